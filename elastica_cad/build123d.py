"""Strips in build123d: sketch and part objects, and an operation on pending edges."""

from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from dataclasses import replace
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, Unpack, overload

from elastica_cad.errors import InputError, how_to_install

try:
    import build123d as bd
except ImportError as error:
    raise ImportError(f"elastica_cad.build123d needs build123d: {how_to_install('build123d')}") from error

from elastica_cad.fabrication.drawings.sheet_colors import FIXTURE_COLOR, sheet_color
from elastica_cad.fabrication.solids.prisms import PrismSolid
from elastica_cad.fabrication.solids.strip_solids import BentSolid, BodyRecord, FlatSolid
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_body import BendOptions, MadeStrip, Point, StripBody
from elastica_cad.kernel.strip_on_path import (
    BlockOptions,
    End,
    FixtureOptions,
    StripOptions,
    make_fixture_on,
    make_strip_on,
    section_requests,
)
from elastica_cad.kernel.strip_warnings import StripWarning, warn_of_missing_slots
from elastica_cad.mechanics.bending.between_clamps import angles_in_rad, elastica_between
from elastica_cad.mechanics.loads.arguments import whole_number
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.material.sheet import Sheet

if TYPE_CHECKING:
    from elastica_cad.fabrication.model.assembly import AssemblyPart, Holder
    from elastica_cad.fabrication.model.strip_model import Model
    from elastica_cad.forming.plane_sections.section_spec import SectionSpec

__all__ = [
    "BentStrip",
    "Elastica",
    "EndFixture",
    "FlatStrip",
    "PlacedStrip",
    "Slider",
    "StripOutline",
    "StripWarning",
    "elastic_strip",
    "model_compound",
    "section_strips",
]

Drawn: TypeAlias = bd.Edge | bd.Wire | PlaneCurve | Strip | StripBody | Iterable[bd.Edge]
"""A curve that is drawn, or a strip that was made before: then there is nothing to solve."""


COLOR = "_color"  # where shapes of build123d keep theirs


