"""What every reader asks of a file before and while it reads: one clear sentence when something is wrong."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import TypeAlias

from elastica_cad._values import require_path
from elastica_cad.errors import InputError, NotConvergedError

FileMark: TypeAlias = tuple[int, int, int] | None
"""What changes when a file does: time, size and number on the disk; None where there is no file."""

_read: ContextVar[dict[Path, FileMark] | None] = ContextVar("files read", default=None)

_below: ContextVar[tuple[Path, ...]] = ContextVar("folders that may be read", default=())

LARGEST_FILE = 64 * 2**20
"""Bytes of a file of curves."""

LARGEST_OF_KIND = {".toml": 2 * 2**20} | dict.fromkeys(
    (".obj", ".stl", ".ply", ".step", ".stp", ".brep", ".brp"), 256 * 2**20
)
"""Bytes of designs, which are read slowly, and of meshes and bodies, which are large."""


def require_file(path: str | Path) -> Path:
    """Return the path, and refuse it unless a file is there that can be read and holds something.

    Raises
    ------
    InputError
        Nothing there, a folder, no permission, no bytes, or more than are read.
    """
    path, noted = require_path(path), _read.get()
    if noted is not None:
        noted.setdefault(path.absolute(), mark_file(path))
    require_below(path)
    if os.path.isdir(path):  # False, not an error, for a name that no disk takes
        raise InputError("{path} is a folder: name one file in it", path=path)
    if os.path.exists(path) and not path.is_file():
        raise InputError("{path} is no file but a device or a pipe: name a file", path=path)
    try:
        with path.open("rb") as file:
            empty = not file.read(1)
    except OSError as error:
        raise InputError(
            "{path} cannot be read: {strerror}; name a file that is there and may be read",
            path=path,
            strerror=error.strerror or error,
        ) from error
    if empty:
        raise InputError("{path} is empty: save it anew in the program that made it", path=path)
    size, most = path.stat().st_size, LARGEST_OF_KIND.get(path.suffix.lower(), LARGEST_FILE)
    if size > most:
        raise InputError(
            "{path} has {size:.0f} MB, and at most {most} MB are read: leave out what is not "
            "needed, or simplify it",
            path=path,
            size=size / 2**20,
            most=most // 2**20,
        )
    return path


def require_below(path: Path) -> None:
    """Refuse a file outside of the folders of `read_below`, links followed."""
    folders, real = _below.get(), Path(os.path.realpath(path))
    if folders and not any(real.is_relative_to(folder) for folder in folders):
        raise InputError(
            "{path} lies outside of {folders}, and a design reads files below its own folder or "
            "the one you work in: copy it there, or allow its folder (--below FOLDER)",
            path=path,
            folders=folders[0],
        )


@contextmanager
def read_below(*folders: str | os.PathLike[str]) -> Iterator[None]:
    """Let the block read files in these folders, and below them, only."""
    token = _below.set(tuple(Path(os.path.realpath(folder)) for folder in folders))
    try:
        yield
    finally:
        _below.reset(token)


def mark_file(path: Path) -> FileMark:
    """Return a mark of the file's contents: equal marks mean equal contents."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


@contextmanager
def note_reads() -> Iterator[dict[Path, FileMark]]:
    """Collect the files that the block requests by `require_file`, with their marks just before they are read."""
    noted: dict[Path, FileMark] = {}
    token = _read.set(noted)
    try:
        yield noted
    finally:
        _read.reset(token)


@contextmanager
def quiet_log(name: str) -> Iterator[None]:
    """Keep a library's log off the screen during the block, unless the program handles it."""
    import logging

    logger, silence = logging.getLogger(name), logging.NullHandler()
    logger.addHandler(silence)
    try:
        yield
    finally:
        logger.removeHandler(silence)


@contextmanager
def name_source(path: str | Path) -> Iterator[Path]:
    """Check a file as `require_file` does, and name it in every error that the block raises about its contents."""
    path = require_file(path)
    try:
        yield path
    except (InputError, NotConvergedError) as error:
        message = str(error)
        raise type(error)(message if str(path) in message else f"{path}: {message}") from error
