"""What turns a cross-section's parameter into stiffness, weight and strain, and back."""

from typing import Protocol

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.mechanics.material.section_limits import LayerStrain
from elastica_cad.mechanics.material.tapered_sections import LaidLeaves


class StiffnessLaw(Protocol):
    """A cross-section with one parameter, mm, that varies along the strip and decides its bending stiffness.

    The parameter is a width at fixed thickness, a thickness at fixed width or a diameter. What else is given along
    the strip, as the base of a laminate is, belongs to the law, station by station.
    """

    def bending_stiffness(self, parameter: ArrayLike, /) -> FloatArray:
        """E I (n,), N mm2, of parameters (n,), mm."""

    def parameter(self, bending_stiffness: ArrayLike, /) -> FloatArray:
        """Parameters (n,), mm, that give the E I (n,), N mm2."""

    def weight_per_length(self, parameter: ArrayLike, /) -> FloatArray:
        """N/mm (n,) of parameters (n,), mm."""

    def strains(
        self, curvature: ArrayLike, parameter: ArrayLike, /, *, natural_curvature: float = 0.0
    ) -> tuple[LayerStrain, ...]:
        """Strain of each layer's outermost fibre, of curvatures (n,), 1/mm, and parameters (n,), mm."""


class BoundedLaw(StiffnessLaw, Protocol):
    """A law whose parameter has limits: what `optimal_rod` and `nearest_rod` take as `section`."""

    @property
    def quantity(self) -> str:
        """What the parameter is: "width", "thickness" or "diameter"."""

    @property
    def limits(self) -> tuple[float, float]:
        """Least (0: none) and largest parameter, mm."""

    @property
    def follows_bend(self) -> bool:
        """Does its stiffness hang on how sharply it is bent? Its scale is then known once the bend is."""

    @property
    def stack(self) -> LaidLeaves | None:
        """The glued leaves that it is, as they lie; None for one piece."""

    def bent(self, curvature: ArrayLike, rest: ArrayLike = 0.0, /) -> "BoundedLaw":
        """The law at stations bent by kappa - kappa_0 (n,) from `rest`, kappa_0, 1/mm.

        Itself where bending does not change it.
        """
