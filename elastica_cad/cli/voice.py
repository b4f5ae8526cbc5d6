"""Output of commands (messages, warnings, answers, JSON), and repetition when a file changes."""

import json
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePath
from threading import Event, Thread
from types import MappingProxyType
from typing import Any

import click

from elastica_cad._text import printable
from elastica_cad._values import plain_data
from elastica_cad.defaults import BAD_INPUT, NOT_REALIZABLE
from elastica_cad.errors import ElasticaError, FaultError, InputError, NotConvergedError, StrainError
from elastica_cad.formats.source_file import FileMark, mark_file, note_reads
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.report_rows import LABEL_WIDTH, Row, printed_row


@dataclass
class Voice:
    """Output settings of the running command, and its JSON record.

    Attributes
    ----------
    command : str
        Name of the command; the schema is "elastica-COMMAND/1".
    step : str
        Current step of the command.
    as_json, quiet, verbose : bool
        Print one JSON record, only problems, or all steps and notes.
    record : dict, or list of dict
        Answer for `--json`; a list has one record for each curve.
    notes, files : list of str
        Printed warnings, and written files.
    read : dict
        Report on the file that was read.
    since : float
        Start of the command, s on the clock of `time.perf_counter`.
    """

    command: str
    as_json: bool = False
    quiet: bool = False
    verbose: bool = False
    record: dict[str, Any] | list[dict[str, Any]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    read: dict[str, Any] = field(default_factory=dict)
    since: float = field(default_factory=time.perf_counter)
    step: str = "working"

    @property
    def schema(self) -> str:
        """Name of the JSON record's schema."""
        return f"elastica-{self.command}/1"

    def begin(self) -> None:
        """Forget the output of an earlier run of the command."""
        self.record, self.notes, self.files, self.read = {}, [], [], {}
        self.since, self.step = time.perf_counter(), "working"

    def conclude(self) -> None:
        """Print the JSON record if `--json` is set."""
        _clear_step()
        if not self.as_json:
            return
        read = {"read": self.read} if self.read else {}
        if isinstance(self.record, list):
            _print_json([{"schema": self.schema, **read, **record} for record in self.record])
        else:
            written = {"notes": self.notes, "files": self.files}
            _print_json({"schema": self.schema, **read, **self.record, **written})

    def refuse(
        self, text: str, problem: ElasticaError, code: int, suggest: Callable[[], list[dict[str, Any]]]
    ) -> None:
        """Print the error, then suggested changes. Ctrl-C ends the search for changes."""
        _clear_step()
        cures: list[dict[str, Any]] = []
        say_error(text, problem.details if self.verbose else ())
        with suppress(KeyboardInterrupt), progress_shown():
            cures = [] if self.quiet else suggest()
        for cure in cures:
            _print_row(Row("Change", cure["text"]), err=True)
        if self.as_json:
            record = problem.refusal.record | {"message": text, "details": list(problem.details)}
            _print_json(
                {
                    "schema": "elastica-error/2",
                    "command": self.command,
                    "exit_code": code,
                    "error": record,
                    "cures": cures,
                }
            )


def say_error(text: str, details: Iterable[str] = ()) -> None:
    """Print the row of an error and its details to stderr."""
    _print_row(Row("Error", text, tuple(details), "error"), err=True)


def exit_code(problem: ElasticaError) -> int:
    """Return the exit code of a command that ends with this error."""
    # errors of a valid request for which no strip can be made
    no_strip = NotRealizable | StrainError | FaultError | NotConvergedError
    return NOT_REALIZABLE if isinstance(problem, no_strip) else BAD_INPUT


def voice() -> Voice:
    """Return the output settings of the running command."""
    ctx = click.get_current_context()
    current: Voice = ctx.meta.setdefault("elastica.voice", Voice(ctx.info_name or "elastica"))
    return current


def echo(text: str, *, nl: bool = True, err: bool = False) -> None:
    """Write a line. Control codes are escaped, because text from a file could control a terminal."""
    click.echo(printable(text), nl=nl, err=err)


def say(*lines: str) -> None:
    """Print lines of the answer, unless output is JSON or quiet."""
    for line in () if voice().as_json or voice().quiet else lines:
        _clear_step()
        echo(line)


def warn(text: str, *, in_notes: bool = True) -> None:
    """Print a warning to stderr. With `in_notes`, it is added to the notes of the JSON record."""
    if in_notes:
        voice().notes.append(text)
    if not voice().quiet:
        _clear_step()
        echo(text, err=True)


def say_rows(*rows: Row, is_answer: bool = False) -> None:
    """Print rows of the report, and with -v their details.

    A row about a problem is a warning: it is printed to stderr and added to the notes of the JSON record.
    With `is_answer`, no row is a warning.
    """
    speaker = voice()
    for row in rows:
        warns = row.stops and not is_answer
        if warns:
            speaker.notes.append(row.text)
        if not speaker.quiet and (warns or not speaker.as_json):
            _clear_step()
            _print_row(row if speaker.verbose else replace(row, details=()), err=warns)


def _print_row(row: Row, *, err: bool) -> None:
    line = printed_row(row)
    label, text = printable(line[:LABEL_WIDTH]), printable(line[LABEL_WIDTH:])
    click.echo((click.style(label, fg="red") if row.stops else label) + text, err=err)
    for detail in row.details:
        echo(f"{'':<{LABEL_WIDTH}} {detail}", err=err)


def wrote(paths: Iterable[PurePath], contents: Mapping[str, str] = MappingProxyType({})) -> None:
    """Report the written files in a row. `contents` has descriptions by file name, or by the end of the name."""
    written = list(paths)
    voice().files += map(str, written)
    names = [
        str(path) if k == 0 or path.parent != written[0].parent else path.name
        for k, path in enumerate(written)
    ]
    texts = [contents.get(path.name) or contents.get(path.suffix) for path in written]
    files = [f"{name} ({text})" if text else name for name, text in zip(names, texts, strict=True)]
    if files:
        say_rows(Row("Files", ", ".join(files)))


def cut_text(kerf: float) -> str:
    """Return the description of a file to cut, from the compensated kerf, mm."""
    return f"cut, {kerf:g} mm kerf included" if kerf else "cut"


def answer(record: Mapping[str, Any] | list[dict[str, Any]]) -> None:
    """Set the record that `--json` prints. Records, arrays and paths become plain JSON."""
    if voice().as_json:
        voice().record = plain_data(record)


def say_step(text: str, number: int = 0, count: int = 0) -> None:
    """Report the current step on stderr, and with -v in a line of its own."""
    speaker = voice()
    speaker.step = counted = f"{text} ({number} of {count})" if count > 1 else text
    if speaker.verbose:
        echo(f"{time.perf_counter() - speaker.since:7.2f} s  {counted}", err=True)
    elif not (speaker.quiet or speaker.as_json) and sys.stderr.isatty():
        _clear_step()
        echo(f"{counted} ...", nl=False, err=True)


PATIENCE_S = 5.0
"""Time, s, before the first report of progress, and between later reports."""


@contextmanager
def progress_shown() -> Iterator[None]:
    """Report on stderr, every few seconds, the current step and the running time."""
    speaker, screen, ended = voice(), sys.__stderr__, Event()

    def show() -> None:
        while screen is not None and not ended.wait(PATIENCE_S):
            text = printable(
                f"{speaker.step} ... {time.perf_counter() - speaker.since:.0f} s, stop with Ctrl-C"
            )
            with suppress(OSError, ValueError):  # stderr may be closed
                screen.write(f"\r\x1b[2K{text}" if screen.isatty() else f"{text}\n")
                screen.flush()

    if not (speaker.quiet or speaker.as_json):
        Thread(target=show, daemon=True).start()
    try:
        yield
    finally:
        ended.set()


def _clear_step() -> None:
    if sys.stderr.isatty():
        click.echo("\r\x1b[2K", nl=False, err=True)


def _print_json(record: Any) -> None:
    echo(json.dumps(record, indent=1, ensure_ascii=False))


def remake_on_change(make: Callable[[], None], tell: Callable[[str], None]) -> None:
    """Run `make`, and again after every change of a file that it read, until the user presses Ctrl-C.

    Changes while `make` runs count too.

    Raises
    ------
    InputError
        `make` did not read a file.
    """
    try:
        while True:
            with note_reads() as read:
                make()
            if not read:
                raise InputError("--watch found no file to watch because none was read. Leave out --watch.")
            tell(f"watching {', '.join(path.name for path in read)}; save to run again, stop with Ctrl-C")
            _wait_for_change(read)
    except KeyboardInterrupt:
        tell("stopped watching")


def _wait_for_change(read: dict[Path, FileMark]) -> None:
    """Wait until a file has changed since it was read, and no file changes any more."""
    before, still = read, 0
    while True:
        time.sleep(0.2)
        now = {path: mark_file(path) for path in read}
        # number of looks without a change
        still = still + 1 if now == before else 0
        gone = any(was and not mark for mark, was in zip(now.values(), read.values(), strict=True))
        # a file may be missing for a moment, because programs replace files when they save
        if now != read and still >= (5 if gone else 1):
            return
        before = now
