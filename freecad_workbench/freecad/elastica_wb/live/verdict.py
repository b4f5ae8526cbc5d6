# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The verdict on a curve: can, cannot or breaks, with colour and words."""

from dataclasses import dataclass
from enum import Enum

from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.solving.bent_blanks import is_bent_beforehand
from freecad.elastica_wb.solving.strip_cache import sharpest_bend
from freecad.elastica_wb.solving.strip_faults import Fault, strain_words, strip_faults, width_fault

from elastica_cad.errors import ElasticaError, StrainError
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.mechanics.section_limits import judge_strain
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable
from elastica_cad.refusals import Length, Span, note, sentences
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec


class Verdict(Enum):
    """Possible verdicts on a curve."""

    CAN = "can"
    BREAKS = "breaks"
    CANNOT = "cannot"
    NOTHING = "nothing"  # no curve is drawn yet


@dataclass(frozen=True)
class Answer:
    """A verdict with a short text, an explanation, and whether another curve may help."""

    verdict: Verdict
    words: str
    sentence: str
    curve_helps: bool = True


def quick_answer(
    curve: PlaneCurve, samples: CurveSamples, spec: StripSpec, check: EquilibriumCheck
) -> Answer:
    """Return the verdict that needs no search: equilibrium, strain of the skin, widths."""
    if check.undecided is not None:
        return _undecided(check)
    if not check.realizable:
        return Answer(Verdict.CANNOT, translate("Elastica", "cannot"), sentence_of(check))
    fault = width_fault(check.length, spec.max_width) or _too_sharp(curve, samples, spec)
    return (
        _failing([fault]) if fault else Answer(Verdict.CAN, translate("Elastica", "can"), sentence_of(check))
    )


def strip_answer(strip: Strip) -> Answer:
    """Return the verdict on a finished strip."""
    faults, check = list(strip_faults(strip)), strip.rod.check
    if faults:
        return _failing(faults)
    if check is not None and check.undecided is not None:
        return _undecided(check)
    return Answer(Verdict.CAN, translate("Elastica", "can"), sentence_of(strip))


def _failing(faults: list[Fault]) -> Answer:
    return Answer(
        Verdict.BREAKS,
        sentences((fault.words for fault in faults), "; "),
        sentences((fault.sentence for fault in faults), "\n"),
        any(fault.curve_helps for fault in faults),
    )


def refusal_answer(error: ElasticaError) -> Answer:
    """Return the verdict for an error: the cause is the curve, or a request for the strip."""
    if isinstance(error, NotRealizable):
        if isinstance(error.check, EquilibriumCheck) and error.check.undecided is not None:
            return _undecided(error.check)
        return Answer(Verdict.CANNOT, translate("Elastica", "cannot"), sentence_of(error))
    if isinstance(error, StrainError):
        words = note("would break: {percent} %", percent=error.refusal.values["percent"])
        return Answer(Verdict.BREAKS, words, sentence_of(error))
    return Answer(Verdict.BREAKS, translate("Elastica", "cannot be made"), sentence_of(error))


def sentence_of(answer: EquilibriumCheck | Strip | ElasticaError) -> str:
    """Return an answer as one sentence for the status bar."""
    if isinstance(answer, Strip):
        return note(
            "A strip bent beforehand takes this curve: {width} wide, stiffness ratio {ratio:.3g}, strain "
            "{used} % of what the sheet bears." if is_bent_beforehand(answer) else
            "A flat strip takes this curve: {width} wide, stiffness ratio {ratio:.3g}, strain {used} % of "
            "what the sheet bears.",
            width=Span.of(*answer.width.extremes), ratio=answer.rod.ratio, used=answer.strain_verdict.percent,
        )  # fmt: skip
    if isinstance(answer, NotRealizable):
        return answer.check.reasons[0]
    if isinstance(answer, ElasticaError):
        return str(answer)
    return answer.reasons[0] if answer.reasons else answer.verdict


def _undecided(check: EquilibriumCheck) -> Answer:
    return Answer(Verdict.BREAKS, note("undecided"), check.verdict)


def _too_sharp(curve: PlaneCurve, samples: CurveSamples, spec: StripSpec) -> Fault | None:
    sheet = spec.material
    bend, place = sharpest_bend(curve, spec.natural_curvature, samples)
    judged = judge_strain(sheet, bend * sheet.thickness / 2, place)
    if judged.allowed:
        return None
    words = note(
        "It would break {s} from the start: its radius there is {radius}, the sheet bears {least}; use a "
        "thinner sheet or a gentler curve." if judged.refused else
        "It is strained beyond its limit {s} from the start: its radius there is {radius}, the sheet bears "
        "{least}; {outcome}; use a thinner sheet or a gentler curve.",
        s=Length(place), radius=Length(1 / bend), least=Length(judged.used / bend), outcome=note(judged.outcome),
    )  # fmt: skip
    return Fault(strain_words(judged), words, "LargestStrain")
