import numpy as np
import pytest

from elastica_cad import NotConvergedError, PlaneCurve
from elastica_cad.geometry import (
    CollinearInflections,
    EndPositions,
    EndTangents,
    FixedLength,
    InflectionsOnLine,
    least_norm_newton,
)
from elastica_cad.geometry.control_point_constraints import CurvatureAt, PointsOnLine

WAVE = np.array(
    [
        (0, 0),
        (20, 25),
        (45, 30),
        (60, -10),
        (95, -25),
        (120, 10),
        (140, 40),
        (170, 30),
        (190, -10),
        (230, -20),
    ]
)

pytestmark = pytest.mark.core


def curves():
    knots = np.cumsum(np.random.default_rng(2).uniform(0.5, 2, len(WAVE) + 5))
    weights = np.array([1, 2, 1, 0.8, 1, 1.5, 1, 1, 1.2, 1])
    return {
        "clamped": PlaneCurve.spline(WAVE),
        "unclamped": PlaneCurve(knots, WAVE, 4),
        "rational": PlaneCurve(knots, WAVE, 4, weights),
    }


def tracked(curve):
    return np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])


def crossed(curve, level):
    return np.array([z.t for z in curve.curvature_equals(level) if z.kind == "crossing"])


def constraints(curve):
    t = tracked(curve)
    return {
        "ends": EndPositions.of(curve),
        "one end": EndPositions(None, np.array([150.0, 20.0])),
        "tangents": EndTangents.of(curve),
        "length": FixedLength(curve.length),
        "line": InflectionsOnLine(-3.0, np.array([0.6, 0.8]), t),
        "natural": InflectionsOnLine(-3.0, np.array([0.6, 0.8]), crossed(curve, 2e-3), 2e-3),
        "points": PointsOnLine(-3.0, np.array([0.6, 0.8]), np.array(curve.domain)),
        "curvature": CurvatureAt(np.array(curve.domain), 1e-3, 100.0),
        "collinear": CollinearInflections(t),
    }


@pytest.mark.parametrize("kind", ["clamped", "unclamped", "rational"])
@pytest.mark.parametrize(
    "name", ["ends", "one end", "tangents", "length", "line", "natural", "points", "curvature", "collinear"]
)
def test_derivatives_agree_with_finite_differences(kind, name):
    curve = curves()[kind]
    assert tracked(curve).size == 3
    constraint = constraints(curve)[name]
    residual, jacobian = constraint.equations(curve)
    h, q = 1e-4, curve.control_points
    numeric = np.empty_like(jacobian)
    for k, unit in enumerate(np.eye(q.size).reshape(q.size, *q.shape)):
        plus, _ = constraint.equations(curve.with_control_points(q + h * unit))
        minus, _ = constraint.equations(curve.with_control_points(q - h * unit))
        numeric[:, k] = (plus - minus) / (2 * h)
    assert residual.shape == (jacobian.shape[0],)
    np.testing.assert_allclose(jacobian, numeric, atol=2e-6 * np.abs(numeric).max())


@pytest.mark.parametrize("kind", ["clamped", "unclamped", "rational"])
def test_inflections_are_made_collinear_with_ends_tangents_and_length_kept(kind):
    curve = curves()[kind]
    kept = [EndPositions.of(curve), EndTangents.of(curve), FixedLength(curve.length)]
    moved, norms = least_norm_newton(curve, [*kept, CollinearInflections(tracked(curve))])
    a, b, c = moved.evaluate(tracked(moved))
    assert abs((c - a)[0] * (b - a)[1] - (c - a)[1] * (b - a)[0]) / np.hypot(*(c - a)) < 1e-8
    assert moved.length == pytest.approx(curve.length, abs=1e-7)
    ends = np.array(curve.domain)
    np.testing.assert_allclose(moved.evaluate(ends), curve.evaluate(ends), atol=1e-8)
    before, after = curve.evaluate(ends, 1), moved.evaluate(ends, 1)
    np.testing.assert_allclose(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], 0, atol=1e-6)
    assert norms[-1] < 1e-8 < norms[0]
    # quadratic convergence at the end
    assert norms[-1] < 1e-3 * norms[-2]


def test_the_move_is_the_least_to_first_order():
    curve = curves()["clamped"]
    target = EndPositions(None, curve.evaluate(curve.domain[1]) + np.array([1.0, 0.0]))
    moved, _ = least_norm_newton(curve, [target])
    step = moved.control_points - curve.control_points
    # only the last control point acts on the end of a clamped spline
    np.testing.assert_allclose(step[:-1], 0, atol=1e-12)
    np.testing.assert_allclose(step[-1], [1, 0], atol=1e-12)


def test_nothing_to_do():
    curve = curves()["clamped"]
    same, norms = least_norm_newton(curve, [EndPositions.of(curve), FixedLength(curve.length)])
    assert same is curve
    assert len(norms) == 1
    assert least_norm_newton(curve, [])[0] is curve
    two = CollinearInflections(tracked(curve)[:2])
    assert two.equations(curve)[0].size == 0


def test_contradictions_are_reported():
    curve = curves()["clamped"]
    chord = float(np.hypot(*(curve.evaluate(1.0) - curve.evaluate(0.0))))
    with pytest.raises(NotConvergedError, match="leave out one constraint"):
        least_norm_newton(curve, [EndPositions.of(curve), FixedLength(0.9 * chord)])


def test_lost_inflections_are_reported():
    arch = PlaneCurve.spline([(0, 0), (10, 20), (30, 20), (40, 0), (45, -10)])
    with pytest.raises(NotConvergedError, match="inflections instead of 3"):
        CollinearInflections(np.array([0.2, 0.5, 0.8])).equations(arch)
