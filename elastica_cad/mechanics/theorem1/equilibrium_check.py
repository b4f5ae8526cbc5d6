"""Theorem 1: can a flat strip take the drawn curve, and if not, where and why not."""

from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.curves.curve_records import CurvatureZero
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.arguments import require_curve, require_supports, require_tolerance
from elastica_cad.mechanics.loads.rest_curvature import (
    ExcessCurvature,
    NaturalCurvature,
    RestCurvature,
    require_natural_curvature,
)
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.theorem1.closed_curves import begin_at, flattest_place
from elastica_cad.mechanics.theorem1.inflection_line import (
    WIDEST_RATIO,
    find_separating_line,
    fit_inflection_line,
    line_meetings,
    widest_place,
)
from elastica_cad.mechanics.theorem1.reasons import (
    AT_END_SHARE,
    FAINT_SHARE,
    GENTLE_SHARE,
    PINNED_SHARE,
    shown_on,
    tell_corners,
    tell_jumps,
    tell_pinned_ends,
    tell_seam,
    tell_straight_parts,
    tell_touches,
    warn_of_crossing,
    warn_of_widths,
)
from elastica_cad.mechanics.theorem1.verdict import (
    EquilibriumCheck,
    count,
    figure,
    listed,
    places,
)

SEAM_SHARE = 0.01
"""Of the largest curvature: a closed curve that is bent less where it begins is begun elsewhere."""

_DIP_SHARE = 0.01  # of the largest curvature: deeper dips are looked at closely


def check_equilibrium(
    curve: PlaneCurve,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    *,
    tolerance: float = 1e-4,
) -> EquilibriumCheck:
    """Decide whether a flat strip of some admissible width can rest in this curve, without weight.

    Condition (1): a line meets the curve in the zeros of its curvature, in nothing else, and is tangent in
    none. Condition (2): the curvature changes sign in each of them with a finite slope. A pinned end must
    have no curvature, which puts it on the line too; an end free to slide along x (y) makes the line vertical
    (horizontal); ends that carry no force at all allow no line. A natural curvature is taken off the
    curvature. A closed curve is held by its own other end; where it was drawn to begin in an inflection, it is
    begun elsewhere (`curve`), and a warning says so.

    Parameters
    ----------
    supports : Supports
        Clamped at both ends unless given.
    natural_curvature : float or RestCurvature
        kappa_0, 1/mm, or that of a blank bent beforehand.
    tolerance : float
        Inflections that lie this near to one line, in lengths of the curve, are moved onto it (`moved`,
        `curve`).

    Raises
    ------
    InputError
        A curve with corners, also where it closes.

    References
    ----------
    Paper, Theorem 1 and section 4.3.

    Examples
    --------
    >>> wave = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 0)], degree=3)
    >>> check = check_equilibrium(wave)
    >>> check.realizable, len(check.inflections)
    (True, 1)
    """
    require_tolerance(tolerance)
    supports = require_supports(supports)
    check = examine_curvature(curve, supports, natural_curvature)
    if check.any_stiffness or not check.zeros:
        return check
    force_x, force_y = supports.transmits_force
    if not (force_x or force_y):
        reason = (
            "No force can act between its ends, so the moment is constant and the curve must bend one way "
            f"only; it has {count(check.zeros)}, {places(z.s for z in check.zeros)}: hold both ends in x "
            "or in y."
        )
        return _refused(check, reason)
    normal = None if force_x and force_y else np.array([1.0, 0.0] if force_y else [0.0, 1.0])
    if len(check.zeros) == 1 and normal is None:
        return _with_one_zero(check, natural_curvature)
    return _with_line(check, normal, supports, natural_curvature, tolerance)


def examine_curvature(
    curve: PlaneCurve, supports: Supports, natural_curvature: NaturalCurvature = 0.0
) -> EquilibriumCheck:
    """Everything of `check_equilibrium` but the line: zeros of kappa - kappa_0, jumps, straight pieces,
    kinks.

    With weight there is no line (paper, section 5), but these conditions stay. The same errors are raised.
    """
    require_curve(curve)
    require_natural_curvature(natural_curvature)
    require_bendable(curve)
    excess = ExcessCurvature(curve, natural_curvature)
    largest = _largest(excess)
    excess, begun = _begun_clear(excess, largest)
    curve = excess.curve
    zeros = _zeros_of(excess, supports, largest)
    flats = [z for z in zeros if z.kind == "flat"]
    jumps = tuple(z.s for z in zeros if z.kind == "jump")
    touches = [z.s for z in zeros if z.kind == "touch"]
    points = tuple(z for z in zeros if z.kind in ("crossing", "end"))
    check = EquilibriumCheck(
        realizable=True,
        reasons=(),
        warnings=(),
        length=curve.length,
        curve=curve,
        inflections=tuple((z.s + z.s_end) / 2 for z in zeros if z.changes_sign),
        jumps=jumps,
        flats=tuple((z.s, z.s_end) for z in flats),
        zeros=points,
    )
    if (
        flats
        and flats[0].s <= AT_END_SHARE * curve.length
        and flats[0].s_end >= (1 - AT_END_SHARE) * curve.length
    ):
        return replace(check, any_stiffness=True, warnings=warn_of_crossing(curve), zeros=())
    gentle = [z.s for z in points if _slope(excess, z) <= GENTLE_SHARE * largest / curve.length]
    gentle += _faint_places(excess, largest, zeros)
    reasons = [
        *tell_pinned_ends(excess, supports, points),
        *tell_straight_parts(excess, flats, largest),
        *tell_jumps(jumps),
        *tell_touches(sorted([*touches, *gentle])),
    ]
    return replace(
        check,
        realizable=not reasons,
        reasons=tuple(reasons),
        warnings=(*begun, *warn_of_widths(curve, jumps), *warn_of_crossing(curve)),
        curvature_touches=tuple(sorted([*touches, *gentle])),
    )


