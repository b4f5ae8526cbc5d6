"""What to write in a file of tables instead of what was refused: a slip of a name, a missing line, quotes."""

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches

SHEETS_MM = ((600, 400), (1000, 600), (1250, 1250), (2500, 1250), (3050, 1525))
"""Sizes in which sheets are sold, the smallest first."""

LAP_MM = 80
"""Of plates that join pieces of a strip: as the manual has them."""


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
    for added in _roomier(text, said):
        yield f"{added}\n{text}", f"write `{added}` in a first line of {{file}}"
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


def _roomier(text: str, said: str) -> Iterator[str]:
    """What makes room for a part that is larger than the sheet: a sheet, where the file names none, else pieces."""
    size = r"([\d.]+) by ([\d.]+) mm"
    large = re.search(
        rf"{size} is larger than a sheet of {size} with a margin of ([\d.]+) mm(.*across)?", said
    )
    if not large:
        return
    long, wide, *_, margin = (float(number) for number in large.groups()[:5])
    if not re.search(r"^\s*(\[nest\]|nest\b)", text, re.MULTILINE):
        for first, second in SHEETS_MM:
            if long + 2 * margin <= first and wide + 2 * margin <= second:
                width, height = (second, first) if large[6] else (first, second)
                yield f"nest.sheet_size = [{width}, {height}]"
                break
    if not re.search(r"^\s*(\[shop\]|shop\b)", text, re.MULTILINE):
        yield f"shop.lap = {LAP_MM}"
