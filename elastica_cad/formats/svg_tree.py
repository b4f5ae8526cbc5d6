"""Element tree of an SVG file, of limited size, with resolved styles, and the lengths and transforms in it.

Style sheets are read by tinycss2 and cssselect2: CSS Syntax 3, Cascade 4 and Selectors 4. Lengths and transforms:
https://www.w3.org/TR/css-transforms-1/.
"""

import re
import zlib
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from gzip import GzipFile
from io import BytesIO
from itertools import chain, cycle
from pathlib import Path
from typing import Any, BinaryIO
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers.expat import ExpatError, ParserCreate

import numpy as np
from cssselect2 import ElementWrapper, Matcher, compile_selector_list
from tinycss2 import (
    parse_component_value_list,
    parse_declaration_list,
    parse_rule_list,
    parse_stylesheet,
    serialize,
)

from elastica_cad._types import FloatArray
from elastica_cad._units import MILLIMETRES, MM_PER_INCH
from elastica_cad.errors import InputError
from elastica_cad.formats.source_file import LARGEST_FILE, MOST_SHAPES, NUMBER, check_count

_PROPERTIES = frozenset((
    "display", "visibility", "opacity", "fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width",
    "clip-path", "mask", "overflow", "transform", "transform-origin", "transform-box", "d", "x", "y", "width",
    "height", "cx", "cy", "r", "rx", "ry",
))  # fmt: skip
"""Properties that affect the visibility and position of curves."""

_SCREEN = re.compile(r"\s*((only\s+)?(all|screen)|not\s+(print|speech))?\s*", re.IGNORECASE)
_PRINT = re.compile(r"\s*((only\s+)?(print|speech)\b.*|not\s+(all|screen))\s*", re.IGNORECASE)
# fonts and images in style sheets
_EMBEDDED = re.compile(r"""url\(\s*["']?data:[^)]*\)""", re.IGNORECASE)

# largest length of an XML entity, characters (the parser expat limits the total length)
_LONGEST_ENTITY = 1000
MOST_ELEMENTS = 5 * MOST_SHAPES
"""Largest number of elements, including groups, texts and elements of clones."""


@dataclass(frozen=True)
class SvgTree:
    """The element tree of a file. The declarations of its style sheets are written into the attributes.

    Attributes
    ----------
    head : str
        The comments and namespaces at the top of the file.
    unread : list of str
        Unsupported selectors of style sheets.
    """

    root: Element
    head: str
    unread: list[str]


def svg_tree(path: Path) -> SvgTree:
    """Parse an SVG file, and evaluate its style sheets for a screen."""
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
    check_elements(sum(1 for _ in root.iter()))
    try:
        return SvgTree(root, head, _apply_styles(root))
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        raise InputError(
            "has a style with unusable numbers, letters or nested parentheses: export the file again"
        ) from error


def check_elements(count: int) -> None:
    """Raise InputError if the number of elements is too large."""
    check_count(
        count, MOST_ELEMENTS, "elements or more, its clones counted", "leave out groups, texts or clones"
    )


def _open_svg(path: Path) -> BinaryIO:
    """Return the file, unpacked if it is compressed by gzip (SVGZ)."""
    file = path.open("rb")
    if file.read(2) != b"\x1f\x8b":  # the mark of gzip
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
        while elements < 2 and (data := file.read(4096)):
            parser.Parse(data)
    file.seek(0)
    return "\n".join(texts)


class _Node(ElementWrapper):  # type: ignore[misc]  # cssselect2 has no types
    """Element to which selectors are compared.

    The base class finds ancestors and siblings by recursion and lists all siblings of each element.
    """

    def _chain(self, relation: str) -> "Iterator[_Node]":
        node = getattr(self, relation)
        while node is not None:
            yield node
            node = getattr(node, relation)

    ancestors = property(lambda self: self._chain("parent"))
    previous_siblings = property(lambda self: self._chain("previous"))


