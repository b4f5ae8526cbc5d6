"""Rod with its shape, stiffness and forces at the nodes, and resampling of a rod."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import isclose
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import BLUE, GREY, svg_of_lines
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, numbers, pair, require_number, require_positive, with_article
from elastica_cad.errors import InputError
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.plane_curve import DEGREE, SURVEY_POINTS, PlaneCurve, integrate_tangents
from elastica_cad.geometry.plane_points import angle_of, left_of, midpoints, norm, unit_vectors
from elastica_cad.geometry.polynomials import gauss_rule
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import fit_spline, spline_through
from elastica_cad.mechanics.bracing import slack_elements
from elastica_cad.mechanics.cross_sections import BendFactor, Section, at_stations, scale_within
from elastica_cad.mechanics.discrete_rod import (
    Compression,
    DiscreteRod,
    edge_forces,
    edge_positions,
    nodal_forces,
    node_weights,
)
from elastica_cad.mechanics.elements import AT_END_SHARE, ElementForce, at_ends, lumped
from elastica_cad.mechanics.loads import (
    Gravity,
    NaturalCurvature,
    Supports,
    Weight,
    nodal_curvature,
    require_gravity,
    require_supports,
    whole_number,
)
from elastica_cad.mechanics.moment_curvature import MaterialLaw

if TYPE_CHECKING:
    from elastica_cad.mechanics.theorem1 import EquilibriumCheck, InflectionLine


# Number of nodes of a final rod. A 300 mm strip has a node every half millimetre, and an error below the kerf
# of a laser.
DEFAULT_SAMPLES = SURVEY_POINTS

# Number of nodes of a rod in a search. Its error is nine times the error of a final rod; `editable_curve`
# removes it by extrapolation.
SEARCH_SAMPLES = 201

DUST_SHARE = 1e-12
"""Values below this fraction of the largest value of the same unit are rounding errors and are written as 0."""


def csv_text(table: Mapping[str, Any]) -> str:
    """Return a table of named columns (n,) as comma-separated text with a header; each name ends in its unit.

    Examples
    --------
    >>> print(csv_text({"x_mm": [0, 1], "y_mm": [1e-17, 2]}), end="")
    x_mm,y_mm
    0,0
    1,2
    """
    columns = {name: np.asarray(column, dtype=float) for name, column in table.items()}
    largest: dict[str, float] = {}
    for name, column in columns.items():
        finite = np.abs(column[np.isfinite(column)])
        largest[_unit(name)] = max(largest.get(_unit(name), 0.0), float(finite.max(initial=0.0)))
    cleaned: dict[str, FloatArray] = {
        name: np.where(np.abs(column) <= DUST_SHARE * largest[_unit(name)], 0.0, column)
        for name, column in columns.items()
    }
    rows = [",".join(cleaned)]
    rows += [",".join(f"{value:.9g}" for value in row) for row in zip(*cleaned.values(), strict=True)]
    return "\n".join(rows) + "\n"


def _unit(name: str) -> str:
    return name.rsplit("_", 1)[-1]


def cell_edges(s: FloatArray) -> FloatArray:
    """Return the ends (n + 1,) of the cells around nodes at arc lengths s (n,)."""
    return np.concatenate([s[:1], midpoints(s), s[-1:]])


def _nodal_stiffness(profile: Profile, s: FloatArray) -> FloatArray:
    """Return the stiffness (n,) at uniform arc lengths (n,), mm.

    At a jump, the result is the inverse of the mean compliance near the node. The shape of the rod then depends
    continuously on the position of the jump.
    """
    K = profile(s)
    steps = np.array([place for place, continuity in profile.breaks if continuity < 0])
    if not steps.size:
        return K
    edges, (points, weights) = cell_edges(s), gauss_rule(3)
    for i in np.unique((edges.searchsorted(steps) - 1).clip(0, s.size - 1)):
        cuts = np.unique(
            np.concatenate([edges[i : i + 2], steps[(steps > edges[i]) & (steps < edges[i + 1])]])
        )
        turned = 0.0
        for a, b in pairwise(cuts):
            inside = (a + b) / 2 + (b - a) / 2 * points
            turned += (b - a) / 2 * float(weights @ (1 / profile(inside)))
        K[i] = (edges[i + 1] - edges[i]) / turned
    return K


def _scaled_to_least(profile: Profile, s: FloatArray) -> tuple[Profile, FloatArray]:
    """Return a stiffness profile and its values at nodes s (n,), mm, both divided by the least value."""
    K = profile(s)
    if (K <= 0).any():
        at = Mm(s[K.argmin()])
        raise InputError(
            f"the stiffness of the rod is not positive {at:.6g} from its start: give numbers above 0"
        )
    return profile.scaled(1 / K.min()), K / K.min()


def _stiffness_profile_of(
    stiffness: "ArrayLike | Profile", length: float, samples: int | None
) -> tuple[Profile, int]:
    """Return the stiffness as a profile over [0, length], and the number of nodes.

    Without `samples`, the number of nodes is the size of an array of stiffnesses, or else `DEFAULT_SAMPLES`.
    """
    if isinstance(stiffness, Profile):
        if not isclose(stiffness.length, length, rel_tol=1e-9, abs_tol=1e-8):
            raise InputError(
                f"the stiffness profile is {Mm(stiffness.length):.6g} long, but the rod is {Mm(length):.6g} "
                "long: give a profile of the rod's length"
            )
        return stiffness, samples or DEFAULT_SAMPLES
    array = as_floats(stiffness)
    values = np.array([]) if array is None else np.atleast_1d(array)
    if not values.size or values.ndim != 1 or not np.isfinite(values).all() or (values <= 0).any():
        raise InputError(
            "stiffness cannot be used: give a positive finite number, or such a number for each node"
        )
    n = samples or (values.size if values.size > 1 else DEFAULT_SAMPLES)
    if values.size == 1:
        values = np.full(2, values[0])
    return Profile.interpolate(np.linspace(0.0, length, values.size), values), n


@dataclass(frozen=True, eq=False)
class CurlingLaw(MaterialLaw):
    """Law M = K m(kappa - kappa_0) at the nodes of a rod whose section depends on its curvature.

    M is the moment, K the stiffness in the design shape, m the effective curvature, kappa the curvature and
    kappa_0 the natural curvature.

    Parameters
    ----------
    factor : BendFactor
        Function that returns factors on the stiffness of the nodes for their curvatures.
    designed : (n,) array
        Factors at the design curvature, which K already includes.
    natural_curvature : float or (n,) array
        Natural curvature kappa_0 of the rod, 1/mm.
    below : MaterialLaw, optional
        Law of the material. The effective curvature of this law is multiplied by the factor.

    Examples
    --------
    >>> from elastica_cad.mechanics.sections import SheetCurl
    >>> wide = SheetCurl(np.full(2, 40.0), 0.5, 0.3)
    >>> law = CurlingLaw(wide, wide(np.array([0.0, 0.01])))
    >>> law.effective_curvature([0.01, 0.01]).round(5).tolist()
    [0.01078, 0.01]
    """

    factor: BendFactor
    designed: FloatArray
    natural_curvature: float | FloatArray = 0.0
    below: MaterialLaw | None = None

    def share(self, curvature: ArrayLike) -> FloatArray:
        """Return the ratio of stiffness to design stiffness for changes of curvature (..., n), 1/mm."""
        return self.factor(np.asarray(curvature, dtype=float) + self.natural_curvature) / self.designed

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """Return moment / design stiffness (..., n), 1/mm, for changes of curvature (..., n), 1/mm."""
        change = np.asarray(curvature, dtype=float)
        m = change if self.below is None else self.below.effective_curvature(change)
        return m * self.share(change)

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """Return the derivative (n,) of moment / design stiffness by the change of curvature."""
        return self.with_slope(curvature)[1]

    def with_slope(self, curvature: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return moment / design stiffness (n,), 1/mm, and its derivative (n,) by the change of curvature."""
        change = np.asarray(curvature, dtype=float)
        step = 1e-7 * (float(np.abs(change).max()) or 1.0)
        here, beyond = self.share(np.stack([change, change + step]))
        m, slope = (change, 1.0) if self.below is None else self.below.with_slope(change)
        return m * here, (slope * here + m * (beyond - here) / step)

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """Return the elastic energy (n,) per length, divided by the stiffness K, 1/mm2."""
        change = np.asarray(curvature, dtype=float)
        # the error is 1e-9 for flat and 1e-3 for pre-bent strips
        x, weight = gauss_rule(24)
        root = (x + 1) / 2  # points are denser near 0, where the stiffness changes most
        return change * ((weight * root) @ self.effective_curvature(root[:, None] ** 2 * change))

    def curvature(self, effective: ArrayLike) -> FloatArray:
        """Return the changes of curvature (n,), 1/mm, for values (n,) of moment / design stiffness, 1/mm."""
        m = np.asarray(effective, dtype=float)
        change = m if self.below is None else self.below.curvature(m)
        for _ in range(8):
            reached, slope = self.with_slope(change)
            change = change - (reached - m) / slope
        return change

    def resampled(self, s: FloatArray, at: FloatArray) -> "CurlingLaw":
        """Return the law at arc lengths `at` (m,), interpolated from arc lengths `s` (n,)."""
        return CurlingLaw(
            self.factor.resampled(s, at), np.interp(at, s, self.designed),
            at_stations(self.natural_curvature, s, at),
            None if self.below is None else self.below.resampled(s, at),
        )  # fmt: skip

    @property
    def injective_limit(self) -> float:
        """Largest curvature, 1/mm, up to which the material law `below` is injective; inf if `below` is None."""
        return float("inf") if self.below is None else self.below.injective_limit


