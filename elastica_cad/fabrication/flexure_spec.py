"""The request for a part with two rest shapes, whoever asks: two curves, a sheet, and what it may be."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal, get_args

from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.flexure import Flexure, Pad
from elastica_cad.forming.matched_pair import MatchedPair, matched_pair
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.two_states.two_state_rod import (
    Objective,
    PairLimits,
    State,
    TwoStateRod,
    two_state_rod,
)

Match = Literal["ends", "shape", "none"]


@dataclass(frozen=True, eq=False)
class FlexureSpec:
    """A flexure as it is asked for.

    Attributes
    ----------
    first, second : PlaneCurve
        Both states as drawn, mm.
    sheet : Sheet or str
    match : "ends", "shape" or "none"
        How their lengths are made equal: see `matched_pair`.
    limits : PairLimits
    free : "first", "second" or None
        A state that needs no holding.
    objective : "thickness" or "ratio"
        The largest least thickness at the sheet's strain, or the least ratio of stiffness.
    least_thickness, pad, fillet, push_at, printed, label, ignore_limits
        As of `Flexure`.

    Examples
    --------
    >>> import numpy as np
    >>> arch = PlaneCurve.spline([(0, 0), (30, 10), (90, 10), (120, 0)], degree=3)
    >>> spec = FlexureSpec(arch, arch.transformed(np.diag([1.0, -1.0, 1.0])), "pom-2")
    >>> spec.make().pair.bistable
    False
    """

    first: PlaneCurve
    second: PlaneCurve
    sheet: Sheet | str
    match: Match = "ends"
    limits: PairLimits = field(default_factory=PairLimits)
    free: State | None = None
    objective: Objective = "thickness"
    least_thickness: float | None = None
    pad: Pad = field(default_factory=Pad)
    fillet: float = 1.0
    push_at: float | None = None
    printed: bool = False
    label: str = ""
    ignore_limits: bool = False

    def __post_init__(self) -> None:
        require_record(self.limits, PairLimits, "limits", "a PairLimits record")
        if self.match not in get_args(Match):
            raise InputError(
                "match is {match!r}: give one of {known}", match=self.match, known=", ".join(get_args(Match))
            )

    @cached_property
    def matched(self) -> MatchedPair | None:
        """Both curves made equally long; None where they are taken as drawn."""
        return None if self.match == "none" else matched_pair(self.first, self.second, self.match)

    @cached_property
    def pair(self) -> TwoStateRod:
        """The rod that rests in both."""
        first, second = self.matched or (self.first, self.second)
        return two_state_rod(first, second, limits=self.limits, free=self.free, objective=self.objective)

    def make(self) -> Flexure:
        """The part.

        Raises
        ------
        NotRealizable
            No strip rests in both curves within the limits.
        InputError
            It cannot be cut, or touches itself; the sentence says what would help.
        """
        return Flexure(
            self.pair, Sheet.of(self.sheet), least_thickness=self.least_thickness, pad=self.pad, fillet=self.fillet,
            push_at=self.push_at, printed=self.printed, label=self.label, ignore_limits=self.ignore_limits,
        )  # fmt: skip
