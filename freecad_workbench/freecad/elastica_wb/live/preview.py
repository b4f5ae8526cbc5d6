# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Previews in the 3D view: lines, a bent strip, and handles for dragging."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from freecad.elastica_wb.host.qt import QtCore, kind_of, later, surface_of
from pivy import coin

from elastica_cad._types import ArrayLike, FloatArray

Place = tuple[float, float]

BEFORE, AFTER, FRAME = (0.6, 0.6, 0.6), (0.9, 0.35, 0.1), (0.1, 0.45, 0.95)
# transparency of the strip in a preview, 0 to 1
GLASS = 0.35


class Preview:
    """Preview of a changed curve: before and after the change, the strip along the new curve, and handles."""

    def __init__(self, view: Any, placement: Any) -> None:
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
        """Show the curves (n, 2) before and after a change, and the line `frame` (n, 2) between the handles,
        mm.
        """
        for points, line in (
            (before, self._before),
            (after, self._after),
            (np.zeros((0, 2)) if frame is None else frame, self._frame),
        ):
            coordinates, shape = line
            rows = _put(coordinates, np.column_stack([points, np.zeros(len(points))]))
            shape.numVertices.setValues(0, 1, [len(rows)])

    def show_strip(self, middle: FloatArray, width: FloatArray) -> None:
        """Show the strip with widths (n,), mm, along a curve (n, 2), mm."""
        self._strip.set(middle, width)

    def remove(self) -> None:
        """Remove everything from the view."""
        self._scene.removeChild(self.root)
        if self.handles is not None:
            self.handles.remove()

    def _line(self, color: tuple[float, float, float], width: float) -> tuple[Any, Any]:
        style, paint = coin.SoDrawStyle(), coin.SoBaseColor()
        style.lineWidth, paint.rgb = width, color
        coordinates, shape = coin.SoCoordinate3(), coin.SoLineSet()
        add_group(self.root, paint, style, coordinates, shape)
        return coordinates, shape


class _Ribbon:
    def __init__(self, root: Any) -> None:
        material, hints = coin.SoMaterial(), coin.SoShapeHints()
        material.diffuseColor, material.transparency = AFTER, GLASS
        # an explicit vertex order makes Coin light both sides
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        self._points, self._mesh = coin.SoCoordinate3(), coin.SoQuadMesh()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        add_group(root, pick, material, hints, self._points, self._mesh)

    def set(self, middle: FloatArray, width: FloatArray) -> None:
        rows = np.concatenate([np.column_stack([middle, side * width / 2]) for side in (-1.0, 1.0)])
        _put(self._points, rows)
        self._mesh.verticesPerRow, self._mesh.verticesPerColumn = len(middle), 2


# distance, pixels, within which the mouse grabs a handle
REACH_PX = 12
SIZE_PX = 13
REST, HELD = (0.1, 0.45, 0.95), (1.0, 0.8, 0.1)
# largest sine of the angle between the line of sight and a plane seen edge-on
EDGE_ON_SINE = 1e-6


