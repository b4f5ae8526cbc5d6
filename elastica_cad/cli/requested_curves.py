"""The CURVE argument of commands: curves of a file, with their names, supports and rest shape."""

import re
import sys
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar, get_args

import click

from elastica_cad._toml import parse_toml
from elastica_cad.cli.options import join_options
from elastica_cad.cli.voice import say_row, voice, warn
from elastica_cad.declared import kind_of
from elastica_cad.errors import InputError, quoted
from elastica_cad.files import read_drawing
from elastica_cad.formats.drawn_file import DrawnCurve, DrawnFile
from elastica_cad.formats.source_file import LARGEST_FILE
from elastica_cad.geometry.fairing import round_corners
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import EndName, NaturalCurvature
from elastica_cad.mechanics.theorem1 import require_bendable
from elastica_cad.report_rows import Row
from elastica_cad.strip.lettering import engravable

F = TypeVar("F", bound=Callable[..., Any])

CHOICE = "--curve 1 .. --curve {count}, --curve ID or --layer NAME"
"""Options, in messages, that select a curve in a file with several curves."""


def curve_argument(*, required: bool = True) -> Callable[[F], F]:
    """Return a decorator that adds the argument CURVE: a file, or - for standard input."""
    return click.argument(
        "curve",
        type=click.Path(path_type=Path, allow_dash=True),
        required=required,
        callback=lambda ctx, _, path: _standard_input(ctx) if str(path) == "-" else path,
    )


def _standard_input(ctx: click.Context) -> Path:
    """Return a temporary file with the contents of standard input, with a suffix that follows from the contents.

    Raises
    ------
    InputError
        Standard input is empty or too large.
    """
    if ctx.find_root().params.get("watch"):
        raise InputError("--watch needs a file; standard input cannot be watched. Name a file.")
    data = sys.stdin.buffer.read(LARGEST_FILE + 1)
    if not data.strip():
        raise InputError("Standard input is empty. Pipe a drawing into it (cat arch.svg | elastica check -).")
    if len(data) > LARGEST_FILE:
        raise InputError(
            "Standard input has more than {largest_file} MB, the limit. Leave out everything except the curves.",
            largest_file=LARGEST_FILE // 2**20,
        )
    folder = TemporaryDirectory(prefix="elastica-")
    ctx.call_on_close(folder.cleanup)
    path = Path(folder.name, f"stdin{_kind(data)}")
    path.write_bytes(data)
    return path


