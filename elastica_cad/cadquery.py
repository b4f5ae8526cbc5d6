"""Strips in CadQuery: free functions, and methods of Workplane and Sketch after `register()`."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, Self, TypeAlias, TypeVar, Unpack

from elastica_cad.errors import InputError, how_to_install

try:
    import cadquery as cq
except ImportError as error:
    raise ImportError(f"elastica_cad.cadquery needs CadQuery: {how_to_install('cadquery')}") from error

from elastica_cad.fabrication.drawings.sheet_colors import sheet_color
from elastica_cad.fabrication.solids.prisms import PrismSolid
from elastica_cad.fabrication.solids.strip_solids import BentSolid, BodyRecord, FlatSolid, bent_sheets
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
    "FixtureSolid",
    "Slider",
    "StripCompound",
    "StripFace",
    "StripSolid",
    "StripWarning",
    "bent_strip",
    "elastica",
    "end_fixture",
    "flat_strip",
    "model_assembly",
    "register",
    "section_strips",
    "strip_outline",
]

Drawn: TypeAlias = cq.Edge | cq.Wire | cq.Workplane | PlaneCurve | Strip | StripBody | Iterable[cq.Edge]
"""A curve that is drawn, or a strip that was made before: then there is nothing to solve."""

Form: TypeAlias = Literal["flat", "bent"]

METHOD = "elasticStrip"
ENDS: tuple[End, End] = ("start", "end")
CHAIN = 1e-4  # mm: ends of pending edges that are meant to meet
KEPT = ("_made", "_joints", "label", "color")


class _Made(StripBody, cq.Shape):
    """The strip behind a shape, which copies, moved and turned ones keep. Its properties make the other bodies."""

    _joints: Mapping[str, cq.Location] = MappingProxyType({})
    color: cq.Color

    def _start(self) -> Frame | None:
        return _frame(self.location() * self._joints["start"]) if "start" in self._joints else None

    @property
    def flat(self) -> "StripSolid | StripCompound":
        """The strip as cut, on the xy plane."""
        return flat_strip(self)

    @property
    def outline(self) -> "StripFace":
        """The flat pattern as a face."""
        return strip_outline(self)

    def bent(self, **moved: Unpack[BendOptions]) -> "StripSolid | StripCompound":
        """The strip bent, with its ends led to `start` and `end` where given: points in space, or two numbers in
        the `frame` of the body, mm; `angles` (rad in that frame) and all others as in `mechanics.bend`.
        """
        if not moved:
            return bent_strip(self)
        return bent_strip(self._bent_anew(moved), plane=self.frame)

    def slider(self, end: Point) -> "Slider":
        """The travel of the strip's end to a point in space, or two numbers in its `frame`, mm."""
        return Slider(self, end)

    @property
    def backing(self) -> cq.Solid:
        """The bent backing of a laminated strip."""
        self._require_backing()
        return self.layers[1]

    @property
    def layers(self) -> tuple[cq.Solid, ...]:
        """The sheets of the bent strip, the base first, with labels."""
        found = []
        for shape, name, _ in self._layers():
            solid: cq.Solid = cq.Solid(shape)
            solid.label = name
            found.append(solid)
        return tuple(found)

    @property
    def assembly(self) -> cq.Assembly:
        """The sheets of the bent strip as children of one assembly, with names and colours."""
        made = cq.Assembly(name=_plain(self.strip.label or "strip"))
        for solid, sheet in zip(self.layers, bent_sheets(self.strip), strict=True):
            made.add(solid, name=_called(solid.label, made), color=cq.Color(*sheet_color(sheet)))
        return made

    def fixture(self, end: "End" = "start", **sizes: Unpack[BlockOptions]) -> "FixtureSolid":
        """The block that holds an end of the bent strip, in place; `sizes` as in `end_fixture`."""
        return end_fixture(self, end=end, **sizes)

    def moved(self, *args: Any, **options: Any) -> Any:
        """As `Shape.moved`; a single copy still knows its strip."""
        return self._told(super().moved(*args, **options))

    def located(self, loc: cq.Location) -> Self:
        """As `Shape.located`; the copy still knows its strip."""
        made: Self = self._told(super().located(loc))
        return made

    def copy(self, mesh: bool = False) -> Self:
        """As `Shape.copy`; the copy still knows its strip."""
        made: Self = self._told(super().copy(mesh))
        return made

    def clean(self) -> Self:
        """As `Shape.clean`; what comes of it still knows its strip."""
        made: Self = self._told(super().clean())
        return made

    def mirror(self, mirrorPlane: Any = "XY", basePointVector: Any = (0, 0, 0)) -> Self:
        """As `Shape.mirror`; the image still knows its strip, which is turned over."""
        made: Self = super().mirror(mirrorPlane, basePointVector)
        return made

    def scale(self, factor: float) -> cq.Shape:
        """As `Shape.scale`: a plain body, as a strip of another size has other numbers."""
        plain = cq.Shape.cast(super().scale(factor).wrapped)
        plain.label = self.label
        return plain

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """CadQuery makes what is rounded or hollowed an object of the same class: it is no strip any more."""
            if "_made" in self.__dict__ or name.startswith("__"):
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            raise AttributeError(
                f"a body that was rounded, chamfered or hollowed has no {name}: ask the strip that it was made from"
            )

    def __getstate__(self) -> tuple[Any, ...]:
        """What `copy`, `deepcopy` and `pickle` take along: the strip too."""
        kept = {k: v for k, v in self.__dict__.items() if k in KEPT}
        if "color" in kept:
            kept["color"] = self.color.toTuple()
        return super().__getstate__(), kept

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        shape, kept = state
        super().__setstate__(shape)
        self.__dict__.update(kept)
        if "color" in kept:
            self.color = cq.Color(*kept["color"])

    def _apply_transform(self, Tr: Any) -> Any:
        made = self._told(super()._apply_transform(Tr))
        if isinstance(made, type(self)) and "_made" in self.__dict__:
            here, back = self.location(), made.location().inverse
            if Tr.IsNegative():
                made._made = self._made.mirrored()
            made._joints = {
                name: back * _location(occt.moved_frame(_frame(here * at), Tr))
                for name, at in self._joints.items()
            }
        return made

    def _told(self, copy: Any) -> Any:
        if isinstance(copy, type(self)):
            copy.__dict__.update({k: v for k, v in self.__dict__.items() if k in KEPT})
        return copy


