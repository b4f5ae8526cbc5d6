"""Counts in words, for sentences that users read."""

from collections.abc import Sized


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
