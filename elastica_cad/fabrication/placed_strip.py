"""A strip placed in space, and the names of several."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, several, three
from elastica_cad.errors import InputError
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame


@dataclass(frozen=True, eq=False)
class Placed:
    """A strip in space: its curve is drawn in the plane of x_axis and y_axis, its width stands across.

    Parameters
    ----------
    strip : Strip
    origin : (3,) array_like
        Where the origin of the curve's plane lies, mm.
    x_axis, y_axis : (3,) array_like
        Directions of the curve's plane, at right angles; the rulings follow x_axis cross y_axis.

    Raises
    ------
    InputError
        Axes that are not at right angles.
    """

    strip: Strip
    origin: FloatArray
    x_axis: FloatArray
    y_axis: FloatArray

    def __init__(
        self,
        strip: Strip,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        x_axis: ArrayLike = (1.0, 0.0, 0.0),
        y_axis: ArrayLike = (0.0, 1.0, 0.0),
    ) -> None:
        frame = Frame(origin, x_axis, y_axis)
        object.__setattr__(self, "strip", strip)
        for name in ("origin", "x_axis", "y_axis"):
            object.__setattr__(self, name, getattr(frame, name))

    @property
    def frame(self) -> Frame:
        """The plane of the curve."""
        return Frame(self.origin, self.x_axis, self.y_axis)

    def with_strip(self, strip: Strip) -> "Placed":
        """Another strip in the same place."""
        return Placed(strip, self.origin, self.x_axis, self.y_axis)

    def moved(self, turn: ArrayLike, shift: ArrayLike = (0.0, 0.0, 0.0)) -> "Placed":
        """The placed strip after x -> turn @ x + shift; a mirror (determinant -1) turns the flat part over.

        Raises
        ------
        InputError
            `turn` is no 3x3 rotation or mirror.
        """
        m = numbers(turn, "the turn of a strip")
        if m.shape != (3, 3) or not np.allclose(m @ m.T, np.eye(3), rtol=0, atol=1e-9):
            raise InputError(
                "a strip is moved by a 3x3 rotation or mirror and a shift: others would deform it"
            )
        strip = self.strip if np.linalg.det(m) > 0 else self.strip.mirrored()
        origin = m @ self.origin + three(shift, "the shift of a strip")
        return Placed(strip, origin, m @ self.x_axis, m @ self.y_axis)


PLACED_BY = "of a strip ec.Placed(strip), of a body in CAD its `placed`"


def require_placed(placed: object) -> tuple[Placed, ...]:
    """Placed strips as a tuple; refuses what is none."""
    return several("placed", placed, Placed, "Placed", PLACED_BY)


def strip_names(placed: Sequence[Placed]) -> tuple[str, ...]:
    """What messages call each strip: its label, or its place counted from 1."""
    return tuple(one.strip.label or f"strip {i}" for i, one in enumerate(placed, start=1))


def distinct_names(placed: Sequence[Placed]) -> tuple[str, ...]:
    """The names, with the place behind those that several strips share."""
    names = strip_names(placed)
    count = Counter(names)
    return tuple(f"{name} (strip {i})" if count[name] > 1 else name for i, name in enumerate(names, start=1))
