import string

import numpy as np
import pytest

from elastica_cad import InputError
from elastica_cad.strip import Text, text_strokes, text_width

pytestmark = pytest.mark.core

LETTERS = string.ascii_letters + string.digits
PUNCTUATION = ".,:;-_+=/\\|()[]<>*#%&!?'\"°×±Ø"


def box(strokes):
    return np.array([min(s.bounds[0, i] for s in strokes) for i in (0, 1)]), np.array(
        [max(s.bounds[1, i] for s in strokes) for i in (0, 1)]
    )


@pytest.mark.parametrize("character", LETTERS + PUNCTUATION)
def test_every_character_fits_its_width_and_height(character):
    strokes = text_strokes(Text((0, 0), character, 6.0))
    assert strokes
    low, high = box(strokes)
    assert low[0] >= -1e-9
    assert high[0] <= text_width(character, 6.0) + 1e-9
    assert low[1] >= -2 - 1e-9
    assert high[1] <= 6.5 + 1e-9
    if character in string.ascii_uppercase + string.digits:
        assert (low[1], high[1]) == pytest.approx((0, 6), abs=1e-5)


def test_characters_differ():
    def drawing(character):
        rows = [s.points(0.05) for s in text_strokes(Text((0, 0), character, 6.0))]
        return tuple(np.round(np.concatenate(rows), 3).ravel())

    assert len({drawing(c) for c in LETTERS + PUNCTUATION}) == len(LETTERS + PUNCTUATION)


def test_strokes_are_smooth_where_arcs_join():
    for character in "OCGQS0689acdeobpq":
        for stroke in text_strokes(Text((0, 0), character, 6.0)):
            turns = [
                a.tangent_at(1.0) @ b.tangent_at(0.0)
                for a, b in zip(stroke.segments[:-1], stroke.segments[1:], strict=True)
            ]
            # straight on, or one of the letter's own sharp corners
            assert all(turn > 0.9999 or turn < 0.95 for turn in turns)


def test_text_is_placed_turned_and_scaled():
    flat = text_strokes(Text((0, 0), "Strip A1", 6.0))
    moved = text_strokes(Text((10, 20), "Strip A1", 3.0, np.pi / 2))
    for a, b in zip(flat, moved, strict=True):
        p, q = a.points(0.01), b.points(0.005)
        assert len(p) == len(q)
        assert np.allclose(q, np.column_stack([10 - p[:, 1] / 2, 20 + p[:, 0] / 2]), atol=1e-12)


def test_width_adds_up():
    low, high = box(text_strokes(Text((0, 0), "HEEH", 6.0)))
    assert (low[0], high[0]) == pytest.approx((0, text_width("HEEH", 6.0)))
    assert text_width("HEEH", 12.0) == pytest.approx(2 * text_width("HEEH", 6.0))
    assert text_width("", 6.0) == 0
    assert text_strokes(Text((0, 0), "", 6.0)) == ()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (((0, 0), "Größe", 5.0), "alphabet has no 'ö'"),
        (((0, 0), "a\nb", 5.0), "alphabet has no"),
        (((0, 0), "a", 0.0), "a height above 0"),
        (((0, 0), "a", np.nan), "a height above 0"),
        (((0, np.inf), "a", 1.0), "finite position"),
    ],
)
def test_bad_texts_are_refused(arguments, message):
    with pytest.raises(InputError, match=message):
        Text(*arguments)
