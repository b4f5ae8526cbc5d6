"""Slotted frames, whose rails hold tabs and are joined by ribs, and feet (gussets) for tabs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Self

import numpy as np

from elastica_cad._text import distinct
from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, require_record, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import BORDER, CLEARANCE, PLAY
from elastica_cad.errors import InputError
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.path_intersections import anticlockwise, self_crossing
from elastica_cad.geometry.plane_points import cross, left_of, norm, unit
from elastica_cad.mechanics.sheets import Sheet, require_flat
from elastica_cad.model.fixtures import tabs_to_hold
from elastica_cad.model.plate_pairs import lean_pair, tab_plane, through_slots
from elastica_cad.model.plates import (
    BasePlate,
    Border,
    Clearance,
    PlateOptions,
    Play,
    TabSlot,
    plate_with,
    rectangle_about,
)
from elastica_cad.strip.drawing import CUT_OUTER, SAME_MM, Drawing, LayeredPath
from elastica_cad.strip.lettering import Text, centred_text
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.solids import FlatSolid, convex_corners
from elastica_cad.strip.strip import Placed
from elastica_cad.strip.uncuttable_parts import (
    FabricationLimits,
    accept_faults,
    find_plate_faults,
    limits_or_default,
)

SHOULDER_MM = 5.0
"""Width, mm, of the shoulders of a rib, which rest against the rail beside the tongue."""


@dataclass(frozen=True, eq=False)
class Rib:
    """Plate that joins the rails. Its tongues are in slots of the rails.

    Attributes
    ----------
    name : str
    sheet : Sheet
    frame : Frame
        Middle plane of the rib.
    outline : Path
        Closed outline, in the frame.
    label : Text
        Engraved name, in the frame.
    warnings : tuple of str
        Faults of the rib, if limits were ignored.
    """

    name: str
    sheet: Sheet
    frame: Frame
    outline: Path
    label: Text
    warnings: tuple[str, ...] = ()

    def checked(self, options: PlateOptions) -> Self:
        """Return the rib with warnings about its faults."""
        require_record(options, PlateOptions, "options", "a PlateOptions")
        faults = find_plate_faults(self.name, self.sheet, self.outline, (), options.shop)
        return replace(self, warnings=accept_faults(faults, options.ignore_limits))

    @property
    def solid(self) -> FlatSolid:
        """Body of the rib in space."""
        thickness = self.sheet.thickness
        return FlatSolid(self.outline, (), thickness, self.frame.shifted(z=-thickness / 2))

    @property
    def piece(self) -> Piece:
        """The rib as a piece to be cut, with its engraved name."""
        drawing = Drawing(self.name, (LayeredPath(CUT_OUTER, self.outline),), (self.label,))
        return Piece(self.name, drawing, self.sheet)


@dataclass(frozen=True, eq=False)
class SlottedFrame:
    """Two rails and the ribs between them.

    Attributes
    ----------
    rails : tuple of BasePlate
        One or two rails for the tabs at the starts of the strips, and as many for the tabs at their ends.
    ribs : tuple of Rib
    """

    rails: tuple[BasePlate, ...]
    ribs: tuple[Rib, ...]

    @property
    def parts(self) -> tuple[BasePlate | Rib, ...]:
        """Rails and ribs."""
        return (*self.rails, *self.ribs)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Pieces to be cut."""
        return tuple(part.piece for part in self.parts)

    @property
    def solids(self) -> tuple[tuple[str, FlatSolid], ...]:
        """Bodies of the plates in space, with the names of the plates."""
        return tuple((part.name, part.solid) for part in self.parts)


