"""Checks of input files: size of the file, range of its numbers, count of its shapes."""

import os
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from json import dumps
from pathlib import Path
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_path
from elastica_cad.errors import BareLength, FieldName, InputError, Length, NotConvergedError

FileMark: TypeAlias = tuple[int, int, int] | None
"""Fingerprint of a file (modification time, size and inode number), or None for a missing file."""

_read: ContextVar[dict[Path, FileMark] | None] = ContextVar("files read", default=None)

_below: ContextVar[tuple[Path, ...]] = ContextVar("folders that may be read", default=())

UNIT = FieldName("unit")
"""Name, in messages, of the option or key that sets the unit of a file."""

LARGEST_FILE = 64 * 10**6
"""Largest size of a file of curves, bytes."""

MESH_SUFFIXES = (".obj", ".stl", ".ply")
KERNEL_SUFFIXES = (".step", ".stp", ".brep")

LARGEST_OF_KIND = {".toml": 2 * 10**6} | dict.fromkeys((*MESH_SUFFIXES, *KERNEL_SUFFIXES), 256 * 10**6)
"""Largest sizes, bytes, of other kinds of files: designs are parsed slowly, and meshes and bodies are large."""


def require_file(path: str | Path) -> Path:
    """Return the path of a file. Raise InputError if the file is missing, empty, too large or not
    readable."""
    path, noted = require_path(path), _read.get()
    if noted is not None:
        noted.setdefault(path.absolute(), mark_file(path))
    require_below(path)
    if os.path.isdir(path):  # `isdir` raises no error for invalid names
        raise InputError("{path} is a folder: name one file in it", path=path)
    if os.path.exists(path) and not path.is_file():
        raise InputError("{path} is a device or a pipe, not a file: name a file", path=path)
    try:
        with path.open("rb") as file:
            empty = not file.read(1)
    except OSError as error:
        raise InputError(
            "{path} cannot be read: {strerror}; name a readable file",
            path=path,
            strerror=error.strerror or error,
        ) from error
    if empty:
        raise InputError("{path} is empty: save the file again in the program that made it", path=path)
    size, most = path.stat().st_size, LARGEST_OF_KIND.get(path.suffix.lower(), LARGEST_FILE)
    if size > most:
        raise InputError(
            "{path} has {size:.0f} MB, more than the limit of {most} MB: remove unneeded parts, or "
            "simplify the file",
            path=path,
            size=size / 10**6,
            most=most // 10**6,
        )
    return path


def file_in(folder: Path, name: str) -> Path:
    """Return the path of a file that a design in `folder` names. Raise InputError if there is none."""
    path = folder / name
    if not path.is_file():
        raise InputError(
            "the file {name} does not exist. Write / in place of \\."
            if any(character < " " or character == "\\" for character in name)
            else "the file {path} does not exist. Write its name relative to the design file.",
            name=dumps(name, ensure_ascii=False),
            path=path,
        )
    return path


def require_below(path: Path) -> None:
    """Raise InputError for a file outside the folders that `read_below` allows, with symbolic links resolved."""
    folders, real = _below.get(), Path(os.path.realpath(path))
    if folders and not any(real.is_relative_to(folder) for folder in folders):
        raise InputError(
            "{path} is outside {folders}, but a design reads only files in its folder or the working folder: "
            "copy the file there, or allow its folder ({field})",
            field=FieldName("below"),
            path=path,
            folders=folders[0],
        )


@contextmanager
def read_below(*folders: str | os.PathLike[str]) -> Iterator[None]:
    """Allow a `with` block to read files only in these folders and their subfolders."""
    token = _below.set(tuple(Path(os.path.realpath(folder)) for folder in folders))
    try:
        yield
    finally:
        _below.reset(token)


def mark_file(path: Path) -> FileMark:
    """Return time, size and inode of a file, which differ after the file was written again."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


@contextmanager
def note_reads() -> Iterator[dict[Path, FileMark]]:
    """Collect the files that a `with` block passes to `require_file`, with their fingerprints."""
    noted: dict[Path, FileMark] = {}
    token = _read.set(noted)
    try:
        yield noted
    finally:
        _read.reset(token)


@contextmanager
def quiet_log(name: str) -> Iterator[None]:
    """Silence the log of a library during a `with` block, unless the program has set up logging."""
    import logging

    logger, silence = logging.getLogger(name), logging.NullHandler()
    logger.addHandler(silence)
    try:
        yield
    finally:
        logger.removeHandler(silence)


@contextmanager
def name_source(path: str | Path) -> Iterator[Path]:
    """Check a file with `require_file`, and add its name to the errors that the `with` block raises."""
    path = require_file(path)
    try:
        yield path
    except (InputError, NotConvergedError) as error:
        message = str(error)
        raise type(error)(message if str(path) in message else f"{path}: {message}") from error


SMALLEST_SIZE, LARGEST_SIZE = 1e-3, 1e6
"""Smallest and largest size of curves that are read, mm."""

FARTHEST = 1e10
"""Largest coordinate, mm. Maps in metres with a distant origin need this range."""

LARGEST_NUMBER = 1e9
"""Largest absolute value of an option or of a number in a design, in any unit.

