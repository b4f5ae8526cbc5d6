"""Every command of SVG's path data, beside an independent reader and the text of the standard."""

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from elastica_cad import InputError
from elastica_cad.formats.source_file import half_last_place
from elastica_cad.formats.svg_path_data import path_data

svgpathtools = pytest.importorskip("svgpathtools")


def ours(text, count=33):
    """Points on every edge with some length, by runs joined."""
    edges = [edge for run in path_data(text).runs for edge in run]
    return [edge.at(np.linspace(edge.spans.edges[0], edge.spans.edges[-1], count)) for edge in edges]


def _is_place(piece):
    """All its points are one; its `length` fails for a curve that turns back on itself."""
    return len({*piece.bpoints()} if hasattr(piece, "bpoints") else {piece.start, piece.end}) == 1


def theirs(text, count=33):
    path = svgpathtools.parse_path(text)
    points = [np.array([s.point(t) for t in np.linspace(0, 1, count)]) for s in path if not _is_place(s)]
    return [np.column_stack([p.real, p.imag]) for p in points]


def same(text):
    mine, other = ours(text), theirs(text)
    assert len(mine) == len(other)
    for one, two in zip(mine, other, strict=True):
        assert one[[0, -1]] == pytest.approx(two[[0, -1]], abs=1e-6)
        # an arc's parameter differs: points of each lie near the other's
        for a, b in ((one, two), (two, one)):
            steps = np.hypot(*np.diff(b, axis=0).T).max()
            assert max(np.hypot(*(b - p).T).min() for p in a) <= steps


@pytest.mark.parametrize("text", [
    "M10 10 20 20 30 10", "m10 10 20 20 30-10", "M1 1H5V9h-2v-3z", "M0 0C5 10 10 20 30 0S50-20 60 0 70 9 80 0",
    "m0 0c5 10 10 20 30 0s20-20 30 0 10 9 20 0", "M0 0Q10 20 30 0T60 0 90 0t9 9", "M0 0q10 20 30 0t30 0 30 0",
    "M0 0Q10 20 30 0S50 10 60 0", "M0 0C5 10 10 20 30 0T50 10", "M0 0L10 0T20 10T30 0", "M0 0L10 0S20 10 30 0",
    "M0 0A5 5 0 0 1 10 0S20 10 30 0", "M0 0A5 5 0 0 1 10 0T20 10", "M0 0A5 5 0 01 10 0a5 3 30 1020 0",
    "M.5.5L1.5e1-3", "M0,0,10,10", "M0 0 A 5 8 40 0 0 3 3 A 5 8 40 1 0 8 3 A 5 8 40 0 1 12 9 A 5 8 40 1 1 15 9",
    "M0 0A1 1 0 0 1 100 0", "M0 0A-5-5 0 0 1 6 0",
    "M0 0c1 1 2 2 3 3 4 4 5 0 6 6z", "M1 1l5 5 3-9zl5 0",
])  # fmt: skip
def test_commands_as_an_independent_reader_takes_them(text):
    same(text)


number = st.floats(-99, 99).map(lambda x: round(x, 3))
ARGUMENTS = {
    "L": 2, "l": 2, "H": 1, "h": 1, "V": 1, "v": 1, "C": 6, "c": 6, "S": 4, "s": 4, "Q": 4, "q": 4, "T": 2, "t": 2,
}  # fmt: skip


@st.composite
def paths(draw):
    words = ["M", *map(str, draw(st.tuples(number, number)))]
    for command in draw(st.lists(st.sampled_from("LlHhVvCcSsQqTtAa"), min_size=1, max_size=8)):
        if command in "Aa":
            radii = draw(st.tuples(st.floats(5, 60), st.floats(5, 60)))
            flags = draw(st.tuples(st.integers(0, 1), st.integers(0, 1)))
            values = [
                *(round(r, 2) for r in radii),
                draw(st.integers(-90, 90)),
                *flags,
                *draw(st.tuples(number, number)),
            ]
        else:
            values = draw(st.lists(number, min_size=ARGUMENTS[command], max_size=ARGUMENTS[command]))
        words += [command, *map(str, values)]
    return " ".join(words)


