"""Widths that close the gap between neighbouring strips."""

import json

import numpy as np
import pytest

from elastica_cad import Frame, InputError, Placed, PlaneCurve, Rod, Sheet, Strip, touching_widths
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

MERIDIAN = PlaneCurve.spline([(20, 0), (60, 10), (70, 60), (40, 90), (55, 120)])


def radial(angle):
    return Frame((0, 0, 0), (np.cos(angle), np.sin(angle), 0), (0, 0, 1))


@pytest.mark.parametrize("gap", [0.0, 2.0])
def test_surface_of_revolution(gap):
    """n equal meridians: half width = r tan(pi / n), less the gap along the ruling."""
    n = 16
    widths = touching_widths([(MERIDIAN, radial(2 * np.pi * i / n)) for i in range(n)], gap, closed=True)
    s = np.linspace(0, MERIDIAN.length, 301)
    r = MERIDIAN.at(s).position[:, 0]
    for width in widths:
        np.testing.assert_allclose(width(s), 2 * (r * np.tan(np.pi / n) - gap / np.cos(np.pi / n)), atol=2e-5)


def test_uneven_planes_keep_to_the_nearer_side():
    """Unequal angles: the smaller half angle counts; neighbours touch at the bisector."""
    angles = np.array([0.0, 0.3, 0.4, 0.9])
    widths = touching_widths([(MERIDIAN, radial(a)) for a in angles])
    r = MERIDIAN.at(np.array([50.0])).position[0, 0]
    for width, half in zip(widths, (0.15, 0.05, 0.05, 0.25), strict=True):
        assert float(width(50.0)) == pytest.approx(2 * r * np.tan(half), abs=2e-5)


def test_sides_that_change_places_make_a_kink():
    """Planes that are no fan: the nearer of two bisectors changes along the curve."""
    first = (MERIDIAN, Frame((0, 0, 8), (1, 0, 0), (0, 1, 0)))
    second = (MERIDIAN, Frame((0, 0, 0), (1, 0, 0), (0, 1, 0)))
    tilt = 0.25
    third = (MERIDIAN, Frame((0, -20, 0), (1, 0, 0), (0, np.cos(tilt), -np.sin(tilt))))
    (_, width, _) = touching_widths([first, second, third])
    s = np.linspace(0, MERIDIAN.length, 1001)
    y = MERIDIAN.at(s).position[:, 1]
    np.testing.assert_allclose(width(s), 2 * np.minimum(4.0, (y + 20) * np.tan(tilt / 2)), atol=2e-5)
    assert np.ptp(width(s)) > 1


def test_parallel_planes_meet_half_way():
    widths = touching_widths([(MERIDIAN, Frame((0, 0, z))) for z in (0, 10, 16)], 0.5)
    assert [float(w(30.0)) for w in widths] == pytest.approx([9.0, 5.0, 5.0], abs=1e-5)


def test_placed_strips():
    """The slope of the frames' rulings does not matter, nor where the strips come from."""
    card = Sheet.named("card-200gsm")
    strip = Strip(Rod.straight(80.0), card, max_width=5, label="A")
    placed = [Placed(strip, (30, 0, 0), f.x_axis, f.y_axis) for f in (Frame(), Frame())]
    over = Placed(strip, (30, 0, 12), (1, 0, 0), (0, -1, 0))
    widths = touching_widths([placed[0], over])
    np.testing.assert_allclose([w([0.0, 80.0]) for w in widths], 12.0, atol=1e-9)


test_refused = refusal_test(
    [
        (lambda: touching_widths([(MERIDIAN, Frame())]), "at least two strips"),
        (
            lambda: touching_widths([(MERIDIAN, Frame()), (MERIDIAN, Frame((5, 0, 0)))]),
            "strip 1 and strip 2 are in the same plane",
        ),
        (
            lambda: touching_widths([(MERIDIAN, radial(0)), (MERIDIAN, radial(0.2))], 3.0),
            r"with a gap of 3 mm, strip 1 would be .* wide at 0 mm from its start",
        ),
        (lambda: touching_widths([(MERIDIAN, radial(0)), (MERIDIAN, radial(0.2))], np.nan), "gap"),
    ]
)


def test_flower_pot(reference_data):
    """The outer half widths of the published 16 strips, 2 mm from the bisector planes, to the digits printed."""
    data = json.loads((reference_data / "reference" / "flower_pot.json").read_text())
    strips, published = [], []
    for row in data["curves"]:
        points = 60 * np.array(row["cp_final"])
        curve = PlaneCurve(np.arange(-4, len(points) + 1), points, 4)
        strips.append((curve, Frame(60 * np.array(row["frame_origin_3d"]), *row["frame_axes_3d"])))
        published.append(1000 * np.array(row["composite_half_width_m"]["outer"]))
    widths = touching_widths(strips, 2.0, closed=True)
    for (curve, _), width, half in zip(strips, widths, published, strict=True):
        s = curve.arc_length(np.linspace(0, 6, 500))
        np.testing.assert_allclose(width(s) / 2, half, atol=7e-5)


@pytest.mark.parametrize(("labels", "told"), [(("L1", "L2"), "L1 and L2"), (("", ""), "strip 1 and strip 2")])
def test_strips_in_one_plane_are_named(labels, told):
    strips = [
        Placed(Strip(Rod.straight(50.0), Sheet.named("card-200gsm"), max_width=9.0, label=label), (0, 0, 0))
        for label in labels
    ]
    with pytest.raises(InputError, match=f"{told} are in the same plane"):
        touching_widths(strips)
