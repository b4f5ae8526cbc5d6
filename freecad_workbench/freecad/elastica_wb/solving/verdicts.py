# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Verdicts on curves and strips (possible, impossible, would break), with reasons in words."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum

import numpy as np
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import together
from freecad.elastica_wb.solving.strip_cache import judged, solve_strip

from elastica_cad.design.reports import pre_bend_message
from elastica_cad.errors import (
    ElasticaError,
    Length,
    Refusal,
    Span,
    StrainError,
    note,
    sentences,
)
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import sharp_bend_message, sharpest_bend
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable, lengths
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec

SLENDER = 2.0
"""Least ratio of length to width of a strip that can be modelled as a rod."""

OFF_LINE = 1e-4
"""Tolerance of `check_equilibrium` for inflections on a line, as a fraction of the length."""

STEP_MM, STEP_SHARE = 0.2, 0.02
"""A step of the width is visible if it exceeds both limits: in mm, and as a fraction of the width."""


@dataclass(frozen=True)
class Fault:
    """A reason why a strip fails.

    Attributes
    ----------
    words : str
        Short text for a heading.
    sentence : str
        Text as a full sentence.
    number : str
        Name of the property with the result that is beyond its limit.
    curve_helps : bool
        True if the nearest curve within limits may avoid the fault.
    """

    words: str
    sentence: str
    number: str
    curve_helps: bool = True


def strip_faults(strip: Strip) -> Iterator[Fault]:
    """Yield the faults of a strip."""
    if (wide := width_fault(strip.rod.length, strip.width.extremes[1])) is not None:
        yield wide
    if not (strain := strip.strain_verdict).allowed:
        words = _strain_words(strain.percent, breaks=strain.refused)
        yield Fault(words, strip.strain_warnings[0], "LargestStrain")
    stability = judged(strip.rod)
    if stability is not None and not stability.stable:
        sentence = note(
            "the strip snaps into another shape; its stability margin is {margin:.3g}"
            if stability.conjugate_point is None else
            "the strip snaps into another shape; its stability margin is {margin:.3g}. A strip of the "
            "first {s} alone would be at the limit of stability",
            margin=stability.margin, s=Length(stability.conjugate_point or 0.0),
        )  # fmt: skip
        yield Fault(note("snaps into another shape"), sentence, "Margin")
    if strip.sideways.word == "unstable":
        yield Fault(note("tips over sideways"), str(strip.sideways), "SidewaysMargin", curve_helps=False)
    for warning in strip.rod.warnings if _has_visible_steps(strip.rod, strip.width.extremes[1]) else ():
        if isinstance(warning, Refusal) and warning.kind == "kinks":
            yield Fault(note("kinks in its width"), warning, "NarrowestWidth")


def _has_visible_steps(rod: Rod, widest: float) -> bool:
    """Return True if the width of a strip has visible steps. `widest` is the largest width, mm."""
    places = [*rod.profile.steps, *([(rod.length, 0.0)] if rod.curve.is_closed else [])]
    least, most = np.sort(rod.profile(np.array(places).reshape(-1, 2)), axis=1).T
    step = most - least
    return bool(np.any((step > STEP_SHARE * most) & (widest / rod.ratio * step > STEP_MM)))


def width_fault(length: float, width: float | None) -> Fault | None:
    """Return the fault of a strip that is too wide for its length (both mm), or None."""
    if width is None or length >= SLENDER * width:
        return None
    sentence = note(
        "The strip would be {width} wide and {length} long. It bends as computed only if its length is at "
        "least {times:.0f} times its width. Draw a longer curve, or make the strip narrower.",
        width=Length(width), length=Length(length), times=SLENDER,
    )  # fmt: skip
    return Fault(note("too short for its width"), sentence, "Length")


def _strain_words(percent: int, *, breaks: bool) -> str:
    return note(
        "would break: {percent} % of the strain limit"
        if breaks
        else "strain too large: {percent} % of the strain limit",
        percent=percent,
    )


def is_bent_beforehand(strip: Strip) -> bool:
    """Return True if a strip is pre-bent before assembly."""
    return bool(np.any(strip.rod.natural_curvature))


