"""The numbers and counts that readers take: finite and in stated ranges, asked before anything is computed."""

import re
from collections.abc import Iterable

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.refusals import Length

SMALLEST_SIZE, LARGEST_SIZE = 1e-3, 1e6
"""Sizes of curves that are read, mm: a thousandth of a millimetre to a kilometre."""

FARTHEST = 1e10
"""Largest coordinate, mm: maps in metres lie thousands of kilometres from their origin."""

LARGEST_NUMBER = 1e9
"""Of any option or value in a design, whatever its unit; what it stands for has its own range."""

MOST_SHAPES = 20_000
"""Shapes of a drawing, those of its blocks and clones counted as often as they are shown."""

MOST_EDGES = 120_000
"""Pieces of all curves of one file."""

MOST_CURVES = 5_000
"""Curves of one file."""

MOST_PIECES = 3_000
"""Pieces of one curve, and its control points or measured points over four."""

MOST_DEGREE = 25
"""Largest degree of a spline."""

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_WRITTEN = re.compile(r"[-+]?(\d*)(?:\.(\d*))?(?:[eE]([-+]?\d+))?")
_PROGRAMS = 6  # significant digits, from which a program may count those instead of decimals
_EVIDENCE = 2  # of the largest numbers that, not being round, would show all decimals that were written


def check_places(points: FloatArray) -> FloatArray:
    """Return coordinates in mm, and refuse those that are not finite or too far away.

    Raises
    ------
    InputError
        The first that is not.
    """
    bad = ~(np.abs(points) <= FARTHEST)
    if bad.any():
        value = points[bad].flat[0]
        raise InputError(
            "a coordinate is {given}; they must be finite and at most {farthest:g}: check the "
            "unit, or export it anew",
            given=Length(value),
            farthest=Length(FARTHEST),
        )
    return points


def check_size(points: FloatArray) -> None:
    """Refuse a curve whose control points (n, d), mm, spread over less or more than any strip does."""
    check_places(points)
    size = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    if size != 0 and not SMALLEST_SIZE <= size <= LARGEST_SIZE:
        raise InputError(
            "a curve is {size} large; {smallest_size:g} to {largest_size:g} are read: check the "
            "unit (--unit), or leave it out",
            size=Length(size),
            smallest_size=SMALLEST_SIZE,
            largest_size=Length(LARGEST_SIZE),
        )


def check_count(count: int, most: int, what: str, instead: str) -> int:
    """Return a count, and refuse it where it is above `most`; the message says `what` it counts and what to do
    `instead`.
    """
    if count > most:
        raise InputError(
            "has {whole} {what}, and at most {most} are read: {instead}",
            whole=_whole(count),
            what=what,
            most=most,
            instead=instead,
        )
    return count


def check_degree(degree: int) -> int:
    """Return the degree of a spline, and refuse it unless it is 1 or more."""
    if not 1 <= degree <= MOST_DEGREE:
        raise InputError(
            "a spline has degree {whole}; 1 to {most_degree} are read: export it with degree 3",
            whole=_whole(degree),
            most_degree=MOST_DEGREE,
        )
    return degree


def check_tolerance(value: float, name: str = "tolerance") -> float:
    """Return the tolerance of a reader, mm: how far ends that it joins, or points that it fits, may lie off.

    Parameters
    ----------
    value : float
        From 1e-9 to 1000 mm.
    name : str
        What the message calls it.

    Raises
    ------
    InputError
        No number, or one outside that range.
    """
    if not (isinstance(value, int | float | np.number) and 1e-9 <= value <= 1e3):
        raise InputError(
            "the {name} for reading is {given!r}: it must be positive, 1e-9 to 1000 mm, e.g. 0.01",
            name=name,
            given=value,
        )
    return float(value)


def _whole(number: int) -> str:
    """A whole number, shortened where it has very many digits."""
    return str(number) if abs(number) < 10**12 else "more than 1e12"


def half_last_place(numbers: Iterable[str]) -> float:
    """Return half a unit of the last digit to which coordinates were written: the most that rounding moved one.

    Some programs write a fixed number of decimals, without closing zeros, others so many significant digits; the
    coarsest number of either decides. No number: 0.

    Examples
    --------
    >>> half_last_place(["12.34", "7.5", "100"]), half_last_place(["123.45678", "0.0012345678"])
    (0.005, 5e-06)
    """
    found = [one for one in map(_digits, numbers) if one is not None]
    if not found:
        return 0.0
    largest = max(size for size, _, _ in found)
    plain = [one for one in found if one[0] > 1e-6 * largest or one[0] == 0]
    decimals = max(places for _, places, _ in plain)
    significant = max(digits for _, _, digits in plain)
    before_point = int(np.floor(np.log10(largest))) + 1 if largest > 0 else 1
    top = [one for one in plain if one[0] >= 10.0 ** (before_point - 1)]
    if significant >= _PROGRAMS or sum(size % 10 != 0 for size, _, _ in top) >= _EVIDENCE:
        decimals = max([places for _, places, _ in top], default=decimals)
        decimals = max(decimals, min(max(places for _, places, _ in plain), significant - before_point))
    return float(0.5 * 10.0 ** -min(max(decimals, 0), 30))


def _digits(text: str) -> tuple[float, int, int] | None:
    """Size, decimals and significant digits of a written number; None for what is none."""
    match = _WRITTEN.fullmatch(text.strip())
    if match is None or not (match[1] or match[2]):
        return None
    whole, fraction, power = match[1] or "", match[2] or "", match[3] or "0"
    if len(power) > 4:
        return None
    size = abs(float(text))
    if not size < 1e300:
        return None
    digits = (whole + fraction if fraction else whole.rstrip("0")).lstrip("0")
    return size, len(fraction) - int(power), len(digits)
