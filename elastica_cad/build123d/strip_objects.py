"""Objects of build123d: strips (flat, bent, placed), joints that move their ends, and blocks that hold strips."""

from collections.abc import Iterable, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from itertools import chain, count
from typing import TYPE_CHECKING, Any, Self, TypeAlias, Unpack, overload

import build123d as bd

from elastica_cad._values import require_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.kernel import occt
from elastica_cad.kernel.flexure_body import FlexureBody, MadeFlexure
from elastica_cad.kernel.option_help import lists
from elastica_cad.kernel.strip_body import BendOptions, MadeStrip, Point, SlidingEnd, StripBody
from elastica_cad.kernel.strip_on_path import (
    BlockOptions,
    FixtureOptions,
    make_fixture_on,
    make_strip_on,
)
from elastica_cad.kernel.strip_options import StripOptions
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.outline import StripEnd
from elastica_cad.strip.solids import BodyRecord, PrismSolid
from elastica_cad.strip.strip import Strip

if TYPE_CHECKING:
    from elastica_cad.kernel.end_travel import Travel
    from elastica_cad.pairs.flexure import Flexure, State


def make_solids(records: Sequence[BodyRecord | PrismSolid]) -> list[bd.Solid]:
    """Return the solids of a body: one for each sheet of a strip, or a single block."""
    return [bd.Solid(solid) for solid in occt.make_sheets(records)]


def add_joints(shape: Any, record: BodyRecord | PrismSolid) -> None:
    """Add the joints of a record to a shape, as rigid joints with the same names."""
    for name, frame in record.joints.items():
        bd.RigidJoint(name, shape, bd.Location(occt.make_location(frame)))


def _read_frame(location: bd.Location) -> Frame:
    plane = bd.Plane(location)
    return Frame(tuple(plane.origin), tuple(plane.x_dir), tuple(plane.y_dir))


def _joint_of_copy(name: str, number: int) -> str:
    # return the name of a joint on copy `number` of a body, counted from 1
    return name if number == 1 else f"{name}:{number}"


Drawn: TypeAlias = bd.Edge | bd.Wire | PlaneCurve | Strip | StripBody | Iterable[bd.Edge]
"""Drawn curve, or a finished strip, which is not computed again."""


Align3: TypeAlias = bd.Align | tuple[bd.Align, bd.Align, bd.Align]
"""Alignment of a part in all directions, or in each direction."""

# private attribute of build123d's shapes for their colour
COLOR = "_color"


