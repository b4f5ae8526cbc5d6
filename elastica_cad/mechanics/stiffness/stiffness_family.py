"""All stiffness profiles that balance a drawn curve, and the one of least ratio on the continuous curve."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.polynomials.panel_functions import (
    DENSE_PARTS,
    SLOPES,
    VANDER,
    WEIGHTS,
    PanelFunction,
    in_panels,
)
from elastica_cad.mechanics.stiffness.minimax_lp import (
    METHOD,
    MinimaxProgram,
    MinimaxSolution,
    minimax_ratio,
    start_rows,
    unsettled,
)
from elastica_cad.mechanics.stiffness.quadrature_panels import Panels
from elastica_cad.mechanics.stiffness.stiffness_smoothing import largest_number, least_variation

_SLOPES_AT_NODES = VANDER @ SLOPES

_SETTLED = 1e-9  # of the least ratio, by which it may still move

_SAME = 4 * float(np.finfo(float).eps)
"""Share of the numbers by which two solutions of one program differ, where its vertex is reached by another way."""

_ROUNDING = 16 * float(np.finfo(float).eps)  # of the terms of a sum: three factors and a series

BOUNDED = 1e-7
"""Relative excess over its bounds that a smooth stiffness may have: the accuracy of its linear program."""


@dataclass(frozen=True, eq=False)
class StiffnessFamily:
    """K = rows @ y + offset with d free numbers y, as piecewise polynomials over panels.

    Attributes
    ----------
    panels : Panels
    rows : PanelFunction
        Coefficients (N, p, d).
    offset : PanelFunction or None
        Coefficients (N, p); None when K is homogeneous in y.
    side_rows, side_offset : (k, d), (k,) arrays or None
        Conditions side_rows @ y + side_offset >= 0; an offset of None is 0.
    """

    panels: Panels
    rows: PanelFunction
    offset: PanelFunction | None = None
    side_rows: FloatArray | None = None
    side_offset: FloatArray | None = None

    @property
    def freedom(self) -> int:
        """Number of free numbers."""
        return int(self.rows.coefficients.shape[2])

    def at(self, panel: IntArray, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Rows (n, d) and offsets (n,) at places x (n,) of panels (n,)."""
        offset = np.zeros(len(x)) if self.offset is None else self.offset.at(panel, x)
        return self.rows.at(panel, x), offset

    @cached_property
    def dense(self) -> tuple[FloatArray, FloatArray]:
        """Rows and offsets at `Panels.dense_places`."""
        rows = self.rows.dense
        return rows, np.zeros(len(rows)) if self.offset is None else self.offset.dense

    def extremes(self, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Rows and offsets where K of the numbers y has its extremes, and at the samples beside them."""
        panel, sample, x = self.stiffness(y).found_extremes
        rows, offset = self.dense
        beside = panel * (DENSE_PARTS + 1) + sample
        rows = np.concatenate([rows[beside], self.rows.at(panel, x)])
        if self.offset is None:
            return rows, np.zeros(len(rows))
        return rows, np.concatenate([offset[beside], self.offset.at(panel, x)])

    def stiffness(self, y: FloatArray) -> PanelFunction:
        """K of the numbers y."""
        K = self.rows.combined(y)
        return K if self.offset is None else PanelFunction(K.coefficients + self.offset.coefficients)


def least_ratio(
    family: StiffnessFamily, places: tuple[IntArray, FloatArray] | None = None
) -> tuple[FloatArray, float] | None:
    """The numbers y of least R, or None where no stiffness is positive everywhere.

    Unless `places` (panel, x) fix the samples, R is judged on the continuous curve: extremes of K between the
    samples are found on its polynomials and join the program until R settles.
    """
    if places is not None:
        solution = _sampled(family, *family.at(*places))
    elif family.freedom == 0 or (family.freedom == 1 and family.offset is None):
        # no number, or one that only scales K: the extremes stay where they are
        rows, offset = family.dense
        more, more_offset = family.extremes(np.ones(family.freedom))
        solution = _sampled(family, np.concatenate([rows, more]), np.concatenate([offset, more_offset]))
    else:
        return _continuous_ratio(family)
    return None if solution is None else (solution.x, solution.ratio)


def _sampled(family: StiffnessFamily, rows: FloatArray, offset: FloatArray) -> MinimaxSolution | None:
    return minimax_ratio(rows, offset=offset, side_rows=family.side_rows, side_offset=family.side_offset)


def _continuous_ratio(family: StiffnessFamily) -> tuple[FloatArray, float] | None:
    """The least R, all local extremes that exceed it being added in each round."""
    rows, offset = family.dense
    program = MinimaxProgram(rows, side_rows=family.side_rows, side_offset=family.side_offset)
    tolerance = _SETTLED
    program.demand(rows, offset, rows, offset)
    before = np.full(family.freedom, np.nan)
    for _ in range(METHOD.most_rounds):
        answer = program.solve()
        if answer is None:
            return None
        y, ratio = answer
        rows, offset = family.extremes(y)
        values = rows @ y + offset
        rounded: FloatArray | float = 0.0
        if np.abs(y - before).max() <= _SAME * np.abs(y).max():
            # what is beyond its bounds still is so by the solver's own tolerance
            tolerance = BOUNDED
            rounded = _ROUNDING * (np.abs(rows) @ np.abs(y))  # or because large terms cancel
        before = y
        low = (values < 1 - tolerance - rounded).nonzero()[0]
        high = (values > ratio * (1 + tolerance) + rounded).nonzero()[0]
        if not (low.size or high.size):
            if values.min() <= 0:  # all that would be positive drowns in rounding
                return None
            return y, float(max(values.max() / min(1.0, values.min()), ratio))
        program.demand(rows[low], offset[low], rows[high], offset[high])
    raise unsettled(ratio)


def smoothest(
    family: StiffnessFamily, ratio: float, places: tuple[IntArray, FloatArray] | None = None
) -> FloatArray:
    """The numbers y of least total variation of K' with K between 1 and `ratio` (paper, section 5.3).

    As by `least_ratio`, K is judged on the continuous curve unless `places` (panel, x) fix the samples.
    """
    panels = family.panels
    count, order = panels.t.shape
    # d/ds = d/dx / stretch, twice; jumps of K' at the panel ends count too
    columns = family.rows.coefficients
    if family.offset is not None:
        columns = np.concatenate([columns, family.offset.coefficients[..., None]], axis=2)
    slope = in_panels(_SLOPES_AT_NODES, columns) / panels.stretch[..., None]
    slopes = PanelFunction.through(slope)
    bend = in_panels(_SLOPES_AT_NODES, slopes.coefficients) * WEIGHTS[:, None]
    before, after = slopes.where_panels_meet
    bends = np.concatenate([bend.reshape(count * order, -1), after - before])
    d = family.freedom
    bend_offset = bends[:, d] if family.offset is not None else np.zeros(len(bends))
    if places is not None:
        return least_variation(*family.at(*places), bends[:, :d], bend_offset, ratio)
    return _bounded(
        family, ratio, lambda rows, offset: least_variation(rows, offset, bends[:, :d], bend_offset, ratio)
    )


def largest_within(family: StiffnessFamily, number: FloatArray, ratio: float) -> FloatArray:
    """The numbers y of the largest number @ y, of a family without offset, with K between 1 and `ratio`."""
    return _bounded(family, ratio, lambda rows, _: largest_number(rows, number, ratio))


def _bounded(
    family: StiffnessFamily, ratio: float, best: Callable[[FloatArray, FloatArray], FloatArray]
) -> FloatArray:
    """The best numbers y with K between 1 and `ratio` on the continuous curve.

    `best` gives those of rows and offsets at places; the extremes of its K are added until it keeps within.
    """
    rows, offset = family.dense
    first = start_rows(len(rows))
    rows, offset = rows[first], offset[first]
    for _ in range(METHOD.most_rounds):
        y = best(rows, offset)
        more, more_offset = family.extremes(y)
        K = more @ y + more_offset
        if K.min() >= 1 - BOUNDED and K.max() <= ratio * (1 + BOUNDED):
            return y
        rows, offset = np.concatenate([rows, more]), np.concatenate([offset, more_offset])
    raise unsettled(ratio)


def find_violations(family: StiffnessFamily) -> FloatArray:
    """Arc lengths (k,), mm, that no choice of the numbers can make positive together.

    Where one number is free these are the stretches of the lesser sign; otherwise the samples that hold the
    largest possible least value of K down.
    """
    from scipy.optimize import linprog

    panel, x = family.panels.dense_places()
    rows, offset = family.dense
    s = family.panels.arc_length(panel, x)
    d = family.freedom
    if d == 0:
        return np.asarray(s[offset <= 0])
    size = np.maximum(np.abs(rows).max(axis=1), 1e-300)
    if d == 1 and family.offset is None:
        sign = rows[:, 0] > 0
        return np.asarray(s[sign != (sign.mean() >= 0.5)])
    scaled = rows / size[:, None]
    matrix = np.column_stack([-scaled, np.ones(len(s))])
    bounds = [(-1.0, 1.0)] * d + [(None, None)]
    result = linprog(np.append(np.zeros(d), -1.0), matrix, offset / size, bounds=bounds, method="highs")
    if result.status != 0:
        return np.zeros(0)
    return np.asarray(s[np.abs(result.ineqlin.marginals) > 1e-9])
