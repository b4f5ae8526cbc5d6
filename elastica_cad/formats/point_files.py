"""Readers of curves from text files: tables of measured points, and control points of a uniform spline."""

import csv
import re
import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH, is_in_inches, look_up_unit, read_number, read_offset, read_unit
from elastica_cad.errors import InputError, Length, Listed, note, quoted
from elastica_cad.formats.chains import curve_from_points
from elastica_cad.formats.drawn_file import DrawnCurve, DrawnFile, ReadUnit
from elastica_cad.formats.source_file import (
    MOST_DEGREE,
    MOST_PIECES,
    UNIT,
    check_count,
    check_degree,
    check_size,
    check_tolerance,
    half_last_place,
    name_source,
)
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import corner_points, is_closed, norm

ALONG = ("distance", "station")
"""Headings of the x column that all curves of a table of offsets share. The first heading found is used."""

NOTHING = ("", "-", "\u2013", "\u2014")
"""Cells of a table of offsets which mean that the curve has no point in this row."""

_FRACTIONS = re.compile("[\u00bc-\u00be\u2150-\u215e]")
"""Fractions that are a single character, such as five eighths."""

_CONTROL = re.compile("[\x00-\x08\x0e-\x1f]")
_SEP = re.compile(r'"?sep=(.)"?', re.IGNORECASE)
# heading with a unit in brackets: text before, unit, text after
_BRACKETS = re.compile(r"(.*?)\s*[\[({<]\s*([^\])}>]*?)\s*[\])}>](.*)", re.DOTALL)
# heading with a unit behind it: text, and the unit as a word or as a sign of feet or inches
_BEHIND = re.compile(r"""(.+?)(?:[\s_/:,-]+([^\W\d_]+\.?)|\s*(["'\u2032\u2033\u2019\u201d]+))""")
# heading of a coordinate: axis, number of the curve, and the rest, which is a name or a unit
_AXIS = re.compile(
    r"([xyz])(?:[ _-]?(?:coord|koord|pos|value|wert|achse|axis)[^\W\d_]*)?[ _-]?(\d*)(?:[\W_]+(.*))?"
)
_SURVEY = {
    **dict.fromkeys(("easting", "east", "e", "rechtswert", "ostwert"), "x"),
    **dict.fromkeys(("northing", "north", "n", "hochwert", "nordwert"), "y"),
    **dict.fromkeys(("elevation", "elev", "height", "h\u00f6he"), "z"),
}
"""Axis for each name of a surveying coordinate."""

_STATED = re.compile(
    r"""\b(?:units?|einheit(?:en)?)\s*(?:[:=]|are|in)\s*["(\[]?([^\W\d_]+)|
    (?:\b(?:all|dimensions|measurements|coordinates|values)\s+in\s+|[(\[])([^\W\d_]+)""",
    re.IGNORECASE | re.VERBOSE,
)
"""Pattern for a unit in a remark or title: certain ("Units: inches"), or possible ("all in mm", "(inches)")."""

_NUMBER = re.compile(r"[-+]?[\d.,]*\d[\d.,]*(?:[eE][-+]?\d+)?")
_SPACES = re.compile("[ '\u2019]")
_GROUPED = re.compile(r"[-+]?[1-9]\d{0,2}(?:([ '\u2019])\d{3})(?:\1\d{3})*(?:[.,]\d*)?")
"""Pattern for a number with thousands separated by blanks or apostrophes."""

_UNIT_BEHIND = re.compile(rf"({_NUMBER.pattern}|[-+]?\d+[ -]\d+/\d+)\s*([^\W\d_]+\.?)")

Row = tuple[int, list[str]]
"""Number of a row in the file, and its cells."""


class Column(NamedTuple):
    """A curve of a table.

    Attributes
    ----------
    name : str
        Heading of the curve; "" if the table is a single curve.
    rows : list
        Number and coordinates of each row. A row without coordinates separates two pieces.
    """

    name: str
    rows: list[Row]


