"""`import elastica_cad` costs a moment: no library is loaded before it is used."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.core


def test_import_needs_numpy_only(project_root):
    code = (
        "import sys, elastica_cad\n"
        "heavy = {'scipy', 'highspy', 'ezdxf', 'svgelements', 'click', 'matplotlib', 'OCP', 'shapely'}\n"
        "print(sorted(heavy & {name.split('.')[0] for name in sys.modules}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.stdout.strip() == "[]", result.stderr


def test_a_nearest_rod_and_its_curve_need_no_package_of_scipy(project_root):
    """They take a third of a second: as long as ten strips."""
    code = (
        "import sys, elastica_cad as ec\n"
        "arch = ec.PlaneCurve.spline([(0, 0), (60, 110), (160, 150), (260, 110), (320, 0)])\n"
        "near = ec.nearest_rod(arch, ec.Limits(ratio=1.6))\n"
        "heavy = {'scipy.' + name for name in ('interpolate', 'linalg', 'optimize', 'special')}\n"
        "curve = near.rod.curve\n"
        "print(near.rod.ratio < 1.6 * (1 + 1e-9), sorted(heavy & set(sys.modules)))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=project_root, capture_output=True, text=True, check=False
    )
    assert result.stdout.strip() == "True []", result.stderr
