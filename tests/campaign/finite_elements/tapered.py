"""Tapered strips bent by finite elements: the side view as its file (DXF) has it, meshed and made wide."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.fabrication.drawings.drawing import CUT_OUTER, Drawing, LayeredPath
from elastica_cad.fabrication.solids.side_views import side_view
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.tabs import Tab
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.formats.drawing_files.write_drawing import write_drawing
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import ThicknessLaw
from tests.campaign.finite_elements.bent_strip import middle_line, on_curve
from tests.campaign.finite_elements.bricks import Bricks, extrude
from tests.campaign.finite_elements.calculix import Material, solve
from tests.campaign.finite_elements.cases import CURVES
from tests.campaign.finite_elements.flat_mesh import mesh_cut_files

__all__ = ["TAPERED", "Tapered", "bend_tapered", "tapered_strips"]

LENGTH, WIDTH, TAB = 400.0, 8.0, 12.0
ELEMENT_MM = 8.0
ACROSS = 2


@dataclass(frozen=True)
class Tapered:
    """One strip: `thickness` least and largest, mm; `strayed` is a share of the length."""

    name: str
    length: float
    thickness: tuple[float, float]
    nodes: int
    strayed: float


def _spec(curve: str, poisson_ratio: float, most: float, **asked: Any) -> StripSpec:
    drawn = CURVES[curve]
    scaled = drawn.transformed(np.diag([1.0, 1.0, drawn.length / LENGTH]))
    sheet = Sheet("known", 2.0, 9000.0, 1200.0, max_strain=0.05, poisson_ratio=poisson_ratio)
    law = ThicknessLaw(sheet, 0.2, most, width=WIDTH)
    return StripSpec(scaled, sheet, law=law, ends=(Tab(TAB), Tab(TAB)), anyway=True, **asked)


TAPERED: Mapping[str, StripSpec] = {
    "tall ellipse, nu 0": _spec("tall ellipse", 0.0, 2.4),
    "tall ellipse, nu 0.3": _spec("tall ellipse", 0.3, 2.4),
    "hook, nu 0.3": _spec("hook", 0.3, 2.4),
    "S, nu 0.3": _spec("S", 0.3, 2.0),
    "heavy bow, nu 0.3": _spec("bow", 0.3, 0.8, gravity=True),
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
    body = _body(strip, folder, size)
    sheet = strip.sheet
    upright = _turned(body)
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
    _, off = middle_line(body, strayed, strip.rod.length)
    thickness = strip.layout.size
    assert thickness is not None
    return Tapered(
        name,
        strip.rod.length,
        thickness.extremes,
        len(body.nodes),
        float(np.hypot(*off.T).max()) / strip.rod.length,
    )


def _body(strip: Strip, folder: Path, size: float) -> Bricks:
    """The side view as its file has it, in x and y, made wide along z."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "side.dxf"
    write_drawing(Drawing("side", (LayeredPath(CUT_OUTER, side_view(strip)),)), path, force=True)
    flat = mesh_cut_files([path], size=size, at=(0.0, strip.rod.length))
    return extrude(
        replace(flat, layers=np.full_like(flat.layers, ACROSS)),
        np.linspace(-WIDTH / 2, WIDTH / 2, ACROSS + 1).tolist(),
    )


def _turned(body: Bricks) -> Bricks:
    """The body with its thickness along z and its width along y, as strips lie."""
    x, y, z = body.nodes.T
    return replace(body, nodes=np.column_stack([x, -z, y]))
