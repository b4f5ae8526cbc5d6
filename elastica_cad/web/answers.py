"""Answers to the requests of the page: JSON records, and the files to download."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path as FilePath
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from elastica_cad._text import file_word
from elastica_cad._types import FloatArray
from elastica_cad._values import SEEN_APART, counted
from elastica_cad.design.design_file import Design, design_of, parse_design
from elastica_cad.design.pair_table import cutting_of, pair_of
from elastica_cad.design.strip_table import scaled_places
from elastica_cad.design.tables import with_present_keys
from elastica_cad.errors import Change, ElasticaError, InputError, Refusal, StrainError, note
from elastica_cad.files import CURVE_FORMATS, read_curves
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.formats.source_file import read_below
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_about,
    homogeneous,
    norm,
    project,
    unit_vectors,
)
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit, pack_files
from elastica_cad.kit.pair_kit import MadePair
from elastica_cad.kit.strip_kit import StripFiles, StripResult
from elastica_cad.mechanics.elements import NOUNS, PlacedElement, PointForce, Rail
from elastica_cad.mechanics.loads import PointMass, Weight
from elastica_cad.mechanics.point_search import ALL_DIRECTIONS, move_while_possible
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import judge_strain
from elastica_cad.mechanics.sheets import Sheet, cut_sheets
from elastica_cad.mechanics.stability import SAFE_MARGIN
from elastica_cad.mechanics.thrust_line import inflections_of, thrust_sides
from elastica_cad.mechanics.trials import not_tried
from elastica_cad.model.assembly import single_holders
from elastica_cad.model.fixtures import EndFixture
from elastica_cad.pairs.flexure import STATES
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.pairs.summary import pair_rows
from elastica_cad.report_rows import Row, in_order, warning_row
from elastica_cad.strip.drawing import LAYERS, Drawing
from elastica_cad.strip.lettering import text_strokes
from elastica_cad.strip.strip import Placed, Strip
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.styles import Bends, Plain
from elastica_cad.strip.suggestions import Suggestion, instruction, suggest, try_change
from elastica_cad.strip.summary import stability_row, strain_rows, strip_rows
from elastica_cad.strip.travel import bend_strip
from elastica_cad.translations import Language
from elastica_cad.web.saved_design import (
    OF_MODELS,
    compose_design,
    curve_table,
    drawable,
    file_mark,
    idle_beside,
    open_design,
    without_idle,
    without_keys,
    without_models,
)

Record = dict[str, Any]

LEAST_STEP = 1e-3
"""Least tolerance, mm, of the search for the last position to which a point can be dragged."""

DIRECTIONS = 2
"""Largest number of directions in which one answer tries to move a blocked control point."""

HALVINGS = 2
"""Largest number of bisection steps of one answer in the search for a possible position."""

PLACE_DIGITS = 6
"""Decimals of a position along the curve, mm. With fewer decimals, a rounded end could be beyond the curve."""

DRAWN_NODES = 160
"""Largest number of nodes of a strip that are sent. More nodes could not be seen on a screen."""

CHORD_MM = 0.05
"""Largest distance, mm, between the cut outline and the lines on the screen."""

DROPPED = (*(suffix for kind in CURVE_FORMATS if kind.is_text for suffix in kind.suffixes), ".toml")
"""Files that may be dropped on the page, by suffix."""

CATALOGUES: dict[str, Language] = {"de": "de", "zh": "zh-CN"}
"""Catalogue of translations for each language of the page, except English."""

DOWNLOADS = ("dxf", "svg", "pdf", "step", "stl", "kit")
"""Files that can be downloaded, in addition to the design."""

FILE_KEYS = ("file", "mesh", "sheets_file", "curve", *STATES)
"""Keys of a design whose value may be the name of a file."""

REMOVED = {"nearest": ("limits", "keep"), "elements": ("between", "loads")}
"""Keys that the page offers to remove if settings of a design conflict, by the field of the suggested change."""

CHANGED = "{name} was changed since this page read it"

BENT_STEPS, PRESSED_STEPS = 32, 12
"""Number of shapes from the flat strip to the design, and from the design to ends pressed closer together."""

NEARLY_FLAT = 0.9999
"""Distance between the ends of the flattest shape that the page shows, as a fraction of the strip's length. A
straighter strip could bend to either side."""

PRESSED_FRACTION = 0.4
"""Largest reduction of the distance between the ends, as a fraction of this distance."""


@dataclass(frozen=True)
class Download:
    """A file that the user can download."""

    name: str
    content: bytes


def answer(request: Mapping[str, Any], saved: FilePath | None = None) -> Record | Download:
    """Return the answer to a request. After an error, the answer has a record "refused".

    Parameters
    ----------
    request : mapping
        Request of the page.
    saved : Path, optional
        The design file of the studio.
    """
    answering = QUESTIONS.get(str(request.get("do")))
    if answering is None:
        raise InputError("The page sent an unknown request. Load the page again.")
    design = request.get("design")
    if design is not None and not isinstance(design, Mapping):
        raise InputError("The design is not a table of keys and values. Load the page again.")
    try:
        if answering in OF_THE_FILE:
            return answering(request, saved)
        _refuse_files(design)
        if answering not in WITH_FILES:
            return answering(request)
        with TemporaryDirectory(prefix="elastica-studio-") as folder, read_below(folder):
            return answering(request, FilePath(folder))
    except ElasticaError as problem:
        return refused(problem)


def refused(problem: ElasticaError) -> Record:
    """Return the record of an error, whose message is translated later."""
    return {"refused": problem.refusal.record | {"message": problem.refusal}}


def _refuse_files(value: object, key: str = "") -> None:
    """Raise InputError for names of files, because the page reads only files dropped on it."""
    if isinstance(value, Mapping):
        for name, item in value.items():
            _refuse_files(item, str(name))
    elif isinstance(value, list):
        for item in value:
            _refuse_files(item, key)
    elif isinstance(value, str) and (key in FILE_KEYS or ".toml" in value):
        raise InputError(
            "The page cannot open a file by its name. Drop {given!r} on the drawing.", given=value
        )


def _no_file(path: FilePath, **_: Any) -> list[PlaneCurve]:
    raise InputError("The page cannot open a file by its name. Drop {name} on the drawing.", name=path.name)


def _design(tables: Mapping[str, Any]) -> Design:
    return design_of(without_idle(with_present_keys(tables)), FilePath("design"), _no_file)


def requested_spec(design: Mapping[str, Any], k: object = 0) -> StripSpec:
    """Return the `StripSpec` of the strip with index `k` in a design."""
    strips = design.get("strips")
    if not isinstance(strips, list) or not isinstance(k, int) or not 0 <= k < len(strips):
        raise InputError("The design has no strip. Add a strip.")
    try:
        return _design(without_models(design) | {"strips": [strips[k]]}).entries[0].spec
    except InputError as problem:
        # remove the name of the strip, which the page shows itself
        while {"place", "why"} == set(problem.refusal.values):
            problem.refusal = problem.refusal.values["why"]
        raise


def _spec(request: Mapping[str, Any]) -> StripSpec:
    return requested_spec(request["design"], request.get("strip", 0))


def _strip_table(request: Mapping[str, Any]) -> Record:
    # the table in [[strips]] of the strip that the page shows
    table: Record = request["design"]["strips"][request.get("strip", 0)]
    return table


def _strip_or_pair(request: Mapping[str, Any]) -> Record:
    """Return the strip, or the part with two states, and the keys that have no effect on it."""
    answered = _pair(request) if "pair" in request["design"] else _bent_strip(request)
    with suppress(ElasticaError, LookupError, TypeError):
        answered["idle"] = [
            *answered.get("idle", ()), *idle_beside(request["design"], request.get("strip", 0)),
        ]  # fmt: skip
    return answered


def _bent_strip(request: Mapping[str, Any]) -> Record:
    """Return the strip. With `hold`, a dragged control point stops at its last possible position."""
    try:
        spec, scaled = _scaled_request(request)
    except ElasticaError as problem:
        return _bare_curve(request) | refused(problem)
    if "hold" in request:
        possible = _solve_if_possible(spec, request["hold"])
        if possible is None:
            return _strip_of_drag(request)
        return _strip_record(spec, scaled, *possible, live=True)
    try:
        rod = solve_rod(spec.rod_spec)
        strip = spec.make(rod)
    except ElasticaError as problem:
        curve, at = spec.rod_spec.curve_to_bend, problem.refusal.where.get("at")
        places = [] if at is None else _rounded(curve.at([np.clip(at, 0, curve.length)]).position, 3)
        refusal = {"elements": _elements(spec), "places": places} | _drawn_points(spec) | refused(problem)
        return _check_record(spec, scaled) | refusal
    return _strip_record(spec, scaled, rod, strip, live=bool(request.get("live")))


def _bare_curve(request: Mapping[str, Any]) -> Record:
    """Return the drawn curve of a strip with invalid options. If the curve is invalid too, return {}."""
    with suppress(LookupError, TypeError):
        return _drawn_table(_strip_table(request)["curve"])
    return {}


def _drawn_table(curve: object) -> Record:
    # points of a curve table, drawn for any strip, because a request needs a sheet and a width
    with suppress(ElasticaError, LookupError, TypeError):
        strip = {"curve": curve, "max_width": 10.0}
        return _drawn_points(requested_spec({"schema": 1, "sheet": "birch-plywood-0.8", "strips": [strip]}))
    return {}


def _check_record(spec: StripSpec, scaled: Record) -> Record:
    """Return the drawn curve and, if all rails, pins and ties are on the curve, the check of the curve."""
    curve = spec.rod_spec.drawn or spec.rod_spec.curve
    path = {"points": _rounded(curve.sample(DRAWN_NODES + 1).position, 3), "length": curve.length}
    record: Record = {"path": path, "kept": scaled}
    with suppress(InputError):
        check = spec.rod_spec.check

        def places(s: Sequence[float]) -> list[Any]:
            return _rounded(check.curve.at(s).position, 3) if len(s) else []

        line = check.line
        record |= {
            "theorem": {
                "inflections": places(check.inflections),
                "at": _rounded(check.inflections, 2),
                "line": None if line is None else [line.point, line.direction],
                "off": [] if check.realizable else places([s for s, _ in check.off_line]),
                "crossings": places(
                    (*check.crossings, *check.touches, *check.curvature_touches, *check.jumps)
                ),
            },
            "text": str(check),
        }
    return record


def _strip_record(
    spec: StripSpec, scaled: Record, rod: Rod | NearestRod, strip: Strip, *, live: bool
) -> Record:
    """Return the answer on a strip: its shape, flat pattern and report.

    While a point is dragged (`live`), slow rows are left out.
    """
    record = _check_record(spec, scaled)
    # the thrust line ends at a box that is larger than the strip by its size on every side
    low, high = box_about(strip.rod.position)
    size = max(high - low)
    record |= {
        "elements": _elements(spec, strip),
        "thrust": [_rounded(side, 3) for side in thrust_sides(strip.rod, low - size, high + size)],
    }
    near = rod if isinstance(rod, NearestRod) else None
    if near is not None:
        record["theorem"] = _inflections(strip.rod)
    record |= _stations(strip) | {
        "flat": _flat_loops(strip.drawings()),
        "length": round(strip.rod.length, 2),
        "deviation": None if near is None else round(near.deviation, 3),
        "rows": _rows(strip_rows(strip, near, quick=live)),
    }
    return record | (_drawn_points(spec) if spec.may_change else {})


def _strip_of_drag(request: Mapping[str, Any]) -> Record:
    """Return the strip for the last possible position of a dragged control point.

    `request["hold"]` has the indices of the points that move together, their last possible positions `from`,
    and the tolerance `step`, mm. Its key `turn` is the index of the first direction to try. If the points
    cannot move, the answer has the positions `from`. If more directions are left, the answer has the next
    `turn`.
    """
    hold, design, strip = request["hold"], request["design"], _strip_table(request)
    curve, indices = strip["curve"], hold["point"]

    def record_with(place: FloatArray) -> Callable[[], Record] | None:
        """Return a function that computes the record for the dragged points at `place`, or None."""
        places = place.round(PLACE_DIGITS).tolist()
        moved = dict(zip(indices, places, strict=True))
        spline = [moved.get(i, point) for i, point in enumerate(curve["spline"])]
        moved_design = design | {"strips": [strip | {"curve": curve | {"spline": spline}}]}
        with suppress(ElasticaError):
            spec, scaled = _scaled_request({**request, "design": moved_design, "strip": 0})
            if (solved := _solve_if_possible(spec, hold)) is not None:
                return lambda: _strip_record(spec, scaled, *solved, live=True) | {"point": places}
        return None

    wanted = [curve["spline"][i] for i in indices]
    start, end = (np.array(xy, dtype=float) for xy in (hold["from"], wanted))
    step, turn = max(float(hold["step"]), LEAST_STEP), int(hold.get("turn", 0))
    record_at = move_while_possible(start, end, record_with, step, HALVINGS, slice(turn, turn + DIRECTIONS))
    if record_at is not None:
        return record_at()
    turn += DIRECTIONS
    return {"point": hold["from"]} | ({"turn": turn} if turn < ALL_DIRECTIONS.stop else {})


def _solve_if_possible(spec: StripSpec, hold: Mapping[str, Any]) -> tuple[Rod | NearestRod, Strip] | None:
    """Return the rod and the strip, or None if the strip is impossible. The reason is not computed.

    A strip narrower than the workshop can cut is impossible. With `hold["strain"]`, a strip above the strain limit
    of its sheet is impossible too.
    """
    with suppress(ElasticaError):
        if _curve_breaks_strip(spec):
            return None
        rod = solve_rod(spec.rod_spec)
        solid = isinstance(spec.style, Plain) and spec.section is None
        if solid and isinstance(rod, Rod) and not (spec.compensate or spec.ignore_limits):
            narrowest = spec.bend(rod).width.extremes[0]
            if narrowest < (1 - SEEN_APART) * spec.shop.width_for(spec.material):
                return None
        strip = spec.make(rod)
        if strip.strain_verdict.allowed or not hold.get("strain"):
            return rod, strip
    return None


def _curve_breaks_strip(spec: StripSpec) -> bool:
    """Return True if the drawn curve alone shows that the strip would break, without a rod."""
    bends = spec.smooth or spec.natural_curvature or spec.loads or spec.gravity is not None
    if spec.may_change or spec.ignore_limits or bends or not isinstance(spec.style, Plain):
        return False
    sharpest = float(np.abs(spec.curve.survey.curvature).max())
    return judge_strain(spec.material, sharpest * spec.material.thickness / 2).refused


def _scaled_request(request: Mapping[str, Any]) -> tuple[StripSpec, Record]:
    """Return the `StripSpec`, with positions of ties and loads scaled with the curve, and the scaled lists by key.

    The page sends the previous length (mm) of an edited curve, to which the positions refer.
    """
    design, before = request["design"], request.get("length")
    spec = _spec(request)
    after = (spec.rod_spec.drawn or spec.rod_spec.curve).length
    if not isinstance(before, int | float) or not before > 0 or before == after:
        return spec, {}
    strip = _strip_table(request)
    tables = {key: strip.get(key, design.get(key)) for key in ("between", "loads")}
    scaled = scaled_places(tables, after / before)
    return requested_spec(design | {"strips": [strip | scaled]}), scaled


def _elements(spec: StripSpec, strip: Strip | None = None) -> list[Record]:
    """Return rails, pins, ties and loads with their positions and, if known, forces in N."""
    curve = spec.rod_spec.curve_to_bend
    drawn_curve = spec.rod_spec.drawn or spec.rod_spec.curve
    loads = () if isinstance(spec.loads, Weight) else spec.loads
    # forces (2,), N, on the strip, by the id of the record
    forces = {id(load): np.array(load.force) for load in loads if isinstance(load, PointForce)}
    if strip is not None:
        forces |= {
            id(action.element): strip.bending_stiffness * action.force[0] for action in strip.rod.between
        }
    elements: list[Record] = []
    for key, records in (("between", spec.between), ("loads", loads)):
        for k, record in enumerate(records):
            mass = record.mass if isinstance(record, PointMass) else None
            # only elements have places, so a mass is placed as a force
            element = PointForce(record.at, (0, 0)) if isinstance(record, PointMass) else record
            with suppress(InputError):  # the check reports a position off the curve
                places = curve.at(PlacedElement.on(element, drawn_curve, curve).s).position
                force = forces.get(id(record))
                elements.append({
                    "key": key, "index": k, "noun": NOUNS[type(element)] if mass is None else "point mass",
                    "places": _rounded(places, 3), "force": None if force is None else _rounded(force, 6),
                    "mass": mass, "slot": isinstance(element, Rail) and not element.one_sided,
                })  # fmt: skip
    return elements


def _drawn_points(spec: StripSpec) -> Record:
    return {"drawn": _rounded(spec.curve.sample(DRAWN_NODES + 1).position, 3)}


def _inflections(rod: Rod) -> Record:
    """Return the inflections of a rod, not of the drawn curve, and the line through them."""
    points = inflections_of(rod)
    s = [rod.s[norm(rod.position - point).argmin()] for point in points]
    line = None if rod.acting or rod.gravity is not None or not len(points) else rod.thrust_line[0]
    return {
        "inflections": _rounded(points, 3),
        "at": _rounded(s, 2),
        "line": None if line is None else [line.point, line.direction],
        "off": [],
        "crossings": [],
    }


def _stations(strip: Strip) -> Record:
    """Return positions and widths along the strip with its tabs, and curvatures and strains without them.

    `shares` are the strains as fractions of their limits.
    """
    rod = strip.rod
    k = np.unique(np.linspace(0, rod.s.size - 1, DRAWN_NODES + 1).round().astype(int))
    s, kappa = rod.s[k], rod.curvature[k]
    rest = np.broadcast_to(rod.natural_curvature, rod.s.shape)[k]
    layers = strip.layout.strains(Bends(np.abs(kappa - rest), s))
    fraction = np.max([layer.strain / layer.limit for layer in layers], axis=0)
    position, width = rod.position[k], strip.width(s)
    along = unit_vectors(rod.angle[k])
    first, last = strip.ends
    ends = [position[:1] - first.length * along[:1], position, position[-1:] + last.length * along[-1:]]
    wide = [first.width or width[0], *width, last.width or width[-1]]
    return {
        "position": _rounded(np.concatenate(ends), 3),
        "width": _rounded(wide, 3),
        "curvature": _rounded(kappa, 6),
        "shares": _rounded(fraction, 3),
    }


def _rows(rows: Iterable[Row]) -> list[Record]:
    return [
        {"label": row.label, "text": row.text, "details": list(row.details), "stops": row.stops}
        for row in rows
    ]


def _flat_loops(drawings: Iterable[Drawing]) -> list[Record]:
    """Return the lines of drawings by layer, one drawing below the other."""
    layers: list[Record] = []
    below = 0.0
    for drawing in drawings:
        paths = [(item.layer, item.path) for item in drawing.paths]
        paths += [(text.layer, stroke) for text in drawing.texts for stroke in text_strokes(text)]
        lines = [(layer, path.closed_points(CHORD_MM)) for layer, path in paths]
        heights = np.concatenate([points[:, 1] for _, points in lines])
        shift = np.array([0.0, below - heights.max()])
        for layer in LAYERS:
            loops = [_rounded(points + shift, 2) for name, points in lines if name == layer]
            layers += [{"layer": layer, "loops": loops}] if loops else []
        below -= 1.1 * np.ptp(heights)
    return layers


def _suggestions(request: Mapping[str, Any]) -> Record:
    """Return tested changes of a request that is refused; none if the strip can be made."""
    try:
        spec = _spec(request)
    except ElasticaError as problem:
        return {"cures": list(_removals(request, problem.refusal.changes))}
    try:
        spec.make()
    except ElasticaError as problem:
        changes = [
            {
                "text": suggestion.title,
                "effect": suggestion.effect,
                "strips": _changed_strips(request, suggestion),
            }
            for suggestion in suggest(spec, problem, sheet_size=_sheet_size_of_model(request["design"]))
        ]
        return {"cures": changes, "reason": not_tried(spec.curve)}
    return {"cures": []}


def _removals(request: Mapping[str, Any], changes: Iterable[Change]) -> Iterator[Record]:
    """Yield changes that each remove one of two conflicting settings."""
    design = request["design"]
    for change in changes:
        if change.field == "nearest_curve":
            yield from _support_of_nearest(request, change)
        removed = REMOVED.get(change.field, ())
        rest, kept = (without_keys(table, removed) for table in (design, _strip_table(request)))
        try:
            spec = requested_spec(rest | {"strips": [kept]})
        except ElasticaError:
            continue
        effect = note("then the strip needs another change")
        with suppress(ElasticaError):
            rod = solve_rod(spec.rod_spec)
            strip = spec.make(rod)
            deviation = rod.deviation if isinstance(rod, NearestRod) else 0.0
            effect = Suggestion(change, (spec,), deviation, strip.strain_verdict.percent, (strip,)).effect
        yield {"text": instruction(change), "effect": effect, "removed": list(removed)}


def _support_of_nearest(request: Mapping[str, Any], change: Change) -> Iterator[Record]:
    """Yield the change that draws the nearest curve and keeps the rails, pins, ties and loads, if it works."""
    strip = _strip_table(request)
    limited, without = (without_keys(table, REMOVED["elements"]) for table in (request["design"], strip))
    spec = requested_spec(limited | {"strips": [without]})
    if suggestion := try_change(spec, change):
        (drawn,) = suggestion.requests
        yield {
            "text": suggestion.title,
            "effect": suggestion.effect,
            "strips": [strip | {"curve": curve_table(drawn.curve)}],
            "removed": list(REMOVED["nearest"]),
        }


def _sheet_size_of_model(design: Mapping[str, Any]) -> tuple[float, float] | None:
    """Return the sides of a model's sheets, mm, or None for a strip alone."""
    if len(design["strips"]) == 1 and design.keys().isdisjoint({"nest", *OF_MODELS}):
        return None
    return _design(without_models(design)).kit.nesting.sheet_size


