# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Base class of all features: properties, sheets, dependence on containers, and errors."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any, ClassVar

import FreeCAD as App
from freecad.elastica_wb.host.objects import Unsaved, dress, is_ours
from freecad.elastica_wb.host.property_table import (
    MESSAGES,
    RECORDS,
    Property,
    choose_again,
    ensure,
    is_misread,
    put,
    require_choices,
    result,
    reword,
)
from freecad.elastica_wb.host.refusal import (
    FAILURES,
    explained,
    refused,
    why_not_computed,
    why_not_made,
)
from freecad.elastica_wb.host.sheet_store import (
    default_sheet,
    sheet_called,
    sheet_from_text,
    sheet_list,
    text_of,
    title_of,
)
from freecad.elastica_wb.host.words import report_error, worded

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.mechanics.sheets import sheet_color

CONTAINERS = Property(
    "LinkListGlobal",
    "Containers",
    "Curve",
    "Objects with which the curve moves",
    [],
    result=True,
    hidden=True,
)
"""Property with the containers that can move the curve relative to the feature. A move recomputes the feature."""

COMPANIONS = Property(
    "LinkList",
    "Companions",
    "Curve",
    "Sources in the same container; they enter and leave containers together with the feature",
    [],
    result=True,
    hidden=True,
)
"""Property with the sources in the container of the feature.

FreeCAD moves the objects of this link into another container together with the feature, as for its own features.
The links to the sources have global scope, because a source may be in another container, such as a body.
"""

CHOSEN_EDGES = Property(
    "FloatList",
    "ChosenEdges",
    "Curve",
    "Lengths and ends of the edges when they were chosen",
    [],
    result=True,
    hidden=True,
)
"""Property of features that follow a curve, from which `renumbered` recognizes the edges of the property Curve."""

HIDDEN_BY_ERROR = Property(
    "Bool", "HiddenByError", "Result", "Hidden because its recompute failed", hidden=True
)

SHOWN_BY_ERROR = result(
    "Bool", "ShownByError", "Shown because the recompute of its model failed", hidden=True
)

REPORTS = result("StringList", "Reports", "Messages of the last recompute")

# colour components that differ by less count as equal, because FreeCAD rounds colours
SAME_COLOR = 1e-2
MOST_NAMES = 6


