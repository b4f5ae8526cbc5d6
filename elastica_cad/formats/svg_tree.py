"""Element tree of an SVG file, of limited size, with resolved styles.

CSS Syntax 3, Cascade 4 and Selectors 3. https://www.w3.org/TR/css-syntax-3/,
https://www.w3.org/TR/selectors-3/
"""

import re
import zlib
from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from gzip import GzipFile
from io import BytesIO
from pathlib import Path
from typing import BinaryIO, NamedTuple
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers.expat import ExpatError, ParserCreate

import numpy as np

from elastica_cad._units import MILLIMETRES, MM_PER_INCH
from elastica_cad.errors import InputError
from elastica_cad.formats.source_file import LARGEST_FILE, MOST_SHAPES, NUMBER, check_count, half_last_place
from elastica_cad.formats.svg_path_data import path_data

_PROPERTIES = frozenset((
    "display", "visibility", "opacity", "fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width",
    "clip-path", "mask", "transform", "transform-origin", "transform-box", "d", "x", "y", "width", "height",
    "cx", "cy", "r", "rx", "ry",
))  # fmt: skip
"""Properties that affect the visibility and position of curves."""

# CSS values that take the value of the parent element
_OF_PARENT = ("inherit", "unset")
_SCREEN = re.compile(r"\s*((only\s+)?(all|screen)|not\s+(print|speech))?\s*", re.IGNORECASE)
_PRINT = re.compile(r"\s*((only\s+)?(print|speech)\b.*|not\s+(all|screen))\s*", re.IGNORECASE)
_DYNAMIC = re.compile(r"::|:(hover|active|focus|visited|target|before|after)", re.IGNORECASE)

_STRING = r""""[^"]*(?:"|\Z)|'[^']*(?:'|\Z)"""
_NAME = r"(?:[\w-]|\\[0-9a-fA-F]{1,6}\s?|\\.)+"
_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)|<!--|-->", re.DOTALL)
_PIECE = re.compile(rf"(?:{_STRING}|[^{{}};\"'])+|[{{}};]")
_DECLARATION = re.compile(rf"([\w-]+)\s*:((?:{_STRING}|\([^)]*(?:\)|\Z)|[^;\"'(])*)")
_ESCAPE = re.compile(r"\\(?:([0-9a-fA-F]{1,6})\s?|(.))")
_SIMPLE = re.compile(
    rf"""(?P<combinator>\s*[>+~]\s*|\s+)|(?P<kind>[#.]?)(?P<name>{_NAME}|\*)
    |\[\s*(?P<key>{_NAME})\s*(?:(?P<how>[~|^$*]?)=\s*(?P<value>{_STRING}|{_NAME})\s*)?\]
    |:(?P<place>root|first-child|last-child)(?![\w(-])""",
    re.VERBOSE | re.IGNORECASE,
)

_Steps = list[tuple[str, list[re.Match[str]]]]
"""Parts of a CSS selector from left to right: a combinator, and the simple selectors of one element."""


class _Rule(NamedTuple):
    steps: _Steps
    weight: tuple[int, ...]
    # CSS declarations: name, value, and True for !important
    declared: list[tuple[str, str, bool]]


def _apply_styles(root: Element) -> list[str]:
    """Evaluate the style sheets for a screen, and write the style of every element as attributes.

    Returns
    -------
    list of str
        Unsupported selectors that may change the visibility or position of curves.
    """
    tree, rules, unread = _Tree(root), defaultdict[str, list[_Rule]](list), []
    for sheet in tree.elements:
        if tag(sheet) != "style":
            continue
        for selectors, body, holds in _rules(sheet):
            declared = _declarations(body)
            for selector in selectors.split(",") if declared else ():
                steps = _steps(selector.strip()) if holds else None
                if steps:
                    ranks = [_rank(part) for _, parts in steps for part in parts]
                    weight = 0, *map(ranks.count, range(3)), sum(map(len, rules.values()))
                    last = steps[-1][1]
                    key = next((_key(part) for part in last if part["kind"]), _key(last[0]))
                    rules[key].append(_Rule(steps, weight, declared))
                elif not _DYNAMIC.search(selector):
                    unread.append(" ".join(selector.split()))
        sheet.text = ""
    for element in tree.elements:
        classes = element.get("class", "").split()
        keys = ["*", tag(element), f"#{element.get('id')}", *(f".{name}" for name in classes)]
        matching = [rule for key in keys for rule in rules.get(key, ()) if tree.matches(element, rule.steps)]
        matching.append(_Rule([], (1,), _declarations(element.attrib.pop("style", ""))))
        ranked = [
            (important, rule.weight, name, value)
            for rule in matching
            for name, value, important in rule.declared
        ]
        for _, _, name, value in sorted(ranked, key=lambda rule: rule[:2]):
            element.set(name, value)
        for name in _PROPERTIES & element.attrib.keys():
            if element.attrib[name].strip().lower() in _OF_PARENT:
                del element.attrib[name]
    return unread


