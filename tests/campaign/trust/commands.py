"""Every flag of every command with sound, odd and hostile values: an answer or one sentence, within limits.

python -m tests.campaign.trust.commands --runs 3000 --seed 1 --minutes 60

Each run is a process of its own, a copy of one that has loaded the command line; every tenth is typed in full. What
counts as a fault: a traceback, a warning of Python's, an exit code other than 0, 1 and 2, more than 10 s of the
processor for a refusal or 60 s for an answer, 10 s in which nothing is printed, more than 1.5 GB, files left after
a refusal, JSON that is none.
"""

import argparse
import json
import os
import random
import re
import resource
import signal
import sys
import time
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

import click

from tests.campaign.trust.corpus import originals
from tests.campaign.trust.mutations import mutated

LONGEST_REFUSAL_S, LONGEST_S, LONGEST_SILENCE_S = 10.0, 60.0, 10.0
MOST_MIB = 1500
MOST_MEMORY = 4 * 2**30
ODD = "0 -1 0.5 1 3 12 20 40 200 1e9 1e200 -1e308 nan inf 1e-9 x 1.5in 3parsec 1,5 -- 0x10 1000000"
NUMBERS = (*ODD.split(), "", "9" * 400)
NAMES = "A1 =1+1 <b> ../x CON birch-plywood-0.8 card-200gsm - %s 日本"
TEXTS = (*NAMES.split(), "", "a\nb", "\u202e", "A" * 3000)
KEYS = (
    "at = 40, width = 1.2", "length = 12, holes = [{at = 6, diameter = 3}]", "a = [", "width = -1", "x = {y = {}}",
    "point = [0, 0], normal = [0, 1]", "at = 1e200, width = nan", "lower = [0, 0], upper = [9, 9]",
)  # fmt: skip
SOUND = {
    "check": ["bow.txt"], "strip": ["bow.txt", "--sheet", "birch-plywood-0.8", "--max-width", "20", "-o", "out"],
    "model": ["arch.toml", "-o", "out", "--no-step", "--no-pictures"],
    "coupon": ["--sheet", "birch-plywood-0.8", "-o", "out"],
    "bend": ["bow.txt", "--to", "120", "0", "-o", "out"],
    "reshape": ["bow.txt", "--top-right", "120", "80", "-o", "out"],
    "sections": ["bowl.obj", "--unit", "mm", "--radial", "2", "--sheet", "card-200gsm", "-o", "out"],
    "sheets": [], "new": ["lamp", "-o", "out"],
}  # fmt: skip


def value(rng, kind, sound):
    """A word for an option of a type."""
    if isinstance(kind, click.Choice) and rng.random() < 0.85:
        return rng.choice(list(kind.choices))
    if isinstance(kind, click.Path):
        return rng.choice(("out", "bow.txt", "nowhere/x", "/dev/null", "..", "arch.toml"))
    if kind.name in ("text",):
        return rng.choice(TEXTS + KEYS)
    return rng.choice(("1", "5", "12", "20")) if sound else rng.choice(NUMBERS)


def words(rng, commands):
    """The words of one run."""
    name = rng.choice(list(SOUND))
    command, text = commands[name], list(SOUND[name])
    options = [
        one
        for one in command.params
        if isinstance(one, click.Option) and one.name not in ("watch", "version", "help")
    ]
    sound = rng.random() < 0.5
    for option in rng.sample(options, min(len(options), rng.choice((1, 1, 2, 3, 5)))):
        text.append(rng.choice((*option.opts, *option.secondary_opts)))
        if not option.is_flag:
            kinds = (
                option.type.types if isinstance(option.type, click.Tuple) else [option.type] * option.nargs
            )
            text += [value(rng, kind, sound) for kind in kinds]
    if rng.random() < 0.1 and text:
        text.pop(rng.randrange(len(text)))
    return [name, *text]


def prepared(folder, rng):
    """Files that commands read, now and then a broken one."""
    (folder / "bow.txt").write_text("2 4\n0 0\n40 60\n90 60\n130 0\n")
    begin(folder, "arch", "sections")
    if rng.random() < 0.2:
        name, kind = rng.choice((("bow.txt", "txt"), ("arch.toml", "toml"), ("bowl.obj", "obj")))
        sound = originals(kind)
        (folder / name).write_bytes(mutated(rng, kind, rng.choice(sound), rng.choice(sound)))


def begin(folder, *kinds):
    """Designs as `elastica new` writes them."""
    from elastica_cad.cli.commands import elastica

    here = os.getcwd()
    os.chdir(folder)
    try:
        for kind in kinds:
            elastica.main(["new", kind, "-q", "--force"], standalone_mode=False)
    finally:
        os.chdir(here)


