"""Contact of tabs with their holders, and the rest shape of a strip whose tabs fit loosely."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise, repeat
from operator import itemgetter

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, numbers, require_positive
from elastica_cad.errors import FieldName, InputError, Length, NotConvergedError, note
from elastica_cad.form_finding.quadratic_program import QuadraticProgram, QuadraticSolution, solve_quadratic
from elastica_cad.geometry.plane_points import left_of, rotated, unit_vectors
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.rod import Rod

STEEPEST_RAD = np.radians(80.0)
"""Largest turn of a tab, rad, up to which contact with the holder is searched."""

ROCKING_RAD = np.radians(3.0)
"""Largest rotation, rad, of a tab in its holder that is not reported.

A larger rotation changes the shape by some percent.
"""

STOP_RAD = np.radians(0.05)
"""Step of the search for the largest turn of a tab, rad."""

WALL_PLACES = 17
"""Number of points of a wall at which contact is checked. A bent tab may touch its pocket between the ends of the
wall."""


@dataclass(frozen=True)
class EndPose:
    """Displacement of an end at rest from the design: `shift` to the left, mm, and `turn` anticlockwise, rad."""

    shift: float = 0.0
    turn: float = 0.0


@dataclass(frozen=True, eq=False)
class TabSeat:
    """Points of a holder that a tab can touch, in the plane of the curve.

    Points are (into, left), mm. `into` is the distance into the tab from the end of the bent part. `left` is the
    distance from the designed centre line of the tab, to the left as seen along the strip from start to end.

    Parameters
    ----------
    left, right : (k, 2) array_like
        Points that the left and the right face of the tab can touch.
    thickness : float
        Thickness of the tab, mm.
    name : str
        Name of the holder in messages.
    cut : float
        Change of the clearance across the tab per change of the width of the slot that holds it. It is the sine
        of the angle between tab and plate, and 0 for pockets that are not cut.
    key : str
        Key of the design that determines how far the tab can turn.

    Examples
    --------
    >>> seat = TabSeat.pocket(length=10, thickness=0.8, clearance=0.15)
    >>> [round(float(np.degrees(turn)), 2) for turn in seat.turning]
    [-1.72, 1.72]
    """

    left: FloatArray
    right: FloatArray
    thickness: float
    name: str = "holder"
    cut: float = 0.0
    key: str = FieldName("clearance")

    def __post_init__(self) -> None:
        for side in ("left", "right"):
            edges = numbers(getattr(self, side), f"{side} edges of a seat")
            if edges.ndim == 0 or (edges.size and edges.shape[-1] != 2):
                raise InputError(
                    f"{side} edges of the pocket for a tab have the shape {edges.shape}: give rows (k, 2), in mm"
                )
            object.__setattr__(self, side, edges.reshape(-1, 2))

    @classmethod
    def pocket(cls, length: float, thickness: float, clearance: float, *, name: str = "pocket") -> "TabSeat":
        """Return a straight pocket around the tab, with a gap of `clearance` mm on each face."""
        require_positive(length, f"{name}: the length")
        require_positive(thickness, f"{name}: the thickness")
        if not (is_number(clearance) and clearance >= 0):
            raise InputError(f"{name}: clearance is {clearance!r} mm: give 0 or more")
        into = np.linspace(0.0, length, WALL_PLACES)
        half = np.full(into.size, thickness / 2 + clearance)
        return cls(np.column_stack([into, half]), np.column_stack([into, -half]), thickness, name)

    @cached_property
    def edges(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Coordinates `into` and `left` (k,) of all points, mm, and the faces (k,) that they can touch.

        The face is 1 for the left and -1 for the right face of the tab.
        """
        into, left = np.concatenate([self.left, self.right]).T.copy()
        return into, left, np.repeat([1.0, -1.0], [len(self.left), len(self.right)])

    @property
    def depth(self) -> float:
        """Length of the tab that the holder covers, mm."""
        return float(max(self.left[:, 0].max(), self.right[:, 0].max()))

    @property
    def room(self) -> float:
        """Clearance across the tab at its designed angle, mm; 0 if the holder presses the tab."""
        return max(0.0, float(self.left[:, 1].min() - self.right[:, 1].max()) - self.thickness)

    @property
    def places(self) -> tuple[float, ...]:
        """Rounded coordinates of all points; equal for equal holders."""
        return tuple(np.round([*self.left.ravel(), *self.right.ravel()], 9).tolist())

    def moved(self, shift: float, turn: float) -> "TabSeat":
        """Return the holder shifted to the left by `shift`, mm, and turned to the left by `turn`, rad.

        The centre of rotation is the end of the bent part.
        """
        left, right = (rotated(side, turn) + np.array([0.0, shift]) for side in (self.left, self.right))
        return replace(self, left=left, right=right)

    def loosened(self, room: float) -> "TabSeat":
        """Return the holder with a larger clearance across the tab, by `room` mm."""
        aside = np.array([0.0, room / 2])
        return replace(self, left=self.left + aside, right=self.right - aside)

    def gaps(self, shift: float, turn: float, sign: int) -> FloatArray:
        """Return the gaps (k,), mm, between the points of the holder and the tab; negative for overlaps.

        The end of the bent part is shifted to the left by `shift`, mm, and turned anticlockwise by `turn`, rad.
        `sign` is 1 for the end of the strip, and -1 for its start.
        """
        cos, sin = np.cos(turn), np.sin(turn)
        into, left, side = self.edges
        return np.asarray(side * (-sign * into * sin + (left - shift) * cos) - self.thickness / 2)

    def slopes(self, shift: float, turn: float, sign: int) -> FloatArray:
        """Return the derivatives (k, 2) of `gaps` with respect to shift and turn."""
        cos, sin = np.cos(turn), np.sin(turn)
        into, left, side = self.edges
        return np.column_stack([-cos * side, side * (-sign * into * cos - (left - shift) * sin)])

    def bends(self, shift: float, turn: float, sign: int) -> FloatArray:
        """Return the second derivatives (k, 2, 2) of `gaps` with respect to shift and turn."""
        _, _, side = self.edges
        second = np.zeros((side.size, 2, 2))
        second[:, 0, 1] = second[:, 1, 0] = np.sin(turn) * side
        second[:, 1, 1] = -self.thickness / 2 - self.gaps(shift, turn, sign)
        return second

    @cached_property
    def turning(self) -> tuple[float, float]:
        """Angles, rad, by which the tab can turn to the right (negative) and to the left, seen from the
        strip.
        """
        return -self._stop(-1), self._stop(1)

    @property
    def rocks(self) -> bool:
        """True if the tab can turn by more than `ROCKING_RAD` on average to both sides."""
        right, left = self.turning
        return bool(left - right > 2 * ROCKING_RAD)

    def _stop(self, sense: int) -> float:
        """Return the angle, rad, by which the tab can turn to the left (`sense` 1) or right (-1) until it stops."""
        turn = np.arange(0.0, STEEPEST_RAD, STOP_RAD)
        cos, sin = np.cos(sense * turn)[:, None], np.sin(sense * turn)[:, None]
        (a, b), (c, d) = self.left.T, self.right.T  # `into` and `left` of the points on both sides
        # largest shift of the turned tab to the left, at which its left face touches the holder
        most = (b - (a * sin + self.thickness / 2) / cos).min(axis=1)
        # range of shifts between contact on the right and on the left
        # the tab might fit again at larger angles, but it stops at the first contact
        room = most - (d + (self.thickness / 2 - c * sin) / cos).max(axis=1)
        jams = np.flatnonzero(room[1:] < -1e-12)
        if not jams.size:
            return float(STEEPEST_RAD)
        k = jams[0]  # last step at which the tab fits; its room vanishes between the steps k and k + 1
        return float(turn[k] + STOP_RAD * max(0.0, room[k]) / (max(0.0, room[k]) - room[k + 1]))


