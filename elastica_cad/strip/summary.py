"""Report on a strip as labelled rows, for text, notebooks, FreeCAD and the web page."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Any

import numpy as np

from elastica_cad.errors import (
    Degrees,
    ElasticaError,
    FieldName,
    Force,
    Length,
    Listed,
    Mass,
    Refusal,
    Strain,
    is_reported,
    note,
    sentences,
)
from elastica_cad.form_finding.limits import FAR_SHARE
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.geometry.plane_points import angle_of, norm
from elastica_cad.mechanics.elements import ElementForce, Pin, Rail, Tie, noun_of, side_of_bar
from elastica_cad.mechanics.loads import PointMass
from elastica_cad.mechanics.mounted_elements import ShapeOfRod, violation
from elastica_cad.mechanics.mounting_errors import (
    ROUNDING_FRACTION,
    SparePiece,
    displacements_per_mm,
    spare_pieces,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sideways import SAFE_LOAD
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.report_rows import Row, in_order, warning_row
from elastica_cad.strip.clamp_errors import can_snap, clamp_warning
from elastica_cad.strip.element_cuts import element_cuts
from elastica_cad.strip.held_shape import HeldShape, about
from elastica_cad.strip.holding_template import (
    HeldEnd,
    angle_text,
    direction_in_drawing,
    distance_between,
    distance_of_tips,
    held_ends,
)
from elastica_cad.strip.strip import Strip

LATER = "…"  # text of a row that is not computed yet


def strip_rows(
    strip: Strip,
    near: NearestRod | None = None,
    verdict: Stability | None = None,
    *,
    quick: bool = False,
) -> tuple[Row, ...]:
    """Return the report on a strip in rows, with warnings before notes.

    Parameters
    ----------
    strip : Strip
    near : NearestRod, optional
        Nearest rod from which the strip was made, if the curve was allowed to change.
    verdict : Stability, optional
        Stability of the rod of the strip; computed by default.
    quick : bool
        If True, the slowest computations are omitted: the rows on accuracy, and on stability without `verdict`,
        show "…", and there are no rows on mounting and creep.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 30, np.pi, 0), "card-200gsm", max_width=8)
    >>> for row in strip_rows(arch)[:3]:
    ...     print(row.label, "|", row.text)
    Size | 94.2 mm long (114.2 mm with tabs), 8 mm wide, 0.183 g
    Strain | 0.33 % at 0 mm from the start; card-200gsm allows 0.50 %
    Stability | stable: the strip neither snaps into another shape nor tips over sideways
    """
    waits = quick and verdict is None
    rows = [
        size_row(strip),
        *load_rows(strip.rod),
        *_nearest(strip, near),
        *strain_rows(strip),
        Row(note("Stability"), LATER) if waits else stability_row(strip, verdict or stability(strip.rod)),
        hold_row(strip),
        *cut_rows(strip),
        *between_rows(strip.rod, strip.bending_stiffness),
        *_unloaded_rows(strip),
        *([Row(note("Accuracy"), LATER)] if quick else _slow_rows(strip, near)),
    ]
    reported = {*strip.strain_warnings, None if near is None else near.status.value}
    rows += [
        warning_row(text, note("Warning")) if is_reported(text) else Row(note("Note"), text)
        for text in strip.warnings
        if text not in reported
    ]
    return in_order(rows)


def _slow_rows(strip: Strip, near: NearestRod | None) -> Iterator[Row]:
    """Yield the rows that take long to compute: mounting, accuracy and creep."""
    yield from _mounting_rows(strip)
    with suppress(ElasticaError):
        accuracy = not_computed_row(strip) or accuracy_row(strip.held())
        yield accuracy
        if near is not None and (accuracy.severity == "warning" or clamp_warning(strip)):
            yield NEAREST_SUPPORT
    with suppress(ElasticaError):
        if strip.crept is not None:
            yield Row(note("Creep"), str(strip.crept))


def size_row(strip: Strip) -> Row:
    """Return the row on length, width and mass of a strip."""
    tabs = sum(tab.length for tab in strip.ends)
    length = strip.rod.length
    ratio = note("The largest stiffness of the strip is {ratio:.4g} times the least.", ratio=strip.rod.ratio)
    return Row(
        note("Size"),
        note(
            "{length:.1f} long ({whole:.1f} with tabs), {breadth}, {mass}"
            if tabs
            else "{length:.1f} long, {breadth}, {mass}",
            length=Length(length), whole=Length(length + tabs), breadth=strip.breadth(".1f"),
            mass=Mass(strip.mass),
        ),
        (ratio, *filter(None, [strip.backing_side])),
    )  # fmt: skip


def _nearest(strip: Strip, near: NearestRod | None) -> Iterator[Row]:
    if near is None:
        return
    yield Row(
        note("Curve"),
        note("at most {far} from the drawn curve", far=Length(near.deviation)),
        (note(near.status.value),),
        "warning" if near.deviation > FAR_SHARE * strip.rod.length else "note",
    )
    if advice := near.advice:
        yield Row(note("Change"), advice[0], advice[1:])


def strain_rows(strip: Strip) -> Iterator[Row]:
    """Yield the warnings about strain or, without any, a row on the largest strain and its limit."""
    for warning in strip.strain_warnings:
        yield warning_row(warning, note("Strain"))
    if strip.strain_warnings:
        return
    worst = other = strip.most_strained
    # `states` are the strains of a layer with and without the loads; `other` is the one that is not the worst
    for states in zip(strip.strains, strip.unloaded_strains, strict=False):
        if worst in states:
            other = states[states[0] is worst]
    text = "{strain:.2f} at {at:.0f} from the start; {sheet} allows {limit:.2f}"
    # both strains are printed if they differ in the printed digits of a percentage
    if round(1e4 * other.largest) != round(1e4 * worst.largest):
        text = (
            "{strain:.2f} at {at:.0f} from the start with the loads, {other:.2f} without them; {sheet} allows "
            "{limit:.2f}"
            if worst in strip.strains
            else "{strain:.2f} at {at:.0f} from the start without the loads, {other:.2f} with them; {sheet} "
            "allows {limit:.2f}"
        )
    yield Row(
        note("Strain"),
        note(
            text, strain=Strain(worst.largest), at=Length(strip.max_strain_at), other=Strain(other.largest),
            sheet=worst.name, limit=Strain(worst.limit),
        ),
    )  # fmt: skip


def stability_row(strip: Strip, verdict: Stability) -> Row:
    """Return the row on stability, in the plane and sideways."""
    sideways = strip.sideways
    details = [
        note(
            "The stability margin is {margin:.3g}; below 5, a push can move the strip into another shape.",
            margin=verdict.margin,
        )
    ]
    if sideways.decided:
        details.append(
            note(
                "The margin against tipping sideways is {margin:.3g}, and {overloaded:.3g} under {factor:g} "
                "times the forces; above 0 is safe.",
                margin=sideways.margin,
                overloaded=sideways.overloaded,
                factor=SAFE_LOAD,
            )
        )
    if warning := instability(strip, verdict):
        return Row(note("Stability"), warning, details, "warning")
    text = note("stable: the strip neither snaps into another shape nor tips over sideways")
    if sideways.word == "undecided":
        text = note("stable in its plane; sideways undecided ({meaning})", meaning=note(sideways.meaning))
    return Row(note("Stability"), text, details)


def instability(strip: Strip, verdict: Stability) -> Refusal | None:
    """Return the warning that a strip snaps in its plane or tips over sideways, or None if it is stable."""
    if warning := instability_in_plane(strip, verdict):
        return warning
    if strip.sideways.word == "unstable":
        return note(
            "unstable sideways: the strip tips over; guide it at the sides, or make it wider",
            severity="warning",
        )
    if strip.sideways.word == "low":
        return note("close to tipping over sideways: guide the strip at the sides", severity="warning")
    return None


def instability_in_plane(strip: Strip, verdict: Stability) -> Refusal | None:
    """Return the warning that a strip snaps, or None if it is stable in its plane under errors of the clamps."""
    if verdict.rating == "unstable":
        return note("unstable: the strip snaps into another shape", severity="warning")
    if verdict.rating == "close to snapping":
        return note(
            "close to snapping: a push can move the strip into another shape",
            severity="warning",
        )
    return clamp_warning(strip)


def hold_row(strip: Strip) -> Row:
    """Return the row on the positions and loads of the ends, or on the joint of a closed strip."""
    if strip.joint:
        return Row(note("Hold"), strip.joint)
    ends = held_ends(strip)
    has_tabs = any(tab.length for tab in strip.ends)
    text = "{apart:.1f} apart, where the tabs begin" if has_tabs else "{apart:.1f} apart"
    distance = note(text, apart=Length(distance_between(ends)))
    apart = note(
        "ends {distance}; seen from start to end, the strip points {start} at the start, {end} at the end"
        if all(end.support.angle for end in ends)
        else "ends {distance}, free to turn; seen from start to end, the strip at rest points {start} at the "
        "start, {end} at the end",
        distance=distance, start=angle_text(ends[0].tilt), end=angle_text(ends[1].tilt),
    )  # fmt: skip
    if strip.rod.supports.is_free:
        apart = note("both ends are free: nothing holds them; they rest {apart:.1f} apart", **distance.values)
        return Row(note("Hold"), apart, (_distance_details(ends),))
    for held, name in zip(ends, ("start", "end"), strict=True):
        if held.support.is_free:
            apart = note("{ends}; the {end} is free: nothing holds it", ends=apart, end=note(name))
    forces = strip.reactions()
    start, end = (
        note("force {force:.2g} and moment {moment:.2g}", force=force, moment=moment)
        for force, moment in forces.sizes
    )
    load: str = note(
        "{apart}; {load} at each end"
        if start == end
        else "{apart}; {start_load} at the start, {end_load} at the end",
        apart=apart, load=start, start_load=start, end_load=end,
    )  # fmt: skip
    chord = ends[1].position - ends[0].position
    inward = forces.start_force @ chord / (norm(chord) or 1.0)
    # a force that is mostly along the line between the ends pushes or pulls them
    if start == end and abs(inward) > 0.9 * forces.sizes[0][0]:
        load = note(
            "{apart}; the strip pushes the ends apart with {force:.2g}, moment {moment:.2g} at each end"
            if inward > 0
            else "{apart}; the strip pulls the ends together with {force:.2g}, moment {moment:.2g} at each "
            "end",
            apart=apart, **start.values,
        )  # fmt: skip
    sides = note(
        "The start is the first point of the curve. Left and right are seen in the drawing, from start to end."
    )
    details, shorter = [_distance_details(ends), sides], strip.compressed_length
    # compression is reported from 5 % of the difference between length and chord
    if abs(shorter) > 0.05 * (strip.rod.length - distance_between(ends)):
        advice = note(
            "set the ends {change:.2f} closer, because the force compresses this shallow strip"
            if shorter > 0
            else "set the ends {change:.2f} farther apart, because the force stretches this shallow strip",
            change=Length(abs(shorter)),
        )  # fmt: skip
        if abs(shorter) > MOUNTING_ERROR_MM:
            load = sentences([load, advice])
        else:
            details.append(advice)
    return Row(note("Hold"), load, details)


def _distance_details(ends: Sequence[HeldEnd]) -> Refusal:
    return note(
        "This distance is measured between the places where the bend begins; the tips of the tabs are "
        "{tips:.1f} apart.",
        tips=Length(distance_of_tips(ends)),
    )


def cut_rows(strip: Strip) -> Iterator[Row]:
    """Yield a row on the holes and notches for pins and ties, if any."""
    cuts, first = element_cuts(strip.rod), strip.ends[0].length
    if not cuts:
        return
    sizes: dict[tuple[float, float], list[Length]] = {}
    for cut in cuts:
        sizes.setdefault((cut.hole, cut.notch), []).append(Length(first + cut.at))
    texts = [
        note(
            "holes of {size:g} at {places}" if hole else "notches of {size:g} at {places}",
            size=Length(hole or notch), places=Listed(places),
        )
        for (hole, notch), places in sizes.items()
    ]  # fmt: skip
    yield Row(
        note("Holes"),
        note("{cuts}; measured along the flat strip from its start", cuts=sentences(texts, ", ")),
    )


def load_rows(rod: Rod) -> Iterator[Row]:
    """Yield a row on the masses and forces on a rod, if any, and whether its own weight acts too."""
    texts: list[Refusal] = []
    for action in (*rod.hung, *rod.point_forces):
        load: Any = action.element
        at = Length(action.s[0])
        texts.append(
            note("{mass:g} at {at:.5g} ({force})", mass=Mass(load.mass), at=at, force=Force(load.newtons))
            if isinstance(load, PointMass)
            else note("({x:g}, {y:g}) N at {at:.5g}", x=load.force[0], y=load.force[1], at=at)
        )
    if texts:
        texts += [note("the weight of the strip")] * (rod.gravity is not None)
        yield Row(note("Load"), sentences(texts, "; "))


def between_rows(rod: Rod, bending_stiffness: float) -> Iterator[Row]:
    """Yield a row on the forces of rails, pins and ties, if any. `bending_stiffness` is in N mm2."""
    if not rod.between:
        return
    least, texts = ROUNDING_FRACTION * norm(rod.force).max(), []
    for action in rod.between:
        text = _element_text(
            action, rod, Force(bending_stiffness * action.size if action.size > least else 0)
        )
        if (bar := action.bar_direction(rod.curve)) is not None:
            text = note("{text} (bar {side})", text=text, side=side_of_bar(bar))
        texts.append(text)
    details = note(
        "Directions are those of the drawing; a rail that pushes the strip upward is below it. Angles are "
        "measured from the x axis."
    )
    yield Row(note("Between"), sentences(texts, "; "), (details,))


def _unloaded_rows(strip: Strip) -> Iterator[Row]:
    """Yield a row on the movement of a strip when its loads are removed, if it has loads."""
    if strip.unloaded is None:
        return
    distance, at, direction = farthest_move(strip.rod, strip.unloaded)
    text = (
        "without the loads, the strip stays within {limit} of the drawn curve"
        if distance < SMALLEST_MOVE_MM
        else "without the loads, the strip moves by at most {far}: the point {at:.0f} from the start, {direction}"
    )
    yield Row(
        note("Movement"),
        note(text, limit=Length(SMALLEST_MOVE_MM), far=about(distance), at=Length(at), direction=direction),
    )


def farthest_move(design: Rod, bent: Rod) -> tuple[float, float, Refusal]:
    """Return the largest movement of a point of a bent rod, mm, the point's arc length, mm, and its direction."""
    moves = bent.position - design.position
    sizes = norm(moves)
    k = sizes.argmax()
    direction = direction_in_drawing(float(np.degrees(angle_of(moves[k]))))
    return float(sizes[k]), float(design.s[k]), direction