def _changed_strips(request: Mapping[str, Any], suggestion: Suggestion) -> list[Record]:
    """Return the tables of the strips after a suggested change: several for a split curve."""
    design, strip, change = request["design"], _strip_table(request), suggestion.change
    if suggestion.width is not None:
        strip = strip | {"max_width": suggestion.width.value}
    match change.field:
        case "point" | "size" | "split_corners":
            tables = [strip | {"curve": curve_table(request.curve)} for request in suggestion.requests]
            return [tables[0], *(without_keys(table, ("label",)) for table in tables[1:])]
        case "nearest":
            return [strip | {"limits": {"margin": SAFE_MARGIN}}]
        case "lap":
            return [strip | {"shop": strip.get("shop", design.get("shop", {})) | {"lap": change.value}}]
        case "between":
            return [strip | {"between": [*strip.get("between", design.get("between", [])), suggestion.table]}]
        case "sheet" if "thickness" in {**design, **strip}:
            return [strip | {"sheet": change.value, "thickness": Sheet.named(change.value).thickness}]
    return [strip | {change.field: suggestion.table}]


def _sheet_rows(request: Mapping[str, Any]) -> Record:
    """Try the named sheets, or all. The rod is computed again only if the rod depends on the sheet."""
    spec, names, solved, rows = _spec(request), request.get("names"), None, []
    for sheet in cut_sheets():
        if names is not None and sheet.name not in names:
            continue
        row: Record = {"name": sheet.name, "fits": False, "kind": "strain"}
        rows.append(row)
        changed = spec.changed(sheet=sheet)
        try:
            if changed.rod_spec != solved:
                rod = solve_rod(changed.rod_spec)
                solved = changed.rod_spec
            strip = changed.make(rod)
        except StrainError as problem:
            row["used"] = problem.refusal.values["percent"] / 100
            continue
        except ElasticaError as problem:
            row |= {"text": problem.refusal, "kind": problem.refusal.kind}
            continue
        verdict = strip.strain_verdict
        row |= {
            "used": round(verdict.used, 3), "mass": float(f"{strip.mass:.4g}"), "fits": verdict.allowed,
        }  # fmt: skip
    return {"sheets": rows}


