"""Perforated strips: diamond holes that reduce the net width to the value that the stiffness requires."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import SEEN_APART, counted, distinct_digits
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import (
    MATERIAL_WIDTH,
    Angle,
    Change,
    Either,
    FaultError,
    FieldName,
    InputError,
    note,
    rounded_down,
    rounded_up,
)
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.approximations import as_arcs
from elastica_cad.geometry.path import JOIN, Path, Segment, Spline, distances
from elastica_cad.geometry.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import SplineFunction, adaptive_spline, over_knots
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import ScaleRange
from elastica_cad.mechanics.sections import PerforatedSection
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.corner_rounding import rounded_where_they_fit, too_small_for
from elastica_cad.strip.outline import Ends, Tab, close_chain, graphs
from elastica_cad.strip.slots import Slot, slot_cut
from elastica_cad.strip.styles import (
    Layout,
    Width,
    refine_stations,
    require_laid_out,
    stations_of,
    width_profile,
)

FIT_MM = 2e-5
"""Largest error of the fitted outline width, net width and hole width, mm. Together these errors change the
sum of all ligaments by at most 1e-4 mm."""

CLEAR_OF_SLOTS_MM = 0.02
"""Chord error, mm, of the polylines with which distances between holes and slots are measured.

The least distance itself is `DiamondPattern.clearance`."""


@dataclass(frozen=True, eq=False)
class DiamondPattern:
    """Pattern of diamond holes: in every second row, diamonds are between the columns, and half diamonds at
    the edges.

    Let H = width - material be the total width of the holes, n = `columns`, and t = material / (2 n + 2). T(s)
    rises from 0 to 1 over half a row and falls again. Full diamonds have the width T H / n. Diamonds in the gaps
    have the width (1 - T) H / n, and the half diamonds at the edges have half this width. At every station, the
    widths of all holes add up to H. Every ligament has the width t, or 2 t where two ligaments join. T is constant
    over the length `bridge` between two rows, which separates the tips of the holes.

    Parameters
    ----------
    width, material : Profile
        Width of the outline, and total width of the ligaments, mm.
    columns, rows : int
        Numbers of full diamonds across the strip and along it.
    bridge : float
        Solid length along the strip between the tips of two holes, mm.
    corner_radius : float
        Radius of the corners of holes, mm; 0 for sharp corners.
    clearance : float
        Clearance between holes and slots, mm. A hole that a slot would cross is divided into a hole before and a
        hole after the slot. The clearance also applies at an end whose tab is narrower than the strip.
    arcs : float, optional
        Tolerance, mm, for sides approximated by arcs; by default the sides are splines.
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
        """Number of ligaments side by side across the strip. Ligaments that are joined count separately."""
        return 2 * self.columns + 2

    @property
    def row_length(self) -> float:
        """Length of a row along the strip, mm."""
        return self.width.length / self.rows

    @property
    def side_length(self) -> float:
        """Length along the strip, mm, from the tip of a diamond to its widest station."""
        return self.row_length / 2 - self.bridge

    def slopes(self, s: FloatArray) -> FloatArray:
        """Return the slopes (n,) of the sides of the diamonds to the centre line at stations `s` (n,), mm."""
        return (self.width(s) - self.material(s)) / (2 * self.columns * self.side_length)

    @cached_property
    def joints(self) -> FloatArray:
        """Stations (2 rows + 1,), mm, at the tips of diamonds, where the neighbouring diamonds are widest."""
        return np.linspace(0.0, self.width.length, 2 * self.rows + 1)

    def __post_init__(self) -> None:
        if self.side_length <= self.bridge:
            raise InputError(
                f"{self.rows} rows of holes leave a length of {Mm(self.row_length):.3g} for each row, but bridges "
                f"of {Mm(self.bridge):g} between the holes need more than {Mm(4 * self.bridge):g}: use fewer rows"
            )

    def paths(self, ends: Ends, slots: Sequence[Slot] = ()) -> tuple[Path, ...]:
        """Return the holes as closed anticlockwise loops in order along the strip, clear of tabs and slots.

        A part of at most half a hole is omitted if the corner radius does not fit into it.
        """
        cuts = [slot_cut(slot, self.width, beyond=slot.width) for slot in slots]
        length = self.width.length
        within = self._margin(ends[0], 0.0), length - self._margin(ends[1], length)
        clear = [
            (part, part.loop(j))
            for row in filter(None, (row.within(*within) for row in self._rows))
            for j in range(row.across)
            for part in self._divide_at_slots(row, j, cuts)
        ]
        loops = [loop for _, loop in clear]
        if self.corner_radius > 0:
            rounded = rounded_where_they_fit(loops, self.corner_radius)
            for (part, loop), rounded_loop in zip(clear, rounded, strict=True):
                if rounded_loop is None and part.lost < part.length:
                    raise too_small_for(self.corner_radius, loop)
            loops = [rounded_loop for rounded_loop in rounded if rounded_loop is not None]
        if self.arcs is not None:
            loops = [as_arcs(loop, self.arcs) for loop in loops]
        return tuple(loops)

    def _margin(self, tab: Tab, s: float) -> float:
        # return the distance, mm, of the holes from the end at `s`: 0 beside a tab as wide as the strip
        held = tab.width is None or tab.width >= float(self.width(s))
        return 0.0 if held and tab.length > 0 else self.clearance

    def _divide_at_slots(self, row: "_Row", j: int, cuts: Sequence[Path]) -> list["_Row"]:
        # return the parts of a row in which its hole number j is clear of the cuts of slots
        rows = [row]
        for cut in cuts:
            rows = [part for piece in rows for part in self._divide_at_slot(piece, j, cut)]
        return rows

    def _divide_at_slot(self, row: "_Row", j: int, cut: Path) -> list["_Row"]:
        if self._apart(row.loop(j), cut):
            return [row]
        (low, _), (high, _) = cut.bounds
        sides = row.within(-np.inf, low - self.clearance), row.within(high + self.clearance, np.inf)
        # shorter parts are omitted
        return [side for side in sides if side is not None and side.length > 2 * self.clearance]

    def _apart(self, loop: Path, cut: Path) -> bool:
        """Return True if a hole keeps the clearance, mm, from a slot or other cut."""
        low, high = cut.bounds + np.array([[-self.clearance], [self.clearance]])
        if np.any(loop.bounds[0] >= high) or np.any(loop.bounds[1] <= low):
            return True
        points, line = loop.closed_points(CLEAR_OF_SLOTS_MM), cut.points(CLEAR_OF_SLOTS_MM)
        if polylines_cross(points, line) is not None or encloses(line, points[0]):
            return False
        return all(
            distances(segment, others).min() >= self.clearance
            for path, others in ((cut, points), (loop, line))
            for segment in path.segments
        )

    @cached_property
    def _rows(self) -> list["_Row"]:
        """Rows of holes.

        Each extends between tips, half a bridge from a joint, and overlaps half of the next row.
        """
        # row i is between the joints i - 1 and i + 1, if they exist
        first, last = self.joints[:-1] + self.bridge / 2, self.joints[1:] - self.bridge / 2
        first[0], last[-1] = self.joints[0], self.joints[-1]
        stretches = self._stretches
        middles = np.array([(stretch.knots[0] + stretch.knots[-1]) / 2 for stretch in stretches])
        begins = middles.searchsorted(np.append(first[:1], first), side="right").tolist()
        ends = middles.searchsorted(np.append(last, last[-1:])).tolist()
        return [
            _Row(tuple(stretches[begin:end]), self.columns, full=i % 2 == 1)
            for i, (begin, end) in enumerate(zip(begins, ends, strict=True))
        ]

    @property
    def _stretches(self) -> list["_Stretch"]:
        """Parts of the pattern between tips of holes and jumps of the width, with widths as cubic splines."""
        breaks = [*self.width.breaks, *self.material.breaks]
        jumps = np.array([s for s, continuity in breaks if continuity < 0])
        inner = self.joints[1:-1]
        tips = np.concatenate([inner - self.bridge / 2, inner + self.bridge / 2])
        cuts = np.unique(np.concatenate([self.joints[[0, -1]], tips, jumps]))
        low, high = cuts[:-1], cuts[1:]
        # splines are fitted a little beside jumps of the width
        inset = 1e-9 * (high - low)
        starts = self._values(np.where(np.isin(low, jumps), low + inset, low))
        ends = self._values(np.where(np.isin(high, jumps), high - inset, high))
        rough = [(s, continuity) for s, continuity in breaks if continuity < 2]
        splines = [
            adaptive_spline(self._values, ends, degree=3, tolerance=FIT_MM, breaks=rough, rounding=1e-12)
            for ends in np.column_stack([low + inset, high - inset]).tolist()
        ]
        for i, (knots, values) in enumerate(splines):
            knots[:4], knots[-4:] = low[i], high[i]
            values[0], values[-1] = starts[i], ends[i]
        return [_Stretch(knots, values) for knots, values in splines]

    def _values(self, s: FloatArray) -> FloatArray:
        """Return the columns (n, 3): outline width, net width and width of a full diamond, mm."""
        w, m = self.width(s), self.material(s)
        # k is the index of the half row; its ends are solid over half a bridge, except at the ends of the strip
        half, last = self.row_length / 2, 2 * self.rows - 1
        k = np.floor(s / half).clip(0, last)
        before, after = np.where(k > 0, self.bridge / 2, 0.0), np.where(k < last, self.bridge / 2, 0.0)
        rise = ((s - k * half - before) / (half - before - after)).clip(0.0, 1.0)
        T = np.where(k % 2 == 0, rise, 1 - rise)
        return np.column_stack([w, m, T * (w - m) / self.columns])


