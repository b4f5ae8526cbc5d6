"""Pieces: what is cut from which sheet and how often; strips and pieces that are the same part."""

import re
from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import count

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_whole, require_record, value_key
from elastica_cad.errors import InputError
from elastica_cad.geometry.path import Path, distances
from elastica_cad.geometry.plane_points import box_around
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER, MARK, SAME_MM, Drawing
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.lettering import Text
from elastica_cad.strip.slots import Cuts, Slot, end_numbers
from elastica_cad.strip.strip import Placed, Strip, strip_names

SAME_SIZE_MM, SIZE_STATIONS = 1e-3, 65
"""Difference in thickness or diameter, mm, up to which strips are the same, and number of places that are
compared."""

SAME_BEND_RAD = 1e-4
"""Difference in angle over the length of a strip, rad, up to which two natural shapes are the same."""

SLOT_DIGITS = 6
"""Decimals of mm to which sizes of slots are compared, since those of copies differ by rounding."""

SAMPLES = 6
"""Points of a segment at which loops are compared."""

WAYS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Signs of x and y of the four positions: as it is, turned over along the strip, across it, and rotated."""


def cut_key(strip: Strip) -> Hashable:
    """Key of strips that are made and cut alike, whatever their labels and the names of their mates."""
    slots = [
        (slot.side, slot.relief, slot.depth is None, *np.round(_sizes(slot), SLOT_DIGITS).tolist())
        for slot in strip.slots
    ]
    own = [getattr(strip, one.name) for one in fields(Strip) if one.name not in ("label", "engrave", "slots")]
    key: Hashable = value_key((own, slots))
    return key


def _sizes(slot: Slot) -> FloatArray:
    """All sizes of a slot, mm; its lean in rad."""
    paths = [np.ravel(part) for part in (slot.path, slot.widths) if part is not None]
    return np.concatenate([[slot.at, slot.width, slot.depth or 0.0, slot.lean], *paths])


@dataclass(frozen=True, eq=False)
class EqualStrips:
    """Equal strips of a model: one part, cut as often as there are `members`.

    Attributes
    ----------
    strip : Strip
        The first of them, whose drawing is cut.
    name : str
        Its label, or "strip 3" after its place in the model.
    members : tuple of int
        Places in the model.
    """

    strip: Strip
    name: str
    members: tuple[int, ...]

    @property
    def count(self) -> int:
        """Number of equal strips."""
        return len(self.members)


def group_equal_strips(placed: Sequence[Placed]) -> tuple[EqualStrips, ...]:
    """The strips grouped by the part that is cut for them, in order of first appearance.

    Strips are equal where sheet, label and all cut loops are, after turning the part about or over.
    """
    found: list[tuple[FlatShape, Strip, list[int]]] = []
    known: dict[int, list[int]] = {}  # one strip in several places need not be compared again
    for index, strip in enumerate(one.strip for one in placed):
        if id(strip) not in known:
            shape = FlatShape.of(strip)
            alike = next(
                (
                    members
                    for first, other, members in found
                    if _same_marks(other, strip) and first.equals(shape)
                ),
                None,
            )
            if alike is None:
                alike = []
                found.append((shape, strip, alike))
            known[id(strip)] = alike
        known[id(strip)].append(index)
    names = strip_names(placed)
    return tuple(EqualStrips(strip, names[members[0]], tuple(members)) for _, strip, members in found)


def count_shapes(parts: Sequence[EqualStrips]) -> int:
    """Number of different shapes of these parts, whatever is engraved on them."""
    found: list[FlatShape] = []
    for part in parts:
        shape = FlatShape.of(part.strip)
        if not any(shape.equals(other) for other in found):
            found.append(shape)
    return len(found)


def _same_marks(a: Strip, b: Strip) -> bool:
    """Whether the same is engraved on both."""
    mates = [sorted(slot.mate for slot in strip.slots) for strip in (a, b)]
    return (a.label, a.engraved) == (b.label, b.engraved) and mates[0] == mates[1]


def _near(a: FloatArray | None, b: FloatArray | None, room: float) -> bool:
    """Whether both are None, or rows of numbers that differ by less than `room`."""
    if a is None or b is None:
        return a is b
    return bool(np.abs(a - b).max() < room)


@dataclass(frozen=True, eq=False)
class FlatShape:
    """The cut loops of a part, of each of its layers, ready to be compared with many others.

    `size` (k,) is the thickness or diameter at even steps along it of one that is planed or turned, and `bent` (k,)
    is how much the blank is bent beforehand there, rad over its length; None for the others.
    """

    layers: tuple[Layer, ...]
    size: FloatArray | None = None
    bent: FloatArray | None = None

    @classmethod
    def of(cls, strip: Strip) -> "FlatShape":
        """Return the flat shape of a strip."""
        rod, size = strip.rod, strip.layout.worked_size
        s = np.linspace(0.0, rod.length, SIZE_STATIONS)
        bent = rod.length * rod.rest_at(s) if np.any(rod.natural_curvature) else None
        return cls(strip.layers, None if size is None else size(s), bent)

    def equals(self, other: "FlatShape") -> bool:
        """Would one part serve for both, but for what is engraved? Sheets and all loops must be the same."""
        if not (_near(self.size, other.size, SAME_SIZE_MM) and _near(self.bent, other.bent, SAME_BEND_RAD)):
            return False
        if len(self.layers) != len(other.layers) or any(
            p.sheet != q.sheet or len(p.holes) != len(q.holes)
            for p, q in zip(self.layers, other.layers, strict=True)
        ):
            return False
        if all(
            (p.outline, *p.holes) == (q.outline, *q.holes)
            for p, q in zip(self.layers, other.layers, strict=True)
        ):
            return True  # strips that are cut alike share their loops
        if np.abs(self._size - other._size).max() > SAME_MM * self._size[0]:
            return False
        ways = WAYS if self.bent is None else WAYS[:1]  # a bent blank that is turned is bent another way
        return any(self._covers(other, way) for way in ways)

    @cached_property
    def _size(self) -> FloatArray:
        """Length, box and areas of the loops: cheap to compare."""
        layers = self.layers
        width, height = np.diff(layers[0].outline.bounds, axis=0)[0]
        return np.array([layers[0].outline.length, width, height, *(np.sqrt(layer.area) for layer in layers)])

    def _covers(self, other: "FlatShape", way: tuple[int, int]) -> bool:
        """Whether the other's loops, in this position and centred on this one, coincide with these."""
        middles = [shape.layers[0].outline.bounds.mean(axis=0) for shape in (self, other)]
        shift = middles[0] - way * middles[1]
        for own, others in zip(self.layers, other.layers, strict=True):
            if not _along(own.outline, _samples(others.outline) * way + shift):
                return False
            for hole in others.holes:
                points, middle = _samples(hole) * way + shift, hole.bounds.mean(axis=0) * way + shift
                near = [
                    one for one in own.holes if np.abs(one.bounds.mean(axis=0) - middle).max() < 10 * SAME_MM
                ]
                if not any(_along(one, points) for one in near):
                    return False
        return True


