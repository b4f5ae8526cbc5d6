import errno
import os
from pathlib import Path

import pytest

from elastica_cad import InputError
from elastica_cad.formats import write_atomically
from elastica_cad.formats.write_files import File, write_files

pytestmark = pytest.mark.core


def test_bytes_or_a_writer(tmp_path):
    assert write_atomically(tmp_path / "a.txt", b"one").read_bytes() == b"one"
    assert write_atomically(str(tmp_path / "b.txt"), lambda file: file.write(b"two")).read_bytes() == b"two"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.txt", "b.txt"]


def test_nothing_is_overwritten_unless_allowed(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("old")
    with pytest.raises(InputError, match=r"a\.txt exists already.*force"):
        write_atomically(path, b"new")
    assert path.read_text() == "old"
    write_atomically(path, b"new", force=True)
    assert path.read_text() == "new"


def test_folders_are_no_files(tmp_path):
    with pytest.raises(InputError, match="is a folder: give the name of a file"):
        write_atomically(tmp_path, b"x", force=True)
    with pytest.raises(InputError, match=r"no folder .*missing: create this folder"):
        write_atomically(tmp_path / "missing" / "a.txt", b"x")
    (tmp_path / "plain").write_text("")
    with pytest.raises(InputError, match="no folder"):
        write_atomically(tmp_path / "plain" / "a.txt", b"x")


def test_a_writer_that_fails_leaves_the_old_file(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("old")

    def broken(file):
        file.write(b"half")
        raise KeyError("broken")

    with pytest.raises(KeyError):
        write_atomically(path, broken, force=True)
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]
    assert path.read_text() == "old"


@pytest.mark.parametrize(
    ("code", "reason"),
    [(errno.EACCES, "no permission"), (errno.ENOSPC, "No space left"), (errno.EROFS, "Read-only")],
)
def test_what_the_system_refuses_is_said(tmp_path, monkeypatch, code, reason):
    def refuse(*_):
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr(os, "replace", refuse)
    with pytest.raises(InputError, match=f"a.txt cannot be written: {reason}"):
        write_atomically(tmp_path / "a.txt", b"x")
    assert not list(tmp_path.iterdir())


def test_a_disk_that_is_read_only_is_said(tmp_path, monkeypatch):
    """Such a disk refuses to remove what is not there, too."""

    def refuse(self, *_, **__):
        raise OSError(errno.EROFS, os.strerror(errno.EROFS), str(self))

    monkeypatch.setattr(Path, "open", refuse)
    monkeypatch.setattr(Path, "unlink", refuse)
    with pytest.raises(InputError, match=r"a\.txt cannot be written: Read-only file system; choose another"):
        write_atomically(tmp_path / "a.txt", b"x")


def test_read_only_files_stay(tmp_path, monkeypatch):
    path = tmp_path / "a.txt"
    path.write_text("old")
    path.chmod(0o444)
    # a superuser may write anything: ask as others would
    monkeypatch.setattr(
        os, "access", lambda file, mode: not (mode & os.W_OK) or bool(os.stat(file).st_mode & 0o200)
    )
    with pytest.raises(InputError, match="no permission to change it"):
        write_atomically(path, b"new", force=True)
    assert path.read_text() == "old"


def test_links_are_followed(tmp_path):
    real = tmp_path / "real.txt"
    real.write_text("old")
    link = tmp_path / "link.txt"
    link.symlink_to(real)
    write_atomically(link, b"new", force=True)
    assert link.is_symlink()
    assert real.read_text() == "new"


def test_permissions_follow_the_users_mask(tmp_path):
    before = os.umask(0o027)
    try:
        path = write_atomically(tmp_path / "a.txt", b"x")
    finally:
        os.umask(before)
    assert path.stat().st_mode & 0o777 == 0o640


MARK = b"\xef\xbb\xbf"


@pytest.mark.parametrize("mark", [b"", MARK])
@pytest.mark.parametrize("line_end", [b"\n", b"\r\n"])
@pytest.mark.parametrize("mode", [0o600, 0o664])
def test_a_file_that_is_overwritten_keeps_its_mode_and_form(tmp_path, mark, line_end, mode):
    """One file, or a folder of files; line ends of the new text do not matter."""
    for name, new in (("a.toml", b"x = 2\ny = 3\n"), ("b.TXT", b"2\r\n3\r\n"), ("c.csv", MARK + b"2\n3\n")):
        path = tmp_path / name
        for write in (
            lambda path, new: write_atomically(path, new, force=True),
            lambda path, new: write_files(
                [File(path.name, lambda file: file.write_bytes(new))], path.parent, force=True
            ),
        ):
            path.write_bytes(mark + b"1" + line_end)
            path.chmod(mode)
            write(path, new)
            text = new.removeprefix(MARK).replace(b"\r\n", b"\n").replace(b"\n", line_end)
            assert path.read_bytes() == mark + text
            assert path.stat().st_mode & 0o777 == mode


def test_other_files_keep_their_mode_and_are_written_as_they_are(tmp_path):
    path = tmp_path / "a.stl"
    path.write_bytes(MARK + b"solid\r\n")
    path.chmod(0o600)
    write_atomically(path, b"\n\r\n\0", force=True)
    assert path.read_bytes() == b"\n\r\n\0"
    assert path.stat().st_mode & 0o777 == 0o600