def slotted_frame(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    ribs: Annotated[int, Option("Number of ribs between the rails.", least=2, most=200)] = 3,
    depth: Annotated[float, Option("Depth of the ribs.", "mm", least=1, most=1000)] = 20.0,
    tongue: Annotated[float, Option("Length of the tongues.", "mm", least=1, most=1000)] = 12.0,
    play: Play = PLAY,
    clearance: Clearance = CLEARANCE,
    border: Border = BORDER,
    gap: Annotated[
        float | None, Option("Distance between two plates that hold inclined tabs.", "mm", above=0)
    ] = None,
    shop: FabricationLimits | None = None,
    ignore_limits: bool = False,
) -> SlottedFrame:
    """Return a frame of plates. Each rail holds the tabs of one end, and ribs join the rails.

    Parameters
    ----------
    placed : sequence of Placed
        Strips with tabs at both ends. The tabs at each end must be near a line or a plane.
    sheet : Sheet or its name
        Sheet of the rails and ribs.
    ribs : int
        Number of ribs, at least 2. The frame has fewer ribs if the gaps between tabs are too narrow.
    depth : float
        Depth of the ribs behind the rails, mm.
    tongue : float
        Length of the ribs' tongues along the slots of the rails, mm.
    play : float
        Gap on each side of tabs and tongues, mm.
    clearance : float
        Amount added to the width of slots, mm.
    border : float
        Least distance of slots from the edge of a rail, mm.
    gap : float, optional
        If given, two rails at this distance, mm, replace each single rail and hold inclined tabs at their
        angle. Shoulders on the tongues hold both rails at this distance.
    shop : FabricationLimits, optional
        Limits of the workshop, such as the width of bridges between slots, and the largest sheet.
    ignore_limits : bool
        Make rails and ribs beyond these limits, and list the faults in their warnings.

    Examples
    --------
    >>> from elastica_cad.strip.strip import Strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.mechanics.least_ratio import optimal_rod
    >>> rod = optimal_rod(PlaneCurve.ellipse((0, 0), (100, 60), start=0.2, end=2.9))
    >>> strip = Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=20)
    >>> arches = [Placed(strip, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 50, 100)]
    >>> frame = slotted_frame(arches, Sheet.named("mdf-3"))
    >>> [piece.name for piece in frame.pieces]
    ['rail-start', 'rail-end', 'rib-1', 'rib-2', 'rib-3']
    """
    sheet = require_flat(Sheet.of(sheet))
    require_declared(slotted_frame, locals(), "frame")
    # steps on both sides of a tongue rest against the inner rail and keep its distance from the outer rail
    step, behind = (0.0, 0.0) if gap is None else (2.5, sheet.thickness + gap)
    if tongue <= 2 * step:
        raise InputError(
            f"the tongue of a frame is {Mm(tongue):g} wide, too narrow to hold in its rails: make the "
            f"tongue wider than {Mm(2 * step):g}"
        )
    options = PlateOptions(play, clearance, border=border, shop=shop, ignore_limits=ignore_limits)
    rails = [_RailPlan.of(placed, end, sheet, options) for end in ENDS]
    outer = [] if gap is None else [_RailPlan.of(placed, end, sheet, options, behind) for end in ENDS]
    # the ribs are at right angles to both rails, along the first rail
    a, b = rails
    normal = np.cross(a.frame.z_axis, b.frame.z_axis)
    # the rails are almost parallel
    if np.linalg.norm(normal) < 0.1:
        normal = a.frame.x_axis - (a.frame.x_axis @ b.frame.z_axis) * b.frame.z_axis
    normal = normal / np.linalg.norm(normal)
    across = normal if normal @ a.frame.x_axis >= 0 else -normal
    # slots of ribs and tabs are at least 3 mm apart, and farther in some sheets
    space = max(3.0, limits_or_default(shop).bridge_for(sheet))
    stations = _stations_of_ribs([*rails, *outer], across, ribs, sheet.thickness + 2 * (space + clearance))
    # for each rib, by its name, its places on both rails
    seats = {
        f"rib-{n}": [rail.seat(station, across) for rail in rails]
        for n, station in enumerate(stations, start=1)
    }
    plates: list[BasePlate] = []
    for group, narrower in ((rails, step), (outer, 0.0)):
        # size of the slots for tongues
        size = (tongue - 2 * narrower + 2 * play, sheet.thickness + clearance)
        for k, rail in enumerate(group):
            held = [*rail.slots]
            for name, places in seats.items():
                center, along = rail.frame.local(places[k].origin), rail.frame.axes @ places[k].x_axis
                corners = rectangle_about(center[:2], along[:2], np.array(size))
                held.append(TabSlot(corners, name, sheet.thickness))
            plates.append(plate_with(held, sheet, rail.frame, replace(options, name=rail.name), BasePlate))
    if gap is not None:
        pairs = [lean_pair(placed, (plates[k], plates[k + 2])) for k in (0, 1)]
        # both inner rails, then both outer rails
        plates = [pair[k] for k in (0, 1) for pair in pairs]
    joining = (
        _rib(name, sheet, places, across, tongue, depth, behind=behind, step=step)
        for name, places in seats.items()
    )
    return SlottedFrame(tuple(plates), tuple(rib.checked(options) for rib in joining))


