"""Fixtures shared by all tests."""

import ast
import importlib.util
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent

# do not read the sheets in the user's home; processes started by the tests inherit the empty folder
_NO_SHEETS = tempfile.mkdtemp(prefix="elastica-sheets-")
os.environ["ELASTICA_SHEETS"] = _NO_SHEETS

if importlib.util.find_spec("hypothesis"):
    from hypothesis import settings

    # use the same examples in every run, so that results are comparable; HYPOTHESIS_SEARCH=1 tries new examples
    settings.register_profile("same", derandomize="HYPOTHESIS_SEARCH" not in os.environ, deadline=None)
    settings.load_profile("same")


def _is_core(path: Path) -> bool:
    """Return True if a test module sets `pytestmark = pytest.mark.core`. The module is not imported."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "pytestmark":
            return "pytest.mark.core" in ast.unparse(node.value)
    return False


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Skip modules without the marker under `-m core`, before their import: their libraries may be missing."""
    if config.getoption("markexpr") != "core" or not collection_path.match("test_*.py"):
        return None
    return None if _is_core(collection_path) else True


def pytest_unconfigure() -> None:
    """Delete the temporary folder."""
    shutil.rmtree(_NO_SHEETS, ignore_errors=True)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Fail on skipped tests, because a skip may hide a missing part. Only benchmarks may be skipped."""
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    if reporter is None:
        return
    hidden = [
        report
        for report in reporter.stats.get("skipped", ())
        if not report.nodeid.startswith("tests/benchmarks/")
    ]
    if hidden:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
        reporter.write_line("")
        for report in hidden:
            reporter.write_line(f"skipped: {report.nodeid}: {report.longrepr}", red=True)


@pytest.fixture(scope="session")
def reference_data() -> Path:
    """Return the folder of published reference data; tests/data/README.md names source and licence."""
    return ROOT / "tests" / "data"


@pytest.fixture(scope="session")
def project_root() -> Path:
    return ROOT


def _helper(name: str) -> ModuleType:
    """Import a helper module of the tests' folder."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "tests" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    if name in sys.modules:
        return sys.modules[name]
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def check_drawing_file() -> Callable[..., Any]:
    """Return `check_drawing_file(path)`, which checks a cutting file and returns its curves."""
    return _helper("filechecks").check_drawing_file


@pytest.fixture
def check_drawing(tmp_path: Path) -> Callable[..., None]:
    """Return `check_drawing(drawing, **options of write_drawing)`, which writes and checks DXF and SVG."""
    return partial(_helper("filechecks").check_drawing, folder=tmp_path)


@pytest.fixture(scope="session")
def pavilion() -> Callable[..., Any]:
    """Return `pavilion(count=31, labels=True)`, which makes the paper's Pavilion as a model without slots."""
    return _helper("pavilion").pavilion


@pytest.fixture(scope="session")
def collisions() -> ModuleType:
    """Return the module of bands of bent strips and their distances."""
    return _helper("collisions")


@pytest.fixture(scope="session")
def slotted_pairs() -> ModuleType:
    """Return the module of random pairs of slotted strips and their overlap outside the slots."""
    return _helper("slotted_pairs")


@pytest.fixture(scope="session")
def wide_strips() -> ModuleType:
    """Return the module of strips that bend as plates, with an independent solver."""
    return _helper("wide_strips")
