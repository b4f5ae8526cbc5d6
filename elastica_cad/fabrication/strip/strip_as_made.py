"""A strip as it is made: all that changes its stiffness, and the shape that it takes in its holders."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.held_shape import HeldShape, Seats, shape_responses, strayed
from elastica_cad.fabrication.holding.lap_joint import LapJoint, closes
from elastica_cad.fabrication.holding.rest_in_seats import rest_in_seats
from elastica_cad.fabrication.holding.tab_seat import EndPose
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.as_built import rod_as_built
from elastica_cad.fabrication.strip.flat_outline import Ends, fix_tab_widths
from elastica_cad.fabrication.strip.made_stiffness import (
    PLATES,
    Curl,
    LapPlates,
    curl_of,
    stiffness_shares,
    with_shares,
)
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.mechanics.rod.as_bent import as_bent
from elastica_cad.mechanics.rod.resampling import resample
from elastica_cad.mechanics.rod.rod_record import Rod

HELD_NODES = 241
"""Of the rod that is bent in its holders: its own error is some millionths of the length."""


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
    ) -> "StripAsMade":
        """What a rod becomes when its layout is cut with tabs and slots, and joined of pieces by plates.

        `whole` gives its layers without slots, where they are needed.
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
            rod_as_built(design, layout, [layer.material for layer in whole()]),
            shares,
            layout.pattern is not None or layout.backing is not None,
            LapJoint.of(design, layout.material(design.s), ends[1].length, float(widths[1]))
            if ends[1].length and closes(rod)
            else None,
            curl_of(design, layout),
        )

    @cached_property
    def rod(self) -> Rod:
        """The rod with all causes together, whose stiffness follows its bend: out of balance until bent."""
        made = with_shares(self.cut, list(self.shares.values()))
        made = made if self.lap is None else _lapped(made, self.lap)
        return made if self.curl is None else self.curl.on(made)

    @property
    def as_plate(self) -> bool:
        """Are its widths made by how the strip curls across?"""
        return self.design.follows_bend

    def tab_ratios(self, rod: Rod) -> tuple[float, float]:
        """E I of the tabs at start and end over the B of a rod made of the design."""
        B = rod.bending_stiffness or self.bending_stiffness
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
        return HeldShape(
            as_bent(rod),
            strayed(self.design, rod.position),
            asked.parts(seats, poses),
            *poses,
            corrected=asked is not self,
            as_plate=self.as_plate,
        )

    def parts(self, seats: Seats, poses: tuple[EndPose, EndPose]) -> dict[str, float]:
        """How far, mm, each cause alone takes the strip from its design, to first order about the strip as made.

        A cause bends each node by more or less under the designed moment, or moves and turns an end.
        """
        design, made = self.design, self.loaded
        K, elastic, n = design.stiffness, design.moment / design.stiffness, design.s.size
        bends = {cause: elastic * (1 / share - 1) for cause, share in self.shares.items()}
        if self.approximated:
            share = self.cut.stiffness * (self.cut.bending_stiffness or 1.0) / (K * self.bending_stiffness)
            bends["fit of the drawing"] = elastic * (1 / share - 1)
        if self.lap is not None:
            bends["lap joint"] = self.lap.rest - design.natural_curvature + elastic * (1 / self.lap.share - 1)
        shifts = {cause: np.zeros((2, 2)) for cause in bends}  # of the start and the end
        cells = design.discrete.node_lengths
        for k, (seat, pose) in enumerate(zip(seats, poses, strict=True)):
            if seat is not None:
                cause, angle = f"{('start', 'end')[k]}: {seat.name}", float(design.angle[-k])
                bends[cause], shifts[cause] = np.zeros(n), np.zeros((2, 2))
                bends[cause][-k] = (-pose.turn if k else pose.turn) / cells[-k]
                shifts[cause][k] = pose.shift * np.array([-np.sin(angle), np.cos(angle)])
        if not bends:
            return {}
        moments = -made.stiffness[:, None] * np.column_stack([*bends.values()])
        ends = np.array([*shifts.values()])
        moved = ends[None, :, 0] + shape_responses(made, moments, apart=ends[:, 1] - ends[:, 0])
        return {cause: strayed(design, design.position + moved[:, k]) for k, cause in enumerate(bends)}


def _lapped(made: Rod, lap: LapJoint) -> Rod:
    """The rod with its joint: stiffer there, and glued in a shape that it keeps in part."""
    return replace(with_shares(made, [lap.share]), natural_curvature=lap.rest)
