"""From B-splines with any knots to Bezier pieces, and the basis functions themselves."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from elastica_cad._types import FloatArray, IntArray

_KEPT = 32  # knot vectors whose spans are kept: those of a curve, its stiffness, its widths and their copies
_SHORT, _KEPT_SHORT = (
    24,
    16384,
)  # knots of sides of holes, thousands in a model, each drawn in several files: 20 MB


@dataclass(frozen=True, eq=False)
class Spans:
    """The non-empty knot spans of a B-spline basis inside its domain.

    Attributes
    ----------
    count : int
        Number m of control points.
    edges : (p + 1,) array
        Ends of the spans in the parameter t, increasing.
    first : (p,) int array
        Index of the first of the degree + 1 control points that act on each span.
    matrix : (p, degree + 1, degree + 1) array
        Bezier control points of a span = matrix @ its B-spline control points.
    """

    count: int
    edges: FloatArray
    first: IntArray
    matrix: FloatArray

    @property
    def degree(self) -> int:
        """Polynomial degree of the basis."""
        return int(self.matrix.shape[-1]) - 1

    @cached_property
    def widths(self) -> FloatArray:
        """Lengths (p,) of the spans in the parameter."""
        return np.asarray(self.edges[1:] - self.edges[:-1])

    def bezier(self, control_points: FloatArray) -> FloatArray:
        """Bezier control points (p, degree + 1, ...) of the spline with `control_points` (m, ...)."""
        return bezier_pieces(control_points, self.first, self.matrix)

    def locate(self, t: FloatArray, *, left: bool = False) -> tuple[IntArray, FloatArray]:
        """Span index and local coordinate u in [0, 1] of parameters (n,); at an edge the right span."""
        index = np.searchsorted(self.edges[1:-1], t, side="left" if left else "right")
        u = (t - self.edges[index]) / self.widths[index]
        return index, np.minimum(np.maximum(u, 0.0), 1.0)

    def basis(self, t: FloatArray, derivative: int = 0) -> FloatArray:
        """Values (n, m) of the d-th derivative of all m basis functions at parameters (n,)."""
        local, index = self.local_basis(t, derivative)
        out = np.zeros((t.size, self.count))
        columns = self.first[index][:, None] + np.arange(self.degree + 1)
        out[np.arange(t.size)[:, None], columns] = local
        return out

    def local_basis(self, t: FloatArray, derivative: int = 0) -> tuple[FloatArray, IntArray]:
        """The degree + 1 basis functions that do not vanish (n, degree + 1), and the span index (n,)."""
        index, u = self.locate(t)
        width = self.widths[index]
        bernstein = _bernstein_values(self.degree, u, derivative) / width[:, None] ** derivative
        return np.asarray(np.einsum("ni,nij->nj", bernstein, self.matrix[index])), index


def bezier_spans(knots: FloatArray, degree: int) -> Spans:
    """Bezier extraction of a B-spline basis with a full knot vector (m + degree + 1,), clamped or not.

    Bezier point j of the span [a, b] is the blossom at a (degree - j times) and b (j times).
    """
    written = np.asarray(knots, dtype=float).tobytes()
    return _short_spans(written, degree) if knots.size <= _SHORT else _long_spans(written, degree)


def _spans(written: bytes, degree: int) -> Spans:
    """The spans of knots as bytes; they are shared, so read-only."""
    knots = np.frombuffer(written)
    if knots.size == 2 * degree + 2 and knots[0] == knots[degree] < knots[degree + 1] == knots[-1]:
        return _one_span(knots[[0, -1]], degree)
    span = (knots[degree + 1 : -degree] > knots[degree : -degree - 1]).nonzero()[0] + degree
    near = knots[span + np.arange(1 - degree, degree + 1)[:, None]]
    first, matrix = span - degree, extraction(near)
    edges = np.concatenate([near[degree - 1], near[degree, -1:]])
    for shared in (edges, first, matrix):
        shared.setflags(write=False)
    return Spans(knots.size - degree - 1, edges, first, matrix)


def bezier_pieces(control_points: FloatArray, first: IntArray, matrix: FloatArray) -> FloatArray:
    """Bezier points (p, degree + 1, ...) of spans on which points (m, ...) act from the `first` (p,) on."""
    local = control_points[first[:, None] + np.arange(matrix.shape[-1])]
    pieces = matrix @ local.reshape(*local.shape[:2], -1)
    return np.asarray(pieces.reshape(local.shape), dtype=float)


def extraction(near: FloatArray) -> FloatArray:
    """Of spans with 2 * degree knots about each, rows of (2 degree, p): see `Spans.matrix`, (p, ...)."""
    degree = len(near) // 2
    size = degree + 1
    # spans run along the last axis: numpy is slow where that is short
    ends = near[degree - 1 : degree + 1]
    points = np.broadcast_to(np.eye(size)[:, None, :, None], (size, 1, size, 1))
    for level in range(1, size):
        low, high = near[level - 1 : degree], near[degree : degree + size - level]
        # argument `level` of the blossom is a of the first Bezier points, b of the others
        shares = ((ends[:, None] - low) / (high - low))[(np.arange(size) >= level).astype(int)]
        shares = shares.swapaxes(0, 1)[:, :, None]
        points = points[:-1] * (1 - shares) + points[1:] * shares
    return np.ascontiguousarray(points[0].transpose(2, 0, 1))


_long_spans, _short_spans = lru_cache(maxsize=_KEPT)(_spans), lru_cache(maxsize=_KEPT_SHORT)(_spans)


def _one_span(edges: FloatArray, degree: int) -> Spans:
    """Of knots that stand at two places only: control points are Bezier points."""
    first, matrix = np.zeros(1, dtype=int), np.eye(degree + 1)[None]
    for shared in (edges, first, matrix):
        shared.setflags(write=False)
    return Spans(degree + 1, edges, first, matrix)


def _bernstein_values(degree: int, u: FloatArray, derivative: int) -> FloatArray:
    """Derivatives (n, degree + 1) of the Bernstein polynomials at local coordinates (n,)."""
    if derivative > degree:
        return np.zeros((u.size, degree + 1))
    values = np.ones((1, u.size))
    for _ in range(degree - derivative):
        raised = np.empty((len(values) + 1, u.size))
        raised[0], raised[-1] = values[0] * (1 - u), values[-1] * u
        raised[1:-1] = values[1:] + (values[:-1] - values[1:]) * u
        values = raised
    for k in range(degree - derivative + 1, degree + 1):
        values = k * np.diff(values, axis=0, prepend=0.0, append=0.0) * -1.0
    return np.ascontiguousarray(values.T)
