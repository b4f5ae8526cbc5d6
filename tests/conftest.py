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

# the sheets that whoever runs the tests keeps at home are not read; what the tests start inherits the empty folder
_NO_SHEETS = tempfile.mkdtemp(prefix="elastica-sheets-")
os.environ["ELASTICA_SHEETS"] = _NO_SHEETS

if importlib.util.find_spec("hypothesis"):
    from hypothesis import settings

    # the same examples in every run, so that a change is judged by itself; HYPOTHESIS_SEARCH=1 looks for new ones
    settings.register_profile("same", derandomize="HYPOTHESIS_SEARCH" not in os.environ, deadline=None)
    settings.load_profile("same")


def _is_core(path: Path) -> bool:
    """Whether a test module says `pytestmark = pytest.mark.core`, read without importing it."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "pytestmark":
            return "pytest.mark.core" in ast.unparse(node.value)
    return False


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """With `-m core` modules without that marker are not even imported: their libraries may be missing."""
    if config.getoption("markexpr") != "core" or not collection_path.match("test_*.py"):
        return None
    return None if _is_core(collection_path) else True


def pytest_unconfigure() -> None:
    """Leave no folder behind."""
    shutil.rmtree(_NO_SHEETS, ignore_errors=True)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A skip may hide a missing part: none is allowed but the benchmarks', which are run on request."""
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
    """Published reference data; tests/data/README.md names source and licence."""
    return ROOT / "tests" / "data"


@pytest.fixture(scope="session")
def project_root() -> Path:
    return ROOT


def _helper(name: str) -> ModuleType:
    """A module of the tests' folder."""
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
    """`check_drawing_file(path)` asserts what every cutting file must be and gives its curves."""
    return _helper("filechecks").check_drawing_file


@pytest.fixture
def check_drawing(tmp_path: Path) -> Callable[..., None]:
    """`check_drawing(drawing, **options of write_drawing)` writes DXF and SVG and runs all file checks."""
    return partial(_helper("filechecks").check_drawing, folder=tmp_path)


@pytest.fixture(scope="session")
def pavilion() -> Callable[..., Any]:
    """`pavilion(count=31, labels=True)` is the paper's Pavilion as a model, without slots."""
    return _helper("pavilion").pavilion


@pytest.fixture(scope="session")
def collisions() -> ModuleType:
    """Bands of bent strips and how near they come to each other."""
    return _helper("collisions")


@pytest.fixture(scope="session")
def slotted_pairs() -> ModuleType:
    """Pairs of strips at random that are slotted together, and what they share beside their slots."""
    return _helper("slotted_pairs")


@pytest.fixture(scope="session")
def wide_strips() -> ModuleType:
    """Strips that bend as plates, solved beside ours."""
    return _helper("wide_strips")
