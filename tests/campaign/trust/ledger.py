"""The ledger of trust: each public claim, the command that asks it again, when it did, and what came out.

python -m tests.campaign.trust.ledger --out out/campaign --claims

With --claims the tests of every claim are run. Sums of campaigns are gathered from the folder that these write to.
`docs/trust.md` is written anew.
"""

import argparse
import json
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from tests.campaign.trust.verdicts import Record, summary, survivors, together

ROOT = Path(__file__).resolve().parents[3]
KEPT = Path(__file__).with_name("measured.json")
PAGE = ROOT / "docs" / "trust.md"

CLAIMS = {
    ("README.md", "what is cut, read and bent by another solver, is the drawn curve", "takes exactly that curve"):
        "tests/validation/test_closed_loop.py",
    ("README.md", "curves are read from all these formats", "Curves come from DXF, SVG, CSV points, JSON"):
        "tests/unit/formats/test_read_curves.py",
    ("README.md", "a real FreeCAD makes strips of sketches", "it runs on FreeCAD 0.20, 1.0 and 1.1"):
        "tests/freecad/test_strip_feature.py",
    ("README.md", "its blocks for both CAD libraries run", "BuildLine, BuildPart, Plane, Spline"):
        "tests/examples/test_readme_cad.py",
    ("docs/gallery.md", "every model can be cut, bent and put together", "each a short script to change"):
        "tests/examples/test_gallery_examples.py",
    ("docs/explanation/validation.md", "the tables are those of a run", "written by a run"):
        "tests/manual/test_validation_page.py",
    ("docs/explanation/left_out.md", "between clamps creep takes force and leaves the shape",
     "the shape of a strip between clamps stays, its force falls"): "tests/validation/test_creep.py",
    ("docs/explanation/left_out.md", "a strip stays in its plane where it is said to",
     "the strip stays in its plane, or not, or undecided: wide ones"): "tests/validation/test_sideways.py",
    ("docs/how_to/batten.md", "tapers are those of closed forms", "Planed thinner towards one end"):
        "tests/validation/test_tapered_tables.py",
    ("docs/explanation/which_curves.md", "a strip bends exactly when one line meets its inflections",
     "one straight line meets it in its inflections"): "tests/unit/mechanics/test_equilibrium_check.py",
    ("docs/how_to/cutting.md", "one closed loop a cut", "one closed loop a cut"):
        "tests/unit/formats/test_cutting_files.py",
    ("docs/how_to/curves.md", "pen curves are made fair within 0.1 mm", "made fair within 0.1 mm"):
        "tests/properties/test_fairing_properties.py",
    ("docs/architecture.md", "a verdict never hangs on a sampling", "a verdict never hangs on a sampling"):
        "tests/unit/geometry/test_curvature_zeros.py",
    ("docs/architecture.md", "least ratios are those of the paper's linear program", "Eqs. 4 and 6 as printed"):
        "tests/validation/test_optimal_ratios.py",
    ("docs/architecture.md", "stability is that of the published code", "conjugate points"):
        "tests/validation/test_stability_reference.py",
    ("docs/architecture.md", "bent strips are elastica", "second variation, margin"):
        "tests/validation/test_elastica_tables.py",
    ("docs/architecture.md", "all files appear together or not at all", "appear together or not at all"):
        "tests/unit/formats/test_living_writers.py",
    ("SECURITY.md", "files are read within limits", "counted before they are expanded"):
        "tests/unit/formats/test_hostile_drawings.py",
    ("SECURITY.md", "names are texts in every file", "texts in every file"):
        "tests/properties/test_hostile_labels.py",
    ("SECURITY.md", "a design reads below its own folder", "below its own folder"):
        "tests/unit/formats/test_design_files.py",
    ("SECURITY.md", "the same bytes in every run", "the same bytes"): "tests/unit/cli/test_budget_and_bytes.py",
}  # fmt: skip
"""Page, claim and the page's own words, and the tests that ask it."""


def today() -> str:
    return datetime.now(UTC).date().isoformat()


def asked(tests: str) -> dict[str, str]:
    """The claim's tests, run: date and how many passed."""
    plain = ("-n", "0", "-p", "no:cacheprovider", "-o", "addopts=--import-mode=importlib")
    words = [sys.executable, "-m", "pytest", *plain, tests]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    figure = done.stdout.strip().splitlines()[-1].strip("= ").rpartition(" in ")[0]
    return {"date": today(), "figure": figure if done.returncode == 0 else f"FAILED: {figure}"}


def gathered(folder: Path) -> dict[str, dict[str, Any]]:
    """What campaigns left in their folder, in words, by their commands, and mutants that no test notices."""
    found, drawn = dict[str, dict[str, Any]](), dict[str, Record]()
    for file in sorted(folder.glob("*.json")):
        kind, record = file.stem.partition("-")[0], json.loads(file.read_text())
        date = datetime.fromtimestamp(file.stat().st_mtime, UTC).date().isoformat()
        for command, figure in _told(kind, record, file.stem.rpartition("-")[2]):
            found[command] = {"date": date, "figure": figure}
            if kind == "mutants":
                found[command]["survivors"] = survivors(record)
                drawn[file.stem.rpartition("-")[2]] = record
    if len(drawn) > 1:
        found[f"python -m tests.campaign.trust.mutants, seeds {' and '.join(drawn)}"] = {
            "date": max(one["date"] for one in found.values() if "survivors" in one),
            "figure": summary(together(list(drawn.values()))),
        }
    return found


