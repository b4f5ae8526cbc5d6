"""The table of a design file for a surface of revolution: its meridian, strips and rings."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.declared import Option
from elastica_cad.defaults import BORDER
from elastica_cad.design.records import Reader
from elastica_cad.design.tables import Table
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.forming.meridians import Meridian, meridian, meridian_through
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.held_tabs import tab_seats
from elastica_cad.model.model import Model
from elastica_cad.model.plate_holes import PlateHoles
from elastica_cad.model.plates import Border
from elastica_cad.model.revolution_model import revolve
from elastica_cad.model.spacers import Spacers
from elastica_cad.refusals import Length, Point, Refusal, note
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits

Pair: TypeAlias = tuple[float, float]

OPENING_STEPS = (1, 2, 4, 8, 16)
"""Increases of the radius of an opening, mm, that are tested if the rings cannot be made."""

LARGEST_STEP_FRACTION = 0.3
"""Largest tested increase as a fraction of the radius."""

NEAR_MM, NEAR_SHARE = 0.05, 1e-3
"""Distances, in mm and as a fraction of the length. A meridian that deviates by less than both is not reported."""


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
        Option("Straight line that is the axis of the profile, such as a curve of the same file by its id."),
    ] = None
    axis_x: Annotated[
        float | None,
        Option("Position x of the upright axis in the drawing of the profile; 0 by default.", "mm"),
    ] = None
    a: Annotated[
        float | None, Option("Moment at the origin divided by stiffness and distance, instead of points.")
    ] = None
    b: Annotated[Pair | None, Option("Change of this value along the meridian.", "1/mm")] = None
    start: Annotated[Pair | None, Option("Start of the meridian.", "mm")] = None
    angle: Annotated[float | None, Option("Angle of the tangent at the start.", "rad")] = None
    length: Annotated[float | None, Option("Length of the meridian.", "mm", least=0)] = None
    ring: Annotated[float | None, Option("Distance of its end from the axis.", "mm", least=0)] = None
    strips: Annotated[int, Option("Number of strips.", least=3, most=1000)] = 16
    thickness: Annotated[
        float | None, Option("Thickness of the sheet, if it differs from the listed one.", "mm", least=0)
    ] = None
    rings: Annotated[Sheet | None, Option("Sheet of the rings at both ends.")] = None
    gap: Annotated[float | None, Option("Distance between two rings at each end.", "mm", least=0)] = None
    spacers: Spacers = None
    border: Border = BORDER
    holes: Annotated[PlateHoles | None, Option("Holes of the rings for a lamp holder and screws.")] = None
    ends: Annotated[
        tuple[Tab, Tab] | None,
        Option("Tab for both ends, or one for the start and one for the end.", written=Tab | tuple[Tab, Tab]),
    ] = None
    shop: Annotated[FabricationLimits, Option("Limits of the workshop.")] = DEFAULT_LIMITS
    ignore_limits: Annotated[
        bool, Option("Make strips beyond the limits of the workshop, with a warning.")
    ] = False

    @cached_property
    def meridian(self) -> Meridian:
        """The meridian, from points, a profile or an equation."""
        ways = [form for form in ("points", "curve", "a") if getattr(self, form) not in (None, ())]
        if len(ways) != 1:
            raise InputError(
                "The meridian is missing. Add one of the keys 'points' and 'curve', or the keys {own_keys}.",
                own_keys=", ".join(EQUATION_KEYS),
            )
        if self.curve is not None or self.points:
            return meridian_through(self._profile or list(self.points), ring=self.ring)
        values: Any = [getattr(self, key) for key in EQUATION_KEYS]
        missing = [key for key in EQUATION_KEYS if getattr(self, key) is None]
        if missing:
            raise InputError("{key} is missing. Add a number or a formula in quotes.", key=missing[0])
        return meridian(*values, ring=self.ring)

    @property
    def _profile(self) -> PlaneCurve | None:
        if self.axis is None and self.axis_x is None:
            return self.curve
        if self.curve is None:
            raise InputError("The keys 'axis' and 'axis_x' apply only to a profile. Set the key 'curve'.")
        if self.axis is not None and self.axis_x is not None:
            raise InputError("The keys 'axis' and 'axis_x' exclude each other. Leave out one of them.")
        start, end = (
            np.array([[self.axis_x, 0.0], [self.axis_x, 1.0]]) if self.axis is None else self._axis_ends
        )
        along = (end - start) / np.hypot(*(end - start)) * (1.0 if end[1] >= start[1] else -1.0)
        across = np.array([along[1], -along[0]])
        if across @ (self.curve.control_points.mean(axis=0) - start) < 0:
            across = -across
        return self.curve.transformed([[*across, -across @ start], [*along, 0.0], [0.0, 0.0, 1.0]])

    @property
    def _axis_ends(self) -> FloatArray:
        assert self.axis is not None
        if not self.axis.is_straight or self.axis.is_closed:
            raise InputError(
                "The curve of the key 'axis' is not straight. Draw the axis as one straight line."
            )
        return self.axis.control_points[[0, -1]]

    def model(self, name: str) -> Model:
        """Make all strips and rings. An error suggests a tested opening with which the rings can be made."""
        try:
            return self._model(name)
        except InputError as problem:
            if not _is_fault(problem.refusal) or (moved := self._larger_opening()) is None:
                raise
            old, new = moved
            raise InputError(
                "Move the point {old} of the meridian to {new}: the rings can then be made. {problem}",
                old=Point(old), new=Point(new), problem=problem.refusal,
            ) from problem  # fmt: skip

    def _larger_opening(self) -> tuple[Pair, Pair] | None:
        """Return an end point of the meridian, and the tested point farther from the axis with which rings fit."""
        if self.gap is None or not self.points or not replace(self, rings=None)._is_made:
            return None

        def moved(k: int, step: int) -> "RevolutionTable":
            points = [*self.points]
            points[k] = (points[k][0] + step, points[k][1])
            return replace(self, points=tuple(points))

        for step in OPENING_STEPS:
            for k in (0, -1):
                if step <= LARGEST_STEP_FRACTION * self.points[k][0] and moved(k, step)._is_made:
                    works = (moved(k, least) for least in range(step // 2 + 1, step + 1))
                    return self.points[k], next(table.points[k] for table in works if table._is_made)
        return None

    @property
    def _is_made(self) -> bool:
        """True if strips and rings can be made, and no tab rocks."""
        try:
            return not any(seat.rocks for seat in tab_seats(self._model("").plates).values())
        except (InputError, NotConvergedError):
            return False

    def _model(self, name: str) -> Model:
        return revolve(
            self.meridian,
            self.strips,
            sheet=self.sheet,
            ends=self.ends,
            rings=self.rings,
            gap=self.gap,
            spacers=self.spacers,
            border=self.border,
            holes=self.holes,
            name=name,
            shop=self.shop,
            ignore_limits=self.ignore_limits,
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
        if self.meridian.deviation > min(NEAR_MM, NEAR_SHARE * self.meridian.curve.length):
            reports.append(note(
                "The meridian deviates by up to {far} from its points, because strips cannot cover the "
                "surface of a closer curve without gaps."
                if self.points
                else "The meridian deviates by up to {far} from the drawn curve, because strips cannot cover the "
                "surface of a closer curve without gaps.",
                far=Length(self.meridian.deviation),
            ))  # fmt: skip
        return tuple(reports)


def _is_fault(refusal: Refusal) -> bool:
    """Return True if a message, or a message in its values, has the kind "fault".

    Such a message reports a part or a tab that cannot be made, and suggests no tested remedy.
    """
    inside = (value for value in refusal.values.values() if isinstance(value, Refusal))
    return refusal.kind == "fault" or any(map(_is_fault, inside))


EQUATION_KEYS = ("a", "b", "start", "angle", "length")
"""Keys of a meridian that is defined by its equation."""

INHERITED = ("sheet", "thickness", "ends", "shop", "ignore_limits")
"""Keys whose default values are the values at the top of the design file."""


def read_revolution(table: Table, reader: Reader) -> RevolutionTable:
    """Read the surface of revolution that the table `revolution` requests."""
    revolution: RevolutionTable = reader.record(RevolutionTable, table)
    try:
        with table.naming():
            _ = revolution.meridian
    except NotConvergedError as problem:
        raise NotConvergedError("{place}: {problem}", place=table.where, problem=problem) from problem
    return revolution
