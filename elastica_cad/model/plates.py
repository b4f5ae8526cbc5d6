"""Slotted plates that hold tabs: base plates, rings and caps."""

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal, Self, TypeAlias, TypeVar

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import require_flag, require_number, require_record, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import BASE_BORDER, BASE_PLAY, BORDER, CLEARANCE, PLAY
from elastica_cad.errors import (
    Angle,
    Degrees,
    FaultError,
    FieldName,
    InputError,
    Point,
    both_names,
    note,
    refuse_unknown,
)
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.frame import Frame, frame_or_plain
from elastica_cad.geometry.offset import offset_path
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_about,
    boxes_meet,
    distinct,
    left_of,
    lengths_along,
    norm,
    points_at,
    unit,
    unit_vectors,
)
from elastica_cad.mechanics.sheets import Sheet, require_flat
from elastica_cad.model.fixtures import PlacedTab, require_ends, tabs_to_hold
from elastica_cad.model.plate_holes import PlateHoles, hole_name, is_window, refuse_other_ends
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER, ENGRAVE, Drawing, LayeredPath
from elastica_cad.strip.lettering import LEAST_LABEL_MM, Text, engravable, engraved_names, text_width
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.solids import FlatSolid, convex_corners
from elastica_cad.strip.strip import Placed, engraved_labels, require_placed
from elastica_cad.strip.uncuttable_parts import (
    FabricationLimits,
    Fault,
    accept_faults,
    find_plate_faults,
    find_shoulder_faults,
    find_slot_faults,
    limits_or_default,
)

FLATTEST_RAD = np.radians(15.0)
"""Least angle between a tab and a plate, rad.

At smaller angles, slots would be over four plate thicknesses wide.
"""

LEAST_OPENING_MM = 20.0
"""Least diameter of the opening of a round plate, mm."""

PITCH_MM = 1.0
"""Distance, mm, between points that represent a cut. Distances from the points are at most 0.05 mm too large."""

LABEL_MM = 4.0
"""Height of engraved names, mm, if the plate is large enough."""

FLAT_MM = 0.01
"""Largest distance, mm, of holes from the polylines that represent them in tests of overlap."""

Shape = Literal["hull", "rectangle", "ring"]

Play: TypeAlias = Annotated[float, Option("Clearance on each side of a tab.", "mm", least=0, most=1000)]
Clearance: TypeAlias = Annotated[
    float, Option("Allowance added to the width of slots.", "mm", least=0, most=1000)
]
Border: TypeAlias = Annotated[
    float, Option("Least distance of the slots for strips from the edge.", "mm", least=0, most=1000)
]
Outline: TypeAlias = Annotated[Shape, Option("Outline of the plate.")]
Name: TypeAlias = Annotated[str, Option("Name of the files.")]


@dataclass(frozen=True)
class PlateOptions:
    """Options of a plate that holds tabs.

    `shape` is the outline around all slots. "ring" is round if the slots surround a common centre. A round plate
    has a round opening, unless the opening would be smaller than 20 mm.
    `shop` contains the limits of the workshop, such as the width of bridges between slots and the largest
    sheet. With `ignore_limits`, a plate beyond these limits is made with warnings.
    """

    play: Play = BASE_PLAY
    clearance: Clearance = CLEARANCE
    slot_width: Annotated[float | None, Option("Least width of slots.", "mm", least=0, most=1000)] = None
    border: Border = BASE_BORDER
    shape: Outline = "hull"
    ends: Annotated[Sequence[StripEnd], Option("Tabs to hold; by default all.", written=StripEnd)] = ENDS
    name: Name = "base"
    holes: Annotated[PlateHoles | None, Option("Holes for a lamp holder and screws.")] = None
    shop: FabricationLimits | None = None
    ignore_limits: bool = False

    def __post_init__(self) -> None:
        require_declared(PlateOptions, vars(self), f"{self.name}:")
        require_flag(self.ignore_limits, "ignore_limits")

    def room_beside(self, width: float) -> float:
        """Return by how much a slot is wider than the `width` that its tab needs, mm."""
        return max(
            self.clearance, (self.slot_width or 0.0) - require_number(width, "the width of a slot", "mm")
        )


@dataclass(frozen=True)
class RingOptions(PlateOptions):
    """Options of a ring, and of plates in the best plane for their tabs."""

    play: Play = PLAY
    border: Border = BORDER
    shape: Outline = "ring"
    name: Name = "ring"


Options = TypeVar("Options", bound=PlateOptions)


def options_by_name(
    record: type[Options], options: Mapping[str, Any], what: str, without: Container[str] = ()
) -> Options:
    """Return the record of options given by name.

    Refuse unknown names. `what` is the name of the object in messages.

    Examples
    --------
    >>> options_by_name(PlateOptions, {"play": 0.2}, "a base plate").border
    12.0
    """
    refuse_unknown(options, [name for name in record.__dataclass_fields__ if name not in without], what)
    return record(**options)