def _rules(sheet: Element) -> Iterator[tuple[str, str, bool]]:
    """Yield the rules of a style sheet: selectors, declarations, and True if the rule applies on every screen."""
    # for each open block, the result of `_applies_on_screen`
    holds: list[bool | None] = [_applies_on_screen(sheet.get("media", ""))]
    selector = text = ""
    for piece in _PIECE.findall(_COMMENT.sub(" ", "".join(sheet.itertext()))):
        if piece == "{":
            text = text.strip()
            at = re.match(r"@[\w-]+", text)
            if at:
                group = {"@media": _applies_on_screen(text[6:]), "@supports": True, "@layer": True}.get(
                    at[0].lower()
                )
                holds.append(group if holds[-1] else holds[-1])
            else:
                holds.append(holds[-1])
            selector, text = "" if at else text, ""
        elif piece == "}":
            if selector and holds[-1] is not None:
                yield selector, text, holds[-1]
            del holds[max(1, len(holds) - 1) :]
            selector = text = ""
        else:
            text = text + piece if selector or piece != ";" else ""


def _applies_on_screen(queries: str) -> bool | None:
    """Return True if media queries apply on every screen, False on some screens, None on no screen."""
    each = queries.split(",")
    return True if any(map(_SCREEN.fullmatch, each)) else None if all(map(_PRINT.fullmatch, each)) else False


def _declarations(text: str) -> list[tuple[str, str, bool]]:
    declarations = []
    for name, written in _DECLARATION.findall(_COMMENT.sub(" ", text)):
        value, _, important = written.partition("!")
        if name.lower() in _PROPERTIES:
            value = re.sub(r"""\s*path\(\s*["'](.*)["']\s*\)""", r"\1", value) if name == "d" else value
            declarations.append((name.lower(), value.strip(), bool(important)))
    return declarations


def _steps(selector: str) -> _Steps | None:
    steps: _Steps = [("", [])]
    at = 0
    while at < len(selector):
        part = _SIMPLE.match(selector, at)
        if part is None:
            return None
        if part["combinator"]:
            steps.append((part["combinator"].strip(), []))
        else:
            steps[-1][1].append(part)
        at = part.end()
    return steps if all(parts for _, parts in steps) else None


def _rank(part: re.Match[str]) -> int:
    """Return 0 for an id, 1 for a class, attribute or pseudo-class, 2 for an element name, 3 for "*"."""
    if part["name"] == "*":
        return 3
    return {"#": 0, "": 2}.get(part["kind"], 1) if part["name"] else 1


def _key(part: re.Match[str]) -> str:
    return part["kind"] + _unescaped(part["name"]) if part["name"] else "*"


def _unescaped(text: str) -> str:
    return _ESCAPE.sub(lambda match: chr(min(int(match[1], 16), 0x10FFFF)) if match[1] else match[2], text)