@dataclass(frozen=True)
class PointTable:
    """The curves of a table of points.

    Attributes
    ----------
    columns : list of Column
    unit : str or None
        Unit named in the table.
    note : str
        Message on how ambiguous numbers were read.
    is_offsets : bool
        True for a table of offsets: all curves share one x column.
    """

    columns: list[Column]
    unit: str | None
    note: str
    is_offsets: bool

    @classmethod
    def read(cls, file: Path, *, unit: str | None) -> "PointTable":
        """Read a table. `unit` overrides the unit in the table."""
        rows, remarks, separator = _split_rows(read_text(file))
        layout = _Layout.of(rows)
        units = [] if unit else _units(layout.units, [*remarks, *layout.titles])
        columns, behind = _without_units(layout.columns)
        units = [unit] if unit else list(dict.fromkeys([*units, *behind]))
        if len(units) > 1:
            raise InputError(
                "the file has the units {names}: give x and y in one unit", names=" and ".join(units)
            )
        # use decimal points, and remove separators of thousands
        columns = _mapped(
            columns,
            lambda cell: _SPACES.sub("", cell) if _SPACES.search(cell) and _GROUPED.fullmatch(cell) else cell,
        )
        cells = [(n, cell) for _, lines in columns for n, line in lines for cell in line]
        group, message = _group_sign(cells, separator, look_up_unit(units[0] if units else "mm"))
        columns = _mapped(columns, lambda cell: cell.replace(group, "").replace(",", "."))
        return cls(columns, next(iter(units), None), message, layout.is_offsets)


def read_text(path: Path) -> str:
    """Return the file as text: UTF-8, UTF-16 with a byte order mark, or Windows-1252 (Excel)."""
    data = path.read_bytes()
    encoding = "utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        text = "\x00" if encoding == "utf-16" else data.decode("cp1252", errors="replace")
    if _CONTROL.search(text):
        raise InputError("is not a text file: save the points as plain text (CSV, UTF-8)")
    fractions = _FRACTIONS.sub(
        lambda sign: " " + unicodedata.normalize("NFKC", sign[0]).replace("\u2044", "/"), text
    )
    # typographic minus sign, as in Nordic spreadsheets
    return fractions.replace("\u2212", "-")


def _split_rows(text: str) -> tuple[list[Row], list[str], str]:
    """Return the rows with unquoted cells, the remarks, and the separator of cells (" " by default)."""
    lines = text.splitlines()
    stated = _SEP.fullmatch(lines[0].strip(" ")) if lines else None
    numbered = [(n, line.strip(" ")) for n, line in enumerate(lines, 1) if not line.lstrip().startswith("#")]
    numbered = numbered[1:] if stated else numbered
    if stated:
        separator = stated[1]
    else:
        outside = [re.sub('"[^"]*"', "", line) for _, line in numbered]
        often = {sign: sum(sign in line for line in outside) for sign in ";\t,"}
        separator = max(often, key=lambda sign: often[sign]) if any(often.values()) else " "
    if separator == " ":
        # leave out blanks before a bracket with a unit, and remarks behind the last cell
        numbered = [(n, re.sub(r"\s+(?=[\[(])|\s#.*", "", line.strip())) for n, line in numbered]
    reader = csv.reader((f"{line}\n" for _, line in numbered), delimiter=separator, skipinitialspace=True)
    rows: list[Row] = []
    begun = 0
    try:
        for cells in reader:
            trimmed = [" ".join(cell.split()) for cell in cells]
            while trimmed and not trimmed[-1]:
                trimmed.pop()
            rows.append((numbered[begun][0], trimmed))
            begun = reader.line_num
    except csv.Error as error:
        raise InputError(
            "row {row} has a quotation mark without its closing mark: add the closing mark",
            row=numbered[begun][0],
        ) from error
    return rows, [line.strip() for line in lines if line.lstrip().startswith("#")], separator


