"""Options for what holds the ends of a strip, and for the shape that it has before it is bent."""

from pathlib import Path
from typing import Any, get_args

import click

from elastica_cad.cli.asking.asked_curves import asked_curves
from elastica_cad.cli.asking.options import join_options
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, RestCurvature
from elastica_cad.mechanics.loads.supports import EndName

END_NAMES = get_args(EndName)


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
            from elastica_cad.formats.design_files.one_line import parse_line
            from elastica_cad.formats.design_files.rod_records import BLANK_LINE, read_rest_curvature

            return parse_line(value, "--natural-curvature", read_rest_curvature, example=BLANK_LINE)
        if not Path(value).is_file():
            self.fail(
                f"{value!r} is no number and no file: give 1/mm, 'stations = [0, 300], curvatures = [0, 0.01]', or "
                "a drawing of the blank",
                param,
                ctx,
            )
        (blank,) = asked_curves(Path(value), None, None, None)
        return RestCurvature.of(blank.bendable(None))


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
