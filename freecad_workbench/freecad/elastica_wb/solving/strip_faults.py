# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Reasons why a strip fails although it can be made. Headline, card and numbers show them."""

from collections.abc import Iterator
from dataclasses import dataclass

from freecad.elastica_wb.solving.strip_cache import judged

from elastica_cad.forming.fairing_request import outline_steps
from elastica_cad.mechanics.section_limits import StrainVerdict
from elastica_cad.refusals import Length, Refusal, note
from elastica_cad.strip.strip import Strip

SLENDER = 2.0
"""Smallest ratio of length to width for which a strip bends as a rod."""


@dataclass(frozen=True)
class Fault:
    """A reason why a strip fails.

    Attributes
    ----------
    words : str
        A few words for a headline.
    sentence : str
    number : str
        Property of a strip with the number that is out of bounds.
    curve_helps : bool
        Whether the nearest curve within limits may be without it.
    """

    words: str
    sentence: str
    number: str
    curve_helps: bool = True


def strip_faults(strip: Strip) -> Iterator[Fault]:
    """Yield the faults of a strip."""
    if (wide := width_fault(strip.rod.length, strip.width.extremes[1])) is not None:
        yield wide
    if not strip.strain_verdict.allowed:
        yield Fault(strain_words(strip.strain_verdict), strip.strain_warnings[0], "LargestStrain")
    stability = judged(strip.rod)
    if stability is not None and not stability.stable:
        sentence = note(
            "it does not stay in this shape: the stability margin is {margin:.3g}"
            if stability.conjugate_point is None else
            "it does not stay in this shape: the stability margin is {margin:.3g} (conjugate point {s} from "
            "its start)",
            margin=stability.margin, s=Length(stability.conjugate_point or 0.0),
        )  # fmt: skip
        yield Fault(note("snaps into another shape"), sentence, "Margin")
    if strip.sideways.word == "unstable":
        yield Fault(note("tips over sideways"), str(strip.sideways), "SidewaysMargin", curve_helps=False)
    for warning in strip.rod.warnings if outline_steps(strip.rod, strip.width.extremes[1]) else ():
        if isinstance(warning, Refusal) and warning.kind == "kinks":
            yield Fault(note("kinks in its width"), warning, "NarrowestWidth")


def width_fault(length: float, width: float | None) -> Fault | None:
    """Return the fault of a strip that is too wide for its length (mm), or None."""
    if width is None or length >= SLENDER * width:
        return None
    sentence = note(
        "The strip would be {width} wide and {length} long: a strip bends as computed where it is "
        "{times:.0f} times as long as wide; draw a longer curve, or make the strip narrower.",
        width=Length(width), length=Length(length), times=SLENDER,
    )  # fmt: skip
    return Fault(note("too short for its width"), sentence, "Length")


def strain_words(verdict: StrainVerdict) -> str:
    """Return a short description of a strain that is not allowed."""
    return note(
        "would break: {percent} %" if verdict.refused else "beyond its limit: {percent} %",
        percent=verdict.percent,
    )
