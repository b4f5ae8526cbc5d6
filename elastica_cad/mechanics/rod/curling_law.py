"""The moment of sections that curl across: how stiff each place is follows how it is bent."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials.gauss_rule import gauss_rule
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw
from elastica_cad.mechanics.rod.rod_record import Rod

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
    factor : callable
        On the stiffness of the nodes, (..., n) for their curvatures (..., n), 1/mm.
    designed : (n,) array
        The factor that K has already.
    natural_curvature : float or (n,) array
        kappa_0 of the rod, 1/mm.
    below : MaterialLaw, optional
        That of the material, which the factor comes on top of.

    Examples
    --------
    >>> from functools import partial
    >>> from elastica_cad.mechanics.material.anticlastic import anticlastic_factor
    >>> wide = partial(anticlastic_factor, 40.0, thickness=0.5, poisson_ratio=0.3)
    >>> law = CurlingLaw(wide, wide(np.array([0.0, 0.01])))
    >>> law.effective_curvature([0.01, 0.01]).round(5).tolist()
    [0.01078, 0.01]
    """

    factor: Callable[[FloatArray], FloatArray]
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

    @property
    def injective_limit(self) -> float:
        """See `MaterialLaw`."""
        return float("inf") if self.below is None else self.below.injective_limit

    def _material(self, curvature: ArrayLike) -> FloatArray:
        change = np.asarray(curvature, dtype=float)
        return change if self.below is None else self.below.effective_curvature(change)


def as_bent(rod: Rod) -> Rod:
    """A rod in balance with the stiffness that it has in its shape, whose law is the material's alone."""
    law = rod.law
    if not isinstance(law, CurlingLaw):
        return rod
    K = rod.stiffness * law.share(rod.curvature - rod.natural_curvature)
    least = float(K.min())
    B = rod.bending_stiffness
    return replace(
        rod, law=law.below, stiffness=K / least, profile=Profile.interpolate(rod.s, K / least),
        moment=rod.moment / least, force=rod.force / least, bending_stiffness=B and B * least,
    )  # fmt: skip
