"""One strip asked for at six front ends: the same cuts as in Python, or the same refusal.

FreeCAD, the seventh, has a process of its own: tests/freecad/test_contract.py asks it for the same rows.
"""

import shlex
from dataclasses import replace
from math import degrees
from pathlib import Path

import build123d as bd
import cadquery as cq
import numpy as np
import pytest
import tomlkit
from click.testing import CliRunner
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
from OCP.Geom import Geom_BSplineCurve
from OCP.gp import gp_Pnt
from OCP.TColgp import TColgp_Array1OfPnt
from OCP.TColStd import TColStd_Array1OfInteger, TColStd_Array1OfReal

from elastica_cad import ElasticaError, Frame, Strip, build123d, cadquery, read_curves, write_curves
from elastica_cad.cli.commands import elastica
from elastica_cad.design import read_design
from elastica_cad.errors import Wording
from elastica_cad.web.answers import requested_spec
from tests.contract import answers
from tests.contract.more_requests import MORE_REQUESTS
from tests.contract.table import REFUSED, REQUESTS

# some rows are bent beyond what their sheet bears
pytestmark = pytest.mark.filterwarnings("ignore::elastica_cad.kernel.strip_body.StripWarning")
QUICK = ("--no-step", "--no-pictures")


def command_line(options, folder):
    """`elastica strip` with the options: its cutting files, or what it prints."""
    write_curves([options.curve], folder / "S1.json")
    words = ["strip", str(folder / "S1.json"), "--sheet", options.sheet, *shlex.split(options.options)]
    done = CliRunner().invoke(elastica, [*words, *QUICK, "-o", str(folder / "out")])
    return made_by(done, folder)


def design_file(options, folder):
    """`elastica model` of a design with the keys."""
    path = folder / "design.toml"
    path.write_text(design_text(options))
    done = CliRunner().invoke(
        elastica, ["model", str(path), *QUICK, "--no-effects", "-o", str(folder / "out")]
    )
    return made_by(done, folder)


def design_text(options):
    knots = "" if options.knots is None else f", knots = {list(options.knots)}"
    points = [list(point) for point in options.points]
    return (
        f"schema = 1\nsheet = '{options.sheet}'\n[[strips]]\nlabel = 'S1'\n{options.keys}\n"
        f"curve = {{ spline = {points}, degree = {options.curve.degree}{knots} }}\n"
    )


def studio_page(options, _):
    """The request of the page for the design that it shows."""
    try:
        return requested_spec(tomlkit.parse(design_text(options)).unwrap()).make()
    except ElasticaError as problem:
        return str(problem)


def made_by(done, folder):
    """The folder of the cutting files, or the refusal."""
    if done.exit_code:
        assert done.exit_code in (1, 2), done.exception
        assert not (folder / "out").exists()
        return done.stderr
    return folder / "out"


def build123d_object(options, _):
    return build123d.FlatStrip(
        edge(options), options.material, plane=frame(options), **drawn_fields(options)
    ).strip


def build123d_builder(options, _):
    with bd.BuildPart():
        with bd.BuildLine():
            bd.insert(edge(options))
        made = build123d.elastic_strip(sheet=options.material, plane=frame(options), **drawn_fields(options))
    return made.strip


def cadquery_function(options, _):
    drawn = cq.Edge(edge(options).wrapped)
    return cadquery.flat_strip(drawn, options.material, plane=frame(options), **drawn_fields(options)).strip


def cadquery_workplane(options, _):
    cadquery.register()
    drawn = cq.Workplane().add(cq.Edge(edge(options).wrapped)).toPending()
    return drawn.elasticStrip(options.material, plane=frame(options), **drawn_fields(options)).val().strip


FRONT_ENDS = {
    "command line": command_line,
    "design file": design_file,
    "studio page": studio_page,
    "build123d object": build123d_object,
    "build123d builder": build123d_builder,
    "CadQuery function": cadquery_function,
    "CadQuery workplane": cadquery_workplane,
}


