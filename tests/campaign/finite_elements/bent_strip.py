"""One strip: cut files out, cut files in, bent and held as designed, compared with the curve that was drawn."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from elastica_cad import PlaneCurve, Strip
from elastica_cad.formats import write_drawing
from tests.campaign.finite_elements.bricks import Bricks, extrude
from tests.campaign.finite_elements.calculix import Answer, Material, solve
from tests.campaign.finite_elements.flat_mesh import mesh_cut_files

__all__ = ["BentStrip", "bend_cut_strip", "flat_body", "in_tabs", "middle_line", "on_curve"]


@dataclass(frozen=True, eq=False)
class BentStrip:
    """A strip bent by finite elements.

    Attributes
    ----------
    body : Bricks
    position : (n, 3) array
        Of the nodes at rest, mm; y across the strip.
    eigenvalues : (k,) array
        1/s2, of the slowest swings; negative where the strip would leave this shape.
    sideways : (k,) bool array
        Which of these swings leave the plane of the curve.
    stations : (b,) array
        Arc lengths, mm, at the middles of bins.
    strayed : (b, 2) array
        From the drawn curve to the middle of the section there, mm.
    """

    body: Bricks
    position: np.ndarray
    eigenvalues: np.ndarray
    sideways: np.ndarray
    stations: np.ndarray
    strayed: np.ndarray

    @property
    def deviation(self) -> float:
        """Largest distance of the middle line from the drawn curve, mm."""
        return float(np.hypot(*self.strayed.T).max())


def bend_cut_strip(
    strip: Strip,
    folder: Path,
    *,
    size: float,
    gravity: tuple[float, float] | None = None,
    modes: int = 0,
    held: Callable[[np.ndarray], np.ndarray] | None = None,
    curve: PlaneCurve | None = None,
    across: float | None = None,
) -> BentStrip:
    """A strip as its cut files (DXF, without kerf) have it, held by its tabs in the drawn pose.

    Parameters
    ----------
    size : float
        Length of the elements' sides, mm.
    gravity : (gx, gy), optional
        Direction in which the strip falls, in the plane of the curve; weightless if not given.
    modes : int
        How many swings about the rest shape are asked for.
    held : callable, optional
        Which of flat points (n, 3) are held; the tabs if not given.
    curve : PlaneCurve, optional
        The drawn curve, where it is not the rod's.
    across : float, optional
        E across the strip, MPa, of sheets whose G is known; that along it if not given.
    """
    drawn = strip.rod.curve if curve is None else curve
    if (
        strip.layout.backing is not None
    ):  # it lies to the right of the curve, and here to the left: seen in a mirror
        assert gravity is None, "laminates are bent weightless"
        drawn = drawn.transformed(np.diag([1.0, -1.0, 1.0]))
    length = strip.rod.length
    body = flat_body(strip, folder, size=size)
    stays = in_tabs(strip, body.nodes) if held is None else held(body.nodes)
    stack = strip.layout.stack
    sheets = [layer.sheet for layer in strip.layers] if stack is None else [stack.sheet] * len(_leaves(strip))
    materials = [
        Material(one.youngs_modulus, one.poisson_ratio, one.density, one.shear_modulus, across)
        for one in sheets
    ]
    falls = None if gravity is None else (gravity[0], 0.0, gravity[1])
    answer: Answer = solve(
        body, materials, on_curve(drawn, body.nodes), stays, folder, gravity=falls, modes=modes
    )
    position = body.nodes + answer.displacement
    stations, strayed = middle_line(body, position - on_curve(drawn, body.nodes), length)
    sideways = [_leaves_plane(body, mode, length) for mode in answer.modes]
    return BentStrip(body, position, answer.eigenvalues, np.array(sideways, dtype=bool), stations, strayed)


def flat_body(strip: Strip, folder: Path, *, size: float, at: Sequence[float] = ()) -> Bricks:
    """A strip as its cut files have it, written to a folder and read again; elements meet across `at`, mm."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"layer{i}.dxf" for i in range(len(strip.layers))]
    for drawing, path in zip(strip.drawings(), files, strict=True):
        write_drawing(drawing, path, force=True)
    return extrude(mesh_cut_files(files, size=size, at=sorted({0.0, *at, strip.rod.length})), _levels(strip))


