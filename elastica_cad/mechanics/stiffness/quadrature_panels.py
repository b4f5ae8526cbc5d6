"""A curve cut into panels with Gauss nodes: quotients and integrals along it to near rounding error."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Self

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.geometry.curves.curve_derivatives import curvature, curvature_slope
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.chebyshev import chebyshev
from elastica_cad.geometry.running_sums import numbers_in_groups
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature, NaturalCurvature
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw

ORDER = 12  # Gauss nodes of a panel
MAX_PANELS = 4000  # of one curve: more mean a function that cannot be resolved
RESOLVED = 1e-11  # of the function: last coefficients below it are rounding
NOISE = 1e-6  # of the function: last coefficients below it that a split hardly lowers are rounding too

NARROWEST_SHARE = 1e-7  # of the domain: no panel is cut further

ROUGH_AT_ZERO = 2
"""Continuity of a curve up to which a knot parts panels however near to a zero of the curvature it lies."""

DENSE_PARTS = 24
"""Of each panel, at whose places bounds are first watched."""

EXTREME_STEPS = 3
"""Of Newton's method, from the nearest of those places to an extreme."""

NODES, WEIGHTS = np.polynomial.legendre.leggauss(ORDER)
_DEGREES = np.arange(ORDER)
VANDER = np.polynomial.legendre.legvander(NODES, ORDER - 1)
TO_COEFFICIENTS = (VANDER * WEIGHTS[:, None]).T * (_DEGREES + 0.5)[:, None]


def _antiderivatives() -> tuple[FloatArray, FloatArray]:
    """Matrices (p, p) that integrate nodal values from -1 to each node, and from each node to 1."""
    longer = np.polynomial.legendre.legvander(NODES, ORDER)
    primitive = np.empty((ORDER, ORDER))
    primitive[:, 0] = NODES + 1
    for n in range(1, ORDER):
        primitive[:, n] = (longer[:, n + 1] - longer[:, n - 1]) / (2 * n + 1)
    left = primitive @ TO_COEFFICIENTS
    return left, WEIGHTS - left


LEFT, RIGHT = _antiderivatives()
_CHEBYSHEV_TO_LEGENDRE = np.linalg.solve(chebyshev(NODES, ORDER).T, VANDER)
SLOPES = np.append(np.polynomial.legendre.legder(np.eye(ORDER)), np.zeros((1, ORDER)), axis=0)
"""Legendre coefficients of the derivative from those of a function."""


def locate_in_panels(edges: FloatArray, places: FloatArray) -> tuple[IntArray, FloatArray]:
    """Between which edges (N + 1,) places (n,) lie, and where there, from -1 to 1."""
    panel = np.searchsorted(edges[1:-1], places, side="right")
    start, end = edges[panel], edges[panel + 1]
    return panel, np.minimum(np.maximum((2 * places - start - end) / (end - start), -1.0), 1.0)


