"""How much material is left at a station of a flat part, measured on its loops, and the rod that this makes."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.styles import Layout
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.rod.rod_record import Rod

CUTS = 8
"""Stations at which the material of each cell of the rod is measured."""


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
