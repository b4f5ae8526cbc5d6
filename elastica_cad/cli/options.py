"""Arguments and options that several commands share."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import click
import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.files import read_curves
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics.equilibrium import require_bendable

__all__ = [
    "bendable_curves",
    "curve_options",
    "holding_option",
    "pick_curve",
    "refuse_odd_numbers",
    "support_options",
]

F = TypeVar("F", bound=Callable[..., Any])

END_NAMES = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]


def curve_options(function: F) -> F:
    """The CURVE argument and how to read it."""
    function = click.option(
        "--unit",
        type=click.Choice(["mm", "cm", "m", "in", "px"]),
        help="Unit of the file's numbers, where the file does not say or says it wrongly.",
    )(function)
    return click.argument("curve", type=click.Path(path_type=Path))(function)


def holding_option(function: F) -> F:
    """Bridges that hold parts in the sheet."""
    return click.option(
        "--holding",
        type=float,
        metavar="MM",
        help="Leave bridges of this width in the outer cuts, which hold the parts in the sheet.",
    )(function)


def support_options(function: F) -> F:
    """What the ends are held by, and a pre-curved rest shape."""
    function = click.option(
        "--natural-curvature",
        type=float,
        default=0.0,
        metavar="1/MM",
        help="Curvature of the strip before bending (0: flat).",
    )(function)
    for end in ("end", "start"):
        function = click.option(
            f"--{end}",
            type=click.Choice(END_NAMES),
            default="clamped",
            show_default=True,
            help=f"Support of the {end} of the curve.",
        )(function)
    return function


def bendable_curves(path: Path, unit: str | None, number: int | None = None) -> list[PlaneCurve]:
    """The curves of a file, or only the one of that number, each open and without corners.

    A complaint names the file.
    """
    curves = read_curves(path, unit=unit)
    for count, curve in enumerate(curves, start=1):
        if number is None or number == count:
            try:
                require_bendable(curve)
            except InputError as problem:
                which = f", curve {count} of {len(curves)}" if len(curves) > 1 else ""
                raise InputError(f"{path}{which}: {problem}") from problem
    return curves


def pick_curve(path: Path, number: int | None, unit: str | None) -> PlaneCurve:
    """The one curve of a file, or the one asked for by its number from 1."""
    curves = bendable_curves(path, unit, number)
    if number is None:
        if len(curves) > 1:
            raise InputError(
                f"{path} holds {len(curves)} curves: choose one with --curve 1 .. --curve {len(curves)}"
            )
        return curves[0]
    if not 1 <= number <= len(curves):
        raise InputError(f"{path} holds {len(curves)} curve(s): --curve {number} is not among them")
    return curves[number - 1]


def refuse_odd_numbers(chosen: Mapping[str, Any]) -> None:
    """Refuse nan and inf among the options of the running command: Python reads them as numbers."""
    for option in click.get_current_context().command.params:
        value = chosen.get(str(option.name))
        if isinstance(value, float | tuple) and not np.all(np.isfinite(np.array(value, dtype=float))):
            raise InputError(f"{option.opts[0]} is given as nan or infinite: give finite numbers")
