"""Preparation of a strip for fabrication: joints, plates over the joints, and compensated widths."""

from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of, require_positive, require_record
from elastica_cad.errors import (
    Change,
    FieldName,
    InputError,
    Listed,
    NotConvergedError,
    StrainError,
    note,
    rounded_up,
    sentences,
)
from elastica_cad.errors import Length as Mm
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.path_intersections import clip_across, trim_across
from elastica_cad.geometry.plane_points import left_of, turns_along
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import bezier_spans
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import thinner_for
from elastica_cad.strip.drawing import MARK, Drawing, cut_paths
from elastica_cad.strip.held_shape import LEAST_REPORTED_MM, closes, deviation_from, shape_responses
from elastica_cad.strip.layers import LapPlates, Layer
from elastica_cad.strip.perforation import Perforated
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.slots import Cut, Cuts, Slot, end_numbers, label_off_cuts, mating_marks, slot_cut
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.uncuttable_parts import (
    FabricationLimits,
    accept_faults,
    change_to_nearest,
    find_strip_faults,
)


def _width_basis(s: FloatArray, *, closed: bool) -> FloatArray:
    """Return the values (n, m) of m cubic B-splines at stations s (n,).

    At the joint of a closed strip, the first and last B-splines are combined.
    """
    # wide spacing of the knots keeps outlines smooth
    pieces = 24
    knots = np.pad(np.linspace(0.0, s[-1], pieces + 1), 3, mode="edge")
    shared = np.eye(pieces + 3)
    if closed:
        shared[0, -1] = 1.0
        shared = shared[:, 1:]
    return bezier_spans(knots, 3).basis(s) @ shared


def _correct_widths(
    rod: Rod, drift: FloatArray, basis: FloatArray, correction: FloatArray, *, largest: float
) -> FloatArray:
    """Return coefficients (m,) of the correction of the width that removes a deviation to first order.

    While the shape is fixed, a relative change f of the width changes moments and weights by the fraction f. Some
    changes do not affect the shape, because the reactions of the supports balance them. The solution is therefore
    not unique, and the smallest and smoothest correction is chosen.

    Parameters
    ----------
    rod : Rod
        Rod of the finished strip, in equilibrium in its holders.
    drift : (n, 2) array
        Displacements of the nodes from the design, mm. For a closed strip, rigid motions are ignored.
    basis : (n, m) array
        Values of the basis functions at the nodes: see `_width_basis`.
    correction : (m,) array
        Coefficients of the present correction.
    largest : float
        Largest magnitude of a coefficient.
    """
    moved = shape_responses(rod, rod.moment[:, None] * basis, rod.nodal_load[:, None, :] * basis[:, :, None])
    A, residual = np.moveaxis(moved[1:], 1, 2).reshape(-1, basis.shape[1]), drift[1:].ravel()
    if closes(rod):
        A, residual = (_without_rigid_motion(rod.position[1:], moves) for moves in (A, residual))
    scale = float(np.abs(A).max()) * np.sqrt(len(A))
    identity = np.eye(basis.shape[1])
    # weights of the roughness and of the size of a correction, relative to the deviation
    whole = scale * np.concatenate([5e-3 * np.diff(identity, n=2, axis=0), 7e-3 * identity])
    system, right_side = np.concatenate([A, whole]), np.concatenate([-residual, -whole @ correction])
    from scipy.optimize import lsq_linear

    room = -largest - correction, largest - correction
    return np.asarray(correction + lsq_linear(system, right_side, room, method="bvls").x)


def _without_rigid_motion(position: FloatArray, moves: FloatArray) -> FloatArray:
    """Return displacements (2 n, ...) of points (n, 2) minus the rigid motion that fits them best."""
    count = len(position)
    turned = left_of(position - position.mean(axis=0))
    rigid = np.array([np.tile([1.0, 0.0], count), np.tile([0.0, 1.0], count), turned.ravel()])
    rigid /= np.linalg.norm(rigid, axis=1)[:, None]
    return moves - rigid.T @ (rigid @ moves)


