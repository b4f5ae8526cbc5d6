"""A stack of equal leaves glued together, of which some end before others: stiffness in steps."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.mechanics.material.section_limits import LayerStrain
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import ThicknessLaw

MOST_LEAVES = 50
"""More leaves are as good as a taper."""


@dataclass(frozen=True)
class LeavesLaw:
    """One to `leaves` leaves of a sheet, glued to one section: E I = E w (k h)^3 / 12 for k of them.

    Parameters
    ----------
    sheet : Sheet
        Of a leaf: its thickness h counts. The glue has none.
    leaves : int
        Of the whole stack, at most.
    width : float
        mm.

    Examples
    --------
    >>> law = LeavesLaw(Sheet("leaf", 2.0, 12.0, density=1000.0, max_strain=0.01), 4, width=10.0)
    >>> law.bending_stiffness([1, 2, 4]).tolist(), law.relaxed.limits
    ([80.0, 640.0, 5120.0], (2.0, 8.0))
    """

    sheet: Sheet
    leaves: int
    width: float

    def __post_init__(self) -> None:
        if not isinstance(self.sheet, Sheet):
            raise InputError(f"a Sheet is needed for the leaves, not {self.sheet!r}")
        whole = isinstance(self.leaves, int | np.integer) and not isinstance(self.leaves, bool)
        if not whole or not 2 <= self.leaves <= MOST_LEAVES:
            raise InputError(f"leaves is {self.leaves!r}: give a whole number from 2 to {MOST_LEAVES}")
        _ = self.relaxed  # which refuses a width that is none

    @cached_property
    def relaxed(self) -> ThicknessLaw:
        """The same stack where any thickness between one leaf and all may be had."""
        h = self.sheet.thickness
        return ThicknessLaw(self.sheet, h, self.leaves * h, width=self.width)

    def bending_stiffness(self, count: ArrayLike) -> FloatArray:
        """E I (n,), N mm2, of `count` (n,) leaves."""
        return self.relaxed.bending_stiffness(self.thickness(count))

    def weight_per_length(self, count: ArrayLike) -> FloatArray:
        """N/mm (n,) of `count` (n,) leaves."""
        return self.relaxed.weight_per_length(self.thickness(count))

    def strains(
        self, curvature: ArrayLike, count: ArrayLike, *, natural_curvature: float = 0.0
    ) -> tuple[LayerStrain, ...]:
        """Strain of the outermost fibre: glued leaves bend as one section."""
        return self.relaxed.strains(curvature, self.thickness(count), natural_curvature=natural_curvature)

    def thickness(self, count: ArrayLike) -> FloatArray:
        """mm (n,) of `count` (n,) leaves."""
        return np.asarray(self.sheet.thickness * np.asarray(count, dtype=float))
