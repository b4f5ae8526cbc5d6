"""A slat on a rail: made for its own shape, then loaded with 8 kg between its start and the rail."""

from pathlib import Path

import elastica_cad as ec

WEIGHT_N = 8 * 9.80665


def main():
    (curve,) = ec.read_curves(Path(__file__).with_name("slat.svg"))
    slat = ec.make_strip(curve, "birch-plywood-6", max_width=100, between=ec.Rail(400), label="slat")
    rod = slat.rod_to_bend
    loaded = ec.bend(rod, loads=ec.PointForce(200, (0, -WEIGHT_N)))
    moved = float(((loaded.position - rod.position) ** 2).sum(axis=1).max() ** 0.5)
    strain = float(abs(loaded.curvature).max() * slat.sheet.thickness / 2)
    print(f"rail {slat.bending_stiffness * slat.rod.between[0].size:.0f} N without load")
    print(f"8 kg move the slat by {moved:.1f} mm; safety {slat.strain_limit / strain:.1f}")
    return slat, loaded


if __name__ == "__main__":
    main()
