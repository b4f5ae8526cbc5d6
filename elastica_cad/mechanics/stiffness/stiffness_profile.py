"""The stiffness of a drawn curve as a spline of arc length, of which its outline will be made."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials.panel_functions import (
    NODES,
    SLOPES,
    PanelFunction,
    legendre_basis,
    locate_in_panels,
)
from elastica_cad.mechanics.stiffness.moment_conditions import BalancedStiffness
from elastica_cad.mechanics.stiffness.quadrature_panels import NARROWEST_SHARE, ROUGH_AT_ZERO
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

TOLERANCE = 1e-6
"""Error of the stiffness profile, relative to its largest value; its extremes are exact."""

WORST_TOLERANCE = 0.01
"""The same where rounding has spoilt the stiffness, as much weight and an inflection beside an end do."""

NOISE_TIMES = 4
"""The fit errs by this many times what rounding has made of the stiffness under much weight."""

SAME_PLACE_SHARE = 1e-9
"""Of the length: a knot nearer to a zero of the curvature is there."""

STEP_LENGTH = 1e-5
"""A step of the stiffness is spread over this part of the length, so that the outline stays one edge."""

CELLS = 8
"""Parts of a panel in which the density of knots is taken as constant."""

_CELL_ENDS = legendre_basis(np.linspace(-1, 1, CELLS + 1))

_FOURTH_IN_CELLS = legendre_basis((2 * np.arange(CELLS) + 1) / CELLS - 1) @ np.linalg.matrix_power(SLOPES, 4)
"""Fourth derivatives by x in the middles of the cells."""

BEST_CUBIC = 1 / 720
"""Error of the best cubic spline over h^4 times the fourth derivative: the largest of B_4 / 4!, a Bernoulli
polynomial."""

SPARE = 0.07
"""Part of the tolerance that the first knots aim at: a second fit would cost more than the knots it saves."""


def stiffness_profile(check: EquilibriumCheck, balance: BalancedStiffness, scale: float) -> Profile:
    """K times `scale` as a cubic spline of arc length.

    K has two derivatives less than the curve, and one less again in an inflection at a knot; a kink stays a
    kink. A step is spread over a ramp.
    """
    curve = check.curve
    length = curve.length
    zeros = np.array([z.s for z in check.zeros])
    breaks: list[tuple[float, int]] = []
    steps: list[float] = []
    for s, order in (*balance.kinks, *((knot.s, knot.continuity - 2) for knot in curve.breaks)):
        near = NARROWEST_SHARE if order > ROUGH_AT_ZERO - 2 else SAME_PLACE_SHARE
        at_zero = zeros.size > 0 and np.abs(zeros - s).min() < near * length
        if order - int(at_zero) >= 0:
            breaks.append((s, order - int(at_zero)))
        elif not steps or np.abs(np.array(steps) - s).min() > STEP_LENGTH * length:
            steps.append(s)
    K = _AlongArc.of(curve, balance, scale)
    half = STEP_LENGTH * length / 2
    feet = [s + side * half for s in steps for side in (-1, 1)]
    # fitted apart, or the ramp, which weighs nothing, would have to take over its neighbours' errors
    breaks += [(s, -1) for s in feet]

    def stiffness(s: FloatArray) -> FloatArray:
        values = K(s)
        for step in steps:
            inside = np.abs(s - step) < half
            if inside.any():
                foot = np.array([step - half, step + half])
                values[inside] = np.interp(s[inside], foot, K(foot))
        return values

    noise = NOISE_TIMES * K.noise([*steps, *(s for s, _ in balance.kinks)])
    tolerance = min(max(TOLERANCE * K.largest, noise), WORST_TOLERANCE * K.largest)
    knots = K.knots([s for s, _ in breaks], SPARE * tolerance)
    fitted = Profile.fit(stiffness, length, breaks=breaks, knots=knots, tolerance=tolerance)
    for i, foot in enumerate(feet):
        fitted = _joined(fitted, foot, keep_left=i % 2 == 0)
    return _with_extremes(fitted, stiffness(np.array(fitted.extreme_places)), tolerance)


@dataclass(frozen=True, eq=False)
class _AlongArc:
    """K on the panels of a balance, as Legendre series in arc length; `edges` (N + 1,) are in mm."""

    edges: FloatArray
    series: PanelFunction

    @classmethod
    def of(cls, curve: PlaneCurve, balance: BalancedStiffness, scale: float) -> "_AlongArc":
        panels = balance.panels
        width = panels.edge_s[1:] - panels.edge_s[:-1]
        s = panels.edge_s[:-1, None] + width[:, None] * (1 + NODES) / 2
        t = curve.parameter(s)
        values = balance.stiffness.at(*panels.locate(t.ravel())) * scale
        return cls(panels.edge_s, PanelFunction.through(values.reshape(t.shape)))

    def __call__(self, s: FloatArray) -> FloatArray:
        return self.series.at(*locate_in_panels(self.edges, s))

    @property
    def largest(self) -> float:
        """The largest of K, nearly."""
        return float(self.series.in_every_panel(_CELL_ENDS).max())

    def noise(self, steps: Sequence[float]) -> float:
        """Largest jump of K between panels, but for its steps: rounding that grows along under much weight."""
        before, after = self.series.where_panels_meet
        # over as much of the length as a step is spread over: of steps nearer to each other one is kept
        jumps = np.abs(after - before)
        if len(steps):
            apart = np.abs(self.edges[1:-1, None] - np.array(steps)) > STEP_LENGTH * self.edges[-1]
            jumps = jumps[apart.all(axis=1)]
        return float(jumps.max(initial=0.0))

    def knots(self, breaks: Sequence[float], tolerance: float) -> FloatArray:
        """Knots between the breaks with which a cubic spline errs by `tolerance` everywhere.

        Their distance h is that where `BEST_CUBIC` h^4 K'''' is the tolerance.
        """
        width = self.edges[1:] - self.edges[:-1]
        fourth = self.series.in_every_panel(_FOURTH_IN_CELLS)
        # both by the panel's own x, from -1 to 1
        count = (np.abs(fourth) * BEST_CUBIC / tolerance) ** 0.25 * 2 / CELLS
        reached, s = np.zeros(count.size + 1), np.empty(count.size + 1)
        np.cumsum(count, out=reached[1:])
        s[:-1] = (self.edges[:-1, None] + width[:, None] * np.arange(CELLS) / CELLS).ravel()
        s[-1] = self.edges[-1]
        stops = sorted({float(self.edges[0]), *breaks, float(self.edges[-1])})
        at = np.interp(stops, s, reached).tolist()
        parts = [max(1, ceil(b - a)) for a, b in pairwise(at)]  # even stiffness asks for none
        wanted = [a + (b - a) / n * np.arange(1, n) for (a, b), n in zip(pairwise(at), parts, strict=True)]
        return np.asarray(np.interp(np.concatenate(wanted), reached, s))


def _with_extremes(profile: Profile, exact: FloatArray, tolerance: float) -> Profile:
    """The profile stretched a little so that its extremes are `exact`, the stiffness where it has them.

    The stiffness is stationary there, so the places need not be exact.
    """
    low, high = profile.extremes
    if high - low <= tolerance:
        return profile
    return profile.stretched(float(exact[0]), float(exact[1]))


def _joined(profile: Profile, place: float, *, keep_left: bool) -> Profile:
    """The profile with the gap at `place` closed: both sides get the value of the one kept."""
    first = int(np.searchsorted(profile.knots, place - 1e-9 * profile.length))
    coefficients = np.delete(profile.coefficients, first if keep_left else first - 1)
    return Profile(np.delete(profile.knots, first), coefficients, profile.degree)
