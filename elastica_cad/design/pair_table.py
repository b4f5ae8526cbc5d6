"""The table [pair] of a design file: a part with two rest shapes."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from elastica_cad.design.design_file import own_sheets, parse_design
from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.model_tables import DesignKeys
from elastica_cad.design.records import CurveReader, Reader, fields_of, names_of
from elastica_cad.design.strip_table import SHARED
from elastica_cad.design.tables import Table, merged
from elastica_cad.errors import InputError
from elastica_cad.formats.source_file import require_file
from elastica_cad.pairs.flexure import STATES
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.refusals import Listed


def read_pair(
    path: Path, read_curves: CurveReader, changes: Mapping[str, Any] = MappingProxyType({})
) -> FlexureSpec:
    """Read the request for a two-state part from the table [pair]. `changes` has new values for keys."""
    table = parse_design(require_file(path))
    return pair_of(merged(table, {"pair": changes}) if changes else table, path, read_curves)


def read_cutting(path: Path, changes: Mapping[str, Any]) -> Cutting:
    """Read the options of cutting files from a design file. `changes` has new values for keys."""
    table = parse_design(require_file(path))
    return cutting_of(merged(table, {"cut": changes}), str(path))


def cutting_of(data: Mapping[str, Any], where: str = "") -> Cutting:
    """Make the options of cutting files from the table [cut] of parsed tables. `where` is the name of the file."""
    cutting: Cutting = Reader().record(Cutting, Table(data, where, {}).table("cut"))
    return cutting


def pair_of(data: Mapping[str, Any], path: Path, read_curves: CurveReader) -> FlexureSpec:
    """Make the request for a two-state part from the parsed tables of the file `path`."""
    top = Table(data, str(path), {}).only(*names_of(DesignKeys))
    if not top.has("pair"):
        raise InputError(
            "{path} has no table [pair], so it does not describe a part with two states. Add this table, or "
            "run `elastica model` for a model of strips.",
            path=path,
        )
    top.scope = top.within(top.raw("let", {}))
    pair = top.table("pair")
    curves = {state: pair.raw(state) for state in STATES}
    ids = {state: curve["id"] for state, curve in curves.items() if isinstance(curve, dict) and "id" in curve}
    own = {entry.name: entry.kind for entry in fields_of(FlexureSpec)}
    given = [entry for entry in fields_of(DesignKeys) if entry.name in SHARED and top.has(entry.name)]
    idle = [entry.name for entry in given if own.get(entry.name) != entry.kind]
    if idle and not top.has("strips"):
        raise InputError(
            "{place} has no effect on a part with two states. Leave out {keys}, or write them below [pair].",
            place=top.place(idle[0]),
            keys=Listed(idle),
        )
    defaults = {entry.name: top.raw(entry.name) for entry in given if entry.name not in idle}
    if len(set(ids.values())) == len(ids):
        defaults |= {f"{state}_state": name for state, name in ids.items()}
    pair.defaults = Table(defaults, pair.where, pair.scope)
    spec: FlexureSpec = Reader(own_sheets(top, path), path.parent, cache(read_curves)).record(
        FlexureSpec, pair
    )
    return spec