def compensate_widths(strip: Strip, *, largest: float = np.inf) -> Strip:
    """Return the strip with widths that compensate its deviation from the design.

    A finished strip in its holders deviates from its design (`Strip.held`), for example because of its slots.
    Smooth corrections of the widths are computed to first order, and are repeated while the deviation decreases.
    The search begins at the correction that the strip has.
    The remaining deviation is `Strip.held().deviation`.

    Parameters
    ----------
    strip : Strip
    largest : float
        Largest magnitude of the logarithm of the factor on the width. Only ratios of widths matter, so
        instead of widening one part, the rest may become narrower.

    Returns
    -------
    Strip
        Strip with the same rod and another `correction`, or without correction if none reduces the deviation.

    Examples
    --------
    >>> from elastica_cad.strip.outline import Tab
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> tabs = (Tab(10, width=10), Tab(10, width=10))
    >>> strip = make_strip(arch, "birch-plywood-0.8", max_width=30, ends=tabs)
    >>> better = compensate_widths(strip)
    >>> bool(better.held_deviation < strip.held_deviation / 5)
    True
    """
    require_record(strip, Strip, "what is compensated", "a Strip")
    if not is_one_of(largest, [np.inf]):
        require_positive(largest, "the largest change of width", "shares of it")
    before = strip.correction
    strip = strip if before is None else replace(strip, correction=None)
    design = strip.as_made.design
    basis = _width_basis(design.s, closed=strip.is_closed)
    # first guess: the correction of before, or the inverse of the loss of stiffness, smoothed along the strip
    factors = (
        1 / np.prod([np.ones(design.s.size), *strip.as_made.factors.values()], axis=0)
        if before is None else before(design.s)
    )  # fmt: skip
    wider = np.log(factors)
    # largest |log(factor on the width)|
    clip = min(0.5, largest)
    guess = np.linalg.lstsq(basis, wider - wider.mean(), rcond=None)[0].clip(-clip, clip)
    drawn, guessed = (_correct(strip, basis, start) for start in (np.zeros(basis.shape[1]), guess))
    best = min(filter(None, (drawn, guessed)), key=lambda candidate: candidate.deviation, default=None)
    if best is None:
        return strip
    step = 1.0
    for _ in range(8):
        if best.deviation <= 1e-5 * design.length:
            break
        drift = best.rod.position - design.position
        # `target` would remove the deviation to first order; `step` is the fraction of this change that is tried
        target = _correct_widths(best.rod, drift, basis, best.coefficients, largest=largest)
        trial = _correct(strip, basis, best.coefficients + step * (target - best.coefficients))
        if trial is None or trial.deviation >= best.deviation:
            step /= 2
            continue
        gain, best, step = trial.deviation / best.deviation, trial, min(1.0, 2 * step)
        # the iteration left more than this fraction of the deviation
        if gain > 0.97:
            break
    gained = np.inf if drawn is None else drawn.deviation - best.deviation
    return best.strip if gained >= LEAST_REPORTED_MM else strip


class _CorrectedStrip(NamedTuple):
    """Strip with widths corrected by `coefficients`, its rest shape, and its deviation from the design, mm."""

    strip: Strip
    coefficients: FloatArray
    rod: Rod
    deviation: float


def _correct(strip: Strip, basis: FloatArray, coefficients: FloatArray) -> _CorrectedStrip | None:
    """Return the strip with widths multiplied by exp(basis @ coefficients), or None if it has no rest shape."""
    design, change = strip.as_made.design, basis @ coefficients
    try:
        if change.any():
            strip = replace(strip, correction=Profile.interpolate(design.s, np.exp(change)))
        rod = strip.as_made.rest()
    except (InputError, NotConvergedError):
        return None
    return _CorrectedStrip(strip, coefficients, rod, deviation_from(design, rod.position))


JOINT_STATIONS = 400  # number of positions at which a joint may be


