"""Engraved strokes as stencils have them: apart from each other, and of most of what was drawn."""

import string

import numpy as np
import pytest
import shapely

from elastica_cad.fabrication.drawings.lettering import Text, text_strokes
from elastica_cad.fabrication.drawings.stencil_strokes import stencil_strokes
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc

WIDTH, GAP = 0.6, 0.16


def test_a_straight_stroke_stays_whole():
    [piece] = stencil_strokes([Path.polyline([(2, 1), (14, 6)])], WIDTH, GAP)
    assert piece.way.length == pytest.approx(13)
    assert piece.turns == (None, None)


def test_a_bar_ends_before_the_legs():
    """The stroke that would be divided stays whole; the one that ends there is shortened."""
    strokes = [Path.polyline([(0, 0), (3, 0)]), Path.polyline([(1.5, 0), (1.5, 6)])]
    foot, stem = sorted(stencil_strokes(strokes, WIDTH, GAP), key=lambda piece: piece.way.length)
    assert foot.way.length == pytest.approx(3)
    assert stem.way.length == pytest.approx(6 - WIDTH / 2 - GAP, abs=0.05)


def test_arcs_about_one_centre_are_one():
    [ring] = stencil_strokes(text_strokes(Text((0, 0), "°", 6.0)), WIDTH / 4, GAP / 4)
    assert isinstance(ring.way, Arc)
    assert abs(ring.way.sweep) == pytest.approx(2 * np.pi)


@pytest.mark.parametrize("height", [1.5, 4.0])
@pytest.mark.parametrize("letter", string.ascii_letters + string.digits + "-_+=/()[]<>*#%&!?:;.,")
def test_pieces_of_every_letter_keep_apart_or_go_on(letter, height):
    scale = height / 4
    strokes = text_strokes(Text((0, 0), letter, height))
    found = stencil_strokes(strokes, scale * WIDTH, scale * GAP)
    rows = [shapely.LineString(piece.way.at(np.linspace(0, 1, 60))) for piece in found]
    areas = [row.buffer(scale * WIDTH / 2, cap_style="flat") for row in rows]
    joints = 0
    for k, one in enumerate(found):
        for i, other in enumerate(found[:k]):
            turns = {turn for pair in (ending(one, other), ending(other, one)) for turn in pair}
            assert len(turns) <= 1
            joints += len(turns)
            assert turns or areas[k].distance(areas[i]) > 0.5 * scale * GAP
    ends = sum(turn is not None for piece in found for turn in piece.turns)
    assert ends == 2 * joints or (len(found) == 2 and ends == 4)
    drawn = shapely.MultiLineString([stroke.points(0.01) for stroke in strokes])
    assert drawn.difference(shapely.union_all(areas).buffer(0.75 * scale)).length < 0.05 * drawn.length


def ending(one, other):
    """The turn from the end of one piece to the start of another, where they go on in each other."""
    meet = np.hypot(*(one.way.end - other.way.start)) < 1e-6
    if not meet or one.turns[1] is None:
        return ()
    assert one.turns[1] == other.turns[0]
    along, after = one.way.tangent_at(1.0), other.way.tangent_at(0.0)
    assert np.cos(one.turns[1]) == pytest.approx(along @ after, abs=1e-9)
    return (one.turns[1],)


def test_a_bowl_goes_on_smoothly_and_its_corner_is_mitred():
    """P: the stem turns right into the bowl, which ends before it comes back."""
    pieces = stencil_strokes(text_strokes(Text((0, 0), "P", 4.0)), WIDTH, GAP)
    corner = pytest.approx(-np.pi / 2)
    for turns in ((None, corner), (corner, 0.0), (0.0, 0.0), (0.0, None)):
        assert sum(piece.turns == turns for piece in pieces) == 1


def test_sharp_corners_keep_a_gap():
    pieces = stencil_strokes(text_strokes(Text((0, 0), "V", 4.0)), WIDTH, GAP)
    assert [piece.turns for piece in pieces] == [(None, None)] * 2


def test_letters_of_a_long_text_are_those_that_stand_alone():
    """Each piece asks its neighbours only: eighty letters take no minutes."""
    text = "STRIP 17 OF THE PAVILION, BENT BY HAND: " * 2
    together = stencil_strokes(text_strokes(Text((0, 0), text, 4.0)), WIDTH, GAP)
    alone = [
        piece.way.length
        for letter in text.replace(" ", "")
        for piece in stencil_strokes(text_strokes(Text((0, 0), letter, 4.0)), WIDTH, GAP)
    ]
    assert sorted(piece.way.length for piece in together) == pytest.approx(sorted(alone), abs=0.02)
