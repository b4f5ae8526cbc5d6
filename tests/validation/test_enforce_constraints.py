"""The paper's EnforceConstraints (Appendix C), against a run of the authors' published code."""

import json

import numpy as np
import pytest

from elastica_cad import PlaneCurve
from elastica_cad.geometry import EndPositions, EndTangents, FixedLength, InflectionsOnLine, least_norm_newton

pytestmark = pytest.mark.core


class ChordLength:
    """The published code's length: the sum of the chords between uniform samples."""

    def __init__(self, curve, samples):
        a, b = curve.domain
        self.t = np.linspace(a, b, samples)
        self.length = self.measured(curve)[0]

    def measured(self, curve):
        chords = np.diff(curve.evaluate(self.t), axis=0)
        length = np.hypot(*chords.T)
        rows = np.diff(curve.basis(self.t), axis=0)
        gradient = rows.T @ (chords / length[:, None])
        return length.sum(), gradient.reshape(1, -1)

    def equations(self, curve):
        length, gradient = self.measured(curve)
        return np.array([length - self.length]), gradient


@pytest.fixture(scope="module")
def reference(reference_data):
    return json.loads((reference_data / "reference" / "enforce_constraints.json").read_text())


def run(reference, length):
    knots = np.arange(len(reference["cp_start"]) + 5.0)
    start = PlaneCurve(knots, reference["cp_start"], 4)
    perturbed = PlaneCurve(knots, reference["cp_perturbed"], 4)
    inflections = [z.t for z in perturbed.curvature_zeros if z.kind == "crossing"]
    line = InflectionsOnLine(
        reference["line_constant"], np.array(reference["line_linear"]), np.array(inflections)
    )
    kept = [EndPositions.of(start), EndTangents.of(start), length(start), line]
    return start, *least_norm_newton(perturbed, kept, tolerance=1e-13)


def test_projection_and_residuals_of_the_published_run(reference):
    samples = _samples_of_the_published_length(reference)
    _, curve, norms = run(reference, lambda start: ChordLength(start, samples))
    np.testing.assert_allclose(curve.control_points, reference["cp_projected"], atol=1e-9)
    published = reference["residual_norm_per_newton_step"]
    np.testing.assert_allclose(norms[:4], published[:4], rtol=1e-5, atol=1e-13)
    assert len(norms) == len(published)


def test_true_arc_length_changes_the_projection_by_the_error_of_the_chords(reference):
    start, curve, _ = run(reference, lambda start: FixedLength(start.length))
    np.testing.assert_allclose(curve.control_points, reference["cp_projected"], atol=1e-6)
    assert curve.length == pytest.approx(start.length, rel=1e-12)
    inflections = [z.t for z in curve.curvature_zeros]
    # the file counts parameters from the start of the domain
    np.testing.assert_allclose(np.array(inflections) - 4, reference["t_inflections"], atol=1e-6)


def _samples_of_the_published_length(reference):
    """How many samples the published length used: the count that gives the length in the file."""
    knots = np.arange(len(reference["cp_start"]) + 5.0)
    start = PlaneCurve(knots, reference["cp_start"], 4)
    counts = range(300, 500)
    lengths = np.array([ChordLength(start, n).length for n in counts])
    best = int(np.abs(lengths - reference["arc_length"]).argmin())
    assert lengths[best] == pytest.approx(reference["arc_length"], abs=1e-9)
    return counts[best]
