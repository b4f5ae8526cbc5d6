"""The example of a lesson: three strips of one length."""

from pathlib import Path

import numpy as np
import pytest

import elastica_cad as ec

LESSON = Path(__file__).parents[2] / "examples" / "lesson" / "lesson.toml"


def test_the_strips_of_the_lesson_have_one_length():
    """The length of each polyline through the nodes is 240 mm, and the strips differ in width."""
    strips = ec.read_model(LESSON).strips
    lengths = [np.hypot(*np.diff(strip.rod.position, axis=0).T).sum() for strip in strips]
    assert lengths == pytest.approx([240] * 3, abs=0.05)
    assert [strip.label for strip in strips] == ["hill", "wave", "cane"]
    assert np.ptp([strip.width.extremes[0] for strip in strips]) > 5