@dataclass(frozen=True, eq=False)
class TabSlot:
    """Slot of a base plate.

    Attributes
    ----------
    corners : (4, 2) array
        Corners in the frame of the plate, anticlockwise, mm. The first side is parallel to the tab's width.
    name : str
        Name of the tab.
    through : float
        Thickness of the tab, mm.
    tab : PlacedTab or None
        Tab in the slot, or None for a tongue of another plate.
    """

    corners: FloatArray
    name: str
    through: float
    tab: PlacedTab | None = None

    @cached_property
    def path(self) -> Path:
        """Closed loop to be cut."""
        return Path.polygon(self.corners)

    @property
    def size(self) -> tuple[float, float]:
        """Size of the slot, mm, in the direction of the tab's width and of the tab's thickness."""
        a, b = norm(self.corners[1:3] - self.corners[:2])
        return float(a), float(b)


@dataclass(frozen=True, eq=False)
class BasePlate:
    """Plate with a slot for every tab.

    Attributes
    ----------
    sheet : Sheet
    frame : Frame
        Upper face of the plate, z up.
    outline : Path
        Closed outline, in the frame.
    slots : tuple of TabSlot
    name : str
    warnings : tuple of str
        Faults of the plate, if limits were ignored, and a message if a bridge has no effect.
    opening : Path or None
        Closed loop of the opening in the middle, or None if the plate is closed or has a bridge.
    holes : tuple of Path
        Closed loops of further holes: for a lamp holder, for screws and beside a bridge.
    glued : bool
        True if the tabs are glued at their angle, with feet (gussets).
    options : PlateOptions or None
        Options with which the plate was checked.
    number : str
        Number that is engraved in place of the name, or "" to choose it if the name cannot be engraved.
    """

    sheet: Sheet
    frame: Frame
    outline: Path
    slots: tuple[TabSlot, ...] = ()
    name: str = "base"
    warnings: tuple[str, ...] = ()
    opening: Path | None = None
    holes: tuple[Path, ...] = ()
    glued: bool = False
    options: PlateOptions | None = None
    number: str = ""

    @property
    def _opening_and_holes(self) -> tuple[Path, ...]:
        return self.holes if self.opening is None else (self.opening, *self.holes)

    @property
    def _inner_loops(self) -> tuple[Path, ...]:
        return (*(slot.path for slot in self.slots), *self._opening_and_holes)

    @cached_property
    def _hole_points(self) -> list[FloatArray]:
        return [loop.points(FLAT_MM) for loop in self._opening_and_holes]

    def checked(self, options: PlateOptions) -> Self:
        """Return the plate with warnings about its faults."""
        require_record(options, PlateOptions, "options", "a PlateOptions")
        require_flat(self.sheet)
        _refuse_meetings(self.slots, self.name, in_ring=isinstance(self, Ring))
        called = [note("the slot of {name}", name=slot.name) for slot in self.slots]
        called += [] if self.opening is None else [note("the opening")]
        drilled = [hole_name(hole) for hole in self.holes]
        _refuse_overlaps(self, called, drilled)
        faults = (
            *find_slot_faults(self.name, [(slot.name, slot.size[1], slot.through) for slot in self.slots]),
            *find_plate_faults(
                self.name, self.sheet, self.outline, self._inner_loops, options.shop, called, drilled
            ),
        )
        warnings = (*self._opening_notes(options), *accept_faults(faults, options.ignore_limits))
        return replace(self, warnings=warnings, options=options)

    def _opening_notes(self, options: PlateOptions) -> tuple[str, ...]:
        """Return the note on a missing opening, or on a bridge without effect."""
        # windows are the parts of the opening beside a bridge
        if self.opening is not None or any(map(is_window, self.holes)):
            return ()
        holes = options.holes
        # the hole for a lamp holder or the bridge replaces the opening
        if holes is not None and holes.is_in(self.name) and (holes.bridge or holes.bulb):
            return (self._bridge_note(options, holes),) if holes.bridge else ()
        tabs, bridge = self.tab_loops, limits_or_default(options.shop).bridge_for(self.sheet)
        # without room for an opening even at the least border, no opening is expected
        if not (self.is_round and tabs) or 2 * around(tabs, self._middle, bridge)[0] < LEAST_OPENING_MM:
            return ()
        return (
            note(
                "{name} has no opening, because its slots, spacers and border of {border:g} leave less than "
                "{least:g} free. For an opening, reduce the border, or move the ends of the strips outwards.",
                name=self.name, least=Mm(LEAST_OPENING_MM), border=Mm(options.border),
            ),
        )  # fmt: skip

    def _bridge_note(self, options: PlateOptions, holes: PlateHoles) -> str:
        """Return the note that a bridge has no effect, with a width that was tried and has an effect.

        If the requested width has an effect without the spacers, the spacers are the cause.
        """
        given = holes.bridge or 0.0
        widths = (given, *np.arange(np.ceil(given) - 1.0, 0.0, -1.0).tolist())
        works = (width for width in widths if self._has_bridge(options, replace(holes, bridge=width)))
        width = next(works, None)
        return note(
            "{name}: the bridge has no effect, because the plate has no opening. Leave out the bridge."
            if width is None
            else "{name}: the bridge has no effect, because the spacers fill the opening. Leave out the bridge."
            if width == given
            else "{name}: the bridge has no effect, because its hub fills the opening. "
            "Use a bridge {width:g} wide.",
            name=self.name, width=Mm(width or 0.0),
        )  # fmt: skip

    def _has_bridge(self, options: PlateOptions, holes: PlateHoles) -> bool:
        """Return True if the plate with these holes and without spacers has openings beside the bridge.

        The bridge is a bar across the round opening that carries the holes in the middle (see `PlateHoles`).
        """
        if not (self.is_round and self.tab_loops):
            return False
        # openings beyond the limits of the workshop do not count
        options = replace(options, holes=holes, ignore_limits=False)
        # spacers have tongues in slots without a tab
        slots = tuple(slot for slot in self.slots if slot.tab is not None)
        plate = replace(self, slots=slots, options=options).resized(
            *around(self.tab_loops, self._middle, options.border)
        )
        try:
            return plate.opening_radius > 0 and plate.checked(options) is not None
        except InputError:
            return False

    @property
    def tab_loops(self) -> list[FloatArray]:
        """Corners (4, 2), mm, of the slots that hold tabs, in the plane of the plate."""
        return [slot.corners for slot in self.slots if slot.tab is not None]

    @property
    def is_round(self) -> bool:
        """True if the outline is a circle."""
        return len(self.outline.segments) == 1

    @property
    def _middle(self) -> FloatArray:
        return np.asarray(self.outline.bounds.mean(axis=0), dtype=float)

    @property
    def opening_radius(self) -> float:
        """Radius, mm, of the opening of a round plate, with or without a bridge, or 0 if the plate is closed."""
        edges = [path for path in self._opening_and_holes if path is self.opening or is_window(path)]
        return float(norm(edges[0].points(FLAT_MM) - self._middle).max()) if edges else 0.0

    def resized(self, inner: float, outer: float) -> Self:
        """Return the round plate with other radii, mm, of its opening and its rim, without checks."""
        opening, holes = _opening_and_holes(options_of(self), self._middle, inner)
        return replace(self, outline=Path.circle(self._middle, outer), opening=opening, holes=holes)

    @property
    def solid(self) -> FlatSolid:
        """Body of the plate in space, on the negative side of its frame."""
        thickness = self.sheet.thickness
        return FlatSolid(self.outline, self._inner_loops, thickness, self.frame.shifted(z=-thickness))

    @cached_property
    def drawing(self) -> Drawing:
        """Cutting pattern seen from above, with the name of the tab at every slot."""
        paths = [LayeredPath(CUT_INNER, path) for path in self._inner_loops]
        slots = [dense_points(slot.corners) for slot in self.slots]
        holes = [dense_points(hole) for hole in self._hole_points]
        # the empty array is for a single slot without other cuts
        labels = [
            self._slot_label(slot, np.concatenate([*slots[:k], *slots[k + 1 :], *holes, np.zeros((0, 2))]))
            for k, slot in enumerate(self.slots)
        ]
        name = self._name_inside_slots() or self._name_anywhere([label.box for label in labels])
        return Drawing(self.name, (*paths, LayeredPath(CUT_OUTER, self.outline)), (*labels, *name))

    @property
    def piece(self) -> Piece:
        """The plate as a piece to be cut."""
        number = "" if self.engraved == self.name else self.engraved
        return Piece(self.name, self.drawing, self.sheet, number=number)

    @property
    def engraved(self) -> str:
        """Engraved name: the name, or a number that no strip in the plate has, if it has other letters."""
        strips = (slot.name.rpartition(":")[0] for slot in self.slots)
        return self.number or engraved_names([*strips, self.name])[self.name]

    def _name_inside_slots(self) -> tuple[Text, ...]:
        """Return the name of the plate between its holes and its slots, if there is room."""
        loops, corners = self._opening_and_holes, [slot.corners for slot in self.slots]
        if not loops:
            return ()
        center = _mean_center(corners)
        inner = max(float(norm(loop.points(0.1) - center).max()) for loop in loops)
        free, _ = around(corners, center, 0.0)
        return self._name_between(inner, free, center)

    def _name_between(self, inner: float, outer: float, center: FloatArray) -> tuple[Text, ...]:
        """Return the name as the largest legible text between two circles of radii in mm, or no text."""
        inner, outer, name = inner + CLEAR_MM, outer - CLEAR_MM, engravable(self.engraved)
        largest = min(LABEL_MM, 0.4 * (outer - inner))
        for height in np.linspace(largest, LEAST_LABEL_MM, 12).tolist() if largest > LEAST_LABEL_MM else ():
            half, below = text_width(name, height) / 2, height * DESCENDER_DEPTH
            # highest base line at which the text is inside the outer circle
            most = float(np.sqrt(max(outer**2 - half**2, 0.0))) - height
            if most >= inner + below:
                low = min(most, (inner + below + outer - height) / 2)
                return (Text((center[0] - half, center[1] + low), name, height),)
        return ()

    def _name_anywhere(self, engraved: Sequence[FloatArray]) -> tuple[Text, ...]:
        """Return the name as the largest legible text clear of cuts and of `engraved` loops, or no text.

        The name is above the middle of the plate, or turned around the middle by the least angle.
        """
        loops = [*(path.points(FLAT_MM) for path in self._inner_loops), *engraved]
        edge, name = self.outline.points(FLAT_MM), engravable(self.engraved)
        cuts = np.concatenate([dense_points(loop) for loop in (edge, *loops)]) - self._middle
        for height in np.linspace(LABEL_MM, LEAST_LABEL_MM, 6).tolist():
            half, below = text_width(name, height) / 2, height * DESCENDER_DEPTH
            # turned by as little as possible, in steps of 15 degrees
            for turn in np.radians(sorted(range(-165, 181, 15), key=abs)):
                along = unit_vectors(turn)
                axes = np.array([along, left_of(along)])
                x, y = axes @ cuts.T
                # the name fits between two neighbouring cuts in its column, best between the farthest
                y = np.sort(y[np.abs(x) <= half + CLEAR_MM])
                room = np.diff(y) - height - below - 2 * CLEAR_MM
                for k in (-room).argsort()[: np.count_nonzero(room > 0)]:
                    low = y[k] + room[k] / 2 + CLEAR_MM + below
                    point = self._middle + low * axes[1]
                    if encloses(edge, point) and not any(encloses(loop, point) for loop in loops):
                        start = point - half * axes[0]
                        return (Text((start[0], start[1]), name, height, float(turn)),)
        return ()

    def _slot_label(self, slot: TabSlot, cuts: FloatArray) -> Text:
        """Return the engraved name of the tab, above the slot or, if a cut is too near above, below the slot.

        If cuts are too near on both sides, the name is smaller. `cuts` (n, 2) are points on all other cuts.
        """
        a, b, *_ = slot.corners
        along = unit(b - a)
        # the name reads from left to right, or upwards
        if along[0] < -1e-9 or (abs(along[0]) <= 1e-9 and along[1] < 0):
            along = -along
        middle, axes = slot.corners.mean(axis=0), np.array([along, left_of(along)])
        name = engravable(slot.name)
        x, y = axes @ (cuts - middle).T
        for scale in (1.0, 0.8, 0.6):
            height = scale * min(LABEL_MM, 0.2 * slot.size[0])
            half, far = text_width(name, height) / 2, slot.size[1] / 2 + 0.5 * height
            # heights of the base line above the middle of the slot, and the distance of the nearest cut for each
            bases, room = (far, -far - height), []
            for base in bases:
                beside = y - base - (1 - DESCENDER_DEPTH) / 2 * height
                apart = np.maximum(np.abs(x) - half, np.abs(beside) - (1 + DESCENDER_DEPTH) / 2 * height)
                in_hole = any(encloses(hole, middle + base * axes[1]) for hole in self._hole_points)
                room.append(-1.0 if in_hole else float(apart.min(initial=1.0)))
            if max(room) > 0.2 * height:
                break
        base = bases[0 if room[0] > 0.2 * height or room[0] >= room[1] else 1]
        start = middle + (-half, base) @ axes
        return Text((start[0], start[1]), name, height, float(angle_of(along)))