@pytest.mark.campaign
@settings(max_examples=80, deadline=None)
@given(text=paths())
@example(text="M 0.562 0.0 q 5.0 1.0 0.0 0.0")
def test_random_paths_as_an_independent_reader_takes_them(text):
    try:
        theirs(text, 3)
    except AssertionError:  # it refuses arcs whose ends are the same
        assume(False)
    mine = [p[[0, -1]] for p in ours(text, 3)]
    other = [p[[0, -1]] for p in theirs(text, 3)]
    mine = [p for p in mine if np.hypot(*(p[1] - p[0])) > 1e-9]
    other = [p for p in other if np.hypot(*(p[1] - p[0])) > 1e-9]
    assert np.array(mine) == pytest.approx(np.array(other), abs=1e-6)


def test_handles_are_reflected_only_after_a_command_of_their_kind():
    """SVG 2, 9.3.6 and 9.3.7: otherwise the first control point is the current point."""
    (run,) = path_data("M0 0 Q 10 20 30 0 S 50 10 60 0 T 90 0").runs
    assert run[1].points[1].tolist() == [30, 0]
    assert run[2].degree == 1  # T after S: its handle is the current point, a straight line


def test_an_arc_without_a_radius_is_a_line():
    assert ours("M0 0A0 5 0 0 1 10 0", 2)[0].tolist() == [[0, 0], [10, 0]]


def test_after_a_closed_subpath_the_pen_is_at_its_start():
    """9.3.4: a command after z other than M begins a subpath at the same start; m after z is relative to it."""
    first, second = path_data("M5 5 L 9 5 L 9 9 z m 1 1 l 3 3").runs
    assert first[-1].points[-1].tolist() == [5, 5]
    assert second[0].points.tolist() == [[6, 6], [9, 9]]


@pytest.mark.parametrize(("text", "after"), [
    ("M 0 0 C 1 2 3", "1 2 3"), ("L 5 5", "beginning"), ("M 0 0 L 5 x", "L 5"), ("M 0 0 A 5 5 0 2 1 9 9", "5 5 0"),
    ("M 0 0 L 1 2 3", "1 2 3"), ("M", "M"), ("0 0 L 5 5", "beginning"), ("M 0 0 R 5 5", "M 0 0"),
])  # fmt: skip
def test_data_that_break_off_are_listed_with_their_place(text, after):
    with pytest.raises(InputError, match="incomplete or invalid") as caught:
        path_data(text)
    assert after in str(caught.value)


@pytest.mark.parametrize("number", ["1e200", "-1e308", "1e999", "9" * 400])
def test_numbers_beyond_all_drawings_are_refused(number):
    with pytest.raises(InputError, match="number"):
        path_data(f"M 0 0 L {number} 5")


@pytest.mark.parametrize(("numbers", "half"), [
    (["12.34", "7.5", "100"], 0.005), (["10", "20", "30"], 0.5), (["10.0"], 0.05), ([], 0.0),
    (["123.45678", "0.0012345678", "12.345678"], 5e-6),  # eight significant digits
    (["19.5", "112", "42.1", "76.3", "198", "2.25"], 0.5),  # three significant digits
    (["33.33", "1200", "7.5"], 0.005), (["12.5", "117.25", "198"], 0.005),
    (["33.333", "66.667", "0.001", "1.2e-15"], 0.0005),
    (["1.5e2", "2e-3"], 0.0005), (["0.1", "100000"], 0.05),
    (["-12.3456789012345", "45.2"], 0.5e-13),
])  # fmt: skip
def test_the_last_written_digit(numbers, half):
    assert half_last_place(numbers) == pytest.approx(half, rel=1e-9)
