"""Smallest change of two drawn curves to equal lengths, so that both can be rest shapes of one strip."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil, log, sqrt
from typing import Literal

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of
from elastica_cad.errors import FieldName, InputError, Length, NotConvergedError, note
from elastica_cad.geometry.plane_curve import PlaneCurve, integrate_tangents
from elastica_cad.geometry.plane_points import left_of, norm, unit_vectors
from elastica_cad.geometry.polynomials import LEFT, NODES, WEIGHTS, PanelFunction, in_panels, locate_in_panels
from elastica_cad.mechanics.theorem1 import require_bendable

ALIKE_SHARE, ALIKE_RAD = 0.01, float(np.radians(2.0))
"""Tolerances within which the ends of two curves become equal: distance / length, and angle, rad."""

NEWTON_STEPS = 20
MET = 1e-13  # largest error of the end after Newton's method: fraction of the length (position), rad (angle)

LARGEST_TURN = 0.5
"""Largest change of the tangent direction, rad, at any point of the curve."""

EQUAL = 1e-12  # relative difference up to which lengths count as equal


@dataclass(frozen=True, eq=False)
class MatchedPair:
    """Two curves of equal length; `first, second = matched_pair(...)` unpacks them.

    Attributes
    ----------
    first, second : PlaneCurve
        Changed curves.
    moved : (float, float)
        Largest distance between corresponding points of each changed and drawn curve, mm.
    same_clamps : bool
        True if both curves have exactly the same ends and the same total turning of the tangent.
    """

    first: PlaneCurve
    second: PlaneCurve
    moved: tuple[float, float]
    same_clamps: bool

    def __iter__(self) -> Iterator[PlaneCurve]:
        return iter((self.first, self.second))

    def __str__(self) -> str:
        return note(
            "To give both curves the same length ({length}) and the same clamped ends, the first curve was "
            "moved by up to {first:.2g} and the second by up to {second:.2g}."
            if self.same_clamps
            else (
                "To give both curves the same length ({length}), the first curve was moved by up to "
                "{first:.2g} and the second by up to {second:.2g}."
            ),
            length=Length(self.first.length),
            first=Length(self.moved[0]),
            second=Length(self.moved[1]),
        )


def same_way(first: PlaneCurve, second: PlaneCurve) -> tuple[PlaneCurve, PlaneCurve]:
    """Return both curves, reversed if necessary to start at the same point or to have the same clamps.

    If reversing a curve does not help, both curves are unchanged.
    """
    for curve in (first, first.reversed()):
        for other in (second, second.reversed()):
            candidates = _Drawn.of(curve), _Drawn.of(other)
            apart = norm(candidates[0].clamps[0] - candidates[1].clamps[0])
            if apart <= ALIKE_SHARE * first.length or _are_alike(*candidates):
                return curve, other
    return first, second


def matched_pair(
    first: PlaneCurve, second: PlaneCurve, keep: Literal["ends", "shape"] = "ends"
) -> MatchedPair:
    """Return two curves with equal lengths, changed as little as possible.

    Parameters
    ----------
    first, second : PlaneCurve
        Drawn curves, mm.
    keep : "ends" or "shape"
        With "ends", each curve keeps the positions and directions of its ends. Its curvature changes by the
        smallest sufficient affine function of the position, as in a uniform elastic strip. The common length
        minimises the changes of both curves. If the ends of both curves agree after a rigid motion (within 1 % of
        the length and 2 degrees, with the same total turning), the ends become exactly equal. With "shape", each
        curve is scaled about its start.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 14), (70, 14), (100, 0)], degree=3)
    >>> flatter = PlaneCurve.spline([(0, 0), (30, -12), (70, -12), (100, 0)], degree=3)
    >>> one, other = matched_pair(arch, flatter)
    >>> abs(one.length - other.length) < 1e-6, bool(np.allclose(one.at([one.length]).position, [[100, 0]]))
    (True, True)
    """
    for curve in (first, second):
        require_bendable(curve)
        if curve.is_closed:
            raise InputError("A closed curve has no ends to hold. Open the curve.")
    if not is_one_of(keep, ("ends", "shape")):
        raise InputError(f"`keep` is {keep!r}: give 'ends' or 'shape'")
    if keep == "shape":
        length = sqrt(first.length * second.length)
        changed, other = (scaled_to_length(curve, length) for curve in (first, second))
        alike = _are_alike(_Drawn.of(changed), _Drawn.of(other), EQUAL)
    else:
        changed, other, alike = _with_equal_lengths(first, second)
    moved = _largest_displacement(first, changed), _largest_displacement(second, other)
    return MatchedPair(changed, other, moved, alike)


def _with_equal_lengths(first: PlaneCurve, second: PlaneCurve) -> tuple[PlaneCurve, PlaneCurve, bool]:
    """Return the curves changed between their ends, and True if their clamps are made equal."""
    drawn, other = _Drawn.of(first), _Drawn.of(second)
    alike = _are_alike(drawn, other)
    if alike:
        chord, angles = (drawn.chord + other.chord) / 2, (drawn.clamps[2] + other.clamps[2]) / 2
        drawn, other = (
            replace(curve, clamps=(curve.clamps[0], curve.clamps[0] + chord, angles))
            for curve in (drawn, other)
        )
    length = _least_change((drawn, other))
    return drawn.of_length(length), other.of_length(length), alike


def scaled_to_length(curve: PlaneCurve, length: float) -> PlaneCurve:
    """Return the curve scaled about its start to the given length, mm."""
    start = curve.evaluate(curve.domain[0])
    return curve.with_control_points(start + (curve.control_points - start) * (length / curve.length))


def _largest_displacement(before: PlaneCurve, after: PlaneCurve) -> float:
    if after is before:
        return 0.0
    apart = after.sample(before.survey.s.size).position - before.survey.position
    return float(norm(apart).max())


def _are_alike(first: "_Drawn", second: "_Drawn", share: float = ALIKE_SHARE) -> bool:
    """Return True if the clamps of both curves agree after a rigid motion.

    `share` is the tolerance of positions as a fraction of the length. The tolerance of angles is proportional.
    """
    size = max(first.curve.length, second.curve.length)
    apart, angles, other_angles = norm(first.chord - second.chord), first.clamps[2], second.clamps[2]
    return bool(
        apart <= share * size and np.abs(angles - other_angles).max() <= ALIKE_RAD / ALIKE_SHARE * share
    )


def _least_change(drawn: "tuple[_Drawn, _Drawn]") -> float:
    """Return the common length with the least change of curvature of both curves."""
    from scipy.optimize import minimize_scalar

    first, second = (drawn_curve.curve.length for drawn_curve in drawn)
    low, high = sorted((first, second))
    if high - low <= EQUAL * high:
        return low

    def change(length: float) -> float:
        return sum(curve.change(length) for curve in drawn)

    with np.errstate(invalid="ignore"):  # the parabola through infinite values
        best = minimize_scalar(
            change, bounds=(low, high), method="bounded", options={"xatol": 1e-4 * (high - low)}
        )
    length = min((float(best.x), low, high), key=change)
    if not np.isfinite(change(length)):
        raise InputError(
            "the curves are {first:.5g} and {second:.5g} long, and no small change of the curves "
            "between their fixed ends makes these lengths equal. Draw curves of more similar length, "
            'or scale the curves (set {field} to "shape").',
            first=Length(first),
            second=Length(second),
            field=FieldName("match"),
        )
    return length


@dataclass(frozen=True, eq=False)
class _Drawn:
    """Drawn curve, and its required clamps: start (2,), end (2,) and both end angles (2,).

    At the fraction u of the length, the tangent turns by the angle c + alpha u + <beta, integral of the position
    up to u>. c is the turn at the start, and alpha and beta (2,) are unknowns.
    """

    curve: PlaneCurve
    clamps: tuple[FloatArray, FloatArray, FloatArray]

    @classmethod
    def of(cls, curve: PlaneCurve) -> "_Drawn":
        ends = curve.at(np.array([0.0, curve.length]))
        return cls(curve, (ends.position[0], ends.position[1], ends.angle))

    @property
    def chord(self) -> FloatArray:
        return self.clamps[1] - self.clamps[0]

    @cached_property
    def _nodes(self) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]:
        """Quadrature nodes of the curve, and derivatives by the three unknowns: alpha, and the vector beta.

        The arrays, for N panels with p nodes each, are:

        - edges of panels (N + 1,), as fractions of the length;
        - weights (N p,) and angles of the tangent (N p,) at the nodes;
        - derivatives (N p, 3) of the curvature at the nodes;
        - derivatives (N p + 1, 3) of the angle at the nodes and at the end.
        """
        curve = self.curve
        edges = curve.arc_length(curve.smooth_panels) / curve.length
        half = np.diff(edges)[:, None] / 2
        u = edges[:-1, None] + half * (1 + NODES)
        at = curve.at((u * curve.length).ravel())
        middle = at.position.mean(axis=0)
        functions = np.column_stack([np.ones(at.s.size), (at.position - middle) / curve.length])
        functions = functions.reshape(*u.shape, 3)
        inside = in_panels(LEFT, functions * half[..., None])
        reached = np.einsum("np,npk->nk", WEIGHTS * half, functions).cumsum(axis=0)
        before = np.concatenate([np.zeros((1, 3)), reached[:-1]])
        turns = np.concatenate([(before[:, None] + inside).reshape(-1, 3), reached[-1:]])
        return edges, (WEIGHTS * half).ravel(), at.angle, functions.reshape(-1, 3), turns

    def numbers(self, length: float) -> FloatArray | None:
        """Return alpha and beta (3,) for a given length, or None if no small change reaches the clamps."""
        _, weight, angle, _, turns = self._nodes
        drawn, (_, _, angles) = _Drawn.of(self.curve), self.clamps
        drawn_angles, numbers = drawn.clamps[2], np.zeros(3)
        # Newton's method approaches the new length in steps of at most 2 %
        steps = max(1, ceil(abs(log(length / self.curve.length)) / 0.02))
        for k in range(1, steps + 1):
            share = k / steps
            size = self.curve.length * (length / self.curve.length) ** share
            held = drawn_angles + share * (angles - drawn_angles)
            chord = drawn.chord + share * (self.chord - drawn.chord)
            for _ in range(NEWTON_STEPS):
                tangent = unit_vectors(angle + (held[0] - drawn_angles[0]) + turns[:-1] @ numbers)
                missed = np.append(
                    weight @ tangent - chord / size,
                    turns[-1] @ numbers - (held[1] - held[0] - drawn_angles[1] + drawn_angles[0]),
                )
                if np.abs(missed).max() <= MET:
                    break
                slope = np.concatenate([(weight[:, None] * left_of(tangent)).T @ turns[:-1], turns[-1:]])
                try:
                    numbers = numbers - np.linalg.solve(slope, missed)
                except np.linalg.LinAlgError:
                    return None
                if not np.abs(turns @ numbers).max() <= LARGEST_TURN:
                    return None
            else:
                return None
        return numbers

    def change(self, length: float) -> float:
        """Return the integral of the squared change of curvature, times the length.

        The result is infinite if no small change reaches the clamps.
        """
        numbers = self.numbers(length)
        if numbers is None:
            return np.inf
        _, weight, _, functions, _ = self._nodes
        return float((functions @ numbers) ** 2 @ weight)

    def of_length(self, length: float) -> PlaneCurve:
        """Return the curve of this length, mm, with the least change of curvature between its fixed ends."""
        numbers = self.numbers(length)
        if numbers is None:
            raise NotConvergedError(
                f"no small change of the curve leads to the length {length:.5g} mm: draw curves of more similar "
                "length"
            )
        start, _, angles = self.clamps
        curve = self.curve
        drawn_start, _, drawn_angles = _Drawn.of(curve).clamps
        if not numbers.any() and np.array_equal(start, drawn_start) and angles[0] == drawn_angles[0]:
            return curve
        scale = curve.length / length
        edges, *_, turns = self._nodes
        turn = PanelFunction.through(turns[:-1].reshape(-1, NODES.size, 3) @ numbers)

        def tangent(s: FloatArray) -> FloatArray:
            theta = curve.at(np.minimum(s * scale, curve.length)).angle + (angles[0] - drawn_angles[0])
            theta = theta + turn.at(*locate_in_panels(edges, s / length))
            return unit_vectors(theta)

        breaks = [(jump.s / scale, jump.continuity - 1) for jump in curve.breaks]
        # the end is off by at most this fraction of the length
        return integrate_tangents(tangent, length, start, tolerance=1e-9, breaks=breaks)
