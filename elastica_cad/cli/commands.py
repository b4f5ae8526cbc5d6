"""The group of commands, and how errors become plain sentences and exit codes."""

from importlib.metadata import PackageNotFoundError, version
from typing import Any

import click

from elastica_cad.cli.bend import bend_command
from elastica_cad.cli.check import check
from elastica_cad.cli.coupon import coupon
from elastica_cad.cli.model import model
from elastica_cad.cli.reshape import reshape
from elastica_cad.cli.sections import sections
from elastica_cad.cli.sheets import sheets
from elastica_cad.cli.strip import strip
from elastica_cad.cli.wish import NotMetError
from elastica_cad.errors import ElasticaError
from elastica_cad.mechanics import NotRealizable

__all__ = ["elastica"]

NOT_REALIZABLE, BAD_INPUT = 1, 2


def _version() -> str:
    try:
        return version("elastica-cad")
    except PackageNotFoundError:
        return "from a checkout"


class _Sentences(click.Group):
    """Errors of ours end as one sentence and an exit code, never as a traceback."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except NotRealizable as problem:
            click.echo(f"Not realizable: {problem}", err=True)
            ctx.exit(NOT_REALIZABLE)
        except NotMetError as problem:
            click.echo(f"Not within these limits: {problem}", err=True)
            ctx.exit(NOT_REALIZABLE)
        except ElasticaError as problem:
            click.echo(f"Error: {problem}", err=True)
            ctx.exit(BAD_INPUT)


@click.group(
    cls=_Sentences, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100}
)
@click.version_option(_version(), prog_name="elastica")
def elastica() -> None:
    """Draw a curve, cut a flat strip, bend it: it takes exactly that curve.

    \b
    A first session:
      elastica check arch.dxf                       can it be bent at all, and if not, why?
      elastica sheets                               materials we know
      elastica strip arch.dxf --sheet birch-plywood-0.8 --max-width 40 -o out
      elastica model pavilion.toml -o out           many strips: slots, base, nested sheets, cut list
      elastica sections pot.obj --radial 16         curves for strips along a mesh or a STEP body

    Curves come from DXF, SVG, CSV, JSON, text files of control points, and STEP with a CAD kernel installed.
    Lengths are mm. Exit code: 0 done, 1 not realizable (or too much strain with --strict), 2 bad input.
    """


for command in (check, strip, model, bend_command, reshape, sections, coupon, sheets):
    elastica.add_command(command)
