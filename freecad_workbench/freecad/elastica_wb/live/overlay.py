# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The overlay in the 3D view: a few permanent Coin nodes whose points change."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.curve_picture import Picture
from freecad.elastica_wb.live.preview import add_group, marks_in_plane
from freecad.elastica_wb.solving.verdicts import Verdict
from pivy import coin

from elastica_cad._types import FloatArray
from elastica_cad.errors import note

# distance, mm, of the overlay above the plane of the sketch
LIFT_MM = 0.02
FULL, DASHED, DOTTED = 0xFFFF, 0xF0F0, 0xCCCC
DOT, DIAMOND, SQUARE = (
    coin.SoMarkerSet.CIRCLE_FILLED_9_9, coin.SoMarkerSet.DIAMOND_FILLED_9_9, coin.SoMarkerSet.SQUARE_FILLED_9_9,
)  # fmt: skip
Color = tuple[float, float, float]
COLORS: dict[Verdict, Color] = {
    Verdict.CAN: (0.08, 0.53, 0.24),
    Verdict.BREAKS: (0.78, 0.36, 0.0),
    Verdict.CANNOT: (0.85, 0.18, 0.18),
    Verdict.NOTHING: (0.42, 0.42, 0.45),
}
"""Colour (red, green, blue) of each verdict, of medium lightness for light and dark backgrounds."""
HELD: Color = (0.10, 0.33, 0.66)
LABEL, LABEL_GROUND, LABEL_SIZE = (1.0, 1.0, 1.0), (0.13, 0.13, 0.15), 10


@dataclass(frozen=True)
class Part:
    """A part of the overlay: lines or marks, with a symbol and text in the legend."""

    color: Color
    sign: str
    words: str
    width: float = 0.0
    pattern: int = FULL
    marker: int = DOT


PARTS = {
    "comb": Part((0.13, 0.49, 0.83), "▬", QT_TRANSLATE_NOOP("Elastica", "curvature"), 1.0),
    "strained": Part(
        COLORS[Verdict.CANNOT], "▬", QT_TRANSLATE_NOOP("Elastica", "above the sheet's limit"), 1.0
    ),
    "width": Part((0.66, 0.44, 0.20), "▬", QT_TRANSLATE_NOOP("Elastica", "the strip laid flat"), 2.0),
    "line": Part(COLORS[Verdict.CAN], "▬", QT_TRANSLATE_NOOP("Elastica", "inflection line"), 2.0),
    "thrust": Part(COLORS[Verdict.CAN], "▬", QT_TRANSLATE_NOOP("Elastica", "thrust line"), 2.0),
    "cords": Part(HELD, "┈", QT_TRANSLATE_NOOP("Elastica", "cord"), 1.5, DOTTED),
    "stations": Part(HELD, "■", QT_TRANSLATE_NOOP("Elastica", "rail, pin, tie or load"), marker=SQUARE),
    "nearest": Part((0.62, 0.35, 0.85), "╍", QT_TRANSLATE_NOOP("Elastica", "nearest curve"), 3.0, DASHED),
    "on_line": Part(COLORS[Verdict.CAN], "●", QT_TRANSLATE_NOOP("Elastica", "inflection on the line")),
    "off_line": Part(COLORS[Verdict.CANNOT], "●", QT_TRANSLATE_NOOP("Elastica", "inflection off it")),
    "crossings": Part(
        COLORS[Verdict.CANNOT],
        "◆",
        QT_TRANSLATE_NOOP("Elastica", "the line must not meet the curve here"),
        marker=DIAMOND,
    ),
}

LINES, MARKS = ("comb", "strained", "thrust", "cords"), ("on_line", "off_line", "crossings")
"""Parts that show the fields of `Picture` with the same names: tuples of lines, and arrays of points."""