def tabs_of(plate: BasePlate) -> list[PlacedTab]:
    """Return the tabs in the slots of a plate."""
    return [slot.tab for slot in plate.slots if slot.tab is not None]


Part = TypeVar("Part")


def numbered(
    placed: Sequence[Placed], parts: Sequence[Part], others: Iterable[object] = ()
) -> tuple[Part, ...]:
    """Return the parts of a model with a different engraved text for each name of a plate.

    These texts also differ from those of the strips and of the `others`, which are further parts of the model.
    """
    plates = [part for part in (*others, *parts) if isinstance(part, BasePlate)]
    texts = engraved_labels(placed, ((plate.name, plate.number) for plate in plates))
    return tuple(
        replace(part, number=texts[part.name])
        if isinstance(part, BasePlate) and texts[part.name] != (part.number or part.name)
        else part
        for part in parts
    )


def options_of(plate: BasePlate) -> PlateOptions:
    """Return the options with which a plate was checked, or the default options."""
    return plate.options or PlateOptions()


def base_plate(
    placed: Sequence[Placed], sheet: Sheet | str, *, frame: Frame | None = None, **options: Any
) -> BasePlate:
    """Return one plate with a slot for every tab.

    Tabs are straight in the plate, and cuts are vertical. The width of a slot is h / sin(phi) + H |cot(phi)|
    + clearance, where phi is the angle of the tab to the plate, h the thickness of the tab, and H the
    thickness of the plate.

    Parameters
    ----------
    placed : sequence of Placed
    sheet : Sheet or its name
        Sheet of the plate.
    frame : Frame, optional
        Upper face of the plate, z up; by default the plane z = 0.
    **options
        Fields of `PlateOptions`: play, clearance, slot_width, border, shape, ends, name, shop, ignore_limits.
    """
    plate_options = options_by_name(PlateOptions, options, "a base plate")
    name, sheet = plate_options.name, Sheet.of(sheet)
    placed, ground = require_placed(placed), frame_or_plain(frame)
    require_ends(plate_options.ends)
    refuse_other_ends(plate_options.holes, [name])
    tabs = tabs_to_hold(placed, plate_options.ends)
    if not tabs:
        raise InputError("{name} holds no end of any strip: change its 'strips' or 'ends'", name=name)
    heights = ground.local([[tab.frame.origin, tab.tip] for tab in tabs])[..., 2]
    # tabs that start above the plate, or hardly below its upper face, and reach into it
    standing = [
        tab
        for tab, (start, tip) in zip(tabs, heights.tolist(), strict=True)
        if start > -tab.thickness and tip < -1e-6
    ]
    if not standing:
        least = float(heights[:, 1].min())
        raise InputError(
            "{name}: no tab reaches down through the plate. The lowest tip is {least:.1f} above its upper face. "
            "Move the plate up by {up:.0f} ({height}), give the strips longer tabs, or hold ends that come from "
            "below by rings."
            if least >= 0
            else "{name}: the ends of the strips come from below the plate. Move the plate down ({height}), or "
            "hold these ends by rings.",
            name=name, least=Mm(least), up=Mm(np.ceil(least + sheet.thickness)), height=FieldName("base.height"),
        )  # fmt: skip
    slots = [tab_slot(tab, ground, sheet.thickness, plate_options) for tab in standing]
    return with_shoulders(plate_with(slots, sheet, ground, plate_options, BasePlate), plate_options)


