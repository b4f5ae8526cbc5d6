"""What killed programs leave is removed by the next; what a living one writes is left alone; two take turns."""

import errno
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from elastica_cad.errors import InputError
from elastica_cad.formats.file_access.atomic_write import write_atomically
from elastica_cad.formats.file_access.file_transaction import write_together

pytestmark = pytest.mark.core

ROOT = Path(__file__).resolve().parents[3]
WRITER = """
import sys
from elastica_cad.formats.file_access.atomic_write import write_atomically
from elastica_cad.formats.file_access.file_transaction import write_together
def wait(file):
    file.write(b"half")
    file.flush()
    print("writing", flush=True)
    sys.stdin.read()
with write_together("out", ["a.txt"]) as workshop:
    write_atomically(workshop / "a.txt", b"whole")
    write_atomically("b.txt", wait)
"""


@pytest.fixture
def writer(tmp_path):
    """A program in the midst of writing."""
    process = subprocess.Popen(
        [sys.executable, "-c", WRITER], cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert process.stdout.readline() == "writing\n"
    yield process
    process.kill()
    process.communicate()


def hidden(folder):
    return sorted(path.name for path in folder.rglob(".*"))


def write_both(folder):
    write_atomically(folder / "b.txt", b"next", force=True)
    with write_together(folder / "out", ["c.txt"]) as workshop:
        (workshop / "c.txt").write_text("next")


def test_what_a_killed_program_left_goes_with_the_next(tmp_path, writer):
    writer.send_signal(signal.SIGKILL)
    writer.wait()
    assert len(hidden(tmp_path)) == 3  # a folder with its lock, a file
    write_both(tmp_path)
    assert hidden(tmp_path) == []
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["b.txt", "c.txt", "out"]


def test_a_living_writer_keeps_its_files(tmp_path, writer):
    before = hidden(tmp_path)
    write_both(tmp_path)
    assert hidden(tmp_path) == before
    writer.communicate()
    assert writer.returncode == 1  # b.txt has come meanwhile, and it may not overwrite
    assert hidden(tmp_path) == []
    assert (tmp_path / "b.txt").read_bytes() == b"next"


def test_a_workshop_whose_lock_is_not_yet_there_is_left_for_a_minute(tmp_path):
    young, old = tmp_path / ".elastica-1", tmp_path / ".elastica-2"
    for folder in (young, old):
        folder.mkdir()
        (folder / "a.txt").write_text("half")
    os.utime(old, (time.time() - 600,) * 2)
    with write_together(tmp_path, ["c.txt"]) as workshop:
        (workshop / "c.txt").write_text("next")
    assert young.exists()
    assert not old.exists()


def test_what_came_first_is_not_overwritten(tmp_path):
    def both():
        with write_together(tmp_path, ["a.txt"]) as mine:
            (mine / "a.txt").write_text("mine")
            with write_together(tmp_path, ["a.txt"]) as other:
                (other / "a.txt").write_text("other")

    with pytest.raises(InputError, match=r"a\.txt exists already"):
        both()
    assert (tmp_path / "a.txt").read_text() == "other"
    assert hidden(tmp_path) == []


def test_a_folder_that_no_disk_takes_is_refused(tmp_path):
    folder = write_together(tmp_path / ("far" * 100), ["a.txt"])
    with pytest.raises(InputError, match="choose another folder"), folder:
        pass


@pytest.mark.parametrize("told", ["by ours", "by the system", "by another library"])
def test_a_disk_that_is_full_is_told_by_the_folder_that_was_asked_for(tmp_path, told):
    """The sentences spoke of the workshop, which is gone then."""

    def full(path):
        if told == "by another library":
            raise OSError(f"Cannot open file '{path}'")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    def write():
        with write_together(tmp_path, ["a.txt"]) as workshop:
            path = workshop / "a.txt"
            write_atomically(path, lambda _: full(path)) if told == "by ours" else full(path)

    with pytest.raises(InputError) as refused:
        write()
    why = "Cannot open file 'a.txt'" if told == "by another library" else "No space left on device"
    assert str(refused.value) == f"files can't be written to {tmp_path}: {why}; choose another folder"
    assert list(tmp_path.iterdir()) == []


def test_other_refusals_stay_as_they_are(tmp_path):
    def refused():
        with write_together(tmp_path, ["a.txt"]):
            try:
                raise OSError(errno.ENOENT, os.strerror(errno.ENOENT), "curve.dxf")
            except OSError as error:
                raise InputError("curve.dxf can't be read: give another file") from error

    with pytest.raises(InputError, match=r"curve\.dxf can't be read"):
        refused()