class Overlay:
    """The overlay of a sketch."""

    def __init__(self, view: Any, placement: Any) -> None:
        self._scene = view.getSceneGraph()
        self.root = marks_in_plane("ElasticaOverlay", placement)
        self.root.renderCaching = coin.SoSeparator.OFF
        self._parts = {name: _Points(self.root, part) for name, part in PARTS.items()}
        self._labels = coin.SoSeparator()
        self.root.addChild(self._labels)
        self._scene.addChild(self.root)

    def show(self, *pictures: Picture, titles: Sequence[tuple[tuple[float, float], str]] = ()) -> None:
        """Show curvature, inflections and inflection lines of curves.

        `titles` are texts with their positions.
        """
        stations = [station for picture in pictures for station in picture.stations]
        self._set(
            **{name: [line for picture in pictures for line in getattr(picture, name)] for name in LINES},
            **{name: [getattr(picture, name) for picture in pictures] for name in MARKS},
            line=[picture.line for picture in pictures if picture.line is not None],
            stations=(np.array([place for place, _ in stations]).reshape(-1, 2),),
        )
        lengths = [
            (place, note("{far}", far=distance)) for picture in pictures for place, distance in picture.labels
        ]
        self._write([*titles, *lengths, *((place, noun) for place, noun in stations if noun)])

    def clear(self) -> None:
        """Hide everything."""
        self._set(**dict.fromkeys(self._parts, ()))
        self._write(())

    def show_width(self, edges: Sequence[FloatArray]) -> None:
        """Show both edges of the strip, or none for an empty sequence."""
        self._set(width=edges)

    def show_nearest(self, *curves: FloatArray) -> None:
        """Show the nearest possible curve, or the curves of a suggested change. Earlier curves are removed."""
        self._set(nearest=curves)

    def shown(self) -> dict[str, int]:
        """Return the number of points in each part."""
        return {name: part.count for name, part in self._parts.items()}

    def remove(self) -> None:
        """Remove everything from the view."""
        self._scene.removeChild(self.root)

    def _set(self, **pieces: Sequence[FloatArray]) -> None:
        for name, lines in pieces.items():
            self._parts[name].set(lines)

    def _write(self, labels: Iterable[tuple[tuple[float, float], str]]) -> None:
        self._labels.removeAllChildren()
        for (x, y), words in labels:
            place, label = coin.SoTranslation(), _label()
            place.translation = (x, y, LIFT_MM)
            label.string.setValue(worded(words))
            add_group(self._labels, place, label)


def _label() -> Any:
    label = coin.SoType.fromName("SoFrameLabel").createInstance()
    label.textColor, label.backgroundColor, label.size = LABEL, LABEL_GROUND, LABEL_SIZE
    return label


class _Points:
    """Lines or marks of one colour. Coin nodes are cached, because finding them is slow."""

    def __init__(self, root: Any, part: Part) -> None:
        points, paint = coin.SoCoordinate3(), coin.SoBaseColor()
        shape, style = coin.SoLineSet() if part.width else coin.SoMarkerSet(), coin.SoDrawStyle()
        paint.rgb, style.linePattern = part.color, part.pattern
        if part.width:
            style.lineWidth = part.width
        else:
            shape.markerIndex.setValue(part.marker)
        self._places = points.point
        self._lengths = shape.numVertices if part.width else None
        self._count = None if part.width else shape.numPoints
        self.count = -1
        add_group(root, paint, style, points, shape)
        self.set([])

    def set(self, pieces: Sequence[FloatArray]) -> None:
        pieces = [piece for piece in pieces if len(piece)]
        if not pieces and self.count == 0:
            return
        lengths = [len(piece) for piece in pieces] or [0]
        self.count = sum(lengths)
        rows = np.full((self.count, 3), LIFT_MM)
        if pieces:
            rows[:, :2] = np.concatenate(pieces)
        self._places.setNum(self.count)
        if pieces:
            self._places.setValues(0, self.count, rows.tolist())
        if self._lengths is None:
            self._count.setValue(self.count)
        else:
            self._lengths.setNum(len(lengths))
            self._lengths.setValues(0, len(lengths), lengths)