SMALLEST_MOVE_MM = 0.01
"""Smallest displacement of a strip, and smallest gap between strip and rail, that is reported, mm."""

MOUNTING_ERROR_MM = 0.5
"""Assumed error of the position of an end, rail or pin, or of the length of a cord, mm."""


@lru_cache(maxsize=64)
def _mounting_moves(rod: Rod) -> tuple[float | SparePiece, ...]:
    """Return the movement, mm, by a usual error of each rail, pin or tie, or the piece that is too short for it."""
    return tuple(
        MOUNTING_ERROR_MM * moved if piece is None or piece.spare >= MOUNTING_ERROR_MM else piece
        for moved, piece in zip(displacements_per_mm(rod), spare_pieces(rod), strict=True)
    )


def moves_far(strip: Strip) -> bool:
    """Return True if a usual mounting error of a rail, pin or tie moves the strip far."""
    moves = (moved for moved in _mounting_moves(strip.rod) if isinstance(moved, float))
    return max(moves, default=0.0) > FAR_SHARE * strip.rod.length


def needs_exact_pin(strip: Strip) -> bool:
    """Return True if a usual mounting error puts a pin out of reach of the strip."""
    return any(isinstance(moved, SparePiece) for moved in _mounting_moves(strip.rod))


def _mounting_rows(strip: Strip) -> Iterator[Row]:
    """Yield the rows on the movement of the strip by errors in mounting rails, pins and ties."""
    texts = []
    for action, moved in zip(strip.rod.between, _mounting_moves(strip.rod), strict=True):
        if isinstance(moved, SparePiece):
            exact = note(
                "the pin {at:.0f} from the start allows an error of at most {spare}, because the strip from "
                "{start:.0f} to {end:.0f} is almost straight and reaches no farther. Move this pin along the "
                "strip, or draw another curve",
                at=Length(action.s[0]), spare=about(max(moved.spare, SMALLEST_MOVE_MM)),
                start=Length(moved.start), end=Length(moved.end),
            )  # fmt: skip
            yield warning_row(exact, note("Mounting"))
            continue
        # the estimate is linear, so it is reported up to 10 % of the length
        move = note(
            "the {element} from {start:.0f} to {end:.0f} moves the strip by {far}"
            if isinstance(action.element, Tie)
            else "the {element} {start:.0f} from the start moves the strip by {far}",
            far=_rounded_move(moved, 0.1 * strip.rod.length), element=noun_of(action.element),
            start=Length(action.s[0]), end=Length(action.s[-1]),
        )  # fmt: skip
        texts.append(move)
    if not texts:
        return
    text = note(
        "if mounted with an error of {error}, {moves}", error=Length(MOUNTING_ERROR_MM), moves=sentences(texts),
    )  # fmt: skip
    if far := moves_far(strip):
        text = note(
            "{text}. Movements above {percent:g} % of the length are large: support the strip in another way, or "
            "draw another curve",
            text=text, percent=100 * FAR_SHARE,
        )  # fmt: skip
    details = note(
        "The error is the distance of a rail or pin from its designed position, or the error of the length of a "
        "cord. The stated movement is that of the point of the strip that moves most."
    )
    yield Row(note("Mounting"), text, (details,), "warning" if far else "note")


