"""Surfaces of revolution (paper, Fig. 22): the six published ones, each closed without gaps by equal strips.

x kappa = a + <b, gamma> for the meridian gamma = (x, y), x its distance from the axis: the width of a strip, and so
its stiffness, is proportional to x. Change a, b, the start or the angle, and see which surface comes of it.
"""

import sys
from dataclasses import dataclass, replace

import numpy as np

import elastica_cad as ec

CARD = ec.Sheet.named("card-200gsm")


@dataclass(frozen=True)
class Surface:
    """a has no unit, b is in 1/unit, start (distance from the axis, height) and length in units, angle in rad."""

    a: float
    b: tuple[float, float]
    start: tuple[float, float]
    angle: float
    length: float
    strips: int
    unit: float  # mm

    @property
    def meridian(self):
        b, start = np.array(self.b) / self.unit, self.unit * np.array(self.start)
        return ec.meridian(self.a, b, start, self.angle, self.unit * self.length)

    def model(self, label):
        """Around the z axis."""
        found = ec.revolve(self.meridian, self.strips, sheet=CARD)
        strip = replace(found.strips[0], label=label)
        return found.with_strips([strip] * len(found.placed))


SURFACES = {
    "A": Surface(-20, (10, 3), (1.3844, 0.9776), 1.5701, 2.628, 20, unit=120),
    "B": Surface(-1, (0.2, 1), (1, -0.5), 0.4 * np.pi, 8, 9, unit=60),
    "C": Surface(-0.4, (-0.2, 0.4), (4, -0.8), 0.9 * np.pi, 6.2, 5, unit=70),
    "D": Surface(-1.5, (0, 1.5), (3, -0.23), 0.7 * np.pi, 6.9, 15, unit=80),
    "E": Surface(-1, (1, -0.3), (3, 0), 0.7 * np.pi, 9, 6, unit=80),
    "F": Surface(-1.2, (0.1, -0.03), (0.2, 0), 0.0, 0.96, 8, unit=300),
}
COLUMNS, APART = 3, (720.0, 1250.0)  # mm


def build():
    """All six on one table, as one model."""
    placed = []
    for i, (label, surface) in enumerate(SURFACES.items()):
        model = surface.model(label)
        low = model.strips[0].rod.position[:, 1].min()
        where = (APART[0] * (i % COLUMNS), -APART[1] * (i // COLUMNS), -low)
        placed += [one.moved(np.eye(3), where) for one in model.placed]
    return ec.Model(tuple(placed), name="revolution")


def main(folder="out/revolution"):
    for label, surface in SURFACES.items():
        model = surface.model(label)
        (strip,) = {id(one): one for one in model.strips}.values()
        rod = strip.rod
        print(
            f"{label}: {surface.strips} strips of {rod.length:.0f} mm, ratio {rod.ratio:.2f}, "
            f"{rod.curve.inflections.size} inflections, strain {100 * strip.max_strain:.2f} %"
        )
        print(ec.save_model(model, f"{folder}/{label}", sheet_size=(800.0, 600.0), force=True))


if __name__ == "__main__":
    main(*sys.argv[1:])
