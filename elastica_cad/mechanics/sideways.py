"""Stability against tipping out of the plane: second variation with twist and bending across the plane."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, require_number
from elastica_cad.errors import InputError, NotConvergedError, note
from elastica_cad.geometry.plane_points import cross, dot, left_of, midpoints, norm, unit_vectors
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bracing import slack_elements
from elastica_cad.mechanics.cross_sections import at_stations
from elastica_cad.mechanics.discrete_rod import (
    Terms,
    largest_of_inverse,
    node_weights,
    orthonormal_rows,
)
from elastica_cad.mechanics.elements import Pin, Rail, edge_weights
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.rod import Rod, require_rod
from elastica_cad.mechanics.sheets import even_shear_ratio

EDGE_LOSS = 0.63
"""Constant 0.63 in the torsional stiffness of a rectangle, G w h^3/3 (1 - 0.63 h/w), by St Venant.

G is the shear modulus, w the width and h the thickness.
"""

LEAST_TORSION = 0.25
"""Least torsional stiffness of a rectangle that is bent about its weak axis, as a fraction of G w h^3/3.

G is the shear modulus, w the width and h the thickness. For a square, the fraction is 0.42.
"""


@dataclass(frozen=True, eq=False)
class SidewaysSection:
    """Cross-sections at equal distances along a strip.

    Stiffnesses are divided by the least bending stiffness of the rod.

    Attributes
    ----------
    width, thickness : (n,) array
        Width, mm, and thickness, mm, of a plate with the same bending and membrane stiffness.
    edgewise, torsion : (n,) array
        Stiffness of bending in the plane of the sheet, and torsional stiffness.
    """

    width: FloatArray
    thickness: FloatArray
    edgewise: FloatArray
    torsion: FloatArray

    @classmethod
    def rectangle(
        cls, stiffness: FloatArray, width: FloatArray, thickness: FloatArray, shear_ratio: float
    ) -> "SidewaysSection":
        """Return the sections of a solid strip.

        `stiffness` (n,) applies to bending in the plane of the curve, and `shear_ratio` is G / E.
        """
        torsion = 4 * shear_ratio * stiffness * _torsion_factor(thickness, width)
        return cls(width, thickness, stiffness * (width / thickness) ** 2, torsion)

    @classmethod
    def perforated(
        cls,
        stiffness: FloatArray,
        width: FloatArray,
        material: FloatArray,
        slope: FloatArray,
        *,
        ligaments: int,
        thickness: float,
        shear_ratio: float,
    ) -> tuple["SidewaysSection", "SidewaysSection"]:
        """Return lower and upper bounds of the stiffnesses of a strip with holes, from energy principles.

        Parameters
        ----------
        stiffness, width, material : (n,) array
            Stiffness of bending in the plane of the curve, width of the outline (mm), and this width minus the
            holes (mm), at every station.
        slope : (n,) array
            Slope tan(theta) of the ligaments relative to the strip.
        ligaments : int
            Number of equal ligaments side by side.
        shear_ratio : float
            Ratio G / E of shear modulus to Young's modulus.

        Notes
        -----
        The lower bound assumes stresses in equilibrium. Every ligament, of width b across the strip, carries its
        part of the load alone. A torque T on the strip is a torque T cos(theta) and a bending moment T sin(theta)
        on the ligament. The torsional stiffness G b h^3/3, for sheet thickness h, is therefore multiplied by
        cos^2 / (cos^2 + 4 G/E sin^2). Edgewise, each ligament has the second moment of area b^3 h/12.

        The upper bound assumes compatible displacements. All ligaments twist equally, with the torsional stiffness
        G t h^3/3 for their total width t. Edgewise, the cross-section remains plane. Its second moment of area is
        at most (W^3 - (W - t)^3) h/12, the value for material at the edges of an outline of width W.
        """
        h = np.full(width.size, thickness)
        cos2 = 1 / (1 + slope**2)
        ligament = material / ligaments
        twist = 4 * shear_ratio * stiffness
        leaning = cos2 / (cos2 + 4 * shear_ratio * (1 - cos2))
        least = cls(
            width,
            h,
            stiffness * cos2**1.5 * (ligament / h) ** 2,
            twist * leaning * _torsion_factor(h, ligament * np.sqrt(cos2)),
        )
        most = cls(width, h, stiffness * (width**3 - (width - material) ** 3) / (material * h**2), twist)
        return least, most

    @classmethod
    def laminated(
        cls,
        stiffness: FloatArray,
        rigidity: float,
        base_width: FloatArray,
        backing_width: FloatArray,
        section: LaminatedSection,
    ) -> "SidewaysSection":
        """Return the sections of two sheets that are glued together.

        Parameters
        ----------
        stiffness : (n,) array
            Relative stiffness K of bending in the plane.
        rigidity : float
            Bending stiffness E I where K = 1, N mm2.
        base_width, backing_width : (n,) array
            Widths of the two sheets, mm.
        section : LaminatedSection

        Notes
        -----
        In free torsion, the net shear flow is zero at every point across the strip, so every point twists about
        its own neutral layer. Beside the backing the torsional stiffness per width is G1 h1^3/3, with shear
        modulus G1 and thickness h1 of the base. On the backing it is 4 (D66 - B66^2/A66), with the stiffnesses A,
        B, D of laminate theory. The result is at least the torsional stiffness of both sheets without glue.
        """
        sheets = section.base, section.backing
        h1, h2 = (sheet.thickness for sheet in sheets)
        # shear and torsional stiffness of each sheet per width
        A1, A2 = (sheet.youngs_modulus * sheet.shear_ratio * sheet.thickness for sheet in sheets)
        D1, D2 = A1 * h1**2 / 3, A2 * h2**2 / 3
        both = D1 + D2 + A1 * A2 / (A1 + A2) * (h1 + h2) ** 2
        base, backing = D1 * _torsion_factor(h1, base_width), D2 * _torsion_factor(h2, backing_width)
        apart = base * base_width + backing * backing_width
        together = base * (base_width - backing_width)
        together += both * backing_width * _torsion_factor(h1 + h2, backing_width)
        E1, E2 = (sheet.youngs_modulus * sheet.thickness for sheet in sheets)
        edgewise, axial = (
            (E1 * base_width**3 + E2 * backing_width**3) / 12,
            E1 * base_width + E2 * backing_width,
        )
        return cls(
            base_width,
            np.sqrt(12 * rigidity * stiffness / axial),
            edgewise / rigidity,
            np.maximum(apart, together) / rigidity,
        )

    @classmethod
    def round(cls, stiffness: FloatArray, diameter: float, shear_ratio: float) -> "SidewaysSection":
        """Return the sections of a round rod or tube; `diameter` is its largest diameter, mm.

        The bending stiffness E I is the same in all directions, and the torsional stiffness is 2 E I G / E.
        """
        size = np.full(stiffness.size, diameter)
        return cls(size, size, stiffness, 2 * shear_ratio * stiffness)


def _checked_shear_ratio(shear_ratio: float | None, poisson_ratio: float) -> float:
    """Return G / E; without `shear_ratio`, that of an isotropic sheet."""
    nu = require_number(poisson_ratio, "poisson_ratio")
    if not -1 < nu < 1:
        raise InputError(
            "poisson_ratio is {poisson_ratio}: give a number between -1 and 1", poisson_ratio=poisson_ratio
        )
    ratio = even_shear_ratio(nu) if shear_ratio is None else require_number(shear_ratio, "shear_ratio")
    if not 0 < ratio < np.inf:
        raise InputError(f"shear_ratio is {shear_ratio}: give the ratio G / E, a number above 0")
    return ratio


def _torsion_factor(thickness: FloatArray | float, width: FloatArray) -> FloatArray:
    """Return the torsional stiffness (n,) of rectangles, divided by G w h^3/3 (shear modulus, width, thickness)."""
    return np.maximum(1 - EDGE_LOSS * thickness / np.maximum(width, 1e-12), LEAST_TORSION)


EDGES = 200
"""Number of edges of the rod whose margin is computed.

