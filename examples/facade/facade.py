"""The Facade (paper, section 9.5): upright fins that open when their upper ends are pressed down."""

import sys
from dataclasses import dataclass

import numpy as np

import elastica_cad as ec

FINS = 8
HEIGHT, PITCH = 430.0, 550.0 / 8  # mm
TRAVEL = 14.0  # mm that the upper ends go down from closed to open
STEPS = 9
SHEET = ec.Sheet.named("gfrp-1")


@dataclass(frozen=True)
class Fin:
    """A fin on its way: end travel (mm), the force that presses (N), stability margin, one of each a step."""

    shapes: tuple[ec.Rod, ...]
    strip: ec.Strip
    travel: np.ndarray
    force: np.ndarray
    margin: np.ndarray


def closed(k):
    """The fin as it is cut and mounted, nearly upright; the bulge sits higher from fin to fin."""
    high = 0.55 + 0.12 * k / (FINS - 1)
    return ec.PlaneCurve.spline(
        [(0, 0), (0, 0.18 * HEIGHT), (26, (high - 0.12) * HEIGHT), (26, (high + 0.12) * HEIGHT),
         (0, 0.86 * HEIGHT), (0, HEIGHT)]
    )  # fmt: skip


def fin(k):
    """Fin k: the strip that rests in the closed shape, and its way to the open one."""
    near = ec.nearest_rod(closed(k), ec.Limits(ratio=3.0, margin=5.0), ec.Keep(tangents=True))
    strip = ec.Strip(near.rod, SHEET, max_width=55, ends=(ec.Tab(20), ec.Tab(20)), label=f"FIN{k + 1}")
    travel = np.linspace(0, TRAVEL, STEPS)
    shapes = ec.mechanics.bend_path(near.rod, [near.rod.position[-1] - (0, d) for d in travel])
    force = np.array([strip.bending_stiffness * rod.force[-1, 1] for rod in shapes])
    margin = np.array([ec.stability(rod).margin for rod in shapes])
    return Fin(shapes, strip, travel, force, margin)


def build(opened=0.0, fins=None):
    """The facade closed (0) to open (1), as a model; `fins` as computed before."""
    placed = []
    for k, one in enumerate(fins or [fin(k) for k in range(FINS)]):
        rod = one.shapes[round(opened * (STEPS - 1))]
        strip = (
            one.strip
            if opened == 0
            else ec.Strip(rod, SHEET, max_width=55, ends=one.strip.ends, label=one.strip.label)
        )
        placed.append(ec.Placed(strip, (0, PITCH * k, 0), (1, 0, 0), (0, 0, 1)))
    return ec.Model(tuple(placed), name="facade")


def states(apart=420.0):
    """Closed, half open and open one behind the other, to be looked at."""
    fins = [fin(k) for k in range(FINS)]
    shown = [
        one.moved(np.eye(3), (apart * i, 0, 0))
        for i, opened in enumerate((0.0, 0.5, 1.0))
        for one in build(opened, fins).placed
    ]
    return ec.Model(tuple(shown), name="facade: closed, half open, open")


def main(folder="out/facade"):
    fins = [fin(k) for k in range(FINS)]
    for name, opened in (("closed", 0.0), ("half-open", 0.5), ("open", 1.0)):
        print(ec.save_model(build(opened, fins), f"{folder}/{name}", sheet_size=(600.0, 500.0), force=True))
    for k, one in enumerate(fins):
        rows = [
            f"{d:5.1f} mm {f:6.2f} N {m:6.1f}"
            for d, f, m in zip(one.travel, one.force, one.margin, strict=True)
        ]
        print(f"fin {k + 1}: travel, force, stability margin\n  " + "\n  ".join(rows))


if __name__ == "__main__":
    main(*sys.argv[1:])