def _bending_frames(request: Mapping[str, Any]) -> Record:
    """Return the shapes for the page's slider: from nearly flat (part 0) over the design (1) to pressed ends.

    Beyond the design, part - 1 is the reduction of the distance of the ends, as a fraction.
    """
    strip = _spec(request).make()
    if strip.rod.acting:
        raise InputError(
            "The slider cannot bend a strip with rails, pins, ties or point forces. Remove these elements "
            "first."
        )
    start, end, chord = strip.rod.position[0], strip.rod.position[-1], strip.rod.chord
    if not chord.any():
        raise InputError("A closed strip has no ends to move. Open the strip to bend it here.")
    out = angle_of(chord)
    flat = start + NEARLY_FLAT * strip.rod.length * unit_vectors(out)
    # direction of the chord, with the full turns of the end angles
    level = out + 2 * np.pi * np.round((strip.rod.angle[[0, -1]].mean() - out) / (2 * np.pi))
    level_ends = [level if support.angle else None for support in strip.rod.supports.ends]
    pulled = bend_strip(strip, [{"end": flat, "angles": level_ends}], steps=BENT_STEPS)
    parts = np.arange(BENT_STEPS + 1) / BENT_STEPS
    frames = [_frame(strip, pulled, k, 1 - part) for k, part in enumerate(parts)][::-1]
    # if the strip cannot be pressed further, show only the shapes up to the design
    with suppress(ElasticaError):
        pressed = bend_strip(strip, [{"end": end - PRESSED_FRACTION * chord}], steps=PRESSED_STEPS)
        frames += [
            _frame(strip, pressed, k, 1 + PRESSED_FRACTION * k / PRESSED_STEPS)
            for k in range(1, PRESSED_STEPS + 1)
        ]
    return {"frames": frames}


