"""Cross-section of two glued layers (paper, section 8.1), narrow or so wide that it bends as a plate."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import EqualByValue, is_number, numbers, require_positive
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.polynomials import gauss_rule
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import Section, SectionLayer, at_stations
from elastica_cad.mechanics.loads import Weight
from elastica_cad.mechanics.section_limits import LIMIT_SLACK, ScaleRange, matched, positive
from elastica_cad.mechanics.sheets import PLAUSIBLE, Sheet

_TOUCH_SHARE = 1e-5
"""Relative tolerance of the limits on stiffness, larger than the error 1e-6 of the stiffness between nodes."""


@dataclass(frozen=True, eq=False)
class LaminatedSection(EqualByValue, Section):
    """Two rectangular layers glued together, with the exact bending stiffness about the common neutral axis.

    The base (width w1, thickness h1) is the outline; the backing (w2 <= w1, h2) adds stiffness, and its width is
    the parameter of the section. Each layer has its own Young's modulus E_i along the strip, because the grain of
    plywood may be parallel or perpendicular to it. The paper's formula (section 8.1) keeps the neutral axis of
    the base, and its stiffness is 12 to 37 % too low at h1/h2 = 1/2. With A_i = E_i w_i h_i and d = (h1 + h2)/2,
    the bending stiffness is

        E I = (A1 h1^2 + A2 h2^2) / 12 + d^2 A1 A2 / (A1 + A2)

    Parameters
    ----------
    base, backing : Sheet
        Sheet of the base, and sheet of the layer that is glued on.
    base_width : float or (n,) array
        Width of the base, mm; set by `on`.
    limits : (float, float)
        Least and largest width of the backing, mm. With a finite largest width, `parameter` clips to the limits.

    Examples
    --------
    >>> card = Sheet("card", 1.0, 12.0, density=600.0, max_strain=0.01)
    >>> section = LaminatedSection(card, card).on(10.0)
    >>> section.bending_stiffness([0.0, 10.0]).round(9).tolist()
    [10.0, 80.0]
    >>> section.parameter(80.0).round(9).item()
    10.0
    """

    quantity = "backing"
    base: Sheet
    backing: Sheet
    base_width: float | FloatArray = 1.0
    limits: tuple[float, float] = (0.0, np.inf)

    def on(self, base_width: ArrayLike) -> "LaminatedSection":
        """Return the section with a base of the given width, mm; a number or (n,)."""
        return replace(self, base_width=positive(base_width, "base width"))

    @property
    def thickness(self) -> float:
        """Whole thickness, mm."""
        return self.base.thickness + self.backing.thickness

    def bending_stiffness(self, backing_width: ArrayLike) -> FloatArray:
        """Return the bending stiffness E I (n,), N mm2, for widths (n,), mm, of the backing."""
        return stack_stiffness(self._stack(*self._widths(backing_width)))

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Return the backing widths (n,), mm, for bending stiffnesses E I (n,), N mm2."""
        EI = positive(bending_stiffness, "bending stiffness")
        if np.isfinite(self.limits[1]):
            EI = EI.clip(*self.bending_stiffness(np.array(self.limits)))
        w1, EI = matched(positive(self.base_width, "base width"), EI)
        least, most = (stack_stiffness(self._stack(w1, w2)) for w2 in (0.0 * w1, w1))
        for bad, text in (
            (
                least * (1 - _TOUCH_SHARE) > EI,
                "less than that of the base alone: narrow the base or increase the stiffness",
            ),
            (
                most * (1 + _TOUCH_SHARE) < EI,
                "more than that of two full layers: widen the base or reduce the stiffness",
            ),
        ):
            if bad.any():
                i = int(bad.argmax())
                raise InputError(
                    f"station {i} (from 0) needs a bending stiffness of {EI.flat[i]:.4g} N mm2, {text}"
                )
        A1 = self.base.youngs_modulus * self.base.thickness * w1
        p, d = self.backing.thickness**2 / 12, self.thickness / 2
        # p x^2 + q x = D A1 for x = E A of the backing, A1 = E A of the base, and the missing stiffness D
        D = np.maximum(EI - least, 0.0)
        q = A1 * (p + d**2) - D
        root = np.sqrt(q**2 + 4 * p * D * A1)
        # avoid cancellation for both signs of q
        safe = np.where(q > 0, q + root, 1.0)
        x = np.where(q > 0, 2 * D * A1 / safe, (root - q) / (2 * p))
        w2 = x / (self.backing.youngs_modulus * self.backing.thickness)
        least_width, largest_width = self.limits
        return w2.clip(least_width, np.minimum(largest_width, w1))

    def stiffening(self, backing_width: ArrayLike) -> FloatArray:
        """Return the derivative (n,) of E I by the width of the backing, N mm; always positive."""
        h = self.backing.thickness
        lever = self.thickness - h / 2 - self.neutral_axis(backing_width)
        return np.asarray(self.backing.youngs_modulus * h * (h**2 / 12 + lever**2))

    def neutral_axis(self, backing_width: ArrayLike) -> FloatArray:
        """Return the height (n,) of the neutral axis above the free face of the base, mm."""
        return _axes_of(self._stack(*self._widths(backing_width)))[-1]

    def layers(self, backing_width: ArrayLike) -> tuple[SectionLayer, SectionLayer]:
        """Return base and backing. The distance for the backing is 0 at stations without a backing."""
        w1, w2 = self._widths(backing_width)
        h1, h2 = self.base.thickness, self.backing.thickness
        axis = self.neutral_axis(w2)
        glue = np.abs(axis - h1)
        inner = np.where(w2 > 0, np.maximum(self.thickness - axis, glue), 0.0)
        return (
            SectionLayer(self.base, h1 * w1, np.maximum(axis, glue)),
            SectionLayer(self.backing, h2 * w2, inner),
        )

    def weight(self, s: ArrayLike, stiffness: ArrayLike, bending_stiffness: float) -> Weight:
        """Return the weight per length alpha(s) + beta(s) K, linearised at the given relative stiffness K.

        Parameters
        ----------
        s : (n,) array_like
            Arc length of the stations, mm.
        stiffness : (n,) array_like
            Relative stiffness K.
        bending_stiffness : float
            E I where K = 1, N mm2.

        Notes
        -----
        `optimal_laminate` alternates this linearisation and the search for an optimal K; together they are Newton's
        method.
        """
        require_positive(bending_stiffness, "bending stiffness", "N mm2")
        K = positive(stiffness, "stiffness")
        w2 = self.parameter(bending_stiffness * K)
        beta = self.backing.specific_weight * self.backing.thickness * bending_stiffness / self.stiffening(w2)
        alpha = self.weight_per_length(w2) - beta * K
        return Weight(alpha=Profile.interpolate(s, alpha), beta=Profile.interpolate(s, beta))

    def scale_range(self, stiffness: ArrayLike, *, least_backing: float = 0.0) -> ScaleRange:
        """Return the scales c for which a laminate of bending stiffness c K can be built (paper, section 8.1).

        K is the relative stiffness. Everywhere the width of the backing is at least `least_backing` and at most
        the width of the base. The bending stiffness is exact, unlike the paper's formula.

        Parameters
        ----------
        stiffness : (n,) array_like
            Relative stiffness K.
        least_backing : float
            Least width of backing that can be cut and glued, mm; on a narrower base, the backing has its full
            width.
        """
        w1 = positive(self.base_width, "base width")
        if not (is_number(least_backing) and least_backing >= 0):
            raise InputError(f"least backing width is {least_backing!r}: give 0 or more, in mm")
        least, most = (stack_stiffness(self._stack(w1, w2)) for w2 in (np.minimum(least_backing, w1), w1))
        return ScaleRange.of(least, most, stiffness)

    def thickness_ratio(self, stiffness: ArrayLike, *, least_backing: float = 0.0) -> float:
        """Return the largest ratio of base thickness to backing thickness that can be built with this base.

        Smaller ratios, with a thicker backing, are possible too. The result is inf if the thinnest
        backing that a sheet can be, a thousandth of a millimetre, is thick enough.
        """
        K = positive(stiffness, "stiffness")

        def feasible(thickness: float) -> bool:
            backing = replace(self.backing, thickness=thickness, thickness_range=None)
            return replace(self, backing=backing).scale_range(K, least_backing=least_backing).feasible

        thin, thick, _ = PLAUSIBLE["thickness_mm"]
        if feasible(thin):
            return float("inf")
        if not feasible(thick):
            raise InputError(
                "a least backing width of {least_backing:g} is too wide for a base {least:.4g} wide and a "
                "stiffness ratio of {given:.4g}, whatever the thickness of the backing: reduce "
                "`least_backing`",
                least_backing=Length(least_backing),
                least=Length(np.min(self.base_width)),
                given=K.max() / K.min(),
            )
        while thick / thin > 1 + 1e-12:
            middle = float(np.sqrt(thin * thick))
            thin, thick = (thin, middle) if feasible(middle) else (middle, thick)
        return self.base.thickness / thick

    def _stack(self, base_width: FloatArray, backing_width: FloatArray) -> list[tuple[Sheet, FloatArray]]:
        return [(self.base, base_width), (self.backing, backing_width)]

    def _widths(self, backing_width: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return the widths of base and backing, mm, in one shape. Refuse a backing wider than the base."""
        w1, w2 = matched(positive(self.base_width, "base width"), numbers(backing_width, "backing width"))
        fits = (w2 >= 0) & (w2 <= w1 * (1 + LIMIT_SLACK))
        if not fits.all():
            i = int(fits.argmin())
            raise InputError(
                "the backing width at station {i} (from 0) is {flat:.6g}: give a width from 0 to the width of the "
                "base, {flat_2:.6g}",
                i=i,
                flat=Length(w2.flat[i]),
                flat_2=Length(w1.flat[i]),
            )
        return w1, w2


def stack_stiffness(layers: Sequence[tuple[Sheet, FloatArray]]) -> FloatArray:
    """Return E I (n,), N mm2, of glued sheets with given widths (n,), mm, about their common neutral axis."""
    axial, middles, axis = _axes_of(layers)
    parts = zip(layers, axial, middles, strict=True)
    return np.asarray(sum(a * (sheet.thickness**2 / 12 + (z - axis) ** 2) for (sheet, _), a, z in parts))


def _axes_of(
    layers: Sequence[tuple[Sheet, FloatArray]],
) -> tuple[list[FloatArray], FloatArray, FloatArray]:
    """Return axial stiffness (n,), N, and middle of each glued sheet, and the height (n,) of the neutral axis."""
    heights = np.array([sheet.thickness for sheet, _ in layers])
    middles = heights.cumsum() - heights / 2
    axial = [sheet.youngs_modulus * sheet.thickness * width for sheet, width in layers]
    axis = sum(a * z for a, z in zip(axial, middles, strict=True)) / sum(axial)
    return axial, middles, np.asarray(axis)


PIECES = 8
"""Number of finite elements in half of the backing, and in each part of the base beside the backing.

With this number, the error of `laminate_factor` is 1e-4.
"""

LEAST_SHARE = 2e-3
"""Least width of the backing and of the base beside it, as a fraction of the width of the base."""

TERMS, STATIONS = 24, 60
"""Numbers of terms of the polynomials in the curvature, and of stations at which the polynomials are computed."""

FINE_SEARLE = 3.0
"""Value of w^2 kappa / h at which the sampling of curvatures changes from uniform to logarithmic.

Here w is the width, kappa the curvature and h the thickness.
"""


def laminate_factor(
    base_width: ArrayLike,
    backing_width: ArrayLike,
    curvature: ArrayLike,
    section: LaminatedSection,
    natural_curvature: ArrayLike = 0.0,
) -> FloatArray:
    """Return M / (E I (kappa - kappa_0)) of a two-layer strip, with the narrower layer in the middle.

    M is the bending moment, E I the bending stiffness of the cross-section, and kappa the uniform curvature.
    Bending stretches or compresses the base beside the backing, because it is away from the neutral axis. The
    stress presses this part of the base towards the neutral axis. The base deflects, so the strip is less stiff
    than E I. The whole cross-section also curls because of Poisson's ratio.

    Parameters
    ----------
    base_width, backing_width, curvature : array_like
        Widths, mm, and curvature, 1/mm; (n,) or numbers. A positive curvature stretches the backing.
    section : LaminatedSection
    natural_curvature : array_like
        Curvature kappa_0 before bending, 1/mm.

    Notes
    -----
    The deflection w(y) across the strip, outward positive, minimises the energy per length. The strip is a plate
    in plane stress that can contract freely. The strain is eps_0 + (kappa - kappa_0) z + kappa w along the strip
    and -z w'' across it, at height z. The finite elements are Hermite cubics on half of the cross-section. For a
    single sheet the result equals `anticlastic_factor`. Curvature that varies within a few widths, and clamps
    that keep the ends flat, are not modelled.
    """
    b1, b2, kappa, rest = (
        np.atleast_1d(value).astype(float)
        for value in np.broadcast_arrays(base_width, backing_width, curvature, natural_curvature)
    )
    b2 = b2.clip(LEAST_SHARE * b1, (1 - LEAST_SHARE) * b1)
    h1, h2 = section.base.thickness, section.backing.thickness
    base, backing = (section.base, -h1 / 2, h1 / 2), (section.backing, h1 / 2, h1 / 2 + h2)
    # unknowns are deflection and strain divided by the change of curvature, finite even if this change is 0
    unknowns = 4 * PIECES + 3
    # indices of the 5 unknowns of each element: deflection and slope at both ends, and eps_0, which all share
    columns = np.column_stack(
        [2 * np.arange(2 * PIECES)[:, None] + np.arange(4), np.full(2 * PIECES, unknowns - 1)]
    )
    H, f = np.zeros((b1.size, unknowns, unknowns)), np.zeros((b1.size, unknowns))
    parts = []
    for layers, half, places in (
        ([base, backing], b2 / 2, columns[:PIECES]),
        ([base], (b1 - b2) / 2, columns[PIECES:]),
    ):
        form, (w, curl, weight) = _energy(layers), _hermite(half / PIECES)
        # strain along the strip, and lever arm of the force along it, for a unit value of each of the 5 unknowns
        w, lever = (np.insert(w * by[:, None, None], 4, 1.0, axis=1) for by in (kappa, kappa - rest))
        curl = np.insert(curl, 4, 0.0, axis=1)
        w_by, curl_by = w * weight[:, None], curl * weight[:, None]
        mixed = form[0, 2] * w_by @ curl.swapaxes(1, 2)
        quadratic = form[0, 0] * w_by @ w.swapaxes(1, 2) + form[2, 2] * curl_by @ curl.swapaxes(1, 2)
        quadratic += mixed + mixed.swapaxes(1, 2)
        linear = (form[0, 1] * w_by + form[1, 2] * curl_by).sum(axis=2)
        for piece in places:
            H[:, piece[:, None], piece] += quadratic
            f[:, piece] += linear
        parts.append((form, w, lever, curl, weight, places))
    free = slice(2, None)  # by symmetry, deflection and slope are zero in the middle
    deflection = np.zeros_like(f)
    deflection[:, free] = -np.linalg.solve(H[:, free, free], f[:, free, None])[..., 0]
    moment = np.zeros(b1.size)
    for form, w, lever, curl, weight, places in parts:
        u, v, c = (deflection[:, places] @ shape for shape in (w, lever, curl))
        along = form[0, 0] * u * v + form[0, 1] * (u + v) + form[1, 1] + (form[0, 2] * v + form[1, 2]) * c
        moment += 2 * (along * weight[:, None]).sum(axis=(1, 2))
    return moment / section.on(b1).bending_stiffness(b2)


def _energy(layers: list[tuple[Sheet, float, float]]) -> FloatArray:
    """Return the quadratic form (3, 3) of twice the energy per area.

    Its variables are strain and curvature along the strip, and curvature across the strip.
    """
    along, coupled = np.zeros(3), np.zeros(3)
    for sheet, low, high in layers:
        Q, nu = sheet.youngs_modulus / (1 - sheet.poisson_ratio**2), sheet.poisson_ratio
        moments = Q * np.array([high - low, (high**2 - low**2) / 2, (high**3 - low**3) / 3])
        along, coupled = along + moments, coupled + nu * moments
    (A, B, D), (An, Bn, Dn) = along, coupled
    rows = [[A, B, -Bn], [B, D, -Dn], [-Bn, -Dn, D]]
    across = np.array([An, Bn, -B])  # at fixed curvatures, the strain across the strip minimises the energy
    return rows - np.outer(across, across) / A


def _hermite(length: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return Hermite cubics and their second derivatives (n, 4, 4) at Gauss points, and the weights (n, 4)."""
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
    """Polynomials that replace `laminate_factor` at the nodes of a strip and are about a hundred times faster.

    Attributes
    ----------
    reach : float
        Largest absolute curvature, 1/mm, of the polynomials. Beyond this curvature, the factor is constant.
    fine : (n,) array
        Curvature, 1/mm, above which the variable of the polynomials is logarithmic: arsinh(curvature / fine).
    coefficients : (m, n) array
        Chebyshev coefficients of the polynomial of each node.

    Examples
    --------
    >>> card = Sheet("card", 0.5, 9000.0, density=600.0, max_strain=0.01, poisson_ratio=0.0)
    >>> curl = LaminateCurl.of(np.zeros(97), 24.0, 12.0, LaminatedSection(card, card))
    >>> bent = np.linspace(-0.04, 0.04, 97)
    >>> exact = laminate_factor(24.0, 12.0, bent, LaminatedSection(card, card))
    >>> bool(np.abs(curl(bent) - exact).max() < 1e-4)
    True
    """

    reach: float
    fine: FloatArray
    coefficients: FloatArray

    @classmethod
    def of(
        cls,
        curvature: FloatArray,
        base_width: ArrayLike,
        backing_width: ArrayLike,
        section: LaminatedSection,
        natural_curvature: ArrayLike = 0.0,
    ) -> "LaminateCurl":
        """Return the polynomials of a laminate with the curvatures `curvature` (n,), 1/mm, in the design."""
        kappa, base, backing, rest = np.broadcast_arrays(
            curvature, base_width, backing_width, natural_curvature
        )
        # no sheet withstands a surface strain of 5 %
        reach = max(2 * 0.05 / section.thickness, 2 * float(np.abs(kappa).max()))
        fine = np.minimum(FINE_SEARLE * section.thickness / base**2, reach)
        nodes = np.arange(kappa.size)
        some = np.unique(np.linspace(0, nodes[-1], STATIONS).round().astype(int))
        t = np.polynomial.chebyshev.chebpts1(TERMS)
        at = np.tile(some, TERMS)
        kappas = fine[at] * np.sinh(t.repeat(some.size) * np.arcsinh(reach / fine[at]))
        factor = laminate_factor(base[at], backing[at], kappas, section, rest[at])
        coefficients = np.linalg.solve(
            np.polynomial.chebyshev.chebvander(t, TERMS - 1), factor.reshape(TERMS, -1)
        )
        return cls(reach, fine, np.array([np.interp(nodes, some, row) for row in coefficients]))

    def resampled(self, s: FloatArray, at: FloatArray) -> "LaminateCurl":
        """Return the polynomials at stations `at` (m,), mm, interpolated from those at stations `s` (n,), mm."""
        fine, coefficients = (at_stations(values, s, at) for values in (self.fine, self.coefficients))
        return LaminateCurl(self.reach, fine, coefficients)

    def __call__(self, curvature: FloatArray) -> FloatArray:
        """Return the factors of the nodes (..., n) for their curvatures (..., n), 1/mm."""
        t = (np.arcsinh(curvature / self.fine) / np.arcsinh(self.reach / self.fine)).clip(-1.0, 1.0)
        return np.asarray(np.polynomial.chebyshev.chebval(t, self.coefficients, tensor=False))
