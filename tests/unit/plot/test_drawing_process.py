"""The process that draws pictures: the same bytes as without it, also if it ends early."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from elastica_cad import InputError, PlaneCurve, StripSpec
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.kit.strip_kit import StripFiles, StripResult
from elastica_cad.plot import canvas
from elastica_cad.plot.drawing_process import DrawingProcess, drawing_process

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals")


@pytest.fixture(scope="module")
def kit():
    curve = PlaneCurve.spline([(0, 0), (40, 60), (90, 60), (130, 0)], degree=3)
    spec = StripSpec(curve, "card-200gsm", max_width=20)
    rod = solve_rod(spec.rod_spec)
    return StripResult(spec, rod, spec.make(rod), "bow").kit(StripFiles(paper="A4", step=False))


@pytest.fixture
def process():
    process = DrawingProcess()
    yield process
    process.end()


def contents(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def fail(*_, **__):
    raise RuntimeError("torn")


@pytest.mark.campaign
def test_the_process_draws_kit_after_kit_as_this_process_does(process, kit, tmp_path, monkeypatch):
    kit.write(tmp_path / "here")
    monkeypatch.setattr(canvas, "write_atomically", fail)
    for folder in (tmp_path / "first", tmp_path / "second"):
        written = kit.write(folder, process=process)
        assert [file.name for file in written] == [file.name for file in kit.files]
        assert contents(folder) == contents(tmp_path / "here")
    assert {"bow.png", "bow.pdf", "bow-holding.pdf"} <= {*contents(tmp_path / "here")}
    with pytest.raises(InputError, match="exists"):
        kit.write(tmp_path / "here", process=process)
    assert not is_running(process.pid)


@pytest.mark.parametrize("noticed", [False, True])
def test_if_the_process_is_killed_the_pictures_are_drawn_here(noticed, process, kit, tmp_path):
    os.kill(process.pid, signal.SIGKILL)
    if noticed:
        process.end()
    kit.write(tmp_path / "out", process=process)
    assert {*contents(tmp_path / "out")} == {file.name for file in kit.files}
    assert contents(tmp_path / "out")["bow.png"].endswith(b"IEND\xaeB`\x82")


def test_a_picture_that_cannot_be_drawn_leaves_no_files(process, kit, tmp_path, monkeypatch):
    process.end()
    monkeypatch.setattr(canvas, "write_atomically", fail)
    with pytest.raises(RuntimeError, match="torn"):
        kit.write(tmp_path / "out", process=process)
    assert not list(tmp_path.rglob("*.*"))


@pytest.mark.parametrize(
    "command", ["check bow.txt", "strip bow.txt --no-pictures", "strip --help", "strip bow.txt", "sheets"]
)
def test_the_process_is_started_for_pictures_only(command, monkeypatch):
    monkeypatch.setattr(os, "cpu_count", lambda: 2)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0, 1}, raising=False)
    with drawing_process(command.split()) as process:
        assert (process is not None) == (command == "strip bow.txt")
    assert process is None or not is_running(process.pid)


@pytest.mark.parametrize("reason", ["one processor", "no matplotlib", "no processes"])
def test_no_process_is_started_if_it_would_not_help_or_cannot_start(reason, monkeypatch):
    processors = {0} if reason == "one processor" else {0, 1}
    monkeypatch.setattr(os, "cpu_count", lambda: len(processors))
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: processors, raising=False)
    if reason == "no matplotlib":
        monkeypatch.setattr("elastica_cad.plot.drawing_process.find_spec", lambda _: None)
    if reason == "no processes":
        monkeypatch.setattr(sys, "executable", "/no/such/python")
    with drawing_process(["strip", "bow.txt"]) as process:
        assert process is None


COMMAND = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
os.sched_getaffinity = lambda _: {0, 1}
import elastica_cad.plot.drawing_process as drawing
start = drawing.DrawingProcess.__init__

def reporting(self):
    start(self)
    print(self.pid, flush=True)

drawing.DrawingProcess.__init__ = reporting
from elastica_cad.cli import main
main()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="looks at processes")
def test_ctrl_c_ends_both_processes_and_neither_imports_from_the_working_folder(tmp_path):
    (tmp_path / "bow.txt").write_text("2 4\n0 0\n40 60\n90 60\n130 0\n")
    for name in ("pickle", "matplotlib", "signal"):
        (tmp_path / f"{name}.py").write_text("open('imported', 'w')")
    before = {*tmp_path.iterdir()}
    command = [sys.executable, "-P", "-c", COMMAND, "strip", "bow.txt", "--sheet", "card-200gsm", "-o", "out"]
    with subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, process_group=0
    ) as process:
        pid = int(process.stdout.readline())
        time.sleep(0.2)
        assert is_running(pid)
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        _, errors = process.communicate()
    assert (process.returncode, errors.strip()) == (130, "")  # click ends the line of ^C
    assert not is_running(pid)
    assert {*tmp_path.iterdir()} == before
