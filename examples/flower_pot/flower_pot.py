"""The Flower Pot (paper, section 9.2): radial sections of a surface, as laminated strips that touch.

python flower_pot.py [SURFACE.obj]     any OBJ, STL or PLY about the z axis, 60 mm to its unit
"""

import sys
from dataclasses import replace

import numpy as np

import elastica_cad as ec

COUNT = 16
SCALE = 60.0  # mm per unit
GAP = 2.0  # mm taken off each half width
RATIO = 2.8  # asked of the shape; the layers' weight, which is not proportional to stiffness, takes it to 3.5
LEAST_RADIUS = 50.0  # mm, that card of 0.1 + 0.2 mm bears for good
CARD = ec.Sheet.named("card-200gsm")
BASE = replace(CARD, name="card-0.1", thickness=0.1, thickness_range=None)
# control points of the profile: distance from the axis and height, mm; a belly, a neck, and a rim turned out
PROFILE = np.array([(52, 0), (90, 2), (140, 20), (166, 76), (136, 116), (103, 140), (104, 176)], dtype=float)
LEAN = np.array([0, 3, 8, 12, 8, 4, 4], dtype=float)  # mm that they move out on one side, and in on the other
LOBES = np.array([0, 0, 3, 3, -2, -2, 5], dtype=float)  # mm, twice around


def surface(turns=96, rows=80):
    """A pot whose profile, belly, neck and rim, changes around the axis; mm."""
    u, around = np.linspace(0, 1, rows), np.linspace(0, 2 * np.pi, turns + 1)
    profiles = [
        ec.PlaneCurve.spline(PROFILE + np.outer(LEAN * np.cos(v) + LOBES * np.sin(2 * v), (1, 0)))
        for v in around
    ]
    radius, height = np.moveaxis([profile.evaluate(u) for profile in profiles], -1, 0)
    points = np.stack([radius * np.cos(around[:, None]), radius * np.sin(around[:, None]), height], axis=-1)
    points[-1] = points[0]  # the seam closes
    corner = (np.arange(turns)[:, None] * rows + np.arange(rows - 1)).ravel()
    faces = np.concatenate(
        [np.column_stack([corner, corner + rows, corner + rows + 1]),
         np.column_stack([corner, corner + rows + 1, corner + 1])]
    )  # fmt: skip
    return ec.form_finding.Mesh(points.reshape(-1, 3), faces)


def build(mesh=None, count=COUNT, least_radius=LEAST_RADIUS):
    """Sections, the nearest curves that strips can follow, and on those strips that bear the weight of both layers.

    Without `least_radius` the card may bend beyond what it bears, as in the paper; the strips' warnings say where.
    """
    mesh = mesh or surface()
    planes = ec.form_finding.radial_planes((0, 0, 0), (0, 0, 1), 2 * np.pi * np.arange(count) / count)
    sections = ec.form_finding.mesh_sections(mesh.vertices, mesh.faces, planes, half=True)
    curves, reports = ec.form_finding.section_curves(sections, tolerance=0.3)
    layers = ec.mechanics.LaminatedSection(BASE, CARD).on(40.0)
    hanging = layers.bending_stiffness(20.0) / layers.weight_per_length(20.0)
    limits = ec.Limits(ratio=RATIO, margin=5.0, curvature=1 / least_radius if least_radius else None)
    found = ec.nearest_rods([c.curve for c in curves], limits, gravity=ec.Gravity(float(hanging) ** (1 / 3)))
    widths = ec.touching_widths(
        [(near.curve, c.frame) for near, c in zip(found, curves, strict=True)], GAP, closed=True
    )
    placed = []
    for near, c, width in zip(found, curves, widths, strict=True):
        label = f"F{len(placed) + 1}"
        reports += () if near.met else (f"{label}: {near.status.value}",)
        laminate = ec.mechanics.optimal_laminate(
            near.curve, layers, width, direction=(0, -1), least_backing=0.5, samples=201
        )
        style = ec.Laminated(width, backing=CARD, least_backing=0.5)
        strip = ec.Strip(laminate.rod, BASE, style=style, ends=(ec.Tab(6), ec.Tab(6)), label=label)
        placed.append(ec.Placed(strip, c.frame.origin, c.frame.x_axis, c.frame.y_axis))
    return ec.Model(tuple(placed), name="flower-pot", reports=reports)


if __name__ == "__main__":
    own = ec.formats.read_mesh(sys.argv[1], unit="cm").scaled(SCALE / 10) if len(sys.argv) > 1 else None
    print(ec.save_model(build(own), "out/flower_pot", force=True))
