"""Drawings saved by programs nobody here wrote: Inkscape at every precision, FreeCAD, LibreCAD's own parts."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from elastica_cad.errors import ElasticaError
from elastica_cad.files import read_curves, read_drawing
from elastica_cad.forming.smoothing import smooth_curve
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium, require_bendable

PRECISION = """<inkscape xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1">
<group id="options"><group id="svgoutput" numericprecision="{digits}"/></group></inkscape>"""

DRAWN = """<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">
<path id="arch" d="M 20,150 C 20,95.3 63.1,50.2 118.4,50.2 C 171.7,50.2 216.9,88.1 220.4,151.3"/></svg>"""

IN_FREECAD = """
import FreeCAD, Part, importSVG
document = FreeCAD.newDocument()
def bezier(*poles):
    curve = Part.BezierCurve()
    curve.setPoles([FreeCAD.Vector(x, y, 0) for x, y in poles])
    return curve.toShape()
made = document.addObject("Part::Feature", "arch")
first, second = bezier((0, 0), (10, 60), (50, 90), (100, 80)), bezier((100, 80), (140, 72), (190, 60), (200, 0))
made.Shape = Part.Wire([first, second])
document.recompute()
importSVG.export([made], {folder!r} + "/f.svg")
made.Shape.exportStep({folder!r} + "/f.step")
"""


@pytest.mark.parametrize("digits", [2, 3, 4, 5, 6, 8])
def test_inkscape_saves_the_same_arch_at_every_precision(tmp_path, digits):
    (tmp_path / "preferences.xml").write_text(PRECISION.format(digits=digits))
    (tmp_path / "drawn.svg").write_text(DRAWN)
    command = ["inkscape", "drawn.svg", "--export-plain-svg", "--export-filename=saved.svg"]
    command += ["--actions=select-by-id:arch;transform-rotate:7.3"]
    here = os.environ | {"INKSCAPE_PROFILE_DIR": str(tmp_path)}
    subprocess.run(command, cwd=tmp_path, env=here, check=True, capture_output=True, timeout=120)
    (curve,) = read_curves(tmp_path / "saved.svg")
    require_bendable(curve)
    smoothing = smooth_curve(curve)
    check = check_equilibrium(smoothing.curve)
    assert check.realizable
    assert not len(check.inflections)
    assert curve.length == pytest.approx(315.3, abs=1.0 if digits < 4 else 0.1)
    assert smoothing.fairing is not None


def test_freecad_saves_one_curve_as_a_drawing_and_as_a_model(tmp_path):
    script = tmp_path / "make.py"
    script.write_text(IN_FREECAD.format(folder=str(tmp_path)))
    subprocess.run(["freecadcmd", str(script)], check=True, capture_output=True, timeout=120)
    (drawn,) = read_curves(tmp_path / "f.svg")
    assert smooth_curve(drawn).fairing is not None  # a pen's path
    pytest.importorskip("OCP")
    (model,) = read_curves(tmp_path / "f.step")
    assert smooth_curve(model).curve is model  # a kernel's edges never move
    assert model.length == pytest.approx(drawn.length, rel=1e-9)


def test_parts_drawn_in_librecad_are_read():
    files = sorted(Path("/usr/share/librecad/library").rglob("*.dxf"))[::12]
    assert len(files) > 30
    read = 0
    for path in files:
        try:
            drawing = read_drawing(path)
        except ElasticaError:
            continue
        read += 1
        for one in drawing:
            assert one.problem or np.isfinite(one.curve.length)
    assert read > 0.9 * len(files)
