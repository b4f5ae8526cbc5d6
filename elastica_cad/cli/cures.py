"""What a refusal ends with: the command that would work, tried before it is said, and what it costs."""

import os
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from difflib import get_close_matches
from itertools import chain, count, islice, product
from os import sep
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeAlias

import click
import numpy as np

from elastica_cad.cli.asking.lengths import Length
from elastica_cad.cli.asking.options import given_of, option_name
from elastica_cad.cli.running.design_mends import mends
from elastica_cad.cli.running.typed_command import TRYING, command_line, length_among
from elastica_cad.errors import ElasticaError
from elastica_cad.files import read_drawing
from elastica_cad.formats.design_files.reshaping import CORNERS, box_around_curves
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

Words: TypeAlias = tuple[str, ...]

MOST_TRIALS = 6
"""Commands that are run before a refusal is told without one."""

MOST_MENDS = 12
"""Mends of a file that are tried, one after another, for as many slips."""

QUICK = {"model": ("--no-step", "--no-pictures", "--no-effects"), "strip": ("--no-step", "--no-pictures")}
"""Options that leave out of a trial what cannot make it fail."""

ADDED = (
    (r"-o out", ("-o", "out")),
    (r"--sheet", ("--sheet", "birch-plywood-0.8")),
    (r"--max-width", ("--max-width", "20mm")),
    (r"planes to cut", ("--radial", "8")),
    (r"length of a straight strip|CURVE", ("--straight", "300mm", "--to", "200mm", "0mm")),
    (r"no rest shape|of the path|continu", ("--steps", "20")),
    (r"no rest shape|of the path|continu", ("--steps", "100")),
    (r"split", ("--split-corners", "20")),
    (r"--force", ("--force",)),
    (r"--gravity", ("--gravity",)),
    (r"--unit", ("--unit", "mm")),
    (r"--unit", ("--unit", "cm")),
    (r"--unit", ("--unit", "m")),
    (r"", ("--nearest",)),
    (r"--ignore-limits", ("--ignore-limits",)),
)
"""Words that are added where a command knows them and its refusal speaks of them: (pattern, words)."""

PULLED = 1.1
"""Of the way from the lower left to the upper right corner of the box, to which the latter is pulled as a trial."""


@dataclass(frozen=True)
class _Refused:
    """A command that was refused: its name, the words behind it, and what was said."""

    command: click.Command
    name: str
    words: Words
    said: str

    def typed(self, option: click.Parameter) -> Iterator[tuple[int, int]]:
        """From where to where among the words an option and its values stand."""
        for i, word in enumerate(self.words):
            if word in option.opts:
                flag = isinstance(option, click.Option) and option.is_flag
                end = i + 1 + (0 if flag else option.nargs)
                if end <= len(self.words):  # an option whose value is missing has none to change
                    yield i, end
            elif any(word.startswith(f"{name}=") for name in option.opts if name.startswith("--")):
                yield i, i + 1

    def knows(self, word: str) -> bool:
        """Is it an option of the command?"""
        return any(word in option.opts for option in self.command.params)

    def length(self, mm: str) -> str:
        """A length, mm, as it is typed behind these words: with its unit where they have others."""
        units = [
            self.words[end - 1].rpartition("=")[2]
            for option in self.command.params
            if "--units" in option.opts
            for _, end in self.typed(option)
        ]
        return length_among(mm, units[-1] if units else "mm")

    def in_its_units(self, word: str) -> str:
        """A word to be added, the unit of a length only where these words have others."""
        return self.length(word[:-2]) if re.fullmatch(r"[\d.]+mm", word) else word

    @property
    def spoken_of(self) -> list[click.Parameter]:
        """The options that the refusal names, or names what they set."""
        return [
            option
            for option in self.command.params
            if any(
                re.search(rf"{re.escape(said)}\b", self.said)
                for name in option.opts
                if name.startswith("--")
                for said in (name, name[2:].replace("-", " "))
            )
        ]


