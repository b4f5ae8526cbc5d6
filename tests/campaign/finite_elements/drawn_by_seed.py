"""Strips that nothing was fitted to: curves, widths and places drawn by a seed, bent in space.

Plywood counts with an E across of 0.3 of that along, which no strip of ours knows.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
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
    Strip,
    StripSpec,
    Tab,
    optimal_rod,
)
from elastica_cad.mechanics import LeavesLaw, ThicknessLaw
from tests.campaign.finite_elements.bent_strip import bend_cut_strip
from tests.campaign.finite_elements.tapered import WIDTH, bend_tapered

__all__ = ["SEED", "Drawn", "requests_drawn", "strips_drawn", "tab_requests", "tabs_drawn"]

SEED = 541126
LENGTH = 300.0
E, ACROSS = 9000.0, 0.3
TAB_SHARES = (0.2, 0.35, 0.5)
"""Widths of tabs over those of the strip's ends."""


@dataclass(frozen=True)
class Drawn:
    """One strip; lengths in mm, the rest as shares of the length.

    Attributes
    ----------
    strayed : float
        By finite elements.
    told, open, sheet : float
        What our own model says, what it says that it leaves open, and what an assumed sheet adds.
    """

    name: str
    length: float
    widest: float
    nodes: int
    strayed: float
    told: float
    open: float
    sheet: float


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
        asked: dict[str, Any] = {"max_width": width}
        if kind == "perforated":
            outer = 1.5 * width
            asked = {"max_width": outer / 3, "style": Perforated(width=outer, columns=2, rows=9, least_ligament=0.2,
                                                                 least_hole=0.2)}  # fmt: skip
        elif kind == "laminated":
            sheet = _sheet(plywood=plywood, thickness=0.5)
            asked = {"max_width": 0.4 * width, "style": Laminated(width=width / 2, backing=sheet, dots=0.0)}
        elif kind == "tapered":
            asked = {"law": ThicknessLaw(sheet, 0.2, 2.0, width=WIDTH)}
        elif kind == "leaves":
            sheet = _sheet(plywood=plywood, thickness=0.6)
            asked = {"law": LeavesLaw(sheet, 4, 20.0), "keep": Keep()}
        elif kind == "slotted":
            places = np.sort(rng.uniform(0.2, 0.8, 2)) * LENGTH
            asked["slots"] = tuple(
                Slot(float(at), width=1.0, side=side)
                for at, side in zip(places, ("upper", "lower"), strict=True)
            )
        elif kind == "tabbed":
            asked["ends"] = tuple(Tab(12.0, width=float(one)) for one in rng.uniform(8.0, 13.0, 2))
        yield f"{kind}, {sheet.name}", StripSpec(curve, sheet, ignore_limits=True, **asked)


def strips_drawn(folder: Path, wanted: str = "") -> Iterator[Drawn]:
    """All of them, as the stiffness alone asks; those whose widths can make up for the rest, so too."""
    for name, spec in requests_drawn():
        if wanted not in name:
            continue
        if isinstance(spec.law, ThicknessLaw):
            strip = spec.make()
            yield _row(name, strip, bend_tapered(name, spec, folder).strayed * strip.rod.length, 0)
            continue
        for compensate in (False,) if spec.law is not None else (False, True):
            strip = spec.changed(compensate=compensate).make()
            across = ACROSS * E if strip.sheet.shear_modulus else None
            size = 3.0 if "perforated" in name else 4.0
            bent = bend_cut_strip(strip, folder, size=size, across=across)
            more = ", made up for" if compensate else ""
            yield _row(name + more, strip, bent.deviation, len(bent.body.nodes))


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


def tabs_drawn(folder: Path) -> Iterator[Drawn]:
    """Strips with narrow tabs, as the stiffness alone asks."""
    for name, spec in tab_requests():
        strip = spec.make()
        bent = bend_cut_strip(
            strip, folder, size=3.0, across=ACROSS * E if strip.sheet.shear_modulus else None
        )
        yield _row(name, strip, bent.deviation, len(bent.body.nodes))


def _row(name: str, strip: Strip, strayed: float, nodes: int) -> Drawn:
    held, length = strip.held(), strip.rod.length
    shares = (one / length for one in (strayed, held.deviation, held.open, held.sheet_adds))
    return Drawn(name, length, strip.width.extremes[1], nodes, *shares)
