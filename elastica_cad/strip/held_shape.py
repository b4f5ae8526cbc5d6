"""Records of a mounted strip: reactions, shape and expected deviation; effects of sheet, cut and clamps on the
deviation.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import Force, Length, Moment, Refusal, note, sentences
from elastica_cad.geometry.plane_curve import CORNER_RAD
from elastica_cad.geometry.plane_points import cross, dot, left_of, norm, rotated
from elastica_cad.mechanics.discrete_rod import solve_tridiagonal
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Sheet, even_shear_ratio
from elastica_cad.mechanics.tolerances import feels_modulus
from elastica_cad.strip.tab_seats import EndPose, TabSeat


def closes(rod: Rod) -> bool:
    """Return True if the ends of a rod meet and have the same direction."""
    gap = float(norm(rod.chord))
    turn = float(np.angle(np.exp(1j * float(rod.angle[-1] - rod.angle[0]))))
    # the ends of closed rods with few nodes do not meet exactly
    return gap <= 1e-4 * rod.length and abs(turn) <= CORNER_RAD


@dataclass(frozen=True, eq=False)
class Reactions:
    """Forces (2,), N, and moments, N mm (positive anticlockwise), of the supports on the strip.

    Examples
    --------
    >>> print(Reactions(np.array([1.0, 0.0]), 20.0, np.array([-1.0, 0.0]), -20.0))
    the start is held by a force of 1 N (x 1, y 0) and a moment of 20 N mm; the end is held by ...
    """

    start_force: FloatArray
    start_moment: float
    end_force: FloatArray
    end_moment: float

    @property
    def sizes(self) -> tuple[tuple[Force, Moment], tuple[Force, Moment]]:
        """Sizes of force and moment at the start, and at the end."""
        start = Force(norm(self.start_force)), Moment(abs(self.start_moment))
        return start, (Force(norm(self.end_force)), Moment(abs(self.end_moment)))

    def __str__(self) -> str:
        start, end = (
            note(
                "a force of {force:.3g} (x {x:.3g}, y {y:.3g}) and a moment of {moment:.3g}",
                force=Force(np.hypot(x, y)), x=x, y=y, moment=Moment(moment),
            )
            for (x, y), moment in ((self.start_force, self.start_moment), (self.end_force, self.end_moment))
        )  # fmt: skip
        return note("the start is held by {start}; the end is held by {end}", start=start, end=end)


Seats = tuple[TabSeat | None, TabSeat | None]

ANTICLASTIC = "anticlastic bending"
"""Cause of deviation: a wide strip curls across as it bends, which changes its stiffness."""

LEAF_ENDS = "ends of leaves"
"""Cause of deviation: the neutral axis of a stack jumps by half a thickness where a glued ply ends."""

LOOSE_TABS = "loose tabs"
"""Cause of deviation: the tabs shift and turn in their holders."""

LEAST_REPORTED_MM = 0.005
"""Smallest deviation, mm, that is reported with its cause."""


@dataclass(frozen=True)
class Contribution:
    """Contribution of one cause to the expected deviation of a strip.

    Attributes
    ----------
    cause : str
        Name of the cause, as a message.
    mm : float
        Computed deviation due to this cause, mm.
    key : str
        Key of the design that determines the contribution, or an empty string.
    """

    cause: str
    mm: float
    key: str = ""

    @property
    def sentence(self) -> Refusal:
        """Amount, cause and key, for a message."""
        return note(
            "{far} due to {cause} ({key})" if self.key else "{far} due to {cause}",
            far=about(self.mm), cause=self.cause, key=self.key,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class HeldShape:
    """Shape of a strip in its holders.

    Attributes
    ----------
    rod : Rod
        Rest shape in the holders, with all causes of deviation.
    deviation : float
        Largest computed distance between a point of the strip and its designed position, mm.
    parts : mapping of str to float
        Deviation due to each cause alone, mm: "slots", "narrow tabs", "leaning ligaments", "anticlastic bending"
        and so on to first order, and "loose tabs".
    start, end : EndPose
        Positions of the ends at rest.
    corrected : bool
        True if the widths were corrected. `parts` then describes the strip without the correction.
    as_plate : bool
        True if the widths compensate anticlastic bending.
    made_up_for : tuple of str
        Causes that the corrected widths compensate. The effect of holders is not among them.
    open : float
        Uncertainty of the model, mm, for a strip without errors of sheet and workmanship: see `open_deviation`.
    sheet : mapping of str to float
        Deviation due to sheet, cut and clamps, mm, by cause: see `sheet_effects`.
    notes : tuple of str
        Notes on the assumptions of the model for this strip.
    contributions : tuple of Contribution
        Contributions to the expected deviation, the largest first.
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
    contributions: tuple[Contribution, ...] = ()

    @property
    def sheet_adds(self) -> float:
        """Deviation due to sheet, cut and clamps together, mm, combined as independent errors."""
        return float(np.linalg.norm([*self.sheet.values(), 0.0]))

    @property
    def expected(self) -> float:
        """Expected deviation of a real strip, mm: computed effects, model uncertainty, and sheet errors
        combined.
        """
        return float(np.linalg.norm([self.deviation, self.open, self.sheet_adds]))

    def __str__(self) -> str:
        strays = note(
            "A real strip, with widths that compensate anticlastic bending (bending across the strip), "
            "deviates from its design by about {far}, {percent:g} % of its length" if self.as_plate else
            "A real strip deviates from its design by about {far}, {percent:g} % of its length",
            far=about(self.expected), percent=_two_digits(100 * self.expected / self.rod.length),
        )  # fmt: skip
        listed = [part.sentence for part in self.contributions if part.mm >= LEAST_REPORTED_MM]
        if listed:
            strays = note("{strays}. Contributions: {causes}", strays=strays, causes=sentences(listed))
        return sentences((strays, *self.notes), ". ")


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")


