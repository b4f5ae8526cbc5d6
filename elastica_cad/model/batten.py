"""Battens of tapered stock, with tables and drawings for the workshop, and workshop documents of glued plies."""

from dataclasses import dataclass, replace
from textwrap import wrap
from typing import Literal

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import numbers, require_record
from elastica_cad.errors import FaultError, FieldName, InputError, Length, NotConvergedError, note
from elastica_cad.form_finding.leaf_ends import LeafedRod, lay_leaves
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Line, Path
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import norm, unit
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.cross_sections import LeavesLaw, RoundLaw, ThicknessLaw
from elastica_cad.mechanics.loads import Gravity, Supports, Weight
from elastica_cad.mechanics.rod import Rod, camber_of, csv_text
from elastica_cad.model.cut_rows import CutList, cut_list
from elastica_cad.report_rows import DECIMALS
from elastica_cad.strip.drawing import CUT_OUTER, MARK, Drawing, LayeredPath
from elastica_cad.strip.holding_template import ends_message
from elastica_cad.strip.lettering import Text, engravable
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import DOWN, StripSpec
from elastica_cad.strip.tapered_solids import side_view


@dataclass(frozen=True, eq=False)
class LeafStack:
    """Workshop documents of a strip of glued plies.

    Attributes
    ----------
    strip : Strip
        Strip with a `LeavesLaw`.
    """

    strip: Strip

    def __post_init__(self) -> None:
        require_record(self.strip, Strip, "what is of leaves", "a Strip")
        if self.strip.layout.stack is None:
            raise InputError("the strip has no plies: make it with section=LeavesLaw(sheet, leaves, width)")

    @property
    def cut_list(self) -> CutList:
        """Cut list with one row for each ply, the full-length ply first."""
        stack, label = self.strip.layout.stack, self.strip.label or "stack"
        assert stack is not None
        layers = zip(self.strip.drawings(), self.strip.layers, stack.names, strict=True)
        leaves = [Piece(f"{label} {name}", drawing, layer.sheet) for drawing, layer, name in layers]
        return cut_list(leaves, dict.fromkeys((leaf.name for leaf in leaves), ""))

    @property
    def drawing(self) -> Drawing:
        """Pattern of the plies at full size, one below another, at their positions along the stack.

        Marks across each ply show the ends of the next plies.
        """
        # the plies are at least 5 mm apart
        pitch = float(np.ptp(self.strip.outline.bounds[:, 1])) + 5.0
        moved = [
            path.transformed(np.array([[1, 0, 0], [0, 1, -i * pitch], [0, 0, 1]]))
            for i, path in enumerate(self.strip.drawings())
        ]
        return Drawing.merged(self.strip.label or "stack", moved)


LETTER_MM, TICK_MM = 4.0, 3.0


def _bench_table(strip: Strip, stations: ArrayLike | None) -> dict[str, FloatArray]:
    """Return the columns (n,) of the workshop table of a tapered strip, by name.

    The columns are the station (measured from the start of the free part), its distance from the tip of the
    tab, the size, the strain and the safety. The default stations include the tips of both tabs. The safety is
    the strain limit of the material divided by the strain, and infinite where the strip is not bent.
    """
    if strip.layout.size is None:
        raise InputError(
            "this strip has a constant thickness, so it has no side view: use a strip with a section "
            "such as ThicknessLaw"
        )
    first, last = (tab.length for tab in strip.ends)
    tips = -first, strip.rod.length + last
    evenly = np.unique([*tips, *np.linspace(0.0, strip.rod.length, 21)])
    s = np.clip(evenly if stations is None else numbers(stations, "stations"), *tips)
    bent = s.clip(0.0, strip.rod.length)
    section, sizes = strip.layout.section_at(bent)
    (layer,) = section.strains(np.abs(strip.rod.bend_at(bent)), sizes)
    # tabs are not bent
    strain = np.where((layer.strain < 1e-12) | (s != bent), 0.0, layer.strain)
    safety = np.divide(layer.limit, strain, out=np.full(s.size, np.inf), where=strain > 0)
    return {
        "s_mm": s, "s_inch": s / MM_PER_INCH,
        "from_tip_mm": s + first, "from_tip_inch": (s + first) / MM_PER_INCH, f"{section.quantity}_mm": sizes,
        f"{section.quantity}_inch": sizes / MM_PER_INCH, "strain": strain, "safety": safety,
    }  # fmt: skip


