"""Curves from plain numbers: measured points (CSV) and the control points of a uniform spline (text)."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH, is_in_inches, look_up_unit
from elastica_cad.errors import InputError, quoted
from elastica_cad.formats.curve_files.chains import curve_from_points
from elastica_cad.formats.curve_files.drawn_file import DrawnCurve, DrawnFile
from elastica_cad.formats.curve_files.number_gate import (
    MOST_PIECES,
    check_count,
    check_degree,
    check_size,
    check_tolerance,
    half_last_place,
)
from elastica_cad.formats.curve_files.point_tables import PointTable, Row, read_row, read_text
from elastica_cad.formats.curve_files.read_report import ReadUnit
from elastica_cad.formats.file_access.source_file import name_source
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.refusals import Length, note

RULER_MM = 0.25  # rounding, mm, as of a ruler with half millimetres: such points were measured by hand
_DIGITS = 20_000  # numbers whose digits are looked at


def read_csv_drawing(file: Path, *, fit_tolerance: float, unit: str | None) -> DrawnFile:
    """Fit curves to measured points, one "x, y" a row; blank rows part one curve from the next.

    Columns are parted by commas, semicolons, tabs or blanks, or by the sign that Excel's `sep=;` names. Rows that
    start with # are remarks. Titles, a heading and a row of units may be above the numbers. Decimals may have
    commas where those part no columns, or in quotes. A third column is taken when it is constant: points of a plane
    z = const.

    A heading that names x and y (or Easting and Northing) among its columns selects them, several times for
    several curves. It names their unit unless `unit` does: "x (in)", "y [mm]", "x_mm", "x in inches". A heading
    with a column "distance" or "station" is of a table of offsets: every other column is a curve over that one,
    called as the column is. Cells may be fractions, "3 1/2", feet and inches, 3' 4 5/8", or feet, inches and
    eighths, "3-4-5"; where no unit is named, they are inches.

    Raises
    ------
    InputError
        A row that is not two or three finite numbers, which is named; too few points; a heading with two units.
    """
    check_tolerance(fit_tolerance, "tolerance for fitting")
    table = PointTable.read(file, unit=unit)
    cells = [cell for column in table.columns for _, row in column.rows for cell in row]
    inches = [cell for cell in cells if is_in_inches(cell)]
    scale = look_up_unit(table.unit or ("in" if inches else "mm"))
    parts = [int(found[1]) for cell in inches if (found := re.search(r"/(\d+)", cell))]  # of an inch
    parts += [8 for cell in inches if cell.count("-") > 1]
    rounded = MM_PER_INCH / max(parts) / 2 if parts else scale * half_last_place(cells[:_DIGITS])
    by_rule = scale == MM_PER_INCH or table.is_offsets or rounded >= RULER_MM
    noise = rounded / np.sqrt(3) if by_rule else 0.0
    makers: list[tuple[str, int, Callable[[], PlaneCurve]]] = []
    for name, rows in table.columns:
        try:
            blocks = _blocks(rows, scale)
        except InputError as problem:
            if len(table.columns) == 1:
                raise
            makers.append((name, 0, partial(_raise, problem)))
            continue
        digits = Provenance(rounding=rounded, name=name)
        makers += [
            (name, len(block), partial(_fitted, block, fit_tolerance, digits, noise)) for block in blocks
        ]
    told = note(
        "its numbers were read as inches, with fractions or as feet-inches-eighths: give the unit if they are none"
    )
    curves = [
        DrawnCurve(number, make, name, kinds={"point": count})
        for number, (name, count, make) in enumerate(makers, start=1)
    ]
    if table.unit:
        known = ReadUnit.requested(unit) if unit else ReadUnit(table.unit, "stated", note("the heading"))
    else:
        known = ReadUnit("in", "guessed", note=told) if inches else ReadUnit("mm")
    return DrawnFile(file, curves, unit=replace(known, note=table.note or known.note))


def read_path_points(file: Path) -> FloatArray:
    """Read the points (n, 3), mm, of a path in space from a table with x, y and z, as `read_csv_drawing` does.

    Raises
    ------
    InputError
        A row without three finite numbers, which is named.
    """
    with name_source(file):
        table = PointTable.read(file, unit=None)
        scale = look_up_unit(table.unit or "mm")
        rows = [row for column in table.columns for row in column.rows if row[1]]
        return np.array([read_row(cells, n, 3, 3, scale) for n, cells in rows]).reshape(-1, 3)


def _raise(problem: InputError) -> PlaneCurve:
    raise problem


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
    rows = [(n, line.split()) for n, line in enumerate(read_text(file).splitlines(), 1) if line.strip()]
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
    points = np.array([read_row(row, n, 2, 2, scale) for n, row in rows[1:]]).reshape(-1, 2)
    check_size(points)
    digits = Provenance(rounding=scale * half_last_place([word for _, row in rows[1:] for word in row]))
    knots = np.arange(-degree, count + 1, dtype=float)
    curve = PlaneCurve(knots, points, degree, provenance=digits)
    known = ReadUnit.requested(unit) if unit else ReadUnit("mm")
    return DrawnFile(file, [DrawnCurve(1, lambda: curve, kinds={"spline": 1})], unit=known)


def _blocks(rows: Sequence[Row], scale: float) -> list[FloatArray]:
    """The points (n, 2) of each block of rows, mm."""
    blocks: list[list[FloatArray]] = [[]]
    for n, cells in rows:
        if not any(cells):
            if blocks[-1]:
                blocks.append([])
            continue
        values = read_row(cells, n, 2, 3, scale)
        blocks[-1].append(np.array([*values, 0.0][:3]))
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
