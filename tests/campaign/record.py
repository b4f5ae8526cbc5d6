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
change affects the code that it tests, and before a release. [CONTRIBUTING.md](../CONTRIBUTING.md) says how to run
them. Two campaigns have pages of their own: [strips bent by finite elements](finite_elements.md) and [bodies in
three CAD kernels](kernels.md).

*Commit*: the version of the program that was tested. *Passed*: no check of the run failed. *Failed*: a check
failed, because the program is wrong or because the check is out of date. Either is mended before a release. The row
*release* installs the files of a release and runs a part of the tests, so it can pass while another row fails. The
campaigns *elements* and *mutants* measure something for which there is no limit: how near strips come to
their design, and how many errors the tests notice. There, *passed* means that the measurement was completed.
Runs of *elements* after 8b5ff0f99 also fail if a part with two states, or a strip with forces between its ends,
is outside the limits on its page; *missed* lists their names.

Most rows of random cases are short runs of two or three minutes (*minutes*). They cover few cases: a longer run
may find more. *Figures* is the last line that the run printed, for those who develop the program:

- *passed*, *failed*: numbers of tests. *Deselected* tests belong to another run. *Xfailed* tests are expected
  to fail in this run, because they compare the wording of a message.
- *ends* and *codes*: what happened to the random cases. A refusal with a message is correct (*sentence*,
  *refused*, codes 1 and 2). Faults are counted separately, by *wrong* or *faults*.
- *MET*, *FAR*, *UNSETTLED*, *NOT_MET*: what the program itself reports, namely that the limits are met, met but
  far from the drawn curve, met by a search that stopped early, and not met. It would be a fault to report a
  limit as met that is not met.
- *seed*: start of the random generator; the same seed gives the same cases. *longest_s*, *most_mib*: longest time
  (seconds) and largest memory (MiB) of a case. *Mib*: memory in MiB.

| campaign | what it tests | outcome | date | commit | figures |
| --- | --- | --- | --- | --- | --- |
"""

TESTED = {
    "banks": "long studies and random curves: results agree with other methods and with published numbers",
    "bodies": "bent and flat bodies in build123d and CadQuery stay valid when they are cut, joined and rounded",
    "elements": "cut files, bent by finite elements, take the drawn curve; a deviation of 1.0e-03 is 1 mm in 1 m",
    "fuzz: commands": "every option of every command, with any value, gives a result or a message",
    "fuzz: compiled code": "compiled code stays within its memory; figures: cases, refused and all wrong calls",
    "fuzz: cutting files": "outlines of random strips are closed, do not cross themselves and fit on the sheet",
    "fuzz: designs": "random changes of design files give a result or a message",
    "fuzz: files": "damaged drawings, tables and meshes give curves or a message",
    "fuzz: limits that are met": "random nearest curves meet the limits that they are reported to meet",
    "fuzz: lost curves": "no curve of a random DXF drawing is left out without a message",
    "fuzz: nonsense in Python": "every public function, called with nonsense values, gives a result or a message",
    "fuzz: typed files": "damaged files, given to the commands, give a result or a message in a short time",
    "galleries": "every model of the gallery is made, its parts do not collide, and its strips bend",
    "held": "random strips on rails, pins and ties agree with other methods (*above 8*: ratio, not bent)",
    "kills": "killed runs, full disks leave no half-written file; the next day's run clears their folders (*left*)",
    "letters": "every message is replaced by random letters, and the program still works",
    "manual": "every command and table of this manual is true, and every output is what the program prints",
    "mutants": "how many small errors, put into the program on purpose, its tests notice",
    "oldest": "the program works with the oldest libraries that it permits",
    "programs": "Inkscape, LibreCAD, FreeCAD and others open the cutting files",
    "release": "the files of a release can be built, installed and used",
    "releases: FreeCAD 1.0": "the workbench in FreeCAD 1.0",
    "releases: FreeCAD 1.1": "the workbench in FreeCAD 1.1",
    "releases: newest CadQuery": "bodies in the newest CadQuery",
    "releases: newest build123d": "bodies in the newest build123d",
    "soak": "memory, threads and open files do not grow over many strips (memory by at most 60 MiB)",
    "solids": "operations on bodies of thirty curves in three CAD kernels",
    "studio": "the page of the studio in a browser, by mouse and keyboard",
    "typing": "a type checker finds the mistakes in sample programs, and none in the examples of this manual",
    "windows": "every panel and button of FreeCAD 0.20, by mouse and keyboard",
}
"""What each campaign tests, for a user of the program."""


def page(kept: dict[str, dict[str, str]]) -> str:
    """The results as Markdown, one row a campaign."""
    return HEAD + "".join(_row(name, last) for name, last in sorted(kept.items()))


def _row(name: str, last: dict[str, str]) -> str:
    failed, result = last["result"].startswith("FAILED"), last["result"]
    figures = result.split(": ", 1)[1] if failed else result
    if figures.startswith("{"):
        figures = _figures(json.loads(figures))
    outcome = "failed" if failed else "passed"
    cells = (name, TESTED[name], outcome, last["date"], last["commit"], figures.replace("|", "/"))
    return f"| {' | '.join(cells)} |\n"


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
