"""What the optimiser knows of a problem: values, local models and one-sided bounds of unknowns in a box.

A point has unknowns z and a state that follows from them by equations (z alone decides a closed point). Search
runs over points that are not quite closed: what it is told of one is to first order what holds once it is closed.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Generic, TypeVar

from elastica_cad._types import BoolArray, FloatArray, IntArray

Point = TypeVar("Point")


@dataclass(frozen=True, eq=False)
class LocalModel:
    """value + h^T d + d^T H d / 2, plus the largest of peaks + peak_rows d where there are peaks.

    Attributes
    ----------
    value : float
    hessian, gradient : (p, p), (p,) arrays
    peaks, peak_rows : (k,), (k, p) arrays
        Empty for smooth objectives.
    """

    value: float
    hessian: FloatArray
    gradient: FloatArray
    peaks: FloatArray
    peak_rows: FloatArray


@dataclass(frozen=True, eq=False)
class ConstraintRows:
    """The constraints' rows that matter near a point, stacked: value + jacobian @ step.

    Attributes
    ----------
    constraint, index : (j,) arrays
        The number of each row's constraint, and its place among the values of that.
    value : (j,) array
        Once the point is closed, where the rows come from a linearization.
    jacobian : (j, p) array
    price : (j,) array
        The most that breaking a row by 1 costs.
    one_sided : (j,) boolean array
        At least 0, not 0.
    """

    constraint: IntArray
    index: IntArray
    value: FloatArray
    jacobian: FloatArray
    price: FloatArray
    one_sided: BoolArray


@dataclass(frozen=True, eq=False)
class Linearization(Generic[Point]):
    """A point and what changes (p + 1,) do to it; their last entry is the share of closing it.

    Attributes
    ----------
    point : Point
    z : (p,) array
        Its unknowns.
    rows : ConstraintRows
        Constraints in steps (p,) from the closed point.
    modelled : callable
        The objective in the same steps, computed where it is asked for: see `model`.
    state_jacobian : (k, p + 1) array
        Of the part of the state that tells how far linearity holds, in numbers of order 1 where it ends.
    moved : callable
        The point after a change, its unknowns within their box, to first order.
    """

    point: Point
    z: FloatArray
    rows: ConstraintRows
    modelled: Callable[[], LocalModel]
    state_jacobian: FloatArray
    moved: Callable[[FloatArray], Point]

    @cached_property
    def model(self) -> LocalModel:
        """The objective in steps (p,) from the closed point."""
        return self.modelled()


@dataclass(frozen=True, eq=False)
class NonlinearProgram(ABC, Generic[Point]):
    """Minimise an objective over unknowns in a box under constraints.

    Attributes
    ----------
    lower, upper : (p,) arrays
        Equal where an unknown is given.
    scale : (p,) array
        Typical sizes of the unknowns.
    """

    lower: FloatArray
    upper: FloatArray
    scale: FloatArray

    @property
    @abstractmethod
    def one_sided(self) -> BoolArray:
        """Of each constraint (c,): are its values at least 0, not 0?"""

    @property
    @abstractmethod
    def highest_prices(self) -> FloatArray:
        """The most (c,) that breaking a value of each constraint by 1 costs."""

    @abstractmethod
    def objective(self, point: Point) -> float:
        """The number to be minimised."""

    @abstractmethod
    def values(self, point: Point) -> Sequence[FloatArray]:
        """Values of each constraint."""

    @abstractmethod
    def rows(self, point: Point, values: Sequence[FloatArray]) -> tuple[FloatArray, ConstraintRows]:
        """The unknowns of a closed point with these values, and the constraints in steps between closed points."""

    @abstractmethod
    def linearize(self, point: Point) -> Linearization[Point] | None:
        """The point, closed or not, with its derivatives; None where they are no numbers to go by."""

    @abstractmethod
    def close(self, point: Point, step: FloatArray | None = None) -> Point | None:
        """The closed point of the unknowns of `point`, after a step (p,) in the box; None where there is none."""

    @abstractmethod
    def clip(self, point: Point) -> Point:
        """The point with its unknowns moved into the box, its state as it is."""

    @abstractmethod
    def fallback(self) -> Point:
        """A closed point, where the search has no other."""

    @abstractmethod
    def apart(self, one: Point, other: Point) -> float:
        """The distance of two points, comparable with the objective."""

    @abstractmethod
    def for_open_points(self) -> "NonlinearProgram[Point]":
        """The same without the constraints that make no sense for points far from closed."""
