"""Checks of arguments that several functions share; each refusal is one sentence."""

from elastica_cad._values import is_number, is_whole
from elastica_cad.errors import InputError, quoted
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports


def require_curve(curve: object) -> None:
    """Refuse what is no `PlaneCurve`."""
    if not isinstance(curve, PlaneCurve):
        raise InputError(
            "the curve is a {name}: give a PlaneCurve, as PlaneCurve.fit(points) makes one",
            name=type(curve).__name__,
        )


def require_gravity(gravity: object) -> None:
    """Refuse what is neither a `Gravity` nor None."""
    if not (gravity is None or isinstance(gravity, Gravity)):
        raise InputError(
            "gravity is {gravity!r}: give a Gravity record, such as sheet.gravity() or "
            "Gravity(96.0), or None",
            gravity=gravity,
        )


def require_supports(supports: object) -> Supports:
    """The supports, clamped at both ends for None."""
    if supports is None:
        return Supports()
    if not isinstance(supports, Supports):
        raise InputError(
            'supports is {supports!r}: give a Supports record, such as Supports("clamped", "pinned")',
            supports=supports,
        )
    return supports


def require_tolerance(tolerance: object) -> None:
    """Refuse a tolerance that is negative or no number."""
    if not (is_number(tolerance) and tolerance >= 0):
        raise InputError(
            "tolerance is {tolerance!r}: it must be a number, 0 or more, in lengths of the curve",
            tolerance=tolerance,
        )


def require_ratio(ratio: object, name: str) -> None:
    """Refuse a bound of max K / min K below 1, or one that is no number."""
    if not (is_number(ratio) and ratio >= 1):
        raise InputError(
            "{name} is {ratio}: the largest stiffness over the least cannot be below 1; plain strips allow 2 to 4",
            name=name,
            ratio=ratio,
        )


MOST_COUNTED = 1_000_000
"""Largest number of nodes or samples; more would not fit into memory."""


def whole_number(value: object, name: str, least: int) -> int:
    """A count of at least `least`; fractions, texts and truth values are none."""
    if not is_whole(value) or value < least:
        raise InputError(
            "{name} is {given!r}: it must be a whole number, {least} or more",
            name=name,
            given=value,
            least=least,
        )
    if value > MOST_COUNTED:
        raise InputError(
            "{name} is {given}: it must be a whole number, {most_counted} at most",
            name=name,
            given=quoted(value),
            most_counted=MOST_COUNTED,
        )
    return int(value)
