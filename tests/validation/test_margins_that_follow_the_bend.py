"""Nearest rods of wide strips that keep a margin, against a dense second variation of their own energy."""

import numpy as np
import pytest
from scipy.linalg import null_space

from elastica_cad import Limits, PlaneCurve, Sheet, make_strip, nearest_rod, stability
from elastica_cad.mechanics import PlainSection
from tests.validation.test_blanks_that_curl import moment

pytestmark = pytest.mark.core

ACRYLIC = Sheet("acrylic", 1.0, 3000.0, 1190.0, max_strain=0.2, poisson_ratio=0.37)
RUBBER = Sheet("rubber", 2.0, 9000.0, 680.0, max_strain=0.2, poisson_ratio=0.49)
DEEP_S = PlaneCurve.spline([(0, 0), (50, 110), (100, 10), (150, -90), (200, 20)], degree=4)
S = PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)], degree=4)


def own_margin(rod, width, sheet):
    """The lowest eigenvalue of the second variation between clamps, dM/dkappa by differences of `moment`."""
    n, B = rod.s.size - 1, rod.bending_stiffness
    edge, step = rod.length / n, 1e-5 * np.abs(rod.curvature).max()
    node = np.full(n + 1, edge)
    node[[0, -1]] /= 2
    rest = np.broadcast_to(rod.natural_curvature, rod.s.shape)
    plate = {"h": sheet.thickness, "E": sheet.youngs_modulus, "nu": sheet.poisson_ratio}
    felt = np.array(
        [
            (moment(k + step, r, w, **plate) - moment(k - step, r, w, **plate)) / (2 * step * B)
            for k, r, w in zip(rod.curvature, rest, width, strict=True)
        ]
    )
    tangent = np.diff(rod.position, axis=0) / edge
    force = (rod.force[1:-1].mean(axis=0)) * np.ones((n, 1))
    spring = felt / node
    H = np.diag(spring[:-1] + spring[1:] - edge * (force * tangent).sum(axis=1))
    H -= np.diag(spring[1:-1], 1) + np.diag(spring[1:-1], -1)
    free = null_space(np.array([-tangent[:, 1], tangent[:, 0]]))
    return np.linalg.eigvalsh(free.T @ H @ free)[0] / edge * rod.length**2


def widths(rod):
    """mm, of the nodes of a rod whose section is a `PlainSection`."""
    law = rod.section.bent(rod.curvature - rod.natural_curvature, rod.natural_curvature)
    return law.parameter(rod.bending_stiffness * rod.stiffness)


@pytest.mark.parametrize(
    ("curve", "sheet", "rest", "margin"),
    [
        (DEEP_S, ACRYLIC, 0.03, 5.0),  # counted with M / kappa it was promised 5 and had -3.6
        (DEEP_S, ACRYLIC, 0.02, 20.0),
        (DEEP_S, RUBBER, 0.03, 20.0),  # had 32 and was 0.8 mm off the curve for it
        (S, ACRYLIC, -0.02, 20.0),
        (S, RUBBER, 0.0, 40.0),
    ],
)
def test_a_margin_that_is_kept_is_that_of_what_a_small_bend_more_takes(curve, sheet, rest, margin):
    near = nearest_rod(
        curve,
        Limits(ratio=3.0, margin=margin),
        section=PlainSection(sheet, 0.0, 40.0),
        natural_curvature=rest,
    )
    assert near.met
    wide = widths(near.rod)
    assert wide.max() == pytest.approx(40.0, rel=0.02)
    assert wide.max() < 40.0 * (1 + 1e-5)
    own = own_margin(near.rod, wide, sheet)
    assert own == pytest.approx(margin, abs=0.3)  # of 201 nodes
    assert stability(near.rod).margin == pytest.approx(margin, abs=0.01)


def test_a_flat_strip_is_not_moved_for_a_margin_that_it_has():
    """By M / kappa it had 33 and was moved by 0.035 mm to have 40; bent as a plate it stiffens."""
    request = {"section": PlainSection(RUBBER, 0.0, 40.0)}
    near = nearest_rod(S, Limits(ratio=3.0, margin=35.0), **request)
    free = nearest_rod(S, Limits(ratio=3.0), **request)
    assert stability(free.rod).margin > 38
    assert near.deviation == pytest.approx(free.deviation, abs=1e-4)


@pytest.mark.parametrize("drawn", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("gravity", [False, True])
def test_a_strip_of_a_blank_that_is_nearly_unbent_stays(gravity, drawn):
    """Asked for as a person does; its verdict was unstable, at a margin of -3.6, and of -5.5 under its weight.

    A pole moved a little decides which search comes to it at once, and which by way of most of the margin.
    """
    curve = PlaneCurve.spline([(0, 0), (50, 110 + drawn), (100, 10), (150, -90), (200, 20)], degree=4)
    made = make_strip(
        curve, ACRYLIC, max_width=40.0, limits=Limits(margin=5.0), natural_curvature=0.03, gravity=gravity,
        ignore_limits=True,
    )  # fmt: skip
    assert stability(made.rod).margin > 5.0 * (1 - 1e-3)
    assert made.width.extremes[1] == pytest.approx(40.0, rel=0.05)
