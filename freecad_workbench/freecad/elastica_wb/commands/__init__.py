# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The commands of the workbench, grouped as in its menu and toolbars."""

from collections.abc import Iterable
from functools import partial

import FreeCADGui as Gui
from freecad.elastica_wb.command import LIVE, Command
from freecad.elastica_wb.commands import actions
from freecad.elastica_wb.commands.actions import answers, open_on, show_panel
from freecad.elastica_wb.commands.selection import chosen_sketch, chosen_sources, chosen_strip, chosen_strips
from freecad.elastica_wb.example import open_example
from freecad.elastica_wb.features.flat import OUTLINE
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP
from freecad.elastica_wb.live import between_clamps
from freecad.elastica_wb.live.sketches import is_sketch_open
from freecad.elastica_wb.panels.bend import BendPanel
from freecad.elastica_wb.panels.coupon import CouponPanel
from freecad.elastica_wb.panels.export import ExportPanel
from freecad.elastica_wb.panels.fixtures import FixturesPanel
from freecad.elastica_wb.panels.projective import ProjectivePanel
from freecad.elastica_wb.panels.rails import RailsPanel
from freecad.elastica_wb.panels.sheets import SheetsPanel
from freecad.elastica_wb.panels.tolerance import TolerancePanel

__all__ = ["COMMANDS", "MENU", "TOOLBARS", "context_menu", "register"]

SKETCH = "Sketcher_NewSketch"
HAS_STRIP, HAS_PARTS = partial(answers, chosen_strips), partial(answers, chosen_sources)
"""Functions that return True if `chosen_strips` or `chosen_sources` finds an object."""

