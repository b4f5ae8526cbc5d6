"""Check whether a curve is realizable, with the reasons in words, and whether other fits of its measured points
give the same result.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError, Length, Listed, NotConvergedError, note
from elastica_cad.geometry.fairing import largest_distance, smooth_through
from elastica_cad.geometry.measured_points import MeasuredPoints
from elastica_cad.geometry.nurbs_curve import curvature_slope
from elastica_cad.geometry.plane_curve import CurvatureZero, PlaneCurve, line_crossings
from elastica_cad.geometry.plane_points import is_closed, norm, thinned, unit
from elastica_cad.geometry.self_intersections import find_view_angles
from elastica_cad.geometry.splines import fit_spline, smoothest_spline
from elastica_cad.mechanics.loads import (
    ExcessCurvature,
    NaturalCurvature,
    RestCurvature,
    Supports,
)
from elastica_cad.mechanics.theorem1 import (
    AT_END_SHARE,
    EquilibriumCheck,
    FittedVerdict,
    InflectionLine,
    Undecided,
    examine_curvature,
    lengths,
    refused,
)
from elastica_cad.mechanics.unbent_ends import (
    MEANT_SHARE,
    almost_unbent,
    find_free_tails,
    straightened,
    without_bend_at,
)

if TYPE_CHECKING:
    from elastica_cad.geometry.control_point_constraints import Constraint

MOST_POINTS = 400
"""Largest number of measured points in a fit that is compared with the drawn curve; others are left out."""

MOST_ON_LINE = 2
"""Largest number of inflections that are always on a common line."""

ADDED_INFLECTIONS = 2
"""Number of inflections that one oscillation adds to a fitted curve."""


def _compare_fits(
    check: EquilibriumCheck, drawn: PlaneCurve, judge: Callable[[PlaneCurve], EquilibriumCheck]
) -> Undecided | None:
    """Return an undecided verdict if another fit of the measured points contradicts the check, or None."""
    points = None if drawn.provenance is None else drawn.provenance.measured
    if (
        points is None or check.any_stiffness or (points.is_noisy and points.outlier)
    ):  # an outlier must be corrected first, because it would decide the comparison of the fits
        return None
    distance = largest_distance(points.points, drawn)
    for curve in _other_curves(points, distance):
        with suppress(ElasticaError):
            other = judge(curve)
            if other.realizable != check.realizable or _has_loose_inflections(check, other, points):
                fits = ((check, distance), (other, largest_distance(points.points, curve)))
                return Undecided(points.resolution, *(
                    FittedVerdict(verdict.realizable, off, len(verdict.inflections)) for verdict, off in fits
                ))  # fmt: skip
    return None


def _has_loose_inflections(check: EquilibriumCheck, other: EquilibriumCheck, points: MeasuredPoints) -> bool:
    """Return True if a curve is refused only for inflections that its measured points do not require."""
    count, required = len(check.off_line), points.bend_changes
    if check.realizable or check.bent_beforehand or len(other.inflections) >= count:
        return False
    return required <= MOST_ON_LINE < count and required + ADDED_INFLECTIONS <= count


def _other_curves(points: MeasuredPoints, distance: float) -> Iterator[PlaneCurve]:
    """Yield two fits within the resolution of the points, a fit of every other point, and a smoother fit.

    For a closed outline, only the last two are made.
    """
    step = -(-len(points.points) // MOST_POINTS)
    some, half = thinned(points.points, step), thinned(points.points, 2 * step)
    loose = max(distance, points.resolution)
    if is_closed(points.points):
        yield from (smooth_through(near, loose, loose) for near in (some, half) if is_closed(near))
        return
    for degree in (3, 5):
        with suppress(ElasticaError):
            yield PlaneCurve(*fit_spline(some, degree, points.resolution), degree)
    smoother = max(points.reach, loose)
    with suppress(ElasticaError):
        coarse = PlaneCurve(*fit_spline(half, 4, loose), 4)
        smoother = max(smoother, largest_distance(points.points, coarse) / 2)
        yield coarse
    with suppress(ElasticaError):
        yield PlaneCurve(*smoothest_spline(some, 4, smoother), 4)


def examine(
    curve: PlaneCurve,
    supports: Supports,
    natural_curvature: NaturalCurvature = 0.0,
    tolerance: float = 1e-4,
    *,
    heavy: bool = False,
    stations: Sequence[float] = (),
) -> EquilibriumCheck:
    """Check the conditions of Theorem 1: curvature, ends without bending, and a line through the inflections.

    A strip with weight (`heavy`) needs no line (paper, section 5). A curve that was fitted to points is compared
    with other fits. If their results differ, the result is `undecided`. `stations` are the arc lengths, mm, of
    rails, pins, ties and forces on a strip without weight. Between a free end and the station nearest to this end,
    the strip carries no moment and must be straight.
    """

    def judge(fit: PlaneCurve) -> EquilibriumCheck:
        # tails exist only beside rails, pins, ties or forces, so no line is needed, and only without pre-bending
        tails = find_free_tails(fit, supports, natural_curvature, stations)
        if tails:
            straight, moved, reasons = straightened(fit, tails, tolerance * fit.length)
            check = examine_curvature(straight, supports, tails=[tail.end for tail in tails])
            check = replace(check, moved=moved)
            # the reasons about tails replace those of the straightened curve, which the user has not drawn
            return replace(check, realizable=False, reasons=reasons) if reasons else check
        check = examine_curvature(fit, supports, natural_curvature)
        check = _with_unbent_ends(check, supports, natural_curvature, tolerance)
        if heavy or check.any_stiffness or not check.zeros:
            return check
        return _check_line(check, supports, natural_curvature, tolerance)

    check = judge(curve)
    undecided = _compare_fits(check, curve, judge)
    return check if undecided is None else replace(check, undecided=undecided)


# an end is unbent if its curvature is below this fraction of the largest curvature
UNBENT_SHARE = 1e-12


def _with_unbent_ends(
    check: EquilibriumCheck, supports: Supports, natural_curvature: NaturalCurvature, tolerance: float
) -> EquilibriumCheck:
    """Make almost unbent ends exactly unbent, with the same positions and tangents, and check the curve again.

    Keep the original curve if the new curve differs from it by more than `tolerance` times the length, or has new
    inflections near its ends.
    """
    if check.curve.is_closed or check.any_stiffness:
        return check
    excess = ExcessCurvature(check.curve, natural_curvature)
    ends = _ends_with_small_curvature(excess, check)
    for t, support in zip(check.curve.domain, supports.ends, strict=True):
        # a bent end that is free to turn, but is meant to be unbent: a zero or a small curvature is near it
        bent = t not in {z.t for z in check.zeros if z.kind == "end"}
        if bent and not support.angle and almost_unbent(excess, np.array(t), check.length):
            ends.append(t)
    if not ends:
        return check
    try:
        unbent = without_bend_at(excess, np.array(ends))
    except NotConvergedError:
        return check
    again = examine_curvature(unbent, supports, natural_curvature)
    moved = largest_move(check.curve, unbent)
    near_zeros = _ends_near_zeros(check) - set(ends)
    new_zeros = _ends_near_zeros(again) - near_zeros
    return check if moved > tolerance * check.length or new_zeros else replace(again, moved=moved)


def _ends_keep_bend(check: EquilibriumCheck, natural_curvature: NaturalCurvature) -> bool:
    return bool(_ends_with_small_curvature(ExcessCurvature(check.curve, natural_curvature), check))


def largest_move(before: PlaneCurve, after: PlaneCurve) -> float:
    """Return the largest distance between points of two curves at the same parameter, mm."""
    t = np.linspace(*before.domain, 1001)
    return float(norm(after.evaluate(t) - before.evaluate(t)).max())


def _ends_with_small_curvature(excess: ExcessCurvature, check: EquilibriumCheck) -> list[float]:
    """Return the parameters of ends that count as unbent, but have a curvature above rounding errors."""
    ends = np.array([z.t for z in check.zeros if z.kind == "end"])
    if not ends.size:
        return []
    least = UNBENT_SHARE * float(np.abs(excess.survey).max())
    bent: list[float] = ends[np.abs(excess.at(ends)) > least].tolist()
    return bent


def _ends_near_zeros(check: EquilibriumCheck) -> set[float]:
    (start, end), near = check.curve.domain, MEANT_SHARE * check.length
    inner = [z.s for z in check.zeros if z.kind != "end"]
    return {start for s in inner if s < near} | {end for s in inner if s > check.length - near}


_WIDEST_RATIO = 1e4
"""Largest stiffness ratio of a realizable curve; above it, the result would depend on rounding errors."""

_TANGENT_RAD = 1e-6
"""Sine of the angle between line and curve below which the line is tangent to the curve."""


@dataclass(frozen=True)
class SeparatingLine:
    """Lines through the only inflection of a curve that meet the curve at no other point.

    Attributes
    ----------
    line : InflectionLine or None
        Line in the middle of the admissible directions, or None if no line exists.
    spread : float
        Angle, rad, that the curve spans as seen from the inflection, after the part before the inflection is
        mirrored at the inflection. A line exists if the angle is less than pi.
    places : (float, float)
        Arc lengths, mm, of the two points of the curve that limit the admissible directions.
    """

    line: InflectionLine | None
    spread: float
    places: tuple[float, float]


def _check_line(
    check: EquilibriumCheck, supports: Supports, natural_curvature: NaturalCurvature, tolerance: float
) -> EquilibriumCheck:
    """Return the check with the line on which the moment is 0, or a refused check if there is no such line."""
    force_x, force_y = supports.transmits_force
    if not (force_x or force_y):
        reason = note(
            "With these supports the curve must bend to one side only, because the ends cannot push or "
            "pull each other. The curve bends to the other side {places} from its start. Choose supports "
            "that hold both ends along x, or both along y.",
            places=lengths(z.s for z in check.zeros),
        )
        return refused(check, reason)
    # if only one component of the force is possible, the line of zero moment is parallel to this component
    normal = None if force_x and force_y else np.array([1.0, 0.0] if force_y else [0.0, 1.0])
    if len(check.zeros) == 1 and normal is None:
        return _with_one_zero(check, natural_curvature)
    return _with_line(check, normal, supports, natural_curvature, tolerance)


def _with_one_zero(check: EquilibriumCheck, natural_curvature: NaturalCurvature) -> EquilibriumCheck:
    """Return the check with a line that meets the curve only at its inflection, or a refused check."""
    zero = check.zeros[0]
    lines = find_separating_line(check.curve, zero, zero.after or -zero.before)
    checked = replace(check, line=lines.line, off_line=((zero.s, 0.0),))
    if lines.line is not None:
        return _refuse_extreme_ratio(checked, natural_curvature, (np.pi - lines.spread) / 2)
    near = tuple(s for s in lines.places if abs(s - zero.s) > AT_END_SHARE * check.length)
    reason = note(
        "The moment is 0 on a straight line that may meet the curve only at the inflection, {s} from the start. "
        "Every line through the inflection is tangent to the curve there, or meets the curve again (near "
        "{places}). Let the curve turn less, or support the strip between the inflection and these places."
        if near
        else "The curve returns to its inflection ({s} from the start). The moment is 0 there, but the returning "
        "curve is bent. Move the curve away from the inflection.",
        s=Length(zero.s), places=lengths(near),
    )  # fmt: skip
    return refused(replace(checked, crossings=near), reason)


def _with_line(
    check: EquilibriumCheck,
    normal: FloatArray | None,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    tolerance: float,
) -> EquilibriumCheck:
    """Check the line of zero moment through the inflections; `normal` fixes its direction if not None."""
    positions = check.curve.evaluate([z.t for z in check.zeros])
    line = fit_inflection_line(positions, normal)
    distance = line.distance(positions)
    off_line = tuple((z.s, float(d)) for z, d in zip(check.zeros, distance, strict=True))
    check = replace(check, line=line, off_line=off_line)
    largest, allowed = float(np.abs(distance).max()), tolerance * check.length
    if largest > allowed:
        return refused(check, _off_line_reason(check, normal, allowed))
    # move inflections that are off the line by more than rounding errors, and ends that are not exactly unbent
    meant = largest > 1e-10 * check.length or _ends_keep_bend(check, natural_curvature)
    if meant and check.realizable:
        moved = _moved_onto(line, check, supports, natural_curvature)
        if moved is None:
            return refused(check, _off_line_reason(check, normal, 0.0))
        check = moved
    meetings = _line_meetings(check.curve, line, check.zeros)
    if not any(meetings.values()):
        return _refuse_extreme_ratio(check, natural_curvature)
    crossings, touches, tangents = (
        tuple(sorted(meetings[kind])) for kind in ("crossing", "touch", "tangent")
    )
    meetings_of = (
        ("crosses the curve at {places}", crossings),
        ("touches the curve at {places}", touches),
        ("is tangent to the curve at its inflection at {places}", tangents),
    )
    reason = note(
        "{line} {meets}. The stiffness would have to be 0 or negative there. Move the curve off the line at "
        "these places, or support the strip between each of these places and the next inflection.",
        line=_names_of(normal)[1],
        meets=Listed(note(text, places=lengths(s)) for text, s in meetings_of if s),
    )  # fmt: skip
    return refused(replace(check, crossings=crossings, touches=(*touches, *tangents)), reason)


def _moved_onto(
    line: InflectionLine, check: EquilibriumCheck, supports: Supports, natural_curvature: NaturalCurvature
) -> EquilibriumCheck | None:
    """Return the check of the curve with its inflections moved onto `line`, or None if they cannot be moved."""
    # moving control points would open a closed curve
    if isinstance(natural_curvature, RestCurvature) or check.curve.is_closed:
        return None

    moved_check = check
    for _ in range(2):  # repeat if the first move brought an inflection to an end
        try:
            moved = project_inflections(moved_check.curve, moved_check.zeros, line, natural_curvature)
        except NotConvergedError:
            return None
        moved_check = examine_curvature(moved, supports, natural_curvature)
        if not _ends_keep_bend(moved_check, natural_curvature):
            break
    move = check.moved + largest_move(check.curve, moved_check.curve)
    return replace(moved_check, line=line, off_line=check.off_line, moved=move)


def _refuse_extreme_ratio(
    check: EquilibriumCheck, natural_curvature: NaturalCurvature, spare: float = 0.0
) -> EquilibriumCheck:
    """Return the check, refused if the stiffness ratio exceeds `_WIDEST_RATIO`.

    A line through a single inflection may turn by `spare` rad in both directions.
    """
    if check.line is None or not check.realizable:
        return check
    at = _place_of_extreme_ratio(
        ExcessCurvature(check.curve, natural_curvature), check.line, check.zeros, spare
    )
    if at is None:
        return check
    reason = note(
        "A strip can hardly take the curve: {s} from its start it would have to be more than {ratio:.0f} times as "
        "stiff as at other places. Move the curve away from the line through its inflections, or bend it "
        "more there.",
        s=Length(round(at, 6)), ratio=_WIDEST_RATIO,
    )  # fmt: skip
    return refused(check, reason)


def _off_line_reason(check: EquilibriumCheck, normal: FloatArray | None, allowed: float) -> str:
    small = (
        note(" (distances up to {allowed:.2g} are corrected automatically)", allowed=Length(allowed))
        if allowed
        else ""
    )
    return note(
        "The inflections are not on {one_line}: the inflections {places} from the start are {off} away "
        "from the nearest line{small}. Move them onto one line, or support the strip between them.",
        one_line=_names_of(normal)[0], places=lengths(s for s, _ in check.off_line),
        off=Listed(Length(abs(d)) for _, d in check.off_line), small=small,
    )  # fmt: skip


def fit_inflection_line(points: FloatArray, normal: FloatArray | None = None) -> InflectionLine:
    """Return the least-squares line through points (k, 2), perpendicular to `normal` if a normal is given."""
    centre = points.mean(axis=0)
    if normal is None:
        _, _, vt = np.linalg.svd(points - centre)
        normal = vt[1]
    normal = unit(normal)
    if normal[1] < 0 or (normal[1] == 0 and normal[0] > 0):
        normal = -normal
    return InflectionLine((float(centre[0]), float(centre[1])), (float(normal[1]), -float(normal[0])))


def _line_meetings(
    curve: PlaneCurve, line: InflectionLine, zeros: Sequence[CurvatureZero]
) -> dict[str, set[float]]:
    """Return the arc lengths, mm, at which the line violates condition (1) of Theorem 1, by kind of meeting.

    The moment is zero on the line. Moment and curvature must have equal signs on the whole curve, or opposite
    signs on the whole curve.

    The kinds are "crossing" (the signs differ beyond this place), "touch" (the line meets the curve away from an
    inflection without crossing it, or along a piece) and "tangent" (at an inflection).
    """
    # points that are closer together are the same inflection
    near = 1e-6 * curve.length
    bad = dict[str, set[float]](crossing=set(), touch=set(), tangent=set())
    tangent = curve.evaluate([z.t for z in zeros], 1).reshape(-1, 2)
    sine = tangent @ line.b / norm(tangent)
    # positive if distance from the line and curvature have equal signs after the zero; at the end of the curve, the
    # sign after the zero is the opposite of the sign before
    turned = np.array([(z.after or -z.before) for z in zeros]) * sine
    majority = 1.0 if (turned > 0).sum() * 2 >= turned.size else -1.0
    for zero, rate, turn in zip(zeros, sine, turned, strict=True):
        if abs(rate) < _TANGENT_RAD:
            bad["tangent"].add(zero.s)
        elif turn * majority < 0:
            # the signs agree after most zeros but differ after this zero, or vice versa
            bad["crossing"].add(zero.s)
    places = np.array([z.s for z in zeros])
    # the line may meet the curve only at the zeros
    for meeting in line_crossings(curve, line.a, line.b):
        if meeting.kind == "flat":
            bad["touch"].add(meeting.s)
        elif not places.size or np.abs(places - meeting.s).min() > near:
            bad["touch" if meeting.kind == "touch" else "crossing"].add(meeting.s)
    return bad


def _place_of_extreme_ratio(
    excess: ExcessCurvature, line: InflectionLine, zeros: Sequence[CurvatureZero], spare: float
) -> float | None:
    """Return the arc length, mm, at which the stiffness ratio would exceed `_WIDEST_RATIO`, or None.

    The stiffness is the distance from the line divided by the excess curvature (curvature minus natural curvature).
    At a zero of the excess curvature, the limit is the sine of the angle between curve and line, divided by the
    slope of the excess curvature. A line through a single zero may turn by `spare` rad in both directions.
    """
    curve, kappa = excess.curve, excess.survey
    nodes = curve.survey
    s_zero, t_zero = np.array([z.s for z in zeros]), np.array([z.t for z in zeros])
    # around a zero of the curvature, the stiffness 0 / 0 is replaced by its limit
    clear = (np.abs(nodes.s - s_zero[:, None]) > 1e-4 * curve.length).all(axis=0)
    clear &= kappa != 0
    _, d1, d2, d3 = curve.derivatives(t_zero, 3)
    tangent = unit(d1)
    slope = curvature_slope(d1, d2, d3) - excess.rest_at(t_zero, 1, left=bool(t_zero[-1] >= curve.domain[1]))
    point, across = line.point, line.b
    bent = np.abs(((nodes.position - point) @ across)[clear] / kappa[clear])
    unbent = np.abs(tangent @ across / slope)
    if max(bent.max(), unbent.max()) <= _WIDEST_RATIO * min(bent.min(), unbent.min()):
        return None
    s = np.concatenate([nodes.s[clear], s_zero])
    arm = np.concatenate([(nodes.position[clear] - point) / kappa[clear, None], tangent / slope[:, None]])
    along = line.direction
    turns = np.linspace(-spare, spare, 67)[1:-1]
    normals = np.cos(turns)[:, None] * across + np.sin(turns)[:, None] * along
    # stiffness at each place (rows) for each line through the zero (columns)
    K = np.abs(arm @ normals.T)
    ratios = K.max(axis=0) / np.maximum(K.min(axis=0), 1e-300)
    best = int(np.argmin(ratios))
    return float(s[K[:, best].argmax()]) if ratios[best] > _WIDEST_RATIO else None


def find_separating_line(curve: PlaneCurve, zero: CurvatureZero, curvature_sign: int) -> SeparatingLine:
    """Return lines through the only inflection of a curve such that moment and bending have the same sign.

    The inflection p is the only zero of kappa - kappa_0, the curvature minus the natural curvature. The moment
    M = <b, gamma - p> must have the sign of kappa - kappa_0 on the whole curve gamma. A vector b exists if and
    only if the angle of sign(kappa - kappa_0) (gamma - p) spans less than pi along the curve.

    Parameters
    ----------
    curvature_sign : int
        Sign of kappa - kappa_0 after the zero. At the end of the curve, the opposite of the sign before the zero.
    """
    views = find_view_angles(curve, zero.t)
    if views is None:
        return SeparatingLine(None, np.pi, (zero.s, zero.s))
    low, high = np.sort(curve.arc_length(np.array([views.low_t, views.high_t]))).tolist()
    spread = views.high - views.low
    if spread >= np.pi - _TANGENT_RAD:
        return SeparatingLine(None, spread, (low, high))
    middle = (views.low + views.high) / 2
    # the line is perpendicular to the middle of the directions from the inflection to the curve
    x, y = (curvature_sign * np.array([np.sin(middle), -np.cos(middle)])).tolist()
    return SeparatingLine(InflectionLine(views.point, (x, y)), spread, (low, high))


def _names_of(normal: FloatArray | None) -> tuple[str, str]:
    """Return two names of the line through the inflections, within a sentence and at its start."""
    if normal is None:
        return note("one line"), note("The line through its inflections")
    if normal[0]:
        return note("one vertical line"), note("The vertical line that the supports require")
    return note("one horizontal line"), note("The horizontal line that the supports require")


MOST_STEPS = 12
"""Largest number of Newton steps that move inflections onto a line."""


def project_inflections(
    curve: PlaneCurve,
    zeros: Sequence[CurvatureZero],
    line: InflectionLine,
    natural_curvature: float = 0.0,
) -> PlaneCurve:
    """Return the curve with control points moved so that all `zeros` of its excess curvature are on a line.

    The excess curvature is the curvature minus the `natural_curvature`. End points and end tangents do not change
    if the curve has enough control points. A zero at an end remains at the end. Tangents remain continuous at
    joints between the pieces of a path.

    Raises
    ------
    NotConvergedError
        No move of the control points brings the inflections onto the line.

    References
    ----------
    Paper, Appendix C.
    """
    # few curves need these constraints, and their module is not loaded for the others
    from elastica_cad.geometry.control_point_constraints import (
        CurvatureAt,
        EndPositions,
        EndTangents,
        InflectionsOnLine,
        PointsOnLine,
        SmoothJoints,
        least_norm_newton,
    )

    inner = np.array([z.t for z in zeros if z.kind != "end"])
    ends = np.array([z.t for z in zeros if z.kind == "end"])
    needed: list[Constraint] = (
        [InflectionsOnLine(line.a, line.b, inner, natural_curvature)] if inner.size else []
    )
    if ends.size:
        needed += [PointsOnLine(line.a, line.b, ends), CurvatureAt(ends, natural_curvature, curve.length)]
    needed.append(SmoothJoints.of(curve))
    # an end at an inflection is not held
    bent = [t not in ends for t in curve.domain]
    places, turns = EndPositions.of(curve, bent), EndTangents.of(curve, bent)
    # without a solution, give up the end tangents, then also the end positions
    for held in ((places, turns), (places,), ()):
        try:
            moved, _ = least_norm_newton(curve, [*needed, *held], tolerance=1e-12, max_steps=MOST_STEPS)
        except NotConvergedError:
            continue
        # a larger move would change the curve visibly
        if np.abs(moved.control_points - curve.control_points).max() <= 0.05 * curve.length:
            return moved.drawn_as(curve.provenance)
    raise NotConvergedError(
        "no small move of the control points brings the inflections onto one line: draw the inflections "
        "closer to a line"
    )