def about(mm: float) -> Length:
    """Return a length in mm, rounded to whole micrometres, then to two digits."""
    return Length(_two_digits(round(mm, 3)))


def deviation_from(design: Rod, place: FloatArray) -> float:
    """Return the largest distance, mm, between the nodes `place` (n, 2) of a shape and the nodes of the design.

    A closed strip has no fixed position, so its shape is first moved and turned to fit the design.
    """
    if closes(design):
        target = design.position.mean(axis=0)
        off, designed = place - place.mean(axis=0), design.position - target
        turn = np.arctan2(cross(off, designed).sum(), dot(off, designed).sum())
        place = target + rotated(off, turn)
    return float(norm(place - design.position).max())


def shape_responses(
    rod: Rod, moments: FloatArray, loads: FloatArray | None = None, apart: FloatArray | None = None
) -> FloatArray:
    """Return the displacements (n, m, 2), mm, of the n nodes of a rod in equilibrium for m small disturbances.

    A disturbance is, for example, another width, which changes the moments and weights. The start of the rod is
    fixed.

    While the edge angles alpha are fixed, a disturbance changes the imbalance of moments by d(imbalance). The
    angles and the end forces lambda then change by d(alpha) and d(lambda) until the rod is in equilibrium again:
    H d(alpha) + C^t d(lambda) = -d(imbalance) and C d(alpha) = d(chord). H is the Hessian of the discrete energy
    (paper, section 7.1). C is the derivative of the chord, the vector between the ends, with respect to alpha.

    Parameters
    ----------
    rod : Rod
    moments : (n, m) array
        Changes of the moments at the nodes while the edge angles are fixed, divided by the bending stiffness B
        of the rod, 1/mm.
    loads : (n, m, 2) array, optional
        Changes of the weights of the nodes, divided by B, 1/mm2.
    apart : (m, 2) array, optional
        Displacement of the end relative to the start, mm.
    """
    require_free_between(rod, "The shape as made")
    discrete, (n, m) = rod.discrete, moments.shape
    lengths, tangents = discrete.edge_lengths[:, None], discrete.tangents
    imbalance = moments[:-1] - moments[1:]
    if loads is not None:
        pull = np.zeros((n - 1, m, 2))
        pull[1:] = loads[1:-1].cumsum(axis=0)
        imbalance = imbalance + lengths * cross(tangents[:, None], pull)
    rows = discrete.constraint_rows
    answers = solve_tridiagonal(*discrete.hessian, np.hstack([-imbalance, rows.T]))
    turned, forced = answers[:, :m], answers[:, m:]
    # required change of the held coordinates of the end
    chord = 0.0 if apart is None else apart.T[list(discrete.held)]
    # `rows` can be singular, because small rotations do not change the length of a straight rod
    turned = turned + forced @ np.linalg.lstsq(rows @ forced, chord - rows @ turned, rcond=None)[0]
    moved = np.zeros((n, m, 2))
    moved[1:] = (lengths[..., None] * turned[..., None] * left_of(tangents)[:, None]).cumsum(axis=0)
    return moved


