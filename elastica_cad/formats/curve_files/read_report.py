"""What was read of a drawing: size, unit, kinds of shapes, changes, and distance from what is drawn."""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.formats.curve_files.edges import Run
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.refusals import Length, note

EXACT_MM = 1e-3
"""Distance, mm, up to which a curve counts as exact."""

_PLACES = 401  # of a curve, at which its size is measured
_EACH, _MOST_POINTS = 4, 200  # points in a span of the drawing, and in all, whose distance is measured
_TURNED = 1e-3  # slope of a drawing's plane from which it counts as turned


class ReadCurve(Protocol):
    """A curve of a drawing; the members are those of `DrawnCurve`."""

    @property
    def kinds(self) -> Mapping[str, int]: ...  # noqa: D102
    @property
    def chain(self) -> Run: ...  # noqa: D102
    @property
    def flatten(self) -> Callable[[Run], Run] | None: ...  # noqa: D102
    @property
    def curve(self) -> PlaneCurve: ...  # noqa: D102
    @property
    def problem(self) -> str: ...  # noqa: D102


@dataclass(frozen=True)
class ReadUnit:
    """The unit of a drawing, and how it is known.

    Attributes
    ----------
    name : str
        "mm", "in".
    known : str
        "stated" by the file or by an option, "guessed" from the program that wrote the file, or "assumed".
    source : str
        Where it is stated, such as "$INSUNITS"; empty where it is assumed.
    note : str
        A sentence on how to change it where it is not stated; else empty.
    """

    name: str = "mm"
    known: Literal["stated", "guessed", "assumed"] = "assumed"
    source: str = ""
    note: str = ""

    @classmethod
    def requested(cls, name: str) -> "ReadUnit":
        """Return the unit that an option gives."""
        return cls(name, "stated", "the option unit")

    def __str__(self) -> str:
        if self.known == "stated":
            return note("{unit}, from {source}", unit=self.name, source=self.source)
        return f"{self.name}, {self.known}"


@dataclass(frozen=True)
class ReadReport:
    """What was read of a drawing.

    Attributes
    ----------
    size : (float, float)
        Width and height of the curves, mm.
    unit : ReadUnit
    kinds : mapping
        Number of shapes of each kind: {"spline": 1}.
    done : tuple of str
        What was done to them: "joined", "fitted", "turned", "smoothed".
    distance : float
        Largest distance between drawing and curve, mm.
    """

    size: tuple[float, float]
    unit: ReadUnit
    kinds: Mapping[str, int] = field(default_factory=dict)
    done: tuple[str, ...] = ()
    distance: float = 0.0

    @classmethod
    def of(cls, curves: Iterable[ReadCurve], unit: ReadUnit) -> "ReadReport | None":
        """Return the report on those curves that are valid; None if none is."""
        good = [one for one in curves if not one.problem]
        if not good:
            return None
        places = np.concatenate([one.curve.sample(_PLACES).position for one in good])
        width, height = np.ptp(places, axis=0).tolist()
        kinds: Counter[str] = Counter()
        found = {"joined": False, "fitted": False, "turned": False, "smoothed": False}
        distance = 0.0
        for one in good:
            kinds.update(one.kinds)
            drawn, flat = one.curve.provenance, one.chain
            if one.flatten is not None:
                flat = one.flatten(one.chain)
                found["turned"] |= _is_turned(one.chain, flat)
            away = _distance(one.curve, flat)
            pointwise = "point" in one.kinds and not one.curve.is_straight
            found["fitted"] |= pointwise or ("polyline" in one.kinds and away > EXACT_MM)
            found["joined"] |= len({id(edge.source or edge) for edge in one.chain}) > 1
            found["smoothed"] |= drawn is not None and drawn.healed > EXACT_MM
            distance = max(distance, away)
        return cls(
            (width, height), unit, kinds, tuple(name for name, is_so in found.items() if is_so), distance
        )

    def __str__(self) -> str:
        width, height = (f"{side:.1f}" if side < 1e6 else f"{side:.4g}" for side in self.size)
        kinds = (f"{count} {kind}{'s' if count > 1 else ''}" for kind, count in self.kinds.items())
        if self.distance <= EXACT_MM:
            exact = "exact"
        else:
            exact = note("within {distance:.2g} of the drawing", distance=Length(self.distance))
        return ", ".join([f"{width} x {height} mm ({self.unit})", *kinds, *self.done, exact])

    def as_dict(self) -> dict[str, Any]:
        """Return the report for programs."""
        return {
            "size": list(self.size),
            "unit": self.unit.name,
            "unit_known": self.unit.known,
            "unit_source": self.unit.source,
            "kinds": dict(self.kinds),
            "done": list(self.done),
            "distance": self.distance,
            "summary": str(self),
        }


def kinds_of(chain: Run) -> Counter[str]:
    """Return the number of shapes of each kind in a chain; all edges of a kind of one shape count once."""
    shapes = {
        (id(edge.source) if edge.source else number, _kind(edge.degree, len(edge.points), edge.weights))
        for number, edge in enumerate(chain)
    }
    return Counter(kind for _, kind in sorted(shapes, key=lambda shape: shape[1]))


def _kind(degree: int, count: int, weights: FloatArray | None) -> str:
    if degree == 1:
        return "line" if count == 2 else "polyline"
    return "arc" if degree == 2 and weights is not None else "spline"


def _is_turned(chain: Run, flat: Run) -> bool:
    """Return True if x and y of a flattened chain are not those of the drawing."""
    drawn, read = (np.concatenate([edge.points[:, :2] for edge in run]) for run in (chain, flat))
    return bool(np.abs(drawn - read).max() > _TURNED * np.ptp(read, axis=0).max())


def _distance(curve: PlaneCurve, flat: Run) -> float:
    """Return the largest distance of what is drawn, edges in the plane or points, from the curve, mm."""
    record = curve.provenance
    if flat:
        if len(flat) == 1 and np.array_equal(flat[0].points, curve.control_points):
            return 0.0
        points = np.concatenate([edge.at(edge.stations(_EACH)) for edge in flat])
    elif record is not None and record.measured is not None:
        points = record.measured.points
    else:
        return 0.0
    return float(distances(Spline(curve), points[:: -(-len(points) // _MOST_POINTS)]).max())
