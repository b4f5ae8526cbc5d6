"""The Carpet (paper, section 9.5): fifteen flowing strips whose lowest points hover just above the ground.

Low walls hold their ends; between two hills, one growing as the other shrinks, they come down to a few millimetres.
"""

import sys

import numpy as np

import elastica_cad as ec

STRIPS = 15
LENGTH, DEPTH, RISE = 460.0, 290.0, 115.0  # mm
GROUND = 2.0  # mm that the strips keep above the ground, z = 0
CARD = ec.Sheet.named("card-200gsm")
LIMITS = ec.Limits(ratio=3.0, margin=5.0, keep_out=(ec.HalfPlane((0, GROUND), (0, 1)),))


def wave(u):
    """Control points of the strip at u = 0 (front) to 1 (back): a hill, a hollow near the ground, a hill."""
    first, second = RISE * (1.0 - 0.35 * u), RISE * (0.65 + 0.35 * u)
    hollow, low = LENGTH * (0.54 - 0.08 * u), -0.12 * RISE
    return [
        (0, 0.35 * first),
        (0.02 * LENGTH, 0.8 * first),
        (0.2 * LENGTH, 1.5 * first),
        (hollow - 0.13 * LENGTH, low),
        (hollow + 0.13 * LENGTH, low),
        (0.8 * LENGTH, 1.5 * second),
        (0.98 * LENGTH, 0.8 * second),
        (LENGTH, 0.35 * second),
    ]


def build(count=STRIPS):
    """Every strip bears its own weight, and stays above the ground with it."""
    places = np.linspace(0, 1, count)
    curves = [ec.PlaneCurve.spline(wave(u)) for u in places]
    # fine nodes: near the walls the stiffness falls to a third within millimetres
    found = ec.nearest_rods(curves, LIMITS, gravity=CARD.gravity(), samples=801)
    placed = []
    for near, u in zip(found, places, strict=True):
        strip = ec.Strip(near.rod, CARD, max_width=0.9 * DEPTH / STRIPS, label=f"C{len(placed) + 1}")
        placed.append(ec.Placed(strip, (0, DEPTH * u, 0), (1, 0, 0), (0, 0, 1)))
    return ec.Model(tuple(placed), name="carpet")


if __name__ == "__main__":
    print(
        ec.save_model(
            build(), sys.argv[1] if len(sys.argv) > 1 else "out/carpet", sheet_size=(700.0, 500.0), force=True
        )
    )
