# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The verdict on a curve in three states, in colour and words."""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from freecad.elastica_wb.host.resources import translate

from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.geometry.curves.curve_records import CurveSamples
from elastica_cad.mechanics.loads.rest_curvature import nodal_curvature
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck, NotRealizable

SLENDER = 2.0  # times its width a strip must be long before it bends as a rod does


class Verdict(Enum):
    """Can a flat strip take the curve?"""

    CAN = "can"
    BREAKS = "breaks"
    CANNOT = "cannot"
    NOTHING = "nothing"  # is drawn yet


@dataclass(frozen=True)
class Answer:
    """A verdict, its few words, and the sentence that explains it."""

    verdict: Verdict
    words: str
    sentence: str


def quick_answer(samples: CurveSamples, spec: StripSpec, check: EquilibriumCheck) -> Answer:
    """What can be said at once: balance, the skin's strain, whether the strip is one."""
    if not check.realizable:
        return Answer(Verdict.CANNOT, translate("Elastica", "cannot"), sentence_of(check))
    spoiled = _too_wide(check.length, spec.max_width) or _too_sharp(samples, spec)
    return spoiled or Answer(Verdict.CAN, translate("Elastica", "can"), sentence_of(check))


def strip_answer(strip: Strip) -> Answer:
    """What a strip says of itself."""
    spoiled = _too_wide(strip.rod.length, strip.width.extremes[1])
    if spoiled is not None:
        return spoiled
    if _used(strip) > 1:
        strained = [line for line in strip.warnings if line.startswith("strain")]
        return Answer(Verdict.BREAKS, _breaks(_used(strip)), (strained or [sentence_of(strip)])[0])
    return Answer(Verdict.CAN, translate("Elastica", "can"), sentence_of(strip))


def refusal_answer(error: ElasticaError) -> Answer:
    """Why there is no strip: the curve, or what is asked of the strip."""
    if isinstance(error, NotRealizable):
        return Answer(Verdict.CANNOT, translate("Elastica", "cannot"), sentence_of(error))
    return Answer(Verdict.BREAKS, translate("Elastica", "cannot be made"), sentence_of(error))


def sentence_of(answer: EquilibriumCheck | Strip | ElasticaError) -> str:
    """One sentence for the status bar."""
    if isinstance(answer, Strip):
        low, high = answer.width.extremes
        return (
            f"A flat strip takes this curve: {low:.3g} to {high:.3g} mm wide, stiffness ratio "
            f"{answer.rod.ratio:.3g}, strain {100 * _used(answer):.0f} % of what the sheet bears."
        )
    if isinstance(answer, NotRealizable):
        return answer.check.reasons[0]
    if isinstance(answer, ElasticaError):
        return str(answer)
    return answer.reasons[0] if answer.reasons else str(answer).split(". ")[0].rstrip(".") + "."


def _too_wide(length: float, width: float | None) -> Answer | None:
    if width is None or length >= SLENDER * width:
        return None
    words = (
        f"The strip would be {width:.3g} mm wide and {length:.3g} mm long: a strip bends as computed where it is "
        f"{SLENDER:.0f} times as long as wide; draw a longer curve, or make the strip narrower."
    )
    return Answer(Verdict.BREAKS, translate("Elastica", "too short for its width"), words)


def _too_sharp(samples: CurveSamples, spec: StripSpec) -> Answer | None:
    bend = np.abs(samples.curvature - nodal_curvature(spec.natural_curvature, samples.s))
    sheet, sharpest = spec.material, int(np.argmax(bend))
    used = float(bend[sharpest]) * sheet.thickness / 2 / sheet.max_strain
    if used <= 1:
        return None
    place = float(samples.s[sharpest])
    words = (
        f"It would break at {place:.3g} mm: its radius there is {1 / bend[sharpest]:.3g} mm, the sheet bears "
        f"{used / bend[sharpest]:.3g} mm; use a thinner sheet or a gentler curve."
    )
    return Answer(Verdict.BREAKS, _breaks(used), words)


def _used(strip: Strip) -> float:
    """Share of the strain that the sheet bears."""
    return float(strip.max_strain / strip.strain_limit)


def _breaks(used: float) -> str:
    return f"{translate('Elastica', 'would break')}: {100 * used:.0f} %"
