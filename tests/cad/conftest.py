"""Curves, strips and independent measurements for the CAD tests, and which of these are meant to run."""

import os
from importlib.util import find_spec

import numpy as np
import pytest

from elastica_cad import Hole, PlaneCurve, Sheet, Strip, Tab, optimal_rod

SKINS = {"build123d", "cadquery"}
NEEDS = {
    "test_build123d_strips.py": {"build123d"},
    "test_cadquery_strips.py": {"cadquery"},
    "test_closed_bodies.py": SKINS,
    "test_engraving_and_pockets.py": SKINS,
    "test_flexures.py": SKINS,
    "test_laminate_bodies.py": SKINS,
    "test_screws_of_bd_warehouse.py": SKINS,  # and bd_warehouse, which is in the environment of both
    "test_step_exchange.py": SKINS,
    "test_step_files.py": {"build123d"},
    "test_typing.py": SKINS,  # and mypy, which is where both are
}

MEANT = set(os.environ.get("ELASTICA_KERNELS", "build123d cadquery").split()) - {"none"}
"""What this environment is for: both, unless it says otherwise (as the Makefile does). Nothing is skipped."""

collect_ignore = [name for name, needs in NEEDS.items() if not needs <= MEANT]
collect_ignore_glob = [] if MEANT else ["test_*.py"]


def pytest_configure(config):
    missing = sorted(name for name in MEANT if name not in SKINS or find_spec(name) is None)
    if missing:
        raise pytest.UsageError(
            f"tests/cad needs {' and '.join(missing)}: install it, or say in ELASTICA_KERNELS which of build123d "
            "and cadquery this environment is for, or none"
        )
    # strips of these tests are often bent beyond what their sheet bears; the tests that mean it catch the warning
    config.addinivalue_line("filterwarnings", "ignore::elastica_cad.kernel.strip_body.StripWarning")
    config.addinivalue_line("markers", "build123d: needs build123d")
    config.addinivalue_line("markers", "cadquery: needs CadQuery")


def pytest_collection_modifyitems(config, items):
    """Leave out tests marked for a library that this environment is not for."""
    foreign = [item for item in items if any(item.get_closest_marker(name) for name in SKINS - MEANT)]
    if foreign:
        config.hook.pytest_deselected(items=foreign)
        items[:] = [item for item in items if item not in foreign]


CURVES = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4),
    "cubic arch": PlaneCurve.spline([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)], degree=3),
    "S": PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)], degree=4),
    "circle": PlaneCurve.arc((10, 20), 60, 0.3, 3.1),
    "ellipse": PlaneCurve.ellipse((0, 0), (90, 50), 0.4, 0.2, 2.0),
}
ENDS = {
    "holes": (
        Tab(12, holes=(Hole(6, 3.2),)),
        Tab(14, corner_radius=3, holes=(Hole(5, 2, -3), Hole(8, 2, 3))),
    ),
    "none": (Tab(0), Tab(0)),
    "wide and narrow": (Tab(8, width=40), Tab(12, width=8, chamfer=2)),
}


@pytest.fixture(params=sorted(CURVES))
def curve(request):
    return CURVES[request.param]


@pytest.fixture(params=sorted(ENDS))
def ends(request):
    return ENDS[request.param]


@pytest.fixture(scope="session")
def card():
    return Sheet.named("birch-plywood-0.8")


@pytest.fixture(scope="session")
def arch_strip(card):
    return Strip(optimal_rod(CURVES["arch"]), card, max_width=30, ends=ENDS["holes"], label="arch")


@pytest.fixture(scope="session")
def plain(arch_strip):
    return Strip(arch_strip.rod, arch_strip.sheet, max_width=30, ends=(Tab(10), Tab(10)), label="plain")


@pytest.fixture(scope="session")
def measure():
    return Measure()


class Measure:
    """Volumes, areas and validity by OpenCASCADE.

    Its adaptive integration is right to rounding on faces with splines, where the plain one, which CAD programs
    show, uses too few points (errors up to 1e-4); on the plane walls of a flat solid the adaptive one stops early.
    """

    def volume(self, shape, *, bent=True):
        from OCP.BRepGProp import BRepGProp

        return self._mass(BRepGProp.VolumeProperties_s, shape, bent)

    def area(self, shape, *, bent=True):
        from OCP.BRepGProp import BRepGProp

        return self._mass(BRepGProp.SurfaceProperties_s, shape, bent)

    def is_valid(self, shape):
        from OCP.BRepCheck import BRepCheck_Analyzer

        return BRepCheck_Analyzer(shape).IsValid()

    def faces(self, shape):
        from OCP.BRepAdaptor import BRepAdaptor_Surface
        from OCP.TopAbs import TopAbs_ShapeEnum
        from OCP.TopExp import TopExp_Explorer
        from OCP.TopoDS import TopoDS

        cast = getattr(TopoDS, "Face_s", None) or TopoDS.Face
        explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
        found = []
        while explorer.More():
            found.append(BRepAdaptor_Surface(cast(explorer.Current())))
            explorer.Next()
        return found

    def distance(self, shape, points):
        """Largest distance of points (n, 3) from a shape, mm."""
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
        from OCP.BRepExtrema import BRepExtrema_DistShapeShape
        from OCP.gp import gp_Pnt

        vertices = [BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, p))).Vertex() for p in points]
        return max(BRepExtrema_DistShapeShape(vertex, shape).Value() for vertex in vertices)

    @staticmethod
    def _mass(integral, shape, bent):
        from OCP.GProp import GProp_GProps

        sums = GProp_GProps()
        integral(shape, sums, *([1e-7] if bent else []))
        return sums.Mass()


@pytest.fixture(scope="session")
def tilted():
    """A frame that is none of the world's, and orthonormal."""
    from elastica_cad import Frame

    x = np.array([2.0, -1.0, 2.0]) / 3
    y = np.array([2.0, 2.0, -1.0]) / 3
    return Frame((5.0, -7.0, 11.0), x, y)
