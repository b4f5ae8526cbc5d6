"""Arguments and options that several commands share."""

import re
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

import click
import numpy as np

from elastica_cad.cli.running.lengths import LENGTH
from elastica_cad.cli.running.voice import warn
from elastica_cad.errors import InputError
from elastica_cad.files import read_drawing
from elastica_cad.formats.curve_files.drawn_file import DrawnCurve, DrawnFile
from elastica_cad.formats.curve_files.number_gate import LARGEST_NUMBER
from elastica_cad.formats.design_files.strip_records import parse_line, read_rest_curvature
from elastica_cad.formats.file_access.source_file import LARGEST_FILE
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, RestCurvature
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.theorem1.equilibrium_check import require_bendable

F = TypeVar("F", bound=Callable[..., Any])

CHOICE = "--curve 1 .. --curve {count}, --curve ID or --layer NAME"

END_NAMES = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]


def join_options(*options: Callable[[Any], Any]) -> Callable[[F], F]:
    """Several options as one decorator; help lists them in this order."""

    def add(function: F) -> F:
        for option in reversed(options):
            function = option(function)
        return function

    return add


def curve_argument(*, required: bool = True) -> Callable[[F], F]:
    """The CURVE argument: a file, or - for standard input."""
    return click.argument(
        "curve",
        type=click.Path(path_type=Path, allow_dash=True),
        required=required,
        callback=lambda ctx, _, path: _standard_input(ctx) if str(path) == "-" else path,
    )


def _standard_input(ctx: click.Context) -> Path:
    """What comes through standard input, in a file while the command runs; what it is, its contents tell.

    Raises
    ------
    InputError
        Nothing, or more than is read.
    """
    if ctx.params.get("watch"):
        raise InputError("standard input does not change: give --watch a file")
    data = sys.stdin.buffer.read(LARGEST_FILE + 1)
    if not data.strip():
        raise InputError("standard input is empty: pipe a drawing into it (cat arch.svg | elastica check -)")
    if len(data) > LARGEST_FILE:
        raise InputError(
            f"standard input has more than {LARGEST_FILE // 2**20} MB: leave out what is no curve"
        )
    folder = TemporaryDirectory(prefix="elastica-")
    ctx.call_on_close(folder.cleanup)
    path = Path(folder.name, f"stdin{_kind(data)}")
    path.write_bytes(data)
    return path


