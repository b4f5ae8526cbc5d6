"""Asks the rows of the tables in the explanations: curves are judged, causes computed, other tests named."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from tests.manual.found_in_pages import ROOT, blocks_of, tables
from tests.manual.proofs import asks, proved_by

EXPLAINED = "docs/explanation"
VALIDATION = "tests/validation"
CHECK = "tests/unit/mechanics/test_equilibrium_check.py"


@asks(f"{EXPLAINED}/which_curves.md", "curve", "verdict")
def _verdicts(row, _):
    def verdict(points, degree=3):
        return ec.check_equilibrium(ec.PlaneCurve.spline(points, degree=degree)).realizable

    if row[0].startswith("bends to one side"):
        assert verdict([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    elif row[0].startswith("no inflection, but"):
        assert not verdict([(-100, 60), (-50, -60), (0, 60), (50, -60), (100, 60)], 4)  # y = x^4
    elif row[0].startswith("straight pieces"):
        proved_by(
            "tests/unit/model/test_straight_ends.py::"
            "test_straight_ends_become_tabs_of_that_length_with_holes_where_circles_are_drawn"
        )
    elif row[0].startswith("a straight piece"):
        bent = [(0, -60), (20, -20), (40, 0), (60, 0), (80, 0), (100, 0), (120, 20), (140, 60)]
        assert not verdict(bent)
    elif row[0] == "straight":
        assert verdict([(0, 0), (60, 0), (120, 0), (180, 0)])
    elif row[0] == "one inflection":
        proved_by(f"{CHECK}::test_no_line_through_one_inflection")
    else:
        assert row[0] == "two or more inflections"
        assert verdict([(-150, 0), (-100, 60), (-50, -60), (0, 0), (50, 60), (100, -60), (150, 0)])
        assert not verdict([(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)])


@asks(f"{EXPLAINED}/stability.md", "rating", "meaning", "margin")
def _words(row, _):
    """The rating and its meaning are those that every front end shows."""
    rod = ec.optimal_rod(ec.PlaneCurve.ellipse((0, 0), (100, 130), start=0, end=math.pi))
    margin = {"below 0": -0.1, "0 to 5": 4.9, "above 5": 5.1}[row[2]]
    result = replace(ec.stability(rod), margin=margin, stable=margin > 0)
    assert (result.rating, result.meaning) == row[:2]


def measured(head, part):
    """Rows of one of the tables of finite elements whose first cell begins so."""
    (table,) = [
        one for one in tables() if one.page == "docs/finite_elements.md" and one.head[: len(head)] == head
    ]
    return [row for row in table.rows if row[0].startswith(part)]


@asks(f"{EXPLAINED}/left_out.md", "left out", "how large", "what is done")
def _left_out(row, _):
    result = [float(number) for number in re.findall(r"[\d.]+e-\d", row[1])]
    of = {
        "anticlastic stiffening": "plain, nu 0.3",
        "slots make a strip softer": "slotted, nu 0.3",
        "inclined ligaments": "perforated, nu 0.3",
        "tabs that are narrower": "narrow tabs, nu 0.3",
    }
    cause = next((words for words in of if row[0].startswith(words)), None)
    if cause is not None:
        ((_, deviations, *_),) = measured(("strips", "not corrected"), of[cause])
        assert f"{result[0]:.1e} ({result[1]:.1e})" == deviations, "docs/finite_elements.md was measured anew"
    elif row[0].startswith("clearance in slots"):
        pockets = measured(("strip", "length (mm)", "finite elements (mm)"), "Pavilion")
        assert result == [
            pytest.approx(max(float(far) / float(long) for _, long, far, _ in pockets), rel=0.05)
        ]
    elif row[0].startswith("a step of the width"):
        proved_by(f"{VALIDATION}/test_steps_of_width.py::test_reported_as_finite_elements_have_it")
    elif row[0].startswith("compression along"):
        proved_by("tests/unit/mechanics/test_axial_elasticity.py::test_a_clamped_slat_is_a_chain_of_springs")
    elif row[0].startswith("twist"):
        words = {row[3] for row in measured(("strip", "width (mm)", "sideways"), "")}
        assert words <= {"stable", "close to tipping", "unstable", "undecided"}
    else:
        assert row[0] == "creep"
        proved_by(f"{VALIDATION}/test_creep.py::test_without_weight_the_shape_stays_and_the_forces_fall")


NEAREST = "tests/unit/form_finding/test_nearest_rod.py"
TESTS_OF_TASKS = {
    "zeros of the curvature": "tests/unit/geometry/test_bernstein.py::test_all_roots_of_random_products",
    "crossings of curve and inflection line": f"{CHECK}::test_line_through_two_inflections_crossing_a_third_time",
    "least ratio (Eqs. 4 and 6)": f"{VALIDATION}/test_optimal_ratios.py::test_same_ratio_as_the_full_program",
    "a curve that cannot be bent": f"{NEAREST}::test_near_curve_is_realizable_and_requests_the_limit",
    "stability (Algorithm 2)": f"{NEAREST}::test_an_unstable_wave_becomes_stable",
    "rest shape": "tests/unit/mechanics/test_rest_shape.py::test_it_converges_to_the_drawn_curve",
    "slots": "tests/unit/model/test_interlock.py::test_all_crossings_are_found_and_exact",
    "layers glued on": f"{VALIDATION}/test_laminate_section.py::test_error_of_the_published_formula",
    "cutting curves": "tests/unit/formats/test_cutting_files.py::test_splines_keep_their_knots",
}


@asks(f"{EXPLAINED}/algorithms.md", "task", "the paper", "here", "why")
def _algorithms(row, _):
    """What is exact here is asked by a test of its own."""
    proved_by(TESTS_OF_TASKS[row[0]])


@asks(f"{EXPLAINED}/reproduce_the_paper.md", "figure", "the paper", "here")
def _figures(row, _):
    """Every number is printed by a call of the page, which `test_a_page_does_what_it_says` runs."""
    page = (ROOT / EXPLAINED / "reproduce_the_paper.md").read_text(encoding="utf-8")
    printed = "".join(block.body for block in blocks_of(page) if block.kind == "text")
    numbers = re.findall(r"\d+\.\d+|\b\d+(?= mm)", row[2])
    assert numbers
    assert [number for number in numbers if not re.search(rf"\b{re.escape(number)}\b", printed)] == []


@asks("docs/how_to/holding.md", "cause", "remedy")
def _what_helps(row, _):
    """Each remedy in the table leaves less."""
    tests = "tests/unit/model/test_holding.py"
    arch = ec.PlaneCurve.ellipse((0, 0), (100, 130), start=0, end=math.pi)

    def strayed(**options):
        return (
            ec.make_strip(arch, options.pop("sheet", "birch-plywood-0.8"), **{"max_width": 40, **options})
            .held()
            .deviation
        )

    if row[0].startswith("a tab that is not perpendicular"):
        proved_by(f"{tests}::test_an_inclined_tab_rocks_in_one_plate_and_not_in_two")
        proved_by(f"{tests}::test_two_rings_hold_a_surface_of_revolution_at_its_angle")
    elif row[0].startswith("a tab has clearance"):
        proved_by(f"{tests}::test_play_moves_the_shape_and_a_leaning_pocket_makes_up_for_it")
    elif row[0].startswith("a tab narrower"):
        narrow, wide = ec.Tab(15, width=10), ec.Tab(15)
        assert strayed(ends=(wide, wide)) < strayed(ends=(narrow, narrow))
    elif row[0].startswith("slots for"):
        slots = (ec.Slot(150, 1.0, side="lower"),)
        assert strayed(slots=slots, compensate=True) < 0.5 * strayed(slots=slots)
    elif row[0].startswith("where two arcs"):
        proved_by(f"{VALIDATION}/test_steps_of_width.py::test_reported_as_finite_elements_have_it")
        proved_by(f"{VALIDATION}/test_steps_of_width.py::test_widths_make_up_for_them")
    elif row[0].startswith("a wide strip"):
        assert strayed(sheet="card-200gsm", compensate=True) < 0.5 * strayed(sheet="card-200gsm")
        proved_by(
            f"{VALIDATION}/test_plate_widths.py::test_a_strip_takes_its_curve_by_default_where_nu_is_known"
        )
    elif row[0].startswith("a long strip"):

        def joined(lap, **options):
            return strayed(shop=ec.FabricationLimits(stock=(250, 100), lap=lap), **options)

        assert joined(20.0, compensate=True) < 0.5 * joined(20.0)
        assert strayed() < joined(10.0) < joined(20.0)
    else:
        assert row[0].startswith("a closed strip")
        proved_by("tests/unit/strip/test_closed_strips.py::test_widths_make_up_for_the_lap_and_close")
        proved_by("tests/unit/strip/test_closed_strips.py::test_the_lap_straightens_the_joint_as_reported")


BETWEEN = f"{EXPLAINED}/between_the_ends.md"


@asks(BETWEEN, "strip", "distance", "force computed", "by finite elements", "difference")
def _forces(row, _):
    ((_, distance, computed, found),) = measured(("strip", "deviation", "force computed (N)"), row[0])
    forces = [float(cell.removesuffix(" N")) for cell in row[2:4]]
    assert float(row[1]) == pytest.approx(float(distance), rel=0.05)
    assert forces == pytest.approx([float(computed), float(found)], abs=6e-4)
    assert float(row[4].removesuffix(" %")) == pytest.approx(
        100 * (float(found) / float(computed) - 1), abs=0.06
    )


@asks(BETWEEN, "element", "made as", "force on the strip")
def _elements(row, _):
    tests = f"{VALIDATION}/test_forces_between_ends.py"
    if row[0].startswith("`PointMass"):
        proved_by(f"{tests}::test_three_supports")
    elif row[0].startswith("`Tie"):
        proved_by(f"{tests}::test_even_bow")
    else:
        proved_by(f"{tests}::test_the_least_ratio_is_that_of_a_dense_program")


(POSSIBLE,) = (
    table.head for table in tables() if table.page == BETWEEN and table.head[0] == "control points"
)


def _is_possible(curve, most, between=()):
    try:
        return ec.optimal_rod(curve, between=between).ratio <= most
    except ec.ElasticaError:
        return False


@asks(BETWEEN, *POSSIBLE)
def _possible_curves(row, _):
    """The curves of the row are drawn again, and judged without elements and with one rail."""
    rng, judged = np.random.default_rng(69), []
    most = np.inf if row[0].endswith("any ratio") else 8
    for points in range(6, int(row[0][0]) + 1):
        heights = [rng.uniform(-60, 60, points) for _ in range(60)]
    for y in heights:
        curve = ec.PlaneCurve.spline(np.column_stack([np.linspace(0, 300, len(y)), y]), degree=5)
        rails = (ec.Rail(curve.length * i / 12) for i in range(1, 12))
        none = _is_possible(curve, most)
        judged.append((none, none or any(_is_possible(curve, most, rail) for rail in rails)))
    result = [float(row[POSSIBLE.index(name)]) for name in ("none", "one rail")]
    assert 100 * np.mean(judged, axis=0) == pytest.approx(result, abs=0.51 + 100 / 60)


@asks(BETWEEN, "computation", "with rails, pins, ties and point forces")
def _what_knows_of_elements(row, _):
    tests = "tests/unit/mechanics/test_elements.py"
    if row[1].startswith("yes"):
        proved_by(f"{tests}::test_lambda_steps_by_the_forces")
    elif row[1].startswith("command line and Python"):
        proved_by("tests/unit/cli/test_bow_command.py::test_an_even_rod_prints_what_a_shorter_cord_does")
    else:
        assert row[1].startswith(("refused", "not computed")), row
        proved_by(f"{tests}::test_other_studies_refuse_them")
