"""Properties, warnings and bending of strip bodies, common to all CAD libraries."""

import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import degrees, hypot
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Any, Protocol, TypeAlias, TypedDict, TypeVar

from elastica_cad._text import printable
from elastica_cad._types import ArrayLike
from elastica_cad.errors import InputError, Length, note, refuse_unknown
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path, Spline
from elastica_cad.kernel.occt import (
    coordinates,
    face_frame,
    make_face,
    make_sheets,
    make_wire,
    sub_shapes,
)
from elastica_cad.kernel.ocp_import import Shape, kernel
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.between_clamps import ElasticaBetween, angles_in_rad, elastica_between
from elastica_cad.mechanics.loads import Supports, whole_number
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.mechanics.theorem1 import EquilibriumCheck
from elastica_cad.model.collisions import missing_slots, self_contact
from elastica_cad.strip.drawing import ENGRAVE, Drawing
from elastica_cad.strip.flat_pattern import in_smooth_pieces
from elastica_cad.strip.solids import BentSolid, BodyRecord, FlatSolid, bent_colors
from elastica_cad.strip.strip import Placed, Strip

if TYPE_CHECKING:
    from elastica_cad.model.assembly import AssemblyPart, Holder
    from elastica_cad.model.fixtures import EndFixture
    from elastica_cad.model.model import Model

T = TypeVar("T")

LEAST_LEAN_DEGREES = 90 / degrees(1)
"""Inclination of a slot, degrees, below which a number with decimals was probably given in radians."""


class StripWarning(UserWarning):
    """Warning about a strip that can be made but may be useless, such as one that intersects another."""


def model_parts(
    model: "Model", others: "Iterable[Holder]", make: "Callable[[AssemblyPart], T]"
) -> "Iterator[tuple[AssemblyPart, T]]":
    """Return the parts of a model and further holders, each with the result of `make`.

    Equal parts share a result. Strips that intersect without a slot cause a warning.
    """
    from elastica_cad.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    for text in missing_slots(model.placed, model.joints):
        warn(text)
    return shape_parts(parts, make)


def end_angles(angles: object) -> tuple[float | None, float | None]:
    """Convert the angles at start and end from degrees to rad. Warn if they were probably given in radians."""
    pair = angles_in_rad(angles)
    # a smaller angle with decimals was probably given in radians
    warn_of_radians([degrees(angle) for angle in pair if angle], 7.0)
    return pair


def warn_of_radians(angles: Sequence[float], least: float) -> None:
    """Warn if all angles, in degrees, have decimals and are smaller than `least`."""
    nonzero = [angle for angle in angles if angle]
    if nonzero and all(abs(angle) < least and round(angle, 9) % 1 for angle in nonzero):
        listed = ", ".join(f"{angle:.4g}" for angle in nonzero)
        warn(
            note(
                "Angles are in degrees, and {shown} is small. Convert radians with numpy.degrees(...).",
                shown=listed,
            )
        )


def clamped_wire(
    start: Any, end: Any, length: Any, *, angles: object, buckling: int, **others: Any
) -> tuple[ElasticaBetween, Shape]:
    """Return the rod of `elastica_between`, and its curve as a TopoDS_Wire at the height of its ends.

    The angles are in degrees.
    """
    mode = whole_number(buckling, "buckling", 1)
    rows = [_read_point(point) for point in (start, end) if point is not None]
    heights = [row[2] if len(row) == 3 else 0.0 for row in rows] or [0.0]
    if abs(heights[0] - heights[-1]) > 1e-6:
        raise InputError(
            "start and end are {apart:.4g} apart in z. Pass points with the same z, in the plane of the curve.",
            apart=Length(abs(heights[0] - heights[-1])),
        )
    first, last = (_read_point(point)[:2] or point for point in (start, end))
    rod = elastica_between(first, last, length, angles=end_angles(angles), mode=mode, **others)
    return rod, make_wire(Path([Spline(rod.curve)]), Frame((0.0, 0.0, heights[0])))


def warn(text: str) -> None:
    """Issue a warning at the line of the user's script."""
    depth, caller = 2, sys._getframe(1)
    skipped = ("elastica_cad", "build123d", "cadquery")
    while caller.f_back is not None and str(caller.f_globals.get("__name__")).split(".")[0] in skipped:
        depth, caller = depth + 1, caller.f_back
    warnings.warn(printable(text), StripWarning, stacklevel=depth)


