"""What a design file says about one strip: its curve, its place in space, and how it is made."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication import Frame, Hole, Laminated, Perforated, Plain, Slot, Tab, TSlot
from elastica_cad.formats.formulae import Formula
from elastica_cad.formats.reshaping import reshaped_as
from elastica_cad.formats.tables import Table
from elastica_cad.forming import Keep, Limits, SectionCurve
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, Sheet, Supports

__all__ = ["STRIP_KEYS", "CurveReader", "StripWish", "drawn_curve", "named_sheet", "strip_wish", "tabs"]

CurveReader: TypeAlias = Callable[..., list[PlaneCurve]]
"""`read_curves(path, unit=...)`."""

MAKING_KEYS = (
    "sheet", "max_width", "min_width", "gravity", "supports", "natural_curvature", "limits", "keep", "ends",
    "style",
)  # fmt: skip
"""Keys that may stand for all strips at the top of the file or for some in [[strips]]."""

STRIP_KEYS = (
    *MAKING_KEYS, "label", "count", "let", "curve", "sections", "origin", "x_axis", "y_axis", "slots",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class StripWish:
    """One strip to be made.

    Attributes
    ----------
    label : str
    curve : PlaneCurve
    frame : Frame
        The plane that the curve is drawn in.
    sheet : Sheet
    making : dict
        Arguments of `make_strip` besides curve, sheet and label.
    where : str
        What messages call it.
    section : str
        The section of a surface that it follows and where that begins, else empty.
    off_section : float
        Largest distance of that section's points from the curve, mm.
    """

    label: str
    curve: PlaneCurve
    frame: Frame
    sheet: Sheet
    making: dict[str, Any] = field(default_factory=dict)
    where: str = ""
    section: str = ""
    off_section: float = 0.0

    @property
    def called(self) -> str:
        """Label, and section where there is one."""
        return f"{self.label} ({self.section})" if self.section else self.label


def strip_wish(
    table: Table,
    label: str,
    folder: Path,
    sheets: dict[str, Sheet],
    read_curves: CurveReader,
    section: SectionCurve | None = None,
) -> StripWish:
    """The wish that one table of strips makes, its formulae computed; of a `section` curve and plane are known.

    Raises
    ------
    InputError
        Unknown keys or values, missing files, curves that make no sense; the place is named.
    """
    sheet = named_sheet(table, "sheet", sheets)
    frame = _plane(table) if section is None else section.frame
    limited = table.has("limits") or table.has("keep")
    making: dict[str, Any] = {
        "max_width": table.maybe("max_width"),
        "min_width": table.maybe("min_width"),
        "gravity": _gravity(table, sheet, frame),
        "supports": _supports(table),
        "natural_curvature": table.number("natural_curvature", 0.0),
        "limits": _limits(table.table("limits"), sheet) if limited else None,
        "keep": _keep(table.table("keep")) if limited else None,
        "ends": tabs(table),
        "style": _style(table.table("style"), sheets),
        "slots": tuple(_slot(slot) for slot in table.tables("slots")),
    }
    curve = drawn_curve(table, folder, read_curves) if section is None else section.curve
    wish = StripWish(label, curve, frame, sheet, making, table.where)
    if section is None:
        return wish
    return replace(wish, section=section.called, off_section=section.deviation)


def _plane(table: Table) -> Frame:
    origin = table.vector("origin", 3, (0.0, 0.0, 0.0))
    x_axis = table.vector("x_axis", 3, (1.0, 0.0, 0.0))
    y_axis = table.vector("y_axis", 3, (0.0, 0.0, 1.0))
    with table.naming():
        return Frame(origin, x_axis, y_axis)


def named_sheet(table: Table, key: str, sheets: dict[str, Sheet]) -> Sheet:
    """One of the design's own sheets, or a built-in one."""
    if not table.has(key):
        raise InputError(f'{table.place(key)} is missing; name a sheet, e.g. sheet = "birch-plywood-0.8"')
    name = table.text(key)
    with table.naming(key):
        return sheets[name] if name in sheets else Sheet.named(name)


