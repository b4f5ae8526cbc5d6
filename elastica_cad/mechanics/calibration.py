"""Calibration: elasto-gravity length of a sheet from the droop of a strip that hangs over the edge of a table."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import counted, is_number, numbers, require_positive
from elastica_cad.errors import BareLength, InputError, Length, Listed, note, sentences
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2, Gravity, Supports
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import USUAL_RATIO, Grain, Range, Sheet


@dataclass(frozen=True)
class Calibration:
    """Properties of a sheet, measured with a hanging strip.

    Attributes
    ----------
    elasto_gravity_length : float
        l_eg = (E h^2 / (12 rho g))^(1/3), mm, for Young's modulus E, thickness h and density rho.
    uncertainty : float
        Standard deviation of l_eg, mm: the larger of the values from the reading errors and from the scatter of the
        readings.
    readings : tuple of float
        l_eg of each reading, mm.
    reading_uncertainties : tuple of float
        Standard deviation of each reading, mm, from the reading errors alone.
    thickness, density : float or None
        Thickness, mm, and density, kg/m3, as passed to `calibrate_cantilever`.
    youngs_modulus, youngs_modulus_uncertainty : float or None
        E = 12 rho g l_eg^3 / h^2 and its standard deviation, MPa, or None if thickness or density is unknown.
    """

    elasto_gravity_length: float
    uncertainty: float
    readings: tuple[float, ...]
    reading_uncertainties: tuple[float, ...]
    thickness: float | None = None
    density: float | None = None
    youngs_modulus: float | None = None
    youngs_modulus_uncertainty: float | None = None

    def gravity(self, direction: ArrayLike = (0.0, -1.0)) -> Gravity:
        """Return the `Gravity` of a strip that is cut from this sheet."""
        x, y = np.asarray(direction, dtype=float)
        return Gravity(self.elasto_gravity_length, (float(x), float(y)))

    def sheet(
        self,
        name: str,
        *,
        max_strain: float | None = None,
        least_radius: float | None = None,
        kerf: float = 0.0,
        poisson_ratio: float = USUAL_RATIO,
        shear_modulus: float | None = None,
        grain: Grain = "none",
        kind: str = "",
    ) -> Sheet:
        """Return the calibrated sheet; E has a range of two standard deviations on either side.

        Parameters
        ----------
        name : str
            Name of the sheet.
        max_strain, least_radius : float
            Largest strain for permanent use, or the least radius (mm) to which the sheet was bent without a
            permanent bend. Give exactly one.
        kerf, poisson_ratio, shear_modulus, grain, kind
            As in `Sheet`.
        """
        if self.youngs_modulus is None or self.thickness is None or self.density is None:
            raise InputError(
                "a calibration needs the thickness (mm) and the density (kg/m3) of the sheet: give both"
            )
        if (max_strain is None) == (least_radius is None):
            raise InputError(
                "the calibration needs the limit of bending: give either max_strain or least_radius"
            )
        if least_radius is not None:
            require_positive(least_radius, "least radius", "mm")
            max_strain = self.thickness / (2 * least_radius)
        spread = 2 * (self.youngs_modulus_uncertainty or 0.0)
        limits: Range = (max(0.0, self.youngs_modulus - spread), self.youngs_modulus + spread)
        return Sheet(
            name,
            self.thickness,
            self.youngs_modulus,
            self.density,
            max_strain or 0.0,
            kerf=kerf,
            poisson_ratio=poisson_ratio,
            shear_modulus=shear_modulus,
            grain=grain,
            kind=kind,
            source=f"cantilever test, {counted(len(self.readings), 'reading')}, elasto-gravity length "
            f"{BareLength(self.elasto_gravity_length)} +- {Length(self.uncertainty)}",
            youngs_modulus_range=limits,
        )

    def __str__(self) -> str:
        length, off = self.elasto_gravity_length, Length(self.uncertainty)
        lines = [note("elasto-gravity length {length:.3g} +- {off:.3g}", length=length, off=off)]
        if len(self.readings) > 1:
            lines.append(
                note("from each reading alone: {readings:.3g}", readings=Listed(map(Length, self.readings)))
            )
        if self.youngs_modulus is not None and self.youngs_modulus_uncertainty is not None:
            modulus, apart = self.youngs_modulus, self.youngs_modulus_uncertainty
            lines.append(note("Young's modulus {modulus:.3g} +- {off:.3g} MPa", modulus=modulus, off=apart))
        return sentences(lines, "\n")


def cantilever_droop(overhang: float, elasto_gravity_length: float) -> float:
    """Return the drop of the free end of a uniform strip that is clamped horizontally, mm.

    Parameters
    ----------
    overhang, elasto_gravity_length : float
        Free length of the strip and elasto-gravity length of the sheet, mm.

    Examples
    --------
    >>> round(cantilever_droop(100.0, 100.0), 3)  # w L^3 / E I = 1
    12.347
    """
    require_positive(overhang, "overhang", "mm")
    require_positive(elasto_gravity_length, "elasto-gravity length", "mm")
    strip = Rod.straight(
        overhang, samples=201, gravity=Gravity(elasto_gravity_length), supports=Supports("clamped", "free")
    )
    return float(-bend(strip).position[-1, 1])


def calibrate_cantilever(
    overhang: float | Sequence[float],
    droop: float | Sequence[float],
    *,
    reading_error: float = 0.5,
    thickness: float | None = None,
    density: float | None = None,
    thickness_error: float = 0.0,
    density_error: float = 0.0,
) -> Calibration:
    """Return the elasto-gravity length from the droop of a rectangular strip that is clamped horizontally.

    Measure once with each face of the strip up. The mean of both readings cancels the curl of the unloaded strip to
    first order.

    Parameters
    ----------
    overhang, droop : float or sequence
        Free length and drop of the free end below the clamp, mm; any number of readings.
    reading_error : float
        Standard deviation of the overhang and of the droop, mm.
    thickness, density : float, optional
        Thickness, mm, and density, kg/m3; if both are given, the result contains E.
    thickness_error, density_error : float
        Standard deviations of thickness and density, mm and kg/m3; they affect the uncertainty of E only.

    Notes
    -----
    The ratio of droop to overhang L depends only on (L / l_eg)^3 (paper, section 5.1). The droop is computed with
    `bend`, and l_eg is the root of computed minus measured droop. Finite differences propagate the reading errors.

    Examples
    --------
    >>> result = calibrate_cantilever(150.0, 61.57, thickness=0.22, density=900.0)
    >>> round(result.elasto_gravity_length, 0), 0.3 < result.uncertainty < 0.8
    (96.0, True)
    """
    lengths, drops = _readings(overhang, droop)
    errors = (
        ("reading", reading_error, "mm"),
        ("thickness", thickness_error, "mm"),
        ("density", density_error, "kg/m3"),
    )
    for name, value, unit in errors:
        if not (is_number(value) and value >= 0):
            raise InputError(f"{name}_error is {value!r}: give a standard error of 0 {unit} or more")
    for number, name, unit in ((thickness, "thickness", "mm"), (density, "density", "kg/m3")):
        if number is not None:
            require_positive(number, name, unit)
    fitted = [_fit(L, d) for L, d in zip(lengths, drops, strict=True)]
    values = np.array([value for value, _ in fitted])
    sigmas = reading_error * np.array([slope for _, slope in fitted])
    mean, sigma = _weighted_mean(values, sigmas)
    E = spread = None
    if thickness is not None and density is not None:
        E = 12 * density * 1e-9 * STANDARD_GRAVITY_M_S2 * mean**3 / thickness**2
        parts = (3 * sigma / mean, 2 * thickness_error / thickness, density_error / density)
        spread = E * float(np.hypot.reduce(parts))
    return Calibration(
        elasto_gravity_length=mean,
        uncertainty=sigma,
        readings=tuple(values.tolist()),
        reading_uncertainties=tuple(sigmas.tolist()),
        thickness=thickness,
        density=density,
        youngs_modulus=E,
        youngs_modulus_uncertainty=spread,
    )


def _readings(overhang: ArrayLike, droop: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Return overhangs and droops, mm, as arrays.

    Impossible droops are refused, and droops from which the stiffness cannot be computed.
    """
    lengths, drops = np.atleast_1d(numbers(overhang, "overhangs"), numbers(droop, "droops"))
    if lengths.shape != drops.shape or lengths.ndim != 1 or lengths.size == 0:
        raise InputError(
            "there are {size} overhangs, but {size_2} droops: give a droop for each overhang",
            size=lengths.size,
            size_2=drops.size,
        )
    for L, d in zip(lengths, drops, strict=True):
        require_positive(L, "overhang", "mm")
        require_positive(d, "droop", "mm")
        if d >= L:
            raise InputError(
                "an overhang of {l:g} cannot droop by {d:g}. Measure the drop of the free end below the "
                "clamp, and the free length along the strip",
                d=Length(d),
                l=Length(L),
            )
        if d > 0.95 * L:
            raise InputError(
                "a droop of {d:g} on an overhang of {l:g} does not depend on the stiffness, because the "
                "strip hangs like a rope. Use a shorter overhang; a droop of about half the overhang is best",
                d=Length(d),
                l=Length(L),
            )
        if d < 1e-4 * L:
            raise InputError(
                "a droop of {d:g} on an overhang of {l:g} is too small to measure: use a longer overhang",
                d=Length(d),
                l=Length(L),
            )
    return lengths, drops


