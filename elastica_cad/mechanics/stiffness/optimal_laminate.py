"""The rod that a laminate makes: its weight depends on the backing, and the backing on the rod."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import require_number, require_record, several
from elastica_cad.errors import InputError, NotConvergedError, rounded_up
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import point
from elastica_cad.mechanics.loads.arguments import require_curve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.laminated_section import BoundedBacking, LaminatedSection
from elastica_cad.mechanics.material.section_limits import ScaleRange
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stiffness.optimal_balance import extrapolated
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod
from elastica_cad.refusals import Length

_SETTLED_SHARE = 1e-5
"""Relative change between rounds that ends the search."""

_MOST_ROUNDS = 30
"""Largest number of optimal rods in the search for a laminate."""

_STATIONS = 81  # of the weight law, a cubic spline in between
_DENSE = 2001  # at which the backing must fit


@dataclass(frozen=True, eq=False)
class Laminate:
    """A rod and the layers that make it.

    Attributes
    ----------
    rod : Rod
        Its `bending_stiffness` is the scale c, N mm2: E I = c K.
    section : LaminatedSection
    base_width, backing_width : (n,) array
        w1 and w2 at the nodes of the rod, mm.
    range : ScaleRange
        Scales that could be built with this K; c is its upper end.
    rounds : int
        Optimal rods that were needed; 1 without weight.
    """

    rod: Rod
    section: LaminatedSection
    base_width: FloatArray
    backing_width: FloatArray
    range: ScaleRange
    rounds: int


def optimal_laminate(
    curve: PlaneCurve,
    section: LaminatedSection,
    base_width: "float | Profile",
    *,
    direction: ArrayLike | None = None,
    supports: Supports | None = None,
    samples: int | None = None,
    least_backing: float = 0.0,
    masses: tuple[PointMass, ...] = (),
) -> Laminate:
    """The rod of least ratio on a curve, and the backing that gives a base of given width its stiffness.

    The weight is that of both layers, linear in w2 and so not in K (paper, section 8.1, footnote 4): the
    weight law is set tangent to the true one at the last K and scale, until both stay. Where they go to and fro
    instead, `optimal_rod` goes on in short steps.

    Parameters
    ----------
    curve : PlaneCurve
    section : LaminatedSection
    base_width : float or Profile
        w1 along the curve, mm.
    direction : (2,) array_like, optional
        Where things fall in the plane of the curve; without it the strip is weightless.
    supports, samples
        As in `optimal_rod`.
    least_backing : float
        Narrowest backing that can be cut and glued, mm.
    masses : tuple of PointMass
        Hung on the strip.

    Returns
    -------
    Laminate

    Raises
    ------
    NotRealizable
        As `optimal_rod`.
    InputError
        The stiffness does not fit into the width; says which thickness ratio would do.
    NotConvergedError
        Weight and stiffness do not settle.

    Examples
    --------
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> card = Sheet.named("card-200gsm")
    >>> arch = PlaneCurve.ellipse((0, 0), (75, 60), start=0, end=3.1416)
    >>> laminate = optimal_laminate(arch, LaminatedSection(card, card), 20.0, direction=(0, -1))
    >>> round(float(laminate.backing_width.max()), 6)
    20.0
    """
    require_curve(curve)
    require_record(section, LaminatedSection, "the section", "a LaminatedSection(base, backing)")
    masses = several("masses", masses, PointMass, "PointMass")
    s_end = curve.length
    if isinstance(base_width, Profile) and not np.isclose(base_width.length, s_end, rtol=1e-6):
        raise InputError(
            "the base width is given over {length:.6g}, the curve is {s_end:.6g} long",
            length=Length(base_width.length),
            s_end=Length(s_end),
        )
    gravity = None if direction is None else _filled(section, direction)
    solve = partial(optimal_rod, curve, gravity, supports, samples=samples)
    rod = solve()
    base = _Base.under(rod, section, base_width, least_backing)
    if gravity is None:
        return base.laminate(rod, base.scale(rod), 1)
    laminate, change = _by_tangent_laws(solve, base, rod, masses)
    if laminate is not None:
        return laminate
    if isinstance(base_width, Profile):
        raise NotConvergedError(
            "weight and stiffness of the laminate do not settle (the stiffness still moves by "
            "{change:.2g}): give the base one width all along, which is searched for more "
            "closely, or use stiffer or lighter sheets",
            change=change,
        )
    rod = _by_short_steps(solve, section, float(base_width), masses)
    return base.laminate(rod, base.scale(rod), _MOST_ROUNDS)


@dataclass(frozen=True, eq=False)
class _Base:
    """The base of a laminate, and the places along it where a backing must fit.

    Attributes
    ----------
    section : LaminatedSection
    width : float or Profile
        w1, mm.
    least_backing : float
        Narrowest backing, mm.
    at_nodes : (n,) array
        w1 at the nodes of the rod, mm.
    places, at_places : (m,) arrays
        Arc lengths where it must fit, and w1 there, mm.
    """

    section: LaminatedSection
    width: "float | Profile"
    least_backing: float
    at_nodes: FloatArray
    places: FloatArray
    at_places: FloatArray

    @classmethod
    def under(
        cls, rod: Rod, section: LaminatedSection, width: "float | Profile", least_backing: float
    ) -> "_Base":
        """That of a rod of the curve's length."""
        at_nodes = _along(width, rod.s)
        places = np.union1d(np.linspace(0.0, rod.length, _DENSE), rod.s)
        if isinstance(width, Profile):
            places = np.union1d(places, np.clip(width.knots, 0.0, rod.length))
        return cls(section, width, least_backing, at_nodes, places, _along(width, places))

    def scale(self, rod: Rod) -> float:
        """The largest c, N mm2, with E I = c K within the base."""
        return _scale(self.section, self.at_places, _stiffness(rod, self.places), self.least_backing)

    def laminate(self, rod: Rod, scale: float, rounds: int) -> Laminate:
        """The record of a rod that is made with this scale."""
        K = np.asarray(rod.stiffness)
        return Laminate(
            rod=replace(rod, bending_stiffness=scale),
            section=self.section,
            base_width=self.at_nodes,
            backing_width=self.section.backing_width(self.at_nodes, scale * K),
            range=self.section.scale_range(self.at_nodes, K, least_backing=self.least_backing),
            rounds=rounds,
        )


