"""Optimal rods of many curves, on one or several processors."""

from collections.abc import Sequence
from concurrent.futures import Executor
from functools import partial
from typing import Any

from elastica_cad._values import require_executor
from elastica_cad.errors import ElasticaError
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.least_ratio import optimal_rod
from elastica_cad.mechanics.loads import require_curves
from elastica_cad.mechanics.rod import Rod


def optimal_rods(
    curves: Sequence[PlaneCurve], *, executor: Executor | None = None, **options: Any
) -> tuple[Rod | ElasticaError, ...]:
    """Return the optimal rod of each curve. A failure for one curve does not affect the others.

    A rod takes about 2 ms, so several processes are useful only for hundreds of curves.

    Parameters
    ----------
    curves : sequence of PlaneCurve
    executor : concurrent.futures.Executor, optional
        A process pool, or the executor of a cluster. By default the rods are computed in this process.
    **options
        Arguments of `optimal_rod`, the same for all curves.

    Returns
    -------
    tuple of Rod or ElasticaError
        Results in the order of `curves`. For a curve that no rod can take, the error that `optimal_rod` raises,
        such as `NotRealizable`.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> wave = PlaneCurve.spline([(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)], degree=4)
    >>> [type(result).__name__ for result in optimal_rods([arch, wave])]
    ['Rod', 'NotRealizable']
    """
    require_curves(curves, "optimal_rods")
    require_executor(executor, "map")
    attempt = partial(_attempted, options=options)
    curves = list(curves)
    # sending a curve to a worker takes as long as computing its rod, so many are sent together
    return tuple(map(attempt, curves) if executor is None else executor.map(attempt, curves, chunksize=32))


def _attempted(curve: PlaneCurve, options: dict[str, Any]) -> Rod | ElasticaError:
    try:
        return optimal_rod(curve, **options)
    except ElasticaError as problem:
        return problem
