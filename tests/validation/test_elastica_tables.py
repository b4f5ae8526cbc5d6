"""The uniform elastica against its closed form in elliptic integrals."""

from dataclasses import dataclass

import numpy as np
import pytest

from elastica_cad import Rod, Supports, bend, stability, stability_limit

pytestmark = pytest.mark.core


@dataclass(frozen=True)
class Elastica:
    """Published ratios of the first mode for the end tangent angle `alpha` (degrees)."""

    alpha: float
    pressure: float
    chord: float
    rise: float


TABLE = (
    Elastica(20, 1.01540, 0.96973, 0.10971),
    Elastica(60, 1.15172, 0.74102, 0.29660),
    Elastica(100, 1.51839, 0.34899, 0.39577),
    Elastica(140, 2.54226, -0.10692, 0.37519),
    Elastica(176, 9.11622, -0.57721, 0.21072),
)
"""P/Pcr = (2K/pi)^2, chord/L = 2E/K - 1, rise/L = k/K, k = sin(alpha/2): Timoshenko & Gere, Theory of Elastic
Stability, section 2.7; computed from complete elliptic integrals, printed to five decimals."""


@pytest.fixture(params=TABLE, ids=lambda e: f"{e.alpha:g}deg")
def elastica(request) -> Elastica:
    return request.param


def chord_of(alpha: float) -> float:
    from scipy.special import ellipe, ellipk

    m = np.sin(np.radians(alpha) / 2) ** 2
    return float(2 * ellipe(m) / ellipk(m) - 1)


def extrapolated(solve, samples=401):
    """Richardson: the discrete rod is second order in the length of its edges."""
    coarse, fine = (np.asarray(solve(n)) for n in (samples, 2 * samples - 1))
    return (4 * fine - coarse) / 3


def on_branch(rod, chord):
    """The shape on the branch of the arch, even where it is unstable: it is guessed from the one before."""
    arch = bend(rod, end=(max(chord, 0.3), 0.0))
    return bend(arch, end=(chord, 0.0), guess=arch)


def pushed(alpha, end):
    """P/Pcr, rise/L and end tangent (degrees, of pinned ends) of a strip pushed to that chord."""
    chord = chord_of(alpha)

    def solve(samples):
        rod = Rod.straight(1.0, samples=samples, supports=Supports(end, end))
        rod = on_branch(rod, chord)
        pressure = np.hypot(*rod.force[0]) / np.pi**2 / (4 if end == "clamped" else 1)
        tangent = np.abs(rod.angle).max() if end == "pinned" else 0.0
        return pressure, np.ptp(rod.position[:, 1]), np.degrees(tangent)

    return extrapolated(solve)


@pytest.mark.parametrize("end", ["pinned", "clamped"])
def test_pressure_chord_and_rise(elastica, end):
    assert chord_of(elastica.alpha) == pytest.approx(elastica.chord, abs=6e-6)
    pressure, rise, tangent = pushed(elastica.alpha, end)
    assert pressure == pytest.approx(elastica.pressure, abs=6e-6)
    assert rise == pytest.approx(elastica.rise, abs=6e-6)
    if end == "pinned":
        assert tangent == pytest.approx(elastica.alpha, abs=1e-4)


def test_rectangular_elastica():
    """k^2 = 1/2: L/height = 2.6220576, base/height = 1.1981402 (Euler)."""

    def solve(samples):
        rod = Rod.straight(1.0, samples=samples, supports=Supports("pinned", "pinned"))
        rod = bend(rod, end=(1.1981402347 / 2.6220575543, 0.0))
        return 1 / np.ptp(rod.position[:, 1]), np.abs(rod.angle[0]) * 2 / np.pi

    height, square = extrapolated(solve)
    assert height == pytest.approx(2.6220576, abs=2e-7)
    assert square == pytest.approx(1.0, abs=1e-6)


def test_figure_eight_is_where_the_clamped_arch_is_lost():
    """Chord zero is the figure eight, k^2 = 0.826114766, alpha = 130.7099 degrees (Love); clamped ends lose
    stability in the plane exactly there."""
    limits = []
    for samples in (401, 801):
        arch = bend(Rod.straight(1.0, samples=samples), end=(0.5, 0.0))
        limits.append(stability_limit(arch, [(-0.4, 0.0)]))
    assert all(limit.kind == "bifurcation" for limit in limits)
    assert limits[-1].at["end"] == pytest.approx([0.0, 0.0], abs=2e-7)
    steepest = [
        float(np.abs(limit.before.angle[np.argmin(np.abs(limit.before.s - 0.25))])) for limit in limits
    ]
    alpha = (4 * steepest[1] - steepest[0]) / 3
    assert np.degrees(alpha) == pytest.approx(130.7099, abs=5e-4)
    assert np.sin(alpha / 2) ** 2 == pytest.approx(0.826114766, abs=2e-6)


@pytest.mark.parametrize(("alpha", "stable"), [(125.0, True), (130.0, True), (131.5, False), (140.0, False)])
def test_clamped_arch_is_stable_while_its_chord_is_positive(alpha, stable):
    arch = on_branch(Rod.straight(1.0, samples=401), chord_of(alpha))
    found = stability(arch)
    assert found.stable is stable
    assert (found.margin > 0) is stable
    assert (found.conjugate_point is None) is stable


def test_conjugate_point_of_the_clamped_arch_at_140_degrees():
    """0.8407 L, computed from the closed form."""
    arch = on_branch(Rod.straight(1.0, samples=801), chord_of(140.0))
    found = stability(arch)
    assert found.started_from == "start"
    assert found.negative == 1
    assert found.conjugate_point == pytest.approx(0.8407, abs=6e-5)


@pytest.mark.parametrize("mode", [1, 2, 3, 4])
def test_pinned_ends_only_the_shape_without_interior_inflection_is_stable(mode):
    """Maddocks 1984, Stability of nonlinearly elastic rods."""
    rod = bend(
        Rod.straight(1.0, samples=301, supports=Supports("pinned", "pinned")), end=(0.8, 0.0), mode=mode
    )
    signs = np.sign(rod.moment[np.abs(rod.moment) > 1e-6])
    inflections = int(np.count_nonzero(np.diff(signs)))
    assert inflections == mode - 1
    found = stability(rod)
    assert found.stable is (mode == 1)
    assert found.negative == mode - 1


@pytest.mark.parametrize("mode", [1, 2, 3])
def test_buckling_loads_of_straight_struts(mode):
    """Euler: n^2 pi^2 pinned; clamped 4 pi^2, then 8.9868^2 (tan x = x, x = 4.4934), then 16 pi^2."""
    clamped = {1: 4 * np.pi**2, 2: 4 * 4.493409457909064**2, 3: 16 * np.pi**2}[mode]
    for end, load in (("pinned", (mode * np.pi) ** 2), ("clamped", clamped)):
        rod = bend(
            Rod.straight(1.0, samples=401, supports=Supports(end, end)), end=(1 - 1e-5, 0.0), mode=mode
        )
        assert np.hypot(*rod.force[0]) == pytest.approx(load, rel=2e-4)
