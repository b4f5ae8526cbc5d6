"""The exact two-layer section against integration over the section and against the paper's approximation."""

import numpy as np
import pytest

from elastica_cad import Sheet
from elastica_cad.mechanics import LaminatedSection

pytestmark = pytest.mark.core


def laminate(h1, h2, e1=1000.0, e2=1000.0):
    common = {"density": 700.0, "max_strain": 0.01}
    return LaminatedSection(Sheet("base", h1, e1, **common), Sheet("backing", h2, e2, **common))


def integrated(section, w1, w2):
    """E I by Gauss points over the height: the least of the second moment over all axes."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    h1, h2 = section.base.thickness, section.backing.thickness
    z = np.concatenate([h1 / 2 * (1 + nodes), h1 + h2 / 2 * (1 + nodes)])
    stiff = np.concatenate(
        [
            h1 / 2 * weights * section.base.youngs_modulus * w1,
            h2 / 2 * weights * section.backing.youngs_modulus * w2,
        ]
    )
    axis = np.sum(stiff * z) / np.sum(stiff)
    return np.sum(stiff * (z - axis) ** 2), axis


@pytest.mark.parametrize("moduli", [(1000.0, 1000.0), (9000.0, 450.0), (450.0, 9000.0)])
@pytest.mark.parametrize("heights", [(1.0, 2.0), (0.2, 0.1), (3.0, 0.05)])
@pytest.mark.parametrize("backing", [1e-6, 0.3, 4.0, 12.5])
def test_stiffness_axis_and_inverse_match_integration(heights, moduli, backing):
    section = laminate(*heights, *moduli)
    EI, axis = integrated(section, 12.5, backing)
    on_base = section.on(12.5)
    assert on_base.bending_stiffness(backing) == pytest.approx(EI, rel=1e-9)
    assert on_base.neutral_axis(backing) == pytest.approx(axis, rel=1e-9)
    found = on_base.parameter(EI)
    assert integrated(section, 12.5, found)[0] == pytest.approx(EI, rel=1e-9)


@pytest.mark.parametrize(("part", "error"), [(0.25, -0.375), (0.5, -0.243), (0.75, -0.116)])
def test_error_of_the_published_formula(part, error):
    """w2 (h1 + h2)^3 + (w1 - w2) h1^3 over 12 (paper, section 8.1) neglects the shift of the neutral axis."""
    h1, h2, w1 = 1.0, 2.0, 10.0
    w2 = part * w1
    published = 1000.0 / 12 * (w2 * (h1 + h2) ** 3 + (w1 - w2) * h1**3)
    assert published / laminate(h1, h2).on(w1).bending_stiffness(w2) - 1 == pytest.approx(error, abs=5e-4)


def test_published_formula_is_right_at_both_ends():
    section = laminate(1.0, 2.0).on(10.0)
    assert section.bending_stiffness([0.0, 10.0]) == pytest.approx([10.0 * 1000 / 12, 10.0 * 1000 / 12 * 27])


@pytest.mark.parametrize(("part", "more"), [(1.0, 1.0), (0.25, 4 / 3), (1e-9, 5 / 3)])
def test_skin_of_a_laminate_strains_more_than_half_its_thickness_says(part, more):
    """h1/h2 = 1/2: the axis lies at h1/2 + A2/(A1 + A2) (h1 + h2)/2, worked by hand."""
    section = laminate(1.0, 2.0).on(10.0)
    outer, inner = (layer.distance for layer in section.layers(10.0 * part))
    assert max(outer, inner) / (section.thickness / 2) == pytest.approx(more, rel=1e-6)