def _frame(strip: Strip, travel: Any, k: int, part: float) -> Record:
    # shape k of a travel at the position `part` of the slider (see `_bending_frames`)
    bent = strip.bent_as(travel.rods[k])
    shape, verdict, rows = _stations(bent), travel.verdicts[k], [*strain_rows(bent)]
    if verdict.rating != "stable":
        rows.append(stability_row(bent, verdict))
    # places and leaps are (stage, part of the stage), and these travels have a single stage
    if any(event.t <= travel.places[k][1] for _, event in travel.leaps):
        rows.append(warning_row(note("snaps on the way; this is the other shape"), "Stability"))
    return {
        "part": round(float(part), 4),
        "force": float(f"{travel.support_force[k]:.3g}"),
        "moment": float(f"{travel.support_moment[k]:.3g}"),
        "stable": verdict.stable,
        "rows": _rows(rows),
        "position": shape["position"],
        "shares": shape["shares"],
    }


def _model(request: Mapping[str, Any]) -> Record:
    """Return the shapes of a model with its holders, the summary of its kit, and warnings.

    `offers` are tested changes that warnings name.
    """
    design = _design(request["design"])
    model = design.model()
    try:
        kit = kit_contents(model, design.kit, entries=design.entries, effects=True)
    except ElasticaError as problem:
        return _placed_strips(model.placed) | refused(problem)
    messages = list(dict.fromkeys((*kit.notes, *kit.model.reports)))
    warnings = [
        message for message in messages if isinstance(message, Refusal) and message.severity == "warning"
    ]
    solids = [
        solid
        for holder in single_holders((*kit.model.plates, *kit.holders))
        for solid in (holder.solid.added if isinstance(holder, EndFixture) else (holder.solid,))
    ]
    cut_list = kit.cut_list
    return _placed_strips(kit.model.placed) | {
        "plates": [
            {
                "loops": [_rounded(path.points(CHORD_MM), 2) for path in (plate.outline, *plate.holes)],
                "thickness": plate.thickness,
                "frame": _matrix(plate.frame),
            }
            for plate in solids
        ],
        "text": note(
            "{strips}, {pieces} on {sheets}, {cuts:.1f} m of cuts, {mass:.0f} g, {blocks}"
            if kit.blocks
            else "{strips}, {pieces} on {sheets}, {cuts:.1f} m of cuts, {mass:.0f} g",
            strips=counted(len(kit.model.placed), "strip"),
            blocks=counted(len(kit.blocks), "printed block"),
            pieces=counted(cut_list.count, "piece"),
            sheets=counted(len(kit.nests), "sheet"),
            cuts=cut_list.cut_length / 1000,
            mass=cut_list.mass,
        ),
        "warnings": warnings,
        "offers": [
            {"text": note("Use {ways}", ways=inner), **change.value}
            for inner in dict.fromkeys(inner for warning in warnings for inner in warning.walk())
            if inner not in warnings
            for change in inner.changes
            if change.field == "two_plates"
        ],
        "notes": [message for message in messages if message not in warnings],
    }


