"""Models of surfaces of revolution, and widths with which neighbouring strips meet without gaps."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_whole, require_flag, require_number, require_record, several
from elastica_cad.defaults import BORDER, PLAY, RING_TAB_LENGTH
from elastica_cad.errors import FaultError, FieldName, InputError, Length, ended, note, sentences
from elastica_cad.form_finding.meridians import Meridian
from elastica_cad.form_finding.meridians import meridian as make_meridian
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve, line_crossings
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.elements import PointForce
from elastica_cad.mechanics.loads import Gravity, PointMass
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.model.fixtures import tabs_to_hold
from elastica_cad.model.frames import Rib
from elastica_cad.model.model import Model
from elastica_cad.model.plate_holes import PlateHoles, refuse_other_ends
from elastica_cad.model.plate_pairs import add_second_plates
from elastica_cad.model.plates import FLATTEST_RAD, Ring, end_names, ring_plate, slot_reach
from elastica_cad.model.spacers import add_spacers
from elastica_cad.strip.held_shape import about, deviation_from
from elastica_cad.strip.lamination import Laminated
from elastica_cad.strip.makeable_strip import compensate_within, refuse_broken
from elastica_cad.strip.outline import ENDS, Tab, pair_of_tabs
from elastica_cad.strip.own_weight import bent_under, carried_percentage, weight_warning
from elastica_cad.strip.perforation import Perforated
from elastica_cad.strip.strip import Placed, Strip
from elastica_cad.strip.strip_spec import GravityOption, pull_in_plane
from elastica_cad.strip.styles import PLAIN, Plain, Style, require_style, width_profile
from elastica_cad.strip.uncuttable_parts import (
    DEFAULT_LIMITS,
    FabricationLimits,
    accept_faults,
    find_strip_faults,
)

SLOPE_TOLERANCE = 1e-12
"""Two bounds on half a width are the same plane, and do not cross, if their slopes differ by at most this."""

END_MM = 1e-9
"""Distance, mm, from an end below which a kink of the width counts as being at the end."""


def touching_widths(
    strips: Sequence[Placed | tuple[PlaneCurve, Frame]], gap: float = 0.0, *, closed: bool = False
) -> tuple[Profile, ...]:
    """Return widths with which neighbouring strips meet at the planes that bisect the angles between them.

    The bisector planes are first moved towards the curve by the gap. Half the width is then the distance from
    the curve, along the ruling, to the nearer plane. The Flower Pot and the Shell of the paper (section 9)
    have such widths.

    Parameters
    ----------
    strips : sequence of Placed, or of (PlaneCurve, Frame)
        Strips in order around the surface. The frame is the plane of the curve.
    gap : float
        Distance of each strip from the bisector plane, mm.
    closed : bool
        True if the last and the first strip are neighbours.

    Returns
    -------
    tuple of Profile
        Full widths, mm, as functions of arc length.

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
        raise InputError(f"strips are {strips!r}: give a list of Placed, or of (PlaneCurve, Frame)")
    pairs = [(p.strip.rod.curve, p.frame) if isinstance(p, Placed) else p for p in strips]
    names = [
        (p.strip.label if isinstance(p, Placed) else "") or f"strip {number}"
        for number, p in enumerate(strips, start=1)
    ]
    count = len(pairs)
    if count < 2:
        raise InputError("touching strips need neighbours: give at least two strips")
    require_flag(closed, "closed")
    widths = []
    for i, (curve, frame) in enumerate(pairs):
        around = {(i - 1) % count, (i + 1) % count} if closed else {i - 1, i + 1} & set(range(count))
        bounds = [
            _bisector_bound((curve, frame), pairs[j], gap, (names[i], names[j])) for j in sorted(around)
        ]
        widths.append(_width_within(curve, bounds, gap, names[i]))
    return tuple(widths)