def _kind(data: bytes) -> str:
    """The suffix of files that begin like this."""
    head = data[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head.startswith(b"<"):
        return ".svg"
    if head.startswith((b"{", b"[")):
        return ".json"
    if head.startswith(b"ISO-10303-21"):
        return ".step"
    if head.startswith(b"AutoCAD Binary DXF") or re.match(rb"(999\s.*\s+)?0\s+SECTION", head):
        return ".dxf"
    return ".txt" if re.match(rb"\d+[ \t]+\d+[ \t]*\r?\n", head) else ".csv"


class _Blank(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """A curvature, a table of curvatures along the strip, or a drawing of the strip before it is bent."""

    name = "blank"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> NaturalCurvature:
        """A number in 1/mm, or a `RestCurvature`."""
        try:
            return float(value)
        except ValueError:
            pass
        if "=" in value:
            return parse_line(value, "--natural-curvature", read_rest_curvature)
        if not Path(value).is_file():
            self.fail(
                f"{value!r} is no number and no file: give 1/mm, 'stations = [0, 300], curvatures = [0, 0.01]', or "
                "a drawing of the blank",
                param,
                ctx,
            )
        return RestCurvature.of(pick_curve(Path(value), None, None))


unit_option = click.option(
    "--unit", type=click.Choice(["mm", "cm", "m", "in", "px"]),
    help="Unit of the file's numbers, where the file does not say or says it wrongly.",
)  # fmt: skip

curve_options = join_options(curve_argument(), unit_option)
"""The CURVE argument and how to read it."""

holding_option = click.option(
    "--holding", type=LENGTH, metavar="MM",
    help="Leave bridges of this width in the outer cuts, which hold the parts in the sheet.",
)  # fmt: skip
"""Bridges that hold parts in the sheet."""

support_options = join_options(
    *(
        click.option(f"--{end}", type=click.Choice(END_NAMES), default="clamped", show_default=True,
                     help=f"Support of the {end} of the curve.")
        for end in ("start", "end")
    ),
    click.option("--natural-curvature", type=_Blank(), default=0.0, metavar="1/MM|KEYS|FILE",
                 help="Curvature of the strip before bending (0: flat); along it as 'stations = [0, 300], "
                      "curvatures = [0, 0.01]', or a drawing of the bent blank."),
)  # fmt: skip
"""What the ends are held by, and a pre-curved rest shape."""

smooth_option = click.option(
    "--smooth", type=LENGTH, metavar="MM",
    help="Make the curve fair (curvature without jumps) within this distance; 0: exactly as drawn  [default: "
    "0.1 or 5e-4 of the length for pen curves whose curvature jumps, 0 for all others]",
)  # fmt: skip
"""How far a curve may be moved to become fair."""

split_option = click.option(
    "--split-corners", is_flag=True, help="Cut curves at their corners; every piece is a curve of its own."
)
"""Curves in pieces between corners."""

which_options = join_options(
    click.option("--curve", "number", metavar="N|ID",
                 help="Which curve of the file: its number from 1, or its id."),
    click.option("--layer", metavar="NAME", help="Only curves on this layer of the drawing."),
)  # fmt: skip
"""Which curve of the file."""

output_options = join_options(
    click.option("--force", is_flag=True, help="Overwrite files that exist."),
    click.option("-o", "--output", type=click.Path(path_type=Path), default=Path(), help="Folder for files."),
)
"""Where files are written, and over what."""


def sheet_options(*, required: bool, use: str = "Material") -> Callable[[F], F]:
    """The material, by name or from a file, and another thickness of it."""

    return join_options(
        click.option("--sheet", required=required, metavar="NAME|FILE",
                     help=f"{use}: a name of `elastica sheets`, or a file of yours, my.toml or my.toml:NAME."),
        click.option("--thickness", type=LENGTH, metavar="MM",
                     help="Thickness, where it is not that of the sheet named."),
    )  # fmt: skip


def asked_sheet(chosen: Mapping[str, Any]) -> Sheet:
    """The sheet that `sheet_options` name.

    Raises
    ------
    InputError
        No such sheet or file, or a thickness that no sheet has.
    """
    sheet = Sheet.named(chosen["sheet"])
    return sheet if chosen["thickness"] is None else sheet.with_thickness(chosen["thickness"])


def file_stem(path: Path, number: str | None = None, piece: int | None = None) -> str:
    """What files made from a curve are called: the drawing's name, the curve's number or id, and the piece."""
    words = [] if number is None else [re.sub(r"[^-.A-Za-z0-9_]+", "_", number.strip()) or "1"]
    return "-".join([path.stem, *words, *([] if piece is None else [str(piece)])])


def drawn_curves(
    path: Path, unit: str | None, number: str | None = None, layer: str | None = None
) -> DrawnFile:
    """What a file draws, told where it leaves something out; at least one curve is as chosen.

    Raises
    ------
    InputError
        No such curve; the file is named.
    """
    drawing = read_drawing(path, unit=unit)
    if drawing.left_out:
        warn(f"{path.name}: {drawing.left_out}")
    if not drawing.chosen(number, layer):
        drawing.one(number, layer, CHOICE)
    return drawing


def bendable_curve(path: Path, drawn: DrawnCurve, count: int, *, may_change: bool = False) -> PlaneCurve:
    """A curve of a file that is open and without corners; a complaint names the file and the curve.

    With `may_change` any curve will do: the strip leaves it where it must.
    """
    try:
        curve = drawn.curve
        if not may_change:
            require_bendable(curve)
    except InputError as problem:
        which = f", {drawn.called} of {count}" if count > 1 else ""
        message = str(problem)
        raise InputError(message if str(path) in message else f"{path}{which}: {message}") from problem
    return curve


def pick_curve(
    path: Path,
    number: str | None,
    unit: str | None,
    layer: str | None = None,
    *,
    may_change: bool = False,
) -> PlaneCurve:
    """The one curve of a file, or the one asked for by its number from 1, its id or its layer."""
    drawing = drawn_curves(path, unit, number, layer)
    one = drawing.one(number, layer, CHOICE)
    return bendable_curve(path, one, len(drawing), may_change=may_change)


def refuse_odd_numbers(chosen: Mapping[str, Any]) -> None:
    """Refuse nan and inf among the options of the running command: Python reads them as numbers."""
    for option in click.get_current_context().command.params:
        if not all(np.isfinite(number) for number in _numbers(chosen.get(str(option.name)))):
            raise InputError(f"{option.opts[0]} is given as nan or infinite: give finite numbers")


def refuse_huge_numbers(chosen: Mapping[str, Any]) -> None:
    """Refuse what no drawing holds, such as 1e200, before anything is computed with it."""
    for option in click.get_current_context().command.params:
        for number in _numbers(chosen.get(str(option.name))):
            if abs(number) > LARGEST_NUMBER:
                raise InputError(
                    f"{option.opts[0]} is {number:.3g}: give a number of at most {LARGEST_NUMBER:g}"
                )


def _numbers(value: Any) -> Iterator[float]:
    """The numbers in nested tuples; whole ones too large for a float as infinite."""
    if isinstance(value, tuple | list):
        for one in value:
            yield from _numbers(one)
    elif isinstance(value, float | int) and not isinstance(value, bool):
        yield float(value) if isinstance(value, float) or abs(value) < 10**300 else 1e300