class Slider:
    """A strip's end on its way, straight and with its direction held, to another point.

    Parameters
    ----------
    rib : StripSolid or StripCompound
        A bent strip.
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
    >>> rib = bent_strip(elastica((0, 0), (160, 0), 200, angles=(0, 0)), "pom-0.5", max_width=10)
    >>> slider = rib.slider(end=(130, 0))
    >>> lamp = cq.Assembly(slider.bent(15), name="rib")
    >>> lamp = lamp.add(cq.Workplane().box(10, 20, 10), name="carriage", loc=slider.place(15))
    >>> round(lamp.objects["carriage"].toCompound().Center().x, 6)
    145.0
    >>> round(slider.bent(15).joints["end"].toTuple()[0][0], 6)
    145.0
    """

    def __init__(self, rib: "_Made", end: Point) -> None:
        if rib._made.home is None:
            raise InputError("the end of a strip slides when it is bent: take its body .bent() first")
        from elastica_cad.kernel.end_travel import Travel

        self.travel = Travel(rib.strip, rib.frame, rib._in_plane(end, "end"))

    def place(self, position: float) -> cq.Location:
        """Where the end is `position` mm along the way: x along it, z across the strip."""
        return _location(self.travel.place) * cq.Location((position, 0, 0))

    def bent(self, position: float) -> "StripSolid | StripCompound":
        """The strip with its end `position` mm along the way."""
        travel = self.travel
        return bent_strip(replace(travel.strip, rod=travel.rod(position)), plane=travel.frame)

    def constrain(self, assembly: cq.Assembly, name: str, position: float) -> cq.Assembly:
        """Hold a child, or a tagged face of it ("carriage?foot"), on the way for `solve()`, square to it."""
        at, turn = self.place(position).toTuple()
        child, _, _ = name.partition("?")
        return assembly.constrain(name, "FixedPoint", at).constrain(child, "FixedRotation", turn)

    def write_glb(
        self, path: str | PathLike[str], *, frames: int = 25, seconds: float = 4.0, force: bool = False
    ) -> None:
        """Write the way there and back as an animation; a file that is there only with `force`."""
        self.travel.write_glb(path, frames=frames, seconds=seconds, force=force)


