"""`elastica reshape` and `reshape` in design files: four handles, files that read back, sentences."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.design import read_design
from tests.command_line import run

WAVE = ec.PlaneCurve.spline([(10, 0), (40, 150), (130, 160), (170, 20), (230, -10), (290, 110)])


@pytest.fixture
def wave(tmp_path):
    return ec.write_curves([WAVE], tmp_path / "wave.json")


def test_there_and_back(wave, tmp_path):
    """The second edit undoes the first: files lose nothing of a curve with weights."""
    pulled = [(0, 0, 0, 0), (300, 0, 300, 0), (300, 150, 265, 190), (0, 150, 20, 130)]
    there = [word for row in pulled for word in ("--handle", *row)]
    back = [word for x, y, u, v in pulled for word in ("--handle", u, v, x, y)]
    result = run("reshape", wave, *there, "-o", tmp_path)
    assert (
        "Before      456.84 mm long, inflections at 259.8 mm; a strip can take it, stiffness ratio 9.867"
        in result.output
    )
    assert (
        "After       448.66 mm long, inflections at 223.3 mm; a strip can take it, stiffness ratio 16.71"
        in result.output
    )
    (changed,) = ec.read_curves(tmp_path / "wave-reshaped.json")
    assert changed.is_rational
    s = np.linspace(0, WAVE.length, 50)
    for kind, degree in (("dxf", 4), ("json", 4), ("svg", 3)):
        (read,) = ec.read_curves(tmp_path / f"wave-reshaped.{kind}")
        assert read.degree == degree
        assert read.length == pytest.approx(changed.length, abs=1e-3 if kind == "svg" else 1e-12)
        assert read.is_rational == (kind != "svg")
        if kind == "svg":
            continue
        result = run("reshape", tmp_path / f"wave-reshaped.{kind}", *back, "-o", tmp_path / kind)
        for again in ("dxf", "json"):
            (home,) = ec.read_curves(tmp_path / kind / f"wave-reshaped-reshaped.{again}")
            np.testing.assert_allclose(home.at(s).position, WAVE.at(s).position, atol=1e-9)


def test_corners_that_are_not_named_stay(wave, tmp_path):
    (left, low), (right, high) = WAVE.bounds
    run("reshape", wave, "--top-right", right + 20, high + 40, "-o", tmp_path)
    (changed,) = ec.read_curves(tmp_path / "wave-reshaped.dxf")
    corners = [(left, low), (right, low), (right, high), (left, high)]
    moved = [*corners[:2], (right + 20, high + 40), corners[3]]
    wanted = WAVE.transformed(ec.four_point_map(corners, moved))
    np.testing.assert_allclose(changed.control_points, wanted.control_points, atol=1e-12)


def test_all_curves_of_a_file_share_their_handles(tmp_path):
    arches = [ec.PlaneCurve.arc((x, 0), 40, 0.2, 2.9) for x in (0, 200)]
    file = ec.write_curves(arches, tmp_path / "two.dxf")
    result = run("reshape", file, "--top-right", 300, 90, "-o", tmp_path)
    assert "curve 2 of 2:" in result.output
    first, second = ec.read_curves(tmp_path / "two-reshaped.dxf")
    assert second.bounds[1, 1] - arches[1].bounds[1, 1] > 10
    assert first.bounds[1, 1] - arches[0].bounds[1, 1] < 5
    alone = run("reshape", file, "--curve", 2, "--top-right", 300, 90, "-o", tmp_path, "--force")
    assert "curve 2 of 2:" not in alone.output
    assert len(ec.read_curves(tmp_path / "two-reshaped.dxf")) == 1


def test_what_cannot_be_bent_stays_so(tmp_path):
    t = np.linspace(0.1, 7.8, 200)
    drawn = ec.PlaneCurve.fit(np.column_stack([50 * t, 40 * np.sin(t) + 6 * t**1.6]))
    file = ec.write_curves([drawn], tmp_path / "bad.json")
    result = run("reshape", file, "--top-left", 0, 200, "-o", tmp_path, code=1)
    assert result.output.count("no strip can take it: ") == 2


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ((), "Give a new position of a corner of the frame around the curve (--bottom-left"),
        (("--handle", 0, 0, 1, 1), "--handle moves 4 places at once, but is given 1 times"),
        (("--handle", 0, 0, 1, 1, "--top-left", 3, 4), "--top-left has no effect beside --handle"),
        (("--top-right", 100, 0, "--top-left", 200, 0), "are on one line, through"),
        (("--top-right", 60, 40), "moves the curve near ("),
        (("--top-right", "nan", 40), "--top-right is not finite"),
        (("--handle", 0, 0, 1, "inf"), "--handle is not finite"),
    ],
)
def test_sentences(wave, tmp_path, options, sentence):
    result = run("reshape", wave, *options, "-o", tmp_path, code=2)
    assert sentence in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_flat_box_has_no_corners(tmp_path):
    file = ec.write_curves([ec.PlaneCurve.line((0, 0), (100, 0))], tmp_path / "flat.json")
    result = run("reshape", file, "--top-right", 100, 20, code=2)
    assert "measures 100 by 0 mm, too thin for handles" in result.stderr


DESIGN = """
schema = 1
sheet = "card-200gsm"
max_width = 30

