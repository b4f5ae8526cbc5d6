"""The stiffness of a strip as it is made, where it differs from the design's, and whose doing it is."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.fabrication.holding.held_shape import ANTICLASTIC
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.as_built import cell_means, cell_stations
from elastica_cad.fabrication.strip.diamond_pattern import DiamondPattern
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.running_sums import lengths_along
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.material.anticlastic import SheetCurl, anticlastic_factor
from elastica_cad.mechanics.material.laminated_section import (
    LaminateCurl,
    LaminatedSection,
    laminate_factor,
    stack_stiffness,
)
from elastica_cad.mechanics.material.plain_section import dead_zone_slope
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BendFactor
from elastica_cad.mechanics.rod.rod_record import CurlingLaw, Rod

DEPTHS = 64
"""Depths of a slot at which its idle width is summed: right to a sixty-fourth of its depth."""

SHOULDER_SLOPE = 0.62
"""Length, over depth, of the idle corner beside a tab: fitted to the strips of `docs/finite_elements.md`."""

STEP_SHARE = 0.76
"""Slope of the idle corners beside a step of the width, over that beside a cut: fitted in the same way."""

END_MM = 1e-6
"""Material is measured this far inside the free part: across a bare end itself there is none."""

PLATE_END, PLATE_CUT = 0.25, 0.82
"""Thicknesses of a glued plate that carry nothing at each of its ends, and over the joint, where the strip is cut
half through. The first is fitted to the strips of `docs/finite_elements.md`; the second is that of an edge crack in
bending (Tada, Paris and Irwin 1973), in whose place 5.7 thicknesses of the stack would turn as much."""

LEAST_SHARE = 0.01
"""Of the width: no less is counted as left, for a slot that reaches across."""

NEARLY_MM = 1e-6
"""Stations farther than this from all that is idle of a slot lie beside it, whatever the rounding."""

BORDERS = "borders that curl"
"""Of a laminate's base, beside its backing: what gives way there, as a cause."""

PLATES = "plates"
"""Over joints of pieces, as a cause."""


def _idle_width(slots: Sequence[Slot], width: Profile, s: FloatArray, *, slope: float) -> FloatArray:
    """Width (n,), mm, that carries nothing at the stations s (n,): the slots, and triangles beside them.

    Parameters
    ----------
    slots : sequence of Slot
    width : Profile
        Full width of the strip, mm.
    s : (n,) array
        mm, increasing.
    slope : float
        Length of a triangle over its depth (`mechanics.dead_zone_slope`); 0 for the slots alone.
    """
    idle = np.zeros(s.size)
    for slot in slots:
        points, widths = slot.center_line(width)
        along = lengths_along(points)
        middle = (np.arange(DEPTHS) + 0.5) / DEPTHS * along[-1]
        x = np.interp(middle, along, points[:, 0])
        y = np.interp(middle, along, points[:, 1])
        depth = np.abs(points[-1, 1] - points[0, 1])
        reach = np.interp(middle, along, widths) / 2 + slope * np.abs(y - points[0, 1])
        first, last = np.searchsorted(s, ((x - reach).min() - NEARLY_MM, (x + reach).max() + NEARLY_MM))
        idle[first:last] += depth * np.mean(np.abs(s[first:last, None] - x) <= reach, axis=1)
    return idle


def stiffness_shares(
    rod: Rod, layout: Layout, slots: Sequence[Slot], tab_widths: tuple[float | None, float | None]
) -> dict[str, FloatArray]:
    """What each cause leaves of, or adds to, the designed stiffness in the drawn shape: factors (n,), by cause.

    "slots": the cuts and the idle triangles beside them. "narrow tabs": idle corners at ends that are wider than
    their tabs. "steps of width": the same of the wider side where a plain strip's width jumps. "leaning
    ligaments": a ligament at the angle theta to the strip keeps cos(theta) of its stiffness when its twist is held
    by its mirror image, for a Poisson ratio near 0.3: in sheets of 0 to 0.1 it keeps more (up to 7 and 4 % at 25
    degrees). "anticlastic bending": `anticlastic_factor` of the width, of a ligament in a perforated strip.
    "borders that curl": `laminate_factor` of a laminate. Causes that change nothing are left out.

    Parameters
    ----------
    rod : Rod
        The bent design.
    layout : Layout
    slots : sequence of Slot
    tab_widths : pair of float or None
        mm; None for a tab as wide as the strip's end.
    """
    s, n = cell_stations(rod), rod.s.size
    width = layout.width(s)
    slope = dead_zone_slope(min(layout.sheet.poisson_ratio, 0.5))
    found = {
        "slots": 1 - _idle_width(slots, layout.width, s, slope=slope) / width if slots else None,
        "narrow tabs": _beside_tabs(layout.width, tab_widths, s),
        "steps of width": _beside_steps(layout, s, slope=STEP_SHARE * slope),
        "leaning ligaments": _leaning(layout, s),
        ANTICLASTIC: _anticlastic(rod, layout, s),
        BORDERS: _curling(rod, layout, s),
    }
    # a cell's angle feels the mean compliance
    return {
        cause: 1 / cell_means(1 / np.maximum(share, LEAST_SHARE), n)
        for cause, share in found.items()
        if share is not None
    }


