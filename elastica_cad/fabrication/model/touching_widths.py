"""Widths with which neighbouring strips on a surface close the gap between them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_flag, require_number
from elastica_cad.errors import InputError
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.geometry.curves.plane_curve import PlaneCurve, line_crossings
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.refusals import Length

WIDTH_MM = 1e-5
"""Largest error of a width, mm."""

PARALLEL = 1e-12
"""Slopes below this are rounding: two planes are then the same, and two bounds never cross."""

END_MM = 1e-9
"""Kinks nearer than this to an end are at the end."""


@dataclass(frozen=True, eq=False)
class _Bound:
    """Distance along the ruling to a plane, a + <b, gamma>, for a curve gamma in its own plane."""

    a: float
    b: FloatArray

    def __call__(self, points: FloatArray) -> FloatArray:
        return np.asarray(self.a + points @ self.b, dtype=float)


def touching_widths(
    strips: Sequence[Placed | tuple[PlaneCurve, Frame]], gap: float = 0.0, *, closed: bool = False
) -> tuple[Profile, ...]:
    """Widths at which strips on neighbouring planes meet at the planes that bisect the angle between theirs.

    Half the width is the distance from the curve, along the ruling, to the nearer bisector plane after that was
    moved towards the curve by the gap (the Flower Pot and the Shell of the paper, section 9).

    Parameters
    ----------
    strips : sequence of Placed, or of (PlaneCurve, Frame)
        In order around the surface; the frame is the plane in which the curve is drawn.
    gap : float
        Distance that either strip keeps from the bisector plane, mm.
    closed : bool
        True where the last strip is the first one's neighbour; otherwise both have one neighbour only.

    Returns
    -------
    tuple of Profile
        Full widths over arc length, mm.

    Raises
    ------
    InputError
        Fewer than two strips, or no width left somewhere.

    Examples
    --------
    >>> arc = PlaneCurve.line((30, 0), (50, 40))
    >>> turned = [Frame((0, 0, 0), (np.cos(a), np.sin(a), 0), (0, 0, 1)) for a in (0.0, 0.2)]
    >>> widths = touching_widths([(arc, frame) for frame in turned])
    >>> float(widths[0](0.0).round(6)), float((60 * np.tan(0.1)).round(6))
    (6.02008, 6.02008)
    """
    require_number(gap, "the gap", "mm")
    if not (isinstance(strips, Sequence) and all(isinstance(p, Placed | tuple) for p in strips)):
        raise InputError(
            "strips are {strips!r}: give a list of Placed, or of (PlaneCurve, Frame)", strips=strips
        )
    pairs = [(p.strip.rod.curve, p.frame) if isinstance(p, Placed) else p for p in strips]
    names = [
        p.strip.label or f"strip {i + 1}" if isinstance(p, Placed) else f"strip {i + 1}"
        for i, p in enumerate(strips)
    ]
    count = len(pairs)
    if count < 2:
        raise InputError("strips touch their neighbours: give two of them or more")
    require_flag(closed, "closed")
    found = []
    for i, (curve, frame) in enumerate(pairs):
        around = {(i - 1) % count, (i + 1) % count} if closed else {i - 1, i + 1} & set(range(count))
        bounds = [_bound((curve, frame), pairs[j], gap, (names[i], names[j])) for j in sorted(around)]
        found.append(_width(curve, bounds, gap, names[i]))
    return tuple(found)


def _bound(
    own: tuple[PlaneCurve, Frame], other: tuple[PlaneCurve, Frame], gap: float, names: tuple[str, str]
) -> _Bound:
    """The plane between two strips, moved towards the first by the gap, as the first sees it."""
    frame, opposite = own[1], other[1]
    middles = [f.point(c.sample(33).position.mean(axis=0)) for c, f in (own, other)]
    z, r = frame.z_axis, opposite.z_axis
    z = z * np.sign((middles[1] - frame.origin) @ z)
    r = r * np.sign((middles[0] - opposite.origin) @ r)
    normal = z - r  # of the points as far from either plane, on the sides that face each other
    pace = float(normal @ z)
    if not (np.any(z) and np.any(r)) or pace < PARALLEL:
        raise InputError(
            "{names} and {names_2} lie in the same plane: no plane passes between them",
            names=names[0],
            names_2=names[1],
        )
    offset = z @ frame.origin - r @ opposite.origin - gap * np.linalg.norm(normal)
    return _Bound(
        float(offset - normal @ frame.origin) / pace,
        -np.array([normal @ frame.x_axis, normal @ frame.y_axis]) / pace,
    )


def _width(curve: PlaneCurve, bounds: Sequence[_Bound], gap: float, name: str) -> Profile:
    """Twice the smaller of the bounds, with a kink where they change places."""
    breaks = [(b.s, max(b.continuity, 0)) for b in curve.breaks]
    if len(bounds) == 2:
        one, two = bounds
        a, b = one.a - two.a, one.b - two.b
        if np.hypot(*b) > PARALLEL:
            breaks += [(r.s, 0) for r in line_crossings(curve, a, b) if r.kind == "crossing"]
    inside = {s: c for s, c in sorted(breaks, reverse=True) if END_MM < s < curve.length - END_MM}

    def half(s: FloatArray) -> FloatArray:
        points = curve.at(s).position
        return np.asarray(np.min([bound(points) for bound in bounds], axis=0))

    width = Profile.fit(
        lambda s: 2 * half(s), curve.length, breaks=sorted(inside.items()), tolerance=WIDTH_MM
    )
    least, _ = width.extremes
    if least <= 0:
        s = np.linspace(0.0, curve.length, 2001)
        at = float(s[int(np.argmin(half(s)))])
        raise InputError(
            "{name}: nothing is left of its width at {at:.6g} ({least:.4g}) with a gap of "
            "{gap:g}: make the gap smaller or end the strip before",
            name=name,
            at=Length(at),
            least=Length(least),
            gap=Length(gap),
        )
    return width
