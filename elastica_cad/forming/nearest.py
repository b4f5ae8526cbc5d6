"""The nearest rod to a drawn curve that material, machine and gravity allow."""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property, partial

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.forming.binding import Binding, bindings
from elastica_cad.forming.editable import editable_curve
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.march import MarchedRod
from elastica_cad.forming.search import MET, best_outcome, mean_distance
from elastica_cad.forming.setting import Measure, Setting, Weights, node_factors, spline_knots
from elastica_cad.forming.wish import Wish
from elastica_cad.geometry import PlaneCurve, Profile
from elastica_cad.mechanics import Gravity, Rod, Supports
from elastica_cad.mechanics.arguments import (
    require_curve,
    require_gravity,
    required_supports,
    whole_number,
)
from elastica_cad.mechanics.balance import Balance, State
from elastica_cad.mechanics.equilibrium import check_equilibrium

__all__ = ["NearestRod", "Status", "nearest_rod"]

DEFAULT_NODES = 201
FEWEST, MOST, PER_HALF_TURN = 20, 60, 4.2  # coefficients of the stiffness unless told
FAR = 0.05  # largest distance, in diagonals of the wish, beyond which a rod no longer looks like it


class Status(Enum):
    """How the search ended, in a sentence for the user."""

    MET = "All limits are met, and no nearer rod was found."
    UNSETTLED = "All limits are met, but the search was stopped before it settled: a nearer rod may exist."
    FAR = "All limits are met, but only by a rod that no longer looks like the drawn curve: relax what binds."
    NOT_MET = (
        "The limits cannot be met together near this curve: this is the best rod found, relax what binds."
    )
    FAILED = "No rod was computed for this curve: see the message."