def cure_by_trial(group: click.Group, words: Sequence[str], said: str) -> str:
    """A sentence with the nearest command to the refused one that works, and what it gives; empty where none does.

    Parameters
    ----------
    group : click.Group
        The command `elastica`.
    words : sequence of str
        What was typed behind it.
    said : str
        The refusal.
    """
    if TRYING.get() or "-" in words:  # standard input has been read
        return ""
    # trials write elsewhere, and would prove nothing
    if re.search("choose another (folder|place)|exists already|name a folder before", said):
        return ""
    for mended, result in _mended(group, tuple(words), said):
        return f"This works: {mended}, then `{command_line(*words)}`{result}."
    for changed in islice(dict.fromkeys(_changes(group, tuple(words), said)), MOST_TRIALS):
        gave, _ = _run(group, changed)
        if gave is not None:
            return f"This works: `{command_line(*changed)}`{gave}."
    return ""


def _mended(group: click.Group, words: Words, said: str) -> Iterator[tuple[str, str]]:
    """What to write in a file of tables that was typed, and what the same command then gives."""
    for i, word in enumerate(words):
        path = Path(word)
        if path.suffix != ".toml" or not os.path.isfile(path):
            continue

        def run(file: Path, i: int = i) -> tuple[str | None, str]:
            return _run(group, (*words[:i], str(file), *words[i + 1 :]))

        with suppress(OSError):
            text = path.read_text(encoding="utf-8", errors="replace")
            yield from _mends_in_turn(path, text, said.replace(f"{path.parent}{sep}", ""), run, count(1))


def _mends_in_turn(
    path: Path, text: str, said: str, run: Callable[[Path], tuple[str | None, str]], trials: Iterator[int]
) -> Iterator[tuple[str, str]]:
    """What to write in a file until a run of it succeeds, one mend after another, and what it gives.

    The changed text is tried in a folder that shows all that stands beside the file.
    """
    beside = [one for one in path.absolute().parent.iterdir() if one.name != path.name]
    for changed, mend in mends(text, said, [one.name for one in beside]):
        if next(trials) > MOST_MENDS:
            return
        with TemporaryDirectory() as folder:
            for one in beside:
                (Path(folder) / one.name).symlink_to(one)
            tried = Path(folder) / path.name
            tried.write_text(changed, encoding="utf-8")
            gave, refusal = run(tried)
        told = mend.replace("{file}", path.name)
        if gave is not None:
            yield told, gave
        elif refusal:
            left = refusal.replace(f"{folder}{sep}", "")
            for others, then in _mends_in_turn(path, changed, left, run, trials):
                yield f"{told}, {others}", then


SPOKEN = ("--watch", "--json", "-q", "--quiet", "-v", "--verbose")
"""How a command speaks, which a trial leaves out."""


def _run(group: click.Group, words: Words) -> tuple[str | None, str]:
    """What a command gives: its first line with a number, files thrown away; None where it is refused, and why."""
    from click.testing import CliRunner

    command = group.commands.get(words[0])
    if command is None:
        return None, ""
    token = TRYING.set(True)
    try:
        with TemporaryDirectory() as folder:
            aside = ("-o", folder) if any("-o" in option.opts for option in command.params) else ()
            ran = CliRunner().invoke(
                group, [*(word for word in words if word not in SPOKEN), *QUICK.get(words[0], ()), *aside]
            )
    finally:
        TRYING.reset(token)
    if ran.exit_code != 0:
        return None, ran.output.strip()
    lines = [line.strip() for line in ran.stdout.splitlines() if re.search(r"\d", line)]
    return (f", which gives: {lines[0].rstrip('.')}" if lines and folder not in lines[0] else ""), ""


def _changes(group: click.Group, words: Words, said: str) -> Iterator[Words]:
    """Commands to try, the likeliest first."""
    if not words:
        return
    if words[0] not in group.commands:
        for i in [i for i, word in enumerate(words) if word in group.commands][:1]:
            before = words[:i] if words[0].startswith("-") else ()
            yield *words[i:], *before  # options stand behind the command
        for near in get_close_matches(words[0], group.commands, n=1):
            yield near, *words[1:]
        return
    refused = _Refused(group.commands[words[0]], words[0], words[1:], said)
    for way in WAYS:
        for changed in way(refused):
            yield words[0], *changed


