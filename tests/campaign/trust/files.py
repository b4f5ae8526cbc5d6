"""Mutated files of every format through the readers: curves, or one sentence, within limits of time and memory.

python -m tests.campaign.trust.files --cases 100000 --seed 1

One process reads them all; another watches it, notes what ends it or takes too long, and goes on behind that case.
"""

import argparse
import json
import os
import random
import re
import resource
import signal
import subprocess
import sys
import time
import traceback
import warnings
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.campaign.trust.corpus import SHARES, originals
from tests.campaign.trust.mutations import mutated

LONGEST_S = 10.0
"""Processor seconds of one case, beyond which it counts as a hang."""

MOST_MEMORY = 4 * 2**30
"""Address space of the reading process, bytes: what a bomb would pass."""

PYTHON = re.compile(
    r"<class|object at 0x|argument must be|invalid literal|could not convert|NoneType|datetime\.|dtype|ndarray"
)
"""What no sentence about a file holds."""

LONGEST_SENTENCE = 1500
LOOKED_AT = 20  # curves of one file


class Hang(BaseException):
    """A case took too long; nothing catches it on the way."""


def case(seed: int, number: int) -> tuple[str, bytes]:
    """Format and content of a case."""
    rng = random.Random(f"{seed} {number}")
    kind = rng.choices(list(SHARES), list(SHARES.values()))[0]
    sound = originals(kind)
    return kind, mutated(rng, kind, rng.choice(sound), rng.choice(sound))


def read(path: Path) -> str:
    """What a file gives: "curves", or the sentence that refuses it."""
    from elastica_cad import ElasticaError, check_equilibrium, read_curves
    from elastica_cad.design import read_design
    from elastica_cad.files import read_drawing, read_surface

    try:
        if path.suffix == ".toml":
            read_design(path, read_curves, read_surface)
        elif path.suffix in (".obj", ".stl", ".ply"):
            read_surface(path, unit="mm")
        else:
            for one in read_drawing(path).curves[:LOOKED_AT]:
                if not one.problem:
                    str(check_equilibrium(one.curve))
    except ElasticaError as problem:
        return str(problem)
    return "curves"


def verdict(path: Path) -> tuple[str, str]:
    """How a case ended ("curves", "sentence", or a fault), and what to know about it."""
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            text = read(path)
        except Hang:
            return "hang", "".join(traceback.format_exc().splitlines(keepends=True)[-8:])
        except MemoryError:
            return "memory", traceback.format_exc(limit=-3)
        except Exception:
            return "traceback", traceback.format_exc(limit=-6)
    if warned:
        return "warning", f"{warned[0].filename}:{warned[0].lineno}: {warned[0].message}"
    if PYTHON.search(text):
        return "speaks Python", text
    if "\n" in text or len(text) > LONGEST_SENTENCE:
        return "sentence too long", text[:2000]
    return ("curves", "") if text == "curves" else ("sentence", text)


def work(seed: int, first: int, cases: int, folder: Path) -> None:
    """Read cases and print a line of JSON for each."""

    for kind in SHARES:
        originals(kind)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    records = os.fdopen(os.dup(1), "w")  # what libraries print themselves goes to a file, and is a fault
    chatter = (folder / "chatter").open("w+b")
    for stream in (1, 2):
        os.dup2(chatter.fileno(), stream)

    def stop(*_: object) -> None:
        raise Hang

    signal.signal(signal.SIGPROF, stop)
    for number in range(first, cases):
        kind, data = case(seed, number)
        path = folder / f"case.{kind}"
        path.write_bytes(data)
        since = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, LONGEST_S)
        try:
            ended, text = verdict(path)
        except Hang:
            ended, text = "hang", ""
        signal.setitimer(signal.ITIMER_PROF, 0)
        if (size := os.fstat(1).st_size) and ended in ("curves", "sentence"):
            os.lseek(1, 0, os.SEEK_SET)
            ended, text = "chatter", os.read(1, 300).decode(errors="replace")
        if size:
            os.ftruncate(1, 0)
            os.lseek(1, 0, os.SEEK_SET)
        record = {"n": number, "kind": kind, "ended": ended, "s": round(time.process_time() - since, 3)}
        if ended not in ("curves", "sentence"):
            record["said"] = text
        record["mib"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
        records.write(json.dumps(record) + "\n")
        records.flush()


def watched(
    seed: int, cases: int, folder: Path, minutes: float
) -> tuple[list[dict[str, object]], dict[str, object]]:
    """All faults, and sums, of so many cases; the reading process is started anew where a case ends it."""
    first, faults, ends, kinds = 0, [], Counter[str](), Counter[str]()
    longest, most, since, starts = 0.0, 0, time.monotonic(), 0
    options = ["--seed", str(seed), "--cases", str(cases), "--folder", str(folder)]
    while first < cases and time.monotonic() - since < 60 * minutes:
        words = [sys.executable, "-m", __spec__.name, "--work", *options, "--first", str(first)]
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as worker:
            starts += 1
            assert worker.stdout is not None
            for line in worker.stdout:
                record = json.loads(line)
                first = record["n"] + 1
                ends[record["ended"]] += 1
                kinds[record["kind"]] += 1
                longest, most = max(longest, record["s"]), max(most, record["mib"])
                if "said" in record:
                    faults.append(record)
                if time.monotonic() - since > 60 * minutes:
                    worker.terminate()
                    break
            else:
                if first < cases:  # the process itself ended: the kernel of STEP files, or no memory
                    text = (folder / "chatter").read_bytes()[-400:].decode(errors="replace")
                    kind, _ = case(seed, first)
                    faults.append({"n": first, "kind": kind, "ended": "process ended", "said": text})
                    ends["process ended"] += 1
                    first += 1
    took = round((time.monotonic() - since) / 60, 1)
    sums = {
        "cases": sum(ends.values()), "seed": seed, "ends": dict(ends), "kinds": dict(kinds), "faults": len(faults),
        "longest_s": longest, "most_mib": most, "starts": starts, "minutes": took,
    }  # fmt: skip
    return faults, sums


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=240.0, help="where it ends at the latest")
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    parser.add_argument("--first", type=int, default=0, help=argparse.SUPPRESS)
    parser.add_argument("--work", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.work:
        work(arguments.seed, arguments.first, arguments.cases, arguments.folder)
        return
    arguments.out.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as folder:
        faults, sums = watched(arguments.seed, arguments.cases, Path(folder), arguments.minutes)
    for fault in faults:
        kind, data = case(arguments.seed, int(str(fault["n"])))
        (arguments.out / f"fault-{arguments.seed}-{fault['n']}.{kind}").write_bytes(data)
    (arguments.out / f"files-{arguments.seed}.json").write_text(
        json.dumps({"sums": sums, "faults": faults}, indent=1) + "\n"
    )
    for fault in faults[:50]:
        print(json.dumps(fault))
    print(json.dumps(sums))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
