"""Drawings as DXF files, R12 to R2018."""

import re
from collections.abc import Mapping
from functools import lru_cache
from itertools import count
from math import degrees

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.formats.drawing_files.curve_style import EXACT, check_curve_style, shape_paths
from elastica_cad.formats.drawing_files.dxf_frame import DXF_VERSIONS, DxfFrame, dxf_frame
from elastica_cad.formats.drawing_files.layers import LayerChoice, LayerStyle, style_layers
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, Spline, trim_segment

_CLOSED, _RATIONAL, _PLANAR = 1, 4, 8  # flags of a SPLINE
_SPLINE_POINT = " 10\n%r\n 20\n%r\n 30\n0.0\n"
_KEPT_KNOTS = 16384  # some 10 MB


def encode_dxf(
    drawing: Drawing,
    *,
    curves: str = "spline",
    tolerance: float = 0.02,
    version: str = "R2010",
    layers: Mapping[str, LayerChoice] | None = None,
) -> bytes:
    """A drawing as the content of a DXF file in mm; the same drawing gives the same bytes.

    A loop of lines and arcs is one closed polyline (a circle a CIRCLE), a loop that is one spline is one
    closed SPLINE. A loop with splines among others is a chain of LINE, ARC and SPLINE in order, ends meeting,
    bound by a GROUP, or with `curves` "arc" or "polyline" one closed LWPOLYLINE. In R12 every loop is a chain of
    LINE and ARC in order, ends meeting: OpenSCAD and old machines read no others there. The order is
    engraving, marks, inner cuts, outer cuts.

    Parameters
    ----------
    drawing : Drawing
    curves : str
        "spline" keeps splines up to degree 3 exactly, and higher ones as cubics to the tolerance but at most
        0.001 mm; "exact" keeps them all; "arc" turns splines into tangent arcs; "polyline" turns splines and
        arcs into lines. R12 knows no splines: there "spline" and "exact" mean "arc".
    tolerance : float
        Largest distance, mm, of a replaced curve from the true one.
    version : str
        One of `DXF_VERSIONS`. R12 has no units in its header; a comment says mm.
    layers : mapping, optional
        Names and colours, see `style_layers`.

    Raises
    ------
    InputError
        The drawing is empty, or an option is unknown.
    MissingDependencyError
        ezdxf is not installed.
    """
    curves = check_curve_style(curves)
    require_record(drawing, Drawing, "what is written", "a Drawing record")
    if not isinstance(version, str) or version not in DXF_VERSIONS:
        raise InputError(f"there is no DXF version {version!r}: use one of {', '.join(DXF_VERSIONS)}")
    styles = style_layers(layers)
    if version == "R12":
        _check_old_names(styles)
        curves = "arc" if curves in ("spline", EXACT) else curves
    bounds = drawing.bounds
    shown = tuple((layer, styles[layer]) for layer in drawing.layers)
    frame = dxf_frame(version, shown)
    writer = _Writer(frame, curves, tolerance, old=version == "R12")
    writer.draw(drawing, styles)
    return frame.around(writer.entities, writer.groups, bounds, free=next(writer.numbers))


