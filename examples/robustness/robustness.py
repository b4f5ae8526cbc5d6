"""The robustness study (paper, Fig. 15): how far a strip strays when stiffness, weight or angles are off."""

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


def build():
    """Largest distances from the design in mm, by cause."""
    rod = ec.optimal_rod(arch(), gravity=CARD.gravity(), samples=301)

    def strays(bent):
        return float(np.hypot(*(bent.position - rod.position).T).max())

    stiffer = [ec.bend(rod.with_stiffness(1 + (rod.stiffness - 1) * m)) for m in FACTORS]
    heavier = [ec.bend(rod, gravity=ec.Gravity(CARD.elasto_gravity_length * m ** (-1 / 3))) for m in FACTORS]
    ends = rod.angle[[0, -1]]
    turned = [ec.bend(rod, angles=ends + np.radians([-d, d])) for d in ANGLES]
    return {
        "stiffness": [strays(b) for b in stiffer],
        "weight": [strays(b) for b in heavier],
        "angles": [strays(b) for b in turned],
    }


def main():
    print("largest distance from the design, mm")
    for cause, values in build().items():
        print(f"{cause:10s}" + "".join(f"{v:8.2f}" for v in values))
    rod = ec.optimal_rod(arch(), gravity=CARD.gravity(), samples=301)
    print(ec.tolerance_study(rod, sheet=CARD, max_width=45, samples=30))


if __name__ == "__main__":
    main()
