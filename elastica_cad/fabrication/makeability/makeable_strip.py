"""A strip as a workshop can make it: in pieces where it is long, its widths made up where they can still be cut."""

from contextlib import suppress
from dataclasses import replace

from elastica_cad._values import require_flag
from elastica_cad.errors import Change, InputError, StrainError
from elastica_cad.fabrication.compensation import compensate_widths
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.makeability.splices import joined_within, spliced
from elastica_cad.fabrication.makeability.uncuttable_parts import accept_faults, find_strip_faults
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.mechanics.material.section_limits import thinner_for


def make_within(strip: Strip, shop: Shop, *, compensate: bool, ignore_limits: bool) -> Strip:
    """The strip joined of pieces where it is longer than the stock, with compensated widths where asked.

    Raises
    ------
    InputError
        It cannot be cut or handled, with place and cure of each fault, unless `ignore_limits`.
    StrainError
        It would break, unless `ignore_limits`.
    """
    refuse_broken(strip, ignore_limits)
    with suppress(InputError):  # no room for joints is told with what else cannot be cut
        strip = joined_within(strip, shop)
    if compensate:
        strip = compensate_within(strip, shop)
    told = accept_faults(find_strip_faults(strip, shop), ignore_limits)
    joined = spliced(strip, shop)
    told += () if joined is None else (str(joined),)
    if not told:
        return strip
    return replace(strip, rod=replace(strip.rod, warnings=(*strip.rod.warnings, *told)))


def refuse_broken(strip: Strip, ignore_limits: bool) -> None:
    """Refuse a strip that would break.

    Raises
    ------
    StrainError
        With the place, the radius there and the least one; not with `ignore_limits`, where the strip warns of it.
    """
    judged = strip.strain_verdict
    if require_flag(ignore_limits, "ignore_limits") or not judged.refused:
        return
    thinner = thinner_for(strip.sheet, strip.max_strain)
    raise StrainError(
        "{strains} To make it all the same, set ignore_limits (--ignore-limits).",
        strains=" ".join(f"{text}." for text in strip.strain_warnings),
        percent=judged.percent,
        where={"at": judged.at},
        changes=[*([] if thinner is None else [Change("thickness", thinner)]), Change("nearest", True)],
    )


def compensate_within(strip: Strip, shop: Shop) -> Strip:
    """The strip with compensated widths; as it is, with a warning, where those could not be cut and handled."""
    better = compensate_widths(strip)
    faults = find_strip_faults(better, shop)
    if not faults or find_strip_faults(strip, shop):
        return better
    told = (
        f"its widths do not make up for how it is made, since it would then be {faults[0].what}; give it tabs as "
        "wide as its ends, or shallower slots"
    )
    return replace(strip, rod=replace(strip.rod, warnings=(*strip.rod.warnings, told)))
