# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""View providers: appearance of the features in the tree and the 3D view."""

from collections.abc import Callable
from typing import Any, ClassVar

import FreeCADGui as Gui
from freecad.elastica_wb.host.objects import Unsaved, is_model
from freecad.elastica_wb.host.resources import icon


class View(Unsaved):
    """Base class of all view providers, which have no data."""

    icon_name = "Elastica"
    panel_of: ClassVar[Callable[[Any], Any]]
    """Function that makes the panel of a feature. The graphical interface sets this function."""

    def __init__(self, provider: Any) -> None:
        provider.Proxy = self

    def attach(self, provider: Any) -> None:
        """Store the object. FreeCAD calls this method for new and for loaded objects."""
        self.Object = provider.Object

    def setEdit(self, provider: Any, mode: int = 0) -> bool | None:
        """Open the panel. Other edit modes, such as Transform, are left to FreeCAD."""
        if mode != 0:
            return None
        Gui.Control.showDialog(self.panel_of(provider.Object))
        return True

    def unsetEdit(self, _provider: Any, mode: int = 0) -> None:
        """Close the panel."""
        if mode == 0:
            Gui.Control.closeDialog()

    def doubleClicked(self, provider: Any) -> bool:
        """Start editing."""
        return bool(Gui.getDocument(provider.Object.Document.Name).setEdit(provider.Object.Name, 0))

    def getIcon(self) -> str:
        """Return the path of the icon."""
        return icon(self.icon_name)


class StripView(View):
    """View provider of the strip, with its sketch below it in the tree."""

    icon_name = "Elastica_Strip"

    def claimChildren(self) -> list[Any]:
        """Return the sketch for the tree, unless it is in a body."""
        source = self.Object.Curve[0] if self.Object.Curve else None
        group = None if source is None else source.getParentGeoFeatureGroup()
        return (
            [] if source is None or (group is not None and group.TypeId == "PartDesign::Body") else [source]
        )


class FlatView(View):
    """View provider of the flat part."""

    icon_name = "Elastica_Flat"


class ModelView(View):
    """View provider of the model, with its strips below it in the tree."""

    icon_name = "Elastica_Interlock"

    def claimChildren(self) -> list[Any]:
        """Return the strips, which the model displays with slots."""
        return list(self.Object.Strips)

    def onDelete(self, _provider: Any, _elements: Any) -> bool:
        """Make the strips visible that the model had hidden, except failed strips."""
        for strip in self.Object.Strips:
            if not any(is_model(user) for user in strip.InList if user is not self.Object):
                strip.HiddenByError = "Invalid" in strip.State
                strip.ShownByError = False
                strip.Visibility = not strip.HiddenByError
        return True


class FixturesView(View):
    """View provider of the printed blocks."""

    icon_name = "Elastica_Fixtures"


class BasePlateView(View):
    """View provider of the base plate."""

    icon_name = "Elastica_Fixtures"


class RingsView(View):
    """View provider of the rings."""

    icon_name = "Elastica_Fixtures"


class NestView(View):
    """View provider of the nested sheets."""

    icon_name = "Elastica_Nest"


class NearestView(View):
    """View provider of the nearest curve."""

    icon_name = "Elastica_Nearest"


class BentView(View):
    """View provider of the curve of a strip with moved ends."""

    icon_name = "Elastica_Bend"


class FlexureView(View):
    """View provider of a part with two states, with its sketches below it in the tree."""

    icon_name = "Elastica_Flexure"

    def claimChildren(self) -> list[Any]:
        """Return the sketches of both curves."""
        links = (self.Object.Curve, self.Object.SecondCurve)
        return list(dict.fromkeys(link[0] for link in links if link))


class SectionView(View):
    """View provider of the sections of bodies."""

    icon_name = "Elastica_Section"


KINDS = {view.__name__.removesuffix("View"): view for view in View.__subclasses__()}
"""View provider of each kind of feature."""
