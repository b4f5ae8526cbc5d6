"""The compiled fits of splines and tables of curves beside their twins in Python."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import _native
from elastica_cad.geometry.curves import arc_length, curve_derivatives
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths import profile, spline_table
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.spline_table import SplineTable
from elastica_cad.geometry.polynomials import bernstein, bezier_pieces, fit_function, panel_functions
from elastica_cad.geometry.polynomials.spline_function import SplineFunction
from elastica_cad.geometry.polynomials.spline_spans import SplineSpans
from tests.unit.test_compiled_polynomials import drawn, ellipses
from tests.unit.test_compiled_twins import CLOSE, SEEDS, both, distance

__all__ = ["both"]

DEGREES = (1, 3, 5, 8, 12)
"""Those of the fits that the library makes are 3 to 5."""


@pytest.mark.parametrize("degree", [1, 2, 3, 5, 12, 32])
@pytest.mark.parametrize("seed", SEEDS)
def test_bezier_points_of_spans(both, seed, degree):
    """The same digits, also beside knots that stand together; a blossom has shares whose sum is 1."""
    near = np.sort(np.random.default_rng(seed).uniform(size=(2 * degree, 7)), axis=0)
    near[degree:] += 0.1
    near[: seed % degree] = near[0]
    compiled, plain = both(bezier_pieces, lambda: bezier_pieces.extraction(near))
    np.testing.assert_array_equal(compiled, plain)
    assert np.abs(compiled.sum(axis=2) - 1).max() < CLOSE


@pytest.mark.parametrize("degree", [2, 3, 5, 12, 32])
@pytest.mark.parametrize("seed", SEEDS)
def test_points_of_splines_side_by_side(both, seed, degree):
    """The same digits, at knots and ends too, with weights and without, and however places are stored."""
    rng = np.random.default_rng(seed)
    sizes = rng.integers(degree + 1, degree + 12, 9)
    curves = [PlaneCurve.spline(np.cumsum(rng.uniform(1, 2, (size, 2)), axis=0), degree) for size in sizes]
    turned = np.cumsum(rng.uniform(1, 2, (degree + 1, 2)), axis=0)
    knots = np.repeat([0.0, 1.0], degree + 1)
    curves.append(PlaneCurve(knots, turned, degree, weights=rng.uniform(1, 2, degree + 1)))
    which = rng.integers(0, len(curves), 90)
    u = np.concatenate([rng.uniform(size=60), rng.integers(0, degree + 2, 30) / (degree + 1)])
    compiled, plain = both(spline_table, lambda: SplineTable(curves).motion(which[::-1], u[::-1]))
    np.testing.assert_array_equal(compiled, plain)
    t = [np.dot(curves[k].domain, (1 - v, v)) for k, v in zip(which, u, strict=True)]
    own = [curves[k].evaluate(np.array([place]))[0] for k, place in zip(which, t, strict=True)]
    assert distance(compiled[0][::-1], own) < CLOSE


def test_points_of_a_spline_that_is_not_there(both):
    table = SplineTable([PlaneCurve.line((0, 0), (1, 2))])
    with pytest.raises(IndexError):
        both(spline_table, lambda: table.motion(np.array([1]), np.array([0.5])))


def test_bezier_points_beyond_the_compiled_room(both):
    near = np.linspace(0, 1, 66)[:, None]
    compiled, plain = both(bezier_pieces, lambda: bezier_pieces.extraction(near))
    np.testing.assert_array_equal(compiled, plain)


@pytest.mark.parametrize("left", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_where_places_lie(both, seed, left):
    """At edges on either side, between them, and beyond the ends."""
    rng = np.random.default_rng(seed)
    edges = np.cumsum(rng.uniform(0.1, 3, seed + 2))
    places = np.concatenate([edges, rng.uniform(edges[0] - 1, edges[-1] + 1, 50)])
    spans = bezier_pieces.Spans(seed + 4, edges, np.arange(seed + 1), np.zeros((seed + 1, 4, 4)))
    (index, u), plain = both(bezier_pieces, lambda: spans.locate(places, left=left))
    np.testing.assert_array_equal(index, plain[0])
    assert distance(u, plain[1]) < CLOSE
    (panel, x), plain = both(panel_functions, lambda: panel_functions.locate_in_panels(edges, places))
    np.testing.assert_array_equal(panel, plain[0])
    assert distance(x, plain[1]) < CLOSE


@pytest.mark.parametrize("columns", [(), (2,)])
@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("seed", range(4))
def test_fits_of_functions(both, seed, degree, columns):
    """Two splines side by side, the first with a kink and a jump, that are refined until they follow."""
    rng = np.random.default_rng(seed)
    waves, phases = rng.uniform(1, 9, columns), rng.uniform(0, 6, columns)

    def function(x):
        x = x.reshape(-1, *(1,) * len(columns))
        return np.sin(waves * x + phases) + np.abs(x - 0.5) + (x > 0.8)

    tolerance = 1e-4 if degree == 1 else 1e-6
    asked = {"degree": degree, "tolerance": tolerance, "breaks": [(0.5, 0), (0.8, -1)]}
    compiled, plain = both(
        fit_function,
        lambda: fit_function.adaptive_splines(function, [(0.0, 1.0), (1.0, 1.7)], **asked),
    )
    for (knots, coefficients), (plain_knots, plain_coefficients) in zip(compiled, plain, strict=True):
        np.testing.assert_array_equal(knots, plain_knots)
        assert coefficients.shape == plain_coefficients.shape
        x = np.linspace(knots[0], knots[-1], 101)
        values = SplineFunction.of(knots, coefficients, degree)(x)
        assert distance(values, SplineFunction.of(knots, plain_coefficients, degree)(x)) < CLOSE
        if degree < 8:  # beyond, B-splines are so alike that rounding tells their shares apart no better
            assert distance(coefficients, plain_coefficients) < CLOSE


def test_a_span_without_a_place_is_told_by_both(both):
    """One so narrow that no place in it has any weight."""
    spans = SplineSpans(np.zeros(1), np.array([5e-324]), np.zeros(1, dtype=int), np.array([4]), 3)
    samples = np.ones((1, 14))

    def fitted():
        with pytest.raises(np.linalg.LinAlgError) as told:
            fit_function._fitted(spans, samples)
        return str(told.value)

    compiled, plain = both(fit_function, fitted)
    assert compiled == plain


@pytest.mark.parametrize("curve", [drawn, ellipses])
@pytest.mark.parametrize("seed", SEEDS)
def test_derivatives_piece_by_piece(both, seed, curve):
    compiled, plain = both(curve_derivatives, lambda: curve(seed)._pieces._series)
    assert compiled.shape == plain.shape
    assert distance(compiled, plain) < CLOSE


@pytest.mark.parametrize("left", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_derivatives_on_either_side_of_knots(both, seed, left):
    """Of a cubic whose knots are double, so that its second derivative jumps there."""
    points = np.cumsum(np.random.default_rng(seed).uniform(1, 9, (8, 2)), axis=0) + 1e4
    knots = np.array([0.0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 3, 3])

    def asked():
        return PlaneCurve(knots, points, 3)._pieces.at(np.linspace(0, 3, 13), 3, left=left)

    compiled, plain = both(curve_derivatives, asked)
    for one, other in zip(compiled, plain, strict=True):
        assert distance(one, other) < CLOSE
    _, _, beyond, _ = PlaneCurve(knots, points, 3)._pieces.at(np.array([1.0]), 3, left=not left)
    assert np.abs(compiled[2][4] - beyond[0]).max() > 0.01


@pytest.mark.parametrize("seed", SEEDS)
def test_where_newtons_method_starts(both, seed):
    table = drawn(seed)._pieces.arc_length
    (meets, cubics), plain = both(arc_length, lambda: replace(table)._inverse)
    assert distance(meets, plain[0]) < CLOSE
    assert distance(cubics[:, 1], plain[1][:, 1]) < CLOSE
    assert np.abs(cubics[:, 2:] - plain[1][:, 2:]).max() < CLOSE  # places from -1 to 1


@pytest.mark.parametrize("seed", range(40))
def test_extremes_of_cubic_profiles(both, seed):
    """The same extremes in the same places, at knots, between them, and of what is even throughout."""
    rng = np.random.default_rng(seed)
    knots = np.concatenate([[0.0] * 4, np.sort(rng.uniform(0, 9, seed % 7)), [9.0] * 4])
    heights = rng.integers(0, 3, knots.size - 4) if seed % 2 else rng.normal(size=knots.size - 4)

    def asked():
        one = Profile(knots, heights.astype(float))
        return *one.extremes, *one.extreme_places, one(np.array(one.extreme_places))

    (low, high, first, second, there), plain = both(profile, asked)
    assert (low, high) == pytest.approx(plain[:2], abs=CLOSE)
    assert there == pytest.approx([low, high], abs=CLOSE)
    assert (first, second) == pytest.approx(plain[2:4], abs=1e-6)  # flat there: only the value is sharp


@pytest.mark.parametrize("degree", [1, 3, 8, 20])
@pytest.mark.parametrize("seed", SEEDS)
def test_zeros_of_polynomials(both, seed, degree):
    """As many, in the same places, of polynomials some of which touch zero or cross it at a triple place."""
    rng = np.random.default_rng(seed)
    c = rng.normal(size=(int(rng.integers(1, 9)), degree + 1))
    if degree == 8:
        place = rng.uniform(0.2, 0.8)
        shifted = np.array([-place, 1 - place])
        power = shifted
        for _ in range(1 + seed % 2):
            power = bernstein.product(power, shifted)
        c[0] = bernstein.product(power, np.ones(9 - power.size + 1))
    noise = 32 * 2.2e-16 * np.abs(c).max(axis=1)
    found, plain = both(bernstein, lambda: bernstein.roots(c, noise))
    assert [(r.piece, r.crossing) for r in found] == [(r.piece, r.crossing) for r in plain]
    assert distance([r.u for r in found], [r.u for r in plain]) < 1e-10


@pytest.mark.parametrize("share", [0.5, 0.3, 0.8123])
def test_a_triple_zero_is_sharp(both, share):
    """Its value is rounding over a thousandth of a percent of the interval, its second derivative is not."""
    line = np.array([-share, 1 - share])
    c = bernstein.product(bernstein.product(line, line), bernstein.product(line, np.array([1.0, 1.3, 2.0])))
    for found in both(bernstein, lambda: bernstein.interior_roots(c[None])):
        (root,) = found
        assert root.crossing
        assert root.u == pytest.approx(share, abs=1e-9)


def test_polynomials_beyond_the_compiled_room(both):
    c = np.random.default_rng(3).normal(size=(2, 40))
    found, plain = both(bernstein, lambda: bernstein.roots(c, np.full(2, 1e-14)))
    assert found == plain


def test_control_points_outside_their_array_are_refused():
    size, out = 4, np.empty((1, 4, 8))
    pieces = np.array([1]), np.ones((4, 3)), np.eye(size)[None], np.ones(1), np.zeros((1, 2))
    raised = curve_derivatives._all_raised(3)
    with pytest.raises(IndexError):
        _native.kernels.derivative_series((3, 2), pieces, raised, out)
