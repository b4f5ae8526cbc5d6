"""Anticlastic bending: wide thin strips curl across, or are kept from it and get stiffer."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import alike, is_number, numbers, require_positive
from elastica_cad.errors import InputError
from elastica_cad.mechanics.material.section_limits import matched
from elastica_cad.mechanics.material.stiffness_law import at_stations

SECANTS = 12
"""Largest number of steps of the search for the width of a given bending stiffness."""

SETTLED = 1e-12
"""Relative error from which one more step reaches rounding."""

SLOPES = (0.4, 3.0)
"""Bounds on the slope of log(stiffness) over log(width). It is up to 1.25 for nu = 0.5 and 2.5 for 0.9, and
smaller for strips whose natural curvature is flattened."""


def anticlastic_factor(
    width: ArrayLike,
    curvature: ArrayLike,
    *,
    thickness: float,
    poisson_ratio: float,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """M / (E I (kappa - kappa_0)) of a rectangular strip bent to a constant curvature: from 1 to 1/(1 - nu^2).

    A narrow strip curls across by -nu (kappa - kappa_0) and bends with E; in a wide one the curl is flattened but
    for its edges and it bends as a plate, with E/(1 - nu^2). What counts is Searle's number w^2 kappa / h, of the
    curvature that the strip has in the end: one that is bent straight curls freely.

    Parameters
    ----------
    width, curvature : array_like
        mm and 1/mm (the sign does not matter where the strip is flat before), broadcast.
    thickness : float
        mm.
    poisson_ratio : float
        nu, across the strip, from 0 to below 1.
    natural_curvature : array_like
        kappa_0, before it is bent, 1/mm. A strip that is bent back towards straight and beyond leaves that range;
        its factor is eased off, to stay between 1 - nu^2 and (1 + nu^2)/(1 - nu^2).

    Returns
    -------
    array
        The factor on E I, of the broadcast shape.

    Raises
    ------
    InputError
        Width or thickness not positive, nu outside [0, 1), values that are not finite.

    Notes
    -----
    Least energy of bending and stretching over the deflection v(y) across the strip, D v'''' + E h kappa^2 v
    = 0 with v'' = -nu b, b = kappa - kappa_0, v''' = 0 at the edges (Lamb 1891; Searle 1908; Ashwell 1950). With
    x = (3 (1 - nu^2))^(1/4) (w^2 kappa / h)^(1/2) and f = (cosh x - cos x)/(sinh x + sin x) the energy is
    D w b^2 g / 2, g = 1 - 2 nu^2 f / x, and the moment its derivative by kappa: (g + (b / kappa) x g'/4) /
    (1 - nu^2). Curvature that varies within a few widths, and clamps that keep the ends flat, are outside the
    formula.

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
    if not (np.all(np.isfinite(w)) and np.all(w > 0)):
        raise InputError("strip width must be positive, in mm")
    if not (np.all(np.isfinite(kappa)) and np.all(np.isfinite(rest))):
        raise InputError("curvature must be finite, in 1/mm")
    matched(w, kappa, rest)
    x = (3 * (1 - nu**2)) ** 0.25 * w * np.sqrt(np.abs(kappa) / h)
    ratio, slope = _curl(x)
    flat = -x * slope / 2  # of a blank that is flat before
    kept = _kept_of_bent(flat, ratio, kappa, rest, nu) if rest.ndim or rest else flat
    return np.asarray((1 + nu**2 * (kept - 2 * ratio)) / (1 - nu**2))


def _kept_of_bent(
    flat: FloatArray, ratio: FloatArray, kappa: FloatArray, rest: FloatArray, nu: float
) -> FloatArray:
    """The counterpart of `flat` for strips with natural curvature kappa_0 (n,)."""
    # of a strip that is straight in the end x slope vanishes faster than kappa
    share = 1 - np.divide(rest, kappa, out=np.zeros(np.broadcast(rest, kappa).shape), where=kappa != 0)
    asked = share * flat
    above, below = np.maximum(asked - flat, 0), np.maximum(-asked, 0)
    return np.asarray(
        np.clip(asked, 0, flat) + _eased(above, 1 + 2 * ratio - flat) - _eased(below, 2 - nu**2 - 2 * ratio)
    )


def _eased(excess: FloatArray, room: FloatArray) -> FloatArray:
    """Soften `excess` beyond a range smoothly, so that widths get no corner: unchanged up to half of the room,
    then less and less."""
    half = room / 2
    late = np.maximum(excess / half - 1, 0)
    return np.asarray(np.minimum(excess, half) - half * np.expm1(-late))


def plate_width(
    effective: ArrayLike,
    curvature: ArrayLike,
    *,
    thickness: float,
    poisson_ratio: float,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """Widths w with w `anticlastic_factor`(w, curvature) = `effective`, the width of a strip that bends with E.

    Examples
    --------
    >>> round(plate_width(1000.0, 0.01, thickness=1.0, poisson_ratio=0.3).item(), 1)
    911.1
    """
    h, nu = _checked(thickness, poisson_ratio)
    aim, kappa, rest = np.broadcast_arrays(
        *alike(effective=effective, curvature=curvature, natural_curvature=natural_curvature)
    )
    wanted = np.log(aim)
    found, last, error, slope = wanted, wanted, np.zeros(aim.shape), np.ones(aim.shape)
    for _ in range(SECANTS):
        before = error
        factor = anticlastic_factor(
            np.exp(found), kappa, thickness=h, poisson_ratio=nu, natural_curvature=rest
        )
        error = found + np.log(factor) - wanted
        moved = found - last
        steep = (error - before) / np.where(moved == 0, 1.0, moved)
        slope = np.where(moved == 0, slope, np.clip(steep, *SLOPES))
        last, found = found, found - error / slope
        if np.abs(error).max(initial=0.0) < SETTLED:
            break
    return np.asarray(np.exp(found))


@dataclass(frozen=True, eq=False)
class SheetCurl:
    """How much stiffer than E I a strip is at its stations, as a function of the curvature that they have.

    Call it with curvatures (..., n), 1/mm: it gives the `anticlastic_factor` of each station.

    Attributes
    ----------
    width : (n,) array
        Of the strip at its stations, mm.
    thickness : float
        Of the sheet, mm.
    poisson_ratio : float
        nu of the sheet, dimensionless.
    natural_curvature : float or (n,) array
        kappa_0 of the blank, 1/mm.

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
        """The factor of the stations (..., n) at their curvatures (..., n), 1/mm."""
        return anticlastic_factor(
            self.width, curvature, thickness=self.thickness, poisson_ratio=self.poisson_ratio,
            natural_curvature=self.natural_curvature,
        )  # fmt: skip

    def stiffened(self, times: FloatArray, curvature: FloatArray) -> "SheetCurl":
        """Return the curl of widths that are `times` (n,) as stiff, bent to curvatures (n,), 1/mm."""
        width = plate_width(
            times * self.width * self(curvature), curvature, thickness=self.thickness,
            poisson_ratio=self.poisson_ratio, natural_curvature=self.natural_curvature,
        )  # fmt: skip
        return replace(self, width=width)

    def resampled(self, s: FloatArray, at: FloatArray) -> "SheetCurl":
        """Interpolate from stations `s` (n,) to stations `at` (m,), mm."""
        rest = at_stations(self.natural_curvature, s, at)
        return replace(self, width=np.interp(at, s, self.width), natural_curvature=rest)


def _checked(thickness: float, poisson_ratio: float) -> tuple[float, float]:
    require_positive(thickness, "thickness")
    if not (is_number(poisson_ratio) and 0 <= poisson_ratio < 1):
        raise InputError(
            "Poisson's ratio is {poisson_ratio}: it must lie between 0 and 1", poisson_ratio=poisson_ratio
        )
    return float(thickness), float(poisson_ratio)


def _curl(x: FloatArray) -> tuple[FloatArray, FloatArray]:
    """f/x and its derivative, f = (cosh x - cos x)/(sinh x + sin x); series below 0.3, no overflow above."""
    is_small = x < 0.3
    y = np.where(is_small, 1.0, x)
    decay = np.exp(-y)
    squared, swing = decay**2, 2 * decay * np.cos(y)
    bottom = 1 - squared + 2 * decay * np.sin(y)
    f = (1 + squared - swing) / bottom
    # (cosh - cos)' = sinh + sin is the denominator itself, whose derivative is cosh + cos
    slope = 1 - f * (1 + squared + swing) / bottom
    share = f / y
    curl, curl_slope = np.asarray(share), np.asarray((slope - share) / y)
    small = x[is_small]
    t = small**4
    curl[is_small], curl_slope[is_small] = 0.5 - t / 360 + t**2 / 45360, small**3 * (t / 5670 - 1 / 90)
    return curl, curl_slope
