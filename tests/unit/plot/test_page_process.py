"""The process that paints beside a command: the same bytes, and nobody notices where it dies."""

import os
import resource
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import pytest

from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.kit.strip_kit import StripKit, write_strip
from elastica_cad.plot import page_process as beside

BOW = "2 4\n0 0\n40 60\n90 60\n130 0\n"
STRIP = ("strip", "bow.txt", "--sheet", "birch-plywood-0.8", "--max-width", "20", "-o", "out")
ONE_CORE = sys.platform == "linux" and len(os.sched_getaffinity(0)) < 2

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals")


@dataclass(frozen=True)
class Broken:
    """A page that nobody can paint."""

    def figure(self):
        raise RuntimeError("torn")


@pytest.fixture(scope="module")
def kit():
    curve = PlaneCurve.spline([(0, 0), (40, 60), (90, 60), (130, 0)], degree=3)
    spec = StripSpec(curve, "card-200gsm", max_width=20)
    found = spec.rod_spec.solve()
    return StripKit(spec, found, spec.make(found), "bow")


@pytest.fixture
def painter(monkeypatch):
    monkeypatch.setattr(beside, "usable_processors", lambda: 2)
    with beside.page_process() as begun:
        yield begun


def is_there(pid):
    """Does a process run?"""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def children(pid):
    """The processes that one began."""
    try:
        return Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return []


def wait_until(true, seconds=30):
    end = time.monotonic() + seconds
    while not true() and time.monotonic() < end:
        time.sleep(0.01)
    assert true()


@pytest.mark.campaign
def test_a_page_painted_beside_is_the_page_painted_here(painter, kit, tmp_path):
    write_strip(kit, tmp_path / "here")
    write_strip(kit, tmp_path / "beside", painter=painter)
    assert painter.pid is None  # it has done its page
    write_strip(kit, tmp_path / "after", painter=painter)
    here = {file.name: file.read_bytes() for file in (tmp_path / "here").iterdir()}
    assert "bow.png" in here
    for folder in ("beside", "after"):
        assert {file.name: file.read_bytes() for file in (tmp_path / folder).iterdir()} == here


def test_it_paints_one_page(painter, kit):
    assert painter.begin(kit.page)()
    assert painter.begin(kit.page) is None


@pytest.mark.parametrize("handed", [False, True])
def test_where_it_is_killed_one_paints_for_oneself(handed, painter, kit, tmp_path, monkeypatch):
    """Before it has its page, and while it paints."""
    begin = painter.begin

    def begin_and_kill(page):
        painted = begin(page) if handed else None
        os.kill(painter.pid, signal.SIGKILL)
        return painted if handed else begin(page)

    if not handed:
        os.kill(painter.pid, signal.SIGSTOP)  # it cannot have read anything
    monkeypatch.setattr(painter, "begin", begin_and_kill)
    write_strip(kit, tmp_path / "out", painter=painter)
    assert (tmp_path / "out" / "bow.png").read_bytes().endswith(b"IEND\xaeB`\x82")
    assert len(list((tmp_path / "out").iterdir())) == len(kit.files)


@pytest.mark.campaign
def test_a_page_that_cannot_be_painted_leaves_no_file(painter, kit, tmp_path, monkeypatch):
    """What is wrong with it is told here, as where nobody paints beside."""
    monkeypatch.setitem(kit.__dict__, "page", Broken())
    with pytest.raises(RuntimeError, match="torn"):
        write_strip(kit, tmp_path / "out", painter=painter)
    assert list(tmp_path.rglob("*")) in ([], [tmp_path / "out"])


def test_half_a_picture_is_none(painter, kit, monkeypatch):
    painted = painter.begin(kit.page)
    communicate = painter._process.communicate
    monkeypatch.setattr(painter._process, "communicate", lambda timeout: (communicate()[0][:-1], None))
    assert painted() is None


@pytest.mark.parametrize("reason", ["one processor", "frozen", "no matplotlib", "no processes"])
def test_there_is_none_where_it_would_spare_nothing_or_cannot_be(reason, monkeypatch):
    monkeypatch.setattr(beside, "usable_processors", lambda: 1 if reason == "one processor" else 2)
    if reason == "frozen":
        monkeypatch.setattr(sys, "frozen", True, raising=False)
    if reason == "no matplotlib":
        monkeypatch.setitem(sys.modules, "matplotlib", None)
    if reason == "no processes":
        monkeypatch.setattr(sys, "executable", "/no/such/python")
    with beside.page_process() as begun:
        assert begun is None


def test_it_ends_with_the_block_and_with_whoever_began_it(tmp_path):
    with beside.page_process() as begun:
        pid = begun and begun.pid
    assert begun is None or not is_there(pid)
    code = (
        "import time\nfrom elastica_cad.plot import page_process as beside\n"
        "beside.usable_processors = lambda: 2\n"
        "with beside.page_process() as begun:\n    print(begun.pid, flush=True)\n    time.sleep(60)\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as process:
        pid = int(process.stdout.readline())
        assert is_there(pid)
        process.kill()
        process.wait()
        wait_until(lambda: not is_there(pid))


@pytest.mark.campaign
@pytest.mark.skipif(ONE_CORE, reason="nothing is painted beside")
@pytest.mark.parametrize("after_s", [0.05, 0.3, 0.6, 0.9])
def test_ctrl_c_ends_both(after_s, tmp_path):
    """A terminal sends it to all that run in it."""
    (tmp_path / "bow.txt").write_text(BOW)
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "from elastica_cad.cli import main; print(flush=True); main()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, *STRIP], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True, process_group=0,
    ) as process:  # fmt: skip
        process.stdout.readline()
        time.sleep(after_s)
        begun = children(process.pid)
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate()
    if process.returncode:
        assert list(tmp_path.rglob("*")) in ([tmp_path / "bow.txt"], [tmp_path / "bow.txt", tmp_path / "out"])
    assert said.count("Traceback") <= 1  # from before the command line was loaded
    wait_until(lambda: not any(map(is_there, begun)))


@pytest.mark.campaign
def test_on_a_full_disk_there_is_a_sentence_and_no_file(tmp_path):
    (tmp_path / "bow.txt").write_text(BOW)
    most = 60_000  # bytes of a file: less than the picture has
    done = subprocess.run(
        [sys.executable, "-m", "elastica_cad", *STRIP], cwd=tmp_path, capture_output=True, text=True,
        check=False, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)),
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    assert "can't be written" in done.stderr
    assert done.stderr.count("\n") == 1
    assert [path.name for path in tmp_path.rglob("*")] == ["bow.txt"]


def test_its_memory_counts():
    from elastica_cad.cli.running.budget import OutOfBudgetError, spend

    def wait():
        for _ in range(3000):
            time.sleep(0.01)  # the end comes between two of them

    # what is held now: its largest share so far may be far above, in a process that has run other tests
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    here = pages * resource.getpagesize() / 2**20
    eat = "held = b'x' * 400_000_000; print(flush=True); input()"
    with subprocess.Popen(
        [sys.executable, "-c", eat], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as eater:
        eater.stdout.readline()
        said = "MB of memory"
        with pytest.raises(OutOfBudgetError, match=said), spend(60, here + 200, beside=lambda: eater.pid):
            wait()
        eater.kill()
