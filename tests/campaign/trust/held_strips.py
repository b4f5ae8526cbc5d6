"""Random strips on rails, pins and ties, checked otherwise: least ratio, balance, rest, stability.

python -m tests.campaign.trust.held_strips --curves 200 --seed 1 --minutes 60

The least ratio is compared with a dense linear program, the balance with sums over forces on an arc length
integrated here. Strips of a ratio of at most 8 are also chains of edges. The energy of one chain is minimised with
one-sided distances by Newton's method. The second variation of the other, with sliding contact, is differentiated
numerically.
Results of chains of n and 2 n edges are extrapolated to the continuous strip. n is 30. It is doubled up to 480
while the results differ, because the error of a chain depends on the places of the elements between its nodes. For
seed 1038 the margins of chains of 240, 480, 960 and 1920 edges are 10.29, 9.06, 8.74 and 8.78.
"""

import traceback
from dataclasses import replace

import numpy as np

import elastica_cad as ec
from elastica_cad.mechanics.bracing import SLACK_SHARE
from elastica_cad.mechanics.stability import SAFE_MARGIN
from tests.campaign.trust.numbered_cases import arguments, run_cases
from tests.validation.test_forces_between_ends import (
    HELD,
    Chain,
    LoadedChain,
    det,
    random_case,
    rod_or_none,
)

LARGEST_RATIO = 100.0
"""Ratios above this are compared only as impossible."""

SAMPLES = 6001
"""Samples of the program. Of 1501, 6001 and 24001 samples, the ratio of seed 1166 is 86.645, 86.824 and 86.830."""

BENT_RATIO = 8.0
"""Largest ratio of a strip that a person makes."""

BALANCE = 1e-8
"""Largest imbalance, as a fraction of the largest moment."""

REST = 1e-4
"""Largest distance of the rest shape from the drawn curve, as a fraction of the length."""

MARGIN = 0.02
"""Largest difference of the margins, as a fraction of the larger of the margin and `SAFE_MARGIN`."""

TAUT = 0.02
"""Force of a one-sided element, as a fraction of the largest force, below which the chain counts it as slack."""

EDGES = 30, 60, 120, 240, 480
"""Numbers of edges of the coarse chain, of which the next is used if one disagrees."""


def arc_lengths(dense, t):
    """Arc lengths at parameters t by a Gauss rule on 400 pieces and one more to t."""
    x, w = np.polynomial.legendre.leggauss(12)
    edges = np.linspace(0, 1, 401)

    def integral(a, b):
        places = (a + b)[:, None] / 2 + (b - a)[:, None] / 2 * x
        return (np.hypot(*np.moveaxis(dense.derivatives[1](places), -1, 0)) @ w) * (b - a) / 2

    before = np.concatenate([[0.0], np.cumsum(integral(edges[:-1], edges[1:]))])
    piece = np.minimum((t * 400).astype(int), 399)
    return before[piece] + integral(edges[piece], t)


def parameters(dense, s):
    """Parameters at arc lengths s by Newton's method."""
    t = dense.parameter(s)
    for _ in range(4):
        t = np.clip(t - (arc_lengths(dense, t) - s) / np.hypot(*dense.derivatives[1](t).T), 0, 1)
    return t


def imbalance(rod, dense):
    """Largest |K kappa - M| over the largest |M|, with M as a sum over forces."""
    t = parameters(dense, rod.s)
    position = dense.derivatives[0](t)
    d1, d2 = dense.derivatives[1](t), dense.derivatives[2](t)
    kappa = det(d1, d2) / np.hypot(*d1.T) ** 3
    M = rod.moment[0] - det(rod.force[0], position - position[0])
    for action in rod.between:
        places = dense.derivatives[0](parameters(dense, action.s))
        for s, place, force in zip(action.s, places, action.force, strict=True):
            M = M - np.where(rod.s > s, det(force, position - place), 0.0)
    return np.abs(rod.stiffness * kappa - M).max() / np.abs(M).max()


def mounted(rod):
    """The elements of a rod at their points in space, ties with their lengths."""
    for action in rod.between:
        places = rod.curve.at(action.s).position
        if isinstance(action.element, ec.Tie):
            yield replace(action.element, length=float(np.hypot(*np.diff(places, axis=0)[0])))
        else:
            yield replace(action.element, at=(*places[0].tolist(),))


def extrapolated(coarse, fine):
    """Limit of values whose error falls with the square of the number of edges."""
    return (4 * fine - coarse) / 3


def bent_faults(rod, edges):
    """What is wrong with rest and stability by chains of `edges` and twice as many edges."""
    margin = ec.stability(rod).margin
    largest = np.abs(rod.force).max()
    sizes = np.array([action.size / largest for action in rod.between])
    loose = np.array([action.is_one_sided for action in rod.between]) & (sizes <= TAUT)
    taut = tuple(action for action, slack in zip(rod.between, loose, strict=True) if not slack)
    lowest = extrapolated(*(Chain(replace(rod, between=taut), n).settled()[0] for n in (edges, 2 * edges)))
    found = []
    # between these sizes the core counts an element that the chain does not
    if not (loose & (sizes > SLACK_SHARE)).any() and abs(margin - lowest) > MARGIN * max(
        abs(lowest), SAFE_MARGIN
    ):
        found.append(f"margin {margin:.6g}, of the chain {lowest:.6g}")
    if min(margin, lowest) < 1:
        return "unstable", found
    try:
        coarse, fine = (LoadedChain(rod, tuple(mounted(rod)), (), n).rest()[0] for n in (edges, 2 * edges))
    except AssertionError:
        return "stable", [*found, f"a chain of {edges} or {2 * edges} edges is not at rest"]
    drawn = rod.curve.at(np.linspace(0, rod.length, edges + 1)).position
    far = np.hypot(*(extrapolated(coarse, fine[::2]) - drawn).T).max() / rod.length
    if far > REST:
        found.append(f"rests {far:.3g} L from the curve")
    return "stable", found


def judged(seed, number):
    """How a strip ended, and what is wrong with it."""
    number += 1000 * seed
    try:
        points, dense, elements = random_case(number, 6 + number % 3)
        sides = np.random.default_rng(number).integers(2, size=len(elements))
        elements = [
            replace(element, one_sided=bool(side)) if isinstance(element, ec.Rail) else element
            for element, side in zip(elements, sides, strict=True)
        ]
        least, rod = dense.ratio(elements, SAMPLES), rod_or_none(points, elements)
        if least > LARGEST_RATIO or rod is None:
            agrees = rod is None or rod.ratio > 0.9 * LARGEST_RATIO if least > LARGEST_RATIO else False
            return "impossible", [] if agrees else [f"ratio {rod and rod.ratio}, of the program {least}"]
        found = []
        if not HELD[0] * least <= rod.ratio <= HELD[1] * least + 1e-3:
            found.append(f"ratio {rod.ratio:.6g}, of the program {least:.6g}")
        off = imbalance(rod, dense)
        if off > BALANCE:
            found.append(f"imbalance {off:.3g}")
        if rod.ratio > BENT_RATIO:
            return "above 8", found
        for edges in EDGES:
            ended, more = bent_faults(rod, edges)
            if not more:
                break
        return ended, found + more
    except Exception:
        return "error", [traceback.format_exc(limit=-3)]


def main():
    request = arguments(__doc__, "curves", 200, minutes=120.0)
    run_cases(request, "held", "curves", judged)


if __name__ == "__main__":
    main()