def _nearly_named(refused: _Refused) -> Iterator[Words]:
    """A word that names nothing, by the nearest name that is told, or by the nearest file in its folder."""
    told = re.findall(r"[\w.-]+", re.split("did you mean", refused.said, flags=re.IGNORECASE)[-1])
    told = told if "id you mean" in refused.said else []
    told += re.findall(r"'([^']*)'", refused.said.partition("is not one of")[2])
    for i, word in enumerate(refused.words):
        head, sign, value = word.rpartition("=") if word.startswith("--") else ("", "", word)
        if value not in refused.said:
            continue
        path = Path(value)
        lost = "." in value and not os.path.exists(path) and os.path.isdir(path.parent)
        near_ones = get_close_matches(value, told, n=2, cutoff=0.5) or told[:1]
        for near in near_ones or (_files_named_like(path) if lost else []):
            yield (*refused.words[:i], f"{head}{sign}{near}", *refused.words[i + 1 :])


def _files_named_like(path: Path) -> list[str]:
    """Files beside it whose names without their endings are nearly its own: another name is another curve."""
    beside: dict[str, list[str]] = {}
    for one in sorted(path.parent.iterdir()):
        beside.setdefault(one.stem.lower(), []).append(str(one))
    return [name for stem in get_close_matches(path.stem.lower(), beside, n=2) for name in beside[stem]]


def _respelt(refused: _Refused) -> Iterator[Words]:
    """A key inside a word (--end-tab 'lenght = 12') by the one that is told."""
    slip = re.search(r"unknown key '([^']+)'; did you mean (\w+)", refused.said)
    if slip is None:
        return
    for i, word in enumerate(refused.words):
        if re.search(rf"\b{re.escape(slip[1])}\b", word):
            meant = re.sub(rf"\b{re.escape(slip[1])}\b", slip[2], word)
            yield (*refused.words[:i], meant, *refused.words[i + 1 :])


def _chosen(refused: _Refused) -> Iterator[Words]:
    """One curve of a file that holds several."""
    count = re.search(r"--curve 1 \.\. --curve (\d+)", refused.said)
    if count is None:
        return
    typed = [span for one in refused.command.params if "--curve" in one.opts for span in refused.typed(one)]
    gone = {i for span in typed for i in range(*span)}
    rest = tuple(word for i, word in enumerate(refused.words) if i not in gone)
    for number in range(1, min(int(count[1]), MOST_TRIALS) + 1):
        yield (*rest, "--curve", str(number))


def _alone(refused: _Refused) -> Iterator[Words]:
    """The first of several files, as a pattern of the shell gives them."""
    extra = re.search(r"unexpected extra arguments? \((.*)\)", refused.said)
    more = extra[1].split(" ") if extra else []
    places = [i for i, word in enumerate(refused.words) if word in more]
    if places and [refused.words[i] for i in places] == more:
        yield tuple(word for i, word in enumerate(refused.words) if i not in places)


def _closer(refused: _Refused) -> Iterator[Words]:
    """Ends that the strip can reach."""
    far = re.search(r"the ends are ([\d.e+]+) mm apart, but the rod is only ([\d.e+]+) mm", refused.said)
    if far is None:
        return
    try:
        asked = refused.command.make_context(refused.name, list(refused.words)).params
        drawn = None if asked["curve"] is None else _drawn_curves(asked)[0]
    except (click.UsageError, ElasticaError, IndexError):
        return
    x, y = asked["start"] or ((0.0, 0.0) if drawn is None else drawn.evaluate(np.array(drawn.domain[0])))
    reach = float(far[2]) / float(far[1])
    (ends,) = (option for option in refused.command.params if "--to" in option.opts)
    more = ("--steps", "20")  # one step may be too long for a curve that is bent already
    for (start, end), share, added in product(refused.typed(ends), (0.9 * reach, 0.6 * reach), ((), more)):
        to_x, to_y = asked["end"]
        near = (
            refused.length(f"{x + share * (to_x - x):.4g}"),
            refused.length(f"{y + share * (to_y - y):.4g}"),
        )
        yield (*refused.words[: start + 1], *near, *refused.words[end:], *added)


