"""The strip of a curve drawn in a CAD kernel, given as numbers, or made before; and what its bodies tell."""

import sys
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from difflib import get_close_matches
from functools import lru_cache
from math import hypot
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias, TypedDict

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad.errors import InputError
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.solids.self_contact import self_contact
from elastica_cad.fabrication.solids.smooth_pieces import in_smooth_pieces
from elastica_cad.fabrication.solids.strip_solids import BentSolid, bent_sheets
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.styles import Style
from elastica_cad.fabrication.strip.tabs import Tab
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.drawn_edges import plane_curve
from elastica_cad.kernel.occt import Shape, make_face, make_solid
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

# what solves and holds strips is imported when it is asked for: a skin is then there soon after its library
if TYPE_CHECKING:
    from elastica_cad.fabrication.asked_gravity import AskedGravity
    from elastica_cad.fabrication.holders.end_fixtures import EndFixture
    from elastica_cad.fabrication.makeability.shop import Shop
    from elastica_cad.fabrication.strip_spec import StripSpec
    from elastica_cad.forming.limits import Keep, Limits
    from elastica_cad.forming.plane_sections.section_curves import SectionCurve

End: TypeAlias = Literal["start", "end"]

LIBRARIES = ("elastica_cad", "build123d", "cadquery")
"""Between the user's line and what goes wrong."""

OFF_PLANE_MM = 1e-4
"""How far a point given in space may lie off the curve's plane."""

KEPT_REQUESTS = 64  # requests whose strips are kept: a few models' worth
FIXTURE_SIZES = ("clearance", "wall", "foot", "foot_height", "screw")
OF_STYLES = {
    "backing": "style=Laminated(width=..., backing=...)",
    "columns": "style=Perforated(width=..., columns=...)",
    "rows": "style=Perforated(width=..., rows=...)",
    "width": "max_width=..., or style=Perforated(width=...)",
}


class StripWarning(UserWarning):
    """Strips can be made, but not bent as they are: strained beyond their sheet's limit, or through each other."""


class UnknownOptionError(InputError, TypeError):
    """An option that no strip has, as Python itself refuses unknown arguments."""


class StripOptions(TypedDict, total=False):
    """What every skin takes besides path, sheet and max_width; see `StripSpec`.

    `plane` is the plane of the curve, its z axis to the strip's upper edge: a plane of the library, or a `Frame`.
    A single `Tab` stands for both ends, a single `Slot` for a sequence of one.
    """

    plane: Any
    min_width: float | None
    style: Style
    limits: "Limits | None"
    keep: "Keep | None"
    gravity: "AskedGravity"
    loads: Sequence[PointMass] | Weight
    supports: Supports
    natural_curvature: float
    samples: int | None
    smooth: float | None
    ends: Tab | Sequence[Tab]
    joint: float | None
    slots: Slot | Sequence[Slot]
    label: str
    shop: "Shop"
    compensate: bool | None
    creep: float
    law: BoundedLaw | None
    anyway: bool


class FixtureOptions(StripOptions, total=False):
    """The sizes of an end fixture too, mm; see `fabrication.EndFixture`."""

    clearance: float
    wall: float
    foot: float
    foot_height: float
    screw: float


class TupleLike(Protocol):
    """A vector of CadQuery."""

    def toTuple(self) -> tuple[float, float, float]:  # noqa: D102
        ...


Point: TypeAlias = Iterable[float] | TupleLike
"""In space, or two numbers in the frame of a body, mm."""


class BendOptions(TypedDict, total=False):
    """Where the ends of a strip are led, as in `mechanics.bend`.

    `start` and `end` are points in space (three numbers, a vector of the library), or two numbers in the body's
    `frame`, mm; `angles` are rad in that frame, None where an end is to turn freely.
    """

    start: "Point | None"
    end: "Point | None"
    angles: "tuple[float | None, float | None] | ArrayLike | None"
    gravity: Any
    supports: Supports | None
    force: ArrayLike | None
    moment: float | tuple[float, float] | None
    guess: Any
    side: int | None
    mode: int
    samples: int | None
    settle: bool


