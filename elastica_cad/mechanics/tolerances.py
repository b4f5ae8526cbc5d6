"""Deviation of real strips from their design, by imperfections within tolerances."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice, product
from typing import NamedTuple

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_whole, numbers, require_executor, require_positive, require_record
from elastica_cad.errors import InputError, Length, NotConvergedError, quoted
from elastica_cad.geometry.plane_points import norm
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend, dead_loads, has_snapped, system_of
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.moment_curvature import PlasticLaw
from elastica_cad.mechanics.rod import CurlingLaw, Rod
from elastica_cad.mechanics.sections import SheetCurl
from elastica_cad.mechanics.sheets import Range, Sheet

ROUNDED_SHARE = 1e-9
"""Loads at a free end up to this fraction of the largest force or moment in the rod count as 0."""


@dataclass(frozen=True)
class Imperfection:
    """Differences between a real strip and its design; the default values mean no difference.

    Attributes
    ----------
    stiffness_range : float
        Factor m that changes the relative stiffness K to 1 + (K - 1) m, and so the stiffness ratio.
    youngs_modulus, density, thickness : float
        Factors on Young's modulus E, density rho and thickness h of the sheet. Under weight the shape depends on
        E h^2 / rho, and under a force or moment on a free end on E h^3. For a wide strip, the thickness also
        changes the plate effect.
    start_angle, end_angle : float
        Changes of the held angles, rad.
    yield_curvature : float
        Largest elastic change of curvature, 1/mm; the change beyond it is permanent (ideal plasticity, paper,
        Appendix D).
    width_loss : float
        Loss of width along the whole strip, mm, in addition to the compensated kerf. It is negative for a strip
        that is too wide.
    thickness_wave, wave_phase : float
        Amplitude of a wave of the thickness, as a fraction of the thickness, and its phase at the start, rad. The
        wave has one period over the length.
    """

    stiffness_range: float = 1.0
    youngs_modulus: float = 1.0
    density: float = 1.0
    thickness: float = 1.0
    start_angle: float = 0.0
    end_angle: float = 0.0
    yield_curvature: float = np.inf
    width_loss: float = 0.0
    thickness_wave: float = 0.0
    wave_phase: float = 0.0


def perturb_rod(rod: Rod, imperfection: Imperfection, *, max_width: float | None = None) -> Rod:
    """Return the rest shape of a strip that differs from its design.

    Parameters
    ----------
    rod : Rod
        Designed rod in equilibrium.
    imperfection : Imperfection
    max_width : float, optional
        Largest width of the strip, mm; it is needed only for a loss of width.

    Raises
    ------
    NotConvergedError
        No rest shape is found.
    """
    require_record(rod, Rod, "the rod", "a Rod, as bend makes one")
    require_record(imperfection, Imperfection, "the imperfection", "an Imperfection")
    require_free_between(rod, "A tolerance study")
    v, rod = imperfection, rod.following()
    changed, B = _as_cut(rod, v, max_width)
    limit = v.yield_curvature / v.thickness
    bend_here = rod.curvature - rod.natural_curvature
    if (np.abs(bend_here) > limit).any():
        rest = rod.natural_curvature + PlasticLaw(limit).permanent_curvature(bend_here)
        law = changed.law
        changed = replace(
            changed, natural_curvature=rest,
            law=replace(law, natural_curvature=rest) if isinstance(law, CurlingLaw) else law,
        )  # fmt: skip
    start, end = (
        float(angle) + delta if support.angle else None
        for angle, delta, support in zip(
            rod.angle[[0, -1]], (v.start_angle, v.end_angle), rod.supports.ends, strict=True
        )
    )
    # divide loads on free ends by the changed stiffness, because their values in newtons do not change
    force, moment = dead_loads(rod, 1 / (v.youngs_modulus * v.thickness**3 * B))
    return bend(changed, angles=(start, end), force=force, moment=moment)


def feels_modulus(rod: Rod) -> bool:
    """Return True if the shape depends on Young's modulus, which is the case only under loads."""
    loads = system_of(rod, rod)
    pulls = np.abs(loads.force).max() > ROUNDED_SHARE * np.abs(rod.force).max()
    turns = np.abs(loads.moments).max() > ROUNDED_SHARE * np.abs(rod.moment).max()
    return bool(pulls or turns or loads.load.any())


