"""Plates that join the pieces of a strip, and how stiff they make it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.path import Path
from elastica_cad.mechanics.material.laminated_section import stack_stiffness


@dataclass(frozen=True)
class LapPlates:
    """Plates of the strip's own sheet, as wide as the strip and solid, glued over joints of its pieces on one side.

    Attributes
    ----------
    joints : tuple of float
        Where the strip is cut, mm along it; of a laminate its base.
    lap : float
        Length of the plates, half of it on either piece, mm.
    backing_joints : tuple of float
        Where the backing of a laminate is cut, mm along it.
    """

    joints: tuple[float, ...]
    lap: float
    backing_joints: tuple[float, ...] = ()

    def clear_holes(self, holes: Sequence[Path]) -> tuple[Path, ...]:
        """Those of a base's holes that no plate comes to lie on: the others are not cut."""
        half = self.lap / 2
        spans = [(hole, hole.bounds[:, 0]) for hole in holes]
        return tuple(
            hole
            for hole, (low, high) in spans
            if not any(low < at + half and high > at - half for at in self.joints)
        )

    def stiffening(self, s: FloatArray, layout: Layout, layers: Sequence[Layer]) -> FloatArray:
        """Factor (n,) on the stiffness of what is cut, in the cell of each of the nodes s (n,), mm.

        Over a plate the strip is a sheet thicker and as stiff as that; it ends at once, as glue does.
        """
        base, *more = layers
        wide, cut = layout.width(s), base.material(s)
        left = np.minimum(replace(base, holes=self.clear_holes(base.holes)).material(s), wide)
        glued = [(layer.sheet, np.minimum(layer.material(s), cut)) for layer in more]
        designed = stack_stiffness([(base.sheet, cut), *glued])
        compliance = np.zeros(s.size)
        on_base, on_backing = self._covered(s, self.joints), self._covered(s, self.backing_joints)
        for share, stack in (
            (1 - on_base - on_backing, [(base.sheet, left), *glued]),
            (on_base, [(base.sheet, wide), (base.sheet, left), *glued]),
            (on_backing, [(base.sheet, left), *glued, *glued]),
        ):
            compliance += share * designed / stack_stiffness(stack)
        return np.asarray(1 / compliance)

    def _covered(self, s: FloatArray, joints: Sequence[float]) -> FloatArray:
        """Share (n,) of each node's cell that lies under a plate."""
        ends = np.concatenate([s[:1], (s[1:] + s[:-1]) / 2, s[-1:]])
        under = np.zeros(s.size)
        for at in joints:
            under += np.diff(np.clip(ends, at - self.lap / 2, at + self.lap / 2))
        return under / np.diff(ends)
