"""Draws arch.dxf, the sketch that `make demo` starts from: one symmetric spline of degree 4, in mm.

Change the control points and run `python examples/arch/draw.py`, or draw your own curve in any CAD program.
With `--picture` it makes arch.png, the README's picture, too.
"""

import sys
from pathlib import Path

import ezdxf

SPAN = 400.0
LEFT = [(0, 0), (40, 5), (80, 40), (125, 160), (SPAN / 2, 175)]


def main() -> None:
    points = LEFT + [(SPAN - x, y) for x, y in reversed(LEFT[:-1])]
    document = ezdxf.new("R2010", units=4)
    document.modelspace().add_open_spline(points, degree=4)
    document.saveas(Path(__file__).with_name("arch.dxf"))


def picture() -> None:
    import elastica_cad as ec
    from elastica_cad.plot import save_figure, strip_sheet

    here = Path(__file__)
    (curve,) = ec.read_curves(here.with_name("arch.dxf"))
    sheet = ec.Sheet.named("birch-plywood-0.8")
    strip = ec.Strip(
        ec.optimal_rod(curve), sheet, max_width=40.0, ends=(ec.Tab(10), ec.Tab(10)), label="ARCH"
    )
    save_figure(strip_sheet(strip), here.with_name("arch.png"), force=True, resolution=90)


if __name__ == "__main__":
    main()
    if "--picture" in sys.argv:
        picture()
