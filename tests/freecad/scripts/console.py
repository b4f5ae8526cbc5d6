"""In freecadcmd, loaded as an addon: create, edit, fail, recover, export, save, reload."""

import json
import os
import sys
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import Part
from drawn_splines import spline, strip_with_flat_part

OUT = Path(os.environ["ELASTICA_TEST_OUT"])
ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
answers = {}


def redraw(sketch, points, degree=4):
    sketch.delGeometry(0)
    sketch.addGeometry(spline(points, degree), False)


def printed(doing):
    """What FreeCAD writes to the console meanwhile."""
    kept, file = [os.dup(1), os.dup(2)], (OUT / "said.txt").open("w+")
    for number in (1, 2):
        os.dup2(file.fileno(), number)
    doing()
    for number, old in zip((1, 2), kept, strict=True):
        os.dup2(old, number)
    return (OUT / "said.txt").read_text()


def report(document, feature):
    """A failure that is meant, and one that nobody foresaw."""
    from freecad.elastica_wb.features import strip

    width = feature.MaxWidth.Value
    feature.MaxWidth = 0
    answers["said"] = [line for line in printed(document.recompute).splitlines() if "Largest width" in line]
    answers["traceback"] = (OUT / "said.txt").read_text().count("Traceback")
    answers["status"] = feature.getStatusString()
    answers["limit"] = hasattr(sys, "tracebacklimit")
    feature.MaxWidth = width
    good, strip.bent_shape = strip.bent_shape, lambda _: 1 / 0
    answers["mistake"] = printed(document.recompute)
    strip.bent_shape = good
    feature.touch()
    document.recompute()
    assert feature.State == ["Up-to-date"]


def work():
    import numpy
    import scipy
    from freecad.elastica_wb.cutting_files import write_cutting_files
    from PySide import QtCore

    import elastica_cad
    from elastica_cad import ElasticaError, StripSpec

    answers["classes"] = [QtCore.QObject.__name__, ElasticaError.__name__, StripSpec.__name__]
    answers["versions"] = [numpy.__version__, scipy.__version__, App.Version()[:3]]
    answers["core"] = elastica_cad.__file__
    document = App.newDocument("Console")
    sketch, feature = strip_with_flat_part(document, ARCH)
    answers["kernels"] = [
        name for name in sys.modules if name.split(".")[0] in ("OCP", "build123d", "cadquery")
    ]
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    answers["volume"], answers["ratio"] = feature.Shape.Volume, feature.Ratio
    times = []
    for i in range(12):
        redraw(sketch, [*ARCH[:2], (70, 80 + 0.5 * i), *ARCH[3:]])
        began = time.thread_time()
        document.recompute([feature])
        times.append(time.thread_time() - began)
    answers["recompute"] = times
    redraw(sketch, [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)])
    document.recompute()
    answers["refused"] = feature.getStatusString()
    answers["hidden"] = not feature.Visibility
    feature.Follow = "Nearest"
    feature.RatioLimit = 6
    feature.StrainLimit, feature.Anyway = 5, True
    document.recompute()
    answers["nearest"] = [feature.State, feature.Verdict, feature.Deviation.Value, feature.getStatusString()]
    feature.Follow, feature.Anyway = "Exactly", False
    redraw(sketch, ARCH)
    document.recompute()
    assert feature.State == ["Up-to-date"]
    assert feature.Visibility
    files = write_cutting_files([feature], OUT / "files", kinds=("svg", "step", "csv"))
    answers["files"] = [path.name for path in files]
    step = Part.Shape()
    step.read(str(next(path for path in files if path.suffix == ".step")))
    answers["step"] = sorted(solid.Volume for solid in step.Solids)
    answers["shapes"] = sorted([feature.Shape.Volume, document.getObject("Flat").Shape.Volume])
    report(document, feature)
    document.saveAs(str(OUT / "console.FCStd"))
    App.closeDocument(document.Name)
    again = App.openDocument(str(OUT / "console.FCStd"))
    loaded = again.getObject("Strip")
    answers["loaded"] = [type(loaded.Proxy).__module__, loaded.Shape.Volume]
    App.closeDocument(again.Name)


try:
    work()
except BaseException:
    answers["error"] = traceback.format_exc()
(OUT / "answers.json").write_text(json.dumps(answers, default=str))
os._exit(1 if "error" in answers else 0)