The error of the margin is below 1e-3, and with a rail below 5e-3.
"""

SAFE_LOAD = 1.5
"""Least factor by which the forces and moments of a safe strip can grow, at a fixed shape, before it tips over.

The factor covers the uncertainty of the stiffness out of the plane, such as the shear modulus of plywood.
"""

RIBBON_NUMBER = 16.0
"""Largest w^2 b / h, for width w, change of curvature b and thickness h, at which a section keeps its shape.

Above this value, bending and twist are coupled (a ribbon), and a small margin of the rod model is not conclusive.
Finite elements show that ribbons are more stable than the rod model.
"""

MOST_RIBBON_NUMBER = 80.0
"""Largest w^2 b / h (width, change of curvature, thickness) that was compared with finite elements."""

RIBBON_SLENDERNESS = 6.0
"""Least ratio of length to width of a strip; shorter strips are plates."""

_FIRST_STEP = 1e-3
"""First trial for a shift below all eigenvalues of a matrix (n, n), as a fraction of its largest entry over n^2."""


@dataclass(frozen=True)
class SidewaysStability:
    """Result of `sideways_stability`.

    Attributes
    ----------
    margin : float
        Lowest eigenvalue of the second variation for rotations out of the plane, times length^2, if the least
        bending stiffness is 1. Positive means stable. It is limited by the twist of the unloaded strip, so
        margins of different sheets are not comparable.
    overloaded : float
        Margin of the same shape if its forces and moments are multiplied by `SAFE_LOAD`.
    ribbon_number : float
        Largest w^2 b / h along the strip, for width w, change of curvature b and thickness h (`RIBBON_NUMBER`).
    slenderness : float
        Ratio of the length to the largest width.
    most : float or None
        Upper bound of the margin if only bounds of the stiffnesses are known; `margin` is then the lower bound.
    """

    margin: float
    overloaded: float
    ribbon_number: float
    slenderness: float
    most: float | None = None

    @property
    def decided(self) -> bool:
        """True if the margin is conclusive: the strip is slender and its stiffness is known well enough."""
        return self._is_rod and not self._between

    @property
    def _is_rod(self) -> bool:
        if self.slenderness < RIBBON_SLENDERNESS or self.ribbon_number > MOST_RIBBON_NUMBER:
            return False
        # a ribbon is more stable than the rod model, so only a good result of the model is conclusive
        return self.ribbon_number <= RIBBON_NUMBER or self.overloaded > 0

    @property
    def _between(self) -> bool:
        # the bounds of the margin do not decide
        return self.most is not None and self.margin <= 0 < self.most

    @property
    def word(self) -> Literal["unstable", "low", "ample", "undecided"]:
        """Rating of the margin: unstable, low, ample or undecided."""
        if not self.decided:
            return "undecided"
        if self.margin <= 0:
            return "unstable"
        return "ample" if self.overloaded > 0 else "low"

    @property
    def rating(self) -> str:
        """Rating of the margin as shown to users."""
        return {"low": "close to tipping", "ample": "stable"}.get(self.word, self.word)

    @property
    def needs_guiding(self) -> bool:
        """True if the strip tips sideways, or a push may tip it."""
        return self.word in ("unstable", "low")

    def __str__(self) -> str:
        return note(
            "sideways stability: {word}; {meaning}", word=note(self.rating), meaning=note(self.meaning)
        )

    @property
    def meaning(self) -> str:
        """Practical meaning of the margin, in a sentence."""
        if self._is_rod and self._between:
            return (
                "because of its holes, it is uncertain whether the strip tips over sideways: guide it at "
                "the sides, or test a sample"
            )
        return {
            "unstable": "the strip tips over sideways or twists out of its plane: guide it at the sides, or "
            "make it wider",
            "low": "a push from the side can tip the strip over: guide it at the sides",
            "ample": "the strip stays in its plane",
            "undecided": (
                "the strip is too wide for its length and bend, so sideways stability cannot be computed: "
                "test a sample"
            ),
        }[self.word]


def sideways_stability(
    rod: Rod,
    width: Profile | ArrayLike,
    thickness: Profile | ArrayLike,
    *,
    poisson_ratio: float = 0.3,
    shear_ratio: float | None = None,
) -> SidewaysStability:
    """Return the stability of a rectangular strip against tipping out of its plane.

    Every support in the plane also supports the end in space: clamps, hinges and sliders prevent twist and sideways
    displacement. An end without support is free. Gravity acts in the plane.

    Parameters
    ----------
    rod : Rod
        Rod in equilibrium; its stiffness applies to bending in the plane, without the plate effect of wide strips.
    width : Profile, number or (n,) array
        Width of the strip along the rod, mm; values at equal distances.
    thickness : Profile, number or (n,) array
        Thickness of the strip along the rod, mm; values at equal distances.
    poisson_ratio : float
        Poisson's ratio nu; an isotropic sheet has G / E = 1 / (2 (1 + nu)).
    shear_ratio : float, optional
        G / E of a sheet with grain, as in `Sheet.shear_ratio`.

    Notes
    -----
    The strip is a Kirchhoff rod with tangent T and normal N in the plane. A small rotation phi about axes in
    the plane bends the strip edgewise by <phi', N> with the stiffness EI2 = E h w^3/12. The rotation twists the
    strip by <phi', T> with GJ = G w h^3/3 (1 - 0.63 h/w) (St Venant). The moment M does work on the area that
    phi encloses, and the force lambda on the second-order change of the tangent. The second variation is

        int EI2 <phi', N>^2 + GJ <phi', T>^2 - M (phi x phi') + <lambda, N> phi_T phi_N - <lambda, T> phi_N^2 ds

    with the constraint int phi_N ds = 0 if both ends are held. A pin also prevents sideways displacement of its
    point. A taut rail touches the strip across its whole width, so it prevents twist there, but the strip slides
    along it. A cord of pull P and length l adds P / l (w_q - w_p)^2 for the sideways displacements w_p, w_q of
    its two points. The equation includes Prandtl's lateral buckling (M = 2 pi sqrt(EI2 GJ) / L between clamps),
    Michell's buckling of a cantilever, and Euler's buckling.

    The model does not include sections that curl or flatten, clamps that prevent warping, slots, and gravity
    across the plane. The result for wide, strongly bent strips is therefore "undecided".

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> arch = bend(Rod.straight(300.0), end=(200.0, 0.0))
    >>> sideways_stability(arch, 20.0, 0.8).word
    'ample'
    """
    require_rod(rod, "sideways_stability")
    s = stations_of_sideways(rod)
    section = SidewaysSection.rectangle(
        np.interp(s, rod.s, rod.flat_stiffness),
        _sizes(width, s, "strip width"),
        _sizes(thickness, s, "thickness"),
        _checked_shear_ratio(shear_ratio, poisson_ratio),
    )
    return sideways_stability_of(rod, section)


def sideways_stability_of(
    rod: Rod, section: SidewaysSection, most: SidewaysSection | None = None
) -> SidewaysStability:
    """Return the stability of a strip against tipping, for sections at the stations `stations_of_sideways`.

    If only bounds of the section are known, `section` is the lower bound and `most` the upper bound.

    Examples
    --------
    A round rod 4 mm thick.

    >>> from elastica_cad.mechanics.bending import bend
    >>> arch = bend(Rod.straight(300.0), end=(280.0, 0.0))
    >>> section = SidewaysSection.round(np.ones(EDGES + 1), 4.0, 0.38)
    >>> sideways_stability_of(arch, section).decided
    True
    """
    s, w = stations_of_sideways(rod), section.width
    bend = np.abs(np.interp(s, rod.s, rod.curvature - rod.natural_curvature))
    return SidewaysStability(
        margin=sideways_margin(rod, section.edgewise, section.torsion),
        # a decrease of the stiffness has the same effect as an increase of all loads
        overloaded=SAFE_LOAD
        * sideways_margin(rod, section.edgewise / SAFE_LOAD, section.torsion / SAFE_LOAD),
        # sections that are not wider than thick keep their shape
        ribbon_number=float(np.where(w > section.thickness, w**2 * bend / section.thickness, 0.0).max()),
        slenderness=float(rod.length / w.max()),
        most=None if most is None else sideways_margin(rod, most.edgewise, most.torsion),
    )


def stations_of_sideways(rod: Rod) -> FloatArray:
    """Return the arc lengths (n,), mm, at which `sideways_stability_of` needs the sections."""
    return np.linspace(0.0, rod.length, EDGES + 1)


def sideways_margin(rod: Rod, edgewise: FloatArray, torsion: FloatArray) -> float:
    """Return the stability margin of a rod against tipping; it is positive if the rod is stable.

    See `SidewaysStability.margin`. `edgewise` and `torsion` (n,) are the stiffnesses at equal distances, divided by
    the least bending stiffness.

    Examples
    --------
    A straight strip with clamped ends and without load has the margin pi^2 GJ, with the torsional stiffness GJ.

    >>> round(sideways_margin(Rod.straight(100.0), np.full(201, 400.0), np.full(201, 1.5)) / np.pi**2, 3)
    1.5
    """
    n = len(edgewise) - 1
    edge = rod.length / n
    s = np.linspace(0.0, rod.length, n + 1)
    middle = midpoints(s)
    angle = np.interp(middle, rod.s, rod.angle)
    force = at_stations(rod.force.T, rod.s, middle).T
    if rod.acting:  # use means over the edges, because the force jumps
        whole = np.zeros_like(rod.force)
        (rod.discrete.force * rod.discrete.edge_length).cumsum(axis=0, out=whole[1:])
        force = np.diff(at_stations(whole.T, rod.s, s)).T / edge
    free = [end.is_free for end in rod.supports.ends]
    lower_band = _band(angle, np.interp(s, rod.s, rod.angle), force, np.interp(s, rod.s, rod.moment), edge,
                       edgewise, torsion, free)  # fmt: skip
    # per length instead of per edge, and in units of 1 / length^2
    return _lowest(lower_band, *_braces(rod, unit_vectors(angle), free)) / edge * rod.length**2


def _braces(rod: Rod, T: FloatArray, free: list[bool]) -> tuple[FloatArray, FloatArray]:
    """Return the contribution of taut rails, pins and ties to the second variation for rotations out of the plane.

    The vector phi (2 n,) contains the rotations about x and y of every edge; T (n, 2) are the unit tangents. The
    arrays are the rows (k, 2 n) of constraints rows @ phi = 0, and a matrix (r, 2 n) whose product
    terms^t terms is added to the second variation.

    Let w be the displacement out of the plane, with w' = phi_N for the rotation phi and the normal N. Held ends
    (not `free`) and pins have w = 0, rails phi_T = 0. A cord with pull P and length l between p and q adds
    P / l (w_q - w_p)^2 to the second variation. Friction is neglected, so a strip slides along a rail.
    """
    n, edge = len(T), rod.length / len(T)
    N = left_of(T)
    places = [float(end) for end, is_free in zip((0.0, rod.length), free, strict=True) if not is_free]
    rows, terms = [], []
    slack = slack_elements(rod.between, rod.discrete.force)
    taut = [action for action in rod.between if action not in slack]

    def rise(start: float, end: float) -> FloatArray:
        """Return the weights (2 n,) of the rotations in the sideways displacement of `end` relative to `start`."""
        return (edge * (edge_weights(end, edge, n) - edge_weights(start, edge, n))[:, None] * N).ravel()

    for action in taut:
        if isinstance(action.element, Pin):
            places.append(float(action.s[0]))
        elif isinstance(action.element, Rail):
            rows.append((edge * edge_weights(float(action.s[0]), edge, n, 1)[:, None] * T).ravel())
        else:
            chord = np.diff(rod.curve.at(action.s).position, axis=0)[0]
            terms.append(np.sqrt(action.size / norm(chord)) * rise(*action.s.tolist()))
    rows += [rise(places[0], place) for place in places[1:]]
    if rod.between and not places and len(terms) == len(taut):
        # if only cords hold the strip, it can turn as a whole without a change of energy
        rows += list(np.tile(np.eye(2), n))
    return np.array(rows).reshape(-1, 2 * n), np.array(terms).reshape(-1, 2 * n)


def _lowest(lower: FloatArray, rows: FloatArray, terms: FloatArray) -> float:
    """Return the lowest eigenvalue of the matrix with the lower band `lower` (4, n) under `rows` and `terms`."""
    largest, n = float(np.abs(lower).max()), lower.shape[1]
    if not np.isfinite(largest):
        raise NotConvergedError(
            "The stability is undecided, because the computation gives numbers that are not finite. Check "
            "the stiffness and the load of the rod."
        )
    # a shift clearly below the lowest eigenvalue makes the matrix positive definite
    shift, on_diagonal = _FIRST_STEP * largest / n**2, np.eye(len(lower), 1)
    while lapack().dpbtrf(lower + shift * on_diagonal, lower=1)[1]:
        shift *= 2
    shift *= 2
    factor = lapack().dpbtrf(lower + shift * on_diagonal, lower=1)[0]
    theta, _ = largest_of_inverse(
        lambda x: lapack().dpbtrs(factor, x, lower=1)[0], n, orthonormal_rows(rows),
        terms=Terms.of(terms, np.eye(len(terms))),
    )  # fmt: skip
    return float(1 / theta[0] - shift)


def _sizes(width: Profile | ArrayLike, s: FloatArray, name: str) -> FloatArray:
    """Return widths or thicknesses, mm, at stations s. An array has values at equal distances."""
    if isinstance(width, Profile):
        sizes = np.asarray(width(s), dtype=float)
    else:
        values = np.atleast_1d(numbers(width, name))
        if values.ndim != 1 or not values.size:
            raise InputError(
                f"{name} cannot be used: give a finite number, an array of numbers or a Profile, in mm"
            )
        sizes = np.interp(s, np.linspace(0, s[-1], values.size), values)
    if not (np.isfinite(sizes).all() and (sizes > 0).all()):
        raise InputError(f"{name} is not positive everywhere: give numbers above 0, in mm")
    return sizes


def _band(
    angle: FloatArray, nodal_angle: FloatArray, force: FloatArray, moment: FloatArray, edge: float,
    edgewise: FloatArray, torsion: FloatArray, free: list[bool],
) -> FloatArray:  # fmt: skip
    """Return the lower band (4, 2 n) of the second variation for rotations about x and y of each edge."""
    n = angle.size
    weight = node_weights(edge, n)
    T = unit_vectors(nodal_angle)
    N = left_of(T)
    # stiffness matrices (n + 1, 2, 2) of the nodes for differences of the rotations of their edges
    spring = np.einsum("i,ij,ik->ijk", edgewise / weight, N, N) + np.einsum(
        "i,ij,ik->ijk", torsion / weight, T, T
    )
    for node, is_free in zip((0, -1), free, strict=True):
        if is_free:
            spring[node] = 0.0
    t = unit_vectors(angle)
    m = left_of(t)
    along, across = dot(force, t), cross(t, force)
    blocks = spring[:-1] + spring[1:] - edge * along[:, None, None] * m[:, :, None] * m[:, None]
    mixed = t[:, :, None] * m[:, None]
    blocks += edge / 2 * across[:, None, None] * (mixed + mixed.transpose(0, 2, 1))
    # off-diagonal blocks; half of the moment's term is in the block, and half in its transpose
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])
    links = -spring[1:-1] - moment[1:-1, None, None] / 2 * turn
    # lower[k, j] is the entry of column j, k rows below the diagonal
    lower = np.zeros((4, 2 * n))
    lower[0, 0::2], lower[0, 1::2], lower[1, 0::2] = blocks[:, 0, 0], blocks[:, 1, 1], blocks[:, 1, 0]
    # links[i] is in the row of edge i and the column of edge i + 1, so its transpose is in the lower band
    lower[2, 0 : 2 * n - 2 : 2], lower[3, 0 : 2 * n - 2 : 2] = links[:, 0, 0], links[:, 0, 1]
    lower[1, 1 : 2 * n - 2 : 2], lower[2, 1 : 2 * n - 2 : 2] = links[:, 1, 0], links[:, 1, 1]
    return lower