# penalty for an overlap, relative to the forces; larger than most contact forces
OVERLAP_PENALTY = 100.0
TAB_PIECES = 16  # number of rigid pieces of an elastic tab, for an error of 0.5 % in its slope


@dataclass(frozen=True, eq=False)
class SeatedEnd:
    """Loosely held end of a strip. Its tab is a chain of rigid pieces with elastic joints.

    The unknowns are the shift and the turn of the end, and the angles of the m pieces of the tab. Turn and angles
    are multiplied by the length of the strip, so that all unknowns are in mm.

    Attributes
    ----------
    index : int
        0 for the start, 1 for the end.
    seat : TabSeat
    stiffness : float
        E I of the tab divided by the bending stiffness B of the rod; infinite for a rigid tab.
    """

    index: int
    seat: TabSeat
    stiffness: float

    @property
    def way(self) -> int:
        """Direction of the tab along the strip: 1 at the end, -1 at the start."""
        return 1 if self.index else -1

    @property
    def pieces(self) -> int:
        """Number m of pieces of the tab; 0 for a rigid tab."""
        return TAB_PIECES if np.isfinite(self.stiffness) else 0

    @cached_property
    def piece(self) -> float:
        """Length of a piece of the tab, mm."""
        return self.seat.depth / TAB_PIECES

    @property
    def bending(self) -> FloatArray:
        """Hessian (m, m), 1/mm, of the bending energy of the tab, divided by the stiffness B of the rod.

        The variables are the angles of the pieces.
        """
        # the first joint represents half a piece at the start of the tab, so it is twice as stiff
        springs = np.full(self.pieces, self.stiffness / self.piece)
        springs[:1] *= 2.0
        joints = np.eye(self.pieces) - np.eye(self.pieces, k=-1)
        return joints.T @ (springs[:, None] * joints)

    @cached_property
    def sideways(self) -> FloatArray:
        """Derivatives (k, m), mm, of the gaps with respect to the angles of the tab's pieces."""
        into, _, side = self.seat.edges
        # a piece moves a contact by its angle times its length up to the contact
        begins = self.piece * np.arange(self.pieces)
        covered = np.minimum(np.maximum(into[:, None] - begins, 0.0), self.piece)
        return -self.way * side[:, None] * covered

    def left(self, design: Rod) -> FloatArray:
        """Return the unit vector (2,) to the left of the designed direction at this end."""
        return left_of(unit_vectors(design.angle[-self.index]))

    def load(self, rod: Rod, design: Rod) -> tuple[float, float]:
        """Return the derivatives of energy / B by the shift of this end and by its turn times the length, 1/mm2.

        B is the bending stiffness of the rod. The derivatives are the force and the moment / length of the holder
        on the rod, both divided by B. The shift is measured from the end of `design`.
        """
        force, moment = rod.force[-self.index], float(rod.moment[-self.index])
        return -self.way * float(force @ self.left(design)), self.way * moment / design.length

    def walls(self, part: FloatArray, length: float) -> tuple[FloatArray, FloatArray]:
        """Return the derivatives (k, 2 + m) of the gaps with respect to the unknowns, and the gaps (k,), mm.

        `part` (2 + m,) has the unknowns of this end.
        """
        pose = float(part[0]), float(part[1]) / length
        gaps = self.seat.gaps(*pose, self.way)
        rows = np.empty((gaps.size, part.size))
        rows[:, :2] = self.seat.slopes(*pose, self.way)
        rows[:, 1] /= length
        if part.size > 2:
            rows[:, 2:] = self.sideways / length
            gaps = gaps + rows[:, 2:] @ part[2:]
        return rows, gaps


