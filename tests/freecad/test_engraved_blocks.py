"""Engraved letters in FreeCAD's own kernel: every letter leaves a valid body."""

import pytest
from freecad.elastica_wb.curves import part_shapes

from elastica_cad import Frame, Path
from elastica_cad.model.fixtures import engraved
from elastica_cad.strip import FlatSolid, PrismSolid, Text, text_strokes


@pytest.mark.campaign
@pytest.mark.parametrize(
    "text",
    [
        "ABCDEFGHI",
        "JKLMNOPQR",
        "STUVWXYZ",
        "abcdefghi",
        "jklmnopqr",
        "stuvwxyz",
        "0123456789",
        "-:+#&%_.*?Ø=",
    ],
)
def test_letters(text):
    strokes = text_strokes(Text((0, 0), text, 4.0))
    letters = tuple(engraved(strokes, 4.0, Frame()))
    block = FlatSolid(Path.rectangle(50, 12, corner=(-2, -4)), (), 4.0, Frame().shifted(z=-4))
    marked = part_shapes.make_solid(PrismSolid((block,), letters))
    assert marked.isValid()
    marked.check(True)
    assert len(marked.Solids) == 1
    assert 0.3 * len(text) < block.volume - marked.Volume < 2.5 * len(text)
