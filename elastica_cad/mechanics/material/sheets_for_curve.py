"""Which sheets bend as far as a curve asks, and how much larger it must be for the others."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature, NaturalCurvature
from elastica_cad.mechanics.material.sheet import Sheet, sheet_names


@dataclass(frozen=True)
class SheetForCurve:
    """A sheet, and the scale from which on a curve is gentle enough for it.

    Attributes
    ----------
    sheet : Sheet
    scale : float
        Largest strain of a strip in the curve over what the sheet bears for long: at 1 or less it can do the curve
        as drawn, else from so many times its size on.
    """

    sheet: Sheet
    scale: float

    @property
    def fits(self) -> bool:
        """Can it do the curve at this size?"""
        return self.scale <= 1.0


def sheets_for_curve(
    curve: PlaneCurve, natural_curvature: NaturalCurvature = 0.0, sheets: Iterable[Sheet] | None = None
) -> tuple[SheetForCurve, ...]:
    """All known sheets by the scale at which they bear a curve, those with the most to spare first.

    The skin of a sheet of thickness t is strained by |kappa - kappa_0| t / 2.

    Parameters
    ----------
    curve : PlaneCurve
    natural_curvature : float or RestCurvature
        Of the strip before it is bent, 1/mm.
    sheets : iterable of Sheet, optional
        Those to look at; all that have a name unless given.

    Examples
    --------
    >>> arc = PlaneCurve.arc((0, 0), 50, 0, 2)
    >>> found = {one.sheet.name: one for one in sheets_for_curve(arc)}
    >>> found["birch-plywood-0.8"].fits, round(found["birch-plywood-3"].scale, 1)
    (True, 5.6)
    """
    sharpest = float(np.abs(ExcessCurvature(curve, natural_curvature).survey).max())
    known = [Sheet.named(name) for name in sheet_names()] if sheets is None else sheets
    found = [SheetForCurve(one, sharpest * one.thickness / (2 * one.max_strain)) for one in known]
    return tuple(sorted(found, key=lambda one: one.scale))
