"""The verdict on a rest shape: does it stay, or does it snap away?"""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.mechanics.rod.discrete_rod import DiscreteRod
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.conjugate_points import (
    Determinant,
    conjugate_point,
    stability_determinant,
)

SAFE_MARGIN = 5.0  # bears the inaccuracies of cutting and mounting; 0 is the border of stability
OUT_OF_BALANCE = 0.05  # share of the moments: what is further from balance is no rest shape, stable or not


@dataclass(frozen=True, eq=False)
class Stability:
    """What `stability` found.

    Attributes
    ----------
    stable : bool
        True when every small disturbance that the supports allow costs energy.
    margin : float
        Lowest eigenvalue of h -> int K h'^2 - <lambda, gamma'> h^2 against int h^2 on the tangent space of
        the end constraints, times length^2, K being dM/dkappa; positive means stable, and it is comparable between
        rods.
    mode : (n,) array
        The turning angles of that mode at the nodes, largest 1: the way in which the rod gives first.
    negative : int
        Number of unstable modes.
    conjugate_point : float or None
        The first isoperimetric conjugate point, mm of arc length from the start of the rod; None when
        there is none (the rod is stable) or when both ends leave the angle free, where it is not defined.
    started_from : {"start", "end"} or None
        The end from which the conjugate point is counted. Counted from the other one it lies elsewhere.
    determinant_s, determinant : (n,) arrays
        The curve Z(s) of Fig. 9 in arc length from the start, mm; empty where it is not defined. Next to
        `started_from` it has a zero of high order.
    borderline : bool
        True when the margin is smaller than its own rounding error; then `stable` is False.
    """

    stable: bool
    margin: float
    mode: FloatArray = field(repr=False)
    negative: int
    conjugate_point: float | None
    started_from: Literal["start", "end"] | None
    determinant_s: FloatArray = field(repr=False)
    determinant: FloatArray = field(repr=False)
    borderline: bool

    @property
    def word(self) -> Literal["unstable", "low", "ample"]:
        """The margin in a word: below 0, below `SAFE_MARGIN`, above it."""
        if not self.stable:
            return "unstable"
        return "low" if self.margin < SAFE_MARGIN else "ample"

    @property
    def meaning(self) -> str:
        """What the margin means to a maker, in words."""
        return {
            "unstable": "in balance but it will not stay: it snaps into another shape",
            "low": "it stays, but a push, a loose clamp or a cut that is off may make it snap",
            "ample": "it stays, and comes back when pushed",
        }[self.word]


def stability(rod: Rod) -> Stability:
    """Is the rest shape stable, with its weight and its supports? O(n).

    Three independent routes must agree: the inertia of the second variation bordered by the end constraints
    (LDL^t), the lowest eigenvalue on their tangent space (inverse iteration), and the sign changes of the
    stability determinant of the Jacobi equation (paper, section 6.2), which holds with weight too, since
    weight enters only through the force. All of them feel dM/dkappa (`Rod.tangent_stiffness`), which is up to a
    tenth more than M / kappa in a wide strip (`section`) that stiffens as it is bent.

    Parameters
    ----------
    rod : Rod
        In equilibrium: from `optimal_rod`, `bend` or `nearest_rod`.

    Returns
    -------
    Stability

    Raises
    ------
    InputError
        When the rod is far from balance: bend it first.
    NotConvergedError
        When the routes disagree.

    Examples
    --------
    >>> from elastica_cad.mechanics.rod.rod_record import Rod
    >>> from elastica_cad.mechanics.bending.bend_forward import bend
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(70.0, 0.0))
    >>> stability(arch).stable
    True
    """
    if not isinstance(rod, Rod):
        raise InputError(f"stability needs a Rod, as optimal_rod or bend makes one, not {type(rod).__name__}")
    if rod.residual > OUT_OF_BALANCE:
        raise InputError(
            f"the rod is out of balance (residual {rod.residual:.2g}), so it has no stability: bend it first"
        )
    discrete = rod.discrete
    negative, margin = discrete.unstable_modes, discrete.margin
    scale = float(np.abs(discrete.hessian[0]).max()) * discrete.angles.size * rod.length
    borderline = abs(margin.value) <= 64 * float(np.finfo(float).eps) * scale
    if not borderline and (negative == 0) != (margin.value > 0):
        raise NotConvergedError(
            f"stability is undecided: {negative} unstable modes counted, but the margin is {margin.value:.6g}"
        )

    started_from: Literal["start", "end"] | None = None
    place, determinant = None, None
    if any(discrete.held_angles):
        started_from = "start" if discrete.held_angles[1] else "end"
        counted = discrete if started_from == "start" else discrete.reversed()
        place, determinant = conjugate_point(counted), stability_determinant(counted)
    if started_from is not None and not borderline and (place is None) != (negative == 0):
        raise NotConvergedError(f"stability is undecided: {negative} unstable modes, conjugate point {place}")
    if determinant is not None and not borderline:
        _check_sign_changes(determinant, negative)

    s, value = np.zeros(0), np.zeros(0)
    if determinant is not None:
        s, value = determinant.s, determinant.value
    if started_from == "end":
        place = None if place is None else rod.length - place
        s, value = rod.length - s[::-1], value[::-1]
    return Stability(
        stable=negative == 0 and not borderline, margin=margin.value, mode=_nodal_mode(discrete),
        negative=negative, conjugate_point=place, started_from=started_from, determinant_s=s,
        determinant=value, borderline=borderline,
    )  # fmt: skip


def _check_sign_changes(determinant: Determinant, negative: int) -> None:
    """Unstable modes come in by sign changes of Z, unless Z drowns in rounding noise."""
    if abs(determinant.value[-1]) <= determinant.noise[-1]:
        return
    changes = determinant.sign_changes.size
    if (changes > 0) != (negative > 0):
        raise NotConvergedError(
            f"stability is undecided: Z(s) changes sign {changes} times, "
            f"but {negative} unstable modes were counted"
        )


def _nodal_mode(rod: DiscreteRod) -> FloatArray:
    """The mode of the margin averaged to the nodes, largest 1; zero at an end that holds the angle."""
    mode = rod.margin.mode
    nodal = np.empty(mode.size + 1)
    nodal[1:-1] = (mode[:-1] + mode[1:]) / 2
    for node, held in zip((0, -1), rod.held_angles, strict=True):
        nodal[node] = 0.0 if held else mode[node]
    return np.asarray(nodal / nodal[int(np.argmax(np.abs(nodal)))])
