"""Single-stroke alphabet for engraving; its Latin, Greek and Cyrillic letters consist of lines and arcs."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from pathlib import Path as FilePath
from typing import Any
from unicodedata import combining, normalize

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, is_series, require_record
from elastica_cad.errors import InputError, Refusal, note, quoted
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import left_of, unit_vectors

CAP_HEIGHT = 6.0  # height of capital letters in units of the alphabet
LABEL_MM = 5.0  # largest height of the label of a strip, mm
LEAST_LABEL_MM = 1.5  # least height of engraved names, mm; smaller names would not be legible and are omitted
LABEL_SHARE = 0.4  # largest height of a label as a fraction of the available height
_GAP = 1.6  # gap between two letters in units of the alphabet
# bulges, tan(turn / 4), of arcs by their letter in `glyphs.toml`; capitals turn to the right
_QUARTER, _EIGHTH = float(np.tan(np.pi / 8)), float(np.tan(np.pi / 16))
_BULGES = {"q": _QUARTER, "Q": -_QUARTER, "h": 1.0, "H": -1.0, "e": _EIGHTH, "E": -_EIGHTH}


@dataclass(frozen=True)
class Text:
    """A line of engraved text.

    Parameters
    ----------
    position : pair of float
        Left end of the baseline, mm.
    text : str
        Text of Latin, Greek and Cyrillic letters without accents, digits and common punctuation.
    height : float
        Height of capital letters, mm.
    angle : float
        Direction of the baseline, rad.
    layer : str
        Name of the layer, "ENGRAVE" by default.
    """

    position: tuple[float, float]
    text: str
    height: float
    angle: float = 0.0
    layer: str = "ENGRAVE"

    def __post_init__(self) -> None:
        place = tuple(self.position) if is_series(self.position) else ()
        if len(place) != 2 or not all(map(is_number, (*place, self.height, self.angle))) or self.height <= 0:
            raise InputError(
                f"the text {self.text!r} cannot be placed: give a finite position and angle, and a height "
                "above 0, in mm"
            )
        object.__setattr__(self, "position", tuple(map(float, place)))
        require_engravable(self.text)

    @property
    def length(self) -> float:
        """Length along the baseline, mm."""
        widths = [_glyphs()[c][0] for c in self.text]
        return (sum(widths) + _GAP * max(0, len(widths) - 1)) * self.height / CAP_HEIGHT

    @property
    def box(self) -> FloatArray:
        """Corners (4, 2) of the box around the capital letters, anticlockwise from `position`, mm."""
        along = unit_vectors(self.angle)
        far, up = self.length * along, self.height * left_of(along)
        return self.position + np.array([0 * far, far, far + up, up])


def require_engravable(text: object) -> None:
    """Raise InputError if the value is not a text or contains characters that the alphabet lacks."""
    if not isinstance(text, str):
        raise InputError(f"the text to engrave is {quoted(text)}: give a text")
    missing = sorted(set(text) - _glyphs().keys())
    if missing:
        raise InputError(
            f"text {text!r}: the engraving alphabet has no {', '.join(map(repr, missing))}; use Latin, "
            "Greek or Cyrillic letters without accents, 0-9 and common punctuation"
        )


def engravable(text: str) -> str:
    """Return the text without accents that the alphabet lacks, and with underscores for other characters.

    Examples
    --------
    >>> engravable("Träger")
    'Trager'
    """
    return "".join(c if c in _glyphs() else "_" for c in _without_accents(text))


def _without_accents(text: str) -> str:
    return "".join(
        part
        for c in normalize("NFC", text)
        for part in (c if c in _glyphs() else normalize("NFKD", c))
        if not combining(part)
    )


def engraved_names(names: Iterable[str], given: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the text that is engraved for each name: the name itself, or a number.

    A name has a number if the alphabet lacks one of its letters, or if an earlier name or a given text looks the
    same when it is engraved. No number looks like another name. `given` maps names to texts that are engraved in
    place of a number.

    Examples
    --------
    >>> engraved_names(["Träger", "左", "2", "右", "Trager"])
    {'Träger': 'Träger', '左': '1', '2': '2', '右': '3', 'Trager': '4'}
    """

    def shape(text: str) -> tuple[Any, ...]:
        return tuple(map(_glyphs().get, text))

    given = given or {}
    shapes = {name: shape(_without_accents(name)) for name in names}
    seen = {shape(text) for text in given.values()}
    taken = seen.union(shapes.values())
    numbers = (str(number) for number in count(1) if shape(str(number)) not in taken)
    engraved = {}
    for name, letters in shapes.items():
        # a name of accents only has no letters left
        legible = letters not in seen and None not in letters and bool(letters) == bool(name)
        engraved[name] = name if legible else given.get(name) or next(numbers)
        seen.add(letters)
    return engraved


def numbers_note(engraved: Mapping[str, str]) -> Iterator[Refusal]:
    """Yield a note with the numbers that are engraved in place of names: see `engraved_names`."""
    numbered = [f"{text} = {name}" for name, text in engraved.items() if text != name]
    if numbered:
        yield note(
            "Numbers are engraved in place of names for which the engraving has no letters: {pairs}",
            pairs=", ".join(numbered),
        )


