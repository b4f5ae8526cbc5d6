"""Model of the finished strip: effects of slots, tabs and curling, its shape in its holders, and the causes of its
deviation from the design, the largest first (row *Accuracy*).
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad.errors import FieldName, Length, NotConvergedError, note
from elastica_cad.geometry.plane_points import cross, left_of, midpoints, unit_vectors
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import BendFactor
from elastica_cad.mechanics.laminated_section import LaminateCurl, LaminatedSection
from elastica_cad.mechanics.loads import Weight
from elastica_cad.mechanics.rod import CurlingLaw, Rod, as_bent, resample
from elastica_cad.mechanics.sections import PlainSection, crack_energy
from elastica_cad.mechanics.sheets import even_shear_ratio
from elastica_cad.strip.element_cuts import CUT, CUT_GRAIN
from elastica_cad.strip.held_shape import (
    ANTICLASTIC,
    LEAF_ENDS,
    LEAST_REPORTED_MM,
    LOOSE_TABS,
    SHEET_KEYS,
    Contribution,
    HeldShape,
    MakingTolerance,
    Seats,
    closes,
    deviation_from,
    open_deviation,
    shape_responses,
    sheet_effects,
)
from elastica_cad.strip.layers import LapPlates, Layer, lap_joint
from elastica_cad.strip.outline import Ends, fix_tab_widths
from elastica_cad.strip.perforation import DiamondPattern
from elastica_cad.strip.slots import Slot
from elastica_cad.strip.styles import Layout
from elastica_cad.strip.tab_seats import EndPose, rest_in_seats

CUTS = 8
"""Number of stations between two nodes of the rod at which the net width is measured."""


def rod_as_built(
    rod: Rod, layout: Layout, layers: Sequence[Layer], added_lengths: Sequence[tuple[float, float]] = ()
) -> Rod:
    """Return the rod with the stiffness and weight of the cut strip.

    Slots, solid ends and rounded tips of holes are included. The stiffness of a node is the inverse of the
    mean compliance between the middles of the adjacent edges. Masses hung on the strip are unchanged.

    Parameters
    ----------
    rod : Rod
        The design.
    layout : Layout
        Flat pattern of the rod in its style (solid, perforated, laminated and so on).
    layers : sequence of Layer
        Layers as they are cut.
    added_lengths : sequence of (float, float)
        Position, mm, and added length, mm, of cuts that the layers do not contain. The strip bends at a cut as
        if it were longer by the added length.

    Returns
    -------
    Rod
        Rod with the shape, supports and gravity of the design. It is not in equilibrium until its rest shape
        is computed.
    """
    if layout.size is not None:  # a planed or turned strip has no cut-outs
        return replace(rod, bending_stiffness=layout.bending_stiffness)
    n, s = rod.s.size, _cell_stations(rod)
    net_widths = [layer.material(s) for layer in layers]
    material = net_widths[0]
    # rounding in the drawing can make the backing slightly wider than the base
    backing = np.minimum(net_widths[1], material) if len(net_widths) > 1 else None
    section, parameter = layout.section_of(material, backing)
    if layout.section is not None:
        section = layout.section.bent(rod.bend_at(s), rod.rest_at(s))
    relative_stiffness = rod.profile(s)
    # designed stiffness divided by that of the cut strip, at each station
    softer = layout.bending_stiffness * relative_stiffness / section.bending_stiffness(parameter)
    # near a step of the stiffness, use the inverse of the mean compliance around the node
    K = rod.stiffness.copy()
    half = rod.length / (rod.s.size - 1) / 2
    if rod.profile.steps:
        jumps = np.array([start for start, _ in rod.profile.steps])
        near = np.abs(rod.s[:, None] - jumps).min(axis=1) <= half
        K[near] = 1 / _cell_means(1 / relative_stiffness, rod.s.size)[near]
    EI = layout.bending_stiffness * K / _cell_means(softer, n)
    if added_lengths:
        EI = EI * _cut_factors(added_lengths, rod)
    # a rod has K >= 1, and its point forces are divided by E I for K = 1
    least = float(EI.min())
    softer_by = layout.bending_stiffness / least
    loads = tuple(replace(load, force=softer_by * load.force) for load in rod.point_forces)
    built = replace(
        rod.with_stiffness(Profile.interpolate(rod.s, EI)), bending_stiffness=least, point_forces=loads
    )
    if rod.gravity is None:
        return built
    weight = rod.weight or Weight()
    if backing is not None or layout.section is not None:
        along = Profile.interpolate(rod.s, _cell_means(section.weight_per_length(parameter), n))
        return replace(built, weight=replace(weight, alpha=along, beta=0.0))
    if rod.weight is None:
        return built
    return replace(built, weight=weight.scaled(beta=least / layout.bending_stiffness))


def _cell_stations(rod: Rod) -> FloatArray:
    # return the stations (CUTS (n - 1),), mm: the middles of `CUTS` equal parts of each edge of the rod
    return midpoints(np.linspace(0.0, rod.length, CUTS * (rod.s.size - 1) + 1))


def _cell_means(values: FloatArray, nodes: int) -> FloatArray:
    """Return the mean around each node of values at `_cell_stations`; at the ends, over half a cell."""
    halves = values.reshape(2 * (nodes - 1), CUTS // 2).mean(axis=1)
    return np.concatenate([halves[:1], (halves[1:-1:2] + halves[2::2]) / 2, halves[-1:]])


STEP, TAB, TAB_REACH = 1.08, 0.86, 0.05
"""Constants of the unstressed corners beside a step of the width (`STEP`) or a tab (`TAB`, `TAB_REACH`).

