"""How much material is left at a station of a flat part, measured on its loops, and the rod that this makes."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import numbers
from elastica_cad.fabrication.strip.flat_outline import paces
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Segment, Spline, chord_points
from elastica_cad.geometry.running_sums import numbers_in_groups
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.rod.rod_record import Rod

CUTS = 8
"""Stations at which the material of each cell of the rod is measured."""

CHORD_MM = 1e-5
"""Flatness of the polylines that are measured: widths are then right to a few parts in a million."""


def material_width(outline: Path, holes: Iterable[Path], s: ArrayLike) -> FloatArray:
    """Summed width (n,), mm, of what a straight cut across at the stations `s` (n,) meets.

    Parameters
    ----------
    outline, holes : Path
        Closed loops of a flat pattern, x along the strip.
    s : (n,) array_like
        mm; at a station where a loop has an edge straight across, the side beyond it counts.

    Examples
    --------
    >>> plate = Path.rectangle(40, 10)
    >>> material_width(plate, [Path.rectangle(10, 4, corner=(5, 3))], [2.0, 8.0]).round(6).tolist()
    [10.0, 6.0]
    """
    s = np.atleast_1d(numbers(s, "stations"))
    return _widths([outline], s) - _widths(tuple(holes), s)


def rod_as_built(rod: Rod, layout: Layout, widths: Sequence[Callable[[FloatArray], FloatArray]]) -> Rod:
    """The rod with the stiffness and weight of what is really cut: slots, solid ends, rounded tips.

    Each node is softer than designed by as much as the mean compliance of its cell, which is what the angle across
    the cell feels. Weight follows; a rod whose own weight is in newtons has it scaled with the material, hung
    masses stay.

    Parameters
    ----------
    rod : Rod
        The design.
    layout : Layout
        What the style made of it.
    widths : sequence of callables
        Of each layer, the width (n,), mm, left at stations (n,), mm.

    Returns
    -------
    Rod
        The design's shape, supports and gravity: out of balance until bent.
    """
    if layout.size is not None:  # tapered: nothing is cut out of it
        return replace(rod, bending_stiffness=layout.bending_stiffness)
    n, s = rod.s.size, cell_stations(rod)
    left = [width(s) for width in widths]
    material = left[0]
    # as drawn, the backing's edge may pass the base's by the tolerance of the drawing
    backing = np.minimum(left[1], material) if len(left) > 1 else None
    law = None if layout.section is None else layout.section.bent(rod.bend_at(s), rod.rest_at(s))
    has = layout.stiffness(material, backing) if law is None else law.bending_stiffness(material)
    asked = rod.profile(s)
    softer = layout.bending_stiffness * asked / has
    EI = layout.bending_stiffness * _stiffness_of_cells(rod, asked) / cell_means(softer, n)
    least = float(EI.min())
    made = replace(rod.with_stiffness(Profile.interpolate(rod.s, EI)), bending_stiffness=least)
    if rod.gravity is None:
        return made
    weight = rod.weight or Weight()
    newtons = layout.weight_per_length(material, backing) if law is None else law.weight_per_length(material)
    if newtons is not None:
        along = Profile.interpolate(rod.s, cell_means(newtons, n))
        return replace(made, weight=replace(weight, alpha=along, beta=0.0))
    if rod.weight is None:
        return made
    return replace(made, weight=weight.scaled(beta=least / layout.bending_stiffness))


def _stiffness_of_cells(rod: Rod, asked: FloatArray) -> FloatArray:
    """K (n,) at the nodes; where it jumps inside a cell, that of the cell's mean compliance."""
    K = rod.stiffness.copy()
    half = rod.length / (rod.s.size - 1) / 2
    if rod.profile.steps:
        jumps = np.array([start for start, _ in rod.profile.steps])
        near = np.abs(rod.s[:, None] - jumps).min(axis=1) <= half
        K[near] = 1 / cell_means(1 / asked, rod.s.size)[near]
    return K


def cell_stations(rod: Rod) -> FloatArray:
    """Stations, mm, at the middle of `CUTS` even parts of every edge of a rod."""
    ends = np.linspace(0.0, rod.length, CUTS * (rod.s.size - 1) + 1)
    return np.asarray((ends[1:] + ends[:-1]) / 2)


