# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What is selected, and which sketch is open."""

from collections.abc import Iterable, Sequence
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import Part
from freecad.elastica_wb.curves.copies import COPYING, contents, not_repeated, originals
from freecad.elastica_wb.curves.sketch_curves import (
    edge_called,
    is_edge,
    is_outline,
    is_sketch,
    linked,
    picked,
)
from freecad.elastica_wb.features.baseplate import is_base_plate
from freecad.elastica_wb.features.curves import is_section
from freecad.elastica_wb.features.flat import is_flat
from freecad.elastica_wb.features.pieces import cut_for, is_cut
from freecad.elastica_wb.features.strip import BODY, is_strip
from freecad.elastica_wb.host.lifetime import is_ours
from freecad.elastica_wb.host.refusal import is_broken_link
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live.sketches import edited_sketch, followers

from elastica_cad.errors import InputError

JOIN_MM = 1e-4  # as edges are joined that a strip follows
LINE = "Part::GeomLine"
OPEN = ("Edge", "Wire", "Compound")  # kinds of shapes that may be a curve


def chosen_curves() -> list[tuple[Any, tuple[str, ...]]]:
    """The selected sketches and chains of edges, each with the names of its edges; a body stands for its sketch.

    Raises
    ------
    InputError
        Nothing of that kind is selected, or a body in which it is not clear which sketch is meant.
    """
    found: list[tuple[Any, tuple[str, ...]]] = []
    meant = _picked()
    for source, names in meant.items():
        edges = tuple(filter(is_edge, names))
        if is_sketch(linked(source)):
            found.append((source, ()))
        elif edges:
            found += [(source, chain) for chain in _chains(source, edges)]
        elif source.TypeId == BODY and not any(one in source.Group for one in meant):
            found.append((_sketch_in(source), ()))
        elif hasattr(source, "Shape") and _has_curves(source.Shape):
            chains = _chains(source, [f"Edge{i + 1}" for i in range(len(source.Shape.Edges))])
            found += [(source, chain) for chain in chains] if len(chains) > 1 else [(source, ())]
    if not found:
        found = [(sketch, ()) for sketch in (edited_sketch() or _only_sketch(),) if sketch is not None]
    if not found:
        raise InputError(
            translate("Elastica", "Select a sketch with a spline, or an edge of an object, first.")
        )
    if _are_pieces(found):
        raise InputError(
            translate(
                "Elastica",
                "The selected lines are pieces of a polyline, as FreeCAD reads it from a file: draw a "
                "B-spline through their ends (workbench Draft) and select that.",
            )
        )
    return found


def _picked() -> dict[Any, list[str]]:
    """What is selected, and which parts of it; through links these are parts of the link."""
    found: dict[Any, list[str]] = {}
    for choice in Gui.Selection.getSelectionEx("", 0):
        for path in choice.SubElementNames or ("",):
            source, name = picked(choice.Object, path)
            found.setdefault(source, []).append(name)
    return found


def _sketch_in(body: Any) -> Any:
    """The sketch in a body of which nothing is made: no feature of the body, and where one is left, no strip."""
    drawn = [one for one in body.Group if is_sketch(one)]
    users = {one: [user for user in one.InList if user is not body] for one in drawn}
    ours = [one for one in drawn if all(map(is_ours, users[one]))]
    found = [one for one in ours if not users[one]] or ours
    if not found:
        raise InputError(
            "{body} holds no sketch for a strip: draw a spline in a sketch of its own, or select "
            "the edge that the strip is to follow",
            body=body.Label,
        )
    if len(found) > 1:
        names = ", ".join(one.Label for one in found)
        raise InputError(
            "{body} holds several sketches ({names}): select the one that the strip is to follow",
            body=body.Label,
            names=names,
        )
    return found[0]


def _are_pieces(curves: Sequence[tuple[Any, tuple[str, ...]]]) -> bool:
    """Are they straight edges of different objects, some of which meet in a row of three or more?"""
    shapes = [source.Shape for source, names in curves if not names and not is_sketch(source)]
    lines = [shape.Edges[0] for shape in shapes if [e.Curve.TypeId for e in shape.Edges] == [LINE]]
    if not 3 <= len(lines) == len(curves):
        return False
    return any(len(row) > 2 for row in Part.sortEdges(lines))


def _chains(source: Any, names: Sequence[str]) -> list[tuple[str, ...]]:
    """Names of edges, those together that touch each other; sections are curves that were divided on purpose."""
    if is_section(source):
        return [(name,) for name in names]
    chains: list[tuple[list[str], list[Any]]] = []
    for name in names:
        places = [vertex.Point for vertex in edge_called(source, name).Vertexes]
        chain: tuple[list[str], list[Any]] = ([name], places)
        for other in [one for one in chains if any(p.isEqual(q, JOIN_MM) for p in places for q in one[1])]:
            chains.remove(other)
            chain = (other[0] + chain[0], other[1] + chain[1])
        chains.append(chain)
    return [tuple(chain) for chain, _ in chains]


