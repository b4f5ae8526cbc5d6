"""Nonlinear program for the nearest rod, with its result and active limits."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.errors import BareLength, FieldName, InputError, Length, note
from elastica_cad.form_finding.constraints import (
    AtNodes,
    Constraint,
    EndAngle,
    EndForce,
    EndMoment,
    EndPosition,
    FollowedMarginLimit,
    InflectionLine,
    LargestSection,
    LeastStiffness,
    MarginLimit,
    MiddleOfMirror,
    MiddleOfTurn,
    StrainLimit,
    Through,
    margin_limit,
)
from elastica_cad.form_finding.curve_distance import Distance, even_steps, symmetry_frame
from elastica_cad.form_finding.limits import MET, ActiveLimit, Limits, Symmetry
from elastica_cad.form_finding.nearest_task import NearestTask, SearchPoint, values_along
from elastica_cad.form_finding.rod_map import MappedRod, Sensitivities, StripGrid
from elastica_cad.form_finding.sqp import ConstraintRows, Linearization, NonlinearProgram, Outcome
from elastica_cad.geometry.plane_points import angle_of, left_of, norm, unit
from elastica_cad.mechanics.loads import LENGTHS_APART, RestCurvature


@dataclass(frozen=True, eq=False, kw_only=True)
class RodProblem(NonlinearProgram[MappedRod]):
    """Problem to minimise `distance` over the unknowns of `grid`, within bounds and under `constraints`.

    A point of the problem is a rod. The state of a point consists of the angles and moments of the rod.
    """

    grid: StripGrid
    distance: Distance
    constraints: tuple[Constraint, ...]

    @cached_property
    def one_sided(self) -> BoolArray:
        """For each constraint, True if its values must be at least 0, and False if they must be 0."""
        return np.array([c.one_sided for c in self.constraints], dtype=bool)

    @cached_property
    def highest_penalties(self) -> FloatArray:
        """For each constraint, upper bound of the penalty for a violation of 1."""
        return np.array([c.penalty for c in self.constraints], dtype=float)

    def objective(self, point: MappedRod) -> float:
        """Return the distance of a rod from the target."""
        return self.distance.value(point)

    def values(self, point: MappedRod) -> list[FloatArray]:
        """Return the values of each constraint for a rod."""
        return [c.values(point) for c in self.constraints]

    def rows(self, point: MappedRod, values: Sequence[FloatArray]) -> tuple[FloatArray, ConstraintRows]:
        """Return the unknowns and the linearised constraints of a rod in equilibrium."""
        return point.z, self._stacked(self.grid.sensitivities(point), values)

    def linearize(self, point: MappedRod) -> Linearization[MappedRod] | None:
        """Return the rod with its derivatives, or None if they overflow."""
        if not np.isfinite(point.moments[-1]):
            return None
        sensitivities = self.grid.sensitivities(point, to_equilibrium=True)
        # with larger derivatives, products could overflow
        if not np.abs(sensitivities.angles).max() < 1e50:
            return None
        return Linearization(
            point, point.z, self._stacked(sensitivities),
            self.distance.model(point, sensitivities), sensitivities.angles,
            partial(self._moved, sensitivities),
        )  # fmt: skip

    def close(self, point: MappedRod, step: FloatArray | None = None) -> MappedRod | None:
        """Return the rod in equilibrium after a step, or None if numbers overflow."""
        rod = self.grid.shoot(point.z if step is None else self._clipped(point.z + step))
        return rod if np.isfinite(rod.moments[-1]) else None

    def clip(self, point: MappedRod) -> MappedRod:
        """Return the rod with its unknowns clipped to their bounds, and unchanged angles and moments."""
        z = self._clipped(point.z)
        return point if np.array_equal(z, point.z) else self.grid.assemble(z, point.all_angles, point.moments)

    def fallback(self) -> MappedRod:
        """Return an initial rod of constant stiffness without forces."""
        u = self.grid.unknowns
        z = np.zeros(u.count)
        z[u.stiffness], z[u.length] = 1.0, 1.0
        return self.grid.shoot(self._clipped(z))

    def apart(self, first: MappedRod, other: MappedRod) -> float:
        """Return half the mean of the squared distances between the nodes of two rods."""
        return float(((first.position - other.position) ** 2).mean())

    def for_open_points(self) -> "RodProblem":
        """Return the problem for rods far from equilibrium, without its `near_balance_only` constraints."""
        return replace(self, constraints=tuple(c for c in self.constraints if not c.near_balance_only))

    def _moved(self, d: Sensitivities, change: FloatArray) -> MappedRod:
        z = self._clipped(d.rod.z + change[:-1])
        return self.grid.assemble(z, d.rod.all_angles + d.angles @ change, d.rod.moments + d.moments @ change)

    def _clipped(self, z: FloatArray) -> FloatArray:
        return z.clip(self.lower, self.upper)

    def with_given(self, unknowns: int | slice, value: FloatArray | float) -> "RodProblem":
        """Return the problem with some `unknowns` fixed to `value`, clipped to the bounds."""
        lower, upper = self.lower.copy(), self.upper.copy()
        lower[unknowns] = upper[unknowns] = np.clip(value, lower[unknowns], upper[unknowns])
        return replace(self, lower=lower, upper=upper)

    def _stacked(
        self, sensitivities: Sensitivities, values: Sequence[FloatArray] | None = None
    ) -> ConstraintRows:
        """Return the rows of all constraints.

        With one more column of derivatives, the values are those of the rod in equilibrium, to first order.
        """
        p = sensitivities.rod.z.size
        if not self.constraints:
            none, empty = np.zeros(0), np.zeros(0, dtype=int)
            return ConstraintRows(empty, empty, none, np.zeros((0, p)), none, none > 0)
        values = self.values(sensitivities.rod) if values is None else values
        # for each constraint, indices (j,) of its values and derivatives (j, p) or (j, p + 1)
        rows = [constraint.rows(sensitivities) for constraint in self.constraints]
        jacobian = np.concatenate([slopes for _, slopes in rows])
        at = np.concatenate([value[index] for value, (index, _) in zip(values, rows, strict=True)])
        if jacobian.shape[1] > p:
            at, jacobian = at + jacobian[:, p], jacobian[:, :p]
        number = np.arange(len(rows)).repeat([index.size for index, _ in rows])
        return ConstraintRows(
            number, np.concatenate([index for index, _ in rows]), at, jacobian, self.highest_penalties[number],
            self.one_sided[number],
        )  # fmt: skip


RodOutcome: TypeAlias = Outcome[MappedRod]


class Search(NamedTuple):
    """Result of a search: its last task and problem, the best outcome, and optima of other shapes.

    `steps` counts the steps of all searches. `off` is the mean distance of the rod from the target after the
    last search from all initial guesses, in diagonals of the target.
    """

    task: NearestTask
    problem: RodProblem
    best: RodOutcome
    others: tuple[RodOutcome, ...]
    steps: int
    off: float

    @property
    def ended(self) -> SearchPoint:
        """End of the search, from which a similar search can begin."""
        target = self.task.target
        return SearchPoint(
            self.best.point.z, self.problem.grid.unknowns, target.size, target.origin, self.off
        )


def pose_problem(task: NearestTask) -> RodProblem:
    """Return the nonlinear program for a task."""
    # gravity is in units of the drawn length. With a section, `e` is its direction, because the weight follows from
    # the section
    gravity, section, size = task.request.gravity, task.section, task.target.size
    e, weight = np.zeros(2), None
    if gravity is not None and section is None:
        e = gravity.e * size**3
    elif gravity is not None and section is not None:
        e, weight = -np.asarray(gravity.direction), partial(section.weight, size=size)
    basis = task.basis.at(even_steps(task.nodes))
    grid = StripGrid(basis, e, task.rest, supports=task.request.supports, weight=weight)
    lower, upper = _box(task, grid)
    scale, u = np.ones(grid.unknowns.count), grid.unknowns
    scale[u.moment], scale[u.force] = _moment_scale(task), 5 * _moment_scale(task)
    return RodProblem(
        lower, upper, scale, grid=grid, distance=task.mean_distance,
        constraints=tuple(_constraints(task)),
    )  # fmt: skip


def _moment_scale(task: NearestTask) -> float:
    # typical moment, in units of the search: root mean square curvature times a typical stiffness
    bend = float(np.sqrt((task.target.curvature**2).mean()))
    return float(max(1.0, bend * min(2.0, np.sqrt(task.limits.largest_ratio))))


def _box(task: NearestTask, grid: StripGrid) -> tuple[FloatArray, FloatArray]:
    """Return the bounds of the unknowns.

    Equal bounds fix a kept start, and an absent force or moment at the start.
    """
    u, target = grid.unknowns, task.target
    lower, upper = np.full(u.count, -np.inf), np.full(u.count, np.inf)
    lower[u.stiffness], upper[u.stiffness] = _coefficient_bounds(task, u.coefficients)
    held = task.request.supports.held  # x, y and angle of the start come first
    if task.keep.both_ends[0]:
        lower[u.position] = upper[u.position] = target.position[0]
    if task.keep.both_tangents[0]:
        lower[u.angle] = upper[u.angle] = target.angle[0]
    if not held[2]:
        lower[u.moment] = upper[u.moment] = 0.0
    lower[u.force][~held[:2]] = upper[u.force][~held[:2]] = 0.0
    lower[u.length], upper[u.length] = _lengths(task)
    return lower, upper


def _lengths(task: NearestTask) -> tuple[float, float]:
    """Return the least and the largest length of the rod, as multiples of the drawn length.

    Refuse conflicts.
    """
    target, limits = task.target, task.limits
    # default limits of the length, as multiples of the length of the drawn curve
    low, high = (0.2, 5.0) if limits.length is None else np.asarray(limits.length) / target.size
    rest = task.request.natural_curvature
    blank = rest.length if isinstance(rest, RestCurvature) else None
    if blank is not None:
        wish = "`keep.length` requires" if task.keep.length else "the limit of the length requires"
        least, most = (1.0, 1.0) if task.keep.length else (low, high)
        # keep a small reserve for rounding errors
        tolerance = LENGTHS_APART * (1 - 1e-6)
        low, high = (
            max(low, (1 - tolerance) * blank / target.size),
            min(high, (1 + tolerance) * blank / target.size),
        )
        if least > high or most < low:
            raise InputError(
                "{asked} a length of {size:.6g} to {size_2:.6g}, but the pre-bent strip is {blank:.6g} "
                "long. Give the curvature of the pre-bent strip along the required length",
                asked=wish,
                size=BareLength(least * target.size),
                size_2=Length(most * target.size),
                blank=Length(blank),
            )
    if task.keep.length:
        if not low * (1 - 1e-12) <= 1 <= high * (1 + 1e-12):
            raise InputError(
                "`keep.length` requires a length of {size:.6g}, but the limits of the length are "
                "{low:.6g} and {high:.6g}: leave out `keep.length`, or change the limits",
                size=Length(target.size),
                low=BareLength(low * target.size),
                high=Length(high * target.size),
            )
        low = high = 1.0
    if all(task.keep.both_ends):
        chord = float(norm(target.position[-1] - target.position[0]))
        if high < chord * (1 - 1e-12):
            raise InputError(
                "the rod may be at most {size:.6g} long, but its fixed ends are {size_2:.6g} apart: allow "
                "more length, or free an end",
                size=Length(high * target.size),
                size_2=Length(chord * target.size),
            )
    return float(low), float(high)


def _constraints(task: NearestTask) -> list[Constraint]:
    """Return the conditions of the request: kept ends, points and lines, supports of the end, and limits."""
    target, limits, keep = task.target, task.limits, task.keep
    end = task.request.supports.ends[1]
    constraints: list[Constraint] = []
    if keep.symmetry:
        constraints.append(_symmetry(task, keep.symmetry))
    else:
        if keep.both_ends[1]:
            constraints.append(EndPosition(target=_pair(target.position[-1])))
        if keep.both_tangents[1]:
            constraints.append(
                EndAngle(
                    active=ActiveLimit("end tangent", title=_end_title(task, 1), unit="angle"),
                    target=float(target.angle[-1]),
                )
            )
        if not end.angle:
            constraints.append(EndMoment(scale=_moment_scale(task)))
        constraints += [
            EndForce(axis=axis, scale=5 * _moment_scale(task))
            for axis, held in enumerate((end.x, end.y))
            if not held
        ]
    for s in keep.points:
        if not 0 <= s <= target.size * (1 + 1e-9):
            raise InputError(
                (
                    "the drawn curve is {size:.6g} long, so it has no point at {s:.6g} for `keep.points`: "
                    "give arc lengths within this length"
                ),
                s=Length(s),
                size=Length(target.size),
            )
        place = min(s / target.size, 1.0)
        point = target.at(np.array([place]))
        constraints.append(Through(target=_pair(point[0]), place=place))
    if task.line is not None:
        a, b = ((p - target.origin) / target.size for p in task.line)
        direction = unit(b - a)
        constraints.append(
            InflectionLine(point=_pair(a), direction=_pair(direction), scale=_moment_scale(task))
        )
    if task.section is not None and limits.sheet is not None:
        constraints.append(StrainLimit(section=task.section, strain=limits.strain, size=target.size))
    constraints += [
        AtNodes(
            active=active, room=room, size=target.size, rest=task.rest, origin=_pair(target.origin),
            kept=keep.both_ends,
            penalty=100.0 if active.unit == "length" else 1.0,
        )
        for _, active, room, _ in limits.at_places(strain=task.section is None)
    ]  # fmt: skip
    if limits.stiffness_bounds is not None and limits.stiffness_bounds[0] is not None:
        constraints.append(LeastStiffness())
    if limits.margin is not None:
        constraints += _margin_limits(task, limits.margin)
    return constraints


def _margin_limits(task: NearestTask, margin: float) -> list[Constraint]:
    """Return the constraints of the stability margin.

    The margin of a section that follows the bend depends on its scale, which the search does not fix.
    """
    section, size, words = task.section, task.target.size, margin_limit(margin)
    if section is None or not task.is_scaled_freely:
        return [MarginLimit(active=words)]
    constraints: list[Constraint] = [
        FollowedMarginLimit(active=words, section=section, rest=task.rest, size=size)
    ]
    if task.keeps_scale and np.isfinite(section.family.limits[1]):
        constraints.append(LargestSection(section=section, rest=task.rest, size=size))
    return constraints


def _symmetry(task: NearestTask, kind: Symmetry) -> Constraint:
    """Return the condition at the middle that makes the rod symmetric.

    A load or natural curvature without this symmetry is refused.
    """
    target = task.target
    centre, axis = symmetry_frame(target, kind)
    rest = np.broadcast_to(task.rest, (task.nodes,))
    # a symmetric pre-bent strip differs by a smaller fraction of its typical curvature
    if np.abs(rest - (1 if kind == "mirror" else -1) * rest[::-1]).max() > 1e-6 * _moment_scale(task):
        image = "mirror image" if kind == "mirror" else "image after a half turn"
        raise InputError(
            f"the pre-bent strip differs from its {image}: give a symmetric pre-bent strip, or leave out "
            "`keep.symmetry`"
        )
    if kind == "turn":
        if task.request.gravity is not None:
            raise InputError(
                "a strip with weight cannot be symmetric under a half turn, which reverses gravity: leave out "
                "`keep.symmetry` or the weight"
            )
        return MiddleOfTurn(centre=_pair(centre), scale=_moment_scale(task))
    if task.request.gravity is not None and abs(np.dot(task.request.gravity.direction, axis)) < 1 - 1e-9:
        raise InputError(
            "gravity is not parallel to the mirror axis, so a strip with weight cannot be symmetric: leave "
            "out `keep.symmetry` or gravity"
        )
    across = left_of(axis)
    middle = float(target.angles(np.array([0.5]))[0])
    angle = float(angle_of(across))
    # of the two directions across the axis, and their full turns, take the nearest to the target
    angle += np.pi * np.round((middle - angle) / np.pi)
    return MiddleOfMirror(centre=_pair(centre), axis=_pair(axis), angle=angle, scale=5 * _moment_scale(task))


def _coefficient_bounds(task: NearestTask, count: int) -> tuple[FloatArray, FloatArray]:
    """Return lower and upper bounds (count,) of the coefficients of the stiffness.

    A coefficient has the strictest bound of the stiffness where its basis function is positive.
    """
    ratio = task.limits.largest_ratio
    low, high = np.ones(count), np.full(count, ratio)
    if task.limits.stiffness_bounds is None:
        return task.least_stiffness * low, high
    s = np.linspace(0, 1, 20 * task.coefficients + 1)
    support = task.basis.at(s) > 0
    below, above = task.limits.stiffness_bounds
    if below is not None:
        values = values_along(below, s, task.target.size, "stiffness bounds")
        low = np.maximum(low, np.where(support, values[:, None], -np.inf).max(axis=0))
    if above is not None:
        values = values_along(above, s, task.target.size, "stiffness bounds")
        high = np.minimum(high, np.where(support, values[:, None], np.inf).min(axis=0))
    if low.min() > 1:
        raise InputError(
            f"the lower of the `stiffness_bounds` is {low.min():.4g} or more everywhere, but the stiffness "
            "K / min K is 1 at the softest place. Reduce the lower bound to 1 at one place at least"
        )
    if (low > high).any():
        at = float(s[np.argmax(support[:, int(np.argmax(low - high))])]) * task.target.size
        raise InputError(
            "near {at:.4g} along the curve, the lower of the `stiffness_bounds` is above the upper one or "
            "the ratio limit {ratio:.4g}: widen the bounds",
            ratio=ratio,
            at=Length(at),
        )
    return low, high


def _pair(point: FloatArray) -> tuple[float, float]:
    return float(point[0]), float(point[1])


# an effect below this fraction of the largest effect may be an error of the quadratic program
_IDLE = 1e-6


def active_limits(
    task: NearestTask, problem: RodProblem, outcome: Outcome[MappedRod]
) -> tuple[ActiveLimit, ...]:
    """Return the violated limits, followed by the limits that increase the distance.

    Each group is sorted by the effect of a relative change of the limit, the largest first.
    """
    size, limits, u = task.target.size, task.limits, problem.grid.unknowns
    # change of the distance, mm, by a unit change of the objective
    power = problem.distance.power
    per = size * (power * outcome.objective) ** (1 / power - 1) if outcome.objective > 1e-14 else 0.0
    at_ratio, pulls = float(outcome.at_upper[u.stiffness].sum()), outcome.at_upper - outcome.at_lower
    bindings = [
        ActiveLimit("ratio", limits.largest_ratio, per * at_ratio, 0.0, _ratio_title(limits), "number")
    ]
    if limits.length is not None or task.keep.length:
        title: str = note("the length" if task.keep.length else "the range of lengths")
        length = float(outcome.point.length * size)
        bindings.append(
            ActiveLimit("length", length, per * abs(float(pulls[u.length])) / size, 0.0, title, "length")
        )
    pull = float(np.linalg.norm(pulls[u.position]))
    bindings.append(ActiveLimit("start position", None, per * pull / size, unit="length"))
    title = _end_title(task, 0) if task.keep.both_tangents[0] else ""
    bindings.append(ActiveLimit("start tangent", None, per * abs(float(pulls[u.angle])), 0.0, title, "angle"))
    values = problem.values(outcome.point)
    bindings += [
        constraint.binding(value, y, size, per)
        for constraint, y, value in zip(problem.constraints, outcome.multipliers, values, strict=True)
    ]
    largest = max(b.cost * abs(b.limit or 1.0) for b in bindings)
    kept = [
        b for b in bindings if b.broken > MET or b.cost * abs(b.limit or 1.0) > _IDLE * max(largest, 1e-12)
    ]
    return tuple(sorted(kept, key=lambda b: (-(b.broken > MET), -b.cost * abs(b.limit or 1.0))))


def _ratio_title(limits: Limits) -> str:
    if limits.ratio is None and limits.width is None:
        return ""
    if limits.width is None or limits.largest_ratio < limits.width[1] / limits.width[0]:
        return note("the ratio limit")
    return note(
        "the ratio of largest to least width, now {most:.3g} ({widest}; {narrowest} or {workshop})",
        most=limits.largest_ratio, widest=FieldName("max_width"), narrowest=FieldName("min_width"),
        workshop=FieldName("shop.least_width"),
    )  # fmt: skip


def _end_title(task: NearestTask, index: int) -> str:
    """Return the name of an end in messages by its side, such as "the angle at the left end"."""
    target = task.target
    # from the other end to this end: the index 0 is the start, 1 the end
    off = target.position[-index] - target.position[index - 1]
    across = 0 if abs(off[0]) >= abs(off[1]) else 1
    if abs(off[across]) < 1e-3 * target.diagonal:  # the ends are too close to have sides
        side = ("first", "last")[index]
    else:
        side = (("left", "right"), ("lower", "upper"))[across][int(off[across] > 0)]
    return note("the angle at the {side} end", side=note(side))
