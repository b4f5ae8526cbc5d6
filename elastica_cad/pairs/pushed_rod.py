"""Clamped rod that is pushed at one point in steps, also past points where the rod snaps."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, pair
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.plane_points import left_of, norm, turn_between, unit, unit_vectors
from elastica_cad.mechanics.cross_sections import at_stations
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.rod import Rod
from elastica_cad.refusals import Length

EDGES = 480
"""Number of edges of the discrete rod (paper, section 7.1).

The relative error (1 / EDGES)^2 is as large as the error of a drawing.
"""

CALM = 1e-8
"""Largest sum of forces on a node at rest, as a fraction of the largest force in an edge."""

FIRST_DAMPING, LEAST_DAMPING, DAMPING_STEP = 1e-6, 1e-12, 4.0
"""First and least damping, as fractions of the largest nodal stiffness, and factor between successive values.

Damping is added if the energy is not convex, or if a step would increase the energy."""


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
    released : (n, 2) array
        Positions of the nodes, mm, at rest after the push is removed at the last step.
    s : (n,) array
        Arc lengths of the nodes, mm.
    at : float
        Arc length of the pushed point, mm.
    direction : (2,) array
        Unit vector of the push.
    """

    travel: FloatArray
    force: FloatArray
    energy: FloatArray
    position: FloatArray
    bend: FloatArray
    stretch: FloatArray
    released: FloatArray
    s: FloatArray
    at: float
    direction: FloatArray

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

    The point is free to move across the direction. At every step, the rod moves from its previous shape to a
    local minimum of the energy. The rod snaps where the local minimum ceases to exist.

    Parameters
    ----------
    rod : Rod
        Rod that is clamped at both ends, without weight, and obeys Hooke's law.
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
    if not 0 < at < _require_plain(rod).length:
        raise InputError("the rod is {length} long and cannot be pushed {at} from its start: push "
                         "the rod between its ends",
                         length=Length(rod.length), at=Length(at))  # fmt: skip
    away = pair(direction, "the direction of the push")
    if not away.any():
        raise InputError(f"the direction of the push is {direction!r}: give two numbers, not both 0")
    away = unit(away)
    chain = _Chain.of(rod, at, np.array([away, left_of(away)]), thickness)
    x = chain.settled(chain.start)
    free = x[chain.pushed, 0]
    steps = numbers(travel, "travel")
    states = []
    for u in steps:
        x = chain.settled(chain.led(x, free + u - x[chain.pushed, 0]), held=True)
        push = chain.gradient(x)[chain.pushed, 0]
        states.append((push, chain.energy(x), chain.placed(x), chain.bends(x), chain.stretch(x)))
    force, energy, position, bend, stretch = map(np.array, zip(*states, strict=True))
    released = chain.placed(chain.settled(x))
    return PushPath(steps, force, energy, position, bend, stretch, released, chain.s, at, away)


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
    chain = _Chain.of(_require_plain(rod), rod.length / 2, np.eye(2), thickness)
    x = chain.settled(chain.start)
    return RestShape(chain.s, chain.placed(x), chain.bends(x), chain.stretch(x))


def _require_plain(rod: Rod) -> Rod:
    require_free_between(rod, "A pushed rod")
    if not (rod.supports.clamped and rod.gravity is None and rod.bending_law is None):
        raise InputError(
            "a pushed rod can be computed only if both ends are clamped, without weight and with a linear "
            "material: leave out other supports, the weight or the material law"
        )
    return rod


