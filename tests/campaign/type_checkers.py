"""Pyright on what users write: it finds each mistake, and none in correct files and in the examples of the manual.

python -m tests.campaign.type_checkers (make campaign-typing); basedpyright is Pyright in a wheel with its own Node.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WRITTEN = ROOT / "tests" / "cad" / "typing"
WORKBENCH = ROOT / "freecad_workbench"
UNTYPED = "from typing import Any\ndef __getattr__(name: str) -> Any: ...\n"
"""Stub of FreeCAD, whose names have no types."""


def write_pages(folder: Path) -> list[Path]:
    """Write the Python blocks of each page of the manual into a file, beside a stub of FreeCAD."""
    (folder / "FreeCAD.pyi").write_text(UNTYPED)
    for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
        blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)
        if blocks and "reference" not in page.parts:
            name = "_".join(page.relative_to(ROOT).with_suffix("").parts).replace("-", "_")
            (folder / f"page_{name}.py").write_text("\n".join(blocks))
    return sorted(folder.glob("*.py"))


def errors_of_pyright(folder: Path, *files: Path) -> list[tuple[str, int, str]]:
    """Return file name, line from 1 and text of each error."""
    settings = {
        "typeCheckingMode": "standard", "include": [*map(str, files)],
        "extraPaths": [*map(str, (ROOT, WORKBENCH, folder))],
    }  # fmt: skip
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [
        sys.executable,
        "-m",
        "basedpyright",
        "-p",
        folder,
        "--pythonpath",
        sys.executable,
        "--outputjson",
    ]
    answer = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)
    assert answer["summary"]["filesAnalyzed"] >= len(files)
    return [
        (Path(error["file"]).name, error["range"]["start"]["line"] + 1, error["message"])
        for error in answer["generalDiagnostics"]
        if error["severity"] == "error"
    ]


def main() -> None:
    mistakes = WRITTEN / "mistakes.py"
    lines = mistakes.read_text().splitlines()
    expected = {(mistakes.name, n) for n, line in enumerate(lines, start=1) if "# mistake" in line}
    with tempfile.TemporaryDirectory() as folder:
        pages = write_pages(Path(folder))
        errors = errors_of_pyright(Path(folder), *WRITTEN.glob("*.py"), *pages)
    missed = expected - {error[:2] for error in errors}
    wrong = [error for error in errors if error[:2] not in expected]
    if missed or wrong:
        raise SystemExit(f"missed {sorted(missed)}, found without reason {wrong}")
    print(f"pyright finds all {len(expected)} mistakes, and none in {len(pages)} pages of the manual")


if __name__ == "__main__":
    main()
