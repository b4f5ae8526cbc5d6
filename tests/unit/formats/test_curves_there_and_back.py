"""Curves written and read again make the same strip, or the change is reported."""

import re
import warnings

import numpy as np
import pytest

from elastica_cad import PlaneCurve, StripSpec, read_curves, write_curves
from elastica_cad.formats.curve_writer import FitWarning
from elastica_cad.geometry.fairing import two_sided_distance

PIECES = (0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2)
CURVES = {
    "a pen curve whose curvature jumps": PlaneCurve(
        PIECES, [(0, 0), (0, 61.7), (40, 100), (100, 100), (150, 100), (200, 70.3), (200, 0)], 3
    ),
    "a pen curve whose bending is reversed by the jump": PlaneCurve(
        PIECES, [(0, 0), (30, 60), (80, 70), (120, 40), (160, 10), (200, 10), (240, 60)], 3
    ),
    "a cubic near an inflection": PlaneCurve.spline(
        [(0, 0), (50, 98), (118.3, 61), (171, -59), (252, -80.7), (300, 1 / 3)], 3
    ),
}
QUINTIC = PlaneCurve.spline([(0, 0), (30, 90), (90, 120), (160, 130), (210, 80), (230, 0)], 5)
WIDE = 40.0


def widths(curve):
    """Widths of the strip at equal distances, mm."""
    made = StripSpec(curve, "pom-0.5", max_width=WIDE, ignore_limits=True, compensate=False).make()
    return made.width(np.linspace(0, made.width.length, 401))


@pytest.mark.parametrize("name", CURVES)
@pytest.mark.parametrize("suffix", ["svg", "dxf", "json"])
def test_no_width_changes(name, suffix, tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error", FitWarning)
        file = write_curves([CURVES[name]], tmp_path / f"a.{suffix}")
    (read,) = read_curves(file)
    assert np.abs(widths(read) - widths(CURVES[name])).max() < 1e-5


@pytest.mark.parametrize(("file", "version"), [("a.svg", "R2010"), ("a.dxf", "R12"), ("a.csv", "R2010")])
def test_what_a_format_cannot_hold_is_reported(file, version, tmp_path):
    with pytest.warns(FitWarning) as caught:
        write_curves([QUINTIC], tmp_path / file, version=version)
    (message,) = (str(one.message) for one in caught)
    far, wide, change = map(float, re.findall(r"([\d.e-]+) mm", message))
    assert message.startswith(f"The copy of curve 1 in {file} differs")
    assert wide == WIDE
    (read,) = read_curves(tmp_path / file)
    if file != "a.svg":  # which is moved to the corner of its sheet
        assert two_sided_distance(read, QUINTIC) == pytest.approx(far, rel=0.1)
    assert np.abs(widths(read) - widths(QUINTIC)).max() == pytest.approx(change, rel=0.1)
