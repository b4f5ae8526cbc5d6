"""What a record of mutants says: how many are noticed, of all and of those that change an answer."""

from typing import Any

Record = list[dict[str, Any]]


def summary(record: Record) -> str:
    """Both rates in a sentence."""
    killed = sum(one["verdict"] in ("killed", "too long") for one in record)
    equal = sum(one["verdict"] == "equivalent" for one in record)
    told = f"{killed} of {len(record)} mutants noticed"
    if not equal:
        return told
    rest = len(record) - equal
    share = 100 * killed / rest if rest else 100.0
    return f"{told}; {equal} leave every answer of the bank as it is, of the other {rest} {share:.1f} % are noticed"


def survivors(record: Record) -> list[list[str]]:
    """File, change and reason of each mutant that no test notices though it may change an answer."""
    left = [one for one in record if one["verdict"] == "survived"]
    return [[one["file"], one["change"], one.get("reason", one.get("bank", ""))] for one in left]
