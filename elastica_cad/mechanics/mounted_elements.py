"""Forces and equations of rails, pins, ties and guides of a discrete rod while the rod is bent.

The rest shape is a stationary point of

    E + sum over pins and rails <f, P - c(s)> + sum over ties <f, c(q) - c(p) - l e(psi)>

with respect to the edge angles, the forces f, the arc length s at each rail and the angle psi of each cord. E is
the energy of the rod, c(s) its position at arc length s, and f a force on the strip. A pin or rail
is at the point P. The force f of a guide has a fixed direction. A cord of length l connects the arc lengths p and
q, in the direction of the unit vector e(psi). If no end is held along an axis, the translation of the rod along
this axis is an additional unknown.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import angle_of, left_of, norm, unit, unit_vectors
from elastica_cad.mechanics.discrete_rod import edge_positions
from elastica_cad.mechanics.elements import (
    Element,
    ElementForce,
    Mount,
    Pin,
    PlacedElement,
    Rail,
    Tie,
    edge_weights,
    floats,
    nearest_arc_length,
)
from elastica_cad.mechanics.loads import Supports

if TYPE_CHECKING:
    from elastica_cad.mechanics.rod import Rod


@dataclass(frozen=True, eq=False)
class ElementEquations:
    """Residuals of rails, pins and ties, and derivatives of the residuals.

    The first two unknowns of each rail, pin or tie are the components of its force. The third unknown of a rail is
    the arc length of its contact point. The third unknown of a tie is the angle of its cord times the length of the
    cord. The only unknown of a guide is the force along its direction. The last unknowns are the translations of
    the rod along free axes.

    Each unknown has a residual. For a component of a force, the residual is the error of a position along x or y,
    or along the direction of a guide, mm. For any other unknown, the residual is a force, 1/mm2.

    Attributes
    ----------
    rows : (k, n) array
        Derivatives of the residuals by the angles of the edges.
    pulls : (k, n) array
        Derivatives of the axial force of each edge by the unknowns, times edge length / nominal length. The axial
        force is the component of lambda (the negative internal force) along the edge.
    corner : (k, k) array
        Derivatives of the residuals by the unknowns.
    residual : (k,) array
    places : (k,) bool array
        True for residuals that are position errors.
    """

    rows: FloatArray
    pulls: FloatArray
    corner: FloatArray
    residual: FloatArray
    places: FloatArray


@dataclass(frozen=True, eq=False)
class MountedElements:
    """Taut rails, pins and ties of a rod and their equations.

    Attributes
    ----------
    actions : tuple of ElementForce
        Rails, pins and ties with their `mount`. The forces and arc lengths are the initial values of the unknowns.
    supports : Supports
    anchor : (2,) array
        Coordinates x and y, mm, from which positions are computed. Each coordinate is that of the start, or of the
        end if the start does not hold this coordinate.
    load : (2,) array
        Sum of the known forces divided by the least bending stiffness, 1/mm2.
    edge_length : float
        Length of an edge, mm.
    """

    actions: tuple[ElementForce, ...]
    supports: Supports
    anchor: FloatArray
    load: FloatArray
    edge_length: float

    @cached_property
    def free_axes(self) -> IntArray:
        """Coordinates (0: x, 1: y) that no end holds, so that rails, pins and ties determine the position."""
        return np.flatnonzero(self.supports.free_axes if self.actions else ())

    def first(self, tangents: FloatArray) -> FloatArray:
        """Return the initial values (k,) of the unknowns for a rod with edge tangents (n, 2)."""
        numbers: list[float] = []
        for action in self.actions:
            numbers += (action.held_directions @ action.force[0]).tolist()
            if isinstance(action.element, Rail):
                numbers.append(float(action.s[0]))
            elif isinstance(action.element, Tie):
                chord = (self._weights(action, len(tangents)) * tangents).sum(axis=0)
                numbers.append(action.mounting.length * float(angle_of(chord)))
        return np.array([*numbers, *(0.0 for _ in self.free_axes)])

    def force(self, solved: Sequence[ElementForce], edges: int) -> FloatArray:
        """Return the part (n, 2) of the edge forces lambda, 1/mm2, that rails, pins and ties cause.

        lambda is the negative internal force. A force on the strip at s acts on all edges up to s, and a tie on
        the edges between its two points.
        """
        force = np.zeros((edges, 2))
        for action in solved:
            force += self._weights(action, edges) * action.force[0]
        return force

    def equations(
        self, tangents: FloatArray, numbers: FloatArray, solved: Sequence[ElementForce]
    ) -> ElementEquations:
        """Return the equations for the unknowns `numbers` (k,), from which `solved` was computed.

        `tangents` (n, 2) are the edge vectors divided by `edge_length`.
        """
        n, k, h = len(tangents), numbers.size, self.edge_length
        rows, pulls, corner = np.zeros((k, n)), np.zeros((k, n)), np.zeros((k, k))
        residual, places = np.zeros(k), np.zeros(k, dtype=bool)
        if not self.actions:
            return ElementEquations(rows, pulls, corner, residual, places)
        across = h * left_of(tangents).T
        free, floating = self.free_axes, floats(self.supports, self.actions)
        first_shift = k - len(free)
        origin = self.anchor + self.shift(numbers)
        for action, at in zip(solved, self.first_unknowns, strict=True):
            # unknowns `pair` are the components of the force, unknown `more` is the arc length or the cord's angle
            along, f = action.held_directions, action.force[0]
            more = at + len(along)
            pair, weights = slice(at, more), self._weights(action, n)
            places[pair] = True
            pulls[pair] = along @ (tangents * weights).T
            rows[pair] = along @ (across * weights.T)
            residual[pair] = h * pulls[pair].sum(axis=1)
            if isinstance(action.element, Tie):
                length = action.mounting.length
                e = unit_vectors(numbers[more] / length)
                turning = left_of(e)
                residual[pair] -= length * e
                if floating:
                    # keep the direction of the cord, because the rod could turn as a whole
                    corner[more, more] = 1.0
                else:
                    residual[more] = -f @ turning
                    corner[pair, more] = corner[more, pair] = -turning
                    corner[more, more] = f @ e / length
                continue
            residual[pair] += along @ (action.mounting.point - origin)
            for j, axis in enumerate(free):
                corner[pair, first_shift + j] = corner[first_shift + j, pair] = -along[:, axis]
                residual[first_shift + j] -= f[axis]
            if isinstance(action.element, Rail):
                crossing, curving = (edge_weights(float(action.s[0]), h, n, order) for order in (1, 2))
                slope = h * (crossing @ tangents)
                pulls[more] = -(tangents @ f) * crossing
                rows[more] = -(f @ across) * crossing
                residual[more] = -f @ slope
                corner[pair, more] = corner[more, pair] = -slope
                corner[more, more] = -h * f @ (curving @ tangents)
        # the equation of a translation: all forces along a free axis add up to 0
        residual[first_shift:] -= self.load[free]
        if floating:  # no support holds the position of the rod: keep it
            corner[first_shift:, first_shift:] = np.eye(len(free))
            residual[first_shift:] = 0.0
        return ElementEquations(rows, pulls, corner, residual, places)

    def solved(self, numbers: FloatArray) -> tuple[ElementForce, ...]:
        """Return rails, pins and ties with the forces and arc lengths of the unknowns `numbers` (k,)."""
        actions = []
        for action, at in zip(self.actions, self.first_unknowns, strict=True):
            along = action.held_directions
            f = numbers[at : at + len(along)] @ along
            force = np.array([f, -f] if isinstance(action.element, Tie) else [f])
            s = numbers[at + 2 : at + 3].copy() if isinstance(action.element, Rail) else action.s
            actions.append(replace(action, s=s, force=force))
        return tuple(actions)

    def shift(self, numbers: FloatArray) -> FloatArray:
        """Return the translation (2,), mm, of the whole rod, from the unknowns `numbers` (k,)."""
        shift = np.zeros(2)
        free = self.free_axes
        shift[free] = numbers[numbers.size - len(free) :]
        return shift

    @cached_property
    def first_unknowns(self) -> IntArray:
        """Index of the first unknown of each element. Guides have 1 unknown, pins 2, and rails and ties 3."""
        sizes = [
            len(action.held_directions) + isinstance(action.element, Rail | Tie) for action in self.actions
        ]
        return np.cumsum([0, *sizes])[:-1]

    @cached_property
    def from_end(self) -> FloatArray:
        """Flags (2,) for x and y: 1 if positions are measured from the end of the rod, 0 if from its start."""
        return np.where(self.supports.held[:2], 0.0, 1.0)

    def _weights(self, action: ElementForce, edges: int) -> FloatArray:
        """Return the weights of the edge vectors in the chord of a tie (n, 1), or in minus a position (n, 2)."""
        start, *ends = (edge_weights(float(s), self.edge_length, edges)[:, None] for s in action.s)
        return ends[0] - start if ends else self.from_end - start


MEETS_SHARE = 1e-9
"""A strip touches a rail, and a cord is taut, if the gap is at most this fraction of the length."""

PULLS_SHARE = 1e-9
"""Forces in the wrong direction up to this fraction of the largest force are rounding errors."""


@dataclass(frozen=True, eq=False)
class ShapeOfRod:
    """Shape of a discrete rod, from which positions at arc lengths are computed."""

    tangents: FloatArray
    edge_length: float
    start: FloatArray

    @property
    def length(self) -> float:
        """Length of the rod, mm."""
        return self.edge_length * len(self.tangents)

    @classmethod
    def of(cls, rod: "Rod") -> "ShapeOfRod":
        """Return the shape of a rod."""
        return cls(rod.discrete.tangents, rod.length / (rod.s.size - 1), rod.position[0])

    def at(self, s: float, order: int = 0) -> FloatArray:
        """Return the position (2,), mm, at arc length s, or its derivative by s of the given order."""
        weights = edge_weights(float(s), self.edge_length, len(self.tangents), order)
        return self.start * (order == 0) + self.edge_length * (weights @ self.tangents)

    def foot(self, point: FloatArray) -> float:
        """Return the arc length, mm, at which the rod is nearest to a point (2,)."""
        nodes = edge_positions(self.start, self.tangents, self.edge_length)
        return nearest_arc_length(
            point, self.edge_length * float(norm(nodes - point).argmin()), self.length,
            lambda s: tuple(self.at(s, order) for order in range(3)),
        )  # fmt: skip


def require_held(
    supports: Supports, elements: Sequence[PlacedElement | ElementForce], shape: ShapeOfRod, load: FloatArray
) -> None:
    """Refuse a rod that can move as a whole, because its supports, rails and pins do not hold it.

    A rod that floats needs no support if the `resultant` of its loads, `load` (3,), is 0.
    """
    # cords need no support if the loads balance each other, except for rounding errors
    if floats(supports, elements) and np.abs(load).max() <= 1e-6:
        return
    reactions = []
    for element in elements:
        s = float(element.s[0])
        if isinstance(element.element, Pin):
            # as for the ends, points of a bent rod are not on one line
            reactions += [(1.0, 0.0, -s / shape.length), (0.0, 1.0, s / shape.length)]
        elif isinstance(element.element, Rail):
            along = unit(shape.at(s, 1))
            reactions.append((*left_of(along), (shape.at(s) - shape.start) @ along / shape.length))
    width, height = np.abs(shape.at(shape.length) - shape.start)
    supports.require_held(reactions, upright=bool(height > width))


def mounted(rod: "Rod", between: tuple[Element, ...] | None) -> tuple[ElementForce, ...]:
    """Return the mounted rails, pins and ties of a rod: the present ones, or the new ones in `between`.

    A pin or rail at a point away from the strip moves the strip to this point. A new pin with the same index as a
    present pin holds the same point of the strip. A tie without `length` is as long as the distance between its two
    points.
    """
    if not (rod.between if between is None else between):
        return ()  # do not compute `rod.curve`, which does not exist if the curvature jumps
    curve = rod.curve
    shape = ShapeOfRod.of(rod) if rod.shape is None else curve
    if between is None:
        return tuple(_kept(action, curve, shape) for action in rod.between)
    actions = []
    for i, element in enumerate(between):
        same = next((action for action in rod.between if action.element == element), None)
        before = rod.between[i] if i < len(rod.between) else None
        actions.append(_new(element, before, curve, shape) if same is None else _kept(same, curve, shape))
    return tuple(actions)


def _positions(shape: "PlaneCurve | ShapeOfRod", s: FloatArray) -> FloatArray:
    if isinstance(shape, ShapeOfRod):
        return np.array([shape.at(float(place)) for place in s])
    return shape.at(s).position


def _kept(action: ElementForce, curve: PlaneCurve, shape: "PlaneCurve | ShapeOfRod") -> ElementForce:
    """Return a force with a mount of its element: by default, the mount at the present shape."""
    if action.mount is not None:
        return action
    places = _positions(shape, action.s)
    if isinstance(action.element, Tie):
        apart = float(norm(places[1] - places[0]))
        return replace(action, mount=Mount(length=action.element.length or apart))
    side = action.side_of_push(unit_vectors(curve.at(action.s).angle[0]))
    return replace(action, mount=Mount(_point(places[0]), side))


def _new(
    element: Element, before: ElementForce | None, curve: PlaneCurve, shape: "PlaneCurve | ShapeOfRod"
) -> ElementForce:
    """Return the initial force and the mount of an element that the rod does not have yet.

    `before` is the element that it replaces. An element of the same type passes on its force, and the side of a
    one-sided rail.
    """
    s = PlacedElement.on(element, curve, curve).s
    force = np.zeros((s.size, 2))
    if before is not None and type(before.element) is type(element):
        force = before.force  # a rail or tie that exerted a force is initially taut
    if isinstance(element, Tie):
        return _kept(ElementForce(element, s, force), curve, shape)
    if isinstance(element, Pin) and before is not None and isinstance(before.element, Pin):
        s = before.s
    assert isinstance(element, Rail | Pin)
    foot = _positions(shape, s)[0]
    point = np.array(element.at) if isinstance(element.at, tuple) else foot
    side, off = 0, float((point - foot) @ left_of(unit_vectors(curve.at(s).angle))[0])
    if isinstance(element, Rail) and element.one_sided:
        if before is not None and isinstance(before.element, Rail):
            side = _kept(before, curve, shape).mounting.side
        elif abs(off) > MEETS_SHARE * curve.length:
            side = int(np.sign(off))
    return ElementForce(element, s, force, Mount(_point(point), side))


def _point(place: FloatArray) -> tuple[float, float]:
    x, y = place.tolist()
    return x, y


def wrong_force(action: ElementForce, shape: ShapeOfRod) -> float:
    """Return the force, 1/mm2, with which a tie would have to push, or a one-sided rail to pull, or else 0."""
    if not action.is_one_sided:
        return 0.0
    if isinstance(action.element, Tie):
        p, q = (shape.at(s) for s in action.s)
        return max(0.0, -float(action.force[0] @ unit(q - p)))
    return max(0.0, -action.mounting.side * float(action.force[0] @ left_of(shape.at(action.s[0], 1))))


def with_side(action: ElementForce, shape: ShapeOfRod) -> ElementForce:
    """Set the direction in which a one-sided rail pushes. Other rails, pins and ties are returned unchanged."""
    mount = action.mounting
    side = mount.side or action.side_of_push(shape.at(action.s[0], 1))
    return action if side == mount.side else replace(action, mount=replace(mount, side=side))


def violation(action: ElementForce, shape: ShapeOfRod) -> float:
    """Return how far, mm, a strip is beyond a rail, or by how much a cord is too short; negative for a gap."""
    if isinstance(action.element, Tie):
        p, q = (shape.at(s) for s in action.s)
        return float(norm(q - p)) - action.mounting.length
    point = np.array(action.mounting.point)
    s = shape.foot(point)
    if not 0 < s < shape.length:
        return 0.0
    return action.mounting.side * float((point - shape.at(s)) @ left_of(shape.at(s, 1)))


def touching(action: ElementForce, shape: ShapeOfRod) -> ElementForce:
    """Return the rail, pin or tie with force 0. The arc length of a rail is that of the nearest strip point."""
    s = action.s
    if isinstance(action.element, Rail):
        s = np.array([shape.foot(np.array(action.mounting.point))])
    return replace(action, s=s, force=np.zeros_like(action.force))
