"""Blanks bent beforehand: zeros against closed forms, shapes against an independent boundary-value solver."""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from elastica_cad import (
    Gravity,
    InputError,
    Keep,
    Limits,
    NotRealizable,
    PlaneCurve,
    Profile,
    Rod,
    Status,
    Supports,
    bend,
    check_equilibrium,
    make_strip,
    nearest_rod,
    optimal_rod,
    stability,
)
from elastica_cad.mechanics import RestCurvature
from elastica_cad.mechanics.loads import ExcessCurvature
from tests.section_designs import Design

pytestmark = pytest.mark.core

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4)
WAVE = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 0)], degree=3)
ARC = PlaneCurve.arc((0, 0), 100.0, 0.0, 2.0)  # 200 mm long, curvature 0.01
SLACK = PlaneCurve.spline([(0, 0), (60, 30), (130, 20), (198, -2)], degree=3)


@dataclass(frozen=True)
class Blank:
    """A curve, the curvature before bending, and the same at arc lengths (n,) by plain interpolation."""

    curve: PlaneCurve
    stations: tuple[float, ...]
    curvatures: tuple[float, ...]
    gravity: Gravity | None = None

    @property
    def rest(self):
        return RestCurvature.linear(np.array(self.stations) * self.curve.length, self.curvatures)

    def kappa_0(self, s):
        return np.interp(s / self.curve.length, self.stations, self.curvatures)


BLANKS = {
    "even": Blank(ARCH, (0, 1), (-0.002, -0.002)),
    "tent": Blank(ARCH, (0, 0.5, 1), (-0.002, 0.003, -0.004)),
    "bent more than the curve": Blank(ARCH, (0, 0.5, 1), (0.0, -0.03, 0.0)),
    "of a wave": Blank(WAVE, (0, 0.3, 0.7, 1), (0.001, -0.004, 0.003, 0.0)),
    "heavy tent": Blank(ARCH, (0, 0.4, 1), (-0.003, 0.002, -0.001), Gravity(120.0)),
    "heavy wave": Blank(WAVE, (0, 0.6, 1), (0.001, -0.002, 0.001), Gravity(90.0, (0.6, -0.8))),
}


def strayed(rod, kappa_0, start=0.02):
    """Distance from the rod, in lengths, of what a boundary-value solver finds from a shape beside it."""
    length = rod.length
    q = 0.0 if rod.gravity is None else (length / rod.gravity.length) ** 3
    down = (0.0, 0.0) if rod.gravity is None else rod.gravity.direction

    def slopes(s, y):
        K, (c, sn) = rod.profile(s * length), (np.cos(y[2]), np.sin(y[2]))
        bent = y[3] / K + kappa_0(s * length) * length
        return np.array([c, sn, bent, y[4] * sn - y[5] * c, -q * K * down[0], -q * K * down[1]])

    ends = [[*rod.position[i] / length, rod.angle[i]] for i in (0, -1)]

    def held(a, b):
        return np.concatenate([a[:3] - ends[0], b[:3] - ends[1]])

    bump = start * np.sin(np.pi * rod.s / length)
    guess = np.vstack(
        [
            rod.position.T / length,
            rod.angle + bump,
            rod.moment * length * (1 + bump),
            -rod.force.T * length**2,
        ]
    )
    found = solve_bvp(slopes, held, rod.s / length, guess, tol=1e-9, max_nodes=100000)
    assert found.success, found.message
    return np.hypot(*(found.sol(rod.s / length)[:2].T - rod.position / length).T).max()


@pytest.mark.parametrize("name", BLANKS)
def test_the_strip_rests_in_the_curve(name):
    blank = BLANKS[name]
    rod = optimal_rod(blank.curve, blank.gravity, natural_curvature=blank.rest)
    assert rod.residual < 1e-10
    assert strayed(rod, blank.kappa_0) < 1e-6
    assert rod.natural_curvature == pytest.approx(blank.kappa_0(rod.s))


