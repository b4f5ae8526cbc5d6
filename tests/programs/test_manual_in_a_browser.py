"""The built manual in Chromium: no lost link, no page wider than a phone, nothing that axe objects to."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_a_reader_meets_nothing_broken(tmp_path):
    site = tmp_path / "site"
    subprocess.run([sys.executable, ROOT / "docs" / "build.py", site], check=True)
    crawl = ROOT / "tests" / "manual" / "crawl_site.py"
    done = subprocess.run(
        [sys.executable, crawl, site], capture_output=True, text=True, check=False, timeout=2400
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert int(done.stdout.split()[0]) > 100  # in three languages every page is linked from the first