def _constrained_step(
    hessian: FloatArray,
    gradient: FloatArray,
    walls: tuple[FloatArray, FloatArray],
    length: float,
    shifts: Sequence[int],
    *,
    scale: float,
    penalty: float = OVERLAP_PENALTY,
    reach: float = np.inf,
) -> QuadraticSolution:
    """Return the next step of sequential quadratic programming for n unknowns and k contacts, mm.

    Parameters
    ----------
    hessian, gradient : (n, n), (n,) arrays
        Hessian and gradient of the energy, divided by the bending stiffness B.
    walls : ((k, n), (k,)) arrays
        Gradients of the gaps at all contacts, and the gaps, mm.
    length : float
        Length of the strip, mm. The largest steps are fractions of this length.
    shifts : sequence of int
        Indices of the unknowns that are shifts; all others are angles.
    scale : float
        Number, 1/mm3, by which Hessian and gradient are divided.
    penalty : float
        Penalty for an overlap, relative to the forces.
    reach : float
        Largest step of any unknown, mm.
    """
    rows, gaps = walls
    # in a step, an end turns by at most 0.15 rad and shifts by at most 5 % of the length
    # (unknown angles are multiplied by the length)
    bound = np.full(gradient.size, 0.15 * length)
    bound[shifts] = 0.05 * length
    each = penalty * (np.abs(gradient).max() / scale + bound.max())
    bound = np.minimum(bound, reach)
    # gaps + rows @ x >= 0, with the penalty `each` for an overlap
    program = QuadraticProgram(
        hessian / scale, gradient / scale, -bound, bound, rows, -gaps,
        np.full(gaps.size, each), np.ones(gaps.size, dtype=bool),
    )  # fmt: skip
    return solve_quadratic(program)


OVERLAP_FRACTION = 1e-7  # largest overlap, as a fraction of the length, that counts as a rounding error


