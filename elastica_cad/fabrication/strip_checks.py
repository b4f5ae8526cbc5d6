"""What may be asked of a strip: gravity as a designer says it, and refusals of requests that exclude each other."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from elastica_cad._values import is_number, several
from elastica_cad.errors import Change, InputError, rounded_up
from elastica_cad.fabrication.makeability.fabrication_limits import FabricationLimits
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.outline import Tab
from elastica_cad.fabrication.strip.styles import Plain, Style
from elastica_cad.forming.limits import Limits
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.theorem1.verdict import NotRealizable
from elastica_cad.refusals import Length

AskedGravity: TypeAlias = Gravity | bool | Sequence[float] | None
"""A `Gravity`, True for the sheet's own weight along -y, or the direction in which that falls."""

Loads: TypeAlias = "tuple[PointMass, ...] | Weight"
"""Masses hung on a strip beside its own weight; or all weight in newtons."""


def pull_in_plane(given: AskedGravity, sheet: Sheet, frame: Frame | None) -> tuple[Gravity | None, float]:
    """Gravity as a strip feels it in the plane of its curve, and the share of a weight that acts there.

    Raises
    ------
    InputError
        No direction, or one in space where no `frame` says how the plane lies.
    """
    if given is None or isinstance(given, bool):
        return (sheet.gravity() if given else None), 1.0
    if isinstance(given, Gravity):
        return given, 1.0
    direction = _direction(given)
    if len(direction) == 2:
        return sheet.gravity(direction), 1.0
    if frame is None:
        raise InputError(
            "gravity {direction} is a direction in space: give frame, the plane of the curve, or "
            "two numbers, the direction in the drawing",
            direction=direction,
            where={"field": "gravity"},
        )
    own = sheet.elasto_gravity_length
    felt = Gravity.in_plane(own, direction, frame.x_axis, frame.y_axis)
    return felt, 1.0 if felt is None else (own / felt.length) ** 3


def lightened(loads: Loads, share: float) -> Loads:
    """Masses of which only a share acts; a weight in newtons is what acts."""
    if isinstance(loads, Weight):
        return loads
    return tuple(replace(one, mass=share * one.mass) for one in loads)


def hung_weight(loads: Loads, share: float) -> Weight | None:
    """Loads as `optimal_rod` takes them; in a plane that leans, masses hang with a share of their weight."""
    felt = lightened(loads, share)
    if isinstance(felt, Weight):
        return felt
    return Weight(masses=felt, own=True) if felt else None


def _direction(given: object) -> tuple[float, ...]:
    """Two or three numbers that say where things fall."""
    row = tuple(given) if isinstance(given, Sequence | np.ndarray) and not isinstance(given, str) else ()
    if len(row) not in (2, 3) or not all(is_number(one) for one in row) or not any(row):
        raise InputError(
            "gravity is {given!r}: give True, a Gravity record, or the direction in which things "
            "fall as two numbers in the drawing or three in space, not all zero, such as (0, -1) "
            "or (0, 0, -1)",
            given=given,
            where={"field": "gravity"},
        )
    return tuple(float(one) for one in row)


NEAREST_CALL = (
    "limits=ec.Limits() asks for the nearest curve that a strip can take, which strip.rod.curve then is."
)
"""What a program that asked for a strip can do."""


def check_seam(seam_position: float | None, curve: PlaneCurve) -> None:
    """Refuse a place to begin that is not on the curve, or on one that is open."""
    if seam_position is not None and seam_position > curve.length:
        raise InputError(
            "seam_position is {seam:g}: give a place along the curve, 0 to {length:.4g}, or none",
            seam=seam_position,
            length=Length(curve.length),
            where={"field": "seam_position"},
        )
    if seam_position is not None and not curve.is_closed:
        raise InputError(
            "seam_position is {seam:g}, but the curve is open and begins at its own end: leave it "
            "out, or close the curve",
            seam=Length(seam_position),
            where={"field": "seam_position"},
        )


