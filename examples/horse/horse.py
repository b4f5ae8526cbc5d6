"""The Horse (paper, section 9.2): body, neck and head of an animal, cut across, split at the spine, laminated.

The animal is our own, from ten ellipses along a bent spine. Legs and tail are no strips, here as in the paper,
where they were printed. Between the halves there is room for a rail along spine and belly, which holds their tabs.
"""

import sys
from dataclasses import replace

import numpy as np

import elastica_cad as ec

PLANES = 20
RATIO = 2.0
LEAST_RADIUS = 40.0  # mm, for both layers
SPACING = 560.0 / PLANES
RAIL = 16.0  # mm between the halves
TAB = ec.Tab(6)
CARD = ec.Sheet.named("card-200gsm")
PAPER = replace(CARD, name="paper-100gsm", thickness=0.1, thickness_range=None)
# along x: height of the spine's axis, half width and half height of the body there, mm
STATIONS = np.array([
    (0, 230, 54, 58), (70, 240, 67, 75), (150, 236, 71, 81), (235, 227, 72, 82), (310, 236, 68, 82),
    (370, 272, 62, 84), (430, 330, 55, 76), (480, 372, 50, 62), (525, 366, 47, 54), (560, 340, 44, 46),
])  # fmt: skip


def surface(turns=80, rows=160):
    """Rings of eggs about the spine, fuller below; mm."""
    x = np.linspace(0, 560, rows)
    axis, wide, tall = (ec.Profile.interpolate(STATIONS[:, 0], column)(x) for column in STATIONS.T[1:])
    v = np.linspace(0, 2 * np.pi, turns + 1)
    y = wide[:, None] * np.sin(v) * (1 - 0.06 * np.cos(v))
    z = axis[:, None] + tall[:, None] * np.cos(v)
    points = np.stack([np.broadcast_to(x[:, None], y.shape), y, z], axis=-1)
    points[:, -1] = points[:, 0]
    corner = (np.arange(rows - 1)[:, None] * (turns + 1) + np.arange(turns)).ravel()
    far = corner + turns + 1
    faces = np.concatenate(
        [np.column_stack([corner, far, far + 1]), np.column_stack([corner, far + 1, corner + 1])]
    )
    return ec.form_finding.Mesh(points.reshape(-1, 3), faces)


def half(line, side):
    """What of a closed section lies on one side (1: left, -1: right) of the rail."""
    pieces = line.split_by((0, side * RAIL / 2, 0), (0, 1, 0))
    return max(pieces, key=lambda piece: side * piece.places[:, 1].mean())


def build(planes=PLANES):
    mesh = surface()
    frames = ec.form_finding.parallel_planes((0, 0, 0), (1, 0, 0), 560 * (np.arange(planes) + 0.5) / planes)
    sections = ec.form_finding.mesh_sections(mesh.vertices, mesh.faces, frames)
    halves = [half(section.line, side) for section in sections for side in (1, -1)]
    curves, reports = ec.form_finding.section_curves(halves, tolerance=0.2)
    found = ec.nearest_rods(
        [c.curve for c in curves], ec.Limits(ratio=RATIO, margin=5.0, curvature=1 / LEAST_RADIUS)
    )
    style = ec.Laminated(SPACING - 4, backing=CARD)
    placed = []
    for near, c in zip(found, curves, strict=True):
        strip = ec.Strip(near.rod, PAPER, style=style, ends=(TAB, TAB), label=f"H{len(placed) + 1}")
        placed.append(ec.Placed(strip, c.frame.origin, c.frame.x_axis, c.frame.y_axis))
    return ec.Model(tuple(placed), name="horse", reports=reports)


if __name__ == "__main__":
    print(ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/horse", force=True))
