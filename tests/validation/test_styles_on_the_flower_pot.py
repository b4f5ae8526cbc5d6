"""The Flower Pot of the paper (section 9.2): strips that touch, laminated and perforated to their stiffness."""

import json
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import Frame, InputError, Laminated, Perforated, touching_widths
from elastica_cad.mechanics import LaminatedSection, optimal_laminate

pytestmark = pytest.mark.core

CARD = ec.Sheet.named("card-200gsm")
SCALE = 60.0  # mm per mesh unit
GAP = 2.0  # mm off each half width


def card(thickness):
    return ec.Sheet(
        f"card-{thickness}",
        thickness,
        CARD.youngs_modulus,
        density=CARD.density,
        max_strain=CARD.max_strain,
    )


@pytest.fixture(scope="module")
def published(reference_data):
    return json.loads((reference_data / "reference" / "flower_pot.json").read_text())["curves"]


@pytest.fixture(scope="module")
def pot(published):
    """Curves in their half planes about the axis."""
    found = []
    for record in published:
        points = SCALE * np.array(record["cp_final"])
        curve = ec.PlaneCurve(np.arange(-4.0, len(points) + 1), points, 4)
        x_axis, y_axis = record["frame_axes_3d"]
        found.append((curve, Frame(SCALE * np.array(record["frame_origin_3d"]), x_axis, y_axis)))
    return found


@pytest.fixture(scope="module")
def widths(pot):
    return touching_widths(pot, GAP, closed=True)


def test_outer_widths_are_the_published_ones(pot, published, widths):
    for (curve, _), record, width in zip(pot, published, widths, strict=True):
        outer = 1e3 * np.array(record["composite_half_width_m"]["outer"])
        t0, t1 = curve.domain
        s = curve.arc_length(np.linspace(t0, t1, outer.size))
        assert np.abs(width(s) / 2 - outer).max() < 0.1


@pytest.mark.parametrize("number", range(0, 16, 5))
def test_laminated_as_published_with_the_exact_section(pot, widths, number):
    """Thickness of base over backing 1/2 as in the paper."""
    rod = ec.optimal_rod(pot[number][0])
    style = Laminated(width=widths[number], backing=card(0.2), least_backing=0.5)
    strip = ec.Strip(rod, card(0.1), style=style)
    s = np.linspace(0.0, rod.length, 1000)
    section = LaminatedSection(card(0.1), card(0.2)).on(strip.width(s))
    made = section.bending_stiffness(np.minimum(strip.layout.backing.width(s), strip.width(s)))
    assert np.abs(made / (strip.bending_stiffness * rod.profile(s)) - 1).max() < 1e-5
    assert strip.deviation_as_built < 0.01


@pytest.mark.parametrize("number", range(0, 16, 5))
def test_laminated_under_the_weight_of_both_layers(pot, widths, number):
    """Footnote 4 of the paper: what is cut, weighed as it is, hangs within 0.1 mm of the published curve."""
    section = LaminatedSection(card(0.1), card(0.2))
    options = {"direction": (0, -1), "least_backing": 0.5}
    laminate = optimal_laminate(pot[number][0], section, widths[number], **options)
    style = Laminated(width=widths[number], backing=card(0.2), least_backing=0.5)
    strip = ec.Strip(laminate.rod, card(0.1), style=style)
    assert ec.stability(laminate.rod).stable
    assert strip.deviation_as_built < 0.1
    weightless = ec.Strip(ec.optimal_rod(pot[number][0]), card(0.1), style=style)
    hanging = replace(weightless.as_built, gravity=laminate.rod.gravity, weight=strip.as_built.weight)
    assert np.abs(ec.bend(hanging).position - hanging.position).max() > 0.1


def test_the_other_way_round_is_refused_with_the_thickness_that_would_do(pot, widths):
    with pytest.raises(InputError, match=r"make the backing at least (0\.9|1\.0)\d* times as thick"):
        ec.Strip(
            ec.optimal_rod(pot[0][0]),
            card(0.2),
            style=Laminated(width=widths[0], backing=card(0.1), least_backing=0.5),
        )


@pytest.mark.parametrize("number", [1, 9])
def test_perforated_two_by_three_in_touching_outlines(pot, widths, number):
    rod = ec.optimal_rod(pot[number][0])
    style = Perforated(width=widths[number], columns=2, rows=3, hole_ratio=0.95)
    strip = ec.Strip(rod, CARD, style=style)
    s = (np.arange(1000) + 0.5) * rod.length / 1000
    left = strip.layers[0].material(s) / rod.profile(s)
    assert np.abs(left / np.median(left) - 1).max() < 0.005
    assert strip.deviation_as_built < 0.01