def _placed_strips(placed: Iterable[Placed]) -> Record:
    """Return the shapes of a model's strips and, for each strip, the index of its shape and its position."""
    strips: dict[int, int] = {}
    shapes: list[Record] = []
    places = []
    for member in placed:
        number = strips.setdefault(id(member.strip.rod), len(shapes))
        if number == len(shapes):
            shapes.append(_stations(member.strip))
        places.append([number, _matrix(member.frame)])
    return {"shapes": shapes, "places": places, "plates": []}


def _matrix(frame: Frame) -> list[float]:
    """Return a frame's matrix (4, 4) by columns, as graphics libraries expect."""
    columns = np.eye(4)
    columns[:3, :3], columns[3, :3] = frame.axes, frame.origin
    return [round(x, 6) for x in columns.ravel().tolist()]


def _pair(request: Mapping[str, Any]) -> Record:
    """Return the shapes, the flat part and the report of a part with two states.

    If it is refused, return both drawn curves with the refusal.
    """
    try:
        part = _pair_spec(request).make()
    except ElasticaError as problem:
        pair = request["design"]["pair"]
        curves = [pair.get(key) for key in STATES] if isinstance(pair, Mapping) else []
        return {"states": [_drawn_table(curve) for curve in curves]} | refused(problem)
    pair, limit, places = part.pair, part.sheet.max_strain, []
    for rod, strain in zip(pair.states, part.strain, strict=True):
        k = np.linspace(0, rod.s.size - 1, DRAWN_NODES + 1).round().astype(int)
        wide, used = (_rounded(np.full(k.size, value), 3) for value in (part.sheet.thickness, strain / limit))
        places.append({"position": _rounded(rod.position[k], 3), "width": wide, "shares": used})
    rows = pair_rows(part, quick=True, live=bool(request.get("live")))
    together = note(
        "both states fit the same clamp positions"
        if pair.bistable
        else "each state needs its own clamp positions"
    )
    faults = [warning_row(text, note("Warning")) for text in part.rest_warnings]
    return {
        "states": places,
        "flat": _flat_loops((part.drawing(), part.holder())),
        "text": str(pair.check),
        "length": round(pair.length, 2),
        "rows": _rows(in_order([*rows, Row(note("Hold"), together), *faults])),
        "idle": [] if pair.bistable else ["push_at"],
    }


