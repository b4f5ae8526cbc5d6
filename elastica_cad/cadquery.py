"""Strips in CadQuery: free functions, and methods of Workplane and Sketch after `register()`."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, Literal, TypeAlias, TypeVar

try:
    import cadquery as cq
except ImportError as error:
    raise ImportError("elastica_cad.cadquery needs CadQuery: pip install cadquery") from error

from elastica_cad import occt
from elastica_cad.errors import InputError
from elastica_cad.fabrication import BentSolid, EndFixture, FlatSolid, Frame, Model, Strip, sheet_color
from elastica_cad.fabrication.assembly import Holder, bent_parts, holder_bodies
from elastica_cad.fabrication.making import StripFacts, make_strip
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Sheet

__all__ = [
    "FixtureSolid",
    "StripCompound",
    "StripFace",
    "StripSolid",
    "bent_strip",
    "end_fixture",
    "flat_strip",
    "model_assembly",
    "register",
    "strip_outline",
]

Drawn: TypeAlias = cq.Edge | cq.Wire | cq.Workplane | PlaneCurve | Iterable[cq.Edge]
Form: TypeAlias = Literal["flat", "bent"]
End: TypeAlias = Literal["start", "end"]

METHOD = "elasticStrip"
ENDS: tuple[End, End] = ("start", "end")


class _Made(StripFacts, cq.Shape):
    """The strip behind a shape; a shape moved by `moved` or `located` keeps it."""

    def moved(self, *args: Any, **options: Any) -> Any:
        """As `Shape.moved`; a single copy still knows its strip."""
        return self._told(super().moved(*args, **options))

    def located(self, loc: cq.Location) -> Any:
        """As `Shape.located`; the copy still knows its strip."""
        return self._told(super().located(loc))

    def _told(self, copy: Any) -> Any:
        if isinstance(copy, type(self)):
            copy.__dict__.update({k: v for k, v in self.__dict__.items() if k in ("strip", "_joints")})
        return copy


class StripFace(_Made, cq.Face):
    """The flat pattern of a strip; `strip`, `rod`, `check`, `warnings` tell about it."""


class _Jointed(_Made):
    _joints: Mapping[str, cq.Location]

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
        tab = self.strip.ends[0 if end == "start" else 1].length
        tip = cq.Vector(*(self.joints[end] * cq.Location((tab, 0, 0))).toTuple()[0])
        return min(self.Faces(), key=lambda face: (face.Center() - tip).Length)


class StripSolid(_Ended, cq.Solid):
    """A strip, flat or bent; `strip`, `rod`, `check`, `warnings` tell about it."""


class StripCompound(_Ended, cq.Compound):
    """The sheets of a laminated strip, flat or bent; otherwise as `StripSolid`."""


class FixtureSolid(_Jointed, cq.Solid):
    """A block that holds one end of a strip; `strip`, `rod`, `check`, `warnings` tell about the strip."""


S = TypeVar("S", bound=_Jointed)


def strip_outline(
    path: Drawn, sheet: Sheet | str, *, max_width: float | None = None, **options: Any
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
        `min_width`, `limits`, `keep`, `gravity`, `supports`, and the options of `Strip`.

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
    strip, _ = _designed(path, sheet, max_width=max_width, **options)
    face = StripFace(occt.make_face(strip.outline, strip.holes))
    face.strip = strip
    return face


def flat_strip(
    path: Drawn, sheet: Sheet | str, *, max_width: float | None = None, **options: Any
) -> StripSolid | StripCompound:
    """The strip as cut, from z = 0 upward; parameters, errors and axes as in `strip_outline`."""
    strip, _ = _designed(path, sheet, max_width=max_width, **options)
    return _body(FlatSolid.layers(strip), strip)


def bent_strip(
    path: Drawn, sheet: Sheet | str, *, max_width: float | None = None, **options: Any
) -> StripSolid | StripCompound:
    """The strip bent, standing on the drawn curve with half its thickness to either side.

    Parameters and errors as in `strip_outline`.
    """
    strip, frame = _designed(path, sheet, max_width=max_width, **options)
    return _body(BentSolid.layers(strip, frame), strip)


def end_fixture(
    path: Drawn,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    end: End = "start",
    floor: cq.Plane | None = None,
    clearance: float = 0.15,
    wall: float = 4.0,
    foot: float = 12.0,
    foot_height: float = 4.0,
    screw: float = 4.3,
    number: str | None = None,
    **options: Any,
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
    strip, frame = _designed(path, sheet, max_width=max_width, **options)
    sizes = {"clearance": clearance, "wall": wall, "foot": foot, "foot_height": foot_height, "screw": screw}
    ground = (
        None if floor is None else Frame(*(axis.toTuple() for axis in (floor.origin, floor.xDir, floor.yDir)))
    )
    block = EndFixture.of(strip, end, frame, floor=ground, number=number, **sizes).solid
    return _dressed(FixtureSolid(occt.make_solid(block)), block.joints, strip)


def model_assembly(model: Model, *, others: Iterable[Holder] = ()) -> cq.Assembly:
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
        with its end faces tagged "start" and "end" and its `Strip` as metadata "strip".

    Raises
    ------
    InputError
        Something else among `others`.
    """
    assembly = cq.Assembly(name=model.name)
    bodies: dict[int, StripSolid | StripCompound] = {}
    for part in bent_parts(model):
        if id(part.solids) not in bodies:
            bodies[id(part.solids)] = _body(part.solids, part.strip)
        solid, place = bodies[id(part.solids)], _location(part.frame)
        work = cq.Workplane(obj=solid)
        faces = {end: solid.end_face(end) for end in ENDS}
        for end, face in faces.items():
            work.newObject([face]).tag(end)
        color = cq.Color(*sheet_color(part.strip.sheet))
        name = _called(part.name, assembly)
        assembly.add(work, name=name, loc=place, color=color, metadata={"strip": part.strip})
        for end, face in faces.items():
            there = face.moved(place)
            assembly.constrain(f"{name}?{end}", "FixedPoint", there.Center().toTuple())
            assembly.constrain(f"{name}?{end}", "FixedAxis", there.normalAt().toTuple())
    for body in holder_bodies((*model.plates, *others)):
        name = _called(body.name, assembly)
        assembly.add(cq.Solid(occt.make_solid(body.solid)), name=name, color=cq.Color(*body.color))
        assembly.constrain(name, "Fixed")
    return assembly


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
    **options: Any,
) -> cq.Workplane:
    """The strip of the pending edges and wires, or of the edges and wires selected.

    Parameters
    ----------
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        As in `strip_outline`.
    form : "flat" or "bent"
        Flat it lies on the workplane, the start of its free part at the origin; bent it stands on the edges.
    combine, clean
        As in `Workplane.eachpoint`.
    **options
        As in `strip_outline`.

    Returns
    -------
    Workplane
        With the strip on its stack; its end faces are tagged "start" and "end".
    """
    if form not in ("flat", "bent"):
        raise InputError(f"form {form!r} is not known: choose flat or bent")
    pending = [*self.ctx.popPendingEdges(False), *self.ctx.popPendingWires(False)]
    drawn = pending or [item for item in self.objects if isinstance(item, cq.Edge | cq.Wire)]
    if not drawn:
        raise InputError("there is no curve: draw one on the workplane, or select edges")
    solid = (flat_strip if form == "flat" else bent_strip)(drawn, sheet, max_width=max_width, **options)
    here = self.plane.location if form == "flat" else cq.Location()
    for end in ENDS:
        self.newObject([solid.end_face(end).moved(here)]).tag(end)
    origin = self.newObject([cq.Location()])
    tidy = clean and bool(combine)  # alone the strip is clean, and stays the object that knows its rod
    return origin.eachpoint(
        lambda at: solid.moved(at) if form == "flat" else solid, form == "flat", combine, tidy
    )


