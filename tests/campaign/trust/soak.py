"""Many strips, files and examples in one process: memory, threads and open files stay where they are.

python -m tests.campaign.trust.soak --solves 10000 --minutes 60
"""

import argparse
import gc
import json
import os
import random
import runpy
import sys
import threading
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import elastica_cad as ec

ROOT = Path(__file__).resolve().parents[3]
EXAMPLES = ("vase", "lantern", "shell", "revolution", "carpet", "projective", "spiral")
EVERY = 30
"""Rounds after which one of the examples is built whole and drawn."""

WARM = EVERY * len(EXAMPLES)  # rounds after which caches are full: every example was built once
MOST_GROWTH_MIB = 60.0


def held():
    """MiB in use, threads, open files."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    mib = pages * os.sysconf("SC_PAGE_SIZE") / 2**20
    return {
        "mib": round(mib, 1),
        "threads": threading.active_count(),
        "files": len(os.listdir("/proc/self/fd")),
    }


def round_of(rng, folder):
    """A curve from a file, its strip, its nearest rod now and then, written and read again."""
    curve = ec.PlaneCurve.spline(
        [(0, 0), (40, rng.uniform(20, 80)), (90, rng.uniform(20, 80)), (130, 0)], degree=3
    )
    ec.write_curves([curve], folder / "a.svg", force=True)
    (read,) = ec.read_curves(folder / "a.svg")
    strip = ec.make_strip(read, "birch-plywood-0.8", max_width=30, label="A", ignore_limits=True)
    ec.save(strip.drawing(), folder / "a.dxf", force=True)
    ec.read_curves(folder / "a.dxf")
    if rng.random() < 0.1:
        ec.nearest_rod(curve, ec.Limits(ratio=1.3))


def built(name, folder):
    """An example as its script builds it, every part drawn."""
    built = runpy.run_path(str(ROOT / "examples" / name / f"{name}.py"))["build"]()
    models = built if isinstance(built, list | tuple | dict) else [built]
    for model in models.values() if isinstance(models, dict) else models:
        for part in getattr(model, "parts", ()):
            for number, drawing in enumerate(part.strip.drawings()):
                ec.save(drawing, folder / f"{number}.dxf", force=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--solves", type=int, default=10_000)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    arguments = parser.parse_args()
    rng, since, first, done = random.Random(1), time.monotonic(), {}, 0
    with TemporaryDirectory() as folder:
        for done in range(1, arguments.solves + 1):
            round_of(rng, Path(folder))
            if done % EVERY == EVERY - 1:
                built(EXAMPLES[done // EVERY % len(EXAMPLES)], Path(folder))
            if done == WARM:
                first = held()
            if time.monotonic() - since > 60 * arguments.minutes:
                break
        last = held()
    if not first:
        sys.exit(
            f"Ended after {done} of the first {WARM} rounds, which fill the caches. Set --minutes higher."
        )
    grown = {key: round(last[key] - first[key], 1) for key in last}
    leaks = grown["mib"] > MOST_GROWTH_MIB or grown["threads"] > 0 or grown["files"] > 2
    record = {"solves": done, "first": first, "last": last, "grown": grown, "leaks": bool(leaks)}
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "soak.json").write_text(json.dumps(record, indent=1) + "\n")
    print(json.dumps(record))
    sys.exit(bool(leaks))


if __name__ == "__main__":
    main()