# base of shapes that can be pickled with their colour
class _Pickled:
    def __getstate__(self) -> dict[str, Any]:
        """Return the state with colours as numbers, because the kernel's colours cannot be pickled."""
        color = self.__dict__.get(COLOR)
        return self.__dict__ | {COLOR: None if color is None else tuple(color)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        color = state[COLOR]
        self.__dict__.update(state | {COLOR: None if color is None else bd.Color(*color)})


class Layer(_Pickled, bd.Solid):
    """A sheet of a bent strip."""


# base of shapes that keep their joints when they are moved
class _Jointed(_Pickled):
    def _apply_transform(self: Any, transformation: Any) -> Any:
        """Return the transformed object with its joints, which build123d would otherwise leave behind."""
        image = bd.Shape._apply_transform(self, transformation)
        occt.lock(image.wrapped)
        image.joints = {}
        for name, joint in getattr(self, "joints", {}).items():
            if isinstance(joint, bd.RigidJoint):
                place = occt.moved_frame(_read_frame(joint.location), transformation)
                bd.RigidJoint(name, image, bd.Location(occt.make_location(place)))
        return image


class StripShape(_Jointed, StripBody):
    """Base of shapes of a strip. Copies of a shape share the strip."""

    def _start(self) -> Frame | None:
        if self._parts:
            raise InputError(
                f"This body has {len(self._parts)} copies of a strip. Use a single copy, such as "
                "body.copies[0]."
            )
        joints: dict[str, bd.Joint] = getattr(self, "joints", {})
        return _read_frame(joints["start"].location) if "start" in joints else None

    @property
    def _parts(self: Any) -> list[bd.Compound]:
        """Parts at several `Locations`; empty for a single location."""
        return [part for part in self if isinstance(part, bd.Compound)]

    @property
    def copies(self) -> "bd.ShapeList[Self]":
        """Bodies at several `Locations`, each with its own joints.

        A single location gives the body itself.
        """
        body: Any = self
        parts = self._parts
        shapes = bd.ShapeList([] if parts else [self])
        names = [name for name in body.joints if _joint_of_copy(name, 2) in body.joints]
        for number, part in enumerate(parts, start=1):
            other_body = copy(body)
            other_body.wrapped, other_body.joints = part.wrapped, {}
            for name in names:
                bd.RigidJoint(name, other_body, body.joints[_joint_of_copy(name, number)].location)
            shapes.append(other_body)
        return shapes

    def _publish_to_context(self: Any, object_scope: Any) -> None:
        """Publish the body to its builder.

        At several `Locations`, the names of joints contain the number of the copy, from the second copy on.
        """
        bd.BaseObject._publish_to_context(self, object_scope)
        occt.lock(self.wrapped)
        parts = self._parts
        if not parts:
            return
        places = {name: joint.relative_location for name, joint in self.joints.items()}
        self.joints = dict[str, bd.Joint]()
        for number, part in enumerate(parts, start=1):
            for name, place in places.items():
                bd.RigidJoint(_joint_of_copy(name, number), self, part.location * place)

    @property
    def flat(self) -> "FlatStrip":
        """The strip as cut, on the xy plane."""
        return FlatStrip(self, mode=bd.Mode.PRIVATE)

    @lists(BendOptions)
    def bent(self, **moved: Unpack[BendOptions]) -> "BentStrip":
        """Return the bent strip on its curve, or with its ends moved: `rib.bent(end=(120, 0))`."""
        if not moved:
            return BentStrip(self, mode=bd.Mode.PRIVATE)
        return BentStrip(self._bent_anew(moved), plane=self.frame, color=self.color, mode=bd.Mode.PRIVATE)

    @overload
    def slider(self, end: Point) -> "Slider": ...

    @overload
    def slider(self, *, angle: float) -> "AngleSlider": ...

    def slider(self, end: Point | None = None, *, angle: float | None = None) -> "Slider | AngleSlider":
        """Return a joint that moves the end of the strip to a point (mm), or rotates it to an angle (degrees).

        A point is in space, or two numbers in the `frame` of the body. An angle is in this frame.
        """
        return Slider(self, end) if angle is None else AngleSlider(self, angle, end)

    @property
    def outline(self) -> "StripOutline":
        """The flat pattern as a sketch."""
        return StripOutline(self, mode=bd.Mode.PRIVATE)

    @property
    def engraving(self) -> bd.ShapeList[bd.Edge]:
        """Edges of the engraved text: on a flat part or outline where it is, else on the upper face of `flat`."""
        wires = [bd.Wire(wire) for body in self.copies for wire in body._engraving()]
        return bd.ShapeList(edge for wire in wires for edge in wire.edges())

    @property
    def layers(self) -> tuple[bd.Solid, ...]:
        """Sheets of the bent strip with names and colours, the base layer first."""
        solids = []
        for shape, name, color in self._layers():
            solid = Layer(shape)
            solid.label, solid.color = name, bd.Color(*color)
            solids.append(solid)
        return tuple(solids)

    def _named_parts(self) -> list[bd.Shape]:
        return [part for body in self.copies for part in StripBody._named_parts(body)]

    @property
    def assembly(self) -> bd.Compound:
        """Sheets of the bent strip as children of a compound, with names and colours."""
        return bd.Compound(label=self._made.name, children=list(self.layers))

    @property
    def backing(self) -> bd.Solid:
        """The bent backing of a laminated strip."""
        return self._backing_of(self.layers)

    @lists(BlockOptions)
    def fixture(self, end: StripEnd = "start", **sizes: Unpack[BlockOptions]) -> "EndFixture":
        """Return the block that holds an end of the bent strip, at its position."""
        return EndFixture(self, end=end, mode=bd.Mode.PRIVATE, **sizes)

    def _apply_transform(self, transformation: Any) -> Any:
        image = super()._apply_transform(transformation)
        if transformation.IsNegative():
            image._made = self._made.mirrored()
        return image

    def scale(self: Any, *args: Any, **options: Any) -> bd.Part | bd.Sketch:
        """Return a scaled plain body, because a strip of another size has other properties."""
        return self._plain(bd.Shape.scale(self, *args, **options))

    def transform_geometry(self: Any, t_matrix: bd.Matrix) -> bd.Part | bd.Sketch:
        """Return a transformed plain body, because a stretched body is not a strip."""
        return self._plain(bd.Shape.transform_geometry(self, t_matrix))

    def _plain(self: Any, changed: bd.Shape) -> bd.Part | bd.Sketch:
        plain = bd.Sketch(changed.wrapped) if isinstance(self, bd.Sketch) else bd.Part(changed.wrapped)
        plain.label, plain.color = self.label, self.color
        return plain


class TravelJoint(SlidingEnd):
    """Base of joints that move the end of a strip. A further joint of a body has a number in its name."""

    travel: "Travel"
    label: str

    def __repr__(self) -> str:
        path = f"{self.travel.length:.4g} {self.travel.unit}"
        return f"<{type(self).__name__} {self.label!r} of {self.parent.label!r}, {path}>"

    def __getstate__(self) -> dict[str, Any]:
        """Return the state with calls that make axes and vectors, because these cannot be pickled."""
        state = dict(self.__dict__)
        for name, value in self.__dict__.items():
            if isinstance(value, bd.Axis):
                state[name] = partial(bd.Axis, tuple(value.position), tuple(value.direction))
            elif isinstance(value, bd.Vector):
                state[name] = partial(bd.Vector, *value)
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        geometry = {name: value() for name, value in state.items() if isinstance(value, partial)}
        self.__dict__.update(state | geometry)

    def bent(self, position: float) -> "BentStrip":
        """Return the strip with its end at a position on the path, mm or degrees."""
        strip = replace(self.parent.strip, rod=self.travel.rod(position))
        return BentStrip(strip, plane=self._frame, color=self.parent.color, mode=bd.Mode.PRIVATE)


def _free_name(rib: Any) -> str:
    # "slider", with the first free number if the body has such a joint
    names = chain(["slider"], map("slider{}".format, count(2)))
    return next(name for name in names if name not in rib.joints)


class Slider(TravelJoint, bd.LinearJoint):
    """Linear joint "slider": the end of a strip moves straight to another point without turning.

    `connect_to(joint, position=...)` moves the part that is attached to the end. `bent(position)` returns the
    strip for this position. `write_glb(path)` writes an animation of the movement.

    Parameters
    ----------
    rib : BentStrip or PlacedStrip
        Body with the joint.
    end : point, or (2,) array_like
        Final position of the end: a point in space, or two numbers in the rib's `frame`, mm.

    Attributes
    ----------
    travel : Travel
        Shapes on the path, and the length of the path.

    Raises
    ------
    InputError
        The body is not bent, or the strip does not reach the point.

    Examples
    --------
    >>> from elastica_cad.build123d import Elastica
    >>> rib = BentStrip(Elastica((0, 0), (160, 0), 200, angles=(0, 0)).edge(), "pom-0.5", max_width=10)
    >>> slider = rib.slider(end=(130, 0))
    >>> carriage = bd.Box(10, 20, 10)
    >>> slider.connect_to(bd.RigidJoint("foot", carriage), position=15)
    >>> round(carriage.center().X, 6), round(slider.bent(15).joints["end"].location.position.X, 6)
    (145.0, 145.0)
    """

    def __init__(self, rib: "StripShape", end: Point | None) -> None:
        from elastica_cad.kernel.end_travel import travel_of

        self.travel = travel_of(rib, end, None)
        place = bd.Location(occt.make_location(self.travel.place))
        axis = bd.Axis(place.position, bd.Plane(place).x_dir)
        super().__init__(_free_name(rib), rib, axis, (0.0, self.travel.length))


class AngleSlider(TravelJoint, bd.RevoluteJoint):
    """Revolute joint "slider": the end of a strip rotates in place.

    `connect_to(joint, angle=...)` rotates the part that is attached to the end; its x axis is along the
    strip. `bent(angle)` returns the strip for this angle. Angles are in degrees from the initial direction of
    the end.

    Parameters
    ----------
    rib : BentStrip or PlacedStrip
        Body with the joint.
    angle : float
        Final direction of the end in the `frame` of the rib, degrees. It is accumulated along the strip, so
        it may exceed a full turn.

    Attributes
    ----------
    travel : Travel
        Shapes on the path, and the angle of rotation.

    Raises
    ------
    InputError
        The body is not bent, or its end has this direction already.

    Examples
    --------
    >>> from elastica_cad.build123d import Elastica
    >>> rib = BentStrip(Elastica((0, 0), (160, 0), 200, angles=(0, 0)).edge(), "pom-0.5", max_width=10)
    >>> slider = rib.slider(angle=30)
    >>> slider.connect_to(bd.RigidJoint("hub", bd.Box(10, 20, 10)), angle=20)
    >>> round(float(slider.bent(20).rod.angle[-1] - rib.rod.angle[-1]), 6)
    0.349066
    """

    def __init__(self, rib: "StripShape", angle: float, end: Point | None = None) -> None:
        from elastica_cad.kernel.end_travel import travel_of

        self.travel = travel_of(rib, end, angle)
        place = bd.Location(occt.make_location(self.travel.place))
        body: Any = rib
        self._home = body.location.inverse() * place  # frame of the end, relative to the body
        axis = bd.Axis(place.position, bd.Plane(place).z_dir)
        super().__init__(_free_name(rib), rib, axis, angular_range=(0.0, self.travel.length))

    def relative_to(self, other: bd.RigidJoint, *, angle: float | None = None) -> bd.Location:
        """Return the location, relative to the strip, of the part whose joint `other` is attached to the end.

        The end is rotated by `angle`, degrees. The method of the base class does not define the direction of
        angle 0.
        """
        require_record(other, bd.RigidJoint, "the other joint", "a RigidJoint")
        if angle is not None and not 0 <= require_number(angle, "the angle", "degrees") <= self.travel.length:
            raise InputError(
                f"the angle of the end is {angle:g} degrees, outside its travel. Use 0 to "
                f"{self.travel.length:g} degrees."
            )
        super().relative_to(other, angle=angle)
        return self._home * bd.Rotation(0, 0, self._angle) * other.relative_location.inverse()


@lists(StripOptions, drawn=True)
class StripOutline(StripShape, bd.BaseSketchObject):
    """Sketch object: the flat pattern of the strip that bends into a curve.

    The x axis is along the strip from the start of its free part, and y = 0 is the centre line.

    Parameters
    ----------
    rotation : float
        Rotation about the z axis, degrees.
    align, mode
        As in every sketch object of build123d.

    Raises
    ------
    NotRealizable
        No strip bends into the curve, and neither limits nor keep permit a change of the curve.
    InputError
        The path is not an open, plane, smooth curve, or a value is out of range.

    Examples
    --------
    >>> arch = bd.Edge.make_spline([(0, 0), (60, 50), (120, 0)])
    >>> outline = StripOutline(arch, "card-200gsm", max_width=20)
    >>> len(outline.edges()), outline.label
    (8, 'strip')
    """

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str | None = None,
        *,
        max_width: float | None = None,
        rotation: float = 0,
        align: bd.Align | tuple[bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Unpack[StripOptions],
    ) -> None:
        degrees = require_number(rotation, "rotation", "degrees")
        made_strip = make_strip_on(path, sheet, max_width=max_width, **options)
        super().__init__(bd.Face(made_strip.face), degrees, align, mode)
        _set_strip(self, made_strip)


class StripPart(StripShape, bd.BasePartObject):
    """Base of part objects of a strip."""

    _is_bent = False

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str | None = None,
        *,
        max_width: float | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: Align3 | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Unpack[StripOptions],
    ) -> None:
        made_strip = make_strip_on(path, sheet, max_width=max_width, **options)
        records, made_strip = made_strip.body(bent=self._is_bent)
        solids = make_solids(records)
        body = solids[0] if len(solids) == 1 else bd.Part(bd.Compound(solids).wrapped)
        add_joints(body, records[0])
        super().__init__(body, rotation, align, mode)
        _set_strip(self, made_strip)


