"""Cross-sections: stiffness, inverse, weight, strain, feasibility, refusals."""

import numpy as np
import pytest

from elastica_cad import InputError, Sheet
from elastica_cad.mechanics import (
    LaminatedSection,
    LeavesLaw,
    PerforatedSection,
    PlainSection,
    RoundLaw,
    ScaleRange,
    Section,
    ThicknessLaw,
)

pytestmark = pytest.mark.core


def sheet(thickness=1.0, modulus=1200.0, density=700.0, max_strain=0.01, name="sheet"):
    return Sheet(name, thickness, modulus, density=density, max_strain=max_strain)


def two_layers():
    base = sheet(0.2, 3000.0, 800.0, 0.012, "base")
    return LaminatedSection(base, sheet(0.4, 9000.0, 650.0, 0.007, "backing"))


def test_plain_width_is_proportional_to_stiffness():
    section = PlainSection(sheet(0.5, 4000.0))
    assert section.bending_stiffness([3.0, 6.0]) == pytest.approx([125.0, 250.0])
    assert section.parameter([125.0, 250.0]) == pytest.approx([3.0, 6.0])


def test_weight_of_a_plain_strip_is_its_gravity():
    """beta K / B is K / l_eg^3, whatever B is."""
    section = PlainSection(sheet(0.5, 4000.0))
    weight = section.weight_per_length(section.parameter(73.0))
    assert weight / 73.0 == pytest.approx(section.sheet.elasto_gravity_length**-3, rel=1e-12)
    assert section.weight_per_length(section.parameter(2 * 73.0)) == pytest.approx(2 * weight)


def test_plain_strain_is_half_the_thickness_times_the_change_of_curvature():
    section = PlainSection(sheet(0.5, max_strain=0.01))
    (layer,) = section.strains([0.01, -0.05, 0.02], 20.0, natural_curvature=0.01)
    assert layer.strain == pytest.approx([0.0, 0.015, 0.0025])
    assert (layer.station, layer.judged().allowed) == (1, False)
    assert section.curvature_limit(20.0) == pytest.approx(1 / section.sheet.least_radius)


def test_two_equal_sheets_glued_make_one_of_twice_the_thickness():
    one = sheet(0.3)
    section = LaminatedSection(one, one).on(7.0)
    twice = PlainSection(sheet(0.6))
    assert section.bending_stiffness(7.0) == pytest.approx(twice.bending_stiffness(7.0))
    assert section.bending_stiffness(0.0) == pytest.approx(PlainSection(one).bending_stiffness(7.0))
    assert section.neutral_axis(7.0) == pytest.approx(0.3)
    outer, inner = section.strains([0.02], 7.0)
    assert [outer.strain, inner.strain] == [pytest.approx([0.006]), pytest.approx([0.006])]


def test_a_missing_backing_bears_no_strain():
    outer, inner = two_layers().on([10.0, 10.0]).strains([0.02, 0.02], [0.0, 5.0])
    assert outer.strain[0] == pytest.approx(0.1 * 0.02)
    assert inner.strain[0] == 0.0 < inner.strain[1]


def test_each_layer_is_held_against_its_own_limit():
    section = two_layers().on(10.0)
    limit = section.curvature_limit([0.0, 3.0, 10.0])
    outer, inner = section.strains(limit, [0.0, 3.0, 10.0])
    closest = np.maximum(outer.strain / outer.limit, inner.strain / inner.limit)
    assert closest == pytest.approx([1.0, 1.0, 1.0])
    assert outer.judged().allowed
    assert inner.judged().allowed
    assert any(not layer.judged().allowed for layer in section.strains((1 + 2e-5) * limit, [0.0, 3.0, 10.0]))


def test_weight_law_of_a_laminate_touches_the_true_one():
    s = np.linspace(0, 100, 21)
    K = 1 + 0.5 * np.sin(s / 30) ** 2
    section = two_layers().on(10 + s / 50)
    B = section.scale_range(K).scale
    weight = section.weight(s, K, B)
    true = section.weight_per_length(section.parameter(B * K))
    assert weight.alpha(s) + weight.beta(s) * K == pytest.approx(true, rel=1e-12)
    step = 1e-5
    lower = section.weight_per_length(section.parameter(B * K * (1 - step)))
    nearer = section.weight_per_length(section.parameter(B * K * (1 - 2 * step)))
    slope = (3 * true - 4 * lower + nearer) / (2 * step * K)
    assert weight.beta(s) == pytest.approx(slope, rel=1e-6)


def test_scale_takes_as_much_backing_as_the_base_covers():
    K, base = np.array([1.0, 2.0, 3.0]), np.array([8.0, 8.0, 9.0])
    section = two_layers().on(base)
    found = section.scale_range(K)
    assert found.feasible
    widths = section.parameter(found.scale * K)
    assert widths.max() == pytest.approx(9.0)
    assert found.highest_at == 2
    assert np.all((widths > 0) & (widths <= base))


def test_infeasible_laminate_names_the_stations_and_the_ratio_that_would_do():
    base = sheet(1.0)
    K, width = np.array([1.0, 30.0]), np.array([10.0, 10.0])
    section = LaminatedSection(base, sheet(2.0)).on(width)
    found = section.scale_range(K)
    assert not found.feasible
    with pytest.raises(InputError, match=r"station 0 needs .* station 1 at most"):
        _ = found.scale
    # one material: the ratio of full to bare section is (1 + h2/h1)^3
    ratio = section.thickness_ratio(K)
    assert ratio == pytest.approx(1 / (30 ** (1 / 3) - 1), rel=1e-9)
    assert LaminatedSection(base, sheet(1.0 / ratio)).on(width).scale_range(K).feasible
    assert not LaminatedSection(base, sheet(0.999 / ratio)).on(width).scale_range(K).feasible
    assert section.thickness_ratio([1.0, 1.0]) == np.inf


