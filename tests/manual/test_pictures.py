"""Pictures of the manual are those that their scripts draw."""

import importlib.util
import re
import runpy
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from elastica_cad.cli.commands import elastica
from tests.manual.found_in_pages import PAGES, ROOT

pytestmark = pytest.mark.campaign

DOCS = ROOT / "docs"
TOOLS = DOCS / "freecad_tools" / "pictures"
DRAWS_TOOLS = (ROOT / "tests" / "freecad" / "scripts" / "manual_pictures.py").read_text(encoding="utf-8")


def script_of(name):
    """A script beside the pages, as a module."""
    spec = importlib.util.spec_from_file_location(name, DOCS / f"{name}.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    return script


def test_the_steps_of_the_theorem_are_drawn_by_the_functions_that_decide(tmp_path, monkeypatch):
    script = script_of("theorem_picture")
    result = matplotlib.image.imread(script.PICTURE)
    monkeypatch.setattr(script, "PICTURE", tmp_path / "theorem1.png")
    script.main()
    drawn = matplotlib.image.imread(script.PICTURE)
    assert drawn.shape == result.shape
    assert np.abs(drawn - result).mean() < 0.01, "draw it again: python docs/theorem_picture.py"


def shown():
    """Every picture that a page shows, as a path from the repository."""
    found = set()
    for page in PAGES:
        for target in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text(encoding="utf-8")):
            found.add((page.parent / target).resolve().relative_to(ROOT).as_posix())
    return sorted(found)


@pytest.mark.parametrize("picture", shown())
def test_a_script_draws_it(picture):
    """Icons are drawings themselves, written as text."""
    path = ROOT / picture
    assert path.is_file()
    if path.parent.name == "icons":
        assert path.read_text(encoding="utf-8").lstrip().startswith(("<?xml", "<svg"))
    elif path.parent == TOOLS:
        names = re.findall(r'"(?:Elastica_)?(\w+)"', DRAWS_TOOLS, re.MULTILINE)
        assert path.stem in {name.lower() for name in names}
    elif path.parent == DOCS / "how_to" / "pictures":
        assert path.stem in script_of("how_to_pictures").MADE
    elif picture in ("docs/explanation/theorem1.png", "docs/plan.svg"):
        return  # compared above and by tests/house
    elif path.parent.name in ("explanation", "tutorials"):
        assert path.stem in (DOCS / "pair_pictures.py").read_text(encoding="utf-8")
    elif path.parent == DOCS / "studio":
        assert path.stem in ("drawing", "lamp", "drag")  # the page of the studio as a browser showed it
    elif path.parent.name == "cad":
        assert any(path.stem in script.name for script in path.parent.glob("*.py"))
    elif path.parent.name == "arch":
        assert picture == "examples/arch/arch.png"  # compared below
    else:
        assert path.stem == path.parent.name  # drawn by docs/gallery.py
        gallery = (ROOT / "docs" / "gallery.py").read_text(encoding="utf-8")
        studies = (ROOT / "docs" / "studies.py").read_text(encoding="utf-8")
        assert f'"{path.stem}"' in gallery + studies


def test_tools_are_shown_in_every_language_and_small():
    english = {path.stem for path in TOOLS.glob("*.png") if "." not in path.stem}
    assert {"live", "strip", "nearest"} <= english
    for language in ("de", "zh_CN"):
        assert {path.name.split(".")[0] for path in TOOLS.glob(f"*.{language}.png")} == english
    assert max(path.stat().st_size for path in TOOLS.glob("*.png")) < 90_000


def test_the_first_picture_is_drawn_by_its_script(tmp_path):
    runpy.run_path(str(ROOT / "docs" / "gallery.py"))["draw_arch"](tmp_path / "arch.png")
    result, drawn = (
        matplotlib.image.imread(p) for p in (ROOT / "examples/arch/arch.png", tmp_path / "arch.png")
    )
    assert drawn.shape[:2] == result.shape[:2]
    off = np.abs(drawn[..., :3] - result[..., :3]).mean()
    assert off < 0.02, "draw it again: python docs/gallery.py --pictures"


@pytest.mark.parametrize("page", ["curves", "tabs"])
def test_a_how_to_page_shows_what_its_commands_make(page, tmp_path, monkeypatch):
    script = script_of("how_to_pictures")
    monkeypatch.setattr(script, "MADE", {page: script.MADE[page]})
    script.main(tmp_path)
    result, drawn = (matplotlib.image.imread(place / f"{page}.png") for place in (script.PICTURES, tmp_path))
    assert drawn.shape[:2] == result.shape[:2]
    assert np.abs(drawn[..., :3] - result[..., :3]).mean() < 0.02, (
        "draw it again: python docs/how_to_pictures.py"
    )


def test_every_task_of_the_command_line_is_shown():
    shown_there = {Path(one).stem for one in shown() if "/how_to/" in one}
    assert shown_there == set(script_of("how_to_pictures").MADE)
    pages = "".join(one.read_text(encoding="utf-8") for one in DOCS.glob("*o*/*.md"))
    typed = set(re.findall(r"^elastica (\w+)", pages, re.MULTILINE))
    assert typed == set(elastica.commands) - {"studio"}  # it goes on until Ctrl-C