def drawn_curve(table: Table, folder: Path, read_curves: CurveReader) -> PlaneCurve:
    """The curve that the key `curve` tells of."""
    given = table.raw("curve")
    if given is None:
        raise InputError(
            f"{table.place('curve')} is missing; give a file, formulae x, y and t, an ellipse or a spline"
        )
    if isinstance(given, str):
        return _from_file(Table({"file": given}, table.place("curve"), table.scope), folder, read_curves)
    curve = table.table("curve")
    kinds = {"file": _from_file, "x": _from_formulae, "ellipse": _from_ellipse, "spline": _from_spline}
    found = [kind for kind in kinds if kind in curve.data]
    if len(found) != 1:
        raise InputError(
            f"{curve.where} must hold one of file, x (with y and t), ellipse or spline, not "
            f"{', '.join(curve.data) or 'nothing'}"
        )
    drawn = kinds[found[0]](curve, folder, read_curves)
    return reshaped_as(drawn, curve.table("reshape")) if curve.has("reshape") else drawn


def _from_file(curve: Table, folder: Path, read_curves: CurveReader) -> PlaneCurve:
    curve.only("file", "number", "unit", "reshape")
    path = folder / curve.text("file")
    if not path.is_file():
        raise InputError(f"{curve.where}: there is no file {path}; names are relative to the design file")
    curves = read_curves(path, unit=curve.raw("unit"))
    number = curve.count("number", 1)
    if number > len(curves) or (len(curves) > 1 and not curve.has("number")):
        raise InputError(
            f"{curve.where}: {path.name} holds {len(curves)} curve{'s' if len(curves) > 1 else ''}: choose one "
            f"with number = 1 .. {len(curves)}"
        )
    return curves[number - 1]


