"""Does a bent strip leave the plane of its curve? Sixteen strips from clearly stable to clearly not.

The shapes are known in closed form: arcs, and the clamped strip whose ends are pushed together, up to loops.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.special import ellipk

from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.sideways import sideways_stability
from tests.campaign.finite_elements.bent_strip import BentStrip, bend_cut_strip
from tests.campaign.finite_elements.closed_forms import LENGTH, THICKNESS, arc, elastica, uniform_strip

__all__ = ["STRIPS", "Swung", "pushed_together", "swings"]

POISSON_RATIO = 0.3
MODES = 6
NODES = 601


@dataclass(frozen=True)
class Swung:
    """The lowest eigenvalues of one strip, in units of E I over mass per length and L^4; negative: unstable.

    Attributes
    ----------
    sideways, in_plane : float
        Of the slowest swing out of the plane, within it.
    told : str
        The word of `sideways_stability`.
    """

    name: str
    width: float
    sideways: float
    in_plane: float
    told: str


def pushed_together(k: float) -> PlaneCurve:
    """A strip clamped in line at both ends that are pushed together: a full wave of the elastica of modulus k."""
    return elastica(k, 0.0, 4 * float(ellipk(k**2)))


STRIPS: tuple[tuple[str, PlaneCurve, float], ...] = (
    *((f"arc of {degrees:g} degrees", arc(degrees), 20.0) for degrees in (120.0, 340.0)),
    *((f"ends pushed together, k = {k:g}", pushed_together(k), w)
      for k in (0.4, 0.7, 0.8, 0.88, 0.9) for w in (5.0, 20.0)),
    ("arc of 340 degrees", arc(340.0), 40.0),
    *((f"ends pushed together, k = {k:g}", pushed_together(k), w)
      for k, w in ((0.7, 40.0), (0.8, 40.0), (0.85, 30.0))),
)  # fmt: skip
"""Name, curve and width, mm."""


def swings(folder: Path) -> Iterator[Swung]:
    """All of them, by finite elements."""
    for name, curve, width in STRIPS:
        strip = uniform_strip(width=width, poisson_ratio=POISSON_RATIO)
        bent: BentStrip = bend_cut_strip(strip, folder, size=min(width / 2, 7.0), curve=curve, modes=MODES)
        h, rho = strip.sheet.thickness, 1e-12 * strip.sheet.density
        found = bent.eigenvalues * 12 * rho * LENGTH**4 / (strip.sheet.youngs_modulus * h**2)
        yield Swung(
            name,
            width,
            *(_lowest(found[which]) for which in (bent.sideways, ~bent.sideways)),
            told(curve, width),
        )


def told(curve: PlaneCurve, width: float) -> str:
    """What our own rod says of a uniform strip bent into a curve that is its rest shape."""
    nodes = curve.sample(NODES)
    ends, angles = nodes.position[[0, -1]], nodes.angle[[0, -1]]
    straight = Rod.straight(LENGTH, samples=NODES)
    rod = bend(straight, start=ends[0], end=ends[1], angles=(angles[0], angles[1]), guess=nodes.angle)
    return sideways_stability(rod, width, THICKNESS, poisson_ratio=POISSON_RATIO).word


def _lowest(values: np.ndarray) -> float:
    return float(values.min()) if values.size else float("inf")
