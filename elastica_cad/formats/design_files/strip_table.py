"""What a design file says about one strip: its curve, its place in space, and how it is made."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.formats.curve_files.drawn_file import CurveList
from elastica_cad.formats.design_files.formulae import Formula
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.reshaping import reshape_curve
from elastica_cad.formats.design_files.rod_records import (
    read_keep,
    read_limits,
    read_loads,
    read_rest_curvature,
    read_supports,
)
from elastica_cad.formats.design_files.strip_records import (
    find_sheet,
    read_law,
    read_shop,
    read_slot,
    read_style,
    read_tabs,
    read_tolerance,
)
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, RestCurvature
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.refusals import Length

if TYPE_CHECKING:
    from elastica_cad.forming.plane_sections.section_curves import SectionCurve

CurveReader: TypeAlias = Callable[..., list[PlaneCurve]]
"""`read_curves(path, unit=...)`."""


@dataclass(frozen=True, eq=False)
class StripEntry:
    """One strip of a design file.

    Attributes
    ----------
    spec : StripSpec
        What is asked.
    section : str
        The section of a surface that it follows and where that begins, else empty.
    off_section : float
        Largest distance of that section's points from the curve, mm.
    """

    spec: StripSpec
    section: str = ""
    off_section: float = 0.0

    @property
    def label(self) -> str:
        """Engraved on the strip, and its name in messages."""
        return self.spec.label

    @property
    def curve(self) -> PlaneCurve:
        """As drawn."""
        return self.spec.curve

    @property
    def sheet(self) -> Sheet:
        """What the strip is cut from."""
        return self.spec.material

    @property
    def frame(self) -> Frame:
        """The plane that the curve is drawn in."""
        return self.spec.frame or Frame()

    @property
    def called(self) -> str:
        """Label, and section where there is one."""
        return f"{self.label} ({self.section})" if self.section else self.label


def read_strip(
    table: Table,
    label: str,
    folder: Path,
    sheets: dict[str, Sheet],
    read_curves: CurveReader,
    section: "SectionCurve | None" = None,
) -> StripEntry:
    """The strip that one table of strips asks for, its formulae computed; a `section` brings curve and plane.

    Raises
    ------
    InputError
        Unknown keys or values, missing files, curves that make no sense; the place is named.
    """
    sheet = find_sheet(table, "sheet", sheets)
    frame = _plane(table) if section is None else section.frame
    limited = table.has("limits") or table.has("keep")
    asked: dict[str, Any] = {
        "max_width": table.maybe("max_width"),
        "min_width": table.maybe("min_width"),
        "gravity": _gravity(table),
        "loads": read_loads(table),
        "supports": read_supports(table),
        "natural_curvature": _natural_curvature(table, folder, read_curves),
        "samples": table.count("samples", 1) if table.has("samples") else None,
        "limits": read_limits(table.table("limits"), sheet) if limited else None,
        "keep": read_keep(table.table("keep")) if limited else None,
        "ends": read_tabs(table),
        "joint": table.maybe("joint"),
        "style": read_style(table.table("style"), sheets),
        "slots": tuple(read_slot(slot) for slot in table.tables("slots")),
        "smooth": table.maybe("smooth"),
        "shop": read_shop(table.table("shop")),
        "compensate": table.flag("compensate") if table.has("compensate") else None,
        "creep": table.number("creep", 0.0),
        "law": read_law(table.table("law"), sheet) if table.has("law") else None,
        "ignore_limits": table.flag("ignore_limits"),
        "tolerance": read_tolerance(table.table("tolerance")),
    }
    curve = read_drawn_curve(table, folder, read_curves) if section is None else section.curve
    with table.naming():
        spec = StripSpec(curve, sheet, frame, label=label, **asked)
    if section is None:
        return StripEntry(spec)
    return StripEntry(spec, section.called, section.deviation)


def _plane(table: Table) -> Frame:
    origin = table.vector("origin", 3, (0.0, 0.0, 0.0))
    x_axis = table.vector("x_axis", 3, (1.0, 0.0, 0.0))
    y_axis = table.vector("y_axis", 3, (0.0, 0.0, 1.0))
    with table.naming():
        return Frame(origin, x_axis, y_axis)


def _natural_curvature(table: Table, folder: Path, read_curves: CurveReader) -> NaturalCurvature:
    """A number, a table of stations and curvatures, or one with the curve in which the blank lies unbent."""
    if not isinstance(table.raw("natural_curvature"), dict):
        return table.number("natural_curvature", 0.0)
    blank = table.table("natural_curvature")
    if not blank.has("curve"):
        return read_rest_curvature(blank)
    with blank.only(*STRIP_TABLES["blank drawn"]).naming():
        return RestCurvature.of(read_drawn_curve(blank, folder, read_curves))


def read_drawn_curve(table: Table, folder: Path, read_curves: CurveReader) -> PlaneCurve:
    """The curve that the key `curve` tells of."""
    given = table.raw("curve")
    if given is None:
        raise InputError(
            "{place} is missing; give a file, formulae x, y and t, an ellipse or a spline",
            place=table.place("curve"),
        )
    if isinstance(given, str):
        return _from_file(Table({"file": given}, table.place("curve"), table.scope), folder, read_curves)
    curve = table.table("curve")
    kinds = {"file": _from_file, "x": _from_formulae, "ellipse": _from_ellipse, "spline": _from_spline}
    found = [kind for kind in kinds if kind in curve.data]
    if len(found) != 1:
        raise InputError(
            "{where_} must hold one of file, x (with y and t), ellipse or spline, not {value}",
            where_=curve.where,
            value=", ".join(curve.data) or "nothing",
        )
    with curve.naming():
        drawn = kinds[found[0]](curve, folder, read_curves)
    return reshape_curve(drawn, curve.table("reshape")) if curve.has("reshape") else drawn


def _from_file(curve: Table, folder: Path, read_curves: CurveReader) -> PlaneCurve:
    curve.only(*STRIP_TABLES["curve file"])
    path = folder / curve.text("file")
    if not path.is_file():
        raise InputError(
            "{where_}: there is no file {path}; names are relative to the design file",
            where_=curve.where,
            path=path,
        )
    curves = read_curves(path, unit=curve.text("unit") if curve.has("unit") else None)
    number = curve.count("number", 1)
    if isinstance(curves, CurveList):
        with curve.naming():
            return curves.file.one(
                curve.text("id") if curve.has("id") else str(number) if curve.has("number") else None,
                curve.text("layer") if curve.has("layer") else None,
                "number = 1 .. {count}, id or layer",
            ).curve
    if number > len(curves) or (len(curves) > 1 and not curve.has("number")):
        raise InputError(
            "{where_}: {name} holds {count} curve{value}: choose one with number = 1 .. {count}",
            where_=curve.where,
            name=path.name,
            count=len(curves),
            value="s" if len(curves) > 1 else "",
        )
    return curves[number - 1]


def _from_formulae(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    curve.only(*STRIP_TABLES["curve formulae"])
    x, y = (Formula(str(curve.raw(key, "")), curve.place(key)) for key in ("x", "y"))
    start, end = curve.vector("t", 2)
    if not start < end:
        raise InputError(
            "{place} is [{start:g}, {end:g}]: it must be a range, least first",
            place=curve.place("t"),
            start=start,
            end=end,
        )
    breaks = curve.raw("breaks", [])
    if not isinstance(breaks, list):
        raise InputError("{place} must be a list of [t, continuity]", place=curve.place("breaks"))
    pairs = [Table({"at": one}, curve.place("breaks"), curve.scope).vector("at", 2) for one in breaks]

    def point(t: FloatArray) -> FloatArray:
        columns = [np.broadcast_to(f(curve.scope, t=t), t.shape) for f in (x, y)]
        return np.column_stack(columns)

    return PlaneCurve.fit_function(point, start, end, breaks=[(t, int(order)) for t, order in pairs])


def _from_ellipse(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    """An exact ellipse arc, between two parameters or above a height."""
    given = curve.only(*STRIP_TABLES["curve ellipse"]).table("ellipse").only(*STRIP_TABLES["ellipse"])
    center, axes = given.vector("center", 2, (0.0, 0.0)), given.vector("semi_axes", 2)
    rotation = given.number("rotation", 0.0)
    if not given.has("above"):
        full = 2 * np.pi
        return PlaneCurve.ellipse(
            center, axes, rotation, given.number("start", 0.0), given.number("end", full)
        )
    idle = [key for key in ("start", "end") if given.has(key)]
    if idle:
        raise InputError(
            "{place} means nothing beside above: leave one of them out", place=given.place(idle[0])
        )
    rise = given.number("above") - center[1]
    # y - center = a sin(rotation) cos v + b cos(rotation) sin v = reach cos(v - top)
    tall = axes[0] * np.sin(rotation), axes[1] * np.cos(rotation)
    reach, top = float(np.hypot(*tall)), float(np.arctan2(tall[1], tall[0]))
    if not -reach < rise < reach:
        raise InputError(
            "{place}: the ellipse lies between y = {reach:.4g} and {reach_2:.4g}, so y = "
            "{rise:.4g} does not cut it",
            place=given.place("above"),
            reach=center[1] - reach,
            reach_2=Length(center[1] + reach),
            rise=Length(rise + center[1]),
        )
    half = float(np.arccos(rise / reach))
    return PlaneCurve.ellipse(center, axes, rotation, top - half, top + half)


def _from_spline(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    curve.only(*STRIP_TABLES["curve spline"])
    return PlaneCurve.spline(curve.points("spline", 2), degree=curve.count("degree", 4))


def _gravity(table: Table) -> Gravity | tuple[float, ...] | None:
    """The direction in space in which the sheet's weight falls, -z unless told; or a `length` of its own."""
    given = table.raw("gravity", False)
    if isinstance(given, bool):
        return (0.0, 0.0, -1.0) if given else None
    if not isinstance(given, dict):
        return table.vector("gravity", 3)
    own = table.table("gravity").only(*STRIP_TABLES["gravity"])
    with own.naming():
        x, y = own.vector("direction", 2, (0.0, -1.0))
        return Gravity(own.number("length"), (x, y))
