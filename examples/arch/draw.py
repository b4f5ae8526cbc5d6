"""Draws arch.dxf, the sketch that `make demo` starts from: one symmetric spline of degree 4, in mm.

Change the control points and run `python examples/arch/draw.py`, or draw your own curve in any CAD program.
"""

from pathlib import Path

import ezdxf

SPAN = 400.0
LEFT = [(0, 0), (40, 5), (80, 40), (125, 160), (SPAN / 2, 175)]


def main() -> None:
    points = LEFT + [(SPAN - x, y) for x, y in reversed(LEFT[:-1])]
    document = ezdxf.new("R2010", units=4)
    document.modelspace().add_open_spline(points, degree=4)
    document.saveas(Path(__file__).with_name("arch.dxf"))


if __name__ == "__main__":
    main()
