"""Holes and notches in a strip for pins and cords, and the widening of the strip that compensates them."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import distinct_digits
from elastica_cad.errors import BareLength, InputError, Length, Listed, Refusal, note, rounded_up
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import at_sign_changes, left_of
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.elements import Pin, Tie, noun_of
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import BRITTLE, StrainState, StrainVerdict, judge_strain
from elastica_cad.mechanics.sections import crack_energy
from elastica_cad.mechanics.sheets import Sheet, even_shear_ratio
from elastica_cad.strip.outline import Ends
from elastica_cad.strip.slots import Side, Slot
from elastica_cad.strip.styles import Bends, Layout

CUT, CUT_GRAIN = 1.15, 0.7
"""Constants of the unstressed corners beside a slot, which act like an added length of the strip.

In a sheet without grain, the added length is `CUT` times `crack_energy` times depth^2 / width. In a sheet with
grain, it is multiplied by g ** `CUT_GRAIN`, where g is sqrt(E / G) divided by its isotropic value.
Fitted to finite elements (`tests/campaign/finite_elements/idle_corners.py`)."""

FRACTIONS = (np.arange(400) + 0.5) / 400
"""Integration points along a widening or a hole, as fractions of its length: midpoints of 400 intervals."""


def _grain_factor(sheet: Sheet) -> float:
    return float((even_shear_ratio(min(sheet.poisson_ratio, 0.5)) / sheet.shear_ratio) ** (CUT_GRAIN / 2))


@dataclass(frozen=True)
class ElementCut:
    """Cut for a pin or for one end of a tie: a hole on the centre line, or a notch in each edge.

    Attributes
    ----------
    at : float
        Arc length at the centre of the cut, mm.
    hole, notch : float
        Diameter of the hole and width and depth of each notch, mm; 0 for none.
    noun : Refusal
        Name of the rail, pin or tie in messages.
    """

    at: float
    hole: float
    notch: float
    noun: Refusal

    def missing_from(self, slots: Sequence[Slot]) -> Iterator[Slot]:
        """Yield the notches that `slots` does not contain yet, as slots with a semicircular end."""
        sides: tuple[Side, ...] = ("upper", "lower") if self.notch else ()
        for side in sides:
            if not any((slot.at, slot.width, slot.side) == (self.at, self.notch, side) for slot in slots):
                yield Slot(self.at, width=self.notch, depth=self.notch / 2, side=side, relief="round")

    @property
    def span(self) -> tuple[float, float]:
        """Start and end of the cut along the strip, mm."""
        half = max(self.hole, self.notch) / 2
        return self.at - half, self.at + half

    def added_length(self, width: float, sheet: Sheet) -> float:
        """Return the added length, mm, of the cut in a strip of width `width`, mm.

        The strip bends as if it were longer by the added length.

        A hole of diameter d reduces the net section, and the corners beside it are unstressed. In a wide
        Kirchhoff plate, both effects add pi / 4 d^2 / width times the stress concentration
        1 + 2 (1 + nu) / (3 + nu). In a narrower strip the effect of the corners is divided by 1 + d / width.
        Plate elements agree within 3 %. Notches are computed as slots. For notches up to 0.3 times as wide as
        the strip, the added length is at most 19 % larger than with plate elements.
        """
        nu, grain = min(sheet.poisson_ratio, 0.5), _grain_factor(sheet)
        chords = self.hole * np.sqrt(1 - (2 * FRACTIONS - 1) ** 2)
        net = self.hole * float((chords / (width - chords)).mean())
        corners = 2 * (1 + nu) / (3 + nu) * grain * np.pi / 4 * self.hole**2 / (width + self.hole)
        cracks = 2 * CUT * crack_energy(nu) * grain * self.notch**2 / width
        # both notches are as deep as they are wide, with semicircular ends
        return net + corners + cracks + (1 + np.pi / 4) * self.notch**2 / (width - 2 * self.notch)


def element_cuts(rod: Rod) -> tuple[ElementCut, ...]:
    """Return the cuts for the pins and ties of a rod."""
    return tuple(
        ElementCut(float(at), action.element.hole, action.element.notch, noun_of(action.element))
        for action in rod.between
        if isinstance(action.element, Pin | Tie) and (action.element.hole or action.element.notch)
        for at in action.s
    )


def cut_holes(rod: Rod, ends: Ends) -> tuple[Path, ...]:
    """Return the outlines of the holes for the pins and ties of a rod, in a strip with the tabs `ends`."""
    cuts = element_cuts(rod)
    for cut in cuts:
        low, high = cut.span
        if low <= -ends[0].length or high >= rod.length + ends[1].length:
            raise InputError(
                "The hole or notch for the {element} {at} from the start extends beyond the end of the "
                "strip. Move the hole or notch, or give the strip a longer tab there.",
                element=cut.noun, at=Length(cut.at), where={"field": "between"},
            )  # fmt: skip
    for first, second in combinations(cuts, 2):
        if first.span[0] < second.span[1] and second.span[0] < first.span[1]:
            raise InputError(
                "The holes or notches {first} and {second} from the start overlap. Move one of these "
                "elements, or leave out its hole or notch.",
                first=Length(first.at), second=Length(second.at), where={"field": "between"},
            )  # fmt: skip
    return tuple(Path.circle((cut.at, 0.0), cut.hole / 2) for cut in cuts if cut.hole)


def lengths_added_by_cuts(rod: Rod, width: Profile, sheet: Sheet) -> list[tuple[float, float]]:
    """Return position and added length, mm, of each cut: see `ElementCut.added_length`."""
    return [(cut.at, cut.added_length(float(width(cut.at)), sheet)) for cut in element_cuts(rod)]


def widened_for_cuts(rod: Rod, layout: Layout, laid_out: Callable[[Profile], Layout]) -> Layout:
    """Return the layout with a smooth widening at each cut, which compensates the bend that the cut adds.

    Parameters
    ----------
    rod : Rod
    layout : Layout
        Layout without widenings.
    laid_out : callable
        Function from a factor on the stiffness, a `Profile` along the strip, to the layout.
    """
    cuts = element_cuts(rod)
    for cut in cuts:
        _require_narrower_cut(cut, float(layout.width(cut.at)))
    cuts = tuple(cut for cut in cuts if 0 < cut.at < rod.length)  # a cut at a free end has no effect
    peaks = np.zeros(len(cuts))
    # the widening at a cut depends on the widened width
    for _ in range(4 if cuts else 0):
        bumps = []
        for cut, peak in zip(cuts, peaks, strict=True):
            plain = float(layout.width(cut.at)) / (1 + peak)
            _require_narrower_cut(cut, plain)
            bumps.append(_Bump(cut.at, plain, plain / 2 + max(cut.hole, cut.notch)))
        pairs = zip(cuts, bumps, strict=True)
        peaks = np.array([bump.peak(cut, layout.sheet, rod.length) for cut, bump in pairs])
        layout = laid_out(_factor(bumps, peaks, rod.length))
    return layout


def _require_narrower_cut(cut: ElementCut, width: float) -> None:
    needed = max(cut.hole, 2 * cut.notch)
    if needed >= width:
        raise InputError(
            "The hole or notches for the {element} {at} from the start are {needed:g} wide in total, but the strip "
            "there is only {wide:.4g} wide. Make the hole or notches smaller, or the strip wider.",
            element=cut.noun, at=Length(cut.at), needed=Length(needed), wide=Length(width),
            where={"field": "between"},
        )  # fmt: skip


def _factor(bumps: Sequence["_Bump"], peaks: FloatArray, length: float) -> Profile:
    knots = np.concatenate([bump.at + bump.reach * np.linspace(-1, 1, 5) for bump in bumps])
    return Profile.fit(
        lambda s: 1 + sum(peak * bump(s) for bump, peak in zip(bumps, peaks, strict=True)),
        length, knots=np.unique(knots[(knots > 0) & (knots < length)]), tolerance=1e-6,
    )  # fmt: skip


@dataclass(frozen=True)
class _Bump:
    """Shape of a widening: a cubic B-spline that is 1 at arc length `at` and 0 beyond `reach`, mm.

    `width` is the width of the strip without the widening, mm.
    """

    at: float
    width: float
    reach: float

    def __call__(self, s: FloatArray) -> FloatArray:
        v = 2 * np.abs(s - self.at) / self.reach
        return np.where(v < 1, 1 - 1.5 * v**2 + 0.75 * v**3, 0.25 * np.maximum(2 - v, 0) ** 3)

    def peak(self, cut: ElementCut, sheet: Sheet, length: float) -> float:
        """Return the largest relative widening, with which the bump compensates the length that the cut adds."""
        low, high = max(self.at - self.reach, 0.0), min(self.at + self.reach, length)
        shape = self(low + (high - low) * FRACTIONS)

        def lack(peak: float) -> float:
            # length added by the cut, minus the length that the stiffer bump saves
            saved = float((1 - 1 / (1 + peak * shape)).mean()) * (high - low)
            return cut.added_length(self.width * (1 + peak), sheet) - saved

        from scipy.optimize import brentq

        # even a hole as wide as the strip needs a smaller relative widening than 9
        peak: float = brentq(lack, 0.0, 9.0)
        return peak


@dataclass(frozen=True)
class StrainedCut:
    """A cut in a brittle sheet, and the bending strain at the edge of the cut."""

    cut: ElementCut
    sheet: Sheet
    strain: float

    @property
    def verdict(self) -> StrainVerdict:
        """Verdict on the strain: at most a warning, because the strain decreases rapidly away from the cut."""
        judged = judge_strain(self.sheet, self.strain, self.cut.at)
        return replace(judged, state=min(judged.state, StrainState.WARNED))

    def __str__(self) -> str:
        strain, allowed = distinct_digits(100 * self.strain, 100 * self.sheet.max_strain, ".2g")
        return note(
            "At {at} from the start, the edge of the hole or notch for the {element} is strained by {strain:g} %; "
            "{sheet} allows {limit:g} %: {outcome}. Move the {element} to a gentler bend, or leave out its hole or "
            "notch.",
            at=Length(self.cut.at), element=self.cut.noun, strain=strain, limit=allowed, sheet=self.sheet.name,
            outcome=note(self.verdict.outcome), severity="warning",
        )  # fmt: skip


def strained_cuts(rod: Rod, layout: Layout) -> tuple[StrainedCut, ...]:
    """Return the cuts whose edges are strained beyond the limit of a brittle sheet.

    Let k be the stress concentration factor in tension. In a bent plate, k - 1 is multiplied by (1 + nu) / (3
    + nu), as beside an elliptic hole (Goodier, Phil. Mag. 22, 1936).
    """
    sheet = layout.sheet
    cuts = element_cuts(rod) if sheet.kind in BRITTLE else ()
    nu = min(sheet.poisson_ratio, 0.5)
    strained = []
    for cut in cuts:
        # k - 1 is 2 sqrt(depth / radius of the cut), and a notch is twice as deep as its radius
        concentration = 2.0 if cut.hole else 2.0 * np.sqrt(2.0)
        at = np.array([cut.at])
        strain = max(float(layer.largest) for layer in layout.strains(Bends(np.abs(rod.bend_at(at)), at)))
        factor = 1 + (1 + nu) / (3 + nu) * _grain_factor(sheet) * concentration
        strained.append(StrainedCut(cut, sheet, float(strain * factor)))
    return tuple(cut for cut in strained if not cut.verdict.allowed)


def crossing_warnings(rod: Rod, width: Profile) -> Iterator[str]:
    """Yield a warning for each cord that crosses the strip between the ends of the cord."""
    for action in rod.between:
        if not isinstance(action.element, Tie):
            continue
        s, along = _crossings(rod, *rod.curve.at(action.s).position)
        # the ends of the cord are on the strip, and are not crossings
        between = np.abs(s[:, None] - action.s).min(axis=1) > rod.length / rod.s.size
        if not between.any():
            continue
        crossings, wide = s[between], width(s[between])
        notch, apart = action.element.notch, rounded_up(float(wide.max()), 3)
        if not notch:
            yield note(
                "The cord from {start} to {end} crosses the strip {places} from its start. Use two cords "
                "beside its edges, more than {apart} apart.",
                start=Length(action.s[0]), end=Length(action.s[1]), places=Listed(map(Length, crossings.tolist())),
                apart=Length(apart), severity="warning",
            )  # fmt: skip
            continue
        # distance of the two cords at each crossing, between the bottoms of the notches at both ends
        gaps = np.interp(along[between], (0, 1), width(action.s) - 2 * notch)
        if np.any(gaps <= wide):
            k = (gaps - wide).argmin()
            yield note(
                "The two cords in the notches from {start} to {end} cross the strip {at} from its start, because "
                "they are {gap:.1f} apart there and the strip is {wide:.1f} wide. Tie them to bars across the "
                "strip, longer than {apart}, instead of notches.",
                start=Length(action.s[0]), end=Length(action.s[1]), at=Length(crossings[k]),
                gap=BareLength(gaps[k]), wide=Length(wide[k]), apart=Length(apart),
                severity="warning",
            )  # fmt: skip


def _crossings(rod: Rod, start: FloatArray, end: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the arc lengths, mm, at which the rod crosses a cord, and the fractions of the cord up to there."""
    chord = end - start
    aside = (rod.position - start) @ left_of(chord)
    along = (at_sign_changes(aside, rod.position) - start) @ (chord / (chord @ chord))
    inside = (along > 0) & (along < 1)
    return at_sign_changes(aside, rod.s)[inside], along[inside]
