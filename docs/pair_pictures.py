"""Draws the pictures of parts with two states: python docs/pair_pictures.py.

explanation/two_states.png shows what decides whether two curves go together, tutorials/clip.png and
explanation/stand.png the two examples.
"""

from pathlib import Path
from typing import Any

import matplotlib
import numpy as np

import elastica_cad as ec
from elastica_cad.design.pair_table import read_pair
from elastica_cad.files import read_curves
from elastica_cad.plot.canvas import save_figure
from elastica_cad.plot.pair_pictures import pair_sheet

matplotlib.use("agg")
import matplotlib.pyplot as plt  # after the choice of what draws

DOCS = Path(__file__).parent
EXAMPLES = DOCS.parent / "examples" / "two_states"
FIRST, SECOND, INK, BAD = "#1f5fa8", "#c2571a", "#222222", "#b2182b"
UP = [(0, 0), (27, 0), (53, 24), (105, 24), (123, 0), (150, 0)]
DOWN = [(0, 0), (27, 0), (53, -20), (105, -20), (123, 0), (150, 0)]
LOWER = [(0, 0), (30, 26), (60, 36), (95, 36), (122, 26), (150, 0)]
WAVY = [(0, 0), (16, 22), (34, -22), (56, 24), (78, -24), (100, 24), (120, -22), (136, 22), (150, 0)]


def main() -> None:
    """Three pictures."""
    figure, axes = plt.subplots(3, 2, figsize=(10, 7), layout="constrained")
    column(axes[:, 0], "They go together", *ec.matched_pair(spline(UP), spline(DOWN)))
    column(axes[:, 1], "They do not", *ec.matched_pair(spline(LOWER), spline(WAVY), keep="shape"))
    figure.savefig(DOCS / "explanation" / "two_states.png", dpi=110)
    for name, folder in (("clip", "tutorials"), ("stand", "explanation")):
        spec = read_pair(EXAMPLES / f"{name}.toml", read_curves)
        save_figure(
            pair_sheet(spec.make(), spec.faired), DOCS / folder / f"{name}.png", force=True, resolution=100
        )


def spline(points: list[tuple[int, int]]) -> ec.PlaneCurve:
    """Of degree 4."""
    return ec.PlaneCurve.spline(points, degree=4)


def column(axes: Any, title: str, first: ec.PlaneCurve, second: ec.PlaneCurve) -> None:
    """Two curves, the difference of their curvatures, and that of the moments or why there is none."""
    drawn, bent, held = axes
    check = ec.check_pair(first, second)
    s = np.linspace(0, check.length, 600)
    one, two = (curve.at(np.minimum(s, curve.length)) for curve in (check.first, check.second))
    d = one.curvature - two.curvature
    for curve, colour in ((one, FIRST), (two, SECOND)):
        drawn.plot(*curve.position.T, color=colour, lw=2)
    drawn.set_aspect("equal")
    drawn.set_axis_off()
    drawn.set_title(f"{title}: {len(check.zeros)} places where they are bent alike", fontsize=12)
    at = [zero.s for zero in check.zeros]
    for curve in (check.first, check.second):
        drawn.plot(*curve.at(np.array(at)).position.T, "o", color=INK, ms=4)
    bent.fill_between(s, d, color="#c6dbef", lw=0)
    bent.plot(s, d, color=INK, lw=1)
    bent.plot(at, np.zeros(len(at)), "o", color=INK, ms=4)
    bent.set_ylabel("difference of\ncurvatures, 1/mm", fontsize=8)
    for axis in (bent, held):
        axis.axhline(0, color=INK, lw=0.5)
        axis.tick_params(labelsize=7)
    if check.realizable:
        pair = ec.two_state_rod(first, second)
        held.plot(pair.first.s, pair.first.moment - pair.second.moment, color=INK, lw=1)
        held.plot(at, np.zeros(len(at)), "o", color=INK, ms=4)
        held.set_ylabel("difference of\nmoments, 1/mm", fontsize=8)
        held.set_title(f"the quotient is the stiffness, of a ratio of {pair.ratio:.2f}", fontsize=9)
    else:
        held.set_axis_off()
        held.text(0, 0.6, "five numbers make the difference of the moments:\nit vanishes in four places as a rule",
                  color=BAD, fontsize=10, transform=held.transAxes)  # fmt: skip
    held.set_xlabel("mm along the strip", fontsize=8)


if __name__ == "__main__":
    main()
