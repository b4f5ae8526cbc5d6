"""Editing with four handles (paper, section 4.3): a projective map changes a curve and keeps it realizable."""

import elastica_cad as ec

HANDLES = [(0, 0), (300, 0), (300, 150), (0, 150)]  # mm, a rectangle around the curve
MOVED = [(0, 0), (300, 0), (265, 190), (20, 130)]
POINTS = [(10, 0), (40, 150), (130, 160), (170, 20), (230, -10), (290, 110)]


def build():
    """The curve before and after."""
    curve = ec.PlaneCurve.spline(POINTS)
    return curve, curve.transformed(ec.four_point_map(HANDLES, MOVED))


def main():
    for name, curve in zip(("before", "after"), build(), strict=True):
        rod = ec.optimal_rod(curve)
        print(
            f"{name}: {curve.length:.1f} mm, inflections at {curve.inflections.round(1)}, ratio {rod.ratio:.2f}"
        )


if __name__ == "__main__":
    main()