def _drawn_curves(asked: dict[str, Any]) -> list[PlaneCurve]:
    """The curves of a file that were asked for."""
    drawing = read_drawing(asked["curve"], unit=asked["unit"])
    return [one.curve for one in drawing.chosen(asked["number"], asked["layer"])]


def _handled(refused: _Refused) -> Iterator[Words]:
    """Handles of `reshape` that make a map: those typed, pulled less far, or one corner of the box."""
    if refused.name != "reshape" or not re.search(r"handle|corner.? of the box|infinity", refused.said):
        return
    try:
        asked = refused.command.make_context(refused.name, list(refused.words)).params
        curves = _drawn_curves(asked)
    except (click.UsageError, ElasticaError):
        return
    if not curves:  # the one that was asked for is not there
        return
    (left, low), (right, high) = box_around_curves(curves)
    home = dict(zip(CORNERS, ((left, low), (right, low), (right, high), (left, high)), strict=True))
    places = given_of(asked, CORNERS)
    handles = asked["handles"]
    pulls = [option for option in refused.command.params if option.name in (*CORNERS, "handles")]
    gone = {i for option in pulls for span in refused.typed(option) for i in range(*span)}
    rest = tuple(word for i, word in enumerate(refused.words) if i not in gone)

    def towards(start: Sequence[float], end: Sequence[float], share: float) -> list[str]:
        return [refused.length(f"{a + share * (b - a):.6g}") for a, b in zip(start, end, strict=True)]

    for share in (1.0, 0.5, 0.2) if handles and places else (0.5, 0.2, 0.05):
        if places:
            moved = (
                (option_name(name), *towards(home[name], place, share)) for name, place in places.items()
            )
            yield (*rest, *chain.from_iterable(moved))
        elif len(handles) == 4:
            moved = (
                ("--handle", *towards(one[:2], one[2:], 0.0), *towards(one[:2], one[2:], share))
                for one in handles
            )
            yield (*rest, *chain.from_iterable(moved))
    yield (*rest, "--top-right", *towards((left, low), (right, high), PULLED))


def _within(refused: _Refused) -> Iterator[Words]:
    """A number that is told instead of one that was typed: use 8 mm or more. What it quotes comes first."""
    told = re.findall(r"(?:use|give|make it|at most|at least|below) (\d[\d.]*\d|\d)", refused.said)

    def unquoted(option: click.Parameter) -> bool:
        values = (refused.words[end - 1] for _, end in refused.typed(option))
        return not any(re.search(rf"(?<![\d.]){re.escape(value)}(?![\d.])", refused.said) for value in values)

    for number, option in product(told, sorted(refused.spoken_of, key=unquoted)):
        for start, end in refused.typed(option):
            if end == start + 2:
                told_as = refused.length(number) if isinstance(option.type, Length) else number
                yield (*refused.words[: start + 1], told_as, *refused.words[end:])


def _added(refused: _Refused) -> Iterator[Words]:
    """Words that the refusal asks for."""
    for pattern, words in ADDED:
        if re.search(pattern, refused.said) and refused.knows(words[0]) and words[0] not in refused.words:
            yield (*refused.words, *map(refused.in_its_units, words))


def _dropped(refused: _Refused) -> Iterator[Words]:
    """Without an option that the refusal speaks of."""
    for option in refused.spoken_of:
        for start, end in refused.typed(option):
            yield (*refused.words[:start], *refused.words[end:])


WAYS: tuple[Callable[[_Refused], Iterator[Words]], ...] = (
    _alone, _respelt, _nearly_named, _chosen, _closer, _handled, _within, _added, _dropped,
)  # fmt: skip