def run(text, folder, typed):
    """Exit code, standard output, standard error, processor seconds, MiB, longest silence in seconds."""
    streams = [(folder / name).open("w+b") for name in (".out", ".err")]
    copy = os.fork()
    if not copy:
        os.chdir(folder)
        os.environ["ELASTICA_SHEETS"] = str(folder / "library")  # not the one of whoever runs the campaign
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        for number, stream in enumerate(streams, start=1):
            os.dup2(stream.fileno(), number)
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
        if typed:
            os.execv(sys.executable, [sys.executable, "-m", "elastica_cad", *text])
        _as_typed(text)
    end, silence, printed, size = time.monotonic() + 6 * LONGEST_S, 0.0, time.monotonic(), 0
    while not (done := os.wait4(copy, os.WNOHANG))[0]:
        if time.monotonic() > end:
            os.kill(copy, signal.SIGKILL)
            done = os.wait4(copy, 0)
            break
        before, size = size, sum(os.fstat(stream.fileno()).st_size for stream in streams)
        printed = printed if size == before else time.monotonic()
        silence = max(silence, time.monotonic() - printed)
        time.sleep(0.01)
    texts = []
    for stream in streams:
        stream.seek(0)
        texts.append(stream.read().decode(errors="replace"))
        stream.close()
    used = done[2]
    seconds, mib = used.ru_utime + used.ru_stime, used.ru_maxrss // 1024
    return os.waitstatus_to_exitcode(done[1]), *texts, seconds, mib, silence


def _as_typed(text):
    """The command in this copy, which ends with it."""
    import traceback
    import warnings

    from elastica_cad.cli.commands import elastica

    warnings.simplefilter("ignore")  # as the program does where it is typed
    code = 0
    try:
        elastica.main(args=text, prog_name="elastica")
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else 1
    except BaseException:
        traceback.print_exc()
        code = 99
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def judged(text, folder, ended):
    """What is wrong with a run."""
    code, out, err, seconds, mib, silence = ended
    found = []
    if code not in (0, 1, 2):
        found.append(f"exit code {code}")
    if "Traceback (most recent call last)" in err + out:
        found.append(err[-1200:])
    if re.search(r"\.py:\d+: \w*Warning", err):
        found.append("Python's warning: " + err[-300:])
    if seconds > (LONGEST_REFUSAL_S if code == 2 else LONGEST_S):
        found.append(f"{seconds:.0f} s of the processor")
    if silence > LONGEST_SILENCE_S and not {"--json", "-q", "--quiet"} & set(text):
        found.append(f"nothing printed for {silence:.0f} s")
    if mib > MOST_MIB:
        found.append(f"{mib} MiB")
    left = [path.name for path in (folder / "out").rglob("*")] if (folder / "out").is_dir() else []
    others_made = re.search(r"of \d+ curves cannot be made|of \d+ is left out", out + err)
    if code == 2 and left and not others_made:
        found.append(f"left behind: {left[:5]}")
    hidden = [path.name for path in folder.rglob(".*") if path.name not in (".out", ".err")]
    if hidden:
        found.append(f"left behind: {hidden}")
    if "--json" in text and out.strip():
        try:
            json.loads(out)
        except ValueError:
            found.append("no JSON: " + out[:300])
    return found


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=120.0)
    parser.add_argument("--only", type=int, help="one run, by its number")
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    arguments = parser.parse_args()
    from elastica_cad.cli.commands import elastica

    codes, faults, since, longest, most = Counter(), [], time.monotonic(), 0.0, 0
    for number in range(arguments.runs) if arguments.only is None else [arguments.only]:
        rng = random.Random(f"{arguments.seed} {number}")
        with TemporaryDirectory() as base:
            folder = Path(base)
            prepared(folder, rng)
            text = words(rng, elastica.commands)
            if any("\x00" in word for word in text):
                continue
            ended = run(text, folder, typed=number % 10 == 0)
            wrong = judged(text, folder, ended)
        codes[ended[0]] += 1
        longest, most = max(longest, ended[3]), max(most, ended[4])
        if wrong:
            faults.append({"n": number, "words": text, "wrong": wrong})
            print(json.dumps(faults[-1])[:2500], flush=True)
        if time.monotonic() - since > 60 * arguments.minutes:
            break
    sums = {
        "runs": sum(codes.values()), "seed": arguments.seed, "codes": dict(codes), "faults": len(faults),
        "longest_s": round(longest, 1), "most_mib": most, "minutes": round((time.monotonic() - since) / 60, 1),
    }  # fmt: skip
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / f"commands-{arguments.seed}.json").write_text(
        json.dumps({"sums": sums, "faults": faults}, indent=1) + "\n"
    )
    print(json.dumps(sums))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
