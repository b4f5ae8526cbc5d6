"""Splines and their strips as scripts make them, in FreeCAD with and without a window."""

import FreeCAD as App
import Part


def spline(points, degree=4):
    """A B-spline by its poles, with even knots."""
    curve = Part.BSplineCurve()
    spans = len(points) - degree
    knots = [i / spans for i in range(spans + 1)]
    counts = [degree + 1, *[1] * (spans - 1), degree + 1]
    curve.buildFromPolesMultsKnots([App.Vector(*p, 0) for p in points], counts, knots, False, degree)
    return curve


def strip_with_flat_part(document, points):
    """A sketch of a spline, its strip, and the strip's flat part, recomputed; the sketch and the strip."""
    from freecad.elastica_wb.features import flat, strip

    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(spline(points), False)
    feature = strip.create(document, sketch)
    flat.create(document, feature)
    document.recompute()
    return sketch, feature
