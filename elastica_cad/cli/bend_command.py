"""`elastica bend`: the shape of a strip with moved ends."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad._text import file_word
from elastica_cad._types import FloatArray
from elastica_cad.cli.bow_command import material_and_section
from elastica_cad.cli.element_options import ELEMENTS, LOADS, element_options, elements_of
from elastica_cad.cli.options import (
    LENGTH,
    POINT,
    Chosen,
    Length,
    given_of,
    output_options,
    refuse_idle,
    requested_sheet,
    sheet_options,
    smooth_option,
    typed_options,
)
from elastica_cad.cli.requested_curves import (
    END_NAMES,
    RequestedCurve,
    curve_argument,
    read_curves_with_note,
    requested_curves,
    unit_option,
    which_options,
)
from elastica_cad.cli.settings import BentKeys, parsed_settings, set_option
from elastica_cad.cli.strip_options import spec_from_options, with_settings
from elastica_cad.cli.voice import answer, say, say_rows, voice, wrote
from elastica_cad.design.records import Reader, fields_of
from elastica_cad.design.strip_request import (
    SOLVED,
    FinishedStrip,
    read_bent,
    read_request,
    rod_record,
    strip_record,
)
from elastica_cad.design.tables import Table
from elastica_cad.errors import Energy, Force, InputError, Moment, Point, Strain, note, number_text
from elastica_cad.errors import Length as MmLength
from elastica_cad.form_finding.limits import Limits
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.rod_solution import accepted_rod, solve_rod
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.formats.json_curves import curves_json
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.geometry.plane_points import norm, points_at
from elastica_cad.kit.kit import can_draw
from elastica_cad.mechanics.bending import Leg, path_legs, places_of
from elastica_cad.mechanics.elements import NOUNS, ElementForce, Tie
from elastica_cad.mechanics.loads import (
    Supports,
    require_supports,
)
from elastica_cad.mechanics.mounted_elements import mounted
from elastica_cad.mechanics.newton_continuation import STRAIGHT_RAD
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import Sheet, require_flat
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.model.bows import bow
from elastica_cad.report_rows import Row, printed_table, warning_row
from elastica_cad.strip.held_shape import Reactions
from elastica_cad.strip.own_weight import with_weight
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.summary import SMALLEST_MOVE_MM, between_rows, farthest_move, load_rows
from elastica_cad.strip.travel import Travel, bend_strip


@click.command("bend")
@curve_argument(required=False)
@click.option(
    "--straight",
    type=LENGTH,
    metavar="MM",
    help=("Length of a straight strip of constant width, instead of CURVE."),
)
@which_options
@smooth_option
@click.option(
    "--nearest",
    is_flag=True,
    help=("If no strip can take CURVE, bend the strip of the nearest possible curve."),
)
@unit_option
@sheet_options(required=False, use="Material, for weight and forces")
@click.option(
    "--max-width",
    type=LENGTH,
    metavar="MM",
    help="Largest width; with --sheet it gives forces in newtons, strain and safety.",
)
@click.option(
    "--rod",
    type=Length(positive=True),
    metavar="DIAMETER",
    help="Even round rod instead of a strip; with --sheet, its material, it gives forces in newtons.",
)
@click.option(
    "--even",
    is_flag=True,
    help="Strip of constant width, --max-width, with the length and ends of CURVE instead of its shape.",
)
@set_option(BentKeys)
@click.option("--gravity", is_flag=True, help="Include the weight of the strip (needs --sheet).")
@click.option("--down", type=(float, float), metavar="X Y",
              help="Direction of gravity  [default: 0 -1].")  # fmt: skip
@click.option(
    "--from",
    "start",
    type=POINT,
    metavar="X Y",
    help="New position of the start, in mm of the drawing, y up.",
)
@click.option(
    "--to", "end", type=POINT, metavar="X Y", help="New position of the end, in mm of the drawing, y up."
)
@click.option("--start-angle", type=float, metavar="DEG",
              help="New direction of the strip at its start, counterclockwise from the x axis.")  # fmt: skip
@click.option(
    "--end-angle",
    type=float,
    metavar="DEG",
    help="New direction of the strip at its end, likewise; a full turn of the strip adds 360.",
)
@click.option("--hold-start", type=click.Choice(END_NAMES),
              help="Support of the start  [default: clamped; as in the report; free for --straight and "
                   "--tie; pinned for CURVE with --rod or --even].")  # fmt: skip
@click.option("--hold-end", type=click.Choice(END_NAMES),
              help="Support of the end  [default: clamped; as in the report; free for --straight and "
                   "--tie; pinned for CURVE with --rod or --even].")  # fmt: skip
@click.option("--steps", type=click.IntRange(1, 200), default=1, show_default=True,
              help="Number of shapes between the first and the last position, evenly spaced.")  # fmt: skip
@element_options()
@click.option(
    "--shorten", type=Length(positive=True), metavar="MM", help="Shorten every cord by this length."
)
@click.option("--release", is_flag=True, help="Remove the rails, pins and ties of the strip.")
@click.option(
    "--side",
    type=click.Choice(["left", "right"]),
    help="Side to which a straight strip bulges, seen from start to end.",
)
@output_options
def bend_command(curve: Path | None, **chosen: Any) -> None:
    """Bend a strip to other ends, or load it, and compute its forces.

    CURVE is a drawing, the report of a strip, or a bent strip, NAME-bent.json, whose supports, elements and loads
    stay. Without it, --straight gives the length of a straight strip.

    \b
      elastica bend arch.dxf --to 350 0                        the arch with its ends 50 mm closer
      elastica bend out/arch.json --to 350 0                   the same from the report of `elastica strip`
      elastica bend arch-bent.json --to 340 0 -o next          from the last shape on
      elastica bend --straight 300 --to 200 0 --hold-end pinned --hold-start pinned
      elastica bend --straight 1200 --tie 240 960 --shorten 100 --side left          a batten under a cord

    \b
      elastica bend out/slat.json --point-mass 200 8000        a finished slat under 8 kg: sag, strain, stability
      elastica bend out/wave.json --shorten 5 --steps 5        a strip made with --tie, its cord 5 mm shorter

    \b
      elastica bend --straight 1200 --rod 8 --sheet gfrp-1 --hold-end roller-x --point-mass 600 9     a rod's sag

    \b
      elastica bend --straight 120 --sheet spring-steel-0.5 --max-width 10 --to 60 0 --steps 20   a spring's force

    Writes NAME-bent.csv (points, angle, curvature and stiffness along the strip), NAME-bent.json (the bent strip
    with its supports, elements and loads, and the curves, for `elastica`) and NAME-bent.png. With --sheet and
    --max-width it also writes NAME-travel.csv: forces and moments at the ends, energy, strain, stress and safety
    at every step. NAME-travel.png shows all shapes, if there is more than one step. The strip is then made as in
    `elastica strip`; --set sets its other keys, such as --set style.kind=perforated. A report sets sheet,
    section, widths and supports, and options replace them. --rail, --pin and --tie replace all rails, pins and
    ties of the strip, and --point-force and --point-mass its loads. With one of these loads, the weight of the
    strip acts too. A rail or pin at a point beside the strip, at most 5 % of its length away, moves the strip
    there. With --rod or --even, the strip is the even bow with the length and ends of CURVE, as in `elastica
    bow`.

    The printed table has a line for each shape. travel is the path of the end relative to the start, turn the
    rotation of an end, load the sum of the new loads, and sag the largest movement under them. Forces are those
    of the supports on the ends, along x and y of the drawing, and moments are counterclockwise. strain is the
    largest strain of the surface, safety the strain limit divided by it. start and end deg are the directions of
    the strip at its ends. stability says whether the shape stays when it is touched.
    """
    if (curve is None) == (chosen["straight"] is None):
        raise InputError(
            "The strip is missing. Name a CURVE, or set the length of a straight strip with --straight MM."
        )
    drawn = ("smooth", "nearest", "settings")
    refuse_idle({}, {
        "straight": ("number", "layer", "unit", "even", *drawn), "rod": ("max_width", "thickness", "even", *drawn),
        "even": drawn,
    })  # fmt: skip
    bent = None if curve is None else read_request(curve, "bent")
    strip, rod = _initial_shape(curve, chosen) if bent is None else _bent_shape(bent)
    # the written file has the strip before it was bent, from which later bends start
    designed = bent["strip"] if bent else strip and strip_record(strip)
    if strip is not None and rod.gravity is None and (chosen["gravity"] or elements_of(chosen, LOADS)):
        strip = with_weight(strip, strip.sheet.gravity(chosen["down"] or (0.0, -1.0)))
        rod = strip.rod
    before = rod if strip is None else strip.rod_to_bend
    if chosen["release"] and not rod.between:
        raise InputError(
            "--release has no effect, because the strip has no rails, pins or ties. Leave it out."
        )
    if chosen["side"] is not None and np.ptp(before.angle) > STRAIGHT_RAD:
        raise InputError("--side has no effect, because the strip is not straight. Leave it out.")
    present = rod.supports
    stays = chosen["start"] is None and chosen["end"] is None
    if curve is None and chosen["tie"] and stays:
        # the ends are free, because held ends could not follow the cord
        present = Supports("free", "free")
    supports = require_supports(
        Supports(chosen["hold_start"] or present.start, chosen["hold_end"] or present.end),
        between=not chosen["release"] or bool(elements_of(chosen, ELEMENTS)),
    )
    if curve is not None and supports != rod.supports:
        held = "with both ends clamped" if rod.supports.clamped else "with its ends held otherwise"
        now = ", ".join(
            f"its {end} {chosen[f'hold_{end}']}" for end in ("start", "end") if chosen[f"hold_{end}"]
        )
        say(f"the strip is designed for {curve.name} {held}, and here bent with {now}")
    side = {"left": 1, "right": -1}.get(chosen["side"])
    name = "straight" if curve is None else file_word(curve.stem)
    moved = None
    change = _bend_keywords(before, strip, chosen)
    if chosen["shorten"] is not None and stays:
        both_held = all(end.x and end.y for end in supports.ends)
        for cord in change["between"] if both_held else ():
            # within 1 mm of an end, because users type whole mm
            if isinstance(cord, Tie) and np.allclose((cord.start, cord.end), (0, rod.length), atol=1.0):
                raise InputError(
                    "Both ends of the strip are held, so the cord between them cannot become shorter. "
                    "Add --hold-start free --hold-end free."
                )
    angles = chosen["start_angle"], chosen["end_angle"]
    path = [{
        "start": chosen["start"], "end": chosen["end"], "supports": supports, **change,
        "angles": tuple(None if angle is None else float(np.radians(angle)) for angle in angles),
    }]  # fmt: skip
    if strip is None:
        legs = path_legs(rod, path, side=side)
        shapes = tuple(legs[k].rod(t) for k, t in places_of(legs, chosen["steps"]))
        verdicts = tuple(map(stability, shapes))
    else:
        moved = bend_strip(strip, path, side=side, steps=chosen["steps"])
        legs = [stage.leg for stage in moved.stages]
        shapes, verdicts = moved.rods, moved.verdicts
    states = [verdict.rating for verdict in verdicts]
    columns: dict[str, Any] = _force_columns(moved) if moved is not None else {
        "ends_apart_mm": [norm(shape.chord) for shape in shapes],
        "smallest_radius_mm": [_smallest_radius(shape) for shape in shapes],
    }  # fmt: skip
    start_deg, end_deg = np.degrees([shape.angle[[0, -1]] for shape in shapes]).T
    say(*printed_table(columns | {"start_deg": start_deg, "end_deg": end_deg, "stability": states}))
    if voice().verbose:
        say_rows(Row("Table", " ".join(str(bend_command.help).rpartition("\n\n")[2].split())))
    say_rows(*_rows(rod, legs, shapes, states, moved, change))
    B = 1.0 if strip is None else strip.bending_stiffness
    reports = [_shape_report(*pair, B) for pair in zip(shapes, verdicts, strict=True)]
    answered = {"length": rod.length, "ratio": rod.ratio, "shapes": reports, "travel": None}
    if moved is not None:
        answered |= {"travel": moved.table(), "snaps_at": moved.snaps_at, "strained_at": moved.strained_at,
                     "unit": moved.unit}  # fmt: skip
    answer(answered)
    wrote(
        _write_files(name, rod, shapes, moved, designed, chosen),
        {
            f"{name}-travel.csv": "the table",
            f"{name}-bent.csv": "points",
            f"{name}-bent.json": "the bent strip",
        },
    )


def _initial_shape(curve: Path | None, chosen: Chosen) -> tuple[Strip | None, Rod]:
    """Return the strip, or None without its size, and the rod as they are designed."""
    requested, finished = None, None
    if curve is not None:
        record = read_request(curve)
        # the file is the report of a finished strip
        if record is not None:
            _refuse_curve_options({name for name in ("nearest", "smooth", "rod", "even") if chosen[name]})
        (requested,) = requested_curves(curve, chosen["unit"], chosen["number"], chosen["layer"])
        finished = None if record is None else FinishedStrip.read(record, requested.curve)
    if finished is None:
        needs = dict.fromkeys(("gravity", "thickness", "max_width", "settings"), ("sheet",))
        refuse_idle(needs | {"sheet": ("max_width", "gravity", "settings", "rod")})
    if finished is None or not finished.spec.gravity:
        refuse_idle({"down": ("gravity", *LOADS)})
    settings = parsed_settings(chosen["settings"], BentKeys)
    _refuse_uncompensated(settings, finished)
    if finished is None:
        return _designed(requested, chosen, settings)
    strip = _with_changes(finished, chosen, settings).make()
    return strip, strip.rod


def _bent_shape(record: Any) -> tuple[Strip | None, Rod]:
    """Return the strip, or None, and the rod of an earlier `elastica bend` in their last shape."""
    strip, rod = read_bent(record)
    # gravity can be added only to a strip that is still without weight
    heavy = () if strip is not None and rod.gravity is None else ("gravity", "down")
    typed = typed_options()
    # the first options determine the strip before it is bent
    for name in typed.keys() & {
        "unit", "number", "layer", "smooth", "nearest", "sheet", "thickness", "max_width", "rod", "even",
        "settings", *heavy,
    }:  # fmt: skip
        raise InputError(
            "The strip is already bent, so {option} has no effect. Leave it out, or bend the report of "
            "`elastica strip`.",
            option=typed[name],
        )
    refuse_idle({"down": ("gravity", *LOADS)})
    return strip, rod


def _refuse_uncompensated(settings: Mapping[str, Any], finished: FinishedStrip | None) -> None:
    """Raise InputError for tabs and slots that change neither the shape nor the widths of the strip."""
    if settings.get("compensate", finished is not None and finished.spec.compensate):
        return
    for key in settings.keys() & ({"slots"} if finished is None else {"slots", "ends"}):
        raise InputError(
            "{key} has no effect without {other}. Set {other}, or leave out {key}.",
            key=key, other="compensate",
        )  # fmt: skip


def _refuse_curve_options(idle: set[str]) -> None:
    for name in sorted(idle):
        raise InputError(
            "{name} applies to a drawn CURVE only, not to the finished strip of a report. Leave out {name}.",
            name=name,
        )


def _with_changes(finished: FinishedStrip, chosen: Chosen, settings: dict[str, Any]) -> FinishedStrip:
    spec = finished.spec
    values = given_of(chosen, ("sheet", "thickness", "max_width"))
    if chosen["gravity"] or chosen["down"] is not None:
        values["gravity"] = list(chosen["down"] or (0.0, -1.0))
    table = with_settings(values, settings)
    # the shape of a finished strip is fixed
    _refuse_curve_options(
        set(table) & {*SOLVED, "length", "samples", "between", "supports"} - {"ignore_limits"}
    )
    sheet = Sheet.named(table["sheet"]) if "sheet" in table else spec.material
    if "thickness" in table:
        sheet = sheet.with_thickness(table["thickness"])
    reader, keys = Reader(read_curves=read_curves_with_note, sheet=sheet), Table(table, "", {})
    fields = {
        entry.name: reader.value(entry.kind, keys, entry.name)
        for entry in fields_of(BentKeys)
        if entry.name in table and entry.name not in ("sheet", "thickness")
    }
    if sheet is not spec.material:
        fields["sheet"] = sheet
    return finished.changed(**fields) if fields else finished


def _designed(
    requested: RequestedCurve | None, chosen: Chosen, settings: dict[str, Any]
) -> tuple[Strip | None, Rod]:
    """Return the strip, or None without its size, and the rod: straight, the even bow, or for the curve."""
    # with a material and a size of the section, forces are in newtons
    is_sized = chosen["sheet"] is not None and (settings or given_of(chosen, ("max_width", "rod")))
    down, gravity = chosen["down"] or (0.0, -1.0), None
    if chosen["gravity"] and not is_sized:
        gravity = require_flat(requested_sheet(chosen)).gravity(down)
    if requested is None and not is_sized:
        return None, Rod.straight(chosen["straight"], gravity=gravity)
    if requested is None or chosen["rod"] or chosen["even"]:
        strip = _even_strip(requested, chosen)
        return (strip, strip.rod) if is_sized else (None, replace(strip.rod, gravity=gravity))
    table = given_of(chosen, ("sheet", "thickness", "max_width", "smooth"))
    table |= {"limits": {}} if chosen["nearest"] else {}
    table |= {"gravity": list(down)} if chosen["gravity"] else {}
    table = with_settings(table, settings)
    drawn = requested.curve if "limits" in table else requested.bendable(table.get("smooth"))
    if is_sized:
        spec = spec_from_options(drawn, requested.label, table)
        strip = spec.make(_solve(spec.rod_spec))
        return strip, strip.rod
    limits = Limits() if chosen["nearest"] else None
    return None, accepted_rod(_solve(RodSpec(drawn, gravity, smooth=chosen["smooth"], limits=limits)))


def _even_strip(requested: RequestedCurve | None, chosen: Chosen) -> Strip:
    """Return a straight strip or rod, or the even bow of the curve. Without a size, its diameter is 1 mm."""
    widest = chosen["max_width"]
    size = chosen["rod"] or (None if widest else 1.0)
    sheet, fields = material_and_section(
        {**chosen, "rod": size and (size, size), "max_width": widest, "min_width": widest}
    )
    if requested is not None:
        return bow(requested.curve, sheet, label=requested.label, **fields).strip
    section = fields.pop("section", None) or PlainSection.as_plate(sheet, widest)
    return Strip(Rod.straight(chosen["straight"], section=section), sheet, **fields)


def _solve(spec: RodSpec) -> Rod | NearestRod:
    say(*spec.smoothing.notes)
    result = solve_rod(spec)
    if isinstance(result, NearestRod):
        say(f"the strip is {MmLength(result.deviation):.2g} off the drawn curve at most")
    return result


def _bend_keywords(rod: Rod, strip: Strip | None, chosen: Chosen) -> dict[str, Any]:
    # the keywords `between` and `loads` of `bend`; a missing keyword leaves these elements as they are
    change: dict[str, Any] = {}
    elements = elements_of(chosen, ELEMENTS)
    if elements or chosen["release"]:
        change["between"] = elements
    if chosen["shorten"] is not None:
        actions = mounted(rod, change.get("between"))
        if not any(isinstance(action.element, Tie) for action in actions):
            raise InputError("--shorten needs a cord. Add --tie START END.")
        change["between"] = tuple(_with_shorter_cord(action, chosen["shorten"]) for action in actions)
    if loads := elements_of(chosen, LOADS):
        if strip is None:
            raise InputError(
                "Loads in newtons or grams need a strip with its size. Add --sheet, and --max-width or --rod."
            )
        change["loads"] = loads
    return change


def _with_shorter_cord(action: ElementForce, by: float) -> Any:
    if not isinstance(action.element, Tie):
        return action.element
    start, end = action.s.tolist()
    length = action.mounting.length - by
    if length <= 0:
        raise InputError(
            "The cord from {start} to {end} is {length} long, so it cannot be shortened by {by}. Shorten it less.",
            start=MmLength(start), end=MmLength(end), length=MmLength(round(length + by, 1)), by=MmLength(by),
        )  # fmt: skip
    return replace(action.element, start=start, end=end, length=length)


def _shape_report(shape: Rod, verdict: Stability, bending_stiffness: float) -> dict[str, Any]:
    """Return the report of a shape with all forces on the strip: their sum and the sum of moments are zero.

    Forces are in N, or in 1/mm2 if `bending_stiffness` is 1.
    """
    B, nodes = bending_stiffness, shape.position
    (start, end), moment, load = B * shape.support_forces, B * shape.moment, norm(B * shape.nodal_load)
    masses = [_force_report(mass, B, points_at(mass.s, shape.s, nodes)) for mass in shape.hung]
    hung = np.array([norm(mass["force"][0]) for mass in masses])
    # the nodal load includes the hung masses; without them, it is the weight of the strip, N
    own = load.sum() - hung.sum()
    center = load @ nodes - sum(size * mass["points"][0] for size, mass in zip(hung, masses, strict=True))
    return {
        "start": nodes[0], "end": nodes[-1], "angles": shape.angle[[0, -1]],
        "size": np.ptp(nodes, axis=0), "largest_curvature": np.abs(shape.curvature).max(),
        "stable": verdict.stable, "margin": verdict.margin,
        "between": [_force_report(action, B, action.points_on(nodes, shape.length)) for action in shape.acting],
        "masses": masses,
        "weight": None if shape.gravity is None else {
            "force": own * np.array(shape.gravity.direction), "center": center / own,
        },
        "reactions": Reactions(start, -moment[0], end, moment[-1]),
    }  # fmt: skip


def _force_report(action: ElementForce, bending_stiffness: float, points: FloatArray) -> dict[str, Any]:
    force = bending_stiffness * action.force
    return {"kind": NOUNS[type(action.element)], "at": action.s, "points": points, "force": force}


def _rows(
    rod: Rod,
    legs: Sequence[Leg],
    shapes: Sequence[Rod],
    states: Sequence[str],
    moved: Travel | None,
    change: dict[str, Any],
) -> Iterator[Row]:
    # `legs` are the stages, `shapes` the rods at all steps, `states` their stability, `moved` the travel of a
    # strip with a size, and `change` is the result of `_bend_keywords`
    last = shapes[-1]
    ratio = f"The largest stiffness of the strip is {rod.ratio:.4g} times the least."
    yield Row("Size", f"{rod.length:.1f} mm long", [ratio])
    width, height = np.ptp(last.position, axis=0)
    which = "last shape " if shapes[1:] else ""
    radius = _smallest_radius(last)
    if radius != "straight":
        radius = f"smallest radius {radius} mm"
    yield Row("Shape", f"{which}{width:.1f} x {height:.1f} mm, {radius}")
    (x0, y0), (x1, y1) = np.round(last.position[[0, -1]], 2) + 0.0
    yield Row("Ends", f"from ({x0:.2f}, {y0:.2f}) to ({x1:.2f}, {y1:.2f}) mm in the drawing")
    if moved is not None and (last.acting or change):
        yield from load_rows(last)
        yield _displacement_row(moved, released=change.get("between") == ())
        yield from between_rows(last, moved.strip.bending_stiffness)
        worst = moved.safety.argmin()
        safety = number_text(moved.safety[worst])
        yield Row("Strain", f"at most {Strain(moved.strain[worst])}, safety {safety}")
    yield _stability_row(states, legs, moved)
    texts: list[str] = [] if moved is not None else [text for leg in legs for text in leg.warnings]
    if any(leg.together for leg in legs):
        texts.append(
            note("the loads grow while the ends move, because the strip does not stand without them")
        )
    texts += [text for action in last.between for text in _warnings_on_side(action, rod, last)]
    stretch = float(norm(np.diff(last.position, axis=0)).sum()) - last.length
    if stretch > 1e-4 * last.length:  # more than rounding errors
        texts.append(note(
            "The strip is stretched by {stretch:.2g} between its ends, because they cannot approach each other. "
            "Let an end slide, with --hold-end slide-x.",
            stretch=MmLength(stretch),
        ))  # fmt: skip
    yield from map(warning_row, dict.fromkeys(texts))
    if moved is None:
        return
    largest = f"{Force(moved.support_force.max())} and {Moment(moved.support_moment.max())}"
    yield Row("Force", f"at most {largest} at an end; the strip stores {Energy(moved.energy.max())}")
    if tips := [k for k, verdict in enumerate(moved.sideways) if verdict.needs_guiding]:
        k = min(tips, key=lambda k: moved.sideways[k].overloaded)
        where = f"at {moved.words(moved.places[k])}, " if shapes[1:] else ""
        yield warning_row(f"{where}{moved.sideways[k].meaning}", "Stability")
    yield from map(warning_row, moved.warnings)


def _warnings_on_side(action: ElementForce, rod: Rod, shape: Rod) -> Iterator[str]:
    """Yield a warning if a rail pushes a straight strip down, because the rail's point is below the strip."""
    at, direction = getattr(action.element, "at", None), action.bar_direction(shape.curve)
    straight = rod.shape is None and np.ptp(rod.angle) <= STRAIGHT_RAD
    if (
        straight
        and isinstance(at, tuple)
        and direction is not None
        and shape.gravity is not None
        and direction @ shape.gravity.direction < 0
    ):
        yield note(
            "The rail at {point} is on top of the strip and pushes it down to this point, which is below the "
            "straight strip. To put a rail under the strip, with a gap between them, draw the straight line, run "
            "{command}, and run `elastica bend` on the report.",
            point=Point(at), command=f"`elastica strip LINE.svg --rail {action.s[0]:.0f}`",
        )  # fmt: skip


