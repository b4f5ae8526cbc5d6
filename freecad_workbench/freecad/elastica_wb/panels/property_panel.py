# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of a feature. Each property has a labelled widget that shows the current value."""

import gc
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field, replace
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.curves.edge_chains import curves_in
from freecad.elastica_wb.curves.sketch_curves import curve_into, drawn_curve, is_edge, linked, picked
from freecad.elastica_wb.features.strip import DRAWN, changeable, valid_request, values_of
from freecad.elastica_wb.host.fields import (
    field_for,
    on_change,
    put_away,
    put_choices_of,
    put_text,
    set_value,
    value_of,
)
from freecad.elastica_wb.host.objects import is_sketch, is_strip, lives
from freecad.elastica_wb.host.progress import begun
from freecad.elastica_wb.host.property_table import Property, reword
from freecad.elastica_wb.host.qt import QtCore, QtWidgets, later
from freecad.elastica_wb.host.refusal import FAILURES, explained, why_not_made
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.host.sheet_store import title_of
from freecad.elastica_wb.host.words import LABELS, report_error, together, worded
from freecad.elastica_wb.live.curve_picture import curve_picture
from freecad.elastica_wb.live.overlay import COLORS, Overlay
from freecad.elastica_wb.panels.panel import Panel, active_view
from freecad.elastica_wb.recording import record_call, record_value, recorded
from freecad.elastica_wb.solving.strip_cache import changes_that_help
from freecad.elastica_wb.solving.verdicts import Verdict

from elastica_cad._text import html_text
from elastica_cad.errors import Refusal, note
from elastica_cad.mechanics.sheets import hex_color
from elastica_cad.mechanics.trials import not_tried
from elastica_cad.report_rows import Row
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.suggestions import Suggestion

# delay, ms, between the last change and the search for suggestions
IDLE_MS = 400
# interval, ms, between checks whether the search for suggestions has ended
PEEK_MS = 60
STYLES = {
    severity: f' style="color: {hex_color(COLORS[verdict])};"'
    for severity, verdict in (("error", Verdict.CANNOT), ("warning", Verdict.BREAKS))
}
"""Style of rows by severity: red for an exceeded limit, orange for other warnings."""


SEARCHING = QT_TRANSLATE_NOOP("Elastica", "Searching for changes that help")
NONE_FOUND = note("No change was found that makes the strip possible. Follow the instruction above.")
MOST_SUGGESTED = 5
LONG_WORD, BREAK = re.compile(r"(?<=[a-z])[._](?=[a-z])"), r"\g<0>&#8203;"
"""Places where a name such as tolerance.thickness_wave may be divided, and what marks them in HTML."""


@dataclass(frozen=True)
class Layout:
    """Definition of the panel for a kind of feature.

    Attributes
    ----------
    title, icon_name, step : str
        Title of the panel, name of its icon, and name of its undo step.
    groups : mapping
        Names of the properties in each group, by the title of the group.
    table : tuple of Property
        Declarations of the properties.
    applies : mapping
        Functions that return True if a property has an effect and is shown, by property. Read-only properties
        are never shown.
    source : str
        Property with a curve that the user can pick again, or "".
    results : callable
        Function that returns the rows below the message. A property name in the details of a row is replaced by
        the help of the property.
    actions : tuple of (label, callable)
        Labels and functions of buttons that replace the feature and close the panel.
    picture : callable
        Function that returns a pixmap for the space below the rows, or None.
    suggestions : callable
        Function that returns suggested changes: the text of a button, and new values of properties.
    footnote : callable
        Function that returns the text below all widgets, with slow results.
    """

    title: str
    icon_name: str
    step: str
    groups: Mapping[str, tuple[str, ...]]
    table: tuple[Property, ...]
    applies: Mapping[str, Callable[[Any], bool]] = field(default_factory=dict)
    source: str = ""
    results: Callable[[Any], Sequence[Row]] = lambda _: ()
    actions: tuple[tuple[str, Callable[[Any], None]], ...] = ()
    picture: Callable[[Any], Any] = lambda _: None
    suggestions: Callable[[Any], Mapping[str, dict[str, Any]]] = lambda _: {}
    footnote: Callable[[Any], str] = lambda _: ""


