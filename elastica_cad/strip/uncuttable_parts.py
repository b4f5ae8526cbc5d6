"""Limits of a workshop, and faults of parts that it cannot cut or handle."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad._values import SEEN_APART, and_more, distinct_digits, require_record
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import (
    BareLength,
    Change,
    FaultError,
    FieldName,
    Length,
    Listed,
    Point,
    both_names,
    note,
    rounded_down,
    rounded_up,
    sentences,
)
from elastica_cad.geometry.path import Arc, Path, Segment, distances
from elastica_cad.geometry.path_intersections import anticlockwise
from elastica_cad.geometry.plane_points import (
    blocks_of_near_pairs,
    cross,
    dot,
    left_of,
    near_pairs,
    norm,
    numbers_in_groups,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.element_cuts import element_cuts
from elastica_cad.strip.lamination import Laminated
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.perforation import Perforated
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.styles import PLAIN, Plain, outline_field

LARGEST_SLENDERNESS = 600.0  # ratio of length to least width above which a flat strip is too floppy to handle


@dataclass(frozen=True)
class FabricationLimits:
    """Limits of a workshop. The default limits depend on the sheet.

    Parameters
    ----------
    least_width : float, optional
        Least width of a strip, a tab or a tongue, mm. By default the value of the sheet record or, if it has none,
        3 times the thickness and at least 3 mm.
    least_ligament : float, optional
        Least width of material between the holes of a perforated strip, mm. By default the value of the sheet
        record or, if it has none, 0.5 mm.
    least_bridge : float, optional
        Least width of material between the cuts of a ring or a plate, mm. By default the value of the sheet record
        or, if it has none, the thickness and at least 2 mm.
    stock : (float, float), optional
        Longer and shorter side of the largest sheet, mm. By default the values of the sheet record or, if it has
        none, 3050 by 1525 mm.
    lap : float, optional
        Length of the plates that join the pieces of a strip longer than the stock, mm. By default such strips are
        refused.

    Examples
    --------
    >>> FabricationLimits().width_for(Sheet.named("birch-plywood-0.8"))
    3.0
    >>> FabricationLimits(least_width=1.5).width_for(Sheet.named("birch-plywood-0.8"))
    1.5
    """

    least_width: Annotated[
        float | None,
        Option(
            "Least width of a strip, tab or tongue; by default that of the sheet.",
            "mm",
            least=0.05,
            group="limits",
        ),
    ] = None
    least_ligament: Annotated[
        float | None,
        Option("Least material between the holes of a perforated strip.", "mm", least=0.05, group="limits"),
    ] = None
    least_bridge: Annotated[
        float | None, Option("Least material between the cuts of a plate.", "mm", least=0.05, group="limits")
    ] = None
    stock: Annotated[
        tuple[float, float] | None, Option("Sides of the largest sheet.", "mm", above=0, group="limits")
    ] = None
    lap: Annotated[
        float | None,
        Option(
            "Length of the plates that join pieces of a strip longer than the stock.",
            "mm",
            above=0,
            group="limits",
        ),
    ] = None

    def __post_init__(self) -> None:
        require_declared(FabricationLimits, vars(self))
        if self.stock is not None:
            object.__setattr__(self, "stock", (float(max(self.stock)), float(min(self.stock))))

    def width_for(self, sheet: Sheet) -> float:
        """Return the least width of strips, tabs and tongues of a sheet, mm."""
        sheet = Sheet.of(sheet)
        # narrower strips break when they are lifted out, or twist
        return self.least_width or sheet.least_width or max(3.0, 3.0 * sheet.thickness)

    def ligament_for(self, sheet: Sheet) -> float:
        """Return the least width of material between the holes of a perforated strip, mm."""
        sheet = Sheet.of(sheet)
        # less material between two laser cuts may burn away
        return self.least_ligament or sheet.least_ligament or 0.5

    def bridge_for(self, sheet: Sheet) -> float:
        """Return the least width of material between two cuts of a plate, mm."""
        sheet = Sheet.of(sheet)
        # both cuts heat the material between them
        return self.least_bridge or sheet.least_bridge or max(2.0, sheet.thickness)

    def stock_for(self, sheet: Sheet) -> tuple[float, float]:
        """Return the longer and the shorter side of the largest available piece of a sheet, mm."""
        sheet = Sheet.of(sheet)
        # largest sheet of plywood or board that is sold
        long, short = sorted(self.stock or sheet.stock or (3050.0, 1525.0), reverse=True)
        return long, short


def limits_or_default(shop: FabricationLimits | None) -> FabricationLimits:
    """Return the limits, or `DEFAULT_LIMITS` for None. Raise InputError for other values."""
    if shop is None:
        return DEFAULT_LIMITS
    require_record(shop, FabricationLimits, "the shop", "a FabricationLimits record")
    return shop


DEFAULT_LIMITS = FabricationLimits()
"""Limits for parts whose workshop is unknown."""

LONGEST_PART = 2.0  # longest chord in the search for facing points, as a multiple of the least width
# least cosine of the angle between a normal and the line to the facing point; no points face each other in
# corners wider than 50 degrees
LEAST_FACING_COSINE = 0.9
CHORD_ERROR_FRACTION = 0.02  # chord error of the cuts as a fraction of the least width


@dataclass(frozen=True)
class ThinPlace:
    """Place with too little material between two cuts: its middle (x, y), mm, and its width, mm.

    `loops` are the indices of the two cuts; outlines are counted before holes.
    """

    x: float
    y: float
    width: float
    loops: tuple[int, int] = (0, 0)


def find_thin_places(outlines: Sequence[Path], holes: Sequence[Path], least: float) -> tuple[ThinPlace, ...]:
    """Return the places where the material between two cuts is narrower than `least`, the narrowest first.

    Of places closer together than `least`, only the narrowest is reported.

    Parameters
    ----------
    outlines, holes : sequences of Path
        Closed outer and inner cuts.
    least : float
        Least width of material, mm.

    Examples
    --------
    >>> plate, hole = Path.rectangle(40, 20), Path.rectangle(10, 10, corner=(5, 1))
    >>> [place.width for place in find_thin_places([plate], [hole], 2.0)]
    [1.0]
    """
    # the width between two holes is measured between chords, so it is too large by two chord errors
    reach = (1 + 2 * CHORD_ERROR_FRACTION) * least
    parts = _Chords.of(outlines, holes, CHORD_ERROR_FRACTION * least).divided(LONGEST_PART * least)
    near = parts.at(_chords_near_others(parts, reach))
    if not near.loop.size:
        return ()
    # the error of a width is then 1 %
    near = near.divided(least / 12)
    points, loop = near.middle, near.loop
    i, j, width = _widths_across(points, near.inward, reach)
    middle = (points[i] + points[j]) / 2
    cuts = (*outlines, *holes)
    places = []
    for k in _thinnest_of_each_group(middle, width, least):
        loops = int(loop[i[k]]), int(loop[j[k]])
        other, hole = (cuts[number] for number in sorted(loops))
        narrow = float(width[k])
        # beside a round hole, the width is computed exactly
        if hole is not other and isinstance(circle := hole.segments[0], Arc) and circle.is_circle:
            here = middle[k]
            faced = min(other.segments, key=lambda segment: _distance(here, [segment]))
            narrow = _distance(circle.center, [faced]) - circle.radius
        if narrow < least * (1 - SEEN_APART):
            x, y = middle[k].tolist()
            places.append(ThinPlace(x, y, narrow, loops))
    return tuple(sorted(places, key=lambda place: place.width))


def _distance(point: FloatArray, segments: Iterable[Segment]) -> float:
    return min(float(distances(segment, point)[0]) for segment in segments)


def _chords_near_others(chords: "_Chords", least: float) -> IntArray:
    """Return the indices of chords that face another chord across less than `least` mm of material."""
    i, j = near_pairs(chords.middle, chords.middle, (1 + LONGEST_PART) * least)
    inward = chords.inward
    # each normal is within acos(LEAST_FACING_COSINE) of the line between facing points
    opposed = dot(inward[i], inward[j]) < 1 - 2 * LEAST_FACING_COSINE**2
    here, there = chords.at(i[opposed]), chords.at(j[opposed])
    facing = here.has_in_front(there, least) & there.has_in_front(here, least)
    return np.flatnonzero(np.bincount(i[opposed][facing], minlength=chords.loop.size))


def _widths_across(
    points: FloatArray, inward: FloatArray, least: float
) -> tuple[IntArray, IntArray, FloatArray]:
    """Return index pairs (k,) of points that face each other across the material, and their distances, mm.

    Each point is paired only with the closest point. `inward` (n, 2) are unit normals that point into the
    material. These times `least` are appended to the coordinates, so that one search compares points and normals.
    """
    here, there = np.hstack([points, least * inward]), np.hstack([points, -least * inward])
    # if two points face each other, the sum of their normals is at most 2 sin(acos(LEAST_FACING_COSINE)) long
    radius = float(least * np.hypot(1, 2 * np.sqrt(1 - LEAST_FACING_COSINE**2)))
    pairs: list[tuple[IntArray, IntArray, FloatArray]] = []
    for i, j in blocks_of_near_pairs(here, there, radius):
        across = points[j] - points[i]
        width = norm(across)
        least_along = LEAST_FACING_COSINE * width
        ahead = (dot(across, inward[i]) > least_along) & (dot(across, inward[j]) < -least_along)
        facing = np.flatnonzero(ahead & (width < (1 - 1e-9) * least))
        narrowest = facing[_narrowest(i[facing], width[facing])]
        pairs.append((i[narrowest], j[narrowest], width[narrowest]))
    i, j, width = map(np.concatenate, zip(*pairs, strict=True))
    i, j = np.minimum(i, j), np.maximum(i, j)
    once = _narrowest(i * len(points) + j, width)
    return i[once], j[once], width[once]


def _thinnest_of_each_group(middle: FloatArray, width: FloatArray, least: float) -> IntArray:
    """Return the indices of places narrower than all other places within `least` mm."""
    # a long narrow part has very many places, so only the narrowest place of each small cell is compared
    cells = (middle - middle.min(axis=0, initial=np.inf)) // (0.25 * least)
    row, column = cells.astype(np.int64).T  # both numbers together are the key of a cell
    kept = np.sort(_narrowest(row * 2**31 + column, width))
    order = kept[width[kept].argsort(kind="stable")]
    i, j = near_pairs(middle[order], middle[order], least)
    ranks = np.arange(order.size)
    thinnest, known = ranks.copy(), None  # for each place, rank of the narrowest place found nearby so far
    while known is None or not np.array_equal(thinnest, known):
        known = thinnest.copy()
        np.minimum.at(thinnest, i, known[j])
        thinnest = thinnest[thinnest]
    return np.asarray(order[thinnest == ranks])


def _narrowest(point: IntArray, width: FloatArray) -> IntArray:
    # return, for each different value of `point`, the index of its least width
    order = np.lexsort((width, point))
    return order[np.diff(point[order], prepend=-1) > 0]


@dataclass(frozen=True, eq=False)
class _Chords:
    """Midpoints and vectors (m, 2), mm, of chords with the material on the left, and the cut of each chord."""

    middle: FloatArray
    vector: FloatArray
    loop: IntArray

    @classmethod
    def of(cls, outlines: Sequence[Path], holes: Sequence[Path], flat: float) -> "_Chords":
        """Return the chords of loops, divided so that they deviate by at most `flat` mm.

        Chords of length 0 are left out.
        """
        lines = [anticlockwise(path.points(flat)) for path in (*outlines, *holes)]
        lines[len(outlines) :] = [line[::-1] for line in lines[len(outlines) :]]
        vectors = np.concatenate([np.roll(line, -1, axis=0) - line for line in lines])
        loop = np.arange(len(lines)).repeat([len(line) for line in lines])
        chords = cls(np.concatenate(lines) + vectors / 2, vectors, loop)
        return chords.at(np.flatnonzero(chords.length))

    def at(self, numbers: IntArray) -> "_Chords":
        # return the chords with these indices
        return _Chords(self.middle[numbers], self.vector[numbers], self.loop[numbers])

    @property
    def length(self) -> FloatArray:
        return norm(self.vector)

    @property
    def inward(self) -> FloatArray:
        # unit normals (m, 2) into the material
        return left_of(self.vector) / self.length[:, None]

    def divided(self, longest: float) -> "_Chords":
        # return the chords, divided into equal parts of at most `longest` mm
        parts = np.maximum(1, np.ceil(self.length / longest - 1e-9)).astype(np.int64)
        count = parts.repeat(parts)[:, None]
        whole = self.at(np.arange(parts.size).repeat(parts))
        place = (numbers_in_groups(parts)[:, None] + 0.5) / count - 0.5
        return replace(whole, middle=whole.middle + place * whole.vector, vector=whole.vector / count)

    def has_in_front(self, others: "_Chords", least: float) -> BoolArray:
        """Return True (m,) where the chord in the same row of `others` is within `least` mm across the material."""
        # both ends (2, m, 2) of the other chords, relative to the middles of these chords
        ends = others.middle - self.middle + np.array([-0.5, 0.5])[:, None, None] * others.vector
        normals = self.inward
        ahead, aside = dot(ends, normals), cross(ends, normals)
        reach = self.length / 2 + np.sqrt(1 - LEAST_FACING_COSINE**2) * least
        in_depth = (ahead.max(axis=0) > 0) & (ahead.min(axis=0) < least)
        return np.asarray(in_depth & (aside.max(axis=0) > -reach) & (aside.min(axis=0) < reach))


LARGER_THAN_STOCK = 2.0
"""Size, as a multiple of the length of the stock, above which a part is refused without a search for thin
places."""


@dataclass(frozen=True)
class Fault:
    """A reason why a part cannot be made.

    Attributes
    ----------
    part : str
        Name of the part, or "" for a strip without a label.
    what : str
        Description of the fault with its position.
    cure : str
        Sentence that suggests a change.
    changes : tuple of Change
        Suggested values of options.
    at : float, optional
        Position along the curve, mm.
    """

    part: str
    what: str
    cure: str
    changes: tuple[Change, ...] = ()
    at: float | None = None

    def __str__(self) -> str:
        return note("{fault}. {cure}", fault=self.what, cure=self.cure).at(strip=self.part)


def accept_faults(faults: Sequence[Fault], ignore_limits: bool) -> tuple[str, ...]:
    """Return the faults of a part as warnings. Without `ignore_limits`, raise FaultError for them."""
    if faults and not ignore_limits:
        changes = dict.fromkeys(change for fault in faults for change in fault.changes)
        places = [fault.at for fault in faults if fault.at is not None]
        # faults of a part with the same suggestion share a sentence
        by_cure: dict[tuple[str, str], list[str]] = {}
        for item in faults:
            by_cure.setdefault((item.part, item.cure), []).append(item.what)
        merged = (Fault(part, sentences(whats), cure) for (part, cure), whats in by_cure.items())
        raise FaultError(
            "{faults} To make the parts anyway, set {field}.",
            faults=sentences(map(str, merged), ". ", "."),
            field=FieldName("ignore_limits"),
            where={"at": places[0]} if places else {},
            changes=[*changes],
        )
    return tuple(note("Made anyway: {fault}", fault=str(fault), severity="warning") for fault in faults)


def find_strip_faults(
    strip: Strip, shop: FabricationLimits | None = None, *, noisy: bool = False
) -> tuple[Fault, ...]:
    """Return all faults that prevent a strip from being cut and handled.

    Set `noisy` for a curve through noisy measured points. The advice is then to smooth the curve.

    Examples
    --------
    >>> from elastica_cad.mechanics.rod import Rod
    >>> thin = Strip(Rod.straight(200, [1, 4, 1]), Sheet.named("birch-plywood-0.8"), max_width=6, label="A")
    >>> print(find_strip_faults(thin)[0])  # doctest: +ELLIPSIS
    A: only 1.5 mm wide in the tab at its end... (and 1 more place), but birch-plywood-0.8 needs at least 3 mm...
    """
    if strip.layout.size is not None:  # the section already limits thickness or diameter
        return ()
    shop = shop or FabricationLimits()
    name = strip.label
    joined = shop.lap is not None  # joined strips may be longer than the stock
    backing, style = strip.layout.backing, strip.style
    ligament = shop.ligament_for(strip.sheet)
    faults: list[Fault] = []
    length = strip.rod.length + sum(tab.length for tab in strip.ends)
    width = max(strip.width.extremes[1], *(tab.widest(0.0) for tab in strip.ends))
    for i, sheet in enumerate([strip.sheet] if backing is None else [strip.sheet, backing.sheet]):
        called = name if i == 0 else f"{name}, backing" if name else "backing"
        least, stock = shop.width_for(sheet), shop.stock_for(sheet)
        if i and isinstance(
            style, Laminated
        ):  # a backing need not be strong, because it is glued to the base
            least = min(least, style.least_backing)
        long = min(length, stock[0] if joined else np.inf)
        web = min(least, shop.bridge_for(sheet))
        if max(long, width) < LARGER_THAN_STOCK * stock[0] and not _is_obviously_wide(strip, least):
            faults += _thin_strip(called, strip, strip.layers[i], least, web, noisy=noisy)
        faults += size_faults(called, long, width, sheet, stock, style)
    if isinstance(style, Perforated) and style.least_ligament < ligament * (1 - SEEN_APART):
        what = note(
            "ligaments (material between holes) of {allowed} are allowed, but only ligaments at least "
            "{ligament} wide can be cut",
            allowed=Length(style.least_ligament),
            ligament=Length(ligament),
        )
        faults.append(Fault(name, what, note("Set wider ligaments, or fewer columns")))
    stock = shop.stock_for(strip.sheet)
    longest = min(strip.rod.length, stock[0] if joined else np.inf)
    slenderest = longest / min(strip.width.extremes[0], stock[1])
    if slenderest > LARGEST_SLENDERNESS:
        what = note(
            "{length} long and {width} wide: too slender to handle (more than {most:g} times as long as wide)",
            length=Length(strip.rod.length),
            width=Length(strip.width.extremes[0]),
            most=LARGEST_SLENDERNESS,
        )
        wider = _change_of_width(strip, slenderest / LARGEST_SLENDERNESS)
        faults.append(Fault(name, what, note("Make it wider, or split it"), wider))
    return tuple(faults)


def find_plate_faults(
    name: str,
    sheet: Sheet,
    outline: Path,
    holes: Sequence[Path],
    shop: FabricationLimits | None = None,
    called: Sequence[str] = (),
    drilled: Sequence[str] = (),
) -> tuple[Fault, ...]:
    """Return faults of a ring, base or rail: thin bridges between its cuts, and a size beyond the stock.

    `called` has the names of the slots, which are the first holes. `drilled` has the names of the last holes.
    """
    shop = limits_or_default(shop)
    least, stock = shop.bridge_for(sheet), shop.stock_for(sheet)
    length, width = np.ptp(outline.bounds, axis=0).tolist()
    far_larger = max(length, width) >= LARGER_THAN_STOCK * stock[0]
    places = () if far_larger else find_thin_places([outline], holes, least)
    others = len(holes) - len(called) - len(drilled)
    loops = (note("the edge"), *called, *(note("a hole") for _ in range(others)), *drilled)
    at_holes = [place for place in places if max(place.loops) > len(called) + others]
    between_slots = [place for place in places if 1 <= min(place.loops) <= max(place.loops) <= len(called)]
    at_edges = [place for place in places if place not in at_holes and place not in between_slots]
    return (
        *_faults_at(
            name, between_slots, least, sheet,
            note("Leave more room between the slots: use a larger ring or plate, or fewer or narrower strips"),
            loops,
        ),
        *_faults_at(
            name, at_edges, least, sheet, note("Use a wider border, or narrower strips"), loops
        ),
        *_faults_at(
            name, at_holes, least, sheet, note(
                "Use smaller holes, place them farther from each other and from the edges, or use a larger plate"
            ), loops,
            of_hole=True,
        ),
        *size_faults(name, length, width, sheet, stock),
    )  # fmt: skip


def find_slot_faults(name: str, slots: Sequence[tuple[str, float, float]]) -> tuple[Fault, ...]:
    """Return a fault if slots are too wide for their tabs. Each slot is (name, slot width, tab thickness), mm."""

    def widest(through: float) -> float:
        # a slot of 2.4 mm can hold a thin tab with glue on both sides; eight times its thickness lets a plate of
        # 3 mm hold a tab of 0.8 mm at 32 degrees
        return max(2.4, 8.0 * through)

    wide = [each for each in slots if each[1] > widest(each[2])]
    if not wide:
        return ()
    slot, width, through = max(wide, key=lambda each: each[1] / each[2])
    what = note(
        "the slot for {slot}{more} is {width} wide, but a tab {through} thick is held only by a slot "
        "of at most {widest}",
        slot=slot, more=and_more(wide), width=Length(width), through=Length(through),
        widest=Length(widest(through)),
    )  # fmt: skip
    cure = note(
        "Let the strips meet the plate more steeply, use a thinner plate, or hold the strips by end fixtures"
    )
    return (Fault(name, what, cure),)


def find_shoulder_faults(name: str, shoulders: Sequence[tuple[str, float, float]]) -> tuple[Fault, ...]:
    """Return faults of strips that would penetrate the plate beside their tabs.

    Each shoulder is (name of the strip, depth by which it enters the plate, strip thickness), mm.
    """
    return tuple(
        Fault(
            name,
            note(
                "beside the tab of {tab}, the strip would enter the plate by {depth}",
                tab=tab,
                depth=Length(depth),
            ),
            note("Make the tab as wide as the strip, or lower the plate by {depth}", depth=Length(depth)),
        )
        for tab, depth, thickness in shoulders
        if depth > thickness
    )


def _is_obviously_wide(strip: Strip, least: float) -> bool:
    """Return True if two nearly parallel long edges, `least` mm or more apart, are the only cuts."""
    layout, width = strip.layout, strip.width
    if strip.slots or element_cuts(strip.rod) or layout.backing is not None or layout.pattern is not None:
        return False
    if any(tab != tab.plain for tab in strip.ends):
        return False
    # no spline is steeper than its control polygon
    rises, runs = np.abs(np.diff(width.coefficients)), np.diff(width.greville)
    # at this slope of the width, each edge slopes by 26 degrees
    return min(width.extremes[0], strip.rod.length) >= least and bool((rises < 1.0 * runs).all())


def _thin_strip(
    name: str, strip: Strip, layer: Layer, least: float, web: float, *, noisy: bool
) -> Iterator[Fault]:
    """Yield faults of a layer of a strip: narrow necks, narrow tabs, and webs beside holes.

    `least` is the least width and `web` the least web, mm; `noisy` is True for a curve from noisy points.
    """
    # ligaments have another limit: see `find_strip_faults`
    holes = layer.holes if strip.layout.pattern is None else ()
    places = find_thin_places([layer.outline], holes, least)
    # necks of the outline (both cuts are loop 0), in the strip (`free`) or in a tab with its own width (`tabs`)
    free: list[ThinPlace] = []
    tabs: list[ThinPlace] = []
    for place in (place for place in places if place.loops == (0, 0)):
        slots = [slot for slot in strip.slots if abs(slot.at - place.x) < slot.width / 2 + place.width]
        if slots[1:]:
            apart = note(
                "Move the slots at {places} apart",
                places=Listed(map(Length, sorted(slot.at for slot in slots))),
            )
            yield from _faults_at(name, [place], least, layer.sheet, apart, strip=strip)
            continue
        of_tab = not 0 <= place.x <= strip.rod.length and strip.ends[int(place.x > 0)].width is not None
        (tabs if of_tab else free).append(place)
    if free:
        cure, changes = _suggestions_for_necks(strip, least / free[0].width, least, noisy)
        for fault in _faults_at(name, free, least, layer.sheet, cure, strip=strip):
            yield replace(fault, changes=changes, at=free[0].x)
    for place in tabs[:1]:
        wide, needed = map(Length, distinct_digits(place.width, least, ".3g"))
        what = note(
            "only {wide:g} wide {at}, but {sheet} needs at least {needed:g}",
            wide=wide, at=_place_on(strip, place), needed=needed, sheet=layer.sheet.name,
        )  # fmt: skip
        yield Fault(name, what, note("Make the tab wider"))
    webs = [place for place in places if place.loops != (0, 0) and place.width < web * (1 - SEEN_APART)]
    narrowest = {max(place.loops): place for place in reversed(webs)}  # a hole is named once
    for place in [place for place in webs if place in narrowest.values()]:
        yield _thin_web(name, place, strip, layer, web)


def _suggestions_for_necks(
    strip: Strip, times: float, least: float, noisy: bool
) -> tuple[str, tuple[Change, ...]]:
    """Return the remedy for narrow necks, and the changes to try.

    The necks need `times` their width.
    """
    wider, nearest = _change_of_width(strip, times), change_to_nearest(strip.rod)
    field = outline_field(strip.style)
    # a strip that is wider than long is no remedy, and its places take long to compare
    too_thin = wider and (
        times * strip.width.extremes[1] > strip.rod.length
        or find_thin_places([strip.outline.transformed(np.diag([1.0, 1.01 * times, 1.0]))], (), least)
    )
    judged = strip.strain_verdict
    if too_thin or not (judged.allowed or judged.unloaded):
        wider = ()  # a wider strip would still be overstrained or have tips that are too thin
        cure = note(
            "Let the program change the curve so that the widths differ less"
            if nearest
            else "Move the rails, pins, ties or loads of the strip"
        )
    elif not wider:
        cure = note(
            "Make the strip wider ({field}), or let the program change the curve so that the widths differ less"
            if nearest
            else "Make the strip wider ({field}), or move its rails, pins, ties or loads",
            field=field,
        )
    else:
        cure = note(
            "Make the strip {width:g} wide or wider ({field}), or let the program change the curve so that "
            "the widths differ less"
            if nearest
            else "Make the strip {width:g} wide or wider ({field}), or move its rails, pins, ties or loads",
            field=field,
            width=Length(wider[0].value),
        )
    smoothing = note("or smooth the points of the curve more ({field})", field=FieldName("smooth"))
    return sentences([cure, *([smoothing] if noisy else [])], ", "), (*wider, *nearest)


def change_to_nearest(rod: Rod) -> tuple[Change, ...]:
    """Return the change to the nearest curve.

    The result is empty for a rod with rails, pins, ties or masses, because `nearest_rod` does not support them.
    """
    return () if rod.acting or (rod.weight is not None and rod.weight.masses) else (Change("nearest", True),)


def _place_on(strip: Strip, place: ThinPlace) -> str:
    """Return where a thin place is: in a tab, or at an arc length."""
    length = strip.rod.length
    if place.x < 0:
        return note("in the tab at its start, {into} from the bent part", into=Length(-place.x))
    if place.x > length:
        return note("in the tab at its end, {into} from the bent part", into=Length(place.x - length))
    return note("at {s} from the start of the curve", s=Length(place.x))


def _thin_web(name: str, place: ThinPlace, strip: Strip, layer: Layer, least: float) -> Fault:
    """Return the fault of a hole too near to the edge or to another hole."""
    wide, needed = map(Length, distinct_digits(place.width, least, ".3g"))
    between_holes = 0 not in place.loops
    what = note(
        "only {wide:g} of material between two holes {at}, but {sheet} needs at least {needed:g}"
        if between_holes
        else "only {wide:g} of material between a hole and the edge {at}, but {sheet} needs at least {needed:g}",
        wide=wide, at=_place_on(strip, place), needed=needed, sheet=layer.sheet.name,
    )  # fmt: skip
    shift = rounded_up(least - place.width, 2)
    if between_holes:
        cure = note("Move the holes farther apart by {shift}, or make them smaller", shift=Length(shift))
        return Fault(name, what, cure)
    hole = layer.holes[max(place.loops) - 1]
    others = (layer.outline, *(other for other in layer.holes if other is not hole))
    edges = [segment for path in others for segment in path.segments]
    center, radius = hole.bounds.mean(axis=0), float(np.ptp(hole.bounds[:, 0])) / 2
    away = center - (place.x, place.y)
    moved = center + shift * away / norm(away)
    room = rounded_down(2 * (_distance(center, edges) - least), 3)
    smaller = note("make the hole at most {most} in diameter", most=Length(room))
    enough = radius + least
    k, into = (0, -center[0]) if place.x < 0 else (1, center[0] - strip.rod.length)
    width, length = rounded_up(2 * (abs(center[1]) + enough), 3), rounded_up(into + enough, 3)
    if _distance(moved, edges) >= enough - SEEN_APART * least:
        larger = note("Move the hole {shift} away from the edge", shift=Length(shift))
    elif into < 0:
        larger = note("Make the strip wider there")
    elif length <= strip.ends[k].length:
        larger = note("Make the tab {width} wide or wider", width=Length(width))
    else:
        width = max(width, strip.ends[k].width or strip.end_widths[k])
        larger = note(
            "Make the tab {width} wide and {length} long", width=Length(width), length=Length(length)
        )
    return Fault(name, what, sentences([larger, smaller] if room > 0 else [larger], note(", or ")))


def _change_of_width(strip: Strip, times: float) -> tuple[Change, ...]:
    # return the change to `times` the largest width, or none if `max_width` does not determine the widths
    if not isinstance(strip.style, Plain) or strip.rod.bending_stiffness is not None:
        return ()
    return (Change("max_width", rounded_up(times * strip.width.extremes[1], 3)),)


def _faults_at(
    name: str,
    places: Sequence[ThinPlace],
    least: float,
    sheet: Sheet,
    cure: str,
    loops: Sequence[str] = (),
    *,
    of_hole: bool = False,
    strip: Strip | None = None,
) -> Iterator[Fault]:
    """Yield a fault for each thin place.

    `loops` are the names of the loops; those of holes have their position.
    """
    # list equal widths once, such as those between the slots around a ring
    alike: dict[str, list[ThinPlace]] = {}
    for place in places:
        alike.setdefault(f"{place.width:.3g}", []).append(place)
    for place, *others in alike.values():
        rest = len(others)
        more = note(" (and {rest} more places)", rest=rest) if rest > 1 else note(" (and 1 more place)")
        at = (
            _place_on(strip, place)
            if strip is not None and abs(place.y) < 0.005
            else note("at {place} of the flat part", place=Point(np.round((place.x, place.y), 3)))
        )
        wide, needed = map(Length, distinct_digits(place.width, least, ".3g"))
        one, other = sorted(place.loops)
        between = (
            ()
            if not loops
            else loops[one]
            if one == other or loops[one] == "a hole"
            else both_names(loops[one], loops[other])
        )
        what = note(
            "only {wide:g} between {loops}{more}, but {sheet} needs at least {needed:g}" if of_hole else
            "only {wide:g} between {loops} {at}{more}, but {sheet} needs at least {needed:g}" if loops else
            "only {wide:g} wide {at}{more}, but {sheet} needs at least {needed:g}",
            wide=wide, loops=between, at=at, more=more if rest else "", needed=needed, sheet=sheet.name,
        )  # fmt: skip
        yield Fault(name, what, cure)


def size_faults(
    name: str, length: float, width: float, sheet: Sheet, stock: tuple[float, float], style: object = PLAIN
) -> Iterator[Fault]:
    """Yield the fault of a strip larger than the stock."""
    long, short = max(length, width), min(length, width)
    if long > stock[0] * (1 + SEEN_APART) or short > stock[1] * (1 + SEEN_APART):
        (its_long, long_side), (its_short, short_side) = (
            distinct_digits(size, side, ".4g") for size, side in zip((long, short), stock, strict=True)
        )
        what = note(
            "{long:g} x {short:g} is larger than the stock of {stock_long:g} x {stock_short:g} in {sheet}",
            long=BareLength(its_long), short=Length(its_short), sheet=sheet.name,
            stock_long=BareLength(long_side), stock_short=Length(short_side),
        )  # fmt: skip
        # the width is too large, not the length of the curve
        if width > length or (width > stock[1] and length <= stock[0]):
            field = outline_field(style)
            # a strip that is only twice as long as wide bends as a plate
            fits = Change(field, rounded_down(min(stock[1], length / 4.0), 2))
            cure = note("Set a smaller {field}, or a larger stock size", field=field)
            yield Fault(name, what, cure, (fits,))
        else:
            cure = note(
                "Set a larger stock size, cut the strip in pieces that are joined by plates ({field}), or make the "
                "curve smaller",
                field=FieldName("shop.lap"),
            )
            # from about 12 thicknesses on, the glue joint is as strong as the sheet
            yield Fault(name, what, cure, (Change("lap", float(round(20 * sheet.thickness))),))
