"""Shapes of strips that were bent, drawn again with a pen's cubics and written to files, can be bent again."""

import numpy as np
import pytest

from elastica_cad import Profile, Rod, Supports, bend, check_equilibrium, optimal_rod
from elastica_cad.files import read_drawing
from elastica_cad.form_finding import smooth_curve
from tests.validation.test_every_number_of_decimals import smooth_path, written

pytest.importorskip("cssselect2")

PINNED = Supports("pinned", "pinned")


def bent_between_pins(rng):
    """A strip of varying stiffness between two ends that turn freely."""
    length = rng.uniform(120, 900)
    stiffness = Profile.interpolate(np.linspace(0, length, 6), np.exp(rng.uniform(-0.4, 0.4, 6)))
    return bend(Rod.straight(length, stiffness, supports=PINNED), end=(rng.uniform(0.45, 0.97) * length, 0.0))


def bent_strip(rng):
    """A strip of varying stiffness between two clamps."""
    length = rng.uniform(120, 900)
    stiffness = Profile.interpolate(np.linspace(0, length, 6), np.exp(rng.uniform(-0.4, 0.4, 6)))
    end, angles = (rng.uniform(0.35, 0.9) * length, 0.0), rng.uniform(-1.2, 1.2, 2)
    return bend(Rod.straight(length, stiffness), end=end, angles=tuple(angles))


def as_cubics(rod, pieces):
    """Cubics between points at even distances, with the tangents there and handles of a third of the way."""
    curve = rod.curve
    t = curve.parameter(np.linspace(0, curve.length, pieces + 1))
    place, velocity = curve.evaluate(t), curve.evaluate(t, 1)
    handle = curve.length / pieces / 3 / np.hypot(*np.diff(place, axis=0).T)
    return smooth_path(place, np.degrees(np.arctan2(velocity[:, 1], velocity[:, 0])), handle, handle)


@pytest.mark.parametrize(
    ("count", "pieces", "decimals"),
    [
        (12, 5, 3),
        *(pytest.param(30, *one, marks=pytest.mark.campaign) for one in ((12, 2), (16, 3), (40, 3))),
    ],
)
def test_bent_strips_drawn_again_are_strips(tmp_path, count, pieces, decimals):
    """Drawn up to 150 m from the origin, as in plans of sites: rounding there must not hide a strip."""
    rng = np.random.default_rng(pieces)
    rods = [bent_strip(rng) for _ in range(count)]
    path = tmp_path / "drawn.svg"
    drawn = {str(k): as_cubics(rod, pieces) for k, rod in enumerate(rods)}
    written(path, decimals, "mm", relative=False, curves=drawn)
    for rod, one in zip(rods, read_drawing(path), strict=True):
        curve = smooth_curve(one.curve).curve
        check = check_equilibrium(curve)
        assert check.realizable, check.reasons
        again = optimal_rod(curve)
        assert again.length == pytest.approx(rod.length, rel=0.02)
        assert again.residual < 1e-8


@pytest.mark.campaign
@pytest.mark.parametrize(("pieces", "decimals", "refused"), [(5, 3, 5), (8, 3, 1), (12, 2, 0), (16, 3, 0)])
def test_strips_between_pins_drawn_again_are_strips(tmp_path, pieces, decimals, refused):
    """A pen leaves some bend in their ends, and evening out the curvature would leave more."""
    rng = np.random.default_rng(5)
    rods = [bent_between_pins(rng) for _ in range(30)]
    path = tmp_path / "drawn.svg"
    written(
        path,
        decimals,
        "mm",
        relative=False,
        curves={str(k): as_cubics(rod, pieces) for k, rod in enumerate(rods)},
    )
    found = []
    for rod, one in zip(rods, read_drawing(path), strict=True):
        smoothing = smooth_curve(one.curve, supports=PINNED)
        assert smoothing.moved <= 0.1
        if check_equilibrium(smoothing.curve, PINNED).realizable:
            again = optimal_rod(smoothing.curve, supports=PINNED)
            assert again.residual < 1e-8
            found.append(again.ratio / (rod.stiffness.max() / rod.stiffness.min()))
    assert len(found) >= len(rods) - refused
    assert np.median(found) == pytest.approx(1.0, abs=0.1)
