"""The argument CURVE of commands: curves of a file, with their names, supports and rest shape."""

import re
import sys
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, get_args

import click

from elastica_cad._text import distinct, file_word, plain_name
from elastica_cad._toml import parse_toml
from elastica_cad.cli.options import F, join_options
from elastica_cad.cli.voice import say_rows, voice, warn
from elastica_cad.declared import kind_of
from elastica_cad.errors import InputError, quoted
from elastica_cad.files import CURVE_FORMATS, read_drawing
from elastica_cad.formats.drawn_file import DrawnCurve, DrawnFile
from elastica_cad.formats.source_file import LARGEST_FILE
from elastica_cad.geometry.fairing import round_corners
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import EndName, NaturalCurvature
from elastica_cad.mechanics.theorem1 import require_bendable
from elastica_cad.report_rows import Row

CHOICE = "--curve 1 .. --curve {count}, --curve ID or --layer NAME"
"""Options that select a curve of a file, as messages list them."""


def curve_argument(*, required: bool = True) -> Callable[[F], F]:
    """Return a decorator that adds the argument CURVE: a file, or - for standard input."""
    return click.argument(
        "curve",
        type=click.Path(path_type=Path, allow_dash=True),
        required=required,
        callback=lambda ctx, _, path: _standard_input(ctx) if str(path) == "-" else path,
    )


def _standard_input(ctx: click.Context) -> Path:
    """Return a temporary file with the data of standard input, and a suffix for its format."""
    if ctx.find_root().params.get("watch"):
        raise InputError("--watch needs a file; standard input cannot be watched. Name a file.")
    data = sys.stdin.buffer.read(LARGEST_FILE + 1)
    if not data.strip():
        raise InputError("Standard input is empty. Pipe a drawing into it (cat arch.svg | elastica check -).")
    if len(data) > LARGEST_FILE:
        raise InputError(
            "Standard input has more than {largest_file} MB, the limit. Leave out everything except the curves.",
            largest_file=LARGEST_FILE // 10**6,
        )
    folder = TemporaryDirectory(prefix="elastica-")
    ctx.call_on_close(folder.cleanup)
    head = data[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    suffix = next((kind.suffixes[0] for kind in CURVE_FORMATS if re.match(kind.begins, head)), ".csv")
    path = Path(folder.name, f"stdin{suffix}")
    path.write_bytes(data)
    return path


UNIT = click.Choice(["mm", "cm", "m", "in", "px", "pt"])

unit_option = click.option(
    "--unit", type=UNIT,
    help="Unit of the numbers in the file, if the file names none or a wrong one.",
)  # fmt: skip

curve_options = join_options(curve_argument(), unit_option)

number_option = click.option(
    "--curve", "number", metavar="N|ID", help="Curve of the file: its number from 1, or its id."
)

which_options = join_options(
    number_option, click.option("--layer", metavar="NAME", help="Only curves on this layer of the drawing.")
)

split_option = click.option(
    "--split-corners", is_flag=True, help="Split curves at their corners into separate curves."
)


@dataclass(frozen=True, eq=False)
class RequestedCurve:
    """Requested curve of a command.

    Attributes
    ----------
    path : Path
        File with the curve.
    drawn : DrawnCurve
        The curve, or a piece of a split curve.
    count : int
        Number of curves in the file.
    name : str
        Stem of the names of output files.
    label : str
        Default label of the strip: the name of the curve with the number of the piece, or the name of the file.
    which : tuple of str
        Command line arguments that select the curve among several requested curves.
    unit : str or None
        Unit of the file, if it was given.
    own : str
        Name of the curve in a file with several curves; "" if the curve has none.
    alone : bool
        True if no other curve of the file has this name.
    """

    path: Path
    drawn: DrawnCurve
    count: int
    name: str
    label: str
    which: tuple[str, ...] = ()
    unit: str | None = None
    own: str = ""
    alone: bool = False

    @property
    def curve(self) -> PlaneCurve:
        """The curve as drawn, with its corners."""
        with self._with_place_in_errors():
            return self.drawn.curve

    def bendable(self, smooth: float | None) -> PlaneCurve:
        """Return the curve as drawn.

        Raise InputError if smoothing by `smooth` mm does not remove its corners.
        """
        with self._with_place_in_errors():
            curve = self.drawn.curve
            require_bendable(round_corners(curve, smooth)[0] if smooth else curve)
            return curve

    @contextmanager
    def _with_place_in_errors(self) -> Iterator[None]:
        """Add the file, and the curve if it has several, to errors that do not name the file."""
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
    split: Callable[[PlaneCurve], Sequence[PlaneCurve]] | None = None,
    corners: bool = True,
    how: str = CHOICE,
) -> tuple[RequestedCurve, ...]:
    """Return the curve selected by number, id or layer.

    With `every`, several curves may be selected. `split` is a function that divides each curve. Without
    `corners`, curves that meet at a corner are not joined. `how` names, in messages, the options that select
    a single curve.
    """
    drawing, chosen = drawn_curves(path, unit, number, layer, how, corners=corners)
    several = every and len(drawing) > 1 and number is None
    selected = chosen if every else (drawing.one(number, layer, how),)
    # names are unique among the selected curves for output files, and in the drawing for saved designs
    in_files = _names_by_number(selected)
    in_drawing = _names_by_number(drawing.curves) if len(drawing) > 1 else {}
    pieces = [piece for whole in selected for piece in (whole.split(split) if split else (whole,))]
    words = []
    for piece in pieces:
        which = (in_files[piece.number][0] or str(piece.number)) if every else number
        words.append([path.stem, *([which] if which else [])])
    stems = distinct(
        "-".join(map(file_word, parts)) + piece.suffix for parts, piece in zip(words, pieces, strict=True)
    )
    curves = []
    for piece, parts, stem in zip(pieces, words, stems, strict=True):
        own, alone = in_drawing.get(piece.number, ("", False))
        name = plain_name((own or "-".join(parts)) + piece.suffix)
        # `StripSpec.label` declares 200 as the largest number of characters
        label = "".join(sign if sign.isprintable() else "_" for sign in name)[:200]
        which_options = ("--curve", str(piece.number)) if several else ()
        curves.append(RequestedCurve(path, piece, len(drawing), stem, label, which_options, unit, own, alone))
    return tuple(curves)


