"""What bodies of strips warn of: strain beyond the limit, strips through themselves or each other, radians."""

import sys
import warnings
from math import degrees
from typing import TYPE_CHECKING

from elastica_cad._printable import printable
from elastica_cad.fabrication.interlocking.collisions import self_contact
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.mechanics.bending.between_clamps import angles_in_rad

if TYPE_CHECKING:
    from elastica_cad.fabrication.model.strip_model import Model

LEAST_DEGREES = 7.0
"""Decimals below this are taken for radians: a whole turn is 6.28."""

LIBRARIES = ("elastica_cad", "build123d", "cadquery")
"""Between the user's line and what goes wrong."""


class StripWarning(UserWarning):
    """Strips can be made, but maybe not as they are meant: strained too much, or through each other."""


def warn_of_missing_slots(model: "Model") -> None:
    """Tell of strips of a model that run through each other."""
    from elastica_cad.fabrication.interlocking.collisions import missing_slots

    for text in missing_slots(model.placed, model.joints):
        warn(text)


def warn_of_strain(strip: Strip) -> None:
    """Tell of a strip that is strained beyond what its sheet takes."""
    for text in strip.strain_warnings[:1]:
        warn(text)


def end_angles(angles: object) -> tuple[float | None, float | None]:
    """Angles in degrees at start and end as rad; warns of what looks like radians, which `mechanics.bend` takes."""
    pair = angles_in_rad(angles)
    given = [degrees(angle) for angle in pair if angle]
    if given and all(abs(angle) < LEAST_DEGREES and round(angle, 9) % 1 for angle in given):
        shown = ", ".join(f"{angle:.4g}" for angle in given)
        warn(f"angles are in degrees, and {shown} is little: give numpy.degrees(...) of what is in radians")
    return pair


def warn(text: str) -> None:
    """Warn at the line of the user's script, however deep we are."""
    depth, caller = 2, sys._getframe(1)
    while caller.f_back is not None and str(caller.f_globals.get("__name__")).split(".")[0] in LIBRARIES:
        depth, caller = depth + 1, caller.f_back
    warnings.warn(printable(text), StripWarning, stacklevel=depth)


def warn_of_contact(strip: Strip) -> None:
    """Tell of a strip that meets itself when it is bent."""
    meeting = self_contact(strip)
    if meeting is not None:
        low, high = meeting
        warn(
            f"bent, the strip runs through itself: {low:.1f} mm along it meets {high:.1f} mm (tabs lie below 0 "
            f"and beyond {strip.rod.length:.1f}); shorten the tabs, open the curve, or cut a slot there"
        )
