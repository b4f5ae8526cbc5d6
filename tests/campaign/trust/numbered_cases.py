"""The frame of campaigns of numbered cases: one after another within a time, ends counted, faults kept."""

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

Case = Callable[[int, int], tuple[str, list[str]]]
"""Of seed and number: how the case ended, and what is wrong with it."""

LONGEST_PRINTED = 1500
"""Letters of a fault as it is printed; the record holds all."""


def arguments(doc: str, what: str, count: int, minutes: float) -> argparse.Namespace:
    """What is typed: how many cases, called `what`, of which seed, for how long at most, and where to."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(f"--{what}", type=int, default=count, dest="count")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=minutes)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    return parser.parse_args()


def run_cases(options: argparse.Namespace, name: str, what: str, case: Case) -> None:
    """Run the cases, write NAME-SEED.json, and end the process with 1 where anything is wrong."""
    ends, wrong, since = Counter[str](), [], time.monotonic()
    for number in range(options.count):
        ended, found = case(options.seed, number)
        ends[ended] += 1
        if found:
            wrong.append({"n": number, "ended": ended, "wrong": found})
            print(json.dumps(wrong[-1])[:LONGEST_PRINTED], flush=True)
        if time.monotonic() - since > 60 * options.minutes:
            break
    sums = {what: sum(ends.values()), "seed": options.seed, "ends": dict(ends), "wrong": len(wrong),
            "minutes": round((time.monotonic() - since) / 60, 1)}  # fmt: skip
    options.out.mkdir(parents=True, exist_ok=True)
    record = {"sums": sums, "wrong": wrong}
    (options.out / f"{name}-{options.seed}.json").write_text(json.dumps(record, indent=1) + "\n")
    print(json.dumps(sums))
    sys.exit(bool(wrong))
