"""The drawing: paths and engraved texts on named layers, whatever file it ends up in."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._notebook import BLUE, GREY, INK, RED, svg_of_lines
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, require_record, several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.lettering import Text, text_strokes
from elastica_cad.geometry.boxes import box_around
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.plane_matrices import is_similarity, similarity_of, transform_points
from elastica_cad.mechanics.material.sheet_library import require_printable

CUT_OUTER = "CUT_OUTER"
CUT_INNER = "CUT_INNER"
ENGRAVE = "ENGRAVE"
MARK = "MARK"
SHEET = "SHEET"

LAYERS = (SHEET, ENGRAVE, MARK, CUT_INNER, CUT_OUTER)
"""All layers in the order in which a machine should work: a part comes loose last. The border of the sheet is for
people, and no machine follows it."""

SAME_MM = 1e-6
"""Paths nearer to each other than this everywhere are one: files keep six digits behind the point."""

CHORD_SHARE = 1e-4  # of the diagonal: how closely a notebook's picture follows splines
LAYER_INK = {CUT_OUTER: RED, CUT_INNER: BLUE, ENGRAVE: INK, MARK: GREY, SHEET: GREY}


@dataclass(frozen=True, eq=False)
class LayeredPath:
    """A path on a layer, one of `LAYERS`."""

    layer: str
    path: Path

    def __post_init__(self) -> None:
        _check_layer(self.layer)
        require_record(self.path, Path, "the path on a layer", "a Path")


@dataclass(frozen=True, eq=False)
class Drawing:
    """A flat drawing, mm.

    Parameters
    ----------
    name : str
        What it shows; titles and file names come from it.
    paths : sequence of LayeredPath
    texts : sequence of Text

    Examples
    --------
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> plate.bounds.tolist()
    [[0.0, 0.0], [40.0, 10.0]]
    """

    name: str
    paths: tuple[LayeredPath, ...] = ()
    texts: tuple[Text, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "paths", several("paths", self.paths, LayeredPath, "LayeredPath"))
        object.__setattr__(self, "texts", several("texts", self.texts, Text, "Text"))
        require_printable(self.name, "the drawing's name")
        for text in self.texts:
            _check_layer(text.layer)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name!r}, {len(self.paths)} paths, {len(self.texts)} texts>"

    def _repr_svg_(self) -> str:
        low, high = self.bounds
        chord = float(np.hypot(*(high - low))) * CHORD_SHARE
        lines = [(one.path.points(chord), LAYER_INK[one.layer], one.path.closed) for one in self.strokes]
        return svg_of_lines(lines, repr(self))

    @cached_property
    def strokes(self) -> tuple[LayeredPath, ...]:
        """Everything as paths in working order: texts as strokes, inner cuts before outer, nothing twice."""
        written = [LayeredPath(text.layer, stroke) for text in self.texts for stroke in text_strokes(text)]
        everything = [*written, *self.paths]
        return _without_twins([item for layer in LAYERS for item in everything if item.layer == layer])

    @property
    def layers(self) -> tuple[str, ...]:
        """The layers that files of it have: all but the sheet's, and that where it is drawn."""
        return LAYERS if self.on(SHEET) else tuple(layer for layer in LAYERS if layer != SHEET)

    @cached_property
    def bounds(self) -> FloatArray:
        """[[x_min, y_min], [x_max, y_max]], mm.

        Raises
        ------
        InputError
            The drawing is empty.
        """
        if not self.strokes:
            raise InputError("the drawing {name!r} is empty: it has neither paths nor texts", name=self.name)
        return box_around(np.array([item.path.bounds for item in self.strokes]))

    def on(self, *layers: str) -> tuple[Path, ...]:
        """The paths (without texts) on the named layers."""
        for layer in layers:
            _check_layer(layer)
        return tuple(item.path for item in self.paths if item.layer in layers)

    def only(self, *layers: str) -> "Drawing":
        """The drawing without paths and texts of other layers."""
        texts = tuple(text for text in self.texts if text.layer in layers)
        return Drawing(self.name, tuple(item for item in self.paths if item.layer in layers), texts)

    def transformed(self, matrix: ArrayLike) -> "Drawing":
        """The drawing moved by a 3x3 affine matrix; texts that would be mirrored or skewed become paths."""
        m = numbers(matrix, "the matrix that a drawing is moved by")
        even = is_similarity(m)
        paths = [LayeredPath(item.layer, item.path.transformed(m)) for item in self.paths]
        if even and np.linalg.det(m[:2, :2]) > 0:
            scale, turn, _ = similarity_of(m)
            texts = []
            for text in self.texts:
                x, y = transform_points(m, text.position)
                texts.append(
                    Text((float(x), float(y)), text.text, text.height * scale, text.angle + turn, text.layer)
                )
            return Drawing(self.name, tuple(paths), tuple(texts))
        for text in self.texts:
            paths.extend(LayeredPath(text.layer, stroke.transformed(m)) for stroke in text_strokes(text))
        return Drawing(self.name, tuple(paths))

    @classmethod
    def merged(cls, name: str, drawings: Iterable["Drawing"]) -> "Drawing":
        """All drawings in one."""
        parts = several("drawings", drawings, Drawing, "Drawing")
        return cls(name, tuple(p for d in parts for p in d.paths), tuple(t for d in parts for t in d.texts))


def _check_layer(layer: str) -> None:
    if not isinstance(layer, str) or layer not in LAYERS:
        raise InputError(
            "there is no layer {layer!r}: use one of {layers}", layer=layer, layers=", ".join(LAYERS)
        )


def _without_twins(items: list[LayeredPath]) -> tuple[LayeredPath, ...]:
    """The paths in order, without those that run where an earlier one of their layer, or a cut, runs."""
    if not items:
        return ()
    from scipy.spatial import cKDTree

    boxes = np.array([item.path.bounds for item in items]).reshape(-1, 4)
    alike = cKDTree(boxes).query_pairs(SAME_MM, p=np.inf, output_type="ndarray")
    dropped: set[int] = set()
    for i, j in sorted(alike.tolist()):
        if not {i, j} & dropped and _twins(items[i], items[j]):
            dropped.add(j)
    return tuple(item for i, item in enumerate(items) if i not in dropped)


def _twins(a: LayeredPath, b: LayeredPath) -> bool:
    cut = (CUT_INNER, CUT_OUTER)
    if a.layer != b.layer and not (a.layer in cut and b.layer in cut):
        return False
    if abs(a.path.length - b.path.length) > 10 * SAME_MM:
        return False
    samples = np.concatenate([s.at(np.array([0.0, 0.3, 0.7, 1.0])) for s in b.path.segments])
    near = np.min([distances(segment, samples) for segment in a.path.segments], axis=0)
    return bool(near.max() <= SAME_MM)