def _has_curves(shape: Any) -> bool:
    return bool(shape.Edges) and (not shape.Faces or is_outline(shape))


def is_curve_chosen() -> bool:
    """Tell whether `chosen_curves` could answer, without computing shapes."""
    if edited_sketch() is not None or _only_sketch() is not None:
        return True
    return any(
        is_sketch(choice.Object)
        or choice.Object.TypeId == BODY
        or any(name.startswith("Edge") for name in choice.SubElementNames)
        or is_sketch(linked(choice.Object))
        or (linked(choice.Object).isDerivedFrom("Part::Feature") and _may_be_open(choice.Object.Shape))
        for choice in Gui.Selection.getSelectionEx()
    )


def _may_be_open(shape: Any) -> bool:
    return not shape.isNull() and (
        shape.ShapeType in OPEN or (shape.ShapeType == "Face" and is_outline(shape))
    )


def _only_sketch() -> Any:
    """With nothing selected, the only sketch of the document that no strip follows yet."""
    if Gui.Selection.hasSelection() or App.ActiveDocument is None:
        return None
    free = [obj for obj in App.ActiveDocument.findObjects("Sketcher::SketchObject") if not followers(obj)]
    return free[0] if len(free) == 1 else None


def chosen_sketch() -> Any:
    """Return the selected sketch, or the one in edit.

    Raises
    ------
    InputError
        Something else is selected, or nothing.
    """
    (source, edges), *_ = chosen_curves()
    sketch = linked(source)
    if edges or not is_sketch(sketch):
        raise InputError(translate("Elastica", "Select a sketch with a spline first."))
    return sketch


def chosen_sources() -> list[Any]:
    """The selected strips, models and base plates, and what shows them; where none is selected, the document's.

    A flat part with the slots of a model stands for the model: its strip alone has none. Links, arrays and clones
    stand for themselves, with all that they show; containers stand for what is in them.

    Raises
    ------
    InputError
        Nothing of that kind; nothing is selected, and it is not clear which strips are meant.
    """
    found = _sources(one for obj in Gui.Selection.getSelection() for one in contents(obj))
    return found or _all_sources() or chosen_strips()


def _sources(objects: Iterable[Any]) -> list[Any]:
    """What among objects is cut or shows what is cut, each once."""
    meant = dict.fromkeys(filter(None, map(cut_for, objects)))
    return not_repeated(one for one in meant if any(_may_be_cut(own) for own in originals(one)))


def _may_be_cut(obj: Any) -> bool:
    """Is it cut, or a broken link? That is not left out in silence: who asks for its pieces is told."""
    return is_cut(cut_for(obj)) or is_broken_link(obj)


def _all_sources() -> list[Any]:
    """The models and base plates of the document with the strips that stand on these; else its only strip."""
    objects = App.ActiveDocument.Objects
    found = _sources(
        obj for obj in objects if _may_show(obj) and contents(obj) == [obj] and not is_broken_link(obj)
    )
    made = [one for one in found if not all(is_strip(cut_for(own)) for own in originals(one))]
    if made:
        held = [one for plate in made if is_base_plate(plate) for one in plate.Sources]
        return list(dict.fromkeys([*made, *held]))
    strips = {cut_for(own) for one in found for own in originals(one)}
    return found if len(strips) == 1 else []


def _may_show(obj: Any) -> bool:
    """Could what is cut be seen in it? A quick look: ours and Draft's are made in Python."""
    return obj.TypeId in COPYING or hasattr(obj, "Proxy")


def chosen_strips(*, least: int = 1) -> list[Any]:
    """The selected strips, through their flat parts and all that shows them; the only one of a document by itself.

    Raises
    ------
    InputError
        Fewer than `least` of them.
    """
    shown = [own for obj in Gui.Selection.getSelection() for own in originals(obj)]
    strips = [one.Strip if is_flat(one) else one for one in shown]
    found = list(dict.fromkeys(one for one in strips if is_strip(one)))
    everything = [obj for obj in App.ActiveDocument.Objects if is_strip(obj)]
    if not found and least == 1 and len(everything) == 1:
        found = everything
    if len(found) < least:
        wanted = (
            translate("Elastica", "Select a strip first.")
            if least == 1
            else translate("Elastica", "Select two strips or more first.")
        )
        raise InputError(wanted)
    return found
