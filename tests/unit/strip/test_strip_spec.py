"""One request for a strip: checked once, equal where it asks the same, and the place where strips are made."""

import math

import numpy as np
import pytest

from elastica_cad import (
    Frame,
    Gravity,
    HalfPlane,
    InputError,
    Keep,
    Laminated,
    Limits,
    Perforated,
    PlaneCurve,
    PointMass,
    Sheet,
    Slot,
    StripSpec,
    Supports,
    Tab,
    Weight,
    make_strip,
)
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.mechanics import PolynomialLaw

POLES = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
CARD = Sheet.named("card-200gsm")
UPRIGHT = Frame(x_axis=(1, 0, 0), y_axis=(0, 0, 1))
LEVEL = Frame()


def spec(**fields):
    return StripSpec(
        **({"curve": PlaneCurve.spline(POLES), "sheet": "card-200gsm", "max_width": 20} | fields)
    )


@pytest.mark.parametrize(
    "fields",
    [
        {},
        {"sheet": CARD},
        {"style": Perforated(width=24.0)},
        {"style": Laminated(width=24.0, backing=CARD)},
        {
            "limits": Limits(ratio=3.0, keep_out=(HalfPlane(),), stiffness_bounds=([1, 2], None)),
            "keep": Keep(),
        },
        {"gravity": (0, -1), "loads": (PointMass(40.0, 5.0),)},
        {"slots": (Slot.along([(10, 0), (10, 10)], [1, 1], side="upper"),), "ends": [Tab(5), Tab(6)]},
        {"frame": UPRIGHT, "gravity": [0, 0, -1], "supports": Supports("pinned", "clamped")},
    ],
)
def test_requests_are_equal_where_they_ask_the_same(fields):
    assert spec(**fields) == spec(**fields)
    assert hash(spec(**fields)) == hash(spec(**fields))
    assert spec(**fields) != spec(**fields, label="another")
    assert {spec(**fields): 1}[spec(**fields)] == 1


@pytest.mark.parametrize(
    ("fields", "same"),
    [
        ({"label": "B"}, True),
        ({"max_width": 12.0, "min_width": 2.0}, True),
        ({"ends": (Tab(3), Tab(4))}, True),
        ({"slots": (Slot(20.0, width=1.0),)}, True),
        ({"sheet": "birch-plywood-0.8"}, False),
        ({"style": Perforated(width=24.0)}, True),
        ({"frame": UPRIGHT}, True),
        ({"natural_curvature": 0.001}, False),
        ({"samples": 101}, False),
        ({"supports": Supports("pinned", "clamped")}, False),
        ({"gravity": True}, False),
        ({"limits": Limits(ratio=3)}, False),
        ({"curve": PlaneCurve.spline(POLES[::-1])}, False),
    ],
)
def test_what_the_rod_depends_on(fields, same):
    assert (spec().changed(**fields).rod_spec == spec().rod_spec) is same


def test_sheet_and_style_matter_where_their_weight_does():
    heavy = spec(gravity=True)
    assert heavy.changed(sheet="birch-plywood-0.8").rod_spec != heavy.rod_spec
    laminate = spec(gravity=True, style=Laminated(width=24.0, backing=CARD))
    assert laminate.rod_spec != heavy.rod_spec
    assert laminate.changed(style=Laminated(width=25.0, backing=CARD)).rod_spec != laminate.rod_spec


class TestGravity:
    @pytest.mark.parametrize("given", [True, (0, -1), np.array([0.0, -2.0]), CARD.gravity()])
    def test_the_sheets_own(self, given):
        assert spec(gravity=given).gravity_in_plane == CARD.gravity()

    @pytest.mark.parametrize("given", [None, False])
    def test_none(self, given):
        assert spec(gravity=given).gravity_in_plane is None

    def test_in_space(self):
        assert spec(frame=UPRIGHT, gravity=(0, 0, -1)).gravity_in_plane == CARD.gravity()
        assert spec(frame=LEVEL, gravity=(0, 0, -1)).gravity_in_plane is None
        leaning = Frame(x_axis=(1, 0, 0), y_axis=(0, math.sqrt(0.5), math.sqrt(0.5)))
        felt = spec(frame=leaning, gravity=(0, 0, -1)).gravity_in_plane
        assert felt.length == pytest.approx(CARD.elasto_gravity_length * 2 ** (1 / 6), rel=1e-12)

    def test_in_space_without_a_plane(self):
        with pytest.raises(InputError, match="also give `frame`, the plane of the curve"):
            spec(gravity=(0, 0, -1))

    @pytest.mark.parametrize("given", ["down", (0, 0), (0, 0, 0), (1,), (0, math.nan), (0, "x"), 5])
    def test_what_is_no_direction(self, given):
        with pytest.raises(InputError, match="such as"):
            spec(gravity=given)