@dataclass
class _RailPlan:
    """Rail of a frame before it gets slots for ribs: its name, its plane, and the slots for its tabs."""

    name: str
    frame: Frame
    slots: list[TabSlot]

    @classmethod
    def of(
        cls,
        placed: Sequence[Placed],
        end: StripEnd,
        sheet: Sheet,
        options: PlateOptions,
        behind: float = 0.0,
    ) -> "_RailPlan":
        """Return the rail with slots for the tabs of one end, shifted `behind` mm along the tabs."""
        name = f"rail-{end}{'-outer' if behind else ''}"
        tabs = tabs_to_hold(placed, [end])
        frame = tab_plane(tabs, name).shifted(z=-behind)
        return cls(name, frame, through_slots(tabs, frame, sheet, replace(options, name=name)))

    def seat(self, station: float, across: FloatArray) -> Frame:
        """Return the place where a rib meets the upper face: x along the rib, z normal to the face.

        `station`, mm, is its position along `across`, the normal of the ribs. Its position along the rib is
        interpolated between the slots beside it.
        """
        centers = self.frame.point([slot.corners.mean(axis=0) for slot in self.slots])
        n = self.frame.z_axis
        along = np.cross(n, across)
        along = along / np.linalg.norm(along)
        order = (centers @ across).argsort()
        side = float(np.interp(station, (centers @ across)[order], (centers @ along)[order]))
        height = float(self.frame.origin @ n)
        return Frame(station * across + side * along + height * n, along, np.cross(n, along))


def _rib(
    name: str,
    sheet: Sheet,
    seats: Sequence[Frame],
    across: FloatArray,
    tongue: float,
    depth: float,
    *,
    behind: float,
    step: float,
) -> Rib:
    """Return the rib behind the rails. Its tongues are narrower by `step` mm per side in inner rails.

    `seats` are its places on both inner rails, and `across` is its normal. Outer rails are `behind` mm behind the
    inner rails; it is 0 without outer rails.
    """
    frame = Frame(seats[0].origin, seats[0].x_axis, np.cross(across, seats[0].x_axis))
    # half the width of the rib behind a rail, and depths of its side at the rail, its middle and its far side, mm
    rest, under = tongue / 2 + SHOULDER_MM, sheet.thickness + behind
    half, full = under + depth / 2, under + depth

    def at(end: int, *places: tuple[float, float]) -> FloatArray:
        """Return corners of the rib, given by distances towards the other rail and behind the face of a rail."""
        seat, other = seats[end], seats[1 - end]
        sign = 1.0 if (other.origin - seat.origin) @ seat.x_axis >= 0 else -1.0
        return frame.local(seat.origin + np.array(places) @ [sign * seat.x_axis, -seat.z_axis])[:, :2]

    # if the convex block behind both rails has no side for a tongue, the rib is a bar with an arm behind each rail
    bases = [at(end, (-tongue / 2, under), (tongue / 2, under)) for end in (0, 1)]
    block = [at(end, (-rest, under), (-rest, full), (rest, under), (rest, full)) for end in (0, 1)]
    bar = [
        at(0, (-rest, under), (rest, under), (rest, half)),
        at(1, (rest, half), (rest, under), (-rest, under), (-rest, full), (rest, full)),
        at(0, (rest, full), (-rest, full)),
    ]
    for loop in (convex_corners(np.concatenate(block)), anticlockwise(np.concatenate(bar))):
        drawn: FloatArray | None = loop
        for base in bases:
            drawn = None if drawn is None else _with_tongue(drawn, base, (behind, under), step)
        if drawn is not None and self_crossing(drawn, closed=True) is None:
            label = centred_text(name, at(0, (0.0, half))[0], min(6.0, 0.6 * depth), 1.6 * rest)
            return Rib(name, sheet, frame, Path.polygon(drawn), label)
    raise InputError(
        f"{name}: the rails face each other, so no rib can join them from behind. Hold the ends by "
        "fixtures instead"
    )


def _stations_of_ribs(
    rails: Sequence[_RailPlan], across: FloatArray, count: int, space: float
) -> list[float]:
    """Return the stations of ribs before and behind all tabs, and in gaps between tabs.

    Gaps narrower than `space`, mm, are not used.
    """
    slots = [rail.frame.point(slot.corners) @ across for rail in rails for slot in rail.slots]
    # gaps are between the end of all previous slots and the start of the next slot
    starts, ends = np.transpose(sorted((slot.min(), slot.max()) for slot in slots))
    first, last = float(starts[0]), float(ends.max())
    starts, ends = starts[1:], np.maximum.accumulate(ends)[:-1]
    gaps = (starts + ends)[starts - ends >= space] / 2
    chosen = [first - space / 2, last + space / 2]
    for wanted in np.linspace(first, last, count)[1:-1]:
        free = [gap for gap in gaps.tolist() if gap not in chosen]
        if free:
            chosen.append(min(free, key=lambda gap: abs(gap - wanted)))
    return sorted(chosen)