class PropertyPanel(Panel):
    """Panel that edits the properties of a feature, or of several features of a kind.

    A widget also shows changes by the property editor or a formula. For several features, it shows the value of
    the first feature and changes all features.
    """

    def __init__(self, obj: Any, layout: Layout, others: Iterable[Any] = ()) -> None:
        self.objects = list(dict.fromkeys([obj, *others]))
        # show no curve and no results, which differ between features
        if len(self.objects) > 1:
            layout = replace(layout, source="", results=lambda _: (), footnote=lambda _: "")
        self.object, self.layout = obj, layout
        for feature in self.objects:
            reword(feature)
        self.helps = {entry.name: entry.translated_help for entry in layout.table}
        self.icon_name, self.step = layout.icon_name, layout.step
        self.fields: dict[str, Any] = {}
        self.rows: dict[str, tuple[Any, Any]] = {}
        self._touched: dict[str, None] = {}
        self._changed: dict[str, None] = {}
        self._suggested: dict[str, list[tuple[Any, dict[str, Any]]]] = {}
        self._writing = False
        super().__init__(obj.Document, self.objects)
        for name, widget in self.fields.items():
            on_change(widget, lambda *_, name=name: self._touch(name))
        self._refresh = later(self._show, parent=self.form)
        self._overlay: Overlay | None = None
        self._tried: tuple[Suggestion, ...] = ()
        self._refused: StripSpec | None = None
        self._search: Future[tuple[Suggestion, ...]] | None = None
        self._idle = later(self._begin_search, IDLE_MS, self.form)
        self._look = later(self._end_search, PEEK_MS, self.form)
        App.addDocumentObserver(self)
        self._show()

    def make_form(self) -> Any:
        """Make the form: message and results at the top, then the groups of properties."""
        form = QtWidgets.QWidget()
        form.setWindowTitle(translate("Elastica", self.layout.title))
        outer = QtWidgets.QVBoxLayout(form)
        form.message, form.numbers = QtWidgets.QLabel(), QtWidgets.QLabel()
        form.numbers.setTextFormat(QtCore.Qt.RichText)
        form.message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        outer.addWidget(form.message)
        form.suggestions = [_ChangeButton(number, self._preview) for number in range(MOST_SUGGESTED)]
        for number, button in enumerate(form.suggestions):
            button.clicked.connect(lambda *_, number=number: self._take(number))
            button.hide()
            outer.addWidget(button)
        form.searching = QtWidgets.QLabel()
        form.searching.hide()
        outer.addWidget(form.searching)
        outer.addWidget(form.numbers)
        form.picture = QtWidgets.QLabel()
        outer.addWidget(form.picture)
        if self.layout.source:
            outer.addLayout(self._source_row(form))
        for words, work in self.layout.actions:
            button = QtWidgets.QPushButton(translate("Elastica", words))
            button.setObjectName(work.__name__)
            button.setToolTip(
                translate("Elastica", "Replaces this feature by objects that no longer follow its source")
            )
            button.clicked.connect(lambda *_, work=work: self._replace(work))
            outer.addWidget(button)
        for title, names in self.layout.groups.items():
            box = QtWidgets.QGroupBox(translate("Elastica", title))
            grid = QtWidgets.QFormLayout(box)
            grid.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
            for name in names:
                label = QtWidgets.QLabel(translate("Elastica", LABELS[name]))
                widget = field_for(self.object, name)
                for part in (widget, label):
                    part.setToolTip(self.helps[name])
                grid.addRow(label, widget)
                self.fields[name], self.rows[name] = widget, (label, widget)
                setattr(form, name, widget)
                set_value(widget, _plain(getattr(self.object, name)))
            outer.addWidget(box)
        # show slow results at the bottom, where they do not move the widgets
        form.footnote = QtWidgets.QLabel()
        outer.addWidget(form.footnote)
        outer.addStretch(1)
        return form

    def changed(self) -> None:
        """Write the changed widgets into their properties and recompute the document."""
        self._writing = True
        try:
            for obj, name in self._unbound(self._touched):
                value = value_of(self.fields[name])
                if _plain(getattr(obj, name)) != value:
                    setattr(obj, name, value)
                    self._changed[name] = None
        finally:
            self._touched.clear()
            self._writing = False
        self._recompute()

    def finished(self) -> None:
        """Apply pending changes, and record all changes for macros."""
        self.now()
        self._record()

    def _record(self) -> None:
        # without changes, read no property, because the objects may be deleted
        for obj, name in self._unbound(self._changed) if self._changed else ():
            record_value(obj, name, _plain(getattr(obj, name)))
        self._changed.clear()

    def _unbound(self, names: Iterable[str]) -> list[tuple[Any, str]]:
        bound = {(obj, path) for obj in self.objects for path, *_ in obj.ExpressionEngine}
        return [(obj, name) for obj in self.objects for name in names if (obj, name) not in bound]

    def closed(self) -> None:
        """Stop observing the document, and delete the widgets, which must not outlive the object."""
        App.removeDocumentObserver(self)
        self._stop_picking()
        self._refresh.stop()
        self._look.stop()
        self._idle.stop()
        self._preview(None)
        self._refused = None
        for name in list(self.fields):
            delattr(self.form, name)
            put_away(self.fields.pop(name))
        self.rows.clear()
        gc.collect()

    def let_go(self) -> None:
        """Release the document before it is closed."""
        self._overlay = None
        self.closed()

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Update the panel after a change by the property editor, a formula, an undo or a recompute."""
        if self.form is None or obj not in self.objects:
            return
        if obj is self.object and name in self.fields and not self._writing:
            # discard the typed value, because the value of a formula is newer
            self._touched.pop(name, None)
            widget = self.fields[name]
            if isinstance(widget, QtWidgets.QComboBox):
                put_choices_of(widget, obj, name)
            set_value(widget, _plain(getattr(obj, name)))
        self._refresh.start()

    def addSelection(self, document: str, name: str, element: str, _place: Any) -> None:
        """Use a curve that the user picks in the view."""
        source = App.getDocument(document).getObject(name)
        if source is None:
            return
        source, element = picked(source, element)
        if source is self.object or not hasattr(source, "Shape"):
            return
        edges = [element] if is_edge(element) else []
        if edges and is_sketch(linked(source)):
            edges, *_ = map(list, curves_in(source, edges))
        setattr(self.object, self.layout.source, (source, edges))
        self._changed[self.layout.source] = None
        self._stop_picking()
        self._recompute()

    def _recompute(self) -> None:
        self.document.recompute()
        self._show()

    def _touch(self, name: str) -> None:
        self._touched[name] = None
        self.soon()

    def _show(self) -> None:
        if self.form is None or not all(map(lives, self.subjects)):
            return
        obj, layout = self.object, self.layout
        for name, widgets in self.rows.items():
            self._show_if_used(name, *widgets)
        failed = bool(why_not_made(obj))
        rows = () if failed else layout.results(obj)
        self.form.numbers.setToolTip(
            _tip(
                f"{worded(row.label)}: {' '.join(self.helps.get(part) or worded(part) for part in row.details)}"
                for row in rows
                if row.details
            )
        )
        self.form.numbers.setText(table_of(rows))
        self.form.numbers.setVisible(bool(rows))
        picture = None if failed else layout.picture(obj)
        self.form.picture.setVisible(picture is not None)
        if picture is not None:
            self.form.picture.setPixmap(picture)
        alone = failed and is_strip(obj) and len(self.objects) == 1
        self._refused, self._tried = valid_request(obj) if alone else None, ()
        self._suggest()
        self.form.searching.setText(f"{translate('Elastica', SEARCHING)} …")
        self.form.searching.setVisible(self._refused is not None)
        self._idle.start() if self._refused is not None else self._idle.stop()
        self.form.footnote.setText("" if failed else layout.footnote(obj))
        self.show_message(self._words())
        if layout.source:
            source, edges = getattr(obj, layout.source) or (None, ())
            self.form.source.setText(
                " ".join([source.Label, *edges]) if source is not None else translate("Elastica", "none")
            )
            self._show_if_used(layout.source, self.form.sourceLabel, self.form.source, self.form.pick)

    def _show_if_used(self, name: str, *widgets: Any) -> None:
        applies = self.layout.applies.get(name)
        used = "ReadOnly" not in self.object.getEditorMode(name) and (not applies or applies(self.object))
        for widget in widgets:
            widget.setVisible(used)

    def _words(self) -> str:
        obj = self.object
        if len(self.objects) > 1:
            verdicts = (
                (strip.Label, words) for strip in self.objects for words in (strip.Verdict, *strip.Reasons)
            )
            return "\n".join(map(worded, together(verdicts)))
        if hasattr(obj, "Verdict"):
            return "\n".join([obj.Verdict, *obj.Reasons])
        return why_not_made(obj) or "\n".join(getattr(obj, "Reports", []))

    def _suggest(self) -> None:
        self._preview(None)
        self._suggested = defaultdict(list)
        for suggestion in self._tried:
            self._suggested[_title(suggestion)].append((self.object, suggestion))
        for obj in self.objects:
            for text, values in self.layout.suggestions(obj).items():
                self._suggested[text].append((obj, values))
        none = [""] * MOST_SUGGESTED
        effects = [worded(suggestion.effect) for suggestion in self._tried] + none
        for button, text, effect in zip(
            self.form.suggestions, [*self._suggested, *none], effects, strict=False
        ):
            put_text(button, worded(text))
            button.setToolTip(_tip([effect]))
            button.setVisible(bool(text))

    def _begin_search(self) -> None:
        if self._refused is None:
            return
        runs = self._search is not None and not self._search.done()
        if runs or QtWidgets.QApplication.mouseButtons():
            self._idle.start()
            return
        self._search = begun(changes_that_help, self._refused, changeable(self.object))
        self._searched = self._refused
        self._look.start()

    def _end_search(self) -> None:
        """Show the found suggestions, unless the properties have changed meanwhile."""
        if not self._search.done():
            self._look.start()
        elif self._searched is self._refused:
            self._tried = self._search.result()
            self._suggest()
            self.form.searching.setText(worded(not_tried(self._refused.curve) or NONE_FOUND))
            self.form.searching.setVisible(not self._suggested)

    def _preview(self, number: int | None) -> None:
        if self._overlay is not None:
            self._overlay.remove()
            self._overlay = None
        view = active_view()
        if number is None or number >= len(self._tried) or view is None:
            return
        suggestion = self._tried[number]
        self._overlay = Overlay(view, drawn_curve(self.object.Curve).world)
        request, strips = suggestion.requests[0], suggestion.strips
        if suggestion.change.field == "between":
            self._overlay.show(curve_picture(request.curve, request))
        self._overlay.show_nearest(*(strip.rod.position for strip in strips))

    def _take(self, number: int) -> None:
        for obj, change in [*self._suggested.values()][number]:
            if isinstance(change, Suggestion) and change.change.field in DRAWN:
                sketch, _ = obj.Curve
                recorded(curve_into, sketch, change.requests[0].curve)
                record_call(sketch, "solve")
                values = {}
            else:
                values = values_of(obj, change.change) if isinstance(change, Suggestion) else change
            if isinstance(change, Suggestion) and change.width is not None:
                values |= values_of(obj, change.width)
            for name, value in values.items():
                setattr(obj, name, value)
                self._changed[name] = None
        self._recompute()

    def _replace(self, work: Callable[[Any], None]) -> None:
        self.now()
        self._record()
        self.closed()
        try:
            recorded(work, self.object)
        except FAILURES as error:
            report_error(str(explained(error)))
            self.reject()
            return
        self.subjects.clear()
        self.accept()

    def _source_row(self, form: Any) -> Any:
        row = QtWidgets.QHBoxLayout()
        form.source = QtWidgets.QLabel()
        form.pick = QtWidgets.QPushButton(translate("Elastica", "Pick another curve"))
        form.pick.setObjectName("pick")
        form.pick.setCheckable(True)
        form.pick.setToolTip(
            translate("Elastica", "Then click a sketch or an edge, in the view or in the tree")
        )
        form.pick.toggled.connect(self._picking)
        form.sourceLabel = QtWidgets.QLabel(translate("Elastica", "Curve"))
        for widget in (form.sourceLabel, form.source):
            row.addWidget(widget)
        row.setStretch(1, 1)
        rows = QtWidgets.QVBoxLayout()
        rows.addLayout(row)
        rows.addWidget(form.pick)
        return rows

    def _picking(self, on: bool) -> None:
        Gui.Selection.removeObserver(self)
        if on:
            Gui.Selection.clearSelection()
            # the argument 0 requests full paths, because a link may display the part
            Gui.Selection.addObserver(self, 0)
            source, _ = getattr(self.object, self.layout.source) or (None, ())
            if source is not None:
                source.Visibility = True

    def _stop_picking(self) -> None:
        Gui.Selection.removeObserver(self)
        if self.form is not None and self.layout.source:
            set_value(self.form.pick, False)


class _ChangeButton(QtWidgets.QPushButton):
    def __init__(self, number: int, preview: Callable[[int | None], None]) -> None:
        super().__init__()
        self._number, self._preview = number, preview

    def enterEvent(self, event: Any) -> None:
        self._preview(self._number)
        super().enterEvent(event)

    def leaveEvent(self, event: Any) -> None:
        self._preview(None)
        super().leaveEvent(event)


def _title(suggestion: Suggestion) -> Refusal:
    change = suggestion.change
    if change.field == "sheet":
        suggestion = replace(suggestion, change=replace(change, value=title_of(change.value)))
    return suggestion.title


def table_of(rows: Sequence[Row]) -> str:
    """Return rows as an HTML table for a label, or "" without rows."""
    table = "".join(
        f"<tr><td>{html_text(worded(row.label))}&nbsp;&nbsp;</td><td{STYLES.get(row.severity, '')}>"
        f"{LONG_WORD.sub(BREAK, html_text(worded(row.text)))}</td></tr>"
        for row in rows
    )
    return f"<table>{table}</table>" if rows else ""


def _tip(lines: Iterable[str]) -> str:
    # a tip has no format, and Qt reads words that look like HTML as HTML
    return "<br>".join(f"<span>{html_text(line)}</span>" for line in lines if line)


def _plain(value: Any) -> Any:
    return getattr(value, "Value", value)
