"""Request for a strip: all its parameters, their checks, and the computation of the strip."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from dataclasses import fields as fields_of
from typing import Annotated, Any, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import EMPTY, Takes
from elastica_cad._values import EqualByValue, is_number, is_one_of, is_series, require_record, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import (
    BareLength,
    Change,
    FaultError,
    FieldName,
    InputError,
    Length,
    Refusal,
    note,
    refuse_unknown,
    rounded_up,
)
from elastica_cad.form_finding.fairing_request import Smoothing
from elastica_cad.form_finding.limits import Keep, Limits
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.rod_solution import accepted_rod, solve_rod
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.form_finding.straight_ends import StraightEnds
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.cross_sections import (
    Section,
    require_section,
)
from elastica_cad.mechanics.elements import Element, Pin, PointForce, Rail, Tie, require_elements
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.least_ratio import LaminateLayers
from elastica_cad.mechanics.loads import (
    Gravity,
    NaturalCurvature,
    PointMass,
    RestCurvature,
    Supports,
    Weight,
    require_curve,
    require_gentle_pre_bend,
    require_natural_curvature,
    require_supports,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import PlainSection, anticlastic_factor
from elastica_cad.mechanics.sheets import ROD_KIND, Sheet, require_name
from elastica_cad.mechanics.stability import SAFE_MARGIN
from elastica_cad.mechanics.theorem1 import NotRealizable, begin_at, flattest_place, measured_points
from elastica_cad.strip.held_shape import USUAL_TOLERANCE, MakingTolerance
from elastica_cad.strip.lamination import Laminated
from elastica_cad.strip.makeable_strip import make_within, with_warnings
from elastica_cad.strip.outline import USUAL_TABS, Hole, Tab, pair_of_tabs
from elastica_cad.strip.own_weight import weight_warning
from elastica_cad.strip.slots import Slot
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.styles import NO_WIDTH, PLAIN, Plain, Style, require_style, width_profile
from elastica_cad.strip.uncuttable_parts import (
    DEFAULT_LIMITS,
    FabricationLimits,
    accept_faults,
    size_faults,
)

GravityOption: TypeAlias = Gravity | bool | Sequence[float] | None
"""Gravity of a request: a `Gravity`, True for the weight of the sheet along -y, or a direction."""

DOWN = (0.0, 0.0, -1.0)
"""Direction of gravity in space."""

Loads: TypeAlias = "tuple[PointMass | PointForce, ...] | Weight"
"""Loads of a request: masses and forces in addition to the weight of the strip, or a `Weight` that replaces
this weight."""


def pull_in_plane(gravity: GravityOption, sheet: Sheet, frame: Frame | None) -> tuple[Gravity | None, float]:
    """Return gravity in the plane of the strip's curve, and the fraction of a weight that acts in this plane."""
    if gravity is None or isinstance(gravity, bool):
        return (sheet.gravity() if gravity else None), 1.0
    if isinstance(gravity, Gravity):
        return gravity, 1.0
    direction = _direction(gravity)
    if len(direction) == 2:
        return sheet.gravity(direction), 1.0
    if frame is None:
        raise InputError(
            f"gravity {direction} is a direction in space: also give `frame`, the plane of the curve, or give the "
            "direction in the drawing as two numbers",
            where={"field": "gravity"},
        )
    length = sheet.elasto_gravity_length
    felt = Gravity.in_plane(length, direction, frame.x_axis, frame.y_axis)
    # weight is proportional to 1 / length^3; without gravity in the plane, weights are refused
    return felt, 1.0 if felt is None else (length / felt.length) ** 3


def _with_masses_in_plane(loads: Loads, share: float) -> Loads:
    # multiply masses by the fraction of weight that acts in the plane; forces and a `Weight` are used unchanged
    if isinstance(loads, Weight):
        return loads
    return tuple(
        replace(load, mass=share * load.mass) if isinstance(load, PointMass) else load for load in loads
    )


def _hung_weight(loads: Loads, share: float, gravity: Gravity | None) -> Weight | None:
    """Return the weight for `optimal_rod`, or None if there are no loads that need one.

    `share` is the fraction that acts in the plane of the curve. With point forces in N, the strip's own weight
    also counts in N.
    """
    felt = _with_masses_in_plane(loads, share)
    if isinstance(felt, Weight):
        return felt
    masses = tuple(load for load in felt if isinstance(load, PointMass))
    return Weight(masses=masses, own=True) if masses or (felt and gravity is not None) else None


def _direction(direction: object) -> tuple[float, ...]:
    """Return the components of a direction of gravity in the drawing (2) or in space (3)."""
    row: tuple[Any, ...] = ()
    if isinstance(direction, Sequence | np.ndarray) and is_series(direction):
        row = tuple(direction)
    if len(row) not in (2, 3) or not all(map(is_number, row)) or not any(row):
        raise InputError(
            f"gravity is {direction!r}: give True, a Gravity record, or the direction in which things "
            "fall as two numbers in the drawing or three in space, not all zero, such as (0, -1) or "
            "(0, 0, -1)",
            where={"field": "gravity"},
        )
    return tuple(map(float, row))


