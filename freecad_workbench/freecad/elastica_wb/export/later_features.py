# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What goes on after a strip in the document, as a pocket or a cut does: no cutting file holds it."""

from typing import Any

from freecad.elastica_wb.features.pieces import later_features
from freecad.elastica_wb.host.resources import translate


def tell_later_features(obj: Any) -> list[str]:
    """A sentence where features go on after a strip, a model or a plate, or after its flat part."""
    words = translate(
        "Elastica",
        "{strip} is followed by {later}, which these files leave out: make it in the strip itself "
        "(slots, tabs, holes), or draw it into the files",
    )
    later = later_features(obj)
    return [words.format(strip=obj.Label, later=later)] if later else []
