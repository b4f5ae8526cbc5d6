"""Flat strip with the stiffness of a rod: outline, strain, mass, reactions, warnings, and position in space."""

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import rows_table
from elastica_cad._types import EMPTY, ArrayLike, FloatArray, Takes, required
from elastica_cad._values import (
    distinct_digits,
    numbers,
    require_positive,
    require_record,
    several,
    three,
    value_key,
)
from elastica_cad.errors import (
    BareLength,
    ElasticaError,
    FieldName,
    InputError,
    Length,
    NotConvergedError,
    Span,
    note,
    rounded_down,
    rounded_up,
    sentences,
)
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import midpoints, norm
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend, has_snapped
from elastica_cad.mechanics.creep_study import Creep, creep, require_creep
from elastica_cad.mechanics.cross_sections import RoundLaw
from elastica_cad.mechanics.discrete_rod import Compression
from elastica_cad.mechanics.elements import require_free_between
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2
from elastica_cad.mechanics.rod import Rod, as_bent, csv_text, resample
from elastica_cad.mechanics.section_limits import (
    BRITTLE,
    STRAIN_SLACK,
    LayerStrain,
    StrainState,
    StrainVerdict,
    judge_strain,
    unit_question,
)
from elastica_cad.mechanics.sheets import (
    PLYWOOD_SOURCE,
    PRINTED_ACCURACY,
    Sheet,
    even_shear_ratio,
    require_flat,
    require_name,
)
from elastica_cad.mechanics.sideways import (
    SidewaysSection,
    SidewaysStability,
    sideways_stability,
    sideways_stability_of,
    stations_of_sideways,
)
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.element_cuts import (
    StrainedCut,
    crossing_warnings,
    cut_holes,
    element_cuts,
    lengths_added_by_cuts,
    strained_cuts,
    widened_for_cuts,
)
from elastica_cad.strip.held_shape import USUAL_TOLERANCE, HeldShape, MakingTolerance, Reactions, closes
from elastica_cad.strip.layers import LapPlates, Layer, cut_layers, draw_layers
from elastica_cad.strip.lettering import LEAST_LABEL_MM, engravable, engraved_names, require_engravable
from elastica_cad.strip.outline import SHOULDER_MM, USUAL_TABS, Ends, Tab, pair_of_tabs
from elastica_cad.strip.perforation import DiamondPattern
from elastica_cad.strip.slots import Cuts, Slot, end_numbers
from elastica_cad.strip.styles import (
    PLAIN,
    Bends,
    Layout,
    Style,
    bends_along,
    correct_layout,
    outline_field,
    require_style,
    stations_of,
)
from elastica_cad.strip.tab_seats import TabSeat

if TYPE_CHECKING:
    from elastica_cad.strip.as_made import StripAsMade


FILLETS = (
    (1.020, 1.009, -0.048),
    (-0.065, -0.165, -0.007),
    (-3.459, 1.266, -0.016),
    (3.505, -2.109, 0.069),
)
DEEPEST, GRAIN = 20.0, 0.7
"""Constants of `corner_factor`, where t is the depth of the shoulder and r is the radius of the fillet.

`DEEPEST` is the largest ratio t / r in the chart. In `FILLETS`, row i is multiplied by (2 t / width)^i and
column j by (t / r)^(j / 2). In a sheet with grain, the excess of the factor over 1 is multiplied by g ** `GRAIN`,
where g is sqrt(E / G) divided by its isotropic value. The exponent is fitted to finite elements
(`tests/campaign/finite_elements/shoulders.py`)."""


def corner_factor(sheet: Sheet, width: float, tab: float) -> float:
    """Return the strain in the corners beside a tab, divided by the mean strain across the tab.

    Strip and tab are bent by the same moment. The factor is based on a flat bar in tension with shoulders of
    depth t and fillets of radius r (Pilkey, Peterson's Stress Concentration Factors, chart 3.1). In a bent
    plate, the excess of the factor over 1 is multiplied by (1 + nu) / (3 + nu), as beside an elliptic hole
    (Goodier, Phil. Mag. 22, 1936). The fillet radius is assumed to be the thickness of the sheet. In a sharp
    corner, the mean strain over a quarter of the thickness is about the same. The strain is lower if the tab is
    clamped up to the shoulder. Solid elements in CalculiX agree within 15 %.

    Parameters
    ----------
    width, tab : float
        Widths of the end of the strip and of its tab, mm.

    Examples
    --------
    >>> round(corner_factor(Sheet("even", 1.0, 12.0, density=1000.0, max_strain=0.01), 30, 15), 2)
    1.75
    """
    depth, nu = (width - tab) / 2, min(sheet.poisson_ratio, 0.5)
    sharp = np.sqrt(min(depth / sheet.thickness, DEEPEST))
    tension = float(np.polynomial.polynomial.polyval2d(2 * depth / width, sharp, FILLETS))
    grain = np.sqrt(even_shear_ratio(nu) / sheet.shear_ratio)
    return float(1 + (1 + nu) / (3 + nu) * grain**GRAIN * max(tension - 1, 0.0))


