"""An arch whose ends are bolted to two feet, in build123d: joints put the bolts where the holes are.

Run it to get arch.step and arch-strip.dxf.
"""

from build123d import Box, Color, Compound, Cylinder, Edge, Plane, Pos, RigidJoint, export_step

import elastica_cad as ec
from elastica_cad.build123d import BentStrip

SHEET = ec.Sheet.named("birch-plywood-0.8")
SPAN, RISE = 260, 110  # mm

points = [(0, 0), (40, 0.9 * RISE), (SPAN / 2, 1.9 * RISE), (SPAN - 40, 0.9 * RISE), (SPAN, 0)]
curve = Plane.XZ * Edge.make_bezier(*points)
tab = ec.Tab(28, width=22, corner_radius=3, holes=(ec.Hole(8, 5.3), ec.Hole(20, 5.3)))
arch = BentStrip(curve, SHEET, max_width=36, ends=(tab, tab), gravity=True, label="arch")

# A bolt: its joint is half way through the strip, its axis the hole's.
bolt = Cylinder(2.5, 14) + Pos(0, 0, 5) * Cylinder(4.5, 3)
bolt.color = Color(0.6, 0.62, 0.65)

parts = [arch]
for name in ("hole1", "hole2", "hole3", "hole4"):
    one = Pos(0, 0, 0) * bolt
    one.label = f"bolt in {name}"
    RigidJoint("strip", one)
    arch.joints[name].connect_to(one.joints["strip"])
    parts.append(one)

# A foot lies under each tab: 10 mm thick, as wide as the tab, drilled by its bolts.
for end, holes in (("start", (1, 2)), ("end", (3, 4))):
    foot = Pos(tab.length / 2, 0, -5 - SHEET.thickness / 2) * Box(tab.length, tab.width, 10)
    RigidJoint("strip", foot)
    arch.joints[end].connect_to(foot.joints["strip"])
    foot -= [parts[number] for number in holes]
    foot.label, foot.color = f"foot at the {end}", Color(0.30, 0.36, 0.42)
    parts.append(foot)
assembly = Compound(label="arch", children=parts)

if __name__ == "__main__":
    print(arch.check)
    export_step(assembly, "arch.step")
    ec.save(arch.strip.drawing(), "arch-strip.dxf", force=True)
