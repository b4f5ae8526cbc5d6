"""Nearest rods of whole models, on one processor or on many."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future, as_completed
from typing import Any

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest import NearestRod, nearest_rod
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, Supports

__all__ = ["nearest_rods"]


def nearest_rods(
    curves: Sequence[PlaneCurve],
    limits: Limits | Sequence[Limits] | None = None,
    keep: Keep | Sequence[Keep] | None = None,
    gravity: Gravity | Sequence[Gravity | None] | None = None,
    *,
    supports: Supports | Sequence[Supports] | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] | None = None,
    **options: Any,
) -> tuple[NearestRod, ...]:
    """`nearest_rod` for many curves; a curve that fails does not lose the others.

    Parameters
    ----------
    curves : sequence of PlaneCurve
    limits, keep, gravity, supports
        As in `nearest_rod`: one for all curves, or one a curve.
    executor : concurrent.futures.Executor, optional
        Where the work is done: a process pool, or a cluster's executor. Here and now unless given.
    progress : callable, optional
        Called with (curves done, curves in all) in this process.
    **options
        weights, measure, samples, coefficients for `nearest_rod`.

    Returns
    -------
    tuple of NearestRod
        In the order of `curves`. Where nothing could be computed (bad input, a worker that died) the status is
        FAILED and `message` says why.

    Raises
    ------
    InputError
        No curves, or sequences of another length.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> [near.met for near in nearest_rods([arch, arch.reversed()], Limits(ratio=1.6))]
    [True, True]
    """
    curves = list(curves)
    if not curves:
        raise InputError("nearest_rods got no curves: give one at least")
    columns = [_spread(name, value, len(curves)) for name, value in
               (("limits", limits), ("keep", keep), ("gravity", gravity), ("supports", supports))]  # fmt: skip
    tasks = list(zip(curves, *columns, strict=True))
    results: dict[int, NearestRod] = {}
    if executor is None:
        for i, task in enumerate(tasks):
            results[i] = _attempted(*task, options)
            _tell(progress, len(results), len(tasks))
        return tuple(results[i] for i in range(len(tasks)))
    running: dict[Future[NearestRod], int] = {}
    for i, task in enumerate(tasks):
        try:
            running[executor.submit(_attempted, *task, options)] = i
        except Exception as error:  # an executor that is shut down or broken raises what it likes
            results[i] = _lost(task, error)
    for future in as_completed(running):
        i = running[future]
        try:
            results[i] = future.result()
        except Exception as error:  # so does a worker that died
            results[i] = _lost(tasks[i], error)
        _tell(progress, len(results), len(tasks))
    return tuple(results[i] for i in range(len(tasks)))


def _attempted(
    curve: PlaneCurve, limits: Limits | None, keep: Keep | None, gravity: Gravity | None,
    supports: Supports | None, options: dict[str, Any],
) -> NearestRod:  # fmt: skip
    """One curve, in the worker; errors become a status."""
    try:
        return nearest_rod(curve, limits, keep, gravity, supports=supports, **options)
    except (ElasticaError, ArithmeticError, ValueError) as error:
        return NearestRod.failed(curve, str(error), limits, keep)


def _lost(task: tuple[Any, ...], error: Exception) -> NearestRod:
    curve, limits, keep = task[:3]
    why = f"the executor gave no answer ({type(error).__name__}: {error}); run this curve again"
    return NearestRod.failed(curve, why, limits, keep)


def _spread(name: str, value: Any, count: int) -> list[Any]:
    """One value a curve."""
    if value is None or not isinstance(value, (list, tuple)):
        return [value] * count
    if len(value) != count:
        raise InputError(f"{name}: {len(value)} given for {count} curves; give one for all, or one a curve")
    return list(value)


def _tell(progress: Callable[[int, int], None] | None, done: int, total: int) -> None:
    if progress is not None:
        progress(done, total)