class StripFace(_Made, cq.Face):
    """The flat pattern of a strip; `strip`, `rod`, `check`, `warnings` tell about it."""


class _Jointed(_Made):
    @property
    def joints(self) -> Mapping[str, cq.Location]:
        """Places to join other parts to.

        Of a strip "start" and "end" of the free part and "hole1", "hole2", ...: half way through the thickness, z
        off the strip, x along it (outward at the ends). Of a fixture "tab", which lies on the strip's start or end.
        """
        here = self.location()
        # a dict of this name would be taken for build123d's joints by viewers that show both libraries
        return MappingProxyType({name: here * place for name, place in self._joints.items()})


class _Ended(_Jointed):
    def end_face(self, end: End) -> cq.Face:
        """The plane face that closes the strip at one end."""
        if end not in ENDS:
            raise InputError(f'a strip has the ends "start" and "end", not {end!r}')
        tab = self.strip.ends[0 if end == "start" else 1].length
        if self.strip.is_closed and self._made.home is not None:  # bent, its lap is another body
            tab = 0.0
        tip = cq.Vector(*(self.joints[end] * cq.Location((tab, 0, 0))).toTuple()[0])
        return min(self.Faces(), key=lambda face: (face.Center() - tip).Length)


class StripSolid(_Ended, cq.Solid):
    """A strip, flat or bent; `strip`, `rod`, `check`, `warnings` tell about it."""


class StripCompound(_Ended, cq.Compound):
    """The sheets of a laminated strip, flat or bent; otherwise as `StripSolid`."""


class FixtureSolid(_Jointed, cq.Solid):
    """A block that holds one end of a strip; `strip`, `rod`, `check`, `warnings` tell about the strip."""


S = TypeVar("S", bound=_Made)


