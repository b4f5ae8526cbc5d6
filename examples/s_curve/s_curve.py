"""The S-curve (paper, Figs. 10 and 11): a curve in equilibrium that would snap away, and the stable one by it."""

import sys

import numpy as np

import elastica_cad as ec

PITCH, HEIGHT = 85.0, 42.0  # mm, between inflections and of the waves
MARGIN = 5.0


def wave(x):
    return np.column_stack([x, HEIGHT * np.sin(np.pi * x / PITCH)])


def build():
    """The drawn curve's rod, and what was found near it."""
    curve = ec.PlaneCurve.fit_function(wave, -0.5 * PITCH, 2.5 * PITCH, tolerance=1e-6)
    return ec.optimal_rod(curve), ec.nearest_rod(curve, ec.Limits(ratio=3.5, margin=MARGIN))


def snapped(rod):
    """Where the unstable one goes when it is let go: bent again from far along the way it gives."""
    mode = ec.stability(rod).mode
    return ec.bend(rod, guess=rod.angle + 2.0 * mode / np.abs(mode).max())


def strip(rod, label):
    return ec.Strip(rod, ec.Sheet.named("card-200gsm"), max_width=25, label=label)


def main(folder="out/s_curve"):
    drawn, found = build()
    for name, rod in (("drawn", drawn), ("snapped", snapped(drawn)), ("stable", found.rod)):
        verdict = ec.stability(rod)
        print(
            f"{name}: ratio {rod.ratio:.2f}, margin {verdict.margin:.1f}, conjugate {verdict.conjugate_point}"
        )
    print(f"moved by at most {found.deviation:.2f} mm")
    model = ec.Model((ec.Placed(strip(found.rod, "S")),), name="s-curve")
    print(ec.save_model(model, folder, force=True))


if __name__ == "__main__":
    main(*sys.argv[1:])
