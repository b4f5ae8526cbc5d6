"""Tabs of strips in space, and printed blocks that hold tabs."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from itertools import combinations
from typing import Annotated, Any, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import EqualByValue, and_more, require_record
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import POCKET_CLEARANCE
from elastica_cad.errors import (
    Angle,
    BareLength,
    InputError,
    Length,
    Refusal,
    both_names,
    note,
    refuse_unknown,
)
from elastica_cad.geometry.frame import Frame, frame_or_plain
from elastica_cad.geometry.path import Arc, Path, Segment
from elastica_cad.geometry.plane_points import left_of, points_at, unit, unit_vectors
from elastica_cad.mechanics.sheets import Color
from elastica_cad.strip.lettering import centred_text, text_strokes
from elastica_cad.strip.outline import ENDS, StripEnd, Tab
from elastica_cad.strip.solids import FlatSolid, PrismSolid, convex_corners
from elastica_cad.strip.strip import Placed, Strip, require_placed, strip_marks, strip_names
from elastica_cad.strip.tab_seats import TabSeat, lean_against

Key: TypeAlias = tuple[float, ...]

FIXTURE_COLOR: Color = (0.30, 0.36, 0.42)
"""Color of printed blocks, darker than any sheet."""


def tab_name(strip: str, end: StripEnd) -> str:
    """Return the part number of the tab at an end of a strip, as engraved on the strip."""
    return f"{strip}:{1 if end == 'start' else 2}"


@dataclass(frozen=True, eq=False)
class PlacedTab:
    """Tab in space.

    Attributes
    ----------
    frame : Frame
        The origin is the end of the free part, at half the thickness. The x axis points out of the strip into the
        tab, y across the tab, and z away from the strip's upper side.
    length, width, thickness : float
        Size of the tab, mm.
    shape : Tab
        Tab of the strip, with its holes in the xy plane of the frame.
    name : str
        Part number: the strip's name with 1 for the start and 2 for the end, as in the engraved label.
    end_width : float
        Width of the strip where the tab begins, mm.
    """

    frame: Frame
    length: float
    width: float
    thickness: float
    shape: Tab
    name: str
    end_width: float = 0.0

    @classmethod
    def of(
        cls, strip: Strip, end: StripEnd, frame: Frame | None = None, *, name: str | None = None
    ) -> "PlacedTab":
        """Return the tab at the start or end of a strip. `frame` is the plane of the strip's curve."""
        require_record(strip, Strip, "what a tab is of", "a Strip, as make_strip makes one")
        require_ends([end])
        place = frame_or_plain(frame)
        k, sign = (0, -1.0) if end == "start" else (-1, 1.0)
        out = sign * place.direction(unit_vectors(strip.rod.angle[k]))
        origin = place.point(strip.rod.position[k])
        tab, end_width = strip.ends[k], strip.end_widths[k]
        require_record(name, str | None, "the name of a tab", "a text")
        return cls(
            Frame(origin, out, sign * place.z_axis),
            tab.length,
            tab.widest(end_width),
            strip.end_thicknesses[k],
            tab,
            tab_name(name or strip.number or strip.label or "strip", end),
            end_width,
        )

    @cached_property
    def key(self) -> Key:
        """Rounded position of the tab, by which holders are matched with strips."""
        return tuple(np.round([*self.frame.origin, *self.frame.x_axis], 6).tolist())

    @property
    def tip(self) -> FloatArray:
        """Middle (3,), mm, of the outer end of the tab."""
        return self.frame.point((self.length, 0.0, 0.0))

    @cached_property
    def profile(self) -> Frame:
        """Frame of the side view: x points out of the strip, y away from its upper side, and z across the strip."""
        return Frame(self.frame.origin, self.frame.x_axis, self.frame.z_axis)

    @property
    def edges(self) -> FloatArray:
        """Starting points (4, 3) of the four long edges of the tab, which run along x of the frame."""
        corners = [(0.0, i * self.width / 2, j * self.thickness / 2) for i in (-1, 1) for j in (-1, 1)]
        return self.frame.point(corners)


