"""Random pairs of curves, and independent checks of a pair: dense programs, eigenvalues, Runge-Kutta."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.integrate import cumulative_trapezoid, solve_ivp
from scipy.interpolate import BSpline, CubicSpline
from scipy.linalg import eigh, null_space
from scipy.optimize import brentq, least_squares, linprog

from elastica_cad import PlaneCurve, Rod

STATIONS = np.linspace(0, 1, 401)


def drawn_pairs(seed: int, count: int, modes: int, *, same_clamps: bool, bend: float = 2.0) -> Iterator:
    """Yield `count` pairs of points (401, 2) of curves of length 1, with random curvatures of `modes` modes."""
    rng = np.random.default_rng(seed)
    while count:
        if (pair := _drawn_pair(rng, modes, same_clamps, bend)) is not None:
            count -= 1
            yield pair


def _drawn_pair(rng, modes: int, same_clamps: bool, bend: float):
    functions = np.array(
        [np.ones(STATIONS.size)]
        + [f(j * np.pi * STATIONS) for j in range(1, modes + 1) for f in (np.cos, np.sin)]
    ).T
    scale = bend / np.r_[1, np.repeat(np.arange(1, modes + 1), 2)]
    first, second = (rng.normal(size=functions.shape[1]) * scale for _ in range(2))
    angle, points = _shape(functions @ first)
    if same_clamps:

        def miss(numbers):
            a, p = _shape(functions @ numbers)
            return np.r_[np.r_[a[-1] - angle[-1], p[-1] - points[-1]] * 1e3, 1e-2 * (numbers - second)]

        second = least_squares(miss, second).x
        if np.abs(miss(second)[:3]).max() > 1e-2:
            return None
    other = _shape(functions @ second)[1]
    return None if np.abs(other - points).max() < 0.05 else (points, other)


def _shape(kappa):
    """Return angle and points of a curve of length 1 from its curvature at `STATIONS`, by the trapezoidal rule."""
    angle = cumulative_trapezoid(kappa, STATIONS, initial=0)
    along = np.column_stack([np.cos(angle), np.sin(angle)])
    return angle, cumulative_trapezoid(along, STATIONS, axis=0, initial=0)


@dataclass(frozen=True)
class SampledCurve:
    """A spline by scipy alone: parameters from a table of arc lengths, curvature from derivatives."""

    spline: BSpline
    t: CubicSpline
    length: float

    @classmethod
    def of(cls, curve: PlaneCurve) -> "SampledCurve":
        # scipy 1.10 evaluates no read-only arrays
        spline = BSpline(np.array(curve.knots), np.array(curve.control_points), curve.degree)
        edges = np.unique(np.clip(curve.knots, *curve.domain))
        x, w = np.polynomial.legendre.leggauss(12)
        fine = np.unique(np.concatenate([np.linspace(a, b, 17) for a, b in pairwise(edges)]))
        half = np.diff(fine)[:, None] / 2
        speed = np.hypot(*np.moveaxis(spline((fine[:-1, None] + half * (1 + x)), 1), -1, 0))
        s = np.concatenate([[0], np.cumsum((speed * half) @ w)])
        return cls(spline, CubicSpline(s, fine), float(s[-1]))

    def at(self, s):
        """Return position (n, 2), tangent (n, 2) and curvature (n,) at arc lengths."""
        t = self.t(s)
        position, d1, d2 = (self.spline(t, k) for k in (0, 1, 2))
        speed = np.hypot(*d1.T)
        return position, d1 / speed[:, None], (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]) / speed**3


@dataclass(frozen=True)
class DensePair:
    """Rows of N at samples (with d) and at the zeros of d, for two curves of equal length."""

    rows: np.ndarray
    d: np.ndarray
    at_zeros: np.ndarray
    zeros: np.ndarray

    @classmethod
    def of(cls, first: PlaneCurve, second: PlaneCurve, samples: int = 2001) -> "DensePair":
        a, b = SampledCurve.of(first), SampledCurve.of(second)
        scale = a.length / b.length

        def difference(s):
            s = np.atleast_1d(s)
            return a.at(s)[2] - b.at(s / scale)[2] / scale

        def row(s):
            s = np.atleast_1d(s)
            middle = np.array([a.length / 2])
            x = (a.at(s)[0] - a.at(middle)[0]) / a.length
            y = (b.at(s / scale)[0] - b.at(middle / scale)[0]) * scale / a.length
            return np.column_stack([np.ones(s.size), x, -y])

        s = np.linspace(0, a.length, samples)
        d = difference(s)
        zeros = np.array(
            [brentq(lambda x: float(difference(x)[0]), s[i], s[i + 1], xtol=1e-13 * a.length)
             for i in np.flatnonzero(d[:-1] * d[1:] < 0)]
        )  # fmt: skip
        return cls(row(s), d * a.length, row(zeros) if zeros.size else np.zeros((0, 5)), zeros)

    def free(self):
        """Return the vectors (5, q) whose N vanishes at the zeros of d."""
        return null_space(self.at_zeros, rcond=1e-10) if len(self.at_zeros) else np.eye(5)

    def best(self) -> float:
        """Return the largest possible minimum of N / d at a mean of 1, or -1 if there is no solution."""
        free = self.free()
        if free.shape[1] == 0:
            return -1.0
        K = self.rows @ free / self.d[:, None]
        best = -1.0
        A = np.column_stack([-K, np.ones(len(K))])
        mean = np.append(K.mean(axis=0), 0.0)[None]
        result = linprog(-np.eye(A.shape[1])[-1], A, np.zeros(len(A)), mean, [1.0], bounds=(None, None))
        return float(result.x[-1]) if result.status == 0 else best

    def least_ratio(self) -> float:
        """Return R of d^2 <= N d <= R d^2."""
        free = self.free()
        K = self.rows @ free / self.d[:, None]
        ones, none = np.ones(len(K)), np.zeros(len(K))
        A = np.concatenate([np.column_stack([-K, none]), np.column_stack([K, -ones])])
        result = linprog(
            np.eye(A.shape[1])[-1], A, np.concatenate([-ones, none]), bounds=(None, None), method="highs"
        )
        return float(result.x[-1])


def astray(rod: Rod, pieces: int = 8) -> float:
    """Return the deviation, in lengths, of an integration by first moment, force, stiffness and natural curvature.

    The integration is split into pieces that start on the rod, because a held strip may be very sensitive to its
    start.
    """
    K, rest = (
        CubicSpline(rod.s, np.broadcast_to(v, rod.s.shape)) for v in (rod.stiffness, rod.natural_curvature)
    )
    b = np.array([rod.force[0, 1], -rod.force[0, 0]])  # lambda = R b

    def slope(s, state):
        moment = rod.moment[0] + b @ (state[:2] - rod.position[0])
        return [np.cos(state[2]), np.sin(state[2]), moment / K(s) + rest(s)]

    missed = 0.0
    for one in np.array_split(np.arange(rod.s.size - 1), pieces):
        nodes = np.append(one, one[-1] + 1)
        start = [*rod.position[nodes[0]], rod.angle[nodes[0]]]
        s = rod.s[nodes]
        found = solve_ivp(slope, (s[0], s[-1]), start, t_eval=s, rtol=1e-11, atol=1e-11 * rod.length)
        missed = max(missed, float(np.hypot(*(found.y[:2].T - rod.position[nodes]).T).max()))
    return missed / rod.length


def dense_margin(rod: Rod, elements: int = 400) -> float:
    """Return the lowest eigenvalue of the second variation between clamps, times length squared.

    The finite elements are linear. A null space keeps the ends in place.
    """
    s = np.linspace(0, rod.length, elements + 1)
    h = s[1]
    middle = (s[1:] + s[:-1]) / 2
    angle = CubicSpline(rod.s, rod.angle)(middle)
    K = CubicSpline(rod.s, rod.stiffness)(middle)
    load = rod.force[0] @ np.array([np.cos(angle), np.sin(angle)])
    n = elements + 1
    stiff, mass, normal = np.zeros((n, n)), np.zeros((n, n)), np.zeros((2, n))
    shape = h / 6 * np.array([[2.0, 1.0], [1.0, 2.0]])
    for i in range(elements):
        own = np.s_[i : i + 2]
        stiff[own, own] += K[i] / h * np.array([[1, -1], [-1, 1]]) - load[i] * shape
        mass[own, own] += shape
        normal[:, own] += h / 2 * np.array([[-np.sin(angle[i])], [np.cos(angle[i])]])
    inner = np.s_[1:-1]
    free = null_space(normal[:, inner])
    A, B = (free.T @ m[inner, inner] @ free for m in (stiff, mass))
    return float(eigh(A, B, eigvals_only=True, subset_by_index=[0, 0])[0]) * rod.length**2
