"""Speed of perforated strips: all holes rounded together against one after the other, in one run."""

import time

import numpy as np
import pytest

from elastica_cad.fabrication.drawings.corner_rounding import round_all_corners, round_corners
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

pytestmark = pytest.mark.benchmark(timer=time.process_time)

RADIUS_MM = 0.2


def test_rounded_holes(benchmark):
    rod = optimal_rod(PlaneCurve.ellipse((0, 0), (400, 200), start=0, end=np.pi))
    style = Perforated(60.0, columns=4, hole_ratio=0.8, least_ligament=0.6)
    holes = Strip(rod, Sheet.named("birch-plywood-0.8"), style=style).holes
    rounded = benchmark.pedantic(lambda: round_all_corners(holes, RADIUS_MM), rounds=3, warmup_rounds=1)
    start = time.process_time()
    alone = [round_corners(hole, RADIUS_MM) for hole in holes]
    ratio = benchmark.stats.stats.min / (time.process_time() - start)
    benchmark.extra_info["ratio"] = ratio
    assert len(holes) > 150
    assert max(abs(a.area - b.area) for a, b in zip(rounded, alone, strict=True)) < 1e-9
    assert ratio <= 0.4
