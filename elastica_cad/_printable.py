"""Foreign text (layers, ids, labels, names of files) made safe to show: the one place that all channels use."""

import re
from html import escape

_SUSPECT = re.compile(
    r"[^ -~\n\xa0\u1680\u2000-\u200a\u202f\u205f\u3000]"
)  # all but ASCII, line ends and spaces


def printable(text: str) -> str:
    r"""The text, signs that cannot be seen (control codes, marks of direction, lone surrogates) as their numbers.

    Such signs recolour a terminal, write to its clipboard, or let a line read backwards; line ends and spaces stay.
    The number is written as JSON writes it, so a JSON record holds the same after as before.

    Examples
    --------
    >>> printable("plain"), printable("a\x1b[31m\u202eb")
    ('plain', 'a\\u001b[31m\\u202eb')
    """
    return _SUSPECT.sub(_shown, text)


def html_text(text: object) -> str:
    """The text as HTML and SVG hold it.

    Examples
    --------
    >>> html_text("<b>")
    '&lt;b&gt;'
    """
    return escape(printable(str(text)))


def _shown(found: re.Match[str]) -> str:
    sign = found[0]
    if sign.isprintable():
        return sign
    pair = sign.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{pair[at : at + 4]}" for at in range(0, len(pair), 4))