def warn_of_strip(strip: Strip) -> None:
    """Warn if a strip is strained beyond the limit of its sheet, or intersects itself when bent."""
    for text in strip.strain_warnings[:1]:
        warn(text)
    meeting = self_contact(strip)
    if meeting is not None:
        low, high = meeting
        warn(note(
            "The bent strip intersects itself: its places {low} and {high} from the start of the bend are "
            "at one point (places below 0 or above {length} are on the tabs). Shorten the tabs, open the "
            "curve, or cut a slot at this point.",
            low=Length(low), high=Length(high), length=Length(strip.rod.length),
        ))  # fmt: skip


class TupleLike(Protocol):
    """Interface of a vector with a method `toTuple`, such as a CadQuery vector."""

    def toTuple(self) -> tuple[float, float, float]:
        """Return the coordinates."""


class LocationLike(Protocol):
    """Interface of a location of build123d or CadQuery."""

    @property
    def wrapped(self) -> Any:
        """Location of the kernel."""


Point: TypeAlias = Iterable[float] | TupleLike | LocationLike
"""Point in space, position of a location, or two coordinates in the frame of a body, mm."""


def numbers_of(point: Point) -> tuple[float, ...]:
    """Return the coordinates of a sequence, or of a vector or location of build123d or CadQuery.

    Raises
    ------
    TypeError, ValueError
        The object is neither a sequence of numbers nor a vector.
    """
    wrapped = getattr(point, "wrapped", None)
    if isinstance(wrapped, kernel().TopLoc_Location):
        return coordinates(wrapped.Transformation().TranslationPart())
    numbers: Any = point.toTuple() if hasattr(point, "toTuple") else point
    if isinstance(numbers, str | bytes):
        raise TypeError
    return tuple(map(float, numbers))


def _read_point(point: Any) -> tuple[float, ...]:
    # return the two or three coordinates of a point, or () if the object is not a point
    try:
        row = numbers_of(point)
    except (TypeError, ValueError):
        row = ()
    return row if len(row) in (2, 3) else ()


def color_numbers(color: Any) -> tuple[float, ...]:
    """Return a colour as 3 or 4 numbers from 0 to 1. `color` is a colour of a library, a name, or numbers."""
    k = kernel()
    named = k.Quantity_Color()
    read = k.Quantity_Color.ColorFromHex_s if str(color).startswith("#") else k.Quantity_Color.ColorFromName_s
    try:
        if isinstance(color, str) and read(color, named):
            return tuple(named.Values(k.Quantity_TypeOfColor.Quantity_TOC_sRGB))
        row = numbers_of(color)
    except (TypeError, ValueError):
        row = ()
    if len(row) not in (3, 4) or not all(0 <= part <= 1 for part in row):
        raise InputError(
            f"color is {color!r}. Pass a CAD library's Color, its name, or red, green and blue from 0 to 1."
        )
    return row


class BendOptions(TypedDict, total=False):
    """Options for moving and turning the ends of a strip: see `mechanics.bend`."""

    end: Annotated[
        "Point | None",
        "Final position of the end: a point in space, or two numbers in the body's `frame` (mm).",
    ]
    start: Annotated[
        "Point | None",
        "Final position of the start: a point in space, or two numbers in the body's `frame` (mm).",
    ]
    angles: Annotated[
        "tuple[float | None, float | None] | ArrayLike | None",
        "Directions of start and end in this frame, counted along the strip; None for no change (degrees).",
    ]
    gravity: Annotated["Any", "A `Gravity`, or None for no weight; by default the gravity of the strip."]
    supports: Annotated["Supports | None", "Supports of the ends; by default the supports of the strip."]
    force: Annotated[
        "ArrayLike | None",
        "Dead force on ends that are free to move, over the least bending stiffness (1/mm2).",
    ]
    moment: Annotated[
        "float | tuple[float, float] | None",
        "Moment on ends that are free to turn, anticlockwise, over the least bending stiffness (1/mm).",
    ]
    guess: Annotated["Any", "A `Rod` to start from, or angles of its nodes (rad)."]
    side: Annotated["int | None", "To which side a straight strip bulges: 1 for left, -1 for right."]
    mode: Annotated["int", "Buckling mode in which a straight strip bulges, from 1."]
    samples: Annotated["int | None", "Nodes of the rod."]
    settle: Annotated["bool", "An unstable shape is replaced by the stable shape that it snaps to."]


