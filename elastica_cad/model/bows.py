"""Bows: rods and strips that are held bent by a cord between their ends."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers, require_number
from elastica_cad.defaults import TAB_LENGTH
from elastica_cad.errors import FaultError, InputError, refuse_unknown
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import largest_deviation
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import angle_of, left_of, norm
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.cross_sections import RoundLaw, ThicknessLaw
from elastica_cad.mechanics.elements import ElementForce, PointForce, Tie
from elastica_cad.mechanics.loads import PointMass, Supports, require_curve
from elastica_cad.mechanics.rod import Rod, camber_of
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.own_weight import with_weight
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import DOWN, make_strip
from elastica_cad.strip.travel import Travel, bend_strip
from elastica_cad.strip.uncuttable_parts import FabricationLimits, find_strip_faults, limits_or_default

ENDS = Supports("pinned", "pinned")
"""Supports of a computed bow. Like a cord, pinned ends carry no moment and keep their distance.

They also fix the direction of the line between the ends, which a cord does not.
"""

SHORTER = (0.02, 0.05, 0.1, 0.2)


@dataclass(frozen=True, eq=False)
class Bow:
    """Rod or strip that is held bent by a cord between its ends; see `bow`.

    Attributes
    ----------
    drawn : PlaneCurve
        Drawn curve. The bow has the same end points.
    strip : Strip
        Strip or rod with pinned ends at the ends of the cord. The weight is neglected.
    hole : float
        Diameter of the hole for the cord at each end of the cord, mm; 0 for none.
    """

    drawn: PlaneCurve
    strip: Strip
    hole: float = 0.0

    def __repr__(self) -> str:
        return f"<Bow of {self.length:.4g} mm, cord {self.cord:.4g} mm, pull {self.pull:.3g} N>"

    @property
    def length(self) -> float:
        """Length of the rod between the ends of the cord, mm."""
        return self.strip.rod.length

    @property
    def cord(self) -> float:
        """Length of the cord, mm."""
        return float(norm(self.strip.rod.chord))

    @property
    def pull(self) -> float:
        """Force in the cord, N."""
        return float(self.strip.reactions().sizes[0][0])

    @property
    def rise(self) -> float:
        """Largest distance of the bow from the cord, mm."""
        return rise_of(self.strip.rod)

    @property
    def end_angles(self) -> FloatArray:
        """Angles (2,), rad, of the bow at its start and end, measured from the direction from start to end."""
        turn = self.strip.rod.angle[[0, -1]] - angle_of(self.strip.rod.chord)
        return np.asarray(turn - 2 * np.pi * np.round(turn.mean() / (2 * np.pi)))

    @cached_property
    def pattern(self) -> Strip:
        """Strip as it is cut, with the holes for the cord."""
        rod = self.strip.rod
        if not self.hole:
            return self.strip
        # a tie without force adds the holes
        cord = Tie(0.0, rod.length, hole=self.hole)
        holes = ElementForce(cord, np.array([0.0, rod.length]), np.zeros((2, 2)))
        return replace(self.strip, rod=replace(rod, between=(holes,)))

    @cached_property
    def deviation(self) -> float:
        """Largest distance between the drawn curve and the bow, mm."""
        bent = self.strip.rod.curve
        return max(largest_deviation(self.drawn, bent), largest_deviation(bent, self.drawn))

    def shortened(self, shares: Sequence[float] = SHORTER) -> Travel:
        """Return the states of the bow for a cord that is shortened by each fraction of its length in `shares`."""
        rod = self.strip.rod
        for share in numbers(shares, "shares").tolist():
            if not 0 <= share < 1:
                raise InputError(
                    "The cord cannot be shortened by {percent:g} %. Give at least 0 and less than 100 %.",
                    percent=100 * share,
                )
        return bend_strip(self.strip, [rod.position[0] + (1 - share) * rod.chord for share in shares])

    def under(self, loads: Sequence[PointMass | PointForce]) -> Travel:
        """Return the bow under its weight and loads. Its ends stand at the distance of the cord; -y is down."""
        return bend_strip(with_weight(self.strip, self.strip.sheet.gravity()), [{"loads": loads}])


def bow(curve: PlaneCurve, sheet: Sheet | str, *, hole: float = 0.0, **fields: Any) -> Bow:
    """Return the rod or strip that a cord between its ends bends into a given curve.

    A constant section (`min_width` equal to `max_width`, or a section with equal limits) bends into an elastica.
    The result is then the bow that has the end points and length of the curve and bulges to the same side.
    `deviation` is its distance from the curve. A varying section gets widths or diameters with which the
    result bends exactly into the curve. The curvature of the curve must then be 0 at both ends.

    Parameters
    ----------
    curve : PlaneCurve
    sheet : Sheet or str
        Material, and thickness of a strip.
    hole : float
        Diameter of the hole for the cord at each end of the cord, mm; 0 for none. The tabs of the strip are
        outside the holes, and by default long enough for them.
    **fields
        Fields of `StripSpec`: `max_width` for a strip, `section=RoundLaw(...)` for a rod, `limits` for the
        nearest possible curve. For a constant section, only `max_width`, `min_width`, `section`, `ends` and
        `label` are allowed.

    Raises
    ------
    NotRealizable
        No bow with a varying section has the shape of the curve.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> from elastica_cad.mechanics import RoundLaw
    >>> glass = ec.Sheet("glass", 8.0, 38000.0, density=1900.0, max_strain=0.02)
    >>> arc = ec.PlaneCurve.arc((0, 0), 500, 0.8 * np.pi, 0.2 * np.pi)
    >>> kite = bow(arc, glass, section=RoundLaw(glass, 8.0, 8.0))
    >>> round(kite.cord, 1), round(kite.pull), round(kite.deviation, 1)
    (809.0, 91, 9.5)
    """
    require_curve(curve)
    sheet = Sheet.of(sheet)
    if require_number(hole, "hole", "mm") < 0:
        raise InputError("hole is {hole:g}. Give a diameter in mm, or 0 for no hole.", hole=hole)
    chord = float(norm(curve.survey.position[-1] - curve.survey.position[0]))
    # the least difference between the lengths of bow and cord
    least = 1e-6 * curve.length
    if chord < least:
        raise InputError(
            "The curve is closed, so a cord between its ends does not bend it. Draw an open arch."
        )
    if curve.length - chord < least:
        raise InputError("The curve is straight, so a cord between its ends is slack. Draw an open arch.")
    if hole:  # the tabs hold the outer half of the hole
        tab = Tab(max(TAB_LENGTH, hole / 2 + _least_beside(sheet, fields.get("shop"))))
        fields = {"ends": (tab, tab)} | fields
    section, width = fields.get("section"), fields.get("max_width")
    if isinstance(section, RoundLaw | ThicknessLaw):
        is_constant = section.least == section.largest
    else:
        is_constant = section is None and width is not None and width == fields.get("min_width")
    if is_constant:
        others = {name: fields[name] for name in fields.keys() - {"section", "max_width", "min_width"}}
        refuse_unknown(others, {"ends", "label"}, "a bow of constant section")
        start, end = curve.survey.position[[0, -1]]
        across = (curve.survey.position - start) @ left_of(end - start)
        # the relative error of the force in the cord is then 2e-7
        flat = Rod.straight(
            curve.length, samples=2401, start=start, angle=float(angle_of(end - start)),
            supports=ENDS, section=section or PlainSection.as_plate(sheet, width),
        )  # fmt: skip
        rod = bend(flat, end=end, side=1 if across.mean() >= 0 else -1)
        strip = Strip(rod, sheet, max_width=width, **others)
    else:
        level = {"frame": Frame(), "gravity": DOWN}  # the weight of a bow is neglected
        wide = room_for_hole(hole, sheet, **fields) if fields.get("limits") or fields.get("keep") else {}
        strip = make_strip(curve, sheet, supports=ENDS, **(level | fields | wide))
    result = Bow(curve, strip, hole)
    if hole and not fields.get("ignore_limits"):
        known = {fault.what for fault in find_strip_faults(strip, fields.get("shop"))}
        for fault in find_strip_faults(result.pattern, fields.get("shop")):
            if fault.what not in known:
                raise FaultError(
                    "The hole for the cord is too large: {what}. Make the hole smaller, or the strip wider.",
                    what=fault.what,
                )
    return result


def room_for_hole(hole: float, sheet: Sheet, **fields: Any) -> dict[str, float]:
    """Return the field `min_width` with which the sheet has enough material beside a hole of diameter `hole`, mm.

    The result is empty without a hole, and if the strip may not be so wide.
    """
    least = hole + 2 * _least_beside(sheet, fields.get("shop"))
    fits = hole and fields.get("max_width", np.inf) > least > (fields.get("min_width") or 0)
    return {"min_width": least} if fits else {}


def _least_beside(sheet: Sheet, shop: FabricationLimits | None) -> float:
    limits = limits_or_default(shop)
    return min(limits.width_for(sheet), limits.bridge_for(sheet))


def rise_of(rod: Rod) -> float:
    """Return the largest distance, mm, of a rod from the line between its ends."""
    return camber_of(rod)[0] * float(norm(rod.chord))
