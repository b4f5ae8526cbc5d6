"""What turns a cross-section's parameter into stiffness, weight and strain, and back."""

from typing import Protocol, Self

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.mechanics.material.section_limits import LayerStrain
from elastica_cad.mechanics.material.tapered_sections import LaidLeaves

SAME_SCALE = 1e-4
"""Relative difference of bending stiffnesses that an optimal rod's own accuracy explains."""

BETWEEN_NODES = 1e-3
"""Relative height by which the stiffness of a rod may rise between the nodes that a limit was kept at."""


class StiffnessLaw(Protocol):
    """A cross-section with one parameter, mm, that varies along the strip and decides its bending stiffness.

    The parameter is a width at fixed thickness, a thickness at fixed width or a diameter. What else is given along
    the strip, as the base of a laminate is, belongs to the law, station by station.
    """

    def bending_stiffness(self, parameter: ArrayLike, /) -> FloatArray:
        """E I (n,), N mm2, of parameters (n,), mm."""

    def parameter(self, bending_stiffness: ArrayLike, /) -> FloatArray:
        """Parameters (n,), mm, that give the E I (n,), N mm2."""

    def weight_per_length(self, parameter: ArrayLike, /) -> FloatArray:
        """N/mm (n,) of parameters (n,), mm."""

    def strains(
        self, curvature: ArrayLike, parameter: ArrayLike, /, *, natural_curvature: float = 0.0
    ) -> tuple[LayerStrain, ...]:
        """Strain of each layer's outermost fibre, of curvatures (n,), 1/mm, and parameters (n,), mm."""


class BoundedLaw(StiffnessLaw, Protocol):
    """A law whose parameter has limits: what `optimal_rod` and `nearest_rod` take as `section`."""

    @property
    def quantity(self) -> str:
        """What the parameter is: "width", "thickness" or "diameter"."""

    @property
    def limits(self) -> tuple[float, float]:
        """Least (0: none) and largest parameter, mm."""

    @property
    def follows_bend(self) -> bool:
        """Does its stiffness hang on how sharply it is bent? Its scale is then known once the bend is."""

    @property
    def stack(self) -> LaidLeaves | None:
        """The glued leaves that it is, as they lie; None for one piece."""

    def bent(self, curvature: ArrayLike, rest: ArrayLike = 0.0, /) -> "BoundedLaw":
        """The law at stations bent by kappa - kappa_0 (n,) from `rest`, kappa_0, 1/mm.

        Itself where bending does not change it.
        """

    def curl(self, parameter: FloatArray, /) -> "BendFactor | None":
        """How the stiffness of parameters (n,), mm, follows their bend; None where bending does not change it."""


class BendFactor(Protocol):
    """On the stiffness of the stations of one strip, by what each of them is bent to."""

    def __call__(self, curvature: FloatArray, /) -> FloatArray:
        """The factor of the stations (..., n) at their curvatures (..., n), 1/mm."""

    def resampled(self, s: FloatArray, at: FloatArray, /) -> Self:
        """The same at stations (m,), mm, of what has it at `s` (n,)."""


def at_stations(values: float | FloatArray, s: FloatArray, at: FloatArray) -> float | FloatArray:
    """Values (..., n) at arc lengths `s` (n,), mm, at others (m,); one number is the same everywhere.

    Examples
    --------
    >>> s = np.array([0.0, 2.0])
    >>> at_stations(s**2, s, np.array([0.0, 1.0, 2.0])).tolist(), at_stations(3.0, s, s)
    ([0.0, 2.0, 4.0], 3.0)
    """
    if np.ndim(values) == 0:
        return values
    return np.apply_along_axis(lambda row: np.interp(at, s, row), -1, values)


def scale_within(
    law: BoundedLaw, stiffness: FloatArray, *, solved: float | None = None, heavy: bool = False
) -> float:
    """The B, N mm2, of a rod of nodal K (n,): that with which its largest, or else its least, section is the limit.

    Parameters
    ----------
    law : BoundedLaw
        At the stations, bent as they are.
    solved : float, optional
        What the rod's own balance says. A heavy rod is in balance under the weight of its sizes; a light one may
        be as large as its limits let it, as the strain it was found within lets its thickness.
    """
    least, largest = law.limits
    limited = bool(np.isfinite(largest))
    scales = law.bending_stiffness(np.full(stiffness.size, largest if limited else least)) / stiffness
    B = float(scales.min() if limited else scales.max())
    if solved is None:
        return B
    bounded = solved < B
    # a search keeps its largest size at nodes; what lies between them may be a little larger
    over = limited and B < solved < B * (1 + BETWEEN_NODES)
    kept = (heavy and not over) or bounded or abs(B / solved - 1) < SAME_SCALE
    return solved if kept else B