@dataclass(frozen=True, eq=False)
class _Row:
    """A row of holes side by side: full diamonds, or diamonds in the gaps and half diamonds at the edges.

    `stretches` are its parts along the strip. `full` is True for full diamonds. `lost` is the length, mm, that ends
    and slots have cut off. `sides` has the lower and the upper side of each hole, for each stretch.
    """

    stretches: tuple["_Stretch", ...]
    columns: int
    full: bool
    lost: float = 0.0

    @property
    def across(self) -> int:
        # number of holes side by side
        return self.columns if self.full else self.columns + 1

    @property
    def length(self) -> float:
        return float(self.stretches[-1].knots[-1] - self.stretches[0].knots[0])

    def within(self, low: float, high: float) -> "_Row | None":
        """Return the part of the row between the arc lengths `low` and `high`, mm, or None if there is none."""
        if low <= self.stretches[0].knots[0] and self.stretches[-1].knots[-1] <= high:
            return self
        parts = tuple(part for stretch in self.stretches if (part := stretch.within(low, high)) is not None)
        if not parts:
            return None
        lost = self.length - float(parts[-1].knots[-1] - parts[0].knots[0])
        return replace(self, stretches=parts, lost=self.lost + lost)

    @cached_property
    def sides(self) -> list[list[tuple[Spline, Spline]]]:
        return [stretch.sides(self.columns, self.across, full=self.full) for stretch in self.stretches]

    def loop(self, j: int) -> Path:
        # return hole number j, counted from the lower edge, as a closed loop
        sides = [of_stretch[j] for of_stretch in self.sides]
        lower: list[Segment] = [side for side, _ in sides]
        upper: list[Segment] = [side for _, side in reversed(sides)]
        return Path(close_chain([*lower, *upper]), closed=True)


