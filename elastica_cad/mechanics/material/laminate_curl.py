"""How a two-layer strip curls across, and how much softer or stiffer than E I that makes it."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.mechanics.material.laminated_section import LaminatedSection
from elastica_cad.mechanics.material.sheet import Sheet

PIECES = 8
"""Of half the backing and of the border beside it: the factor is then right to 1e-4."""

LEAST_SHARE = 2e-3
"""Of the width: no border and no backing is counted as narrower."""


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
    share = np.linspace(0.0, 1.0, PIECES + 1)
    edges = np.hstack([b2[:, None] * share, b2[:, None] + (b1 - b2)[:, None] * share[1:]]) / 2
    # over kappa - kappa_0, which leaves them finite where that vanishes: w and its slopes, and eps_0
    unknowns = 2 * edges.shape[1] + 1
    H, f = np.zeros((b1.size, unknowns, unknowns)), np.zeros((b1.size, unknowns))
    elements = []
    for e in range(2 * PIECES):
        form = _energy([base, backing] if e < PIECES else [base])
        w, curl, weight = _hermite(edges[:, e + 1] - edges[:, e])
        w, lever = (
            np.concatenate([w * by[:, None, None], np.ones_like(w[:, :1])], axis=1)
            for by in (kappa, kappa - rest)
        )
        curl = np.concatenate([curl, np.zeros_like(curl[:, :1])], axis=1)
        both, own = np.concatenate([w, curl], axis=2), np.append(np.arange(2 * e, 2 * e + 4), unknowns - 1)
        twice = np.tile(weight, 2)
        quadratic = np.einsum("nig,njg,ng->nij", both * np.repeat([form[0, 0], form[2, 2]], 4), both, twice)
        mixed = form[0, 2] * np.einsum("nig,njg,ng->nij", w, curl, weight)
        H[:, own[:, None], own] += quadratic + mixed + np.swapaxes(mixed, 1, 2)
        f[:, own] += np.einsum("nig,ng->ni", form[0, 1] * w + form[1, 2] * curl, weight)
        elements.append((form, w, lever, curl, weight, own))
    free = np.arange(2, unknowns)  # deflection and slope in the middle are none
    deflection = np.zeros_like(f)
    deflection[:, free] = -np.linalg.solve(H[:, free[:, None], free], f[:, free, None])[..., 0]
    moment = np.zeros(b1.size)
    for form, w, lever, curl, weight, own in elements:
        u, v, c = (np.einsum("nig,ni->ng", shape, deflection[:, own]) for shape in (w, lever, curl))
        along = form[0, 0] * u * v + form[0, 1] * (u + v) + form[1, 1] + (form[0, 2] * v + form[1, 2]) * c
        moment += 2 * np.sum(along * weight, axis=1)
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
    x, weight = np.polynomial.legendre.leggauss(4)
    t, ones, long = (x + 1) / 2, np.ones((length.size, 1)), length[:, None]
    values = np.stack(
        [ones * (1 - 3 * t**2 + 2 * t**3), long * (t - 2 * t**2 + t**3), ones * (3 * t**2 - 2 * t**3),
         long * (t**3 - t**2)], axis=1,
    )  # fmt: skip
    bends = np.stack(
        [(12 * t - 6) / long**2, (6 * t - 4) / long, (6 - 12 * t) / long**2, (6 * t - 2) / long], axis=1
    )
    return values, bends, long * weight / 2