class _Head(NamedTuple):
    """Cell of a heading: axis, name and unit; missing parts are empty."""

    axis: str
    name: str
    unit: str

    @classmethod
    def of(cls, cell: str) -> "_Head":
        """Return the parts of a cell such as "x [mm]" or "x mm"."""
        base, unit = cell, ""
        if match := _BRACKETS.fullmatch(cell):
            base, unit = f"{match[1]} {match[3]}".strip(), "" if match[2] in NOTHING else match[2]
        elif (match := _BEHIND.fullmatch(cell)) and read_unit(match[2] or match[3]):
            base, unit = re.sub(r"[\s_]+in$", "", match[1]), match[2] or match[3]
        base = base.strip(" _-:/,.")
        known = not unit or read_unit(unit) is not None
        if axis := _AXIS.fullmatch(base.lower()):
            return cls(axis[1], axis[3] or (axis[2] if known else unit), unit or axis[3] or "")
        return cls("", base if known else cell, unit)


@dataclass(frozen=True)
class _Layout:
    """Curves of a table, with the units in its heading and the texts (`titles`) above the heading."""

    columns: list[Column]
    units: list[str]
    titles: list[str]
    is_offsets: bool = False

    @classmethod
    def of(cls, rows: list[Row]) -> "_Layout":
        """Return the layout of rows with the first heading among them, or with no heading."""
        first = _first_data(rows)
        for k, (_, cells) in enumerate(rows[: first + 1]):
            heads = [_Head.of(cell) for cell in cells]
            names = [head.name.lower() for head in heads]
            survey = [_SURVEY.get(name, "") for name in names]
            along = next((name for name in ALONG if name in names), None)
            above, (units, below) = rows[:k], _units_row(rows[k + 1 :])
            if {"x", "y"} <= {head.axis for head in heads}:
                return cls._of_axes(heads, above, below, units)
            if {"x", "y"} <= set(survey):
                named = [_Head(axis, "", head.unit) for head, axis in zip(heads, survey, strict=True)]
                return cls._of_axes(named, above, below, units)
            if along is not None and len(heads) > 1:
                return cls._of_offsets(heads, names.index(along), below, units, _words(above))
        titles = [cells for _, cells in rows[:first] if cells]
        stated = [_Head.of(cell).unit for cells in titles[-2:] if len(cells) > 1 for cell in cells]
        stated += [cell for cells in titles if all(map(read_unit, cells)) for cell in cells]
        return cls([Column("", rows[first:])], stated, _words(rows[:first]))

    @classmethod
    def _of_axes(
        cls, heads: Sequence[_Head], above: list[Row], below: list[Row], units: list[str]
    ) -> "_Layout":
        """Return the layout with a curve for every pair of columns x and y, or triple x, y and z."""
        # columns of each axis, one for every curve
        places = {axis: [k for k, head in enumerate(heads) if head.axis == axis] for axis in "xyz"}
        count = max(len(places["x"]), len(places["y"]))
        for axis, indices in places.items():
            if len(indices) == 1 and axis != "z":
                places[axis] = indices * count
            elif len(indices) != count and (indices or axis != "z"):
                raise InputError(
                    "the heading has x {x} times, y {y} times and z {z} times: give each curve its own "
                    "columns, or one x column for all curves",
                    x=len(places["x"]),
                    y=len(places["y"]),
                    z=len(places["z"]),
                )
        curves = list(zip(*(indices for indices in places.values() if indices), strict=True))
        stated = dict.fromkeys(unit for curve in curves for k in curve if (unit := heads[k].unit))
        names = [unit for unit in stated if read_unit(unit) is None]
        units = [
            *units,
            *(unit_name for unit_name in stated if len(names) < 2 or unit_name not in names),
        ]  # several names that are not units are names of curves
        if count == 1:
            last = max(curves[0])
            rows = [(n, [cells[k] for k in curves[0]] if len(cells) > last else cells) for n, cells in below]
            return cls([Column("", rows)], units, _words(above))
        titles = [_cells_of_curve(above[-1][1], curve)[:1] if above else [] for curve in curves]
        columns = []
        for curve, title in zip(curves, titles, strict=True):
            named = [heads[place].name for place in curve[::-1] if heads[place].name]
            name = title[0] if all(titles) else next(iter(named), "")
            columns.append(Column(name, [(n, _cells_of_curve(cells, curve)) for n, cells in below]))
        return cls(columns, units, _words(above))

    @classmethod
    def _of_offsets(
        cls, heads: Sequence[_Head], along: int, below: list[Row], units: list[str], titles: list[str]
    ) -> "_Layout":
        """Return the layout of a table of offsets, with a curve for every named column over the column `along`."""
        columns, used = [], [along]
        for k, head in enumerate(heads):
            if head.name.lower() in ALONG or not head.name:
                continue
            rows = [(n, [cells[along], cells[k]]) for n, cells in below
                    if len(cells) > max(along, k) and cells[k] not in NOTHING]  # fmt: skip
            if any(re.match(r"[-+.]?\s*\d", y) for _, (_, y) in rows):
                columns.append(Column(head.name, rows))
                used.append(k)
        if not columns:
            return cls([Column("", [(n, cells) for n, cells in below if cells])], units, titles)
        return cls(columns, [*units, *(heads[k].unit for k in used)], titles, is_offsets=True)


