"""Requests for strips whose curves, widths and places are drawn by a seed. Nothing was fitted to them.

Only the core is needed here, so that tests on the oldest libraries can make these strips too.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from elastica_cad import (
    ElasticaError,
    Keep,
    Laminated,
    Perforated,
    PlaneCurve,
    Sheet,
    Slot,
    StripSpec,
    Tab,
    optimal_rod,
)
from elastica_cad.mechanics import LeavesLaw, ThicknessLaw

__all__ = ["TAPERED_WIDTH", "E", "requests_drawn", "tab_requests"]

SEED = 541126
LENGTH = 300.0
E = 9000.0
TAPERED_WIDTH = 8.0
TAB_SHARES = (0.2, 0.35, 0.5)
"""Widths of tabs over those of the strip's ends."""


def _sheet(*, plywood: bool, thickness: float = 0.8) -> Sheet:
    grain: dict[str, Any] = {"grain": "along", "shear_modulus": E / 15, "kind": "plywood"} if plywood else {}
    nu = 0.1 if plywood else 0.3
    return Sheet(
        "ply" if plywood else "even", thickness, E, 680.0, max_strain=0.05, poisson_ratio=nu, **grain
    )


def _curve(rng: np.random.Generator, ratio: float) -> PlaneCurve:
    """A curve that a strip of at most this ratio takes, of `LENGTH`."""
    while True:
        turns = rng.uniform(0.15, 0.75, 6) * (-1.0 if rng.random() < 0.3 else 1.0)
        turns[: rng.integers(0, 3)] *= -1.0
        angles = np.concatenate([[0.0], np.cumsum(turns)])
        steps = np.column_stack([np.cos(angles), np.sin(angles)]) * rng.uniform(0.8, 1.2, (7, 1))
        drawn = PlaneCurve.spline(np.vstack([np.zeros(2), np.cumsum(steps, axis=0)]))
        curve = drawn.transformed(np.diag([1.0, 1.0, drawn.length / LENGTH]))
        try:
            if optimal_rod(curve).ratio < ratio:
                return curve
        except ElasticaError:
            continue


def requests_drawn() -> Iterator[tuple[str, StripSpec]]:
    """The twelve, with their names."""
    rng = np.random.default_rng(SEED)
    for kind, plywood in (
        ("plain", False), ("plain", True), ("perforated", False), ("perforated", True), ("laminated", False),
        ("laminated", True), ("tapered", False), ("leaves", False), ("slotted", False), ("slotted", True),
        ("tabbed", False), ("tabbed", True),
    ):  # fmt: skip
        width = float(rng.uniform(22.0, 38.0))
        sheet, curve = _sheet(plywood=plywood), _curve(rng, 2.2)
        request: dict[str, Any] = {"max_width": width}
        if kind == "perforated":
            outer = 1.5 * width
            style = Perforated(width=outer, columns=2, rows=9, least_ligament=0.2, least_hole=0.2)
            request = {"max_width": outer / 3, "style": style}
        elif kind == "laminated":
            sheet = _sheet(plywood=plywood, thickness=0.5)
            request = {"max_width": 0.4 * width, "style": Laminated(width=width / 2, backing=sheet, dots=0.0)}
        elif kind == "tapered":
            request = {"section": ThicknessLaw(sheet, 0.2, 2.0, width=TAPERED_WIDTH)}
        elif kind == "leaves":
            sheet = _sheet(plywood=plywood, thickness=0.6)
            request = {"section": LeavesLaw(sheet, 4, 20.0), "keep": Keep()}
        elif kind == "slotted":
            places = np.sort(rng.uniform(0.2, 0.8, 2)) * LENGTH
            request["slots"] = tuple(
                Slot(float(at), width=1.0, side=side)
                for at, side in zip(places, ("upper", "lower"), strict=True)
            )
        elif kind == "tabbed":
            request["ends"] = tuple(Tab(12.0, width=float(one)) for one in rng.uniform(8.0, 13.0, 2))
        yield f"{kind}, {sheet.name}", StripSpec(curve, sheet, ignore_limits=True, **request)


def tab_requests() -> Iterator[tuple[str, StripSpec]]:
    """Return twelve strips with narrow tabs, and their names: two curves, three widths of tab, two sheets."""
    rng = np.random.default_rng(SEED + 1)
    for number in ("first", "second"):
        width, thickness = float(rng.uniform(30.0, 60.0)), float(rng.uniform(0.8, 2.5))
        curve = _curve(rng, 2.2)
        for plywood in (False, True):
            sheet = _sheet(plywood=plywood, thickness=thickness)
            spec = StripSpec(curve, sheet, max_width=width, ignore_limits=True, compensate=False)
            ends = spec.make().width([0.0, LENGTH])
            for share in TAB_SHARES:
                tabs = tuple(Tab(12.0, width=float(share * end)) for end in ends)
                yield f"{number} curve, {sheet.name}, {share:g} of the width", spec.changed(ends=tabs)