class _Made(StripBody):
    """The strip behind a shape; copies of the shape share it. Its properties make the other bodies."""

    def _start(self) -> Frame | None:
        joints: dict[str, bd.Joint] = getattr(self, "joints", {})
        return _frame(joints["start"].location) if "start" in joints else None

    @property
    def flat(self) -> "FlatStrip":
        """The strip as cut, on the xy plane."""
        return FlatStrip(self, mode=bd.Mode.PRIVATE)

    @property
    def bent(self) -> "_Bent":
        """The strip bent, on its curve; called with new ends it is bent further: `rib.bent(end=(120, 0))`."""
        return _Bent(self)

    def slider(self, end: Point) -> "Slider":
        """A joint of this body: the travel of its end to a point in space, or two numbers in its `frame`, mm."""
        return Slider(self, end)

    @property
    def outline(self) -> "StripOutline":
        """The flat pattern as a sketch."""
        return StripOutline(self, mode=bd.Mode.PRIVATE)

    @property
    def layers(self) -> tuple[bd.Solid, ...]:
        """The sheets of the bent strip, the base first, with names and colours."""
        found = []
        for shape, name, sheet in self._layers():
            solid = bd.Solid(shape)
            solid.label, solid.color = name, bd.Color(*sheet_color(sheet))
            found.append(solid)
        return tuple(found)

    @property
    def assembly(self) -> bd.Compound:
        """The sheets of the bent strip as children of one compound, with names and colours."""
        return bd.Compound(label=self.strip.label or "strip", children=list(self.layers))

    @property
    def backing(self) -> bd.Solid:
        """The bent backing of a laminated strip."""
        self._require_backing()
        return self.layers[1]

    def fixture(self, end: End = "start", **sizes: Unpack[BlockOptions]) -> "EndFixture":
        """The block that holds an end of the bent strip, in place; `sizes` as in `EndFixture`."""
        return EndFixture(self, end=end, mode=bd.Mode.PRIVATE, **sizes)

    def _apply_transform(self, transformation: Any) -> Any:
        """A shape mirrored, or made anew where it goes: joints are made there too, strips of images turned over."""
        body: Any = self
        image = bd.Shape._apply_transform(body, transformation)
        if transformation.IsNegative():
            image._made = self._made.mirrored()
        image.joints = {}
        for name, joint in getattr(self, "joints", {}).items():
            if isinstance(joint, bd.RigidJoint):
                place = occt.moved_frame(_frame(joint.location), transformation)
                bd.RigidJoint(name, image, bd.Location(occt.make_location(place)))
        return image

    def scale(self, *args: Any, **options: Any) -> bd.Part | bd.Sketch:
        """As `Shape.scale`: a plain body, as a strip of another size has other numbers."""
        body: Any = self
        return self._plain(bd.Shape.scale(body, *args, **options))

    def transform_geometry(self, t_matrix: bd.Matrix) -> bd.Part | bd.Sketch:
        """As `Shape.transform_geometry`: a plain body, as what is stretched is no strip."""
        body: Any = self
        return self._plain(bd.Shape.transform_geometry(body, t_matrix))

    def _plain(self, changed: bd.Shape) -> bd.Part | bd.Sketch:
        body: Any = self
        plain = bd.Sketch(changed.wrapped) if isinstance(self, bd.Sketch) else bd.Part(changed.wrapped)
        plain.label, plain.color = body.label, body.color
        return plain

    def __getstate__(self) -> dict[str, Any]:
        """What `pickle` takes along; the kernel's colours cannot be pickled, so their numbers are."""
        color = self.__dict__.get(COLOR)
        return self.__dict__ | {COLOR: None if color is None else tuple(color)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        color = state[COLOR]
        self.__dict__.update(state | {COLOR: None if color is None else bd.Color(*color)})


class _Bent:
    """Makes the bent body of a strip, as it is or with its ends led elsewhere."""

    def __init__(self, owner: _Made) -> None:
        self._owner = owner

    def __call__(self, **moved: Unpack[BendOptions]) -> "BentStrip":
        """The body with its ends led to `start` and `end`: points in space, or two numbers in the `frame` of the
        body, mm; `angles` (rad in that frame) and all others as in `mechanics.bend`.
        """
        owner = self._owner
        if not moved:
            return BentStrip(owner, mode=bd.Mode.PRIVATE)
        return BentStrip(owner._bent_anew(moved), plane=owner.frame, mode=bd.Mode.PRIVATE)


class Slider(bd.LinearJoint):
    """Linear joint "slider": a strip's end on its way, straight and with its direction held, to another point.

    `connect_to(joint, position=...)` moves what rides on the end; `bent(position)` is the strip then.

    Parameters
    ----------
    rib : BentStrip or PlacedStrip
        Gets the joint.
    end : point, or (2,) array_like
        Where the end goes: a point in space, or two numbers in the rib's `frame`, mm.

    Attributes
    ----------
    travel : Travel
        The shapes on the way, and how long it is.

    Raises
    ------
    InputError
        A body that is not bent, a point that the strip does not reach.

    Examples
    --------
    >>> rib = BentStrip(Elastica((0, 0), (160, 0), 200, angles=(0, 0)).edge(), "pom-0.5", max_width=10)
    >>> slider = rib.slider(end=(130, 0))
    >>> carriage = bd.Box(10, 20, 10)
    >>> slider.connect_to(bd.RigidJoint("foot", carriage), position=15)
    >>> round(carriage.center().X, 6), round(slider.bent(15).joints["end"].location.position.X, 6)
    (145.0, 145.0)
    """

    def __init__(self, rib: "_Made", end: Point) -> None:
        if rib._made.home is None:
            raise InputError("the end of a strip slides when it is bent: take its body .bent() first")
        from elastica_cad.kernel.end_travel import Travel

        self.travel = Travel(rib.strip, rib.frame, rib._in_plane(end, "end"))
        place = bd.Location(occt.make_location(self.travel.place))
        super().__init__(
            "slider", rib, bd.Axis(place.position, bd.Plane(place).x_dir), (0.0, self.travel.length)
        )

    def bent(self, position: float) -> "BentStrip":
        """The strip with its end `position` mm along the way."""
        travel = self.travel
        strip = replace(travel.strip, rod=travel.rod(position))
        return BentStrip(strip, plane=self._frame, mode=bd.Mode.PRIVATE)

    def write_glb(
        self, path: str | PathLike[str], *, frames: int = 25, seconds: float = 4.0, force: bool = False
    ) -> None:
        """Write the way there and back as an animation; a file that is there only with `force`."""
        moved = replace(self.travel, frame=self._frame)
        moved.write_glb(path, frames=frames, seconds=seconds, force=force)

    @property
    def _frame(self) -> Frame:
        """The plane of the strip where its body lies now: it may have been joined to others since."""
        rib: Any = self.parent
        return rib.frame if isinstance(rib, _Made) else self.travel.frame


class StripOutline(_Made, bd.BaseSketchObject):
    """Sketch object: the flat pattern of the strip that bends into a curve.

    The x axis runs along the strip from the start of its free part, y = 0 is the centre line.

    Parameters
    ----------
    path : Edge, Wire, edges that follow each other, or PlaneCurve
        The curve that the strip is to take.
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        The largest width of the free part, mm; or give `min_width`, the least.
    rotation, align, mode
        As in every sketch object of build123d.
    **options
        All other fields of `StripSpec`: min_width, style, limits, keep, gravity, loads, supports,
        natural_curvature, samples, ends, slots, label; and of a `PlaneCurve` its `frame` in space.

    Raises
    ------
    NotRealizable
        No strip takes the curve and neither limits nor keep allow it to change.
    InputError
        A path that is not one open, plane, smooth curve; numbers that make no strip.

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
        made = make_strip_on(path, sheet, max_width=max_width, **options)
        super().__init__(bd.Face(made.face), rotation, align, mode)
        _dress(self, made)


class _StripPart(_Made, bd.BasePartObject):
    """A strip as a part."""

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str | None = None,
        *,
        max_width: float | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: bd.Align | tuple[bd.Align, bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Unpack[StripOptions],
    ) -> None:
        made = make_strip_on(path, sheet, max_width=max_width, **options)
        records = self._records(made)
        super().__init__(_jointed(records), rotation, align, mode)
        stands = isinstance(records[0], BentSolid)
        _dress(self, replace(made, home=records[0].joints["start"]) if stands else made)

    def _records(self, made: MadeStrip) -> Sequence[BodyRecord]:
        raise NotImplementedError


class FlatStrip(_StripPart):
    """Part object: the strip as cut, lying on the xy plane.

    Rigid joints "start", "end", "hole1", "hole2", ... lie half way through the thickness: z off the sheet, x
    outward along the strip. Parameters, errors and frame as in `StripOutline`.
    """

    def _records(self, made: MadeStrip) -> Sequence[BodyRecord]:
        return FlatSolid.layers(made.strip)


class BentStrip(_StripPart):
    """Part object: the strip bent, standing on the drawn curve with half its thickness to either side.

    Inside a builder the path is in the coordinates of its workplane, as all that is drawn there. Joints as on
    `FlatStrip`, parameters and errors as in `StripOutline`.
    """

    def _records(self, made: MadeStrip) -> Sequence[BodyRecord]:
        return BentSolid.layers(made.strip, made.frame)


class EndFixture(_Made, bd.BasePartObject):
    """Part object: the block that holds one end of the bent strip, in place beside `BentStrip` of the same path.

    Its rigid joint "tab" lies where the free part ends, x out of the strip; connect it to the joint of that end.

    Parameters
    ----------
    path, sheet, max_width
        As in `StripOutline`.
    end : "start" or "end"
    floor : Plane, optional
        What the block stands on; without it on a plane square to the tab.
    clearance, wall, foot, foot_height, screw, number
        As in `fabrication.EndFixture`, mm.
    rotation, align, mode, **options
        As in `BentStrip`.

    Raises
    ------
    InputError
        No tab at that end, sizes that do not fit, a floor not square to the curve's plane; and as `StripOutline`.
    """

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str | None = None,
        *,
        max_width: float | None = None,
        end: End = "start",
        floor: bd.Plane | None = None,
        number: str | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: bd.Align | tuple[bd.Align, bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Unpack[FixtureOptions],
    ) -> None:
        made, block = make_fixture_on(
            path, sheet, max_width=max_width, end=end, floor=floor, number=number, **options
        )
        solid = bd.Solid(occt.make_solid(block.solid))
        _join(solid, block.solid)
        super().__init__(solid, rotation, align, mode)
        self._made = made
        self.label, self.color = block.label, bd.Color(*FIXTURE_COLOR)


class Elastica(bd.BaseLineObject):
    """Line object: the curve that a strip of given length takes between two clamps, or from one to its free end.

    Which of its many shapes is stated by `branch`, and chosen by `side` and `buckling`.

    Parameters
    ----------
    start, end : point
        In the plane of the workplane; `end=None` leaves the end free, with the start clamped.
    length : float
        Of the strip, mm: more than the distance of its ends.
    angles : pair of float or None
        Of the tangents at start and end, degrees, whole turns not counted; None leaves the strip free to turn
        there.
    stiffness : float, sequence or Profile
        Of a tapered strip: its widths at even stations, in any unit.
    gravity : Gravity, optional
        The strip's own weight, as `Sheet.gravity` gives it.
    force : pair of float, optional
        At a free end, newtons over the strip's least bending stiffness in N mm2 (`Sheet.bending_stiffness`).
    side : {+1, -1}
        Bulge to the left or the right of the way from start to end.
    buckling : int
        Buckling mode; above 1 the shape is unstable as a rule.
    mode : Mode
        How it joins the builder's line.

    Raises
    ------
    InputError
        A length that does not reach, points off the plane, a force at an end that is held.

    Examples
    --------
    >>> line = Elastica((0, 0), (70, 0), 100, angles=(0, 0))
    >>> round(line.length, 3), str(line.branch)
    (100.0, 'the strip bulges to the left of its chord, with 2 inflections (mode 1)')
    """

    def __init__(
        self,
        start: bd.VectorLike,
        end: bd.VectorLike | None,
        length: float,
        *,
        angles: tuple[float | None, float | None] = (None, None),
        stiffness: "float | Sequence[float] | Profile" = 1.0,
        gravity: Gravity | None = None,
        force: tuple[float, float] | None = None,
        side: int = 1,
        buckling: int = 1,
        mode: bd.Mode = bd.Mode.ADD,
    ) -> None:
        self.branch = elastica_between(
            start,
            end,
            length,
            angles=angles_in_rad(angles),
            stiffness=stiffness,
            gravity=gravity,
            force=force,
            side=side,
            mode=whole_number(buckling, "buckling", 1),
        )
        wire = occt.make_wire(Path([Spline(self.branch.curve)]))
        super().__init__(bd.Wire(wire), mode)


@overload
def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["flat"] = "flat",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> FlatStrip: ...


@overload
def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["bent"],
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> BentStrip: ...


@overload
def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["outline"],
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> StripOutline: ...


def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["flat", "bent", "outline"] = "flat",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> FlatStrip | BentStrip | StripOutline:
    """Operation: the strip of a curve, of the builder's pending edges unless `path` is given.

    Parameters
    ----------
    path : Edge, Wire, edges or PlaneCurve, optional
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        As in `StripOutline`.
    form : "flat", "bent" or "outline"
        The strip as cut (`FlatStrip`), as bent (`BentStrip`), or its flat pattern (`StripOutline`). Bent it stands
        on the pending edges where these are, as locations put them there; flat it lies at each active location.
    mode : Mode
        How it joins the builder's part or sketch.
    **options
        All others of `StripOutline`.

    Returns
    -------
    FlatStrip, BentStrip or StripOutline
        Where pending edges make several chains a `ShapeList` of them, one a chain.

    Raises
    ------
    InputError
        No path and no pending edges, an unknown form, and as `StripOutline`.
    """
    forms: dict[str, Any] = {"flat": FlatStrip, "bent": BentStrip, "outline": StripOutline}
    if form not in forms:
        raise InputError(f"form {form!r} is not known: choose one of {', '.join(forms)}")
    builder = bd.BuildSketch if form == "outline" else bd.BuildPart
    context = builder._get_context("elastic_strip")
    if path is None:
        if isinstance(context, bd.BuildLine):
            raise InputError(
                "elastic_strip stands inside BuildLine: end that first, a strip follows its line"
            )
        path = list(context.pending_edges) if context is not None else []
        if not path:
            raise InputError(
                "there is no curve: give a path, or draw one with BuildLine in the builder first"
            )
        context.pending_edges = bd.ShapeList()
        path = list(bd.Wire.combine(path)) if len(path) > 1 else path
        # pending edges are where the active locations put them, once for each
        drawn = bd.LocationList([bd.Location()]) if form == "bent" else nullcontext()
        with drawn:
            strips: list[Any] = [
                forms[form](chain, sheet, max_width=max_width, mode=mode, **options) for chain in path
            ]
        made: Any = strips[0] if len(strips) == 1 else bd.ShapeList(strips)
    else:
        made = forms[form](path, sheet, max_width=max_width, mode=mode, **options)
    found: FlatStrip | BentStrip | StripOutline = made
    return found


def section_strips(
    body: bd.Shape,
    planes: "bd.Plane | Frame | Iterable[bd.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "bd.ShapeList[BentStrip]":
    """The strips that follow the lines in which planes cut a face or a body.

    Parameters
    ----------
    body : Face, Shell or Solid
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, keeps the longest and smooths.
    sheet, max_width, **options
        As in `StripOutline`; most sections bend within `limits` only.
    half : bool
        Only what lies on the side to which a plane's x axis points.

    Returns
    -------
    ShapeList of BentStrip
        Standing in the section's plane, with its z axis to the strip's upper edge; called by `label` and a number.

    Raises
    ------
    InputError
        No section that a strip could follow, and as `StripOutline`.

    Warns
    -----
    StripWarning
        Of lines that are left out.

    Examples
    --------
    >>> dome = bd.Sphere(60, arc_size1=20)
    >>> planes = [bd.Plane.XZ.offset(y) for y in (-20, 0, 20)]
    >>> ribs = section_strips(dome.faces().sort_by(bd.Axis.Z)[-1], planes, "card-200gsm", max_width=8)
    >>> len(ribs)
    3
    """
    return bd.ShapeList(
        BentStrip(curve, sheet, max_width=max_width, mode=bd.Mode.PRIVATE, **placed)
        for curve, placed in section_requests(body, planes, options, half=half)
    )


class PlacedStrip(_Made, bd.Part):
    """A bent strip of a model, in its place; `strip`, `rod`, `check`, `warnings` tell about it."""


def model_compound(model: "Model", *, others: "Iterable[Holder]" = ()) -> bd.Compound:
    """The bent strips of a model as an assembly: a compound whose children are called like the parts.

    Equal strips share one body. Every child has the joints of `BentStrip` and knows its `strip`; the sheets of a
    laminate are its children.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        What holds the strips, as further children: plates and blocks, these with their joint "tab".

    Returns
    -------
    Compound
        Called like the model, with one `PlacedStrip` a strip.

    Raises
    ------
    InputError
        Something else among `others`.
    """
    from elastica_cad.fabrication.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    warn_of_missing_slots(model.placed)
    children = [
        _child(part, solids) for part, solids in shape_parts(parts, lambda part: _solids(part.solids))
    ]
    return bd.Compound(label=model.name, children=children)


def _child(part: "AssemblyPart", solids: list[bd.Solid]) -> bd.Part:
    """A part of an assembly in its place; of a strip one that knows it."""
    child: Any = bd.Part(solids[0].wrapped)
    if part.strip is not None:
        child = PlacedStrip(bd.Compound(solids).wrapped)
        base: Any = part.solids[0]
        child._made = MadeStrip(part.strip, Frame(), home=base.joints["start"])
        if len(solids) > 1:
            # new wrappers: equal strips share shapes, but a child has one parent
            layers = [bd.Solid(solid.wrapped) for solid in solids]
            for layer, name, color in zip(layers, part.names, part.colors, strict=True):
                layer.label, layer.color = name, bd.Color(*color)
            child.children = layers
    _join(child, part.solids[0])
    child.label, child.color = part.name, bd.Color(*part.colors[0])
    child.location = bd.Location(occt.make_location(part.frame))
    return child


def _jointed(records: Sequence[BodyRecord]) -> bd.Solid | bd.Part:
    """The sheets of a strip with the joints of its base."""
    solids = _solids(records)
    body = solids[0] if len(solids) == 1 else bd.Part(bd.Compound(solids).wrapped)
    _join(body, records[0])
    return body


def _solids(records: Sequence[BodyRecord | PrismSolid]) -> list[bd.Solid]:
    return [bd.Solid(occt.make_solid(record)) for record in records]


def _join(shape: Any, record: BodyRecord | PrismSolid) -> None:
    for name, frame in record.joints.items():
        bd.RigidJoint(name, shape, bd.Location(occt.make_location(frame)))


def _dress(shape: Any, made: MadeStrip) -> None:
    shape._made = made
    shape.label = made.strip.label or "strip"
    shape.color = bd.Color(*sheet_color(made.strip.sheet))


def _frame(location: bd.Location) -> Frame:
    plane = bd.Plane(location)
    return Frame(tuple(plane.origin), tuple(plane.x_dir), tuple(plane.y_dir))
