"""Runs that are killed, disks that are full, workers that are lost: nothing half written, others lose nothing.

python -m tests.campaign.trust.faults --kills 200 --full 20 --lost 20 --seed 1
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
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import elastica_cad as ec

BOW = "2 4\n0 0\n40 60\n90 60\n130 0\n"
STRIP = ("strip", "bow.txt", "--sheet", "birch-plywood-0.8", "--max-width", "20", "-o", "out", "--force")


def command(*words):
    return [sys.executable, "-m", "elastica_cad", *words]


def quietly(words, folder, **options):
    return subprocess.Popen(
        words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options
    )


STRANGERS = (
    ".elastica-notes/a.txt",
    "out/.elastica-1/a.txt",
    "out/.bow.dxf.00.part",
    "out/b.txt",
    "kit/.elastica-2/a.txt",
    ".elastica-0123456789abcdef/a.txt",
)
"""Files of others where runs write, some by names like those of temporary files."""


def put_strangers(folder):
    """The files of others, an hour old."""
    for name in STRANGERS:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(name)
        for one in (path, path.parent):
            os.utime(one, (time.time() - 3600,) * 2)


def lost_strangers(folder):
    """Those that are no longer as they were."""
    paths = {name: folder / name for name in STRANGERS}
    return [name for name, path in paths.items() if not path.is_file() or path.read_text() != name]


def contents(folder):
    files = (folder / "out").iterdir() if (folder / "out").is_dir() else ()
    names = {name.rpartition("/")[2] for name in STRANGERS}
    return {path.name: _parts(path) for path in files if path.is_file() and path.name not in names}


def _parts(path):
    """The bytes of a file; of STEP the lines in order without their numbers, as colours come in any order."""
    data = path.read_bytes()
    return sorted(re.sub(rb"#\d+", b"#", data).splitlines()) if path.suffix == ".step" else data


def left(folder):
    return [path.name for path in folder.rglob(".*")]


def kills(count, rng, folder):
    """Kill `elastica strip` at random moments: each file is the old or the new one, and those of others stay."""
    wrong, between = [], 0
    put_strangers(folder)
    (folder / "bow.txt").write_text(BOW)
    took = []
    for _ in range(2):
        since = time.monotonic()
        quietly(command(*STRIP), folder).communicate()
        took.append(time.monotonic() - since)
    old = contents(folder)
    (folder / "bow.txt").write_text(BOW.replace("130", "150"))
    quietly(command(*STRIP), folder).communicate()
    new = contents(folder)
    for number in range(count):
        (folder / "bow.txt").write_text(BOW if number % 2 else BOW.replace("130", "150"))
        process = quietly(command(*STRIP), folder)
        time.sleep(rng.uniform(0.2, 1.1) * min(took))
        process.kill()
        process.communicate()
        found = contents(folder)
        broken = [name for name, data in found.items() if data not in (old.get(name), new.get(name))]
        mixed = {found == old, found == new} == {False}
        between += mixed
        lost = lost_strangers(folder)
        if broken or lost or set(found) != set(old):
            wrong.append({"kill": number, "half": broken, "files": sorted(found), "lost": lost})
    quietly(command(*STRIP), folder).communicate()
    wrong += [{"lost": lost} for lost in lost_strangers(folder)]
    return {"kills": count, "mixed sets": between, "left behind": len(left(folder)), "wrong": wrong}


def kills_and_a_day(count, folder):
    """Kill runs at moments spread over their writing; a day later, the next run removes what they left."""
    put_strangers(folder)
    (folder / "bow.txt").write_text(BOW)
    words = command(*STRIP, "--no-step", "--no-pictures")
    strangers = {name.split("/")[-2] for name in STRANGERS if "/" in name}

    def homes():
        return [one for one in folder.rglob(".elastica-*") if one.is_dir() and one.name not in strangers]

    def writing():
        """Start a run and return it when it has made its folder, or has ended."""
        before, process = len(homes()), quietly(words, folder)
        while len(homes()) == before and process.poll() is None:
            time.sleep(0.001)
        return process

    quietly(words, folder).communicate()
    process, since = writing(), time.monotonic()
    process.communicate()
    took, killed = time.monotonic() - since, 0
    for number in range(count):
        process = writing()
        time.sleep(took * number / count)
        process.kill()
        process.communicate()
        killed += process.returncode == -signal.SIGKILL
    quietly(words, folder).communicate()
    kept = len(homes())
    for one in homes():
        os.utime(one, (time.time() - 25 * 3600,) * 2)
    quietly(words, folder).communicate()
    after, lost = homes(), lost_strangers(folder)
    # a run killed before it locked its folder leaves an empty one, which nothing may remove
    locked = [one.name for one in after if any(path.is_dir() for path in one.iterdir())]
    wrong = [{"left": locked, "lost": lost}] if locked or lost else []
    return {"killed before a day": killed, "left": kept, "a day later": len(after), "wrong": wrong}


def kills_of_new_kits(count, rng, folder):
    """Kill `elastica model` as it writes to a folder that is not there: the whole kit, or none of it."""
    wrong, whole = [], 0
    put_strangers(folder)
    quietly(command("new", "arch"), folder).communicate()
    words = ("model", "arch.toml", "--no-step", "--no-pictures", "-o")
    took = []
    for number in range(2):
        since = time.monotonic()
        quietly(command(*words, f"sound{number}"), folder).communicate()
        took.append(time.monotonic() - since)
    sound = {path.name for path in (folder / "sound0").rglob("*")}
    for number in range(count):
        process = quietly(command(*words, f"kit{number}"), folder)
        time.sleep(rng.uniform(0.2, 1.1) * min(took))
        process.kill()
        process.communicate()
        found = {path.name for path in (folder / f"kit{number}").rglob("*")}
        whole += bool(found)
        lost = lost_strangers(folder)
        if found not in (set(), sound) or lost:
            wrong.append({"kill": number, "files": sorted(found), "lost": lost})
    return {"kills of kits": count, "whole": whole, "wrong": wrong}


def full_disks(count, rng, folder):
    """Files may not grow beyond a random size: one sentence, the old files stay, nothing is left."""
    wrong = []
    (folder / "bow.txt").write_text(BOW)
    quietly(command(*STRIP), folder).communicate()
    old = contents(folder)
    largest = max(map(len, old.values()))
    (folder / "bow.txt").write_text(BOW.replace("130", "150"))
    for number in range(count):
        size = rng.randrange(100, largest // 2)

        def shrink(size=size):
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        process = quietly(
            command(*STRIP), folder, preexec_fn=shrink, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
        )
        text, _ = process.communicate()
        if process.returncode != 2 or "Traceback" in text or contents(folder) != old or left(folder):
            wrong.append(
                {
                    "full": number,
                    "size": size,
                    "code": process.returncode,
                    "said": text[-600:],
                    "left": left(folder),
                }
            )
    return {"full disks": count, "wrong": wrong}


def two_writers(count, folder):
    """Two runs write to one folder at the same time: each file is there, and whole."""
    wrong = []
    for number in range(count):
        base = folder / str(number)
        (base / "b").mkdir(parents=True)
        (base / "bow.txt").write_text(BOW)
        (base / "b" / "bow.txt").write_text(BOW.replace("130", "150"))
        other = [*STRIP]
        other[1] = "b/bow.txt"
        runs = [quietly(command(*words), base) for words in (STRIP, other)]
        text = [run.communicate()[0] for run in runs]
        lengths = {
            json.loads(data)["length"] for name, data in contents(base).items() if name.endswith(".json")
        }
        if any(run.returncode for run in runs) or len(lengths) != 1 or left(base):
            wrong.append({"pair": number, "said": [one[-300:] for one in text], "left": left(base)})
    return {"two writers": count, "wrong": wrong}


def die_or_pass(number):
    """In a worker: end it the hard way where asked."""
    if number < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def lost_workers(count, rng):
    """A worker of a pool dies while many rods are searched: an answer for each, or one sentence."""
    wrong = []
    curves = [
        ec.PlaneCurve.spline([(0, 0), (40, 60 + 5 * i), (90, 60), (130, 0)], degree=3) for i in range(4)
    ]
    for number in range(count):
        with ProcessPoolExecutor(2) as pool:
            list(pool.map(die_or_pass, range(2)))
            victim = rng.choice(list(pool._processes))
            try:
                os.kill(victim, signal.SIGKILL) if number % 2 else pool.submit(die_or_pass, -1)
                found = ec.nearest_rods(curves, ec.Limits(ratio=1.5), executor=pool)
                if len(list(found)) != len(curves):
                    wrong.append({"lost": number, "found": len(list(found))})
            except ec.ElasticaError as problem:
                if "\n" in str(problem):
                    wrong.append({"lost": number, "said": str(problem)})
            except Exception as problem:
                wrong.append({"lost": number, "fault": f"{type(problem).__name__}: {problem}"})
    return {"lost workers": count, "wrong": wrong}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    for name, usual in (("kills", 200), ("days", 40), ("full", 20), ("pairs", 20), ("lost", 20), ("seed", 1)):
        parser.add_argument(f"--{name}", type=int, default=usual)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    arguments = parser.parse_args()
    rng, found = random.Random(arguments.seed), []
    for part in (
        lambda folder: lost_workers(arguments.lost, rng),
        lambda folder: full_disks(arguments.full, rng, folder),
        lambda folder: two_writers(arguments.pairs, folder),
        lambda folder: kills(arguments.kills, rng, folder),
        lambda folder: kills_of_new_kits(arguments.kills, rng, folder),
        lambda folder: kills_and_a_day(arguments.days, folder),
    ):
        with TemporaryDirectory() as folder:
            found.append(part(Path(folder)))
        print(json.dumps(found[-1])[:3000], flush=True)
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "faults.json").write_text(json.dumps(found, indent=1) + "\n")
    sys.exit(any(one["wrong"] for one in found))


if __name__ == "__main__":
    main()