Most options have smaller limits."""

MOST_SHAPES = 20_000
"""Largest number of shapes in a drawing. A shape in a block or clone is counted for every copy."""

MOST_EDGES = 120_000
"""Largest number of pieces of all curves of a file."""

MOST_CURVES = 5_000

MOST_PIECES = 3_000
"""Largest number of pieces of a curve.

The limit of control points and of measured points is four times as large."""

MOST_DEGREE = 25

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_WRITTEN = re.compile(r"[-+]?(\d*)(?:\.(\d*))?(?:[eE]([-+]?\d+))?")


def check_places(points: FloatArray) -> FloatArray:
    """Return coordinates in mm. Raise InputError if any is too large or not finite."""
    bad = ~(np.abs(points) <= FARTHEST)
    if bad.any():
        value = points[bad].flat[0]
        raise InputError(
            "a coordinate is {given}, not between {low:g} and {high:g}: check the unit, or export the "
            "file again",
            given=Length(value),
            low=BareLength(-FARTHEST),
            high=Length(FARTHEST),
        )
    return points


def check_size(points: FloatArray, *, in_file: bool = True) -> None:
    """Raise InputError for control points (n, d), mm, that are too small or too large for a strip.

    The message names the option for the unit only if the curve is in a file.
    """
    check_places(points)
    size = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    if size != 0 and not SMALLEST_SIZE <= size <= LARGEST_SIZE:
        raise InputError(
            "a curve has a size of {size}, outside {smallest_size:g} to {largest_size:g}: check the unit "
            "({field}), or leave the curve out"
            if in_file
            else "The size of the curve is {size}, outside {smallest_size:g} to {largest_size:g}. Check the unit.",
            field=UNIT,
            size=Length(size),
            smallest_size=BareLength(SMALLEST_SIZE),
            largest_size=Length(LARGEST_SIZE),
        )


def check_count(count: int, most: int, what: str, instead: str) -> int:
    """Return `count`. Raise InputError if it exceeds `most`.

    The message names the counted items, `what`, and gives the instruction `instead`.
    """
    if count > most:
        raise InputError(
            "has {whole} {what}, more than the limit of {most}: {instead}",
            whole=_shortened(count),
            what=what,
            most=most,
            instead=instead,
        )
    return count


def check_degree(degree: int) -> int:
    """Return the degree of a spline, and refuse a degree outside 1 to `MOST_DEGREE`."""
    if not 1 <= degree <= MOST_DEGREE:
        raise InputError(
            "a spline has degree {whole}, outside 1 to {most_degree}: export it with degree 3",
            whole=_shortened(degree),
            most_degree=MOST_DEGREE,
        )
    return degree


def check_tolerance(value: float, name: str = "tolerance") -> float:
    """Check and return the tolerance, mm, with which a file reader joins segments and fits splines.

    Parameters
    ----------
    value : float
        From 1e-9 to 1000 mm.
    name : str
        Name in the message.
    """
    if not (isinstance(value, int | float | np.number) and 1e-9 <= value <= 1e3):
        raise InputError(
            "the {name} for reading is {given!r}: set 1e-9 to 1000 mm, such as 0.01",
            name=name,
            given=value,
        )
    return float(value)


def _shortened(number: int) -> str:
    return str(number) if abs(number) < 10**12 else "more than 1e12"


def half_last_place(numbers: Iterable[str]) -> float:
    """Return half a unit of the last written digit of coordinates: their largest rounding error.

    If a program writes a fixed number of decimals, the number with the most decimals determines the result,
    because trailing zeros may be missing. If a program writes a fixed number of significant digits, the largest
    number determines the result, because its rounding is coarsest. Without numbers the result is 0.

    Examples
    --------
    >>> half_last_place(["12.34", "7.5", "100"]), half_last_place(["123.45678", "0.0012345678"])
    (0.005, 5e-06)
    """
    rows = [row for row in map(_value_and_digits, numbers) if row is not None]
    if not rows:
        return 0.0
    largest = max(size for size, _, _ in rows)
    # much smaller numbers are rounding errors, whose many decimals do not count
    plain = [row for row in rows if row[0] > 1e-6 * largest or row[0] == 0]
    most = decimals = max(places for _, places, _ in plain)
    significant = max(digits for _, _, digits in plain)
    before_point = int(np.floor(np.log10(largest))) + 1 if largest > 0 else 1
    # the numbers with most digits before the point
    top = [row for row in plain if row[0] >= 10.0 ** (before_point - 1)]
    # programs that write a fixed number of significant digits write at least 6; otherwise the decimals of the
    # numbers with most digits before the point count if two of them are no multiples of 10
    if significant >= 6 or sum(size % 10 != 0 for size, _, _ in top) >= 2:
        decimals = max([places for _, places, _ in top], default=decimals)
        decimals = max(decimals, min(most, significant - before_point))
    return float(0.5 * 10.0 ** -min(max(decimals, 0), 30))


def _value_and_digits(text: str) -> tuple[float, int, int] | None:
    """Return the absolute value of a number, its decimals and its significant digits, or None for other text."""
    match = _WRITTEN.fullmatch(text.strip())
    if match is None or not (match[1] or match[2]):
        return None
    whole, fraction, power = match[1] or "", match[2] or "", match[3] or "0"
    if len(power) > 4:
        return None
    size = abs(float(text))
    if not size < 1e300:
        return None
    digits = (whole + fraction if fraction else whole.rstrip("0")).lstrip("0")
    return size, len(fraction) - int(power), len(digits)
