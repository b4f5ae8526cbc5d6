"""Smoothing of a drawn curve, on request or if the outline of the strip would have steps or corners."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._values import require_record
from elastica_cad.errors import Angle, ElasticaError, FieldName, InputError, Length, Severity, note
from elastica_cad.geometry.fairing import Fairing, fair_curve, round_corners, usual_tolerance
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.tangent_healing import LARGEST_REMOVED_RAD
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.least_ratio import rod_of_request
from elastica_cad.mechanics.loads import (
    ExcessCurvature,
    NaturalCurvature,
    Supports,
    require_natural_curvature,
    require_supports,
)
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.theorem1 import (
    KINK_SHARE,
    curvature_jumps,
    measured_points,
    outlier_message,
    require_bendable,
)

LARGEST_SMOOTH = 1000.0
"""Largest distance that can be requested for smoothing, mm."""

SEEN = 1e-3
"""Smallest displacement by smoothing, mm, that is reported."""

STEP_SHARE = 0.02
"""Largest step of the width that remains, as a fraction of the width."""

PLACES, SEEN_SHARE = 401, 0.1
"""Number of stations at which curvatures with and without noise are compared, and limit of their difference.

The noise is reported if the difference exceeds this fraction of the largest curvature.
"""


@dataclass(frozen=True, eq=False)
class Smoothing:
    """A drawn curve and the smoothed curve that the strip takes instead.

    Attributes
    ----------
    smooth : float or None
        Requested largest distance between drawn and smoothed curve, mm. With None, the curve is smoothed only if
        the outline of the strip would have steps or corners.
    with_elements : bool
        True if elements hold the strip between its ends. Their forces need corners of the curvature, so corners
        alone are not smoothed.
    """

    drawn: PlaneCurve
    smooth: float | None = None
    supports: Supports | None = None
    natural_curvature: NaturalCurvature = 0.0
    with_elements: bool = False

    @cached_property
    def fairing(self) -> Fairing | None:
        """The smoothed curve, or None if the curve is not smoothed."""
        unbent = _unbent_ends(self.drawn, self.supports)
        if self.smooth is not None:
            return _smoothed(self.drawn, self.smooth, unbent) if self.smooth > 0 else None
        drawn = self.drawn
        jumps, kinks = curvature_jumps(
            drawn, drawn.breaks if drawn.seam is None else (drawn.seam, *drawn.breaks)
        )
        slight = np.inf if self.with_elements else KINK_SHARE
        # only an outline with steps or corners, but without straight pieces, is smoothed
        rough = (kinks > slight).any() or (jumps > STEP_SHARE).any()
        if not rough or any(zero.kind == "flat" for zero in drawn.curvature_zeros):
            return None
        try:
            fairing = fair_curve(self.drawn, usual_tolerance(self.drawn), unbent)
        except InputError:
            return None
        return fairing if self._is_as_good(fairing.curve) else None

    @cached_property
    def curve(self) -> PlaneCurve:
        """Curve that the strip takes: the smoothed curve if there is one, or the drawn curve."""
        if self.fairing is None:
            return self.drawn
        provenance, outlier = self.drawn.provenance, outlier_message(self.drawn)
        if provenance is not None:
            provenance = replace(provenance, measured=provenance.measured if outlier else None)
        return self.fairing.curve.drawn_as(provenance)

    @property
    def moved(self) -> float:
        """Largest distance between the drawn and the smoothed curve, mm."""
        return 0.0 if self.fairing is None else self.fairing.moved

    @property
    def healed(self) -> float:
        """Distance, mm, by which the file reader moved the curve to remove rounding errors of its tangents."""
        return 0.0 if self.drawn.provenance is None else self.drawn.provenance.healed

    @property
    def ratio_as_drawn(self) -> float | None:
        """Stiffness ratio of a strip without weight in the drawn curve, or None if there is no such strip."""
        return None if self._rod_as_drawn is None else self._rod_as_drawn.ratio

    @cached_property
    def _rod_as_drawn(self) -> Rod | None:
        return self._weightless_rod_on(self.drawn)

    def _weightless_rod_on(self, curve: PlaneCurve) -> Rod | None:
        try:
            return rod_of_request(
                RodRequest(curve, None, self.supports or Supports(), self.natural_curvature)
            )
        except ElasticaError:
            return None

    def _inflections(self, curve: PlaneCurve) -> int:
        return sum(zero.changes_sign for zero in ExcessCurvature(curve, self.natural_curvature).zeros)

    def _is_as_good(self, curve: PlaneCurve) -> bool:
        """Return True if a smoothed curve adds no inflection, and hardly increases the stiffness ratio."""
        if self._inflections(curve) > self._inflections(self.drawn):
            return False
        if self._rod_as_drawn is None:
            return True
        rod = self._weightless_rod_on(curve)
        # Smoothing of cubics often increases the ratio by 5 %. With a smaller factor, a strip would lose and regain
        # its corners while the curve is dragged.
        return rod is not None and rod.ratio < 1.1 * self._rod_as_drawn.ratio

    @property
    def change_by_noise(self) -> float:
        """Largest change of curvature if noisy points are smoothed, as a fraction of the largest curvature.

        The change is 0 for curves without measured points. It is also 0 for curves that no strip can take, because
        their error message mentions the noise.
        """
        points = measured_points(self.drawn)
        if points is None or not examine(self.drawn, self.supports or Supports()).realizable:
            return 0.0
        unsmoothed, smooth = (
            curve.sample(PLACES).curvature
            for curve in (self.drawn, round_corners(self.drawn, points.reach)[0])
        )
        largest = float(np.abs(smooth).max())
        return float(np.abs(unsmoothed - smooth).max()) / largest if largest else 0.0

    @property
    def noise(self) -> tuple[str, ...]:
        """Note on the effect of noise in the measured points on the widths; empty if the effect is small."""
        points = measured_points(self.drawn)
        if points is None or points.outlier or self.fairing is not None:
            return ()
        change = self.change_by_noise
        if change <= SEEN_SHARE:
            return ()
        return (note(
            "Noise of the points changes the curvature, and with it the widths, by {percent:.0f} %: "
            "{points}.",
            percent=100 * change, points=points.noise_message, severity="warning",
        ),)  # fmt: skip

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on displacements of the curve, and on noise that was not smoothed."""
        notes: list[str] = [*outlier_message(self.drawn)]
        if self.healed > SEEN:
            notes.append(note(
                "Corners of at most {angle:.0f}, at which pieces of the curve met, were rounded. This "
                "moved the curve by at most {far:.2g}.",
                angle=Angle(LARGEST_REMOVED_RAD), far=Length(self.healed),
            ))  # fmt: skip
        points = measured_points(self.drawn)
        if points is not None and self.fairing is not None:
            return (*notes, note(
                ("The points have noise of about {noise}, so the curve was smoothed; it is at most {far} "
                 "from the points."),
                noise=points.rounded_noise, far=Length(self.moved), severity="warning",
            ))  # fmt: skip
        notes += self.noise
        if self.fairing is not None:
            before = self.ratio_as_drawn
            # a cut has a tolerance of more than 0.1 mm
            severity: Severity = "warning" if self.moved > 0.1 else "note"
            notes.append(
                note(
                    "The curvature jumped or had a kink where pieces of the curve meet. Smoothing moved the curve "
                    "by at most {far:.2g}; a strip can take only the smoothed curve."
                    if before is None else
                    "The curvature jumped or had a kink where pieces of the curve meet. Smoothing moved the curve "
                    "by at most {far:.2g}; the drawn curve needs a stiffness ratio of {ratio:.3g}. Set {field} to "
                    "limit this.",
                    far=Length(self.moved), ratio=before, field=FieldName("smooth"), severity=severity,
                )
            )  # fmt: skip
        if self.fairing is not None and self.drawn.tangent_breaks:
            sharpest = max(abs(corner.angle) for corner in self.drawn.tangent_breaks)
            notes.append(note(
                "The smoothing also rounded corners of at most {angle:.2g}.",
                angle=Angle(sharpest), severity="warning",
            ))  # fmt: skip
        return tuple(notes)


