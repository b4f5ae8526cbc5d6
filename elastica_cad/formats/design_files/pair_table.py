"""The table [pair] of a design file: a part with two rest shapes."""

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any, get_args

from elastica_cad.fabrication.flexure import Pad
from elastica_cad.fabrication.flexure_spec import FlexureSpec, Match
from elastica_cad.formats.design_files.strip_table import CurveReader, read_drawn_curve
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.two_states.two_state_rod import Objective, PairLimits, State

LIMITS = tuple(one.name for one in fields(PairLimits))
PAD = tuple(one.name for one in fields(Pad))
KEYS = tuple(one.name for one in fields(FlexureSpec))
"""Of the table, with tables `limits` and `pad` inside; `first` and `second` are curves as those of a strip."""


def read_pair(data: Mapping[str, Any], path: Path, read_curves: CurveReader) -> FlexureSpec:
    """The request that a parsed design file makes in its table [pair].

    Raises
    ------
    InputError
        An unknown key, a value of the wrong kind, a curve that cannot be read; file and key are named.
    """
    table = Table(data["pair"], f"{path}: pair", {}).only(*KEYS)
    limits = table.table("limits").only(*LIMITS)
    pad = table.table("pad").only(*PAD)
    given: dict[str, Any] = {
        name: table.text(name, choices=get_args(kind))
        for name, kind in (("match", Match), ("free", State), ("objective", Objective), ("label", str))
        if table.has(name)
    }
    given |= {name: table.flag(name) for name in ("printed", "ignore_limits") if table.has(name)}
    given |= table.numbers("least_thickness", "fillet", "push_at")
    with table.naming():
        return FlexureSpec(
            first=_curve(table, "first", path, read_curves),
            second=_curve(table, "second", path, read_curves),
            sheet=Sheet.named(table.text("sheet"), folder=path.parent),
            limits=PairLimits(**limits.numbers(*LIMITS)),
            pad=Pad(**pad.numbers(*PAD)),
            **given,
        )


def _curve(table: Table, name: str, path: Path, read_curves: CurveReader) -> PlaneCurve:
    own = Table({"curve": table.raw(name)} if table.has(name) else {}, table.place(name), table.scope)
    return read_drawn_curve(own, path.parent, read_curves)
