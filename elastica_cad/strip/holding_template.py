"""Positions of the two held ends of a strip, as numbers and as a full-size drawing for mounting the strip."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import Degrees, Force, Length, Listed, Mass, Refusal, note
from elastica_cad.geometry.path import Path, Spline
from elastica_cad.geometry.plane_points import angle_of, cross, left_of, norm, points_at, unit_vectors
from elastica_cad.mechanics.elements import (
    NOUNS,
    ElementForce,
    Pin,
    PointForce,
    Rail,
    Tie,
    noun_of,
    side_of_bar,
)
from elastica_cad.mechanics.loads import End, PointMass
from elastica_cad.strip.drawing import ENGRAVE, MARK, Drawing, LayeredPath
from elastica_cad.strip.lettering import Text, engravable
from elastica_cad.strip.outline import Hole
from elastica_cad.strip.strip import Strip

LETTERS_MM = 4.0
"""Height of the letters on the template, mm."""

CROSS_MM = 8.0
"""Length of the short lines that mark ends, hole axes, rails, pins and ties, mm."""

ARROW_MM, HEAD_MM = 20.0, 3.0
"""Length of the arrow of a load and size of the arrowhead, mm."""

MARKS = (0.25, 0.5, 0.75)
"""Positions along the strip, as fractions of its length, at which its heights above the chord are measured."""

DRAWN_AXES = "the x axis of the drawing", "the y axis of the drawing"
"""Names of the axes along which an end may slide, for the template."""

ELEMENT_LETTERS = {Rail: "R", Pin: "P", Tie: "T", PointForce: "F", PointMass: "M"}


@dataclass(frozen=True, eq=False)
class HeldEnd:
    """A held end of the bent part of a strip.

    Attributes
    ----------
    position : (2,) array
        Point at which the strip begins to bend, mm, in the plane of the curve.
    angle : float
        Direction of the strip at this point, from start to end, degrees from the x axis.
    tilt : float
        Direction of the strip relative to the line between both ends, degrees.
    support : End
        Support of the end.
    tab, thickness : float
        Length and thickness of the tab, mm.
    holes : tuple of Hole
        Holes in the tab.
    outward : (2,) array
        Unit vector along the tab.
    """

    position: FloatArray
    angle: float
    tilt: float
    support: End
    tab: float
    thickness: float
    holes: tuple[Hole, ...]
    outward: FloatArray

    @property
    def tip(self) -> FloatArray:
        """End point of the tab (2,), mm."""
        return self.position + self.tab * self.outward

    def turned_about(self, x: float, y: float) -> "HeldEnd":
        """Return the end turned by 180 degrees about a point, mm."""
        return replace(
            self,
            position=2 * np.array([x, y]) - self.position,
            angle=_principal_angle(self.angle + 180),
            outward=-self.outward,
        )


def freedom_text(support: End, x: str = "x", y: str = "y") -> str:
    """Return how an end may move, or "" if its place and its angle are held. `x` and `y` name the axes."""
    axes = [name for name, held in ((x, support.x), (y, support.y)) if not held]
    if support.is_free:
        return note("free: nothing holds it")
    if axes:
        text = "free to slide along {axes}" if support.angle else "free to slide along {axes} and to turn"
        return note(text, axes=Listed(axes))
    return "" if support.angle else note("free to turn")


def angle_text(degrees: float) -> Refusal:
    """Return the direction of a strip relative to the line between its ends, seen from start to end.

    `degrees` is positive to the left, as in `HeldEnd.tilt`.
    """
    if round(degrees, 1) == 0:
        return note("straight ahead")
    text = "{angle:.1f} to the left" if degrees > 0 else "{angle:.1f} to the right"
    return note(text, angle=Degrees(abs(degrees)))


def held_ends(strip: Strip) -> tuple[HeldEnd, HeldEnd]:
    """Return the positions and directions of both ends of an open strip, in the plane of its curve.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 100, np.pi, 0), "card-200gsm", max_width=20)
    >>> first, last = held_ends(arch)
    >>> first.position.round(6).tolist(), round(first.angle, 6), round(last.tilt, 6)
    ([-100.0, 0.0], 90.0, -90.0)
    """
    rod = strip.rod
    line = np.degrees(angle_of(rod.chord))
    first, last = (
        HeldEnd(
            np.array(rod.position[k]),
            _principal_angle(np.degrees(rod.angle[k])),
            _principal_angle(np.degrees(rod.angle[k]) - line),
            support,
            tab.length,
            thickness,
            tab.holes,
            direction * unit_vectors(rod.angle[k]),
        )
        for k, direction, support, tab, thickness in zip(
            (0, -1), (-1, 1), rod.supports.ends, strip.ends, strip.end_thicknesses, strict=True
        )
    )
    return first, last


def _principal_angle(degrees: float) -> float:
    return 180.0 - (180.0 - round(float(degrees), 6)) % 360.0


def heights_of_marks(position: FloatArray, s: FloatArray | None = None) -> FloatArray:
    """Return the distances of the marks from the chord, mm, positive to the left of the chord.

    Without arc lengths `s` (n,), the points (n, 2) are taken as evenly spaced.
    """
    chord = position[-1] - position[0]
    stations = np.linspace(0.0, 1.0, len(position)) if s is None else s / s[-1]
    marks = points_at(np.array(MARKS), stations, position - position[0])
    return cross(chord, marks) / norm(chord)


def upward(heights: FloatArray) -> float:
    """Return the sign, 1.0 or -1.0, of heights on the side of the chord that is drawn above it.

    An arch is drawn with its hump above the chord. An S-shaped strip is drawn with its start at the left, so that
    the left side of its chord is above.
    """
    low, high = heights.min(), heights.max()
    # in a strip that is not S-shaped, rounding errors give smaller ratios of opposite heights
    return -1.0 if low < 0 and high < -0.01 * low else 1.0


def distance_between(ends: Sequence[HeldEnd]) -> float:
    """Return the distance between the two ends, mm."""
    return float(norm(ends[1].position - ends[0].position))


def distance_of_tips(ends: Sequence[HeldEnd]) -> float:
    """Return the distance between the end points of both tabs, mm."""
    return float(norm(ends[1].tip - ends[0].tip))


def hole_places(ends: Sequence[HeldEnd]) -> tuple[FloatArray, FloatArray]:
    """Return the centres (n, 2), mm, of the holes in each tab. The x axis is the line between the ends.

    Examples
    --------
    >>> from elastica_cad.strip.outline import Hole, Tab
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> tabs = Tab(20, holes=(Hole(10, 3),)), Tab(20)
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 100, np.pi, 0), "card-200gsm", max_width=20, ends=tabs)
    >>> [places.round(6).tolist() for places in hole_places(held_ends(arch))]
    [[[0.0, -10.0]], []]
    """
    first, last = (end.position for end in ends)
    along = (last - first) / (norm(last - first) or 1.0)
    axes = np.column_stack([along, left_of(along)])
    start, end = (
        np.reshape([tab.position + hole.at * tab.outward - first for hole in tab.holes], (-1, 2)) @ axes
        for tab in ends
    )
    return start, end


@dataclass(frozen=True, eq=False)
class HeldElement:
    """Rail, pin, tie or load of a strip, with the dimensions for mounting it.

    Attributes
    ----------
    name : str
        Letter for the kind (rail, pin, tie, force or mass) and a count, such as R1, P1, T1, F1 or M1.
    action : ElementForce
    position : (k, 2) array
        Points of application on the strip, mm, in the plane of the curve.
    outward : (k, 2) array
        Unit normals of the strip at these points. For a rail they point to the side of the rail, for a pin or
        tie to the left of the strip. For a load, this is the direction of its force.
    places : (k, 2) array
        Coordinates of these points from the start of the strip, mm: along the line from start to end, and to
        the left of this line.
    tilt : float
        Direction of the strip at the first point, or of a load, relative to the line from start to end, degrees.
    force : float
        Force on the strip, N.
    contact : (2,) array, optional
        Point at which a one-sided rail touches the strip, mm, in the plane of the curve.
    face : (2,) array, optional
        This point in the coordinates of `places`, mm.
    """

    name: str
    action: ElementForce
    position: FloatArray
    outward: FloatArray
    places: FloatArray
    tilt: float
    force: float
    contact: FloatArray | None = None
    face: FloatArray | None = None

    def __str__(self) -> str:
        force = f"{Force(self.force):.2g}"
        at = " to ".join(f"x {x:z.1f}, y {y:z.1f}" for x, y in self.places)
        if isinstance(self.action.element, Tie):
            length = norm(self.places[1] - self.places[0])
            return f"{self.name} {NOUNS[Tie]}: {at}, {length:.1f} mm long, {force}"
        if self.face is not None:
            x, y = self.face
            at = f"touches the strip at x {x:z.1f}, y {y:z.1f}, bar {side_of_bar(self.outward[0])}"
        elif self.is_between_bars:
            at += ", middle between two bars"
        strip = "" if self.is_load else "strip "
        x, y = self.action.force[0]
        push = f"{force} {direction_in_drawing(np.degrees(np.arctan2(y, x)))}" if self.force else force
        return f"{self.name} {self.noun}: {at}, {strip}{angle_text(self.tilt)}, {push}"

    @property
    def noun(self) -> str:
        """Noun such as "rail", or the noun and the mass, g, of a point mass."""
        element: Any = self.action.element
        noun = noun_of(element)
        if not isinstance(element, PointMass):
            return noun
        return note("{noun} {mass:g}", noun=noun, mass=Mass(element.mass))

    @property
    def is_between_bars(self) -> bool:
        """True for a rail that holds the strip from both sides."""
        return isinstance(self.action.element, Rail) and not self.action.element.one_sided

    @property
    def is_load(self) -> bool:
        """True for a given force or mass, which is drawn as an arrow."""
        return isinstance(self.action.element, PointForce | PointMass)


def held_elements(strip: Strip) -> tuple[HeldElement, ...]:
    """Return the rails, pins, ties and loads of a strip with the dimensions for mounting them."""
    rod, counts, held = strip.rod, Counter[str](), []
    actions = [*rod.acting, *strip.rod.hung]
    if not actions:
        return ()
    chord = rod.chord / (norm(rod.chord) or 1.0)
    axes = np.column_stack([chord, left_of(chord)])
    for action in actions:
        letter = ELEMENT_LETTERS[type(action.element)]
        counts[letter] += 1
        at = rod.curve.at(action.s)
        normal = left_of(unit_vectors(at.angle))
        direction = at.angle[0]
        if isinstance(action.element, PointForce | PointMass):
            direction = angle_of(action.force[0])
            normal = action.force / (action.size or 1.0)
        elif isinstance(action.element, Rail) and action.force[0] @ normal[0] > 0:
            normal = -normal  # a rail is on the side from which it pushes
        contact = face = None
        if (bar := action.bar_direction(rod.curve)) is not None:
            normal = bar[None]
            contact = at.position[0] + strip.sheet.thickness / 2 * bar
            face = (contact - rod.position[0]) @ axes
        held.append(
            HeldElement(
                f"{letter}{counts[letter]}", action, at.position, normal,
                (at.position - rod.position[0]) @ axes,
                _principal_angle(np.degrees(direction - angle_of(chord))),
                strip.bending_stiffness * action.size,
                contact, face,
            )
        )  # fmt: skip
    return tuple(held)


def direction_in_drawing(angle: float) -> Refusal:
    """Return the direction, such as "upward", nearest to an angle in degrees from the x axis."""
    return note(("to the right", "upward", "to the left", "downward")[round(angle / 90) % 4])


def _element_lines(held: HeldElement, half: float) -> Iterator[list[FloatArray]]:
    """Yield the drawn lines of an element: a cord, the arrow of a load, the faces of bars, or a cross.

    `half` is half the thickness of the strip, mm.
    """
    if isinstance(held.action.element, Tie):
        yield [*held.position]
        return
    point, normal = held.position[0], held.outward[0]
    along = left_of(normal)
    if held.is_load:
        tip = point + ARROW_MM * normal
        yield [point, tip]
        yield [tip - HEAD_MM * (normal + along / 2), tip, tip - HEAD_MM * (normal - along / 2)]
        return
    if isinstance(held.action.element, Rail):
        for side in (1.0,) if held.action.element.one_sided else (1.0, -1.0):
            face = point + side * half * normal
            yield [face - CROSS_MM / 2 * along, face + CROSS_MM / 2 * along]
            yield [face, face + side * CROSS_MM * normal]
        return
    yield [point - CROSS_MM / 2 * along, point + CROSS_MM / 2 * along]
    yield [point - CROSS_MM / 2 * normal, point + CROSS_MM / 2 * normal]


def ends_message(strip: Strip) -> Refusal:
    """Return a sentence with the positions and directions in which to hold the ends."""
    ends = held_ends(strip)
    far: dict[str, Any] = {"apart": Length(distance_between(ends)), "tips": Length(distance_of_tips(ends))}
    if all(end.support.angle for end in ends):
        return note(
            "hold the ends {apart:.1f} apart where the bend begins ({tips:.1f} from tip to tip); seen from start "
            "to end, the strip points {start} at the start, {end} at the end",
            start=angle_text(ends[0].tilt),
            end=angle_text(ends[1].tilt),
            **far,
        )
    if strip.rod.supports.is_free:
        return note(
            "nothing holds the free ends; they rest {apart:.1f} apart ({tips:.1f} from tip to tip)", **far
        )
    return note("hold the ends {apart:.1f} apart where the bend begins ({tips:.1f} from tip to tip)", **far)


def holding_template(strip: Strip) -> Drawing:
    """Return a full-size side view of a strip, to lay under it or to engrave into the mounting board.

    The view shows the curve, the tabs with the axes of their holes, and the line between the ends. Curve and
    tabs are on the layer ENGRAVE, and guide lines on the layer MARK. Nothing is cut.

    The view has the same side up as the page for measurements. Under gravity and with rails, pins, ties or loads,
    the view has the directions of the drawing.
    """
    ends, rod, elements = held_ends(strip), strip.rod, held_elements(strip)
    shape = Spline(rod.curve)
    # the side of the chord that is drawn above would be below in the drawing
    upside_down = round(upward(heights_of_marks(rod.position, rod.s)) * float(rod.chord[0]), 6) < 0
    if rod.gravity is None and not elements and upside_down:
        x, y = ends[0].position + ends[1].position
        shape = shape.transformed([[-1.0, 0.0, x], [0.0, -1.0, y], [0.0, 0.0, 1.0]])
        ends = ends[0].turned_about(x / 2, y / 2), ends[1].turned_about(x / 2, y / 2)
    first, last = ends
    # the name of each end, and of a joint with another strip
    marks = [joint or number for joint, number in zip(strip.joints, "12", strict=True)]
    lines = [(MARK, [first.position, last.position])]
    for end in ends:
        aside = left_of(end.outward)
        middles = [end.position, *(end.position + hole.at * end.outward for hole in end.holes)]
        lines += [(MARK, [middle - CROSS_MM * aside, middle + CROSS_MM * aside]) for middle in middles]
        if end.tab:
            tip, half = end.tip, 0.5 * end.thickness * aside
            rim = [end.position - half, tip - half, tip + half, end.position + half]
            lines.append((ENGRAVE, rim))
    thick = max(strip.end_thicknesses)
    lines += [(MARK, points) for held in elements for points in _element_lines(held, thick / 2)]
    paths = [LayeredPath(ENGRAVE, Path([shape]))]
    paths += [LayeredPath(layer, Path.polyline(points)) for layer, points in lines]
    low = min(path.path.bounds[0, 1] for path in paths) - 3 * LETTERS_MM
    left = min(first.position[0], last.position[0])
    drawn_text = [
        engravable(strip.engraved or strip.label or "strip")
        + (
            f": its first letter points to its start ({marks[0]})"
            if strip.engraved and not strip.unmarked
            else ""
        ),
        f"bend lines {distance_between(ends):.1f} mm apart, tips {distance_of_tips(ends):.1f} mm",
        *(
            f"{word} ({mark}): strip {angle_text(end.tilt)}"
            + "".join(f", {free}" for free in [freedom_text(end.support, *DRAWN_AXES)] if free)
            + "".join(f", hole at x {x:z.1f}, y {y:z.1f}" for x, y in holes)
            for word, mark, end, holes in zip(("start", "end"), marks, ends, hole_places(ends), strict=True)
        ),
        *map(str, elements),
        *(["mm; x along the line from its start"] if first.holes or last.holes or elements else []),
        "angles from the line, from start to end",
    ]
    texts = [
        Text((left, low - 1.8 * LETTERS_MM * row), line, LETTERS_MM, 0.0, MARK)
        for row, line in enumerate(drawn_text)
    ]
    # name, its width in letter heights, and its middle
    names = [
        (mark, 0.5 * len(mark), end.tip + LETTERS_MM * end.outward * (0.5 * (1 + len(mark)), 1.0))
        for mark, end in zip(marks, ends, strict=True)
    ]
    for held in elements:
        away = ARROW_MM if held.is_load else CROSS_MM
        names.append((held.name, 1.0, held.position[0] + (away + LETTERS_MM) * held.outward[0]))
    for name, wide, (x, y) in names:
        texts.append(Text((x - wide * LETTERS_MM / 2, y - LETTERS_MM / 2), name, LETTERS_MM, 0.0, MARK))
    return Drawing(f"{strip.label or 'strip'} template", tuple(paths), tuple(texts))
