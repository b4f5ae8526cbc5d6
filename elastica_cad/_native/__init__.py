"""Compiled twins of the inner loops of curves and rods; without them Python does the same more slowly.

`kernels` is None where the package was built without a C compiler, and where the environment has ELASTICA_PURE. The
functions in Python stay what is meant: tests compare each kernel with its twin to 1e-12.
"""

import os
from collections.abc import Callable
from importlib import import_module
from typing import Protocol, cast

import numpy as np

from elastica_cad._types import FloatArray, IntArray

MOST_DEGREE = 32
"""Of the polynomials that kernels have room for."""


class Kernels(Protocol):
    """The compiled functions. Arrays are contiguous float64 or, of places in others, int64; the last arguments are
    filled; truth is 0 or 1.
    """

    def locate(
        self, edges: FloatArray, to_left: bool, low: float, places: FloatArray, piece: IntArray,
        x: FloatArray, /,
    ) -> None:  # fmt: skip
        """Between which edges places lie, and where from `low` to 1: `Spans.locate`, `locate_in_panels`."""

    def legendre_sums(
        self,
        coefficients: FloatArray,
        sizes: tuple[int, int],
        panel: IntArray,
        x: FloatArray,
        values: FloatArray,
        /,
    ) -> None:
        """That of `geometry.polynomials.panel_functions.values_at`."""

    def bernstein_sums(
        self, series: FloatArray, sizes: tuple[int, int, int, int], piece: IntArray, u: FloatArray,
        values: FloatArray, /,
    ) -> None:  # fmt: skip
        """That of `geometry.curves.curve_derivatives.RationalPieces`; pieces, degree, columns, the first asked."""

    def curve_at(
        self, series: FloatArray, sizes: tuple[int, int, int], edges: FloatArray, left: bool,
        origins: FloatArray, t: FloatArray, values: FloatArray, /,
    ) -> None:  # fmt: skip
        """`at` of the same, of a curve without weights."""

    def arc_lengths_at(
        self, t: FloatArray, s: FloatArray, series: FloatArray, parameters: FloatArray, lengths: FloatArray, /
    ) -> None:
        """`length_at` of `geometry.curves.arc_length.ArcLength`."""

    def parameters_at(
        self, t: FloatArray, s: FloatArray, series: FloatArray, meets: FloatArray, cubics: FloatArray,
        step_from_cubic: float, last_step: float, lengths: FloatArray, parameters: FloatArray, /,
    ) -> None:  # fmt: skip
        """`parameter_at` of the same."""

    def speed_panels(
        self, series: FloatArray, sizes: tuple[int, int, int, int], edges: FloatArray, shares: FloatArray,
        to_series: FloatArray, integrate: FloatArray, settings: tuple[float, float, float, float],
        starts: FloatArray, lengths: FloatArray, /,
    ) -> int:  # fmt: skip
        """The panels of `geometry.curves.arc_length.arc_length_table`: how many, -1 where they need more room."""

    def resolve_panels(
        self, series: FloatArray, sizes: tuple[int, int, int, int], edges: FloatArray,
        rule: tuple[FloatArray, FloatArray, FloatArray, FloatArray],
        cut: tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray], rest: float,
        limits: tuple[float, float, float],
        nodes: tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray], /,
    ) -> int:  # fmt: skip
        """Those of `mechanics.stiffness.quadrature_panels`: how many, -1 where they need more room."""

    def extremes(
        self, coefficients: FloatArray, basis: FloatArray, places: FloatArray, slopes: FloatArray,
        settings: tuple[int, float, float], table: FloatArray, panel: IntArray, sample: IntArray,
        x: FloatArray, /,
    ) -> int:  # fmt: skip
        """`found_extremes` of `geometry.polynomials.panel_functions.PanelFunction`: how many there are."""

    def bernstein_roots(
        self, coefficients: FloatArray, noise: FloatArray, settings: tuple[int, float, float, float, float, float],
        piece: IntArray, sharp: IntArray, places: FloatArray, /,
    ) -> int:  # fmt: skip
        """The events of `roots` in `geometry.polynomials.bernstein`: how many, -1 where they need more room."""

    def vertex_exchange(
        self, rows: FloatArray, limits: FloatArray, settings: tuple[int, float, float, float],
        active: IntArray, inverse: FloatArray, vertex: FloatArray, /,
    ) -> int:  # fmt: skip
        """`_exchanged` of `mechanics.stiffness.vertex_exchange.VertexExchange`: how it ended."""

    def cubic_extremes(
        self, pieces: FloatArray, edges: FloatArray, /
    ) -> tuple[tuple[float, float], tuple[float, float]]:
        """`_extreme_points` of a cubic `geometry.paths.profile.Profile`."""

    def spline_motion(
        self, degree: int, splines: tuple[FloatArray, FloatArray, FloatArray], which: IntArray, u: FloatArray,
        position: FloatArray, velocity: FloatArray, /,
    ) -> None:  # fmt: skip
        """`motion` of `geometry.paths.spline_table.SplineTable`, of its knots, points and domain."""

    def extraction(self, degree: int, near: FloatArray, matrix: FloatArray, /) -> None:
        """That of `geometry.polynomials.bezier_pieces`."""

    def fit_splines(
        self, degree: int, spans: tuple[IntArray, FloatArray, FloatArray],
        rule: tuple[FloatArray, FloatArray, FloatArray], samples: FloatArray, band: FloatArray,
        coefficients: FloatArray, errors: FloatArray, /,
    ) -> int:  # fmt: skip
        """`_least_squares` of `geometry.polynomials.fit_function`, with the errors; 0 where there is none."""

    def derivative_series(
        self, sizes: tuple[int, int],
        pieces: tuple[IntArray, FloatArray, FloatArray, FloatArray, FloatArray], raised: FloatArray,
        series: FloatArray, /,
    ) -> None:  # fmt: skip
        """`_series` of `geometry.curves.curve_derivatives.RationalPieces`; degree, numbers of a place."""

    def inverse_cells(
        self, t: FloatArray, s: FloatArray, series: FloatArray, at_steps: FloatArray, paces: FloatArray,
        meets: FloatArray, cubics: FloatArray, /,
    ) -> None:  # fmt: skip
        """`_inverse` of `geometry.curves.arc_length.ArcLength`."""

    def quintics_at(
        self, nodes: FloatArray, rows: FloatArray, s: FloatArray, points: FloatArray, slopes: FloatArray, /
    ) -> None:
        """`in_plane` of `fabrication.interlocking.ruled_strip.RuledStrip`."""

    def nearest_on_quintics(
        self, nodes: FloatArray, rows: FloatArray, stations: tuple[FloatArray, FloatArray],
        settings: tuple[float, int], points: FloatArray, s: FloatArray, places: FloatArray,
        tangents: FloatArray, /,
    ) -> None:  # fmt: skip
        """`nearest_places` of `fabrication.interlocking.flush_strips`; length, steps."""

    def spline_values(
        self, edges: FloatArray, pieces: FloatArray, x: FloatArray, values: FloatArray, /
    ) -> None:
        """`__call__` of `geometry.polynomials.spline_function.SplineFunction`."""

    def are_cones(self, hodographs: FloatArray, parts: int, limits: tuple[float, float, float], /) -> bool:
        """Is no part cut by `cut_into_tangent_cones` of `geometry.curves.tangent_angle`, and none a standstill?"""

    def tangent_angles(self, hodographs: FloatArray, axis: FloatArray, angle: FloatArray, /) -> float:
        """`tabulate_tangent_angle` of the same: the spread."""

    def angles_at(
        self, tabulated: tuple[FloatArray, FloatArray, FloatArray], to_left: bool, t: FloatArray,
        velocity: FloatArray, angles: FloatArray, /,
    ) -> None:  # fmt: skip
        """`TangentAngle.at` of the same."""

    def near_pairs(
        self, places: tuple[FloatArray, FloatArray, IntArray], ranges: tuple[IntArray, IntArray],
        reach: float, lower: IntArray, higher: IntArray, /,
    ) -> int:  # fmt: skip
        """That of `fabrication.makeability.near_pairs`: how many pairs there are, also beyond the room for them."""

    def chord_pairs(self, p: FloatArray, q: FloatArray, of_p: IntArray, of_q: IntArray, /) -> int:
        """`_candidate_pairs` of `geometry.paths.path_intersections`: how many, also beyond the room for them."""

    def away_from_rims(
        self, sides: tuple[FloatArray, FloatArray], s: FloatArray, across: FloatArray, away: FloatArray, /
    ) -> None:
        """`uncut` of `fabrication.interlocking.slotted_collisions.SlotRims`."""

    def shoot(
        self, bend: FloatArray, rest: FloatArray, pull_x: FloatArray, pull_y: FloatArray, moment: float,
        angle: float, wound_up: float, angles: FloatArray, moments: FloatArray, /,
    ) -> None:  # fmt: skip
        """The recursion of `mechanics.rod.shooting.shoot`."""

    def shape(
        self, angles: FloatArray, force: FloatArray, start: FloatArray, edge_length: float,
        tangents: FloatArray, position: FloatArray, pull: FloatArray, shear: FloatArray, /,
    ) -> None:  # fmt: skip
        """Those of `mechanics.rod.discrete_rod.DiscreteRod`, of edges of one length."""

    def second_variation(
        self, stiffness: FloatArray, node_lengths: FloatArray, edge_lengths: FloatArray, pull: FloatArray,
        tangents: FloatArray, free_start: bool, free_end: bool, held_x: bool, held_y: bool, straight: float,
        diagonal: FloatArray, off: FloatArray, rows: FloatArray, /,
    ) -> None:  # fmt: skip
        """`hessian` and `constraint_rows` of `mechanics.rod.discrete_rod.DiscreteRod`."""

    def sensitivities(
        self, stiffness: FloatArray, moments: FloatArray, all_angles: FloatArray, tangents: FloatArray,
        pull: FloatArray, shear: FloatArray, shares: FloatArray, rest: FloatArray, basis: FloatArray,
        e: FloatArray, carried_sums: FloatArray | None, carried_slopes: FloatArray | None, length: float,
        start_moment: float, start_angle: float, heavy: bool, closing: bool, by_angles: FloatArray,
        by_moments: FloatArray, by_position: FloatArray, /,
    ) -> None:  # fmt: skip
        """The derivatives of `forming.nearest.rod_map.StripGrid.sensitivities`."""

    def weighted_gram(
        self, J: FloatArray, added: FloatArray, weights: FloatArray, product: FloatArray, /
    ) -> None:
        """That of `forming.optimizer.dense_solves.weighted_gram`."""

    def largest_distance(self, points: FloatArray, chain: FloatArray, bounds: FloatArray, /) -> float:
        """That of `forming.nearest.curve_distance`; `bounds` (n,) is room."""

    def hermite(
        self, position: FloatArray, slopes: FloatArray, s: FloatArray, places: FloatArray,
        directions: FloatArray, /,
    ) -> None:  # fmt: skip
        """The cubics of `forming.nearest.target_curve.hermite`."""

    def active_sets(
        self, hessian: FloatArray, gradient: FloatArray, lower: FloatArray, upper: FloatArray,
        rows: FloatArray, right: FloatArray, price: FloatArray, one_sided: FloatArray, fixed: FloatArray,
        low: FloatArray, high: FloatArray, met: FloatArray, broken: FloatArray, most_guesses: int,
        patience: int, x: FloatArray, y: FloatArray, at_lower: FloatArray, at_upper: FloatArray, /,
    ) -> int:  # fmt: skip
        """The guesses of `forming.optimizer.quadratic_program`: which one settled, 0 where none did."""

    def interior_points(
        self, hessian: FloatArray, gradient: FloatArray, lower: FloatArray, upper: FloatArray,
        rows: FloatArray, right: FloatArray, price: FloatArray, one_sided: FloatArray, fixed: FloatArray,
        settings: tuple[float, float, float, float, float, float, int, int, int, int],
        x: FloatArray, y: FloatArray, at_lower: FloatArray, at_upper: FloatArray, /,
    ) -> tuple[int, int]:  # fmt: skip
        """The steps of the same module: 0, 1 where they converge or 2 where a guess settled, and their count."""

    def lowest_mode(
        self, diagonal: FloatArray, off: FloatArray, lengths: FloatArray, constraint_rows: FloatArray,
        polynomials: FloatArray, settings: tuple[int, int, float, float, float, float],
        mode: FloatArray, multipliers: FloatArray, /,
    ) -> float | None:  # fmt: skip
        """The margin of `mechanics.rod.discrete_rod.DiscreteRod` with its mode, where that is smooth."""


def pairs_of(ask: Callable[[IntArray, IntArray], int], room: int) -> IntArray:
    """Pairs (2, k) that a kernel fills in and counts, also beyond the room for them: then it is asked again."""
    while True:
        pairs = np.empty((2, room), dtype=np.intp)
        count = ask(*pairs)
        if count <= room:
            return pairs[:, :count]
        room = count


def _found() -> Kernels | None:
    if os.environ.get("ELASTICA_PURE"):
        return None
    try:
        return cast(Kernels, import_module("elastica_cad._native.kernels"))
    except ImportError:
        return None


kernels = _found()
