"""Drawings within a drawing: nested ones, and symbols with a box of their own, as groups with a transform.

SVG 2, sections 5.5 ("The symbol element"), 8.6 ("The viewBox attribute") and 8.9 ("Units"): percentages are of the
nearest drawing around. https://www.w3.org/TR/SVG2/
"""

import re
from xml.etree import ElementTree

import numpy as np

from elastica_cad.formats.curve_files.number_gate import NUMBER
from elastica_cad.formats.svg_files.svg_elements import LENGTH, MM, linked_id, tag

_PLACES = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
_ALONG = dict.fromkeys(("x", "x1", "x2", "cx", "rx", "width"), 0) | dict.fromkeys(
    ("y", "y1", "y2", "cy", "ry", "height"), 1
)
_SHARE = re.compile(rf"\s*({NUMBER})\s*%\s*")
_HELD = ("svg", "symbol")

Extent = tuple[float, float]
Fit = tuple[float, float, float, float]  # scales, then where the origin goes


def fit_views(root: ElementTree.Element) -> None:
    """Write percentages as user units and nested drawings as groups; fit symbols into the boxes of clones."""
    box = _box(root)
    extent = box[2:] if box else (_size(root.get("width"), 100.0), _size(root.get("height"), 100.0))
    held: dict[str, ElementTree.Element] = {}
    fits: dict[ElementTree.Element, Fit] = {}
    clones: list[tuple[ElementTree.Element, Extent]] = []
    stack: list[tuple[ElementTree.Element, Extent]] = [(child, extent) for child in reversed(root)]
    while stack:
        element, around = stack.pop()
        kind, box = tag(element), _box(element)
        _resolve(element, around)
        if kind == "use":
            clones.append((element, around))
        inner = around
        if kind in _HELD:
            inner = box[2:] if box else _sides(element, element, around)
            if box and (name := element.get("id")):
                held.setdefault(name, element)
        if kind == "svg":
            fits[element] = _fit(element, element, around)
        stack += [(child, inner) for child in reversed(element)]
    for clone, around in clones:
        target = held.get(linked_id(clone))
        if target is not None and target not in fits:
            _place(clone, _fit(clone, target, around))
        elif target is not None and (clone.get("width") or clone.get("height")):
            _place(clone, _over(_fit(clone, target, around), fits[target], target))
    for element, fit in fits.items():
        _place(element, fit)
        element.tag = str(element.tag).removesuffix("svg") + "g"


def _resolve(element: ElementTree.Element, around: Extent) -> None:
    """Percentages of an element in user units; of a radius they are of the diagonal over the root of two."""
    for name in (*_ALONG, "r"):
        share = _SHARE.fullmatch(element.get(name, ""))
        if share:
            whole = around[_ALONG[name]] if name in _ALONG else float(np.hypot(*around)) / 2**0.5
            element.set(name, repr(float(share[1]) * whole / 100))


def _sides(shown: ElementTree.Element, view: ElementTree.Element, around: Extent) -> Extent:
    """Width and height: those of the clone, else the drawing's own, else all that is around."""
    width, height = (
        _size(shown.get(side) or view.get(side), whole)
        for side, whole in zip(("width", "height"), around, strict=True)
    )
    return width, height


def _fit(shown: ElementTree.Element, view: ElementTree.Element, around: Extent) -> Fit:
    """How `view` stands in the box of `shown`, itself or a clone of it."""
    box, sides = _box(view), _sides(shown, view, around)
    at = [_size(shown.get(axis), whole, default=0.0) for axis, whole in zip("xy", around, strict=True)]
    if box is None:
        return 1.0, 1.0, at[0], at[1]
    scales = [side / extent for side, extent in zip(sides, box[2:], strict=True)]
    asked = view.get("preserveAspectRatio", "")
    rest = [0.0, 0.0]
    if "none" not in asked:
        scales = [max(scales) if "slice" in asked else min(scales)] * 2
        places = re.match(r"\s*(?:defer\s+)?x(Min|Mid|Max)Y(Min|Mid|Max)", asked)
        shares = [_PLACES[word] for word in (places.groups() if places else ("Mid", "Mid"))]
        rest = [
            share * (side - scale * extent)
            for share, side, scale, extent in zip(shares, sides, scales, box[2:], strict=True)
        ]
    moved = [
        start + free - scale * low for start, free, scale, low in zip(at, rest, scales, box[:2], strict=True)
    ]
    return scales[0], scales[1], moved[0], moved[1]


def _over(asked: Fit, own: Fit, target: ElementTree.Element) -> Fit:
    """What, before the drawing's own fit, comes to the one asked for by its clone."""
    if not (own[0] and own[1]):
        return 0.0, 0.0, 0.0, 0.0
    start = [_size(target.get(axis), 0.0, default=0.0) for axis in "xy"]
    scales = asked[0] / own[0], asked[1] / own[1]
    x, y = (asked[k + 2] + start[k] - scales[k] * own[k + 2] for k in range(2))
    return scales[0], scales[1], x, y


def _place(element: ElementTree.Element, fit: Fit) -> None:
    """Write the fit as a transform, in place of the box."""
    numbers = " ".join(map(repr, (fit[0], 0.0, 0.0, *fit[1:])))
    element.set("transform", f"{element.get('transform', '')} matrix({numbers})".strip())
    for name in ("x", "y", "width", "height", "viewBox", "preserveAspectRatio"):
        element.attrib.pop(name, None)


def _box(element: ElementTree.Element) -> tuple[float, float, float, float] | None:
    """The numbers of a viewBox that has a size."""
    box = tuple(float(v) for v in re.findall(NUMBER, element.get("viewBox", "")))
    if len(box) != 4 or not (0 < box[2] < 1e15 and 0 < box[3] < 1e15):
        return None
    return box[0], box[1], box[2], box[3]


def _size(text: str | None, whole: float, default: float | None = None) -> float:
    """A length in user units; `whole`, all of its side, is what none means unless told."""
    match = LENGTH.fullmatch(text or "")
    if match is None:
        return whole if default is None else default
    return float(match[1]) * MM[(match[2] or "px").lower()] / MM["px"]
