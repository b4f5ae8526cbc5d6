# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Contents of the overlay as arrays of points in the plane of the sketch, without a window."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from freecad.elastica_wb.solving.strip_cache import find_rod
from freecad.elastica_wb.solving.verdicts import OFF_LINE, Answer, quick_answer, refusal_answer

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError, Length
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.mechanics.elements import noun_of
from elastica_cad.mechanics.loads import nodal_curvature
from elastica_cad.mechanics.section_limits import STRAIN_SLACK
from elastica_cad.mechanics.theorem1 import EquilibriumCheck
from elastica_cad.mechanics.thrust_line import thrust_sides
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec

TEETH = 161
# height of the curvature comb, as a fraction of the size of the curve
COMB_HEIGHT = 0.2
# length of the inflection line and the thrust line beyond the curve, as a fraction of its size
LINE_MARGIN = 0.15


Point = Sequence[float]


def _nothing() -> FloatArray:
    return np.zeros((0, 2))


@dataclass(frozen=True, eq=False)
class Picture:
    """Lines and marks of the overlay, mm in the plane of the sketch.

    Attributes
    ----------
    answer : Answer
        The result of the checks that need no search.
    realizable : bool or None
        True if a strip is possible, or None for a curve with weight, about which only the solver decides.
    comb, strained : tuple of (n, 2) arrays
        Rim and teeth of the curvature comb, within and beyond the strain limit of the sheet.
    line : (2, 2) array or None
        Part of the inflection line near the curve.
    on_line, off_line : (k, 2) arrays
        Inflections on the line, and inflections that are not on it.
    crossings : (k, 2) array
        Inadmissible crossings of the line and the curve.
    labels : tuple of ((x, y), mm)
        Positions and arc lengths of the inflections and crossings that the result of the check mentions.
    thrust : tuple of (n, 2) arrays
        Sides of the thrust line, for a curve with rails, pins, ties or point forces.
    stations : tuple of ((x, y), str)
        Positions of rails, pins, ties and point forces. The text is the kind, at the first position of each.
    cords : tuple of (2, 2) arrays
        Ties.
    """

    answer: Answer
    realizable: bool | None
    comb: tuple[FloatArray, ...]
    strained: tuple[FloatArray, ...]
    line: FloatArray | None = None
    on_line: FloatArray = field(default_factory=_nothing)
    off_line: FloatArray = field(default_factory=_nothing)
    crossings: FloatArray = field(default_factory=_nothing)
    labels: tuple[tuple[Point, Length], ...] = ()
    thrust: tuple[FloatArray, ...] = ()
    stations: tuple[tuple[Point, str], ...] = ()
    cords: tuple[FloatArray, ...] = ()


def curve_picture(curve: PlaneCurve, spec: StripSpec, scale: float | None = None) -> Picture:
    """Return the overlay of a curve with the supports and loads of `spec`.

    `scale` is the length of a tooth of the comb, mm, for a curvature of 1/mm.
    """
    scale = scale or comb_scale(curve)
    try:
        rod_spec = spec.changed(curve=curve).rod_spec
        smoothing, check = rod_spec.smoothing, rod_spec.check
        acting = (*rod_spec.elements, *rod_spec.forces)
    except ElasticaError as error:
        return Picture(refusal_answer(error), False, *_combs(curve.sample(TEETH), spec, scale))
    drawn_curve = smoothing.curve if smoothing.moved else curve
    samples = drawn_curve.sample(TEETH)
    comb, strained = _combs(samples, spec, scale)
    places = dict(check.off_line) or dict.fromkeys(check.inflections, 0.0)
    good = [s for s, d in places.items() if abs(d) <= OFF_LINE * check.length]
    bad = [s for s in places if s not in good]
    met = [*check.crossings, *check.touches]
    positions = [*good, *bad, *met]
    marks = _at(check.curve, positions)
    on_line, off_line, crossings = np.split(marks, [len(good), len(good) + len(bad)])
    answer, realizable = quick_answer(drawn_curve, spec, check), check.realizable
    thrust: tuple[FloatArray, ...] = ()
    if realizable and acting:
        try:
            rod = find_rod(rod_spec)
            low, high = rod.position.min(axis=0), rod.position.max(axis=0)
            margin = LINE_MARGIN * float(np.max(high - low))
            thrust = tuple(thrust_sides(rod, low - margin, high + margin))
        except ElasticaError as error:
            answer, realizable = refusal_answer(error), False
    places_of = [_at(check.curve, element.s) for element in acting]
    return Picture(
        answer=answer,
        realizable=None if rod_spec.gravity is not None and realizable else realizable,
        comb=comb,
        strained=strained,
        line=None if check.line is None else _line_near(check, samples.position),
        on_line=on_line,
        off_line=off_line,
        crossings=crossings,
        labels=tuple(zip(marks.tolist(), map(Length, positions), strict=True)),
        thrust=thrust,
        stations=tuple(
            (place.tolist(), "" if k else noun_of(element.element))
            for element, ends in zip(acting, places_of, strict=True)
            for k, place in enumerate(ends)
        ),
        cords=tuple(ends for ends in places_of if len(ends) > 1),
    )


def comb_scale(curve: PlaneCurve) -> float:
    """Return the length of a comb tooth, mm, for a curvature of 1/mm."""
    samples = curve.sample(TEETH)
    largest = float(np.abs(samples.curvature).max())
    extent = float(np.ptp(samples.position, axis=0).max())
    return COMB_HEIGHT * extent / largest if largest > 1e-12 / extent else 0.0


def width_lines(strip: Strip, count: int = 161) -> tuple[FloatArray, ...]:
    """Return lines (n, 2), mm, on both sides of the curve, as far apart as the strip is wide."""
    samples = strip.rod.curve.sample(count)
    aside = np.column_stack([-np.sin(samples.angle), np.cos(samples.angle)])
    half = strip.width(samples.s * (strip.width.length / samples.s[-1]))[:, None] / 2
    return samples.position + half * aside, samples.position - half * aside


def _combs(
    samples: CurveSamples, spec: StripSpec, scale: float
) -> tuple[tuple[FloatArray, ...], tuple[FloatArray, ...]]:
    """Return the curvature combs within and beyond the strain limit. As in FreeCAD, the combs point
    outward."""
    normals = np.column_stack([-np.sin(samples.angle), np.cos(samples.angle)])
    tips = samples.position - scale * samples.curvature[:, None] * normals
    bend = np.abs(samples.curvature - nodal_curvature(spec.natural_curvature, samples.s))
    strained = bend * spec.material.least_radius > 1 + STRAIN_SLACK
    teeth = np.stack([samples.position, tips], axis=1)
    edges = np.flatnonzero(np.diff(strained)) + 1
    runs = np.split(np.arange(len(tips)), edges)
    combs: tuple[list[FloatArray], list[FloatArray]] = ([], [])
    for run in runs:  # the rim of a part continues to the first tooth of the next part
        combs[int(strained[run[0]])].extend([tips[run[0] : run[-1] + 2], *teeth[run]])
    return tuple(combs[0]), tuple(combs[1])


def _at(curve: PlaneCurve, places: Sequence[float] | FloatArray) -> FloatArray:
    if not len(places):
        return _nothing()
    return np.asarray(curve.at(np.array(places)).position)


def _line_near(check: EquilibriumCheck, points: FloatArray) -> FloatArray:
    along, start = np.asarray(check.line.direction), np.asarray(check.line.point)
    shadow = (points - start) @ along
    margin = LINE_MARGIN * float(np.ptp(points, axis=0).max())
    return start + np.array([[shadow.min() - margin], [shadow.max() + margin]]) * along
