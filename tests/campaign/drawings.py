"""What every drawing of a folder gives, as a table: python tests/campaign/drawings.py FOLDER > table.md

The verdicts are those of tests/unit/formats/test_public_drawings.py, which asks the drawings that are kept; with
tests/data/public it prints the table of these again.
"""

import runpy
import sys
import time
from collections import Counter
from pathlib import Path

HERE = Path(__file__).parent
given = runpy.run_path(str(HERE.parent / "unit" / "formats" / "test_public_drawings.py"))["given"]
KINDS = ("bends", "healed", "faired", "refused", "undecided", "corner", "closed", "no curve", "skipped")
SUFFIXES = (".svg", ".dxf", ".step", ".stp")


def main(folder):
    """One row for each file, then the sums; a file that ends in anything but a sentence is named as a fault."""
    print(f"| drawing | {' | '.join(KINDS)} | said | s |")
    print(f"| --- |{' ---: |' * len(KINDS)} --- | ---: |")
    sums, faults = Counter(), 0
    files = sorted(path for path in Path(folder).rglob("*") if path.suffix.lower() in SUFFIXES)
    for path in files:
        start = time.process_time()
        try:
            found = given(path)
        except Exception as problem:  # what no reader may do
            found, faults = f"FAULT {type(problem).__name__}: {problem}", faults + 1
        counts, text = (found, "") if isinstance(found, dict) else ({}, found)
        sums.update(counts)
        cells = [str(counts.get(kind, "")) for kind in KINDS]
        row = [path.relative_to(folder).as_posix(), *cells, text.replace("|", "/").replace(str(folder), "")]
        print(f"| {' | '.join(row)} | {time.process_time() - start:.2f} |", flush=True)
    totals = " | ".join(str(sums[kind]) for kind in KINDS)
    print(f"| {len(files)} drawings | {totals} | {faults} faults | |")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
