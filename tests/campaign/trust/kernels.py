"""Compiled kernels under the compiler's sanitizers: odd sizes, dependent rows, numbers that are none, wrong arrays.

python -m tests.campaign.trust.kernels --cases 20000
Needs gcc. What reads or writes beyond its arrays, or overflows an integer, ends the process with a report.
"""

import argparse
import os
import shutil
import subprocess
import sys
import sysconfig
import tomllib
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
SANITIZERS = ("asan", "ubsan")
FLAGS = ("-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fPIC", "-shared")
MOST_S = 3000.0


def build(folder):
    """The package with kernels that watch themselves, in `folder`."""
    leave_out = shutil.ignore_patterns("__pycache__", "*.so")
    shutil.copytree(ROOT / "elastica_cad", folder / "elastica_cad", ignore=leave_out)
    asked = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (extension,) = asked["tool"]["setuptools"]["ext-modules"]
    macros = [f"-D{name}={value}" for name, value in extension["define-macros"]]
    include = f"-I{sysconfig.get_path('include')}"
    target = "elastica_cad/_native/kernels.abi3.so"
    subprocess.run(
        ["gcc", *FLAGS, *macros, include, *extension["sources"], "-o", target], check=True, cwd=folder
    )


def ask_apart(cases, seed):
    """The finished process that asked so many cases of kernels that watch themselves."""
    with TemporaryDirectory() as place:
        folder = Path(place)
        build(folder)
        loaded = [
            subprocess.run(
                ["gcc", f"-print-file-name=lib{name}.so"], check=True, capture_output=True, text=True
            ).stdout.strip()
            for name in SANITIZERS
        ]
        return subprocess.run(
            [sys.executable, __file__, "--here", "--cases", str(cases), "--seed", str(seed)],
            env=dict(os.environ)
            | {"LD_PRELOAD": ":".join(loaded), "ASAN_OPTIONS": "detect_leaks=0", "PYTHONPATH": str(folder)},
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=MOST_S,
            check=False,
        )


def ask_here(cases, seed):
    """Ask the kernels that this process finds; how many wrong arrays were refused, of how many."""
    from elastica_cad._native import kernels

    rng = np.random.default_rng(seed)
    for case in range(cases):
        with np.errstate(all="ignore"):
            ask_programs(rng, case)
        ask_modes(kernels, rng, case)
        ask_distances(kernels, rng, case)
        ask_polynomials(kernels, rng, case)
        ask_arc_lengths(kernels, rng, case)
        ask_vertices(kernels, rng, case)
        ask_splines(kernels, rng, case)
        ask_places(kernels, rng, case)
    return refused_arrays(kernels)


def ask_programs(rng, case):
    """A program with rows that say the same, say nothing, or hold no number."""
    from elastica_cad.forming.optimizer import quadratic_program as programs

    p, m = int(rng.integers(1, 40)), int(rng.integers(0, 60))
    J, A = rng.normal(size=(int(rng.integers(1, 2 * p + 1)), p)), rng.normal(size=(m, p))
    H = J.T @ J * (rng.random() < 0.8) + 1e-9 * np.eye(p)
    if m > 3 and case % 3 == 0:
        A[1], A[2] = A[0], 0
    if m and case % 50 == 0:
        A[0, 0] = np.nan
    if case % 70 == 0:
        H[0, 0] = np.inf
    lower, upper, given = -rng.random(p), rng.random(p), rng.random(p) < 0.2
    upper[given] = lower[given]
    asked = programs.QuadraticProgram(
        H, rng.normal(size=p) * 10 ** rng.uniform(-6, 6), lower, upper, A, rng.normal(size=m),
        10 ** rng.uniform(-3, 5, m), rng.random(m) < 0.5,
    )  # fmt: skip
    programs.solve_quadratic(asked)
    if not given.any():
        programs._by_interior_points(asked, 1e-10)


