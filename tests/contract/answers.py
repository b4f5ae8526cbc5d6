"""What Python answers to a request, and when the answer of another front end is the same."""

import json
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest

from elastica_cad import ElasticaError, Strip, make_strip, save
from tests.contract.table import Request

LABEL = "S1"
CLOSE = 1e-9  # mm


@cache
def in_python(options: Request) -> Strip | ElasticaError:
    """The strip of the fields, or why there is none."""
    try:
        strip = make_strip(options.curve, options.material, label=LABEL, **options.fields)
        _ = strip.layers
    except ElasticaError as refusal:
        return refusal
    return strip


def assert_same_strip(made: Strip, strip: Strip) -> None:
    """All that is drawn of two strips, cuts and engraving, is the same; and creep, which is not drawn."""
    assert_same_strokes(strokes(made), strokes(strip))
    assert made.creep == strip.creep


def assert_same_files(folder: Path, strip: Strip) -> None:
    """The DXF file of every layer, in a folder that a command made, is as Python saves it of the strip."""
    for drawing in strip.drawings():
        (made,) = [path for path in folder.rglob("*.dxf") if path.stem.partition("_")[0] == drawing.name]
        save(drawing, folder / "in-python.dxf")
        assert_same_strokes(entities(made), entities(folder / "in-python.dxf"))
        (folder / "in-python.dxf").unlink()
    report = folder / f"{LABEL}.json"  # of a single strip; that of a model does not tell of creep
    if report.is_file():
        answer = json.loads(report.read_text(encoding="utf-8"))
        assert (answer["creep"] or {"factor": 0.0})["factor"] == strip.creep


def assert_same_strokes(made: "Strokes", expected: "Strokes") -> None:
    assert [kind for kind, _ in made] == [kind for kind, _ in expected]
    assert expected
    for (_, ours), (_, numbers) in zip(made, expected, strict=True):
        assert ours == pytest.approx(numbers, abs=CLOSE)


def same_refusal(refusal: ElasticaError, met: ElasticaError | str, words: Callable[[str], str] = str) -> bool:
    """Is what a front end says this refusal?

    An exception has the sentence; the command line adds its options, a design file the name of the strip. FreeCAD
    puts the sentence in other `words`.
    """
    sentence = words(str(refusal))
    return str(met) == sentence if isinstance(met, ElasticaError) else sentence in met


Strokes = list[tuple[str, np.ndarray]]
"""Layer and kind of every segment that is drawn, with its control points and other numbers."""


def strokes(strip: Strip) -> Strokes:
    return [
        (f"{one.layer} {type(segment).__name__}", np.array(_numbers(segment)))
        for drawing in strip.drawings()
        for one in drawing.strokes
        for segment in one.path.segments
    ]


def _numbers(value: Any) -> list[float]:
    if is_dataclass(value):
        return [number for one in fields(value) for number in _numbers(getattr(value, one.name))]
    if isinstance(value, list | tuple | np.ndarray):
        return [number for one in value for number in _numbers(one)]
    return [float(value)] if isinstance(value, float | int | np.number) else []


def entities(path: Path) -> Strokes:
    """The same of a DXF file."""
    found = []
    for entity in ezdxf.readfile(path).modelspace():
        values: list[float] = []
        for name in ("start", "end", "center", "radius", "start_angle", "end_angle"):
            if entity.dxf.hasattr(name):
                values += np.ravel(entity.dxf.get(name)).tolist()
        if entity.dxftype() == "SPLINE":
            values += [*np.ravel(entity.control_points), *entity.knots]
        if entity.dxftype() == "LWPOLYLINE":
            values += np.ravel(entity.get_points()).tolist()
        assert values, f"{entity.dxftype()} is not compared"
        found.append((f"{entity.dxf.layer} {entity.dxftype()}", np.array(values, dtype=float)))
    return found
