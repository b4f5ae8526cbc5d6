"""Strips of two pieces under a plate, bent by finite elements: the base is cut through, the plate glued over it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from elastica_cad import Strip
from elastica_cad.formats import write_drawing
from elastica_cad.strip import compensate_widths
from elastica_cad.strip.layers import LapPlates
from tests.campaign.finite_elements.bent_strip import in_tabs, middle_line, on_curve
from tests.campaign.finite_elements.bricks import Bricks, extrude
from tests.campaign.finite_elements.calculix import Material, solve
from tests.campaign.finite_elements.cases import Case, ply
from tests.campaign.finite_elements.flat_mesh import FlatMesh, mesh_cut_files

__all__ = ["JOINED", "Joined", "bend_joined", "joined_strips"]

LENGTH, ELEMENT_MM = 300.0, 4.0
AT_MM = 1e-5


@dataclass(frozen=True)
class Joined:
    """One strip: `strayed` by finite elements and as `told`, shares of the length, and with widths that make up."""

    name: str
    length: float
    lap: float
    strayed: float
    told: float
    made_up: float
    told_made_up: float


def _strip(curve: str, poisson_ratio: float, width: float, joint: float, lap: float) -> Strip:
    request = {"max_width": width, "ignore_limits": True, "compensate": False}
    made = Case("joined", curve, curve, LENGTH, ply(0.8, poisson_ratio), ELEMENT_MM, request).spec.make()
    return replace(made, plates=LapPlates((joint,), lap))


JOINED: Mapping[str, Strip] = {
    "arch, nu 0": _strip("arch", 0.0, 30.0, 150.0, 40.0),
    "S, nu 0": _strip("S", 0.0, 30.0, 90.0, 30.0),
    "bow, nu 0.3": _strip("bow", 0.3, 30.0, 150.0, 24.0),
    "arch, nu 0.3": _strip("arch", 0.3, 20.0, 110.0, 60.0),
}
"""The bank: name, with one joint and its plate."""


def joined_strips(folder: Path) -> Iterator[Joined]:
    """All of them, bent as the stiffness alone asks and with widths that make up for the plate."""
    for name, strip in JOINED.items():
        better = compensate_widths(strip)
        shares = [(bend_joined(one, folder) / LENGTH, one.held_deviation / LENGTH) for one in (strip, better)]
        assert strip.plates is not None
        yield Joined(name, LENGTH, strip.plates.lap, *shares[0], *shares[1])


def bend_joined(strip: Strip, folder: Path) -> float:
    """How far, mm, its middle line strays from the drawn curve, held by its tabs."""
    plates = strip.plates
    assert plates is not None
    (joint,), half = plates.joints, plates.lap / 2
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "layer0.dxf"
    bare = replace(strip, plates=None)
    write_drawing(bare.drawing(), file, force=True)
    lines = (0.0, joint - half, joint, joint + half, strip.rod.length)
    flat = mesh_cut_files([file], size=ELEMENT_MM, at=lines)
    middle = flat.nodes[flat.quads[:, :4], 0].mean(axis=1)
    flat = FlatMesh(flat.nodes, flat.quads, np.where(np.abs(middle - joint) < half, 2, 1))
    h = strip.sheet.thickness
    body = _cut_through(extrude(flat, [-h / 2, h / 2, 3 * h / 2]), joint, h / 2)
    pose = on_curve(strip.rod.curve, body.nodes)
    sheet = strip.sheet
    materials = [Material(sheet.youngs_modulus, sheet.poisson_ratio, sheet.density)] * 2
    answer = solve(body, materials, pose, in_tabs(bare, body.nodes), folder)
    _, strayed = middle_line(body, body.nodes + answer.displacement - pose, strip.rod.length)
    return float(np.hypot(*strayed.T).max())


def _cut_through(body: Bricks, joint: float, glue: float) -> Bricks:
    """The base's two pieces have nodes of their own at the joint, below the glue."""
    nodes = body.nodes
    there = np.flatnonzero((np.abs(nodes[:, 0] - joint) < AT_MM) & (nodes[:, 2] < glue - AT_MM))
    twin = np.arange(len(nodes))
    twin[there] = len(nodes) + np.arange(there.size)
    beyond = (body.layer == 0) & (nodes[body.bricks, 0].mean(axis=1) > joint)
    bricks = np.where(beyond[:, None], twin[body.bricks], body.bricks)
    return Bricks(np.vstack([nodes, nodes[there]]), bricks, body.layer, body.flat)
