"""Strips that nothing was fitted to: curves, widths and places drawn by a seed, bent in space.

Plywood counts with an E across of 0.3 of that along, which no strip of ours knows.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from elastica_cad import Strip
from elastica_cad.mechanics import ThicknessLaw
from tests.campaign.finite_elements.bent_strip import bend_cut_strip
from tests.campaign.finite_elements.drawn_requests import E, requests_drawn, tab_requests
from tests.campaign.finite_elements.tapered import bend_tapered

__all__ = ["Drawn", "strips_drawn", "tabs_drawn"]

ACROSS = 0.3


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


def strips_drawn(folder: Path, wanted: str = "") -> Iterator[Drawn]:
    """All of them, as the stiffness alone asks; those whose widths can make up for the rest, so too."""
    for name, spec in requests_drawn():
        if wanted not in name:
            continue
        if isinstance(spec.section, ThicknessLaw):
            strip = spec.make()
            yield _row(name, strip, bend_tapered(name, spec, folder).strayed * strip.rod.length, 0)
            continue
        for compensate in (False,) if spec.section is not None else (False, True):
            strip = spec.changed(compensate=compensate).make()
            across = ACROSS * E if strip.sheet.shear_modulus else None
            size = 3.0 if "perforated" in name else 4.0
            bent = bend_cut_strip(strip, folder, size=size, across=across)
            more = ", made up for" if compensate else ""
            yield _row(name + more, strip, bent.deviation, len(bent.body.nodes))


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
