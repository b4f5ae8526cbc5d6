"""Faces, solids and compounds of strips in CadQuery, and blocks that hold the strips."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Self, TypeAlias, TypeVar, Unpack, cast, overload

import cadquery as cq

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
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.strip import Strip

if TYPE_CHECKING:
    from cadquery.occ_impl.geom import VectorLike

    from elastica_cad.kernel.end_travel import Travel
    from elastica_cad.pairs.flexure import Flexure, State


def _read_frame(location: cq.Location) -> Frame:
    plane = cq.Plane(location)
    return Frame(plane.origin.toTuple(), plane.xDir.toTuple(), plane.yDir.toTuple())


def make_location(frame: Frame) -> cq.Location:
    """Convert a frame to a CadQuery location."""
    return cq.Location(occt.make_location(frame))


def _query_name(name: str) -> str:
    # CadQuery's queries permit only letters, digits and "_", and a letter first
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)
    return plain if plain[:1].isalpha() else f"strip_{plain}"


def free_name(name: str, assembly: cq.Assembly) -> str:
    """Return a name for CadQuery's queries that is unique in the assembly."""
    plain = _query_name(name)
    tries = (plain, *(f"{plain}_{number}" for number in range(2, len(assembly.children) + 3)))
    return next(text for text in tries if text not in assembly.objects)


Drawn: TypeAlias = cq.Edge | cq.Wire | cq.Workplane | PlaneCurve | Strip | StripBody | Iterable[cq.Edge]
"""Drawn curve, or a finished strip, which is not computed again."""

# attributes of a shape that its copies and its pickle keep
COPIED_ATTRIBUTES = ("_made", "_joints", "_label", "label", "color")


class _Pickled(cq.Shape):
    color: cq.Color

    def __getstate__(self) -> tuple[Any, ...]:
        attributes = {k: v for k, v in self.__dict__.items() if k in COPIED_ATTRIBUTES}
        if "color" in attributes:
            attributes["color"] = self.color.toTuple()
        return super().__getstate__(), attributes

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        shape, attributes = state
        super().__setstate__(shape)
        self.__dict__.update(attributes)
        if "color" in attributes:
            self.color = cq.Color(*attributes["color"])


class _Layer(_Pickled, cq.Solid):
    """A sheet of a bent strip."""


class _Moved(_Pickled):
    """Shape that gives the data and joints of a strip to its copies.

    `_joints` are relative to the location of the shape.
    """

    _joints: Mapping[str, cq.Location] = MappingProxyType({})

    @overload
    def moved(self, place: "cq.Location | VectorLike", /) -> Self: ...

    @overload
    def moved(
        self, x: float = 0, y: float = 0, z: float = 0, rx: float = 0, ry: float = 0, rz: float = 0
    ) -> Self: ...

    @overload
    def moved(self, *places: Any) -> cq.Shape: ...

    def moved(self, *args: Any, **options: Any) -> Any:
        """Return moved copies, as `Shape.moved` does. A single copy has the data of this shape."""
        return self._with_record(super().moved(*args, **options))

    def mirror(self, mirrorPlane: Any = "XY", basePointVector: "VectorLike" = (0, 0, 0)) -> Self:
        """Return the mirrored strip, as `Shape.mirror` does."""
        return cast("Self", super().mirror(mirrorPlane, basePointVector))

    def located(self, loc: cq.Location) -> Self:
        return self._with_record(super().located(loc))

    def copy(self, mesh: bool = False) -> Self:
        return self._with_record(super().copy(mesh))

    def clean(self) -> Self:
        return self._with_record(super().clean())

    def _apply_transform(self, Tr: Any) -> Any:
        image = self._with_record(super()._apply_transform(Tr))
        if isinstance(image, type(self)) and "_made" in self.__dict__:
            # joints are moved in space, and made relative to the location of the image
            here, back = self.location(), image.location().inverse
            image._joints = {
                name: back * make_location(occt.moved_frame(_read_frame(here * at), Tr))
                for name, at in self._joints.items()
            }
        return image

    def _with_record(self, copy: Self) -> Self:
        if isinstance(copy, type(self)):
            copy.__dict__.update({k: v for k, v in self.__dict__.items() if k in COPIED_ATTRIBUTES})
        return copy