def with_shoulders(plate: BasePlate, options: PlateOptions) -> BasePlate:
    """Return the plate with a warning for each strip that would run into the plate beside its tab."""
    warnings = accept_faults(shoulder_faults(tabs_of(plate), plate.frame, options), options.ignore_limits)
    return replace(plate, warnings=(*warnings, *plate.warnings))


def shoulder_faults(tabs: Sequence[PlacedTab], ground: Frame, options: PlateOptions) -> tuple[Fault, ...]:
    """Return a fault for each strip that would run into a base plate, because it is wider than its tab."""

    def depth(tab: PlacedTab) -> float:
        # depth, mm, of the lower corner of the strip's end below the upper face of the plate
        height = float(ground.local(tab.frame.origin)[2])
        return tab.end_width / 2 * abs(float(ground.z_axis @ tab.frame.y_axis)) - height

    wide = [tab for tab in tabs if tab.end_width > tab.width + 2 * options.play]
    return find_shoulder_faults(options.name, [(tab.name, depth(tab), tab.thickness) for tab in wide])


def tips_below(plates: Sequence[BasePlate]) -> tuple[str, ...]:
    """Return a note if tabs extend below all plates of a base, so that the model would stand on their tips."""
    lowest = min(plates, key=lambda plate: float(plate.frame.origin @ plate.frame.z_axis))
    thickness, depths = lowest.sheet.thickness, []
    for slot in lowest.slots:
        if (tab := slot.tab) is not None:
            # a load bends the tab towards the middle of its slot, which has been moved accordingly
            start = lowest.frame.local(tab.frame.origin)
            out = np.append(slot.corners.mean(axis=0), -thickness / 2) - start
            steepness = float(out[2] / np.linalg.norm(out))
            depth = -float(start[2]) - tab.length * steepness - thickness
            # tips less than 0.2 mm below the plate are not reported
            if depth > 0.2 and steepness < 0:
                depths.append(depth)
    if not depths:
        return ()
    return (
        note(
            "{name}: the tips of the tabs are up to {depth:.1f} below the plate, so the model would stand on them. "
            "Put feet under the plate, or file the tips after the assembly.",
            name=lowest.name, depth=Mm(max(depths)),
        ),
    )  # fmt: skip


