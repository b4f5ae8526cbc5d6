"""A rod on another number of nodes."""

from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.mechanics.loads.arguments import whole_number
from elastica_cad.mechanics.material.stiffness_law import at_stations
from elastica_cad.mechanics.rod.discrete_rod import edge_positions, tangents
from elastica_cad.mechanics.rod.nodal_stiffness import nodal_stiffness
from elastica_cad.mechanics.rod.rod_record import Rod


def resample(rod: Rod, samples: int) -> Rod:
    """The same rod on another number of nodes: stiffness from its profile, the rest interpolated, its law too."""
    whole_number(samples, "samples", 4)
    s = np.linspace(0.0, rod.length, samples)
    K = nodal_stiffness(rod.profile, s)

    def at(values: FloatArray) -> FloatArray:
        return np.asarray(np.interp(s, rod.s, values))

    middles = (s[:-1] + s[1:]) / 2
    angles = np.interp(middles, (rod.s[:-1] + rod.s[1:]) / 2, rod.discrete.angles)
    return replace(
        rod, s=s, position=edge_positions(rod.position[0], tangents(angles), s[1]), angle=at(rod.angle),
        curvature=at(rod.curvature), stiffness=K / K.min(), profile=rod.profile.scaled(1 / float(K.min())),
        moment=at(rod.moment), force=np.column_stack([at(rod.force[:, 0]), at(rod.force[:, 1])]),
        natural_curvature=at_stations(rod.natural_curvature, rod.s, s),
        law=None if rod.law is None else rod.law.resampled(rod.s, s),
    )  # fmt: skip
