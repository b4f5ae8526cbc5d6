"""Plane curves from edges in space: find the plane of the edges, and the curve in this plane."""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from math import dist

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import Angle, Change, InputError, Length, Point, note, rounded_up
from elastica_cad.formats.chains import curve_from_run, holes_on_chains, join_runs
from elastica_cad.formats.edges import Edge, Run, sample_run
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve

# largest deviation of a drawing from its plane: in mm, and as a fraction of the size of the drawing
NOISE_MM, NOISE_SHARE = 0.05, 1e-3
# least z component of the unit normal of a plane that counts as horizontal
HORIZONTAL = np.cos(np.radians(1.0))


def flatten_run(run: Sequence[Edge], tolerance: float) -> Run:
    """Map a run of edges from space to the coordinates of its `drawing_plane`."""
    return in_plane(run, drawing_plane(run, tolerance))


def in_plane(run: Sequence[Edge], frame: Frame) -> Run:
    """Map a run of edges from space to the coordinates of a plane."""
    axes = frame.axes[:2]
    return tuple(edge.mapped(axes, -axes @ frame.origin) for edge in run)


def drawing_plane(run: Sequence[Edge], tolerance: float = 0.0) -> Frame:
    """Return the plane of a run of edges in space.

    Its origin is the point of the plane nearest to the origin of space. The edges may leave the plane by
    `tolerance` mm, or by the noise of a drawing (`NOISE_MM`, `NOISE_SHARE`) if this is more.

    In a plane within a degree of horizontal, x and y are the axes of the drawing. In all other planes, x is along
    the horizontal line of the plane, towards positive x (or y). The y axis is along the steepest line, upwards.
    """
    points = sample_run(run)
    noise = min(NOISE_MM, NOISE_SHARE * float(np.ptp(points, axis=0).max()))
    x_axis, y_axis = _plane_axes(points, max(tolerance, noise))
    normal = np.cross(x_axis, y_axis)
    return Frame((points[0] @ normal) * normal, x_axis, y_axis)


def _plane_axes(points: FloatArray, tolerance: float) -> FloatArray:
    """Return the axes (2, 3) of the plane of points (n, 3): x to the right and, in a steep plane, y upwards.

    Collinear points are in a vertical plane.
    """
    if np.ptp(points[:, 2]) <= tolerance:
        return np.eye(2, 3)
    centred = points - points.mean(axis=0)
    _, sizes, directions = np.linalg.svd(centred, full_matrices=False)
    normal = directions[-1]
    if len(sizes) < 3 or sizes[1] <= 1e-9 * sizes[0]:  # draw collinear points in the vertical plane
        normal = np.cross(directions[0], (0.0, 0.0, 1.0))
        if np.linalg.norm(normal) < 1e-9:
            normal = np.array([0.0, 1.0, 0.0])
    normal = normal / np.linalg.norm(normal)
    off = float(np.abs(centred @ normal).max())
    if off > tolerance:
        raise InputError(
            "a curve leaves its plane by {off} (z varies by {ptp:.4g}), but a strip bends in one plane only: "
            "project the curve onto a plane first",
            off=Length(off),
            ptp=Length(np.ptp(points[:, 2])),
        )
    if abs(normal[2]) > HORIZONTAL:
        x_axis = np.array([1.0, 0.0, 0.0]) - normal[0] * normal
        x_axis = x_axis / np.linalg.norm(x_axis)
        return np.array([x_axis, np.cross(np.sign(normal[2]) * normal, x_axis)])
    up = np.array([0.0, 0.0, 1.0])
    y_axis = up - (up @ normal) * normal
    y_axis = y_axis / np.linalg.norm(y_axis)
    x_axis = np.cross(y_axis, normal)
    x_axis = x_axis * np.sign(x_axis[np.abs(x_axis).argmax()])
    return np.array([x_axis, y_axis])


# largest gap, mm, between ends of edges that meet
JOIN = 1e-4
# largest turn, rad, at a joint that counts as smooth
TANGENT = 1e-3
# least total turn, rad, of a curve that determines the side of its plane
LEAST_TURN = 1e-6
# largest gap, mm, for which a larger tolerance is suggested
JOINED_MM = 0.5
AS_DRAWN = np.eye(3)


def placed_curve(
    edges: Sequence[Edge],
    *,
    plane: Frame | None = None,
    turned: ArrayLike | None = None,
    join: float = JOIN,
) -> tuple[PlaneCurve, Frame]:
    """Join edges in space end to end, and return the curve and its plane.

    The curve has the direction of the first edge; a closed curve starts there. If the plane is horizontal,
    the axes of the frame are parallel to the axes of space. In any other plane, the y axis of the frame
    points towards z as far as possible. Its z axis points to the side from which the total turn of the curve
    is anticlockwise. If edges are rotated, the frame rotates with them.

    Parameters
    ----------
    edges : sequence of Edge
        In any order.
    plane : Frame, optional
        The plane in which the edges are drawn, if it is known.
    turned : (3, 3) array, optional
        Rotation of the edges since they were drawn. The side of the frame is determined before this rotation.
    join : float
        Largest gap between ends of edges that is closed, mm. Edges are moved as a whole, so tangents do not turn.
    """
    if not edges:
        raise InputError("there is no edge: select at least one edge or wire for the strip to follow")
    runs = edge_chains(edges, join)
    if not runs:
        raise InputError("the edge has no length: draw a curve for the strip to follow")
    runs, holes = holes_on_chains(runs)
    if len(runs) > 1:
        raise InputError(_several_chains_message(runs))
    turn = AS_DRAWN if turned is None else np.asarray(turned, dtype=float)
    frame_of = partial(_side_of, turned=turn) if plane is None else partial(_require_in_plane, plane=plane)
    return place_chain(runs[0], frame_of, holes[0], join)