def plate_with(
    slots: Sequence[TabSlot],
    sheet: Sheet,
    frame: Frame,
    options: PlateOptions,
    kind: "type[Plate]",
) -> "Plate":
    """Return the plate or the ring (about the z axis of `frame`) that contains the slots.

    Errors are those of `BasePlate.checked`.
    """
    loops = [slot.corners for slot in slots]
    center = np.zeros(2) if kind is Ring else _mean_center(loops)
    inner, outer = around(loops, center, 0.0)
    # a plate is round if the slots surround a common centre
    if kind is Ring or (options.shape == "ring" and inner > 0.5 * outer):
        outline, inner = Path.circle(center, outer + options.border), inner - options.border
    else:
        outline, inner = _outline(np.concatenate(loops), options.border, options.shape), 0.0
    opening, holes = _opening_and_holes(options, center, inner)
    plate = kind(sheet, frame, outline, tuple(slots), options.name, opening=opening, holes=holes)
    return plate.checked(options)


def _mean_center(loops: Sequence[FloatArray]) -> FloatArray:
    return np.asarray(np.mean([loop.mean(axis=0) for loop in loops], axis=0), dtype=float)


def _opening_and_holes(
    options: PlateOptions, center: FloatArray, radius: float
) -> tuple[Path | None, tuple[Path, ...]]:
    # the opening of a round plate, or None, and the loops of its holes (see `PlateHoles.cut`)
    opening = Path.circle(center, radius) if 2 * radius >= LEAST_OPENING_MM else None
    if options.holes is None or not options.holes.is_in(options.name):
        return opening, ()
    return options.holes.cut(center, opening, options.border)


