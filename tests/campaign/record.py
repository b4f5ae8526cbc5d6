"""Runs a campaign and keeps what came out: python -m tests.campaign.record NAME COMMAND [WORD ...]

The last line that the command prints is its result. It is kept with date and commit in `results.json`, and
docs/trust.md is written anew. The exit code is that of the command.
"""

import json
import re
import signal
import subprocess
import sys
from collections import Counter
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path(__file__).with_name("results.json")
PAGE = ROOT / "docs" / "trust.md"

HEAD = """# What the long test runs found

The tests of `make test` are run for every change. Long test runs are called *campaigns*. A campaign is run when a
change affects the code that it tests, and before a release. [How to contribute](contributing.md) says how to run
them. The campaigns *elements* and *solids* have pages of their own: [strips bent by finite
elements](finite_elements.md) and [bodies in three CAD programs](kernels.md).

- *Passed*: no check of the run failed. For the campaigns *elements*, *solids* and *mutants*, it means that the
  measurement was completed, because most of what they measure has no limit.
- *Failed*: a check failed, because the program is wrong or because the check is out of date. Either is mended
  before a release. Newer rows name the tests that failed.
- *Commit*: the version of the program that was tested.
- *Campaign*: its name for `make`, as in `make campaign-held`. `make campaign-fuzz` runs all rows of *fuzz*.

Most rows with random or damaged input (*fuzz*, *held*) are runs of two or three minutes: a longer run may find
more. *Refused* means that the program gave a message about the input, which is correct. *Wrong* counts faults.

| what is tested | outcome | result | date | commit | campaign |
| --- | --- | --- | --- | --- | --- |
"""

TESTED = {
    "banks": "long studies and random curves: results agree with other methods and with published numbers",
    "bodies": "bent and flat bodies in build123d and CadQuery stay valid when they are cut, joined and rounded",
    "elements": "strips from cutting files, bent by finite elements, take the drawn curve",
    "fresh": "the first commands of the README work on a new Debian 12",
    "fuzz: commands": "commands with random options and values give a result or a message",
    "fuzz: compiled code": "the compiled code stays within its memory",
    "fuzz: cutting files": "outlines of random strips are closed, do not cross themselves and fit on the sheet",
    "fuzz: designs": "random changes of design files give a result or a message",
    "fuzz: files": "damaged drawings, tables and meshes give curves or a message",
    "fuzz: limits that are met": "curves near random curves meet the limits that the program says they meet",
    "fuzz: lost curves": "no curve of a random DXF drawing is left out without a message",
    "fuzz: nonsense in Python": "public functions of Python, called with nonsense, give a result or a message",
    "fuzz: typed files": "commands that read a damaged file give a result or a message in a short time",
    "galleries": "every model of the gallery is made, its parts do not collide, and its strips bend",
    "held": "random strips on rails, pins and ties: shape and stability agree with other methods",
    "kills": "killed runs and full disks leave no half-written file; a run on the next day removes the rest",
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
    "soak": "memory (limit: 60 MiB), threads and open files do not grow over many strips",
    "solids": "how many CAD operations on bodies of thirty curves succeed in build123d, CadQuery and FreeCAD",
    "studio": "the page of `elastica studio` in a browser, by mouse and keyboard",
    "typing": "a type checker finds the mistakes in sample programs, and none in the examples of this manual",
    "windows": "every panel and button of the workbench in FreeCAD 0.20, the oldest that it permits",
}
"""What each campaign tests, for a user of the program."""