def _apply_styles(root: Element) -> list[str]:
    """Evaluate the style sheets for a screen, and write the style of every element as attributes.

    Returns
    -------
    list of str
        Unsupported selectors that may change the visibility or position of curves.
    """
    matcher, unread, inline = Matcher(), list[str](), cache(_declarations)
    for sheet in root.iter():
        for rule, holds in _rules(sheet) if tag(sheet) == "style" else ():
            # a rule that holds on some screens only (`holds` False) is reported, not applied
            declared = _declarations(rule.content)
            selectors = _selectors(rule.prelude) if holds and declared else []
            for selector in selectors:
                if selector.pseudo_element is None:
                    matcher.add_selector(selector, declared)
            if declared and not selectors:
                unread.append(" ".join(serialize(rule.prelude).split()))
    # the attributes change after all elements are matched, because selectors may refer to attributes
    styles = []
    for node in _Node.from_xml_root(root).iter_subtree():
        element = node.etree_element
        matching = [*(declared for *_, declared in matcher.match(node)), inline(element.get("style", ""))]
        # the matcher returns rules in the order of the cascade, and the style attribute comes after them; the
        # stable sort moves declarations with !important to the end, where they replace the others of their name
        ranked = sorted(chain(*matching), key=lambda declared: declared[0])
        styles.append((element, {name: value for _, name, value in ranked}))
    for element, style in styles:
        element.attrib.update(style)
        for name in _PROPERTIES & element.attrib.keys():
            # the value of the parent element
            if element.attrib[name].strip().lower() in ("inherit", "unset"):
                del element.attrib[name]
    return unread


def _rules(sheet: Element) -> Iterator[tuple[Any, bool]]:
    """Yield the rules of a style sheet, each with True if it applies on every screen, False if on some."""
    text = _EMBEDDED.sub("none", "".join(sheet.itertext()))
    check_count(len(text), 10**6, "characters in a style sheet", "leave out styles that are not used")
    media = _applies_on_screen(sheet.get("media", ""))
    pending = [(rule, media) for rule in reversed(parse_stylesheet(text, True, True))]
    while pending:
        rule, holds = pending.pop()
        if rule.type == "qualified-rule" and holds is not None:
            yield rule, holds
        elif rule.type == "at-rule" and rule.content is not None:
            # rules inside other at-rules, such as @font-face, do not apply (None)
            group = {"media": _applies_on_screen(serialize(rule.prelude)), "supports": True, "layer": True}
            inner = group.get(rule.lower_at_keyword) if holds else holds
            pending += [(part, inner) for part in reversed(parse_rule_list(rule.content, True, True))]


def _applies_on_screen(queries: str) -> bool | None:
    """Return True if media queries apply on every screen, False on some screens, None on no screen."""
    each = queries.split(",")
    return True if any(map(_SCREEN.fullmatch, each)) else None if all(map(_PRINT.fullmatch, each)) else False


def _declarations(source: Any) -> list[tuple[bool, str, str]]:
    """Return the declarations of a rule or of a style attribute: True for !important, name, and value."""
    return [
        (part.important, part.lower_name, _value(part))
        for part in parse_declaration_list(source, True, True)
        if part.type == "declaration" and part.lower_name in _PROPERTIES
    ]


def _value(declaration: Any) -> str:
    if declaration.lower_name != "d":
        return str(serialize(declaration.value)).strip()
    paths = [token.arguments for token in declaration.value if token.type == "function"]
    return "".join(token.value for path in paths for token in path if token.type == "string")


def _selectors(prelude: Any) -> list[Any]:
    # cssselect2 compiles selectors to expressions of Python, which cannot be nested without limit
    with suppress(ValueError, TypeError, NotImplementedError, SyntaxError, RecursionError, MemoryError):
        return list(compile_selector_list(prelude))
    return []


def tag(element: Element) -> str:
    """Return the name of an element without its namespace."""
    return str(element.tag).rpartition("}")[2]


Extent = tuple[float, float]
"""Width and height of a viewport, user units."""

_LENGTH = re.compile(rf"\s*({NUMBER}|[-+]?\d+,\d+)\s*([a-z]*)\s*", re.IGNORECASE)
_SHARE = re.compile(rf"\s*({NUMBER})\s*%\s*")
PHYSICAL = {"pc": MM_PER_INCH / 6, "q": 0.25} | {unit: MILLIMETRES[unit] for unit in ("pt", "mm", "cm", "in")}
"""Sizes, mm, of the units of length other than the pixel."""

_PX = MILLIMETRES["px"]
_MM = PHYSICAL | {"px": _PX, "": _PX}
# em and rem are the default font size
_MM |= dict.fromkeys(("em", "rem"), 16 * _PX)


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


