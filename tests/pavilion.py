"""The paper's Pavilion: 31 arches on a circle, each a part of an ellipse that turns from arch to arch."""

from functools import lru_cache

import numpy as np

from elastica_cad import Model, Placed, PlaneCurve, Sheet, Strip, optimal_rod


def arch(number):
    """Return the part of strip 1 to 31 above the ground."""
    turn = 3 * np.pi * (number - 1) / 30
    rise = np.array([75 * np.sin(turn), 112.5 * np.cos(turn)])  # height = 20 + <rise, (cos v, sin v)>
    top, reach = np.arctan2(rise[1], rise[0]), np.arccos(-20 / np.hypot(*rise))
    return PlaneCurve.ellipse((0, 20), (75, 112.5), turn, top - reach, top + reach)


@lru_cache(maxsize=4)
def pavilion(count=31, *, labels=True):
    """Return the first strips of the Pavilion as a model: card of 200 gsm under its weight, without slots."""
    card = Sheet.named("card-200gsm")
    placed = []
    for number in range(1, count + 1):
        rod = optimal_rod(arch(number), gravity=card.gravity())
        strip = Strip(rod, card, max_width=45, label=f"P{number:02d}" if labels else "")
        angle = np.pi / 3 * (number - 1) / 30
        outward = np.array([np.cos(angle), np.sin(angle), 0.0])
        placed.append(Placed(strip, 800 * outward, outward, (0, 0, 1)))
    return Model(placed, name="pavilion")
