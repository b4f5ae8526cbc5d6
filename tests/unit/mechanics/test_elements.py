"""Rails, pins, ties and point forces: their records, their places, and what does not take them into account."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.errors import InputError

ARCH = ec.PlaneCurve.ellipse((0, 0), (200, 100), start=0, end=np.pi)
WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)


@pytest.mark.parametrize(
    ("record", "message"),
    [
        (
            lambda: ec.Rail("a"),
            "The place of a rail is 'a', neither a finite number nor a point. Give",
        ),
        (lambda: ec.Rail((1, 2, 3)), "The place of a rail"),
        (lambda: ec.Rail(3, one_sided="yes"), "one_sided of a rail is"),
        (lambda: ec.Pin(float("nan")), "The place of a pin"),
        (lambda: ec.Tie(1, None), "The place of the end of a tie is None"),
        (lambda: ec.PointForce(3, 4), "two finite numbers"),
    ],
)
def test_wrong_records_are_refused(record, message):
    with pytest.raises(InputError, match=message):
        record()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"between": "rail"}, "Pass only Rail, Pin or Tie records"),
        ({"between": ec.PointForce(10, (0, 1))}, "Pass only Rail, Pin or Tie records"),
        ({"loads": ec.Rail(10)}, "Pass only PointMass or PointForce records"),
        ({"loads": ec.PointMass(10, 5)}, "no gravity for its direction"),
        (
            {"between": ec.Rail(1e4)},
            "The rail 10000 mm from the start is not on the curve. Give a place from 0 to 484",
        ),
        (
            {"between": ec.Pin((0, 60))},
            r"The pin at \(0, 60\) mm is 40 mm off the curve, farther than 24.22 mm \(5 % of its length\)",
        ),
        ({"between": ec.Pin(0)}, "The pin 0 mm from the start acts on an end that is held in place"),
        (
            {"between": ec.Tie(0, ARCH.length)},
            "The tie 0 mm from the start acts on an end that is held in place",
        ),
        ({"between": ec.Tie(90, 200, length=80)}, "The tie from 90 mm to 200 mm has a length"),
        ({"between": ec.Tie(90, 90)}, "The tie from 90 mm to 90 mm along the strip has no length"),
        ({"supports": ec.Supports("free", "free")}, "The rod is free to move along x"),
    ],
)
def test_wrong_requests_are_refused(options, message):
    with pytest.raises(InputError, match=message):
        ec.optimal_rod(ARCH, **options)


def test_a_point_is_moved_to_the_nearest_place():
    point = ec.PlaneCurve.at(WAVE, [150.0]).position[0]
    by_point, by_length = (ec.optimal_rod(WAVE, between=ec.Rail(at)) for at in ((*point,), 150.0))
    assert by_point.between[0].s == pytest.approx(150.0, abs=1e-6)
    assert by_point.ratio == pytest.approx(by_length.ratio, rel=1e-6)
    assert by_point.between[0].element.at == (*point,)


def test_lambda_steps_by_the_forces():
    """Also at a node; a tie acts on both of its stations."""
    rod = ec.optimal_rod(WAVE, between=(ec.Pin(WAVE.length / 2), ec.Tie(60, 320)))
    step = rod.force[-1] - rod.force[0]
    assert step == pytest.approx(rod.between_forces[0], abs=1e-12)
    inside = rod.force[int(rod.s.searchsorted(70))] - rod.force[0]
    assert inside == pytest.approx(rod.between_forces[1], abs=1e-12)
    chord = WAVE.at([60.0, 320.0]).position
    assert rod.between_forces[1] @ (chord[1] - chord[0]) > 0
    # M' = <b, gamma'>, with lambda = R b: the balance of moments between two nodes away from the stations
    k = int(rod.s.searchsorted(100))
    moved = rod.position[k + 40] - rod.position[k]
    b = np.array([rod.force[k, 1], -rod.force[k, 0]])
    assert rod.moment[k + 40] - rod.moment[k] == pytest.approx(b @ moved, abs=1e-8 * np.abs(rod.moment).max())


def test_two_free_ends_need_a_tie():
    flat = ec.Rod.straight(500.0, samples=601)
    bow = ec.bend(flat, end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned")).curve
    free = ec.Supports("free", "free")
    with pytest.raises(InputError, match="free to turn"):
        ec.optimal_rod(bow, supports=free, between=ec.Pin(250.0))
    with pytest.raises(ec.NotRealizable, match="free to turn"):
        ec.optimal_rod(ARCH, supports=free, between=ec.Tie(0, ARCH.length))
    for refused in (lambda: ec.check_equilibrium(bow, free), lambda: ec.nearest_rod(bow, supports=free)):
        with pytest.raises(InputError, match="free to move"):
            refused()


@pytest.mark.parametrize("off", [-2e-7, 2e-7])
def test_a_tie_ends_at_the_end_within_rounding(off):
    flat = ec.Rod.straight(500.0, samples=601)
    bow = ec.bend(flat, end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned")).curve
    rod = ec.optimal_rod(
        bow, supports=ec.Supports("free", "free"), between=ec.Tie(off, bow.length * (1 + off))
    )
    assert rod.between[0].s == pytest.approx([0.0, rod.length], abs=1e-9)
    assert rod.ratio < 1.01


def test_an_element_at_an_inflection_does_not_push():
    inflection = WAVE.inflections[0]
    rod = ec.optimal_rod(WAVE, between=(ec.Rail(inflection), ec.Pin(200.0)))
    assert np.hypot(*rod.between_forces[0]) < 1e-6 * np.abs(rod.force).max()
    assert any("may become slack" in warning for warning in rod.warnings)
    assert ec.stability(rod).stable


def test_other_studies_refuse_them():
    rod = ec.optimal_rod(WAVE, between=ec.Pin(200.0))
    strip = ec.Strip(rod, ec.Sheet.named("birch-plywood-0.8"), max_width=30.0)
    assert strip.outline.length > 2 * rod.length
    for refused in (
        strip.held,
        lambda: ec.Strip(rod, "birch-plywood-0.8", max_width=30.0, creep=0.5).crept,
    ):
        with pytest.raises(InputError, match="does not take rails, pins, ties or point forces into account"):
            refused()


def test_a_straight_strip_bends_under_a_force():
    line = ec.PlaneCurve.spline([(0, 0), (50, 0), (100, 0)], degree=2)
    assert ec.optimal_rod(line, between=ec.Rail(50.0)).ratio == 1.0
    with pytest.raises(ec.NotRealizable, match="a straight strip bends"):
        ec.optimal_rod(line, loads=ec.PointForce(50.0, (0, -1)))


def test_each_inflection_is_on_its_side_of_the_thrust_line():
    """Neighbouring sides meet on the line of the force between them."""
    rod = ec.optimal_rod(WAVE, between=ec.Pin(200.0))
    first, second = rod.thrust_line
    before, after = WAVE.at(WAVE.inflections).position
    assert first.distance(before[None]) == pytest.approx(0.0, abs=1e-6)
    assert second.distance(after[None]) == pytest.approx(0.0, abs=1e-6)
    corner = np.linalg.solve([first.b, second.b], [-first.a, -second.a])
    off = corner - WAVE.at([200.0]).position[0]
    force = rod.between_forces[0] / np.hypot(*rod.between_forces[0])
    assert off[0] * force[1] - off[1] * force[0] == pytest.approx(0.0, abs=1e-6)
    (side,) = ec.optimal_rod(
        ec.PlaneCurve.spline([(0, 0), (60, 50), (120, -50), (180, 0)], degree=3)
    ).thrust_line
    assert side.distance(np.array([[90.0, 0.0]])) == pytest.approx(0.0, abs=1e-3)