def user_units(text: str | None, whole: float, default: float = 0.0) -> float:
    """Return a length in user units; 100 % is `whole`. A missing or invalid length is `default`."""
    share, length = _SHARE.fullmatch(text or ""), read_length(text)
    if share:
        return float(share[1]) * whole / 100
    return length[0] / _PX if length else default


_ORIGINS = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
_DEGREES = {"": 1.0, "deg": 1.0, "grad": 0.9, "rad": float(np.degrees(1)), "turn": 360.0}


def _turn(angle: float, x: float = 0.0, y: float = 0.0) -> tuple[float, ...]:
    c, s = float(np.cos(np.radians(angle))), float(np.sin(np.radians(angle)))
    return c, s, -s, c, x - c * x + s * y, y - s * x - c * y


def _slope(angle: float) -> float:
    return float(np.tan(np.radians(angle)))


# functions of a transform list: arguments in user units or degrees, and the numbers of matrix(a b c d e f)
_TRANSFORMS: dict[str, Any] = {
    "matrix": lambda a, b, c, d, e, f: (a, b, c, d, e, f),
    "translate": lambda x, y=0.0: (1, 0, 0, 1, x, y),
    "translatex": lambda x: (1, 0, 0, 1, x, 0),
    "translatey": lambda y: (1, 0, 0, 1, 0, y),
    "scale": lambda x, y=None: (x, 0, 0, x if y is None else y, 0, 0),
    "scalex": lambda x: (x, 0, 0, 1, 0, 0),
    "scaley": lambda y: (1, 0, 0, y, 0, 0),
    "rotate": _turn,
    "skew": lambda x, y=0.0: (1, _slope(y), _slope(x), 1, 0, 0),
    "skewx": lambda angle: (1, 0, _slope(angle), 1, 0, 0),
    "skewy": lambda angle: (1, _slope(angle), 0, 1, 0, 0),
}


def affine(a: float, b: float, c: float, d: float, e: float, f: float) -> FloatArray:
    """Return the matrix (3, 3) of the SVG transform matrix(a b c d e f)."""
    return np.array([[a, c, e], [b, d, f], [0, 0, 1]], dtype=float)


def transform_matrix(element: Element, around: Extent) -> FloatArray:
    """Return the matrix (3, 3) of an element's transforms, NaN if they are invalid.

    `around` is the size of the viewport, to which percentages refer.
    """
    matrix = np.eye(3)
    # SVG permits spaces before a parenthesis, CSS does not
    for token in parse_component_value_list(re.sub(r"\s+\(", "(", element.get("transform", ""))):
        if token.type == "function":
            wholes = {"translate": around, "translatex": around, "translatey": around[::-1]}
            # what 100 % of each argument is; other functions permit no percentages
            shares = cycle(wholes.get(token.lower_name, (np.nan,)))
            written = [word for word in token.arguments if word.type != "whitespace" and word != ","]
            numbers = [_argument(word, whole) for word, whole in zip(written, shares, strict=False)]
            try:
                matrix = matrix @ affine(*_TRANSFORMS[token.lower_name](*numbers))
            except (KeyError, TypeError):
                return np.full((3, 3), np.nan)
    words = [*element.get("transform-origin", "").lower().split(), "center"][:2]
    if len(words) == 1:
        return matrix
    if words[0] in ("top", "bottom") or words[1] in ("left", "right"):
        words = words[::-1] if set(words) <= _ORIGINS.keys() else ["0", "0"]
    x, y = (user_units(_ORIGINS.get(word, word), whole) for word, whole in zip(words, around, strict=True))
    return affine(1, 0, 0, 1, x, y) @ matrix @ affine(1, 0, 0, 1, -x, -y)


def _argument(word: Any, whole: float) -> float:
    """Return an argument of a transform: an angle in degrees, a length in user units, or a plain number.

    The result is NaN for other words. 100 % is `whole`.
    """
    if word.type == "percentage":
        return float(word.value) * whole / 100
    if word.type not in ("number", "dimension"):
        return np.nan
    unit = word.lower_unit if word.type == "dimension" else ""
    return float(word.value * _DEGREES.get(unit, _MM.get(unit, np.nan) / _PX))
