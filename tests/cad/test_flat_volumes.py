"""Volumes of flat parts as CAD programs show them: OpenCASCADE misreads walls of many spans."""

import numpy as np
import pytest

from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line, Spline
from elastica_cad.kernel import occt

LENGTH, THICK = 240.0, 0.8


def rippled(spans):
    """A strip whose sides are cubics of so many spans, 5 to 20 mm apart in sharp steps, as limits make them."""
    inner = np.linspace(0, LENGTH, spans + 1)
    knots = np.concatenate([[0.0] * 3, inner, [LENGTH] * 3])
    x = np.array([knots[i + 1 : i + 4].mean() for i in range(len(knots) - 4)])
    half = 2.5 + 7.5 * (np.arange(x.size) * 7 % 5 == 0)
    upper = PlaneCurve(knots, np.column_stack([x, half]), 3)
    lower = PlaneCurve(knots, np.column_stack([x, -half]), 3)
    right, left = (LENGTH, half[-1]), (0.0, half[0])
    sides = [
        Spline(lower), Line((LENGTH, -half[-1]), right), Spline(upper.reversed()), Line(left, (0.0, -half[0])),
    ]  # fmt: skip
    # x is linear in the parameter, so the area is twice the integral of half the width: that of the basis functions
    weights = (knots[4:] - knots[:-4]) / 4
    return Path(sides, closed=True), 2 * float(weights @ half)


def shown(shape, what):
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    sums = GProp_GProps()
    measure = getattr(BRepGProp, f"{what}_s", None) or getattr(BRepGProp, what)
    measure(shape, sums)
    return sums.Mass()


@pytest.mark.parametrize("spans", [6, 21, 57])
@pytest.mark.parametrize(
    "frame", [Frame(), Frame((500, 300, 200), (1, 1, 0), (0, 0, 1))], ids=["flat", "placed"]
)
def test_the_volume_that_programs_show_is_area_times_thickness(spans, frame, measure):
    outline, area = rippled(spans)
    body = occt.make_solid(FlatSolid(outline, (), THICK, frame))
    assert measure.is_valid(body)
    assert shown(body, "VolumeProperties") == pytest.approx(area * THICK, rel=1e-2)
    assert shown(occt.make_face(outline, (), frame), "SurfaceProperties") == pytest.approx(area, rel=5e-3)
