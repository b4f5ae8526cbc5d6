"""The style of an SVG's elements, from its style sheets and `style` attributes, written as their attributes.

CSS Syntax 3, Cascade 4 and Selectors 3. https://www.w3.org/TR/css-syntax-3/, https://www.w3.org/TR/selectors-3/
"""

import re
from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple
from xml.etree.ElementTree import Element

_PROPERTIES = frozenset((
    "display", "visibility", "opacity", "fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width",
    "clip-path", "mask", "transform", "transform-origin", "transform-box", "d", "x", "y", "width", "height",
    "cx", "cy", "r", "rx", "ry",
))  # fmt: skip
"""Properties that decide which curves are seen, and where."""

_OF_PARENT = ("inherit", "unset")  # values that stand for the one of the element around
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
"""A selector from left to right: the combinator before, and the simple selectors of one element."""


class _Rule(NamedTuple):
    steps: _Steps
    weight: tuple[int, ...]
    declared: list[tuple[str, str, bool]]  # name, value, is it important


def apply_styles(root: Element) -> list[str]:
    """Write the style of every element as attributes, as browsers show it on a screen.

    Returns
    -------
    list of str
        Selectors that are not evaluated although they may change which curves are seen, or where.
    """
    tree, rules, unread = _Tree(root), defaultdict[str, list[_Rule]](list), []
    for sheet in tree.elements:
        if _kind(sheet) != "style":
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
        keys = ["*", _kind(element), f"#{element.get('id')}", *(f".{name}" for name in classes)]
        found = [rule for key in keys for rule in rules.get(key, ()) if tree.matches(element, rule.steps)]
        found.append(_Rule([], (1,), _declarations(element.attrib.pop("style", ""))))
        ranked = [
            (important, rule.weight, name, value)
            for rule in found
            for name, value, important in rule.declared
        ]
        for _, _, name, value in sorted(ranked, key=lambda one: one[:2]):
            element.set(name, value)
        for name in _PROPERTIES & element.attrib.keys():
            if element.attrib[name].strip().lower() in _OF_PARENT:
                del element.attrib[name]
    return unread


def _rules(sheet: Element) -> Iterator[tuple[str, str, bool]]:
    """Selectors and declarations of the rules of a sheet, and whether they surely hold on a screen."""
    holds: list[bool | None] = [_holds(sheet.get("media", ""))]  # None: not on a screen, or no rules
    selector = text = ""
    for piece in _PIECE.findall(_COMMENT.sub(" ", "".join(sheet.itertext()))):
        if piece == "{":
            text = text.strip()
            at = re.match(r"@[\w-]+", text)
            if at:
                group = {"@media": _holds(text[6:]), "@supports": True, "@layer": True}.get(at[0].lower())
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


def _holds(queries: str) -> bool | None:
    """Do media queries hold on a screen? None where they are for paper, False where that depends on the screen."""
    each = queries.split(",")
    return True if any(map(_SCREEN.fullmatch, each)) else None if all(map(_PRINT.fullmatch, each)) else False


def _declarations(text: str) -> list[tuple[str, str, bool]]:
    """The declarations that count here: name, value, and whether it is important."""
    found = []
    for name, written in _DECLARATION.findall(_COMMENT.sub(" ", text)):
        value, _, important = written.partition("!")
        if name.lower() in _PROPERTIES:
            value = re.sub(r"""\s*path\(\s*["'](.*)["']\s*\)""", r"\1", value) if name == "d" else value
            found.append((name.lower(), value.strip(), bool(important)))
    return found


def _steps(selector: str) -> _Steps | None:
    """The steps of a selector; None of one that is not evaluated."""
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
    """What a simple selector counts as: 0 an id, 1 a class, attribute or place, 2 a kind, 3 nothing."""
    if part["name"] == "*":
        return 3
    return {"#": 0, "": 2}.get(part["kind"], 1) if part["name"] else 1


def _key(part: re.Match[str]) -> str:
    """What an element must have for a selector to match: its id, class or kind, or "*" for any."""
    return part["kind"] + _unescaped(part["name"]) if part["name"] else "*"


def _unescaped(text: str) -> str:
    return _ESCAPE.sub(lambda one: chr(min(int(one[1], 16), 0x10FFFF)) if one[1] else one[2], text)


def _kind(element: Element) -> str:
    return str(element.tag).rpartition("}")[2]


class _Tree:
    """The elements of a document, with what is around and before each."""

    def __init__(self, root: Element) -> None:
        self.elements = list(root.iter())
        self.around = {child: parent for parent in self.elements for child in parent}
        self.before = {
            after: before
            for parent in self.elements
            for before, after in zip(parent, list(parent)[1:], strict=False)
        }
        self.after = set(self.before.values())  # elements that another one follows

    def matches(self, element: Element, steps: _Steps) -> bool:
        """Does a selector select the element?"""
        found, combinator = {element}, None
        for before, parts in reversed(steps):
            if combinator is not None:
                way = self.before if combinator in ("+", "~") else self.around
                found = set(self._reached(found, way, once=combinator in (">", "+")))
            found = {one for one in found if all(self._has(one, part) for part in parts)}
            combinator = before
        return bool(found)

    @staticmethod
    def _reached(found: set[Element], way: dict[Element, Element], *, once: bool) -> Iterator[Element]:
        seen = set[Element]()
        for element in found:
            here = way.get(element)
            while here is not None and here not in seen:
                seen.add(here)
                yield here
                here = None if once else way.get(here)

    def _has(self, element: Element, part: re.Match[str]) -> bool:
        """Does one simple selector hold?"""
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
        return name in ("*", element.get("id") if part["kind"] else _kind(element))