def place_tabs(placed: Sequence[Placed], ends: Sequence[StripEnd] = ENDS) -> list[PlacedTab]:
    """Return the tabs at these ends of all strips, in the order of the strips and named after the strips."""
    return [
        PlacedTab.of(member.strip, end, member.frame, name=name)
        for member, name in zip(placed, strip_marks(placed), strict=True)
        for end in ends
    ]


def tabs_to_hold(placed: Sequence[Placed], ends: Sequence[StripEnd] = ENDS) -> list[PlacedTab]:
    """Return the result of `place_tabs`. Refuse strips whose ends fit no holder."""
    require_ends(ends)
    for member, name in zip(require_placed(placed), strip_names(placed), strict=True):
        _require_holdable(member.strip, name)
    return place_tabs(placed, ends)


def require_ends(ends: object) -> None:
    """Refuse values that do not name ends of strips."""
    named = ends if isinstance(ends, Sequence) and not isinstance(ends, str) else (ends,)
    if not all(isinstance(end, str) and end in ENDS for end in named):
        raise InputError(f'ends are {ends!r}: give "start", "end", or a list of them')


def _require_holdable(strip: Strip, name: str | None = None) -> None:
    if strip.layout.stack is not None:
        raise InputError(
            f"{name or strip.label or 'strip'}: a holder does not fit a stack of plies, because the stack "
            "is on one side of its curve: clamp the ends of the stack, and give the holder only the other "
            "strips"
        )


MOST_EXTENDED_MM = 150.0
"""Largest height, mm, by which a block is extended down to its floor. Few printers make taller blocks."""

LEVEL = 1e-6
"""Largest depth, mm, of a block below its floor, and largest component of a unit vector, that count as 0."""

CUT_EXTENSION_MM = 1.0
"""Distance, mm, by which bodies that cut holes and pockets extend beyond the faces of the block."""


