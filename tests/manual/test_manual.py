"""The manual: every page is run as its reader does, and the site is built without a warning."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import elastica_cad as ec

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
RUN = Path(__file__).with_name("run_page.py")
PAGES = sorted(
    path.relative_to(DOCS).as_posix()
    for folder in ("tutorials", "how_to", "explanation")
    for path in (DOCS / folder).glob("*.md")
)


@pytest.mark.parametrize("page", PAGES)
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


def test_the_site_is_built_without_a_warning(tmp_path):
    done = subprocess.run(
        [sys.executable, DOCS / "build.py", tmp_path / "site"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    shown = (tmp_path / "site" / "reference" / "python.html").read_text(encoding="utf-8")
    packages = {"fabrication", "formats", "forming", "geometry", "mechanics", "plot", "published"}
    assert [name for name in ec.__all__ if name not in packages and f'id="{name.lower()}"' not in shown] == []
    for language, title in (("de", "Ihr erster Streifen"), ("zh_CN", "您的第一条条带")):
        first = (tmp_path / "site" / language / "tutorials" / "first_strip.html").read_text(encoding="utf-8")
        assert title in first
        assert 'href="../../explanation/which_curves.html"' in first  # what is in English only


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
                said = known.get(message.id)
                there = said is not None and said.string and not said.fuzzy
                assert there, f"{language} {name}: {message.id}"
                told = words.get(message.id, said.string)
                assert told == said.string, f"{language} {name}: not as the workbench says it"