def cell_means(values: FloatArray, nodes: int) -> FloatArray:
    """Mean (n,) over the cell of each node of values at uniform stations, `CUTS` between neighbouring nodes."""
    halves = values.reshape(2 * (nodes - 1), CUTS // 2).mean(axis=1)
    inner = (halves[1:-1:2] + halves[2::2]) / 2
    return np.concatenate([halves[:1], inner, halves[-1:]])


class _Side(NamedTuple):
    """A segment of a loop, the one after it, and the loop's number."""

    segment: Segment
    following: Segment
    loop: int


def _widths(loops: Sequence[Path], s: FloatArray) -> FloatArray:
    """Lengths (n,) inside loops of the lines across at `s`, summed: each loop's signed sum of its crossings' y."""
    order = np.argsort(s, kind="stable")
    at = s[order]
    sides = [
        _Side(segment, following, k)
        for k, loop in enumerate(loops)
        for segment, following in pairwise((*loop.segments, loop.segments[0]))
    ]
    splines = [i for i, side in enumerate(sides) if isinstance(side.segment, Spline)]
    motion = np.full((len(sides), 2), np.nan)
    motion[splines] = paces([side.segment for side in sides if isinstance(side.segment, Spline)])
    even = np.isfinite(motion[:, 0])
    runs = [side for side, runs_evenly in zip(sides, even.tolist(), strict=True) if runs_evenly]
    rest = [side for side, runs_evenly in zip(sides, even.tolist(), strict=True) if not runs_evenly]
    found = [*_even_crossings(runs, motion[even], at), *_drawn_crossings(rest, at)]
    if not found:
        return np.zeros(s.shape)
    loop, station, y = (np.concatenate(part) for part in zip(*found, strict=True))
    # a loop is run round either way
    way = np.sign(np.bincount(loop, y, minlength=len(loops)))
    total = np.zeros(s.shape)
    total[order] = np.bincount(station, way[loop] * y, minlength=at.size)
    return total


Crossings: TypeAlias = tuple[IntArray, IntArray, FloatArray]
"""Numbers (k,) of the loops, of the stations, and the signed y."""


def _even_crossings(sides: Sequence[_Side], motion: FloatArray, at: FloatArray) -> Iterator[Crossings]:
    """Of splines along which x runs evenly, with offset and speed (n, 2): exact."""
    if not sides:
        return
    curves = [side.segment.curve for side in sides if isinstance(side.segment, Spline)]
    owner = np.array([side.loop for side in sides])
    x0 = np.array([side.segment.start[0] for side in sides], dtype=float)
    x1 = np.array([side.following.start[0] for side in sides], dtype=float)
    which, station = _met(at, x0, x1)
    offset, speed = motion.T
    t = np.clip((at[station] - offset[which]) / speed[which], *np.array([c.domain for c in curves])[which].T)
    y = np.empty(t.size)
    for own in np.split(np.argsort(which, kind="stable"), np.cumsum(np.bincount(which))[:-1]):
        y[own] = curves[which[own[0]]].evaluate(t[own])[:, 1] if own.size else 0.0
    yield owner[which], station, np.sign(x0 - x1)[which] * y


def _drawn_crossings(sides: Sequence[_Side], at: FloatArray) -> Iterator[Crossings]:
    """Of all other segments, by their chords."""
    if not sides:
        return
    chords = [chord_points(side.segment, CHORD_MM)[:-1] for side in sides]
    counts, start = np.array([len(points) for points in chords]), np.concatenate(chords)
    owner = np.repeat([side.loop for side in sides], counts)
    end = np.empty_like(start)
    end[:-1] = start[1:]
    some = counts > 0
    end[np.cumsum(counts)[some] - 1] = np.array([side.following.start for side in sides])[some]
    (x, y), (x1, y1) = start.T, end.T
    line, station = _met(at, x, x1)
    u = (at[station] - x[line]) / (x1 - x)[line]
    crossing = np.sign(x[line] - x1[line]) * (y[line] * (1 - u) + y1[line] * u)
    yield owner[line], station, crossing


def _met(at: FloatArray, x0: FloatArray, x1: FloatArray) -> tuple[IntArray, IntArray]:
    """Which line (k,) between x0 and x1 (m,) meets which of the sorted stations: min <= s < max."""
    first = np.searchsorted(at, np.minimum(x0, x1), side="left")
    count = np.searchsorted(at, np.maximum(x0, x1), side="left") - first
    line = np.repeat(np.arange(x0.size), count)
    return line, numbers_in_groups(count) + np.repeat(first, count)
