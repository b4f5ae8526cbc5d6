"""Slots: narrow cuts that let strips interlock, open at the edge of the flat pattern."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError

__all__ = ["Relief", "Side", "Slot"]

Side = Literal["upper", "lower"]
Relief = Literal["square", "round"]


@dataclass(frozen=True, eq=False)
class Slot:
    """A slot from inside the strip to its edge.

    Parameters
    ----------
    at : float
        Arc length of the inner end of its centre line, mm.
    width : float
        Across the slot, mm; of a slot along a `path` the width at the inner end.
    depth : float, optional
        From the edge of the strip to the inner end, measured across the strip, mm; to the centre line of the
        strip where not given.
    side : "upper" or "lower"
        The edge on which it opens: y > 0 or y < 0 of the flat pattern.
    lean : float
        Angle of the centre line to the strip's ruling, rad: outward it moves towards larger x where positive.
    relief : "square" or "round"
        The inner end: straight across, or a half circle beyond it.
    mate : str
        What goes in here; written beside the slot.
    path : (k, 2) array, optional
        Centre line in the flat pattern from the inner end to the edge, mm, in place of depth and lean.
    widths : (k,) array, optional
        Width at every point of `path`, mm.

    Raises
    ------
    InputError
        Sizes that are not positive, a path without its widths.

    Examples
    --------
    >>> Slot(40.0, width=1.2, depth=5.0, side="lower").mirrored().side
    'upper'
    """

    at: float
    width: float
    depth: float | None = None
    side: Side = "upper"
    lean: float = 0.0
    relief: Relief = "square"
    mate: str = ""
    path: FloatArray | None = None
    widths: FloatArray | None = None

    def __post_init__(self) -> None:
        for name in ("at", "width", "lean", *(() if self.depth is None else ("depth",))):
            if not np.isfinite(getattr(self, name)):
                raise InputError(f"slot {name} is {getattr(self, name)}: it must be a finite number")
        here = f"slot at {self.at:.6g} mm"
        if self.width <= 0 or (self.depth is not None and self.depth <= 0):
            raise InputError(f"{here}: width and depth must be positive, in mm")
        if self.side not in ("upper", "lower") or self.relief not in ("square", "round"):
            raise InputError(
                f'{here}: side is "upper" or "lower" and relief "square" or "round", not {self.side!r} and '
                f"{self.relief!r}"
            )
        if abs(self.lean) >= np.pi / 2:
            raise InputError(f"{here}: lean is {self.lean:g} rad: it must stay within a quarter turn")
        if (self.path is None) != (self.widths is None):
            raise InputError(f"{here}: path and widths go together")
        if self.path is not None:
            path, widths = np.array(self.path, dtype=float), np.array(self.widths, dtype=float)
            if path.ndim != 2 or path.shape[1] != 2 or len(path) < 2 or widths.shape != (len(path),):
                raise InputError(f"{here}: path has two or more rows (x, y), widths one number for each")
            if not np.all(np.isfinite(path)) or not np.all(widths > 0):
                raise InputError(f"{here}: path and widths must be finite, widths positive, in mm")
            for name, array in (("path", path), ("widths", widths)):
                array.setflags(write=False)
                object.__setattr__(self, name, array)

    @classmethod
    def along(
        cls, path: ArrayLike, widths: ArrayLike, *, side: Side, relief: Relief = "square", mate: str = ""
    ) -> "Slot":
        """A slot along a centre line (k, 2) from its inner end to the edge, as wide as `widths` (k,) say."""
        rows, across = np.asarray(path, dtype=float), np.asarray(widths, dtype=float)
        return cls(
            float(rows[0, 0]), float(across[0]), side=side, relief=relief, mate=mate, path=rows, widths=across
        )

    def mirrored(self) -> "Slot":
        """The slot of the strip turned over about its centre line (y to -y)."""
        path = None if self.path is None else self.path * (1.0, -1.0)
        return replace(self, side="lower" if self.side == "upper" else "upper", path=path)
