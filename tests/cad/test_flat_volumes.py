"""Volumes of flat parts as CAD programs show them: OpenCASCADE misreads walls of many spans that are extruded."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import Frame
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.kernel import occt, ocp_import
from elastica_cad.strip import FlatSolid

CURVES = {
    2.0: [(0, 0), (60, 70), (120, -50), (180, 60), (240, -30), (300, 40)],
    4.0: [(0, 0), (70, 40), (150, -80), (230, 90), (330, -60), (400, 50)],
    6.0: [(0, 0), (60, 120), (130, -60), (220, 100), (300, 0)],
}
"""Curves no strip takes exactly, by the ratio that is allowed: the sides near them are of some 20 spans."""

PLACES = {"flat": Frame(), "placed": Frame((500, 300, 200), (1, 1, 0), (0, 0, 1))}


@pytest.fixture(scope="module")
def limited():
    made = {}
    for ratio, points in CURVES.items():
        limits = ec.Limits(ratio=ratio)
        spec = ec.StripSpec(ec.PlaneCurve.spline(points), "birch-plywood-0.8", max_width=40, limits=limits)
        made[ratio] = spec.make(solve_rod(spec.rod_spec))
    return made


def shown(shape, what):
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    sums = GProp_GProps()
    measure = getattr(BRepGProp, f"{what}_s", None) or getattr(BRepGProp, what)
    measure(shape, sums)
    return sums.Mass()


def area_of(strip):
    """By corners along its loops, a thousandth of a mm off them at most."""
    areas = []
    for loop in (strip.outline, *strip.holes):
        x, y = loop.points(1e-3).T
        areas.append(abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2)
    return areas[0] - sum(areas[1:])


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("ratio", CURVES)
def test_the_volume_that_programs_show_is_area_times_thickness(ratio, place, limited, measure):
    """It was 1.2 to 2.3 % off."""
    strip = limited[ratio]
    body = occt.make_solid(FlatSolid(strip.outline, strip.holes, 0.8, PLACES[place]))
    assert measure.is_valid(body)
    assert shown(body, "VolumeProperties") == pytest.approx(0.8 * area_of(strip), rel=1e-3)


@pytest.mark.parametrize("place", PLACES)
def test_sketches_on_a_flat_part_lie_along_it(place, limited):
    """build123d takes the x axis of a face for that of a sketch on it."""
    from OCP.BRepAdaptor import BRepAdaptor_Surface

    strip, frame = limited[2.0], PLACES[place]
    body = occt.make_solid(FlatSolid(strip.outline, strip.holes, 0.8, frame))
    k = ocp_import.kernel()
    large = []
    for face in occt.sub_shapes(body, "face"):
        surface = BRepAdaptor_Surface(k.as_face(face))
        if shown(face, "SurfaceProperties") > 0.4 * area_of(strip):
            x = surface.Plane().Position().XDirection()
            large.append([x.X(), x.Y(), x.Z()])
    assert len(large) == 2
    for x in large:
        assert abs(np.dot(x, frame.x_axis)) == pytest.approx(1, abs=1e-9)
