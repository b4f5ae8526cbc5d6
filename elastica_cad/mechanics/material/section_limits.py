"""What a cross-section may bear and hold: strains against limits, scales that can be built."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.strain_rule import StrainVerdict, judge_strain

LIMIT_SLACK = 1e-9
"""Relative slack on limits that a design may touch."""


@dataclass(frozen=True, eq=False)
class LayerStrain:
    """Strain of the outermost fibre of one layer.

    Attributes
    ----------
    sheet : Sheet
    strain : (n,) array
        Distance from the neutral axis times |kappa - kappa_0|; 0 where the layer is missing.
    """

    sheet: Sheet
    strain: FloatArray

    @property
    def name(self) -> str:
        """The sheet's."""
        return self.sheet.name

    @property
    def limit(self) -> float:
        """What the sheet bears for long."""
        return self.sheet.max_strain

    @cached_property
    def largest(self) -> float:
        """The largest strain along the strip."""
        return float(self.strain.max())

    @property
    def station(self) -> int:
        """Index of the largest strain."""
        return int(np.argmax(self.strain))

    def judged(self, at: float | None = None) -> StrainVerdict:
        """What the rule of strain says of it; `at`: where the largest strain is, mm."""
        return judge_strain(self.sheet, self.largest, at)


@dataclass(frozen=True)
class ScaleRange:
    """Scales c for which E I = c K can be built inside a given outer width (paper, section 8.1).

    Attributes
    ----------
    lowest, highest : float
        max c_min and min c_max over the stations, N mm2 (with min K = 1, c is the least bending stiffness).
    lowest_at, highest_at : int
        Stations that decide them.
    """

    lowest: float
    highest: float
    lowest_at: int
    highest_at: int

    @classmethod
    def of(cls, least: ArrayLike, most: ArrayLike, stiffness: ArrayLike) -> "ScaleRange":
        """The range from the least and most E I (n,), N mm2, that each station can have, and K (n,)."""
        K = positive(stiffness, "stiffness")
        low_EI, high_EI, K = matched(
            numbers(least, "least bending stiffness"), numbers(most, "most bending stiffness"), K
        )
        if not K.size:
            raise InputError("there is no station to find a scale for: give one stiffness or more")
        c_min, c_max = low_EI / K, high_EI / K
        low, high = int(np.argmax(c_min)), int(np.argmin(c_max))
        return cls(float(c_min.flat[low]), float(c_max.flat[high]), low, high)

    @property
    def feasible(self) -> bool:
        """Can the stiffness be built at all?"""
        return self.lowest <= self.highest * (1 + LIMIT_SLACK)

    @property
    def scale(self) -> float:
        """The paper's choice c = min c_max: as much added material as the outer width takes.

        Raises
        ------
        InputError
            When nothing fits; the message says which stations disagree.
        """
        if not self.feasible:
            raise InputError(
                f"no scale fits: station {self.lowest_at} needs E I of at least {self.lowest:.4g} N mm2 per "
                f"unit of stiffness and station {self.highest_at} takes at most {self.highest:.4g}; widen "
                f"the strip at station {self.highest_at}, narrow it at station {self.lowest_at} or lower the "
                "stiffness ratio"
            )
        return self.highest


def matched(*rows: FloatArray) -> tuple[FloatArray, ...]:
    """Rows of one value for each station, or one for all, as rows of the same length."""
    try:
        return tuple(np.broadcast_arrays(*rows))
    except ValueError:
        sizes = " and ".join(str(row.size) for row in rows)
        raise InputError(
            f"there are {sizes} finite values: give one a station, as many in each, or one for all"
        ) from None


def positive(values: ArrayLike, name: str) -> FloatArray:
    """The values (n,) as an array; refused with their station where one is not positive and finite."""
    array = numbers(values, name)
    good = np.isfinite(array) & (array > 0)
    if not good.all():
        i = int(np.argmin(good))
        raise InputError(f"{name} is {array.flat[i]:.6g} at station {i}: it must be positive")
    return array
