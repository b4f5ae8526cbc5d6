"""Many segments at one go: the same as one by one."""

import numpy as np
import pytest

from elastica_cad.geometry.path import Arc, Line, SegmentTable, Spline, chords, chords_of_all
from elastica_cad.geometry.plane_curve import PlaneCurve

pytestmark = pytest.mark.core

BOWS = [PlaneCurve.spline([(0, 0), (30, 50 - k), (60, k), (90, 0)], degree=3) for k in range(4)]
LONG = PlaneCurve.spline([(0, 0), (9, 5), (20, -8), (31, 3), (42, 0), (50, 9)], degree=3)
UNCLAMPED = PlaneCurve(np.arange(8.0), [(0, 0), (9, 5), (20, -8), (31, 3)], 3)
SEGMENTS = [
    Line((0, 0), (4, 3)), Spline(BOWS[0]), Arc((1, 2), 5.0, 0.3, 2.9), Spline(LONG), Spline(BOWS[1]),
    Spline(PlaneCurve.arc((0, 0), 7.0, 0.0, 2.0)), Spline(UNCLAMPED), Line((9, 9), (8, 7)),
    Arc((0, 0), 3.0, 1.0, -1.0), Spline(BOWS[2].reversed()), Spline(PlaneCurve.line((0, 0), (5, 5))),
    Spline(BOWS[3]),
]  # fmt: skip


def test_points_and_derivatives():
    which = np.repeat(np.arange(len(SEGMENTS)), 5)[::-1]
    u = np.tile(np.linspace(0, 1, 5), len(SEGMENTS))
    table = SegmentTable(SEGMENTS)
    for derivative in (0, 1):
        each = [
            SEGMENTS[k].velocity_at(x) if derivative else SEGMENTS[k].at(x)
            for k, x in zip(which, u, strict=True)
        ]
        assert table.at(which, u, derivative) == pytest.approx(np.array(each), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("tolerance", [1.0, 1e-3])
def test_chords(tolerance):
    which, points = chords_of_all(SEGMENTS, tolerance)
    for k, segment in enumerate(SEGMENTS):
        assert points[which == k] == pytest.approx(chords(segment, tolerance)[1], abs=1e-9)
