"""mypy sees users' mistakes through both the classes' own arguments and the typed options."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.campaign.type_checkers import WORKBENCH, write_pages

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "tests" / "cad" / "typing" / "mistakes.py"


@pytest.mark.campaign
def test_mypy_finds_the_mistakes_it_can():
    """Two of them need the types of build123d itself, which mypy does not follow here."""
    lines = FILE.read_text().splitlines()
    meant = {n for n, line in enumerate(lines, start=1) if line.endswith("# mistake")}
    command = [sys.executable, "-m", "mypy", "--no-error-summary", "--hide-error-context", str(FILE)]
    text = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT).stdout
    result = {
        int(line.split(":")[1]) for line in text.splitlines() if "mistakes.py" in line and ": error:" in line
    }
    assert result == meant


def strict(*files):
    """The errors that strict mypy finds in files, whose functions need no types."""
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--allow-untyped-defs",
        "--allow-untyped-calls",
        "--no-error-summary",
        "--explicit-package-bases",
        *files,
    ]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT).stdout


@pytest.mark.campaign
def test_mypy_accepts_what_users_write():
    assert strict(ROOT / "tests" / "cad" / "typing" / "correct.py") == ""


@pytest.mark.campaign
def test_mypy_accepts_the_examples_of_the_manual(tmp_path, monkeypatch):
    written = write_pages(tmp_path)
    assert len(written) > 10
    monkeypatch.setenv("MYPYPATH", f"{tmp_path}:{WORKBENCH}")
    assert strict("--follow-imports=silent", *written) == ""
