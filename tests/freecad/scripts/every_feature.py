"""Writes a document with every kind of feature: how data/every-feature-0.1.FCStd was made (in 0.20)."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import ARCH, OUT, answers, run, sketch, wait

WAVE = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
STATES = {
    "Up": [(15, 75), (57, 75), (87, 102), (126, 102), (162, 102), (201, 75), (240, 75)],
    "Down": [(15, 51), (51, 51), (81, 27), (120, 27), (162, 27), (204, 51), (240, 51)],
}
STAND = App.Rotation(App.Vector(1, 0, 0), 90)


def placed(document, points, x=0.0, y=0.0, name="Sketch"):
    made = sketch(document, points, name=name)
    made.Placement = App.Placement(App.Vector(x, y, 0), STAND)
    return made


def work():
    from freecad.elastica_wb.features import baseplate, curves, fixtures, flat, flexure, model, nest, strip

    document = App.newDocument("Every")
    plain = strip.create(document, placed(document, ARCH))
    plain.EngravedText, plain.MaxWidth = "A1", 24
    holes = strip.create(document, placed(document, ARCH, y=80, name="SketchHoles"))
    holes.Style, holes.OuterWidth = "Perforated", 28
    layers = strip.create(document, placed(document, ARCH, y=160, name="SketchLayers"))
    layers.Style, layers.OuterWidth, layers.Sheet, layers.Backing = "Laminated", 28, "pom-0.5", "pom-0.5"
    bad = [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)]
    near = strip.create(document, sketch(document, bad, name="SketchNear"))
    near.Follow, near.StrainLimit, near.Anyway = "Nearest", 5, True
    first = strip.create(document, sketch(document, [(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)]))
    second = strip.create(document, sketch(document, [(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)]))
    for label, crossing in zip("BC", (first, second), strict=True):
        crossing.Curve[0].Placement.Base.x = 400
        crossing.EngravedText, crossing.MaxWidth = label, 16
    document.recompute()
    part = document.addObject("App::Part", "Part")
    inner = sketch(document, ARCH, name="SketchPart")
    part.addObject(inner)
    part.Placement.Base = App.Vector(0, 300, 0)
    strip.create(document, inner)
    body = document.addObject("PartDesign::Body", "Body")
    drawn = sketch(document, ARCH, name="SketchBody")
    body.addObject(drawn)
    body.Placement.Base = App.Vector(0, 400, 0)
    strip.create(document, drawn).Between = ["at = 60"]
    whole = model.create(document, [first, second])
    flat.create(document, plain)
    flat.create(document, layers, "Backing")
    flat.create(document, first).Model = whole
    fixtures.create(document, [whole])
    plate = baseplate.create(document, [plain])
    plate.Placement.Base.z = -2
    nest.create(document, [whole, plain, holes])
    baseplate.create_rings(document, [plain])
    curves.nearest(document, near.Curve[0]).StrainLimit = 5
    curves.bent(document, plain, EndX=-5.0)
    document.recompute()
    curves.section(document, [plate]).Closed = "left and right"
    held = strip.create(document, sketch(document, WAVE, degree=5, name="SketchHeld"))
    held.Between = ['kind = "pin", at = 200', 'kind = "tie", start = 40.5, end = 310']
    held.Gravity, held.GravityDirection = True, (0, -1, 0)
    held.Loads = ["at = 150, force = [0, -0.2]", "at = 90, mass = 3"]
    states = [sketch(document, points, degree=3, name=f"Sketch{name}") for name, points in STATES.items()]
    flexure.create(document, states[0], (), states[1], ())
    document.recompute()
    wait(300)
    wrong = [(o.Name, o.getStatusString()) for o in document.Objects if "Invalid" in o.State]
    assert not wrong, wrong
    answers["kinds"] = sorted({type(o.Proxy).__name__ for o in document.Objects if getattr(o, "Proxy", None)})
    document.saveAs(str(OUT / "every-feature.FCStd"))
    Gui.activateWorkbench("PartWorkbench")


run(work)