@lists(StripOptions, drawn=True)
class FlatStrip(StripPart):
    """Part object: the strip as cut, on the xy plane.

    Rigid joints "start", "end", "hole1", "hole2", ... are at half the thickness, with z away from the sheet and x
    outward along the strip. Errors and frame are as for `StripOutline`.

    Parameters
    ----------
    rotation : (float, float, float)
        Rotation about the axes, degrees.
    align, mode
        As in every part object of build123d.
    """


@lists(StripOptions, drawn=True)
class BentStrip(StripPart):
    """Part object: the bent strip, with half its thickness on either side of the drawn curve.

    Inside a builder the path is in the coordinates of its workplane. Joints are as on `FlatStrip`, and errors are
    as for `StripOutline`.

    Parameters
    ----------
    rotation : (float, float, float)
        Rotation about the axes, degrees.
    align, mode
        As in every part object of build123d.
    """

    _is_bent = True


@lists(BlockOptions, StripOptions, drawn=True)
class EndFixture(StripShape, bd.BasePartObject):
    """Part object: the block that holds an end of the bent strip, positioned for the `BentStrip` of the same path.

    Its rigid joint "tab" is at the end of the free part, with x out of the strip. Connect "tab" to the strip's
    joint of the same end.

    Parameters
    ----------
    end : "start" or "end"
    rotation : (float, float, float)
        Rotation about the axes, degrees.
    align, mode
        As in every part object of build123d.

    Raises
    ------
    InputError
        The end has no tab, sizes do not fit, or the floor is not perpendicular to the plane of the curve.
        Errors of `StripOutline` are passed on.
    """

    _is_strip = False

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str | None = None,
        *,
        max_width: float | None = None,
        end: StripEnd = "start",
        floor: bd.Plane | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: Align3 | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Unpack[FixtureOptions],
    ) -> None:
        made_strip, block = make_fixture_on(path, sheet, max_width=max_width, end=end, floor=floor, **options)
        solid = bd.Solid(occt.make_solid(block.solid))
        add_joints(solid, block.solid)
        super().__init__(solid, rotation, align, mode)
        _set_strip(self, made_strip)
        self.label = block.label


