"""Reports on strips as plain data."""

from itertools import zip_longest

import numpy as np

from elastica_cad._values import is_whole, plain_data, require_record
from elastica_cad.design.check_report import PlainData, report_check
from elastica_cad.errors import FieldName, InputError, Length, NotConvergedError, installed_version, note
from elastica_cad.form_finding.fairing_request import Smoothing
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.formats.json_curves import curve_record
from elastica_cad.mechanics.elements import NOUNS, Tie
from elastica_cad.mechanics.mounting_errors import displacements_per_mm
from elastica_cad.mechanics.stability import Stability
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.holding_template import (
    distance_between,
    distance_of_tips,
    ends_message,
    held_ends,
    hole_places,
)
from elastica_cad.strip.measuring import Measuring
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.summary import farthest_move, instability, instability_in_plane, not_computed_row


def report_blank(strip: Strip) -> PlainData | None:
    """Return the natural curvature (1/mm, positive to the left) at stations (mm), or None if it is zero.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> curve = PlaneCurve.arc((0, 0), 100, 0, 1)
    >>> report_blank(make_strip(curve, "birch-plywood-0.8", max_width=20, natural_curvature=0.004))
    {'s': [0.0, 100.0], 'curvature': [0.004, 0.004]}
    """
    rest = np.asarray(strip.rod.natural_curvature, dtype=float)
    if not rest.any():
        return None
    s = np.linspace(0.0, strip.rod.length, 201 if np.ptp(rest) > 0 else 2)
    return {"s": plain_data(s), "curvature": plain_data(strip.rod.rest_at(s))}


def pre_bend_message(strip: Strip) -> str:
    """Return an instruction for pre-bending the strip, without a full stop, or "" for a flat strip.

    The instruction gives the direction relative to the final bend. No face of the strip is named, because
    equal pieces may be turned over.
    """
    rod = strip.rod
    rest = rod.rest_at(rod.s)
    if not rest.any():
        return ""
    even = np.ptp(rest) == 0
    at = int(np.argmax(np.abs(rod.curvature if even else rest)))
    # True if the inner face is the same where the first bend (or, if it is even, the final bend) is largest
    same = rest[at] * rod.curvature[at] > 0
    ways = (
        (
            "Before assembly, bend the strip to a radius of {radius} along its whole length. The inner face of "
            "this bend is also the inner face at {s} from the start after assembly. The widths are designed for "
            "this pre-bending.",
            "Before assembly, bend the strip to a radius of {radius} along its whole length. The inner face of "
            "this bend is the outer face at {s} from the start after assembly. The widths are designed for this "
            "pre-bending.",
        )
        if even
        else (
            "Before assembly, bend the strip; the smallest radius is {radius}, at {s} from the start. There, the "
            "inner face of this bend is also the inner face after assembly. The report or the "
            "properties list the curvature along the strip ({field}). The widths are designed for this "
            "pre-bending.",
            "Before assembly, bend the strip; the smallest radius is {radius}, at {s} from the start. There, the "
            "inner face of this bend is the outer face after assembly. The report or the properties "
            "list the curvature along the strip ({field}). The widths are designed for this pre-bending.",
        )
    )
    radius = Length(1 / abs(rest[at]))
    return note(ways[0 if same else 1], field=FieldName("blank"), radius=radius, s=Length(rod.s[at]))


REPORT_SCHEMA = "elastica-report/1"
MOST_STATIONS = 100_000

UNITS = {
    "length": "mm",
    "width": "mm",
    "area": "mm2",
    "angle": "rad",
    "curvature": "1/mm",
    "strain": "1",
    "stiffness": "1 (least value 1)",
    "mass": "g",
    "force": "N",
    "moment": "N mm",
}


