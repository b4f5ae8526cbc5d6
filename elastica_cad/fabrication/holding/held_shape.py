"""The shape that a strip takes as it is made and held, and what each cause adds to its deviation."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from elastica_cad.fabrication.holding.rest_in_seats import EndPose, rest_in_seats
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.mechanics.rod.rod_record import Rod

Seats = tuple[TabSeat | None, TabSeat | None]

LEAST_TOLD_MM = 0.005
"""Deviations below it are not told one by one."""


@dataclass(frozen=True, eq=False)
class HeldShape:
    """A strip in its holders.

    Attributes
    ----------
    rod : Rod
        The shape it takes, with all causes together.
    deviation : float
        Largest distance of any place of the strip from where it was designed to be, mm.
    parts : mapping of str to float
        The same for each cause alone, mm: "slots", "narrow tabs", "leaning ligaments", "anticlastic bending",
        "start: pocket" and so on.
    start, end : EndPose
        Where the ends come to rest.
    """

    rod: Rod
    deviation: float
    parts: Mapping[str, float]
    start: EndPose
    end: EndPose

    def __str__(self) -> str:
        """One sentence."""
        told = [
            f"{mm:.2g} mm by {cause}"
            for cause, mm in sorted(self.parts.items(), key=lambda part: -part[1])
            if mm >= LEAST_TOLD_MM
        ]
        of = f" ({', '.join(told)}, each alone)" if told else ""
        share = 100 * self.deviation / self.rod.length
        return (
            f"as made and held the strip strays {self.deviation:.2g} mm from its design, {share:.2g} % of its "
            f"length{of}"
        )


def hold(
    design: Rod,
    whole: Rod,
    alone: Mapping[str, Rod],
    seats: Seats = (None, None),
    *,
    tab_stiffness: tuple[float, float],
    bending_stiffness: float,
) -> HeldShape:
    """Bend a strip as it is made, in its holders.

    Parameters
    ----------
    design : Rod
        In the shape that is wanted.
    whole : Rod
        With the stiffness and weight of all causes together.
    alone : mapping of str to Rod
        With those of one cause each.
    seats : pair of TabSeat or None
        At start and end; None for an end that is held without play.
    tab_stiffness : pair of float
        E I of the tabs, N mm2.
    bending_stiffness : float
        B of the design, N mm2; `whole` knows its own.

    Raises
    ------
    NotConvergedError
        No rest shape was found.
    """
    parts = {
        cause: strayed(design, rest_in_seats(made, design, (None, None))[0]) for cause, made in alone.items()
    }
    for k, (end, seat) in enumerate(zip(("start", "end"), seats, strict=True)):
        if seat is not None:
            one: Seats = (seat, None) if k == 0 else (None, seat)
            rod, _ = rest_in_seats(design, design, one, _over(tab_stiffness, bending_stiffness))
            parts[f"{end}: {seat.name}"] = strayed(design, rod)
    own = _over(tab_stiffness, whole.bending_stiffness or bending_stiffness)
    rod, poses = rest_in_seats(whole, design, seats, own)
    return HeldShape(rod, strayed(design, rod), parts, *poses)


def _over(tab_stiffness: tuple[float, float], B: float) -> tuple[float, float]:
    return tab_stiffness[0] / B, tab_stiffness[1] / B


def strayed(design: Rod, found: Rod) -> float:
    """Largest distance, mm, of the nodes of a shape from those of the design."""
    return float(np.hypot(*(found.position - design.position).T).max())
