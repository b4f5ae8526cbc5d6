"""What is told of a strip in words: how wide it is, how it closes, and what a maker should know before cutting."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from elastica_cad._counts import told_apart
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.held_shape import Reactions
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Bends
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.material.section_limits import LayerStrain
from elastica_cad.mechanics.material.sheet import PLYWOOD_SOURCE, TOLD_TO
from elastica_cad.mechanics.studies.creep import Creep
from elastica_cad.refusals import Length, Span, note

LINEAR_CREEP_SHARE = 0.5
"""Share of the strain limit above which creep grows faster than the stress."""

STRAIGHT_SHARE = 1e-6
"""Curvature, as a share of the largest, below which the strip counts as not bent."""

UNEVEN_JOINT_MM = 0.05
"""Difference between the widths of a closed strip's ends, mm, from which on it is reported."""


def tell_breadth(width: Profile, tapered: dict[str, Profile], digits: str) -> str:
    """Width of a strip in words, with the thickness if it varies."""
    told: dict[str, Any] = {
        name: Span.of(*size.extremes, digits) for name, size in {"width": width, **tapered}.items()
    }
    if "diameter" in told:
        return note("{diameter} in diameter", diameter=told["diameter"])
    return note("{width} wide, {thickness} thick" if "thickness" in told else "{width} wide", **told)


def backing_mark(curvature: FloatArray) -> str:
    """The word engraved on both sheets of a laminate: where their engraved faces look when it is bent.

    The backing lies on the right of the curve as it runs from its start, so outside where it bends to the left.
    Where the sense of bending changes the word is that of the first bend, with the end named.
    """
    small = STRAIGHT_SHARE * float(np.abs(curvature).max(initial=0.0))
    bent = curvature[np.abs(curvature) > small]
    if not bent.size:
        return ""
    word = "OUTSIDE" if bent[0] > 0 else "INSIDE"
    return word if np.all(np.sign(bent) == np.sign(bent[0])) else f"{word} AT START"


def tell_backing(mark: str) -> str:
    """Return a sentence on which side of the bend the backing lies; empty of a straight strip."""
    if not mark:
        return ""
    said = {
        "INSIDE": "bent, the backing lies inside: {mark} is engraved on both sheets, on the faces that look "
        "there",
        "OUTSIDE": "bent, the backing lies outside: {mark} is engraved on both sheets, on the faces that "
        "look there",
        "INSIDE AT START": "bent, the backing lies inside at the start (the end at x = 0 of the cutting "
        "files), on the other side of the bend beyond each inflection: {mark} is "
        "engraved on both sheets",
        "OUTSIDE AT START": "bent, the backing lies outside at the start (the end at x = 0 of the cutting "
        "files), on the other side of the bend beyond each inflection: {mark} is "
        "engraved on both sheets",
    }
    return note(said[mark], mark=mark)


def tell_joint(lap: float, width: float, held: Reactions, place: str) -> str:
    """Sentence on how a closed strip is joined at a place of this width, mm, and what the joint carries."""
    how = (
        note("glue its tab of {lap}, bent as drawn, behind its start", lap=Length(lap))
        if lap
        else note("join its ends butt to butt")
    )
    return note(
        "closed: {how} at {place}, where it is {width} wide; the joint carries {moment:.3g} N mm and "
        "{force:.2g} N",
        how=how, place=place, width=Length(width), moment=abs(held.end_moment), force=np.hypot(*held.end_force),
    )  # fmt: skip


def warn_of_strains(strains: Sequence[LayerStrain], bends: Bends) -> Iterator[str]:
    """Layers strained beyond what their sheets bear."""
    bend = bends.amount
    for layer in strains:
        at = layer.station
        judged = layer.judged(bends.place(at))
        if not judged.allowed:
            bearable = bend[at] * layer.limit / layer.largest
            strain, limit = told_apart(100 * layer.largest, 100 * layer.limit, ".2g")
            radius, least = told_apart(1 / bend[at], 1 / bearable, ".3g")
            yield note(
                "strain {strain:g} % at {at} from the start is beyond the {limit:g} % that {sheet} bears: "
                "its radius there is {radius:g}, the least advisable {least:g}; {outcome}; use a thinner "
                "sheet or a gentler curve",
                strain=strain, at=Length(judged.at or 0.0), limit=limit, sheet=layer.name, radius=Length(radius),
                least=Length(least), outcome=note(judged.outcome), severity="warning",
            )  # fmt: skip


def warn_of_width(width: Profile, length: float, *, closed: bool) -> Iterator[str]:
    """Ends that do not match where a strip closes, and strips wider than long."""
    start, end = width([0.0, length]).tolist()
    if closed and abs(end - start) > UNEVEN_JOINT_MM:
        yield note(
            "its ends are {start:.3g} and {end} wide where it closes: choose another joint, leave out "
            "gravity, or make the curvature continuous there",
            start=start, end=Length(end), severity="warning",
        )  # fmt: skip
    widest = float(width.extremes[1])
    if widest > length:
        yield note(
            "it is {width} wide and {length} long: what is wider than long bends as a plate, not as a "
            "strip; give a smaller max_width, and look at its unit",
            width=Length(widest), length=Length(length), severity="warning",
        )  # fmt: skip


def warn_of_plywood(layers: Sequence[Layer], strains: Sequence[LayerStrain], bends: Bends) -> Iterator[str]:
    """Plywood bent sharper than its published radii, where its strain has not told so."""
    bend = bends.amount
    tightest = int(np.argmax(bend))
    for one, layer in zip(layers, strains, strict=False):
        least = one.sheet.published_radius
        if least is not None and layer.judged().allowed and bend[tightest] * least > 1 + TOLD_TO:
            at = bends.place(tightest)
            yield note(
                "it bends to a radius of {radius} at {at} from the start, but plywood of {thickness:g} "
                "bends to {least} at least {grain} the face grain ({source}); use a thinner sheet or a "
                "gentler curve",
                radius=Length(1 / bend[tightest]), at=Length(at), thickness=Length(one.sheet.thickness),
                least=Length(least), grain=note(one.sheet.grain), source=PLYWOOD_SOURCE, severity="warning",
            )  # fmt: skip


def warn_of_creep(factor: float, strained: LayerStrain, crept: Callable[[], Creep | None]) -> Iterator[str]:
    """Warn of places where creep of the most strained layer is not linear, and of a strip that does not stay."""
    if strained.largest > LINEAR_CREEP_SHARE * strained.limit:
        yield note(
            "strain {strain:.2f} % is more than {share:.0f} % of what the sheet bears: creep is not linear "
            "there, and more than said; use a thinner sheet or a gentler curve",
            strain=100 * strained.largest, share=100 * LINEAR_CREEP_SHARE, severity="warning",
        )  # fmt: skip
    try:
        later = crept()
    except NotConvergedError as problem:
        yield str(problem)
        return
    if later is not None and not later.stays:
        yield note(
            "with a creep factor of {factor:g} it will not stay in the long run: it snaps into another "
            "shape; use a stiffer sheet or support it",
            factor=factor, severity="warning",
        )  # fmt: skip
