"""Division of a curve into panels with Gauss nodes, on which integrals are exact up to rounding errors."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.nurbs_curve import curvature, curvature_slope
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import midpoints, norm, numbers_in_groups
from elastica_cad.geometry.polynomials import (
    DENSE_PARTS,
    LEFT,
    NODES,
    ORDER,
    RIGHT,
    TO_COEFFICIENTS,
    WEIGHTS,
    PanelFunction,
    in_panels,
    lobatto_places,
    locate_in_panels,
)
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import knot_runs
from elastica_cad.mechanics.loads import ExcessCurvature, Gravity, NaturalCurvature, Weight
from elastica_cad.mechanics.moment_curvature import MaterialLaw
from elastica_cad.mechanics.theorem1 import EquilibriumCheck

# last Legendre coefficients of a resolved function, as a fraction of its largest value
RESOLVED = 1e-11
# last Legendre coefficients below this fraction of the largest value may be rounding errors
NOISE = 1e-6

# least distance between cuts, as a fraction of the width of a panel
APART_SHARE = 0.25

# least width of a panel that is cut, as a fraction of the parameter range of the curve
NARROWEST_SHARE = 1e-7

ROUGH_AT_ZERO = 2
"""A knot with at most this number of continuous derivatives ends a panel, even close to a zero of the curvature."""

STEP_LENGTH = 1e-5
"""Length of the ramp that replaces a jump of the stiffness, as a fraction of the length."""

# distances of the nodes from the left end of a panel, in half widths of the panel
FROM_LEFT = 1 + NODES


@dataclass(frozen=True, eq=False)
class Panels:
    """N panels with p Gauss nodes each; no node is on a knot or a zero of the excess curvature.

    Attributes
    ----------
    edges, edge_s : (N + 1,) arrays
        Parameters and arc lengths (mm) of the ends of panels.
    edge_position : (N + 1, 2) array
        Positions of the ends of panels, mm.
    zero_left, zero_right : (N,) bool arrays
        True if the excess curvature is zero at this end of the panel; never at both ends.
    flat : (N,) bool array
        True on the straight tails of a strip, which carry no moment.
    t, s, curvature : (N, p) arrays
        Parameters, arc lengths (mm) and excess curvature (1/mm) at the nodes. The excess curvature is the curvature
        minus the natural curvature. In a panel with a zero, it is the integral of its slope from the zero, so that
        its relative error is small.
    stretch : (N, p) array
        Derivative of arc length with respect to the panel coordinate x in [-1, 1], mm.
    from_left, from_right : (N, p, 2) arrays
        Positions of the nodes relative to the left and right end of the panel, mm.
    """

    edges: FloatArray
    edge_s: FloatArray
    edge_position: FloatArray
    zero_left: BoolArray
    zero_right: BoolArray
    flat: BoolArray
    t: FloatArray
    s: FloatArray
    curvature: FloatArray
    stretch: FloatArray
    from_left: FloatArray
    from_right: FloatArray

    @property
    def count(self) -> int:
        """Number of panels."""
        return len(self.t)

    def locate(self, t: FloatArray) -> tuple[IntArray, FloatArray]:
        """Return panel indices and panel coordinates x in [-1, 1] of parameters `t` (n,)."""
        return locate_in_panels(self.edges, t)

    def dense_places(self, parts: int = DENSE_PARTS) -> tuple[IntArray, FloatArray]:
        """Return panel indices and coordinates x of dense samples, with `parts` intervals in each panel."""
        x = lobatto_places(parts)
        return np.arange(self.count).repeat(x.size), np.tile(x, self.count)

    def arc_length(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Return the arc lengths, mm, at coordinates x of panels."""
        return PanelFunction.through(self.s).at(panel, x)


