"""A lamp of ten plywood strips between two rings, in CadQuery.

Run it to get lamp.step (all parts, named) and lamp-strip.dxf (the strip to cut ten times).
"""

import cadquery as cq

import elastica_cad as ec
from elastica_cad.cadquery import bent_strip

SHEET = ec.Sheet.named("birch-plywood-0.8")
STRIPS, HEIGHT, NECK, REACH, RING = 10, 260, 50, 140, 4  # count, then mm

# The meridian leaves both rings upright and swings out between them.
points = [(NECK, 0), (NECK, 60), (REACH, 80), (REACH, HEIGHT - 80), (NECK, HEIGHT - 60), (NECK, HEIGHT)]
meridian = cq.Workplane("XZ").bezier(points)
tab = ec.Tab(RING + 6, width=10)
strip = bent_strip(meridian, SHEET, max_width=24, ends=(tab, tab), label="lamp")

# Each tab goes through a slot of its ring.
ring = (
    cq.Workplane()
    .circle(NECK + 12)
    .circle(NECK - 12)
    .extrude(RING)
    .polarArray(NECK, 0, 360, STRIPS)
    .rect(SHEET.thickness + 0.2, tab.width + 0.2)
    .cutThruAll()
)

lamp = cq.Assembly(name="lamp")
for number in range(STRIPS):
    turn = cq.Location((0, 0, 0), (0, 0, 1), 360 / STRIPS * number)
    lamp.add(strip, name=f"strip_{number + 1}", loc=turn, color=cq.Color(0.85, 0.70, 0.48))
for name, z in (("lower_ring", -RING), ("upper_ring", HEIGHT)):
    lamp.add(ring, name=name, loc=cq.Location((0, 0, z)), color=cq.Color(0.35, 0.30, 0.28))

if __name__ == "__main__":
    print(strip.check)
    lamp.export("lamp.step")
    ec.save(strip.strip.drawing(), "lamp-strip.dxf", force=True)