class _Tree:
    def __init__(self, root: Element) -> None:
        self.elements = list(root.iter())
        self.around = {child: parent for parent in self.elements for child in parent}
        self.before = {
            after: before
            for parent in self.elements
            for before, after in zip(parent, list(parent)[1:], strict=False)
        }
        # elements that have a next sibling
        self.after = set(self.before.values())

    def matches(self, element: Element, steps: _Steps) -> bool:
        elements, combinator = {element}, None
        for before, parts in reversed(steps):
            if combinator is not None:
                relation = self.before if combinator in ("+", "~") else self.around
                elements = set(self._reached(elements, relation, once=combinator in (">", "+")))
            elements = {
                candidate for candidate in elements if all(self._has(candidate, part) for part in parts)
            }
            combinator = before
        return bool(elements)

    @staticmethod
    def _reached(
        elements: set[Element], relation: dict[Element, Element], *, once: bool
    ) -> Iterator[Element]:
        visited = set[Element]()
        for element in elements:
            here = relation.get(element)
            while here is not None and here not in visited:
                visited.add(here)
                yield here
                here = None if once else relation.get(here)

    def _has(self, element: Element, part: re.Match[str]) -> bool:
        if part["place"]:
            place = part["place"].lower()
            if element not in self.around or place == "root":
                return element not in self.around
            return element not in (self.before if place == "first-child" else self.after)
        if part["key"]:
            held, value = element.get(_unescaped(part["key"])), _unescaped((part["value"] or "").strip("\"'"))
            if held is None or part["value"] is None:
                return held is not None
            return {
                "": held == value,
                "~": value in held.split(),
                "|": held == value or held.startswith(f"{value}-"),
                "^": bool(value) and held.startswith(value),
                "$": bool(value) and held.endswith(value),
                "*": bool(value) and value in held,
            }[part["how"]]
        name = _unescaped(part["name"])
        if part["kind"] == ".":
            return name in element.get("class", "").split()
        return name in ("*", element.get("id") if part["kind"] else tag(element))


_LENGTH = re.compile(rf"\s*({NUMBER}|[-+]?\d+,\d+)\s*([a-z]*)\s*", re.IGNORECASE)
PHYSICAL = {"pc": MM_PER_INCH / 6, "q": 0.25} | {unit: MILLIMETRES[unit] for unit in ("pt", "mm", "cm", "in")}
"""Sizes, mm, of the units of length other than the pixel."""

_MM = PHYSICAL | {"px": MILLIMETRES["px"], "": MILLIMETRES["px"]}
# em and rem are the default font size
_MM |= dict.fromkeys(("em", "rem"), 16 * _MM["px"])
_LINKS = ("href", "{http://www.w3.org/1999/xlink}href")


def tag(element: ElementTree.Element) -> str:
    """Return the name of an element without its namespace."""
    return str(element.tag).rpartition("}")[2]


def read_length(text: str | None) -> tuple[float, str] | None:
    """Return a length in mm and its lower-case unit, or None for percentages and other text.

    Examples
    --------
    >>> read_length("10IN"), read_length("210,5mm"), read_length("50vw")
    ((254.0, 'in'), (210.5, 'mm'), None)
    """
    match = _LENGTH.fullmatch(text or "")
    if match is None or (unit := match[2].lower()) not in _MM:
        return None
    return float(match[1].replace(",", ".")) * _MM[unit], unit


def _linked_id(element: ElementTree.Element) -> str:
    link = next((text for name in _LINKS if (text := element.get(name))), "")
    return link[1:] if link.startswith("#") else ""


def unlink(element: ElementTree.Element) -> None:
    """Remove the link attributes of a clone (<use>)."""
    for name in _LINKS:
        element.attrib.pop(name, None)


_PLACES = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
_ALONG = dict.fromkeys(("x", "x1", "x2", "cx", "rx", "width"), 0) | dict.fromkeys(
    ("y", "y1", "y2", "cy", "ry", "height"), 1
)
_SHARE = re.compile(rf"\s*({NUMBER})\s*%\s*")
_ORIGINS = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
_HELD = ("svg", "symbol")

Box = tuple[float, float, float, float]
Extent = tuple[float, float]
# scale along x, scale along y, and origin (x, y) that fit a drawing into a box
Fit = tuple[float, float, float, float]