@lists()
class FlexurePart(_Jointed, FlexureBody, bd.BasePartObject):
    """Part object: a two-state part, either unloaded or in one of its states.

    The unloaded part begins at the origin in direction x. In a state, the part is on the drawn curve. Rigid
    joints "start" and "end" are on the inner edges of the pads, with x outward. "hole1" to "hole4" are at the
    holes, from start to end.

    Parameters
    ----------
    flexure : Flexure
        The part, as `ec.Flexure` or `FlexureSpec(...).make()`.
    state : "first" or "second", optional
        State of the part. None is the unloaded part, as it is cut.
    color : Color, name or numbers, optional
        Colour on screen, by default that of the sheet.
    rotation : (float, float, float)
        Rotation about the axes, degrees.
    align, mode
        As in every part object of build123d.

    Raises
    ------
    InputError
        The state is unknown, or the object is not a Flexure.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> arch = ec.PlaneCurve.spline([(0, 0), (30, 10), (90, 10), (120, 0)], degree=3)
    >>> pair = ec.two_state_rod(arch, arch.transformed([[1, 0, 0], [0, -1, 0], [0, 0, 1]]))
    >>> up = FlexurePart(ec.Flexure(pair, "pom-2"), "first")
    >>> round(up.in_state("second").volume / up.volume, 4)
    1.0
    """

    def __init__(
        self,
        flexure: "Flexure",
        state: "State | None" = None,
        *,
        color: Any = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: Align3 | None = None,
        mode: bd.Mode = bd.Mode.ADD,
    ) -> None:
        self._made = made_flexure = MadeFlexure.of(flexure, state, color)
        record = made_flexure.solid
        solid = bd.Solid(occt.make_solid(record))
        add_joints(solid, record)
        super().__init__(solid, rotation, align, mode)
        occt.lock(self.wrapped)
        self.label, self.color = made_flexure.name, bd.Color(*made_flexure.color)

    def in_state(self, state: "State | None") -> "FlexurePart":
        """Return the part in another state, with its first pad in the same place."""
        part = FlexurePart(self.flexure, state, color=self.color, mode=bd.Mode.PRIVATE)
        part.label = self.label
        part.locate(self.joints["start"].location * part.joints["start"].relative_location.inverse())
        return part


class PlacedStrip(StripShape, bd.Part):
    """Bent strip in its position in a model, with properties `strip`, `rod`, `check` and `warnings`."""


def _set_strip(shape: Any, made_strip: MadeStrip) -> None:
    occt.lock(shape.wrapped)
    shape._made = made_strip
    shape.label = made_strip.name
    shape.color = bd.Color(*made_strip.body_color)
