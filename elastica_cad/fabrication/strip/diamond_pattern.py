"""The pattern of a perforated strip: diamonds between ligaments of equal width that run along the strip."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.corner_rounding import rounded_where_they_fit, too_small_for
from elastica_cad.fabrication.slots.slot import Slot, slot_cut
from elastica_cad.fabrication.strip.flat_outline import Ends, close_chain, graphs
from elastica_cad.fabrication.strip.tabs import Tab
from elastica_cad.geometry.paths.approximations import as_arcs
from elastica_cad.geometry.paths.path import JOIN, Path
from elastica_cad.geometry.paths.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.polynomials.spline_fits import adaptive_spline
from elastica_cad.geometry.polynomials.splines import bezier_spans, greville

FIT_MM = 2e-5
"""Largest error of width, material and full diamond along the strip: of the sums of ligaments some 1e-4 mm."""

FIT_ROUNDING = 1e-12
"""Relative error of the widths that are fitted."""

INSET = 1e-9
"""Share of a stretch by which its spline is fitted inside it, on this side of jumps."""

CLEAR_OF_SLOTS_MM = 0.02
"""Flatness of the polylines by which holes are kept clear of slots."""


@dataclass(frozen=True, eq=False)
class DiamondPattern:
    """Full diamonds in `rows` along and `columns` across, others in the gaps between them, halves at the edges.

    With H = width - material, T(s) rising from 0 to 1 over half a row and falling again, n = `columns` and
    t = material / (2 n + 2): full diamonds are T H / n wide across, those in the gaps (1 - T) H / n, halves along
    both edges half of that. Every station meets holes of H in all, and every ligament is t wide across, 2 t where
    two of them join. T rests at 0 and at 1 for a `bridge` between two rows, which keeps tips apart.

    Parameters
    ----------
    width, material : Profile
        Of the outline, and what is to be left of it, mm.
    columns, rows : int
        Full diamonds across and along.
    bridge : float
        Solid length along the strip between the tips of two holes, mm.
    corner_radius : float
        Of the holes' corners, mm; 0 leaves them sharp.
    clearance : float
        What holes keep from a slot, mm: those in its way end before it and begin anew behind it; where a tab is
        narrower than the strip they keep it from the end, too.
    arcs : float, optional
        Sides as arcs within this distance, mm, of the true ones; splines unless given.
    """

    width: Profile
    material: Profile
    columns: int
    rows: int
    bridge: float
    corner_radius: float = 0.0
    clearance: float = 0.5
    arcs: float | None = None

    @property
    def ligaments(self) -> int:
        """How many run side by side, counting those that have joined."""
        return 2 * self.columns + 2

    @property
    def row_length(self) -> float:
        """mm."""
        return self.width.length / self.rows

    @property
    def side_length(self) -> float:
        """Length along the strip, mm, over which a diamond opens from its tip to its whole width."""
        return self.row_length / 2 - self.bridge

    def slopes(self, s: FloatArray) -> FloatArray:
        """Slope (n,) of the diamonds' sides against the strip at stations `s` (n,)."""
        holes = self.width(s) - self.material(s)
        return np.asarray(holes / (2 * self.columns * self.side_length), dtype=float)

    @cached_property
    def joints(self) -> FloatArray:
        """Stations (2 rows + 1,), mm, where diamonds end in a tip and others are widest."""
        return np.linspace(0.0, self.width.length, 2 * self.rows + 1)

    def __post_init__(self) -> None:
        if self.side_length <= self.bridge:
            raise InputError(
                f"{self.rows} rows are {self.row_length:.3g} mm long each: diamonds with bridges of "
                f"{self.bridge:g} mm between their tips need more than {4 * self.bridge:g} mm; use fewer rows"
            )

    def paths(self, ends: Ends, slots: Sequence[Slot] = ()) -> tuple[Path, ...]:
        """The holes as closed anticlockwise loops in the order of the strip, clear of tabs and slots.

        What a slot leaves of a hole, less than half of it, is not cut where the corner radius does not fit it.
        """
        cuts = [slot_cut(slot, self.width, beyond=slot.width) for slot in slots]
        clear = [
            (part, part.loop(j))
            for row in self._rows_within(ends)
            for j in range(row.across)
            for part in self._clear(row, j, cuts)
        ]
        loops = [loop for _, loop in clear]
        if self.corner_radius > 0:
            rounded = rounded_where_they_fit(loops, self.corner_radius)
            for (part, loop), found in zip(clear, rounded, strict=True):
                if found is None and part.lost < part.length:
                    raise too_small_for(self.corner_radius, loop)
            loops = [found for found in rounded if found is not None]
        if self.arcs is not None:
            loops = [as_arcs(loop, self.arcs) for loop in loops]
        return tuple(loops)

    def _rows_within(self, ends: Ends) -> list["_Row"]:
        """What the tabs leave of the rows."""
        length = self.width.length
        within = self._margin(ends[0], 0.0), length - self._margin(ends[1], length)
        return [row for whole in self._rows if (row := whole.within(*within)) is not None]

    def _margin(self, tab: Tab, s: float) -> float:
        held = tab.width is None or tab.width >= float(self.width(s))
        return 0.0 if held and tab.length > 0 else self.clearance

    def _clear(self, row: "_Row", j: int, cuts: Sequence[Path]) -> list["_Row"]:
        """The row for its j-th hole, or what slots leave of it on both sides of them."""
        left = [row]
        for cut in cuts:
            left = [part for one in left for part in self._beside(one, j, cut)]
        return left

    def _beside(self, row: "_Row", j: int, cut: Path) -> list["_Row"]:
        """The row where the slot leaves its j-th hole alone, else its parts on both sides."""
        if self._apart(row.loop(j), cut):
            return [row]
        (low, _), (high, _) = cut.bounds
        sides = row.within(-np.inf, low - self.clearance), row.within(high + self.clearance, np.inf)
        return [side for side in sides if side is not None and side.length > 2 * self.clearance]

    def _apart(self, loop: Path, cut: Path) -> bool:
        low, high = cut.bounds + np.array([[-self.clearance], [self.clearance]])
        if np.any(loop.bounds[0] >= high) or np.any(loop.bounds[1] <= low):
            return True
        points, line = loop.points(CLEAR_OF_SLOTS_MM), cut.points(CLEAR_OF_SLOTS_MM)
        if polylines_cross(np.concatenate([points, points[:1]]), line) is not None:
            return False
        if encloses(line, points[0]):
            return False
        near = min(float(distances(segment, points).min()) for segment in cut.segments)
        back = min(float(distances(segment, line).min()) for segment in loop.segments)
        return min(near, back) >= self.clearance

    @cached_property
    def _rows(self) -> list["_Row"]:
        """Rows of full diamonds and of the ones in the gaps between them, in turn."""
        first, last = self.joints[:-1] + self.bridge / 2, self.joints[1:] - self.bridge / 2
        first[0], last[-1] = self.joints[0], self.joints[-1]
        stretches = self._stretches
        middles = np.array([(one.knots[0] + one.knots[-1]) / 2 for one in stretches])
        begins = np.searchsorted(middles, np.append(first[:1], first), side="right").tolist()
        ends = np.searchsorted(middles, np.append(last, last[-1:]), side="left").tolist()
        return [
            _Row(tuple(stretches[begin:end]), self.columns, full=i % 2 == 1)
            for i, (begin, end) in enumerate(zip(begins, ends, strict=True))
        ]

    @property
    def _stretches(self) -> list["_Stretch"]:
        """The strip between joints and jumps: width, material and T H / columns as splines over the same knots."""
        breaks = [*self.width.breaks, *self.material.breaks]
        jumps = np.array([s for s, continuity in breaks if continuity < 0])
        inner = self.joints[1:-1]
        tips = np.concatenate([inner - self.bridge / 2, inner + self.bridge / 2])
        cuts = np.unique(np.concatenate([self.joints[[0, -1]], tips, jumps]))
        low, high = cuts[:-1], cuts[1:]
        inset = INSET * (high - low)
        starts = self._values(np.where(np.isin(low, jumps), low + inset, low))
        ends = self._values(np.where(np.isin(high, jumps), high - inset, high))
        rough = [(s, continuity) for s, continuity in breaks if continuity < 2]
        splines = [
            adaptive_spline(
                self._values, ends, degree=3, tolerance=FIT_MM, breaks=rough, rounding=FIT_ROUNDING
            )
            for ends in np.column_stack([low + inset, high - inset]).tolist()
        ]
        for i, (knots, values) in enumerate(splines):
            knots[:4], knots[-4:] = low[i], high[i]
            values[0], values[-1] = starts[i], ends[i]
        return [_Stretch(knots, values) for knots, values in splines]

    def _values(self, s: FloatArray) -> FloatArray:
        """Width, material, and the width of a full diamond (n, 3), mm."""
        w, m = self.width(s), self.material(s)
        half, last = self.row_length / 2, 2 * self.rows - 1
        k = np.clip(np.floor(s / half), 0, last)
        before, after = np.where(k > 0, self.bridge / 2, 0.0), np.where(k < last, self.bridge / 2, 0.0)
        rise = np.clip((s - k * half - before) / (half - before - after), 0.0, 1.0)
        T = np.where(k % 2 == 0, rise, 1 - rise)
        return np.column_stack([w, m, T * (w - m) / self.columns])