def report_strip(
    strip: Strip,
    *,
    name: str,
    files: dict[str, str],
    near: NearestRod | None = None,
    stability: Stability | None = None,
    smoothing: Smoothing | None = None,
    stations: int = 201,
) -> PlainData:
    """Return the report of one strip as plain data for JSON.

    Parameters
    ----------
    strip : Strip
    name : str
        Name of the part.
    files : dict
        File name for each kind of file (dxf, svg, ...).
    near : NearestRod, optional
        Nearest possible rod. The report gives its deviation from the drawn curve, and the limits that cause it.
    stability : Stability, optional
        Stability of the rest shape.
    smoothing : Smoothing, optional
        Smoothing that was applied to the drawn curve.
    stations : int
        Number of stations for stiffness and width, uniform in arc length.
    """
    require_record(strip, Strip, "what is reported", "a Strip, as make_strip makes one")
    for value, record, what in ((near, NearestRod, "near"), (stability, Stability, "stability")):
        require_record(value, record | None, what, f"a {record.__name__}, or None")
    if not (is_whole(stations) and 2 <= stations <= MOST_STATIONS):
        raise InputError(
            "stations is {stations!r}. Use a whole number from 2 to {most_stations}.",
            stations=stations,
            most_stations=MOST_STATIONS,
        )
    rod, sheet, layout = strip.rod, strip.sheet, strip.layout
    s = np.linspace(0.0, rod.length, stations)
    unstable = None if stability is None else instability(strip, stability)
    numbers = strip_quantities(strip) | {
        "stability": None if stability is None else _stability_report(strip, stability),
        "moved_by_snapping": rod.moved,
        "residual": rod.residual,
        "gravity": rod.gravity,
        "stations": {
            "s": s,
            "stiffness": rod.profile(s),
            "width": strip.width(s),
            "material": layout.material(s),
            "backing": None if layout.backing is None else layout.backing.width(s),
            **{name: size(s) for name, size in strip.tapered.items()},
        },
        "sheet": {
            "name": sheet.name,
            "thickness": sheet.thickness,
            "youngs_modulus_MPa": sheet.youngs_modulus,
            "density_kg_m3": sheet.density,
            "max_strain": sheet.max_strain,
            "source": sheet.source,
        },
        "strain": {"largest": strip.max_strain, "at": strip.max_strain_at, "limit": strip.strain_limit},
        "without_loads": _without_loads(strip),
        "backing_side": strip.backing_side or None,
        "ends": _ends(strip),
        "held": _held(strip),
        "measuring": report_measuring(strip),
        "joint": _joint(strip),
        "layers": _layers(strip),
        "between": _between(strip),
        "warnings": [*strip.warnings, *filter(None, [unstable])],
    }
    smoothed = None
    if smoothing is not None:
        fairing = smoothing.fairing
        smoothed = plain_data({
            "moved": smoothing.moved, "allowed": fairing and fairing.tolerance,
            "ratio_as_drawn": fairing and smoothing.ratio_as_drawn, "healed": smoothing.healed,
        }) | {"drawn": fairing and curve_record(smoothing.drawn)}  # fmt: skip
    return {
        "schema": REPORT_SCHEMA,
        "name": name,
        "versions": list_versions(),
        "units": UNITS,
        "files": files,
        # curves are not rounded, because strips are made from them again
        "curve": curve_record(rod.curve),
        "check": None if rod.check is None else report_check(rod.check),
        "nearest": None
        if near is None
        else {
            "wish": curve_record(near.target),
            "status": near.status.name.lower(),
            "message": near.status.value,
            "met": near.met,
            "deviation": plain_data(near.deviation),
            "binding": [
                {"name": bound.name, "limit": bound.limit, "cost": plain_data(bound.cost)}
                for bound in near.binding
            ],
        },
        "smoothing": smoothed,
        **plain_data(numbers),
    }


def strip_quantities(strip: Strip) -> PlainData:
    """Return the quantities that the reports of a strip and of a model state about a strip."""
    low, high = strip.width.extremes
    return {
        "length": strip.rod.length,
        "ratio": strip.rod.ratio,
        "width": {"least": low, "largest": high},
        "mass": strip.mass,
        "sideways": {
            "word": strip.sideways.word, "margin": strip.sideways.margin,
            "overloaded": strip.sideways.overloaded, "meaning": strip.sideways.meaning,
        },
        "reactions": strip.reactions(),
        "creep": _creep(strip),
        "blank": report_blank(strip),
    }  # fmt: skip


def _without_loads(strip: Strip) -> PlainData | None:
    if strip.unloaded is None:
        return None
    # strain of the layer that is closest to its limit, with and without the loads
    loaded, unloaded = (
        max(strains, key=lambda layer: layer.largest / layer.limit).largest
        for strains in (strip.strains, strip.unloaded_strains)
    )
    moved, at, _ = farthest_move(strip.rod, strip.unloaded)
    return {"strain": unloaded, "strain_with_loads": loaded, "moved": moved, "moved_at": at}


def _stability_report(strip: Strip, stability: Stability) -> PlainData:
    word, meaning = str(stability.word), stability.meaning
    # in spite of an ample margin, a strip can snap if a clamp is turned by a usual error
    if word == "ample" and (warning := instability_in_plane(strip, stability)):
        word, meaning = "low", warning
    return {
        "stable": stability.stable,
        "margin": stability.margin,
        "word": word,
        "meaning": meaning,
    }


