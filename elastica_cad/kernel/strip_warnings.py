"""What bodies of strips warn of: strain beyond the limit, strips that run through themselves or each other."""

import sys
import warnings
from typing import TYPE_CHECKING

from elastica_cad.fabrication.solids.self_contact import self_contact
from elastica_cad.fabrication.strip.strip_record import Strip

if TYPE_CHECKING:
    from elastica_cad.fabrication.model.strip_model import Model

LIBRARIES = ("elastica_cad", "build123d", "cadquery")
"""Between the user's line and what goes wrong."""


class StripWarning(UserWarning):
    """Strips can be made, but not bent as they are: strained beyond their sheet's limit, or through each other."""


def warn_of_missing_slots(model: "Model") -> None:
    """Tell of strips of a model that run through each other."""
    from elastica_cad.fabrication.interlocking.missing_slots import missing_slots

    for text in missing_slots(model.placed, model.joints):
        warn(text)


def warn_of_strain(strip: Strip) -> None:
    """Tell of a strip that is strained beyond what its sheet takes."""
    for text in strip.strain_warnings[:1]:
        warn(text)


def warn(text: str) -> None:
    """Warn at the line of the user's script, however deep we are."""
    depth, caller = 2, sys._getframe(1)
    while caller.f_back is not None and str(caller.f_globals.get("__name__")).split(".")[0] in LIBRARIES:
        depth, caller = depth + 1, caller.f_back
    warnings.warn(text, StripWarning, stacklevel=depth)


def warn_of_contact(strip: Strip) -> None:
    """Tell of a strip that meets itself when it is bent."""
    meeting = self_contact(strip)
    if meeting is not None:
        low, high = meeting
        warn(
            f"bent, the strip runs through itself: {low:.1f} mm along it meets {high:.1f} mm (tabs lie below 0 "
            f"and beyond {strip.rod.length:.1f}); shorten the tabs, open the curve, or cut a slot there"
        )
