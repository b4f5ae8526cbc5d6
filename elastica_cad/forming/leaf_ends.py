"""Ends of the plies of a glued stack, placed so that it bends as near as possible to a curve."""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.loads import Weight
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stiffness_law import LaidLeaves, Leaf, LeavesLaw

NODES = 401
"""Number of nodes of the rods in the search. A step inside a cell is averaged over the cell, so the shape is a
continuous function of the place of the step."""

FINE_NODES = 1001
"""Number of nodes of the returned rod; with fewer, a nearly unstable rod has an error of 1e-4 of its length."""

SHORTEST_SHARE = 0.01
"""Shortest piece of a leaf, and shortest distance between ends, as a share of the length."""

ROUNDINGS = (0.35, 0.5, 0.65)
"""Fractions of a ply above which a ply is laid; each starts a search, and the best result is returned."""

DIFFERENCE = 1e-4
"""Step of the finite differences in the search, as a share of the length."""

SETTLED = 1e-7
"""Relative change of the distance and of the places that ends the search."""

MOST_TRIALS = 60  # largest number of trials in a search, each with a finite difference for every end


@dataclass(frozen=True, eq=False)
class LeafedRod:
    """A bent rod of glued plies.

    Attributes
    ----------
    rod : Rod
        Rest shape computed with the stiffness of the plies in `section`.
    section : LaidLeaves
    deviation, mean_deviation : float
        Largest and root mean square distance, mm, to `relaxed`, between points at the same fraction of the length.
    relaxed : Rod
        The rod of continuous thickness that the plies approximate.
    settled : bool
        True if the search ended at a local optimum.
    """

    rod: Rod
    section: LaidLeaves
    deviation: float
    mean_deviation: float
    relaxed: Rod
    settled: bool

    @property
    def leaves(self) -> tuple[Leaf, ...]:
        """The plies: full length first, then by number."""
        return self.section.leaves


def leaf_bends(rod: Rod, section: LaidLeaves) -> tuple[FloatArray, FloatArray]:
    """Stations (n,), mm, with both sides of each step, and their change of curvature |M| / E I, 1/mm."""
    beside = 1e-9 * rod.length
    s = np.sort(np.concatenate([rod.s, section.steps - beside, section.steps + beside]))
    EI = section.bending_stiffness(section.sheet.thickness * section.counts(s))
    moment = np.interp(s, rod.s, rod.moment) * float(rod.bending_stiffness or 1.0)
    return s, np.abs(moment) / EI


def lay_leaves(relaxed: Rod, law: LeavesLaw, *, tangents: tuple[bool, bool] = (False, False)) -> LeafedRod:
    """Approximate a rod of continuous thickness by plies.

    Plies are first laid where the rod is thick. Then their ends, and the angles of clamps that may turn, are
    optimised for the least distance; the result is a local optimum.

    Parameters
    ----------
    relaxed : Rod
        Rod with a `bending_stiffness` between the stiffness of the fewest plies and of all plies.
    law : LeavesLaw
    tangents : (bool, bool)
        True for each end (start, end) that keeps its angle.

    Raises
    ------
    NotConvergedError
        No stack has a rest shape between the same ends.
    """
    if not isinstance(law, LeavesLaw):
        raise InputError(f"the law is {law!r}: give a LeavesLaw(sheet, leaves, width)")
    drawn = relaxed.curve.sample(NODES).position
    searches: dict[tuple[tuple[int, ...], ...], _Search] = {}
    for rounding in ROUNDINGS:
        search = _Search.of(relaxed, law, drawn, rounding, tangents)
        searches.setdefault(tuple(map(tuple, search.steps.tolist())), search)
    stacks = [answer for search in searches.values() if (answer := search.answer()) is not None]
    if not stacks:
        raise NotConvergedError(
            f"no stack of {law.leaves} plies has a rest shape near this curve: use more and thinner plies"
        )
    best = min(stacks, key=lambda stack: stack.mean_deviation)
    if not best.section.steps.size and relaxed.gravity is None:
        # if all plies have full length, their number does not affect the shape, so the fewest plies suffice
        bare = _Search(
            relaxed,
            law,
            drawn,
            np.zeros((0, 2), dtype=int),
            np.zeros(0),
            tuple(range(1, law.fewest + 1)),
            tangents,
        )
        best = bare.answer() or best
    return best