def bench_csv(strip: Strip, stations: ArrayLike | None = None) -> str:
    """Return the table of a tapered strip, or the cut list of a strip of glued plies, as comma-separated text.

    The strain is in percent. The safety is empty where the strip is not bent.
    """
    if strip.layout.stack:
        return LeafStack(strip).cut_list.csv
    *sizes, (_, strain), safety = _bench_table(strip, stations).items()
    columns = dict([*sizes, ("strain_percent", 100 * strain), safety])
    rounded = {name: column.round(DECIMALS[name.rsplit("_", 1)[-1]]) for name, column in columns.items()}
    return csv_text(rounded).replace(",inf", ",")


def bench_drawing(strip: Strip, stations: ArrayLike | None = None) -> Drawing:
    """Return the side view of a tapered strip at full size, or the pattern of a strip of glued plies.

    A tick at each station is labelled with its distance from the tip of the tab, and the size of the batten,
    both in mm. The lines below the view state the stock and the supports of the ends.
    """
    if strip.layout.stack:
        return LeafStack(strip).drawing
    s, _, far, _, sizes, *_ = _bench_table(strip, stations).values()
    view = side_view(strip)
    (left, low), (_, top) = view.bounds.tolist()
    ticks = [LayeredPath(MARK, Path((Line((x, top + 1.0), (x, top + 1.0 + TICK_MM)),))) for x in s.tolist()]
    texts = tuple(
        Text((x, top + 2.0 + TICK_MM), f"{tip:.1f}: {size:.2f}", LETTER_MM, np.pi / 2)
        for x, tip, size in zip(s.tolist(), far.tolist(), sizes.tolist(), strict=True)
    )
    text_lines = tuple(
        Text((left, low - 1.8 * LETTER_MM * row), line, LETTER_MM, 0.0, MARK)
        for row, line in enumerate(_label_lines(strip), start=1)
    )
    return Drawing(strip.label, (*ticks, LayeredPath(CUT_OUTER, view)), (*texts, *text_lines))


def _label_lines(strip: Strip) -> list[str]:
    """Return the lines of text on the drawing of a batten: name, stock and work, ends, and meaning of ticks."""
    sheet, flat = strip.sheet, "thickness" in strip.tapered
    # remove the thickness of the sheet from its name, because the stock has another thickness
    stock = sheet.full_name.removesuffix(f" {sheet.thickness:g} mm")
    wide = f"{stock}, {strip.width.extremes[1]:g} mm wide: plane both faces alike"
    sizes = {f"{size:.2f}" for profile in strip.tapered.values() for size in profile.extremes}
    work = ": turn it to the diameters" if len(sizes) > 1 else f", {float(sizes.pop()):g} mm in diameter"
    instruction = wide if flat else f"{stock}, round{work}"
    ticks = "full size, seen from the side; at a tick: mm from this tip, and the size there"
    blocks = strip.engraved or "batten", instruction, str(ends_message(strip)), ticks
    # that many letters fit on A4 paper
    return [engravable(line) for block in blocks for line in wrap(block, 46)]


ENDS = Supports("pinned", "pinned")
LARGEST_CAMBER = 0.4  # largest camber, as a fraction of the chord, because a deeper batten is a bow
SEARCH_NODES = 401  # number of nodes in the search for the taper; the final curve has more
# largest fraction of the length with full size, because the remaining length is needed for the taper
LARGEST_FULL_FRACTION = 0.8
CAMBER_TOLERANCE = 1e-7  # accuracy of the camber and of its position, as a fraction of the chord
MOST_STEPS = 30


