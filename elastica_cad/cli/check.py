"""`elastica check`: can this curve be bent from a flat strip?"""

import json
from pathlib import Path

import click

from elastica_cad.cli.options import bendable_curves, curve_options, support_options
from elastica_cad.formats import check_report
from elastica_cad.mechanics import Supports, check_equilibrium
from elastica_cad.mechanics.supports import EndName

__all__ = ["check"]


@click.command()
@curve_options
@support_options
@click.option("--json", "as_json", is_flag=True, help="Print the answer as JSON.")
@click.pass_context
def check(
    ctx: click.Context,
    curve: Path,
    unit: str | None,
    start: EndName,
    end: EndName,
    natural_curvature: float,
    as_json: bool,
) -> None:
    """Tell whether the curves in CURVE can be bent from a flat strip, and if not, where and why.

    A curve can be bent when one straight line meets it exactly in its inflections and is tangent to it in none
    of them. Exit code 1 when any curve fails.
    """
    supports = Supports(start, end)
    checks = [
        check_equilibrium(one, supports=supports, natural_curvature=natural_curvature)
        for one in bendable_curves(curve, unit)
    ]
    if as_json:
        click.echo(json.dumps([check_report(one) for one in checks], indent=1))
    else:
        for number, one in enumerate(checks, start=1):
            head = f"{curve.name}, curve {number} of {len(checks)}:\n" if len(checks) > 1 else ""
            click.echo(f"{head}{one}")
    if not all(one.realizable for one in checks):
        ctx.exit(1)