@dataclass(frozen=True, eq=False)
class MadeStrip:
    """Strip from which a body was made, with its position. Copies of the body share this record.

    Attributes
    ----------
    strip : Strip
    frame : Frame
        Plane of the strip's curve.
    deviation : float
        Largest distance of the strip from the drawn curve, mm; 0 if neither limits nor smoothing changed the curve.
    home : Frame or None
        Frame of the joint "start" of a bent body when it was made; None for other bodies.
    color: tuple[float, ...] or None
        Requested screen colour of the body: red, green, blue and optionally opacity, each from 0 to 1.
    block : EndFixture or None
        The body itself, if it is a block that holds an end; None for a body of the strip.
    """

    strip: Strip
    frame: Frame
    deviation: float = 0.0
    home: Frame | None = None
    color: tuple[float, ...] | None = None
    block: "EndFixture | None" = None

    def __deepcopy__(self, memo: dict[int, Any]) -> "MadeStrip":
        return self

    def body(self, *, bent: bool) -> "tuple[Sequence[BodyRecord], MadeStrip]":
        """Return the solids of the flat or the bent strip, and the record of a body made of them."""
        if not bent:
            return FlatSolid.layers(self.strip), self
        solids = BentSolid.layers(self.strip, self.frame)
        return solids, replace(self, home=solids[0].joints["start"])

    def mirrored(self) -> "MadeStrip":
        """Return the record of the mirrored body, with the mirrored strip."""
        return replace(self, strip=self.strip.mirrored())

    @property
    def name(self) -> str:
        """Name of the bodies of the strip."""
        return self.strip.label or "strip"

    @property
    def body_color(self) -> tuple[float, ...]:
        """Screen colour of the bodies of the strip."""
        return self.color or sheet_color(self.strip.sheet)

    @property
    def face(self) -> Shape:
        """Flat pattern as a TopoDS_Face."""
        holes = [in_smooth_pieces(hole, 1) for hole in self.strip.holes]
        return make_face(in_smooth_pieces(self.strip.outline), holes)


class SlidingEnd:
    """Animation of a strip whose end moves, common to the sliders of all CAD libraries."""

    travel: Any
    parent: Any

    @property
    def _frame(self) -> Frame:
        """Current plane of the strip. The plane moves with the body when the body is joined to others."""
        return self.parent.frame if isinstance(self.parent, StripBody) else self.travel.frame

    def write_glb(
        self, path: str | PathLike[str], *, frames: int = 25, seconds: float = 4.0, force: bool = False
    ) -> None:
        """Write an animation of the movement, forward and backward.

        An existing file is overwritten only with `force`.
        """
        moved, color = replace(self.travel, frame=self._frame), self.parent._changed_color
        moved.write_glb(path, frames=frames, seconds=seconds, color=color, force=force)


