"""Creep of a bent strip: sag, relaxed clamp forces and the bend that remains after release."""

from dataclasses import dataclass, replace

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number
from elastica_cad.errors import InputError, Length, NotConvergedError, note, sentences
from elastica_cad.geometry.plane_points import norm
from elastica_cad.mechanics.bending import bend, dead_loads, has_snapped
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.loads import Supports
from elastica_cad.mechanics.rod import CurlingLaw, Rod, require_rod
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.tolerances import feels_modulus


@dataclass(frozen=True, eq=False)
class Creep:
    """Result of `creep`.

    Attributes
    ----------
    factor : float
        Creep factor phi: ratio of creep strain to elastic strain.
    rod, later : Rod
        Rod before creep and after creep has ended, with the same supports.
    exact : bool
        True if the result is exact for a homogeneous standard linear solid. False if the result is an
        approximation with an effective modulus.
    """

    factor: float
    rod: Rod
    later: Rod
    exact: bool

    @property
    def force_share(self) -> float:
        """Fraction 1 / (1 + phi) of the modulus that remains after creep, with the creep factor phi.

        If the shape does not change, the same fraction of the clamp forces remains.
        """
        return 1 / (1 + self.factor)

    @property
    def kept_share(self) -> float:
        """Fraction phi / (1 + phi) of the bend that remains just after release, with the creep factor phi.

        The fraction decreases later.
        """
        return self.factor / (1 + self.factor)

    @property
    def sag(self) -> float:
        """Largest displacement of the strip by creep, mm; 0 without weight or constant loads on free ends."""
        return float(norm(self.later.position - self.rod.position).max())

    @property
    def end_forces(self) -> FloatArray:
        """Forces on start and end (2, 2) after creep has ended, 1/mm2.

        The forces are divided by the least bending stiffness before creep.
        """
        return self.later.force[[0, -1]] * self.force_share

    @property
    def stays(self) -> bool:
        """True if the strip remains stable and does not snap while it creeps."""
        return not has_snapped(self.later) and self.stability.stable

    @property
    def stability(self) -> Stability:
        """Stability of the shape after creep has ended."""
        return stability(self.later)

    def released(self) -> Rod:
        """Return the strip, without weight, just after both ends are released at the end of creep.

        The start of the strip does not move.
        """
        rod = self.later
        free = Rod.straight(
            rod.length, rod.profile, samples=rod.s.size, start=rod.position[0],
            angle=float(rod.angle[0]), supports=Supports(end="free"),
        )  # fmt: skip
        rest = rod.natural_curvature + self.kept_share * (rod.curvature - rod.natural_curvature)
        turned = rod.angle[0] + self.kept_share * (rod.angle - rod.angle[0])
        return bend(replace(free, natural_curvature=rest), guess=turned)

    def __str__(self) -> str:
        summary = note(
            "In the long run the strip sags by {sag} and keeps {force:.0f} % of its stiffness. When the "
            "strip is taken out, it keeps {bend:.0f} % of its bend at first. (Creep factor {factor:g}; "
            "exact for a linear homogeneous sheet.)"
            if self.exact else
            "In the long run the strip sags by {sag} and keeps {force:.0f} % of its stiffness. When the "
            "strip is taken out, it keeps {bend:.0f} % of its bend at first. (Creep factor {factor:g}; an "
            "approximation by the effective modulus.)",
            factor=self.factor, sag=Length(self.sag), force=100 * self.force_share, bend=100 * self.kept_share,
        )  # fmt: skip
        after = self.stability
        if not self.stays:
            snaps = note(
                "After creep the strip snaps into another shape under its load. Use a stiffer sheet, or "
                "support the strip."
            )
            return sentences([summary, snaps], " ")
        if after.word == "low" and stability(self.rod).word == "ample":
            return sentences(
                [
                    summary,
                    note(
                        "After creep the strip is close to snapping (stability margin {margin:.3g}; at least "
                        "{safe:.3g} is safe).",
                        margin=after.margin,
                        safe=after.safe,
                    ),
                ],
                " ",
            )
        return summary


def creep(rod: Rod, factor: float) -> Creep:
    """Return the shapes of a rod before creep and after creep has ended, with unchanged supports.

    The elastic modulus becomes E / (1 + phi), the effective modulus under a permanent load. Weights, and the forces
    and moments on free ends, do not change. The long-term shape of a standard linear solid is exact, whatever
    the history of its loads. Without loads the shape does not change, and the forces decrease in proportion to
    the modulus. The duration of creep depends on the creep law of the sheet and is not computed.

    Parameters
    ----------
    rod : Rod
        Rod in equilibrium.
    factor : float
        Creep factor phi, 0 or more. For wood-based panels under permanent load, phi is k_def of Eurocode 5,
        table 3.2. For plywood (EN 636), k_def is 0.80 in heated rooms, 1.00 under a roof, and 2.50 outdoors.

    Raises
    ------
    NotConvergedError
        The strip collapses during creep, because no equilibrium exists near the first shape.

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> from elastica_cad.mechanics.loads import Gravity
    >>> arch = bend(Rod.straight(300.0, gravity=Gravity(100.0)), end=(200.0, 0.0))
    >>> found = creep(arch, 0.8)
    >>> found.sag > 1, round(found.force_share, 3)
    (True, 0.556)
    """
    require_rod(rod, "creep")
    phi = require_creep(factor)
    require_free_between(rod, "A creep study")
    first = later = rod
    if phi > 0 and feels_modulus(rod):
        first = bend(rod, guess=rod.angle)
        force, moment = dead_loads(rod, 1 + phi)
        soft = first
        if soft.gravity is not None:
            soft = replace(soft, gravity=soft.gravity.scaled(1 + phi))
        if soft.bending_stiffness is not None:
            soft = replace(soft, bending_stiffness=soft.bending_stiffness / (1 + phi))
        try:
            later = bend(soft, force=force, moment=moment, guess=rod.angle)
        except NotConvergedError as problem:
            raise NotConvergedError(
                f"Over the years the strip collapses under its load (creep factor {phi:g}). Use a stiffer sheet, "
                "or support the strip."
            ) from problem
    return Creep(
        phi,
        first,
        later,
        exact=rod.law is None or (isinstance(rod.law, CurlingLaw) and rod.law.below is None),
    )


def require_creep(factor: object) -> float:
    """Return the creep factor; refuse negative values and values that are not numbers."""
    if not is_number(factor):
        raise InputError(f"creep is {factor!r}: give the creep factor, a number of 0 or more, such as 0.8")
    if factor < 0:
        raise InputError(
            "creep is {factor:g}: give 0 or more; for plywood indoors 0.8 (Eurocode 5)", factor=factor
        )
    return float(factor)