def strip_outline(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripFace:
    """The flat pattern of the strip that bends into a curve, on the xy plane.

    The x axis runs along the strip from the start of its free part, y = 0 is the centre line.

    Parameters
    ----------
    path : Edge, Wire, Workplane, edges that follow each other, or PlaneCurve
        The curve that the strip is to take.
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        The largest width of the free part, mm; or give `min_width`, the least.
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
    >>> arch = cq.Edge.makeSpline([cq.Vector(0, 0), cq.Vector(60, 50), cq.Vector(120, 0)])
    >>> strip_outline(arch, "card-200gsm", max_width=20).geomType()
    'PLANE'
    """
    made = _designed(path, sheet, max_width=max_width, **options)
    return _dressed(StripFace(made.face), {}, made)


def flat_strip(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripSolid | StripCompound:
    """The strip as cut, from z = 0 upward; parameters, errors and axes as in `strip_outline`."""
    made = _designed(path, sheet, max_width=max_width, **options)
    return _body(FlatSolid.layers(made.strip), made)


def bent_strip(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    **options: Unpack[StripOptions],
) -> StripSolid | StripCompound:
    """The strip bent, standing on the drawn curve with half its thickness to either side.

    Parameters and errors as in `strip_outline`.
    """
    made = _designed(path, sheet, max_width=max_width, **options)
    return _body(BentSolid.layers(made.strip, made.frame), made)


def end_fixture(
    path: Drawn,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    end: End = "start",
    floor: cq.Plane | None = None,
    number: str | None = None,
    **options: Unpack[FixtureOptions],
) -> FixtureSolid:
    """The block that holds one end of the bent strip, in place beside `bent_strip` of the same path.

    Parameters
    ----------
    path, sheet, max_width, **options
        As in `strip_outline`.
    end : "start" or "end"
    floor : Plane, optional
        What the block stands on; without it on a plane square to the tab.
    clearance, wall, foot, foot_height, screw, number
        As in `fabrication.EndFixture`, mm.

    Raises
    ------
    InputError
        No tab at that end, sizes that do not fit, a floor not square to the curve's plane; and as `strip_outline`.
    """
    edges, drawn_on = _drawn(path)
    made, block = make_fixture_on(
        edges, sheet, max_width=max_width, end=end, floor=floor, number=number, **drawn_on, **options
    )
    return _dressed(FixtureSolid(occt.make_solid(block.solid)), block.solid.joints, made)


def elastica(
    start: cq.Vector | tuple[float, float],
    end: cq.Vector | tuple[float, float] | None,
    length: float,
    *,
    angles: tuple[float | None, float | None] = (None, None),
    stiffness: "float | Sequence[float] | Profile" = 1.0,
    gravity: Gravity | None = None,
    force: tuple[float, float] | None = None,
    side: int = 1,
    buckling: int = 1,
) -> cq.Edge:
    """The curve of a strip of given length between two clamps, or of one with a free end, as an edge in xy.

    Parameters
    ----------
    start, end : (x, y) or Vector
        mm; `end=None` leaves the end free, with the start clamped.
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

    Raises
    ------
    InputError
        A length that does not reach, a force at an end that is held.

    Examples
    --------
    >>> round(elastica((0, 0), (70, 0), 100, angles=(0, 0)).Length(), 3)
    100.0
    """
    found = elastica_between(
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
    return cq.Wire(occt.make_wire(Path([Spline(found.curve)]))).Edges()[0]


def section_strips(
    body: "cq.Shape | cq.Workplane",
    planes: "cq.Plane | Frame | Iterable[cq.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "list[StripSolid | StripCompound]":
    """The strips that follow the lines in which planes cut a face or a body.

    Parameters
    ----------
    body : Face, Shell, Solid, or Workplane with one
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, keeps the longest and smooths.
    sheet, max_width, **options
        As in `strip_outline`; most sections bend within `limits` only.
    half : bool
        Only what lies on the side to which a plane's x axis points.

    Returns
    -------
    list of StripSolid
        Standing in the section's plane; called by `label` and a number.

    Raises
    ------
    InputError
        No section that a strip could follow, and as `strip_outline`.

    Warns
    -----
    StripWarning
        Of lines that are left out.

    Examples
    --------
    >>> dome = cq.Workplane().sphere(60, angle1=20).faces(">Z")
    >>> len(section_strips(dome, cq.Plane.XZ(), "card-200gsm", max_width=8))
    1
    """
    shape = body.val() if isinstance(body, cq.Workplane) else body
    return [
        bent_strip(curve, sheet, max_width=max_width, **placed)
        for curve, placed in section_requests(shape, planes, options, half=half)
    ]


def model_assembly(model: "Model", *, others: "Iterable[Holder]" = ()) -> cq.Assembly:
    """The bent strips of a model as an assembly with names, colours and places.

    The ends of every strip are held by constraints (points and axes of their end faces), so that parts which are
    added and constrained to them find their places in `solve()` while the strips stay. Equal strips share one body.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        What holds the strips, as further children, held where they are by `solve()` as the strips.

    Returns
    -------
    Assembly
        Called like the model; its children like the parts (with "_" for what queries cannot hold), each strip
        with its end faces tagged "start" and "end" and its `Strip` as metadata "strip". Of a laminate that is the
        base, with the backing as its child.

    Raises
    ------
    InputError
        Something else among `others`.
    """
    from elastica_cad.fabrication.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    assembly = cq.Assembly(name=model.name)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    warn_of_missing_slots(model.placed)
    for part, (body, *glued_on) in shape_parts(parts, _part_shapes):
        name, place = _called(part.name, assembly), _location(part.frame)
        color, *colors = (cq.Color(*each) for each in part.colors)
        if not isinstance(body, StripSolid):
            assembly.add(body, name=name, color=color, loc=place)
            assembly.constrain(name, "Fixed")
            continue
        work = cq.Workplane(obj=body)
        faces = {end: body.end_face(end) for end in ENDS}
        for end, face in faces.items():
            work.newObject([face]).tag(end)
        strip = cq.Assembly(work, name=name, loc=place, color=color, metadata={"strip": part.strip})
        for sheet, label, its_color in zip(glued_on, part.names[1:], colors, strict=True):
            strip.add(sheet, name=_called(label, assembly), color=its_color)
        assembly.add(strip)
        for end, face in faces.items():
            there = face.moved(place)
            assembly.constrain(f"{name}?{end}", "FixedPoint", there.Center().toTuple())
            assembly.constrain(f"{name}?{end}", "FixedAxis", there.normalAt().toTuple())
    return assembly


def _part_shapes(part: "AssemblyPart") -> list[cq.Shape]:
    """A body, of a strip its sheets: the base is the one that knows its strip."""
    base, *glued_on = (cq.Solid(occt.make_solid(record)) for record in part.solids)
    if part.strip is not None:
        home = part.solids[0].joints["start"]
        made = MadeStrip(part.strip, Frame(), home=home)
        base = _dressed(StripSolid(base.wrapped), part.solids[0].joints, made)
    return [base, *glued_on]


def register() -> None:
    """Add `elasticStrip` to cq.Workplane and cq.Sketch; calling it again does no harm.

    Raises
    ------
    InputError
        Another library has put an `elasticStrip` there.
    """
    methods: dict[type, Callable[..., Any]] = {cq.Workplane: _workplane_strip, cq.Sketch: _sketch_strip}
    for owner, method in methods.items():
        if getattr(owner, METHOD, method) is not method:
            raise InputError(
                f"cq.{owner.__name__} has an {METHOD} of another library already: use the functions of "
                "elastica_cad.cadquery instead"
            )
    for owner, method in methods.items():
        setattr(owner, METHOD, method)


def _workplane_strip(
    self: cq.Workplane,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    form: Form = "flat",
    combine: bool | str = False,
    clean: bool = True,
    **options: Unpack[StripOptions],
) -> cq.Workplane:
    """The strip of the pending edges and wires, or of the edges and wires selected.

    Parameters
    ----------
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        As in `strip_outline`.
    form : "flat" or "bent"
        Flat it lies on the workplane, the start of its free part at the origin; bent it stands on the edges,
        which are moved to the points of the stack, where there are some.
    combine, clean
        As in `Workplane.eachpoint`.
    **options
        As in `strip_outline`.

    Returns
    -------
    Workplane
        With a strip for every chain of edges on its stack, at every point of the stack; their end faces are tagged
        "start" and "end".
    """
    if form not in ("flat", "bent"):
        raise InputError(f"form {form!r} is not known: choose flat or bent")
    pending = [*self.ctx.popPendingEdges(False), *self.ctx.popPendingWires(False)]
    drawn = pending or [item for item in self.objects if isinstance(item, cq.Edge | cq.Wire)]
    if not drawn:
        raise InputError("there is no curve: draw one on the workplane, or select edges")
    bodies = []
    for chain in cq.Wire.combine(_edges(drawn), CHAIN):
        made = _designed(chain, sheet, max_width=max_width, workplane=self.plane, **options)
        records = FlatSolid.layers(made.strip) if form == "flat" else BentSolid.layers(made.strip, made.frame)
        bodies.append(_body(records, made))
    tidy = clean and bool(combine)  # alone the strip is clean, and stays the object that knows its rod
    points = [item for item in self.objects if not isinstance(item, cq.Edge | cq.Wire)]
    places = points or [cq.Location()]
    local = form == "flat" or bool(points)  # what is drawn in place stays as it was made
    if local and form == "bent":
        bodies = [body.moved(self.plane.location.inverse) for body in bodies]
    left = iter([body for body in bodies for _ in places])
    put = []

    def at_place(place: cq.Location) -> StripSolid | StripCompound:
        put.append(next(left).moved(place) if local else next(left))
        return put[-1]

    made = self.newObject(places * len(bodies)).eachpoint(at_place, local, combine, tidy)
    for end in ENDS:
        self.newObject([body.end_face(end) for body in put]).tag(end)
    return made


def _edges(drawn: Iterable[cq.Edge | cq.Wire]) -> list[cq.Edge]:
    return [edge for item in drawn for edge in (item.Edges() if isinstance(item, cq.Wire) else [item])]


def _sketch_strip(
    self: cq.Sketch,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    mode: str = "a",
    tag: str | None = None,
    **options: Unpack[StripOptions],
) -> cq.Sketch:
    """Add the flat pattern of the strip that bends into the sketch's edges; these are used up.

    `mode` and `tag` as in `Sketch.face`, other arguments as in `strip_outline`.
    """
    if not self._edges:
        raise InputError("there is no curve: draw edges in the sketch first")
    face = strip_outline(list(self._edges), sheet, max_width=max_width, **options)
    self._edges = []
    return self.reset().face(face, mode=mode, tag=tag)


def _drawn(path: Drawn) -> tuple[Any, dict[str, Any]]:
    """What was drawn, and of a Workplane the plane it was drawn on."""
    if not isinstance(path, cq.Workplane):
        return path, {}
    return [*path.ctx.pendingEdges, *path.ctx.pendingWires] or path.vals(), {"workplane": path.plane}


def _designed(path: Drawn, sheet: Sheet | str | None, **options: Any) -> MadeStrip:
    edges, drawn_on = _drawn(path)
    return make_strip_on(edges, sheet, **(drawn_on | options))


def _body(records: Sequence[BodyRecord | PrismSolid], made: MadeStrip) -> StripSolid | StripCompound:
    solids = [occt.make_solid(record) for record in records]
    shape: StripSolid | StripCompound
    if len(solids) == 1:
        shape = StripSolid(solids[0])
    else:
        shape = StripCompound(cq.Compound.makeCompound([cq.Solid(solid) for solid in solids]).wrapped)
    if isinstance(records[0], BentSolid):
        made = replace(made, home=records[0].joints["start"])
    return _dressed(shape, records[0].joints, made)


def _dressed(shape: S, joints: Mapping[str, Frame], made: MadeStrip) -> S:
    shape._made = made
    shape._joints = {name: _location(frame) for name, frame in joints.items()}
    shape.label = made.strip.label or "strip"
    shape.color = cq.Color(*sheet_color(made.strip.sheet))
    return shape


def _frame(location: cq.Location) -> Frame:
    plane = cq.Plane(location)
    return Frame(plane.origin.toTuple(), plane.xDir.toTuple(), plane.yDir.toTuple())


def _plain(name: str) -> str:
    """A name that CadQuery's queries can hold."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)
    return plain if plain[:1].isalpha() else f"strip_{plain}"


def _called(name: str, assembly: cq.Assembly) -> str:
    """A name that CadQuery's queries can hold, unlike those in the assembly."""
    plain = _plain(name)
    tries = (plain, *(f"{plain}_{number}" for number in range(2, len(assembly.children) + 3)))
    return next(text for text in tries if text not in assembly.objects)


def _location(frame: Frame) -> cq.Location:
    return cq.Location(occt.make_location(frame))