class TestLoads:
    LAMP = PointMass(90.0, 3.0)

    def test_a_hung_mass_is_felt(self):
        light, heavy = spec(gravity=True).make(), spec(gravity=True, loads=self.LAMP, max_width=None).make()
        assert heavy.rod.weight.masses == (self.LAMP,)
        assert np.abs(heavy.rod.stiffness - light.rod.stiffness).max() > 1e-3

    def test_supports_carry_strip_and_mass(self):
        made = spec(gravity=True, loads=(self.LAMP,), max_width=None, ends=(Tab(0), Tab(0))).make()
        forces = made.reactions()
        carried = forces.start_force[1] + forces.end_force[1]
        assert carried == pytest.approx((made.mass + 3.0) * 1e-3 * 9.80665, rel=2e-3)

    def test_a_laminate_carries_them_too(self):
        style = Laminated(width=20.0, backing=CARD)
        made = spec(
            gravity=True, loads=(self.LAMP,), style=style, max_width=None, ends=(Tab(0), Tab(0))
        ).make()
        forces = made.reactions()
        carried = forces.start_force[1] + forces.end_force[1]
        assert carried == pytest.approx((made.mass + 3.0) * 1e-3 * 9.80665, rel=5e-3)
        with pytest.raises(InputError, match="PointMass records only"):
            spec(gravity=True, loads=Weight(alpha=1e-3), style=style)

    def test_a_leaning_plane_feels_a_share(self):
        leaning = Frame(x_axis=(1, 0, 0), y_axis=(0, math.sqrt(0.5), math.sqrt(0.5)))
        request = spec(frame=leaning, gravity=(0, 0, -1), loads=(self.LAMP,)).rod_spec
        assert request.weight.masses[0].mass == pytest.approx(3.0 * math.sqrt(0.5), rel=1e-12)

    @pytest.mark.parametrize(
        ("fields", "match"),
        [
            ({"gravity": None}, "needs gravity"),
            ({"gravity": (0, 0, -1), "frame": LEVEL}, "needs gravity"),
            ({"gravity": True, "limits": Limits(ratio=3)}, "can only be made for the drawn curve itself"),
        ],
    )
    def test_refusals(self, fields, match):
        with pytest.raises(InputError, match=match):
            spec(loads=(self.LAMP,), **fields)


@pytest.mark.parametrize(
    ("fields", "match"),
    [
        ({"curve": POLES}, "give a PlaneCurve"),
        ({"sheet": 3}, "the sheet is an int"),
        ({"sheet": "paper"}, "unknown sheet"),
        ({"frame": (0, 0, 0)}, "Pass a Frame"),
        ({"max_width": 0}, "max_width is 0: give a number above 0"),
        ({"min_width": math.nan}, "min_width is nan: give a number above 0"),
        ({"max_width": "wide"}, "max_width is 'wide'"),
        ({"style": "plain"}, r"give Plain\(\)"),
        ({"limits": 3.5}, "limits is 3.5: give a Limits"),
        ({"keep": True}, "keep is True: give a Keep"),
        ({"loads": (5.0,)}, "loads contain 5.0. Pass only PointMass or PointForce records"),
        ({"supports": "clamped"}, "give a Supports record"),
        ({"natural_curvature": math.inf}, "natural_curvature is inf"),
        ({"natural_curvature": "0"}, "natural_curvature is '0'"),
        ({"samples": 2}, "samples is 2"),
        ({"samples": 1.5}, "samples is 1.5"),
        ({"ends": (Tab(5),)}, "`ends` has 1 tab: give two"),
        ({"ends": (5, 5)}, "ends contain 5. Pass only Tab records"),
        ({"slots": (5,)}, "slots contain 5. Pass only Slot records"),
        ({"label": 7}, "label is 7"),
        ({"max_width": None}, "Give max_width or min_width in mm"),
        (
            {"samples": 99, "limits": Limits(ratio=3)},
            "samples can only be set if the strip",
        ),
    ],
)
def test_what_no_strip_can_be_requested(fields, match):
    with pytest.raises(InputError, match=match):
        spec(**fields)


def test_short_form_makes_the_same_strip():
    made, short = spec(label="A").make(), make_strip(PlaneCurve.spline(POLES), CARD, max_width=20, label="A")
    assert np.array_equal(made.outline.bounds, short.outline.bounds)
    assert (made.label, made.sheet, made.max_width) == (short.label, short.sheet, short.max_width)


def test_a_rod_serves_requests_that_share_it():
    first = spec()
    rod = solve_rod(first.rod_spec)
    assert first.changed(max_width=10.0).make(rod).rod is rod


def test_samples_are_those_of_the_rod():
    assert spec(samples=77).make().rod.s.size == 77


def test_gravity_of_a_record_is_taken_as_it_is():
    weaker = Gravity(200.0, (1.0, 0.0))
    assert spec(gravity=weaker).make().rod.gravity is weaker


@pytest.mark.parametrize("name", ["max_width", "min_width"])
@pytest.mark.parametrize("width", [-5.0, 0.0, math.nan, "20"])
def test_a_width_is_positive(name, width):
    with pytest.raises(InputError, match=f"{name} is {width!r}: give a number above 0, in mm"):
        spec(**{name: width})


def test_strain_is_that_of_the_curve_whatever_the_samples():
    curve = PlaneCurve.ellipse((0, 0), (60, 110), start=0.2, end=2.7)
    bend = 110 / 60**2  # the sharpest place of an ellipse
    for samples in (12, 200):
        made = make_strip(curve, "birch-plywood-0.8", max_width=20, samples=samples)
        assert made.max_strain == pytest.approx(0.4 * bend, rel=1e-6)


@pytest.mark.parametrize("section", [3, "rod", PolynomialLaw(-0.3, curvature_scale=1.0), Limits()])
@pytest.mark.parametrize("sizes", [{}, {"max_width": 40}])
def test_a_value_that_is_not_a_section_is_refused_when_it_is_set(section, sizes):
    with pytest.raises(InputError, match=r"section is .*: give a record with limits"):
        StripSpec(PlaneCurve.spline(POLES), "card-200gsm", section=section, **sizes)