@dataclass(frozen=True, eq=False)
class EndFixture(EqualByValue):
    """Block with a pocket for a tab, and a foot with two screw holes.

    Parameters
    ----------
    tab : PlacedTab
        Tab in the pocket; see `EndFixture.of`.
    floor : Frame, optional
        Plane under the block, z up, perpendicular to the plane of the strip's curve. The default plane is
        perpendicular to the tab, behind its tip.
    clearance : float
        Clearance around the tab on every side, mm.
    wall : float
        Least thickness around the pocket, mm.
    foot : float
        Width of the foot on each side, mm; 0 for no foot.
    foot_height : float
        Height of the foot, mm.
    screw : float
        Diameter of the screw holes in the foot, mm; 0 for no holes. Holes of the tab also pass through the block,
        for clamping screws.
    engrave : str, optional
        Engraved text; by default the tab's name, empty for no text.
    lean : (float, float)
        Shift of the pocket to the left of the strip's curve, mm, and rotation of the pocket to the left, rad.
        `EndFixture.of` computes both.

    Examples
    --------
    >>> from elastica_cad.mechanics.rod import Rod
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> strip = Strip(Rod.straight(100), Sheet.named("birch-plywood-0.8"), max_width=20, label="A")
    >>> fixture = EndFixture.of(strip, "end")
    >>> fixture.engrave, len(fixture.solid.added)
    ('A:2', 2)
    """

    tab: PlacedTab
    floor: Frame | None = None
    clearance: Annotated[
        float, Option("Clearance around the tab in its pocket.", "mm", least=0, most=100)
    ] = POCKET_CLEARANCE
    # a printed wall is at least two lines of a 0.4 mm nozzle
    wall: Annotated[float, Option("Thickness around the pocket.", "mm", least=0.8, most=1000)] = 4.0
    foot: Annotated[
        float, Option("Width of the foot on each side of the block; 0 for no foot.", "mm", least=0, most=1000)
    ] = 12.0
    foot_height: Annotated[float, Option("Height of the foot.", "mm", above=0, most=1000)] = 4.0
    screw: Annotated[
        float, Option("Diameter of the screw holes in the foot; 0 for no holes.", "mm", least=0, most=100)
    ] = 4.3
    engrave: str | None = None
    lean: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        require_record(self.tab, PlacedTab, "the tab", "a PlacedTab")
        require_record(self.floor, Frame | None, "the floor", "a Frame")
        who = f"fixture {self.tab.name}"
        if self.tab.length <= 0:
            raise InputError(f"{who}: the strip has no tab at this end: add one, such as Tab(10)")
        require_declared(EndFixture, vars(self), f"{who}:")
        if self.foot and self.screw > 0.8 * min(self.foot, self.across):
            raise InputError(
                "{who}: a screw of {screw:g} does not fit into a foot of {foot:g} x {across:.4g}: make the "
                "foot longer or the screw thinner",
                who=who,
                screw=Length(self.screw),
                foot=BareLength(self.foot),
                across=Length(self.across),
            )
        if self.engrave is None:
            object.__setattr__(self, "engrave", self.tab.name)
        # sine of the angle between the floor and the width of the strip
        lean = abs(float(self.ground.z_axis @ self.tab.frame.y_axis))
        if lean > LEVEL:
            raise InputError(
                "{who}: the strip leans by {lean:.3g}, but a block on a floor needs an upright "
                "strip. Leave out the floor; the block is then at right angles to its tab",
                who=who,
                lean=Angle(np.arcsin(min(1.0, lean))),
            )
        if self.lowest < -LEVEL:
            raise InputError(
                "{who}: the block reaches {given:.4g} below the floor: lower the floor or shorten the tab",
                who=who,
                given=Length(-self.lowest),
            )

    @classmethod
    def of(
        cls,
        strip: Strip,
        end: StripEnd = "start",
        frame: Frame | None = None,
        *,
        floor: Frame | None = None,
        engrave: str | None = None,
        **sizes: Any,
    ) -> "EndFixture":
        """Return the fixture for an end of a strip. `frame` is the plane of the strip's curve, by default xy.

        The pocket is shifted and rotated so that the tab, which the load presses against the walls, has its
        designed position.
        """
        tab = PlacedTab.of(strip, end, frame)
        _require_holdable(strip)
        return cls(tab, floor, engrave=engrave, **sizes).leaning(strip, end)

    def leaning(self, strip: Strip, end: StripEnd) -> "EndFixture":
        """Return the fixture with its pocket shifted and rotated against the load at the end of the strip.

        The loaded tab bends between the walls. Drawings show the tab straight, so it overlaps the walls slightly.
        """
        require_record(strip, Strip, "what is held", "a Strip")
        require_ends([end])
        index, straight = ENDS.index(end), replace(self, lean=(0.0, 0.0)).seat
        # the strip as cut, bent by its loads, and the stiffness of the tab divided by that of this rod
        loaded = strip.as_made.loaded
        lean = lean_against(loaded, index, straight, strip.as_made.tab_ratios(loaded)[index])
        return replace(self, lean=(lean.shift, lean.turn))

    @property
    def warnings(self) -> tuple[Refusal, ...]:
        """Warning about a tall block, and a message that the pocket is rotated."""
        warnings = []
        if self.lowest > MOST_EXTENDED_MM:
            warnings.append(note(
                "The block of {tab} is {height:.0f} high, because the floor is {extra:.0f} below its "
                "pocket. Raise the floor, or leave out the floor.",
                tab=self.tab.name, height=Length(self.size[2]), extra=Length(self.lowest), severity="warning",
            ))  # fmt: skip
        # depth, mm, to which the straight tab in its designed position overlaps a wall
        depth = -float(self.seat.gaps(0.0, 0.0, 1).min())
        if depth > 0:
            shift, turn = self.lean
            warnings.append(note(
                "The pocket of {fixture} is turned by {angle:.2g} and moved by {shift:.2g}, so that the "
                "loaded tab has its designed direction. In the drawing, the wall of the pocket overlaps the "
                "straight tab by up to {depth:.2g}. Do not correct the pocket.",
                fixture=self.label, angle=Angle(abs(turn)), shift=Length(abs(shift)),
                depth=Length(depth), severity="note",
            ))  # fmt: skip
        return tuple(warnings)

    @property
    def label(self) -> str:
        """Name of the block in assemblies."""
        return f"fixture {self.engrave or self.tab.name}"

    @property
    def across(self) -> float:
        """Width of the block across the strip, mm."""
        return self.tab.width + 2 * (self.clearance + self.wall)

    @property
    def size(self) -> tuple[float, float, float]:
        """Length along the tab, width and height of the block with its foot, mm."""
        up, along, height = self._floor_directions
        corners = np.concatenate([prism.outline.points(1.0) for prism in self.solid.added])
        return float(np.ptp(corners @ along)), self.across, float((corners @ up).max() - height)

    @cached_property
    def ground(self) -> Frame:
        """Plane under the block. The z axis points to the block."""
        if self.floor is not None:
            return self.floor
        tab = self.tab.frame
        back = self.tab.length + self.clearance + self.wall
        return Frame(tab.point((back, 0.0, 0.0)), tab.z_axis, tab.y_axis)

    @cached_property
    def _block_corners(self) -> FloatArray:
        half = self.tab.thickness / 2 + self.clearance + self.wall
        back = self.tab.length + self.clearance + self.wall
        return np.array([(0.0, -half), (back, -half), (back, half), (0.0, half)])

    @cached_property
    def _floor_directions(self) -> tuple[FloatArray, FloatArray, float]:
        """Unit vectors (2,) normal to the floor and along the floor, and height of the floor, in the side view."""
        n = self.ground.z_axis
        up = unit((self.tab.profile.axes @ n)[:2])
        return up, -left_of(up), float((self.ground.origin - self.tab.profile.origin) @ n)

    @property
    def lowest(self) -> float:
        """Height, mm, above the floor of the block's lowest corner, before the block is extended to the floor."""
        up, _, height = self._floor_directions
        return float((self._block_corners @ up).min() - height)

    @property
    def lowest_height(self) -> float:
        """Least z in space, mm, of the block around the pocket."""
        return float(self.tab.profile.point(self._block_corners)[:, 2].min())

    @property
    def seat(self) -> TabSeat:
        """Walls of the pocket between which the tab can move."""
        return TabSeat.pocket(self.tab.length, self.tab.thickness, self.clearance).moved(*self.lean)

    @cached_property
    def solid(self) -> PrismSolid:
        """Block as a union and difference of prisms. The pocket is the first prism that is removed.

        The body has a joint with the name "tab" at the end of the free part of the strip.
        """
        up, along, height = self._floor_directions
        core = self._block_corners
        # the block around the pocket, extended to its projection on the floor
        body = convex_corners(np.concatenate([core, core - np.outer(core @ up - height, up)]))
        added = [self._prism(body, self.across)]
        reach = np.array([(core @ along).min(), (core @ along).max()])
        removed = [self._pocket(), *self._clamp_holes(body), *self._tip_hole(body)]
        if self.foot:
            span = reach + np.array([-self.foot, self.foot])
            low, high = height * up, (height + self.foot_height) * up
            left, right = span[:, None] * along
            added.append(
                self._prism(np.array([left + low, right + low, right + high, left + high]), self.across)
            )
            middles = (span[0] + self.foot / 2, span[1] - self.foot / 2)
            removed += [self._screw_hole(x) for x in middles if self.screw]
        return PrismSolid(tuple(added), (*removed, *self._letter_grooves()), {"tab": self.tab.frame})

    def _prism(self, corners: FloatArray, across: float) -> FlatSolid:
        """Return the prism with these anticlockwise corners in the side view."""
        return FlatSolid(Path.polygon(corners), (), across, self.tab.profile.shifted(z=-across / 2))

    def _pocket(self) -> FlatSolid:
        """Return the space that the tab needs in the block, leaning and enlarged by the clearance."""
        half = self.tab.thickness / 2 + self.clearance
        back, front = self.tab.length + self.clearance, -CUT_EXTENSION_MM
        shift, turn = self.lean
        cos, sin = np.cos(turn), np.sin(turn)
        corners = np.array([(front, -half), (back, -half), (back, half), (front, half)])
        # the left side of the curve is below the strip, in direction -y of the profile
        leaned = corners @ np.array([[cos, -sin], [sin, cos]]) - (0.0, shift)
        return self._prism(leaned, self.tab.width + 2 * self.clearance)

    def _clamp_holes(self, body: FloatArray) -> list[FlatSolid]:
        low, high = body[:, 1].min() - CUT_EXTENSION_MM, body[:, 1].max() + CUT_EXTENSION_MM
        frame = self.tab.frame.shifted(z=float(low))
        return [
            FlatSolid(Path.circle((hole.at, hole.across), hole.diameter / 2), (), float(high - low), frame)
            for hole in self.tab.shape.holes
        ]

    def _tip_hole(self, body: FloatArray) -> list[FlatSolid]:
        """Return the hole for the screw of a T-slot, from the tip of the tab through the block, if there is one."""
        slot, tab = self.tab.shape.t_slot, self.tab.frame
        if slot is None:
            return []
        # past the foot, which extends beyond the block where the floor is along the tab
        tip, back = self.tab.length, float(body[:, 0].max()) + 2 * self.foot + CUT_EXTENSION_MM
        frame = Frame(tab.point((tip, 0.0, 0.0)), tab.y_axis, tab.z_axis)
        return [FlatSolid(Path.circle((0.0, 0.0), slot.screw / 2), (), back - tip, frame)]

    def _screw_hole(self, along: float) -> FlatSolid:
        up, level, height = self._floor_directions
        start = self.tab.profile.point(along * level + (height - CUT_EXTENSION_MM) * up)
        across = self.tab.profile.z_axis
        # the z axis of this frame is `up`
        frame = Frame(start, np.cross(across, self.tab.profile.direction(up)), across)
        return FlatSolid(
            Path.circle((0.0, 0.0), self.screw / 2), (), self.foot_height + 2 * CUT_EXTENSION_MM, frame
        )

    def _letter_grooves(self) -> list[FlatSolid]:
        """Return the grooves of the letters on the side of the block."""
        if not self.engrave:
            return []
        (_, low), (long, high) = self._block_corners[0], self._block_corners[2]
        tab = self.tab.frame
        side = Frame(tab.point((0.0, self.across / 2, 0.0)), tab.x_axis, -tab.z_axis)
        text = centred_text(self.engrave, (long / 2, 0.0), min(4.0, 0.7 * (high - low)), 0.85 * long)
        return engraved(text_strokes(text), text.height, side)


