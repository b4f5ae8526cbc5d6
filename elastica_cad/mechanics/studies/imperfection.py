"""One way in which a real strip differs from its design, and where it then rests."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_positive, require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.bending.bend_forward import bend, dead_loads, system_of
from elastica_cad.mechanics.material.anticlastic import SheetCurl
from elastica_cad.mechanics.material.moment_curvature import PlasticLaw
from elastica_cad.mechanics.rod.rod_record import CurlingLaw, Rod

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
        end through E h^3. In a strip that bends as a plate the thickness tells how far it does, too.
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
    require_record(rod, Rod, "the rod", "a Rod, as bend makes one")
    require_record(imperfection, Imperfection, "the imperfection", "an Imperfection")
    v, rod = imperfection, rod.following()
    changed, B = _as_cut(rod, v, max_width)
    limit = v.yield_curvature / v.thickness
    bend_here = np.asarray(rod.curvature) - rod.natural_curvature
    if np.any(np.abs(bend_here) > limit):
        rest = rod.natural_curvature + PlasticLaw(limit).permanent_curvature(bend_here)
        law = changed.law
        changed = replace(
            changed, natural_curvature=rest,
            law=replace(law, natural_curvature=rest) if isinstance(law, CurlingLaw) else law,
        )  # fmt: skip
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
    plate = _plate_of(rod.following())
    least = max_width / float(np.max(rod.stiffness)) if plate is None else float(plate[1].width.min())
    if loss >= least:
        raise InputError(
            f"a loss of {loss:g} mm leaves nothing of the narrowest place, {least:.4g} mm wide: use a larger "
            "max_width"
        )
    return least


def _plate_of(rod: Rod) -> tuple[CurlingLaw, SheetCurl] | None:
    """The law of a strip whose widths follow the bend, and how they curl; None of others."""
    law = rod.law
    if rod.follows_bend and isinstance(law, CurlingLaw) and isinstance(law.factor, SheetCurl):
        return law, law.factor
    return None


def _as_cut(rod: Rod, v: Imperfection, max_width: float | None) -> tuple[Rod, float]:
    """The rod as it is cut, with its weight, and what is left of its least stiffness by its widths."""
    K, B = 1 + (np.asarray(rod.stiffness) - 1) * v.stiffness_range, 1.0
    least = np.inf if v.width_loss == 0 else least_width(rod, max_width, v.width_loss)
    plate = _plate_of(rod)
    if plate is not None:
        return _plate_as_cut(rod, *plate, K / rod.stiffness, v)
    if v.width_loss != 0:
        loss = v.width_loss / least
        K, B = (K - loss) / (1 - loss), 1 - loss
    changed = rod.with_stiffness(K) if np.any(rod.stiffness != K) else rod
    return _with_weight(changed, v, B), B


def _plate_as_cut(
    rod: Rod, law: CurlingLaw, curl: SheetCurl, stiffer: FloatArray, v: Imperfection
) -> tuple[Rod, float]:
    """The same of a strip that bends as a plate, the more so the wider and the thinner it comes out.

    `stiffer` (n,) is what its range of stiffness makes of K.
    """
    kappa = np.asarray(rod.curvature)
    asked = curl if np.all(stiffer == 1) else curl.stiffened(stiffer, kappa)
    cut = replace(asked, width=asked.width - v.width_loss, thickness=curl.thickness * v.thickness)
    narrower, here = cut.width / curl.width, cut(kappa)
    K = rod.stiffness * narrower * here / law.designed
    B = float(K.min())
    changed = rod.with_stiffness(K) if np.any(rod.stiffness != K) else rod
    changed = _with_weight(replace(changed, law=replace(law, factor=cut, designed=here)), v, B)
    if rod.weight is not None and rod.gravity is not None:
        alpha, beta = rod.weight.along(rod.s)
        newtons = v.density * v.thickness * narrower * (alpha + beta * rod.stiffness)
        weight = replace(rod.weight, alpha=Profile.interpolate(rod.s, newtons), beta=0.0)
        changed = replace(changed, weight=weight)
    return changed, B


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
