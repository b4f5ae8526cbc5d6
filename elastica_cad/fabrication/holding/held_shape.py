"""How a strip is held: its reactions, and the shape that it takes as it is made."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holding.tab_seat import EndPose, TabSeat
from elastica_cad.geometry.curves.plane_curve import CORNER_RAD
from elastica_cad.mechanics.rod.banded_matrices import solve_tridiagonal
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.refusals import Length, note, sentences

MEETING_SHARE = 1e-4
"""Ends nearer to each other than this share of the length meet; rods with few nodes close to this accuracy."""


def closes(rod: Rod) -> bool:
    """Whether the ends of a rod meet with the same direction."""
    gap = float(np.hypot(*(rod.position[-1] - rod.position[0])))
    turn = float(np.angle(np.exp(1j * float(rod.angle[-1] - rod.angle[0]))))
    return gap <= MEETING_SHARE * rod.length and abs(turn) <= CORNER_RAD


@dataclass(frozen=True, eq=False)
class Reactions:
    """What the supports do to the strip: forces (2,) in N, moments in N mm (positive anticlockwise).

    Examples
    --------
    >>> print(Reactions(np.array([1.0, 0.0]), 20.0, np.array([-1.0, 0.0]), -20.0))
    the start is held by 1 N, (1, 0), and 20 N mm; the end by 1 N, (-1, 0), and -20 N mm
    """

    start_force: FloatArray
    start_moment: float
    end_force: FloatArray
    end_moment: float

    def __str__(self) -> str:
        start, end = (
            note(
                "{force:.3g} N, ({x:.3g}, {y:.3g}), and {moment:.3g} N mm",
                force=np.hypot(x, y), x=x, y=y, moment=moment,
            )
            for (x, y), moment in ((self.start_force, self.start_moment), (self.end_force, self.end_moment))
        )  # fmt: skip
        return note("the start is held by {start}; the end by {end}", start=start, end=end)


Seats = tuple[TabSeat | None, TabSeat | None]

ANTICLASTIC = "anticlastic bending"
"""Name of the cause that a wide strip curls across as it bends, and is stiffer."""

LEAF_ENDS = "ends of leaves"
"""Where a glued leaf ends, the neutral axis of the stack jumps by half its thickness."""

LEAST_TOLD_MM = 0.005
"""Deviations below this, mm, are not listed one by one."""


MOST = np.sqrt(0.5)
"""Of what a strip strays in all: more than this is most of it, as independent causes add by their squares."""


@dataclass(frozen=True, eq=False)
class HeldShape:
    """A strip in its holders.

    Attributes
    ----------
    rod : Rod
        The shape it takes, with all causes together.
    deviation : float
        Largest distance of any place of the strip from where it was designed to be, mm, as the model has it.
    parts : mapping of str to float
        What each cause alone adds to first order, mm: "slots", "narrow tabs", "leaning ligaments", "anticlastic
        bending", "start: pocket" and so on.
    start, end : EndPose
        Where the ends come to rest.
    corrected : bool
        Were the widths corrected? `parts` are then those of the strip without the correction.
    as_plate : bool
        Are the widths made for anticlastic bending, which would move the strip otherwise?
    made_up_for : tuple of str
        Causes that move the strip without the correction of its widths; holders are not corrected.
    open : float
        How far a strip of a perfect sheet may lie from where the model has it, mm: see `open_deviation`.
    sheet : mapping of str to float
        What the sheet, its cut and its clamps add, mm, by cause: see `sheet_effects`.
    notes : tuple of str
        What the model takes for granted of this strip.
    """

    rod: Rod
    deviation: float
    parts: Mapping[str, float]
    start: EndPose
    end: EndPose
    corrected: bool = False
    as_plate: bool = False
    made_up_for: tuple[str, ...] = ()
    open: float = 0.0
    sheet: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    @property
    def sheet_adds(self) -> float:
        """What sheet, cut and clamps add together, mm; they are independent of each other."""
        return float(np.linalg.norm([*self.sheet.values(), 0.0]))

    @property
    def expected(self) -> float:
        """How far a real strip strays, mm: as modelled, by what the model leaves open, and by its sheet."""
        return float(np.linalg.norm([self.deviation, self.open, self.sheet_adds]))

    def __str__(self) -> str:
        """One sentence, and one for each note."""
        figures = {
            "most of it as modelled": self.deviation,
            "most of it left open by the model": self.open,
            "most of it from the sheet": self.sheet_adds,
        }
        largest = max(figures, key=lambda words: figures[words])
        strays = note(
            "as made and held, its widths made for anticlastic bending, the strip strays about {far} from its "
            "design, {percent:g} % of its length" if self.as_plate else
            "as made and held the strip strays about {far} from its design, {percent:g} % of its length",
            far=about(self.expected), percent=_two_digits(100 * self.expected / self.rod.length),
        )  # fmt: skip
        if figures[largest] > MOST * self.expected:
            strays = note("{strays}, {most}", strays=strays, most=note(largest))
        said = note(
            "{strays}: the model says {modelled} and leaves {open} open, and sheet, cut and clamps add {sheet}",
            strays=strays, modelled=about(self.deviation), open=about(self.open),
            sheet=about(self.sheet_adds),
        )  # fmt: skip
        told = [
            note("{far:.2g} by {cause}", far=Length(mm), cause=note(cause))
            for cause, mm in sorted(self.parts.items(), key=lambda part: -part[1])
            if mm >= LEAST_TOLD_MM
        ]
        if told:
            each = (
                "{strays}; each cause alone, without its correction: {causes}"
                if self.corrected
                else "{strays}; each cause alone: {causes}"
            )
            said = note(each, strays=said, causes=sentences(told))
        return sentences((said, *self.notes), ". ")


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")


def about(mm: float) -> Length:
    """A length to two digits, and no finer than a micrometre."""
    return Length(_two_digits(round(mm, 3)))


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