def engraved(strokes: Sequence[Path], height: float, side: Frame) -> list[FlatSolid]:
    """Return the grooves of letters of this height in a face whose normal is the z axis of `side`.

    Each line or arc of a stroke is a groove with a flat bottom.
    """
    # if letters are 4 mm high, a 0.4 mm nozzle can print this width, and the depth is two fine layers
    width, depth = 0.16 * height, 0.075 * height
    frame = side.shifted(z=-depth)
    return [
        FlatSolid(_groove(segment, width), (), 2 * depth, frame)
        for stroke in strokes
        for segment in stroke.segments
    ]


def _groove(middle: Segment, width: float) -> Path:
    """Return the outline of a groove along a line or arc, or a round hole if the width exceeds the length."""
    if middle.length <= width:
        return Path.circle(middle.at(0.5), width / 2)
    ends, along = middle.at(np.array([0.0, 1.0])), middle.tangent_at(np.array([0.0, 1.0]))
    off = width / 2 * left_of(along)
    # bulge of an arc as in DXF files
    bulge = np.tan(middle.sweep / 4) if isinstance(middle, Arc) else 0.0
    return Path.polyline([*(ends - off), *(ends + off)[::-1]], [bulge, 0.0, -bulge, 0.0], closed=True)


def end_fixtures(
    placed: Sequence[Placed], *, floor: Frame | None = None, ends: Sequence[StripEnd] = ENDS, **sizes: Any
) -> tuple[EndFixture, ...]:
    """Return blocks for these ends of every strip that has tabs. `sizes` are fields of `EndFixture`.

    By default, blocks of strips in vertical planes have a horizontal floor below the lowest block. A block
    more than `MOST_EXTENDED_MM` above this floor has a higher floor or, if its tab points upwards, a floor
    perpendicular to the tab. Blocks of other strips have a floor perpendicular to the tab.
    """
    refuse_unknown(
        sizes, {field.name for field in fields(EndFixture)} - {"tab", "floor", "engrave"}, "a fixture"
    )
    placed = require_placed(placed)
    tabs = tabs_to_hold(placed, ends)
    of_tabs = [(member.strip, end) for member in placed for end in ends]
    held = [(tab, *of) for tab, of in zip(tabs, of_tabs, strict=True) if tab.length > 0]
    if floor is not None:
        grounds: list[Frame | None] = [floor] * len(held)
    else:
        grounds = _floors([EndFixture(tab, None, engrave=None, **sizes) for tab, _, _ in held])
    return tuple(
        EndFixture(tab, ground, engrave=None, **sizes).leaning(strip, end)
        for (tab, strip, end), ground in zip(held, grounds, strict=True)
    )