def _fit_views(root: ElementTree.Element) -> None:
    """Resolve percentages, make groups of nested <svg> elements, and fit each symbol into the box of its <use>."""
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
        target = held.get(_linked_id(clone))
        if target is not None and target not in fits:
            _set_transform(clone, _fit(clone, target, around))
        elif target is not None and (clone.get("width") or clone.get("height")):
            _set_transform(clone, _replaced_fit(_fit(clone, target, around), fits[target], target))
    for element, fit in fits.items():
        _set_transform(element, fit)
        element.tag = str(element.tag).removesuffix("svg") + "g"


def _resolve(element: ElementTree.Element, around: Extent) -> None:
    """Convert percentages in an element to user units, and its transform origin to translations.

    100 % of a radius is the diagonal of `around`, the width and height of the viewport, divided by sqrt(2).
    """
    for name in (*_ALONG, "r"):
        share = _SHARE.fullmatch(element.get(name, ""))
        if share:
            whole = around[_ALONG[name]] if name in _ALONG else float(np.hypot(*around)) / 2**0.5
            element.set(name, repr(float(share[1]) * whole / 100))
    words, transform = element.attrib.pop("transform-origin", "").lower().split(), element.get("transform")
    if words and transform:
        words = [*words, "center"][:2]
        if words[0] in ("top", "bottom") or words[1] in ("left", "right"):
            words = words[::-1] if set(words) <= _ORIGINS.keys() else ["0", "0"]
        x, y = (_origin(word, whole) for word, whole in zip(words, around, strict=True))
        element.set("transform", f"translate({x!r} {y!r}) {transform} translate({-x!r} {-y!r})")


def _origin(word: str, whole: float) -> float:
    share = _SHARE.fullmatch(_ORIGINS.get(word, word))
    return float(share[1]) * whole / 100 if share else _size(word, 0.0)


def _sides(shown: ElementTree.Element, view: ElementTree.Element, around: Extent) -> Extent:
    width, height = (
        _size(shown.get(side) or view.get(side), whole)
        for side, whole in zip(("width", "height"), around, strict=True)
    )
    return width, height


def _fit(shown: ElementTree.Element, view: ElementTree.Element, around: Extent) -> Fit:
    box, sides = _box(view), _sides(shown, view, around)
    at = [_size(shown.get(axis), whole, default=0.0) for axis, whole in zip("xy", around, strict=True)]
    if box is None:
        return 1.0, 1.0, at[0], at[1]
    scales = [side / extent for side, extent in zip(sides, box[2:], strict=True)]
    aspect = view.get("preserveAspectRatio", "")
    rest = [0.0, 0.0]
    if "none" not in aspect:
        scales = [max(scales) if "slice" in aspect else min(scales)] * 2
        places = re.match(r"\s*(?:defer\s+)?x(Min|Mid|Max)Y(Min|Mid|Max)", aspect)
        shares = [_PLACES[word] for word in (places.groups() if places else ("Mid", "Mid"))]
        rest = [
            share * (side - scale * extent)
            for share, side, scale, extent in zip(shares, sides, scales, box[2:], strict=True)
        ]
    moved = [
        start + free - scale * low for start, free, scale, low in zip(at, rest, scales, box[:2], strict=True)
    ]
    return scales[0], scales[1], moved[0], moved[1]


def _replaced_fit(requested: Fit, own: Fit, target: ElementTree.Element) -> Fit:
    if not (own[0] and own[1]):
        return 0.0, 0.0, 0.0, 0.0
    start = [_size(target.get(axis), 0.0, default=0.0) for axis in "xy"]
    scales = requested[0] / own[0], requested[1] / own[1]
    x, y = (requested[k + 2] + start[k] - scales[k] * own[k + 2] for k in range(2))
    return scales[0], scales[1], x, y


def _set_transform(element: ElementTree.Element, fit: Fit) -> None:
    numbers = " ".join(map(repr, (fit[0], 0.0, 0.0, *fit[1:])))
    element.set("transform", f"{element.get('transform', '')} matrix({numbers})".strip())
    for name in ("x", "y", "width", "height", "viewBox", "preserveAspectRatio"):
        element.attrib.pop(name, None)


