# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The overlay in the 3D view: a few Coin nodes whose points are replaced, never rebuilt."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.curve_picture import Picture
from freecad.elastica_wb.live.verdict import Verdict
from freecad.elastica_wb.preview.handles import plane_node
from pivy import coin

from elastica_cad._types import FloatArray
from elastica_cad.refusals import Length, note

LIFT_MM = 0.02  # above the sketch's own lines
DASHED = 0xF0F0
COLORS = {
    "comb": (0.13, 0.49, 0.83),
    "line": (0.71, 0.42, 0.05),
    "nearest": (0.62, 0.35, 0.85),
    "width": (0.66, 0.44, 0.20),
    Verdict.CAN: (0.08, 0.53, 0.24),
    Verdict.BREAKS: (0.78, 0.36, 0.0),
    Verdict.CANNOT: (0.85, 0.18, 0.18),
    Verdict.NOTHING: (0.42, 0.42, 0.45),
}
"""Red, green, blue; of middle lightness, so that they stand out from light backgrounds and from dark ones."""


class Overlay:
    """Everything that is shown over one sketch."""

    def __init__(self, view: Any, placement: Any) -> None:
        self._scene = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self.root.setName("ElasticaOverlay")
        self.root.renderCaching = coin.SoSeparator.OFF
        plain = coin.SoLightModel()
        plain.model = coin.SoLightModel.BASE_COLOR
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        depth = coin.SoDepthBuffer()
        depth.test = False
        for node in (pick, plain, depth, plane_node(placement)):
            self.root.addChild(node)
        self._comb = self._lines(COLORS["comb"], 1.0)
        self._width = self._lines(COLORS["width"], 2.0)
        self._line = self._lines(COLORS["line"], 2.0)
        self._nearest = self._lines(COLORS["nearest"], 3.0, DASHED)
        self._good = self._marks(COLORS[Verdict.CAN], coin.SoMarkerSet.CIRCLE_FILLED_9_9)
        self._bad = self._marks(COLORS[Verdict.CANNOT], coin.SoMarkerSet.CIRCLE_FILLED_9_9)
        self._crossings = self._marks(COLORS[Verdict.CANNOT], coin.SoMarkerSet.DIAMOND_FILLED_9_9)
        self._texts = coin.SoSeparator()
        self.root.addChild(self._texts)
        self._scene.addChild(self.root)

    def show(self, picture: Picture) -> None:
        """Show curvature, inflections and inflection line of a curve."""
        self._comb.set(picture.comb)
        self._line.set([] if picture.line is None else [picture.line])
        self._line.color(COLORS[Verdict.CAN] if picture.realizable else COLORS["line"])
        self._good.set([picture.on_line])
        self._bad.set([picture.off_line])
        self._crossings.set([picture.crossings])
        self._write(picture.distances)

    def clear(self) -> None:
        """Show nothing."""
        for part in (
            self._comb,
            self._width,
            self._line,
            self._nearest,
            self._good,
            self._bad,
            self._crossings,
        ):
            part.set([])
        self._write(())

    def show_width(self, edges: Sequence[FloatArray]) -> None:
        """Show both edges of the strip; an empty sequence hides them."""
        self._width.set(edges)

    def show_nearest(self, points: FloatArray | None) -> None:
        """The nearest curve that can be bent; None hides it."""
        self._nearest.set([] if points is None else [points])

    def shown(self) -> dict[str, int]:
        """How many points each part shows: for tests and for the curious."""
        parts = {
            "comb": self._comb, "width": self._width, "line": self._line, "nearest": self._nearest,
            "on line": self._good, "off line": self._bad, "crossings": self._crossings,
        }  # fmt: skip
        return {name: part.count for name, part in parts.items()}

    def remove(self) -> None:
        """Remove everything from the view."""
        self._scene.removeChild(self.root)

    def _lines(self, color: tuple[float, float, float], width: float, pattern: int = 0xFFFF) -> "_Points":
        style = coin.SoDrawStyle()
        style.lineWidth, style.linePattern = width, pattern
        return _Points(self.root, color, style, coin.SoLineSet())

    def _marks(self, color: tuple[float, float, float], marker: int) -> "_Points":
        shape = coin.SoMarkerSet()
        shape.markerIndex.setValue(marker)
        return _Points(self.root, color, None, shape)

    def _write(self, texts: Iterable[tuple[tuple[float, float], Length]]) -> None:
        self._texts.removeAllChildren()
        for (x, y), far in texts:
            part, color, place = coin.SoSeparator(), coin.SoBaseColor(), coin.SoTranslation()
            color.rgb = COLORS[Verdict.BREAKS]
            place.translation = (x, y, LIFT_MM)
            text, font = coin.SoText2(), coin.SoFont()
            font.size = 14.0
            text.string = f"  {worded(note('{far}', far=far))}"
            for node in (color, place, font, text):
                part.addChild(node)
            self._texts.addChild(part)


class _Points:
    """Lines or marks of one colour; the fields are kept, since every look for one costs as much as filling it."""

    def __init__(self, root: Any, color: tuple[float, float, float], style: Any, shape: Any) -> None:
        points, self._paint, group = coin.SoCoordinate3(), coin.SoBaseColor(), coin.SoSeparator()
        self._places = points.point
        self._lengths = shape.numVertices if isinstance(shape, coin.SoLineSet) else None
        self._count = None if self._lengths is not None else shape.numPoints
        self._color: tuple[float, float, float] | None = None
        self.count = -1
        self.color(color)
        for node in (self._paint, style, points, shape):
            if node is not None:
                group.addChild(node)
        root.addChild(group)
        self.set([])

    def color(self, color: tuple[float, float, float]) -> None:
        if color != self._color:
            self._paint.rgb = self._color = color

    def set(self, pieces: Sequence[FloatArray]) -> None:
        """Replace the points; each piece is one line."""
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
