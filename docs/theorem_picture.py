"""Draws the steps of Theorem 1, explanation/theorem1.png: python docs/theorem_picture.py."""

from pathlib import Path

import matplotlib
import numpy as np

import elastica_cad as ec

matplotlib.use("agg")
import matplotlib.pyplot as plt  # after the choice of what draws

PICTURE = Path(__file__).parent / "explanation" / "theorem1.png"
GOOD = [(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)]
BAD = [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)]
LEFT, RIGHT, RED, INK = "#9ecae1", "#fdd0a2", "#b2182b", "#222222"
COMB_MM, REACH_MM = 350.0, 120.0


def main() -> None:
    """Four steps, two by two."""
    figure, axes = plt.subplots(2, 2, figsize=(10, 8), layout="constrained")
    (one, two), (three, four) = axes
    good, bad = ec.PlaneCurve.spline(GOOD), ec.PlaneCurve.spline(BAD)
    curve_on(one, good, "1. Curvature")
    comb(one, good)
    curve_on(two, good, "2. The line")
    sides(two, good)
    curve_on(three, good, "3. The width")
    sides(three, good)
    widths(three, good)
    curve_on(four, bad, "4. Refused")
    sides(four, bad)
    crossings(four, bad)
    figure.savefig(PICTURE, dpi=110)
    print(PICTURE)


def curve_on(axes: plt.Axes, curve: ec.PlaneCurve, title: str) -> None:
    """The curve with its inflections."""
    x, y = curve.sample(400).position.T
    axes.plot(x, y, color=INK, linewidth=2, zorder=3)
    places = curve.at(curve.inflections).position
    axes.plot(*places.T, "o", color=INK, markersize=7, zorder=4)
    axes.set_title(title, fontsize=13)
    axes.set_aspect("equal")
    axes.margins(0.12)
    axes.set_axis_off()


def comb(axes: plt.Axes, curve: ec.PlaneCurve) -> None:
    """Teeth as long as the curvature."""
    s = curve.sample(161)
    normal = np.column_stack([-np.sin(s.angle), np.cos(s.angle)])
    tips = s.position - COMB_MM * s.curvature[:, None] * normal
    for foot, tip, kappa in zip(s.position, tips, s.curvature, strict=True):
        axes.plot(*zip(foot, tip, strict=True), color=LEFT if kappa > 0 else RIGHT, linewidth=1.2)


def sides(axes: plt.Axes, curve: ec.PlaneCurve) -> None:
    """The line of the inflections and the half planes in which the curve bends left and right."""
    line = ec.check_equilibrium(curve).line
    point, along = np.array(line.point), np.array(line.direction)
    across = np.array([-along[1], along[0]])
    if ((curve.sample(400).position - point) @ across * curve.sample(400).curvature).mean() < 0:
        across = -across
    ends = point + np.outer([-REACH_MM, REACH_MM], along)
    for side, color in ((1, LEFT), (-1, RIGHT)):
        corners = np.vstack([ends, ends[::-1] + side * REACH_MM * across])
        axes.fill(*corners.T, color=color, alpha=0.35, linewidth=0, zorder=0)
    axes.plot(*ends.T, "--", color=INK, linewidth=1.2, zorder=1)
    low, high = curve.bounds
    axes.set_xlim(low[0] - 20, high[0] + 20)
    axes.set_ylim(low[1] - 25, high[1] + 25)


def widths(axes: plt.Axes, curve: ec.PlaneCurve) -> None:
    """The strip, laid along the curve: wide where the line is far and the curve bends little."""
    rod = ec.optimal_rod(curve)
    normal = np.column_stack([-np.sin(rod.angle), np.cos(rod.angle)])
    half = (1.6 * rod.stiffness)[:, None] * normal
    edge = np.vstack([rod.position + half, (rod.position - half)[::-1]])
    axes.fill(*edge.T, color="#8c6d3f", alpha=0.7, zorder=2)


def crossings(axes: plt.Axes, curve: ec.PlaneCurve) -> None:
    """Where the line meets the curve and must not."""
    found = curve.at(np.array(ec.check_equilibrium(curve).crossings)).position
    axes.plot(*found.T, "o", color=RED, markersize=11, zorder=5)


if __name__ == "__main__":
    main()
