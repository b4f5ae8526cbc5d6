"""Drawings as DXF files, R12 to R2018."""

import io
import logging
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache, lru_cache
from importlib import import_module
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, MissingDependencyError, how_to_install
from elastica_cad.fabrication.drawings.drawing import SHEET, Drawing
from elastica_cad.formats.drawing_files.curve_style import EXACT, check_curve_style, shape_path
from elastica_cad.formats.drawing_files.layers import LayerChoice, LayerStyle, style_layers
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, Spline
from elastica_cad.geometry.paths.trim import trim_segment

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

R12 = "AC1009"
DXF_VERSIONS = ("R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018")

_TRUE_COLOR = DXF_VERSIONS[2:]
_CLOSED, _RATIONAL, _PLANAR = 1, 4, 8  # flags of a SPLINE
_OPTIONS = Lock()
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
    if version not in DXF_VERSIONS:
        raise InputError(f"there is no DXF version {version!r}: use one of {', '.join(DXF_VERSIONS)}")
    styles = style_layers(layers)
    if version == "R12":
        _check_old_names(styles)
        curves = "arc" if curves in ("spline", EXACT) else curves
    bounds = drawing.bounds
    with _plain_ezdxf():
        document = _new_document(version, styles, drawing.layers, bounds)
        writer = _Writer(document, curves, tolerance)
        writer.draw(drawing, styles)
        _sort_classes(document)
        stream = io.StringIO()
        if version == "R12":
            stream.write("999\nall lengths in mm\n")
        document.write(stream)
        return document.encode(writer.within(stream.getvalue()))


class _Writer:
    """Turns paths into the text of entities under numbers of one document.

    ezdxf makes all that is around them; made by it one by one they would take eight times as long.
    """

    def __init__(self, document: "Document", curves: str, tolerance: float) -> None:
        self.document = document
        self.old = document.dxfversion == R12
        self.owner = document.modelspace().layout_key
        self.number = document.entitydb.next_handle
        self.curves = curves
        self.tolerance = tolerance
        self.entities: list[str] = []
        self.groups: list[tuple[str, list[str]]] = []

    def draw(self, drawing: Drawing, styles: Mapping[str, LayerStyle]) -> None:
        for item in drawing.strokes:
            self.path(item.path, styles[item.layer].name)

    def path(self, path: Path, layer: str) -> None:
        path = shape_path(path, self.curves, self.tolerance)
        first = path.segments[0]
        alone = len(path.segments) == 1
        if alone and isinstance(first, Arc) and first.is_circle:
            self._add("CIRCLE", layer, self.number(), self._round(first))
        elif not (path.has_splines or (path.closed and self.old)):
            self._polyline(path, layer)
        else:
            numbers = [self.number() for _ in path.segments]
            group = "" if alone or self.old else self._group(numbers)
            for segment, number in zip(path.segments, numbers, strict=True):
                self._segment(segment, layer, number, group, path.closed and alone)

    def within(self, text: str) -> str:
        """The text of the document, with its entities and groups."""
        head, section, tail = text.partition("  0\nSECTION\n  2\nENTITIES\n")
        if self.groups:
            first = self.groups[0][0]
            before, _, after = tail.partition(_name_of_group(1, first))
            names = [_name_of_group(k, number) for k, (number, _) in enumerate(self.groups, 1)]
            # the empty first one shows how all are written
            begin = after.index(f"  0\nGROUP\n  5\n{first}\n")
            end = after.index("\n  0\n", begin) + 1
            empty = after[begin:end].partition(first)
            filled = [
                "".join((empty[0], number, empty[2], *[f"340\n{member}\n" for member in members]))
                for number, members in self.groups
            ]
            tail = "".join((before, *names, after[:begin], *filled, after[end:]))
        return "".join((head, section, *self.entities, tail))

    def _group(self, members: list[str]) -> str:
        """The number of a new group that binds a loop; ezdxf makes the first."""
        number = self.number() if self.groups else str(self.document.groups.new("LOOP_1").dxf.handle)
        self.groups.append((number, members))
        return number

    def _add(self, kind: str, layer: str, number: str, rest: str, group: str = "") -> None:
        bound = f"102\n{{ACAD_REACTORS\n330\n{group}\n102\n}}\n" if group else ""
        owned = "" if self.old else f"{bound}330\n{self.owner}\n100\nAcDbEntity\n"
        self.entities.append(f"  0\n{kind}\n  5\n{number}\n{owned}  8\n{layer}\n{rest}")

    def _class(self, name: str) -> str:
        return "" if self.old else f"100\nAcDb{name}\n"

    def _polyline(self, path: Path, layer: str) -> None:
        segments = [piece for segment in path.segments for piece in _up_to_half_turns(segment)]
        ends = [segment.start for segment in segments] + ([] if path.closed else [path.end])
        bulges = [segment.bulge if isinstance(segment, Arc) else 0.0 for segment in segments] + [0.0]
        rows = [
            (_place(10, end, flat=not self.old), f" 42\n{bulge}\n" if bulge else "")
            for end, bulge in zip(ends, map(float, bulges), strict=False)
        ]
        number = self.number()
        if not self.old:
            count = f" 90\n{len(rows)}\n 70\n{int(path.closed)}\n"
            places = "".join([place + bulge for place, bulge in rows])
            self._add("LWPOLYLINE", layer, number, f"{self._class('Polyline')}{count}{places}")
            return
        last = self.number()
        self._add("POLYLINE", layer, number, f" 66\n1\n{_place(10, (0.0, 0.0))} 70\n0\n")
        for place, bulge in rows:
            self._add("VERTEX", layer, self.number(), f"{place}{bulge} 70\n0\n")
        self._add("SEQEND", layer, last, "")

    def _segment(self, segment: Segment, layer: str, number: str, group: str, closed: bool) -> None:
        if isinstance(segment, Spline):
            self._add("SPLINE", layer, number, _spline_text(segment.curve, closed=closed), group)
        elif isinstance(segment, Arc):
            first, last = np.degrees(sorted([segment.start_angle, segment.end_angle])).tolist()
            angles = f"{self._class('Arc')} 50\n{first}\n 51\n{last}\n"
            self._add("ARC", layer, number, self._round(segment) + angles, group)
        else:
            ends = _place(10, segment.start) + _place(11, segment.end)
            self._add("LINE", layer, number, self._class("Line") + ends, group)

    def _round(self, arc: Arc) -> str:
        return f"{self._class('Circle')}{_place(10, arc.center)} 40\n{float(arc.radius)}\n"


