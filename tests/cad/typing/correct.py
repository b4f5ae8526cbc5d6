"""What users of build123d write: a type checker finds no mistake."""

import elastica_cad as ec
from elastica_cad.build123d import AngleSlider, BentStrip, FlatStrip, Slider, StripOutline, elastic_strip


def correct() -> None:
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    tab = ec.Tab(12, holes=ec.Hole(6, 3.2))
    tabs = [ec.Tab(12, holes=[ec.Hole(6, 3.2)]), ec.Tab(12)]
    rib: BentStrip = elastic_strip(arch, sheet="mdf-3", max_width=20, ends=tab)
    flat: FlatStrip = elastic_strip(arch, sheet="mdf-3", max_width=20, form="flat", ends=tabs)
    face: StripOutline = elastic_strip(arch, sheet="mdf-3", max_width=20, form="outline")
    slider: Slider = rib.slider((3, 4))
    hinge: AngleSlider = rib.slider(angle=30)
    model = ec.Model([BentStrip(arch, "mdf-3", max_width=20, color="red").placed for _ in range(3)])
    rod = ec.optimal_rod(arch, between=ec.Pin(40))
    strips = [
        ec.Strip(rod, "mdf-3", max_width=20, ends=tab, slots=ec.Slot(40, 1.2)),
        ec.Strip(rod, ec.Sheet.named("mdf-3"), max_width=20, ends=tabs, slots=[ec.Slot(40, 1.2)]),
        ec.make_strip(arch, "mdf-3", max_width=20, ends=tabs, loads=ec.PointMass(40, 3)),
        ec.StripSpec(arch, "mdf-3", max_width=20, ends=tab, slots=ec.Slot(40, 1.2)).make(),
    ]
    thickness: float = strips[0].sheet.thickness
    hole: ec.Hole = tab.holes[0]
    first: ec.Placed = model.placed[0]
    print(flat, face, slider, hinge, model, thickness, hole, first)
