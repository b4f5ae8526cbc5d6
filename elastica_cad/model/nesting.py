"""Nesting: pieces arranged on sheets of a given size, and lengths sawn from rods."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal, TypeAlias

import numpy as np

from elastica_cad._values import require_number, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import KERF
from elastica_cad.errors import BareLength, FieldName, InputError, Length, note, sentences
from elastica_cad.geometry.path import Path
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.drawing import SHEET, Drawing, LayeredPath
from elastica_cad.strip.pieces import Piece

FIT_TOLERANCE_MM = 1e-9
"""Tolerance, mm, so that a piece fits in a row of its exact size."""


Side: TypeAlias = Literal["width", "height"]


@dataclass(frozen=True)
class Nesting:
    """Size of the sheets (width, height) and least distance between pieces, mm, grain, edge, prices."""

    sheet_size: Annotated[tuple[float, float], Option("Width and height of the sheets.", "mm", above=0)] = (
        600.0,
        400.0,
    )
    margin: Annotated[float, Option("Least distance between parts.", "mm", least=0.01)] = 2.0
    grain: Annotated[
        Literal["width", "height"], Option("Side of the sheets that their grain is parallel to.")
    ] = "width"
    edge: Annotated[bool, Option("Draw the edge of each sheet, on the layer SHEET.")] = True
    price: Annotated[
        tuple[float, float] | None,
        Option("Price of a sheet, and price of a metre of cuts; the cut list gives the sum.", least=0),
    ] = None

    def __post_init__(self) -> None:
        require_declared(Nesting, vars(self))


@dataclass(frozen=True, eq=False, repr=False)
class NestedSheet(Drawing):
    """Drawing of a sheet with its pieces and its outline. The origin is the lower left corner of the sheet.

    Attributes
    ----------
    sheet : Sheet
        Material of the sheet.
    sheet_size : (width, height)
        Size of the sheet, mm.
    along : {"width", "height"}
        Side of the sheet that its grain is parallel to.
    pieces : tuple of str
        Name of each piece.
    used : float
        Area, mm2, of the part of the sheet that the rows of pieces occupy.
    filled : float
        Area of the pieces' bounding boxes, each with its margin, mm2.
    share : float
        Area of the pieces as a fraction of the sheet.
    """

    sheet: Sheet | None = None
    sheet_size: tuple[float, float] = (0.0, 0.0)
    along: Side = "width"
    pieces: tuple[str, ...] = ()
    used: float = 0.0
    filled: float = 0.0
    share: float = 0.0

    @property
    def grain(self) -> str:
        """Sentence on the direction of the grain, or "" for a sheet without grain."""
        if self.sheet is None or self.sheet.grain == "none":
            return ""
        upright = self.along == "height"
        return note(
            "the grain runs along {axis}, parallel to the edge of the sheet that is {side:g} long",
            axis="xy"[upright], side=Length(self.sheet_size[upright]),
        )  # fmt: skip

    @property
    def counts(self) -> dict[str, int]:
        """Number of copies of each piece on this sheet."""
        return dict(Counter(self.pieces))


@dataclass(frozen=True)
class _Box:
    """Box of a piece with its margin: size along and across rows, mm, and True if rotated by 90 degrees."""

    piece: int
    long: float
    wide: float
    turned: bool


@dataclass
class _Row:
    """Row of boxes: index of the sheet, start and width across the sheet, and length of all boxes, mm."""

    sheet: int
    start: float
    wide: float
    taken: float = 0.0


_Place: TypeAlias = tuple[_Box, float, float]
"""Box, and the position of its corner along and across the rows, mm."""


def nest_pieces(
    pieces: Iterable[Piece],
    *,
    sheet_size: tuple[float, float] = (600.0, 400.0),
    margin: float = 2.0,
    grain: Side = "width",
    edge: bool = True,
    kerf: float | None = KERF,
    name: str = "nest",
) -> tuple[NestedSheet, ...]:
    """Arrange pieces in rows on as few sheets as possible, separately for each material.

    Rows are parallel to the side of the sheet for which the pieces need fewer sheets. If the counts are
    equal, the side that uses less of the last sheet is chosen. Pieces without grain may be rotated by 90
    degrees. `Sheet.grain` sets the direction of pieces with grain.

    Parameters
    ----------
    pieces : iterable of Piece
        Each piece is placed `count` times.
    sheet_size : (width, height)
        Size of the sheets, mm.
    margin : float
        Least distance of tool paths from each other and from the edge of the sheet, mm.
    grain : {"width", "height"}
        Side of the sheets that their grain is parallel to.
    edge : bool
        Draw the edge of each sheet, on the layer SHEET.
    kerf : float or None
        Kerf, mm, for which the written drawings will be compensated (`compensate_kerf`). None means the kerf
        of each sheet.
    name : str
        First part of the names of the drawings, before the material and the number.

    Returns
    -------
    tuple of NestedSheet
        Drawings of all sheets, grouped by material.

    Notes
    -----
    Boxes are placed by best fit in the order of decreasing width (shelf packing; Lodi, Martello and Monaci,
    Two-dimensional packing problems, EJOR 141, 2002). A box is the exact bounding box of the cut curves, so
    the curves keep the margin.
    """
    nesting = Nesting(sheet_size, margin, grain, edge)
    if kerf is not None:
        require_number(kerf, "the kerf", "mm")
    groups: dict[Sheet, list[Piece]] = {}
    for piece in several("pieces", pieces, Piece, "Piece"):
        groups.setdefault(piece.sheet, []).append(piece)
    drawings: list[NestedSheet] = []
    for sheet, group in groups.items():
        drawings += _nested_group(
            sheet, group, replace(nesting, margin=margin + widened_by(sheet, kerf)), name
        )
    return tuple(drawings)


def saw_rods(
    pieces: Iterable[Piece], stock: float, saw: float = 2.0
) -> tuple[tuple[tuple[str, float], ...], ...]:
    """Return the names of pieces and the lengths, mm, to saw from each rod.

    The longest lengths are sawn first, each from the first rod that is long enough. A piece that is longer
    than a rod is joined from whole rods and a shorter length.

    Parameters
    ----------
    pieces : iterable of Piece
        Each piece is sawn `count` times.
    stock : float
        Length of the rods, mm.
    saw : float
        Length that is lost at each cut, mm.

    Examples
    --------
    >>> from elastica_cad.strip.drawing import CUT_OUTER
    >>> pole = Drawing("pole", [LayeredPath(CUT_OUTER, Path.rectangle(700, 4))])
    >>> [[length for _, length in rod] for rod in saw_rods([Piece("P", pole, Sheet.named("glass-rod-4"), 3)], 2000)]
    [[700.0, 700.0], [700.0]]
    """
    lengths: list[tuple[str, float]] = []
    for piece in pieces:
        length = piece.size[0]
        whole = int((length - FIT_TOLERANCE_MM) // stock)
        parts = [stock] * whole + [length - whole * stock]
        lengths += [(piece.name, part) for part in parts] * piece.count
    rods: list[list[tuple[str, float]]] = []
    for name, length in sorted(lengths, key=lambda sawn: -_rounded(sawn[1])):
        fits = (
            rod for rod in rods if sum(used + saw for _, used in rod) + length <= stock + FIT_TOLERANCE_MM
        )
        rod = next(fits, None)
        if rod is None:
            rods.append(rod := [])
        rod.append((name, length))
    return tuple(map(tuple, rods))


def widened_by(sheet: Sheet, kerf: float | None) -> float:
    """Return the width, mm, by which tool paths widen a piece: `kerf` or, if it is None, the sheet's kerf."""
    return max(sheet.kerf if kerf is None else kerf, 0.0)


