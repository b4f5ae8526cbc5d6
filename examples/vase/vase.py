"""The Vase (paper, section 9.4): equal strips of card close a surface of revolution without gaps, between rings."""

import sys

import elastica_cad as ec

STRIPS = 20
# x kappa = a + <b, gamma>; passes (70, 0), (125, 55), (90, 115) and (75, 140), as others do: five points fix one
A, B = -4.488549, (0.06233611, -0.0145922)  # no unit, 1/mm
START, ANGLE, LENGTH = (70.0, 0.0), 0.277409, 185.5945  # mm from the axis and up, rad, mm


def build():
    card, board = ec.Sheet.named("card-200gsm"), ec.Sheet.named("mdf-3")
    return ec.revolution(A, B, START, ANGLE, STRIPS, length=LENGTH, sheet=card, rings=board, name="vase")


if __name__ == "__main__":
    print(ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/vase", force=True))