def _floors(blocks: Sequence[EndFixture]) -> list[Frame | None]:
    """Return the floor of each block if it is horizontal, or None if it is perpendicular to the tab."""
    floors: list[Frame | None] = [None] * len(blocks)
    floor = None
    for k in sorted(range(len(blocks)), key=lambda k: blocks[k].lowest_height):
        tab, height = blocks[k].tab.frame, blocks[k].lowest_height
        # the plane of the strip is not vertical
        if abs(tab.y_axis[2]) > LEVEL:
            continue
        if floor is None or height - floor.origin[2] > MOST_EXTENDED_MM:
            # far above the floor, a block whose tab points upwards gets a floor perpendicular to its tab
            if tab.x_axis[2] > LEVEL and floor is not None:
                continue
            floor = Frame((0.0, 0.0, height))
        floors[k] = floor
    return floors


PITCH_MM = 0.5
"""Distance, mm, between sample points on strips and on edges of blocks that are tested for overlap."""


def crowded_blocks(blocks: Sequence[EndFixture], placed: Sequence[Placed]) -> tuple[str, ...]:
    """Return messages on the first two blocks that overlap and on the first strip that runs through a block.

    Examples
    --------
    >>> crowded_blocks([], [])
    ()
    """
    if not blocks:
        return ()
    parts = [[_Prism.of(solid) for solid in block.solid.added] for block in blocks]
    edges = [np.concatenate([part.edges for part in its]) for its in parts]
    pairs = [
        both_names(blocks[i].tab.name, blocks[j].tab.name)
        for i, j in combinations(range(len(blocks)), 2)
        if _is_inside_any(edges[i], parts[j]) or _is_inside_any(edges[j], parts[i])
    ]
    crossed = [
        note("{strip} would pass through the printed block of {tab}", strip=name, tab=blocks[k].tab.name)
        for name, strip in zip(strip_names(placed), placed, strict=True)
        for k in _crossed_blocks(strip, blocks, parts)
    ]
    messages = []
    if pairs:
        messages.append(note(
            "the printed blocks of {pair}{more} would overlap: let these strips end farther apart, make wall and "
            "foot smaller, or hold fewer ends with blocks (keys `strips` and `ends`)",
            pair=pairs[0], more=and_more(pairs, "pair"),
        ))  # fmt: skip
    if crossed:
        messages.append(note(
            "{crossed}{more}: let the strips end farther apart, or hold fewer ends with blocks (keys "
            "`strips` and `ends`)",
            crossed=crossed[0], more=and_more(crossed, "place"),
        ))  # fmt: skip
    return tuple(messages)


