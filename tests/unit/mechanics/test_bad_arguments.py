"""Arguments that are not what they should be are told in one sentence, wherever they are given."""

import numpy as np
import pytest

from elastica_cad import (
    End,
    Gravity,
    InputError,
    NotRealizable,
    PlaneCurve,
    PointMass,
    Rod,
    Supports,
    Weight,
    bend,
    check_equilibrium,
    optimal_rod,
    stability,
)

pytestmark = pytest.mark.core

ARCH = PlaneCurve.ellipse((0, 0), (50, 25), start=0, end=np.pi)
STRIP = Rod.straight(100.0, samples=41)


@pytest.mark.parametrize("of", [
    lambda **options: optimal_rod(ARCH, **options), lambda **options: check_equilibrium(ARCH, **options),
    lambda **options: Rod.straight(100.0, **options), lambda **options: bend(STRIP, **options),
])  # fmt: skip
@pytest.mark.parametrize("supports", ["clamped", 3, ("clamped", "pinned")])
def test_supports_are_a_record(of, supports):
    with pytest.raises(InputError, match=r"supports is .*: give a Supports record"):
        of(supports=supports)


@pytest.mark.parametrize("of", [
    lambda **options: optimal_rod(ARCH, **options), lambda **options: Rod.straight(100.0, **options),
])  # fmt: skip
@pytest.mark.parametrize("gravity", [96, "down", (0, -1)])
def test_gravity_is_a_record(of, gravity):
    with pytest.raises(InputError, match=r"gravity is .*: give a Gravity record"):
        of(gravity=gravity)


@pytest.mark.parametrize("end", [None, 3, True])
def test_a_support_is_a_name_or_an_end(end):
    with pytest.raises(InputError, match="the support of the end is"):
        Supports(End(), end)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: optimal_rod(STRIP), "the curve is a Rod: give a PlaneCurve"),
        (lambda: check_equilibrium(STRIP), "the curve is a Rod: give a PlaneCurve"),
        (lambda: bend(ARCH), "bend was called with a PlaneCurve"),
        (lambda: stability(ARCH), "stability was called with a PlaneCurve"),
        (lambda: check_equilibrium(ARCH, tolerance=-1.0), "tolerance is -1.0"),
        (lambda: optimal_rod(ARCH, tolerance=np.nan), "tolerance is nan"),
        (lambda: optimal_rod(ARCH, natural_curvature=np.zeros(5)), "natural_curvature is array"),
        (lambda: Rod.straight(100.0, samples=2), "samples is 2: give a whole number, 3 or more"),
        (lambda: Rod.straight(100.0, samples=2.5), "samples is 2.5"),
        (lambda: Rod.straight(100.0, start=(0.0,)), "start cannot be .*: give two finite numbers"),
        (lambda: Rod.straight(100.0, bending_stiffness=-1.0), "bending stiffness is -1.0"),
        (lambda: STRIP.with_stiffness(np.ones(40)), "`stiffness` has 40 values, but the rod has 41 nodes"),
        (lambda: bend(STRIP, end=(90.0, 0.0), mode=1.5), "mode is 1.5"),
        (lambda: bend(STRIP, samples="many"), "samples is 'many'"),
        (lambda: Weight(-1.0), "weight alpha is -1.0: give 0 or more"),
        (lambda: Weight(0.0, np.nan), "weight beta is nan"),
        (lambda: PointMass(5.0, -1.0), "a point mass is -1.0: give 0 or more"),
    ],
)
def test_reported_in_one_sentence(call, message):
    with pytest.raises(InputError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("length", [0.5, 1e-3])
def test_a_weight_beyond_all_strips(length):
    """A length in metres, say: the march overflows, which is told, not a warning of numpy's."""
    with pytest.raises(NotRealizable, match=r"far too large for the stiffness: .* check the units"):
        optimal_rod(ARCH, Gravity(length))
