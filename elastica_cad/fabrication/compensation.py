"""Widths that make up for what slots, tabs, leaning ligaments and anticlastic bending do to a strip."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of, require_positive, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.holding.held_shape import Seats, strayed
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.holding.width_correction import correct_widths, width_basis
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.rod.rod_record import Rod

ROUNDS = 8
LEAST_GAIN = 0.97  # of what is left in one round: a round that leaves more is the last
LARGEST_GUESS = 0.5  # of the logarithm of a width's change
ENOUGH_SHARE = 1e-5  # of the length: a deviation that needs no correction


def compensate_widths(
    strip: Strip, start: TabSeat | None = None, end: TabSeat | None = None, *, largest: float = np.inf
) -> Strip:
    """The strip with widths that bring it, as it is made and held, back to its design.

    Bent forward as made (`Strip.held`) it strays; its widths are changed smoothly, to first order, and that is
    repeated as long as it helps. What is left is `Strip.held().deviation`.

    Parameters
    ----------
    strip : Strip
    start, end : TabSeat, optional
        What holds the ends.
    largest : float
        Of the logarithm of a width's change, against the mean: ends flare where a slot lies beside a narrow tab,
        and a strip as wide as before at its ends is narrower elsewhere.

    Returns
    -------
    Strip
        The same rod with another `correction`; the strip itself where nothing helps.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip.outline import Tab
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
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
    for seat in (start, end):
        if seat is not None:
            require_record(seat, TabSeat, "a holder", "a TabSeat, or None")
    strip = replace(strip, correction=None) if strip.correction is not None else strip
    design = strip.as_made.design
    basis = width_basis(design.s, closed=strip.is_closed)
    # a first guess: as much wider as each place is softer, evened out along the strip
    softer = -np.log(np.prod([np.ones(design.s.size), *strip.as_made.shares.values()], axis=0))
    clip = min(LARGEST_GUESS, largest)
    guess = np.clip(np.linalg.lstsq(basis, softer - softer.mean(), rcond=None)[0], -clip, clip)
    starts = [_held(strip, basis, start_at, (start, end)) for start_at in (np.zeros(basis.shape[1]), guess)]
    best = min(filter(None, starts), key=lambda one: one.strayed, default=None)
    if best is None:
        return strip
    step = 1.0
    for _ in range(ROUNDS):
        if best.strayed <= ENOUGH_SHARE * design.length:
            break
        drift = best.rod.position - design.position
        wanted = correct_widths(best.rod, drift, basis, best.coefficients, largest=largest)
        coefficients = best.coefficients + step * (wanted - best.coefficients)
        found = _held(strip, basis, coefficients, (start, end))
        if found is None or found.strayed >= best.strayed:
            step /= 2
            continue
        gain, best, step = found.strayed / best.strayed, found, min(1.0, 2 * step)
        if gain > LEAST_GAIN:
            break
    return best.strip


class _Held(NamedTuple):
    """A strip with corrected widths, its shape as held, and how far that strays from the design, mm."""

    strip: Strip
    coefficients: FloatArray
    rod: Rod
    strayed: float


def _held(strip: Strip, basis: FloatArray, coefficients: FloatArray, seats: Seats) -> _Held | None:
    """A strip with its widths changed by a basis (n, m), held; None where the style or the rest refuses it."""
    design, change = strip.as_made.design, basis @ coefficients
    try:
        if change.any():
            strip = replace(strip, correction=Profile.interpolate(design.s, np.exp(change)))
        rod = strip.as_made.rest(seats)
    except (InputError, NotConvergedError):
        return None
    return _Held(strip, coefficients, rod, strayed(design, rod.position))
