"""What users of build123d get wrong: a type checker finds each line with a mistake, and no other."""

import build123d as bd

from elastica_cad import Slot, Tab
from elastica_cad.build123d import BentStrip, Elastica, EndFixture, FlatStrip, StripOutline, elastic_strip


def mistakes() -> None:
    arch = bd.Edge.make_bezier((0, 0), (60, 100), (120, 0))
    good = BentStrip(arch, "mdf-3", max_width=20, ends=Tab(5), slots=Slot(40, 1.2, 4))
    flat: FlatStrip = good.flat
    rib: BentStrip = elastic_strip(arch, sheet="mdf-3", max_width=20, form="bent")
    BentStrip(arch, "mdf-3", max_widht=20)  # mistake
    BentStrip(arch, 3.0, max_width=20)  # mistake
    FlatStrip(arch, "mdf-3", max_width="20")  # mistake
    StripOutline(arch, "mdf-3", slot=3)  # mistake
    BentStrip(arch, "mdf-3", ends=5)  # mistake
    elastic_strip(arch, sheet="mdf-3", form="rolled")  # mistake
    EndFixture(arch, "mdf-3", end="left")  # mistake
    good.fixtur("start")  # mistake, by pyright only
    good.fixture("start", wal=3)  # mistake
    good.slider(end=(3, 4), angle=30)  # mistake
    elastic_strip(arch, sheet="mdf-3", between=40)  # mistake
    Elastica((0, 0), (70, 0), "100")  # mistake
    print(flat, rib)