def _cells_of_curve(cells: list[str], places: Sequence[int]) -> list[str]:
    # the cells in the columns `places` of a curve, or none if x and y are empty
    cells_of_curve = [cells[k] if k < len(cells) else "" for k in places]
    return cells_of_curve if any(cell not in NOTHING for cell in cells_of_curve[:2]) else []


def _words(rows: list[Row]) -> list[str]:
    return [cell for _, cells in rows for cell in cells if cell]


def _units_row(rows: list[Row]) -> tuple[list[str], list[Row]]:
    """Return the units in the first row that is not empty, and the rows without it, if all its cells are units."""
    for k, (_, cells) in enumerate(rows):
        if cells:
            bare = [cell.strip(" []()") for cell in cells]
            units = [cell for cell in bare if cell not in NOTHING]
            return (units, rows[:k] + rows[k + 1 :]) if units and all(map(read_unit, units)) else ([], rows)
    return [], rows


def _units(names: Sequence[str], titles: Sequence[str]) -> list[str]:
    """Return the units in the heading or, without units in the heading, in titles and remarks."""
    stated = [match for title in titles for match in _STATED.finditer(title)]
    words = [word for word in names if word not in NOTHING] or [
        match[1] or match[2] for match in stated if match[1] or read_unit(match[2])
    ]
    for word in words:
        if read_unit(word) is None:
            raise InputError(
                "the heading has {word}, which is not a known unit: set the unit ({field}), or remove {word} "
                "from the heading",
                field=UNIT,
                word=quoted(word[:40]),
            )
    return list(dict.fromkeys(unit for word in words if (unit := read_unit(word))))


def _mapped(columns: list[Column], change: Callable[[str], str]) -> list[Column]:
    return [Column(name, [(n, list(map(change, cells))) for n, cells in rows]) for name, rows in columns]


def _without_units(columns: list[Column]) -> tuple[list[Column], list[str]]:
    """Return the columns without the units of numbers such as "12.5 mm", and these units."""
    units: dict[str, None] = {}

    def bare(cell: str) -> str:
        match = None if cell[-1:].isdigit() else _UNIT_BEHIND.fullmatch(cell)
        unit = read_unit(match[2]) if match and read_offset(cell) is None else None
        if match is None or unit is None:
            return cell
        units[unit] = None
        return match[1]

    return _mapped(columns, bare), list(units)