# few Newton steps are enough, because the initial angles are nearly exact
NEWTON_STEPS = 5


def has_even_edges(s: FloatArray, position: FloatArray) -> bool:
    """Return True if all edges of the polygon are as long as the arc length between their nodes."""
    h = np.diff(s)
    # for nodes on a curve, the difference is about (curvature * edge length)^2 / 24
    return bool((np.abs(norm(np.diff(position, axis=0)) - h) <= 1e-7 * h).all())


def integrate_edges(
    s: FloatArray, position: FloatArray, angle: FloatArray, bent: tuple[float, float] | None = None
) -> PlaneCurve:
    """Return the spline, with arc length as its parameter, that follows the edges of a discrete rod.

    The edges of a discrete rod (paper, section 7.1) are tangents of a smooth curve at their midpoints. A curve of
    the same length as the polygon passes the nodes on their inner side, at the distance h^2 |kappa| / 24, with
    edge length h and curvature kappa. The result integrates a quintic spline through the edge angles. Its end
    angles differ from the held angles by h^2 |kappa'| / 8. The smallest smooth changes of angle correct the end
    angles and the end position.

    Parameters
    ----------
    s : (n,) array
        Arc lengths of the nodes, mm, uniform.
    position : (n, 2) array
        Nodes, mm; each edge between two nodes is as long as the difference of their arc lengths.
    angle : (n,) array
        Angles at the nodes, rad; the result has exactly the first and the last angle.
    bent : (float, float), optional
        Arc lengths, mm, between which the rod is bent, by default its ends. Beyond them the result is straight, and
        the held positions and angles of these free ends are not matched.

    Returns
    -------
    PlaneCurve
        Spline of degree 5 whose parameter is arc length, with a relative error of 1e-8.

    Examples
    --------
    >>> s = np.linspace(0.0, 30.0, 61)
    >>> middles = (s[:-1] + s[1:]) / 20
    >>> steps = 0.5 * np.column_stack([np.cos(middles), np.sin(middles)])
    >>> nodes = np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
    >>> curve = integrate_edges(s, nodes, s / 10)
    >>> off = np.hypot(*(curve.at(s).position - nodes).T).max()
    >>> round(curve.length, 7), bool(off < 3 * 0.5**2 / 10 / 24)
    (30.0, True)
    """
    edge = _edge_angles(position, angle)
    if edge.size == 1:
        return PlaneCurve(s.repeat(DEGREE + 1), np.linspace(position[0], position[1], DEGREE + 1), DEGREE)
    length, ends, middles = float(s[-1]), s[[0, -1]], midpoints(s)
    low, high = (0.0, length) if bent is None else bent
    held = np.array([low <= 0.0, high >= length])
    if not held.all():
        # omit the edges next to a straight end, because a discrete rod spreads the force at the joint over them
        inside = (middles > low + s[1] * (not held[0])) & (middles < high - s[1] * (not held[1]))
        middles, edge = middles[inside], edge[inside]
        # the curvature is 0 at the joint, so mirror the angles there
        first, last = (slice(_MIRRORED * (not is_held)) for is_held in held)
        middles = np.concatenate([2 * low - middles[first][::-1], middles, 2 * high - middles[::-1][last]])
        edge = np.concatenate([edge[first][::-1], edge, edge[::-1][last]])
    through = spline_through(middles, edge, min(DEGREE, edge.size - 1))
    x, weight = gauss_rule(6)
    places = (s[:-1, None] + s[1] * (1 + x) / 2).ravel()
    weight, turns, end_turns = (
        np.tile(s[1] / 2 * weight, s.size - 1),
        _angle_corrections(places.clip(low, high) / length),
        _angle_corrections(ends / length)[held],
    )
    places = places.clip(low, high)
    c, gap = np.zeros(turns.shape[1]), np.zeros(2)
    for _ in range(NEWTON_STEPS):
        T = unit_vectors(through(places) + turns @ c)
        gap = position[-1] - position[0] - weight @ T
        rows, missed = [end_turns], [angle[[0, -1]][held] - through(ends[held]) - end_turns @ c]
        if held.all():
            rows.append((weight[:, None] * left_of(T)).T @ turns / length)
            missed.append(gap / length)
        c += np.linalg.lstsq(np.concatenate(rows), np.concatenate(missed), rcond=1e-9)[0]
    return integrate_tangents(
        lambda at: unit_vectors(
            through(at.clip(low, high)) + _angle_corrections(at.clip(low, high) / length) @ c
        ),
        length,
        position[0] + gap * (held[1] and not held[0]),
        tolerance=1e-8,
        breaks=[(joint, 1) for joint in (low, high) if 0.0 < joint < length],
    )