def _with_one_zero(check: EquilibriumCheck, natural_curvature: NaturalCurvature) -> EquilibriumCheck:
    """One zero, any direction: is there a line through it that meets the curve nowhere else?"""
    zero = check.zeros[0]
    found = find_separating_line(check.curve, zero, zero.after or -zero.before)
    checked = replace(check, line=found.line, off_line=((zero.s, 0.0),))
    if found.line is not None:
        return _off_the_border(checked, natural_curvature, (np.pi - found.spread) / 2)
    near = tuple(s for s in found.places if abs(s - zero.s) > AT_END_SHARE * check.length)
    reason = (
        f"Every line through the inflection at {zero.s:.4g} mm meets the curve again or touches it there "
        f"(the curve is in the way {places(near, 'near')}): wind the curve less, or support the strip "
        "between."
    )
    return _refused(replace(checked, crossings=near), reason)


def _with_line(
    check: EquilibriumCheck,
    normal: FloatArray | None,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    tolerance: float,
) -> EquilibriumCheck:
    """Two or more zeros, or a line of given direction: there is one line to look at."""
    line = fit_inflection_line(_positions(check), normal)
    distance = line.distance(_positions(check))
    off_line = tuple((z.s, float(d)) for z, d in zip(check.zeros, distance, strict=True))
    check = replace(check, line=line, off_line=off_line)
    largest = float(np.abs(distance).max())
    if largest > tolerance * check.length:
        return _refused(check, _off_line_reason(check, normal, tolerance * check.length))
    if largest > 1e-10 * check.length and check.realizable:
        # what moves inflections would open a closed curve
        if isinstance(natural_curvature, RestCurvature) or check.curve.is_closed:
            return _refused(check, _off_line_reason(check, normal, 0.0))
        try:
            from elastica_cad.mechanics.theorem1.project_inflections import project_inflections

            moved = project_inflections(
                check.curve, check.zeros, normal=normal, natural_curvature=natural_curvature
            )
        except NotConvergedError:
            return _refused(check, _off_line_reason(check, normal, 0.0))
        again = examine_curvature(moved, supports, natural_curvature)
        line = fit_inflection_line(_positions(again), normal)
        check = replace(again, line=line, off_line=off_line, moved=_largest_move(check.curve, moved))
    meetings = line_meetings(check.curve, line, check.zeros)
    if not meetings:
        return _off_the_border(check, natural_curvature)
    crossings = tuple(m.s for m in meetings if m.kind == "crossing")
    tangents = tuple(m.s for m in meetings if m.kind == "tangent")
    touches = tuple(m.s for m in meetings if m.kind == "touch")
    name = (
        "the line through its inflections"
        if normal is None
        else f"the {_kind_of(normal)}line that the supports ask for"
    )
    parts = [
        *([f"crosses the curve {places(crossings)}"] if crossings else []),
        *([f"touches the curve {places(touches)}"] if touches else []),
        *([f"is tangent to the curve in the inflection {places(tangents)}"] if tangents else []),
    ]
    reason = (
        f"{name[0].upper()}{name[1:]} {' and '.join(parts)}, where the moment would vanish or change sign "
        "and the curvature does not: move the curve off the line there, or support the strip between there "
        "and the inflections beside it."
    )
    return _refused(replace(check, crossings=crossings, touches=(*touches, *tangents)), reason)


def _off_the_border(
    check: EquilibriumCheck, natural_curvature: NaturalCurvature, spare: float = 0.0
) -> EquilibriumCheck:
    """The verdict, refused where only a stiffness beyond all strips would do."""
    if check.line is None or not check.realizable:
        return check
    at = widest_place(ExcessCurvature(check.curve, natural_curvature), check.line, check.zeros, spare)
    if at is None:
        return check
    reason = (
        f"The curve is on the border of what a strip can take: near {figure(at)} mm the stiffness would have to be "
        f"more than {WIDEST_RATIO:g} times that of other places. Move the curve farther from the line through its "
        "inflections, or bend it more clearly there."
    )
    return _refused(check, reason)


def _off_line_reason(check: EquilibriumCheck, normal: FloatArray | None, allowed: float) -> str:
    small = f" (at most {allowed:.2g} mm is put right without asking)" if allowed else ""
    return (
        f"Its inflections do not lie on one {_kind_of(normal)}line: those "
        f"{places(s for s, _ in check.off_line)} are {listed(f'{abs(d):.3g}' for _, d in check.off_line)} "
        f"mm off the nearest one{small}. Move them onto one line, or support the strip between them."
    )


