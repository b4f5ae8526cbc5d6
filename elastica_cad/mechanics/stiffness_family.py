"""All stiffness profiles that balance a drawn curve, and the one of least ratio on the continuous curve."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.mechanics.gravity_lp import least_variation
from elastica_cad.mechanics.minimax_lp import MinimaxSolution, Solver, minimax_ratio
from elastica_cad.mechanics.panels import NODES, WEIGHTS, PanelFunction, Panels

__all__ = ["StiffnessFamily", "dense_places", "extreme_places", "least_ratio", "smoothest", "wrong_places"]

DENSE = np.concatenate([[-1.0], np.cos(np.pi * (np.arange(1, 24)[::-1] / 24)), [1.0]])
"""Places in each panel at which bounds are first watched."""


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
    side_rows : (k, d) array or None
        Conditions side_rows @ y >= 0.
    """

    panels: Panels
    rows: PanelFunction
    offset: PanelFunction | None = None
    side_rows: FloatArray | None = None

    @property
    def freedom(self) -> int:
        """Number of free numbers."""
        return int(self.rows.coefficients.shape[2])

    def at(self, panel: IntArray, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Rows (n, d) and offsets (n,) at places x (n,) of panels (n,)."""
        offset = np.zeros(len(x)) if self.offset is None else self.offset.at(panel, x)
        return self.rows.at(panel, x), offset

    def stiffness(self, y: FloatArray) -> PanelFunction:
        """K of the numbers y."""
        K = self.rows.combined(y)
        return K if self.offset is None else PanelFunction(K.coefficients + self.offset.coefficients)


def dense_places(panels: Panels) -> tuple[IntArray, FloatArray]:
    """Panel numbers and places x of a dense sampling, panel ends included."""
    return np.repeat(np.arange(panels.count), DENSE.size), np.tile(DENSE, panels.count)


def least_ratio(
    family: StiffnessFamily,
    places: tuple[IntArray, FloatArray] | None = None,
    *,
    solver: Solver = "auto",
    tolerance: float = 1e-9,
) -> tuple[FloatArray, float] | None:
    """The numbers y of least R, or None where no stiffness is positive everywhere.

    Unless `places` (panel, x) fix the samples, R is judged on the continuous curve: extremes of K between the
    samples are found on its polynomials and join the program until R moves by less than `tolerance`.
    """
    watch = places is None
    panel, x = dense_places(family.panels) if places is None else places
    rows, offset = family.at(panel, x)
    solution = _solved(family, rows, offset, solver)
    while solution is not None and watch:
        panel, x = extreme_places(family.stiffness(solution.x), dense_places(family.panels))
        more, more_offset = family.at(panel, x)
        K = more @ solution.x + more_offset
        exact = K.max() / min(1.0, K.min())
        if K.min() >= 1 - tolerance and K.max() <= solution.ratio * (1 + tolerance):
            return solution.x, float(max(exact, solution.ratio))
        rows, offset = np.concatenate([rows, more]), np.concatenate([offset, more_offset])
        solution = _solved(family, rows, offset, solver)
    return None if solution is None else (solution.x, solution.ratio)


def smoothest(family: StiffnessFamily, ratio: float) -> FloatArray:
    """The numbers y of least total variation of K' with K between 1 and `ratio` (paper, section 5.3)."""
    panels = family.panels
    count, order = panels.t.shape
    # d/ds = d/dx / stretch, twice; jumps of K' at the panel ends count too
    to_slopes = np.linalg.solve(
        np.polynomial.legendre.legvander(NODES, order - 1).T, _derivative_rows(NODES).T
    ).T
    to_ends = np.linalg.solve(
        np.polynomial.legendre.legvander(NODES, order - 1).T,
        np.polynomial.legendre.legvander(np.array([-1.0, 1.0]), order - 1).T,
    ).T
    columns = family.rows.coefficients
    if family.offset is not None:
        columns = np.concatenate([columns, family.offset.coefficients[..., None]], axis=2)
    nodal = np.einsum("ij,njm->nim", np.polynomial.legendre.legvander(NODES, order - 1), columns)
    slope = np.einsum("ij,njm->nim", to_slopes, nodal) / panels.stretch[..., None]
    bend = np.einsum("ij,njm->nim", to_slopes, slope) * WEIGHTS[:, None]
    at_ends = np.einsum("ij,njm->nim", to_ends, slope)
    jumps = at_ends[1:, 0] - at_ends[:-1, 1]
    bends = np.concatenate([bend.reshape(count * order, -1), jumps])
    d = family.freedom
    bend_offset = bends[:, d] if family.offset is not None else np.zeros(len(bends))
    rows, offset = family.at(*dense_places(family.panels))
    for _ in range(4):
        y = least_variation(rows, offset, bends[:, :d], bend_offset, ratio)
        more, more_offset = family.at(*extreme_places(family.stiffness(y), dense_places(family.panels)))
        K = more @ y + more_offset
        if K.min() >= 1 - 1e-9 and K.max() <= ratio * (1 + 1e-9):
            break
        rows, offset = np.concatenate([rows, more]), np.concatenate([offset, more_offset])
    return y


def wrong_places(family: StiffnessFamily) -> FloatArray:
    """Arc lengths (k,), mm, that no choice of the numbers can make positive together.

    Where one number is free these are the stretches of the lesser sign; otherwise the samples that hold the
    largest possible least value of K down.
    """
    from scipy.optimize import linprog

    panel, x = dense_places(family.panels)
    rows, offset = family.at(panel, x)
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


def _solved(
    family: StiffnessFamily, rows: FloatArray, offset: FloatArray, solver: Solver
) -> MinimaxSolution | None:
    return minimax_ratio(rows, offset=offset, side_rows=family.side_rows, solver=solver)


def _derivative_rows(x: FloatArray) -> FloatArray:
    """Derivatives (n, p) of the Legendre polynomials at x."""
    order = NODES.size
    identity = np.eye(order)
    return np.stack(
        [np.polynomial.legendre.legval(x, np.polynomial.legendre.legder(identity[i])) for i in range(order)],
        axis=1,
    )


def extreme_places(
    K: PanelFunction, dense: tuple[IntArray, FloatArray], steps: int = 3
) -> tuple[IntArray, FloatArray]:
    """Places of the local extremes of K near its largest and least value, by Newton's method from samples."""
    panel, x = dense
    values = K.at(panel, x)
    table = values.reshape(-1, DENSE.size)
    inner = np.zeros_like(table, dtype=bool)
    middle, before, after = table[:, 1:-1], table[:, :-2], table[:, 2:]
    inner[:, 1:-1] = ((middle >= before) & (middle >= after)) | ((middle <= before) & (middle <= after))
    low, high = values.min(), values.max()
    band = 0.05 * (high - low)
    near = inner.ravel() & ((values > high - band) | (values < low + band))
    # the worst samples stay in, ends of panels among them
    near[[int(values.argmin()), int(values.argmax())]] = True
    panel, x = panel[near], x[near]
    start = x.copy()
    for _ in range(steps):
        slope, curvature = K.slopes_at(panel, x)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where(curvature != 0, -slope / curvature, 0.0)
        x = np.clip(
            np.where(np.isfinite(step), x + step, x),
            np.maximum(start - 0.15, -1),
            np.minimum(start + 0.15, 1),
        )
    return np.concatenate([panel, panel]), np.concatenate([start, x])
