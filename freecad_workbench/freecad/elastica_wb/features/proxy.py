# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What the proxies of all later features share."""

from collections.abc import Iterable
from typing import Any

from freecad.elastica_wb.features.property_table import Property, ensure
from freecad.elastica_wb.host.refusal import FAILURES, explained, refused
from freecad.elastica_wb.host.view_providers import dress

__all__ = ["Feature", "added"]


class Feature:
    """Proxy of a feature; it keeps nothing, everything lives in the properties."""

    properties: tuple[Property, ...] = ()

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self.ensure(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring a file of an earlier version up to date."""
        self.ensure(obj)
        dress(obj, type(self).__name__.removesuffix("Feature"))

    def ensure(self, obj: Any) -> None:
        """Add what is missing."""
        ensure(obj, self.properties)

    def execute(self, obj: Any) -> None:
        """Make the shape, or fail with a sentence and keep the last good one."""
        try:
            self.make(obj)
        except FAILURES as error:
            raise refused(obj, explained(error)) from None

    def make(self, obj: Any) -> None:
        """Set the shape and the results."""
        raise NotImplementedError

    def dumps(self) -> None:
        """Nothing to save."""

    def loads(self, state: Any) -> None:
        """Nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads


def added(document: Any, name: str, proxy: type[Feature], sources: Iterable[Any] = ()) -> Any:
    """A new feature, in the App::Part that all its sources share."""
    obj = document.addObject("Part::FeaturePython", name)
    proxy(obj)
    groups = {source.getParentGeoFeatureGroup() for source in sources}
    group = groups.pop() if len(groups) == 1 else None
    if group is not None and group.TypeId == "App::Part":
        group.addObject(obj)
    dress(obj, name)
    return obj