class StripShape(StripBody, _Moved):
    """Base of shapes of a strip. Copies of a shape share the strip."""

    def _start(self) -> Frame | None:
        return _read_frame(self.location() * self._joints["start"]) if "start" in self._joints else None

    @property
    def flat(self) -> "StripSolid | StripCompound":
        """The strip as cut, on the xy plane."""
        return flat_strip(self)

    @property
    def outline(self) -> "StripFace":
        """The flat pattern as a face."""
        return strip_outline(self)

    @lists(BendOptions)
    def bent(self, **moved: Unpack[BendOptions]) -> "StripSolid | StripCompound":
        """Return the bent strip on its curve, or with its ends moved: `rib.bent(end=(120, 0))`."""
        if not moved:
            return bent_strip(self)
        return bent_strip(self._bent_anew(moved), plane=self.frame, color=self.color)

    @overload
    def slider(self, end: Point) -> "Slider": ...

    @overload
    def slider(self, *, angle: float) -> "Slider": ...

    def slider(self, end: Point | None = None, *, angle: float | None = None) -> "Slider":
        """Return the movement of the end of the strip to a point (mm), or its rotation to an angle (degrees).

        A point is in space, or two numbers in the `frame` of the strip. An angle is in this frame.
        """
        return Slider(self, end, angle=angle)

    @property
    def backing(self) -> cq.Solid:
        """The bent backing of a laminated strip."""
        return self._backing_of(self.layers)

    @property
    def engraving(self) -> list[cq.Edge]:
        """Edges of the engraved text: on a flat part or outline where it is, else on the upper face of `flat`."""
        return [edge for wire in self._engraving() for edge in cq.Wire(wire).Edges()]

    @property
    def layers(self) -> tuple[_Layer, ...]:
        """Sheets of the bent strip with labels and colours, the base layer first."""
        solids = []
        for shape, name, color in self._layers():
            solid = _Layer(shape)
            solid.label, solid.color = name, cq.Color(*color)
            solids.append(solid)
        return tuple(solids)

    @property
    def assembly(self) -> cq.Assembly:
        """Sheets of the bent strip as children of an assembly, with names and colours."""
        assembly = cq.Assembly(name=_query_name(self._made.name))
        for solid in self.layers:
            assembly.add(solid, name=free_name(solid.label, assembly), color=solid.color)
        return assembly

    @lists(BlockOptions)
    def fixture(self, end: "StripEnd" = "start", **sizes: Unpack[BlockOptions]) -> "FixtureSolid":
        """Return the block that holds an end of the bent strip, at its position."""
        return end_fixture(self, end=end, **sizes)

    def scale(self, factor: float) -> cq.Shape:
        """Return a scaled plain body, because a strip of another size has other properties."""
        plain = cq.Shape.cast(super().scale(factor).wrapped)
        plain.label = self.label
        return plain

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Raise AttributeError that explains why a filleted or shelled body has no data of a strip.

            CadQuery returns such bodies as objects of the same class.
            """
            if "_made" in self.__dict__ or name.startswith("__"):
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            raise AttributeError(
                f"A body that was rounded, chamfered or hollowed has no {name}. Use {name} of the original strip."
            )

    def _apply_transform(self, Tr: Any) -> Any:
        image = super()._apply_transform(Tr)
        if isinstance(image, type(self)) and "_made" in self.__dict__ and Tr.IsNegative():
            image._made = self._made.mirrored()
        return image


class Slider(SlidingEnd):
    """Path on which the end of a strip moves: straight to another point without turning, or rotating in
    place.

    `write_glb(path, frames=25, seconds=4.0, force=False)` writes an animation of the movement, forward and
    backward.

    Parameters
    ----------
    rib : StripSolid or StripCompound
        A bent strip.
    end : point, or (2,) array_like
        Final position of the end: a point in space, or two numbers in the rib's `frame`, mm.
    angle : float
        Final direction of the end in the rib's `frame`, degrees, instead of `end`. It is accumulated along the
        strip, so it may exceed a full turn. Positions on the path are then in degrees.

    Attributes
    ----------
    travel : Travel
        Shapes on the path, and the length of the path.
    parent : StripSolid or StripCompound
        The bent strip.

    Raises
    ------
    InputError
        The body is not bent, or the strip does not reach the point.

    Examples
    --------
    >>> from elastica_cad.cadquery import elastica
    >>> rib = bent_strip(elastica((0, 0), (160, 0), 200, angles=(0, 0)), "pom-0.5", max_width=10)
    >>> slider = rib.slider(end=(130, 0))
    >>> lamp = cq.Assembly(slider.bent(15), name="rib")
    >>> lamp = lamp.add(cq.Workplane().box(10, 20, 10), name="carriage", loc=slider.place(15))
    >>> round(lamp.objects["carriage"].toCompound().Center().x, 6)
    145.0
    >>> round(slider.bent(15).joints["end"].toTuple()[0][0], 6)
    145.0
    >>> round(rib.slider(angle=30).travel.length, 3)
    30.0
    """

    travel: "Travel"

    def __init__(self, rib: "StripShape", end: Point | None = None, *, angle: float | None = None) -> None:
        from elastica_cad.kernel.end_travel import travel_of

        self.travel = travel_of(rib, end, angle)
        self.parent = rib

    def __repr__(self) -> str:
        return f"<Slider of {self.parent.label!r}, {self.travel.length:.4g} {self.travel.unit}>"

    def place(self, position: float) -> cq.Location:
        """Return the frame of the end at a position on the path, mm or degrees.

        The x axis is along the path, or along the strip if the end rotates. The z axis is across the
        strip.
        """
        self.travel.rod(position)  # a position outside the travel is refused
        turns = self.travel.angle is not None
        moved = cq.Location((0, 0, 0), (0, 0, 1), position) if turns else cq.Location((position, 0, 0))
        return make_location(self.travel.place) * moved

    def bent(self, position: float) -> "StripSolid | StripCompound":
        """Return the strip with its end at a position on the path, mm or degrees."""
        strip = replace(self.parent.strip, rod=self.travel.rod(position))
        return bent_strip(strip, plane=self._frame, color=self.parent.color)

    def constrain(self, assembly: cq.Assembly, name: str, position: float) -> cq.Assembly:
        """Constrain a child of the assembly, or its tagged face ("carriage?foot"), to the end of the strip."""
        at, turn = self.place(position).toTuple()
        child, _, _ = name.partition("?")
        return assembly.constrain(name, "FixedPoint", at).constrain(child, "FixedRotation", turn)


class StripFace(StripShape, cq.Face):
    """Flat pattern of a strip, with properties `strip`, `rod`, `check` and `warnings`."""


class _Jointed(_Moved):
    def __init__(self, obj: Any) -> None:
        super().__init__(obj)
        occt.lock(self.wrapped)

    @property
    def joints(self) -> Mapping[str, cq.Location]:
        """Locations at which other parts are joined.

        The joints of a strip are "start" and "end", at the ends of its free part, and "hole1", "hole1:top",
        "hole1:bottom", ... for its holes. Joints are at half the thickness, or on the face that they name.
        The z axis points away from the strip, and the x axis is along the strip, outward at the ends. The joint of
        a fixture is "tab", at an end of its strip. For the joints of a two-state part see `FlexureSolid`.
        """
        here = self.location()
        # viewers would take a dict named `joints` for joints of build123d
        return MappingProxyType({name: here * place for name, place in self._joints.items()})


class EndedShape(StripShape, _Jointed):
    """Base of solids of a strip, with faces at its ends and in its holes."""

    def end_face(self, end: StripEnd) -> cq.Face:
        """Return the plane face at an end of the strip."""
        if end not in ENDS:
            raise InputError(f'A strip has no end {end!r}. Use "start" or "end".')
        tab = self.strip.ends[0 if end == "start" else 1].length
        # the lap of a closed bent strip is a separate body
        if self.strip.is_closed and self._made.home is not None:
            tab = 0.0
        # middle of the end face, at the outer edge of the tab
        tip = cq.Vector(*(self.joints[end] * cq.Location((tab, 0, 0))).toTuple()[0])
        return min(self.Faces(), key=lambda face: (_middle_of_corners(face) - tip).Length)

    def hole_face(self, hole: str) -> cq.Face:
        """Return a round plane face inside a hole, for constraints: "hole1", "hole1_top" or "hole1_bottom".

        It is at the joint of this name, normal to the z axis of the joint.
        """
        places = self._hole_places
        if hole not in places:
            raise InputError(f"The strip has no hole {hole!r}. Its holes are: {', '.join(places) or 'none'}.")
        (number,) = re.findall(r"\d+", hole)
        left, right = self.strip.holes[int(number) - 1].bounds
        disc = cq.Face.makeFromWires(
            cq.Wire.makeCircle(min(right - left) / 2, cq.Vector(), cq.Vector(0, 0, 1))
        )
        return disc.moved(self.location() * places[hole])

    @property
    def tagged_faces(self) -> dict[str, cq.Face]:
        """Faces by their tags: "start" and "end", and the faces in holes, such as "hole1_top"."""
        ends: dict[str, cq.Face] = {end: self.end_face(end) for end in ENDS}
        return {**ends, **{hole: self.hole_face(hole) for hole in self._hole_places}}

    @property
    def _hole_places(self) -> dict[str, cq.Location]:
        # CadQuery's queries do not permit the colon in the names of joints
        return {_query_name(name): at for name, at in self._joints.items() if name.startswith("hole")}


def _middle_of_corners(face: cq.Face) -> cq.Vector:
    # `Center` takes seconds for a face with hundreds of holes
    corners = [corner.Center() for corner in face.Vertices()]
    return sum(corners, cq.Vector()) / len(corners)


class StripSolid(EndedShape, cq.Solid):
    """Flat or bent strip, with properties `strip`, `rod`, `check` and `warnings`."""


class Sheets(cq.Compound):
    """Compound of sheets that boolean operations take as one argument.

    Boolean operations would split a plain compound into its solids, and intersect the sheets with each other.
    """

    def _bool_op(self, args: Iterable[cq.Shape], *others: Any) -> cq.Shape:
        # `args` is iterated, which would split this compound
        result: cq.Shape = super()._bool_op((self,) if args is self else args, *others)
        return Sheets(result.wrapped) if isinstance(result, cq.Compound) else result

    def fuse(self, *toFuse: cq.Shape, **options: Any) -> cq.Compound:
        """Fuse the sheets with other shapes or, without other shapes, with each other."""
        fuse = cq.Shape.fuse if toFuse else cq.Compound.fuse
        return fuse(self, *toFuse, **options)


class StripCompound(EndedShape, Sheets):
    """The sheets of a laminated strip, flat or bent, with the properties of `StripSolid`."""


class FixtureSolid(StripShape, _Jointed, cq.Solid):
    """Block that holds one end of a strip, with properties `strip`, `rod`, `check` and `warnings` of the strip."""

    _is_strip = False


class FlexureSolid(FlexureBody, _Jointed, cq.Solid):
    """Two-state part as a solid, unloaded as cut or bent into a state, with properties `flexure` and `state`.

    The joints "start" and "end" are on the inner edges of the pads, with x outward, and "hole1" to "hole4" are
    at the holes.
    """

    def in_state(self, state: "State | None") -> "FlexureSolid":
        """Return the part in another state, with its first pad in the same place."""
        part = flexure_solid(self.flexure, state, color=self.color)
        part.label = self.label
        moved: FlexureSolid = part.moved(self.joints["start"] * part.joints["start"].inverse)
        return moved


def flexure_solid(flexure: "Flexure", state: "State | None" = None, *, color: Any = None) -> FlexureSolid:
    """Return the body of a two-state part, either unloaded or in one of its states.

    The unloaded part begins at the origin in direction x. In a state, the part is on the drawn curve.

    Parameters
    ----------
    flexure : Flexure
        The part, as `ec.Flexure` or `FlexureSpec(...).make()`.
    state : "first" or "second", optional
        State of the part. None is the unloaded part, as it is cut.
    color : Color, name or numbers, optional
        Colour on screen, by default that of the sheet.

    Raises
    ------
    InputError
        The state is unknown, or the object is not a Flexure.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> arch = ec.PlaneCurve.spline([(0, 0), (30, 10), (90, 10), (120, 0)], degree=3)
    >>> pair = ec.two_state_rod(arch, arch.transformed([[1, 0, 0], [0, -1, 0], [0, 0, 1]]))
    >>> up = flexure_solid(ec.Flexure(pair, "pom-2"), "first")
    >>> round(up.in_state("second").Volume() / up.Volume(), 4)
    1.0
    """
    made_flexure = MadeFlexure.of(flexure, state, color)
    record = made_flexure.solid
    part = FlexureSolid(occt.make_solid(record))
    part._made = made_flexure
    part._joints = {name: make_location(frame) for name, frame in record.joints.items()}
    part.label, part.color = made_flexure.name, cq.Color(*made_flexure.color)
    return part


S = TypeVar("S", bound=StripShape)


@lists(StripOptions, drawn=True)
def strip_outline(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripFace:
    """Return the flat pattern of the strip that bends into a curve, on the xy plane.

    The x axis is along the strip from the start of its free part, and y = 0 is the centre line.

    Raises
    ------
    NotRealizable
        No strip bends into the curve, and the options `limits` and `keep` do not permit a change of the curve.
    InputError
        The path is not an open, plane, smooth curve, or a value is out of range.

    Examples
    --------
    >>> arch = cq.Edge.makeSpline([cq.Vector(0, 0), cq.Vector(60, 50), cq.Vector(120, 0)])
    >>> strip_outline(arch, "card-200gsm", max_width=20).geomType()
    'PLANE'
    """
    made_strip = _make_strip_of(path, sheet, max_width=max_width, **options)
    return dress(StripFace(made_strip.face), {}, made_strip)


@lists(StripOptions, drawn=True)
def flat_strip(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripSolid | StripCompound:
    """Return the strip as cut, from z = 0 upward. Errors and axes are those of `strip_outline`."""
    return _make_body(_make_strip_of(path, sheet, max_width=max_width, **options), bent=False)


@lists(StripOptions, drawn=True)
def bent_strip(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripSolid | StripCompound:
    """Return the bent strip, with half its thickness on either side of the drawn curve.

    Errors are as for `strip_outline`.
    """
    return _make_body(_make_strip_of(path, sheet, max_width=max_width, **options), bent=True)


@lists(BlockOptions, StripOptions, drawn=True)
def end_fixture(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    end: StripEnd = "start",
    floor: cq.Plane | None = None,
    **options: Unpack[FixtureOptions],
) -> FixtureSolid:
    """Return the block that holds an end of the bent strip, positioned for `bent_strip` of the same path.

    Parameters
    ----------
    end : "start" or "end"

    Raises
    ------
    InputError
        The end has no tab, sizes do not fit, or the floor is not perpendicular to the plane of the curve.
        Errors of `strip_outline` are passed on.
    """
    edges, drawn_on = _shapes_and_plane(path)
    made_strip, block = make_fixture_on(
        edges, sheet, max_width=max_width, end=end, floor=floor, **drawn_on, **options
    )
    fixture = dress(FixtureSolid(occt.make_solid(block.solid)), block.solid.joints, made_strip)
    fixture.label = block.label
    return fixture


def _shapes_and_plane(path: Drawn) -> tuple[Any, dict[str, Any]]:
    # return the drawn shapes and, for a Workplane, its plane as the option `workplane`
    if not isinstance(path, cq.Workplane):
        return path, {}
    return [*path.ctx.pendingEdges, *path.ctx.pendingWires] or path.vals(), {"workplane": path.plane}


def _make_strip_of(path: Drawn, sheet: Sheet | str | None, **options: Any) -> MadeStrip:
    """Make the strip of drawn shapes. The plane of a Workplane is used as the plane of the curve."""
    edges, drawn_on = _shapes_and_plane(path)
    return make_strip_on(edges, sheet, **(drawn_on | options))


def _make_body(made_strip: MadeStrip, *, bent: bool) -> StripSolid | StripCompound:
    """Return the body of a strip, with the property `strip`. Several sheets form a compound."""
    records, made_strip = made_strip.body(bent=bent)
    solids = occt.make_sheets(records)
    shape: StripSolid | StripCompound
    if len(solids) == 1:
        shape = StripSolid(solids[0])
    else:
        shape = StripCompound(cq.Compound.makeCompound(map(cq.Solid, solids)).wrapped)
    return dress(shape, records[0].joints, made_strip)


def dress(shape: S, joints: Mapping[str, Frame], made_strip: MadeStrip) -> S:
    """Set the strip, joints, name and colour of a shape, and return the shape."""
    shape._made = made_strip
    shape._joints = {name: make_location(frame) for name, frame in joints.items()}
    shape.label = made_strip.name
    shape.color = cq.Color(*made_strip.body_color)
    return shape
