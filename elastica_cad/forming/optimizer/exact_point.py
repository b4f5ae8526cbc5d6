"""The end of a search: what is missed by little is put right to rounding."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.forming.optimizer.dense_solves import least_step
from elastica_cad.forming.optimizer.iterate import find_free
from elastica_cad.forming.optimizer.nonlinear_program import ConstraintRows, NonlinearProgram, Point
from elastica_cad.forming.optimizer.quadratic_program import QuadraticProgram, solve_quadratic

CLEARANCE = 1e-9  # what a limit that is touched keeps in hand, so that rounding does not break it
_NEWTON_STEPS = 6  # each squares what is missed, as far as rounding lets it
_IN_REACH = 1e-3  # of a constraint's value: more is not missed by rounding
_TOUCHED = 1e-3  # values of a limit below this are touched
_MISSED = 1e-13  # by rounding alone
_FIRM = 1e4  # times what is missed: no step that puts it right is longer, no multiplier larger


def make_exact(program: NonlinearProgram[Point], point: Point) -> Point:
    """The point near a closed one that meets the equalities, and what limits are nearly met, to rounding."""
    point = _by_least_steps(program, point)
    well = worst_broken(program, program.values(point)) < 2 * CLEARANCE
    return point if well else _by_fine_steps(program, point)


def worst_broken(program: NonlinearProgram[Point], values: Sequence[FloatArray]) -> float:
    """The worst broken constraint."""
    return max(
        (
            float((np.maximum(-value, 0.0) if one_sided else np.abs(value)).max())
            for value, one_sided in zip(values, program.one_sided, strict=True)
        ),
        default=0.0,
    )


def _by_least_steps(program: NonlinearProgram[Point], point: Point) -> Point:
    """Newton's method on the equalities and on the limits that are touched, by least steps of what is free."""
    values = program.values(point)
    for k in range(_NEWTON_STEPS):
        if not any(_is_missed(v, one) for v, one in zip(values, program.one_sided, strict=True)):
            return point
        z, rows = program.rows(point, values)
        aim = _aim(rows)
        if np.abs(aim).max() > _IN_REACH:
            return point
        step = _least_step(program, rows, z, aim) if k == 0 else _least_step_within(program, rows, z, aim)
        trial = program.close(point, step)
        if trial is None:
            return point
        trial_values = program.values(trial)
        if worst_broken(program, trial_values) < worst_broken(program, values):
            point, values = trial, trial_values
        elif k > 0:
            return point
    return point


def _by_fine_steps(program: NonlinearProgram[Point], point: Point) -> Point:
    """The same where one unknown rules all rows: they are told apart, and a step may be for the worse."""
    best, least = point, np.inf
    for _ in range(_NEWTON_STEPS):
        values = program.values(point)
        if (broken := worst_broken(program, values)) < least:
            best, least = point, broken
        z, rows = program.rows(point, values)
        aim = _aim(rows)
        if not np.abs(aim).max(initial=0.0) < _IN_REACH:
            break
        trial = program.close(point, _least_step(program, rows, z, aim, finely=True))
        if trial is None:
            break
        point = trial
    return best


def _aim(rows: ConstraintRows) -> FloatArray:
    """By how much each row (j,) is to change."""
    return np.where(rows.one_sided, np.maximum(CLEARANCE - rows.value, 0.0), -rows.value)


def _is_missed(values: FloatArray, one_sided: bool) -> bool:
    """Is an equality, or what a limit should keep in hand, missed by more than rounding?"""
    gap = CLEARANCE - values.min() if one_sided else np.abs(values).max()
    return bool(gap > _MISSED)


def _least_step(
    program: NonlinearProgram[Point],
    rows: ConstraintRows,
    z: FloatArray,
    aim: FloatArray,
    finely: bool = False,
) -> FloatArray:
    """The least step that changes equalities by `aim`, and the limits that are touched.

    `finely` in scales in which no row changes fast.
    """
    touched, free = ~rows.one_sided | (rows.value < _TOUCHED), find_free(program, z)
    slopes, s, step = rows.jacobian[touched][:, free], program.scale[free], np.zeros(z.size)
    if finely:
        s = s / np.maximum(1.0, np.sqrt(np.einsum("jp,jp->p", slopes, slopes)) * s)
    step[free] = least_step(slopes * s, aim[touched]) * s
    return step


def _least_step_within(
    program: NonlinearProgram[Point], rows: ConstraintRows, z: FloatArray, aim: FloatArray
) -> FloatArray:
    """The same where more limits are touched than can be held: none is left broken."""
    s, unit, p = program.scale, float(np.abs(aim).max()), z.size
    right = np.where(rows.one_sided, CLEARANCE - rows.value, -rows.value)
    solution = solve_quadratic(
        QuadraticProgram(
            np.eye(p), np.zeros(p), np.maximum((program.lower - z) / s / unit, -_FIRM),
            np.minimum((program.upper - z) / s / unit, _FIRM), rows.jacobian * s, right / unit,
            np.full(right.size, _FIRM), rows.one_sided,
        ),
        accuracy=1e-6,
    )  # fmt: skip
    return np.asarray(solution.x * s * unit)
