"""Clamped rod that is pushed at one point in steps, also past points where the rod snaps.

The rod is a discrete rod with axial elasticity (`Compression`), because the constraints of a rod that cannot
stretch nearly depend on each other at a snap. The push is a `Guide`: it holds one point along the direction of the
push, and its force is the force of the push.
"""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, pair
from elastica_cad.errors import InputError, Length, NotConvergedError
from elastica_cad.geometry.plane_points import midpoints, norm, unit
from elastica_cad.mechanics.bending import state_of, system_of
from elastica_cad.mechanics.discrete_rod import Compression
from elastica_cad.mechanics.elements import ElementForce, Guide, Mount, require_free_between
from elastica_cad.mechanics.followed_path import FollowedPath, Segment, Visit, followed, shape_of
from elastica_cad.mechanics.newton_continuation import correct, relax
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.rod_system import RodState


@dataclass(frozen=True, eq=False)
class RestShape:
    """Rest shape of a clamped rod that can also stretch.

    Attributes
    ----------
    s : (n,) array
        Arc lengths of the nodes, mm.
    position : (n, 2) array
        Positions of the nodes, mm.
    bend : (n,) array
        Changes of curvature at the nodes, 1/mm.
    stretch : (n,) array
        Axial strains at the nodes.
    """

    s: FloatArray
    position: FloatArray
    bend: FloatArray
    stretch: FloatArray


@dataclass(frozen=True, eq=False)
class PushPath:
    """Shapes and forces of a rod while it is pushed in k steps.

    Attributes
    ----------
    travel : (k,) array
        Displacements of the pushed point along the push, mm.
    force : (k,) array
        Forces of the push divided by the least bending stiffness, 1/mm2. Negative forces hold the rod back.
    energy : (k,) array
        Energies of bending and stretching, divided by the least bending stiffness, 1/mm.
    position : (k, n, 2) array
        Positions of the nodes, mm.
    bend : (k, n) array
        Changes of curvature at the nodes, 1/mm.
    stretch : (k, n) array
        Axial strains at the nodes.
    way : FollowedPath
        Equilibria along the whole travel.
    """

    travel: FloatArray
    force: FloatArray
    energy: FloatArray
    position: FloatArray
    bend: FloatArray
    stretch: FloatArray
    way: FollowedPath

    @classmethod
    def listed(cls, way: FollowedPath, travel: FloatArray, length: float) -> "PushPath":
        """Return shapes and forces at the displacements `travel` (k,), mm, on a path of this length, mm."""
        states = [way.at(u / length).state for u in travel]
        position, bend, stretch = map(np.array, zip(*map(_nodal, states), strict=True))
        force, energy = np.array([(state.reactions[-1], state.energy) for state in states]).T
        return cls(travel, force, energy, position, bend, stretch, way)

    @property
    def released(self) -> FloatArray:
        """Positions (n, 2) of the nodes, mm, at rest after the push is removed at the end of the travel."""
        last = self.way.visits[-1].state
        # the first two reactions are those of the clamps
        return _settled(replace(last.system, actions=()).state(last.angles, last.reactions[:2])).position

    def finer(self, travel: FloatArray) -> "PushPath":
        """Return the path with more shapes, at the displacements `travel`, mm, of the same push."""
        more = self.listed(self.way, travel, float(self.travel[-1]))
        order = np.argsort(np.concatenate([self.travel, travel]), kind="stable")
        rows = {name: np.concatenate([value, getattr(more, name)])[order]
                for name, value in vars(self).items() if name != "way"}  # fmt: skip
        return PushPath(**rows, way=self.way)

    @property
    def visited(self) -> tuple[FloatArray, FloatArray]:
        """Changes of curvature, 1/mm, and axial strains (v, n) of the shapes from which the path was computed."""
        _, bend, stretch = zip(*(_nodal(visit.state) for visit in self.way.visits), strict=True)
        return np.array(bend), np.array(stretch)

    @property
    def largest_force(self) -> float:
        """Largest value of `force` up to the snap, or over the whole travel if the rod does not snap.

        It is a force divided by the least bending stiffness, 1/mm2.
        """
        return float(self.force[self.travel <= (self.travel[-1] if self.snap is None else self.snap)].max())

    @property
    def snap(self) -> float | None:
        """Travel, mm, at which the push drops to zero and the rod snaps, or None."""
        gone = np.flatnonzero((self.force[1:] <= 0) & (self.force[:-1] > 0))
        if not gone.size:
            return None
        i = gone[0]
        share = self.force[i] / (self.force[i] - self.force[i + 1])
        return float(self.travel[i] + share * (self.travel[i + 1] - self.travel[i]))

    @property
    def barrier(self) -> float:
        """Work of the push up to the snap, divided by the least bending stiffness, 1/mm.

        A push at another point may need less work.
        """
        end = self.travel[-1] if self.snap is None else self.snap
        return float(np.interp(end, self.travel, self.energy) - self.energy[0])


