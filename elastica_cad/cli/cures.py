"""What a refusal ends with: the command that would work, tried before it is said, and what it costs."""

import re
import shlex
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from contextvars import ContextVar
from dataclasses import dataclass, replace
from difflib import get_close_matches
from itertools import chain, islice, product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeAlias

import click
import numpy as np

from elastica_cad.cli.running.design_mends import mends
from elastica_cad.cli.running.program import name_program
from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication.makeability.splices import SPLICED
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.styles import Plain
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.files import read_drawing
from elastica_cad.formats.design_files.reshaping import CORNERS, box_around
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.rod.rod_record import Rod

Words: TypeAlias = tuple[str, ...]

MOST_TRIALS = 6
"""Commands that are run before a refusal is told without one."""

TRYING: ContextVar[bool] = ContextVar("elastica.trying", default=False)
"""Does a command run to see whether it works? It then looks for no cure of its own."""

QUICK = {"model": ("--no-step", "--no-pictures", "--no-effects", "--no-parts")}
"""Options that leave out of a trial what cannot make it fail."""

ADDED = (
    (r"--sheet", ("--sheet", "birch-plywood-0.8")),
    (r"--max-width", ("--max-width", "20")),
    (r"planes to cut", ("--radial", "8")),
    (r"length of a straight strip|CURVE", ("--straight", "300", "--to", "200", "0")),
    (r"no rest shape|of the path|continu", ("--steps", "20")),
    (r"no rest shape|of the path|continu", ("--steps", "100")),
    (r"split", ("--split-corners", "20")),
    (r"--force", ("--force",)),
    (r"--unit", ("--unit", "mm")),
    (r"--unit", ("--unit", "cm")),
    (r"--unit", ("--unit", "m")),
    (r"", ("--nearest",)),
    (r"--anyway", ("--anyway",)),
)
"""Words that are added where a command knows them and its refusal speaks of them: (pattern, words)."""


TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

NEAREST = "--nearest"

TRIED_SHEETS = ("birch-plywood-0.8", "pom-0.5", "card-200gsm", "spring-steel-0.2")
"""What people have, for a curve whose sheet is not said: wood, plastic, card, steel."""

WIDTHS_MM = (8.0, 120.0)
"""Of a strip for a curve of which no width is said."""

LAP_THICKNESSES = 20
"""Of the plates that join a strip of pieces: glue holds as well as the sheet from a dozen on."""

PULLED = 1.1
"""Of the box: where a corner of it goes when nobody says."""

NEAR_SHARE = 0.01
"""Of the length: a strip that comes so near looks as drawn."""


def _typed_command(*added: str, instead: str | None = None) -> str:
    """The running command as it was typed with options behind it, which outweigh those of the same name before.

    `instead` names another command that takes the same options, but for those that print.
    """
    context = click.get_current_context()
    words: Sequence[str] = context.meta.get(TYPED, ())
    if instead is not None:
        words = [instead if word == context.info_name else word for word in words if word != "--json"]
    return _command(*(word for word in words if word != NEAREST), *added)


def _command(*words: str) -> str:
    """A command as it is typed."""
    return f"{name_program()} {shlex.join(words)}"


def cure_for(spec: StripSpec) -> str:
    """A sentence with a command that makes a strip of this request after all; empty where none was found.

    The ways are tried in order, and the first that succeeds is told: the nearest curve within sheet and widths,
    then with a free end, then a wider strip.
    """
    for added, fields in () if TRYING.get() else _ways(spec):
        answer = _solved(spec.changed, **fields)
        if answer is not None:
            return f"This works: `{_typed_command(*added)}` {_costs(*answer)}."
    return ""


def cure_for_curve(
    drawn: PlaneCurve,
    supports: Supports,
    natural_curvature: float,
    smooth: float | None,
    which: Sequence[str],
    *,
    file: Path | None = None,
) -> str:
    """A sentence with the command `elastica strip` that comes nearest to a curve that no strip takes.

    Of the sheets tried the first within a hundredth of the length is told, else the one that comes nearest.

    Parameters
    ----------
    drawn : PlaneCurve
    supports, natural_curvature, smooth
        As asked of the check.
    which : sequence of str
        Words that choose this curve in its file.
    file : Path, optional
        That holds the curve, where it is not the one that was typed.
    """
    if natural_curvature or TRYING.get():
        return ""
    width = float(np.clip(round(drawn.length / 12), *WIDTHS_MM))
    found: list[tuple[NearestRod, Strip]] = []
    for sheet in TRIED_SHEETS:
        asked = {"max_width": width, "supports": supports, "smooth": smooth}
        answer = _solved(StripSpec, drawn, sheet, limits=Limits(), keep=Keep(), **asked)
        if answer is None or not isinstance(answer[0], NearestRod):
            continue
        found.append((answer[0], answer[1]))
        if answer[0].deviation < NEAR_SHARE * drawn.length:
            break
    if not found:
        return ""
    near, made = min(found, key=lambda one: one[0].deviation)
    words = ["--sheet", made.sheet.name, "--max-width", f"{width:g}", NEAREST, *which]
    typed = _typed_command(*words, instead="strip") if file is None else _command("strip", str(file), *words)
    return f"This works: `{typed}` {_costs(near, made)}."


