"""From a drawn curve and a sheet to a strip in one call: what every CAD skin does for its user."""

from dataclasses import replace
from typing import Any

from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.lamination import Laminated
from elastica_cad.fabrication.strip import Strip
from elastica_cad.fabrication.styles import along
from elastica_cad.forming import Keep, Limits, NearestRod, Status, nearest_rod
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import (
    EquilibriumCheck,
    Gravity,
    LaminatedSection,
    Rod,
    Sheet,
    Supports,
    optimal_laminate,
    optimal_rod,
)

__all__ = ["StripFacts", "make_strip"]


class StripFacts:
    """What a body of a strip tells about it; for the classes of CAD skins."""

    strip: Strip

    @property
    def rod(self) -> Rod:
        """The bent rod: shape, stiffness, moment, force."""
        return self.strip.rod

    @property
    def check(self) -> EquilibriumCheck | None:
        """The verdict of Theorem 1 on the drawn curve, where one was asked for."""
        return self.rod.check

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a maker should know before cutting."""
        return self.strip.warnings


def make_strip(
    curve: PlaneCurve,
    sheet: Sheet | str,
    *,
    limits: Limits | None = None,
    keep: Keep | None = None,
    gravity: Gravity | bool | None = None,
    supports: Supports | None = None,
    natural_curvature: float = 0.0,
    **options: Any,
) -> Strip:
    """The strip that bends into a curve, or into the nearest one that meets `limits`.

    Parameters
    ----------
    curve : PlaneCurve
    sheet : Sheet or str
        The material, or the name of a built-in one.
    limits, keep : Limits, Keep, optional
        With one of them the curve may be changed, by `nearest_rod`; without them it is followed exactly.
    gravity : Gravity or bool, optional
        True for the sheet's own weight, falling along -y. A laminate carries the weight of both its layers,
        which is not proportional to its stiffness (see `optimal_laminate`).
    supports, natural_curvature
        As in `optimal_rod`.
    **options
        The other arguments of `Strip`: max_width, min_width, style, ends, slots, label.

    Raises
    ------
    NotRealizable
        No strip takes the curve and neither limits nor keep allow it to change.
    NotConvergedError
        No rod near the curve meets the limits; the message says what would help.
    InputError
        As `optimal_rod`, `nearest_rod` and `Strip`.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> round(make_strip(arch, "birch-plywood-0.8", max_width=30).width.extremes[1], 6)
    30.0
    """
    if isinstance(sheet, str):
        sheet = Sheet.named(sheet)
    if not isinstance(sheet, Sheet):
        raise InputError(f"a Sheet or the name of one is needed, not {type(sheet).__name__}")
    if isinstance(gravity, bool):
        gravity = sheet.gravity() if gravity else None
    held = supports or Supports()
    style = options.get("style")
    if isinstance(style, Laminated) and gravity is not None:
        if limits is not None or keep is not None or natural_curvature != 0.0:
            raise InputError(
                "a laminate that carries its weight follows its curve exactly, from flat sheets: leave out limits, "
                "keep and natural_curvature, or gravity"
            )
        return Strip(_laminate(curve, sheet, style, gravity, held), sheet, **options)
    if limits is None and keep is None:
        rod = optimal_rod(curve, gravity=gravity, supports=held, natural_curvature=natural_curvature)
        return Strip(rod, sheet, **options)
    if natural_curvature != 0.0:
        raise InputError(
            "a strip with a natural curvature follows its curve exactly: leave limits and keep out"
        )
    near = nearest_rod(curve, limits, keep, gravity, supports=held)
    return Strip(_accepted(near), sheet, **options)


def _laminate(curve: PlaneCurve, sheet: Sheet, style: Laminated, gravity: Gravity, supports: Supports) -> Rod:
    """The rod of base and backing under the weight of both."""
    if abs(gravity.length / sheet.elasto_gravity_length - 1) > 1e-9:
        raise InputError(
            "a laminate that carries its weight must stand upright and weigh what its sheets do: turn its plane, "
            "give gravity=True or the base sheet's gravity, or leave gravity out"
        )
    laminate = optimal_laminate(
        curve,
        LaminatedSection(sheet, style.backing),
        along(style.width, curve.length, "the width of the base"),
        direction=gravity.direction,
        supports=supports,
        least_backing=style.least_backing,
    )
    return laminate.rod


def _accepted(near: NearestRod) -> Rod:
    """The rod, with a warning where the search says one."""
    if not near.met:
        raise NotConvergedError(str(near))
    if near.status is Status.MET:
        return near.rod
    return replace(near.rod, warnings=(*near.rod.warnings, near.status.value))
