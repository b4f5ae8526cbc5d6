"""Labelled rows of the report on a part with two states, for text and page."""

from typing import Any

import numpy as np

from elastica_cad.errors import Degrees, Energy, Force, Length, Refusal, Span, Strain, note
from elastica_cad.mechanics.section_limits import judge_strain
from elastica_cad.pairs.flexure import STATES, Flexure
from elastica_cad.report_rows import Row, in_order
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.holding_template import direction_in_drawing
from elastica_cad.strip.summary import LATER


def pair_rows(part: Flexure, *, quick: bool = False, live: bool = False) -> tuple[Row, ...]:
    """Return the report on a part in rows, with warnings before notes.

    Parameters
    ----------
    part : Flexure
    quick : bool
        True to omit the path between the states, which is slow to compute.
    live : bool
        True to show "…" instead of the stability, which is computed later.
    """
    path = [] if quick else [Row(note("Force"), _force_sentence(part))]
    first, second = part.rest_deviations
    rest = note(
        "the part rests up to {far} ({first}) and {other} ({second}) from its curves, because its forces "
        "stretch the part",
        far=about(first), other=about(second), **_names(part),
    )  # fmt: skip
    stability = Row(note("Stability"), LATER) if live else _stability_row(part)
    size = note(
        "{length:.1f} between its end pads, {thickness} wide in the drawing, {depth} thick",
        length=Length(part.pair.length), thickness=Span.of(*part.thickness_range),
        depth=Length(part.sheet.thickness),
    )  # fmt: skip
    ratio = note("The largest stiffness of the strip is {ratio:.4g} times the least.", ratio=part.pair.ratio)
    rows = [Row(note("Size"), size, (ratio,)), _strain(part, quick=quick), stability, *path]
    turn, moved = part.second_moved
    # curves may be drawn beside each other, so the turn of the second state is stated
    if abs(turn) > 0.05:
        angles = [float(np.degrees(rod.angle[0])) for rod in part.pair.states]
        text = note(
            "{second} is turned by {turn:.1f}, because both states start in the same clamp, and the drawn "
            "curves start at {one:.1f} and {other:.1f} to the x axis",
            turn=Degrees(turn), one=angles[0], other=Degrees(angles[1]), second=part.state_labels[1],
        )  # fmt: skip
        details = [note("Curves that start in the same direction are not turned.")]
        rows += [Row(note("Position"), text, details)]
        rest = note(
            "{rest}; in the clamp, {second} is up to {moved} from its drawn position",
            rest=rest, moved=about(moved), second=part.state_labels[1],
        )  # fmt: skip
    return in_order([*rows, Row(note("Accuracy"), rest)])


def _names(part: Flexure) -> dict[str, Any]:
    return dict(zip(STATES, part.state_labels, strict=True))


def _strain(part: Flexure, *, quick: bool) -> Row:
    strains = [*map(Strain, (*part.strain, *(() if quick else (part.travel_strain,))))]
    text = note(
        "{one:.2f} ({first}) and {other:.2f} ({second}); {sheet} allows {limit:.2f} in the long term"
        if quick else
        "{one:.2f} ({first}) and {other:.2f} ({second}), {between:.2f} on the way between them; {sheet} "
        "allows {limit:.2f} in the long term",
        one=strains[0], other=strains[1], between=strains[-1],
        sheet=part.sheet.name, limit=Strain(part.sheet.max_strain), **_names(part),
    )  # fmt: skip
    allowed = judge_strain(part.sheet, max(strains)).allowed
    return Row(note("Strain"), text, severity="note" if allowed else "warning")


def _stability_row(part: Flexure) -> Row:
    (first, second), sides = part.pair.stability, part.sideways
    ratings = (first.rating, second.rating, *(side.rating for side in sides))
    details = [
        note(
            "The stability margins of both states are {first:.3g} and {second:.3g}, sideways {left:.3g} and "
            "{right:.3g}. A state is stable if its margin is positive.",
            first=first.margin, second=second.margin, left=sides[0].margin, right=sides[1].margin,
        )
    ]  # fmt: skip
    if set(ratings) == {"stable"}:
        return Row(note("Stability"), note("both states are stable, in the plane and sideways"), details)
    first_plane, second_plane, first_sideways, second_sideways = map(note, ratings)
    text = note(
        "{first}: {first_plane} in the plane, {first_sideways} sideways. {second}: {second_plane} in the plane, "
        "{second_sideways} sideways.",
        first_plane=first_plane, second_plane=second_plane, first_sideways=first_sideways,
        second_sideways=second_sideways, **_names(part),
    )  # fmt: skip
    return Row(note("Stability"), text, details, "warning")


def _force_sentence(part: Flexure) -> Refusal:
    """Return the sentence on what moves the part between its states: its end or, if it is bistable, a push."""
    turn = Degrees(round(part.force_direction))
    if not part.pair.bistable:
        sentence = note(
            "the end of the part can be clamped in two positions; moving the end between them takes "
            "at most {force}, at {turn:.0f} to the x axis",
            force=part.force_text, turn=turn,
        )  # fmt: skip
        snap, jump = part.travel.snap, part.travel.forces_at_snap
        if snap is None or jump is None:
            return sentence
        return note(
            "{sentence}; the part snaps after {snap:.3g} of rotation, and the force jumps from "
            "{before:.2g} to {after:.2g}"
            if part.travel.unit == "deg" else
            "{sentence}; the part snaps after {snap:.3g} of travel, and the force jumps from {before:.2g} to "
            "{after:.2g}",
            sentence=sentence, snap=(Degrees if part.travel.unit == "deg" else Length)(snap),
            before=jump[0], after=Force(jump[1]),
        )  # fmt: skip
    at = Length(part.pushed[0])
    if (back := part.travel_back) is None:
        return note(
            "not bistable: the part keeps one curve ({second}) only while pushed with {force}, "
            "{at:.4g} from the start and at {turn:.0f} to the x axis",
            force=part.force_text, at=at, turn=turn, second=part.state_labels[1],
        )  # fmt: skip
    sentence = note(
        "bistable: pushed {direction} at {at:.3g} from the start, the part snaps over at {force}, and back at "
        "about {back:.2g}"
        if turn % 90 == 0 else
        "bistable: pushed at {at:.3g} from the start, at {turn:.0f} to the x axis, the part snaps over at "
        "{force}, and back at about {back:.2g}",
        at=at, turn=turn, direction=direction_in_drawing(turn), force=part.force_text,
        back=Force(back.largest_force),
    )  # fmt: skip
    if part.travel.snap is None:
        return sentence
    return note(
        "{sentence}; after {snap:.3g} of travel and about {work:.2g} of work, the part snaps by itself",
        sentence=sentence, snap=Length(part.travel.snap), work=Energy(part.travel.work),
    )  # fmt: skip