def _box(element: ElementTree.Element) -> tuple[float, float, float, float] | None:
    box = tuple(float(v) for v in re.findall(NUMBER, element.get("viewBox", "")))
    if len(box) != 4 or not (0 < box[2] < 1e15 and 0 < box[3] < 1e15):
        return None
    return box[0], box[1], box[2], box[3]


def _size(text: str | None, whole: float, default: float | None = None) -> float:
    """Return a length in user units. A missing length is `default` if given, else `whole`."""
    length = read_length(text)
    if length is None:
        return whole if default is None else default
    return length[0] / _PX


_PX = MILLIMETRES["px"]
_LENGTH_ATTRIBUTES = ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height")
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

_GZIP_MARK = b"\x1f\x8b"
# number of bytes that are read at a time to find the first element
_HEAD = 4096
# largest length of an XML entity, characters (the parser expat limits the total length)
_LONGEST_ENTITY = 1000
# largest depth of nested elements
_DEEPEST = 200
# largest number of elements, including groups, texts and elements of clones
_MOST_ELEMENTS = 5 * MOST_SHAPES
# largest number of characters including those of clones
_MOST_TEXT = 64 * 10**6
MARK = "data-shape"
"""Attribute that numbers the shapes, so that copies in clones are recognized."""

CLIPPED = "data-clipped"

CLONE = "data-clone-"
"""Prefix of the attributes that number nested clones, the outermost first."""


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
    def of(cls, element: ElementTree.Element) -> "Name":
        """Return the name of an element."""
        element_id = element.get("id", "")
        labels = [label for key in _LABELS if (label := element.get(key, "").strip())]
        chosen = [label for label in labels if not _KIND.fullmatch(label)]
        if element_id and not (_KIND.fullmatch(element_id) or _TOKEN.fullmatch(element_id)):
            chosen.append(element_id)
        return cls(next(iter([*chosen, element_id, *labels]), ""), element_id, bool(chosen))


@dataclass(frozen=True)
class Shape:
    """A shape in the file.

    Attributes
    ----------
    kind : str
        "path", "circle", ...
    name : Name
    layer : str
        Label of the Inkscape layer.
    data : str or None
        The path data of a path.
    rounding : float
        Half a unit of the last digit of the size attributes; 0 for a path.
    shown : bool
        True if the shape is not inside definitions or other hidden elements.
    clips : tuple of (box, str)
        Box and transforms of each clip path or mask. The box (low x, low y, high x, high y) is None if the
        area is not a rectangle. The transforms lead from the shape to the area.
    """

    kind: str
    name: Name
    layer: str
    data: str | None
    rounding: float
    shown: bool
    clips: "tuple[tuple[Box | None, str], ...]"


@dataclass
class SvgTree:
    """The element tree of a file, its shapes, and the names of clones. In the tree, path data are replaced by
    the indices of shapes.

    Attributes
    ----------
    size : (str, str)
        Width and height as written in the file.
    head : str
        The comments and namespaces at the top of the file.
    unread : list of str
        Unsupported parts of the style: selectors of style sheets, and transforms relative to a box.
    """

    root: ElementTree.Element
    size: tuple[str, str]
    head: str
    shapes: list[Shape] = field(default_factory=list)
    clones: list[Name] = field(default_factory=list)
    skipped: Counter[str] = field(default_factory=Counter)
    unread: list[str] = field(default_factory=list)


def svg_tree(path: Path) -> SvgTree:
    """Parse an SVG file, count its shapes, and number them."""
    with _open_svg(path) as file:
        head = _read_head(file)
        try:
            root = ElementTree.parse(file).getroot()
        except (ElementTree.ParseError, ValueError, LookupError) as error:
            raise InputError("is not an SVG file ({error}): export the file again", error=error) from error
    if tag(root) != "svg":
        raise InputError(
            "is not an SVG file, because it begins with <{tag}>, not with <svg>: export it as SVG",
            tag=tag(root),
        )
    unread = _apply_styles(root)
    tree = SvgTree(root, (root.get("width", ""), root.get("height", "")), head, unread=unread)
    _check_expanded_count(tree)
    _fit_views(root)
    _mark(tree)
    return tree