@dataclass(frozen=True, eq=False)
class _Stretch:
    """Part of the pattern, with its widths as cubic splines on common knots.

    `values` (m, 3) are the coefficients of the outline width, the net width and the width of a full
    diamond, mm.
    """

    knots: FloatArray
    values: FloatArray

    def within(self, low: float, high: float) -> "_Stretch | None":
        """Return the part of the stretch between the arc lengths `low` and `high`, mm, or None for a tiny part."""
        a, b = max(low, float(self.knots[0])), min(high, float(self.knots[-1]))
        if b - a <= JOIN:
            return None
        if (a, b) == (self.knots[0], self.knots[-1]):
            return self
        inner = self.knots[(self.knots > a) & (self.knots < b)]
        knots = np.pad([a, *inner, b], 3, mode="edge")
        return _Stretch(knots, over_knots(SplineFunction(self.knots, self.values, 3), knots, 3))

    def sides(self, columns: int, across: int, *, full: bool) -> list[tuple[Spline, Spline]]:
        """Return the lower and the upper side of each of `across` holes side by side.

        Lower sides are directed along x, and upper sides against x.
        """
        w, m, diamond = self.values.T
        # widths of a ligament, of a full diamond at its widest station, and of a diamond in a gap
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


STEEP_RAD = np.radians(30.0)
"""Inclination of ligaments, rad, above which a warning is added. Steeper ligaments are stiffer than their width
suggests."""