def _name_of_group(count: int, number: str) -> str:
    return f"  3\nLOOP_{count}\n350\n{number}\n"


def _place(code: int, point: Sequence[float] | FloatArray, *, flat: bool = False) -> str:
    x, y = np.asarray(point, dtype=float).tolist()
    return f" {code}\n{x}\n {code + 10}\n{y}\n" + ("" if flat else f" {code + 20}\n0.0\n")


def _spline_text(curve: PlaneCurve, *, closed: bool) -> str:
    weights = [] if curve.weights is None else curve.weights.tolist()
    flags = _PLANAR | (_RATIONAL if curve.is_rational else 0) | (_CLOSED if closed else 0)
    counts = f" 72\n{curve.knots.size}\n 73\n{len(curve.control_points)}\n 74\n0\n"
    return "".join(
        [
            f"100\nAcDbSpline\n 70\n{flags}\n 71\n{curve.degree}\n{counts}",
            _knot_lines(curve.knots.tobytes()),
            *[f" 41\n{weight}\n" for weight in weights],
            *[f" 10\n{x}\n 20\n{y}\n 30\n0.0\n" for x, y in curve.control_points.tolist()],
        ]
    )


@lru_cache(maxsize=_KEPT_KNOTS)
def _knot_lines(written: bytes) -> str:
    """Of knots as bytes: sides of holes side by side share theirs, and those of a part and of its sheet."""
    return "".join([f" 40\n{knot}\n" for knot in np.frombuffer(written).tolist()])


def _up_to_half_turns(segment: Segment) -> list[Segment]:
    """An arc of more than half a turn in two, so that its bulge stays moderate."""
    if isinstance(segment, Arc) and abs(segment.sweep) > np.pi * (1 + 1e-9):
        return [trim_segment(segment, 0.0, 0.5), trim_segment(segment, 0.5, 1.0)]
    return [segment]


def _new_document(
    version: str, styles: Mapping[str, LayerStyle], layers: Sequence[str], bounds: np.ndarray
) -> "Document":
    ezdxf = _ezdxf()
    document: Document = ezdxf.new(version, setup=False, units=ezdxf.units.MM)
    for layer in layers:
        style = styles[layer]
        index = _nearest_index(style.rgb)
        row = document.layers.add(style.name, color=index)
        if version in _TRUE_COLOR and ezdxf.colors.aci2rgb(index) != style.rgb:
            row.rgb = style.rgb
        if layer == SHEET and version != "R12":
            row.dxf.plot = 0  # seen, not worked
    low, high = bounds
    document.modelspace().reset_extents((*low, 0.0), (*high, 0.0))
    # ezdxf takes a corner in the origin for none, and the header would tell an empty drawing
    document.header["$EXTMIN"], document.header["$EXTMAX"] = (*low, 0.0), (*high, 0.0)
    width, height = high - low
    document.set_modelspace_vport(1.1 * max(float(height), float(width) / 2), tuple((low + high) / 2))
    return document


def _sort_classes(document: "Document") -> None:
    """ezdxf keeps the classes that a version needs in a set: their order would change with every process."""
    document.classes.add_required_classes(document.dxfversion)
    document.classes.classes = dict(sorted(document.classes.classes.items()))


@cache
def _nearest_index(rgb: tuple[int, int, int]) -> int:
    """The AutoCAD colour index nearest to a colour; black is 7, which is drawn in the ink of the screen."""
    from ezdxf.colors import aci2rgb

    if rgb == (0, 0, 0):
        return 7
    return min(range(1, 256), key=lambda i: sum((a - b) ** 2 for a, b in zip(aci2rgb(i), rgb, strict=True)))


def _check_old_names(styles: Mapping[str, LayerStyle]) -> None:
    for style in styles.values():
        if not re.fullmatch(r"[A-Za-z0-9_$-]{1,31}", style.name):
            raise InputError(
                f"DXF R12 takes no layer named {style.name!r}: use up to 31 letters, digits, $, - and _"
            )


def _ezdxf() -> Any:
    try:
        return import_module("ezdxf")
    except ImportError:
        raise MissingDependencyError(f"writing DXF needs ezdxf: {how_to_install('ezdxf')}") from None


@contextmanager
def _plain_ezdxf() -> Iterator[None]:
    """ezdxf without time stamps and random identifiers, by which files would differ, and without chatter."""
    ezdxf = _ezdxf()
    logger = logging.getLogger("ezdxf")
    with _OPTIONS:
        before, level = ezdxf.options.write_fixed_meta_data_for_testing, logger.level
        ezdxf.options.write_fixed_meta_data_for_testing = True
        logger.setLevel(logging.ERROR)
        try:
            yield
        finally:
            ezdxf.options.write_fixed_meta_data_for_testing = before
            logger.setLevel(level)
