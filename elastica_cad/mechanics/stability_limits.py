"""Limits of stability: the displacement or load at which a rest shape snaps or buckles."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_record
from elastica_cad.errors import InputError, NotConvergedError, Point
from elastica_cad.mechanics.bending import as_steps, first_visit, segment_to, system_of
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.followed_path import Event, followed
from elastica_cad.mechanics.loads import PointMass
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.rod_system import RodSystem

Path: TypeAlias = "ArrayLike | Sequence[Mapping[str, Any]]"

# number of margins that are computed on each step of the path
STATIONS = 16


@dataclass(frozen=True, eq=False, repr=False)
class StabilityLimit:
    """Point on a path of end positions or loads at which a stable rod becomes unstable.

    Attributes
    ----------
    parameter : float or None
        Path parameter at which the rod becomes unstable, or None if the rod is stable along the whole path. It is
        the number of completed steps: 0 is the initial rod, and 2.25 is a quarter of the third step.
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
    path : sequence
        Entries are positions of the end (k, 2), mm, or load factors (k,), or mappings with keywords
        of `bend`. Load factors multiply weight, dead forces and moments. The path is linear from the present
        state to the first entry and from entry to entry.
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
    base = rod = rod.following()
    entries = _entries(path)
    names = {name for entry in entries for name in entry}
    if "load" in names:
        system = system_of(base, base)
        if not (system.load.any() or system.force.any() or system.moments.any()):
            raise InputError(
                "the rod has no load that the path could scale: add a weight, or a force or moment at an end"
            )
    there: dict[str, Any] = {}
    parameters, margins, load = list[float](), list[float](), 1.0
    for k, entry in enumerate(entries):
        there |= entry  # values that an entry does not contain stay as they are
        segment, visit = segment_to(_loaded(base, there), rod, _system(base, there))
        first, to = first_visit(segment, visit, side)
        if isinstance(first, Event):
            raise NotConvergedError(
                f"the rod snaps before it begins step {k + 1} of the path: start the path closer to the shape of "
                "the rod"
            )
        if not k and (margin := first.state.discrete.margin.value) <= 0:
            raise InputError(
                f"the rod is unstable at the start of the path (margin {margin:.3g}, not above 0): start from "
                "a stable shape"
            )
        path_here = followed(segment, first, side=to or 1, once=True)
        event = next(iter(path_here.events), None)
        end = 1.0 if event is None else event.t
        for t in np.linspace(first.t, end, STATIONS + 1):
            stable = event.before if event is not None and t == end else path_here.at(float(t))
            parameters.append(k + float(t))
            margins.append(stable.state.discrete.margin.value)
        load += end * (there.get("load", load) - load)
        like = _loaded(base, there | ({"load": load} if "load" in names else {}))
        rod = stable.rod(like)
        if event is not None:
            after = None if event.after is None else event.after.rod(like)
            kind: Literal["snap", "bifurcation"] = "snap" if event.kind == "snap" else "bifurcation"
            return StabilityLimit(
                k + end, _values(stable.state.system, there, load), kind, rod, after, np.array(parameters),
                np.array(margins),
            )  # fmt: skip
    at = _values(stable.state.system, there, load)
    return StabilityLimit(None, at, None, rod, None, np.array(parameters), np.array(margins))


def _values(system: RodSystem, entry: Mapping[str, Any], load: float) -> dict[str, Any]:
    """Return the values of the names in an entry of the path at a place of the path."""
    values = {
        **entry, "start": system.start, "end": system.end, "angles": system.held_angles, "force": system.force,
        "moment": tuple(system.moments), "load": load,
    }  # fmt: skip
    return {name: values[name] for name in entry}


def _loaded(rod: Rod, entry: Mapping[str, Any]) -> Rod:
    """Return the rod with the weight of an entry of the path, times its load factor."""
    if "gravity" in entry:
        rod = replace(rod, gravity=entry["gravity"])
    factor = entry.get("load", 1.0)
    if rod.gravity is None or factor == 1.0:
        return rod
    if rod.weight is None:
        return replace(rod, gravity=rod.gravity.scaled(factor) if factor > 0 else None)
    masses = tuple(PointMass(point.at, factor * point.mass) for point in rod.weight.masses)
    return replace(rod, weight=replace(rod.weight.scaled(factor, factor), masses=masses))


def _system(rod: Rod, entry: Mapping[str, Any]) -> RodSystem:
    """Return the equations of the rod at an entry of the path."""
    ends = {name: entry[name] for name in ("start", "end", "angles", "force", "moment") if name in entry}
    system = system_of(_loaded(rod, entry), rod, **ends)
    factor = entry.get("load", 1.0)
    return replace(system, force=factor * system.force, moments=factor * system.moments)


def _entries(path: Any) -> list[dict[str, Any]]:
    # each entry of the path as keywords of `bend`, with the load factor as "load"
    if isinstance(path, Sequence) and path and all(isinstance(entry, Mapping) for entry in path):
        if any("supports" in entry for entry in path):
            raise InputError(
                "`supports` cannot change along a path: bend the rod with the new supports first"
            )
        return [_entry_as_keywords(entry) for entry in path]
    values = numbers(path, "the path of loads")
    if values.ndim == 1 and values.size:
        return [{"load": _load_factor(value)} for value in values.tolist()]
    return as_steps(values)


def _entry_as_keywords(step: Mapping[str, Any]) -> dict[str, Any]:
    load = {"load": _load_factor(step["load"])} if "load" in step else {}
    rest = {name: value for name, value in step.items() if name != "load"}
    return {**as_steps([rest])[0], **load} if rest else load


def _load_factor(value: Any) -> float:
    if not (is_number(value) and value >= 0):
        raise InputError(f"a load factor is {value!r}: give a finite number, 0 or more")
    return float(value)