def _between(strip: Strip) -> list[PlainData]:
    """Return rails, pins, ties and point forces, with their positions (mm) and their forces on the strip (N).

    A tie also has its length (mm) and its pull (N). `moved_per_mm` is the largest displacement of the strip,
    mm, per mm of error in the position of a rail or pin, or in the length of a tie.
    """
    moves = displacements_per_mm(strip.rod)
    return [
        {
            "kind": NOUNS[type(action.element)],
            "at": action.s,
            "force": strip.bending_stiffness * action.force,
            **(
                {
                    "length": action.distance_on(strip.rod.curve),
                    "pull": strip.bending_stiffness * action.size,
                }
                if isinstance(action.element, Tie)
                else {}
            ),
            **({} if moved is None else {"moved_per_mm": moved}),
        }
        for action, moved in zip_longest(strip.rod.acting, moves)
    ]


def _layers(strip: Strip) -> list[PlainData]:
    """Return the layers, the base layer first.

    The thickness of a planed or turned strip is its largest thickness.
    """
    worked = strip.layout.worked_size
    return [
        {
            "sheet": layer.sheet.name,
            "thickness": layer.sheet.thickness if worked is None else worked.extremes[1],
            "mass": layer.mass if worked is None else strip.mass,
        }
        for layer in strip.layers
    ]


def _creep(strip: Strip) -> PlainData | None:
    if not strip.creep:
        return None
    try:
        crept = strip.crept
    except NotConvergedError as problem:
        return {"factor": strip.creep, "problem": str(problem)}
    assert crept is not None
    # the result of the creep study: sag, mm, and the fractions of the end force and of the bend that are kept
    return {
        "factor": crept.factor, "basis": "exact" if crept.exact else "effective modulus", "sag": crept.sag,
        "force_share": crept.force_share, "end_forces": crept.end_forces * strip.bending_stiffness,
        "margin": crept.stability.margin, "word": crept.stability.word, "kept_bend": crept.kept_share,
    }  # fmt: skip


def report_held(shape: HeldShape) -> PlainData:
    """Return the deviation of a held strip and its causes as plain data.

    Predicted deviations are rounded to two significant digits.
    """
    return {
        "expected": float(f"{shape.expected:.2g}"),
        "deviation": shape.deviation,
        "open": float(f"{shape.open:.2g}"),
        "sheet": {
            cause: float(f"{mm:.2g}") for cause, mm in {"all": shape.sheet_adds, **shape.sheet}.items()
        },
        "parts": shape.parts,
        "made_up_for": shape.made_up_for,
        "ends": {"start": shape.start, "end": shape.end},
        "notes": shape.notes,
    }


def _ends(strip: Strip) -> PlainData | None:
    """Return the positions (mm) and angles (degrees) of the held ends, or None for a closed strip."""
    if strip.is_closed:
        return None
    ends = held_ends(strip)
    by_end = {
        "distance": distance_between(ends), "tips": distance_of_tips(ends), "meaning": str(ends_message(strip)),
    }  # fmt: skip
    for name, end, places in zip(("start", "end"), ends, hole_places(ends), strict=True):
        by_end[name] = {
            "position": end.position + 0.0, "angle": end.angle, "from_the_line": end.tilt, "tab": end.tab,
            "holes": [
                {
                    "at": hole.at, "across": hole.across, "diameter": hole.diameter,
                    "from_the_start": np.round(place, 6) + 0.0,
                }
                for hole, place in zip(end.holes, places, strict=True)
            ],
        }  # fmt: skip
    return by_end


def _held(strip: Strip) -> PlainData | None:
    """Return the shape of the strip as cut, with its ends at their designed positions and angles.

    Return None if no shape near the design is found, if the strip has rails, pins, ties or point forces, or if it
    can snap into another shape.
    """
    try:
        return None if not_computed_row(strip) else report_held(strip.held())
    except NotConvergedError:
        return None


def report_measuring(strip: Strip) -> PlainData | None:
    """Return measurable quantities for `elastica compare`.

    Return None if the strip is closed, has no rest shape, or has rails, pins, ties or point forces.
    """
    if strip.is_closed or strip.rod.acting:
        return None
    try:
        return {**vars(Measuring.of(strip))}
    except NotConvergedError:
        return None


def _joint(strip: Strip) -> PlainData | None:
    # where and how the ends of a closed strip are glued to each other, or None for an open strip
    if not strip.is_closed:
        return None
    held = strip.reactions()
    return {
        "place": strip.rod.position[0],
        "lap": strip.ends[1].length,
        "widths": strip.end_widths,
        "moment": held.end_moment,
        "force": held.end_force,
        "meaning": strip.joint,
    }


def list_versions() -> dict[str, str]:
    """Return the versions of the packages that a result depends on."""
    packages = ("elastica-cad", "numpy", "scipy", "highspy", "ezdxf")
    return {package: version for package in packages if (version := installed_version(package))}
