"""Bending of a strip by moving its ends along a path: forces, moments, energy, strain and safety at each step."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, BoolArray, FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import Degrees, Force, InputError, Length, Refusal, note
from elastica_cad.geometry.plane_points import dot, norm, unit
from elastica_cad.mechanics.bending import Leg, Place, as_steps, path_legs, places_of
from elastica_cad.mechanics.followed_path import Event
from elastica_cad.mechanics.loads import whole_number
from elastica_cad.mechanics.rod import Rod, csv_text
from elastica_cad.mechanics.sideways import SidewaysStability
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.strip.strip import Strip, strip_sideways

TURNED_DEG = 1e-7  # smaller rotations of an end are rounding errors

TITLES = {
    "mm": "travel mm   force N  strain %    margin",
    "deg": " turn deg   force N  strain %    margin",
    "N": "   load N   force N  strain %    margin",
    "%": "applied %   force N  strain %    margin",
}
"""Header of the printed table, by the unit of the movement."""


@dataclass(frozen=True, eq=False, repr=False)
class Stage:
    """Leg of a bend with its axis.

    Attributes
    ----------
    leg : Leg
    unit : str
        "mm" of travel, "deg" of turn, "N" of load, or "%" of another change.
    travel, turn, load : (float, float)
        Travel of the end, mm, turn of the end that turns more, degrees, and sum of the magnitudes of the new loads,
        N, at the start and at the end of the leg.
    """

    leg: Leg
    unit: str
    travel: tuple[float, float]
    turn: tuple[float, float]
    load: tuple[float, float]

    def at(self, name: str, t: float) -> float:
        """Return travel, turn or load at the fraction t of the leg."""
        begin, end = getattr(self, name)
        return float(begin + t * (end - begin))

    def value(self, t: float) -> float:
        """Return the place on the axis at the fraction t of the leg."""
        name = {"mm": "travel", "deg": "turn", "N": "load"}.get(self.unit)
        return 100 * t if name is None else self.at(name, t)

    def words(self, t: float) -> Refusal:
        """Return words for a place, such as "5 mm of travel"."""
        at = self.value(t)
        if self.unit == "N":
            return note("a load of {force:.4g}", force=Force(at))
        if self.unit == "deg":
            return note("{degrees:.4g} of turn", degrees=Degrees(at))
        if self.unit == "mm":
            return note("{at:.4g} of travel", at=Length(round(at, 2)))
        return note("{percent:.3g} % of the change", percent=at)


@dataclass(frozen=True, eq=False, repr=False)
class Travel:
    """States of a strip at k positions of its ends, in physical units.

    `stable` and `snaps_at` are for ends that a guide holds in place. An end pushed by a constant load is
    unstable where the force decreases with the travel (`force_falls_at`).

    Attributes
    ----------
    strip : Strip
        Strip before its ends are moved.
    path : tuple of dict
        Keyword arguments of `bend` for each step.
    stages : tuple of Stage
        The movement of the ends, and then the growth of the loads, of each step.
    places : tuple of (int, float)
        Stage, and fraction of it, at which each shape is.
    rods : tuple of Rod
        Rest shape at each place.
    end : (k, 2) array
        Position of the end relative to the start, mm.
    travel : (k,) array
        Length of the path of the end relative to the start, from its designed position up to each step, mm.
    turn : (k,) array
        Turn from the design up to each step, rad, of the held end that turns most.
    load : (k,) array
        Sum of the magnitudes of the new loads, N.
    start_force, end_force : (k, 2) array
        Forces of the supports on the strip, N.
    start_moment, end_moment : (k,) array
        Moments of the supports on the strip, N mm, positive anticlockwise.
    force_along : (k,) array
        Component along the path of the force on the end, N; negative if the strip pulls the end forward.
    energy : (k,) array
        Bending energy, N mm (mJ).
    strain, stress : (k,) array
        Surface strain of the layer nearest to its limit (dimensionless), and the elastic stress there, MPa.
    safety : (k,) array
        Strain limit divided by strain, for the layer nearest to its limit.
    verdicts : tuple of Stability
        Stability in the plane of the curve.
    sideways : tuple of SidewaysStability
        Stability against leaving the plane of the curve.
    """

    strip: Strip
    path: tuple[dict[str, Any], ...]
    stages: tuple[Stage, ...]
    places: tuple[Place, ...]
    rods: tuple[Rod, ...]
    end: FloatArray
    travel: FloatArray
    turn: FloatArray
    load: FloatArray
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
        return "\n".join([TITLES[self.unit], *rows, *self.warnings])

    @property
    def unit(self) -> str:
        """Unit of `path_length`: that of the last stage, "mm" of travel, "deg" of turn, "N" of load, or "%"."""
        return self.stages[-1].unit

    @property
    def path_length(self) -> FloatArray:
        """Travel (k,), mm, or turn in degrees, load in newtons or percent of the change; see `unit`."""
        stages = [(self.stages[k], t) for k, t in self.places]
        return np.array([stage.value(t) if stage.unit == self.unit else 0.0 for stage, t in stages])

    @property
    def displacement(self) -> FloatArray:
        """Largest displacement (k,) of a point of the strip from its design, mm."""
        return np.array([norm(rod.position - self.strip.rod.position).max() for rod in self.rods])

    @property
    def sag(self) -> FloatArray:
        """Largest displacement (k,), mm, of a point of the strip under new loads, from its shape before them.

        It is 0 while the ends move.
        """
        before = [stage.leg.rod(0.0).position if stage.unit == "N" else None for stage in self.stages]
        pairs = ((rod.position, before[k]) for rod, (k, _) in zip(self.rods, self.places, strict=True))
        return np.array([0.0 if rest is None else norm(place - rest).max() for place, rest in pairs])

    @property
    def support_force(self) -> FloatArray:
        """Larger of the forces (k,) of the supports on start and end, N."""
        return np.maximum(norm(self.start_force), norm(self.end_force))

    @property
    def support_moment(self) -> FloatArray:
        """Larger of the moments (k,) of the supports on start and end, N mm, without sign."""
        return np.maximum(abs(self.start_moment), abs(self.end_moment))

    @property
    def turning_moment(self) -> FloatArray:
        """Moment (k,), N mm, at the end that turns more."""
        first, last = self.rods[0].angle, self.rods[-1].angle
        start, end = np.abs(last - first)[[0, -1]] * [held.angle for held in self.rods[-1].supports.ends]
        return self.start_moment if start > end else self.end_moment

    def words(self, place: Place) -> Refusal:
        """Return words for a place, such as "5 mm of travel" or "a load of 12 N"."""
        return self.stages[place[0]].words(place[1])

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings that the force decreases, or that the strip snaps, crosses itself or is overstrained."""
        warnings = []
        if self.force_falls_at is not None:
            warnings.append(note(
                "beyond {place}, a smaller force is enough to move the end. An end moved by a guide can "
                "stay there, but an end pushed by a weight runs away",
                place=note("{at:.4g} of travel", at=Length(round(self.force_falls_at, 2))),
            ))  # fmt: skip
        for k, event in self.leaps:
            warnings.append(note(
                "the strip snaps into another shape at {place}" if event.other is None else
                "the strip buckles at {place}, and nothing decides to which side; the result is one of two shapes",
                place=self.words((k, event.t)),
            ))  # fmt: skip
        if self._snaps is not None and not self.leaps:
            warnings.append(
                note("the strip snaps into another shape at {place}", place=self.words(self._snaps))
            )
        if self._crosses is not None:
            warnings.append(note(
                "the strip crosses itself beyond {place}: contact of the strip with itself is not computed",
                place=self.words(self._crosses),
            ))  # fmt: skip
        if self._strained is not None:
            warnings.append(note(
                "the strain exceeds the limit of the material already before the change (limit / strain: "
                "{safety:.2g}): use another sheet, another curve or smaller loads"
                if self._strained == (0, 0.0) else
                "the strain exceeds the limit of the material beyond {place} (limit / strain: {safety:.2g}): use "
                "another sheet or a smaller change"
                if self.unit not in ("mm", "deg") or any("between" in step for step in self.path) else
                "the strain exceeds the limit of the material beyond {place} (limit / strain: {safety:.2g}): use "
                "thinner material, a longer strip or less travel",
                place=self.words(self._strained), safety=self.safety.min(),
            ))  # fmt: skip
        return tuple(warnings)

    @property
    def stable(self) -> BoolArray:
        """True for each step (k,) whose shape is stable with its ends held."""
        return np.array([verdict.stable for verdict in self.verdicts])

    @property
    def margin(self) -> FloatArray:
        """Stability margins (k,)."""
        return np.array([verdict.margin for verdict in self.verdicts])

    @property
    def strained_at(self) -> float | None:
        """First value of `path_length` at which the strain exceeds the limit of the sheet, or None."""
        return self._value(self._strained)

    @property
    def snaps_at(self) -> float | None:
        """First value of `path_length` at which the strip snaps, or None."""
        return self._value(self._snaps)

    @property
    def crosses_at(self) -> float | None:
        """First value of `path_length` at which the strip crosses itself, or None."""
        return self._value(self._crosses)

    def _value(self, place: Place | None) -> float | None:
        return None if place is None else self.stages[place[0]].value(place[1])

    # the first places (number of the stage, fraction of it) at which the strip fails in each way
    @cached_property
    def _strained(self) -> Place | None:
        return self._first_failure(lambda rod: not self.strip.bent_as(rod).most_strained.judged().allowed)

    @property
    def leaps(self) -> list[tuple[int, Event]]:
        """Events in which the strip leaves its shape, each with the number of its stage."""
        return [(k, event) for k, stage in enumerate(self.stages) for event in stage.leg.path.leaps]

    @cached_property
    def _snaps(self) -> Place | None:
        if self.leaps:
            return self.leaps[0][0], self.leaps[0][1].t
        return self._first_failure(lambda rod: not stability(rod).stable)

    @cached_property
    def _crosses(self) -> Place | None:
        return self._first_failure(
            lambda rod: bool(np.ptp(rod.angle) > np.pi and rod.curve.self_intersections().size)
        )

    @cached_property
    def force_falls_at(self) -> float | None:
        """Travel, mm, at which the force along the path of the end first decreases.

        The result is None if the force increases until the strip snaps or the path ends, or without travel.
        """
        if self.unit != "mm":
            return None
        steps, gains = np.diff(self.end, axis=0), np.diff(self.end_force, axis=0)
        # a force that decreases less in a step counts as constant
        even = 1e-4 * norm(self.end_force).max() * norm(steps)
        falls = dot(gains, steps) < -even
        if self.snaps_at is not None:
            falls &= self.travel[1:] <= self.snaps_at
        return float(self.travel[falls.argmax()]) if falls.any() else None

    def _first_failure(self, fails: Callable[[Rod], bool]) -> Place | None:
        """Return the first place at which `fails` is True, within 1e-4 of its stage, or None."""
        for stage, leg in enumerate(one.leg for one in self.stages):
            first, *later = leg.path.visits
            # a strip that nothing changes is known at the end of its path only
            low = first.t % 1.0
            if fails(leg.rod(first.t)):
                return stage, low
            for visit in later:
                high = visit.t
                if not fails(leg.rod(high)):
                    low = high
                    continue
                while high - low > 1e-4:
                    middle = (low + high) / 2
                    low, high = (low, middle) if fails(leg.rod(middle)) else (middle, high)
                return stage, high
        return None

    def table(self) -> dict[str, FloatArray | BoolArray]:
        """Return columns (k,) by name with their unit, for a data frame or a file."""
        return {
            "travel_mm": self.travel,
            "turn_deg": np.degrees(self.turn),
            "load_N": self.load,
            "sag_mm": self.sag,
            "end_x_mm": self.end[:, 0],
            "end_y_mm": self.end[:, 1],
            "force_along_N": self.force_along,
            "end_force_x_N": self.end_force[:, 0],
            "end_force_y_N": self.end_force[:, 1],
            "end_moment_Nmm": self.end_moment,
            "start_force_x_N": self.start_force[:, 0],
            "start_force_y_N": self.start_force[:, 1],
            "start_moment_Nmm": self.start_moment,
            "displacement_mm": self.displacement,
            "energy_Nmm": self.energy,
            "strain": self.strain,
            "stress_MPa": self.stress,
            "safety": self.safety,
            "stable": self.stable,
            "margin": self.margin,
        }

    def csv(self) -> str:
        """Return the columns of `table` as comma-separated text with a header."""
        return csv_text(self.table())


