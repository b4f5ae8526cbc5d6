"""A strip: the flat part whose width gives a rod its stiffness."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawing import CUT_INNER, CUT_OUTER, ENGRAVE, MARK, Drawing, LayeredPath, Text
from elastica_cad.fabrication.ends import Tab
from elastica_cad.fabrication.lettering import text_width
from elastica_cad.fabrication.slots import Slot
from elastica_cad.fabrication.slotting import with_slots
from elastica_cad.geometry import Arc, Line, Path, PlaneCurve, Profile, Spline
from elastica_cad.mechanics import Rod, Sheet

__all__ = ["Plain", "Reactions", "Strip"]


@dataclass(frozen=True)
class Plain:
    """A solid strip of one sheet: the width is proportional to the stiffness (paper, section 8.1)."""


@dataclass(frozen=True, eq=False)
class Reactions:
    """What the supports do to the strip: forces (2,) in N, moments in N mm (positive anticlockwise)."""

    start_force: FloatArray
    start_moment: float
    end_force: FloatArray
    end_moment: float


@dataclass(frozen=True, eq=False)
class Strip:
    """A flat strip that takes the shape of `rod` when its ends are held as the rod's are.

    Parameters
    ----------
    rod : Rod
        From `optimal_rod`, `nearest_rod` or `bend`.
    sheet : Sheet
        The material it is cut from.
    max_width, min_width : float, optional
        Width of the widest, of the narrowest place, mm; one of them sets the scale. With both, `max_width` sets
        it and a strip that would be narrower than `min_width` is refused. A rod that knows its bending stiffness
        in N mm2 (a weight in newtons) fixes its own width; the two are then limits.
    style : Plain
        How stiffness becomes material.
    ends : pair of Tab
        Tabs at the start and at the end.
    slots : tuple of Slot
        Cuts for other strips; they become part of the outline.
    label : str
        Engraved on the strip; empty for none.

    Raises
    ------
    InputError
        No width given, a width that is not positive, or limits that cannot be kept.

    Notes
    -----
    Flat pattern: x is arc length from the start of the free part, y = 0 the centre line. The long sides are cubic
    B-splines whose x control points are the Greville abscissae of the knots, so that y(x) is exactly half the
    spline width.

    Examples
    --------
    >>> strip = Strip(Rod.straight(100, [1, 2, 1]), Sheet.named("card-200gsm"), max_width=20)
    >>> round(strip.outline.length, 1) > 200
    True
    """

    rod: Rod
    sheet: Sheet
    max_width: float | None = None
    min_width: float | None = None
    style: Plain = Plain()
    ends: tuple[Tab, Tab] = (Tab(10.0), Tab(10.0))
    slots: tuple[Slot, ...] = ()
    label: str = ""

    def __post_init__(self) -> None:
        for name in ("max_width", "min_width"):
            value = getattr(self, name)
            if value is not None and not (np.isfinite(value) and value > 0):
                raise InputError(f"{name} is {value}: it must be positive, in mm")
        if self.max_width is None and self.min_width is None and self.rod.bending_stiffness is None:
            raise InputError(
                "a strip needs max_width or min_width (mm): the rod only fixes how widths compare"
            )
        narrow, wide = self.width.extremes
        slack = 1 + 1e-9
        if self.min_width is not None and narrow * slack < self.min_width:
            raise InputError(
                f"the narrowest place is {narrow:.4g} mm, below min_width {self.min_width:g} mm: the ratio is "
                f"{self.rod.ratio:.3g}, so max_width must be {self.min_width * self.rod.ratio:.4g} mm or more"
            )
        if self.max_width is not None and wide > self.max_width * slack:
            raise InputError(
                f"the rod's bending stiffness asks for a width of {wide:.4g} mm, above max_width "
                f"{self.max_width:g} mm: choose a thicker or stiffer sheet"
            )

    @cached_property
    def width(self) -> Profile:
        """Full width (mm) along the free part [0, length]."""
        rod, sheet = self.rod, self.sheet
        low, high = rod.profile.extremes
        if rod.bending_stiffness is not None:
            return rod.profile.scaled(
                12 * rod.bending_stiffness / (sheet.youngs_modulus * sheet.thickness**3)
            )
        if self.max_width is not None:
            return rod.profile.scaled(self.max_width / high)
        return rod.profile.scaled((self.min_width or 0.0) / low)

    @cached_property
    def outline(self) -> Path:
        """The closed outer loop with its slots, anticlockwise; its long sides are B-splines."""
        return with_slots(self._rim, self.holes, self.slots, self.width, name=self.label or "strip")

    @cached_property
    def _rim(self) -> Path:
        """The outer loop without slots."""
        pieces = _pieces(self.width)
        lower = [_side(piece, -0.5) for piece in pieces]
        upper = [_side(piece, 0.5).reversed() for piece in reversed(pieces)]
        w0, w1 = self.end_widths
        length = self.rod.length
        far = [_placed(segment, length, 1) for segment in self.ends[1].corners(w1)]
        near = [_placed(segment, 0.0, -1) for segment in self.ends[0].corners(w0)]
        return Path(_joined([*lower, *far, *upper, *near]), closed=True)

    @cached_property
    def holes(self) -> tuple[Path, ...]:
        """Closed inner loops."""
        w0, w1 = self.end_widths
        start = [_placed_path(path, 0.0, -1) for path in self.ends[0].hole_paths(w0)]
        end = [_placed_path(path, self.rod.length, 1) for path in self.ends[1].hole_paths(w1)]
        return (*start, *end)

    def mirrored(self) -> "Strip":
        """The strip turned over about its centre line (y to -y), bent into the same curve."""
        start, end = self.ends
        slots = tuple(slot.mirrored() for slot in self.slots)
        return replace(self, ends=(start.mirrored(), end.mirrored()), slots=slots)

    @property
    def end_widths(self) -> tuple[float, float]:
        """Width of the free part at its start and end, mm."""
        return float(self.width(0.0)), float(self.width(self.rod.length))

    @property
    def max_strain(self) -> float:
        """Largest strain of the skin, h/2 |kappa - kappa_0| (dimensionless)."""
        return self._strain_peak[0]

    @property
    def max_strain_at(self) -> float:
        """Arc length of the largest strain, mm."""
        return self._strain_peak[1]

    @cached_property
    def _strain_peak(self) -> tuple[float, float]:
        samples = (
            self.rod.curve.sample(max(2001, self.rod.s.size)) if self.rod.shape is not None else self.rod
        )
        bend = np.abs(samples.curvature - self.rod.natural_curvature)
        i = int(np.argmax(bend))
        return float(self.sheet.thickness / 2 * bend[i]), float(samples.s[i])

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a maker should know before cutting: the rod's warnings and a strain beyond the sheet's limit."""
        limit = self.sheet.max_strain
        if self.max_strain <= limit:
            return self.rod.warnings
        radius = self.sheet.thickness / 2 / self.max_strain
        return (
            *self.rod.warnings,
            f"strain {100 * self.max_strain:.2f} % at {self.max_strain_at:.1f} mm is beyond the "
            f"{100 * limit:.2f} % that {self.sheet.name} bears: its radius there is {radius:.1f} mm, the least "
            f"advisable {self.sheet.least_radius:.1f} mm; use a thinner sheet or a gentler curve",
        )

    @cached_property
    def area(self) -> float:
        """Area of the flat part, mm2."""
        return abs(self.outline.area) - sum(abs(hole.area) for hole in self.holes)

    @property
    def mass(self) -> float:
        """Mass in g."""
        return self.area * self.sheet.thickness * self.sheet.density * 1e-6

    @property
    def bending_stiffness(self) -> float:
        """B, the least E I along the strip, N mm2; the rod's numbers times B are newtons."""
        return self.sheet.youngs_modulus * self.sheet.thickness**3 / 12 * self.width.extremes[0]

    def reactions(self) -> Reactions:
        """Forces (N) and moments (N mm) that the supports exert on the strip.

        The internal force is -lambda B (Eq. 2), so the start is pushed by lambda(0) B and the end by -lambda(L) B.
        """
        B, force, moment = self.bending_stiffness, self.rod.force, self.rod.moment
        return Reactions(B * force[0], float(-B * moment[0]), -B * force[-1], float(B * moment[-1]))

    def drawing(self) -> Drawing:
        """The cut pattern on its layers: engraved label, end marks, inner cuts, outer cut."""
        marks = [_tick(x, w) for x, w in zip((0.0, self.rod.length), self.end_widths, strict=True)]
        paths = (
            *(LayeredPath(MARK, mark) for mark in marks),
            *(LayeredPath(CUT_INNER, hole) for hole in self.holes),
            LayeredPath(CUT_OUTER, self.outline),
        )
        texts = (self._label_text(),) if self.label else ()
        return Drawing(name=self.label or "strip", paths=paths, texts=texts)

    def _label_text(self) -> Text:
        """The label, lying along the middle of the strip, as large as fits up to 5 mm."""
        middle = self.rod.length / 2
        height = min(5.0, 0.4 * float(self.width(middle)))
        long = text_width(self.label, height)
        height *= min(1.0, 0.8 * self.rod.length / long) if long > 0 else 1.0
        x = middle - text_width(self.label, height) / 2
        return Text(position=(x, -height / 2), text=self.label, height=height, layer=ENGRAVE)


