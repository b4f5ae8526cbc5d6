"""The Lantern (paper, section 9.1): twenty strips of POM, drawn by hand in two kinds, between two rings."""

import sys

import numpy as np

import elastica_cad as ec

RING = 60.0  # mm, where all strips are held, above and below
# control points: distance from the axis and height, mm; ends so steep that slots of the rings hold the tabs
OUTER = [(RING, 0), (79, 30), (140, 66), (150, 135), (136, 206), (80, 230), (RING, 260)]
INNER = [(RING, 0), (74, 24), (106, 66), (116, 132), (104, 200), (74, 236), (RING, 260)]
WIDEST = 24.0  # mm
ROOM = 2 * RING * np.tan(np.pi / 20) - 2.0  # mm beside each other on the rings
LIMITS = ec.Limits(ratio=3.0, margin=5.0, sheet=ec.Sheet.named("pom-0.5"))


def build():
    """Ten strips of each kind in turn; the ends are kept, so that both rings close."""
    sheet, board = ec.Sheet.named("pom-0.5"), ec.Sheet.named("hdf-2.5")
    found = ec.nearest_rods([ec.PlaneCurve.spline(points) for points in (OUTER, INNER)], LIMITS)
    tab = ec.Tab(12, width=10)
    strips = []
    for near, label in zip(found, ("OUTER", "INNER"), strict=True):
        K = near.rod.stiffness
        widest = min(WIDEST, float(ROOM * K.max() / max(K[0], K[-1])))
        strips.append(ec.Strip(near.rod, sheet, max_width=widest, ends=(tab, tab), label=label))
    angles = 2 * np.pi * np.arange(20) / 20
    frames = [((np.cos(a), np.sin(a), 0.0), (0.0, 0.0, 1.0)) for a in angles]
    placed = tuple(ec.Placed(strips[i % 2], (0, 0, 0), *frame) for i, frame in enumerate(frames))
    rings = tuple(
        ec.model.ring_plate(
            [ec.model.PlacedTab.of(one.strip, end, one.frame) for one in placed],
            board,
            name=f"ring-{end}",
        )
        for end in ("start", "end")
    )
    return ec.Model(placed, name="lantern", plates=rings)


if __name__ == "__main__":
    print(ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/lantern", force=True))
