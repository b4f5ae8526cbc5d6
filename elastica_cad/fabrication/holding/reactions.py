"""What the supports of a bent strip do to it."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray


@dataclass(frozen=True, eq=False)
class Reactions:
    """What the supports do to the strip: forces (2,) in N, moments in N mm (positive anticlockwise).

    Examples
    --------
    >>> print(Reactions(np.array([1.0, 0.0]), 20.0, np.array([-1.0, 0.0]), -20.0))
    the start is held by 1 N, (1, 0), and 20 N mm; the end by 1 N, (-1, 0), and -20 N mm
    """

    start_force: FloatArray
    start_moment: float
    end_force: FloatArray
    end_moment: float

    def __str__(self) -> str:
        start, end = (
            f"{np.hypot(x, y):.4g} N, ({x:.4g}, {y:.4g}), and {moment:.4g} N mm"
            for (x, y), moment in ((self.start_force, self.start_moment), (self.end_force, self.end_moment))
        )
        return f"the start is held by {start}; the end by {end}"
