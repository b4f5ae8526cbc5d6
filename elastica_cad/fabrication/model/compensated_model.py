"""Strips that lock into each other, with widths that make up for their slots."""

from collections.abc import Container
from dataclasses import replace
from typing import Any

from elastica_cad.fabrication.compensation import compensate_widths
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.strip.strip_record import Strip

ROUNDS = 2
"""Wider strips have deeper slots: a second round leaves little of that."""


def interlock_compensated(model: Model, which: Container[str], **options: Any) -> Model:
    """The model interlocked, with widths that make up for the slots.

    Parameters
    ----------
    model : Model
        Not interlocked yet.
    which : container of str
        Labels of the strips whose widths may change.
    **options
        Those of `Model.interlock`, and its errors.
    """
    locked = model.interlock(**options)
    for _ in range(ROUNDS):
        # slots are cut anew: where widths change, those of the round before need not reach the edge
        strips = [
            replace(one, correction=compensate_widths(cut).correction) if one.label in which else one
            for one, cut in zip(model.strips, locked.strips, strict=True)
        ]
        locked = model.with_strips(_shared(model.strips, locked.strips, strips)).interlock(**options)
    return locked


def _shared(before: tuple[Strip, ...], cut: tuple[Strip, ...], after: list[Strip]) -> list[Strip]:
    """Strips that were one and are cut alike stay one."""
    known: dict[tuple[int, int], Strip] = {}
    return [
        known.setdefault((id(one), id(slotted)), new)
        for one, slotted, new in zip(before, cut, after, strict=True)
    ]
