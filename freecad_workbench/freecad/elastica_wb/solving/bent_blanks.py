# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Messages about pre-bent strips, because a cut pattern does not show that they are bent before assembly."""

from collections.abc import Iterable

import numpy as np
from freecad.elastica_wb.host.words import together, worded

from elastica_cad.design.reports import tell_blank
from elastica_cad.strip.strip import Strip


def is_bent_beforehand(strip: Strip) -> bool:
    """Return True if a strip is bent before assembly."""
    return bool(np.any(strip.rod.natural_curvature))


def told_blanks(named: Iterable[tuple[str, Strip]]) -> list[str]:
    """Return how named strips are bent before assembly, with one message for strips that are bent alike."""
    return together((name, worded(tell_blank(strip))) for name, strip in named)
