"""Text for people: names, names of files, escaping of text from files, quoting of commands for a shell, and the
command that files state.
"""

import os
import re
import shlex
import subprocess
from collections.abc import Iterable
from contextvars import ContextVar
from html import escape
from pathlib import PurePath, PurePosixPath, PureWindowsPath
from unicodedata import category, normalize

_SUSPECT = re.compile(
    r"[^ -~\n\xa0\u1680\u2000-\u200a\u202f\u205f\u3000]"
)  # all characters except printable ASCII, line ends and spaces


def printable(text: str) -> str:
    r"""Escape invisible characters in a text: control codes, marks of writing direction, lone surrogates.

    Such characters could recolour a terminal, write to its clipboard, or reverse a line. Line ends and spaces
    are kept. The escapes are valid JSON, so the contents of a JSON record do not change.

    Examples
    --------
    >>> printable("plain"), printable("a\x1b[31m\u202eb")
    ('plain', 'a\\u001b[31m\\u202eb')
    """
    return _SUSPECT.sub(_escaped, text)


def html_text(text: object) -> str:
    """Return the text escaped for HTML and SVG.

    Examples
    --------
    >>> html_text("<b>")
    '&lt;b&gt;'
    """
    return escape(printable(str(text)))


def _escaped(match: re.Match[str]) -> str:
    sign = match[0]
    if sign.isprintable():
        return sign
    pair = sign.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{pair[at : at + 4]}" for at in range(0, len(pair), 4))


_OVERRIDES = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
"""Signs that change the direction of the text after them, with which a name could look like another name."""

_INVISIBLE = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u3164\ufe00-\ufe0f\uffa0\U000e0100-\U000e01ef]"
)
"""Letters and marks without width. Other signs without width are in the category Cf of Unicode."""


def plain_name(text: str) -> str:
    r"""Return a name in Unicode's normal form C, with plain spaces and without signs that have no width.

    Signs that change the direction of writing are kept, so that `require_name` can refuse them.

    Examples
    --------
    >>> plain_name("A\u00a01\u00ad"), plain_name("Tra\u0308ger") == "Tr\u00e4ger"
    ('A 1', True)
    """
    signs = (" " if category(sign) == "Zs" else sign for sign in _INVISIBLE.sub("", text))
    return normalize("NFC", "".join(sign for sign in signs if category(sign) != "Cf" or sign in _OVERRIDES))


LONGEST_WORD, LONGEST_WORD_BYTES = 60, 96
"""Largest number of characters and of bytes of a name in a file name, which may contain two names.

File systems limit file names to 255 bytes."""

_DEVICE = re.compile(r"^(con|prn|aux|nul|(?:com|lpt)[0-9¹²³])(?=\.|$)", re.IGNORECASE)  # Windows device names


def file_word(text: str) -> str:
    """Return the text with only characters that are valid in file names on all systems.

    Letters, marks and digits of all scripts are kept.

    Examples
    --------
    >>> file_word("P 1/2: top"), file_word("../Łuk/左")
    ('P-1-2-top', 'Łuk-左')
    >>> file_word("con.txt")  # a device of Windows
    'con_.txt'
    """
    signs = (sign if category(sign)[0] in "LMN" or sign in "_.-" else " " for sign in plain_name(text))
    word = "-".join("".join(signs).split())[:LONGEST_WORD]
    word = word.encode()[:LONGEST_WORD_BYTES].decode(errors="ignore").strip("-.") or "part"
    return _DEVICE.sub(r"\1_", word)


def distinct(names: Iterable[str]) -> list[str]:
    """Return the names with numbers appended to repeated names.

    Names that differ only in case count as equal, because some file systems ignore case.

    Examples
    --------
    >>> distinct(["A", "B", "a"])
    ['A', 'B', 'a-2']
    """
    names = list(names)
    first = {name.casefold(): i for i, name in reversed(list(enumerate(names)))}
    taken, unique = set(first), []
    for i, name in enumerate(names):
        number, candidate = 1, name
        while first.get(name.casefold()) != i and candidate.casefold() in taken:
            number += 1
            candidate = f"{name}-{number}"
        taken.add(candidate.casefold())
        unique.append(candidate)
    return unique


MADE_BY: ContextVar[str] = ContextVar("made_by", default="")
"""Text of the running command for comments in written files, or "" in a script."""

_PLAIN = re.compile(r"[^&|<>^()%!]+")
"""Words of these characters need no quotes in cmd, the Windows shell."""

_NOT_OF_DRAWINGS = {
    "-o": 1, "--output": 1, "--force": 0, "--json": 0, "-v": 0, "--verbose": 0, "-q": 0, "--quiet": 0, "--watch": 0,
}  # fmt: skip
"""Options without effect on drawings, and the number of values of each."""


def in_runs(names: Iterable[str]) -> list[str]:
    """Return names with the middle of each run of at least three consecutive numbers left out.

    Examples
    --------
    >>> in_runs(["P9", "P10", "P11", "P12", "base", "C1", "C2"])
    ['P9 ... P12', 'base', 'C1', 'C2']
    """
    runs, expected = list[list[str]](), ""
    for name in names:
        if name == expected:
            runs[-1].append(name)
        else:
            runs.append([name])
        found = re.fullmatch(r"(.*?)(\d+)", name)
        expected = f"{found[1]}{int(found[2]) + 1:0{len(found[2])}}" if found else ""
    return [text for run in runs for text in ([f"{run[0]} ... {run[-1]}"] if run[2:] else run)]


def quote_words(words: Iterable[str], *, windows: bool = os.name == "nt") -> str:
    """Return words as a line for the shell of this system, or for the Windows shell cmd, quoted if necessary.

    Examples
    --------
    >>> quote_words(["strip", "my arch.dxf"], windows=False), quote_words(["strip", "my arch.dxf"], windows=True)
    ("strip 'my arch.dxf'", 'strip "my arch.dxf"')
    """
    if not windows:
        return shlex.join(words)
    # cmd interprets characters such as & outside quotes, but `list2cmdline` quotes only words with blanks
    lines = (subprocess.list2cmdline([word]) for word in words)
    return " ".join(word if word[0] == '"' or _PLAIN.fullmatch(word) else f'"{word}"' for word in lines)


def command_of_drawings(words: Iterable[str], *, windows: bool = os.name == "nt") -> str:
    """Return the command that makes the same drawings again, from the arguments of the program.

    The output folder is omitted. Absolute paths become file names, because they may contain user names.

    Examples
    --------
    >>> command_of_drawings(["strip", "/home/jo/arch.dxf", "--sheet", "pom-1", "-o", "out"], windows=False)
    'elastica strip arch.dxf --sheet pom-1'
    """
    command, rest = ["elastica"], iter(words)
    path: type[PurePath] = PureWindowsPath if windows else PurePosixPath
    for word in rest:
        option, equals_sign, value = word.partition("=") if word.startswith("--") else ("", "", word)
        if (name := option or word) in _NOT_OF_DRAWINGS or word.startswith("-o"):
            if not equals_sign and _NOT_OF_DRAWINGS.get(name):
                next(rest, "")
            continue
        text = path(value).name if path(value).is_absolute() else value
        command.append(f"{option}{equals_sign}{text}")
    return quote_words(command, windows=windows)
