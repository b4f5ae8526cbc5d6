"""A lamp of ten plywood strips between two rings, in build123d.

Run it to get lamp.step (all parts, named) and lamp-strip.dxf (the strip to cut ten times).
"""

from build123d import Box, Color, Compound, Cylinder, Edge, Plane, PolarLocations, Pos, export_step

import elastica_cad as ec
from elastica_cad.build123d import BentStrip

SHEET = ec.Sheet.named("birch-plywood-0.8")
STRIPS, HEIGHT, NECK, REACH, RING = 10, 260, 50, 140, 4  # count, then mm

# The meridian leaves both rings upright and swings out between them.
points = [(NECK, 0), (NECK, 60), (REACH, 80), (REACH, HEIGHT - 80), (NECK, HEIGHT - 60), (NECK, HEIGHT)]
meridian = Plane.XZ * Edge.make_bezier(*points)
tab = ec.Tab(RING + 6, width=10)
strip = BentStrip(meridian, SHEET, max_width=24, ends=(tab, tab), label="lamp")

# Each tab goes through a slot of its ring.
turns = PolarLocations(0, STRIPS)
slot = Pos(NECK, 0, 0) * Box(SHEET.thickness + 0.2, tab.width + 0.2, RING)
ring = Cylinder(NECK + 12, RING) - Cylinder(NECK - 12, RING) - [turn * slot for turn in turns]
ring.color = Color(0.35, 0.30, 0.28)

strips = [turn * strip for turn in turns]
rings = [Pos(0, 0, -RING / 2) * ring, Pos(0, 0, HEIGHT + RING / 2) * ring]
for number, part in enumerate(strips, start=1):
    part.label = f"strip {number}"
for part, name in zip(rings, ("lower ring", "upper ring"), strict=True):
    part.label = name
lamp = Compound(label="lamp", children=[*strips, *rings])

if __name__ == "__main__":
    print(strip.check)
    export_step(lamp, "lamp.step")
    ec.save(strip.strip.drawing(), "lamp-strip.dxf", force=True)