def _group_sign(cells: Sequence[tuple[int, str]], separator: str, scale: float) -> tuple[str, str]:
    """Return the separator of thousands ("" if none), and a message if it was guessed.

    A single separator before three digits may separate thousands or decimals. The other cells decide. If all
    cells are ambiguous, a quoted comma in a comma-separated file separates thousands. Any other separator is a
    decimal point, unless the curve would then be smaller than any strip.
    """
    numbers = [(n, cell.lstrip("+-")) for n, cell in cells if _NUMBER.fullmatch(cell)]
    # row and cell of the numbers with each sign: "group" if it surely separates thousands, "decimal" if it surely
    # does not, else "open"
    kinds: dict[str, dict[str, list[tuple[int, str]]]] = {",": {}, ".": {}}
    for n, cell in numbers:
        for sign, other in (",.", ".,"):
            if sign in cell:
                grouped = re.fullmatch(rf"[1-9]\d{{0,2}}(?:\{sign}\d{{3}})+(?:\{other}\d*)?", cell)
                sure = cell.count(sign) > 1 or other in cell
                kinds[sign].setdefault(("group" if sure else "open") if grouped else "decimal", []).append(
                    (n, cell)
                )
    large = any(re.match(r"\d{4}", cell) for _, cell in numbers)
    for sign, other in (",.", ".,"):
        mine, its = kinds[sign], kinds[other]
        if "group" in mine:
            unsure = mine["group"] if "decimal" in mine or "group" in its else []
        elif set(mine) != {"open"} or "group" in its or (sign == "." and separator in ", "):
            continue
        elif its:
            unsure = mine["open"] if large or "decimal" not in its else []
        elif large:
            continue
        elif separator == ",":
            cell = mine["open"][0][1]
            return sign, note(
                "the numbers have thousands separators: {cell} was read as {number}. If that is wrong, "
                "remove the separators",
                cell=cell,
                number=cell.replace(sign, ""),
            )
        elif max(float(cell.replace(sign, ".")) for _, cell in mine["open"]) * scale >= 20:
            # with a decimal point, the strip has a likely size in mm
            continue
        else:
            unsure = mine["open"]
        if not unsure:
            return sign, ""
        raise InputError(
            "row {row} has {cell!r}, whose separator can mean thousands or decimals: write numbers without "
            "a thousands separator",
            row=unsure[0][0],
            cell=unsure[0][1],
        )
    return "", ""


def _first_data(rows: list[Row]) -> int:
    """Return the index of the first data row.

    This is the first row with two numbers, else the first row with one number, else the second filled row.
    """
    filled, forms = [k for k, (_, cells) in enumerate(rows) if cells], (_NUMBER, _GROUPED, _UNIT_BEHIND)
    for least in (2, 1):
        for k in filled:
            cells = rows[k][1]
            numbers = [
                cell for cell in cells if is_in_inches(cell) or any(form.fullmatch(cell) for form in forms)
            ]
            if len(numbers) >= least:
                return k
    return filled[1] if len(filled) > 1 else len(rows)


def _read_row(cells: list[str], row: int, least: int, most: int, scale: float) -> list[float]:
    """Return the numbers of a row, mm.

    `scale` is the size of the unit; cells in feet and inches need none.
    """
    if not least <= len(cells) <= most:
        raise InputError(
            "row {row} has {count} columns instead of {needed}: correct this row",
            row=row,
            count=len(cells),
            needed="x, y and z" if least == 3 else "x and y" if most == 2 else "x and y (and z)",
        )
    values = []
    for cell in cells:
        try:
            inches = read_offset(cell)
            values.append(scale * read_number(cell) if inches is None else MM_PER_INCH * inches)
        except ValueError:
            raise InputError(
                "row {row} has {cell!r} instead of a number: write a number such as 12.5, or # before a comment",
                row=row,
                cell=cell[:40],
            ) from None
    if not all(map(isfinite, values)):
        raise InputError(
            "row {row} is not finite ({cells}): correct this row or leave it out",
            row=row,
            cells=", ".join(cells),
        )
    return values


LARGEST_GAP = 1.6
"""Largest ratio of the distance between the ends of a closed outline to the steps beside the ends, or inverse."""

# points with a rounding error of at least this, mm, count as measured with a ruler
RULER_MM = 0.25


