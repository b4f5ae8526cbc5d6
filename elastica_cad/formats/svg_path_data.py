"""Conversion of SVG path data (commands and numbers in the attribute `d`) to edges.

SVG 2, section 9.3 ("Path data") and appendix B.2 (arcs). https://www.w3.org/TR/SVG2/paths.html
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.source_file import MOST_PIECES, NUMBER, check_count, half_last_place
from elastica_cad.geometry.plane_points import is_straight, left_of

# the flags of an arc (f) need no separator
_PARTS = {"n": rf"((?>{NUMBER}))[\s,]*+", "f": r"([01])[\s,]*+"}


def _arguments(parts: str) -> re.Pattern[str]:
    """Return the pattern of the numbers after a command. If numbers are missing, the last groups are None."""
    pattern = ""
    for part in reversed(parts):
        pattern = f"(?:{_PARTS[part]}{pattern})?"
    return re.compile(rf"[\s,]*+{pattern}")


_ARGUMENTS = {
    "M": _arguments("nn"), "L": _arguments("nn"), "H": _arguments("n"), "V": _arguments("n"),
    "C": _arguments("nnnnnn"), "S": _arguments("nnnn"), "Q": _arguments("nnnn"), "T": _arguments("nn"),
    "A": _arguments("nnnffnn"), "Z": _arguments(""),
}  # fmt: skip
# commands after which S and T mirror the handle
_AFTER = {"S": "CS", "T": "QT"}


@dataclass(frozen=True, eq=False)
class PathData:
    """The edges of an SVG path, in user units.

    Attributes
    ----------
    runs : tuple of tuple of Edge
        The edges of every subpath.
    rounding : float
        Half a unit of the last digit of the coordinates.
    """

    runs: tuple[tuple[Edge, ...], ...]
    rounding: float


def path_data(text: str) -> PathData:
    """Parse a path's `d` attribute into runs of edges.

    Examples
    --------
    >>> path_data("M0 0 Q 10 20 30 0 S 50 10 60 0").runs[0][1].points.tolist()
    [[30.0, 0.0], [30.0, 0.0], [50.0, 10.0], [60.0, 0.0]]
    """
    # coordinates as written, for the rounding, and the command before
    runs, written, before = [list[Edge]()], list[str](), ""
    # present point, start of the subpath, and the control point before the present point
    here = start = handle = np.zeros(2)
    for count, (command, words) in enumerate(_commands(text), start=1):
        # a path may have subpaths, of which each is a curve
        check_count(count, 20 * MOST_PIECES, "commands in one path or more", "simplify the path")
        kind, values = command.upper(), np.array([float(word) for word in words])
        if not np.all(np.abs(values) < 1e15):
            odd = next(word for word in words if not abs(float(word)) < 1e15)
            raise InputError("has the unusable number {odd} in a path: export the file again", odd=odd)
        # the first five numbers of an arc are radii, an angle and flags
        written += words[5:] if kind == "A" else words
        origin = here if command.islower() else np.zeros(2)
        if kind == "A":
            points = np.array([here, origin + values[5:]])
            edge = _arc_edge(
                points[0], points[1], np.abs(values[:2]), float(np.radians(values[2] % 360.0)),
                large=bool(values[3]), sweep=bool(values[4]),
            )  # fmt: skip
        else:
            if kind in "HV":
                axis = "HV".index(kind)
                following = here[None].copy()
                following[0, axis] = values[0] + origin[axis]
            else:
                following = start[None] if kind == "Z" else values.reshape(-1, 2) + origin
            if kind in _AFTER:
                # the mirrored handle of the curve before, if there is one
                mirrored = 2 * here - handle if before in _AFTER[kind] else here
                following = np.vstack([mirrored, following])
            points = np.vstack([here, following])
            edge = None if kind == "M" else _bezier_edge(points)
        if edge is not None:
            runs[-1].append(edge)
        if kind in "MZ":
            runs.append([])
        start = points[-1] if kind == "M" else start
        here, handle, before = points[-1], points[-2], kind
    return PathData(tuple(tuple(run) for run in runs if run), half_last_place(written))


def _commands(text: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield every command with its numbers. A command that is repeated implicitly is yielded again."""
    text = text.lstrip(", \t\r\n\f")
    at, command, allowed = 0, "", "Mm"
    while at < len(text):
        if text[at] in allowed:
            command, at, allowed = text[at], at + 1, "MmLlHhVvCcSsQqTtAaZz"
        elif command in "zZ":
            raise _broken(text, at)
        match = _ARGUMENTS[command.upper()].match(text, at)
        if match is None or None in match.groups():
            raise _broken(text, match.end() if match else at)
        yield command, match.groups()
        # numbers without a command repeat the last command, after a move as lines
        command, at = {"M": "L", "m": "l"}.get(command, command), match.end()


def _broken(text: str, at: int) -> InputError:
    done = " ".join(text[max(0, at - 24) : at].split())
    after = f"after ...{done!r}" if done else "at their beginning"
    return InputError("has incomplete or invalid path data {after}: export it again", after=after)


def _bezier_edge(points: FloatArray) -> Edge | None:
    """Return the edge of a Bezier piece: a line if it is straight, None if it has no length."""
    if not np.any(points != points[0]):
        return None
    # a straight piece whose handles point backward is no line
    is_line = is_straight(points) and np.all(np.diff(points, axis=0) @ (points[-1] - points[0]) >= 0)
    return Edge.polyline(points[[0, -1]]) if is_line else Edge.bezier(points)


def _arc_edge(
    start: FloatArray, end: FloatArray, radii: FloatArray, turned: float, *, large: bool, sweep: bool
) -> Edge | None:
    """Return the exact elliptic arc between two points. Too small radii are enlarged.

    Parameters
    ----------
    radii : (2,) array
        Semi-axes; if one is 0, the arc is a line.
    turned : float
        Angle of the first semi-axis to the x axis, rad.
    large, sweep : bool
        Flags of the SVG arc command.
    """
    if not np.any(start != end):
        return None
    if radii.min() <= 1e-12 * np.abs(end - start).max():
        return Edge.polyline([start, end])
    c, s = np.cos(turned), np.sin(turned)
    axes = np.array([[c, -s], [s, c]]) * radii
    # in units of the semi-axes, the arc is part of a unit circle, centred on the bisector of the chord
    half = np.linalg.solve(axes, (end - start) / 2)
    reach = float(np.hypot(*half))
    if reach < 1e-12:
        return None
    rest = 1 - reach**2
    along = np.sqrt(rest) / reach if rest > 1e-12 else 0.0
    middle = (along if (not large) == sweep else -along) * left_of(half)
    if along == 0.0:
        axes, half = axes * reach, half / reach
    begin = np.arctan2(*(-half - middle)[::-1])
    turn = np.arctan2(*(half - middle)[::-1]) - begin
    turn = turn % (2 * np.pi) if sweep else -((-turn) % (2 * np.pi))
    center = (start + end) / 2 + axes @ middle
    return Edge.arc(center, axes[:, 0], axes[:, 1], float(begin), float(begin + turn))
