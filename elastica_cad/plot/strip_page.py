"""What is shown of a strip on a page, in numbers and words alone, and how that is painted."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.plot.canvas import INK, WIDTH_INCHES, Axes, Figure, Panel, new_page

COMB, LINE, FAINT = "#2f6db3", "#c2452d", "#8a8f98"

NUMBERED = Panel(5.2, above=0.54, below=0.52, left=0.8, right=0.15)
"""A drawing with both its axes, a title, and a legend below that."""

STIFFNESS = NUMBERED._replace(height=1.6, above=0.32)
"""K along the strip, under a title."""

WIDE = WIDTH_INCHES - NUMBERED.left - NUMBERED.right
"""Of the axes of these pages, inches."""

MARGIN_SHARE = 0.04
"""Of the flat strip's length: the room beside it."""


@dataclass(frozen=True, eq=False)
class BentView:
    """The bent rod with its curvature comb and inflection line.

    Attributes
    ----------
    length : float
        Of the rod, mm.
    position, tips : ndarray (n, 2)
        Along the rod, and the ends of the comb's teeth there, mm.
    wish : ndarray (k, 2), optional
        Along the curve that was asked for.
    turns : ndarray (m, 2)
        Where the bending changes sign.
    line : ndarray (2, 2), optional
        Ends of the inflection line.
    window : ndarray (2, 2)
        Least and largest coordinates shown.
    height : float
        Of the axes, inches.
    """

    length: float
    position: FloatArray
    tips: FloatArray
    wish: FloatArray | None
    turns: FloatArray
    line: FloatArray | None
    window: FloatArray
    height: float

    @property
    def panel(self) -> Panel:
        """Its room."""
        return NUMBERED._replace(height=self.height)

    def paint(self, axes: Axes) -> None:
        """Draw it."""
        position, tips = self.position, self.tips
        step = max(1, len(position) // 100)
        teeth = np.stack([position, tips, np.full_like(tips, np.nan)], axis=1)[::step].reshape(-1, 2)
        axes.plot(*teeth.T, color=COMB, linewidth=0.5, alpha=0.6)
        axes.plot(*tips.T, color=COMB, linewidth=0.8, label="curvature comb")
        if self.wish is not None:
            dashed = {"color": FAINT, "linewidth": 1.4, "linestyle": (0, (4, 2))}
            axes.plot(*self.wish.T, label="drawn curve", **dashed)
        axes.plot(*position.T, color=INK, linewidth=2.2, label="strip")
        if len(self.turns):
            called = "inflection" if len(self.turns) == 1 else "inflections"
            axes.plot(*self.turns.T, "o", color=LINE, markersize=6, label=called)
        if self.line is not None:
            axes.plot(*self.line.T, color=LINE, linewidth=1.0, linestyle="--", label="inflection line")
        axes.set_xlim(*self.window[:, 0])
        axes.set_ylim(*self.window[:, 1])
        paint_both_axes(axes, f"Bent: {self.length:.1f} mm along the curve")
        paint_legend(axes)


@dataclass(frozen=True, eq=False)
class StiffnessView:
    """The stiffness along a rod.

    Attributes
    ----------
    s, K : ndarray (n,)
        Arc length, mm, and stiffness there.
    ratio : float
        Largest over smallest.
    """

    s: FloatArray
    K: FloatArray
    ratio: float

    def paint(self, axes: Axes) -> None:
        """Draw it."""
        axes.plot(self.s, self.K, color=INK, linewidth=1.6)
        axes.fill_between(self.s, 0, self.K, color=COMB, alpha=0.12, linewidth=0)
        axes.set_xlim(0, self.s[-1])
        axes.set_ylim(0, 1.12 * self.K.max())
        axes.set_xlabel("arc length from the start of the free part (mm)")
        axes.set_ylabel("stiffness K")
        _entitle(axes, f"Stiffness: largest over smallest {self.ratio:.3f}")
        axes.grid(visible=True, color="#e3e5e8", linewidth=0.6)
        _quiet(axes)


@dataclass(frozen=True, eq=False)
class FlatLayer:
    """The cut pattern of one sheet, in the colour of that.

    Attributes
    ----------
    loops : sequence of ndarray (n, 2)
        The outline, then what runs against it and is left out of the filling, mm.
    color : (float, float, float)
    seen_through : bool
        It lies on another.
    """

    loops: Sequence[FloatArray]
    color: tuple[float, float, float]
    seen_through: bool

    def paint(self, axes: Axes, shift: tuple[float, float]) -> None:
        """Draw it, moved by `shift` mm."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path as Outline

        outlines = [Outline(loop + shift, closed=True) for loop in self.loops]
        # `add_patch` would look at every piece of every hole for limits that are set afterwards
        axes.add_artist(
            PathPatch(
                Outline.make_compound_path(*outlines),
                facecolor=self.color,
                edgecolor=INK,
                linewidth=1.0,
                alpha=0.6 if self.seen_through else None,
            )
        )


@dataclass(frozen=True, eq=False)
class FlatView:
    """The flat strip with its dimensions.

    Attributes
    ----------
    layers : sequence of FlatLayer
    bounds : ndarray (2, 2)
        Least and largest coordinates of the outline, mm.
    free : float
        Length of the free part, which begins at x = 0, mm.
    stations : sequence of (float, float, float)
        Places along it, width there and the size that is told there, mm.
    title : str
    """

    layers: Sequence[FlatLayer]
    bounds: FloatArray
    free: float
    stations: Sequence[tuple[float, float, float]]
    title: str

    @property
    def panel(self) -> Panel:
        """Its room."""
        (left, bottom), (right, top) = self.bounds
        tall = float(np.clip(WIDE * ((top - bottom) / (right - left) + 0.13), 1.2, 4.5))
        return STIFFNESS._replace(height=tall, below=0.08)

    def paint(self, axes: Axes) -> None:
        """Draw it."""
        for layer in self.layers:
            layer.paint(axes, (0.0, 0.0))
        (left, bottom), (right, top) = self.bounds
        length = right - left
        unit = 0.012 * length
        axes.plot([0, 0, np.nan, self.free, self.free],
                  [bottom, top, np.nan, bottom, top], color=FAINT, linewidth=0.8, linestyle=":")  # fmt: skip
        above, below = top + 1.6 * unit, bottom - 1.2 * unit
        _dimension(axes, (left, above), (right, above), f"{length:.2f} mm in all, {self.free:.2f} mm free")
        for x, w, told in self.stations:
            axes.plot([x, x], [-w / 2, w / 2], color=LINE, linewidth=0.9)
            axes.text(x, below, f"{told:.2f}", ha="center", va="top", fontsize=9, color=LINE)
        axes.set_xlim(left - MARGIN_SHARE * length, right + MARGIN_SHARE * length)
        axes.set_ylim(bottom - 5.0 * unit, top + 5.2 * unit)
        axes.set_aspect("equal")
        axes.set_xticks([])
        axes.set_yticks([])
        for side in axes.spines.values():
            side.set_visible(False)
        _entitle(axes, self.title)


@dataclass(frozen=True, eq=False)
class StripPage:
    """One page about a strip: its curve, its stiffness, its flat pattern, under a title."""

    title: str
    bent: BentView
    stiffness: StiffnessView
    flat: FlatView

    def figure(self) -> Figure:
        """The page, painted."""
        figure, axes = new_page([self.bent.panel, STIFFNESS, self.flat.panel], self.title)
        self.bent.paint(axes[0])
        self.stiffness.paint(axes[1])
        self.flat.paint(axes[2])
        (start, _), (end, _) = self.flat.bounds
        margin = MARGIN_SHARE * (end - start)
        for below in axes[1:]:
            below.set_xlim(start - margin, end + margin)
        return figure


def _dimension(axes: Axes, start: tuple[float, float], end: tuple[float, float], text: str) -> None:
    arrow = {"arrowstyle": "<->", "color": FAINT, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", start, end, arrowprops=arrow)
    middle = ((start[0] + end[0]) / 2, start[1])
    above = {"xytext": (0, 3), "textcoords": "offset points", "ha": "center", "va": "bottom"}
    axes.annotate(text, middle, fontsize=9, color=INK, **above)


def paint_both_axes(axes: Axes, title: str) -> None:
    """Numbers along x and y, at one scale, and a title."""
    axes.set_aspect("equal")
    axes.set_xlabel("x (mm)")
    axes.set_ylabel("y (mm)")
    _entitle(axes, title, pad=22)
    _quiet(axes)


def _entitle(axes: Axes, title: str, pad: float = 6.0) -> None:
    """Above the axes, at a place that needs no look at what else is drawn."""
    axes.set_title(title, fontsize=10, loc="left", color=INK, pad=pad, y=1.0)


def _quiet(axes: Axes) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=9)


def paint_legend(axes: Axes) -> None:
    """In one line above the axes, below the title."""
    axes.legend(
        fontsize=9, frameon=False, loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncols=5, borderpad=0.1
    )
