"""Solution of a request for a rod: the rod that takes the curve, or the nearest rod within limits. A load that no
width carries is refused with the width or thickness that would carry it.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.errors import Change, FieldName, InputError, Length, NotMetError, note, rounded_up
from elastica_cad.form_finding.nearest_record import NearestRod, Status
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.mechanics.least_ratio import filled_gravity, laminate_of_request, rod_of_request
from elastica_cad.mechanics.optimal_balance import OverloadError
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import sharp_bend_message, sharpest_bend
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.theorem1 import NotRealizable, crossing_notes


def solve_rod(spec: RodSpec) -> Rod | NearestRod:
    """Return the rod that is at rest in the curve, or the nearest rod if the curve may change.

    Raises
    ------
    NotRealizable
        No rod takes the curve, and the curve may not change.
    InputError, NotConvergedError
        See `optimal_rod`, `optimal_laminate` and `nearest_rod`.
    """
    curve, layers, widths = spec.curve_to_bend, spec.layers, spec.widths
    if (spec.between or spec.point_forces) and (spec.may_change or layers is not None):
        raise InputError(
            "A strip with rails, pins, ties or point forces must be of one sheet and follow the drawn curve "
            "exactly. Leave out the backing and {limits}, or these elements.",
            limits=FieldName("limits"),
        )
    weight, factor = spec.weight, curve.length / spec.curve.length
    if weight is not None:
        weight = replace(weight, masses=tuple(replace(mass, at=factor * mass.s) for mass in weight.masses))
    smoothed: Any = {"curve": curve, "smooth": 0.0, "weight": weight}
    if spec.may_change:
        from elastica_cad.form_finding.curve_distance import TargetCurve, measure_deviation
        from elastica_cad.form_finding.nearest_search import find_nearest

        near = find_nearest(replace(spec, **smoothed))
        if near.failed or not spec.smoothing.moved:
            return near
        # from the curve as drawn, not from the smoothed curve
        return replace(near, deviation=measure_deviation(TargetCurve.of(spec.curve), near.rod.position))
    if layers is not None and spec.gravity is not None:
        gravity = filled_gravity(layers.section, spec.gravity.direction)
        return laminate_of_request(replace(spec, **smoothed, gravity=gravity), layers).rod
    bounds: Any = {} if widths is None else _stiffness_limits(widths)
    try:
        rod = rod_of_request(replace(spec, **smoothed, known_check=spec.check, drawn=spec.curve, **bounds))
    except NotRealizable as error:
        # if the sheet would break, the refusal begins with the place
        sharp = spec.sheet and sharp_bend_message(spec.sheet, *sharpest_bend(curve, spec.natural_curvature))
        if not sharp:
            raise
        check = replace(error.check, reasons=(sharp, *error.check.reasons))
        raise NotRealizable(check, [Change("size", sharp.values["times"])]) from None
    except OverloadError as error:
        raise (error if widths is None else _overload_refusal(widths, error)) from None
    return rod if widths is None else _with_widest(rod, widths)


def _stiffness_limits(widths: PlainSection) -> dict[str, float]:
    """Return arguments of `optimal_rod`: bending stiffnesses, N mm2, by name."""
    if np.isinf(widths.largest):
        # increase the least width, so that rounding errors do not make a strip narrower than the limit
        return {"bending_stiffness": widths.rigidity * widths.least * (1 + 1e-6)}
    limits = {"least_stiffness": widths.least, "largest_stiffness": widths.largest}
    return {name: widths.rigidity * width for name, width in limits.items() if width}


def _with_widest(rod: Rod, widths: PlainSection) -> Rod:
    """Return the rod, with a warning if its largest width is less than the requested width."""
    widest = rod.profile.extremes[1] * (rod.bending_stiffness or 0.0) / widths.rigidity
    # do not warn of a difference below 0.1 mm
    if np.isinf(widths.largest) or widest > widths.largest - 0.1:
        return rod
    warning = note(
        "The load on the strip determines its width: the widest place is {widest:.4g} wide, not {largest:g} "
        "({field}).",
        field=FieldName("max_width"), widest=Length(widest), largest=Length(widths.largest), severity="warning",
    )  # fmt: skip
    return replace(rod, warnings=(*rod.warnings, warning))


def _overload_refusal(widths: PlainSection, error: OverloadError) -> InputError:
    """Return the refusal of a load, with the needed width, or thickness of the sheet, as changes."""
    needed = rounded_up(error.needed / widths.rigidity, 4)
    changes, otherwise = [Change("max_width", needed)], ""
    if error.thickening is not None:
        thickness = rounded_up(error.thickening * widths.sheet.thickness, 4)
        changes.append(Change("thickness", thickness))
        otherwise = note(", or use a sheet {thickness:.4g} thick or thicker", thickness=Length(thickness))
    return InputError(
        "No strip between {least:.4g} and {largest:.4g} wide carries this load. Set {field} to {needed:.4g} "
        "or more{otherwise}.",
        field=FieldName("max_width"),
        least=Length(widths.least),
        largest=Length(widths.largest),
        needed=Length(needed),
        otherwise=otherwise,
        where={"field": "max_width"},
        changes=changes,
    )


def accepted_rod(result: Rod | NearestRod) -> Rod:
    """Return the rod of a result, with the warnings of the search, and of a curve that crosses itself.

    Raises
    ------
    NotMetError
        No rod near the curve meets the limits. The message has suggestions.
    """
    if isinstance(result, Rod):
        return result
    require_record(result, NearestRod, "what was found", "a Rod or NearestRod")
    if not result.met:
        raise NotMetError(str(result))
    rod, status = result.rod, () if result.status is Status.MET else (result.status.value,)
    return replace(rod, warnings=(*rod.warnings, *crossing_notes(rod.curve), *status))