def _solved(
    asked: Callable[..., StripSpec], *values: Any, **fields: Any
) -> tuple[Rod | NearestRod, Strip] | None:
    """What answers a request, and its strip, where there is one."""
    try:
        spec = asked(*values, **fields)
        found = spec.rod_spec.solve()
        return found, spec.make(found)
    except ElasticaError:
        return None


def _ways(spec: StripSpec) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    """Words to add and the fields that they change, the smallest change first."""
    if spec.natural_curvature or spec.loads or spec.samples is not None:
        return  # such strips follow their curve exactly
    limits, keep = spec.limits or Limits(), spec.keep or Keep()
    flat = spec.curve.length + sum(tab.length for tab in spec.ends)
    too_long = flat > spec.shop.stock_for(spec.material)[0]
    if too_long and spec.shop.lap is None and isinstance(spec.style, Plain):
        lap = round(LAP_THICKNESSES * spec.material.thickness)
        joined = {"shop": replace(spec.shop, lap=float(lap))}
        yield ("--lap", f"{lap}"), joined
        yield ("--lap", f"{lap}", NEAREST), joined | {"limits": limits, "keep": keep}
    if not spec.may_change:
        yield (NEAREST,), {"limits": limits, "keep": keep}
    if keep.both_ends == (True, True):
        freed = replace(keep, ends=(True, False))
        yield (NEAREST, "--keep-ends", "start"), {"limits": limits, "keep": freed}
    if spec.max_width is not None:
        wider = round(2 * spec.max_width, 3)
        yield ("--max-width", f"{wider:g}", NEAREST), {"limits": limits, "keep": keep, "max_width": wider}


def _costs(found: Rod | NearestRod, made: Strip) -> str:
    """What a strip gives up for being made."""
    off = f"bends to within {found.deviation:.2g} mm of" if isinstance(found, NearestRod) else "keeps"
    joined = "".join(f", {text}" for text in made.warnings if text.startswith(SPLICED))
    strain = 100 * made.max_strain / made.strain_limit
    return (
        f"{off} the drawn curve, ratio {made.rod.ratio:.2g}, {strain:.0f} % of the strain that "
        f"{made.sheet.name} bears{joined}"
    )


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
                yield i, i + 1 + (0 if flag else option.nargs)
            elif any(word.startswith(f"{name}=") for name in option.opts if name.startswith("--")):
                yield i, i + 1

    def knows(self, word: str) -> bool:
        """Is it an option of the command?"""
        return any(word in option.opts for option in self.command.params)

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
    for mended, result in _mended(group, tuple(words), said):
        return f"This works: {mended}, then `{_command(*words)}`{result}."
    for changed in islice(dict.fromkeys(_changes(group, tuple(words), said)), MOST_TRIALS):
        gave = _run(group, changed)
        if gave is not None:
            return f"This works: `{_command(*changed)}`{gave}."
    return ""


def _mended(group: click.Group, words: Words, said: str) -> Iterator[tuple[str, str]]:
    """What to write in a file of tables that was typed, and what the same command then gives.

    The changed file is tried in a folder that shows all that stands beside the file.
    """
    for i, word in enumerate(words):
        path = Path(word)
        if path.suffix != ".toml" or not path.is_file():
            continue
        beside = [one for one in path.absolute().parent.iterdir() if one.name != path.name]
        text = path.read_text(encoding="utf-8", errors="replace")
        for changed, told in islice(mends(text, said, [one.name for one in beside]), MOST_TRIALS):
            with TemporaryDirectory() as folder, suppress(OSError):
                for one in beside:
                    (Path(folder) / one.name).symlink_to(one)
                tried = Path(folder) / path.name
                tried.write_text(changed, encoding="utf-8")
                gave = _run(group, (*words[:i], str(tried), *words[i + 1 :]))
                if gave is not None:
                    yield told.format(file=path.name), gave


SPOKEN = ("--watch", "--json", "-q", "--quiet", "-v", "--verbose")
"""How a command speaks, which a trial leaves out."""


def _run(group: click.Group, words: Words) -> str | None:
    """What a command gives: its first line with a number, its files thrown away; None where it is refused."""
    from click.testing import CliRunner

    command = group.commands.get(words[0])
    if command is None:
        return None
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
        return None
    lines = [line.strip() for line in ran.stdout.splitlines() if re.search(r"\d", line)]
    return f", which gives: {lines[0].rstrip('.')}" if lines and folder not in lines[0] else ""


