"""Fixtures shared by all tests."""

import importlib.util
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Published reference data beside the checkout; absent on users' machines."""
    folder = ROOT.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("reference data not present beside the checkout")
    return folder


@pytest.fixture(scope="session")
def project_root() -> Path:
    return ROOT


def _filechecks() -> ModuleType:
    spec = importlib.util.spec_from_file_location("filechecks", ROOT / "tests" / "filechecks.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def check_drawing_file() -> Callable[..., Any]:
    """`check_drawing_file(path)` asserts what every cutting file must be and gives its curves."""
    return _filechecks().check_drawing_file


@pytest.fixture
def check_drawing(tmp_path: Path) -> Callable[..., None]:
    """`check_drawing(drawing, **options of write_drawing)` writes DXF and SVG and runs all file checks."""
    return partial(_filechecks().check_drawing, folder=tmp_path)