@dataclass(frozen=True, eq=False)
class Splice:
    """A strip cut into pieces, with a plate of the same sheet glued over each joint on one side.

    Plates are solid and as wide as the strip, and no holes are cut under them. The two layers of a laminate
    have their joints at different places, and plates on their outer faces.

    Attributes
    ----------
    strip : Strip
    plates : LapPlates
        Plates that join the pieces.
    ends : (str, str)
        Texts engraved at the start and the end of the base; empty strings for no text.
    """

    strip: Strip
    plates: LapPlates
    ends: tuple[str, str] = ("", "")

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Pieces of every layer, followed by the plates that are glued over the joints of the layer.

        Marks on the pieces show where the plates end.
        """
        return tuple(piece for layer in self.layer_pieces.values() for piece in layer)

    @cached_property
    def layer_pieces(self) -> dict[str, tuple[Piece, ...]]:
        """Pieces and plates by the name of their layer, the base layer first."""
        strip, layout = self.strip, self.strip.layout
        name, base = strip.label or "strip", strip.layers[0]
        marks = [drawing.on(MARK) for drawing in strip.drawings()]
        cut = replace(base, holes=self._holes)
        whole = [_Whole(name, cut, strip.width, marks[0], self.plates.joints, strip.slots, self.ends)]
        if layout.backing is not None:
            glued = strip.layers[1]
            whole.append(
                _Whole(f"{name}-backing", glued, layout.backing.width, marks[1], self.plates.backing_joints)
            )
        return {layer.name: self._cut(layer) for layer in whole}

    @cached_property
    def drawings(self) -> tuple[Drawing, ...]:
        """Drawings of the layers, with the pieces and plates of each layer one above the other."""
        drawn = []
        for name, pieces in self.layer_pieces.items():
            placed, y = [], 0.0
            for piece in pieces:
                (x0, y0), (_, y1) = piece.bounds
                placed.append(piece.drawing.transformed([[1, 0, -x0], [0, 1, y - y0], [0, 0, 1]]))
                y += float(y1 - y0) + 5.0  # mm
            drawn.append(Drawing.merged(name, placed))
        return tuple(drawn)

    @cached_property
    def deviation(self) -> float:
        """Deviation of the bent strip due to the stiffness of the plates, mm.

        If the widths compensate the plates, this is the remaining deviation.
        """
        held = replace(self.strip, plates=self.plates).held()
        return held.deviation if held.corrected else held.parts["plates"]

    def __str__(self) -> str:
        if len(self.strip.layers) > 1:
            joints = zip(self.layer_pieces, (self.plates.joints, self.plates.backing_joints), strict=True)
            pieces = Listed(
                note("{pieces}, joined {places} from the start", pieces=name, places=Listed(map(Mm, at)))
                for name, at in joints
                if at
            )
            return note(
                "Cut in pieces: {pieces}. The plates that join the pieces are {lap:g} long, on the free "
                "face of each layer; they stiffen the strip and move its shape by {far:.2g}.",
                pieces=pieces, lap=Mm(self.plates.lap), far=Mm(self.deviation), severity="warning",
            )  # fmt: skip
        lost = len(self.strip.holes) - len(self._holes)
        return note(
            "Cut in {count} pieces, joined {places} from the start by plates {lap:g} long. The plates stiffen "
            "the strip and move its shape by {far:.2g}. Number of holes that are omitted under the plates: {lost}."
            if lost
            else "Cut in {count} pieces, joined {places} from the start by plates {lap:g} long. The plates "
            "stiffen the strip and move its shape by {far:.2g}.",
            count=len(self.plates.joints) + 1,
            places=Listed(map(Mm, self.plates.joints)),
            lap=Mm(self.plates.lap),
            lost=lost,
            far=Mm(self.deviation),
            severity="warning",
        )

    @cached_property
    def _holes(self) -> tuple[Path, ...]:
        return self.plates.clear_holes(self.strip.holes)

    def _cut(self, whole: "_Whole") -> tuple[Piece, ...]:
        first, last = whole.layer.outline.bounds[:, 0].tolist()
        ends, half = [first, *whole.joints, last], self.plates.lap / 2
        pieces = [
            self._piece(whole, f"{whole.name}-{k}", low, high)
            for k, (low, high) in enumerate(pairwise(ends), start=1)
        ]
        plates = [
            self._piece(whole, f"{whole.name}-lap-{k}", at - half, at + half, plate=True)
            for k, at in enumerate(whole.joints, start=1)
        ]
        return (*pieces, *plates)

    def _piece(self, whole: "_Whole", name: str, low: float, high: float, *, plate: bool = False) -> Piece:
        """Return the piece, or the plate over a joint, between the arc lengths `low` and `high`, mm."""
        layer = whole.layer
        outline = clip_across(layer.outline, low, high)
        marks: list[Path] = []
        holes: list[Path] = []
        slots: list[tuple[Slot, Cut]] = []
        if not plate:
            edges = [at + side * self.plates.lap / 2 for at in whole.joints for side in (-1, 1)]
            marks = [_tick(whole, x) for x in edges if low < x < high]
            marks += [part for mark in whole.marks for part in trim_across(mark, low, high)]
            holes = [hole for hole in layer.holes if low < hole.bounds.mean(axis=0)[0] < high]
            pairs = zip(whole.slots, layer.slots, strict=True)
            slots = [(slot, rim) for slot, rim in pairs if low < slot.at < high]
        span = max(low, 0.0), min(high, self.strip.rod.length)
        if isinstance(self.strip.style, Perforated) and not plate:  # there are no holes under the plates
            half = self.plates.lap / 2
            span = (low, low + half) if low in whole.joints else (high - half, high)
        cuts = Cuts(holes, marks, rim=Cut(outline, "outside"))
        called = self.strip.label or "strip"
        labelled = self.strip.labelled(called)
        text = f"{labelled.engraved}{name.removeprefix(called)}"
        label = label_off_cuts(text.lstrip("-"), whole.width, cuts, span)
        ends = [_tick(whole, x) for x in (low, high) if 0.0 < x < self.strip.rod.length]
        mates = mating_marks(slots, whole.width, holes, (*marks, *ends), label)
        known = whole.ends[0] if low <= 0.0 else "", whole.ends[1] if high >= self.strip.rod.length else ""
        numbers = end_numbers(whole.width, cuts, (*label, *mates), known)
        paths = cut_paths(outline, holes, marks)
        number = text if labelled.number else ""
        return Piece(name, Drawing(name, paths, (*label, *mates, *numbers)), layer.sheet, number=number)


@dataclass(frozen=True, eq=False)
class _Whole:
    """A layer before it is cut into pieces.

    `joints` are arc lengths, mm, and `ends` are the texts engraved at both ends.
    """

    name: str
    layer: Layer
    width: Profile
    marks: tuple[Path, ...]
    joints: tuple[float, ...]
    slots: tuple[Slot, ...] = ()
    ends: tuple[str, str] = ("", "")


def _tick(whole: _Whole, x: float) -> Path:
    # return a mark across the layer at arc length x, mm, which ends before the edges
    half = 0.4 * float(whole.width(x))
    return Path.polyline([(x, -half), (x, half)])


def splice(strip: Strip, stock: float, lap: float, *, backing_stock: float | None = None) -> Splice:
    """Divide a strip into as few pieces as the stock allows, joined where plates change the shape least.

    Joints are clear of slots, tabs and other joints, including joints of the other layer. Among the possible
    positions, dynamic programming selects those with the least sum of squared bend angles under the plates.

    Parameters
    ----------
    strip : Strip
    stock : float
        Length of the longest piece, mm.
    lap : float
        Length of the plates, mm.
    backing_stock : float, optional
        Length of the longest piece of a laminate's backing, mm; by default `stock`.

    Examples
    --------
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> from elastica_cad.mechanics.rod import Rod
    >>> long = Strip(Rod.straight(1000), Sheet.named("birch-plywood-3"), max_width=40, label="A")
    >>> [piece.name for piece in splice(long, 600, 60).pieces]
    ['A-1', 'A-2', 'A-lap-1']
    """
    where = {"strip": strip.label}
    if strip.layout.size is not None:
        raise InputError(
            "a strip of varying thickness or diameter cannot be cut in pieces, because the plates that join "
            "the pieces would have to taper too. Use a larger stock, or a strip of constant thickness",
            where=where,
        )
    longest = (stock, backing_stock or stock)[: len(strip.layers)]
    if not (np.isfinite(lap) and 0 < lap < min(longest) / 3):
        raise InputError(
            "plates {lap:g} long (lap) cannot join pieces {longest:g} long. Set a lap above 0 and below a "
            "third of the length of the pieces",
            where=where,
            lap=Mm(lap),
            longest=Mm(min(longest)),
        )
    s = np.linspace(lap / 2, strip.rod.length - lap / 2, JOINT_STATIONS)
    clear = np.ones(JOINT_STATIONS, dtype=bool)
    for slot in strip.slots:
        low, high = slot_cut(slot, strip.width, beyond=slot.width).bounds[:, 0]
        clear &= np.abs(s - (low + high) / 2) > (lap + high - low + slot.width) / 2
    rod = strip.rod
    turned = turns_along(rod.angle)
    turn = np.interp(s + lap / 2, rod.s, turned) - np.interp(s - lap / 2, rod.s, turned)
    places: list[tuple[float, ...]] = []
    for layer, most in zip(strip.layers, longest, strict=True):
        # plates of two layers must not overlap
        for taken in (at for joints in places for at in joints):
            clear &= np.abs(s - taken) >= lap
        first, last = layer.outline.bounds[:, 0].tolist()
        count = int(np.ceil((last - first) / most * (1 - 1e-12))) - 1
        joints = _cheapest_joints(s, np.where(clear, turn**2, np.inf), count, first, last, most, lap)
        if joints is None:
            raise InputError(
                "the pieces of the strip need {count} joints, each {lap:g} long, which do not fit between "
                "the slots: set a shorter lap, or a larger stock",
                where=where,
                count=count,
                lap=Mm(lap),
            )
        places.append(joints)
    return Splice(strip, LapPlates(places[0], lap, places[1] if len(places) > 1 else ()), strip.joints)


def spliced(strip: Strip, shop: FabricationLimits) -> Splice | None:
    """Return the strip cut into pieces, or None if it fits the stock or `shop.lap` is None."""
    if shop.lap is None:
        return None
    stocks = [shop.stock_for(layer.sheet)[0] for layer in strip.layers]
    layers = zip(strip.layers, stocks, strict=True)
    if all(np.ptp(layer.outline.bounds[:, 0]) <= stock for layer, stock in layers):
        return None
    return splice(strip, stocks[0], shop.lap, backing_stock=stocks[-1])


def joined_within(strip: Strip, shop: FabricationLimits) -> Strip:
    """Return the strip with plates over its joints, or without plates if the stock is long enough."""
    joined = spliced(strip, shop)
    plates = None if joined is None else joined.plates
    return strip if strip.plates == plates else replace(strip, plates=plates)


def _cheapest_joints(
    s: FloatArray, cost: FloatArray, count: int, first: float, last: float, stock: float, lap: float
) -> tuple[float, ...] | None:
    """Return the arc lengths of the joints with the least sum of costs, or None if `count` joints do not fit.

    `cost` is the cost of a joint at each station of `s`. Inner pieces are between twice `lap` and `stock`
    long.
    """
    if count < 1:
        return ()
    # best[k] is the least cost of joints up to one at station k, and `came` has the station of the joint before it
    gap = s[:, None] - s[None, :]
    allowed = (gap <= stock) & (gap >= 2 * lap)
    best = np.where(s - first <= stock, cost, np.inf)
    came: list[FloatArray] = []
    for _ in range(count - 1):
        total = np.where(allowed, best[None, :], np.inf)
        came.append(total.argmin(axis=1))
        best = cost + total.min(axis=1)
    best = np.where(last - s <= stock, best, np.inf)
    at = int(best.argmin())
    if not np.isfinite(best[at]):
        return None
    chosen = [at]
    for back in reversed(came):
        chosen.append(int(back[chosen[-1]]))
    return tuple(float(s[k]) for k in reversed(chosen))


def make_within(
    strip: Strip, shop: FabricationLimits, *, compensate: bool, ignore_limits: bool, noisy: bool
) -> Strip:
    """Return the strip as it is made: joined from pieces if too long, with compensated widths on request.

    For `noisy`, see `find_strip_faults`.

    Raises
    ------
    StrainError
        The strip would break, and `ignore_limits` is False.
    """
    refuse_broken(strip, ignore_limits)
    # if joints do not fit, `spliced` below raises the error, after all other faults
    with suppress(InputError):
        strip = joined_within(strip, shop)
    if compensate:
        strip = compensate_within(strip, shop)
    warnings = accept_faults(find_strip_faults(strip, shop, noisy=noisy), ignore_limits)
    joined = spliced(strip, shop)
    warnings += () if joined is None else (str(joined),)
    return with_warnings(strip, *warnings) if warnings else strip


def with_warnings(strip: Strip, *warnings: str) -> Strip:
    """Return the strip with more warnings."""
    return replace(strip, rod=replace(strip.rod, warnings=(*strip.rod.warnings, *warnings)))


def refuse_broken(strip: Strip, ignore_limits: bool) -> None:
    """Raise StrainError if the strip would break, and `ignore_limits` is False."""
    if not ignore_limits and strip.strain_verdict.refused:
        raise overstrained(strip)


def overstrained(strip: Strip) -> StrainError:
    """Return the error of a strip whose strain exceeds its limit, with changes that may help."""
    judged = strip.strain_verdict
    changes = []
    if not judged.unloaded:
        thinner = thinner_for(strip.sheet, judged.used * strip.strain_limit)
        changes += [] if thinner is None else [Change("thickness", thinner)]
    elif (wider := _width_without_loads(strip)) is not None:
        changes.append(Change("max_width", wider))
    return StrainError(
        "{strains} To make the strip anyway, set {field}.",
        field=FieldName("ignore_limits"),
        strains=sentences(strip.strain_warnings, " "),
        percent=judged.percent,
        other_unit=bool(strip.unit_question),
        where={"at": judged.at},
        changes=[*changes, *change_to_nearest(strip.rod)],
    )


def _width_without_loads(strip: Strip) -> float | None:
    """Return an estimate of `max_width`, mm, with which the strip without its loads keeps to its limit, or None.

    At the place of the largest strain, the loads change the curvature in inverse proportion to the width. The
    estimate assumes that the strip becomes wider by the same amount everywhere. Because this is too little, the
    estimate aims below the limit.
    """
    at, used = strip.strain_verdict.at, strip.strain_verdict.used
    if at is None or strip.unloaded is None or strip.max_width is None or not strip.is_widest:
        return None
    loaded, empty = (float(rod.bend_at(np.array([at]))[0]) for rod in (strip.rod, strip.unloaded))
    loaded, empty = loaded * np.sign(empty), abs(empty)
    limit = empty / used
    if loaded >= limit:
        return None
    # aim at 80 % of the limit
    aim = max(0.8 * limit, (loaded + limit) / 2)
    more = float(strip.width(at)) * (empty - aim) / (aim - loaded)
    # a strip with a very narrow place needs more than the estimate
    return rounded_up(strip.max_width + max(more, 0.2 * strip.max_width), 3)


def compensate_within(strip: Strip, shop: FabricationLimits) -> Strip:
    """Return the strip with compensated widths.

    If the result could not be cut or handled, return the original strip with a warning.
    """
    better = compensate_widths(strip)
    faults = find_strip_faults(better, shop)
    if not faults or find_strip_faults(strip, shop):
        return better
    warning = note(
        "The widths are not corrected for the expected deviation, because the corrected strip could not be "
        "made: {fault}. Make the tabs as wide as the ends of the strip, or the slots shallower.",
        fault=faults[0].what,
        severity="warning",
    )
    return with_warnings(strip, warning)
