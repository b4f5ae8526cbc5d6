"""The strips that tests/cad/test_five_doors.py asks for at four doors, asked for in FreeCAD's properties."""

import runpy
from pathlib import Path

import FreeCAD as App
import pytest
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.host.sentences import translated

from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication.strip_spec import make_strip

DOORS = runpy.run_path(str(Path(__file__).resolve().parents[1] / "five_doors.py"))
ASKED, REFUSED, loop_numbers = DOORS["ASKED"], DOORS["REFUSED"], DOORS["loop_numbers"]
NEAR = 1e-9  # mm


@pytest.mark.parametrize("name", [*ASKED, *REFUSED])
def test_properties(name, document, drawn):
    asked = (ASKED | REFUSED)[name]
    feature = strip.create(document, drawn(asked.points, len(asked.points) - 1))
    feature.Sheet = asked.sheet
    feature.EngravedText = "S1"
    for key, value in ({"MaxWidth": 20.0} | asked.properties).items():
        setattr(feature, key, App.Vector(*value) if key == "GravityDirection" else value)
    document.recompute()
    try:
        kinds, numbers = loop_numbers(make_strip(asked.curve, asked.sheet, label="S1", **asked.fields))
    except ElasticaError as error:
        refused = str(error)
    else:
        refused = ""
    if refused:
        assert "Invalid" in feature.State
        # the same sentence, with the names of properties
        assert feature.getStatusString().strip() == translated(refused)
        return
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    found, ours = loop_numbers(strip.strip_of(feature))
    assert found == kinds
    assert ours == pytest.approx(numbers, abs=NEAR)
