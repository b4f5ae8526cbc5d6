"""Rest shape of a rod after its ends, loads or supports have changed."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from typing import Any, Literal, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import (
    as_floats,
    is_one_of,
    pair,
    require_flag,
    require_record,
)
from elastica_cad.errors import (
    Degrees,
    FieldName,
    InputError,
    Length,
    NotConvergedError,
    Point,
    Refusal,
    note,
)
from elastica_cad.geometry.plane_points import midpoints, norm
from elastica_cad.mechanics.elements import (
    Element,
    ElementForce,
    Mount,
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
from elastica_cad.mechanics.followed_path import (
    Event,
    FollowedPath,
    Segment,
    Visit,
    followed,
    not_found,
    shape_of,
)
from elastica_cad.mechanics.loads import (
    Gravity,
    PointMass,
    Supports,
    Weight,
    require_supports,
    whole_number,
)
from elastica_cad.mechanics.mounted_elements import MEETS_SHARE, ShapeOfRod, mounted, violation
from elastica_cad.mechanics.newton_continuation import (
    STRAIGHT_RAD,
    Reached,
    follow,
    is_balanced,
    is_straight,
    leave_straight,
    must_shorten,
    stretch,
)
from elastica_cad.mechanics.rod import Rod, require_rod, resample
from elastica_cad.mechanics.rod_system import RodState, RodSystem

Keep = Literal["keep"]

# force components up to this fraction of the largest force in the rod are rounding errors
ROUNDED_SHARE = 1e-12
# largest sum of the forces, and of their moments, on a bent rod, as a fraction of the sum of their sizes
BALANCED_SHARE = 1e-6
# a force of this size, times stiffness / length^2, bends a rod by about this angle, rad
SMALLEST_FORCE = 1e-3
# fraction of the path at which a straight rod is first computed, already bent
FIRST_SHARE = 0.004


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
        Buckling mode of a straight rod whose ends approach each other; modes above 1 are usually unstable.
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
    require_flag(settle, "settle")
    legs = _bend_legs(rod, Change(
        start, end, angles, gravity, supports, force, moment, between, loads, guess, side, mode, samples
    ))  # fmt: skip
    bent = _end_of(legs)
    return _settled(legs[-1]) if settle and bent.discrete.unstable_modes else bent


@dataclass(frozen=True, eq=False)
class Change:
    """What `bend` changes; each field is its keyword. The default changes nothing."""

    start: ArrayLike | None = None
    end: ArrayLike | None = None
    angles: "tuple[float | None, float | None] | ArrayLike | None" = None
    gravity: Gravity | Keep | None = "keep"
    supports: Supports | None = None
    force: ArrayLike | None = None
    moment: float | tuple[float, float] | None = None
    between: "Element | Sequence[Element] | Keep" = "keep"
    loads: "PointMass | PointForce | Sequence[PointMass | PointForce] | Keep" = "keep"
    guess: "Rod | ArrayLike | None" = None
    side: int | None = None
    mode: int = 1
    samples: int | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Leg:
    """Stage of a bend: the ends, rails, pins and ties move, or loads grow.

    Attributes
    ----------
    path : FollowedPath
    loads : (present, new) or None
        Loads that fade and loads that grow along this leg; None if the ends move.
    like : Rod
        Rod with profile, weight and loads of the leg.
    together : bool
        True if loads grow while the ends move, because the rod does not stand without them.
    """

    path: FollowedPath
    like: Rod
    loads: "tuple[Sequence[PointMass | PointForce], Sequence[PointMass | PointForce]] | None" = None
    together: bool = False

    def rod(self, t: float) -> Rod:
        """Return the rod at the fraction t of the leg."""
        like = self.like
        if self.loads is not None and t < 1:
            like = _with_loads(like, (*scaled(self.loads[0], 1 - t), *scaled(self.loads[1], t)))
        return self.path.at(t).rod(like)

    @property
    def warnings(self) -> tuple[Refusal, ...]:
        """What happens on the way, in one sentence for each event."""
        of_loads = self.loads is not None and not self.together
        return tuple(_event_warning(event, of_loads=of_loads) for event in self.path.leaps)


def _bend_legs(rod: Rod, change: Change) -> tuple[Leg, ...]:
    """Return the stages of `bend`: first the ends and what is between them, then the new loads.

    If the rod does not stand without its new loads, they grow while the ends move.
    """
    require_rod(rod, "bend", "Rod.straight")
    rod = rod.following()
    gravity = change.gravity
    start = rod.position[0] if change.start is None else change.start
    end = rod.position[-1] if change.end is None else change.end
    if change.samples is not None and not is_one_of(change.samples, [rod.s.size]):
        rod = resample(rod, change.samples)
    if not (gravity is None or isinstance(gravity, Gravity) or is_one_of(gravity, ["keep"])):
        raise InputError(f'gravity is {gravity!r}: give a Gravity record, None or "keep"')
    whole_number(change.mode, "mode", 1)
    if not isinstance(gravity, str) and np.ptp(rod.discrete.angles) <= STRAIGHT_RAD:
        rod = replace(rod, gravity=gravity)  # a straight rod has no rest shape that its weight could change
    between, supports = change.between, change.supports
    elements = mounted(rod, None if is_one_of(between, ["keep"]) else require_elements(between))
    requested = replace(
        rod,
        gravity=rod.gravity if isinstance(gravity, str) else gravity,
        supports=rod.supports if supports is None else require_supports(supports, between=bool(elements)),
        between=elements,
    )
    if not elements:
        requested.supports.require_held()
    system = system_of(requested, rod, start, end, change.angles, force=change.force, moment=change.moment)
    # refuse places that hold the strip if the straight way from each to the next is longer than the strip;
    # the strip may stay away from a one-sided rail
    rails = [
        (action.s[0], action.mounting.point)
        for action in sorted(elements, key=lambda action: float(action.s[0]))
        if isinstance(action.element, Rail) and not action.is_one_sided
    ]
    for (s, place), (next_s, next_place) in pairwise(fixed_places(elements, system)):
        over = [point for at, point in rails if s < at < next_s]
        apart = float(norm(np.diff([place, *over, next_place], axis=0)).sum())
        if apart > (next_s - s) * (1 + MEETS_SHARE) + MEETS_SHARE * system.length:
            raise InputError(
                "The strip must be at least {apart:.6g} long from {first} over the rails to {second}, but it is "
                "only {length:.6g} long there. Move the rails or the ends closer." if over else
                "The places {first} and {second} at which the strip is held are {apart:.6g} apart, but the strip "
                "between them is only {length:.6g} long. Move the pin closer.",
                first=Point(tuple(place)), second=Point(tuple(next_place)), apart=Length(apart),
                length=Length(next_s - s),
            )  # fmt: skip
    if isinstance(change.loads, str) and change.loads == "keep":
        return (_leg(requested, rod, system, change),)
    loaded = _with_loads(requested, change.loads)
    loads = _loads_of(rod), _loads_of(loaded)
    at_end = replace(system, load=_present_load(loaded))
    moves = segment_to(requested, rod, system)[0].changes
    if moves and change.guess is None:
        try:
            first = _leg(requested, rod, system, change)
            bent = first.rod(1.0)
            loaded = replace(loaded, between=bent.between)
            return first, _leg(loaded, bent, at_end, Change(), loads=loads)
        except (InputError, NotConvergedError):
            pass  # the rod does not stand without its new loads
    return (_leg(loaded, rod, at_end, change, loads=loads, together=moves),)


def _with_loads(rod: Rod, loads: object) -> Rod:
    plain = None if rod.weight is None else replace(rod.weight, masses=())
    # loads in newtons also need the weight of the strip in newtons
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


def scaled(loads: Sequence[PointMass | PointForce], factor: float) -> tuple[PointMass | PointForce, ...]:
    """Return loads multiplied by a factor; none for 0."""
    if factor == 0:
        return ()
    return tuple(
        PointMass(load.at, factor * load.mass)
        if isinstance(load, PointMass)
        else PointForce(load.at, (factor * load.force[0], factor * load.force[1]))
        for load in loads
    )


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


def _begins(action: ElementForce, shape: ShapeOfRod) -> Mount:
    """Return where a rail, pin or tie begins: at the present shape if it acts there, or else in its place."""
    mount, beyond = action.mounting, violation(action, shape)
    if action.is_one_sided and not action.force.any() and beyond <= MEETS_SHARE * shape.length:
        return mount
    if isinstance(action.element, Tie):
        return replace(mount, length=mount.length + beyond)
    pinned = isinstance(action.element, Pin)
    s = float(action.s[0]) if pinned else shape.foot(np.array(mount.point))
    x, y = shape.at(s).tolist()
    return replace(mount, point=(x, y))


def _arched(segment: Segment, visit: Visit, side: int | None) -> FloatArray | None:
    """Return the edge angles, rad, of the straight rod buckled by a shortened tie, or None without such a tie."""
    state, shape = visit.state, shape_of(visit.state)
    elements = segment.elements_at(FIRST_SHARE, visit.elements)
    cord = next((action for action in elements if isinstance(action.element, Tie)
                 and violation(action, shape) > 0), None)  # fmt: skip
    if cord is None:
        return None
    if side is None:
        raise InputError(
            "The strip is straight, so a shorter cord could bend it to either side. Set {field} to the side to "
            "which it bulges.",
            field=FieldName("side"),
        )
    low, high = sorted(cord.s.tolist())
    # half a sine wave between the ends of the cord; chord / arc length is about 1 - variance of the angles / 2
    s = (np.arange(state.angles.size) + 0.5) * shape.edge_length
    wave = np.cos(np.pi * ((s - low) / (high - low)).clip(0.0, 1.0))
    return np.asarray(state.angles + side * 2 * np.sqrt(1 - cord.mounting.length / (high - low)) * wave)


def _taut(elements: Sequence[ElementForce], shape: ShapeOfRod) -> tuple[bool, ...]:
    """Return which rails, pins and ties carry load, or touch the strip without a gap."""
    return tuple(
        not action.is_one_sided
        or bool(action.force.any())
        or violation(action, shape) >= -MEETS_SHARE * shape.length
        for action in elements
    )


def segment_to(requested: Rod, rod: Rod, system: RodSystem) -> tuple[Segment, Visit]:
    """Return the path from the present shape of `rod` to `system`, and the shape as its first visit."""
    elements, shape = requested.between, ShapeOfRod.of(rod)
    mounts = tuple(_begins(action, shape) for action in elements)
    n, length = rod.s.size, rod.length
    # forces of rails, pins and ties that are replaced by `elements` count as loads
    replaced = lumped(rod.between, n, length) - lumped(elements, n, length)
    present = replace(
        system,
        start=rod.position[0], end=rod.position[-1], end_angles=rod.angle[[0, -1]],
        load=_present_load(rod) + (replaced if rod.between else 0.0),
        force=_end_force(None, system.supports, rod),
        moments=_end_moments(None, system.supports, rod),
    )  # fmt: skip
    segment = Segment(present, system, elements, mounts)
    begins = segment.elements_at(0.0, elements)
    taut = _taut(begins, shape)
    return segment, Visit(0.0, state_of(rod, segment.system(0.0, begins, taut)), begins, taut)


def _leg(
    requested: Rod,
    rod: Rod,
    system: RodSystem,
    change: Change,
    **kind: Any,
) -> Leg:
    """Return the stage from the present shape of `rod` to an equilibrium of `system`."""
    segment, visit = segment_to(requested, rod, system)
    if requested.between:
        visit.require_held()
    side, mode = change.side, change.mode
    if change.guess is not None:
        state = _guess_state(change.guess, segment.system(1.0, visit.elements, visit.taut))
        path = followed(segment, segment.at_rest(1.0, state, visit), watched=False)
    else:
        first, to = first_visit(segment, visit, side, mode)
        watched = mode == 1 and not (rod.discrete.unstable_modes and side is None)
        path = followed(segment, first, side=to, watched=watched)
    if side is not None and is_straight(path.visits[-1].state):
        raise InputError(
            "the load is too small to buckle the straight rod: increase the load or the length, or leave out "
            "`side` to keep the rod straight"
        )
    if requested.between:
        path.visits[-1].require_held()
    leg = Leg(path, requested, **kind)
    # require that the forces of the result, and their moments, add up to zero
    bent = leg.rod(1.0)
    nodes, acting, moment = bent.position, bent.acting, bent.moment
    points = [nodes[[0, -1]], nodes, *(action.points_on(nodes, bent.length) for action in acting)]
    forces = [bent.support_forces, bent.nodal_load, *(action.force for action in acting)]
    rest = np.abs(resultant(
        np.concatenate(points) - nodes[0], np.concatenate(forces), bent.length,
        moment=float(moment[-1] - moment[0]),
        other=float(np.abs(moment).max()) / bent.length + SMALLEST_FORCE / bent.length**2,
    )).max()  # fmt: skip
    if rest > BALANCED_SHARE:
        raise NotConvergedError(
            "the forces on the bent strip do not balance: {percent:.2g} % of them is left. Use another number of "
            "samples",
            percent=100 * float(rest),
        )
    return leg


def first_visit(
    segment: Segment, visit: Visit, side: int | None, mode: int = 1
) -> tuple[Visit | Event, int | None]:
    """Return the first equilibrium of a path, and the side to which a straight rod buckles on the way."""
    if not is_one_of(side, (None, 1, -1)):
        raise InputError(f"side is {side!r}: give +1 to bend the rod to the left first, -1 to the right")
    final, state = segment.last, visit.state
    # True if the ends are as far apart as the rod is long, so that it must be straight
    long = bool(final.held) and np.linalg.norm(final.chord) > final.length * (1 - 1e-12)
    if not (long or is_straight(state)):
        return segment.at_rest(0.0 if segment.changes else 1.0, state, visit), side
    arched = _arched(segment, visit, side)
    if arched is not None:
        guess = segment.system(FIRST_SHARE, visit.elements, visit.taut).state(arched)
        return segment.at_rest(FIRST_SHARE, _with_reactions(guess), visit), side
    # a straight rod whose ends do not approach each other need not buckle
    if not (long or mode > 1 or must_shorten(state.under(final))):
        return segment.at_rest(0.0, state, visit), side
    a, b = final.held_angles
    turn = 0.0 if a is None or b is None else b - a
    # if the held end angles differ much, the sign of the difference determines the default side
    side = side or (-int(np.sign(turn)) if abs(turn) > 0.5 else 1)
    found: list[Visit | Event] = []
    # near the start of the path, the rod may be unstable on this side, so begin at a later place then
    for t in (1.0,) if long or mode > 1 else (FIRST_SHARE, 0.1, 0.4, 1.0):
        plain = segment.system(t, visit.elements, [False] * len(visit.elements))
        reached = reach(plain.state(state.angles, state.reactions[: len(plain.held)]), side, mode)
        if not visit.elements and reached.arrived and is_balanced(reached.state):
            found.append(replace(visit, t=t, state=reached.state))
        else:
            begins = segment.elements_at(t, visit.elements)
            visit = replace(visit, taut=_taut(begins, shape_of(reached.state)))
            bent = segment.system(t, visit.elements, visit.taut).state(reached.state.angles)
            found.append(segment.at_rest(t, _with_reactions(bent), visit))
        if isinstance(found[-1], Visit) and not found[-1].state.discrete.unstable_modes:
            return found[-1], side
    return found[0], side


def _settled(leg: Leg) -> Rod:
    """Return the stable shape into which the unstable result of a leg moves."""
    last = leg.path.visits[-1]
    rest = leg.path.segment.settled(1.0, last.state, last)
    if rest is None:
        raise not_found(1.0)
    return replace(rest.rod(leg.like), warnings=(_snap_warning(100.0, of_loads=False),))


def _event_warning(event: Event, *, of_loads: bool) -> Refusal:
    if event.kind == "snap" or event.other is None:
        return _snap_warning(100 * event.t, of_loads=of_loads)
    return note(
        "the strip buckles after {percent:.3g} % of the path, and nothing decides to which side; the result is one "
        "of two shapes",
        percent=100 * event.t,
        severity="warning",
    )


def _snap_warning(percent: float, *, of_loads: bool) -> Refusal:
    text = (
        "the strip snaps into another shape under {percent:.3g} % of the new loads; the result is this other shape"
        if of_loads
        else "the strip snaps into another shape after {percent:.3g} % of the path; the result is this other shape"
    )
    return note(text, percent=percent, severity="warning")


def inaccuracies(rod: Rod) -> tuple[str, ...]:
    """Return a warning if the nodes of a bent rod are too far apart for its shape."""
    turn = float(np.degrees(np.abs(np.diff(rod.discrete.angles)).max()))
    if turn < 60.0:
        return ()
    return (note(
        "the strip turns by {turn:.0f} between two nodes, so its shape is inaccurate: use more samples",
        turn=Degrees(turn), severity="warning",
    ),)  # fmt: skip


def has_snapped(rod: Rod) -> bool:
    """Return True if `bend` warned that the rod snapped, or buckled to one of two equal sides."""
    return snap_percent(rod) is not None


def snap_percent(rod: Rod) -> float | None:
    """Return the percentage of the movement, or of the new loads, at which the rod snapped or buckled, or None.

    Only the warnings of these events have a value `percent`.
    """
    notes = (message for message in rod.warnings if isinstance(message, Refusal))
    return next((float(one.values["percent"]) for one in notes if "percent" in one.values), None)


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
    return tuple(map(_end_of, _legs_of_steps(rod, path, side, mode)))


def path_legs(
    rod: Rod, path: "ArrayLike | Sequence[Mapping[str, Any]]", *, side: int | None = None
) -> list[Leg]:
    """Return the stages of all steps of a path, as in `bend_path`."""
    return [leg for legs in _legs_of_steps(rod, path, side, 1) for leg in legs]


def _legs_of_steps(
    rod: Rod, path: "ArrayLike | Sequence[Mapping[str, Any]]", side: int | None, mode: int
) -> Iterator[tuple[Leg, ...]]:
    steps = as_steps(path)
    for k, step in enumerate(steps):
        try:
            legs = _bend_legs(rod, Change(**step) if k else Change(**step, side=side, mode=mode))
        except NotConvergedError as error:
            raise NotConvergedError(f"step {k + 1} of {len(steps)} of the path: {error}") from error
        yield legs
        rod = legs[-1].rod(1.0)


Place: TypeAlias = tuple[int, float]
"""Number of a leg, and a fraction of it."""


def places_of(legs: Sequence[Leg], steps: int) -> tuple[Place, ...]:
    """Return the places of the shapes that are listed: `steps` in each leg and, if above 1, the start of the first.

    A straight rod is listed from its first bent shape on.
    """
    first = ((0, 0.0),) if steps > 1 and legs[0].path.visits[0].t == 0 else ()
    places = ((k, j / steps) for k in range(len(legs)) for j in range(1, steps + 1))
    return (*first, *(place for place in places if place[1] >= legs[place[0]].path.visits[0].t))


def _end_of(legs: Sequence[Leg]) -> Rod:
    """Return the rod after the stages of a bend, with what happened on the way as warnings."""
    bent = legs[-1].rod(1.0)
    return replace(bent, warnings=(*(text for leg in legs for text in leg.warnings), *inaccuracies(bent)))


def as_steps(path: "ArrayLike | Sequence[Mapping[str, Any]]") -> list[dict[str, Any]]:
    """Return the steps of a path as keywords of `bend`. Pairs of numbers are positions of the end."""
    if isinstance(path, Sequence) and path and all(isinstance(step, Mapping) for step in path):
        steps = [dict(step) for step in path if isinstance(step, Mapping)]
        names = {field.name for field in fields(Change)} - {"guess", "side", "mode", "samples"}
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


def state_of(rod: Rod, system: RodSystem) -> RodState:
    """Return the present shape of a rod as the first state on the way to an equilibrium of `system`."""
    if system.actions:
        return _with_reactions(system.state(rod.discrete.angles))
    # the reactions are the part of the edge forces that the loads do not explain, the same for all edges
    extra = (rod.discrete.force - system.given_force).mean(axis=0)
    return system.state(rod.discrete.angles, extra[list(system.held)])


def _present_load(rod: Rod) -> FloatArray:
    return rod.nodal_load + lumped(rod.point_forces, rod.s.size, rod.length)


def _loads_of(rod: Rod) -> tuple[PointMass | PointForce, ...]:
    masses = () if rod.weight is None else rod.weight.masses
    return (*masses, *(action.on_curve for action in rod.point_forces))


def reach(state: RodState, side: int, mode: int) -> Reached:
    """Continue from a straight or taut state to an equilibrium. The rod is bent if it must bend."""
    system = state.system
    if system.held and np.linalg.norm(system.chord) > system.length * (1 - 1e-12):
        taut = stretch(state)
        if system.compression is not None and is_straight(state):
            return follow(taut)
        if not is_balanced(taut):
            raise InputError(
                "the ends are as far apart as the rod is long ({length:.6g}), so the rod must be straight, "
                "but its end angles or its weight bend it. Bring the ends closer together",
                length=Length(system.length),
            )
        return Reached(taut, 1.0)
    if system.compression is not None:
        bent = reach(state.under(replace(system, compression=None)), side, mode).state
        reached = follow(bent.under(system))
        # an axially elastic rod does not bend if its ends are only a little closer than its length
        return reached if reached.arrived else follow(state)
    return leave_straight(state, side, mode)


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
    # coordinates (2,) that neither the present nor the new support holds, at the start and at the end
    at_start, at_end = ~(supports.held | present.supports.held).reshape(2, 3)[:, :2]
    # the applied force is the edge force at the first node, and the negative edge force at the last node
    forces = np.where(at_end, -at_ends[1], np.where(at_start, at_ends[0], 0.0))
    return np.where(np.abs(forces) <= ROUNDED_SHARE * np.abs(present.force).max(), 0.0, forces)


def _end_moments(moment: float | tuple[float, float] | None, supports: Supports, present: Rod) -> FloatArray:
    """Return the counterclockwise moments (2,) on start and end, 1/mm. None keeps those of `present`."""
    free = [not end.angle for end in supports.ends]
    moments = np.zeros(2)
    if moment is None:
        # a counterclockwise moment at the start bends the rod to the right, so M changes its sign; the angles
        # of the ends are entries 2 and 5 of `held`
        return np.where(
            (supports.held | present.supports.held)[[2, 5]], 0.0, present.moment[[0, -1]] * (-1.0, 1.0)
        )
    values = as_floats(moment)
    if values is not None and values.shape == ():
        if all(free):
            raise InputError(
                "both ends turn freely, so each has its own moment: give both moments, (start, end)"
            )
        # without a free end, the moment is refused below
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