def _pair_spec(request: Mapping[str, Any]) -> FlexureSpec:
    return pair_of(without_idle(request["design"]), FilePath("design"), _no_file)


def _edit(request: Mapping[str, Any]) -> Record:
    """Return the curve with a control point added near a place, or with a point removed."""
    if "pair" in request["design"]:
        spec = _pair_spec(request)
        curve = spec.second if request.get("strip") else spec.first
    else:
        curve = _spec(request).curve
    k = request.get("remove")
    if k is None:
        return {"curve": curve_table(with_point_near(curve, request.get("near")))}
    return {"curve": curve_table(without_point(curve, k))}


def with_point_near(curve: PlaneCurve, point: object) -> PlaneCurve:
    """Insert a knot, and so a control point, near a point of the curve, without changing the shape.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (0, 10), (10, 10), (10, 0)], degree=3)
    >>> finer = with_point_near(arch, (5.0, 7.5))
    >>> len(finer.control_points), round(float(abs(finer.evaluate(0.3) - arch.evaluate(0.3)).max()), 12)
    (5, 0.0)
    """
    from scipy.interpolate import insert

    place = np.asarray(
        point if isinstance(point, list | tuple) and len(point) == 2 else (np.nan, 0), dtype=float
    )
    if not np.isfinite(place).all():
        raise InputError("The position of a control point is {point!r}. Use two numbers in mm.", point=point)
    t = np.linspace(*curve.domain, 2001)[1:-1]
    at = t[np.argmin(norm(curve.evaluate(t) - place))]
    # each coordinate is a spline with the same knots; of a rational curve, these are homogeneous coordinates
    rows = homogeneous(curve.control_points, curve.weights)
    knots, new, degree = insert(at, (curve.knots, [*rows.T], curve.degree))
    rows = np.transpose(new)[: len(knots) - degree - 1]
    return PlaneCurve(knots, project(rows), degree, rows[:, -1] if curve.is_rational else None)


