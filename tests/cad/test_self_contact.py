"""Bent bodies that run through themselves are told: by warnings where the script makes them."""

import warnings

import numpy as np
import pytest

from elastica_cad import Model, Placed, PlaneCurve, Slot, Tab, make_strip
from elastica_cad.kernel.strip_body import StripWarning
from elastica_cad.model.collisions import self_contact
from tests.cad.libraries import bd_strips, cq_strips

SHEET = "card-200gsm"
LOOP = PlaneCurve.spline([(0, 0), (90, 0), (140, 90), (60, 140), (-20, 90), (30, 0), (120, 0)], degree=4)


def ring(degrees):
    return PlaneCurve.arc((0, 0), 50, 0, np.radians(degrees))


def made(library, curve, tab):
    """The bent body of a strip with tabs of this length, and what is warned of by whom."""
    ends = (Tab(tab), Tab(tab))
    with warnings.catch_warnings(record=True) as result:
        warnings.simplefilter("always", StripWarning)
        if library == "build123d":
            body = bd_strips.BentStrip(curve, SHEET, max_width=20, ends=ends)
        else:
            body = cq_strips.bent_strip(curve, SHEET, max_width=20, ends=ends)
    assert all(one.filename == __file__ for one in result)
    return body, [str(one.message) for one in result if "intersects itself" in str(one.message)]


LIBRARIES = [pytest.param(name, marks=getattr(pytest.mark, name)) for name in ("build123d", "cadquery")]


@pytest.mark.parametrize("library", LIBRARIES)
class TestWarnings:
    def test_tabs_that_cross(self, library):
        body, (text,) = made(library, ring(355), 10)
        assert "Shorten the tabs" in text
        low, high = self_contact(body.strip)
        assert -10 < low < 0
        assert body.strip.rod.length - 1 < high < body.strip.rod.length + 10

    @pytest.mark.parametrize(("degrees", "tab"), [(355, 0), (355, 1.5), (300, 10), (180, 40), (90, 10)])
    def test_rings_that_stay_open(self, library, degrees, tab):
        assert made(library, ring(degrees), tab)[1] == []

    def test_loop_that_crosses(self, library):
        assert len(made(library, LOOP, 10)[1]) == 1

    def test_bent_until_the_tabs_meet(self, library):
        body, result = made(library, ring(300), 4)
        assert result == []
        with pytest.warns(StripWarning, match="intersects itself"):
            body.bent(end=tuple(body.rod.position[0] + (0.05, -0.2)))


@pytest.mark.build123d
@pytest.mark.parametrize("gap", [-0.02, 0.02])
def test_grazing_tabs(gap):
    """The legs of a U that leans inward: between their tips there are `gap` mm, or they run into each other."""
    from elastica_cad import Sheet

    thickness, lean, radius = Sheet.named(SHEET).thickness, 0.1, 20.0
    # the inner corner of a tip lies half a thickness off the middle line, square to the leg
    inside = (radius - thickness / 2) * np.cos(lean)
    leg = (inside - gap / 2) / np.sin(lean)
    curve = PlaneCurve.arc((0, 0), radius, -lean, np.pi + lean)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StripWarning)
        body = bd_strips.BentStrip(curve, SHEET, max_width=10, ends=(Tab(leg), Tab(leg)))
    assert (self_contact(body.strip) is not None) == (gap < 0)


@pytest.mark.build123d
def test_slot_makes_room():
    with pytest.warns(StripWarning, match="intersects itself"):
        crossing = bd_strips.BentStrip(LOOP, SHEET, max_width=20)
    at = self_contact(crossing.strip)[0]
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message=".*intersects itself")
        bd_strips.BentStrip(LOOP, SHEET, max_width=20, slots=Slot(at, width=1.0))


@pytest.mark.parametrize("library", LIBRARIES)
class TestModels:
    def shown(self, library, model):
        """What showing a model warns of."""
        with warnings.catch_warnings(record=True) as result:
            warnings.simplefilter("always", StripWarning)
            if library == "build123d":
                bd_strips.model_compound(model)
            else:
                cq_strips.model_assembly(model)
        assert all(one.filename == __file__ for one in result)
        return [str(one.message) for one in result]

    def test_strips_that_cross_without_slots(self, library):
        # two arcs of standing strips, one beside the other
        curve = PlaneCurve.arc((0, 0), 50, np.pi / 6, 5 * np.pi / 6)
        arch = make_strip(curve, SHEET, max_width=8)
        crossed, apart = (
            Model(tuple(Placed(arch, (x, 0, z), (1, 0, 0), (0, 1, 0)) for x, z in ((0, 0), (40, beside))))
            for beside in (1, 10)
        )
        assert self.shown(library, apart) == []
        (text,) = self.shown(library, crossed)
        assert "cut slots (interlock)" in text
        assert self.shown(library, crossed.interlock()) == []
