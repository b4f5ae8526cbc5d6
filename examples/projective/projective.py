"""Editing with four handles (paper, section 4.3): a projective map changes a curve and keeps it realizable."""

import sys

import numpy as np

import elastica_cad as ec

PITCH, HEIGHT = 90.0, 45.0  # mm, between inflections and of the waves
HANDLES = [(-50, -60), (230, -60), (230, 60), (-50, 60)]  # mm, a rectangle around the curve
MOVED = [(-50, -60), (230, -75), (212, 85), (-42, 52)]


def wave(x):
    return np.column_stack([x, HEIGHT * np.sin(np.pi * x / PITCH)])


def build():
    """A curve with three inflections on one line, and what the moved handles make of it: so has its image."""
    curve = ec.PlaneCurve.fit_function(wave, -0.5 * PITCH, 2.5 * PITCH, tolerance=1e-6)
    return curve, curve.transformed(ec.four_point_map(HANDLES, MOVED))


def main(folder="out/projective"):
    placed = []
    for name, curve in zip(("before", "after"), build(), strict=True):
        rod = ec.optimal_rod(curve)
        print(
            f"{name}: {curve.length:.1f} mm, inflections at {curve.inflections.round(1)}, ratio {rod.ratio:.2f}"
        )
        strip = ec.Strip(rod, ec.Sheet.named("card-200gsm"), max_width=25, label=name)
        placed.append(ec.Placed(strip, (0, 60 * len(placed), 0), (1, 0, 0), (0, 0, 1)))
    fine = ec.FabricationLimits(
        least_width=1.0
    )  # card is cut with a knife here: the ends of the second are 1.2 mm wide
    print(ec.save_model(ec.Model(tuple(placed), name="projective"), folder, shop=fine, force=True))


if __name__ == "__main__":
    main(*sys.argv[1:])
