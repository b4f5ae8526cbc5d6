"""Rods that are said to meet their limits, checked otherwise: balance, ratio, curvature, margin, distance.

python -m tests.campaign.trust.met_checks --solves 10000 --seed 1 --minutes 60

Control points, limits, weight, what is kept are drawn at random; every rod that is `met` is asked again by finite
elements and sums over nodes, which share nothing with the solver but the record of the rod.
"""

import random
import traceback
import warnings
from types import SimpleNamespace

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.linalg import eigh, null_space

import elastica_cad as ec
from tests.campaign.trust.numbered_cases import arguments, run_cases

WILD = 0.04
"""Share of requests with far points, hard limits and free ends, which take a second or more each."""

LOOSE = 1e-6
"""Relative: limits are met to rounding, not to a share."""

UNBALANCED = 1e-2
"""Of the largest moment: what 200 edges leave where the stiffness grows tenfold within a few of them."""

COARSE = 5e-3
"""Relative: what finite elements over 200 edges leave of a margin, in shares of the larger of the two terms whose
difference it is, and sums over points of a distance."""

FINER = 4
"""Nodes between those of a record, on splines through it, so that sums see the rod and not its edges."""


def request(rng):
    """A curve, limits, what is kept, weight and measure: most as people draw, the others wild."""
    wild = rng.random() < WILD
    count = rng.randint(4, 8 if wild else 6)
    x = np.cumsum([rng.uniform(5 if wild else 30, 60) for _ in range(count)])
    points = [(a, rng.uniform(-80, 80) if wild else rng.uniform(-25, 25)) for a in x]
    limits = {"ratio": rng.choice((1.0, 1.2, 1.6, 2.5, 4.0, 10.0) if wild else (1.6, 2.5, 4.0, 10.0))}
    if wild and rng.random() < 0.3:
        del limits["ratio"]
    if rng.random() < (0.4 if wild else 0.2):
        limits["margin"] = rng.choice((0.5, 2.0, 5.0, 15.0) if wild else (0.5, 2.0))
    if rng.random() < (0.3 if wild else 0.15):
        limits["curvature"] = rng.choice((0.01, 0.03, 0.08) if wild else (0.05, 0.08))
    keep = rng.choice(
        (
            {},
            {},
            {"tangents": True},
            {"length": True},
            *({"ends": (True, False)}, {"ends": False})[: 2 * wild],
        )
    )
    weight = rng.choice((None, None, 60.0, 120.0, 400.0))
    return (
        points,
        limits,
        keep,
        weight,
        rng.choice(("mean", "max")),
    )


def finely(rod):
    """The record of a rod on more nodes."""
    s = np.linspace(0.0, rod.length, FINER * (len(rod.s) - 1) + 1)
    smooth = {"angle": rod.angle, "force": rod.force, "moment": rod.stiffness * rod.curvature}
    return SimpleNamespace(
        s=s, length=rod.length, stiffness=PchipInterpolator(rod.s, rod.stiffness)(s),  # which may jump
        **{name: CubicSpline(rod.s, values)(s) for name, values in smooth.items()},
    )  # fmt: skip


def balance_defect(rod):
    """Largest miss of M' = <force, R gamma'>, where weight changes the force, in shares of the largest moment.

    Sums over the nodes by the trapezoidal rule; the moment is K kappa of the record.
    """
    s, tangent = rod.s, np.column_stack([np.cos(rod.angle), np.sin(rod.angle)])
    across = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    slope = (rod.force * across).sum(axis=1)
    moment = rod.moment
    grown = np.concatenate([[0.0], np.cumsum((slope[1:] + slope[:-1]) / 2 * np.diff(s))])
    off = moment - moment[0] - grown
    size = max(np.abs(moment).max(), 1e-12)
    return float(np.abs(off).max() / size)


