"""Curves defined in a design file, and handles that reshape them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray, Pair
from elastica_cad.declared import Kind, Option, kind_of
from elastica_cad.design.records import Reader, reads
from elastica_cad.design.tables import Formula, Table
from elastica_cad.errors import BareLength, InputError, Length
from elastica_cad.formats.drawn_file import CurveList
from elastica_cad.formats.source_file import file_in
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import box_around
from elastica_cad.geometry.projective_maps import four_point_map

Handles: TypeAlias = tuple[Pair, Pair, Pair, Pair]

_TO = "New position of the {} corner of the curve's bounding box."

CORNERS = ("bottom_left", "bottom_right", "top_right", "top_left")
"""Names of the corners of the drawn curves' bounding box, which serve as handles."""


def map_corners(curves: Sequence[PlaneCurve], places: Mapping[str, ArrayLike]) -> FloatArray:
    """Return the projective map (3, 3) that moves corners of the curves' bounding box to `places`, mm.

    Corners that are not in `places` keep their positions.

    Examples
    --------
    >>> arch = PlaneCurve.arc((0, 0), 50, 0, np.pi)
    >>> leaning = arch.transformed(map_corners([arch], {"top_right": (70, 60)}))
    >>> leaning.bounds.round(6).tolist()[0]
    [-50.0, 0.0]
    """
    (left, low), (right, high) = box_around(np.array([curve.bounds for curve in curves]))
    if min(right - left, high - low) <= 1e-9 * max(right - left, high - low):
        raise InputError(
            "The bounding box of the curve measures {left:.4g} by {low:.4g}, too thin for handles at its "
            "corners. Set four handles instead.",
            left=BareLength(right - left),
            low=Length(high - low),
        )
    before = [(left, low), (right, low), (right, high), (left, high)]
    after = [np.asarray(places.get(name, corner)) for name, corner in zip(CORNERS, before, strict=True)]
    return four_point_map(before, after)


@dataclass(frozen=True)
class Reshape:
    """Deformation that moves some corners of a curve's bounding box, or four `handles`, to new positions."""

    bottom_left: Annotated[Pair | None, Option(_TO.format("lower left"), "mm")] = None
    bottom_right: Annotated[Pair | None, Option(_TO.format("lower right"), "mm")] = None
    top_right: Annotated[Pair | None, Option(_TO.format("upper right"), "mm")] = None
    top_left: Annotated[Pair | None, Option(_TO.format("upper left"), "mm")] = None
    handles: Annotated[
        Handles | None,
        Option("Positions of four handles, instead of corners.", "mm", needs="to", replaces=CORNERS),
    ] = None
    to: Annotated[Handles | None, Option("New positions of the handles.", "mm", needs="handles")] = None

    def __post_init__(self) -> None:
        if not (self.handles or self.corners):
            raise InputError(
                "New positions are missing. Set corners of the curve's bounding box ({corners}), or four "
                "handles and four points `to`.",
                corners=", ".join(CORNERS),
            )

    @property
    def corners(self) -> dict[str, Pair]:
        """New positions of the named corners, mm."""
        return {name: place for name in CORNERS if (place := getattr(self, name)) is not None}

    def of(self, curve: PlaneCurve) -> PlaneCurve:
        """Return the curve after the handles are moved to their new positions."""
        if self.handles is not None and self.to is not None:
            return curve.transformed(four_point_map(self.handles, self.to))
        return curve.transformed(map_corners([curve], self.corners))


@dataclass(frozen=True)
class _Curve:
    reshape: Annotated[Reshape | None, Option("Deform the curve by moving four handles.")] = None


