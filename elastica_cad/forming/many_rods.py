"""Nearest rods of whole models, on one processor or on many."""

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor, Future, as_completed
from typing import Any, NamedTuple

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.forming.nearest.nearest_rod import nearest_rod
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports

_OPTIONS = {"weights", "measure", "samples", "coefficients", "section", "natural_curvature"}


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
        weights, measure, samples, coefficients, section, natural_curvature for `nearest_rod`.

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
    if isinstance(curves, PlaneCurve | str) or not isinstance(curves, Iterable):
        raise InputError(f"nearest_rods takes a list of curves, not a {type(curves).__name__}")
    if not (executor is None or hasattr(executor, "submit")):
        raise InputError(f"executor is {executor!r}: give a concurrent.futures.Executor, or None")
    if not (progress is None or callable(progress)):
        raise InputError(
            f"progress is {progress!r}: give a function of (curves done, curves in all), or None"
        )
    if unknown := set(options) - _OPTIONS:
        raise InputError(f"nearest_rods knows no option {min(unknown)!r}: use {', '.join(sorted(_OPTIONS))}")
    curves = list(curves)
    if not curves:
        raise InputError("nearest_rods got no curves: give one at least")
    count = len(curves)
    columns = (
        _spread("limits", limits, count), _spread("keep", keep, count), _spread("gravity", gravity, count),
        _spread("supports", supports, count),
    )  # fmt: skip
    tasks = [
        _Task(curve, *given, options=options)
        for curve, given in zip(curves, zip(*columns, strict=True), strict=True)
    ]
    results: dict[int, NearestRod] = {}
    if executor is None:
        for i, task in enumerate(tasks):
            results[i] = _attempted(task)
            _tell(progress, len(results), len(tasks))
        return tuple(results[i] for i in range(len(tasks)))
    running: dict[Future[NearestRod], int] = {}
    for i, task in enumerate(tasks):
        try:
            running[executor.submit(_attempted, task)] = i
        except Exception as error:  # an executor that is shut down or broken may raise anything
            results[i] = _lost(task, error)
    for future in as_completed(running):
        i = running[future]
        try:
            results[i] = future.result()
        except Exception as error:  # so does a worker that died
            results[i] = _lost(tasks[i], error)
        _tell(progress, len(results), len(tasks))
    return tuple(results[i] for i in range(len(tasks)))


class _Task(NamedTuple):
    """One curve with all that goes with it, as it travels to a worker."""

    curve: PlaneCurve
    limits: Limits | None
    keep: Keep | None
    gravity: Gravity | None
    supports: Supports | None
    options: dict[str, Any]


def _attempted(task: _Task) -> NearestRod:
    """One curve, in the worker; errors become a status."""
    curve, limits, keep, gravity, supports, options = task
    try:
        return nearest_rod(curve, limits, keep, gravity, supports=supports, **options)
    except (ElasticaError, ArithmeticError, ValueError) as error:
        return NearestRod.failed(curve, str(error), limits, keep)


def _lost(task: _Task, error: Exception) -> NearestRod:
    why = f"the executor gave no answer ({type(error).__name__}: {error}); run this curve again"
    return NearestRod.failed(task.curve, why, task.limits, task.keep)


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
