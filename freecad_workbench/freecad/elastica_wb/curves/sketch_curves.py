# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The curve that a feature follows, read from a sketch or an object, with its plane."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import FreeCAD as App
import numpy as np
import Part
from freecad.elastica_wb.curves.part_shapes import is_bounded, plane_curve, report_on_edges, spline_geometry
from freecad.elastica_wb.host.objects import is_sketch
from freecad.elastica_wb.host.property_table import put
from freecad.elastica_wb.host.refusal import why_not_made

from elastica_cad._types import FloatArray
from elastica_cad.errors import FieldName, InputError, Length, note
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve

MOST_DRAGGED = 24
"""Largest number of poles that can be dragged. With more poles, the solver of FreeCAD 1.1 moves the curve."""

LINK = "App::Link"

EDGE_NUMBERS = 7


@dataclass(frozen=True, eq=False)
class DrawnCurve:
    """A drawn curve, with the placement of its plane.

    `placement` is relative to the container of the feature that follows the curve. `world` is relative to the
    document.
    """

    curve: PlaneCurve
    placement: App.Placement
    world: App.Placement

    @property
    def plane(self) -> Frame:
        """Plane of the curve in document coordinates."""
        return frame_of(self.world)


def drawn_curve(link: Any, follower: Any = None) -> DrawnCurve:
    """Return the curve of a link (object, names of edges), in the coordinates of the feature `follower`."""
    source, names = link if isinstance(link, tuple) else (link, ())
    if source is None:
        raise InputError("the curve is missing: choose a sketch or an edge in {box}", box=FieldName("Curve"))
    edges = [name for name in names if name]
    gap = gap_of(follower)
    if is_sketch(source):
        place = source.Placement
        plane = frame_of(place)
        curve = plane_curve(_edges(source, edges), plane, gap)[0] if edges else sketch_curve(source, gap=gap)
    else:
        curve, frame = plane_curve(_edges(source, edges), gap=gap)
        place = placement_of(frame)
    world = container(source) * place
    return DrawnCurve(curve, container(follower).inverse() * world, world)


def gap_of(*followers: Any) -> float:
    """Return the largest gap, mm, between edges that these features allow."""
    gaps = (obj.JoinGaps.Value for obj in followers if hasattr(obj, "JoinGaps"))
    return float(max(gaps, default=0.0))


def sketch_curve(sketch: Any, geometry: list[Any] | None = None, gap: float = 0.0) -> PlaneCurve:
    """Return the only curve of a sketch in sketch coordinates. Gaps of at most `gap` mm are closed.

    `geometry`, if given, replaces the geometry of the sketch.
    """
    curve, frame = plane_curve(drawn_in(sketch, geometry), gap=gap)
    if abs(frame.z_axis[2] - 1) > 1e-12:
        raise InputError("{sketch} is not plane: choose a plane sketch", sketch=sketch.Label)
    return curve


def read_line(link: Any, geometry: list[Any] | None = None) -> str:
    """Describe the curve of a link (object, names of edges), or the given `geometry`, in a line of text."""
    source, edges = link
    whole = is_sketch(source) and not edges
    curves = drawn_in(source, geometry) if whole else _edges(source, edges)
    return note("Read: {report}.", report=str(report_on_edges(curves, gap_of(*source.InList))))


def drawn_in(sketch: Any, geometry: list[Any] | None) -> list[Any]:
    """Return the curves of a sketch, or of `geometry`, without construction geometry."""
    everything = list(sketch.Geometry) if geometry is None else geometry
    curves = [
        g for i, g in enumerate(everything) if not isinstance(g, Part.Point) and not sketch.getConstruction(i)
    ]
    if not curves:
        raise InputError(
            "{sketch} {why}: draw a spline in this sketch", sketch=sketch.Label, why=note(_why_empty(sketch))
        )
    return curves


def is_blank(sketch: Any) -> bool:
    """Return True if a sketch contains no geometry that could be a curve."""
    return all(isinstance(sketch.Geometry[i], Part.Point) for i in _drawn_numbers(sketch))


def _drawn_numbers(sketch: Any) -> list[int]:
    """Return the indices of the geometry that is not construction geometry."""
    return [i for i in range(len(sketch.Geometry)) if not sketch.getConstruction(i)]


def linked(obj: Any) -> Any:
    """Return the object that a link or an element of a link array displays, or the object itself."""
    target = link_target(obj)
    return obj if target is None else linked(target)


def link_target(obj: Any) -> Any:
    """Return the target of a link, or None for a broken link and for objects that are not links."""
    target = getattr(obj, "LinkedObject", None) if obj.TypeId.startswith(LINK) else None
    return obj.getLinkedObject(False) if isinstance(target, tuple) else target


