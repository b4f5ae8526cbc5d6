"""Options that are not known are refused, with the nearest that is."""

from collections.abc import Iterable
from difflib import get_close_matches

from elastica_cad.errors import InputError


class UnknownOptionError(InputError, TypeError):
    """An option that no strip has, as Python itself refuses unknown arguments."""


def refuse_unknown(asked: Iterable[str], known: Iterable[str], what: str) -> None:
    """Refuse the first name that is not known as an option of `what`.

    Raises
    ------
    UnknownOptionError
        There is one.
    """
    names = sorted(known)
    for name in asked:
        if name not in names:
            near = get_close_matches(name, names, n=1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise UnknownOptionError(f"{name} is no option of {what}: {hint}")
