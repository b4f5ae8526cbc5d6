"""Page for measurements of a bent strip, and reading of the measured values."""

import json
import tomllib
from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path as FilePath
from typing import Any

import numpy as np

from elastica_cad._toml import parse_toml
from elastica_cad.design.toml_text import toml_key
from elastica_cad.errors import InputError, toml_slip
from elastica_cad.geometry.path import Line, Path
from elastica_cad.geometry.plane_points import points_at
from elastica_cad.strip.drawing import ENGRAVE, MARK, Drawing, LayeredPath
from elastica_cad.strip.holding_template import MARKS, heights_of_marks
from elastica_cad.strip.lettering import Text, engravable
from elastica_cad.strip.measuring import (
    ANGLES,
    KINDS,
    LENGTHS,
    MEANINGS,
    READING_ERROR_MM,
    Measuring,
    row_label,
)

DRAWN_MM = (180.0, 60.0)
"""Largest width and height of the drawn strip, mm. The page with its text then fits A4."""

LETTER_MM, LINE_MM, TEXT_MM = 3.0, 6.0, 40.0
"""Letter height, line spacing, and position of the second column of the page, mm."""

ERRORS = {"reading_error": LENGTHS, "angle_error": ANGLES}
"""Quantities whose standard error (mm or degrees) a key in a file of measured values sets."""

WORDS = {
    "chord": "from end to end of the free part",
    "height_1": "from the chord to mark 1",
    "height_2": "from the chord to mark 2",
    "height_3": "from the chord to mark 3",
    "start_angle": "between the chord and the tab at the start (1)",
    "end_angle": "between the chord and the tab at the end (2)",
}


def read_measuring(path: FilePath) -> dict[str, Measuring]:
    """Read the quantities to measure from the report of a strip or a model.

    Returns
    -------
    dict of str to Measuring
        Quantities of each part of a model, by its name. In the report of a strip, the name is "".
    """
    has_elements = False
    try:
        report = json.loads(path.read_text(encoding="utf-8-sig"))
        records = (
            {part["name"]: part["measuring"] for part in report["parts"]}
            if "parts" in report
            else {"": report["measuring"]}
        )
        # a strip with rails, pins, ties or point forces has no quantities to measure
        has_elements = [*records.values()] == [None] and bool(report.get("between"))
        measured = {name: measuring_of(record) for name, record in records.items() if record is not None}
        if not measured:
            raise ValueError
        return measured
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
        if has_elements:
            raise InputError(
                "{path} is the report of a strip with rails, pins, ties or point forces, which cannot be compared "
                "yet. Use the report of a strip without them.",
                path=path,
            ) from error
        raise InputError(
            "{path} is not a report with quantities to measure. Use the .json file of `elastica strip` for an open "
            "strip, or of `elastica model` without --no-effects.",
            path=path,
        ) from error


def measuring_of(record: Mapping[str, Any]) -> Measuring:
    """Return the quantities to measure from their record in a report."""
    causes = {cause: tuple(map(_measures, changes)) for cause, changes in record["causes"].items()}
    measuring = Measuring(
        tuple(map(_number, record["marks"])),
        _measures(record["expected"]),
        _measures(record["uncertain"]),
        causes,
        tuple((_number(x), _number(y)) for x, y in record["shape"]),
        None if record.get("tips") is None else _number(record["tips"]),
        record.get("can_snap") is True,
    )
    # `read_measuring` reports a ValueError as a wrong file
    if not (
        causes.keys() <= MEANINGS.keys()
        and all(causes.values())
        and min(measuring.uncertain.values()) > 0
        and len(set(measuring.shape)) > 1
    ):
        raise ValueError
    return measuring


def _measures(readings: Mapping[str, Any]) -> dict[str, float]:
    # all lengths (mm) and angles (degrees) by the names of the quantities
    return {name: _number(readings[name]) for name in (*LENGTHS, *ANGLES)}


def _number(value: Any) -> float:
    if isinstance(value, bool) or not abs(value) <= 1e6:  # the largest length (mm) or angle (degrees)
        raise ValueError
    return float(value)