@dataclass(frozen=True)
class BattenSpec:
    """Request for a batten.

    Parameters
    ----------
    length : float
        Length of the batten, mm.
    camber : float
        Largest depth of the bow between the pressed ends, as a fraction of the chord (0.1 is 10 %).
    place : float
        Position of the largest depth along the chord, as a fraction of the chord from the start.
    stock : ThicknessLaw or RoundLaw
        Section of a strip planed in thickness, or of a rod. Its largest size is the size of the stock.
        Its least size is the limit of planing or turning.
    label : str
    full : float
        Fraction of the length, at the thick end, that has the full size. The remaining length is tapered.
    lying : "up" or "down", optional
        Side to which a batten with a level chord bulges. Camber and its position then include the effect of
        the weight. By default the weight is ignored, as for an upright batten in a sail.

    Examples
    --------
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> glass = Sheet("glass", 8.0, 38000.0, density=1900.0, max_strain=0.012)
    >>> batten = BattenSpec(2400.0, 0.1, 0.4, ThicknessLaw(glass, 3.0, 8.0, width=25.0)).make()
    >>> sizes = batten.table([0.0, 1200.0, 2400.0])["thickness_mm"]
    >>> sizes.round(1).tolist(), round(batten.end_force)
    ([3.3, 5.7, 8.0], 20)
    """

    length: float
    camber: float
    place: float
    stock: ThicknessLaw | RoundLaw
    label: str = "batten"
    full: float = 0.0
    lying: Literal["up", "down"] | None = None

    def __post_init__(self) -> None:
        if not (np.isfinite(self.length) and self.length > 0):
            raise InputError(f"the batten's length is {self.length:g}: give a number above 0, in mm")
        if not 0 < self.camber <= LARGEST_CAMBER:
            raise InputError(
                f"the camber (height of the bulge) is {100 * self.camber:g} % of the chord: give 1 to "
                f"{100 * LARGEST_CAMBER:g} %"
            )
        if not 0 < self.place < 1:
            raise InputError(f"the largest camber is at {100 * self.place:g} % of the chord: give 1 to 99 %")
        if not 0 <= self.full <= LARGEST_FULL_FRACTION:
            raise InputError(
                "The batten cannot have its full size over {percent:g} % of its length. Set {field} to 0 to "
                "{most:g} %.",
                percent=100 * self.full,
                field=FieldName("full"),
                most=100 * LARGEST_FULL_FRACTION,
            )
        require_record(
            self.stock, ThicknessLaw | RoundLaw, "the stock of the batten", "a ThicknessLaw or a RoundLaw"
        )
        if self.lying not in (None, "up", "down"):
            raise InputError(f'lying is {self.lying!r}: give "up" or "down", the side of the bulge, or None')

    def make(self) -> "Batten":
        """Return the batten with the linear taper at which its bulge is deepest at the requested position.

        Raises
        ------
        NotConvergedError
            No taper puts the deepest point at the requested position.
        """
        try:
            taper, chord = self._taper()
        except NotConvergedError:
            if self.lying is not None:  # the error may already name the weight as the cause
                raise
            raise self._place_out_of_reach(0.5 - self.place, self._untapered_chord, "") from None
        thin = self.stock.largest * np.exp(-abs(taper))
        if thin < self.stock.least * (1 - 1e-9):
            raise self._place_out_of_reach(taper, chord, note(" (it needs {thin})", thin=Length(thin)))
        # move the third control point from each end, so that both end curvatures are 0
        curve = _rod_between_hinges(self, taper, chord, 2401).curve
        points = np.array(curve.control_points)
        for first, second, third in ((0, 1, 2), (-1, -2, -3)):
            along = unit(points[second] - points[first])
            points[third] = points[first] + ((points[third] - points[first]) @ along) * along
        return Batten(self, PlaneCurve(curve.knots, points, curve.degree))

    def _place_out_of_reach(self, side: float, chord: float, thin: str) -> InputError:
        # `side` has the sign of the required taper; `most` is the taper at the limit
        most = float(np.log(self.stock.largest / self.stock.least)) * np.sign(side)
        within = 100 * self._place_for_taper(most, chord)
        # round towards the middle of the chord, so that the suggested position is possible
        nearest = (
            note("at least {percent:.3g} %", percent=np.ceil(10 * within) / 10)
            if side > 0
            else note("at most {percent:.3g} %", percent=np.floor(10 * within) / 10)
        )
        return FaultError(
            "with the largest camber at {place:.4g} % of the chord, the thin end would be thinner than the "
            "limit of {least:g}{thin}. Move the largest camber to {nearest} of the chord, or reduce this "
            "limit",
            place=100 * self.place,
            thin=thin,
            least=Length(self.stock.least),
            nearest=nearest,
        )

    @property
    def _untapered_chord(self) -> float:
        """Ratio of chord to length if the untapered batten bends to half a sine wave."""
        # 2.4 is about (pi / 2)^2
        return 1 - 2.4 * self.camber**2

    def _place_for_taper(self, taper: float, chord: float) -> float:
        """Return the position of the largest depth, after adjusting the chord to the requested depth.

        Each adjustment assumes a depth proportional to the square root of length minus chord.
        """
        for _ in range(MOST_STEPS):
            depth, place = camber_of(_rod_between_hinges(self, taper, chord, SEARCH_NODES))
            if abs(depth - self.camber) < 10 * CAMBER_TOLERANCE:
                break
            chord = max(1 - (1 - chord) * (self.camber / depth) ** 2, 0.3)
        return place

    def _taper(self) -> tuple[float, float]:
        """Return the taper and the chord, as a fraction of the length, that give the camber at its place."""
        from scipy.optimize import least_squares

        def missed(x: FloatArray) -> FloatArray:
            bow = camber_of(_rod_between_hinges(self, float(x[0]), float(x[1]), SEARCH_NODES))
            return np.array(bow) - (self.camber, self.place)

        # the position of the largest depth depends almost linearly on the taper
        first = [6.0 * (0.5 - self.place), self._untapered_chord]
        solution = least_squares(
            missed, first, bounds=([-4.0, 0.3], [4.0, 1.0 - 1e-6]), x_scale=[1.0, 0.1], ftol=None, gtol=None,
            xtol=1e-10, max_nfev=MOST_STEPS,
        )  # fmt: skip
        if np.abs(solution.fun).max() < CAMBER_TOLERANCE:
            return float(solution.x[0]), float(solution.x[1])
        raise NotConvergedError(
            f"no taper was found with a camber of {100 * self.camber:g} % at {100 * self.place:g} % of the "
            "chord: move the camber closer to the middle"
        )


