"""By what each table of the manual is proved: rows are asked, or the whole table is written by a script.

Modules beside this one decorate functions by `asks`; a function is given a row and fails where the row is wrong.
"""

from collections.abc import Callable
from contextlib import chdir
from pathlib import Path

from click.testing import CliRunner

from elastica_cad.cli.commands import elastica
from tests.manual.found_in_pages import ROOT

Asker = Callable[[tuple[str, ...], Path], None]
ASKED: dict[tuple[str, tuple[str, ...]], Asker] = {}
"""Who asks the rows of a table, by page and head."""

WRITTEN = {
    "docs/explanation/validation.md": "tests/manual/test_validation_page.py::test_the_tables_are_what_a_run_gives",
    "docs/explanation/speed.md": "tests/manual/test_speed_page.py::test_the_page_is_what_was_kept",
    "docs/finite_elements.md": "tests/manual/test_tables.py::test_pages_of_campaigns_are_what_was_measured",
    "docs/kernels.md": "tests/manual/test_tables.py::test_pages_of_campaigns_are_what_was_measured",
    "docs/trust.md": "tests/manual/test_tables.py::test_pages_of_campaigns_are_what_was_measured",
    "docs/models_in_numbers.md": "tests/examples/test_gallery_examples.py::"
    "test_the_table_is_of_the_models_as_they_are",
}
"""Pages whose tables a script writes, and the test that compares."""

ARCH = """<svg xmlns="http://www.w3.org/2000/svg" width="240mm" height="180mm" viewBox="0 0 240 180">
  <path id="arch" d="M 20 160 C 20 40 220 40 220 160" fill="none" stroke="black"/>
</svg>
"""
"""The arch of the manual's pages."""

PLY = ("--sheet", "birch-plywood-0.8", "--max-width", "30")
QUICK = ("--no-step", "--no-pictures")


def asks(page: str, *head: str) -> Callable[[Asker], Asker]:
    """The function asks each row of the page's table with this head."""

    def keep(function: Asker) -> Asker:
        assert (page, head) not in ASKED
        ASKED[page, head] = function
        return function

    return keep


def typed(folder: Path, *words: str, code: int | None = 0, stdin: str | None = None) -> str:
    """What a command prints in a folder, on both streams."""
    with chdir(folder):
        done = CliRunner().invoke(elastica, words, input=stdin)
    text = done.output + (getattr(done, "stderr", "") if "Error" not in done.output else "")
    assert code in (None, done.exit_code), f"{words}: {text}{done.exception}"
    return text


def proved_by(test: str) -> None:
    """The test is there; it runs with all others."""
    file, name = test.split("::")
    assert f"def {name}(" in (ROOT / file).read_text(encoding="utf-8"), test
