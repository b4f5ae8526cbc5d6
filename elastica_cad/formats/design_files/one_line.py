"""Tables of a design file that stand in one line: of an option, or of a property in FreeCAD."""

import tomllib
from collections.abc import Callable, Sequence
from typing import TypeVar

from elastica_cad.errors import InputError, quoted
from elastica_cad.formats.design_files.tables import Table

T = TypeVar("T")


def parse_line(
    line: str, where: str, reader: Callable[[Table], T], *, example: str = "at = 40, side = 'lower'"
) -> T:
    """What one line tells, written as the inside of a table of a design file: `at = 40, width = 1.2`.

    Parameters
    ----------
    example : str
        What a line that cannot be read is told to look like.

    Raises
    ------
    InputError
        A line that is no such table, or what `reader` refuses; it names `where` the line stands.

    Examples
    --------
    >>> from elastica_cad.formats.design_files.strip_records import read_slot
    >>> parse_line("at = 40, width = 1.2, side = 'lower'", "--slot", read_slot).side
    'lower'
    """
    inside = line.strip()
    try:
        data = tomllib.loads(f"line = {inside}" if inside.startswith("{") else f"line = {{{inside}}}")
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(
            "{where_}: {line} cannot be read: write keys and values, such as {example}",
            where_=where,
            line=quoted(line),
            example=example,
        ) from error
    table = Table(data["line"], where, {})
    with table.naming():
        return reader(table)


def parse_lines(
    lines: Sequence[str],
    where: str,
    reader: Callable[[Table], T],
    *,
    example: str = "at = 40, side = 'lower'",
) -> tuple[T, ...]:
    """What every line tells that is not empty."""
    return tuple(parse_line(line, where, reader, example=example) for line in lines if line.strip())
