"""What was read of a drawing: size, unit, kinds of shapes, changes, and distance from what is drawn."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from elastica_cad._counts import counted
from elastica_cad._types import FloatArray
from elastica_cad.formats.curve_files.edges import Run
from elastica_cad.refusals import Length, note, sentences

EXACT_MM = 1e-3
"""Distance, mm, up to which a curve counts as exact."""


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
        return note("{unit}, {known}", unit=self.name, known=self.known)


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

    def __str__(self) -> str:
        width, height = self.size
        size = note("{width:.1f} x {height:.1f} mm ({unit})", width=width, height=height, unit=str(self.unit))
        kinds = [counted(count, kind) for kind, count in self.kinds.items()]
        exact = "exact" if self.distance <= EXACT_MM else note(
            "within {distance:.2g} of the drawing", distance=Length(self.distance)
        )  # fmt: skip
        return sentences([size, *kinds, *self.done, exact], ", ")

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
