"""What corners beside slots, steps and tabs add to a strip: plates of their own, from which the coefficients came.

python -m tests.campaign.finite_elements.idle_corners

Thin orthotropic plates (Kirchhoff) on rectangular grids, elements of sixteen unknowns that are exact to third order
(Bogner, Fox and Schmit 1965). One end of a strip is turned by a unit angle; what the moment lacks beside a strip
without a cut is the length of strip that the cut stands for. Slots are printed over `crack_energy` of an even
sheet beside `CUT` times the power `CUT_GRAIN` of sqrt(E / G), steps and tabs over `idle_length` times
`crack_energy`, at the plate's own E across, beside `STEP` and `TAB`. Behind @ is the place where a tab's length
acts, in widths that the tab lacks, beside `TAB_REACH` times sqrt(E / G). Last is what a clamp of the whole width
takes away, in nu^2 widths, beside `RESTRAINT`.
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.linalg import spsolve

from elastica_cad.mechanics import crack_energy
from elastica_cad.strip.as_made import CUT, CUT_GRAIN, RESTRAINT, STEP, TAB, TAB_REACH, idle_length

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)
W, WX, WY, WXY = range(4)
"""Unknowns of a node: deflection and its derivatives."""

LONG = 3.0
"""Widths from the cut to the end of the plate."""

TURN = np.array([WX, WXY])
ALL = np.arange(4)


def hermite(t: float, a: float, order: int) -> np.ndarray:
    """Cubics of value and slope at both ends of an element of length a, or their derivatives, at t in 0..1."""
    powers = {
        0: (1 - 3 * t**2 + 2 * t**3, a * (t - 2 * t**2 + t**3), 3 * t**2 - 2 * t**3, a * (t**3 - t**2)),
        1: ((6 * t**2 - 6 * t) / a, 1 - 4 * t + 3 * t**2, (6 * t - 6 * t**2) / a, 3 * t**2 - 2 * t),
        2: ((12 * t - 6) / a**2, (6 * t - 4) / a, (6 - 12 * t) / a**2, (6 * t - 2) / a),
    }
    return np.array(powers[order])


def element(a: float, b: float, D: np.ndarray) -> np.ndarray:
    """Stiffness (16, 16) of a rectangle; nodes (0, 0), (0, b), (a, 0), (a, b)."""
    K = np.zeros((16, 16))
    for x, wx in zip((POINTS + 1) / 2, WEIGHTS / 2, strict=True):
        for y, wy in zip((POINTS + 1) / 2, WEIGHTS / 2, strict=True):
            bends = []
            for dx, dy, factor in ((2, 0, 1), (0, 2, 1), (1, 1, 2)):
                along = hermite(x, a, dx).reshape(2, 1, 1, 2)  # end, value or slope
                across = hermite(y, b, dy).reshape(1, 2, 2, 1)
                bends.append(factor * (along * across).reshape(16))
            B = np.array(bends)
            K += wx * wy * a * b * B.T @ D @ B
    return K


def moment(
    x: np.ndarray, y: np.ndarray, there: np.ndarray, D: np.ndarray, *,
    at_start: Callable[[float], Sequence[int]], symmetric: bool,
) -> tuple[float, float]:  # fmt: skip
    """Moment that turns the end x[-1] by a unit angle, and mean deflection of that end.

    `there` (n-1, m-1) says which rectangles are; `at_start` says which unknowns are held at x[0], `symmetric`
    that y[0] is a line of symmetry.
    """
    number = np.arange(x.size * y.size).reshape(x.size, y.size)
    known: dict[tuple[float, float], np.ndarray] = {}
    dofs, values = [], []
    for i, j in np.argwhere(there):
        size = round(x[i + 1] - x[i], 9), round(y[j + 1] - y[j], 9)
        if size not in known:
            known[size] = element(*size, D)
        nodes = number[[i, i, i + 1, i + 1], [j, j + 1, j, j + 1]]
        dofs.append((4 * nodes[:, None] + ALL).ravel())
        values.append(known[size].ravel())
    rows = np.array(dofs)
    count = 4 * number.size
    where = (np.repeat(rows, 16, axis=1).ravel(), np.tile(rows, 16).ravel())
    K = coo_array((np.concatenate(values), where), shape=(count, count)).tocsc()
    free, u = np.zeros(count, dtype=bool), np.zeros(count)
    free[rows] = True
    for node, height in zip(number[0], y, strict=True):
        free[[4 * node + k for k in at_start(height)]] = False
    end = 4 * number[-1]
    u[end + WX] = 1.0
    free[end[:, None] + TURN] = False
    if symmetric:
        free[4 * number[:, 0, None] + np.array([WY, WXY])] = False
    if W not in at_start(y[0]):  # nothing else holds it in its place
        free[end[0] + W] = False
    u[free] = spsolve(K[free][:, free], -(K @ u)[free])
    return float(u @ (K @ u)), float(
        np.sum((u[end[1:] + W] + u[end[:-1] + W]) / 2 * np.diff(y)) / (y[-1] - y[0])
    )


def finer(places: Sequence[float], count: int = 12, growth: float = 1.25) -> np.ndarray:
    """Grid lines that get denser towards the inner places from the outer ones."""
    steps = np.cumsum(growth ** np.arange(count)) / np.sum(growth ** np.arange(count))
    low, *inner, high = places
    lines = [*places]
    for at in inner:
        lines += [*(at + (high - at) * steps), *(at + (low - at) * steps)]
    return np.unique(np.round(lines, 9))


def added(kind: str, share: float, D: np.ndarray) -> tuple[float, float]:
    """Length that a slot of a depth, a tab or a narrower part of a width, shares of 1, adds to a strip 1 wide, and
    where it acts beside a tab."""
    E = 1 / np.linalg.inv(D)[0, 0]
    if kind == "slot":  # of no width; half of the plate, that opens on one side
        y, x = finer((-0.5, 0.5 - share, 0.5)), finer((-1e-9, 0.0, LONG), 24)[1:]
        there = np.ones((x.size - 1, y.size - 1), dtype=bool)
        held, _ = moment(
            x, y, there, D, symmetric=False, at_start=lambda at: TURN if at <= 0.5 - share else ()
        )
        return 2 * (E / held - LONG), 0.0
    y = finer((0.0, share / 2, 0.5)) if share < 1 else finer((0.0, 0.25, 0.5))
    if kind == "tab":
        x = finer((-1e-9, 0.0, LONG), 24)[1:]
        there = np.ones((x.size - 1, y.size - 1), dtype=bool)
        held, high = moment(
            x, y, there, D, symmetric=True, at_start=lambda at: ALL if at <= share / 2 else ()
        )
        length = E / (2 * held) - LONG
        return length, LONG - (high * (LONG + length) - LONG**2 / 2) / length
    x = finer((-LONG, 0.0, LONG), 20)
    there = (x[1:, None] > 1e-9) | (y[None, 1:] <= share / 2)
    held, _ = moment(x, y, there, D, symmetric=True, at_start=lambda at: TURN if at <= share / 2 else ())
    return E / (2 * held) - LONG - LONG / share, 0.0


def plate(nu: float, ratio: float, across: float) -> np.ndarray:
    """Rigidities (3, 3) for E = 1 along, E / G = ratio, and E across."""
    d = 1 - nu**2 * across
    return np.array([[1 / d, nu * across / d, 0], [nu * across / d, across / d, 0], [0, 0, 1 / ratio]])


def own_energy(nu: float, ratio: float, across: float) -> float:
    """`crack_energy` of a plate whose E across is known (`plate`), with nu along."""
    r, g = np.sqrt(across), 1 / ratio
    return float(np.pi / 2 * np.sqrt(2 * (nu * r**2 + 2 * (1 - nu**2 * across) * g + r)) / (r + 4 * g))


def main() -> None:
    print("nu, E/G, E across | slots of 0.3, 0.5: fitted | steps to 0.2, 0.5, 0.8; tabs of 0.2, 0.5 | clamp")
    print(f"steps {STEP:g}, tabs {TAB:g} @ {TAB_REACH:g} sqrt(E / G), clamp {RESTRAINT:g}")
    for nu, across in ((0.0, 1.0), (0.3, 1.0), (0.1, 0.3), (0.1, 0.0625)):
        for ratio in (2 * (1 + nu), 8.0, 15.0, 26.0):
            D, grain = plate(nu, ratio, across), np.sqrt(ratio / (2 * (1 + nu)))
            energy = own_energy(nu, ratio, across)
            slots = [added("slot", depth, D)[0] / depth**2 / crack_energy(nu) for depth in (0.3, 0.5)]
            steps = [added("step", one, D)[0] / idle_length(1, one, 0) / energy for one in (0.2, 0.5, 0.8)]
            tabs = [(one, *added("tab", one, D)) for one in (0.2, 0.5)]
            beside = [
                f"{a / idle_length(1, one, 0) / energy:5.2f} @ {at / (1 - one):4.2f}" for one, a, at in tabs
            ]
            clamp = -added("tab", 1.0, D)[0] / nu**2 if nu else 0.0
            print(f"{nu:g} {ratio:4.1f} {across:6g} | {' '.join(f'{one:5.2f}' for one in slots)} : "
                  f"{CUT * grain**CUT_GRAIN:.2f} | {' '.join(f'{one:5.2f}' for one in steps)} ; "
                  f"{' '.join(beside)} : {TAB_REACH * grain:.2f} | {clamp:.2f}", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
