"""Check whether a strip can take a drawn curve, and changes that make an impossible curve possible, tried with a
common sheet and width.
"""

from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.elements import Pin, Rail, Tie
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import (
    NaturalCurvature,
    Supports,
    require_natural_curvature,
    require_supports,
    require_tolerance,
)
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable

if TYPE_CHECKING:
    from elastica_cad.strip.strip_spec import StripSpec
    from elastica_cad.strip.suggestions import Suggestion

TRIED_SHEETS = ("birch-plywood-0.8", "pom-0.5", "card-200gsm")
"""Sheets that are tried if no sheet is given, in order of decreasing thickness."""


def common_request(
    curve: PlaneCurve,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    between: tuple[Rail | Pin | Tie, ...] = (),
    sheet: Sheet | None = None,
    max_width: float | None = None,
) -> "StripSpec":
    """Return a request for a strip: by default 12 times as long as wide, from a thin sheet of `TRIED_SHEETS`."""
    from elastica_cad.strip.strip_spec import StripSpec

    curvature = np.abs(curve.survey.curvature).max()
    thin = (name for name in TRIED_SHEETS if Sheet.named(name).least_radius * curvature <= 1)
    return StripSpec(
        curve,
        next(thin, TRIED_SHEETS[-1]) if sheet is None else sheet,
        max_width=max_width or float(np.clip(round(curve.length / 12), 8.0, 120.0)),
        supports=supports or Supports(),
        natural_curvature=natural_curvature,
        between=between,
    )


@dataclass(frozen=True, repr=False)
class CurveCheck(EquilibriumCheck):
    """Result of the check of a drawn curve by Theorem 1 of the paper.

    Attributes
    ----------
    drawn : PlaneCurve
        The drawn curve.
    supports : Supports
    natural_curvature : float or RestCurvature
        Curvature of the unloaded strip, 1/mm.
    """

    drawn: PlaneCurve = field(kw_only=True, repr=False)
    supports: Supports = field(kw_only=True, repr=False)
    natural_curvature: NaturalCurvature = field(kw_only=True, repr=False)

    @cached_property
    def cures(self) -> "tuple[Suggestion, ...]":
        """At most four changes that make an impossible curve possible.

        Each change was tested: a strip of a common sheet is then stable and within its strain limit.

        Examples
        --------
        >>> points = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]
        >>> for suggestion in check_equilibrium(PlaneCurve.spline(points, degree=5)).cures:
        ...     print(suggestion.change.field, round(suggestion.deviation, 1))
        nearest 0.2
        point 9.0
        """
        from elastica_cad.strip.suggestions import suggest

        if self.realizable:
            return ()
        request = common_request(self.drawn, self.supports, self.natural_curvature)
        return tuple(suggest(request, NotRealizable(self)))


def check_equilibrium(
    curve: PlaneCurve,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    *,
    tolerance: float = 1e-4,
) -> CurveCheck:
    """Check whether a weightless flat strip with suitable widths can be at rest in a curve.

    Condition (1): there is a line that meets the curve exactly at the zeros of its curvature and is not tangent to
    the curve. Condition (2): the curvature changes sign at each zero with a finite slope. At a pinned end the
    curvature is zero, so the line passes through this end too. The line is vertical if an end is free to slide
    along x, and horizontal if it is free to slide along y. If the ends carry no force, there is no line. A natural
    curvature is subtracted from the curvature. If a closed curve begins at an inflection, its start is moved, and
    a warning is added.

    Parameters
    ----------
    supports : Supports
        By default both ends are clamped.
    natural_curvature : float or RestCurvature
        Curvature kappa_0 of the unloaded strip, 1/mm.
    tolerance : float
        Largest distance of the inflections from a line, as a fraction of the length. Inflections within this
        distance are moved onto the line (`moved`, `curve`). At an end that is free to turn, the curvature is
        set to zero within the same tolerance.

    References
    ----------
    Paper, Theorem 1 and section 4.3.

    Examples
    --------
    >>> wave = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 0)], degree=3)
    >>> check = check_equilibrium(wave)
    >>> check.realizable, len(check.inflections)
    (True, 1)
    """
    require_natural_curvature(natural_curvature)
    require_tolerance(tolerance)
    supports = require_supports(supports)
    check = examine(curve, supports, natural_curvature, tolerance)
    values = {entry.name: getattr(check, entry.name) for entry in fields(check)}
    return CurveCheck(**values, drawn=curve, supports=supports, natural_curvature=natural_curvature)
