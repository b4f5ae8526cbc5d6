"""The Shell (paper, section 9.3): a roof of three-fold symmetry, sixty perforated strips of card, ten different."""

import sys

import numpy as np

import elastica_cad as ec

STRIPS = 10  # across one sixth of the roof
SPAN, RISE = 240.0, 130.0  # mm
RATIO = 1.5
GAP = 0.5  # mm taken off each half width
TABS = (ec.Tab(10), ec.Tab(10, taper=1.0))  # towards the axis there is less room between neighbours
CARD = ec.Sheet.named("card-200gsm")


def height(x, y):
    """A dome that three arches carry; towards their edges it turns up, so that every strip bends both ways."""
    r, v = np.hypot(x, y) / SPAN, np.arctan2(y, x)
    return RISE * (1 - 1.75 * r**2 + 0.75 * r**4) * (1 + 0.3 * r**2 * np.cos(3 * v))


def planes():
    """Upright planes fanned out about the axis, over a sixth of the roof."""
    sixth = np.pi / 3
    return ec.form_finding.radial_planes((0, 0, 0), (0, 0, 1), sixth * (np.arange(STRIPS) + 0.5) / STRIPS)


def surface(rows=60, turns=120):
    v, r = np.meshgrid(np.linspace(-0.1, np.pi / 3 + 0.1, turns), np.linspace(0.42, 1.0, rows), indexing="ij")
    x, y = SPAN * r * np.cos(v), SPAN * r * np.sin(v)
    points = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(turns - 1)[:, None] * rows + np.arange(rows - 1)).ravel()
    faces = np.concatenate(
        [np.column_stack([corner, corner + rows, corner + rows + 1]),
         np.column_stack([corner, corner + rows + 1, corner + 1])]
    )  # fmt: skip
    return ec.form_finding.Mesh(points, faces)


def build():
    mesh = surface()
    sections = ec.form_finding.mesh_sections(mesh.vertices, mesh.faces, planes(), half=True)
    curves, reports = ec.form_finding.section_curves(
        sections, tolerance=0.1, false_turn=0.0
    )  # gentle bends are meant
    found = ec.nearest_rods([c.curve for c in curves], ec.Limits(ratio=RATIO, margin=5.0))
    widths = ec.touching_widths([(near.curve, c.frame) for near, c in zip(found, curves, strict=True)], GAP)
    placed = []
    for near, c, width in zip(found, curves, widths, strict=True):
        style = ec.Perforated(width, columns=2, rows=3, hole_ratio=0.9)
        strip = ec.Strip(near.rod, CARD, style=style, ends=TABS, label=f"S{len(placed) + 1}")
        placed.append(ec.Placed(strip, c.frame.origin, c.frame.x_axis, c.frame.y_axis))
    sixth = ec.Model(tuple(placed), name="shell", reports=reports)
    return sixth.mirrored((0, 0, 0), (0, 1, 0)).rotated(3)


if __name__ == "__main__":
    print(ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/shell", force=True))
