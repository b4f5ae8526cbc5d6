"""Tapered strips and round rods bent by finite elements: their side view as its file (DXF) has it, meshed.

A strip is the side view made wide; a rod is a disc of quadrilaterals, drawn along with the view's heights.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np

from elastica_cad import Drawing, Sheet, Strip, StripSpec, Tab
from elastica_cad.formats import write_drawing
from elastica_cad.mechanics import RoundLaw, ThicknessLaw
from elastica_cad.strip import CUT_OUTER, LayeredPath
from elastica_cad.strip.tapered_solids import side_view
from tests.campaign.finite_elements.bent_strip import middle_line, on_curve
from tests.campaign.finite_elements.bricks import Bricks, extrude
from tests.campaign.finite_elements.calculix import Material, solve
from tests.campaign.finite_elements.cases import CURVES
from tests.campaign.finite_elements.drawn_requests import TAPERED_WIDTH
from tests.campaign.finite_elements.flat_mesh import FlatMesh, mesh_cut_files

__all__ = ["TAPERED", "Tapered", "bend_tapered", "tapered_strips"]

LENGTH, TAB = 400.0, 12.0
ELEMENT_MM = 8.0
ACROSS = 2


@dataclass(frozen=True)
class Tapered:
    """One strip or rod: `thickness` or diameter, least and largest, mm; `strayed` is a share of the length."""

    name: str
    length: float
    thickness: tuple[float, float]
    nodes: int
    strayed: float


def _spec(curve: str, poisson_ratio: float, most: float, *, rod: bool = False, **options: Any) -> StripSpec:
    drawn = CURVES[curve]
    scaled = drawn.transformed(np.diag([1.0, 1.0, drawn.length / LENGTH]))
    sheet = Sheet("known", 2.0, 9000.0, 1200.0, max_strain=0.05, poisson_ratio=poisson_ratio)
    law = RoundLaw(sheet, 0.2, most) if rod else ThicknessLaw(sheet, 0.2, most, width=TAPERED_WIDTH)
    return StripSpec(scaled, sheet, section=law, ends=(Tab(TAB), Tab(TAB)), ignore_limits=True, **options)


TAPERED: Mapping[str, StripSpec] = {
    "tall ellipse, nu 0": _spec("tall ellipse", 0.0, 2.4),
    "tall ellipse, nu 0.3": _spec("tall ellipse", 0.3, 2.4),
    "hook, nu 0.3": _spec("hook", 0.3, 2.4),
    "S, nu 0.3": _spec("S", 0.3, 2.0),
    "heavy bow, nu 0.3": _spec("bow", 0.3, 0.8, gravity=True),
    "round rod, hook, nu 0.3": _spec("hook", 0.3, 5.0, rod=True),
    "round rod, heavy bow, nu 0.3": _spec("bow", 0.3, 1.0, rod=True, gravity=True),
}
"""The bank."""


def tapered_strips(folder: Path) -> Iterator[Tapered]:
    """All of them, bent."""
    for name, spec in TAPERED.items():
        yield bend_tapered(name, spec, folder)


def bend_tapered(name: str, spec: StripSpec, folder: Path, size: float = ELEMENT_MM) -> Tapered:
    """A strip held by its tabs in the drawn pose: how far its middle strays from the curve."""
    strip = spec.make()
    falls = spec.gravity_in_plane
    is_rod = isinstance(strip.layout.section, RoundLaw)
    body = None if is_rod else _body(strip, folder, size)
    upright = _rod_body(strip, folder, size) if body is None else _turned(body)
    sheet = strip.sheet
    pose = on_curve(strip.rod.curve, upright.nodes)
    x = upright.nodes[:, 0]
    held = (x < 1e-6) | (x > strip.rod.length - 1e-6)
    answer = solve(
        upright,
        [Material(sheet.youngs_modulus, sheet.poisson_ratio, sheet.density)] * ACROSS,
        pose,
        held,
        folder,
        gravity=None if falls is None else (falls.direction[0], 0.0, falls.direction[1]),
    )
    strayed = upright.nodes + answer.displacement - pose
    # of a rod the axis: what its sections do to stay round has no mean
    off = (
        strayed[_on_axis(upright)][:, [0, 2]]
        if body is None
        else middle_line(body, strayed, strip.rod.length)[1]
    )
    thickness = strip.layout.size
    assert thickness is not None
    return Tapered(
        name,
        strip.rod.length,
        thickness.extremes,
        len(upright.nodes),
        float(np.hypot(*off.T).max()) / strip.rod.length,
    )


def _side_file(strip: Strip, folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "side.dxf"
    write_drawing(Drawing("side", (LayeredPath(CUT_OUTER, side_view(strip)),)), path, force=True)
    return path


def _body(strip: Strip, folder: Path, size: float) -> Bricks:
    """The side view as its file has it, in x and y, made wide along z."""
    flat = mesh_cut_files([_side_file(strip, folder)], size=size, at=(0.0, strip.rod.length))
    return extrude(
        replace(flat, layers=np.full_like(flat.layers, ACROSS)),
        np.linspace(-TAPERED_WIDTH / 2, TAPERED_WIDTH / 2, ACROSS + 1).tolist(),
    )


def _turned(body: Bricks) -> Bricks:
    """The body with its thickness along z and its width along y, as strips lie."""
    x, y, z = body.nodes.T
    return replace(body, nodes=np.column_stack([x, -z, y]))


def _rod_body(strip: Strip, folder: Path, size: float) -> Bricks:
    """Discs as wide as the side view's file is high, along x."""
    length = strip.rod.length
    along = np.linspace(0.0, length, round(length / size) + 1)
    levels = [-TAB, *along, length + TAB]
    unit = extrude(_disc(len(levels) - 1), levels)
    y, z, x = unit.nodes.T
    radius = _radius(_side_file(strip, folder), x)
    nodes = np.column_stack([x, radius * y, radius * z])
    return replace(unit, nodes=nodes, layer=np.zeros_like(unit.layer))


