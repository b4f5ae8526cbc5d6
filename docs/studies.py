"""Pictures of the studies: NAME/NAME.png beside each script of examples/, on request.

python docs/studies.py [NAME ...]
"""

import runpy
import sys
from pathlib import Path

import numpy as np

import elastica_cad as ec
from elastica_cad import plot
from elastica_cad.plot.strip_pictures import paint_flat

EXAMPLES = Path(__file__).parents[1] / "examples"
WIDTH = 9.0  # inches
INK, FAINT, MARK, OTHER = "#1f2430", "#8a8f98", "#c2452d", "#2f6db3"
SHADES = ("#9ecae1", "#5b9fd0", INK, "#e59a5f", "#c2452d")


def page(*heights, columns=1):
    """A figure and its axes, rows of the given heights in inches."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, sum(heights)), layout="constrained")
    return figure, figure.subplots(len(heights), columns, height_ratios=heights, squeeze=False)


def bare(axes, title=""):
    """Axes of a drawing to scale, without a frame."""
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(title, fontsize=10, loc="left", color=INK)


def legend(axes, of, columns=4):
    """The legend of some axes in others of its own."""
    handles, labels = of.get_legend_handles_labels()
    axes.legend(handles, labels, fontsize=9, frameon=False, loc="center", ncols=columns, handlelength=1.3)
    axes.set_axis_off()


def draw_rod(axes, rod, color=INK, label=None):
    """The bent strip, its inflections and the line through them."""
    axes.plot(*rod.position.T, color=color, linewidth=2.2, label=label)
    points = rod.curve.at(rod.curve.inflections).position
    if len(points) and rod.gravity is None:
        direction = rod.force[0] / np.hypot(*rod.force[0])
        along = (points - points[0]) @ direction
        ends = points[0] + np.outer([along.min() - 25, along.max() + 25], direction)
        axes.plot(*ends.T, color=color, linewidth=0.9, linestyle="--")
    axes.plot(*points.T, "o", color=color, markersize=5)


def draw_flat(axes, strips):
    """Strips as they are cut, one above the other, labelled."""
    y, longest = 0.0, max(np.ptp(strip.outline.bounds[:, 0]) for strip in strips)
    for strip in strips:
        (left, bottom), (right, top) = strip.outline.bounds
        text = f"{strip.label}: {right - left:.0f} by {top - bottom:.0f} mm, {strip.sheet.name}"
        axes.text(0, y, text, fontsize=9, color=INK, va="bottom")
        y -= 0.012 * longest
        paint_flat(axes, strip, (-left, y - top))
        y -= top - bottom + 0.05 * longest
    axes.set_xlim(-0.01 * longest, 1.01 * longest)
    axes.set_ylim(y, 0.05 * longest)
    bare(axes)


def s_curve(names):
    """The drawn curve, where it snaps to, and the stable one beside it; both strips."""
    drawn, found = names["build"]()
    gone = names["snapped"](drawn)
    figure, ((above,), (told,), (middle,), (below,)) = page(4.4, 0.3, 2.0, 1.5)
    draw_rod(above, drawn, MARK, f"drawn: margin {ec.stability(drawn).margin:.0f}, unstable")
    above.plot(*gone.position.T, color=FAINT, linewidth=1.6, label="where it snaps to when it is let go")
    draw_rod(above, found.rod, INK, f"found: margin {ec.stability(found.rod).margin:.0f}, stable")
    bare(above, f"Drawn and found are {found.deviation:.1f} mm apart at most; inflections lie on their lines")
    legend(told, above)
    for rod, color, label in ((drawn, MARK, "drawn"), (found.rod, INK, "found")):
        s = np.linspace(0, rod.length, 1200)
        middle.plot(s, rod.profile(s), color=color, label=f"{label}: largest over smallest {rod.ratio:.1f}")
    middle.set(xlabel="arc length (mm)", ylabel="stiffness K", ylim=(0, None), xlim=(0, drawn.length))
    middle.spines[["top", "right"]].set_visible(False)
    middle.legend(fontsize=9, frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2)
    draw_flat(below, [names["strip"](drawn, "drawn"), names["strip"](found.rod, "found")])
    return figure


def projective(names):
    """Curves with their handles before and after, and the strips of both."""
    curves, frames = names["build"](), (names["HANDLES"], names["MOVED"])
    figure, (row, flats) = page(3.2, 1.0, columns=2)
    for axes, below, label, curve, handles in zip(
        row, flats, ("before", "after"), curves, frames, strict=True
    ):
        rod = ec.optimal_rod(curve)
        axes.plot(*np.array([*handles, handles[0]]).T, "s-", color=OTHER, linewidth=0.8, markersize=7)
        draw_rod(axes, rod)
        bare(axes, f"{label}: {rod.length:.0f} mm, stiffness ratio {rod.ratio:.2f}")
        draw_flat(below, [ec.Strip(rod, ec.Sheet.named("card-200gsm"), max_width=25, label=label)])
    everything = np.concatenate([*(curve.sample(200).position for curve in curves), *map(np.array, frames)])
    for axes in row:  # one scale for both
        for setter, low, high in zip(
            (axes.set_xlim, axes.set_ylim), everything.min(axis=0), everything.max(axis=0), strict=True
        ):
            setter(low - 12, high + 12)
    return figure


def robustness(names):
    """The arch as designed and as it comes out, for each cause; the strip."""
    found, rod = names["bent"](), names["designed"]()
    figure, (row, told, flats) = page(2.3, 0.7, 1.5, columns=len(found))
    for axes, under, (cause, shapes) in zip(row, told, found.items(), strict=True):
        for (label, bent), color in zip(shapes.items(), SHADES, strict=True):
            axes.plot(*bent.position.T, color=color, linewidth=1.6, label=label)
        far = max(names["strays"](bent) for bent in shapes.values())
        bare(axes, f"{cause}: up to {far:.1f} mm off")
        legend(under, axes, 2)
    grid = flats[0].get_gridspec()
    for axes in flats:
        axes.remove()
    draw_flat(figure.add_subplot(grid[2, :]), [ec.Strip(rod, names["CARD"], max_width=45, label="strip")])
    return figure


STUDIES = {"s_curve": s_curve, "projective": projective, "robustness": robustness}


def main(*chosen):
    """Draw the pictures of the studies."""
    from PIL import Image

    for name in chosen or STUDIES:
        figure = STUDIES[name](runpy.run_path(str(EXAMPLES / name / f"{name}.py")))
        file = EXAMPLES / name / f"{name}.png"
        plot.save_figure(figure, file, force=True, resolution=90)
        Image.open(file).convert("RGB").quantize(64).save(file, optimize=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
