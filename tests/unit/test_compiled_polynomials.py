"""The compiled sums of polynomials, arc lengths and small linear programs beside their twins in Python."""

import numpy as np
import pytest

from elastica_cad import _native
from elastica_cad.geometry.curves import arc_length, curve_derivatives, tangent_angle
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials import bernstein, panel_functions
from elastica_cad.geometry.polynomials.panel_functions import ORDER, PanelFunction, legendre_basis
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature
from elastica_cad.mechanics.stiffness import quadrature_panels, vertex_exchange
from elastica_cad.mechanics.stiffness.quadrature_panels import cut_into_panels
from elastica_cad.mechanics.stiffness.vertex_exchange import VertexExchange
from tests.unit.test_compiled_twins import CLOSE, SEEDS, both, distance

__all__ = ["both"]


def drawn(seed, degree=None):
    """A spline through random points."""
    rng = np.random.default_rng(seed)
    points = np.cumsum(rng.uniform(5, 40, (int(rng.integers(4, 12)), 2)) * (1, rng.choice([-1, 1])), axis=0)
    points[:, 1] += rng.normal(size=len(points)) * 20
    return PlaneCurve.spline(points, degree=degree or int(rng.integers(2, 6)))


def ellipses(seed):
    """A rational curve, in mm far from its origin."""
    return PlaneCurve.ellipse((1e4 * seed, 0), (30.0 + seed, 80.0), start=0.1, end=2.0 + seed / 4)


@pytest.mark.parametrize("columns", [(), (0,), (1,), (4,), (2, 3)])
@pytest.mark.parametrize("seed", SEEDS)
def test_values_of_panel_functions(both, seed, columns):
    rng = np.random.default_rng(seed)
    panels, places = int(rng.integers(1, 40)), int(rng.integers(0, 90))
    functions = [PanelFunction(rng.normal(size=(panels, ORDER, *columns))) for _ in range(2)]
    panel, x = rng.integers(0, panels, places), rng.uniform(-1, 1, places)
    compiled, plain = both(panel_functions, lambda: panel_functions.values_at(functions, panel, x))
    for one, other in zip(compiled, plain, strict=True):
        assert one.shape == other.shape == (places, *columns)
        assert distance(one, other) < CLOSE


@pytest.mark.parametrize("seed", SEEDS)
def test_extremes_of_panel_functions(both, seed):
    """The same extremes are found, and the function is the same there: a flat one moves its places at will."""
    rng = np.random.default_rng(seed)
    series = rng.normal(size=(int(rng.integers(1, 30)), ORDER)) * 0.4 ** np.arange(ORDER)
    function = PanelFunction(series)
    (panel, sample, x), plain = both(panel_functions, lambda: function.found_extremes)
    np.testing.assert_array_equal(panel, plain[0])
    np.testing.assert_array_equal(sample, plain[1])
    assert distance(function.at(panel, x), function.at(plain[0], plain[2])) < CLOSE
    highest = (legendre_basis(np.linspace(-1, 1, 2001)) @ series.T).max()
    assert function.extremes.max() > highest - 1e-6


@pytest.mark.parametrize("curve", [drawn, ellipses])
@pytest.mark.parametrize("seed", SEEDS)
def test_derivatives_of_curves(both, seed, curve):
    t = np.random.default_rng(seed).uniform(0, 1, 50)

    def asked():
        one = curve(seed)
        low, high = one.domain
        return one.derivatives(low + (high - low) * np.concatenate([[0, 1], t]), 3)

    compiled, plain = both(curve_derivatives, asked)
    for one, other in zip(compiled, plain, strict=True):
        assert distance(one, other) < CLOSE


def test_curves_of_a_degree_beyond_the_compiled_room(both):
    """A curve of degree 40 is evaluated in Python either way."""
    rng = np.random.default_rng(1)
    line = np.column_stack([np.linspace(0, 200, 41), 5 * rng.normal(size=41)])
    curve = PlaneCurve(np.repeat([0.0, 1.0], 41), line, 40)
    compiled, plain = both(curve_derivatives, lambda: curve.evaluate(np.linspace(0, 1, 9)))
    np.testing.assert_array_equal(compiled, plain)


