"""Atomic writing of single files and of groups of files."""

import json
import os
import re
import shutil
import sys
import time
from codecs import BOM_UTF8
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from io import FileIO
from pathlib import Path
from typing import Any, BinaryIO

from elastica_cad._values import require_flag, require_path
from elastica_cad.errors import FieldName, InputError


def write_text(path: Path, text: str) -> None:
    """Write a text to a file in UTF-8, with line feeds as line ends on every system.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_text(Path(folder, "a.txt"), "8 µm\\n")
    ...     Path(folder, "a.txt").read_bytes()
    b'8 \\xc2\\xb5m\\n'
    """
    path.write_text(text, encoding="utf-8", newline="\n")


def write_json(path: Path, record: Any) -> None:
    """Write a record to a file as JSON."""
    write_text(path, json.dumps(record, indent=1) + "\n")


def check_target(path: str | os.PathLike[str], *, force: bool = False) -> Path:
    """Return the path of a file to be written, after following symbolic links.

    Raise InputError if the file cannot be written.
    """
    require_flag(force, "force")
    target = Path(os.path.realpath(require_path(path)))
    if target.is_dir():
        raise InputError("{path} is a folder: give the name of a file in it", path=path)
    if not target.parent.is_dir():
        raise InputError(
            "{path} cannot be written, because there is no folder {parent}: create this folder first",
            path=path,
            parent=target.parent,
        )
    if target.exists() and not force:
        raise InputError(
            "{path} exists already: choose another name, or allow it to be overwritten ({field})",
            field=FieldName("force"),
            path=path,
            kind="exists",
        )
    if target.exists() and not os.access(target, os.W_OK):
        raise InputError(
            "{path} cannot be written, because you have no permission to change it: choose another name",
            path=path,
        )
    return target


def write_atomically(
    path: str | os.PathLike[str], content: bytes | Callable[[BinaryIO], None], force: bool = False
) -> Path:
    """Write a file under a temporary name in its folder, then rename it.

    After an error, no incomplete file remains. A killed program may leave the file with the temporary name.

    Parameters
    ----------
    path : path-like
        The file.
    content : bytes, or callable
        The bytes, or a function that writes them to an open binary file.
    force : bool
        Overwrite a file of that name.

    Returns
    -------
    Path
        The file written.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_atomically(folder + "/note.txt", b"done").read_bytes()
    b'done'
    """
    if not (callable(content) or isinstance(content, bytes | bytearray | memoryview)):
        raise InputError(
            "the content is a {name}: give bytes, or a function that writes them",
            name=type(content).__name__,
        )
    target = check_target(path, force=force)
    temporary = target.with_name(f".{target.name[:40]}.{os.urandom(6).hex()}.part")
    try:
        with temporary.open("xb") as file:
            try:
                if callable(content):
                    content(file)
                else:
                    file.write(content)
                file.close()
                # another process may have written the file in the meantime
                check_target(path, force=force)
                _replace(temporary, target)
            except BaseException:
                # Windows cannot remove an open file
                file.close()
                with suppress(OSError):  # a file cannot be removed from a read-only disk
                    temporary.unlink()
                raise
    except OSError as error:
        raise InputError(
            "{path} cannot be written: {reason}; choose another place", path=path, reason=reason(error)
        ) from error
    return target


def _replace(new: Path, target: Path) -> None:
    """Move a file to `target`. A file that is overwritten keeps its mode and, if it is a text, its form."""
    if target.exists():
        # users edit these texts, so their byte order mark and line ends are kept
        if target.suffix.lower() in (".toml", ".csv", ".txt"):
            before, text = target.read_bytes(), new.read_bytes().removeprefix(BOM_UTF8)
            mark = BOM_UTF8 if before.startswith(BOM_UTF8) else b""
            line_end = b"\r\n" if 2 * before.count(b"\r\n") > before.count(b"\n") else b"\n"
            new.write_bytes(mark + text.replace(b"\r\n", b"\n").replace(b"\n", line_end))
        shutil.copymode(target, new)
    os.replace(new, target)


