"""The rest shape of a strip whose tabs sit in holders that leave them room."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.forming.optimizer.quadratic_program import (
    QuadraticProgram,
    QuadraticSolution,
    solve_quadratic,
)
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.rod.rod_record import Rod

MOST_STEPS = 60
STEP_SHARE = 0.05  # of the length: largest move of an end in one step
RENEWED_SHARE = 0.003  # of the length: after longer steps the stiffness of the ends is measured anew
SHORTER, LONGER = 0.5, 2.0  # most of the next step: of one that went back, and of what the last was allowed
STEP_RAD = 0.15  # largest turn of an end in one step
DIFFERENCE_SHARE = 1e-5  # of the length: step of the finite differences of reactions
SETTLED_SHARE = 1e-9  # of the length: steps below it end the search
LEAST_SHARE = 1e-6  # of the largest eigenvalue: a direction that is softer counts as this stiff
PRICE = 100.0  # of a mm of overlap, over the forces that are there: far above most contacts' multipliers
DEARER = 10.0  # times as much, where a tab that is wedged in pays it
DEAREST = 1e6  # a tab that pays this does not fit
OVERLAP_SHARE = 1e-7  # of the length: overlaps below it are rounding
SEATING_STEPS = 3
SEATING = 1e4  # times as stiff are the ends while tabs bend into their seats
LEAN_STEPS = 6  # at most: contacts change little after the first
SHORTENING = (1.0, 0.1, 0.01, 0.01, 0.01, 0.01)  # stiffness of an end over its load / length, step by step
LEAN_SHARE = 1e-7  # of the length: what a step moves when the contacts have been found
ALIKE_DIGITS = 11  # of loads and lengths that are one: rounding of strips made alike in different places
TAB_PIECES = 16  # of a tab that bends: its turn at the mouth is then right to half a percent


@dataclass(frozen=True)
class EndPose:
    """Where an end comes to rest: `shift` mm to the left of the design, `turn` rad anticlockwise."""

    shift: float = 0.0
    turn: float = 0.0


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
        _SeatedEnd(k, seat, stiffness)
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


@dataclass(frozen=True)
class Lean:
    """How a holder is shifted, mm, and turned, rad, to the left.

    `slopes` are those of the tab's pieces at rest, each `piece` mm long, to its left; `touching` is the last step,
    with what touches.
    """

    shift: float
    turn: float
    slopes: FloatArray
    piece: float
    touching: QuadraticSolution | None = None

    def touched(self, wall: FloatArray) -> tuple[float, float]:
        """How far into the tab at rest a wall of the moved holder comes nearest to it, mm, and its slope there.

        Parameters
        ----------
        wall : (n, 2) array
            Places of the wall before it is moved, into the tab and to its left, mm.
        """
        (into, left), (slopes, places, bent) = wall.T, self._at_rest
        gaps = left + self.shift + self.turn * into - np.interp(into, places, bent)
        place = float(into[np.abs(gaps).argmin()])
        return place, float(slopes[min(int(place / self.piece), slopes.size - 1)])

    @cached_property
    def _at_rest(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """The tab's slopes (k,), and where its pieces begin and end (k + 1,): into it and to its left, mm."""
        slopes = np.resize(self.slopes, max(self.slopes.size, 1))  # stiff tabs are one straight piece
        bent = np.append(0.0, np.cumsum(slopes)) * self.piece
        return slopes, np.asarray(self.piece * np.arange(slopes.size + 1), dtype=float), bent


def lean_against(
    design: Rod,
    index: int,
    seat: TabSeat,
    tab_stiffness: float = np.inf,
    near: Lean | None = None,
) -> Lean:
    """How a holder is shifted and turned so that the loaded tab lies as designed.

    The strip's force and moment press the tab against some edges of the holder: moved by this, those edges are
    where the tab is meant to be, and all play lies on the other sides.

    Parameters
    ----------
    design : Rod
    index : int
        0 for the start, 1 for the end.
    seat : TabSeat
        The holder where it was designed.
    tab_stiffness : float
        E I of the tab over the rod's B; a stiff tab unless given.
    near : Lean, optional
        Found in a seat like this one: changes the time only.
    """
    shift = turn = 0.0
    free = _SeatedEnd(index, seat, tab_stiffness)
    to_angles = free.way * design.length
    slopes, touching = (np.zeros(free.pieces), None) if near is None else (near.slopes, near.touching)
    for _ in range(LEAN_STEPS):
        end = replace(free, seat=seat.moved(shift, turn))
        problem = _Held(design, design, (end,))
        load = np.abs(problem.reactions(design)).max()
        if load == 0:
            break
        q = np.concatenate([[0.0, 0.0], to_angles * slopes])
        # the strip's load does not change here: what is stiff in its place keeps the first steps short
        for stiffness in SHORTENING if touching is None else SHORTENING[3:]:
            touching = problem.step(q, design, stiffness * load / design.length * np.eye(2), touching)
            q = q + touching.x
            if np.abs(touching.x).max() <= LEAN_SHARE * design.length:
                break
        slopes = q[2:] / to_angles
        moved, turned = problem.pose(q)
        shift, turn = shift - moved, turn - end.way * turned
        if abs(moved) + abs(turned) * design.length <= LEAN_SHARE * design.length:
            break
    return Lean(shift, turn, slopes, free.piece, touching)


