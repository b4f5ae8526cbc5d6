"""What a record of mutants says: how many are noticed, of all and of those that change an answer."""

from typing import Any

Record = list[dict[str, Any]]
NOTICED = ("killed", "too long")


def summary(record: Record) -> str:
    """Both rates in a sentence, and how many were noticed before tests were mended."""
    killed = sum(one["verdict"] in NOTICED for one in record)
    first = sum(one.get("first", one["verdict"]) in NOTICED for one in record)
    equal = sum(one["verdict"] == "equivalent" for one in record)
    result = f"{killed} of {len(record)} errors noticed"
    if first != killed:
        result += f" ({first} at the first look)"
    if not equal:
        return result
    rest = len(record) - equal
    share = 100 * killed / rest if rest else 100.0
    return f"{result}; {equal} change no result, of the other {rest} {share:.1f} % are noticed"


def together(records: list[Record]) -> Record:
    """Mutants of several seeds, those that two of them drew once, as they were judged last."""
    return list(
        {(one["file"], one["number"], one["change"]): one for record in records for one in record}.values()
    )