def _fit(overhang: float, droop: float) -> tuple[float, float]:
    """Return the elasto-gravity length, mm, and the norm of its gradient with respect to overhang and droop."""
    part = droop / overhang
    value = overhang * _length_for(part)
    step = 1e-3 * min(part, 1 - part)
    # the length is L G(d / L) for overhang L and droop d, with the derivatives G - (d / L) G1 and G1
    G1 = (_length_for(part + step) - _length_for(part - step)) / (2 * step)
    return value, float(np.hypot(G1, value / overhang - part * G1))


def _length_for(part: float) -> float:
    """Return the ratio of elasto-gravity length to overhang for the ratio `part` of droop to overhang."""
    from scipy.optimize import brentq

    def excess(log_load: float) -> float:
        return cantilever_droop(1.0, float(np.exp(-log_load / 3))) - part

    # lower bound: a strip of length L and weight w per length droops by at most w L^4 / (8 E I)
    low = float(np.log(8 * part)) - 0.05
    high = low + 1.0
    while excess(high) < 0:
        low, high = high, high + 1.0
    return float(np.exp(-brentq(excess, low, high, xtol=1e-10) / 3))


def _weighted_mean(values: FloatArray, errors: FloatArray) -> tuple[float, float]:
    """Return the mean of values with the weights 1 / errors^2, and its standard error.

    The error is the larger of the propagated error and the scatter of the values. If an error is 0, all weights
    are equal.
    """
    exact = np.any(errors == 0)
    weights = np.ones(values.shape) if exact else errors**-2
    mean = float(np.average(values, weights=weights))
    inner = 0.0 if exact else float(weights.sum() ** -0.5)
    if values.size == 1:
        return mean, inner
    scatter = float(np.sqrt(np.average((values - mean) ** 2, weights=weights) / (values.size - 1)))
    return mean, max(inner, scatter)
