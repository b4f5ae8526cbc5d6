"""Shapes that an SVG file shows, found in one walk through its elements and their clones.

SVG 2, chapters 5 (structure), 8 (coordinates) and 10 (shapes). https://www.w3.org/TR/SVG2/
"""

import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import NamedTuple
from xml.etree.ElementTree import Element

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.source_file import MOST_SHAPES, NUMBER, check_count
from elastica_cad.formats.svg_path_data import path_data
from elastica_cad.formats.svg_tree import (
    Extent,
    SvgTree,
    affine,
    check_elements,
    tag,
    transform_matrix,
    user_units,
)

_SHAPES = ("path", "line", "polyline", "polygon", "rect", "circle", "ellipse")
_NOT_SHOWN = (
    "defs",
    "symbol",
    "clipPath",
    "mask",
    "pattern",
    "marker",
    "linearGradient",
    "radialGradient",
    "filter",
)
_NO_CURVES = ("text", "image", "foreignObject", "flowRoot", "switch")
_INHERITED = {
    "visibility": "visible", "fill": "black", "fill-opacity": "1", "stroke": "none", "stroke-opacity": "1",
    "stroke-width": "1",
}  # fmt: skip
"""Initial values of inherited properties."""

_AREAS = ("clip-path", "mask")
_INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"

_LABELS = (f"{_INKSCAPE}label", "data-name", "{http://www.serif.com/}id")
"""Attributes in which Inkscape, Illustrator and Affinity store a name chosen by a person."""

_KIND = re.compile(
    r"""((path|rect(angle)?|circle|ellipse|oval|line|polyline|polygon|vector|shape|spline|bspline|bezcurve|d?wire|sketch
    |(combined|compound)[ _-](path|shape)|union|subtract|intersect|exclude|g|group|layer|use
    |pfad|linie|rechteck|kreis|vektor|gruppe|ebene|trac\u00e9|trazado|tracciato
    |\u8def\u5f84|\u77e2\u91cf|\u76f4\u7ebf|\u77e9\u5f62|\u692d\u5706|\u5f62\u72b6|\u56fe\u5c42|\u7ec4)
    |(star|triangle|spiral|fill|stroke|svg|object|element|form)(?=\W?\d))
    ([ _-]*(copy|kopie|\d+|\(stroke\)|n?w[ef]?\d+))*_?""",
    re.IGNORECASE | re.VERBOSE,
)
"""Labels and ids that drawing programs make: the kind of shape and numbers ("path37-1-6", "Vector 2")."""

_TOKEN = re.compile(
    r"""_?\d[0-9a-f]*|[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}|(xmlid|svgid)_\d+_|svgjs\w*\d+|id\d+
    |(?-i:(LINE|ARC|CIRCLE|ELLIPSE|SPLINE|(LW)?POLYLINE|HELIX)[ _-]?[0-9A-F]*\d[0-9A-F]*)""",
    re.IGNORECASE | re.VERBOSE,
)
"""Ids that programs make: CAD handles ("2F", "SPLINE_2F"), UUIDs and numbers of libraries. A label that a person
chose may look the same."""


@dataclass(frozen=True)
class Name:
    """The name of a shape.

    Attributes
    ----------
    shown : str
        Label of the shape, else its id, else "".
    id : str
    is_chosen : bool
        True if a person chose the label or the id, False if a program made them.
    """

    shown: str
    id: str
    is_chosen: bool

    @classmethod
    def of(cls, element: Element) -> "Name":
        """Return the name of an element."""
        element_id = element.get("id", "")
        labels = [label for key in _LABELS if (label := element.get(key, "").strip())]
        chosen = [label for label in labels if not _KIND.fullmatch(label)]
        if element_id and not (_KIND.fullmatch(element_id) or _TOKEN.fullmatch(element_id)):
            chosen.append(element_id)
        return cls(next(iter([*chosen, element_id, *labels]), ""), element_id, bool(chosen))


Box = tuple[float, float, float, float]
"""Low x, low y, high x, high y."""


