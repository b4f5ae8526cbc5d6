"""Strips that lock into each other, with widths that make up for their slots."""

from collections import Counter
from collections.abc import Container
from dataclasses import replace
from typing import Any

from elastica_cad.fabrication.compensation import compensate_widths
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.strip.strip_record import Strip

ROUNDS, MOST_ROUNDS = 2, 6
"""Wider strips have deeper slots: a second round leaves little of that. As many again where joints were lost."""


def interlock_compensated(model: Model, which: Container[str], **options: Any) -> Model:
    """The model interlocked, with widths that make up for the slots.

    Strips that would no longer reach each other, narrower as they get, are widened as a whole by as much as they
    lost there: that changes no shape, and is reported.

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
    wider, left = [1.0] * len(model.strips), ROUNDS
    for _ in range(MOST_ROUNDS):
        # slots are cut anew: where widths change, those of the round before need not reach the edge
        strips = [
            _widened(replace(one, correction=compensate_widths(cut).correction), scale)
            if one.label in which else one
            for one, cut, scale in zip(model.strips, locked.strips, wider, strict=True)
        ]  # fmt: skip
        locked = model.with_strips(_shared(model.strips, locked.strips, strips)).interlock(**options)
        lost = _lost(first, locked)
        left = ROUNDS if lost else left - 1
        if not left:
            break
        for k, at in lost:
            before, now = model.strips[k].width(at), locked.strips[k].width(at)
            wider[k] *= max(1.0, float(before / now))
    told = tuple(
        f"{model.name_of(k)} is {strip.max_width:.4g} mm wide at most, not {one.max_width:.4g} mm, so that it "
        "still locks into its neighbours"
        for k, (one, strip) in enumerate(zip(model.strips, locked.strips, strict=True))
        if strip.max_width is not None and one.max_width is not None and strip.max_width > one.max_width
    )
    return replace(locked, reports=(*locked.reports, *told))


def _widened(strip: Strip, scale: float) -> Strip:
    if scale == 1 or strip.max_width is None or strip.rod.bending_stiffness is not None:
        return strip
    return replace(strip, max_width=scale * strip.max_width)


def _lost(before: Model, after: Model) -> list[tuple[int, float]]:
    """Strips, and places on them, mm, of joints that are no more."""
    known = Counter(joint.members for joint in after.joints)
    lost: list[tuple[int, float]] = []
    for joint in before.joints:
        if known[joint.members]:
            known[joint.members] -= 1
        else:
            lost += [(k, slot.at) for k, slot in zip(joint.members, joint.slots, strict=True)]
    return lost


def _shared(before: tuple[Strip, ...], cut: tuple[Strip, ...], after: list[Strip]) -> list[Strip]:
    """Strips that were one and are cut alike stay one."""
    known: dict[tuple[int, int], Strip] = {}
    return [
        known.setdefault((id(one), id(slotted)), new)
        for one, slotted, new in zip(before, cut, after, strict=True)
    ]