@pytest.mark.parametrize("name", BLANKS)
def test_bent_forward_from_the_blank(name):
    """The blank lies unbent; led to the ends it takes the curve."""
    blank = BLANKS[name]
    rod = optimal_rod(blank.curve, blank.gravity, natural_curvature=blank.rest)
    flat = Rod.straight(
        rod.length, rod.profile, samples=601, natural_curvature=blank.rest, gravity=rod.gravity
    )
    ends = {"start": rod.position[0], "end": rod.position[-1], "angles": (rod.angle[0], rod.angle[-1])}
    bent = bend(flat, **ends, guess=rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * rod.length
    assert stability(rod).conjugate_point == stability(bent).conjugate_point


def test_a_blank_that_lies_free_takes_its_own_shape():
    """Nothing acts on it: the angles are the integral of kappa_0."""
    rest = RestCurvature.of(SLACK)
    unbent = Rod.straight(
        rest.length, samples=1201, natural_curvature=rest, supports=Supports("clamped", "free")
    )
    rod = bend(unbent, start=(0, 0), angles=(float(SLACK.angle_at(0.0)), None))
    assert np.hypot(*(rod.position - SLACK.sample(1201).position).T).max() < 1e-6 * rest.length
    assert np.abs(rod.moment).max() < 1e-12


def test_a_drawn_blank():
    curve = PlaneCurve.spline([(0, 0), (50, 55), (130, 50), (178, 0)], degree=3)
    blank = SLACK.transformed(np.diag([1.0, 1.0, SLACK.length / curve.length]))
    rod = optimal_rod(curve, natural_curvature=RestCurvature.of(blank))
    flat = Profile.interpolate(np.linspace(0, blank.length, 2001), blank.sample(2001).curvature)
    assert strayed(rod, lambda s: flat(s * blank.length / rod.length)) < 1e-6


def test_steps_of_the_blank_are_steps_of_the_stiffness():
    rest = RestCurvature.linear([0, 70, 70, ARCH.length], [-0.004, -0.004, 0.002, 0.002])
    rod = optimal_rod(ARCH, natural_curvature=rest)
    kappa = ARCH.at(np.array([70.0])).curvature[0]
    left, right = rod.profile(np.array([70 - 0.01, 70 + 0.01]))
    assert left / right == pytest.approx((kappa - 0.002) / (kappa + 0.004), rel=1e-4)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * rod.length


def test_a_law_of_thickness_and_weight_with_a_bent_blank():
    arch = PlaneCurve.ellipse((0, 0), (250, 150), start=0, end=np.pi)
    rest = RestCurvature.linear([0, arch.length / 2, arch.length], [0.001, 0.002, 0.0005])
    section = Design("thickness", arch, heavy=True, nearest=False).section
    rod = optimal_rod(arch, Gravity(1.0), natural_curvature=rest, section=section)
    bent = bend(rod)
    assert np.hypot(*(bent.position - rod.position).T).max() < 1e-5 * rod.length


NEAR = {
    "ratio": (Limits(ratio=1.5), None),
    "margin and tangents": (Limits(margin=5.0), Keep(tangents=True)),
    "curvature and length": (Limits(ratio=2.5, curvature=0.035), Keep(length=True)),
}


@pytest.mark.parametrize("options", NEAR)
@pytest.mark.parametrize("name", BLANKS)
def test_the_nearest_strip_of_a_blank(name, options):
    """It rests where an independent solver has it, within its limits, and is as long as the blank."""
    blank, (limits, keep) = BLANKS[name], NEAR[options]
    near = nearest_rod(blank.curve, limits, keep, blank.gravity, natural_curvature=blank.rest)
    rod = near.rod
    assert near.status is Status.MET
    share = blank.curve.length / rod.length
    assert share == pytest.approx(1.0, rel=1e-9 if keep and keep.length else 0.01)
    assert strayed(rod, lambda s: blank.kappa_0(s * share)) < 2e-5
    assert rod.natural_curvature == pytest.approx(blank.kappa_0(rod.s * share))
    assert rod.ratio <= (limits.ratio or np.inf) * (1 + 1e-6)
    assert np.abs(rod.curvature - rod.natural_curvature).max() <= (limits.curvature or np.inf) * (1 + 1e-6)
    assert limits.margin is None or stability(rod).margin >= limits.margin - 1e-6
    if keep is not None and keep.both_tangents[0]:
        ends = blank.curve.angle_at(np.array([0.0, 1.0]) * blank.curve.domain[1])
        assert rod.angle[[0, -1]] == pytest.approx(ends, abs=1e-9)
    asked_ratio = optimal_rod(blank.curve, blank.gravity, natural_curvature=blank.rest).ratio
    assert near.deviation < (1e-3 if asked_ratio < rod.ratio else 0.01) * rod.length


@pytest.mark.parametrize("name", ["tent", "bent more than the curve", "of a wave"])
def test_the_curve_of_the_nearest_strip_requests_its_ratio(name):
    blank = BLANKS[name]
    near = nearest_rod(blank.curve, Limits(ratio=1.8), natural_curvature=blank.rest)
    assert check_equilibrium(near.curve, natural_curvature=blank.rest).moved < 1e-6
    again = optimal_rod(near.curve, natural_curvature=blank.rest)
    assert again.ratio < near.rod.ratio * 1.001


def test_a_nearest_strip_of_a_blank_and_of_a_number():
    """One curvature all along is the same as a blank of it; the strip bears what its skin bears."""
    number = nearest_rod(ARCH, Limits(ratio=1.3), natural_curvature=-0.002).rod
    rest = RestCurvature.linear([0, number.length], [-0.002, -0.002])
    blank = nearest_rod(ARCH, Limits(ratio=1.3), natural_curvature=rest).rod
    assert np.hypot(*(number.position - blank.position).T).max() < 0.05
    strip = make_strip(
        ARCH, "birch-plywood-0.8", max_width=30, natural_curvature=rest, limits=Limits(ratio=1.3)
    )
    assert strip.max_strain <= strip.strain_limit
    assert strip.rod.ratio == pytest.approx(1.3)


@pytest.mark.parametrize(
    ("rest", "keep", "words"),
    [
        (RestCurvature.linear([0, 150], [0, 0]), Keep(length=True), "the pre-bent strip is 150 mm long"),
        (
            RestCurvature.linear([0, WAVE.length], [0, 0.001]),
            Keep(symmetry="turn"),
            "the pre-bent strip differs from its image after a half turn",
        ),
        (0.001, Keep(symmetry="turn"), "the pre-bent strip differs from its image after a half turn"),
    ],
)
def test_what_a_blank_cannot_keep_is_reported(rest, keep, words):
    with pytest.raises(InputError, match=words):
        nearest_rod(WAVE, None, keep, natural_curvature=rest)


@pytest.mark.parametrize(("share", "length"), [(0.97, 1.01), (1.03, 0.99)])
def test_a_blank_becomes_a_hundredth_longer_or_shorter_at_most(share, length):
    """Its curvature is known along it: the nearest strip comes as near to the curve's length as it may."""
    blank = share * ARCH.length
    near = nearest_rod(ARCH, natural_curvature=RestCurvature.linear([0, blank], [0.002, 0.001]))
    assert near.rod.length == pytest.approx(length * blank, rel=1e-6)


class TestZeros:
    """Of kappa - kappa_0 on an arc, where kappa is 0.01 and kappa_0 is given."""

    @staticmethod
    def of(function, breaks=()):
        profile = Profile.fit(function, ARC.length, tolerance=1e-15, breaks=breaks)
        return ExcessCurvature(ARC, RestCurvature(profile)).zeros

    def test_a_crossing_is_found_to_rounding(self):
        (zero,) = ExcessCurvature(ARC, RestCurvature.linear([0, 200], [0.0, 0.03])).zeros
        assert zero.s == pytest.approx(200 / 3, rel=1e-11)
        assert (zero.kind, zero.before, zero.after) == ("crossing", 1, -1)

    @pytest.mark.parametrize("apart", [20.0, 1.0, 0.01])
    def test_two_close_together(self, apart):
        found = self.of(lambda s: 0.01 + 1e-6 * ((s - 90) ** 2 - apart**2))
        assert [z.s for z in found] == pytest.approx([90 - apart, 90 + apart], rel=1e-6)

    def test_a_touch_is_refused(self):
        (zero,) = self.of(lambda s: 0.01 + 1e-6 * (s - 90) ** 2)
        assert (zero.kind, round(zero.s, 2)) == ("touch", 90.0)
        profile = Profile.fit(lambda s: 0.01 + 1e-6 * (s - 90) ** 2, ARC.length, tolerance=1e-15)
        with pytest.raises(NotRealizable, match="becomes 0 at 90 mm from the start"):
            optimal_rod(ARC, natural_curvature=RestCurvature(profile))

    def test_a_jump_through_zero_is_refused(self):
        rest = RestCurvature.linear([0, 80, 80, 200], [0.005, 0.005, 0.015, 0.015])
        (zero,) = ExcessCurvature(ARC, rest).zeros
        assert (zero.kind, zero.s) == ("jump", pytest.approx(80))
        assert "jumps from one sign to the other 80 mm from the start" in str(
            check_equilibrium(ARC, natural_curvature=rest)
        )

    def test_a_stretch_with_the_blanks_curvature(self):
        rest = RestCurvature.linear([0, 80, 120, 200], [0.0, 0.01, 0.01, 0.0])
        found = ExcessCurvature(ARC, rest).zeros
        assert [(z.kind, round(z.s, 6), round(z.s_end, 6)) for z in found] == [("flat", 80.0, 120.0)]
        assert "is bent exactly as the pre-bent strip" in str(check_equilibrium(ARC, natural_curvature=rest))

    def test_the_curve_itself_as_blank_is_not_bent(self):
        check = check_equilibrium(ARCH, natural_curvature=RestCurvature.of(ARCH))
        assert check.any_stiffness

    def test_a_number_and_a_blank_of_that_number_agree(self):
        found = ExcessCurvature(WAVE, RestCurvature.linear([0, WAVE.length], [0.003, 0.003])).zeros
        request = ExcessCurvature(WAVE, 0.003).zeros
        assert [(z.kind, z.before, z.after) for z in found] == [(z.kind, z.before, z.after) for z in request]
        assert [z.s for z in found] == pytest.approx([z.s for z in request], rel=1e-10)

    def test_three_inflections_off_one_line_are_refused(self):
        rest = RestCurvature.linear([0, 50, 100, 150, 200], [0.0, 0.02, 0.0, 0.02, 0.012])
        check = check_equilibrium(ARC, natural_curvature=rest)
        assert "are not on one line" in str(check)


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (lambda: RestCurvature.linear([0, 100], [0.0]), "two or more stations, each with a curvature"),
        (lambda: RestCurvature.linear([10, 100], [0.0, 0.0]), "Begin at 0 mm"),
        (
            lambda: RestCurvature.linear([0, 100, 100, 100, 200], [0.0] * 5),
            "twice only where the curvature jumps",
        ),
        (lambda: RestCurvature(0.01), "RestCurvature.linear"),
        (lambda: RestCurvature.of([(0, 0)]), "give a PlaneCurve"),
        (
            lambda: optimal_rod(ARC, natural_curvature=RestCurvature.linear([0, 150], [0, 0])),
            "the curve is 200 mm",
        ),
        (lambda: optimal_rod(ARC, natural_curvature=[0.0, 0.1]), "give a finite number"),
    ],
)
def test_what_is_no_blank_is_refused_in_a_sentence(made, words):
    with pytest.raises(InputError, match=words):
        made()