def _told(kind, record, seed):
    """Command and figure of a campaign's record."""
    module = f"python -m tests.campaign.trust.{kind}"
    if kind == "files":
        sums = record["sums"]
        bad = {what: n for what, n in sums["ends"].items() if what not in ("curves", "sentence")}
        wrong = ", ".join(f"{n} {what}" for what, n in bad.items()) or "no fault"
        good = f"{sums['ends'].get('curves', 0)} give curves, {sums['ends'].get('sentence', 0)} one sentence"
        most = f"longest {sums['longest_s']} s, most {sums['most_mib']} MB"
        yield f"{module} --seed {seed}", f"{sums['cases']} files: {good}, {wrong}; {most}"
    elif kind == "commands":
        sums = record["sums"]
        yield (
            f"{module} --seed {seed}",
            f"{sums['runs']} runs, {sums['faults']} faults; longest {sums['longest_s']} s",
        )
    elif kind == "designs":
        sums = record["sums"]
        made = ", ".join(f"{n} with {name}" for name, n in sorted(sums["ends"].items()))
        yield f"{module} --seed {seed}", f"{sums['designs']} designs ({made}), {sums['wrong']} wrong"
    elif kind == "mets":
        sums = record["sums"]
        met = ", ".join(f"{n} {name}" for name, n in sums["ends"].items())
        yield (
            f"python -m tests.campaign.trust.met_checks --seed {seed}",
            (f"{sums['solves']} solves ({met}), {sums['wrong']} wrong"),
        )
    elif kind == "written":
        sums = record["sums"]
        made = ", ".join(f"{n} {name}" for name, n in sorted(sums["ends"].items()))
        yield (
            f"{module} --seed {seed}",
            f"{sums['strips']} strips ({made}), {sums['wrong']} with a fault in their files",
        )
    elif kind == "faults":
        for part in record:
            (name, count), *rest = part.items()
            more = "".join(f", {value} {key}" for key, value in rest if key != "wrong")
            yield f"{module}, {name}", f"{count} {name}{more}, {len(part['wrong'])} wrong"
    elif kind == "soak":
        grown = ", ".join(f"{value} {key}" for key, value in record["grown"].items())
        yield module, f"{record['solves']} solves in one process; grown by {grown}"
    elif kind == "mutants":
        yield f"{module} --seed {seed}", summary(record)


def page(kept) -> str:
    """The ledger as Markdown."""
    lines = [
        "# Ledger of trust", "",
        "`make campaign` writes this page (`tests/campaign/trust/ledger.py`): what is claimed in public, the",
        "command that asks it again, when it last did, and what came out. FAILED is a claim that does not hold.",
        "Faults that a campaign found stay in its row as it went; those that are mended have tests.",
        "", "## Claims", "", "| claim | where | command | date | figure |", "| --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    for (where, claim, _), tests in CLAIMS.items():
        last = kept["claims"].get(tests, {"date": "not run yet", "figure": ""})
        lines.append(f"| {claim} | {where} | `pytest {tests}` | {last['date']} | {last['figure']} |")
    lines += [
        "", "Strips bent by finite elements have [a page of their own](finite_elements.md).",
        "", "## Campaigns", "", "| command | date | figure |", "| --- | --- | --- |",
    ]  # fmt: skip
    ran = kept["campaigns"].items()
    lines += [f"| `{command}` | {last['date']} | {last['figure']} |" for command, last in ran]
    lines += [
        "", "## Mutants that no test notices", "",
        "Of the mutants above these change an answer, or run where the bank of requests does not go. A mutant that",
        "gives every answer of the bank as before, to 1e-6, and that no test of a long look notices, is equivalent",
        "and not listed (`tests/campaign/trust/equivalent.py`); the bank sees only what it asks. Rates are those",
        "against the tests as they were mended after the first look. A seed draws from the program as it is on its",
        "date: seed 101 was left at 203 of 400 as files had changed; seed 102, with --count 200, drew what was",
        "missing, and three again.",
        "", "| file | change | why it is left |", "| --- | --- | --- |",
    ]  # fmt: skip
    left = dict.fromkeys(tuple(row) for one in ran for row in one[1].get("survivors", ()))
    lines += [f"| {' | '.join(_in_table(text) for text in row)} |" for row in left]
    return "\n".join([*lines, ""])


def _in_table(text: str) -> str:
    """A text in one cell of a table, as it is."""
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--claims", action="store_true", help="run the tests of every claim")
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    options = parser.parse_args()
    kept = json.loads(KEPT.read_text()) if KEPT.exists() else {"claims": {}, "campaigns": {}}
    kept["campaigns"].update(gathered(options.out))
    for tests in CLAIMS.values() if options.claims else ():
        kept["claims"][tests] = asked(tests)
        print(tests, kept["claims"][tests]["figure"], flush=True)
        KEPT.write_text(json.dumps(kept, indent=1) + "\n")
    KEPT.write_text(json.dumps(kept, indent=1) + "\n")
    PAGE.write_text(page(kept), encoding="utf-8")


if __name__ == "__main__":
    main()
