"""Rings of surfaces of revolution among the bodies of an assembly."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.kernel.occt import make_location
from elastica_cad.kernel.step_files import model_shapes, write_step

CARD, MDF = ec.Sheet.named("card-200gsm"), ec.Sheet.named("mdf-3")


def test_rings_stand_with_the_strips_and_tabs_go_through_them(tmp_path):
    """Exact volumes; no strip goes through the material of a ring."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    def volume(shape):
        found = GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, found)
        return found.Mass()

    meridian = ec.meridian(0.0, (1 / 80, 0), (80, 0), np.pi / 2, 400, ring=35)
    model = ec.revolve(meridian, 8, sheet=CARD, rings=MDF, name="globe", ignore_limits=True)
    parts = model_shapes(model)
    assert [part.name for part in parts[8:]] == ["ring-bottom", "ring-top"]
    strip = parts[0].shape.Moved(make_location(parts[0].frame))
    for part, ring in zip(parts[8:], model.plates, strict=True):
        assert volume(part.shape) == pytest.approx(ring.piece.area * MDF.thickness, rel=1e-9)
        common = BRepAlgoAPI_Common(strip, part.shape).Shape()
        assert volume(common) < 0.1  # the wedge under a leaning shoulder
    write_step(model_shapes(model), tmp_path / "globe.step", name=model.name)
    assert "'ring-top'" in (tmp_path / "globe.step").read_text()
