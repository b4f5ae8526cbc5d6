"""Make strips from edges drawn in a CAD library, from plane curves, or from finished strips."""

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from functools import lru_cache
from math import radians
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Any

from elastica_cad._values import is_number, is_one_of, is_series, several
from elastica_cad.errors import InputError, Length, UnknownOptionError, note, refuse_unknown
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.kernel.drawn_edges import plane_curve
from elastica_cad.kernel.ocp_import import bare
from elastica_cad.kernel.strip_body import (
    LEAST_LEAN_DEGREES,
    MadeStrip,
    StripBody,
    color_numbers,
    numbers_of,
    warn,
    warn_of_radians,
    warn_of_strip,
)
from elastica_cad.kernel.strip_options import FixtureSizes, StripOptions
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.outline import StripEnd
from elastica_cad.strip.slots import Slot
from elastica_cad.strip.strip import Strip

if TYPE_CHECKING:
    from elastica_cad.model.fixtures import EndFixture
    from elastica_cad.strip.strip_spec import StripSpec

FIXTURE_SIZES = tuple(FixtureSizes.__annotations__)
# for names that users may try, the way in which the option is passed
GIVEN_OTHERWISE = {
    "material": 'sheet="mdf-3" or another name of ec.sheet_names()',
    "thickness": 'sheet="birch-plywood-0.8" or ec.Sheet(..., thickness=0.8); the sheet has the thickness',
    **dict.fromkeys(("tab", "tabs"), "ends=ec.Tab(12)"),
    **dict.fromkeys(("hole", "holes"), "ends=ec.Tab(12, holes=ec.Hole(6, 3.2))"),
    **dict.fromkeys(("notch", "notches"), "slots=ec.Slot(...)"),
    "name": "label=...",
    "text": "engrave=...",
    "kerf": "kerf=... to ec.save(...)",
    "backing": "style=Laminated(width=..., backing=...)",
    "columns": "style=Perforated(width=..., columns=...)",
    "number": "engrave=...",
    "rows": "style=Perforated(width=..., rows=...)",
    "width": "max_width=..., or style=Perforated(width=...)",
}
NO_CURVES = {
    "StripSpec": "the strip that its .make() makes",
    "Placed": "its .strip",
    "Rod": "ec.Strip(rod, sheet, max_width=...)",
    "NearestRod": "ec.Strip(found.rod, sheet, max_width=...)",
}
"""For each type of record that is not a curve, the object that the user must pass instead."""


class FixtureOptions(StripOptions, FixtureSizes, total=False):
    """Options of a strip, and sizes of an end fixture, mm: see `model.EndFixture`."""


class BlockOptions(FixtureSizes, total=False):
    """Options of the end fixture of a finished strip: see `model.EndFixture`."""

    floor: Annotated["Any", "Plane under the block, of any library; by default perpendicular to the tab."]
    engrave: Annotated[
        "str | None",
        "Text engraved on the block; the strip's name and the number of the end unless given, empty for none.",
    ]


