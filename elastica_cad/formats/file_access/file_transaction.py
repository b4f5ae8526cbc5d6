"""Several files that appear together, or not at all."""

import os
import shutil
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from elastica_cad.errors import InputError
from elastica_cad.formats.file_access.atomic_write import check_target, reason


@contextmanager
def write_together(
    folder: str | os.PathLike[str], names: Iterable[str], *, force: bool = False
) -> Iterator[Path]:
    """A temporary folder whose files move to `folder` only when the whole block has succeeded.

    A folder that is not there yet appears in one step. Into one that is there the files move one after the other;
    after an error, or Ctrl-C, the new ones among those that were moved are taken back.

    Parameters
    ----------
    folder : path-like
        Where the files are to be; made if need be.
    names : iterable of str
        File names that the block will write into the folder it is given, in folders of their own where they have /.
    force : bool
        Overwrite files of those names.

    Yields
    ------
    Path
        The temporary folder, on the same disk. A program that is killed may leave it behind.

    Raises
    ------
    InputError
        `folder` is a file or can't be made, or a file exists and `force` is not set: before the block runs.

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
        workshop = _workshop(ground)
        workshop.mkdir()
        try:
            with _about_its_own_files(workshop):
                for name in names:
                    Path(workshop, name).parent.mkdir(parents=True, exist_ok=True)
                yield workshop
                _move(workshop, target, names, force=force)
        finally:
            shutil.rmtree(workshop, ignore_errors=True)


def check_folder(folder: str | os.PathLike[str], names: Iterable[str], *, force: bool = False) -> None:
    """Refuse a folder that files of these names cannot be written to, before they are worked out.

    Parameters
    ----------
    folder, names, force
        As for `write_together`.

    Raises
    ------
    InputError
        As `write_together` would.

    Examples
    --------
    >>> check_folder(".", ["a-name-of-no-file-yet.txt"])
    """
    with _refusals(folder):
        _, ground = _places(folder, names, force=force)
        probe = _workshop(ground)
        probe.mkdir()
        probe.rmdir()


def _workshop(ground: Path) -> Path:
    """A temporary folder's path that nobody else has."""
    return ground / f".elastica-{os.urandom(8).hex()}"


@contextmanager
def _refusals(folder: str | os.PathLike[str]) -> Iterator[None]:
    """What the system refuses, as a sentence."""
    try:
        yield
    except OSError as problem:
        raise InputError(
            f"files can't be written to {folder}: {reason(problem)}; choose another folder"
        ) from problem


@contextmanager
def _about_its_own_files(workshop: Path) -> Iterator[None]:
    """What cannot be written in the workshop is told without that place: nobody asked for it, and it goes."""
    try:
        yield
    except (InputError, OSError) as problem:
        cause = problem.__cause__ if isinstance(problem, InputError) else problem
        place = f"{workshop}{os.sep}"
        if not isinstance(cause, OSError) or place not in str(problem):
            raise
        raise OSError(cause.errno, reason(cause).replace(place, "")) from problem


def _places(folder: str | os.PathLike[str], names: Iterable[str], *, force: bool) -> tuple[Path, Path]:
    """The folder with links followed, checked, and the lowest of those above it that is there."""
    target = Path(os.path.realpath(os.fspath(folder)))
    # a folder that may not be looked into, or a name that no disk takes, is found here already
    if target.exists() and not target.is_dir():
        raise InputError(f"{folder} is a file, not a folder: choose another folder for the files")
    _check(target, names, force=force)
    return target, next(parent for parent in (target, *target.parents) if parent.is_dir())


def _move(workshop: Path, target: Path, names: Sequence[str], *, force: bool) -> None:
    """All files to their places."""
    _check(target, names, force=force)  # another may have come first
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
            os.replace(workshop / name, path)
            new += [] if was_there else [path]
    except BaseException:
        for path in new:
            path.unlink(missing_ok=True)
        raise


def _check(target: Path, names: Iterable[str], *, force: bool) -> None:
    """Refuse files that are there already, or stand where a folder is to be."""
    for path in (target / name for name in names):
        files = [one for one in path.parents if one.exists() and not one.is_dir()]
        if files:
            raise InputError(f"{files[0]} is a file, and a folder is to be there: choose another folder")
        if path.parent.is_dir():
            check_target(path, force=force)
