"""Rails, pins, ties and point forces, which support or load a strip between its ends.

At a point p_j = gamma(s_j) of the strip gamma(s), a force f_j changes the slope of the bending moment:

    M(s) = a + <b, gamma(s)> - sum over s_j < s of det(f_j, gamma(s) - p_j),    where a and b are constants.

The manual's page "Forces between the ends" has the derivation.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import pair, require_flag, require_positive, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import FieldName, InputError, Length, Point, Refusal, note
from elastica_cad.geometry.plane_curve import ROUNDED_END_SHARE, PlaneCurve
from elastica_cad.geometry.plane_points import angle_of, cross, left_of, norm, unit_vectors
from elastica_cad.mechanics.loads import Gravity, Place, PointMass, Supports, Weight, require_place

_AT = Option("Place along the curve, or a point (x, y) near it.", "mm")
_HOLE = Option("Diameter of the hole in the strip for a cord or screw; 0 for none.", "mm", least=0)
_NOTCH = Option("Width of a notch in each edge of the strip, for two cords; 0 for none.", "mm", least=0)


class Element:
    """Support of a strip between its ends: rail, pin or tie."""


@dataclass(frozen=True)
class Rail(Element):
    """Rail across the strip that pushes normal to the strip; the strip slides over the rail.

    The equilibrium determines the direction of the push. Mount a bar on the side from which it pushes.

    Parameters
    ----------
    at : float or (float, float)
        Arc length along the drawn curve, mm, or a point (x, y), mm, which is moved to the nearest curve point.
    one_sided : bool
        True for a single bar, from which the strip may lift off. False for a slot, or for a bar on each side.

    Examples
    --------
    >>> Rail(120.0), Rail((60, 25), one_sided=False)
    (Rail(at=120.0, one_sided=True), Rail(at=(60.0, 25.0), one_sided=False))
    """

    at: Annotated[Place, _AT]
    one_sided: Annotated[
        bool, Option("A single bar, from which the strip may lift off, instead of a slot.")
    ] = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "at", require_place(self.at, "a rail"))
        require_flag(self.one_sided, "one_sided of a rail")


@dataclass(frozen=True)
class Pin(Element):
    """Pin that fixes a point of the strip and lets the strip turn: a ring around it, or a hinge screwed to it.

    Parameters
    ----------
    at : float or (float, float)
        Arc length along the drawn curve, mm, or a point (x, y), mm, which is moved to the nearest curve point.
    hole, notch : float
        Diameter of a hole on the centre line, or width and depth of a notch in each edge, mm; 0 for none. The
        strip is widened at the cut, so that it bends like a strip without a cut.

    Examples
    --------
    >>> Pin(180, hole=4).at
    180.0
    """

    at: Annotated[Place, _AT]
    hole: Annotated[float, _HOLE] = 0.0
    notch: Annotated[float, _NOTCH] = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "at", require_place(self.at, "a pin"))
        _require_cut(self)


@dataclass(frozen=True)
class Tie(Element):
    """Taut cord between two points of the strip, which it pulls towards each other.

    Parameters
    ----------
    start, end : float or (float, float)
        Arc lengths along the drawn curve, mm, or points (x, y), mm, which are moved to the nearest curve points.
    length : float, optional
        Length of the cord for `bend`, mm; by default, the distance between its two points.
    hole, notch : float
        Diameter of a hole on the centre line, or width and depth of a notch in each edge for two cords, mm; 0 for
        none. The strip is widened at the cut, so that it bends like a strip without a cut.

    Examples
    --------
    >>> Tie(40, 310, hole=3).end
    310.0
    """

    start: Annotated[Place, _AT]
    end: Annotated[Place, _AT]
    length: float | None = None
    hole: Annotated[float, _HOLE] = 0.0
    notch: Annotated[float, _NOTCH] = 0.0

    def __post_init__(self) -> None:
        for name in ("start", "end"):
            object.__setattr__(self, name, require_place(getattr(self, name), f"the {name} of a tie"))
        if self.length is not None:
            require_positive(self.length, "the length of a tie")
        _require_cut(self)


@dataclass(frozen=True)
class Guide(Element):
    """Guide that holds a point of the strip along one direction. The point slides across it, and the strip turns.

    A guide is not part of a design. `push_path` moves a point of a rod with it.

    Parameters
    ----------
    direction : (float, float)
        Unit vector of the direction along which the point cannot move.
    """

    direction: tuple[float, float]


@dataclass(frozen=True)
class PointForce:
    """Known force on the strip.

    Parameters
    ----------
    at : float or (float, float)
        Arc length along the drawn curve, mm, or a point (x, y), mm, which is moved to the nearest curve point.
    force : (float, float)
        Components of the force in the plane of the curve, N.

    Examples
    --------
    >>> PointForce(150, (0, -2.5))
    PointForce(at=150.0, force=(0.0, -2.5))
    """

    at: Annotated[Place, _AT]
    force: Annotated[tuple[float, float], Option("Force in the plane of the curve.", "N")]

    def __post_init__(self) -> None:
        object.__setattr__(self, "at", require_place(self.at, "a point force"))
        object.__setattr__(self, "force", tuple(pair(self.force, "the force of a point force").tolist()))

    @property
    def newtons(self) -> float:
        """Magnitude of the force, N."""
        return float(norm(np.array(self.force)))


def _require_cut(element: "Pin | Tie") -> None:
    require_declared(type(element), vars(element), NOUNS[type(element)])
    if element.hole and element.notch:
        raise InputError(
            "A {element} can have a hole or notches, but not both. Leave out {hole} or {notch}.",
            element=noun_of(element), hole=FieldName("hole"), notch=FieldName("notch"),
        )  # fmt: skip


NOUNS = {Rail: "rail", Pin: "pin", Tie: "tie", PointForce: "point force", PointMass: "point mass"}


def noun_of(element: Element | PointForce | PointMass) -> Refusal:
    """Return the noun that names a rail, pin, tie or load in messages."""
    return note(NOUNS[type(element)])


def require_elements(between: object) -> tuple[Element, ...]:
    """Return rails, pins and ties as a tuple. Refuse objects of other classes."""
    return several("between", between, Rail | Pin | Tie, "Rail, Pin or Tie")


def weight_with_loads(
    weight: Weight | None, gravity: Gravity | None, loads: object
) -> tuple[Weight | None, tuple[PointForce, ...]]:
    """Add the point masses of `loads` to the weight; return the new weight and the point forces of `loads`."""
    point_loads = several("loads", loads, PointMass | PointForce, "PointMass or PointForce")
    masses = tuple(load for load in point_loads if isinstance(load, PointMass))
    forces = tuple(load for load in point_loads if isinstance(load, PointForce))
    if masses and gravity is None:
        raise InputError(
            "loads contain a PointMass, but there is no {field} for its direction. Pass {field}, or a PointForce.",
            field=FieldName("gravity"),
        )
    if weight is None and gravity is not None and point_loads:
        weight = Weight(own=True)
    return (
        replace(weight, masses=(*weight.masses, *masses)) if weight is not None and masses else weight
    ), forces


NEAR_SHARE = 0.05
"""Largest distance, as a fraction of the length, by which a point is moved to the curve."""

AT_END_SHARE = 1e-6
"""Positions closer to an end than this fraction of the length count as at the end."""

AT_JOINT_SHARE = 2e-3
"""Largest distance, as a fraction of the length, by which a position is moved to the start of a straight free end.

