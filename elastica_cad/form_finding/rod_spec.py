"""Request for a rod that follows a curve exactly, or for the nearest rod within limits."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.form_finding.fairing_request import Smoothing, check_smooth
from elastica_cad.form_finding.limits import Keep, Limits, Measure
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.least_ratio import LaminateLayers
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import Sheet

Weights: TypeAlias = "ArrayLike | Callable[[FloatArray], ArrayLike] | None"


@dataclass(frozen=True, eq=False)
class RodSpec(RodRequest):
    """Request for a rod that follows a drawn or smoothed curve, or for the nearest rod within limits.

    Equal requests give equal rods.

    Parameters
    ----------
    limits, keep : Limits, Keep, optional
        Limits, and properties to keep. With either, the curve may change.
    layers : LaminateLayers, optional
        Layers of a laminate that carries its own weight.
    smooth : float, optional
        Largest distance that smoothing may move the curve, mm: see `smooth_curve`.
    widths : PlainSection, optional
        Section with limits of its width, for a solid strip that carries loads.
    sheet : Sheet, optional
        Sheet that the refusal of a curve too sharp for it names; None for a section of other thickness.
    weights, measure, coefficients
        Options of the search for the nearest rod, as in `nearest_rod`.
    """

    limits: Limits | None = None
    keep: Keep | None = None
    layers: LaminateLayers | None = None
    smooth: float | None = None
    widths: PlainSection | None = None
    weights: Weights = None
    measure: Measure = "max"
    coefficients: int | None = None
    sheet: Sheet | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "smooth", check_smooth(self.smooth))

    @property
    def may_change(self) -> bool:
        """True if the rod may deviate from the drawn curve."""
        return self.limits is not None or self.keep is not None

    @cached_property
    def smoothing(self) -> Smoothing:
        """Drawn curve, with its smoothed curve."""
        return Smoothing(
            self.curve, self.smooth, self.supports, self.natural_curvature, with_elements=bool(self.between)
        )

    @property
    def curve_to_bend(self) -> PlaneCurve:
        """Curve of the rod: smoothed, or as drawn."""
        return self.smoothing.curve
