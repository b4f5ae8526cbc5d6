"""The manual: every page is run as its reader does, and the site is built without a warning."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
RUN = Path(__file__).with_name("run_page.py")
PAGES = sorted(
    path.relative_to(DOCS).as_posix()
    for folder in ("tutorials", "how_to", "explanation")
    for path in (DOCS / folder).glob("*.md")
)


EVERYDAY = ("tutorials/notebook.md", "how_to/curves.md")
"""Pages of the everyday suite, of code and of commands; `make campaign-manual` runs all."""


@pytest.mark.parametrize(
    "page", [page if page in EVERYDAY else pytest.param(page, marks=pytest.mark.campaign) for page in PAGES]
)
def test_a_page_does_what_it_says(page, tmp_path):
    tools = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": tools, "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, RUN, DOCS / page],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_wrong_page_is_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("```python\nprint(2 + 2)\n```\n\n```text\n5\n```\n", encoding="utf-8")
    done = subprocess.run(
        [sys.executable, RUN, page], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert "printed\n4" in done.stderr


def test_pages_are_plain_markdown():
    """Directives, roles and attributes of Sphinx would be shown as they stand by other viewers."""
    odd = re.compile(r"^\s*(`{3,}\{|:{3,})|\{[\w-]+\}`|\]\([^)]*\)\{", re.MULTILINE)
    pages = [*DOCS.rglob("*.md"), *ROOT.glob("*.md")]
    assert len(pages) > 60
    assert [page.name for page in pages if odd.search(page.read_text(encoding="utf-8"))] == []


def test_reference_pages_are_those_of_the_code(monkeypatch):
    """`make generate` writes them again."""
    monkeypatch.syspath_prepend(str(DOCS))
    import generated_pages

    for name, text in generated_pages.pages().items():
        assert (DOCS / "reference" / name).read_text(encoding="utf-8") == text, name


@pytest.mark.campaign
def test_every_sentence_is_translated(monkeypatch):
    monkeypatch.syspath_prepend(str(DOCS))
    import catalogues

    wanted = catalogues.templates()
    assert len(wanted) > 20
    for language in catalogues.LANGUAGES:
        for name, template in wanted.items():
            known = catalogues.read(catalogues.catalogue_path(language, name))
            words = catalogues.workbench_words(language)
            for message in template:
                if not message.id:
                    continue
                text = known.get(message.id)
                there = text is not None and text.string and not text.fuzzy
                assert there, f"{language} {name}: {message.id}"
                result = words.get(message.id, text.string)
                assert result == text.string, f"{language} {name}: not as the workbench says it"
