"""Pieces: what is cut from which sheet, and how often."""

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import count

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_whole, require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import CUT_INNER, CUT_OUTER, MARK, Drawing
from elastica_cad.fabrication.drawings.lettering import Text
from elastica_cad.fabrication.sheets.equal_strips import EqualStrips
from elastica_cad.fabrication.slots.marks import Cuts, end_numbers
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.boxes import box_around
from elastica_cad.geometry.paths.many_segments import areas, total_length
from elastica_cad.mechanics.material.sheet import Sheet


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
    >>> from elastica_cad.fabrication.drawings.drawing import LayeredPath
    >>> from elastica_cad.geometry.paths.path import Path
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
        return total_length(self.drawing.on(CUT_INNER, CUT_OUTER))

    @cached_property
    def area(self) -> float:
        """Of one piece, mm2."""
        outer, inner = (
            areas([path for path in self.drawing.on(layer) if path.closed])
            for layer in (CUT_OUTER, CUT_INNER)
        )
        return float(np.abs(outer).sum() - np.abs(inner).sum())

    @property
    def mass(self) -> float:
        """Of one piece as it is used, g."""
        if self.worked is not None:
            return self.worked
        return self.area * self.sheet.thickness * self.sheet.density * 1e-6


LONGEST_WORD = 60
"""Signs of a label that go into a file name: file systems take 255 bytes in all."""

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
    """Each group of equal strips as a piece with its count; each layer of a laminate is one.

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
                cuts = Cuts(layer.holes, drawing.on(MARK), outline=layer.outline)
                marks = end_numbers(strip.width, cuts, drawing.texts)
            texts = (*drawing.texts, *marks)
            sheet, worked = _blank(strip, layer)
            drawn = replace(drawing, name=called, texts=texts)
            pieces.append(Piece(called, drawn, sheet, part.count, worked))
    return tuple(pieces)


def _blank(strip: Strip, layer: Layer) -> tuple[Sheet, float | None]:
    """What a layer is cut from; where it is planed or turned, as thick as it ever is, and what is left of it, g."""
    size = strip.layout.worked_size
    if size is None:
        return layer.sheet, None
    return layer.sheet.with_thickness(float(f"{size.extremes[1]:.4g}")), strip.mass
