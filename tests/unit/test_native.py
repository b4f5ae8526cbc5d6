"""Each compiled loop beside the same calculation in Python: the same numbers to 1e-12."""

import os
import subprocess
import sys
from importlib import import_module

import numpy as np
import pytest

from elastica_cad import End, Supports, _native
from elastica_cad.form_finding import rod_map
from elastica_cad.form_finding.quadratic_program import QuadraticProgram, solve_quadratic
from elastica_cad.form_finding.rod_map import StiffnessBasis
from elastica_cad.mechanics import DiscreteRod, discrete_rod
from elastica_cad.mechanics.discrete_rod import node_weights

CLOSE = 1e-12
SEEDS = range(12)


@pytest.fixture
def loops():
    """The compiled loops, also where ELASTICA_PURE leaves them out."""
    try:
        return import_module("elastica_cad._native.loops")
    except ImportError:
        pytest.fail(
            "the loops were not built: run tests/setup.sh, which installs a C compiler, and make test"
        )


@pytest.fixture
def both(monkeypatch, loops):
    """Asks compiled and in Python."""

    def ask(question):
        answers = []
        for compiled in (loops, None):
            monkeypatch.setattr(_native, "compiled", compiled)
            answers.append(question())
        return answers

    return ask


def distance(one, other):
    """Over the size of the numbers."""
    one, other = np.asarray(one), np.asarray(other)
    return np.abs(one - other).max(initial=0.0) / (1 + np.abs(other).max(initial=0.0))


def bent(seed, edges=200):
    """A smooth rod with forces, n edges."""
    rng = np.random.default_rng(seed)
    s = np.linspace(0, 1, edges + 1)
    K = 1 + rng.uniform(0, 3) * (1 + np.sin(rng.uniform(1, 9) * s + rng.uniform(0, 6)))
    angles = rng.normal() * 3 * s[1:] + rng.normal() * np.sin(rng.uniform(1, 9) * s[1:])
    return rng, K, angles


@pytest.mark.parametrize("seed", SEEDS)
def test_shooting(both, seed):
    rng, K, _ = bent(seed)
    force, w = rng.normal(size=(200, 2)) * 9, node_weights(1 / 200, 200)
    rest = rng.normal(size=201) if seed % 2 else 0.4

    def shot():
        return discrete_rod.shoot(K, w, force, 1 / 200, moment=2.0, angle=0.3, natural_curvature=rest)

    compiled, plain = both(shot)
    assert max(map(distance, compiled, plain)) < CLOSE


def test_shooting_that_winds_up(both):
    def shot():
        return discrete_rod.shoot(
            np.ones(201), node_weights(1 / 200, 200), np.zeros((200, 2)), 1 / 200, moment=1e12, angle=0.0
        )

    compiled, plain = both(shot)
    for one, other in zip(compiled, plain, strict=True):
        np.testing.assert_array_equal(np.isnan(one), np.isnan(other))
    assert np.isnan(compiled[0]).any()


@pytest.mark.parametrize("seed", SEEDS)
def test_shapes(both, seed):
    rng, *_ = bent(seed)
    e = rng.normal(size=2) * 4 * (seed % 2)
    grid = rod_map.StripGrid(StiffnessBasis(20).at(np.linspace(0, 1, 201)), e)
    z = np.concatenate([rng.uniform(1, 3, 20), [2.0, *rng.normal(size=2) * 5, 0.1, 0.2, 0.3, 1.1]])

    def shape():
        rod = grid.shoot(z)
        return rod.tangents, rod.position, rod.pull, rod.shear

    compiled, plain = both(shape)
    assert max(map(distance, compiled, plain)) < CLOSE


