"""An arch whose ends are bolted to two feet, in CadQuery: bolts and feet sit where the strip's joints are.

Run it to get arch.step and arch-strip.dxf.
"""

import cadquery as cq

import elastica_cad as ec
from elastica_cad.cadquery import bent_strip

SHEET = ec.Sheet.named("birch-plywood-0.8")
SPAN, RISE = 260, 110  # mm

points = [(0, 0), (40, 0.9 * RISE), (SPAN / 2, 1.9 * RISE), (SPAN - 40, 0.9 * RISE), (SPAN, 0)]
curve = cq.Workplane("XZ").bezier(points)
tab = ec.Tab(28, width=22, corner_radius=3, holes=(ec.Hole(8, 5.3), ec.Hole(20, 5.3)))
arch = bent_strip(curve, SHEET, max_width=36, ends=(tab, tab), gravity=True, label="arch")

bolt = cq.Workplane().circle(2.5).extrude(14).translate((0, 0, -7))
bolt = bolt.faces(">Z").workplane().circle(4.5).extrude(-3)
foot = (
    cq.Workplane(origin=(0, 0, -SHEET.thickness / 2))
    .center(tab.length / 2, 0)
    .rect(tab.length, tab.width)
    .extrude(-10)
    .pushPoints([(hole.at - tab.length / 2, 0) for hole in tab.holes])
    .circle(2.5)
    .cutThruAll()
)

assembly = cq.Assembly(name="arch").add(arch, name="strip", color=cq.Color(0.85, 0.70, 0.48))
for name, place in arch.joints.items():
    if ":" in name:  # hole1:top and the like lie on the faces; the bolt's middle is the hole's
        continue
    part, color = (bolt, (0.60, 0.62, 0.65)) if name.startswith("hole") else (foot, (0.30, 0.36, 0.42))
    assembly.add(part, name=f"at_{name}", loc=place, color=cq.Color(*color))

if __name__ == "__main__":
    print(arch.check)
    assembly.export("arch.step")
    ec.save(arch.strip.drawing(), "arch-strip.dxf", force=True)
