"""The table [pair] of a design file: a part with two rest shapes."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from elastica_cad.design.design_file import own_sheets, parse_design, top_table
from elastica_cad.design.kit_spec import Cutting, PairCutting
from elastica_cad.design.model_tables import share_keys
from elastica_cad.design.records import CurveReader, Reader
from elastica_cad.design.strip_table import SHARED
from elastica_cad.design.tables import Slips, Table
from elastica_cad.errors import InputError
from elastica_cad.formats.source_file import require_file
from elastica_cad.pairs.flexure import STATES
from elastica_cad.pairs.flexure_spec import FlexureSpec


def read_pair(path: Path, read_curves: CurveReader) -> FlexureSpec:
    """Read the request for a two-state part from the table [pair] of a design file."""
    return pair_of(parse_design(require_file(path)), path, read_curves)


def cutting_of(data: Mapping[str, Any], where: str = "") -> Cutting:
    """Make the options of cutting files from the table [cut] of parsed tables. `where` is the name of the file."""
    cutting: Cutting = Reader().record(PairCutting, Table(data, where, {}).table("cut"))
    return cutting


PAIR_FILE = ("schema", "name", "let", "sheets", "sheets_file", "pair", "cut")
"""Keys of a design file with a table [pair], in addition to the shared keys that this table uses."""


def pair_of(data: Mapping[str, Any], path: Path, read_curves: CurveReader) -> FlexureSpec:
    """Make the request for a two-state part from the parsed tables of the file `path`."""
    slips = Slips()
    top = top_table(data, path, slips)
    slips.refuse()
    if not top.has("pair"):
        raise InputError(
            "{path} has no table [pair], so it does not describe a part with two states. Add this table, or "
            "run `elastica model` for a model of strips.",
            path=path,
        )
    pair = top.table("pair")
    reader = Reader(own_sheets(top, path), path.parent, cache(read_curves))
    others = [key for key in top.data if key not in (*SHARED, *PAIR_FILE)]
    share_keys(top, {"a part with two states": (FlexureSpec, pair)}, reader, others)
    # states without names are called by the ids of their curves, if these differ
    curves = {state: pair.raw(state) for state in STATES}
    ids = {state: curve["id"] for state, curve in curves.items() if isinstance(curve, dict) and "id" in curve}
    if len(set(ids.values())) == len(ids):
        names = {f"{state}_state": name for state, name in ids.items()}
        pair.defaults = Table(names, pair.where, pair.scope, pair.defaults)
    spec: FlexureSpec = reader.record(FlexureSpec, pair)
    return spec
