"""Where a curve is cut into panels: where its bend, its load or its stiffness is not smooth, or varies much."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials.panel_functions import PanelFunction
from elastica_cad.geometry.polynomials.splines import knot_runs
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature, NaturalCurvature
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw
from elastica_cad.mechanics.stiffness.quadrature_panels import Panels, cut_into_panels
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

REFINEMENTS = 6
"""Rounds of solving anew on finer panels."""

_ROUGH = 1e-9  # last Legendre coefficients of K in a panel, relative to K, that call for smaller panels
_SMOOTH = 4  # continuous derivatives of K from which on a knot of the load needs no edge of a panel
_MOST_PARTS = 50  # of one panel under a heavy K


@dataclass(frozen=True, eq=False)
class CutCurve:
    """A curve and the parameters at which it is cut into panels, beside its zeros.

    Attributes
    ----------
    check : EquilibriumCheck
    natural_curvature : float or RestCurvature
    law : MaterialLaw or None
    cuts : tuple of float
        Parameters.
    kinks : tuple of (float, int)
        Arc lengths, mm, at which the stiffness has a kink, each with its continuity.
    """

    check: EquilibriumCheck
    natural_curvature: NaturalCurvature
    law: MaterialLaw | None
    cuts: tuple[float, ...]
    kinks: tuple[tuple[float, int], ...]

    @classmethod
    def where_kinked(
        cls,
        check: EquilibriumCheck,
        natural_curvature: NaturalCurvature,
        law: MaterialLaw | None = None,
        weight: Weight | None = None,
    ) -> "CutCurve":
        """Cut where the blank, the material law or the load is not smooth."""
        bend = _bend_kinks(check, natural_curvature, law)
        hung = _load_kinks(check.length, weight)
        places = [float(t) for t in check.curve.parameter(np.array([s for s, _ in hung]))] if hung else []
        cuts = (*(t for t, _, _ in bend), *places)
        return cls(check, natural_curvature, law, cuts, (*((s, c) for _, s, c in bend), *hung))

    @cached_property
    def panels(self) -> Panels:
        """The panels."""
        check = self.check
        return cut_into_panels(
            check.curve, [z.t for z in check.zeros], cuts=list(self.cuts),
            natural_curvature=self.natural_curvature, law=self.law,
        )  # fmt: skip

    def for_weight(self, gravity: Gravity) -> "CutCurve":
        """The same, panels longer than sqrt(kappa l_eg^3) cut, on which a heavy K varies."""
        panels = self.panels
        steep = np.sqrt(gravity.length**-3 / np.abs(panels.curvature).max(axis=1))
        parts = np.clip(np.ceil(np.diff(panels.edge_s) * steep / 2), 1, _MOST_PARTS).astype(int)
        edges = panels.edges
        inner = [np.linspace(a, b, n + 1)[1:-1] for a, b, n in zip(edges[:-1], edges[1:], parts, strict=True)]
        return self._also_at(np.concatenate(inner))

    def for_stiffness(self, stiffness: PanelFunction) -> "CutCurve | None":
        """The same, panels halved on which a stiffness is not resolved; None where it is resolved everywhere."""
        rough = stiffness.unresolved(_ROUGH)
        edges = self.panels.edges
        return self._also_at(((edges[1:] + edges[:-1]) / 2)[rough]) if rough.any() else None

    def _also_at(self, cuts: FloatArray) -> "CutCurve":
        return replace(self, cuts=(*self.cuts, *cuts))


def _bend_kinks(
    check: EquilibriumCheck, natural_curvature: NaturalCurvature, law: MaterialLaw | None
) -> list[tuple[float, float, int]]:
    """(t, s, continuity of K) where the blank or the material law is not smooth."""
    excess = ExcessCurvature(check.curve, natural_curvature)
    return [*excess.kinks] + [
        (place.t, place.s, continuity)
        for curvature, continuity in (() if law is None else law.kinks)
        for side in (-curvature, curvature)
        for place in excess.equals(side)
    ]


def _load_kinks(length: float, weight: Weight | None) -> list[tuple[float, int]]:
    """(s, continuity of K) where the load is not smooth, or a mass hangs."""
    if weight is None:
        return []
    kinks: list[tuple[float, int]] = []
    for mass in weight.masses:
        if not (np.isfinite(mass.mass) and 0 <= mass.at <= length):
            raise InputError(
                f"point mass of {mass.mass:.6g} g at {mass.at:.6g} mm does not lie on the curve of "
                f"{length:.6g} mm"
            )
        kinks.append((mass.at, 0))
    for part in (weight.alpha, weight.beta):
        if isinstance(part, Profile):
            if not np.isclose(part.length, length, rtol=1e-6):
                raise InputError(f"a weight profile is {part.length:.6g} mm long, the curve {length:.6g} mm")
            # the moment is twice an integral of the load
            knots, times = knot_runs(part.knots)
            smooth = part.degree - times + 2
            kinks += [(float(s), int(c)) for s, c in zip(knots, smooth, strict=True) if c < _SMOOTH]
    return [(s, c) for s, c in kinks if 0 < s < length]
