"""Reactions of a held strip, the shape it takes as made, and the expected error."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.declared import Asked, require_declared
from elastica_cad.geometry.plane_curve import CORNER_RAD
from elastica_cad.mechanics.discrete_rod import solve_tridiagonal
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Sheet, even_shear_ratio
from elastica_cad.mechanics.tolerances import feels_modulus
from elastica_cad.refusals import Length, note, sentences
from elastica_cad.strip.tab_seats import EndPose, TabSeat

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


PHASES = 8
"""Of a wave along the strip that are tried."""

OPEN_SHARES: Mapping[str, float] = {
    "slots": 0.24,
    "narrow tabs": 0.3,
    "steps of width": 0.3,
    "leaning ligaments": 0.7,
    ANTICLASTIC: 0.25,
    "borders that curl": 0.15,
    "plates": 0.1,
    "lap joint": 0.1,
    LEAF_ENDS: 0.1,
}
"""Of what each cause does to a strip: the largest error of the model (`docs/finite_elements.md`)."""

OPEN_PLAIN, OPEN_CURLED, OPEN_BUILT, OPEN_GRAINED = 1e-4, 2.5e-4, 3e-4, 2.2e-3
"""Of the length, whatever the causes: of any strip; of one whose sheet curls across, at nu = 0.3 and as nu^2; of
one that is perforated or laminated; and of such a one in a sheet with grain, whose holes and borders are computed
as those of a sheet without, in proportion to what sqrt(E / G) has more."""

OPEN_WIDE = 2e-3
"""Of the length, times (width / length)^2 and E / G over that of an even sheet: sections of a wide strip of varying
width do not stay straight across."""


def open_deviation(
    length: float,
    sheet: Sheet,
    parts: Mapping[str, float],
    *,
    width: float = 0.0,
    approximated: bool = False,
    crowded: bool = False,
) -> float:
    """How far, mm, a strip of a perfect sheet may lie from where the model has it.

    Errors of every strip, of its curl across and of its causes are independent of each other.

    Parameters
    ----------
    length : float
        mm.
    sheet : Sheet
    parts : mapping of str to float
        What each cause does to the strip before widths make up for it, mm.
    width : float
        Of the widest place of a part that is cut, mm.
    approximated : bool
        Does the drawing only come near to the stiffness, as holes and backings do?
    crowded : bool
        Do slots lie so near to each other that what they do together is not known?
    """
    nu = sheet.poisson_ratio
    shear = even_shear_ratio(nu) / sheet.shear_ratio
    own = sum(OPEN_SHARES.get(cause, 0.0) * mm for cause, mm in parts.items())
    own += parts.get("slots", 0.0) * crowded
    if approximated:
        grained = OPEN_GRAINED * max(0.0, shear**0.5 - 1)
        own += (OPEN_BUILT + grained) * length
    every = [OPEN_PLAIN, OPEN_CURLED * (nu / 0.3) ** 2, OPEN_WIDE * shear * (width / length) ** 2]
    return float(np.linalg.norm([*(length * np.array(every)), own]))


@dataclass(frozen=True)
class MakingTolerance:
    """What is assumed to be off in a strip that is made with care.

    Parameters
    ----------
    thickness_wave : float
        Amplitude of a wave of thickness, one over the length of the strip, as a share of the thickness.
    grain : float
        By how much the grain wanders to either side along the strip, rad; sheets without grain do not feel it.
    clamps : float
        By how much each clamp is turned, rad.
    kerf : float
        Width lost all along beyond what the kerf was corrected for, mm.
    modulus : float
        Share by which Young's modulus is smaller; only strips under weight or loads depend on it.

    Raises
    ------
    InputError
        A number that is negative or not finite.

    Examples
    --------
    >>> MakingTolerance(kerf=0.1).thickness_wave
    0.01
    """

    thickness_wave: Annotated[
        float,
        Asked("Amplitude of a wave of thickness along the strip, as a share of the thickness.", least=0),
    ] = 0.01
    grain: Annotated[
        float, Asked("By how much the grain wanders to either side along the strip.", "rad", least=0)
    ] = float(np.radians(2.0))
    clamps: Annotated[float, Asked("By how much each clamp is turned.", "rad", least=0)] = float(
        np.radians(0.5)
    )
    kerf: Annotated[
        float, Asked("Width that is lost beyond what the kerf was corrected for.", "mm", least=0)
    ] = 0.05
    modulus: Annotated[
        float,
        Asked(
            "Share by which Young's modulus is smaller; only strips under weight or loads depend on it.",
            least=0,
            most=0.5,
        ),
    ] = 0.1

    def __post_init__(self) -> None:
        require_declared(MakingTolerance, vars(self), "tolerance")


USUAL_TOLERANCE = MakingTolerance()
"""Of a shop that works with care."""


def sheet_effects(
    made: Rod, design: Rod, sheet: Sheet, breadth: FloatArray | None, tolerance: MakingTolerance
) -> dict[str, float]:
    """How far, mm, sheet, cut and clamps take a strip from where it rests, by cause, from one linear solve.

    Parameters
    ----------
    made : Rod
        The strip as made, at rest.
    design : Rod
        On the same nodes; its shape is what distances are measured from.
    sheet : Sheet
    breadth : (n,) array or None
        Width at the nodes of each of the parts that are cut side by side, mm; None where nothing is cut to width.
    tolerance : MakingTolerance
    """
    n, M = made.s.size, made.moment
    phases = 2 * np.pi * made.s[:, None] / made.length + np.pi * np.arange(PHASES) / PHASES
    wave = M[:, None] * np.cos(phases)
    changes = {"thickness": 3 * tolerance.thickness_wave * wave}  # E I ~ h^3
    # at the angle theta to the grain 1 / E grows by sin^2 (E / G - 2 nu - 2), here between 0 and that
    softer = np.sin(tolerance.grain) ** 2 * (1 / sheet.shear_ratio - 2 * sheet.poisson_ratio - 2)
    if sheet.grain != "none" and softer > 0:
        changes["grain"] = softer / 2 * wave
    if feels_modulus(design):
        changes["modulus"] = (tolerance.modulus / (1 - tolerance.modulus) * M)[:, None]
    if breadth is not None:
        changes["kerf"] = (M * tolerance.kerf / breadth)[:, None]
    for k, end in enumerate(made.supports.ends):
        if end.angle and not closes(design):
            turned = changes[f"clamp at the {('start', 'end')[k]}"] = np.zeros((n, 1))
            turned[-k] = made.stiffness[-k] * tolerance.clamps / made.discrete.node_lengths[-k]
    moved = shape_responses(made, np.hstack([*changes.values()]))
    owner = np.repeat(np.arange(len(changes)), [columns.shape[1] for columns in changes.values()])
    far = np.array([strayed(design, design.position + moved[:, k]) for k in range(owner.size)])
    return {cause: float(far[owner == k].max()) for k, cause in enumerate(changes)}