_MIRRORED = 8

# least number of edges of a bent part between straight free ends
_SHORTEST_BENT = 24


def _angle_corrections(x: FloatArray) -> FloatArray:
    """Return 18 functions (n, 18) of x (n,), 0 to 1 along the rod.

    Multiples of them are added to the tangent angle of a curve, so that its ends get given angles and positions.
    """
    # with this exponent, the functions decrease to 0 within an eighth of the length
    y, m = 1 - x, 8
    beside = np.column_stack([y**m * (1 - (m + 2) * x), x**m * (1 - (m + 2) * y)])
    k = np.arange(1, 17)
    return np.concatenate([beside, np.sqrt(k) * np.sin(np.pi * x[:, None] * k)], axis=1)


def _edge_angles(position: FloatArray, angle: FloatArray) -> FloatArray:
    """Return the angles (n,), rad, of edges between nodes (n + 1, 2), within half a turn of the nodal angles."""
    edge = angle_of(np.diff(position, axis=0))
    return np.asarray(edge + 2 * np.pi * np.round((midpoints(angle) - edge) / (2 * np.pi)))


@dataclass(frozen=True, eq=False)
class Rod:
    """Rod in the plane; all arrays contain values at its n nodes.

    Attributes
    ----------
    s : (n,) array
        Arc lengths, mm, in equal steps from 0 to the length.
    position : (n, 2) array
        Positions, mm.
    angle : (n,) array
        Angles of the tangent, rad, continuous along the rod. For a discrete rod (paper, section 7.1) the end
        values are the angles of the supports. The other values are means of the two edges at the node.
    curvature : (n,) array
        Signed curvature kappa, 1/mm; for a discrete rod, moment / stiffness + natural curvature kappa_0.
    stiffness : (n,) array
        Relative stiffness K, dimensionless; its least value is 1.
    moment : (n,) array
        Bending moment M = K (kappa - kappa_0), 1/mm. Multiply by the least bending stiffness (N mm2) to obtain N
        mm.
    force : (n, 2) array
        Force lambda, 1/mm2: the negative of the usual internal force. Multiply by the least bending stiffness
        (N mm2) to obtain N. For a discrete rod, the value at a node is the mean of its two edges. The value
        at the start is the value of the first edge minus the load of the first node. At the end, the load of
        the last node is added.
    profile : Profile
        Stiffness K as a spline of arc length, from which the width of a strip is computed.
    natural_curvature : float or (n,) array
        Natural curvature kappa_0, 1/mm: one value for the whole rod, or values at the nodes.
    gravity, weight, bending_stiffness
        Loads, see `Gravity` and `Weight`; `bending_stiffness` is the least bending stiffness B, N mm2, or None.
    law : MaterialLaw or None
        Law M = K m(kappa - kappa_0) of a nonlinear material (paper, Appendix D). If the section depends on the
        curvature, `bend` adds its effect to the law, and K is the stiffness of the design; see `bending_law`.
    section : Section or None
        Section of the strip, or None for a strip of one sheet that bends with Young's modulus E, not as a plate.
    residual : float
        Largest imbalance of moments, relative to the moments.
    shape : PlaneCurve or None
        Drawn curve of the rod, or None if the rod has none; `curve` is then computed from the nodes.
    check : EquilibriumCheck or None
        Result of the check of Theorem 1 for the drawn curve.
    moved : float
        Distance by which the drawn curve was moved to bring its inflections onto a line, mm.
    warnings : tuple of str
        Warnings about the result.
    between, point_forces : tuple of ElementForce
        Rails, pins and ties, and point forces, with their positions and forces on the strip. The attribute `force`
        jumps by these forces.
    compression : Compression or None
        Axial elasticity of the edges, or None for a rod whose length is constant.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    stiffness: FloatArray
    moment: FloatArray
    force: FloatArray
    profile: Profile
    gravity: Gravity | None = None
    supports: Supports = field(default_factory=Supports)
    natural_curvature: float | FloatArray = 0.0
    residual: float = 0.0
    weight: Weight | None = None
    bending_stiffness: float | None = None
    law: MaterialLaw | None = None
    section: Section | None = None
    shape: PlaneCurve | None = None
    check: "EquilibriumCheck | None" = None
    warnings: tuple[str, ...] = ()
    moved: float = 0.0
    between: tuple[ElementForce, ...] = ()
    point_forces: tuple[ElementForce, ...] = ()
    compression: Compression | None = None

    def __post_init__(self) -> None:
        n = numbers(self.s, "rod s").size
        for name, shape in {
            "s": (n,), "position": (n, 2), "angle": (n,), "curvature": (n,), "stiffness": (n,),
            "moment": (n,), "force": (n, 2),
        }.items():  # fmt: skip
            array = numbers(getattr(self, name), f"rod {name}").copy()
            if array.shape != shape:
                raise InputError(
                    f"`{name}` of the rod has the shape {array.shape}: give numbers of shape {shape}"
                )
            if not np.isfinite(array).all():
                raise InputError(f"`{name}` of the rod is not finite everywhere: give finite numbers")
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        rest = numbers(self.natural_curvature, "natural curvature")
        if rest.size not in (1, n) or not np.isfinite(rest).all():
            raise InputError(
                f"the natural curvature cannot be used: give a finite number, or {n} numbers for the nodes, "
                "in 1/mm"
            )
        if (self.stiffness <= 0).any():
            at = float(self.s[self.stiffness.argmin()])
            raise InputError(
                f"the stiffness of the rod is not positive {Mm(at):.6g} from its start: give every place a "
                "width above 0"
            )

    @classmethod
    def straight(
        cls,
        length: float,
        stiffness: "ArrayLike | Profile" = 1.0,
        *,
        samples: int | None = None,
        start: ArrayLike = (0.0, 0.0),
        angle: float = 0.0,
        gravity: Gravity | None = None,
        supports: Supports | None = None,
        natural_curvature: NaturalCurvature = 0.0,
        weight: Weight | None = None,
        bending_stiffness: float | None = None,
        law: MaterialLaw | None = None,
        section: Section | None = None,
    ) -> "Rod":
        """Return a straight rod, for example as input of `bend`.

        Parameters
        ----------
        length : float
            Length of the rod, mm.
        stiffness : float, (n,) array_like or Profile
            Stiffness: one value, values at n uniform stations, or a profile over [0, length]. The stiffness is
            divided by its least value, because the least stiffness of a rod is 1.
        samples : int, optional
            Number of nodes; by default 601, or the number of nodal values.
        start, angle
            Position of the first end, mm, and angle of the rod, rad.
        gravity, supports, natural_curvature, weight, bending_stiffness, law, section
            As in `optimal_rod`. The stiffness applies while the rod is straight.

        Returns
        -------
        Rod
            Rod whose moments and forces are zero. With gravity it is not in equilibrium, and `residual` is its
            imbalance.

        Examples
        --------
        >>> Rod.straight(100.0, [1, 2, 3]).ratio
        3.0
        """
        require_gravity(gravity)
        supports = require_supports(supports)
        if samples is not None:
            whole_number(samples, "samples", 3)
        if bending_stiffness is not None:
            require_positive(bending_stiffness, "bending stiffness", "N mm2")
        place = pair(start, "start")
        require_positive(length, "rod length")
        require_number(angle, "the angle of a rod", "rad")
        profile, n = _stiffness_profile_of(stiffness, length, samples)
        if not profile.is_positive:
            raise InputError("the stiffness of the rod is not positive everywhere: give numbers above 0")
        s = np.linspace(0.0, length, n)
        profile, K = _scaled_to_least(profile, s)
        tangent = unit_vectors(angle)
        rest = nodal_curvature(natural_curvature, s)
        loaded = gravity is not None or weight is not None or bool(numbers(rest, "natural curvature").any())
        return cls(
            s=s, position=place + s[:, None] * tangent,
            angle=np.full(n, float(angle)), curvature=np.zeros(n), stiffness=K,
            moment=np.zeros(n), force=np.zeros((n, 2)), profile=profile, gravity=gravity,
            supports=supports, natural_curvature=rest, residual=float(loaded), weight=weight,
            bending_stiffness=bending_stiffness, law=law, section=section,
        )  # fmt: skip

    @property
    def length(self) -> float:
        """Length of the rod, mm."""
        return float(self.s[-1])

    @property
    def chord(self) -> FloatArray:
        """Vector (2,), mm, from the start to the end."""
        return np.asarray(self.position[-1] - self.position[0])

    def __repr__(self) -> str:
        carries = "" if self.gravity is None else ", with weight"
        return f"<Rod of {self.length:.4g} mm, ratio {self.ratio:.4g}, {self.s.size} nodes{carries}>"

    def _repr_svg_(self) -> str:
        across = left_of(unit_vectors(self.angle))
        # the band that shows the stiffness is up to 4 % of the length wide
        half = 0.02 * self.length * (self.stiffness / self.stiffness.max())[:, None] * across
        band = np.concatenate([self.position + half, (self.position - half)[::-1]])
        return svg_of_lines([(band, GREY, True), (self.position, BLUE, False)], repr(self))

    def table(self) -> dict[str, FloatArray]:
        """Return columns (n,) of nodal values by name, for a data frame or a file; each name ends in its unit.

        Multiply forces and moments by the least bending stiffness of a strip (N mm2) to obtain N and N mm, as in
        `Strip.table`.
        """
        return {
            "s_mm": self.s, "x_mm": self.position[:, 0], "y_mm": self.position[:, 1], "angle_rad": self.angle,
            "curvature_1_per_mm": self.curvature, "stiffness": self.stiffness, "moment_1_per_mm": self.moment,
            "force_x_1_per_mm2": self.force[:, 0], "force_y_1_per_mm2": self.force[:, 1],
        }  # fmt: skip

    def csv(self) -> str:
        """Return the columns of `table` as comma-separated text with a header."""
        return csv_text(self.table())

    @property
    def ratio(self) -> float:
        """Ratio of the largest to the least stiffness, at the nodes and on the profile between them."""
        low, high = self.profile.extremes
        return float(max(high, self.stiffness.max()) / min(low, self.stiffness.min()))

    @property
    def effective_curvature(self) -> FloatArray:
        """Moment divided by stiffness (n,), 1/mm.

        For a linear material, the value is the change of curvature; for a `law`, the effective curvature.
        """
        change = self.curvature - self.natural_curvature
        return change if self.law is None else self.law.effective_curvature(change)

    @property
    def follows_bend(self) -> bool:
        """True if the stiffness of the section depends on the curvature."""
        return self.section is not None and self.section.follows_bend

    @cached_property
    def bending_law(self) -> MaterialLaw | None:
        """Law M = K m(kappa - kappa_0) of the rod in every shape; see `MaterialLaw`.

        If the stiffness of the section depends on the curvature, K is the stiffness in the present shape, and the
        law includes the change of stiffness.
        """
        law, section, rest = self.law, self.section, self.natural_curvature
        if section is None or not section.follows_bend or isinstance(law, CurlingLaw):
            return law
        here = section.bent(self.curvature - rest, rest)
        B = scale_within(here, self.stiffness, solved=self.bending_stiffness, heavy=self.gravity is not None)
        factor = here.curl(here.parameter(B * self.stiffness))
        return law if factor is None else CurlingLaw(factor, factor(self.curvature), rest, law)

    @property
    def acting(self) -> tuple[ElementForce, ...]:
        """Rails, pins, ties and point forces."""
        return (*self.between, *self.point_forces)

    @property
    def hung(self) -> tuple[ElementForce, ...]:
        """Masses that hang on the rod, as forces divided by the least bending stiffness, 1/mm2."""
        if self.gravity is None or self.weight is None:
            return ()
        unit = np.array([self.gravity.direction]) / (self.bending_stiffness or 1.0)
        masses: tuple[Any, ...] = self.weight.masses
        return tuple(ElementForce(mass, np.array([mass.s]), mass.newtons * unit) for mass in masses)

    @property
    def has_loads(self) -> bool:
        """True if masses hang on the rod, or point forces act on it."""
        return bool(self.point_forces or (self.weight is not None and self.weight.masses))

    @property
    def support_forces(self) -> FloatArray:
        """Forces (2, 2) of the supports on start and end, divided by the least bending stiffness, 1/mm2.

        Forces of rails, pins and ties at the ends are not included.
        """
        return np.array([self.force[0], -self.force[-1]]) - at_ends(self.length, self.acting)

    @property
    def between_forces(self) -> FloatArray:
        """Forces (m, 2) of the m rails, pins and ties, divided by the least bending stiffness, 1/mm2.

        The force of a tie is the force at its start.
        """
        return np.array([action.force[0] for action in self.between]).reshape(-1, 2)

    @property
    def thrust_line(self) -> "tuple[InflectionLine | None, ...]":
        """Sides of the thrust line, in order along the rod.

        Rails, pins, ties and point forces divide the rod into pieces. The side of a piece is its line of zero
        moment, or None if its moment is constant. Neighbouring sides intersect on the line of action of the force
        between their pieces. A rod with weight has no sides, because its internal force turns along each piece.
        """
        from elastica_cad.mechanics.theorem1 import InflectionLine

        if self.gravity is not None:
            return ()
        steps = [
            (float(s), force)
            for action in self.acting
            for s, force in zip(action.s, action.force, strict=True)
            if AT_END_SHARE < s / self.length < 1 - AT_END_SHARE
        ]
        moment, place, b = float(self.moment[0]), self.position[0], -left_of(self.force[0])
        sides = []
        tiny = DUST_SHARE * max(
            float(np.abs(self.force).max()), float(np.abs(self.moment).max()) / self.length
        )
        for s, force in [*sorted(steps, key=lambda step: step[0]), (self.length, np.zeros(2))]:
            sides.append(InflectionLine.of_moment(moment, b, place) if norm(b) > tiny else None)
            at = self.curve.at(np.array([s * self.curve.length / self.length])).position[0]
            moment, place, b = moment + float(b @ (at - place)), at, b - left_of(force)
        return tuple(sides)

    def following(self) -> "Rod":
        """Return the rod with `bending_law` as its law, so that `bend` can change its shape."""
        law = self.bending_law
        return self if law is self.law else replace(self, law=law)

    @property
    def tangent_stiffness(self) -> FloatArray:
        """Stiffness dM/dkappa (n,) against small changes of the curvature.

        The value is `stiffness` if there is no `bending_law`.
        """
        law = self.bending_law
        if law is None:
            return self.stiffness
        return self.stiffness * law.slope(self.curvature - self.natural_curvature)

    @property
    def flat_stiffness(self) -> FloatArray:
        """Relative stiffness (n,) of the sections in the unbent strip."""
        law = self.bending_law
        return self.stiffness / law.designed if isinstance(law, CurlingLaw) else self.stiffness

    @property
    def bending_energy(self) -> float:
        """Elastic energy of bending, 1/mm, relative to the unloaded rod.

        Multiply by the least bending stiffness (N mm2) to obtain N mm.
        """
        change, law = self.curvature - self.natural_curvature, self.bending_law
        density = self.stiffness * (change**2 / 2 if law is None else law.energy(change))
        return float(((density[1:] + density[:-1]) * np.diff(self.s)).sum() / 2)

    def bend_at(self, s: FloatArray) -> FloatArray:
        """Return the change of curvature (n,), 1/mm, at arc lengths s (n,), mm.

        The result is exact if the rod has a drawn curve.
        """
        s = numbers(s, "arc lengths")
        if self.shape is None:
            return Profile.interpolate(self.s, self.curvature - self.natural_curvature)(s)
        curvature = self.shape.curvature_at(self.shape.parameter(np.minimum(s, self.shape.length)))
        return np.asarray(curvature - self.rest_at(s))

    def rest_at(self, s: FloatArray) -> FloatArray:
        """Return the natural curvature (n,), 1/mm, at arc lengths s (n,), mm."""
        rest = np.broadcast_to(np.asarray(self.natural_curvature, dtype=float), self.s.shape)
        return np.asarray(np.interp(numbers(s, "arc lengths"), self.s, rest))

    @property
    def node_lengths(self) -> FloatArray:
        """Voronoi lengths (n,) of the nodes, mm (paper, section 7.1): half the sum of the incident edge lengths."""
        return node_weights(self.length / (self.s.size - 1), self.s.size - 1)

    @property
    def nodal_load(self) -> FloatArray:
        """Weight of each node (n, 2) divided by the least bending stiffness, 1/mm2; zero without gravity."""
        if self.gravity is None:
            return np.zeros_like(self.position)
        down = self.gravity.direction
        if self.weight is None:
            amount = self.node_lengths * self.flat_stiffness / self.gravity.length**3
        else:
            if self.bending_stiffness is None:
                raise InputError(
                    "a rod with weights in newtons needs its least bending stiffness (N mm2): set "
                    "bending_stiffness"
                )
            amount = self.weight.lumped(self.s, self.stiffness, self.node_lengths) / self.bending_stiffness
        return amount[:, None] * down

    @cached_property
    def discrete(self) -> DiscreteRod:
        """Discrete rod for stability, with angles and forces of the edges, and tangent stiffness at the nodes."""
        steps = np.diff(self.position, axis=0)
        apart = steps.any(axis=1)
        if not apart.all():
            at = float(self.s[apart.argmin()])
            raise InputError(
                f"two neighbouring nodes of the rod coincide at {Mm(at):.6g} from its start: remove one of "
                "these nodes"
            )
        angles = _edge_angles(self.position, self.angle)
        load, acting = self.nodal_load, self.acting
        force = edge_forces(np.zeros(2), load)
        nodal = nodal_forces(force, load)
        between = lumped(acting, self.s.size, self.length)
        force += edge_forces(between[0], between)
        for action in acting:
            nodal += np.einsum("nk,kc->nc", self.s[:, None] > action.s, action.force)
        # a rail, pin or tie at a node makes the force there ambiguous, so take the median difference of all nodes
        missing = self.force - nodal
        force += np.median(missing, axis=0) if acting else missing.mean(axis=0)
        slack = slack_elements(self.between, force)
        return DiscreteRod(
            self.tangent_stiffness, angles, force, self.length / angles.size, self.supports, self.position[0],
            bracing=[action for action in self.between if action not in slack] if self.between else None,
            compression=self.compression,
        )  # fmt: skip

    @cached_property
    def curve(self) -> PlaneCurve:
        """Shape as a spline: the drawn curve if it exists, otherwise a spline of degree 5.

        For a discrete rod the spline has the length, end positions and end angles of the rod. Its distance
        from the nodes is about h^2 kappa / 24, with edge length h and curvature kappa (see
        `integrate_edges`). If the nodes are samples of a curve, the spline is a fit. The spline of an axially
        elastic rod is stretched everywhere by its mean strain.
        """
        if self.shape is not None:
            return self.shape
        if self.compression is not None:
            start = self.position[0]
            stretch = norm(np.diff(self.position, axis=0)).sum() / self.length
            even = integrate_edges(
                self.s, start + (self.position - start) / stretch, self.angle, self._bent_part
            )
            return replace(even, control_points=start + (even.control_points - start) * stretch)
        if has_even_edges(self.s, self.position):
            return integrate_edges(self.s, self.position, self.angle, self._bent_part)
        return PlaneCurve(*fit_spline(self.position, 5, 1e-6 * self.length), 5)

    @property
    def _bent_part(self) -> tuple[float, float] | None:
        """Arc lengths, mm, at the ends of the bent part between straight free ends, or None."""
        places = [float(s) for action in self.acting for s in action.s]
        free = [end.is_free for end in self.supports.ends]
        if self.gravity is not None or np.any(self.natural_curvature) or not places or not any(free):
            return None
        low, high = min(places) * free[0], max(places) if free[1] else self.length
        return (low, high) if high - low > _SHORTEST_BENT * (self.length / (self.s.size - 1)) else None

    def with_stiffness(self, stiffness: "ArrayLike | Profile") -> "Rod":
        """Return the rod with another stiffness profile, before `bend` computes its equilibrium.

        `stiffness` contains values (n,) at the nodes, or is a `Profile`. The stiffness is divided by its
        least value. Do not change the stiffness of a wide strip after `bend`, because the law of a bent rod
        applies only to its present widths.
        """
        if not isinstance(stiffness, Profile) and numbers(stiffness, "stiffness").size not in (
            1,
            self.s.size,
        ):
            raise InputError(
                f"`stiffness` has {np.size(stiffness)} values, but the rod has {self.s.size} nodes: give a "
                "value for each node, or a Profile"
            )
        profile, _ = _stiffness_profile_of(stiffness, self.length, self.s.size)
        profile, K = _scaled_to_least(profile, self.s)
        size = np.abs(self.moment).max()
        imbalance = np.abs(K * self.effective_curvature - self.moment).max()
        residual = float(imbalance / size) if size > 0 else float(imbalance > 0)
        return replace(self, stiffness=K, profile=profile, residual=residual)


def require_rod(rod: object, caller: str, source: str = "bend") -> None:
    """Refuse objects that are not a `Rod`. `caller` and `source` are names of functions for the message."""
    if not isinstance(rod, Rod):
        raise InputError(
            f"{caller} was called with {with_article(type(rod))}: give a Rod from optimal_rod or {source}"
        )


def resample(rod: Rod, samples: int) -> Rod:
    """Return the rod with another number of nodes.

    The stiffness is evaluated on the profile, and the other data are interpolated.
    """
    whole_number(samples, "samples", 4)
    s = np.linspace(0.0, rod.length, samples)
    K = _nodal_stiffness(rod.profile, s)
    angle, curvature, moment, *force = (
        np.interp(s, rod.s, row) for row in (rod.angle, rod.curvature, rod.moment, *rod.force.T)
    )
    middles = midpoints(s)
    before = midpoints(rod.s)
    T = unit_vectors(np.interp(middles, before, rod.discrete.angles))
    if rod.compression is not None:
        T *= np.interp(middles, before, norm(rod.discrete.tangents))[:, None]
    return replace(
        rod, s=s, position=edge_positions(rod.position[0], T, s[1]), angle=angle,
        curvature=curvature, stiffness=K / K.min(), profile=rod.profile.scaled(1 / float(K.min())),
        moment=moment, force=np.column_stack(force),
        natural_curvature=at_stations(rod.natural_curvature, rod.s, s),
        law=None if rod.law is None else rod.law.resampled(rod.s, s),
        compression=None if rod.compression is None else rod.compression.resampled(samples - 1),
    )  # fmt: skip


def as_bent(rod: Rod) -> Rod:
    """Return the rod with the stiffness of its sections in the present shape.

    The law of the result is the law of the material, without the effect of the section.
    """
    law = rod.law
    if not isinstance(law, CurlingLaw):
        return rod
    share = law.share(rod.curvature - rod.natural_curvature)
    K, B, design = rod.stiffness * share, rod.bending_stiffness, rod.profile
    least, follow = float(K.min()), Profile.interpolate(rod.s, share)
    profile = Profile.fit(
        lambda s: design(s) * follow(s) / least, rod.length, breaks=design.breaks, knots=design.knots,
        tolerance=1e-6 * float(K.max()) / least,
    )  # fmt: skip
    weight = rod.weight
    if weight is not None:  # a weight in newtons does not change with the stiffness
        alpha, beta = weight.along(rod.s)
        weight = replace(weight, alpha=Profile.interpolate(rod.s, alpha + beta * rod.stiffness), beta=0.0)
    return replace(
        rod, law=law.below, stiffness=K / least, profile=profile, weight=weight, moment=rod.moment / least,
        force=rod.force / least, bending_stiffness=B and B * least,
        compression=None if rod.compression is None else rod.compression.scaled(least),
    )  # fmt: skip


def camber_of(rod: Rod) -> tuple[float, float]:
    """Return the largest distance from the chord and its position, as fractions of the chord.

    The result is the vertex of a parabola through three nodes.
    """
    size, points = float(rod.chord @ rod.chord), rod.position - rod.position[0]
    along, off = points @ rod.chord / size, np.abs(points @ left_of(rod.chord)) / size
    k = int(np.clip(off.argmax(), 1, off.size - 2))
    a, b, c = np.polyfit(along[k - 1 : k + 2] - along[k], off[k - 1 : k + 2], 2)
    return float(c - b**2 / (4 * a)), float(along[k] - b / (2 * a))
