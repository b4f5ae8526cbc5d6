"""What a refusal of a curve ends with: the command that makes a strip of it after all, tried, and what it costs."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias

import click
import numpy as np

from elastica_cad.cli.running.typed_command import (
    TRYING,
    TYPED,
    command_line,
    cure_later,
    typed_length,
    while_short,
)
from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.fabrication.makeability.splices import SPLICED
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.forming.rounding_verdict import undecided_by_rounding
from elastica_cad.geometry.curve_editing.slight_corners import smooth_for_corners
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.trim import split_at_corners
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.theorem1.verdict import NotRealizable

Answer: TypeAlias = tuple[Rod | NearestRod, Strip]

NEAREST = "--nearest"

SPLIT = "--split-corners"

MOST_PIECES = 24
"""Of a curve that is cut at its corners to see whether strips take them."""

LEFT_OUT = (NEAREST, SPLIT, "--all")
"""Words typed that a cure says anew, or that would bring the other curves back."""

LEAST_TOLD_MM = 1e-3
"""Smaller distances are told as this one."""

TRIED_SHEETS = ("birch-plywood-0.8", "pom-0.5", "card-200gsm", "spring-steel-0.2")
"""What people have, for a curve whose sheet is not said: wood, plastic, card, steel."""

WIDTHS_MM = (8.0, 120.0)
"""Of a strip for a curve of which no width is said."""

LAP_THICKNESSES = 20
"""Of the plates that join a strip of pieces: glue holds as well as the sheet from a dozen on."""

USUAL_WIDTH_SHARE = 0.1
"""Of a curve's length: a strip for it where a width was asked for that makes a plate."""

NEAR_SHARE = 0.01
"""Of the length: a strip that comes so near looks as drawn."""


def _typed_line(*added: str, instead: str | None = None) -> str:
    """The running command as it was typed with options behind it, which outweigh those of the same name before.

    `instead` names another command that takes the same options, but for those that print.
    """
    context = click.get_current_context()
    words: Sequence[str] = context.meta.get(TYPED, ())
    if instead is not None:
        words = [instead if word == context.info_name else word for word in words if word != "--json"]
    return command_line(*(word for word in words if word not in LEFT_OUT), *added)


def explained(
    problem: ElasticaError,
    spec: StripSpec,
    *,
    which: Sequence[str] = (),
    whole: PlaneCurve | None = None,
    cured: bool = True,
) -> ElasticaError:
    """The refusal of a request as it is told: whether the file's digits decide it, and what would work.

    Parameters
    ----------
    problem : ElasticaError
    spec : StripSpec
    which : sequence of str
        Words that choose its curve in its file, where several were asked for.
    whole : PlaneCurve, optional
        The curve as drawn, where that of the request is a piece between its corners.
    cured : bool
        Have a command that would work looked for, once the refusal is told.
    """
    told = problem
    if isinstance(problem, NotRealizable):
        doubt = undecided_by_rounding(spec.curve, False, spec.smooth, spec.supports)
        if doubt:
            told = InputError(f"{doubt} As it stands: {problem}")
    if cured:
        cure_later(told, lambda: _cure_for(spec, which, whole))
    else:
        told.look_for_cure = str  # gives none
    return told


def _cure_for(spec: StripSpec, which: Sequence[str], whole: PlaneCurve | None) -> str:
    """A sentence with a command that makes a strip of this request after all; empty where none was found.

    The ways are tried in order, and the first that succeeds is told: the nearest curve within sheet and widths,
    then with a free end, then a wider strip; of a curve with corners the strips between them before that.
    """
    if TRYING.get():
        return ""
    spec = spec if whole is None else spec.changed(curve=whole)
    pieces = (np.inf, "")
    if not (spec.may_change or spec.slots or _slight(spec.curve, spec.smooth)):
        freed = {"limits": Limits(), "keep": Keep()}
        pieces = _in_pieces(spec.curve, which, spec.changed, (((), {}), ((NEAREST,), freed)))
    for added, fields in while_short(_ways(spec)):
        answer = _solved(spec.changed, **fields)
        if answer is not None:
            smoothed = spec.changed(**fields).rod_spec.smoothing.moved
            off = answer[0].deviation if isinstance(answer[0], NearestRod) else smoothed
            return _cure_in_words(pieces, off, f"`{_typed_line(*added, *which)}` {_costs(*answer, smoothed)}")
    return _cure_in_words(pieces)


