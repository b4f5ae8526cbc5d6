"""Many curves at once: order, failures, executors that live and die, progress."""

import gc
import weakref
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from threading import Barrier

import numpy as np
import pytest

from elastica_cad import (
    Gravity,
    Keep,
    Limits,
    NearestRod,
    PlaneCurve,
    Status,
    nearest_rod,
    nearest_rods,
)
from elastica_cad.form_finding import stream_nearest_rods
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

WORKERS = 100

ARCHES = [PlaneCurve.spline([(0, 0), (20, h), (80, h), (100, 0)], degree=3) for h in (40, 60, 80)]


class Dying(Executor):
    """Answers the first task and breaks on the second; refuses the third."""

    def __init__(self):
        self.seen = 0

    def submit(self, fn, /, *args, **kwargs):
        self.seen += 1
        if self.seen > 2:
            raise RuntimeError("cannot schedule new futures")
        future = Future()
        if self.seen == 1:
            future.set_result(fn(*args, **kwargs))
        else:
            future.set_exception(MemoryError("worker killed"))
        return future


def test_one_by_one_as_alone():
    result = []
    found = nearest_rods(ARCHES, Limits(ratio=1.3), progress=lambda done, total: result.append((done, total)))
    assert result == [(1, 3), (2, 3), (3, 3)]
    for near, curve in zip(found, ARCHES, strict=True):
        assert near.target is curve
        np.testing.assert_array_equal(near.rod.position, nearest_rod(curve, Limits(ratio=1.3)).rod.position)


@pytest.mark.campaign
@pytest.mark.parametrize(
    "pool",
    [lambda: ThreadPoolExecutor(2), lambda: ProcessPoolExecutor(2, mp_context=get_context("spawn"))],
    ids=["threads", "processes"],
)
def test_pools_answer_in_order(pool):
    result = []
    with pool() as executor:
        found = nearest_rods(
            ARCHES, Limits(ratio=1.3), executor=executor, progress=lambda done, total: result.append(done)
        )
    assert result == [1, 2, 3]
    alone = nearest_rods(ARCHES, Limits(ratio=1.3))
    for near, other in zip(found, alone, strict=True):
        np.testing.assert_allclose(near.rod.position, other.rod.position, atol=1e-9)
        assert near.status is Status.MET


def test_one_record_a_curve():
    found = nearest_rods(
        ARCHES,
        [Limits(ratio=r) for r in (1.2, 1.3, 1.4)],
        [Keep(), Keep(tangents=True), Keep()],
        [None, None, Gravity(200.0)],
    )
    assert [
        round(near.rod.ratio, 6) <= limit for near, limit in zip(found, (1.2, 1.3, 1.4), strict=True)
    ] == [True] * 3
    assert found[2].rod.gravity == Gravity(200.0)


def test_a_curve_that_fails_does_not_lose_the_others():
    nearby, short = Limits(ratio=1.3), Limits(length=(1, 2))
    curves = [*ARCHES, "no curve"]
    found = nearest_rods(curves, [nearby, short, nearby, nearby])
    assert [near.status for near in found] == [Status.MET, Status.FAILED, Status.MET, Status.FAILED]
    assert "the rod may be at most 2 mm long" in found[1].message
    assert "PlaneCurve" in found[3].message


def test_executors_that_die_leave_what_they_did():
    found = nearest_rods(ARCHES, Limits(ratio=1.3), executor=Dying())
    assert [near.status for near in found] == [Status.MET, Status.FAILED, Status.FAILED]
    assert "worker killed" in found[1].message
    assert "run this curve again" in found[2].message
    executor = ThreadPoolExecutor(1)
    executor.shutdown()
    assert all(near.status is Status.FAILED for near in nearest_rods(ARCHES, executor=executor))


test_refusals = refusal_test(
    [
        (lambda: nearest_rods([]), "no curves"),
        (lambda: nearest_rods(ARCHES, [Limits(), Limits()]), "limits has 2 values for 3"),
        (lambda: nearest_rods(ARCHES[0]), "list of curves"),
        (lambda: nearest_rods(ARCHES, executor=2), "executor"),
        (lambda: nearest_rods(ARCHES, measur="max"), "no option 'measur'"),
        (lambda: nearest_rods(ARCHES, progress=3), "progress"),
        (lambda: stream_nearest_rods(ARCHES[0]), "called with a PlaneCurve: give an iterable of curves"),
        (lambda: stream_nearest_rods(ARCHES, ahead=0), "ahead"),
        (lambda: stream_nearest_rods(ARCHES, measur="max"), "stream_nearest_rods has no option 'measur'"),
    ]
)


def test_a_stream_reads_its_curves_as_they_are_needed():
    """Of a thousand curves only those that are ahead have been read when the first answer comes."""
    read = []

    def curves():
        for i in range(1000):
            read.append(i)
            yield ARCHES[i % 3]

    with ThreadPoolExecutor(2) as executor:
        answers = stream_nearest_rods(curves(), Limits(ratio=1.3), executor=executor, ahead=5)
        found = dict(next(answers) for _ in range(3))
        answers.close()
    assert len(read) <= 5 + 3
    assert set(found) <= set(read)
    assert all(near.status is Status.MET for near in found.values())


def test_a_stream_answers_as_a_list_does():
    alone = nearest_rods(ARCHES, Limits(ratio=1.3))
    for i, near in stream_nearest_rods(iter(ARCHES), Limits(ratio=1.3)):
        np.testing.assert_array_equal(near.rod.position, alone[i].rod.position)


@pytest.mark.campaign
def test_a_stream_keeps_nothing_of_what_it_gave():
    """Neither curve nor answer is held once the next ones are asked for."""
    gone = []

    def curves():
        for h in (40, 50, 60, 70, 80, 90):
            curve = PlaneCurve.spline([(0, 0), (20, h), (80, h), (100, 0)], degree=3)
            weakref.finalize(curve, gone.append, h)
            yield curve

    with ThreadPoolExecutor(1) as executor:
        for i, near in stream_nearest_rods(curves(), Limits(ratio=1.3), executor=executor, ahead=1):
            assert near.met
            del near
            gc.collect()
            assert len(gone) >= i - 1


def test_a_stream_whose_worker_dies_goes_on():
    found = dict(stream_nearest_rods(ARCHES, Limits(ratio=1.3), executor=Dying()))
    assert [found[i].status for i in range(3)] == [Status.MET, Status.FAILED, Status.FAILED]


FAILED = NearestRod.failure(ARCHES[0], "", None, None)
BEGUN = Barrier(WORKERS)


class Together(ThreadPoolExecutor):
    """Answers every task with a failure, once as many have begun as there are workers."""

    def submit(self, fn, /, *_):
        del fn
        return super().submit(self.answered)

    def answered(self):
        BEGUN.wait(timeout=20)
        return FAILED


def test_a_list_keeps_any_number_of_workers_busy():
    with Together(WORKERS) as executor:
        answers = nearest_rods(ARCHES[:1] * WORKERS, Limits(ratio=1.3), executor=executor)
    assert all(near is FAILED for near in answers)