def least_width(rod: Rod, max_width: float | None, loss: float) -> float:
    """Return the least width of the strip, mm; refuse a `loss` of width that is at least as large."""
    if max_width is None:
        raise InputError(
            "the effect of a loss of width depends on the width, which is unknown: set `max_width`, in mm"
        )
    require_positive(max_width, "max_width")
    plate = _plate_of(rod.following())
    least = max_width / float(rod.stiffness.max()) if plate is None else float(plate[1].width.min())
    if loss >= least:
        raise InputError(
            "a loss of width of {loss:g} is more than the least width, {least:.4g}: use a smaller loss or a "
            "larger `max_width`",
            loss=Length(loss),
            least=Length(least),
        )
    return least


def _plate_of(rod: Rod) -> tuple[CurlingLaw, SheetCurl] | None:
    # the law, and its effect of bending, of a strip that bends as a plate
    law = rod.law
    if rod.follows_bend and isinstance(law, CurlingLaw) and isinstance(law.factor, SheetCurl):
        return law, law.factor
    return None


def _as_cut(rod: Rod, v: Imperfection, max_width: float | None) -> tuple[Rod, float]:
    """Return the rod as it was cut, and the factor by which its least stiffness changed."""
    K = 1 + (rod.stiffness - 1) * v.stiffness_range
    loss = v.width_loss and v.width_loss / least_width(rod, max_width, v.width_loss)
    plate = _plate_of(rod)
    wave = (1 + v.thickness_wave * np.cos(2 * np.pi * rod.s / rod.length + v.wave_phase)) ** 3
    if plate is not None:
        return _plate_as_cut(rod, *plate, K * wave / rod.stiffness, v)
    # `loss` is a fraction of the least width, where K is 1
    K = (K - loss) / (1 - loss) * wave
    # the wave may also raise the least stiffness
    low = float(K.min()) if v.thickness_wave else 1.0
    B = (1 - loss) * low
    return _with_weight(_stiffened(rod, K / low), v, B), B


def _plate_as_cut(
    rod: Rod, law: CurlingLaw, curl: SheetCurl, stiffer: FloatArray, v: Imperfection
) -> tuple[Rod, float]:
    """Return the result of `_as_cut` for a strip that bends as a plate. `stiffer` (n,) multiplies the stiffness."""
    kappa = rod.curvature
    stiffened = curl if np.all(stiffer == 1) else curl.stiffened(stiffer, kappa)
    cut = replace(stiffened, width=stiffened.width - v.width_loss, thickness=curl.thickness * v.thickness)
    narrower, here = cut.width / curl.width, cut(kappa)
    K = rod.stiffness * narrower * here / law.designed
    B = float(K.min())
    changed = _with_weight(replace(_stiffened(rod, K), law=replace(law, factor=cut, designed=here)), v, B)
    if rod.weight is not None and rod.gravity is not None:
        alpha, beta = rod.weight.along(rod.s)
        newtons = v.density * v.thickness * narrower * (alpha + beta * rod.stiffness)
        weight = replace(rod.weight, alpha=Profile.interpolate(rod.s, newtons), beta=0.0)
        changed = replace(changed, weight=weight)
    return changed, B


def _stiffened(rod: Rod, K: FloatArray) -> Rod:
    return rod.with_stiffness(K) if np.any(rod.stiffness != K) else rod


def _with_weight(rod: Rod, v: Imperfection, width_factor: float) -> Rod:
    """Return the rod with the weight, and the stiffness that this weight bends, of the imperfect sheet.

    Without a `weight`, gravity acts through the elasto-gravity length, which does not depend on the width.
    """
    if rod.gravity is None:
        return rod
    if rod.weight is None:
        factor = v.density / (v.youngs_modulus * v.thickness**2)
        return rod if factor == 1 else replace(rod, gravity=rod.gravity.scaled(factor))
    heavier = v.density * v.thickness
    weight = rod.weight.scaled(heavier, heavier * width_factor)
    B = (rod.bending_stiffness or 0.0) * v.youngs_modulus * v.thickness**3 * width_factor
    return replace(rod, weight=weight, bending_stiffness=B)


MOST_SAMPLES = 100_000