def _samples(path: Path) -> FloatArray:
    """Points along every segment of a path."""
    return np.concatenate([segment.at(np.linspace(0.0, 1.0, SAMPLES + 1)[:-1]) for segment in path.segments])


def _along(path: Path, points: FloatArray) -> bool:
    """Whether points are within `SAME_MM` of a path."""
    left = points
    for segment in path.segments:
        low, high = segment.bounds
        inside = np.flatnonzero(np.all((left > low - SAME_MM) & (left < high + SAME_MM), axis=1))
        left = np.delete(left, inside[distances(segment, left[inside]) <= SAME_MM], axis=0)
    return not left.size


@dataclass(frozen=True, eq=False)
class Piece:
    """A flat part to be cut.

    Parameters
    ----------
    name : str
    drawing : Drawing
        One closed outer cut or more.
    sheet : Sheet
        What it is cut from; where the sheet has a grain, the drawing's x runs along or across it as `sheet.grain`
        says.
    count : int
        How many are cut.
    worked : float, optional
        What one weighs, g, when it has been planed or turned; what is cut of the sheet unless told.

    Raises
    ------
    InputError
        Nothing to cut out, or a count below 1.

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

    def __post_init__(self) -> None:
        require_record(self.drawing, Drawing, "the drawing of a piece", "a Drawing")
        if not (is_whole(self.count) and self.count >= 1):
            raise InputError(f"{self.name}: cut {self.count!r} times; the count must be 1 or more")
        if not any(path.closed for path in self.drawing.on(CUT_OUTER)):
            raise InputError(f"{self.name}: there is no closed outer cut, so nothing to cut out")

    @property
    def file_stem(self) -> str:
        """File name without suffix: part, material, thickness and quantity."""
        words = (self.name, self.sheet.name, f"{self.sheet.thickness:g}mm", f"x{self.count}")
        return "_".join(map(file_word, words))

    @cached_property
    def bounds(self) -> FloatArray:
        """[[x_min, y_min], [x_max, y_max]] of the outer cuts, mm, exact; all else lies inside."""
        return box_around(np.array([path.bounds for path in self.drawing.on(CUT_OUTER)]))

    @property
    def size(self) -> tuple[float, float]:
        """Length along x and height along y, mm."""
        x, y = self.bounds[1] - self.bounds[0]
        return float(x), float(y)

    @cached_property
    def cut_length(self) -> float:
        """Length of all cuts of one piece, mm."""
        return sum(path.length for path in self.drawing.on(CUT_INNER, CUT_OUTER))

    @cached_property
    def area(self) -> float:
        """Area of one piece, mm2."""
        outer, inner = (
            sum(abs(path.area) for path in self.drawing.on(layer) if path.closed)
            for layer in (CUT_OUTER, CUT_INNER)
        )
        return outer - inner

    @property
    def mass(self) -> float:
        """Mass of one piece as it is used, g."""
        if self.worked is not None:
            return self.worked
        return self.area * self.sheet.thickness * self.sheet.density * 1e-6


LONGEST_WORD = 60
"""Characters of a label that go into a file name: file systems allow 255 bytes in all."""

_DEVICE = re.compile(r"^(con|prn|aux|nul|(?:com|lpt)[0-9¹²³])(?=\.|$)", re.IGNORECASE)  # of Windows


def file_word(text: str) -> str:
    """The text as it may stand in a file name on any system.

    Examples
    --------
    >>> file_word("P 1/2: top")
    'P-1-2-top'
    >>> file_word("con.txt")  # a device of Windows
    'con_.txt'
    """
    word = re.sub(r"[^\w.-]+", "-", text)[:LONGEST_WORD].strip("-.") or "part"
    return _DEVICE.sub(r"\1_", word)


def distinct(names: Iterable[str]) -> list[str]:
    """Names, with a number behind those that came before; file systems may not tell capitals from small letters.

    Examples
    --------
    >>> distinct(["A", "B", "a"])
    ['A', 'B', 'a-2']
    """
    names = list(names)
    first = {name.casefold(): i for i, name in reversed(list(enumerate(names)))}
    taken, found = set(first), []
    for i, name in enumerate(names):
        number, told = 1, name
        while first.get(name.casefold()) != i and told.casefold() in taken:
            number += 1
            told = f"{name}-{number}"
        taken.add(told.casefold())
        found.append(told)
    return found


def strip_pieces(parts: Sequence[EqualStrips], *, numbered: bool = False) -> tuple[Piece, ...]:
    """Return each group of equal strips as a piece with its count; each layer of a laminate is a piece.

    Different parts with the same label get a number behind it, on the part and in its name. With `numbered` ends
    are engraved 1 and 2, as the slots that hold them are.
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
            strip = replace(strip, label=name)
        for i, (drawing, layer) in enumerate(zip(strip.drawings(), strip.layers, strict=True)):
            called = layer.called(name)
            marks: tuple[Text, ...] = ()
            if numbered and i == 0:
                cuts = Cuts(layer.holes, drawing.on(MARK), rim=layer.rim)
                marks = end_numbers(strip.width, cuts, drawing.texts)
            texts = (*drawing.texts, *marks)
            sheet, worked = _blank(strip, layer)
            drawn = replace(drawing, name=called, texts=texts)
            pieces.append(Piece(called, drawn, sheet, part.count, worked))
    return tuple(pieces)


def _blank(strip: Strip, layer: Layer) -> tuple[Sheet, float | None]:
    """Sheet from which a layer is cut; one that is planed or turned starts at its largest thickness and has the
    mass given, g."""
    size = strip.layout.worked_size
    if size is None:
        return layer.sheet, None
    return layer.sheet.with_thickness(float(f"{size.extremes[1]:.4g}")), strip.mass
