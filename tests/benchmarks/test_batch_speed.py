"""Batches of wishes: how well two processes are used, that time grows with the number, and that memory does not."""

import multiprocessing
import tracemalloc
from concurrent.futures import ProcessPoolExecutor
from time import perf_counter

import pytest

from elastica_cad import Limits, PlaneCurve
from elastica_cad.form_finding import stream_nearest_rods

WORKERS = 2
FEW, MANY, TEN_THOUSAND = 200, 600, 10_000


def arches(count):
    """Each of another height."""
    for i in range(count):
        yield PlaneCurve.spline([(0, 0), (20, 40 + 40 * i / count), (80, 60), (100, 0)], degree=3)


def answered(count, executor=None):
    """Whether all are met; nothing is kept."""
    return all(
        near.met for _, near in stream_nearest_rods(arches(count), Limits(ratio=1.6), executor=executor)
    )


@pytest.fixture(scope="module")
def workers():
    with ProcessPoolExecutor(WORKERS, mp_context=multiprocessing.get_context("spawn")) as executor:
        assert answered(4 * WORKERS, executor)  # so that each has its modules
        yield executor


def seconds(count, executor=None):
    start = perf_counter()
    assert answered(count, executor)
    return perf_counter() - start


def test_two_processes(benchmark, workers):
    """Beside one process; half is all that two can do."""
    benchmark.pedantic(lambda: answered(FEW, workers), rounds=3, warmup_rounds=1)
    ratio = min(seconds(FEW, workers) for _ in range(3)) / min(seconds(FEW) for _ in range(3))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 0.75


def test_time_is_linear(benchmark, workers):
    benchmark.pedantic(lambda: answered(MANY, workers), rounds=1)
    ratio = min(seconds(MANY, workers) for _ in range(3)) / min(seconds(FEW, workers) for _ in range(3))
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 1.25 * MANY / FEW


def test_ten_thousand(benchmark, workers):
    """Beside half the time of one process, which is reckoned from a thousand of them.

    Two processes beside each other each run slower than one alone, by what they share of the machine.
    """
    benchmark.pedantic(lambda: answered(TEN_THOUSAND, workers), rounds=1)
    alone = TEN_THOUSAND / 1000 * seconds(1000)
    ratio = benchmark.stats.stats.median / (alone / WORKERS)
    benchmark.extra_info["ratio"] = ratio
    assert ratio <= 1.5


def test_memory_is_constant(benchmark, workers):
    """The largest amount that Python holds at a time, of many beside few."""

    def peak(count):
        tracemalloc.start()
        answered(count, workers)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    benchmark.pedantic(lambda: peak(FEW), rounds=1)
    most = peak(MANY)
    ratio = most / peak(FEW)
    benchmark.extra_info.update(ratio=ratio, megabytes=most / 1e6)
    assert ratio <= 1.5  # three would be growth; what is collected when makes a fifth
