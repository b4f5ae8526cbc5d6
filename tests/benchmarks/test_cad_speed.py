"""What bodies cost on top of the core, and how much of that is OpenCASCADE's share."""

from time import perf_counter

import numpy as np
import pytest

from elastica_cad import occt, step
from elastica_cad.fabrication import BentSolid, FlatSolid, Hole, Model, Placed, Slot, Tab
from elastica_cad.fabrication.making import make_strip
from elastica_cad.geometry import PlaneCurve

ENDS = (Tab(12, holes=(Hole(6, 3.2),)), Tab(12, holes=(Hole(6, 3.2),)))


def seconds(function, repeats=9):
    best = np.inf
    for _ in range(repeats):
        start = perf_counter()
        function()
        best = min(best, perf_counter() - start)
    return best


def arch(lift=0.0, slots=()):
    curve = PlaneCurve.spline([(0, 0), (30, 60 + lift), (70, 80 + lift), (120, 60), (150, 0)])
    strip = make_strip(
        curve, "birch-plywood-0.8", max_width=24, ends=ENDS, slots=slots, label=f"arch {lift:g}"
    )
    assert strip.outline.closed  # drawn here: the outline belongs to the core
    return strip


@pytest.mark.parametrize(("kind", "limit"), [(FlatSolid, 0.020), (BentSolid, 0.100)])
def test_one_strip(benchmark, kind, limit):
    strip = arch()
    occt.make_solid(kind.of(strip))
    benchmark(lambda: occt.make_solid(kind.of(strip)))
    whole, record = seconds(lambda: occt.make_solid(kind.of(strip))), seconds(lambda: kind.of(strip))
    benchmark.extra_info["OpenCASCADE's share"] = round(1 - record / whole, 2)
    assert whole <= limit


def test_assembly_of_31_slotted_strips(benchmark):
    """31 different strips with six slots each, as bodies in their places; the STEP file is told apart."""
    slots = tuple(Slot(at=25.0 + 25 * k, width=1, side="upper" if k % 2 else "lower") for k in range(6))
    model = Model(tuple(Placed(arch(float(k), slots), (0, 0, 40 * k)) for k in range(31)), name="many")
    parts = benchmark.pedantic(lambda: step.model_parts(model), rounds=2)
    assert len({id(part.shape) for part in parts}) == 31
    whole = seconds(lambda: step.model_parts(model), 3)
    records = seconds(lambda: [BentSolid.of(placed.strip) for placed in model.placed], 3)
    benchmark.extra_info["OpenCASCADE's share"] = round(1 - records / whole, 2)
    benchmark.extra_info["seconds to write STEP"] = round(
        seconds(lambda: step.step_bytes(parts, name="many"), 1), 2
    )
    assert whole <= 3.0
