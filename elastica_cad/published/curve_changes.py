"""What small moves of the control points do to stiffness, shape and stability, along equilibrium curves.

The map from control points q to stiffness exists only where the inflections are collinear (paper, section
6.4), so everything is expressed in a basis of the tangent space of that set: moves u of the control points
and of the line a + <b, x> = 0 together, under which the inflections stay on the line and what is to be kept
stays.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.forming.equilibrium_curve import EquilibriumCurve
from elastica_cad.geometry.curve_editing.control_point_constraints import (
    Constraint,
    InflectionsOnLine,
    curvature_rows,
    directed_rows,
)
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.panel_functions import LEFT, NODES, WEIGHTS, PanelFunction

_ALONG = 0.1  # a move along the curve counts this much of one across it
_BEND = 0.005  # a move that changes the curvature by 1 / length counts as this share of the length
_STRETCH = 0.05  # one that changes the velocity d/dt by all of itself counts as this share of the length
_LINE_STEP = 0.02  # moves of the line that count as much as moving the curve by this share of its length
_RANK = 1e-11  # of the largest singular value: changes below it are none


@dataclass(frozen=True, eq=False)
class CurveChanges:
    """First-order changes of an equilibrium curve of length l in r tangent coordinates u.

    |u| is about the root mean square move of the curve. The scale of the moment is held, so that K moves
    freely up and down.

    Parameters
    ----------
    state : EquilibriumCurve
    constraints : sequence of Constraint
        What stays, beside the inflections on their line.
    """

    state: EquilibriumCurve
    constraints: Sequence[Constraint]

    @cached_property
    def _t(self) -> FloatArray:
        """Gauss nodes: never on an inflection."""
        return self.state.balance.panels.t.ravel()

    @cached_property
    def distance_rows(self) -> FloatArray:
        """Rows (2 g, 2 m) whose product with a move has as square sum the weighted mean square distance.

        First the moves across the curve at all Gauss nodes, then `_ALONG` times those along it.
        """
        return self._weighted(self._frame)

    @cached_property
    def _frame(self) -> tuple[FloatArray, FloatArray]:
        d1 = self.state.curve.evaluate(self._t, 1)
        tangent = d1 / np.linalg.norm(d1, axis=1, keepdims=True)
        return np.column_stack([-tangent[:, 1], tangent[:, 0]]), _ALONG * tangent

    def _weighted(self, directions: tuple[FloatArray, FloatArray]) -> FloatArray:
        basis = self.state.curve.basis(self._t)
        return np.concatenate([directed_rows(basis, d * self._root_share) for d in directions])

    @cached_property
    def _root_share(self) -> FloatArray:
        panels = self.state.balance.panels
        return np.sqrt((panels.stretch * WEIGHTS).ravel() / self.state.curve.length)[:, None]

    def offsets(self, target: PlaneCurve) -> FloatArray:
        """The present distance (2 g,) from a curve with the same parameter, weighted as `distance_rows`."""
        off = self.state.curve.evaluate(self._t) - target.evaluate(self._t)
        return np.concatenate([(off * d * self._root_share).sum(axis=1) for d in self._frame])

    @cached_property
    def basis(self) -> FloatArray:
        """Moves of control points and line, (2 m + 3, r): columns dq (x and y in turn), da, db."""
        curve = self.state.curve
        a, b = self.state.line
        count = curve.control_points.size
        zeros = np.array([z.t for z in self.state.check.zeros])
        held = [c.equations(curve)[1] for c in self.constraints]
        rows = [np.pad(row, ((0, 0), (0, 3))) for row in held]
        if zeros.size:
            _, moved = InflectionsOnLine(a, b, zeros).equations(curve)
            rows.append(np.column_stack([moved, np.ones(zeros.size), curve.evaluate(zeros)]))
        size, length = np.abs(self._moment).max(), curve.length
        centre = curve.evaluate(self._t).mean(axis=0)
        # the line in numbers of order 1: moment at the middle of the curve, and its slope
        line = np.array(
            [[1.0, -centre[0] / length, -centre[1] / length], [0, 1 / length, 0], [0, 0, 1 / length]]
        )
        line *= size / (_LINE_STEP * length)
        rows.append(np.concatenate([np.zeros(count), np.linalg.inv(line) @ [a, *b]])[None] @ np.block(
            [[np.eye(count), np.zeros((count, 3))], [np.zeros((3, count)), np.linalg.inv(line)]]
        ))  # fmt: skip
        bends = curvature_rows(curve, self._t) * (self._root_share * _BEND * length**2)
        d1, slope = curve.evaluate(self._t, 1), curve.basis(self._t, 1)
        share = self._root_share * (_STRETCH * length) / (d1**2).sum(axis=1, keepdims=True)
        turned = np.column_stack([-d1[:, 1], d1[:, 0]])
        stretches = np.concatenate([directed_rows(slope, d * share) for d in (d1, turned)])
        metric = np.concatenate([self.distance_rows, bends, stretches])
        gram = metric.T @ metric
        gram.flat[:: count + 1] += 1e-12 * np.trace(gram)
        to_moves = np.zeros((count + 3, count + 3))
        to_moves[:count, :count] = np.linalg.inv(np.linalg.cholesky(gram)).T
        to_moves[count:, count:] = line
        scaled = np.concatenate(rows) @ to_moves
        scaled /= np.linalg.norm(scaled, axis=1, keepdims=True)
        _, sizes, vt = np.linalg.svd(scaled)
        rank = int((sizes > _RANK * sizes[0]).sum())
        return np.asarray(to_moves @ vt[rank:].T)

    @property
    def _moves(self) -> FloatArray:
        return self.basis[:-3]

    @cached_property
    def _moment(self) -> FloatArray:
        a, b = self.state.line
        return np.asarray(a + self.state.curve.evaluate(self._t) @ b)

    @cached_property
    def compliance(self) -> PanelFunction:
        """Changes (r) of C = 1/K = kappa / M at fixed parameters.

        dC = (d kappa - C dM) / M. Beside an inflection both vanish on the tangent space, and nowhere else:
        the polynomial through the Gauss nodes carries their quotient across.
        """
        state, curve = self.state, self.state.curve
        _, b = state.line
        panels = state.balance.panels
        position = curve.evaluate(self._t)
        across = directed_rows(curve.basis(self._t), np.broadcast_to(b, position.shape))
        moment = np.column_stack([across, np.ones(len(position)), position]) @ self.basis
        kappa = curvature_rows(curve, self._t) @ self._moves
        K = state.balance.stiffness.at(
            np.repeat(np.arange(panels.count), NODES.size), np.tile(NODES, panels.count)
        )
        M = state.balance.moment.at(
            np.repeat(np.arange(panels.count), NODES.size), np.tile(NODES, panels.count)
        )
        C, M = state.scale / K, M / state.scale
        change = (kappa - C[:, None] * moment) / M[:, None]
        return PanelFunction.through(change.reshape(*panels.t.shape, -1))

    def watched(self) -> tuple[FloatArray, FloatArray]:
        """C = 1/K (n,) at the places of the state, and its changes (n, r)."""
        return 1 / self.state.stiffness, self.compliance.at(*self.state.places)

    @cached_property
    def _stretching(self) -> tuple[PanelFunction, FloatArray, FloatArray]:
        """Changes (r) of the arc length along the panels, at their left ends (N, r), and of all of it (r,)."""
        panels, curve = self.state.balance.panels, self.state.curve
        d1 = curve.evaluate(self._t, 1)
        tangent = d1 / np.linalg.norm(d1, axis=1, keepdims=True)
        rate = directed_rows(curve.basis(self._t, 1), tangent) @ self._moves
        rate = rate.reshape(*panels.t.shape, -1) * (np.diff(panels.edges) / 2)[:, None, None]
        within = np.einsum("ij,njr->nir", LEFT, rate)
        whole = np.cumsum(np.einsum("j,njr->nr", WEIGHTS, rate), axis=0)
        return (
            PanelFunction.through(within),
            np.concatenate([np.zeros((1, whole.shape[1])), whole[:-1]]),
            whole[-1],
        )

    @cached_property
    def margin(self) -> FloatArray:
        """Changes (r,) of the stability margin while the scale of the moment is held."""
        state, rod, nodes = self.state, self.state.rod, self.state.nodes
        panels, curve = state.balance.panels, state.curve
        panel, x = panels.locate(nodes.t)
        along, before, length = self._stretching
        d1 = curve.evaluate(nodes.t, 1)
        speed = np.linalg.norm(d1, axis=1)
        share = np.linspace(0.0, 1.0, nodes.t.size)
        # the nodes slide along the curve so that they stay at equal arc lengths
        slide = (share[:, None] * length - before[panel] - along.at(panel, x)) / speed[:, None]
        half = (np.diff(panels.edges) / 2)[panel]
        K_slope = state.balance.stiffness.slope_at(panel, x) / (state.scale * half)
        K = -(rod.stiffness**2)[:, None] * self.compliance.at(panel, x) + K_slope[:, None] * slide
        moved = np.stack([curve.basis(nodes.t) @ self._moves[k::2] for k in (0, 1)], axis=1)
        moved += d1[:, :, None] * slide[:, None, :]
        edge = np.diff(nodes.position, axis=0)
        turned = np.column_stack([-edge[:, 1], edge[:, 0]]) / (edge**2).sum(axis=1)[:, None]
        angles = np.einsum("nk,nkr->nr", turned, np.diff(moved, axis=0))
        db = self.basis[-2:]
        by = rod.margin_derivatives
        force = by.force.sum(axis=0) @ np.stack([-db[1], db[0]])
        return np.asarray(by.stiffness @ K + by.angles @ angles + force + by.length * length)