def cut_into_panels(
    curve: PlaneCurve,
    zeros: Sequence[float],
    *,
    cuts: Sequence[float] = (),
    natural_curvature: NaturalCurvature = 0.0,
    law: MaterialLaw | None = None,
    orders: Sequence[int] | None = None,
    flats: Sequence[tuple[float, float]] = (),
) -> Panels:
    """Return panels on which the curve, and moments divided by curvature, are polynomials within rounding errors.

    A panel is cut into 2, 4 or 8 parts until the last Legendre coefficients of two functions of the parameter
    t are negligible. These functions are the speed, and (t - zero) / excess for the nearest zero of the
    excess curvature (curvature minus natural curvature). The moment has the same zero, so moment / excess
    is smooth there, and panels need not become smaller towards the zero.

    Parameters
    ----------
    zeros : sequence of float
        Parameters at which the excess curvature is zero; they become ends of panels.
    cuts : sequence of float
        Further parameters that become ends of panels, such as the parameters of point masses.
    law : MaterialLaw, optional
        Material law. Its ratio of moment to initial stiffness replaces the excess curvature. Pass `cuts` where the
        law is not smooth.
    orders : sequence of int, optional
        Orders of the zeros: 2 if the excess curvature does not change its sign there; by default 1.
    flats : sequence of (float, float)
        Parameters between which the excess curvature is zero, at the ends of the curve.
    """
    excess = ExcessCurvature(curve, natural_curvature)
    low, high = curve.domain
    close = 1e-10 * (high - low)
    # a break (t, apart) ends a panel if it is farther than `apart` from a zero and from the ends; see `places`
    vanishing = sorted(map(float, zeros))
    order = np.array([o for _, o in sorted(zip(zeros, orders or [1] * len(zeros), strict=True))])
    fixed = [low, *(z for z in vanishing if low + close < z < high - close), high]
    # least width of a panel beside a zero, because values on narrower panels would be rounding errors
    narrow = NARROWEST_SHARE * (high - low)
    breaks = [(b.t, close if b.continuity <= ROUGH_AT_ZERO else narrow) for b in curve.breaks]
    breaks += [(float(t), close) for t in (*(t for t, _, _ in excess.kinks), *cuts)]
    away = _distances_from_nearest(np.array([t for t, _ in breaks]), fixed).tolist()
    places = sorted(
        fixed + [t for (t, apart), distance in zip(breaks, away, strict=True) if distance > apart]
    )
    smooth = curve.smooth_panels
    # the inner ends of panels on which the curve is smooth, except those close to another end
    between, widths = smooth[1:-1], np.diff(smooth)
    finer = between[
        _distances_from_nearest(between, places) > APART_SHARE * np.minimum(widths[:-1], widths[1:])
    ]
    sorted_places = sorted(places + finer.tolist())
    distinct_places = sorted_places[:1]
    for place in sorted_places[1:]:
        if place - distinct_places[-1] > close:
            distinct_places.append(place)
    edges = np.array(distinct_places)
    flags = _distances_from_nearest(edges, vanishing) <= close
    # cut a panel with zeros at both ends in two, so that each panel has at most one zero
    tail, parts = np.full(edges.size - 1, np.inf), np.where(flags[:-1] & flags[1:], 2, 1)
    poles = np.array(vanishing)
    while True:
        whole, part = np.arange(parts.size).repeat(parts), numbers_in_groups(parts)
        edges = np.append(edges[whole] + np.diff(edges)[whole] * (part / parts[whole]), high)
        flags = np.append(flags[whole] & (part == 0), flags[-1])
        before = tail[whole]
        t, velocity, stretch, kappa, flat, tail = _evaluated(excess, edges, flags, poles, order, law, flats)
        # coefficients that do not decrease when the panel is cut are rounding errors
        settled = (tail <= RESOLVED) | ((tail < NOISE) & (tail > 0.3 * before)) | (np.diff(edges) < narrow)
        # halving a panel of p nodes divides its last Legendre coefficient by about 2^p
        halvings = np.ceil(np.log2(np.where(np.isfinite(tail), tail, 1.0) / RESOLVED) / ORDER)
        parts = np.where(settled, 1, 2 ** halvings.clip(1, 3).astype(int))
        if settled.all() or parts.sum() > 4000:
            break
    edge_s = np.append(0.0, (stretch @ WEIGHTS).cumsum())
    from_ends = in_panels(np.concatenate([LEFT, -RIGHT]), velocity)
    return Panels(
        edges=edges, edge_s=edge_s, edge_position=curve.evaluate(edges),
        zero_left=flags[:-1], zero_right=flags[1:], flat=flat, t=t,
        s=edge_s[:-1, None] + stretch @ LEFT.T, curvature=kappa, stretch=stretch,
        from_left=from_ends[:, :ORDER], from_right=from_ends[:, ORDER:],
    )  # fmt: skip


def nearest_of(places: FloatArray, t: FloatArray) -> IntArray:
    """Return the indices (n,) of the sorted places (k,) that are nearest to parameters `t` (n,)."""
    return midpoints(places).searchsorted(t)


def _distances_from_nearest(t: FloatArray, sorted_places: list[float]) -> FloatArray:
    places = np.array(sorted_places or [np.inf])
    return np.asarray(np.abs(t - places[nearest_of(places, t)]))


