"""Plane sections of CAD solids and NURBS surfaces, computed by OpenCASCADE."""

from collections.abc import Sequence
from itertools import product

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.form_finding.plane_sections import refuse_odd_planes
from elastica_cad.form_finding.section_lines import PlaneSection, collect_section, tidy_points
from elastica_cad.form_finding.section_spec import Surface
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.placed_curve import JOIN, edge_chains
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_points import lengths_along
from elastica_cad.kernel.drawn_edges import drawn_edges
from elastica_cad.kernel.occt import coordinates, plane_axes_of, sub_shapes
from elastica_cad.kernel.ocp_import import Shape, bare, kernel

POINTS = 120
"""Number of points on each span of an edge of a section, or fewer for an edge with more than four spans."""

MOST = 1000
"""Number of points above which a line is thinned. Half as many evenly spaced points remain, and the points that
`BETWEEN` requires."""

BETWEEN = 1e-3
"""Largest distance, mm, of omitted points from the chords between remaining points."""


def shape_sections(shape: Shape, planes: Sequence[Frame], *, half: bool = False) -> tuple[PlaneSection, ...]:
    """Return the sections of an OpenCASCADE body or surface by planes.

    Parameters
    ----------
    shape : TopoDS_Shape or wrapped shape
        Solid, shell or face, such as a build123d object, or `.val()` of a CadQuery workplane.
    planes : sequence of Frame
    half : bool
        If True, only the part with x >= 0 in each frame is returned, for half planes about an axis.

    Returns
    -------
    tuple of PlaneSection
        A section for each plane, in order. Points are on the surface. A line with more than 1000 points is thinned:
        omitted points are within 0.001 mm of the chords between the remaining points. The section has no lines if
        the plane misses the shape.
    """
    k, shape = kernel(), bare(shape)
    if not isinstance(shape, k.TopoDS_Shape) or shape.IsNull():
        raise InputError("There is no shape to cut. Pass a solid, a shell or a face.")
    refuse_odd_planes(planes)

    def section(number: int, frame: Frame) -> PlaneSection:
        cut = k.BRepAlgoAPI_Section(shape, k.gp_Pln(plane_axes_of(frame)), False)
        # request splines, because a freeform face would otherwise give a polyline of 10,000 points
        cut.Approximation(True)
        cut.Build()
        lines = [_points(run, frame) for run in edge_chains(drawn_edges(cut.Shape()))]
        return collect_section(f"section {number}", frame, lines, half=half, apart=JOIN)

    return tuple(section(number, frame) for number, frame in enumerate(planes, 1))


def shape_surface(shape: Shape, scale: float = 1.0) -> Surface:
    """Convert a body or surface of OpenCASCADE to a `Surface`, which can be cut by planes.

    Lengths are multiplied by `scale`.
    """
    k = kernel()
    if not isinstance(shape, k.TopoDS_Shape):
        raise InputError(f"A {type(shape).__name__} cannot be cut. Pass a face, shell or solid.")
    if scale != 1.0:
        larger = k.gp_Trsf()
        larger.SetScaleFactor(scale)
        shape = k.BRepBuilderAPI_Transform(shape, larger, True).Shape()
    if not sub_shapes(shape, "face"):
        raise InputError("The shape has no faces to cut. Export a solid, a shell or a face.")
    box = k.Bnd_Box()
    k.BRepBndLib.AddOptimal_s(shape, box, False, False)
    low, high = coordinates(box.CornerMin()), coordinates(box.CornerMax())
    corners = np.array(list(product(*zip(low, high, strict=True))))
    return Surface(corners, lambda planes, half: shape_sections(shape, planes, half=half))


def _points(run: Sequence[Edge], frame: Frame) -> FloatArray:
    """Return the points (n, 2) of a chain of edges in the plane, in the order that `SectionLine` requires."""
    parts = [frame.local(_places(edge))[:, :2] for edge in run]
    points = np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
    if np.linalg.norm(points[-1] - points[0]) <= JOIN:
        points[-1] = points[0]
    return tidy_points(_thinned(points), JOIN)


def _places(edge: Edge) -> FloatArray:
    """Return points along an edge, enough to approximate it by a line."""
    count = len(edge.spans.edges) - 1
    if edge.degree == 1 and count > 4 * POINTS:
        return edge.points
    stations = edge.stations(max(edge.degree + 2, min(POINTS, 4 * POINTS // count)))
    # evaluate in blocks, because the matrix of basis functions is dense
    rows = max(1, MOST * MOST // len(edge.points))
    return np.concatenate([edge.at(stations[i : i + rows]) for i in range(0, len(stations), rows)])


def _thinned(points: FloatArray) -> FloatArray:
    """Return evenly spaced points of a line, and further points where the chords would deviate from it."""
    if len(points) <= MOST:
        return points
    s = lengths_along(points)
    samples = np.unique(np.searchsorted(s, np.linspace(0.0, s[-1], MOST // 2)).clip(0, len(s) - 1))
    samples[0] = 0
    todo = list(zip(samples[:-1].tolist(), samples[1:].tolist(), strict=True))
    indices = set(samples.tolist())
    # between the points a and b, keep the point farthest from the chord until all are near enough
    while todo:
        a, b = todo.pop()
        if b - a < 2:
            continue
        along, off = points[b] - points[a], points[a + 1 : b] - points[a]
        share = np.clip(off @ along / max(along @ along, np.finfo(float).tiny), 0.0, 1.0)
        gaps = np.linalg.norm(off - share[:, None] * along, axis=1)
        worst = int(gaps.argmax())
        if gaps[worst] > BETWEEN:
            middle = a + 1 + worst
            indices.add(middle)
            todo += [(a, middle), (middle, b)]
    return points[sorted(indices)]