class Feature(Unsaved):
    """Proxy of a feature. All data are in the properties of the document object."""

    properties: tuple[Property, ...] = ()
    sheets: ClassVar[Mapping[str, str]] = {}
    """Names of the properties with sheet data, by the properties with sheet names."""
    places: ClassVar[tuple[Property, ...]] = (CONTAINERS, COMPANIONS)
    """Properties with objects whose placement matters: none for a feature that only the user places."""
    choices: ClassVar[frozenset[str]] = frozenset()
    links: ClassVar[tuple[str, ...]] = ()
    """Names of the properties with the objects on which the feature depends."""
    deciding: ClassVar[tuple[str, ...]] = ()
    """Names of the properties whose values decide which other properties have an effect."""
    reported = ""
    """Error that the last recompute of the feature printed."""
    chosen: str | None = None
    """Value of an enumeration property before its current change, or None if that value was invalid."""

    def __init_subclass__(cls) -> None:
        groups = {entry.name: entry.group for entry in cls.properties}
        titles = [
            Property("String", f"{name}Title", groups[name], "Full name of the sheet", result=True)
            for name in cls.sheets
        ]
        cls.links = tuple(entry.name for entry in cls.properties if entry.kind.startswith("Link"))
        chosen = [CHOSEN_EDGES] if "Curve" in cls.links else []
        cls.properties = (*cls.properties, *titles, *chosen, *cls.places)
        cls.choices = frozenset(entry.name for entry in cls.properties if entry.kind == "Enumeration")

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self.ensure(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Update a feature of a file that an earlier version wrote."""
        self.ensure(obj)
        _note_containers(obj)
        reword(obj)
        dress(obj)

    def ensure(self, obj: Any) -> None:
        """Add missing properties, update the list of sheets, and make properties without effect read-only."""
        sheet_names = {name: getattr(obj, name) for name in self.sheets if name in obj.PropertiesList}
        ensure(obj, (*self.properties, HIDDEN_BY_ERROR, SHOWN_BY_ERROR, RECORDS))
        for name in self.sheets:
            chosen = sheet_names.get(name) or default_sheet()
            setattr(obj, name, list(dict.fromkeys([*sheet_list(), chosen])))
            setattr(obj, name, chosen)
            _show_title(obj, name)
        self.show_idle(obj)

    def show_idle(self, obj: Any) -> None:
        """Make the properties read-only that have no effect beside the present values of others."""

    def onBeforeChange(self, obj: Any, name: str) -> None:
        """Store a valid choice before it changes. If a formula sets an invalid choice, the old one is restored."""
        if name in self.choices:
            self.chosen = None if is_misread(obj, name) else getattr(obj, name)

    def onChanged(self, obj: Any, name: str) -> None:
        """Replace an invalid choice, and update Containers and Companions after a change of the sources.

        After the choice of another sheet, set thickness, sheet data and colour. Properties that lose or gain
        their effect by the change become read-only or editable.
        """
        # FreeCAD calls this method for every written result, so slow checks come last
        if name in self.choices and is_misread(obj, name):
            if getattr(obj, name) is None or self.chosen not in (None, getattr(obj, name)):
                choose_again(obj, name, self.chosen)
            return
        # a new object or a copy gets its properties one by one, and `ensure` follows when it has all
        if name in self.deciding and all(entry.name in obj.PropertiesList for entry in self.properties):
            self.show_idle(obj)
        if (name not in self.links and name not in self.sheets) or "Restore" in obj.State:
            return
        if name in self.links:
            _note_containers(obj)
        if name == "Curve" and CHOSEN_EDGES.name in obj.PropertiesList:
            put(obj, ChosenEdges=[])
        if f"{name}Title" in obj.PropertiesList:
            _show_title(obj, name)
        numbers_name = self.sheets.get(name)
        # `chosen` is None if the sheet was restored after an invalid formula
        if numbers_name in obj.PropertiesList and self.chosen is not None:
            with suppress(InputError):  # the next recompute reports the error
                sheet = sheet_called(getattr(obj, name), getattr(obj, numbers_name))
                put(obj, **{numbers_name: text_of(sheet)})
                if name == "Sheet" and "Thickness" in obj.PropertiesList:
                    put(obj, Thickness=sheet.thickness)
            if name == "Sheet" and App.GuiUp:
                _recolor(obj, self.chosen)

    def keep_sheets(self, obj: Any) -> None:
        """Update the list of sheets. Mark the feature for recompute if the user has edited its sheet."""
        names = {*self.sheets.values(), "Thickness"} & {*obj.PropertiesList}
        saved = {name: getattr(obj, name) for name in names}
        for name in self.sheets:
            chosen = getattr(obj, name)
            choices = list(dict.fromkeys([*sheet_list(), chosen]))
            if choices != obj.getEnumerationsOfProperty(name):
                setattr(obj, name, choices)
                setattr(obj, name, chosen)
        put(obj, **{name: getattr(value, "Value", value) for name, value in saved.items()})
        for name, numbers in self.sheets.items():
            with suppress(InputError):
                old = sheet_from_text(getattr(obj, name), saved[numbers])
                new = sheet_called(old.name, saved[numbers])
                if new != old:
                    obj.touch()
                if name == "Sheet" and "Thickness" in saved and obj.Thickness.Value == old.thickness:
                    # replace the nominal thickness of the old sheet, but not a measured thickness
                    put(obj, Thickness=new.thickness)

    def execute(self, obj: Any) -> None:
        """Recompute the feature. After an error, the shape is unchanged."""
        try:
            require_choices(obj, self.properties)
            for name, numbers in self.sheets.items():
                with suppress(InputError):
                    put(obj, **{numbers: text_of(sheet_called(getattr(obj, name), getattr(obj, numbers)))})
            self.make(obj)
        except FAILURES as error:
            explanation = explained(error)
            self.failed(obj, explanation)
            raise refused(obj, explanation) from None
        self.reported = ""
        _restore_visibility(obj)

    def make(self, obj: Any) -> None:
        """Compute shape and results from the properties. Subclasses override this method."""
        raise NotImplementedError

    def failed(self, obj: Any, error: ElasticaError) -> None:
        """Write the error into the results, and hide the last valid shape."""
        self.show_error(obj, error)
        hide(obj)

    def show_error(self, obj: Any, error: ElasticaError) -> None:
        """Write the error into the results, if the feature has results."""

    def covered(self, _obj: Any) -> list[Any]:
        """Return the features that are hidden because this feature displays them."""
        return []


def added(
    document: Any,
    name: str,
    proxy: type[Feature],
    sources: Iterable[Any] = (),
    *,
    type_id: str = "Part::FeaturePython",
    **properties: Any,
) -> Any:
    """Add a feature with these properties to the document, or to the App::Part that contains all `sources`.

    A feature of PartDesign is added to the body of its sources. A feature with a sheet gets the sheet's colour.
    """
    obj = document.addObject(type_id, name)
    proxy(obj)
    groups = {source.getParentGeoFeatureGroup() for source in sources}
    group = groups.pop() if len(groups) == 1 else None
    if group is not None and (group.TypeId == "App::Part" or type_id.startswith("PartDesign::")):
        group.addObject(obj)
    dress(obj)
    if App.GuiUp and proxy.sheets:
        obj.ViewObject.ShapeColor = sheet_color(sheet_called(obj.Sheet))
    for prop, value in properties.items():
        setattr(obj, prop, value)
    return obj


def _show_title(obj: Any, name: str) -> None:
    put(obj, **{f"{name}Title": worded(title_of(getattr(obj, name)))})


def _recolor(obj: Any, before: str) -> None:
    with suppress(InputError):
        old, new = (sheet_color(sheet_called(name)) for name in (before, obj.Sheet))
        users = [user for user in obj.InList if not getattr(getattr(user, "Proxy", None), "sheets", None)]
        for view in [user.ViewObject for user in (obj, *users)]:
            color = getattr(view, "ShapeColor", ())[:3]
            if color and all(abs(a - b) < SAME_COLOR for a, b in zip(color, old, strict=True)):
                view.ShapeColor = new


def hide(obj: Any) -> None:
    """Hide a failed feature and its dependent features, because their shapes are outdated.

    Valid features that the hidden features had replaced become visible again.
    """
    failed = _with_users(obj)
    ours = [feature for feature in failed if is_ours(feature)]
    for feature in ours:
        if feature.Visibility:
            feature.HiddenByError = True
            feature.Visibility = False
    for part in [
        part for feature in ours if feature.HiddenByError for part in feature.Proxy.covered(feature)
    ]:
        well = part not in failed and "Invalid" not in part.State
        is_covered = any(
            user.Visibility and part in user.Proxy.covered(user) for user in part.InList if is_ours(user)
        )
        if well and not (part.Visibility or part.ShownByError or is_covered):
            part.ShownByError = True
            part.Visibility = True


def give_up(document: Any) -> None:
    """Set the error of features that FreeCAD skips because they depend on a failed object.

    The failed object belongs to another workbench, or has a formula that cannot be computed.
    """
    for source in filter(_failed_before, document.Objects):
        ours = [feature for feature in _with_users(source) if is_ours(feature)]
        message = why_not_made(source)
        # if all features are hidden, the error was already reported
        if any(feature.Visibility for feature in ours):
            names = ", ".join(
                [feature.Label for feature in ours[:MOST_NAMES]] + ["..."] * (len(ours) > MOST_NAMES)
            )
            report_error(message, names)
        for feature in ours:
            feature.Proxy.show_error(feature, InputError(message))
        hide(source)


def why_skipped(obj: Any) -> str:
    """Return why FreeCAD skipped the recompute of an object, or "" if it did not skip the object."""
    for followed in (obj, *_sources_of(obj)):
        sources = [
            source for source in followed.OutList if source not in getattr(followed, CONTAINERS.name, ())
        ]
        for failed in filter(_failed_before, (followed, *sources)):
            return why_not_made(failed)
    return ""


def _failed_before(obj: Any) -> bool:
    return "Invalid" in obj.State and (not is_ours(obj) or bool(why_not_computed(obj)))


def hide_failed(source: Any) -> None:
    """Hide all failed features that depend on a source."""
    for user in source.InListRecursive:
        if is_ours(user) and "Invalid" in user.State:
            hide(user)


def _with_users(obj: Any) -> list[Any]:
    """Return an object and its dependents. Dependence on the placement of a container does not count."""
    affected = [obj]
    for source in affected:
        users = [user for user in source.InList if source not in getattr(user, CONTAINERS.name, ())]
        affected += [user for user in dict.fromkeys(users) if user not in affected]
    return affected


def _restore_visibility(obj: Any) -> None:
    if obj.HiddenByError:
        obj.HiddenByError = False
        obj.Visibility = True
        for part in obj.Proxy.covered(obj):
            if part.ShownByError:
                part.ShownByError = False
                part.Visibility = False


def parents(source: Any) -> list[Any]:
    """Return the containers of an object, from the innermost to the outermost."""
    containers: list[Any] = []
    while source is not None:
        source = source.getParentGeoFeatureGroup()
        containers.append(source)
    return containers[:-1]


def keep_containers(document: Any, moved: Collection[str]) -> None:
    """Update features after the objects named in `moved` entered or left a container.

    A feature inside a container must not depend on this container.
    """
    for obj in document.Objects:
        if is_ours(obj) and CONTAINERS.name in obj.PropertiesList:
            before = obj.Containers
            _note_containers(obj)
            standing = (above for source in (obj, *_sources_of(obj)) for above in (source, *parents(source)))
            if obj.Containers != before or any(source.Name in moved for source in standing):
                obj.touch()


def keep_sheets() -> None:
    """Update the lists of sheets in all open documents.

    Recompute features whose sheet the user has edited.
    """
    for document in App.listDocuments().values():
        ours = [obj for obj in document.Objects if is_ours(obj)]
        for obj in ours:
            obj.Proxy.keep_sheets(obj)
        if ours:
            document.recompute()


def keep_places(container: Any) -> None:
    """Mark features for recompute if a container moves either the features or their sources, but not both."""
    for obj in container.Document.Objects:
        ours = is_ours(obj) and CONTAINERS.name in obj.PropertiesList
        inside = ours and container in parents(obj)
        if ours and any(inside != (container in parents(source)) for source in _sources_of(obj)):
            obj.touch()


def telling(obj: Any, name: str) -> list[Any]:
    """Return an object and the features that depend on it, but only those whose messages contain `name`."""
    ours = (feature for feature in (obj, *obj.InListRecursive) if is_ours(feature))
    return [feature for feature in ours if any(name in words for words in _sentences(feature))]


def _sentences(obj: Any) -> Iterator[str]:
    for name in [entry for entry in MESSAGES if entry in obj.PropertiesList]:
        text = getattr(obj, name)
        yield from [text] if isinstance(text, str) else text
    yield str(obj.getStatusString())


def _note_containers(obj: Any) -> None:
    """Update Containers and Companions.

    Containers has the containers that move a feature's sources, but neither contain the feature nor depend on it.
    """
    if not is_ours(obj) or CONTAINERS.name not in obj.PropertiesList:
        return
    above = parents(obj)
    containers = dict.fromkeys(container for source in _sources_of(obj) for container in parents(source))
    put(
        obj,
        Containers=[
            container
            for container in containers
            if container not in (obj, *above) and not _depends_on(container, obj)
        ],
    )
    if COMPANIONS.name in obj.PropertiesList:
        put(obj, Companions=[source for source in dict.fromkeys(_linked(obj)) if parents(source) == above])


def _depends_on(container: Any, obj: Any) -> bool:
    sources = [container]
    for user in sources:
        sources += [source for source in dict.fromkeys(user.OutList) if source not in sources]
    return obj in sources


def _sources_of(obj: Any) -> Iterator[Any]:
    for source in _linked(obj):
        yield source
        yield from _sources_of(source)


def _linked(obj: Any) -> Iterator[Any]:
    for name in obj.Proxy.links if is_ours(obj) else ():
        value = getattr(obj, name, None)
        sources = value[:1] if isinstance(value, tuple) else value if isinstance(value, list) else [value]
        yield from (source for source in sources if source is not None)
