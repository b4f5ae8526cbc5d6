"""Shoulders of a strip beside a tab that is narrower: what the moment of its end does to the sheet between them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._counts import told_apart
from elastica_cad.errors import rounded_up
from elastica_cad.fabrication.strip.outline import SHOULDER_MM, Ends
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.mechanics.material.section_limits import (
    BRITTLE,
    STRAIN_SLACK,
    LayerStrain,
    StrainState,
    StrainVerdict,
    judge_strain,
)
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.sheet_library import even_shear_ratio
from elastica_cad.refusals import Length, note

FILLETS = (
    (1.020, 1.009, -0.048),
    (-0.065, -0.165, -0.007),
    (-3.459, 1.266, -0.016),
    (3.505, -2.109, 0.069),
)
DEEPEST, GRAIN = 20.0, 0.7
"""Of `corner_factor`: row i times (2 t / width)^i, column j times (t / r)^(j / 2); largest t / r of the chart;
power with which the peak follows sqrt(E / G), over that of a sheet without grain, fitted to finite elements
(`tests/campaign/finite_elements/shoulders.py`)."""


def corner_factor(sheet: Sheet, width: float, tab: float) -> float:
    """Strain in the corners beside a tab, over its mean across the tab, where both are bent by one moment.

    That of a flat bar with shoulders t deep and fillets of radius r in tension (Pilkey, Peterson's Stress
    Concentration Factors, chart 3.1), whose excess over 1 is smaller by (1 + nu) / (3 + nu) in a plate that is
    bent, as beside an elliptic hole (Goodier, Phil. Mag. 22, 1936). A corner counts as rounded by the thickness of
    the sheet: a sharp one is strained about as much in the mean over the nearest quarter of the thickness, and less
    where the tab is gripped up to its mouth. Solids in CalculiX agree within 15 %.

    Parameters
    ----------
    width, tab : float
        Of the strip's end and of its tab, mm.

    Examples
    --------
    >>> round(corner_factor(Sheet("even", 1.0, 12.0, density=1000.0, max_strain=0.01), 30, 15), 2)
    1.75
    """
    depth, nu = (width - tab) / 2, min(sheet.poisson_ratio, 0.5)
    sharp = np.sqrt(min(depth / sheet.thickness, DEEPEST))
    tension = float(np.polynomial.polynomial.polyval2d(2 * depth / width, sharp, FILLETS))
    grain = np.sqrt(even_shear_ratio(nu) / sheet.shear_ratio)
    return float(1 + (1 + nu) / (3 + nu) * grain**GRAIN * max(tension - 1, 0.0))


@dataclass(frozen=True)
class Shoulder:
    """An end of a strip, `at` mm along it and `width` mm wide, with its `tab`, mm, whose mean strain of the skin is
    `strain`."""

    at: float
    width: float
    tab: float
    sheet: Sheet
    strain: float

    @property
    def verdict(self) -> StrainVerdict:
        """Result of the strain rule: tabs break by their mean strain, brittle ones may crack in the corners before.

        Where a sheet yields or creeps, the peak in a corner evens out.
        """
        mean = judge_strain(self.sheet, self.strain, self.at)
        if mean.refused or self.sheet.kind not in BRITTLE:
            return mean
        peak = self.strain * corner_factor(self.sheet, self.width, self.tab)
        judged = judge_strain(self.sheet, peak, self.at)
        return replace(judged, state=min(judged.state, StrainState.WARNED))

    @property
    def least_tab(self) -> float:
        """The narrowest tab, mm, that is not strained beyond the limit; else the width of the strip."""
        wider = np.linspace(self.tab, self.width, 100)[1:-1]
        tried = (replace(self, tab=float(one), strain=self.strain * self.tab / float(one)) for one in wider)
        return next((rounded_up(one.tab, 3) for one in tried if one.verdict.allowed), self.width)

    def __str__(self) -> str:
        """One sentence."""
        judged, bears = self.verdict, self.sheet.max_strain
        peak = judged.used * bears
        strain, limit = told_apart(100 * peak, 100 * bears, ".2g")
        place = note("in the corners beside it" if peak > self.strain * (1 + STRAIN_SLACK) else "across it")
        return note(
            "at {at} from the start the strip is {width} wide and its tab {tab}: {place} the strain is "
            "{strain:g} %, beyond the {limit:g} % that {sheet} bears; {outcome}; make the tab {least} wide, or "
            "the curve gentler there",
            at=Length(self.at), width=Length(self.width), tab=Length(self.tab), place=place, strain=strain,
            limit=limit, sheet=self.sheet.name, outcome=note(judged.outcome), least=Length(self.least_tab),
            severity="warning",
        )  # fmt: skip


def find_shoulders(layout: Layout, ends: Ends, strains: Sequence[LayerStrain]) -> tuple[Shoulder, ...]:
    """The ends of a strip, with its strains, whose tabs are too narrow for the moment there."""
    if layout.size is not None:  # not cut from a sheet: a tab is as wide as the strip
        return ()
    found = []
    for at, tab, station in zip((0.0, layout.width.length), ends, (0, -1), strict=True):
        width = float(layout.width(at))
        if not tab.length or tab.width is None or tab.width > width - SHOULDER_MM:
            continue
        widths = np.array([layout.material(at), tab.width])
        glued = None if layout.backing is None else np.array([layout.backing.width(at), tab.width])
        own, narrow = layout.stiffness(widths, glued).tolist()
        found += [
            Shoulder(at, width, tab.width, layer.sheet, float(layer.strain[station]) * own / narrow)
            for layer in strains
            if layer.strain[station] <= layer.limit  # else the end itself is told of, which no tab helps
        ]
    return tuple(one for one in found if not one.verdict.allowed)