def _sketch_strip(
    self: cq.Sketch,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    mode: str = "a",
    tag: str | None = None,
    **options: Any,
) -> cq.Sketch:
    """Add the flat pattern of the strip that bends into the sketch's edges; these are used up.

    `mode` and `tag` as in `Sketch.face`, other arguments as in `strip_outline`.
    """
    if not self._edges:
        raise InputError("there is no curve: draw edges in the sketch first")
    face = strip_outline(list(self._edges), sheet, max_width=max_width, **options)
    self._edges = []
    return self.reset().face(face, mode=mode, tag=tag)


def _designed(path: Drawn, sheet: Sheet | str, **options: Any) -> tuple[Strip, Frame]:
    if isinstance(path, cq.Workplane):
        path = [*path.ctx.pendingEdges, *path.ctx.pendingWires] or path.vals()
    curve, frame = (path, Frame()) if isinstance(path, PlaneCurve) else occt.plane_curve(path)
    return make_strip(curve, sheet, **options), frame


def _body(records: Sequence[FlatSolid | BentSolid], strip: Strip) -> StripSolid | StripCompound:
    solids = [occt.make_solid(record) for record in records]
    if len(solids) == 1:
        return _dressed(StripSolid(solids[0]), records[0].joints, strip)
    compound = cq.Compound.makeCompound([cq.Solid(solid) for solid in solids])
    return _dressed(StripCompound(compound.wrapped), records[0].joints, strip)


def _dressed(shape: S, joints: Mapping[str, Frame], strip: Strip) -> S:
    shape.strip = strip
    shape._joints = {name: _location(frame) for name, frame in joints.items()}
    return shape


def _called(name: str, assembly: cq.Assembly) -> str:
    """A name that CadQuery's queries can hold, unlike those in the assembly."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)
    plain = plain if plain[:1].isalpha() else f"strip_{plain}"
    tries = (plain, *(f"{plain}_{number}" for number in range(2, len(assembly.children) + 3)))
    return next(text for text in tries if text not in assembly.objects)


def _location(frame: Frame) -> cq.Location:
    return cq.Location(occt.make_location(frame))
