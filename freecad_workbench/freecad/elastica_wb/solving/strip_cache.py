# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Cached strips and nearest curves; equal requests are computed once."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache, wraps
from typing import Any, NamedTuple, TypeVar

import Part
from freecad.elastica_wb.curves.part_shapes import make_solid, make_wire
from freecad.elastica_wb.curves.sketch_curves import MOST_DRAGGED
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.progress import in_background
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.host.sheet_store import default_sheet, sheet_called

from elastica_cad.errors import ElasticaError, Length, NotConvergedError, note
from elastica_cad.form_finding.curve_distance import TargetCurve, measure_deviation
from elastica_cad.form_finding.editable_curve import coarse_curves
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import DRAWN_POINTS, PlaneCurve
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import STRAIN_SLACK, sharpest_bend
from elastica_cad.mechanics.stability import SAFE_MARGIN, Stability, stability
from elastica_cad.strip.drawing import ENGRAVE
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.solids import BentSolid, BodyRecord, FlatSolid, glued
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.suggestions import Suggestion, suggest

Result = TypeVar("Result")


def remembered(function: Callable[..., Result]) -> Callable[..., Result]:
    """Cache the last 256 results or errors of a function, enough for two states of a hundred strips.

    Errors are cached too, because FreeCAD recomputes a failed object at each change of the document.
    """

    @lru_cache(maxsize=256)
    def outcome(*arguments: Any) -> Result | ElasticaError:
        try:
            return function(*arguments)
        except ElasticaError as error:
            return error

    @wraps(function)
    def result_or_error(*arguments: Any) -> Result:
        result = outcome(*arguments)
        if isinstance(result, ElasticaError):
            raise result.with_traceback(None)  # remove the traceback of earlier calls
        return result

    return result_or_error


MANY_HOLES = 100
# divisor of the curvature limit of a rod, because a spline through the rod is curved more sharply
HEADROOM = 1.003
# largest number of searches, and factor by which each search overcorrects an exceeded limit
STRICTER, BEYOND = 4, 1.3
# a curve closer than this, mm, to the nearest curve within the limits counts as within the limits
AS_DRAWN_MM = 0.05
SEARCHING = QT_TRANSLATE_NOOP("Elastica", "Searching the nearest curve")


def default_spec(curve: PlaneCurve) -> StripSpec:
    """Return the `StripSpec` for a strip along a curve with the sheet and the width of the preferences."""
    return StripSpec(curve, sheet_called(default_sheet()), max_width=preferences.get("MaxWidth"))


def solve_strip(spec: StripSpec) -> Strip:
    """Return the strip that a request describes."""
    spec = _shared_request(spec.in_plane)
    return in_background(SEARCHING, _strip, spec) if spec.may_change else _strip(spec)


@remembered
def changes_that_help(spec: StripSpec, fields: tuple[str, ...]) -> tuple[Suggestion, ...]:
    """Return changes of these fields that make a refused strip possible. This takes some seconds."""
    try:
        _strip(spec.in_plane)
    except ElasticaError as problem:
        return tuple(suggest(spec.in_plane, problem, fields))
    return ()


def moved_by_smoothing(spec: StripSpec) -> float:
    """Return the largest distance, mm, by which smoothing moves the curve of a request."""
    return _shared_request(spec.in_plane).rod_spec.smoothing.moved


@remembered
def _shared_request(spec: StripSpec) -> StripSpec:
    """Cache requests, so that equal requests share the computed smoothing."""
    return spec


@remembered
def find_nearest_now(spec: RodSpec) -> NearestRod:
    """Return the nearest rod whose curve, as a spline, is within the limits.

    The curvature of the spline differs from the rod's curvature by a few thousandths. Therefore the limits of
    the rod are tightened.
    """
    limits = spec.limits
    most = None if limits is None else limits.largest_curvature
    if limits is None or most is None:
        return find_rod(spec)
    factor = HEADROOM
    for _ in range(STRICTER):
        near = find_rod(replace(spec, limits=limits.tightened(curvature=factor, strain=factor)))
        if near.found is None or not near.met:
            break
        try:
            used = sharpest_bend(near.curve, spec.natural_curvature)[0] / most
        except NotConvergedError:  # so close to snapping that a finer rod snaps
            limits = replace(limits, margin=2 * (limits.margin or SAFE_MARGIN))
            continue
        if used <= 1 + STRAIN_SLACK:
            return near
        factor *= 1 + BEYOND * (used - 1)
    return find_rod(spec)


# factor by which limits are tightened, because a curve with few poles differs from its rod
TIGHTER = 1.01
# numbers of coefficients of the stiffness, tried in order: the curve of a rod with few of them needs few poles
COEFFICIENTS, SPANS = (None, 14, 10, 6), (8, 12, 16, 20)
# largest deviation with few poles: this multiple of the deviation with all poles, or this fraction of the
# length, whichever is larger
FARTHER, NEAR_FRACTION = 3, 0.01


