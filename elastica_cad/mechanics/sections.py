"""Sections of one sheet: stiffness, weight and strain for a given width, and anticlastic bending."""

from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import (
    EqualByValue,
    alike,
    is_number,
    is_one_of,
    numbers,
    require_number,
    require_positive,
    require_record,
)
from elastica_cad.errors import BareLength, InputError
from elastica_cad.errors import Length as Mm
from elastica_cad.mechanics.cross_sections import Section, SectionLayer, at_stations
from elastica_cad.mechanics.section_limits import ScaleRange, matched, positive
from elastica_cad.mechanics.sheets import Sheet

SETTLED = 1e-12
"""Relative error of the stiffness below which the search for a width ends after one more step."""

SLOPES = (0.4, 3.0)
"""Bounds of the slope of log(stiffness) as a function of log(width).

The slope is up to 1.25 for a Poisson's ratio of 0.5 and 2.5 for 0.9. The slope is smaller if bending flattens a
natural curvature.
"""


def anticlastic_factor(
    width: ArrayLike,
    curvature: ArrayLike,
    *,
    thickness: float,
    poisson_ratio: float,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """Return the stiffening of a rectangular strip by anticlastic bending, a factor from 1 to 1/(1 - nu^2).

    The factor is M / (E I (kappa - kappa_0)) for constant curvature kappa, natural curvature kappa_0, moment M
    and bending stiffness E I. A narrow strip curls across its width by -nu (kappa - kappa_0) and bends with
    Young's modulus E. A wide strip is flat across except at its edges, and bends as a plate with E/(1 - nu^2).
    The factor depends on Searle's number w^2 kappa / h for width w and thickness h. A strip that is bent straight
    curls freely.

    Parameters
    ----------
    width, curvature : array_like
        Width, mm, and final curvature, 1/mm, which are broadcast. The sign of the curvature has no effect if the
        strip is flat before bending.
    thickness : float
        Thickness of the strip, mm.
    poisson_ratio : float
        Poisson's ratio nu, across the strip, from 0 to below 1.
    natural_curvature : array_like
        Curvature kappa_0 before bending, 1/mm. If a strip is bent back to straight and beyond, the factor leaves
        the above range. The factor is then limited smoothly to values from 1 - nu^2 to (1 + nu^2)/(1 - nu^2).

    Returns
    -------
    array
        Factor on E I, with the broadcast shape.

    Notes
    -----
    The deflection v(y) across the strip minimises the energy of bending and stretching:
    D v'''' + E h kappa^2 v = 0 with plate stiffness D, v'' = -nu b and v''' = 0 at the edges, where b = kappa -
    kappa_0 (Lamb 1891; Searle 1908; Ashwell 1950). Let x = (3 (1 - nu^2))^(1/4) (w^2 kappa / h)^(1/2) and f =
    (cosh x - cos x)/(sinh x + sin x). The energy is D w b^2 g / 2 with g = 1 - 2 nu^2 f / x. The moment is its
    derivative by kappa, so the factor is (g + (b / kappa) x g'/4) / (1 - nu^2). The formula does not apply to
    curvature that varies within a few widths, and to clamps that keep the ends flat.

    Examples
    --------
    >>> anticlastic_factor([0.1, 1000.0], 0.01, thickness=1.0, poisson_ratio=0.3).round(3).tolist()
    [1.0, 1.098]
    """
    h, nu = _checked(thickness, poisson_ratio)
    w, kappa, rest = (
        numbers(value, name)
        for value, name in (
            (width, "strip width"),
            (curvature, "curvature"),
            (natural_curvature, "rest curvature"),
        )
    )
    if not (np.isfinite(w).all() and (w > 0).all()):
        raise InputError("the strip width is not positive: give a number above 0, in mm")
    if not (np.isfinite(kappa).all() and np.isfinite(rest).all()):
        raise InputError("the curvature is not finite: give a finite number, in 1/mm")
    matched(w, kappa, rest)
    x = (3 * (1 - nu**2)) ** 0.25 * w * np.sqrt(np.abs(kappa) / h)
    ratio, slope = _curl(x)
    flat = -x * slope / 2  # term of the moment for a strip that is flat before bending
    limited = flat
    if rest.ndim or rest:
        # correct the term for the natural curvature. Where kappa is 0, any finite `share` gives the limit 0 of
        # `scaled`, because `flat` is 0 there
        share = 1 - np.divide(rest, kappa, out=np.zeros(np.broadcast(rest, kappa).shape), where=kappa != 0)
        scaled = share * flat
        above, below = np.maximum(scaled - flat, 0), np.maximum(-scaled, 0)
        limited = (
            scaled.clip(0, flat)
            + _smoothly_limited(above, 1 + 2 * ratio - flat)
            - _smoothly_limited(below, 2 - nu**2 - 2 * ratio)
        )
    return np.asarray((1 + nu**2 * (limited - 2 * ratio)) / (1 - nu**2))


def _smoothly_limited(excess: FloatArray, limit: FloatArray) -> FloatArray:
    """Limit `excess` smoothly. Values up to half of the limit do not change."""
    half = limit / 2
    return np.asarray(np.minimum(excess, half) - half * np.expm1(-np.maximum(excess / half - 1, 0)))


def plate_width(
    effective: ArrayLike,
    curvature: ArrayLike,
    *,
    thickness: float,
    poisson_ratio: float,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """Return the widths w of strips that are as stiff as narrow strips of the widths `effective`.

    The effective width is w times `anticlastic_factor`(w, curvature).
    """
    h, nu = _checked(thickness, poisson_ratio)
    aim, kappa, rest = np.broadcast_arrays(
        *alike(effective=effective, curvature=curvature, natural_curvature=natural_curvature)
    )
    target = np.log(aim)
    log_width, last, error, slope = target, target, np.zeros(aim.shape), np.ones(aim.shape)
    for _ in range(12):
        before = error
        factor = anticlastic_factor(
            np.exp(log_width), kappa, thickness=h, poisson_ratio=nu, natural_curvature=rest
        )
        error = log_width + np.log(factor) - target
        moved = log_width - last
        steep = (error - before) / np.where(moved == 0, 1.0, moved)
        slope = np.where(moved == 0, slope, np.clip(steep, *SLOPES))
        last, log_width = log_width, log_width - error / slope
        if np.abs(error).max(initial=0.0) < SETTLED:
            break
    return np.asarray(np.exp(log_width))


@dataclass(frozen=True, eq=False)
class SheetCurl:
    """Factor on E I of a strip at its stations, as a function of their curvature.

    A call with curvatures (..., n), 1/mm, returns the `anticlastic_factor` of each station.

    Attributes
    ----------
    width : (n,) array
        Width of the strip at its stations, mm.
    thickness : float
        Thickness of the sheet, mm.
    poisson_ratio : float
        Poisson's ratio of the sheet, dimensionless.
    natural_curvature : float or (n,) array
        Curvature before bending, 1/mm.

    Examples
    --------
    >>> curl = SheetCurl(np.array([20.0, 40.0]), 0.5, 0.3)
    >>> curl(np.array([[0.0, 0.0], [0.01, 0.01]])).round(3).tolist()
    [[1.0, 1.0], [1.058, 1.078]]
    """

    width: FloatArray
    thickness: float
    poisson_ratio: float
    natural_curvature: float | FloatArray = 0.0

    def __call__(self, curvature: FloatArray) -> FloatArray:
        """Return the factors of the stations (..., n) for their curvatures (..., n), 1/mm."""
        return anticlastic_factor(
            self.width, curvature, thickness=self.thickness, poisson_ratio=self.poisson_ratio,
            natural_curvature=self.natural_curvature,
        )  # fmt: skip

    def stiffened(self, times: FloatArray, curvature: FloatArray) -> "SheetCurl":
        """Return the `SheetCurl` of a wider strip whose stiffness is `times` (n,) as large at `curvature` (n,)."""
        width = plate_width(
            times * self.width * self(curvature), curvature, thickness=self.thickness,
            poisson_ratio=self.poisson_ratio, natural_curvature=self.natural_curvature,
        )  # fmt: skip
        return replace(self, width=width)

    def resampled(self, s: FloatArray, at: FloatArray) -> "SheetCurl":
        """Return the `SheetCurl` at arc lengths `at` (m,), mm, interpolated from arc lengths `s` (n,), mm."""
        rest = at_stations(self.natural_curvature, s, at)
        return replace(self, width=np.interp(at, s, self.width), natural_curvature=rest)


def _checked(thickness: float, poisson_ratio: float) -> tuple[float, float]:
    require_positive(thickness, "thickness")
    if not (is_number(poisson_ratio) and 0 <= poisson_ratio < 1):
        raise InputError(f"Poisson's ratio is {poisson_ratio}: give a number between 0 and 1")
    return float(thickness), float(poisson_ratio)


def _curl(x: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return f/x and its derivative, for f = (cosh x - cos x)/(sinh x + sin x). Below x = 0.3, use a series."""
    is_small = x < 0.3
    y = np.where(is_small, 1.0, x)
    decay = np.exp(-y)
    squared, swing = decay**2, 2 * decay * np.cos(y)
    bottom = 1 - squared + 2 * decay * np.sin(y)
    f = (1 + squared - swing) / bottom
    # the derivative of cosh x - cos x is sinh x + sin x, the denominator of f
    slope = 1 - f * (1 + squared + swing) / bottom
    share = f / y
    curl, curl_slope = np.asarray(share), np.asarray((slope - share) / y)
    small = x[is_small]
    t = small**4
    curl[is_small], curl_slope[is_small] = 0.5 - t / 360 + t**2 / 45360, small**3 * (t / 5670 - 1 / 90)
    return curl, curl_slope


def crack_energy(poisson_ratio: float, grain: float = 1.0) -> float:
    """Return the coefficient k for the energy that a cut from the edge of a bent strip releases.

    The released energy equals the bending energy of a strip of length l = k depth^2 / width.

    For a sheet without grain, k = pi (1 + nu) / (3 + nu). A through crack of length 2 a in a thin plate of
    thickness h with the surface stress sigma releases the energy pi (1 + nu) / (3 (3 + nu)) sigma^2 a^2 h / E
    (Sih, Paris and Erdogan, J. Appl. Mech. 29, 1962; Hui and Zehnder, Int. J. Fracture 61, 1993). A cut from the
    edge releases half of this energy if the other edge is far away. A strip of width w stores the energy sigma^2
    w h / (6 E) per length.

    In a sheet with grain, the shear force on the line of a crack across the strip is 0 by symmetry. There the
    moment M and slope theta of a Kirchhoff half-plane satisfy M = Z |m| theta for waves exp(i m y), and the
    energy is proportional to 1 / Z. For moduli E along and E2 = r^2 E across the strip, shear modulus G = g E,
    and nu the geometric mean of both Poisson's ratios, k = pi / 2 sqrt(2 (1 + nu) r + 4 (1 - nu^2) g) / (r + 4
    g). E2 is seldom published. It is assumed that the ratio of E2 to E equals the ratio of G to the shear modulus
    of a sheet without grain.

    Parameters
    ----------
    poisson_ratio : float
        Poisson's ratio nu, dimensionless.
    grain : float
        Ratio of sqrt(E / G) of the sheet to sqrt(E / G) of a sheet without grain.

    Examples
    --------
    >>> round(crack_energy(0.3), 3), round(crack_energy(0.1, 2.6), 2)
    (1.238, 2.53)
    """
    nu = require_number(poisson_ratio, "Poisson's ratio")
    if not 0 <= nu <= 0.5:
        raise InputError(f"Poisson's ratio is {poisson_ratio}: give a number between 0 and 0.5")
    require_positive(grain, "grain")
    twist = (1 + nu) * grain
    return float(np.pi / 2 * twist * np.sqrt(2 * (twist + 1 - nu)) / (twist + 2))


@dataclass(frozen=True, eq=False)
class PlainSection(EqualByValue, Section):
    """Solid rectangular section of a sheet with a variable width w: E I = w E h^3 / 12 (paper, section 8.1).

    h is the thickness and E Young's modulus. The formula is for a strip that is narrow, or not yet bent. A strip
    that is wide for its curvature bends as a plate with E/(1 - nu^2): `bent` returns the section for curvatures,
    whose weight is not proportional to its stiffness; see `anticlastic_factor`.

    Parameters
    ----------
    sheet : Sheet
    least, largest : float
        Limits of the width, mm; 0 means no least width, infinity no largest width.
    curvature, natural_curvature : float or (n,) array
        Curvature and natural curvature of the stations, 1/mm; set by `bent`.

    Examples
    --------
    >>> section = PlainSection(Sheet("s", 1.0, 12.0, density=1000.0, max_strain=0.01), 0.0, 900.0)
    >>> section.bending_stiffness(900.0).item(), section.parameter(900.0).item()
    (900.0, 900.0)
    >>> round(section.bent(0.01).bending_stiffness(900.0).item() / 900, 3)
    1.098
    """

    quantity = "width"
    follows_bend = True  # a larger part of the width bends as a plate if the curvature increases
    sheet: Sheet
    least: float = 0.0
    largest: float = np.inf
    curvature: float | FloatArray = 0.0
    natural_curvature: float | FloatArray = 0.0

    def __post_init__(self) -> None:
        low = require_number(self.least, "width limit")
        high = np.inf if is_one_of(self.largest, [np.inf]) else require_number(self.largest, "width limit")
        if not 0 <= low <= high or high == 0:
            raise InputError(
                "{quantity} limits are {low:g} and {high:g}: give the least first, such as 3 and 8",
                quantity=self.quantity, low=BareLength(low), high=Mm(high),
            )  # fmt: skip

    @classmethod
    def as_plate(cls, sheet: Sheet, largest: float | None) -> "PlainSection | None":
        """Return the section for widths up to `largest`, or None.

        The result is None if `largest` is None, or if Poisson's ratio of the sheet is unknown or 0.
        """
        require_record(sheet, Sheet, "the sheet", "a Sheet")
        has_plate_effect = largest is not None and sheet.poisson_known and sheet.poisson_ratio > 0
        return cls(sheet, 0.0, largest) if largest is not None and has_plate_effect else None

    @property
    def rigidity(self) -> float:
        """Bending stiffness per mm of width of a narrow strip, N mm."""
        return self.sheet.bending_stiffness(1.0)

    @property
    def limits(self) -> tuple[float, float]:
        """Least and largest width, mm."""
        return self.least, self.largest

    def bent(self, curvature: ArrayLike, rest: ArrayLike = 0.0) -> Self:
        """Return the section at stations (n,) that are bent by a change of curvature, 1/mm.

        `curvature` is the change kappa - kappa_0, and `rest`, a number or (n,), the natural curvature kappa_0.
        """
        bend, before = alike(curvature=curvature, rest=rest)
        return replace(self, curvature=bend + before, natural_curvature=before)

    def curl(self, parameter: FloatArray) -> SheetCurl | None:
        """Return the effect of anticlastic bending for widths (n,), mm, or None if Poisson's ratio is 0."""
        return (
            SheetCurl(numbers(parameter, "widths") / self._pieces, **self._plate)
            if self.sheet.poisson_ratio
            else None
        )

    def bending_stiffness(self, width: ArrayLike) -> FloatArray:
        """Return E I (n,), N mm2, for widths (n,), mm, including the plate effect of the curvature."""
        w = positive(width, "width")
        if not np.any(self.curvature):  # the strip curls freely
            return self.rigidity * w
        return self.rigidity * w * anticlastic_factor(w / self._pieces, self.curvature, **self._plate)

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Return the widths (n,), mm, for E I (n,), N mm2."""
        narrow = positive(bending_stiffness, "bending stiffness") / self.rigidity
        if not np.any(self.curvature):
            return narrow
        return self._pieces * plate_width(narrow / self._pieces, self.curvature, **self._plate)

    def layers(self, width: ArrayLike) -> tuple[SectionLayer, ...]:
        """Return the sheet as a layer."""
        h = self.sheet.thickness
        return (SectionLayer(self.sheet, h * positive(width, "width"), h / 2),)

    @property
    def _pieces(self) -> int:
        """Number of pieces side by side that share the width and curl separately."""
        return 1

    @property
    def _plate(self) -> dict[str, Any]:
        return {
            "thickness": self.sheet.thickness,
            "poisson_ratio": self.sheet.poisson_ratio,
            "natural_curvature": self.natural_curvature,
        }


@dataclass(frozen=True, eq=False)
class PerforatedSection(PlainSection):
    """Section of a sheet with holes: the ligaments at a station act like a strip of their total width.

    `width` is the total width of the ligaments, each of which curls separately if it is bent. The weight is
    independent of the outer width.

    Parameters
    ----------
    sheet, least, largest, curvature, natural_curvature
        As in `PlainSection`.
    ligaments : int
        Number of ligaments side by side.
    least_ligament : float
        Least width, mm, at which a ligament does not burn or break during cutting.
    """

    ligaments: int = 2
    least_ligament: float = 0.5

    @property
    def _pieces(self) -> int:
        return self.ligaments

    def __post_init__(self) -> None:
        super().__post_init__()
        if not (is_number(self.ligaments) and self.ligaments >= 1 and self.ligaments == int(self.ligaments)):
            raise InputError(
                f"a perforated strip has {self.ligaments!r} ligaments (material between holes): give a whole "
                "number, 1 or more"
            )
        if not (is_number(self.least_ligament) and self.least_ligament >= 0):
            raise InputError(
                f"the least width of a ligament is {self.least_ligament!r}: give 0 or more, in mm"
            )

    def scale_range(self, outer_width: ArrayLike, stiffness: ArrayLike) -> ScaleRange:
        """Return the scales c for which the ligaments fit into the outer width (n,), mm, and are wide enough.

        The bending stiffness of the strip is c times the relative `stiffness` (n,).
        """
        least = self.rigidity * self.ligaments * self.least_ligament
        return ScaleRange.of(least, self.bending_stiffness(outer_width), stiffness)