def _evaluated(
    excess: ExcessCurvature,
    edges: FloatArray,
    at_zero: BoolArray,
    zeros: FloatArray,
    orders: IntArray,
    law: MaterialLaw | None,
    flats: Sequence[tuple[float, float]],
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, BoolArray, FloatArray]:
    """Return fields of `Panels` between `edges`, and the relative size (N,) of the last Legendre coefficients.

    The fields are t, the derivative (N, p, 2) of the position by the panel coordinate x, stretch, curvature and
    flat. `at_zero` is True for the edges at a zero. `zeros` (k,) are the sorted parameters of the zeros of
    curvature minus natural curvature, `orders` their orders.
    """
    left, zero_left = edges[:-1], at_zero[:-1]
    half = np.diff(edges)[:, None] / 2
    from_left = half * FROM_LEFT
    t = left[:, None] + from_left
    beside = (zero_left | at_zero[1:]).nonzero()[0]
    _, d1, d2, *d3 = excess.curve.derivatives(t.ravel(), 3 if beside.size else 2)
    velocity = d1.reshape(*t.shape, 2) * half[..., None]
    stretch = norm(velocity)
    kappa = curvature(d1, d2).reshape(t.shape) - excess.rest_at(t)
    if beside.size:
        at = (beside[:, None] * ORDER + np.arange(ORDER)).ravel()
        slope = curvature_slope(d1[at], d2[at], d3[0][at]).reshape(-1, ORDER) - excess.rest_at(t[beside], 1)
        nearest = nearest_of(zeros, edges[beside + ~zero_left[beside]])
        double = orders[nearest] == 2
        # at a double zero, the computed slope is a rounding error, so subtract it from slopes nearby
        if double.any():
            slope[double] -= excess.slope_at(zeros[nearest[double]])[:, None]
        growth = slope * stretch[beside]
        kappa[beside] = np.where(zero_left[beside, None], growth @ LEFT.T, -(growth @ RIGHT.T))
    if law is not None:
        kappa = law.effective_curvature(kappa)
    middle = left + half[:, 0]
    flat = np.zeros(middle.shape, dtype=bool)
    for low, high in flats:
        flat |= (low < middle) & (middle < high)
    kappa[flat] = 0.0
    # the speed, and a power of the distance from the nearest zero, which is divided by the excess curvature below
    functions = np.stack([stretch, np.ones(t.shape)])
    if zeros.size:
        pole = nearest_of(zeros, middle)
        functions[1] = (from_left + (left - zeros[pole])[:, None]) ** orders[pole, None]
    if beside.size:
        functions[1, beside] = (
            np.where(zero_left[beside, None], FROM_LEFT, NODES - 1) ** orders[nearest, None]
        )
    with np.errstate(divide="ignore", invalid="ignore"):
        functions[1] /= kappa
        functions[1, flat] = 1.0
        tails = np.abs(functions @ TO_COEFFICIENTS[-2:].T).max(axis=-1) / np.abs(functions).max(axis=-1)
    return t, velocity, stretch, kappa, flat, tails.max(axis=0)


REFINEMENTS = 6
"""Largest number of times that a linear program is solved again on finer panels."""

# a knot of the load ends a panel if the stiffness has fewer than this number of continuous derivatives there
_SMOOTH = 4