@dataclass(frozen=True)
class Shoulder:
    """An end of a strip with a narrower tab.

    `at` is the arc length of the end, mm. `width` and `tab` are the widths of strip and tab, mm. `strain` is the
    mean surface strain across the tab. `room` is the width of the widest tab that fits into its holder, mm.
    """

    at: float
    width: float
    tab: float
    sheet: Sheet
    strain: float
    room: float = np.inf

    @property
    def verdict(self) -> StrainVerdict:
        """Verdict on the strain of the tab.

        The mean strain decides whether the tab breaks. In a brittle sheet, the higher strain in the corners causes
        a warning. In other sheets, yielding or creep reduces that strain.
        """
        mean = judge_strain(self.sheet, self.strain, self.at)
        if mean.refused or self.sheet.kind not in BRITTLE:
            return mean
        peak = self.strain * corner_factor(self.sheet, self.width, self.tab)
        judged = judge_strain(self.sheet, peak, self.at)
        return replace(judged, state=min(judged.state, StrainState.WARNED))

    @property
    def least_tab(self) -> float | None:
        """Least width of the tab, mm, that keeps its strain within the limit; None if no tab is wide enough."""
        if not judge_strain(self.sheet, self.strain * self.tab / self.width, self.at).allowed:
            return None
        wider = np.linspace(self.tab, self.width, 100)[1:-1]
        tried = (
            replace(self, tab=float(width), strain=self.strain * self.tab / float(width)) for width in wider
        )
        return next(
            (rounded_up(shoulder.tab, 3) for shoulder in tried if shoulder.verdict.allowed), self.width
        )

    @property
    def _advice(self) -> str:
        least = self.least_tab
        if self.room < min(self.width, least or np.inf):
            return note(
                "The ring has no room for a tab wider than {room}. Make the curve gentler there.",
                room=Length(self.room),
            )
        if least is None:
            return note("Make the curve gentler there, and the tab wider.")
        # `at` is 0 at the start
        wider = f"{{ width = {least:g}, ... }}"
        tabs = ("{ ... }", wider) if self.at else (wider, "{ ... }")
        return note(
            "Make the tab at the {end} at least {least} wide (in a design file: {written}), or the curve "
            "gentler there.",
            end=note("end" if self.at else "start"),
            least=Length(least),
            written=f"ends = [{', '.join(tabs)}]",
        )

    def __str__(self) -> str:
        judged, bears = self.verdict, self.sheet.max_strain
        peak = judged.used * bears
        strain, limit = distinct_digits(100 * peak, 100 * bears, ".2g")
        place = note(
            "in the corners beside the tab" if peak > self.strain * (1 + STRAIN_SLACK) else "across the tab"
        )
        return note(
            "At {at} from the start, the strip is {width} wide and its tab is {tab} wide. The strain "
            "{place} is {strain:g} %; {sheet} allows {limit:g} %: {outcome}. {advice}",
            at=Length(self.at), width=Length(self.width), tab=Length(self.tab), place=place, strain=strain,
            limit=limit, sheet=self.sheet.name, outcome=note(judged.outcome), advice=self._advice,
            severity="warning",
        )  # fmt: skip


def _overstrained_tabs(
    layout: Layout, ends: Ends, strains: Sequence[LayerStrain], rooms: tuple[float, float]
) -> tuple[Shoulder, ...]:
    """Return the tabs, narrower than their strip, whose strain is not allowed.

    `rooms` are the widths, mm, of the widest tabs that fit into the holders at start and end.
    """
    # a strip of varying thickness or diameter is as wide in its tabs
    if layout.size is not None:
        return ()
    shoulders = []
    for at, tab, station, room in zip((0.0, layout.width.length), ends, (0, -1), rooms, strict=True):
        width = float(layout.width(at))
        if not tab.length or tab.width is None or tab.width > width - SHOULDER_MM:
            continue
        # in both arrays, the end of the strip is first, and the tab second
        widths = np.array([layout.material(at), tab.width])
        glued = None if layout.backing is None else np.array([layout.backing.width(at), tab.width])
        section, parameter = layout.section_of(widths, glued)
        wide, narrow = section.bending_stiffness(parameter).tolist()
        # strip and tab have the same moment, so the strain grows as the stiffness decreases
        shoulders += [
            Shoulder(at, width, tab.width, layer.sheet, float(layer.strain[station]) * wide / narrow, room)
            for layer in strains
        ]
    return tuple(shoulder for shoulder in shoulders if not shoulder.verdict.allowed)


LINEAR_CREEP_FRACTION = 0.5
"""Fraction of the strain limit above which creep grows faster than the stress."""


def _mark_on_backing(curvature: FloatArray) -> str:
    """Return "INSIDE" or "OUTSIDE": the side of the bend to which the engraved face of a laminate points.

    Seen from the start, the backing is on the right of the curve. If the curvature changes sign, "AT START" is
    added. For a straight strip, return an empty string.
    """
    # up to this curvature, the strip counts as straight at a point
    bent = curvature[np.abs(curvature) > 1e-6 * np.abs(curvature).max(initial=0.0)]
    if not bent.size:
        return ""
    word = "OUTSIDE" if bent[0] > 0 else "INSIDE"
    return word if np.all(np.sign(bent) == np.sign(bent[0])) else f"{word} AT START"


BACKING_SIDES: Mapping[str, str] = {
    "INSIDE": note("When the strip is bent, the backing is on the inside."),
    "OUTSIDE": note("When the strip is bent, the backing is on the outside."),
    "INSIDE AT START": note(
        "When the strip is bent, the backing is on the inside of the bend at the start (x = 0 in the cutting "
        "files). After an inflection, the same face is on the outside."
    ),
    "OUTSIDE AT START": note(
        "When the strip is bent, the backing is on the outside of the bend at the start (x = 0 in the cutting "
        "files). After an inflection, the same face is on the inside."
    ),
}
"""Sentence for each word that is engraved on a laminate."""


def _warn_of_strains(
    strains: Sequence[LayerStrain], bends: Bends, advice_unloaded: str | None = None
) -> Iterator[str]:
    """Yield the warnings about overstrained layers, of a strip without its loads if its advice is given."""
    bend = bends.amount
    for layer in strains:
        at = layer.station
        judged = layer.judged(bends.place(at))
        if not judged.allowed:
            # change of curvature, 1/mm, at which the layer would reach its limit
            bearable = bend[at] * layer.limit / layer.largest
            strain, limit = distinct_digits(100 * layer.largest, 100 * layer.limit, ".2g")
            radius, least = distinct_digits(1 / bend[at], rounded_up(1 / bearable, 3), ".3g")
            question = unit_question(layer.largest / layer.limit, bends.place(-1))
            if advice_unloaded is not None:
                yield note(
                    "Without its loads, the strip is strained by {strain:g} % at {at} from the start; {sheet} "
                    "allows {limit:g} %: {outcome}. {advice}",
                    strain=strain, at=Length(judged.at or 0.0), sheet=layer.name, limit=limit,
                    outcome=note(judged.outcome), advice=advice_unloaded, severity="warning",
                )  # fmt: skip
                continue
            yield note(
                "The strain is {strain:g} % at {at} from the start; {sheet} allows {limit:g} %: {outcome}. "
                "Use thinner material, or a radius of at least {least:g} there (now {radius:g}).{question}",
                strain=strain, at=Length(judged.at or 0.0), limit=limit, sheet=layer.name, radius=Length(radius),
                least=Length(least), outcome=note(judged.outcome), severity="warning",
                question=f" {question}" if question else "",
            )  # fmt: skip


