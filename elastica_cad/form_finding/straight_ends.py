"""Straight first and last pieces of a drawn curve. `strip_spec` makes tabs with holes of them."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad.errors import Length, Refusal, note
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, unit_vectors
from elastica_cad.mechanics.loads import NaturalCurvature, RestCurvature, Supports
from elastica_cad.mechanics.theorem1 import measured_points

SHORTEST_RUN_IN_MM = 1.0
"""Shortest straight piece that becomes a tab, mm. Shorter pieces are bent with the curve."""


@dataclass(frozen=True, eq=False)
class StraightEnds:
    """A drawn curve, divided into its bent part and straight pieces at its ends.

    Attributes
    ----------
    drawn, bent : PlaneCurve
        The whole curve and its bent part. If neither end is straight, the bent part is the whole curve.
    lengths : (float, float)
        Lengths of the straight first and last pieces, mm; 0 if there is none.

    Examples
    --------
    >>> arch = PlaneCurve([0, 0, 0, 20, 20, 60, 60, 60], [(0, 0), (10, 0), (20, 0), (40, 0), (50, 20)], 2)
    >>> ends = StraightEnds.of(arch, Supports())
    >>> ends.lengths, ends.bent.control_points[0].tolist()
    ((20.0, 0.0), [20.0, 0.0])
    """

    drawn: PlaneCurve
    bent: PlaneCurve
    lengths: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def of(
        cls, curve: PlaneCurve, supports: Supports, natural_curvature: NaturalCurvature = 0.0
    ) -> "StraightEnds":
        """Separate straight pieces of 1 mm or more from an open curve, at ends whose angle is held.

        Straight curves, polylines, and curves fitted to measured points are not divided. Curves with a
        `RestCurvature` are not divided either, because the rest curvature starts at the drawn start.
        """
        counted = isinstance(natural_curvature, RestCurvature)
        if curve.is_closed or curve.is_straight or counted or measured_points(curve) is not None:
            return cls(curve, curve)
        flats = [z for z in curve.curvature_zeros if z.kind == "flat"]
        start, end = (support.angle for support in supports.ends)
        (low, high), near, lengths = curve.domain, 1e-9 * curve.length, [0.0, 0.0]
        for flat in flats:
            long = flat.s_end - flat.s >= SHORTEST_RUN_IN_MM
            if start and long and flat.s <= near:
                low, lengths[0] = flat.t_end, flat.s_end
            if end and long and flat.s_end >= curve.length - near:
                high, lengths[1] = flat.t, curve.length - flat.s
        drawn = curve.provenance
        if not any(lengths) or low >= high or (drawn is not None and drawn.vertices is not None):
            return cls(curve, curve)
        bent = curve.trimmed(low, high).drawn_as(curve.provenance)
        return cls(curve, bent, (round(lengths[0], 6), round(lengths[1], 6)))

    def __bool__(self) -> bool:
        return any(self.lengths)

    def place_of(self, point: ArrayLike, within: float) -> tuple[int, float] | None:
        """Return the straight piece near a point (2,), and the position of the point along the piece, mm.

        The piece is 0 (first) or 1 (last). Return None if the point is farther than `within`, mm, from both pieces.
        """
        for end, t, outward in zip((0, 1), self.bent.domain, (-1.0, 1.0), strict=True):
            ahead = outward * unit_vectors(self.bent.angle_at(t))
            along, across = np.array([ahead, left_of(ahead)]) @ (np.asarray(point) - self.bent.evaluate(t))
            if 0 < along < self.lengths[end] and abs(across) <= within:
                return end, float(along)
        return None

    @property
    def message(self) -> Refusal | None:
        """Note on the straight pieces that became tabs, or None."""
        first, last = map(Length, self.lengths)
        if not self:
            return None
        return note(
            "The curve is straight over its first {first} and its last {last}; these pieces become "
            "tabs. Positions along the strip are measured from the end of the first tab."
            if first and last else
            "The curve is straight over its first {first}; this piece becomes a tab. Positions along "
            "the strip are measured from the end of this tab."
            if first else
            "The curve is straight over its last {last}; this piece becomes a tab.",
            first=first, last=last, severity="warning",
        )  # fmt: skip
