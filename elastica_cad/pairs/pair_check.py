"""Theorem 1 for two curves: conditions for a strip, of any natural curvature, with both curves as rest shapes.

In both states, the moments M_i of a strip that is held at its ends are affine functions of the position gamma_i
(paper, Eq. 3),

    K (kappa_1 - kappa_0) = M_1 = a_1 + <b_1, gamma_1>,    K (kappa_2 - kappa_0) = M_2 = a_2 + <b_2, gamma_2>,

with stiffness K, curvatures kappa_i and natural curvature kappa_0. It follows that K d = N with d = kappa_1 -
kappa_2 and N = M_1 - M_2. The parameters of N are a number and two vectors. A positive K exists if and only if
some N has the sign of d everywhere, and the same zeros with the same orders. Then kappa_0 = kappa_1 - M_1 / K.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray
from elastica_cad.errors import Change, FieldName, InputError, Length, note
from elastica_cad.geometry.plane_curve import CurvatureZero, PlaneCurve
from elastica_cad.geometry.plane_points import left_of, norm, unit, unit_vectors
from elastica_cad.geometry.polynomials import LEFT, RIGHT, PanelFunction, in_panels
from elastica_cad.mechanics.loads import CurveOfRest, ExcessCurvature
from elastica_cad.mechanics.moment_conditions import (
    WIDEST_RATIO,
    StiffnessFamily,
    find_violations,
    least_ratio,
    null_space,
    stretches,
    vanishing_at_zeros,
)
from elastica_cad.mechanics.quadrature_panels import Panels, cut_into_panels
from elastica_cad.mechanics.theorem1 import (
    AT_END_SHARE,
    PairCheck,
    PairZero,
    faint_places,
    lengths,
    require_bendable,
)
from elastica_cad.pairs.matching import scaled_to_length

SAME_CLAMPS = 1e-3
"""Tolerance for equal clamps: for distances as a fraction of the length, and for angles in rad."""

CONGRUENT_SHARE = 1e-7
"""Curves are congruent if their difference of curvature is below this fraction of the largest curvature."""

FAINT_SHARE = 1e-9
"""A difference of curvature inside a curve counts as zero below this fraction of the largest difference."""

GENTLE_SHARE = 1e-7
"""Slope of the curvature difference at a zero, below which the zero counts as a zero of higher order.

The slope is a fraction of the largest difference divided by the length. At a zero of order 1, the width of the
strip is proportional to the inverse of the slope, and would be too large."""

DEPENDENT_SHARE = 1e-8
"""Functions count as linearly dependent if a singular value of their samples is relatively at most this."""

NUMBERS = 6
"""Number of parameters of the moments M_1 and M_2: a_1 - a_2, the vectors b_1 and b_2 with two numbers each, a_1.

