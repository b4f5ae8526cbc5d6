"""Conversion between a design file and the tables that the studio's page edits."""

from collections.abc import Mapping, Sequence
from functools import cache
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.design.design_file import design_of, parse_design
from elastica_cad.design.pair_table import pair_of
from elastica_cad.design.records import CurveReader, idle_keys
from elastica_cad.design.strip_table import StripKeys
from elastica_cad.design.tables import Table
from elastica_cad.design.toml_text import is_tables
from elastica_cad.errors import InputError
from elastica_cad.files import read_curves
from elastica_cad.formats.source_file import read_below, require_file
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.pairs.flexure_spec import FlexureSpec

Tables = dict[str, Any]

OF_MODELS = ("patterns", "interlock", "base", "rings", "frame", "fixtures", "stand", "extras", "revolution")
"""Tables of a design that only models need."""

STARTS = ("pavilion", "revolution")
"""Designs of `elastica new` that need no other files. The page offers these designs as templates."""


def open_design(path: Path) -> Tables:
    """Return the tables of a design file, with curves as editable splines."""
    with read_below(path.parent, Path()):
        return drawable(parse_design(path), path, cache(read_curves))


def file_mark(path: Path | None) -> str:
    """Return a digest of the contents of a file, or "" if there is no file."""
    if path is None or not path.exists():
        return ""
    return sha256(require_file(path).read_bytes()).hexdigest()


def start_designs() -> dict[str, Tables]:
    """Return the designs that the page offers as templates, by name."""
    folder = Path(str(files("elastica_cad.cli").joinpath("templates")))
    return {name: parse_design(folder / f"{name}.toml") for name in STARTS}


def without_models(tables: Mapping[str, Any]) -> Tables:
    """Return the tables of a design without those that only models need."""
    return without_keys(tables, OF_MODELS)


def idle_beside(design: Mapping[str, Any], k: int = 0) -> list[str]:
    """Return the keys without effect beside others: of the pair or of strip k, and of the top of the design."""
    pair = design.get("pair")
    record, table = (FlexureSpec, pair) if isinstance(pair, Mapping) else (StripKeys, design["strips"][k])
    return list(idle_keys(record, Table(table, "", {}, Table(design, "", {}))))


def without_idle(design: Mapping[str, Any]) -> Tables:
    """Return the tables of a design without the keys that have no effect beside others.

    The page keeps the values of such keys, and files with them are refused.

    Examples
    --------
    >>> without_idle({"max_width": 30, "strips": [{"section": {"kind": "rod"}, "min_width": 4}]})
    {'strips': [{'section': {'kind': 'rod'}}]}
    """
    strips, pair = design.get("strips"), design.get("pair")
    if isinstance(pair, Mapping):
        return {**design, "pair": without_keys(pair, idle_beside(design))}
    if not strips or not isinstance(strips, list):
        return {**design}
    idle = [idle_beside(design, k) for k in range(len(strips))]
    top = {key: value for key, value in design.items() if not all(key in keys for keys in idle)}
    return top | {"strips": [without_keys(strip, keys) for strip, keys in zip(strips, idle, strict=True)]}


def without_keys(table: Mapping[str, Any], keys: Sequence[str]) -> Tables:
    """Return a table without some of its keys."""
    return {key: value for key, value in table.items() if key not in keys}


def drawable(tables: Tables, path: Path, read_curves: CurveReader) -> Tables:
    """Convert the curves in the tables of a design to splines.

    `path` is the file of the design. `read_curves` reads the curve files that the design names.
    """
    if "pair" in tables:
        spec = pair_of(tables, path, read_curves)
        for state, curve in (("first", spec.first), ("second", spec.second)):
            if not _has_movable_points(tables["pair"][state]):
                tables["pair"][state] = curve_table(curve)
        return tables
    design_of(tables, path, read_curves)
    for k, strip in enumerate(tables.get("strips", [])):
        if several := strip.keys() & {"sections", "split"}:
            raise InputError(
                "{path}: the page cannot draw the strips of the key {key}. Run `elastica model`.",
                path=path,
                key=min(several),
            )
        if "count" in strip or _has_movable_points(strip["curve"]):
            continue
        (entry,) = design_of(without_models(tables) | {"strips": [strip]}, path, read_curves).entries
        tables["strips"][k] = strip | {"curve": curve_table(entry.curve)}
    return tables


def _has_movable_points(curve: object) -> bool:
    # control points as numbers can be dragged; formulae and deformed curves are first converted
    points = curve.get("spline") if isinstance(curve, Mapping) and "reshape" not in curve else None
    return isinstance(points, list) and all(
        isinstance(x, int | float) for point in points if isinstance(point, list) for x in point
    )


def curve_table(curve: PlaneCurve) -> Tables:
    """Return a curve as a table of a design file, without rounding.

    Examples
    --------
    >>> curve_table(PlaneCurve.spline([(0, 0), (5, 8), (10, 0)], degree=2))
    {'spline': [[0.0, 0.0], [5.0, 8.0], [10.0, 0.0]], 'degree': 2}
    """
    table: Tables = {"spline": curve.control_points.tolist(), "degree": curve.degree}
    if curve.is_rational or not np.array_equal(
        curve.knots, PlaneCurve.spline(curve.control_points, curve.degree).knots
    ):
        table["knots"] = curve.knots.tolist()
    return table if curve.weights is None else table | {"weights": curve.weights.tolist()}


def compose_design(tables: Mapping[str, Any], before: str = "") -> str:
    """Return the text of a design file with these tables.

    Comments of the text `before` are kept if possible.

    Examples
    --------
    >>> print(compose_design({"schema": 1, "max_width": 30}, "schema = 1\\nmax_width = 40  # of the laser's bed"))
    schema = 1
    max_width = 30  # of the laser's bed
    """
    import tomlkit

    document = tomlkit.parse(before)
    _update(document, tables)
    return tomlkit.dumps(document)


def _update(saved: Any, changes: Mapping[str, Any]) -> None:
    """Change the tables of a saved file to those of the page, in place, so that comments and order remain.

    Keys with the value None stay as they are.
    """
    for key in [key for key in saved if key not in changes]:
        del saved[key]
    for key, value in changes.items():
        if value is None or (key in saved and saved[key] == value):
            continue
        if isinstance(value, Mapping) and isinstance(saved.get(key), Mapping):
            _update(saved[key], value)
        elif is_tables(value) and is_tables(saved.get(key)) and len(value) == len(saved[key]):
            for entry, other in zip(saved[key], value, strict=True):
                _update(entry, other)
        else:
            saved[key] = value