@dataclass(frozen=True, eq=False)
class NearestRod:
    """A rod near a wish.

    Attributes
    ----------
    found : Rod or None
        See `rod`; None where nothing could be computed.
    wish : PlaneCurve
        The curve that was drawn.
    status : Status
    deviation : float
        Largest distance between rod and wish, either way, mm.
    mean_deviation : float
        Root mean square distance, arc length against arc length, mm.
    binding : tuple of Binding
        The limits that hold the rod away from the wish, the dearest first.
    violation : float
        Worst broken limit, in lengths of the wish, radians or shares of the limit.
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
    again : callable, optional
        `nearest_rod` with all else that was asked; see `relaxed`.
    """

    found: Rod | None
    wish: PlaneCurve
    status: Status
    deviation: float
    mean_deviation: float
    binding: tuple[Binding, ...]
    violation: float
    iterations: int
    limits: Limits
    keep: Keep
    message: str = ""
    measure: Measure = "mean"
    distance: float = np.inf
    again: "Callable[..., NearestRod] | None" = field(default=None, repr=False)

    @classmethod
    def failed(
        cls, wish: PlaneCurve, message: str, limits: Limits | None = None, keep: Keep | None = None
    ) -> "NearestRod":
        """The record of a curve for which nothing could be computed."""
        return cls(
            found=None, wish=wish, status=Status.FAILED, deviation=np.inf, mean_deviation=np.inf, binding=(),
            violation=np.inf, iterations=0, limits=limits or Limits(), keep=keep or Keep(), message=message,
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
        `check_equilibrium` accepts it.
        """
        return editable_curve(self.rod, tangents=self.keep.both_tangents)

    def relaxed(self, limits: Limits | None = None, keep: Keep | None = None) -> "NearestRod":
        """The answer to the same wish with other limits, or other things kept, and all else as asked.

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
        >>> wish = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
        >>> nearest_rod(wish, Limits(ratio=1.2)).advice[0]  # doctest: +ELLIPSIS
        'The ratio limit costs 0.17... mm of mean distance; 1.44 instead of 1.2 would cost 0.05... mm.'
        """
        from elastica_cad.forming.advice import advised

        return tuple(advised(self))

    def __str__(self) -> str:
        if self.found is None:
            return f"{self.status.value} {self.message}"
        far = f"The rod leaves the drawn curve by {self.deviation:.3g} mm at most."
        return " ".join((self.status.value, far, *self.advice))


def nearest_rod(
    curve: PlaneCurve,
    limits: Limits | None = None,
    keep: Keep | None = None,
    gravity: Gravity | None = None,
    *,
    supports: Supports | None = None,
    weights: Weights = None,
    measure: Measure = "mean",
    samples: int = DEFAULT_NODES,
    coefficients: int | None = None,
) -> NearestRod:
    """The rod nearest to a drawn curve, realizable or not, that meets all limits.

    Stiffness, length and start of the rod are the unknowns and its shape follows from the balance of moments
    (Eqs. 3 and 5), so every rod that is tried rests in its shape; see `forming.sqp` for the method.

    Parameters
    ----------
    curve : PlaneCurve
        The wish.
    limits : Limits, optional
        Hard limits: ratio, stability margin, curvature, ...
    keep : Keep, optional
        What must stay; the end positions unless told.
    gravity : Gravity, optional
        Weight proportional to the stiffness, as of a plain strip.
    supports : Supports, optional
        Clamped at both ends unless given.
    weights : optional
        How much each part of the curve matters: a number, values at equal distances, or a function of the arc
        length of the curve (mm).
    measure : "mean", "closest" or "max"
        Mean square distance, arc length against arc length or each point against the nearest; or the largest
        distance.
    samples : int
        Nodes of the rod.
    coefficients : int
        B-spline coefficients of the stiffness; unless given 20, and 4 more for each half turn of the curve.

    Returns
    -------
    NearestRod
        Also when limits cannot be met: see its `status`, `met` and `binding`.

    Raises
    ------
    InputError
        Limits that contradict each other or the curve.

    References
    ----------
    Paper, sections 4.2, 6.4 and 7.2, whose control point moves this replaces.

    Examples
    --------
    >>> wish = PlaneCurve.spline([(0, 0), (30, 60), (70, 60), (100, 0)], degree=3)
    >>> near = nearest_rod(wish, Limits(ratio=1.5, margin=5))
    >>> near.met, round(near.rod.ratio, 6)
    (True, 1.5)
    """
    setting = _setting(curve, limits, keep, gravity, supports, weights, samples, coefficients)
    problem, outcome, steps = best_outcome(setting, measure)
    rod = _rod(setting, outcome.rod)
    deviation = setting.wish.deviation(outcome.rod.position) * setting.wish.size
    distance = outcome.distance if measure == "max" else float(np.sqrt(2 * outcome.distance))
    if outcome.violation > MET:
        status = Status.NOT_MET
    elif deviation > FAR * setting.wish.diagonal * setting.wish.size:
        status = Status.FAR
    else:
        status = Status.MET if outcome.settled else Status.UNSETTLED
    return NearestRod(
        found=rod, wish=curve, status=status, deviation=deviation,
        mean_deviation=mean_distance(setting, outcome) * setting.wish.size,
        binding=bindings(setting, problem, outcome, measure), violation=outcome.violation, iterations=steps,
        limits=setting.limits, keep=setting.keep, measure=measure,
        distance=distance * setting.wish.size,
        again=partial(
            nearest_rod, curve, gravity=gravity, supports=supports, weights=setting.weights, measure=measure,
            samples=setting.nodes, coefficients=setting.coefficients,
        ),
    )  # fmt: skip


def _setting(
    curve: PlaneCurve, limits: Limits | None, keep: Keep | None, gravity: Gravity | None,
    supports: Supports | None, weights: Weights, samples: int, coefficients: int | None,
) -> Setting:  # fmt: skip
    """Checked input."""
    require_curve(curve)
    require_gravity(gravity)
    for name, value, record in (("limits", limits, Limits), ("keep", keep, Keep)):
        if not (value is None or isinstance(value, record)):
            raise InputError(f"{name} is {value!r}: give a {record.__name__} record, or None")
    if whole_number(samples, "samples", 20) > 5000:
        raise InputError(f"samples={samples!r}: a rod needs 20 to 5000 nodes, 201 are usual")
    wish = Wish.of(curve)
    if coefficients is None:
        half_turns = float(np.abs(np.diff(wish.angle)).sum()) / np.pi
        coefficients = min(MOST, FEWEST + round(PER_HALF_TURN * half_turns), (samples - 1) // 2)
    if whole_number(coefficients, "coefficients", 4) > (samples - 1) // 2:
        raise InputError(
            f"coefficients={coefficients!r}: the stiffness needs 4 coefficients or more, and at most half as many "
            f"as there are edges ({samples - 1})"
        )
    limits, keep = limits or Limits(), keep or Keep()
    for region in limits.keep_out:
        for side, kept, point in zip(("start", "end"), keep.both_ends, wish.position[[0, -1]], strict=True):
            inside = -float(region.clearance((point * wish.size + wish.origin)[None])[0][0])
            if kept and inside > 1e-9 * wish.size:
                raise InputError(
                    f"the kept {side} of the curve lies {inside:.3g} mm inside a keep-out region: "
                    "move the curve or the region, or free that end"
                )
    return Setting(
        wish=wish, limits=limits, keep=keep, supports=required_supports(supports), gravity=gravity,
        weights=node_factors(weights, samples, wish.size), nodes=int(samples), coefficients=int(coefficients),
        line=_line(curve, keep, gravity),
    )  # fmt: skip


def _line(curve: PlaneCurve, keep: Keep, gravity: Gravity | None) -> tuple[FloatArray, FloatArray] | None:
    """Two points of the inflection line that is kept."""
    if not keep.line:
        return None
    if gravity is not None:
        raise InputError("a rod with weight has no inflection line: do without keep line, or without gravity")
    if not isinstance(keep.line, bool):
        return np.asarray(keep.line[0]), np.asarray(keep.line[1])
    line = check_equilibrium(curve).line
    if line is None:
        raise InputError(
            "the drawn curve has no inflection line to keep: give two points, keep line=((x, y), (x, y))"
        )
    point, direction = np.asarray(line.point), np.asarray(line.direction)
    return point, point + direction * curve.length


def _rod(setting: Setting, marched: MarchedRod) -> Rod:
    """The rod in millimetres, least stiffness 1."""
    size = setting.wish.size
    least = float(marched.stiffness.min())
    length = marched.length * size
    knots = spline_knots(setting.coefficients) * length
    profile = Profile(knots, setting.coefficients_of(marched.z) / least)
    nodes = setting.nodes
    blank = Rod.straight(length, profile, samples=nodes, gravity=setting.gravity, supports=setting.supports)
    position = marched.position * size + setting.wish.origin
    balance = Balance(
        stiffness=blank.stiffness, edge_length=length / (nodes - 1), load=blank.nodal_load,
        natural_curvature=0.0, supports=setting.supports, start=position[0], end=position[-1],
        end_angles=marched.angles[[0, -1]], force=np.zeros(2), moments=np.zeros(2),
    )  # fmt: skip
    force = marched.edge_force / (least * size**2)
    reactions = (force - balance.given_force)[:, list(balance.held)].mean(axis=0)
    return balance.rod(State(marched.edge_angles, reactions), blank)
