"""How a two-layer strip curls across, and how much softer or stiffer than E I that makes it."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.polynomials.panel_functions import gauss_rule
from elastica_cad.mechanics.material.laminated_section import LaminatedSection
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import at_stations

PIECES = 8
"""Of half the backing and of the border beside it: the factor is then right to 1e-4."""

LEAST_SHARE = 2e-3
"""Of the width: no border and no backing is counted as narrower."""

BENDS = (0.1, 1.4)
"""Of its bend by design, between which a node may be bent otherwise: under a plate it keeps an eighth of it."""

ROOM_SHARE = 0.15
"""Of the largest bend: room beyond that, for inflections that move."""

TERMS, EVERY = 8, 4
"""Of the polynomials in curvature, and of the nodes one in so many that they are found at."""

TERMS_EVERYWHERE, STATIONS = 24, 60
"""Of the polynomials for all that a strip may be bent to, and the stations that they are found at, about."""

LARGEST_STRAIN = 0.05
"""Of a skin, to which a strip may be bent: beyond what any sheet bears."""

FINE_SEARLE = 3.0
"""Width^2 kappa / thickness up to which the factor follows the bend evenly; beyond, with the logarithm of that."""


def laminate_factor(
    base_width: ArrayLike,
    backing_width: ArrayLike,
    curvature: ArrayLike,
    section: LaminatedSection,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """M / (E I (kappa - kappa_0)) of a strip of two layers, the narrower in the middle, bent to an even curvature.

    The borders of the base lie off the neutral axis and carry stress along the bend, which presses them towards
    that axis: they give way, and the strip is softer than its section. Poisson's ratio lets the whole curl too.

    Parameters
    ----------
    base_width, backing_width, curvature : array_like
        (n,) or numbers, mm and 1/mm; the curvature is positive where the backing is stretched.
    section : LaminatedSection
    natural_curvature : array_like
        kappa_0, before it is bent, 1/mm.

    Returns
    -------
    (n,) array

    Notes
    -----
    Least energy, per length, of the deflection w(y) across the strip, outward positive: a plate in plane stress,
    free to contract, with the strain eps_0 + (kappa - kappa_0) z + kappa w along the strip and -z w'' across;
    Hermite cubics on half of the section. For one sheet it is `anticlastic_factor`. Curvature that varies within a
    few widths, and clamps that keep the ends flat, are outside of it.

    Examples
    --------
    >>> card = Sheet("card", 0.5, 9000.0, density=600.0, max_strain=0.01, poisson_ratio=0.0)
    >>> laminate_factor(24.0, 12.0, [1e-4, 0.01], LaminatedSection(card, card)).round(3).tolist()
    [1.0, 0.91]
    """
    b1, b2, kappa, rest = (
        np.atleast_1d(value).astype(float)
        for value in np.broadcast_arrays(base_width, backing_width, curvature, natural_curvature)
    )
    b2 = np.clip(b2, LEAST_SHARE * b1, (1 - LEAST_SHARE) * b1)
    h1, h2 = section.base.thickness, section.backing.thickness
    base, backing = (section.base, -h1 / 2, h1 / 2), (section.backing, h1 / 2, h1 / 2 + h2)
    # over kappa - kappa_0, which leaves them finite where that vanishes: w and its slopes, and eps_0
    unknowns = 4 * PIECES + 3
    own = np.column_stack(
        [2 * np.arange(2 * PIECES)[:, None] + np.arange(4), np.full(2 * PIECES, unknowns - 1)]
    )
    H, f = np.zeros((b1.size, unknowns, unknowns)), np.zeros((b1.size, unknowns))
    parts = []
    for layers, half, places in (
        ([base, backing], b2 / 2, own[:PIECES]),
        ([base], (b1 - b2) / 2, own[PIECES:]),
    ):
        form, (w, curl, weight) = _energy(layers), _hermite(half / PIECES)  # all pieces of a part are alike
        w, lever = (
            np.concatenate([w * by[:, None, None], np.ones_like(w[:, :1])], axis=1)
            for by in (kappa, kappa - rest)
        )
        curl = np.concatenate([curl, np.zeros_like(curl[:, :1])], axis=1)
        w_by, curl_by = w * weight[:, None], curl * weight[:, None]
        mixed = form[0, 2] * w_by @ np.swapaxes(curl, 1, 2)
        quadratic = form[0, 0] * w_by @ np.swapaxes(w, 1, 2) + form[2, 2] * curl_by @ np.swapaxes(curl, 1, 2)
        quadratic += mixed + np.swapaxes(mixed, 1, 2)
        linear = np.sum(form[0, 1] * w_by + form[1, 2] * curl_by, axis=2)
        for piece in places:
            H[:, piece[:, None], piece] += quadratic
            f[:, piece] += linear
        parts.append((form, w, lever, curl, weight, places))
    free = slice(2, None)  # deflection and slope in the middle are none
    deflection = np.zeros_like(f)
    deflection[:, free] = -np.linalg.solve(H[:, free, free], f[:, free, None])[..., 0]
    moment = np.zeros(b1.size)
    for form, w, lever, curl, weight, places in parts:
        u, v, c = (deflection[:, places] @ shape for shape in (w, lever, curl))
        along = form[0, 0] * u * v + form[0, 1] * (u + v) + form[1, 1] + (form[0, 2] * v + form[1, 2]) * c
        moment += 2 * np.sum(along * weight[:, None], axis=(1, 2))
    return np.asarray(moment / section.bending_stiffness(b1, b2))


def _energy(layers: list[tuple[Sheet, float, float]]) -> FloatArray:
    """Twice the energy per area as a form (3, 3) in strain and curvature along the strip, and w''."""
    along, coupled = np.zeros(3), np.zeros(3)
    for sheet, low, high in layers:
        Q, nu = sheet.youngs_modulus / (1 - sheet.poisson_ratio**2), sheet.poisson_ratio
        moments = Q * np.array([high - low, (high**2 - low**2) / 2, (high**3 - low**3) / 3])
        along, coupled = along + moments, coupled + nu * moments
    (A, B, D), (An, Bn, Dn) = along, coupled
    rows = [[A, B, -Bn], [B, D, -Dn], [-Bn, -Dn, D]]
    across = np.array([An, Bn, -B])  # the strain across, which costs A, is what costs least
    return np.asarray(rows - np.outer(across, across) / A)


def _hermite(length: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Cubics and their second derivatives (n, 4, 4) at Gauss points of elements (n,) long, and weights (n, 4)."""
    x, weight = gauss_rule(4)
    t, ones, long = (x + 1) / 2, np.ones((length.size, 1)), length[:, None]
    values = np.stack(
        [ones * (1 - 3 * t**2 + 2 * t**3), long * (t - 2 * t**2 + t**3), ones * (3 * t**2 - 2 * t**3),
         long * (t**3 - t**2)], axis=1,
    )  # fmt: skip
    bends = np.stack(
        [(12 * t - 6) / long**2, (6 * t - 4) / long, (6 - 12 * t) / long**2, (6 * t - 2) / long], axis=1
    )
    return values, bends, long * weight / 2