@pytest.mark.parametrize("angle", [None, 0.0, np.pi / 2])
@pytest.mark.parametrize(
    "supports",
    [
        Supports(),
        Supports(End(True, True, False), End(True, False, True)),
        Supports(end=End(False, False, False)),
    ],
)
def test_second_variations(both, supports, angle):
    """Along a straight rod the row of one axis is empty."""
    rng, K, angles = bent(3)
    angles = angles if angle is None else np.full(200, angle)
    force, edge = rng.normal(size=2) * 8, (1 / 200 if angle is None else rng.uniform(0.5, 1.5, 200) / 200)
    rod = DiscreteRod(K, angles, force, edge, supports)
    compiled, plain = both(lambda: rod._second_variation)
    for one, other in zip(compiled, plain, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("to_equilibrium", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_sensitivities(both, seed, to_equilibrium):
    rng, *_ = bent(seed)
    e = np.zeros(2) if seed % 3 == 0 else rng.normal(size=2) * 4
    law = (lambda K: (np.sqrt(K), 0.5 / np.sqrt(K))) if seed % 3 == 2 else None
    grid = rod_map.StripGrid(
        StiffnessBasis(20).at(np.linspace(0, 1, 201)), e, 0.3 * rng.normal(size=201), weight=law
    )
    z = np.concatenate([rng.uniform(1, 3, 20), [2.0, *rng.normal(size=2) * 5, 0.1, 0.2, 0.3, 1.1]])
    rod = grid.shoot(z)
    if to_equilibrium:
        rod = grid.assemble(z, rod.all_angles + 0.01 * rng.normal(size=202), rod.moments + 0.01)

    compiled, plain = both(lambda: grid.sensitivities(rod, to_equilibrium=to_equilibrium))
    for name in ("angles", "moments", "position"):
        assert distance(getattr(compiled, name), getattr(plain, name)) < CLOSE


def program(seed):
    """A strictly convex program with equalities and limits, some broken at their penalty, some unknowns given."""
    rng = np.random.default_rng(seed)
    p, m = int(rng.integers(4, 30)), int(rng.integers(0, 12))
    J = rng.normal(size=(2 * p, p))
    lower, upper = -rng.uniform(0.05, 1.5, p), rng.uniform(0.05, 1.5, p)
    given = rng.uniform(size=p) < 0.15
    upper[given] = lower[given]
    one_sided = rng.uniform(size=m) < 0.7
    return QuadraticProgram(
        J.T @ J / p + 1e-3 * np.eye(p), rng.normal(size=p) * 4, lower, upper, rng.normal(size=(m, p)),
        rng.normal(size=m), rng.uniform(0.5, 9, m), one_sided,
    )  # fmt: skip


@pytest.mark.parametrize("seed", range(60))
def test_quadratic_programs(both, seed):
    request = program(seed)
    compiled, plain = both(lambda: solve_quadratic(request, accuracy=1e-13))
    assert compiled.converged
    assert plain.converged
    assert distance(compiled.x, plain.x) < 1e-9
    assert distance(compiled.row_multipliers, plain.row_multipliers) < 1e-8


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    "supports",
    [Supports(), Supports(End(True, True, False), End(True, True, False)), Supports(end=End(False, True, True)),
     Supports(end=End(False, False, False))],
)  # fmt: skip
def test_margins(both, seed, supports):
    rng, K, angles = bent(seed)
    force, edge = rng.normal(size=2) * 8, (1 / 200 if seed % 2 else rng.uniform(0.5, 1.5, 200) / 200)
    compiled, plain = both(lambda: DiscreteRod(K, angles, force, edge, supports).margin)
    assert distance(compiled.value, plain.value) < 1e-11
    assert distance(compiled.mode, plain.mode) < 1e-8
    assert distance(compiled.multipliers, plain.multipliers) < 1e-7


def test_python_alone_on_request(project_root):
    """ELASTICA_PURE leaves the compiled loops out; the nearest rod is the same."""
    code = (
        "import elastica_cad as ec; from elastica_cad._native import compiled; "
        "arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3); "
        "near = ec.nearest_rod(arch, ec.Limits(ratio=1.5, margin=5)); "
        "print(compiled is None, *near.rod.stiffness[::20], near.deviation)"
    )
    result = []
    for pure in ("", "1"):
        answer = subprocess.run(
            [sys.executable, "-c", code], check=True, capture_output=True, text=True, cwd=project_root,
            env=dict(os.environ) | {"ELASTICA_PURE": pure},
        )  # fmt: skip
        result.append(answer.stdout.split())
    assert [one[0] for one in result] == ["False", "True"]
    np.testing.assert_allclose(*(np.array(one[1:], dtype=float) for one in result), rtol=1e-5)


@pytest.mark.parametrize(
    "wrong",
    [np.ones(201, dtype=int), np.ones(200), np.ones(402)[::2], [1.0] * 201],
    ids=["integers", "too few", "with steps", "a list"],
)
def test_arrays_that_do_not_fit_are_refused(loops, wrong):
    out = np.empty(202), np.empty(201)
    with pytest.raises((TypeError, ValueError, BufferError)):
        loops.shoot(201, np.ones(201), wrong, np.ones(200), np.ones(200), 1.0, 0.0, 1e6, *out)


@pytest.mark.parametrize("nodes", [-1, 0, 2**62, 2**63 - 1])
def test_sizes_that_make_no_rod_are_refused(loops, nodes):
    out = np.empty(202), np.empty(201)
    given = np.ones(201), np.ones(201), np.ones(200), np.ones(200)
    with pytest.raises(ValueError, match="nodes must be from 1 to"):
        loops.shoot(nodes, *given, 1.0, 0.0, 1e6, *out)
