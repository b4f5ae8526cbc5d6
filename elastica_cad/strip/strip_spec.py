"""The request for one strip, its checks, and the strip made from it."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from dataclasses import fields as fields_of
from functools import cached_property
from typing import Annotated, Any, TypeAlias, cast

import numpy as np

from elastica_cad._values import EqualByValue, is_number, require_record, several
from elastica_cad.declared import Asked, require_declared
from elastica_cad.errors import Change, InputError, refuse_unknown, rounded_up
from elastica_cad.forming.fairing_request import Smoothing
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest_record import NearestRod
from elastica_cad.forming.rod_spec import LaminateLayers, RodSpec, accepted_rod
from elastica_cad.forming.straight_ends import StraightEnds
from elastica_cad.geometry.fairing import may_step
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.creep_study import require_creep
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.loads import (
    Gravity,
    NaturalCurvature,
    PointMass,
    RestCurvature,
    Supports,
    Weight,
    require_curve,
    require_natural_curvature,
    require_supports,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import WidthLaw, WidthRange
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.stiffness_law import BoundedLaw
from elastica_cad.mechanics.theorem1 import NotRealizable, begin_at, flattest_place, measured_points
from elastica_cad.refusals import FieldName, Length, Refusal, note
from elastica_cad.strip.held_shape import USUAL_TOLERANCE, MakingTolerance
from elastica_cad.strip.lamination import Laminated
from elastica_cad.strip.makeable_strip import make_within
from elastica_cad.strip.outline import Hole, Tab, pair_of_tabs
from elastica_cad.strip.slots import Slot
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.styles import NO_WIDTH, PLAIN, Plain, Style, require_style, width_profile
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits

AskedGravity: TypeAlias = Gravity | bool | Sequence[float] | None
"""A `Gravity`, True for the sheet's own weight along -y, or the direction in which that falls."""

Loads: TypeAlias = "tuple[PointMass, ...] | Weight"
"""Masses hung on a strip beside its own weight; or all weight in newtons."""


def pull_in_plane(given: AskedGravity, sheet: Sheet, frame: Frame | None) -> tuple[Gravity | None, float]:
    """Gravity as a strip feels it in the plane of its curve, and the share of a weight that acts there.

    Raises
    ------
    InputError
        No direction, or one in space where no `frame` says how the plane lies.
    """
    if given is None or isinstance(given, bool):
        return (sheet.gravity() if given else None), 1.0
    if isinstance(given, Gravity):
        return given, 1.0
    direction = _direction(given)
    if len(direction) == 2:
        return sheet.gravity(direction), 1.0
    if frame is None:
        raise InputError(
            f"gravity {direction} is a direction in space: give frame, the plane of the curve, or two "
            "numbers, the direction in the drawing",
            where={"field": "gravity"},
        )
    own = sheet.elasto_gravity_length
    felt = Gravity.in_plane(own, direction, frame.x_axis, frame.y_axis)
    return felt, 1.0 if felt is None else (own / felt.length) ** 3


def _lightened(loads: Loads, share: float) -> Loads:
    """Masses of which only a share acts; a weight in newtons is what acts."""
    if isinstance(loads, Weight):
        return loads
    return tuple(replace(one, mass=share * one.mass) for one in loads)


def _hung_weight(loads: Loads, share: float) -> Weight | None:
    """Loads as `optimal_rod` takes them; in a plane that leans, masses hang with a share of their weight."""
    felt = _lightened(loads, share)
    if isinstance(felt, Weight):
        return felt
    return Weight(masses=felt, own=True) if felt else None


def _direction(given: object) -> tuple[float, ...]:
    """Two or three numbers that say where things fall."""
    row = tuple(given) if isinstance(given, Sequence | np.ndarray) and not isinstance(given, str) else ()
    if len(row) not in (2, 3) or not all(is_number(one) for one in row) or not any(row):
        raise InputError(
            f"gravity is {given!r}: give True, a Gravity record, or the direction in which things "
            "fall as two numbers in the drawing or three in space, not all zero, such as (0, -1) or "
            "(0, 0, -1)",
            where={"field": "gravity"},
        )
    return tuple(float(one) for one in row)


