"""Counts in words, and numbers that are compared, for sentences that users read."""

from collections.abc import Sized

MORE_DIGITS = 9
"""Beyond those that are usual: numbers that so many do not tell apart are as good as equal."""


def counted(count: int, noun: str) -> str:
    """How many there are.

    Examples
    --------
    >>> counted(1, "strip"), counted(2, "strip")
    ('1 strip', '2 strips')
    """
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def and_more(found: Sized, noun: str = "") -> str:
    """What follows the first of those found: how many more there are, nothing for a single one.

    Examples
    --------
    >>> and_more("a", "pair"), and_more("abc", "pair"), and_more("abc")
    ('', ' (and 2 more pairs)', ' (and 2 more)')
    """
    others = len(found) - 1
    if others < 1:
        return ""
    return f" (and {counted(others, f'more {noun}') if noun else f'{others} more'})"


def told_apart(one: float, other: float, digits: str) -> tuple[str, str]:
    """Two numbers with as many digits as show that they differ, at least as their format says.

    Examples
    --------
    >>> told_apart(2.51, 3.0, ".3g"), told_apart(2.9982, 3.0, ".3g"), told_apart(0.8729, 0.8734, ".2f")
    (('2.51', '3'), ('2.998', '3'), ('0.8729', '0.8734'))
    """
    usual, kind = int(digits[1:-1]), digits[-1]
    told = [(f"{one:.{n}{kind}}", f"{other:.{n}{kind}}") for n in range(usual, usual + MORE_DIGITS)]
    return next((pair for pair in told if pair[0] != pair[1]), told[0])


def told_range(low: float, high: float, digits: str) -> str:
    """From where to where numbers run, or the one that they all are as far as is told.

    Examples
    --------
    >>> told_range(20.83, 30.0, ".3g"), told_range(29.99, 30.0, ".3g")
    ('20.8 to 30', '30')
    """
    least, most = f"{low:{digits}}", f"{high:{digits}}"
    return most if least == most else f"{least} to {most}"
