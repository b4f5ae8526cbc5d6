"""`nearest_rod` against the published optimiser's results (Flower Pot, unstable S) and published limits."""

import json

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

from elastica_cad import (
    Frame,
    Gravity,
    Keep,
    Limits,
    PlaneCurve,
    Rod,
    bend,
    check_equilibrium,
    nearest_rod,
    optimal_rod,
    stability,
)
from elastica_cad.form_finding import mesh_sections
from elastica_cad.mechanics import bend_path

pytestmark = pytest.mark.core


def unclamped(control_points):
    """The reference's uniform unclamped quartic spline."""
    return PlaneCurve(np.arange(-4.0, len(control_points) + 1), np.asarray(control_points, dtype=float), 4)


def read_flower_pot(reference_data):
    """Drawn curves, published distances and weight."""
    data = json.loads((reference_data / "reference" / "flower_pot.json").read_text())
    millimetres = 1000 * data["scale_m_per_unit"]
    curves = [unclamped(np.array(c["cp_initial"]) * millimetres) for c in data["curves"]]
    published = np.array([c["distance"]["hausdorff_fit_to_final_rel"] for c in data["curves"]])
    e = np.array(data["e_gravity"]) * 1e-9  # 1/m3 to 1/mm3; it points up
    gravity = Gravity(np.hypot(*e) ** (-1 / 3), tuple(-e))
    return curves, published, gravity


@pytest.fixture(scope="module")
def flower_pot(reference_data):
    return read_flower_pot(reference_data)


@pytest.fixture(scope="module")
def s_curve(reference_data):
    points = np.loadtxt(reference_data / "hafner" / "spline_infl_simple.txt", skiprows=1)
    return unclamped(30 * points)


def hausdorff(curve, nodes, count=3000):
    """Largest distance of a curve and a chain of nodes, either way, over the diagonal: the file's own measure."""
    knots, points = np.array(curve.knots), np.array(curve.control_points)  # copies: scipy < 1.11
    spline = BSpline(knots, points, curve.degree)
    a = spline(np.linspace(*curve.domain, count))
    s = np.linspace(0, 1, len(nodes))
    b = np.column_stack([np.interp(np.linspace(0, 1, count), s, nodes[:, k]) for k in (0, 1)])
    return max(cKDTree(a).query(b)[0].max(), cKDTree(b).query(a)[0].max()) / np.hypot(*np.ptp(a, axis=0))


def independent_residual(rod):
    """Moment imbalance by the book: M' = <b, gamma'> with b' = -K R^t e, on the nodes' chords."""
    h = rod.length / (rod.s.size - 1)
    w = np.full(rod.s.size, h)
    w[[0, -1]] /= 2
    load = np.zeros_like(rod.position)
    if rod.gravity is not None:
        load = (w * rod.stiffness / rod.gravity.length**3)[:, None] * np.array(rod.gravity.direction)
    force = rod.force[0] + np.cumsum(load, axis=0)[:-1]
    step = np.diff(rod.position, axis=0)
    across = force[:, 1] * step[:, 0] - force[:, 0] * step[:, 1]
    return np.abs(np.diff(rod.moment) - across).max() / np.abs(rod.moment).max()


def test_flower_pot_without_weight_beats_the_published_curves(flower_pot):
    curves, published, _ = flower_pot
    found = [nearest_rod(curve, Limits(ratio=2.5)) for curve in curves]
    distances = np.array([hausdorff(c, n.rod.position) for c, n in zip(curves, found, strict=True)])
    assert all(near.met for near in found)
    assert max(near.rod.ratio for near in found) <= 2.5 * (1 + 1e-9)
    assert np.all(distances < published)
    assert distances.mean() <= 0.0195
    for curve, near in zip(curves, found, strict=True):
        np.testing.assert_allclose(
            near.rod.position[[0, -1]], curve.evaluate(np.array(curve.domain)), atol=1e-6
        )
        assert near.deviation == pytest.approx(
            hausdorff(curve, near.rod.position) * diagonal(curve), rel=0.02
        )
        assert independent_residual(near.rod) < 1e-9


def diagonal(curve):
    return float(np.hypot(*np.ptp(curve.sample(3000).position, axis=0)))


def test_flower_pot_under_its_weight_is_stable(flower_pot):
    curves, _, gravity = flower_pot
    found = [nearest_rod(curve, Limits(ratio=3.3, margin=5.0), gravity=gravity) for curve in curves]
    distances = np.array([hausdorff(c, n.rod.position) for c, n in zip(curves, found, strict=True)])
    assert all(near.met for near in found)
    assert max(near.rod.ratio for near in found) <= 3.3 * (1 + 1e-9)
    assert distances.mean() <= 0.016
    assert distances.max() <= 0.020
    for near in found:
        assert stability(near.rod).margin >= 5.0 - 1e-6
        assert independent_residual(near.rod) < 1e-9


