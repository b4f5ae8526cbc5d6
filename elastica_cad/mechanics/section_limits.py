"""Limits of sections: strain of their layers, and failure of a material beyond its limits."""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import SEEN_APART, numbers
from elastica_cad.errors import InputError, Length, Refusal, note, rounded_down, rounded_up
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import NaturalCurvature, nodal_curvature
from elastica_cad.mechanics.sheets import Sheet, built_in_figures

STRAIN_SLACK = SEEN_APART
"""Relative tolerance of the strain limit, larger than the error of a spline fitted to a curve at the limit."""

BRITTLE = ("plywood", "wood", "veneer", "board", "composite", "rod", "brittle plastic")
"""Kinds of sheets whose breaking strain is estimated with `BRITTLE_FACTOR`."""

OUTCOMES = {
    **dict.fromkeys(BRITTLE, "the material may crack there"),
    **dict.fromkeys(("card", "paper", "metal"), "the material stays bent there"),
    "plastic": "the material creeps there and stays partly bent",
}
"""Behaviour of a sheet beyond its strain limit, by kind of sheet."""


class StrainState(IntEnum):
    """Possible results of the comparison of a strain with its limit, in order of severity."""

    ALLOWED = 0
    WARNED = 1
    REFUSED = 2


@dataclass(frozen=True)
class StrainVerdict:
    """Result of the comparison of a strain with the limit of the sheet.

    Attributes
    ----------
    state : StrainState
        Allowed up to the limit, warned above the limit, refused if the sheet breaks and limits are not ignored.
    used : float
        Ratio of the strain to the limit.
    at : float or None
        Arc length of the strain along the strip, mm.
    outcome : str
        Behaviour of the material at this strain; empty within the limit.
    unloaded : bool
        True if this is the strain of the strip without its loads.
    """

    state: StrainState
    used: float
    at: float | None = None
    outcome: str = ""
    unloaded: bool = False

    @property
    def allowed(self) -> bool:
        """True if the strain is within the long-term limit of the sheet."""
        return self.state is StrainState.ALLOWED

    @property
    def refused(self) -> bool:
        """True if the strip would break."""
        return self.state is StrainState.REFUSED

    @property
    def percent(self) -> int:
        """Strain in percent of the limit.

        The number is rounded such that it exceeds 100 if and only if the strain exceeds the limit.
        """
        percent = round(100 * self.used)
        return min(percent, 100) if self.allowed else max(percent, 101)


def judge_strain(sheet: Sheet, strain: float, at: float | None = None) -> StrainVerdict:
    """Return the result of comparing the strain of the outermost fibre of a sheet with its limit.

    Parameters
    ----------
    sheet : Sheet
    strain : float
        Strain of the outermost fibre, dimensionless.
    at : float, optional
        Arc length of the strain along the strip, mm.

    Examples
    --------
    >>> ply = Sheet.named("birch-plywood-0.8")
    >>> [judge_strain(ply, share * ply.max_strain).state.name for share in (1.0, 1.2, 3.0)]
    ['ALLOWED', 'WARNED', 'REFUSED']
    >>> judge_strain(Sheet.named("card-200gsm"), 0.015).outcome
    'the material stays bent there'
    """
    used = strain / sheet.max_strain
    if used <= 1 + STRAIN_SLACK:
        return StrainVerdict(StrainState.ALLOWED, used, at)
    breaks = breaking_strain(sheet)
    broken = breaks is not None and strain > breaks * (1 + STRAIN_SLACK)
    state = StrainState.REFUSED if broken else StrainState.WARNED
    return StrainVerdict(
        state, used, at, OUTCOMES.get(sheet.kind, "the material may crack there, or stay bent")
    )


def breaking_strain(sheet: Sheet) -> float | None:
    """Return the breaking strain of a sheet (estimated for brittle kinds), or None if it is unknown."""
    strain = sheet.break_strain
    if strain is not None and strain > sheet.max_strain:
        return strain
    # estimated breaking strain of wood and brittle plastics
    return 1.5 * sheet.max_strain if sheet.kind in BRITTLE else None


# number of points of a curve, so that its largest curvature is found within `STRAIN_SLACK`
BEND_SAMPLES = 1281


def sharpest_bend(curve: PlaneCurve, rest: NaturalCurvature) -> tuple[float, float]:
    """Return the largest change of curvature, 1/mm, from unbent strip to curve, and its position, mm."""
    samples = curve.sample(BEND_SAMPLES)
    bend = np.abs(samples.curvature - nodal_curvature(rest, samples.s))
    most = int(bend.argmax())
    return float(bend[most]), float(samples.s[most])


def sharp_bend_message(sheet: Sheet, bend: float, at: float) -> Refusal | None:
    """Return the message on a change of curvature `bend`, 1/mm, that the sheet does not allow `at` mm, or None."""
    judged = judge_strain(sheet, bend * sheet.thickness / 2, at)
    if judged.allowed:
        return None
    return note(
        "The strip would break {s} from the start: its radius there is {radius}, but the sheet needs at "
        "least {least}. Draw the curve {times:.2g} times as large, or use a thinner sheet."
        if judged.refused else
        "The strain exceeds its limit {s} from the start: the radius there is {radius}, but the sheet needs "
        "at least {least}; {outcome}. Draw the curve {times:.2g} times as large, or use a thinner sheet.",
        s=Length(at), radius=Length(rounded_down(1 / bend, 3)), least=Length(rounded_up(judged.used / bend, 3)),
        times=rounded_up(judged.used, 2), outcome=note(judged.outcome), percent=judged.percent,
        breaks=judged.refused,
    )  # fmt: skip


