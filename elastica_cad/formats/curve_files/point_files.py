"""Curves from plain numbers: measured points (CSV) and the control points of a uniform spline (text)."""

import re
from functools import partial
from pathlib import Path

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import (
    MILLIMETRES,
    MM_PER_INCH,
    is_in_inches,
    look_up_unit,
    read_number,
    read_offset,
)
from elastica_cad.errors import InputError, quoted
from elastica_cad.formats.curve_files.chains import curve_from_points
from elastica_cad.formats.curve_files.drawn_file import DrawnCurve, DrawnFile
from elastica_cad.formats.curve_files.number_gate import (
    MOST_PIECES,
    NUMBER,
    check_count,
    check_degree,
    check_size,
    check_tolerance,
    half_last_place,
)
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.refusals import Length, note

_UNIT = "|".join(MILLIMETRES)
_HEAD = re.compile(rf"(.+?)(?:[\s_]*[\[(]\s*({_UNIT})\s*[\])]|[\s_]+({_UNIT}))?", re.IGNORECASE)
"""A cell of a heading: the name of a column, and its unit."""

ALONG = ("distance", "station")
"""Columns of a table of offsets from which all others are curves: the first of these names that its heading has."""

NOTHING = ("", "-", "\u2013", "\u2014")
"""Cells of a table of offsets where a curve does not reach."""

_MINUS = "\u2212"
"""The minus of typesetters, which spreadsheets in Nordic languages write."""

_DIGITS = 20_000  # numbers whose digits are looked at


def read_csv_drawing(file: Path, *, fit_tolerance: float, unit: str | None) -> DrawnFile:
    """Fit curves to measured points, one "x, y" a row; blank rows part one curve from the next.

    Columns are parted by commas, semicolons, tabs or blanks; rows that start with # are remarks, and the
    first row may be a heading. With semicolons, or with tabs, decimals may have commas. A third column is
    taken when it is constant: points of a plane z = const. A heading that names x and y among its columns says
    which they are, and their unit, "x (in)", "y [mm]" or "x_mm", unless `unit` does. One that names a column
    "distance" or "station" is of a table of offsets: every other column is a curve over that one, called as the
    column is. Cells may be fractions, "3 1/2", or feet, inches and eighths, "3-4-5"; where no unit is named those
    tell that it is inches.

    Raises
    ------
    InputError
        A row that is not two or three finite numbers, which is named; too few points; a heading with two units.
    """
    check_tolerance(fit_tolerance, "tolerance for fitting")
    text = _text(file)
    columns, named = _columns(text)
    rows = [row for _, column in columns for row in column]
    inches = [cell for _, cells in rows for cell in cells if is_in_inches(cell)]
    headed = unit or _one_unit(named)
    scale = look_up_unit(headed or ("in" if inches else "mm"))
    parts = max((int(cell.rpartition("/")[2]) for cell in inches if "/" in cell), default=8)  # of an inch
    rounded = (
        MM_PER_INCH / parts / 2 if inches else scale * half_last_place(re.findall(NUMBER, text)[:_DIGITS])
    )
    by_rule = scale == MM_PER_INCH or any(name for name, _ in columns)  # as fine as a rule is read
    noise = rounded / np.sqrt(3) if by_rule else 0.0
    blocks = [(name, block) for name, column in columns for block in _blocks(column, scale)]
    makers = [
        DrawnCurve(
            number,
            partial(_fitted, block, fit_tolerance, Provenance(rounding=rounded, name=name), noise),
            name,
        )
        for number, (name, block) in enumerate(blocks, start=1)
    ]
    told = note(
        "its numbers were read as inches, with fractions or as feet-inches-eighths: give the unit if they are none"
    )
    return DrawnFile(file, makers, size=told if inches and headed is None else "")


def _fitted(points: FloatArray, tolerance: float, digits: Provenance, noise: float) -> PlaneCurve:
    check_size(points)
    check_count(len(points), 4 * MOST_PIECES, "points in one curve", "leave some out")
    return curve_from_points(points, tolerance=tolerance, drawn=digits, noise=noise)


def read_text_drawing(file: Path, *, unit: str | None) -> DrawnFile:
    """Read a control point file: its first line is "degree count", then come `count` lines "x y".

    Its knots are the whole numbers from -degree to count: a uniform spline, not clamped at its ends.

    Raises
    ------
    InputError
        A first line that does not say degree and count, or other than `count` good points after it.
    """
    scale = look_up_unit(unit or "mm")
    rows = [(n, line.split()) for n, line in enumerate(_text(file).splitlines(), 1) if line.strip()]
    rows = [(n, row) for n, row in rows if not row[0].startswith("#")]
    if not rows:
        raise InputError("there are no numbers in it: the first line must be 'degree count'")
    number, head = rows[0]
    if len(head) != 2 or not all(re.fullmatch(r"\d+", word) for word in head):
        raise InputError(
            "line {number} is {given}; it must be two whole numbers, degree and count of control "
            "points (measured points belong into a .csv file)",
            number=number,
            given=quoted(" ".join(head)),
        )
    if max(len(word) for word in head) > 9:
        raise InputError(
            "line {number} has a number of {most} digits: it cannot be meant",
            number=number,
            most=max(len(w) for w in head),
        )
    degree, count = check_degree(int(head[0])), int(head[1])
    check_count(count, 4 * MOST_PIECES, "control points", "leave some out")
    if len(rows) - 1 != count:
        raise InputError(
            "line {number} announces {count} control points, but {given} lines follow",
            number=number,
            count=count,
            given=len(rows) - 1,
        )
    points = np.array([_numbers(row, n, 2, scale) for n, row in rows[1:]]).reshape(-1, 2)
    check_size(points)
    digits = Provenance(rounding=scale * half_last_place([word for _, row in rows[1:] for word in row]))
    knots = np.arange(-degree, count + 1, dtype=float)
    curve = PlaneCurve(knots, points, degree, provenance=digits)
    return DrawnFile(file, [DrawnCurve(1, lambda: curve)])


