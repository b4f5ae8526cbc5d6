"""Styles, which convert stiffness into material: the plain style, and the layout that every style returns."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Protocol, TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import SEEN_APART, distinct_digits, require_number, require_positive, require_record
from elastica_cad.errors import InputError, rounded_up
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import LayerStrain
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.stiffness_law import (
    SAME_SCALE,
    BoundedLaw,
    LaidLeaves,
    StiffnessLaw,
    ThicknessLaw,
    scale_within,
)
from elastica_cad.refusals import FieldName, Length, note
from elastica_cad.strip.outline import Ends, long_sides
from elastica_cad.strip.slots import Slot

Width: TypeAlias = float | Profile | Callable[[FloatArray], FloatArray]
"""Outer width: a number, or a profile or function of arc length, all in mm."""

WIDTH_MM = 1e-6
"""Largest error, mm, of a width given as a function."""


SIZE_SHARE = 3e-6
"""Relative error of a section's size, about equal to the error of the stiffness from which it is computed."""

CORRECTION_TOLERANCE = 1e-6
"""Error of the corrected stiffness, relative to its largest value."""

CURVATURE_STATIONS = 2001
"""Number of places on the curve's smooth panels for computing the strain."""

_RODS = 64  # number of rods with cached bends; equal strips of a model share them

MOST_EXTREMES = 200
"""Largest number of local extremes with finer stations; more extremes are due to rounding."""

GUIDE_MM = 0.5
"""Least distance, mm, between the edges of backing and base at which the backing is marked on the base."""


NO_WIDTH = note(
    "a strip needs {max_width} or {min_width}, in mm, because its curve sets only the ratio of its widths",
    max_width=FieldName("max_width"), min_width=FieldName("min_width"),
)  # fmt: skip
"""Message for a plain strip without a width; other styles do not need `max_width`."""


@dataclass(frozen=True, eq=False)
class Bends:
    """Bend of a strip at stations along it.

    Attributes
    ----------
    amount : (n,) array
        |kappa - kappa_0|, 1/mm.
    places : (n,) array
        Arc lengths, mm, or parameters of `curve`.
    curve : PlaneCurve, optional
        Curve that converts parameters into arc lengths when they are needed.
    """

    amount: FloatArray
    places: FloatArray
    curve: PlaneCurve | None = None

    def arc_length(self, stations: int | slice) -> FloatArray:
        """Return the arc length of stations by number or slice, mm."""
        places = np.asarray(self.places[stations])
        return places if self.curve is None else self.curve.arc_length(places)

    @cached_property
    def s(self) -> FloatArray:
        """Arc lengths of all stations (n,), mm."""
        return self.arc_length(slice(None))

    def place(self, station: int) -> float:
        """Return the arc length of a station, mm."""
        return float(self.arc_length(station))


class Pattern(Protocol):
    """Holes in the free part of a strip."""

    def paths(self, ends: Ends, slots: Sequence[Slot]) -> tuple[Path, ...]:
        """Return the holes as closed loops, clear of the slots."""
        ...


@dataclass(frozen=True, eq=False)
class Backing:
    """Narrower strip that is glued on.

    Attributes
    ----------
    sheet : Sheet
    width : Profile
        mm along the free part.
    """

    sheet: Sheet
    width: Profile


