# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Functions that the commands run on the selected objects."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb import make_strip
from freecad.elastica_wb.commands.selection import (
    chosen_curves,
    chosen_sources,
    chosen_strips,
    is_curve_chosen,
)
from freecad.elastica_wb.curves.plane_sections import chosen_bodies, is_path
from freecad.elastica_wb.features import curves, flat, flexure, model, nest
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.dialogs import show_message
from freecad.elastica_wb.host.refusal import why_not_made
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live import observers
from freecad.elastica_wb.live.sketches import edited_sketch
from freecad.elastica_wb.panels.check import CheckPanel
from freecad.elastica_wb.panels.feature_panels import panel_of
from freecad.elastica_wb.recording import record_recompute, record_value, recorded
from freecad.elastica_wb.undo_steps import close_step, open_step, open_step_and

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.pairs.flexure import STATES


def has_curve() -> bool:
    """Return True if a curve is selected, or a sketch is open."""
    return App.ActiveDocument is not None and is_curve_chosen()


def answers(question: Callable[..., Any], **options: Any) -> bool:
    """Return True if the function `question` returns a true value without an error."""
    with suppress(ElasticaError):
        return App.ActiveDocument is not None and bool(question(**options))
    return False


def show_panel(make: Callable[..., Any], *arguments: Any) -> None:
    """Close the open sketch, then open the panel that `make(*arguments)` returns."""
    _close_sketch()
    Gui.Control.showDialog(make(*arguments))


def open_on(panel: Callable[[Any], Any], choose: Callable[[], Any]) -> None:
    """Open a panel on the objects that `choose` returns."""
    show_panel(panel, choose())


def _close_sketch() -> None:
    if edited_sketch() is not None:
        Gui.ActiveDocument.resetEdit()


def _begin_step(name: str) -> None:
    if (sketch := edited_sketch()) is not None:
        # FreeCAD hides an open sketch, which must be visible after an undo
        sketch.Visibility = True
    open_step_and(_close_sketch, App.ActiveDocument, name)


def _make_and_edit(step: str, make: Callable[..., Any], *arguments: Any) -> None:
    _begin_step(step)
    feature = recorded(make, App.ActiveDocument, *arguments)
    record_recompute(App.ActiveDocument)
    show_panel(panel_of, feature)


def check() -> None:
    """Start live feedback in an open sketch. If none is open, open a panel with the full result."""
    selected = chosen_curves()
    if edited_sketch() is selected[0][0]:
        observers.switch(edited_sketch(), on=True)
        return
    show_panel(CheckPanel, selected)


def make_nearest() -> None:
    """Find the strip curve that is nearest to the selected curve, and open its panel."""
    (source, edges), *further = chosen_curves()
    if further:
        raise InputError("{count} curves are selected. Select one edge of one curve.", count=1 + len(further))
    _make_and_edit("Nearest curve to sketch", curves.nearest, source, edges)


def make_flexure() -> None:
    """Make a two-state part from the two selected curves, and open its panel."""
    selected = chosen_curves()
    if len(selected) != len(STATES):
        raise InputError(
            "A part with two states needs two curves; number of selected curves: {count}. Select two sketches.",
            count=len(selected),
        )
    (first, first_edges), (second, second_edges) = selected
    _make_and_edit("Two-state part", flexure.create, first, first_edges, second, second_edges)
    for source in (first, second):
        source.Visibility = True


def make_sections() -> None:
    """Cut a body or a mesh by planes, make curves for strips from the sections, and open their panel."""
    _make_and_edit("Section into curves", curves.section, *bodies_and_path())


def bodies_and_path() -> tuple[list[Any], Any]:
    """Return the bodies to be cut, and the path of the planes: a selected sketch, wire or chain of edges."""
    paths, bodies = [], []
    for choice in Gui.Selection.getSelectionEx():
        edges = tuple(name for name in choice.SubElementNames if name.startswith("Edge"))
        if edges or is_path(choice.Object):
            paths.append((choice.Object, edges))
        else:
            bodies.append(choice.Object)
    if not bodies:  # selecting edges of a path also selects their body
        bodies = [obj for obj, edges in paths if edges]
    return chosen_bodies(bodies), paths[0] if paths else None


