"""Requests for a rod that follows a curve exactly, or for the nearest rod within limits."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from elastica_cad._values import EqualByValue, require_record
from elastica_cad.errors import Change, InputError, NotMetError, rounded_up
from elastica_cad.forming.fairing_request import Smoothing, check_smooth
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest_record import NearestRod, Status
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.least_ratio import optimal_laminate, rod_of_request
from elastica_cad.mechanics.loads import (
    Gravity,
    NaturalCurvature,
    Supports,
    Weight,
)
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.optimal_balance import OverloadError
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import PlainSection, WidthRange
from elastica_cad.mechanics.stiffness_law import BoundedLaw
from elastica_cad.mechanics.theorem1 import EquilibriumCheck
from elastica_cad.refusals import FieldName, Length, note


@dataclass(frozen=True, eq=False)
class LaminateLayers:
    """A base of known width with a glued layer; its weight is not proportional to its stiffness.

    Attributes
    ----------
    section : LaminatedSection
    base_width : float or Profile
        mm.
    least_backing : float
        Narrowest backing that can be cut and glued, mm.
    """

    section: LaminatedSection
    base_width: float | Profile
    least_backing: float


@dataclass(frozen=True, eq=False)
class RodSpec(EqualByValue):
    """Complete request for a rod; equal requests give equal rods.

    Parameters
    ----------
    curve : PlaneCurve
    gravity : Gravity, optional
    supports : Supports, optional
        Clamped at both ends by default.
    natural_curvature : float or RestCurvature
        Curvature of the strip before bending, 1/mm, constant or along the strip.
    samples : int, optional
        Number of nodes; chosen automatically by default.
    weight : Weight, optional
        Loads in newtons, as in `optimal_rod`.
    limits, keep : Limits, Keep, optional
        If either is given, the curve may change.
    layers : LaminateLayers, optional
        Layers of a laminate with weight.
    smooth : float, optional
        Largest distance that smoothing may move the curve, mm: see `smooth_curve`.
    section : BoundedLaw, optional
        Relation of section and stiffness, as in `optimal_rod`.
    widths : WidthRange, optional
        Widths of a plain strip that carries loads.
    outline_widths : (float or None, float or None)
        Requested largest and least width of the strip, mm, for the decision of `smooth_curve`.

    Raises
    ------
    InputError
        An impossible smoothing, or requests that exclude each other.
    """

    curve: PlaneCurve
    gravity: Gravity | None = None
    supports: Supports = field(default_factory=Supports)
    natural_curvature: NaturalCurvature = 0.0
    samples: int | None = None
    weight: Weight | None = None
    limits: Limits | None = None
    keep: Keep | None = None
    layers: LaminateLayers | None = None
    smooth: float | None = None
    section: BoundedLaw | None = None
    widths: WidthRange | None = None
    outline_widths: tuple[float | None, float | None] = (None, None)

    def __post_init__(self) -> None:
        object.__setattr__(self, "smooth", check_smooth(self.smooth))
        if self.layers is not None and (self.may_change or self.natural_curvature != 0.0):
            raise InputError(
                "a laminate that carries its weight follows its curve exactly, from flat sheets: do without the "
                "nearest curve ({limits}) and {natural_curvature}, or without {gravity}",
                limits=FieldName("limits"),
                natural_curvature=FieldName("natural_curvature"),
                gravity=FieldName("gravity"),
                where={"field": ("limits", "natural_curvature", "gravity")},
            )
        if self.weight is not None and self.gravity is None:
            raise InputError(
                "loads hang where gravity pulls in the plane of the curve: set {gravity}, with a direction "
                "in that plane, or leave out {loads}",
                gravity=FieldName("gravity"),
                loads=FieldName("loads"),
                where={"field": ("gravity", "loads")},
            )
        if self.may_change and self.samples is not None:
            raise InputError(
                "samples are of a strip that follows its curve exactly: do without the nearest curve ({limits}), "
                "or without {samples}",
                limits=FieldName("limits"),
                samples=FieldName("samples"),
                where={"field": ("limits", "samples")},
            )
        if self.may_change and self.weight is not None:
            raise InputError(
                "a strip with loads hung on it follows its curve exactly: do without the nearest curve ({limits}), "
                "or without {loads}",
                limits=FieldName("limits"),
                loads=FieldName("loads"),
                where={"field": ("limits", "loads")},
            )

    @property
    def may_change(self) -> bool:
        """May the rod leave the drawn curve?"""
        return self.limits is not None or self.keep is not None

    @cached_property
    def smoothing(self) -> Smoothing:
        """The drawn curve and the smoothed curve."""
        return Smoothing(self.curve, self.smooth, self.supports, self.natural_curvature, self.outline_widths)

    @cached_property
    def check(self) -> EquilibriumCheck:
        """Theorem 1 on the curve that is bent; a strip that feels its weight needs no line."""
        curve, heavy = self.smoothing.curve, self.gravity is not None
        return examine(curve, self.supports, self.natural_curvature, heavy=heavy)

    def solve(self) -> "Rod | NearestRod":
        """Return the rod that rests in the curve, or the nearest rod if the curve may change.

        Raises
        ------
        NotRealizable
            No rod takes the curve, and it may not change.
        InputError, NotConvergedError
            As `optimal_rod`, `optimal_laminate` and `nearest_rod`.
        """
        if self.may_change:
            from elastica_cad.forming.nearest_search import find_nearest
            from elastica_cad.forming.nearest_task import NearestRequest

            return find_nearest(NearestRequest(
                self.smoothing.curve, self.limits or Limits(), self.keep or Keep(), self.gravity, self.supports,
                section=self.section, natural_curvature=self.natural_curvature,
            ))  # fmt: skip
        if self.layers is not None and self.gravity is not None:
            return optimal_laminate(
                self.smoothing.curve,
                self.layers.section,
                self.layers.base_width,
                direction=self.gravity.direction,
                supports=self.supports,
                samples=self.samples,
                least_backing=self.layers.least_backing,
                masses=() if self.weight is None else self.weight.masses,
            ).rod
        limits: Any = {} if self.widths is None else self.widths.stiffness
        try:
            rod = rod_of_request(RodRequest(
                self.check, self.supports, self.natural_curvature, self.gravity, self.weight,
                section=self.section, samples=self.samples, **limits,
            ))  # fmt: skip
        except OverloadError as error:
            raise (error if self.widths is None else _too_narrow(self.widths, error)) from None
        return rod if self.widths is None else _with_widest(rod, self.widths)


WIDTH_TOLERANCE_MM = 0.1
"""Difference between the largest width and `max_width`, mm, above which there is a warning."""


def _with_widest(rod: Rod, widths: WidthRange) -> Rod:
    """Return the rod, with a warning if its largest width is below the allowed width."""
    widest = rod.profile.extremes[1] * (rod.bending_stiffness or 0.0) / PlainSection(widths.sheet).rigidity
    if widths.largest is None or widest > widths.largest - WIDTH_TOLERANCE_MM:
        return rod
    told = note(
        "This load determines the width: the widest place is {widest:.4g} wide, below {field} {largest:g}.",
        field=FieldName("max_width"), widest=Length(widest), largest=Length(widths.largest), severity="warning",
    )  # fmt: skip
    return replace(rod, warnings=(*rod.warnings, told))


def _too_narrow(widths: WidthRange, error: OverloadError) -> InputError:
    """Return the error for a load that no strip of these widths carries."""
    needed = rounded_up(error.needed / PlainSection(widths.sheet).rigidity, 4)
    changes, otherwise = [Change("max_width", needed)], ""
    if error.thickening is not None:
        thickness = rounded_up(error.thickening * widths.sheet.thickness, 4)
        changes.append(Change("thickness", thickness))
        otherwise = note(", or use a sheet {thickness:.4g} thick or thicker", thickness=Length(thickness))
    return InputError(
        "No strip between {least:.4g} and {largest:.4g} wide carries this load. Set {field} to {needed:.4g} "
        "or more{otherwise}.",
        field=FieldName("max_width"),
        least=Length(widths.least),
        largest=Length(widths.largest or 0.0),
        needed=Length(needed),
        otherwise=otherwise,
        where={"field": "max_width"},
        changes=changes,
    )


def accepted_rod(found: Rod | NearestRod) -> Rod:
    """Return the rod of a result, with the warning of the search if there is one.

    Raises
    ------
    NotMetError
        No rod near the curve meets the limits; the message has suggestions.
    """
    if isinstance(found, Rod):
        return found
    require_record(found, NearestRod, "what was found", "a Rod or NearestRod")
    if not found.met:
        raise NotMetError(str(found))
    if found.status is Status.MET:
        return found.rod
    return replace(found.rod, warnings=(*found.rod.warnings, found.status.value))
