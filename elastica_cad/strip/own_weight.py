"""Effect of the weight of a strip that was designed without weight."""

from dataclasses import replace

from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend, has_snapped
from elastica_cad.mechanics.loads import Gravity, Weight
from elastica_cad.mechanics.rod import Rod
from elastica_cad.refusals import FieldName, Refusal, note
from elastica_cad.strip.held_shape import about, deviation_from
from elastica_cad.strip.strip import Strip

LIGHT_CLAMPED, LIGHT = 1.0, 0.008
"""Largest weight, as a multiple of E I / length^2, whose effect is not computed.

The weight is that of the whole strip. `LIGHT_CLAMPED` is for strips with both ends clamped, `LIGHT` for others.
If the weight is W times E I / length^2, the end of a straight cantilever moves by W / 8 times the length. The
middle of a straight strip with clamped ends moves by W / 384 times the length."""

MOVES_FRACTION = 1e-3
"""Movement by the weight, as a fraction of the length, above which the user is warned.

Sheet, cut and clamps of a usual strip have an effect of this size."""

HALVINGS = 10
"""Number of halvings in the search for the largest fraction of the weight that the strip carries."""

COLLAPSES = (
    "The weight of the strip is not considered. If the curve stands upright, the strip collapses under "
    "{carried:.2g} % of its weight. Set {gravity}."
)


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
    if (rod.length / gravity.length) ** 3 <= limit or rod.supports.is_free or strip.layout.stack is not None:
        return None
    if rod.discrete.unstable_modes:
        return None
    light = replace(rod, warnings=())
    share = (strip.sheet.elasto_gravity_length / gravity.length) ** 3
    newtons = share * strip.layout.weight_at(rod.s)

    def under(fraction: float) -> Rod | None:
        weight = Weight(alpha=Profile.interpolate(rod.s, fraction * newtons))
        heavy = replace(light, gravity=gravity, weight=weight, bending_stiffness=strip.bending_stiffness)
        try:
            bent = bend(heavy)
        except NotConvergedError:
            return None
        return None if has_snapped(bent) or bent.discrete.unstable_modes else bent

    try:
        bent = under(1.0)
    except InputError:  # `bend` refuses a straight strip whose ends are as far apart as the strip is long
        return None
    if bent is None:
        low, high = 0.0, 1.0
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (low, middle) if under(middle) is None else (middle, high)
        return note(COLLAPSES, carried=100 * high, gravity=FieldName("gravity"), severity="warning")
    moved = deviation_from(rod, bent.position)
    if moved <= MOVES_FRACTION * rod.length:
        return None
    return note(
        "The weight of the strip, which the accuracy leaves out, moves the strip by {far} if the curve stands "
        "upright. In this case set {gravity}.",
        far=about(moved), gravity=FieldName("gravity"), severity="warning",
    )  # fmt: skip


def collapses(strip: Strip) -> bool:
    """Return True if a warning of the strip states that it collapses under its weight."""
    return any(isinstance(text, Refusal) and text.text == COLLAPSES for text in strip.rod.warnings)