def make_strip_on(
    path: Any, sheet: Sheet | str | None = None, *, workplane: Any = None, **options: Any
) -> MadeStrip:
    """Return the strip for a path, made by `StripSpec`. Equal requests return the same strip.

    Parameters
    ----------
    path : PlaneCurve, edges and wires of a kernel, a Strip, or the body of a Strip
        Path of the strip. Drawn edges determine their plane. For a `PlaneCurve` or `Strip`, the option `plane` is
        the plane of the curve, by default the xy plane.
    sheet : Sheet or str
        Sheet of the strip; None for a finished strip.
    workplane : Frame, or a plane of build123d or CadQuery, optional
        Plane in which the path was drawn. This plane determines the axes of the curve's plane.
    **options
        `StripOptions`, and `max_width`.
    """
    from elastica_cad.strip.strip_spec import StripSpec, changes_suggested_in_python

    drawn = getattr(path, "line", None)
    # use the line of a `BuildLine` of build123d
    path = path if drawn is None or callable(drawn) else drawn
    options = {name: value for name, value in options.items() if value is not None}
    _refuse_unknown(options)
    color = color_numbers(options.pop("color")) if "color" in options else None
    if isinstance(path, str | PathLike):
        raise InputError(
            f"{str(path)!r} is not a curve. Pass the curve first; ec.read_curves(file)[0] reads a file."
        )
    rows = list(path) if is_series(path) and (isinstance(path, Sequence) or hasattr(path, "tolist")) else []
    if rows and all(
        _is_vector(row) or (bare(row) is row and is_series(row) and all(map(is_number, row))) for row in rows
    ):
        raise InputError(
            f"The path is a list of {len(rows)} points. Pass a spline through them, such as "
            "ec.PlaneCurve.fit(points) or a CAD library's spline."
        )
    if "ends" in options:
        ends = options["ends"]
        lengths = [end for end in (ends if is_series(ends) else [ends]) if is_number(end)]
        if lengths:
            raise InputError(
                f"`ends` contains the number {lengths[0]:g}. Pass ec.Tab({lengths[0]:g}) for a tab of this length."
            )
    if "slots" in options:
        in_degrees = several("slots", options["slots"], Slot, "Slot")
        warn_of_radians([slot.lean for slot in in_degrees], LEAST_LEAN_DEGREES)
        options["slots"] = tuple(replace(slot, lean=radians(slot.lean)) for slot in in_degrees)
    frame = _frame_of(options.pop("plane")) if "plane" in options else None
    if isinstance(path, Strip | StripBody):
        late = [*(("sheet",) if sheet is not None else ()), *options]
        if late:
            raise InputError(
                f"{', '.join(late)}: the options of a finished strip cannot be changed. Pass the curve instead."
            )
        if isinstance(path, Strip):
            warn_of_strip(path)
            return MadeStrip(path, frame or Frame(), color=color)
        return MadeStrip(path.strip, frame or path.frame, path.deviation, color=color or path._changed_color)
    kind = type(path).__name__
    if kind in NO_CURVES:
        raise InputError(f"A {kind} is not a curve. Pass {NO_CURVES[kind]}.")
    if sheet is None:
        raise InputError('A strip for a curve needs a sheet. Pass a Sheet or its name, such as "mdf-3".')
    if _is_vector(options.get("gravity")):
        options["gravity"] = numbers_of(options["gravity"])
    if isinstance(path, PlaneCurve):
        curve, frame = path, frame or Frame()
    else:
        # rotation from the global axes to those of the workplane
        drawn_on = None if workplane is None else _frame_of(workplane).axes.T
        curve, frame = plane_curve(path, frame, turned=drawn_on)
    width = options.get("max_width")
    # a curve shorter than the width of its strip was probably drawn in metres
    if curve.length < 5.0 and isinstance(width, int | float) and width > curve.length:
        raise InputError(
            (
                "The curve is only {length:.3g} long. Draw it in millimetres (in metres it would be "
                "{metres:.3g})."
            ),
            length=Length(curve.length),
            metres=Length(1000 * curve.length),
        )
    spec = StripSpec(curve, sheet, frame, **options)
    with changes_suggested_in_python(spec.curve, spec.may_change):
        strip, deviation = _strip_and_deviation(spec)
    warn_of_strip(strip)
    if deviation > 0.01 * strip.rod.length:
        warn(note(
            "The strip deviates from the drawn curve by up to {far}, {percent:.2g} % of its length, because "
            "its options allow this.",
            far=Length(deviation), percent=100 * deviation / strip.rod.length,
        ))  # fmt: skip
    return MadeStrip(strip, frame, deviation, color=color)


