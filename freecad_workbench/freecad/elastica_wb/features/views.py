# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How the features look in the tree and the view."""

from typing import Any

import FreeCADGui as Gui
from freecad.elastica_wb.host import view_providers
from freecad.elastica_wb.host.lifetime import Unsaved
from freecad.elastica_wb.host.resources import icon


class _View(Unsaved):
    """What all views share; they keep nothing."""

    icon_name = "Elastica"

    def __init__(self, provider: Any) -> None:
        provider.Proxy = self

    def attach(self, provider: Any) -> None:
        """FreeCAD hands over the view provider, at creation and after loading."""
        self.Object = provider.Object

    def setEdit(self, provider: Any, mode: int = 0) -> bool | None:
        """Open the panel; FreeCAD's other modes, such as Transform, stay FreeCAD's."""
        if mode != 0:
            return None
        Gui.Control.showDialog(view_providers.panel_of(provider.Object))
        return True

    def unsetEdit(self, _provider: Any, mode: int = 0) -> None:
        """Close the panel."""
        if mode == 0:
            Gui.Control.closeDialog()

    def doubleClicked(self, provider: Any) -> bool:
        """A double click edits."""
        return bool(Gui.getDocument(provider.Object.Document.Name).setEdit(provider.Object.Name, 0))

    def getIcon(self) -> str:
        """Path of the icon."""
        return icon(self.icon_name)


class StripView(_View):
    """The strip in the tree, with its sketch below it."""

    icon_name = "Elastica_Strip"

    def claimChildren(self) -> list[Any]:
        """The sketch, unless a body holds it already."""
        source = self.Object.Curve[0] if self.Object.Curve else None
        group = None if source is None else source.getParentGeoFeatureGroup()
        return (
            [] if source is None or (group is not None and group.TypeId == "PartDesign::Body") else [source]
        )


class FlatView(_View):
    """The flat part in the tree."""

    icon_name = "Elastica_Flat"


class ModelView(_View):
    """The model in the tree, with its strips below it."""

    icon_name = "Elastica_Interlock"

    def claimChildren(self) -> list[Any]:
        """The strips that stand for themselves where they are not slotted."""
        return list(self.Object.Strips)

    def onDelete(self, _provider: Any, _elements: Any) -> bool:
        """Strips that the model hid stand for themselves again, as soon as they can be made."""
        for strip in self.Object.Strips:
            if not any(
                isinstance(_view_of(user), ModelView) for user in strip.InList if user is not self.Object
            ):
                strip.HiddenByError = "Invalid" in strip.State
                strip.ShownByError = False
                strip.Visibility = not strip.HiddenByError
        return True


class FixturesView(_View):
    """The printed blocks in the tree."""

    icon_name = "Elastica_Fixtures"


class BasePlateView(_View):
    """The base plate in the tree."""

    icon_name = "Elastica_Fixtures"


class NestView(_View):
    """The nested sheets in the tree."""

    icon_name = "Elastica_Nest"


class NearestView(_View):
    """The nearest curve in the tree."""

    icon_name = "Elastica_Nearest"


class BentView(_View):
    """The curve of a strip bent further, in the tree."""

    icon_name = "Elastica_Bend"


class SectionView(_View):
    """The curves cut out of bodies, in the tree."""

    icon_name = "Elastica_Section"


def _view_of(obj: Any) -> Any:
    return getattr(obj.ViewObject, "Proxy", None)


KINDS = {
    "Strip": StripView, "Flat": FlatView, "Model": ModelView, "Fixtures": FixturesView,
    "BasePlate": BasePlateView, "Nest": NestView, "Nearest": NearestView, "Bent": BentView,
    "Section": SectionView,
}  # fmt: skip
"""The view provider of every kind of feature."""
