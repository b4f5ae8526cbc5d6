"""The joint of a closed strip: its last tab, glued behind its start while both lie in the drawn curve."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import CORNER_RAD
from elastica_cad.mechanics.rod.rod_record import Rod

MEETING_SHARE = 1e-4
"""Of the length: ends that are nearer meet; rods on few nodes close as well as that."""


def closes(rod: Rod) -> bool:
    """Do the ends of a rod meet, one going on in the other?"""
    gap = float(np.hypot(*(rod.position[-1] - rod.position[0])))
    turn = float(np.angle(np.exp(1j * float(rod.angle[-1] - rod.angle[0]))))
    return gap <= MEETING_SHARE * rod.length and abs(turn) <= CORNER_RAD


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
