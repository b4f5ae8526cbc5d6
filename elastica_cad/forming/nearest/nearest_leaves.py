"""The nearest stack of glued leaves: tapers are sought, and leaves laid to come near them within the limits."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.forming.leaf_ends import LeafedRod, lay_leaves, leaf_bends
from elastica_cad.forming.limits import MET, Keep, Limits
from elastica_cad.forming.nearest.advice import advise
from elastica_cad.forming.nearest.curve_distance import measure_deviation
from elastica_cad.forming.nearest.nearest_record import Binding, NearestRod, judge_search
from elastica_cad.forming.nearest.rod_search import find_rod
from elastica_cad.forming.nearest.target_curve import TargetCurve
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.material.tapered_sections import LeavesLaw
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.stability_verdict import stability
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

_STRICTER = 6  # tapers at most, each within stricter limits, from which leaves are laid
_BEYOND = 1.2  # times what a stack breaks of a limit is asked of the next taper
_WHOLE = 1e-9  # of a leaf: more than rounding


def find_leaves(
    curve: PlaneCurve,
    limits: Limits,
    keep: Keep,
    law: LeavesLaw,
    *,
    gravity: Gravity | None,
    again: Callable[..., NearestRod],
    **asked: Any,
) -> NearestRod:
    """A stack of glued leaves near the nearest taper; where a step breaks a limit, that of a stricter taper."""
    if limits.stiffness_bounds is not None or keep.points or keep.symmetry or keep.line:
        raise InputError(
            "leaves keep ends, tangents and length, within ratio, margin, curvature, strain and regions: leave out "
            "stiffness_bounds, points, symmetry and line"
        )
    # (n / k)^3 is the ratio of n leaves and k
    fewest = int(np.ceil(law.leaves / limits.largest_ratio ** (1 / 3) - _WHOLE))
    law = replace(law, fewest=min(max(law.fewest, fewest), law.leaves))
    laid, steps = None, 0
    taper = _taper_on_curve(curve, limits, gravity, law, asked)
    if taper is not None:
        laid = lay_leaves(taper, law, tangents=keep.both_tangents)
    strict = limits
    for _ in range(_STRICTER):
        if laid is not None and not _broken_by(laid, limits):
            break
        near = find_rod(curve, strict, keep, law.relaxed, gravity=gravity, again=again, grown=False, **asked)
        steps += near.iterations
        laid = lay_leaves(near.rod, law, tangents=keep.both_tangents)
        strict = _stricter(strict, _broken_by(laid, limits))
    assert laid is not None
    broken = _broken_by(laid, limits)
    missed = max((binding.broken for binding in broken), default=0.0)
    target = TargetCurve.of(curve)
    position = (laid.rod.position - target.origin) / target.size
    deviation = measure_deviation(target, position) * target.size
    drawn = curve.sample(laid.rod.s.size).position
    mean = float(np.sqrt(((laid.rod.position - drawn) ** 2).sum(axis=1).mean()))
    return NearestRod(
        found=laid.rod, target=curve, deviation=deviation, mean_deviation=mean,
        status=judge_search(missed, deviation / (target.diagonal * target.size), laid.settled),
        binding=broken, violation=missed, iterations=steps, limits=limits, keep=keep,
        measure=asked["measure"], distance=mean, advise=advise,
        again=partial(again, curve, gravity=gravity, section=law, **asked),
    )  # fmt: skip


def _taper_on_curve(
    curve: PlaneCurve, limits: Limits, gravity: Gravity | None, law: LeavesLaw, asked: dict[str, Any]
) -> Rod | None:
    """The taper that rests in the curve itself, as thick as the stack may be, where there is one."""
    if limits.length is not None and not limits.length[0] <= curve.length <= limits.length[1]:
        return None
    try:
        return optimal_rod(curve, gravity, asked["supports"], asked["natural_curvature"], section=law.relaxed)
    except ElasticaError:
        return None


def _broken_by(laid: LeafedRod, limits: Limits) -> tuple[Binding, ...]:
    """The limits that a stack breaks, and by how much, in shares of each."""
    rod = laid.rod
    s, bend = leaf_bends(rod, laid.section)
    shares: dict[str, tuple[float | None, float]] = {}
    if limits.margin is not None:
        scale = max(10.0, abs(limits.margin))
        shares["margin"] = limits.margin, (limits.margin - stability(rod).margin) / scale
    if limits.curvature is not None:
        shares["curvature"] = limits.curvature, float(bend.max()) / limits.curvature - 1
    if limits.sheet is not None:
        (strain,) = laid.section.strains(bend, laid.section.sheet.thickness * laid.section.counts(s))
        shares["strain"] = None, strain.largest / (limits.strain or strain.limit) - 1
    if limits.keep_out:
        inside = -min(float(region.clearance(rod.position)[0][1:-1].min()) for region in limits.keep_out)
        shares["keep-out"] = None, inside / rod.length
    return tuple(Binding(name, limit, 0.0, over) for name, (limit, over) in shares.items() if over > MET)


def _stricter(limits: Limits, broken: tuple[Binding, ...]) -> Limits:
    """Limits for the taper, of which a stack then breaks less."""
    for one in broken:
        more = 1 + _BEYOND * one.broken
        if one.name == "margin":
            scale = max(10.0, abs(one.limit or 0.0))
            limits = replace(limits, margin=(limits.margin or 0.0) + _BEYOND * one.broken * scale)
        elif one.name == "curvature":
            limits = limits.tightened(curvature=more)
        elif one.name == "strain":
            limits = limits.tightened(strain=more)
    return limits