def _nested_group(sheet: Sheet, pieces: Sequence[Piece], nesting: Nesting, name: str) -> list[NestedSheet]:
    """Return sheets with the pieces of one material.

    Rows are along the long or the short side, whichever needs fewer sheets or less of the last sheet.
    """
    # number of sheets and used area of the last sheet, whether rows are along the height, and the places
    best: tuple[tuple[float, float], bool, list[list[_Place]]] | None = None
    (width, height), margin = nesting.sheet_size, nesting.margin
    for upright in (False, True):
        # every box has a margin on one side, so the other edge of the sheet needs one more
        usable = (height - margin, width - margin) if upright else (width - margin, height - margin)
        boxes = [_boxes(i, piece, nesting, usable, upright) for i, piece in enumerate(pieces)]
        if not all(boxes):
            continue
        sheets = _pack(boxes, pieces, usable)
        cost = len(sheets), _rounded(max(y + box.wide for box, _, y in sheets[-1]) * usable[0])
        if best is None or cost < best[0]:
            best = cost, upright, sheets
    if best is None:
        raise InputError(sentences(_too_large(pieces, nesting), ". "))
    _, upright, sheets = best
    return [
        _drawing(sheet, pieces, places, nesting, upright, f"{name}-{number}")
        for number, places in enumerate(sheets, start=1)
    ]


def _boxes(
    index: int, piece: Piece, nesting: Nesting, usable: tuple[float, float], upright: bool
) -> list[_Box]:
    """Return the boxes of a piece with margin, narrowest first, turned as the grain permits.

    `usable` are the sizes of the sheet along and across the rows, mm, without one margin. With `upright`, rows run
    along the height of the sheet.
    """
    x, y = (side + nesting.margin for side in piece.size)
    boxes, grain = [], piece.sheet.grain
    for turned in (False, True) if grain == "none" else ((grain == "across") != (nesting.grain == "height"),):
        long, wide = (y, x) if turned != upright else (x, y)
        if long <= usable[0] + FIT_TOLERANCE_MM and wide <= usable[1] + FIT_TOLERANCE_MM:
            boxes.append(_Box(index, long, wide, turned))
    return sorted(boxes, key=lambda box: _rounded(box.wide))