def _radius(path: Path, x: np.ndarray) -> np.ndarray:
    """Half the height (n,) of the side view in a file at stations (n,)."""
    above = [
        (point.x, point.y)
        for entity in ezdxf.readfile(path).modelspace()
        for point in _flattened(entity)
        if point.y > 0
    ]
    at, height = np.array(sorted(above)).T
    return np.interp(x, at, height)


def _flattened(entity: Any) -> Iterator[Any]:
    if entity.dxftype() == "LINE":
        return iter((entity.dxf.start, entity.dxf.end))
    return iter(entity.flattening(1e-5))


def _disc(layers: int) -> FlatMesh:
    """A disc of radius 1: four quadrilaterals about its middle, eight around them, sides bent along the rim."""
    ring = np.exp(0.125j * np.pi * np.arange(16))
    rim, inner = (
        ring,
        np.where(np.arange(16) % 2 == 0, 0.5 * ring, 0.5 * (np.roll(ring, 1) + np.roll(ring, -1)) / 2),
    )
    spokes, crosses = 0.75 * ring[::2], 0.25 * ring[::4]
    nodes = np.concatenate([[0], crosses, inner, spokes, rim])
    cross, first, spoke, outer = 1, 5, 21, 29
    quads = [
        [0, first + 4 * k, first + 4 * k + 2, first + (4 * k + 4) % 16,
         cross + k, first + 4 * k + 1, first + 4 * k + 3, cross + (k + 1) % 4]
        for k in range(4)
    ] + [
        [first + 2 * k, outer + 2 * k, outer + (2 * k + 2) % 16, first + (2 * k + 2) % 16,
         spoke + k, outer + 2 * k + 1, spoke + (k + 1) % 8, first + 2 * k + 1]
        for k in range(8)
    ]  # fmt: skip
    return FlatMesh(np.column_stack([nodes.real, nodes.imag]), np.array(quads), np.full(12, layers))


def _on_axis(body: Bricks) -> np.ndarray:
    return np.hypot(*body.nodes[:, 1:].T) < 1e-9