class Context(NamedTuple):
    """State that an element takes from its ancestors.

    Attributes
    ----------
    matrix : (3, 3) array
        Map from the coordinates of the element to those of the drawing.
    extent : (float, float)
        Width and height of the viewport.
    values : mapping
        Inherited properties.
    clips : tuple of (box or None, matrix)
        Viewports, clip paths and masks; None is an area that is not a rectangle. The matrix maps to the
        coordinates of the box.
    layer : str
        Label of the Inkscape layer.
    clone : Name or None
        Name of the outermost clone.
    is_hidden : bool
        True if the element is not displayed.
    """

    matrix: FloatArray
    extent: Extent
    values: Mapping[str, str]
    clips: tuple[tuple[Box | None, FloatArray], ...] = ()
    layer: str = ""
    clone: Name | None = None
    is_hidden: bool = False

    def moved(self, matrix: FloatArray) -> "Context":
        """Return the context in coordinates that `matrix` maps to those of this context."""
        clips = tuple((box, clip @ matrix) for box, clip in self.clips)
        return self._replace(matrix=self.matrix @ matrix, clips=clips)


class Shape(NamedTuple):
    """A shape where it is shown, with its outline as path data."""

    element: Element
    data: str
    context: Context


# largest depth of nested elements, including elements of clones
_DEEPEST = 200


class SvgShapes:
    """The shapes of a file in the order in which they are drawn.

    Attributes
    ----------
    displayed : list of Shape
        Shapes that are not empty and not hidden by `display` or `opacity`. A shape occurs once for each clone.
    elements : set of Element
        All shapes, including the hidden ones.
    left_out : dict
        Kinds of the elements that are not read, such as "text".
    unread : list of str
        Unsupported parts of the style: selectors of style sheets, and transforms relative to a box.
    """

    def __init__(self, tree: SvgTree) -> None:
        root = tree.root
        box = view_box(root)
        extent = (
            box[2:]
            if box
            else (user_units(root.get("width"), 100.0, 100.0), user_units(root.get("height"), 100.0, 100.0))
        )
        self.displayed: list[Shape] = []
        self.elements: set[Element] = set()
        self.left_out: dict[Element, str] = {}
        self.unread = [*tree.unread]
        self._root = root
        # of several elements with one id, the first counts
        self._named = {element.get("id"): element for element in reversed([*root.iter()])}
        # box of each clip path or mask by its id, None if it is not a rectangle
        self._areas = {
            name: _rectangle(element, extent)
            for name, element in self._named.items()
            if tag(element) in ("clipPath", "mask")
        }
        # elements that are being visited, to find clones of themselves
        self._open: set[Element] = set()
        # elements without shapes, which clones may repeat without limit
        self._empty: set[Element] = set()
        self._element_count = self._shape_count = self._text_size = 0
        with np.errstate(over="ignore", invalid="ignore"):
            self._visit(root, Context(np.eye(3), extent, _INHERITED))

    def _visit(self, element: Element, context: Context, clone: Element | None = None) -> None:
        """Collect the shapes in an element and in its children, or in the element that it clones."""
        kind = tag(element)
        self._element_count += 1
        check_elements(self._element_count)
        if element in self._empty or (kind in _NOT_SHOWN and (kind != "symbol" or clone is None)):
            return
        if len(self._open) > _DEEPEST:
            raise InputError(
                "has groups nested more than {deepest} deep: ungroup them before export", deepest=_DEEPEST
            )
        self._open.add(element)
        before = self._shape_count
        context = self._inner(element, context, clone)
        if kind in _NO_CURVES:
            self.left_out[element] = kind
        if kind in _SHAPES:
            self._add(element, context)
        elif kind == "use":
            link = element.get("href", "") or element.get("{http://www.w3.org/1999/xlink}href", "")
            target = self._named.get(link[1:]) if link.startswith("#") else None
            if target in self._open:
                self.left_out[element] = "clone of itself"
            elif target is not None:
                self._visit(target, context, element)
        else:
            for child in element:
                self._visit(child, context)
        self._open.remove(element)
        if self._shape_count == before:
            self._empty.add(element)

    def _add(self, element: Element, context: Context) -> None:
        """Collect a shape, unless it is hidden.

        Limits on their number and text stop files with very many clones.
        """
        self._shape_count += 1
        check_count(
            self._shape_count,
            MOST_SHAPES,
            "shapes or more, its clones counted",
            "leave out clones or unused parts",
        )
        data = _outline(element, context.extent)
        self._text_size += len(data)
        if self._text_size > 64 * 10**6:
            raise InputError("has clones with more than 64 MB of path data in total: remove clones")
        self.elements.add(element)
        if data.strip() and not context.is_hidden:
            self.displayed.append(Shape(element, data, context))

    def _inner(self, element: Element, context: Context, clone: Element | None) -> Context:
        """Return the context of the children of an element, or of a shape itself."""
        kind, own = tag(element), element.attrib
        if "transform" in own:
            context = context.moved(transform_matrix(element, context.extent))
            if own.get("transform-box", "").endswith(("l-box", "e-box", "t-box")):
                self.unread.append(f"transform-box: {own['transform-box']}")
        opacity = re.match(rf"\s*{NUMBER}", own.get("opacity", ""))
        is_clear = opacity is not None and float(opacity[0]) <= 0
        areas = [area for name in _AREAS if (area := own.get(name, "").strip())]
        context = context._replace(
            values={**context.values, **{name: own[name] for name in _INHERITED if name in own}},
            clips=(
                *context.clips,
                *((self._areas.get(_id_in_url(area)), np.eye(3)) for area in areas if self._is_area(area)),
            ),
            is_hidden=context.is_hidden or is_clear or own.get("display", "").strip().lower() == "none",
        )
        if kind == "g" and own.get(f"{_INKSCAPE}groupmode") == "layer":
            context = context._replace(layer=own.get(f"{_INKSCAPE}label") or own.get("id") or context.layer)
        if kind == "use":
            x, y = (
                user_units(own.get(axis), whole) for axis, whole in zip("xy", context.extent, strict=True)
            )
            return context._replace(clone=context.clone or Name.of(element)).moved(affine(1, 0, 0, 1, x, y))
        return (
            _in_view(element, clone, context)
            if kind in ("svg", "symbol") and element is not self._root
            else context
        )

    def _is_area(self, text: str) -> bool:
        # True for a known clip path or mask, or for a form that is not read; a missing one does not clip
        return _id_in_url(text) in self._areas or not re.match(r"(url\(|none$)", text)


