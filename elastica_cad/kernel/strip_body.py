"""What bodies of strips tell and warn of in every CAD library, and how they are bent anew."""

import sys
import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import degrees, hypot
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, TypedDict

from elastica_cad._text import printable
from elastica_cad._types import ArrayLike
from elastica_cad.errors import InputError, refuse_unknown
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.occt import make_face, make_sheets
from elastica_cad.kernel.ocp_import import Shape
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.between_clamps import angles_in_rad
from elastica_cad.mechanics.loads import Supports
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.theorem1 import EquilibriumCheck
from elastica_cad.model.collisions import self_contact
from elastica_cad.refusals import Length, note
from elastica_cad.strip.flat_pattern import in_smooth_pieces
from elastica_cad.strip.solids import BentSolid, bent_sheets
from elastica_cad.strip.strip import Placed, Strip

if TYPE_CHECKING:
    from elastica_cad.model.model import Model


LEAST_DEGREES = 7.0
"""Decimals below this are taken for radians: a whole turn is 6.28."""

LIBRARIES = ("elastica_cad", "build123d", "cadquery")
"""Between the user's line and what goes wrong."""


class StripWarning(UserWarning):
    """Strips can be made, but maybe not as they are meant: strained too much, or through each other."""


def warn_of_missing_slots(model: "Model") -> None:
    """Warn of strips of a model that run through each other without a slot."""
    from elastica_cad.model.collisions import missing_slots

    for text in missing_slots(model.placed, model.joints):
        warn(text)


def warn_of_strain(strip: Strip) -> None:
    """Tell of a strip that is strained beyond what its sheet takes."""
    for text in strip.strain_warnings[:1]:
        warn(text)


def end_angles(angles: object) -> tuple[float | None, float | None]:
    """Angles in degrees at start and end as rad; warns of what looks like radians, which `mechanics.bend` takes."""
    pair = angles_in_rad(angles)
    given = [degrees(angle) for angle in pair if angle]
    if given and all(abs(angle) < LEAST_DEGREES and round(angle, 9) % 1 for angle in given):
        shown = ", ".join(f"{angle:.4g}" for angle in given)
        warn(
            note(
                "angles are in degrees, and {shown} is little: give numpy.degrees(...) of what is in radians",
                shown=shown,
            )
        )
    return pair


def warn(text: str) -> None:
    """Warn at the line of the user's script, however deep we are."""
    depth, caller = 2, sys._getframe(1)
    while caller.f_back is not None and str(caller.f_globals.get("__name__")).split(".")[0] in LIBRARIES:
        depth, caller = depth + 1, caller.f_back
    warnings.warn(printable(text), StripWarning, stacklevel=depth)


def warn_of_contact(strip: Strip) -> None:
    """Tell of a strip that meets itself when it is bent."""
    meeting = self_contact(strip)
    if meeting is not None:
        low, high = meeting
        warn(note(
            "bent, the strip runs through itself: {low} along it meets {high} (tabs lie below 0 and beyond "
            "{length}); shorten the tabs, open the curve, or cut a slot there",
            low=Length(low), high=Length(high), length=Length(strip.rod.length),
        ))  # fmt: skip


OFF_PLANE_MM = 1e-4
"""How far a point given in space may lie off the curve's plane."""


class TupleLike(Protocol):
    """Any vector with a method `toTuple`, as CadQuery's."""

    def toTuple(self) -> tuple[float, float, float]:
        """Return the coordinates."""


Point: TypeAlias = Iterable[float] | TupleLike
"""In space, or two numbers in the frame of a body, mm."""


def numbers_of(point: Point) -> tuple[float, ...]:
    """Return the numbers of a sequence, or of a vector of build123d or CadQuery.

    Raises
    ------
    TypeError, ValueError
        It is neither.
    """
    given: Any = point.toTuple() if hasattr(point, "toTuple") else point
    return tuple(map(float, given))


class BendOptions(TypedDict, total=False):
    """The ends to which a strip is bent, as in `mechanics.bend`."""

    start: "Point | None"
    """Where the start goes: a point in space, or two numbers in the body's `frame` (mm)."""
    end: "Point | None"
    """Where the end goes, likewise (mm)."""
    angles: "tuple[float | None, float | None] | ArrayLike | None"
    """Directions of start and end in that frame, counted along the strip; None keeps one (degrees)."""
    gravity: Any
    """A `Gravity`, or None for no weight; the strip's own unless given."""
    supports: Supports | None
    """What holds the ends from now on; the strip's own unless given."""
    force: ArrayLike | None
    """Dead force on ends that are free to move, over the least bending stiffness (1/mm2)."""
    moment: float | tuple[float, float] | None
    """Moment on ends that are free to turn, anticlockwise, over the least bending stiffness (1/mm)."""
    guess: Any
    """A `Rod` to start from, or angles of its nodes (rad)."""
    side: int | None
    """To which side a straight strip bulges: 1 for left, -1 for right."""
    mode: int
    """Buckling mode in which a straight strip bulges, from 1."""
    samples: int | None
    """Nodes of the rod."""
    settle: bool
    """An unstable shape snaps to the stable one near it."""


