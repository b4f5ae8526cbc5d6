"""What is told of a strip in words: how wide it is, how it closes, and what a maker should know before cutting."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from elastica_cad._counts import told_apart, told_range
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.held_shape import Reactions
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.styles import Bends
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.material.section_limits import LayerStrain
from elastica_cad.mechanics.material.sheet import PLYWOOD_SOURCE, TOLD_TO
from elastica_cad.mechanics.studies.creep import Creep

LINEAR_CREEP_SHARE = 0.5
"""Of the strain limit: beyond it creep grows faster than the stress."""

STRAIGHT_SHARE = 1e-6
"""Of the largest curvature: less has no sense of bending."""

UNEVEN_JOINT_MM = 0.05
"""Difference between the widths of a closed strip's ends that is told: finer than it is cut."""


def tell_breadth(width: Profile, tapered: dict[str, Profile], digits: str) -> str:
    """How wide a strip is, and as thick as it tapers."""

    def told(size: Profile) -> str:
        return f"{told_range(*size.extremes, digits)} mm"

    if "diameter" in tapered:
        return f"{told(tapered['diameter'])} in diameter"
    wide = f"{told(width)} wide"
    return f"{wide}, {told(tapered['thickness'])} thick" if "thickness" in tapered else wide


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
    """On which side of the bend the backing lies, in a sentence; empty of a straight strip."""
    if not mark:
        return ""
    if mark.endswith("START"):
        word, *_ = mark.split()
        return (
            f"bent, the backing lies {word.lower()} at the start (the end at x = 0 of the cutting files), on the "
            f"other side of the bend beyond each inflection: {mark} is engraved on both sheets"
        )
    return f"bent, the backing lies {mark.lower()}: {mark} is engraved on both sheets, on the faces that look there"


def tell_joint(lap: float, width: float, held: Reactions, place: str) -> str:
    """How a closed strip is joined at a place, where it is so wide, mm, and what the joint carries."""
    how = (
        f"glue its tab of {lap:.3g} mm, bent as drawn, behind its start"
        if lap
        else "join its ends butt to butt"
    )
    return (
        f"closed: {how} at {place}, where it is {width:.3g} mm wide; the joint carries "
        f"{abs(held.end_moment):.3g} N mm and {np.hypot(*held.end_force):.2g} N"
    )


def warn_of_strains(strains: Sequence[LayerStrain], bends: Bends) -> Iterator[str]:
    """Layers strained beyond what their sheets bear."""
    bend = bends.amount
    for layer in strains:
        at = layer.station
        judged = layer.judged(bends.place(at))
        if not judged.allowed:
            bearable = bend[at] * layer.limit / layer.largest
            strain, limit = told_apart(100 * layer.largest, 100 * layer.limit, ".2f")
            radius, least = told_apart(1 / bend[at], 1 / bearable, ".1f")
            yield (
                f"strain {strain} % at {judged.at:.1f} mm is beyond the {limit} % "
                f"that {layer.name} bears: its radius there is {radius} mm, the least advisable "
                f"{least} mm; {judged.outcome}; use a thinner sheet or a gentler curve"
            )


def warn_of_width(width: Profile, length: float, *, closed: bool) -> Iterator[str]:
    """Ends that do not match where a strip closes, and strips wider than long."""
    start, end = width([0.0, length]).tolist()
    if closed and abs(end - start) > UNEVEN_JOINT_MM:
        yield (
            f"its ends are {start:.3g} and {end:.3g} mm wide where it closes: choose another joint, leave out "
            "gravity, or make the curvature continuous there"
        )
    widest = float(width.extremes[1])
    if widest > length:
        yield (
            f"it is {widest:.4g} mm wide and {length:.4g} mm long: what is wider than long bends as a "
            "plate, not as a strip; give a smaller max_width, and look at its unit"
        )


def warn_of_plywood(layers: Sequence[Layer], strains: Sequence[LayerStrain], bends: Bends) -> Iterator[str]:
    """Plywood bent sharper than its published radii, where its strain has not told so."""
    bend = bends.amount
    tightest = int(np.argmax(bend))
    for one, layer in zip(layers, strains, strict=False):
        least = one.sheet.published_radius
        if least is not None and layer.judged().allowed and bend[tightest] * least > 1 + TOLD_TO:
            at = bends.place(tightest)
            yield (
                f"it bends to a radius of {1 / bend[tightest]:.1f} mm at {at:.1f} mm, but plywood of "
                f"{one.sheet.thickness:g} mm bends to {least:.1f} mm at least {one.sheet.grain} the face grain "
                f"({PLYWOOD_SOURCE}); use a thinner sheet or a gentler curve"
            )


def warn_of_creep(factor: float, strained: LayerStrain, crept: Callable[[], Creep | None]) -> Iterator[str]:
    """Where creep of the most strained layer is not linear any more, and a strip that does not stay."""
    if strained.largest > LINEAR_CREEP_SHARE * strained.limit:
        yield (
            f"strain {100 * strained.largest:.2f} % is more than {100 * LINEAR_CREEP_SHARE:.0f} % of what the "
            "sheet bears: creep is not linear there, and more than said; use a thinner sheet or a gentler curve"
        )
    try:
        later = crept()
    except NotConvergedError as problem:
        yield str(problem)
        return
    if later is not None and not later.stays:
        yield (
            f"with a creep factor of {factor:g} it will not stay in the long run: it snaps into another "
            "shape; use a stiffer sheet or support it"
        )