def pre_bend_messages(named_strips: Iterable[tuple[str, Strip]]) -> list[str]:
    """Return instructions for strips that must be pre-bent. Strips with equal pre-bends share an instruction."""
    return together((name, pre_bend_message(strip)) for name, strip in named_strips)


class Verdict(Enum):
    """Possible results of the check of a curve, in order of severity."""

    NOTHING = "nothing"
    CAN = "can"
    BREAKS = "breaks"
    CANNOT = "cannot"


@dataclass(frozen=True)
class Answer:
    """Result of a check: verdict, short text, explanation, and True if another curve may help."""

    verdict: Verdict
    words: str
    sentence: str
    curve_helps: bool = True


def quick_answer(curve: PlaneCurve, spec: StripSpec, check: EquilibriumCheck) -> Answer:
    """Return the result of the fast checks: equilibrium, surface strain, widths."""
    if check.undecided is not None or not check.realizable:
        return _impossible(check)
    fault = width_fault(check.length, spec.max_width)
    sharp = sharp_bend_message(spec.material, *sharpest_bend(curve, spec.natural_curvature))
    if fault is None and sharp is not None:
        words = _strain_words(sharp.values["percent"], breaks=sharp.values["breaks"])
        fault = Fault(words, sharp, "LargestStrain")
    return _failing([fault]) if fault else Answer(Verdict.CAN, translate("Elastica", "can"), check.verdict)


def answer_of(spec: StripSpec) -> Answer:
    """Return the result of the checks of the strip that a request describes."""
    try:
        return strip_answer(solve_strip(spec))
    except ElasticaError as error:
        return refusal_answer(error)


def strip_answer(strip: Strip) -> Answer:
    """Return the result of the checks of a finished strip."""
    faults, check = list(strip_faults(strip)), strip.rod.check
    if faults:
        return _failing(faults)
    if check is not None and check.undecided is not None:
        return _impossible(check)
    sentence = note(
        "A pre-bent strip can be bent into this curve: {width} wide, stiffness ratio {ratio:.3g}, strain {used} "
        "% of the sheet's limit." if is_bent_beforehand(strip) else
        "A flat strip can be bent into this curve: {width} wide, stiffness ratio {ratio:.3g}, strain {used} % "
        "of the sheet's limit.",
        width=Span.of(*strip.width.extremes), ratio=strip.rod.ratio, used=strip.strain_verdict.percent,
    )  # fmt: skip
    return Answer(Verdict.CAN, translate("Elastica", "can"), sentence)


def _failing(faults: list[Fault]) -> Answer:
    return Answer(
        Verdict.BREAKS,
        sentences((fault.words for fault in faults), "; "),
        sentences((fault.sentence for fault in faults), "\n"),
        any(fault.curve_helps for fault in faults),
    )


def refusal_answer(error: ElasticaError) -> Answer:
    """Return the result for an error caused by the curve or an option of the strip."""
    if isinstance(error, NotRealizable):
        return _impossible(error.check)
    sentence = str(error)
    words = (
        _strain_words(error.refusal.values["percent"], breaks=True)
        if isinstance(error, StrainError)
        else note("cannot be made: {reason}", reason=sentence)
    )
    return Answer(Verdict.BREAKS, words, sentence)


def _impossible(check: EquilibriumCheck) -> Answer:
    """Return the result for a curve that no strip can take, or whose points do not decide this."""
    if check.undecided is not None:
        return Answer(Verdict.BREAKS, note("undecided"), check.verdict)
    reason, places = check.reasons[0], lengths([*check.crossings, *check.touches])
    off = max((abs(distance) for _, distance in check.off_line), default=0.0)
    if isinstance(reason, Refusal) and "times" in reason.values:
        words = note(
            "radius {radius}, but the sheet needs {least}",
            radius=reason.values["radius"], least=reason.values["least"],
        )  # fmt: skip
    elif len(check.reasons) > 1:
        words = reason
    elif places:
        words = note("the inflection line meets the curve at {places}", places=places)
    elif off > OFF_LINE * check.length:
        words = note("inflections up to {off} off one line", off=Length(off))
    else:
        words = reason
    return Answer(Verdict.CANNOT, note("cannot: {reason}", reason=words), reason)
