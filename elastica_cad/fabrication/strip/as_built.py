"""How much material is left at a station of a flat part, measured on its loops, and the rod that this makes."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Arc, Spline
from elastica_cad.geometry.running_sums import numbers_in_groups
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.rod.rod_record import Rod

CUTS = 8
"""Stations at which the material of each cell of the rod is measured."""

SPAN_CHORDS, FLAT_MM = 16, 1e-4
"""Chords for each span of a spline, and how near they come to an arc: widths are right to a few parts in a million.
"""


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


def _widths(loops: Sequence[Path], s: FloatArray) -> FloatArray:
    """Lengths (n,) inside loops of the lines across at `s`, summed: each loop's signed sum of its crossings' y."""
    order = np.argsort(s, kind="stable")
    at, total = s[order], np.zeros(s.size)
    for loop in loops:
        (x, y), (x1, y1) = (points := _chords(loop)).T, np.roll(points, -1, axis=0).T
        # which chord meets which of the sorted stations: min <= s < max
        first = np.searchsorted(at, np.minimum(x, x1), side="left")
        count = np.searchsorted(at, np.maximum(x, x1), side="left") - first
        line = np.repeat(np.arange(x.size), count)
        station = numbers_in_groups(count) + np.repeat(first, count)
        u = (at[station] - x[line]) / (x1 - x)[line]
        crossing = np.sign(x - x1)[line] * (y[line] * (1 - u) + y1[line] * u)
        # a loop is run round either way
        total += np.sign(crossing.sum()) * np.bincount(station, crossing, minlength=at.size)
    found = np.empty(s.size)
    found[order] = total
    return found


def _chords(loop: Path) -> FloatArray:
    """Where the chords of a closed loop begin (n, 2)."""
    rows = []
    for segment in loop.segments:
        parts = 1
        if isinstance(segment, Spline):
            parts = SPAN_CHORDS * (np.unique(segment.curve.knots).size - 1)
        elif isinstance(segment, Arc):
            parts = int(np.ceil(abs(segment.sweep) * np.sqrt(segment.radius / (8 * FLAT_MM))))
        rows.append(segment.at(np.arange(parts) / parts))
    return np.concatenate(rows)
