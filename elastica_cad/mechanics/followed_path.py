"""Equilibria of a rod while its ends, loads, rails, pins and ties change slowly, and what happens on the way.

The path leads from 0 (present values) to 1 (required values). All values change linearly, as a slow hand would
change them.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.mechanics.elements import ElementForce, Mount, Rail, resultant
from elastica_cad.mechanics.mounted_elements import (
    MEETS_SHARE,
    PULLS_SHARE,
    ShapeOfRod,
    require_held,
    touching,
    violation,
    with_side,
    wrong_force,
)
from elastica_cad.mechanics.newton_continuation import (
    SMALL_TURN_RAD,
    correct,
    first_bulge,
    follow,
    is_straight,
    newton_step,
    relax,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.rod_system import RodState, RodSystem, Step

# accuracy of events, as a fraction of the path
LOCATED_SHARE = 1e-6
# step after an event, as a fraction of the path
FIRST_STEP = 1e-4
# largest rotation of an edge in a step, rad
LARGEST_TURN_RAD = 0.3
# largest difference between a step and its prediction, as a fraction of the step
MISSED_SHARE = 0.25
# smallest rotation, rad, that is reported as a leap into another shape
LEAP_RAD = 1e-3
# size of a response, rad, that can be a rounding error
ROUNDED_RAD = 1e-5
# rotation, rad, with which a rod leaves an equilibrium that is no longer stable
PUSH_RAD = 0.02
# largest number of changes between slack and taut at one place of the path, per rail, pin and tie
ROUNDS = 12
# largest number of events on a path
MOST_EVENTS = 200

CHANGING = ("start", "end", "end_angles", "load", "force", "moments")
"""Fields of `RodSystem` that change along a path."""


def shape_of(state: RodState) -> ShapeOfRod:
    """Return the shape of the rod whose unknowns have the values `state`."""
    return ShapeOfRod(state.discrete.tangents, state.system.edge_length, state.position[0])


@dataclass(frozen=True, eq=False, repr=False)
class Visit:
    """Equilibrium at the fraction `t` of a path.

    `elements` are all rails, pins and ties, each with its present force; `taut` says which of them carry load.
    """

    t: float
    state: RodState
    elements: tuple[ElementForce, ...]
    taut: tuple[bool, ...]

    @classmethod
    def of(cls, t: float, state: RodState, elements: Sequence[ElementForce], taut: Sequence[bool]) -> "Visit":
        """Return the visit of a state, with the forces of its rails, pins and ties."""
        if not elements:
            return cls(t, state, (), ())
        shape, acting = shape_of(state), iter(state.actions)
        present = []
        for action, is_taut in zip(elements, taut, strict=True):
            now = next(acting) if is_taut else touching(action, shape)
            # the direction of a force that is a rounding error decides no side
            present.append(with_side(now, shape) if now.size > _rounded(state) else now)
        return cls(t, state, tuple(present), tuple(taut))

    @property
    def undecided(self) -> bool:
        """True if a rail that touches the strip may still push to either side."""
        rails = (
            action for action in self.elements if isinstance(action.element, Rail) and action.is_one_sided
        )
        return any(not rail.mounting.side for rail in rails)

    def rod(self, like: Rod) -> Rod:
        """Return the rod of this equilibrium, with the profile, weight and section of `like`."""
        rod = self.state.rod(like)
        return replace(rod, between=self.elements) if self.elements else rod

    @property
    def changed(self) -> tuple[bool, ...] | None:
        """`taut` with one wrong flag changed, or None if no flag is wrong.

        The flag is that of the slack rail or tie that the strip passes farthest, or else that of the taut rail or
        tie with the largest force in a direction that it cannot exert.
        """
        shape = shape_of(self.state)
        pairs = zip(self.elements, self.taut, strict=True)
        wrong = np.array([wrong_force(action, shape) if taut else 0.0 for action, taut in pairs])
        return self.closed or self._with_flag(wrong, _rounded(self.state))

    @property
    def closed(self) -> tuple[bool, ...] | None:
        """`taut` with the flag of the slack rail or tie that the strip passes farthest, or None."""
        shape = shape_of(self.state)
        pairs = zip(self.elements, self.taut, strict=True)
        through = np.array([0.0 if taut else violation(action, shape) for action, taut in pairs])
        return self._with_flag(through, MEETS_SHARE * shape.length)

    def _with_flag(self, sizes: FloatArray, least: float) -> tuple[bool, ...] | None:
        """Return `taut` with the flag of the largest of the sizes changed, or None if it is at most `least`."""
        if sizes.max(initial=0.0) <= least:
            return None
        return tuple(flag != (k == sizes.argmax()) for k, flag in enumerate(self.taut))

    def require_held(self) -> None:
        """Refuse a state in which the rod can move as a whole."""
        state, system = self.state, self.state.system
        # the dead force of a rod with two free ends acts at its start
        forces = system.load + np.outer(np.arange(system.edges + 1) == 0, system.force)
        load = resultant(
            state.position - state.position[0], forces, system.length, moment=float(system.moments.sum()),
            other=sum(action.size for action in state.actions),
        )  # fmt: skip
        require_held(system.supports, state.actions, shape_of(state), load)


def _rounded(state: RodState) -> float:
    """Return the largest force, 1/mm2, that counts as a rounding error."""
    return PULLS_SHARE * max(float(np.abs(state.discrete.force).max()), state.system.length**-2)


@dataclass(frozen=True, eq=False, repr=False)
class Event:
    """Place of a path at which a rod leaves its shape.

    Attributes
    ----------
    t : float
        Fraction of the path.
    kind : {"snap", "buckle"}
        "snap": the shape ends, and the rod jumps into another one. "buckle": the shape is no longer stable, and
        the rod bends away from it.
    before : Visit
        Last stable shape.
    after : Visit or None
        Stable shape into which the rod moves; None if none was found.
    other : Visit or None
        Second shape into which the rod could as well move, if nothing decides between both.
    """

    t: float
    kind: Literal["snap", "buckle"]
    before: Visit
    after: Visit | None
    other: Visit | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Segment:
    """Equations of a rod along a path.

    Attributes
    ----------
    first, last : RodSystem
        Equations at the start and at the end of the path, without rails, pins and ties.
    elements : tuple of ElementForce
        Rails, pins and ties, with their places at the end of the path.
    mounts : tuple of Mount
        Their places at the start of the path.
    """

    first: RodSystem
    last: RodSystem
    elements: tuple[ElementForce, ...] = ()
    mounts: tuple[Mount, ...] = ()

    @property
    def changes(self) -> bool:
        """True if the path changes more than rounding errors."""
        pairs = [(getattr(self.first, name), getattr(self.last, name), 1e-12) for name in CHANGING]
        for first, element in zip(self.mounts, self.elements, strict=True):
            last = element.mounting
            # the discrete rod is this far from the curve on which rails, pins and ties were placed
            pairs.append(([*first.point, first.length], [*last.point, last.length], 1e-5 * self.last.length))
        return not all(np.allclose(first, last, rtol=1e-9, atol=small) for first, last, small in pairs)

    def system(self, t: float, elements: Sequence[ElementForce], taut: Sequence[bool]) -> RodSystem:
        """Return the equations at the fraction t, with the rails, pins and ties that are taut."""
        actions = self.elements_at(t, elements)
        acting = tuple(action for action, is_taut in zip(actions, taut, strict=True) if is_taut)
        changed = {
            name: getattr(self.last, name) - (1 - t) * (getattr(self.last, name) - getattr(self.first, name))
            for name in CHANGING
        }
        return replace(self.last, actions=acting, **changed)

    def elements_at(self, t: float, elements: Sequence[ElementForce]) -> tuple[ElementForce, ...]:
        """Return rails, pins and ties at their places of the fraction t, on the same side of the strip."""
        return tuple(
            replace(action, mount=replace(_between(first, last.mounting, t), side=action.mounting.side))
            for action, first, last in zip(elements, self.mounts, self.elements, strict=True)
        )

    def moved(self, visit: Visit, t: float) -> tuple[Visit, int] | None:
        """Return the equilibrium at t near a visit, and the number of Newton steps, or None if none was found.

        A shape far from the one that the first Newton step predicts may be on another branch, and is not taken.
        """
        start = visit.state.under(self.system(t, visit.elements, visit.taut))
        corrected = correct(start, turn=LARGEST_TURN_RAD)
        if corrected is None:
            return None
        turned = corrected[0].angles - start.angles
        missed = np.abs(turned - newton_step(start, start.residual).angles).max()
        if missed > max(SMALL_TURN_RAD, MISSED_SHARE * np.abs(turned).max()):
            return None
        elements = self.elements_at(t, visit.elements)
        return Visit.of(t, corrected[0], elements, visit.taut), corrected[1]

    def switched(self, visit: Visit, taut: tuple[bool, ...]) -> RodState:
        """Return the state of a visit as the first guess with other taut rails, pins and ties."""
        system = self.system(visit.t, visit.elements, taut)
        return system.state(visit.state.angles, visit.state.reactions[: len(system.held)])

    def at_rest(self, t: float, state: RodState, like: Visit) -> "Visit | Event":
        """Return the equilibrium at t to which the imbalance of a state leads, or the event in which it ends."""
        visit, state = replace(like, t=t), state.under(self.system(t, like.elements, like.taut))
        for _ in range(ROUNDS * (1 + len(like.elements))):
            reached = follow(state)
            if not reached.arrived:
                break
            visit = Visit.of(t, reached.state, self.elements_at(t, visit.elements), visit.taut)
            changed = visit.changed
            if changed is None:
                return visit
            state, visit = self.switched(visit, changed), replace(visit, taut=changed)
        settled = self.settled(t, reached.state, visit)
        if settled is None:
            raise not_found(t)
        return Event(t * reached.fraction, "snap", visit, settled)

    def settled(self, t: float, state: RodState, like: Visit) -> Visit | None:
        """Return the stable equilibrium at t that is found by descent of the energy, or None."""
        visit = replace(like, t=t)
        for _ in range(ROUNDS * (1 + len(like.elements))):
            now = replace(visit, elements=self.elements_at(t, visit.elements))
            # a slack rail or tie that the descent meets stops it, and then carries load
            rest = relax(state, partial(_meets, now) if now.elements else None)
            if rest is None or _is_kinked(rest):
                return None
            visit = Visit.of(t, rest, now.elements, now.taut)
            changed = visit.changed
            if changed is None:
                return visit
            state, visit = self.switched(visit, changed), replace(visit, taut=changed)
        return None


def _meets(visit: Visit, state: RodState) -> bool:
    """Return True if a state passes a rail or tie that is slack in a visit."""
    return replace(visit, state=state).closed is not None


def _between(first: Mount, last: Mount, t: float) -> Mount:
    (x, y), (to_x, to_y) = first.point, last.point
    return Mount(
        (x + t * (to_x - x), y + t * (to_y - y)), last.side, first.length + t * (last.length - first.length)
    )


@dataclass(frozen=True, eq=False, repr=False)
class FollowedPath:
    """Equilibria along a path, from which those between are computed, and the events on the way."""

    segment: Segment
    visits: tuple[Visit, ...]
    events: tuple[Event, ...]

    @property
    def leaps(self) -> tuple[Event, ...]:
        """Events in which a bent rod leaves its shape; that a straight rod buckles is no surprise."""
        return tuple(
            event for event in self.events
            if not is_straight(event.before.state)
            and event.after is not None
            and np.abs(event.after.state.angles - event.before.state.angles).max() > LEAP_RAD
        )  # fmt: skip

    def at(self, t: float) -> Visit:
        """Return the equilibrium at the fraction t of the path, after the events up to there.

        A rod that is straight at first is known from its first bent shape on.
        """
        # of several visits at one place, the last is after the event there
        near = next((visit for visit in reversed(self.visits) if visit.t <= t), self.visits[0])
        if near.t >= t:
            return near
        beyond = next(visit for visit in self.visits if visit.t > t)
        between = None if near.taut != beyond.taut else self.segment.moved(_interpolated(near, beyond, t), t)
        return _stepped(self.segment, near, t) if between is None else between[0]


def _interpolated(first: Visit, last: Visit, t: float) -> Visit:
    """Return the first guess at t between two visits with the same taut rails and ties."""
    a, b = first.state, last.state
    step = Step(b.angles - a.angles, b.reactions - a.reactions)
    return replace(first, state=a.moved(step, (t - first.t) / (last.t - first.t)))


def _stepped(segment: Segment, visit: Visit, goal: float) -> Visit:
    """Return the equilibrium at `goal` on the branch of a visit; no event is between them."""
    share = 1.0
    while visit.t != goal:
        t = goal if share == 1 else visit.t + share * (goal - visit.t)
        moved = segment.moved(visit, t)
        if moved is None:
            share /= 2
            if share < LOCATED_SHARE:
                return visit
            continue
        visit, share = moved[0], 1.0
    return visit


def followed(
    segment: Segment,
    first: Visit | Event,
    *,
    side: int | None = None,
    watched: bool = True,
    once: bool = False,
) -> FollowedPath:
    """Follow the equilibria of a segment from a visit to the end of the path.

    Where an equilibrium is no longer stable, the rod moves into the stable shape that descent of the energy
    finds at this place of the path, and the path continues from there, or ends there if `once`. Without
    `watched`, unstable equilibria are followed. `side` is the side of the first bulge of a straight rod; with
    None, it stays straight.

    Raises
    ------
    NotConvergedError
        No equilibrium was found beyond a place of the path.
    """
    events = list[Event]()
    if isinstance(first, Visit) and watched and _is_unstable(first.state, side):
        first = _left(segment, first, first.t, side)
    if isinstance(first, Event):
        events.append(first)
        first = _landed(first)
    visit, visits = first, [first]
    # the first small movement decides the side to which a rail pushes; while `near`, a fault is known within twice
    # the step, and each step halves this distance
    step, near = FIRST_STEP if visit.undecided else 1.0 - visit.t, False
    while visit.t < 1.0:
        goal = min(visit.t + step, 1.0)
        width = goal - visit.t
        moved = segment.moved(visit, goal)
        fault = _fault(visit, moved, side, watched=watched)
        if moved is not None and fault is None:
            visit = moved[0]
            # after at most 4 steps of Newton's method, the next step is twice as long
            step = width / 2 if near else width * (2 if moved[1] <= 4 else 1)
        elif width > 2 * LOCATED_SHARE:
            # a solution that is lost may be found with a shorter step, so it does not locate a fault
            step, near = width / 2, fault != "lost"
            continue
        else:
            contact = None if moved is None else moved[0].changed
            after = None if contact is None or moved is None else _after_contact(segment, moved[0], contact)
            if after is None:
                events.append(_left(segment, visit, goal, side))
                if once:
                    break
                after = _landed(events[-1])
            if len(events) > MOST_EVENTS:
                raise not_found(goal)
            visit, step, near = after, FIRST_STEP, False
        visits.append(visit)
        if near and step < LOCATED_SHARE:  # the next step contains the fault and is short enough for an event
            step, near = 2 * step, False
    return FollowedPath(segment, tuple(visits), tuple(events))


def _landed(event: Event) -> Visit:
    if event.after is None:
        raise not_found(event.t)
    return event.after


def _fault(visit: Visit, moved: tuple[Visit, int] | None, side: int | None, *, watched: bool) -> str | None:
    """Return why a step is not taken as it is: "lost", "contact" or "unstable", or None."""
    if moved is None or _is_kinked(moved[0].state):
        return "lost"
    after = moved[0]
    if after.changed is not None:
        return "contact"
    if watched:
        return "unstable" if _is_unstable(after.state, side) else None
    turned = float(np.abs(after.state.angles - visit.state.angles).max())
    modes = after.state.discrete.unstable_modes
    return "lost" if turned > SMALL_TURN_RAD and modes != visit.state.discrete.unstable_modes else None


def _is_kinked(state: RodState) -> bool:
    """Return True if the material is beyond its crest, where a kink is as sharp as the edges are short."""
    law = state.system.law
    return law is not None and bool(np.abs(state.change).max() > law.injective_limit)


def _is_unstable(state: RodState, side: int | None) -> bool:
    """Return True if a rod leaves a shape. A straight rod remains straight if no side is chosen."""
    return bool(state.discrete.unstable_modes) and not (side is None and is_straight(state))


def _after_contact(segment: Segment, visit: Visit, changed: tuple[bool, ...]) -> Visit | None:
    """Return the stable equilibrium after a rail or tie became slack or taut, or None if the rod leaves it."""
    seen = {visit.taut}
    while changed not in seen:
        seen.add(changed)
        corrected = correct(segment.switched(visit, changed))
        if corrected is None:
            return None
        visit = Visit.of(visit.t, corrected[0], visit.elements, changed)
        again = visit.changed
        if again is None:
            visit.require_held()
            return None if corrected[0].discrete.unstable_modes else visit
        changed = again
    return None


def _left(segment: Segment, before: Visit, t: float, side: int | None) -> Event:
    """Return the event in which the rod leaves a shape that is not stable at t.

    Where a branch ends, the linear response of the rod is its critical mode, and it snaps; or else it buckles.
    """
    # closer to the place, rounding errors alone cause a response
    near = before if t == before.t else _stepped(segment, before, max(before.t - 1e-3, 0.0))
    mode = near.state.discrete.lowest_modes()[1][0]
    push = Step(PUSH_RAD * mode / np.abs(mode).max(), np.zeros_like(before.state.reactions))
    later = near.state.under(segment.system(min(near.t + FIRST_STEP, 1.0), near.elements, near.taut))
    response = newton_step(later, later.residual).angles
    # cosine of the angle between response and mode: almost 1 or -1 where a branch ends
    lean = float(mode @ response / max(np.linalg.norm(mode) * np.linalg.norm(response), ROUNDED_RAD))
    buckles = t == before.t or abs(lean) < 0.5
    if t == before.t:  # unstable from the start: the rod moves against the gradient of the energy
        lean = -float(mode @ later.residual.imbalance) / later.scale
    left = 1.0 if first_bulge(mode) > 0 else -1.0  # sign with which the mode bulges to the left first
    # if the change of loads and ends does not decide, the rod moves to the left
    decided = abs(lean) > (1e-9 if t == before.t else 0.5)
    first = side * left if side and buckles else float(np.sign(lean)) if decided else left
    found = []
    for sign in (first, -first)[: 2 if buckles else 1]:
        # where many shapes have almost the same energy, the descent leads on only a little farther along the path
        for at in (min(t + share, 1.0) for share in (1e-3, 1e-2)):
            pushed = before.state.under(segment.system(at, before.elements, before.taut)).moved(push, sign)
            visit = segment.settled(at, pushed, before)
            if visit is not None:
                # the other shape exists at this place too, but a buckled one only beyond it
                found.append(visit if buckles else _stepped(segment, visit, t))
                break
    differ = len(found) > 1 and np.abs(found[0].state.angles - found[1].state.angles).max() > PUSH_RAD / 4
    after, other = (*found, None, None)[:2]
    return Event(t, "buckle" if buckles else "snap", before, after, other if differ else None)


def not_found(t: float) -> NotConvergedError:
    """Return the error that no equilibrium was found beyond the fraction t of a path."""
    return NotConvergedError(
        "no equilibrium was found beyond {fraction:.1%} of the path: the strip may be pulled tight between the "
        "places that hold it. Move it less far, or give a guess closer to the result",
        fraction=t,
    )
