"""Arrays and clones of Draft, made of strips and flat parts, go to the cutter by the buttons."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import Draft
import FreeCAD as App
from inside import (
    ARCH,
    OUT,
    answers,
    at_rest,
    begun,
    button,
    choose,
    fill,
    fit,
    is_grey,
    open_panel,
    panel,
    picture,
    press,
    run,
    shown_message,
    sketch,
    typed,
    until,
    window,
)

STEP = App.Vector(0, 60, 0)


def array(base, count=6, **options):
    made = Draft.make_ortho_array(base, App.Vector(), STEP, App.Vector(), 1, count, 1, **options)
    base.Document.recompute()
    return made


def exported(*things):
    """How often each piece is cut, as the panel of the export says."""
    open_panel("Elastica_Export", *things)
    counts = {piece.name: piece.count for piece in panel().pieces}
    button("Cancel")
    return counts


def followed(document, strip):
    """What the panel of the export says of a strip that a box is cut from; a picture of it."""
    cut, box = document.addObject("Part::Cut", "Cut"), document.addObject("Part::Box", "Box")
    cut.Base, cut.Tool = strip, box
    document.recompute()
    open_panel("Elastica_Export", strip)
    text = panel().form.message.text()
    picture("followed.png")
    button("Cancel")
    for one in (cut, box):
        document.removeObject(one.Name)
    strip.ViewObject.Visibility = True
    document.recompute()
    return text


def outlines(nest):
    return sum(100 < wire.BoundBox.XLength < 500 for wire in nest.Shape.Wires)


def nested(document, *things):
    before = set(document.Objects)
    choose(*things)
    press("Elastica_Nest")
    until(lambda: set(document.Objects) - before)
    (made,) = set(document.Objects) - before
    return made


def held(document, shown, tabs):
    """Blocks of what shows strips: one for each tab, each about corners of a strip, with room for it."""
    before = set(document.Objects)
    open_panel("Elastica_Fixtures", shown)
    button()
    (blocks,) = set(document.Objects) - before
    solids = shown.Shape.Solids
    corners = [corner.Point for corner in shown.Shape.Vertexes]
    about = [any(map(block.BoundBox.isInside, corners)) for block in blocks.Shape.Solids]
    shared = sum(one.common(blocks.Shape).Volume for one in solids)
    document.removeObject(blocks.Name)
    # pockets lean for tabs that bend; straight ones, of some 150 mm3, run into them a little
    return [len(about) == tabs, all(about), shared < 15 * tabs]


def work():
    window()
    document = begun("Copies")
    drawn = sketch(document, ARCH)
    drawn.Placement = App.Placement(App.Vector(0, -100, 0), App.Rotation(App.Vector(1, 0, 0), 90))
    document.recompute()
    open_panel("Elastica_Strip", drawn)
    typed("MaxWidth", "20 mm")
    button()
    strip, flat = document.getObject("Strip"), document.getObject("Flat")
    answers["followed"] = followed(document, strip)
    row = array(strip)
    choose(row)
    answers["grey for an array"] = [
        is_grey(f"Elastica_{name}") for name in ("Export", "Nest", "Fixtures", "Bend")
    ]
    answers["array"] = exported(row)
    answers["everything"] = exported()
    answers["array with its base"] = exported(strip, row)
    nest = nested(document, row)
    laid = [outlines(nest)]
    row.NumberY = 2
    document.recompute()
    answers["laid"] = [*laid, outlines(nest)]
    row.ExpandArray = True
    document.recompute()
    answers["one of an array"] = exported(row.ElementList[1])
    answers["held"] = held(document, row, 4)
    shapes = array(strip, 3, use_link=False)
    shapes.Placement = App.Placement(App.Vector(300, 0, 5), App.Rotation(App.Vector(0, 0, 1), 30))
    document.recompute()
    answers["array of shapes"] = exported(shapes)
    answers["shapes held"] = held(document, shapes, 6)
    clone = Draft.make_clone(strip)
    clone.Placement = App.Placement(App.Vector(0, 300, 305), App.Rotation(App.Vector(1, 0, 0), 90))
    both = Draft.make_clone([strip, flat])
    document.recompute()
    answers["clones"] = [exported(clone), exported(strip, clone, both)]
    answers["clone held"] = held(document, clone, 2)
    open_panel("Elastica_Fixtures", clone)
    fill(panel(), blocks=False, plate=True)
    typed("plateHeight", "303 mm")
    button()
    plate = document.getObject("BasePlate")
    open_panel("Elastica_Fixtures", plate)
    button()
    answers["held by a plate"] = len(document.getObject("Fixtures").Shape.Solids)
    image = Draft.mirror(strip, App.Vector(-50, 0, 0), App.Vector(-50, 1, 0))
    document.recompute()
    choose(image)
    answers["grey for an image"] = is_grey("Elastica_Export")
    answers["image"] = [image.TypeId, exported(image), exported(strip, image), held(document, image, 2)]
    lying = array(flat, 5)
    answers["flat parts"] = [exported(lying), exported(strip, lying)]
    fit("Isometric")
    picture("copies.png")
    closed = Draft.make_circle(60, App.Placement(App.Vector(0, -400, 0), App.Rotation()), face=True)
    document.recompute()
    choose(closed)
    answers["grey for a face"] = is_grey("Elastica_Strip")
    file = str(OUT / "copies.FCStd")
    document.saveAs(file)
    names = [one.Name for one in (row, shapes, clone)]
    App.closeDocument(document.Name)
    again = App.openDocument(file)
    answers["opened again"] = [exported(again.getObject(name)) for name in names]
    clone = again.getObject(names[2])
    clone.Scale = App.Vector(2, 2, 2)
    again.recompute()
    choose(clone)
    press("Elastica_Export")
    at_rest()
    answers["scaled"] = shown_message()


run(work)
