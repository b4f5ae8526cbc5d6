"""Random pairs of strips that are slotted together, and their overlap outside the slots, by points."""

import numpy as np
from scipy.spatial import cKDTree

from elastica_cad import Model, Placed, PlaneCurve, Sheet, Strip, Tab, optimal_rod

PLYWOOD = Sheet.named("birch-plywood-0.8")


def drawn(rng):
    """Return an arch, a wave or an arc."""
    kind, length, rise = rng.integers(3), rng.uniform(120, 350), rng.uniform(0.15, 0.6)
    x = length * np.array([-1 / 2, -1 / 3, 0, 1 / 3, 1 / 2])
    if kind == 0:
        return PlaneCurve.spline(np.column_stack([x, rise * length * np.array([0, 0.7, 1, 0.7, 0])]))
    if kind == 1:
        x = np.linspace(-length / 2, length / 2, 7)
        return PlaneCurve.spline(np.column_stack([x, 0.25 * rise * length * np.sin(2 * np.pi * x / length)]))
    return PlaneCurve.arc((0, -length / 2), length / 2, rise + 0.15, np.pi - rise - 0.15)


def pair(seed, **options):
    """Return two strips that cross at a shallow angle, with slots. Errors are passed on."""
    rng = np.random.default_rng(seed)
    sheet, placed = PLYWOOD.with_thickness(float(rng.choice([0.8, 1.5, 3.0, 4.0]))), []
    for label in "AB":
        rod, width = optimal_rod(drawn(rng)), float(rng.uniform(14, 45))
        strip = Strip(rod, sheet, max_width=width, ends=(Tab(0), Tab(0)), label=label)
        along, tilt = rng.uniform(-0.4, 0.4), 0.25 * rng.normal()
        x = np.array([np.cos(along), np.sin(along), 0.0])
        y = np.cos(tilt) * np.array([0, 0, 1.0]) + np.sin(tilt) * np.cross([0, 0, 1], x)
        at = rod.position[int(rng.uniform(0.25, 0.75) * rod.s.size)]
        origin = rng.uniform(-0.3, 0.3) * width * np.cross(x, y) - at[0] * x - at[1] * y
        placed.append(Placed(strip, origin, x, y))
    return Model(placed).interlock(**{"clearance": 0.1, **options})


def shared(one, other, pitch=0.2):
    """Return how deep the long edges of a strip reach into the other strip without its slots, mm, or 0."""
    strip, thick = one.strip, one.strip.sheet.thickness
    s = np.arange(pitch, strip.rod.length, pitch)
    spot = strip.rod.curve.at(s)
    normal = np.column_stack([-np.sin(spot.angle), np.cos(spot.angle)])
    points, flat = [], []
    for side in (-0.5, 0.5):
        for face in (-0.5, 0.5):
            v = side * strip.width(s) * (1 - 1e-6)
            points.append(np.column_stack([spot.position + face * thick * normal, v]))
            flat.append(np.column_stack([s, v]))
    depth = depths(other, one.frame.point(np.concatenate(points)))
    inside = depth > 0
    kept = _has_material(strip, *np.concatenate(flat)[inside].T)
    return float((depth[inside] * kept).max(initial=0.0))


def depths(placed, points):
    """Return how deep points are below the faces and long edges of a strip, mm. -1 in its slots and outside."""
    strip, local = placed.strip, placed.frame.local(points)
    dense = np.linspace(0, strip.rod.length, 40_001)
    away, nearest = cKDTree(strip.rod.curve.at(dense).position).query(local[:, :2])
    depth = np.minimum(
        strip.sheet.thickness / 2 - away, strip.width(dense[nearest]) / 2 - np.abs(local[:, 2])
    )
    return np.where(_has_material(strip, dense[nearest], local[:, 2]), depth, -1.0)


def _has_material(strip, x, y):
    """Return which places of the flat pattern are inside its outline, without the slots."""
    import shapely  # not there where CAD programs alone are tested

    outline = shapely.Polygon(strip.outline.points(0.001))
    shapely.prepare(outline)
    return shapely.contains_xy(outline, x, y)
