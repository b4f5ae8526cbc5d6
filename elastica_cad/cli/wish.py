"""How far a drawn curve may be changed: options that turn it into the nearest curve that can be made."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import click

from elastica_cad.errors import ElasticaError
from elastica_cad.forming import Keep, Limits, NearestRod, nearest_rod
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, Sheet, Supports

__all__ = ["NotMetError", "WishOptions", "wish_options"]

F = TypeVar("F", bound=Callable[..., Any])

SAFE_MARGIN = 5.0
"""A margin that bears the inaccuracies of cutting and mounting; 0 is the border of stability."""


class NotMetError(ElasticaError, ValueError):
    """The limits cannot be met near the drawn curve."""


@dataclass(frozen=True)
class WishOptions:
    """What the user allows: any limit given means that the curve may be changed."""

    nearest: bool
    ratio: float | None
    stable: bool
    margin: float | None
    keep_strain: bool
    keep_tangents: bool
    keep_length: bool

    @property
    def asked(self) -> bool:
        """May the curve be changed at all?"""
        return (
            self.nearest
            or self.stable
            or self.keep_strain
            or self.ratio is not None
            or self.margin is not None
        )

    def fulfilled(
        self, curve: PlaneCurve, sheet: Sheet, gravity: Gravity | None, supports: Supports
    ) -> NearestRod:
        """The nearest rod within the limits.

        Raises
        ------
        NotMetError
            When there is none; the message says what binds.
        """
        margin = self.margin if self.margin is not None else SAFE_MARGIN if self.stable else None
        near = nearest_rod(
            curve,
            Limits(ratio=self.ratio, margin=margin, sheet=sheet if self.keep_strain else None),
            Keep(tangents=self.keep_tangents, length=self.keep_length),
            gravity,
            supports=supports,
        )
        if not near.met:
            raise NotMetError(str(near))
        return near


def wish_options(function: F) -> F:
    """Limits that let the strip leave the drawn curve, as little as possible."""
    added = [
        click.option("--nearest", is_flag=True, help="Change the curve, as little as it takes."),
        click.option("--ratio", type=float, metavar="R", help="Largest stiffness ratio (widest to narrowest)."),
        click.option("--stable", is_flag=True, help=f"Make sure that it stays put (a margin of {SAFE_MARGIN:g})."),
        click.option("--margin", type=float, metavar="MU", help="Least stability margin, instead of --stable's."),
        click.option("--keep-strain", is_flag=True, help="Keep within the strain that the sheet bears."),
        click.option("--keep-tangents", is_flag=True, help="When the curve changes, keep its end tangents."),
        click.option("--keep-length", is_flag=True, help="When the curve changes, keep its length."),
    ]  # fmt: skip
    for option in reversed(added):
        function = option(function)
    return function
