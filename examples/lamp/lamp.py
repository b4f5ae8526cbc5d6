"""The Lamp (paper, section 9.3): a leaf of 32 perforated strips of 0.8 mm birch plywood under its strain limit."""

import sys

import numpy as np

import elastica_cad as ec

STRIPS = 32
LENGTH, WIDTH, RISE = 930.0, 660.0, 170.0  # mm
GAP = 3.0  # mm between strips
BIRCH = ec.Sheet.named("birch-plywood-0.8")
LIMITS = ec.Limits(ratio=2.4, margin=5.0, sheet=BIRCH, strain=0.9 * BIRCH.max_strain)


def outline(x):
    """Half the width of the leaf at x from -LENGTH / 2 to LENGTH / 2, mm; it is blunt at both tips."""
    u = 2 * x / LENGTH
    return WIDTH / 2 * (1 - 0.62 * u**2) * (1 + 0.10 * u)


def rib(x):
    """A strip across the leaf: flat where it leaves the base, arched over the middle."""
    half = outline(x)
    rise = RISE * (1 - 0.5 * (2 * x / LENGTH) ** 2) * half / (WIDTH / 2)
    shape = np.array([(-1, 0), (-0.72, 0.30), (-0.38, 1.05), (0, 1.25), (0.38, 1.05), (0.72, 0.30), (1, 0)])
    return ec.PlaneCurve.spline(shape * (half, rise))


def build(count=STRIPS):
    places = LENGTH * ((np.arange(count) + 0.5) / count - 0.5)
    found = ec.nearest_rods([rib(x) for x in places], LIMITS, ec.Keep(symmetry="mirror"))
    style = ec.Perforated(
        LENGTH / STRIPS - GAP, columns=2, hole_ratio=0.8, least_ligament=1.5, corner_radius=0.07
    )
    placed = []
    for near, x in zip(found, places, strict=True):
        strip = ec.Strip(
            near.rod, BIRCH, style=style, ends=(ec.Tab(25), ec.Tab(25)), label=f"L{len(placed) + 1}"
        )
        placed.append(ec.Placed(strip, (x, 0, 0), (0, 1, 0), (0, 0, 1)))
    return ec.Model(tuple(placed), name="lamp")


def main(folder="out/lamp"):
    model = build()
    print(f"{len(model.placed)} strips found; thousands of rounded holes take their time", flush=True)
    written = ec.save_model(
        model, folder, sheet_size=(1250.0, 1250.0), done=lambda name, _: print(name, flush=True), force=True
    )
    print(written)


if __name__ == "__main__":
    main(*sys.argv[1:])
