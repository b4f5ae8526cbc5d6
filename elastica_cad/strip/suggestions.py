"""Search for changes that make a refused strip possible. Every suggested change was tested."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from itertools import chain, islice
from typing import Any

import numpy as np

from elastica_cad.errors import (
    Change,
    ElasticaError,
    FieldName,
    Length,
    Listed,
    Refusal,
    StrainError,
    note,
    rounded_up,
    sentences,
)
from elastica_cad.form_finding.curve_distance import TargetCurve, measure_deviation
from elastica_cad.form_finding.limits import FAR_SHARE
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.rod_solution import accepted_rod, solve_rod
from elastica_cad.form_finding.sqp import at_most
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.geometry.plane_curve import split_at_corners
from elastica_cad.mechanics.elements import NOUNS, Pin, Rail, Tie, side_of_bar
from elastica_cad.mechanics.equilibrium_check import largest_move
from elastica_cad.mechanics.point_search import move_one_point
from elastica_cad.mechanics.section_limits import thinner_on_sale
from elastica_cad.mechanics.sheets import cut_sheets, sheet_names
from elastica_cad.mechanics.stability import stability
from elastica_cad.mechanics.support_search import suggest_support
from elastica_cad.mechanics.theorem1 import NotRealizable, outlier_message
from elastica_cad.mechanics.trials import MOST_CORNERS, MOST_INFLECTIONS, MOST_STEPS, not_tried
from elastica_cad.strip.clamp_errors import clamp_warning
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.makeable_strip import overstrained
from elastica_cad.strip.own_weight import collapses
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.summary import moves_far, needs_exact_pin

FIRST_FIELDS = ("smooth", "split_corners", "nearest")
CURVE_FIELDS = ("point", *FIRST_FIELDS)
"""Fields that change the curve."""

MOST_TRIED = 3
"""Largest number of changes of one field that are tested. Each test takes as long as the refused computation."""


COLLAPSES = "{effect}; the strip collapses under its own weight if it stands upright"

DANGERS: dict[str, Callable[[Strip], object]] = {
    "{effect}; the strip tips over sideways: guide the strip at the sides": (
        lambda strip: strip.sideways.word == "unstable"
    ),
    "{effect}; the strip snaps at a small error of a clamp": clamp_warning,
    "{effect}; a small mounting error moves the strip far": moves_far,
    "{effect}; a small mounting error puts a pin out of reach": needs_exact_pin,
    COLLAPSES: collapses,
}
"""Added texts on the effect of a change, and the tests of the strips to which they apply."""


@dataclass(frozen=True)
class Suggestion:
    """A tested change of a request: the strip is then possible, stable and within its strain limit.

    `str()` returns the change and its effect, and `as_dict()` a table for reports.

    Attributes
    ----------
    change : Change
        Field and value. For "between", the value is a rail, pin or tie to add. Two fields are not part of a
        request. "point" moves a control point; its value is (index, (x, y)), with indices from 0. "size" is a
        factor on the size of the drawing.
    requests : tuple of StripSpec
        Requests with this change: several requests if the curve is divided at its corners.
    deviation : float
        Largest distance from the drawn curve, mm.
    used : int
        Strain, % of the long-term strain limit of the sheet.
    strips : tuple of Strip
        The strips of the requests.
    width : Change or None
        Other width that the strip also needs.
    """

    change: Change
    requests: tuple[StripSpec, ...] = field(repr=False)
    deviation: float
    used: int
    strips: tuple[Strip, ...] = field(repr=False)
    width: Change | None = None

    @property
    def title(self) -> str:
        """Instruction to make the change."""
        first = instruction(self.change, self.requests[0].curve.provenance)
        return first if self.width is None else sentences([first, instruction(self.width)], " ")

    @property
    def is_far(self) -> bool:
        """True if the strip is farther from the drawn curve than 3 % of the curve's size."""
        return self.deviation > FAR_SHARE * _size(self.requests[0])

    @property
    def dangers(self) -> list[str]:
        """Texts of `DANGERS` that apply to one of the strips."""
        return [text for text, threatens in DANGERS.items() if any(map(threatens, self.strips))]

    @property
    def is_last_resort(self) -> bool:
        """True if the strip is far from the drawn curve, tips over, or is sensitive to small errors."""
        return self.is_far or any(text != COLLAPSES for text in self.dangers)

    @property
    def effect(self) -> Refusal:
        """Sentence on strain, and on the distance from the drawn curve or the length of an enlarged strip."""
        values: dict[str, Any] = {"used": self.used}
        if self.is_far:
            text = "another shape, up to {distance} from the drawn curve, {used} % of the strain limit"
        elif self.deviation:
            text = "within {distance} of the drawn curve, {used} % of the strain limit"
        elif self.change.field == "size":
            text = "a strip {length} long, {used} % of the strain limit"
            values["length"] = Length(float(f"{self.strips[0].rod.length:.3g}"))
        else:
            text = "the curve as drawn, {used} % of the strain limit"
        effect = note(text, distance=about(self.deviation), **values)
        for danger in self.dangers:
            effect = note(danger, effect=effect)
        match self.change.value:
            case Rail(float(at)):
                *_, action = self.strips[0].rod.between
                direction = action.bar_direction(self.strips[0].rod.curve)
                support = note(
                    "build the rail, a bar across the strip, {place} along the curve from its start"
                    if direction is None
                    else "build the rail, a crosswise bar {side}, {place} along the curve from its start",
                    place=Length(at), side="" if direction is None else side_of_bar(direction),
                )  # fmt: skip
            case Pin(float(at)):
                support = note(
                    "build the pin, on which the strip can turn, {place} along the curve from its start",
                    place=Length(at),
                )
            case Tie(float(start), float(end)):
                support = note(
                    "build the tie, a taut cord between the places {places} along the curve from its start",
                    places=Listed((Length(start), Length(end))),
                )
            case _:
                return effect
        return note("{effect}; {support}", effect=effect, support=support)

    def __str__(self) -> str:
        return f"{self.title} ({self.effect})"

    @property
    def table(self) -> Any:
        """New value of the changed field, or the added rail, pin or tie, as it is written in a design file."""
        value = self.change.value
        if not isinstance(value, Rail | Pin | Tie):
            return True if isinstance(value, dict) else value
        given = {name: item for name, item in asdict(value).items() if item is not None}
        return {"kind": NOUNS[type(value)], **given}

    def as_dict(self) -> dict[str, Any]:
        """Return the field, value, deviation (mm), used fraction of the strain limit (%) and text.

        A width that the strip also needs is added as `max_width` (mm).
        """
        record = {
            "field": self.change.field, "value": self.table, "deviation": self.deviation, "used": self.used,
            "text": str(self),
        }  # fmt: skip
        return record if self.width is None else record | {"max_width": self.width.value}


