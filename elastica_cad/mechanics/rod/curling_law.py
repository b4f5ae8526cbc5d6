"""The moment of sections that curl across: how stiff each place is follows how it is bent."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.polynomials.panel_functions import gauss_rule
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw
from elastica_cad.mechanics.material.stiffness_law import BendFactor, at_stations

DIFFERENCE_SHARE = 1e-7
"""Of the largest bend: step of the differences that tell how the stiffness follows."""

GAUSS_POINTS = 24
"""Between rest and bend, where the energy is summed: right to 1e-9 for blanks that are flat, to 1e-3 for others."""

NEWTON_STEPS = 8
"""To the curvature that a moment belongs to; the stiffness follows slowly, so the last ones only round."""


@dataclass(frozen=True, eq=False)
class CurlingLaw(MaterialLaw):
    """M = K m(kappa - kappa_0) at the nodes of one rod, whose K is right where each node is bent as designed.

    Parameters
    ----------
    factor : BendFactor
        On the stiffness of the nodes, by their curvatures.
    designed : (n,) array
        The factor that K has already.
    natural_curvature : float or (n,) array
        kappa_0 of the rod, 1/mm.
    below : MaterialLaw, optional
        That of the material, which the factor comes on top of.

    Examples
    --------
    >>> from elastica_cad.mechanics.material.anticlastic import SheetCurl
    >>> wide = SheetCurl(np.full(2, 40.0), 0.5, 0.3)
    >>> law = CurlingLaw(wide, wide(np.array([0.0, 0.01])))
    >>> law.effective_curvature([0.01, 0.01]).round(5).tolist()
    [0.01078, 0.01]
    """

    factor: BendFactor
    designed: FloatArray
    natural_curvature: float | FloatArray = 0.0
    below: MaterialLaw | None = None

    def share(self, curvature: ArrayLike) -> FloatArray:
        """What the stiffness is times that of the design (..., n), for changes of curvature (..., n), 1/mm."""
        kappa = np.asarray(curvature, dtype=float) + self.natural_curvature
        return np.asarray(self.factor(kappa) / self.designed)

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`; of all nodes (..., n)."""
        return np.asarray(self._material(curvature) * self.share(curvature))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`; of all nodes (n,)."""
        return self.with_slope(curvature)[1]

    def with_slope(self, curvature: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """See `MaterialLaw`; of all nodes (n,) each."""
        change = np.asarray(curvature, dtype=float)
        step = DIFFERENCE_SHARE * (float(np.abs(change).max()) or 1.0)
        here, beyond = self.share(np.stack([change, change + step]))
        m, slope = (change, 1.0) if self.below is None else self.below.with_slope(change)
        return m * here, np.asarray(slope * here + m * (beyond - here) / step)

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`; of all nodes (n,)."""
        change = np.asarray(curvature, dtype=float)
        x, weight = gauss_rule(GAUSS_POINTS)
        root = (x + 1) / 2  # closer together near rest, where the stiffness follows soonest
        return np.asarray(change * ((weight * root) @ self.effective_curvature(root[:, None] ** 2 * change)))

    def curvature(self, effective: ArrayLike) -> FloatArray:
        """See `MaterialLaw`; of all nodes (n,)."""
        m = np.asarray(effective, dtype=float)
        change = m if self.below is None else self.below.curvature(m)
        for _ in range(NEWTON_STEPS):
            found, slope = self.with_slope(change)
            change = change - (found - m) / slope
        return change

    def resampled(self, s: FloatArray, at: FloatArray) -> "CurlingLaw":
        """See `MaterialLaw`."""
        return CurlingLaw(
            self.factor.resampled(s, at), np.interp(at, s, self.designed),
            at_stations(self.natural_curvature, s, at),
            None if self.below is None else self.below.resampled(s, at),
        )  # fmt: skip

    @property
    def injective_limit(self) -> float:
        """See `MaterialLaw`."""
        return float("inf") if self.below is None else self.below.injective_limit

    def _material(self, curvature: ArrayLike) -> FloatArray:
        change = np.asarray(curvature, dtype=float)
        return change if self.below is None else self.below.effective_curvature(change)
