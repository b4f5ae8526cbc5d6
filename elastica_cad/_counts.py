"""Counts in words, and numbers that are compared, for sentences that users read."""

from collections.abc import Sized

from elastica_cad.refusals import note

MORE_DIGITS = 9
"""Beyond those that are usual: numbers that so many do not tell apart are as good as equal."""


def counted(count: int, noun: str) -> str:
    """How many there are.

    Examples
    --------
    >>> counted(1, "strip"), counted(2, "strip")
    ('1 strip', '2 strips')
    """
    return note(f"{{count}} {noun}{'' if count == 1 else 's'}", count=count)


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
    if not noun:
        return note(" (and {others} more)", others=others)
    return note(" (and {more})", more=counted(others, f"more {noun}"))


def told_apart(one: float, other: float, digits: str) -> tuple[float, float]:
    """Two numbers rounded to as many digits as show that they differ, at least as their format says.

    Examples
    --------
    >>> told_apart(2.51, 3.0, ".3g"), told_apart(2.9982, 3.0, ".3g"), told_apart(0.8729, 0.8734, ".2f")
    ((2.51, 3.0), (2.998, 3.0), (0.8729, 0.8734))
    """
    usual, kind = int(digits[1:-1]), digits[-1]
    digits_of = range(usual, usual + MORE_DIGITS)
    told = [(float(f"{one:.{n}{kind}}"), float(f"{other:.{n}{kind}}")) for n in digits_of]
    return next((pair for pair in told if pair[0] != pair[1]), told[0])