def reason(error: OSError) -> str:
    """Return the reason why a file can't be written, worded as the end of a sentence."""
    return "no permission" if isinstance(error, PermissionError) else error.strerror or str(error)


@contextmanager
def write_together(
    folder: str | os.PathLike[str], names: Iterable[str], *, force: bool = False
) -> Iterator[Path]:
    """Provide a temporary folder, whose files are moved to `folder` if the `with` block succeeds.

    A new folder appears in a single step. If the folder exists, the files move one by one. If moving fails or
    Ctrl-C stops it, moved files that did not replace another file are removed.

    Parameters
    ----------
    folder : path-like
        Target folder; created if it does not exist.
    names : iterable of str
        Names of the files that the block writes into the temporary folder. A name with / is in a subfolder.
    force : bool
        Overwrite files of those names.

    Yields
    ------
    Path
        The temporary folder, on the same disk. If the process is killed, the folder remains, and a later call
        removes it after a day.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as base:
    ...     with write_together(base + "/out", ["a.txt"]) as workshop:
    ...         _ = (workshop / "a.txt").write_text("done")
    ...     Path(base, "out", "a.txt").read_text()
    'done'
    """
    names = list(names)
    with _refusals(folder):
        target, ground = _places(folder, names, force=force)
        with _workshop(ground, target.parent) as workshop, _about_its_own_files(workshop):
            for name in names:
                Path(workshop, name).parent.mkdir(parents=True, exist_ok=True)
            yield workshop
            _move(workshop, target, names, force=force)


@dataclass(frozen=True)
class File:
    """A file that is going to be written to a folder.

    Attributes
    ----------
    name : str
        Name of the file; a name with / is in a subfolder.
    write : callable
        Function that writes the file to a path.
    description : str
        Contents of the file, for lists of files.
    """

    name: str
    write: Callable[[Path], object]
    description: str = ""


def text_file(name: str, text: str, description: str = "") -> File:
    """Return a file with a text, in UTF-8."""
    return File(name, partial(write_text, text=text), description)


def write_files(
    files: Sequence[File],
    folder: str | os.PathLike[str],
    *,
    force: bool = False,
    done: Callable[[str, int], None] | None = None,
) -> tuple[Path, ...]:
    """Write all files into a folder and return their paths. After any error, no file is written.

    Parameters
    ----------
    files : sequence of File
        The files in the order of writing. A file may read the previous files, which are in the same temporary
        folder.
    folder, force
        As for `write_together`.
    done : callable, optional
        Function that is called after each file with its name and the total number of files.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     paths = write_files([text_file("a.txt", "done")], folder)
    ...     paths[0].name, paths[0].read_text()
    ('a.txt', 'done')
    """
    with write_together(folder, [file.name for file in files], force=force) as workshop:
        for file in files:
            file.write(workshop / file.name)
            if done is not None:
                done(file.name, len(files))
    return tuple(Path(folder, file.name) for file in files)


def check_folder(folder: str | os.PathLike[str], names: Iterable[str], *, force: bool = False) -> None:
    """Raise InputError for a folder to which files of these names cannot be written.

    Parameters
    ----------
    folder, names, force
        As for `write_together`.

    Examples
    --------
    >>> check_folder(".", ["a-name-of-no-file-yet.txt"])
    """
    with _refusals(folder):
        target, ground = _places(folder, names, force=force)
        with _workshop(ground, target.parent):
            pass


_LOCK, _FILES = "lock", "files"
"""Contents of a temporary folder: the lock file of its process, and the folder of written files."""

_OURS = b"elastica_cad writes files here\n"
"""Content of a lock file."""


@contextmanager
def _workshop(ground: Path, above: Path) -> Iterator[Path]:
    """Provide a folder inside a new, locked temporary folder in `ground`. At the end, both folders are removed.

    First, temporary folders in `ground` and `above` are removed if their process was killed more than a day
    ago.
    """
    for place in {ground, above}:
        for old in place.glob(".elastica-*"):
            with suppress(OSError):  # another process may be using or removing the folder
                _remove_stale(old)
    home = ground / f".elastica-{os.urandom(8).hex()}"
    home.mkdir()
    try:
        with (home / _LOCK).open("xb", buffering=0) as lock:
            lock.write(_OURS)
            _take(lock)
            (home / _FILES).mkdir()
            yield home / _FILES
    finally:
        _remove(home)


