"""Widths that make up for what a strip is made with, where a workshop can still cut them."""

from dataclasses import replace

from elastica_cad.fabrication.compensation import compensate_widths
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.makeability.uncuttable_parts import find_strip_faults
from elastica_cad.fabrication.strip.strip_record import Strip


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