@dataclass(frozen=True, eq=False)
class Curl:
    """How the stiffness of a strip's nodes follows their curvature.

    Attributes
    ----------
    designed : (n,) array
        The factor of the nodes where they are bent as designed.
    factor, plated : BendFactor
        The factor, and that of a strip with plates over its joints: there it is twice as thick, and curls as if it
        were narrower.
    """

    designed: FloatArray
    factor: BendFactor
    plated: BendFactor

    def on(self, made: Rod, *, plated: bool = False) -> Rod:
        """A rod that is as stiff as made where it is bent as designed, and follows its bend elsewhere."""
        factor, below = self.plated if plated else self.factor, made.law
        if isinstance(below, CurlingLaw):  # of a design that was led elsewhere, which curls in the same way
            below = below.below
        return replace(made, law=CurlingLaw(factor, self.designed, made.natural_curvature, below))


def curl_of(rod: Rod, layout: Layout, covered: ArrayLike = 0.0) -> Curl | None:
    """How a strip curls about its design; None where that changes nothing or a section knows its own.

    `covered` is the share (n,) of each node's cell under a plate; plates on a laminate leave its curl as it is.
    """
    s, rest = rod.s, rod.natural_curvature
    if layout.backing is not None:
        section = LaminatedSection(layout.sheet, layout.backing.sheet)
        table = LaminateCurl.about(rod.curvature, layout.width(s), layout.backing.width(s), section, rest)
        return Curl(table(rod.curvature), table, table)
    nu = layout.sheet.poisson_ratio
    if nu == 0 or (layout.section is not None and not layout.section.follows_bend):
        return None
    # what counts is width^2 over thickness
    breadth = _breadth(layout, s)
    bare, plated = (
        SheetCurl(wide, layout.sheet.thickness, nu, rest)
        for wide in (breadth, breadth / np.sqrt(1 + np.asarray(covered)))
    )
    return Curl(bare(rod.curvature), bare, plated)


def curling_by_design(made: Rod, design: Rod, layout: Layout) -> Rod:
    """A rod that follows its bend as its design counts on; where it does not, the rod itself."""
    curl = curl_of(design, layout) if design.follows_bend else None
    return made if curl is None else curl.on(made)


