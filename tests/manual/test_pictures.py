"""Pictures of the manual are those that their scripts draw."""

import importlib.util
from pathlib import Path

import matplotlib.image
import numpy as np

DOCS = Path(__file__).resolve().parents[2] / "docs"


def test_the_steps_of_the_theorem_are_drawn_by_the_functions_that_decide(tmp_path, monkeypatch):
    spec = importlib.util.spec_from_file_location("theorem_picture", DOCS / "theorem_picture.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    told = matplotlib.image.imread(script.PICTURE)
    monkeypatch.setattr(script, "PICTURE", tmp_path / "theorem1.png")
    script.main()
    drawn = matplotlib.image.imread(script.PICTURE)
    assert drawn.shape == told.shape
    assert np.abs(drawn - told).mean() < 0.01, "draw it again: python docs/theorem_picture.py"