def check_law(
    law: BoundedLaw, sheet: Sheet, style: Style, ends: Sequence[Tab], slots: Sequence[Slot], *, sized: bool
) -> None:
    """Refuse a law beside another style, widths (`sized`) or a shape of its own, or one of another sheet."""
    shaped = bool(slots) or any(tab != Tab(tab.length) for tab in ends)
    shaped = shaped and getattr(law, "quantity", "") != "width"
    if not isinstance(style, Plain) or sized or shaped:
        raise InputError(
            "a law says what the section is and how large: leave out style, slots, max_width and min_width, "
            "and give tabs a length only, or leave out law",
            where={"field": "law"},
        )
    other = getattr(law, "sheet", sheet)
    if other != sheet:
        raise InputError(
            "the law is of {name}, the strip of {name_2}: give both the same sheet",
            name=other.name,
            name_2=sheet.name,
            where={"field": "law"},
        )


def limits_beside(
    limits: Limits, sheet: Sheet, style: Style, *, max_width: float | None, min_width: float | None
) -> Limits:
    """Limits of a strip without a law, agreed with its own sheet and widths.

    What is asked of a plain strip's width stands in two places: the narrower range is kept.

    Raises
    ------
    InputError
        Widths outside those of the limits, or strains of a sheet of another thickness.
    """
    if (
        limits.sheet is not None
        and not isinstance(style, Laminated)
        and limits.sheet.thickness != sheet.thickness
    ):
        raise InputError(
            "the limits are of {name}, {thickness:g} thick, the strip of {name_2}, "
            "{thickness_2:g}: leave sheet out of the limits, which are then of the strip's",
            name=limits.sheet.name,
            thickness=Length(limits.sheet.thickness),
            name_2=sheet.name,
            thickness_2=Length(sheet.thickness),
        )
    if limits.width is None or not isinstance(style, Plain):
        return limits
    low, high = limits.width
    for name, width in (("max_width", max_width), ("min_width", min_width)):
        if width is not None and not low <= width <= high:
            raise InputError(
                "{name} is {width:g}, outside the limit width of {low:g} to {high:g}: change one of "
                "them, or leave the limit out",
                name=name,
                width=Length(width),
                low=low,
                high=Length(high),
                where={"field": (name, "limits.width")},
            )
    narrowest, widest = min_width or low, max_width or high
    if narrowest > widest:  # refused where the widths are compared
        return limits
    return replace(limits, width=(narrowest, widest))


def ratio_of_widths(max_width: float, min_width: float, sheet: Sheet, shop: FabricationLimits) -> float:
    """The largest ratio of a plain strip's widths, mm, that the workshop can cut of a sheet.

    Raises
    ------
    InputError
        A `min_width` above `max_width`, or a strip that is too narrow for its sheet everywhere.
    """
    least = shop.width_for(sheet)
    if min_width > max_width:
        raise InputError(
            "min_width is {min_width:g}, more than max_width, {max_width:g}: give the larger one "
            "as max_width",
            min_width=Length(min_width),
            max_width=Length(max_width),
            where={"field": "max_width"},
        )
    if least >= max_width:
        raise InputError(
            "max_width is {max_width:g}, but {name} needs {least} at its narrowest: widen the "
            "strip, take another sheet, or allow less with shop=FabricationLimits(least_width=...)",
            max_width=Length(max_width),
            name=sheet.name,
            least=Length(least),
            where={"field": "max_width"},
            changes=[Change("max_width", rounded_up(2 * least, 3))],
        )
    return max_width / max(min_width, least)


def masses_of(loads: object) -> tuple[PointMass, ...]:
    """Masses hung on a strip: one, or several."""
    return several("loads", loads, PointMass, "PointMass")


@contextmanager
def told_in_python(curve: PlaneCurve, may_change: bool) -> Iterator[None]:
    """A refusal of the curve ends with the argument that lets it change, where a program asked for the strip.

    It is a note below the message, not tried: a search may take longer than a program has for a curve that it
    only asks about.
    """
    try:
        yield
    except (NotRealizable, InputError) as problem:
        refused = isinstance(problem, NotRealizable) or curve.has_corners
        if refused and not may_change:
            problem.add_note(NEAREST_CALL)
        raise