def instruction(change: Change, drawn: Provenance | None = None) -> Refusal:
    """Return a change as an instruction. Coordinates are those of the drawing program."""
    value = change.value
    match change.field, value:
        case "point", (index, place):
            shown = (drawn or Provenance()).shown(place)
            return note("Move control point {number} to {place}.", number=index + 1, place=shown)
        case "smooth", _:
            return note("Smooth the curve by at most {distance}.", distance=Length(value))
        case "nearest", True:
            return note("Take the nearest curve that a strip can take.")
        case "nearest", _:
            return note("Switch the nearest curve off.")
        case "nearest_curve", _:
            return note("Take the nearest curve first, and then support the strip on it.")
        case "elements", _:
            return note("Remove the rails, pins, ties and loads.")
        case "split_corners", _:
            return note("Cut one strip from corner to corner.")
        case "between", Rail(float(at)):
            return note("Rest the strip on a rail at {at}.", at=Length(at))
        case "between", Pin(float(at)):
            return note("Hold the strip with a pin at {at}.", at=Length(at))
        case "between", Tie(float(start), float(end)):
            return note("Tie the strip from {start} to {end}.", start=Length(start), end=Length(end))
        case "sheet", _:
            return note("Cut it from {sheet}.", sheet=value)
        case "size", _:
            return note("Draw the curve {scale:g} times as large.", scale=value)
    return note("Set {field} to {value}.", field=FieldName(change.field), value=Length(value))


