"""What sections of strips set against leaving the plane of the curve: edgewise bending and torsion."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_number
from elastica_cad.errors import InputError
from elastica_cad.mechanics.material.laminated_section import LaminatedSection
from elastica_cad.mechanics.material.sheet_keys import even_shear_ratio

EDGE_LOSS = 0.63
"""Thicknesses by which a rectangle seems narrower in torsion (St Venant): G w h^3/3 (1 - 0.63 h/w)."""

LEAST_TORSION = 0.25
"""Share of G w h^3/3 that is left of any rectangle that is bent flat: a square has 0.42."""


@dataclass(frozen=True, eq=False)
class SidewaysSection:
    """Of a strip at equal distances along it; stiffnesses are over the rod's B, as its own K is.

    Attributes
    ----------
    width, thickness : (n,) array
        mm; the thickness is that of a plate of as much bending and membrane stiffness.
    edgewise, torsion : (n,) array
        Stiffness of bending in the sheet's own plane, and of twist.
    """

    width: FloatArray
    thickness: FloatArray
    edgewise: FloatArray
    torsion: FloatArray

    @classmethod
    def rectangle(
        cls, stiffness: FloatArray, width: FloatArray, thickness: FloatArray, shear_ratio: float
    ) -> "SidewaysSection":
        """A solid strip whose stiffness (n,) of bending in the plane is given; `shear_ratio` is G / E."""
        torsion = 4 * shear_ratio * stiffness * _held_back(thickness, width)
        return cls(width, thickness, stiffness * (width / thickness) ** 2, torsion)

    @classmethod
    def perforated(
        cls,
        stiffness: FloatArray,
        width: FloatArray,
        material: FloatArray,
        slope: FloatArray,
        *,
        ligaments: int,
        thickness: float,
        shear_ratio: float,
    ) -> tuple["SidewaysSection", "SidewaysSection"]:
        """The least and the most that a strip with holes may have: bounds on its energy.

        Parameters
        ----------
        stiffness, width, material : (n,) array
            Of bending in the plane; of the outline, and what holes leave of it at every station, mm.
        slope : (n,) array
            Of ligaments against the strip: tan(theta).
        ligaments : int
            How many equal ones run side by side.
        shear_ratio : float
            G / E.

        Notes
        -----
        The least by stresses in balance: every ligament, b wide across the strip, carries its share by itself. A
        torque T turned into a ligament's own directions is twist T cos(theta) and bending T sin(theta), so that G b
        h^3/3 keeps cos^2 / (cos^2 + 4 G/E sin^2) of itself; edgewise it bends as b^3 h/12. The most by
        displacements: the whole twists alike, G t h^3/3 with t in all, and bends edgewise as a plane section, at
        most as if all material lay at the edges, (W^3 - (W - t)^3) h/12.
        """
        h = np.full(width.size, thickness)
        cos2 = 1 / (1 + slope**2)
        one = material / ligaments
        twist = 4 * shear_ratio * stiffness
        leaning = cos2 / (cos2 + 4 * shear_ratio * (1 - cos2))
        least = cls(
            width,
            h,
            stiffness * cos2**1.5 * (one / h) ** 2,
            twist * leaning * _held_back(h, one * np.sqrt(cos2)),
        )
        most = cls(width, h, stiffness * (width**3 - (width - material) ** 3) / (material * h**2), twist)
        return least, most

    @classmethod
    def laminated(
        cls,
        stiffness: FloatArray,
        rigidity: float,
        base_width: FloatArray,
        backing_width: FloatArray,
        section: LaminatedSection,
    ) -> "SidewaysSection":
        """Two sheets glued back to back.

        Parameters
        ----------
        stiffness : (n,) array
            K of bending in the plane.
        rigidity : float
            B, N mm2: the E I where K = 1.
        base_width, backing_width : (n,) array
            mm.
        section : LaminatedSection

        Notes
        -----
        Free torsion leaves no shear flow anywhere across the strip, so every place twists about its own neutral
        layer: G1 h1^3/3 beside the backing, 4 (D66 - B66^2/A66) on it. Never less than both sheets unglued.
        """
        sheets, widths = (section.base, section.backing), (base_width, backing_width)
        h1, h2 = (sheet.thickness for sheet in sheets)
        G1, G2 = (sheet.youngs_modulus * sheet.shear_ratio for sheet in sheets)
        both = G1 * h1**3 / 3 + G2 * h2**3 / 3 + G1 * h1 * G2 * h2 / (G1 * h1 + G2 * h2) * (h1 + h2) ** 2
        apart = G1 * h1**3 / 3 * base_width * _held_back(h1, base_width) + np.where(
            backing_width > 0, G2 * h2**3 / 3 * backing_width * _held_back(h2, backing_width), 0.0
        )
        beside = G1 * h1**3 / 3 * (base_width - backing_width)
        together = beside * _held_back(h1, base_width) + both * backing_width * _held_back(
            h1 + h2, backing_width
        )
        edgewise, axial = (
            np.asarray(
                sum(
                    sheet.youngs_modulus * sheet.thickness * w**power / over
                    for sheet, w in zip(sheets, widths, strict=True)
                )
            )
            for power, over in ((3, 12.0), (1, 1.0))
        )
        return cls(
            base_width,
            np.sqrt(12 * rigidity * stiffness / axial),
            edgewise / rigidity,
            np.maximum(apart, together) / rigidity,
        )

    @classmethod
    def round(cls, stiffness: FloatArray, diameter: float, shear_ratio: float) -> "SidewaysSection":
        """A rod or tube, at most `diameter` mm thick: E I all round, and G J = 2 G/E times that."""
        size = np.full(stiffness.size, diameter)
        return cls(size, size, stiffness, 2 * shear_ratio * stiffness)


def checked_shear_ratio(shear_ratio: float | None, poisson_ratio: float) -> float:
    """G / E as given, else that of an isotropic sheet; or an InputError."""
    nu = require_number(poisson_ratio, "poisson_ratio")
    if not -1 < nu < 1:
        raise InputError(f"poisson_ratio is {poisson_ratio}: it must lie between -1 and 1")
    ratio = even_shear_ratio(nu) if shear_ratio is None else require_number(shear_ratio, "shear_ratio")
    if not 0 < ratio < np.inf:
        raise InputError(f"shear_ratio is {shear_ratio}: G / E is positive")
    return ratio


def _held_back(thickness: FloatArray | float, width: FloatArray) -> FloatArray:
    """Share (n,) of G w h^3/3 that a rectangle has."""
    return np.asarray(np.maximum(1 - EDGE_LOSS * thickness / np.maximum(width, 1e-12), LEAST_TORSION))