def _check_section(
    section: Section,
    sheet: Sheet,
    style: Style,
    ends: Sequence[Tab],
    slots: Sequence[Slot],
    *,
    sized: bool,
    compensate: bool,
) -> None:
    """Refuse options that conflict with a section, and another sheet.

    A section has its own limits, so it needs the plain style without widths (`sized` is True if a width is given).
    Only a section whose width varies (`PlainSection`) allows slots, compensated widths and shaped tabs, because a
    planed, turned or stacked strip has no cut-outs. Tabs with only a length are always allowed.
    """
    shaped = bool(slots) or compensate or any(tab != tab.plain for tab in ends)
    shaped = shaped and section.quantity != "width"
    if not isinstance(style, Plain) or sized or shaped:
        raise InputError(
            "{section} sets the width and thickness of the whole strip. Leave out {style}, {slots}, {compensate}, "
            "{max_width} and {min_width} and give tabs only a length, or leave out {section}",
            style=FieldName("style"),
            slots=FieldName("slots"),
            compensate=FieldName("compensate"),
            max_width=FieldName("max_width"),
            min_width=FieldName("min_width"),
            section=FieldName("section"),
            where={"field": "section"},
        )
    other = getattr(section, "sheet", sheet)
    if other != sheet:
        raise InputError(
            "{section} (varying thickness or diameter) uses the sheet {name}, but the strip uses {name_2}: set the "
            "same sheet for both",
            section=FieldName("section"),
            name=other.name,
            name_2=sheet.name,
            where={"field": "section"},
        )


NEAREST_OFF, NO_ELEMENTS = Change("nearest", False), Change("elements", ())


def _check_conflicts(spec: RodSpec) -> None:
    """Refuse options that cannot be combined, such as limits with a number of samples."""
    if spec.layers is not None and (spec.may_change or spec.natural_curvature != 0.0):
        raise InputError(
            "with {gravity}, a laminate can only be made for the drawn curve itself and from flat sheets. "
            "Leave out {limits} (which changes the curve) and {natural_curvature}, or leave out {gravity}",
            limits=FieldName("limits"),
            natural_curvature=FieldName("natural_curvature"),
            gravity=FieldName("gravity"),
            where={"field": ("limits", "natural_curvature", "gravity")},
        )
    if spec.weight is not None and spec.gravity is None:
        raise InputError(
            "A point mass needs gravity in the plane of the curve. Set {gravity}."
            if spec.weight.masses
            else "A weight needs gravity in the plane of the curve. Set {gravity}.",
            gravity=FieldName("gravity"),
            where={"field": "gravity"},
        )
    if spec.may_change and spec.samples is not None:
        raise InputError(
            "{samples} can only be set if the strip follows the drawn curve itself, but {limits} requests "
            "the nearest possible curve. Leave out {limits}, or {samples}",
            limits=FieldName("limits"),
            samples=FieldName("samples"),
            where={"field": ("limits", "samples")},
        )
    if spec.may_change and spec.weight is not None:
        raise InputError(
            "a strip with loads can only be made for the drawn curve itself, but {limits} requests the "
            "nearest possible curve. Leave out {limits}, or {loads}",
            limits=FieldName("limits"),
            loads=FieldName("loads"),
            where={"field": ("limits", "loads")},
            changes=(NEAREST_OFF, NO_ELEMENTS),
        )


def _limits_with_sheet_and_widths(
    limits: Limits, sheet: Sheet, style: Style, *, max_width: float | None, min_width: float | None
) -> Limits:
    """Return the limits, narrowed by the sheet and the requested widths.

    A solid strip must meet `limits.width` as well as `max_width` and `min_width`.
    """
    if (
        limits.sheet is not None
        and not isinstance(style, Laminated)
        and limits.sheet.thickness != sheet.thickness
    ):
        raise InputError(
            "the limits are for {name}, {thickness:g} thick, but the strip is of {name_2}, {thickness_2:g} "
            "thick: leave the sheet out of the limits to use the strip's sheet",
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
                "{name} is {width:g}, outside the limits of the width, {low:g} to {high:g}: change this "
                "width or the limits, or leave out the limits",
                name=FieldName(name),
                width=Length(width),
                low=BareLength(low),
                high=Length(high),
                where={"field": (name, "limits.width")},
            )
    narrowest, widest = min_width or low, max_width or high
    if narrowest > widest:  # `_ratio_of_widths` reports this error
        return limits
    return replace(limits, width=(narrowest, widest))


