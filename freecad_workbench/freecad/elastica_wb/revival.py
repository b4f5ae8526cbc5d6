# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Revival of features in files that were saved on a computer without the addon, which removes their proxies."""

from typing import Any

from freecad.elastica_wb.features import (  # noqa: F401 - defines all kinds of features
    baseplate,
    curves,
    fixtures,
    flat,
    flexure,
    model,
    nest,
    strip,
)
from freecad.elastica_wb.features.proxy import Feature
from freecad.elastica_wb.host.objects import dress


def revive(lost: list[Any]) -> None:
    """Give features without proxies their proxies and view providers again, and recompute them.

    A computer without the addon may have changed their sources without recomputing the features.
    """
    for obj in lost:
        proxy = kind_of(obj)
        proxy.onDocumentRestored(obj)  # without a proxy, writing the list of sheets resets no thickness
        obj.Proxy = proxy
        dress(obj)
        obj.touch()
    for document in dict.fromkeys(obj.Document for obj in lost):
        document.recompute()


def kind_of(obj: Any) -> Feature:
    """Return a proxy of the kind with the most properties of an object; of equals, the one that adds fewest.

    An object in a file of an earlier version may lack half of the properties of its kind.
    """
    there = {*obj.PropertiesList}

    def likeness(kind: type[Feature]) -> tuple[int, int]:
        names = {entry.name for entry in kind.properties}
        return len(names & there), -len(names - there)

    kind = max(Feature.__subclasses__(), key=likeness)
    return kind.__new__(kind)