def _kind(data: bytes) -> str:
    """Return the suffix of the kind of file that begins with these bytes."""
    head = data[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head.startswith((b"<", b"\x1f\x8b")):
        return ".svg"
    if head.startswith((b"{", b"[")):
        return ".json"
    if head.startswith(b"ISO-10303-21"):
        return ".step"
    if head.startswith(b"AutoCAD Binary DXF") or re.match(rb"(999\s.*\s+)?0\s+SECTION", head):
        return ".dxf"
    return ".txt" if re.match(rb"\d+[ \t]+\d+[ \t]*\r?\n", head) else ".csv"


UNIT = click.Choice(["mm", "cm", "m", "in", "px", "pt"])
"""Units of the numbers in a file."""

unit_option = click.option(
    "--unit", type=UNIT,
    help="Unit of the numbers in the file, if the file names none or a wrong one.",
)  # fmt: skip

curve_options = join_options(curve_argument(), unit_option)
"""The CURVE argument and the unit of its file."""

number_option = click.option(
    "--curve", "number", metavar="N|ID", help="Curve of the file: its number from 1, or its id."
)

which_options = join_options(
    number_option, click.option("--layer", metavar="NAME", help="Only curves on this layer of the drawing.")
)
"""Options that select a curve of the file."""

split_option = click.option(
    "--split-corners", is_flag=True, help="Split curves at their corners into separate curves."
)
"""Option that splits curves at their corners."""


@dataclass(frozen=True, eq=False)
class RequestedCurve:
    """Requested curve of a command.

    Attributes
    ----------
    path : Path
        File with the curve.
    drawn : DrawnCurve
    whole : DrawnCurve
        Curve before splitting; it is `drawn` if the curve was not split.
    count : int
        Number of curves in the file.
    name : str
        Stem of the names of output files.
    which : tuple of str
        Command line arguments that select the curve, if several curves were requested.
    unit : str or None
        Unit of the file, if it was given.
    own : str
        Name that a person gave to the curve in a file with several curves, or "".
    alone : bool
        True if no other curve of the file has this name.
    """

    path: Path
    drawn: DrawnCurve
    whole: DrawnCurve
    count: int
    name: str
    which: tuple[str, ...] = ()
    unit: str | None = None
    own: str = ""
    alone: bool = False

    @property
    def label(self) -> str:
        """Default for the engraved text: the name of the curve with the number of its piece, or the stem of
        its files.
        """
        piece = f"-{self.drawn.piece}" if self.drawn.pieces > 1 else ""
        return engravable(f"{self.own}{piece}" if self.own else self.name)

    @property
    def curve(self) -> PlaneCurve:
        """The curve as drawn, with its corners.

        Raises
        ------
        InputError
            The numbers do not define a curve; the message names file and curve.
        """
        with self._named():
            return self.drawn.curve

    def bendable(self, smooth: float | None) -> PlaneCurve:
        """Return the curve as drawn. Refuse it if smoothing by `smooth` mm does not remove its corners.

        Raises
        ------
        InputError
            The curve is not bendable; the message names file and curve.
        """
        with self._named():
            drawn = self.drawn.curve
            require_bendable(round_corners(drawn, smooth)[0] if smooth else drawn)
            return drawn

    @contextmanager
    def _named(self) -> Iterator[None]:
        """Add the names of file and curve to errors."""
        try:
            yield
        except InputError as problem:
            if str(self.path) in str(problem):
                raise
            which = f", {self.drawn.called} of {self.count}" if self.count > 1 else ""
            problem.at(file=f"{self.path}{which}")
            raise


def requested_curves(
    path: Path,
    unit: str | None,
    number: str | None,
    layer: str | None,
    *,
    every: bool = False,
    split: bool = False,
    corners: bool = True,
    how: str = CHOICE,
) -> tuple[RequestedCurve, ...]:
    """Return the curve selected by number, id or layer.

    With `every`, several curves may be selected. With `split`, curves are divided at corners. Without
    `corners`, curves that meet at a corner are not joined, and joints are not reported. `how` names the
    options that select a single curve, for messages.

    Raises
    ------
    InputError
        No curve is selected, or several curves are selected although a single curve is required. The message
        names the file.
    """
    drawing = drawn_curves(path, unit, number, layer, how, corners=corners)
    several = every and len(drawing) > 1 and number is None
    drawn = drawing.chosen(number, layer) if every else (drawing.one(number, layer, how),)
    in_files = _names(drawn)
    in_drawing = _names(drawing.curves) if len(drawing) > 1 else {}
    return tuple(
        RequestedCurve(
            path,
            piece,
            whole,
            len(drawing),
            _file_stem(
                path,
                (in_files[whole.number][0] or str(whole.number)) if every else number,
                piece.piece if piece.pieces > 1 else None,
            ),
            ("--curve", str(piece.number)) if several else (),
            unit,
            *in_drawing.get(whole.number, ("", False)),
        )
        for whole in drawn
        for piece in (whole.split_at_corners() if split else (whole,))
    )


def drawn_curves(
    path: Path,
    unit: str | None,
    number: str | None,
    layer: str | None,
    how: str = CHOICE,
    *,
    corners: bool = True,
) -> DrawnFile:
    """Read a file, print notes about omitted items, and return all its curves.

    Raises
    ------
    InputError
        No curve matches number, id or layer; the message names the file.
    """
    drawing = read_drawing(path, unit=unit, corners=corners)
    for text in drawing.notes:
        warn(f"{path.name}: {text}")
    chosen = drawing.chosen(number, layer)
    if not chosen:
        drawing.one(number, layer, how)
    report = drawing.report(chosen)
    if report is not None:
        voice().read = report.as_dict()
        say_row(Row("Read", str(report)))
    return drawing


def _names(curves: Sequence[DrawnCurve]) -> dict[int, tuple[str, bool]]:
    """Return a mapping from the number of each curve to its name, and True if the name is unique.

    A name that several curves have is followed by the number. Curves without a name from a user have an empty name.
    """
    often = Counter(_word(curve.name).casefold() for curve in curves)
    names = {}
    for curve in curves:
        alone = often[_word(curve.name).casefold()] == 1
        named = re.match(r"_|[^\W\d]", curve.name) is not None
        called = (curve.name if alone else f"{curve.name}-{curve.number}") if named else ""
        names[curve.number] = called, named and alone
    return names


def _word(name: str) -> str:
    """Return the name with _ instead of characters that are not valid in file names."""
    return re.sub(r"[^-.A-Za-z0-9_]+", "_", engravable(name.strip()))


def _file_stem(path: Path, number: str | None, piece: int | None) -> str:
    """Return the stem of file names: the drawing's name, the curve's number or id, and the piece."""
    words = [] if number is None else [_word(number) or "1"]
    return "-".join([path.stem, *words, *([] if piece is None else [str(piece)])])


END_NAMES = get_args(EndName)


def read_curves_with_note(path: Path, *, unit: str | None = None) -> list[PlaneCurve]:
    """Read the curve of a file that has a single curve, and print a note if its size is doubtful."""
    (drawn,) = requested_curves(path, unit, None, None)
    return [drawn.bendable(None)]


def natural_curvature_of(value: Any) -> NaturalCurvature:
    """Return the value of the option as a number (1/mm) or a record."""
    if isinstance(value, float):
        return value
    from elastica_cad.design.records import Reader
    from elastica_cad.design.tables import Table

    kind, table = kind_of(NaturalCurvature), Table({"natural_curvature": value}, "", {})
    rest: NaturalCurvature = Reader(read_curves=read_curves_with_note).value(kind, table, "natural_curvature")
    return rest


class Blank(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Parameter type of `natural_curvature`: a number (1/mm), a table, or a drawing of the unloaded strip."""

    name = "blank"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the value in a form that the key `natural_curvature` of a design file accepts."""
        try:
            return float(value)
        except ValueError:
            pass
        if "=" in value:
            try:
                return parse_toml(f"blank = {{{value}}}")["blank"]
            except tomllib.TOMLDecodeError as error:
                raise InputError(
                    "--natural-curvature: {line} cannot be read. Write keys and values, such as stations = "
                    "[0, 300], curvatures = [0, 0.01].",
                    line=quoted(value),
                ) from error
        if not Path(value).is_file():
            self.fail(
                f"{value!r} is not a number or file. Use 1/mm, 'stations = [0, 300], curvatures = [0, 0.01]', "
                "or a drawing of the pre-bent strip.",
                param,
                ctx,
            )
        return {"curve": value}


support_options = join_options(
    *(
        click.option(f"--{end}", type=click.Choice(END_NAMES), default="clamped", show_default=True,
                     help=f"Support of the {end} of the curve.")
        for end in ("start", "end")
    ),
    click.option("--natural-curvature", type=Blank(), default=0.0, metavar="1/MM|KEYS|FILE",
                 help="Curvature of the strip before bending (0: flat); variable as 'stations = [0, 300], "
                      "curvatures = [0, 0.01]', or a drawing of the pre-bent strip."),
)  # fmt: skip
"""Options for the supports of the ends and for a pre-curved rest shape."""
