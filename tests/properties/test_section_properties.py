"""Sections, laws and anticlastic widths: inverses, monotony and scaling."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastica_cad import Sheet
from elastica_cad.mechanics import (
    ElasticPlasticLaw,
    LaminatedSection,
    PolynomialLaw,
    TabulatedLaw,
    anticlastic_factor,
)
from elastica_cad.mechanics.sections import plate_width
from elastica_cad.mechanics.sheets import PLAUSIBLE

pytestmark = pytest.mark.core

heights = st.floats(0.05, 5.0)
moduli = st.floats(500.0, 200e3)
widths = st.floats(1.0, 100.0)
parts = st.floats(0.0, 1.0)


@st.composite
def laminates(draw):
    base = Sheet("base", draw(heights), draw(moduli), density=draw(st.floats(300, 8000)), max_strain=0.01)
    backing = Sheet(
        "backing", draw(heights), draw(moduli), density=draw(st.floats(300, 8000)), max_strain=0.005
    )
    return LaminatedSection(base, backing)


@settings(deadline=None, max_examples=50)
@given(laminates(), widths, parts)
def test_backing_width_undoes_stiffness(section, base, part):
    section = section.on(base)
    EI = section.bending_stiffness(part * base)
    found = section.parameter(EI)
    assert 0 <= found <= base
    assert section.bending_stiffness(found) == pytest.approx(EI, rel=1e-9)


@settings(deadline=None, max_examples=50)
@given(laminates(), widths)
def test_stiffness_grows_with_the_backing(section, base):
    EI = section.on(base).bending_stiffness(base * np.linspace(0, 1, 50))
    assert np.all(np.diff(EI) > 0)


@settings(deadline=None, max_examples=50)
@given(laminates(), widths, parts, st.floats(0.1, 10.0))
def test_wider_by_a_factor_is_stiffer_and_heavier_by_it(section, base, part, factor):
    w2 = part * base
    section, wider = section.on(base), section.on(factor * base)
    assert wider.bending_stiffness(factor * w2) == pytest.approx(factor * section.bending_stiffness(w2))
    assert wider.neutral_axis(factor * w2) == pytest.approx(section.neutral_axis(w2))
    assert wider.weight_per_length(factor * w2) == pytest.approx(factor * section.weight_per_length(w2))


@settings(deadline=None, max_examples=50)
@given(laminates(), widths, parts)
def test_neutral_axis_lies_between_the_layers_own(section, base, part):
    axis = section.on(base).neutral_axis(part * base)
    assert section.base.thickness / 2 * (1 - 1e-12) <= axis
    assert axis <= (section.base.thickness + section.backing.thickness / 2) * (1 + 1e-12)


@settings(deadline=None, max_examples=50)
@given(
    laminates(),
    st.lists(st.tuples(st.floats(1.0, 3.0), st.floats(5.0, 50.0)), min_size=2, max_size=8),
)
def test_the_thickness_ratio_is_the_limit_of_feasibility(section, stations):
    K, base = np.array(stations).T

    def feasible(thickness):
        backing = replace(section.backing, thickness=thickness)
        return LaminatedSection(section.base, backing).on(base).scale_range(K).feasible

    thinnest, thickest, _ = PLAUSIBLE["thickness_mm"]
    ratio = section.on(base).thickness_ratio(K)
    if np.isinf(ratio):
        assert feasible(thinnest)
        return
    thickness = section.base.thickness / ratio
    assert feasible(min(1.001 * thickness, thickest))
    assert not feasible(max(0.999 * thickness, thinnest))


@settings(deadline=None, max_examples=50)
@given(
    st.one_of(
        st.builds(
            PolynomialLaw, st.floats(0.0, 2.0), st.floats(0.0, 1.0), curvature_scale=st.floats(0.01, 1.0)
        ),
        st.builds(ElasticPlasticLaw, st.floats(0.01, 1.0)),
        st.builds(
            lambda x, y: TabulatedLaw(np.cumsum(x), np.cumsum(y)),
            st.lists(st.floats(0.01, 1.0), min_size=3, max_size=3),
            st.lists(st.floats(0.01, 1.0), min_size=3, max_size=3),
        ),
    ),
    st.floats(1e-6, 0.9),
)
def test_laws_are_odd_increasing_and_inverted(law, part):
    top = min(law.injective_limit, 1.0)
    kappa = part * top
    m = law.effective_curvature(np.array([-kappa, kappa, top]))
    assert m[0] == -m[1]
    assert m[1] < m[2]
    assert law.curvature(m[:2]) == pytest.approx([-kappa, kappa], rel=1e-9)
    law.require_injective(kappa)


@settings(deadline=None, max_examples=50)
@given(widths, st.floats(1e-4, 0.2), st.floats(0.05, 2.0), st.floats(0.0, 0.5), st.floats(0.1, 10.0))
def test_anticlastic_factor_depends_on_searles_number_only(width, curvature, thickness, nu, scale):
    one = anticlastic_factor(width, curvature, thickness=thickness, poisson_ratio=nu)
    other = anticlastic_factor(
        scale * width, curvature / scale, thickness=scale * thickness, poisson_ratio=nu
    )
    assert other == pytest.approx(one, rel=1e-9)
    assert one >= 1 - 1e-12
    assert one <= 1 / (1 - nu**2) * (1 + 1e-12)


@settings(deadline=None, max_examples=50)
@given(
    st.lists(st.tuples(st.floats(1.0, 80.0), st.floats(-0.1, 0.1)), min_size=1, max_size=12),
    st.floats(0.0, 0.5),
)
def test_plate_widths_realize_the_stiffness(stations, nu):
    wanted, kappa = np.array(stations).T
    width = plate_width(wanted, kappa, thickness=0.5, poisson_ratio=nu)
    factor = anticlastic_factor(width, kappa, thickness=0.5, poisson_ratio=nu)
    assert width * factor == pytest.approx(wanted, rel=1e-9)
