"""A sketched spline becomes a strip with slots, in build123d's builder mode.

Run it to get slotted.step and slotted.dxf.
"""

from build123d import BuildLine, BuildPart, Compound, Plane, Pos, Spline, export_step

import elastica_cad as ec
from elastica_cad.build123d import elastic_strip

SHEET = ec.Sheet.named("birch-plywood-0.8")
POINTS, TANGENTS = [(0, 0), (95, 65), (210, 0)], [(0.7, 1), (0.9, -1)]
STATIONS = (50, 95, 140, 185)  # mm along the strip
OPTIONS = {
    "sheet": SHEET,
    "max_width": 40,
    "slots": tuple(ec.Slot(at=s, width=SHEET.thickness + 0.1, relief="round") for s in STATIONS),
    "label": "rib 1",
}

with BuildPart() as bent:
    with BuildLine(Plane.XZ):
        Spline(*POINTS, tangents=TANGENTS)
    rib = elastic_strip(**OPTIONS)

with BuildPart() as flat:
    with BuildLine():
        Spline(*POINTS, tangents=TANGENTS)
    pattern = elastic_strip(form="flat", **OPTIONS)

bent.part.label, flat.part.label = "rib 1 bent", "rib 1 flat"
both = Compound(label="rib 1", children=[bent.part, Pos(0, -60, 0) * flat.part])

if __name__ == "__main__":
    print(rib.check)
    export_step(both, "slotted.step")
    ec.save(pattern.strip.drawing(), "slotted.dxf", force=True)
