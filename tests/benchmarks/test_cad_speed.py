"""What bodies cost on top of the core, how that compares with the core, and how much is OpenCASCADE's share."""

import pytest

from elastica_cad import (
    Hole,
    Model,
    Placed,
    PlaneCurve,
    Profile,
    Rod,
    Sheet,
    Slot,
    Strip,
    Tab,
    bend,
    make_strip,
)
from elastica_cad.kernel import occt
from elastica_cad.kernel import step_files as step
from elastica_cad.mechanics.rod import integrate_edges
from elastica_cad.strip import BentSolid, FlatSolid
from tests.benchmarks.timing import seconds

ENDS = (Tab(12, holes=(Hole(6, 3.2),)), Tab(12, holes=(Hole(6, 3.2),)))


def arch(lift=0.0, slots=()):
    curve = PlaneCurve.spline([(0, 0), (30, 60 + lift), (70, 80 + lift), (120, 60), (150, 0)])
    strip = make_strip(
        curve, "birch-plywood-0.8", max_width=24, ends=ENDS, slots=slots, label=f"arch {lift:g}"
    )
    assert strip.outline.closed  # drawn here: the outline belongs to the core
    return strip


@pytest.mark.parametrize(("kind", "limit"), [(FlatSolid, 0.020), (BentSolid, 0.100)])
def test_one_strip(benchmark, kind, limit):
    """The record of a body beside the STEP file, which OpenCASCADE writes."""
    strip = arch()
    occt.make_solid(kind.of(strip))
    benchmark(lambda: occt.make_solid(kind.of(strip)))
    whole, record = seconds(lambda: occt.make_solid(kind.of(strip))), seconds(lambda: kind.of(strip))
    core = seconds(arch, 3)
    benchmark.extra_info["OpenCASCADE's share"] = round(1 - record / whole, 2)
    benchmark.extra_info["times the core"] = round(whole / core, 2)
    parts = step.model_shapes(Model((Placed(strip),), name="one"))
    assert whole <= limit
    assert record <= seconds(lambda: step.step_bytes(parts, name="one"), 3)


def test_assembly_of_31_slotted_strips(benchmark):
    """31 different strips with six slots each, as bodies in their places; the STEP file is told apart."""
    slots = tuple(Slot(at=25.0 + 25 * k, width=1, side="upper" if k % 2 else "lower") for k in range(6))
    model = Model(tuple(Placed(arch(0.5 * k, slots), (0, 0, 40 * k)) for k in range(31)), name="many")
    parts = benchmark.pedantic(lambda: step.model_shapes(model), rounds=2)
    assert len({id(part.shape) for part in parts}) == 31
    whole = seconds(lambda: step.model_shapes(model), 3)
    records = seconds(lambda: [BentSolid.of(placed.strip) for placed in model.placed], 3)
    core = 31 * seconds(lambda: arch(0.5, slots), 3)
    benchmark.extra_info["OpenCASCADE's share"] = round(1 - records / whole, 2)
    benchmark.extra_info["times the core"] = round(whole / core, 2)
    benchmark.extra_info["seconds to write STEP"] = round(
        seconds(lambda: step.step_bytes(parts, name="many"), 1), 2
    )
    assert whole <= 3.0


def test_a_strip_bent_forward(benchmark):
    """A discrete rod: its smooth curve, and its body in the time of any other's."""
    straight = Rod.straight(150.0, Profile.interpolate([0, 75, 150], [1, 1.6, 1]))
    rod = bend(straight, start=(0, 0), end=(120, 0), angles=(0.9, -0.9))
    strip = Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=20)
    curve = seconds(lambda: integrate_edges(rod.s, rod.position, rod.angle), 5)
    benchmark.extra_info["seconds of its curve"] = round(curve, 4)
    assert strip.outline.closed
    assert rod.curve.length > 0
    occt.make_solid(benchmark(lambda: BentSolid.of(strip)))
    assert seconds(lambda: occt.make_solid(BentSolid.of(strip)), 5) <= 0.100
