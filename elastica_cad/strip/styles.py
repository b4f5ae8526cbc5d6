"""Styles of a strip, which convert the stiffness of a rod into a flat pattern: interface, and the plain style."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Protocol, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import SEEN_APART, distinct_digits, require_number, require_positive, require_record
from elastica_cad.errors import FaultError, FieldName, InputError, Length, note, rounded_up
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import (
    SAME_SCALE,
    LaidLeaves,
    Section,
    ThicknessLaw,
    scale_within,
)
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import LayerStrain
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.outline import Ends, long_sides
from elastica_cad.strip.slots import Slot

Width: TypeAlias = float | Profile | Callable[[FloatArray], FloatArray]
"""Width of an outline, mm: a number, a profile, or a function of the arc length, mm."""

NO_WIDTH = note(
    "Give {max_width} or {min_width} in mm, because the curve sets only the ratio of the widths",
    max_width=FieldName("max_width"), min_width=FieldName("min_width"),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Bends:
    """Change of the curvature by bending, at n stations along a strip.

    Attributes
    ----------
    amount : (n,) array
        Magnitude |kappa - kappa_0| of the change, 1/mm.
    places : (n,) array
        Arc lengths of the stations, mm, or their parameters on `curve`.
    curve : PlaneCurve, optional
        Curve that converts parameters into arc lengths when they are needed.
    """

    amount: FloatArray
    places: FloatArray
    curve: PlaneCurve | None = None

    def arc_length(self, stations: int | slice) -> FloatArray:
        """Return the arc lengths, mm, of stations with the given index or slice."""
        places = np.asarray(self.places[stations])
        return places if self.curve is None else self.curve.arc_length(places)

    @cached_property
    def s(self) -> FloatArray:
        """Arc lengths of all stations (n,), mm."""
        return self.arc_length(slice(None))

    def place(self, station: int) -> float:
        """Return the arc length of the station with the given index, mm."""
        return float(self.arc_length(station))


class Pattern(Protocol):
    """Pattern of holes in the bent part of a strip."""

    def paths(self, ends: Ends, slots: Sequence[Slot]) -> tuple[Path, ...]:
        """Return the holes as closed loops, clear of tabs and slots."""
        ...


@dataclass(frozen=True, eq=False)
class Backing:
    """Narrower strip that is glued to the base of a laminate.

    Attributes
    ----------
    sheet : Sheet
    width : Profile
        Width along the bent part, mm.
    """

    sheet: Sheet
    width: Profile


@dataclass(frozen=True, eq=False)
class Layout:
    """Flat pattern of a strip, computed by a style from a rod and a sheet.

    Attributes
    ----------
    sheet : Sheet
        Sheet of the outline.
    width : Profile
        Full width of the outline along the bent part, mm.
    material : Profile
        Intended net width of the sheet, mm.
    bending_stiffness : float
        Bending stiffness E I where the relative stiffness K is 1, N mm2.
    pattern : Pattern or None
        Pattern of holes.
    backing : Backing or None
        Backing of a laminate.
    dots : float
        Diameter of the holes that align base and backing, mm; 0 for none.
    warnings : tuple of str
        Warnings about the pattern.
    section : Section or None
        Section with limits, or None if the width is proportional to the stiffness.
    size : Profile or None
        Thickness or diameter along the bent part, mm, if the section prescribes it, else None. For glued plies,
        the thickness of the stack.
    """

    sheet: Sheet
    width: Profile
    material: Profile
    bending_stiffness: float
    pattern: Pattern | None = None
    backing: Backing | None = None
    dots: float = 0.0
    warnings: tuple[str, ...] = ()
    section: Section | None = None
    size: Profile | None = None

    @property
    def stack(self) -> LaidLeaves | None:
        """Glued plies of the strip, or None for other strips."""
        return None if self.section is None else self.section.stack

    @property
    def worked_size(self) -> Profile | None:
        """Thickness or diameter of a planed or turned strip, mm, or None for other strips."""
        return self.size if self.stack is None else None

    def hole_paths(self, ends: Ends, slots: Sequence[Slot] = ()) -> tuple[Path, ...]:
        """Return the holes in the bent part as closed loops, clear of tabs and slots."""
        return () if self.pattern is None else self.pattern.paths(ends, slots)

    @property
    def guides(self) -> tuple[Path, ...]:
        """Lines on the base that mark the edges of the backing; none if the widths are nearly equal."""
        if self.backing is None:
            return ()
        s = stations_of(self.width.length, count=201)
        if (self.width(s) - self.backing.width(s)).max() < 0.5:
            return ()
        return tuple(Path([side]) for sides in long_sides(self.backing.width) for side in sides)

    def section_of(self, material: FloatArray, backing: FloatArray | None) -> tuple[Section, FloatArray]:
        """Return the section for net widths (n,) of sheet and backing, mm, and the values (n,) of its parameter."""
        if self.backing is None or backing is None:
            return PlainSection(self.sheet), material
        return LaminatedSection(self.sheet, self.backing.sheet, material), backing

    def section_at(self, s: FloatArray) -> tuple[Section, FloatArray]:
        """Return the section at arc lengths s (n,), mm, and the values (n,) of its parameter."""
        if self.section is not None and self.size is not None:
            return self.section, self.size(s)
        material = self.material(s)
        # rounding can make the backing slightly wider than the base
        backing = None if self.backing is None else np.minimum(self.backing.width(s), material)
        return self.section_of(material, backing)

    def strains(self, bends: Bends) -> tuple[LayerStrain, ...]:
        """Return the surface strain of each layer at stations along the strip."""
        section, parameter = self.section_at(bends.s)
        return section.strains(bends.amount, parameter)


class Style(Protocol):
    """Interface of a style, which converts stiffness into a flat pattern."""

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the flat pattern of a rod, or raise `InputError` if it cannot be made."""
        ...