class StripBody:
    """Properties that a body of a strip has in every CAD library."""

    _made: MadeStrip
    _is_strip = True
    _label = ""
    color: Any
    wrapped: Any

    def __repr__(self) -> str:
        # a rounded body of CadQuery has no strip
        made: MadeStrip | None = self.__dict__.get("_made")
        if made is None:
            return super().__repr__()
        return f"<{type(self).__name__} {self.label!r} of {made.strip!r}>"

    @property
    def label(self) -> str:
        """Name of the body and of its strip. Bodies that are made from this body have the same name."""
        return self._label

    @label.setter
    def label(self, label: str) -> None:
        changed, self._label = label != self._label, label
        made: MadeStrip | None = self.__dict__.get("_made")
        if made is not None and self._is_strip and changed and label and label != made.name:
            self._made = replace(made, strip=made.strip.labelled(label))

    def _start(self) -> Frame | None:
        # return the present frame of the joint "start", or None for a body without it
        raise NotImplementedError

    @property
    def strip(self) -> Strip:
        """Strip with its widths, outline, strain and mass."""
        return self._made.strip

    @property
    def deviation(self) -> float:
        """Largest distance of the strip from the drawn curve, mm; 0 if the curve was not changed."""
        return self._made.deviation

    @property
    def frame(self) -> Frame:
        """Plane of the curve. For a bent body, the plane moves with the body; else it is the drawn plane."""
        home, now = self._made.home, self._start()
        return self._made.frame if home is None or now is None else self._made.frame.carried(home, now)

    @property
    def rod(self) -> Rod:
        """Rod with the shape, stiffness, moments and forces of the bent strip."""
        return self.strip.rod

    @property
    def check(self) -> EquilibriumCheck | None:
        """Result of the check of the drawn curve (paper, Theorem 1), or None if the curve was not checked."""
        return self.rod.check

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the strip, and for a block also about its pocket."""
        block = self._made.block
        return (*self.strip.warnings, *(() if block is None else block.warnings))

    def drawing(self) -> Drawing:
        """Return the drawing of the flat strip. A block is not cut from a sheet and has none."""
        if not self._is_strip:
            raise InputError(f"{self.label} is a block, which has no flat pattern. Write it as STEP or STL.")
        return self.strip.drawing()

    def _named_parts(self: Any) -> Sequence[Any]:
        # return the parts of the body for files, with names and colours: the sheets of a bent strip
        return (self,) if self._made.home is None else self.layers

    @property
    def placed(self) -> Placed:
        """Strip with its position in space, for `Model`."""
        frame = self.frame
        return Placed(self.strip, frame.origin, frame.x_axis, frame.y_axis, self._changed_color)

    @property
    def _changed_color(self) -> tuple[float, ...] | None:
        # colour that the user has set, or None if the body has the colour of its sheet
        color = color_numbers(self.color) if self._is_strip and self.color is not None else ()
        usual = (*sheet_color(self.strip.sheet), 1.0)
        # components of equal colours differ by rounding errors
        differs = any(abs(a - b) > 1e-6 for a, b in zip(color, usual, strict=False))
        return color if differs else None

    def _bent_anew(self, moved: BendOptions) -> Strip:
        """Return the strip, bent to other positions or angles of its ends. Points may be in space."""
        refuse_unknown(moved, BendOptions.__annotations__, "bending a strip")
        led: dict[str, Any] = dict(moved)
        for name in ("start", "end"):
            if led.get(name) is not None:
                led[name] = self._in_plane(led[name], name)
        if led.get("angles") is not None:
            led["angles"] = end_angles(led["angles"])
        return replace(self.strip, rod=bend(self.strip.rod_to_bend, **led))

    def _in_plane(self, point: Point, name: str) -> tuple[float, ...]:
        """Return a point, mm, in the plane of the strip. A point in space must be on this plane."""
        row = _read_point(point)
        if len(row) == 2:
            return row
        if not row:
            raise InputError(
                f"{name} is {point!r}. Pass a point in space, or two numbers in the strip's frame, in mm."
            )
        x, y, z = self.frame.local(row).tolist()
        # beyond 100 mm from the origin, the limit grows with the distance
        if abs(z) > 1e-4 * max(1.0, hypot(x, y) / 100):
            raise InputError(
                "{name} is {z:.4g} away from the plane in which the strip bends. Pass a point in this plane.",
                name=name,
                z=Length(abs(z)),
            )
        return x, y

    def _layers(self) -> Iterator[tuple[Shape, str, tuple[float, ...]]]:
        # yield shape, name and colour of each sheet of the bent strip
        from elastica_cad.model.assembly import bent_names

        names = bent_names(self._made.name, self.strip)
        records = BentSolid.layers(self.strip, self.frame)
        yield from zip(make_sheets(records), names, bent_colors(self.strip, self._changed_color), strict=True)

    def _engraving(self) -> list[Shape]:
        face, strokes = self._engraved_face(), self.strip.drawing().strokes
        return [make_wire(stroke.path, face) for stroke in strokes if stroke.layer == ENGRAVE]

    def _engraved_face(self) -> Frame:
        """Return the plane of an outline or the upper face of a flat body, at its position; else that of `flat`."""
        faces = sub_shapes(self.wrapped, "face")
        if len(faces) == 1:
            return face_frame(faces[0])
        upper, now = Frame((0.0, 0.0, self.strip.layers[0].high)), self._start()
        if self._made.home is not None or now is None:
            return upper
        return upper.carried(FlatSolid.of(self.strip).joints["start"], now)

    def _backing_of(self, layers: Sequence[T]) -> T:
        # `layers` are the sheets of this strip, the base first
        if len(self.strip.layers) == 1:
            raise InputError("The strip has no backing. Use style=Laminated(width=..., backing=...).")
        return layers[1]