NEAREST_CALL = (
    "limits=ec.Limits() asks for the nearest curve that a strip can take, which strip.rod.curve then is."
)
"""What a program that asked for a strip can do."""


def _check_seam(seam_position: float | None, curve: PlaneCurve) -> None:
    """Refuse a place to begin that is not on the curve, or on one that is open."""
    if seam_position is not None and seam_position > curve.length:
        raise InputError(
            "{field} is {seam:g}: give a place along the curve, 0 to {length:.4g}, or none",
            field=FieldName("seam_position"),
            seam=seam_position,
            length=Length(curve.length),
            where={"field": "seam_position"},
        )
    if seam_position is not None and not curve.is_closed:
        raise InputError(
            "{field} is {seam:g}, but the curve is open and begins at its own end: leave it "
            "out, or close the curve",
            field=FieldName("seam_position"),
            seam=Length(seam_position),
            where={"field": "seam_position"},
        )


def _check_law(
    law: BoundedLaw, sheet: Sheet, style: Style, ends: Sequence[Tab], slots: Sequence[Slot], *, sized: bool
) -> None:
    """Refuse a law beside another style, widths (`sized`) or a shape of its own, or one of another sheet."""
    shaped = bool(slots) or any(tab != Tab(tab.length) for tab in ends)
    shaped = shaped and getattr(law, "quantity", "") != "width"
    if not isinstance(style, Plain) or sized or shaped:
        raise InputError(
            "a law says what the section is and how large: leave out {style}, {slots}, {max_width} and "
            "{min_width}, and give tabs a length only, or leave out {law}",
            style=FieldName("style"),
            slots=FieldName("slots"),
            max_width=FieldName("max_width"),
            min_width=FieldName("min_width"),
            law=FieldName("law"),
            where={"field": "law"},
        )
    other = getattr(law, "sheet", sheet)
    if other != sheet:
        raise InputError(
            "the law is of {name}, the strip of {name_2}: give both the same sheet",
            name=other.name,
            name_2=sheet.name,
            where={"field": "law"},
        )


def _limits_beside(
    limits: Limits, sheet: Sheet, style: Style, *, max_width: float | None, min_width: float | None
) -> Limits:
    """Limits of a strip without a law, agreed with its own sheet and widths.

    What is asked of a plain strip's width stands in two places: the narrower range is kept.

    Raises
    ------
    InputError
        Widths outside those of the limits, or strains of a sheet of another thickness.
    """
    if (
        limits.sheet is not None
        and not isinstance(style, Laminated)
        and limits.sheet.thickness != sheet.thickness
    ):
        raise InputError(
            "the limits are of {name}, {thickness:g} thick, the strip of {name_2}, "
            "{thickness_2:g}: leave sheet out of the limits, which are then of the strip's",
            name=limits.sheet.name,
            thickness=Length(limits.sheet.thickness),
            name_2=sheet.name,
            thickness_2=Length(sheet.thickness),
        )
    if limits.width is None or not isinstance(style, Plain):
        return limits
    low, high = limits.width
    for name, width in (("max_width", max_width), ("min_width", min_width)):
        if width is not None and not low <= width <= high:
            raise InputError(
                "{name} is {width:g}, outside the limit width of {low:g} to {high:g}: change one of "
                "them, or leave the limit out",
                name=FieldName(name),
                width=Length(width),
                low=low,
                high=Length(high),
                where={"field": (name, "limits.width")},
            )
    narrowest, widest = min_width or low, max_width or high
    if narrowest > widest:  # refused where the widths are compared
        return limits
    return replace(limits, width=(narrowest, widest))