def read_csv_drawing(file: Path, *, fit_tolerance: float, unit: str | None, **_: Any) -> DrawnFile:
    """Fit curves to measured points, one "x, y" in each row. Blank rows separate curves.

    Columns are separated by commas, semicolons, tabs or blanks, or by the sign defined in a row such as
    Excel's `sep=;`. Rows that start with # are remarks. Titles, a heading and a row of units may precede the
    numbers. Decimal commas are allowed in quotes, or if commas do not separate columns. A third column, z,
    must be constant.

    A heading that names x and y (or Easting and Northing) selects these columns; it may name several pairs
    for several curves. The heading may also state the unit, as in "x (in)", "y [mm]", "x_mm" or "x in
    inches"; `unit` overrides it. A heading with a column "distance" or "station" starts a table of offsets.
    Every other column is then a curve over that column, named by its heading. Cells may be fractions (3 1/2),
    feet and inches (3' 4 5/8"), or feet, inches and eighths (3-4-5). Without a unit, such cells are in inches.
    """
    check_tolerance(fit_tolerance, "tolerance for fitting")
    table = PointTable.read(file, unit=unit)
    cells = [cell for column in table.columns for _, row in column.rows for cell in row]
    inches = [cell for cell in cells if is_in_inches(cell)]
    scale = look_up_unit(table.unit or ("in" if inches else "mm"))
    # parts of an inch: denominators of fractions, and eighths
    parts = [int(match[1]) for cell in inches if (match := re.search(r"/(\d+)", cell))]
    parts += [8 for cell in inches if cell.count("-") > 1]
    # half a unit of the finest fraction or of the last digit; more cells would be slow
    rounded = MM_PER_INCH / max(parts) / 2 if parts else scale * half_last_place(cells[:20_000])
    # tables in inches, tables of offsets and coarse numbers count as measured with a ruler: their rounding is a
    # noise, with the root mean square of an error that is uniform within +-rounded
    measured = scale == MM_PER_INCH or table.is_offsets or rounded >= RULER_MM
    noise = measured * rounded / np.sqrt(3)
    curves: list[DrawnCurve] = []
    closed: list[str] = []
    for name, rows in table.columns:
        try:
            blocks = _blocks(rows, scale)
        except InputError as problem:
            if len(table.columns) == 1:
                raise
            curves.append(DrawnCurve(len(curves) + 1, partial(_raise, problem), name, kinds={"point": 0}))
            continue
        digits = Provenance(rounding=rounded, name=name)
        for block in blocks:
            points = _outline_of(block)
            make = partial(_fitted, points, fit_tolerance, digits, noise)
            curves.append(DrawnCurve(len(curves) + 1, make, name, kinds={"point": len(block)}))
            if points is not block:
                closed.append(f"curve {len(curves)}")
    if table.unit:
        known = ReadUnit.requested(unit) if unit else ReadUnit(table.unit, "stated", note("the heading"))
    else:
        known = ReadUnit("in", "guessed", note=note(
            "the numbers were read as inches (fractions, or feet-inches-eighths): set the unit if they are not "
            "inches"
        )) if inches else ReadUnit("mm")  # fmt: skip
    remarks = [note(
        "{curves} is closed from the last to the first point, which are as far apart as other points. To keep it "
        "open, add a point between an end and its neighbour",
        curves=Listed(closed),
    )] if closed else []  # fmt: skip
    return DrawnFile(file, curves, unit=replace(known, note=table.note or known.note), remarks=tuple(remarks))


# coordinates that are too large are refused later, with the name of their curve
@np.errstate(all="ignore")
def _outline_of(points: FloatArray) -> FloatArray:
    """Return points (n, 2), with the first one repeated at the end if they go round without a larger gap."""
    closed = np.concatenate([points, points[:1]])
    if not is_closed(closed):
        return points
    before, gap, after = norm(np.diff(np.concatenate([closed[-3:], closed[1:2]]), axis=0))
    has_gap = gap > LARGEST_GAP * min(before, after) or gap * LARGEST_GAP < max(before, after)
    return points if has_gap or max(corner_points(closed), default=0) >= len(points) - 1 else closed


