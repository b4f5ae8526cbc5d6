"""Result of `nearest_rod`: the rod, its distance from the drawn curve, active limits, and suggestions."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import BLUE, GREY, svg_of_lines
from elastica_cad.errors import Angle, Either, Length, NotConvergedError, note, sentences
from elastica_cad.form_finding.limits import MET, ActiveLimit, Keep, Limits, Measure, require_limits
from elastica_cad.geometry.plane_curve import DRAWN_POINTS, PlaneCurve
from elastica_cad.mechanics.rod import Rod

if TYPE_CHECKING:
    from elastica_cad.form_finding.nearest_task import SearchPoint


class Status(Enum):
    """Status of a search, with a sentence for the user."""

    MET = "All limits are met, and no nearer curve was found."
    UNSETTLED = "All limits are met, but the search stopped early: a nearer curve may exist."
    FAR = "All limits are met, but the result is far from the drawn curve. Relax a limit."
    NOT_MET = "No curve near the drawn one meets all limits; this is the best one found. Relax a limit."
    FAILED = "No result was computed for this curve: see the message."


def judge_search(violation: float, deviation: float, settled: bool) -> Status:
    """Return the status of a search.

    `violation` is the largest violation of a limit. `deviation` is the distance from the drawn curve, divided by
    the diagonal of the curve's bounding box. `settled` is True if the search converged."""
    if violation > MET:
        return Status.NOT_MET
    if deviation > 0.05:  # the rod no longer resembles the curve
        return Status.FAR
    return Status.MET if settled else Status.UNSETTLED


@dataclass(frozen=True, eq=False)
class NearestRod:
    """The rod nearest to a drawn curve within limits, with details of the search.

    Attributes
    ----------
    found : Rod or None
        The rod, or None if nothing could be computed: see `rod`.
    target : PlaneCurve
        The drawn curve.
    status : Status
    deviation : float
        Largest distance of a rod point from the curve, or of a curve point from the rod, mm.
    mean_deviation : float
        Root mean square distance, mm, between points at the same fraction of the length.
    binding : tuple of ActiveLimit
        Limits and kept properties that are violated, followed by those that increase the distance; in each group,
        the largest effect is first.
    violation : float
        Largest violation of any limit; see `ActiveLimit.broken` for its units.
    iterations : int
        Number of accepted steps of the search, from all initial guesses.
    limits, keep
        Limits and kept properties of the request.
    message : str
        Reason for the status FAILED.
    measure : "max" or "mean"
        Measure of the distance in the request.
    distance : float
        Distance that was minimised, mm, in the requested measure and with the requested weights.
    ties : tuple of Rod
        Rods of different shapes that meet the limits and whose distances are at most 2 % larger.
    ended : SearchPoint or None
        End of the search, where `nearest_rod` continues if this record is passed as `start`.
    again : callable, optional
        Function that repeats the request with other limits: see `relaxed`.
    """

    found: Rod | None
    target: PlaneCurve
    status: Status
    deviation: float
    mean_deviation: float
    binding: tuple[ActiveLimit, ...]
    violation: float
    iterations: int
    limits: Limits
    keep: Keep
    message: str = ""
    measure: Measure = "max"
    distance: float = np.inf
    ties: tuple[Rod, ...] = ()
    ended: "SearchPoint | None" = field(default=None, repr=False)
    again: "Callable[..., NearestRod] | None" = field(default=None, repr=False)

    @classmethod
    def failure(
        cls, target: PlaneCurve, message: str, limits: Limits | None = None, keep: Keep | None = None
    ) -> "NearestRod":
        """Return the record with the status FAILED, for a curve whose rod could not be computed."""
        return cls(
            found=None, target=target, status=Status.FAILED, deviation=np.inf, mean_deviation=np.inf, binding=(),
            violation=np.inf, iterations=0, limits=Limits() if limits is None else limits,
            keep=Keep() if keep is None else keep, message=message,
        )  # fmt: skip

    @property
    def rod(self) -> Rod:
        """Discrete rod in equilibrium. Its stiffness is the cubic spline `rod.profile`.

        Raises
        ------
        NotConvergedError
            The status is FAILED.
        """
        if self.found is None:
            raise self._no_rod
        return self.found

    @property
    def _no_rod(self) -> NotConvergedError:
        return NotConvergedError("there is no rod for this curve: {message}", message=self.message)

    @property
    def failed(self) -> bool:
        """True if no rod could be computed."""
        return self.status is Status.FAILED

    @property
    def met(self) -> bool:
        """True if all limits are met, with a tolerance of 5e-5."""
        return self.violation <= MET

    @cached_property
    def curve(self) -> PlaneCurve:
        """Shape of the rod in equilibrium, as a spline of degree 4 with few control points for further editing.

        The distance of the spline from the rod is at most 1e-3 mm. Without weight, the inflections are on one
        line, so that `check_equilibrium` accepts the spline. For glued plies, the result is the curve of the rod.
        """
        from elastica_cad.form_finding.editable_curve import editable_curve

        section = self.rod.section
        # the curvature of a stack of plies jumps at their ends, so no smooth curve has it
        if section is not None and section.stack is not None:
            return self.rod.curve
        return editable_curve(self.rod)

    def relaxed(self, limits: Limits | None = None, keep: Keep | None = None) -> "NearestRod":
        """Return the nearest rod of the same request with other limits or kept properties.

        Raises
        ------
        NotConvergedError
            The status is FAILED.
        """
        if self.again is None:
            raise self._no_rod
        require_limits(limits, keep)
        return self.again(limits=limits or self.limits, keep=keep or self.keep)

    @cached_property
    def advice(self) -> tuple[str, ...]:
        """Suggestions for reducing the distance from the drawn curve, the most useful first.

        The effects of changes are first-order estimates from the Lagrange multipliers. `relaxed` computes the rod
        for a changed limit. `split` finds supports for the drawn curve.

        Examples
        --------
        >>> from elastica_cad.form_finding.nearest_search import nearest_rod
        >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
        >>> nearest_rod(arch, Limits(ratio=1.2)).advice[0]  # doctest: +ELLIPSIS
        'To come nearer to the drawn curve, relax the ratio limit: a change of 10 % reduces the largest ... mm.'
        """
        return tuple(_advise(self))

    def __repr__(self) -> str:
        return f"<NearestRod {self.status.name}, {self.deviation:.3g} mm from its target, {self.found!r}>"

    def _repr_svg_(self) -> str:
        target_line = [(self.target.sample(DRAWN_POINTS).position, GREY, False)]
        bent = [] if self.found is None else [(self.found.position, BLUE, False)]
        return svg_of_lines(target_line + bent, repr(self))

    @property
    def verdict(self) -> str:
        """Sentence on the status and the distance from the drawn curve, without suggestions."""
        if self.found is None:
            return sentences([note(self.status.value), self.message], " ")
        far = note(
            "The strip follows the nearest possible curve, at most {far} from the drawn curve.",
            far=Length(self.deviation),
        )
        return sentences([note(self.status.value), far], " ")

    def __str__(self) -> str:
        return sentences((self.verdict, *self.advice), " ")


