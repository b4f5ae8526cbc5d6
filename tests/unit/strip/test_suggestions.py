"""Changes that make an impossible curve possible, each judged with other means than the search."""

import re

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import write_curves
from elastica_cad.mechanics import trials
from elastica_cad.strip import suggestions
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.suggestions import suggest
from tests.command_line import run

ZIGZAG = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]
ORDER = ["point", "smooth", "split_corners", "nearest", "between", "sheet", "size"]


def curves(count):
    """Splines that no strip takes, by seed."""
    rng = np.random.default_rng(4)
    while count:
        points = np.column_stack([np.linspace(0, 300, 7), rng.uniform(-1, 1, 7) * rng.uniform(15, 60)])
        curve = ec.PlaneCurve.spline(points, degree=5)
        if not ec.check_equilibrium(curve).realizable:
            count -= 1
            yield curve


def require_held(curve, suggestion):
    """The strip of a suggestion is made again, in equilibrium, stable, within the strain and near the curve."""
    (request,) = suggestion.requests
    strip = request.make()
    assert ec.stability(strip.rod).stable
    assert strip.strain_verdict.allowed
    gaps = np.linalg.norm(
        strip.rod.position[:, None] - curve.at(np.linspace(0, curve.length, 500)).position, axis=2
    )
    size = np.hypot(*np.ptp(curve.bounds, axis=0))
    assert suggestion.is_far == (suggestion.deviation > 0.03 * size)
    assert gaps.min(axis=1).max() <= 1.01 * suggestion.deviation + 0.003 * size


def test_a_moved_point_alone_makes_a_curve_possible():
    curve = ec.PlaneCurve.spline(ZIGZAG, degree=5)
    check = ec.check_equilibrium(curve)
    (index, place), *_ = (cure.change.value for cure in check.cures if cure.change.field == "point")
    points = np.array(ZIGZAG, dtype=float)
    points[index] = place
    moved = ec.PlaneCurve.spline(points, degree=5)
    assert not check.realizable
    assert ec.check_equilibrium(moved).realizable
    assert ec.optimal_rod(moved).ratio <= 8


def test_a_possible_curve_has_no_cures():
    assert ec.check_equilibrium(ec.PlaneCurve.arc((0, 0), 100, 0, 2)).cures == ()


def changes_of(points, sheet, width, degree=5, **options):
    """The curve and the changes of a refused strip, each made again."""
    spec = ec.StripSpec(ec.PlaneCurve.spline(points, degree), sheet, max_width=width)
    with pytest.raises(ec.ElasticaError) as refusal:
        spec.make()
    found = list(suggest(spec, refusal.value, **options))
    for suggestion in found:
        (request,) = suggestion.requests
        strip = request.make()
        assert ec.stability(strip.rod).stable
        assert strip.strain_verdict.allowed
    return spec, found


def test_the_nearest_curve_is_the_last_change_if_it_is_far():
    points = [(0, 0), (45, 55), (90, 10), (140, -50), (190, 5), (240, 50), (280, -10)]
    _, found = changes_of(points, "birch-plywood-2", 20)
    *_, last = found
    assert last.change.field == "nearest"
    assert last.is_far
    assert f"up to {about(last.deviation)} from the drawn curve" in last.effect
    assert not any(suggestion.is_far for suggestion in found[:-1])


def test_a_straight_strip_is_not_suggested():
    arch = ec.PlaneCurve.spline([(0, 0), (200, 100), (900, 100), (1100, 0)], degree=3)
    spec = ec.StripSpec(arch, "birch-plywood-0.8", max_width=103, supports=ec.Supports(end="free"))
    with pytest.raises(ec.ElasticaError, match="free to turn") as refusal:
        spec.make()
    assert list(suggest(spec, refusal.value, ["nearest"])) == []


def test_no_nearest_curve_is_sought_for_more_than_100_corners():
    zigzag = [(5 * k, 10 * (k % 4 == 2) + 5 * (k % 2)) for k in range(205)]
    knots = np.repeat(np.arange(103), [3, *[2] * 101, 3])
    spec = ec.StripSpec(ec.PlaneCurve(knots, zigzag, 2), "pom-0.5", max_width=20)
    with pytest.raises(ec.InputError, match="has corners") as refusal:
        spec.make()
    assert list(suggest(spec, refusal.value)) == []


def test_the_searches_after_a_refusal_share_a_bound_of_steps(monkeypatch):
    spec = ec.StripSpec(ec.PlaneCurve.arc((0, 0), 60, 0, 3), "oak-3", max_width=12)
    with pytest.raises(ec.ElasticaError, match="strain") as refused:
        spec.make()
    assert [found.change.field for found in suggest(spec, refused.value)][-1] == "nearest"
    monkeypatch.setattr(suggestions, "MOST_STEPS", 1)
    assert [found.change.field for found in suggest(spec, refused.value)] == ["sheet", "size"]


