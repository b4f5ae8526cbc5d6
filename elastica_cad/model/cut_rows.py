"""Cut list of pieces, printed blocks, and the sheets and rods to buy, as CSV and as a printed table."""

import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._text import distinct, file_word
from elastica_cad._values import counted, require_record, several
from elastica_cad.mechanics.sheets import hex_color, sheet_color
from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.pieces import DistinctShapes, FlatShape, Piece

CSV_COLUMNS = {
    "part": "{0.part}", "sheet": "{0.sheet}", "thickness_mm": "{0.thickness:g}", "length_mm": "{0.length:.2f}",
    "width_mm": "{0.width:.2f}", "count": "{0.count}", "file": "{0.file}",
    "cut_length_mm": "{0.cut_length:.1f}", "pierces": "{0.pierces}", "area_cm2": "{0.area:.1f}",
    "mass_g": "{0.mass:.3f}", "grain": "{0.grain}", "same_shape_as": "{0.like}", "color": "{0.color}",
    "height_mm": "{0.thickness:.2f}", "engraved_number": "{0.number}",
}  # fmt: skip
"""Columns of the CSV file, with the format of each value."""

TABLE_COLUMNS = {
    "part": "{0.called}", "sheet": "{0.sheet}", "mm": "{0.thickness:g}",
    "size mm": "{0.length:.1f} x {0.width:.1f}", "count": "{0.count}", "cut mm": "{0.cut_length:.0f}",
    "pierces": "{0.pierces}", "cm2": "{0.area:.1f}", "g": "{0.mass:.2f}", "grain": "{0.grain}",
    "shape as": "{0.like}", "color": "{0.color}", "file": "{0.file}",
}  # fmt: skip
"""Columns of the printed table, with the format of each value."""

BLOCK_COLUMNS = {
    "printed block": "{0.part}", "base, length x width mm": "{0.length:.1f} x {0.width:.1f}",
    "height over the base mm": "{0.thickness:.1f}", "count": "{0.count}", "color": "{0.color}", "file": "{0.file}",
}  # fmt: skip
"""Columns of the printed table of blocks, with the format of each value."""


@dataclass(frozen=True)
class CutListRow:
    """Row of the cut list. Lengths are in mm, areas in cm2, masses in g.

    `cut_length`, `pierces` (the number of cuts), `area` and `mass` are those of a single piece. `grain` is the
    direction of `length` relative to the grain, or "" for material without grain. `like` is the name of the first
    piece with the same shape (possibly turned or flipped) but another engraving. `color` is the colour of the
    piece in pictures and STEP files, as "#rrggbb". `number` is the number that is engraved in place of the name,
    or "" if there is none. For a printed block, `thickness` is the height, and `cut_length`, `pierces`, `area` and
    `mass` are 0.
    """

    part: str
    sheet: str
    thickness: float
    length: float
    width: float
    count: int
    cut_length: float
    mass: float
    file: str
    pierces: int = 0
    area: float = 0.0
    grain: str = ""
    like: str = ""
    color: str = ""
    number: str = ""

    @property
    def called(self) -> str:
        """Name of the part, after the number that is engraved in its place, as in "1 = Анна"."""
        return f"{self.number} = {self.part}" if self.number else self.part


@dataclass(frozen=True)
class Stock:
    """Equal sheets or rods to buy.

    Attributes
    ----------
    sheet : str
        Full name of the material.
    size : (float, ...)
        Width and height of a sheet, or length of a rod, mm.
    count : int
        Number of sheets or rods.
    sawn : tuple of str
        For rods, the lengths to saw from each rod, mm, with the names of the pieces.
    """

    sheet: str
    size: tuple[float, ...]
    count: int
    sawn: tuple[str, ...] = ()

    def __str__(self) -> str:
        noun = "rod" if len(self.size) == 1 else "sheet"
        size = " x ".join(f"{side:g}" for side in self.size)
        return f"{counted(self.count, noun)} of {self.sheet}, {size} mm{' long' * (noun == 'rod')}"