def test_no_thickness_helps_when_the_least_backing_fills_the_base():
    with pytest.raises(InputError, match="whatever the thickness of the backing: reduce `least_backing`"):
        two_layers().on([5.0, 5.0]).thickness_ratio([1.0, 2.0], least_backing=6.0)


def test_perforated_scale_keeps_ligaments_within_the_outline_and_above_their_least_width():
    section = PerforatedSection(sheet(), ligaments=3, least_ligament=0.8)
    K, outer = np.array([1.0, 2.0, 4.0]), np.array([20.0, 20.0, 30.0])
    found = section.scale_range(outer, K)
    ligaments = section.parameter(found.scale * K)
    assert np.all(ligaments <= outer * (1 + 1e-12))
    assert ligaments.max() == pytest.approx(30.0)
    assert section.parameter(found.lowest * K).min() == pytest.approx(3 * 0.8)
    assert not section.scale_range([2.0, 2.0, 2.0], K).feasible
    assert section.weight_per_length(5.0) == PlainSection(sheet()).weight_per_length(5.0)


def test_ligaments_curl_separately():
    one, three = (
        kind.bent(0.02) for kind in (PlainSection(sheet()), PerforatedSection(sheet(), ligaments=3))
    )
    assert three.bending_stiffness(60.0) == pytest.approx(3 * one.bending_stiffness(20.0))
    assert three.bending_stiffness(60.0) < one.bending_stiffness(60.0)


def test_scale_range_of_touching_limits_is_feasible():
    assert ScaleRange.of([3.0, 1.0], [5.0, 3.0], [1.0, 1.0]).feasible


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: PlainSection(sheet()).bending_stiffness([1.0, 0.0]), "width is 0 at station 1"),
        (lambda: PlainSection(sheet()).parameter(float("nan")), "bending stiffness is nan"),
        (lambda: two_layers().on(5.0).bending_stiffness(6.0), "to the width of the base, 5"),
        (lambda: two_layers().on(5.0).bending_stiffness(-1.0), "to the width of the base, 5"),
        (lambda: two_layers().on(5.0).parameter(1e-3), "less than that of the base alone"),
        (
            lambda: two_layers().on([5.0, 5.0]).parameter([200.0, 1e9]),
            "station 1 .* more than that of two full layers",
        ),
        (lambda: two_layers().on(5.0).scale_range([1.0, -1.0]), "stiffness is -1 at station 1"),
        (lambda: two_layers().on(5.0).scale_range(1.0, least_backing=-1.0), "give 0 or more"),
        (lambda: PerforatedSection(sheet(), ligaments=0), "whole number"),
        (lambda: PerforatedSection(sheet(), least_ligament=-0.1), "give 0 or more"),
        (lambda: ThicknessLaw(sheet(), 8.0, 3.0, width=20.0), "thickness limits are 8 and 3 mm"),
        (lambda: ThicknessLaw(sheet(), 3.0, 8.0, width=0.0), "width is 0: give a positive width"),
        (lambda: ThicknessLaw("ply", 3.0, 8.0, width=5.0), "Pass a Sheet"),
        (lambda: RoundLaw(sheet(), 3.0, 8.0, bore=1.0), "`bore` is 1: give the ratio of inner to outer"),
        (lambda: RoundLaw(sheet(), 0.0, "8"), "diameter limit is '8': give a finite number"),
        (lambda: PlainSection(sheet(), 0.0, 0.0), "width limits are 0 and 0 mm"),
    ],
)
def test_bad_input_is_one_sentence(call, message):
    with pytest.raises(InputError, match=message):
        call()


@pytest.mark.parametrize(
    ("section", "dearest"),
    [
        (PlainSection(sheet()), 40.0),
        (PerforatedSection(sheet(), ligaments=3), 40.0),
        (PerforatedSection(sheet(), ligaments=3).bent([0.01, 0.03, 0.02]), 40.0),
        (LaminatedSection(sheet(), sheet(0.5, name="backing")).on([25.0, 30.0, 40.0]), 20.0),
        (ThicknessLaw(sheet(), 1.0, 50.0, width=30.0), 40.0),
        (RoundLaw(sheet(), 1.0, 50.0), 40.0),
        (RoundLaw(sheet(), 1.0, 50.0, bore=0.8), 40.0),
        (PlainSection(sheet(), 1.0, 50.0).bent([0.01, 0.03, 0.02]), 40.0),
        (LeavesLaw(sheet(), 50, 30.0), 40.0),
    ],
)
def test_every_section_turns_its_parameter_into_stiffness_and_back(section: Section, dearest):
    parameter = np.array([5.0, 12.0, dearest])
    stiffness = section.bending_stiffness(parameter)
    assert section.parameter(stiffness) == pytest.approx(parameter, rel=1e-9)
    assert np.all(np.diff(stiffness) > 0)
    assert np.all(np.diff(section.weight_per_length(parameter)) > 0)
    bent, straight = section.strains([0.01, 0.02, 0.03], parameter), section.strains(np.full(3, 0.02), parameter,
                                                                              natural_curvature=0.02)  # fmt: skip
    assert all(layer.largest > 0 for layer in bent)
    assert all(layer.largest == 0 for layer in straight)
