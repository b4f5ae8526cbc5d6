"""What every command does alike, as typed: JSON records as documented, silence, steps, inches, watching files."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from elastica_cad.cli.commands import elastica
from elastica_cad.strip.measuring import ANGLES, LENGTHS
from tests.command_line import run

ROOT = Path(__file__).resolve().parents[3]
SHEET = ("--sheet", "birch-plywood-0.8")
BOW = "2 4\n0 0\n40 60\n90 60\n130 0\n"
TOLD = re.findall(
    r"^\| `elastica-(\w+)/\d` \| ([^|]+) \|", (ROOT / "docs" / "json.md").read_text(), re.MULTILINE
)
KEYS = {name: set(re.findall(r"`(\w+)`", keys)) for name, keys in TOLD}
TYPED = {
    "check": ("bow.txt",),
    "strip": ("bow.txt", *SHEET, "--max-width", "20", "-o", "out"),
    "model": ("arch.toml", "-o", "kit", "--no-step", "--no-pictures"),
    "bend": ("--straight", "100", *SHEET, "--max-width", "10", "--to", "70", "0", "-o", "out"),
    "reshape": ("bow.txt", "--top-right", "120", "80", "-o", "out"),
    "sections": ("bowl.obj", "--unit", "mm", "--radial", "2", "--sheet", "card-200gsm", "-o", "out"),
    "coupon": (*SHEET, "-o", "out"),
    "compare": ("made.json", "read.toml"),
    "batten": (*SHEET, "--length", "600", "--camber", "10", "--at", "42", "--stock", "20", "2", "-o", "out"),
    "bow": ("bow.txt", "--rod", "3:6", *SHEET, "--nearest", "-o", "out"),
    "pair": ("bow.txt", "flat.txt", "--sheet", "pom-2", "-o", "out"),
    "sheets": (),
    "new": ("lamp", "-o", "out"),
    "help": ("limits.ratio",),
}  # fmt: skip


def command(*words):
    return [sys.executable, "-m", "elastica_cad", *map(str, words)]


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "bow.txt").write_text(BOW)
    (tmp_path / "flat.txt").write_text(BOW.replace("60\n", "40\n"))
    measures = dict.fromkeys((*LENGTHS, *ANGLES), 90)
    chord = {
        "marks": [],
        "expected": measures,
        "uncertain": measures,
        "causes": {},
        "shape": [[0, 0], [90, 0]],
    }
    (tmp_path / "made.json").write_text(json.dumps({"measuring": chord}))
    (tmp_path / "read.toml").write_text("chord = 90.5")
    for kind in ("arch", "sections"):
        run("new", kind, "-q", cwd=tmp_path)
    return tmp_path


def test_every_command_is_documented_and_tried():
    commands = set(elastica.commands) - {"studio"}  # which serves its page
    assert commands | {"error"} == set(KEYS)
    assert commands == set(TYPED)


@pytest.mark.parametrize("name", TYPED)
def test_a_command_prints_one_record_with_the_documented_keys(folder, name):
    done = run(name, *TYPED[name], "--json", cwd=folder)
    record = json.loads(done.stdout)
    usual = {"schema", "notes", "files"}
    if name == "check":
        (record,) = record
        usual = {"schema"}
    read = {"read"} if name in ("check", "strip", "reshape", "pair", "bow") else set()
    assert set(record) == KEYS[name] | usual | read
    assert record["schema"] == f"elastica-{name}/1"
    written = record.get("files", [])
    assert all((folder / file).is_file() for file in written)
    assert bool(written) == (name not in ("check", "sheets", "help", "compare"))


@pytest.mark.campaign
def test_a_refusal_is_a_record_too(folder):
    done = run("strip", "bow.txt", "--sheet", "no such sheet", "--json", cwd=folder, code=2)
    record = json.loads(done.stdout)
    assert set(record) == KEYS["error"] | {"schema"}
    assert record["exit_code"] == done.exit_code == 2
    answer = record["error"]
    assert f"! Error     {answer['message']}" == done.stderr.strip()
    assert set(answer) == {"kind", "severity", "text", "values", "where", "changes", "message", "details"}


@pytest.mark.campaign
def test_quiet_says_nothing_and_verbose_every_step(folder):
    quiet = run("strip", "bow.txt", *SHEET, "--max-width", 20, "-q", "-o", "a", cwd=folder)
    assert (quiet.exit_code, quiet.stdout, quiet.stderr) == (0, "", "")
    assert (folder / "a" / "bow.dxf").exists()
    wordy = run("model", "arch.toml", "-o", "b", "--no-step", "--no-pictures", "-v", cwd=folder)
    assert re.search(r"^ +[0-9.]+ s  made strip ARCH$", wordy.stderr, re.MULTILINE)
    assert re.search(r"s  writing \S+ \(1 of \d+\)$", wordy.stderr, re.MULTILINE)


@pytest.mark.campaign
def test_a_width_meant_in_mm_is_reported_where_lengths_are_inches(folder):
    words = ("--units", "inch", "--max-width", "40", "-o", "out")
    made = run("strip", "arch.dxf", "--sheet", "card-200gsm", *words, cwd=folder)
    assert "1016 mm wide" in made.stderr
    assert "check its unit" in made.stderr


@pytest.mark.campaign
@pytest.mark.parametrize(
    "words",
    [
        ("--max-width", "1.5in"),
        ("--max-width", '1.5"'),
        ("--max-width", "3/2in"),
        ("--max-width", "1 1/2in"),
        ("--max-width", "1-1/2in"),
        ("--units", "inch", "--max-width", "1.5"),
        ("--units", "inch", "--max-width", "1 1/2"),
    ],
)
def test_lengths_may_be_inches(folder, words):
    text = run("strip", "bow.txt", *SHEET, *words, "-o", "out", "--json", cwd=folder).stdout
    (report,) = json.loads(text)["strips"]
    assert report["width"]["largest"] == pytest.approx(38.1)


@pytest.mark.campaign
def test_what_stays_in_mm_is_reported_where_lengths_are_inches(folder):
    """A slot meant 2 inches along, of 0.05 inch, came out at 2 mm and 0.05 mm wide without a word."""
    words = ("strip", "bow.txt", *SHEET, "--max-width", "1", "--units", "inch", "--json")
    slot = ("--set", "slots = [{ at = 60, width = 1.27 }]", "--natural-curvature", "0")
    answer = json.loads(run(*words, *slot, "-o", "a", cwd=folder).stdout)
    assert [text for text in answer["notes"] if "not in --units" in text] == [
        'Note: --set: lengths are in mm, as in design files, and not in --units; 5 inches are "5*inch"',
        "Note: --natural-curvature: the value is in 1/mm, not in --units; 1/inch is 0.03937",
    ]
    inches = ("--set", 'slots = [{ at = "60/25.4*inch", width = "0.05*inch" }]')
    run(*words, *inches, "-o", "b", cwd=folder)
    plain = run(*words[:4], "--max-width", "25.4", *slot[:2], "-o", "c", "--json", cwd=folder)
    assert not any("not in --units" in text for text in json.loads(plain.stdout)["notes"])
    cut = [(folder / name / "bow.svg").read_text().partition("</desc>")[2] for name in "bc"]
    assert cut[0] == cut[1]
    assert cut[0]


@pytest.mark.campaign
def test_lengths_without_sense_are_refused(folder):
    done = run("strip", "bow.txt", *SHEET, "--max-width", "3parsec", cwd=folder, code=2)
    assert (
        "'3parsec' is not a length: give a number of mm, or a length with its unit such as 1.5in"
        in done.stderr
    )


@pytest.mark.campaign
def test_hints_name_the_program_that_runs(folder):
    words = command("new", "lamp", "-o", "out")
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert f"Next        {sys.executable} -m elastica_cad model" in done.stdout


@pytest.mark.campaign
def test_a_shell_completes_commands_and_options(folder):
    request = {"_ELASTICA_COMPLETE": "bash_complete", "COMP_WORDS": "elastica re", "COMP_CWORD": "1"}
    done = subprocess.run(
        command(), cwd=folder, capture_output=True, text=True, check=False, env=os.environ | request
    )
    assert "plain,reshape" in done.stdout


def wait_for(found, process, seconds=60):
    """The first answer of `found` that is true."""
    end = time.monotonic() + seconds
    while not (answer := found()):
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < end, "nothing came"
        time.sleep(0.05)
    return answer


@pytest.mark.campaign
def test_watching_remakes_what_changes_and_survives_mistakes(folder):
    words = ("strip", "bow.txt", *SHEET, "--max-width", 20, "-o", "out", "--watch")
    file, log = folder / "out" / "bow.json", folder / "said.txt"

    def length():
        return json.loads(file.read_text())["length"]

    with log.open("w") as text:
        # a runner in the background would hand down a Ctrl-C that is ignored
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        process = subprocess.Popen(command(*words), cwd=folder, stdout=text, stderr=text)
        signal.signal(signal.SIGINT, before)
        try:
            wait_for(lambda: log.read_text().count("save to run again") == 1, process)
            first = length()
            (folder / "bow.txt").write_text("no curve")
            wait_for(lambda: log.read_text().count("save to run again") == 2, process)
            assert "! Error " in log.read_text()
            assert length() == first
            (folder / "new.txt").write_text(BOW.replace("130", "150"))
            (folder / "new.txt").replace(folder / "bow.txt")  # as careful editors save
            wait_for(lambda: log.read_text().count("save to run again") == 3, process)
            assert length() > first + 5
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=30) == 0
        finally:
            process.kill()
            process.wait()
    assert "stopped watching" in log.read_text()
    assert "Traceback" not in log.read_text()


@pytest.mark.campaign
def test_a_model_is_made_again_when_a_drawing_changes_that_it_names(folder):
    (folder / "one.toml").write_text(
        'schema = 1\nsheet = "birch-plywood-0.8"\nmax_width = 20\n[[strips]]\nlabel = "A"\ncurve = "bow.txt"\n'
    )
    log = folder / "said.txt"
    words = ("model", "one.toml", "-o", "kit", "--no-step", "--no-pictures", "--watch")
    with log.open("w") as text:
        process = subprocess.Popen(command(*words), cwd=folder, stdout=text, stderr=text)
        try:
            wait_for(lambda: "watching one.toml, bow.txt" in log.read_text(), process)
            (folder / "bow.txt").write_text(BOW.replace("130", "150"))
            wait_for(lambda: log.read_text().count("save to run again") == 2, process)
        finally:
            process.kill()
            process.wait()


@pytest.mark.campaign
def test_what_does_not_change_cannot_be_watched(folder):
    done = subprocess.run(
        command("check", "-", "--watch"), input=b"0 0\n", cwd=folder, capture_output=True, check=False
    )
    assert done.returncode == 2
    assert b"--watch needs a file; standard input cannot be watched" in done.stderr


@pytest.mark.parametrize("words", [("new", "arch"), ("studio", "arch.toml", "--no-browser")])
def test_a_command_that_reads_no_file_or_does_not_end_cannot_be_watched(words, tmp_path):
    text = run(*words, "--watch", cwd=tmp_path, code=2).output
    assert "--watch applies only to commands that read files and end" in text


LONG = "n" * 300


@pytest.mark.campaign
@pytest.mark.parametrize(
    "words",
    [
        *([name, *words[:-1], LONG] for name, words in TYPED.items() if words[-2:-1] == ("-o",)),
        ["model", "arch.toml", "-o", LONG, "--no-step", "--no-pictures"],
        ["check", f"{LONG}.svg"],
        ["model", f"{LONG}.toml"],
        ["sections", f"{LONG}.stl", "--radial", "2"],
        ["sheets", f"{LONG}.toml"],
        ["strip", "bow.txt", "--sheet", f"{LONG}.toml", "--max-width", "20"],
        ["strip", f"{LONG}/bow.txt", *SHEET, "--max-width", "20"],
    ],
    ids=lambda words: " ".join(words)[:20],
)
def test_names_that_no_disk_takes_are_reported(folder, words):
    """Looking whether such a file is there had ended in a traceback."""
    run = subprocess.run(command(*words), cwd=folder, capture_output=True, text=True, check=False)
    assert run.returncode == 2, run.stderr
    assert re.search(r"^! Error .*File name too long; (choose|name) ", run.stderr, re.MULTILINE)
    assert "Traceback" not in run.stderr
    assert not list(folder.glob("n*"))