def _with_tongue(
    loop: FloatArray, base: FloatArray, heights: tuple[float, float], step: float
) -> FloatArray | None:
    """Return the anticlockwise loop with an outward tongue on a side, or None if `base` is not on a side.

    `base` (2, 2) has both ends of the tongue on the side. `heights` are two distances from the side. At the
    first distance, the tongue becomes narrower by `step` on both sides. At the second distance, it ends.
    """
    for i, (p, q) in enumerate(zip(loop, np.roll(loop, -1, axis=0), strict=True)):
        side = unit(q - p)
        outward = -left_of(side)
        off, along = (base - p) @ outward, (base - p) @ side
        if np.abs(off).max() < 1e-6 and along.min() > 0 and along.max() < norm(q - p):
            a, b = base[along.argsort()]
            (low, high), inset = np.multiply.outer(heights, outward), step * side
            stepped = [a + low, a + low + inset] if step else []
            back = [b + low - inset, b + low] if step else []
            corners = [a, *stepped, a + high + inset, b + high - inset, *back, b]
            return np.concatenate([loop[: i + 1], corners, loop[i + 1 :]])
    return None


LEAST_GLUED_MM = 4.0
"""Least length of a tab behind its plate for gluing, mm."""


def add_feet(plates: Sequence[BasePlate], size: float) -> tuple[BasePlate | Rib, ...]:
    """Return the plates with glued tabs, and two feet (gussets) for each tab, which set the angle of the tab.

    A foot is perpendicular to plate and tab. One side is glued to the back of the plate, another to the tab.
    Feet of equal strips are equal and share a name. A number distinguishes different feet with the same name.

    Parameters
    ----------
    size : float
        Length, mm, of the two glued sides of a foot, along the tab and along the plate beside the slot.
    """
    plates = several("plates", plates, BasePlate, "BasePlate")
    if not (is_number(size) and size >= LEAST_GLUED_MM):
        raise InputError(
            f"the size of the feet is {size!r} mm: make the feet {Mm(LEAST_GLUED_MM):g} or larger"
        )
    glued = tuple(replace(plate, glued=True) for plate in plates)
    return (*glued, *_distinctly_named([foot for plate in plates for foot in _feet(plate, size)]))


def _feet(plate: BasePlate, size: float) -> Iterator[Rib]:
    """Yield two triangular feet for each tab, glued to both of its faces and to the back of the plate."""
    for slot in plate.slots:
        tab = slot.tab
        if tab is None:
            continue
        # in the side view of the tab, the plate's back has the points p with <n, p> = low
        profile = tab.profile
        back = plate.frame.shifted(z=-plate.sheet.thickness)
        n = (profile.axes @ back.z_axis)[:2]
        low = float((back.origin - profile.origin) @ back.z_axis)
        walls = profile.local(back.point(slot.corners))[:, :2]
        # direction along the back of the plate, with positive y
        level = left_of(unit(n)) * np.sign(n[0])
        for side, called in ((1.0, "a"), (-1.0, "b")):
            face = side * tab.thickness / 2
            begin = (low - n[1] * face) / n[0]
            reach = min(size, tab.length - begin)
            if reach < LEAST_GLUED_MM:
                raise InputError(
                    f"{plate.name}: the tab of {tab.name} is too short to glue feet to: make it "
                    f"{Mm(np.ceil(begin + LEAST_GLUED_MM)):.0f} long"
                )
            # the foot starts where face and back meet, and extends `size` beyond the slot along the back
            corner = np.array([begin, face])
            past = float(((walls - corner) @ (side * level)).max())
            beside = corner + side * level * (max(past, 0.0) + size)
            corners = np.array([corner, corner + reach * np.array([1.0, 0.0]), beside])
            outline = Path.polygon(corners if side > 0 else corners[::-1])
            name = f"foot-{slot.name.replace(':', '-')}{called}"
            yield Rib(name, plate.sheet, profile, outline, _label_in_triangle(name, corners))


def _distinctly_named(feet: Sequence[Rib]) -> Iterator[Rib]:
    """Yield the feet. A number is added to equal names of feet with different shapes."""
    corners = [foot.outline.points(SAME_MM) for foot in feet]
    # positions are rounded, because copies of a foot differ by rounding errors
    shapes = [(foot.name, (p.round(6) + 0.0).tobytes()) for foot, p in zip(feet, corners, strict=True)]
    different = dict.fromkeys(shapes)
    names = dict(zip(different, distinct(name for name, _ in different), strict=True))
    for foot, shape, p in zip(feet, shapes, corners, strict=True):
        name = names[shape]
        yield foot if name == foot.name else replace(foot, name=name, label=_label_in_triangle(name, p))


def _label_in_triangle(name: str, corners: np.ndarray) -> Text:
    sides = np.roll(corners, -1, axis=0) - corners
    # radius of the inscribed circle of the triangle; names are at most 3 mm high
    inner = abs(cross(*sides[:2])) / norm(sides).sum()
    return centred_text(name, corners.mean(axis=0), min(3.0, inner / 2), 1.6 * inner)
