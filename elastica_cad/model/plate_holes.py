"""Holes in the middle of plates and rings, for lamp holders and screws, and the bridge with these holes."""

from dataclasses import dataclass, replace
from typing import Annotated, Literal, TypeAlias, get_args

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import Either, FieldName, InputError, Length, Point, note
from elastica_cad.geometry.path import Arc, Line, Path, Segment
from elastica_cad.geometry.plane_points import unit_vectors

Side: TypeAlias = Literal["bottom", "top", "start", "end"]
SIDES: tuple[Side, ...] = get_args(Side)


@dataclass(frozen=True)
class PlateHoles:
    """Holes in the middle of a plate or ring.

    The bridge is along the x axis of the plate, and the first screw hole is on this axis. Without a bridge, a
    plate with a hole for a lamp holder has no other opening.

    Examples
    --------
    >>> holes = PlateHoles(bulb=40, bridge=16, side="top")
    >>> [holes.is_in(name) for name in ("ring-top", "ring-top-outer", "ring-bottom")]
    [True, True, False]
    """

    bulb: Annotated[
        float | None,
        Option(
            "Diameter of a central hole: about 40 for a lamp holder E27, 28 to 30 for E14.", "mm", least=0
        ),
    ] = None
    bridge: Annotated[
        float | None,
        Option("Width of a bar across the opening of a ring that carries the holes.", "mm", least=0),
    ] = None
    screws: Annotated[int, Option("Number of screw holes on a circle.", least=0, most=100)] = 0
    screw: Annotated[float, Option("Diameter of the screw holes.", "mm", above=0, needs="screws")] = 4.2
    circle: Annotated[
        float | None,
        Option(
            "Diameter of the circle of the screw holes; by default the border is between them and the central "
            "hole.",
            "mm",
            least=0,
            needs="screws",
        ),
    ] = None
    side: Annotated[
        Side | None,
        Option("The only side of the model whose plates have the holes; by default both."),
    ] = None

    def __post_init__(self) -> None:
        require_declared(PlateHoles, vars(self), "holes:")
        if not self.bulb and not self.screws:
            raise InputError(
                "There is no hole. Set {bulb} or {screws}.",
                bulb=FieldName("holes.bulb"),
                screws=FieldName("holes.screws"),
            )
        if self.screws and not self.bulb and not self.circle:
            raise InputError(
                "The positions of the screw holes are unknown. Set {circle}, the diameter of their circle.",
                circle=FieldName("holes.circle"),
            )

    def is_in(self, name: str) -> bool:
        """Return True if the plate of this name has the holes."""
        require_record(name, str, "the name of a plate", "a text")
        # endings of the name of the second plate of a pair
        for ending in ("-outer", "-lower"):
            name = name.removesuffix(ending)
        return self.side is None or name.endswith(f"-{self.side}")

    def cut(
        self, center: FloatArray, opening: Path | None, border: float
    ) -> tuple[Path | None, tuple[Path, ...]]:
        """Return the round opening (None if holes or a bridge replace it) and the loops of all holes."""
        round_hole = (self.bulb or 0.0) / 2
        # by default, the screw holes are `border` mm from the edge of the hole for the lamp holder
        circle = (self.circle or (self.bulb or 0.0) + self.screw + 2 * border) / 2
        turns = 2 * np.pi * np.arange(self.screws) / max(self.screws, 1)
        middles = center + circle * unit_vectors(turns)
        holes = [Path.circle(center, round_hole)] if round_hole else []
        holes += [Path.circle(middle, self.screw / 2) for middle in middles]
        if opening is None or (not round_hole and not self.bridge):
            return opening, tuple(holes)
        windows: tuple[Path, ...] = ()
        if self.bridge:
            inner = float(np.ptp(opening.bounds[:, 0])) / 2
            # holes inside the opening are in a round hub, with half the bridge's width of material around them
            reach = circle + self.screw / 2 if self.screws and circle - self.screw / 2 < inner else 0.0
            hub = max(round_hole, reach)
            windows = _openings_beside_bar(
                center, inner, hub + self.bridge / 2 if hub else 0.0, self.bridge / 2
            )
        return None, (*holes, *windows)


def _openings_beside_bar(center: FloatArray, outer: float, hub: float, half: float) -> tuple[Path, ...]:
    """Return the two parts of a round opening beside a bar along x with a round hub, or () if the hub fills it.

    `outer` and `hub` are the radii of opening and hub, and `half` is half the width of the bar, mm.
    """
    if max(hub, half) + half >= outer:
        return ()
    # the edges of the bar meet the opening at x = far, and the hub at x = near
    far = np.sqrt(outer**2 - half**2)
    turn = float(np.arcsin(half / outer))
    segments: list[Segment] = [Arc((0, 0), outer, turn, np.pi - turn)]
    if hub > half:
        near, bend = np.sqrt(hub**2 - half**2), float(np.arcsin(half / hub))
        segments += [
            Line((-far, half), (-near, half)),
            Arc((0, 0), hub, np.pi - bend, bend),
            Line((near, half), (far, half)),
        ]
    else:
        segments.append(Line((-far, half), (far, half)))
    upper = Path(segments, closed=True)
    return tuple(
        path.moved(*map(float, center)) for path in (upper, upper.transformed(np.diag([-1.0, -1.0, 1.0])))
    )


def is_window(path: Path) -> bool:
    """Return True if a loop is an opening beside a bridge, and not a round hole."""
    return len(path.segments) > 1


def hole_name(path: Path) -> str:
    """Return the name of a hole for messages, with the position of its centre."""
    arc, center = path.segments[0], Point(path.bounds.mean(axis=0).tolist())
    if isinstance(arc, Arc) and not is_window(path):
        return note("the hole of {diameter} at {center}", diameter=Length(2 * arc.radius), center=center)
    return note("the opening beside the bridge at {center}", center=center)


def refuse_other_ends(holes: PlateHoles | None, names: list[str]) -> None:
    """Raise InputError if none of the plates with these names has the holes."""
    if holes is None:
        return
    require_record(holes, PlateHoles, "the record of holes", "a PlateHoles")
    if not any(holes.is_in(name) for name in names):
        sides = [side for side in SIDES if any(replace(holes, side=side).is_in(name) for name in names)]
        raise InputError(
            "{field} is {side}, but the plates are {names}. Use {sides}, or leave out {field}." if sides else
            "{field} is {side}, but the plates are {names}. Leave out {field}.",
            field=FieldName("holes.side"), side=holes.side, names=", ".join(names), sides=Either(sides),
        )  # fmt: skip
