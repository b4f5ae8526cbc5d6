"""What the overlay shows of a curve, as plain points in the plane of the sketch: no window needed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from freecad.elastica_wb.design import Wish

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication import Strip
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import EquilibriumCheck, NotRealizable, check_equilibrium
from elastica_cad.mechanics.equilibrium import examine_curvature

__all__ = ["Picture", "comb_scale", "curve_picture", "sentence_of", "width_lines"]

TEETH = 81
COMB_HEIGHT = 0.2  # of the curve's extent
LINE_MARGIN = 0.15
ON_LINE = 1e-4  # of the length: what `check_equilibrium` puts right by itself


@dataclass(frozen=True, eq=False)
class Picture:
    """Lines and marks of the overlay, mm in the sketch's plane.

    Attributes
    ----------
    comb : tuple of (n, 2) arrays
        Curvature comb: its rim, then its teeth.
    line : (2, 2) array or None
        The inflection line inside the neighbourhood of the curve.
    on_line, off_line : (k, 2) arrays
        Inflections on the line and off it.
    distances : tuple of ((x, y), text)
        How far those off it are.
    crossings : (k, 2) array
        Where the line meets the curve and must not.
    realizable : bool or None
        None where only the solver can tell (with weight).
    sentence : str
        One sentence of advice.
    """

    comb: tuple[FloatArray, ...]
    line: FloatArray | None
    on_line: FloatArray
    off_line: FloatArray
    distances: tuple[tuple[tuple[float, float], str], ...]
    crossings: FloatArray
    realizable: bool | None
    sentence: str


def curve_picture(curve: PlaneCurve, wish: Wish, scale: float | None = None) -> Picture:
    """Curvature, inflections and their line; `scale` is the comb's, mm for 1/mm."""
    samples = curve.sample(TEETH)
    comb = _comb(samples.position, samples.angle, samples.curvature, scale or comb_scale(curve))
    try:
        if wish.gravity is None:
            check = check_equilibrium(curve, wish.supports, wish.natural_curvature)
        else:
            check = examine_curvature(curve, wish.supports, wish.natural_curvature)
    except ElasticaError as error:
        nothing = np.zeros((0, 2))
        return Picture(comb, None, nothing, nothing, (), nothing, False, str(error))
    realizable = None if wish.gravity is not None and check.realizable else check.realizable
    places = dict(check.off_line) or dict.fromkeys(check.inflections, 0.0)
    good = [s for s, d in places.items() if abs(d) <= ON_LINE * check.length]
    bad = [s for s in places if s not in good]
    off = _at(curve, bad)
    texts = tuple(
        ((float(x), float(y)), f"{abs(places[s]):.3g} mm") for s, (x, y) in zip(bad, off, strict=True)
    )
    return Picture(
        comb=comb,
        line=None if check.line is None else _inside(check, samples.position),
        on_line=_at(curve, good),
        off_line=off,
        distances=texts,
        crossings=_at(curve, (*check.crossings, *check.touches)),
        realizable=realizable,
        sentence=sentence_of(check),
    )


def comb_scale(curve: PlaneCurve) -> float:
    """mm that the comb draws for a curvature of 1/mm."""
    samples = curve.sample(TEETH)
    largest = float(np.abs(samples.curvature).max())
    extent = float(np.ptp(samples.position, axis=0).max())
    return COMB_HEIGHT * extent / largest if largest > 1e-12 / extent else 0.0


def width_lines(strip: Strip, count: int = 161) -> tuple[FloatArray, ...]:
    """Both edges of the strip, laid flat into the plane along its curve."""
    samples = strip.rod.curve.sample(count)
    aside = np.column_stack([-np.sin(samples.angle), np.cos(samples.angle)])
    half = strip.width(samples.s * (strip.width.length / samples.s[-1]))[:, None] / 2
    return samples.position + half * aside, samples.position - half * aside


def sentence_of(answer: EquilibriumCheck | Strip | ElasticaError) -> str:
    """One sentence for the status bar."""
    if isinstance(answer, Strip):
        low, high = answer.width.extremes
        used = 100 * answer.max_strain / answer.sheet.max_strain
        return (
            f"A flat strip takes this curve: {low:.3g} to {high:.3g} mm wide, stiffness ratio "
            f"{answer.rod.ratio:.3g}, strain {used:.0f} % of what the sheet bears."
        )
    if isinstance(answer, NotRealizable):
        return answer.check.reasons[0]
    if isinstance(answer, ElasticaError):
        return str(answer)
    return answer.reasons[0] if answer.reasons else str(answer).split(". ")[0].rstrip(".") + "."


def _comb(
    position: FloatArray, angle: FloatArray, curvature: FloatArray, scale: float
) -> tuple[FloatArray, ...]:
    """On the outer side of the bend, as FreeCAD's own combs are."""
    tips = position - scale * curvature[:, None] * np.column_stack([-np.sin(angle), np.cos(angle)])
    return tips, *np.stack([position, tips], axis=1)


def _at(curve: PlaneCurve, places: Sequence[float]) -> FloatArray:
    if not len(places):
        return np.zeros((0, 2))
    return np.asarray(curve.at(np.array(places)).position)


def _inside(check: EquilibriumCheck, points: FloatArray) -> FloatArray:
    """The piece of the inflection line along the curve, a little longer than the curve's shadow on it."""
    along, start = np.asarray(check.line.direction), np.asarray(check.line.point)
    shadow = (points - start) @ along
    margin = LINE_MARGIN * float(np.ptp(points, axis=0).max())
    return start + np.array([[shadow.min() - margin], [shadow.max() + margin]]) * along
