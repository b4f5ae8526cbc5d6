# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""FreeCAD workbench of elastica_cad: draw a spline, see whether it can be bent, get the strip."""

import sys
from pathlib import Path
from typing import Any

import FreeCAD as App

__all__ = ["make_strip"]

TESTS = "freecad.elastica_wb.tests"

CORE = Path(__file__).parent / "core"
"""Where `make addon` puts the package elastica_cad; a checkout has it at its root."""

if CORE.is_dir():
    sys.path.insert(0, str(CORE))

if TESTS not in App.__unit_test__:
    App.__unit_test__ += [TESTS]


def make_strip(source: Any, edges: tuple[str, ...] = (), *, flat_part: bool = True, **properties: Any) -> Any:
    """Make the strip that bends into a sketch, or into edges of an object, with its flat part.

    Parameters
    ----------
    source : document object
        A sketch, a curve, or whatever has the edges.
    edges : tuple of str
        Names such as "Edge1"; none for a sketch or for an object that is one curve.
    flat_part : bool
        Make the part to cut too.
    **properties
        Values of the strip's properties, such as ``Sheet="birch-plywood-0.8", MaxWidth=40``; lengths in mm, or as
        texts with a unit.

    Returns
    -------
    document object
        The strip, recomputed; where it cannot be made, its property Verdict says so and Reasons why.

    Raises
    ------
    AttributeError
        A strip has no such property.

    Examples
    --------
    In the console or a macro::

        import freecad.elastica_wb as elastica
        strip = elastica.make_strip(App.ActiveDocument.Sketch, Sheet="birch-plywood-0.8", MaxWidth="40 mm")
        print(strip.Verdict, strip.Ratio)
    """
    from freecad.elastica_wb.features import flat, strip

    document = source.Document
    made = strip.create(document, source, tuple(edges))
    for name, value in properties.items():
        if name not in made.PropertiesList:
            document.removeObject(made.Name)
            raise AttributeError(f"a strip has no property {name}: see its PropertiesList")
        setattr(made, name, value)
    if flat_part:
        flat.create(document, made)
    document.recompute()
    return made