def _id_in_url(text: str) -> str:
    match = re.match(r"""url\(\s*["']?#([^"')]*)""", text)
    return match[1].strip() if match else ""


def _rectangle(area: Element, around: Extent) -> Box | None:
    """Return the box of a clip path, or None if the area of a clip path or mask is not a plain rectangle."""
    shapes = [child for child in area if tag(child) in (*_SHAPES, "use", "text", "g")]
    written = {name for element in (area, *shapes) for name in element.attrib}
    if tag(area) != "clipPath" or len(shapes) != 1 or written & {"transform", "clipPathUnits", *_AREAS}:
        return None
    with suppress(InputError):
        runs = path_data(_outline(shapes[0], around, is_rounded=False)).runs
        if len(runs) == 1 and [len(edge.points) for edge in runs[0]] == [2] * 4:
            points = np.array([edge.points[0] for edge in runs[0]])
            low, high = points.min(axis=0), points.max(axis=0)
            if np.all((points == low) | (points == high)):
                return (*low.tolist(), *high.tolist())
    return None


# axis to which a percentage of an attribute refers: 0 for the width of the viewport, 1 for its height
_ALONG = dict.fromkeys(("x", "x1", "x2", "cx", "rx", "width"), 0) | dict.fromkeys(
    ("y", "y1", "y2", "cy", "ry", "height"), 1
)