@dataclass(frozen=True, eq=False)
class Batten:
    """Finished batten; see `BattenSpec`.

    Attributes
    ----------
    spec : BattenSpec
    curve : PlaneCurve
        Shape between the pressed ends, with the chord along x.
    """

    spec: BattenSpec
    curve: PlaneCurve

    @property
    def strip_spec(self) -> StripSpec:
        """Request for the batten's strip: its curve, hinged ends, and the section of the stock."""
        stock = self.spec.stock
        return StripSpec(
            self.curve, stock.sheet, section=stock, supports=ENDS, ends=(Tab(0.0), Tab(0.0)), label=self.spec.label,
            smooth=0.0, frame=Frame(),  # by default the batten is on its side, so its weight does not bend it
            gravity=DOWN if self.spec.lying is None else _gravity_across(self.spec.lying),
        )  # fmt: skip

    @cached_property
    def strip(self) -> Strip:
        """Strip that is made from the request `strip_spec`."""
        return self.strip_spec.make()

    @property
    def camber(self) -> tuple[float, float]:
        """Largest depth and its position, as fractions of the chord."""
        return camber_of(self.strip.rod)

    def camber_with_weight(self, *, bulging: Literal["up", "down"]) -> tuple[float, float]:
        """Return the largest depth and its position, as fractions of the chord, under the batten's weight.

        The chord is level and as long as without weight.
        """
        rod, size = self.strip.rod, self.strip.layout.size
        assert size is not None
        side = float(np.sign(rod.position[rod.s.size // 2, 1] - rod.position[0, 1]))
        down = _gravity_across(bulging, side)
        newtons = Profile.interpolate(rod.s, self.spec.stock.weight_per_length(size(rod.s)))
        return camber_of(bend(replace(rod, gravity=down, weight=Weight(alpha=newtons))))

    @property
    def chord(self) -> float:
        """Distance between the pressed ends, mm."""
        return float(norm(self.strip.rod.chord))

    @property
    def end_force(self) -> float:
        """Force that presses the ends together, N."""
        return float(self.strip.reactions().sizes[0][0])

    def of_leaves(self, leaves: int) -> LeafedRod:
        """Return the stack of glued plies that is closest to the batten. Plies differ only in length.

        Raises
        ------
        NotConvergedError
            No stack has an equilibrium between the pressed ends.
        """
        stock = self.spec.stock
        if not isinstance(stock, ThicknessLaw):
            raise InputError("a round batten cannot be made of plies: give a ThicknessLaw as stock")
        leaf = stock.sheet.with_thickness(stock.largest / max(leaves, 1))
        return lay_leaves(self.strip.rod, LeavesLaw(leaf, leaves, stock.width))

    def strip_of(self, leafed: LeafedRod) -> Strip:
        """Return the strip that is glued from the plies of `leafed`."""
        return Strip(leafed.rod, leafed.section.sheet, ends=(Tab(0.0), Tab(0.0)), label=self.spec.label)

    def table(self, stations: FloatArray | list[float]) -> dict[str, FloatArray]:
        """Return columns (n,) with the size, strain and safety at `stations` (n,), mm, by name."""
        return _bench_table(self.strip, stations)


def _rod_between_hinges(spec: BattenSpec, taper: float, chord: float, nodes: int) -> Rod:
    """Return the bent rod whose size at the end is exp(taper) times the size at the start.

    `chord` is the distance between the hinges as a fraction of the length.
    """
    along = np.linspace(0.0, 1.0, nodes)
    tapered = 1 - spec.full
    # the part of full size is at the thick end: at the end if the taper is positive, else at the start
    share = along / tapered if taper > 0 else (along - spec.full) / tapered
    sizes = 1 + np.expm1(taper) * np.clip(share, 0.0, 1.0)
    sizes *= spec.stock.largest / sizes.max()
    EI = spec.stock.bending_stiffness(sizes)
    flat = Rod.straight(spec.length, EI, samples=nodes, supports=ENDS, bending_stiffness=float(EI.min()))
    light = bend(flat, end=(chord * spec.length, 0.0))
    if spec.lying is None:
        return light
    newtons = Profile.interpolate(light.s, spec.stock.weight_per_length(sizes))
    heavy = bend(replace(light, gravity=_gravity_across(spec.lying), weight=Weight(alpha=newtons)))
    if heavy.position[nodes // 2, 1] <= 0:
        raise NotConvergedError(
            f"lying level with its bulge {spec.lying}, the batten snaps over under its own weight: use "
            "stiffer or lighter stock, or more camber"
        )
    return heavy


def _gravity_across(bulging: Literal["up", "down"], side: float = 1.0) -> Gravity:
    """Return gravity perpendicular to the chord of a batten that bulges to the left (`side` 1) or right (-1)."""
    return Gravity(1.0, (0.0, -side if bulging == "up" else side))
