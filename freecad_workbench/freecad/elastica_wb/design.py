"""From what a user asks for to a strip: solved once for equal wishes, whoever asks."""

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import Part
from freecad.elastica_wb.patience import patiently
from freecad.elastica_wb.shapes import make_solid

from elastica_cad.errors import ElasticaError, MissingDependencyError, NotConvergedError
from elastica_cad.fabrication import BentSolid, FlatSolid, Laminated, Perforated, Plain, Strip, Tab
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest import NearestRod, nearest_rod
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, Rod, Sheet, Stability, Supports, optimal_rod, stability

__all__ = ["StyleChoice", "Wish", "bent_shape", "flat_shape", "judged", "nearest", "nearest_now", "solved"]

MANY = 100  # holes


@dataclass(frozen=True)
class _Same:
    """A curve that equals another one with the same numbers."""

    degree: int
    knots: bytes
    points: bytes
    weights: bytes | None
    curve: PlaneCurve = field(compare=False, repr=False)

    @classmethod
    def of(cls, curve: PlaneCurve) -> "_Same":
        weights = None if curve.weights is None else curve.weights.tobytes()
        return cls(curve.degree, curve.knots.tobytes(), curve.control_points.tobytes(), weights, curve)


@dataclass(frozen=True)
class StyleChoice:
    """How stiffness becomes material, in numbers that can be compared."""

    kind: str = "Plain"
    width: float = 0.0
    columns: int = 2
    rows: int | None = None
    backing: Sheet | None = None

    def style(self) -> Any:
        """The core's style."""
        if self.kind == "Perforated":
            return Perforated(width=self.width, columns=self.columns, rows=self.rows)
        if self.kind == "Laminated" and self.backing is not None:
            return Laminated(width=self.width, backing=self.backing)
        return Plain()


@dataclass(frozen=True)
class Wish:
    """Everything that a strip depends on."""

    sheet: Sheet
    max_width: float | None = None
    min_width: float | None = None
    style: StyleChoice = StyleChoice()
    supports: Supports = field(default_factory=Supports)
    gravity: Gravity | None = None
    natural_curvature: float = 0.0
    samples: int | None = None
    ends: tuple[Tab, Tab] = (Tab(10.0), Tab(10.0))
    label: str = ""
    nearest: bool = False
    ratio: float | None = None
    margin: float | None = None
    strain: float | None = None
    tangents: bool = False
    keeps_length: bool = False


def solved(curve: PlaneCurve, wish: Wish) -> Strip:
    """The strip for a curve.

    Raises
    ------
    ElasticaError
        With the core's own sentence: what is wrong, where, what to do.
    """
    try:
        if wish.nearest:
            patiently("Searching the nearest curve", _near, _Same.of(curve), _question(wish))
        return _strip(_Same.of(curve), wish)
    except ImportError as error:
        raise MissingDependencyError(
            f"{error.name or 'a library'} is not installed in this FreeCAD: strips need numpy and scipy"
        ) from error


def nearest_now(curve: PlaneCurve, wish: Wish) -> NearestRod:
    """As `nearest`, for threads of their own: no progress bar."""
    return _near(_Same.of(curve), _question(wish))


def nearest(curve: PlaneCurve, wish: Wish) -> NearestRod:
    """The nearest rod that meets the limits of a wish, whether or not the curve is to be followed exactly."""
    return patiently("Searching the nearest curve", _near, _Same.of(curve), _question(wish))


def judged(rod: Rod) -> Stability | None:
    """Its stability, None where it cannot be decided."""
    try:
        return _stability(rod)
    except ElasticaError:
        return None


@lru_cache(maxsize=32)
def bent_shape(strip: Strip) -> Part.Shape:
    """The strip bent, its curve in the xy plane; of a laminate both layers."""
    # thousands of holes take seconds: then the records are made beside the window, with a bar that can be cancelled
    many = len(strip.holes) > MANY
    layers = patiently("Bending the strip", _bent, strip) if many else _bent(strip)
    solids = [make_solid(layer) for layer in layers]
    return solids[0] if len(solids) == 1 else Part.Compound(solids)


@lru_cache(maxsize=8)
def _bent(strip: Strip) -> tuple[BentSolid, ...]:
    layers = BentSolid.layers(strip)
    for layer in layers:
        _ = layer.boundary
    return layers


@lru_cache(maxsize=32)
def flat_shape(strip: Strip, layer: int = 0) -> Part.Shape:
    """One layer of the strip as cut, lying on the xy plane."""
    cut = strip.layers[layer]
    return make_solid(FlatSolid(cut.outline, cut.holes, cut.sheet.thickness))


def _question(wish: Wish) -> tuple[Any, ...]:
    """What the nearest rod depends on."""
    names = ("sheet", "ratio", "margin", "strain", "tangents", "keeps_length", "gravity", "supports")
    return tuple(getattr(wish, name) for name in names)


@lru_cache(maxsize=32)
def _rod(drawn: _Same, options: tuple[tuple[str, Any], ...]) -> Rod:
    return optimal_rod(drawn.curve, **dict(options))


@lru_cache(maxsize=32)
def _near(drawn: _Same, question: tuple[Any, ...]) -> NearestRod:
    sheet, ratio, margin, strain, tangents, keeps_length, gravity, supports = question
    limits = Limits(ratio=ratio, margin=margin, sheet=sheet, strain=strain)
    keep = Keep(tangents=tangents, length=keeps_length)
    return nearest_rod(drawn.curve, limits, keep, gravity, supports=supports)


@lru_cache(maxsize=32)
def _strip(drawn: _Same, wish: Wish) -> Strip:
    if wish.nearest:
        near = _near(drawn, _question(wish))
        if not near.met:
            raise NotConvergedError(near.status.value)
        rod = near.rod
    else:
        options = ("gravity", "supports", "natural_curvature", "samples")
        rod = _rod(drawn, tuple((name, getattr(wish, name)) for name in options))
    return Strip(
        rod,
        wish.sheet,
        max_width=wish.max_width,
        min_width=wish.min_width,
        style=wish.style.style(),
        ends=wish.ends,
        label=wish.label,
    )


@lru_cache(maxsize=32)
def _stability(rod: Rod) -> Stability:
    return stability(rod)