def _from_formulae(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    curve.only("x", "y", "t", "breaks", "reshape")
    x, y = (Formula(str(curve.raw(key, "")), curve.place(key)) for key in ("x", "y"))
    start, end = curve.vector("t", 2)
    if not start < end:
        raise InputError(f"{curve.place('t')} is [{start:g}, {end:g}]: it must be a range, least first")
    breaks = curve.raw("breaks", [])
    if not isinstance(breaks, list):
        raise InputError(f"{curve.place('breaks')} must be a list of [t, continuity]")
    pairs = [Table({"at": one}, curve.place("breaks"), curve.scope).vector("at", 2) for one in breaks]

    def point(t: FloatArray) -> FloatArray:
        columns = [np.broadcast_to(f(curve.scope, t=t), t.shape) for f in (x, y)]
        return np.column_stack(columns)

    return PlaneCurve.fit_function(point, start, end, breaks=[(t, int(order)) for t, order in pairs])


def _from_ellipse(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    """An exact ellipse arc, between two parameters or above a height."""
    given = curve.only("ellipse", "reshape").table("ellipse")
    given.only("center", "semi_axes", "rotation", "start", "end", "above")
    center, axes = given.vector("center", 2, (0.0, 0.0)), given.vector("semi_axes", 2)
    rotation = given.number("rotation", 0.0)
    if not given.has("above"):
        full = 2 * np.pi
        return PlaneCurve.ellipse(
            center, axes, rotation, given.number("start", 0.0), given.number("end", full)
        )
    rise = given.number("above") - center[1]
    # y - center = a sin(rotation) cos v + b cos(rotation) sin v = reach cos(v - top)
    tall = axes[0] * np.sin(rotation), axes[1] * np.cos(rotation)
    reach, top = float(np.hypot(*tall)), float(np.arctan2(tall[1], tall[0]))
    if not -reach < rise < reach:
        raise InputError(
            f"{given.place('above')}: the ellipse lies between y = {center[1] - reach:.4g} and "
            f"{center[1] + reach:.4g} mm, so y = {rise + center[1]:.4g} mm does not cut it"
        )
    half = float(np.arccos(rise / reach))
    return PlaneCurve.ellipse(center, axes, rotation, top - half, top + half)


def _from_spline(curve: Table, _folder: Path, _read: CurveReader) -> PlaneCurve:
    curve.only("spline", "degree", "reshape")
    rows = curve.raw("spline")
    if not isinstance(rows, list):
        raise InputError(f"{curve.place('spline')} must be a list of control points [x, y]")
    points = [Table({"point": row}, f"{curve.place('spline')}[{i}]", curve.scope).vector("point", 2)
              for i, row in enumerate(rows, start=1)]  # fmt: skip
    return PlaneCurve.spline(points, degree=curve.count("degree", 4))


def _gravity(table: Table, sheet: Sheet, frame: Frame) -> Gravity | None:
    """The sheet's weight in the plane of the curve; in space things fall along -z unless told."""
    given = table.raw("gravity", False)
    down = (0.0, 0.0, -1.0) if isinstance(given, bool) else table.vector("gravity", 3)
    if given is False or not any(down):
        return None
    return Gravity.in_plane(sheet.elasto_gravity_length, down, frame.x_axis, frame.y_axis)


def _supports(table: Table) -> Supports:
    given = table.raw("supports", ["clamped", "clamped"])
    if not isinstance(given, list) or len(given) != 2:
        raise InputError(f'{table.place("supports")} is {given!r}: name two, e.g. ["clamped", "pinned"]')
    with table.naming("supports"):
        return Supports(*given)


def _limits(table: Table, sheet: Sheet) -> Limits:
    table.only("ratio", "margin", "curvature", "strain", "length", "width")
    keep_strain = table.raw("strain", False)
    ranges: dict[str, Any] = {key: table.vector(key, 2) for key in ("length", "width") if table.has(key)}
    with table.naming():
        return Limits(
            ratio=table.maybe("ratio"),
            margin=table.maybe("margin"),
            curvature=table.maybe("curvature"),
            sheet=sheet if keep_strain else None,
            strain=None if isinstance(keep_strain, bool) else table.number("strain"),
            **ranges,
        )


def _keep(table: Table) -> Keep:
    table.only("ends", "tangents", "length", "symmetry")
    symmetry: Any = table.text("symmetry", choices=("mirror", "turn")) if table.has("symmetry") else None
    return Keep(
        ends=table.flag("ends", True),
        tangents=table.flag("tangents"),
        length=table.flag("length"),
        symmetry=symmetry,
    )


def tabs(table: Table) -> tuple[Tab, Tab]:
    """One table for both ends, or a list of two."""
    given = table.raw("ends", {})
    if isinstance(given, list):
        if len(given) != 2:
            raise InputError(
                f"{table.place('ends')} lists {len(given)} tabs: give one table, or two in a list"
            )
        start, end = table.tables("ends")
        return _tab(start), _tab(end)
    tab = _tab(table.table("ends"))
    return tab, tab


def _tab(table: Table) -> Tab:
    table.only("length", "width", "corner_radius", "chamfer", "taper", "holes", "t_slot")
    holes = tuple(
        Hole(hole.number("at"), hole.number("diameter"), hole.number("across", 0.0))
        for hole in (one.only("at", "diameter", "across") for one in table.tables("holes"))
    )
    sizes = {key: table.number(key, 0.0) for key in ("corner_radius", "chamfer", "taper")}
    with table.naming():
        t_slot = _t_slot(table.table("t_slot")) if table.has("t_slot") else None
        return Tab(table.number("length", 10.0), table.maybe("width"), holes=holes, t_slot=t_slot, **sizes)


def _t_slot(table: Table) -> TSlot:
    table.only("depth", "screw", "nut", "wall")
    width, height = table.vector("nut", 2, TSlot.nut)
    return TSlot(
        table.number("depth"),
        table.number("screw", TSlot.screw),
        (width, height),
        table.number("wall", TSlot.wall),
    )


def _style(table: Table, sheets: dict[str, Sheet]) -> Plain | Perforated | Laminated:
    """Plain, perforated or laminated."""
    kind = table.text("kind", "plain", ("plain", "perforated", "laminated"))
    with table.naming():
        chosen: dict[str, Any]
        if kind == "perforated":
            sizes: tuple[str, ...] = ("hole_ratio", "least_ligament", "least_hole", "corner_radius")
            table.only("kind", "width", "columns", "rows", *sizes)
            chosen = {key: table.number(key) for key in sizes if table.has(key)}
            chosen |= {key: table.count(key, 1) for key in ("columns", "rows") if table.has(key)}
            return Perforated(table.number("width"), **chosen)
        if kind == "laminated":
            sizes = ("least_backing", "dots")
            table.only("kind", "width", "backing", *sizes)
            chosen = {key: table.number(key) for key in sizes if table.has(key)}
            return Laminated(table.number("width"), named_sheet(table, "backing", sheets), **chosen)
    table.only("kind")
    return Plain()


def _slot(table: Table) -> Slot:
    table.only("at", "width", "depth", "side", "lean", "relief", "mate")
    chosen: dict[str, Any] = {
        "depth": table.maybe("depth"),
        "side": table.text("side", "upper"),
        "lean": table.number("lean", 0.0),
        "relief": table.text("relief", "square"),
        "mate": table.text("mate", ""),
    }
    with table.naming():
        return Slot(table.number("at"), table.number("width"), **chosen)