def _bisector_bound(
    placed_curve: tuple[PlaneCurve, Frame],
    other: tuple[PlaneCurve, Frame],
    gap: float,
    names: tuple[str, str],
) -> tuple[float, FloatArray]:
    """Return the bound on half the first strip's width at the plane midway between both strips.

    The plane is moved inwards by `gap` mm. The bound is a and b of the distance a + <b, gamma> of the strip's curve
    gamma from the plane.
    """
    frame, opposite = placed_curve[1], other[1]
    middles = [f.point(c.sample(33).position.mean(axis=0)) for c, f in (placed_curve, other)]
    # normals of the planes of both strips, each towards the other strip
    z, r = frame.z_axis, opposite.z_axis
    z = z * np.sign((middles[1] - frame.origin) @ z)
    r = r * np.sign((middles[0] - opposite.origin) @ r)
    # normal of the plane midway between the facing sides of both strips
    normal = z - r
    # change of the distance from the plane per mm along the ruling
    pace = float(normal @ z)
    if not (np.any(z) and np.any(r)) or pace < SLOPE_TOLERANCE:
        raise InputError(
            f"{names[0]} and {names[1]} are in the same plane, so no plane passes between them: move one of them"
        )
    offset = z @ frame.origin - r @ opposite.origin - gap * np.linalg.norm(normal)
    return float(offset - normal @ frame.origin) / pace, -(frame.axes[:2] @ normal) / pace


def _width_within(
    curve: PlaneCurve, bounds: Sequence[tuple[float, FloatArray]], gap: float, name: str
) -> Profile:
    """Return twice the smaller of the bounds of `_bisector_bound`, with a kink where the bounds cross."""
    # the width is continuous also at corners of the curve
    breaks = [(b.s, max(b.continuity, 0)) for b in curve.breaks]
    if len(bounds) == 2:
        (a, b), (c, d) = bounds
        if np.hypot(*(b - d)) > SLOPE_TOLERANCE:
            breaks += [(r.s, 0) for r in line_crossings(curve, a - c, b - d) if r.kind == "crossing"]
    # of several breaks at a place, the least continuity is the last, and is kept
    inside = {s: c for s, c in sorted(breaks, reverse=True) if END_MM < s < curve.length - END_MM}

    def half(s: FloatArray) -> FloatArray:
        points = curve.at(s).position
        return np.asarray(np.min([a + points @ b for a, b in bounds], axis=0))

    width = Profile.fit(lambda s: 2 * half(s), curve.length, breaks=sorted(inside.items()), tolerance=1e-5)
    least, _ = width.extremes
    if least <= 0:
        s = np.linspace(0.0, curve.length, 2001)
        raise InputError(
            "with a gap of {gap:g}, {name} would be only {least:.4g} wide at {at:.6g} from its start: reduce "
            "the gap, or end the strip before this place",
            name=name,
            at=Length(float(s[int(half(s).argmin())])),
            least=Length(least),
            gap=Length(gap),
        )
    return width


MOST_STRIPS = 1000
"""Largest number of strips. A sphere of 1 m would then have strips 3 mm wide."""


def revolution(
    a: float,
    b: ArrayLike,
    start: ArrayLike,
    angle: float,
    strips: int,
    *,
    length: float,
    ring: float | None = None,
    **options: Any,
) -> Model:
    """Return the model of `revolve` for the meridian gamma with x kappa = a + <b, gamma>.

    Here kappa is the curvature, and x the distance from the axis. See `meridian` for the parameters.

    Examples
    --------
    >>> card = Sheet.named("card-200gsm")
    >>> vase = revolution(-1.5, (0, 0.03), (150, -11.5), 2.2, 15, length=300, sheet=card)
    >>> len(vase.placed), len(vase.parts)
    (15, 1)
    """
    return revolve(make_meridian(a, b, start, angle, length, ring=ring), strips, **options)