def rest_in_seats(
    rod: Rod,
    design: Rod,
    seats: tuple[TabSeat | None, TabSeat | None],
    tab_stiffness: tuple[float, float] = (np.inf, np.inf),
) -> tuple[Rod, tuple[EndPose, EndPose]]:
    """Return the rest shape of a strip whose tabs fit loosely in their holders, and the positions of its ends.

    Tabs can shift across, turn and bend, but not slide along the strip. Contacts have no friction. Sequential
    quadratic programming minimizes the energy under the condition that tabs do not overlap their holders. The
    gradient consists of forces and moments of the rod (paper, Eq. 2). The Hessian consists of finite
    differences of these forces and moments, and of the change of the contact forces with the angles.

    Parameters
    ----------
    rod : Rod
        Rod of the finished strip.
    design : Rod
        Rod with the designed positions of the ends.
    seats : pair of TabSeat or None
        Holders at start and end, or None for an end that is held as designed.
    tab_stiffness : pair of float
        E I of the tabs divided by the bending stiffness B of the rod; infinite for rigid tabs.

    Raises
    ------
    NotConvergedError
        A tab does not fit into its holder, or no rest shape was found.
    """
    # an end that is free to turn is held at its point only, also in a holder
    seated = [
        SeatedEnd(k, seat, stiffness)
        for k, (seat, stiffness) in enumerate(zip(seats, tab_stiffness, strict=True))
        if seat is not None and design.supports.ends[k].angle
    ]
    if not seated:
        return bend(rod, start=design.position[0], end=design.position[-1]), (EndPose(), EndPose())
    problem = _ContactProblem(rod, design, tuple(seated))
    q = np.zeros(problem.slices[-1].stop)
    rod = problem.bent(q, rod)
    stiffness = problem.end_stiffness(q, rod)
    firm = _made_definite(stiffness)
    # first bend the tabs into their holders, because overlaps of straight tabs would move the strip too far
    # in these steps the ends are stiff, so only tabs bend
    for _ in range(3):
        q = q + problem.step(q, rod, 1e4 * firm).x
    rod = problem.bent(q, rod)
    step, pushes = np.zeros(q.size), np.zeros(problem.walls(q)[1].size)
    penalty, reach = OVERLAP_PENALTY, np.inf
    for _ in range(60):
        # after a long step, the stiffness of the ends is computed again
        if np.abs(step).max() > 0.003 * design.length:
            stiffness = problem.end_stiffness(q, rod)
        firm = _made_definite(stiffness - problem.wall_bends(q, pushes))
        solution = problem.step(q, rod, firm, penalty=penalty, reach=reach)
        # the quadratic program divides forces by the largest stiffness
        before, step, pushes = step, solution.x, solution.row_multipliers * np.abs(firm).max()
        moved = np.abs(step).max()
        # a small step that `reach` has shortened is not the last step
        settled = moved <= 1e-9 * design.length and moved < reach
        # a reversed step shows that the previous step was too long for the linear prediction
        reach = 0.5 * moved if step @ before < 0 else 2.0 * reach
        q = q + step
        rod = problem.bent(q, rod)
        if settled:
            if problem.walls(q)[1].min() >= -OVERLAP_FRACTION * design.length:
                break
            # with a larger penalty, the tab does not fit into its holder
            if penalty >= 1e6:
                raise NotConvergedError(problem.without_room(q))
            penalty, reach = 10.0 * penalty, np.inf
    else:
        raise NotConvergedError(
            problem.without_room(q)
            if penalty > OVERLAP_PENALTY and problem.walls(q)[1].min() < -OVERLAP_FRACTION * design.length
            else "the strip is loose in its holders and finds no rest position: reduce the clearance, or hold the "
            "tabs with screws or glue"
        )
    poses = [EndPose(), EndPose()]
    for end, part in problem.parts(q):
        poses[end.index] = EndPose(*problem.pose(part))
    return rod, (poses[0], poses[1])