[[strips]]
curve = { ellipse = { semi_axes = [150, 100], start = 0.1, end = "pi - 0.1" }, reshape = RESHAPE }
"""


def read(tmp_path, reshape):
    path = tmp_path / "design.toml"
    path.write_text(DESIGN.replace("RESHAPE", reshape))
    return read_design(path, ec.read_curves)


def test_design_files_reshape_any_curve(tmp_path):
    ellipse = ec.PlaneCurve.ellipse((0, 0), (150, 100), 0.0, 0.1, np.pi - 0.1)
    (left, low), (right, high) = ellipse.bounds
    corners = [(left, low), (right, low), (right, high), (left, high)]
    wanted = ellipse.transformed(ec.four_point_map(corners, [*corners[:2], (120, 130), corners[3]]))
    (wish,) = read(tmp_path, '{ top_right = ["12 * 10", 130] }').entries
    np.testing.assert_allclose(wish.curve.control_points, wanted.control_points, atol=1e-9)
    model = read(
        tmp_path, "{ handles = [[0, 0], [1, 0], [1, 1], [0, 1]], to = [[0, 0], [1, 0], [1, 2], [0, 2]] }"
    )
    assert model.entries[0].curve.bounds[1, 1] == pytest.approx(200)
    assert model.model().strips[0].rod.ratio > 1


@pytest.mark.parametrize(
    ("reshape", "sentence"),
    [
        ("{}", r"curve: reshape: New positions are missing"),
        ("{ middle = [1, 2] }", "unknown key 'middle'"),
        (
            "{ top_left = [1, 2], to = [[1, 2]] }",
            "to has no effect without handles. Set handles, or leave out to",
        ),
        ("{ handles = [[1, 2]], to = [[1, 2]] }", "handles is not a list of four points"),
        ("{ top_right = [0, 0], top_left = [50, 10] }", r"reshape: after: handles|to infinity"),
    ],
)
def test_bad_reshaping_names_its_place(tmp_path, reshape, sentence):
    with pytest.raises(InputError, match=sentence) as found:
        read(tmp_path, reshape)
    assert "strips[1]" in str(found.value)


def test_files_that_cannot_be_written(tmp_path):
    with pytest.raises(InputError, match="there are no curves"):
        ec.write_curves([], tmp_path / "a.dxf")
    with pytest.raises(InputError, match=r"end its name with \.dxf, \.svg, \.json"):
        ec.write_curves([WAVE], tmp_path / "a.step")
    with pytest.warns(UserWarning, match="The copy of curve 1 in a.svg differs"):
        ec.write_curves([WAVE], tmp_path / "a.svg")
    with pytest.raises(InputError, match="exists already"):
        ec.write_curves([WAVE], tmp_path / "a.svg")