def what_leans(
    design: Rod, index: int, seat: TabSeat, tab_stiffness: float = np.inf
) -> tuple[int | float, ...]:
    """All that `lean_against` hangs on, to rounding: of ends that are loaded and held alike the same."""
    load = _Held(design, design, (_SeatedEnd(index, seat, tab_stiffness),)).reactions(design)
    numbers = (design.length, *load.tolist(), tab_stiffness)
    return (index, *(float(f"{number:.{ALIKE_DIGITS}g}") for number in numbers), seat.thickness, *seat.places)


@dataclass(frozen=True, eq=False)
class _SeatedEnd:
    """An end with room: its tab as a chain of rigid pieces between bending joints."""

    index: int
    seat: TabSeat
    stiffness: float

    @property
    def way(self) -> int:
        return 1 if self.index else -1

    @cached_property
    def pieces(self) -> int:
        return TAB_PIECES if np.isfinite(self.stiffness) else 0

    @property
    def piece(self) -> float:
        """Length of a piece, mm."""
        return self.seat.depth / TAB_PIECES

    @cached_property
    def bending(self) -> FloatArray:
        """Hessian (m, m) of the tab's energy over B in the angles of its pieces, 1/mm."""
        m = self.pieces
        # the first piece turns about the mouth, half a piece away from its middle
        springs = self.stiffness / self.piece * np.array([2.0, *np.ones(m - 1)])
        joints = np.eye(m) - np.eye(m, k=-1)
        return np.asarray(joints.T @ (springs[:, None] * joints))

    @cached_property
    def sideways(self) -> FloatArray:
        """How far (k, m) each edge's gap closes for the angle of each piece, mm."""
        into, _, side = self.seat.edges
        begins = self.piece * np.arange(self.pieces)
        covered = np.clip(into[:, None] - begins, 0.0, self.piece)
        return np.asarray(-self.way * side[:, None] * covered)


@dataclass(frozen=True, eq=False)
class _Held:
    """Unknowns q of each seated end: shift, turn, angles of its tab's pieces; angles times the length, all mm."""

    made: Rod
    design: Rod
    seated: tuple[_SeatedEnd, ...]

    @cached_property
    def unknowns(self) -> int:
        return sum(2 + one.pieces for one in self.seated)

    def parts(self, q: FloatArray) -> list[tuple[_SeatedEnd, FloatArray]]:
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
        found = []
        for one in self.seated:
            k, sign = -one.index, -1.0 if one.index else 1.0
            found += [sign * rod.force[k] @ self.lefts[one.index], -sign * rod.moment[k] / self.design.length]
        return np.array(found)

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
        length, rows, room = self.design.length, [], []
        for at, (one, part) in zip(self._begins, self.parts(q), strict=True):
            pose = self.pose(part)
            gaps = one.seat.gaps(*pose, one.way)
            block = np.zeros((gaps.size, q.size))
            block[:, at : at + 2] = one.seat.slopes(*pose, one.way)
            block[:, at + 1] /= length
            if one.pieces:
                block[:, self._tab(at, one)] = one.sideways / length
                gaps = gaps + one.sideways @ part[2:] / length
            rows.append(block)
            room.append(gaps)
        return np.concatenate(rows), np.concatenate(room)

    def step(
        self,
        q: FloatArray,
        rod: Rod,
        end_stiffness: FloatArray,
        near: QuadraticSolution | None = None,
        *,
        price: float = PRICE,
        reach: float = np.inf,
    ) -> QuadraticSolution:
        """The next step of sequential quadratic programming; `near` is the one before, for what touches."""
        length, poses = self.design.length, self.poses
        scale = float(np.abs(end_stiffness).max())
        g, H = np.zeros(q.size), self._bending.copy()
        g[poses] = self.reactions(rod)
        H[self._pose_block] = end_stiffness
        for at, (one, part) in zip(self._begins, self.parts(q), strict=True):
            tab = self._tab(at, one)
            g[tab] = H[tab, tab] @ part[2:]
        A, gaps = self.walls(q)
        bound = np.full(q.size, STEP_RAD * length)
        bound[poses[::2]] = STEP_SHARE * length
        each = price * (np.abs(g).max() / scale + bound.max())
        program = QuadraticProgram(
            H / scale, g / scale, -np.minimum(bound, reach), np.minimum(bound, reach), A, -gaps,
            np.full(gaps.size, each), np.ones(gaps.size, dtype=bool),
        )  # fmt: skip
        return solve_quadratic(program, near=near)

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

    def _tab(self, at: int, one: _SeatedEnd) -> slice:
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
