"""mypy sees users' mistakes through both the classes' own arguments and the typed options."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "tests" / "cad" / "typing" / "mistakes.py"


@pytest.mark.campaign
def test_mypy_finds_the_mistakes_it_can():
    """Two of them need the types of build123d itself, which mypy does not follow here."""
    lines = FILE.read_text().splitlines()
    meant = {n for n, line in enumerate(lines, start=1) if line.endswith("# mistake")}
    command = [sys.executable, "-m", "mypy", "--no-error-summary", "--hide-error-context", str(FILE)]
    said = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT).stdout
    told = {
        int(line.split(":")[1]) for line in said.splitlines() if "mistakes.py" in line and ": error:" in line
    }
    assert told == meant