def margin_by_elements(rod, clamped=(True, True)):
    """Least eigenvalue of K h'^2 - <force, gamma'> h^2 against h^2 on h that keep the ends, times length^2; and
    the largest <force, gamma'>, times length^2."""
    s, angle, stiffness = rod.s[::2], rod.angle[::2], rod.stiffness[::2]
    tangent = np.column_stack([np.cos(angle), np.sin(angle)])
    pull, h, n = (rod.force[::2] * tangent).sum(axis=1), s[1] - s[0], len(s)
    middle = (stiffness[1:] + stiffness[:-1]) / 2 / h
    stretch = np.zeros((n, n))
    i = np.arange(n - 1)
    stretch[i, i] += middle
    stretch[i + 1, i + 1] += middle
    stretch[i, i + 1] -= middle
    stretch[i + 1, i] -= middle
    share = np.full(n, h)
    share[[0, -1]] /= 2
    form = stretch - np.diag(pull * share)
    rows = [(-np.sin(angle)) * share, np.cos(angle) * share]
    free = np.ones(n, dtype=bool)
    free[0], free[-1] = not clamped[0], not clamped[1]
    basis = null_space(np.array(rows)[:, free])
    small = basis.T @ form[np.ix_(free, free)] @ basis
    mass = basis.T @ (share[free, None] * basis)
    least = eigh(small, mass, eigvals_only=True, subset_by_index=[0, 0])[0]
    return float(least * rod.length**2), float(np.abs(pull).max() * rod.length**2)


def faults(near, points, limits, keep):
    """What of a rod that is said to meet its limits does not."""
    rod, target = near.rod, near.target
    found = []
    ratio = float(rod.stiffness.max() / rod.stiffness.min())
    if "ratio" in limits and ratio > limits["ratio"] * (1 + LOOSE):
        found.append(f"ratio {ratio}, {limits['ratio']} allowed")
    bend = float(np.abs(rod.curvature).max())
    if "curvature" in limits and bend > limits["curvature"] * (1 + LOOSE):
        found.append(f"curvature {bend}, {limits['curvature']} allowed")
    fine = finely(rod)
    if (off := balance_defect(fine)) > UNBALANCED:
        found.append(f"balance missed by {off:.2g}")
    if "margin" in limits:
        margin, pull = margin_by_elements(fine)
        if margin < limits["margin"] - COARSE * max(10.0, abs(margin), pull):
            found.append(f"margin {margin:.4g}, {limits['margin']} asked for")
    ends = keep.get("ends", True)
    ends = (ends, ends) if isinstance(ends, bool) else ends
    drawn = np.array([points[0], points[-1]], dtype=float)
    gone = np.hypot(*(rod.position[[0, -1]] - drawn).T)
    if any(kept and away > LOOSE * rod.length for kept, away in zip(ends, gone, strict=True)):
        found.append(f"ends moved by {gone}")
    if keep.get("length") and abs(rod.length - target.length) > LOOSE * target.length:
        found.append(f"length {rod.length}, {target.length} kept")
    dense = target.sample(4001).position
    far = max(float(np.hypot(*(dense - place).T).min()) for place in rod.position[::10])
    if far > near.deviation + COARSE * target.length:
        found.append(f"{far:.4g} mm away, {near.deviation:.4g} told")
    return found


def solved(seed, number):
    """How one solve ended, and what is wrong with it."""
    points, limits, keep, weight, measure = request(random.Random(f"{seed} {number}"))
    gravity = None if weight is None else ec.Gravity(weight, (0, -1))
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            curve = ec.PlaneCurve.spline(points, degree=3)
            near = ec.nearest_rod(curve, ec.Limits(**limits), ec.Keep(**keep), gravity, measure=measure)
            ended, wrong = near.status.name, faults(near, points, limits, keep) if near.met else []
        except ec.ElasticaError:
            ended, wrong = "sentence", []
        except Exception:
            ended, wrong = "traceback", [traceback.format_exc(limit=-4)]
    if warned:
        wrong = [*wrong, f"warning: {warned[0].filename}:{warned[0].lineno}: {warned[0].message}"]
    return ended, wrong


def main():
    query = arguments(__doc__, "solves", 10_000, minutes=120.0)
    run_cases(query, "mets", "solves", solved)


if __name__ == "__main__":
    main()
