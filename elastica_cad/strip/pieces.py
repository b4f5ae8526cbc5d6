"""Parts to be cut with their quantities, and detection of equal strips."""

from bisect import bisect_left, bisect_right, insort
from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, fields, replace
from itertools import count
from operator import itemgetter

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._text import file_word
from elastica_cad._types import FloatArray
from elastica_cad._values import is_whole, require_record, value_key
from elastica_cad.errors import InputError
from elastica_cad.geometry.path import Path, distances
from elastica_cad.geometry.plane_points import box_around
from elastica_cad.mechanics.cross_sections import RoundLaw
from elastica_cad.mechanics.sheets import ROD_KIND, Sheet
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER, MARK, SAME_MM, Drawing
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.lettering import Text
from elastica_cad.strip.slots import Cuts, Slot, end_numbers
from elastica_cad.strip.strip import Placed, Strip, strip_names

SIZE_TOLERANCE = 1e-6
"""Largest difference between equal parts, as a fraction of the length of the outline.

The parts are compared by length, bounding box and square root of the area."""

FLIPS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Signs of x and y of a part that is unchanged, turned over about either axis, or rotated by 180 degrees."""


def cut_key(strip: Strip) -> Hashable:
    """Return a key that is equal for strips with the same geometry and material.

    Labels and names of inserted parts are ignored.
    """
    # copies of a slot differ by rounding errors
    slots = [
        (slot.side, slot.relief, slot.depth is None, *np.round(_sizes(slot), 6).tolist())
        for slot in strip.slots
    ]
    values = [
        getattr(strip, field.name)
        for field in fields(Strip)
        if field.name not in ("label", "engrave", "slots", "joints")
    ]
    key: Hashable = value_key((values, slots))
    return key


def _sizes(slot: Slot) -> FloatArray:
    # return all numbers that determine the shape of a slot
    paths = [part.ravel() for part in (slot.path, slot.widths) if part is not None]
    return np.concatenate([[slot.at, slot.width, slot.depth or 0.0, slot.lean], *paths])


@dataclass(frozen=True, eq=False)
class EqualStrips:
    """Equal strips of a model, which are cut from the same drawing.

    Attributes
    ----------
    strip : Strip
        The first of the equal strips.
    name : str
        Label of this strip, or its index in the model counted from 1, as in "strip 3".
    members : tuple of int
        Indices of the strips in the model.
    shape : int
        Index of the shape. Groups with the same index differ only in their engraving.
    """

    strip: Strip
    name: str
    members: tuple[int, ...]
    shape: int

    @property
    def count(self) -> int:
        """Number of equal strips."""
        return len(self.members)


def group_equal_strips(placed: Sequence[Placed]) -> tuple[EqualStrips, ...]:
    """Return groups of equal strips, in the order of their first members.

    Strips are equal if their sheets, shapes (see `FlatShape.equals`), labels and engravings are equal, including
    the names beside slots.
    """
    shapes = DistinctShapes()
    groups: dict[tuple[int, Hashable], list[int]] = {}
    known: dict[int, list[int]] = {}  # group by the id of a strip, so that each strip is compared once
    for index, strip in enumerate(item.strip for item in placed):
        if id(strip) not in known:
            marks = strip.label, strip.engraved, *strip.joints, *sorted(slot.mate for slot in strip.slots)
            known[id(strip)] = groups.setdefault((shapes.number(FlatShape.of(strip)), marks), [])
        known[id(strip)].append(index)
    names = strip_names(placed)
    return tuple(
        EqualStrips(placed[members[0]].strip, names[members[0]], tuple(members), shape)
        for (shape, _), members in groups.items()
    )


def _nearly_equal(a: FloatArray | None, b: FloatArray | None, room: float) -> bool:
    if a is None or b is None:
        return a is b
    return bool(np.abs(a - b).max() < room)


@dataclass(frozen=True, eq=False)
class FlatShape:
    """Shape of a part for the detection of equal parts.

    `layers` has the cut loops of the part. `size` (k,) is the thickness or diameter, mm, of a planed or
    turned part at evenly spaced stations. `bent` (k,) is the natural curvature of a pre-bent strip times its
    length, rad. For other parts, `size` and `bent` are None.
    """

    layers: tuple[Layer, ...]
    size: FloatArray | None = None
    bent: FloatArray | None = None

    @classmethod
    def of(cls, strip: Strip) -> "FlatShape":
        """Return the shape of a strip."""
        rod, size = strip.rod, strip.layout.worked_size
        s = np.linspace(0.0, rod.length, 65)
        bent = rod.length * rod.rest_at(s) if np.any(rod.natural_curvature) else None
        return cls(strip.layers, None if size is None else size(s), bent)

    def equals(self, other: "FlatShape") -> bool:
        """Return True if the parts have the same sheets and cut loops. Engraving has no effect."""
        # sizes may differ by 1e-3 mm, and natural curvatures times the length by 1e-4 rad
        if not (_nearly_equal(self.size, other.size, 1e-3) and _nearly_equal(self.bent, other.bent, 1e-4)):
            return False
        if len(self.layers) != len(other.layers):
            return False
        pairs = [*zip(self.layers, other.layers, strict=True)]
        if any(p.sheet != q.sheet or len(p.holes) != len(q.holes) for p, q in pairs):
            return False
        if all((p.outline, *p.holes) == (q.outline, *q.holes) for p, q in pairs):
            return True
        if np.abs(self.size_of_loops - other.size_of_loops).max() > SIZE_TOLERANCE * self.size_of_loops[0]:
            return False
        # turning a pre-bent strip reverses its curvature or the order of its ends
        return any(self._covers(other, signs) for signs in (FLIPS if self.bent is None else FLIPS[:1]))

    @cached_property
    def size_of_loops(self) -> FloatArray:
        """Length and bounding box of the outline, and square roots of layer areas; equal for equal parts."""
        layers = self.layers
        width, height = np.diff(layers[0].outline.bounds, axis=0)[0]
        return np.array([layers[0].outline.length, width, height, *(np.sqrt(layer.area) for layer in layers)])

    def _covers(self, other: "FlatShape", signs: tuple[int, int]) -> bool:
        """Return True if the loops coincide after `other` is mirrored by `signs` and moved onto this shape.

        The shapes have equal sizes and counts of loops (see `equals`), so samples of one of them suffice.
        """
        middles = [shape.layers[0].outline.bounds.mean(axis=0) for shape in (self, other)]
        shift = middles[0] - signs * middles[1]
        for layer, others in zip(self.layers, other.layers, strict=True):
            if not _along(layer.outline, _samples(others.outline) * signs + shift):
                return False
            for hole in others.holes:
                points, middle = _samples(hole) * signs + shift, hole.bounds.mean(axis=0) * signs + shift
                if not any(
                    np.abs(candidate.bounds.mean(axis=0) - middle).max() < 10 * SAME_MM
                    and _along(candidate, points)
                    for candidate in layer.holes
                ):
                    return False
        return True


class DistinctShapes:
    """Different shapes with indices from 0, sorted by length for fast comparison."""

    def __init__(self) -> None:
        self._found: list[tuple[float, int, FlatShape]] = []  # length of the outline, mm, index, and shape

    def number(self, shape: FlatShape) -> int:
        """Return the index of an equal shape, or the next index for a new shape."""
        length = float(shape.size_of_loops[0])
        low, high = ((length * (1 + side * 2 * SIZE_TOLERANCE),) for side in (-1, 1))
        near = self._found[bisect_left(self._found, low) : bisect_right(self._found, high)]
        for _, number, other in sorted(near, key=itemgetter(1)):
            if other.equals(shape):
                return number
        insort(self._found, (length, len(self._found), shape))
        return len(self._found) - 1


def _samples(path: Path) -> FloatArray:
    # return six points (n, 2) of each segment
    return np.concatenate([segment.at(np.linspace(0.0, 1.0, 6, endpoint=False)) for segment in path.segments])


def _along(path: Path, points: FloatArray) -> bool:
    """Return True if all points are on the path."""
    remaining = points
    for segment in path.segments:
        low, high = segment.bounds
        inside = np.flatnonzero(np.all((remaining > low - SAME_MM) & (remaining < high + SAME_MM), axis=1))
        remaining = np.delete(remaining, inside[distances(segment, remaining[inside]) <= SAME_MM], axis=0)
    return not remaining.size


@dataclass(frozen=True, eq=False)
class Piece:
    """Flat part to be cut.

    Parameters
    ----------
    name : str
    drawing : Drawing
        Drawing with at least one closed outer cut.
    sheet : Sheet
        Sheet of the part. `sheet.grain` is the direction of its grain relative to the x axis of the drawing.
    count : int
        Number of copies.
    worked : float, optional
        Mass of a planed or turned piece, g; by default the mass of the flat part.
    number : str
        Number that is engraved in place of the name, or "" if there is none.

    Examples
    --------
    >>> from elastica_cad.strip.drawing import LayeredPath
    >>> from elastica_cad.geometry.path import Path
    >>> plate = Drawing("plate", [LayeredPath("CUT_OUTER", Path.rectangle(40, 10))])
    >>> Piece("plate", plate, Sheet.named("birch-plywood-0.8"), 2).file_stem
    'plate_birch-plywood-0.8_0.8mm_x2'
    """

    name: str
    drawing: Drawing
    sheet: Sheet
    count: int = 1
    worked: float | None = None
    number: str = ""

    def __post_init__(self) -> None:
        require_record(self.drawing, Drawing, "the drawing of a piece", "a Drawing")
        if not (is_whole(self.count) and self.count >= 1):
            raise InputError(
                f"{self.name}: the number of copies is {self.count!r}; give a whole number, 1 or more"
            )
        if not any(path.closed for path in self.drawing.on(CUT_OUTER)):
            raise InputError(f"{self.name}: there is no closed outer cut; close the outline of the part")

    @property
    def called(self) -> str:
        """Name, after the number that is engraved in its place, as in "1 = Анна"."""
        return f"{self.number} = {self.name}" if self.number else self.name

    @property
    def file_stem(self) -> str:
        """File name without suffix: part, material, thickness and quantity."""
        words = (self.name, self.sheet.name, f"{self.sheet.thickness:g}mm", f"x{self.count}")
        return "_".join(map(file_word, words))

    @property
    def is_rod(self) -> bool:
        """True if the piece is sawn from a rod, not cut from a sheet."""
        return self.sheet.kind == ROD_KIND

    @cached_property
    def bounds(self) -> FloatArray:
        """Exact bounding box [[x_min, y_min], [x_max, y_max]] of the outer cuts, mm."""
        return box_around(np.array([path.bounds for path in self.drawing.on(CUT_OUTER)]))

    @property
    def size(self) -> tuple[float, float]:
        """Size of the bounding box along x and y, mm."""
        x, y = (self.bounds[1] - self.bounds[0]).tolist()
        return x, y

    @cached_property
    def cut_length(self) -> float:
        """Length of all cuts of a piece, mm."""
        return sum(path.length for path in self.drawing.on(CUT_INNER, CUT_OUTER))

    @cached_property
    def area(self) -> float:
        """Area of a piece, mm2."""
        outer, inner = (
            sum(abs(path.area) for path in self.drawing.on(layer) if path.closed)
            for layer in (CUT_OUTER, CUT_INNER)
        )
        return outer - inner

    @property
    def mass(self) -> float:
        """Mass of a finished piece, g."""
        if self.worked is not None:
            return self.worked
        return self.area * self.sheet.thickness * self.sheet.density * 1e-6


def count_pieces(pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """Return one piece for each name, with the total quantity. Pieces with the same name are equal."""
    first: dict[str, Piece] = {}
    for piece in pieces:
        known = first.get(piece.name)
        first[piece.name] = piece if known is None else replace(known, count=known.count + piece.count)
    return tuple(first.values())


def strip_pieces(parts: Sequence[EqualStrips], *, numbered: bool = False) -> tuple[Piece, ...]:
    """Return a piece with its quantity for each layer of each group of equal strips.

    Numbers are appended to labels that occur more than once. With `numbered`, the ends are engraved with 1 and 2,
    like the slots that hold the ends.
    """
    pieces: list[Piece] = []
    taken = {part.name for part in parts}
    used: Counter[str] = Counter()
    for part in parts:
        name, strip = part.name, part.strip
        used[name] += 1
        if used[name] > 1:
            name = next(f"{name}-{n}" for n in count(used[name]) if f"{name}-{n}" not in taken)
            taken.add(name)
            engrave = f"{strip.engraved}{name.removeprefix(part.name)}" if strip.number else strip.engrave
            strip = replace(strip, label=name, engrave=engrave)
        for i, (drawing, layer) in enumerate(zip(strip.drawings(), strip.layers, strict=True)):
            called = layer.called(name)
            marks: tuple[Text, ...] = ()
            if numbered and i == 0:
                cuts = Cuts(layer.holes, drawing.on(MARK), rim=layer.rim)
                marks = end_numbers(strip.width, cuts, drawing.texts)
            texts = (*drawing.texts, *marks)
            sheet, worked = _stock(strip, layer)
            drawn = replace(drawing, name=called, texts=texts)
            pieces.append(Piece(called, drawn, sheet, part.count, worked, strip.number))
    return tuple(pieces)


def _stock(strip: Strip, layer: Layer) -> tuple[Sheet, float | None]:
    """Return the sheet of a layer and, for a planed or turned strip, its mass, g.

    A planed strip is cut from a sheet of its largest thickness; a turned strip is a rod.
    """
    size = strip.layout.worked_size
    if size is None:
        return layer.sheet, None
    sheet = layer.sheet.with_thickness(float(f"{size.extremes[1]:.4g}"))
    return (
        replace(sheet, kind=ROD_KIND) if isinstance(strip.layout.section, RoundLaw) else sheet
    ), strip.mass