def _ratio_of_widths(max_width: float, min_width: float, sheet: Sheet, shop: FabricationLimits) -> float:
    """The largest ratio of a plain strip's widths, mm, that the workshop can cut of a sheet.

    Raises
    ------
    InputError
        A `min_width` above `max_width`, or a strip that is too narrow for its sheet everywhere.
    """
    least = shop.width_for(sheet)
    if min_width > max_width:
        raise InputError(
            "{field} is {min_width:g}, more than {wider}, {max_width:g}: give the larger one as {wider}",
            field=FieldName("min_width"),
            wider=FieldName("max_width"),
            min_width=Length(min_width),
            max_width=Length(max_width),
            where={"field": "max_width"},
        )
    if least >= max_width:
        raise InputError(
            "{field} is {max_width:g}, but {name} needs {least} at its narrowest: widen the "
            "strip, take another sheet, or allow less with {least_width}",
            field=FieldName("max_width"),
            least_width=FieldName("shop.least_width"),
            max_width=Length(max_width),
            name=sheet.name,
            least=Length(least),
            where={"field": "max_width"},
            changes=[Change("max_width", rounded_up(2 * least, 3))],
        )
    return max_width / max(min_width, least)


@contextmanager
def told_in_python(curve: PlaneCurve, may_change: bool) -> Iterator[None]:
    """A refusal of the curve ends with the argument that lets it change, where a program asked for the strip.

    It is a note below the message, not tried: a search may take longer than a program has for a curve that it
    only asks about.
    """
    try:
        yield
    except (NotRealizable, InputError) as problem:
        refused = isinstance(problem, NotRealizable) or curve.has_corners
        if refused and not may_change:
            problem.add_note(NEAREST_CALL)
        raise


SAME_LENGTH = 1e-9
"""Relative difference below which two gravity lengths are of the same sheet: they were computed alike."""


