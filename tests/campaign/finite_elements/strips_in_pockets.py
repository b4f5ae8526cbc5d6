"""Strips in pockets with play: finite elements against what our own rod says."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.strip.strip_record import Strip
from tests.campaign.finite_elements.bent_strip import bend_cut_strip, flat_body, middle_line, on_curve
from tests.campaign.finite_elements.calculix import Material
from tests.campaign.finite_elements.cases import CASES
from tests.campaign.finite_elements.pockets import solve_in_pockets
from tests.pavilion import pavilion

__all__ = ["Held", "held_in_pockets", "strips_in_pockets", "strips_posed"]

PAVILION = (3, 6, 12)
PLAY_MM = 0.15
SIZE_MM = 3.4
"""Three elements along a tab of 10 mm."""


@dataclass(frozen=True)
class Held:
    """How far a strip strays in its pockets, mm: by finite elements with contact, and as `Strip.held` says."""

    name: str
    length: float
    strayed: float
    told: float


def strips_in_pockets(folder: Path) -> Iterator[Held]:
    """Narrow strips of the bank in three curves."""
    for case in CASES:
        if case.group == "plain, nu 0" and case.name in ("arch", "bow", "S"):
            strip = replace(case.spec.make(), max_width=12.0)
            yield held_in_pockets(strip, folder, name=f"{case.name}, 12 mm wide")


def strips_posed(folder: Path) -> Iterator[Held]:
    """Three strips of the paper's Pavilion, slots and weight and all, with tabs where `Strip.held` has them.

    Card so thin and wide does not settle in the pockets themselves.
    """
    slotted = pavilion(max(PAVILION) + 1).interlock(clearance=0.1)
    for number in PAVILION:
        strip = slotted.strips[number - 1]
        seat = TabSeat.pocket(length=10.0, thickness=strip.sheet.thickness, play=PLAY_MM)
        told, falls = strip.held(seat, seat), strip.rod.gravity.direction
        bent = bend_cut_strip(strip, folder, size=4.0, gravity=(falls[0], falls[1]), curve=told.rod.curve)
        designed, found = (curve.at(bent.stations).position for curve in (strip.rod.curve, told.rod.curve))
        strayed = float(np.hypot(*(found + bent.strayed - designed).T).max())
        yield Held(f"Pavilion {number}, tabs led", strip.rod.length, strayed, told.deviation)


def held_in_pockets(
    strip: Strip, folder: Path, *, name: str, size: float = SIZE_MM, play: float = PLAY_MM
) -> Held:
    """A strip whose tabs lie in pockets as deep as they are long."""
    curve, sheet, length = strip.rod.curve, strip.sheet, strip.rod.length
    depth = min(tab.length for tab in strip.ends)
    body = flat_body(strip, folder, size=size)
    falls = None if strip.rod.gravity is None else strip.rod.gravity.direction
    answer = solve_in_pockets(
        body,
        Material(sheet.youngs_modulus, sheet.poisson_ratio, sheet.density),
        lambda points: on_curve(curve, points),
        length,
        folder,
        depth=depth,
        play=play,
        gravity=None if falls is None else (falls[0], 0.0, falls[1]),
    )
    strayed = body.nodes + answer.displacement - on_curve(curve, body.nodes)
    _, middle = middle_line(body, strayed, length)
    seat = TabSeat.pocket(length=depth, thickness=sheet.thickness, play=play)
    return Held(name, length, float(np.hypot(*middle.T).max()), strip.held(seat, seat).deviation)
