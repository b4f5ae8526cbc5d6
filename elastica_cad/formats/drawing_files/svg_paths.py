"""Paths as SVG writes them, all of a drawing at one go: thousands of holes are a million numbers."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline, points_on_circles
from elastica_cad.geometry.running_sums import numbers_in_groups

_LETTERS = {2: "Q", 3: "C"}


def path_data(paths: Sequence[Path], origin: FloatArray) -> list[str]:
    """The d attributes of paths of lines, arcs and clamped polynomial splines of degree 2 and 3.

    Parameters
    ----------
    paths : sequence of Path
    origin : (2,) array
        The upper left corner of the sheet, mm; y runs downward there.

    Examples
    --------
    >>> path_data([Path.rectangle(40, 10)], np.array([-1.0, 11.0]))
    ['M1,11L41,11L41,1L1,1Z']
    """
    drawn = [_drawn(path) for path in paths]
    segments = [segment for own in drawn for segment in own]
    numbers = np.array([len(own) for own in drawn], dtype=int)
    # before the segments of each path stands the move to its start
    places = np.arange(len(segments)) + np.repeat(np.arange(len(paths)), numbers) + 1
    moves = np.cumsum(numbers + 1) - numbers - 1
    starts = np.array([path.start for path in paths]).reshape(-1, 2)
    strokes = [
        _Strokes(moves, np.ones(len(paths), dtype=int), ["M"] * len(paths), starts),
        *(one._replace(which=places[one.which]) for one in _strokes(segments)),
    ]
    counts, words, points = _in_order(strokes)
    x, y = ((points - origin) * (1, -1)).T.tolist()
    parts = [","] * (4 * len(words))
    parts[0::4], parts[1::4], parts[3::4] = words, _numbers(x), _numbers(y)
    begins = 4 * (np.cumsum(counts) - counts)[moves]
    return [
        "".join([*parts[begin:end], "Z" if path.closed else ""])
        for path, begin, end in zip(paths, begins, [*begins[1:], len(parts)], strict=True)
    ]


def format_length(value: float) -> str:
    """A length to 1e-6 mm, as short as it goes."""
    return _numbers([value])[0]


def _numbers(values: Iterable[float]) -> list[str]:
    # most of them have no zeros at their end
    return [text if text[-1] != "0" else _shortened(text) for text in [f"{value:.6f}" for value in values]]


def _shortened(text: str) -> str:
    """A decimal number without the zeros at its end."""
    short = text.rstrip("0").rstrip(".")
    return "0" if short == "-0" else short


def _drawn(path: Path) -> tuple[Segment, ...]:
    """The segments that are written: the closing line is drawn by Z."""
    closing = path.closed and isinstance(path.segments[-1], Line)
    return path.segments[:-1] if closing else path.segments


class _Strokes(NamedTuple):
    """Numbers (k,) of strokes, how many points (k,) each goes to, what is written before each, and these (n, 2)."""

    which: IntArray
    counts: IntArray
    words: list[str]
    points: FloatArray


def _in_order(strokes: Sequence[_Strokes]) -> tuple[IntArray, list[str], FloatArray]:
    """How many points each stroke goes to, and all words and points in the order of the strokes."""
    counts = np.zeros(sum(one.which.size for one in strokes), dtype=int)
    for one in strokes:
        counts[one.which] = one.counts
    begins, total = np.cumsum(counts) - counts, int(counts.sum())
    words, points = np.empty(total, dtype=object), np.empty((total, 2))
    for one in strokes:
        rows = numbers_in_groups(one.counts) + np.repeat(begins[one.which], one.counts)
        words[rows], points[rows] = one.words, one.points
    return counts, words.tolist(), points


def _strokes(segments: Sequence[Segment]) -> Iterator[_Strokes]:
    """Segments of one kind at a time."""
    lines = [i for i, segment in enumerate(segments) if isinstance(segment, Line)]
    if lines:
        ends = np.array([segments[i].end for i in lines])
        yield _Strokes(np.array(lines), np.ones(len(lines), dtype=int), ["L"] * len(lines), ends)
    arcs = [(i, segment) for i, segment in enumerate(segments) if isinstance(segment, Arc)]
    if arcs:
        yield _arcs(np.array([i for i, _ in arcs]), [arc for _, arc in arcs])
    curves = [(i, segment.curve) for i, segment in enumerate(segments) if isinstance(segment, Spline)]
    for degree in sorted({curve.degree for _, curve in curves}):
        alike = [(i, curve) for i, curve in curves if curve.degree == degree]
        tables = [curve.bezier_table[1] for _, curve in alike]
        pieces = np.array([len(own) for own in tables])
        rows = np.concatenate(tables)
        points = rows[..., :2] / rows[..., 2:]
        words = [_LETTERS[degree], *[" "] * (degree - 1)] * len(points)
        which = np.array([i for i, _ in alike])
        yield _Strokes(which, degree * pieces, words, points[:, 1:].reshape(-1, 2))


def _arcs(which: IntArray, arcs: Sequence[Arc]) -> _Strokes:
    """More than half a turn in two parts: a whole turn has no ends, and nearly one is badly conditioned."""
    center = np.array([arc.center for arc in arcs])
    shape = np.array([(arc.radius, arc.start_angle, arc.end_angle, arc.sweep) for arc in arcs])
    radius, start, end, sweep = shape.T
    long = np.abs(sweep) > np.pi * (1 + 1e-9)
    counts = np.where(long, 2, 1)
    each, last = np.repeat(np.arange(counts.size), counts), numbers_in_groups(counts) == 1
    angle = np.where(long[each], start[each] + sweep[each] * np.where(last, 1.0, 0.5), end[each])
    points = points_on_circles(center[each], radius[each], angle)
    told = [
        f"A{size} {size} 0 0 {'0' if turn > 0 else '1'} "
        for size, turn in zip(_numbers(radius.tolist()), sweep.tolist(), strict=True)
    ]
    return _Strokes(which, counts, [told[k] for k in each.tolist()], points)
