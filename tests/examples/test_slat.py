"""The example of a slat on a rail under a load of 8 kg."""

import runpy

import pytest

import elastica_cad as ec


def test_a_slat_on_a_rail_carries_8_kg(project_root, capsys):
    slat, loaded = runpy.run_path(str(project_root / "examples" / "slat" / "slat.py"))["main"]()
    assert "safety 2.1" in capsys.readouterr().out
    ends = loaded.bending_stiffness * (loaded.force[0] - loaded.force[-1])
    rail = loaded.bending_stiffness * loaded.between[0].force[0]
    assert ends + rail == pytest.approx([0, 8 * 9.80665], abs=0.05)
    unloaded, under_load = (rod.between[0].force[0, 1] for rod in (slat.rod, loaded))
    assert under_load > 1.5 * unloaded > 0, "the slat rests on the bar below it"
    assert ec.stability(loaded).rating == "stable"
