"""What binds, in words: what each limit costs, and what could be done about it."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from elastica_cad.errors import ElasticaError
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import Binding, NearestRod, Status
from elastica_cad.forming.splitting import split
from elastica_cad.mechanics.stability.stability_verdict import stability
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

_MOST_CHANGES = 4  # things that bind, each solved again; more supports than that are no help either
_SLIGHT_DIAGONALS = 1e-3  # distances below this are not worth advice
_NEAR_DIAGONALS = 0.01  # and below this not worth supports
_NEGLIGIBLE = 0.01  # of the distance: savings not worth a sentence
_CURVATURE_SAMPLES = 501  # of the drawn curve, where its largest curvature is compared with the limit
_MISSED = 1e-4  # limits broken by less are what the search left open, not what it failed on
_IN_LENGTHS = ("end position", "points", "keep-out")


@dataclass(frozen=True)
class _Looser:
    """What might be asked instead of the present limits, and how that is said."""

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
        yield (
            f"Rods of another shape are as near, but for 2 % ({len(near.ties)} of them): look at `ties`, and draw "
            "the curve closer to the one you mean."
        )
    if near.status is Status.NOT_MET:
        yield from _ways_out(near)
    elif near.distance > _SLIGHT_DIAGONALS * _diagonal(near):
        yield from _costs(near)
    yield from _supports(near)


def _costs(near: NearestRod) -> Iterator[str]:
    """What limits cost, and what is saved by freeing what is kept."""
    unit = f"mm of {'largest' if near.measure == 'max' else 'mean'} distance"
    for binding, change in _changes(near):
        free = near.relaxed(change.without.limits, change.without.keep)
        cost = near.distance - free.distance
        if free.met and 0 <= cost < _NEGLIGIBLE * near.distance:
            continue
        if not free.met or cost < 0:
            if binding.limit is not None and not change.kept:
                yield (
                    f"{_capitalize(change.without.words)} of {binding.limit:.4g} costs {binding.cost:.3g} {unit} "
                    "per unit (its multiplier: true of small changes)."
                )
            continue
        if change.kept:
            yield f"Free {change.without.words}: that saves {cost:.3g} {unit}."
            continue
        said = f"{_capitalize(change.without.words)} costs {cost:.3g} {unit}"
        if change.steps:
            step = change.steps[0]
            less = near.relaxed(step.limits, step.keep)
            if less.met and less.distance < near.distance:
                said += f"; {step.words} would cost {max(0.0, less.distance - free.distance):.3g} mm"
        yield said + "."


def _ways_out(near: NearestRod) -> Iterator[str]:
    """What is missed, and what alone would make the rest possible."""
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
        end = f"all limits are met, {other.deviation:.3g} mm from the drawn curve at most."
        if change.kept:
            yield f"Free {way.words}: {end}"
        elif way is change.without:
            yield f"Without {way.words} {end}"
        else:
            yield f"{_capitalize(change.without.words)} at {way.words}: {end}"
    if not found:
        yield "No single one of the limits that bind is to blame: relax several."


def _supports(near: NearestRod) -> Iterator[str]:
    """Where supports would make strips of the drawn curve itself."""
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
    """What was asked for and binds, the dearest first."""
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
        _Looser(f"{more:g} instead of {ratio:.3g}", replace(limits, ratio=more, width=None), keep)
        for more in _multiples(ratio, 1.2, 1.6, 2.5)
    ]
    return _Change(_Looser(name, replace(limits, ratio=None, width=None), keep), tuple(steps))


def _margin(near: NearestRod) -> _Change | None:
    limits, keep, margin = near.limits, near.keep, near.limits.margin
    if margin is None:
        return None
    steps = [
        _Looser(f"{less:g} instead of {margin:.3g}", replace(limits, margin=less), keep)
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
            f"a least radius of {radius:g} instead of {1 / most:.3g} mm",
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
            f"{more:g} instead of {bound:.4g} mm",
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
    return _freed(near, f"the {_side(near, index)} end's angle", tangents=kept)


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
    """What is broken, and what the rod has instead."""
    if binding.name == "margin" and binding.limit is not None:
        found = stability(near.rod)
        has = f"{found.margin:.3g} ({found.word})"
        return f"The stability margin of {binding.limit:.3g} is missed: this rod has {has}."
    if binding.name == "curvature" and binding.limit is not None:
        radius = 1 / float(np.abs(near.rod.curvature).max())
        return f"The least radius of {1 / binding.limit:.3g} mm is missed: this rod has {radius:.3g} mm."
    if binding.name in _IN_LENGTHS:
        return f"Missed: the {binding.name}, by {binding.broken * near.target.length:.3g} mm."
    if binding.name == "end tangent":
        return f"Missed: the {binding.name}, by {np.degrees(binding.broken):.3g} degrees."
    return f"Missed: the {binding.name}."


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
    return sentence[:1].upper() + sentence[1:]