@dataclass(frozen=True, eq=False)
class _Row:
    """The holes side by side over some stretches: full diamonds, or those in the gaps (first and last: halves)."""

    stretches: tuple["_Stretch", ...]
    columns: int
    full: bool
    lost: float = 0.0  # of the length, mm, to ends and slots

    @property
    def across(self) -> int:
        """Number of holes."""
        return self.columns if self.full else self.columns + 1

    @property
    def length(self) -> float:
        """Along the strip, mm."""
        return float(self.stretches[-1].knots[-1] - self.stretches[0].knots[0])

    def within(self, low: float, high: float) -> "_Row | None":
        """The part between two stations; None where there is none."""
        if low <= self.stretches[0].knots[0] and self.stretches[-1].knots[-1] <= high:
            return self
        kept = tuple(part for one in self.stretches if (part := one.within(low, high)) is not None)
        if not kept:
            return None
        lost = self.length - float(kept[-1].knots[-1] - kept[0].knots[0])
        return replace(self, stretches=kept, lost=self.lost + lost)

    @cached_property
    def sides(self) -> list[list[tuple[Spline, Spline]]]:
        """Of every stretch those of the holes: the lower from its start, the upper from its end."""
        return [one.sides(self.columns, self.across, full=self.full) for one in self.stretches]

    def loop(self, j: int) -> Path:
        """The j-th hole, anticlockwise."""
        sides = [of_stretch[j] for of_stretch in self.sides]
        lower: list[Segment] = [side for side, _ in sides]
        upper: list[Segment] = [side for _, side in reversed(sides)]
        return Path(close_chain([*lower, *upper]), closed=True)