def ask_modes(kernels, rng, case):
    """The lowest mode of matrices that are rough, empty, huge or no numbers."""
    n, rows, smooth = int(rng.integers(2, 300)), int(rng.integers(0, 3)), int(rng.integers(1, 17))
    diagonal = rng.normal(size=n) * 10 ** rng.uniform(-3, 300 if case % 40 == 0 else 6)
    off = rng.normal(size=n - 1)
    if case % 30 == 0:
        diagonal[0] = np.nan
    if case % 31 == 0:
        diagonal[:], off[:] = 0, 0
    polynomials = np.linalg.qr(rng.normal(size=(max(n, smooth), smooth)))[0][:n].copy()
    kernels.lowest_mode(
        diagonal, off, rng.random(n) + 0.01, rng.normal(size=(rows, n)) * (case % 17 > 0), polynomials,
        (smooth, 8, 1e-9, 1e-15, 2e-16, 1e-5), np.empty(n), np.empty(2),
    )  # fmt: skip


def ask_distances(kernels, rng, case):
    """Points far from their chain, and places that are no numbers."""
    count, nodes = int(rng.integers(1, 300)), int(rng.integers(2, 300))
    points, chain = rng.normal(size=(count, 2)) * 10 ** rng.uniform(-3, 3), rng.normal(size=(nodes, 2))
    if case % 20 == 0:
        chain[0] = np.nan
    if case % 21 == 0:
        points[0] = np.inf
    kernels.largest_distance(points, chain, np.empty(count))
    kernels.weighted_gram(chain, rng.random(nodes), rng.random(nodes), np.empty((2, 2)))
    kernels.hermite(chain, chain, points[:, 0].copy(), np.empty((count, 2)), np.empty((count, 2)))
    shape = np.empty((count, 2)), np.empty((count + 1, 2)), np.empty(count), np.empty(count)
    kernels.shape(points[:, 0].copy(), points, chain[0].copy(), 0.1, *shape)
    nodes, edges = rng.random(count + 1), rng.random(count)
    held = [bool(rng.integers(2)) for _ in range(4)]
    rows = np.empty((sum(held[2:]), count))
    kernels.second_variation(
        nodes, nodes, edges, edges, points, *held, 1e-9, edges.copy(), np.empty(count - 1), rows
    )


def odd(rng, case, *shape):
    """Numbers of any size, one of them none now and then."""
    numbers = rng.normal(size=shape) * 10 ** rng.uniform(-9, 300 if case % 40 == 0 else 6)
    if case % 9 == 0 and numbers.size:
        numbers.flat[int(rng.integers(numbers.size))] = rng.choice([np.nan, np.inf, 0.0])
    return numbers


def ask_polynomials(kernels, rng, case):
    """Sums at places within their pieces and far outside; extremes; places of arrays that are none of them."""
    pieces, terms, columns, places = (int(n) for n in rng.integers(1, 33, 4))
    which, out = rng.integers(0, pieces, places), np.empty((places, columns))
    series, x = odd(rng, case, pieces, terms, columns), odd(rng, case, places)
    kernels.legendre_sums(series, (pieces, terms), which, x, out)
    kernels.bernstein_sums(series, (pieces, terms - 1, columns, 0), which, x, out)
    knots, points = np.sort(odd(rng, case, pieces, 2 * columns + 1 + terms), axis=1), np.empty((places, 2))
    rows = knots, odd(rng, case, pieces, columns + terms, 3), odd(rng, case, pieces, 2)
    kernels.spline_motion(columns, rows, which, x, points, points.copy())
    kernels.locate(odd(rng, case, pieces + 1), case % 2, -1.0, x, which.copy(), np.empty(places))
    if columns > 1:
        curve = odd(rng, case, pieces + 1), case % 2, odd(rng, case, pieces, 2)
        kernels.curve_at(series, (pieces, terms, columns), *curve, x, np.empty((places, columns)))
    count, found = pieces * 25, np.empty((2, pieces * 25), dtype=np.intp)
    kernels.extremes(
        odd(rng, case, pieces, 12), rng.normal(size=(25, 12)), np.linspace(-1, 1, 25),
        rng.normal(size=(12, 12)), (int(rng.integers(0, 4)), 0.05, 0.15), np.empty(count), *found, np.empty(count),
    )  # fmt: skip
    which[0] = rng.choice([-1, pieces, 2**62])
    for ask, sizes in ((kernels.legendre_sums, (pieces, terms)),
                       (kernels.bernstein_sums, (pieces, terms - 1, columns, 0))):  # fmt: skip
        with suppress(IndexError):
            ask(series, sizes, which, x, out)
            raise AssertionError("a place outside its array was taken")