def _pack(
    boxes: list[list[_Box]], pieces: Sequence[Piece], usable: tuple[float, float]
) -> list[list[_Place]]:
    """Return the places of all boxes on each sheet."""
    # each item has the boxes, turned or not, of one copy of a piece
    queue = [ways for ways, piece in zip(boxes, pieces, strict=True) for _ in range(piece.count)]
    queue.sort(key=lambda ways: (-_rounded(ways[0].wide), -_rounded(ways[0].long)))
    shortest = min(box.long for ways in boxes for box in ways)
    rows: list[_Row] = []  # rows that still have space for the shortest box
    ends: list[float] = []  # end of the last row on each sheet, mm
    sheets: list[list[_Place]] = []
    for ways in queue:
        # best fit: least unused width of the row, then least unused length
        fits = [
            (
                _rounded(row.wide - box.wide),
                _rounded(usable[0] - row.taken - box.long),
                row.sheet,
                row.start,
                row,
                box,
            )
            for row in rows
            for box in ways
            if box.wide <= row.wide + FIT_TOLERANCE_MM
            and row.taken + box.long <= usable[0] + FIT_TOLERANCE_MM
        ]
        if fits:
            *_, row, box = min(fits, key=lambda fit: fit[:4])
        else:
            box = ways[0]
            open_sheets = (i for i, end in enumerate(ends) if end + box.wide <= usable[1] + FIT_TOLERANCE_MM)
            number = next(open_sheets, len(ends))
            if number == len(ends):
                ends.append(0.0)
                sheets.append([])
            row = _Row(number, ends[number], box.wide)
            rows.append(row)
            ends[number] += box.wide
        sheets[row.sheet].append((box, row.taken, row.start))
        row.taken += box.long
        if row.taken + shortest > usable[0] + FIT_TOLERANCE_MM:
            rows.remove(row)
    return sheets


def _rounded(size: float) -> float:
    # sizes in mm are rounded before sorting, so that rounding errors do not change the order
    return round(size, 6)


def _drawing(
    sheet: Sheet,
    pieces: Sequence[Piece],
    places: Sequence[_Place],
    nesting: Nesting,
    upright: bool,
    name: str,
) -> NestedSheet:
    """Return the drawing of a sheet with the placed pieces, and the fractions that are used."""
    size, margin = nesting.sheet_size, nesting.margin
    usable = size[upright] - margin
    laid, places = [], sorted(places, key=lambda place: place[0].piece)
    placed = [pieces[box.piece] for box, _, _ in places]
    for piece, (box, *start) in zip(placed, places, strict=True):
        x, y = start[::-1] if upright else start
        laid.append(piece.drawing.transformed(_placement(piece, box.turned, x + margin, y + margin)))
    merged = Drawing.merged(f"{name}-{sheet.name}", laid)
    return NestedSheet(
        merged.name,
        (*[LayeredPath(SHEET, Path.rectangle(*size))] * nesting.edge, *merged.paths),
        merged.texts,
        sheet=sheet,
        sheet_size=size,
        along=nesting.grain,
        pieces=tuple(piece.name for piece in placed),
        used=max(y + box.wide for box, _, y in places) * usable,
        filled=sum(box.long * box.wide for box, _, _ in places),
        share=sum(piece.area for piece in placed) / (size[0] * size[1]),
    )


def _placement(piece: Piece, turned: bool, x: float, y: float) -> np.ndarray:
    # map (3, 3) that turns the piece and puts the lower left corner of its box at x, y
    (x0, y0), (_, y1) = piece.bounds
    if turned:
        return np.array([[0.0, -1.0, x + y1], [1.0, 0.0, y - x0], [0.0, 0.0, 1.0]])
    return np.array([[1.0, 0.0, x - x0], [0.0, 1.0, y - y0], [0.0, 0.0, 1.0]])


def _too_large(pieces: Sequence[Piece], nesting: Nesting) -> Iterator[str]:
    size, margin = nesting.sheet_size, nesting.margin
    for piece in pieces:
        if not any(_boxes(0, piece, nesting, (size[0] - margin, size[1] - margin), False)):
            x, y = piece.size
            yield note(
                "{piece}: a part of {x:.4g} by {y:.4g} does not fit on a sheet of {long:g} by {short:g} "
                "with a margin of {margin:g}. Use a larger sheet ({field}) or make the part in pieces"
                if piece.sheet.grain == "none" else
                "{piece}: a part of {x:.4g} by {y:.4g}, with its grain {grain} the part, does not fit on a "
                "sheet of {long:g} by {short:g} with a margin of {margin:g}. Use a larger sheet ({field}), turn "
                "the grain of the sheet ({turn}), or make the part in pieces",
                piece=piece.name, x=BareLength(x), y=Length(y), long=BareLength(size[0]), short=Length(size[1]),
                margin=Length(margin), grain=piece.sheet.grain, field=FieldName("nest.sheet_size"),
                turn=FieldName("nest.grain"),
            )  # fmt: skip
