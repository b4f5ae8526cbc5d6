"""FreeCAD's rows of the table in tests/contract: properties of a strip give the cuts that Python's fields give."""

import re
from pathlib import Path

import FreeCAD as App
import pytest
from freecad.elastica_wb.features import strip as feature
from freecad.elastica_wb.host.words import worded

from elastica_cad import ElasticaError
from tests.contract import answers
from tests.contract.more_requests import MORE_REQUESTS
from tests.contract.table import REFUSED, REQUESTS

ROOT = Path(__file__).resolve().parents[2]


def asked_in(document, sketch, options):
    """A recomputed strip with the row's properties, along a sketch in the row's plane."""
    frame = options.fields.get("frame")
    if frame is not None:
        turned = App.Rotation(
            *(App.Vector(*axis) for axis in (frame.x_axis, frame.y_axis, frame.z_axis)), "XYZ"
        )
        sketch.Placement = App.Placement(App.Vector(*frame.origin), turned)
    made = feature.create(document, sketch)
    made.Sheet, made.EngravedText = options.sheet, answers.LABEL
    for name, value in options.properties.items():
        setattr(made, name, App.Vector(*value) if name == "GravityDirection" else value)
    document.recompute()
    return made


def assert_same_answer(options, document, drawn):
    expected, made = (
        answers.in_python(options),
        asked_in(document, drawn(options.points, options.curve.degree, knots=options.knots), options),
    )
    if isinstance(expected, ElasticaError):
        assert "Invalid" in made.State
        assert answers.same_refusal(expected, made.getStatusString(), worded), made.getStatusString()
    else:
        assert made.State == ["Up-to-date"], made.getStatusString()
        answers.assert_same_strip(feature.strip_of(made), expected)


@pytest.mark.parametrize("name", [*REQUESTS, *REFUSED])
def test_same_answer(name, document, drawn):
    assert_same_answer((REQUESTS | REFUSED)[name], document, drawn)


@pytest.mark.campaign
@pytest.mark.parametrize("name", MORE_REQUESTS)
def test_more_requests(name, document, drawn):
    assert_same_answer(MORE_REQUESTS[name], document, drawn)


def test_page_of_the_workbench(document, sketch, capsys):
    """What it types into the Python console, with a sketch in the document."""
    (code,) = re.findall(
        r"```python\n(.*?)```", (ROOT / "docs" / "freecad.md").read_text(encoding="utf-8"), re.DOTALL
    )
    names = {}
    exec(compile(code, "freecad.md", "exec"), names)
    assert "can be bent into this curve" in capsys.readouterr().out
    assert names["strip"].MaxWidth.Value == 40