SAID = {
    "elements": "largest distance from the drawn curve, for a strip of 1 m: "
    "{deviation of strips, plain widths median} mm without correction (median of "
    "{deviation of strips, plain widths strips}; at worst {deviation of strips, plain widths worst} mm), "
    "{deviation of strips, by default median} mm for strips that are corrected by default (median of "
    "{deviation of strips, by default strips}; at worst {deviation of strips, by default worst} mm), "
    "{deviation of strips, compensated median} mm with full correction (median of "
    "{deviation of strips, compensated strips}; at worst {deviation of strips, compensated worst} mm)",
    "fuzz: commands": "{runs} runs: {codes 0} gave a result, {codes 1} gave no strip, {codes 2} refused the input; "
    "{faults} wrong",
    "fuzz: cutting files": "{strips} random strips: {ends Plain} plain, {ends Perforated} perforated, "
    "{ends Laminated} laminated, {ends sentence} refused; {wrong} wrong",
    "fuzz: designs": "{designs} designs: {ends code 0} made, {ends code 1} gave no strip, {ends code 2} refused; "
    "{wrong} wrong",
    "fuzz: files": "{cases} files: {ends curves} gave curves, {ends sentence} refused; {faults} wrong",
    "fuzz: limits that are met": "{solves} curves: {ends MET} said to meet the limits, {ends FAR} to meet them but "
    "far from the random curve, {ends UNSETTLED} to meet them by a search that stopped early, {ends NOT_MET} not "
    "to meet them, {ends sentence} refused; {wrong} wrong",
    "fuzz: lost curves": "{files} files: {ends read} read, {ends read, some named} read with a message about "
    "curves left out, {ends refused} refused; {wrong} wrong",
    "fuzz: typed files": "{files} files: {ends code 0} gave a result, {ends code 1} gave no strip, "
    "{ends code 2} refused; {wrong} wrong",
    "held": "{curves} strips: {ends stable} stable, {ends unstable} unstable, {ends impossible} impossible, "
    "{ends above 8} so uneven in stiffness that shape and stability were not compared; {wrong} wrong",
    "kills": "{killed before a day} runs killed as they wrote: {left} folders left, {a day later} after a day",
    "soak": "after {solves} strips, memory has grown by {grown mib} MiB, threads by {grown threads}, "
    "open files by {grown files}",
    "solids": "{succeeded} of {operations} operations succeeded; [the page](kernels.md) has the causes",
}
"""Results of the campaigns that print a record, in words; a dictionary's counts are named by both keys."""

TESTS = {"passed": "tests passed", "failed": "failed", "error": "stopped by an error",
         "errors": "stopped by an error",
         "xfailed": "failed as expected, because they compare a wording"}  # fmt: skip
"""Words of pytest for what tests came to, and of the page; it also counts warnings, and tests of other runs."""


def page(kept: dict[str, dict[str, Any]]) -> str:
    """The results as Markdown, one row a campaign."""
    return HEAD + "".join(_row(name, last) for name, last in sorted(kept.items()))


def _row(name: str, last: dict[str, Any]) -> str:
    failed, result = last["result"].startswith("FAILED"), last["result"]
    text = _said(name, result.split(": ", 1)[1] if failed else result).replace("|", "/")
    text += f": {', '.join(last['tests'])}" if last.get("tests") else ""
    cells = (TESTED[name], "failed" if failed else "passed", text, last["date"], last["commit"], name)
    return f"| {' | '.join(cells)} |\n"


def _said(name: str, result: str) -> str:
    """The last line of a campaign, in words."""
    if result.startswith("{") and name in SAID:
        record = json.loads(result)
        missed = f"; outside the limits: {', '.join(record['missed'])}" if record.get("missed") else ""
        return SAID[name].format_map(Counter(_figures(record))) + missed
    if re.search(r"\d (passed|failed|errors?)\b.* in [\d.]+s", result):
        counts = {word: number for number, word in re.findall(r"(\d+) (\w+)", result)}
        return ", ".join(f"{counts[word]} {TESTS[word]}" for word in TESTS if word in counts)
    return result


def _figures(record: dict[str, Any]) -> dict[str, Any]:
    """Figures of a record, those of its dictionaries by both names; strings are fractions, shown in thousandths."""
    inner = {
        f"{name} {key}": f"{1000 * float(figure):.2g}" if isinstance(figure, str) else figure
        for name, figures in record.items()
        if isinstance(figures, dict)
        for key, figure in figures.items()
    }
    return record | inner


def run(words: list[str]) -> tuple[int, str, list[str]]:
    """Exit code and last line of a command, and the tests that failed; its output is shown as it comes."""
    last, tests = "", list[str]()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # behind a shell's & tests of Ctrl-C would fail
    with subprocess.Popen(
        words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            last = line.strip("= \n") or last
            tests += re.findall(r"^(?:FAILED|ERROR) \S+::test_(\w+)", line)
    return process.returncode, last, [test.replace("_", " ") for test in tests]


def main(name: str, *words: str) -> int:
    """Run, keep, and give back the command's exit code."""
    code, result, tests = run(list(words))
    run_result = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    kept[name] = {
        "date": datetime.now(UTC).date().isoformat(),
        "commit": run_result.stdout.strip(),
        "result": result if code == 0 else f"FAILED ({code}): {result}",
    } | ({"tests": tests} if tests else {})
    KEPT.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    PAGE.write_text(page(kept), encoding="utf-8")
    return code


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
