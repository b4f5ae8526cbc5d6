"""Widths that make up for what slots, tabs, leaning ligaments and anticlastic bending do to a strip."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of, require_positive, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.holding.held_shape import Seats, strayed
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.holding.width_correction import correct_widths, width_basis
from elastica_cad.fabrication.strip.strip_as_made import left_beyond
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.rod.rod_record import Rod

ROUNDS = 10
FIRST_DAMPING, MOST_DAMPING = 3e-4, 1.0  # of corrections: the first, and the last that is tried
DAMPED = 5.0  # times as much after a correction that did not help
LEAST_GAIN = 0.9  # of what is left in one round: a round that leaves more is the last
LARGEST_GUESS = 0.5  # of the logarithm of a width's change
SMOOTHINGS = (2e-2, 1e-2, 5e-3, 2e-3)  # of corrections: the next where the smoother one leaves too much
LEFT_SHARE = 2.8e-4  # of the length: what a correction may leave
LOOKS = 4  # at rounded holes: corrections change what these leave beyond sharp ones by little
SAME_LEFT = 1.02  # of what was reckoned with the holes of a look before: then no other look is needed
ENOUGH_SHARE = 1e-5  # of the length: a deviation that needs no correction


def compensate_widths(
    strip: Strip, start: TabSeat | None = None, end: TabSeat | None = None, *, largest: float = np.inf
) -> Strip:
    """The strip with widths that bring it, as it is made and held, back to its design.

    Bent forward as made (`Strip.held`) it strays; its widths are changed to first order, as smoothly as suffices,
    and that is repeated as long as it helps. What is left is `Strip.held().deviation`.

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
    >>> from elastica_cad.fabrication.strip.tabs import Tab
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
    holding = _Holding(strip, basis, (start, end), largest)
    starts = [
        found
        for coefficients in (np.zeros(basis.shape[1]), guess)
        if (found := holding.held(coefficients)) is not None
    ]
    if not starts:
        return strip
    best = min(starts, key=lambda one: one.strayed)
    for _ in range(LOOKS):
        beyond = left_beyond(design, best.strip.layout, strip.ends, best.strip.whole)
        near = _corrected(holding, best, beyond)
        if beyond is None or near is best:
            best = near
            break
        found = holding.held(near.coefficients)
        if found is None or found.strayed >= best.strayed:
            break
        best = found
        if best.strayed <= SAME_LEFT * near.strayed:
            break
    return best.strip


class _Held(NamedTuple):
    """A strip with corrected widths, its shape as held, and how far that strays from the design, mm."""

    strip: Strip
    coefficients: FloatArray
    rod: Rod
    strayed: float


@dataclass(frozen=True, eq=False)
class _Holding:
    """A strip whose widths are changed by a basis (n, m), held in its seats."""

    strip: Strip
    basis: FloatArray
    seats: Seats
    largest: float

    def held(self, coefficients: FloatArray, beyond: FloatArray | None = None) -> _Held | None:
        """With its widths changed; None where the style or the rest refuses it.

        With `beyond` its holes are not drawn: see `Strip.nearly_as_made`.
        """
        design, change, changed = self.strip.as_made.design, self.basis @ coefficients, self.strip
        try:
            if change.any():
                changed = replace(changed, correction=Profile.interpolate(design.s, np.exp(change)))
            made = changed.as_made if beyond is None else changed.nearly_as_made(beyond)
            rod = made.rest(self.seats)
        except (InputError, NotConvergedError):
            return None
        return _Held(changed, coefficients, rod, strayed(design, rod))


def _corrected(holding: _Holding, best: _Held, beyond: FloatArray | None) -> _Held:
    """The best that corrections come to, as smooth ones as suffice."""
    design = holding.strip.as_made.design
    for smoothing in SMOOTHINGS:
        damping = FIRST_DAMPING
        for _ in range(ROUNDS):
            if best.strayed <= ENOUGH_SHARE * design.length or damping > MOST_DAMPING:
                break
            coefficients = correct_widths(
                best.rod, best.rod.position - design.position, holding.basis, best.coefficients,
                damping=damping, smoothing=smoothing, largest=holding.largest,
            )  # fmt: skip
            found = holding.held(coefficients, beyond)
            if found is None or found.strayed >= best.strayed:
                damping *= DAMPED
                continue
            gain = found.strayed / best.strayed
            best, damping = found, damping / 3
            if gain > LEAST_GAIN:
                break
        if best.strayed <= LEFT_SHARE * design.length:
            break
    return best