def check_smooth(smooth: object) -> float | None:
    """Return the requested smoothing distance, mm, or None; raise InputError for other values."""
    if smooth is None:
        return None
    if isinstance(smooth, bool) or not isinstance(smooth, float | int | np.number):
        raise InputError(
            f"`smooth` is {smooth!r}: give a distance in mm, or 0 for no smoothing", where={"field": "smooth"}
        )
    if not 0 <= smooth <= LARGEST_SMOOTH:
        raise InputError(
            "{field} is {smooth}: give a distance from 0 to {largest_smooth:g}",
            field=FieldName("smooth"),
            smooth=smooth,
            largest_smooth=Length(LARGEST_SMOOTH),
            where={"field": "smooth"},
        )
    return float(smooth)


def smooth_curve(
    curve: PlaneCurve,
    smooth: float | None = None,
    *,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
) -> Smoothing:
    """Smooth a drawn curve if necessary, and return the drawn and the smoothed curve.

    By default a curve is smoothed if the width of the strip would have a step of more than 2 %, or if its edges
    would have corners. A step is caused by a jump of the curvature, or of its derivative at an inflection; a corner
    is caused by a jump of the derivative elsewhere. The curve moves by at most 0.1 mm and 5e-4 of its length. The
    curve is not smoothed if smoothing would add an inflection or increase the stiffness ratio by 10 % or more.

    Parameters
    ----------
    smooth : float, optional
        Largest distance by which the curve may move, mm; slight corners are rounded too. 0 keeps the curve as
        drawn.
    supports : Supports, optional
        Supports of the ends. At ends that are free to turn, a small curvature is removed.
    natural_curvature : float or RestCurvature
        Curvature of the unbent strip, 1/mm.

    Examples
    --------
    >>> pen = PlaneCurve(np.repeat([0.0, 1.0, 2.0], [4, 3, 4]),
    ...                  [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)], 3)
    >>> smoothing = smooth_curve(pen)
    >>> 0 < smoothing.moved <= 0.1, smooth_curve(pen, 0).moved, round(smoothing.ratio_as_drawn, 2)
    (True, 0.0, 1.63)
    """
    require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
    supports = None if supports is None else require_supports(supports)
    require_natural_curvature(natural_curvature)
    smoothing = Smoothing(curve, check_smooth(smooth), supports, natural_curvature)
    _ = smoothing.fairing  # raise errors here, not at the first use of the result
    return smoothing


def _unbent_ends(curve: PlaneCurve, supports: Supports | None) -> tuple[bool, bool]:
    """Return whether start and end must stay unbent: the end can turn, and is drawn almost straight."""
    if supports is None or all(end.angle for end in supports.ends):
        return False, False
    bent = np.abs(curve.curvature_at(np.array(curve.domain)))
    # below this fraction of the largest curvature, an end counts as straight
    little = bent <= 0.05 * np.abs(curve.survey.curvature).max()
    start, end = (bool(few and not support.angle) for few, support in zip(little, supports.ends, strict=True))
    return start, end


def _smoothed(curve: PlaneCurve, smooth: float, unbent: tuple[bool, bool]) -> Fairing:
    """Return the curve with rounded corners, and smoothed within the rest of `smooth`, mm.

    A curve fitted to points is already smooth.
    """
    rounded, moved = round_corners(curve, smooth)
    require_bendable(rounded)
    if measured_points(curve) is not None:
        return Fairing(rounded, moved, smooth)
    fairing = fair_curve(rounded, smooth - moved, unbent)
    return replace(fairing, moved=fairing.moved + moved, tolerance=smooth)
