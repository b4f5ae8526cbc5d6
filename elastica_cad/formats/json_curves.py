"""Exact JSON files of curves: knots, control points, degree and weights, in mm."""

import json
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad._units import look_up_unit
from elastica_cad._values import require_record, several
from elastica_cad.errors import InputError, quoted
from elastica_cad.formats.drawn_file import DrawnCurve, DrawnFile, ReadUnit
from elastica_cad.formats.source_file import MOST_PIECES, check_count, check_degree, check_size
from elastica_cad.geometry.plane_curve import PlaneCurve

CURVES_SCHEMA = "elastica-curves/1"


def curve_record(curve: PlaneCurve) -> dict[str, Any]:
    """Return the curve as a dict for JSON, without rounding. `weights` is None for a polynomial spline."""
    require_record(curve, PlaneCurve, "a curve to write", "a PlaneCurve")
    return {
        "degree": curve.degree,
        "knots": curve.knots.tolist(),
        "control_points": curve.control_points.tolist(),
        "weights": None if curve.weights is None else curve.weights.tolist(),
    }


def curves_json(curves: Sequence[PlaneCurve], **more: Any) -> str:
    """Return the text of a JSON file of curves, from which `read_json_drawing` reads equal curves.

    `more` are records for JSON that the file has besides.
    """
    data = {
        "schema": CURVES_SCHEMA,
        "units": "mm",
        "curves": [curve_record(curve) for curve in several("curves", curves, PlaneCurve, "PlaneCurve")],
        **more,
    }
    return json.dumps(data, indent=1) + "\n"


def read_json_drawing(file: Path, *, unit: str | None = None, **_: Any) -> DrawnFile:
    """Read the curves of a JSON file: a file written by `curves_json`, or the report of a strip."""
    try:
        data = json.loads(file.read_bytes())
    except RecursionError as error:
        raise InputError("has lists or records nested too deeply: give a file that elastica wrote") from error
    except ValueError as error:  # an integer of thousands of digits raises ValueError too
        raise InputError(
            "is not JSON ({partition}): export the file again", partition=str(error).partition(";")[0]
        ) from error
    if not isinstance(data, dict):
        raise InputError(
            "has no record with the schema {curves_schema!r}: give a file that elastica wrote",
            curves_schema=CURVES_SCHEMA,
        )
    schema = data.get("schema")
    name, _slash, version = str(schema).partition("/")
    if name not in ("elastica-curves", "elastica-report"):
        raise InputError(
            "has the schema {schema}, but curves are read only from {curves_schema!r} and from reports of "
            "strips: give a file of one of these kinds",
            schema=quoted(schema),
            curves_schema=CURVES_SCHEMA,
        )
    if version != "1":
        raise InputError(
            "has the schema {schema}, which is newer than this program: update the program",
            schema=quoted(schema),
        )
    unit_name = data.get("units", "mm")
    stated = str(unit_name.get("length", "mm") if isinstance(unit_name, dict) else unit_name)
    scale = look_up_unit(unit or stated)
    known = ReadUnit.requested(unit) if unit else ReadUnit(stated, "stated", "units")
    curves = [data["curve"]] if "curve" in data else data.get("curves")
    if not isinstance(curves, list) or not curves:
        raise InputError("has no list of curves: add the list 'curves', with a record for each curve")
    drawn = []
    for i, record in enumerate(curves, start=1):
        make = partial(_curve, record, "curve" if "curve" in data else f"curve {i}", scale)
        drawn.append(DrawnCurve(i, make, kinds={"spline": 1}))
    return DrawnFile(file, drawn, unit=known)


def _curve(record: Any, where: str, scale: float) -> PlaneCurve:
    """Return the curve of a record. `where` names the record in errors, and `scale` is the unit, mm."""
    if not isinstance(record, dict):
        raise InputError(
            "{place} is not a curve: write a record of degree, knots, control_points and weights", place=where
        )
    for key in ("degree", "knots", "control_points"):
        if key not in record:
            raise InputError("{place} has no {key!r}: add this key", place=where, key=key)
    degree = record["degree"]
    if not isinstance(degree, int) or isinstance(degree, bool):
        raise InputError(
            "{place}: degree is {degree}: write a whole number", place=where, degree=quoted(degree)
        )
    try:
        knots = np.array(record["knots"], dtype=float)
        points = np.array(record["control_points"], dtype=float)
        weights = None if record.get("weights") is None else np.array(record["weights"], dtype=float)
    except (TypeError, ValueError, OverflowError, RecursionError) as error:
        raise InputError(
            "{place} has an entry that is not a number: write only numbers", place=where
        ) from error
    if points.ndim != 2 or points.shape[1] != 2:
        raise InputError("{place}: control_points are not points: write rows of x and y", place=where)
    try:
        check_count(len(points), 4 * MOST_PIECES, "control points", "leave some out")
        check_degree(degree)
        check_size(scale * points)
        return PlaneCurve(knots, scale * points, degree, weights)
    except InputError as error:
        raise InputError("{place}: {error}", place=where, error=error) from error