@dataclass(frozen=True, eq=False)
class Panels:
    """N panels with p Gauss nodes each; no node lies on a knot or a zero of the curvature.

    Attributes
    ----------
    edges, edge_s : (N + 1,) arrays
        Parameters and arc lengths (mm) of the panel ends.
    edge_position : (N + 1, 2) array
        mm.
    zero_left, zero_right : (N,) bool arrays
        Does the curvature vanish at this end of the panel? Never at both.
    t, s, curvature : (N, p) arrays
        Parameters, arc lengths and kappa - kappa_0 at the nodes; beside a zero integrated from it, so that
        the relative accuracy is kept.
    stretch : (N, p) array
        ds/dx, where x in [-1, 1] runs over the panel.
    from_left, from_right : (N, p, 2) arrays
        Position less that of the panel's left, right end, mm.
    """

    edges: FloatArray
    edge_s: FloatArray
    edge_position: FloatArray
    zero_left: BoolArray
    zero_right: BoolArray
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
        """Panel numbers and places x in [-1, 1] of parameters `t` (n,)."""
        return locate_in_panels(self.edges, t)

    def dense_places(self, parts: int = DENSE_PARTS) -> tuple[IntArray, FloatArray]:
        """Panel numbers and places x of a dense sampling, panel ends included, in so many parts a panel."""
        x = _lobatto(parts)
        return np.repeat(np.arange(self.count), x.size), np.tile(x, self.count)

    def arc_length(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Arc lengths of places x in panels, mm."""
        return np.asarray(PanelFunction.through(self.s).at(panel, x))


@dataclass(frozen=True, eq=False)
class PanelFunction:
    """A piecewise polynomial: Legendre coefficients (N, p, ...) over the panels."""

    coefficients: FloatArray

    @classmethod
    def through(cls, values: FloatArray) -> "PanelFunction":
        """The interpolant of nodal values (N, p, ...)."""
        return cls(np.einsum("ij,nj...->ni...", TO_COEFFICIENTS, values))

    def at(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Values (n, ...) at places x (n,) of panels (n,)."""
        return values_at((self,), panel, x)[0]

    def in_every_panel(self, basis: FloatArray) -> FloatArray:
        """Values (N, k, ...) at the same places of every panel, from their `legendre_basis` (k, p)."""
        return np.asarray(np.einsum("ki,ni...->nk...", basis, self.coefficients))

    def slopes_at(self, panel: IntArray, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """First and second derivatives with respect to x (n, ...)."""
        both = self._slopes.at(panel, x)
        return both[..., 0], both[..., 1]

    @cached_property
    def _slopes(self) -> "PanelFunction":
        first = np.einsum("ij,nj...->ni...", SLOPES, self.coefficients)
        return PanelFunction(np.stack([first, np.einsum("ij,nj...->ni...", SLOPES, first)], axis=-1))

    def unresolved(self, tolerance: float) -> BoolArray:
        """Panels (N,) whose last coefficients exceed `tolerance` times the largest one."""
        size = np.abs(self.coefficients)
        return np.asarray(size[:, -2:].max(axis=1) > tolerance * size.max(axis=1))

    @property
    def nodal(self) -> FloatArray:
        """Values (N, p, ...) at the nodes of the panels."""
        return np.asarray(np.einsum("ij,nj...->ni...", VANDER, self.coefficients))

    @property
    def where_panels_meet(self) -> tuple[FloatArray, FloatArray]:
        """Values (N - 1, ...) before and after the places where panels meet."""
        at_ends = self.in_every_panel(_ENDS_BASIS)
        return at_ends[:-1, 1], at_ends[1:, 0]

    @property
    def dense(self) -> FloatArray:
        """Values (n, ...) at `Panels.dense_places`."""
        values = self.in_every_panel(_DENSE_BASIS)
        return values.reshape(values.shape[0] * values.shape[1], *values.shape[2:])

    @property
    def extremes(self) -> FloatArray:
        """Values at `extreme_places`."""
        return self.at(*self.extreme_places)

    @property
    def extreme_places(self) -> tuple[IntArray, FloatArray]:
        """Places of the local extremes near the largest and least value, by Newton's method from samples."""
        table = self.in_every_panel(_DENSE_BASIS)
        extreme = np.zeros_like(table, dtype=bool)
        middle, before, after = table[:, 1:-1], table[:, :-2], table[:, 2:]
        extreme[:, 1:-1] = ((middle >= before) & (middle >= after)) | ((middle <= before) & (middle <= after))
        low, high = table.min(), table.max()
        band = 0.05 * (high - low)
        near = extreme & ((table > high - band) | (table < low + band))
        # the worst samples stay in, ends of panels among them
        near.flat[[table.argmin(), table.argmax()]] = True
        panel, place = np.nonzero(near)
        start = x = _DENSE[place]
        lower, upper = np.maximum(start - 0.15, -1.0), np.minimum(start + 0.15, 1.0)
        for _ in range(EXTREME_STEPS):
            slope, curvature = self.slopes_at(panel, x)
            step = np.divide(-slope, curvature, out=np.zeros_like(x), where=curvature != 0)
            x = np.minimum(np.maximum(x + step, lower), upper)
        return np.concatenate([panel, panel]), np.concatenate([start, x])

    def combined(self, numbers: FloatArray) -> "PanelFunction":
        """The last axis contracted with `numbers`."""
        return PanelFunction(self.coefficients @ numbers)


def values_at(functions: Sequence[PanelFunction], panel: IntArray, x: FloatArray) -> list[FloatArray]:
    """Values (n, ...) of each function at places x (n,) of panels (n,)."""
    basis = legendre_basis(x)
    return [np.asarray(np.einsum("ni,ni...->n...", basis, f.coefficients[panel])) for f in functions]


def legendre_basis(x: FloatArray) -> FloatArray:
    """Values (n, p) of the Legendre polynomials at x (n,)."""
    return np.asarray(chebyshev(x, ORDER).T @ _CHEBYSHEV_TO_LEGENDRE)


def _lobatto(parts: int) -> FloatArray:
    """Places (parts + 1,) from -1 to 1, closer towards the ends."""
    inner = np.cos(np.pi * (np.arange(1, parts)[::-1] / parts))
    return np.concatenate([[-1.0], inner, [1.0]])


_DENSE = _lobatto(DENSE_PARTS)
_DENSE_BASIS = legendre_basis(_DENSE)
_ENDS_BASIS = legendre_basis(np.array([-1.0, 1.0]))


def cut_into_panels(
    curve: PlaneCurve,
    zeros: Sequence[float],
    *,
    cuts: Sequence[float] = (),
    natural_curvature: NaturalCurvature = 0.0,
    law: MaterialLaw | None = None,
) -> Panels:
    """Panels that resolve the curve, and any moment over its curvature.

    A panel is cut into 2, 4 or 8 until the Legendre coefficients of the speed and of (t - zero)/(kappa -
    kappa_0) have died away.

    Parameters
    ----------
    zeros : sequence of float
        Parameters where kappa - kappa_0 vanishes: they become panel ends.
    cuts : sequence of float
        Further parameters that must be panel ends, such as places of point masses.
    law : MaterialLaw, optional
        Its effective curvature stands for kappa - kappa_0; where it is not smooth there should be cuts.
    """
    excess = ExcessCurvature(curve, natural_curvature)
    low, high = curve.domain
    close = 1e-10 * (high - low)
    fixed = np.array([low, *sorted(z for z in zeros if low + close < z < high - close), high])
    # beside a zero a narrow panel would hold nothing but rounding
    narrow = NARROWEST_SHARE * (high - low)
    knots = ((b.t, close if b.continuity <= ROUGH_AT_ZERO else narrow) for b in curve.breaks)
    kinks = ((t, close) for t in (*(t for t, _, _ in excess.kinks), *cuts))
    others = [t for t, apart in (*knots, *kinks) if np.abs(fixed - t).min() > apart]
    edges = np.unique(np.concatenate([fixed, others]))
    edges = edges[np.concatenate([[True], np.diff(edges) > close])]
    flags = np.array([any(abs(z - e) <= close for z in zeros) for e in edges])
    cut = _Cut(edges[:-1], edges[1:], flags[:-1], flags[1:], np.full(edges.size - 1, np.inf))
    cut = cut.into(np.where(cut.zero_left & cut.zero_right, 2, 1))
    done: list[_Nodes] = []
    while cut.left.size:
        found, tail = _evaluated(excess, cut, law)
        parts = _parts(tail)
        # where cutting no longer helps, the rest is rounding noise
        settled = (tail <= RESOLVED) | ((tail < NOISE) & (tail > 0.3 * cut.tail))
        settled |= cut.right - cut.left < NARROWEST_SHARE * (high - low)
        if sum(len(nodes.t) for nodes in done) + cut.left.size + parts[~settled].sum() > MAX_PANELS:
            settled[:] = True
        done.append(found.chosen(settled))
        cut = replace(cut, tail=tail).chosen(~settled).into(parts[~settled])
    return _panels(curve, done)


@dataclass(frozen=True, eq=False)
class _Columns:
    """Arrays with one entry a panel."""

    def chosen(self, which: BoolArray | IntArray) -> Self:
        """Some of the panels."""
        return replace(self, **{f.name: getattr(self, f.name)[which] for f in fields(self)})


@dataclass(frozen=True, eq=False)
class _Cut(_Columns):
    """Panels before they are evaluated; `tail` is how badly the panel they come from was resolved."""

    left: FloatArray
    right: FloatArray
    zero_left: BoolArray
    zero_right: BoolArray
    tail: FloatArray

    def into(self, parts: IntArray) -> "_Cut":
        """Every panel cut into its number of equal parts."""
        whole = self.chosen(np.repeat(np.arange(parts.size), parts))
        count = np.repeat(parts, parts)
        part = numbers_in_groups(parts)
        width, first, last = whole.right - whole.left, part == 0, part == count - 1
        return _Cut(
            whole.left + width * (part / count),
            np.where(last, whole.right, whole.left + width * ((part + 1) / count)),
            whole.zero_left & first,
            whole.zero_right & last,
            whole.tail,
        )


def _parts(tail: FloatArray) -> IntArray:
    """How many parts a panel needs, 2, 4 or 8: halving divides the last coefficient by 2^p or so."""
    halvings = np.ceil(np.log2(np.nan_to_num(tail, nan=1.0, posinf=1.0) / RESOLVED) / ORDER)
    return np.asarray(2 ** np.minimum(np.maximum(halvings, 1), 3), dtype=int)


@dataclass(frozen=True, eq=False)
class _Nodes(_Columns):
    """Panels evaluated at their Gauss nodes: fields as of `Panels`, `velocity` (N, p, 2) by x."""

    left: FloatArray
    zero_left: BoolArray
    zero_right: BoolArray
    t: FloatArray
    velocity: FloatArray
    stretch: FloatArray
    curvature: FloatArray


def _evaluated(excess: ExcessCurvature, cut: _Cut, law: MaterialLaw | None) -> tuple[_Nodes, FloatArray]:
    """The panels at their nodes, and how much of each is unresolved."""
    half = (cut.right - cut.left)[:, None] / 2
    t = cut.left[:, None] + half * (1 + NODES)
    beside = cut.zero_left | cut.zero_right
    _, d1, d2, *d3 = excess.curve.derivatives(t.ravel(), 3 if beside.any() else 2)
    velocity = d1.reshape(*t.shape, 2) * half[..., None]
    stretch = np.hypot(velocity[..., 0], velocity[..., 1])
    kappa = curvature(d1, d2).reshape(t.shape) - excess.rest_at(t)
    if d3:
        slope = curvature_slope(d1, d2, d3[0]).reshape(t.shape) - excess.rest_at(t, 1)
        growth = (slope * stretch)[beside]
        kappa[beside] = np.where(cut.zero_left[beside, None], growth @ LEFT.T, -(growth @ RIGHT.T))
    if law is not None:
        kappa = law.effective_curvature(kappa)
    to_zero = np.where(cut.zero_left[:, None], 1 + NODES, np.where(cut.zero_right[:, None], NODES - 1, 1.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        functions = np.stack([stretch, to_zero / kappa])
        tails = np.abs(functions @ TO_COEFFICIENTS[-2:].T).max(axis=-1) / np.abs(functions).max(axis=-1)
    nodes = _Nodes(cut.left, cut.zero_left, cut.zero_right, t, velocity, stretch, kappa)
    return nodes, np.asarray(tails.max(axis=0))


def _panels(curve: PlaneCurve, parts: list[_Nodes]) -> Panels:
    """One chain of panels from loose ones."""
    nodes = _Nodes(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(_Nodes)))
    nodes = nodes.chosen(np.argsort(nodes.left))
    edges = np.append(nodes.left, curve.domain[1])
    edge_s = np.concatenate([[0.0], np.cumsum(nodes.stretch @ WEIGHTS)])
    return Panels(
        edges=edges, edge_s=edge_s, edge_position=curve.evaluate(edges),
        zero_left=nodes.zero_left, zero_right=nodes.zero_right, t=nodes.t,
        s=edge_s[:-1, None] + nodes.stretch @ LEFT.T, curvature=nodes.curvature, stretch=nodes.stretch,
        from_left=np.einsum("ij,njk->nik", LEFT, nodes.velocity),
        from_right=-np.einsum("ij,njk->nik", RIGHT, nodes.velocity),
    )  # fmt: skip