def _warn_of_width(width: Profile, length: float, field: FieldName, *, closed: bool) -> Iterator[str]:
    start, end = width([0.0, length]).tolist()
    # a smaller step at the joint needs no warning
    if closed and abs(end - start) > 0.05:
        yield note(
            "The ends of the closed strip do not fit together: one is {start:.3g} wide, the other {end}. Choose "
            "another place for the joint, leave out gravity, or make the curvature continuous there.",
            start=BareLength(start), end=Length(end), severity="warning",
        )  # fmt: skip
    widest = width.extremes[1]
    if widest > length:
        yield note(
            "The strip is {width} wide but only {length} long, so it bends as a plate. Set a smaller "
            "{field}, and check its unit.",
            field=field,
            width=Length(widest), length=Length(length), severity="warning",
        )  # fmt: skip


def _warn_of_plywood(layers: Sequence[Layer], strains: Sequence[LayerStrain], bends: Bends) -> Iterator[str]:
    bend = bends.amount
    tightest = int(bend.argmax())
    for cut, layer in zip(layers, strains, strict=False):
        least = cut.sheet.published_radius
        if least is not None and layer.judged().allowed and bend[tightest] * least > 1 + PRINTED_ACCURACY:
            yield note(
                "The radius is {radius} at {at} from the start. Plywood {thickness:g} thick needs at least "
                "{least} {grain} the face grain ({source}). Use a thinner sheet or a gentler curve.",
                radius=Length(rounded_down(1 / bend[tightest], 3)), at=Length(bends.place(tightest)),
                thickness=Length(cut.sheet.thickness), least=Length(least),
                grain=note(cut.sheet.grain), source=PLYWOOD_SOURCE, severity="warning",
            )  # fmt: skip


def _warn_of_creep(factor: float, strained: LayerStrain, crept: Callable[[], Creep | None]) -> Iterator[str]:
    """Yield warnings if the strain is too large for linear creep, and if the strip snaps after creep."""
    if strained.largest > LINEAR_CREEP_FRACTION * strained.limit:
        yield note(
            "The strain of {strain:.2f} % is more than {share:.0f} % of the limit of the material, so creep there "
            "is larger than computed. Use thinner material or a gentler curve.",
            strain=100 * strained.largest, share=100 * LINEAR_CREEP_FRACTION, severity="warning",
        )  # fmt: skip
    try:
        later = crept()
    except NotConvergedError as problem:
        yield str(problem)
        return
    if later is not None and not later.stays:
        yield note(
            "Over the years the strip snaps into another shape (creep factor {factor:g}). Use a stiffer "
            "sheet, or support the strip.",
            factor=factor, severity="warning",
        )  # fmt: skip


_sideways: WeakKeyDictionary[Rod, dict[Hashable, SidewaysStability]] = WeakKeyDictionary()
"""Cache of `strip_sideways`. The first key is the rod; the second key determines the cross sections."""

_unloaded: WeakKeyDictionary[Rod, dict[Hashable, "Rod | ElasticaError"]] = WeakKeyDictionary()
"""Cache of the rods of strips without their loads, or of the errors of `bend`, with the same keys."""


def strip_sideways(rod: Rod, layout: Layout) -> SidewaysStability:
    """Return the sideways stability of a rod with the cross sections of a layout. Slots are ignored."""
    sheet, ratio = layout.sheet, layout.sheet.shear_ratio
    s = stations_of_sideways(rod)
    K, width = np.interp(s, rod.s, rod.flat_stiffness), layout.width(s)
    if isinstance(layout.section, RoundLaw):
        return sideways_stability_of(rod, SidewaysSection.round(K, layout.width.extremes[1], ratio))
    if isinstance(layout.pattern, DiamondPattern):
        between = SidewaysSection.perforated(
            K, width, layout.material(s), layout.pattern.slopes(s), ligaments=layout.pattern.ligaments,
            thickness=sheet.thickness, shear_ratio=ratio,
        )  # fmt: skip
        return sideways_stability_of(rod, *between)
    if layout.backing is not None:
        section = LaminatedSection(sheet, layout.backing.sheet)
        backing = layout.backing.width(s).clip(0.0, width)
        laminate = SidewaysSection.laminated(K, layout.bending_stiffness, width, backing, section)
        return sideways_stability_of(rod, laminate)
    thickness = sheet.thickness if layout.size is None else layout.size
    return sideways_stability(rod, layout.width, thickness, shear_ratio=ratio)


