"""A model: strips in space, how many of them are equal, and patterns of them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.equality import FlatShape
from elastica_cad.fabrication.interlock import Fit, Joint, interlocked
from elastica_cad.fabrication.slot_effects import SlotEffect, slot_effect
from elastica_cad.fabrication.slots import Relief
from elastica_cad.fabrication.strip import Strip

if TYPE_CHECKING:
    from elastica_cad.fabrication.base import BasePlate
    from elastica_cad.fabrication.cutlist import CutList
    from elastica_cad.fabrication.fixtures import EndFixture
    from elastica_cad.fabrication.frames import SlottedFrame
    from elastica_cad.fabrication.nesting import NestedSheet
    from elastica_cad.fabrication.pieces import Piece
    from elastica_cad.fabrication.rings import Ring
    from elastica_cad.mechanics import Sheet

__all__ = ["Model", "Part", "Placed"]


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
        m = np.asarray(turn, dtype=float)
        if m.shape != (3, 3) or not np.allclose(m @ m.T, np.eye(3), rtol=0, atol=1e-9):
            raise InputError(
                "a strip is moved by a 3x3 rotation or mirror and a shift: others would deform it"
            )
        strip = self.strip if np.linalg.det(m) > 0 else self.strip.mirrored()
        origin = m @ self.origin + np.asarray(shift, dtype=float)
        return Placed(strip, origin, m @ self.x_axis, m @ self.y_axis)


@dataclass(frozen=True, eq=False)
class Part:
    """Equal strips of a model: cut as often as there are `members`.

    Attributes
    ----------
    strip : Strip
        The first of them, whose drawing is cut.
    name : str
        Its label, or "strip 3" after its place in the model.
    members : tuple of int
        Places in the model.
    """

    strip: Strip
    name: str
    members: tuple[int, ...]

    @property
    def count(self) -> int:
        """How many are cut."""
        return len(self.members)


@dataclass(frozen=True, eq=False)
class Model:
    """Strips in space.

    Parameters
    ----------
    placed : sequence of Placed
        In the order of assembly.
    name : str
        Titles and file names come from it.
    reports : tuple of str
        What was found on the way, one sentence each.
    joints : tuple of Joint
        Where strips were slotted into each other by `interlock`.
    plates : tuple of Ring
        Flat parts that belong to it, in their places: rings and caps of a surface of revolution.

    Raises
    ------
    InputError
        No strips, or two different parts with the same label.
    """

    placed: tuple[Placed, ...]
    name: str = "model"
    reports: tuple[str, ...] = ()
    joints: tuple[Joint, ...] = ()
    plates: "tuple[Ring, ...]" = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "placed", tuple(self.placed))
        object.__setattr__(self, "reports", tuple(self.reports))
        if not self.placed:
            raise InputError(f"the model {self.name!r} has no strips")

    @property
    def strips(self) -> tuple[Strip, ...]:
        """The strips in order, equal ones repeated."""
        return tuple(placed.strip for placed in self.placed)

    def name_of(self, index: int) -> str:
        """How messages call a strip: its label, or its place counted from 1."""
        return self.placed[index].strip.label or f"strip {index + 1}"

    def single_name_of(self, index: int) -> str:
        """Its name, with its place where other strips have the same label."""
        label = self.placed[index].strip.label
        alike = bool(label) and sum(placed.strip.label == label for placed in self.placed) > 1
        return f"{label} (strip {index + 1})" if alike else self.name_of(index)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """What must be cut: equal strips once, with their count.

        Strips are equal where sheet, label and all cut loops are, after turning the part about or over.
        """
        found: list[tuple[FlatShape, list[int]]] = []
        known: dict[int, list[int]] = {}  # one strip in several places need not be compared again
        for index, strip in enumerate(self.strips):
            if id(strip) not in known:
                shape = FlatShape(strip)
                alike = next((members for first, members in found if first.equals(shape)), None)
                if alike is None:
                    alike = []
                    found.append((shape, alike))
                known[id(strip)] = alike
            known[id(strip)].append(index)
        return tuple(Part(shape.strip, self.name_of(members[0]), tuple(members)) for shape, members in found)

    def with_strips(self, strips: Sequence[Strip]) -> "Model":
        """The model with other strips in the same places."""
        pairs = zip(self.placed, strips, strict=True)
        return replace(self, placed=tuple(placed.with_strip(strip) for placed, strip in pairs))

    def interlock(
        self,
        *,
        clearance: float = 0.1,
        fit: Fit = "exact",
        relief: Relief = "square",
        pairs: Iterable[tuple[int, int]] | None = None,
        above: ArrayLike | None = None,
    ) -> "Model":
        """The model with slots wherever two bent strips cross, cut half way into each from opposite sides.

        The strips are taken as ruled surfaces, and their crossings are exact. A slot is as wide as the angle
        between the strips asks for, point by point. Each strip is cut from the side on which it ends; where
        both sides would do, the earlier of two strips opens towards `above`, so that the later one is pushed on
        from there. Only the strips between their tabs are searched: keep tabs clear of other strips. A crossing
        that leaves a strip through its end, not its edge, leaves no way to push it on and is refused.

        Parameters
        ----------
        clearance : float
            Added to the width of every slot, mm.
        fit : "exact" or "paper"
            "paper" is the narrower h / sin(phi), too narrow below 60 degrees.
        relief : "square" or "round"
            Inner ends of the slots.
        pairs : iterable of (int, int), optional
            Which strips may be slotted, by their places; all that cross if not given.
        above : (3,) array_like, optional
            A direction; the earlier strip's own rulings if not given.

        Raises
        ------
        InputError
            Strips that touch along a line or cross where one of them ends, slots that meet, a clearance larger
            than a strip.
        """
        slots, joints, reports = interlocked(
            self, clearance=clearance, fit=fit, relief=relief, pairs=pairs, above=above
        )
        strips = [
            replace(strip, slots=(*strip.slots, *new)) if new else strip
            for strip, new in zip(self.strips, slots, strict=True)
        ]
        slotted = self.with_strips(strips)
        for index, strip in enumerate(slotted.strips):
            _refuse_faults(strip, slotted.name_of(index))
        return replace(slotted, joints=(*self.joints, *joints), reports=(*self.reports, *reports))

    @property
    def pieces(self) -> "tuple[Piece, ...]":
        """What must be cut, drawn: as `parts`, each layer of a laminate a piece of its own, then the plates."""
        from elastica_cad.fabrication.pieces import strip_pieces

        return (*strip_pieces(self), *(plate.piece for plate in self.plates))

    def fixtures(self, *, floor: Frame | None = None, **sizes: float) -> "tuple[EndFixture, ...]":
        """Printed blocks that hold both ends of every strip: see `end_fixtures`."""
        from elastica_cad.fabrication.fixtures import end_fixtures

        return end_fixtures(self, floor=floor, **sizes)

    def base_plate(self, sheet: "Sheet", *, frame: Frame | None = None, **options: Any) -> "BasePlate":
        """One slotted plate for all tabs that stand on it: see `base_plate`."""
        from elastica_cad.fabrication.base import base_plate

        return base_plate(self, sheet, frame=frame, **options)

    def slotted_frame(self, sheet: "Sheet", **options: Any) -> "SlottedFrame":
        """Rails for the tabs of both ends, joined by ribs, where there is no base: see `slotted_frame`."""
        from elastica_cad.fabrication.frames import slotted_frame

        return slotted_frame(self, sheet, **options)

    def nest(
        self,
        *,
        sheet_size: tuple[float, float] = (600.0, 400.0),
        margin: float = 2.0,
        kerf: float | None = 0.0,
        others: "Iterable[Piece]" = (),
    ) -> "tuple[NestedSheet, ...]":
        """Drawings of all sheets to be cut: the strips, and other pieces. See `nested`."""
        from elastica_cad.fabrication.nesting import nested

        pieces, name = (*self.pieces, *others), f"{self.name}-nest"
        return nested(pieces, sheet_size=sheet_size, margin=margin, kerf=kerf, name=name)

    def cut_list(self, others: "Iterable[Piece]" = ()) -> "CutList":
        """The list of all pieces, equal ones once with their count."""
        from elastica_cad.fabrication.cutlist import cut_list

        return cut_list((*self.pieces, *others))

    def slot_effects(self) -> tuple[SlotEffect | None, ...]:
        """For each strip what its slots do to its stiffness and shape; None where there are none."""
        return tuple(slot_effect(strip) if strip.slots else None for strip in self.strips)

    def mirrored(self, point: ArrayLike, normal: ArrayLike, *, keep: bool = True) -> "Model":
        """The mirror image in the plane through `point` across `normal`, and the strips themselves if kept."""
        n, p = np.asarray(normal, dtype=float), np.asarray(point, dtype=float)
        size = float(np.linalg.norm(n))
        if not (n.shape == p.shape == (3,) and np.isfinite(size) and size > 0):
            raise InputError("a mirror needs a point and a normal of three numbers, the normal not zero")
        n = n / size
        turn = np.eye(3) - 2 * np.outer(n, n)
        self._refuse_plates()
        images = tuple(placed.moved(turn, 2 * (p @ n) * n) for placed in self.placed)
        return replace(self, placed=(*(self.placed if keep else ()), *images))

    def rotated(
        self,
        count: int,
        *,
        axis: ArrayLike = (0.0, 0.0, 1.0),
        point: ArrayLike = (0.0, 0.0, 0.0),
        step: float | None = None,
    ) -> "Model":
        """The strips `count` times about an axis, the first where they are, each `step` rad further.

        `step` is the full turn divided by `count` where not given.
        """
        k, p = np.asarray(axis, dtype=float), np.asarray(point, dtype=float)
        size = float(np.linalg.norm(k))
        if count < 1 or not (np.isfinite(size) and size > 0):
            raise InputError("a rotation pattern needs a count of 1 or more and an axis that is not zero")
        angle = 2 * np.pi / count if step is None else float(step)
        k = k / size
        cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        self._refuse_plates()
        copies: list[Placed] = []
        for i in range(count):
            turn = np.eye(3) + np.sin(i * angle) * cross + (1 - np.cos(i * angle)) * cross @ cross
            copies += [placed.moved(turn, p - turn @ p) if i else placed for placed in self.placed]
        return replace(self, placed=tuple(copies))

    def repeated(self, count: int, step: ArrayLike) -> "Model":
        """The strips `count` times, the first where they are, each `step` (3,) mm further."""
        if count < 1:
            raise InputError(f"a pattern repeats 1 time or more, not {count}")
        d = np.asarray(step, dtype=float)
        self._refuse_plates()
        copies = [placed.moved(np.eye(3), i * d) for i in range(count) for placed in self.placed]
        return replace(self, placed=tuple(copies))

    def _refuse_plates(self) -> None:
        if self.plates:
            raise InputError(
                f"the model {self.name!r} has {self.plates[0].name}, made for its strips where they are: repeat "
                "the strips without rings"
            )


def _refuse_faults(strip: Strip, name: str) -> None:
    """Draw the outline now, so that slots that meet are found with the part's name."""
    try:
        whole = strip.outline.closed
    except InputError as error:
        own = f"{strip.label or 'strip'}: "
        raise InputError(f"{name}: {str(error).removeprefix(own)}") from error
    if not whole:
        raise InputError(f"{name}: the slots open its outline")
