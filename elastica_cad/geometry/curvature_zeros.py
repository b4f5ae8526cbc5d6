"""Zeros of piecewise polynomials along a curve: zeros of the curvature and crossings with a line.

The curvature has the sign of det(P, P', P'') / w^3 in homogeneous coordinates P = (x w, y w, w), with weight w. The
determinant is a polynomial on every knot span. Therefore no zero is missed between samples, even if two zeros are
very close.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import comb
from typing import Literal, TypeAlias

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.geometry.plane_points import norm, project
from elastica_cad.geometry.polynomials import divide_out_end_root, product, roots, without_end_roots
from elastica_cad.geometry.splines import sampled

ZeroKind: TypeAlias = Literal["crossing", "touch", "end", "jump", "flat"]

_EPS = float(np.finfo(float).eps)

_DEGREE = 11

_FLAT = 1e-7
"""A function is zero on an interval if all its values there are below this fraction of its size."""


# Chebyshev nodes, and the matrices from the values there to Chebyshev and to Bernstein coefficients
_SITES = np.cos(np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1))
_TO_CHEBYSHEV = np.linalg.inv(np.polynomial.chebyshev.chebvander(_SITES, _DEGREE))
_TO_BERNSTEIN = np.linalg.inv(
    [
        [comb(_DEGREE, i) * u**i * (1 - u) ** (_DEGREE - i) for i in range(_DEGREE + 1)]
        for u in (1 + _SITES) / 2
    ]
)


@dataclass(frozen=True)
class ZeroPlace:
    """Zero of a function along a curve, in terms of its parameter.

    Attributes
    ----------
    t, t_end : float
        Parameter of the zero. For an interval in which the function is zero ("flat") they are its start and end.
    kind : str
        "crossing" (the sign changes), "touch" (the sign does not change), "end" (a zero at an end of the curve),
        "jump" (the sign changes by a jump at a knot), or "flat" (zero from t to t_end).
    before, after : int
        Signs of the function before and after the zero; 0 beyond the ends of the curve.
    """

    t: float
    t_end: float
    kind: ZeroKind
    before: int
    after: int


def curvature_zero_places(bezier: FloatArray, edges: FloatArray, smooth: BoolArray) -> tuple[ZeroPlace, ...]:
    """Return all zeros of the curvature of a curve that consists of Bezier pieces.

    Parameters
    ----------
    bezier : (p, degree + 1, 3) array
        Homogeneous control points of the pieces.
    edges : (p + 1,) array
        Parameters of the ends of the p pieces.
    smooth : (p - 1,) bool array
        True for inner edges at which the curvature is continuous.
    """
    bezier = _unit_sized(bezier)
    numerator, noise = _curvature_numerator(bezier)
    flat = _straight_pieces(bezier) | (np.abs(numerator).max(axis=1) <= noise)
    return _places(numerator, noise, flat, smooth, edges)


def line_places(bezier: FloatArray, edges: FloatArray, a: float, b: FloatArray) -> tuple[ZeroPlace, ...]:
    """Return all zeros of a + <b, gamma> along a curve gamma of homogeneous Bezier pieces."""
    terms = bezier * np.array([b[0], b[1], a])
    distance = terms.sum(axis=-1)
    noise = 16 * _EPS * np.abs(terms).sum(axis=-1).max(axis=1)
    extent = float(np.ptp(project(bezier), axis=(0, 1)).max())
    level = 1e-12 * norm(b) * extent * bezier[..., 2].max(axis=1)
    on_line = np.abs(distance).max(axis=1) <= np.maximum(noise, level)
    return _places(distance, noise, on_line, np.ones(edges.size - 2, dtype=bool), edges)


def function_zero_places(
    function: Callable[[FloatArray], FloatArray], edges: FloatArray, smooth: BoolArray, size: float
) -> tuple[ZeroPlace, ...]:
    """Return all zeros along the curve of a function that is smooth between `edges`.

    Each span is halved until a polynomial agrees with the function within rounding errors. All zeros of these
    polynomials are returned, including zeros without a change of sign.

    Parameters
    ----------
    function : callable
        Function of parameters (k,) that returns values (k,); it is not evaluated at edges.
    edges : (p + 1,) array
        Parameters of the ends of the p spans on which the function is smooth.
    smooth : (p - 1,) bool array
        True where the function is continuous across an inner edge.
    size : float
        Typical size of the values, to which tolerances are relative.
    """
    low, high, cuts = edges[:-1], edges[1:], np.zeros(edges.size - 1, dtype=int)
    pieces: list[tuple[FloatArray, FloatArray]] = []
    while low.size:
        values = sampled(function, low[:, None] + (high - low)[:, None] * (1 + _SITES) / 2)
        tail = np.abs(values @ _TO_CHEBYSHEV[-2:].T).max(axis=1)
        largest = np.abs(values).max(axis=1)
        # the polynomial represents the function if its last two coefficients are small, compared with the typical
        # size or with the largest value, whose rounding error may be larger
        followed = tail <= 1e-13 * np.maximum(size, largest)
        # after 12 halvings, errors are rounding errors
        done = followed | (cuts == 12) | (largest <= _FLAT * size)
        pieces.append((low[done], values[done]))
        low, high, cuts = low[~done], high[~done], cuts[~done] + 1
        middle = (low + high) / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
        cuts = np.concatenate([cuts, cuts])
    starts, values = map(np.concatenate, zip(*pieces, strict=True))
    order = starts.argsort()
    starts, values = starts[order], values[order]
    largest = np.abs(values).max(axis=1)
    # smaller coefficients are rounding errors
    flat, noise = largest <= _FLAT * size, 1e-12 * np.maximum(size, largest)
    # where a span was halved, the function is continuous
    joined = np.ones(starts.size - 1, dtype=bool)
    joined[starts.searchsorted(edges[1:-1]) - 1] = smooth
    return _places(values @ _TO_BERNSTEIN.T, noise, flat, joined, np.append(starts, edges[-1]))


def _straight_pieces(bezier: FloatArray) -> BoolArray:
    """Return flags (p,): True for pieces with a curvature below 1e-8, on a curve of extent 1."""
    points = project(bezier)
    x, y = (points - points[:, :1]).transpose(2, 0, 1)
    along, across = x[:, -1:], y[:, -1:]
    length = np.hypot(along, across)
    sagitta = np.abs((y * along - x * across) / np.where(length > 0, length, 1.0))
    sagitta = np.where(length > 1e-12, sagitta, np.hypot(x, y)).max(axis=1)
    # an arc with a sagitta h above a chord of length l has the curvature 8 h / l^2
    return np.asarray(8 * sagitta <= 1e-8 * length[:, 0] ** 2 + 16 * _EPS)


def _unit_sized(bezier: FloatArray) -> FloatArray:
    """Return Bezier pieces in homogeneous coordinates, moved to the origin and scaled to the size 1.

    Their largest weight becomes 1.
    """
    points = project(bezier)
    high, low = points.max(axis=(0, 1)), points.min(axis=(0, 1))
    unit = np.empty_like(bezier)
    unit[..., 2] = bezier[..., 2] / bezier[..., 2].max()
    unit[..., :2] = (points - (high + low) / 2) / float((high - low).max()) * unit[..., 2:]
    return unit


def _curvature_numerator(bezier: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return Bernstein coefficients of D, which has the sign of the curvature, and their rounding errors.

    D = det(A, B - A, A - 2B + C). A, B and C are the points two steps before the end of de Casteljau's algorithm.
    The curvature is (degree - 1)/degree * D * w^3 / |h|^3, with the weight w and the vector h from `hodograph`,
    which is parallel to the velocity.
    """
    centre = bezier[:, :, :2].sum(axis=1) / bezier[:, :, 2:].sum(axis=1)
    step = bezier[:, 1:] - bezier[:, :-1]
    bend = step[:, 1:] - step[:, :-1]
    # equal weights may be replaced by 1, and D is then the cross product of `step` and `bend`
    if np.ptp(bezier[..., 2]) == 0:
        d, e = (v[..., :2].transpose(2, 0, 1) for v in (step[:, :-1], bend))
        first, second = product(d, e[::-1])
        return first - second, _numerator_noise(d, e, centre)
    # homogeneous coordinates x w, y w, w relative to the centre of each piece
    a, d, e = (
        np.stack([*(v[..., :2] - centre[:, None] * v[..., 2:]).transpose(2, 0, 1), v[..., 2]])
        for v in (bezier[:, :-2], step[:, :-1], bend)
    )

    def minor(i: int, j: int) -> FloatArray:
        return product(d[i], e[j]) - product(d[j], e[i])

    value = product(a[2], minor(0, 1)) + product(a[0], minor(1, 2)) + product(a[1], minor(2, 0))
    return value, _numerator_noise(d, e, centre)


