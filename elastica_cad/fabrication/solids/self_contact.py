"""Where a bent strip meets itself: its section in the plane of the curve, tabs included."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.path_intersections import self_crossing
from elastica_cad.geometry.running_sums import turns_along

STEP_RAD = 0.03
"""Turn between the points of the section: chords then stray by a ten-thousandth of the radius."""

TAB_POINTS = 9


def self_contact(strip: Strip) -> tuple[float, float] | None:
    """Two places of the bent strip that touch or run through each other, mm along it; None where there are none.

    Tabs lie below 0 and beyond the length. A crossing that a slot at one of the places makes room for is none.

    Examples
    --------
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> from elastica_cad.mechanics.rod.rod_record import Rod
    >>> self_contact(Strip(Rod.straight(100), Sheet.named("card-200gsm"), max_width=20)) is None
    True
    """
    rod = strip.rod
    if strip.is_closed:
        return _closed_contact(strip)
    if np.ptp(rod.angle) < np.pi:  # all of it runs on in one direction
        return None
    thickness = _thickness(strip)
    s, middle, angle = _middle(strip)
    off = thickness / 2 * np.column_stack([-np.sin(angle), np.cos(angle)])
    meeting = self_crossing(np.concatenate([middle + off, (middle - off)[::-1]]), closed=True)
    if meeting is None:
        return None
    away = np.hypot(*(middle - meeting).T)
    one = s[np.argmin(away)]
    # between two places that meet a curve turns by half a circle or more
    turned = turns_along(angle)
    elsewhere = np.abs(turned - turned[np.argmin(away)]) > np.pi / 2
    other = s[np.argmin(np.where(elsewhere, away, np.inf))]
    places = min(one, other), max(one, other)
    if any(abs(slot.at - place) < slot.width + thickness for slot in strip.slots for place in places):
        return None
    return float(places[0]), float(places[1])


def _thickness(strip: Strip) -> float:
    """The largest along it, mm."""
    size = strip.layout.size
    return strip.layers[-1].high if size is None else float(size.extremes[1])


def _closed_contact(strip: Strip) -> tuple[float, float] | None:
    """The same of a closed strip, whose ends and lap meet by intent."""
    rod = strip.rod
    kept = np.unique(
        np.searchsorted(turns_along(rod.angle), np.arange(0.0, turns_along(rod.angle)[-1], STEP_RAD))
    )
    kept = kept[kept < len(rod.s) - 1]
    ring = rod.position[kept]
    meeting = self_crossing(ring, closed=True)
    if meeting is None:
        return None
    near = np.sort(np.argsort(np.hypot(*(ring - meeting).T))[:2])
    return float(rod.s[kept[near[0]]]), float(rod.s[kept[near[1]]])


def _middle(strip: Strip) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Stations (n,), points (n, 2) and angles (n,) of the middle line with its tabs."""
    rod = strip.rod
    turned = turns_along(rod.angle)
    kept = np.unique(np.searchsorted(turned, np.arange(0.0, turned[-1], STEP_RAD)))
    kept = np.union1d(kept, [0, len(rod.s) - 1])
    parts = [(rod.s[kept], rod.position[kept], rod.angle[kept])]
    for tab, end, way in zip(strip.ends, (0, -1), (-1, 1), strict=True):
        if tab.length == 0:
            continue
        out = way * np.linspace(0.0, tab.length, TAB_POINTS)[1:]
        angle = np.full(out.shape, rod.angle[end])
        line = rod.position[end] + out[:, None] * [np.cos(angle[0]), np.sin(angle[0])]
        rows = rod.s[end] + out, line, angle
        parts = [*parts, rows] if way > 0 else [(rows[0][::-1], line[::-1], angle), *parts]
    s, middle, angle = (np.concatenate(column) for column in zip(*parts, strict=True))
    return s, middle, angle