def thinner_for(sheet: Sheet, strain: float) -> float | None:
    """Return the thickness, mm, of the thickest thinner sheet on sale that withstands the same curve, or None.

    `strain` is the strain of the given sheet.

    Examples
    --------
    >>> thinner_for(Sheet.named("birch-plywood-3"), 0.008)
    2.0
    """
    for thickness in thinner_on_sale(sheet):
        if judge_strain(sheet.with_thickness(thickness), strain * thickness / sheet.thickness).allowed:
            return thickness
    return None


def thinner_on_sale(sheet: Sheet) -> list[float]:
    """Return the smaller thicknesses in which this sheet is sold, mm, in decreasing order."""
    stem = sheet.name.removesuffix(f"-{sheet.thickness:g}")
    sold = (
        figures["thickness"] for name, figures in built_in_figures().items() if name.startswith(f"{stem}-")
    )
    return sorted((float(thickness) for thickness in sold if thickness < sheet.thickness), reverse=True)


SMALL_MM = 150.0
"""Length of a strip, mm, below which the unit of its curve is doubted if the sheet is strained far too much."""

UNIT_FACTOR = 2.0
"""Factor needed on the size of a curve from which its unit is doubted. A curve in cm needs a factor up to 10."""


def unit_question(used: float, length: float) -> str:
    """Return the question about the unit of a curve that is too small for its sheet, or "".

    The question replaces the advice to enlarge the curve.

    Parameters
    ----------
    used : float
        Strain divided by its limit, which is also the factor needed on the size of the curve.
    length : float
        Length of the strip, mm.
    """
    doubted = used > UNIT_FACTOR and length < SMALL_MM
    return note("Lengths are in mm: was the curve drawn in cm, inches or metres?") if doubted else ""


LIMIT_SLACK = 1e-9
"""Relative tolerance of limits that a design may reach exactly."""


@dataclass(frozen=True, eq=False)
class LayerStrain:
    """Strain of the outermost fibre of a layer.

    Attributes
    ----------
    sheet : Sheet
    strain : (n,) array
        Distance from the neutral axis times the absolute change of curvature; 0 at stations without the layer.
    """

    sheet: Sheet
    strain: FloatArray

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self.sheet.name

    @property
    def limit(self) -> float:
        """Largest long-term strain of the sheet."""
        return self.sheet.max_strain

    @cached_property
    def largest(self) -> float:
        """Largest strain along the strip."""
        return float(self.strain.max())

    @property
    def station(self) -> int:
        """Index of the station with the largest strain."""
        return int(self.strain.argmax())

    def judged(self, at: float | None = None) -> StrainVerdict:
        """Compare the largest strain, at arc length `at` (mm), with the limit of the sheet."""
        return judge_strain(self.sheet, self.largest, at)


@dataclass(frozen=True)
class ScaleRange:
    """Scales c for which the bending stiffness c K can be built inside a given outer width (paper, section 8.1).

    Attributes
    ----------
    lowest, highest : float
        Limits of the scale, N mm2: the largest of the lower limits and the least of the upper limits of all
        stations. If the least relative stiffness K is 1, c is the least bending stiffness.
    lowest_at, highest_at : int
        Indices of the stations that determine these limits.
    """

    lowest: float
    highest: float
    lowest_at: int
    highest_at: int

    @classmethod
    def of(cls, least: ArrayLike, most: ArrayLike, stiffness: ArrayLike) -> "ScaleRange":
        """Return the scales for stations whose E I is limited to values from `least` to `most` (n,), N mm2.

        `stiffness` (n,) is the relative stiffness of the stations.
        """
        K = positive(stiffness, "stiffness")
        low_EI, high_EI, K = matched(
            numbers(least, "least bending stiffness"), numbers(most, "most bending stiffness"), K
        )
        if not K.size:
            raise InputError("the array of stiffnesses is empty: give at least one stiffness")
        c_min, c_max = low_EI / K, high_EI / K
        low, high = int(c_min.argmax()), int(c_max.argmin())
        return cls(float(c_min.flat[low]), float(c_max.flat[high]), low, high)

    @property
    def feasible(self) -> bool:
        """True if at least one scale can be built."""
        return self.lowest <= self.highest * (1 + LIMIT_SLACK)

    @property
    def scale(self) -> float:
        """Largest scale that can be built within the outer width (paper, section 8.1)."""
        if not self.feasible:
            raise InputError(
                f"no bending stiffness (where the relative stiffness K is 1) suits all stations (numbered from "
                f"0): station {self.lowest_at} needs "
                f"at least {self.lowest:.4g} N mm2, station {self.highest_at} at most {self.highest:.4g} N "
                f"mm2. Widen the strip at station {self.highest_at}, narrow the strip at station "
                f"{self.lowest_at}, or lower the stiffness ratio"
            )
        return self.highest


def matched(*rows: FloatArray) -> tuple[FloatArray, ...]:
    """Return arrays of the same length; an array with a single value is repeated for all stations."""
    try:
        return tuple(np.broadcast_arrays(*rows))
    except ValueError:
        sizes = " and ".join(str(row.size) for row in rows)
        raise InputError(
            f"the arrays have {sizes} values: give each array one value, or one value per station"
        ) from None


def positive(values: ArrayLike, name: str) -> FloatArray:
    """Return the values (n,) as an array; refuse values that are not positive and finite."""
    array = numbers(values, name)
    good = np.isfinite(array) & (array > 0)
    if not good.all():
        i = int(good.argmin())
        raise InputError(f"{name} is {array.flat[i]:.6g} at station {i} (from 0): give a number above 0")
    return array
