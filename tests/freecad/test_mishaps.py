"""What a person meets who makes mistakes, in a real window with a real mouse."""

import importlib.util
from pathlib import Path

_spec = importlib.util.spec_from_file_location("freecad_launching", Path(__file__).with_name("launching.py"))
launching = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(launching)


def test_what_goes_wrong_is_in_sight_and_is_undone(tmp_path):
    found = launching.run_window("mishaps.py", tmp_path)
    lying = {"Strip flat", "Strip001 flat"}
    failing = {"Strip": True, "Strip001": True, "Model": False} | dict.fromkeys(lying, False)
    standing = {name: not shown for name, shown in failing.items()}
    assert "touch along a line" in found["told in the panel"]
    assert found["made in error"] == found["within again"] == failing
    assert found["apart"] == found["undone"] == standing
    assert found["marked"] == [[]] * 6
    assert found["filled"] == "Face"
    assert found["strip on it"].startswith("A flat strip takes this curve.")
    assert "B-spline through their ends" in found["lines"][0]
    assert found["lines"][1] == 0
    assert "polyline of 3 straight pieces" in found["polygon"]


def test_a_point_is_a_comma_where_numbers_are_written_with_one(tmp_path):
    """FreeCAD takes it for one of thousands: 12.5 mm were 125 mm, and shown as 12.5."""
    found = launching.run_window("decimals.py", tmp_path, language="German")
    assert found["12,5"] == found["12.5"]
    text, value = found["12.5"]
    assert text.startswith("12,5")  # with the unit and two decimals or without, by the release
    assert value == 12.5
    assert found["angle"] == 0.5
