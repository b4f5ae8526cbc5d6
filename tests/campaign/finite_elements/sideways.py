"""Does a bent strip leave the plane of its curve? Strips from clearly stable to clearly not, of three styles.

The shapes are known in closed form: arcs, and the clamped strip whose ends are pushed together, up to loops.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.special import ellipk

from elastica_cad import Laminated, Perforated, PlaneCurve, Rod, Strip, bend
from elastica_cad.strip.strip import strip_sideways
from tests.campaign.finite_elements.bent_strip import BentStrip, bend_cut_strip
from tests.campaign.finite_elements.closed_forms import GRAVITY_MM_S2, LENGTH, arc, elastica, uniform_strip

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


def perforated(width: float, material: float, rows: int) -> Strip:
    """Even holes, one column of them and halves at the edges."""
    style = Perforated(width=width, columns=1, rows=rows, least_ligament=0.2, least_hole=0.2)
    return replace(uniform_strip(width=material, poisson_ratio=POISSON_RATIO), style=style)


def laminated(width: float, backing: float) -> Strip:
    """An even backing on a base, both 0.5 mm thick."""
    strip = uniform_strip(width=backing, poisson_ratio=POISSON_RATIO)
    half = replace(strip.sheet, thickness=0.5)
    return replace(strip, sheet=half, style=Laminated(width=width, backing=half, dots=0.0))


STYLED: tuple[tuple[str, Strip, float, float], ...] = (
    *(("perforated, 12 rows", perforated(12.0, 5.0, 12), k, 1.25) for k in (0.7, 0.9)),
    ("perforated, 10 rows", perforated(20.0, 8.0, 10), 0.7, 1.6),
    *(("laminated, backing 5 mm", laminated(8.0, 5.0), k, 2.5) for k in (0.8, 0.9)),
    ("laminated, backing 12 mm", laminated(20.0, 12.0), 0.7, 4.0),
)
"""Name, strip, modulus of the elastica, size of the elements, mm."""


def swings(folder: Path) -> Iterator[Swung]:
    """All of them, by finite elements."""
    for name, curve, width in STRIPS:
        strip = uniform_strip(width=width, poisson_ratio=POISSON_RATIO)
        yield _swung(name, strip, curve, folder, size=min(width / 2, 7.0))
    for style, strip, k, size in STYLED:
        name = f"{style}, ends pushed together, k = {k:g}"
        yield _swung(name, strip, pushed_together(k), folder, size=size)


def _swung(name: str, strip: Strip, curve: PlaneCurve, folder: Path, *, size: float) -> Swung:
    """One strip; eigenvalues over its own bending stiffness and mass per length."""
    bent: BentStrip = bend_cut_strip(strip, folder, size=size, curve=curve, modes=MODES)
    layout, at = strip.layout, LENGTH / 2
    section, parameter = layout.section_at(at)
    tonnes = float(section.weight_per_length(parameter)) / GRAVITY_MM_S2
    found = bent.eigenvalues * tonnes * LENGTH**4 / strip.bending_stiffness
    return Swung(
        name,
        round(float(strip.width(at)), 6),
        *(_lowest(found[which]) for which in (bent.sideways, ~bent.sideways)),
        described(curve, strip),
    )


def described(curve: PlaneCurve, strip: Strip) -> str:
    """What our own rod says of a uniform strip bent into a curve that is its rest shape."""
    nodes = curve.sample(NODES)
    ends, angles = nodes.position[[0, -1]], nodes.angle[[0, -1]]
    straight = Rod.straight(LENGTH, samples=NODES)
    rod = bend(straight, start=ends[0], end=ends[1], angles=(angles[0], angles[1]), guess=nodes.angle)
    return strip_sideways(rod, strip.layout).word


def _lowest(values: np.ndarray) -> float:
    return float(values.min()) if values.size else float("inf")