def _pieces(width: Profile) -> list[Profile]:
    """The profile cut at its jumps (interior knots of multiplicity degree + 1)."""
    k = width.degree
    knots, counts = np.unique(width.knots, return_counts=True)
    cuts = knots[(counts > k) & (knots > knots[0]) & (knots < knots[-1])]
    pieces, first = [], 0
    for cut in [*cuts, None]:
        last = width.coefficients.size if cut is None else int(np.searchsorted(width.knots, cut))
        pieces.append(Profile(width.knots[first : last + k + 1], width.coefficients[first:last], k))
        first = last
    return pieces


def _side(width: Profile, factor: float) -> Spline:
    """One long side: the graph of `factor` times the width, with Greville abscissae as x."""
    points = np.column_stack([width.greville, factor * width.coefficients])
    return Spline(PlaneCurve(width.knots, points, width.degree))


def _placed(segment: Line | Arc, x: float, direction: int) -> Line | Arc:
    """A tab's segment in the strip's frame: at the end as it is, at the start turned by half a turn."""
    return segment.transformed(_frame(x, direction))


def _placed_path(path: Path, x: float, direction: int) -> Path:
    return path.transformed(_frame(x, direction))


def _frame(x: float, direction: int) -> FloatArray:
    return np.array([[direction, 0.0, x], [0.0, direction, 0.0], [0.0, 0.0, 1.0]])


def _joined(segments: list[Line | Arc | Spline]) -> tuple[Line | Arc | Spline, ...]:
    """The closed chain, with a step of the width drawn as a line wherever two neighbours do not meet."""
    chain: list[Line | Arc | Spline] = []
    for segment in segments:
        if chain and not np.allclose(chain[-1].end, segment.start, rtol=0, atol=1e-9):
            chain.append(Line(chain[-1].end, segment.start))
        chain.append(segment)
    if not np.allclose(chain[-1].end, chain[0].start, rtol=0, atol=1e-9):
        chain.append(Line(chain[-1].end, chain[0].start))
    return tuple(chain)


def _tick(x: float, width: float) -> Path:
    """A mark across the strip where the free part ends, kept off its edges so that it is no notch."""
    y = 0.3 * width
    return Path((Line((x, -y), (x, y)),), closed=False)