@dataclass(frozen=True)
class CutList:
    """List of the pieces to be cut. `csv` is the list for spreadsheets, and `str()` returns a table to print.

    Attributes
    ----------
    rows : tuple of CutListRow
        Pieces to be cut.
    printed : tuple of CutListRow
        Blocks to be printed. The totals `count`, `shapes`, `cut_length` and `mass` do not include printed blocks.
    stock : tuple of Stock
        Sheets and rods to buy, if the list belongs to a kit.
    price : (float, float), optional
        Price of a sheet, and of a metre of cuts.
    """

    rows: tuple[CutListRow, ...]
    printed: tuple[CutListRow, ...] = ()
    stock: tuple[Stock, ...] = ()
    price: tuple[float, float] | None = None

    @property
    def count(self) -> int:
        """Number of all pieces to be cut."""
        return sum(row.count for row in self.rows)

    @property
    def shapes(self) -> int:
        """Number of different shapes, without regard to engraving."""
        return sum(not row.like for row in self.rows)

    @property
    def cut_length(self) -> float:
        """Length of all cuts, mm."""
        return sum(row.count * row.cut_length for row in self.rows)

    @property
    def pierces(self) -> int:
        """Number of all cuts."""
        return sum(row.count * row.pierces for row in self.rows)

    @property
    def area(self) -> float:
        """Area of all pieces, cm2."""
        return sum(row.count * row.area for row in self.rows)

    @property
    def sheets(self) -> int:
        """Number of sheets to buy."""
        return sum(item.count for item in self.stock if len(item.size) == 2)

    @property
    def mass(self) -> float:
        """Mass of all pieces, g."""
        return sum(row.count * row.mass for row in self.rows)

    @property
    def csv(self) -> str:
        """Comma separated values, with a header line that states the units.

        A text that a spreadsheet would treat as a formula is preceded by an apostrophe.
        """
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(CSV_COLUMNS)
        # pieces have no height, and the mass of printed blocks depends on the printer
        no_cut = ("thickness_mm", "cut_length_mm", "pierces", "area_cm2", "mass_g")
        for rows, empty in ((self.rows, ("height_mm",)), (self.printed, no_cut)):
            for row in _texts(rows, CSV_COLUMNS, empty):
                writer.writerow(f"'{text}" if text.startswith(tuple("=+-@\t\r")) else text for text in row)
        return stream.getvalue()

    def in_files(self, files: Mapping[str, str]) -> "CutList":
        """Return the list with other file names. `files` maps names of parts to names of files."""
        require_record(files, Mapping, "the names of files", "a mapping from part to file")
        cut, printed = (
            tuple(replace(row, file=files.get(row.part, row.file)) for row in rows)
            for rows in (self.rows, self.printed)
        )
        return replace(self, rows=cut, printed=printed)

    def __str__(self) -> str:
        # the totals of the list have the names of the fields of a row
        sums = [
            TABLE_COLUMNS[name].format(self) if name in ("count", "cut mm", "pierces", "cm2", "g") else ""
            for name in TABLE_COLUMNS
        ]
        pieces = [[*TABLE_COLUMNS], *_texts(self.rows, TABLE_COLUMNS), ["in all", *sums[1:]]]
        parts = [_table(pieces, right=range(2, 9), lines=(1, len(pieces) - 1))]
        if self.stock:
            rows = [
                line for item in self.stock for line in (str(item), *(f"    {each}" for each in item.sawn))
            ]
            parts.append("\n".join(["to buy", *rows, ""]))
        if self.price is not None:
            (sheet, metre), metres = self.price, self.cut_length / 1000
            parts.append(
                f"price {sheet * self.sheets + metre * metres:.2f}: {counted(self.sheets, 'sheet')} at {sheet:g}, "
                f"{metres:.2f} m of cuts at {metre:g}\n"
            )
        if self.printed:
            blocks = [[*BLOCK_COLUMNS], *_texts(self.printed, BLOCK_COLUMNS)]
            parts.append(_table(blocks, right=(1, 2, 3), lines=(1,)))
        return "\n".join(parts)


