"""Is a drawing of a size that strips have? If not, its unit is likely another than the one it was read in."""

from collections.abc import Iterable

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.formats.file_access.source_file import look_up_unit

LIKELY_MM = (20.0, 5000.0)
"""Sides of the box about a curve for a strip: from a clip to what is joined of several sheets."""

NO_UNIT = "its file names no unit, and mm are taken"

_SO_LARGE, _SO_SMALL = ("mm",), ("mm", "in", "cm", "m")  # what numbers are where they were taken as another


def doubt_size(curves: Iterable[Iterable[FloatArray]], unit: float, why: str) -> str:
    """A sentence where the curves of a file are larger or smaller than strips are and another unit would suit them.

    Parameters
    ----------
    curves : iterable of iterables of (n, d) arrays
        Control points, mm, of the pieces of each.
    unit : float
        What was taken as one unit of the file, mm.
    why : str
        What says so.

    Returns
    -------
    str
        Empty where most curves, or the largest, are of a likely size.

    Examples
    --------
    >>> import numpy as np
    >>> doubt_size([[np.array([(0, 0), (3e5, 9e4)])]], 1000.0, "its file says m")
    'its largest curve is 300 m across, for its file says m: where that is wrong, say --unit mm (300 mm)'
    """
    sizes = [_size(points) for points in curves]
    if not sizes:
        return ""
    (least, most), largest = LIKELY_MM, max(sizes)
    small = largest < least
    if not small and not (largest > most and np.median(sizes) > most):  # the median loads all of numpy.ma
        return ""
    others = {name: largest / unit * look_up_unit(name) for name in (_SO_SMALL if small else _SO_LARGE)}
    meant = [f"--unit {name} ({size:.4g} mm)" for name, size in others.items() if least <= size <= most]
    if not meant:
        return ""
    across = f"{largest:.3g} mm" if small else f"{largest / 1000:.4g} m"
    return f"its largest curve is {across} across, for {why}: where that is wrong, say {' or '.join(meant)}"


def _size(pieces: Iterable[FloatArray]) -> float:
    """The longer side of the box about the control points."""
    return float(np.ptp(np.concatenate(list(pieces)), axis=0).max())
