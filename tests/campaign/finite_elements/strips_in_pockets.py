"""Strips in pockets with play: finite elements against what our own rod says."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from elastica_cad import Strip
from elastica_cad.strip import TabSeat
from tests.campaign.finite_elements.bent_strip import flat_body, middle_line, on_curve
from tests.campaign.finite_elements.calculix import Material
from tests.campaign.finite_elements.cases import CASES
from tests.campaign.finite_elements.pockets import solve_in_pockets
from tests.pavilion import pavilion

__all__ = ["Held", "held_in_pockets", "strips_in_pockets", "strips_of_the_pavilion"]

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


def strips_of_the_pavilion(folder: Path) -> Iterator[Held]:
    """Three strips of the paper's Pavilion, slots and weight and all."""
    slotted = pavilion(max(PAVILION) + 1).interlock(clearance=0.1)
    for number in PAVILION:
        yield held_in_pockets(slotted.strips[number - 1], folder, name=f"Pavilion {number}", size=4.0)


def held_in_pockets(strip: Strip, folder: Path, *, name: str, size: float = SIZE_MM) -> Held:
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
        play=PLAY_MM,
        gravity=None if falls is None else (falls[0], 0.0, falls[1]),
    )
    strayed = body.nodes + answer.displacement - on_curve(curve, body.nodes)
    _, middle = middle_line(body, strayed, length)
    seat = TabSeat.pocket(length=depth, thickness=sheet.thickness, clearance=PLAY_MM)
    return Held(name, length, float(np.hypot(*middle.T).max()), strip.held(seat, seat).deviation)