def without_point(curve: PlaneCurve, k: object) -> PlaneCurve:
    """Return the curve without control point `k` and without the inner knot beside it."""
    count, degree = len(curve.control_points), curve.degree
    if not isinstance(k, int) or not 0 <= k < count:
        raise InputError("The control point {k!r} does not exist. Choose another control point.", k=k)
    points = np.delete(curve.control_points, k, axis=0)
    weights = None if curve.weights is None else np.delete(curve.weights, k)
    inner = np.arange(degree + 1, count)
    if not inner.size:
        return PlaneCurve.spline(points, degree=degree - 1)
    # Greville abscissa of point k, near which the point has its largest influence
    beside = curve.knots[k + 1 : k + degree + 1].mean()
    knot = inner[np.argmin(np.abs(curve.knots[inner] - beside))]
    return PlaneCurve(np.delete(curve.knots, knot), points, degree, weights)


def _read_dropped(request: Mapping[str, Any], folder: FilePath) -> Record:
    """Return the contents of a dropped file, which is stored in `folder` to be read."""
    name, text = FilePath(str(request.get("name", ""))).name, request.get("text")
    if not isinstance(text, str) or FilePath(name).suffix.lower() not in DROPPED:
        raise InputError(
            "The page cannot read {name!r}. Drop one of these files: {known}.",
            name=name,
            known=", ".join(DROPPED),
        )
    path = folder / f"dropped{FilePath(name).suffix.lower()}"
    path.write_text(text, encoding="utf-8", newline="")
    try:
        if path.suffix == ".toml":
            tables = parse_design(path)
            _refuse_files(tables)
            return {"design": drawable(tables, path, _no_file)}
        curves = read_curves(path)
        return {
            "curves": [
                {
                    "called": f"{name} {item.number} {item.name}".rstrip(),
                    "curve": curve_table(item.curve),
                    "read": str(curves.file.report([item])),
                }
                for item in curves.file
                if not item.problem
            ],
            "notes": list(curves.notes),
        }
    except ElasticaError as problem:
        problem.refusal = _with_name(problem.refusal, path, name)
        raise