def ask_arc_lengths(kernels, rng, case):
    """Curves that stand still, run to infinity or have knots in no order; rooms that are too small."""
    from elastica_cad.geometry.curves import arc_length
    from elastica_cad.mechanics.stiffness import quadrature_panels as panels

    pieces, degree, room = int(rng.integers(1, 9)), int(rng.integers(0, 9)), int(rng.integers(1, 300))
    edges, series = odd(rng, case, pieces + 1), odd(rng, case, pieces, degree + 1, 8)
    if case % 3:
        edges.sort()
    if case % 5 == 0:
        series[:] = 0
    curve = series, (pieces, degree, 8, 2), edges
    starts, lengths = np.empty(room), np.empty((room, 17))
    settings = (2e-15, 1e-8, 2.0**-40, 1e-15)
    kernels.speed_panels(*curve, *arc_length._chebyshev(), settings, starts, lengths)
    count, met = room // 8 + 1, odd(rng, case, 32 * pieces - 1)
    table = edges, odd(rng, case, pieces + 1), odd(rng, case, pieces, 17)
    kernels.arc_lengths_at(*table, odd(rng, case, count), np.empty(count))
    kernels.parameters_at(
        *table, met, odd(rng, case, 32 * pieces, 6), 2e-8, 1e-8, odd(rng, case, count), np.empty(count)
    )
    flags = (rng.random((2, count)) < 0.3).astype(float)
    cut = odd(rng, case, count), odd(rng, case, count), *flags, odd(rng, case, int(rng.integers(0, 4)))
    rule = panels.NODES, panels.LEFT, panels.RIGHT, panels._LAST
    grid = (count, panels.ORDER)
    ends = tuple(np.empty((3, count)))
    nodes = np.empty(grid), np.empty((*grid, 2)), np.empty(grid), np.empty(grid)
    kernels.resolve_panels(*curve, rule, cut, rng.normal(), (1e-11, 1e-6, abs(rng.normal())), (*ends, *nodes))


def ask_splines(kernels, rng, case):
    """Knots in no order, spans that no place is in, control points that are not there; curves that stand still."""
    from elastica_cad.geometry.curves import arc_length, curve_derivatives

    spans, degree, columns = (int(n) for n in rng.integers(1, 13, 3))
    if case % 10 == 0:
        degree = 32
    size, count = degree + 1, degree + spans
    near, matrix = odd(rng, case, 2 * degree, spans), np.empty((spans, size, size))
    if case % 3:
        near.sort(axis=0)
    kernels.extraction(degree, near, matrix)
    first, widths = rng.integers(0, spans, spans), odd(rng, case, spans)
    sites, probes = (int(n) for n in rng.integers(1, 9, 2))
    rule = odd(rng, case, sites, size), rng.random(sites), odd(rng, case, probes, size)
    samples = odd(rng, case, spans, sites + probes, columns)
    kernels.fit_splines(
        degree, (first, widths, matrix), rule, samples, np.empty((count, size)), np.empty((count, columns)),
        np.empty(spans),
    )  # fmt: skip
    kernels.cubic_extremes(odd(rng, case, spans, 4), odd(rng, case, spans + 1))
    found = np.empty((2, 4 * spans), dtype=np.intp)
    kernels.bernstein_roots(
        odd(rng, case, spans, size), np.abs(odd(rng, case, spans)) * 10 ** rng.uniform(-20, 1),
        (48, 10.0, 4.0, 0.5, 0.4375, 0.578125), *found, np.empty((4 * spans, 2)),
    )  # fmt: skip
    numbers = int(rng.integers(2, 4))
    series = np.empty((spans, size, 4 * numbers))
    raised = curve_derivatives._all_raised(degree)
    pieces = odd(rng, case, count, 3), matrix, widths, odd(rng, case, spans, 2)
    kernels.derivative_series((degree, numbers), (first, *pieces), raised, series)
    table = odd(rng, case, spans + 1), odd(rng, case, spans + 1), odd(rng, case, spans, 17)
    kernels.inverse_cells(*table, *arc_length._IN_ROWS, np.empty(32 * spans - 1), np.empty((32 * spans, 6)))
    first[0] = rng.choice([-1, spans, 2**62])
    with suppress(IndexError):
        kernels.derivative_series((degree, numbers), (first, *pieces), raised, series)
        raise AssertionError("a control point outside its array was taken")