@pytest.mark.parametrize(("ratio", "largest"), [(2.954, 0.0105), (2.0, 0.03)])
def test_the_unstable_s_becomes_stable(s_curve, ratio, largest):
    assert not stability(optimal_rod(s_curve)).stable
    near = nearest_rod(s_curve, Limits(ratio=ratio, margin=5.0), Keep(tangents=True))
    assert near.met
    assert hausdorff(s_curve, near.rod.position) <= largest
    assert stability(near.rod).margin >= 5.0 - 1e-6
    assert near.rod.ratio <= ratio * (1 + 1e-9)
    np.testing.assert_allclose(near.rod.angle[[0, -1]], s_curve.at([0.0, s_curve.length]).angle, atol=1e-7)
    if ratio > 2.5:
        least = nearest_rod(s_curve, Limits(ratio=ratio, margin=5.0), Keep(tangents=True), measure="max")
        assert least.met
        assert hausdorff(s_curve, least.rod.position) < 0.0085


def test_near_curves_are_realizable_at_the_limit(flower_pot, s_curve):
    curves, _, _ = flower_pot
    cases = [(c, Limits(ratio=2.5), Keep()) for c in curves[:5]]
    cases.append((s_curve, Limits(ratio=2.954, margin=5.0), Keep(tangents=True)))
    for curve, limits, keep in cases:
        spline = nearest_rod(curve, limits, keep).curve
        assert spline.degree == 4
        assert check_equilibrium(spline).realizable
        assert optimal_rod(spline).ratio == pytest.approx(limits.ratio, rel=1e-3)


def test_rods_return_when_disturbed(flower_pot, s_curve):
    """Disturbed by 1 % of its curvature and released, a rod with positive margin comes back."""
    curves, _, gravity = flower_pot
    cases = [(curves[k], Limits(ratio=3.3, margin=5.0), Keep(), gravity) for k in (0, 2, 4)]
    cases += [(curves[1], Limits(ratio=2.5, margin=5.0), Keep(), None)]
    cases += [(s_curve, Limits(ratio=2.954, margin=5.0), Keep(tangents=True), None)]
    for curve, limits, keep, weight in cases:
        rod = nearest_rod(curve, limits, keep, weight).rod
        phase = 2 * np.pi * rod.s / rod.length
        disturbed = (
            rod.angle + 0.01 * np.abs(rod.curvature).max() * rod.length / (2 * np.pi) * np.sin(phase) ** 2
        )
        back = bend(rod, guess=disturbed)
        assert np.abs(back.position - rod.position).max() < 1e-6 * rod.length


def test_rods_without_inflection_rise_from_the_flat_strip():
    """The strip that is cut flat, led to its ends in steps, stands in the shape that was found."""
    arch = PlaneCurve.spline([(0, 0), (10, 60), (60, 95), (115, 60), (120, 0)], degree=4)
    near = nearest_rod(arch, Limits(ratio=1.3, margin=5.0), Keep(tangents=True))
    rod = near.rod
    assert near.met
    assert not np.any(rod.moment[1:-1] * rod.moment[1] < 0)
    flat = Rod.straight(rod.length, rod.profile, samples=rod.s.size, angle=float(rod.angle.mean()))
    share = np.linspace(0, 1, 13)[1:, None]
    starts = (1 - share) * flat.position[0] + share * rod.position[0]
    ends = (1 - share) * flat.position[-1] + share * rod.position[-1]
    angles = (1 - share) * flat.angle[[0, -1]] + share * rod.angle[[0, -1]]
    path = [{"start": a, "end": b, "angles": c} for a, b, c in zip(starts, ends, angles, strict=True)]
    stands = bend_path(flat, path, side=1 if rod.moment[1] < 0 else -1)[-1]
    assert np.abs(stands.position - rod.position).max() < 1e-6 * rod.length


def test_shell_sections_at_a_ratio_of_1_5(reference_data):
    """Ten planes from the Shell's foot, six control points each (paper, Fig. 20; 1.39 s there)."""
    lines = (reference_data / "hafner" / "teaser" / "teaser_sixth.obj").read_text().splitlines()
    vertices = 30 * np.array([line.split()[1:4] for line in lines if line.startswith("v ")], dtype=float)
    quads = np.array(
        [[int(c.split("/")[0]) - 1 for c in line.split()[1:]] for line in lines if line.startswith("f ")]
    )
    triangles = np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    foot = vertices[vertices[:, 2] < 1e-2]
    foot = foot[np.argsort(-np.arctan2(foot[:, 1], foot[:, 0]))]
    along = np.append(0, np.cumsum(np.linalg.norm(np.diff(foot, axis=0), axis=1)))
    knots = np.concatenate([np.zeros(5), [0.5], np.ones(5)])
    u = np.linspace(0, 1, 200)
    basis = BSpline.design_matrix(u, knots, 4).toarray()
    for t in (np.arange(10) + 0.5) / 10:
        angle = (1 - t) * np.pi / 2 + t * np.pi / 6 - t * (1 - t) / 2
        start = [np.interp(t * along[-1], along, column) for column in foot.T]
        frame = Frame(start, (np.cos(angle), np.sin(angle), 0), (0, 0, 1))
        (section,) = mesh_sections(vertices, triangles, [frame])
        points = max((line.points for line in section.lines), key=len)
        at = np.append(0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
        dense = np.column_stack([np.interp(u, at / at[-1], column) for column in points.T])
        wish = PlaneCurve(knots, np.linalg.lstsq(basis, dense, rcond=None)[0], 4)
        near = nearest_rod(wish, Limits(ratio=1.5))
        assert near.met
        assert near.rod.ratio <= 1.5 * (1 + 1e-9)
        assert near.deviation < 0.01 * diagonal(wish)