def _advise(near: NearestRod) -> Iterator[str]:
    """Yield instructions: which limits to relax, and how much nearer the rod would then be."""
    if near.found is None:
        return
    if near.ties:
        yield note(
            "Other shapes ({count}) are as near to the drawn curve, within 2 %; `ties` lists these shapes. "
            "Draw the curve closer to the intended shape.",
            count=len(near.ties),
        )
    named = [binding for binding in near.binding if binding.title][:4]
    if near.status is Status.NOT_MET:
        yield from (_violation_sentence(near, binding) for binding in near.binding if binding.broken > 1e-4)
        if named:
            yield note("Relax {limits}.", limits=Either(binding.title for binding in named))
    # make no suggestions for a slight distance
    elif near.distance > 1e-3 * np.hypot(*np.ptp(near.target.bounds, axis=0)):
        for binding in named:
            step, size = _step(binding)
            if not size:
                yield note("Relax {limits}.", limits=binding.title)
            elif binding.cost * size > 0.01 * near.distance:  # the effect is not negligible
                yield note(
                    ("To come nearer to the drawn curve, relax {limit}: a change of {step} reduces the "
                     "{distance} by about {saved:.3g}."),
                    limit=binding.title, step=step, saved=Length(binding.cost * size),
                    distance=note("largest distance" if near.measure == "max" else "mean distance"),
                )  # fmt: skip


def _step(binding: ActiveLimit) -> tuple[str | Length, float]:
    """Return a small change of a limit, as text and as a number in the unit of the limit.

    The number is 0 for a limit that is not a number, such as the symmetry.
    """
    match binding.unit:
        case "angle":
            return note("1 degree"), float(np.radians(1))
        case "length":
            return Length(1), 1.0
        case "number":
            return "10 %", 0.1 * abs(1.0 if binding.limit is None else binding.limit)
    return "", 0.0


def _violation_sentence(near: NearestRod, binding: ActiveLimit) -> str:
    """Return the sentence on a limit that the rod violates, and by how much."""
    if binding.sentence is not None:
        return binding.sentence(binding.limit, near.rod)
    missed = note(binding.name)
    # `broken` is a fraction of the drawn length for lengths, and in rad for angles
    if binding.unit == "length":
        by = Length(binding.broken * near.target.length)
        return note("The strip violates a limit by {by}: {missed}.", missed=missed, by=by)
    if binding.unit == "angle":
        return note(
            "The strip violates a limit by {angle:.3g}: {missed}.", missed=missed, angle=Angle(binding.broken)
        )
    return note("The strip violates a limit: {missed}.", missed=missed)
