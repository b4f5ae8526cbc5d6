# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of sections: a family of planes, what becomes of closed lines, the lines shown before OK."""

from collections.abc import Sequence
from typing import Any

import FreeCAD as App
import numpy as np
from freecad.elastica_wb.curves.plane_sections import (
    AXES,
    CLOSED,
    FAMILIES,
    Family,
    box_of,
    curves_of,
    cut,
    is_path,
    path_points,
    section_sketches,
)
from freecad.elastica_wb.host.lifetime import lives
from freecad.elastica_wb.host.resources import tr
from freecad.elastica_wb.host.user_units import worded
from freecad.elastica_wb.panels.panel import Panel, active_view, progress
from freecad.elastica_wb.panels.widgets.fields import set_value
from freecad.elastica_wb.preview.preview_lines import Lines

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.forming.plane_sections.section_lines import PlaneSection
from elastica_cad.geometry.frame import Frame

__all__ = ["SectionPanel"]

FIELDS = ("family", "axis", "path", "count", "throughX", "throughY", "throughZ", "sweep")
SHOWN = {
    "axis": ("label_1_Across", FAMILIES[:2]),
    "path": ("label_2_Path", FAMILIES[2:]),
    "throughX": ("label_4_x", FAMILIES[1:2]),
    "throughY": ("label_5_y", FAMILIES[1:2]),
    "throughZ": ("label_6_z", FAMILIES[1:2]),
    "sweep": ("label_7_Sweep", FAMILIES[1:2]),
}
"""Label of a field, and which families have a use for it."""

PLANE, OPEN, CLOSED_LINE = (0.8, 0.85, 0.95), (1.0, 0.45, 0.0), (0.75, 0.1, 0.75)


class SectionPanel(Panel):
    """Cuts as soon as something is changed; the sketches are made at OK, in one undo step."""

    file = "section"
    icon_name = "Elastica_Section"
    step = "Section into curves"

    def __init__(self, bodies: list[Any], path: tuple[Any, Sequence[str]] | None = None) -> None:
        super().__init__(App.ActiveDocument, bodies)
        self.bodies = bodies
        self.sketches: list[Any] = []
        self.remarks: list[str] = []
        self.sections: list[list[PlaneSection]] = []
        view = active_view()
        self.lines = None if view is None else Lines(view)
        self.boxes = [box_of(body) for body in bodies]
        self.paths = [(obj, ()) for obj in self.document.Objects if obj not in bodies and is_path(obj)]
        if path is not None:
            self.paths = [path, *((obj, names) for obj, names in self.paths if obj is not path[0])]
        form = self.form
        form.axis.addItems(list(AXES))
        form.path.addItems([" ".join([obj.Label, *names]) for obj, names in self.paths])
        form.family.setCurrentIndex(0 if path is None else 2)
        for name, value in zip(("throughX", "throughY", "throughZ"), self.boxes[0].Center, strict=True):
            set_value(getattr(form, name), value)
        self.watch(*FIELDS)
        self._safely_changed()

    def family(self) -> Family:
        """The planes that the widgets ask for."""
        form, kind = self.form, FAMILIES[self.form.family.currentIndex()]
        path = None
        if kind == FAMILIES[2] and self.paths:
            source, names = self.paths[form.path.currentIndex()]
            if not lives(source):
                raise InputError(tr("the path was deleted: choose another one"))
            path = path_points(source, names)
        return Family(
            kind,
            self.value("count"),
            form.axis.currentText(),
            [self.value(name) for name in ("throughX", "throughY", "throughZ")],
            self.value("sweep"),
            path,
        )

    def changed(self) -> None:
        """Cut, show planes and lines, count them."""
        self.sections = []
        kind = FAMILIES[self.form.family.currentIndex()]
        for name, (label, families) in SHOWN.items():
            for widget in (name, label):
                getattr(self.form, widget).setVisible(kind in families)
        if self.lines is not None:
            self.lines.show([])
        family = self.family()
        with progress(tr("Cutting"), family.count * len(self.bodies)) as go_on:
            for k, body in enumerate(self.bodies):
                self.sections.append(cut(body, family, lambda i, k=k: go_on(k * family.count + i)))
        lines = [line for cuts in self.sections for section in cuts for line in section.lines]
        closed = [line.places for line in lines if line.is_closed]
        opened = [line.places for line in lines if not line.is_closed]
        if self.lines is not None:
            planes = [
                _border(frame, box, family.half) for box in self.boxes for _, frame in family.planes(box)
            ]
            self.lines.show([(PLANE, 1.0, planes), (CLOSED_LINE, 3.0, closed), (OPEN, 3.0, opened)])
        words = [
            f"{tr('Open lines')}: {len(opened)}. {tr('Closed ones')}: {len(closed)}.",
            *(report for cuts in self.sections for section in cuts for report in section.reports),
        ]
        self.tell("\n".join(words))

    def finished(self) -> None:
        """Make the curves; what gives none is named in the report view, the others go on."""
        self.now()
        if not self.sections:
            self.changed()
        form, made = self.form, []
        self.remarks = []
        for body, cuts in zip(self.bodies, self.sections, strict=True):
            with progress(tr("Making curves"), len(cuts)) as go_on:
                curves, said = curves_of(
                    cuts,
                    tolerance=self.value("tolerance"),
                    waves=self.value("waves"),
                    closed=CLOSED[form.closed.currentIndex()],
                    step=go_on,
                )
            made.append((body, curves))
            self.remarks += said
        if not any(curves for _, curves in made):
            raise InputError("; ".join(self.remarks) or tr("the planes miss the object"))
        for body, curves in made:
            self.sketches += section_sketches(self.document, body, curves)
        for remark in self.remarks:
            App.Console.PrintWarning(f"Elastica: {worded(remark)}\n")

    def closed(self) -> None:
        """Take the preview off the view."""
        if self.lines is not None:
            self.lines.remove()
            self.lines = None


def _border(frame: Frame, box: Any, half: bool) -> FloatArray:
    """The part of a plane that can meet something in a box, as a closed line (5, 3)."""
    corners = np.array([tuple(box.getPoint(i)) for i in range(8)])
    flat = frame.local(corners)[:, :2]
    (x0, y0), (x1, y1) = flat.min(axis=0), flat.max(axis=0)
    x0 = 0.0 if half else x0
    return frame.point([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])
