"""Cantilever calibration against heavy elasticas solved as boundary value problems, and its errors."""

import numpy as np
import pytest

from elastica_cad import InputError, Sheet, load_sheets
from elastica_cad.mechanics import calibrate_cantilever, cantilever_droop

pytestmark = pytest.mark.core

# drop / L of a strip under its own weight, clamped level, q = w L^3 / EI (integrated to tolerance)
DROPS = {1.0: 0.123471, 5.0: 0.495905, 20.0: 0.829881}


def droop_by_bvp(overhang, length):
    """alpha'' = (L - s) cos(alpha) / l_eg^3 measured downwards, alpha(0) = 0, alpha'(L) = 0."""
    from scipy.integrate import solve_bvp

    q = (overhang / length) ** 3
    s = np.linspace(0.0, 1.0, 50)
    solved = solve_bvp(
        lambda t, y: np.array([y[1], -q * (1 - t) * np.cos(y[0]), np.sin(y[0])]),
        lambda a, b: np.array([a[0], a[2], b[1]]),
        s,
        np.vstack([s, 1 - s, s**2 / 2]),
        tol=1e-9,
        max_nodes=5000,
    )
    assert solved.success
    return overhang * solved.y[2, -1]


@pytest.mark.parametrize(("load", "drop"), DROPS.items())
def test_droop_of_the_heavy_cantilever(load, drop):
    assert cantilever_droop(1.0, load ** (-1 / 3)) == pytest.approx(drop, abs=3e-5)


@pytest.mark.parametrize("overhang", [60.0, 110.0, 160.0, 260.0])
def test_length_comes_back_from_an_independent_droop(overhang):
    result = calibrate_cantilever(overhang, droop_by_bvp(overhang, 96.0))
    assert result.elasto_gravity_length == pytest.approx(96.0, rel=5e-5)


def test_small_droop_is_the_linear_beam_with_its_errors():
    """d = L^4 / (8 l^3): dl = l hypot(4/3 / L, 1/3 / d) times the reading error."""
    L, l_eg = 100.0, 600.0
    d = L**4 / (8 * l_eg**3)
    result = calibrate_cantilever(L, d, reading_error=0.01)
    assert result.elasto_gravity_length == pytest.approx(l_eg, rel=1e-4)
    assert result.uncertainty == pytest.approx(0.01 * l_eg * np.hypot(4 / 3 / L, 1 / 3 / d), rel=1e-3)


def test_propagated_error_is_that_of_noisy_readings():
    rng = np.random.default_rng(3)
    L, d = 150.0, droop_by_bvp(150.0, 96.0)
    result = calibrate_cantilever(L, d, reading_error=0.5)
    noisy = [calibrate_cantilever(L + a, d + b).elasto_gravity_length for a, b in rng.normal(0, 0.5, (25, 2))]
    assert result.uncertainty == pytest.approx(np.std(noisy), rel=0.3)


def test_readings_are_combined_and_scatter_is_not_hidden():
    lengths = np.array([120.0, 150.0, 180.0])
    exact = [droop_by_bvp(L, 96.0) for L in lengths]
    single = calibrate_cantilever(150.0, exact[1])
    good = calibrate_cantilever(lengths, exact)
    assert good.elasto_gravity_length == pytest.approx(96.0, rel=5e-5)
    assert good.uncertainty < single.uncertainty
    bad = calibrate_cantilever(lengths, np.add(exact, [6.0, 0.0, -6.0]))
    assert bad.uncertainty > 2 * good.uncertainty
    assert len(bad.readings) == 3
    assert "each reading" in str(bad)


def test_exact_readings_have_no_error_of_their_own():
    assert calibrate_cantilever(150.0, 61.57, reading_error=0.0).uncertainty == 0.0


def test_modulus_and_sheet_entry(tmp_path):
    card = Sheet("card", 0.22, 1937.0, density=900.0, max_strain=0.0055)
    droop = droop_by_bvp(150.0, card.elasto_gravity_length)
    result = calibrate_cantilever(
        150.0, droop, thickness=0.22, density=900.0, thickness_error=0.01, density_error=20.0
    )
    assert result.youngs_modulus == pytest.approx(1937.0, rel=2e-4)
    relative = np.sqrt(
        (3 * result.uncertainty / result.elasto_gravity_length) ** 2
        + (2 * 0.01 / 0.22) ** 2
        + (20 / 900) ** 2
    )
    assert result.youngs_modulus_uncertainty == pytest.approx(1937.0 * relative, rel=1e-3)
    sheet = result.sheet("my-card", least_radius=20.0, kind="card")
    assert sheet.elasto_gravity_length == pytest.approx(result.elasto_gravity_length, rel=1e-12)
    assert sheet.least_radius == pytest.approx(20.0)
    assert sheet.youngs_modulus_range[1] == pytest.approx(
        result.youngs_modulus + 2 * result.youngs_modulus_uncertainty
    )
    entry = tmp_path / "sheets.toml"
    entry.write_text(sheet.toml())
    assert load_sheets(entry) == {"my-card": sheet}
    assert "modulus 19" in str(result)
    assert result.gravity((1, 0)).direction == (1.0, 0.0)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"overhang": 100.0, "droop": 120.0}, "overhang of 100 mm cannot droop by 120 mm"),
        ({"overhang": 100.0, "droop": 97.0}, "hangs like a rope"),
        ({"overhang": 100.0, "droop": 0.001}, "too small to measure"),
        ({"overhang": 0.0, "droop": 1.0}, "overhang is 0.0: give a number above 0"),
        ({"overhang": 100.0, "droop": -3.0}, r"droop is -3\.0"),
        ({"overhang": [100.0, 120.0], "droop": 10.0}, "2 overhangs, but 1 droops"),
        ({"overhang": 100.0, "droop": 40.0, "reading_error": -1.0}, "reading_error is -1.0"),
        ({"overhang": 100.0, "droop": 40.0, "thickness": 0.0, "density": 1.0}, "thickness is 0.0"),
    ],
)
def test_bad_readings(arguments, message):
    with pytest.raises(InputError, match=message):
        calibrate_cantilever(**arguments)


def test_a_sheet_needs_thickness_density_and_one_limit():
    bare = calibrate_cantilever(150.0, 60.0)
    with pytest.raises(InputError, match="thickness"):
        bare.sheet("x", max_strain=0.01)
    full = calibrate_cantilever(150.0, 60.0, thickness=0.2, density=900.0)
    for limits in ({}, {"max_strain": 0.01, "least_radius": 10.0}):
        with pytest.raises(InputError, match="either max_strain or least_radius"):
            full.sheet("x", **limits)
    with pytest.raises(InputError, match="least radius is 0"):
        full.sheet("x", least_radius=0.0)
