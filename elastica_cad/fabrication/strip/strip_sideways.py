"""Does a strip of any style stay in the plane of its curve?"""

import numpy as np

from elastica_cad.fabrication.strip.diamond_pattern import DiamondPattern
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.mechanics.material.laminated_section import LaminatedSection
from elastica_cad.mechanics.material.stiffness_law import RoundLaw
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.sideways import (
    SidewaysSection,
    SidewaysStability,
    sideways_stability,
    sideways_stability_of,
    stations_of_sideways,
)


def strip_sideways(rod: Rod, layout: Layout) -> SidewaysStability:
    """The verdict on a rod that is made by a layout; its slots are left out."""
    sheet, ratio = layout.sheet, layout.sheet.shear_ratio
    s = stations_of_sideways(rod)
    K, width = np.interp(s, rod.s, rod.flat_stiffness), layout.width(s)
    if isinstance(layout.section, RoundLaw):
        thickest = float(layout.width.extremes[1])
        return sideways_stability_of(rod, SidewaysSection.round(K, thickest, ratio))
    if isinstance(layout.pattern, DiamondPattern):
        between = SidewaysSection.perforated(
            K, width, layout.material(s), layout.pattern.slopes(s), ligaments=layout.pattern.ligaments,
            thickness=sheet.thickness, shear_ratio=ratio,
        )  # fmt: skip
        return sideways_stability_of(rod, *between)
    if layout.backing is not None:
        section = LaminatedSection(sheet, layout.backing.sheet)
        backing = np.clip(layout.backing.width(s), 0.0, width)
        laminate = SidewaysSection.laminated(K, layout.bending_stiffness, width, backing, section)
        return sideways_stability_of(rod, laminate)
    thickness = sheet.thickness if layout.size is None else layout.size
    return sideways_stability(rod, layout.width, thickness, shear_ratio=ratio)