@dataclass(frozen=True, eq=False)
class Strip:
    """A flat strip that takes the shape of `rod` when its ends are held like the ends of the rod.

    Parameters
    ----------
    rod : Rod
        Rod from `optimal_rod`, `nearest_rod` or `bend`.
    sheet : Sheet
        Sheet from which the strip is cut.
    max_width, min_width : float, optional
        Largest and least width, mm. At least one is required, because the rod determines widths only up to a
        factor. With both, `max_width` determines the widths, and `min_width` is a limit. If the rod has a bending
        stiffness in N mm2, this stiffness determines the widths, and `max_width` and `min_width` are limits.
    style : Plain, Perforated or Laminated
        Style of the strip: solid, with holes, or with a glued backing. In a strip with holes, `max_width` and
        `min_width` limit the total width of the ligaments. In a laminate, they limit the width of the backing.
    ends : pair of Tab
        Tabs at the start and at the end. In a closed strip, the first tab is ignored, and the second is the lap.
    slots : tuple of Slot
        Slots for other strips, which become part of the outline.
    label : str
        Name in messages, files and assemblies; empty for none.
    engrave : str, optional
        Text engraved on the strip; an empty string for none. By default the label is engraved.
    creep : float
        Long-term creep factor phi of the sheet, 0 for none: see `crept`.
    correction : Profile, optional
        Factor on the stiffness from which the widths are computed. It compensates effects such as slots: see
        `compensate_widths`.
    plates : LapPlates, optional
        Plates that join the pieces of a strip that is longer than the stock.
    tolerance : MakingTolerance
        Assumed deviations of sheet, cut and clamps: see `held`.
    joints : (str, str)
        Names, such as "J1", that are engraved at the start and the end of the bent part, where another strip
        continues; empty for other ends.
    unmarked : bool
        True if nothing will be engraved or marked on the parts, as by a cutting service. Messages then mention no
        engraving.

    Notes
    -----
    In the flat pattern, x is the arc length from the start of the bent part, and y = 0 is the centre line. The
    long sides are cubic B-splines. The x coordinates of their control points are the Greville abscissae of the
    knots, so that y(x) is exactly half the width.

    Examples
    --------
    >>> strip = Strip(Rod.straight(100, [1, 2, 1]), Sheet.named("card-200gsm"), max_width=20)
    >>> round(strip.outline.length, 1) > 200
    True
    """

    rod: Rod
    sheet: Takes[Sheet, Sheet | str] = required()  # noqa: RUF009
    max_width: float | None = None
    min_width: float | None = None
    style: Style = PLAIN
    ends: Takes[tuple[Tab, Tab], Tab | Sequence[Tab]] = USUAL_TABS
    slots: Takes[tuple[Slot, ...], Slot | Sequence[Slot]] = EMPTY
    label: str = ""
    engrave: str | None = None
    creep: float = 0.0
    correction: Profile | None = None
    plates: LapPlates | None = None
    tolerance: MakingTolerance = USUAL_TOLERANCE
    joints: tuple[str, str] = ("", "")
    unmarked: bool = False

    def __post_init__(self) -> None:
        require_record(self.rod, Rod, "the rod", "a Rod, such as the result of optimal_rod")
        if self.rod.follows_bend:
            object.__setattr__(self, "rod", as_bent(self.rod))
        require_style(self.style)
        for name in ("max_width", "min_width"):
            value = getattr(self, name)
            if value is not None:
                require_positive(value, name)
        if self.engrave is not None:
            require_engravable(self.engrave)
        require_record(self.tolerance, MakingTolerance, "the tolerance", "a MakingTolerance")
        require_record(self.correction, Profile | None, "the correction", "a Profile, or None")
        slots = several("slots", self.slots, Slot, "Slot")
        for slot in slots:
            slot.require_rad()
        missing = [notch for cut in element_cuts(self.rod) for notch in cut.missing_from(slots)]
        vars(self).update(
            sheet=Sheet.of(self.sheet),
            label=require_name(self.label, "the label"),
            ends=pair_of_tabs(self.ends, self.rod.supports),
            slots=(*slots, *missing),
            creep=require_creep(self.creep),
        )
        if self.is_closed:
            object.__setattr__(self, "ends", (Tab(0.0), self.ends[1]))
            if self.layout.backing is not None or self.layout.size is not None:
                raise InputError(
                    "a closed strip needs one sheet of even thickness for its joint: use a plain or "
                    "perforated strip, or leave a gap between the ends"
                )
        if self.layout.size is None:
            require_flat(self.sheet)

    def __repr__(self) -> str:
        called = f" {self.label!r}" if self.label else ""
        size = f"{self.rod.length:.4g} mm long, {self.breadth('.3g')}"
        strain = f"strain {self.max_strain:.2%} of {self.strain_limit:.2%}"
        return f"<Strip{called} of {self.sheet.name}, {size}, {strain}>"

    def _repr_svg_(self) -> str:
        return self.drawing()._repr_svg_()

    def _repr_html_(self) -> str:
        summary = import_module("elastica_cad.strip.summary")  # avoid a circular import
        return self._repr_svg_() + rows_table(repr(self), summary.strip_rows(self))

    def table(self) -> dict[str, FloatArray]:
        """Return the columns (n,) of `Rod.table` in N and N mm, the widths in mm, and the largest surface
        strains.
        """
        columns, B = self.rod.table(), self.bending_stiffness
        for name, physical in {
            "moment_1_per_mm": "moment_Nmm", "force_x_1_per_mm2": "force_x_N", "force_y_1_per_mm2": "force_y_N",
        }.items():  # fmt: skip
            columns[physical] = B * columns.pop(name)
        worst = max(
            self.layout.strains(Bends(np.abs(self.rod.curvature - self.rod.natural_curvature), self.rod.s)),
            key=lambda layer: layer.largest / layer.limit,
        )
        more = {f"{name}_mm": size(self.rod.s) for name, size in self.tapered.items()}
        return columns | {"width_mm": self.width(self.rod.s)} | more | {"strain": worst.strain}

    def csv(self) -> str:
        """Return the columns of `table` as comma-separated text with a header."""
        return csv_text(self.table())

    @property
    def tapered(self) -> dict[str, Profile]:
        """The varying "thickness" or "diameter", mm, by its name; empty if neither varies."""
        section, size = self.layout.section, self.layout.size
        return {} if section is None or size is None else {section.quantity: size}

    def breadth(self, digits: str = ".2f") -> str:
        """Return a text such as "20.00 mm wide, 2.00 to 3.00 mm thick". A constant thickness is left out."""
        sizes = {"width": self.width, **self.tapered}
        spans: dict[str, Any] = {name: Span.of(*size.extremes, digits) for name, size in sizes.items()}
        if "diameter" in spans:
            return note("{diameter} in diameter", diameter=spans["diameter"])
        return note("{width} wide, {thickness} thick" if "thickness" in spans else "{width} wide", **spans)

    @cached_property
    def layout(self) -> Layout:
        """Flat pattern of the rod in the style of the strip."""
        widths = {"max_width": self.max_width, "min_width": self.min_width}

        def laid_out(factor: Profile) -> Layout:
            return correct_layout(self.style, self.rod, self.sheet, factor, **widths)

        if self.correction is not None:
            return laid_out(self.correction)
        return widened_for_cuts(self.rod, self.style.laid_out(self.rod, self.sheet, **widths), laid_out)

    @property
    def width(self) -> Profile:
        """Full width, mm, along the bent part [0, length]."""
        return self.layout.width

    @cached_property
    def layers(self) -> tuple[Layer, ...]:
        """Sheets of the strip, the base layer first."""
        holes = cut_holes(self.rod, self.ends)
        return cut_layers(self.layout, self.ends, self.slots, holes, name=self.label)

    def cut_as(self, other: "Strip") -> "Strip":
        """Copy the computed layers of another strip with the same `cut_key`, and return this strip."""
        vars(self)["layers"] = other.layers
        return self

    @property
    def outline(self) -> Path:
        """Closed outline with slots, anticlockwise. Its long sides are B-splines."""
        return self.layers[0].outline

    @property
    def holes(self) -> tuple[Path, ...]:
        """Closed loops of the holes."""
        return self.layers[0].holes

    def bent_as(self, rod: Rod) -> "Strip":
        """Return the strip with the same cut in another shape, such as a step of `bend_strip`, under its loads.

        `rod` is `rod_to_bend`, or the result of `bend` for it. The new strip can be bent further from this shape.
        """
        # not `replace`, because the fields are checked already
        bent = object.__new__(type(self))
        vars(bent).update({field.name: getattr(self, field.name) for field in fields(self)})
        # the layout is that of the design; the shape without loads is not computed for a step, and `rod` keeps its
        # loads
        vars(bent).update(rod=rod, rod_to_bend=rod, layout=self.layout, _unloaded=None)
        return bent

    def labelled(self, label: str) -> "Strip":
        """Return the strip with another label.

        If the label is the same, return the strip itself with its cached results.
        """
        return self if isinstance(label, str) and label == self.label else replace(self, label=label)

    def mirrored(self) -> "Strip":
        """Return the strip turned over about its centre line (y to -y).

        The new strip bends into the same curve. A symmetric strip is returned unchanged.
        """
        start, end = (tab.mirrored() for tab in self.ends)
        if not self.slots and (start, end) == self.ends:
            return self
        return replace(self, ends=(start, end), slots=tuple(slot.mirrored() for slot in self.slots))

    @cached_property
    def is_closed(self) -> bool:
        """True if the strip is closed.

        A closed strip has only the second tab, which is glued to the inside of the start.
        """
        return closes(self.rod)

    @property
    def joint(self) -> str:
        """Sentence on the joint of a closed strip and its load; empty for an open strip."""
        if not self.is_closed:
            return ""
        lap, (_, (force, moment)) = self.ends[1].length, self.reactions().sizes
        how = note(
            "bend the tab of {lap} at the end of the strip along the curve, and glue it to the inside of the start"
            if lap
            else "join its two ends butt to butt",
            lap=Length(lap),
        )
        return note(
            "closed: {how} at {place}, where the strip is {width} wide; the joint carries {moment:.3g} and "
            "{force:.2g}",
            how=how, place=(self.rod.curve.provenance or Provenance()).shown(self.rod.position[0]),
            width=Length(self.end_widths[1]), moment=moment, force=force,
        )  # fmt: skip

    @property
    def is_widest(self) -> bool:
        """False if the loads determine the widths, and the strip is narrower than `max_width`."""
        return self.max_width is None or self.width.extremes[1] > 0.99 * self.max_width

    @cached_property
    def end_widths(self) -> tuple[float, float]:
        """Widths of the bent part at its start and end, mm."""
        return float(self.width(0.0)), float(self.width(self.rod.length))

    @property
    def max_strain(self) -> float:
        """Largest surface strain (dimensionless) of the layer nearest to its limit, with or without the loads."""
        return self.most_strained.largest

    @property
    def max_strain_at(self) -> float:
        """Arc length of the largest strain, mm."""
        layer, bends = self._most_strained
        return bends.place(layer.station)

    @property
    def strain_limit(self) -> float:
        """Strain limit of the layer nearest to its limit."""
        return self.most_strained.limit

    @property
    def most_strained(self) -> LayerStrain:
        """Layer whose strain is nearest to the limit of its sheet, with or without the loads of the strip."""
        return self._most_strained[0]

    @property
    def _most_strained(self) -> tuple[LayerStrain, Bends]:
        # the `most_strained` layer, and the bends at the stations of its strains
        layers = ((layer, bends) for _, bends, strains in self._loadings for layer in strains)
        return max(layers, key=lambda item: item[0].largest / item[0].limit)

    @cached_property
    def strain_verdict(self) -> StrainVerdict:
        """Worst verdict on the strain of layers, of tabs, and of cuts for pins and ties.

        The strip is judged with its loads and without them.
        """
        judged: list[StrainVerdict] = []
        for (rod, bends, strains), shoulders in zip(self._loadings, self._shoulders, strict=True):
            verdicts = [layer.judged(bends.place(layer.station)) for layer in strains]
            verdicts += [shoulder.verdict for shoulder in shoulders]
            judged += [replace(verdict, unloaded=rod is not self.rod) for verdict in verdicts]
        return max(judged, key=lambda verdict: (verdict.state, verdict.used))

    @property
    def unit_question(self) -> str:
        """Question about the unit of a curve that is too small for the sheet, or ""."""
        return unit_question(self.strain_verdict.used, self.rod.length)

    @property
    def strain_warnings(self) -> tuple[str, ...]:
        """Warnings about each layer, tab, and cut for a pin or tie that is strained beyond its limit."""
        (_, bends, loaded), *without_loads = self._loadings
        warnings = (*_warn_of_strains(loaded, bends), *map(str, self._shoulders[0]))
        if not without_loads:
            return warnings
        advice = note("Support the strip between its ends, or draw another curve.")
        if self.is_widest:  # a wider strip is bent less by its loads
            advice = note(
                "Make the strip wider ({field}), or reduce its loads.", field=outline_field(self.style)
            )
        [(_, bends, empty)] = without_loads
        shoulders = (
            note("{text} This is the strain without the loads.", text=str(shoulder), severity="warning")
            for shoulder in self._shoulders[1]
        )
        return (*warnings, *_warn_of_strains(empty, bends, advice), *shoulders)

    @property
    def _tab_rooms(self) -> tuple[float, float]:
        """Widths of the widest tabs that fit into the holders at both ends, mm."""
        return np.inf, np.inf

    @cached_property
    def _loadings(self) -> tuple[tuple[Rod, Bends, tuple[LayerStrain, ...]], ...]:
        """Rod, bends and strains with the loads and, if the strip has loads, without them."""
        rods = [self.rod] if self.unloaded is None else [self.rod, self.unloaded]
        bent = [(rod, self._bends_of(rod)) for rod in rods]
        return tuple((rod, bends, self.layout.strains(bends)) for rod, bends in bent)

    @cached_property
    def _shoulders(self) -> tuple[tuple[Shoulder | StrainedCut, ...], ...]:
        """Overstrained tabs and cuts for each of the `_loadings`."""
        return tuple(
            (
                *_overstrained_tabs(self.layout, self.ends, strains, self._tab_rooms),
                *strained_cuts(rod, self.layout),
            )
            for rod, _, strains in self._loadings
        )

    @property
    def strains(self) -> tuple[LayerStrain, ...]:
        """Surface strain of each layer at stations along the strip, with the limit of its sheet."""
        return self._loadings[0][2]

    @property
    def unloaded_strains(self) -> tuple[LayerStrain, ...]:
        """Surface strain of each layer of the strip without its loads; empty if `unloaded` is None."""
        return () if self.unloaded is None else self._loadings[1][2]

    def _bends_of(self, rod: Rod) -> Bends:
        """Return the change of curvature along a shape of this strip; in glued plies it jumps at ply ends."""
        if self.layout.stack is None:
            return bends_along(rod)
        from elastica_cad.form_finding.leaf_ends import leaf_bends

        s, amount = leaf_bends(rod, self.layout.stack)
        return Bends(amount, s)

    @property
    def unloaded(self) -> Rod | None:
        """Rest shape of the strip without its hung masses and point forces. Its own weight remains.

        The result is None if the strip has no loads, or if no rest shape was found, which is one of the `warnings`.
        """
        rod = self._unloaded
        return rod if isinstance(rod, Rod) else None

    @cached_property
    def _unloaded(self) -> "Rod | ElasticaError | None":
        """Rest shape without the loads, or the error of its computation; None for a strip without loads.

        Strips of the same rod and sections share it.
        """
        if not self.rod.has_loads:
            return None
        known = _unloaded.setdefault(self.rod, {})
        if self._section_key not in known:
            try:
                # an unstable shape is replaced by the shape into which the strip snaps: see `unloading_warnings`
                known[self._section_key] = bend(self.rod_to_bend, loads=(), settle=True)
            except (InputError, NotConvergedError) as problem:
                known[self._section_key] = problem
        return known[self._section_key]

    @property
    def _section_key(self) -> Hashable:
        # key of all fields, besides the rod, that determine the cross sections
        key: Hashable = value_key((self.style, self.sheet, self.correction, self.max_width, self.min_width))
        return key

    @property
    def unloading_warnings(self) -> tuple[str, ...]:
        """Warning that the strip snaps without its loads, or that no rest shape was found."""
        rod = self._unloaded
        if isinstance(rod, ElasticaError):
            text = "The shape of the strip without its loads was not found. {problem}"
            return (note(text, problem=str(rod), severity="warning"),)
        if rod is None or not has_snapped(rod):
            return ()
        text = (
            "Without its loads, the strip snaps into another shape. Support the strip between its ends, or draw "
            "another curve."
        )
        return (note(text, severity="warning"),)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """All warnings about the strip."""
        warnings = (
            *self.rod.warnings,
            *self.layout.warnings,
            *self.strain_warnings,
            *self.unloading_warnings,
            *crossing_warnings(self.rod, self.width),
            *_warn_of_width(self.width, self.rod.length, outline_field(self.style), closed=self.is_closed),
        )
        if self.layout.size is not None:
            return warnings
        creeps = _warn_of_creep(self.creep, self.most_strained, lambda: self.crept) if self.creep else ()
        return (
            *warnings,
            *_warn_of_plywood(self.layers, self.strains, self._loadings[0][1]),
            *creeps,
            *self._label_notes,
        )

    @property
    def _label_notes(self) -> Iterator[str]:
        """Notes on a label that is engraved as a number, or is not engraved at all."""
        if not self.engraved or self.unmarked:
            return
        if self.number:
            yield note(
                "The strip is engraved with the number {number}, because the engraving has no letters for its "
                "name: {number} = {label}",
                number=self.number, label=self.label,
            )  # fmt: skip
        label = engravable(self.engraved)
        if not any(text.text.startswith(label) for text in self.drawing().texts):
            yield note(
                "The label {label} is not engraved, because no place on the strip has room for letters {height} "
                "high. Write the name on the strip.",
                label=self.engraved, height=Length(LEAST_LABEL_MM),
            )  # fmt: skip

    @cached_property
    def crept(self) -> Creep | None:
        """Strip after creep with its ends held all the time, or None if `creep` is 0.

        Raises
        ------
        NotConvergedError
            The strip collapses under its weight as it creeps.
        """
        if not self.creep:
            return None
        crept = creep(self.rod, self.creep)
        return crept if len({layer.sheet for layer in self.layers}) == 1 else replace(crept, exact=False)

    @property
    def area(self) -> float:
        """Area of the flat strip, or of the base of a laminate, mm2."""
        return self.layers[0].area

    @property
    def mass(self) -> float:
        """Mass of all layers, g."""
        if self.layout.worked_size is None:
            return sum(layer.mass for layer in self.layers)
        section, size = self.layout.section_at(stations_of(self.rod.length))
        newtons = section.weight_per_length(size)
        free = float((newtons[1:] + newtons[:-1]).mean()) / 2 * self.rod.length
        ends = float(newtons[[0, -1]] @ [tab.length for tab in self.ends])
        return (free + ends) / STANDARD_GRAVITY_M_S2 * 1e3

    @property
    def end_thicknesses(self) -> tuple[float, float]:
        """Thickness of all layers together at the start and end of the bent part, mm."""
        if self.layout.size is not None:
            start, end = self.layout.size([0.0, self.rod.length]).tolist()
            return start, end
        return (self.layers[-1].high,) * 2

    @property
    def bending_stiffness(self) -> float:
        """Bending stiffness E I where the relative stiffness K is 1, N mm2.

        Forces of the rod multiplied by this value are in N.
        """
        return self.layout.bending_stiffness

    @cached_property
    def as_built(self) -> Rod:
        """Rod with the stiffness and weight of the cut strip.

        It is not in equilibrium: see `rod_as_built`.
        """
        from elastica_cad.strip.as_made import rod_as_built

        added = lengths_added_by_cuts(self.rod, self.width, self.sheet)
        return rod_as_built(self.rod, self.layout, self.whole() if added else self.layers, added)

    @cached_property
    def deviation_as_built(self) -> float:
        """Largest distance of the cut strip from its design, mm, with its ends held as designed.

        The rod has more nodes than the design, because the stiffness of the cut strip varies more.
        """
        edges = self.rod.s.size - 1
        # with 1600 edges or more, the discretization error is negligible
        finer = -(-1600 // edges)
        from elastica_cad.strip.as_made import curling_by_design

        built, design = (resample(rod, finer * edges + 1) for rod in (self.as_built, self.rod))
        bent = bend(curling_by_design(built, design, self.layout), end=self.rod.position[-1])
        return float(norm(bent.position[::finer] - self.rod.position).max())

    @cached_property
    def rod_to_bend(self) -> Rod:
        """Rod for moving the ends of the strip: see `bend_strip`.

        The stiffness includes curling across the strip. The rod also stretches and shortens under axial
        force.
        """
        from elastica_cad.strip.as_made import rod_to_bend

        rod = rod_to_bend(self.rod, self.layout, corrected=self.correction is not None)
        if rod.bending_stiffness is None:  # loads in N need a bending stiffness in N mm2
            rod = replace(rod, bending_stiffness=self.bending_stiffness)
        section, parameter = self.layout.section_at(midpoints(rod.s))
        compliance = self.bending_stiffness / section.axial_stiffness(parameter)
        return replace(rod, compression=Compression(compliance, rod.discrete.pull))

    @property
    def compressed_length(self) -> float:
        """Shortening of the designed strip by its axial force, mm; negative if the force stretches the strip.

        The strip takes the drawn curve if its ends are held closer together by this length.
        """
        rod = self.rod_to_bend
        assert rod.compression is not None
        return float(rod.discrete.edge_lengths @ (rod.compression.compliance * rod.compression.pull))

    @cached_property
    def as_made(self) -> "StripAsMade":
        """Model of the strip with all effects on its stiffness, for `held`."""
        from elastica_cad.strip.as_made import StripAsMade

        return StripAsMade.of(self.rod, self.layout, self.ends, self.slots, self.plates, self.whole)

    def whole(self) -> tuple[Layer, ...]:
        """Return the layers without slots and without holes for pins and ties."""
        cut = self.slots or element_cuts(self.rod)
        return cut_layers(self.layout, self.ends, (), name="") if cut else self.layers

    def held(self, start: TabSeat | None = None, end: TabSeat | None = None) -> HeldShape:
        """Return the shape of the finished strip in its holders.

        An end without a holder is clamped as designed.

        Raises
        ------
        NotConvergedError
            No rest shape was found.
        """
        for seat in (start, end):
            require_record(seat, TabSeat | None, "a holder", "a TabSeat, or None")
        return self._held_as_designed if start is None and end is None else self._held_by(start, end)

    @cached_property
    def _held_as_designed(self) -> HeldShape:
        return self._held_by(None, None)

    def _held_by(self, start: TabSeat | None, end: TabSeat | None) -> HeldShape:
        require_free_between(self.rod, "The strip as made")
        uncorrected = self.as_made if self.correction is None else replace(self, correction=None).as_made
        return self.as_made.held((start, end), uncorrected, self.tolerance)

    @cached_property
    def held_deviation(self) -> float:
        """Deviation of the finished strip from its design, mm, with its ends held as designed: see `held`."""
        return self.held().deviation

    @cached_property
    def sideways(self) -> SidewaysStability:
        """Stability against leaving the plane of the curve. Slots are ignored."""
        known = _sideways.setdefault(self.rod, {})
        if self._section_key not in known:
            known[self._section_key] = strip_sideways(self.rod, self.layout)
        return known[self._section_key]

    def reactions(self) -> Reactions:
        """Return the forces (N) and moments (N mm) that the supports exert on the strip.

        The internal force is -lambda B, where B is the bending stiffness and lambda(s) is from Eq. 2 of the
        paper. The supports therefore push the start with lambda(0) B and the end with -lambda(L) B.
        """
        B, moment = self.bending_stiffness, self.rod.moment
        start, end = B * self.rod.support_forces
        return Reactions(start, float(-B * moment[0]), end, float(B * moment[-1]))

    def drawing(self) -> Drawing:
        """Return the drawing of the strip, or of the base of a laminate, with texts, marks and cuts."""
        return self.drawings()[0]

    def drawings(self) -> tuple[Drawing, ...]:
        """Return the drawing of each sheet, the base layer first.

        All drawings have the same origin and the same holes in the tabs.

        In a laminate, the position of the backing is marked on the base. Base and backing are engraved with INSIDE
        or OUTSIDE, the side of the bend to which the engraved face points.
        """
        return self._drawings

    @cached_property
    def _drawings(self) -> tuple[Drawing, ...]:
        lap = self.ends[1].length if self.is_closed else 0.0
        engraved = f"{self.engraved} {self._backing_mark}".strip()
        base, *others = draw_layers(
            self.layout, self.layers, self.ends, self.slots, engraved, self.label, lap=lap
        )
        marks = end_numbers(self.width, Cuts(self.holes, rim=self.layers[0].rim), base.texts, self.joints)
        return (replace(base, texts=(*base.texts, *marks)), *others)

    @property
    def engraved(self) -> str:
        """Text engraved on the strip. By default it is the label, or a number if it has other letters."""
        return engraved_names([self.label])[self.label] if self.engrave is None else self.engrave

    @property
    def number(self) -> str:
        """Number that is engraved in place of the label, or "" if there is none."""
        text = self.engraved
        numbered = text.replace("-", "").isdecimal() and text != self.label and not self.unmarked
        return text if numbered else ""

    @property
    def backing_side(self) -> str:
        """Sentence that states on which side of the bend the backing of a laminate is; empty for other strips."""
        mark = self._backing_mark
        if not mark or self.unmarked:
            return BACKING_SIDES.get(mark, "")
        engraved = note(
            "On base and backing, the face with the engraving {mark} points to this side.", mark=mark
        )
        return sentences([BACKING_SIDES[mark], engraved], " ")

    @property
    def _backing_mark(self) -> str:
        return "" if self.layout.backing is None else _mark_on_backing(self.rod.curvature)


@dataclass(frozen=True, eq=False)
class Placed:
    """A strip in space.

    Its curve is in the plane of `x_axis` and `y_axis`, and its width is perpendicular to that plane.

    Parameters
    ----------
    strip : Strip
    origin : (3,) array_like
        Origin of the curve's plane, mm.
    x_axis, y_axis : (3,) array_like
        Perpendicular directions in the plane of the curve. The width of the strip is along their cross product.
    color : (red, green, blue), optional
        Screen colour of the base sheet, each component in 0..1; by default the colour of the sheet.
    """

    strip: Strip
    origin: FloatArray
    x_axis: FloatArray
    y_axis: FloatArray
    color: tuple[float, ...] | None

    def __init__(
        self,
        strip: Strip,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        x_axis: ArrayLike = (1.0, 0.0, 0.0),
        y_axis: ArrayLike = (0.0, 1.0, 0.0),
        color: tuple[float, ...] | None = None,
    ) -> None:
        frame = Frame(origin, x_axis, y_axis)
        vars(self).update(strip=strip, color=color)
        vars(self).update(origin=frame.origin, x_axis=frame.x_axis, y_axis=frame.y_axis)

    @property
    def frame(self) -> Frame:
        """Plane of the curve."""
        return Frame(self.origin, self.x_axis, self.y_axis)

    def with_strip(self, strip: Strip) -> "Placed":
        """Return another strip in the same position."""
        return Placed(strip, self.origin, self.x_axis, self.y_axis, self.color)

    def moved(self, turn: ArrayLike, shift: ArrayLike = (0.0, 0.0, 0.0)) -> "Placed":
        """Return the placed strip after the map x -> turn @ x + shift.

        A reflection (determinant -1) turns the flat part over.
        """
        m = numbers(turn, "the turn of a strip")
        if m.shape != (3, 3) or not np.allclose(m @ m.T, np.eye(3), rtol=0, atol=1e-9):
            raise InputError(
                "this map would deform the strip: use only a shift and a 3x3 matrix that rotates or mirrors"
            )
        strip = self.strip if np.linalg.det(m) > 0 else self.strip.mirrored()
        origin = m @ self.origin + three(shift, "the shift of a strip")
        return Placed(strip, origin, m @ self.x_axis, m @ self.y_axis, self.color)


def require_placed(placed: object) -> tuple[Placed, ...]:
    """Return placed strips as a tuple, with different engraved texts for different labels.

    Raise InputError for other values.
    """
    members = several(
        "placed", placed, Placed, "Placed", "of a strip ec.Placed(strip), of a body in CAD its `placed`"
    )
    marks, numbered = engraved_labels(members), dict[int, Strip]()
    for strip in {id(member.strip): member.strip for member in members}.values():
        if strip.engrave is None and strip.label != marks[strip.label]:
            numbered[id(strip)] = replace(strip, engrave=marks[strip.label])
    return tuple(
        member.with_strip(numbered[id(member.strip)]) if id(member.strip) in numbered else member
        for member in members
    )


def engraved_labels(placed: Sequence[Placed], others: Iterable[tuple[str, str]] = ()) -> dict[str, str]:
    """Return, by label, the text that is engraved on other parts for a strip: the label, or a number.

    `others` are the names of other parts, which have different texts. Each name is followed by the text that is
    engraved for the part already, or by "".
    """
    named = [*((member.strip.label, member.strip.engrave) for member in placed), *others]
    return engraved_names((name for name, _ in named), {name: text for name, text in named if text})


def strip_names(placed: Sequence[Placed]) -> tuple[str, ...]:
    """Return the name of each strip for messages: its label, or its index, counted from 1."""
    return tuple(item.strip.label or f"strip {i}" for i, item in enumerate(placed, start=1))


def strip_marks(placed: Sequence[Placed]) -> tuple[str, ...]:
    """Return the name of each strip that is engraved on other parts: see `engraved_labels` and `strip_names`."""
    marks = engraved_labels(placed)
    named = zip(placed, strip_names(placed), strict=True)
    return tuple(marks[item.strip.label] or name for item, name in named)


def distinct_names(placed: Sequence[Placed]) -> tuple[str, ...]:
    """Return the names of `strip_names`; equal names are followed by the number of their strip."""
    names = strip_names(placed)
    count = Counter(names)
    return tuple(f"{name} (strip {i})" if count[name] > 1 else name for i, name in enumerate(names, start=1))
