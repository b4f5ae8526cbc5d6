"""The pages of the FreeCAD tools: one for each command, with its own words, keys, icon and picture."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WORKBENCH = ROOT / "freecad_workbench" / "freecad" / "elastica_wb"
PAGES = ROOT / "docs" / "freecad_tools"


def words_of(value):
    """A text of a command, or the text in the call that marks it for translation."""
    value = value.args[-1] if isinstance(value, ast.Call) and value.args else value
    return value.value if isinstance(value, ast.Constant) else None


def commands():
    """What each command says of itself, by its name."""
    found = {}
    for file in (WORKBENCH / "commands" / "__init__.py", WORKBENCH / "command.py"):
        for made in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(made, ast.Call) and getattr(made.func, "id", "") == "Command":
                answer = {part.arg: words_of(part.value) for part in made.keywords}
                found[answer["name"]] = answer
    return found


COMMANDS = commands()


@pytest.mark.parametrize("name", COMMANDS)
def test_the_page_says_what_the_command_says(name):
    answer, short = COMMANDS[name], name.removeprefix("Elastica_").lower()
    page = (PAGES / f"{short}.md").read_text(encoding="utf-8")
    assert page.startswith(f"# {answer['text']}\n")
    assert f"\n{answer['tip']}.\n" in page
    assert (f"Keys: `{answer['shortcut']}`" in page) if answer.get("shortcut") else "Keys:" not in page
    assert f"icons/{name}.svg" in page
    assert (PAGES / "pictures" / f"{short}.png").stat().st_size > 10_000


def test_no_page_is_of_a_command_that_is_gone():
    shown = {path.stem for path in PAGES.glob("*.md")} - {"index"}
    assert shown == {name.removeprefix("Elastica_").lower() for name in COMMANDS}
    assert len(shown) > 15