@dataclass(frozen=True, eq=False)
class MadeStrip:
    """A strip and where it lies; copies of a shape share it.

    Attributes
    ----------
    strip : Strip
    frame : Frame
        The plane of its curve.
    deviation : float
        How far limits moved the strip off the drawn curve, mm.
    home : Frame or None
        The joint "start" as it was made of a body that stands on the curve; None for others.
    """

    strip: Strip
    frame: Frame
    deviation: float = 0.0
    home: Frame | None = None

    def __deepcopy__(self, memo: dict[int, Any]) -> "MadeStrip":
        return self

    def mirrored(self) -> "MadeStrip":
        """That of a body's image: across, the strip is the other way round."""
        return replace(self, strip=self.strip.mirrored())

    @property
    def face(self) -> Shape:
        """The flat pattern as a TopoDS_Face."""
        outline, *holes = (in_smooth_pieces(loop) for loop in (self.strip.outline, *self.strip.holes))
        return make_face(outline, holes)


class StripBody:
    """What a body of a strip tells about it, in every kernel."""

    _made: MadeStrip

    def _start(self) -> Frame | None:
        """Where the joint "start" lies now; None where the body has none."""
        raise NotImplementedError

    @property
    def strip(self) -> Strip:
        """The strip: widths, outline, strain, mass."""
        return self._made.strip

    @property
    def deviation(self) -> float:
        """How far limits moved the strip off the drawn curve, mm."""
        return self._made.deviation

    @property
    def frame(self) -> Frame:
        """The plane in which the curve of the bent strip lies: moved with a bent body, as drawn for others."""
        home, now = self._made.home, self._start()
        return self._made.frame if home is None or now is None else self._made.frame.carried(home, now)

    @property
    def rod(self) -> Rod:
        """The bent rod: shape, stiffness, moment, force."""
        return self.strip.rod

    @property
    def check(self) -> EquilibriumCheck | None:
        """The verdict of Theorem 1 on the drawn curve, where one was asked for."""
        return self.rod.check

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a maker should know before cutting."""
        return self.strip.warnings

    @property
    def placed(self) -> Placed:
        """The strip in its place, for `Model`."""
        frame = self.frame
        return Placed(self.strip, frame.origin, frame.x_axis, frame.y_axis)

    def _bent_anew(self, moved: BendOptions) -> Strip:
        """The strip with its ends led elsewhere; what it then suffers is told."""
        _refuse_others(moved, BendOptions, "bending a strip")
        led: dict[str, Any] = dict(moved)
        for name in ("start", "end"):
            if led.get(name) is not None:
                led[name] = self._in_plane(led[name], name)
        strip = replace(self.strip, rod=bend(self.rod, **led))
        _warn_of_strain(strip)
        return strip

    def _in_plane(self, point: Point, name: str) -> tuple[float, ...]:
        """A point in space in the plane of the curve; two numbers are taken as they are."""
        try:
            numbers: Any = point.toTuple() if hasattr(point, "toTuple") else point
            row = tuple(map(float, numbers))
        except (TypeError, ValueError):
            row = ()
        if len(row) == 2:
            return row
        if len(row) != 3:
            raise InputError(
                f"{name} is {point!r}: give a point in space, or two numbers in the strip's frame, mm"
            )
        x, y, z = self.frame.local(row).tolist()
        if abs(z) > OFF_PLANE_MM * max(1.0, hypot(x, y) / 100):
            raise InputError(
                f"{name} lies {abs(z):.4g} mm off the plane in which the strip bends: give a point in it"
            )
        return x, y

    def _layers(self) -> Iterator[tuple[Shape, str, Sheet]]:
        """The bent sheets, the base first: TopoDS_Solid, name, material."""
        from elastica_cad.fabrication.model.assembly import bent_names

        names = bent_names(self.strip.label or "strip", self.strip)
        records = BentSolid.layers(self.strip, self.frame)
        for record, name, sheet in zip(records, names, bent_sheets(self.strip), strict=True):
            yield make_solid(record), name, sheet

    def _require_backing(self) -> None:
        if len(self.strip.layers) == 1:
            raise InputError("the strip has no backing: give style=Laminated(width=..., backing=...)")


def make_strip_on(
    path: Any, sheet: Sheet | str | None = None, *, workplane: Any = None, **asked: Any
) -> MadeStrip:
    """The strip that `StripSpec` makes of a path; equal requests share it.

    Parameters
    ----------
    path : PlaneCurve, edges and wires of a kernel, a Strip, or a body of one
        The plane of drawn edges is found; that of a `PlaneCurve` or `Strip` is xy, or `plane`.
    sheet : Sheet or str
        None with a strip, which has one.
    workplane : Frame, or a plane of build123d or CadQuery, optional
        What the path was drawn on; its side is taken where the path lies in it or beside it.
    **asked
        `StripOptions`, and `max_width`.

    Raises
    ------
    InputError
        Edges that are no smooth, plane curve, or lie in another plane; options that are not known, or that
        come too late for a strip that is made; and as `StripSpec.make`.
    """
    from elastica_cad.fabrication.strip_checks import told_in_python
    from elastica_cad.fabrication.strip_spec import StripSpec

    asked = {name: value for name, value in asked.items() if value is not None}
    _refuse_unknown(asked)
    frame = _frame_of(asked.pop("plane")) if "plane" in asked else None
    if isinstance(path, Strip | StripBody):
        late = [*(("sheet",) if sheet is not None else ()), *asked]
        if late:
            raise InputError(
                f"{', '.join(late)} cannot be given for a strip that is made: leave out, or give the curve"
            )
        if isinstance(path, Strip):
            _warn_of_contact(path)
            return MadeStrip(path, frame or Frame())
        return MadeStrip(path.strip, frame or path.frame, path.deviation)
    if sheet is None:
        raise InputError(
            'a curve needs a sheet to be cut from: give a Sheet or the name of one, like "mdf-3"'
        )
    for name, kind in (("ends", Tab), ("slots", Slot)):
        if isinstance(asked.get(name), kind):
            asked[name] = (asked[name],) * (2 if name == "ends" else 1)
    if isinstance(path, PlaneCurve):
        curve, frame = path, frame or Frame()
    else:
        drawn_on = None if workplane is None else _frame_of(workplane).axes.T
        curve, frame = plane_curve(path, frame, turned=drawn_on)
    spec = StripSpec(curve, sheet, frame, **asked)
    with told_in_python(spec.curve, spec.may_change):
        strip, deviation = _made(spec)
    _warn_of_strain(strip)
    _warn_of_contact(strip)
    return MadeStrip(strip, frame, deviation)


def image_of(frame: Frame, mirror: Frame) -> Frame:
    """The mirror image of a frame in the xy plane of another: x and z are kept, as frames are right-handed."""
    n = mirror.z_axis
    x, z = (axis - 2 * (axis @ n) * n for axis in (frame.x_axis, frame.z_axis))
    return Frame(frame.origin - 2 * ((frame.origin - mirror.origin) @ n) * n, x, np.cross(z, x))


def make_fixture_on(
    path: Any,
    sheet: Sheet | str | None = None,
    *,
    end: End = "start",
    floor: Any = None,
    number: str | None = None,
    **asked: Any,
) -> "tuple[MadeStrip, EndFixture]":
    """The block that holds an end of the strip that `make_strip_on` makes, and that strip.

    `floor` is a plane of any library, `asked` as `FixtureOptions`; errors as of `EndFixture` and `make_strip_on`.
    """
    from elastica_cad.fabrication.holders.end_fixtures import EndFixture

    sizes = {name: asked.pop(name) for name in FIXTURE_SIZES if name in asked}
    _refuse_unknown(asked, FIXTURE_SIZES)
    made = make_strip_on(path, sheet, **asked)
    ground = None if floor is None else _frame_of(floor)
    number = None if number is None else str(number)
    return made, EndFixture.of(made.strip, end, made.frame, floor=ground, number=number, **sizes)


def curves_on_body(body: Any, planes: Any, *, half: bool = False) -> "tuple[SectionCurve, ...]":
    """The curves in which planes cut a face or a body of a kernel, each with its plane in space.

    `planes` are planes of any library, or a `SectionSpec`; `half` keeps what lies on the side of their x axes. What
    is left out is told by a warning.

    Raises
    ------
    InputError
        No faces, or no section that a strip could follow.
    """
    from elastica_cad.forming.plane_sections.section_spec import GivenCuts, SectionSpec
    from elastica_cad.kernel.shape_sections import shape_surface

    if not isinstance(planes, SectionSpec):
        alone = isinstance(planes, Frame | str) or not isinstance(planes, Iterable)
        rows = (planes,) if alone else planes
        planes = SectionSpec(GivenCuts(tuple(map(_frame_of, rows))), half=half)
    curves, reports = planes.curves(shape_surface(getattr(body, "wrapped", body)))
    for text in reports:
        _warn(text)
    found: tuple[SectionCurve, ...] = curves
    return found


def warn_of_missing_slots(placed: Sequence[Placed]) -> None:
    """Tell of strips of a model that run through each other."""
    from elastica_cad.fabrication.interlocking.missing_slots import missing_slots

    for text in missing_slots(placed):
        _warn(text)


@lru_cache(maxsize=KEPT_REQUESTS)
def _made(spec: "StripSpec") -> tuple[Strip, float]:
    """The strip and its deviation."""
    from elastica_cad.forming.nearest.nearest_record import NearestRod

    found = spec.rod_spec.solve()
    return spec.make(found), found.deviation if isinstance(found, NearestRod) else 0.0


def _warn_of_strain(strip: Strip) -> None:
    """Tell of a strip that is strained beyond what its sheet takes."""
    if any(layer.exceeded for layer in strip.strains):
        _warn(next(text for text in strip.warnings if text.startswith("strain")))


def _warn(text: str) -> None:
    """Warn at the line of the user's script, however deep we are."""
    depth, caller = 2, sys._getframe(1)
    while caller.f_back is not None and str(caller.f_globals.get("__name__")).split(".")[0] in LIBRARIES:
        depth, caller = depth + 1, caller.f_back
    warnings.warn(text, StripWarning, stacklevel=depth)


