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
