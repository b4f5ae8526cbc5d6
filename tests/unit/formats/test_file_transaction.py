"""Files that appear together or not at all; nothing is removed but what the run itself made."""

import errno
import os
import subprocess
import sys
import time

import pytest

from elastica_cad.errors import InputError
from elastica_cad.formats.write_files import check_folder, write_atomically, write_together

pytestmark = pytest.mark.core


def hidden(folder):
    return sorted(path.name for path in folder.rglob(".*"))


def write_both(folder):
    write_atomically(folder / "b.txt", b"next", force=True)
    with write_together(folder / "out", ["c.txt"], force=True) as workshop:
        (workshop / "c.txt").write_text("next")


def test_what_others_call_by_names_like_ours_stays(tmp_path):
    """Such files and folders were removed once they were a minute old, in the folder written to or its parent."""
    notes, kit, part = (
        tmp_path / ".elastica-notes",
        tmp_path / "out" / ".elastica-1",
        tmp_path / ".b.txt.0a.part",
    )
    for folder in (notes, kit):
        folder.mkdir(parents=True)
        (folder / "a.txt").write_text("mine")
        os.utime(folder, (time.time() - 600,) * 2)
    part.write_text("mine")
    write_both(tmp_path)
    write_both(tmp_path)
    assert all((folder / "a.txt").read_text() == "mine" for folder in (notes, kit))
    assert hidden(tmp_path) == sorted(path.name for path in (notes, kit, part))


def test_a_new_folder_appears_in_one_step(tmp_path, monkeypatch):
    """A program that is killed at any moment leaves the whole kit or none of it."""
    monkeypatch.setattr(os, "replace", None)  # no file is moved by itself
    with write_together(tmp_path / "far" / "out", ["a.txt", "parts/b.txt"]) as workshop:
        for name in ("a.txt", "parts/b.txt"):
            (workshop / name).write_text("whole")
        assert not (tmp_path / "far").exists()
    names = sorted(path.name for path in tmp_path.rglob("*"))
    assert names == ["a.txt", "b.txt", "far", "out", "parts"]


@pytest.mark.parametrize("problem", [KeyboardInterrupt, OSError(errno.ENOSPC, "No space left")])
def test_what_ends_the_moving_takes_back_what_is_new(tmp_path, monkeypatch, problem):
    replace = os.replace

    def stops(source, path):
        if path.name == "c.txt":
            raise problem
        replace(source, path)

    (tmp_path / "a.txt").write_text("old")
    (tmp_path / "stranger.txt").write_text("mine")
    monkeypatch.setattr(os, "replace", stops)
    names = ["a.txt", "b.txt", "c.txt"]

    def write():
        with write_together(tmp_path, names, force=True) as workshop:
            for name in names:
                (workshop / name).write_text("new")

    with pytest.raises((KeyboardInterrupt, InputError)):
        write()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.txt", "stranger.txt"]


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


@pytest.mark.parametrize("result", ["by ours", "by the system", "by another library"])
def test_a_disk_that_is_full_is_named_by_the_folder_that_was_requested(tmp_path, result):
    """The sentences spoke of the workshop, which is gone then."""

    def full(path):
        if result == "by another library":
            raise OSError(f"Cannot open file '{path}'")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    def write():
        with write_together(tmp_path, ["a.txt"]) as workshop:
            path = workshop / "a.txt"
            write_atomically(path, lambda _: full(path)) if result == "by ours" else full(path)

    with pytest.raises(InputError) as refused:
        write()
    why = "Cannot open file 'a.txt'" if result == "by another library" else "No space left on device"
    assert str(refused.value) == f"files cannot be written to {tmp_path}: {why}; choose another folder"
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


KILLED = """
import os, signal, sys
from elastica_cad.formats.write_files import write_together
with write_together(sys.argv[1], ["a.txt"]) as workshop:
    (workshop / "a.txt").write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_a_killed_run_is_cleaned_up_a_day_later_and_nothing_else_is(tmp_path):
    subprocess.run([sys.executable, "-c", KILLED, str(tmp_path / "out")], check=False)
    (killed,) = tmp_path.glob(".elastica-*")
    assert (killed / "files" / "a.txt").exists()
    other = tmp_path / ".elastica-0123456789abcdef"
    other.mkdir()
    (other / "lock").write_text("of another program")
    day_ago = time.time() - 25 * 3600
    os.utime(other, (day_ago, day_ago))

    def write(name):
        with write_together(tmp_path, [name]) as workshop:
            (workshop / name).write_text("whole")
            (home,) = {*tmp_path.glob(".elastica-*")} - {killed, other}
            os.utime(home, (day_ago, day_ago))
            check_folder(tmp_path, ["b.txt"])  # a run of another process: this one is alive
            assert home.exists()

    write("first.txt")
    assert killed.exists()  # not a day old
    os.utime(killed, (day_ago, day_ago))
    write("second.txt")
    assert [path.name for path in tmp_path.glob(".elastica-*")] == [other.name]


@pytest.mark.parametrize("name", ["../b.txt", "a/../../b.txt", "a/../b.txt", "/b.txt", ".."])
def test_nothing_is_written_outside_the_folder(tmp_path, name):
    folder = tmp_path / "out"
    with pytest.raises(InputError, match="is outside the folder"):
        check_folder(folder, [name])
    with pytest.raises(InputError, match="is outside the folder"), write_together(folder, [name], force=True):
        raise AssertionError
    assert not [*tmp_path.iterdir()]