def bend_strip(
    strip: Strip,
    path: "ArrayLike | Sequence[Mapping[str, Any]]",
    *,
    side: int | None = None,
    steps: int = 1,
) -> Travel:
    """Return forces, energy, strain and stability of a strip whose ends are moved along a path.

    Forces follow from the internal force -lambda B, where lambda is that of the rod (paper, Eq. 2) and B is
    the bending stiffness for K = 1. The stiffness of each step includes anticlastic bending of sheets with a
    known Poisson's ratio, and the curling of the borders of laminates. If the widths do not compensate these
    effects, the strip deviates from its design before its ends are moved, as `Strip.held` reports. Other
    effects of `Strip.held`, such as slots, are ignored.

    Parameters
    ----------
    strip : Strip
        Strip to bend. Its rod may be straight.
    path : (k, 2) array_like or sequence of mappings
        Positions of the end at each step, mm, or keyword arguments of `bend` for each step.
    side : {+1, -1}, optional
        Side to which a straight strip bulges, as in `bend`.
    steps : int
        Number of shapes that are listed for each stage of each step: first its ends move, then its loads grow.
        They lie on the same path, whatever their number.

    Returns
    -------
    Travel

    Raises
    ------
    InputError, NotConvergedError
        See `bend`. The message gives the step.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> clip = ec.Strip(ec.Rod.straight(100.0, samples=201), "spring-steel-0.5", max_width=10.0)
    >>> moved = ec.bend_strip(clip, [(95.0, 0.0), (90.0, 0.0)])
    >>> bool(moved.force_along[1] > 0), moved.travel.tolist()
    (True, [5.0, 10.0])
    >>> round(moved.strained_at, 2), moved.snaps_at
    (2.6, None)
    """
    require_record(strip, Strip, "what is bent", "a Strip")
    whole_number(steps, "steps", 1)
    legs = path_legs(strip.rod_to_bend, path, side=side)
    if not legs:
        raise InputError("the path is empty: give the positions to which the end is moved")
    B = strip.bending_stiffness
    places = places_of(legs, steps)
    rods = tuple(legs[k].rod(t) for k, t in places)
    end = np.array([rod.chord for rod in rods])
    stages = _stages(strip.rod, legs)
    travel, turn, load = (
        np.array([stages[k].at(name, t) for k, t in places]) for name in ("travel", "turn", "load")
    )
    start_force, end_force = B * np.stack([rod.support_forces for rod in rods], axis=1)
    moment = np.array([rod.moment for rod in rods])
    layers = [strip.bent_as(rod).most_strained for rod in rods]
    strain = np.array([layer.largest for layer in layers])
    with np.errstate(divide="ignore"):
        safety = np.array([layer.limit for layer in layers]) / strain
    # the path's direction at a position is from the previous position to the next
    begins = np.concatenate([end[:1] if len(end) > 1 else [strip.rod.chord], end[:-1]])
    moves = np.concatenate([end[1:], end[-1:]]) - begins
    return Travel(
        strip=strip, path=tuple(as_steps(path)), stages=stages, places=places, rods=rods, end=end,
        travel=travel, turn=np.radians(turn), load=load,
        start_force=start_force, end_force=end_force,
        start_moment=-B * moment[:, 0], end_moment=B * moment[:, -1],
        force_along=dot(end_force, unit(moves)),
        energy=np.array([B * rod.bending_energy for rod in rods]),
        strain=strain,
        stress=strain * [layer.sheet.youngs_modulus for layer in layers],
        safety=safety,
        verdicts=tuple(map(stability, rods)),
        sideways=tuple(strip_sideways(rod, strip.layout) for rod in rods),
    )  # fmt: skip


def _stages(rod: Rod, legs: Sequence[Leg]) -> tuple[Stage, ...]:
    """Return the legs, which begin at the shape of `rod`, with their axes."""
    stages, travel, turn = [], 0.0, 0.0
    for leg in legs:
        bent = leg.rod(1.0)
        held = [end.angle for end in bent.supports.ends]
        far = round(float(norm(bent.chord - rod.chord)), 9)
        turned = float(np.degrees(np.abs(bent.angle - rod.angle)[[0, -1]] * held).max())
        # sums of the present and of the new loads, N
        load = [sum(one.newtons for one in loads) for loads in leg.loads or ((), ())]
        moves = "mm" if far else "deg" if turned > TURNED_DEG else "%"
        # if loads grow while the ends move (`together`), the axis is the movement
        unit = "N" if load[0] != load[1] and not leg.together else moves
        stages.append(Stage(leg, unit, (travel, travel + far), (turn, turn + turned), (load[0], load[1])))
        rod, travel, turn = bent, travel + far, turn + turned
    return tuple(stages)
