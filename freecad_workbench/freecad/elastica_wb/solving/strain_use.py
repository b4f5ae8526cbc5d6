# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The sharpest bend of a curve, of which the rule of strain is asked before there is a strip."""

import numpy as np

from elastica_cad.geometry.curves.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, nodal_curvature

STEPS, FINER = 641, 21


def sharpest_bend(
    curve: PlaneCurve, rest: NaturalCurvature, samples: CurveSamples | None = None
) -> tuple[float, float]:
    """The most that a strip is bent by along a curve, 1/mm, and where, mm: by steps, then finer between two."""
    samples = curve.sample(STEPS) if samples is None else samples
    s, t = samples.s, samples.t
    most = int(np.argmax(np.abs(samples.curvature - nodal_curvature(rest, s))))
    fine = np.linspace(t[max(most - 1, 0)], t[min(most + 1, t.size - 1)], FINER)
    places = np.append(np.interp(fine, t, s), s[-1])  # a blank bent beforehand is as long as its curve
    bend = np.abs(curve.curvature_at(np.append(fine, t[-1])) - nodal_curvature(rest, places))
    best = int(np.argmax(bend))
    return float(bend[best]), float(places[best])
