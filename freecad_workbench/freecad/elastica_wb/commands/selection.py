# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Functions that return the selected curves, sketches and strips, and the open sketch."""

from collections.abc import Iterable, Sequence
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import Part
from freecad.elastica_wb.curves.copies import COPYING, contents, not_repeated, originals
from freecad.elastica_wb.curves.edge_chains import chains_of, curves_in, edges_drawn
from freecad.elastica_wb.curves.sketch_curves import is_edge, is_outline, linked, picked
from freecad.elastica_wb.features.pieces import cut_for, is_cut
from freecad.elastica_wb.features.strip import BODY
from freecad.elastica_wb.host.objects import (
    feature_kind,
    is_flat,
    is_ours,
    is_plate,
    is_sketch,
    is_strip,
)
from freecad.elastica_wb.host.refusal import is_broken_link
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live.sketches import edited_sketch, followers

from elastica_cad.errors import InputError

LINE = "Part::GeomLine"
OPEN = ("Edge", "Wire", "Compound")


def chosen_curves() -> list[tuple[Any, tuple[str, ...]]]:
    """Return the selected sketches and chains of edges, each with the names of its edges.

    If a body is selected, its sketch is returned.
    """
    curves: list[tuple[Any, tuple[str, ...]]] = []
    meant = _picked()
    for source, names in meant.items():
        edges = list(filter(is_edge, names))
        if is_sketch(linked(source)):
            curves += _curves_of_sketch(source, edges)
        elif edges:
            curves += [(source, chain) for chain in _chains(source, edges)]
        elif source.TypeId == BODY and not any(obj in source.Group for obj in meant):
            curves += _curves_of_sketch(_only_sketch_in(source))
        elif (
            hasattr(source, "Shape")
            and source.Shape.Edges
            and (not source.Shape.Faces or is_outline(source.Shape))
        ):
            chains = _chains(source, [f"Edge{i + 1}" for i in range(len(source.Shape.Edges))])
            curves += [(source, chain) for chain in chains] if len(chains) > 1 else [(source, ())]
    if not curves:
        sketch = edited_sketch() or _only_sketch()
        curves = [] if sketch is None else _curves_of_sketch(sketch)
    if not curves:
        raise InputError(
            translate("Elastica", "Select a sketch with a spline, or an edge of an object, first.")
        )
    if _are_pieces(curves):
        raise InputError(
            translate(
                "Elastica",
                "The selected lines are pieces of a polyline, as FreeCAD reads it from a file: draw a "
                "B-spline through their ends (workbench Draft) and select that.",
            )
        )
    return curves


def _picked() -> dict[Any, list[str]]:
    names: dict[Any, list[str]] = {}
    for choice in Gui.Selection.getSelectionEx("", 0):
        for path in choice.SubElementNames or ("",):
            source, name = picked(choice.Object, path)
            names.setdefault(source, []).append(name)
    return names


def _curves_of_sketch(sketch: Any, picked: Sequence[str] = ()) -> list[tuple[Any, tuple[str, ...]]]:
    if edited_sketch() is sketch:
        picked = edges_drawn(sketch, picked)
    return [(sketch, chain) for chain in curves_in(sketch, picked) or [()]]


def _only_sketch_in(body: Any) -> Any:
    """Return the only sketch in a body that no object except the body uses.

    If there is none, return the only sketch that no object uses except the body and features of this
    workbench.
    """
    sketches = [sketch for sketch in body.Group if is_sketch(sketch)]
    users = {sketch: [user for user in sketch.InList if user is not body] for sketch in sketches}
    ours = [sketch for sketch in sketches if all(map(is_ours, users[sketch]))]
    candidates = [sketch for sketch in ours if not users[sketch]] or ours
    if not candidates:
        raise InputError(
            "{body} has no sketch for a strip. Draw a spline in a separate sketch, or select the edge for "
            "the strip.",
            body=body.Label,
        )
    if len(candidates) > 1:
        names = ", ".join(sketch.Label for sketch in candidates)
        raise InputError(
            "{body} has several sketches ({names}). Select the sketch for the strip.",
            body=body.Label,
            names=names,
        )
    return candidates[0]


