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
    assert piece.length == pytest.approx(13)


def test_a_bar_ends_before_the_legs():
    """The stroke that would be divided stays whole; the one that ends there is shortened."""
    strokes = [Path.polyline([(0, 0), (3, 0)]), Path.polyline([(1.5, 0), (1.5, 6)])]
    foot, stem = sorted(stencil_strokes(strokes, WIDTH, GAP), key=lambda piece: piece.length)
    assert foot.length == pytest.approx(3)
    assert stem.length == pytest.approx(6 - WIDTH / 2 - GAP, abs=0.05)


def test_arcs_about_one_centre_are_one():
    [ring] = stencil_strokes(text_strokes(Text((0, 0), "°", 6.0)), WIDTH / 4, GAP / 4)
    assert isinstance(ring, Arc)
    assert abs(ring.sweep) == pytest.approx(2 * np.pi)


@pytest.mark.parametrize("height", [1.5, 4.0])
@pytest.mark.parametrize("letter", string.ascii_letters + string.digits + "-_+=/()[]<>*#%&!?:;.,")
def test_pieces_of_every_letter_keep_apart(letter, height):
    scale = height / 4
    strokes = text_strokes(Text((0, 0), letter, height))
    found = stencil_strokes(strokes, scale * WIDTH, scale * GAP)
    rows = [shapely.LineString(piece.at(np.linspace(0, 1, 60))) for piece in found]
    areas = [row.buffer(scale * WIDTH / 2, cap_style="flat") for row in rows]
    for k, one in enumerate(areas):
        assert all(one.distance(other) > 0.5 * scale * GAP for other in areas[:k])
    drawn = shapely.MultiLineString([stroke.points(0.01) for stroke in strokes])
    assert drawn.difference(shapely.union_all(areas).buffer(0.75 * scale)).length < 0.05 * drawn.length


def test_letters_of_a_long_text_are_those_that_stand_alone():
    """Each piece asks its neighbours only: eighty letters take no minutes."""
    text = "STRIP 17 OF THE PAVILION, BENT BY HAND: " * 2
    together = stencil_strokes(text_strokes(Text((0, 0), text, 4.0)), WIDTH, GAP)
    alone = [
        piece.length
        for letter in text.replace(" ", "")
        for piece in stencil_strokes(text_strokes(Text((0, 0), letter, 4.0)), WIDTH, GAP)
    ]
    assert sorted(piece.length for piece in together) == pytest.approx(sorted(alone), abs=0.02)