def drawn_curves(
    path: Path,
    unit: str | None,
    number: str | None,
    layer: str | None,
    how: str = CHOICE,
    *,
    corners: bool = True,
) -> tuple[DrawnFile, Sequence[DrawnCurve]]:
    """Read a file, print notes about omitted items, and return all its curves and the selected ones."""
    drawing = read_drawing(path, unit=unit, corners=corners)
    for text in drawing.notes:
        warn(f"{path.name}: {text}")
    chosen = drawing.chosen(number, layer)
    if not chosen:
        drawing.one(number, layer, how)
    report = drawing.report(chosen)
    if report is not None:
        voice().read = report.as_dict()
        say_rows(Row("Read", str(report)))
    return drawing, chosen


def _names_by_number(curves: Sequence[DrawnCurve]) -> dict[int, tuple[str, bool]]:
    """Return, by the number of each curve, its name, and True if no other curve has this name.

    A name of several curves is followed by the number. A curve that the user did not name has the name "".
    """
    # the name of an unnamed DXF shape, such as SPLINE 2F, ends with its handle
    shown = [
        curve.chosen_name or ("" if curve.id and curve.name.endswith(f" {curve.id}") else curve.name)
        for curve in curves
    ]
    counts = Counter(file_word(name).casefold() for name in shown)
    names = {}
    for curve, name in zip(curves, shown, strict=True):
        alone = counts[file_word(name).casefold()] == 1
        has_name = re.match(r"_|[^\W\d]", name) is not None
        text = (name if alone else f"{name}-{curve.number}") if has_name else ""
        names[curve.number] = text, has_name and alone
    return names


END_NAMES = get_args(EndName)


def read_curves_with_note(path: Path, *, unit: str | None = None) -> list[PlaneCurve]:
    """Return a list with the only curve of a file. Print a note if the size of the curve is doubtful."""
    (curve,) = requested_curves(path, unit, None, None)
    return [curve.bendable(None)]


def natural_curvature_of(value: Any) -> NaturalCurvature:
    """Return the natural curvature that an option gives: a number (1/mm) or a record."""
    if isinstance(value, float):
        return value
    from elastica_cad.design.records import Reader
    from elastica_cad.design.tables import Table

    kind, table = kind_of(NaturalCurvature), Table({"natural_curvature": value}, "", {})
    rest: NaturalCurvature = Reader(read_curves=read_curves_with_note).value(kind, table, "natural_curvature")
    return rest


class Blank(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Type of the option for natural curvature: a number (1/mm), a table, or a drawing of the unloaded strip."""

    name = "blank"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the value as the key `natural_curvature` of a design file."""
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
