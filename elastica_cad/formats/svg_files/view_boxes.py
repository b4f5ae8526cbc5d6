"""Symbols with a box of their own, shown in the box of each clone.

SVG 2, sections 5.5 ("The symbol element") and 8.6 ("The viewBox attribute"). https://www.w3.org/TR/SVG2/
"""

import re
from xml.etree import ElementTree

from elastica_cad.formats.curve_files.number_gate import NUMBER
from elastica_cad.formats.svg_files.svg_lengths import LENGTH, MM

_HREF = ("href", "{http://www.w3.org/1999/xlink}href")
_PLACES = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}


def fit_symbols(root: ElementTree.Element) -> None:
    """Give every clone of a symbol with a viewBox the transform that fits this into the box of the clone."""
    symbols = {e.get("id"): e for e in root.iter() if _tag(e) == "symbol" and _box(e)}
    if not symbols:
        return
    around = _box(root) or (0.0, 0.0, _size(root.get("width"), 100.0), _size(root.get("height"), 100.0))
    for clone in root.iter():
        link = next((clone.get(name) for name in _HREF if clone.get(name)), None) or ""
        if _tag(clone) == "use" and link[:1] == "#" and link[1:] in symbols:
            _fit(clone, symbols[link[1:]], around[2:])


def _fit(clone: ElementTree.Element, symbol: ElementTree.Element, around: tuple[float, ...]) -> None:
    """The clone's place and the symbol's scale as one transform; sizes are the clone's, else the symbol's."""
    box = _box(symbol)
    assert box is not None
    sides = [
        _size(clone.get(side) or symbol.get(side), whole)
        for side, whole in zip(("width", "height"), around, strict=True)
    ]
    scales = [side / extent for side, extent in zip(sides, box[2:], strict=True)]
    asked = symbol.get("preserveAspectRatio", "")
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
        _size(clone.attrib.pop(axis, None), whole, default=0.0) + free - scale * low
        for axis, whole, free, scale, low in zip("xy", around, rest, scales, box[:2], strict=True)
    ]
    numbers = " ".join(map(repr, (scales[0], 0.0, 0.0, scales[1], *moved)))
    clone.set("transform", f"{clone.get('transform', '')} matrix({numbers})".strip())
    for side in ("width", "height"):
        clone.attrib.pop(side, None)


def _tag(element: ElementTree.Element) -> str:
    return str(element.tag).rpartition("}")[2]


def _box(element: ElementTree.Element) -> tuple[float, ...] | None:
    """The numbers of a viewBox that has a size."""
    box = tuple(float(v) for v in re.findall(NUMBER, element.get("viewBox", "")))
    return box if len(box) == 4 and 0 < box[2] < 1e15 and 0 < box[3] < 1e15 else None


def _size(text: str | None, whole: float, default: float | None = None) -> float:
    """A length in user units, `whole` being all of its side, which is also what none means unless told."""
    share = re.fullmatch(rf"\s*({NUMBER})\s*%\s*", text or "")
    if share:
        return float(share[1]) * whole / 100
    match = LENGTH.fullmatch(text or "")
    if match is None:
        return whole if default is None else default
    return float(match[1]) * MM[(match[2] or "px").lower()] / MM["px"]
