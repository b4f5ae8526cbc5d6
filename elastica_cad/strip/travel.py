"""Bending of a strip by moving its ends along a path: forces, moments, energy, strain and safety at each step."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, BoolArray, FloatArray
from elastica_cad._values import require_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_points import dot, norm, unit
from elastica_cad.mechanics.bending import (
    Movement,
    as_steps,
    bend,
    bend_path,
    has_snapped,
    part_of_change,
    snap_percent,
)
from elastica_cad.mechanics.elements import require_elements
from elastica_cad.mechanics.rod import Rod, csv_text
from elastica_cad.mechanics.sideways import SidewaysStability
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.stability_limits import Course
from elastica_cad.refusals import Degrees, Length, Refusal, note
from elastica_cad.strip.strip import Strip, strip_sideways

TITLES = {
    "mm": "travel mm   force N  strain %    margin",
    "deg": " turn deg   force N  strain %    margin",
    "%": "applied %   force N  strain %    margin",
}
"""Header of the printed table, by the unit of the movement."""


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
    side : {+1, -1} or None
        Side to which a straight strip bulges.
    rods : tuple of Rod
        Rest shape at each step.
    end : (k, 2) array
        Position of the end relative to the start, mm.
    travel : (k,) array
        Length of the path of the end relative to the start, from its designed position up to each step, mm.
    turn : (k,) array
        Turn from the design up to each step, rad, of the held end that turns most.
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
        return "\n".join([TITLES[self.unit], *rows, *self.warnings])

    @cached_property
    def _movement(self) -> Movement:
        return Movement(np.append(0.0, self.travel), np.append(0.0, self.turn))

    @property
    def is_turn(self) -> bool:
        """True if the ends of the strip turn without displacement."""
        return self._movement.is_turn

    @property
    def is_still(self) -> bool:
        """True if the ends do not move, so that only loads, rails, pins or ties change."""
        return self._movement.is_still

    @property
    def unit(self) -> str:
        """Unit of `path_length`: "mm" of travel, "deg" if the ends only turn, or "%" if they do not move."""
        return "deg" if self.is_turn else "%" if self.is_still else "mm"

    @property
    def path_length(self) -> FloatArray:
        """Travel (k,), mm, or the turn in degrees if the ends only turn, or percent of the steps if they do not
        move.
        """
        if self.is_still:
            return 100 * self._movement.progress[1:]
        return np.degrees(self.turn) if self.is_turn else self.travel

    @property
    def displacement(self) -> FloatArray:
        """Largest displacement (k,) of a point of the strip from its design, mm."""
        return np.array([norm(rod.position - self.strip.rod.position).max() for rod in self.rods])

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

    def place_message(self, at: float) -> Refusal:
        """Return words for a place in the movement, such as "5 mm of travel". The unit of `at` is `self.unit`."""
        at = require_number(at, "the place", self.unit)
        if self.is_still:
            return note("{percent:.3g} % of the change", percent=at)
        if self.is_turn:
            return note("{degrees:.4g} of turn", degrees=Degrees(at))
        return note("{at:.4g} of travel", at=Length(round(at, 2)))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings that the force decreases, or that the strip snaps, crosses itself or is overstrained."""
        warnings = []
        if self.force_falls_at is not None:
            warnings.append(note(
                "beyond {place}, a smaller force is enough to move the end. An end moved by a guide can "
                "stay there, but an end pushed by a weight runs away",
                place=self.place_message(self.force_falls_at),
            ))  # fmt: skip
        if self.snaps_at is not None:
            warnings.append(
                note("the strip snaps into another shape at {place}", place=self.place_message(self.snaps_at))
            )
        if self.crosses_at is not None:
            warnings.append(note(
                "the strip crosses itself beyond {place}: contact of the strip with itself is not computed",
                place=self.place_message(self.crosses_at),
            ))  # fmt: skip
        if self.strained_at is not None:
            warnings.append(note(
                "the strain exceeds the limit of the material already before the change (limit / strain: "
                "{safety:.2g}): use another sheet, another curve or smaller loads"
                if self.strained_at == 0 else
                "the strain exceeds the limit of the material beyond {place} (limit / strain: {safety:.2g}): use "
                "another sheet or a smaller change"
                if self.is_still or any({"loads", "between"} & set(step) for step in self.path) else
                "the strain exceeds the limit of the material beyond {place} (limit / strain: {safety:.2g}): use "
                "thinner material, a longer strip or less travel",
                place=self.place_message(self.strained_at), safety=self.safety.min(),
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

    @cached_property
    def strained_at(self) -> float | None:
        """First value of `path_length` at which the strain exceeds the limit of the sheet, or None."""
        return self._first_failure(lambda rod: not self.strip.bent_as(rod).most_strained.judged().allowed)

    @cached_property
    def snaps_at(self) -> float | None:
        """First value of `path_length` at which the strip snaps, or None."""
        at = self._first_failure(lambda rod: has_snapped(rod) or not stability(rod).stable)
        if at == 0 and self.is_still and not any({"loads", "between"} & set(step) for step in self.path):
            # the path changes no ends, loads, rails, pins or ties, so the strip failed while its weight and
            # curling bent it away from its design: return the percentage of them at which it snapped
            return snap_percent(self._at_rest) or 0.0
        return at

    @cached_property
    def crosses_at(self) -> float | None:
        """First value of `path_length` at which the strip crosses itself, or None."""
        return self._first_failure(
            lambda rod: bool(np.ptp(rod.angle) > np.pi and rod.curve.self_intersections().size)
        )

    @cached_property
    def force_falls_at(self) -> float | None:
        """Travel, mm, at which the force along the path of the end first decreases.

        The result is None if the force increases until the strip snaps or the path ends, or without travel.
        """
        if self.is_turn or self.is_still:
            return None
        steps, gains = np.diff(self.end, axis=0), np.diff(self.end_force, axis=0)
        # a force that decreases less in a step counts as constant
        even = 1e-4 * norm(self.end_force).max() * norm(steps)
        falls = dot(gains, steps) < -even
        if self.snaps_at is not None:
            falls &= self.travel[1:] <= self.snaps_at
        return float(self.travel[falls.argmax()]) if falls.any() else None

    @cached_property
    def _at_rest(self) -> Rod:
        return bend(self.strip.rod_to_bend)

    def _first_failure(self, fails: Callable[[Rod], bool]) -> float | None:
        """Return the least `path_length` at which `fails` is True, or None.

        Between two steps, the ends move linearly.
        """
        rods = (self._at_rest, *self.rods)
        k = next((k for k, rod in enumerate(rods) if fails(rod)), None)
        if not k:
            return None if k is None else 0.0
        step, good = dict(self.path[k - 1]), rods[k - 1]
        start, held = good, {"supports": step.pop("supports", good.supports)}
        changed: dict[str, Any] = {name: step.pop(name) for name in ("loads", "between") if name in step}
        course = Course.of(replace(good, **held), [step])
        before, after = np.append(0.0, self.path_length)[k - 1 : k + 1]
        # rails, pins and ties are added or removed at the start of a step
        at_once = "between" in changed and len(require_elements(changed["between"])) != len(start.between)
        low, high = 0.0, 0.0 if at_once else 1.0
        while high - low > 1e-4:
            middle = (low + high) / 2
            entry = course.entry(middle) | part_of_change(start, changed, middle)
            rod = bend(good, **entry, **held, side=self.side if k == 1 else None)
            if fails(rod):
                high = middle
            else:
                low, good = middle, rod
        return float(before + high * (after - before))

    def table(self) -> dict[str, FloatArray | BoolArray]:
        """Return columns (k,) by name with their unit, for a data frame or a file."""
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
    strip: Strip, path: "ArrayLike | Sequence[Mapping[str, Any]]", *, side: int | None = None
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
    rods = bend_path(strip.rod_to_bend, path, side=side)
    if not rods:
        raise InputError("the path is empty: give the positions to which the end is moved")
    B = strip.bending_stiffness
    end = np.array([rod.chord for rod in rods])
    movement = Movement.of([strip.rod, *rods])
    start_force, end_force = B * np.stack([rod.support_forces for rod in rods], axis=1)
    moment = np.array([rod.moment for rod in rods])
    layers = [strip.bent_as(rod).most_strained for rod in rods]
    strain = np.array([layer.largest for layer in layers])
    with np.errstate(divide="ignore"):
        safety = np.array([layer.limit for layer in layers]) / strain
    begins = np.concatenate([end[:1] if len(end) > 1 else [strip.rod.chord], end[:-1]])
    steps = np.concatenate([end[1:], end[-1:]]) - begins
    return Travel(
        strip=strip, path=tuple(as_steps(path)), side=side, rods=rods, end=end,
        travel=movement.travel[1:], turn=movement.turn[1:],
        start_force=start_force, end_force=end_force,
        start_moment=-B * moment[:, 0], end_moment=B * moment[:, -1],
        force_along=dot(end_force, unit(steps)),
        energy=np.array([B * rod.bending_energy for rod in rods]),
        strain=strain,
        stress=strain * [layer.sheet.youngs_modulus for layer in layers],
        safety=safety,
        verdicts=tuple(map(stability, rods)),
        sideways=tuple(strip_sideways(rod, strip.layout) for rod in rods),
    )  # fmt: skip
