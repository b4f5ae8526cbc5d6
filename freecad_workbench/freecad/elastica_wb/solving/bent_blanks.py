# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Strips that are bent before they are mounted: no cut pattern shows it, so whoever gets one is told."""

from collections.abc import Iterable

import numpy as np
from freecad.elastica_wb.host.words import together, worded

from elastica_cad.design.reports import tell_blank
from elastica_cad.strip.strip import Strip


def is_bent_beforehand(strip: Strip) -> bool:
    """Is it anything but flat before it is mounted?"""
    return bool(np.any(strip.rod.natural_curvature))


def told_blanks(named: Iterable[tuple[str, Strip]]) -> list[str]:
    """How named strips are bent beforehand: a sentence for those that are bent alike, none for flat ones."""
    return together((name, worded(tell_blank(strip))) for name, strip in named)
