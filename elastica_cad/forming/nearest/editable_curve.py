"""A rod's rest shape as a spline of degree 4 with few control points, for further editing."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities, StripGrid
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.refusals import Length

DEGREE = 4  # the least whose curvature has a slope that is continuous
STRAIGHT_RAD = 1e-9  # over the whole length: nothing but rounding bends such a rod
TOLERANCE_MM = 1e-3  # between curve and rod: below what a laser cutter repeats
FAITHFUL = 3e-4  # relative error of the extremes of the stiffness that the curve asks for: limits stay met
LOOSE = 0.02  # and of the stiffness between, where no limit depends on it
UNBENT_SHARE = 2e-3  # of the largest curvature, below which the stiffness is a quotient of rounding errors
_REACH_LENGTHS = 0.05  # curvature errors that extend this far weigh as much as the displacement they make
_FIRST_SPANS, _MOST_SPANS = 24, 240  # few control points are tried first, as they are edited by hand
_SHORTEST_SPAN = 1e-3  # span, in lengths: shorter ones fit rounding
_SAME_LENGTHS = 1e-6  # an inflection as near an end is the end's own
_PARDONED = 2.0  # tolerances, accepted where finer spans do not help
_RESISTANCES = (1e-9, 1e-6, 1e-3, np.inf)  # against moving coefficients of the stiffness, tried in turn
_GROWN = 1e-4  # of the ratio, the most that giving way may cost
_NEWTON_STEPS = 15  # at most: where coefficients of the stiffness resist, steps die out slowly
# Steps leave imbalance of the order of their squares; what resists makes them die out slowly along idle unknowns.
_SETTLED_RAD, _STILL_RAD = 2e-7, 2e-6  # of the last step: aimed at, and accepted
_FINER = 4  # the continuous rod is extrapolated from 4 and 8 times as many edges


def editable_curve(rod: Rod, *, tangents: tuple[bool, bool] = (False, False)) -> PlaneCurve:
    """The spline of degree 4 that the continuous rod with the stiffness of a discrete one takes.

    The discrete rod of n edges is off the continuous one by O(1/n^2), which the curvature near inflections would
    show. So the continuous rod of the same stiffness through the same ends is computed first, and the spline
    fits its curvature as well as its position; at its inflections the spline meets it exactly, so that they lie on
    one line without weight (Theorem 1).

    Parameters
    ----------
    rod : Rod
        In balance.
    tangents : (bool, bool)
        Whether the start and the end keep the discrete rod's tangent exactly.

    Raises
    ------
    NotConvergedError
        The continuous rod or the fit did not reach its tolerance.
    """
    if np.abs(rod.curvature).max() * rod.length < STRAIGHT_RAD:
        return PlaneCurve.line(rod.position[0], rod.position[-1], degree=DEGREE)
    shape = _continuous(rod, tangents)
    edges = np.linspace(0, float(shape.s[-1]), _FIRST_SPANS + 1)
    least, best = np.inf, None
    while edges.size <= _MOST_SPANS and np.diff(edges).min() > _SHORTEST_SPAN:
        curve = _fitted(shape, edges)
        error = _errors(curve, shape)
        if error.max() < least:
            least, best = float(error.max()), curve
        if least <= 1:
            break
        edges = _refined(edges, shape.s[error > 1])
    if best is None or least > _PARDONED:
        raise NotConvergedError(
            "the rest shape of {length:.6g} cannot be written as a spline of degree 4 with "
            "{most_spans} spans: use rod.curve, or fewer coefficients",
            length=Length(rod.length),
            most_spans=_MOST_SPANS,
        )
    return _in_millimetres(best, rod)


def coarse_curve(rod: Rod, spans: int, *, tangents: tuple[bool, bool] = (False, False)) -> PlaneCurve:
    """As `editable_curve`, with `spans` even spans: beside the rod, with inflections on one line all the same.

    What the rod keeps within its limits the curve may not: ask again.

    Raises
    ------
    NotConvergedError
        The continuous rod was not reached, or as few spans cannot meet its inflections.
    """
    shape = _continuous(rod, tangents)
    try:
        return _in_millimetres(_fitted(shape, np.linspace(0, float(shape.s[-1]), spans + 1)), rod)
    except np.linalg.LinAlgError as error:
        raise NotConvergedError(
            "a spline of {spans} spans does not meet the inflections of the rest shape: take more",
            spans=spans,
        ) from error


def _refined(edges: FloatArray, places: FloatArray) -> FloatArray:
    """Halves the widest of the spans that hold `places` and their neighbours: jumps in width would ring."""
    width = np.diff(edges)
    bad = np.searchsorted(edges, places, side="right") - 1
    bad = np.unique(np.clip(np.concatenate([bad - 1, bad, bad + 1]), 0, width.size - 1))
    bad = bad[width[bad] > 0.6 * width[bad].max()]
    return np.sort(np.concatenate([edges, edges[bad] + width[bad] / 2]))


@dataclass(frozen=True, eq=False)
class _Shape:
    """A continuous rod at uniform stations, in lengths of the discrete one.

    Attributes
    ----------
    s, angle, curvature, stiffness : (k,) arrays
    rest : (k,) array
        Curvature before bending.
    position : (k, 2) array
    inflections : (j,) array
        Arc lengths where the moment vanishes: inside, and at ends that are free to turn.
    size : float
        The unit of length, mm.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    stiffness: FloatArray
    rest: FloatArray
    inflections: FloatArray
    size: float

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Position, angle, curvature at arc lengths s, by cubic splines through the stations."""
        from scipy.interpolate import make_interp_spline

        table = np.column_stack([self.position, self.angle, self.curvature])
        values = make_interp_spline(self.s, table, k=5)(s)
        return values[:, :2], values[:, 2], values[:, 3]

    def slope(self, s: FloatArray) -> FloatArray:
        """Derivative of the curvature at arc lengths s."""
        from scipy.interpolate import make_interp_spline

        return np.asarray(make_interp_spline(self.s, self.curvature, k=5)(s, nu=1))


def _continuous(rod: Rod, tangents: tuple[bool, bool]) -> _Shape:
    """The continuous rod nearest to the discrete one with the same ends (and tangents, where asked).

    It is extrapolated from the rods with 4 and 8 times as many edges, whose error is a series in 1/n^2.
    """
    for stiff in _RESISTANCES:
        a = _Refinement(rod, _FINER, tangents, stiff).solved()
        b = None if a is None else _Refinement(rod, 2 * _FINER, tangents, stiff).solved()
        if a is None or b is None:
            continue
        shape = _extrapolated(a, b, rod)
        if shape.stiffness.max() <= (1 + _GROWN) * rod.ratio * shape.stiffness.min():
            return shape
    raise NotConvergedError(
        "the continuous rod does not reach the ends of the discrete one: it is about to snap; use more samples"
    )


@dataclass(frozen=True, eq=False)
class _Refinement:
    """The rod with `factor` times as many edges that is nearest to a discrete one, in lengths of that."""

    rod: Rod
    factor: int
    tangents: tuple[bool, bool]
    stiff: float

    def solved(self) -> MappedRod | None:
        """Newton's method with angles and moments as unknowns of their own; None without convergence."""
        rod, size, k = self.rod, self.rod.length, self.factor
        grid = self._grid()
        u = grid.unknowns
        z = np.zeros(u.count)
        z[u.stiffness] = rod.profile.coefficients
        z[u.moment], z[u.force] = rod.moment[0] * size, rod.force[0] * size**2
        z[u.angle], z[u.length] = rod.angle[0], 1.0
        s = np.linspace(0, 1, grid.edges + 1)
        nodes = np.linspace(0, 1, rod.s.size)
        edges = np.concatenate([[0.0], (s[:-1] + s[1:]) / 2, [1.0]])
        angles, moments = np.interp(edges, nodes, rod.angle), np.interp(s, nodes, rod.moment * size)
        target = (rod.position - rod.position[0]) / size
        free = self._free(grid)
        resist = np.where(free < u.moment, min(self.stiff, 1.0), 1e-14)
        for _ in range(_NEWTON_STEPS):
            now = grid.assemble(z, angles, moments)
            d = grid.sensitivities(now, closing=True)
            gap, C = self._ends(now, d, target)
            J = d.position[::k].reshape(-1, u.count + 1)
            off = (now.position[::k] - target).ravel() + J[:, -1]
            J = J[:, free]
            scale = np.sqrt((J**2).sum(axis=0))
            J, C = J / scale, C[:, free] / scale
            system = np.block([[J.T @ J + np.diag(resist), C.T], [C, np.zeros((gap.size, gap.size))]])
            change = np.zeros(u.count + 1)
            change[-1] = 1.0
            change[free] = np.linalg.solve(system, np.concatenate([-J.T @ off, -gap]))[: free.size] / scale
            z, turn = z + change[:-1], d.angles @ change
            angles, moments = angles + turn, moments + d.moments @ change
            size_of_step = float(np.abs(turn).max())
            if not size_of_step < 10:
                return None
            if size_of_step < _SETTLED_RAD:
                break
        return grid.assemble(z, angles, moments) if size_of_step < _STILL_RAD else None

    def _free(self, grid: StripGrid) -> IntArray:
        """Unknowns that may move: coefficients of K that touch neither extreme give way a little."""
        u, rod = grid.unknowns, self.rod
        start = rod.supports.ends[0]
        fixed = [u.position.start, u.position.start + 1]
        fixed += [u.angle] if self.tangents[0] else []
        fixed += [] if start.angle else [u.moment]
        fixed += [u.force.start + axis for axis, held in enumerate((start.x, start.y)) if not held]
        c = rod.profile.coefficients
        room = 1e-3 * np.ptp(c) if np.isfinite(self.stiff) else np.inf
        fixed += np.flatnonzero((c <= c.min() + room) | (c >= c.max() - room)).tolist()
        return np.setdiff1d(np.arange(u.count), fixed)

    def _ends(self, now: MappedRod, d: Sensitivities, target: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Equations at the end: values (k,) that must be 0, and their derivatives (k, p + 1)."""
        gaps, rows = [now.position[-1] - target[-1]], [d.position[-1]]
        if self.tangents[1]:
            gaps.append(now.all_angles[-1:] - self.rod.angle[-1])
            rows.append(d.angles[-1:])
        if not self.rod.supports.ends[1].angle:
            gaps.append(now.moments[-1:])
            rows.append(d.moments[-1:])
        C = np.concatenate(rows)
        return np.concatenate(gaps) + C[:, -1], C[:, :-1]

    def _grid(self) -> StripGrid:
        from scipy.interpolate import BSpline

        rod, profile = self.rod, self.rod.profile
        x = np.linspace(0, 1, (rod.s.size - 1) * self.factor + 1)
        basis = BSpline.design_matrix(x, profile.knots / profile.length, profile.degree).toarray()
        kappa_0 = np.asarray(rod.natural_curvature, dtype=float) * rod.length
        if kappa_0.ndim:
            kappa_0 = np.interp(x, np.linspace(0, 1, kappa_0.size), kappa_0)
        e = np.zeros(2) if rod.gravity is None else rod.gravity.e * rod.length**3
        if rod.gravity is None or rod.weight is None:
            return StripGrid(np.asarray(basis), e, kappa_0)
        over = rod.length**3 / (rod.bending_stiffness or 1.0)
        alpha, beta = (over * part for part in rod.weight.along(x * rod.length))
        up = -np.asarray(rod.gravity.direction)
        return StripGrid(np.asarray(basis), up, kappa_0, weight=lambda K: (alpha + beta * K, beta))


def _extrapolated(a: MappedRod, b: MappedRod, rod: Rod) -> _Shape:
    """Richardson's extrapolation from a rod and one with twice as many edges."""
    position = (4 * b.position[::2] - a.position) / 3
    moment = (4 * b.moments[::2] - a.moments) / 3
    angle = (4 * _nodal(b)[::2] - _nodal(a)) / 3
    K = (4 * b.stiffness[::2] - a.stiffness) / 3
    s = np.linspace(0, (4 * b.length - a.length) / 3, K.size)
    kappa_0 = np.broadcast_to(np.asarray(rod.natural_curvature, dtype=float) * rod.length, rod.s.shape)
    kappa_0 = np.interp(s / s[-1], rod.s / rod.length, kappa_0)
    kappa = moment / K + kappa_0
    bends, (start, end) = _zeros(s, moment / K), rod.supports.ends
    # the zero of an end that is free to turn is counted once, at that end
    bends = bends[
        (start.angle | (bends > _SAME_LENGTHS * s[-1])) & (end.angle | (bends < (1 - _SAME_LENGTHS) * s[-1]))
    ]
    bends = np.concatenate([s[:1][: not start.angle], bends, s[-1:][: not end.angle]])
    return _Shape(s, position, angle, kappa, K, kappa_0, bends, rod.length)


def _nodal(rod: MappedRod) -> FloatArray:
    """Angles at the nodes: the ends', and the mean of the two edges that meet."""
    inner = (rod.angles[:-1] + rod.angles[1:]) / 2
    return np.concatenate([rod.all_angles[:1], inner, rod.all_angles[-1:]])


def _zeros(s: FloatArray, kappa: FloatArray) -> FloatArray:
    """Arc lengths where kappa - kappa_0 changes sign, not at the very ends."""
    from scipy.interpolate import make_interp_spline
    from scipy.optimize import brentq

    spline = make_interp_spline(s, kappa, k=5)
    where = np.flatnonzero(kappa[:-1] * kappa[1:] < 0)
    return np.array([brentq(spline, s[i], s[i + 1], xtol=1e-15) for i in where])


def _fitted(shape: _Shape, edges: FloatArray) -> PlaneCurve:
    """Least squares for position and curvature over given knots, exact at the ends and the inflections.

    At an inflection also the slope of the curvature is met, which is what the stiffness there is made of.
    """
    from scipy.interpolate import BSpline

    knots = np.concatenate([np.full(DEGREE, edges[0]), edges, np.full(DEGREE, edges[-1])])
    spline = BSpline(knots, np.eye(edges.size - 1 + DEGREE), DEGREE)
    gauss, share = np.polynomial.legendre.leggauss(5)
    half = np.diff(edges)[:, None] / 2
    s = (edges[:-1, None] + half + half * gauss).ravel()
    root = np.sqrt(half * share)
    position, angle, kappa = shape.at(s)
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    typical = float(np.sqrt(np.mean(kappa**2))) + 1e-6
    w = root.ravel() * _REACH_LENGTHS**2 * typical / (np.abs(kappa) + 0.1 * typical)
    A = np.vstack([root.ravel()[:, None] * spline(s), w[:, None] * spline(s, 2)])
    B = np.vstack([root.ravel()[:, None] * position, (w * kappa)[:, None] * normal])
    ends, bends = edges[[0, -1]], shape.inflections
    # beside an end or each other they leave no freedom for more than the zeros of the curvature
    apart = np.diff(np.concatenate([ends[:1], bends, ends[1:]])) > 2 * np.diff(edges).max()
    inner = bends[apart[:-1] & apart[1:]]
    there, turned, _ = shape.at(np.concatenate([ends, inner]))
    bent, rest = shape.at(bends)[1], np.interp(bends, shape.s, shape.rest)[:, None]
    along = np.column_stack([np.cos(turned), np.sin(turned)])
    across = np.column_stack([-along[2:, 1], along[2:, 0]])
    # a curvature that is not 0 depends on the speed too
    paced = inner[: inner.size * bool(np.any(rest))]
    C = np.vstack(
        [
            spline(np.concatenate([ends, inner])),
            spline(np.concatenate([ends, paced]), 1),
            spline(bends, 2),
            spline(inner, 3),
        ]
    )
    slope, kept = shape.slope(inner)[:, None], np.interp(inner, shape.s, shape.rest)[:, None]
    turns = rest * np.column_stack([-np.sin(bent), np.cos(bent)])
    D = np.vstack([there, along[: 2 + paced.size], turns, slope * across - kept**2 * along[2:]])
    return PlaneCurve(knots, _constrained_least_squares(A, B, C, D), DEGREE)


def _constrained_least_squares(A: FloatArray, B: FloatArray, C: FloatArray, D: FloatArray) -> FloatArray:
    """X that minimises |A X - B| subject to C X = D; A^T A has the band of the splines."""
    from scipy.linalg import cho_solve_banded, cholesky_banded

    m = A.shape[1]
    both = np.hstack([A, B])
    joined = both.T @ both
    band = np.zeros((DEGREE + 1, m))
    for k in range(DEGREE + 1):
        band[k, : m - k] = np.diagonal(joined[:m, :m], -k)
    band[0] += 1e-14 * band[0].max()  # far from small enough to show, enough for rounding
    factor = cholesky_banded(band, lower=True)
    size = np.linalg.norm(C, axis=1)[:, None]
    C, D = C / size, D / size
    X = cho_solve_banded((factor, True), joined[:m, m:])
    Y = cho_solve_banded((factor, True), C.T)
    schur = C @ Y
    for _ in range(3):
        X = X + Y @ np.linalg.solve(schur, D - C @ X)
    return np.asarray(X)


def _errors(curve: PlaneCurve, shape: _Shape) -> FloatArray:
    """The worst error at the stations, in tolerances: of position, of the stiffness that the curve asks
    for, and, stricter, of its extremes."""
    s, kappa, K = shape.s, shape.curvature - shape.rest, shape.stiffness
    off = np.hypot(*(curve.evaluate(s) - shape.position).T) * shape.size / TOLERANCE_MM
    near = np.abs(kappa) < UNBENT_SHARE * np.abs(kappa).max()
    with np.errstate(divide="ignore", invalid="ignore"):
        asked = np.where(near, K, K * kappa / (curve.curvature_at(s) - shape.rest))
    beyond = np.maximum(asked / shape.stiffness.max() - 1, 1 - asked / shape.stiffness.min()) / FAITHFUL
    beyond = np.where(asked > 0, beyond, np.inf)
    return np.asarray(np.nan_to_num(np.maximum.reduce([off, beyond, np.abs(asked / K - 1) / LOOSE]), nan=0.0))


def _in_millimetres(curve: PlaneCurve, rod: Rod) -> PlaneCurve:
    return PlaneCurve(curve.knots * rod.length, curve.control_points * rod.length + rod.position[0], DEGREE)
