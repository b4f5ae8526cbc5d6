"""Nearest rods of many curves, on one or several processors."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future
from queue import SimpleQueue
from typing import Any, NamedTuple

from elastica_cad._values import require_executor
from elastica_cad.errors import ElasticaError, InputError, note
from elastica_cad.form_finding.limits import Keep, Limits
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.nearest_search import nearest_rod
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import Gravity, Supports, require_curves, whole_number

AHEAD = 64
"""Number of curves of a stream that are submitted at a time: enough for a dozen workers, with little memory."""

LISTED = 1024
"""Number of curves of a list that are submitted at a time: enough for hundreds of workers."""

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
    """Return the nearest rod of each curve. A failure for one curve does not affect the others.

    Parameters
    ----------
    curves : sequence of PlaneCurve
    limits, keep, gravity, supports
        Arguments of `nearest_rod`: one value for all curves, or a value for each curve.
    executor : concurrent.futures.Executor, optional
        A process pool, or the executor of a cluster. By default the rods are computed in this process.
    progress : callable, optional
        Function that is called in this process with the number of finished curves and the number of all curves.
    **options
        Arguments of `nearest_rod`: weights, measure, samples, coefficients, section, natural_curvature.

    Returns
    -------
    tuple of NearestRod
        Results in the order of `curves`. If a rod could not be computed (invalid input, a crashed worker), its
        status is FAILED, and `message` gives the reason.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> [near.met for near in nearest_rods([arch, arch.reversed()], Limits(ratio=1.6))]
    [True, True]
    """
    require_curves(curves, "nearest_rods")
    require_executor(executor, "submit")
    if not (progress is None or callable(progress)):
        raise InputError(
            f"`progress` is {progress!r}: give a function of (curves done, curves in all), or None"
        )
    _require_options("nearest_rods", options)
    curves = list(curves)
    if not curves:
        raise InputError("nearest_rods has no curves: give at least one curve")
    count = len(curves)
    columns = (
        _values_each("limits", limits, count), _values_each("keep", keep, count),
        _values_each("gravity", gravity, count), _values_each("supports", supports, count),
    )  # fmt: skip
    tasks = [
        _Task(curve, *arguments, options=options)
        for curve, arguments in zip(curves, zip(*columns, strict=True), strict=True)
    ]
    results: dict[int, NearestRod] = {}
    for i, near in _in_order_of_completion(tasks, executor, LISTED):
        results[i] = near
        if progress is not None:
            progress(len(results), count)
    return tuple(results[i] for i in range(count))


def stream_nearest_rods(
    curves: Iterable[PlaneCurve],
    limits: Limits | None = None,
    keep: Keep | None = None,
    gravity: Gravity | None = None,
    *,
    supports: Supports | None = None,
    executor: Executor | None = None,
    ahead: int = AHEAD,
    **options: Any,
) -> Iterator[tuple[int, NearestRod]]:
    """Yield the nearest rod of each curve as soon as it is computed.

    The memory needed does not depend on the number of curves.

    Parameters
    ----------
    curves : iterable of PlaneCurve
        Curves, read one by one, so that a generator can be passed.
    limits, keep, gravity, supports, **options
        Arguments of `nearest_rods`, the same for all curves.
    executor : concurrent.futures.Executor, optional
        See `nearest_rods`.
    ahead : int
        Number of curves that are submitted at a time; use several for each worker.

    Yields
    ------
    tuple of int and NearestRod
        Index of the curve in `curves`, and its nearest rod. Failures are reported as in `nearest_rods`.

    Examples
    --------
    >>> arches = (PlaneCurve.spline([(0, 0), (30, h), (70, h), (100, 0)], degree=3) for h in (40, 50, 60))
    >>> [(i, near.met) for i, near in stream_nearest_rods(arches, Limits(ratio=1.6))]
    [(0, True), (1, True), (2, True)]
    """
    require_curves(curves, "stream_nearest_rods", "an iterable")
    require_executor(executor, "submit")
    _require_options("stream_nearest_rods", options)
    whole_number(ahead, "ahead", 1)
    tasks = (_Task(curve, limits, keep, gravity, supports, options) for curve in curves)
    return _in_order_of_completion(tasks, executor, ahead)


def _in_order_of_completion(
    tasks: Iterable["_Task"], executor: Executor | None, ahead: int
) -> Iterator[tuple[int, NearestRod]]:
    """Yield the index and the result of each task when it is complete, at most `ahead` tasks at a time."""
    running: dict[Future[NearestRod], tuple[int, _Task]] = {}
    finished: SimpleQueue[Future[NearestRod]] = SimpleQueue()

    def next_answer() -> tuple[int, NearestRod]:
        future = finished.get()
        i, task = running.pop(future)
        try:
            return i, future.result()
        except Exception as error:  # a crashed worker may raise any exception
            return i, _lost(task, error)

    try:
        for i, task in enumerate(tasks):
            if executor is None:
                yield i, _attempted(task)
                continue
            try:
                future = executor.submit(_attempted, task)
            except Exception as error:  # an executor that is shut down may raise any exception
                yield i, _lost(task, error)
                continue
            running[future] = i, task
            future.add_done_callback(finished.put)
            if len(running) >= ahead:
                yield next_answer()
        while running:
            yield next_answer()
    finally:
        for future in running:
            future.cancel()


class _Task(NamedTuple):
    """A curve with the request for its nearest rod, for a worker process."""

    curve: PlaneCurve
    limits: Limits | None
    keep: Keep | None
    gravity: Gravity | None
    supports: Supports | None
    options: dict[str, Any]


def _attempted(task: _Task) -> NearestRod:
    curve, limits, keep, gravity, supports, options = task
    try:
        return nearest_rod(curve, limits, keep, gravity, supports=supports, **options)
    except (ElasticaError, ArithmeticError, ValueError) as error:
        return NearestRod.failure(curve, str(error), limits, keep)


def _lost(task: _Task, error: Exception) -> NearestRod:
    why = note(
        "the executor returned no result ({kind_of_error}: {error}): run this curve again",
        kind_of_error=type(error).__name__,
        error=error,
    )
    return NearestRod.failure(task.curve, why, task.limits, task.keep)


def _values_each(name: str, value: Any, count: int) -> list[Any]:
    # one value for each curve
    if not isinstance(value, list | tuple):
        return [value] * count
    if len(value) != count:
        raise InputError(
            f"{name} has {len(value)} values for {count} curves: give one value for all, or {count} values"
        )
    return list(value)


def _require_options(function_name: str, options: dict[str, Any]) -> None:
    if unknown := set(options) - _OPTIONS:
        raise InputError(f"{function_name} has no option {min(unknown)!r}: use {', '.join(sorted(_OPTIONS))}")