def _texts(
    rows: Iterable[CutListRow], columns: Mapping[str, str], empty: Sequence[str] = ()
) -> list[list[str]]:
    # a rod is sawn, so it has no length of cuts
    return [
        [
            ""
            if name in empty or (name in ("cut mm", "pierces") and not row.cut_length)
            else text.format(row)
            for name, text in columns.items()
        ]
        for row in rows
    ]


def cut_list(pieces: Iterable[Piece | EndFixture], files: Mapping[str, str] | None = None) -> CutList:
    """Return the cut list of pieces and printed blocks, in the given order.

    Parameters
    ----------
    pieces : iterable of Piece or EndFixture
    files : mapping, optional
        Mapping from the name of a piece or block to its file. By default a piece has the file `file_stem` with
        .dxf, and a block its name with .stl. Numbers are appended to repeated names of files.
    """
    rows, pieces = [], several("pieces", pieces, Piece | EndFixture, "Piece")
    blocks = [piece for piece in pieces if isinstance(piece, EndFixture)]
    cut = [piece for piece in pieces if isinstance(piece, Piece)]
    shapes, first_names = DistinctShapes(), list[str]()
    for piece, stem in zip(cut, distinct(piece.file_stem for piece in cut), strict=True):
        length, width = piece.size
        rows.append(
            CutListRow(
                piece.name,
                piece.sheet.name,
                piece.sheet.thickness,
                length,
                width,
                piece.count,
                0.0 if piece.is_rod else piece.cut_length,
                piece.mass,
                f"{stem}.dxf",
                0 if piece.is_rod else len(piece.drawing.on(CUT_INNER, CUT_OUTER)),
                piece.area / 100,
                "" if piece.is_rod or piece.sheet.grain == "none" else piece.sheet.grain,
                _equal_piece(piece, shapes, first_names),
                hex_color(sheet_color(piece.sheet)),
                piece.number,
            )
        )
    return CutList(tuple(rows), tuple(_printed(blocks))).in_files({} if files is None else files)


def _printed(blocks: Sequence[EndFixture]) -> Iterator[CutListRow]:
    """Yield a row for each group of equal printed blocks, with the file of one block of the group."""
    stems = distinct(file_word(block.label) for block in blocks)
    same: dict[object, list[int]] = {}
    for k, block in enumerate(blocks):
        same.setdefault((block.label, *np.round([*block.size, *block.lean], 6)), []).append(k)
    for first, *others in same.values():
        block, color = blocks[first], hex_color(FIXTURE_COLOR)
        length, width, height = block.size
        yield CutListRow(
            block.label, "printed", round(height, 2), length, width, 1 + len(others), 0.0, 0.0,
            f"{stems[first]}.stl", color=color,
        )  # fmt: skip


def _equal_piece(piece: Piece, shapes: DistinctShapes, first_names: list[str]) -> str:
    """Return the name of an earlier piece with the same shape. If there is none, store this piece and return "".

    Pieces with several outlines, and planed or turned pieces, are neither compared nor stored.
    """
    outer = piece.drawing.on(CUT_OUTER)
    # the drawing does not show the shape of a planed or turned piece
    if len(outer) != 1 or piece.worked is not None:
        return ""
    shape = FlatShape((Layer(piece.sheet, outer[0], piece.drawing.on(CUT_INNER)),))
    number = shapes.number(shape)
    if number < len(first_names):
        return first_names[number]
    first_names.append(piece.name)
    return ""


def _table(rows: Sequence[Sequence[str]], *, right: Sequence[int], lines: Sequence[int]) -> str:
    """Return rows as text, with a horizontal line above each row whose index is in `lines`.

    Columns in `right` are aligned to the right.
    """
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    texts = []
    for row in rows:
        cells = [
            cell.rjust(width) if k in right else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        texts.append("  ".join(cells).rstrip())
    line = "-" * max(map(len, texts))
    for k in sorted(lines, reverse=True):
        texts.insert(k, line)
    return "\n".join(texts) + "\n"