def _rounded_move(mm: float, most: float) -> Length | Refusal:
    # return a movement as a text, or as "more than" or "less than" a limit
    if mm > most:
        return note("more than {limit}", limit=about(most))
    return about(mm) if mm >= SMALLEST_MOVE_MM else note("less than {limit}", limit=Length(SMALLEST_MOVE_MM))


def _element_text(action: ElementForce, rod: Rod, force: Force) -> Refusal:
    """Return what a rail, pin or tie does to the strip, with its force, or that it is slack."""
    if action.is_one_sided and not force:
        places = Listed(map(Length, np.round(action.s, 1).tolist()))
        gap = -violation(action, ShapeOfRod.of(rod))
        return note(
            "the {element} {places} from the start is slack, {gap:.2g} away from the strip"
            if isinstance(action.element, Rail) and gap >= SMALLEST_MOVE_MM
            else "the {element} {places} from the start is slack",
            element=noun_of(action.element), places=places, gap=Length(gap),
        )  # fmt: skip
    if isinstance(action.element, Tie):
        return note(
            "tie from {start:.0f} to {end:.0f}, {length:.1f} long, pulls {force:.2g}",
            start=Length(action.s[0]), end=Length(action.s[1]), force=force,
            length=Length(action.distance_on(rod.curve)),
        )  # fmt: skip
    angle = float(np.degrees(angle_of(action.force[0])))
    if isinstance(action.element, Rail):
        return note(
            "rail {at:.0f} from the start pushes the strip {direction} with {force:.2g}",
            at=Length(action.s[0]), direction=direction_in_drawing(angle), force=force,
        )  # fmt: skip
    pin = note(
        "pin {at:.0f} from the start pushes the strip with {force:.2g} at {angle:.0f}",
        at=Length(action.s[0]), force=force, angle=Degrees(angle),
    )  # fmt: skip
    assert isinstance(action.element, Pin)
    turn = np.radians(angle) - float(rod.curve.at(action.s).angle[0])
    along, across = force * abs(np.cos(turn)), force * abs(np.sin(turn))
    # with less force along the strip, friction holds a ring
    if along <= 0.3 * across or action.element.hole or action.element.notch:
        return pin
    return note(
        "{pin}, {along:.2g} of it along the strip: a ring would slide, so screw a hinge to the strip",
        pin=pin, along=Force(along),
    )  # fmt: skip