TIP_FRACTION = 0.03
"""Extra material at rounded tips, as a fraction of the net width, above which a warning is added."""


@dataclass(frozen=True, eq=False)
class Perforated:
    """Style of a strip with an outline of given width and diamond holes.

    The total width of the ligaments is proportional to the stiffness (paper, section 8.1).

    The proportion is exact in the bent part, except near rounded tips of holes. The weight per length
    is therefore proportional to the stiffness, as in a solid strip. Without `max_width`, the holes are as small,
    and the ligaments as wide, as the limits allow.

    Parameters
    ----------
    width : float, Profile or callable
        Width of the outline, mm: a number, or a profile or function of the arc length (such as `touching_widths`).
    columns, rows : int
        Numbers of full diamonds across the strip and along it. By default diamonds are three times as long as the
        spacing of the columns.
    hole_ratio : float
        Largest total width of the holes at a station, as a fraction of the outline width.
    least_ligament, least_hole : float
        Least width of a ligament, and least width of a hole at its widest station, mm.
    corner_radius : float
        Radius of the corners of holes, mm, which reduces tearing; 0 for sharp corners.
    sides : "spline" or "arc"
        Kind of curve for the sides of holes.

    Examples
    --------
    >>> from elastica_cad.strip.strip import Strip
    >>> style = Perforated(width=24.0, columns=2, rows=4)
    >>> strip = Strip(Rod.straight(120.0, [1, 2, 1]), Sheet.named("card-200gsm"), style=style)
    >>> len(strip.holes)  # four rows of two, five of three
    23
    >>> left, needed = strip.layers[0].material([13.7, 60.0]), strip.layout.material([13.7, 60.0])
    >>> bool(abs(left / needed - 1).max() < 1e-4)
    True
    """

    width: Annotated[Width, Option("Width of the outline.", "mm", least=0, common=True, written=float)]
    columns: Annotated[int, Option("Number of diamond holes side by side.", least=1)] = 2
    rows: Annotated[
        int | None,
        Option(("Number of diamond holes along the strip; chosen automatically by default."), least=1),
    ] = None
    hole_ratio: Annotated[
        float, Option("Largest fraction of the width that the holes may take.", above=0, most=1)
    ] = 0.85
    least_ligament: Annotated[float, Option("Narrowest ligament between holes.", "mm", above=0)] = 0.5
    least_hole: Annotated[float, Option("Least width of a hole, at its widest place.", "mm", above=0)] = 1.0
    corner_radius: Annotated[float, Option("Corner radius of the holes.", "mm", least=0)] = 0.0
    sides: Annotated[Literal["spline", "arc"], Option("Curves that form the sides of holes.")] = "spline"

    def __post_init__(self) -> None:
        require_declared(Perforated, vars(self))

    @property
    def ligaments(self) -> int:
        """Number of ligaments side by side across the strip."""
        return 2 * self.columns + 2

    def laid_out(
        self, rod: Rod, sheet: Sheet, *, max_width: float | None = None, min_width: float | None = None
    ) -> Layout:
        """Return the flat pattern of a rod.

        Parameters
        ----------
        max_width, min_width : float, optional
            Limits of the total width of the ligaments, mm.
        """
        require_laid_out(rod, sheet, max_width, min_width)
        outer = width_profile(self.width, rod.length, "the width of the outline")
        fit = _Fit(self, rod, sheet, outer)
        scale = fit.scale(max_width, min_width)
        material = rod.profile.scaled(scale / fit.section.rigidity)
        # diamonds are three times as long as the spacing of the columns
        rows = self.rows or max(1, round(rod.length * self.columns / (3.0 * float(fit.w.mean()))))
        # bridges and clearances are as wide as the narrowest ligament
        pattern = DiamondPattern(
            outer, material, self.columns, rows, self.least_ligament, self.corner_radius, self.least_ligament,
            arcs=None if self.sides == "spline" else 5e-4 * material.extremes[0] / self.ligaments,
        )  # fmt: skip
        warnings = tuple(self._warnings(pattern, fit.s))
        return Layout(sheet, outer, material, scale, pattern=pattern, warnings=warnings)

    def _warnings(self, pattern: DiamondPattern, s: FloatArray) -> Iterator[str]:
        slopes = pattern.slopes(s)
        i = slopes.argmax()
        if slopes[i] > np.tan(STEEP_RAD):
            # length of a row whose sides have the allowed slope; slopes are inversely proportional to `side_length`
            long = pattern.row_length + 2 * pattern.side_length * (slopes[i] / np.tan(STEEP_RAD) - 1)
            yield note(
                "the ligaments (material between holes) {s} from the start are inclined by {angle:.0f}, "
                "too much for an exact stiffness: use fewer holes along the strip, each at least {long} long",
                angle=Angle(np.arctan(slopes[i])), s=Mm(s[i]), long=Mm(np.ceil(long)),
            )  # fmt: skip
        # the rounding of a corner with half angle a and radius r begins where the hole is 2 r (sec a - tan a) wide;
        # half diamonds have half the angle of full diamonds, so their rounding begins farther from the joint
        slope = pattern.slopes(pattern.joints)
        others, halves = (
            2 * self.corner_radius * (np.hypot(1.0, tan) - tan)
            for tan in (slope, np.tan(np.arctan(slope) / 2))
        )
        at_gaps = np.arange(slope.size) % 2 == 1
        # largest extra width, mm, that rounded tips leave near each joint
        excess = np.maximum(self.columns * others, np.where(at_gaps, 2 * halves, 0.0))
        missing = excess / pattern.material(pattern.joints)
        i = missing.argmax()
        if missing[i] > TIP_FRACTION:
            yield note(
                "a corner radius of {radius:g} leaves {percent:.2g} % too much material at the tips of the "
                "holes {s} from the start: use {least:g} or less to stay within {allowed:.0f} %",
                radius=Mm(self.corner_radius), percent=100 * missing[i], s=Mm(pattern.joints[i]),
                least=Mm(rounded_down(self.corner_radius * TIP_FRACTION / missing[i], 2)),
                allowed=100 * TIP_FRACTION,
            )  # fmt: skip


