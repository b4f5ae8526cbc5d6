# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How much of the strain that a sheet bears is used, and how that is told: over 100 % where it breaks only."""

import numpy as np

from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.curves.curve_records import CurveSamples
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, nodal_curvature
from elastica_cad.mechanics.material.section_limits import STRAIN_SLACK

STEPS, FINER = 641, 21


def strain_use(strip: Strip) -> float:
    """Share of what the sheet bears; of two layers, of that which comes nearest to its limit."""
    return float(strip.max_strain / strip.strain_limit)


def is_beyond(used: float) -> bool:
    """Is that more than the sheet bears? A curve that is drawn at the limit is not."""
    return used > 1 + STRAIN_SLACK


def whole_percent(used: float) -> int:
    """As it is told: what is beyond the limit by a thousandth is no 100 %, and what is at the limit no more."""
    percent = round(100 * used)
    return max(percent, 101) if is_beyond(used) else min(percent, 100)


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