SIGNED = ("angle", "width_loss", "thickness_wave", "wave_phase")
"""Ranges that may contain negative values."""


@dataclass(frozen=True)
class ToleranceRanges:
    """Ranges of all varied quantities, which `Imperfection` describes.

    Parameters
    ----------
    stiffness_range : (low, high)
        Factors m on K - 1, where K is the relative stiffness.
    youngs_modulus, density, thickness : (low, high)
        Factors on the values of the sheet.
    angle : (low, high)
        Changes of the held angles, rad, independent for each end.
    yield_curvature : (low, high)
        Largest elastic change of curvature, 1/mm, for the design thickness.
    width_loss : (low, high)
        Loss of width, mm.
    thickness_wave, wave_phase : (low, high)
        Amplitude, as a fraction, and phase, rad, of a wave of the thickness along the strip.
    """

    stiffness_range: Range = (0.9, 1.1)
    youngs_modulus: Range = (0.9, 1.1)
    density: Range = (0.95, 1.05)
    thickness: Range = (0.95, 1.05)
    angle: Range = (-0.035, 0.035)
    yield_curvature: Range = (np.inf, np.inf)
    width_loss: Range = (0.0, 0.0)
    thickness_wave: Range = (-0.01, 0.01)
    wave_phase: Range = (0.0, float(np.pi))

    def __post_init__(self) -> None:
        for name, limits in vars(self).items():
            pair = numbers(limits, f"the range of {name}")
            if pair.shape != (2,):
                raise InputError(f"range of {name} is {limits!r}: give the lowest and the highest")
            low, high = pair.tolist()
            if not low <= high:
                raise InputError(f"range of {name} is {low:g} to {high:g}: give the lowest first")
            if name not in SIGNED and low <= 0:
                raise InputError(f"range of {name} begins at {low:g}: give numbers above 0")
            if name in SIGNED and not np.isfinite([low, high]).all():
                raise InputError(f"range of {name} is {low:g} to {high:g}: give finite numbers")

    @classmethod
    def of(
        cls, sheet: Sheet, *, stiffness_range: Range = (0.9, 1.1), angle: Range = (-0.035, 0.035)
    ) -> "ToleranceRanges":
        """Return the ranges of a sheet; a quantity without a range does not vary.

        Parameters
        ----------
        sheet : Sheet
            Sheet with ranges. The kerf is compensated, so only deviations from it change the width.
        stiffness_range, angle : (low, high)
            Ranges of quantities that are not properties of a sheet.
        """

        sheet = Sheet.of(sheet)

        def factors(quantity: str) -> Range:
            low, high = sheet.range_of(quantity)
            value = float(getattr(sheet, quantity))
            return low / value, high / value

        low_strain, high_strain = sheet.range_of("max_strain")
        low_kerf, high_kerf = sheet.range_of("kerf")
        return cls(
            stiffness_range=stiffness_range,
            **{name: factors(name) for name in ("youngs_modulus", "density", "thickness")},
            angle=angle,
            yield_curvature=(2 * low_strain / sheet.thickness, 2 * high_strain / sheet.thickness),
            width_loss=(low_kerf - sheet.kerf, high_kerf - sheet.kerf),
        )


@dataclass(frozen=True)
class ToleranceEffect:
    """Deviation of the shape by one cause, or by all causes together.

    Attributes
    ----------
    name : str
        Name of the cause.
    worst : float
        Largest deviation of the samples, mm; for one cause, the extremes of its ranges are included.
    percentile_95 : float
        95th percentile of the deviations of the samples, mm.
    samples, failed, snapped : int
        Numbers of bent rods, of rods without a rest shape, and of rods that snapped to a shape far from the
        design. The deviations do not include rods without a rest shape, but include those that snapped.
    """

    name: str
    worst: float
    percentile_95: float
    samples: int
    failed: int
    snapped: int


