"""Distances between bent strips, including their tabs.

This is independent of the package's search for crossings. One band is sampled, and each sample is compared with the
exact other band. Two neighbouring samples on different sides of the other sheet mean a collision.
"""

from dataclasses import dataclass

import numpy as np
import shapely

import elastica_cad as ec

REACH = 5.0  # mm, distance beyond which strips count as far apart
PITCH = 2.0  # mm between samples, approximately
INSIDE = 0.05  # mm from a cut edge within which a place counts as material


@dataclass(frozen=True)
class Band:
    """The middle surface of a bent strip.

    Points (n, 2) of the curve in the plane of `frame`, arc lengths `s` (n,) and half widths `half` (n,), mm. `flat`
    is the cut pattern if slots and holes count, else None.
    """

    points: np.ndarray
    s: np.ndarray
    half: np.ndarray
    frame: ec.Frame
    thickness: float
    flat: shapely.Polygon | None = None

    def samples(self):
        """Return flat places (n, k, 2) and points in space (n, k, 3) from edge to edge."""
        count = int(np.clip(2 * self.half.max() / PITCH + 2, 3, 51))
        across = np.linspace(-1, 1, count) * self.half[:, None]
        plane = np.broadcast_to(self.points[:, None], (*across.shape, 2))
        flat = np.stack([np.broadcast_to(self.s[:, None], across.shape), across], axis=-1)
        return flat, self.frame.point(np.concatenate([plane, across[..., None]], axis=-1))

    def local(self, places):
        """Return places (..., 3) in space as x, y in the plane of the curve and z across the strip."""
        axes = np.column_stack([self.frame.x_axis, self.frame.y_axis, self.frame.z_axis])
        return (places - self.frame.origin) @ axes

    def room(self, flat):
        """Return the distance (...) of flat places from the rim and counted slots, mm. Negative outside."""
        if self.flat is None:
            return np.interp(flat[..., 0], self.s, self.half) - np.abs(flat[..., 1])
        points = shapely.points(flat)
        depth = shapely.distance(self.flat.boundary, points)
        return np.where(shapely.contains(self.flat, points), depth, -depth)


def band(placed, *, as_built=True, slots=False):
    """Return the band of a placed strip: as designed, or bent as it is cut and held as designed."""
    strip = placed.strip
    bent = ec.bend(strip.as_built) if as_built else strip.rod
    every = max(1, int(PITCH / (bent.s[1] - bent.s[0])))
    kept = np.unique(np.append(np.arange(0, bent.s.size, every), bent.s.size - 1))
    s, points = bent.s[kept], bent.position[kept]
    half = strip.width(np.minimum(s, strip.rod.length)) / 2
    for tab, end, way in zip(strip.ends, (0, -1), (-1, 1), strict=True):
        out = way * np.array([np.cos(bent.angle[end]), np.sin(bent.angle[end])])
        wide = half[end] if tab.width is None else tab.width / 2
        beyond = np.array([1e-6, tab.length])[::way]
        narrowed = np.array([wide, wide - tab.taper])[::way]
        rows = (points[end] + beyond[:, None] * out, s[end] + way * beyond, narrowed)
        points, s, half = (
            np.concatenate([new, old] if way < 0 else [old, new])
            for new, old in zip(rows, (points, s, half), strict=True)
        )
    thickness = sum(layer.sheet.thickness for layer in strip.layers)
    flat = shapely.Polygon(strip.outline.points(1e-3)) if slots else None
    return Band(points, s, half, placed.frame, thickness, flat)


def clearance(one, other):
    """Return the least distance between two bands, mm, minus their thickness.

    The distance is negative if the bands overlap, and infinite for strips out of reach.
    """
    return (
        min(_one_way(a, b) for a, b in ((one, other), (other, one))) - (one.thickness + other.thickness) / 2
    )


def overlap(one, other):
    """Return how far the sheets of two bands pass through each other inside their rims, mm, or 0."""
    return max(0.0, -min(_one_way(a, b) for a, b in ((one, other), (other, one))))


def self_clearance(one, apart):
    """Return the least distance between places more than `apart` mm of arc apart, minus the thickness, mm."""
    far = np.linalg.norm(one.points[:, None] - one.points[None], axis=2)
    far[np.abs(one.s[:, None] - one.s[None]) < apart] = np.inf
    return float(far.min()) - one.thickness


def _one_way(a, b):
    """Return the distance of the nearest sample of a from b, or minus the depth to which a passes through b."""
    flat, places = a.samples()
    grid = b.local(places)
    low, high = b.points.min(axis=0) - REACH, b.points.max(axis=0) + REACH
    near = np.all((grid[..., :2] > low) & (grid[..., :2] < high), axis=-1)
    near &= np.abs(grid[..., 2]) < b.half.max() + REACH
    if not near.any():
        return np.inf
    shape = near.shape
    distance, side, there = np.full(shape, np.inf), np.full(shape, np.nan), np.zeros((*shape, 2))
    distance[near], side[near], there[near] = _against(b, grid[near])
    depths = [
        _crossed(*(values.swapaxes(0, axis) for values in (flat, there, side)), a, b) for axis in (0, 1)
    ]
    if max(depths) > 0:
        return -max(depths)
    least = float(distance.min())
    return least if least < REACH else np.inf


def _crossed(flat, there, side, a, b):
    """Return how deep inside both rims a crosses b between neighbouring rows."""
    before, after = side[:-1], side[1:]
    with np.errstate(invalid="ignore"):
        through = (before * after <= 0) & (before != after) & (np.abs(before - after) < REACH)
    if not through.any():
        return 0.0
    u = (before / (before - after))[through][:, None]
    crossings = [rows[:-1][through] * (1 - u) + rows[1:][through] * u for rows in (flat, there)]
    room = np.minimum(a.room(crossings[0]), b.room(crossings[1]))
    return float(max(0.0, room.max() - INSIDE))


def _against(b, places):
    """Return distances (m,) from the band, signed distances (m,) from its extended sheet, flat places (m, 2)."""
    start, step = b.points[:-1], np.diff(b.points, axis=0)
    length = np.hypot(*step.T)
    found = []
    for some in np.array_split(places, max(1, len(places) * len(start) // 1_000_000)):
        off = some[:, None, :2] - start
        along = np.clip((off * step).sum(axis=2) / length**2, 0, 1)
        gap = off - along[..., None] * step
        half = b.half[:-1] * (1 - along) + b.half[1:] * along
        beyond = np.maximum(np.abs(some[:, None, 2]) - half, 0)
        squares = (gap**2).sum(axis=2)
        row, k = np.arange(len(some)), np.argmin(squares, axis=1)
        left = (step[k, 0] * gap[row, k, 1] - step[k, 1] * gap[row, k, 0]) / length[k]
        s = b.s[k] + along[row, k] * (b.s[k + 1] - b.s[k])
        # the sheet has no sides beyond its ends
        inside = (s > b.s[0]) & (s < b.s[-1])
        found.append(
            np.column_stack(
                [np.sqrt((squares + beyond**2).min(axis=1)), np.where(inside, left, np.nan), s, some[:, 2]]
            )
        )
    table = np.concatenate(found)
    return table[:, 0], table[:, 1], table[:, 2:]
