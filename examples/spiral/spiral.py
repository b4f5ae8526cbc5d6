"""The Spiral (paper, Fig. 7): an Archimedean spiral whose ends turn in and out.

The published one is of 200 gsm card, which goes plastic in the innermost winding; paper of half its thickness
keeps within what it bears.
"""

import sys

import numpy as np

import elastica_cad as ec

START, END = 4.5 * np.pi, 9.5 * np.pi  # rad; the radius is as many mm
REACH = 5 * np.pi / 3  # rad, of the turn at either end
MAX_WIDTH = 50.0  # mm
CARD = ec.Sheet.named("card-200gsm")
PAPER = ec.Sheet("paper-100gsm", 0.1, CARD.youngs_modulus, density=CARD.density, max_strain=CARD.max_strain)

# c4 x^4 + c3 x^3 + c2 x^2 - x, which vanishes at REACH with two derivatives
ROWS = [
    [REACH**4, REACH**3, REACH**2],
    [4 * REACH**3, 3 * REACH**2, 2 * REACH],
    [12 * REACH**2, 6 * REACH, 2],
]
TURN = np.linalg.solve(ROWS, [REACH, 1.0, 0.0])


def turned(x):
    return np.where(x < REACH, np.polyval([*TURN, -1.0, 0.0], x), 0.0)


def spiral(t):
    radius = t + turned(t - START) - turned(END - t)
    return radius[:, None] * np.column_stack([np.cos(t), np.sin(t)])


def build(sheet=PAPER):
    """One strip, lying on its edge: weight acts across its plane and does not bend it."""
    breaks = [(START + REACH, 2), (END - REACH, 2)]
    curve = ec.PlaneCurve.fit_function(spiral, START, END, tolerance=1e-7, breaks=breaks)
    strip = ec.Strip(ec.optimal_rod(curve), sheet, max_width=MAX_WIDTH, label="SPIRAL")
    return ec.Model((ec.Placed(strip),), name="spiral")


def main(folder="out/spiral", sheet="paper"):
    """`python spiral.py out/spiral card` for the published one."""
    model = build(CARD if sheet == "card" else PAPER)
    for text in model.strips[0].warnings:
        print(text)
    print(ec.save_model(model, folder, force=True))


if __name__ == "__main__":
    main(*sys.argv[1:])
