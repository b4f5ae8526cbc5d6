"""A single-stroke alphabet for engraving: every letter is a few lines and arcs that the tool runs once."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from unicodedata import combining, normalize

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.geometry import Path

__all__ = ["Text", "engravable", "text_strokes", "text_width"]

CAP_HEIGHT = 6.0
_GAP = 1.6
_QUARTER, _EIGHTH = float(np.tan(np.pi / 8)), float(np.tan(np.pi / 16))
_BULGES = {"q": _QUARTER, "Q": -_QUARTER, "h": 1.0, "H": -1.0, "e": _EIGHTH, "E": -_EIGHTH}

# Capitals are 6 high, small letters 4, descenders -2: width, then strokes of points x,y. A letter after a
# point bends the way to the next: q a quarter, h half, e an eighth of a turn left; Q, H, E to the right.
_GLYPHS = {
    " ": (2.6, ""),
    "A": (4.0, "0,0 2,6 4,0; 0.8,2.4 3.2,2.4"),
    "B": (4.0, "0,3 0,6 2.5,6H 2.5,3 0,3 0,0 2.5,0h 2.5,3"),
    "C": (4.0, "4,4q 2,6q 0,4 0,2q 2,0q 4,2"),
    "D": (4.0, "0,0 0,6 2,6Q 4,4 4,2Q 2,0 0,0"),
    "E": (3.6, "3.6,0 0,0 0,6 3.6,6; 0,3 3,3"),
    "F": (3.6, "0,0 0,6 3.6,6; 0,3 3,3"),
    "G": (4.0, "4,4q 2,6q 0,4 0,2q 2,0q 4,2 4,3 2.5,3"),
    "H": (4.0, "0,0 0,6; 4,0 4,6; 0,3 4,3"),
    "I": (2.0, "1,0 1,6; 0,0 2,0; 0,6 2,6"),
    "J": (3.0, "3,6 3,1.5Q 1.5,0Q 0,1.5"),
    "K": (4.0, "0,0 0,6; 4,6 0,2.4; 1.5,3.75 4,0"),
    "L": (3.6, "0,6 0,0 3.6,0"),
    "M": (5.0, "0,0 0,6 2.5,2 5,6 5,0"),
    "N": (4.0, "0,0 0,6 4,0 4,6"),
    "O": (4.0, "2,6q 0,4 0,2q 2,0q 4,2 4,4q 2,6"),
    "P": (4.0, "0,0 0,6 2.5,6H 2.5,3 0,3"),
    "Q": (4.0, "2,6q 0,4 0,2q 2,0q 4,2 4,4q 2,6; 2.5,1.5 4,0"),
    "R": (4.0, "0,0 0,6 2.5,6H 2.5,3 0,3; 2,3 4,0"),
    "S": (4.0, "4,4.5q 2.5,6 1.5,6h 1.5,3 2.5,3H 2.5,0 1.5,0Q 0,1.5"),
    "T": (4.0, "2,0 2,6; 0,6 4,6"),
    "U": (4.0, "0,6 0,2q 2,0q 4,2 4,6"),
    "V": (4.0, "0,6 2,0 4,6"),
    "W": (6.0, "0,6 1.5,0 3,4.5 4.5,0 6,6"),
    "X": (4.0, "0,0 4,6; 0,6 4,0"),
    "Y": (4.0, "0,6 2,3 4,6; 2,3 2,0"),
    "Z": (4.0, "0,6 4,6 0,0 4,0"),
    "a": (3.0, "3,4 3,0; 3,2.5q 1.5,4q 0,2.5 0,1.5q 1.5,0q 3,1.5"),
    "b": (3.0, "0,6 0,0; 0,2.5Q 1.5,4Q 3,2.5 3,1.5Q 1.5,0Q 0,1.5"),
    "c": (2.6, "2.56066,3.56066e 1.5,4q 0,2.5 0,1.5q 1.5,0e 2.56066,0.43934"),
    "d": (3.0, "3,6 3,0; 3,2.5q 1.5,4q 0,2.5 0,1.5q 1.5,0q 3,1.5"),
    "e": (3.0, "0,2 3,2 3,2.5q 1.5,4q 0,2.5 0,1.5q 1.5,0e 2.56066,0.43934"),
    "f": (2.4, "0.75,0 0.75,4.75Q 2,6 2.4,6; 0,4 2,4"),
    "g": (3.0, "3,4 3,-0.5Q 1.5,-2 0.5,-2; 3,2.5q 1.5,4q 0,2.5 0,1.5q 1.5,0q 3,1.5"),
    "h": (3.0, "0,6 0,0; 0,2.5Q 1.5,4Q 3,2.5 3,0"),
    "i": (1.0, "0.5,4 0.5,0; 0.5,5.4 0.5,5.8"),
    "j": (2.0, "1.5,4 1.5,-0.75Q 0.25,-2 0,-2; 1.5,5.4 1.5,5.8"),
    "k": (3.0, "0,6 0,0; 3,4 0,1.5; 1.2,2.5 3,0"),
    "l": (1.5, "0.5,6 0.5,1q 1.5,0"),
    "m": (5.0, "0,4 0,0; 0,2.75Q 1.25,4Q 2.5,2.75 2.5,0; 2.5,2.75Q 3.75,4Q 5,2.75 5,0"),
    "n": (3.0, "0,4 0,0; 0,2.5Q 1.5,4Q 3,2.5 3,0"),
    "o": (3.0, "1.5,4q 0,2.5 0,1.5q 1.5,0q 3,1.5 3,2.5q 1.5,4"),
    "p": (3.0, "0,4 0,-2; 0,2.5Q 1.5,4Q 3,2.5 3,1.5Q 1.5,0Q 0,1.5"),
    "q": (3.0, "3,4 3,-2; 3,2.5q 1.5,4q 0,2.5 0,1.5q 1.5,0q 3,1.5"),
    "r": (2.2, "0,4 0,0; 0,2.5Q 1.5,4 2.2,4"),
    "s": (3.0, "3,4 1,4h 1,2 2,2H 2,0 0,0"),
    "t": (2.4, "0.75,6 0.75,1q 1.75,0 2.4,0; 0,4 2.2,4"),
    "u": (3.0, "0,4 0,1.5q 1.5,0q 3,1.5; 3,4 3,0"),
    "v": (3.0, "0,4 1.5,0 3,4"),
    "w": (4.6, "0,4 1.15,0 2.3,3 3.45,0 4.6,4"),
    "x": (3.0, "0,0 3,4; 0,4 3,0"),
    "y": (3.0, "0,4 1.5,0; 3,4 0.75,-2"),
    "z": (3.0, "0,4 3,4 0,0 3,0"),
    "0": (4.0, "2,6q 0,4 0,2q 2,0q 4,2 4,4q 2,6; 1,1.5 3,4.5"),
    "1": (3.0, "0,4.5 1.5,6 1.5,0; 0,0 3,0"),
    "2": (4.0, "0,4Q 2,6Q 4,4E 3.414214,2.585786 0,0 4,0"),
    "3": (4.0, "0,4.5Q 1.5,6 2.5,6H 2.5,3 1.5,3; 2.5,3H 2.5,0 1.5,0Q 0,1.5"),
    "4": (4.0, "3,0 3,6 0,2 4,2"),
    "5": (4.0, "3.6,6 0,6 0,3.5 2.25,3.5H 2.25,0 0,0"),
    "6": (4.0, "3.4,6 2,6q 0,4 0,2q 2,0q 4,2q 2,4q 0,2"),
    "7": (4.0, "0,6 4,6 1.5,0"),
    "8": (3.6, "1.8,3.2h 1.8,6h 1.8,3.2h 1.8,0h 1.8,3.2"),
    "9": (4.0, "0.6,0 2,0q 4,2 4,4q 2,6q 0,4q 2,2q 4,4"),
    ".": (1.0, "0.5,0 0.5,0.4"),
    ",": (1.0, "0.7,0.5 0.2,-1"),
    ":": (1.0, "0.5,0 0.5,0.4; 0.5,3.2 0.5,3.6"),
    ";": (1.0, "0.7,0.5 0.2,-1; 0.5,3.2 0.5,3.6"),
    "-": (3.0, "0.3,2.5 2.7,2.5"),
    "_": (4.0, "0,-1 4,-1"),
    "+": (4.0, "2,1 2,5; 0,3 4,3"),
    "=": (4.0, "0,2 4,2; 0,4 4,4"),
    "/": (3.0, "0,-0.5 3,6.5"),
    "\\": (3.0, "0,6.5 3,-0.5"),
    "|": (1.0, "0.5,-1 0.5,6.5"),
    "(": (1.6, "1.6,6.5e 0,3e 1.6,-0.5"),
    ")": (1.6, "0,-0.5e 1.6,3e 0,6.5"),
    "[": (1.5, "1.5,6.5 0,6.5 0,-0.5 1.5,-0.5"),
    "]": (1.5, "0,6.5 1.5,6.5 1.5,-0.5 0,-0.5"),
    "<": (4.0, "4,1 0,3 4,5"),
    ">": (4.0, "0,1 4,3 0,5"),
    "*": (3.0, "1.5,1.5 1.5,4.5; 0.2,2.25 2.8,3.75; 0.2,3.75 2.8,2.25"),
    "#": (4.4, "1,0 1.8,6; 2.6,0 3.4,6; 0,2 4,2; 0.4,4 4.4,4"),
    "%": (5.0, "0.5,0 4.5,6; 1,6h 1,4h 1,6; 4,2h 4,0h 4,2"),
    "&": (4.0, "4,0 0.7,4.2E 0.5,5Q 1.5,6Q 2.5,5Q 1.9,3.8 0.6,2.7e 0,1.5q 1.5,0q 4,2.5"),
    "!": (1.0, "0.5,6 0.5,2; 0.5,0 0.5,0.4"),
    "?": (3.0, "0,4.5Q 1.5,6Q 3,4.5Q 1.5,3 1.5,2; 1.5,0 1.5,0.4"),
    "'": (1.0, "0.5,4.8 0.5,6"),
    '"': (1.8, "0.4,4.8 0.4,6; 1.4,4.8 1.4,6"),
    "°": (1.6, "0.8,6h 0.8,4.4h 0.8,6"),
    "×": (3.0, "0,1 3,4; 0,4 3,1"),
    "±": (4.0, "2,1.5 2,5.5; 0,3.5 4,3.5; 0,0 4,0"),
    "Ø": (4.0, "2,6q 0,4 0,2q 2,0q 4,2 4,4q 2,6; 0,-0.5 4,6.5"),
}  # fmt: skip


@dataclass(frozen=True)
class Text:
    """One line of engraved text.

    Parameters
    ----------
    position : pair of float
        Left end of the base line, mm.
    text : str
        Letters A-Z, a-z, digits and common punctuation.
    height : float
        Height of capitals, mm.
    angle : float
        Direction of the base line, rad.
    layer : str
        Name of the layer, "ENGRAVE" unless told.

    Raises
    ------
    InputError
        The height is not positive, or the alphabet lacks a character.
    """

    position: tuple[float, float]
    text: str
    height: float
    angle: float = 0.0
    layer: str = "ENGRAVE"

    def __post_init__(self) -> None:
        x, y = self.position
        if not np.all(np.isfinite([x, y, self.height, self.angle])) or self.height <= 0:
            raise InputError(
                f"text {self.text!r} needs a finite position and angle, and a positive height in mm"
            )
        object.__setattr__(self, "position", (float(x), float(y)))
        missing = sorted(set(self.text) - set(_GLYPHS))
        if missing:
            raise InputError(
                f"text {self.text!r}: the engraving alphabet has no {', '.join(map(repr, missing))}; "
                "use A-Z, a-z, 0-9 and common punctuation"
            )


def engravable(text: str) -> str:
    """The text in letters that can be engraved: accents are left out, unknown letters become underscores.

    Examples
    --------
    >>> engravable("Träger")
    'Trager'
    """
    plain = normalize("NFKD", text.replace("ß", "ss"))
    return "".join(c if c in _GLYPHS else "_" for c in plain if not combining(c))


def text_width(text: str, height: float) -> float:
    """Length of a line of text, mm, whose capitals are `height` mm high.

    Examples
    --------
    >>> text_width("H", 6.0)
    4.0
    """
    widths = [_GLYPHS[c][0] for c in Text((0.0, 0.0), text, height).text]
    return (sum(widths) + _GAP * max(0, len(widths) - 1)) * height / CAP_HEIGHT


def text_strokes(text: Text) -> tuple[Path, ...]:
    """The strokes of a text as open paths of lines and arcs, mm.

    Examples
    --------
    >>> strokes = text_strokes(Text((10, 0), "AL", 5.0))
    >>> len(strokes), round(float(max(path.bounds[1, 1] for path in strokes)), 9)
    (3, 5.0)
    """
    scale = text.height / CAP_HEIGHT
    c, s = scale * np.cos(text.angle), scale * np.sin(text.angle)
    x, y = text.position
    placed: list[Path] = []
    advance = 0.0
    for character in text.text:
        frame = np.array([[c, -s, x + c * advance], [s, c, y + s * advance], [0.0, 0.0, 1.0]])
        placed.extend(stroke.transformed(frame) for stroke in _glyph(character))
        advance += _GLYPHS[character][0] + _GAP
    return tuple(placed)


@lru_cache(maxsize=len(_GLYPHS))
def _glyph(character: str) -> tuple[Path, ...]:
    return tuple(_strokes(_GLYPHS[character][1]))


def _strokes(code: str) -> Iterator[Path]:
    for stroke in filter(None, code.split(";")):
        tokens = stroke.split()
        bulges = [_BULGES.get(token[-1], 0.0) for token in tokens]
        points = [[float(v) for v in token.rstrip("".join(_BULGES)).split(",")] for token in tokens]
        yield Path.polyline(points, bulges)
