"""What to write in a file of tables instead of what was refused: a slip of a name, a missing line, quotes."""

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches


def mends(text: str, said: str, files: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Texts to try instead of a refused one, each with what to do in a few words; `{file}` stands for its name.

    Parameters
    ----------
    text : str
        Of the file, TOML.
    said : str
        The refusal.
    files : sequence of str
        Names of the files that it may have meant.

    Examples
    --------
    >>> said = "kit.toml: unknown key 'max_widht'; did you mean max_width?"
    >>> list(mends("max_widht = 12", said, []))
    [('max_width = 12', 'write `max_width` for `max_widht` in line 1 of {file}')]
    """
    lines = text.splitlines()
    for wrong, right in _slips(said, files):
        word = re.compile(rf"(?<![\w.-]){re.escape(wrong)}(?![\w.-])")
        changed = [line if line.lstrip().startswith("#") else right.join(word.split(line)) for line in lines]
        at = [str(n) for n, (old, new) in enumerate(zip(lines, changed, strict=True), start=1) if old != new]
        if at:
            where = f"line{'s' if len(at) > 1 else ''} {', '.join(at)}"
            yield "\n".join(changed), f"write `{right}` for `{wrong}` in {where} of {{file}}"
    if schema := re.search(r"schema is None; this version reads (schema = \d+)", said):
        yield f"{schema[1]}\n{text}", f"write `{schema[1]}` in a first line of {{file}}"
    if line := re.search(r"is no TOML file: .*at line (\d+),", said):
        number = int(line[1])
        key, sign, value = (lines[number - 1] if number <= len(lines) else "").partition("=")
        if sign and '"' not in value:
            quoted = f'{key.strip()} = "{value.strip()}"'
            yield (
                "\n".join([*lines[: number - 1], quoted, *lines[number:]]),
                f"write `{quoted}` in line {number} of {{file}}",
            )


def _slips(said: str, files: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Words that the refusal does not know, each with a word that it names instead."""
    for slip in said.split(" Also: "):
        unknown = re.search(r"unknown [\w ]+ '([^']+)'", slip)
        meant = re.search(r"did you mean ([^?]+)\?|known sheets: ([^;]+)", slip)
        if unknown and meant:
            for name in re.split(r", | or ", meant[1] or meant[2]):
                yield unknown[1], name.strip()
        if choices := re.search(r" is '([^']+)'[:;] (?:it must be|use) one of ([\w, -]+)", slip):
            for name in get_close_matches(choices[1], choices[2].split(", "), n=1):
                yield choices[1], name
        if lost := re.search(r"there is no file ([^;]+);", slip):
            for name in get_close_matches(lost[1], files, n=2):
                yield lost[1], name