def _refused(check: EquilibriumCheck, reason: str) -> EquilibriumCheck:
    return replace(check, realizable=False, reasons=(*check.reasons, reason))


def require_bendable(curve: PlaneCurve) -> None:
    """Refuse what no strip can follow, whatever holds it: a corner, also where a curve closes.

    Raises
    ------
    InputError
        The message says where, and what to do.
    """
    corners = curve.tangent_breaks
    if corners:
        raise InputError(tell_corners(curve, corners))
    if curve.has_corners:
        raise InputError(tell_seam(curve))


def _begun_clear(excess: ExcessCurvature, largest: float) -> tuple[ExcessCurvature, tuple[str, ...]]:
    """The same; of a closed curve that begins where its bending vanishes, begun elsewhere, with a sentence."""
    curve = excess.curve
    if not curve.is_closed or isinstance(excess.rest, RestCurvature):  # which counts from the start
        return excess, ()
    if np.abs(excess.at(np.array(curve.domain))).min() > SEAM_SHARE * largest:
        return excess, ()
    place = flattest_place(curve)
    told = (
        "The curve is closed and begins where it is not bent, so places are counted from "
        f"{shown_on(curve, curve.at(np.array([place])).position[0])}, "
        f"{figure(place)} mm after its start."
    )
    return replace(excess, curve=begin_at(curve, place)), (told,)


def _zeros_of(excess: ExcessCurvature, supports: Supports, largest: float) -> tuple[CurvatureZero, ...]:
    """Zeros of kappa - kappa_0, those next to an end put there; a pinned end may keep a trace."""
    curve = excess.curve
    low, high = curve.domain
    length, near = curve.length, AT_END_SHARE * curve.length
    found: list[CurvatureZero] = []
    ends: dict[bool, CurvatureZero] = {}
    for zero in excess.zeros:
        at_start, at_end = zero.s_end <= near, zero.s >= length - near
        if zero.kind == "flat" or not (at_start or at_end):
            found.append(zero)
        else:
            ends[at_end] = zero
    for is_end, support in enumerate(supports.ends):
        t = high if is_end else low
        kappa = float(excess.at(np.array(t)))
        pinned = not support.angle and abs(kappa) <= PINNED_SHARE * largest
        if bool(is_end) in ends or (pinned and not any(z.t <= t <= z.t_end for z in found)):
            slope = int(np.sign(excess.slope_at(np.array(t))))
            sign = (0, slope) if not is_end else (-slope, 0)
            s = length if is_end else 0.0
            found.append(CurvatureZero(s, t, "end", s, t, *sign))
    return tuple(sorted(found, key=lambda z: z.s))


def _largest(excess: ExcessCurvature) -> float:
    """Largest |kappa - kappa_0|, nearly: the size against which others are small."""
    return float(np.abs(excess.survey).max())


def _faint_places(excess: ExcessCurvature, largest: float, zeros: tuple[CurvatureZero, ...]) -> list[float]:
    """Arc lengths (mm) where |kappa - kappa_0| dips all but to zero, without a zero there."""
    curve, felt = excess.curve, excess.survey
    s = curve.survey.s
    bent = np.abs(felt)
    inside = bent[1:-1]
    dips = (inside <= bent[:-2]) & (inside <= bent[2:]) & (inside < _DIP_SHARE * largest)
    found = []
    for i in np.flatnonzero(dips) + 1:
        low, high = s[i - 1], s[i + 1]
        if any(low <= z.s_end and z.s <= high for z in zeros):
            continue
        sign = np.sign(felt[i])

        def depth(s: float, sign: float = sign) -> float:
            return float(sign * excess.at(curve.parameter(np.array(s))))

        from scipy.optimize import minimize_scalar

        least = minimize_scalar(
            depth, bounds=(low, high), method="bounded", options={"xatol": 1e-7 * curve.length}
        )
        if least.fun <= FAINT_SHARE * largest:
            found.append(float(least.x))
    return found


def _slope(excess: ExcessCurvature, zero: CurvatureZero) -> float:
    """Least one-sided |d kappa / ds| at a zero."""
    t = np.array(zero.t)
    low, high = excess.curve.domain
    sides = [side for side, inside in ((True, zero.t > low), (False, zero.t < high)) if inside]
    return min(abs(float(excess.slope_at(t, left=side))) for side in sides)


def _positions(check: EquilibriumCheck) -> FloatArray:
    return np.asarray(check.curve.evaluate(np.array([z.t for z in check.zeros])))


def _largest_move(before: PlaneCurve, after: PlaneCurve) -> float:
    """Largest distance of points of the same parameter, mm."""
    t = np.linspace(*before.domain, 1001)
    return float(np.hypot(*np.moveaxis(np.asarray(after.evaluate(t)) - before.evaluate(t), -1, 0)).max())


def _kind_of(normal: FloatArray | None) -> str:
    if normal is None:
        return ""
    return "vertical " if normal[0] else "horizontal "
