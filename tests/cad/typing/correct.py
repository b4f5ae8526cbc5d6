"""What users of build123d write: a type checker finds no mistake."""

from pathlib import Path

import build123d as bd
import cadquery as cq

import elastica_cad as ec
from elastica_cad.build123d import (
    AngleSlider,
    BentStrip,
    Elastica,
    FlatStrip,
    Slider,
    StripOutline,
    elastic_strip,
)
from elastica_cad.cadquery import StripCompound, StripSolid, bent_strip


def correct() -> None:
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    tab = ec.Tab(12, holes=ec.Hole(6, 3.2))
    tabs = [ec.Tab(12, holes=[ec.Hole(6, 3.2)]), ec.Tab(12)]
    rib: BentStrip = elastic_strip(arch, sheet="mdf-3", max_width=20, ends=tab)
    flat: FlatStrip = elastic_strip(arch, sheet="mdf-3", max_width=20, form="flat", ends=tabs)
    face: StripOutline = elastic_strip(arch, sheet="mdf-3", max_width=20, form="outline")
    slider: Slider = rib.slider((3, 4))
    rib = elastic_strip(arch, "mdf-3", max_width=20)
    line = Elastica((0, 0, 5), length=100, angles=(30, None))
    rib = rib.bent(end=bd.Location((100, 0, 0)))
    saved: Path = ec.save(rib, "rib.step", force=True)
    solid: StripSolid | StripCompound = bent_strip(arch, "mdf-3", max_width=20)
    moved: StripSolid | StripCompound = solid.moved(cq.Location((1, 2, 3))).mirror("YZ").moved(x=3)
    print(line, saved, moved, solid.hole_face("hole1_top"))
    hinge: AngleSlider = rib.slider(angle=30)
    model = ec.Model([BentStrip(arch, "mdf-3", max_width=20, color="red").placed for _ in range(3)])
    rib = elastic_strip(arch, sheet="mdf-3", max_width=20, loads=ec.PointMass(40, 3), between=ec.Pin(40))
    rib = elastic_strip(
        arch, sheet="mdf-3", max_width=20, loads=[ec.PointMass(40, 3), ec.PointForce(60, (0, -1))],
        between=(ec.Pin(40), ec.Rail(60), ec.Tie(10, 80)),
    )  # fmt: skip
    spec = ec.StripSpec(arch, "mdf-3", max_width=20, loads=[ec.PointMass(40, 3)], between=[ec.Pin(40)])
    alone = ec.StripSpec(arch, "mdf-3", max_width=20, loads=ec.PointForce(40, (0, -1)), between=ec.Rail(40))
    both: tuple[ec.Rail | ec.Pin | ec.Tie, ...] = spec.between + alone.between
    rod = ec.optimal_rod(arch, between=both)
    strips = [
        ec.Strip(rod, "mdf-3", max_width=20, ends=tab, slots=ec.Slot(40, 1.2)),
        ec.Strip(rod, ec.Sheet.named("mdf-3"), max_width=20, ends=tabs, slots=[ec.Slot(40, 1.2)]),
        ec.make_strip(arch, "mdf-3", max_width=20, ends=tabs, loads=ec.PointMass(40, 3)),
        ec.StripSpec(arch, "mdf-3", max_width=20, ends=tab, slots=ec.Slot(40, 1.2)).make(),
    ]
    thickness: float = strips[0].sheet.thickness
    hole: ec.Hole = tab.holes[0]
    first: ec.Placed = model.placed[0]
    print(rib, flat, face, slider, hinge, model, thickness, hole, first)
