"""The answer of `nearest_rod`: a rod, how far it is from the drawn curve, and what holds it there."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._notebook import BLUE, GREY, svg_of_lines
from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.limits import MET, Keep, Limits
from elastica_cad.geometry.curves.plane_curve import DRAWN_POINTS, PlaneCurve
from elastica_cad.mechanics.rod.rod_record import Rod

if TYPE_CHECKING:
    from elastica_cad.forming.nearest.nearest_task import Measure, SearchPoint

_UNLIKE = 0.05  # largest distance, in diagonals of the target, beyond which a rod no longer looks like it


class Status(Enum):
    """How the search ended, in a sentence for the user."""

    MET = "All limits are met, and no nearer rod was found."
    UNSETTLED = "All limits are met, but the search was stopped before it settled: a nearer rod may exist."
    FAR = "All limits are met, but only by a rod that no longer looks like the drawn curve: relax what binds."
    NOT_MET = (
        "The limits cannot be met together near this curve: this is the best rod found, relax what binds."
    )
    FAILED = "No rod was computed for this curve: see the message."


def judge_search(violation: float, deviation: float, settled: bool) -> Status:
    """How a search ended: by what is broken, by how far off it is, in diagonals, by whether it came to rest."""
    if violation > MET:
        return Status.NOT_MET
    if deviation > _UNLIKE:
        return Status.FAR
    return Status.MET if settled else Status.UNSETTLED


@dataclass(frozen=True)
class Binding:
    """A limit, or something kept, that costs distance.

    Attributes
    ----------
    name : str
        "ratio", "margin", "curvature", "length", "keep-out", "stiffness bounds", "end position", "end tangent",
        "start position", "start tangent", "points", "inflection line", "symmetry", ...
    limit : float or None
        Its present value where it is one number (curvature in 1/mm, lengths in mm).
    cost : float
        Millimetres of distance (mean or largest, as measured) saved at first by relaxing it by one unit; for what
        is kept, by moving it by 1 mm or 1 rad.
    broken : float
        By how much it is missed, in lengths of the drawn curve, radians or shares of the limit.
    """

    name: str
    limit: float | None
    cost: float
    broken: float = 0.0


@dataclass(frozen=True, eq=False)
class NearestRod:
    """A rod near a drawn curve.

    Attributes
    ----------
    found : Rod or None
        See `rod`; None where nothing could be computed.
    target : PlaneCurve
        The curve that was drawn.
    status : Status
    deviation : float
        Largest distance between rod and curve, either way, mm.
    mean_deviation : float
        Root mean square distance, arc length against arc length, mm.
    binding : tuple of Binding
        The limits that hold the rod away from the drawn curve, the dearest first.
    violation : float
        Worst broken limit, in lengths of the drawn curve, radians or shares of the limit.
    iterations : int
        Steps (quadratic programs accepted) over all starts.
    limits, keep
        As asked.
    message : str
        What went wrong where the status is FAILED.
    measure : "mean", "closest" or "max"
        As asked.
    distance : float
        What was made least: the distance as measured and weighted, mm.
    ties : tuple of Rod
        Rods of another shape that meet the limits and are as near, but for 2 %.
    ended : SearchPoint or None
        Where the search ended; `nearest_rod` begins there that has this record as `start`.
    again : callable, optional
        `nearest_rod` with all else that was asked; see `relaxed`.
    advise : callable, optional
        What turns this record into sentences; see `advice`.
    """

    found: Rod | None
    target: PlaneCurve
    status: Status
    deviation: float
    mean_deviation: float
    binding: tuple[Binding, ...]
    violation: float
    iterations: int
    limits: Limits
    keep: Keep
    message: str = ""
    measure: "Measure" = "mean"
    distance: float = np.inf
    ties: tuple[Rod, ...] = ()
    ended: "SearchPoint | None" = field(default=None, repr=False)
    again: "Callable[..., NearestRod] | None" = field(default=None, repr=False)
    advise: "Callable[[NearestRod], Iterable[str]] | None" = field(default=None, repr=False)

    @classmethod
    def failed(
        cls, target: PlaneCurve, message: str, limits: Limits | None = None, keep: Keep | None = None
    ) -> "NearestRod":
        """The record of a curve for which nothing could be computed."""
        return cls(
            found=None, target=target, status=Status.FAILED, deviation=np.inf, mean_deviation=np.inf, binding=(),
            violation=np.inf, iterations=0, limits=Limits() if limits is None else limits,
            keep=Keep() if keep is None else keep, message=message,
        )  # fmt: skip

    @property
    def rod(self) -> Rod:
        """The discrete rod in balance; `rod.profile` is its stiffness, a cubic spline.

        Raises
        ------
        NotConvergedError
            When the status is FAILED.
        """
        if self.found is None:
            raise self._no_rod
        return self.found

    @property
    def _no_rod(self) -> NotConvergedError:
        return NotConvergedError(f"there is no rod for this curve: {self.message}")

    @property
    def met(self) -> bool:
        """Are all limits met (to 1e-6)?"""
        return self.violation <= MET

    @cached_property
    def curve(self) -> PlaneCurve:
        """The rest shape as a spline of degree 4 with few control points, to go on editing.

        It follows the rod to 1e-3 mm; without weight its inflections lie on one line, so that
        `check_equilibrium` accepts it. Of glued leaves it is the rod's own curve.
        """
        from elastica_cad.forming.nearest.editable_curve import editable_curve

        section = self.rod.section
        if section is not None and section.stack is not None:  # its curvature goes in steps
            return self.rod.curve
        return editable_curve(self.rod, tangents=self.keep.both_tangents)

    def relaxed(self, limits: Limits | None = None, keep: Keep | None = None) -> "NearestRod":
        """The answer for the same curve with other limits, or other things kept, and all else as asked.

        Raises
        ------
        NotConvergedError
            When the status is FAILED.
        """
        if self.again is None:
            raise self._no_rod
        return self.again(limits=limits or self.limits, keep=keep or self.keep)

    @cached_property
    def advice(self) -> tuple[str, ...]:
        """What binds in words, and what could be done: sentences, the most useful first.

        Costs are differences to rods that are solved for when this is asked for, one limit relaxed at a time:
        as long as a few calls of `nearest_rod`. Where supports would help, `split` says where.

        Examples
        --------
        >>> from elastica_cad.forming.nearest.nearest_rod import nearest_rod
        >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
        >>> nearest_rod(arch, Limits(ratio=1.2)).advice[0]  # doctest: +ELLIPSIS
        'The ratio limit costs 0.17... mm of mean distance; 1.44 instead of 1.2 would cost 0.05... mm.'
        """
        return () if self.advise is None else tuple(self.advise(self))

    def __repr__(self) -> str:
        return f"<NearestRod {self.status.name}, {self.deviation:.3g} mm from its target, {self.found!r}>"

    def _repr_svg_(self) -> str:
        """The drawn curve, and over it the rod."""
        drawn = [(self.target.sample(DRAWN_POINTS).position, GREY, False)]
        found = [] if self.found is None else [(self.found.position, BLUE, False)]
        return svg_of_lines(drawn + found, repr(self))

    @property
    def verdict(self) -> str:
        """How the search ended and how far the rod is from the drawn curve, without advice."""
        if self.found is None:
            return f"{self.status.value} {self.message}"
        far = f"The rod leaves the drawn curve by {self.deviation:.3g} mm at most."
        return f"{self.status.value} {far}"

    def __str__(self) -> str:
        return " ".join((self.verdict, *self.advice))
