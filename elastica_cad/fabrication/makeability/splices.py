"""A strip longer than the stock: cut in pieces, and joined by lap plates where that changes its shape least."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import (
    CUT_INNER,
    CUT_OUTER,
    ENGRAVE,
    MARK,
    Drawing,
    LayeredPath,
)
from elastica_cad.fabrication.drawings.lettering import Text, text_width
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.sheets.pieces import Piece
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.styles import Plain
from elastica_cad.geometry.paths.clip import clip_across
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.material.laminated_section import LaminatedSection

PLACES = 400
"""Places along a strip where a joint is tried."""

LABEL_MM = 6.0
"""Height of a piece's name, where there is room."""

SPLICED = "cut in"
"""How the sentence about a strip in pieces begins."""

APART_MM = 5.0
"""Between the pieces in one drawing."""


@dataclass(frozen=True, eq=False)
class Splice:
    """A strip in pieces, butt to butt, with a plate of the same sheet glued over each joint on one side.

    Plates are solid and as wide as the strip; holes that would come to lie under one are not cut.

    Attributes
    ----------
    strip : Strip
    joints : tuple of float
        Where it is cut, mm along it.
    lap : float
        Length of the plates, half of it on either piece, mm.
    """

    strip: Strip
    joints: tuple[float, ...]
    lap: float

    @cached_property
    def pieces(self) -> tuple[Piece, ...]:
        """The pieces in order, where the plates come to lie marked on them, then the plates."""
        strip, name = self.strip, self.strip.label or "strip"
        (first, _), (last, _) = strip.outline.bounds
        ends = [float(first), *self.joints, float(last)]
        cut = [self._piece(f"{name}-{k}", low, high) for k, (low, high) in enumerate(pairwise(ends), start=1)]
        plates = [
            self._piece(f"{name}-lap-{k}", at - self.lap / 2, at + self.lap / 2, marked=False)
            for k, at in enumerate(self.joints, start=1)
        ]
        return (*cut, *plates)

    @cached_property
    def drawing(self) -> Drawing:
        """All pieces and plates in one drawing, one above the other."""
        placed, y = [], 0.0
        for piece in self.pieces:
            (x0, y0), (_, y1) = piece.bounds
            placed.append(piece.drawing.transformed([[1, 0, -x0], [0, 1, y - y0], [0, 0, 1]]))
            y += float(y1 - y0) + APART_MM
        return Drawing.merged(self.strip.label or "strip", placed)

    @cached_property
    def deviation(self) -> float:
        """How far the plates move the shape, bent and held as designed, mm; their weight is left out.

        Over a plate the strip is two sheets thick and as stiff as that; it ends at once, as glue does.
        """
        made = self.strip.as_built
        covered = self._covered(made.s)
        base = self.strip.layers[0]
        section, wide = LaminatedSection(base.sheet, base.sheet), self.strip.width(made.s)
        left = np.minimum(replace(base, holes=self._holes).material(made.s), wide)
        designed = section.bending_stiffness(base.material(made.s), 0.0)
        bare = section.bending_stiffness(left, 0.0) / designed
        under = section.bending_stiffness(wide, left) / designed
        K = made.stiffness / ((1 - covered) / bare + covered / under)
        factor = float(K.min() / made.stiffness.min())
        B = made.bending_stiffness
        stiffer = replace(
            made.with_stiffness(Profile.interpolate(made.s, K)),
            bending_stiffness=None if B is None else B * factor,
        )
        bent = bend(stiffer)
        return float(np.hypot(*(bent.position - self.strip.rod.position).T).max())

    def __str__(self) -> str:
        """One sentence."""
        count = len(self.joints) + 1
        places = " and ".join(f"{at:.1f}" for at in self.joints)
        lost = len(self.strip.holes) - len(self._holes)
        if lost:
            return (
                f"{SPLICED} {count} pieces at {places} mm, joined by plates of {self.lap:g} mm, without the {lost} "
                f"holes that lie under them; they are stiffer and move the shape by {self.deviation:.2g} mm"
            )
        return (
            f"{SPLICED} {count} pieces at {places} mm, joined by plates of {self.lap:g} mm, which are stiffer and "
            f"move the shape by {self.deviation:.2g} mm"
        )

    @cached_property
    def _holes(self) -> tuple[Path, ...]:
        """Holes that are cut: those clear of the plates."""
        half = self.lap / 2
        spans = [(hole, hole.bounds[:, 0]) for hole in self.strip.holes]
        return tuple(
            hole
            for hole, (low, high) in spans
            if not any(low < at + half and high > at - half for at in self.joints)
        )

    def _covered(self, s: FloatArray) -> FloatArray:
        """Share (n,) of each node's cell that lies under a plate."""
        ends = np.concatenate([s[:1], (s[1:] + s[:-1]) / 2, s[-1:]])
        under = np.zeros(s.size)
        for at in self.joints:
            under += np.diff(np.clip(ends, at - self.lap / 2, at + self.lap / 2))
        return under / np.diff(ends)

    def _piece(self, name: str, low: float, high: float, *, marked: bool = True) -> Piece:
        strip = self.strip
        outline = clip_across(strip.outline, low, high)
        holes = [hole for hole in self._holes if low < float(hole.bounds.mean(axis=0)[0]) < high and marked]
        edges = [at + side * self.lap / 2 for at in self.joints for side in (-1, 1)] if marked else []
        paths = [
            *(LayeredPath(MARK, self._tick(x)) for x in edges if low < x < high),
            *(LayeredPath(CUT_INNER, hole) for hole in holes),
            LayeredPath(CUT_OUTER, outline),
        ]
        return Piece(name, Drawing(name, tuple(paths), (self._label(name, low, high),)), strip.sheet)

    def _tick(self, x: float) -> Path:
        half = 0.4 * float(self.strip.width(x))
        return Path.polyline([(x, -half), (x, half)])

    def _label(self, name: str, low: float, high: float) -> Text:
        if isinstance(self.strip.style, Perforated) and high - low > self.lap:  # no room between the holes
            joint = next(at for at in self.joints if at in (low, high))
            low, high = sorted((joint, joint + (self.lap / 2 if joint == low else -self.lap / 2)))
        middle = (max(low, 0.0) + min(high, self.strip.rod.length)) / 2
        height = min(LABEL_MM, 0.3 * float(self.strip.width(middle)))
        height *= min(1.0, 0.6 * (high - low) / text_width(name, height))
        start = (middle - text_width(name, height) / 2, -height / 2)
        return Text(start, name, height, 0.0, ENGRAVE)


