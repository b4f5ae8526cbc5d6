"""What a notebook shows: short words, pictures that a parser reads, tables whose texts are text."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from elastica_cad import (
    Limits,
    Model,
    NearestRod,
    Placed,
    PlaneCurve,
    Sheet,
    Strip,
    check_equilibrium,
    nearest_rod,
    optimal_rod,
)
from elastica_cad.strip import CUT_OUTER
from elastica_cad.strip.summary import strip_rows

pytestmark = pytest.mark.core

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
LOOP = PlaneCurve.spline([(0, 0), (200, 100), (-100, 100), (100, 0)], 3)


@pytest.fixture(scope="module")
def strip():
    return Strip(optimal_rod(ARCH), Sheet.named("birch-plywood-0.8"), max_width=30.0, label="A<1>")


def test_words_are_short(strip):
    model = Model((Placed(strip),), name="one")
    sheet, *_ = model.nest(sheet_size=(600, 400))
    for record in (ARCH, strip.rod, strip, strip.drawing(), model, sheet, strip.width, *strip.layers):
        assert len(repr(record)) < 120
    assert repr(check_equilibrium(ARCH)).startswith("<EquilibriumCheck realizable, ")
    assert repr(ARCH) == f"<PlaneCurve of degree 4, 5 control points, {ARCH.length:.4g} mm>"
    assert repr(model) == "<Model 'one', 1 strip, 0 joints>"
    assert repr(sheet).startswith("<NestedSheet 'one-nest-1")
    assert repr(strip.width).endswith(f"{strip.width.extremes[0]:.4g} to 30>")
    assert f"ratio {strip.rod.ratio:.4g}" in repr(strip.rod)


def test_pictures_are_sound_and_hold_the_shape(strip):
    near, failed = nearest_rod(ARCH), NearestRod.failure(ARCH, "too wild")
    for record in (ARCH, strip.rod, strip, strip.drawing(), near, failed):
        root = ElementTree.fromstring(record._repr_svg_())
        width, height = float(root.get("width")), float(root.get("height"))
        assert 0 < width <= 640
        assert 0 < height <= 420
        paths = root.findall("{http://www.w3.org/2000/svg}path")
        points = np.array([p.split(",") for path in paths for p in path.get("d").strip("MZ ").split()], float)
        assert points.min() >= 0
        assert points[:, 0].max() <= width
    low, high = strip.drawing().bounds
    root = ElementTree.fromstring(strip._repr_svg_())
    shape = (float(root.get("width")) - 16) / (float(root.get("height")) - 16)
    assert shape == pytest.approx((high - low)[0] / (high - low)[1], rel=0.02)
    assert len(strip.drawing().on(CUT_OUTER)) == 1


def test_a_nearest_rod_is_drawn_over_its_target():
    near = nearest_rod(ARCH, Limits(ratio=1.05))
    drawn, found = ElementTree.fromstring(near._repr_svg_()).findall("{http://www.w3.org/2000/svg}path")
    ends = [[one.get("d").strip("M").split()[i].split(",") for i in (0, -1)] for one in (drawn, found)]
    np.testing.assert_allclose(np.array(ends[0], float), np.array(ends[1], float), atol=0.02)
    assert drawn.get("d") != found.get("d")


def test_a_sheet_is_a_table_of_its_figures():
    table = ElementTree.fromstring(Sheet.named("birch-plywood-0.8")._repr_html_())
    rows = [[cell.text for cell in row] for row in table.findall("tr")]
    assert ["thickness", "0.8", "mm"] in [[name, value, unit] for name, value, _, unit in rows]
    spread = {name: result for name, _, result, _ in rows}
    assert spread["youngs modulus"] == "8200 to 10300"
    assert spread["kerf"] is None or " to " in spread["kerf"]
    assert (
        "<b>" not in Sheet("<b>", thickness=1, youngs_modulus=1e3, density=500, max_strain=0.01)._repr_html_()
    )


def test_a_strip_is_a_picture_and_its_labelled_rows(strip):
    html = strip._repr_html_()
    picture, table, _ = re.split(r"(?<=</svg>)(.*)", html)
    assert picture == strip._repr_svg_()
    rows = [
        (row[0].text, row[1].text, row[1].get("title")) for row in ElementTree.fromstring(table).findall("tr")
    ]
    assert rows == [(row.label, row.text, " ".join(row.details)) for row in strip_rows(strip)]
    tipping = Strip(optimal_rod(LOOP), Sheet.named("birch-plywood-0.8"), max_width=5.0)
    assert "<th>! Stability</th>" in tipping._repr_html_()


def test_a_label_is_text_in_the_table(strip):
    html = Model((Placed(strip),), name="<script>")._repr_html_()
    assert "&lt;script&gt;" in html
    assert "<script>" not in html
    assert "A&lt;1&gt;" in html


def test_tables_have_units_and_physics(strip):
    rod, table = strip.rod.table(), strip.table()
    assert {len(column) for column in (*rod.values(), *table.values())} == {strip.rod.s.size}
    np.testing.assert_allclose(table["moment_Nmm"], strip.bending_stiffness * strip.rod.moment)
    np.testing.assert_allclose(table["width_mm"], strip.width(strip.rod.s))
    reactions = strip.reactions()
    assert -table["force_x_N"][-1] == pytest.approx(reactions.end_force[0])
    assert table["strain"].max() == pytest.approx(strip.max_strain, rel=1e-3)
