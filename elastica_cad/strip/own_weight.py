"""Effect of the weight of a strip that was designed without weight."""

from collections.abc import Sequence
from dataclasses import replace

from elastica_cad.errors import FieldName, InputError, NotConvergedError, Refusal, note
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend, has_snapped, scaled
from elastica_cad.mechanics.elements import PointForce
from elastica_cad.mechanics.loads import Gravity, PointMass, Weight
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.trials import not_tried
from elastica_cad.strip.held_shape import about, deviation_from
from elastica_cad.strip.strip import Strip

LIGHT_CLAMPED, LIGHT = 1.0, 0.008
"""Largest weight, as a multiple of E I / length^2, whose effect is not computed.

The weight is that of the whole strip. `LIGHT_CLAMPED` is for strips with both ends clamped, `LIGHT` for others.
If the weight is W times E I / length^2, the end of a straight cantilever moves by W / 8 times the length. The
middle of a straight strip with clamped ends moves by W / 384 times the length."""

COLLAPSES = (
    "The weight of the strip is not considered. If the curve stands upright, the strip collapses under "
    "{carried:.2g} % of its weight. Set {gravity}."
)


def _weight(strip: Strip, share: float = 1.0) -> Weight:
    # return the weight per length of the sections of the strip, times `share`
    section, parameter = strip.layout.section_at(strip.rod.s)
    return Weight(alpha=Profile.interpolate(strip.rod.s, share * section.weight_per_length(parameter)))


def with_weight(strip: Strip, gravity: Gravity) -> Strip:
    """Return a strip that was designed without weight, with its weight per length for `bend_strip`.

    Its size does not depend on the length of the `Gravity`.
    """
    return strip.bent_as(replace(strip.rod_to_bend, gravity=gravity, weight=_weight(strip)))


def bent_under(
    strip: Strip, gravity: Gravity | None, loads: Sequence[PointMass | PointForce] = (), fraction: float = 1.0
) -> Rod | None:
    """Return the rest shape under a fraction of weight and loads, or None if the strip loses its stability."""
    rod, weight = strip.rod, None
    if gravity is not None:
        # weight is proportional to 1 / length^3, and only a part of it may act in the plane of the curve
        weight = _weight(strip, fraction * (strip.sheet.elasto_gravity_length / gravity.length) ** 3)
    heavy = replace(
        rod, gravity=gravity, weight=weight, bending_stiffness=strip.bending_stiffness, warnings=()
    )
    try:
        bent = bend(heavy, loads=scaled(loads, fraction)) if loads else bend(heavy)
    except NotConvergedError:
        return None
    return None if has_snapped(bent) or bent.discrete.unstable_modes > rod.discrete.unstable_modes else bent


def carried_percentage(
    strip: Strip, gravity: Gravity | None, loads: Sequence[PointMass | PointForce] = ()
) -> float:
    """Return the percentage of weight and loads under which the strip loses its stability."""
    low, high = 0.0, 1.0
    for _ in range(10):
        middle = (low + high) / 2
        low, high = (low, middle) if bent_under(strip, gravity, loads, middle) is None else (middle, high)
    return 100 * high


def weight_warning(strip: Strip, gravity: Gravity) -> Refusal | None:
    """Return the warning that the weight of a strip matters, or None.

    Parameters
    ----------
    strip : Strip
        Strip whose design does not include the weight.
    gravity : Gravity
        Gravity in the plane of the curve, from `Sheet.gravity` or `Gravity.in_plane`.
    """
    rod = strip.rod
    limit = LIGHT_CLAMPED if rod.supports.clamped else LIGHT
    light = (rod.length / gravity.length) ** 3 <= limit
    if light or rod.supports.is_free or strip.layout.stack is not None or rod.discrete.unstable_modes:
        return None
    if reason := not_tried(rod.curve):
        return note(
            "The effect of the weight is not computed, because the curve has {pieces} pieces, more than {most}. "
            "Draw the curve with fewer points.",
            **reason.values, severity="warning",
        )  # fmt: skip
    try:
        bent = bent_under(strip, gravity)
    except InputError:  # `bend` refuses a straight strip whose ends are as far apart as the strip is long
        return None
    if bent is None:
        carried = carried_percentage(strip, gravity)
        return note(COLLAPSES, carried=carried, gravity=FieldName("gravity"), severity="warning")
    moved = deviation_from(rod, bent.position)
    # sheet, cut and clamps of a usual strip have an effect of this size
    if moved <= 1e-3 * rod.length:
        return None
    return note(
        "The weight of the strip, which the accuracy leaves out, moves the strip by {far} if the curve stands "
        "upright. In this case set {gravity}.",
        far=about(moved), gravity=FieldName("gravity"), severity="warning",
    )  # fmt: skip


def collapses(strip: Strip) -> bool:
    """Return True if a warning of the strip states that it collapses under its weight."""
    return any(isinstance(text, Refusal) and text.text == COLLAPSES for text in strip.rod.warnings)