@dataclass(frozen=True)
class Plain:
    """A solid strip of a single sheet, whose width is proportional to the stiffness.

    See the paper, section 8.1.
    """

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the flat pattern of a rod.

        The bending stiffness of the rod determines the widths. If this stiffness is None, `max_width` or
        `min_width` determines them.
        """
        require_laid_out(rod, sheet, max_width, min_width)
        if rod.section is not None:
            sized = _laid_out_by_section(rod, rod.section, sheet)
            _require_width_within(sized.width, rod, min_width, max_width, slack=SAME_SCALE)
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
        _require_width_within(width, rod, min_width, max_width, slack=SEEN_APART)
        return Layout(sheet, width, material=width, bending_stiffness=factor * rigidity)


def outline_field(style: object) -> FieldName:
    """Return the name of the field that determines the outline width in a style."""
    return FieldName("max_width" if isinstance(style, Plain) else "style.width")


def require_style(style: object) -> None:
    """Raise InputError for a value that is not a style."""
    if not callable(getattr(style, "laid_out", None)):
        raise InputError(
            f"style is {style!r}: give Plain(), Perforated(width=...) or Laminated(width=..., backing=...)"
        )


def require_laid_out(rod: object, sheet: object, *widths: object) -> None:
    """Raise InputError for arguments of `Style.laid_out` that have a wrong type."""
    require_record(rod, Rod, "what is laid out", "a Rod")
    require_record(sheet, Sheet, "the sheet", "a Sheet")
    for width in widths:
        if width is not None:
            require_number(width, "a width", "mm")


def _require_width_within(
    width: Profile, rod: Rod, min_width: float | None, max_width: float | None, *, slack: float
) -> None:
    # `slack` is the fraction by which a width may be beyond its limit
    narrow, wide = width.extremes
    if min_width is not None and narrow * (1 + slack) < min_width:
        shown, limit = distinct_digits(narrow, min_width, ".4g")
        raise FaultError(
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
        raise FaultError(
            "the strip needs a width of {wide:g} for its bending stiffness, more than {field} "
            "({max_width:g}): choose a thicker or stiffer sheet",
            field=FieldName("max_width"),
            wide=Length(shown),
            max_width=Length(limit),
        )


def _laid_out_by_section(rod: Rod, section: Section, sheet: Sheet) -> Layout:
    """Return the flat pattern of a strip with a section, which determines width, thickness or diameter."""
    profile, B = rod.profile, rod.bending_stiffness or 1.0
    if section.stack is not None:
        size = Profile(profile.knots, section.parameter(B * profile.coefficients), profile.degree)
    else:
        s = stations_of(rod.length, profile)
        bent = section.bent(rod.bend_at(s), rod.rest_at(s))
        B = scale_within(bent, profile(s), solved=rod.bending_stiffness, heavy=rod.gravity is not None)
        # the error of the stiffness is similar to this relative error of the size
        size = Profile.fit(
            lambda s: section.bent(_bend_between_steps(rod, s), rod.rest_at(s)).parameter(B * profile(s)),
            rod.length, breaks=profile.breaks, knots=profile.knots,
            tolerance=3e-6 * section.deciding_limit,
        )  # fmt: skip
    width = width_profile(section.width, rod.length, "width") if isinstance(section, ThicknessLaw) else size
    varies = None if section.quantity == "width" else size
    return Layout(sheet, width, material=width, bending_stiffness=B, section=section, size=varies)


def _bend_between_steps(rod: Rod, s: FloatArray) -> FloatArray:
    """Return the change of curvature kappa - kappa_0 (n,), 1/mm, at stations s (n,), mm.

    The change is interpolated across steps of the stiffness.
    """
    bend = rod.bend_at(s)
    for step in rod.profile.steps:
        inside = (s > step[0]) & (s < step[1])
        bend[inside] = np.interp(s[inside], step, rod.bend_at(np.array(step)))
    return bend


PLAIN = Plain()


def width_profile(width: Width, length: float, name: str) -> Profile:
    """Return a width as a profile over [0, length]."""
    if isinstance(width, Profile):
        if not np.isclose(width.length, length, rtol=1e-6):
            covered, strip_length = distinct_digits(width.length, length, ".6g")
            raise InputError(
                (
                    "{name} covers a length of {covered:.12g}, but the strip is {strip_length:.12g} long: give a "
                    "width along the whole strip"
                ),
                name=name,
                covered=Length(covered),
                strip_length=Length(strip_length),
            )
        profile = width
    elif callable(width):
        profile = Profile.fit(width, length, tolerance=1e-6)
    else:
        require_positive(width, name)
        return Profile(np.repeat([0.0, length], 4), np.full(4, float(width)))
    if profile.extremes[0] <= 0:
        s = stations_of(length, profile)
        at = float(s[profile(s).argmin()])
        raise InputError(
            "{name} is {given:.4g} at {at:.4g} from the start: give numbers above 0 everywhere",
            name=name,
            given=Length(profile(at)),
            at=Length(at),
        )
    return profile


def refine_stations(s: FloatArray, *values: FloatArray) -> FloatArray:
    """Return the stations `s` (n,) with additional stations near the local extremes of all `values` (n,)."""
    # indices at which the slope of the values changes its sign
    turns = [np.flatnonzero(np.diff(np.sign(np.diff(value)))) + 1 for value in values]
    # more extremes are rounding errors
    extremes = np.unique(np.concatenate([[0, s.size - 1], *turns]).astype(int))[:200]
    before, after = s[np.maximum(extremes - 1, 0)], s[np.minimum(extremes + 1, s.size - 1)]
    return np.unique(np.concatenate([s, np.linspace(before, after, 65).ravel()]))


def stations_of(length: float, *profiles: Profile, count: int = 2001) -> FloatArray:
    """Return `count` evenly spaced stations in [0, length], mm, together with the knots of the profiles."""
    knots = [profile.knots[(profile.knots >= 0) & (profile.knots <= length)] for profile in profiles]
    return np.unique(np.concatenate([np.linspace(0.0, length, count), *knots]))


def correct_layout(
    style: Style, rod: Rod, sheet: Sheet, correction: Profile, **widths: float | None
) -> Layout:
    """Return the flat pattern of a rod whose stiffness is multiplied by a correction."""
    drawn = rod.profile
    corrected = Profile.fit(
        lambda s: drawn(s) * correction(s), rod.length, breaks=drawn.breaks, knots=correction.knots,
        tolerance=1e-6 * drawn.extremes[1],
    )  # fmt: skip
    # `with_stiffness` divides K by its minimum, so E I for K = 1 is multiplied by the same number. The last line
    # reverses this: the layout returned has the E I of the place where K of `rod` times the correction is 1
    least, changed = float(corrected(rod.s).min()), rod.with_stiffness(corrected)
    if rod.bending_stiffness is not None:
        changed = replace(changed, bending_stiffness=least * rod.bending_stiffness)
    layout = style.laid_out(changed, sheet, **widths)
    return replace(layout, bending_stiffness=layout.bending_stiffness / least)


# equal strips share a rod
@lru_cache(maxsize=64)
def bends_along(rod: Rod) -> Bends:
    """Return the change of curvature of a rod at stations along its curve and on both sides of jumps."""
    if rod.shape is None:
        return Bends(np.abs(rod.curvature - rod.natural_curvature), rod.s)
    curve, rest = rod.curve, rod.natural_curvature
    panels = curve.smooth_panels
    # equally many stations in each panel
    places = np.linspace(0.0, panels.size - 1.0, max(2001, rod.s.size))
    t = np.interp(places, np.arange(panels.size), panels)
    jumps = np.array([at.t for at in curve.breaks if at.continuity < 2])
    # each jump is included twice: first with the curvature on its left, then with that on its right
    t = np.sort(np.concatenate([t, jumps, jumps]))
    kappa = curve.curvature_at(t)
    if jumps.size:
        kappa[t.searchsorted(jumps)] = curve.curvature_at(jumps, left=True)
    if np.size(rest) > 1:
        rest = rod.rest_at(curve.arc_length(t))
    return Bends(np.abs(kappa - rest), t, curve)
