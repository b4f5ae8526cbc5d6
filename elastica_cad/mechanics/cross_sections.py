"""Cross-sections: their interface, and tapered strips, rods, tubes and glued plies."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, NamedTuple, Protocol, Self, TypeVar, cast

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import alike, is_whole, numbers, require_number, require_record
from elastica_cad.declared import Option
from elastica_cad.errors import BareLength, FieldName, InputError, Length, quoted
from elastica_cad.mechanics.section_limits import LayerStrain, positive
from elastica_cad.mechanics.sheets import Sheet

MOST_LEAVES = 50
"""Largest number of plies; with more plies a stack would be as smooth as a taper."""


class SectionLayer(NamedTuple):
    """Layer of a cross-section at n stations along a strip.

    Attributes
    ----------
    sheet : Sheet
        Material of the layer.
    area : (n,) array
        Area of the layer in the cross-section, mm2.
    distance : float or (n,) array
        Distance of its outermost fibre from the neutral axis, mm; 0 at stations without the layer.
    """

    sheet: Sheet
    area: FloatArray
    distance: float | FloatArray


class Section(ABC):
    """Cross-section with a parameter, mm, that varies along the strip and determines its bending stiffness.

    The parameter is a width at fixed thickness, a thickness at fixed width, or a diameter. Other properties, such
    as the width of the base of a laminate, are fields of the section. The argument `section` of `optimal_rod`
    and `nearest_rod` needs a section whose parameter has limits.

    Attributes
    ----------
    quantity : str
        Name of the parameter, such as "width", "thickness" or "diameter".
    follows_bend : bool
        True if the stiffness depends on the curvature.
    """

    quantity: ClassVar[str]
    follows_bend: ClassVar[bool] = False

    @property
    @abstractmethod
    def limits(self) -> tuple[float, float]:
        """Least and largest value of the parameter, mm; 0 and infinity mean no limit."""

    @property
    def deciding_limit(self) -> float:
        """Limit that determines the scale of a rod: the largest value or, if there is none, the least, mm."""
        least, largest = self.limits
        return largest if np.isfinite(largest) else least

    @abstractmethod
    def bending_stiffness(self, parameter: ArrayLike, /) -> FloatArray:
        """Return E I (n,), N mm2, for parameters (n,), mm."""

    @abstractmethod
    def parameter(self, bending_stiffness: ArrayLike, /) -> FloatArray:
        """Return the parameters (n,), mm, for E I (n,), N mm2."""

    @abstractmethod
    def layers(self, parameter: ArrayLike, /) -> tuple[SectionLayer, ...]:
        """Return the layers of the section for parameters (n,), mm."""

    def axial_stiffness(self, parameter: ArrayLike) -> FloatArray:
        """Return E A (n,), N, for parameters (n,), mm."""
        return np.asarray(sum(layer.sheet.youngs_modulus * layer.area for layer in self.layers(parameter)))

    def weight_per_length(self, parameter: ArrayLike) -> FloatArray:
        """Return the weights per length (n,), N/mm, for parameters (n,), mm."""
        return np.asarray(sum(layer.sheet.specific_weight * layer.area for layer in self.layers(parameter)))

    def strains(
        self, curvature: ArrayLike, parameter: ArrayLike, *, natural_curvature: ArrayLike = 0.0
    ) -> tuple[LayerStrain, ...]:
        """Return the strain of each layer's outermost fibre: change of curvature times distance from the axis.

        Parameters
        ----------
        curvature, parameter : (n,) array_like
            Curvature, 1/mm, and parameter of the section, mm. Without a natural curvature, the sign of the
            curvature has no effect.
        natural_curvature : array_like
            Curvature before bending, 1/mm.
        """
        kappa, rest = alike(curvature=curvature, natural_curvature=natural_curvature)
        bend = np.abs(kappa - rest)
        return tuple(
            LayerStrain(layer.sheet, np.atleast_1d(layer.distance * bend)) for layer in self.layers(parameter)
        )

    def curvature_limit(self, parameter: ArrayLike) -> FloatArray:
        """Return the largest change of curvature (n,), 1/mm, that all layers withstand."""
        used = [np.asarray(layer.distance / layer.sheet.max_strain) for layer in self.layers(parameter)]
        return np.asarray(1 / np.max(used, axis=0))

    def with_sheet(self, sheet: Sheet) -> Self:
        """Return the section for another sheet, such as a sheet of another thickness."""
        return cast(Self, replace(cast(Any, self), sheet=sheet))

    @property
    def stack(self) -> "LaidLeaves | None":
        """Stack of glued plies; None for a single piece, or if the positions of the plies are unknown."""
        return None

    def bent(self, curvature: ArrayLike, rest: ArrayLike = 0.0) -> Self:  # noqa: ARG002 - see `follows_bend`
        """Return the section at stations (n,) that are bent by a change of curvature, 1/mm.

        `curvature` is the change kappa - kappa_0, and `rest` the natural curvature kappa_0. If bending has no
        effect on the section, the section itself is returned.
        """
        return self

    def curl(self, parameter: FloatArray) -> "BendFactor | None":  # noqa: ARG002 - see `follows_bend`
        """Return the effect of bending on the stiffness for parameters (n,), mm, or None without an effect."""
        return None


@dataclass(frozen=True)
class _PowerLaw(Section):
    """Section with E I = E c p^k for a parameter p, mm. The cross-section has the area a p^(k - 2).

    The property `_shape` contains k, c and a. The thickness of `sheet` is ignored.
    """

    sheet: Sheet
    least: float
    largest: float

    def __post_init__(self) -> None:
        require_record(self.sheet, Sheet, "the sheet of the section", 'a Sheet, such as Sheet.named("pom-1")')
        low, high = (require_number(value, f"{self.quantity} limit") for value in (self.least, self.largest))
        if not 0 < low <= high:
            raise InputError(
                "{quantity} limits are {low:g} and {high:g}: give the least first, such as 3 and 8",
                quantity=self.quantity,
                low=BareLength(low),
                high=Length(high),
            )

    def with_sheet(self, sheet: Sheet) -> Self:
        """Return the section for another thickness of the sheet, with limits in proportion to the thickness."""
        factor = sheet.thickness / self.sheet.thickness
        return replace(self, sheet=sheet, least=factor * self.least, largest=factor * self.largest)

    @property
    @abstractmethod
    def _shape(self) -> tuple[int, float, float]: ...

    @property
    def limits(self) -> tuple[float, float]:
        return self.least, self.largest

    def bending_stiffness(self, parameter: ArrayLike) -> FloatArray:
        power, inertia, _ = self._shape
        return np.asarray(self.sheet.youngs_modulus * inertia * positive(parameter, self.quantity) ** power)

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        power, inertia, _ = self._shape
        EI = positive(bending_stiffness, "bending stiffness")
        return np.asarray((EI / (self.sheet.youngs_modulus * inertia)) ** (1 / power))

    def layers(self, parameter: ArrayLike) -> tuple[SectionLayer, ...]:
        power, _, area = self._shape
        size = positive(parameter, self.quantity)
        return (SectionLayer(self.sheet, area * size ** (power - 2), size / 2),)


@dataclass(frozen=True)
class ThicknessLaw(_PowerLaw):
    """Strip of constant width w with variable thickness t: E I = E w t^3 / 12, weight proportional to t.

    Parameters
    ----------
    sheet : Sheet
        Sheet with the modulus, density and largest strain of the material; its thickness is ignored.
    least, largest : float
        Limits of the thickness, mm.
    width : float
        Width of the strip, mm.

    Examples
    --------
    >>> section = ThicknessLaw(Sheet("rod", 1.0, 12.0, density=1000.0, max_strain=0.01), 3.0, 8.0, width=10.0)
    >>> section.bending_stiffness(4.0).item(), round(section.parameter(640.0).item(), 9)
    (640.0, 4.0)
    """

    quantity = "thickness"
    width: float = 10.0

    def __post_init__(self) -> None:
        super().__post_init__()
        if not require_number(self.width, "width") > 0:
            raise InputError("width is {width:g}: give a positive width, in mm", width=self.width)

    @property
    def _shape(self) -> tuple[int, float, float]:
        return 3, self.width / 12, self.width


@dataclass(frozen=True)
class RoundLaw(_PowerLaw):
    """Round rod or tube with variable outer diameter d: E I proportional to d^4, weight to d^2.

    Parameters
    ----------
    sheet : Sheet
        Sheet with the modulus, density and largest strain of the material; its thickness is ignored.
    least, largest : float
        Limits of the outer diameter, mm.
    bore : float
        Ratio of inner to outer diameter, from 0 (a rod) to below 1.

    Examples
    --------
    >>> section = RoundLaw(Sheet("rod", 1.0, 64.0, density=1000.0, max_strain=0.01), 2.0, 8.0)
    >>> round(section.bending_stiffness(2.0).item() / np.pi, 9)
    16.0
    """

    quantity = "diameter"
    bore: float = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 0 <= require_number(self.bore, "bore") < 1:
            raise InputError(
                f"`bore` is {self.bore:g}: give the ratio of inner to outer diameter, from 0 (a solid rod) "
                "to below 1"
            )

    @property
    def _shape(self) -> tuple[int, float, float]:
        return 4, np.pi / 64 * (1 - self.bore**4), np.pi / 4 * (1 - self.bore**2)


@dataclass(frozen=True)
class LeavesLaw(Section):
    """Stack of glued plies of a sheet: E I = E w (k h)^3 / 12 for k plies.

    The stiffness jumps at the end of each ply, so a stack only approximates a curve. Use the section with
    `nearest_rod`, not `optimal_rod`.

    Parameters
    ----------
    sheet : Sheet
        Sheet of a ply, of thickness h; the thickness of the glue is neglected.
    leaves : int
        Largest number of plies in the stack.
    width : float
        Width w of the stack, mm.
    fewest : int
        Number of plies over the full length, which is the least number at any station.

    Examples
    --------
    >>> section = LeavesLaw(Sheet("leaf", 2.0, 12.0, density=1000.0, max_strain=0.01), 4, width=10.0)
    >>> section.bending_stiffness([1, 2, 4]).tolist(), section.relaxed.limits
    ([80.0, 640.0, 5120.0], (2.0, 8.0))
    """

    quantity = "leaves"
    sheet: Sheet
    leaves: int
    width: float
    fewest: int = 1

    def __post_init__(self) -> None:
        require_record(self.sheet, Sheet, "the sheet of the plies", 'a Sheet, such as Sheet.named("pom-1")')
        if not is_whole(self.leaves) or not 2 <= self.leaves <= MOST_LEAVES:
            raise InputError(f"`leaves` is {self.leaves!r}: give the number of plies, 2 to {MOST_LEAVES}")
        if not is_whole(self.fewest) or not 1 <= self.fewest <= self.leaves:
            raise InputError(f"`fewest` is {self.fewest!r}: give a whole number of plies, 1 to {self.leaves}")
        _ = self.relaxed  # the property refuses an invalid width

    @property
    def limits(self) -> tuple[float, float]:
        """Least and largest number of plies."""
        return float(self.fewest), float(self.leaves)

    @cached_property
    def relaxed(self) -> ThicknessLaw:
        """Section of the same stack with a continuous thickness, from `fewest` plies to all plies."""
        h = self.sheet.thickness
        return ThicknessLaw(self.sheet, self.fewest * h, self.leaves * h, width=self.width)

    def bending_stiffness(self, count: ArrayLike) -> FloatArray:
        """Return E I (n,), N mm2, for numbers of plies `count` (n,)."""
        return self.relaxed.bending_stiffness(self.thickness(count))

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Return the numbers of plies (n,), not rounded, for E I (n,), N mm2."""
        return self.relaxed.parameter(bending_stiffness) / self.sheet.thickness

    def layers(self, count: ArrayLike) -> tuple[SectionLayer, ...]:
        """Return the plies as one layer, because glued plies bend as a single section."""
        return self.relaxed.layers(self.thickness(count))

    def thickness(self, count: ArrayLike) -> FloatArray:
        """Return the thickness (n,), mm, of `count` (n,) plies."""
        return np.asarray(self.sheet.thickness * numbers(count, "the count of leaves"))

    def laid(self, leaves: Sequence["Leaf"]) -> "LaidLeaves":
        """Return the section of a stack whose plies `leaves` have fixed positions."""
        thick = self.relaxed
        return LaidLeaves(self.sheet, thick.least, thick.largest, width=self.width, leaves=tuple(leaves))


