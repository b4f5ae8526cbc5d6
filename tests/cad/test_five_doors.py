"""One strip asked for at four doors and in the core: the same cuts, or the same sentence of refusal.

The fifth door is FreeCAD, which has a process of its own: see tests/freecad/test_fifth_door.py.
"""

import runpy
import shlex
from pathlib import Path

import build123d as bd
import cadquery as cq
import ezdxf
import numpy as np
import pytest
from click.testing import CliRunner

from elastica_cad import build123d, cadquery
from elastica_cad.cli.commands import elastica
from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication.strip_spec import make_strip
from elastica_cad.files import save
from elastica_cad.formats.curve_files.write_curves import write_curves

DOORS = runpy.run_path(str(Path(__file__).resolve().parents[1] / "five_doors.py"))
ASKED, REFUSED, loop_numbers = DOORS["ASKED"], DOORS["REFUSED"], DOORS["loop_numbers"]
NEAR = 1e-9  # mm


def core(asked):
    """The strip in the core, or the sentence that refuses it."""
    try:
        strip = make_strip(asked.curve, asked.sheet, label="S1", **asked.fields)
        _ = strip.layers
    except ElasticaError as error:
        return str(error)
    return strip


def typed(asked, folder):
    write_curves([asked.curve], folder / "S1.json")
    words = ["strip", str(folder / "S1.json"), "--sheet", asked.sheet, *shlex.split(asked.options)]
    return CliRunner().invoke(elastica, [*words, "-o", str(folder / "out")])


def written(asked, folder):
    """A design file, made by the command that is typed for it."""
    points = [list(point) for point in asked.points]
    path = folder / "doors.toml"
    path.write_text(
        f"schema = 1\nsheet = '{asked.sheet}'\n[[strips]]\nlabel = 'S1'\n{asked.keys}\n"
        f"curve = {{ spline = {points}, degree = {len(points) - 1} }}\n"
    )
    fast = ("--no-step", "--no-pictures", "--no-effects")
    return CliRunner().invoke(elastica, ["model", str(path), *fast, "-o", str(folder / "out")])


def skins(asked):
    """What build123d and CadQuery make of an edge drawn with each of them."""
    drawn = bd.Edge.make_bezier(*asked.points)
    yield lambda: build123d.FlatStrip(drawn, asked.sheet, label="S1", **asked.fields)
    yield lambda: cadquery.flat_strip(cq.Edge(drawn.wrapped), asked.sheet, label="S1", **asked.fields)


def cuts(path):
    """Kind and numbers of everything that is cut in a DXF file."""
    found = []
    for entity in ezdxf.readfile(path).modelspace().query('*[layer=="CUT_OUTER" | layer=="CUT_INNER"]'):
        values = []
        for name in ("start", "end", "center", "radius", "start_angle", "end_angle"):
            if entity.dxf.hasattr(name):
                values += list(np.ravel(entity.dxf.get(name)))
        if entity.dxftype() == "SPLINE":
            values += [*np.ravel(entity.control_points), *entity.knots]
        if entity.dxftype() == "LWPOLYLINE":
            values += list(np.ravel(entity.get_points()))
        found.append((entity.dxftype(), np.array(values, dtype=float)))
    return found


def assert_same_cuts(folder, strip, *files):
    for i, drawing in enumerate(strip.drawings()):
        save(drawing, folder / f"core{i}.dxf")
        (made,) = (folder / "out").rglob(files[i])
        ours, theirs = cuts(folder / f"core{i}.dxf"), cuts(made)
        assert [kind for kind, _ in ours] == [kind for kind, _ in theirs]
        assert ours
        for (_, one), (_, other) in zip(ours, theirs, strict=True):
            assert other == pytest.approx(one, abs=NEAR)


@pytest.mark.parametrize("name", ASKED)
def test_command_line(name, tmp_path):
    asked = ASKED[name]
    strip, done = core(asked), typed(asked, tmp_path)
    if isinstance(strip, str):
        assert done.exit_code in (1, 2)
        assert strip in done.stderr
        return
    assert done.exit_code == 0, done.stderr
    assert_same_cuts(tmp_path, strip, "S1.dxf", "S1-backing.dxf")


@pytest.mark.parametrize("name", ASKED)
def test_design_file(name, tmp_path):
    asked = ASKED[name]
    strip, done = core(asked), written(asked, tmp_path)
    if isinstance(strip, str):
        assert done.exit_code in (1, 2)
        assert strip in done.stderr
        return
    assert done.exit_code == 0, done.stderr
    assert_same_cuts(tmp_path, strip, "S1_*.dxf", "S1-backing_*.dxf")


@pytest.mark.parametrize("name", ASKED)
def test_kernels(name):
    asked = ASKED[name]
    strip = core(asked)
    for make in skins(asked):
        if isinstance(strip, str):
            with pytest.raises(ElasticaError) as refused:
                make()
            assert str(refused.value) == strip
            continue
        kinds, numbers = loop_numbers(make().strip)
        ours, expected = loop_numbers(strip)
        assert kinds == ours
        assert numbers == pytest.approx(expected, abs=NEAR)


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name, tmp_path):
    """The same sentence; the command line adds its options, a design file the name of the strip."""
    asked = REFUSED[name]
    sentence = core(asked)
    assert isinstance(sentence, str)
    for command in (typed, written):
        done = command(asked, tmp_path)
        assert done.exit_code in (1, 2)
        assert sentence in done.stderr
        assert not (tmp_path / "out").exists()
    for make in skins(asked):
        with pytest.raises(ElasticaError) as refused:
            make()
        assert str(refused.value) == sentence