class _Writer:
    """Turns paths into the text of entities under numbers of one file.

    ezdxf makes all that is around them; made by it one by one they would take eight times as long.
    """

    def __init__(self, frame: DxfFrame, curves: str, tolerance: float, *, old: bool) -> None:
        self.frame = frame
        self.old = old
        self.numbers = count(frame.first)
        self.curves = curves
        self.tolerance = tolerance
        self.entities: list[str] = []
        self.groups: list[tuple[str, list[str]]] = []

    def draw(self, drawing: Drawing, styles: Mapping[str, LayerStyle]) -> None:
        shaped = shape_paths([item.path for item in drawing.strokes], self.curves, self.tolerance)
        for item, path in zip(drawing.strokes, shaped, strict=True):
            self.path(path, styles[item.layer].name)

    def path(self, path: Path, layer: str) -> None:
        first = path.segments[0]
        alone = len(path.segments) == 1
        if alone and isinstance(first, Arc) and first.is_circle:
            self._add("CIRCLE", layer, self.number(), self._round(first))
        elif not (path.has_splines or (path.closed and self.old)):
            self._polyline(path, layer)
        else:
            numbers = [self.number() for _ in path.segments]
            group = "" if alone or self.old else self._group(numbers)
            head, closed = self._head(layer, group), path.closed and alone
            for segment, number in zip(path.segments, numbers, strict=True):
                kind, rest = self._segment(segment, closed=closed)
                self.entities.append(f"  0\n{kind}\n  5\n{number}\n{head}{rest}")

    def number(self) -> str:
        """A new one."""
        return f"{next(self.numbers):X}"

    def _group(self, members: list[str]) -> str:
        """The number of a new group that binds a loop."""
        number = self.number()
        self.groups.append((number, members))
        return number

    def _add(self, kind: str, layer: str, number: str, rest: str) -> None:
        self.entities.append(f"  0\n{kind}\n  5\n{number}\n{self._head(layer)}{rest}")

    def _head(self, layer: str, group: str = "") -> str:
        """What all entities of a path have between their numbers and their shapes."""
        bound = f"102\n{{ACAD_REACTORS\n330\n{group}\n102\n}}\n" if group else ""
        owned = "" if self.old else f"{bound}330\n{self.frame.owner}\n100\nAcDbEntity\n"
        return f"{owned}  8\n{layer}\n"

    def _class(self, name: str) -> str:
        return "" if self.old else f"100\nAcDb{name}\n"

    def _polyline(self, path: Path, layer: str) -> None:
        segments = [piece for segment in path.segments for piece in _up_to_half_turns(segment)]
        ends = [segment.start for segment in segments] + ([] if path.closed else [path.end])
        bulges = [segment.bulge if isinstance(segment, Arc) else 0.0 for segment in segments] + [0.0]
        rows = [
            (_written(10, x, y, flat=not self.old), f" 42\n{bulge}\n" if bulge else "")
            for (x, y), bulge in zip([end.tolist() for end in ends], map(float, bulges), strict=False)
        ]
        number = self.number()
        if not self.old:
            count = f" 90\n{len(rows)}\n 70\n{int(path.closed)}\n"
            places = "".join([place + bulge for place, bulge in rows])
            self._add("LWPOLYLINE", layer, number, f"{self._class('Polyline')}{count}{places}")
            return
        last = self.number()
        self._add("POLYLINE", layer, number, f" 66\n1\n{_place(10, np.zeros(2))} 70\n0\n")
        for place, bulge in rows:
            self._add("VERTEX", layer, self.number(), f"{place}{bulge} 70\n0\n")
        self._add("SEQEND", layer, last, "")

    def _segment(self, segment: Segment, *, closed: bool) -> tuple[str, str]:
        """The kind of its entity, and what tells its shape."""
        if isinstance(segment, Spline):
            return "SPLINE", _spline_text(segment.curve, closed=closed)
        if isinstance(segment, Arc):
            first, last = sorted((degrees(segment.start_angle), degrees(segment.end_angle)))
            return "ARC", f"{self._round(segment)}{self._class('Arc')} 50\n{first}\n 51\n{last}\n"
        return "LINE", f"{self._class('Line')}{_place(10, segment.start)}{_place(11, segment.end)}"

    def _round(self, arc: Arc) -> str:
        return f"{self._class('Circle')}{_place(10, arc.center)} 40\n{float(arc.radius)}\n"


def _place(code: int, point: FloatArray) -> str:
    x, y = point.tolist()
    return _written(code, x, y, flat=False)


def _written(code: int, x: float, y: float, *, flat: bool) -> str:
    return f" {code}\n{x}\n {code + 10}\n{y}\n" + ("" if flat else f" {code + 20}\n0.0\n")


def _spline_text(curve: PlaneCurve, *, closed: bool) -> str:
    weighted = curve.weights is not None
    flags = _PLANAR | (_RATIONAL if weighted else 0) | (_CLOSED if closed else 0)
    head = _spline_head(curve.knots.tobytes(), curve.degree, flags)
    weights = "" if curve.weights is None else "".join([f" 41\n{w}\n" for w in curve.weights.tolist()])
    # one template for all numbers of a curve is filled faster than one for each point
    points = curve.control_points
    return f"{head}{weights}{_SPLINE_POINT * len(points)}" % (*points.ravel().tolist(),)


@lru_cache(maxsize=_KEPT_KNOTS)
def _spline_head(knots: bytes, degree: int, flags: int) -> str:
    """Of knots as bytes: sides of holes side by side share theirs, and those of a part and of its sheet."""
    places = np.frombuffer(knots).tolist()
    counts = f" 72\n{len(places)}\n 73\n{len(places) - degree - 1}\n 74\n0\n"
    lines = "".join([f" 40\n{knot}\n" for knot in places])
    return f"100\nAcDbSpline\n 70\n{flags}\n 71\n{degree}\n{counts}{lines}"


def _up_to_half_turns(segment: Segment) -> list[Segment]:
    """An arc of more than half a turn in two, so that its bulge stays moderate."""
    if isinstance(segment, Arc) and abs(segment.sweep) > np.pi * (1 + 1e-9):
        return [trim_segment(segment, 0.0, 0.5), trim_segment(segment, 0.5, 1.0)]
    return [segment]


def _check_old_names(styles: Mapping[str, LayerStyle]) -> None:
    for style in styles.values():
        if not re.fullmatch(r"[A-Za-z0-9_$-]{1,31}", style.name):
            raise InputError(
                f"DXF R12 takes no layer named {style.name!r}: use up to 31 letters, digits, $, - and _"
            )