def _crossed_blocks(
    placed: Placed, blocks: Sequence[EndFixture], parts: Sequence[Sequence["_Prism"]]
) -> list[int]:
    """Return the indices of the blocks that a strip runs through, except the blocks that hold it."""
    tab_keys = {PlacedTab.of(placed.strip, end, placed.frame).key for end in ENDS}
    rod, frame = placed.strip.rod, placed.frame
    s = np.linspace(0.0, rod.length, int(rod.length / PITCH_MM) + 2)
    half = placed.strip.width(s) / 2
    across = np.linspace(-1.0, 1.0, int(2 * half.max() / PITCH_MM) + 2)
    middle = frame.point(points_at(s, rod.s, rod.position))

    def crosses(prisms: Sequence["_Prism"]) -> bool:
        corners = np.concatenate([prism.edges for prism in prisms])
        near = (middle > corners.min(axis=0) - half.max()) & (middle < corners.max(axis=0) + half.max())
        places, wide = middle[near.all(axis=1)], half[near.all(axis=1)]
        points = places[:, None] + np.multiply.outer(wide, across)[..., None] * frame.z_axis
        return _is_inside_any(points.reshape(-1, 3), prisms)

    return [k for k, block in enumerate(blocks) if block.tab.key not in tab_keys and crosses(parts[k])]