def revolve(
    meridian: Meridian,
    strips: int,
    *,
    sheet: Sheet | str,
    ends: tuple[Tab, Tab] | None = None,
    rings: Sheet | str | None = None,
    gap: float | None = None,
    spacers: int | None = None,
    border: float = BORDER,
    holes: PlateHoles | None = None,
    name: str = "revolution",
    shop: FabricationLimits = DEFAULT_LIMITS,
    ignore_limits: bool = False,
    style: Style = PLAIN,
    engrave: str | None = None,
    compensate: bool = False,
    creep: float = 0.0,
    gravity: GravityOption = None,
    loads: Sequence[PointMass | PointForce] = (),
) -> Model:
    """Return the model of a surface of revolution about z, tiled by equal strips along its meridians.

    Parameters
    ----------
    meridian : Meridian
        From `meridian` or `meridian_through`.
    strips : int
        Number of strips.
    sheet : Sheet or str
        Sheet of the strips, or its name.
    ends : pair of Tab, optional
        Tabs of each strip. By default they are 8 mm long, or as long as two rings need, and narrow enough to keep
        neighbouring tabs apart.
    rings : Sheet or str, optional
        Sheet of the ring at each end, or of the cap near a pole. Rings and caps are the `plates` of the
        model; see `ring_plate`. The plates are named ring-bottom and ring-top, or ring-start and ring-end if they
        have equal heights.
    gap : float, optional
        If given, two rings at this distance, mm, replace each single slotted ring and hold the tabs at their
        angle; see `ring_pair`.
    spacers : int, optional
        Number of spacers between the two rings of each pair; see `add_spacers`. The rings are as wide as they need.
    border : float
        Least distance of the slots for strips from the edges of the rings, mm.
    holes : PlateHoles, optional
        Holes of the rings for a lamp holder and screws.
    name : str
    shop : FabricationLimits
        Limits of the workshop.
    ignore_limits : bool
        Make strips and rings beyond these limits, and list the faults in their warnings.
    style : Plain, Perforated or Laminated
        Style of the strips. The width of its outline must be the width of touching strips at their widest place.
    engrave : str, optional
        Text engraved on each strip.
    compensate : bool
        Correct the widths, as in `StripSpec`. The strips become at most as wide as touching strips, so they leave
        gaps.
    creep : float
        Long-term creep factor of the sheet.
    gravity : Gravity, bool or direction, optional
        Weight of the strips, as in `StripSpec`; its direction must be along the axis. The touching widths stay, so
        weight and loads move the strips from the meridian.
    loads : sequence of PointMass and PointForce
        Loads on each strip. The x axis of the plane of a strip is away from the axis, and its y axis is z.

    Examples
    --------
    >>> from elastica_cad.form_finding.meridians import meridian_through
    >>> profile = meridian_through([(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)])
    >>> len(revolve(profile, 20, sheet="card-200gsm", rings="hdf-1.5").plates)
    2
    """
    require_record(meridian, Meridian, "what is turned", "a Meridian, as meridian_through makes one")
    if not (is_whole(strips) and 3 <= strips <= MOST_STRIPS):
        raise InputError(
            f"the number of strips is {strips!r}: give 3 to {MOST_STRIPS} for a surface of revolution"
        )
    sheet = Sheet.of(sheet)
    rings = None if rings is None else Sheet.of(rings)
    require_record(shop, FabricationLimits, "the shop", "a FabricationLimits")
    require_flag(ignore_limits, "ignore_limits")
    ends = None if ends is None else pair_of_tabs(ends)
    if gap is not None:
        require_number(gap, "gap", "mm")
    require_style(style)
    request = _Request(
        strips, sheet, ends, rings, gap, shop, style, engrave, compensate, creep,
        _gravity_along_axis(gravity, sheet),
        several("loads", loads, PointMass | PointForce, "PointMass or PointForce"),
        spacers, border, holes, ignore_limits,
    )  # fmt: skip
    try:
        placed, plates, reports = request.made(meridian)
    except InputError as problem:
        works = _smallest_ring(meridian, request) if meridian.at_pole else None
        if works is None:
            raise
        message = f"{problem}".rstrip(".")
        raise InputError(f"{message}; use ring={works} or more (in mm)") from problem
    return Model(placed, name=name, plates=plates, reports=reports)


