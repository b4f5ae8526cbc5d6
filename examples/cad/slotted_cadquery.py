"""A sketched spline becomes a strip with slots, with methods of CadQuery's Workplane.

Run it to get slotted.step and slotted.dxf.
"""

import cadquery as cq

import elastica_cad as ec
from elastica_cad.cadquery import Workplane

SHEET = ec.Sheet.named("birch-plywood-0.8")
POINTS, TANGENTS = [(0, 0), (95, 65), (210, 0)], [(0.7, 1), (0.9, -1)]
STATIONS = (50, 95, 140, 185)  # mm along the strip
OPTIONS = {
    "max_width": 40,
    "slots": tuple(ec.Slot(at=s, width=SHEET.thickness + 0.1, relief="round") for s in STATIONS),
    "label": "rib 1",
}

bent = Workplane("XZ").spline(POINTS, tangents=TANGENTS).elasticStrip(SHEET, **OPTIONS)
flat = (
    Workplane("XY", origin=(0, -60, 0))
    .spline(POINTS, tangents=TANGENTS)
    .elasticStrip(SHEET, form="flat", **OPTIONS)
)
rib = bent.val()

wood = cq.Color(0.85, 0.70, 0.48)
both = cq.Assembly(name="rib_1").add(bent, name="bent", color=wood).add(flat, name="flat", color=wood)

if __name__ == "__main__":
    print(rib.check)
    both.export("slotted.step")
    ec.save(rib.strip.drawing(), "slotted.dxf", force=True)