@dataclass(frozen=True, eq=False)
class LaminateCurl:
    """`laminate_factor` at the nodes of a strip near its design, as polynomials that cost a hundredth of the time.

    Attributes
    ----------
    middle, reach : (n,) arrays
        The curvatures of each node that are told apart, middle +- reach, 1/mm; beyond them the factor stays.
    coefficients : (m, n) array
        Of Chebyshev polynomials over them.
    fine : (n,) array, optional
        Distance from the middle, 1/mm, beyond which places are told apart by its logarithm (by arsinh).

    Examples
    --------
    >>> card = Sheet("card", 0.5, 9000.0, density=600.0, max_strain=0.01, poisson_ratio=0.0)
    >>> kappa = np.linspace(0.005, 0.01, 97)
    >>> curl = LaminateCurl.about(kappa, 24.0, 12.0, LaminatedSection(card, card))
    >>> bent = 1.1 * kappa
    >>> exact = laminate_factor(24.0, 12.0, bent, LaminatedSection(card, card))
    >>> bool(np.abs(curl(bent) - exact).max() < 1e-4)
    True
    """

    middle: FloatArray
    reach: FloatArray
    coefficients: FloatArray
    fine: FloatArray | None = None

    @classmethod
    def about(
        cls,
        curvature: FloatArray,
        base_width: ArrayLike,
        backing_width: ArrayLike,
        section: LaminatedSection,
        natural_curvature: ArrayLike = 0.0,
    ) -> "LaminateCurl":
        """About the curvature (n,) of a design, 1/mm, at even stations; the rest as of `laminate_factor`."""
        kappa, base, backing, rest = np.broadcast_arrays(
            curvature, base_width, backing_width, natural_curvature
        )
        bend = kappa - rest
        ends = rest + np.multiply.outer(BENDS, bend)
        middle, reach = ends.mean(axis=0), np.abs(ends[1] - ends[0]) / 2 + ROOM_SHARE * np.abs(bend).max()
        return cls(middle, reach, np.empty((TERMS, 0)))._found(base, backing, section, rest, EVERY)

    @classmethod
    def everywhere(
        cls,
        curvature: FloatArray,
        base_width: ArrayLike,
        backing_width: ArrayLike,
        section: LaminatedSection,
        natural_curvature: ArrayLike = 0.0,
    ) -> "LaminateCurl":
        """For all that a strip of the design may be bent to, whatever the curvature (n,) of this, 1/mm.

        Examples
        --------
        >>> card = Sheet("card", 0.5, 9000.0, density=600.0, max_strain=0.01, poisson_ratio=0.0)
        >>> curl = LaminateCurl.everywhere(np.zeros(97), 24.0, 12.0, LaminatedSection(card, card))
        >>> bent = np.linspace(-0.04, 0.04, 97)
        >>> exact = laminate_factor(24.0, 12.0, bent, LaminatedSection(card, card))
        >>> bool(np.abs(curl(bent) - exact).max() < 1e-4)
        True
        """
        kappa, base, backing, rest = np.broadcast_arrays(
            curvature, base_width, backing_width, natural_curvature
        )
        thickness = section.base.thickness + section.backing.thickness
        reach = np.full(kappa.size, max(2 * LARGEST_STRAIN / thickness, 2 * float(np.abs(kappa).max())))
        fine = np.minimum(FINE_SEARLE * thickness / base**2, reach)
        empty = cls(np.zeros(kappa.size), reach, np.empty((TERMS_EVERYWHERE, 0)), fine)
        return empty._found(base, backing, section, rest, max(EVERY, kappa.size // STATIONS))

    def _found(
        self, base: FloatArray, backing: FloatArray, section: LaminatedSection, rest: FloatArray, every: int
    ) -> "LaminateCurl":
        """With coefficients, from the factor at one in `every` of the nodes."""
        terms, nodes = self.coefficients.shape[0], np.arange(self.middle.size)
        some = np.unique(np.append(nodes[::every], nodes[-1]))
        t = np.cos(np.pi * (np.arange(terms) + 0.5) / terms)
        at = np.tile(some, terms)
        away = self.reach[at] * np.repeat(t, some.size)
        if self.fine is not None:
            fine = self.fine[at]
            away = fine * np.sinh(np.repeat(t, some.size) * np.arcsinh(self.reach[at] / fine))
        factor = laminate_factor(base[at], backing[at], self.middle[at] + away, section, rest[at])
        known = np.linalg.solve(np.polynomial.chebyshev.chebvander(t, terms - 1), factor.reshape(terms, -1))
        return replace(self, coefficients=np.array([np.interp(nodes, some, row) for row in known]))

    def resampled(self, s: FloatArray, at: FloatArray) -> "LaminateCurl":
        """The same at stations (m,), mm, of what has it at `s` (n,)."""
        middle, reach, coefficients = (
            np.asarray(at_stations(values, s, at)) for values in (self.middle, self.reach, self.coefficients)
        )
        fine = None if self.fine is None else np.interp(at, s, self.fine)
        return LaminateCurl(middle, reach, coefficients, fine)

    def __call__(self, curvature: FloatArray) -> FloatArray:
        """The factor of the nodes (..., n) at their curvatures (..., n), 1/mm."""
        away, reach = curvature - self.middle, np.where(self.reach == 0, 1.0, self.reach)
        if self.fine is not None:
            away, reach = np.arcsinh(away / self.fine), np.arcsinh(reach / self.fine)
        t = np.clip(away / reach, -1.0, 1.0)
        return np.asarray(np.polynomial.chebyshev.chebval(t, self.coefficients, tensor=False))
