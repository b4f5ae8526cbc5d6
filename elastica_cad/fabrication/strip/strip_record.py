"""A strip: the flat part whose width gives a rod its stiffness."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_positive, require_record, several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.fabrication.drawings.lettering import require_engravable
from elastica_cad.fabrication.holding.expected_error import USUAL_TOLERANCE, MakingTolerance
from elastica_cad.fabrication.holding.held_shape import Reactions, closes
from elastica_cad.fabrication.holding.tab_seat import TabSeat
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.outline import Tab, pair_of_tabs
from elastica_cad.fabrication.strip.perforation import DiamondPattern
from elastica_cad.fabrication.strip.shoulders import Shoulder, find_shoulders
from elastica_cad.fabrication.strip.strip_layers import Layer, cut_layers, draw_layers
from elastica_cad.fabrication.strip.strip_sentences import (
    backing_mark,
    tell_backing,
    tell_breadth,
    tell_joint,
    warn_of_creep,
    warn_of_plywood,
    warn_of_strains,
    warn_of_width,
)
from elastica_cad.fabrication.strip.styles import (
    PLAIN,
    Bends,
    Layout,
    Style,
    bends_along,
    correct_layout,
    require_style,
    stations_of,
)
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2
from elastica_cad.mechanics.material.laminated_section import LaminatedSection
from elastica_cad.mechanics.material.section_limits import LayerStrain, StrainVerdict
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.sheet_library import require_printable
from elastica_cad.mechanics.material.stiffness_law import RoundLaw
from elastica_cad.mechanics.rod.rod_record import Rod, as_bent, csv_text, resample
from elastica_cad.mechanics.stability.sideways import (
    SidewaysSection,
    SidewaysStability,
    sideways_stability,
    sideways_stability_of,
    stations_of_sideways,
)
from elastica_cad.mechanics.studies.creep import Creep, creep, require_creep

if TYPE_CHECKING:
    from elastica_cad.fabrication.holding.held_shape import HeldShape
    from elastica_cad.fabrication.strip.as_made import StripAsMade
    from elastica_cad.fabrication.strip.laps import LapPlates


def strip_sideways(rod: Rod, layout: Layout) -> SidewaysStability:
    """The verdict on a rod that is made by a layout; its slots are left out."""
    sheet, ratio = layout.sheet, layout.sheet.shear_ratio
    s = stations_of_sideways(rod)
    K, width = np.interp(s, rod.s, rod.flat_stiffness), layout.width(s)
    if isinstance(layout.section, RoundLaw):
        thickest = float(layout.width.extremes[1])
        return sideways_stability_of(rod, SidewaysSection.round(K, thickest, ratio))
    if isinstance(layout.pattern, DiamondPattern):
        between = SidewaysSection.perforated(
            K, width, layout.material(s), layout.pattern.slopes(s), ligaments=layout.pattern.ligaments,
            thickness=sheet.thickness, shear_ratio=ratio,
        )  # fmt: skip
        return sideways_stability_of(rod, *between)
    if layout.backing is not None:
        section = LaminatedSection(sheet, layout.backing.sheet)
        backing = np.clip(layout.backing.width(s), 0.0, width)
        laminate = SidewaysSection.laminated(K, layout.bending_stiffness, width, backing, section)
        return sideways_stability_of(rod, laminate)
    thickness = sheet.thickness if layout.size is None else layout.size
    return sideways_stability(rod, layout.width, thickness, shear_ratio=ratio)


FINE_EDGES = 1600
"""Least number of edges of the rod that is bent as built, so that its own error is negligible."""


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
    style : Plain, Perforated or Laminated
        How stiffness becomes material. The last two give the strip a width of its own; `max_width` and `min_width`
        then limit the material: the ligaments' sum, the backing.
    ends : pair of Tab
        Tabs at the start and at the end. Of a strip that closes the second is its lap, the first is left out.
    slots : tuple of Slot
        Cuts for other strips; they become part of the outline.
    label : str
        Its name in messages, files and assemblies; empty for none.
    engrave : str, optional
        Text engraved on the strip; empty for none. Unless given its label, in letters that can be engraved.
    creep : float
        Creep factor phi of the sheet in the long run, 0 for none: see `crept`.
    correction : Profile, optional
        Factor on the stiffness from which widths are made, to make up for what else changes it: see
        `compensate_widths`.
    plates : LapPlates, optional
        What joins the pieces of a strip that is longer than the stock.

    tolerance : MakingTolerance
        What is assumed to be off in sheet, cut and clamps: see `held`.

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
    style: Style = PLAIN
    ends: tuple[Tab, Tab] = (Tab(10.0), Tab(10.0))
    slots: tuple[Slot, ...] = ()
    label: str = ""
    engrave: str | None = None
    creep: float = 0.0
    correction: Profile | None = None
    plates: "LapPlates | None" = None
    tolerance: MakingTolerance = USUAL_TOLERANCE

    def __post_init__(self) -> None:
        if not isinstance(self.rod, Rod):
            raise InputError(
                "the rod is a {name}: give a Rod, as optimal_rod makes one", name=type(self.rod).__name__
            )
        if self.rod.follows_bend:  # its widths are those that make it as stiff as it is in this shape
            object.__setattr__(self, "rod", as_bent(self.rod))
        object.__setattr__(self, "sheet", Sheet.of(self.sheet))
        require_style(self.style)
        for name in ("max_width", "min_width"):
            value = getattr(self, name)
            if value is not None:
                require_positive(value, name)
        require_printable(self.label, "the label")
        if self.engrave is not None:
            require_engravable(self.engrave)
        require_record(self.tolerance, MakingTolerance, "the tolerance", "a MakingTolerance")
        if self.correction is not None:
            require_record(self.correction, Profile, "the correction", "a Profile, or None")
        object.__setattr__(self, "ends", pair_of_tabs(self.ends))
        object.__setattr__(self, "slots", several("slots", self.slots, Slot, "Slot"))
        object.__setattr__(self, "creep", require_creep(self.creep))
        if self.is_closed:
            object.__setattr__(self, "ends", (Tab(0.0), self.ends[1]))
            if self.layout.backing is not None or self.layout.size is not None:
                raise InputError(
                    "a closed strip is of one sheet of even thickness, which its lap can join: take a plain or "
                    "perforated strip, or leave a gap between its ends"
                )
        _ = self.layout

    def __repr__(self) -> str:
        called = f" {self.label!r}" if self.label else ""
        size = f"{self.rod.length:.4g} mm long, {self.breadth('.3g')}"
        strain = f"strain {self.max_strain:.2%} of {self.strain_limit:.2%}"
        return f"<Strip{called} of {self.sheet.name}, {size}, {strain}>"

    def _repr_svg_(self) -> str:
        return self.drawing()._repr_svg_()

    def table(self) -> dict[str, FloatArray]:
        """Columns (n,) by name with their unit: those of `Rod.table`, with moments and forces in N mm and N, widths
        in mm and the strain of the most strained skin.
        """
        columns, B = self.rod.table(), self.bending_stiffness
        for name, physical in {
            "moment_1_per_mm": "moment_Nmm", "force_x_1_per_mm2": "force_x_N", "force_y_1_per_mm2": "force_y_N",
        }.items():  # fmt: skip
            columns[physical] = B * columns.pop(name)
        bent = np.abs(self.rod.curvature - self.rod.natural_curvature)
        worst = max(
            self.layout.strains(Bends(bent, self.rod.s)),
            key=lambda layer: layer.largest / layer.limit,
        )
        section, size = self.layout.section, self.layout.size
        more = {} if section is None or size is None else {f"{section.quantity}_mm": size(self.rod.s)}
        return columns | {"width_mm": self.width(self.rod.s)} | more | {"strain": worst.strain}

    def csv(self) -> str:
        """The table as comma-separated text with a header."""
        return csv_text(self.table())

    @property
    def tapered(self) -> dict[str, Profile]:
        """Profile of the quantity that varies instead of the width, "thickness" or "diameter", mm along the
        free part."""
        section, size = self.layout.section, self.layout.size
        if section is None or size is None or section.quantity not in ("thickness", "diameter"):
            return {}  # leaves are counted
        return {section.quantity: size}

    def breadth(self, digits: str = ".2f") -> str:
        """Width in words, with the thickness if it varies: "20.00 mm wide, 2.00 to 3.00 mm thick"."""
        return tell_breadth(self.width, self.tapered, digits)

    @cached_property
    def layout(self) -> Layout:
        """Layout that the style makes of the rod."""
        widths = {"max_width": self.max_width, "min_width": self.min_width}
        if self.correction is None:
            return self.style.laid_out(self.rod, self.sheet, **widths)
        return correct_layout(self.style, self.rod, self.sheet, self.correction, **widths)

    @property
    def width(self) -> Profile:
        """Full width (mm) along the free part [0, length]."""
        return self.layout.width

    @cached_property
    def layers(self) -> tuple[Layer, ...]:
        """The sheets that the strip is made of, the base first."""
        return cut_layers(self.layout, self.ends, self.slots, name=self.label or "strip")

    @property
    def outline(self) -> Path:
        """The closed outer loop with its slots, anticlockwise; its long sides are B-splines."""
        return self.layers[0].outline

    @property
    def _begins_at(self) -> str:
        """Its start as the program shows it in which the curve was drawn."""
        return (self.rod.curve.provenance or Provenance()).shown(self.rod.position[0])

    @property
    def mass_told(self) -> str:
        """The mass in words: in grams, from a thousand of them on in kilograms."""
        return f"{self.mass:.3g} g" if self.mass < 1000 else f"{self.mass / 1000:.3g} kg"

    @property
    def holes(self) -> tuple[Path, ...]:
        """Closed inner loops."""
        return self.layers[0].holes

    def labelled(self, label: str) -> "Strip":
        """The strip under another name; itself where it has it, with all that was worked out."""
        return self if label == self.label else replace(self, label=label)

    def mirrored(self) -> "Strip":
        """The strip turned over about its centre line (y to -y), bent into the same curve; itself if it is even."""
        start, end = (tab.mirrored() for tab in self.ends)
        if not self.slots and (start, end) == self.ends:
            return self
        return replace(self, ends=(start, end), slots=tuple(slot.mirrored() for slot in self.slots))

    @cached_property
    def is_closed(self) -> bool:
        """Whether the strip is closed. Its second tab is then glued behind its start, and it has no first tab."""
        return closes(self.rod)

    @property
    def joint(self) -> str:
        """Sentence on how a closed strip is joined and what the joint carries; empty for an open one."""
        if not self.is_closed:
            return ""
        return tell_joint(self.ends[1].length, self.end_widths[1], self.reactions(), self._begins_at)

    @cached_property
    def end_widths(self) -> tuple[float, float]:
        """Width of the free part at its start and end, mm."""
        return float(self.width(0.0)), float(self.width(self.rod.length))

    @property
    def max_strain(self) -> float:
        """Largest strain of the skin (dimensionless): of the layer that comes nearest to its limit."""
        return self.most_strained.largest

    @property
    def max_strain_at(self) -> float:
        """Arc length of the largest strain, mm."""
        return self._bends.place(self.most_strained.station)

    @property
    def strain_limit(self) -> float:
        """Largest strain that the sheet of the most strained layer bears."""
        return self.most_strained.limit

    @property
    def most_strained(self) -> LayerStrain:
        """The layer that comes nearest to what its sheet bears."""
        return max(self.strains, key=lambda layer: layer.largest / layer.limit)

    @cached_property
    def strain_verdict(self) -> StrainVerdict:
        """Result of the strain rule for the worst of the strip's layers, and of tabs too narrow for their ends."""
        judged = [layer.judged(self._bends.place(layer.station)) for layer in self.strains]
        judged += [shoulder.verdict for shoulder in self._shoulders]
        return max(judged, key=lambda one: (one.state, one.used))

    @property
    def strain_warnings(self) -> tuple[str, ...]:
        """A sentence for each layer or tab strained beyond what its sheet bears: where, and what happens there."""
        return (*warn_of_strains(self.strains, self._bends), *map(str, self._shoulders))

    @cached_property
    def _shoulders(self) -> tuple[Shoulder, ...]:
        return find_shoulders(self.layout, self.ends, self.strains)

    @cached_property
    def strains(self) -> tuple[LayerStrain, ...]:
        """Skin strain of each layer at stations along the strip, with the limit of its sheet."""
        return self.layout.strains(self._bends)

    @cached_property
    def _bends(self) -> Bends:
        if self.layout.stack is None:
            return bends_along(self.rod)
        from elastica_cad.forming.leaf_ends import leaf_bends

        s, bend = leaf_bends(self.rod, self.layout.stack)
        return Bends(bend, s)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Warnings of the rod and the style, and strains beyond a limit."""
        found = (
            *self.rod.warnings,
            *self.layout.warnings,
            *self.strain_warnings,
            *warn_of_width(self.width, self.rod.length, closed=self.is_closed),
        )
        if self.layout.size is not None:
            return found
        creeps = warn_of_creep(self.creep, self.most_strained, lambda: self.crept) if self.creep else ()
        return (*found, *warn_of_plywood(self.layers, self.strains, self._bends), *creeps)

    @cached_property
    def crept(self) -> Creep | None:
        """The strip in the long run, held the same all the time; None without a creep factor.

        Raises
        ------
        NotConvergedError
            It collapses under its weight as it creeps.
        """
        if not self.creep:
            return None
        found = creep(self.rod, self.creep)
        sheets = {layer.sheet for layer in self.layers}
        return found if len(sheets) == 1 else replace(found, exact=False)

    @property
    def area(self) -> float:
        """Area of the flat part (the base of a laminate), mm2."""
        return self.layers[0].area

    @property
    def mass(self) -> float:
        """Mass in g, of all layers."""
        section, size = self.layout.section, self.layout.size
        if section is None or size is None or section.stack is not None:
            return sum(layer.mass for layer in self.layers)
        newtons = section.weight_per_length(size(stations_of(self.rod.length)))
        newtons = (newtons[1:] + newtons[:-1]) / 2
        ends = section.weight_per_length(size([0.0, self.rod.length])) @ [tab.length for tab in self.ends]
        free = float(newtons.mean()) * self.rod.length
        return (free + float(ends)) / STANDARD_GRAVITY_M_S2 * 1e3

    @property
    def end_thicknesses(self) -> tuple[float, float]:
        """Thickness at the start and end of the free part, of all layers there, mm."""
        if self.layout.size is not None:
            start, end = self.layout.size([0.0, self.rod.length]).tolist()
            return start, end
        return (self.layers[-1].high,) * 2

    @property
    def bending_stiffness(self) -> float:
        """B, the E I where K = 1, N mm2; the rod's numbers times B are newtons."""
        return self.layout.bending_stiffness

    @cached_property
    def as_built(self) -> Rod:
        """The rod with the stiffness and weight of what is really cut, to be bent: see `rod_as_built`."""
        from elastica_cad.fabrication.strip.as_made import rod_as_built

        return rod_as_built(self.rod, self.layout, self.layers)

    @cached_property
    def deviation_as_built(self) -> float:
        """How far the strip as built, bent and held as designed, strays from the design, mm.

        Bent on finer nodes than the design's, which may be too coarse for its own stiffness.
        """
        edges = self.rod.s.size - 1
        finer = -(-FINE_EDGES // edges)
        from elastica_cad.fabrication.strip.as_made import curling_by_design

        built, design = (resample(rod, finer * edges + 1) for rod in (self.as_built, self.rod))
        bent = bend(curling_by_design(built, design, self.layout), end=self.rod.position[-1])
        return float(np.hypot(*(bent.position[::finer] - self.rod.position).T).max())

    @cached_property
    def rod_to_bend(self) -> Rod:
        """The rod to be led elsewhere, where what is cut curls as its bend there makes it: see `bend_strip`."""
        from elastica_cad.fabrication.strip.as_made import rod_to_bend

        return rod_to_bend(self.rod, self.layout, corrected=self.correction is not None)

    @cached_property
    def as_made(self) -> "StripAsMade":
        """The strip with all that changes its stiffness, to be held: see `held`."""
        from elastica_cad.fabrication.strip.as_made import StripAsMade

        return StripAsMade.of(self.rod, self.layout, self.ends, self.slots, self.plates, self.whole)

    def whole(self) -> tuple[Layer, ...]:
        """Return the layers without slots."""
        return cut_layers(self.layout, self.ends, (), name="strip") if self.slots else self.layers

    def held(self, start: TabSeat | None = None, end: TabSeat | None = None) -> "HeldShape":
        """The shape of the strip as it is made, in its holders; without one an end is held as designed.

        Raises
        ------
        NotConvergedError
            No rest shape was found.
        """
        for seat in (start, end):
            if seat is not None:
                require_record(seat, TabSeat, "a holder", "a TabSeat, or None")
        asked = self.as_made if self.correction is None else replace(self, correction=None).as_made
        return self.as_made.held((start, end), asked, self.tolerance)

    @cached_property
    def held_deviation(self) -> float:
        """Largest distance, mm, of the strip as made, with its ends held as designed, from its design; see
        `held`."""
        return self.held().deviation

    @cached_property
    def sideways(self) -> SidewaysStability:
        """Stability against leaving the plane of the curve."""
        return strip_sideways(self.rod, self.layout)

    def reactions(self) -> Reactions:
        """Forces (N) and moments (N mm) that the supports exert on the strip.

        The internal force is -lambda B (Eq. 2), so the start is pushed by lambda(0) B and the end by -lambda(L) B.
        """
        B, force, moment = self.bending_stiffness, self.rod.force, self.rod.moment
        return Reactions(B * force[0], float(-B * moment[0]), -B * force[-1], float(B * moment[-1]))

    def drawing(self) -> Drawing:
        """The cut pattern on its layers: text, marks, inner cuts, outer cut; of a laminate that of the base."""
        return self.drawings()[0]

    def drawings(self) -> tuple[Drawing, ...]:
        """The cut pattern of each layer, the base first; they register: same frame, same holes in the tabs.

        Where the backing of a laminate comes to lie is marked on the base, and on both which side of the bend
        their engraved faces are on.
        """
        lap = self.ends[1].length if self.is_closed else 0.0
        engraved = f"{self.engraved} {self._backing_mark}".strip()
        return draw_layers(self.layout, self.layers, self.ends, self.slots, engraved, self.label, lap=lap)

    @property
    def engraved(self) -> str:
        """The text that is engraved on the strip."""
        return self.label if self.engrave is None else self.engrave

    @property
    def backing_side(self) -> str:
        """A sentence on which side of the bend the backing of a laminate lies; empty of other strips."""
        return tell_backing(self._backing_mark)

    @property
    def _backing_mark(self) -> str:
        return "" if self.layout.backing is None else backing_mark(self.rod.curvature)
