"""The width of a plain strip as stiffness, its weight and strain, and what notches leave of it."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import alike, is_number, is_one_of, require_number, require_positive
from elastica_cad.errors import InputError
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2, Weight
from elastica_cad.mechanics.material.anticlastic import SheetCurl, anticlastic_factor, plate_width
from elastica_cad.mechanics.material.section_limits import LayerStrain, ScaleRange, positive
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.refusals import Length as Mm


def crack_energy(poisson_ratio: float, grain: float = 1.0) -> float:
    """Return k for the length l = k depth^2 / width of a bent strip that stores the energy released by a cut.

    An even sheet: k = pi (1 + nu) / (3 + nu). A through crack of length 2 a in a thin plate with the skin stress
    sigma releases the energy pi (1 + nu) / (3 (3 + nu)) sigma^2 a^2 h / E (Sih, Paris and Erdogan, J. Appl. Mech.
    29, 1962; Hui and Zehnder, Int. J. Fracture 61, 1993). A cut from the edge releases half of it, if the other
    edge is far. A strip of width w stores sigma^2 w h / (6 E) in each unit of its length.

    A sheet with grain: on the line of a crack across the strip the shear force is 0 by symmetry. Moment and slope
    of a Kirchhoff half-plane there are M = Z |k| theta for waves exp(i k y), and the energy follows 1 / Z. With
    E2 / E = r^2, g = G / E and nu the geometric mean of both ratios,
    k = pi / 2 sqrt(2 (1 + nu) r + 4 (1 - nu^2) g) / (r + 4 g). E2 across the strip is seldom published, and is
    taken to be smaller than E in the same ratio as G is smaller than that of an even sheet.

    Parameters
    ----------
    poisson_ratio : float
        Dimensionless.
    grain : float
        sqrt(E / G) of the sheet over that of an even sheet.

    Raises
    ------
    InputError
        A ratio outside 0 to 0.5.

    Examples
    --------
    >>> round(crack_energy(0.3), 3), round(crack_energy(0.1, 2.6), 2)
    (1.238, 2.53)
    """
    nu = require_number(poisson_ratio, "Poisson's ratio")
    if not 0 <= nu <= 0.5:
        raise InputError(
            "Poisson's ratio is {poisson_ratio}: it must lie between 0 and 0.5", poisson_ratio=poisson_ratio
        )
    require_positive(grain, "grain")
    twist = (1 + nu) * grain
    return float(np.pi / 2 * twist * np.sqrt(2 * (twist + 1 - nu)) / (twist + 2))


@dataclass(frozen=True)
class PlainSection:
    """A solid rectangle of one sheet: E I = w E h^3 / 12 (paper, section 8.1).

    Examples
    --------
    >>> section = PlainSection(Sheet("mm", 1.0, 12.0, density=1000.0, max_strain=0.01))
    >>> section.bending_stiffness(20.0).item()
    20.0
    """

    sheet: Sheet

    @property
    def rigidity(self) -> float:
        """E I per mm of width, N mm."""
        return self.sheet.bending_stiffness(1.0)

    def bending_stiffness(self, width: ArrayLike) -> FloatArray:
        """E I (n,), N mm2, of widths (n,), mm."""
        return self.rigidity * positive(width, "width")

    def width(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Width (n,), mm, that gives the E I (n,), N mm2."""
        return positive(bending_stiffness, "bending stiffness") / self.rigidity

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """The width, as a `StiffnessLaw` names it."""
        return self.width(bending_stiffness)

    def weight_per_length(self, width: ArrayLike) -> FloatArray:
        """N/mm (n,) of widths (n,), mm."""
        return areal_weight(self.sheet) * positive(width, "width")

    def weight(self, bending_stiffness: float) -> Weight:
        """The weight law: beta K with beta = 12 rho g B / (E h^2), whatever the profile.

        Parameters
        ----------
        bending_stiffness : float
            B, N mm2, the E I where K = 1.
        """
        return Weight(beta=areal_weight(self.sheet) * float(self.width(bending_stiffness)))

    def strains(
        self,
        curvature: ArrayLike,
        width: ArrayLike | None = None,  # noqa: ARG002 - the strain of a solid sheet does not depend on it
        *,
        natural_curvature: float = 0.0,
    ) -> tuple[LayerStrain, ...]:
        """Skin strain h/2 |kappa - kappa_0| of curvatures (n,), 1/mm; one layer."""
        kappa, rest = alike(curvature=curvature, natural_curvature=natural_curvature)
        bend = np.abs(kappa - rest)
        return (layer_strain(self.sheet, np.full(bend.shape, self.sheet.thickness / 2), bend),)

    @property
    def curvature_limit(self) -> float:
        """Largest |kappa - kappa_0| the sheet bears, 1/mm: the inverse of the least cold-bend radius."""
        return 2 * self.sheet.max_strain / self.sheet.thickness