def _open_svg(path: Path) -> BinaryIO:
    file = path.open("rb")
    if file.read(2) != _GZIP_MARK:
        file.seek(0)
        return file
    with file:
        file.seek(0)
        try:
            data = GzipFile(fileobj=file).read(LARGEST_FILE + 1)
        except (OSError, EOFError, zlib.error) as error:
            raise InputError(
                "is compressed and cannot be unpacked: save the file again, as plain SVG"
            ) from error
    if len(data) > LARGEST_FILE:
        raise InputError(
            "has more than {largest_file} MB when unpacked: remove everything except curves, or simplify "
            "the file",
            largest_file=LARGEST_FILE // 10**6,
        )
    return BytesIO(data)


def _read_head(file: BinaryIO) -> str:
    """Return the comments and namespaces before the second element.

    Refuse XML entities that are not plain text.
    """
    parser, elements, texts = ParserCreate(), 0, list[str]()

    def declare(name: str, is_parameter: int, text: str | None, *_: object) -> None:
        if is_parameter or text is None or len(text) > _LONGEST_ENTITY or set(text) & set("<&"):
            raise InputError(
                "declares the XML entity {name}, which is not plain text of up to {most} characters: save "
                "the file as plain SVG (Illustrator: without its editing capabilities)",
                name=name,
                most=_LONGEST_ENTITY,
            )

    def begin(_: str, attributes: dict[str, str]) -> None:
        nonlocal elements
        elements += 1
        texts.extend(name for name in attributes if name.startswith("xmlns"))

    def comment(text: str) -> None:
        if elements < 2:
            texts.append(text)

    parser.EntityDeclHandler, parser.StartElementHandler, parser.CommentHandler = declare, begin, comment
    # the parser of the whole file reports a file that is not XML
    with suppress(ExpatError, LookupError):
        while elements < 2 and (data := file.read(_HEAD)):
            parser.Parse(data)
    file.seek(0)
    return "\n".join(texts)


def _check_expanded_count(tree: SvgTree) -> None:
    """Count the shapes including those of clones (<use>), and remove clones that contain themselves."""
    order: list[tuple[ElementTree.Element, int]] = [(tree.root, 0)]
    for element, depth in order:  # the loop adds the children of each element
        if depth > _DEEPEST:
            raise InputError(
                "has groups nested more than {deepest} deep: ungroup them before export", deepest=_DEEPEST
            )
        order += [(child, depth + 1) for child in element]
    clones = [e for e, _ in order if tag(e) == "use"]
    named = _elements_of_clones(tree.root, {_linked_id(e) for e in clones} - {""})
    links = {e: named.get(_linked_id(e)) for e in clones}
    state: dict[ElementTree.Element, tuple[int, int, int]] = {}
    open_now: set[ElementTree.Element] = set()
    stack: list[tuple[ElementTree.Element, bool]] = [(tree.root, False)]
    while stack:
        element, done = stack.pop()
        below = [*element, *([links[element]] if links.get(element) is not None else [])]
        if done:
            open_now.discard(element)
            shapes, elements = int(tag(element) in _SHAPES), 1
            size = len(element.get("d", "")) + len(element.get("points", ""))
            for node in below:
                if node is links.get(element) and node in state and not state[node][0]:
                    unlink(element)
                elif node in state:
                    shapes, elements, size = (
                        mine + its for mine, its in zip((shapes, elements, size), state[node], strict=True)
                    )
            check_count(shapes, MOST_SHAPES, "shapes, its clones counted", "leave out clones or unused parts")
            if size > _MOST_TEXT:
                raise InputError("has clones with more than 64 MB of path data in total: remove clones")
            check_count(
                elements, _MOST_ELEMENTS, "elements, its clones counted", "leave out groups, texts or clones"
            )
            state[element] = shapes, elements, size
        elif element not in state and element not in open_now:
            open_now.add(element)
            stack.append((element, True))
            for node in below:
                if node in open_now:
                    unlink(element)
                    tree.skipped["clone of itself"] += 1
                elif node not in state:
                    stack.append((node, False))


