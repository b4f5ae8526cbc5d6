"""The quadratic program of one step: local model and linearised constraints in a box, solved in scales."""

from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.forming.optimizer.iterate import Iterate
from elastica_cad.forming.optimizer.nonlinear_program import Point
from elastica_cad.forming.optimizer.quadratic_program import (
    QuadraticProgram,
    QuadraticSolution,
    solve_quadratic,
)

_SENSITIVE = 100.0
"""Root of the objective's curvature, per scale, beyond which an unknown is measured in a finer scale."""


def solve_step(
    here: Iterate[Point], radius: float, damping: float, near: QuadraticSolution | None
) -> tuple[FloatArray | None, QuadraticSolution | None]:
    """The step of the quadratic program in a box of `radius` scales, and its solution.

    Parameters
    ----------
    here : Iterate
        With p unknowns and their local program.
    radius : float
        Of the trust region, in scales.
    damping : float
        Added to the Hessian's diagonal, in scales.
    near : QuadraticSolution or None
        Of the program before, from which this one begins.

    Returns
    -------
    tuple of (p,) array and QuadraticSolution, or of None
        The step in the program's own units, and the solution in scales; None where it is not finite.
    """
    program, local = here.program, here.local
    rows, model, z = local.rows, local.model, local.z
    s = program.scale
    p = z.size
    # what the objective is very sensitive to is measured finer: it would set how well the others are solved for
    fine = np.sqrt(np.maximum(1.0, model.hessian.diagonal() * (s / _SENSITIVE) ** 2))
    s = s / fine
    hessian = model.hessian * np.outer(s, s)
    hessian.flat[:: p + 1] += damping / fine**2
    lower = np.maximum((program.lower - z) / s, -radius * fine)
    upper = np.minimum((program.upper - z) / s, radius * fine)
    jacobian, value = rows.jacobian * s, rows.value
    gradient, price, one_sided = model.gradient * s, rows.price, rows.one_sided
    if model.peaks.size:
        # one more unknown t >= every peak; its rows cannot be worth breaking
        k, top = model.peaks.size, float(model.peaks.max())
        grown = np.zeros((p + 1, p + 1))
        grown[:p, :p] = hessian
        hessian, gradient = grown, np.append(gradient, 1.0)
        lower, upper = np.append(lower, -2 * top - 1e-9), np.append(upper, 2 * top + 1e-9)
        jacobian = np.block([[jacobian, np.zeros((value.size, 1))], [-model.peak_rows * s, np.ones((k, 1))]])
        value = np.append(value, top - model.peaks)
        price = np.append(price, np.full(k, 10.0))
        one_sided = np.append(one_sided, np.ones(k, dtype=bool))
    solution = solve_quadratic(
        QuadraticProgram(hessian, gradient, lower, upper, jacobian, -value, price, one_sided), near=near
    )
    if not np.all(np.isfinite(solution.x)):
        return None, None
    if fine.max() == 1.0:
        return solution.x[:p] * s, solution
    back = np.append(fine, np.ones(solution.x.size - p))
    in_scales = replace(
        solution, x=solution.x / back, lower_multipliers=solution.lower_multipliers * back,
        upper_multipliers=solution.upper_multipliers * back,
    )  # fmt: skip
    return solution.x[:p] * s, in_scales


def damping_of(here: Iterate[Point], most: float, share: float) -> float:
    """What is added to the Hessian against long steps that change nothing: less as the objective comes down.

    Parameters
    ----------
    most : float
        Share of the Hessian's largest entry that it is at most.
    share : float
        Of the objective that a step of one scale may cost; infinite for `most` itself.
    """
    most *= float(here.local.model.hessian.diagonal().max())
    if here.local.model.peaks.size or not np.isfinite(share):
        return most
    return min(most, max(share * here.program.objective(here.local.point), 1e-16))