WIDTH_SHARE = 1e-6
"""Relative excess of a rod over the least width, so that the width does not fall below it by rounding."""


@dataclass(frozen=True)
class WidthRange:
    """Limits of the width of a plain strip whose loads determine its width.

    Attributes
    ----------
    sheet : Sheet
    least : float
        Least width, mm; 0 for none.
    largest : float or None
        Width of the widest place, mm. None if the narrowest place has the least width instead.
    """

    sheet: Sheet
    least: float
    largest: float | None

    @property
    def stiffness(self) -> dict[str, float]:
        """The arguments of `optimal_rod` for these widths, N mm2."""
        rigidity = PlainSection(self.sheet).rigidity
        if self.largest is None:
            return {"bending_stiffness": rigidity * self.least * (1 + WIDTH_SHARE)}
        limits = {"least_stiffness": self.least, "largest_stiffness": self.largest}
        return {name: rigidity * width for name, width in limits.items() if width}


@dataclass(frozen=True)
class PerforatedSection(PlainSection):
    """A sheet with holes: the ligaments that are left at a station act like one strip of their summed width.

    `width` is then the ligament sum, and it weighs ~ K as a plain strip does, whatever the outer width.

    Parameters
    ----------
    sheet : Sheet
        What it is cut from.
    ligaments : int
        How many run side by side.
    least_ligament : float
        Width below which a ligament burns or tears away, mm.
    """

    ligaments: int = 2
    least_ligament: float = 0.5

    def __post_init__(self) -> None:
        if not (is_number(self.ligaments) and self.ligaments >= 1 and self.ligaments == int(self.ligaments)):
            raise InputError(
                "a perforated strip has {ligaments!r} ligaments: give a whole number from 1",
                ligaments=self.ligaments,
            )
        if not (is_number(self.least_ligament) and self.least_ligament >= 0):
            raise InputError(
                "least ligament is {least_ligament!r}: it can't be negative, in mm",
                least_ligament=self.least_ligament,
            )

    def scale_range(self, outer_width: ArrayLike, stiffness: ArrayLike) -> ScaleRange:
        """Scales for which the ligaments fit the outer width (n,), mm, and none is too narrow; K is (n,)."""
        least = self.rigidity * self.ligaments * self.least_ligament
        return ScaleRange.of(least, self.bending_stiffness(outer_width), stiffness)