def _is_inside_any(points: FloatArray, parts: Sequence["_Prism"]) -> bool:
    # an overlap of up to 0.1 mm can be filed off
    return any(bool((part.depths(part.near(points)) > 0.1).any()) for part in parts)


@dataclass(frozen=True, eq=False)
class _Prism:
    """Convex prism: points (n, 3) along its edges, and a point and the normal of each face."""

    edges: FloatArray
    faces: FloatArray
    outward: FloatArray

    @classmethod
    def of(cls, solid: FlatSolid) -> "_Prism":
        """Return the prism of a solid whose outline is an anticlockwise polygon."""
        up = solid.frame.z_axis
        lower = solid.frame.point([segment.start for segment in solid.outline.segments])
        upper, sides = lower + solid.thickness * up, np.roll(lower, -1, axis=0) - lower
        starts = np.concatenate([lower, upper, lower])
        ways = np.concatenate([sides, sides, upper - lower])
        count = int(np.linalg.norm(ways, axis=1).max() / PITCH_MM) + 2
        edges = starts + np.linspace(0.0, 1.0, count)[:, None, None] * ways
        outward = np.concatenate([np.cross(sides, up), up[None], -up[None]])
        outward /= np.linalg.norm(outward, axis=1)[:, None]
        return cls(edges.reshape(-1, 3), np.concatenate([lower, upper[:1], lower[:1]]), outward)

    def near(self, points: FloatArray) -> FloatArray:
        inside = (points > self.edges.min(axis=0)) & (points < self.edges.max(axis=0))
        return np.asarray(points[inside.all(axis=1)])

    def depths(self, points: FloatArray) -> FloatArray:
        """Return the depths (n,), mm, of points (n, 3) below the surface, negative for points outside."""
        heights = (self.faces * self.outward).sum(axis=1)
        return np.asarray((heights - points @ self.outward.T).min(axis=1))