The first five numbers determine the difference N = M_1 - M_2."""


def check_pair(first: PlaneCurve, second: PlaneCurve) -> PairCheck:
    """Check whether a strip that is held at its ends can have two curves as rest shapes.

    Parameters
    ----------
    first, second : PlaneCurve
        Curves, mm. The relative difference of their lengths is at most 1e-4 (`matched_pair` makes them equal).
        The second curve is scaled to the length of the first.

    Returns
    -------
    PairCheck
        Result; its `str()` states why and where no strip is possible.

    References
    ----------
    Paper, Theorem 1, with the difference of two curvatures instead of the curvature.

    Examples
    --------
    >>> flat = PlaneCurve.spline([(0, 0), (30, 4), (70, 4), (100, 0)], degree=3)
    >>> check_pair(flat, flat.transformed(np.diag([1.0, -1.0, 1.0]))).realizable
    True
    """
    return examine_pair(first, second)[0]


def examine_pair(
    first: PlaneCurve, second: PlaneCurve
) -> tuple[PairCheck, "PairedPanels | None", FloatArray | None]:
    """Return the check, the panels, and the parameters that select the stiffness with the least ratio.

    The ratio is the largest stiffness divided by the least. The parameters are those of `PairedPanels.family`. The
    panels and the parameters are None if no strip is possible, or if every stiffness is possible.
    """
    for curve in (first, second):
        require_bendable(curve)
        if curve.is_closed:
            raise InputError(
                "A strip with two states needs two ends, but a closed curve has no ends. Open the curve."
            )
    # `matched_pair` reduces larger differences
    if abs(second.length / first.length - 1) > 1e-4:
        raise InputError(
            "the first curve is {first:.6g} long, the second {second:.6g}, but the strip has the "
            'same length in both. Set {field} to "ends".',
            first=Length(first.length),
            second=Length(second.length),
            field=FieldName("match"),
            changes=[Change("match", "ends")],
        )
    second = scaled_to_length(second, first.length)
    difference = ExcessCurvature(first, CurveOfRest.of(second))
    (chord, turn), (other, other_turn) = map(_clamps_of, (first, second))
    fits = norm(chord - other) <= SAME_CLAMPS * first.length and abs(turn - other_turn) <= SAME_CLAMPS
    check = PairCheck(
        realizable=True, reasons=(), length=first.length, first=first, second=second, bistable=bool(fits)
    )
    largest = float(np.abs(difference.survey).max())
    if largest <= CONGRUENT_SHARE * np.abs(first.survey.curvature).max(initial=1 / first.length):
        return replace(check, any_stiffness=True), None, None
    crossings = difference.zeros
    flats = tuple((z.s, z.s_end) for z in crossings if _is_stretch(first, z))
    zeros = _with_orders(difference, crossings, largest)
    unmet = tuple(z for z in zeros if not _can_be_met(first, z))
    check = replace(check, zeros=zeros, flats=flats, unmet=unmet)
    if flats or unmet:
        same = [
            note(
                "Both curves have the same curvature from {start} to {end}, so the stiffness beside this piece "
                "would have to be 0. Draw one of the curves with a little more curvature there. Two curves with "
                "the same curvature everywhere are also possible.",
                start=Length(start), end=Length(end),
            )
            for start, end in flats
        ]  # fmt: skip
        return _refused(check, *same, *_unmet_messages(unmet)), None, None
    paired = PairedPanels.of(check, difference)
    if paired.family.freedom == 0:
        too_many = note(
            "Both curves have the same curvature at too many places: {places}. For two equal or mirrored "
            "curves, usually at most two such places are possible. Change one curve so that the curvatures "
            "differ at {beyond}."
            if paired.rank < NUMBERS - 1
            else "Both curves have the same curvature at too many places: {places}. Usually at most four such "
            "places are possible. Change one curve so that the curvatures differ at {beyond}.",
            places=lengths(z.s for z in check.zeros),
            beyond=Length(paired.beyond[0].s),
        )
        return _refused(replace(check, unmet=paired.beyond), too_many), None, None
    answer = paired.least_ratio()
    if answer is None:
        against = find_violations(paired.family)
        reason = note(
            "No part can rest in both curves, because the moment near {places} would bend the part to the "
            "other side. Change one of the curves there, or draw the curves closer to each other."
            if against.size
            else "No part can rest in both curves, because the moment would bend the part to the other side. "
            "Draw the curves closer to each other.",
            places=stretches(against, check.length),
        )
        return _refused(replace(check, against=tuple(against.tolist())), reason), None, None
    return check, paired, answer


def _clamps_of(curve: PlaneCurve) -> tuple[FloatArray, float]:
    """Return the end (2,), mm, relative to the start and its tangent, and the total turning of the tangent, rad."""
    ends = curve.at(np.array([0.0, curve.length]))
    along = unit_vectors(ends.angle[0])
    chord = np.array([along, left_of(along)]) @ (ends.position[1] - ends.position[0])
    return chord, float(ends.angle[1] - ends.angle[0])


def _is_stretch(curve: PlaneCurve, zero: CurvatureZero) -> bool:
    """Return True if the curvatures are equal on too long a piece to count as a zero of high order."""
    return zero.kind == "flat" and zero.s_end - zero.s > 0.01 * curve.length


def _with_orders(
    difference: ExcessCurvature, crossings: Sequence[CurvatureZero], largest: float
) -> tuple[PairZero, ...]:
    """Return the zeros of the curvature difference with their orders.

    Zeros near an end are moved to the end, and close zeros are merged.
    """
    curve, zeros = difference.curve, list[PairZero]()
    for z in crossings:
        if _is_stretch(curve, z):
            continue
        end = min((0.0, curve.length), key=lambda s: abs(s - z.s))
        if abs(end - z.s) <= AT_END_SHARE * curve.length:
            zeros.append(_at_end(difference, end, largest))
            continue
        slope = min(abs(float(difference.slope_at(z.t, left=left))) for left in (True, False))
        gentle = slope * curve.length <= GENTLE_SHARE * largest
        # a simple zero with a gentle slope counts as order 3, and a short equal piece as a zero of order 2 or 3
        order = {"jump": 0, "touch": 2, "flat": 3 if z.changes_sign else 2}.get(z.kind, 3 if gentle else 1)
        before = zeros[-1] if zeros else None
        # two simple zeros between which the difference is faint are one double zero
        if before and order == before.order == 1 and before.before:
            middle = (before.s + z.s) / 2
            t = float(curve.parameter(middle))
            if abs(difference.at(t)) <= FAINT_SHARE * largest:
                zeros[-1] = PairZero(middle, t, 2, before.before, z.after)
                continue
        s = (z.s + z.s_end) / 2
        zeros.append(PairZero(s, float(curve.parameter(s)), order, z.before, z.after))
    for s in faint_places(difference, largest, crossings, FAINT_SHARE):
        t = float(curve.parameter(s))
        sign = int(np.sign(difference.at(t)))
        zeros.append(PairZero(s, t, 2, sign, sign))
    for end in (0.0, curve.length):  # a zero computed near an end may be slightly beyond the end
        if all(z.s != end for z in zeros):
            t = curve.domain[int(end > 0)]
            value, slope = (abs(float(along(t))) for along in (difference.at, difference.slope_at))
            if value <= AT_END_SHARE * min(curve.length * slope, largest):
                zeros.append(_at_end(difference, end, largest))
    return tuple(sorted(zeros, key=lambda z: z.s))


def _at_end(difference: ExcessCurvature, s: float, largest: float) -> PairZero:
    """Return the zero of the curvature difference at an end; a gentle slope makes it a double zero.

    `s` is 0 or the length, mm, and `largest` is the largest curvature difference.
    """
    curve = difference.curve
    t = curve.domain[int(s > 0)]
    slope = difference.slope_at(t, left=s > 0)
    # the sign beside the end
    beside = float(difference.at(curve.parameter(abs(s - 1e-4 * curve.length))))
    sign = int(np.sign(beside))
    order = 2 if abs(slope) * curve.length <= GENTLE_SHARE * largest else 1
    return PairZero(s, t, order, sign if s > 0 else 0, 0 if s > 0 else sign)


def _can_be_met(first: PlaneCurve, zero: PairZero) -> bool:
    """Return True if the moment difference N can have a zero of the same order as the curvature difference.

    With tangents T_i, N' = <b_1, T_1> - <b_2, T_2>. At a zero, N'' = kappa (<b_1, n_1> - <b_2, n_2>) with the
    normals n_i and the common curvature kappa, so a double zero is possible where the curves are bent. If N''
    is zero too, the order of N is too large by two.
    """
    if zero.order == 2:
        bent = float(first.curvature_at(zero.t))
        return abs(bent) > CONGRUENT_SHARE * float(np.abs(first.survey.curvature).max())
    return zero.order == 1


def _refused(check: PairCheck, *reasons: str) -> PairCheck:
    return replace(check, realizable=False, reasons=reasons)


def _unmet_messages(unmet: Sequence[PairZero]) -> Iterable[str]:
    what = {
        0: "At {places} a curvature jumps past the curvature of the other curve, which no part can follow. "
        "Make the curvature continuous there, as in a spline.",
        2: "At {places} the curvatures are both 0 and touch without crossing. There the moments cannot differ "
        "in the same way (order 4, not 2). Bend both curves there, or let their curvatures differ.",
        3: "At {places} the curvatures cross with equal slopes. There the moments cannot differ in the same "
        "way (order 5, not 3). Let the curvature of one curve change faster there.",
    }
    for order, words in what.items():
        at = [z.s for z in unmet if z.order == order]
        if at:
            yield note(words, places=lengths(at))


@dataclass(frozen=True, eq=False)
class PairedPanels:
    """Moments of two states along both curves, as linear functions of six numbers.

    The numbers are a_1 - a_2, b_1, b_2 and a_1 (symbols: see the docstring of the module), with the vectors b
    multiplied by the length. Positions are measured from the panel end in the middle. The curves have N panels with
    p nodes each.

    Attributes
    ----------
    check : PairCheck
    panels : Panels
        Panels of the first curve; their `curvature` is d = kappa_1 - kappa_2.
    moments : tuple of (N, p, 6) arrays
        Coefficients of the moments M_1 and M_2 at the nodes.
    stiffness : (N, p, 5) array
        Coefficients of the stiffness K = N / d, as a linear function of the first five numbers.
    conditions : (k, 5) array
        Rows of conditions rows @ numbers = 0: N at the zeros of d, and N' at the double zeros.
    """

    check: PairCheck
    panels: Panels
    moments: tuple[FloatArray, FloatArray]
    stiffness: FloatArray
    conditions: FloatArray

    @classmethod
    def of(cls, check: PairCheck, difference: ExcessCurvature) -> "PairedPanels":
        """Return the coefficients of two curves. Zeros of the curvature difference d are at ends of
        panels."""
        zeros, first, second, size = check.zeros, check.first, check.second, check.length
        panels = cut_into_panels(
            first, [z.t for z in zeros], cuts=[t for t, _, _ in difference.kinks],
            natural_curvature=difference.rest, orders=[z.order for z in zeros],
        )  # fmt: skip
        stretch = panels.stretch[..., None]
        s = panels.s.clip(0.0, second.length)
        tangent = second.evaluate(second.parameter(s), 1)
        along = unit(tangent) * stretch
        edge = second.evaluate(second.parameter(panels.edge_s.clip(0.0, second.length)))
        from_left = (panels.from_left, in_panels(LEFT, along))
        from_right = (panels.from_right, -in_panels(RIGHT, along))
        # positions of the panel ends on both curves, and the coefficients (N + 1, 5) of N there
        edges = [(x - x[len(x) // 2]) / size for x in (panels.edge_position, edge)]
        rows = _rows(np.ones(edges[0].shape[:1]), *edges)
        at = np.array([np.abs(panels.edges - z.t).argmin() for z in zeros], dtype=int)
        double = np.array([z.order == 2 for z in zeros], dtype=bool)
        places = [np.clip(panels.edge_s[at], 0.0, curve.length) for curve in (first, second)]
        turns = [unit_vectors(curve.at(s).angle) for curve, s in zip((first, second), places, strict=True)]
        conditions = np.concatenate(
            [rows[at], _rows(np.zeros(int(double.sum())), *(turn[double] for turn in turns))]
        )
        # N at a node is N at the nearer end of its panel (0 at a zero of N) plus the change from there
        vanishing = vanishing_at_zeros(panels, rows)
        left = panels.zero_left
        base = np.where(left[:, None], vanishing[:-1], vanishing[1:])
        step = [
            np.where(left[:, None, None], a, b) / size for a, b in zip(from_left, from_right, strict=True)
        ]
        far = np.where(left[:, None], panels.stretch @ LEFT.T, -(panels.stretch @ RIGHT.T)) / size
        near = np.arange(panels.count) + ~left  # index of the panel end from which N is computed
        for place, turn in zip(at[double], zip(*(turn[double] for turn in turns), strict=True), strict=True):
            beside_zero = (near == place) & (panels.zero_left | panels.zero_right)
            for row, tangent_there in zip(step, turn, strict=True):  # N' is also 0 at a double zero of N
                row[beside_zero] -= far[beside_zero, :, None] * tangent_there
        difference_rows = base[:, None, :] + _rows(np.zeros(far.shape), *step)
        moments = np.zeros((2, *far.shape, NUMBERS))
        moments[..., -1], moments[1, ..., 0] = 1.0, -1.0
        moments[0, ..., 1:3], moments[1, ..., 3:5] = (
            end[:-1, None] + a / size for end, a in zip(edges, from_left, strict=True)
        )
        first_moment, second_moment = moments
        stiffness = difference_rows / panels.curvature[..., None]
        return cls(check, panels, (first_moment, second_moment), stiffness, conditions)

    @property
    def stiffness_rows(self) -> FloatArray:
        """Coefficients (N, p, 6) of the stiffness, as a linear function of all six numbers."""
        return np.pad(self.stiffness, ((0, 0), (0, 0), (0, 1)))

    @cached_property
    def basis(self) -> FloatArray:
        """Basis (5, q) of the solutions of `conditions`, except for solutions that do not change the stiffness."""
        return self._split[0]

    @cached_property
    def idle(self) -> FloatArray:
        """Columns (6, r), each with six numbers that satisfy `conditions` and do not change the stiffness."""
        none = np.pad(self._split[1], ((0, 1), (1, 0)))
        none[-1, 0] = 1.0
        return none

    @cached_property
    def solutions(self) -> FloatArray:
        """Columns (6, q + r), each with six numbers that satisfy `conditions`: `basis` and `idle`."""
        return np.concatenate([np.pad(self.basis, ((0, 1), (0, 0))), self.idle], axis=1)

    @cached_property
    def _split(self) -> tuple[FloatArray, FloatArray]:
        """Bases of the numbers that satisfy the conditions: those that change the stiffness, and the others."""
        free = null_space(self.conditions)
        if not free.shape[1]:
            return free, free
        _, sigma, vt = svd(PanelFunction.through(self.stiffness @ free).dense, full_matrices=False)
        rank = int(np.count_nonzero(sigma > DEPENDENT_SHARE * sigma[0]))
        # without a stiffness that satisfies the conditions, the product consists of rounding errors
        is_free = np.abs(self._difference @ free).max(initial=0.0) > CONGRUENT_SHARE
        return (free @ vt[:rank].T, free @ vt[rank:].T) if is_free else (free[:, :0], free)

    @property
    def _difference(self) -> FloatArray:
        """Coefficients (nodes, 5) of the moment difference as a linear function of the first five numbers."""
        return (self.stiffness * self.panels.curvature[..., None]).reshape(-1, NUMBERS - 1)

    @cached_property
    def rank(self) -> int:
        """Dimension of the space of moment differences: five, or three for congruent or mirrored curves."""
        return int(np.linalg.matrix_rank(self._difference, DEPENDENT_SHARE * np.sqrt(len(self._difference))))

    @cached_property
    def beyond(self) -> tuple[PairZero, ...]:
        """Last zeros of the curvature difference, from the first that no moment difference can share.

        A moment difference can have all zeros before this zero, but not this zero too.
        """
        for count in range(1, len(self.check.zeros) + 1):
            free = null_space(self.conditions[:count])
            if not free.shape[1] or np.abs(self._difference @ free).max() <= CONGRUENT_SHARE:
                return self.check.zeros[count - 1 :]
        return self.check.zeros[-1:]

    @cached_property
    def family(self) -> StiffnessFamily:
        """All stiffnesses that satisfy the conditions, as functions of free parameters (q,)."""
        return StiffnessFamily.through(self.panels, self.stiffness @ self.basis)

    def least_ratio(self, family: StiffnessFamily | None = None) -> FloatArray | None:
        """Return the parameters of the stiffness with the least ratio of largest to least value.

        Return None if no stiffness in the family is positive everywhere. The default is `self.family`.
        """
        family = family or self.family
        sizes = np.abs(family.dense[:, :-1]).sum(axis=1)
        if not sizes.max() < WIDEST_RATIO * sizes.min():
            return None
        result = least_ratio(family)
        return None if result is None else result[0]


def _rows(number: FloatArray, first: FloatArray, second: FloatArray) -> FloatArray:
    # coefficients (..., 5) of N by a_1 - a_2, b_1 and b_2, at positions (..., 2) on the first and the second curve
    return np.concatenate([number[..., None], first, -second], axis=-1)
