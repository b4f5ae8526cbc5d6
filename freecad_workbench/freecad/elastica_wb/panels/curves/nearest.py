# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the nearest curve: limits, what to keep, the curve found shown beside the drawn one."""

from typing import Any

from freecad.elastica_wb.curves.sketch_curves import curve_into, sketch_curve
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.resources import tr
from freecad.elastica_wb.host.sheet_store import sheet_called, sheet_list
from freecad.elastica_wb.panels.panel import Panel, active_view
from freecad.elastica_wb.preview.preview_lines import Preview
from freecad.elastica_wb.solving.strip_cache import find_nearest

from elastica_cad.errors import InputError
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.forming.rod_spec import RodSpec

__all__ = ["NearestPanel"]

FIELDS = ("sheet", "ratio", "useMargin", "margin", "useStrain", "tangents", "length")
FREE_STRAIN = 0.4  # what no sheet stands


class NearestPanel(Panel):
    """OK adds a sketch with the curve found, or replaces the spline in the drawn one."""

    file = "nearest"
    icon_name = "Elastica_Nearest"
    step = "Nearest curve to sketch"

    def __init__(self, sketch: Any) -> None:
        self.curve = sketch_curve(sketch)
        super().__init__(sketch.Document, [sketch])
        self.sketch = sketch
        self.near: NearestRod | None = None
        self.form.sheet.addItems(sheet_list())
        self.form.sheet.setCurrentText(preferences.default_sheet())
        self.form.ends.setEnabled(False)
        view = active_view()
        self.preview = None if view is None else Preview(view, sketch.getGlobalPlacement())
        self.watch(*FIELDS)
        self._safely_changed()

    def changed(self) -> None:
        """Search."""
        self.near = None
        form = self.form
        limits = Limits(
            ratio=self.value("ratio"),
            margin=self.value("margin") if form.useMargin.isChecked() else None,
            sheet=sheet_called(form.sheet.currentText()),
            strain=None if form.useStrain.isChecked() else FREE_STRAIN,
        )
        keep = Keep(tangents=form.tangents.isChecked(), length=form.length.isChecked())
        self.near = find_nearest(RodSpec(self.curve, limits=limits, keep=keep))
        if self.preview is not None:
            self.preview.show(self.curve.sample(201).position, self.near.rod.position)
        words = [self.near.status.value, f"{tr('Largest distance')}: {self.near.deviation:.3g} mm."]
        held = [f"{tr(b.name)} ({b.limit:.3g})" if b.limit else tr(b.name) for b in self.near.binding[:3]]
        words += [f"{tr('Held away by')}: {', '.join(held)}."] if held else []
        self.tell("\n".join(words))

    def finished(self) -> None:
        """Keep the curve found."""
        self.now()
        if self.near is None:
            raise InputError(tr("no curve was found: change the limits"))
        target = self.sketch
        if not self.form.replace.isChecked():
            target = self.document.addObject("Sketcher::SketchObject", "Nearest")
            target.Label = f"{self.sketch.Label} {tr('nearest')}"
            group = self.sketch.getParentGeoFeatureGroup()
            if group is not None:
                group.addObject(target)
            target.Placement = self.sketch.Placement
        curve_into(target, self.near.curve)

    def closed(self) -> None:
        """Take the preview off the view."""
        if self.preview is not None:
            self.preview.remove()
            self.preview = None
