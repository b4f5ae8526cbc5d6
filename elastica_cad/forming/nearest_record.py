"""The answer of `nearest_rod`: a rod, how far it is from the drawn curve, what holds it there, and advice."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._notebook import BLUE, GREY, svg_of_lines
from elastica_cad.errors import ElasticaError, NotConvergedError
from elastica_cad.forming.limits import MET, Keep, Limits
from elastica_cad.forming.splitting import split
from elastica_cad.geometry.plane_curve import DRAWN_POINTS, PlaneCurve
from elastica_cad.mechanics.equilibrium_check import check_equilibrium
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import stability
from elastica_cad.refusals import Length, note, sentences

if TYPE_CHECKING:
    from elastica_cad.forming.nearest_task import Measure, SearchPoint


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
    """Status of a search, from the violation of its limits, its distance in diagonals, and whether it
    converged."""
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
        return NotConvergedError("there is no rod for this curve: {message}", message=self.message)

    @property
    def met(self) -> bool:
        """Whether all limits are met (to 1e-6)."""
        return self.violation <= MET

    @cached_property
    def curve(self) -> PlaneCurve:
        """The rest shape as a spline of degree 4 with few control points, to go on editing.

        It follows the rod to 1e-3 mm; without weight its inflections lie on one line, so that
        `check_equilibrium` accepts it. Of glued leaves it is the rod's own curve.
        """
        from elastica_cad.forming.editable_curve import editable_curve

        section = self.rod.section
        if section is not None and section.stack is not None:  # its curvature goes in steps
            return self.rod.curve
        return editable_curve(self.rod)

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
        >>> from elastica_cad.forming.nearest_search import nearest_rod
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
            return sentences([note(self.status.value), self.message], " ")
        far = note("The rod leaves the drawn curve by {far} at most.", far=Length(self.deviation))
        return sentences([note(self.status.value), far], " ")

    def __str__(self) -> str:
        return sentences((self.verdict, *self.advice), " ")


_MOST_CHANGES = 4  # things that bind, each solved again; more supports than that are no help either
_SLIGHT_DIAGONALS = 1e-3  # distances below this are not worth advice
_NEAR_DIAGONALS = 0.01  # and below this not worth supports
_NEGLIGIBLE = 0.01  # of the distance: savings not worth a sentence
_CURVATURE_SAMPLES = 501  # of the drawn curve, where its largest curvature is compared with the limit
_MISSED = 1e-4  # limits broken by less are what the search left open, not what it failed on
_IN_LENGTHS = ("end position", "points", "keep-out")


@dataclass(frozen=True)
class _Looser:
    """A change of the present limits, and a sentence for it."""

    words: str
    limits: Limits
    keep: Keep


@dataclass(frozen=True)
class _Change:
    """One thing that binds: without it, and with ever looser values of it."""

    without: _Looser
    steps: tuple[_Looser, ...] = ()
    kept: bool = False


def advise(near: NearestRod) -> Iterator[str]:
    """Sentences to the designer, the most useful first, each computed when it is asked for.

    Distances come from solving again with one limit relaxed or one thing freed, all else as asked. Only where
    the looser problem ends in a worse valley does the multiplier of the limit speak, and the sentence says so.
    """
    if near.found is None:
        return
    if near.ties:
        yield note(
            "Rods of another shape are as near, but for 2 % ({count} of them): look at `ties`, and draw the "
            "curve closer to the one you mean.",
            count=len(near.ties),
        )
    if near.status is Status.NOT_MET:
        yield from _ways_out(near)
    elif near.distance > _SLIGHT_DIAGONALS * _diagonal(near):
        yield from _costs(near)
    yield from _supports(near)


def _costs(near: NearestRod) -> Iterator[str]:
    """Sentences about the cost of limits and of what is kept."""
    largest = near.measure == "max"
    for binding, change in _changes(near):
        free = near.relaxed(change.without.limits, change.without.keep)
        cost = near.distance - free.distance
        if free.met and 0 <= cost < _NEGLIGIBLE * near.distance:
            continue
        if not free.met or cost < 0:
            if binding.limit is not None and not change.kept:
                yield note(
                    "{limit} of {bound:.3g} costs {cost:.3g} of largest distance per unit (its multiplier: "
                    "true of small changes)." if largest else
                    "{limit} of {bound:.3g} costs {cost:.3g} of mean distance per unit (its multiplier: "
                    "true of small changes).",
                    limit=_capitalize(change.without.words), bound=binding.limit, cost=Length(binding.cost),
                )  # fmt: skip
            continue
        if change.kept:
            yield note(
                "Free {kept}: that saves {cost:.3g} of largest distance." if largest else
                "Free {kept}: that saves {cost:.3g} of mean distance.",
                kept=note(change.without.words), cost=Length(cost),
            )  # fmt: skip
            continue
        said = note(
            "{limit} costs {cost:.3g} of largest distance" if largest else "{limit} costs {cost:.3g} of "
            "mean distance",
            limit=_capitalize(change.without.words), cost=Length(cost),
        )  # fmt: skip
        less = None
        if change.steps:
            step = change.steps[0]
            less = near.relaxed(step.limits, step.keep)
        if less is None or not (less.met and less.distance < near.distance):
            yield note("{costs}.", costs=said)
            continue
        would = Length(max(0.0, less.distance - free.distance))
        yield note("{costs}; {looser} would cost {cost}.", costs=said, looser=step.words, cost=would)


def _ways_out(near: NearestRod) -> Iterator[str]:
    """Sentences about limits that are not met, and changes that would make the others possible."""
    for binding in near.binding:
        if binding.broken > _MISSED:
            yield _missed(near, binding)
    found = False
    for _, change in _changes(near):
        free = near.relaxed(change.without.limits, change.without.keep)
        if not free.met:
            continue
        found = True
        tried = ((step, near.relaxed(step.limits, step.keep)) for step in change.steps)
        way, other = next((pair for pair in tried if pair[1].met), (change.without, free))
        yield note(
            "Free {way}: all limits are met, {far} from the drawn curve at most." if change.kept else
            "Without {way} all limits are met, {far} from the drawn curve at most." if way is change.without else
            "{limit} at {way}: all limits are met, {far} from the drawn curve at most.",
            way=note(way.words), far=Length(other.deviation), limit=_capitalize(change.without.words),
        )  # fmt: skip
    if not found:
        yield note("No single one of the limits that bind is to blame: relax several.")


def _supports(near: NearestRod) -> Iterator[str]:
    """Sentences about supports with which the drawn curve itself can be made."""
    rod, target, bent = near.rod, near.target, near.limits.largest_curvature
    if (
        rod.gravity is not None
        or np.any(rod.natural_curvature)
        or near.deviation < _NEAR_DIAGONALS * _diagonal(near)
    ):
        return
    if bent is not None and np.abs(target.sample(_CURVATURE_SAMPLES).curvature).max() > bent:
        return  # pieces that follow the drawn curve would be bent too much as well
    try:
        if near.status is Status.MET and check_equilibrium(target, rod.supports).realizable:
            return
        limited = near.limits.ratio is not None or near.limits.width is not None
        ratio = near.limits.largest_ratio if limited else None
        found = split(target, ratio=ratio, supports=rod.supports)
    except ElasticaError:
        return
    if 0 < len(found.supports) <= _MOST_CHANGES:
        yield str(found)


def _changes(near: NearestRod) -> Iterator[tuple[Binding, _Change]]:
    """Active limits with a possible change of each, the most expensive first."""
    left = _MOST_CHANGES
    for binding in near.binding:
        maker = _CHANGES.get(binding.name)
        change = None if maker is None else maker(near)
        if change is not None and left:
            left -= 1
            yield binding, change


def _ratio(near: NearestRod) -> _Change | None:
    limits, keep = near.limits, near.keep
    if limits.ratio is None and limits.width is None:
        return None
    ratio = limits.largest_ratio
    name = "the ratio limit" if limits.ratio == ratio else "the ratio of the widths"
    steps = [
        _Looser(
            note("{more:g} instead of {ratio:.3g}", more=more, ratio=ratio),
            replace(limits, ratio=more, width=None),
            keep,
        )
        for more in _multiples(ratio, 1.2, 1.6, 2.5)
    ]
    return _Change(_Looser(name, replace(limits, ratio=None, width=None), keep), tuple(steps))


def _margin(near: NearestRod) -> _Change | None:
    limits, keep, margin = near.limits, near.keep, near.limits.margin
    if margin is None:
        return None
    steps = [
        _Looser(
            note("{less:g} instead of {margin:.3g}", less=less, margin=margin),
            replace(limits, margin=less),
            keep,
        )
        for less in (_multiples(margin, 0.8, 0.5, 0.2) if margin > 0 else ())
    ]
    return _Change(_Looser("the stability margin", replace(limits, margin=None), keep), tuple(steps))


def _curvature(near: NearestRod) -> _Change | None:
    limits, keep, most = near.limits, near.keep, near.limits.largest_curvature
    if most is None:
        return None
    name = "the curvature limit" if limits.curvature == most else "the sheet's strain limit"
    steps = [
        _Looser(
            note(
                "a least radius of {radius:g} instead of {most}", radius=Length(radius), most=Length(1 / most)
            ),
            replace(limits, curvature=1 / radius, sheet=None, strain=None),
            keep,
        )
        for radius in _multiples(1 / most, 0.8, 0.6, 0.4)
    ]
    free = replace(limits, curvature=None, sheet=None, strain=None)
    return _Change(_Looser(name, free, keep), tuple(steps))


def _length(near: NearestRod) -> _Change | None:
    limits, keep = near.limits, near.keep
    if keep.length:
        return _freed(near, "the length", length=False)
    if limits.length is None:
        return None
    low, high = limits.length
    short = abs(near.rod.length - low) < abs(near.rod.length - high)
    bound, factors = (low, (0.98, 0.9)) if short else (high, (1.02, 1.1))
    steps = [
        _Looser(
            note("{more:.4g} instead of {bound:.4g}", more=Length(more), bound=Length(bound)),
            replace(limits, length=(more, high) if short else (low, more)),
            keep,
        )
        for more in _multiples(bound, *factors, digits=4)
    ]
    return _Change(_Looser("the range of lengths", replace(limits, length=None), keep), tuple(steps))


def _tangent(near: NearestRod, index: int) -> _Change | None:
    start, end = near.keep.both_tangents
    if not (start, end)[index]:
        return None
    if near.keep.symmetry:
        return _freed(near, "both ends' angles", tangents=False)
    kept = (False, end) if index == 0 else (start, False)
    return _freed(near, note("the {side} end's angle", side=note(_side(near, index))), tangents=kept)


def _all_of(near: NearestRod, words: str, **limits: Any) -> _Change:
    return _Change(_Looser(words, replace(near.limits, **limits), near.keep))


def _freed(near: NearestRod, words: str, **keep: Any) -> _Change:
    return _Change(_Looser(words, near.limits, replace(near.keep, **keep)), kept=True)


_CHANGES: dict[str, Callable[[NearestRod], _Change | None]] = {
    "ratio": _ratio,
    "margin": _margin,
    "curvature": _curvature,
    "length": _length,
    "start tangent": lambda near: _tangent(near, 0),
    "end tangent": lambda near: _tangent(near, 1),
    "keep-out": lambda near: _all_of(near, "the keep-out regions", keep_out=()),
    "stiffness bounds": lambda near: _all_of(near, "the stiffness bounds", stiffness_bounds=None),
    "points": lambda near: _freed(near, "the kept points", points=()),
    "inflection line": lambda near: _freed(near, "the inflection line", line=None),
    "symmetry": lambda near: _freed(near, "the symmetry", symmetry=None),
}


def _missed(near: NearestRod, binding: Binding) -> str:
    """Sentence about a limit that is not met, with the value that the rod has."""
    if binding.name == "margin" and binding.limit is not None:
        found = stability(near.rod)
        return note(
            "The stability margin of {limit:.3g} is missed: this rod has {margin:.3g} ({word}).",
            limit=binding.limit, margin=found.margin, word=note(found.word),
        )  # fmt: skip
    if binding.name == "curvature" and binding.limit is not None:
        radius = Length(1 / float(np.abs(near.rod.curvature).max()))
        least = Length(1 / binding.limit)
        return note(
            "The least radius of {least} is missed: this rod has {radius}.", least=least, radius=radius
        )
    missed = note(binding.name)
    if binding.name in _IN_LENGTHS:
        by = Length(binding.broken * near.target.length)
        return note("Missed: the {missed}, by {by}.", missed=missed, by=by)
    if binding.name == "end tangent":
        angle = np.degrees(binding.broken)
        return note("Missed: the {missed}, by {angle:.3g} degrees.", missed=missed, angle=angle)
    return note("Missed: the {missed}.", missed=missed)


def _side(near: NearestRod, index: int) -> str:
    """The end's name as the designer sees it."""
    ends = near.target.evaluate(np.array(near.target.domain))
    off = ends[index] - ends[1 - index]
    across = 0 if abs(off[0]) >= abs(off[1]) else 1
    if abs(off[across]) < 1e-3 * _diagonal(near):
        return ("first", "last")[index]
    return (("left", "right"), ("lower", "upper"))[across][int(off[across] > 0)]


def _diagonal(near: NearestRod) -> float:
    lower, upper = near.target.bounds
    return float(np.hypot(*(np.asarray(upper) - np.asarray(lower))))


def _multiples(value: float, *factors: float, digits: int = 3) -> tuple[float, ...]:
    """Multiples with few digits, for a reader."""
    return tuple(float(f"{value * factor:.{digits}g}") for factor in factors)


def _capitalize(sentence: str) -> str:
    return note(sentence[:1].upper() + sentence[1:])