class DraggableCurve(NamedTuple):
    """A nearest rod with its curve, whose distance from the drawn curve is `deviation`, mm, and a message on it."""

    near: NearestRod
    curve: PlaneCurve
    deviation: float
    cost: str


@remembered
def nearest_to_drag(spec: RodSpec) -> DraggableCurve:
    """Return a nearest curve with few enough poles for dragging.

    If no such curve is within the limits, return the nearest curve with all poles.
    """
    nearest = find_nearest_now(spec)
    most = len(nearest.curve.control_points)
    if not nearest.met or most <= MOST_DRAGGED:
        return DraggableCurve(nearest, nearest.curve, nearest.deviation, "")
    target = TargetCurve.of(spec.curve)
    farthest = max(FARTHER * nearest.deviation, NEAR_FRACTION * spec.curve.length)
    limits = spec.limits.tightened(curvature=TIGHTER, strain=TIGHTER)
    limits = replace(limits, ratio=max(1.0, limits.largest_ratio / TIGHTER))
    for coefficients in COEFFICIENTS:
        near = find_rod(replace(spec, limits=limits, coefficients=coefficients))
        with suppress(NotConvergedError):
            for curve in coarse_curves(near.rod, SPANS) if near.met and near.deviation <= farthest else ():
                if _is_within_limits(replace(spec, curve=curve)):
                    far = measure_deviation(target, curve.sample(DRAWN_POINTS).position)
                    return DraggableCurve(near, curve, far, note(
                        "The new curve has {count} poles and is {far} from the original curve. With {most} "
                        "poles, too many to drag, the distance would be {near}.",
                        count=len(curve.control_points), far=Length(far), most=most,
                        near=Length(nearest.deviation),
                    ))  # fmt: skip
    return DraggableCurve(nearest, nearest.curve, nearest.deviation, note(
        "The new curve has {count} poles, too many to drag by hand. With fewer poles the curve would exceed "
        "its limits.",
        count=most,
    ))  # fmt: skip


def _is_within_limits(spec: RodSpec) -> bool:
    most, ratio = spec.limits.largest_curvature, spec.limits.largest_ratio
    if most is not None and sharpest_bend(spec.curve, spec.natural_curvature)[0] > most * (1 + STRAIN_SLACK):
        return False
    try:
        if find_rod(replace(spec, limits=None, keep=None)).ratio > ratio * (1 + STRAIN_SLACK):
            return False
        again = find_rod(spec)
        return bool(again.met and again.deviation <= AS_DRAWN_MM)
    except ElasticaError:
        return False


def judged(rod: Rod) -> Stability | None:
    """Return the stability of a rod, or None if the computation fails."""
    try:
        return _stability(rod)
    except ElasticaError:
        return None


@remembered
def held_shape(strip: Strip) -> HeldShape | None:
    """Return the shape of a strip in its holders, or None if it is too far from the design to compute."""
    try:
        return strip.held()
    except NotConvergedError:
        return None


@remembered
def bent_shape(strip: Strip) -> Part.Shape:
    """Return the body of the bent strip, with its curve in the xy plane. The body of a laminate has both layers."""
    # bodies with thousands of holes take seconds
    many = len(strip.holes) > MANY_HOLES
    layers = (
        in_background(QT_TRANSLATE_NOOP("Elastica", "Bending the strip"), _bent, strip)
        if many
        else _bent(strip)
    )
    solids = [make_solid(layer) for layer in layers]
    return solids[0] if len(solids) == 1 else Part.Compound(solids)


@remembered
def _bent(strip: Strip) -> tuple[BodyRecord, ...]:
    layers = glued(BentSolid.layers(strip))
    for layer in layers:
        if not isinstance(layer, FlatSolid):
            _ = layer.boundary
    return layers


@remembered
def flat_shape(strip: Strip, layer: int = 0) -> Part.Shape:
    """Return the body of a layer of the strip as cut, in the xy plane."""
    records = FlatSolid.layers(strip)
    if strip.layout.stack is not None:
        return Part.Compound([make_solid(record) for record in glued(records)])
    record = records[layer]
    return make_solid(replace(record, frame=Frame()) if layer else record)


@remembered
def engraved_shape(strip: Strip, layer: int = 0) -> Part.Shape:
    """Return `flat_shape`, with the engraved text as edges on the upper face.

    Tapered strips and stacks of plies have no text, because they have no plane face for a text.
    """
    shape = flat_shape(strip, layer)
    if strip.layout.worked_size is not None or strip.layout.stack is not None:
        return shape
    face = Frame().shifted(z=strip.layers[layer].sheet.thickness)
    strokes = strip.drawings()[layer].strokes
    letters = [make_wire(stroke.path, face) for stroke in strokes if stroke.layer == ENGRAVE]
    return Part.Compound([shape, *letters]) if letters else shape


@remembered
def find_rod(spec: RodSpec) -> Any:
    """Return the rod of a request, or the nearest rod if the curve may be changed."""
    return solve_rod(spec)


@remembered
def _strip(spec: StripSpec) -> Strip:
    return spec.make(find_rod(spec.rod_spec))


_stability = remembered(stability)