def around(loops: Sequence[FloatArray], center: FloatArray, border: float) -> tuple[float, float]:
    """Return the radii, mm, of two circles about `center`: `border` mm inside, and `border` mm outside, all slots.

    `loops` are the corners of the slots, (4, 2) each.
    """
    # corners of the slots and middles of their sides
    points = np.concatenate([(loop + np.roll(loop, shift, axis=0)) / 2 for loop in loops for shift in (0, 1)])
    away = norm(points - center)
    return float(away.min()) - border, float(away.max()) + border


def dense_points(loop: FloatArray) -> FloatArray:
    """Return points (n, 2) on a polygon, at most `PITCH_MM` apart."""
    closed = np.concatenate([loop, loop[:1]])
    s = lengths_along(closed)
    at = distinct(np.append(s, np.linspace(0.0, s[-1], int(np.ceil(s[-1] / PITCH_MM)) + 1)))
    return points_at(at, s, closed)


def rectangle_about(center: FloatArray, along: FloatArray, size: FloatArray) -> FloatArray:
    """Return the corners (4, 2) of a rectangle, anticlockwise.

    `center` (2,) is its middle, `along` (2,) the unit vector along its first side, and `size` (2,) its sides, mm.
    """
    sides = np.array([along, left_of(along)]) * size[:, None] / 2
    return center + np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) @ sides


def tab_slot(tab: PlacedTab, ground: Frame, thickness: float, options: PlateOptions) -> TabSlot:
    """Return the rectangular slot through which the tab passes."""
    down = -float(tab.frame.x_axis @ ground.z_axis)
    if down < np.sin(FLATTEST_RAD):
        raise InputError(
            "{name}: the tab of {name_2} is at {given:.3g} to the plate, but a slot needs more than "
            "{flattest_rad:.0f}. Use a fixture there",
            name=options.name,
            name_2=tab.name,
            given=Angle(np.arcsin(max(0.0, down))),
            flattest_rad=Angle(FLATTEST_RAD),
        )
    axes, low, high = room_of_tab(tab, ground, thickness)
    room = np.array([options.play, options.room_beside(high[1] - low[1]) / 2])
    low, high = low - room, high + room
    box = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    return TabSlot(box @ axes, tab.name, tab.thickness, tab)


