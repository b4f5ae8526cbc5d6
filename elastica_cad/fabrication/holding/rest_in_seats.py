"""The rest shape of a strip whose tabs sit in holders that leave them room."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.seated_end import PRICE, SeatedEnd, step_within
from elastica_cad.fabrication.holding.tab_seat import EndPose, TabSeat
from elastica_cad.forming.optimizer.quadratic_program import QuadraticSolution
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.rod.rod_record import Rod

MOST_STEPS = 60
RENEWED_SHARE = 0.003  # of the length: after longer steps the stiffness of the ends is measured anew
SHORTER, LONGER = 0.5, 2.0  # most of the next step: of one that went back, and of what the last was allowed
DIFFERENCE_SHARE = 1e-5  # of the length: step of the finite differences of reactions
SETTLED_SHARE = 1e-9  # of the length: steps below it end the search
LEAST_SHARE = 1e-6  # of the largest eigenvalue: a direction that is softer counts as this stiff
DEARER = 10.0  # times as much, where a tab that is wedged in pays it
DEAREST = 1e6  # a tab that pays this does not fit
OVERLAP_SHARE = 1e-7  # of the length: overlaps below it are rounding
SEATING_STEPS = 3
SEATING = 1e4  # times as stiff are the ends while tabs bend into their seats


def rest_in_seats(
    made: Rod,
    design: Rod,
    seats: tuple[TabSeat | None, TabSeat | None],
    tab_stiffness: tuple[float, float] = (np.inf, np.inf),
) -> tuple[Rod, tuple[EndPose, EndPose]]:
    """The shape of least energy whose tabs stay within their seats, and where its ends are.

    Tabs may shift across, turn and bend, not slide along. Contacts are without friction: least energy under
    one-sided conditions, by sequential quadratic programming on shift and turn of each end and the angles of each
    tab; forces and moments of the rod (Eq. 2) are the gradient, their differences and how pushes turn the Hessian.

    Parameters
    ----------
    made : Rod
        What is held.
    design : Rod
        Where its ends were meant to be.
    seats : pair of TabSeat or None
        At start and end; None holds that end as its support does, without play.
    tab_stiffness : pair of float
        E I of the tabs over the rod's B; infinite for tabs that do not bend.

    Raises
    ------
    NotConvergedError
        A tab does not fit into its seat, or no rest shape was found.
    """
    seated = [
        SeatedEnd(k, seat, stiffness)
        for k, (seat, stiffness) in enumerate(zip(seats, tab_stiffness, strict=True))
        if seat is not None and design.supports.ends[k].angle
    ]
    if not seated:
        return bend(made, start=design.position[0], end=design.position[-1]), (EndPose(), EndPose())
    problem = _Held(made, design, tuple(seated))
    q = np.zeros(problem.unknowns)
    rod = problem.bent(q, made)
    stiffness = problem.end_stiffness(q, rod)
    firm = _made_definite(stiffness)
    # tabs bend into their seats first, else the strip is thrown far off by walls that a straight tab meets
    for _ in range(SEATING_STEPS):
        q = q + problem.step(q, rod, SEATING * firm).x
    rod = problem.bent(q, rod)
    step, pushes, price, reach = np.zeros(q.size), np.zeros(len(problem.walls(q)[1])), PRICE, np.inf
    for _ in range(MOST_STEPS):
        if np.abs(step).max() > RENEWED_SHARE * design.length:
            stiffness = problem.end_stiffness(q, rod)
        firm = _made_definite(stiffness - problem.wall_bends(q, pushes))
        found = problem.step(q, rod, firm, price=price, reach=reach)
        before, step, pushes = step, found.x, found.row_multipliers * np.abs(firm).max()
        moved = np.abs(step).max()
        settled = moved <= SETTLED_SHARE * design.length and moved < reach
        # steps back ask for shorter ones: shape and contacts change more on the way than a step knows
        reach = SHORTER * moved if step @ before < 0 else LONGER * reach
        q = q + step
        rod = problem.bent(q, rod)
        if settled:
            if problem.walls(q)[1].min() >= -OVERLAP_SHARE * design.length:
                break
            if price >= DEAREST:
                raise NotConvergedError(problem.without_room(q))
            price, reach = DEARER * price, np.inf
    else:
        raise NotConvergedError(
            problem.without_room(q)
            if price > PRICE and problem.walls(q)[1].min() < -OVERLAP_SHARE * design.length
            else "the strip finds no rest in its holders: give them less play, or hold the tabs with screws or glue"
        )
    poses = [EndPose(), EndPose()]
    for one, part in problem.parts(q):
        poses[one.index] = EndPose(*problem.pose(part))
    return rod, (poses[0], poses[1])


@dataclass(frozen=True, eq=False)
class _Held:
    """Unknowns q of each seated end: shift, turn, angles of its tab's pieces; angles times the length, all mm."""

    made: Rod
    design: Rod
    seated: tuple[SeatedEnd, ...]

    @cached_property
    def unknowns(self) -> int:
        return sum(2 + one.pieces for one in self.seated)

    def parts(self, q: FloatArray) -> list[tuple[SeatedEnd, FloatArray]]:
        return [(one, q[at : at + 2 + one.pieces]) for at, one in zip(self._begins, self.seated, strict=True)]

    def pose(self, part: FloatArray) -> tuple[float, float]:
        return float(part[0]), float(part[1]) / self.design.length

    def bent(self, q: FloatArray, near: Rod) -> Rod:
        design = self.design
        places = [design.position[0], design.position[-1]]
        angles = [float(design.angle[0]), float(design.angle[-1])]
        for one, part in self.parts(q):
            shift, turn = self.pose(part)
            places[one.index] = places[one.index] + shift * self.lefts[one.index]
            angles[one.index] += turn
        held = [angle if end.angle else None for angle, end in zip(angles, design.supports.ends, strict=True)]
        return bend(near, start=places[0], end=places[1], angles=(held[0], held[1]))

    @cached_property
    def lefts(self) -> FloatArray:
        """Unit vectors (2, 2) to the left of the design at start and end."""
        angles = self.design.angle[[0, -1]]
        return np.column_stack([-np.sin(angles), np.cos(angles)])

    def reactions(self, rod: Rod) -> FloatArray:
        """What the holders do to the strip along shift and turn of each end, over B: 1/mm2."""
        found = [one.load(rod, self.lefts[one.index], self.design.length) for one in self.seated]
        return np.array(found).ravel()

    @cached_property
    def poses(self) -> list[int]:
        """Indices in q of shifts and turns."""
        return [at + k for at in self._begins for k in (0, 1)]

    def end_stiffness(self, q: FloatArray, rod: Rod) -> FloatArray:
        """Derivatives of the reactions, 1/mm3."""
        reactions, difference = self.reactions(rod), DIFFERENCE_SHARE * self.design.length
        moves = difference * np.eye(q.size)[self.poses]
        ends = np.array([self.reactions(self.bent(q + move, rod)) - reactions for move in moves]) / difference
        return np.asarray((ends + ends.T) / 2)

    def without_room(self, q: FloatArray) -> str:
        """What to say of the tab that overlaps its holder most."""
        gaps = self.walls(q)[1]
        sizes = [one.seat.edges[0].size for one in self.seated]
        each = [float(part.min()) for part in np.split(gaps, np.cumsum(sizes)[:-1])]
        one, gap = min(zip(self.seated, each, strict=True), key=lambda pair: pair[1])
        end = "end" if one.index else "start"
        return (
            f"the tab at the {end} does not go into its {one.seat.name}: however it turns and bends, {-gap:.2g} mm "
            "of it stand in the material; give it more play"
        )

    def wall_bends(self, q: FloatArray, pushes: FloatArray) -> FloatArray:
        """What the pushes (k,) of the walls, over B, change of them as the ends turn, 1/mm3."""
        found, at = np.zeros((2 * len(self.seated), 2 * len(self.seated))), 0
        for k, (one, part) in enumerate(self.parts(q)):
            bends = one.seat.bends(*self.pose(part), one.way) / np.array([[1.0, self.design.length]] * 2)
            bends[:, 1] /= self.design.length
            pose = slice(2 * k, 2 * k + 2)
            found[pose, pose] = np.einsum("k,kij->ij", pushes[at : at + len(bends)], bends)
            at += len(bends)
        return found

    def walls(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Slopes (k, n) by q and gaps (k,), mm, between tabs and the edges of their holders; negative overlaps."""
        rows, room = [], []
        for at, (one, part) in zip(self._begins, self.parts(q), strict=True):
            own, gaps = one.walls(part, self.design.length)
            rows.append(np.zeros((gaps.size, q.size)))
            rows[-1][:, at : at + part.size] = own
            room.append(gaps)
        return np.concatenate(rows), np.concatenate(room)

    def step(
        self,
        q: FloatArray,
        rod: Rod,
        end_stiffness: FloatArray,
        *,
        price: float = PRICE,
        reach: float = np.inf,
    ) -> QuadraticSolution:
        """The next step of sequential quadratic programming, none of it farther than `reach` mm."""
        poses = self.poses
        scale = float(np.abs(end_stiffness).max())
        g, H = np.zeros(q.size), self._bending.copy()
        g[poses] = self.reactions(rod)
        H[self._pose_block] = end_stiffness
        for at, (one, part) in zip(self._begins, self.parts(q), strict=True):
            tab = self._tab(at, one)
            g[tab] = H[tab, tab] @ part[2:]
        return step_within(
            H, g, self.walls(q), self.design.length, poses[::2], scale=scale, price=price, reach=reach
        )

    @cached_property
    def _pose_block(self) -> tuple[IntArray, ...]:
        """Where in the Hessian shifts and turns are."""
        return np.ix_(self.poses, self.poses)

    @cached_property
    def _bending(self) -> FloatArray:
        """Hessian (n, n) of the tabs' energy over B in q, 1/mm3."""
        found = np.zeros((self.unknowns, self.unknowns))
        for at, one in zip(self._begins, self.seated, strict=True):
            if one.pieces:
                found[self._tab(at, one), self._tab(at, one)] = one.bending / self.design.length**2
        return found

    def _tab(self, at: int, one: SeatedEnd) -> slice:
        """Where in q the angles of a tab's pieces are."""
        return slice(at + 2, at + 2 + one.pieces)

    @cached_property
    def _begins(self) -> list[int]:
        sizes = [2 + one.pieces for one in self.seated]
        return [sum(sizes[:k]) for k in range(len(sizes))]


def _made_definite(stiffness: FloatArray) -> FloatArray:
    """Symmetric (n, n) with the same directions, all of them stiff."""
    values, vectors = np.linalg.eigh(stiffness)
    values = np.maximum(np.abs(values), LEAST_SHARE * np.abs(values).max())
    return np.asarray(vectors @ np.diag(values) @ vectors.T)