def _with_name(refusal: Refusal, path: FilePath, name: str) -> Refusal:
    """Return the refusal with the name of the dropped file in place of the path of its temporary copy."""

    def shown(values: Mapping[str, Any]) -> Record:
        return {
            key: _with_name(value, path, name) if isinstance(value, Refusal)
            else str(value).replace(str(path), name) if str(path) in str(value)
            else value
            for key, value in values.items()
        }  # fmt: skip

    return Refusal(
        refusal.kind,
        refusal.text.replace(str(path), name),
        shown(refusal.values),
        shown(refusal.where),
        refusal.changes,
        refusal.severity,
    )


def _open_saved(_: Mapping[str, Any], saved: FilePath | None) -> Record:
    mark = file_mark(saved)
    return {"mark": mark, "design": open_design(saved) if saved and mark else None}


def _save(request: Mapping[str, Any], saved: FilePath | None) -> Record:
    """Return the text of the design and the mark of the file, for the server to write the file.

    If another program has changed the file, return its new contents instead.
    """
    before, mark = "", file_mark(saved)
    if saved is not None and not request.get("copy"):
        if request.get("mark") != mark:
            return _open_saved(request, saved) | refused(InputError(CHANGED, name=saved.name))
        before = saved.read_text(encoding="utf-8-sig") if mark else ""
    try:
        return {"text": compose_design(without_idle(request["design"]), before), "mark": mark}
    except (TypeError, ValueError) as problem:
        raise InputError(
            "The design cannot be written because values have the wrong type. Correct them."
        ) from problem


def _download(request: Mapping[str, Any], folder: FilePath) -> Download:
    """Return a file of the requested kind, made in `folder`; a kit is a ZIP file."""
    kind = request.get("kind")
    if kind not in DOWNLOADS:
        raise InputError("{file!r} is not a file of this page. Load the page again.", file=kind)
    tables = request["design"]
    labels = [strip.get("label") for strip in tables.get("strips", ()) if isinstance(strip, Mapping)]
    called = str(tables.get("name") or next(filter(None, labels[request.get("strip", 0) :]), "strip"))
    name = file_word(called)
    if "pair" in tables:
        spec, cutting = _pair_spec(request), cutting_of(tables)
        kit = MadePair(spec, spec.make(), name, cutting).kit
    elif kind == "kit":
        design = _design(tables)
        cutting, language = design.kit.cutting, CATALOGUES.get(request.get("language", "en"), "en")
        kit_spec = replace(design.kit, language=design.kit.language or language)
        kit = model_kit(kit_contents(design.model(), kit_spec, entries=design.entries, effects=True))
    else:
        cutting, strip_spec = _design(tables).kit.cutting, _spec(request)
        rod = solve_rod(strip_spec.rod_spec)
        files = StripFiles(
            cutting, "A4" if kind == "pdf" else None, step=kind == "step", pictures=False, stl=kind == "stl"
        )
        strip = replace(strip_spec.make(rod), unmarked=cutting.service)
        kit = StripResult(strip_spec, rod, strip, name).kit(files)
    written = kit.write(folder / name)
    if kind == "kit":
        packed = BytesIO()
        pack_files(folder, [path.relative_to(folder).as_posix() for path in sorted(written)], packed)
        return Download(f"{name}.zip", packed.getvalue())
    path = folder / name / cutting.file_name(name, kind)
    if path not in written:
        raise InputError("This page makes no file {file} of this design. Choose another file.", file=kind)
    return Download(path.name, path.read_bytes())


def _rounded(values: Any, digits: int) -> list[Any]:
    rows: list[Any] = np.round(np.asarray(values, dtype=float), digits).tolist()
    return rows


QUESTIONS: Mapping[str, Callable[..., Record | Download]] = {
    "strip": _strip_or_pair,
    "sheets": _sheet_rows,
    "cures": _suggestions,
    "bend": _bending_frames,
    "model": _model,
    "pair": _strip_or_pair,
    "edit": _edit,
    "read": _read_dropped,
    "file": _download,
    "open": _open_saved,
    "save": _save,
}

WITH_FILES = (_read_dropped, _download)
"""Functions that get a temporary folder and read no files outside this folder."""

OF_THE_FILE = (_open_saved, _save)
"""Functions that get the path of the studio's design file."""
