"""Places where a strip lies double: the lap that closes a ring, and plates over the joints of its pieces."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.path import Path
from elastica_cad.mechanics.material.laminated_section import stack_stiffness
from elastica_cad.mechanics.rod.rod_record import Rod

END_MM = 1e-6
"""Material is measured this far inside the free part: across a bare end itself there is none."""

PLATE_END, PLATE_CUT = 0.25, 0.82
"""Thicknesses of a glued plate that carry nothing at each of its ends, and over the joint, where the strip is cut
half through. The first is fitted to the strips of `docs/finite_elements.md`; the second is that of an edge crack in
bending (Tada, Paris and Irwin 1973), in whose place 5.7 thicknesses of the stack would turn as much."""


@dataclass(frozen=True, eq=False)
class LapJoint:
    """What a lap does to the strip that it covers.

    Two layers of widths w and v, bent together to the drawn curvature kappa and glued there, push back with
    (w + v) kappa, where w kappa is asked for; glued they bend as one section of c w, with
    c w = w + v + 12 w v / (w + v) for layers of equal thickness. So the lap bends as c times the strip, from the
    rest curvature kappa - (w + v) / (c w) (kappa - kappa_0), and stays straighter than drawn.

    Attributes
    ----------
    share : (n,) array
        Factor on the stiffness of the rod's cells.
    rest : (n,) array
        Curvature of its cells without moment, 1/mm.
    """

    share: FloatArray
    rest: FloatArray

    @classmethod
    def of(cls, rod: Rod, width: FloatArray, length: float, lap_width: float) -> "LapJoint":
        """The lap of a closed rod.

        Parameters
        ----------
        rod : Rod
            The design.
        width : (n,) array
            Of the material at its nodes, mm.
        length, lap_width : float
            Of the tab, mm.
        """
        # cells reach half an edge to either side of their node
        edges = np.concatenate([[0.0], (rod.s[1:] + rod.s[:-1]) / 2, [rod.length]])
        covered = np.clip((length - edges[:-1]) / np.diff(edges), 0.0, 1.0)
        both = width + lap_width
        stiffer = (both + 12 * width * lap_width / both) / width
        natural = rod.natural_curvature
        lapped = rod.curvature - both / width / stiffer * (rod.curvature - natural)
        return cls(1 / (covered / stiffer + 1 - covered), natural + covered * (lapped - natural))


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
        """Return those of a base's holes that no plate covers; the others are not cut."""
        half = self.lap / 2
        spans = [(hole, hole.bounds[:, 0]) for hole in holes]
        return tuple(
            hole
            for hole, (low, high) in spans
            if not any(low < at + half and high > at - half for at in self.joints)
        )

    def stiffening(self, s: FloatArray, layout: Layout, layers: Sequence[Layer]) -> FloatArray:
        """Factor (n,) on the stiffness of what is cut, in the cell of each of the nodes s (n,), mm.

        Over a plate the strip is a sheet thicker and as stiff as that, but for its ends and over the joint itself.
        """
        base, *more = layers
        at = np.clip(s, END_MM, layout.width.length - END_MM)
        wide, cut = layout.width(at), base.material(at)
        left = np.minimum(replace(base, holes=self.clear_holes(base.holes)).material(at), wide)
        glued = [(layer.sheet, np.minimum(layer.material(at), cut)) for layer in more]
        designed = stack_stiffness([(base.sheet, cut), *glued])
        compliance = np.zeros(s.size)
        on_base = self._covered(s, self.joints, base.sheet.thickness)
        on_backing = self._covered(s, self.backing_joints, layers[-1].sheet.thickness)
        for share, stack in (
            (1 - on_base - on_backing, [(base.sheet, left), *glued]),
            (on_base, [(base.sheet, wide), (base.sheet, left), *glued]),
            (on_backing, [(base.sheet, left), *glued, *glued]),
        ):
            compliance += share * designed / stack_stiffness(stack)
        return np.asarray(1 / compliance)

    def _covered(self, s: FloatArray, joints: Sequence[float], thickness: float) -> FloatArray:
        """Share (n,) of each node's cell that lies under a plate which carries."""
        ends = np.concatenate([s[:1], (s[1:] + s[:-1]) / 2, s[-1:]])
        near = PLATE_CUT / 2 * thickness
        far = max(near, self.lap / 2 - PLATE_END * thickness)
        under = np.zeros(s.size)
        for at in joints:
            for low, high in ((at - far, at - near), (at + near, at + far)):
                under += np.diff(np.clip(ends, low, high))
        return under / np.diff(ends)
