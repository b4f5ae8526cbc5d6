"""The built manual in Chromium: no lost link, no page wider than a phone, nothing that axe objects to."""

import subprocess
import sys
from pathlib import Path

import pytest

import elastica_cad as ec

ROOT = Path(__file__).resolve().parents[2]
CRAWL = ROOT / "tests" / "manual" / "crawl_site.py"


def crawled(site, *words):
    """How many pages were looked at; none of them is broken."""
    done = subprocess.run(
        [sys.executable, CRAWL, site, *words], capture_output=True, text=True, check=False, timeout=2400
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return int(done.stdout.split()[0])


def built(site, *words):
    done = subprocess.run(
        [sys.executable, ROOT / "docs" / "build.py", site, *words],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return site


def test_a_page_of_the_manual(tmp_path):
    """The site in English is built without a warning, names all public names, and its first tutorial is sound."""
    site = built(tmp_path / "site", "--english")
    shown = (site / "reference" / "python.html").read_text(encoding="utf-8")
    packages = {"design", "formats", "form_finding", "geometry", "mechanics", "model", "pairs", "plot"}
    packages |= {"paper", "strip"}
    assert [name for name in ec.__all__ if name not in packages and f'id="{name.lower()}"' not in shown] == []
    assert crawled(site, "--page", "tutorials/first_strip.html") == 1
    assert 'href="contributing.html"' in (site / "trust.html").read_text(encoding="utf-8")
    crawled(site, "--find", "lamps", "tutorials/lamp.html", "--find", "pytest", "contributing.html")


@pytest.mark.campaign
def test_the_whole_site_in_three_languages(tmp_path):
    site = built(tmp_path / "site")
    for language, title in (("de", "Ihr erster Streifen"), ("zh_CN", "您的第一条条带")):
        first = (site / language / "tutorials" / "first_strip.html").read_text(encoding="utf-8")
        assert title in first
        assert 'href="../../explanation/which_curves.html"' in first  # what is in English only
        assert 'href="../contributing.html"' in (site / language / "index.html").read_text(encoding="utf-8")
    words = {
        "lamps": "tutorials/lamp.html",
        "Lampen": "de/tutorials/lamp.html", "Krümmung": "de/tutorials/bow.html",
        "灯": "zh_CN/tutorials/lamp.html", "曲率": "zh_CN/tutorials/first_strip.html",
        "FreeCAD": "zh_CN/tutorials/freecad.html",
    }  # fmt: skip
    crawled(site, *(part for search in words.items() for part in ("--find", *search)))
    assert crawled(site) > 100


@pytest.mark.campaign
def test_the_page_of_a_kit_shows_its_files(tmp_path):
    elastica = [sys.executable, "-m", "elastica_cad"]
    subprocess.run([*elastica, "new", "arch", "-q"], cwd=tmp_path, check=True)
    subprocess.run([*elastica, "model", "arch.toml", "-q", "-o", "kit"], cwd=tmp_path, check=True)
    crawled(tmp_path / "kit")
