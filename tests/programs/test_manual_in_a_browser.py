"""The built manual in Chromium: no lost link, no page wider than a phone, nothing that axe objects to."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CRAWL = ROOT / "tests" / "manual" / "crawl_site.py"


def test_a_reader_meets_nothing_broken(tmp_path):
    site = tmp_path / "site"
    subprocess.run([sys.executable, ROOT / "docs" / "build.py", site], check=True)
    done = subprocess.run(
        [sys.executable, CRAWL, site], capture_output=True, text=True, check=False, timeout=2400
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert int(done.stdout.split()[0]) > 100  # in three languages every page is linked from the first


def test_the_page_of_a_kit_shows_its_files(tmp_path):
    elastica = [sys.executable, "-m", "elastica_cad"]
    subprocess.run([*elastica, "new", "arch", "-q"], cwd=tmp_path, check=True)
    subprocess.run([*elastica, "model", "arch.toml", "-q", "-o", "kit"], cwd=tmp_path, check=True)
    crawled = [sys.executable, CRAWL, tmp_path / "kit"]
    done = subprocess.run(crawled, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
