"""A strip as it is made: all that changes its stiffness, and the shape that it takes in its holders."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.held_shape import ANTICLASTIC, HeldShape, Seats, strayed
from elastica_cad.fabrication.holding.lap_joint import LapJoint, closes
from elastica_cad.fabrication.holding.rest_in_seats import rest_in_seats
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.as_built import cell_stations, material_width, rod_as_built
from elastica_cad.fabrication.strip.diamond_pattern import DiamondPattern
from elastica_cad.fabrication.strip.flat_outline import Ends, end_holes, fix_tab_widths, flat_rim
from elastica_cad.fabrication.strip.made_stiffness import (
    BORDERS,
    PLATES,
    Curl,
    LapPlates,
    curl_of,
    stiffness_shares,
    with_shares,
)
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.mechanics.rod.rod_record import Rod, as_bent, resample

HELD_NODES = 241
"""Of the rod that is bent in its holders: its own error is some millionths of the length."""

FEW_HOLES = 300
"""Rounded holes that are drawn and measured in no longer than a strip is bent."""


@dataclass(frozen=True, eq=False)
class StripAsMade:
    """What is bent when a strip is held.

    Attributes
    ----------
    design : Rod
        In the shape that is wanted, on nodes enough to be bent.
    bending_stiffness : float
        B of the design, N mm2.
    tab_stiffness : pair of float
        E I of the tabs at start and end, N mm2.
    cut : Rod
        With the stiffness and weight of what is cut, slots apart.
    shares : mapping of str to (n,) array
        Factors on that stiffness at the nodes by cause, bent as designed: see `stiffness_shares`; "plates" over
        joints of pieces.
    approximated : bool
        Does the drawing only come near to the stiffness, as holes and backings do?
    lap : LapJoint, optional
        The joint of a closed strip.
    curl : Curl, optional
        How the stiffness of the nodes follows their curvature.
    """

    design: Rod
    bending_stiffness: float
    tab_stiffness: tuple[float, float]
    cut: Rod
    shares: Mapping[str, FloatArray]
    approximated: bool
    lap: LapJoint | None = None
    curl: Curl | None = None

    @classmethod
    def of(
        cls,
        rod: Rod,
        layout: Layout,
        ends: Ends,
        slots: Sequence[Slot],
        plates: LapPlates | None,
        whole: Callable[[], Sequence[Layer]],
        beyond: FloatArray | None = None,
    ) -> "StripAsMade":
        """What a rod becomes when its layout is cut with tabs and slots, and joined of pieces by plates.

        `whole` gives its layers without slots, where they are needed; with `beyond` holes need not be drawn: see
        `left_beyond`.
        """
        design = rod if rod.s.size <= HELD_NODES else resample(rod, HELD_NODES)
        widths = np.array([tab.width for tab in fix_tab_widths(layout.width, ends)])
        first, last = layout.stiffness(widths, None if layout.backing is None else widths).tolist()
        if layout.section is not None and layout.size is not None:
            first, last = layout.section.bending_stiffness(layout.size([0.0, rod.length])).tolist()
        shares = stiffness_shares(design, layout, slots, (ends[0].width, ends[1].width))
        if plates is not None:
            shares[PLATES] = plates.stiffening(design.s, layout, whole())
        return cls(
            design,
            layout.bending_stiffness,
            (first, last),
            rod_as_built(design, layout, _widths_left(layout, ends, whole, beyond)),
            shares,
            layout.pattern is not None or layout.backing is not None,
            LapJoint.of(design, layout.material(design.s), ends[1].length, float(widths[1]))
            if ends[1].length and closes(rod)
            else None,
            curl_of(design, layout, 0.0 if plates is None else plates.covered(design.s, layout.sheet)),
        )

    @cached_property
    def rod(self) -> Rod:
        """The rod with all causes together, whose stiffness follows its bend: out of balance until bent."""
        made = with_shares(self.cut, list(self.shares.values()))
        return self._curling(made if self.lap is None else _lapped(made, self.lap), plated=True)

    @property
    def as_plate(self) -> bool:
        """Are its widths made by how the strip curls across?"""
        return self.design.follows_bend

    def alone(self, cause: str) -> Rod:
        """The rod with one of the causes in `shares` alone: out of balance until bent."""
        made, plated = with_shares(self.cut, [self.shares[cause]]), cause == PLATES
        follows = self.as_plate or cause in (ANTICLASTIC, BORDERS)
        return self._curling(made, plated=plated) if follows else made

    def tab_ratios(self, rod: Rod | None = None) -> tuple[float, float]:
        """E I of the tabs at start and end over the B of a rod made of the design, or of the design itself."""
        B = self.bending_stiffness if rod is None else rod.bending_stiffness or self.bending_stiffness
        return self.tab_stiffness[0] / B, self.tab_stiffness[1] / B

    def rest(self, seats: Seats = (None, None)) -> Rod:
        """The shape that the strip takes, with a law of its nodes where their stiffness follows the bend.

        Raises
        ------
        NotConvergedError
            No rest shape was found.
        """
        return rest_in_seats(self.rod, self.design, seats, self.tab_ratios(self.rod))[0]

    @cached_property
    def loaded(self) -> Rod:
        """Its shape with both ends held as designed, with what it does to its holders; the design where none.

        As `rest` has it: stiffness and law are those of the strip before it is bent.
        """
        try:
            return self.rest()
        except NotConvergedError:
            return self.design

    def held(self, seats: Seats, asked: "StripAsMade") -> HeldShape:
        """The same with what each cause does alone to the strip as it was asked for, before any correction."""
        rod, poses = rest_in_seats(self.rod, self.design, seats, self.tab_ratios(self.rod))
        parts = asked.deviations_alone(seats)
        return HeldShape(
            as_bent(rod),
            strayed(self.design, rod),
            parts,
            *poses,
            corrected=asked is not self,
            as_plate=self.as_plate,
        )

    def deviations_alone(self, seats: Seats) -> dict[str, float]:
        """How far, mm, each cause alone takes the strip from its design."""
        alone = {cause: self.alone(cause) for cause in self.shares}
        if self.approximated:
            alone["fit of the drawing"] = self.cut
        if self.lap is not None:
            alone["lap joint"] = self._by_design(_lapped(self.cut, self.lap))
        shapes = {cause: rest_in_seats(made, self.design, (None, None))[0] for cause, made in alone.items()}
        one_seat: tuple[Seats, Seats] = (seats[0], None), (None, seats[1])
        for end, seat, one in zip(("start", "end"), seats, one_seat, strict=True):
            if seat is not None:
                bent, _ = rest_in_seats(self._by_design(self.design), self.design, one, self.tab_ratios())
                shapes[f"{end}: {seat.name}"] = bent
        return {cause: strayed(self.design, shape) for cause, shape in shapes.items()}

    def _curling(self, made: Rod, *, plated: bool = False) -> Rod:
        return made if self.curl is None else self.curl.on(made, plated=plated)

    def _by_design(self, made: Rod) -> Rod:
        """Does the design itself count on its curl?"""
        return self._curling(made) if self.as_plate else made


def left_beyond(
    design: Rod, layout: Layout, ends: Ends, whole: Callable[[], Sequence[Layer]]
) -> FloatArray | None:
    """What rounded and arc-sided holes leave (n,), mm, at `cell_stations` beyond what is reckoned without loops.

    None where there are no such holes, or so few that they are drawn as fast.
    """
    pattern = layout.pattern
    if layout.backing is not None or not isinstance(pattern, DiamondPattern) or pattern.is_sharp:
        return None
    base, s = whole()[0], cell_stations(design)
    return base.material(s) - _left_by(pattern, layout, ends)(s) if len(base.holes) > FEW_HOLES else None


def _widths_left(
    layout: Layout, ends: Ends, whole: Callable[[], Sequence[Layer]], beyond: FloatArray | None
) -> list[Callable[[FloatArray], FloatArray]]:
    """Of each layer the width (n,), mm, left at stations (n,); sharp holes are reckoned without their loops."""
    pattern = layout.pattern
    if layout.backing is None and isinstance(pattern, DiamondPattern):
        left = _left_by(pattern, layout, ends)
        if pattern.is_sharp:
            return [left]
        if beyond is not None:
            return [lambda s: left(s) + beyond]
    return [layer.material for layer in whole()]


def _left_by(pattern: DiamondPattern, layout: Layout, ends: Ends) -> Callable[[FloatArray], FloatArray]:
    """The width left, reckoned without loops: right for sharp holes, about right at rounded tips."""
    rim, holes = flat_rim(layout.width, ends), end_holes(layout.width, ends)
    return lambda s: material_width(rim, holes, s) - pattern.width_cut(ends, s) + pattern.left_by_tips(s)


def _lapped(made: Rod, lap: LapJoint) -> Rod:
    """The rod with its joint: stiffer there, and glued in a shape that it keeps in part."""
    return replace(with_shares(made, [lap.share]), natural_curvature=lap.rest)