The corners act like an added length of the strip: `STEP` or `TAB` times `crack_energy` times `idle_length`.
Beside a tab, `crack_energy` is that of the Poisson ratio 0, because a tab prevents curling across the strip.

The length is added at a distance from the tab of `TAB_REACH` times the difference in width between strip and
tab. In a sheet with grain, the distance is multiplied by sqrt(E / G) divided by its isotropic value.
Fitted to finite elements (`tests/campaign/finite_elements/idle_corners.py`)."""

RESTRAINT, WIDE_TAB = 0.35, 0.4
"""`RESTRAINT` is the length along which a clamp prevents curling across the strip, as a multiple of the
strip's width. `WIDE_TAB` is the least width of a tab that acts as a clamp, as a fraction of the strip's
width. For narrower tabs the length is proportional to the square of the tab's width.

Fitted to finite elements (`tests/campaign/finite_elements/idle_corners.py`)."""

FREE_EDGE = 0.63
"""Reduction of the effective width in torsion, because both edges are free, in thicknesses (Saint-Venant)."""


def _cut_factors(added_lengths: Sequence[tuple[float, float]], rod: Rod) -> FloatArray:
    """Return the factor (n,) by which cuts reduce the stiffness at each node.

    A cut is given as (position, added length), mm.
    """
    at, lengths = np.array(added_lengths).T
    # each added length is divided between the nodes before and after it
    node = (at / rod.length).clip(0.0, 1.0) * (rod.s.size - 1)
    before = np.minimum(node.astype(int), rod.s.size - 2)
    after = node - before
    added = np.bincount(before, lengths * (1 - after), rod.s.size)
    added += np.bincount(before + 1, lengths * after, rod.s.size)
    return 1 / (1 + added / rod.discrete.node_lengths)


def stiffness_factors(
    rod: Rod, layout: Layout, slots: Sequence[Slot], tab_widths: tuple[float | None, float | None]
) -> dict[str, FloatArray]:
    """Return factors (n,) on the stiffness at the nodes of the designed shape, by cause.

    - "slots": cuts and the unstressed corners beside them.
    - "narrow tabs": unstressed corners at ends that are wider than their tabs.
    - "steps of width": unstressed corners on the wider side of a jump of the width, for solid strips.
    - "leaning ligaments": the stiffness of a ligament at the angle theta to the strip is multiplied by
      cos(theta), because its mirror image prevents twisting. This factor is for a Poisson ratio near 0.3. At 25
      degrees, real ligaments are up to 7 % stiffer than this for the Poisson ratio 0, and up to 4 % for 0.1.
    - "anticlastic bending": a strip or ligament is stiffer if it cannot curl across its width.
    - "borders that curl": change of the stiffness of a laminate, because its borders curl.

    Each slot, narrow tab and step of the width lets the strip bend further at its position. Causes without
    effect are left out.

    Parameters
    ----------
    rod : Rod
        Designed shape.
    layout : Layout
    slots : sequence of Slot
    tab_widths : pair of float or None
        Widths of the tabs, mm; None for a tab as wide as the strip's end.
    """
    width, nu = layout.width, min(layout.sheet.poisson_ratio, 0.5)
    grain = float(np.sqrt(even_shear_ratio(nu) / layout.sheet.shear_ratio))
    curl = _curl(rod, layout)
    free = np.zeros(2)  # fraction of the anticlastic stiffening that is lost near each end
    if curl is not None and layout.backing is None and layout.pattern is None:
        free = 1 / curl.designed[[0, -1]] - 1 + nu**2
    added_lengths = {
        "slots": [*_lengths_added_by_slots(slots, width, CUT * crack_energy(nu) * grain**CUT_GRAIN)],
        "narrow tabs": [*_lengths_added_by_tabs(layout, tab_widths, grain, RESTRAINT * free)],
        "steps of width": [*_lengths_added_by_steps(layout, STEP * crack_energy(nu, grain))],
    }
    factors = {cause: _cut_factors(places, rod) for cause, places in added_lengths.items() if places}
    if isinstance(layout.pattern, DiamondPattern):
        # mean compliance near each node, because deflections are proportional to it
        compliance = np.hypot(1.0, layout.pattern.slopes(_cell_stations(rod)))
        factors["leaning ligaments"] = 1 / _cell_means(compliance, rod.s.size)
    if curl is not None and layout.section is None:
        factors[ANTICLASTIC if layout.backing is None else "borders that curl"] = curl.designed
    return factors


@dataclass(frozen=True, eq=False)
class Curl:
    """Dependence of the stiffness of a strip's nodes on their curvature.

    Attributes
    ----------
    designed : (n,) array
        Factors on the stiffness at the nodes in the designed shape.
    factor : BendFactor
        Function from curvatures to factors on the stiffness.
    """

    designed: FloatArray
    factor: BendFactor

    def on(self, rod: Rod) -> Rod:
        """Return `rod` with a stiffness that depends on the curvature.

        It is unchanged at the curvatures at which the factor is `designed`.
        """
        below = rod.law.below if isinstance(rod.law, CurlingLaw) else rod.law
        return replace(rod, law=CurlingLaw(self.factor, self.designed, rod.natural_curvature, below))


def _curl_factor(rod: Rod, layout: Layout) -> BendFactor | None:
    """Return the effect of curling on the stiffness as a function, or None without effect.

    Plates over joints are ignored.
    """
    s, rest = rod.s, rod.natural_curvature
    if layout.backing is not None:
        section = LaminatedSection(layout.sheet, layout.backing.sheet)
        return LaminateCurl.of(rod.curvature, layout.width(s), layout.backing.width(s), section, rest)
    if layout.section is not None and not layout.section.follows_bend:
        return None
    return PlainSection(layout.sheet, natural_curvature=rest).curl(_curling_width(layout, s))


def _curl(rod: Rod, layout: Layout) -> Curl | None:
    # return the effect of curling on the nodes of the designed rod, or None without effect
    factor = _curl_factor(rod, layout)
    return None if factor is None else Curl(factor(rod.curvature), factor)


def curling_by_design(rod: Rod, design: Rod, layout: Layout) -> Rod:
    """Return the rod with the curvature-dependent stiffness of its design.

    If the stiffness of the design is constant, return the rod unchanged.
    """
    curl = _curl(design, layout) if design.follows_bend else None
    return rod if curl is None else curl.on(rod)


def rod_to_bend(rod: Rod, layout: Layout, *, corrected: bool) -> Rod:
    """Return the designed rod with a stiffness that depends on its curvature.

    If the widths are `corrected` for curling, the rod keeps its stiffness in the designed shape. If not, the rod
    is not in equilibrium until its rest shape is computed. The stiffness stays constant for a single sheet
    whose Poisson ratio is only an estimate. A rod with another law, or with a section that itself follows the
    bend, is returned unchanged.
    """
    curling_sheet = layout.section is None and layout.sheet.poisson_known
    if rod.follows_bend or isinstance(rod.law, CurlingLaw) or not (curling_sheet or layout.backing):
        return rod
    factor = _curl_factor(rod, layout)
    if factor is None:
        return rod
    designed = factor(rod.curvature) if corrected else np.ones(rod.s.size)
    return Curl(designed, factor).on(rod)


def _with_factors(built: Rod, factors: Sequence[FloatArray]) -> Rod:
    """Return the rod with its stiffness times all factors (n,), and with unchanged weight."""
    B, K = built.bending_stiffness or 1.0, built.stiffness
    changed = K * np.prod([np.ones(K.size), *factors], axis=0)
    changed_rod = built.with_stiffness(Profile.interpolate(built.s, changed))
    if built.bending_stiffness is not None:
        changed_rod = replace(changed_rod, bending_stiffness=B * float(changed.min()))
    if built.gravity is None:
        return changed_rod
    # without a `Weight`, the weight is proportional to the stiffness: B / l^3 for the elasto-gravity length l
    weight = built.weight or Weight(beta=B / built.gravity.length**3)
    alpha, beta = weight.along(built.s)
    newtons = Profile.interpolate(built.s, alpha + beta * K)
    return replace(changed_rod, weight=replace(weight, alpha=newtons, beta=0.0))


def _lengths_added_by_slots(
    slots: Sequence[Slot], width: Profile, corner: float
) -> Iterator[tuple[float, float]]:
    """Yield the position and the added length, mm, of each slot, for unstressed corners and the narrower width.

    `corner` is the factor of the corners, in depth^2 / width.
    """
    for slot in slots:
        points, widths = slot.center_line(width)
        at, depth = float(points[:, 0].mean()), abs(float(points[-1, 1] - points[0, 1]))
        wide = float(width(min(max(at, 0.0), width.length)))
        # a width is assumed beside every slot, to avoid a division by zero
        remaining = max(wide - depth, 0.01 * wide)
        yield at, corner * depth**2 / wide + float(widths.mean()) * (wide - remaining) / remaining


def idle_length(width: float, narrow: float, thickness: float) -> float:
    """Return the added length, mm, of a step from `width` to `narrow` mm, divided by `crack_energy`.

    Unstressed corners beside the step let the strip bend further, as if it were longer by the added length.

    Many such strips side by side are like a wide sheet with a row of collinear cracks. For crack length 2a
    and spacing w, the stress intensity is proportional to sqrt(tan(pi a / w)), in bending as in tension
    (Westergaard, J. Appl. Mech. 6, 1939). For short cracks the result tends to depth^2 / width. The narrow
    part is less stiff in torsion near its free edges, so its width is reduced by `FREE_EDGE`.
    """
    net = narrow**2 / (narrow + FREE_EDGE * thickness)
    return float(-2 / np.pi**2 * width * np.log(np.sin(np.pi / 2 * net / width)))


def _lengths_added_by_tabs(
    layout: Layout, tab_widths: tuple[float | None, float | None], grain: float, restraint: FloatArray
) -> Iterator[tuple[float, float]]:
    """Yield (position, added length), mm, for each end that is wider than its tab.

    A tab prevents curling near it. This reduces the added length by `restraint` (2,) times the width.
    """
    length = layout.width.length
    for end, inwards, tab, stiffer in zip((0.0, length), (1, -1), tab_widths, restraint, strict=True):
        wide = float(layout.width(end))
        if tab and tab < wide:
            added = TAB * crack_energy(0.0, grain) * idle_length(wide, tab, layout.sheet.thickness)
            added -= stiffer * wide * min(1.0, tab / WIDE_TAB / wide) ** 2
            if added > 0:
                yield end + inwards * TAB_REACH * grain * (wide - tab), added


def _lengths_added_by_steps(layout: Layout, corner: float) -> Iterator[tuple[float, float]]:
    """Yield (position, added length), mm, for each step of the width. `corner` is `STEP` times `crack_energy`.

    Steps in a strip with holes, a backing or a varying thickness are neglected.
    """
    if layout.pattern is not None or layout.backing is not None or layout.size is not None:
        return
    for start, end in layout.width.steps:
        before, after = layout.width([start, end]).tolist()
        narrow, wide = sorted((before, after))
        # the middle of the unstressed corners of the wide part, which are about as long as they are wide
        at = start - (wide - narrow) / 4 if before > after else end + (wide - narrow) / 4
        yield at, corner * idle_length(wide, narrow, layout.sheet.thickness)


def _curling_width(layout: Layout, s: FloatArray) -> FloatArray:
    # return the width (n,), mm, of the strip or of each ligament, which curls by itself
    pieces = layout.pattern.ligaments if isinstance(layout.pattern, DiamondPattern) else 1
    return layout.material(s) / pieces


HELD_NODES = 241
"""Number of nodes of the rod for the shape in the holders. The error is a few millionths of the length."""


@dataclass(frozen=True, eq=False)
class StripAsMade:
    """Model of the finished strip, for its shape in the holders.

    Attributes
    ----------
    design : Rod
        Design, with at most `HELD_NODES` nodes.
    layout : Layout
        Flat pattern of the design.
    tab_stiffness : pair of float
        E I of the tabs at start and end, N mm2.
    cut : Rod
        Rod with the stiffness and weight of the cut strip, without slots.
    factors : mapping of str to (n,) array
        Factors on the stiffness of `cut` at the nodes in the designed shape, by cause: see
        `stiffness_factors`. The cause "plates" means plates over the joints of pieces.
    approximated : bool
        True if the drawing only approximates the stiffness, as holes and backings do.
    lap : pair of (n,) arrays, optional
        Stiffness factors and rest curvature of the joint of a closed strip: see `lap_joint`.
    curl : Curl, optional
        Dependence of the nodes' stiffness on their curvature.
    crowded : tuple of float
        Positions, mm, of two slots whose distance is less than the larger slot depth; empty if there are none.
    """

    design: Rod
    layout: Layout
    tab_stiffness: tuple[float, float]
    cut: Rod
    factors: Mapping[str, FloatArray]
    approximated: bool
    lap: tuple[FloatArray, FloatArray] | None = None
    curl: Curl | None = None
    crowded: tuple[float, ...] = ()

    @classmethod
    def of(
        cls,
        rod: Rod,
        layout: Layout,
        ends: Ends,
        slots: Sequence[Slot],
        plates: LapPlates | None,
        whole: Callable[[], Sequence[Layer]],
    ) -> "StripAsMade":
        """Return the model of a strip with tabs and slots.

        `plates` join the pieces of a long strip. `whole` returns the layers without slots, and is called only if
        needed.
        """
        design = rod if rod.s.size <= HELD_NODES else resample(rod, HELD_NODES)
        widths = np.array([tab.width for tab in fix_tab_widths(layout.width, ends)])
        section, parameter = layout.section_of(widths, None if layout.backing is None else widths)
        if layout.size is not None:
            section, parameter = layout.section_at(np.array([0.0, rod.length]))
        factors = stiffness_factors(design, layout, slots, (ends[0].width, ends[1].width))
        if plates is not None:
            factors["plates"] = plates.stiffening(design.s, layout, whole())
        points = (slot.center_line(layout.width)[0] for slot in slots)
        lines = sorted((float(line[:, 0].mean()), float(np.ptp(line[:, 1]))) for line in points)
        return cls(
            design,
            layout,
            tuple(section.bending_stiffness(parameter).tolist()),
            rod_as_built(design, layout, whole()),
            factors,
            layout.pattern is not None or layout.backing is not None,
            lap_joint(design, layout.material(design.s), ends[1].length, float(widths[1]))
            if ends[1].length and closes(rod)
            else None,
            _curl(design, layout),
            # the first two slots that are closer together than they are deep
            next(((a, b) for (a, d), (b, e) in pairwise(lines) if b - a < max(d, e)), ()),
        )

    @cached_property
    def rod(self) -> Rod:
        """Rod with the stiffness of the finished strip, which can depend on the curvature.

        It is not in equilibrium until its rest shape is computed.
        """
        rod = _with_factors(self.cut, list(self.factors.values()))
        if self.lap is not None:
            share, rest = self.lap
            rod = replace(_with_factors(rod, [share]), natural_curvature=rest)
        return rod if self.curl is None else self.curl.on(rod)

    @property
    def as_plate(self) -> bool:
        """True if the designed widths compensate anticlastic bending."""
        return self.design.follows_bend

    def tab_ratios(self, rod: Rod) -> tuple[float, float]:
        """Return E I of the tabs at start and end, divided by the bending stiffness B of `rod`."""
        B = rod.bending_stiffness or self.layout.bending_stiffness
        return self.tab_stiffness[0] / B, self.tab_stiffness[1] / B

    def rest(self) -> Rod:
        """Return the rest shape with both ends held as designed.

        Raises
        ------
        NotConvergedError
            No rest shape was found.
        """
        return self._rest_in((None, None))[0]

    def _rest_in(self, seats: Seats) -> tuple[Rod, tuple[EndPose, EndPose]]:
        return rest_in_seats(self.rod, self.design, seats, self.tab_ratios(self.rod))

    @cached_property
    def loaded(self) -> Rod:
        """Rest shape with both ends held as designed, or the design if no rest shape was found.

        If the stiffness depends on the curvature, `stiffness` of this rod is that in the designed shape.
        """
        try:
            return self.rest()
        except NotConvergedError:
            return self.design

    def held(self, seats: Seats, uncorrected: "StripAsMade", tolerance: MakingTolerance) -> HeldShape:
        """Return the shape in the holders, and the deviation that each cause alone would produce.

        The deviations by cause are computed for `uncorrected`, the strip without compensation.
        """
        rod, poses = self._rest_in(seats)
        parts, corrected = uncorrected.parts(), uncorrected is not self
        made_up_for = tuple(
            cause
            for cause, mm in parts.items()
            if mm >= LEAST_REPORTED_MM and (corrected or (self.as_plate and cause == ANTICLASTIC))
        )
        if self.as_plate:
            parts.pop(ANTICLASTIC, None)
        uncertainty = open_deviation(
            rod.length,
            self.layout.sheet,
            parts,
            width=0.0 if self._cut_breadth is None else float(self._cut_breadth.max()),
            approximated=self.approximated,
            crowded=bool(self.crowded),
        )
        sheet = sheet_effects(self.loaded, self.design, self.layout.sheet, self._cut_breadth, tolerance)
        notes = [*self._notes(seats)]
        try:
            sheet |= self._loose_tabs(seats, rod, tolerance)
        except NotConvergedError:
            notes.append(
                note(
                    "The effects of wider slots and thinner tabs are not computed, and Accuracy leaves them out"
                )
            )
        # effects can cancel, so a single effect can be larger than the deviation of all effects
        together = deviation_from(self.design, self.loaded.position + self._leaf_ends)
        key = FieldName("compensate") if self.layout.stack is None else ""
        contributions = [
            Contribution(note("uncertainty of the model"), uncertainty),
            *(Contribution(note(cause), mm, f"tolerance.{SHEET_KEYS[cause]}") for cause, mm in sheet.items()),
            *([Contribution(note("effects that the widths do not compensate"), together)] if corrected else
              [Contribution(note(cause), min(mm, together), key) for cause, mm in parts.items()]),
        ]  # fmt: skip
        # holders by the turn of their tab; the holder of the tab that turns most is named
        turned = {abs(pose.turn): seat for seat, pose in zip(seats, poses, strict=True) if seat is not None}
        if turned:
            loosest = turned[max(turned)]
            parts[LOOSE_TABS] = deviation_from(self.loaded, rod.position)
            cause = note("tabs that turn in the {holder}", holder=loosest.name)
            contributions.append(Contribution(cause, parts[LOOSE_TABS], loosest.key))
        return HeldShape(
            as_bent(rod),
            deviation_from(self.design, rod.position + self._leaf_ends),
            parts,
            *poses,
            corrected=corrected,
            as_plate=self.as_plate and ANTICLASTIC in made_up_for,
            made_up_for=made_up_for,
            open=uncertainty,
            sheet=sheet,
            notes=tuple(notes),
            contributions=tuple(sorted(contributions, key=lambda part: -part.mm)),
        )

    def _loose_tabs(self, seats: Seats, rod: Rod, tolerance: MakingTolerance) -> dict[str, float]:
        """Return the deviation, mm, because tabs are thinner and slots are wider than designed.

        `rod` is the shape in the designed slots. Both errors turn the tabs, so they are computed together.
        """
        # added clearance, mm: a row for each seat, with columns for thinner tabs and for wider slots
        rooms = np.array([
            (0.0, 0.0) if seat is None else
            (tolerance.thickness_wave * seat.thickness, tolerance.kerf * seat.cut) for seat in seats
        ])  # fmt: skip
        if not rooms.any():
            return {}
        start, end = (
            None if seat is None else seat.loosened(float(room))
            for seat, room in zip(seats, rooms.sum(axis=1), strict=True)
        )
        loose, _ = self._rest_in((start, end))
        # the deviation is divided in proportion to the clearances
        far = deviation_from(rod, loose.position) * rooms.sum(axis=0) / rooms.sum()
        return dict(zip(("thinner tabs", "wider slots"), far.tolist(), strict=True))

    @property
    def _cut_breadth(self) -> FloatArray | None:
        """Width (n,), mm, of the strip or of each ligament; None for planed or turned strips."""
        return _curling_width(self.layout, self.design.s) if self.layout.size is None else None

    def _notes(self, seats: Seats) -> Iterator[str]:
        """Yield notes on effects that the model neglects for this strip."""
        sheet = self.layout.sheet
        if (
            sheet.grain != "none"
            and sheet.shear_modulus is None
            and self.factors.keys() & {"slots", "narrow tabs", "steps of width"}
        ):
            yield note(
                "The shear modulus of {sheet} is unknown, so the model assumes a sheet without grain. "
                "Beside slots, tabs and steps the strip is softer than computed",
                sheet=sheet.name,
            )
        # below 0.8 times the isotropic ratio G / E, a sheet counts as a sheet with grain
        if self.approximated and sheet.shear_ratio < 0.8 * even_shear_ratio(sheet.poisson_ratio):
            yield note(
                "The model of holes and layers assumes a sheet without grain. {sheet} shears more "
                "easily; that effect is not computed",
                sheet=sheet.name,
            )
        if self.crowded:
            first, second = map(Length, self.crowded)
            yield note(
                "The slots {first} and {second} from the start are closer together than they are deep. Their "
                "combined effect is not computed",
                first=first,
                second=second,
            )
        if any(seat is not None for seat in seats):
            yield note("Friction in the pockets is neglected")

    @cached_property
    def _leaf_ends(self) -> FloatArray:
        """Displacements (n, 2), mm, of the nodes due to the ends of shorter plies; zero without plies.

        The neutral axis is not at the centre of the full-length ply, so the force in the strip adds a moment.
        """
        design, stack = self.design, self.layout.stack
        if stack is None:
            return np.zeros((design.s.size, 2))
        # `aside` is the distance of the neutral axis from the full-length ply, `off` is this distance as a vector,
        # and `axis` is the sum of the jumps of the neutral axis along the strip
        aside = (stack.counts(design.s) - 1) * stack.sheet.thickness / 2
        normals = left_of(unit_vectors(design.angle))
        between = midpoints(normals)
        off = aside[:, None] * normals
        axis = off[0] + np.vstack([np.zeros(2), (np.diff(aside)[:, None] * between).cumsum(axis=0)])
        moments = cross(design.force, axis)[:, None]
        return np.asarray(axis + shape_responses(design, moments, apart=off[-1:] - axis[-1:])[:, 0] - off)

    def parts(self) -> dict[str, float]:
        """Return the deviation from the design, mm, that each cause alone produces, to first order.

        A cause changes the curvature at each node under the designed moment.
        Anticlastic bending is computed as if the widths did not compensate it.
        """
        design, loaded = self.design, self.loaded
        K, elastic = design.stiffness, design.moment / design.stiffness
        curl = {ANTICLASTIC: self.curl.designed} if self.as_plate and self.curl is not None else {}
        bends = {cause: elastic * (1 / factor - 1) for cause, factor in {**self.factors, **curl}.items()}
        if self.approximated:
            # stiffness as cut, divided by the design
            share = (
                self.cut.stiffness * (self.cut.bending_stiffness or 1.0) / (K * self.layout.bending_stiffness)
            )
            bends["fit of the drawing"] = elastic * (1 / share - 1)
        if self.lap is not None:
            share, rest = self.lap
            bends["lap joint"] = rest - design.natural_curvature + elastic * (1 / share - 1)
        jumps = (
            {LEAF_ENDS: deviation_from(design, design.position + self._leaf_ends)}
            if self._leaf_ends.any()
            else {}
        )
        if not bends:
            return jumps
        # at fixed edge angles, a further bend of the loose strip reduces its moment by the stiffness times the bend
        moved = shape_responses(loaded, -loaded.stiffness[:, None] * np.column_stack([*bends.values()]))
        return jumps | {
            cause: deviation_from(design, design.position + moved[:, k]) for k, cause in enumerate(bends)
        }