@dataclass(frozen=True)
class Leaf:
    """Ply of a stack, or piece of a ply, from arc length `start` to `end`, mm.

    `number` is the index of the ply in the stack, from 1. Ply 1 has the full length.
    """

    number: int
    start: float
    end: float

    @property
    def length(self) -> float:
        """Length of the ply, mm."""
        return self.end - self.start


@dataclass(frozen=True)
class LaidLeaves(ThicknessLaw):
    """Stack of glued plies with fixed positions; its thickness has steps.

    Parameters
    ----------
    sheet, least, largest, width
        As in `ThicknessLaw`; `sheet` is the sheet of each ply.
    leaves : tuple of Leaf
        Plies over the full length first, then the other plies in the order of their indices.
    """

    leaves: tuple[Leaf, ...] = ()

    @property
    def stack(self) -> "LaidLeaves":
        """Stack of glued plies: the section itself."""
        return self

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the plies or pieces: the index of the ply from 1, and a letter if the ply has several pieces."""
        numbers = [leaf.number for leaf in self.leaves]
        return tuple(
            f"{number}{chr(ord('a') + numbers[:i].count(number)) if numbers.count(number) > 1 else ''}"
            for i, number in enumerate(numbers)
        )

    @property
    def steps(self) -> FloatArray:
        """Arc lengths (m,), mm, at which plies begin or end inside the stack."""
        length = max(leaf.end for leaf in self.leaves)
        places = {s for leaf in self.leaves for s in (leaf.start, leaf.end) if 0 < s < length}
        return np.array(sorted(places))

    def counts(self, s: ArrayLike) -> FloatArray:
        """Return the number of plies (n,) at arc lengths (n,), mm."""
        length = max(leaf.end for leaf in self.leaves)
        inside = np.minimum(np.asarray(s, dtype=float), np.nextafter(length, 0.0))
        lie = [(leaf.start <= inside) & (inside < leaf.end) for leaf in self.leaves]
        return np.asarray(np.sum(lie, axis=0), dtype=float)


SAME_SCALE = 1e-4
"""Bending stiffnesses that differ by a smaller fraction count as equal; optimal rods are not more accurate."""

BETWEEN_NODES = 1e-3
"""If only the nodes are limited, the stiffness may exceed its limit between nodes by this fraction."""


# the schema describes a table by the docstring of its function, so each docstring names the result
def _thickness(
    sheet: Sheet,
    limits: Annotated[tuple[float, float], Option("Least and largest thickness.", "mm", least=0)],
    width: Annotated[float, Option("Width of the batten.", "mm", least=0)],
) -> ThicknessLaw:
    """A batten of constant width whose thickness is tapered by planing."""
    return ThicknessLaw(sheet, *limits, width=width)


def _rod(
    sheet: Sheet, limits: Annotated[tuple[float, float], Option("Least and largest diameter.", "mm", least=0)]
) -> RoundLaw:
    """A round rod whose diameter is tapered by turning."""
    return RoundLaw(sheet, *limits)


def _tube(
    sheet: Sheet,
    limits: Annotated[tuple[float, float], Option("Least and largest outer diameter.", "mm", least=0)],
    bore: Annotated[float, Option("Inner diameter divided by outer diameter.", least=0, most=1)],
) -> RoundLaw:
    """A tube whose outer diameter is tapered by turning."""
    return RoundLaw(sheet, *limits, bore=bore)


def _leaves(
    sheet: Sheet,
    leaves: Annotated[int, Option("Largest number of plies of the sheet.", least=2)],
    width: Annotated[float, Option("Width of the plies.", "mm", least=0)],
    fewest: Annotated[int, Option("Number of plies that run over the whole length.", least=1)] = 1,
) -> LeavesLaw:
    """Glued plies of the sheet, of different lengths. Such a strip needs the key `limits` or `keep`."""
    return LeavesLaw(sheet, leaves, width, fewest)


SECTION_KINDS: dict[str, Callable[..., Section]] = {
    "thickness": _thickness, "rod": _rod, "tube": _tube, "leaves": _leaves,
}  # fmt: skip
"""Functions that make a section from its table in a file, by the value of its key `kind`."""


def require_section(section: object) -> None:
    """Raise InputError for a value that is not a `Section` with limits."""
    if not isinstance(section, Section) or section.limits == (0.0, np.inf):
        raise InputError(
            "{name} is {given}: give a record with limits, such as ThicknessLaw(sheet, 3, 8, width=20)",
            name=FieldName("section"), given=quoted(section), where={"field": "section"},
        )  # fmt: skip


class BendFactor(Protocol):
    """Function from the curvatures of the stations of a strip to factors (n,) on their stiffness."""

    def __call__(self, curvature: FloatArray, /) -> FloatArray:
        """Return the factors of the stations (..., n) for their curvatures (..., n), 1/mm."""

    def resampled(self, s: FloatArray, at: FloatArray, /) -> Self:
        """Return the function for stations at arc lengths `at` (m,), mm, by interpolation from `s` (n,), mm."""


Values = TypeVar("Values", float, FloatArray, float | FloatArray)


def at_stations(values: Values, s: FloatArray, at: FloatArray) -> Values:
    """Interpolate values (..., n) from arc lengths `s` (n,) to `at` (m,), mm; return a single number unchanged.

    Examples
    --------
    >>> s = np.array([0.0, 2.0])
    >>> at_stations(s**2, s, np.array([0.0, 1.0, 2.0])).tolist(), at_stations(3.0, s, s)
    ([0.0, 2.0, 4.0], 3.0)
    """
    if np.ndim(values) == 0:
        return values
    return cast("Values", np.apply_along_axis(lambda row: np.interp(at, s, row), -1, values))


def scale_within(
    section: Section, stiffness: FloatArray, *, solved: float | None = None, heavy: bool = False
) -> float:
    """Return the bending stiffness B, N mm2, with which a rod reaches the limits of its section.

    The largest section along the rod is at the upper limit. Without an upper limit, the least section is
    at the lower limit.

    Parameters
    ----------
    section : Section
        Section at the stations in their bent state.
    stiffness : (n,) array
        Relative stiffness of the stations.
    solved : float, optional
        B of a rod that is already in equilibrium. This value is returned for a rod with weight (`heavy`), which is
        in equilibrium only with the weight of its sections. It is also returned if it is below the limit, because
        another limit, such as the strain, may determine it.
    """
    limited = bool(np.isfinite(section.limits[1]))
    scales = section.bending_stiffness(np.full(stiffness.size, section.deciding_limit)) / stiffness
    B = float(scales.min() if limited else scales.max())
    if solved is None:
        return B
    bounded = limited and solved < B
    # a search limits the section only at the nodes, so the section may be slightly beyond the limit between nodes
    over = 1 < (solved / B if limited else B / solved) < 1 + BETWEEN_NODES
    unchanged = (heavy and not over) or bounded or abs(B / solved - 1) < SAME_SCALE
    return solved if unchanged else B