@dataclass(frozen=True, eq=False)
class CutCurve:
    """Curve and the parameters at which it is cut into panels with a smooth stiffness.

    Panels end at the `cuts` and at the zeros of the excess curvature, which `check` contains.

    Attributes
    ----------
    check : EquilibriumCheck
        Curve and its zeros.
    natural_curvature : float or RestCurvature
        Curvature of the unloaded strip, 1/mm.
    law : MaterialLaw or None
        Moment-curvature law of a nonlinear material, or None for a linear material.
    cuts : tuple of float
        Parameters of the curve at which panels end: kinks, and more where the stiffness varies strongly.
    kinks : tuple of (float, int)
        Arc lengths, mm, at which the stiffness is not smooth, each with the number of continuous derivatives.
    """

    check: EquilibriumCheck
    natural_curvature: NaturalCurvature
    law: MaterialLaw | None
    cuts: tuple[float, ...]
    kinks: tuple[tuple[float, int], ...]

    @classmethod
    def where_kinked(
        cls,
        check: EquilibriumCheck,
        natural_curvature: NaturalCurvature,
        law: MaterialLaw | None,
        weight: Weight | None,
        stations: Sequence[float],
    ) -> "CutCurve":
        """Return the curve, cut where the natural curvature, the material law or the load is not smooth.

        `stations` are the arc lengths, mm, of forces between the ends.
        """
        excess = ExcessCurvature(check.curve, natural_curvature)
        # kinks (parameter, arc length, continuous derivatives) of the natural curvature and of the law, which has
        # its kinks at both signs of the excess curvature
        bend = [*excess.kinks] + [
            (place.t, place.s, continuity)
            for curvature, continuity in (() if law is None else law.kinks)
            for side in (-curvature, curvature)
            for place in excess.equals(side)
        ]
        zeros = np.array([zero.s for zero in check.zeros])
        # (arc length, continuous derivatives): the moment has a corner at a force, and so has the stiffness
        kinks = [*_load_kinks(check.length, weight), *((s, 0) for s in stations)]
        # the panel between a load and a zero close to it would be too narrow, so the load moves to the zero; at an
        # end, it then causes no kink
        hung = [(_moved_to_zero(s, zeros, check.length), c) for s, c in kinks if 0 < s < check.length]
        hung = [(s, c) for s, c in hung if 0 < s < check.length]
        places = [place for s, _ in hung for place in (s, *_away_from_zero(s, zeros, check.length))]
        cuts = (*(t for t, _, _ in bend), *check.curve.parameter(places).tolist())
        return cls(check, natural_curvature, law, cuts, (*((s, c) for _, s, c in bend), *hung))

    @cached_property
    def panels(self) -> Panels:
        """Panels between the cuts."""
        curve, zeros = self.check.curve, self.check.zeros
        low, high = curve.domain
        tails = [(zero.t, high) if zero.before else (low, zero.t) for zero in zeros if zero.kind == "flat"]
        return cut_into_panels(
            curve, [zero.t for zero in zeros], cuts=self.cuts, natural_curvature=self.natural_curvature,
            law=self.law, flats=tails,
        )  # fmt: skip

    def for_weight(self, gravity: Gravity) -> "CutCurve":
        """Return the curve with more cuts for a strip with weight, whose stiffness varies within long panels.

        With weight, (K kappa)'' is about K / l_eg^3, with the elasto-gravity length l_eg, so K changes by a factor
        e over the length sqrt(kappa l_eg^3). A panel is divided if it is longer than twice this length for its
        largest curvature, because the curvature is 0 where panels end at zeros.
        """
        panels = self.panels
        steep = np.sqrt(gravity.length**-3 / np.abs(panels.curvature).max(axis=1))
        # a limit, because almost straight panels would be divided very often
        parts = np.ceil(np.diff(panels.edge_s) * steep / 2).clip(1, 50).astype(int)
        edges = panels.edges
        inner = [np.linspace(a, b, n + 1)[1:-1] for a, b, n in zip(edges[:-1], edges[1:], parts, strict=True)]
        return self._also_at(np.concatenate(inner))

    def for_stiffness(self, stiffness: PanelFunction) -> "CutCurve | None":
        """Halve the panels on which the stiffness is not resolved; return None if it is resolved everywhere."""
        rough = stiffness.unresolved(1e-9)
        edges = self.panels.edges
        return self._also_at(midpoints(edges)[rough]) if rough.any() else None

    def _also_at(self, cuts: FloatArray) -> "CutCurve":
        return replace(self, cuts=(*self.cuts, *cuts))


def _moved_to_zero(s: float, zeros: FloatArray, length: float) -> float:
    near = zeros[np.abs(zeros - s) < STEP_LENGTH * length]
    return float(near[0]) if near.size else s


def _away_from_zero(s: float, zeros: FloatArray, length: float) -> list[float]:
    """Return arc lengths, mm, of more panel ends beyond a mass at s, if the mass is near a zero of the curvature.

    Beyond the mass, a part of the stiffness is inversely proportional to the distance from the zero. The distances
    of the panel ends from the zero double, so that this part is resolved on each panel.
    """
    if not zeros.size:
        return []
    zero = float(zeros[np.abs(zeros - s).argmin()])
    places, reach = [], 2 * (s - zero)
    while 0 < abs(reach) < 0.05 * length and 0 < zero + reach < length:
        places.append(zero + reach)
        reach *= 2
    return places


def _load_kinks(length: float, weight: Weight | None) -> list[tuple[float, int]]:
    """Return arc length, mm, and number of continuous derivatives of the stiffness, for each kink of the load."""
    if weight is None:
        return []
    kinks = [(mass.s, 0) for mass in weight.masses]
    for part in (weight.alpha, weight.beta):
        if isinstance(part, Profile):
            if not np.isclose(part.length, length, rtol=1e-6):
                raise InputError(
                    (
                        "a weight profile is {length:.6g} long, but the curve is {length_2:.6g} long: give the "
                        "weight along the whole curve"
                    ),
                    length=Length(part.length),
                    length_2=Length(length),
                )
            # the stiffness is smoother by two derivatives, because the moment is a double integral of the load
            knots, times = knot_runs(part.knots)
            smooth = part.degree - times + 2
            kinks += [(float(s), int(c)) for s, c in zip(knots, smooth, strict=True) if c < _SMOOTH]
    return kinks
