"""What holds a rod away from the drawn curve: multipliers in millimetres."""

import numpy as np

from elastica_cad.forming.limits import MET
from elastica_cad.forming.nearest.constraints.limit_rows import CurvatureLimit, MarginLimit
from elastica_cad.forming.nearest.nearest_record import Binding
from elastica_cad.forming.nearest.nearest_task import Measure, NearestTask
from elastica_cad.forming.nearest.rod_map import MappedRod
from elastica_cad.forming.nearest.rod_problem import RodProblem
from elastica_cad.forming.optimizer.sqp import Outcome

_IDLE = 1e-6  # of the largest cost: smaller ones are what the quadratic program leaves open


def list_bindings(
    task: NearestTask, problem: RodProblem, outcome: Outcome[MappedRod], measure: Measure
) -> tuple[Binding, ...]:
    """All limits with a cost, the dearest relative change first."""
    size, limits, u = task.target.size, task.limits, problem.grid.unknowns
    if measure == "max":
        per = size
    else:
        per = float(size / np.sqrt(2 * outcome.objective)) if outcome.objective > 1e-14 else 0.0
    found: list[Binding] = []
    at_ratio = float(outcome.at_upper[u.stiffness].sum())
    found.append(Binding("ratio", limits.largest_ratio, per * at_ratio))
    if limits.length is not None or task.keep.length:
        pull = float(outcome.at_upper[u.length] - outcome.at_lower[u.length])
        found.append(Binding("length", float(outcome.point.length * size), per * abs(pull) / size))
    for name, part, unit in (("start position", u.position, size), ("start tangent", u.angle, 1.0)):
        pull = float(np.linalg.norm(outcome.at_upper[part] - outcome.at_lower[part]))
        found.append(Binding(name, None, per * pull / unit))
    values = problem.values(outcome.point)
    for constraint, y, value in zip(problem.constraints, outcome.multipliers, values, strict=True):
        broken = float((np.maximum(-value, 0) if constraint.one_sided else np.abs(value)).max(initial=0.0))
        total = float(np.abs(y).sum()) if constraint.one_sided else float(np.linalg.norm(y))
        limit: float | None = None
        if isinstance(constraint, MarginLimit):
            limit, total = constraint.limit, total / constraint.scale
        elif isinstance(constraint, CurvatureLimit):
            limit, total = constraint.limit / size, total / constraint.limit * size
        elif constraint.name in ("end position", "points", "keep-out"):
            total /= size
        found.append(Binding(constraint.name, limit, per * total, broken))
    largest = max(b.cost * abs(b.limit or 1.0) for b in found)
    kept = [b for b in found if b.broken > MET or b.cost * abs(b.limit or 1.0) > _IDLE * max(largest, 1e-12)]
    return tuple(sorted(kept, key=lambda b: (-(b.broken > MET), -b.cost * abs(b.limit or 1.0))))
