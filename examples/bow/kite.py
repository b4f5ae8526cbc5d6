"""The spar of a kite: a rod of glass fibre that a cord holds bent, and the same curve with a tapered rod."""

import sys
from pathlib import Path

import elastica_cad as ec
from elastica_cad import plot
from elastica_cad.mechanics import RoundLaw

GLASS = ec.Sheet("glass fibre rod", 5.0, 38000.0, density=1900.0, max_strain=0.01)


def main(folder="out/bow"):
    (curve,) = ec.read_curves(Path(__file__).with_name("kite.csv"))
    even = ec.bow(curve, GLASS, section=RoundLaw(GLASS, 5.0, 5.0))
    taper = ec.bow(curve, GLASS, section=RoundLaw(GLASS, 2.0, 5.0), limits=ec.Limits())
    for name, bow in (("even", even), ("tapered", taper)):
        print(f"{name}: rod {bow.length:.0f} mm, cord {bow.cord:.0f} mm, rise {bow.rise:.0f} mm")
        print(f"    pull {bow.pull:.1f} N, {bow.deviation:.1f} mm from the drawn curve")
    Path(folder).mkdir(parents=True, exist_ok=True)
    plot.save_figure(plot.bow(even, even.shortened()), Path(folder) / "bow.png", force=True)
    return even, taper


if __name__ == "__main__":
    main(*sys.argv[1:])