def not_computed_row(strip: Strip) -> Row | None:
    """Return the row on accuracy of a strip whose accuracy is not computed, with the reason, or None."""
    if strip.rod.acting:
        return Row(note("Accuracy"), note(
            "not computed for a strip with rails, pins, ties or point forces, because the model of the strip as "
            "made has supports at its ends only"
        ))  # fmt: skip
    if can_snap(strip):
        return Row(note("Accuracy"), note("not computed, because the strip can snap into another shape"))
    return None


NEAREST_SUPPORT = Row(
    note("Change"),
    note(
        "To support this strip between its ends, take its curve ({curve}) as the drawn curve, leave out {limits}, "
        "and add {between}",
        curve=FieldName("rod.curve"), limits=FieldName("limits"), between=FieldName("between"),
    ),
)  # fmt: skip
"""Row on supports of a strip of a nearest curve, with which they cannot be combined."""


def accuracy_row(held: HeldShape) -> Row:
    """Return the row on the expected deviation of a real strip, with its causes in the details."""
    share = held.expected / held.rod.length
    # the user is warned before cutting
    far_off = share > 0.05
    text = note(
        "about {far} from the design, {percent:.0f} % of its length. Largest contribution: {largest}. Reduce it, "
        "support the strip between its ends, or draw another curve" if far_off else
        "about {far} from the design. Largest contribution: {largest}",
        far=about(held.expected), percent=100 * share, largest=held.contributions[0].sentence,
    )  # fmt: skip
    return Row(note("Accuracy"), text, (str(held),), "warning" if far_off else "note")