@dataclass(frozen=True, kw_only=True)
class CurveOfFile(_Curve):
    """Table of a curve in a file. `number`, `id` or `layer` selects one of several curves.

    In `file`, `id` and `layer`, {i} stands for the number of the strip, as in labels.
    """

    file: Annotated[str, Option("Name of a file with curves, relative to the design file.")]
    number: Annotated[int | None, Option("Curve of the file.", least=1)] = None
    id: Annotated[
        str | None,
        Option(
            "Name of the curve in the file; may contain the number of the strip, as labels do.",
            replaces=("number",),
        ),
    ] = None
    layer: Annotated[str | None, Option("Layer of the curve.")] = None
    unit: Annotated[str | None, Option("Unit of the file, if the file names none.")] = None

    def drawn(self, reader: Reader, table: Table) -> PlaneCurve:
        """Read the file, and return the curve that the table selects."""
        strip_number = f"{table.scope['i']:g}" if "i" in table.scope else "{i}"
        file, name, layer = (
            text and text.replace("{i}", strip_number) for text in (self.file, self.id, self.layer)
        )
        path = file_in(reader.folder, file or "")
        assert reader.read_curves is not None
        curves = reader.read_curves(path, unit=self.unit)
        # a `CurveList` knows names and layers; another reader returns a plain list
        if isinstance(curves, CurveList):
            number = None if self.number is None else str(self.number)
            return curves.file.one(name or number, layer, "number = 1 .. {count}, id or layer").curve
        if (self.number or 1) > len(curves) or (len(curves) > 1 and self.number is None):
            raise InputError(
                "{place}: {name} has {count} curve{given}. Choose a curve with number = 1 .. {count}.",
                place=table.where,
                name=path.name,
                count=len(curves),
                given="s" if len(curves) > 1 else "",
            )
        return curves[(self.number or 1) - 1]


@dataclass(frozen=True, kw_only=True)
class CurveOfFormulae(_Curve):
    """The table of a curve given by two formulae: x and y, mm, as functions of t."""

    x: Annotated[Formula, Option("Formula in t.", "mm")]
    y: Annotated[Formula, Option("Formula in t.", "mm")]
    t: Annotated[tuple[float, float], Option("Range of t.")]
    breaks: Annotated[
        tuple[Pair, ...],
        Option("Pairs [t, continuity], one for each parameter t at which pieces of the formulae meet."),
    ] = ()

    def drawn(self, _: Reader, table: Table) -> PlaneCurve:
        """Return a spline fitted to points of the formulae."""
        start, end = self.t
        if not start < end:
            raise InputError(
                "{place} is [{start:g}, {end:g}], which is not a range. Write two numbers, the smaller first.",
                place=table.place("t"),
                start=start,
                end=end,
            )

        def point(t: FloatArray) -> FloatArray:
            return np.column_stack([np.broadcast_to(f(table.scope, t=t), t.shape) for f in (self.x, self.y)])

        return PlaneCurve.fit_function(
            point, start, end, breaks=[(place, int(order)) for place, order in self.breaks]
        )


@dataclass(frozen=True)
class EllipseArc:
    """An arc of an ellipse between two parameters, or above a height."""

    semi_axes: Annotated[Pair, Option("Lengths of both semi-axes.", "mm", least=0)]
    center: Annotated[Pair, Option("Centre of the ellipse.", "mm")] = (0.0, 0.0)
    rotation: Annotated[float, Option("Angle of the first axis.", "rad")] = 0.0
    start: Annotated[float | None, Option("Parameter at the start of the arc.", "rad")] = None
    end: Annotated[float | None, Option("Parameter at the end of the arc.", "rad")] = None
    above: Annotated[
        float | None,
        Option(
            "Height above which the arc is used, instead of start and end.", "mm", replaces=("start", "end")
        ),
    ] = None

    def drawn(self, where: str) -> PlaneCurve:
        """Return the arc as an exact rational curve."""
        center, axes, rotation = self.center, self.semi_axes, self.rotation
        if self.above is None:
            end = 2 * np.pi if self.end is None else self.end
            return PlaneCurve.ellipse(center, axes, rotation, self.start or 0.0, end)
        rise = self.above - center[1]
        # height above the centre at the parameter v, for half axes a and b:
        # a sin(rotation) cos(v) + b cos(rotation) sin(v) = reach cos(v - top)
        tall = axes[0] * np.sin(rotation), axes[1] * np.cos(rotation)
        reach, top = float(np.hypot(*tall)), float(np.arctan2(tall[1], tall[0]))
        if not -reach < rise < reach:
            raise InputError(
                "{place}: y = {rise:.4g} does not cut the ellipse. Choose a height between {reach:.4g} and "
                "{reach_2:.4g}.",
                place=f"{where}: above",
                reach=BareLength(center[1] - reach),
                reach_2=Length(center[1] + reach),
                rise=Length(rise + center[1]),
            )
        half = float(np.arccos(rise / reach))
        return PlaneCurve.ellipse(center, axes, rotation, top - half, top + half)


