"""Kernels that are missing or not known are told in one sentence."""

import importlib
import importlib.util
import re
import signal
import sys
from importlib.metadata import version
from pathlib import Path as Files

import pytest

from elastica_cad import MissingDependencyError, Path
from elastica_cad.kernel import occt, ocp_import
from elastica_cad.kernel import step_files as step
from elastica_cad.strip import FlatSolid

PLATE = FlatSolid(Path.rectangle(10, 5), (), 1.0)


@pytest.fixture(autouse=True)
def fresh():
    """The kernel is looked for once: forget it before and after."""
    ocp_import.kernel.cache_clear()
    yield
    ocp_import.kernel.cache_clear()


@pytest.mark.parametrize("version", ["6.4.1", "9.0", ""])
def test_unknown_version(version, monkeypatch):
    import OCP

    monkeypatch.setattr(OCP, "__version__", version)
    with pytest.raises(MissingDependencyError, match=r"works with 7\.x and 8\.x"):
        occt.make_solid(PLATE)


def test_it_is_an_import_error(monkeypatch):
    """As a library's own complaint would be."""
    monkeypatch.setitem(sys.modules, "OCP", None)
    with pytest.raises(ImportError, match="pip install"):
        occt.make_wire(Path.rectangle(1, 1))


def test_version_that_cannot_be_reported(monkeypatch):
    import OCP

    monkeypatch.delattr(OCP, "__version__")
    with pytest.raises(MissingDependencyError, match=r"OCP \? is installed"):
        ocp_import.kernel()


def test_no_kernel_at_all(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "OCP", None)
    with pytest.raises(MissingDependencyError, match="pip install build123d"):
        occt.make_solid(PLATE)
    with pytest.raises(MissingDependencyError):
        step.write_step([step.NamedShape("plate", None)], tmp_path / "plate.step")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("library", ["build123d", "cadquery"])
def test_skin_without_its_library(library, monkeypatch):
    """As where the other kernel alone is installed: an ImportError that says what to install."""
    monkeypatch.setitem(sys.modules, library, None)
    monkeypatch.delitem(sys.modules, f"elastica_cad.{library}", raising=False)
    with pytest.raises(ImportError, match=f"pip install {library}"):
        importlib.import_module(f"elastica_cad.{library}")


def test_the_page_for_scripts_names_what_is_tested():
    """The newest of a library may be newer than the page; the versions it names are there, or older."""
    page = (Files(__file__).resolve().parents[2] / "docs" / "code_cad.md").read_text(encoding="utf-8")
    named = {
        library: [
            tuple(map(int, found.split("."))) for found in re.findall(rf"{library} (\d+\.\d+\.\d+)", page)
        ]
        for library in ("build123d", "CadQuery")
    }
    installed = {one: version(one.lower()) for one in named if importlib.util.find_spec(one.lower())}
    assert installed
    for library, found in installed.items():
        have = tuple(map(int, found.split(".")[:3]))
        assert have in named[library] or have > max(named[library])


def test_ctrl_c_while_the_kernel_is_loaded_ends_the_program(monkeypatch):
    """OCP makes an ImportError of an interrupt, so the interrupt waits until the kernel is loaded."""

    def interrupted(name):
        signal.raise_signal(signal.SIGINT)
        return importlib.import_module(name)

    monkeypatch.setattr(ocp_import, "import_module", interrupted)
    with pytest.raises(KeyboardInterrupt):
        ocp_import.kernel.__wrapped__()