def picked(root: Any, path: str) -> tuple[Any, str]:
    """Return the picked object at a path (`Part.Body.Pad.Edge3`), and the name of the picked element.

    If a link displays the element, the link is returned, because the original has another position.
    """
    along = root.getSubObjectList(path)
    # skip names such as ;#14:1; that change with every edit
    names = [name for name in path.split(".") if not name.startswith(";")]
    for i, obj in enumerate(along):
        if obj.TypeId.startswith(LINK):
            return obj, ".".join(names[i:])
    return along[-1], names[-1]


def is_edge(name: str) -> bool:
    """Return True for the name or path of an edge: `Edge1`, or `edge1` as in open sketches of FreeCAD 1.1."""
    return name.rpartition(".")[2].lower().startswith("edge")


def edge_called(source: Any, name: str) -> Any:
    """Return the element of an object's shape with the given name or path."""
    try:
        path = "." in name
        element = (
            Part.getShape(source, name, needSubElement=True)
            if path
            else Part.getShape(source).getElement(name)
        )
        if element.isNull():
            raise IndexError(name)
    except (ValueError, IndexError, Part.OCCError) as error:
        # FreeCAD 1.x marks lost elements by "?"
        called = name.lstrip("?")
        raise InputError(
            "{source} no longer has {part}. Choose the curve again.", source=source.Label, part=called
        ) from error
    return element


def renumbered(obj: Any) -> list[str]:
    """Return a remark if other edges got the names of the chosen edges, as FreeCAD 0.20 numbers edges.

    The chosen edges still exist then. Otherwise the edges have changed, and their new form is stored.
    """
    source, names = obj.Curve
    now = _numbers_of(edge_called(source, name) for name in names if name and "." not in name)
    chosen = np.reshape(obj.ChosenEdges, (-1, EDGE_NUMBERS)).tolist()
    every = _numbers_of(Part.getShape(source).Edges)
    if chosen and sorted(now) != sorted(chosen) and all(numbers in every for numbers in chosen):
        before, after = (Length(sum(length for length, *_ in edges)) for edges in (chosen, now))
        return [note(
            "The curve is another edge than before: {before:.4g} -> {now:.4g}. Choose the curve again.",
            before=before, now=after,
        )]  # fmt: skip
    put(obj, ChosenEdges=[number for numbers in now for number in numbers])
    return []


def _numbers_of(edges: Iterable[Any]) -> list[list[float]]:
    """Return `EDGE_NUMBERS` numbers for each edge: its length and the coordinates of its ends, mm."""
    ends = [(edge, *map(edge.valueAt, edge.ParameterRange)) for edge in edges]
    return [[round(x, 6) for x in (edge.Length, *first, *last)] for edge, first, last in ends]


def frame_of(placement: App.Placement) -> Frame:
    """Return the plane z = 0 of a placement."""
    x, y = (placement.Rotation.multVec(App.Vector(*axis)) for axis in ((1, 0, 0), (0, 1, 0)))
    return Frame(tuple(placement.Base), tuple(x), tuple(y))