@dataclass(frozen=True, kw_only=True)
class CurveOfEllipse(_Curve):
    """The table of a curve with the key `ellipse`: an exact arc of an ellipse."""

    ellipse: Annotated[EllipseArc, Option("An exact arc of an ellipse.")]

    def drawn(self, _: Reader, table: Table) -> PlaneCurve:
        """Return the arc as an exact rational curve."""
        return self.ellipse.drawn(table.place("ellipse"))


@dataclass(frozen=True, kw_only=True)
class CurveOfSpline(_Curve):
    """The table of a curve with the key `spline`: a B-spline given by its control points.

    By default its knots are uniform and clamped. With given knots, it may have weights (NURBS).
    """

    spline: Annotated[tuple[Pair, ...], Option("Control points.", "mm")]
    degree: Annotated[int, Option("Degree of the spline.", least=1)] = 4
    knots: Annotated[
        tuple[float, ...] | None, Option("Full knot vector; by default evenly spaced with clamped ends.")
    ] = None
    weights: Annotated[
        tuple[float, ...] | None, Option("Weights of the control points; by default equal.", needs="knots")
    ] = None

    def drawn(self, _: Reader, __: Table) -> PlaneCurve:
        """Return the B-spline exactly as it is given."""
        if self.knots is None:
            return PlaneCurve.spline(self.spline, degree=self.degree)
        weights = None if self.weights is None else np.array(self.weights)
        return PlaneCurve(np.array(self.knots), np.array(self.spline), self.degree, weights)


CURVES = {"file": CurveOfFile, "x": CurveOfFormulae, "ellipse": CurveOfEllipse, "spline": CurveOfSpline}
"""Record class of each kind of drawn curve, by the key that its table must contain."""


def read_drawn_curve(reader: Reader, table: Table, key: str = "curve") -> PlaneCurve:
    """Return the curve that the value of a key describes: the name of a file, or a table."""
    value = table.raw(key)
    if value is None:
        raise InputError(
            "{place} is missing. Add a file, formulae x and y with the range t, an ellipse or a spline.",
            place=table.place(key),
        )
    # a name of a file is short for a table with the key `file`
    named = isinstance(value, str)
    curve = Table({"file": value}, table.place(key), table.scope) if named else table.table(key)
    kinds = [kind for kind in CURVES if kind in curve.data]
    if len(kinds) != 1:
        raise InputError(
            (
                "{place} has {given}, but needs exactly one of the keys 'file', 'x' (with 'y' and 't'), "
                "'ellipse' and 'spline'. Use one of these keys."
            ),
            place=curve.where,
            given=", ".join(curve.data) or "no keys",
        )
    request = reader.record(CURVES[kinds[0]], curve)
    with curve.naming():
        drawn: PlaneCurve = request.drawn(reader, curve)
        return drawn if request.reshape is None else request.reshape.of(drawn)


reads(
    PlaneCurve,
    Kind("either", (Kind("text"), *(kind_of(record) for record in CURVES.values()))),
    read_drawn_curve,
)
