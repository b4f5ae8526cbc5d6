"""Cost of interlocking the Pavilion against computing its strips, in one run."""

from dataclasses import replace
from time import process_time

from elastica_cad import optimal_rod
from tests.benchmarks.timing import seconds


def test_slots_cost_a_few_times_the_strips(benchmark, pavilion):
    """All pairs of 31 strips searched, 102 slots found, cut, and refused where they meet (paper: 3.93 s)."""
    model = pavilion()
    assert all(strip.outline.closed for strip in model.strips)
    gravity = model.strips[0].sheet.gravity()

    def interlocked():  # copies, because joints of the same placed strips are kept
        return replace(model, placed=tuple(replace(placed) for placed in model.placed)).interlock()

    def rods():
        return [optimal_rod(strip.rod.curve, gravity=gravity) for strip in model.strips]

    benchmark.pedantic(interlocked, rounds=3)
    slots = seconds(interlocked, 3, process_time)
    benchmark.extra_info["ratio"] = slots / seconds(rods, 3, process_time)
    assert slots < 3.9 / 2
    assert benchmark.extra_info["ratio"] < 8
