"""A drawn curve as a strip is to take it: exactly, or made fair where that was asked for or a pen drew it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.geometry.curve_editing.fairing import Fairing, choose_tolerance, fair_curve, round_corners
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.arguments import require_supports
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.curvature_conditions import require_bendable
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium
from elastica_cad.mechanics.theorem1.verdict import measured_points, stray_point
from elastica_cad.refusals import Length, note

LARGEST_SMOOTH = 1000.0
"""Largest smoothing distance, mm."""

LITTLE_BEND_SHARE = 0.05
"""Curvature that counts as little bend, as a share of the largest."""

SEEN = 1e-3
"""Smallest move, mm, that is reported."""

PLACES, SEEN_SHARE = 401, 0.1
"""Places along a curve where curvature is compared, and the smallest change of it by noise that is reported."""


@dataclass(frozen=True, eq=False)
class Smoothing:
    """A drawn curve and the curve that is bent instead.

    Attributes
    ----------
    drawn : PlaneCurve
    curve : PlaneCurve
        The drawn one itself where nothing was moved.
    fairing : Fairing or None
        How it was made fair.
    supports : Supports
    """

    drawn: PlaneCurve
    curve: PlaneCurve
    fairing: Fairing | None = None
    supports: Supports | None = None

    @property
    def moved(self) -> float:
        """Largest distance between both curves, mm."""
        return 0.0 if self.fairing is None else self.fairing.moved

    @property
    def healed(self) -> float:
        """Distance, mm, by which the reader moved the curve to remove rounding errors from its tangents."""
        return 0.0 if self.drawn.provenance is None else self.drawn.provenance.healed

    @cached_property
    def ratio_as_drawn(self) -> float | None:
        """Stiffness ratio of the curve as drawn, clamped and without weight; None where no strip takes it."""
        from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

        try:
            return optimal_rod(self.drawn, supports=self.supports).ratio
        except ElasticaError:
            return None

    @property
    def change_by_noise(self) -> float:
        """Largest change of curvature when points that waver are smoothed, as a share of the largest; 0 for others.

        So of a curve that is refused: the refusal tells of the noise.
        """
        points = measured_points(self.drawn)
        if points is None or not _can_be_bent(self.drawn, self.supports):
            return 0.0
        drawn, smooth = (
            one.sample(PLACES).curvature for one in (self.drawn, round_corners(self.drawn, points.reach)[0])
        )
        largest = float(np.abs(smooth).max())
        return float(np.abs(drawn - smooth).max()) / largest if largest else 0.0

    @property
    def noise(self) -> tuple[str, ...]:
        """A sentence where points waver so much that it shows in the widths, and they were not smoothed."""
        points = measured_points(self.drawn)
        if points is None or points.stray or self.fairing is not None:
            return ()
        change = self.change_by_noise
        if change <= SEEN_SHARE:
            return ()
        return (note(
            "The curvature, and the widths with it, change by {percent:.0f} % when noise is taken out: {points}.",
            percent=100 * change, points=points.told, severity="warning",
        ),)  # fmt: skip

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences about what was moved, and about noise that was not."""
        found: list[str] = [*stray_point(self.drawn)]
        if self.healed > SEEN:
            found.append(note(
                "The digits of the file turn its tangents where pieces meet: put right, {far:.2g} at most.",
                far=Length(self.healed),
            ))  # fmt: skip
        points = measured_points(self.drawn)
        if points is not None and self.fairing is not None:
            return (*found, note(
                "The points waver by about {waver}: smoothed, {far} from them at most.",
                waver=points.shown, far=Length(self.moved), severity="warning",
            ))  # fmt: skip
        found += self.noise
        drawn = self.drawn.provenance
        if self.fairing is not None and drawn is not None and drawn.drawn == "poles":
            found.append(note(
                "A spline of degree {degree} would give the strip kinks: made fair, {far:.2g} from the drawn curve "
                "at most.",
                degree=self.drawn.degree, far=Length(self.moved),
            ))  # fmt: skip
        elif self.fairing is not None:
            before = self.ratio_as_drawn
            ratio = (
                note("as drawn no strip takes it")
                if before is None
                else note("the stiffness ratio as drawn was {ratio:.3g}", ratio=before)
            )
            found.append(note(
                "The curvature jumped where pieces meet: made fair, {far:.2g} from the drawn curve "
                "at most; {before} (smooth = 0, --smooth 0, takes it as drawn, a larger number "
                "makes it fairer).",
                far=Length(self.moved), before=ratio, severity="warning",
            ))  # fmt: skip
        if self.fairing is not None and self.drawn.tangent_breaks:
            sharpest = max(np.degrees(abs(corner.angle)) for corner in self.drawn.tangent_breaks)
            found.append(note(
                "Its corners, of {angle:.2g} degrees at most, were rounded within that.",
                angle=sharpest, severity="warning",
            ))  # fmt: skip
        return tuple(found)


