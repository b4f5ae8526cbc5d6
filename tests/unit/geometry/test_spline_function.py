"""Bezier pieces and basis functions are those of scipy; LAPACK is found without the rest of scipy."""

import subprocess
import sys
import tracemalloc
from importlib.machinery import PathFinder
from unittest.mock import Mock

import numpy as np
import pytest

from elastica_cad import _compiled_scipy as compiled_scipy
from elastica_cad.geometry.splines import adaptive_spline, bezier_spans, spline_through

pytestmark = pytest.mark.core

JUMPING = np.array([0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4.0])


@pytest.mark.parametrize("derivative", range(4))
def test_basis_functions_are_those_of_scipy_at_knots_and_jumps(derivative):
    from scipy.interpolate import BSpline

    places = np.concatenate([np.linspace(0, 4, 61), np.arange(5)])
    ours = bezier_spans(JUMPING, 3).basis(places, derivative)
    theirs = BSpline(JUMPING, np.eye(13), 3)(places, nu=derivative)
    assert np.abs(ours - theirs).max() < 1e-12 * max(1.0, np.abs(theirs).max())


@pytest.mark.parametrize("count", [2, 3, 4, 5, 6, 7, 8, 60, 400])
@pytest.mark.parametrize("columns", [(), (4,)])
@pytest.mark.parametrize("highest", [3, 5])
def test_splines_through_values_are_those_of_scipy(count, columns, highest):
    from scipy.interpolate import make_interp_spline

    random = np.random.default_rng(count)
    x, values = np.cumsum(random.uniform(0.2, 2, count)), random.normal(size=(count, *columns))
    degree = min(highest, count - 1)
    found = spline_through(x, values, degree)
    knots, coefficients = found.knots, found.coefficients
    # scipy before 1.14 chooses no knots for degree 4
    theirs = make_interp_spline(x, values, k=degree, t=knots if degree == 4 else None)
    assert np.array_equal(knots, theirs.t)
    assert np.abs(coefficients - theirs.c).max() < 1e-12 * np.abs(theirs.c).max()


def test_lapack_is_that_of_scipy_and_leaves_it_whole():
    code = (
        "import sys\n"
        "from elastica_cad._compiled_scipy import lapack\n"
        "import numpy as np\n"
        "ours = lapack().dgtsv(np.ones(4), 4 * np.ones(5), np.ones(4), np.arange(5.0))[-2]\n"
        "assert 'scipy.linalg' not in sys.modules\n"
        "import scipy.linalg.lapack\n"
        "theirs = scipy.linalg.lapack.dgtsv(np.ones(4), 4 * np.ones(5), np.ones(4), np.arange(5.0))[-2]\n"
        "assert np.array_equal(ours, theirs)\n"
        "print('same')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "same", done.stderr


@pytest.mark.parametrize(
    "found",
    [lambda _: None, lambda places: PathFinder.find_spec("scipy.linalg._fblas", places)],
    ids=["no such file", "without these functions"],
)
def test_a_build_of_scipy_without_these_files_is_requested_as_a_whole(found, monkeypatch):
    monkeypatch.setattr(compiled_scipy, "PathFinder", Mock(find_spec=lambda _, places: found(places)))
    assert compiled_scipy.lapack.__wrapped__().__name__ == "scipy.linalg.lapack"


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_a_single_span_is_its_control_points(degree):
    from scipy.interpolate import BSpline

    knots = np.repeat([-0.7, 13.1], degree + 1)
    controls = np.random.default_rng(degree).normal(size=(degree + 1, 2))
    spans = bezier_spans(knots, degree)
    assert np.array_equal(spans.bezier(controls), controls[None])
    places = np.linspace(*spans.edges, 23)
    ours, theirs = spans.basis(places) @ controls, BSpline(knots, controls, degree)(places)
    assert np.abs(ours - theirs).max() < 1e-14 * np.abs(theirs).max() * 10


def test_the_memory_of_many_breaks_and_knots_does_not_grow_with_their_product():
    places = np.linspace(0.0, 1.0, 2002)[1:-1]
    tracemalloc.start()
    _, coefficients = adaptive_spline(
        np.zeros_like, (0.0, 1.0), degree=1, tolerance=1.0, breaks=[(x, 0) for x in places[::2]], knots=places
    )
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(coefficients) == 2002
    assert peak < 10e6
