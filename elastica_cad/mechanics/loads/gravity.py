"""Gravity as a rod feels it: one length and a direction."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, is_number, numbers, require_positive
from elastica_cad.declared import Asked
from elastica_cad.errors import InputError


@dataclass(frozen=True)
class Gravity:
    """Weight of a strip whose weight per length is proportional to its stiffness.

    Parameters
    ----------
    length : float
        Elasto-gravity length (E h^2 / (12 rho g))^(1/3), mm (paper, section 5.1: (beta l^3)^(1/3)).
    direction : (2,) array_like
        The direction in which things fall; any length, in the plane of the curve.

    Raises
    ------
    InputError
        Length not positive and finite, or direction zero.

    Examples
    --------
    >>> Gravity(96.0, (3, -4)).e.round(9).tolist()
    [-6.78e-07, 9.04e-07]
    """

    length: Annotated[
        float, Asked("Elasto-gravity length, in place of that of the sheet.", "mm", least=0, group="weight")
    ]
    direction: Annotated[
        tuple[float, float],
        Asked("The direction in which things fall, in the plane of the curve.", group="weight"),
    ] = (0.0, -1.0)

    def __post_init__(self) -> None:
        if not (is_number(self.length) and self.length > 0):
            raise InputError(
                "gravity length is {length!r}; it must be positive, in mm (200 gsm card: 96)",
                length=self.length,
            )
        d = as_floats(self.direction)
        if d is None or d.shape != (2,) or not np.all(np.isfinite(d)) or not np.any(d):
            raise InputError(
                "gravity direction {direction!r} must be two numbers, not both zero, e.g. (0, -1)",
                direction=self.direction,
            )
        d = d / np.hypot(*d)
        object.__setattr__(self, "direction", (float(d[0]), float(d[1])))

    @classmethod
    def in_plane(
        cls, length: float, direction: ArrayLike, x_axis: ArrayLike, y_axis: ArrayLike
    ) -> "Gravity | None":
        """Gravity of a plane in space: the part of `direction` (3,) within the plane; None when it has none."""
        d, *axes = (
            numbers(given, name)
            for given, name in ((direction, "gravity direction"), (x_axis, "x axis"), (y_axis, "y axis"))
        )
        if any(row.shape != (3,) for row in (d, *axes)) or not 0 < np.abs(d).max() < np.inf:
            raise InputError(
                "gravity in a plane takes a direction and two axes of three numbers, none of them all 0"
            )
        require_positive(length, "gravity length")
        d = d / np.linalg.norm(d)
        part = np.array([d @ axis for axis in axes])
        size = float(np.hypot(*part))
        if size < 1e-9:
            return None
        return cls(length / size ** (1 / 3), (float(part[0]), float(part[1])))

    @property
    def e(self) -> FloatArray:
        """The vector e of Eq. 5, 1/mm3; it points up, as the paper's derivation needs and its text misprints."""
        return -np.asarray(self.direction) / self.length**3

    def scaled(self, factor: float) -> "Gravity":
        """`factor` times the weight."""
        require_positive(factor, "the factor of a gravity", "times the weight")
        return Gravity(self.length / factor ** (1 / 3), self.direction)