def cure_for_curve(
    drawn: PlaneCurve,
    supports: Supports,
    natural_curvature: NaturalCurvature,
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
    asked: dict[str, Any] = {"max_width": width, "supports": supports}
    freed: dict[str, Any] = {"limits": Limits(), "keep": Keep()}
    slight = _slight(drawn, smooth)

    def strip(curve: PlaneCurve, sheet: str, **fields: Any) -> StripSpec:
        return StripSpec(curve, sheet, **asked, **{"smooth": smooth, **fields})

    def words(sheet: str, *added: str) -> tuple[str, ...]:
        return ("--sheet", sheet, "--max-width", typed_length(width), *added)

    if slight and file is None:
        for sheet in while_short(TRIED_SHEETS):
            answer = _solved(strip, drawn, sheet, smooth=slight)
            if answer is not None and _bears(answer[1]):
                smoothed = strip(drawn, sheet, smooth=slight).rod_spec.smoothing.moved
                typed = _typed_line(*words(sheet, "--smooth", typed_length(slight)), *which, instead="strip")
                return _cure_in_words((np.inf, ""), smoothed, f"`{typed}` {_costs(*answer, smoothed)}")
    tries = [(words(sheet, *added), {"sheet": sheet} | more) for sheet in TRIED_SHEETS
             for added, more in (((), {}), ((NEAREST,), freed))]  # fmt: skip
    pieces = (np.inf, "") if file else _in_pieces(drawn, which, strip, tries, instead="strip")
    found: list[tuple[NearestRod, Strip]] = []
    for sheet in while_short(TRIED_SHEETS):
        answer = _solved(strip, drawn, sheet, **freed)
        if answer is None or not isinstance(answer[0], NearestRod):
            continue
        found.append((answer[0], answer[1]))
        if answer[0].deviation < NEAR_SHARE * drawn.length:
            break
    if not found:
        return _cure_in_words(pieces)
    near, made = min(found, key=lambda one: one[0].deviation)
    added = (*words(made.sheet.name, NEAREST), *which)
    typed = _typed_line(*added, instead="strip") if file is None else command_line("strip", str(file), *added)
    return _cure_in_words(pieces, near.deviation, f"`{typed}` {_costs(near, made)}")


def _cure_in_words(pieces: tuple[float, str], off: float = np.inf, whole: str = "") -> str:
    """The cure: strips between the corners where they come nearer, one strip for all, or both."""
    apart, said = pieces
    if said and whole and apart <= off:
        return f"This works: {said}. Or one strip for all of it: {whole}."
    told = whole or said
    return f"This works: {told}." if told else ""


def _in_pieces(
    drawn: PlaneCurve,
    which: Sequence[str],
    asked: Callable[..., StripSpec],
    tries: Sequence[tuple[tuple[str, ...], dict[str, Any]]],
    *,
    instead: str | None = None,
) -> tuple[float, str]:
    """How near strips between the corners of a curve come, mm, and the command that makes them with what it gives.

    Of the tries, words to add and the fields that they change, the first is told that makes every piece within the
    strain of its sheet and within a hundredth of the length, else the one that comes nearest.
    """
    pieces = split_at_corners(drawn)
    best: tuple[float, str] = (np.inf, "")
    for added, fields in while_short(tries if 1 < len(pieces) <= MOST_PIECES else ()):
        made: list[Answer] = []
        for piece in pieces:
            answer = _solved(asked, curve=piece, **fields)
            if answer is None or not _bears(answer[1]):
                break
            made.append(answer)
        off = max((one.deviation if isinstance(one, NearestRod) else 0.0 for one, _ in made), default=np.inf)
        if len(made) == len(pieces) and off < best[0]:
            typed = _typed_line(*added, SPLIT, *which, instead=instead)
            ratio = max(strip.rod.ratio for _, strip in made)
            best = (
                off,
                (
                    f"`{typed}` makes {len(made)} strips that meet at the corners, each "
                    f"{_off(off) if off else 'as drawn'}, ratio at most {ratio:.2g}"
                ),
            )
            if off < NEAR_SHARE * drawn.length:
                break
    return best


def _bears(made: Strip) -> bool:
    return made.max_strain <= made.strain_limit * (1 + 1e-6)


def _off(deviation: float) -> str:
    return f"within {max(deviation, LEAST_TOLD_MM):.2g} mm of the drawn curve"


def _solved(asked: Callable[..., StripSpec], *values: Any, **fields: Any) -> Answer | None:
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
    if spec.max_width is not None and spec.max_width > spec.curve.length:
        narrower = float(f"{USUAL_WIDTH_SHARE * spec.curve.length:.2g}")
        yield ("--max-width", typed_length(narrower)), {"max_width": narrower}
    flat = spec.curve.length + sum(tab.length for tab in spec.ends)
    sheets = [spec.material, *([spec.style.backing] if isinstance(spec.style, Laminated) else [])]
    too_long = flat > min(spec.shop.stock_for(sheet)[0] for sheet in sheets)
    if too_long and spec.shop.lap is None:
        lap = round(LAP_THICKNESSES * max(sheet.thickness for sheet in sheets))
        joined = {"shop": replace(spec.shop, lap=float(lap))}
        yield ("--lap", typed_length(lap)), joined
        yield ("--lap", typed_length(lap), NEAREST), joined | {"limits": limits, "keep": keep}
    slight = _slight(spec.curve, spec.smooth)
    if slight and not spec.may_change:
        yield ("--smooth", typed_length(slight)), {"smooth": slight}
    if not spec.may_change:
        yield (NEAREST,), {"limits": limits, "keep": keep}
    if keep.both_ends == (True, True):
        freed = replace(keep, ends=(True, False))
        yield (NEAREST, "--keep-ends", "start"), {"limits": limits, "keep": freed}
    if spec.max_width is not None:
        wider = round(2 * spec.max_width, 3)
        yield (
            ("--max-width", typed_length(wider), NEAREST),
            {"limits": limits, "keep": keep, "max_width": wider},
        )


def _slight(drawn: PlaneCurve, smooth: float | None) -> float | None:
    """The distance, mm, within which slight corners are taken out, where no other was asked for."""
    return smooth_for_corners(drawn) if smooth is None else None


def _costs(found: Rod | NearestRod, made: Strip, smoothed: float = 0.0) -> str:
    """What a strip gives up for being made; `smoothed`: how far its curve was moved to be fair, mm."""
    off = f"stays {_off(smoothed)}" if smoothed else "keeps the drawn curve"
    if isinstance(found, NearestRod):
        off = f"bends to {_off(found.deviation)}"
    joined = "".join(f", {text}" for text in made.warnings if text.startswith(SPLICED))
    strain = 100 * made.max_strain / made.strain_limit
    return (
        f"{off}, ratio {made.rod.ratio:.2g}, {strain:.0f} % of the strain that "
        f"{made.sheet.name} bears{joined}"
    )