DRAW = (
    Command(
        name="Elastica_Between",
        text=QT_TRANSLATE_NOOP("Elastica_Between", "Curve of given length"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Between",
            "Draw a strip of given length between two clamps, as a curve in the open sketch",
        ),
        run=between_clamps.switch,
        has_subject=is_sketch_open,
        shortcut="Y, E",
    ),
    Command(
        name="Elastica_Check",
        text=QT_TRANSLATE_NOOP("Elastica_Check", "Check curve"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Check",
            ("Check whether a flat strip can take the selected curve; if not, show why and where"),
        ),
        run=actions.check,
        has_subject=actions.has_curve,
        shortcut="Y, C",
    ),
    Command(
        name="Elastica_Nearest",
        text=QT_TRANSLATE_NOOP("Elastica_Nearest", "Nearest curve to sketch"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Nearest", "Find the curve nearest to the selected sketch that can be bent within limits"
        ),
        run=actions.make_nearest,
        has_subject=actions.has_curve,
        shortcut="Y, N",
    ),
    Command(
        name="Elastica_Projective",
        text=QT_TRANSLATE_NOOP("Elastica_Projective", "Projective edit"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Projective",
            "Pull the selected sketch's curve by four handles; if a strip can take the drawn curve, it can take the changed curve",  # noqa: E501
        ),
        run=partial(open_on, ProjectivePanel, chosen_sketch),
        has_subject=actions.has_curve,
        shortcut="Y, P",
    ),
    Command(
        name="Elastica_Section",
        text=QT_TRANSLATE_NOOP("Elastica_Section", "Section into curves"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Section",
            "Cut the selected body, surface or mesh by planes into smooth curves that strips can follow",
        ),
        run=actions.make_sections,
        has_subject=partial(answers, actions.bodies_and_path),
        in_sketch=False,
    ),
)
STRIPS = (
    Command(
        name="Elastica_Strip",
        text=QT_TRANSLATE_NOOP("Elastica_Strip", "Strip from sketch"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Strip",
            "Make the strip that bends into the selected spline: the bent part and the linked flat part",
        ),
        run=actions.make_strips,
        has_subject=actions.has_curve,
        shortcut="Y, S",
    ),
    Command(
        name="Elastica_Edit",
        text=QT_TRANSLATE_NOOP("Elastica_Edit", "Edit strips"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Edit", "Change sheet, widths and ends of all selected strips at once"
        ),
        run=actions.edit_strips,
        has_subject=HAS_STRIP,
    ),
    Command(
        name="Elastica_Perforate",
        text=QT_TRANSLATE_NOOP("Elastica_Perforate", "Perforate"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Perforate",
            "Give the selected strips an even width, with holes that set their stiffness",
        ),
        run=actions.perforate,
        has_subject=HAS_STRIP,
    ),
    Command(
        name="Elastica_Laminate",
        text=QT_TRANSLATE_NOOP("Elastica_Laminate", "Laminate"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Laminate",
            "Rebuild the selected strips as two glued layers: a base of even width and a narrower backing",
        ),
        run=actions.laminate,
        has_subject=HAS_STRIP,
    ),
    Command(
        name="Elastica_Flat",
        text=QT_TRANSLATE_NOOP("Elastica_Flat", "Flat part"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Flat",
            "Make the missing flat parts of the selected strips, for example of copied strips",
        ),
        run=actions.make_flat_parts,
        has_subject=HAS_STRIP,
    ),
    Command(
        name="Elastica_Outline",
        text=QT_TRANSLATE_NOOP("Elastica_Outline", "Flat outline"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Outline",
            "Make the outlines of the selected strips as plane faces, for pockets, tool paths and FreeCAD's own DXF files",  # noqa: E501
        ),
        run=partial(actions.make_flat_parts, OUTLINE),
        has_subject=HAS_STRIP,
    ),
    Command(
        name="Elastica_Rails",
        text=QT_TRANSLATE_NOOP("Elastica_Rails", "Rails, ties and loads"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Rails",
            "Hold the selected strip between its ends by rails, pins and cords, and load it with forces and masses",
        ),
        run=partial(open_on, RailsPanel, chosen_strip),
        has_subject=HAS_STRIP,
        shortcut="Y, R",
    ),
    Command(
        name="Elastica_Flexure",
        text=QT_TRANSLATE_NOOP("Elastica_Flexure", "Two-state part"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Flexure",
            "Make a part that rests in both selected curves, such as a clip that snaps, and the plate that holds it",  # noqa: E501
        ),
        run=actions.make_flexure,
        has_subject=actions.has_curve,
        shortcut="Y, T",
    ),
    Command(
        name="Elastica_Bend",
        text=QT_TRANSLATE_NOOP("Elastica_Bend", "Bend forward"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Bend",
            "Move or turn the ends of the selected strip and watch it take its new rest shape",
        ),
        run=partial(open_on, BendPanel, chosen_strip),
        has_subject=HAS_STRIP,
        shortcut="Y, B",
    ),
    Command(
        name="Elastica_Tolerance",
        text=QT_TRANSLATE_NOOP("Elastica_Tolerance", "Tolerance study"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Tolerance",
            "Compute the deviation of the bent strip when sheet, cut and clamps vary within their ranges",
        ),
        run=partial(open_on, TolerancePanel, chosen_strip),
        has_subject=HAS_STRIP,
    ),
)
MODELS = (
    Command(
        name="Elastica_Interlock",
        text=QT_TRANSLATE_NOOP("Elastica_Interlock", "Interlock selected strips"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Interlock", "Combine the selected strips into a model, and cut slots where they cross"
        ),
        run=actions.make_model,
        has_subject=partial(answers, chosen_strips, least=2),
        shortcut="Y, I",
        in_sketch=False,
    ),
    Command(
        name="Elastica_Fixtures",
        text=QT_TRANSLATE_NOOP("Elastica_Fixtures", "End fixtures and base plate"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Fixtures",
            "Make printed blocks, a slotted base plate or rings that hold the ends of the selected strips or model",
        ),
        run=partial(open_on, FixturesPanel, chosen_sources),
        has_subject=HAS_PARTS,
        in_sketch=False,
    ),
    Command(
        name="Elastica_Nest",
        text=QT_TRANSLATE_NOOP("Elastica_Nest", "Nest on sheets"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Nest",
            "Arrange all cut parts of the selected strips, models and base plates on sheets",
        ),
        run=actions.make_nest,
        has_subject=HAS_PARTS,
        in_sketch=False,
    ),
    Command(
        name="Elastica_Export",
        text=QT_TRANSLATE_NOOP("Elastica_Export", "Export cutting files"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Export",
            "Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates",
        ),
        run=partial(open_on, ExportPanel, chosen_sources),
        has_subject=HAS_PARTS,
        shortcut="Y, X",
    ),
)
WORKSHOP = (
    Command(
        name="Elastica_Sheets",
        text=QT_TRANSLATE_NOOP("Elastica_Sheets", "Sheet library"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Sheets", "Show the known sheets with their sources, and store your own sheets"
        ),
        run=partial(show_panel, SheetsPanel),
    ),
    Command(
        name="Elastica_Coupon",
        text=QT_TRANSLATE_NOOP("Elastica_Coupon", "Coupon and calibrate"),
        tip=QT_TRANSLATE_NOOP(
            "Elastica_Coupon",
            "Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own",
        ),
        run=partial(show_panel, CouponPanel),
        in_sketch=False,
    ),
)
EXAMPLE = Command(
    name="Elastica_Example",
    text=QT_TRANSLATE_NOOP("Elastica_Example", "Open an example"),
    tip=QT_TRANSLATE_NOOP(
        "Elastica_Example",
        "Open an example arch with its strip and its flat part, to try changes",
    ),
    run=open_example,
    has_subject=lambda: True,
    in_sketch=False,
)

COMMANDS: tuple[Command, ...] = (*DRAW, *STRIPS, *MODELS, *WORKSHOP, EXAMPLE)


def _names(commands: Iterable[Command]) -> list[str]:
    return [command.name for command in commands]


TOOLBARS = {
    "Elastica": [SKETCH, LIVE.name, "Separator", *_names(DRAW), "Separator", *_names(STRIPS)],
    "Elastica models": [*_names(MODELS), "Separator", *_names(WORKSHOP)],
}
MENU = [*TOOLBARS["Elastica"], "Separator", *TOOLBARS["Elastica models"], "Separator", EXAMPLE.name]


def register() -> None:
    """Register all commands with FreeCAD."""
    registered = set(Gui.listCommands())
    for command in COMMANDS:
        if command.name not in registered:
            Gui.addCommand(command.name, command)


def context_menu() -> list[str]:
    """Return the commands that can be used with the current selection, for the context menu."""
    if not Gui.Selection.getSelection():
        return []
    groups = [[c.name for c in group if c.has_subject() and c.IsActive()] for group in (DRAW, STRIPS, MODELS)]
    names: list[str] = []
    for group in filter(None, groups):
        names += ["Separator", *group] if names else group
    return names
