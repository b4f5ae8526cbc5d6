# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""FreeCAD workbench of elastica_cad: draw a spline, check it, and make the strip that bends into it."""

import sys
from pathlib import Path
from typing import Any

import FreeCAD as App

__all__ = ["make_strip"]

TESTS = "freecad.elastica_wb.tests"

MARK = "HiddenByError"
"""Property that only features of this workbench have."""

CORE = Path(__file__).parent / "core"
"""Copy of the package elastica_cad in an addon. A checkout has no such folder."""

if CORE.is_dir():
    sys.path.insert(0, str(CORE))


class _Opened:
    """Observer that revives features of documents that were saved on a computer without the addon."""

    def slotActivateDocument(self, _document: Any) -> None:
        """Revive the features of all open documents. FreeCAD activates a document after opening it."""
        lost = [
            obj
            for document in App.listDocuments().values()
            for obj in (() if document.Restoring else document.Objects)
            if getattr(obj, "Proxy", self) is None and MARK in obj.PropertiesList
        ]
        if lost:
            from freecad.elastica_wb.revival import revive

            revive(lost)


App.addDocumentObserver(_Opened())

if TESTS not in App.__unit_test__:
    App.__unit_test__ += [TESTS]


def make_strip(source: Any, edges: tuple[str, ...] = (), *, flat_part: bool = True, **properties: Any) -> Any:
    """Make a strip along a sketch or along edges of an object, and its flat parts.

    Parameters
    ----------
    source : document object
        A sketch, a curve, or an object with edges.
    edges : tuple of str
        Names of the edges to follow, such as ``"Edge1"``. It is empty for a sketch or an object with a single
        curve.
    flat_part : bool
        Also make the flat parts: the flat strip, and the backing of a laminated strip.
    **properties
        Values of the strip's properties, such as ``Sheet="birch-plywood-0.8", MaxWidth=40``. A length is a
        number in mm, or a string with a unit.

    Returns
    -------
    document object
        The recomputed strip. If the strip cannot be made, its property Verdict states this, and its property
        Reasons contains the reasons.

    Raises
    ------
    AttributeError
        The strip has no property of that name.

    Examples
    --------
    In the console or a macro::

        import freecad.elastica_wb as elastica
        strip = elastica.make_strip(App.ActiveDocument.Sketch, Sheet="birch-plywood-0.8", MaxWidth="40 mm")
        print(strip.Verdict, strip.Ratio)
    """
    from freecad.elastica_wb.features import flat, strip

    document = source.Document
    feature = strip.create(document, source, tuple(edges))
    for name, value in properties.items():
        if name not in feature.PropertiesList:
            document.removeObject(feature.Name)
            raise AttributeError(f"a strip has no property {name}: see its PropertiesList")
        setattr(feature, name, value)
    for layer in flat.layers_of(feature) if flat_part else ():
        # give the earlier parts their shapes, because the new part must not overlap them
        document.recompute()
        flat.create(document, feature, layer)
    document.recompute()
    return feature
