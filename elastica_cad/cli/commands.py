"""The group of commands, and how errors become plain sentences and exit codes."""

from importlib.metadata import PackageNotFoundError, version
from typing import Any

import click

from elastica_cad.cli.bend_command import bend_command
from elastica_cad.cli.check_command import check
from elastica_cad.cli.coupon_command import coupon
from elastica_cad.cli.cures import TYPED, cure_by_trial
from elastica_cad.cli.model_command import model
from elastica_cad.cli.new_command import new
from elastica_cad.cli.options import refuse_huge_numbers, refuse_odd_numbers
from elastica_cad.cli.reshape_command import reshape
from elastica_cad.cli.sections_command import sections
from elastica_cad.cli.sheets_command import sheets
from elastica_cad.cli.strip_command import strip
from elastica_cad.cli.strip_options import NotMetError
from elastica_cad.errors import ElasticaError
from elastica_cad.mechanics.theorem1.verdict import NotRealizable

NOT_REALIZABLE, BAD_INPUT = 1, 2

TOLD: dict[type[ElasticaError], tuple[str, int]] = {
    NotRealizable: ("Not realizable", NOT_REALIZABLE),
    NotMetError: ("Not within these limits", NOT_REALIZABLE),
    ElasticaError: ("Error", BAD_INPUT),
}
"""How a refusal begins, and the exit code, the first that fits."""


def _version() -> str:
    try:
        return version("elastica-cad")
    except PackageNotFoundError:
        return "from a checkout"


def _said(problem: ElasticaError) -> str:
    """The refusal, and the cure that was found for it."""
    return _with_cure(str(problem), " ".join(getattr(problem, "__notes__", ())))


def _with_cure(said: str, cure: str) -> str:
    """Two sentences, or one."""
    return f"{said}{'' if said.endswith(('.', '?', '!', ')')) else '.'} {cure}" if cure else said


class _Sentences(click.Group):
    """Errors of ours end as one sentence and an exit code, and with a command that works."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        ctx.meta[TYPED] = tuple(args)
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except ElasticaError as problem:
            if not getattr(problem, "__notes__", None):
                problem.add_note(self._cure(ctx, str(problem)))
            begins, code = next((told for kind, told in TOLD.items() if isinstance(problem, kind)))
            click.echo(f"{begins}: {_said(problem)}", err=True)
            ctx.exit(code)
        except click.UsageError as problem:
            said = problem.format_message()
            raise click.UsageError(
                " ".join(filter(None, (said, self._cure(ctx, said)))), problem.ctx
            ) from problem

    def _cure(self, ctx: click.Context, said: str) -> str:
        return cure_by_trial(self, ctx.meta.get(TYPED, ()), said)


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
      elastica new pavilion                         a commented design file to start from
      elastica model pavilion.toml -o out           many strips: slots, base, nested sheets, cut list
      elastica sections pot.obj --radial 16         curves for strips along a mesh or a STEP body

    Curves come from DXF, SVG, CSV, JSON, text files of control points, and STEP with a CAD kernel installed.
    Lengths are mm. Exit code: 0 done, 1 not realizable (or too much strain with --strict), 2 bad input.
    """


def _gated(command: click.Command) -> click.Command:
    """The command behind the gate for numbers, which no option passes by."""
    run = command.callback

    def behind(*values: Any, **chosen: Any) -> Any:
        chosen_now = click.get_current_context().params
        refuse_odd_numbers(chosen_now)
        if command is not sections:  # which has sentences of its own
            refuse_huge_numbers(chosen_now)
        return None if run is None else run(*values, **chosen)

    command.callback = behind
    return command


for command in (new, check, strip, model, bend_command, reshape, sections, coupon, sheets):
    elastica.add_command(_gated(command))
