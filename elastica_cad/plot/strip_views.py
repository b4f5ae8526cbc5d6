"""What pictures show of rods and strips: numbers and words, as records that anybody may paint."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.fabrication.drawings.sheet_colors import sheet_color
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.boxes import box_about
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.arguments import require_curve
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.plot.strip_page import WIDE, BentView, FlatLayer, FlatView, StiffnessView, StripPage

COMB_SHARE = 0.16
"""Of the curve's extent: the longest tooth of its comb."""

SMOOTH_MM = 0.02
"""How closely polylines follow splines in pictures: less than a printed dot."""


def view_page(strip: Strip, wish: PlaneCurve | None) -> StripPage:
    """One page about a strip; `wish` is the curve that was asked for, where the strip may leave it."""
    require_record(strip, Strip, "what is drawn", "a Strip")
    sheet = strip.sheet
    size = strip.breadth() if strip.tapered else f"{sheet.thickness:g} mm thick"
    facts = f"{sheet.name}, {size}, {strip.mass_told}"
    strain = f"largest strain {100 * strip.max_strain:.2f} %, {100 * strip.strain_limit:.2f} % allowed"
    title = f"{fill(strip.label or 'Strip', 90)}\n{facts}; {strain}"
    return StripPage(title, view_bent(strip.rod, wish), view_stiffness(strip.rod), view_flat(strip))


def view_bent(rod: Rod, wish: PlaneCurve | None) -> BentView:
    """The rod as it is bent, and beside it the curve that was asked for."""
    if wish is not None:
        require_curve(wish)
    position, tips, turns = rod.position, _comb_tips(rod), _inflections(rod)
    wished = [] if wish is None else [wish.sample(600).position]
    low, high = box_about(np.concatenate([position, tips, *wished, turns]))
    at_rest, line = _inflection_line(rod), None
    if at_rest is not None:
        reach = 0.04 * float(np.max(high - low))
        line = _clipped(*at_rest, low - reach, high + reach)
    shown = [low, high] if line is None else [low, high, *line]
    return BentView(
        rod.length,
        position,
        tips,
        wished[0] if wished else None,
        turns,
        line,
        _window(box_about(np.array(shown))),
        _height([position, tips, *([] if wish is None else [wish.sample(200).position])]),
    )


def view_stiffness(rod: Rod) -> StiffnessView:
    """The stiffness along a rod."""
    s = np.linspace(0.0, rod.length, 1201)
    return StiffnessView(s, rod.profile(s), rod.ratio)


def view_flat(strip: Strip) -> FlatView:
    """The flat strip with its dimensions."""
    called, size = next(iter(strip.tapered.items()), ("width", strip.width))
    stations = [(x, float(strip.width(x)), float(size(x))) for x in _stations_of(size)]
    called = "widths" if called == "width" else called
    then = "; to be bent beforehand" if np.any(strip.rod.natural_curvature) else ""
    title = f"Flat: {strip.breadth()}, {called} in mm below{then}"
    if strip.backing_side:
        title += f"\n{fill(strip.backing_side, 100)}"
    return FlatView(view_layers(strip), strip.outline.bounds, strip.rod.length, stations, title)


def view_layers(strip: Strip) -> list[FlatLayer]:
    """The cut pattern in the colours of its sheets, a backing seen through."""
    shown = []
    for layer in strip.layers:
        # what runs against the outline is left out of the filling
        loops = [layer.outline, *(hole if hole.area < 0 else hole.reversed() for hole in layer.holes)]
        shown.append(FlatLayer(view_paths(loops), sheet_color(layer.sheet), layer is not strip.layers[0]))
    return shown


def view_paths(paths: Sequence[Path]) -> list[FloatArray]:
    """Polylines (n, 2) along paths, closed ones back to their start."""
    return [
        np.concatenate([points, points[:1]]) if path.closed else points
        for path, points in ((path, path.points(SMOOTH_MM)) for path in paths)
    ]


def _height(points: Sequence[FloatArray]) -> float:
    """Of the axes about a curve, inches."""
    width, height = _widened(np.ptp(np.concatenate(points), axis=0))
    return float(np.clip(WIDE * height / width, 2.2, 5.2))


def _window(box: FloatArray) -> FloatArray:
    """The box (2, 2) shown: a curve that is nearly straight has some room across, for its axis to be read."""
    size = box[1] - box[0]
    least, middle = _widened(size) / 2, box[0] + size / 2
    return np.array([middle - least, middle + least])


def _widened(size: FloatArray) -> FloatArray:
    """Width and height shown of so large a drawing: the axis of a nearly straight curve can be read."""
    return np.asarray(1.1 * np.maximum(size, 0.3 * size.max()))


def _stations_of(size: Profile) -> list[float]:
    """Widest and narrowest place, the ends, then the quarters, as far as their labels keep apart."""
    length = size.length
    s = np.linspace(0.0, length, 801)
    w = np.round(size(s), 9)  # where many places are widest, rounding does not choose
    wanted = [s[int(np.argmax(w))], s[int(np.argmin(w))], 0.0, length, length / 2, length / 4, 3 * length / 4]
    kept: list[float] = []
    for x in map(float, wanted):
        if all(abs(x - other) > 0.08 * length for other in kept):
            kept.append(x)
    return sorted(kept)


def _inflections(rod: Rod) -> FloatArray:
    """Points (k, 2) where the bending changes sign: of a flat blank, where the curvature does."""
    if rod.shape is not None and not np.any(rod.natural_curvature):
        return np.asarray(rod.shape.at(rod.shape.inflections).position, dtype=float).reshape(-1, 2)
    kappa = rod.curvature - rod.natural_curvature
    i = np.flatnonzero(kappa[:-1] * kappa[1:] < 0)
    u = (kappa[i] / (kappa[i] - kappa[i + 1]))[:, None]
    return np.asarray(rod.position[i] * (1 - u) + rod.position[i + 1] * u, dtype=float)


def _inflection_line(rod: Rod) -> tuple[FloatArray, FloatArray] | None:
    """Point and direction of the line on which the moment vanishes (Eq. 3); with weight there is none."""
    size = float(np.linalg.norm(rod.force[0]))
    if rod.gravity is not None or size == 0.0:
        return None
    direction = rod.force[0] / size
    gradient = np.array([direction[1], -direction[0]])  # b = R^t lambda
    return rod.position[0] - gradient * rod.moment[0] / size, direction


def _clipped(
    point: FloatArray, direction: FloatArray, low: FloatArray, high: FloatArray
) -> FloatArray | None:
    """The part (2, 2) of a line inside a box, or None."""
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.sort(np.array([low - point, high - point]) / direction, axis=0)
    inside = np.all((direction != 0) | ((low <= point) & (point <= high)))
    first, last = (
        np.nanmax(np.where(direction != 0, t[0], -np.inf)),
        np.nanmin(np.where(direction != 0, t[1], np.inf)),
    )
    return (
        np.array([point + first * direction, point + last * direction]) if inside and first < last else None
    )


def _comb_tips(rod: Rod) -> FloatArray:
    """Ends (n, 2) of the teeth of the curvature comb."""
    largest = float(np.abs(rod.curvature).max())
    extent = float(np.ptp(rod.position, axis=0).max())
    scale = COMB_SHARE * extent / largest if largest > 0 else 0.0
    normal = np.column_stack([-np.sin(rod.angle), np.cos(rod.angle)])
    return np.asarray(rod.position - scale * rod.curvature[:, None] * normal)