def _gravity_along_axis(gravity: GravityOption, sheet: Sheet) -> Gravity | None:
    acting, share = pull_in_plane(gravity or None, sheet, Frame(y_axis=(0.0, 0.0, 1.0)))
    if gravity and (acting is None or max(abs(acting.direction[0]), abs(share - 1)) > SLOPE_TOLERANCE):
        raise InputError(
            "{gravity} must act along the axis of a surface of revolution, because all its strips are equal. Use "
            "true or [0, 0, 1].",
            gravity=FieldName("gravity"),
            where={"field": "gravity"},
        )
    return acting


def revolved_strip(
    meridian: Meridian, strips: int, *, sheet: Sheet, gravity: GravityOption, **options: Any
) -> Strip:
    """Return the strip of `revolve` without its checks."""
    acting = _gravity_along_axis(gravity, sheet)
    return _Request(strips, sheet, gravity=acting, **options)._placed(meridian)[0].strip


# strips, rings with spacers, and messages
Made: TypeAlias = tuple[tuple[Placed, ...], tuple[Ring | Rib, ...], tuple[str, ...]]


@dataclass(frozen=True)
class _Request:
    """Options of a surface of revolution, for every meridian that is tried; see `revolve`.

    `narrower`, mm, is taken from the width of default tabs between two rings.
    """

    strips: int
    sheet: Sheet
    ends: tuple[Tab, Tab] | None
    rings: Sheet | None
    gap: float | None
    shop: FabricationLimits
    style: Style
    engrave: str | None
    compensate: bool
    creep: float
    gravity: Gravity | None
    loads: Sequence[PointMass | PointForce]
    spacers: int | None = None
    border: float = BORDER
    holes: PlateHoles | None = None
    ignore_limits: bool = True
    narrower: float = 0.0

    def made(self, meridian: Meridian) -> Made:
        """Return the strips, the plates and the warnings.

        The load of a strip bends its tabs between two rings, and their slots follow. If the slots of default tabs
        are then too close, narrower tabs are tested.
        """
        try:
            return self._made(meridian)
        except FaultError:
            if self.gap is None or self.ends is not None:
                raise
            for narrower in (0.5, 1.5, 4.0):  # mm
                with suppress(InputError):
                    return replace(self, narrower=narrower)._made(meridian)
            raise

    def _made(self, meridian: Meridian) -> Made:
        """Return the result of `made` for tabs of one width.

        Problems of the strips and of the ring at each end are independent, so one error states all of them.
        """
        placed = self._placed(meridian)
        checks: list[Callable[[], Any]] = self._checks(placed)
        notes = self._notes(meridian, placed[0].strip)
        if self.rings is None:
            *_, warnings = _results_of(checks)
            return placed, (), (*notes, *warnings)
        heights = meridian.rod.position[:, 1]
        names = end_names("ring", (heights[0], heights[-1]))
        refuse_other_ends(self.holes, [*names.values()])
        checks += [
            partial(
                ring_plate, tabs_to_hold(placed, [end]), self.rings, name=names[end], border=self.border,
                middle=float(heights.min() + heights.max()) / 2, holes=self.holes, shop=self.shop,
                ignore_limits=self.ignore_limits,
            )
            for end in ENDS
        ]  # fmt: skip
        # results of the two checks of the strips, then the rings
        _, warnings, *made = _results_of(checks)
        warnings = (*notes, *warnings)
        plates: tuple[Ring, ...] = tuple(made)
        if self.gap is not None:
            plates = add_second_plates(
                placed,
                plates,
                self.gap,
                strips_at=None if self.ends else lambda gap: replace(self, gap=gap)._checked_strips(meridian),
            )
        if self.spacers is None:
            return placed, plates, warnings
        rings, spacers = add_spacers(placed, plates, self.spacers)
        return placed, (*rings, *spacers), warnings

    def _placed(self, meridian: Meridian) -> tuple[Placed, ...]:
        """Return the strips about the axis, all cut alike, as wide as their neighbours permit."""
        width, tabs = meridian.width(self.strips), self._tabs(meridian)
        widest, style = float(width.extremes[1]), self.style
        if isinstance(style, Perforated | Laminated):
            drawn = width_profile(style.width, meridian.curve.length, "the width of the outline")
            if abs(float(drawn.extremes[1]) / widest - 1) > 5e-3:
                raise InputError(
                    "The {count} strips touch each other, so their largest width is {width:.4g}. Set {field} to "
                    "this width, or change the number of strips.",
                    count=self.strips,
                    width=Length(widest),
                    field=FieldName("style.width"),
                    where={"field": "style.width"},
                )
            style = replace(style, width=width)
        strip: Strip = _Gore(
            meridian.rod,
            self.sheet,
            max_width=widest if isinstance(style, Plain) else None,
            style=style,
            ends=self.ends or tabs,
            engrave=self.engrave,
            creep=self.creep,
            widest_tabs=None if self.rings is None else tabs,
        )
        if self.compensate:
            strip = compensate_within(strip, self.shop)
        if strip.max_width is not None and strip.correction is not None:
            # corrected widths are scaled until they nowhere exceed the touching widths
            s = strip.rod.s
            strip = replace(strip, max_width=widest * float((width(s) / strip.width(s)).min()))
        strip = self._loaded(strip)
        turn = 2 * np.pi * np.arange(self.strips) / self.strips
        return tuple(Placed(strip, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn)

    def _loaded(self, strip: Strip) -> Strip:
        """Return the strip in its rest shape under its weight and loads."""
        if self.gravity is None and not self.loads:
            return strip
        rod = bent_under(strip, self.gravity, self.loads)
        if rod is None:
            raise InputError(
                "Under {carried:.2g} % of their weight and loads, the strips snap into another shape. Reduce the "
                "loads, or use a thicker sheet.",
                carried=carried_percentage(strip, self.gravity, self.loads),
                where={"field": "loads" if self.loads else "gravity"},
            )
        return replace(strip, rod=rod, max_width=None)

    def _notes(self, meridian: Meridian, strip: Strip) -> tuple[str, ...]:
        """Return notes on the movement by weight and loads, and on gaps between the strips.

        Without weight and loads, a note states the effect of the weight.
        """
        notes, rod = list[str](), strip.rod
        if self.compensate and strip.correction is None:
            notes.append(note("No correction of the widths makes the strips more accurate."))
        if rod is not meridian.rod:
            far = about(deviation_from(meridian.rod, rod.position))
            notes.append(
                note("The weight and the loads move the strips by up to {far} from the meridian.", far=far)
            )
        elif warning := weight_warning(strip, self.sheet.gravity()):
            notes.append(warning)
        gaps = 2 * np.tan(np.pi / self.strips) * rod.position[:, 0] - strip.width(rod.s)
        if float(np.abs(gaps).max()) > 0.05:
            notes.append(note(
                "The strips do not touch everywhere: gaps are up to {gap} wide, and overlaps up to {overlap}.",
                gap=about(max(float(gaps.max()), 0.0)), overlap=about(max(-float(gaps.min()), 0.0)),
            ))  # fmt: skip
        return tuple(notes)

    def _checks(self, placed: Sequence[Placed]) -> list[Callable[[], Any]]:
        strip = placed[0].strip
        return [
            lambda: refuse_broken(strip, self.ignore_limits),
            lambda: accept_faults(find_strip_faults(strip, self.shop), self.ignore_limits),
        ]

    def _checked_strips(self, meridian: Meridian) -> tuple[Placed, ...]:
        placed = self._placed(meridian)
        _results_of(self._checks(placed))
        return placed

    def _tabs(self, meridian: Meridian) -> tuple[Tab, Tab]:
        """Return the widest straight tabs that keep a gap to the tabs of both neighbours.

        A tab that would be too narrow for the workshop, as at a pole, is as wide as the end of the strip.
        """
        ends = meridian.curve.sample(2)
        # angles (2,) of the tabs in the plane of the meridian; 0 is away from the axis
        outward = ends.angle + np.array([np.pi, 0.0])
        steep = np.abs(np.sin(outward))
        # lengths (2,) of the tabs, mm, and the distance from the first to the last face of the rings
        lengths, through = np.full(2, RING_TAB_LENGTH), 0.0 if self.rings is None else self.rings.thickness
        if self.rings is not None and self.gap is not None:
            through += self.gap + self.rings.thickness
            # a tab extends 2 mm beyond the second ring
            needed = through / np.maximum(steep, np.sin(FLATTEST_RAD)) + 2.0
            lengths = np.where(
                steep > np.sin(FLATTEST_RAD), np.maximum(needed, RING_TAB_LENGTH), RING_TAB_LENGTH
            )
        # least distance (2,), mm, of each tab from the axis, where neighbouring tabs are closest
        near = np.minimum(ends.position[:, 0], ends.position[:, 0] + lengths * np.cos(outward))
        # tabs of neighbouring strips are at least 0.5 mm apart
        between_tabs = 0.5
        if self.rings is not None:
            # a bridge is measured along the side of a slot, which is inclined by half the angle between slots, and
            # `between_tabs` across this direction; the material between slots is 0.1 mm wider than necessary
            between_tabs = (
                2 * PLAY + (0.1 + self.shop.bridge_for(self.rings)) / float(np.cos(np.pi / self.strips)) ** 2
            )
            inner = [
                slot_reach(float(r), float(angle), through, self.sheet.thickness)
                for r, angle in zip(ends.position[:, 0], outward, strict=True)
            ]
            near = np.minimum(near, inner)
        room = 2 * np.tan(np.pi / self.strips) * near - between_tabs - self.narrower
        first, last = (
            Tab(float(long), width=float(wide) if wide >= self.shop.width_for(self.sheet) else None)
            for long, wide in zip(lengths, room, strict=True)
        )
        return first, last


@dataclass(frozen=True, eq=False, repr=False)
class _Gore(Strip):
    """Strip of a surface of revolution with rings, in which wider tabs than `widest_tabs` would meet."""

    widest_tabs: tuple[Tab, Tab] | None = None

    @property
    def is_widest(self) -> bool:
        """False, because the number of strips determines their width."""
        return False

    @property
    def _tab_rooms(self) -> tuple[float, float]:
        first, last = (tab.widest(np.inf) for tab in self.widest_tabs or (Tab(), Tab()))
        return first, last


def _results_of(checks: Sequence[Callable[[], Any]]) -> list[Any]:
    """Return the results of the functions, or raise one error that states the problems of all of them."""
    results, problems = [], list[InputError]()
    for check in checks:
        try:
            results.append(check())
        except InputError as problem:
            problems.append(problem)
    if len(problems) > 1:
        first, text = problems[0], sentences([ended(problem.refusal) for problem in problems], " ")
        raise type(first)(text, kind=first.refusal.kind, where=first.refusal.where) from first
    if problems:
        raise problems[0]
    return results


def _smallest_ring(meridian: Meridian, request: _Request) -> int | None:
    """Return the least distance of a ring from the axis, in whole mm, at which all parts can be made, or None."""

    def works(ring: int) -> bool:
        try:
            request.made(meridian.to_ring(ring))
        except InputError:
            return False
        return True

    start, end = meridian.ring
    # 60 sizes in all; then every whole mm below the first size that works
    tried = np.unique(np.ceil(np.geomspace(end, start, 60)[1:-1]).astype(int))
    tried = tried[(tried > end) & (tried < start)]
    first = next((i for i, ring in enumerate(tried.tolist()) if works(ring)), None)
    if first is None:
        return None
    before = int(tried[first - 1]) if first else int(end)
    return next(ring for ring in range(before + 1, int(tried[first]) + 1) if ring > end and works(ring))
