"""The table of a design file for a surface of revolution: its meridian, strips and rings, and tested changes if
these cannot be made.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil
from typing import Annotated, Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, Pair
from elastica_cad.declared import TWO_TURNS_RAD, Option
from elastica_cad.defaults import BORDER
from elastica_cad.design.records import Reader
from elastica_cad.design.tables import Table
from elastica_cad.errors import (
    Either,
    FieldName,
    InputError,
    Length,
    Listed,
    NotConvergedError,
    Point,
    StrainError,
    ended,
    note,
    sentences,
)
from elastica_cad.form_finding.fairing_request import smooth_curve
from elastica_cad.form_finding.meridians import Meridian, meridian, meridian_through
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.elements import PointForce
from elastica_cad.mechanics.loads import Gravity, PointMass
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.held_tabs import tab_seats
from elastica_cad.model.model import Model
from elastica_cad.model.plate_holes import PlateHoles
from elastica_cad.model.revolution_model import revolve, revolved_strip
from elastica_cad.model.spacers import Spacers
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip_spec import GravityOption
from elastica_cad.strip.styles import PLAIN, Style
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits

TESTED_COUNTS = 6
"""Smaller numbers of strips, at equal steps down to half the requested number, that are tested then."""


@dataclass(frozen=True)
class RevolutionTable:
    """The table `revolution`: a surface of revolution, made of strips and rings."""

    sheet: Annotated[Sheet, Option("Sheet of the strips.")]
    points: Annotated[
        tuple[Pair, ...], Option("Points of the meridian as [distance from the axis, height].", "mm")
    ] = ()
    curve: Annotated[
        PlaneCurve | None, Option("Profile that the meridian approximates, instead of points.")
    ] = None
    axis: Annotated[
        PlaneCurve | None,
        Option(
            "Straight line that is the axis of the profile, such as a curve of the same file by its id.",
            needs="curve",
            replaces=("axis_x",),
        ),
    ] = None
    axis_x: Annotated[
        float | None,
        Option(
            "Position x of the upright axis in the drawing of the profile; 0 by default.", "mm", needs="curve"
        ),
    ] = None
    a: Annotated[
        float | None, Option("Moment at the origin divided by stiffness and distance, instead of points.")
    ] = None
    b: Annotated[Pair | None, Option("Change of this value along the meridian.", "1/mm", needs="a")] = None
    start: Annotated[Pair | None, Option("Start of the meridian.", "mm", needs="a")] = None
    angle: Annotated[
        float | None,
        Option(
            "Angle of the tangent at the start.", "rad", least=-TWO_TURNS_RAD, most=TWO_TURNS_RAD, needs="a"
        ),
    ] = None
    length: Annotated[
        float | None,
        Option("Length of the meridian; points and profiles are scaled to it.", "mm", above=0),
    ] = None
    smooth: Annotated[
        float | None,
        Option(
            "Largest distance by which smoothing may move the profile; 0 keeps it as drawn.",
            "mm",
            least=0,
            needs="curve",
        ),
    ] = None
    ring: Annotated[float | None, Option("Distance of its end from the axis.", "mm", least=0)] = None
    strips: Annotated[int, Option("Number of strips.", least=3, most=1000)] = 16
    thickness: Annotated[
        float | None, Option("Thickness of the sheet, if it differs from the listed one.", "mm", least=0)
    ] = None
    rings: Annotated[Sheet | None, Option("Sheet of the rings at both ends.")] = None
    gap: Annotated[
        float | None, Option("Distance between two rings at each end.", "mm", least=0, needs="rings")
    ] = None
    spacers: Spacers = None
    border: Annotated[
        float,
        Option(
            "Least distance of the slots for strips from the edge.", "mm", least=0, most=1000, needs="rings"
        ),
    ] = BORDER
    holes: Annotated[
        PlateHoles | None, Option("Holes of the rings for a lamp holder and screws.", needs="rings")
    ] = None
    ends: Annotated[
        tuple[Tab, Tab] | None,
        Option("Tab for both ends, or one for the start and one for the end.", written=Tab | tuple[Tab, Tab]),
    ] = None
    style: Annotated[
        Style, Option("Style; the width of its outline is the width of the touching strips.")
    ] = PLAIN
    engrave: Annotated[str | None, Option("Text engraved on each strip.", most=200)] = None
    compensate: Annotated[
        bool, Option("Correct the widths for narrow tabs and curling; the strips then leave gaps.")
    ] = False
    creep: Annotated[float, Option("Long-term creep factor of the sheet; 0 for no creep.", least=0)] = 0.0
    gravity: Annotated[
        GravityOption,
        Option(
            "Weight of the strips: true, or the direction of gravity along the axis.",
            written=bool | tuple[float, float, float] | tuple[float, float] | Gravity,
        ),
    ] = None
    loads: Annotated[
        tuple[PointMass | PointForce, ...],
        Option("Masses and forces on each strip; x is away from the axis, and y is the height."),
    ] = ()
    shop: Annotated[FabricationLimits, Option("Limits of the workshop.")] = DEFAULT_LIMITS
    ignore_limits: Annotated[
        bool, Option("Make strips beyond the limits of the workshop, with a warning.")
    ] = False

    def __post_init__(self) -> None:
        if not self.gravity and any(isinstance(load, PointMass) for load in self.loads):
            raise InputError(
                "A point mass needs gravity in the plane of the curve. Set {gravity}.",
                gravity=FieldName("gravity"),
                where={"field": "gravity"},
            )
        if self.creep and any(isinstance(load, PointForce) for load in self.loads):
            raise InputError(
                "Rails, pins, ties and point forces cannot be combined with {what}. Leave out {field}, or these "
                "elements.",
                what=note("creep"),
                field=FieldName("creep"),
                where={"field": ("creep", "loads")},
            )

    @cached_property
    def meridian(self) -> Meridian:
        """The meridian, from points, a profile or an equation."""
        ways = [form for form in ("points", "curve", "a") if getattr(self, form) not in (None, ())]
        if len(ways) != 1:
            raise InputError(
                "The meridian is missing. Add one of the keys 'points' and 'curve', or the keys {own_keys}.",
                own_keys=", ".join(EQUATION_KEYS),
            )
        profile: PlaneCurve | FloatArray = self._profile or np.array(self.points)
        if self.smooth and isinstance(profile, PlaneCurve):
            profile = smooth_curve(profile, self.smooth).curve
        if self.length is not None and self.a is None:
            profile = _scaled(profile, self.length / meridian_through(profile).curve.length)
        if self.a is None:
            return meridian_through(profile, ring=self.ring)
        values: Any = [getattr(self, key) for key in EQUATION_KEYS]
        missing = [key for key in EQUATION_KEYS if getattr(self, key) is None]
        if missing:
            raise InputError("{key} is missing. Add a number or a formula in quotes.", key=missing[0])
        return meridian(*values, ring=self.ring)

    @property
    def _profile(self) -> PlaneCurve | None:
        """Profile with x as the distance from the axis and y along the axis, or None."""
        if self.curve is None or (self.axis is None and self.axis_x is None):
            return self.curve
        if self.axis is None:
            start, end = np.array([[self.axis_x, 0.0], [self.axis_x, 1.0]])
        elif self.axis.is_straight and not self.axis.is_closed:
            start, end = self.axis.control_points[[0, -1]]
        else:
            raise InputError(
                "The curve of the key 'axis' is not straight. Draw the axis as one straight line."
            )
        along = (end - start) / np.hypot(*(end - start)) * (1.0 if end[1] >= start[1] else -1.0)
        across = -left_of(along)
        # the profile is on the positive side of the axis
        if across @ (self.curve.control_points.mean(axis=0) - start) < 0:
            across = -across
        return self.curve.transformed([[*across, -across @ start], [*along, 0.0], [0.0, 0.0, 1.0]])

    def model(self, name: str) -> Model:
        """Make all strips and rings. An error suggests tested changes with which they can be made."""
        try:
            return self._model(name)
        except InputError as problem:
            # errors about these fields already state the change that helps
            fixed = problem.refusal.where.get("field") in ("style.width", "gravity", "loads")
            if fixed or self.rings is None or self.meridian.at_pole or self._breaks_without_tabs:
                raise
            tested = [*self._without_ends(), *self._larger_openings(), *self._fewer_strips()]
            if not tested:
                raise
            # `tested` has pairs of a tested change and the instruction that worked, or ""
            edits = Either(edit for _, edit in tested if edit)
            text = (
                "{problem} A tested change makes strips and rings possible: {edits}."
                if edits
                else "{problem} These changes were tested, but none of them alone makes strips and rings "
                "possible within the strain limit: {tested}."
            )
            found, names = problem.refusal, sentences(name for name, _ in tested)
            raise type(problem)(
                text, problem=ended(found), edits=edits, tested=names, kind=found.kind, where=found.where
            ) from problem

    @property
    def _breaks_without_tabs(self) -> bool:
        # other rings or tabs cannot help strips whose strain is too large without them
        strips = replace(self, rings=None, gap=None, spacers=None, holes=None, ends=(Tab(0.0), Tab(0.0)))
        try:
            strips._model("")
        except InputError as problem:
            return isinstance(problem, StrainError)
        return False

    def _without_ends(self) -> Iterator[tuple[str, str]]:
        if self.ends is not None:
            edit = note("leave out {field}", field=FieldName("ends"))
            yield note("tabs of the default size"), edit if self._works(ends=None) else ""

    def _larger_openings(self) -> Iterator[tuple[str, str]]:
        """Yield the change that moves one end point of the meridian, or both, away from the axis."""
        points, widest = self.points, max((x for x, _ in self.points), default=0.0)

        def moved(ends: tuple[int, ...], step: int) -> tuple[Pair, ...]:
            places = [*points]
            for k in ends:
                places[k] = (points[k][0] + step, points[k][1])
            return tuple(places)

        def works(ends: tuple[int, ...], step: int) -> bool:
            return self._works(points=moved(ends, step))

        # increases of the radius of both openings, mm
        steps = [
            step for step in (4, 16, 32) if points and points[0][0] + step < widest > points[-1][0] + step
        ]
        if not steps:
            return
        tested = note("openings larger by {steps} in radius", steps=Listed(map(Length, steps)))
        enough = next((step for step in steps if works((0, -1), step)), None)
        if enough is None:
            yield tested, ""
            return
        # move a single end if that is enough, and bisect for the least whole number of mm
        ends = next((one for one in ((0,), (-1,)) if works(one, enough)), (0, -1))
        too_small = 0
        while enough - too_small > 1:
            middle = (enough + too_small) // 2
            enough, too_small = (middle, too_small) if works(ends, middle) else (enough, middle)
        yield (
            tested,
            note(
                "move the point {olds} of the meridian to {news}"
                if len(ends) == 1
                else "move the points {olds} of the meridian to {news}",
                olds=Listed(Point(points[k]) for k in ends),
                news=Listed(Point(moved(ends, enough)[k]) for k in ends),
            ),
        )

    def _fewer_strips(self) -> Iterator[tuple[str, str]]:
        """Yield the numbers of strips that were tried, and the change to the largest that works, or ""."""
        step = ceil(self.strips / (2 * TESTED_COUNTS))
        counts = [count for k in range(1, TESTED_COUNTS + 1) if (count := self.strips - k * step) >= 3]
        works = next((count for count in counts if self._works(strips=count)), None)
        if works is not None:  # between the steps, a smaller change may be enough
            more = range(works + step - 1, works, -1)[:TESTED_COUNTS]
            works = next((count for count in more if self._works(strips=count)), works)
        if counts:
            edit = "" if works is None else note("use {count} strips", count=works)
            yield note("{counts} strips", counts=Listed(counts)), edit

    def _works(self, **changes: Any) -> bool:
        """Return True if strips and rings can be made with these changes, and no tab rocks between two rings.

        The strain must be within its limit, unless it exceeds the limit also without the changes.
        """
        changed = replace(self, **changes)
        try:
            model = changed._model("")
            rocks = self.gap is not None and any(seat.rocks for seat in tab_seats(model.plates).values())
            allowed = model.placed[0].strip.strain_verdict.allowed
            return not rocks and (allowed or not self._is_within_limit)
        except (InputError, NotConvergedError):
            return False

    @cached_property
    def _is_within_limit(self) -> bool:
        """True if the strain of the strips is within its limit, or no strip can be made."""
        try:
            strip = revolved_strip(self.meridian, self.strips, **self._strip_options)
        except InputError:
            return True
        return strip.strain_verdict.allowed

    @property
    def _strip_options(self) -> dict[str, Any]:
        keys = (
            "sheet", "ends", "rings", "gap", "shop", "style", "engrave", "compensate", "creep", "gravity", "loads",
        )  # fmt: skip
        return {key: getattr(self, key) for key in keys}

    def _model(self, name: str) -> Model:
        return revolve(
            self.meridian,
            self.strips,
            spacers=self.spacers,
            border=self.border,
            holes=self.holes,
            name=name,
            ignore_limits=self.ignore_limits,
            **self._strip_options,
        )

    @property
    def reports(self) -> tuple[str, ...]:
        """Messages on an assumed axis, and on a meridian that deviates from its points or curve."""
        reports = []
        if self.curve is not None and self.axis is None and self.axis_x is None:
            width = Length(2 * float(self.meridian.curve.bounds[1, 0]))
            reports.append(note(
                "The axis is x = 0 of the drawing, so the surface is {width} wide. "
                "If the axis is elsewhere, set the key 'axis' or 'axis_x'.",
                width=width,
            ))  # fmt: skip
        # a smaller deviation, in mm or as a fraction of the length, is not visible
        if self.meridian.deviation > min(0.05, 1e-3 * self.meridian.curve.length):
            reports.append(note(
                "The meridian deviates by up to {far} from its points, because strips cannot cover the "
                "surface of a closer curve without gaps."
                if self.points
                else "The meridian deviates by up to {far} from the drawn curve, because strips cannot cover the "
                "surface of a closer curve without gaps.",
                far=Length(self.meridian.deviation),
            ))  # fmt: skip
        return tuple(reports)


def _scaled(profile: PlaneCurve | FloatArray, factor: float) -> PlaneCurve | FloatArray:
    """Enlarge a profile about the point of the axis at the height of its start."""
    points = profile.control_points if isinstance(profile, PlaneCurve) else profile
    raised = (1 - factor) * points[0, 1]
    if isinstance(profile, PlaneCurve):
        return profile.transformed([[factor, 0, 0], [0, factor, raised], [0, 0, 1]])
    return np.asarray(factor * profile + np.array([0, raised]), dtype=float)


EQUATION_KEYS = ("a", "b", "start", "angle", "length")
"""Keys of a meridian that is defined by its equation."""


def read_revolution(table: Table, reader: Reader) -> RevolutionTable:
    """Read the surface of revolution that the table `revolution` requests."""
    revolution: RevolutionTable = reader.record(RevolutionTable, table)
    try:
        with table.naming():
            _ = revolution.meridian
    except NotConvergedError as problem:
        raise NotConvergedError("{place}: {problem}", place=table.where, problem=problem) from problem
    return revolution