def suggest(
    spec: StripSpec,
    problem: ElasticaError,
    fields: Collection[str] | None = None,
    sheet_size: tuple[float, float] | None = None,
) -> Iterator[Suggestion]:
    """Yield at most four tested changes of a refused request that give a suitable strip.

    The first are changes of the curve: a moved control point, smoothing, separate strips between corners, and the
    nearest curve. Then come a rail, pin or tie, other fields that the refusal names, another sheet, and another
    size. A change of the curve at least ten times as large as the smallest one follows the other changes of the
    curve. A strip is suitable if it is bent, stable and strained within the limit of its sheet. Strips farther
    from the drawn curve than 3 % of the curve's size, and strips that tip over sideways or are sensitive to small
    errors, are suggested last.

    Nothing is tried for a curve of very many pieces: see `not_tried`.

    An interrupted search yields the changes found so far, and then raises the interrupt.

    Parameters
    ----------
    spec : StripSpec
        The refused request.
    problem : ElasticaError
        The error that refused the request.
    fields : collection of str, optional
        Fields that may change; by default all.
    sheet_size : pair of float, optional
        Sides of the sheets, mm, on which an enlarged strip must fit; by default those of the request.

    Examples
    --------
    >>> from elastica_cad import PlaneCurve
    >>> spec = StripSpec(PlaneCurve.arc((0, 0), 60, 0, 3), "oak-3", max_width=12)
    >>> try:
    ...     strip = spec.make()
    ... except StrainError as problem:
    ...     print([suggestion.change.field for suggestion in suggest(spec, problem)])
    ['sheet', 'size', 'nearest']
    """
    if outlier_message(spec.curve) or not_tried(spec.curve):
        return
    found: list[Suggestion] = []
    interrupt: BaseException | None = None
    # every refusal suggests the next width
    widths = 2 if fields is None or "max_width" in fields else 0
    # after a refused width, test other fields without changing the width
    is_width = "max_width" in {change.field for change in problem.refusal.changes}
    try:
        with at_most(MOST_STEPS):
            for changes in _changes(spec, problem, fields):
                tried = (change for change in changes if fields is None or change.field in fields)
                held = (
                    try_change(
                        spec, change, 0 if is_width and change.field != "max_width" else widths, sheet_size
                    )
                    for change in islice(tried, MOST_TRIED)
                )
                found += islice(filter(None, held), 1)  # the first suitable change of this field
                if len(found) == 4:
                    break
    except (KeyboardInterrupt, MemoryError) as error:
        interrupt = error

    def deviation(suggestion: Suggestion) -> float:
        return suggestion.deviation if suggestion.change.field in CURVE_FIELDS else 0.0

    last = {id(suggestion): suggestion.is_last_resort for suggestion in found}
    least = min((deviation(item) for item in found if deviation(item) and not last[id(item)]), default=np.inf)
    yield from sorted(
        found,
        key=lambda item: (
            last[id(item)],
            item.change.field not in CURVE_FIELDS,
            # a much larger change of the curve comes after the smaller one
            not last[id(item)] and deviation(item) >= 10 * least,
        ),
    )
    if interrupt is not None:
        raise interrupt


def thinner_for_all(specs: Sequence[StripSpec]) -> float | None:
    """Return the largest thickness below the present thickness, mm, that suits all requests, or None.

    The requests have the same sheet. At most `MOST_TRIED` thicknesses on sale are tested.
    """
    for thickness in islice(thinner_on_sale(specs[0].material), MOST_TRIED):
        if all(try_change(spec, Change("thickness", thickness)) for spec in specs):
            return thickness
    return None


def _changes(
    spec: StripSpec, problem: ElasticaError, fields: Collection[str] | None
) -> Iterator[Iterable[Change]]:
    """Yield possible changes by field. Only the first suitable change of each field is suggested.

    Points and supports take long to find, so they are searched only if `fields` names them.
    """
    named = problem.refusal.changes
    names = dict.fromkeys((*FIRST_FIELDS, *(change.field for change in named)))
    has_loads = spec.may_change or spec.loads or spec.gravity is not None
    without_load = isinstance(problem, NotRealizable) and not has_loads
    exact = without_load and not spec.between
    thinner = [change for change in named if isinstance(problem, StrainError) and change.field == "thickness"]
    if exact and (fields is None or "point" in fields):
        yield _moved_points(spec)
    for name in names:
        yield [change for change in named if change.field == name and change not in thinner]
        if without_load and name == FIRST_FIELDS[-1] and (fields is None or "between" in fields):
            yield _support(spec)
    if isinstance(problem, StrainError):
        share = problem.refusal.values["percent"] / 100
        yield chain(islice(_other_sheets(spec, share), MOST_TRIED - len(thinner)), thinner)
        if not problem.refusal.values["other_unit"]:
            yield [Change("size", rounded_up(1.01 * share, 2))]


def _moved_points(spec: StripSpec) -> Iterator[Change]:
    # with straight ends or smoothing, the curve to bend is not the one that the control points draw
    if spec.run_ins or spec.smooth:
        return
    farthest = FAR_SHARE * _size(spec)
    for index, curve in move_one_point(spec.curve, farthest, spec.supports, spec.natural_curvature):
        yield Change("point", (index, tuple(curve.control_points[index].tolist())))


def _support(spec: StripSpec) -> Iterator[Change]:
    """Yield the change that adds a rail, pin or tie with which the curve becomes possible, if there is one."""
    with suppress(ElasticaError):
        curve = spec.rod_spec.curve_to_bend
        if len(spec.rod_spec.check.zeros) > MOST_INFLECTIONS:
            return
        if element := suggest_support(curve, spec.supports, spec.natural_curvature, spec.between):
            yield Change("between", element)