def _are_pieces(curves: Sequence[tuple[Any, tuple[str, ...]]]) -> bool:
    """Return True for three or more straight edges of different objects, connected end to end."""
    shapes = [source.Shape for source, names in curves if not names and not is_sketch(source)]
    lines = [shape.Edges[0] for shape in shapes if [e.Curve.TypeId for e in shape.Edges] == [LINE]]
    if not 3 <= len(lines) == len(curves):
        return False
    return any(len(row) > 2 for row in Part.sortEdges(lines))


def _chains(source: Any, names: Sequence[str]) -> list[tuple[str, ...]]:
    if feature_kind(source) == "Section":
        return [(name,) for name in names]
    return chains_of(source, names)


def is_curve_chosen() -> bool:
    """Return True if `chosen_curves` probably succeeds, without computing shapes, which is slow."""
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
    if Gui.Selection.hasSelection() or App.ActiveDocument is None:
        return None
    free = [obj for obj in App.ActiveDocument.findObjects("Sketcher::SketchObject") if not followers(obj)]
    return free[0] if len(free) == 1 else None


def chosen_sketch() -> Any:
    """Return the selected sketch or the open sketch."""
    (source, _), *_ = chosen_curves()
    sketch = linked(source)
    if not is_sketch(sketch):
        raise InputError(translate("Elastica", "Select a sketch with a spline first."))
    return sketch


def chosen_sources() -> list[Any]:
    """Return the selected strips, models, plates, two-state parts and copies.

    If none of these is selected, return those of the whole document. A selected container
    selects its contents. A selected flat part selects every object of the document that displays its strip,
    or its model if it has slots, because all of these are cut from it.
    """
    chosen = [content for obj in Gui.Selection.getSelection() for content in contents(obj)]
    patterns = {cut_for(obj) for obj in chosen if is_flat(obj)}
    if patterns:
        chosen += [obj for obj in _shown() if patterns & set(map(cut_for, originals(obj)))]
    return _sources(chosen) or _all_sources() or chosen_strips()


def _sources(objects: Iterable[Any]) -> list[Any]:
    meant = dict.fromkeys(filter(None, map(cut_for, objects)))
    return not_repeated(
        obj
        for obj in meant
        if any(is_cut(cut_for(original)) or is_broken_link(original) for original in originals(obj))
    )


def _all_sources() -> list[Any]:
    """Return the models, plates, two-state parts and strips on plates of the document.

    If there are none, return all strips.
    """
    sources = _sources(_shown())
    assemblies = [
        source for source in sources if not all(is_strip(cut_for(original)) for original in originals(source))
    ]
    if assemblies:
        strips_on_plates = [source for plate in assemblies if is_plate(plate) for source in plate.Sources]
        return list(dict.fromkeys([*assemblies, *strips_on_plates]))
    return sources


def _shown() -> list[Any]:
    """Return the objects of the document that may display strips, models or plates, without containers."""
    objects = (obj for obj in App.ActiveDocument.Objects if obj.TypeId in COPYING or hasattr(obj, "Proxy"))
    return [obj for obj in objects if contents(obj) == [obj] and not is_broken_link(obj)]


def chosen_strips(*, least: int = 1) -> list[Any]:
    """Return the selected strips, or the only strip of the document.

    For a selected flat part or copy, return its strip.
    """
    shapes = [shape for obj in Gui.Selection.getSelection() for shape in originals(obj)]
    strips = [original.Strip if is_flat(original) else original for original in shapes]
    chosen = list(dict.fromkeys(original for original in strips if is_strip(original)))
    everything = [obj for obj in App.ActiveDocument.Objects if is_strip(obj)]
    if not chosen and least == 1 and len(everything) == 1:
        chosen = everything
    if len(chosen) < least:
        message = (
            translate("Elastica", "Select a strip first.")
            if least == 1
            else translate("Elastica", "Select two strips or more first.")
        )
        raise InputError(message)
    return chosen


def chosen_strip() -> Any:
    """Return the first of the selected strips, or the only strip of the document."""
    return chosen_strips()[0]
