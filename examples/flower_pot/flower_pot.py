"""The Flower Pot (paper, section 9.2): radial sections of a surface, as laminated strips that touch.

python flower_pot.py [SURFACE.obj]     any OBJ, STL or PLY about the z axis, 60 mm to its unit
"""

import sys

import numpy as np

import elastica_cad as ec

COUNT = 16
SCALE = 60.0  # mm per unit
GAP = 2.0  # mm taken off each half width
RATIO = 3.5
CARD = ec.Sheet.named("card-200gsm")
BASE = ec.Sheet("card-0.1", 0.1, CARD.youngs_modulus, density=CARD.density, max_strain=CARD.max_strain)


def surface(turns=96, rows=60):
    """A pot that leans: its belly and its rim lie to different sides; mm."""
    height = np.linspace(0, 1, rows)
    around = np.linspace(0, 2 * np.pi, turns + 1)
    h, v = np.meshgrid(height, around, indexing="ij")
    radius = 60 + 200 * h - 190 * h**2 + 45 * h**3 + 14 * h * (1 - h) * np.cos(v) + 4 * h**2 * np.sin(2 * v)
    points = np.stack([radius * np.cos(v), radius * np.sin(v), 150 * h], axis=-1)
    points[:, -1] = points[:, 0]  # the seam closes
    corner = (np.arange(rows - 1)[:, None] * (turns + 1) + np.arange(turns)).ravel()
    below, right, across = corner + turns + 1, corner + 1, corner + turns + 2
    faces = np.concatenate(
        [np.column_stack([corner, below, across]), np.column_stack([corner, across, right])]
    )
    return ec.Mesh(points.reshape(-1, 3), faces)


def build(mesh=None, count=COUNT):
    """The weight counts as proportional to the stiffness; `deviation_as_made` tells what that costs."""
    mesh = mesh or surface()
    planes = ec.radial_planes((0, 0, 0), (0, 0, 1), 2 * np.pi * np.arange(count) / count)
    sections = ec.mesh_sections(mesh.vertices, mesh.faces, planes, half=True)
    curves, reports = ec.section_curves(sections, tolerance=0.5)
    layers = ec.LaminatedSection(BASE, CARD)
    hanging = layers.bending_stiffness(30.0, 20.0) / layers.weight_per_length(30.0, 20.0)
    gravity = ec.Gravity(float(hanging) ** (1 / 3))
    found = ec.nearest_rods([c.curve for c in curves], ec.Limits(ratio=RATIO, margin=5.0), gravity=gravity)
    widths = ec.touching(
        [(near.rod.curve, c.frame) for near, c in zip(found, curves, strict=True)], GAP, closed=True
    )
    placed = []
    for near, c, width in zip(found, curves, widths, strict=True):
        outline = ec.Profile(width.knots * (near.rod.length / width.length), width.coefficients)
        style = ec.Laminated(outline, backing=CARD, least_backing=0.5)
        strip = ec.Strip(
            near.rod, BASE, style=style, ends=(ec.Tab(6), ec.Tab(6)), label=f"F{len(placed) + 1}"
        )
        placed.append(ec.Placed(strip, c.frame.origin, c.frame.x_axis, c.frame.y_axis))
    return ec.Model(tuple(placed), name="flower-pot", reports=reports)


if __name__ == "__main__":
    own = ec.read_mesh(sys.argv[1], unit="cm").scaled(SCALE / 10) if len(sys.argv) > 1 else None
    ec.save_model(build(own), "out/flower-pot")
