"""What a person meets who makes mistakes, in a real window with a real mouse."""

import importlib.util
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("freecad_launching", Path(__file__).with_name("launching.py"))
launching = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(launching)


@pytest.mark.campaign
def test_what_goes_wrong_is_in_sight_and_is_undone(tmp_path):
    found = launching.run_window("mishaps.py", tmp_path)
    lying = {"Strip flat", "Strip001 flat"}
    failing = {"Strip": True, "Strip001": True, "Model": False} | dict.fromkeys(lying, False)
    standing = {name: not shown for name, shown in failing.items()}
    assert "touch along a line" in found["told in the panel"]
    assert found["made in error"] == found["within again"] == failing
    assert found["apart"] == found["undone"] == standing
    assert found["marked"] == [[]] * 6
    rises = (200, 300, 200, 0, 200, 300)
    for heights, rise in zip(found["in containers"], rises, strict=True):
        assert heights == pytest.approx([height + rise for height in found["before"]]), (
            "the sketch comes along"
        )
    assert found["filled"] == "Face"
    assert found["strip on it"].startswith("A flat strip can be bent into this curve.")
    assert "B-spline through their ends" in found["lines"][0]
    assert found["lines"][1] == 0
    assert "polyline of 3 straight pieces" in found["polygon"]


@pytest.mark.campaign
def test_a_point_is_a_comma_where_numbers_are_written_with_one(tmp_path):
    """FreeCAD takes it for one of thousands: 12.5 mm were 125 mm, and shown as 12.5."""
    found = launching.run_window("decimals.py", tmp_path, language="German")
    assert found["12,5"] == found["12.5"]
    text, value = found["12.5"]
    assert text.startswith("12,5")  # with the unit and two decimals or without, by the release
    assert value == 12.5
    assert found["angle"] == 0.5


@pytest.mark.campaign
def test_files_that_are_gone_and_edges_behind_links(tmp_path):
    found = launching.run_window("lost.py", tmp_path)
    assert found["tracebacks"] == 0
    missing = {
        "file": f"Imported reads {tmp_path}/spline.brep, which is missing. Restore the file, or choose another "
        'file in property "File Name", and recompute the document.',
        "document": "Curve links to Sketch in source.FCStd, which is missing. Restore or open the file, and "
        "recompute the document.",
    }
    for kind, sentence in missing.items():
        seen, reasons, volume = found[f"{kind} there"]
        assert all(seen.values())
        assert not any("missing" in reason for reason in reasons)
        assert found[f"{kind} lost, told"] == [f"Strip, Strip flat, Nest, Fixtures: {sentence}"]
        assert found[f"{kind} lost"] == [dict.fromkeys(seen, False), [sentence], volume]
        assert found[f"{kind} found"] == found[f"{kind} there"]
    lost = missing["file"]
    assert found["told again"] == found["file found, told"] == []
    assert found["panels"] == [lost, f"There is no strip.\n{lost}"]
    assert found["export"] == f"Strip is left out: {lost}"
    seen, reasons, volume = found["numbers there"]
    (message,) = found["numbers lost, told"]
    assert message.startswith(
        'Strip, Strip flat, Nest, Fixtures: FreeCAD cannot compute the formula of "Largest width" ('
    )
    sentence = message.partition("Fixtures: ")[2]
    assert sentence.endswith("). Correct or remove the formula.")
    assert found["numbers lost"] == [dict.fromkeys(seen, False), [sentence], volume]
    assert found["panel of the formula"] == f"There is no strip.\n{sentence}"
    assert found["export of the formula"] == f"Strip is left out: {sentence}"
    assert found["numbers found"] == [seen, reasons, volume]
    assert all(seen.values())
    arch = ["Up-to-date", pytest.approx(50), pytest.approx(90.4, abs=0.5), pytest.approx(20)]
    for picked in ("Body", "Linked body", "Linked part"):
        assert found[picked] == arch, "the strip is where the edge was seen"
    assert found["all follow"] == pytest.approx([30, 30, 80])
    assert found["coupon refused"].startswith("/proc/coupon.dxf cannot be written: ")
    assert found["coupon"] == f"wrote {tmp_path}/Prüf #1.dxf"
