# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What is not in the document yet: lines in the view, a strip as it would bend, handles to drag it by."""

from collections.abc import Callable
from typing import Any

import numpy as np
from freecad.elastica_wb.preview.handles import Handles, Place, plane_node
from pivy import coin

from elastica_cad._types import ArrayLike, FloatArray

BEFORE, AFTER, FRAME = (0.6, 0.6, 0.6), (0.9, 0.35, 0.1), (0.1, 0.45, 0.95)
GLASS = 0.35  # transparency of a strip that is not made yet


class Preview:
    """Two curves in a plane, before and after; the strip that stands on the second; handles."""

    def __init__(self, view: Any, placement: Any) -> None:
        self._view, self._placement = view, placement
        self._scene = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self.root.setName("ElasticaPreview")
        place = plane_node(placement)
        self.root.addChild(place)
        self._strip = _Ribbon(self.root)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self.root.addChild(light)
        self._before, self._after = self._line(BEFORE, 1.5), self._line(AFTER, 4.0)
        self._frame = self._line(FRAME, 1.0)
        self.handles: Handles | None = None
        self._scene.addChild(self.root)

    def show(self, before: FloatArray, after: FloatArray, frame: FloatArray | None = None) -> None:
        """Replace both curves (n, 2), and the frame that the handles stand on."""
        for points, line in (
            (before, self._before),
            (after, self._after),
            (np.zeros((0, 2)) if frame is None else frame, self._frame),
        ):
            coordinates, shape = line
            rows = np.column_stack([points, np.zeros(len(points))])
            coordinates.point.setNum(len(rows))
            coordinates.point.setValues(0, len(rows), rows.tolist())
            shape.numVertices.setValues(0, 1, [len(rows)])

    def show_strip(self, middle: FloatArray, width: FloatArray) -> None:
        """The strip (its widths (n,)) as it stands on a curve (n, 2)."""
        self._strip.set(middle, width)

    def add_handles(
        self,
        places: ArrayLike,
        moved: Callable[[int, Place], None],
        released: Callable[[], None] | None = None,
    ) -> None:
        """Handles at places (n, 2); `moved` is told which one was dragged and where to."""
        self.handles = Handles(self._view, self._placement, places, moved, released)

    def remove(self) -> None:
        """Take everything off the view."""
        self._scene.removeChild(self.root)
        if self.handles is not None:
            self.handles.remove()

    def _line(self, color: tuple[float, float, float], width: float) -> tuple[Any, Any]:
        group, style, paint = coin.SoSeparator(), coin.SoDrawStyle(), coin.SoBaseColor()
        style.lineWidth, paint.rgb = width, color
        coordinates, shape = coin.SoCoordinate3(), coin.SoLineSet()
        for node in (paint, style, coordinates, shape):
            group.addChild(node)
        self.root.addChild(group)
        return coordinates, shape


class _Ribbon:
    """A strip without thickness, half of its width on either side of the plane."""

    def __init__(self, root: Any) -> None:
        group, material, hints = coin.SoSeparator(), coin.SoMaterial(), coin.SoShapeHints()
        material.diffuseColor, material.transparency = AFTER, GLASS
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # lit from both sides
        self._points, self._mesh = coin.SoCoordinate3(), coin.SoQuadMesh()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, material, hints, self._points, self._mesh):
            group.addChild(node)
        root.addChild(group)

    def set(self, middle: FloatArray, width: FloatArray) -> None:
        rows = np.concatenate([np.column_stack([middle, side * width / 2]) for side in (-1.0, 1.0)])
        self._points.point.setNum(len(rows))
        self._points.point.setValues(0, len(rows), rows.tolist())
        self._mesh.verticesPerRow, self._mesh.verticesPerColumn = len(middle), 2
