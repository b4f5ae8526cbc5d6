"""Plane sections of bodies as smooth curves, each in a sketch of its own that strips can follow."""

from collections.abc import Iterable
from typing import Any

import FreeCAD as App
import numpy as np
from freecad.elastica_wb.drawn import placement_of
from freecad.elastica_wb.shapes import plane_curve, spline_geometry

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.geometry import PlaneCurve

__all__ = ["AXES", "chosen_bodies", "section_sketches"]

AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}
POINTS = 200


def chosen_bodies(objects: Iterable[Any]) -> list[Any]:
    """The objects with faces.

    Raises
    ------
    InputError
        There is none.
    """
    found = [obj for obj in objects if getattr(obj, "Shape", None) is not None and obj.Shape.Faces]
    if not found:
        raise InputError("select a body or a surface to cut")
    return found


def section_sketches(
    document: Any, source: Any, axis: str, count: int, tolerance: float
) -> tuple[list[Any], list[str]]:
    """Cut an object by `count` planes across an axis, evenly spread through it.

    Parameters
    ----------
    tolerance : float
        Largest distance of a sketch's spline from the true section, mm.

    Returns
    -------
    sketches, remarks
        A sketch for every open section; a sentence for each section that makes none.
    """
    if axis not in AXES or count < 1:
        raise InputError("choose an axis (X, Y or Z) and one plane or more")
    normal, box = App.Vector(*AXES[axis]), source.Shape.BoundBox
    low, high = (getattr(box, f"{axis}{side}") for side in ("Min", "Max"))
    places = low + (high - low) * (np.arange(count) + 0.5) / count
    sketches, remarks = [], []
    for place in places:
        wires = source.Shape.slice(normal, float(place))
        if not wires:
            remarks.append(f"at {axis} = {place:.4g} mm there is nothing to cut")
        for wire in wires:
            try:
                curve, frame = plane_curve(wire.OrderedEdges)
                smooth = PlaneCurve.fit(curve.sample(POINTS).position, tolerance=tolerance)
            except ElasticaError as error:
                remarks.append(f"at {axis} = {place:.4g} mm: {error}")
                continue
            sketch = document.addObject("Sketcher::SketchObject", "Section")
            sketch.Label = f"{source.Label} {axis} {place:.4g}"
            sketch.Placement = placement_of(frame)
            number = sketch.addGeometry(spline_geometry(smooth), False)
            sketch.exposeInternalGeometry(number)
            sketches.append(sketch)
    return sketches, remarks