class _Fit:
    """Range of the scale, N mm2, in which the net widths fit the outline.

    Ligaments and the largest part of holes limit it. `s`, `w` and `K` are stations, mm, with the width of the
    outline, mm, and the relative stiffness. `holes` is the least total width of the holes, mm. `by_ligaments` and
    `by_ratio` are the ranges due to the two limits.
    """

    def __init__(self, style: Perforated, rod: Rod, sheet: Sheet, outer: Profile) -> None:
        self.style, self.rod = style, rod
        # the narrowest holes are the half diamonds at the edges, half as wide as the n full diamonds
        self.holes = 2 * style.columns * style.least_hole
        s = stations_of(rod.length, outer, rod.profile)
        self.s = refine_stations(s, outer(s) / rod.profile(s), (outer(s) - self.holes) / rod.profile(s))
        self.w, self.K = outer(self.s), rod.profile(self.s)
        self.section = PerforatedSection(
            sheet, ligaments=style.ligaments, least_ligament=style.least_ligament
        )
        room = self.w - self.holes
        i = room.argmin()
        if room[i] <= style.ligaments * style.least_ligament:
            raise InputError(
                "the outline {s:.1f} from the start is {w:.4g} wide, but {ligaments} ligaments (material "
                "between holes) of {least_ligament:g} and {columns} columns of holes need more than "
                "{holes:.4g}. Widen the outline or use fewer columns",
                w=Mm(self.w[i]),
                s=Mm(self.s[i]),
                ligaments=style.ligaments,
                least_ligament=Mm(style.least_ligament),
                columns=style.columns,
                holes=Mm(self.holes + style.ligaments * style.least_ligament),
            )
        self.by_ligaments = self.section.scale_range(room, self.K)
        most = self.section.bending_stiffness(room)
        least = self.section.bending_stiffness((1 - style.hole_ratio) * self.w)
        self.by_ratio = ScaleRange.of(least, most, self.K)
        # both ranges have the same upper limit, from the least width of the holes
        self.lowest = max(self.by_ligaments.lowest, self.by_ratio.lowest)
        self.highest = self.by_ligaments.highest

    def scale(self, max_width: float | None, min_width: float | None) -> float:
        """Return the bending stiffness of the strip where the relative stiffness is 1, N mm2.

        If the rod has no bending stiffness, return the largest value that `max_width` allows.
        """
        if self.lowest > self.highest * (1 + SEEN_APART):
            raise FaultError(self._infeasible())
        # E I per mm of net width, and extremes of K: the net width is scale * K / rigidity
        rigidity, (low, high) = self.section.rigidity, self.rod.profile.extremes
        scale = self.highest if max_width is None else min(self.highest, rigidity * max_width / high)
        if self.rod.bending_stiffness is not None:
            stiffness = self.rod.bending_stiffness
            if stiffness > scale * (1 + SEEN_APART):
                i = self.by_ligaments.highest_at
                needed, given = distinct_digits(
                    stiffness * self.K[i] / rigidity, scale * self.K[i] / rigidity, ".4g"
                )
                raise FaultError(
                    "{s:.1f} from the start, all ligaments (material between holes) together must be {needed:g} "
                    "wide, but the outline and {field} allow only {given:g}: widen the outline or raise {field}",
                    field=MATERIAL_WIDTH,
                    needed=Mm(needed),
                    s=Mm(self.s[i]),
                    given=Mm(given),
                )
            scale = stiffness
        if scale < self.lowest * (1 - SEEN_APART):
            way = (
                note("raise {field}", field=MATERIAL_WIDTH)
                if self.rod.bending_stiffness is None
                else note("use a thinner or softer sheet")
            )
            needed, given = distinct_digits(self.lowest * high / rigidity, scale * high / rigidity, ".4g")
            raise FaultError(
                "{too_little}. At the widest place all ligaments (material between holes) together must be "
                "{needed:g} wide, but are {given:g} wide: {way}",
                too_little=self._too_little(scale),
                needed=Mm(needed),
                given=Mm(given),
                way=way,
                changes=[Change("max_width", rounded_up(self.lowest * high / rigidity))]
                if self.rod.bending_stiffness is None
                else [],
            )
        if min_width is not None and scale * low / rigidity < min_width * (1 - SEEN_APART):
            total, limit = distinct_digits(scale * low / rigidity, min_width, ".4g")
            raise FaultError(
                "all ligaments (material between holes) together are {ligaments:g} wide at the narrowest "
                "place, less than {field} ({min_width:g}): widen the outline or lower the stiffness ratio",
                field=FieldName("min_width"),
                ligaments=Mm(total),
                min_width=Mm(limit),
            )
        return scale

    def _infeasible(self) -> str:
        """Return the sentence that the outline is too narrow somewhere, with the changes that would help."""
        style, rigidity = self.style, self.section.rigidity
        i, need = self._least_outline()
        ways = []
        if np.isfinite(need):
            ways.append(note(
                "make the outline {s} from the start at least {least:g} wide (now {now:.4g})"
                if self._has_varying_outline(i) else
                "make the outline at least {least:g} wide everywhere (now {now:.4g})",
                least=Mm(rounded_up(need)), s=Mm(self.s[i]), now=Mm(self.w[i]),
            ))  # fmt: skip
        fewer = [n for n in range(style.columns - 1, 0, -1) if self._would_do(n)]
        if self.by_ratio.lowest > self.by_ligaments.lowest:
            # largest fraction of the width that the holes take at the highest possible stiffness
            share = 1 - float((self.highest * self.K / (rigidity * self.w)).min())
            ways.append(
                note(
                    "set {field} to {share:.3f}",
                    field=FieldName("style.hole_ratio"),
                    share=np.ceil(1000 * share) / 1000,
                )
            )
        elif fewer:
            ways.append(note("use {columns}", columns=counted(fewer[0], "column")))
        ratio = self.rod.ratio * self.highest / self.lowest
        if ratio > 1:
            now, most = distinct_digits(self.rod.ratio, rounded_down(ratio, 3), ".3g")
            ways.append(note("lower the stiffness ratio from {now:g} to {most:g}", now=now, most=most))
        return note(
            "The outline is too narrow {s} from the start. If holes must fit there, {too_little}: {ways}",
            too_little=self._too_little(self.highest), s=Mm(self.s[i]), ways=Either(ways),
        )  # fmt: skip

    def _least_outline(self) -> tuple[int, float]:
        """Return the index of a station where the outline is too narrow, and a sufficient width, mm.

        The width is infinite if no width is sufficient. An outline of constant width must be widened everywhere,
        which also increases the least net width.
        """
        rigidity = self.section.rigidity
        need = self.lowest * self.K / rigidity + self.holes
        i = int((need / self.w).argmax())
        if self._has_varying_outline(i):
            return i, float(need[i])
        # where K is least, the net width is at least (1 - hole_ratio) w, so where K is largest, it is at least
        # (1 - hole_ratio) w K_max / K_min; the rest of the constant width w is for holes
        share_of_holes = 1 - (1 - self.style.hole_ratio) * float(self.K.max() / self.K.min())
        by_ligaments = self.by_ligaments.lowest * float(self.K.max()) / rigidity + self.holes
        if share_of_holes <= 0:
            return i, np.inf
        return i, max(by_ligaments, self.holes / share_of_holes)

    def _has_varying_outline(self, i: int) -> bool:
        # return True if the outline's width varies noticeably, relative to its width at station i
        return bool(np.ptp(self.w) > SEEN_APART * self.w[i])

    def _would_do(self, columns: int) -> bool:
        # return True if the ligaments fit the outline with this number of columns
        section = PerforatedSection(
            self.section.sheet, ligaments=2 * columns + 2, least_ligament=self.style.least_ligament
        )
        return section.scale_range(self.w - 2 * columns * self.style.least_hole, self.K).feasible

    def _too_little(self, scale: float) -> str:
        """Return the part of a sentence on the place where the scale, N mm2, leaves too little material."""
        if self.by_ratio.lowest > self.by_ligaments.lowest:
            i = self.by_ratio.lowest_at
            share = 1 - scale * self.K[i] / (self.section.rigidity * self.w[i])
            percent, most = distinct_digits(100 * share, 100 * self.style.hole_ratio, ".3g")
            return note(
                "holes {s} from the start would take {percent:g} % of the width, more than {most:g} %",
                percent=percent, s=Mm(self.s[i]), most=most,
            )  # fmt: skip
        i = self.by_ligaments.lowest_at
        each = scale * self.K[i] / self.section.rigidity / self.style.ligaments
        shown, least = distinct_digits(each, self.style.least_ligament, ".3g")
        return note(
            "ligaments (material between holes) {s} from the start would be {each:g} wide, below {least:g}",
            each=Mm(shown), s=Mm(self.s[i]), least=Mm(least),
        )  # fmt: skip