class Handles:
    """Handles at points (n, 2) of a plane, mm.

    Dragging a handle calls `moved` with its index and new position; releasing a handle calls `released`. Mouse
    moves during a call of `moved` are ignored.
    """

    def __init__(
        self,
        view: Any,
        placement: Any,
        places: ArrayLike,
        moved: Callable[[int, Place], None],
        released: Callable[[], None] | None = None,
    ) -> None:
        self._view, self._placement, self._moved, self._let_go = view, placement, moved, released
        self._scene = view.getSceneGraph()
        self._held: int | None = None
        self._soon = later(self._notify)
        self.root = marks_in_plane("ElasticaHandles", placement)
        self._color, self._points, marks = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoMarkerSet()
        self._color.rgb = REST
        marks.markerIndex.setValue(Gui.getMarkerIndex("CIRCLE_FILLED", SIZE_PX))
        add_group(self.root, self._color, self._points, marks)
        self._scene.addChild(self.root)
        self._mouse = _Mouse(view, self._pressed, self._dragged, self._released)
        self.put(places)

    def put(self, places: ArrayLike) -> None:
        """Move the handles to other points (n, 2), mm."""
        self.places: FloatArray = np.array(places, dtype=float)
        _put(self._points, np.column_stack([self.places, np.zeros(len(self.places))]))

    @property
    def is_held(self) -> bool:
        """True while a handle is dragged."""
        return self._held is not None

    def on_screen(self) -> list[tuple[float, float]]:
        """Positions of the handles in pixels from the lower left corner of the view."""
        spots = []
        for x, y in self.places:
            px, py = self._view.getPointOnScreen(self._placement.multVec(App.Vector(x, y, 0)))
            spots.append((float(px), float(py)))
        return spots

    def remove(self) -> None:
        """Remove the handles from the view."""
        self._soon.stop()
        self._mouse.leave()
        self._scene.removeChild(self.root)

    def _pressed(self, pixel: FloatArray) -> bool:
        away = np.hypot(*(np.array(self.on_screen()).reshape(-1, 2) - pixel).T)
        self._held = int(np.argmin(away)) if away.size and away.min() <= REACH_PX else None
        self._color.rgb = REST if self._held is None else HELD
        return self._held is not None

    def _dragged(self, pixel: FloatArray) -> bool:
        if self._held is None:
            return False
        place = self._in_plane(pixel)
        if place is not None:
            moved = self.places.copy()
            moved[self._held] = place
            self.put(moved)
            if not self._soon.isActive():
                self._soon.start()
        return True

    def _released(self, _pixel: FloatArray) -> bool:
        if self._held is None:
            return False
        self._soon.stop()
        self._notify()
        self._held = None
        self._color.rgb = REST
        if self._let_go is not None:
            self._let_go()
        return True

    def _notify(self) -> None:
        if self._held is not None:
            x, y = self.places[self._held]
            self._moved(self._held, (float(x), float(y)))

    def _in_plane(self, pixel: FloatArray) -> FloatArray | None:
        back = self._placement.inverse()
        start, end = (
            np.array(tuple(back.multVec(p))) for p in self._view.projectPointToLine(*map(int, pixel))
        )
        direction = end - start
        if abs(direction[2]) <= EDGE_ON_SINE * np.linalg.norm(direction):
            return None
        return np.asarray((start - direction * (start[2] / direction[2]))[:2])


def _put(coordinates: Any, rows: FloatArray) -> FloatArray:
    coordinates.point.setNum(len(rows))
    coordinates.point.setValues(0, len(rows), rows.tolist())
    return rows


def plane_node(placement: Any) -> Any:
    """Return a node of Coin, FreeCAD's 3D library, that transforms (x, y) to points of a plane in space."""
    node = coin.SoMatrixTransform()
    rows = np.array(placement.toMatrix().A, dtype=float).reshape(4, 4).T
    node.matrix.setValue(*rows.ravel().tolist())
    return node


def marks_in_plane(name: str, placement: Any) -> Any:
    """Return a Coin group for unlit marks in a plane. The marks cover all objects and ignore the mouse."""
    light, pick, depth = coin.SoLightModel(), coin.SoPickStyle(), coin.SoDepthBuffer()
    light.model, pick.style = coin.SoLightModel.BASE_COLOR, coin.SoPickStyle.UNPICKABLE
    depth.test = False
    group = coin.SoSeparator()
    group.setName(name)
    for node in (light, pick, depth, plane_node(placement)):
        group.addChild(node)
    return group


def add_group(root: Any, *nodes: Any) -> None:
    """Add nodes to a root node, in a separate group."""
    group = coin.SoSeparator()
    for node in nodes:
        group.addChild(node)
    root.addChild(group)


class _Mouse(QtCore.QObject):
    """Event filter that takes the left mouse button before FreeCAD rotates the view or selects objects."""

    def __init__(self, view: Any, *answers: Callable[[FloatArray], bool]) -> None:
        super().__init__()
        surface = surface_of(view)
        self._view, self._widget = view, None if surface is None else surface.viewport()
        kinds = QtCore.QEvent
        self._answers = dict(
            zip((kinds.MouseButtonPress, kinds.MouseMove, kinds.MouseButtonRelease), answers, strict=True)
        )
        if self._widget is not None:
            self._widget.installEventFilter(self)

    def leave(self) -> None:
        with suppress(RuntimeError):
            if self._widget is not None:
                self._widget.removeEventFilter(self)
        # release the view, because PySide would reuse its wrapper for the next view
        self._widget = self._view = None

    def eventFilter(self, _widget: Any, event: Any) -> bool:
        answer = self._answers.get(kind_of(event))
        if answer is None:
            return False
        button = QtCore.Qt.LeftButton
        if event.button() != button and not event.buttons() & button:
            return False
        width, height = self._view.getSize()
        x, y = event.pos().x() / self._widget.width(), event.pos().y() / self._widget.height()
        return answer(np.array([x * width, (1 - y) * height]))
