"""Search for the ends of glued plies whose rest shape is nearest to a curve."""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.plane_points import norm, points_at
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.cross_sections import LaidLeaves, Leaf, LeavesLaw
from elastica_cad.mechanics.loads import Weight
from elastica_cad.mechanics.rod import Rod

NODES = 401
"""Number of nodes of the rods that are computed in the search for ply ends."""

FINE_NODES = 1001
"""Number of nodes of the returned rod; with fewer nodes, a nearly unstable rod has errors of 1e-4 of its length."""

SETTLED = 1e-7
"""The search for ply ends stops at a smaller relative change of the ply ends or of the squared distance."""


@dataclass(frozen=True, eq=False)
class LeafedRod:
    """Rest shape of a stack of glued plies, and its distance from the rod that it approximates.

    Attributes
    ----------
    rod : Rod
        Rest shape with the stiffness of the plies in `section`.
    section : LaidLeaves
    deviation, mean_deviation : float
        Largest and root mean square distance from `relaxed`, mm, between points at the same fraction of the
        length.
    relaxed : Rod
        Rod of continuously varying thickness that the plies approximate.
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
        """Plies in the order of their indices; plies of full length are first."""
        return self.section.leaves


def leaf_bends(rod: Rod, section: LaidLeaves) -> tuple[FloatArray, FloatArray]:
    """Return stations (n,), mm, and the change of curvature (n,) there, |moment| / E I, 1/mm.

    The stations include both sides of each ply end.
    """
    beside = 1e-9 * rod.length
    s = np.sort(np.concatenate([rod.s, section.steps - beside, section.steps + beside]))
    EI = section.bending_stiffness(section.sheet.thickness * section.counts(s))
    moment = np.interp(s, rod.s, rod.moment) * float(rod.bending_stiffness or 1.0)
    return s, np.abs(moment) / EI


def lay_leaves(
    relaxed: Rod, section: LeavesLaw, *, tangents: tuple[bool, bool] = (False, False)
) -> LeafedRod:
    """Return a stack of plies that approximates a rod of continuously varying thickness.

    The thickness is first rounded to whole plies. Then the ends of the plies, and clamp angles that are not kept,
    are optimised for the least distance. The result is a local optimum.

    Parameters
    ----------
    relaxed : Rod
        Rod whose stiffness is between the stiffness of the fewest plies and the stiffness of all plies.
    section : LeavesLaw
    tangents : (bool, bool)
        For start and end, True if the clamp angle is kept.

    Raises
    ------
    NotConvergedError
        No stack has a rest shape with the same ends.
    """
    require_record(section, LeavesLaw, "section", "glued plies, as LeavesLaw(sheet, leaves, width)")
    points = relaxed.curve.sample(NODES).position
    searches: dict[tuple[tuple[int, ...], ...], _Search] = {}
    # start a search for each fraction of a ply above which the number of plies is rounded up
    for rounding in (0.35, 0.5, 0.65):
        search = _Search.of(relaxed, section, points, rounding, tangents)
        searches.setdefault(tuple(map(tuple, search.steps.tolist())), search)
    stacks = [answer for search in searches.values() if (answer := search.answer()) is not None]
    if not stacks:
        raise NotConvergedError(
            f"no stack of {section.leaves} plies was found that bends near this curve: use more and thinner plies"
        )
    best = min(stacks, key=lambda stack: stack.mean_deviation)
    if not best.section.steps.size and relaxed.gravity is None:
        # without ply ends the shape does not depend on the number of plies, so use the fewest
        full = tuple(range(1, section.fewest + 1))
        full_length = replace(search, steps=np.zeros((0, 2), dtype=int), places=np.zeros(0), first=full)
        best = full_length.answer() or best
    return best


@dataclass(frozen=True, eq=False)
class _Search:
    """Search for ply ends and clamp angles that give the rest shape nearest to the points `drawn`.

    The order of the ply ends is fixed.

    Attributes
    ----------
    steps : (m, 2) int array
        For each of `places`, the index of a ply, and 1 if the ply begins there or -1 if it ends there.
    places : (m,) array
        Initial positions of the ply ends, as fractions of the length.
    first : tuple of int
        Indices of the plies that begin at the start of the rod.
    tangents : (bool, bool)
        For start and end, True if the clamp angle is fixed.
    """

    relaxed: Rod
    section: LeavesLaw
    drawn: FloatArray
    steps: IntArray
    places: FloatArray
    first: tuple[int, ...]
    tangents: tuple[bool, bool]

    @classmethod
    def of(
        cls, relaxed: Rod, section: LeavesLaw, drawn: FloatArray, rounding: float,
        tangents: tuple[bool, bool],
    ) -> "_Search":  # fmt: skip
        """Return the search that starts with ply k wherever the thickness exceeds k - 1 + `rounding` plies."""
        s = np.linspace(0.0, 1.0, 20 * NODES)
        EI = relaxed.profile(s * relaxed.length) * float(relaxed.bending_stiffness or 1.0)
        leaves = section.relaxed.parameter(EI) / section.sheet.thickness
        steps: list[tuple[float, int, int]] = []
        first = list(range(1, section.fewest + 1))
        for number in range(section.fewest + 1, section.leaves + 1):
            inside = leaves > number - 1 + rounding
            edges = np.flatnonzero(np.diff(inside.astype(int)))
            signs = np.diff(inside.astype(int))[edges]
            first += [number] if inside[0] else []
            steps += [(float(s[i + 1]), number, int(sign)) for i, sign in zip(edges, signs, strict=True)]
        steps.sort()
        return cls(
            relaxed, section, drawn, np.array([(number, sign) for _, number, sign in steps]).reshape(-1, 2),
            np.array([at for at, _, _ in steps]), tuple(first), tangents,
        )  # fmt: skip

    @property
    def turned(self) -> list[int]:
        """Indices (0: start, 1: end) of the clamped ends whose angle is optimised."""
        return [i for i, end in enumerate(self.relaxed.supports.ends) if end.angle and not self.tangents[i]]

    def answer(self) -> LeafedRod | None:
        """Return the nearest rod of glued plies, or None if the initial stack has no rest shape."""
        from scipy.optimize import least_squares

        start = np.concatenate([self.places, self.relaxed.angle[[0, -1]][self.turned]])
        try:
            first_rod = self._bent(start, self.relaxed)
        except (InputError, NotConvergedError):
            return None
        # `_missed` puts each solved rod here, as the initial guess of the next rod
        latest = [first_rod]
        missed = partial(self._missed, latest=latest)
        if not start.size:
            return self._record(start, first_rod, settled=True)
        is_place = np.arange(start.size) < self.places.size
        bounds = np.where(is_place, 0.0, -np.inf), np.where(is_place, 1.0, np.inf)
        # `diff_step` is a fraction of the length, as the positions of ply ends are
        optimum = least_squares(
            missed, start, bounds=bounds, diff_step=1e-4, ftol=SETTLED, xtol=SETTLED, gtol=1e-12,
            max_nfev=60, x_scale="jac",
        )  # fmt: skip
        return self._record(optimum.x, self._bent(optimum.x, latest[0]), settled=optimum.status > 0)

    def _missed(self, x: FloatArray, latest: list[Rod]) -> FloatArray:
        """Return scaled offsets from `drawn`.

        The sum of their squares is the mean squared distance / length^2. The offsets are large if the stack
        has no rest shape.
        """
        try:
            rod = self._bent(x, latest[0])
        except (InputError, NotConvergedError):
            return np.ones(2 * NODES)
        latest[0] = rod
        return np.asarray((rod.position - self.drawn).ravel() / (rod.length * np.sqrt(NODES)))

    def _separated(self, places: FloatArray) -> FloatArray:
        """Return positions in increasing order, moved apart so that each ply has a least length."""
        m = places.size
        # least distance between two ply ends, and least length of a ply, as a fraction of the rod's length
        clearance = min(0.01, 0.5 / (m + 1))
        low, high = clearance * np.arange(1, m + 1), 1 - clearance * np.arange(m, 0, -1)
        gaps = np.sort(places).clip(low, high) - low
        return np.asarray(np.maximum.accumulate(gaps) + low)

    def _bent(self, x: FloatArray, guess: Rod) -> Rod:
        """Return the rest shape of the stack for the unknowns x.

        These are the positions of the ply ends, as fractions of the length, and the angles of the `turned` ends.
        """
        relaxed = self.relaxed
        s = np.linspace(0.0, relaxed.length, NODES)
        compliance, newtons = self._cells(x[: self.places.size])
        # least bending stiffness, N mm2, by which the stiffness of a rod is divided
        B = 1 / float(compliance.max())
        rest = np.broadcast_to(relaxed.natural_curvature, relaxed.s.shape)
        weight = None if relaxed.gravity is None else Weight(alpha=Profile.interpolate(s, newtons))
        flat = Rod.straight(
            relaxed.length, 1 / (compliance * B), samples=NODES, gravity=relaxed.gravity,
            supports=relaxed.supports, weight=weight, bending_stiffness=B,
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
        """Return means (n,) around each node of 1 / (E I), 1/(N mm2), and of the weight per length, N/mm.

        `places` are the positions of the ply ends as fractions of the length.
        """
        edges = np.concatenate([[0.0], (np.arange(NODES - 1) + 0.5) / (NODES - 1), [1.0]])
        cuts, counts = self._stack(places)
        values = 1 / self.section.bending_stiffness(counts), self.section.weight_per_length(counts)
        means = []
        for value in values:
            reached = np.append(0.0, (value * np.diff(cuts)).cumsum())
            means.append(np.diff(np.interp(edges, cuts, reached)) / np.diff(edges))
        return means[0], means[1]

    def _stack(self, places: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the positions (m + 2,) of rod ends and ply ends, as fractions of the length.

        The second result (m + 1,) is the number of plies between successive positions.
        """
        cuts = np.concatenate([[0.0], self._separated(places), [1.0]])
        return cuts, len(self.first) + np.append(0, self.steps[:, 1].cumsum())

    def _record(self, x: FloatArray, rod: Rod, *, settled: bool) -> LeafedRod:
        """Return the record for the unknowns x.

        The rod is bent anew on a finer grid, with steps of the stiffness.
        """
        places, length = self._separated(x[: self.places.size]), rod.length
        # start, mm, of each ply that has not ended yet, by its index
        began = dict.fromkeys(self.first, 0.0)
        leaves = []
        for at, (number, sign) in zip(places * length, self.steps, strict=True):
            if sign > 0:
                began[int(number)] = float(at)
            else:
                leaves.append(Leaf(int(number), began.pop(int(number)), float(at)))
        leaves += [Leaf(number, start, length) for number, start in began.items()]
        cuts, counts = self._stack(places)
        K = self.section.bending_stiffness(counts) / float(rod.bending_stiffness or 1.0)
        stepped = Profile(np.concatenate([[0.0], cuts.repeat(2)[1:-1], [1.0]]) * length, K.repeat(2), 1)
        laid = self.section.laid(sorted(leaves, key=lambda leaf: (leaf.number, leaf.start)))
        fine = bend(replace(rod, profile=stepped, section=laid), samples=FINE_NODES)
        s = np.linspace(0.0, fine.length, NODES)
        off = norm(points_at(s, fine.s, fine.position) - self.drawn)
        return LeafedRod(
            fine, laid, float(off.max()), float(np.sqrt((off**2).mean())),
            self.relaxed, settled,
        )  # fmt: skip
