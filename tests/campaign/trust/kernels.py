"""Compiled loops under the compiler's sanitizers: odd sizes, dependent rows, numbers that are none, wrong arrays.

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
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
SANITIZERS = ("asan", "ubsan")
FLAGS = (
    "-O1",
    "-g",
    "-fsanitize=address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
    "-fPIC",
    "-shared",
)
MOST_S = 3000.0


def build(folder):
    """The package with loops built under the sanitizers, in `folder`."""
    leave_out = shutil.ignore_patterns("__pycache__", "*.so")
    shutil.copytree(ROOT / "elastica_cad", folder / "elastica_cad", ignore=leave_out)
    request = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (extension,) = request["tool"]["setuptools"]["ext-modules"]
    macros = [f"-D{name}={value}" for name, value in extension["define-macros"]]
    include = f"-I{sysconfig.get_path('include')}"
    target = "elastica_cad/_native/loops.abi3.so"
    subprocess.run(
        ["gcc", *FLAGS, *macros, include, *extension["sources"], "-o", target], check=True, cwd=folder
    )


def ask_apart(cases, seed):
    """The finished process that ran so many cases under the sanitizers."""
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
    """Ask the compiled loops that this process finds; how many wrong calls were refused, of how many."""
    from elastica_cad import _native

    rng = np.random.default_rng(seed)
    for case in range(cases):
        with np.errstate(all="ignore"):
            ask_programs(rng, case)
            ask_modes(_native, rng, case)
            ask_rods(_native, rng, case)
    return refused_calls(_native.compiled)


def ask_programs(rng, case):
    """A program with rows that say the same, say nothing, or hold no number."""
    from elastica_cad.form_finding import quadratic_program as programs

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
    request = programs.QuadraticProgram(
        H, rng.normal(size=p) * 10 ** rng.uniform(-6, 6), lower, upper, A, rng.normal(size=m),
        10 ** rng.uniform(-3, 5, m), rng.random(m) < 0.5,
    )  # fmt: skip
    programs.solve_quadratic(request)


def odd(rng, case, *shape):
    """Numbers of any size, one of them none now and then."""
    numbers = rng.normal(size=shape) * 10 ** rng.uniform(-9, 300 if case % 40 == 0 else 6)
    if case % 9 == 0 and numbers.size:
        numbers.flat[int(rng.integers(numbers.size))] = rng.choice([np.nan, np.inf, 0.0])
    return numbers


def ask_modes(native, rng, case):
    """The lowest mode of matrices that are rough, empty, huge or no numbers."""
    n, rows, smooth = int(rng.integers(2, 300)), int(rng.integers(0, 3)), int(rng.integers(1, 17))
    diagonal, off = odd(rng, case, n), odd(rng, case + 3, n - 1)
    if case % 31 == 0:
        diagonal[:], off[:] = 0, 0
    polynomials = np.linalg.qr(rng.normal(size=(max(n, smooth), smooth)))[0][:n]
    lengths = rng.random(n) + 0.01 * (case % 13 > 0)
    native.lowest_mode(diagonal, off, lengths, rng.normal(size=(rows, n)) * (case % 17 > 0), polynomials)


def ask_rods(native, rng, case):
    """Rods that wind up without end, without stiffness, of one edge, with and without weight."""
    edges, coefficients = int(rng.integers(1, 120)), int(rng.integers(1, 12))
    nodes = edges + 1
    bend, rest, *pulls = (odd(rng, case + k, n) for k, n in enumerate((nodes, nodes, edges, edges)))
    angles, moments = native.shoot(bend, rest, *pulls, rng.normal(), rng.normal(), 1e6)
    force, e = odd(rng, case, edges, 2), odd(rng, case, 2)
    tangents, _, pull, shear = native.shape(angles[1:-1], force, e, 1.0 / edges)
    stiffness, shares = odd(rng, case + 2, nodes), rng.random(nodes)
    held = tuple(bool(one) for one in rng.integers(0, 2, 2))
    native.second_variation(
        stiffness, shares, shares[1:], pull, tangents, free_ends=held[::-1], held=held, straight=1e-9
    )
    carried = (odd(rng, case, nodes), odd(rng, case, nodes, coefficients)) if case % 2 else None
    native.sensitivities(
        stiffness=stiffness, moments=moments, all_angles=angles, tangents=tangents, pull=pull, shear=shear,
        shares=shares, rest=rest, basis=odd(rng, case, nodes, coefficients), e=e, carried=carried,
        length=rng.normal(), start_moment=rng.normal(), start_angle=rng.normal(), to_equilibrium=bool(case % 3),
    )  # fmt: skip


def refused_calls(compiled):
    """Arrays of other sizes, kinds and layouts, or that may not be written, and sizes that no array has: how many
    calls are refused, of how many."""
    locked = np.empty(10)
    locked.setflags(write=False)
    wrong = [
        np.ones(3), np.ones(20), np.ones((3, 6))[:, ::2], None, "x", np.ones(9, dtype=np.float32), np.ones(0),
        np.ones(9, dtype=">f8"),
    ]  # fmt: skip
    sizes = [-(2**63), -1, 0, 8, 10, 2**31, 2**61, 2**62 + 1, 2**63 - 1, 2**64, 9.0, None]
    request = [(place, array) for place in (1, 2, 3, 4, 8, 9) for array in wrong] + [(8, locked)]
    request += [(0, size) for size in sizes]
    refused = 0
    for place, value in request:
        arguments = [
            9,
            np.ones(9),
            np.ones(9),
            np.ones(8),
            np.ones(8),
            1.0,
            0.0,
            1e6,
            np.empty(10),
            np.empty(9),
        ]
        arguments[place] = value
        refused += is_refused(compiled.shoot, arguments)
    pairs = [(2**32, 2**32), (2**62, 4), (4, 2**62), (-4, -3), (0, 2**63 - 1), (3, 4), (4, -3)]
    program = [
        np.eye(4), np.ones(4), np.zeros(4), np.ones(4), np.ones((3, 4)), *np.ones((3, 3)), 1e-9, np.empty(4),
        np.empty(3), np.empty(4), np.empty(4),
    ]  # fmt: skip
    compiled.interior_points(4, 3, *program)
    refused += sum(is_refused(compiled.interior_points, [*pair, *program]) for pair in pairs)
    return refused, len(request) + len(pairs)


def is_refused(function, arguments):
    """Is a call refused in Python?"""
    try:
        function(*arguments)
    except (TypeError, ValueError, BufferError, OverflowError):
        return True
    return False


def main():
    """Ask here, or in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--here", action="store_true")
    arguments = parser.parse_args()
    if arguments.here:
        refused, count = ask_here(arguments.cases, arguments.seed)
        print(f"{arguments.cases} cases; {refused} of {count} wrong calls refused")
        sys.exit(refused < count)
    found = ask_apart(arguments.cases, arguments.seed)
    print(found.stdout, found.stderr)
    sys.exit(found.returncode)


if __name__ == "__main__":
    main()
