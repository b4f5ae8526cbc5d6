"""A shape that is not in the document yet: lines in the view, and a handle to drag its end by."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from pivy import coin

from elastica_cad._types import FloatArray

__all__ = ["Lines", "Preview"]

BEFORE, AFTER = (0.6, 0.6, 0.6), (0.9, 0.35, 0.1)


class Preview:
    """Two curves in a plane, before and after, and a dragger."""

    def __init__(self, view: Any, placement: Any) -> None:
        self._scene = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self.root.setName("ElasticaPreview")
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        place = coin.SoMatrixTransform()
        rows = np.array(placement.toMatrix().A, dtype=float).reshape(4, 4).T
        place.matrix.setValue(*rows.ravel().tolist())
        for node in (light, place):
            self.root.addChild(node)
        self._before, self._after = self._line(BEFORE, 1.5), self._line(AFTER, 4.0)
        self._dragger: Any = None
        self._scene.addChild(self.root)

    def show(self, before: FloatArray, after: FloatArray) -> None:
        """Replace both curves (n, 2)."""
        for points, line in ((before, self._before), (after, self._after)):
            coordinates, shape = line
            rows = np.column_stack([points, np.zeros(len(points))])
            coordinates.point.setNum(len(rows))
            coordinates.point.setValues(0, len(rows), rows.tolist())
            shape.numVertices.setValues(0, 1, [len(rows)])

    def add_dragger(self, place: FloatArray, moved: Callable[[tuple[float, float]], None]) -> None:
        """A handle at `place` that says where it was dragged to."""
        start, size = np.asarray(place, dtype=float), 4.0
        group, shift, scale = coin.SoSeparator(), coin.SoTranslation(), coin.SoScale()
        shift.translation = (float(start[0]), float(start[1]), 0.0)
        scale.scaleFactor = (size, size, size)
        self._dragger = coin.SoTranslate2Dragger()

        def tell(*_: Any) -> None:
            x, y, _ = self._dragger.translation.getValue().getValue()
            moved((start[0] + size * x, start[1] + size * y))

        self._tell = tell
        self._dragger.addMotionCallback(tell, self._dragger)
        for node in (shift, scale, self._dragger):
            group.addChild(node)
        self.root.addChild(group)

    def drag(self, x: float, y: float) -> None:
        """Move the handle as a mouse would, mm from its place."""
        self._dragger.translation.setValue(x / 4.0, y / 4.0, 0.0)
        self._tell()

    def remove(self) -> None:
        """Take everything off the view."""
        self._scene.removeChild(self.root)

    def _line(self, color: tuple[float, float, float], width: float) -> tuple[Any, Any]:
        group, style, paint = coin.SoSeparator(), coin.SoDrawStyle(), coin.SoBaseColor()
        style.lineWidth, paint.rgb = width, color
        coordinates, shape = coin.SoCoordinate3(), coin.SoLineSet()
        for node in (paint, style, coordinates, shape):
            group.addChild(node)
        self.root.addChild(group)
        return coordinates, shape


class Lines:
    """Lines in space, of several colours: what is going to be made."""

    def __init__(self, view: Any) -> None:
        self._scene = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self.root.setName("ElasticaLines")
        self._scene.addChild(self.root)

    def show(self, groups: Iterable[tuple[tuple[float, float, float], float, Sequence[FloatArray]]]) -> None:
        """Replace everything: colour, width and lines (n, 3) of each group."""
        self.root.removeAllChildren()
        light, pick = coin.SoLightModel(), coin.SoPickStyle()
        light.model, pick.style = coin.SoLightModel.BASE_COLOR, coin.SoPickStyle.UNPICKABLE
        depth = coin.SoDepthBuffer()
        depth.test = False  # what the object hides is to be seen too
        for node in (light, pick, depth):
            self.root.addChild(node)
        for color, width, lines in groups:
            if not lines:
                continue
            part, style, paint = coin.SoSeparator(), coin.SoDrawStyle(), coin.SoBaseColor()
            style.lineWidth, paint.rgb = width, color
            points, shape = coin.SoCoordinate3(), coin.SoLineSet()
            rows = np.concatenate(lines)
            points.point.setValues(0, len(rows), rows.tolist())
            shape.numVertices.setValues(0, len(lines), [len(line) for line in lines])
            for node in (paint, style, points, shape):
                part.addChild(node)
            self.root.addChild(part)

    def remove(self) -> None:
        """Take everything off the view."""
        self._scene.removeChild(self.root)
