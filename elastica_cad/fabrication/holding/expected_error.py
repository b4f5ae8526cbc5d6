"""How far the shape of a real strip lies from the computed one: what the model leaves open, what the sheet adds."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.declared import Asked, require_declared
from elastica_cad.fabrication.holding.held_shape import (
    ANTICLASTIC,
    LEAF_ENDS,
    closes,
    shape_responses,
    strayed,
)
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.sheet_library import even_shear_ratio
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.studies.tolerance_study import feels_modulus

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
