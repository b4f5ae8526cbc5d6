"""A model: strips in space and their copies, what holds them and what is cut."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, TypeAlias

import numpy as np

from elastica_cad._counts import counted
from elastica_cad._notebook import html_table
from elastica_cad._types import ArrayLike
from elastica_cad._values import direction, is_whole, several, three
from elastica_cad.declared import Asked, require_declared
from elastica_cad.errors import InputError, quoted, refuse_options_unlike
from elastica_cad.fabrication.holders.end_fixtures import EndFixture, end_fixtures
from elastica_cad.fabrication.holders.held_tabs import held_shapes
from elastica_cad.fabrication.holders.plates import BasePlate, Ring, base_plate
from elastica_cad.fabrication.holders.slotted_frame import SlottedFrame, slotted_frame
from elastica_cad.fabrication.holding.held_shape import HeldShape
from elastica_cad.fabrication.interlocking.interlock import Joint, interlock
from elastica_cad.fabrication.placed_strip import Placed, distinct_names, require_placed, strip_names
from elastica_cad.fabrication.sheets.cut_list import CutList, cut_list
from elastica_cad.fabrication.sheets.nesting import NestedSheet, nest_pieces
from elastica_cad.fabrication.sheets.pieces import (
    EqualStrips,
    Piece,
    count_shapes,
    group_equal_strips,
    strip_pieces,
)
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.sheet_library import require_printable

Triple: TypeAlias = tuple[float, float, float]

MOST_PLACED = 100_000
"""Largest number of strips of one model."""


def mirror(
    placed: Sequence[Placed],
    point: Annotated[ArrayLike, Asked("A point on the plane.", "mm", written=Triple)] = (0.0, 0.0, 0.0),
    normal: Annotated[ArrayLike, Asked("Across the plane.", written=Triple)] = (1.0, 0.0, 0.0),
    *,
    keep: Annotated[bool, Asked("Keep the original too.")] = True,
) -> tuple[Placed, ...]:
    """The mirror images in the plane through `point` across `normal`, behind the strips themselves if kept."""
    n, p = direction(normal, "the normal of a mirror"), three(point, "the point of a mirror")
    turn = np.eye(3) - 2 * np.outer(n, n)
    images = tuple(one.moved(turn, 2 * (p @ n) * n) for one in placed)
    return (*placed, *images) if keep else images


def rotate(
    placed: Sequence[Placed],
    count: Annotated[int, Asked("How many in all.", least=1, most=1000)],
    *,
    axis: Annotated[ArrayLike, Asked("Direction of the axis.", written=Triple)] = (0.0, 0.0, 1.0),
    point: Annotated[ArrayLike, Asked("A point on the axis.", "mm", written=Triple)] = (0.0, 0.0, 0.0),
    step: Annotated[float | None, Asked("Angle between two; all around unless given.", "rad")] = None,
) -> tuple[Placed, ...]:
    """The strips `count` times about an axis, each `step` rad further; the full turn by `count` unless given."""
    _require_count(count, len(placed))
    require_declared(rotate, {"step": step}, "rotation")
    k, p = direction(axis, "the axis of a rotation"), three(point, "the point of a rotation")
    angle = 2 * np.pi / count if step is None else float(step)
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    copies = list(placed)
    for i in range(1, count):
        turn = np.eye(3) + np.sin(i * angle) * cross + (1 - np.cos(i * angle)) * cross @ cross
        copies += [one.moved(turn, p - turn @ p) for one in placed]
    return tuple(copies)


def repeat(
    placed: Sequence[Placed],
    count: Annotated[int, Asked("How many in all.", least=1, most=1000)],
    step: Annotated[ArrayLike, Asked("From one to the next.", "mm", written=Triple)],
) -> tuple[Placed, ...]:
    """The strips `count` times, the first where they are, each `step` (3,) mm further."""
    _require_count(count, len(placed))
    d = three(step, "the step of a pattern")
    return tuple(one.moved(np.eye(3), i * d) for i in range(count) for one in placed)


def _require_count(count: int, of: int) -> None:
    require_declared(repeat, {"count": count}, "pattern")
    if count * of > MOST_PLACED:
        raise InputError(
            "a pattern of {of} strips, {count} times: a model holds {most_placed} at most",
            of=of,
            count=quoted(count),
            most_placed=MOST_PLACED,
        )


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
        No strips.
    """

    placed: tuple[Placed, ...]
    name: str = "model"
    reports: tuple[str, ...] = ()
    joints: tuple[Joint, ...] = ()
    plates: tuple[Ring, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "placed", require_placed(self.placed))
        object.__setattr__(self, "reports", several("reports", self.reports, str, "text"))
        require_printable(self.name, "the model's name")
        if not self.placed:
            raise InputError("the model {name!r} has no strips", name=self.name)

    @property
    def strips(self) -> tuple[Strip, ...]:
        """The strips in order, equal ones repeated."""
        return tuple(placed.strip for placed in self.placed)

    def name_of(self, index: int) -> str:
        """Name of a strip in messages: its label, or its number counted from 1."""
        return strip_names(self.placed)[self._place(index)]

    def single_name_of(self, index: int) -> str:
        """Return the name of strip `index`, with its place where other strips have the same label."""
        return distinct_names(self.placed)[self._place(index)]

    def _place(self, index: int) -> int:
        if not is_whole(index) or not -len(self.placed) <= index < len(self.placed):
            raise InputError(
                "{index!r} is no strip of this model: give one of the places 0 to {given}",
                index=index,
                given=len(self.placed) - 1,
            )
        return index

    def __repr__(self) -> str:
        strips, joints = counted(len(self.placed), "strip"), counted(len(self.joints), "joint")
        return f"<Model {self.name!r}, {strips}, {joints}>"

    def _repr_html_(self) -> str:
        rows = [
            {
                "part": part.name, "cut": part.count, "sheet": part.strip.sheet.name,
                "length, mm": f"{part.strip.rod.length:.1f}", "ratio": f"{part.strip.rod.ratio:.3g}",
                "strain": f"{part.strip.max_strain:.2%}",
            }
            for part in self.parts
        ]  # fmt: skip
        return html_table(repr(self), rows)

    @cached_property
    def parts(self) -> tuple[EqualStrips, ...]:
        """Strips to be cut: equal ones once, with their count; see `group_equal_strips`."""
        return group_equal_strips(self.placed)

    @cached_property
    def shape_count(self) -> int:
        """Number of different shapes of the strips, whatever is engraved on them."""
        return count_shapes(self.parts)

    def with_strips(self, strips: Sequence[Strip]) -> "Model":
        """The model with other strips in the same places."""
        new = several("strips", strips, Strip, "Strip")
        if len(new) != len(self.placed):
            raise InputError(
                "the model has {count} strips, not {count_2}: give a Strip record for each",
                count=len(self.placed),
                count_2=len(new),
            )
        pairs = zip(self.placed, new, strict=True)
        return replace(self, placed=tuple(placed.with_strip(strip) for placed, strip in pairs))

    def interlock(self, **options: Any) -> "Model":
        """The model with slots wherever two bent strips cross, cut half way into each.

        Options are those of `fabrication.interlock`: clearance, fit, relief, pairs, above; so are the errors.
        """
        refuse_options_unlike(options, interlock, "interlock")
        found = interlock(self.placed, **options)
        return replace(
            self,
            placed=found.placed,
            joints=(*self.joints, *found.joints),
            reports=(*self.reports, *found.reports),
        )

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Drawings of what is cut: as `parts`, with each layer of a laminate as a piece, then the plates."""
        return (*strip_pieces(self.parts), *(plate.piece for plate in self.plates))

    def fixtures(self, *, floor: Frame | None = None, **sizes: Any) -> tuple[EndFixture, ...]:
        """Printed blocks that hold both ends of every strip; sizes are those of `EndFixture`."""
        return end_fixtures(self.placed, floor=floor, **sizes)

    def base_plate(self, sheet: Sheet | str, **options: Any) -> BasePlate:
        """One slotted plate for all tabs that stand on it; options: see `fabrication.base_plate`."""
        refuse_options_unlike(options, base_plate, "a base plate")
        return base_plate(self.placed, sheet, **options)

    def slotted_frame(self, sheet: Sheet | str, **options: Any) -> SlottedFrame:
        """Rails for the tabs of both ends, joined by ribs; options: see `fabrication.slotted_frame`."""
        refuse_options_unlike(options, slotted_frame, "a slotted frame")
        return slotted_frame(self.placed, sheet, **options)

    def nest(self, *, others: Iterable[Piece] = (), **options: Any) -> tuple[NestedSheet, ...]:
        """Drawings of all sheets to be cut: the strips and other pieces.

        Options are those of `fabrication.nest_pieces`: sheet_size, margin, kerf, name.
        """
        refuse_options_unlike(options, nest_pieces, "a nest")
        more = several("other pieces", others, Piece, "Piece")
        return nest_pieces((*self.pieces, *more), **{"name": f"{self.name}-nest", **options})

    def cut_list(self, others: Iterable[Piece] = ()) -> CutList:
        """Return the list of all pieces, equal ones once with their count."""
        return cut_list((*self.pieces, *several("other pieces", others, Piece, "Piece")))

    def held(self, *holders: object) -> tuple[HeldShape, ...]:
        """The shape that each strip takes as it is made, in its rings and these holders: see `Strip.held`."""
        return held_shapes(self.placed, (*self.plates, *holders))

    def mirrored(
        self, point: ArrayLike = (0.0, 0.0, 0.0), normal: ArrayLike = (1.0, 0.0, 0.0), *, keep: bool = True
    ) -> "Model":
        """The mirror image in the plane through `point` across `normal`, and the strips themselves if kept."""
        return self._arranged(mirror(self.placed, point, normal, keep=keep))

    def rotated(self, count: int, **options: Any) -> "Model":
        """The strips `count` times about an axis, the first where they are.

        Options: axis (3,), point (3,) and step, rad; about z, one full turn in all, unless given.
        """
        refuse_options_unlike(options, rotate, "a rotated model")
        return self._arranged(rotate(self.placed, count, **options))

    def repeated(self, count: int, step: ArrayLike) -> "Model":
        """The strips `count` times, the first where they are, each `step` (3,) mm further."""
        return self._arranged(repeat(self.placed, count, step))

    def _arranged(self, placed: tuple[Placed, ...]) -> "Model":
        if self.plates:
            raise InputError(
                "the model {name!r} has {name_2}, made for its strips where they are: repeat the "
                "strips without rings",
                name=self.name,
                name_2=self.plates[0].name,
            )
        return replace(self, placed=placed)