def make_strips() -> None:
    """Make a bent strip and its flat part for every selected curve, and open one panel for all strips."""
    selected = chosen_curves()
    _begin_step("Strip from sketch")
    strips = [recorded(make_strip, source, edges, flat_part=False) for source, edges in selected]
    for strip in strips:
        _add_flat(strip)
    for source, _ in selected:
        source.Visibility = True
    show_panel(panel_of, strips[-1], strips)


def _add_flat(strip: Any, layer: str = "Base", type_id: str = flat.PART) -> None:
    recorded(flat.create, strip.Document, strip, layer, type_id)
    # give this part its shape, because the next part must not overlap it
    record_recompute(strip.Document)


def make_flat_parts(type_id: str = flat.PART) -> None:
    """Make the flat parts, or the outlines, that the selected strips lack, in one undo step."""
    missing = [(strip, layer) for strip in chosen_strips() for layer in flat.missing_layers(strip, type_id)]
    if not missing:
        raise InputError(
            translate("Elastica", "Every selected strip has its flat part.")
            if type_id == flat.PART
            else translate("Elastica", "Every selected strip has its outline.")
        )
    _begin_step("Flat part")
    for strip, layer in missing:
        _add_flat(strip, layer, type_id)
    close_step(App.ActiveDocument)


def edit_strips() -> None:
    """Open a common panel for all selected strips. Each change applies to all strips."""
    first, *further = chosen_strips()
    show_panel(panel_of, first, further)


def perforate() -> None:
    """Give the selected strips a constant width, with holes that reduce the stiffness, and open the panel."""
    strips = chosen_strips()
    _set_constant_width(strips, "Perforated", "Perforate")
    show_panel(panel_of, strips[-1], strips)


def laminate() -> None:
    """Give the selected strips a constant width, with a narrower strip glued on, and open the panel."""
    strips = chosen_strips()
    _set_constant_width(strips, "Laminated", "Laminate")
    for strip in strips:
        for layer in flat.missing_layers(strip):
            _add_flat(strip, layer)
    show_panel(panel_of, strips[-1], strips)


def _set_constant_width(strips: list[Any], style: str, step: str) -> None:
    _begin_step(step)
    usual = preferences.get("MaxWidth")
    for strip in strips:
        if strip.Style == "Plain" and strip.MaxWidth.Value and strip.OuterWidth.Value == usual:
            record_value(strip, "OuterWidth", strip.MaxWidth.Value)
        record_value(strip, "Style", style)
    record_recompute(App.ActiveDocument)


def make_model() -> None:
    """Make slots where strips cross, hide the single strips, and open the panel of the model."""
    strips = chosen_strips(least=2)
    open_step(App.ActiveDocument, "Interlock selected strips")
    feature = recorded(model.create, App.ActiveDocument, strips)
    for part in flat.flats_of(strips):
        record_value(part, "Model", feature)
    record_recompute(App.ActiveDocument)
    failed = bool(why_not_made(feature))
    for strip in strips:
        if not failed:
            record_value(strip, "Visibility", False)
        elif strip.Visibility:
            record_value(strip, "ShownByError", True)
    show_panel(panel_of, feature)


def make_nest() -> None:
    """Arrange all parts on sheets in one undo step."""
    document, sources = App.ActiveDocument, chosen_sources()
    failed = [message for message in map(why_not_made, sources) if message]
    if failed:
        raise InputError("; ".join(failed))
    open_step(document, "Nest on sheets")
    feature = recorded(nest.create, document, sources)
    record_recompute(document)
    close_step(document)
    # keep the undo step, because the parts may fit on larger sheets
    if "Invalid" in feature.State:
        show_message(feature.getStatusString())
    elif feature.LeftOut or feature.Reports:
        show_message("\n".join([*feature.LeftOut, *feature.Reports]))