@dataclass(frozen=True, eq=False)
class _Chain:
    """Discrete rod whose edges can stretch and whose nodes can bend.

    Positions x (n + 1, 2) are relative to the first node, with the first axis along the push.
    """

    s: FloatArray
    edge: FloatArray
    stiffness: FloatArray
    natural: FloatArray
    weight: FloatArray
    axial: FloatArray
    clamps: FloatArray
    start: FloatArray
    pushed: int
    frame: FloatArray
    origin: FloatArray

    @classmethod
    def of(cls, rod: Rod, at: float, frame: FloatArray, thickness: float | None) -> "_Chain":
        """Return the chain of a rod with a node at the pushed place, `at` mm from the start.

        Without a `thickness`, the rod hardly stretches.
        """
        pushed = int(np.clip(round(EDGES * at / rod.length), 1, EDGES - 1))
        s = np.append(
            np.linspace(0.0, at, pushed, endpoint=False), np.linspace(at, rod.length, EDGES - pushed + 1)
        )
        # a thinner rod hardly stretches, and its axial forces would have large rounding errors
        edge, h = np.diff(s), max(thickness or rod.length / 400, rod.length / 1000)
        ends = unit_vectors(rod.angle[[0, -1]])
        start = at_stations((rod.position - rod.position[0]).T, rod.s, s).T
        return cls(
            s=s, edge=edge, stiffness=rod.profile(s), natural=rod.rest_at(s),
            weight=(np.append(edge, 0.0) + np.append(0.0, edge)) / 2,
            axial=12 / h**2 * rod.profile(s[:-1] + edge / 2) ** (1 / 3), clamps=ends @ frame.T,
            start=start @ frame.T, pushed=pushed, frame=frame, origin=rod.position[0],
        )  # fmt: skip

    def placed(self, x: FloatArray) -> FloatArray:
        """Return the positions of the nodes (n + 1, 2), mm, in the coordinates of the drawing."""
        return self.origin + x @ self.frame

    def _edges(self, x: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return lengths (n,) and directions (n, 2) of the edges, and turning angles (n + 1,) at the nodes."""
        e = np.diff(x, axis=0)
        r = norm(e)
        t = e / r[:, None]
        around = np.concatenate([self.clamps[:1], t, self.clamps[1:]])
        return r, t, turn_between(around[:-1], around[1:])

    def bends(self, x: FloatArray) -> FloatArray:
        return self._edges(x)[2] / self.weight - self.natural

    def stretch(self, x: FloatArray) -> FloatArray:
        strain = self._edges(x)[0] / self.edge - 1
        return np.asarray((np.append(strain, strain[-1]) + np.append(strain[0], strain)) / 2)

    def energy(self, x: FloatArray) -> float:
        r, _, turn = self._edges(x)
        bent = self.stiffness * self.weight @ (turn / self.weight - self.natural) ** 2
        return float(bent + self.axial * self.edge @ (r / self.edge - 1) ** 2) / 2

    def gradient(self, x: FloatArray) -> FloatArray:
        """Return the forces (n + 1, 2) that hold the nodes, which are the derivatives of the energy."""
        force = self._edge_forces(x)
        return np.pad(force, ((1, 0), (0, 0))) - np.pad(force, ((0, 1), (0, 0)))

    def _edge_forces(self, x: FloatArray) -> FloatArray:
        r, t, shear, pull = self._loads(x)
        return (shear / r)[:, None] * left_of(t) + pull[:, None] * t

    def _loads(self, x: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return lengths and directions of the edges, differences of moments along the edges, and axial forces."""
        r, t, turn = self._edges(x)
        moment = self.stiffness * (turn / self.weight - self.natural)
        return r, t, moment[:-1] - moment[1:], self.axial * (r / self.edge - 1)

    def _band(self, x: FloatArray) -> FloatArray:
        """Return the second derivatives of the energy by the inner nodes, as an upper band (6, 2 n - 2) for SciPy.

        The second derivatives by the edge vectors are 2 x 2 blocks: A_i for edge i, and C_i for the edges i and
        i + 1 with a common node. An edge vector is a difference of two nodes, so the derivatives by the nodes are
        differences of blocks.
        """
        r, t, shear, pull = self._loads(x)
        n = left_of(t)
        K, a = self.stiffness / self.weight, n / r[:, None]

        def outer(scale: FloatArray, factor: FloatArray, other: FloatArray) -> FloatArray:
            return scale[:, None, None] * factor[:, :, None] * other[:, None, :]

        A = outer(self.axial / self.edge, t, t) + outer(pull / r, n, n) + outer(K[:-1] + K[1:], a, a)
        A -= outer(shear / r**2, n, t) + outer(shear / r**2, t, n)
        C = -outer(K[1:-1], a[:-1], a[1:])
        blocks = [A[:-1] + A[1:] - C - C.transpose(0, 2, 1), C[:-1] + C[1:] - A[1:-1], -C[1:-1]]
        band = np.zeros((6, 2 * r.size - 2))
        for apart, block in enumerate(blocks):
            for row in (0, 1):
                for column in (0, 1):
                    off = 2 * apart + column - row
                    if off >= 0:
                        band[5 - off, 2 * apart + column :: 2] = block[:, row, column]
        return band

    def led(self, x: FloatArray, by: float) -> FloatArray:
        """Return a linear estimate of the nodes after the pushed node has moved by `by` along the push."""
        step = _solved(*self._holding(self._band(x), by))
        moved = x.copy()
        if step is None:
            moved[self.pushed, 0] += by
        else:
            moved[1:-1] += step.reshape(-1, 2)
        return moved

    def _holding(self, band: FloatArray, by: float) -> tuple[FloatArray, FloatArray]:
        """Return the band and right-hand side of the equations in which the pushed node moves by `by`."""
        row, held, right = 2 * (self.pushed - 1), band.copy(), np.zeros(band.shape[1])
        for k in range(1, 6):
            held[5 - k, row] = 0.0
            if row - k >= 0:
                right[row - k] = -band[5 - k, row] * by
            if row + k < right.size:
                right[row + k], held[5 - k, row + k] = -band[5 - k, row + k] * by, 0.0
        held[5, row], right[row] = 1.0, by
        return held, right

    def settled(self, x: FloatArray, *, held: bool = False) -> FloatArray:
        """Return the nodes at a minimum of the energy near given nodes.

        If `held`, the pushed node does not move along the push.
        """
        damping, here, kicked = 0.0, self.energy(x), False
        shortest = self.edge.min()
        # rounding error of a force
        noise = 4e-15 * self.s[-1] / shortest * (self.axial.max() + self.stiffness.max() / shortest**2)
        for _ in range(2000):
            band, slope = self._band(x), self.gradient(x)[1:-1]
            if held:
                band, _ = self._holding(band, 0.0)
                slope[self.pushed - 1, 0] = 0.0
            pulls = max(float(np.abs(self._edge_forces(x)).max()), self.s[-1] ** -2)
            if np.abs(slope).max() <= max(CALM * pulls, noise):
                if damping == 0.0 or _solved(band, slope.ravel()) is not None:
                    return x
                if kicked:
                    break
                x, kicked = self._kicked(x, held), True
                here = self.energy(x)
                continue
            size = float(band[5].max())
            while True:
                shifted = band.copy()
                shifted[5] += damping * size
                step = _solved(shifted, -slope.ravel())
                if step is not None:
                    there = x.copy()
                    there[1:-1] += step.reshape(-1, 2)
                    energy = self.energy(there)
                    # near rest, rounding errors hide the decrease of the energy
                    if energy <= here or -slope.ravel() @ step <= 1e-11 * abs(here):
                        x, here = there, energy
                        damping = damping / DAMPING_STEP if damping > LEAST_DAMPING else 0.0
                        break
                damping = max(damping * DAMPING_STEP, FIRST_DAMPING)
                if damping > 1e6:
                    raise NotConvergedError(
                        "no equilibrium of the pushed rod was found: push it at another place"
                    )
        raise NotConvergedError(
            "no equilibrium of the pushed rod was found: push it less far, or at another place"
        )

    def _kicked(self, x: FloatArray, held: bool) -> FloatArray:
        """Return the nodes, displaced slightly, so that the rod can leave an unstable shape."""
        share = self.s / self.s[-1]
        # an asymmetric displacement moves the rod away from a saddle of the energy
        bow = 1e-4 * self.s[-1] * np.sin(np.pi * share) ** 2 * (np.sin(2 * np.pi * share) + 0.3)
        moved = np.asarray(x + bow[:, None] * np.array([0.6, 0.8]))
        if held:
            moved[self.pushed, 0] = x[self.pushed, 0]
        return moved


def _solved(band: FloatArray, right: FloatArray) -> FloatArray | None:
    """Return the solution, or None if the symmetric matrix is not positive definite."""
    from scipy.linalg import LinAlgError, solveh_banded

    try:
        return np.asarray(solveh_banded(band, right, check_finite=False))
    except LinAlgError:
        return None