@dataclass(frozen=True, eq=False)
class _Search:
    """Search for the places of steps in a given order, and for clamp angles, that bring a stack nearest to points.

    Attributes
    ----------
    steps : (m, 2) int array
        Number of the leaf that begins (+1) or ends (-1) at each place, in the order of `places`.
    places : (m,) array
        Initial places, in lengths.
    first : tuple of int
        Numbers of the leaves that begin at the start.
    tangents : (bool, bool)
    """

    relaxed: Rod
    law: LeavesLaw
    drawn: FloatArray
    steps: IntArray
    places: FloatArray
    first: tuple[int, ...]
    tangents: tuple[bool, bool] = (False, False)

    @classmethod
    def of(
        cls, relaxed: Rod, law: LeavesLaw, drawn: FloatArray, rounding: float,
        tangents: tuple[bool, bool] = (False, False),
    ) -> "_Search":  # fmt: skip
        """Leaf k where the relaxed thickness is more than k - 1 + `rounding` leaves."""
        s = np.linspace(0.0, 1.0, 20 * NODES)
        EI = relaxed.profile(s * relaxed.length) * float(relaxed.bending_stiffness or 1.0)
        leaves = law.relaxed.parameter(EI) / law.sheet.thickness
        steps: list[tuple[float, int, int]] = []
        first = list(range(1, law.fewest + 1))
        for number in range(law.fewest + 1, law.leaves + 1):
            inside = leaves > number - 1 + rounding
            edges = np.flatnonzero(np.diff(inside.astype(int)))
            signs = np.diff(inside.astype(int))[edges]
            first += [number] if inside[0] else []
            steps += [(float(s[i + 1]), number, int(sign)) for i, sign in zip(edges, signs, strict=True)]
        steps.sort()
        return cls(
            relaxed, law, drawn, np.array([(number, sign) for _, number, sign in steps]).reshape(-1, 2),
            np.array([at for at, _, _ in steps]), tuple(first), tangents,
        )  # fmt: skip

    @property
    def turned(self) -> list[int]:
        """Clamped ends (0, 1) whose angle may change."""
        return [i for i, end in enumerate(self.relaxed.supports.ends) if end.angle and not self.tangents[i]]

    def answer(self) -> LeafedRod | None:
        """Return the best stack, or None if no stack has a rest shape."""
        from scipy.optimize import least_squares

        start = np.concatenate([self.places, self.relaxed.angle[[0, -1]][self.turned]])
        try:
            known = self._bent(start, self.relaxed)
        except (InputError, NotConvergedError):
            return None
        shape = [known]
        missed = partial(self._missed, shape=shape)
        if not start.size:
            return self._record(start, known, settled=True)
        low = np.full(start.size, -np.inf)
        high = np.full(start.size, np.inf)
        low[: self.places.size], high[: self.places.size] = 0.0, 1.0
        optimum = least_squares(
            missed, start, bounds=(low, high), diff_step=DIFFERENCE, ftol=SETTLED, xtol=SETTLED, gtol=1e-12,
            max_nfev=MOST_TRIALS, x_scale="jac",
        )  # fmt: skip
        return self._record(optimum.x, self._bent(optimum.x, shape[0]), settled=optimum.status > 0)

    def _missed(self, x: FloatArray, shape: list[Rod]) -> FloatArray:
        """Distances from the drawn points in lengths; large values if the stack has no rest shape."""
        try:
            rod = self._bent(x, shape[0])
        except (InputError, NotConvergedError):
            return np.ones(2 * NODES)
        shape[0] = rod
        return np.asarray((rod.position - self.drawn).ravel() / (rod.length * np.sqrt(NODES)))

    def _apart(self, places: FloatArray) -> FloatArray:
        """Return the places sorted, with at least the shortest piece between them and at the ends."""
        m = places.size
        room = min(SHORTEST_SHARE, 0.5 / (m + 1))
        low, high = room * np.arange(1, m + 1), 1 - room * np.arange(m, 0, -1)
        gaps = np.clip(np.sort(places), low, high) - low
        return np.asarray(np.maximum.accumulate(gaps) + low)

    def _bent(self, x: FloatArray, guess: Rod) -> Rod:
        """Return the rest shape of the stack with places x, between the ends of the relaxed rod."""
        relaxed = self.relaxed
        s = np.linspace(0.0, relaxed.length, NODES)
        compliance, newtons = self._cells(x[: self.places.size])
        B = 1 / float(compliance.max())
        rest = np.broadcast_to(np.asarray(relaxed.natural_curvature, dtype=float), relaxed.s.shape)
        weight = None if relaxed.gravity is None else Weight(alpha=Profile.interpolate(s, newtons))
        flat = Rod.straight(
            relaxed.length, 1 / (compliance * B), samples=NODES, gravity=relaxed.gravity, supports=relaxed.supports,
            weight=weight, bending_stiffness=B,
        )  # fmt: skip
        flat = replace(flat, natural_curvature=np.interp(s, relaxed.s, rest))
        angles = [
            float(angle) if end.angle else None
            for angle, end in zip(relaxed.angle[[0, -1]], relaxed.supports.ends, strict=True)
        ]
        for i, value in zip(self.turned, x[self.places.size :], strict=True):
            angles[i] = float(value)
        start, end = (
            place if support.x or support.y else None
            for place, support in zip(relaxed.position[[0, -1]], relaxed.supports.ends, strict=True)
        )
        return bend(flat, start=start, end=end, angles=(angles[0], angles[1]), guess=guess)

    def _cells(self, places: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Mean of 1 / (E I) and of the weight per length, N/mm, over the cells of the nodes (n,)."""
        edges = np.concatenate([[0.0], (np.arange(NODES - 1) + 0.5) / (NODES - 1), [1.0]])
        cuts, counts = self._stack(places)
        values = 1 / self.law.bending_stiffness(counts), self.law.weight_per_length(counts)
        means = []
        for value in values:
            reached = np.concatenate([[0.0], np.cumsum(value * np.diff(cuts))])
            means.append(np.diff(np.interp(edges, cuts, reached)) / np.diff(edges))
        return means[0], means[1]

    def _stack(self, places: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Places (m + 2,), as shares of the length, where the number of leaves changes, and the numbers between
        them (m + 1,)."""
        cuts = np.concatenate([[0.0], self._apart(places), [1.0]])
        return cuts, len(self.first) + np.concatenate([[0], np.cumsum(self.steps[:, 1])])

    def _record(self, x: FloatArray, rod: Rod, *, settled: bool) -> LeafedRod:
        places, length = self._apart(x[: self.places.size]), rod.length
        began = dict.fromkeys(self.first, 0.0)
        leaves = []
        for at, (number, sign) in zip(places * length, self.steps, strict=True):
            if sign > 0:
                began[int(number)] = float(at)
            else:
                leaves.append(Leaf(int(number), began.pop(int(number)), float(at)))
        leaves += [Leaf(number, start, length) for number, start in began.items()]
        cuts, counts = self._stack(places)
        K = self.law.bending_stiffness(counts) / float(rod.bending_stiffness or 1.0)
        stepped = Profile(
            np.concatenate([[0.0], np.repeat(cuts, 2)[1:-1], [1.0]]) * length, np.repeat(K, 2), 1
        )
        laid = self.law.laid(sorted(leaves, key=lambda leaf: (leaf.number, leaf.start)))
        fine = bend(replace(rod, profile=stepped, section=laid), samples=FINE_NODES)
        s = np.linspace(0.0, fine.length, NODES)
        at_shares = np.column_stack([np.interp(s, fine.s, column) for column in fine.position.T])
        off = np.hypot(*(at_shares - self.drawn).T)
        return LeafedRod(
            fine, laid, float(off.max()), float(np.sqrt((off**2).mean())),
            self.relaxed, settled,
        )  # fmt: skip