def _elements_of_clones(root: ElementTree.Element, ids: set[str]) -> dict[str, ElementTree.Element]:
    named: dict[str, ElementTree.Element] = {}
    for element in root.iter():
        name = element.get("id")
        if name in ids and named.setdefault(str(name), element) is not element:
            del element.attrib["id"]
    return named


def _mark(tree: SvgTree) -> None:
    """Number the shapes in an attribute, remove path data, and convert lengths such as 10mm to user units."""
    areas = {
        e.get("id"): _rectangle(e) for e in reversed([*tree.root.iter()]) if tag(e) in ("clipPath", "mask")
    }
    stack: list[tuple[ElementTree.Element, str, bool, tuple[tuple[Box | None, str], ...]]] = [
        (tree.root, "", True, ())
    ]
    while stack:
        element, layer, shown, clips = stack.pop()
        kind = tag(element)
        clips = tuple((box, f"{transform} {element.get('transform', '')}") for box, transform in clips)
        for name in _AREAS:
            area = element.get(name, "").strip()
            if _id_in_url(area) in areas or not re.match(r"(url\(|none$|$)", area):
                clips = (*clips, (areas.get(_id_in_url(area)), ""))
        opacity = re.match(rf"\s*{NUMBER}", element.get("opacity", ""))
        if opacity and float(opacity[0]) <= 0:
            element.set("display", "none")
        if element.get("transform") and element.get("transform-box", "").endswith(
            ("l-box", "e-box", "t-box")
        ):
            tree.unread.append(f"transform-box: {element.get('transform-box')}")
        shown = shown and kind not in _NOT_SHOWN
        if kind == "g" and element.get(f"{_INKSCAPE}groupmode") == "layer":
            layer = element.get(f"{_INKSCAPE}label") or element.get("id") or layer
        if shown and kind in _NO_CURVES:
            tree.skipped[kind] += 1
        for name in [name for name in element.attrib if name in (MARK, CLIPPED) or name.startswith(CLONE)]:
            del element.attrib[name]
        if kind == "use":
            element.set(f"{CLONE}{len(tree.clones)}", str(len(tree.clones)))
            if clips:
                element.set(CLIPPED, "1")
            tree.clones.append(Name.of(element))
        written = " ".join(element.get(name, "") for name in (*_LENGTH_ATTRIBUTES, "points"))
        for name in _LENGTH_ATTRIBUTES:
            length = read_length(element.get(name))
            if length and length[1]:
                element.set(name, repr(length[0] / _PX))
        if kind in _SHAPES:
            data = element.get("d", "") if kind == "path" else None
            if data is not None:
                element.set("d", "M0 0L1 1" if data.strip() else "")
            rounding = half_last_place(re.findall(NUMBER, written)) if data is None else 0.0
            element.set(MARK, str(len(tree.shapes)))
            tree.shapes.append(Shape(kind, Name.of(element), layer, data, rounding, shown, clips))
        stack += [(child, layer, shown, clips) for child in reversed(element)]


_AREAS = ("clip-path", "mask")


def _id_in_url(text: str) -> str:
    match = re.match(r"""url\(\s*["']?#([^"')]*)""", text)
    return match[1].strip() if match else ""


def _rectangle(area: ElementTree.Element) -> Box | None:
    shapes = [child for child in area if tag(child) in (*_SHAPES, "use", "text", "g")]
    written = {name for element in (area, *shapes) for name in element.attrib}
    if tag(area) != "clipPath" or len(shapes) != 1 or written & {"transform", "clipPathUnits", *_AREAS}:
        return None
    x, y, width, height = (_size(shapes[0].get(name), 0.0) for name in ("x", "y", "width", "height"))
    if tag(shapes[0]) == "rect":
        return x, y, x + width, y + height
    with suppress(InputError):
        runs = path_data(shapes[0].get("d", "")).runs
        if len(runs) != 1:
            return None
        run = runs[0]
        points = np.array([edge.points[0] for edge in run])
        low, high = points.min(axis=0), points.max(axis=0)
        if (
            len(run) == 4
            and all(len(edge.points) == 2 for edge in run)
            and np.all((points == low) | (points == high))
        ):
            return (*low.tolist(), *high.tolist())
    return None