@dataclass(frozen=True, eq=False)
class Layout:
    """Layout of a strip by a style, from a rod and a sheet.

    Attributes
    ----------
    sheet : Sheet
        Sheet of the outline.
    width : Profile
        Full width of the outline along the free part, mm.
    material : Profile
        Intended net width of the sheet, mm.
    bending_stiffness : float
        B, N mm2: bending stiffness E I where the relative stiffness K is 1.
    pattern : Pattern or None
        Holes.
    backing : Backing or None
        Backing that is glued on.
    dots : float
        Diameter of holes that align base and backing, mm; 0 for none.
    warnings : tuple of str
        Warnings for the maker.
    section : BoundedLaw or None
        Law of the stiffness, or None if the width is proportional to the stiffness with E.
    size : Profile or None
        Thickness or diameter of the section along the free part, mm, if it varies.
    """

    sheet: Sheet
    width: Profile
    material: Profile
    bending_stiffness: float
    pattern: Pattern | None = None
    backing: Backing | None = None
    dots: float = 0.0
    warnings: tuple[str, ...] = ()
    section: BoundedLaw | None = None
    size: Profile | None = None

    @property
    def stack(self) -> LaidLeaves | None:
        """Glued plies of the strip; None without plies."""
        return None if self.section is None else self.section.stack

    @property
    def worked_size(self) -> Profile | None:
        """Thickness or diameter, mm, after planing or turning, or None for strips that are cut, and for plies."""
        return self.size if self.stack is None else None

    def hole_paths(self, ends: Ends, slots: Sequence[Slot] = ()) -> tuple[Path, ...]:
        """Return closed loops to cut out of the free part, clear of the slots."""
        return () if self.pattern is None else self.pattern.paths(ends, slots)

    @property
    def guides(self) -> tuple[Path, ...]:
        """Lines on the base that mark the edges of the backing, unless the edges of the base are close to them."""
        if self.backing is None:
            return ()
        s = stations_of(self.width.length, count=201)
        if float((self.width(s) - self.backing.width(s)).max()) < GUIDE_MM:
            return ()
        return tuple(Path([side]) for sides in long_sides(self.backing.width) for side in sides)

    def law(self, material: FloatArray, backing: FloatArray | None) -> tuple[StiffnessLaw, FloatArray]:
        """Return the stiffness law of a sheet `material` (n,) wide, mm, and the law's parameter at each station."""
        if self.backing is None or backing is None:
            return PlainSection(self.sheet), material
        return LaminatedSection(self.sheet, self.backing.sheet).on(material), backing

    def strains(self, bends: Bends) -> tuple[LayerStrain, ...]:
        """Return the skin strain of each layer at stations along the strip."""
        if self.section is not None and self.size is not None:
            return self.section.strains(bends.amount, self.size(bends.s))
        if self.backing is None:  # the strain of a solid sheet does not depend on its width
            return PlainSection(self.sheet).strains(bends.amount)
        outer = self.width(bends.s)
        # a backing as wide as the base may exceed it by the tolerance of its fit
        law, parameter = self.law(outer, np.minimum(self.backing.width(bends.s), outer))
        return law.strains(bends.amount, parameter)

    def stiffness(self, material: FloatArray, backing: FloatArray | None = None) -> FloatArray:
        """Return the bending stiffness E I (n,), N mm2, for the net widths (n,), mm, of sheet and backing."""
        law, parameter = self.law(material, backing)
        return law.bending_stiffness(parameter)

    def weight_per_length(self, material: FloatArray, backing: FloatArray | None = None) -> FloatArray | None:
        """Return the weight (n,), N/mm, for net widths (n,), mm, or None for a single sheet.

        The weight of a single sheet is proportional to its stiffness.
        """
        law, parameter = self.law(material, backing)
        return None if backing is None or self.backing is None else law.weight_per_length(parameter)


class Style(Protocol):
    """Interface of a style, which turns stiffness into material."""

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the layout for a rod, or raise `InputError` with the place that cannot be made."""
        ...


@dataclass(frozen=True)
class Plain:
    """A solid strip of a single sheet, whose width is proportional to the stiffness.

    See the paper, section 8.1.
    """

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the layout; a width sets the scale, unless the rod has a bending stiffness."""
        require_laid_out(rod, sheet, max_width, min_width)
        if rod.section is not None:
            sized = _of_section(rod, rod.section, sheet)
            _within(sized.width, rod, min_width, max_width, slack=SAME_SCALE)
            return sized
        if max_width is None and min_width is None and rod.bending_stiffness is None:
            raise InputError(NO_WIDTH)
        rigidity = PlainSection(sheet).rigidity
        low, high = rod.profile.extremes
        if rod.bending_stiffness is not None:
            factor = rod.bending_stiffness / rigidity
        else:
            factor = (min_width or 0.0) / low if max_width is None else max_width / high
        width = rod.profile.scaled(factor)
        _within(width, rod, min_width, max_width, slack=SEEN_APART)
        return Layout(sheet, width, material=width, bending_stiffness=factor * rigidity)


