"""What a person met without being told, in a real window with a real mouse."""

import csv
import importlib.util
import io
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("freecad_launching", Path(__file__).with_name("launching.py"))
launching = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(launching)


@pytest.mark.campaign
def test_what_is_easily_overlooked_is_reported(tmp_path):
    found = launching.run_window("untold.py", tmp_path)
    bend = "Before assembly, bend the strip to a radius of 250 mm along its whole length. The inner face of "
    verdict, reason, *_ = found["blank"].splitlines()
    assert verdict == "A pre-bent strip can be bent into this curve."
    assert reason.startswith(bend)
    assert found["blank, flat part"].startswith(f"Strip: {bend}")
    assert f"Strip: {bend}" in found["blank, export"]
    assert found["blank, written"].splitlines()[-1].startswith(f"Strip: {bend}")
    (row,) = csv.DictReader(io.StringIO(found["blank, cut list"]))
    assert row["bent_beforehand"].startswith(bend)
    words = "a later feature of its body. Use the slots"
    assert found["nest told"].startswith(f"The nest shows Strip without Notch, {words}")
    assert found["nest"].startswith(f"The nest shows Strip without Notch, Rounded, {words}")
    assert found["nest of the strip alone"] == [[], ""]
    formula = "Strip.Style has the formula Cells.A1, which gives 4. Use 0 to 2, or a name such as <<Plain>>. "
    assert found["formula"] == f"There is no strip.\n{formula}Correct or remove the formula."
    assert found["formula mended"] == ["Perforated", "Up-to-date"]
    assert found["body without a sketch"] == (
        "Body has no sketch for a strip. Draw a spline in a separate sketch, or select the edge for the strip."
    )
    several = "Body has several sketches (Drawn, Profile). Select the sketch for the strip."
    assert found["body with two sketches"] == several
    assert found["body and its sketch"] == [["Drawn", []]]
    assert found["body"] == ["Drawn", "A flat strip can be bent into this curve.", ["Up-to-date"]]
    takes = "A flat strip can be bent into this curve."
    assert found["pasted with its sketch"] == ["Behind", takes, [], True, 0]
    missing = 'The curve is missing: choose a sketch or an edge in "Curve"'
    assert found["pasted alone"] == [None, "There is no strip.", [missing], False, 0]
    assert found["shear of birch"] == pytest.approx(620)
    assert found["shear kept"] == [600, True]
    assert found["shear of card"] == found["shear emptied"] == "E / (2 (1 + ν))"
    assert found["shear estimated"] == [None, False]
    assert [found["closed with its document"], found["buttons left"]] == [True, False]
    assert found["the other's step"], "what is begun in another document is not taken back"
    text, hidden, _ = found["deleted"]
    assert text.splitlines()[0] == "The edited object was deleted. Press Cancel."
    assert not hidden
