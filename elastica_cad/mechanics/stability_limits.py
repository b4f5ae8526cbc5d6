"""Limits of stability: the displacement or load at which a rest shape snaps or buckles."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.mechanics.bending import as_steps, reach, state_of, system_of
from elastica_cad.mechanics.discrete_rod import Margin, solve_tridiagonal
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.loads import Gravity, PointMass
from elastica_cad.mechanics.newton_continuation import correct, is_straight, relax
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.rod_system import RodState, RodSystem, Step
from elastica_cad.refusals import Point

PathStep: TypeAlias = "float | ArrayLike | Mapping[str, Any]"
Path: TypeAlias = "Callable[[float], PathStep] | ArrayLike | Sequence[Mapping[str, Any]]"

# largest rotation of an edge in a step along the path
LARGEST_TURN_RAD = 0.3
# initial number of steps for each leg of the path of loads and end positions
FIRST_STEPS = 16
# accuracy of the stability limit, as a fraction of the path
RESOLUTION_SHARE = 1e-9


@dataclass(frozen=True, eq=False, repr=False)
class StabilityLimit:
    """Point on a path of end positions or loads at which a stable rod becomes unstable.

    Attributes
    ----------
    parameter : float or None
        Path parameter at which the rod becomes unstable, or None if the rod is stable along the whole path. The
        parameter of a function is t. The parameter of a sequence is the number of completed steps: 0 is the
        initial rod, and 2.25 is a quarter of the third step.
    at : dict
        Entry of the path at this parameter: keywords of `bend`, {"end": ...} or {"load": factor}.
    kind : {"snap", "bifurcation"} or None
        "snap": the branch of equilibria turns back, and the rod jumps. "bifurcation": the shape remains an
        equilibrium, but the rod buckles away from it.
    before : Rod
        Last stable shape; it is at the end of the path if `parameter` is None.
    after : Rod or None
        Stable shape of the rod just beyond the limit, or None if no such shape was found.
    parameters, margins : (k,) arrays
        Path parameters and margins of the computed stable states.
    """

    parameter: float | None
    at: dict[str, Any]
    kind: Literal["snap", "bifurcation"] | None
    before: Rod
    after: Rod | None
    parameters: FloatArray
    margins: FloatArray

    def __str__(self) -> str:
        if self.parameter is None:
            return f"stable all along the path, with a margin of {self.margins.min():.3g} at least"
        place = ", ".join(
            f"{key} is {value:.4g}" if np.ndim(value) == 0 else f"{key} is {Point(value):.4g}"
            for key, value in self.at.items()
        )
        how = "snaps" if self.kind == "snap" else "buckles"
        return f"stable up to {self.parameter:.4g} on the path, where {place}: it {how} there"

    def __repr__(self) -> str:
        return f"<StabilityLimit: {self}>"


def stability_limit(rod: Rod, path: Path, *, side: int | None = None) -> StabilityLimit:
    """Return the end displacement or load factor at which a stable rod becomes unstable.

    The branch of equilibria is followed from the present shape in adaptive steps. The parameter at which the lowest
    eigenvalue (the margin of `stability`) becomes zero is found by bisection. The stiffness of a wide strip
    (`section`) is updated at every step.

    Parameters
    ----------
    rod : Rod
        Stable rod in equilibrium; a straight rod may be compressed.
    path : function or sequence
        Entries of a sequence are positions of the end (k, 2), mm, or load factors (k,), or mappings with keywords
        of `bend`. Load factors multiply weight, dead forces and moments. The path is linear from the present
        state to the first entry and from entry to entry. A function of t in [0, 1] returns such an entry.
    side : {+1, -1}, optional
        Side to which a straight rod is bent (see `bend`).

    Raises
    ------
    NotConvergedError
        No equilibrium is found at the start of the path.

    Examples
    --------
    An upright column of its own weight buckles at w L^3 / (E I) = 7.837.

    >>> from elastica_cad.mechanics.loads import Gravity, Supports
    >>> from elastica_cad.mechanics.rod import Rod
    >>> column = Rod.straight(
    ...     100.0, angle=np.pi / 2, supports=Supports("clamped", "free"), gravity=Gravity(100.0)
    ... )
    >>> limit = stability_limit(column, [20.0])
    >>> limit.kind, round(limit.at["load"], 2)
    ('bifurcation', 7.84)
    """
    require_record(rod, Rod, "the rod", "a Rod, as bend makes one")
    require_free_between(rod, "A stability limit")
    rod = rod.following()
    course = Course.of(rod, path)
    t, state = _first_state(course, rod, side)
    margin = state.discrete.margin
    if margin.value <= 0:
        raise InputError(
            f"the rod is unstable at the start of the path (margin {margin.value:.3g}, not above 0): start from "
            "a stable shape"
        )
    visited = [(t, margin.value)]
    step = course.end / max(FIRST_STEPS * course.legs, 1)
    while t < course.end:
        t_next = course.clipped(t, step)
        following = _advance(course.system(t_next), state)
        if following is not None and (after := following.discrete.margin).value <= 0:
            (t, state, margin), at_zero = _bisected(course, (t, state, margin), t_next)
            visited.append((t, margin.value))
            if at_zero:
                return _limit_at(course, t, state, visited)
            # the step reached another branch, which is unstable: approach the fold more slowly
            step = (t_next - t) / 8
        elif following is None:
            step = (t_next - t) / 2
        else:
            t, state, margin = t_next, following, after
            visited.append((t, margin.value))
            step = min(2 * step, course.end / (FIRST_STEPS * course.legs))
            continue
        if step < RESOLUTION_SHARE * course.end:
            return _limit_at(course, t, state, visited)
    return StabilityLimit(
        None, course.entry(t), None, state.rod(course.loaded(t)), None, *np.array(visited).T
    )


@dataclass(frozen=True, eq=False)
class Course:
    """Path of a rod as a function from a parameter to the equations of the rod."""

    base: Rod
    entry: Callable[[float], dict[str, Any]]
    legs: int
    end: float

    @classmethod
    def of(cls, rod: Rod, path: Path) -> "Course":
        """Return the path from the present state of a rod along given entries."""
        if callable(path):
            function = path
            return cls(rod, lambda t: _entry_as_keywords(function(t)), 1, 1.0)
        entries = _entries(path)
        present = _present_values(rod, {name for entry in entries for name in entry})
        stops = [present]
        for entry in entries:
            stops.append({**stops[-1], **entry})
        legs = len(entries)

        def entry_at(t: float) -> dict[str, Any]:
            k = min(int(t), legs - 1)
            return {name: _interpolated(stops[k][name], stops[k + 1][name], t - k, name) for name in present}

        return cls(rod, entry_at, legs, float(legs))

    def clipped(self, t: float, step: float) -> float:
        """Return the parameter after a step from t, but not beyond the next corner of the path."""
        corner = min(np.floor(t / self.end * self.legs + 1e-9) + 1, self.legs) * self.end / self.legs
        return float(corner if t + step >= corner * (1 - 1e-12) else t + step)

    def around(self, t: float) -> tuple[float, float]:
        """Return an interval of the parameter around t that contains no corner of the path."""
        reach_t = 1e-3 * self.end
        a = max(t - reach_t, float(np.floor(t / self.end * self.legs)) * self.end / self.legs)
        return a, min(a + 2 * reach_t, self.end)

    def loaded(self, t: float) -> Rod:
        """Return the rod with the weight of the path at parameter t."""
        entry = self.entry(t)
        rod = self.base
        if "gravity" in entry:
            rod = replace(rod, gravity=entry["gravity"])
        return _with_scaled_weight(rod, entry["load"]) if "load" in entry else rod

    def system(self, t: float) -> RodSystem:
        """Return the equations of the rod at parameter t."""
        entry = self.entry(t)
        ends = {name: entry[name] for name in ("start", "end", "angles", "force", "moment") if name in entry}
        system = system_of(self.loaded(t), self.base, **ends)
        factor = entry.get("load", 1.0)
        return replace(system, force=factor * system.force, moments=factor * system.moments)


def _first_state(course: Course, rod: Rod, side: int | None) -> tuple[float, RodState]:
    """Return the parameter and the state of the first equilibrium of the path.

    The parameter is 0, or slightly larger if a straight rod would buckle at once.
    """
    for t in (0.0, 1e-3 * course.end):
        reached = reach(state_of(rod, course.system(t)), side if t > 0 else None, 1)
        if not reached.arrived:
            raise NotConvergedError(
                f"the rod snaps on the way to the start of the path, after {reached.fraction:.1%} of that "
                "way: start the path closer to the shape of the rod"
            )
        if (
            not is_straight(reached.state)
            or correct(reached.state.under(course.system(1e-3 * course.end))) is not None
        ):
            break
    return t, reached.state


def _advance(system: RodSystem, state: RodState) -> RodState | None:
    corrected = correct(state.under(system), turn=LARGEST_TURN_RAD)
    return None if corrected is None else corrected[0]


Visit: TypeAlias = tuple[float, RodState, Margin]


def _bisected(course: Course, low: Visit, high: float) -> tuple[Visit, bool]:
    """Return the last stable state, and True if its stability margin is 0.

    At a fold, the margin can jump from above to below 0, because a step may reach the unstable branch.
    """
    start = low[2].value
    while high - low[0] > RESOLUTION_SHARE * course.end:
        t = (low[0] + high) / 2
        middle = _advance(course.system(t), low[1])
        if middle is not None and (margin := middle.discrete.margin).value > 0:
            low = (t, middle, margin)
        else:
            high = t
    return low, low[2].value < 1e-6 * max(start, 1.0)


def _limit_at(
    course: Course, t: float, state: RodState, visited: list[tuple[float, float]]
) -> StabilityLimit:
    kind = _kind_of_limit(course, t, state)
    beyond = min(t + 1e-4 * course.end, course.end)
    mode = state.discrete.margin.mode
    push = Step(0.02 * mode / np.abs(mode).max(), np.zeros_like(state.reactions))
    rest = relax(state.moved(push).under(course.system(beyond)))
    before, after = state.rod(course.loaded(t)), None if rest is None else rest.rod(course.loaded(beyond))
    return StabilityLimit(t, course.entry(t), kind, before, after, *np.array(visited).T)


def _kind_of_limit(course: Course, t: float, state: RodState) -> Literal["snap", "bifurcation"]:
    """Return "snap" if a change of the load does work on the critical mode, or else "bifurcation".

    Work below a thousandth of its upper bound for a rod without axial force counts as 0.
    """
    margin, rod, norm = state.discrete.margin, state.discrete, np.linalg.norm
    a, b = course.around(t)
    before, after = (state.under(course.system(end)).residual for end in (a, b))
    imbalance, miss = after.imbalance - before.imbalance, after.miss - before.miss
    mode, nu = margin.mode, margin.multipliers[list(state.system.held)]
    diagonal, off = rod.hessian
    elastic = diagonal + rod.edge_length * rod.pull + rod.edge_lengths / state.system.length**2
    response = solve_tridiagonal(elastic, off, imbalance)
    moments = elastic * mode
    moments[:-1] += off * mode[1:]
    moments[1:] += off * mode[:-1]
    size = norm(moments) * norm(response) + norm(nu) * norm(miss)
    work = mode @ imbalance - nu @ miss
    rounding = 1e-8 * (b - a) * state.scale * float(norm(mode, 1))
    return "snap" if abs(work) > 1e-3 * size + rounding else "bifurcation"


def _entries(path: Any) -> list[dict[str, Any]]:
    if isinstance(path, Sequence) and path and all(isinstance(entry, Mapping) for entry in path):
        steps = as_steps(path)
        if any("supports" in step for step in steps):
            raise InputError(
                "`supports` cannot change along a path: bend the rod with the new supports first"
            )
        return steps
    values = numbers(path, "the path of loads")
    if values.ndim == 1 and values.size:
        return [_entry_as_keywords(value) for value in values]
    return as_steps(values)


def _entry_as_keywords(step: Any) -> dict[str, Any]:
    if isinstance(step, Mapping):
        load = {"load": _load_factor(step["load"])} if "load" in step else {}
        rest = {name: value for name, value in step.items() if name != "load"}
        return {**as_steps([rest])[0], **load} if rest else load
    value = numbers(step, "a step of the path")
    return {"load": _load_factor(float(value))} if value.ndim == 0 else as_steps(value[None])[0]


def _load_factor(value: Any) -> float:
    if not (is_number(value) and value >= 0):
        raise InputError(f"a load factor is {value!r}: give a finite number, 0 or more")
    return float(value)


def _present_values(rod: Rod, names: set[str]) -> dict[str, Any]:
    system = system_of(rod, rod)
    if "load" in names and not (system.load.any() or system.force.any() or system.moments.any()):
        raise InputError(
            "the rod has no load that the path could scale: add a weight, or a force or moment at an end"
        )
    present: dict[str, Any] = {
        "start": system.start, "end": system.end, "gravity": rod.gravity, "force": system.force,
        "angles": system.held_angles,
        "moment": tuple(system.moments), "load": 1.0,
    }  # fmt: skip
    return {name: present[name] for name in names}


def _interpolated(a: Any, b: Any, u: float, name: str) -> Any:
    if name == "gravity":
        zero = np.zeros(2)
        e = (1 - u) * (zero if a is None else a.e) + u * (zero if b is None else b.e)
        size = float(np.hypot(*e))
        return None if size == 0 else Gravity(size ** (-1 / 3), (-e[0], -e[1]))
    if name == "angles":
        return tuple(
            None if x is None else (1 - u) * x + u * (x if y is None else y)
            for x, y in zip(a, b, strict=True)
        )
    if name == "moment" and np.ndim(b) == 0:
        b = tuple(float(b) if x != 0 or k == 1 else 0.0 for k, x in enumerate(a))
    if name == "load":
        return float((1 - u) * a + u * b)
    return (1 - u) * np.asarray(a, dtype=float) + u * np.asarray(b, dtype=float)


def _with_scaled_weight(rod: Rod, factor: float) -> Rod:
    if rod.gravity is None or factor == 1.0:
        return rod
    if rod.weight is None:
        return replace(rod, gravity=rod.gravity.scaled(factor) if factor > 0 else None)
    masses = tuple(PointMass(point.at, factor * point.mass) for point in rod.weight.masses)
    return replace(rod, weight=replace(rod.weight.scaled(factor, factor), masses=masses))
