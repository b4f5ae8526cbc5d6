"""Runs a campaign and keeps what came out: python -m tests.campaign.record NAME COMMAND [WORD ...]

The last line that the command prints is its result. It is kept with date and commit in `results.json`, and
docs/trust.md is written anew. The exit code is that of the command.
"""

import json
import signal
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path(__file__).with_name("results.json")
PAGE = ROOT / "docs" / "trust.md"

HEAD = """# What the long test runs found

The tests of `make test` are run for every change. Long test runs are called *campaigns*. A campaign is run when a
change affects the code that it tests, and before a release. [CONTRIBUTING.md](../CONTRIBUTING.md) says
what each campaign proves.

*Passed*: the run found nothing wrong. *Failed*: it found something; the figures say how much. Such a fault is
mended before a release. Two campaigns have pages of their own: [strips bent by finite
elements](finite_elements.md) and [bodies in three CAD kernels](kernels.md).

| campaign | outcome | date | commit | figures |
| --- | --- | --- | --- | --- |
"""


def page(kept: dict[str, dict[str, str]]) -> str:
    """The results as Markdown, one row a campaign."""
    return HEAD + "".join(_row(name, last) for name, last in sorted(kept.items()))


def _row(name: str, last: dict[str, str]) -> str:
    failed, result = last["result"].startswith("FAILED"), last["result"]
    figures = result.split(": ", 1)[1] if failed else result
    if figures.startswith("{"):
        figures = _figures(json.loads(figures))
    outcome = "failed" if failed else "passed"
    return f"| {name} | {outcome} | {last['date']} | {last['commit']} | {figures.replace('|', '/')} |\n"


def _figures(record: dict[str, object]) -> str:
    """The record that a campaign prints, in words: "runs 249; codes: 0 (96), 2 (151)"."""
    parts = list[str]()
    for name, figure in record.items():
        if isinstance(figure, dict):
            parts.append(f"{name}: {', '.join(f'{key} ({value})' for key, value in figure.items())}")
        else:
            parts.append(f"{name} {figure}")
    return "; ".join(parts)


def run(words: list[str]) -> tuple[int, str]:
    """Exit code and last line of a command, whose output is shown as it comes."""
    last = ""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # behind a shell's & tests of Ctrl-C would fail
    with subprocess.Popen(
        words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            last = line.strip("= \n") or last
    return process.returncode, last


def main(name: str, *words: str) -> int:
    """Run, keep, and give back the command's exit code."""
    code, result = run(list(words))
    told = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    kept[name] = {
        "date": datetime.now(UTC).date().isoformat(),
        "commit": told.stdout.strip(),
        "result": result if code == 0 else f"FAILED ({code}): {result}",
    }
    KEPT.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    PAGE.write_text(page(kept), encoding="utf-8")
    return code


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
