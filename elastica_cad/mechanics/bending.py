"""Rest shape of a rod after its ends, loads or supports have changed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, Literal, TypeGuard

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import (
    as_floats,
    is_one_of,
    pair,
    require_flag,
    require_record,
    several,
)
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.plane_points import midpoints, norm
from elastica_cad.mechanics.elements import (
    Element,
    ElementForce,
    Pin,
    PlacedElement,
    PointForce,
    Rail,
    Tie,
    lumped,
    require_elements,
    resultant,
    weight_with_loads,
    with_placed_masses,
)
from elastica_cad.mechanics.loads import (
    Gravity,
    PointMass,
    Supports,
    Weight,
    require_supports,
    whole_number,
)
from elastica_cad.mechanics.mounted_elements import (
    MEETS_SHARE,
    PULLS_SHARE,
    ShapeOfRod,
    mounted,
    require_held,
    touching,
    violation,
    with_side,
    wrong_force,
)
from elastica_cad.mechanics.newton_continuation import (
    LARGEST_TURN_RAD,
    SMALL_TURN_RAD,
    STOP_SHARE,
    STRAIGHT_RAD,
    Reached,
    Stop,
    between_loads,
    buckling_mode,
    follow,
    is_balanced,
    is_straight,
    leave_straight,
    relax,
    stretch,
)
from elastica_cad.mechanics.rod import Rod, require_rod, resample
from elastica_cad.mechanics.rod_system import RodState, RodSystem
from elastica_cad.refusals import Degrees, FieldName, Length, Point, Refusal, note

Keep = Literal["keep"]

# force components up to this fraction of the largest force in the rod are rounding errors
ROUNDED_SHARE = 1e-12
TURNED_RAD = 1e-9  # smaller rotations of an end, rad, are rounding errors


def bend(
    rod: Rod,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    angles: tuple[float | None, float | None] | ArrayLike | None = None,
    *,
    gravity: Gravity | Keep | None = "keep",
    supports: Supports | None = None,
    force: ArrayLike | None = None,
    moment: float | tuple[float, float] | None = None,
    guess: "Rod | ArrayLike | None" = None,
    side: int | None = None,
    mode: int = 1,
    samples: int | None = None,
    settle: bool = False,
    between: "Element | Sequence[Element] | Keep" = "keep",
    loads: "PointMass | PointForce | Sequence[PointMass | PointForce] | Keep" = "keep",
) -> Rod:
    """Return the rest shape of a rod after its ends, loads, supports, rails, pins or ties have changed.

    The discrete rod of the paper (section 7.1), with its weight, is solved by Newton's method with a line
    search. Ends, angles and loads change in adaptive steps, starting from the present shape or from `guess`.
    The result is therefore on the same branch of equilibria, and may be unstable (see `stability`). If the
    branch ends on the way, the rod snaps into another stable shape, and the result has a message in `warnings`.

    The stiffness of a strip that bends as a plate (`section`) is updated at every step. The `law` of the
    result contains the updated stiffness. The relative stiffness K of the design does not change.

    Parameters
    ----------
    rod : Rod
        From `optimal_rod`, `Rod.straight` or `bend`.
    start, end : (2,) array_like, optional
        Positions of the ends, mm; by default the present positions. A coordinate that the support leaves free is
        ignored.
    angles : pair of float, optional
        Angles of the tangent at the start and the end, rad, counted continuously along the rod (a full turn
        adds 2 pi). None keeps the present angle.
    gravity : Gravity, None or "keep"
        New gravity; None removes the weight.
    supports : Supports, optional
        New supports; by default the supports of the rod.
    force : (2,) array_like, optional
        Components in x and y, 1/mm2, of a force with a constant direction, divided by the least bending stiffness.
        Each component acts at the end where its coordinate is free. None keeps the present force.
    moment : float or pair of float, optional
        Moment over the least bending stiffness, 1/mm, counterclockwise positive. A single moment acts at the end
        with a free angle, a pair at start and end. None keeps the present moment.
    guess : Rod or array_like, optional
        Initial shape: a rod, or angles at the n nodes or n-1 edges.
    side : {+1, -1}, optional
        Side of the first bulge, left (+1) or right (-1) seen from start to end, for a straight rod. By default,
        the rod bends to the left if its ends are pushed together, and remains straight under a force if possible.
        A shortened tie requires `side`.
    mode : int
        Buckling mode of a straight rod; modes above 1 are usually unstable.
    samples : int, optional
        Number of nodes; by default the same as in `rod`.
    settle : bool
        If True, an unstable result is replaced by the stable shape into which the rod moves.
    between : sequence of Rail, Pin and Tie, or "keep"
        New rails, pins and ties, which replace the present ones. Arc lengths are measured along the present
        shape. A pin or rail at a point away from the present shape moves the strip to this point. A pin with the
        same index as a present pin keeps its position on the strip. A tie pulls if its `length` is less than the
        distance between its two points on the strip. The strip may lift off a one-sided rail, and a slack tie
        does not pull.
    loads : sequence of PointMass and PointForce, or "keep"
        New loads; they replace the masses and point forces of the rod. The rod must have a `bending_stiffness`.

    Returns
    -------
    Rod
        The moments balance to 1e-10 of the largest moment, and the positions of the ends are exact to 1e-10
        of the length. The reactions at the ends are `force[0]` and `force[-1]` (the negative internal force)
        and `moment`.

    Raises
    ------
    NotConvergedError
        No equilibrium found; the message states how far the continuation came.

    Examples
    --------
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(70.0, 0.0))
    >>> round(float(arch.position[:, 1].max()), 1)
    31.4
    """
    require_rod(rod, "bend", "Rod.straight")
    rod = rod.following()
    start = rod.position[0] if start is None else start
    end = rod.position[-1] if end is None else end
    if samples is not None and not is_one_of(samples, [rod.s.size]):
        rod = resample(rod, samples)
    if not (gravity is None or isinstance(gravity, Gravity) or is_one_of(gravity, ["keep"])):
        raise InputError(f'gravity is {gravity!r}: give a Gravity record, None or "keep"')
    if not is_one_of(side, (None, 1, -1)):
        raise InputError(f"side is {side!r}: give +1 to bend the rod to the left first, -1 to the right")
    whole_number(mode, "mode", 1)
    keeps = isinstance(between, str) and between == "keep"
    elements = mounted(rod, None if keeps else require_elements(between))
    requested = replace(
        rod,
        gravity=rod.gravity if isinstance(gravity, str) else gravity,
        supports=rod.supports if supports is None else require_supports(supports, between=bool(elements)),
        between=elements,
    )
    if not elements:
        requested.supports.require_held()
    if not (isinstance(loads, str) and loads == "keep"):
        requested = _with_loads(requested, loads)
    system = system_of(requested, rod, start, end, angles, force=force, moment=moment)
    require_flag(settle, "settle")
    if elements:
        _refuse_pins_out_of_reach(elements, system)
        arched = _arched(elements, rod, system, side) if guess is None else guess
        return _bent_on_elements(requested, rod, system, arched, settle=settle)
    before = None if guess is not None else _under_present_loads(rod, system)
    state = state_of(rod, system, before) if guess is None else _guess_state(guess, system)
    rest, at = _rest_or_snapped_state(reach(state, side, mode, before=before), settle=settle)
    return replace(rest.rod(requested), warnings=_warnings(rest, at))


def _rest_or_snapped_state(reached: Reached, *, settle: bool) -> tuple[RodState, float | None]:
    """Return the rest state, and the fraction of the path at which the rod snapped into it (None: no snap)."""
    balanced = reached.arrived and is_balanced(reached.state)
    if balanced and not (settle and reached.state.discrete.unstable_modes):
        return reached.state, None
    snapped = relax(reached.state)
    if snapped is None:
        raise NotConvergedError(
            "no equilibrium was found beyond {fraction:.1%} of the path from the present shape. Move the ends "
            "in smaller steps, or give a guess closer to the result",
            fraction=reached.fraction,
        )
    return snapped, reached.fraction


def _warnings(state: RodState, snaps_at: float | None) -> tuple[str, ...]:
    warnings = [] if snaps_at is None else [_snap_warning(100 * snaps_at)]
    turn = float(np.degrees(np.abs(np.diff(state.angles)).max()))
    if turn >= 60.0:
        warnings.append(note(
            "the strip turns by {turn:.0f} between two nodes, so its shape is inaccurate: use more samples",
            turn=Degrees(turn), severity="warning",
        ))  # fmt: skip
    return tuple(warnings)


def _with_loads(rod: Rod, loads: object) -> Rod:
    plain = None if rod.weight is None else replace(rod.weight, masses=())
    if plain is None and rod.gravity is not None and rod.bending_stiffness is not None:
        plain = Weight(beta=rod.bending_stiffness / rod.gravity.length**3)
    weight, forces = weight_with_loads(plain, rod.gravity, loads)
    masses = weight is not None and bool(weight.masses)
    B = rod.bending_stiffness
    if (masses or forces) and B is None:
        raise InputError(
            "Loads in newtons need a rod with its stiffness in N mm2. Set bending_stiffness of the rod."
        )
    curve = rod.curve
    weight = None if weight is None else with_placed_masses(weight, curve, curve)
    placed = tuple(PlacedElement.on(load, curve, curve) for load in forces)
    acting = tuple(ElementForce(load.element, load.s, load.units[0] / (B or 1.0)) for load in placed)
    return replace(rod, weight=weight if masses or rod.weight is not None else None, point_forces=acting)


def part_of_change(rod: Rod, step: Mapping[str, Any], part: float) -> dict[str, Any]:
    """Return the arguments `loads` and `between` of `bend` at the fraction `part` of a step of `bend_path`.

    The present loads of `rod` decrease to zero, and the loads of the step grow from zero. Points of rails and
    pins, and lengths of ties, are interpolated linearly. If a rail, pin or tie is replaced by another kind, the
    replacement is immediate.
    """
    entry: dict[str, Any] = {}
    if "loads" in step:
        new_loads = several("loads", step["loads"], PointMass | PointForce, "PointMass or PointForce")
        masses = () if rod.weight is None else rod.weight.masses
        present = (*masses, *(action.on_curve for action in rod.point_forces))
        entry["loads"] = (*_scaled(present, 1 - part), *_scaled(new_loads, part))
    if "between" in step:
        goal, present = (mounted(rod, require_elements(step["between"])), mounted(rod, None))
        partners = [*present, *goal[len(present) :]]
        entry["between"] = tuple(
            _interpolated_element(before, after, part) for before, after in zip(partners, goal, strict=False)
        )
    return entry


def _scaled(loads: Sequence[PointMass | PointForce], factor: float) -> tuple[PointMass | PointForce, ...]:
    if factor == 0:
        return ()
    return tuple(
        PointMass(load.at, factor * load.mass)
        if isinstance(load, PointMass)
        else PointForce(load.at, (factor * load.force[0], factor * load.force[1]))
        for load in loads
    )


def _interpolated_element(before: ElementForce, after: ElementForce, part: float) -> Element:
    element, first, last = after.element, before.mounting, after.mounting
    assert isinstance(element, Rail | Pin | Tie)
    if type(before.element) is not type(element) or first == last:
        return element
    if isinstance(element, Tie):
        start, end = after.s.tolist()
        return replace(element, start=start, end=end, length=(1 - part) * first.length + part * last.length)
    x, y = ((1 - part) * a + part * b for a, b in zip(first.point, last.point, strict=True))
    return replace(element, at=(x, y))


def fixed_places(elements: Sequence[ElementForce], system: RodSystem) -> list[tuple[float, FloatArray]]:
    """Return arc length and point, mm, of ends that are held in place and of pins, sorted by arc length."""
    held = [
        (s, place)
        for s, place, end in zip(
            (0.0, system.length), (system.start, system.end), system.supports.ends, strict=True
        )
        if end.x and end.y
    ]
    held += [
        (float(action.s[0]), np.array(action.mounting.point))
        for action in elements
        if isinstance(action.element, Pin)
    ]
    return sorted(held, key=lambda item: item[0])


def _refuse_pins_out_of_reach(elements: Sequence[ElementForce], system: RodSystem) -> None:
    for (s, place), (next_s, next_place) in pairwise(fixed_places(elements, system)):
        apart = float(norm(next_place - place))
        if apart > (next_s - s) * (1 + MEETS_SHARE) + MEETS_SHARE * system.length:
            raise InputError(
                "The places {first} and {second} at which the strip is held are {apart:.6g} apart, but the strip "
                "between them is only {length:.6g} long. Move the pin closer.",
                first=Point(tuple(place)), second=Point(tuple(next_place)), apart=Length(apart),
                length=Length(next_s - s),
            )  # fmt: skip


def _arched(
    elements: Sequence[ElementForce], rod: Rod, system: RodSystem, side: int | None
) -> FloatArray | None:
    """Return the edge angles, rad, of the straight rod buckled by a shortened tie, or None without such a tie."""
    shape, angles = ShapeOfRod.of(rod), rod.discrete.angles
    shorter = [
        action for action in elements
        if isinstance(action.element, Tie) and violation(action, shape) > MEETS_SHARE * shape.length
    ]  # fmt: skip
    if not shorter or np.ptp(angles) > STRAIGHT_RAD:
        return None
    if side is None:
        raise InputError(
            "The strip is straight, so a shorter cord could bend it to either side. Set {field} to the side to "
            "which it bulges.",
            field=FieldName("side"),
        )
    cord = shorter[0]
    start, end = cord.s
    # the buckling load of a hinged rod; the mode changes little with the load
    pull = (np.pi / (end - start)) ** 2 * float(rod.stiffness.mean())
    taut = replace(cord, force=np.sign(end - start) * pull * np.outer((1, -1), shape.tangents[0]))
    pins = (action for action in elements if isinstance(action.element, Pin))
    mode = buckling_mode(replace(system, actions=(taut, *pins)).state(angles), side, 1)[1]
    s = (np.arange(angles.size) + 0.5) * shape.edge_length
    under = (min(start, end) < s) & (s < max(start, end))
    # chord / arc length is about 1 - variance of the angles / 2
    size = np.sqrt(2 * (1 - cord.mounting.length / abs(end - start))) / mode[under].std()
    return np.asarray(angles + size * mode)


ROUNDS = 12
"""Largest number of changes between slack and taut, per tie or one-sided rail."""


def _bent_on_elements(
    wanted: Rod, present: Rod, system: RodSystem, guess: "Rod | ArrayLike | None", *, settle: bool
) -> Rod:
    """Bend a rod with rails, pins and ties, and find out which ties and one-sided rails are taut."""
    elements = list(wanted.between)
    shape = ShapeOfRod.of(present)
    reach_of_rail = MEETS_SHARE * shape.length
    taut = [
        not action.is_one_sided or bool(action.force.any()) or violation(action, shape) >= -reach_of_rail
        for action in elements
    ]
    state, snaps_at, last, remaining = None, None, None, 1.0
    # distances, mm, by which slack rails move and slack ties shorten on the rest of the path
    ahead = np.zeros(len(elements))
    before = system if guess is not None else _under_present_loads(present, system)

    def changed_set(state: RodState, fraction: float) -> list[bool] | None:
        return _changed_taut_set(elements, taut, state, (1 - fraction) * ahead)

    for _ in range(ROUNDS * (1 + len(elements))):
        acting = [i for i, is_taut in enumerate(taut) if is_taut]
        system = replace(system, actions=tuple(elements[i] for i in acting))
        if state is not None:
            state = system.state(state.angles, state.reactions[: len(system.held)])
        elif guess is not None:
            state = _guess_state(guess, system)
        else:
            state = state_of(present, system, before)
        _require_held(state)
        # use short steps after a rail or tie became slack or taut, because the branch of equilibria may end
        # soon
        turn = LARGEST_TURN_RAD if last is None else SMALL_TURN_RAD
        reached = reach(state, None, 1, lambda *at: changed_set(*at) is not None, turn=turn, before=before)
        state = reached.state
        changed = None if reached.arrived else changed_set(state, reached.fraction)
        # if a released rail or tie is taut again at once, the strip is unstable without it and snaps
        leaps = changed == last and changed is not None and sum(taut) < sum(changed)
        if changed is None or (leaps and reached.fraction <= STOP_SHARE):
            state, at = _rest_or_snapped_state(reached, settle=settle)
            snaps_at = snaps_at if at is None else 1 - remaining * (1 - at)
            changed = changed_set(state, 1.0)
        if changed is None:
            _require_held(state)
            return replace(
                state.rod(wanted),
                between=_with_present_forces(elements, taut, state),
                warnings=_warnings(state, snaps_at),
            )
        remaining *= 1 - reached.fraction
        ahead *= 1 - reached.fraction
        before = between_loads(before, system, reached.fraction)
        shape = shape_of(state)
        for i, (was_taut, is_taut) in enumerate(zip(taut, changed, strict=True)):
            if was_taut and not is_taut:
                ahead[i] = violation(elements[i], shape)
        elements, taut, last = list(_with_present_forces(elements, taut, state)), changed, taut
    raise NotConvergedError(
        "The program could not decide which rails, pins and ties carry load in this shape. Move the ends or "
        "change the loads in smaller steps."
    )


def _require_held(state: RodState) -> None:
    """Refuse a state in which the rod can move as a whole."""
    system = state.system
    # the dead force of a rod with two free ends acts at its start
    forces = system.load + np.outer(np.arange(system.edges + 1) == 0, system.force)
    load = resultant(
        state.position - state.position[0], forces, system.length, moment=float(system.moments.sum()),
        other=sum(action.size for action in state.actions),
    )  # fmt: skip
    require_held(system.supports, state.actions, shape_of(state), load)


def shape_of(state: RodState) -> ShapeOfRod:
    """Return the shape of the rod whose unknowns have the values `state`."""
    return ShapeOfRod(state.discrete.tangents, state.system.edge_length, state.position[0])


def _with_present_forces(
    elements: Sequence[ElementForce], taut: Sequence[bool], state: RodState
) -> tuple[ElementForce, ...]:
    shape, acting = shape_of(state), iter(state.actions)
    return tuple(
        with_side(next(acting), shape) if is_taut else touching(action, shape)
        for action, is_taut in zip(elements, taut, strict=True)
    )


def _changed_taut_set(
    elements: Sequence[ElementForce], taut: Sequence[bool], state: RodState, ahead: FloatArray
) -> list[bool] | None:
    """Find the flag in `taut` that contradicts the forces or gaps most. Return `taut` with this flag changed.

    Return None if no flag contradicts them.
    """
    shape, acting = shape_of(state), iter(state.actions)
    largest = np.abs(state.discrete.force).max(initial=0.0)
    wrong, through = np.zeros(len(elements)), np.zeros(len(elements))
    for i, action in enumerate(elements):
        if taut[i]:
            wrong[i] = wrong_force(next(acting), shape)
        else:
            through[i] = violation(action, shape) - ahead[i]
    changed = list(taut)
    if wrong.max() > PULLS_SHARE * largest:
        changed[wrong.argmax()] = False
    elif through.max() > MEETS_SHARE * shape.length:
        changed[through.argmax()] = True
    else:
        return None
    return changed


def _snap_warning(percent: float) -> Refusal:
    return note(
        "the strip snaps into another shape after {percent:.3g} % of the path; the result is this other shape",
        percent=percent,
        severity="warning",
    )


def has_snapped(rod: Rod) -> bool:
    """Return True if `bend` warned that the rod snapped into another shape."""
    return snap_percent(rod) is not None


def snap_percent(rod: Rod) -> float | None:
    """Return the percentage of the change of ends and loads at which the rod snapped, or None."""
    return next(
        (float(warning.values["percent"]) for warning in rod.warnings if is_snap_warning(warning)), None
    )


def is_snap_warning(message: str) -> TypeGuard[Refusal]:
    """Return True if a warning of `bend` states that the rod snapped."""
    return isinstance(message, Refusal) and "percent" in message.values


def bend_path(
    rod: Rod, path: "ArrayLike | Sequence[Mapping[str, Any]]", *, side: int | None = None, mode: int = 1
) -> tuple[Rod, ...]:
    """Return the shapes of a rod whose ends are moved in steps (paper, section 9.5).

    Parameters
    ----------
    rod : Rod
    path : (k, 2) array_like or sequence of mappings
        Successive positions of the end, mm, or a mapping for each step with keywords of `bend`: start, end,
        angles, gravity, force, moment, supports, between, loads.
    side, mode
        As in `bend`, for the first step.

    Returns
    -------
    tuple of Rod
        Rod after each step. The reactions are its `force` and `moment` at the first and the last node.

    Raises
    ------
    InputError, NotConvergedError
        As in `bend`; the message names the step.

    Examples
    --------
    >>> rods = bend_path(Rod.straight(100.0, samples=101), [(90.0, 0.0), (80.0, 0.0), (80.0, 10.0)])
    >>> len(rods)
    3
    """
    require_record(rod, Rod, "what is bent", "a Rod, as optimal_rod or Rod.straight makes one")
    rods = [rod]
    steps = as_steps(path)
    for k, step in enumerate(steps):
        try:
            bent = bend(rods[-1], **step, side=side if k == 0 else None, mode=mode if k == 0 else 1)
        except NotConvergedError as error:
            raise NotConvergedError(f"step {k + 1} of {len(steps)} of the path: {error}") from error
        rods.append(bent)
    progress = Movement.of(rods).progress
    return tuple(
        _with_rescaled_snap(bent, *shares) for bent, shares in zip(rods[1:], pairwise(progress), strict=True)
    )


def _with_rescaled_snap(rod: Rod, start: float, end: float) -> Rod:
    if (percent := snap_percent(rod)) is None:
        return rod
    others = [message for message in rod.warnings if not is_snap_warning(message)]
    return replace(rod, warnings=(_snap_warning(100 * start + (end - start) * percent), *others))


@dataclass(frozen=True, eq=False)
class Movement:
    """Movement of the ends of a rod over several steps.

    Attributes
    ----------
    travel : (k,) array
        Length of the path of the end relative to the start, mm, from the first shape to each of the k shapes.
    turn : (k,) array
        Rotation, rad, of the end that turns more, from the first shape to each shape. Ends that turn freely are
        ignored.
    """

    travel: FloatArray
    turn: FloatArray

    @classmethod
    def of(cls, rods: Sequence[Rod]) -> "Movement":
        """Return the movement of the ends from the successive shapes of a rod."""
        steps = np.diff([rod.chord for rod in rods], axis=0)
        held = [end.angle for end in rods[-1].supports.ends]
        turns = np.abs(np.diff([rod.angle[[0, -1]] for rod in rods], axis=0)) * held
        travel = np.append(0.0, norm(steps).cumsum())
        turn = np.append(0.0, turns[:, int(turns.sum(axis=0).argmax())].cumsum())
        # smaller movements of an end are rounding errors
        still = travel[-1] <= 1e-9 * rods[0].length
        return cls(np.zeros_like(travel) if still else travel.round(9), turn)

    @property
    def is_turn(self) -> bool:
        """True if the ends turn without travel."""
        return bool(self.travel[-1] == 0 and self.turn[-1] > TURNED_RAD)

    @property
    def is_still(self) -> bool:
        """True if the ends neither travel nor turn."""
        return bool(self.travel[-1] == 0 and self.turn[-1] <= TURNED_RAD)

    @property
    def progress(self) -> FloatArray:
        """Completed fraction (k,) of the movement at each of its k shapes, from 0 to 1."""
        amount = self.turn if self.is_turn else self.travel
        return amount / amount[-1] if amount[-1] > 0 else np.linspace(0.0, 1.0, amount.size)


def as_steps(path: "ArrayLike | Sequence[Mapping[str, Any]]") -> list[dict[str, Any]]:
    """Return the steps of a path as keywords of `bend`. Pairs of numbers are positions of the end."""
    if isinstance(path, Sequence) and path and all(isinstance(step, Mapping) for step in path):
        steps = [dict(step) for step in path if isinstance(step, Mapping)]
        names = {
            "start", "end", "angles", "gravity", "force", "moment", "supports", "between", "loads",
        }  # fmt: skip
        for step in steps:
            if set(step) - names:
                raise InputError(
                    f"unknown entry {sorted(set(step) - names)[0]!r} in a path: use {', '.join(sorted(names))}"
                )
        return steps
    points = as_floats(path)
    if points is None:
        raise InputError(
            "the path cannot be read: give a sequence of end positions (x, y), or of dictionaries with options "
            "of `bend`"
        )
    if points.ndim != 2 or points.shape[1] != 2:
        raise InputError(
            f"the path of end positions has the shape {points.shape}: give an array (k, 2), in mm"
        )
    if not np.isfinite(points).all():
        raise InputError("the path of end positions is not finite everywhere: give finite numbers, in mm")
    return [{"end": point} for point in points]


def system_of(
    rod: Rod,
    present: Rod,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    angles: "tuple[float | None, float | None] | ArrayLike | None" = None,
    *,
    force: ArrayLike | None = None,
    moment: float | tuple[float, float] | None = None,
) -> RodSystem:
    """Return the equations of equilibrium of `rod`. Arguments that are None are taken from `present`."""
    if rod.s.size < 4:
        raise InputError(f"a rod of {rod.s.size} nodes cannot be bent: use samples=4 or more")
    system = RodSystem(
        stiffness=rod.stiffness, edge_length=rod.length / (rod.s.size - 1),
        load=_present_load(rod),
        natural_curvature=rod.natural_curvature, supports=rod.supports,
        start=present.position[0].copy() if start is None else pair(start, "start"),
        end=present.position[-1].copy() if end is None else pair(end, "end"),
        end_angles=_end_angles(angles, rod.supports, present), force=_end_force(force, rod.supports,
        present), moments=_end_moments(moment, rod.supports, present), law=rod.bending_law,
        compression=rod.compression,
    )  # fmt: skip
    apart = float(np.linalg.norm(system.chord))
    if apart > system.length * (1 + 1e-12):
        raise InputError(
            "the ends are {apart:.6g} apart, but the rod is only {length:.6g} long: bring the ends closer "
            "together, or use a longer rod",
            apart=Length(apart),
            length=Length(system.length),
        )
    return system


def dead_loads(rod: Rod, times: float = 1.0) -> tuple[FloatArray, tuple[float, float]]:
    """Return the forces and moments on the free ends, multiplied by `times`, as arguments of `bend`."""
    loads = system_of(rod, rod)
    first, last = (times * loads.moments).tolist()
    return times * loads.force, (first, last)


def state_of(rod: Rod, system: RodSystem, before: RodSystem | None = None) -> RodState:
    """Return the present shape of a rod as the first state on the way to an equilibrium of `system`."""
    present = between_loads(before or _under_present_loads(rod, system), system, 0.0)
    if system.actions:
        return _with_reactions(present.state(rod.discrete.angles)).under(system)
    extra = (rod.discrete.force - present.given_force).mean(axis=0)
    return system.state(rod.discrete.angles, extra[list(system.held)])


def _under_present_loads(rod: Rod, system: RodSystem) -> RodSystem:
    released = replace(rod, supports=system.supports)
    return replace(
        system,
        load=_present_load(rod),
        force=_end_force(None, system.supports, released),
        moments=_end_moments(None, system.supports, released),
    )


def _present_load(rod: Rod) -> FloatArray:
    return rod.nodal_load + lumped(rod.point_forces, rod.s.size, rod.length)


def reach(
    state: RodState,
    side: int | None,
    mode: int,
    stop: Stop | None = None,
    *,
    turn: float = LARGEST_TURN_RAD,
    before: RodSystem | None = None,
) -> Reached:
    """Continue from `state` to an equilibrium.

    A straight rod is bent if it must bend, or if `side` is given. The continuation ends early at the first state
    for which `stop` returns True.
    """
    system = state.system
    straight = is_straight(state) and stop is None
    if system.held and np.linalg.norm(system.chord) > system.length * (1 - 1e-12):
        taut = stretch(state)
        if system.compression is not None and is_straight(state):
            return follow(taut, stop)
        if not is_balanced(taut):
            raise InputError(
                "the ends are as far apart as the rod is long ({length:.6g}), so the rod must be straight, "
                "but its end angles or its weight bend it. Bring the ends closer together",
                length=Length(system.length),
            )
        return Reached(taut, 1.0)
    if straight and system.compression is not None:
        bent = reach(state.under(replace(system, compression=None)), side, mode).state
        reached = follow(bent.under(system))
        # an axially elastic rod does not bend if its ends are only a little closer than its length
        return reached if reached.arrived else follow(state)
    return leave_straight(state, side, mode) if straight else follow(state, stop, turn=turn, before=before)


def _guess_state(guess: "Rod | ArrayLike", system: RodSystem) -> RodState:
    n = system.edges
    if isinstance(guess, Rod):
        edges = guess.discrete.angles
        at = (np.arange(edges.size) + 0.5) / edges.size
        edges = np.interp((np.arange(n) + 0.5) / n, at, edges)
    else:
        values = as_floats(guess)
        edges = np.array([]) if values is None else values
        if edges.shape == (n + 1,):
            edges = midpoints(edges)
        if edges.shape != (n,) or not np.isfinite(edges).all():
            raise InputError(
                f"`guess` has the shape {edges.shape}: give a Rod, or {n + 1} angles at the nodes (or {n} at "
                "the edges)"
            )
    return _with_reactions(system.state(edges))


def _with_reactions(state: RodState) -> RodState:
    """Return the state with the support, rail, pin and tie forces that give the least imbalance of moments."""
    if not state.reactions.size:
        return state
    rows = np.where(state.places[:, None], state.rows, 0.0)
    reactions = np.linalg.lstsq(rows @ rows.T, -rows @ state.residual.imbalance, rcond=1e-9)[0]
    return state.system.state(state.angles, state.reactions + reactions)


def _end_angles(
    angles: "tuple[float | None, float | None] | ArrayLike | None", supports: Supports, present: Rod
) -> FloatArray:
    end_angles = np.array([present.angle[0], present.angle[-1]])
    if angles is None:
        return end_angles
    values = np.atleast_1d(np.asarray(angles, dtype=object))
    if values.shape != (2,) or not all(isinstance(v, float | int | np.number | None) for v in values):
        raise InputError(f"angles are {angles!r}: give two numbers in rad, for start and end")
    for i, (value, support, name) in enumerate(zip(values, supports.ends, ("start", "end"), strict=True)):
        if value is None:
            continue
        if not support.angle:
            raise InputError(
                f"an angle is given at the {name}, but the support there leaves the angle free: give None"
            )
        end_angles[i] = float(value)
    if not np.all(np.isfinite(end_angles)):
        raise InputError(f"angles are {angles!r}: give finite numbers, in rad")
    return end_angles


def _end_force(force: ArrayLike | None, supports: Supports, present: Rod) -> FloatArray:
    both = np.array(supports.transmits_force)
    if force is not None:
        components = pair(force, "force")
        components = np.where(np.abs(components) <= ROUNDED_SHARE * norm(components), 0.0, components)
        useless = both & (components != 0)
        if useless.any():
            axis = "xy"[useless.argmax()]
            raise InputError(
                "a force along {axis} has no effect, because both ends are held along {axis}: free one end "
                "along {axis}",
                axis=axis,
            )
        return components
    at_ends = present.force[[0, -1]]
    acting = (*present.between, *present.point_forces)
    if acting:
        load = present.nodal_load + lumped(acting, present.s.size, present.length)
        at_ends = present.discrete.force[[0, -1]] + (-load[0], load[-1])
    at_start, at_end = ~(supports.held | present.supports.held).reshape(2, 3)[:, :2]
    # the applied force is the edge force at the first node, and the negative edge force at the last node
    forces = np.where(at_end, -at_ends[1], np.where(at_start, at_ends[0], 0.0))
    return np.where(np.abs(forces) <= ROUNDED_SHARE * np.abs(present.force).max(), 0.0, forces)


def _end_moments(moment: float | tuple[float, float] | None, supports: Supports, present: Rod) -> FloatArray:
    free = [not end.angle for end in supports.ends]
    moments = np.zeros(2)
    if moment is None:
        return np.where(
            (supports.held | present.supports.held)[[2, 5]], 0.0, present.moment[[0, -1]] * (-1.0, 1.0)
        )
    values = as_floats(moment)
    if values is not None and values.shape == ():
        if free == [True, True]:
            raise InputError(
                "both ends turn freely, so each has its own moment: give both moments, (start, end)"
            )
        moments[free.index(True) if True in free else 0] = float(values)
    elif values is not None and values.shape == (2,):
        moments[:] = values
    else:
        raise InputError(f"moment is {moment!r}: give one number or two (start, end), in 1/mm")
    for k, name in enumerate(("start", "end")):
        if moments[k] != 0 and not free[k]:
            raise InputError(
                (
                    "a moment at the {name} has no effect, because the support holds the angle there: free the "
                    "angle"
                ),
                name=name,
            )
    if not np.isfinite(moments).all():
        raise InputError(f"moment is {moment!r}: give a finite number, in 1/mm")
    return moments
