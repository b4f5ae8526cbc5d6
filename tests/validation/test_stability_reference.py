"""Stability against the authors' public code, and against theorems on inflections."""

import json

import numpy as np
import pytest

from elastica_cad import PlaneCurve, bend, optimal_rod, stability
from elastica_cad.mechanics import DiscreteRod, conjugate_point, determinant_gradient, stability_determinant
from elastica_cad.mechanics.discrete_rod import bending_moments, node_weights, shoot

pytestmark = pytest.mark.core


@pytest.fixture(scope="module")
def state(reference_data):
    """One equilibrium with determinant and gradient, from AbsoluteAngleElastica.m of the authors' code
    (010fb77e); finite differences added."""
    data = json.loads((reference_data / "reference" / "adjoint_check.json").read_text())
    return {name: np.array(value) if isinstance(value, list) else value for name, value in data.items()}


def bump(data, s):
    x = np.clip((s - data["sigma"]) / 0.1, -1, 1)
    with np.errstate(divide="ignore"):
        return np.exp(-1 / (1 - x**2))


def test_state_is_balanced_with_our_sign_of_the_force(state):
    lengths, angles = state["segment_lengths"], state["segment_angles"]
    ends = (state["alpha_start"], state["alpha_end"])
    moments = bending_moments(state["K"], angles, node_weights(lengths, lengths.size), ends=ends)
    force = np.tile(state["lambda"], (lengths.size, 1))
    assert np.abs(DiscreteRod(state["K"], angles, force, lengths).moment_imbalance(moments)).max() < 1e-10
    assert np.abs(DiscreteRod(state["K"], angles, -force, lengths).moment_imbalance(moments)).max() > 1e-2


def test_determinant_and_conjugate_point(state):
    rod = DiscreteRod(state["K"], state["segment_angles"], state["lambda"], state["segment_lengths"])
    z = stability_determinant(rod)
    assert z.value[:-1] == pytest.approx(state["determinant"], rel=1e-9, abs=1e-9)
    assert z.sign_changes == pytest.approx([state["sigma"]], abs=1e-9)
    assert conjugate_point(rod) == pytest.approx(state["sigma"], abs=1e-3)


def gradient_of(data):
    lengths, angles, K = data["segment_lengths"], data["segment_angles"], data["K"]
    moments = bending_moments(
        K, angles, node_weights(lengths, lengths.size), ends=(data["alpha_start"], data["alpha_end"])
    )
    weights = np.append(lengths * bump(data, np.cumsum(lengths) - lengths / 2), 0.0)
    return determinant_gradient(
        DiscreteRod(K, angles, data["lambda"], lengths), weights=weights, moments=moments
    )


def test_adjoint_gradient(state):
    reference = state["gradient_wrt_nodal_K_adjoint"]
    assert np.abs(gradient_of(state) - reference).max() < 1e-6 * np.abs(reference).max()


def test_adjoint_against_finite_differences(state):
    nodes = np.append(0.0, np.cumsum(state["segment_lengths"]))
    gradient = gradient_of(state)
    for q, finite_difference in enumerate(state["finite_difference_directional"], start=1):
        direction = state["K"] * np.cos(q * np.pi * nodes / nodes[-1] + 0.3 * q)
        assert gradient @ direction == pytest.approx(finite_difference, rel=1e-6)


def test_s_curve(reference_data):
    """Three inflections: R = 3.4687, conjugate point at 0.773 L, one negative eigenvalue (authors' code)."""
    points = np.loadtxt(reference_data / "hafner" / "spline_infl_simple.txt", skiprows=1)
    curve = PlaneCurve(np.arange(-4.0, len(points) + 1), points, 4)
    rod = optimal_rod(curve)
    found = stability(rod)
    assert rod.ratio == pytest.approx(3.4687, abs=2e-4)
    assert found.conjugate_point / rod.length == pytest.approx(0.773, abs=1e-3)
    assert found.negative == 1
    assert not found.stable
    # the drawn curve is a saddle: bending stays on it, letting go snaps to a stable shape (Fig. 11)
    again = bend(rod)
    assert np.abs(again.position - rod.position).max() < 1e-5 * rod.length
    free = bend(rod, settle=True)
    assert stability(free).stable
    assert np.abs(free.position - rod.position).max() > 0.1 * rod.length
    assert "snaps" in free.warnings[0]


@pytest.mark.parametrize("moment", [0.3, 1.5, 3.0])
def test_inflectional_elastica_first_conjugate_point_between_first_and_third_inflection(moment):
    """Sachkov 2008, Conjugate points in the Euler elastic problem."""
    n, length = 3000, 9.0
    h = length / n
    w, K, force = node_weights(h, n), np.ones(n + 1), np.tile([4.0, 0.0], (n, 1))
    angles, moments = shoot(K, w, force, h, moment=moment, angle=0.1)
    inflections = np.flatnonzero(moments[:-1] * moments[1:] < 0) * h
    place = conjugate_point(DiscreteRod(K, angles[1:-1], force, h))
    assert inflections.size >= 3
    assert inflections[0] < place < inflections[2]


@pytest.mark.parametrize("moment", [4.5, 6.0, 9.0])
def test_no_conjugate_point_without_inflection(moment):
    """Born 1906: an elastica without inflection is stable."""
    n, length = 2000, 3.0
    h = length / n
    w, K, force = node_weights(h, n), np.ones(n + 1), np.tile([4.0, 0.0], (n, 1))
    angles, moments = shoot(K, w, force, h, moment=moment, angle=0.3)
    assert np.all(moments > 0)
    rod = DiscreteRod(K, angles[1:-1], force, h)
    assert conjugate_point(rod) is None
    assert stability_determinant(rod).sign_changes.size == 0
