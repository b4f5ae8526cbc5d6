"""A whole model on a cluster: Dask's executor does what one processor does."""

import distributed
import numpy as np
import pytest

from elastica_cad import Limits, PlaneCurve, Status, nearest_rods
from elastica_cad.form_finding import stream_nearest_rods

ARCHES = [PlaneCurve.spline([(0, 0), (20, h), (80, h), (100, 0)], degree=3) for h in (40, 60, 80)]


@pytest.fixture(scope="module")
def client():
    cluster = distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None, silence_logs=50
    )
    with cluster, distributed.Client(cluster) as found:
        yield found


def test_the_cluster_answers_as_one_processor_does(client):
    result = []
    limits = [Limits(ratio=1.3), Limits(ratio=1.4), Limits(ratio=1.5)]
    found = nearest_rods(
        ARCHES,
        limits,
        executor=client.get_executor(),
        progress=lambda done, total: result.append((done, total)),
    )
    assert result == [(1, 3), (2, 3), (3, 3)]
    for near, alone in zip(found, nearest_rods(ARCHES, limits), strict=True):
        assert near.status is Status.MET
        np.testing.assert_allclose(near.rod.position, alone.rod.position, atol=1e-9)


def test_a_bad_curve_does_not_lose_the_others(client):
    found = nearest_rods(
        [ARCHES[0], "no curve", ARCHES[2]], Limits(ratio=1.3), executor=client.get_executor()
    )
    assert [near.status for near in found] == [Status.MET, Status.FAILED, Status.MET]
    assert "PlaneCurve" in found[1].message


def test_an_executor_that_is_shut_down_is_reported(client):
    executor = client.get_executor()
    executor.shutdown()
    found = nearest_rods(ARCHES, Limits(ratio=1.3), executor=executor)
    assert all(near.status is Status.FAILED for near in found)
    assert all("run this curve again" in near.message for near in found)


def test_a_stream_on_the_cluster(client):
    curves = (ARCHES[i % 3] for i in range(7))
    found = dict(stream_nearest_rods(curves, Limits(ratio=1.3), executor=client.get_executor(), ahead=2))
    assert sorted(found) == list(range(7))
    assert all(near.status is Status.MET for near in found.values())
