"""Drawings as DXF files, R12 to R2018."""

import io
import logging
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from threading import Lock
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from elastica_cad.errors import InputError, MissingDependencyError, how_to_install
from elastica_cad.fabrication.drawings.drawing import SHEET, Drawing
from elastica_cad.formats.drawing_files.curve_style import EXACT, check_curve_style, shape_path
from elastica_cad.formats.drawing_files.layers import LayerChoice, LayerStyle, style_layers
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, Spline
from elastica_cad.geometry.paths.trim import trim_segment

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities.dxfgfx import DXFGraphic
    from ezdxf.entities.dxfgroups import DXFGroup
    from ezdxf.layouts.layout import Modelspace

R12 = "AC1009"
DXF_VERSIONS = ("R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018")

_TRUE_COLOR = DXF_VERSIONS[2:]
_OPTIONS = Lock()


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
        _Writer(document, curves, tolerance).draw(drawing, styles)
        _sort_classes(document)
        stream = io.StringIO()
        if version == "R12":
            stream.write("999\nall lengths in mm\n")
        document.write(stream)
        return document.encode(stream.getvalue())


class _Writer:
    """Turns paths into entities of one document."""

    def __init__(self, document: "Document", curves: str, tolerance: float) -> None:
        self.document = document
        self.space: Modelspace = document.modelspace()
        self.curves = curves
        self.tolerance = tolerance
        self.loops = 0

    def draw(self, drawing: Drawing, styles: Mapping[str, LayerStyle]) -> None:
        for item in drawing.strokes:
            self.path(item.path, {"layer": styles[item.layer].name})

    def path(self, path: Path, attributes: dict[str, Any]) -> None:
        path = shape_path(path, self.curves, self.tolerance)
        first = path.segments[0]
        alone = len(path.segments) == 1
        if alone and isinstance(first, Arc) and first.is_circle:
            self.space.add_circle(tuple(first.center), first.radius, dxfattribs=attributes)
        elif not (path.has_splines or (path.closed and self.document.dxfversion == R12)):
            self._polyline(path, attributes)
        else:
            chain = [self._entity(segment, attributes, path.closed and alone) for segment in path.segments]
            if not alone and self.document.dxfversion != R12:
                self.loops += 1
                self._bind(f"LOOP_{self.loops}", chain)

    def _bind(self, name: str, chain: Sequence["DXFGraphic"]) -> None:
        """A GROUP of entities: what `groups.new` does, which compares the name with that of every group before."""
        groups = self.document.groups.object_dict
        attributes = {"description": "", "unnamed": 0, "selectable": 1, "owner": groups.dxf.handle}
        group = self.document.objects.add_dxf_object_with_reactor("GROUP", attributes)
        groups.add(name, group)
        cast("DXFGroup", group).extend(chain)

    def _polyline(self, path: Path, attributes: dict[str, Any]) -> None:
        segments = [piece for segment in path.segments for piece in _up_to_half_turns(segment)]
        rows = [(*segment.start, segment.bulge if isinstance(segment, Arc) else 0.0) for segment in segments]
        if not path.closed:
            rows.append((*path.end, 0.0))
        add = self.space.add_polyline2d if self.document.dxfversion == R12 else self.space.add_lwpolyline
        add(rows, format="xyb", close=path.closed, dxfattribs=attributes)

    def _entity(self, segment: Segment, attributes: dict[str, Any], closed: bool) -> "DXFGraphic":
        if isinstance(segment, Spline):
            curve = segment.curve
            entity = self.space.add_spline(degree=curve.degree, dxfattribs=attributes)
            entity.control_points = np.column_stack(
                [curve.control_points, np.zeros(len(curve.control_points))]
            )
            entity.knots = curve.knots
            if curve.weights is not None:
                entity.weights = curve.weights
            entity.dxf.flags = entity.PLANAR | (entity.RATIONAL if curve.is_rational else 0)
            entity.closed = closed
            return entity
        if isinstance(segment, Arc):
            first, last = np.degrees(sorted([segment.start_angle, segment.end_angle]))
            return self.space.add_arc(
                tuple(segment.center), segment.radius, first, last, dxfattribs=attributes
            )
        return self.space.add_line(tuple(segment.start), tuple(segment.end), dxfattribs=attributes)


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