@dataclass(frozen=True, eq=False)
class _Stretch:
    """Knots and coefficients (m, 3) of width, material and full diamond; cubic."""

    knots: FloatArray
    values: FloatArray

    def within(self, low: float, high: float) -> "_Stretch | None":
        """The part between two stations; None where there is none."""
        a, b = max(low, float(self.knots[0])), min(high, float(self.knots[-1]))
        if b - a <= JOIN:
            return None
        if (a, b) == (self.knots[0], self.knots[-1]):
            return self
        inner = self.knots[(self.knots > a) & (self.knots < b)]
        knots = np.concatenate([np.repeat(a, 4), inner, np.repeat(b, 4)])
        sites = np.clip(greville(knots, 3), a, b)  # a mean of equal knots may be off by rounding
        values = bezier_spans(self.knots, 3).basis(sites) @ self.values
        solved = np.linalg.solve(bezier_spans(knots, 3).basis(sites), values)
        return _Stretch(knots, np.asarray(solved, dtype=float))

    def sides(self, columns: int, across: int, *, full: bool) -> list[tuple[Spline, Spline]]:
        """Of each of the holes `across` the lower side from its start, and the upper side from its end."""
        w, m, diamond = self.values.T
        t, pitch = m / (2 * columns + 2), (w - m) / columns
        gap = pitch - diamond
        step = 2 * t + pitch
        j = np.arange(across)[:, None]
        if full:
            center, half = -w / 2 + 2 * t + pitch / 2 + j * step, diamond / 2
            lower, upper = center - half, center + half
        else:
            center = -w / 2 + t + j * step
            lower = center - np.where(j > 0, gap / 2, 0.0)
            upper = center + np.where(j < columns, gap / 2, 0.0)
        return list(zip(graphs(self.knots, lower), graphs(self.knots, upper, backward=True), strict=True))