def test_no_change_of_a_curve_of_very_many_pieces_is_tried(monkeypatch, tmp_path):
    wave = ec.PlaneCurve.spline(ZIGZAG, degree=3)
    spec = ec.StripSpec(wave, "pom-0.5", max_width=20)
    with pytest.raises(ec.NotRealizable) as refusal:
        spec.make()
    assert list(suggest(spec, refusal.value))
    monkeypatch.setattr(trials, "MOST_PIECES", 2)
    assert list(suggest(spec, refusal.value)) == []
    write_curves([wave], tmp_path / "wave.json")
    checked = run("check", tmp_path / "wave.json", code=1).output
    assert re.search(r"^Change +Not tried, because the curve has 3 pieces, more than 2\.", checked, re.M)


def test_no_support_is_sought_for_a_curve_of_very_many_inflections(monkeypatch):
    wave = ec.PlaneCurve.spline(
        [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
    )
    spec = ec.StripSpec(wave, "birch-plywood-0.8", max_width=25)
    with pytest.raises(ec.NotRealizable) as refusal:
        spec.make()
    for most, fields in ((2, ["between"]), (1, [])):
        monkeypatch.setattr(suggestions, "MOST_INFLECTIONS", most)
        assert [found.change.field for found in suggest(spec, refusal.value, ["between"])] == fields


def test_a_tight_curve_gets_another_sheet_or_size_once_with_the_width_it_needs():
    points = [(0, 0), (60, 70), (120, 20), (180, -45), (240, 30), (300, 75)]
    spec, found = changes_of(points, "birch-plywood-3", 31)
    changes = {suggestion.change.field: suggestion for suggestion in found}
    assert "thickness" not in changes
    sheet, size = changes["sheet"], changes["size"]
    assert sheet.requests[0].material.kind == spec.material.kind
    assert size.strips[0].rod.length == pytest.approx(size.change.value * spec.curve.length, rel=1e-3)
    assert float(size.effect.split()[2]) == pytest.approx(size.strips[0].rod.length, rel=0.005)
    wider = [suggestion for suggestion in (sheet, size) if suggestion.width]
    assert wider
    for suggestion in wider:
        (width,) = (request.max_width for request in suggestion.requests)
        assert suggestion.as_dict()["max_width"] == width > 31
        assert f"Set max_width to {width:g} mm." in suggestion.title
    _, fitting = changes_of(points, "birch-plywood-3", 31, sheet_size=(600, 400))
    assert "size" not in [suggestion.change.field for suggestion in fitting]


def test_cures_hold_in_a_fixed_order():
    for curve in curves(2):
        cures = ec.check_equilibrium(curve).cures
        fields = [cure.change.field for cure in cures]
        last = {cure.change.field for cure in cures if cure.is_last_resort}
        moved = {cure.change.field: cure.deviation for cure in cures if cure.change.field in ORDER[:4]}
        least = min((far for name, far in moved.items() if far and name not in last), default=np.inf)
        much_larger = {name for name, far in moved.items() if far >= 10 * least}
        assert fields == sorted(
            fields,
            key=lambda name: (name in last, name not in moved, name in much_larger, ORDER.index(name)),
        )
        for cure in cures:
            require_held(curve, cure)


def test_a_much_larger_change_of_the_curve_follows_the_smaller_one():
    """Changes of the curve come in their order, unless one is ten times as large as another."""
    wave = ec.PlaneCurve.spline(np.array(ZIGZAG) * [0.7, -0.7], degree=5)
    nearest, point = ec.check_equilibrium(wave).cures
    assert (nearest.change.field, point.change.field) == ("nearest", "point")
    assert point.deviation > 10 * nearest.deviation > 0
    point, nearest, rail = ec.check_equilibrium(next(curves(1))).cures
    assert [cure.change.field for cure in (point, nearest, rail)] == ["point", "nearest", "between"]
    assert nearest.deviation < point.deviation < 10 * nearest.deviation


@pytest.mark.campaign
def test_most_refused_curves_have_a_cure():
    """Of 60 curves by seed; the same list each time."""
    found = []
    for curve in curves(60):
        cures = ec.check_equilibrium(curve).cures
        assert len(cures) <= 4
        for cure in cures:
            require_held(curve, cure)
        found.append([cure.change.field for cure in cures])
    print(sum(map(bool, found)), "of 60 have a cure; the first is", [fields[:1] for fields in found])
    assert sum(map(bool, found)) >= 55