def read_readings(path: FilePath) -> tuple[dict[str, dict[str, float]], dict[str, float]]:
    """Return the measured values in a TOML file, by strip and quantity, and their standard errors.

    Keys before the first table are the errors, or values of a strip with the name "".
    """
    text = ""
    try:
        text = path.read_text(encoding="utf-8-sig")
        table = parse_toml(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(
            "{path} cannot be read: {error}; {toml_slip}",
            path=path,
            error=error,
            toml_slip=toml_slip(text, error),
        ) from error
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(
            "{path} cannot be read: {error}; name a readable file", path=path, error=error
        ) from error
    errors = {name: table.pop(name) for name in ERRORS if name in table}
    alone = {name: table.pop(name) for name in [*table] if not isinstance(table[name], dict)}
    readings = {"": alone, **table} if alone or not table else table
    strips_read = {strip: _readings_of(values, path) for strip, values in readings.items()}
    return strips_read, _readings_of(errors, path)


def _readings_of(values: Mapping[str, Any], path: FilePath) -> dict[str, float]:
    readings = {}
    for name, value in values.items():
        try:
            readings[name] = _number(value)
        except (TypeError, ValueError) as error:
            raise InputError(
                "{path}: {name} is not a number. Write a number.", path=path, name=name
            ) from error
    return readings


def blank_readings(measured: Mapping[str, Measuring]) -> str:
    """Return the text of a TOML file for the measured values, with a table for each strip of a model."""
    lines = [
        "# Replace the expected values by your readings, and delete the # at the start of these lines.",
        "# Lengths in mm, angles in degrees.",
        f"# reading_error = {READING_ERROR_MM}  # typical error of your ruler, mm",
        "# angle_error = 1.0  # typical error of your protractor, degrees",
    ]
    for strip, measuring in measured.items():
        lines += ["", f"[{toml_key(strip)}]"] if strip else []
        lines += [f"# {name} = {value:.1f}  # {WORDS[name]}" for name, value in measuring.expected.items()]
    return "\n".join(lines) + "\n"


def measuring_page(name: str, measuring: Measuring) -> Drawing:
    """Return a page with the bent strip, places to measure, expected values, and causes of differences."""
    position = np.array(measuring.shape)
    x, y = position[-1] - position[0]
    position = position @ (np.array([[x, -y], [y, x]]) / np.hypot(x, y))  # turn the chord level
    # make expected heights positive above the chord, because the report may use the opposite sign
    expected = np.array([measuring.expected[name] for name in LENGTHS[1:]])
    position = position if expected @ heights_of_marks(position) >= 0 else -position
    scale = float(np.min(DRAWN_MM / np.maximum(np.ptp(position, axis=0), DRAWN_MM)))
    points = (position - position.min(axis=0)) * scale
    marks = points_at(np.array(MARKS), np.linspace(0, 1, len(points)), points)
    chord = Path([Line(points[0], points[-1])])
    drawn = Path([Line(a, b) for a, b in pairwise(points)])
    crosses = [Path([Line(at - reach, at + reach)]) for at in marks for reach in np.diag([2.0, 2.0])]
    paths = (LayeredPath(ENGRAVE, drawn), *(LayeredPath(MARK, path) for path in (chord, *crosses)))
    texts = [Text((x + 2, y + 2), str(k), LETTER_MM) for k, (x, y) in enumerate(marks.tolist(), 1)]
    places = ", ".join(f"{place:.1f}" for place in measuring.marks)
    rows = [
        (engravable(name), "Measure the strip in its fixture."),
        ("Marks", f"1, 2 and 3 at {places} mm along the free part"),
        ("Signs", "Heights above the chord and angles of ends that rise from it are positive."),
        *(
            (
                row_label(measure),
                f"{value:.1f} +/- {KINDS[measure](measuring.uncertain[measure]):.1f} {WORDS[measure]}",
            )
            for measure, value in measuring.expected.items()
        ),
        ("Causes", "Compare your differences with those that each cause makes."),
    ]
    for cause, changes in measuring.causes.items():
        rows.append(("Cause", MEANINGS[cause].format(amount=1)))
        if len(changes) == 1:
            largest = sorted(changes[0].items(), key=lambda change: -abs(change[1]))[:3]
            differences = ", ".join(f"{row_label(key)} {KINDS[key](value):+.1f}" for key, value in largest)
            rows.append(("", f"Differences: {differences}"))
    for k, row in enumerate(rows, 2):
        texts += [
            Text((x, -LINE_MM * k), text, LETTER_MM)
            for x, text in zip((0.0, TEXT_MM), row, strict=True)
            if text
        ]
    return Drawing(f"{name}-measure", paths, tuple(texts))
