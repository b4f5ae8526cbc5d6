"""Editing with four handles (paper, section 4.3): a projective map changes a curve and keeps it realizable."""

import numpy as np

import elastica_cad as ec

HANDLES = [(0, 0), (300, 0), (300, 150), (0, 150)]  # mm, a rectangle around the curve
MOVED = [(0, 0), (300, 0), (265, 190), (20, 130)]
POINTS = [(10, 0), (40, 150), (130, 160), (170, 20), (230, -10), (290, 110)]


def four_point_map(before, after):
    """The 3 x 3 matrix that takes four points to four others."""
    rows = []
    for (x, y), (u, v) in zip(before, after, strict=True):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
    return np.append(np.linalg.solve(rows, np.ravel(after)), 1.0).reshape(3, 3)


def build():
    """The curve before and after."""
    curve = ec.PlaneCurve.spline(POINTS)
    return curve, curve.transformed(four_point_map(HANDLES, MOVED))


def main():
    for name, curve in zip(("before", "after"), build(), strict=True):
        rod = ec.optimal_rod(curve)
        print(
            f"{name}: {curve.length:.1f} mm, inflections at {curve.inflections.round(1)}, ratio {rod.ratio:.2f}"
        )


if __name__ == "__main__":
    main()
