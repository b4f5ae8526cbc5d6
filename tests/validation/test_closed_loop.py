"""From the cutting file back to the drawn curve, by a reader and a solver that share no code with ours.

The DXF is read with ezdxf, the widths become stiffness, and scipy's collocation solver for boundary-value
problems bends that strip between the drawn ends. It must land on the drawn curve within 1e-4 of its length.
"""

import ezdxf
import numpy as np
import pytest
from scipy.integrate import solve_bvp
from scipy.interpolate import BSpline, CubicHermiteSpline

import elastica_cad as ec

SHEET = "birch-plywood-0.8"


def wave(start, stop, amplitude=40.0, pitch=100.0):
    """A sine wave: its inflections lie at the multiples of pi, all on the axis, which it crosses nowhere else."""
    x = np.linspace(start, stop, 200)
    return ec.PlaneCurve.fit(np.column_stack([pitch * x, amplitude * np.sin(x)]), degree=5, tolerance=1e-3)


def spiral():
    t = np.linspace(0.0, 3 * np.pi, 300)
    r = 20 + 6 * t
    return ec.PlaneCurve.fit(np.column_stack([r * np.cos(t), r * np.sin(t)]), degree=4, tolerance=1e-3)


CURVES = {
    "arc": lambda: ec.PlaneCurve.arc((0, 0), 150.0, 0.2, 2.9),
    "ellipse": lambda: ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.0, np.pi),
    "tall ellipse": lambda: ec.PlaneCurve.ellipse((5, 3), (100.0, 200.0), 0.3, 0.3, 2.5),
    "spiral": spiral,
    "one inflection": lambda: wave(-2.0, 1.7),
    "two inflections": lambda: wave(-0.9, np.pi + 0.7),
    "three inflections": lambda: wave(-1.0, 2 * np.pi + 0.8),
}


def widths_of(path):
    """Stations and widths of the free part from the splines on CUT_OUTER, and its length."""
    document = ezdxf.readfile(path)
    sides = [e for e in document.modelspace() if e.dxftype() == "SPLINE" and e.dxf.layer == "CUT_OUTER"]
    assert len(sides) == 2, "a smooth strip has exactly two spline edges"
    graphs = []
    for side in sides:
        points = np.array(side.control_points)[:, :2]
        spline = BSpline(np.array(side.knots), points, side.dxf.degree)
        u = np.linspace(side.knots[0], side.knots[-1], 20001)
        xy = spline(u)
        xy = xy[np.argsort(xy[:, 0], kind="stable")]
        graphs.append(xy)
    x0 = max(g[0, 0] for g in graphs)
    x1 = min(g[-1, 0] for g in graphs)
    x = np.linspace(x0, x1, 8001)
    low, high = sorted(graphs, key=lambda g: g[:, 1].mean())
    return x - x0, np.interp(x, *high.T) - np.interp(x, *low.T)


def bent(s, stiffness, drawn, load=None):
    """The equilibrium between the drawn ends: (alpha, x, y, M) with b as the two unknown parameters."""
    length = s[-1]
    slope = np.gradient(stiffness, s, edge_order=2)
    K = CubicHermiteSpline(s, stiffness, slope)
    first, last = drawn.at(np.array([0.0])), drawn.at(np.array([drawn.length]))

    def rhs(x, z, b):
        alpha, _, _, M = z
        return np.vstack(
            [M / K(x), np.cos(alpha), np.sin(alpha), b[0] * np.cos(alpha) + b[1] * np.sin(alpha)]
        )

    def ends(za, zb, b):
        return np.array([
            za[0] - first.angle[0], za[1] - first.position[0, 0], za[2] - first.position[0, 1],
            zb[0] - last.angle[0], zb[1] - last.position[0, 0], zb[2] - last.position[0, 1],
        ])  # fmt: skip

    mesh = np.linspace(0.0, length, 801)
    guess = drawn.at(mesh * drawn.length / length)
    M = K(mesh) * guess.curvature
    basis = np.column_stack([np.ones(mesh.size), guess.position])
    b0 = np.linalg.lstsq(basis, M, rcond=None)[0][1:]
    state = np.vstack([guess.angle, guess.position.T, M])
    solution = solve_bvp(rhs, ends, mesh, state, p=b0, tol=1e-7, max_nodes=60000)
    assert solution.success, solution.message
    return solution.sol


def deviation(strip, drawn, folder):
    """Largest distance (mm) between the bent strip that the DXF holds and the drawn curve."""
    path = folder / "strip.dxf"
    ec.save(strip.drawing(), path)
    s, width = widths_of(path)
    assert s[-1] == pytest.approx(drawn.length, rel=1e-9)
    shape = bent(s, width / width.min(), drawn)
    stations = np.linspace(0.0, drawn.length, 501)
    return np.abs(shape(stations)[1:3].T - drawn.at(stations).position).max()


@pytest.mark.parametrize("name", CURVES)
def test_cut_strip_bends_into_the_drawn_curve(name, tmp_path):
    drawn = CURVES[name]()
    rod = ec.optimal_rod(drawn)
    strip = ec.Strip(rod, ec.Sheet.named(SHEET), max_width=40.0)
    assert deviation(strip, rod.curve, tmp_path) < 1e-4 * drawn.length
    assert rod.moved < 1e-4 * drawn.length


def test_published_s_curve_bends_into_itself_although_unstable(reference_data, tmp_path):
    (drawn,) = ec.read_curves(reference_data / "hafner" / "spline_infl_simple.txt")
    rod = ec.optimal_rod(drawn)
    assert rod.ratio == pytest.approx(3.4687, abs=1e-3)
    strip = ec.Strip(rod, ec.Sheet.named("card-200gsm"), max_width=1.0)
    assert deviation(strip, rod.curve, tmp_path) < 1e-4 * drawn.length


def test_a_wrong_width_misses_the_curve(tmp_path):
    """The loop can fail: a strip of constant width does not take the ellipse."""
    drawn = CURVES["tall ellipse"]()
    rod = ec.optimal_rod(drawn)
    wrong = ec.Strip(rod.with_stiffness(np.ones(rod.s.size)), ec.Sheet.named(SHEET), max_width=40.0)
    assert deviation(wrong, drawn, tmp_path) > 1e-3 * drawn.length