@dataclass(frozen=True, eq=False)
class StripSpec(EqualByValue):
    """All that is asked of one strip; equal requests give equal strips.

    Parameters
    ----------
    curve : PlaneCurve
        What the strip bends into.
    sheet : Sheet or str
        The material, or the name of a built-in one.
    frame : Frame, optional
        The plane of the curve in space, for directions that are given there.
    max_width, min_width : float, optional
        Width of the widest, of the narrowest place, mm: see `Strip`.
    style : Plain, Perforated or Laminated
        How stiffness becomes material.
    limits, keep : Limits, Keep, optional
        With one of them the curve may be changed, by `nearest_rod`; without them it is followed exactly.
    gravity : Gravity, bool or sequence of float, optional
        True for the sheet's own weight, falling along -y of the drawing; two numbers for the direction in which it
        falls there; three for a direction in space, of which the part in the plane of `frame` is felt. A `Gravity`
        is taken as it is. A laminate carries the weight of both its layers.
    loads : sequence of PointMass, or Weight
        Masses hung on the strip, besides its own weight; or all weight in newtons. They need gravity.
    supports : Supports
        What holds the ends; clamped unless given.
    natural_curvature : float or RestCurvature
        Of the strip before bending, 1/mm; along its length where the blank was bent beforehand.
    samples : int, optional
        Nodes of the rod; chosen unless given.
    ends : pair of Tab
        Of a closed strip the second is the lap that is glued behind its start, the first is left out.
    seam_position : float, optional
        Where a closed strip begins and ends, mm along the curve as drawn; where it is bent least unless given, or
        as drawn with limits or keep. All places along the strip are counted from there. None for an open curve.
    straight_ends : bool
        Straight first and last pieces of the curve, where its end is held in its direction, become the tabs (at
        least as long as drawn, with the circles drawn on them as holes), and only what lies between them is bent.
        All places along the strip are counted from there. False: the whole curve is bent.
    slots : sequence of Slot
    label : str
        Its name in messages, files and assemblies; empty for none.
    engrave : str, optional
        Text engraved on the strip; empty for none. Unless given its label, in letters that can be engraved.
    smooth : float, optional
        Largest distance, mm, by which the curve may be moved to make its curvature and the slope of that
        continuous; 0: exactly as drawn. By default a curve is moved by at most 0.1 mm and 5e-4 of its length, and
        only if the outline would step: see `smooth_curve`.
    shop : FabricationLimits
        What the workshop can make: least widths and the largest sheet.
    compensate : bool, optional
        True: change the widths so that the strip as made (slots, narrow tabs, leaning ligaments, anticlastic
        bending, its own weight) takes the curve, instead of the designed rod: see `compensate_widths`. False:
        widths are proportional to the stiffness. Unless given, a plain strip of a sheet whose Poisson's ratio is
        known (`Sheet.poisson_known`) makes up for anticlastic bending alone, under its weight too, but not under
        loads: see `WidthLaw`.
    creep : float
        Creep factor phi of the sheet in the long run, 0 for none: sag, forces and springback are told, see
        `Strip.crept`.
    law : BoundedLaw, optional
        What stiffness is made of instead of width: `ThicknessLaw` or `RoundLaw` of the sheet's material;
        `LeavesLaw` for glued leaves of the sheet, with limits or keep, as a stack only comes near a curve; or
        `WidthLaw`, for a plain strip that bends as a beam where it is narrow and as a plate where it is wide,
        station by station, and so carries its weight. Its limits stand for `max_width` and `min_width`.
    ignore_limits : bool
        Make a strip that the workshop cannot, and say so in its warnings.
    tolerance : MakingTolerance
        What is assumed to be off in sheet, cut and clamps; what that adds to how far the strip strays is told.

    Raises
    ------
    InputError
        Values of another kind, not positive or not finite, or requests that exclude each other.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> spec = StripSpec(arch, "birch-plywood-0.8", max_width=30)
    >>> round(spec.make().width.extremes[1], 6)
    30.0
    >>> spec.changed(label="A").rod_spec == spec.rod_spec  # the same rod serves both
    True
    """

    curve: Annotated[PlaneCurve, Asked("The curve that the strip takes.", group="curve")]
    sheet: Annotated[
        Sheet | str,
        Asked(
            "Material: the name of a sheet, or a file of yours, my.toml or my.toml:NAME.",
            group="sheet",
            common=True,
            written=Sheet,
        ),
    ]
    frame: Frame | None = None
    max_width: Annotated[
        float | None, Asked("Width of the widest place.", "mm", above=0, group="widths", common=True)
    ] = None
    min_width: Annotated[
        float | None,
        Asked("Width of the narrowest place, or its limit.", "mm", above=0, group="widths", common=True),
    ] = None
    style: Annotated[Style, Asked("How stiffness becomes material.", group="widths", common=True)] = PLAIN
    limits: Annotated[
        Limits | None,
        Asked("The curve may change, as little as these limits ask for.", group="limits", common=True),
    ] = None
    keep: Annotated[
        Keep | None, Asked("What a curve that may change keeps.", group="limits", common=True)
    ] = None
    gravity: Annotated[
        AskedGravity,
        Asked(
            "The strip carries its own weight: true, the direction in which it falls, or a length of its own.",
            group="weight",
            common=True,
            written=bool | tuple[float, float, float] | tuple[float, float] | Gravity,
        ),
    ] = None
    loads: Annotated[
        tuple[PointMass, ...] | Weight,
        Asked(
            "Masses hung on the strip, or all weight in newtons.",
            group="weight",
            written=tuple[PointMass, ...] | Weight,
        ),
    ] = ()
    supports: Annotated[
        Supports, Asked("What holds the start and the end of the curve.", group="ends", common=True)
    ] = field(default_factory=Supports)
    natural_curvature: Annotated[
        NaturalCurvature,
        Asked(
            "Curvature of the strip before it is bent, or a blank that is bent beforehand.",
            "1/mm",
            group="curve",
            common=True,
        ),
    ] = 0.0
    samples: Annotated[
        int | None, Asked("Nodes of the rod; chosen unless given.", least=3, most=10000, group="curve")
    ] = None
    ends: Annotated[
        tuple[Tab, Tab],
        Asked(
            "Tab of both ends, or the two of start and end.",
            group="ends",
            common=True,
            written=Tab | tuple[Tab, Tab],
        ),
    ] = (Tab(), Tab())
    seam_position: Annotated[
        float | None,
        Asked(
            "Where a closed strip is joined, along its curve; where it is bent least unless given.",
            "mm",
            least=0,
            group="ends",
        ),
    ] = None
    straight_ends: Annotated[
        bool,
        Asked(
            "Straight first and last pieces of the curve become the tabs; false: the whole curve is bent.",
            group="ends",
        ),
    ] = True
    slots: Annotated[tuple[Slot, ...], Asked("Slots from the edge.", many=1000, group="ends")] = ()
    label: Annotated[
        str, Asked("Name of the strip, which is engraved on it.", most=200, group="ends", common=True)
    ] = ""
    engrave: Annotated[
        str | None, Asked("Text engraved in place of the label; empty for none.", most=200, group="ends")
    ] = None
    smooth: Annotated[
        float | None,
        Asked(
            "How far the curve may be moved to become fair; 0 follows it exactly as drawn.",
            "mm",
            least=0,
            group="curve",
            common=True,
        ),
    ] = None
    shop: Annotated[FabricationLimits, Asked("What the workshop can make.", group="limits")] = DEFAULT_LIMITS
    compensate: Annotated[
        bool | None,
        Asked(
            "Make up in the widths for slots, narrow tabs and bending; unless given for anticlastic bending alone.",
            group="widths",
            common=True,
        ),
    ] = None
    creep: Annotated[
        float,
        Asked("Creep factor of the sheet in the long run; 0 leaves creep out.", least=0, group="weight"),
    ] = 0.0
    law: Annotated[
        BoundedLaw | None,
        Asked(
            "What stiffness is made of in place of width: thickness, a rod, a tube, or glued leaves.",
            group="widths",
        ),
    ] = None
    ignore_limits: Annotated[
        bool, Asked("Make a strip that cannot be cut or handled, and say so.", group="limits", common=True)
    ] = False
    tolerance: Annotated[
        MakingTolerance, Asked("What is off in sheet, cut and clamps; what that adds is told.", group="sheet")
    ] = USUAL_TOLERANCE

    def __post_init__(self) -> None:
        require_curve(self.curve)
        given = Sheet.of(self.sheet)
        object.__setattr__(self, "supports", require_supports(self.supports))
        require_natural_curvature(self.natural_curvature)
        require_declared(StripSpec, vars(self))
        if self.frame is not None:
            require_record(self.frame, Frame, "the frame", "a Frame, the plane of the curve, or None")
        require_style(self.style)
        ends, slots = pair_of_tabs(self.ends), several("slots", self.slots, Slot, "Slot")
        sized = bool(self.max_width or self.min_width)
        if self.law is not None:
            _check_law(self.law, self.material, self.style, ends, slots, sized=sized)
        elif isinstance(self.style, Plain) and not (sized or self.loads):
            raise InputError(NO_WIDTH, where={"field": "max_width"})
        _check_seam(self.seam_position, self.curve)
        settled = {
            "sheet": given,
            "loads": self.loads
            if isinstance(self.loads, Weight)
            else several("loads", self.loads, PointMass, "PointMass"),
            "ends": ends,
            "slots": slots,
            "creep": require_creep(self.creep),
        }
        for name, value in settled.items():
            object.__setattr__(self, name, value)
        _ = self.rod_spec

    @property
    def material(self) -> Sheet:
        """The sheet, also where its name was given."""
        return self.sheet if isinstance(self.sheet, Sheet) else Sheet.named(self.sheet)

    @cached_property
    def gravity_in_plane(self) -> Gravity | None:
        """Gravity as the rod feels it in the plane of its curve."""
        return self._pulled[0]

    @cached_property
    def _pulled(self) -> tuple[Gravity | None, float]:
        """Gravity in the plane of the curve, and the share of a weight that acts there."""
        return pull_in_plane(self.gravity, self.material, self.frame)

    @property
    def in_plane(self) -> "StripSpec":
        """The same request in the plane of the curve alone, without its frame in space."""
        if self.frame is None:
            return self
        gravity, share = self._pulled
        return replace(self, frame=None, gravity=gravity, loads=_lightened(self.loads, share))

    @property
    def may_change(self) -> bool:
        """May the strip leave the drawn curve?"""
        return self.rod_spec.may_change

    @cached_property
    def rod_spec(self) -> RodSpec:
        """What the rod is found from; requests alike but for ends, slots, label or (unloaded) widths share it."""
        gravity, share = self._pulled
        layers: LaminateLayers | None = None
        weight = _hung_weight(self.loads, share)
        if isinstance(self.style, Laminated) and gravity is not None:
            layers = self._layers(self.style, gravity)
            if isinstance(self.loads, Weight):
                raise InputError(
                    "a laminate's own weight follows from its layers: give loads as PointMass records only"
                )
        return RodSpec(
            self._begun,
            gravity,
            self.supports,
            self.natural_curvature,
            self.samples,
            weight=weight,
            limits=self._makeable_limits if self.limits is not None or self.keep is not None else None,
            keep=self.keep,
            layers=layers,
            smooth=self.smooth,
            section=self._section(share),
            widths=self._widths,
            # these decide about a step of the outline; without one all widths share a rod
            outline_widths=(self.max_width, self.min_width) if may_step(self._begun) else (None, None),
        )

    @cached_property
    def run_ins(self) -> StraightEnds:
        """The drawn curve and the part of it that is bent, between straight ends that are the tabs."""
        if not self.straight_ends or (self.curve.has_corners and not self.smooth):
            return StraightEnds(self.curve, self.curve)
        return StraightEnds.of(self.curve, self.supports, self.natural_curvature)

    @cached_property
    def tabs(self) -> tuple[Tab, Tab]:
        """The tabs, at least as long as straight ends are drawn, with the holes that are drawn on those."""
        run_ins = self.run_ins
        holes: tuple[list[Hole], list[Hole]] = ([], [])
        drawn = self.curve.provenance
        for x, y, diameter in drawn.holes if run_ins and drawn is not None else ():
            place = run_ins.place_of((x, y), diameter)
            if place is not None:
                holes[place[0]].append(Hole(round(place[1], 6), round(diameter, 6)))
        first, last = (
            replace(tab, length=max(tab.length, length), holes=(*tab.holes, *drilled)) if length else tab
            for tab, length, drilled in zip(self.ends, run_ins.lengths, holes, strict=True)
        )
        return first, last

    @property
    def tabs_told(self) -> Refusal | None:
        """What is said of straight ends that became tabs, and of circles on them; None where there are none."""
        told = self.run_ins.told
        drilled = sum(
            len(made.holes) - len(own.holes) for made, own in zip(self.tabs, self.ends, strict=True)
        )
        if told is None or not drilled:
            return told
        return note(
            "{tabs} Circles drawn on them became holes: {count}.",
            tabs=told,
            count=drilled,
            severity="warning",
        )

    @property
    def _widths(self) -> WidthRange | None:
        """Widths of a plain strip whose stiffness follows from its loads; None for other strips."""
        sized = self.max_width is not None or self.min_width is not None
        if not sized or not self.loads or self.law is not None or not isinstance(self.style, Plain):
            return None
        least, cuttable = self.min_width or 0.0, self.shop.width_for(self.material)
        if self.max_width is not None and not self.ignore_limits and cuttable < self.max_width:
            least = max(least, cuttable)
        return WidthRange(self.material, least, self.max_width)

    @cached_property
    def _begun(self) -> PlaneCurve:
        """The curve; a closed one from where the strip is joined: where told, else only where it may not change."""
        curve = self.run_ins.bent
        if not curve.is_closed or (curve.has_corners and not self.smooth):  # refused, with places as drawn
            return curve
        if self.seam_position is not None:
            return begin_at(curve, self.seam_position)
        counted = isinstance(self.natural_curvature, RestCurvature)  # from the start
        return curve if self.limits or self.keep or counted else begin_at(curve, flattest_place(curve))

    @property
    def makes_up_for_curl(self) -> bool:
        """Are the widths made for anticlastic bending, as they are unless `compensate` says otherwise?"""
        sheet = self.material
        if self.compensate is not None or self.law is not None or not isinstance(self.style, Plain):
            return False
        # masses settle the widths by themselves
        return sheet.poisson_known and sheet.poisson_ratio > 0 and not self.loads

    @property
    def _width_law(self) -> WidthLaw:
        """The law of a strip that is as wide at its widest, or else at its narrowest, place as asked."""
        if self.max_width is not None:
            return WidthLaw(self.material, 0.0, self.max_width)
        return WidthLaw(self.material, self.min_width or 0.0, np.inf)

    def _section(self, share: float) -> BoundedLaw | None:
        """The law with the weight that pulls in the plane."""
        law: BoundedLaw | None = self.law
        felt = self.gravity_in_plane
        if law is None and self.makes_up_for_curl and (felt is not None or self._asks_for_margin):
            law = self._width_law  # its weight is that of the sheet, its stability that of a plate
            share = 1.0 if felt is None else (self.material.elasto_gravity_length / felt.length) ** 3
        if law is None and felt is None and isinstance(self.style, Laminated):
            changes = self.limits is not None or self.keep is not None
            widths = {"max_width": self.max_width, "min_width": self.min_width}
            return self.style.bounded(self.material, **widths) if changes else None
        if law is None:
            return None
        sheet = getattr(law, "sheet", None)
        if abs(share - 1.0) < SAME_LENGTH or not isinstance(sheet, Sheet):
            return law
        lighter = replace(sheet, density=share * sheet.density, density_range=None)
        return cast(BoundedLaw, replace(cast(Any, law), sheet=lighter))

    @property
    def _asks_for_margin(self) -> bool:
        return self.limits is not None and self.limits.margin is not None

    @property
    def _makeable_limits(self) -> Limits:
        """The limits with what sheet and widths imply: a nearest rod can be cut and bent."""
        limits = Limits() if self.limits is None else self.limits
        if self.ignore_limits:
            return limits
        if self.law is None:
            widths = {"max_width": self.max_width, "min_width": self.min_width}
            limits = _limits_beside(limits, self.material, self.style, **widths)
        if limits.sheet is None:
            limits = replace(limits, sheet=self.material)
        if self.law is None and isinstance(self.style, Plain) and self.max_width is not None:
            ratio = _ratio_of_widths(self.max_width, self.min_width or 0.0, self.material, self.shop)
            limits = replace(limits, ratio=ratio if limits.ratio is None else min(limits.ratio, ratio))
        return limits

    def make(self, found: Rod | NearestRod | None = None) -> Strip:
        """The strip.

        Parameters
        ----------
        found : Rod or NearestRod, optional
            What `rod_spec.solve()` answered, where that is known already.

        Raises
        ------
        NotRealizable
            No strip takes the curve and neither limits nor keep allow it to change.
        NotConvergedError
            No rod near the curve meets the limits; the message says what would help.
        InputError
            As `optimal_rod`, `optimal_laminate`, `nearest_rod` and `Strip`; or the strip cannot be cut or handled,
            with place and cure of each fault.
        StrainError
            It would break.
        """
        rod = accepted_rod(self.rod_spec.solve() if found is None else found)
        if self.makes_up_for_curl and rod.section is None:
            rod = replace(rod, section=self._width_law)
        if isinstance(self.style, Laminated):  # which makes the section itself, as stiff as the rod was found
            rod = replace(rod, section=None)
        told = self.tabs_told
        notes = (*([] if told is None else [told]), *self.rod_spec.smoothing.notes)
        made = Strip(
            replace(rod, warnings=(*rod.warnings, *notes)) if notes else rod,
            self.material,
            max_width=self.max_width,
            min_width=self.min_width,
            style=self.style,
            ends=self.tabs,
            slots=self.slots,
            label=self.label,
            engrave=self.engrave,
            creep=self.creep,
            tolerance=self.tolerance,
        )
        return make_within(
            made, self.shop, compensate=bool(self.compensate), ignore_limits=self.ignore_limits,
            wavers=measured_points(self.curve) is not None,
        )  # fmt: skip

    def changed(self, **fields: Any) -> "StripSpec":
        """The request with other values of some fields."""
        refuse_unknown(fields, {one.name for one in fields_of(self)}, "a strip")
        return replace(self, **fields)

    def with_change(self, change: Change) -> "StripSpec | None":
        """The request with a change that a refusal names; None where that says nothing new of a strip.

        Examples
        --------
        >>> spec = StripSpec(PlaneCurve.spline([(0, 0), (50, 60), (100, 0)], degree=2), "pom-0.5", max_width=9)
        >>> spec.with_change(Change("max_width", 12.0)).max_width, spec.with_change(Change("unit", "cm"))
        (12.0, None)
        """
        require_record(change, Change, "a change", "a Change")
        if change.field == "nearest":
            if self.may_change:
                return None
            return self.changed(limits=self.limits or Limits(), keep=self.keep or Keep())
        if change.field == "thickness":
            return self.changed(sheet=self.material.with_thickness(change.value))
        if change.field == "lap":
            return self.changed(shop=replace(self.shop, lap=change.value))
        if change.field not in {one.name for one in fields_of(self)}:
            return None
        return self.changed(**{change.field: change.value})

    @property
    def _bent(self) -> PlaneCurve:
        """The curve that the strip takes where it may not change."""
        widths = self.max_width, self.min_width
        return Smoothing(self._begun, self.smooth, self.supports, widths=widths).curve

    def _layers(self, style: Laminated, gravity: Gravity) -> LaminateLayers:
        """What the rod of a laminate is found from; its weight is known for sheets that stand upright only."""
        if abs(gravity.length / self.material.elasto_gravity_length - 1) > SAME_LENGTH:
            raise InputError(
                "a laminate that carries its weight must stand upright and weigh what its sheets do: turn its "
                "plane, give {field} the length of the base sheet, or leave it out",
                field=FieldName("gravity"),
            )
        return LaminateLayers(
            LaminatedSection(self.material, style.backing),
            width_profile(style.width, self._bent.length, "the width of the base"),
            style.least_backing,
        )


def make_strip(curve: PlaneCurve, sheet: Sheet | str, **fields: Any) -> Strip:
    """The strip that bends into a curve: `StripSpec(curve, sheet, **fields).make()`.

    Raises
    ------
    NotRealizable, NotConvergedError, InputError
        As `StripSpec` and its `make`; a field that no strip has.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> round(make_strip(arch, "birch-plywood-0.8", max_width=30).width.extremes[1], 6)
    30.0
    """
    refuse_unknown(fields, {one.name for one in fields_of(StripSpec)} - {"curve", "sheet"}, "a strip")
    spec = StripSpec(curve, sheet, **fields)
    with told_in_python(spec.curve, spec.may_change):
        return spec.make()
