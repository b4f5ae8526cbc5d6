"""A strip led through a travel: forces and moments at its ends, energy, strain and safety, step by step."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray
from elastica_cad._values import require_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.mechanics.bending import Movement, as_steps, bend, bend_path, has_snapped
from elastica_cad.mechanics.rod import Rod, csv_text
from elastica_cad.mechanics.sideways import SidewaysStability
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.stability_limits import Course
from elastica_cad.refusals import Length, Refusal, note
from elastica_cad.strip.strip import Strip, strip_sideways
from elastica_cad.strip.styles import Bends

RESOLUTION_SHARE = 1e-4
"""Of a step: how closely the place is found at which a shape snaps, is strained too much or crosses itself."""

FALL_SHARE = 1e-4
"""Of the largest force: a force that falls by less in a step counts as even."""

TITLES = "travel mm   force N  strain %    margin"
TURN_TITLES = " turn deg   force N  strain %    margin"


@dataclass(frozen=True, eq=False, repr=False)
class Travel:
    """What a strip does at k places of its ends, in physical units.

    `stable` and `snaps_at` are of ends that are led and held where they are. A weight that pushes an end runs away
    where the force falls with the travel: `force_falls_at`.

    Attributes
    ----------
    strip : Strip
        As it is before its ends are moved.
    path : tuple of dict
        Keywords of `bend` for each step.
    side : {+1, -1} or None
        To which side a straight strip bulges.
    rods : tuple of Rod
        The rest shape at each step.
    end : (k, 2) array
        Where the end is, seen from the start, mm.
    travel : (k,) array
        Way of the end seen from the start up to each step, mm, from where the strip's own end is.
    turn : (k,) array
        Angle by which the held end that turns most has turned up to each step, rad.
    start_force, end_force : (k, 2) array
        What the supports push the strip with, N.
    start_moment, end_moment : (k,) array
        N mm, positive anticlockwise.
    force_along : (k,) array
        What the end is pushed with in the direction of its way, N: positive where work is put in, negative where
        the strip pulls the end on.
    energy : (k,) array
        Stored by bending, N mm (mJ).
    strain, stress : (k,) array
        Of the most strained skin (dimensionless), and its elastic stress, MPa.
    safety : (k,) array
        Strain limit over strain of the layer nearest to its limit.
    verdicts : tuple of Stability
        In the plane of the curve.
    sideways : tuple of SidewaysStability
        Out of it.
    """

    strip: Strip
    path: tuple[dict[str, Any], ...]
    side: int | None
    rods: tuple[Rod, ...]
    end: FloatArray
    travel: FloatArray
    turn: FloatArray
    start_force: FloatArray
    end_force: FloatArray
    start_moment: FloatArray
    end_moment: FloatArray
    force_along: FloatArray
    energy: FloatArray
    strain: FloatArray
    stress: FloatArray
    safety: FloatArray
    verdicts: tuple[Stability, ...]
    sideways: tuple[SidewaysStability, ...]

    def __repr__(self) -> str:
        return f"<Travel of {len(self.rods)} steps to {self.path_length[-1]:.4g} {self.unit}>"

    def __str__(self) -> str:
        rows = [
            f"{travel:9.4g} {force:9.4g} {100 * strain:9.3g} {margin:9.3g}"
            for travel, force, strain, margin in zip(
                self.path_length, self.force_along, self.strain, self.margin, strict=True
            )
        ]
        titles = TURN_TITLES if self.is_turn else TITLES
        return "\n".join([titles, *rows, *self.warnings])

    @property
    def is_turn(self) -> bool:
        """Return True if the ends turn without travel."""
        return self._movement.is_turn

    @property
    def unit(self) -> str:
        """Return the unit of `path_length`: "mm" of travel, or "deg" of turn where the ends only turn."""
        return "deg" if self.is_turn else "mm"

    @property
    def path_length(self) -> FloatArray:
        """Return the travel (k,), mm, or where the ends only turn their turn, degrees."""
        return np.degrees(self.turn) if self.is_turn else self.travel

    @property
    def _movement(self) -> Movement:
        return Movement(np.append(0.0, self.travel), np.append(0.0, self.turn))

    @property
    def turning_moment(self) -> FloatArray:
        """Return the moment (k,), N mm, at the end that turns more."""
        first, last = self.rods[0].angle, self.rods[-1].angle
        start, end = np.abs(last - first)[[0, -1]] * [held.angle for held in self.rods[-1].supports.ends]
        return self.start_moment if start > end else self.end_moment

    def tell_place(self, at: float) -> Refusal:
        """Return the words for a place on the movement, mm of travel or degrees of turn."""
        at = require_number(at, "the place", "degrees" if self.is_turn else "mm")
        if self.is_turn:
            return note("{degrees:.4g} degrees of turn", degrees=at)
        return note("{at:.4g} of travel", at=Length(round(at, 2)))

    @property
    def warnings(self) -> tuple[str, ...]:
        """A sentence each where its force falls, where it snaps, where it crosses itself, and where it is strained
        beyond what its sheet bears.
        """
        told = []
        if self.force_falls_at is not None:
            told.append(note(
                "from {place} on the force falls: an end that is led stays there, one that a weight "
                "pushes runs away",
                place=self.tell_place(self.force_falls_at),
            ))  # fmt: skip
        if self.snaps_at is not None:
            told.append(note("at {place} it snaps out of its shape", place=self.tell_place(self.snaps_at)))
        if self.crosses_at is not None:
            told.append(note(
                "from {place} on it crosses itself: that it touches itself there is left out",
                place=self.tell_place(self.crosses_at),
            ))  # fmt: skip
        if self.strained_at is not None:
            told.append(note(
                "from {place} on it is strained beyond what the sheet bears (safety {safety:.2g}): take "
                "a thinner sheet, a longer strip or less travel",
                place=self.tell_place(self.strained_at), safety=self.safety.min(),
            ))  # fmt: skip
        return tuple(told)

    @property
    def stable(self) -> BoolArray:
        """Does the shape of each step (k,) stay where its ends are led?"""
        return np.array([verdict.stable for verdict in self.verdicts])

    @property
    def margin(self) -> FloatArray:
        """Stability margins (k,)."""
        return np.array([verdict.margin for verdict in self.verdicts])

    @cached_property
    def strained_at(self) -> float | None:
        """Place of `path_length` from which the sheet is strained beyond its limit; None where it never is."""
        return self._first(lambda rod: _most_strained(self.strip, rod)[2] < 1)

    @cached_property
    def snaps_at(self) -> float | None:
        """Place of `path_length` at which the strip snaps, its ends driven; None where every step is stable."""
        return self._first(lambda rod: has_snapped(rod) or not stability(rod).stable)

    @cached_property
    def crosses_at(self) -> float | None:
        """Place of `path_length` from which the strip crosses itself; None where it never does."""
        return self._first(_crosses_itself)

    @cached_property
    def force_falls_at(self) -> float | None:
        """Travel of the first step behind which the force on the end falls along its way, mm.

        None where it rises at every step, or until the strip snaps, and where the ends only turn.
        """
        if self.is_turn:
            return None
        steps, gains = np.diff(self.end, axis=0), np.diff(self.end_force, axis=0)
        even = FALL_SHARE * np.linalg.norm(self.end_force, axis=1).max() * np.linalg.norm(steps, axis=1)
        falls = np.sum(gains * steps, axis=1) < -even
        if self.snaps_at is not None:
            falls &= self.travel[1:] <= self.snaps_at
        return float(self.travel[int(np.argmax(falls))]) if falls.any() else None

    @cached_property
    def _at_rest(self) -> Rod:
        """The strip before it is moved, also under a weight that it was not designed for."""
        return bend(self.strip.rod_to_bend)

    def _first(self, fails: Callable[[Rod], bool]) -> float | None:
        """First place of `path_length` where a shape fails; between steps the ends move in straight lines."""
        rods = (self._at_rest, *self.rods)
        k = next((k for k, rod in enumerate(rods) if fails(rod)), None)
        if not k:
            return None if k is None else 0.0
        step, good = dict(self.path[k - 1]), rods[k - 1]
        held = {"supports": step.pop("supports", good.supports)}
        way = Course.of(replace(good, **held), [step])
        low, high = 0.0, 1.0
        while high - low > RESOLUTION_SHARE:
            middle = (low + high) / 2
            rod = bend(good, **way.asked(middle), **held, side=self.side if k == 1 else None)
            if fails(rod):
                high = middle
            else:
                low, good = middle, rod
        before, after = np.append(0.0, self.path_length)[k - 1 : k + 1]
        return float(before + high * (after - before))

    def table(self) -> dict[str, FloatArray | BoolArray]:
        """Columns (k,) by name with their unit, for a data frame or a file."""
        return {
            "travel_mm": self.travel,
            "turn_deg": np.degrees(self.turn),
            "end_x_mm": self.end[:, 0],
            "end_y_mm": self.end[:, 1],
            "force_along_N": self.force_along,
            "end_force_x_N": self.end_force[:, 0],
            "end_force_y_N": self.end_force[:, 1],
            "end_moment_Nmm": self.end_moment,
            "start_force_x_N": self.start_force[:, 0],
            "start_force_y_N": self.start_force[:, 1],
            "start_moment_Nmm": self.start_moment,
            "energy_Nmm": self.energy,
            "strain": self.strain,
            "stress_MPa": self.stress,
            "safety": self.safety,
            "stable": self.stable,
            "margin": self.margin,
        }

    def csv(self) -> str:
        """The table as comma-separated text with a header."""
        return csv_text(self.table())


def bend_strip(
    strip: Strip, path: "ArrayLike | Sequence[Mapping[str, Any]]", *, side: int | None = None
) -> Travel:
    """Lead the ends of a strip along a path and tell what it does, in newtons and millimetres.

    Forces follow from the internal force -lambda B (Eq. 2), with B the bending stiffness where K = 1; the energy is
    what bending stores. Sheets whose Poisson ratio is known stiffen across as each step bends them, and borders of
    laminates give way. Widths that do not make up for it rest off their design from the start, by what `Strip.held`
    tells; its other causes, such as slots, are left out.

    Parameters
    ----------
    strip : Strip
        Its rod may be straight: a strip cut to a width profile and then bent.
    path : (k, 2) array_like or sequence of mappings
        Positions of the end at each step, mm, or keywords of `bend` for it.
    side : {+1, -1}, optional
        To which side a straight strip bulges, as in `bend`.

    Returns
    -------
    Travel

    Raises
    ------
    InputError, NotConvergedError
        As `bend`, with the step.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> clip = ec.Strip(ec.Rod.straight(100.0, samples=201), "spring-steel-0.5", max_width=10.0)
    >>> moved = ec.bend_strip(clip, [(95.0, 0.0), (90.0, 0.0)])
    >>> bool(moved.force_along[1] > 0), moved.travel.tolist()
    (True, [5.0, 10.0])
    >>> round(moved.strained_at, 2), moved.snaps_at
    (2.59, None)
    """
    require_record(strip, Strip, "what is bent", "a Strip")
    rods = bend_path(strip.rod_to_bend, path, side=side)
    if not rods:
        raise InputError("the path holds no place: give the places that the end is moved to")
    B = strip.bending_stiffness
    end = np.array([rod.position[-1] - rod.position[0] for rod in rods])
    own = strip.rod.position[-1] - strip.rod.position[0]
    movement = Movement.of([strip.rod, *rods])
    force = np.array([rod.force for rod in rods])
    moment = np.array([rod.moment for rod in rods])
    skins = [_most_strained(strip, rod) for rod in rods]
    end_force = -B * force[:, -1]
    return Travel(
        strip=strip, path=tuple(as_steps(path)), side=side, rods=rods, end=end,
        travel=movement.travel[1:], turn=movement.turn[1:],
        start_force=B * force[:, 0], end_force=end_force,
        start_moment=-B * moment[:, 0], end_moment=B * moment[:, -1],
        force_along=np.sum(end_force * _directions(end, own), axis=1),
        energy=np.array([B * rod.bending_energy for rod in rods]),
        strain=np.array([strain for strain, _, _ in skins]),
        stress=np.array([stress for _, stress, _ in skins]),
        safety=np.array([safety for _, _, safety in skins]),
        verdicts=tuple(stability(rod) for rod in rods),
        sideways=tuple(strip_sideways(rod, strip.layout) for rod in rods),
    )  # fmt: skip


def _directions(end: FloatArray, own: FloatArray) -> FloatArray:
    """Unit vectors (k, 2) of the way of the end, seen from the start; 0 where it stands still."""
    first = end[0] if len(end) > 1 else own
    before = np.concatenate([[first], end[:-1]])
    after = np.concatenate([end[1:], end[-1:]])
    way = after - before
    size = np.hypot(way[:, 0], way[:, 1])[:, None]
    return np.asarray(np.divide(way, size, out=np.zeros_like(way), where=size > 0))


def _crosses_itself(rod: Rod) -> bool:
    """Whether it does; without more than half a turn it cannot."""
    return bool(np.ptp(rod.angle) > np.pi and rod.curve.self_intersections().size)


def _most_strained(strip: Strip, rod: Rod) -> tuple[float, float, float]:
    """Strain, elastic stress (MPa) and safety of the layer nearest to its limit."""
    bent = np.abs(rod.curvature - rod.natural_curvature)
    layers = strip.layout.strains(Bends(bent, rod.s))
    k = max(range(len(layers)), key=lambda i: layers[i].largest / layers[i].limit)
    worst = layers[k]
    with np.errstate(divide="ignore"):
        safety = float(np.divide(worst.limit, worst.largest))
    return worst.largest, worst.largest * strip.layers[k].sheet.youngs_modulus, safety
