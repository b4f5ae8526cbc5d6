"""The shape that a strip takes as it is made and held, and what each cause adds to its deviation."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holding.lap_joint import closes
from elastica_cad.fabrication.holding.tab_seat import EndPose, TabSeat
from elastica_cad.mechanics.rod.banded_matrices import solve_tridiagonal
from elastica_cad.mechanics.rod.rod_record import Rod

Seats = tuple[TabSeat | None, TabSeat | None]

ANTICLASTIC = "anticlastic bending"
"""A wide strip curls across as it bends, and is stiffer for it."""

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
        What each cause alone adds to first order, mm: "slots", "narrow tabs", "leaning ligaments", "anticlastic
        bending", "start: pocket" and so on.
    start, end : EndPose
        Where the ends come to rest.
    corrected : bool
        Do the widths make up for the causes? `parts` are then those of the strip without the correction.
    as_plate : bool
        Are the widths made by how the strip curls across? Anticlastic bending is then no cause.
    """

    rod: Rod
    deviation: float
    parts: Mapping[str, float]
    start: EndPose
    end: EndPose
    corrected: bool = False
    as_plate: bool = False

    @property
    def made_up_for(self) -> tuple[str, ...]:
        """The causes that widths make up for."""
        return (*(self.parts if self.corrected else ()), *((ANTICLASTIC,) if self.as_plate else ()))

    def __str__(self) -> str:
        """One sentence."""
        told = [
            f"{mm:.2g} mm by {cause}"
            for cause, mm in sorted(self.parts.items(), key=lambda part: -part[1])
            if mm >= LEAST_TOLD_MM
        ]
        before = ", without its correction" if self.corrected else ""
        of = f"; each cause alone{before}: {'; '.join(told)}" if told else ""
        curl = ", its widths made for anticlastic bending," if self.as_plate else ""
        share = 100 * self.deviation / self.rod.length
        return (
            f"as made and held{curl} the strip strays {self.deviation:.2g} mm from its design, {share:.2g} % of "
            f"its length{of}"
        )


def strayed(design: Rod, place: FloatArray) -> float:
    """Largest distance, mm, of the nodes of a shape (n, 2) from those of the design.

    A closed strip, which nothing holds in its place, is laid over its design as well as it fits.
    """
    if closes(design):
        middle, wanted = place.mean(axis=0), design.position.mean(axis=0)
        (x, y), (u, v) = (place - middle).T, (design.position - wanted).T
        turn = np.arctan2(np.sum(x * v - y * u), np.sum(x * u + y * v))
        cos, sin = np.cos(turn), np.sin(turn)
        place = wanted + (place - middle) @ np.array([[cos, sin], [-sin, cos]])
    return float(np.hypot(*(place - design.position).T).max())


def shape_responses(
    rod: Rod, moments: FloatArray, loads: FloatArray | None = None, apart: FloatArray | None = None
) -> FloatArray:
    """How the nodes of a rod in balance move (n, m, 2), mm, to first order, with its start held in its place.

    The shape answers changes of moment and weight at the same shape by H d(alpha) + C^t d(lambda) = -d(imbalance),
    C d(alpha) = d(chord), with the Hessian H of the discrete energy (paper, section 7.1) and the ends' rows C.

    Parameters
    ----------
    rod : Rod
    moments : (n, m) array
        By how much the moments at the nodes grow, where the shape stays.
    loads : (n, m, 2) array, optional
        The same of the nodal weight.
    apart : (m, 2) array, optional
        How the end is moved against the start, mm.
    """
    discrete, (n, m) = rod.discrete, moments.shape
    lengths, tangents = discrete.edge_lengths[:, None], discrete.tangents
    imbalance = moments[:-1] - moments[1:]
    if loads is not None:
        pull = np.zeros((n - 1, m, 2))
        pull[1:] = np.cumsum(loads[1:-1], axis=0)
        shear = pull[..., 1] * tangents[:, None, 0] - pull[..., 0] * tangents[:, None, 1]
        imbalance = imbalance + lengths * shear
    rows = discrete.constraint_rows
    answers = solve_tridiagonal(*discrete.hessian, np.hstack([-imbalance, rows.T]))
    turned, forced = answers[:, :m], answers[:, m:]
    chord = 0.0 if apart is None else apart.T[list(discrete.held)]
    # of a straight rod no turn of its parts moves the ends along it
    turned = turned + forced @ np.linalg.lstsq(rows @ forced, chord - rows @ turned, rcond=None)[0]
    normals = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    moved = np.zeros((n, m, 2))
    moved[1:] = np.cumsum(lengths[..., None] * turned[..., None] * normals[:, None, :], axis=0)
    return moved
