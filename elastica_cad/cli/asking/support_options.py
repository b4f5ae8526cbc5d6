"""Options for what holds the ends of a strip, and for the shape that it has before it is bent."""

import tomllib
from pathlib import Path
from typing import Any, get_args

import click

from elastica_cad._toml import parse_toml
from elastica_cad.cli.asking.asked_curves import asked_curves
from elastica_cad.cli.asking.options import join_options
from elastica_cad.declared import kind_of
from elastica_cad.errors import InputError, quoted
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import EndName

END_NAMES = get_args(EndName)


def read_curves_told(path: Path, *, unit: str | None = None) -> list[PlaneCurve]:
    """The one curve of a file, told where its size is in doubt."""
    (drawn,) = asked_curves(path, unit, None, None)
    return [drawn.bendable(None)]


def natural_curvature_of(value: Any) -> NaturalCurvature:
    """Return the value of the option as a number (1/mm) or a record."""
    if isinstance(value, float):
        return value
    from elastica_cad.formats.design_files.records import Reader  # imports all records
    from elastica_cad.formats.design_files.tables import Table

    kind, table = kind_of(NaturalCurvature), Table({"natural_curvature": value}, "", {})
    found: NaturalCurvature = Reader(read_curves=read_curves_told).value(kind, table, "natural_curvature")
    return found


class Blank(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """A parameter type for `natural_curvature`: a number (1/mm), a table, or a drawing of the unloaded strip."""

    name = "blank"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the value as the key `natural_curvature` of a design file takes it."""
        try:
            return float(value)
        except ValueError:
            pass
        if "=" in value:
            try:
                return parse_toml(f"blank = {{{value}}}")["blank"]
            except tomllib.TOMLDecodeError as error:
                raise InputError(
                    "--natural-curvature: {line} cannot be read: write keys and values, such as "
                    "stations = [0, 300], curvatures = [0, 0.01]",
                    line=quoted(value),
                ) from error
        if not Path(value).is_file():
            self.fail(
                f"{value!r} is no number and no file: give 1/mm, 'stations = [0, 300], curvatures = [0, 0.01]', or "
                "a drawing of the blank",
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
                 help="Curvature of the strip before bending (0: flat); along it as 'stations = [0, 300], "
                      "curvatures = [0, 0.01]', or a drawing of the bent blank."),
)  # fmt: skip
"""What the ends are held by, and a pre-curved rest shape."""