def splice(strip: Strip, stock: float, lap: float) -> Splice:
    """Cut a plain or perforated strip into as few pieces as the stock allows, where plates change its shape least.

    Joints keep off slots, tabs and each other; of the places left those are taken where the strip turns least under
    the plates, in the sum of squares (dynamic programming).

    Parameters
    ----------
    strip : Strip
    stock : float
        Length of the longest piece, mm.
    lap : float
        Length of the plates, mm.

    Raises
    ------
    InputError
        A laminate or a strip of varying thickness, a lap that is not possible, or no places for the joints.

    Examples
    --------
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> from elastica_cad.mechanics.rod.rod_record import Rod
    >>> long = Strip(Rod.straight(1000), Sheet.named("birch-plywood-3"), max_width=40, label="A")
    >>> [piece.name for piece in splice(long, 600, 60).pieces]
    ['A-1', 'A-2', 'A-lap-1']
    """
    name = strip.label or "strip"
    if not isinstance(strip.style, Plain | Perforated) or strip.rod.section is not None:
        raise InputError(
            f"{name}: only plain and perforated strips of one sheet are cut in pieces, for every layer would need "
            "plates of its own: take a larger stock, or a plain strip"
        )
    (first, _), (last, _) = strip.outline.bounds
    length = float(last - first)
    if not (np.isfinite(lap) and 0 < lap < stock / 3):
        raise InputError(
            f"{name}: a lap of {lap:g} mm: give a length above 0 and below a third of {stock:g} mm"
        )
    count = int(np.ceil(length / stock * (1 - 1e-12))) - 1
    s = np.linspace(lap / 2, strip.rod.length - lap / 2, PLACES)
    clear = np.ones(PLACES, dtype=bool)
    for slot in strip.slots:
        clear &= np.abs(s - slot.at) > lap / 2 + slot.width
    rod = strip.rod
    turned = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(rod.angle)))])
    turn = np.interp(s + lap / 2, rod.s, turned) - np.interp(s - lap / 2, rod.s, turned)
    cost = np.where(clear, turn**2, np.inf)
    joints = _placed(s, cost, count, float(first), float(last), stock, lap)
    if joints is None:
        raise InputError(
            f"{name}: there is no room for {count} joints of {lap:g} mm between its slots: take a shorter lap or a "
            "larger stock"
        )
    return Splice(strip, joints, lap)


def spliced(strip: Strip, shop: Shop) -> Splice | None:
    """The strip in pieces, where the shop joins pieces and the strip is longer than its stock."""
    if shop.lap is None:
        return None
    length = float(np.ptp(strip.outline.bounds, axis=0)[0])
    stock = shop.stock_for(strip.sheet)[0]
    return splice(strip, stock, shop.lap) if length > stock else None


def _placed(
    s: FloatArray, cost: FloatArray, count: int, first: float, last: float, stock: float, lap: float
) -> tuple[float, ...] | None:
    """Places of the joints with the least sum of costs, no piece longer than the stock or shorter than two laps."""
    gap = s[:, None] - s[None, :]
    allowed = (gap <= stock) & (gap >= 2 * lap)
    best = np.where(s - first <= stock, cost, np.inf)
    came: list[FloatArray] = []
    for _ in range(count - 1):
        total = np.where(allowed, best[None, :], np.inf)
        came.append(np.argmin(total, axis=1))
        best = cost + total.min(axis=1)
    best = np.where(last - s <= stock, best, np.inf)
    at = int(np.argmin(best))
    if not np.isfinite(best[at]):
        return None
    chosen = [at]
    for back in reversed(came):
        chosen.append(int(back[chosen[-1]]))
    return tuple(float(s[k]) for k in reversed(chosen))