def _text(path: Path) -> str:
    """The file as text, with or without a byte order mark."""
    data = path.read_bytes()
    encoding = "utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    try:
        return data.decode(encoding).replace(_MINUS, "-")
    except UnicodeDecodeError as error:
        raise InputError("is not a text file: save the points as plain text") from error


_Rows = list[tuple[int, list[str]]]


def _columns(text: str) -> tuple[list[tuple[str, _Rows]], tuple[str, ...]]:
    """Name of each curve, number and coordinates of its rows (none where they part blocks); a heading's units."""
    lines = [line.strip() for line in text.splitlines()]
    rows = [(n, _cells(line)) for n, line in enumerate(lines, 1) if not line.startswith("#")]
    first = next((k for k, (_, cells) in enumerate(rows) if any(cells)), 0)
    if not rows or any(_is_number(cell) for cell in rows[first][1]):
        return [("", rows)], ()
    head = _cells(re.sub(r"\s+(?=[\[(])", "", lines[rows[first][0] - 1]))  # where blanks part columns
    heads = {
        found[1].lower(): (k, found[2] or found[3], found[1])
        for k, cell in enumerate(head)
        if (found := _HEAD.fullmatch(cell))
    }
    rows = rows[first + 1 :]
    along = next((heads[name] for name in ALONG if name in heads), None)
    if {"x", "y"} <= heads.keys():
        taken = [heads[name] for name in ("x", "y", "z") if name in heads]
        last = max(k for k, *_ in taken)
        rows = [(n, [cells[k] for k, *_ in taken] if len(cells) > last else cells) for n, cells in rows]
        columns = [("", rows)]
    elif along is not None:
        taken = [one for name, one in heads.items() if name not in ALONG]
        tried = [(name, _offsets(rows, along[0], k)) for k, _, name in taken]
        columns = [(name, column) for name, column in tried if any(_is_number(y) for _, (_, y) in column)]
        taken = [along, *taken]
    else:
        return [("", rows)], ()
    return columns, tuple(unit.lower() for _, unit, _ in taken if unit)


def _offsets(rows: _Rows, along: int, column: int) -> _Rows:
    """The rows of two columns in which a curve has a place."""
    far = max(along, column)
    return [(n, [cells[along], cells[column]]) for n, cells in rows
            if len(cells) > far and cells[column] not in NOTHING]  # fmt: skip


def _one_unit(named: tuple[str, ...]) -> str | None:
    """The unit that a heading names; None where it names none."""
    if len(set(named)) > 1:
        raise InputError(
            "its heading names {names}: give x and y in one unit", names=" and ".join(dict.fromkeys(named))
        )
    return named[0] if named else None


def _blocks(rows: _Rows, scale: float) -> list[FloatArray]:
    """The points (n, 2) of each block of rows, mm."""
    blocks: list[list[FloatArray]] = [[]]
    for n, cells in rows:
        if not any(cells):
            if blocks[-1]:
                blocks.append([])
            continue
        blocks[-1].append(_numbers(cells, n, 3, scale))
    filled = [np.array(block) for block in blocks if block]
    if not filled:
        raise InputError("there are no points in it: write one 'x, y' a row")
    for block in filled:
        height = np.ptp(block[:, 2])
        if height > 1e-6 * max(1.0, float(np.ptp(block[:, :2], axis=0).max())):
            raise InputError(
                "the third column runs over {height:.4g}: only curves in a plane z = const are read; "
                "turn the points into the xy plane",
                height=Length(height),
            )
    return [block[:, :2] for block in filled]


def _cells(line: str) -> list[str]:
    """The cells of one row, without quotes; a trailing separator adds none."""
    parts = line.split('"')
    parting = next((sign for sign in ";\t," if any(sign in part for part in parts[::2])), None)
    if parting is None:
        cells = "".join(parts).split()
    else:
        parts[::2] = [part.replace(parting, "\n") for part in parts[::2]]  # within quotes nothing parts cells
        cells = [cell.strip() for cell in "".join(parts).split("\n")]
    if parting != "," or len(parts) > 1:
        cells = [cell.replace(",", ".") for cell in cells]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _in_mm(cell: str, scale: float) -> float:
    """A cell, mm, whose unit is `scale` mm unless it is of feet, inches and eighths."""
    inches = read_offset(cell)
    return scale * read_number(cell) if inches is None else MM_PER_INCH * inches


def _is_number(cell: str) -> bool:
    try:
        _in_mm(cell, 1.0)
    except ValueError:
        return False
    return True


def _numbers(cells: list[str], row: int, most: int, scale: float) -> FloatArray:
    """x, y (and z, 0 where there is none, when `most` is 3) of one row, mm."""
    if not 2 <= len(cells) <= most:
        raise InputError(
            "row {row} has {count} columns; it needs x and y{given}",
            row=row,
            count=len(cells),
            given=" (and z)" if most == 3 else "",
        )
    for cell in cells:
        if not _is_number(cell):
            raise InputError(
                "row {row} has {cell!r} where a number is needed: write digits alone, 12.5, or # "
                "before a remark",
                row=row,
                cell=cell,
            )
    values = np.array([_in_mm(cell, scale) for cell in cells])
    if not np.all(np.isfinite(values)):
        raise InputError(
            "row {row} is not finite ({cells}): leave it out or mend it", row=row, cells=", ".join(cells)
        )
    return np.append(values, [0.0] * (most - len(values)))