def _changes(group: click.Group, words: Words, said: str) -> Iterator[Words]:
    """Commands to try, the likeliest first."""
    if not words:
        return
    if words[0] not in group.commands:
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
        lost = "." in value and not path.exists() and path.parent.is_dir()
        names = told or ([str(one) for one in path.parent.iterdir()] if lost else [])
        for near in get_close_matches(value, names, n=2, cutoff=0.5) or names[:1]:
            yield (*refused.words[:i], f"{head}{sign}{near}", *refused.words[i + 1 :])


def _chosen(refused: _Refused) -> Iterator[Words]:
    """One curve of a file that holds several."""
    count = re.search(r"--curve 1 \.\. --curve (\d+)", refused.said)
    for number in range(1, min(int(count[1]), MOST_TRIALS) + 1) if count else ():
        yield (*refused.words, "--curve", str(number))


def _closer(refused: _Refused) -> Iterator[Words]:
    """Ends of a straight strip that it can reach."""
    far = re.search(r"the ends are ([\d.e+]+) mm apart, but the rod is only ([\d.e+]+) mm", refused.said)
    if far is None or "--straight" not in refused.words or "--from" in refused.words:
        return
    share = 0.9 * float(far[2]) / float(far[1])
    (ends,) = (option for option in refused.command.params if "--to" in option.opts)
    for start, end in refused.typed(ends):
        near = [f"{share * float(value):.4g}" for value in refused.words[start + 1 : end]]
        yield (*refused.words[: start + 1], *near, *refused.words[end:])


def _handled(refused: _Refused) -> Iterator[Words]:
    """Handles of `reshape` that make a map: those typed, pulled less far, or one corner of the box."""
    if refused.name != "reshape" or not re.search(r"handle|corner.? of the box|infinity", refused.said):
        return
    try:
        asked = refused.command.make_context(refused.name, list(refused.words)).params
        drawing = read_drawing(asked["curve"], unit=asked["unit"])
        curves = [one.curve for one in drawing.chosen(asked["number"], asked["layer"])]
    except (click.UsageError, ElasticaError):
        return
    (left, low), (right, high) = box_around(curves)
    home = dict(zip(CORNERS, ((left, low), (right, low), (right, high), (left, high)), strict=True))
    places = {name: asked[name] for name in CORNERS if asked[name] is not None}
    handles = asked["handles"]
    pulls = [option for option in refused.command.params if option.name in (*CORNERS, "handles")]
    gone = {i for option in pulls for span in refused.typed(option) for i in range(*span)}
    rest = tuple(word for i, word in enumerate(refused.words) if i not in gone)

    def towards(start: Sequence[float], end: Sequence[float], share: float) -> list[str]:
        return [f"{a + share * (b - a):.6g}" for a, b in zip(start, end, strict=True)]

    for share in (1.0, 0.5, 0.2) if handles and places else (0.5, 0.2, 0.05):
        if places:
            moved = ((_option(name), *towards(home[name], place, share)) for name, place in places.items())
            yield (*rest, *chain.from_iterable(moved))
        elif len(handles) == 4:
            moved = (
                ("--handle", *towards(one[:2], one[2:], 0.0), *towards(one[:2], one[2:], share))
                for one in handles
            )
            yield (*rest, *chain.from_iterable(moved))
    yield (*rest, "--top-right", *towards((left, low), (right, high), PULLED))


def _option(name: str) -> str:
    """The option that sets a parameter."""
    return f"--{name.replace('_', '-')}"


def _within(refused: _Refused) -> Iterator[Words]:
    """A number that is told instead of one that was typed: use 8 mm or more."""
    told = re.findall(r"(?:use|give|make it|at most|at least|below) (\d[\d.]*\d|\d)", refused.said)
    for number, option in product(told, refused.spoken_of):
        for start, end in refused.typed(option):
            if end == start + 2:
                yield (*refused.words[: start + 1], number, *refused.words[end:])


def _added(refused: _Refused) -> Iterator[Words]:
    """Words that the refusal asks for."""
    for pattern, words in ADDED:
        if re.search(pattern, refused.said) and refused.knows(words[0]) and words[0] not in refused.words:
            yield (*refused.words, *words)


def _dropped(refused: _Refused) -> Iterator[Words]:
    """Without an option that the refusal speaks of."""
    for option in refused.spoken_of:
        for start, end in refused.typed(option):
            yield (*refused.words[:start], *refused.words[end:])


WAYS: tuple[Callable[[_Refused], Iterator[Words]], ...] = (
    _nearly_named, _chosen, _closer, _handled, _within, _added, _dropped,
)  # fmt: skip