def ask_places(kernels, rng, case):
    """Arc lengths in no order, places that are none, one station."""
    pieces, count, stations = (int(n) for n in rng.integers(1, 13, 3))
    quintics = odd(rng, case, pieces + 1), odd(rng, case, 6, pieces, 2)
    kernels.quintics_at(*quintics, odd(rng, case, count), *np.empty((2, count, 2)))
    kernels.nearest_on_quintics(
        *quintics, (odd(rng, case, stations), odd(rng, case, stations, 2)), (1.0, 3), odd(rng, case, count, 2),
        np.empty(count), *np.empty((2, count, 2)),
    )  # fmt: skip
    row = odd(rng, case, pieces, int(rng.integers(1, 33)))
    kernels.spline_values(odd(rng, case, pieces + 1), row, odd(rng, case, count), np.empty(count))
    parts = odd(rng, case, pieces, stations, 2)
    axis, angle = np.empty((pieces, 2)), np.empty(pieces)
    kernels.are_cones(parts, pieces, (1e-14, 1e-9, 1e-9))
    kernels.tangent_angles(parts, axis, angle)
    velocity = odd(rng, case, count, 2)
    table = odd(rng, case, pieces + 1), axis, angle
    kernels.angles_at(table, case % 2, odd(rng, case, count), velocity, np.empty(count))
    away = np.empty(count)
    kernels.away_from_rims(tuple(odd(rng, case, 2, stations, 2)), *odd(rng, case, 2, count), away)
    lines = odd(rng, case, count, 2), odd(rng, case, stations, 2)
    kernels.chord_pairs(*lines, *np.empty((2, int(rng.integers(0, 99))), dtype=np.int64))
    places = *odd(rng, case, 2, count), rng.integers(-5, 5, count)
    ranges = rng.integers(0, count + 1, (2, count))
    kernels.near_pairs(places, tuple(ranges), 1.0, *np.empty((2, int(rng.integers(0, 9))), dtype=np.int64))
    ranges[int(rng.integers(0, 2)), 0] = rng.choice([-1, count + 1, 2**62])
    with suppress(IndexError):
        kernels.near_pairs(places, tuple(ranges), 1.0, *np.empty((2, 9), dtype=np.int64))
        raise AssertionError("places beyond the last were taken")


def ask_vertices(kernels, rng, case):
    """Programs that contradict themselves, go without end or say the same twice."""
    numbers = int(rng.integers(1, 17))
    conditions = numbers + int(rng.integers(0, 40))
    rows = odd(rng, case, conditions, numbers)
    rows[rng.random(conditions) < 0.2] = rows[0]
    active = rng.permutation(conditions)[:numbers]
    kernels.vertex_exchange(
        rows, odd(rng, case, conditions), (200, 1e-10, 1e-9, 1e-13), active, odd(rng, case, numbers, numbers),
        np.empty(numbers),
    )  # fmt: skip


def refused_arrays(kernels):
    """Arrays of other sizes, kinds and layouts, or that may not be written: how many are refused, of how many."""
    locked = np.empty(10)
    locked.setflags(write=False)
    wrong = [
        np.ones(3), np.ones(20), np.ones((3, 6))[:, ::2], None, "x", np.ones(9, dtype=np.float32), np.ones(0),
    ]  # fmt: skip
    asked = [(place, array) for place in (0, 1, 2, 3, 7, 8) for array in wrong] + [(7, locked)]
    refused = 0
    for place, array in asked:
        arguments = [np.ones(9), np.ones(9), np.ones(8), np.ones(8), 1.0, 0.0, 1e6, np.empty(10), np.empty(9)]
        arguments[place] = array
        try:
            kernels.shoot(*arguments)
        except (TypeError, ValueError, BufferError):
            refused += 1
    return refused, len(asked)


def main():
    """Ask here, or in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--here", action="store_true")
    asked = parser.parse_args()
    if asked.here:
        print(asked.cases, *ask_here(asked.cases, asked.seed))
        return
    found = ask_apart(asked.cases, asked.seed)
    print(found.stdout, found.stderr)
    sys.exit(found.returncode)


if __name__ == "__main__":
    main()
