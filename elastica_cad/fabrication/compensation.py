"""Widths that make up for what slots, tabs, leaning ligaments and anticlastic bending do to a strip."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_one_of, require_positive, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.holding.held_shape import LEAST_TOLD_MM, closes, shape_responses, strayed
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials.splines import bezier_spans
from elastica_cad.mechanics.rod.rod_record import Rod

SPACING_SHARE = 1 / 24  # of the length: between knots of a correction, so that outlines stay smooth
SMOOTHING = 5e-3  # weight of the second differences of the coefficients against the drift that is left
SIZE = 7e-3  # the same of the coefficients themselves: of many changes that serve, the smallest


def _width_basis(s: FloatArray, *, closed: bool = False) -> FloatArray:
    """Cubic B-splines (n, m) at even stations s (n,) of a strip; of a closed one both ends share theirs."""
    pieces = round(1 / SPACING_SHARE)
    knots = np.concatenate([np.zeros(3), np.linspace(0.0, s[-1], pieces + 1), np.full(3, s[-1])])
    one = np.eye(pieces + 3)
    if closed:
        one[0, -1] = 1.0
        one = one[:, 1:]
    return np.asarray(bezier_spans(knots, 3).basis(s) @ one)


def _correct_widths(
    made: Rod, drift: FloatArray, basis: FloatArray, kept: FloatArray, *, largest: float
) -> FloatArray:
    """Coefficients (m,) of the change of width that takes a drift back, to first order.

    A change f of the width changes moment and weight by M f and p f at the same shape. Many changes leave the shape
    alone (all that keep K kappa = M0 + <b, gamma>); the smallest and smoothest one is taken.

    Parameters
    ----------
    made : Rod
        As made and held, in balance.
    drift : (n, 2) array
        Of its nodes from the design, mm.
    basis : (n, m) array
        Of the changes: see `_width_basis`. Of a closed strip only its shape counts, not where it lies.
    kept : (m,) array
        Coefficients of the change that the rod has already.
    largest : float
        No coefficient goes beyond it.
    """
    moved = shape_responses(
        made, made.moment[:, None] * basis, made.nodal_load[:, None, :] * basis[:, :, None]
    )
    A, left = np.moveaxis(moved[1:], 1, 2).reshape(-1, basis.shape[1]), drift[1:].ravel()
    if closes(made):
        A, left = _without_motion(made.position[1:], A), _without_motion(made.position[1:], left)
    scale = float(np.abs(A).max()) * np.sqrt(len(A))
    one = np.eye(basis.shape[1])
    # the whole change is to be small and smooth
    whole = scale * np.concatenate([SMOOTHING * np.diff(one, n=2, axis=0), SIZE * one])
    system, wanted = np.concatenate([A, whole]), np.concatenate([-left, -whole @ kept])
    from scipy.optimize import lsq_linear

    return np.asarray(kept + lsq_linear(system, wanted, (-largest - kept, largest - kept), method="bvls").x)


def _without_motion(position: FloatArray, moves: FloatArray) -> FloatArray:
    """Moves (2 n, ...) of points (n, 2) without what shifts and turns them all."""
    x, y = (position - position.mean(axis=0)).T
    one, none = np.ones(x.size), np.zeros(x.size)
    rigid = np.array([np.column_stack(row).ravel() for row in ((one, none), (none, one), (-y, x))])
    rigid /= np.linalg.norm(rigid, axis=1)[:, None]
    return np.asarray(moves - rigid.T @ (rigid @ moves))


ROUNDS = 8
LEAST_GAIN = 0.97  # of what is left in one round: a round that leaves more is the last
LARGEST_GUESS = 0.5  # of the logarithm of a width's change
ENOUGH_SHARE = 1e-5  # of the length: a deviation that needs no correction


def compensate_widths(strip: Strip, *, largest: float = np.inf) -> Strip:
    """The strip with widths that bring it, as it is made and held as designed, back to its design.

    Bent forward as made (`Strip.held`) it strays; its widths are changed smoothly, to first order, and that is
    repeated as long as it helps. What is left is `Strip.held().deviation`.

    Parameters
    ----------
    strip : Strip
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
    strip = replace(strip, correction=None) if strip.correction is not None else strip
    design = strip.as_made.design
    basis = _width_basis(design.s, closed=strip.is_closed)
    # a first guess: as much wider as each place is softer, evened out along the strip
    softer = -np.log(np.prod([np.ones(design.s.size), *strip.as_made.shares.values()], axis=0))
    clip = min(LARGEST_GUESS, largest)
    guess = np.clip(np.linalg.lstsq(basis, softer - softer.mean(), rcond=None)[0], -clip, clip)
    drawn, guessed = (_held(strip, basis, start) for start in (np.zeros(basis.shape[1]), guess))
    best = min(filter(None, (drawn, guessed)), key=lambda one: one.strayed, default=None)
    if best is None:
        return strip
    step = 1.0
    for _ in range(ROUNDS):
        if best.strayed <= ENOUGH_SHARE * design.length:
            break
        drift = best.rod.position - design.position
        wanted = _correct_widths(best.rod, drift, basis, best.coefficients, largest=largest)
        coefficients = best.coefficients + step * (wanted - best.coefficients)
        found = _held(strip, basis, coefficients)
        if found is None or found.strayed >= best.strayed:
            step /= 2
            continue
        gain, best, step = found.strayed / best.strayed, found, min(1.0, 2 * step)
        if gain > LEAST_GAIN:
            break
    gained = np.inf if drawn is None else drawn.strayed - best.strayed
    return best.strip if gained >= LEAST_TOLD_MM else strip


class _Held(NamedTuple):
    """A strip with corrected widths, its shape as held, and how far that strays from the design, mm."""

    strip: Strip
    coefficients: FloatArray
    rod: Rod
    strayed: float


def _held(strip: Strip, basis: FloatArray, coefficients: FloatArray) -> _Held | None:
    """A strip with its widths changed by a basis (n, m), held; None where the style or the rest refuses it."""
    design, change = strip.as_made.design, basis @ coefficients
    try:
        if change.any():
            strip = replace(strip, correction=Profile.interpolate(design.s, np.exp(change)))
        rod = strip.as_made.rest()
    except (InputError, NotConvergedError):
        return None
    return _Held(strip, coefficients, rod, strayed(design, rod.position))
