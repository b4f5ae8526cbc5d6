"""Paths as SVG writes them."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment

_LETTERS = {2: "Q", 3: "C"}


def path_data(path: Path, origin: FloatArray) -> str:
    """The d attribute of a path of lines, arcs and clamped polynomial splines of degree 2 and 3.

    Parameters
    ----------
    path : Path
    origin : (2,) array
        The upper left corner of the sheet, mm; y runs downward there.

    Examples
    --------
    >>> path_data(Path.rectangle(40, 10), np.array([-1.0, 11.0]))
    'M1,11L41,11L41,1L1,1Z'
    """
    # the closing line is drawn by Z
    closing = path.closed and isinstance(path.segments[-1], Line)
    drawn = path.segments[:-1] if closing else path.segments
    strokes = [f"M{_place(path.start, origin)}", *(_stroke(segment, origin) for segment in drawn)]
    return "".join([*strokes, "Z" if path.closed else ""])


def format_length(value: float) -> str:
    """A length to 1e-6 mm, as short as it goes."""
    short = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if short == "-0" else short


def _place(point: FloatArray, origin: FloatArray) -> str:
    return f"{format_length(point[0] - origin[0])},{format_length(origin[1] - point[1])}"


def _stroke(segment: Segment, origin: FloatArray) -> str:
    if isinstance(segment, Line):
        return f"L{_place(segment.end, origin)}"
    if isinstance(segment, Arc):
        radius, turns = format_length(segment.radius), "0" if segment.sweep > 0 else "1"
        # more than half a turn in two parts: a whole turn has no ends, and nearly one is badly conditioned
        long = abs(segment.sweep) > np.pi * (1 + 1e-9)
        ends = segment.at(np.array([0.5, 1.0] if long else [1.0]))
        return "".join(f"A{radius} {radius} 0 0 {turns} {_place(end, origin)}" for end in ends)
    letter = _LETTERS[segment.curve.degree]
    pieces = [piece[1:, :2] / piece[1:, 2:] for _, _, piece in segment.curve.bezier_pieces()]
    return "".join(letter + " ".join(_place(point, origin) for point in piece) for piece in pieces)