def _other_sheets(spec: StripSpec, share: float) -> Iterator[Change]:
    """Yield changes to other sheets: for each kind, the thickest sheet that withstands the curve.

    The kind of the present sheet is first. For a user's sheet, only sheets of its kind are considered.
    `share` is the strain divided by the limit of the present sheet.
    """
    own, listed = spec.material, spec.material.name in sheet_names()
    bears = share * own.max_strain / own.thickness
    known = (sheet for sheet in cut_sheets() if listed or sheet.kind == own.kind)
    kinds = set()
    for sheet in sorted(known, key=lambda sheet: (sheet.kind != own.kind, -sheet.thickness)):
        if sheet.max_strain / sheet.thickness >= bears and sheet.kind not in kinds:
            kinds.add(sheet.kind)
            yield Change("sheet", sheet.name)


def _requests(spec: StripSpec, change: Change, sheet_size: tuple[float, float] | None) -> Sequence[StripSpec]:
    """Return the requests with a change: several for a split curve, none if the change does not apply."""
    match change.field, change.value:
        case "point", (index, place):
            points = spec.curve.control_points.copy()
            points[index] = place
            return [
                spec.changed(curve=spec.curve.with_control_points(points).drawn_as(spec.curve.provenance))
            ]
        case "size", scale:
            shop = spec.shop if sheet_size is None else replace(spec.shop, stock=sheet_size)
            return [spec.changed(curve=spec.curve.transformed(np.diag([scale, scale, 1.0])), shop=shop)]
        case "split_corners", _:
            pieces = split_at_corners(spec.curve)
            drawn = spec.curve.degree > 1  # a polyline is not divided at its corners
            apart = drawn and 1 < len(pieces) <= 8 and not (spec.slots or spec.may_change)
            return [spec.changed(curve=piece) for piece in pieces] if apart else []
        case "nearest" | "nearest_curve", _ if len(spec.curve.tangent_breaks) > MOST_CORNERS:
            return []
        case "nearest_curve", fields:
            if "curve" not in fields:
                fields = fields | {"curve": accepted_rod(solve_rod(spec.rod_spec)).curve}
            return [spec.changed(limits=None, keep=None, **fields)]
    changed = spec.with_change(change)
    return [] if changed is None else [changed]


def try_change(
    spec: StripSpec, change: Change, widths: int = 0, sheet_size: tuple[float, float] | None = None
) -> Suggestion | None:
    """Return the suggestion for a change, or None if the strip is impossible or unsuitable.

    If the strip is refused because of its width, the suggested width is tried next, at most `widths` times.
    """
    width = None
    for _ in range(widths + 1):
        try:
            return _tested(spec, change, width, sheet_size)
        except ElasticaError as problem:
            width = next((named for named in problem.refusal.changes if named.field == "max_width"), None)
            if width is None:
                return None
            if change.field == width.field:
                change, width = width, None
    return None


def _tested(
    spec: StripSpec, change: Change, width: Change | None, sheet_size: tuple[float, float] | None
) -> Suggestion | None:
    """Return the suggestion if all its strips can be made, are stable and withstand their strain, or None.

    `width` is a change of the width to be made with it.
    """
    away, used, strips = [0.0], [0], []  # deviations, mm, and strains, % of the limit
    widened = spec if width is None else spec.changed(max_width=width.value)
    requests = tuple(_requests(widened, change, sheet_size))
    for request in requests:
        rod = solve_rod(request.rod_spec)
        strip = request.make(rod)
        away.append(rod.deviation if isinstance(rod, NearestRod) else request.rod_spec.smoothing.moved)
        if change.field == "point":
            away.append(largest_move(spec.curve, request.curve))
        elif change.field == "nearest_curve":
            away.append(measure_deviation(TargetCurve.of(spec.curve), strip.rod.position))
        # a wider strip bends as a plate
        wide = strip.width.extremes[1] > 0.5 * strip.rod.length
        # the search for the nearest curve limits the strain only at its nodes
        near = change.field == "nearest_curve" and strip.strain_verdict.used <= 1.01
        if not (wide or near or strip.strain_verdict.allowed):
            raise overstrained(strip)  # `try_change` tries the width that the error names
        if wide or not stability(strip.rod).stable or strip.unloading_warnings:
            return None
        used.append(strip.strain_verdict.percent)
        strips.append(strip)
    if not max(used):  # there are no requests, or the strips are straight
        return None
    return Suggestion(change, requests, max(away), max(used), tuple(strips), width)


def _size(spec: StripSpec) -> float:
    return float(np.hypot(*np.ptp(spec.curve.bounds, axis=0)))