def _displacement_row(moved: Travel, *, released: bool) -> Row:
    """Return the row on the movement: the sag under the new loads, and the distance from the design."""
    last, stage = moved.rods[-1], moved.stages[-1]
    design = moved.strip.rod
    distance, at, direction = farthest_move(design, last)
    strip = "without rails, pins and ties, the strip" if released else "the strip"
    if distance < SMALLEST_MOVE_MM:
        return Row("Movement", f"{strip} stays within {SMALLEST_MOVE_MM:g} mm of its design")
    far = f"{MmLength(distance):.2g} from its design"
    where = f"the point {at:.0f} mm along the strip, {direction}"
    if stage.unit != "N":
        return Row("Movement", f"{strip} moves by at most {far}: {where}")
    # the last stage adds the loads, and the sag is the movement since its start
    sag, at, direction = farthest_move(stage.leg.rod(0.0), last)
    sags = (
        f"{strip} sags by at most {MmLength(sag):.2g} under the load: the point {at:.0f} mm along the strip"
    )
    return Row("Movement", f"{sags}, {direction}; it is at most {far}")


def _force_columns(moved: Travel) -> dict[str, Any]:
    # columns (n,) of the printed table; each name ends with its unit
    size = moved.support_force[:, None]
    start, end = (
        np.where(np.abs(force) <= 1e-9 * size, 0.0, force) for force in (moved.start_force, moved.end_force)
    )
    # without loads, rails, pins and ties, the start has the opposite force of the end, and no columns
    differs = bool((np.abs(start + end) > 1e-3 * size).any())
    units = {stage.unit for stage in moved.stages}
    columns = {
        "travel_mm": moved.travel if "mm" in units else None,
        "turn_deg": np.degrees(moved.turn) if "deg" in units - {"mm"} else None,
        "change_applied_percent": moved.path_length if units == {"%"} else None,
        "load_N": moved.load if "N" in units else None,
        "sag_mm": moved.sag if moved.unit == "N" else None,
        "start_force_x_N": start[:, 0] if differs else None,
        "start_force_y_N": start[:, 1] if differs else None,
        "end_force_x_N": end[:, 0], "end_force_y_N": end[:, 1],
        "start_moment_Nmm": moved.start_moment, "end_moment_Nmm": moved.end_moment,
        "strain_percent": 100 * moved.strain, "safety": moved.safety,
    }  # fmt: skip
    return {name: values for name, values in columns.items() if values is not None}