@pytest.mark.parametrize("columns", [(0, None), (2, 4), (3, 3)])
@pytest.mark.parametrize("seed", SEEDS)
def test_some_columns_of_polynomials(both, seed, columns):
    rng = np.random.default_rng(seed)
    series = rng.normal(size=(int(rng.integers(1, 9)), int(rng.integers(1, 12)), 5))
    u = np.concatenate([[0.0, 1.0], rng.random(30)])
    piece = rng.integers(0, len(series), u.size)
    compiled, plain = both(bernstein, lambda: bernstein.sums_in_pieces(series, piece, u, *columns))
    assert compiled.shape == plain.shape
    assert distance(compiled, plain) < CLOSE


@pytest.mark.parametrize("curve", [drawn, ellipses])
@pytest.mark.parametrize("seed", SEEDS)
def test_tangent_angles(both, seed, curve):
    """Cones, their axes and angles, and the angle at edges, from either side, and between them."""
    one = curve(seed)
    velocities, edges = tangent_angle.hodograph(one._pieces.bezier), one._pieces.edges
    t = np.concatenate([edges, np.random.default_rng(seed).uniform(*one.domain, 200)])
    velocity = one.derivatives(t, 1)[1]

    def asked():
        cones = tangent_angle.cut_into_tangent_cones(velocities, edges)
        angles = tangent_angle.tabulate_tangent_angle(cones)
        return cones, angles, [angles.at(t, velocity, left=left) for left in (False, True)]

    (cones, angles, at), (plain_cones, plain_angles, plain_at) = both(tangent_angle, asked)
    np.testing.assert_array_equal(cones.edges, plain_cones.edges)
    np.testing.assert_array_equal(cones.hodographs, plain_cones.hodographs)
    assert distance(angles.axis, plain_angles.axis) < CLOSE
    assert distance(angles.angle, plain_angles.angle) < CLOSE
    assert abs(angles.spread - plain_angles.spread) < CLOSE
    assert distance(at, plain_at) < CLOSE


@pytest.mark.parametrize(
    "velocities",
    [
        [(1, 0), (0, 0), (1, 0)],
        [(0, 0), (1, 0), (1, 0)],
        [(1, 0), (1, 0), (1e-10, 0)],
        [(1e-15, 0), (1e-15, 0), (1e-15, 0)],
        [(1, 0), (-1, 1), (-1, -1)],
    ],
    ids=["held up", "begins at rest", "comes to rest", "a point", "turns about"],
)
def test_cones_beside_a_standstill(both, velocities):
    """What may be cut or may stand still is left to the twin in Python."""
    parts = np.array([[(1.0, 0.0)] * 3, velocities])
    edges = np.array([0.0, 1.0, 2.0])
    compiled, plain = both(tangent_angle, lambda: tangent_angle.cut_into_tangent_cones(parts, edges))
    assert compiled.standstill == plain.standstill
    np.testing.assert_array_equal(compiled.edges, plain.edges)


@pytest.mark.parametrize("curve", [drawn, ellipses])
@pytest.mark.parametrize("seed", SEEDS)
def test_arc_lengths_and_back(both, seed, curve):
    """Lengths and parameters at the ends, at random places and where panels meet; and there and back again."""
    one = curve(seed)
    table = one._pieces.arc_length
    t = np.concatenate([table.t, np.random.default_rng(seed).uniform(*one.domain, 200)])
    lengths, plain = both(arc_length, lambda: table.length_at(t))
    assert distance(lengths, plain) < CLOSE
    back, plain_back = both(arc_length, lambda: table.parameter_at(lengths))
    assert distance(back, plain_back) < CLOSE
    assert np.abs(back - t).max() < 1e-11 * np.ptp(one.domain)


def test_arc_length_of_a_curve_that_all_but_stops(both):
    """Where three control points all but meet Newton's steps need their bracket."""
    near = [(0, 0), (50, 0), (50, 1e-7), (50, 2e-7), (100, 40)]
    table = PlaneCurve(np.repeat([0.0, 1.0], 5), np.array(near, dtype=float), 4)._pieces.arc_length
    s = np.linspace(0, table.s[-1], 4001)
    compiled, plain = both(arc_length, lambda: table.parameter_at(s))
    assert np.abs(compiled - plain).max() < 1e-9
    assert np.abs(table.length_at(compiled) - s).max() < 1e-11 * table.s[-1]