def check_smooth(smooth: object) -> float | None:
    """The distance in mm that fairing may move a curve by, 0 for none; None leaves it to the curve.

    Raises
    ------
    InputError
        What is no such number.
    """
    if smooth is None:
        return None
    if isinstance(smooth, bool) or not isinstance(smooth, float | int | np.number):
        raise InputError(
            "smooth is {smooth!r}: give a distance in mm, 0 for none, or None",
            smooth=smooth,
            where={"field": "smooth"},
        )
    if not 0 <= smooth <= LARGEST_SMOOTH:
        raise InputError(
            "smooth is {smooth}: a curve is made fair within 0 (not at all) to {largest_smooth:g}",
            smooth=smooth,
            largest_smooth=Length(LARGEST_SMOOTH),
            where={"field": "smooth"},
        )
    return float(smooth)


def smooth_curve(
    curve: PlaneCurve, smooth: float | None = None, *, supports: Supports | None = None
) -> Smoothing:
    """The curve to be bent instead of a drawn one.

    Parameters
    ----------
    smooth : float, optional
        0: exactly the drawn one; more: fair within so many mm, slight corners rounded; None: only a curve of a
        pen tool whose curvature jumps is moved (see `choose_tolerance`), and only where it can be bent afterwards
        if it could before.
    supports : Supports, optional
        What holds the ends. Those that are free to turn and drawn with little bend come out unbent.

    Raises
    ------
    InputError
        When it was asked for and cannot be done.

    Examples
    --------
    >>> pen = PlaneCurve(np.repeat([0.0, 1.0, 2.0], [4, 3, 4]),
    ...                  [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)], 3)
    >>> smooth_curve(pen).moved, round(smooth_curve(pen, 0.1).ratio_as_drawn, 2)
    (0.0, 1.63)
    """
    require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
    smooth, supports = check_smooth(smooth), None if supports is None else require_supports(supports)
    unbent = _unbent_ends(curve, supports)
    if smooth is not None:
        return _with(curve, _faired(curve, smooth, unbent) if smooth > 0 else None, supports)
    tolerance = choose_tolerance(curve)
    if tolerance == 0:
        return _with(curve, None, supports)
    try:
        fairing: Fairing | None = fair_curve(curve, tolerance, unbent)
    except InputError:
        return _with(curve, None, supports)
    if fairing and _can_be_bent(curve, supports) and not _can_be_bent(fairing.curve, supports):
        fairing = None
    return _with(curve, fairing, supports)


def _unbent_ends(curve: PlaneCurve, supports: Supports | None) -> tuple[bool, bool]:
    """Which ends are free to turn and drawn with little bend: no strip is bent there, so they mean none."""
    if supports is None or all(end.angle for end in supports.ends):
        return False, False
    bent = np.abs(curve.curvature_at(np.array(curve.domain)))
    little = bent <= LITTLE_BEND_SHARE * np.abs(curve.survey.curvature).max()
    start, end = (bool(few and not one.angle) for few, one in zip(little, supports.ends, strict=True))
    return start, end


def _faired(curve: PlaneCurve, smooth: float, unbent: tuple[bool, bool]) -> Fairing:
    """Fair within so many mm, slight corners rounded."""
    rounded, moved = round_corners(curve, smooth)
    require_bendable(rounded)
    if measured_points(curve) is not None:  # fitted anew, which is fair
        return Fairing(rounded, moved, smooth)
    fairing = fair_curve(rounded, smooth - moved, unbent)
    return replace(fairing, moved=fairing.moved + moved, tolerance=smooth)


def _can_be_bent(curve: PlaneCurve, supports: Supports | None) -> bool:
    return check_equilibrium(curve, supports).realizable


def _with(curve: PlaneCurve, fairing: Fairing | None, supports: Supports | None) -> Smoothing:
    if fairing is None:
        return Smoothing(curve, curve, None, supports)
    drawn, stray = curve.provenance, stray_point(curve)
    if drawn is not None:  # a point that stands out does so for all that is made of it
        drawn = replace(drawn, drawn="exact", measured=drawn.measured if stray else None)
    fair = fairing.curve.drawn_as(drawn)
    return Smoothing(curve, fair, fairing, supports)