The tolerance allows for positions that are rounded to a millimetre.
"""

_NEWTON_STEPS = 30


@dataclass(frozen=True, eq=False)
class PlacedElement:
    """Rail, pin, tie or load with its position on a curve.

    Attributes
    ----------
    element : Rail, Pin, Tie or PointForce
    s : (k,) array
        Arc lengths of the points at which the element acts, mm.
    units : (u, k, 2) array
        Forces on the strip at the k points if one of the u unknowns is 1 and the others are 0. The unknowns are
        the push of a rail, the x and y components of the force of a pin, or the pull of a tie. For a
        `PointForce`: the known force, N.
    """

    element: Element | PointForce
    s: FloatArray
    units: FloatArray

    @classmethod
    def on(
        cls, element: Element | PointForce, drawn: PlaneCurve, curve: PlaneCurve, joints: Sequence[float] = ()
    ) -> "PlacedElement":
        """Convert the position of `element` from the `drawn` curve to the realizable `curve`.

        Rails and pins are moved to the nearest point of `curve`. Ties and loads keep their arc length as a
        fraction of the whole length. If the position is near the start of a straight free end (`joints`, mm), it is
        moved there.
        """
        assert isinstance(element, Rail | Pin | Tie | PointForce)
        places = (element.start, element.end) if isinstance(element, Tie) else (element.at,)
        s = np.array([_station(at, drawn, element) for at in places])
        if isinstance(element, Tie | PointForce):
            s *= curve.length / drawn.length
        elif curve is not drawn:
            s = np.array([_foot(curve, drawn.at(s).position[0])])
        for joint in joints:
            s = np.where(np.abs(s - joint) <= AT_JOINT_SHARE * curve.length, joint, s)
        if isinstance(element, PointForce):
            return cls(element, s, np.array([[element.force]]))
        if isinstance(element, Pin):
            return cls(element, s, np.eye(2)[:, None, :])
        if isinstance(element, Rail):
            return cls(element, s, left_of(unit_vectors(curve.at(s).angle))[None])
        ends = curve.at(s).position
        chord = ends[1] - ends[0]
        size = float(norm(chord))
        if size <= AT_END_SHARE * curve.length:
            raise InputError(
                "The tie from {start} to {end} along the strip has no length. Move one of its ends.",
                start=Length(s[0]), end=Length(s[1]),
            )  # fmt: skip
        return cls(element, s, np.array([[chord, -chord]]) / size)

    @property
    def unknowns(self) -> int:
        """Number of unknowns of the force: 2 for a pin, 1 for a rail or tie, 0 for a known force."""
        return 0 if isinstance(self.element, PointForce) else len(self.units)


def place_elements(
    elements: Iterable[Element | PointForce],
    drawn: PlaneCurve,
    curve: PlaneCurve,
    supports: Supports,
    joints: Sequence[float],
) -> tuple[PlacedElement, ...]:
    """Return rails, pins, ties and loads on the realizable curve. Refuse those at points that the ends hold."""
    placed = tuple(PlacedElement.on(element, drawn, curve, joints) for element in elements)
    near = AT_END_SHARE * curve.length
    held = [s for s, end in zip((0.0, curve.length), supports.ends, strict=True) if end.x and end.y]
    for placed_element in placed:
        if isinstance(placed_element.element, Tie) and placed_element.element.length is not None:
            raise InputError(
                "The tie from {start} to {end} has a length, but in a design its length follows from the "
                "curve. Leave out the length, or pass the length to `bend`.",
                start=Length(placed_element.s[0]), end=Length(placed_element.s[1]),
            )  # fmt: skip
        fixed = [min((abs(s - end) for end in held), default=np.inf) <= near for s in placed_element.s]
        if all(fixed):
            raise InputError(
                "The {element} {places} from the start acts on an end that is held in place, so it has no "
                "effect. Move the {element} between the ends.",
                element=noun_of(placed_element.element), places=Length(placed_element.s[0]),
            )  # fmt: skip
    return placed


def with_placed_masses(weight: Weight, drawn: PlaneCurve, curve: PlaneCurve) -> Weight:
    """Return the weight with the positions of its masses converted to arc lengths along the curve.

    A mass at a point is moved to the nearest point of the `drawn` curve.
    """
    masses = tuple(
        replace(mass, at=_station(mass.at, drawn if isinstance(mass.at, tuple) else curve, mass))
        for mass in weight.masses
    )
    return replace(weight, masses=masses)


def _station(at: Place, curve: PlaneCurve, element: Element | PointForce | PointMass) -> float:
    """Return the arc length, mm, of a place: points move to the curve, and rounded lengths to the end."""
    if isinstance(at, tuple):
        s = _foot(curve, np.array(at))
        off = float(norm(curve.at(s).position[0] - at))
        if off > NEAR_SHARE * curve.length:
            raise InputError(
                "The {element} at {point} is {off:.4g} off the curve, farther than {most:.4g} ({percent:g} % of "
                "its length). Give a point nearer to the curve, or the arc length in mm.",
                element=noun_of(element), point=Point(at), off=Length(off),
                most=Length(NEAR_SHARE * curve.length), percent=100 * NEAR_SHARE,
            )  # fmt: skip
        return s
    rounding = ROUNDED_END_SHARE * curve.length
    if not -rounding <= at <= curve.length + rounding:
        raise InputError(
            "The {element} {at:.6g} from the start is not on the curve. Give a place from 0 to "
            "{length:.6g} along the curve.",
            element=noun_of(element), at=Length(at), length=Length(curve.length),
        )  # fmt: skip
    if at <= rounding:
        return 0.0
    return at if at < curve.length - rounding else curve.length


def _foot(curve: PlaneCurve, point: FloatArray) -> float:
    """Return the arc length, mm, of the point of the curve nearest to `point`."""

    def at(s: float) -> tuple[FloatArray, ...]:
        here = curve.at(s)
        tangent = unit_vectors(here.angle[0])
        return here.position[0], tangent, here.curvature[0] * left_of(tangent)

    nodes = curve.survey
    return nearest_arc_length(point, float(nodes.s[norm(nodes.position - point).argmin()]), curve.length, at)


def nearest_arc_length(
    point: FloatArray, start: float, length: float, at: Callable[[float], tuple[FloatArray, ...]]
) -> float:
    """Return the arc length, mm, at which a curve of `length` mm is nearest to a point (2,).

    The method is Newton's, from the arc length `start`. `at` returns the position (2,) at an arc length, and its
    first and second derivative by the arc length.
    """
    s = start
    for _ in range(_NEWTON_STEPS):
        position, slope, bend = at(s)
        off = point - position
        # limit the step, because Newton's method diverges near the centre of curvature
        spread = max(float(slope @ slope - off @ bend), 0.3)
        before, s = s, float((s + off @ slope / spread).clip(0.0, length))
        if abs(s - before) <= 1e-13 * length:
            break
    return s


@dataclass(frozen=True)
class Mount:
    """Properties of a mounted rail, pin or tie that do not change while the strip is bent.

    Attributes
    ----------
    point : (float, float)
        Point at which a rail or pin holds the strip, or a point on the line of a guide, mm; not used for ties.
    side : int
        Direction in which a rail pushes the strip: 1 left, -1 right, 0 both or unknown.
    length : float
        Length of the cord of a tie, mm; not used for rails and pins.
    """

    point: tuple[float, float] = (0.0, 0.0)
    side: int = 0
    length: float = 0.0


@dataclass(frozen=True, eq=False)
class ElementForce:
    """Rail, pin, tie or load with its force on a rod.

    Attributes
    ----------
    element : Rail, Pin, Tie, Guide or PointForce
    s : (k,) array
        Arc lengths of the points at which the element acts, mm.
    force : (k, 2) array
        Forces on the strip at these points, 1/mm2. Multiply by the least bending stiffness of the rod (N mm2) to
        obtain N.
    mount : Mount or None
        Data set by `bend`; None if the element is taut and the rod has not been bent since its design.
    """

    element: Element | PointForce
    s: FloatArray
    force: FloatArray
    mount: Mount | None = None

    @property
    def mounting(self) -> Mount:
        """Value of `mount`, or an empty `Mount` instead of None."""
        return self.mount or Mount()

    @property
    def held_directions(self) -> FloatArray:
        """Unit vectors (1, 2) of the direction along which a guide holds the strip, else (2, 2) of both axes."""
        return np.array([self.element.direction]) if isinstance(self.element, Guide) else np.eye(2)

    @property
    def is_one_sided(self) -> bool:
        """True for a tie, and for a rail from which the strip may lift off."""
        element = self.element
        return isinstance(element, Tie) or (isinstance(element, Rail) and element.one_sided)

    def bar_direction(self, curve: PlaneCurve) -> FloatArray | None:
        """Return the unit vector (2,) from a strip on a curve to the bar of a one-sided rail.

        Return None for another element, or if the side of the rail is unknown.
        """
        tangent = unit_vectors(curve.at(self.s).angle[0])
        side = self.mounting.side or self.side_of_push(tangent)
        return -side * left_of(tangent) if side else None

    def side_of_push(self, tangent: FloatArray) -> int:
        """Return the direction in which a one-sided rail pushes: 1 left, -1 right; 0 for another element."""
        if isinstance(self.element, Rail) and self.element.one_sided:
            return int(np.sign(self.force[0] @ left_of(pair(tangent, "the tangent"))))
        return 0

    @property
    def on_curve(self) -> Any:
        """Rail, pin, tie or load with its positions as arc lengths along the rod."""
        names = ("start", "end") if isinstance(self.element, Tie) else ("at",)
        element: Any = self.element
        return replace(element, **dict(zip(names, self.s.tolist(), strict=True)))

    @property
    def size(self) -> float:
        """Magnitude of the force over the least bending stiffness, 1/mm2; for a tie, its pull."""
        return float(norm(self.force[0]))

    def points_on(self, nodes: FloatArray, length: float) -> FloatArray:
        """Return the points (k, 2), mm, at which the force acts on a bent rod of nodes (n, 2) and length, mm."""
        edges = np.diff(nodes, axis=0)
        weights = [edge_weights(float(s), length / len(edges), len(edges)) for s in self.s]
        return np.asarray(nodes[0] + np.array(weights) @ edges)

    def distance_on(self, curve: PlaneCurve) -> float:
        """Return the straight distance, mm, between the first and the last point of application on a curve."""
        ends = curve.at(self.s).position
        return float(norm(ends[-1] - ends[0]))


def side_of_bar(direction: FloatArray) -> Refusal:
    """Return the side of the strip, in words, in the direction (2,) of `ElementForce.bar_direction`."""
    quarter = round(float(angle_of(direction)) / (np.pi / 2)) % 4
    sides = "on the right of the strip", "above the strip", "on the left of the strip", "below the strip"
    return note(sides[quarter])


def forces_of(placed: Sequence[PlacedElement], numbers: FloatArray) -> tuple[ElementForce, ...]:
    """Return rails, pins and ties with their forces, from the solved values `numbers` (u,) of the unknowns."""
    ends = np.cumsum([placed_element.unknowns for placed_element in placed], dtype=int)
    return tuple(
        ElementForce(
            placed_element.element,
            placed_element.s,
            np.einsum("u,ukc->kc", numbers[end - placed_element.unknowns : end], placed_element.units),
        )
        for placed_element, end in zip(placed, ends, strict=True)
    )


def floats(supports: Supports, elements: Sequence["PlacedElement | ElementForce"]) -> bool:
    """Return True if only cords act on a rod with free ends, as in a bow; they do not hold it in place."""
    only_cords = bool(elements) and all(isinstance(element.element, Tie) for element in elements)
    return supports.is_free and only_cords


def resultant(
    points: FloatArray, forces: FloatArray, length: float, *, moment: float = 0.0, other: float = 0.0
) -> FloatArray:
    """Return the force in x and y, and the moment about the start over the length, of forces on a rod.

    The result is a fraction of the sum of the sizes of all forces and of `other`.

    Parameters
    ----------
    points, forces : (n, 2) array
        Points relative to the start, mm, and forces.
    """
    total = forces.sum(axis=0)
    turning = (float(cross(points, forces).sum()) + moment) / length
    size = float(norm(forces).sum()) + abs(moment) / length + other
    return np.array([*total, turning]) / (size or 1.0)


@lru_cache(maxsize=32)
def edge_weights(s: float, edge_length: float, edges: int, order: int = 0) -> FloatArray:
    """Return the weights (n,) with which the edge vectors add up to the position at arc length s.

    With `order` 1 or 2, return the derivatives of the weights by s. The position is on the quadratic B-spline of
    the nodes, along which a rail slides smoothly from edge to edge. This spline touches each edge at its midpoint,
    and is straight in the outer halves of the first and the last edge. Calls with equal arguments share the array.
    """
    x = s / edge_length
    if 0.5 < x < edges - 0.5:
        z = (x + 0.5 - np.arange(edges)).clip(0.0, 2.0)
        if order == 0:
            return np.asarray(np.where(z < 1, z**2, 2 - (2 - z) ** 2) / 2)
        if order == 1:
            return np.asarray(np.minimum(z, 2 - z) / edge_length)
        return np.asarray((np.sign(z) - 2 * (z >= 1) + (z >= 2)) / edge_length**2)
    weights = np.zeros(edges)
    last = min(max(int(x), 0), edges - 1)
    if order == 0:
        weights[:last] = 1.0
    if order < 2:
        weights[last] = (x - last, 1 / edge_length)[order]
    return weights


def lumped(forces: Iterable[ElementForce], nodes: int, length: float) -> FloatArray:
    """Distribute the forces to the neighbouring nodes of a rod; return nodal forces (n, 2), 1/mm2."""
    load = np.zeros((nodes, 2))
    for action in forces:
        for s, force in zip(action.s, action.force, strict=True):
            before = edge_weights(float(s), length / (nodes - 1), nodes - 1)
            load += -np.diff(before, prepend=1.0, append=0.0)[:, None] * force
    return load


def at_ends(length: float, forces: Iterable[ElementForce]) -> FloatArray:
    """Return the sums (2, 2) of the forces that act exactly at the start and at the end of a rod, 1/mm2."""
    total = np.zeros((2, 2))
    for action in forces:
        for s, force in zip(action.s, action.force, strict=True):
            total += np.outer(np.abs(s - np.array([0.0, length])) <= AT_END_SHARE * length, force)
    return total


def require_free_between(rod: Any, task: str) -> None:
    """Refuse a rod with rails, pins, ties or point forces, which `task` does not take into account."""
    if rod.acting:
        raise InputError(
            "{task} does not take rails, pins, ties or point forces into account yet. Use a rod without them.",
            task=task,
        )
