"""FreeCAD in this process: its modules, the workbench of this checkout, a home of its own."""

import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
PLACES = (
    "/usr/lib/freecad-python3/lib",
    "/usr/lib/freecad/lib",
    "/usr/share/freecad/Ext",
    *map(str, sorted(Path("/usr/share/freecad/Mod").glob("*/"))),  # as FreeCAD does itself
    "/usr/share/freecad/Mod",
)

collect_ignore_glob = ["scripts/*"]  # they run inside FreeCAD

os.environ.setdefault("FREECAD_USER_HOME", tempfile.mkdtemp(prefix="elastica-freecad-"))
sys.path += [place for place in PLACES if Path(place).is_dir()]
if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))
try:
    import FreeCAD as App
    import freecad
    import Part
    import Sketcher  # noqa: F401 - documents with sketches need it loaded
except ImportError as missing:
    raise pytest.UsageError(f"FreeCAD is not installed ({missing}): run tests/setup.sh") from missing
freecad.__path__.append(str(ROOT / "freecad_workbench" / "freecad"))
if find_spec("OCP") is None:  # in the folders of other releases there is FreeCAD's own OpenCASCADE only
    collect_ignore = ["test_step_agreement.py"]

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]


@pytest.fixture
def document() -> Iterator[Any]:
    """An empty document with undo switched on."""
    made = App.newDocument("Test")
    made.UndoMode = 1
    name = made.Name
    yield made
    if App.listDocuments().get(name) is made:
        App.closeDocument(name)


@pytest.fixture
def spline_geometry() -> Callable[..., Any]:
    """`spline_geometry(points, degree, weights)`: a clamped uniform B-spline for a sketch."""
    return _spline


@pytest.fixture
def sketch(document: Any) -> Any:
    """A sketch with one spline that can be bent."""
    return draw(document, ARCH)


@pytest.fixture
def drawn(document: Any) -> Callable[..., Any]:
    """`drawn(points, degree, weights, knots)`: a sketch with one spline."""

    def make(points: Any, degree: int = 4, weights: Any = None, knots: Any = None) -> Any:
        return draw(document, points, degree, weights, knots)

    return make


@pytest.fixture
def move_pole() -> Callable[[Any, int, tuple[float, float]], None]:
    """`move_pole(sketch, number from 0, (x, y))`: what an edit in the sketcher does to the only spline."""

    def move(sketch: Any, number: int, place: tuple[float, float]) -> None:
        curve = sketch.Geometry[0]
        curve.setPole(number + 1, App.Vector(*place, 0))
        sketch.delGeometry(0)
        sketch.addGeometry(curve, False)

    return move


def draw(document: Any, points: Any, degree: int = 4, weights: Any = None, knots: Any = None) -> Any:
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(_spline(points, degree, weights, knots), False)
    document.recompute()
    return sketch


def _spline(points: Any, degree: int = 4, weights: Any = None, knots: Any = None) -> Any:
    """A clamped spline of Part; its knots are uniform by default."""
    curve = Part.BSplineCurve()
    spans = len(points) - degree
    uniform = [0.0] * degree + [i / spans for i in range(spans + 1)] + [1.0] * degree
    knots, counts = np.unique(uniform if knots is None else knots, return_counts=True)
    knots, counts = knots.tolist(), counts.tolist()
    poles = [App.Vector(*p, 0) for p in points]
    curve.buildFromPolesMultsKnots(poles, counts, knots, False, degree, weights or [1.0] * len(poles))
    return curve
