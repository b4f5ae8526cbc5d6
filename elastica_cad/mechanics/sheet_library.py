"""The built-in sheets: published numbers, their sources, and how far they spread.

A strip stays bent for years, so `max_strain` is what can be borne for long. Metals: yield strength over E.
Plastics and composites, which creep, and boards: half of the least published strength over the greatest E,
unless a limit for lasting load is published. Plywood and card: from published least radii, h / (2 r).
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from elastica_cad.mechanics.loads import STANDARD_GRAVITY
from elastica_cad.mechanics.sheet import Grain, Range, Sheet

__all__ = ["LIBRARY"]

# FAA AC 43.13-1B: thickness and least cold-bend radii of 3-ply birch or aircraft plywood, mm
_PLYWOOD_THICKNESS = np.array([0.89, 1.78, 2.54, 3.18])
_RADIUS_ALONG = np.array([51.0, 132.0, 218.0, 305.0])
_RADIUS_ACROSS = np.array([28.0, 81.0, 132.0, 180.0])

# laser kerf by thickness, mm
_KERF_THICKNESS = np.array([1.6, 3.2, 6.4])
_KERF_ACRYLIC = np.array([0.18, 0.23, 0.25])
_KERF_PLYWOOD = np.array([0.15, 0.20, 0.25])

CARD_GRAVITO_BENDING = 8.86e-4  # m3, paper section 5.1: measured by the authors on 200 gsm card


def _plywood(thickness: float) -> Sheet:
    strain = float(np.interp(thickness, _PLYWOOD_THICKNESS, _PLYWOOD_THICKNESS / (2 * _RADIUS_ALONG)))
    across = float(np.interp(thickness, _PLYWOOD_THICKNESS, _PLYWOOD_THICKNESS / (2 * _RADIUS_ACROSS)))
    return Sheet(
        f"birch-plywood-{thickness:g}",
        thickness=thickness,
        youngs_modulus=9250.0,
        youngs_modulus_range=(8200.0, 10300.0),
        density=680.0,
        density_range=(640.0, 720.0),
        max_strain=strain,
        max_strain_range=(48 / 10300, strain),
        kerf=round(float(np.interp(thickness, _KERF_THICKNESS, _KERF_PLYWOOD)), 2),
        kerf_range=(0.10, 0.30),
        poisson_ratio=0.1,
        grain="along",
        kind="plywood",
        source=(
            "3-ply, strip along the face grain; E 8.2-10.3 GPa, bending strength 48-69 MPa: MatWeb, plywood "
            "sheathing; strain: least cold-bend radii of FAA AC 43.13-1B (across the face grain it bends to "
            f"{thickness / (2 * across):.0f} mm and E is far lower: measure a coupon); density: handbooks; "
            "kerf 0.15-0.25 mm"
        ),
    )


def _card() -> Sheet:
    thickness, grammage = 0.2, 0.2  # mm, kg/m2
    density = grammage / (thickness * 1e-3)
    modulus = CARD_GRAVITO_BENDING * 12 * density * STANDARD_GRAVITY / (thickness * 1e-3) ** 2 * 1e-6
    return Sheet(
        "card-200gsm",
        thickness=thickness,
        thickness_range=(0.20, 0.25),
        youngs_modulus=modulus,
        density=density,
        density_range=(800.0, 1000.0),
        max_strain=thickness / (2 * 20.0),
        max_strain_range=(0.2 / 40.0, 0.25 / 40.0),
        kerf=0.11,
        kerf_range=(0.08, 0.15),
        grain="along",
        kind="card",
        source=(
            "paper (Hafner and Bickel), section 5.1: elasto-gravity length^3 = 8.86e-4 m3, hence E; "
            "appendix D: stays bent below 20 mm radius; thickness 0.20-0.25 mm; bend it along its grain"
        ),
    )


@dataclass(frozen=True)
class _Family:
    """Sheets that differ in thickness only."""

    name: str
    kind: str
    thicknesses: tuple[float, ...]
    youngs_modulus: float
    youngs_modulus_range: Range
    density: float
    density_range: Range
    max_strain: float
    greatest_strain: float
    poisson_ratio: float
    source: str
    kerfs: tuple[float, ...] = ()
    kerf_range: Range | None = None
    grain: Grain = "none"

    def sheets(self) -> Iterator[Sheet]:
        """One sheet for each thickness; a kerf that nobody published stays 0 and the source says so."""
        unknown = "" if self.kerfs else "; kerf not published: measure it on a coupon"
        for thickness, kerf in zip(
            self.thicknesses, self.kerfs or (0.0,) * len(self.thicknesses), strict=True
        ):
            yield Sheet(
                f"{self.name}-{thickness:g}",
                thickness=thickness,
                youngs_modulus=self.youngs_modulus,
                youngs_modulus_range=self.youngs_modulus_range,
                density=self.density,
                density_range=self.density_range,
                max_strain=self.max_strain,
                max_strain_range=(self.max_strain, self.greatest_strain),
                kerf=kerf,
                kerf_range=self.kerf_range,
                poisson_ratio=self.poisson_ratio,
                grain=self.grain,
                kind=self.kind,
                source=self.source + unknown,
            )


def _acrylic_kerf(*thicknesses: float) -> tuple[float, ...]:
    return tuple(round(float(np.interp(t, _KERF_THICKNESS, _KERF_ACRYLIC)), 2) for t in thicknesses)


_FAMILIES = (
    _Family(
        "pom", "plastic", (0.5, 1.0), 2750.0, (2500.0, 3000.0), 1410.0, (1400.0, 1420.0),
        0.5 * 89 / 3000, 105 / 2500, 0.35,
        "polyacetal; E 2.5 (copolymer) to 3.0 GPa (homopolymer), bending strength 89-105 MPa, 1410 kg/m3: "
        "Engineering Plastics Handbook; strain: half of strength over E, for it creeps",
    ),
    _Family(
        "polypropylene", "plastic", (0.5, 0.8), 1070.0, (900.0, 1300.0), 910.0, (900.0, 915.0),
        0.5 * 31 / 1300, 31 / 900, 0.42,
        "E 1.07 GPa, 910 kg/m3: Engineers Edge; E 0.9-1.3 GPa, bending strength 31 MPa: makeitfrom.com, "
        "PP copolymer; strain: half of strength over E, for it creeps",
    ),
    _Family(
        "petg", "plastic", (0.5, 1.0), 2400.0, (2300.0, 2500.0), 1330.0, (1270.0, 1340.0),
        0.5 * 77 / 2500, 84 / 2300, 0.38,
        "PETG-like copolyester; E 2.3-2.5 GPa, yield 77-84 MPa, 1330 kg/m3: Eastar MN021 data sheet; "
        "strain: half of strength over E, for it creeps",
    ),
    _Family(
        "acrylic", "plastic", (1.5, 2.0, 3.0), 3350.0, (3000.0, 3400.0), 1190.0, (1170.0, 1200.0),
        10.4 / 3350, 106 / 3350, 0.37,
        "E 3.35 GPa, strength 106 MPa; strain from the sustained crazing limit of 10.4 MPa: Politem; "
        "density: makers' data sheets; kerf 0.18-0.25 mm at 1.6-6.4 mm",
        _acrylic_kerf(1.5, 2.0, 3.0), (0.15, 0.30),
    ),
    _Family(
        "mdf", "board", (3.0,), 2700.0, (2500.0, 3000.0), 800.0, (750.0, 850.0),
        0.5 * 23 / 3000, 23 / 2500, 0.25,
        "E 2.7 GPa: Risun; bending strength 23 MPa: EN 622-5; density: makers' data sheets; "
        "strain: half of strength over E; kerf 0.15-0.18 mm",
        (0.16,), (0.15, 0.18),
    ),
    _Family(
        "hdf", "board", (1.5, 2.5), 2700.0, (2500.0, 3500.0), 880.0, (850.0, 900.0),
        0.5 * 35 / 3500, 35 / 2500, 0.25,
        "1.5-3.5 mm: E 2.7 GPa, bending strength at least 35 MPa, 880 kg/m3: Risun; strain: half of strength "
        "over E; kerf as 3 mm MDF, 0.15-0.18 mm",
        (0.15, 0.16), (0.12, 0.18),
    ),
    _Family(
        "aluminium-6061", "metal", (0.5, 1.0), 69000.0, (68000.0, 70000.0), 2700.0, (2690.0, 2710.0),
        276 / 69000, 276 / 68000, 0.33,
        "temper T6; E 69 GPa, yield 276 MPa, 2700 kg/m3: eCourses; strain: yield over E",
    ),
    _Family(
        "spring-steel", "metal", (0.2, 0.5), 200000.0, (190000.0, 210000.0), 7850.0, (7800.0, 7900.0),
        1010 / 200000, 1200 / 190000, 0.3,
        "301 full hard, yield 1010 MPa; 50CrV4, yield 1200 MPa; E about 200 GPa, 7850 kg/m3: spring steel "
        "tables; strain: yield of 301 over E",
    ),
    _Family(
        "gfrp", "composite", (1.0, 2.0), 18000.0, (17000.0, 19000.0), 1800.0, (1700.0, 2000.0),
        0.5 * 207 / 19000, 230 / 17000, 0.3,
        "pultruded, strip along the fibres; E 17-19 GPa, strength 207-230 MPa: ZHCLG; "
        "density 1700-2000 kg/m3: Tencom; strain: half of strength over E",
        grain="along",
    ),
)  # fmt: skip


def _built_in() -> Mapping[str, Sheet]:
    sheets = [_card(), *(_plywood(t) for t in (0.8, 1.0, 1.5, 2.0, 3.0))]
    for family in _FAMILIES:
        sheets.extend(family.sheets())
    return MappingProxyType({sheet.name: sheet for sheet in sheets})


LIBRARY = _built_in()