def on_curve(curve: PlaneCurve, nodes: np.ndarray) -> np.ndarray:
    """Flat points (n, 3) on a strip that follows a curve, straight beyond its ends; (n, 3) with y across."""
    s, y, z = nodes.T
    on = curve.at(np.clip(s, 0.0, curve.length))
    tangent = np.column_stack([np.cos(on.angle), np.sin(on.angle)])
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    plane = on.position + (s - np.clip(s, 0.0, curve.length))[:, None] * tangent + z[:, None] * normal
    return np.column_stack([plane[:, 0], y, plane[:, 1]])


def in_tabs(strip: Strip, nodes: np.ndarray) -> np.ndarray:
    """Which points (n, 3) belong to the tabs, with their roots at the ends of the free part."""
    x, y, _ = nodes.T
    held = np.zeros(x.size, dtype=bool)
    for beyond, tab, own in zip((-x, x - strip.rod.length), strip.ends, strip.end_widths, strict=True):
        root = (abs(beyond) < 1e-6) & (abs(y) < (tab.width or own) / 2 + 1e-3)
        held |= (beyond > 1e-6) | root
    return held


def _levels(strip: Strip) -> list[float]:
    """z of the sheets' faces; 0 is the middle of one sheet, of a laminate its mean neutral axis."""
    if strip.layout.stack is not None:  # the through leaf is centred on the curve
        h = strip.layout.stack.sheet.thickness
        return [(k - 0.5) * h for k in range(len(_leaves(strip)) + 1)]
    h = [layer.sheet.thickness for layer in strip.layers]
    if len(h) == 1:
        return [-h[0] / 2, h[0] / 2]
    s = np.linspace(0.0, strip.rod.length, 401)
    A = [layer.sheet.youngs_modulus * layer.sheet.thickness * layer.material(s) for layer in strip.layers]
    neutral = float(np.mean((h[0] / 2 * A[0] + (h[0] + h[1] / 2) * A[1]) / (A[0] + A[1])))
    return [-neutral, h[0] - neutral, h[0] + h[1] - neutral]


def _leaves(strip: Strip) -> range:
    """Numbers of the leaves that lie on each other where most do."""
    return range(1, 1 + max(leaf.number for leaf in strip.layout.stack.leaves))


def _leaves_plane(body: Bricks, mode: np.ndarray, length: float) -> bool:
    """Is the middle line at rest in the plane, up to a tenth of what moves most, while the strip swings?"""
    _, middle = middle_line(body, mode, length)
    return bool(np.abs(middle).max() < 0.1 * np.abs(mode).max())


def middle_line(
    body: Bricks, strayed: np.ndarray, length: float, bins: int = 120
) -> tuple[np.ndarray, np.ndarray]:
    """Mean over the section, in bins along the strip, of how far the base's middle strayed in the curve's plane.

    The mean, not the line y = 0: a wide strip curls across, and a perforated one may have a hole there.
    """
    bricks = body.bricks[body.layer == 0]
    low, high = bricks[:, [0, 1, 2, 3, 8, 9, 10, 11]], bricks[:, [4, 5, 6, 7, 12, 13, 14, 15]]
    shape = _shape_functions(8)
    middle = (shape @ ((strayed[low] + strayed[high]) / 2)[:, :, [0, 2]]).reshape(-1, 2)
    s = (shape @ body.nodes[low, 0][:, :, None]).ravel()
    corners = body.nodes[low[:, :4], :2]
    d1, d2 = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    area = np.repeat(abs(d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]), len(shape))
    which = np.floor(s / length * bins).astype(int)
    inside = (which >= 0) & (which < bins)
    which, area = which[inside], area[inside]
    total = np.bincount(which, area, bins)
    means = [np.bincount(which, area * value[inside], bins) / total for value in (s, *middle.T)]
    return means[0], np.column_stack(means[1:])


def _shape_functions(count: int) -> np.ndarray:
    """Values (count^2, 8) of the eight-node quadrilateral's functions at the middles of equal cells."""
    at = (np.arange(count) + 0.5) / count * 2 - 1
    x, y = (v.ravel() for v in np.meshgrid(at, at))
    corners = [
        (1 + a * x) * (1 + b * y) * (a * x + b * y - 1) / 4 for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    sides = [
        (1 - x**2) * (1 - y) / 2,
        (1 + x) * (1 - y**2) / 2,
        (1 - x**2) * (1 + y) / 2,
        (1 - x) * (1 - y**2) / 2,
    ]
    return np.column_stack([*corners, *sides])
