"""The picture of a verdict shows the places that the reasons name."""

import numpy as np
import pytest
from matplotlib.text import Annotation

import elastica_cad as ec
from elastica_cad import plot


def test_a_refused_curve_is_drawn_with_the_places_of_its_reasons(tmp_path):
    points = [(0, 0), (30, 80), (90, 60), (120, -40), (200, -60), (230, 60), (290, 120), (340, -20)]
    verdict = ec.check_equilibrium(ec.PlaneCurve.spline(points, degree=3))
    figure = plot.check(verdict)
    result = {text.get_text() for text in figure.axes[0].findobj(Annotation)}
    assert not verdict.realizable
    assert result == {f"{s:.4g}" for s in (*verdict.inflections, *verdict.crossings)}
    assert "crosses the curve" in figure.get_suptitle().replace("\n", " ")
    plot.save_figure(figure, tmp_path / "check.png")
    assert (tmp_path / "check.png").stat().st_size > 10_000


def test_the_measured_point_that_stands_out_is_ringed():
    x = np.linspace(0.0, 400.0, 15)
    y = 0.001 * x * (400 - x) + 0.1 * np.random.default_rng(1).normal(size=15) + 5.0 * (np.arange(15) == 6)
    figure = plot.check(ec.check_equilibrium(ec.PlaneCurve.fit(np.column_stack([x, y]), tolerance=0.01)))
    drawn = {line.get_label(): line.get_xydata() for line in figure.axes[0].lines}
    assert drawn["_measured points"] == pytest.approx(np.column_stack([x, y]))
    assert drawn["_stands out"][0] == pytest.approx((x[6], y[6]))
    assert "number 7 of 15" in figure.get_suptitle().replace("\n", " ")