@dataclass(frozen=True)
class ToleranceStudy:
    """Deviations by each cause and by all causes together; `str()` returns a table.

    Attributes
    ----------
    effects : tuple of ToleranceEffect
        Effects of one cause each: stiffness range, weight, end angles, plasticity, thickness, kerf, thickness
        along the strip.
    combined : ToleranceEffect
        Effect of all causes together.
    seed : int
        Seed of the random numbers.
    """

    effects: tuple[ToleranceEffect, ...]
    combined: ToleranceEffect
    seed: int

    def __getitem__(self, name: str) -> ToleranceEffect:
        for effect in self._every:
            if effect.name == name:
                return effect
        raise InputError(f"unknown effect {name!r}: use one of {', '.join(e.name for e in self._every)}")

    @property
    def failed(self) -> int:
        """Number of bent rods without a rest shape, over all causes."""
        return sum(effect.failed for effect in self._every)

    @property
    def _every(self) -> tuple[ToleranceEffect, ...]:
        return (*self.effects, self.combined)

    def __str__(self) -> str:
        lines = [f"{'deviation, mm':<26}{'95 %':>9}{'worst':>9}"]
        for effect in self._every:
            line = f"{effect.name:<26}{effect.percentile_95:>9.3f}{effect.worst:>9.3f}"
            if effect.failed:
                line += f"   {effect.failed} of {effect.samples} found no rest shape"
            if effect.snapped:
                line += f"   {effect.snapped} of {effect.samples} snapped"
            lines.append(line)
        return "\n".join(lines)


def tolerance_study(
    rod: Rod,
    *,
    sheet: Sheet | None = None,
    ranges: ToleranceRanges | None = None,
    max_width: float | None = None,
    samples: int = 100,
    seed: int = 0,
    executor: Executor | None = None,
) -> ToleranceStudy:
    """Return the deviations of real strips from the designed `rod` (paper, section 8.2 and Fig. 15).

    The method is Monte Carlo with uniform distributions, for each cause alone and then for all causes together. A
    deviation is the largest distance between a node of the varied rod and the same node of the design. A wide strip
    (`section`) bends as a plate, so its thickness has an effect even without load.

    Parameters
    ----------
    rod : Rod
        Designed rod in equilibrium.
    sheet : Sheet, optional
        Sheet whose ranges are the default.
    ranges : ToleranceRanges, optional
        Ranges that replace the ranges of `sheet`.
    max_width : float, optional
        Largest width of the strip, mm; without it the kerf is not varied.
    samples : int
        Number of rods that are bent for each cause.
    seed : int
        Seed of the random numbers; results do not depend on the executor.
    executor : concurrent.futures.Executor, optional
        Executor (threads or processes) that computes the bent rods.

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> rod = bend(Rod.straight(100.0, [1, 2, 1], samples=41), end=(70.0, 0.0))
    >>> study = tolerance_study(rod, samples=8)
    >>> study["end angles"].worst > study["end angles"].percentile_95 > 0
    True
    >>> study["weight"].worst
    0.0
    """
    require_record(rod, Rod, "the rod", "a Rod, as bend makes one")
    if not (is_whole(samples) and 1 <= samples <= MOST_SAMPLES):
        raise InputError(f"samples is {samples!r}: give a whole number from 1 to {MOST_SAMPLES}")
    if not (ranges is None or isinstance(ranges, ToleranceRanges)):
        raise InputError(f"ranges are {quoted(ranges)}: give a ToleranceRanges record, or None")
    require_executor(executor, "map")
    if not (is_whole(seed) and seed >= 0):
        raise InputError(f"seed is {seed!r}: give a whole number, 0 or more")
    varied = ranges or (ToleranceRanges.of(sheet) if sheet is not None else ToleranceRanges())
    if max_width is None:
        varied = replace(varied, width_loss=(0.0, 0.0))
    elif varied.width_loss[1] > 0:
        least_width(rod, max_width, varied.width_loss[1])
    rng = np.random.default_rng(seed)
    imperfections = {name: _drawn(varied, name, rng, samples) for name in _CAUSES}
    combined = [
        Imperfection(**{
            field: getattr(part, field)
            for part, fields in zip(parts, _CAUSES.values(), strict=True)
            for field in fields
        })
        for parts in zip(*imperfections.values(), strict=True)
    ]  # fmt: skip
    groups = [(name, drawn, _corner_imperfections(varied, name)) for name, drawn in imperfections.items()]
    groups.append(("combined", combined, []))
    todo = [v for _, inner, outer in groups for v in (*inner, *outer)]
    # imperfections that have the same effect are computed once
    effective = [_without_ineffective_changes(rod, v) for v in todo]
    different = list(dict.fromkeys(effective))
    bent = partial(_outcome, rod, max_width)
    answers = map(bent, different) if executor is None else executor.map(bent, different, chunksize=16)
    found = dict(zip(different, answers, strict=True))
    outcomes = iter([found[v] for v in effective])
    effects = [
        _effect(name, list(islice(outcomes, len(inner))), list(islice(outcomes, len(outer))))
        for name, inner, outer in groups
    ]
    return ToleranceStudy(tuple(effects[:-1]), effects[-1], seed)