def _smallest_radius(shape: Rod) -> str:
    kappa = float(np.abs(shape.curvature).max())
    return number_text(1 / kappa, ".4g") if kappa * shape.length > 1e-6 else "straight"


def _stability_row(states: Sequence[str], legs: Sequence[Leg], moved: Travel | None) -> Row:
    # first step that is not stable
    step = next((k for k, state in enumerate(states) if state != "stable"), None)
    if step is None:
        sideways = {side.word for side in moved.sideways} if moved is not None else set()
        every = " at every step" if states[1:] else ""
        undecided = "; sideways undecided" if "undecided" in sideways else ""
        text = f"stable in its plane{every}{undecided}"
        if any(leg.path.leaps for leg in legs):
            last = "last " if states[1:] else ""
            return warning_row(f"snaps on the way; the {last}shape is {text}", "Stability")
        if sideways == {"ample"}:
            text = f"stable{every}: the strip neither snaps into another shape nor tips over sideways"
        return Row("Stability", text)
    place = f"step {step + 1} of {len(states)}" if moved is None else moved.words(moved.places[step])
    where = f" from {place} on" if states[1:] else ""
    return warning_row(f"{states[step]}{where}", "Stability")


def _write_files(
    name: str, rod: Rod, shapes: Sequence[Rod], moved: Travel | None, designed: Any, chosen: Chosen
) -> tuple[Path, ...]:
    # `designed` is the record of the strip before it was bent
    bent = {"strip": designed, "rod": rod_record(shapes[-1])}
    files = [
        File(f"{name}-bent.csv", partial(_write_shapes, shapes)),
        text_file(f"{name}-bent.json", curves_json([shape.curve for shape in shapes], bent=bent)),
    ]
    if can_draw():
        from elastica_cad.plot.canvas import save_figure
        from elastica_cad.plot.strip_pictures import rod as draw_rod
        from elastica_cad.plot.strip_pictures import travel as draw_travel

        # a straight strip has no drawn shape to compare with
        design = None if rod.shape is None else rod
        files.append(
            File(f"{name}-bent.png", lambda path: save_figure(draw_rod(shapes[-1], design=design), path))
        )
    if moved is not None:
        files.append(text_file(f"{name}-travel.csv", moved.csv()))
        if can_draw() and shapes[1:]:
            files.append(File(f"{name}-travel.png", lambda path: save_figure(draw_travel(moved), path)))
    return write_files(files, chosen["output"], force=chosen["force"])


def _write_shapes(shapes: Sequence[Rod], path: Path) -> None:
    header = "shape,s_mm,x_mm,y_mm,angle_rad,curvature_1_per_mm,stiffness"
    rows = [
        np.column_stack([np.full(r.s.size, k), r.s, r.position, r.angle, r.curvature, r.stiffness])
        for k, r in enumerate(shapes, start=1)
    ]
    formats = ["%d", *["%.6f"] * 4, "%.9g", "%.6f"]
    np.savetxt(path, np.concatenate(rows), formats, ",", header=header, comments="")