def _numerator_noise(d: FloatArray, e: FloatArray, centre: FloatArray) -> FloatArray:
    # rounding errors (p,) of D, from the components d, e (2 or 3, p, n) of its factors
    sizes = np.sqrt((d * d).sum(axis=0).max(axis=1)) + np.sqrt((e * e).sum(axis=0).max(axis=1))
    return np.asarray(8 * _EPS * sizes * (1 + np.abs(centre).max()))


def _places(
    coefficients: FloatArray, noise: FloatArray, flat: BoolArray, smooth: BoolArray, edges: FloatArray
) -> tuple[ZeroPlace, ...]:
    """Return the zeros along a curve of polynomials with Bernstein coefficients (p, n).

    `noise` (p,) are rounding errors. `flat` (p,) marks polynomials that are zero everywhere. `smooth` (p - 1,)
    marks inner edges at which the function is continuous.
    """
    count = flat.size
    # `zero` (p, 2) marks zeros at the start and end of each polynomial, which are divided out
    c, zero = without_end_roots(coefficients, noise, ~flat)
    # a zero at an edge with a continuous function belongs to both polynomials, even if rounding shows it in one
    for i in np.flatnonzero(smooth & ~flat[:-1] & ~flat[1:]).tolist():
        differ = c[i, -1] * c[i + 1, 0] < 0
        if zero[i, 1] != zero[i + 1, 0] or (differ and not zero[i, 1]):
            for j, side in ((i, 1), (i + 1, 0)):
                if not zero[j, side]:
                    c[j] = divide_out_end_root(c[j], at_end=bool(side))
                    zero[j, side] = True
    curved = np.flatnonzero(~flat)
    # local coordinate and sign change of each zero inside a piece; the last list remains empty
    inside: list[list[tuple[float, bool]]] = [[] for _ in edges]
    for root in roots(c[curved], noise[curved]):
        inside[curved[root.piece]].append((root.u, root.crossing))
    signs = np.where(flat[:, None], 0, np.sign(c[:, [0, -1]])).astype(int).tolist()
    # the pieces before and after each edge; beyond the ends of the curve the sign is 0
    before, after = [0, *(sign for _, sign in signs)], [*(sign for sign, _ in signs), 0]
    vanishes = zip([False, *zero[:, 1].tolist()], [*zero[:, 0].tolist(), False], strict=True)
    is_flat = [False, *flat.tolist(), False]
    places: list[ZeroPlace] = []
    for i, (t, vanish) in enumerate(zip(edges.tolist(), vanishes, strict=True)):
        if is_flat[i + 1] and not is_flat[i]:
            last = is_flat.index(False, i + 1) - 1
            places.append(ZeroPlace(t, float(edges[last]), "flat", before[i], after[last]))
        elif not is_flat[i]:
            kind: ZeroKind | None = None
            if before[i] * after[i] < 0:
                kind = "crossing" if all(vanish) else "jump"
            elif any(vanish):
                kind = "touch" if 0 < i < count else "end"
            if kind:
                places.append(ZeroPlace(t, t, kind, before[i], after[i]))
        sign = after[i]
        for u, crossing in inside[i]:
            at, following = t + u * float(edges[i + 1] - edges[i]), -sign if crossing else sign
            places.append(ZeroPlace(at, at, "crossing" if crossing else "touch", sign, following))
            sign = following
    return tuple(places)