@dataclass(frozen=True, eq=False)
class _ContactProblem:
    """Search for the rest shape of a loosely held strip. The vector q (n,) has the unknowns of each `SeatedEnd`.

    `made` is the rod of the finished strip, and `seated` are the ends that have a holder.
    """

    made: Rod
    design: Rod
    seated: tuple[SeatedEnd, ...]

    @cached_property
    def slices(self) -> list[slice]:
        # range of each seated end in q
        stops = np.cumsum([0, *(2 + end.pieces for end in self.seated)]).tolist()
        return [slice(*limits) for limits in pairwise(stops)]

    def parts(self, q: FloatArray) -> list[tuple[SeatedEnd, FloatArray]]:
        # return each seated end with its unknowns (2 + m,)
        return [(end, q[columns]) for end, columns in zip(self.seated, self.slices, strict=True)]

    @cached_property
    def poses(self) -> list[int]:
        # indices in q of the shift and the turn of each seated end; all others are angles of tab pieces
        return [columns.start + k for columns in self.slices for k in (0, 1)]

    def pose(self, part: FloatArray) -> tuple[float, float]:
        # return shift, mm, and turn, rad, of an end with the unknowns `part`
        return float(part[0]), float(part[1]) / self.design.length

    def bent(self, q: FloatArray, near: Rod) -> Rod:
        """Return the rest shape of the strip with its ends displaced by q. `near` is the initial guess."""
        design = self.design
        places = [*design.position[[0, -1]]]
        angles = design.angle[[0, -1]].tolist()
        for seated_end, part in self.parts(q):
            shift, turn = self.pose(part)
            places[seated_end.index] = places[seated_end.index] + shift * seated_end.left(design)
            angles[seated_end.index] += turn
        held = [angle if end.angle else None for angle, end in zip(angles, design.supports.ends, strict=True)]
        return bend(near, start=places[0], end=places[1], angles=(held[0], held[1]))

    def reactions(self, rod: Rod) -> FloatArray:
        """Return the results of `SeatedEnd.load` for all ends, 1/mm2."""
        return np.ravel([end.load(rod, self.design) for end in self.seated])

    def end_stiffness(self, q: FloatArray, rod: Rod) -> FloatArray:
        # return the derivatives (p, p), 1/mm3, of the p `reactions` by the unknowns `poses`, from differences
        reactions, difference = self.reactions(rod), 1e-5 * self.design.length
        moves = difference * np.eye(q.size)[self.poses]
        ends = np.array([self.reactions(self.bent(q + move, rod)) - reactions for move in moves]) / difference
        return (ends + ends.T) / 2

    def without_room(self, q: FloatArray) -> str:
        # return the message about the tab that overlaps its holder most
        gaps = [float(end.walls(part, self.design.length)[1].min()) for end, part in self.parts(q)]
        gap, seated_end = min(zip(gaps, self.seated, strict=True), key=itemgetter(0))
        end = "end" if seated_end.index else "start"
        return note(
            "the tab at the {end} does not fit into its {seat}: in every position the tab overlaps the "
            "material by at least {depth:.2g}. Increase the clearance",
            end=end, seat=seated_end.seat.name, depth=Length(-gap),
        )  # fmt: skip

    def wall_bends(self, q: FloatArray, pushes: FloatArray) -> FloatArray:
        """Return the sum of the second derivatives of the gaps times the contact forces, 1/mm3.

        `pushes` (k,) are the contact forces divided by the bending stiffness B.
        """
        blocks, at, scale = [], 0, np.array([1.0, 1 / self.design.length])
        for end, part in self.parts(q):
            bends = end.seat.bends(*self.pose(part), end.way) * np.outer(scale, scale)
            blocks.append(np.einsum("k,kij->ij", pushes[at : at + len(bends)], bends))
            at += len(bends)
        return _block_diagonal(blocks)

    def walls(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the derivatives (k, n) of all gaps with respect to q, and the gaps (k,), mm.

        Overlaps are negative.
        """
        rows, room = zip(*(end.walls(part, self.design.length) for end, part in self.parts(q)), strict=True)
        return _block_diagonal(rows), np.concatenate(room)

    def step(
        self,
        q: FloatArray,
        rod: Rod,
        end_stiffness: FloatArray,
        *,
        penalty: float = OVERLAP_PENALTY,
        reach: float = np.inf,
    ) -> QuadraticSolution:
        """Return the next step of sequential quadratic programming, at most `reach` mm in each unknown."""
        length = self.design.length
        # H is the Hessian of the energy of the tabs, 1/mm3; the Hessian of the rod is added below
        H = _block_diagonal(
            [_block_diagonal([np.zeros((2, 2)), end.bending / length**2]) for end in self.seated]
        )
        g = H @ q
        g[self.poses] = self.reactions(rod)
        H[np.ix_(self.poses, self.poses)] = end_stiffness
        scale = float(np.abs(end_stiffness).max())
        return _constrained_step(
            H, g, self.walls(q), length, self.poses[::2], scale=scale, penalty=penalty, reach=reach
        )


def _block_diagonal(blocks: Sequence[FloatArray]) -> FloatArray:
    from scipy.linalg import block_diag

    return np.asarray(block_diag(*blocks), dtype=float)


def _made_definite(stiffness: FloatArray) -> FloatArray:
    # return the matrix with positive eigenvalues, as a quadratic program needs; unstable shapes have negative ones
    values, vectors = np.linalg.eigh(stiffness)
    # smaller eigenvalues are raised to this fraction of the largest
    values = np.maximum(np.abs(values), 1e-6 * np.abs(values).max())
    return np.asarray(vectors * values @ vectors.T)


@dataclass(frozen=True)
class Lean:
    """Displacement of a holder: `shift` to the left, mm, and `turn` to the left, rad.

    `slopes` are the slopes of the pieces of the resting tab, positive to the left. `piece` is the length of a
    piece, mm.
    """

    shift: float
    turn: float
    slopes: FloatArray
    piece: float

    def touched(self, wall: FloatArray) -> tuple[float, float, float]:
        """Return where the resting tab is nearest to a wall.

        The result is the distance into the tab, mm, its slope there, and the distance of its centre line from
        the wall, mm.

        Parameters
        ----------
        wall : (n, 2) array
            Points of the wall before the displacement, as in `TabSeat`, mm.
        """
        (into, left), (slopes, places, bent) = wall.T, self.resting
        gaps = left + self.shift + self.turn * into - np.interp(into, places, bent)
        nearest = np.abs(gaps).argmin()
        place = float(into[nearest])
        slope = float(slopes[np.clip(int(place / self.piece), 0, slopes.size - 1)])
        return place, slope, float(abs(gaps[nearest]))

    @property
    def bend(self) -> float:
        """Largest angle, rad, by which the resting tab is bent."""
        return float(np.abs(self.slopes).max(initial=0.0))

    @cached_property
    def resting(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Slopes (k,) of the pieces of the resting tab, and `into` and `left` (k + 1,), mm, of their ends."""
        slopes = np.resize(self.slopes, max(self.slopes.size, 1))  # a rigid tab is a piece of slope 0
        bent = np.append(0.0, slopes.cumsum()) * self.piece
        return slopes, np.asarray(self.piece * np.arange(slopes.size + 1), dtype=float), bent


def lean_against(design: Rod, index: int, seat: TabSeat, tab_stiffness: float = np.inf) -> Lean:
    """Return the displacement of a holder that gives the loaded tab its designed position.

    Force and moment of the strip press the tab against some points of the holder. The holder is displaced
    until these points touch the tab in its designed position. Springs resist the load until the tab touches a
    wall. Each iteration uses softer springs, until the displacement no longer changes.

    Parameters
    ----------
    design : Rod
    index : int
        0 for the start, 1 for the end.
    seat : TabSeat
        Holder in its designed position.
    tab_stiffness : float
        E I of the tab divided by the bending stiffness B of the rod; by default the tab is rigid.
    """
    end, length = SeatedEnd(index, seat, tab_stiffness), design.length
    load, piece, sign, n = end.load(design, design), end.piece, end.way, 2 + end.pieces
    shift = turn = 0.0
    pressed = max(map(abs, load))
    if pressed == 0:
        return Lean(shift, turn, np.zeros(end.pieces), piece)
    H, g, q = np.zeros((n, n)), np.zeros(n), np.zeros(n)
    g[:2] = load
    # stiff springs limit the first steps; later, each step multiplies the error by about 1e-4
    springs = chain((1.0, 0.1, 0.01), repeat(1e-4))
    # usually about six iterations are needed
    for spring, _ in zip(springs, range(36), strict=False):
        H[0, 0] = H[1, 1] = spring * pressed / length
        if n > 2:
            H[2:, 2:] = end.bending / length**2
            g[2:] = H[2:, 2:] @ q[2:]
        step = _constrained_step(H, g, end.walls(q, length), length, [0], scale=H[0, 0]).x
        q[2:] += step[2:]
        # the holder moves in the opposite direction to the step of the tab
        shift, turn = shift - float(step[0]), turn - sign * float(step[1]) / length
        if np.abs(step).max() <= 1e-7 * length:
            break
        end = SeatedEnd(index, seat.moved(shift, turn), tab_stiffness)
    return Lean(shift, turn, q[2:] * sign / length, piece)
