"""The example of a slat on a rail under a load of 8 kg."""

import runpy

import pytest

import elastica_cad as ec


def test_a_slat_on_a_rail_carries_8_kg(project_root, capsys):
    slat, loaded = runpy.run_path(str(project_root / "examples" / "slat" / "slat.py"))["main"]()
    assert "safety 1.9" in capsys.readouterr().out
    ends = loaded.bending_stiffness * (loaded.force[0] - loaded.force[-1])
    assert ends == pytest.approx([0, 8 * 9.80665], abs=0.01)
    assert not loaded.between[0].force.any(), "the load lifts the slat off the bar above it"
    assert slat.rod.between[0].force[0, 1] < 0
    assert ec.stability(loaded).rating == "stable"