def outline_field(style: object) -> FieldName:
    """Return the field that sets the width of the outline of a strip in a style."""
    return FieldName("max_width" if isinstance(style, Plain) else "style.width")


def require_style(style: object) -> None:
    """Refuse a value that is not a style."""
    if not callable(getattr(style, "laid_out", None)):
        raise InputError(
            f"style is {style!r}: give Plain(), Perforated(width=...) or Laminated(width=..., backing=...)"
        )


def require_laid_out(rod: object, sheet: object, *widths: object) -> None:
    """Refuse arguments of `Style.laid_out` of wrong types."""
    require_record(rod, Rod, "what is laid out", "a Rod")
    require_record(sheet, Sheet, "the sheet", "a Sheet")
    for width in widths:
        if width is not None:
            require_number(width, "a width", "mm")


def _within(
    width: Profile, rod: Rod, min_width: float | None, max_width: float | None, *, slack: float
) -> None:
    """Refuse widths beyond their limits."""
    narrow, wide = width.extremes
    if min_width is not None and narrow * (1 + slack) < min_width:
        shown, limit = distinct_digits(narrow, min_width, ".4g")
        raise InputError(
            "the narrowest place is {narrow:g} wide, less than {field} ({min_width:g}): set {wider} to "
            "{needed:g} or more (the widest place is {ratio:.3g} times as wide)",
            field=FieldName("min_width"),
            wider=FieldName("max_width"),
            narrow=Length(shown),
            min_width=Length(limit),
            ratio=rod.ratio,
            needed=Length(rounded_up(min_width * wide / narrow)),
        )
    if max_width is not None and wide > max_width * (1 + slack):
        shown, limit = distinct_digits(wide, max_width, ".4g")
        raise InputError(
            "the strip needs a width of {wide:g} for its bending stiffness, more than {field} "
            "({max_width:g}): choose a thicker or stiffer sheet",
            field=FieldName("max_width"),
            wide=Length(shown),
            max_width=Length(limit),
        )


def _of_section(rod: Rod, section: BoundedLaw, sheet: Sheet) -> Layout:
    """Return the layout for a section: given width of a tapered strip, or computed width or diameter."""
    profile = rod.profile
    if (stack := section.stack) is not None:
        B = rod.bending_stiffness or 1.0
        steps = Profile(profile.knots, section.parameter(B * profile.coefficients), profile.degree)
        even = width_profile(stack.width, rod.length, "width")
        return Layout(sheet, even, material=even, bending_stiffness=B, section=section, size=steps)
    least, largest = section.limits
    s = stations_of(rod.length, profile)
    limit = largest if np.isfinite(largest) else least
    law = section.bent(rod.bend_at(s), rod.rest_at(s))
    B = scale_within(law, profile(s), solved=rod.bending_stiffness, heavy=rod.gravity is not None)
    size = Profile.fit(
        lambda s: section.bent(_bend_between_steps(rod, s), rod.rest_at(s)).parameter(B * profile(s)), rod.length,
        breaks=profile.breaks, knots=profile.knots, tolerance=SIZE_SHARE * limit,
    )  # fmt: skip
    if section.quantity == "width":
        return Layout(sheet, size, material=size, bending_stiffness=B, section=section)
    width = size
    if isinstance(section, ThicknessLaw):
        width = width_profile(section.width, rod.length, "width")
    return Layout(sheet, width, material=width, bending_stiffness=B, section=section, size=size)


def _bend_between_steps(rod: Rod, s: FloatArray) -> FloatArray:
    """Return kappa - kappa_0 (n,), 1/mm, linear inside the ramps that represent steps of the stiffness."""
    bend = rod.bend_at(s)
    for step in rod.profile.steps:
        inside = (s > step[0]) & (s < step[1])
        bend[inside] = np.interp(s[inside], step, rod.bend_at(np.array(step)))
    return bend


