"""What holds a rod away from its wish: multipliers in millimetres."""

from dataclasses import dataclass

import numpy as np

from elastica_cad.forming.constraints import CurvatureLimit, MarginLimit
from elastica_cad.forming.problem import Problem
from elastica_cad.forming.setting import Measure, Setting
from elastica_cad.forming.sqp import Outcome

__all__ = ["Binding", "bindings"]

_IDLE = 1e-6  # costs below this share of the largest are noise


@dataclass(frozen=True)
class Binding:
    """A limit, or something kept, that costs distance.

    Attributes
    ----------
    name : str
        "ratio", "margin", "curvature", "length", "keep-out", "stiffness bounds", "end position", "end tangent",
        "start position", "start tangent", "points", "inflection line", "symmetry", ...
    limit : float or None
        Its present value where it is one number (curvature in 1/mm, lengths in mm).
    cost : float
        Millimetres of distance (mean or largest, as measured) saved at first by relaxing it by one unit; for what
        is kept, by moving it by 1 mm or 1 rad.
    broken : float
        By how much it is missed, in lengths of the wish, radians or shares of the limit.
    """

    name: str
    limit: float | None
    cost: float
    broken: float = 0.0


def bindings(setting: Setting, problem: Problem, outcome: Outcome, measure: Measure) -> tuple[Binding, ...]:
    """All limits with a cost, the dearest relative change first."""
    size, limits, u = setting.wish.size, setting.limits, problem.grid.unknowns
    if measure == "max":
        per = size
    else:
        per = float(size / np.sqrt(2 * outcome.distance)) if outcome.distance > 1e-14 else 0.0
    found: list[Binding] = []
    at_ratio = float(outcome.at_upper[u.stiffness].sum())
    found.append(Binding("ratio", limits.largest_ratio, per * at_ratio))
    if limits.length is not None or setting.keep.length:
        pull = float(outcome.at_upper[u.length] - outcome.at_lower[u.length])
        found.append(Binding("length", float(outcome.rod.length * size), per * abs(pull) / size))
    for name, part, unit in (("start position", u.position, size), ("start tangent", u.angle, 1.0)):
        pull = float(np.linalg.norm(outcome.at_upper[part] - outcome.at_lower[part]))
        found.append(Binding(name, None, per * pull / unit))
    values = problem.values(outcome.rod)
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
    kept = [b for b in found if b.broken > 1e-6 or b.cost * abs(b.limit or 1.0) > _IDLE * max(largest, 1e-12)]
    return tuple(sorted(kept, key=lambda b: (-(b.broken > 1e-6), -b.cost * abs(b.limit or 1.0))))
