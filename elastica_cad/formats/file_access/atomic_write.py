"""Files that appear whole or not at all."""

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from elastica_cad._values import require_flag, require_path
from elastica_cad.errors import InputError


def check_target(path: str | os.PathLike[str], *, force: bool = False) -> Path:
    """The file to be written, with links followed, refused early where it can't be.

    Raises
    ------
    InputError
        It is a folder, its folder is missing, or it exists and `force` is not set.
    """
    require_flag(force, "force")
    target = Path(os.path.realpath(require_path(path)))
    if target.is_dir():
        raise InputError(f"{path} is a folder: give the name of a file in it")
    if not target.parent.is_dir():
        raise InputError(f"{path} can't be written: there is no folder {target.parent}; create it first")
    if target.exists() and not force:
        raise InputError(
            f"{path} exists already: choose another name, or allow it to be overwritten (--force, or force=True)"
        )
    if target.exists() and not os.access(target, os.W_OK):
        raise InputError(f"{path} can't be written: no permission to change that file; choose another name")
    return target


def write_atomically(
    path: str | os.PathLike[str], content: bytes | Callable[[BinaryIO], None], force: bool = False
) -> Path:
    """Write a file under a temporary name beside its place, then rename it: no file is ever half written.

    A program that is killed while it writes may leave the file of that temporary name.

    Parameters
    ----------
    path : path-like
        The file.
    content : bytes, or callable
        The bytes, or a function that writes them to the open binary file it is given.
    force : bool
        Overwrite a file of that name.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        As `check_target`; or there is no permission or no room.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_atomically(folder + "/note.txt", b"done").read_bytes()
    b'done'
    """
    if not (callable(content) or isinstance(content, bytes | bytearray | memoryview)):
        raise InputError(
            f"what is written is a {type(content).__name__}: give bytes, or a function that writes them"
        )
    target = check_target(path, force=force)
    temporary = target.with_name(f".{target.name[:100]}.{os.urandom(6).hex()}.part")
    try:
        with temporary.open("xb") as file:
            try:
                if callable(content):
                    content(file)
                else:
                    file.write(content)
                file.close()
                check_target(path, force=force)  # another may have come first
                os.replace(temporary, target)
            except BaseException:
                file.close()  # Windows removes no file that is open
                with suppress(OSError):  # a disk that nobody may write to refuses this too
                    temporary.unlink()
                raise
    except OSError as error:
        raise InputError(f"{path} can't be written: {reason(error)}; choose another place") from error
    return target


def reason(error: OSError) -> str:
    """Why a file can't be written, for a sentence."""
    return "no permission" if isinstance(error, PermissionError) else error.strerror or str(error)