def frame(options):
    return options.fields.get("frame", Frame())


def drawn_fields(options):
    """The fields; the frame is that in which the curve is drawn, and the lean of slots is in degrees."""
    fields = {"label": answers.LABEL} | options.fields
    if "slots" in fields:
        fields["slots"] = tuple(replace(slot, lean=degrees(slot.lean)) for slot in fields["slots"])
    return {name: value for name, value in fields.items() if name != "frame"}


def edge(options):
    """The curve as a user of build123d has it, drawn in its place."""
    curve, there = options.curve, frame(options)
    points = [there.point(point).tolist() for point in options.points]
    if len(points) == curve.degree + 1:
        return bd.Edge.make_bezier(*points)
    values, multiplicities = np.unique(curve.knots, return_counts=True)
    poles = TColgp_Array1OfPnt(1, len(points))
    knots, counts = TColStd_Array1OfReal(1, values.size), TColStd_Array1OfInteger(1, values.size)
    for number, point in enumerate(points, start=1):
        poles.SetValue(number, gp_Pnt(*point))
    for number, (value, count) in enumerate(zip(values, multiplicities, strict=True), start=1):
        knots.SetValue(number, float(value))
        counts.SetValue(number, int(count))
    return bd.Edge(BRepBuilderAPI_MakeEdge(Geom_BSplineCurve(poles, knots, counts, curve.degree)).Edge())


SPELLED = {
    "command line": {
        "max_width": "--max-width", "min_width": "--min-width", "ignore_limits": "--ignore-limits",
        "gravity": "--gravity", "loads": "--set loads", "shop.least_width": "--set shop.least_width",
        "style.hole_ratio": "--set style.hole_ratio", "limits": "--nearest",
        "natural_curvature": "--natural-curvature", "seam_position": "--set seam_position",
    },
    "design file": {"ignore_limits": "--ignore-limits"},  # an option of `elastica model`
}  # fmt: skip


class Spelled(Wording):
    """English with the names of fields of a front end."""

    def __init__(self, front_end):
        self.names = SPELLED.get(front_end, {})

    def field(self, name):
        return self.names.get(name, name)


def assert_same_answer(options, front_end, folder):
    expected = answers.in_python(options)
    try:
        made = FRONT_ENDS[front_end](options, folder)
    except ElasticaError as raised:
        made = raised
    if isinstance(expected, ElasticaError):
        assert answers.same_refusal(expected, made, Spelled(front_end).sentence), made
    elif isinstance(made, Strip):
        answers.assert_same_strip(made, expected)
    else:
        assert isinstance(made, Path), made
        answers.assert_same_files(made, expected)


@pytest.mark.parametrize("name", REQUESTS)
@pytest.mark.parametrize("front_end", FRONT_ENDS)
def test_same_cuts(front_end, name, tmp_path):
    assert isinstance(answers.in_python(REQUESTS[name]), Strip)
    assert_same_answer(REQUESTS[name], front_end, tmp_path)


@pytest.mark.parametrize("name", REFUSED)
@pytest.mark.parametrize("front_end", FRONT_ENDS)
def test_same_refusal(front_end, name, tmp_path):
    assert isinstance(answers.in_python(REFUSED[name]), ElasticaError)
    assert_same_answer(REFUSED[name], front_end, tmp_path)


@pytest.mark.campaign
@pytest.mark.parametrize("name", MORE_REQUESTS)
@pytest.mark.parametrize("front_end", FRONT_ENDS)
def test_more_requests(front_end, name, tmp_path):
    assert_same_answer(MORE_REQUESTS[name], front_end, tmp_path)


def test_creep_in_a_design_file(tmp_path):
    """Neither drawings nor the report of a model show it."""
    request = REQUESTS["plain, of a measured sheet, with equal tabs"]
    design_file(request, tmp_path)
    (entry,) = read_design(tmp_path / "design.toml", read_curves).entries
    assert entry.spec.creep == request.fields["creep"]