@dataclass(frozen=True, eq=False)
class WidthLaw:
    """A strip of one sheet, from narrow, which bends with E, to wide, which bends as a plate with E/(1 - nu^2).

    Its weight is that of the sheet, so it is not proportional to the stiffness: see `anticlastic_factor`.

    Parameters
    ----------
    sheet : Sheet
    least, largest : float
        Limits of the width, mm; 0 for no least one, or infinity for no largest one.
    curvature, natural_curvature : float or (n,) array
        kappa and kappa_0 of the stations, 1/mm; set by `bent`.

    Examples
    --------
    >>> law = WidthLaw(Sheet("s", 1.0, 12.0, density=1000.0, max_strain=0.01), 0.0, 900.0)
    >>> law.bending_stiffness(900.0).item(), round(law.bent(0.01).bending_stiffness(900.0).item() / 900, 3)
    (900.0, 1.098)
    """

    sheet: Sheet
    least: float
    largest: float
    curvature: float | FloatArray = 0.0
    natural_curvature: float | FloatArray = 0.0

    def __post_init__(self) -> None:
        low = require_number(self.least, "width limit")
        high = np.inf if is_one_of(self.largest, [np.inf]) else require_number(self.largest, "width limit")
        if not 0 <= low <= high or (low, high) in ((0, 0), (0, np.inf)):
            raise InputError(
                "width limits are {low:g} and {high:g}: give the least first, 0 for none, such as 0 and 40",
                low=low,
                high=Mm(high),
            )

    @property
    def quantity(self) -> str:
        """Width."""
        return "width"

    @property
    def limits(self) -> tuple[float, float]:
        """Least and largest width, mm."""
        return self.least, self.largest

    @property
    def follows_bend(self) -> bool:
        """Yes: the sharper the bend, the more of the width bends as a plate."""
        return True

    @property
    def stack(self) -> None:
        """Always None: the section is of one piece."""
        return None

    def bent(self, curvature: ArrayLike, rest: ArrayLike = 0.0) -> "WidthLaw":
        """The law at stations bent by kappa - kappa_0 (n,) from `rest`, kappa_0 (n,) or a number, 1/mm."""
        bend, before = alike(curvature=curvature, rest=rest)
        return replace(self, curvature=bend + before, natural_curvature=before)

    def curl(self, parameter: FloatArray) -> SheetCurl | None:
        """Dependence of the stiffness of widths (n,), mm, on the bend; None for a sheet whose Poisson ratio is
        not known."""
        return SheetCurl(width=parameter, **self._plate) if self.sheet.poisson_ratio else None

    def bending_stiffness(self, parameter: ArrayLike) -> FloatArray:
        """E I (n,), N mm2, of widths (n,), mm, as far as they bend as plates."""
        w = positive(parameter, self.quantity)
        return np.asarray(
            self.sheet.bending_stiffness(1.0) * w * anticlastic_factor(w, self.curvature, **self._plate)
        )

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Widths (n,), mm, that give the E I (n,), N mm2."""
        EI = positive(bending_stiffness, "bending stiffness")
        return plate_width(EI / self.sheet.bending_stiffness(1.0), self.curvature, **self._plate)

    def weight_per_length(self, parameter: ArrayLike) -> FloatArray:
        """N/mm (n,) of widths (n,), mm."""
        return areal_weight(self.sheet) * positive(parameter, self.quantity)

    def strains(
        self,
        curvature: ArrayLike,
        parameter: ArrayLike,  # noqa: ARG002 - laws are asked with it, and here the strain does not depend on it
        *,
        natural_curvature: float = 0.0,
    ) -> tuple[LayerStrain, ...]:
        """Skin strain h/2 |kappa - kappa_0|, whatever the width."""
        return PlainSection(self.sheet).strains(curvature, natural_curvature=natural_curvature)

    @property
    def _plate(self) -> dict[str, Any]:
        return {
            "thickness": self.sheet.thickness,
            "poisson_ratio": self.sheet.poisson_ratio,
            "natural_curvature": self.natural_curvature,
        }


def areal_weight(sheet: Sheet) -> float:
    """rho g h, N/mm2."""
    return sheet.density * 1e-9 * STANDARD_GRAVITY_M_S2 * sheet.thickness


def layer_strain(sheet: Sheet, distance: FloatArray, bend: FloatArray) -> LayerStrain:
    """Strain of a fibre that lies `distance` (n,) mm from the neutral axis of what is bent by `bend` (n,), 1/mm."""
    return LayerStrain(sheet, np.atleast_1d(distance * bend))
