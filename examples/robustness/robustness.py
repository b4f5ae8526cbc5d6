"""The robustness study (paper, Fig. 15): how far a strip strays when stiffness, weight or angles are off."""

import sys
from functools import cache

import numpy as np

import elastica_cad as ec

CARD = ec.Sheet.named("card-200gsm")
FACTORS = (0.5, 0.71, 1.0, 1.41, 2.0)
ANGLES = (-10, -5, 0, 5, 10)  # degrees


def arch():
    """Strip 4 of the Pavilion: a turned ellipse, 20 mm above the ground."""
    turn = 0.3 * np.pi
    rise = np.array([75 * np.sin(turn), 112.5 * np.cos(turn)])
    top, reach = np.arctan2(rise[1], rise[0]), np.arccos(-20 / np.hypot(*rise))
    return ec.PlaneCurve.ellipse((0, 20), (75, 112.5), turn, top - reach, top + reach)


@cache
def designed():
    return ec.optimal_rod(arch(), gravity=CARD.gravity(), samples=301)


def strays(bent):
    """Largest distance from the design, mm."""
    return float(np.hypot(*(bent.position - designed().position).T).max())


def bent():
    """What becomes of the strip, by cause and by how far it is off."""
    rod, ends = designed(), designed().angle[[0, -1]]
    length = CARD.elasto_gravity_length
    return {
        "stiffness range": {
            f"times {m:g}": ec.bend(rod.with_stiffness(1 + (rod.stiffness - 1) * m)) for m in FACTORS
        },
        "weight": {f"times {m:g}": ec.bend(rod, gravity=ec.Gravity(length * m ** (-1 / 3))) for m in FACTORS},
        "end angles": {f"{d:g} degrees": ec.bend(rod, angles=ends + np.radians([-d, d])) for d in ANGLES},
    }


def build():
    """Largest distances from the design in mm, by cause."""
    return {cause: [strays(shape) for shape in shapes.values()] for cause, shapes in bent().items()}


def main(folder="out/robustness"):
    print("largest distance from the design, mm")
    for cause, values in build().items():
        print(f"{cause:16s}" + "".join(f"{v:8.2f}" for v in values))
    print(ec.mechanics.tolerance_study(designed(), sheet=CARD, max_width=45, samples=30))
    strip = ec.Strip(designed(), CARD, max_width=45, label="ARCH")
    placed = ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))
    print(ec.save_model(ec.Model((placed,), name="robustness"), folder, force=True))


if __name__ == "__main__":
    main(*sys.argv[1:])