def _warn_of_contact(strip: Strip) -> None:
    """Tell of a strip that meets itself when it is bent."""
    meeting = self_contact(strip)
    if meeting is not None:
        low, high = meeting
        _warn(
            f"bent, the strip runs through itself: {low:.1f} mm along it meets {high:.1f} mm (tabs lie below 0 "
            f"and beyond {strip.rod.length:.1f}); shorten the tabs, open the curve, or cut a slot there"
        )


def _refuse_others(asked: Mapping[str, Any], known: type, what: str) -> None:
    """Names that a dict of options does not have, with the nearest that it has."""
    names = sorted(known.__annotations__)
    for name in asked:
        if name not in names:
            near = get_close_matches(name, names, n=1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise UnknownOptionError(f"{name} is no option of {what}: {hint}")


def _refuse_unknown(asked: Mapping[str, Any], sizes: Sequence[str] = ()) -> None:
    """Names that are no options, with the nearest that is."""
    from elastica_cad.fabrication.strip_spec import StripSpec

    known = sorted(
        {"plane", *sizes, *(field.name for field in fields(StripSpec))} - {"curve", "sheet", "frame"}
    )
    for name in asked:
        if name in known:
            continue
        if name in OF_STYLES:
            raise UnknownOptionError(f"{name} is no option of a strip: give {OF_STYLES[name]}")
        near = get_close_matches(name, known, n=1)
        what = "a fixture" if sizes else "a strip"
        hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}"
        raise UnknownOptionError(f"{name} is no option of {what}: {hint}")


def _frame_of(plane: Any) -> Frame:
    """The frame of a plane of any library."""
    if isinstance(plane, Frame):
        return plane
    for names in (("origin", "x_dir", "y_dir"), ("origin", "xDir", "yDir")):
        if all(hasattr(plane, name) for name in names):
            axes: list[Any] = [getattr(plane, name) for name in names]
            rows = [axis.toTuple() if hasattr(axis, "toTuple") else tuple(axis) for axis in axes]
            return Frame(*rows)
    raise InputError(f"plane is {plane!r}: give a Plane of your library, or a Frame")