def _remove(home: Path) -> None:
    """Remove a temporary folder.

    Its lock file is removed last, so that a later run recognizes the folder after an interruption.
    """
    shutil.rmtree(home / _FILES, ignore_errors=True)
    with suppress(OSError):  # on Windows, a folder that a program displays cannot be removed
        (home / _LOCK).unlink(missing_ok=True)
        home.rmdir()


def _remove_stale(home: Path) -> None:
    """Remove a temporary folder that a dead process has left, if it is one of ours and older than a day."""
    lock = home / _LOCK
    if home.is_symlink() or lock.is_symlink() or not re.fullmatch(r"\.elastica-[0-9a-f]{16}", home.name):
        return
    # a folder of a dead process is removed after a day
    if time.time() - home.stat().st_mtime < 24 * 3600 or lock.stat().st_size != len(_OURS):
        return
    with lock.open("r+b") as file:
        if file.read() != _OURS:
            return
        _take(file)
    _remove(home)


def _take(lock: BinaryIO | FileIO) -> None:
    """Lock an open file until it is closed or its process ends.

    Raise OSError if another process has locked the file.
    """
    if sys.platform == "win32":
        import msvcrt

        # lock the byte after the text, so that other processes can read the text
        lock.seek(len(_OURS))
        msvcrt.locking(lock.fileno(), msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)


@contextmanager
def _refusals(folder: str | os.PathLike[str]) -> Iterator[None]:
    try:
        yield
    except OSError as problem:
        raise InputError(
            "files cannot be written to {folder}: {reason}; choose another folder",
            folder=folder,
            reason=reason(problem),
        ) from problem


@contextmanager
def _about_its_own_files(workshop: Path) -> Iterator[None]:
    """Remove the name of the temporary folder, which means nothing to the user, from error messages."""
    try:
        yield
    except (InputError, OSError) as problem:
        cause = problem.__cause__ if isinstance(problem, InputError) else problem
        place = f"{workshop}{os.sep}"
        if not isinstance(cause, OSError) or place not in str(problem):
            raise
        raise OSError(cause.errno, reason(cause).replace(place, "")) from problem


def _places(folder: str | os.PathLike[str], names: Iterable[str], *, force: bool) -> tuple[Path, Path]:
    """Check the folder, and return its real path and its nearest existing parent."""
    target = Path(os.path.realpath(os.fspath(folder)))
    # `exists` raises OSError for unreadable folders and invalid names
    if target.exists() and not target.is_dir():
        raise InputError(
            "{folder} is a file, not a folder: choose another folder for the files", folder=folder
        )
    _check(target, names, force=force)
    return target, next(parent for parent in (target, *target.parents) if parent.is_dir())


def _move(workshop: Path, target: Path, names: Sequence[str], *, force: bool) -> None:
    """Move the written files to their target.

    If a file cannot be moved, remove the new files moved before it.
    """
    # another process may have written files in the meantime
    _check(target, names, force=force)
    if not target.exists():
        target.parent.mkdir(parents=True, exist_ok=True)
        os.rename(workshop, target)
        return
    new: list[Path] = []
    try:
        for name in names:
            path = target / name
            path.parent.mkdir(parents=True, exist_ok=True)
            was_there = path.exists()
            _replace(workshop / name, path)
            new += [] if was_there else [path]
    except BaseException:
        for path in new:
            path.unlink(missing_ok=True)
        raise


def _check(target: Path, names: Iterable[str], *, force: bool) -> None:
    """Refuse files outside the target, below another file, or, without `force`, already there."""
    for path in (target / name for name in names):
        if target not in path.parents or ".." in path.parts:
            raise InputError(
                "{path} is outside the folder {folder}: give the file another name", path=path, folder=target
            )
        files = [parent for parent in path.parents if parent.exists() and not parent.is_dir()]
        if files:
            raise InputError(
                "{files} is a file, but a folder is needed there: choose another folder", files=files[0]
            )
        if path.parent.is_dir():
            check_target(path, force=force)
