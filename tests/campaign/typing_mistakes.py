"""Pyright on a user's file with ten mistakes: it finds each, and nothing else.

python tests/campaign/typing_mistakes.py
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "tests" / "cad" / "typing" / "mistakes.py"


def main() -> None:
    lines = FILE.read_text().splitlines()
    meant = {number for number, line in enumerate(lines) if "# mistake" in line}
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "--outputjson", str(FILE)]
    found = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)
    told = {
        one["range"]["start"]["line"] for one in found["generalDiagnostics"] if one["severity"] == "error"
    }
    if told != meant:
        raise SystemExit(f"missed {sorted(meant - told)}, told without reason {sorted(told - meant)}")
    print(f"pyright finds all {len(meant)} mistakes and no others")


if __name__ == "__main__":
    main()