PLAIN = Plain()
"""Default style."""


def width_profile(width: Width, length: float, name: str) -> Profile:
    """Return a width as a profile over [0, length], positive everywhere.

    Raises
    ------
    InputError
        The width is not positive somewhere, the profile has another length, or the function returns no numbers.
    """
    if isinstance(width, Profile):
        if not np.isclose(width.length, length, rtol=1e-6):
            raise InputError(
                (
                    "{name} covers a length of {length:.6g}, but the strip is {length_2:.6g} long: give it along "
                    "the whole strip"
                ),
                name=name,
                length=Length(width.length),
                length_2=Length(length),
            )
        profile = width
    elif callable(width):
        profile = Profile.fit(width, length, tolerance=WIDTH_MM)
    else:
        require_positive(width, name)
        value = float(width)
        return Profile(np.repeat([0.0, length], 4), np.full(4, value))
    if profile.extremes[0] <= 0:
        s = stations_of(length, profile)
        at = float(s[int(np.argmin(profile(s)))])
        raise InputError(
            "{name} is {given:.4g} at {at:.4g}: it must be positive everywhere",
            name=name,
            given=Length(float(profile(at))),
            at=Length(at),
        )
    return profile


def refine_stations(s: FloatArray, *values: FloatArray) -> FloatArray:
    """Return the stations (n,) with finer stations about the local extremes of `values` (n,)."""
    turns = [np.flatnonzero(np.diff(np.sign(np.diff(value)))) + 1 for value in values]
    extremes = np.unique(np.concatenate([[0, s.size - 1], *turns]).astype(int))[:MOST_EXTREMES]
    before, after = s[np.maximum(extremes - 1, 0)], s[np.minimum(extremes + 1, s.size - 1)]
    return np.unique(np.concatenate([s, np.linspace(before, after, 65).ravel()]))


def stations_of(length: float, *profiles: Profile, count: int = 2001) -> FloatArray:
    """Return dense stations (n,) in [0, length], mm, including the knots of the profiles."""
    knots = [profile.knots[(profile.knots >= 0) & (profile.knots <= length)] for profile in profiles]
    return np.unique(np.concatenate([np.linspace(0.0, length, count), *knots]))


def correct_layout(
    style: Style, rod: Rod, sheet: Sheet, correction: Profile, **widths: float | None
) -> Layout:
    """Return the layout of a style for a rod whose stiffness is multiplied by a correction."""
    drawn = rod.profile
    corrected = Profile.fit(
        lambda s: drawn(s) * correction(s), rod.length, breaks=drawn.breaks, knots=correction.knots,
        tolerance=CORRECTION_TOLERANCE * float(drawn.extremes[1]),
    )  # fmt: skip
    layout = style.laid_out(rod.with_stiffness(corrected), sheet, **widths)
    # bending stiffness E I where K = 1 in the original rod; `with_stiffness` has divided K by its corrected minimum
    return replace(layout, bending_stiffness=layout.bending_stiffness / float(corrected(rod.s).min()))


@lru_cache(maxsize=_RODS)
def bends_along(rod: Rod) -> Bends:
    """Return the bend of a rod at stations on its curve's smooth panels and on both sides of jumps."""
    if rod.shape is None:
        return Bends(np.abs(rod.curvature - rod.natural_curvature), rod.s)
    curve, rest = rod.curve, rod.natural_curvature
    panels = curve.smooth_panels
    places = np.linspace(0.0, panels.size - 1.0, max(CURVATURE_STATIONS, rod.s.size))
    t = np.interp(places, np.arange(panels.size), panels)
    jumps = np.array([at.t for at in curve.breaks if at.continuity < 2])
    t = np.sort(np.concatenate([t, jumps, jumps]))
    kappa = curve.curvature_at(t)
    if jumps.size:
        kappa[np.searchsorted(t, jumps)] = curve.curvature_at(jumps, left=True)
    if np.size(rest) > 1:
        rest = rod.rest_at(curve.arc_length(t))
    return Bends(np.abs(kappa - rest), t, curve)