def _by_tangent_laws(
    solve: Callable[..., Rod], base: _Base, rod: Rod, masses: tuple[PointMass, ...]
) -> tuple[Laminate | None, float]:
    """Each rod under a weight law tangent to the true one at the rod before; None and the last change of K where
    they do not settle.
    """
    section = base.section
    stations = np.linspace(0.0, rod.length, _STATIONS)
    w1 = _along(base.width, stations)
    bounds = section.bending_stiffness(w1, 0.0 * w1), section.bending_stiffness(w1, w1)
    scale = base.scale(rod)
    history: list[float] = []
    change, least = np.inf, 1.0  # a smoothed stiffness may have a least value above the 1 that was asked for
    for rounds in range(2, _MOST_ROUNDS):
        asked = scale / least
        # an extrapolated scale may ask for more than two full layers somewhere, or for less than the base
        EI = np.clip(scale * _stiffness(rod, stations), *bounds)
        weight = section.weight(stations, w1, EI / asked, asked)
        found = solve(weight=Weight(weight.alpha, weight.beta, masses), bending_stiffness=asked)
        change = float(np.abs(found.stiffness / rod.stiffness - 1).max())
        rod, got = found, found.bending_stiffness or asked
        least = got / asked
        scale = base.scale(rod)
        if change < _SETTLED_SHARE and abs(scale / got - 1) < _SETTLED_SHARE:
            return base.laminate(rod, scale, rounds), change
        history.append(np.log(scale))
        if len(history) == 3:
            scale = float(np.exp(extrapolated(*history)))
            history.clear()
    return None, change


def _by_short_steps(
    solve: Callable[..., Rod], section: LaminatedSection, base_width: float, masses: tuple[PointMass, ...]
) -> Rod:
    """The rod that `optimal_rod` finds for a base of one width."""
    law = BoundedBacking(section, np.asarray(base_width), (0.0, base_width))
    try:
        rod = solve(section=law, weight=Weight(masses=masses, own=True))
    except InputError as error:
        raise InputError(
            "the laminate cannot be as soft in one place and as stiff in another as the curve needs under "
            "this weight: use a thicker backing, or lighter sheets"
        ) from error
    return replace(rod, section=None)


def _along(width: float | Profile, s: FloatArray) -> FloatArray:
    return (
        width(s)
        if isinstance(width, Profile)
        else np.full(s.shape, require_number(width, "base width", "mm"))
    )


def _stiffness(rod: Rod, s: FloatArray) -> FloatArray:
    """K from the profile, whose own small error must not fall below the least value."""
    return np.maximum(rod.profile(s), 1.0)


def _filled(section: LaminatedSection, direction: ArrayLike) -> Gravity:
    """Gravity of the laminate with two full layers, to begin with."""
    length = section.bending_stiffness(1.0, 1.0) / section.weight_per_length(1.0, 1.0)
    x, y = point(direction, "direction")
    return Gravity(float(length ** (1 / 3)), (float(x), float(y)))


def _scale(
    section: LaminatedSection, base_width: FloatArray, stiffness: FloatArray, least_backing: float
) -> float:
    found = section.scale_range(base_width, stiffness, least_backing=least_backing)
    if not found.feasible:
        ratio = section.thickness_ratio(base_width, stiffness, least_backing=least_backing)
        raise InputError(
            "the laminate cannot be as soft in one place and as stiff in another as the curve "
            "needs: with the backing {least:g} times as thick as the base (now "
            "{thickness:.3g} times) or more it could",
            least=rounded_up(1 / ratio, 3),
            thickness=section.backing.thickness / section.base.thickness,
        )
    return found.scale