def _ratio_of_widths(max_width: float, min_width: float, sheet: Sheet, shop: FabricationLimits) -> float:
    """Return the largest stiffness ratio of a strip between these widths that can be cut from the sheet."""
    least = shop.width_for(sheet)
    if min_width > max_width:
        raise InputError(
            "{field} is {min_width:g}, more than {wider} ({max_width:g}): exchange these two widths",
            field=FieldName("min_width"),
            wider=FieldName("max_width"),
            min_width=Length(min_width),
            max_width=Length(max_width),
            where={"field": "max_width"},
        )
    if least >= max_width:
        raise FaultError(
            "{field} is {max_width:g}, but a strip of {name} must be wider than {least} at its widest place: "
            "increase {field}, use another sheet, or lower {least_width}",
            field=FieldName("max_width"),
            least_width=FieldName("shop.least_width"),
            max_width=Length(max_width),
            name=sheet.name,
            least=Length(rounded_up(least, 3)),
            where={"field": "max_width"},
            changes=[Change("max_width", rounded_up(2 * least, 3))],
        )
    return max_width / max(min_width, least)


@contextmanager
def changes_suggested_in_python(curve: PlaneCurve, may_change: bool) -> Iterator[None]:
    """Add a note to errors about the curve, which shows the argument that lets the curve change.

    The nearest curve is not computed, because the computation can take too long.
    """
    try:
        yield
    except (NotRealizable, InputError) as problem:
        if (isinstance(problem, NotRealizable) or curve.has_corners) and not may_change:
            problem.add_note(
                "limits=ec.Limits() asks for the nearest curve that a strip can take, which strip.rod.curve "
                "then is."
            )
        raise


SAME_LENGTH = 1e-9
"""Relative difference of two elasto-gravity lengths (see `Gravity`), or of two weights, that counts as zero."""


