"""The Vase (paper, section 9.4): equal strips of card close a surface of revolution without gaps, between rings."""

import sys

import elastica_cad as ec

STRIPS = 20
# x kappa = a + <b, gamma>; passes (70, 0), (85, 16), (125, 55), (90, 115) and (75, 140): five points fix one. It
# leaves its foot at 65 degrees: at 16, as without the second point, slots would be 11 mm wide for card of 0.2 mm.
A, B = -10.192963, (0.10992181, -0.00576012)  # no unit, 1/mm
START, ANGLE, LENGTH = (70.0, 0.0), 1.129905, 184.0179  # mm from the axis and up, rad, mm


def build():
    card, board = ec.Sheet.named("card-200gsm"), ec.Sheet.named("hdf-1.5")
    return ec.revolve(ec.meridian(A, B, START, ANGLE, LENGTH), STRIPS, sheet=card, rings=board, name="vase")


if __name__ == "__main__":
    print(ec.save_model(build(), sys.argv[1] if len(sys.argv) > 1 else "out/vase", force=True))