@dataclass(frozen=True, eq=False)
class MadeStrip:
    """A strip and where it lies; copies of a shape share it.

    Attributes
    ----------
    strip : Strip
    frame : Frame
        The plane of its curve.
    deviation : float
        How far limits moved the strip off the drawn curve, mm.
    home : Frame or None
        The joint "start" as it was made of a body that stands on the curve; None for others.
    """

    strip: Strip
    frame: Frame
    deviation: float = 0.0
    home: Frame | None = None

    def __deepcopy__(self, memo: dict[int, Any]) -> "MadeStrip":
        return self

    def mirrored(self) -> "MadeStrip":
        """Return the strip of a mirrored body, whose sides across the strip are exchanged."""
        return replace(self, strip=self.strip.mirrored())

    @property
    def face(self) -> Shape:
        """The flat pattern as a TopoDS_Face."""
        outline, *holes = (in_smooth_pieces(loop) for loop in (self.strip.outline, *self.strip.holes))
        return make_face(outline, holes)


class StripBody:
    """The properties that a body of a strip has in every CAD library."""

    _made: MadeStrip

    def _start(self) -> Frame | None:
        """Where the joint "start" lies now; None where the body has none."""
        raise NotImplementedError

    @property
    def strip(self) -> Strip:
        """The strip: widths, outline, strain, mass."""
        return self._made.strip

    @property
    def deviation(self) -> float:
        """How far limits moved the strip off the drawn curve, mm."""
        return self._made.deviation

    @property
    def frame(self) -> Frame:
        """The plane in which the curve of the bent strip lies: moved with a bent body, as drawn for others."""
        home, now = self._made.home, self._start()
        return self._made.frame if home is None or now is None else self._made.frame.carried(home, now)

    @property
    def rod(self) -> Rod:
        """The bent rod: shape, stiffness, moment, force."""
        return self.strip.rod

    @property
    def check(self) -> EquilibriumCheck | None:
        """The verdict of Theorem 1 on the drawn curve, where one was asked for."""
        return self.rod.check

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences that a maker should read before cutting."""
        return self.strip.warnings

    @property
    def placed(self) -> Placed:
        """The strip in its place, for `Model`."""
        frame = self.frame
        return Placed(self.strip, frame.origin, frame.x_axis, frame.y_axis)

    def _bent_anew(self, moved: BendOptions) -> Strip:
        """The strip with its ends led elsewhere."""
        refuse_unknown(moved, BendOptions.__annotations__, "bending a strip")
        led: dict[str, Any] = dict(moved)
        for name in ("start", "end"):
            if led.get(name) is not None:
                led[name] = self._in_plane(led[name], name)
        if led.get("angles") is not None:
            led["angles"] = end_angles(led["angles"])
        return replace(self.strip, rod=bend(self.strip.rod_to_bend, **led))

    def _in_plane(self, point: Point, name: str) -> tuple[float, ...]:
        """A point in space in the plane of the curve; two numbers are taken as they are."""
        try:
            row = numbers_of(point)
        except (TypeError, ValueError):
            row = ()
        if len(row) == 2:
            return row
        if len(row) != 3:
            raise InputError(
                f"{name} is {point!r}: give a point in space, or two numbers in the strip's frame, mm"
            )
        x, y, z = self.frame.local(row).tolist()
        if abs(z) > OFF_PLANE_MM * max(1.0, hypot(x, y) / 100):
            raise InputError(
                "{name} lies {z:.4g} off the plane in which the strip bends: give a point in it",
                name=name,
                z=Length(abs(z)),
            )
        return x, y

    def _layers(self) -> Iterator[tuple[Shape, str, Sheet]]:
        """The bent sheets, the base first: TopoDS_Solid, name, material."""
        from elastica_cad.model.assembly import bent_names

        names = bent_names(self.strip.label or "strip", self.strip)
        records = BentSolid.layers(self.strip, self.frame)
        yield from zip(make_sheets(records), names, bent_sheets(self.strip), strict=True)

    def _require_backing(self) -> None:
        if len(self.strip.layers) == 1:
            raise InputError("the strip has no backing: give style=Laminated(width=..., backing=...)")
