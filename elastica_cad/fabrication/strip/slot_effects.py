"""What slots do to the stiffness of a strip, and so to its shape."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.material.notches import dead_zone_slope
from elastica_cad.mechanics.rod.rod_record import Rod

DEPTHS = 64
"""Depths of a slot at which its idle width is summed: right to a sixty-fourth of its depth."""

LEAST_SHARE = 0.01
"""Of the width: no less is counted as left, for a slot that reaches across."""


@dataclass(frozen=True)
class SlotEffect:
    """How the slots of one strip change it.

    Attributes
    ----------
    least_stiffness : float
        What is left of the stiffness at the worst slot, a share of 1.
    at : float
        Arc length of that slot, mm.
    deviation : float
        Largest distance between the shape with slots, bent and held as designed, and the design, mm.
    """

    least_stiffness: float
    at: float
    deviation: float

    def __str__(self) -> str:
        """One sentence."""
        return (
            f"the slots leave {100 * self.least_stiffness:.0f} % of the stiffness at {self.at:.1f} mm and move the "
            f"shape by {self.deviation:.2g} mm"
        )


def _idle_width(slots: Sequence[Slot], width: Profile, s: FloatArray, *, slope: float) -> FloatArray:
    """Width (n,), mm, that carries nothing at the stations s (n,): the slots, and triangles beside them.

    Parameters
    ----------
    slots : sequence of Slot
    width : Profile
        Full width of the strip, mm.
    s : (n,) array
        mm.
    slope : float
        Length of a triangle over its depth (`mechanics.dead_zone_slope`); 0 for the slots alone.
    """
    idle = np.zeros(s.size)
    for slot in slots:
        points, widths = slot.center_line(width)
        along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        middle = (np.arange(DEPTHS) + 0.5) / DEPTHS * along[-1]
        x = np.interp(middle, along, points[:, 0])
        y = np.interp(middle, along, points[:, 1])
        depth = np.abs(points[-1, 1] - points[0, 1])
        reach = np.interp(middle, along, widths) / 2 + slope * np.abs(y - points[0, 1])
        idle += depth * np.mean(np.abs(s[:, None] - x) <= reach, axis=1)
    return idle


def _slotted_rod(strip: Strip) -> Rod:
    """The strip as built, with the material beside its slots idle too: out of balance until bent."""
    made, width = strip.as_built, strip.width
    W = width(made.s)
    slope = dead_zone_slope(strip.sheet.poisson_ratio)
    left = [W - _idle_width(strip.slots, width, made.s, slope=k) for k in (slope, 0.0)]
    K = made.stiffness * np.maximum(left[0], LEAST_SHARE * W) / np.maximum(left[1], LEAST_SHARE * W)
    B = made.bending_stiffness
    return replace(
        made.with_stiffness(Profile.interpolate(made.s, K)),
        bending_stiffness=None if B is None else B * float(K.min() / made.stiffness.min()),
    )


def slot_effect(strip: Strip) -> SlotEffect:
    """Loss of stiffness at the slots of a strip, and how far its shape strays for it.

    Raises
    ------
    NotConvergedError
        The slotted strip has no rest shape near the design.
    """
    width, s = strip.width, strip.rod.s
    slope = dead_zone_slope(strip.sheet.poisson_ratio)
    share = 1 - _idle_width(strip.slots, width, s, slope=slope) / width(s)
    worst = int(np.argmin(share))
    bent = bend(_slotted_rod(strip))
    deviation = float(np.hypot(*(bent.position - strip.rod.position).T).max())
    return SlotEffect(float(share[worst]), float(s[worst]), deviation)
