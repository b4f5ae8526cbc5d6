"""In freecadcmd: a strip and its flat part, recomputed after each of many changes of their curve."""

import json
import os
import sys
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
from drawn_splines import spline, strip_with_flat_part

OUT = Path(os.environ["ELASTICA_TEST_OUT"])
CURVES = {
    "an arch": [(0, 0), (90, 180), (210, 240), (360, 180), (450, 0)],
    "a wave": [(0, 0), (200, 320), (360, 240), (480, -240), (640, -320), (840, 0)],
}
TIMES = 60
answers = {"recomputes": {}}


def recomputes(points):
    """Seconds of the processor, without those of the sketch."""
    document = App.newDocument("Recomputes")
    sketch, feature = strip_with_flat_part(document, points)
    took = []
    for k in range(TIMES):
        moved = [points[0], points[1], (points[2][0] + 0.1 * (k + 1), points[2][1]), *points[3:]]
        sketch.Geometry = [spline(moved)]
        sketch.recompute()
        began = time.process_time()
        document.recompute()
        took.append(time.process_time() - began)
        assert feature.State == ["Up-to-date"], feature.getStatusString()
    App.closeDocument(document.Name)
    return took


try:
    for name, points in CURVES.items():
        answers["recomputes"][name] = recomputes(points)
except BaseException:
    answers["error"] = traceback.format_exc()
(OUT / "answers.json").write_text(json.dumps(answers))
os._exit(0)
