"""Strips that lock into each other, with widths that make up for their slots."""

from collections.abc import Container
from dataclasses import replace
from typing import Any

from elastica_cad.fabrication.compensation import compensate_widths
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.sheets.pieces import cut_key
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.refusals import Length, note

LARGEST = 0.15
"""Largest change of the logarithm of a width. Strips that become wider at their ends are narrower elsewhere."""

WIDENED, GENTLER = 1.1, 0.7
"""As much wider a strip becomes at once so that no joint is lost; where that would need more, its largest change is
made so much smaller instead: a wider strip has wider shoulders beside its tabs, which cost more than is gained."""

ROUNDS, MOST_ROUNDS = 2, 10
"""Usual and largest number of rounds: wider strips have deeper slots, and joints may be lost."""


def interlock_compensated(model: Model, which: Container[str], **options: Any) -> Model:
    """The model interlocked, with widths that make up for the slots.

    Strips that would no longer reach each other, narrower as they get, are widened as a whole by as much as they
    lost there, which changes no shape and is reported; where that is much, less is made up for. What is left is
    each strip's `held_deviation`.

    Parameters
    ----------
    model : Model
        Not interlocked yet.
    which : container of str
        Labels of the strips whose widths may change.
    **options
        Those of `Model.interlock`, and its errors.
    """
    first = locked = model.interlock(**options)
    wider, largest, left = [1.0] * len(model.strips), [LARGEST] * len(model.strips), ROUNDS
    for _ in range(MOST_ROUNDS):
        # slots are cut anew: where widths change, those of the round before need not reach the edge
        known: dict[Any, Strip] = {}
        strips = list(model.strips)
        for k, (one, cut) in enumerate(zip(model.strips, locked.strips, strict=True)):
            if one.label not in which:
                continue
            alike = cut_key(cut), largest[k]
            if alike not in known:
                known[alike] = compensate_widths(cut, largest=largest[k])
            strips[k] = _widened(replace(one, correction=known[alike].correction), wider[k])
        locked = model.with_strips(strips).interlock(**options)
        lost = _lost(first, locked)
        left = ROUNDS if lost else left - 1
        if not left:
            break
        for k, narrower in _narrowed(lost, model, locked).items():
            if narrower > WIDENED:
                largest[k] *= GENTLER
            else:
                wider[k] *= narrower
    told = tuple(
        note(
            "{strip} is {width:.4g} wide at most, not {asked:.4g}, so that it still locks into its neighbours",
            strip=model.name_of(k), width=Length(strip.max_width), asked=Length(one.max_width),
        )
        for k, (one, strip) in enumerate(zip(model.strips, locked.strips, strict=True))
        if strip.max_width is not None and one.max_width is not None and strip.max_width > one.max_width
    )  # fmt: skip
    return replace(locked, reports=(*locked.reports, *told))


def _widened(strip: Strip, scale: float) -> Strip:
    if scale == 1 or strip.max_width is None or strip.rod.bending_stiffness is not None:
        return strip
    return replace(strip, max_width=scale * strip.max_width)


def _lost(before: Model, after: Model) -> list[tuple[int, float]]:
    """Strips, and places on them, mm, of joints that are no more.

    Two strips may meet more than once: each joint that is left is the nearest one of before.
    """
    gone = [(joint.members, [slot.at for slot in joint.slots]) for joint in before.joints]
    for joint in after.joints:
        same = [one for one in gone if one[0] == joint.members]
        if same:
            gone.remove(min(same, key=lambda one: abs(one[1][0] - joint.slots[0].at)))
    return [place for members, places in gone for place in zip(members, places, strict=True)]


def _narrowed(lost: list[tuple[int, float]], before: Model, after: Model) -> dict[int, float]:
    """Largest share by which each strip became narrower at the joints that it lost."""
    found: dict[int, float] = {}
    for k, at in lost:
        narrower = float(before.strips[k].width(at) / after.strips[k].width(at))
        found[k] = max(1.0, narrower, found.get(k, 1.0))
    return found