def text_width(text: str, height: float) -> float:
    """Return the length of a line of text, mm, for capital letters of the given height, mm.

    Examples
    --------
    >>> text_width("H", 6.0)
    4.0
    """
    return Text((0.0, 0.0), text, height).length


def text_span(text: str, height: float) -> tuple[float, float]:
    """Return the heights, mm, of the lowest and the highest stroke above the baseline.

    The first is negative for letters with a descender.

    Examples
    --------
    >>> text_span("H", 6.0), text_span("g", 6.0)
    ((0.0, 6.0), (-2.0, 6.0))
    """
    spans = [_span(c) for c in text]
    low = min([0.0, *(below for below, _ in spans)])
    high = max([CAP_HEIGHT, *(above for _, above in spans)])
    return low * height / CAP_HEIGHT, high * height / CAP_HEIGHT


def text_strokes(text: Text) -> tuple[Path, ...]:
    """Return the strokes of a text as open paths of lines and arcs, mm.

    Examples
    --------
    >>> strokes = text_strokes(Text((10, 0), "AL", 5.0))
    >>> len(strokes), round(float(max(path.bounds[1, 1] for path in strokes)), 9)
    (3, 5.0)
    """
    require_record(text, Text, "what is engraved", "a Text")
    scale, strokes = text.height / CAP_HEIGHT, list[Path]()
    c, s = scale * np.cos(text.angle), scale * np.sin(text.angle)
    (x, y), advance = text.position, 0.0
    for character in text.text:
        place = [[c, -s, x + c * advance], [s, c, y + s * advance], [0.0, 0.0, 1.0]]
        strokes += [stroke.transformed(place) for stroke in _glyph(character)]
        advance += _glyphs()[character][0] + _GAP
    return tuple(strokes)


def fit_label(text: str, center: tuple[float, float], *, angle: float, room: float, across: float) -> Text:
    """Return a label centred on a point.

    Its height is at most 5 mm and 40 % of `across`. Its length is at most 80 % of `room`.

    Parameters
    ----------
    center : pair of float
        Middle of the label, mm.
    angle : float
        Direction of the baseline, rad.
    room, across : float
        Available lengths along the baseline and perpendicular to it, mm.

    Examples
    --------
    >>> fit_label("A1", (50.0, 0.0), angle=0.0, room=100.0, across=20.0).height
    5.0
    >>> fit_label("A1", (50.0, 0.0), angle=0.0, room=100.0, across=5.0).height
    2.0
    """
    return centred_text(text, center, min(LABEL_MM, LABEL_SHARE * across), 0.8 * room, angle=angle)


def centred_text(
    text: str, center: Sequence[float] | FloatArray, height: float, room: float, *, angle: float = 0.0
) -> Text:
    """Return a text of the given height, mm, centred on a point (2,).

    The height is reduced if the text would be longer than `room`, mm. Characters that the alphabet lacks are
    replaced.

    Examples
    --------
    >>> centred_text("H", (10.0, 0.0), 6.0, 2.0).position
    (9.0, -1.5)
    """
    text = engravable(text)
    long = text_width(text, height)
    height *= min(1.0, room / long) if long > 0 else 1.0
    along, up = text_width(text, height) / 2, height / 2
    c, s = np.cos(angle), np.sin(angle)
    corner = (center[0] - c * along + s * up, center[1] - s * along - c * up)
    return Text(corner, text, height, float(angle))


@lru_cache(maxsize=1)
def _glyphs() -> dict[str, tuple[float, str]]:
    # return the width of each character in units of the alphabet, and the code of its strokes
    import tomllib

    text = FilePath(__file__).with_name("glyphs.toml").read_text(encoding="utf-8")
    table = tomllib.loads(text)
    # some entries are the letter with the same strokes
    return {c: tuple(table[entry] if isinstance(entry, str) else entry) for c, entry in table.items()}


@lru_cache(maxsize=256)
def _glyph(character: str) -> tuple[Path, ...]:
    return tuple(_strokes(_glyphs()[character][1]))


@lru_cache(maxsize=256)
def _span(character: str) -> tuple[float, float]:
    # return the heights of the lowest and the highest point above the baseline, in units of the alphabet
    bounds = [stroke.bounds[:, 1] for stroke in _glyph(character)]
    if not bounds:
        return 0.0, 0.0
    low, high = np.array(bounds).T
    return float(low.min()), float(high.max())


def _strokes(code: str) -> Iterator[Path]:
    # strokes are separated by ";", and their points "x,y" by spaces; a letter after a point makes the line to the
    # next point an arc
    for stroke in filter(None, code.split(";")):
        tokens = stroke.split()
        bulges = [_BULGES.get(token[-1], 0.0) for token in tokens]
        points = [[float(v) for v in token.rstrip("".join(_BULGES)).split(",")] for token in tokens]
        yield Path.polyline(points, bulges)
