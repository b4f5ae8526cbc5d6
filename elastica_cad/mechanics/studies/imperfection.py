"""One way in which a real strip differs from its design, and where it then rests."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._values import require_positive
from elastica_cad.errors import InputError
from elastica_cad.mechanics.bending.bend_forward import bend, dead_loads, system_of
from elastica_cad.mechanics.material.moment_curvature import PlasticLaw
from elastica_cad.mechanics.rod.rod_record import Rod

ROUNDED_SHARE = 1e-9
"""Of a rod's forces and moments: what is left of them at an end that bears none."""


@dataclass(frozen=True)
class Imperfection:
    """One way in which a real strip differs from its design; the default is no difference.

    Attributes
    ----------
    stiffness_range : float
        m in K -> 1 + (K - 1) m: the ratio of stiffness is smaller or larger than intended.
    youngs_modulus, density, thickness : float
        Factors on those of the sheet; with weight they act through E h^2 / rho, with a force or moment on a free
        end through E h^3.
    start_angle, end_angle : float
        Added to the angles that the supports hold, rad.
    yield_curvature : float
        1/mm; what the design's curvature exceeds it by stays in the strip (ideal plasticity, paper Appendix
        D).
    width_loss : float
        Width lost all along, mm, beyond what the kerf was corrected for; negative for a strip left too wide.
    """

    stiffness_range: float = 1.0
    youngs_modulus: float = 1.0
    density: float = 1.0
    thickness: float = 1.0
    start_angle: float = 0.0
    end_angle: float = 0.0
    yield_curvature: float = np.inf
    width_loss: float = 0.0


def perturb_rod(rod: Rod, imperfection: Imperfection, *, max_width: float | None = None) -> Rod:
    """The rest shape of a strip that differs from its design.

    Parameters
    ----------
    rod : Rod
        The design, in balance.
    imperfection : Imperfection
    max_width : float, optional
        Width of the widest place, mm; needed for a loss of width only.

    Raises
    ------
    InputError
        A loss of width without `max_width`, or as large as the narrowest place.
    NotConvergedError
        No rest shape found.
    """
    v = imperfection
    K, B = 1 + (np.asarray(rod.stiffness) - 1) * v.stiffness_range, 1.0
    if v.width_loss != 0:
        loss = v.width_loss / least_width(rod, max_width, v.width_loss)
        K, B = (K - loss) / (1 - loss), 1 - loss
    changed = rod.with_stiffness(K) if np.any(rod.stiffness != K) else rod
    changed = _with_weight(changed, v, B)
    limit = v.yield_curvature / v.thickness
    bend_here = np.asarray(rod.curvature) - rod.natural_curvature
    if np.any(np.abs(bend_here) > limit):
        permanent = PlasticLaw(limit).permanent_curvature(bend_here)
        changed = replace(changed, natural_curvature=rod.natural_curvature + permanent)
    held = [end.angle for end in rod.supports.ends]
    angles = tuple(
        float(angle) + delta if hold else None
        for angle, delta, hold in zip(rod.angle[[0, -1]], (v.start_angle, v.end_angle), held, strict=True)
    )
    softer = 1 / (v.youngs_modulus * v.thickness**3 * B)  # loads on free ends are newtons: they stay
    force, moment = dead_loads(rod, softer)
    return bend(changed, angles=(angles[0], angles[1]), force=force, moment=moment)


def feels_modulus(rod: Rod) -> bool:
    """Does the shape hang on the sheet's modulus? Only where something pulls that is no support."""
    loads = system_of(rod, rod)
    pulls = np.abs(loads.force).max() > ROUNDED_SHARE * np.abs(rod.force).max()
    turns = np.abs(loads.moments).max() > ROUNDED_SHARE * np.abs(rod.moment).max()
    return bool(pulls or turns or np.any(loads.load))


def least_width(rod: Rod, max_width: float | None, loss: float) -> float:
    """Width of the narrowest place, mm; refused where `loss` would leave nothing of it."""
    if max_width is None:
        raise InputError("a loss of width needs max_width, the width of the widest place, mm")
    require_positive(max_width, "max_width")
    least = max_width / float(np.max(rod.stiffness))
    if loss >= least:
        raise InputError(
            f"a loss of {loss:g} mm leaves nothing of the narrowest place, {least:.4g} mm wide: use a larger "
            "max_width"
        )
    return least


def _with_weight(rod: Rod, v: Imperfection, width_factor: float) -> Rod:
    """The changed sheet's weight; `width_factor` is what the least bending stiffness lost by width."""
    if rod.gravity is None:
        return rod
    if rod.weight is None:
        factor = v.density / (v.youngs_modulus * v.thickness**2)
        return rod if factor == 1 else replace(rod, gravity=rod.gravity.scaled(factor))
    heavier = v.density * v.thickness
    weight = rod.weight.scaled(heavier, heavier * width_factor)
    B = (rod.bending_stiffness or 0.0) * v.youngs_modulus * v.thickness**3 * width_factor
    return replace(rod, weight=weight, bending_stiffness=B)
