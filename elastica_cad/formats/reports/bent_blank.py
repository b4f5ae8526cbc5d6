"""The blank that a strip is bent from where it is not flat: for the report, and in words for the bench."""

from typing import Any

import numpy as np

from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.formats.reports.check_report import round_numbers

STATIONS = 201
"""At which the curvature of a blank is listed, uniform in arc length; an even one is told at both ends."""


def report_blank(strip: Strip) -> dict[str, Any] | None:
    """Curvature of the blank, 1/mm, positive to the left, at places along the free part, mm; None of a flat one.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
    >>> curve = PlaneCurve.arc((0, 0), 100, 0, 1)
    >>> report_blank(make_strip(curve, "birch-plywood-0.8", max_width=20, natural_curvature=0.004))
    {'s': [0.0, 100.0], 'curvature': [0.004, 0.004]}
    """
    rest = np.asarray(strip.rod.natural_curvature, dtype=float)
    if not rest.any():
        return None
    s = np.linspace(0.0, strip.rod.length, STATIONS if np.ptp(rest) > 0 else 2)
    return {"s": round_numbers(s), "curvature": round_numbers(strip.rod.rest_at(s))}


def tell_blank(strip: Strip) -> str:
    """How the blank is bent before it is put in, without an end; empty of a flat one.

    The way is told by how the strip stands in the end: pieces of one shape are turned over where that
    spares a part, so that none of their faces tells left from right.
    """
    rod = strip.rod
    rest = np.broadcast_to(np.asarray(rod.natural_curvature, dtype=float), rod.s.shape)
    if not rest.any():
        return ""
    even = np.ptp(rest) == 0
    at = int(np.argmax(np.abs(rod.curvature if even else rest)))
    radius = f"a radius of {1 / abs(rest[at]):.4g} mm"
    place = f"at {rod.s[at]:.1f} mm"
    where = f"{radius} all along" if even else f"{radius} {place}, its sharpest"
    way = "the way" if rest[at] * rod.curvature[at] > 0 else "the other way than"
    more = "" if even else "; `blank` in the report has its curvature along the strip"
    return (
        f"bend it beforehand to {where}, {way} it stands bent {place if even else 'there'}: its widths count on "
        f"that{more}"
    )
