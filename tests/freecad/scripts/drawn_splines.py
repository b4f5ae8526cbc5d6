"""Splines as scripts draw them, in FreeCAD with and without a window."""

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