class _Outcome(NamedTuple):
    """Deviation of a rest shape, mm (None without rest shape), and True if the rod snapped."""

    deviation: float | None
    snapped: bool


# varied attributes of `Imperfection` for each cause, each with the name of its range in `ToleranceRanges`
_CAUSES: dict[str, dict[str, str]] = {
    "stiffness range": {"stiffness_range": "stiffness_range"},
    "weight": {"youngs_modulus": "youngs_modulus", "density": "density"},
    "end angles": {"start_angle": "angle", "end_angle": "angle"},
    "plasticity": {"yield_curvature": "yield_curvature"},
    "thickness": {"thickness": "thickness"},
    "kerf": {"width_loss": "width_loss"},
    "thickness along the strip": {"thickness_wave": "thickness_wave", "wave_phase": "wave_phase"},
}


def _drawn(
    ranges: ToleranceRanges, cause: str, rng: "np.random.Generator", samples: int
) -> list[Imperfection]:
    fields = _CAUSES[cause]
    share = rng.random((samples, len(fields)))
    columns = [_between(getattr(ranges, source), share[:, i]) for i, source in enumerate(fields.values())]
    return [Imperfection(**dict(zip(fields, map(float, row), strict=True))) for row in np.transpose(columns)]


def _between(limits: Range, share: FloatArray) -> FloatArray:
    low, high = limits
    return np.full(share.shape, low) if low == high else low + (high - low) * share


def _corner_imperfections(ranges: ToleranceRanges, cause: str) -> list[Imperfection]:
    fields = _CAUSES[cause]
    corners = product(*(getattr(ranges, source) for source in fields.values()))
    return [Imperfection(**dict(zip(fields, corner, strict=True))) for corner in dict.fromkeys(corners)]


def _without_ineffective_changes(rod: Rod, v: Imperfection) -> Imperfection:
    """Return an imperfection without the changes that do not move the rod.

    Equal imperfections are computed once.
    """
    loaded = feels_modulus(rod)
    if not loaded:
        v = replace(v, youngs_modulus=1.0, density=1.0)
    if np.abs(rod.curvature - rod.natural_curvature).max() <= v.yield_curvature / v.thickness:
        v = replace(v, yield_curvature=np.inf)
        if not (loaded or rod.follows_bend):
            v = replace(v, thickness=1.0)
    a, b = rod.supports.ends
    return replace(
        v, start_angle=v.start_angle if a.angle else 0.0, end_angle=v.end_angle if b.angle else 0.0
    )


def _outcome(rod: Rod, max_width: float | None, imperfection: Imperfection) -> _Outcome:
    """Return the deviation, mm, of an imperfect strip, or None without rest shape, and True if it has snapped."""
    if imperfection == Imperfection():
        return _Outcome(0.0, False)
    try:
        bent = perturb_rod(rod, imperfection, max_width=max_width)
    except NotConvergedError:
        return _Outcome(None, False)
    return _Outcome(float(norm(bent.position - rod.position).max()), has_snapped(bent))


def _effect(name: str, inner: Sequence[_Outcome], outer: Sequence[_Outcome]) -> ToleranceEffect:
    # `inner` are random samples, `outer` the extremes of the ranges, which do not count in the percentile
    both = (*inner, *outer)
    good, every = (
        np.array([outcome.deviation for outcome in outcomes if outcome.deviation is not None])
        for outcomes in (inner, both)
    )
    return ToleranceEffect(
        name=name,
        worst=float(every.max()) if every.size else float("nan"),
        percentile_95=float(np.percentile(good, 95)) if good.size else float("nan"),
        samples=len(both),
        failed=len(both) - every.size,
        snapped=sum(outcome.snapped for outcome in both),
    )
