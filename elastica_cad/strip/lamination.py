"""Laminated strips: a base of given width, and a narrower backing glued to it that determines the stiffness."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import distinct_digits, is_number
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import (
    MATERIAL_WIDTH,
    Either,
    FaultError,
    InputError,
    Length,
    Refusal,
    note,
    rounded_up,
)
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import ScaleRange
from elastica_cad.mechanics.sheets import Sheet, require_flat
from elastica_cad.strip.styles import (
    Backing,
    Layout,
    Width,
    refine_stations,
    require_laid_out,
    stations_of,
    width_profile,
)

SLACK = 3e-4
"""Fraction by which a stiffness may exceed its limits, because the limits are computed only at stations."""


@dataclass(frozen=True, eq=False)
class Laminated:
    """Style of a strip with a base of given width and a narrower backing glued to it.

    The width of the backing follows from the exact bending stiffness of the two-layer section.

    Both tabs have a backing as wide as the base, so that holes in the tabs align the layers. Without
    `max_width`, the backing is as wide as the base at one point, as in the paper (section 8.1). The weight of
    a laminate is not proportional to its stiffness, so a rod under its own weight needs `optimal_laminate`.

    Parameters
    ----------
    width : float, Profile or callable
        Width of the base, mm: a number, or a profile or function of the arc length (such as `touching_widths`).
    backing : Sheet
        Sheet of the backing, or its name.
    least_backing : float
        Narrowest backing that can be cut and glued, mm.
    dots : float
        Diameter, mm, of the alignment holes in the middle of both tabs; 0 for none.

    Examples
    --------
    >>> from elastica_cad.strip.strip import Strip
    >>> card = Sheet.named("card-200gsm")
    >>> style = Laminated(width=20.0, backing=card)
    >>> strip = Strip(Rod.straight(120.0, [1, 2, 1]), card, style=style)
    >>> round(strip.layout.backing.width.extremes[1], 4)
    20.0
    """

    width: Annotated[Width, Option("Width of the base.", "mm", least=0, common=True, written=float)]
    backing: Annotated[Sheet, Option("Sheet that is glued on.")]
    least_backing: Annotated[float, Option("Narrowest backing that can be cut and glued.", "mm", above=0)] = (
        1.0
    )
    dots: Annotated[
        float, Option("Diameter of the holes in the tabs that align the layers; 0 for none.", "mm", least=0)
    ] = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "backing", require_flat(Sheet.of(self.backing)))
        require_declared(Laminated, vars(self))

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the flat pattern of a rod.

        Parameters
        ----------
        max_width, min_width : float, optional
            Bounds of the backing's width, mm.
        """
        require_laid_out(rod, sheet, max_width, min_width)
        base = width_profile(self.width, rod.length, "the width of the base")
        section = LaminatedSection(sheet, self.backing)
        least = max(self.least_backing, min_width or 0.0)
        scale = self._scale(rod, section, base, least, max_width)

        def width(s: FloatArray) -> FloatArray:
            return section.on(base(s)).parameter(scale * rod.profile(s))

        breaks = [(s, order) for s, order in (*rod.profile.breaks, *base.breaks) if order < 2]
        # the backing is clipped to the width of the base; the kinks due to clipping are negligible
        backing = Backing(self.backing, Profile.fit(width, rod.length, breaks=breaks, tolerance=1e-5))
        warnings: tuple[str, ...] = ()
        if rod.gravity is not None and rod.weight is None:
            warnings = (
                "the rod was designed for a weight proportional to its stiffness, and a laminate's is not: "
                "use optimal_laminate, or see how far it strays (deviation_as_built)",
            )
        return Layout(sheet, base, base, scale, backing=backing, dots=self.dots, warnings=warnings)

    def bounded(
        self, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> LaminatedSection | None:
        """Return the section with limits of the backing's width; None if the width of the base varies."""
        if not is_number(self.width):
            return None
        width = float(self.width)
        least, most = max(self.least_backing, min_width or 0.0), min(width, max_width or width)
        if least >= most:  # `laid_out` raises the error for these limits
            return None
        return LaminatedSection(sheet, self.backing, width, (least, most))

    def _scale(
        self, rod: Rod, section: LaminatedSection, base: Profile, least: float, most: float | None
    ) -> float:
        """Return the bending stiffness of the strip where the relative stiffness is 1, N mm2.

        If the rod has no bending stiffness, return the largest possible value.
        """
        s = stations_of(rod.length, base, rod.profile)
        w1 = base(s)
        s = refine_stations(s, section.on(w1).bending_stiffness(w1) / rod.profile(s), w1 / rod.profile(s))
        K, w1 = rod.profile(s), base(s)
        section = section.on(w1)
        i = w1.argmin()
        if w1[i] < least:
            narrow, needed = distinct_digits(float(w1[i]), least, ".4g")
            raise FaultError(
                "the base {s:.1f} from the start is {w1:g} wide, less than the narrowest backing "
                "({least:g}): widen the base there",
                w1=Length(narrow),
                s=Length(s[i]),
                least=Length(needed),
            )
        fits = section.scale_range(K, least_backing=least)
        if not fits.feasible:
            raise FaultError(_infeasible(section, fits, s, K, least))
        if most is not None:
            widest = section.bending_stiffness(np.minimum(w1, most))
            fits = ScaleRange.of(section.bending_stiffness(least), widest, K)
        low, high = float(s[fits.lowest_at]), float(s[fits.highest_at])
        if not fits.feasible:
            raise FaultError(
                "{field} is {most:g}, but a backing that is at least {least:g} wide {low:.1f} from the start of "
                "the strip must be wider than {most:g} {high:.1f} from the start. Raise {field}",
                field=MATERIAL_WIDTH,
                least=Length(least),
                low=Length(low),
                most=Length(most or 0.0),
                high=Length(high),
            )
        scale = rod.bending_stiffness or fits.highest
        if scale > fits.highest * (1 + SLACK):
            shown, limit = distinct_digits(scale, fits.highest, ".4g")
            raise FaultError(
                "the strip needs a bending stiffness of {scale:g} N mm2, but {high:.1f} from the start the widest "
                "backing gives {highest:g} N mm2: use thicker or stiffer sheets, or widen the base",
                scale=shown,
                high=Length(high),
                highest=limit,
            )
        if scale < fits.lowest * (1 - SLACK):
            shown, limit = distinct_digits(scale, fits.lowest, ".4g")
            raise FaultError(
                "the strip needs a bending stiffness of {scale:g} N mm2, but {low:.1f} from the start even "
                "the narrowest backing of {least:g} gives {lowest:g} N mm2: use thinner sheets, or narrow "
                "the base",
                scale=shown,
                least=Length(least),
                low=Length(low),
                lowest=limit,
            )
        return float(np.clip(scale, fits.lowest, fits.highest))


def _infeasible(
    section: LaminatedSection, fits: ScaleRange, s: FloatArray, K: FloatArray, least: float
) -> str:
    """Return the message that no scale of the stiffness fits both the softest and the stiffest place."""
    i, j, w1 = fits.lowest_at, fits.highest_at, np.asarray(section.base_width)
    ways: list[Refusal] = []
    try:
        ratio = section.thickness_ratio(K, least_backing=least)
    except InputError as error:
        ways = [note("choose other widths ({why})", why=error.refusal)]
    else:
        ways = [note(
            "make the backing at least {least:g} times as thick as the base (now {now:.3g} times)",
            least=rounded_up(1 / ratio, 3), now=section.backing.thickness / section.base.thickness,
        )]  # fmt: skip
    ways[1:1] = [
        note("narrow the base {s} from the start", s=Length(s[i])),
        note("widen the base {s} from the start", s=Length(s[j])),
    ]
    return note(
        "the laminate cannot be both soft enough at {soft} from the start (base sheet {soft_width} wide, "
        "relative stiffness {soft_stiffness:.3g}) and stiff enough at {stiff} from the start (base sheet "
        "{stiff_width} wide, relative stiffness {stiff_stiffness:.3g}): {ways}",
        soft=Length(s[i]), soft_width=Length(w1[i]), soft_stiffness=K[i],
        stiff=Length(s[j]), stiff_width=Length(w1[j]), stiff_stiffness=K[j], ways=Either(ways),
    )  # fmt: skip