def _outline(element: Element, around: Extent, *, is_rounded: bool = True) -> str:
    """Return the path data of a shape, "" if it has no size.

    100 % of a radius is the diagonal of `around`, the width and height of the viewport, divided by sqrt(2).
    """
    kind, get = tag(element), element.get
    wholes = (*around, float(np.hypot(*around)) / 2**0.5)

    def size(name: str) -> float:
        return user_units(get(name), wholes[_ALONG.get(name, 2)])

    if kind == "path":
        return get("d", "")
    if kind in ("polyline", "polygon"):
        points = get("points", "").strip()
        return f"M{points}{'Z' if kind == 'polygon' else ''}" if points else ""
    if kind == "line":
        return f"M{size('x1')} {size('y1')}L{size('x2')} {size('y2')}"
    # a radius that is not given is as large as the other
    rx, ry = (
        size(own if get(own, "auto") != "auto" else other) for own, other in (("rx", "ry"), ("ry", "rx"))
    )
    if kind in ("circle", "ellipse"):
        rx, ry = (size("r"), size("r")) if kind == "circle" else (rx, ry)
        x, y = size("cx"), size("cy")
        quarters = ((x, y + ry), (x - rx, y), (x, y - ry), (x + rx, y))
        arcs = "".join(f"A{rx} {ry} 0 0 1 {right} {low}" for right, low in quarters)
        return f"M{x + rx} {y}{arcs}Z" if rx > 0 and ry > 0 else ""
    x, y, width, height = size("x"), size("y"), size("width"), size("height")
    if kind != "rect" or not (width > 0 and height > 0):
        return ""
    rx, ry = (min(rx, width / 2), min(ry, height / 2)) if is_rounded and rx > 0 and ry > 0 else (0.0, 0.0)
    # the ends of a side are equal if the radius is half the side
    left, right, top, bottom = x + rx, x + (width - rx), y + ry, y + (height - ry)
    arc = f"A{rx} {ry} 0 0 1"
    return (
        f"M{left} {y}H{right}{arc} {x + width} {top}V{bottom}{arc} {right} {y + height}"
        f"H{left}{arc} {x} {bottom}V{top}{arc} {left} {y}Z"
    )


_PLACES = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}


def view_box(element: Element) -> Box | None:
    """Return low x, low y, width and height of the viewBox, or None if there is no valid one."""
    box = tuple(float(v) for v in re.findall(NUMBER, element.get("viewBox", "")))
    if len(box) != 4 or not np.all(np.isfinite(box)) or box[2] <= 0 or box[3] <= 0:
        return None
    return box[0], box[1], box[2], box[3]


def _in_view(element: Element, clone: Element | None, context: Context) -> Context:
    """Return the context inside a nested <svg> or a <symbol>, which the size of a clone may scale."""
    around, box, aspect = context.extent, view_box(element), element.get("preserveAspectRatio", "")
    given = [
        (None if clone is None else clone.get(side)) or element.get(side) for side in ("width", "height")
    ]
    sides = np.array([user_units(text, whole, whole) for text, whole in zip(given, around, strict=True)])
    start = np.array([user_units(element.get(axis), whole) for axis, whole in zip("xy", around, strict=True)])
    if element.get("overflow", "").strip().lower() not in ("visible", "auto"):
        view = (*start.tolist(), *(start + sides).tolist())
        context = context._replace(clips=(*context.clips, (view, np.eye(3))))
    low, extent = (box[:2], box[2:]) if box else ((0.0, 0.0), (float(sides[0]), float(sides[1])))
    # factors along x and y, and fractions of the free space that is before the drawing
    scales, shares = sides / extent if box else np.ones(2), np.zeros(2)
    if "none" not in aspect:
        scales = np.full(2, scales.max() if "slice" in aspect else scales.min())
        places = re.match(r"\s*(?:defer\s+)?x(Min|Mid|Max)Y(Min|Mid|Max)", aspect)
        shares = np.array([_PLACES[word] for word in (places.groups() if places else ("Mid", "Mid"))])
    offset = start + shares * (sides - scales * extent) - scales * low
    return context._replace(extent=extent).moved(affine(scales[0], 0, 0, scales[1], *offset))