def placement_of(frame: Frame) -> App.Placement:
    """Return the placement whose plane z = 0 is the plane of a frame."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.axes.T, frame.origin
    return App.Placement(App.Matrix(*matrix.ravel().tolist()))


def _why_empty(sketch: Any) -> str:
    if sketch.Geometry:
        return "has construction geometry and points only"
    return "has external geometry only" if sketch.ExternalGeometry else "is empty"


def _edges(source: Any, names: list[str]) -> list[Part.Edge]:
    lost = why_not_made(source)
    if lost:
        raise InputError(lost)
    shape = Part.getShape(source)
    if shape.isNull():
        raise InputError("{source} has no shape. Choose a sketch, an edge or a wire.", source=source.Label)
    if names:
        return [edge for name in names for edge in edge_called(source, name).Edges]
    if shape.Faces and not is_outline(shape):
        raise InputError("{source} has many edges. Choose the edges for the strip.", source=source.Label)
    return list(shape.Edges)


def is_outline(shape: Any) -> bool:
    """Return True for a single plane face without holes, such as Draft makes from a closed curve."""
    faces = shape.Faces
    # the surface may be a spline, because FreeCAD's SVG reader scales faces
    return len(faces) == 1 and len(shape.Wires) == 1 and faces[0].findPlane() is not None


def container(obj: Any) -> App.Placement:
    """Return the placement, in the document, of the container of an object.

    FreeCAD has no method that returns this placement for links.
    """
    group = None if obj is None else obj.getParentGeoFeatureGroup()
    return App.Placement() if group is None else group.getGlobalPlacement()


def boxes_of(objects: Iterable[Any]) -> list[App.BoundBox]:
    """Return the bounding boxes, in document coordinates, of the objects whose shapes are bounded."""
    shaped = [obj for obj in objects if hasattr(obj, "Shape") and is_bounded(obj.Shape.BoundBox)]
    return [obj.Shape.BoundBox.transformed(container(obj).toMatrix()) for obj in shaped]


def curve_into(sketch: Any, curve: PlaneCurve) -> None:
    """Replace the curves of a sketch by a spline, with visible poles if they can be dragged.

    Construction geometry stays.
    """
    # delete in a single call, because each deletion renumbers the geometry
    sketch.delGeometries(_drawn_numbers(sketch))
    points = ("Part::GeomCircle", "Part::GeomPoint")
    remaining = [
        i for i, g in enumerate(sketch.Geometry) if g.TypeId in points and not _has_user_constraint(sketch, i)
    ]
    sketch.delGeometries(remaining)
    number = sketch.addGeometry(spline_geometry(curve), False)
    if len(curve.control_points) <= MOST_DRAGGED:
        sketch.exposeInternalGeometry(number)


def move_poles(sketch: Any, curve: PlaneCurve) -> None:
    """Move the poles of a sketch's only spline, and the circles that show them, to the poles of a curve."""
    geometry = sketch.Geometry
    (number,) = (
        i
        for i, g in enumerate(geometry)
        if isinstance(g, Part.BSplineCurve) and not sketch.getConstruction(i)
    )
    aligned = (c.First for c in sketch.Constraints if c.Type == "InternalAlignment" and c.Second == number)
    circles = [geometry[i] for i in aligned if isinstance(geometry[i], Part.Circle)]
    for k, (x, y) in enumerate(curve.control_points.tolist(), start=1):
        before, pole = geometry[number].getPole(k), App.Vector(x, y, 0)
        if circles:  # use the nearest circle, because FreeCAD 0.20 does not number circles
            circles.sort(key=lambda circle, place=before: circle.Center.distanceToPoint(place), reverse=True)
            circles.pop().Center = pole
        geometry[number].setPole(k, pole)
    sketch.Geometry = geometry


def replace_curve(sketch: Any, number: int | None, curve: PlaneCurve) -> int:
    """Replace the curve with index `number` by a spline, or add the spline if `number` is None. Return its index.

    A spline with hidden poles keeps its constraints. Visible poles are deleted with the replaced curve.
    """
    spline = spline_geometry(curve)
    poles = [c.First for c in sketch.Constraints if c.Type == "InternalAlignment" and c.Second == number]
    if poles:
        sketch.delGeometries([number, *poles])
        number = None
    if number is None:
        return int(sketch.addGeometry(spline, False))
    geometry = sketch.Geometry
    geometry[number] = spline
    sketch.Geometry = geometry
    return number


def _has_user_constraint(sketch: Any, number: int) -> bool:
    return any(
        number in (c.First, c.Second, c.Third) and c.Type not in ("Weight", "Equal")
        for c in sketch.Constraints
    )


# short side of the box around a nearly straight curve, as a fraction of its long side
LEAST_SIDE = 0.2
# constraints that FreeCAD adds itself
AUTOMATIC = ("InternalAlignment", "Weight", "Equal")


def box_around(curve: PlaneCurve) -> FloatArray:
    """Return the corners (4, 2) of the box around a curve, anticlockwise from the lower left.

    The box of a nearly straight curve is enlarged, so that its handles do not overlap.
    """
    low, high = np.array(curve.bounds)
    least = LEAST_SIDE * float(np.max(high - low))
    grow = np.maximum(0.0, least - (high - low)) / 2
    (left, bottom), (right, top) = low - grow, high + grow
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])


def evened(curve: PlaneCurve) -> PlaneCurve:
    """Return the same curve with weights near 1, which the sketcher draws as the radii of circles."""
    if curve.weights is None:
        return curve
    weights = curve.weights / np.exp(np.log(curve.weights).mean())
    return PlaneCurve(curve.knots, curve.control_points, curve.degree, weights)


def lost_constraints(sketch: Any) -> int:
    """Return the number of the user's constraints that would be deleted with the drawn geometry."""
    numbers = {*_drawn_numbers(sketch)}
    return sum(
        bool(numbers & {c.First, c.Second, c.Third}) for c in sketch.Constraints if c.Type not in AUTOMATIC
    )