@dataclass(frozen=True, eq=False)
class StripSpec(EqualByValue):
    """Request for a strip. Equal requests give equal strips.

    Parameters
    ----------
    curve : PlaneCurve
        Curve of the bent strip.
    sheet : Sheet or str
        Sheet of the strip, or the name of a built-in sheet.
    frame : Frame, optional
        Plane of the curve in space. Directions in space need a frame.
    max_width, min_width : float, optional
        Largest and least width, mm: see `Strip`.
    style : Plain, Perforated or Laminated
        Style of the strip: solid, with holes, or with a glued backing.
    limits, keep : Limits, Keep, optional
        Limits of the strip, and properties of the curve to keep. With `limits` or `keep`, `nearest_rod` may change
        the curve. Otherwise the strip takes the drawn curve, apart from smoothing (see `smooth`).
    gravity : Gravity, bool or sequence of float, optional
        True for the weight of the sheet along -y of the drawing. Two numbers are a direction in the drawing. Three
        numbers are a direction in space; only its component in the plane of `frame` acts. A `Gravity` is used
        unchanged. The weight of a laminate is that of both layers.
    loads : sequence of PointMass and PointForce, or Weight
        Masses hung on the strip in addition to its own weight, and forces (N). A `Weight` is the whole weight in
        newtons. Masses and a `Weight` need gravity.
    between : sequence of Rail, Pin and Tie
        Rails, pins and ties that hold the strip between its ends. The accuracy of such a strip is not computed.
    supports : Supports
        Supports of the ends, clamped by default.
    natural_curvature : float or RestCurvature
        Curvature of the unloaded strip, 1/mm. A `RestCurvature` varies along the strip.
    samples : int, optional
        Number of nodes of the rod; chosen automatically by default.
    ends : pair of Tab
        Tabs at the start and at the end. In a closed strip, the first tab is ignored. The second tab is the
        lap, which is glued to the inside of the start.
    seam_position : float, optional
        Arc length on the drawn curve, mm, at which a closed strip begins and ends. All positions along the strip
        are measured from there. The default is the point of least curvature. With `limits`, `keep` or a
        `RestCurvature`, the default is the start of the drawn curve. An open curve has no seam.
    straight_ends : bool
        If True, a straight piece at the start or the end of the curve becomes a tab, but not where the support
        lets this end turn. Only the part between the tabs is bent, and positions along the strip are measured
        from its start. The tabs are at least as long as drawn, and circles drawn on them become holes. If False,
        the whole curve is bent.
    slots : sequence of Slot
        Slots for other strips, which become part of the outline.
    label : str
        Name in messages, files and assemblies; empty for none.
    engrave : str, optional
        Text engraved on the strip; an empty string for none. By default the label is engraved.
    smooth : float, optional
        Largest distance, mm, by which smoothing may move the curve; 0 keeps it as drawn. Smoothing makes the
        curvature and its derivative continuous. By default, the curve is smoothed only if the outline would have
        steps or corners, by at most 0.1 mm and 5e-4 of the length: see `smooth_curve`.
    shop : FabricationLimits
        Limits of the workshop, such as least widths and the size of the stock.
    compensate : bool, optional
        If True, the widths compensate all effects on the finished strip: slots, narrow tabs, inclined ligaments,
        anticlastic bending and its weight (see `compensate_widths`). If False, the widths are proportional to the
        stiffness. By default, only anticlastic bending is compensated, for solid strips without loads and with a
        known Poisson's ratio (`Sheet.poisson_known`): see `PlainSection`.
    creep : float
        Long-term creep factor phi of the sheet, 0 for none. Creep adds sag, forces and springback to the
        report: see `Strip.crept`.
    section : Section, optional
        Cross-section with the quantity that varies along the strip instead of the width. `ThicknessLaw` and
        `RoundLaw` vary the thickness or the diameter. `LeavesLaw` is for glued plies and needs `limits` or
        `keep`, because a stack can only approximate a curve. `PlainSection` is for a solid strip that bends as a
        beam where it is narrow and as a plate where it is wide. The limits of the section replace `max_width`
        and `min_width`.
    ignore_limits : bool
        If True, a strip outside the limits of the workshop is made with a warning.
    tolerance : MakingTolerance
        Assumed deviations of sheet, cut and clamps, for the expected deviation of the strip.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> spec = StripSpec(arch, "birch-plywood-0.8", max_width=30)
    >>> round(spec.make().width.extremes[1], 6)
    30.0
    >>> spec.changed(label="A").rod_spec == spec.rod_spec  # the same rod serves both
    True
    """

    curve: Annotated[PlaneCurve, Option("Curve of the bent strip.", group="curve")]
    sheet: Annotated[
        Sheet | str,
        Option(
            "Material: the name of a sheet, or your own file, my.toml or my.toml:NAME.",
            group="sheet",
            common=True,
            written=Sheet,
        ),
    ]
    frame: Frame | None = None
    max_width: Annotated[
        float | None, Option("Width of the widest place.", "mm", above=0, group="widths", common=True)
    ] = None
    min_width: Annotated[
        float | None,
        Option("Width of the narrowest place, or its limit.", "mm", above=0, group="widths", common=True),
    ] = None
    style: Annotated[
        Style,
        Option("Style: one sheet, a sheet with holes, or two glued sheets.", group="widths", common=True),
    ] = PLAIN
    limits: Annotated[
        Limits | None,
        Option(
            "Limits that the strip must meet; the curve changes as little as possible to meet them.",
            group="limits",
            common=True,
            replaces=("samples",),
        ),
    ] = None
    keep: Annotated[
        Keep | None,
        Option(
            "Properties of the curve that stay when it changes.",
            group="limits",
            common=True,
            replaces=("samples",),
        ),
    ] = None
    gravity: Annotated[
        GravityOption,
        Option(
            "Own weight of the strip: true, the direction of gravity, or also its elasto-gravity length.",
            group="weight",
            common=True,
            written=bool | tuple[float, float, float] | tuple[float, float] | Gravity,
        ),
    ] = None
    loads: Annotated[
        Takes[
            tuple[PointMass | PointForce, ...] | Weight,
            PointMass | PointForce | Sequence[PointMass | PointForce] | Weight,
        ],
        Option(
            "Masses and forces on the strip, or its weight in newtons, own weight included.",
            group="weight",
            written=tuple[PointMass | PointForce, ...] | Weight,
        ),
    ] = EMPTY
    between: Annotated[
        Takes[tuple[Rail | Pin | Tie, ...], Rail | Pin | Tie | Sequence[Rail | Pin | Tie]],
        Option(
            "Rails, pins and ties that hold the strip between its ends.",
            group="ends",
            written=tuple[Element, ...],
        ),
    ] = EMPTY
    supports: Annotated[
        Supports, Option("Supports of the start and the end of the curve.", group="ends", common=True)
    ] = field(default_factory=Supports)
    natural_curvature: Annotated[
        NaturalCurvature,
        Option(
            "Curvature before bending: a number, stations, or the curve of a pre-bent strip.",
            "1/mm",
            group="curve",
            common=True,
        ),
    ] = 0.0
    samples: Annotated[
        int | None,
        Option(
            "Number of nodes of the rod; chosen automatically by default.", least=3, most=10000, group="curve"
        ),
    ] = None
    ends: Annotated[
        Takes[tuple[Tab, Tab], Tab | Sequence[Tab]],
        Option(
            "Tab for both ends, or one for the start and one for the end; by default, a free end has no tab.",
            group="ends",
            common=True,
            written=Tab | tuple[Tab, Tab],
        ),
    ] = USUAL_TABS
    seam_position: Annotated[
        float | None,
        Option(
            "Place of the joint of a closed strip along its curve; by default where it is bent least.",
            "mm",
            least=0,
            group="ends",
        ),
    ] = None
    straight_ends: Annotated[
        bool,
        Option(
            "Use straight first and last pieces of the curve as tabs; if false, bend the whole curve.",
            group="ends",
        ),
    ] = True
    slots: Annotated[
        Takes[tuple[Slot, ...], Slot | Sequence[Slot]],
        Option("Slots from the edge.", many=1000, group="ends"),
    ] = EMPTY
    label: Annotated[
        str, Option("Name of the strip, which is engraved on it.", most=200, group="ends", common=True)
    ] = ""
    engrave: Annotated[
        str | None, Option("Text engraved in place of the label; empty for none.", most=200, group="ends")
    ] = None
    smooth: Annotated[
        float | None,
        Option(
            "Largest distance by which smoothing may move the curve; 0 keeps it as drawn.",
            "mm",
            least=0,
            group="curve",
            common=True,
        ),
    ] = None
    shop: Annotated[FabricationLimits, Option("Limits of the workshop.", group="limits")] = DEFAULT_LIMITS
    compensate: Annotated[
        bool | None,
        Option(
            "Correct the widths for slots and narrow tabs too, not only for anticlastic bending.",
            group="widths",
            common=True,
        ),
    ] = None
    creep: Annotated[
        float,
        Option("Long-term creep factor of the sheet; 0 for no creep.", least=0, group="weight"),
    ] = 0.0
    section: Annotated[
        Section | None,
        Option(
            "Section: thickness, diameter of a rod or tube, or number of plies varies instead of the width.",
            group="widths",
            replaces=("max_width", "min_width", "compensate", "slots", "style"),
        ),
    ] = None
    ignore_limits: Annotated[
        bool,
        Option(
            "Make a strip even if it cannot be cut or handled, with a warning.", group="limits", common=True
        ),
    ] = False
    tolerance: Annotated[
        MakingTolerance,
        Option(
            "Assumed errors of sheet, cut and clamps. The expected accuracy of the strip is computed from them.",
            group="sheet",
        ),
    ] = USUAL_TOLERANCE

    def __post_init__(self) -> None:
        require_curve(self.curve)
        sheet = Sheet.of(self.sheet)
        supports = require_supports(self.supports, between=not is_one_of(self.between, (None, (), [])))
        object.__setattr__(self, "supports", supports)
        require_natural_curvature(self.natural_curvature)
        require_declared(StripSpec, vars(self))
        require_gentle_pre_bend(self.natural_curvature, sheet.thickness)
        require_record(self.frame, Frame | None, "the frame", "a Frame, the plane of the curve, or None")
        require_style(self.style)
        ends, slots = pair_of_tabs(self.ends, supports), several("slots", self.slots, Slot, "Slot")
        sized = bool(self.max_width or self.min_width)
        if self.section is not None:
            require_section(self.section)
            _check_section(
                self.section, self.material, self.style, ends, slots,
                sized=sized, compensate=bool(self.compensate),
            )  # fmt: skip
        elif self.material.kind == ROD_KIND:
            raise InputError(
                "{sheet} is a rod, so no strip can be cut from it. Choose another {field}, or set the diameters "
                "of the rod ({section}). `elastica bow --rod` bends a rod by a cord.",
                sheet=self.material.name, field=FieldName("sheet"), section=FieldName("section"),
                where={"field": "sheet"},
            )  # fmt: skip
        elif isinstance(self.style, Plain) and not (sized or self.loads):
            raise InputError(NO_WIDTH, where={"field": "max_width"})
        if self.seam_position is not None:
            if self.seam_position > self.curve.length:
                raise InputError(
                    "{field} is {seam:g}, which is not on the curve: set a place from 0 to {length:.4g}, or leave "
                    "out {field}",
                    field=FieldName("seam_position"),
                    seam=self.seam_position,
                    length=Length(self.curve.length),
                    where={"field": "seam_position"},
                )
            if not self.curve.is_closed:
                raise InputError(
                    "the curve is open and has no joint, but {field} puts a joint {seam:g} from its start: leave "
                    "out {field}, or close the curve",
                    field=FieldName("seam_position"),
                    seam=Length(self.seam_position),
                    where={"field": "seam_position"},
                )
        vars(self).update(
            sheet=sheet,
            label=require_name(self.label, "the label"),
            loads=self.loads
            if isinstance(self.loads, Weight)
            else several("loads", self.loads, PointMass | PointForce, "PointMass or PointForce"),
            between=require_elements(self.between),
            ends=ends,
            slots=slots,
        )
        _check_conflicts(self.rod_spec)
        if self.between or self.rod_spec.point_forces:
            self._require_alone()

    def _require_alone(self) -> None:
        """Raise InputError for fields that cannot be combined with rails, pins, ties and point forces."""
        if self.section is None and self.may_change:
            name = "limits" if self.limits is not None else "keep"
            raise InputError(
                "Rails, pins, ties and point forces cannot be combined with a nearest curve. First make the strip "
                "without them. Then take its curve ({curve}) as the drawn curve, leave out {field}, and add them.",
                curve=FieldName("rod.curve"),
                field=FieldName(name),
                where={"field": (name, "between", "loads")},
                changes=(
                    Change("nearest_curve", {"between": self.between, "loads": self.loads}),
                    NEAREST_OFF,
                    NO_ELEMENTS,
                ),
            )
        curve = self._curve_from_seam
        conflicts = {
            "a section": ("section", self.section is not None),
            "a style other than plain": ("style", not isinstance(self.style, Plain)),
            "creep": ("creep", bool(self.creep)),
            "compensation of the widths": ("compensate", bool(self.compensate)),
            "a closed curve": ("curve", curve.is_closed),
        }
        for what, (name, is_set) in conflicts.items():
            if is_set:
                raise InputError(
                    "Rails, pins, ties and point forces cannot be combined with {what}. Leave out {field}, or "
                    "these elements.",
                    what=note(what),
                    field=FieldName(name),
                    where={"field": (name, "between", "loads")},
                    changes=(NO_ELEMENTS,),
                )

    @property
    def material(self) -> Sheet:
        """Sheet of the strip as a record."""
        return self.sheet if isinstance(self.sheet, Sheet) else Sheet.named(self.sheet)

    @cached_property
    def gravity_in_plane(self) -> Gravity | None:
        """Gravity that acts on the rod in the plane of its curve."""
        return self._gravity_and_fraction[0]

    @cached_property
    def _gravity_and_fraction(self) -> tuple[Gravity | None, float]:
        return pull_in_plane(self.gravity, self.material, self.frame)

    @property
    def _neglected_gravity(self) -> Gravity | None:
        """Gravity that acts in the plane of the curve, but is not included; None if the request sets `gravity`."""
        if self.gravity is not None and not is_one_of(self.gravity, [False]):
            return None
        down: GravityOption = True if self.frame is None else DOWN
        return pull_in_plane(down, self.material, self.frame)[0]

    @property
    def in_plane(self) -> "StripSpec":
        """Equivalent request whose directions are in the plane of the curve, without `frame`."""
        if self.frame is None:
            return self
        gravity, share = self._gravity_and_fraction
        return replace(self, frame=None, gravity=gravity, loads=_with_masses_in_plane(self.loads, share))

    @property
    def may_change(self) -> bool:
        """True if the strip may deviate from the drawn curve."""
        return self.rod_spec.may_change

    @property
    def largest_ratio(self) -> float:
        """Largest stiffness ratio that the limits, the widths and the workshop allow."""
        return self._makeable_limits.largest_ratio

    @cached_property
    def rod_spec(self) -> RodSpec:
        """Request from which the rod of this strip is computed.

        The request has no tabs, slots and label, and has widths only for loads, limits, a section or
        smoothing.
        """
        gravity, share = self._gravity_and_fraction
        layers: LaminateLayers | None = None
        weight = _hung_weight(self.loads, share, gravity)
        forces = [] if isinstance(self.loads, Weight) else self.loads
        if isinstance(self.style, Laminated) and gravity is not None:
            layers = self._layers(self.style, gravity)
            if isinstance(self.loads, Weight):
                raise InputError(
                    "a laminate's own weight follows from its layers: give loads as PointMass records only"
                )
        return RodSpec(
            self._curve_from_seam,
            gravity,
            self.supports,
            self.natural_curvature,
            self.samples,
            weight=weight,
            between=self.between,
            point_forces=tuple(load for load in forces if isinstance(load, PointForce)),
            limits=self._makeable_limits if self.limits is not None or self.keep is not None else None,
            keep=self.keep,
            layers=layers,
            smooth=self.smooth,
            section=self._section_in_plane(share),
            widths=self._widths,
            sheet=self.material if self.section is None and not isinstance(self.style, Laminated) else None,
        )

    @cached_property
    def run_ins(self) -> StraightEnds:
        """Drawn curve, divided into its bent part and straight ends that become tabs."""
        # without smoothing, a curve with corners is refused later
        if not self.straight_ends or (self.curve.has_corners and not self.smooth):
            return StraightEnds(self.curve, self.curve)
        return StraightEnds.of(self.curve, self.supports, self.natural_curvature)

    @cached_property
    def tabs(self) -> tuple[Tab, Tab]:
        """Tabs of the strip.

        The tabs are at least as long as the drawn straight ends, and have the holes drawn on these ends.
        """
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
    def tabs_message(self) -> Refusal | None:
        """Note on straight ends that became tabs, and on circles that became holes; None without straight ends."""
        message = self.run_ins.message
        drilled = sum(
            len(tab.holes) - len(requested.holes) for tab, requested in zip(self.tabs, self.ends, strict=True)
        )
        if message is None or not drilled:
            return message
        return note(
            "{tabs} Circles drawn on the tabs became holes: {count}.",
            tabs=message,
            count=drilled,
            severity="warning",
        )

    @property
    def _widths(self) -> PlainSection | None:
        """Range of widths of a plain strip with loads, which fixes its stiffness; None for other strips."""
        sized = self.max_width is not None or self.min_width is not None
        if not sized or not self.loads or self.section is not None or not isinstance(self.style, Plain):
            return None
        least, cuttable = self.min_width or 0.0, self.shop.width_for(self.material)
        # if even `max_width` cannot be cut, the fault of the finished strip is reported later
        if self.max_width is not None and not self.ignore_limits and cuttable < self.max_width:
            least = max(least, cuttable)
        return PlainSection(self.material, least, self.max_width or np.inf)

    @cached_property
    def _curve_from_seam(self) -> PlaneCurve:
        """Curve to which the strip is bent. A closed curve starts at the seam.

        By default, the seam is at the point of least curvature. If the curve may change, or the request has a
        `RestCurvature`, the seam is at the start of the drawn curve.
        """
        curve = self.run_ins.bent
        # without smoothing, a curve with corners is refused later, when the rod is computed
        if not curve.is_closed or (curve.has_corners and not self.smooth):
            return curve
        if self.seam_position is not None:
            return begin_at(curve, self.seam_position)
        # keep the start of the curve, because stations of a rest curvature are measured from there
        counted = isinstance(self.natural_curvature, RestCurvature)
        return curve if self.limits or self.keep or counted else begin_at(curve, flattest_place(curve))

    @property
    def makes_up_for_curl(self) -> bool:
        """True if the widths compensate anticlastic bending by default (`compensate` is None)."""
        sheet = self.material
        if self.compensate is not None or self.section is not None or not isinstance(self.style, Plain):
            return False
        # the compensation supports neither loads nor the weight of a strip with rails, pins or ties
        free = not self.loads and not (self.between and self.gravity_in_plane is not None)
        return sheet.poisson_known and sheet.poisson_ratio > 0 and free

    @property
    def _plate(self) -> PlainSection:
        # section of a solid strip that compensates anticlastic bending. With `max_width`, the widths follow from
        # it, and `min_width` is a limit that the style checks
        least = 0.0 if self.max_width else self.min_width or 0.0
        return PlainSection(self.material, least, self.max_width or np.inf)

    def _section_in_plane(self, share: float) -> Section | None:
        """Return the section, or None if the width is proportional to the stiffness.

        The density of the section is multiplied by `share`, the fraction of the weight that acts in the plane of
        the curve.
        """
        section: Section | None = self.section
        felt = self.gravity_in_plane
        asks_for_margin = self.limits is not None and self.limits.margin is not None
        # without weight and stability margin, the section does not change the rod, and `bend` adds it later
        if section is None and self.makes_up_for_curl and (felt is not None or asks_for_margin):
            section = self._plate
            # the gravity of the request determines the weight, which is proportional to 1 / length^3
            share = 1.0 if felt is None else (self.material.elasto_gravity_length / felt.length) ** 3
        if section is None and felt is None and isinstance(self.style, Laminated):
            changes = self.limits is not None or self.keep is not None
            widths = {"max_width": self.max_width, "min_width": self.min_width}
            return self.style.bounded(self.material, **widths) if changes else None
        if section is None:
            return None
        sheet = getattr(section, "sheet", None)
        if abs(share - 1.0) < SAME_LENGTH or not isinstance(sheet, Sheet):
            return section
        return section.with_sheet(sheet.with_weight_share(share))

    @property
    def _makeable_limits(self) -> Limits:
        """Limits that include those of the sheet, the widths and the workshop, unless `ignore_limits` is set."""
        limits = Limits() if self.limits is None else self.limits
        if self.ignore_limits:
            return limits
        if self.section is None:
            widths = {"max_width": self.max_width, "min_width": self.min_width}
            limits = _limits_with_sheet_and_widths(limits, self.material, self.style, **widths)
        if limits.sheet is None:
            limits = replace(limits, sheet=self.material)
        if self.section is None and isinstance(self.style, Plain) and self.max_width is not None:
            ratio = _ratio_of_widths(self.max_width, self.min_width or 0.0, self.material, self.shop)
            if self.makes_up_for_curl:
                # anticlastic bending stiffens the narrowest place by at most this factor, which makes it narrower
                stiffening = anticlastic_factor(
                    self.max_width / ratio, limits.largest_curvature or 0.0,
                    thickness=self.material.thickness, poisson_ratio=self.material.poisson_ratio,
                )  # fmt: skip
                ratio = max(1.0, ratio / float(stiffening))
            # the limits get the smaller of both ranges of widths
            if limits.width is None or ratio < limits.width[1] / limits.width[0]:
                limits = replace(limits, width=(self.max_width / ratio, self.max_width))
        return limits

    def size_above(self, longest: float) -> tuple[float, float]:
        """Return the length with tabs and the largest width, mm; 0 for sizes that only the rod determines.

        A strip that is joined from pieces is shorter than `longest` mm, and so is a strip whose curve may change,
        unless its drawn curve is a tenth longer.
        """
        if self.section is not None:
            return 0.0, 0.0
        length = self.run_ins.bent.length + sum(tab.length for tab in self.tabs)
        if self.shop.lap is not None or (self.may_change and 0.9 * length <= longest):
            length = min(length, 0.9 * longest)
        outer = getattr(self.style, "width", None) or (None if self.loads else self.max_width)
        return length, float(outer) if isinstance(outer, int | float) else 0.0

    def require_size(self) -> None:
        """Raise FaultError for a strip larger than its stock, before its rod is computed."""
        stock = self.shop.stock_for(self.material)
        size = self.size_above(stock[0])
        faults = size_faults(self.label or "strip", *size, self.material, stock, self.style)
        accept_faults(tuple(faults), self.ignore_limits)

    def make(self, found: Rod | NearestRod | None = None) -> Strip:
        """Return the strip.

        Parameters
        ----------
        found : Rod or NearestRod, optional
            Result of `solve_rod(rod_spec)`, if it is already known.

        Raises
        ------
        NotRealizable
            No strip takes the curve, and neither `limits` nor `keep` allows the curve to change.
        NotConvergedError
            No rod near the curve meets the limits; the message suggests changes.
        StrainError
            The strip would break.
        """
        if found is None:
            self.require_size()
            found = solve_rod(self.rod_spec)
        strip = self.bend(accepted_rod(found))
        made = make_within(
            strip, self.shop, compensate=bool(self.compensate), ignore_limits=self.ignore_limits,
            noisy=measured_points(self.curve) is not None,
        )  # fmt: skip
        neglected = self._neglected_gravity
        warning = None if neglected is None else weight_warning(made, neglected)
        return made if warning is None else with_warnings(made, warning)

    def bend(self, rod: Rod) -> Strip:
        """Return the strip of a rod, without joints, compensation or checks for the workshop."""
        if self.makes_up_for_curl and rod.section is None:
            rod = replace(rod, section=self._plate)
        # the style of a laminate computes its section from the stiffness of the rod
        if isinstance(self.style, Laminated):
            rod = replace(rod, section=None)
        tabs_note = self.tabs_message
        notes = (*([] if tabs_note is None else [tabs_note]), *self.rod_spec.smoothing.notes)
        return Strip(
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

    def changed(self, **fields: Any) -> "StripSpec":
        """Return a copy of the request with other values of the given fields."""
        refuse_unknown(fields, {option.name for option in fields_of(self)}, "a strip")
        return replace(self, **fields)

    def with_change(self, change: Change) -> "StripSpec | None":
        """Return the request with a suggested change, or None if the change does not apply to it.

        Examples
        --------
        >>> spec = StripSpec(PlaneCurve.spline([(0, 0), (50, 60), (100, 0)], degree=2), "pom-0.5", max_width=9)
        >>> spec.with_change(Change("max_width", 12.0)).max_width, spec.with_change(Change("unit", "cm"))
        (12.0, None)
        """
        require_record(change, Change, "a change", "a Change")
        # "nearest", "thickness", "elements" and "lap" are not fields; "between" has an element to add
        if change.field == "nearest":
            if self.may_change == bool(change.value):
                return None
            if not change.value:
                return self.changed(limits=None, keep=None)
            return self.changed(limits=Limits(margin=SAFE_MARGIN), keep=self.keep or Keep())
        if change.field == "thickness":
            sheet = self.material.with_thickness(change.value)
            return self.changed(sheet=sheet, section=self.section and self.section.with_sheet(sheet))
        if change.field == "between":
            return self.changed(between=(*self.between, change.value))
        if change.field == "elements":
            return self.changed(between=(), loads=())
        if change.field == "lap":
            return self.changed(shop=replace(self.shop, lap=change.value))
        if change.field not in {option.name for option in fields_of(self)}:
            return None
        return self.changed(**{change.field: change.value})

    def _layers(self, style: Laminated, gravity: Gravity) -> LaminateLayers:
        """Return the layers for the rod of a laminate. Gravity must act fully in the plane of the curve."""
        if abs(gravity.length / self.material.elasto_gravity_length - 1) > SAME_LENGTH:
            raise InputError(
                "the weight of a laminate is computed from its sheets and for a vertical plane of the curve, "
                "but {field} has another value. Make this plane vertical, set {field} to the value of the base "
                "sheet, or leave out {field}",
                field=FieldName("gravity"),
            )
        bent = Smoothing(self._curve_from_seam, self.smooth, self.supports).curve
        return LaminateLayers(
            LaminatedSection(self.material, style.backing),
            width_profile(style.width, bent.length, "the width of the base"),
            style.least_backing,
        )


def make_strip(curve: PlaneCurve, sheet: Sheet | str, **fields: Any) -> Strip:
    """Return the strip that bends into a curve: `StripSpec(curve, sheet, **fields).make()`.

    Raises
    ------
    NotRealizable, NotConvergedError, InputError
        See `StripSpec` and `StripSpec.make`. An unknown field raises InputError.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    >>> round(make_strip(arch, "birch-plywood-0.8", max_width=30).width.extremes[1], 6)
    30.0
    """
    refuse_unknown(fields, {option.name for option in fields_of(StripSpec)} - {"curve", "sheet"}, "a strip")
    spec = StripSpec(curve, sheet, **fields)
    with changes_suggested_in_python(spec.curve, spec.may_change or bool(spec.between)):
        return spec.make()