def edge_chains(edges: Sequence[Edge], join: float = JOIN) -> list[Run]:
    """Join edges across gaps of at most `join` mm to chains, for `place_chain`."""
    return join_runs([(edge,) for edge in edges], join).chains


def place_chain(
    run: Run, frame_of: Callable[[Run], Frame], holes: Sequence[Run] = (), join: float = JOIN
) -> tuple[PlaneCurve, Frame]:
    """Return the curve of a chain of edges and its frame. A chain with corners is refused."""
    # the last edge of a closed chain is followed by the first
    closed = dist(run[0].start.tolist(), run[-1].end.tolist()) <= join
    for before, after in pairwise((*run, *run[:1]) if closed else run):
        out, onward = before.points[-1] - before.points[-2], after.points[1] - after.points[0]
        turn = np.arctan2(np.linalg.norm(np.cross(out, onward)), out @ onward)
        if turn > TANGENT:
            if len(run) > 2 and all(edge.degree == 1 for edge in run):
                raise InputError(
                    "the edges are a polyline of {count} straight pieces, with corners between them: "
                    "draw a spline through its points for the strip to follow",
                    count=len(run),
                )
            raise InputError(
                "edges meet at a corner of {turn:.3g} at {place}: make them tangent or round the corner",
                turn=Angle(turn),
                place=Point(before.end),
            )
    frame = frame_of(run)
    flat, *drilled = [in_plane(part, frame) for part in (run, *holes)]
    return curve_from_run(flat, tolerance=join, holes=drilled), frame


def _several_chains_message(runs: Sequence[Run]) -> str:
    """Return the message for edges that do not form a single chain, with the place of the nearest ends."""
    ends = np.array([(run[0].start, run[-1].end) for run in runs])
    # axes of the array: run, end of the run, other run, end of the other run
    between = np.linalg.norm(ends[:, :, None, None] - ends, axis=-1)
    between[np.arange(len(runs)), :, np.arange(len(runs))] = np.inf
    run, side = np.unravel_index(between.argmin(), between.shape)[:2]
    gap, place = between.min(), Point(ends[run, side])
    if gap <= JOIN:
        return note(
            "three or more edges meet at {place}, but a strip follows a single path: give only the edges "
            "that the strip must follow",
            place=place,
        )
    points = np.concatenate([edge.points for part in runs for edge in part])
    # ends closer than 5 % of the extent are probably intended to meet
    if gap <= 0.05 * np.ptp(points, axis=0).max():
        return note(
            "two edges end {gap} apart at {place}: join their ends there (in a sketch, by a coincident "
            "constraint)",
            gap=Length(gap),
            place=place,
            changes=[Change("join", rounded_up(1.01 * gap, 2))] if gap <= JOINED_MM else [],
        )
    return note(
        "the edges form {count} separate chains, the nearest {gap} apart at {place}: join their ends, or "
        "leave out edges that the strip does not follow (in a sketch, make them construction geometry)",
        count=len(runs), gap=Length(gap), place=place,
    )  # fmt: skip


def _require_in_plane(run: Sequence[Edge], plane: Frame) -> Frame:
    points = sample_run(run)
    off = (points - plane.origin) @ plane.z_axis
    if np.abs(off).max() > max(JOIN, 1e-6 * float(np.ptp(points, axis=0).max())):
        raise InputError(
            "the curve is up to {most} away from the plane that was given: give the plane of the curve, or "
            "leave out the plane",
            most=Length(np.abs(off).max()),
        )
    return plane


def _side_of(run: Sequence[Edge], turned: FloatArray) -> Frame:
    """Return the plane of the edges. Its z axis points to the side that `placed_curve` describes."""
    if turned is AS_DRAWN and np.ptp(np.concatenate([edge.points[:, 2] for edge in run])) <= JOIN:
        return Frame((0.0, 0.0, run[0].start[2]))
    points = sample_run(run)
    x_axis, y_axis = _plane_axes(points, max(JOIN, 1e-6 * float(np.ptp(points, axis=0).max())))
    normal = np.cross(x_axis, y_axis)
    before = turned.T @ normal  # the normal before the rotation
    # in a horizontal plane the normal points up, else to the side from which the curve turns anticlockwise
    if (before[2] if np.hypot(*before[:2]) < TANGENT else _total_turn(points, normal)) < 0:
        x_axis, normal = -x_axis, -normal
    return Frame((run[0].start @ normal) * normal, x_axis, y_axis)


def _total_turn(points: FloatArray, normal: FloatArray) -> float:
    """Return the total turn, rad, of a polyline (m, 3) about a normal. If the total is 0, return the first
    turn."""
    chords = np.diff(points, axis=0)
    chords = chords[np.linalg.norm(chords, axis=1) > 0]
    before, after = chords[:-1], chords[1:]
    sines = np.cross(before, after) @ normal
    turns = np.arctan2(sines, np.einsum("ij,ij->i", before, after))
    whole = float(turns.sum())
    if abs(whole) > LEAST_TURN:
        return whole
    bends = turns[np.abs(turns) > LEAST_TURN]
    return float(bends[0]) if bends.size else 0.0
