"""The Lantern (paper, section 9.1): twenty strips of POM, drawn by hand in two kinds, between two rings."""

import sys

import numpy as np

import elastica_cad as ec

RING = 60.0  # mm, where all strips are held, above and below
# control points: distance from the axis and height, mm
OUTER = [(RING, 0), (95, 5), (150, 50), (150, 150), (120, 235), (85, 255), (RING, 260)]
INNER = [(RING, 0), (80, 10), (105, 60), (125, 140), (105, 215), (80, 250), (RING, 260)]
LIMITS = ec.Limits(ratio=3.0, margin=5.0, sheet=ec.Sheet.named("pom-0.5"))


def build():
    """Ten strips of each kind in turn; the ends are kept, so that both rings close."""
    sheet = ec.Sheet.named("pom-0.5")
    found = ec.nearest_rods([ec.PlaneCurve.spline(points) for points in (OUTER, INNER)], LIMITS)
    strips = [
        ec.Strip(
            near.rod, sheet, max_width=width, ends=(ec.Tab(12, width=10), ec.Tab(12, width=10)), label=label
        )
        for near, width, label in zip(found, (24, 20), ("OUTER", "INNER"), strict=True)
    ]
    angles = 2 * np.pi * np.arange(20) / 20
    frames = [((np.cos(a), np.sin(a), 0.0), (0.0, 0.0, 1.0)) for a in angles]
    placed = tuple(ec.Placed(strips[i % 2], (0, 0, 0), *frame) for i, frame in enumerate(frames))
    return ec.Model(placed, name="lantern")


if __name__ == "__main__":
    ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/lantern")