def rod_to_bend(rod: Rod, layout: Layout, *, corrected: bool) -> Rod:
    """A design to be led elsewhere: K stays, and what is cut curls at every place as its bend there makes it.

    Widths that were not made for that leave it out of balance until it is bent; those that are `corrected` are as
    stiff as K in the design. A sheet whose Poisson ratio is only estimated bends with E.
    """
    if rod.follows_bend or isinstance(rod.law, CurlingLaw):
        return rod
    s, rest = rod.s, rod.natural_curvature
    factor: BendFactor
    if layout.backing is not None:
        section = LaminatedSection(layout.sheet, layout.backing.sheet)
        factor = LaminateCurl.everywhere(
            rod.curvature, layout.width(s), layout.backing.width(s), section, rest
        )
    elif layout.section is None and layout.sheet.poisson_known and layout.sheet.poisson_ratio > 0:
        factor = SheetCurl(_breadth(layout, s), layout.sheet.thickness, layout.sheet.poisson_ratio, rest)
    else:
        return rod
    designed = factor(rod.curvature) if corrected else np.ones(s.size)
    return replace(rod, law=CurlingLaw(factor, designed, rest, rod.law))


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

        Over a plate the strip is a sheet thicker and as stiff as that, but for its ends and over the joint itself.
        """
        base, *more = layers
        at = np.clip(s, END_MM, layout.width.length - END_MM)
        wide, cut = layout.width(at), base.material(at)
        left = np.minimum(replace(base, holes=self.clear_holes(base.holes)).material(at), wide)
        glued = [(layer.sheet, np.minimum(layer.material(at), cut)) for layer in more]
        designed = stack_stiffness([(base.sheet, cut), *glued])
        compliance = np.zeros(s.size)
        on_base = self.covered(s, base.sheet)
        on_backing = self._covered(s, self.backing_joints, layers[-1].sheet.thickness)
        for share, stack in (
            (1 - on_base - on_backing, [(base.sheet, left), *glued]),
            (on_base, [(base.sheet, wide), (base.sheet, left), *glued]),
            (on_backing, [(base.sheet, left), *glued, *glued]),
        ):
            compliance += share * designed / stack_stiffness(stack)
        return np.asarray(1 / compliance)

    def covered(self, s: FloatArray, base: Sheet) -> FloatArray:
        """Share (n,) of the cell of each of the nodes s (n,), mm, where a plate on the base carries."""
        return self._covered(s, self.joints, base.thickness)

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


def with_shares(built: Rod, shares: Sequence[FloatArray]) -> Rod:
    """A rod whose stiffness is changed by factors (n,) while its weight stays: out of balance until bent."""
    B, K = built.bending_stiffness or 1.0, built.stiffness
    changed = K * np.prod([np.ones(K.size), *shares], axis=0)
    made = built.with_stiffness(Profile.interpolate(built.s, changed))
    if built.bending_stiffness is not None:
        made = replace(made, bending_stiffness=B * float(changed.min()))
    if built.gravity is None:
        return made
    weight = built.weight or Weight(beta=B / built.gravity.length**3)
    alpha, beta = weight.along(built.s)
    newtons = Profile.interpolate(built.s, alpha + beta * K)
    return replace(made, weight=replace(weight, alpha=newtons, beta=0.0))


def _beside_tabs(
    width: Profile, tab_widths: tuple[float | None, float | None], s: FloatArray
) -> FloatArray | None:
    """Share (n,) of the width that carries beside ends that are wider than their tabs."""
    idle = np.zeros(s.size)
    for end, tab in zip((0.0, width.length), tab_widths, strict=True):
        shoulder = (float(width(end)) - (tab or np.inf)) / 2
        idle += 2 * np.maximum(0.0, shoulder - np.abs(s - end) / SHOULDER_SLOPE)
    return 1 - idle / width(s) if idle.any() else None


def _beside_steps(layout: Layout, s: FloatArray, *, slope: float) -> FloatArray | None:
    """Share (n,) of a plain strip's width that carries beside the places where it jumps."""
    if layout.pattern is not None or layout.backing is not None or layout.size is not None:
        return None
    width, idle = layout.width, np.zeros(s.size)
    for start, end in width.steps:
        before, after = width([start, end]).tolist()
        wider = s <= start if before > after else s >= end
        away = np.abs(s - (start if before > after else end))
        idle += np.where(wider, 2 * np.maximum(0.0, abs(after - before) / 2 - away / slope), 0.0)
    return 1 - idle / width(s) if idle.any() else None


def _leaning(layout: Layout, s: FloatArray) -> FloatArray | None:
    pattern = layout.pattern
    return 1 / np.hypot(1.0, pattern.slopes(s)) if isinstance(pattern, DiamondPattern) else None


def _anticlastic(rod: Rod, layout: Layout, s: FloatArray) -> FloatArray | None:
    """Stiffening (n,) of each station by what it is bent; None for laminates and where a section knows its own."""
    nu = layout.sheet.poisson_ratio
    if nu == 0 or layout.section is not None or layout.backing is not None:
        return None
    return anticlastic_factor(
        _breadth(layout, s),
        np.interp(s, rod.s, rod.curvature),
        thickness=layout.sheet.thickness,
        poisson_ratio=nu,
        natural_curvature=rod.rest_at(s),
    )


def _curling(rod: Rod, layout: Layout, s: FloatArray) -> FloatArray | None:
    """What is left of, or added to, a laminate's stiffness by how its borders give way (n,)."""
    if layout.backing is None:
        return None
    base, backing = layout.width(rod.s), layout.backing.width(rod.s)
    section = LaminatedSection(layout.sheet, layout.backing.sheet)
    # the backing lies on the strip's upper side, to the right of the curve: a turn to the left stretches it
    factor = laminate_factor(base, backing, rod.curvature, section, rod.natural_curvature)
    return np.interp(s, rod.s, factor)


def _breadth(layout: Layout, s: FloatArray) -> FloatArray:
    """Width (n,), mm, of each of the parts side by side that curl on their own."""
    pieces = layout.pattern.ligaments if isinstance(layout.pattern, DiamondPattern) else 1
    return np.asarray(layout.material(s) / pieces)