def room_of_tab(tab: PlacedTab, ground: Frame, thickness: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the least rectangle through which a tab passes, as its axes (2, 2) and its corners (2,) in these axes.

    The first axis is parallel to the width of the tab.
    """
    edges = ground.local(tab.edges)
    step = ground.axes @ tab.frame.x_axis
    # points where the four edges of the tab cross the upper and the lower face of the plate
    through = [edges - np.outer((edges[:, 2] - z) / step[2], step) for z in (0.0, -thickness)]
    u = unit((ground.axes @ tab.frame.y_axis)[:2])
    axes = np.array([u, left_of(u)])
    return axes, *box_about(np.concatenate(through)[:, :2] @ axes.T)


def _refuse_meetings(slots: Sequence[TabSlot], name: str, *, in_ring: bool) -> None:
    """Refuse slots that overlap. `in_ring` is True for the strips of a surface of revolution."""
    corners = np.array([slot.corners for slot in slots]).reshape(-1, 4, 2)
    boxes = box_about(corners)
    for i, j in np.argwhere(np.tril(boxes_meet(boxes[:, None], boxes[None]), -1)).tolist():
        if _overlap(corners[i], corners[j]):
            raise InputError(
                "{name}: the slots of {tabs} overlap near {place:.1f}. Give the strips narrower tabs."
                if in_ring
                else "{name}: the slots of {tabs} overlap near {place:.1f}. Give the strips narrower tabs, or "
                "move the strips apart.",
                name=name,
                tabs=both_names(slots[j].name, slots[i].name),
                place=Point((corners[i].mean(axis=0) + corners[j].mean(axis=0)) / 2),
            )


def _refuse_overlaps(plate: BasePlate, called: Sequence[str], drilled: Sequence[str]) -> None:
    """Refuse a hole that meets the edge of the plate or another cut.

    `called` are the names of the slots and the opening, and `drilled` the names of the holes.
    """
    if not drilled:
        return
    loops, names = [path.points(FLAT_MM) for path in plate._inner_loops], (*called, *drilled)
    edge = plate.outline.points(FLAT_MM)
    for k, hole in enumerate(loops[len(called) :], start=len(called)):
        inside = encloses(edge, hole[0]) and not _cross(hole, edge)
        edges = () if inside else (note("the edge"),)
        met = (*edges, *(name for i, name in enumerate(names) if i != k and _overlap(hole, loops[i])))
        if met:
            raise _overlap_error(plate.name, names[k], met[0])


def _overlap_error(name: str, hole: str, other: str) -> InputError:
    return InputError(
        "{name}: {hole} and {other} overlap. Use smaller holes, place them farther apart, or "
        "use a larger plate.",
        name=name, hole=hole, other=other,
    )  # fmt: skip


def _overlap(p: FloatArray, q: FloatArray) -> bool:
    """Return True if two polygons overlap or touch."""
    if not boxes_meet(box_about(p), box_about(q)):
        return False
    return _cross(p, q) or encloses(p, q[0]) or encloses(q, p[0])


def _cross(p: FloatArray, q: FloatArray) -> bool:
    return polylines_cross(np.concatenate([p, p[:1]]), np.concatenate([q, q[:1]])) is not None


def _outline(points: FloatArray, border: float, shape: Shape) -> Path:
    low, high = points.min(axis=0) - border, points.max(axis=0) + border
    if shape == "rectangle":
        return Path.rectangle(*map(float, high - low), corner=low)
    hull = Path.polygon(convex_corners(points))
    return offset_path(hull, border) if border else hull


GAP_MM = 20.0
"""Default distance between two plates, mm."""

LYING_RAD = np.radians(5.0)
"""Largest angle, rad, between ring and tab at which the tab is glued flat to the ring. Glue fills the wedge."""

CLEAR_MM = 0.5
"""Distance, mm, of a name from slots and from the rim."""

DESCENDER_DEPTH = 1 / 3
"""Depth of letters such as g below the base line, as a fraction of their height."""


@dataclass(frozen=True, eq=False)
class Ring(BasePlate):
    """Flat ring about an axis, or a cap without an opening.

    The frame is on the face towards the strips. Its origin is on the axis, and z points towards the strips.

    Attributes
    ----------
    seats : tuple of Path
        Engraved outlines of the tabs that are glued or bolted to the face. The first loops in `holes` are for the
        bolts.
    seated : tuple of str
        Names of the tabs in `seats`.
    """

    seats: tuple[Path, ...] = ()
    seated: tuple[str, ...] = ()

    @property
    def tab_loops(self) -> list[FloatArray]:
        """Corners (4, 2), mm, of the slots that hold tabs, or the outlines of the seats of glued tabs."""
        return super().tab_loops or [seat.points(FLAT_MM) for seat in self.seats]

    @property
    def radii(self) -> tuple[float, float]:
        """Radius of the opening (0 if there is none) and of the rim, mm."""
        return 0.0 if self.opening is None else float(self.opening.bounds[1, 0]), float(
            self.outline.bounds[1, 0]
        )

    @cached_property
    def drawing(self) -> Drawing:
        """Cutting pattern, seen from the strips, with the name of the ring, near the rim if there is room."""
        paths = [LayeredPath(CUT_INNER, path) for path in self._inner_loops]
        paths += [LayeredPath(ENGRAVE, seat) for seat in self.seats]
        paths.append(LayeredPath(CUT_OUTER, self.outline))
        seats = [seat.points(FLAT_MM) for seat in self.seats]
        inner = max(float(norm(loop).max()) for loop in [*(slot.corners for slot in self.slots), *seats])
        name = self._name_between(inner, self.radii[1], np.zeros(2)) or self._name_anywhere(seats)
        return Drawing(self.name, tuple(paths), name)


Plate = TypeVar("Plate", bound=BasePlate)


def slot_reach(radius: float, angle: float, thickness: float, tab: float) -> float:
    """Return the least distance, mm, of a slot in a ring from the axis of the ring.

    The slot is for a tab, `tab` mm thick, that starts at `radius`, in a ring `thickness` mm thick. `angle`, rad,
    is the inclination of the tab to the plane of the ring: 0 for a tab that points outwards in this plane, pi / 2
    for a perpendicular tab. A tab less inclined than `FLATTEST_RAD` needs no slot, and the result is `radius`.
    """
    steepness = abs(float(np.sin(angle)))
    if steepness < np.sin(FLATTEST_RAD):
        return radius
    through = radius + thickness * float(np.cos(angle)) / steepness
    return min(radius, through) - tab / 2 / steepness - CLEARANCE


def ring_plate(
    tabs: Sequence[PlacedTab], sheet: Sheet | str, *, middle: float = np.inf, **options: Any
) -> Ring:
    """Return the ring or cap about the z axis that holds one end of all strips of a surface of revolution.

    Tabs at more than 15 degrees to the plane pass through slots. Tabs at less than 5 degrees are glued or bolted to
    the face, where their outlines are engraved.

    Parameters
    ----------
    tabs : sequence of PlacedTab
        Tabs at the same end of every strip.
    sheet : Sheet or its name
        Sheet of the ring.
    middle : float
        Height of the middle of the model, mm. Flat tabs are on the side of the ring that faces the middle.
    **options
        Fields of `RingOptions` without shape and ends: border, play, clearance, slot_width, name, shop,
        ignore_limits.
    """
    sheet, ring_options = Sheet.of(sheet), options_by_name(RingOptions, options, "a ring", ("shape", "ends"))
    name, tabs = ring_options.name, several("tabs", tabs, PlacedTab, "PlacedTab")
    if not tabs:
        raise InputError(f"{name} has no tab to hold: give PlacedTab records")
    first = tabs[0]
    if first.length == 0:
        raise InputError("{name}: a ring cannot hold strips without tabs: give the strips tabs", name=name)
    height, rise = float(first.frame.origin[2]), float(first.frame.x_axis[2])
    if abs(rise) >= np.sin(FLATTEST_RAD):
        frame = _level_frame(height, up=rise < 0)
        slots = [tab_slot(tab, frame, sheet.thickness, ring_options) for tab in tabs]
        return plate_with(slots, sheet, frame, ring_options, Ring)
    if abs(rise) > np.sin(LYING_RAD):
        lean, steep, flat = np.degrees([np.arcsin(abs(rise)), FLATTEST_RAD, LYING_RAD])
        raise FaultError(
            "{name}: the tabs meet the plane of the ring at {lean:.3g}. Slots need more than "
            "{steep:.0f}, and tabs glued flat need less than {flat:.0f}. Shorten or lengthen the "
            "strips until their ends are steeper or flatter.",
            name=name,
            lean=Degrees(lean),
            steep=Degrees(steep),
            flat=flat,
        )
    below = middle > height
    frame = _level_frame(height + (-0.5 if below else 0.5) * first.thickness, up=below)
    seats = [_seat_corners(tab, frame) for tab in tabs]
    out = unit(seats[0].mean(axis=0))
    along, across = seats[0] @ out, np.abs(seats[0] @ left_of(out))
    # each of the equally spaced seats must be inside its own sector of the ring
    if np.any(across >= along * np.tan(np.pi / len(tabs))):
        raise InputError(
            "{name}: neighbouring tabs overlap at a distance of {least} from the axis. End the strips at a "
            "larger ring, or give them shorter or narrower tabs.",
            name=name,
            least=Mm(along.min()),
        )
    holes = tuple(
        Path.circle(frame.local(tab.frame.point((hole.at, hole.across, 0.0)))[:2], hole.diameter / 2)
        for tab in tabs
        for hole in tab.shape.holes
    )
    inner, outer = around(seats, np.zeros(2), ring_options.border)
    opening, further = _opening_and_holes(ring_options, np.zeros(2), inner)
    for hole in further:
        if any(_overlap(hole.points(FLAT_MM), seat) for seat in seats):
            raise _overlap_error(name, hole_name(hole), note("the seat of a tab"))
    ring = Ring(
        sheet, frame, Path.circle(np.zeros(2), outer), (), name, (), opening, (*holes, *further),
        seats=tuple(map(Path.polygon, seats)), seated=tuple(tab.name for tab in tabs),
    )  # fmt: skip
    return ring.checked(ring_options)


def end_names(name: str, heights: tuple[float, float]) -> dict[StripEnd, str]:
    """Return the names of the plates at the ends of strips: bottom and top if they are at different heights.

    Examples
    --------
    >>> end_names("ring", (180.0, 0.0))
    {'start': 'ring-top', 'end': 'ring-bottom'}
    """
    first, last = heights
    # two plates whose heights differ by less than 1 mm are level, so neither is the upper plate
    words = ENDS if abs(last - first) < 1.0 else ("bottom", "top")
    return {
        end: f"{name}-{word}" for end, word in zip(ENDS, words if last >= first else words[::-1], strict=True)
    }


def _level_frame(height: float, *, up: bool) -> Frame:
    # the horizontal plane at a height, mm, whose z axis points up or down
    return Frame((0.0, 0.0, height), (1.0, 0.0, 0.0), (0.0, 1.0 if up else -1.0, 0.0))


def _seat_corners(tab: PlacedTab, frame: Frame) -> FloatArray:
    # corners (4, 2), mm, of the tab in the plane of the ring
    half = tab.width / 2
    corners = [(0.0, -half, 0.0), (tab.length, -half, 0.0), (tab.length, half, 0.0), (0.0, half, 0.0)]
    return frame.local(tab.frame.point(corners))[:, :2]


def needed_length(tab: PlacedTab, first: BasePlate, gap: float) -> float:
    """Return the length, mm, of a tab through a plate and a plate `gap` mm behind it, rounded up to 0.1 mm."""
    back = first.frame.shifted(z=-2 * first.sheet.thickness - gap)
    missing = float(back.local(tab.tip)[2] / -(back.z_axis @ tab.frame.x_axis))
    return up_to_tenth(tab.length + missing)


def up_to_tenth(length: float) -> float:
    """Return a length rounded up to 0.1 mm, so that a longer tab hardly extends beyond its plate."""
    return float(np.ceil(10 * length - 1e-6) / 10)