def push_path(
    rod: Rod, at: float, direction: ArrayLike, travel: ArrayLike, *, thickness: float | None = None
) -> PushPath:
    """Return the path of a clamped rod that is pushed at a point in a direction.

    The point is free to move across the direction. The shapes are stable equilibria of the rod with the point held
    along the direction. Where such an equilibrium ends or becomes unstable, the rod snaps: it moves to a local
    minimum of the energy with the point held at the same place.

    Parameters
    ----------
    rod : Rod
        Rod that is clamped at both ends, without weight, and obeys Hooke's law. Its nodes are those of the result.
    at : float
        Arc length of the pushed point between the ends, mm.
    direction : (2,) array_like
        Direction of the push.
    travel : (k,) array_like
        Displacements from the shape of the rod, mm.
    thickness : float, optional
        Thickness in the plane at the softest point of the rod, mm; by default 1/400 of the length. The
        thickness determines the axial stiffness. The bending stiffness is proportional to the cube of the
        thickness.

    Raises
    ------
    NotConvergedError
        No rest shape is found.

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> arch = bend(Rod.straight(100.0), end=(95.0, 0.0))
    >>> path = push_path(arch, 50.0, (0, -1), np.linspace(0, 40, 21))
    >>> abs(path.force[0]) < 1e-4 < path.largest_force, path.snap is not None
    (True, True)
    """
    free = _rest_state(rod, thickness)
    if not 0 < at < rod.length:
        raise InputError("the rod is {length} long and cannot be pushed {at} from its start: push "
                         "the rod between its ends",
                         length=Length(rod.length), at=Length(at))  # fmt: skip
    away = pair(direction, "the direction of the push")
    if not away.any():
        raise InputError(f"the direction of the push is {direction!r}: give two numbers, not both 0")
    away = unit(away)
    steps, place, reactions = numbers(travel, "travel"), shape_of(free).at(at), free.reactions
    guide = ElementForce(Guide((float(away[0]), float(away[1]))), np.array([at]), np.zeros((1, 2)))
    first, last = (Mount(tuple((place + u * away).tolist())) for u in (0.0, steps[-1]))
    # ends and loads do not change; only the place of the guide moves
    segment = Segment(free.system, free.system, (replace(guide, mount=last),), (first,))
    begin = segment.system(0.0, (guide,), (True,)).state(free.angles, reactions)
    way = followed(segment, Visit.of(0.0, begin, (guide,), (True,)))
    return PushPath.listed(way, steps, float(steps[-1]))


def rest_shape(rod: Rod, *, thickness: float | None = None) -> RestShape:
    """Return the rest shape of a clamped rod that can stretch, starting from its unstretched shape.

    Parameters
    ----------
    rod, thickness
        As in `push_path`.

    Raises
    ------
    NotConvergedError
        No rest shape is found.

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> arch = bend(Rod.straight(100.0), end=(95.0, 0.0))
    >>> float(rest_shape(arch, thickness=1.0).stretch.max()) < 0
    True
    """
    return RestShape(rod.s, *_nodal(_rest_state(rod, thickness)))


def _rest_state(rod: Rod, thickness: float | None) -> RodState:
    """Return the rest state near the shape of the rod, whose nominal lengths are those without a force."""
    require_free_between(rod, "A pushed rod")
    if not (rod.supports.clamped and rod.gravity is None and rod.bending_law is None):
        raise InputError(
            "a pushed rod can be computed only if both ends are clamped, without weight and with a linear "
            "material: leave out other supports, the weight or the material law"
        )
    # a thinner rod hardly stretches, and a push that makes it taut would need an unlimited force
    h = max(thickness or rod.length / 400, rod.length / 1000)
    compliance = h**2 / 12 / rod.profile(midpoints(rod.s)) ** (1 / 3)
    system = replace(system_of(rod, rod), compression=Compression(compliance, np.zeros_like(compliance)))
    return _settled(state_of(rod, system))


def _settled(state: RodState) -> RodState:
    """Return the stable equilibrium that a rod reaches from a state, smoothly or by a snap."""
    corrected = correct(state)
    rest = relax(state) if corrected is None or corrected[0].discrete.unstable_modes else corrected[0]
    if rest is None:
        raise NotConvergedError(
            "no equilibrium of the pushed rod was found: push it less far, or at another place"
        )
    return rest


def _nodal(state: RodState) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the positions (n, 2), mm, changes of curvature (n,), 1/mm, and axial strains (n,) of the nodes."""
    strain = np.pad(norm(state.discrete.tangents) - 1, 1, mode="edge")
    return state.position, state.moments / state.system.stiffness, midpoints(strain)
