"""The rule of strain: what a sheet bears for long, what happens to it beyond that, and where it breaks.

All front ends ask this one function, so that a strip that one of them makes is made by the others.
"""

from dataclasses import dataclass
from enum import IntEnum

from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.sheet_library import built_in_figures

STRAIN_SLACK = 1e-6
"""Relative slack of the limit: a curve that is drawn at its limit strays from it by less once it is a spline."""

BRITTLE_FACTOR = 1.5
"""Of what wood and brittle plastics bear for long: where they are taken to break if no figure is known."""

BRITTLE = ("plywood", "wood", "veneer", "board", "composite", "brittle plastic")
"""Kinds of sheets to which that applies."""

CRACKS = "it may crack there"
KEEPS_BEND = "it keeps a bend from there"
CREEPS = "it creeps there and keeps a part of its bend"
UNKNOWN = "it may crack there, or keep a bend"
OUTCOMES = {
    **dict.fromkeys(BRITTLE, CRACKS),
    **dict.fromkeys(("card", "paper", "metal"), KEEPS_BEND),
    "plastic": CREEPS,
}
"""What happens beyond the limit, by kind of sheet."""


class StrainState(IntEnum):
    """What the rule says, the worst last."""

    ALLOWED = 0
    WARNED = 1
    REFUSED = 2


@dataclass(frozen=True)
class StrainVerdict:
    """What the rule says of a strain in a sheet.

    Attributes
    ----------
    state : StrainState
        Allowed up to the limit, warned beyond it, refused where the sheet breaks, unless limits are ignored.
    used : float
        Strain over the limit.
    at : float or None
        Place along the strip, mm.
    outcome : str
        What happens to this material there; empty within the limit.
    """

    state: StrainState
    used: float
    at: float | None = None
    outcome: str = ""

    @property
    def allowed(self) -> bool:
        """Is it within what the sheet bears for long?"""
        return self.state is StrainState.ALLOWED

    @property
    def refused(self) -> bool:
        """Does it break?"""
        return self.state is StrainState.REFUSED

    @property
    def percent(self) -> int:
        """Of the limit: beyond it, if by a thousandth, at least 101; at the limit 100."""
        percent = round(100 * self.used)
        return min(percent, 100) if self.allowed else max(percent, 101)


def judge_strain(sheet: Sheet, strain: float, at: float | None = None) -> StrainVerdict:
    """What happens to a sheet whose outermost fibre is strained so far.

    Parameters
    ----------
    sheet : Sheet
    strain : float
        Dimensionless.
    at : float, optional
        Its place along the strip, mm.

    Examples
    --------
    >>> ply = Sheet.named("birch-plywood-0.8")
    >>> [judge_strain(ply, share * ply.max_strain).state.name for share in (1.0, 1.2, 3.0)]
    ['ALLOWED', 'WARNED', 'REFUSED']
    >>> judge_strain(Sheet.named("card-200gsm"), 0.015).outcome
    'it keeps a bend from there'
    """
    used = strain / sheet.max_strain
    if used <= 1 + STRAIN_SLACK:
        return StrainVerdict(StrainState.ALLOWED, used, at)
    breaks = breaking_strain(sheet)
    broken = breaks is not None and strain > breaks * (1 + STRAIN_SLACK)
    state = StrainState.REFUSED if broken else StrainState.WARNED
    return StrainVerdict(state, used, at, OUTCOMES.get(sheet.kind, UNKNOWN))


def breaking_strain(sheet: Sheet) -> float | None:
    """The strain at which a sheet breaks: its own figure, else that of brittle kinds; None where none is known."""
    known = sheet.break_strain
    if known is not None and known > sheet.max_strain:
        return known
    return BRITTLE_FACTOR * sheet.max_strain if sheet.kind in BRITTLE else None


def thinner_for(sheet: Sheet, strain: float) -> float | None:
    """The largest thickness below its own, mm, that the sheet is sold in and that bears the same curve.

    Examples
    --------
    >>> thinner_for(Sheet.named("birch-plywood-3"), 0.008)
    2.0
    """
    stem = sheet.name.removesuffix(f"-{sheet.thickness:g}")
    sold = (
        figures["thickness"] for name, figures in built_in_figures().items() if name.startswith(f"{stem}-")
    )
    for thickness in sorted((one for one in sold if one < sheet.thickness), reverse=True):
        thinner = sheet.with_thickness(thickness)
        if judge_strain(thinner, strain * thickness / sheet.thickness).allowed:
            return float(thickness)
    return None
