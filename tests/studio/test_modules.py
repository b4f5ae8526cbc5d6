"""No module of the working folder is imported: not by a command, not by a worker, not by a notebook."""

import json
import subprocess
import sys

import pytest

from tests.studio.conftest import design, running

HOSTILE = """
with open({seen!r}, "a") as file:
    file.write(__name__ + "\\n")
raise ImportError
"""


@pytest.fixture
def folder(tmp_path):
    """A folder in which every module of Python and of a dependency has a hostile namesake."""
    seen = tmp_path / "seen.txt"
    names = sys.stdlib_module_names | {
        "numpy", "scipy", "click", "ezdxf", "highspy", "matplotlib", "anywidget", "tomlkit", "starlette", "uvicorn",
        "websockets", "OCP", "sitecustomize", "usercustomize",
    }  # fmt: skip
    for name in names:
        (tmp_path / f"{name}.py").write_text(HOSTILE.format(seen=str(seen)))
    yield tmp_path
    assert not seen.exists(), seen.read_text()


def test_neither_the_studio_nor_its_workers_import_modules_of_the_working_folder(folder):
    with running(cwd=folder) as server, server.page() as page:
        assert "length" in page.ask("strip", design=design())


def test_a_notebook_whose_folder_comes_first_imports_no_module_of_it(folder):
    question = json.dumps({"do": "strip", "design": design()})
    text = f"""
import sys, json, ast, contextlib, importlib, pathlib, typing  # as the kernel of a notebook has
sys.path.insert(0, "")
import elastica_cad
widget, answers = elastica_cad.studio(), []
widget.send = lambda head, _: answers.append(head)
widget._answer(None, json.loads({question!r}), None)
assert "length" in answers[0], answers
"""
    subprocess.run([sys.executable, "-P", "-c", text], cwd=folder, check=True)