@pytest.mark.parametrize("seed", SEEDS)
def test_panels_of_arc_length(seed):
    """The compiled table has the panels of the one in Python, and their series."""
    pieces = drawn(seed)._pieces
    plain = arc_length.arc_length_table(pieces.speed, pieces.edges)
    np.testing.assert_allclose(pieces.arc_length.t, plain.t, rtol=0, atol=1e-15 * np.ptp(plain.t))
    assert distance(pieces.arc_length.series, plain.series) < CLOSE
    assert distance(pieces.arc_length.s, plain.s) < CLOSE


def test_arc_length_beyond_the_compiled_room(monkeypatch):
    """Where panels need more room than a kernel was given the table is made in Python."""
    near = np.array([(0, 0), (50, 0), (50, 1e-7), (50, 2e-7), (100, 40)])
    curve = PlaneCurve(np.repeat([0.0, 1.0], 5), near, 4)
    monkeypatch.setattr(arc_length, "_ROOM", 1)
    assert arc_length.compiled_arc_length(*curve.compiled_series.from_derivative(1)) is None
    assert curve.length == pytest.approx(
        arc_length.arc_length_table(curve._pieces.speed, curve._pieces.edges).s[-1], rel=1e-14
    )


@pytest.mark.parametrize("rest", [0.0, 0.004])
@pytest.mark.parametrize("seed", SEEDS)
def test_panels_of_a_curve(both, seed, rest):
    """The same panels and numbers at their nodes, beside zeros of the curvature too."""

    def cut():
        curve = drawn(seed)
        zeros = [one.t for one in ExcessCurvature(curve, rest).zeros]
        return cut_into_panels(curve, zeros, natural_curvature=rest)

    compiled, plain = both(curve_derivatives, cut)
    assert compiled.count == plain.count
    for name, value in vars(plain).items():
        assert distance(1.0 * getattr(compiled, name), 1.0 * value) < CLOSE, name


def test_panels_beyond_the_compiled_room(monkeypatch):
    """Where panels are more than a kernel was given room for they are cut in Python."""
    curve = drawn(3)
    zeros = [one.t for one in ExcessCurvature(curve, 0.0).zeros]
    compiled = cut_into_panels(curve, zeros)
    monkeypatch.setattr(quadrature_panels, "_ROOM", 2)
    plain = cut_into_panels(curve, zeros)
    assert compiled.count == plain.count
    assert distance(compiled.s, plain.s) < CLOSE


@pytest.mark.parametrize("seed", range(60))
def test_small_linear_programs(both, seed):
    rng = np.random.default_rng(seed)
    unknowns, count = int(rng.integers(1, 6)), int(rng.integers(8, 60))
    rows = rng.normal(size=(count, unknowns)) + (np.arange(unknowns) == 0) * 3.0

    def solved():
        program = VertexExchange(unknowns)
        program.add(np.concatenate([rows, rows]), np.repeat([-1.0, 0.0], count), count)
        first = program.solve()
        more = rows[:4] * 1.01 - 0.02
        program.add(np.concatenate([more, more]), np.repeat([-1.0, 0.0], 4), 4)
        return first, program.solve()

    compiled, plain = both(vertex_exchange, solved)
    for one, other in zip(compiled, plain, strict=True):
        assert (one is None) == (other is None)
        assert one is None or distance(one, other) < 1e-10


def test_small_linear_programs_come_to_an_answer():
    """The programs above are no empty test: most of them have an answer."""
    rng = np.random.default_rng(0)
    program = VertexExchange(2)
    rows = rng.normal(size=(20, 2)) + np.array([3.0, 0.0])
    program.add(np.concatenate([rows, rows]), np.repeat([-1.0, 0.0], 20), 20)
    x = program.solve()
    assert (rows @ x[:2]).min() == pytest.approx(1.0)
    assert (rows @ x[:2]).max() == pytest.approx(x[2])


@pytest.mark.parametrize(
    ("panel", "error"), [(np.array([0, 3]), IndexError), (np.array([0.0, 1.0]), ValueError)]
)
def test_places_outside_their_arrays_are_refused(panel, error):
    with pytest.raises(error):
        _native.kernels.legendre_sums(np.ones((3, ORDER)), (3, ORDER), panel, np.zeros(2), np.empty(2))
