"""Strips in build123d: sketch and part objects, and an operation on pending edges."""

from collections.abc import Iterable, Sequence
from typing import Any, Literal, TypeAlias

try:
    import build123d as bd
except ImportError as error:
    raise ImportError("elastica_cad.build123d needs build123d: pip install build123d") from error

from elastica_cad import occt
from elastica_cad.errors import InputError
from elastica_cad.fabrication import BentSolid, FlatSolid, Frame, Model, Strip, sheet_color
from elastica_cad.fabrication import EndFixture as FixtureRecord
from elastica_cad.fabrication.assembly import Holder, bent_parts, holder_bodies
from elastica_cad.fabrication.colors import FIXTURE_COLOR
from elastica_cad.fabrication.making import StripFacts, make_strip
from elastica_cad.fabrication.prisms import PrismSolid
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Sheet

__all__ = [
    "BentStrip",
    "EndFixture",
    "FlatStrip",
    "PlacedStrip",
    "StripOutline",
    "elastic_strip",
    "model_compound",
]

Drawn: TypeAlias = bd.Edge | bd.Wire | PlaneCurve | Iterable[bd.Edge]


class _Made(StripFacts):
    """The strip behind a shape; copies of the shape share it."""

    @property
    def strip(self) -> Strip:
        """The strip: widths, outline, strain, mass."""
        return self._shared.strip

    @strip.setter
    def strip(self, strip: Strip) -> None:
        self._shared = _Shared(strip)


class _Shared:
    """A record that copies of a shape need not copy."""

    def __init__(self, strip: Strip) -> None:
        self.strip = strip

    def __deepcopy__(self, memo: dict[int, Any]) -> "_Shared":
        return self


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
        `min_width`, `limits`, `keep`, `gravity`, `supports`, and the options of `Strip`.

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
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        rotation: float = 0,
        align: bd.Align | tuple[bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Any,
    ) -> None:
        curve, _ = _curve_and_frame(path)
        made = make_strip(curve, sheet, max_width=max_width, **options)
        super().__init__(bd.Face(occt.make_face(made.outline, made.holes)), rotation, align, mode)
        _dress(self, made)


class FlatStrip(_Made, bd.BasePartObject):
    """Part object: the strip as cut, lying on the xy plane.

    Rigid joints "start", "end", "hole1", "hole2", ... lie half way through the thickness: z off the sheet, x
    outward along the strip. Parameters, errors and frame as in `StripOutline`.
    """

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: bd.Align | tuple[bd.Align, bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Any,
    ) -> None:
        curve, _ = _curve_and_frame(path)
        made = make_strip(curve, sheet, max_width=max_width, **options)
        super().__init__(_jointed(FlatSolid.layers(made)), rotation, align, mode)
        _dress(self, made)


class BentStrip(_Made, bd.BasePartObject):
    """Part object: the strip bent, standing on the drawn curve with half its thickness to either side.

    Inside a builder the path is in the coordinates of its workplane, as all that is drawn there. Joints as on
    `FlatStrip`, parameters and errors as in `StripOutline`.
    """

    def __init__(
        self,
        path: Drawn,
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: bd.Align | tuple[bd.Align, bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Any,
    ) -> None:
        curve, frame = _curve_and_frame(path)
        made = make_strip(curve, sheet, max_width=max_width, **options)
        super().__init__(_jointed(BentSolid.layers(made, frame)), rotation, align, mode)
        _dress(self, made)


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
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        end: Literal["start", "end"] = "start",
        floor: bd.Plane | None = None,
        clearance: float = 0.15,
        wall: float = 4.0,
        foot: float = 12.0,
        foot_height: float = 4.0,
        screw: float = 4.3,
        number: str | None = None,
        rotation: bd.RotationLike = (0, 0, 0),
        align: bd.Align | tuple[bd.Align, bd.Align, bd.Align] | None = None,
        mode: bd.Mode = bd.Mode.ADD,
        **options: Any,
    ) -> None:
        curve, frame = _curve_and_frame(path)
        made = make_strip(curve, sheet, max_width=max_width, **options)
        sizes = {
            "clearance": clearance,
            "wall": wall,
            "foot": foot,
            "foot_height": foot_height,
            "screw": screw,
        }
        ground = None if floor is None else Frame(tuple(floor.origin), tuple(floor.x_dir), tuple(floor.y_dir))
        block = FixtureRecord.of(made, end, frame, floor=ground, number=number, **sizes)
        solid = bd.Solid(occt.make_solid(block.solid))
        _join(solid, block.solid)
        super().__init__(solid, rotation, align, mode)
        self.strip = made
        self.label, self.color = f"fixture {block.number or block.tab.name}", bd.Color(*FIXTURE_COLOR)


def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str,
    max_width: float | None = None,
    form: Literal["flat", "bent", "outline"] = "flat",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Any,
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
        The strip as cut (`FlatStrip`), as bent (`BentStrip`), or its flat pattern (`StripOutline`).
    mode : Mode
        How it joins the builder's part or sketch.
    **options
        All others of `StripOutline`.

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
        path = list(context.pending_edges) if context is not None else []
        if not path:
            raise InputError(
                "there is no curve: give a path, or draw one with BuildLine in the builder first"
            )
        context.pending_edges = bd.ShapeList()
    strip: FlatStrip | BentStrip | StripOutline = forms[form](
        path, sheet, max_width=max_width, mode=mode, **options
    )
    return strip


class PlacedStrip(_Made, bd.Part):
    """A bent strip of a model, in its place; `strip`, `rod`, `check`, `warnings` tell about it."""


def model_compound(model: Model, *, others: Iterable[Holder] = ()) -> bd.Compound:
    """The bent strips of a model as an assembly: a compound whose children are called like the parts.

    Equal strips share one body. Every child has the joints of `BentStrip` and knows its `strip`.

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
    bodies: dict[int, list[bd.Solid]] = {}
    children: list[bd.Part] = []
    for part in bent_parts(model):
        if id(part.solids) not in bodies:
            bodies[id(part.solids)] = _solids(part.solids)
        child = PlacedStrip(bd.Compound(bodies[id(part.solids)]).wrapped)
        _join(child, part.solids[0])
        _dress(child, part.strip)
        child.label = part.name
        child.location = bd.Location(occt.make_location(part.frame))
        children.append(child)
    for body in holder_bodies((*model.plates, *others)):
        holder = bd.Part(occt.make_solid(body.solid))
        _join(holder, body.solid)
        holder.label, holder.color = body.name, bd.Color(*body.color)
        children.append(holder)
    return bd.Compound(label=model.name, children=children)


def _curve_and_frame(path: Drawn) -> tuple[PlaneCurve, Frame]:
    return (path, Frame()) if isinstance(path, PlaneCurve) else occt.plane_curve(path)


def _jointed(records: Sequence[FlatSolid | BentSolid]) -> bd.Solid | bd.Part:
    """The sheets of a strip with the joints of its base."""
    solids = _solids(records)
    body = solids[0] if len(solids) == 1 else bd.Part(bd.Compound(solids).wrapped)
    _join(body, records[0])
    return body


def _solids(records: Sequence[FlatSolid | BentSolid]) -> list[bd.Solid]:
    return [bd.Solid(occt.make_solid(record)) for record in records]


def _join(shape: Any, record: FlatSolid | BentSolid | PrismSolid) -> None:
    for name, frame in record.joints.items():
        bd.RigidJoint(name, shape, bd.Location(occt.make_location(frame)))


def _dress(shape: Any, made: Strip) -> None:
    shape.strip = made
    shape.label = made.label or "strip"
    shape.color = bd.Color(*sheet_color(made.sheet))