def read_path_points(file: Path) -> FloatArray:
    """Read the points (n, 3), mm, of a path in space from a table with x, y and z: see `read_csv_drawing`."""
    with name_source(file):
        table = PointTable.read(file, unit=None)
        scale = look_up_unit(table.unit or "mm")
        rows = (row for column in table.columns for row in column.rows)
        return np.array([_read_row(cells, n, 3, 3, scale) for n, cells in rows if cells]).reshape(-1, 3)


def _raise(problem: InputError) -> PlaneCurve:
    raise problem


def _fitted(points: FloatArray, tolerance: float, digits: Provenance, noise: float) -> PlaneCurve:
    check_size(points)
    check_count(len(points), 4 * MOST_PIECES, "points in one curve", "leave some out")
    return curve_from_points(points, tolerance=tolerance, drawn=digits, noise=noise)


def read_text_drawing(file: Path, *, fit_tolerance: float, unit: str | None, **_: Any) -> DrawnFile:
    """Read a file of control points, or of measured points like a .csv file: see `read_csv_drawing`.

    Control points follow a line "degree count", as `count` lines "x y". The knots are the integers from -degree to
    count: a uniform spline, not clamped at its ends.
    """
    scale = look_up_unit(unit or "mm")
    rows = [(n, line.split()) for n, line in enumerate(read_text(file).splitlines(), 1) if line.strip()]
    rows = [(n, row) for n, row in rows if not row[0].startswith("#")]
    if not rows:
        raise InputError(
            "the file has no numbers: write the degree and the number of control points in the first line"
        )
    number, head = rows[0]
    has_head = re.fullmatch(r"[1-9]\d{0,8} \d{1,9}", " ".join(head)) is not None
    degree, count = map(int, head) if has_head else (0, 0)
    # measured points, or a heading
    if not has_head or (degree > MOST_DEGREE and len(rows) - 1 != count):
        return read_csv_drawing(file, fit_tolerance=fit_tolerance, unit=unit)
    check_degree(degree)
    check_count(count, 4 * MOST_PIECES, "control points", "leave some out")
    if len(rows) - 1 != count:
        raise InputError(
            "line {number} announces {count} control points, but {given} lines follow: correct the count, or put "
            "measured points into a .csv file",
            number=number,
            count=count,
            given=len(rows) - 1,
        )
    points = np.array([_read_row(row, n, 2, 2, scale) for n, row in rows[1:]]).reshape(-1, 2)
    check_size(points)
    digits = Provenance(rounding=scale * half_last_place([word for _, row in rows[1:] for word in row]))
    curve = PlaneCurve(np.arange(-degree, count + 1, dtype=float), points, degree, provenance=digits)
    known = ReadUnit.requested(unit) if unit else ReadUnit("mm")
    return DrawnFile(file, [DrawnCurve(1, lambda: curve, kinds={"spline": 1})], unit=known)


def _blocks(rows: Sequence[Row], scale: float) -> list[FloatArray]:
    """Return the points (n, 2), mm, of each block of rows between blank rows."""
    blocks: list[list[FloatArray]] = [[]]
    for n, cells in rows:
        if not any(cells):
            if blocks[-1]:
                blocks.append([])
            continue
        blocks[-1].append(np.array([*_read_row(cells, n, 2, 3, scale), 0.0][:3]))
    filled = [np.array(block) for block in blocks if block]
    if not filled:
        raise InputError("the file has no points: write one 'x, y' per row")
    for block in filled:
        height = np.ptp(block[:, 2])
        if height > 1e-6 * max(1.0, float(np.ptp(block[:, :2], axis=0).max())):
            raise InputError(
                "the third column varies by {height:.4g}, but only curves in a plane z = const are read: "
                "rotate the points into the xy plane",
                height=Length(height),
            )
    return [block[:, :2] for block in filled]
