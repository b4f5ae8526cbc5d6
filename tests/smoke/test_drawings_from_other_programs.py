"""Drawings saved by programs nobody here wrote: Inkscape at every precision, FreeCAD, LibreCAD's own parts."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from elastica_cad import (
    ElasticaError,
    PlaneCurve,
    Sheet,
    Strip,
    check_equilibrium,
    optimal_rod,
    read_curves,
    save,
)
from elastica_cad.files import read_drawing
from elastica_cad.form_finding import smooth_curve
from elastica_cad.mechanics.theorem1 import require_bendable

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


@pytest.mark.parametrize(
    "digits", [*(pytest.param(one, marks=pytest.mark.campaign) for one in (2, 3, 4, 5, 8)), 6]
)
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
    assert smooth_curve(drawn).fairing is not None  # its curvature jumps
    pytest.importorskip("OCP")
    (model,) = read_curves(tmp_path / "f.step")
    assert smooth_curve(model).curve.length == pytest.approx(smooth_curve(drawn).curve.length, rel=1e-6)
    assert model.length == pytest.approx(drawn.length, rel=1e-9)


AT_LIBRECAD = """
for start in 1 2 3 4; do  # LibreCAD once showed no window for five minutes: start it again after 75 s
    librecad "$1" & program=$!
    for look in $(seq 150); do
        window=$(xdotool search --onlyvisible --name "LibreCAD - " | head -1)
        [ -n "$window" ] && break 2
        sleep 0.5
    done
    kill $program
done
for try in $(seq 15); do  # a window that is shown does not take keys at once: type until an arc is in the file
    xdotool windowfocus "$window" key Escape Escape ctrl+m  # keys go to the command line, as by a click on it
    for typed in "${@:2}"; do
        xdotool type --delay 20 "$typed"
        xdotool key Return
    done
    xdotool key Escape Escape ctrl+s
    for look in $(seq $((10 * try))); do  # longer each time: on a busy machine it saves late
        head -c 40 "$1" | grep -q dxfrw && grep -q "^ARC" "$1" && break 2
        sleep 0.2
    done
done
kill $program
"""


def test_librecad_saves_a_strip_of_ours_and_an_arc_drawn_beside_it(tmp_path):
    """Our file is opened, an arc is typed at LibreCAD's command line, and all is saved."""
    settings = tmp_path / ".config" / "LibreCAD" / "LibreCAD.conf"
    settings.parent.mkdir(parents=True)
    settings.write_text("[Startup]\nFirstLoad=0\n")
    bow = PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4)
    strip = Strip(optimal_rod(bow), Sheet.named("birch-plywood-0.8"), max_width=30, label="BOW")
    save(strip.drawing(), tmp_path / "ours.dxf")
    before = {one.layer + str(one.number): one.curve for one in read_drawing(tmp_path / "ours.dxf")}
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x1280x24", "bash", "-c", AT_LIBRECAD, "at", "ours.dxf"]
    words += ["arc", "0,100", "60,140", "120,100"]
    here = os.environ | {"HOME": str(tmp_path)}
    subprocess.run(words, cwd=tmp_path, env=here, check=False, capture_output=True, timeout=900)
    assert b"dxfrw" in (tmp_path / "ours.dxf").read_bytes()[:40], "LibreCAD has not saved it"
    after = list(read_drawing(tmp_path / "ours.dxf"))
    for one in after:
        if one.layer != "0":
            curve = before[one.layer + str(one.number)]
            assert one.curve.length == pytest.approx(curve.length, abs=1e-6)
            np.testing.assert_allclose(one.curve.bounds, curve.bounds, atol=1e-6)
    typed = [one.curve for one in after if one.layer == "0"]  # once or more: see above
    assert typed
    assert len(after) == len(before) + len(typed)
    for drawn in typed:
        assert drawn.length == pytest.approx(2 * 65 * np.arcsin(60 / 65), abs=1e-6)  # of a radius of 65 mm
        assert check_equilibrium(drawn).realizable


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