def make_fixture_on(
    path: Any,
    sheet: Sheet | str | None = None,
    *,
    end: StripEnd = "start",
    floor: Any = None,
    engrave: str | None = None,
    workplane: Any = None,
    **options: Any,
) -> "tuple[MadeStrip, EndFixture]":
    """Return the strip made by `make_strip_on`, and the block that holds one of its ends.

    `floor` and `workplane` are planes of any CAD library, and `options` are `FixtureOptions`. Errors are
    those of `EndFixture` and `make_strip_on`.
    """
    from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture

    sizes = {name: options.pop(name) for name in FIXTURE_SIZES if name in options}
    _refuse_unknown(options, FIXTURE_SIZES)
    color = options.pop("color", None)
    color = color_numbers(FIXTURE_COLOR if color is None else color)
    result = replace(make_strip_on(path, sheet, workplane=workplane, **options), color=color)
    ground = None if floor is None else _frame_of(floor)
    engrave = None if engrave is None else str(engrave)
    block = EndFixture.of(result.strip, end, result.frame, floor=ground, engrave=engrave, **sizes)
    return replace(result, block=block), block


def section_requests(
    body: Any, planes: Any, options: StripOptions, *, half: bool
) -> "list[tuple[PlaneCurve, StripOptions]]":
    """Return the curve of each section of a body, and the options of its strip. Each omitted line causes a warning.

    `planes` are planes of any CAD library, or a `SectionSpec`. `half` selects the parts with x >= 0. The options
    include the plane of the section, and a label with a number.
    """
    from elastica_cad.form_finding.section_spec import GivenCuts, SectionSpec
    from elastica_cad.kernel.shape_sections import shape_surface

    if not isinstance(planes, SectionSpec):
        rows = (planes,) if isinstance(planes, Frame) or not is_series(planes) else tuple(planes)
        if not rows:
            raise InputError(
                "There is no plane. Pass at least one plane that cuts the body; for a Workplane pass its "
                ".plane."
            )
        planes = SectionSpec(GivenCuts(tuple(map(_frame_of, rows))), half=half)
    curves, reports = planes.curves(shape_surface(bare(body)))
    for text in reports:
        warn(text)
    label = options.get("label")
    called = "strip" if is_one_of(label, (None, "")) else label
    return [
        (section.curve, {**options, "plane": section.frame, "label": f"{called}-{number}"})
        for number, section in enumerate(curves, start=1)
    ]


@lru_cache(maxsize=64)  # enough for a few models
def _strip_and_deviation(spec: "StripSpec") -> tuple[Strip, float]:
    # return the strip, and its largest distance, mm, from the drawn curve
    from elastica_cad.form_finding.nearest_record import NearestRod

    rod = solve_rod(spec.rod_spec)
    return spec.make(rod), rod.deviation if isinstance(rod, NearestRod) else spec.rod_spec.smoothing.moved


def _refuse_unknown(options: Mapping[str, Any], sizes: Sequence[str] = ()) -> None:
    """Refuse options that a strip, or a fixture with `sizes`, does not have.

    For options that are passed in another way, the message states this way.
    """
    from elastica_cad.strip.strip_spec import StripSpec

    names = {"plane", "color", *sizes, *(field.name for field in fields(StripSpec))} - {
        "curve",
        "sheet",
        "frame",
    }
    for name in options:
        if name in GIVEN_OTHERWISE and name not in names:
            raise UnknownOptionError(f"{name} is not an option of a strip. Pass {GIVEN_OTHERWISE[name]}")
    refuse_unknown(options, names, "a fixture" if sizes else "a strip")


def _frame_of(plane: Any) -> Frame:
    """Return the frame of a plane of build123d or CadQuery, whose attributes have different names."""
    if isinstance(plane, Frame):
        return plane
    for names in (("origin", "x_dir", "y_dir"), ("origin", "xDir", "yDir")):
        if all(hasattr(plane, name) for name in names):
            return Frame(*(numbers_of(getattr(plane, name)) for name in names))
    raise InputError(f"plane is {plane!r}. Pass a CAD library's Plane, or a Frame.")


def _is_vector(value: Any) -> bool:
    return hasattr(value, "toTuple") or all(hasattr(value, name) for name in ("X", "Y", "Z", "__iter__"))