PHASES = 8
"""Number of phases at which a wave of the thickness or of the grain is tried."""

OPEN_FRACTIONS: Mapping[str, float] = {
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
"""Largest error of the model as a fraction of the deviation due to each cause (`docs/finite_elements.md`)."""

OPEN_PLAIN, OPEN_CURLED, OPEN_BUILT, OPEN_GRAINED = 1e-4, 2.5e-4, 3e-4, 2.2e-3
"""Uncertainties of the model as fractions of the length.

`OPEN_PLAIN` is for any strip. `OPEN_CURLED` is for sheets that curl across the strip; it holds for the
Poisson ratio nu = 0.3 and is proportional to nu^2. `OPEN_BUILT` is for perforated and laminated strips.
`OPEN_GRAINED` is added for perforated and laminated strips of sheets with grain, because their holes and
borders are computed as isotropic. `OPEN_GRAINED` is multiplied by r - 1, where r is sqrt(E / G) divided by
its isotropic value.
"""

OPEN_WIDE = 2e-3
"""Uncertainty of a wide strip of varying width as a fraction of the length, because its cross sections warp.

The fraction is multiplied by (width / length)^2, and by E / G divided by its isotropic value."""


def open_deviation(
    length: float,
    sheet: Sheet,
    parts: Mapping[str, float],
    *,
    width: float,
    approximated: bool,
    crowded: bool,
) -> float:
    """Return the uncertainty of the model, mm, apart from errors of sheet and workmanship.

    It is the root of the sum of the squares of four errors. One is the sum of the errors due to the causes in
    `parts` and, if `approximated`, due to holes or a backing. The others have the factors `OPEN_PLAIN`,
    `OPEN_CURLED` and `OPEN_WIDE`.

    Parameters
    ----------
    length : float
        Length of the strip, mm.
    sheet : Sheet
    parts : mapping of str to float
        Deviation due to each cause if the widths did not compensate for it, mm.
    width : float
        Largest width of the strip or of a ligament, mm.
    approximated : bool
        True if the drawing only approximates the stiffness, as holes and backings do.
    crowded : bool
        True if slots are so close to each other that their combined effect is not known.
    """
    nu = sheet.poisson_ratio
    shear = even_shear_ratio(nu) / sheet.shear_ratio
    from_causes = sum(OPEN_FRACTIONS.get(cause, 0.0) * mm for cause, mm in parts.items())
    # the combined effect of crowded slots is unknown, so the whole effect of slots counts as an error
    from_causes += parts.get("slots", 0.0) * crowded
    if approximated:
        from_causes += (OPEN_BUILT + OPEN_GRAINED * max(0.0, shear**0.5 - 1)) * length
    every = [OPEN_PLAIN, OPEN_CURLED * (nu / 0.3) ** 2, OPEN_WIDE * shear * (width / length) ** 2]
    return float(np.linalg.norm([*(length * np.array(every)), from_causes]))


@dataclass(frozen=True)
class MakingTolerance:
    """Assumed deviations of a strip that is made with care.

    Parameters
    ----------
    thickness_wave : float
        Amplitude of a wave of the thickness as a fraction of the thickness; its period is the strip's length.
    grain : float
        Largest deviation of the direction of the grain along the strip, rad; for sheets with grain.
    clamps : float
        Error of the angle of each clamp, rad.
    kerf : float
        Width that the cut removes in addition to the compensated kerf, mm. Strips become narrower, and slots
        wider.
    modulus : float
        Relative reduction of Young's modulus; it has an effect only on strips under weight or loads.

    Examples
    --------
    >>> MakingTolerance(kerf=0.1).thickness_wave
    0.01
    """

    thickness_wave: Annotated[
        float,
        Option("Amplitude of a wave of thickness along the strip, as a fraction of the thickness.", least=0),
    ] = 0.01
    grain: Annotated[
        float,
        Option("Deviation of the grain to either side along the strip.", "rad", least=0, most=np.pi / 2),
    ] = float(np.radians(2.0))
    clamps: Annotated[float, Option("Error of the angle of each clamp.", "rad", least=0, most=np.pi / 2)] = (
        float(np.radians(0.5))
    )
    kerf: Annotated[
        float, Option("Width that the cut removes in addition to the corrected kerf.", "mm", least=0)
    ] = 0.05
    modulus: Annotated[
        float,
        Option(
            "Relative reduction of Young's modulus; it affects only strips under weight or loads.",
            least=0,
            most=0.5,
        ),
    ] = 0.1

    def __post_init__(self) -> None:
        require_declared(MakingTolerance, vars(self), "tolerance")


USUAL_TOLERANCE = MakingTolerance()
"""Tolerances of a careful workshop."""

SHEET_KEYS: Mapping[str, str] = {
    "thickness": "thickness_wave",
    "grain": "grain",
    "modulus": "modulus",
    "kerf": "kerf",
    "clamp at the start": "clamps",
    "clamp at the end": "clamps",
    "thinner tabs": "thickness_wave",
    "wider slots": "kerf",
}
"""Fields of `MakingTolerance` by the cause of a deviation."""


def sheet_effects(
    rod: Rod, design: Rod, sheet: Sheet, breadth: FloatArray | None, tolerance: MakingTolerance
) -> dict[str, float]:
    """Return the deviation, mm, due to each error of sheet, cut and clamps, to first order.

    Parameters
    ----------
    rod : Rod
        The strip as made, at rest.
    design : Rod
        Design with the same nodes; distances are measured from its shape.
    sheet : Sheet
    breadth : (n,) array or None
        Width of the strip or of each ligament at the nodes, mm; None for planed or turned strips.
    tolerance : MakingTolerance
    """
    n, M = rod.s.size, rod.moment
    phases = 2 * np.pi * rod.s[:, None] / rod.length + np.pi * np.arange(PHASES) / PHASES
    # changes of the moments (n, columns) by cause; a wave has a column for each phase, of which the worst counts
    wave = M[:, None] * np.cos(phases)
    # E I is proportional to the cube of the thickness
    changes = {"thickness": 3 * tolerance.thickness_wave * wave}
    # at the angle t to the grain, the compliance 1 / E grows at most by the fraction sin^2(t) (E / G - 2 nu - 2)
    softer = np.sin(tolerance.grain) ** 2 * (1 / sheet.shear_ratio - 2 * sheet.poisson_ratio - 2)
    if sheet.grain != "none" and softer > 0:
        # the compliance varies by fractions from 0 to `softer`
        changes["grain"] = softer / 2 * wave
    if feels_modulus(design):
        changes["modulus"] = (tolerance.modulus / (1 - tolerance.modulus) * M)[:, None]
    if breadth is not None:
        changes["kerf"] = (M * tolerance.kerf / breadth)[:, None]
    for k, end in enumerate(rod.supports.ends):
        if end.angle and not closes(design):
            turned = changes[f"clamp at the {('start', 'end')[k]}"] = np.zeros((n, 1))
            turned[-k] = rod.stiffness[-k] * tolerance.clamps / rod.discrete.node_lengths[-k]
    moved = shape_responses(rod, np.hstack([*changes.values()]))
    owner = np.arange(len(changes)).repeat([columns.shape[1] for columns in changes.values()])
    far = np.array([deviation_from(design, design.position + moved[:, k]) for k in range(owner.size)])
    return {cause: float(far[owner == k].max()) for k, cause in enumerate(changes)}
