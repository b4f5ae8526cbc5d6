"""What is asked of a nearest rod, in lengths of the drawn curve, and the nonlinear program made of it."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.forming.limits import Keep, Limits, Symmetry
from elastica_cad.forming.nearest.constraints.constraint import Constraint
from elastica_cad.forming.nearest.constraints.kept_shape import (
    EndAngle,
    EndForce,
    EndMoment,
    EndPosition,
    InflectionLine,
    MiddleOfMirror,
    MiddleOfTurn,
    Through,
)
from elastica_cad.forming.nearest.constraints.limit_rows import (
    CurvatureLimit,
    KeepOut,
    LeastStiffness,
    MarginLimit,
    StrainLimit,
)
from elastica_cad.forming.nearest.curve_distance import (
    ClosestDistance,
    Distance,
    LargestDistance,
    MeanDistance,
)
from elastica_cad.forming.nearest.rod_map import MappedRod, StripGrid
from elastica_cad.forming.nearest.rod_problem import RodProblem
from elastica_cad.forming.nearest.stiffness_basis import StiffnessBasis
from elastica_cad.forming.nearest.target_curve import TargetCurve, symmetry_frame
from elastica_cad.forming.section_scale import SectionScale
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.arguments import (
    require_curve,
    require_gravity,
    require_supports,
    whole_number,
)
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import (
    LENGTHS_APART,
    NaturalCurvature,
    RestCurvature,
    require_natural_curvature,
)
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.rod.node_counts import SEARCH_SAMPLES
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.rod.rod_system import RodSystem
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

Measure: TypeAlias = Literal["mean", "closest", "max"]
Weights: TypeAlias = "ArrayLike | Callable[[FloatArray], ArrayLike] | None"

_MOST_NODES = 5000  # beyond, time grows and the shape hardly changes
_FEWEST_COEFFICIENTS, _MOST_COEFFICIENTS = 20, 60  # of the stiffness unless told
_COEFFICIENTS_PER_HALF_TURN = 4.2  # a curve that turns more often asks for a finer stiffness
_SAME_LENGTH = 1e-6  # of the room that a blank has: rods keep inside it for all rounding
_SAME_CURVATURE = 1e-6  # of the target's typical one: blanks are symmetric but for rounding
_LENGTHS = (0.2, 5.0)  # of the target, least and largest: where no limit says so a rod stays of its kind


@dataclass(frozen=True, eq=False)
class NearestTask:
    """All that is asked, in lengths of the target; `problem` builds the nonlinear program.

    Attributes
    ----------
    curve : PlaneCurve
        As drawn.
    target : TargetCurve
    limits : Limits
    keep : Keep
    supports : Supports
    gravity : Gravity or None
    weights : (nodes,) array
        Of the nodes, mean 1.
    nodes, coefficients : int
    line : pair of points or None
        Inflection line to be kept, mm.
    section : SectionScale or None
        What K is made of, where its weight or strain is not that of a plain strip.
    natural_curvature : float or RestCurvature
        1/mm before bending.
    """

    curve: PlaneCurve
    target: TargetCurve
    limits: Limits
    keep: Keep
    supports: Supports
    gravity: Gravity | None
    weights: FloatArray
    nodes: int
    coefficients: int
    line: tuple[FloatArray, FloatArray] | None = None
    section: SectionScale | None = None
    natural_curvature: NaturalCurvature = 0.0

    @classmethod
    def of(
        cls, curve: PlaneCurve, limits: Limits | None, keep: Keep | None, gravity: Gravity | None,
        supports: Supports | None, weights: Weights, samples: int, coefficients: int | None,
        section: BoundedLaw | None = None, natural_curvature: NaturalCurvature = 0.0,
    ) -> "NearestTask":  # fmt: skip
        """Checked input of `nearest_rod`.

        Raises
        ------
        InputError
            Limits that contradict each other or the curve, and arguments of the wrong kind.
        """
        require_curve(curve)
        require_gravity(gravity)
        require_natural_curvature(natural_curvature)
        supports = require_supports(supports)
        for name, value, record in (("limits", limits, Limits), ("keep", keep, Keep)):
            if not (value is None or isinstance(value, record)):
                raise InputError(f"{name} is {value!r}: give a {record.__name__} record, or None")
        if whole_number(samples, "samples", 20) > _MOST_NODES:
            raise InputError(
                f"samples={samples!r}: a rod needs 20 to {_MOST_NODES} nodes, {SEARCH_SAMPLES} are usual"
            )
        target = TargetCurve.of(curve)
        if coefficients is None:
            half_turns = float(np.abs(np.diff(target.angle)).sum()) / np.pi
            wanted = _FEWEST_COEFFICIENTS + round(_COEFFICIENTS_PER_HALF_TURN * half_turns)
            coefficients = min(_MOST_COEFFICIENTS, wanted, (samples - 1) // 2)
        if whole_number(coefficients, "coefficients", 4) > (samples - 1) // 2:
            raise InputError(
                f"coefficients={coefficients!r}: the stiffness needs 4 coefficients or more, and at most half as "
                f"many as there are edges ({samples - 1})"
            )
        limits, keep = limits or Limits(), keep or Keep()
        scale = None
        if section is not None:
            bent = np.interp(
                np.linspace(0, 1, samples), np.linspace(0, 1, target.curvature.size), target.curvature
            )
            bent -= _nodal_rest(natural_curvature, samples, target.size)
            scale = SectionScale.of(section.bent(bent / target.size), limits)
            limits = replace(limits, ratio=scale.ratio)
        for region in limits.keep_out:
            ends = zip(("start", "end"), keep.both_ends, target.position[[0, -1]], strict=True)
            for side, kept, point in ends:
                inside = -float(region.clearance((point * target.size + target.origin)[None])[0][0])
                if kept and inside > 1e-9 * target.size:
                    raise InputError(
                        f"the kept {side} of the curve lies {inside:.3g} mm inside a keep-out region: "
                        "move the curve or the region, or free that end"
                    )
        return cls(
            curve=curve, target=target, limits=limits, keep=keep, supports=supports, gravity=gravity,
            weights=_node_weights(weights, samples, target.size), nodes=int(samples),
            coefficients=int(coefficients), line=_inflection_line(curve, keep, gravity, natural_curvature),
            section=scale, natural_curvature=natural_curvature,
        )  # fmt: skip

    @property
    def is_scaled_freely(self) -> bool:
        """Does K tell shares only? Of a law whose limits settle its scale, whatever the bend, each K is a size."""
        return self.section is None or self.section.law.follows_bend

    def settled(self, mapped: MappedRod) -> "NearestTask":
        """The task with widths as large as their limit lets a rod be that was found; itself where they were.

        Of other laws the scale is that of their limits, whatever the bend, and their sizes keep within these.
        """
        if self.section is None or not self.is_scaled_freely:
            return self
        bend = mapped.moments / mapped.stiffness / self.target.size
        section = self.section.settled(bend, mapped.stiffness)
        return self if section is self.section else replace(self, section=section)

    def problem(self, measure: Measure, *, weight: float = 1.0, with_margin: bool = True) -> RodProblem:
        """The problem with a share `weight` of gravity."""
        grid = self.grid(weight)
        lower, upper = self._box(grid)
        return RodProblem(
            lower, upper, self._scale(grid), grid=grid, distance=self.distance(measure),
            constraints=tuple(self._constraints(with_margin)),
        )  # fmt: skip

    def grid(self, weight: float = 1.0) -> StripGrid:
        """The nodes, with a share `weight` of gravity."""
        basis = self.basis.at_nodes(self.nodes)
        rest = self.rest
        if self.gravity is None:
            return StripGrid(basis, np.zeros(2), rest, supports=self.supports)
        if self.section is None:
            return StripGrid(
                basis, self.gravity.e * self.target.size**3 * weight, rest, supports=self.supports
            )
        up = -weight * np.asarray(self.gravity.direction)
        carried = partial(self.section.weight, size=self.target.size)
        return StripGrid(basis, up, rest, supports=self.supports, weight=carried)

    @property
    def rest(self) -> float | FloatArray:
        """kappa_0, or that of a blank (nodes,), in the target's units; the blank is stretched to the rod."""
        return _nodal_rest(self.natural_curvature, self.nodes, self.target.size)

    def rod_of(self, mapped: MappedRod) -> Rod:
        """The rod in millimetres, least stiffness 1."""
        size = self.target.size
        least = float(mapped.stiffness.min())
        length = mapped.length * size
        profile = Profile(self.basis.knots * length, self.basis.coefficients(mapped.z) / least)
        nodes = self.nodes
        blank = Rod.straight(
            length, profile, samples=nodes, gravity=self.gravity, supports=self.supports,
            natural_curvature=self.natural_curvature,
        )  # fmt: skip
        if self.section is not None:
            blank = self.section.carried_by(blank, mapped.stiffness)
        position = mapped.position * size + self.target.origin
        system = RodSystem(
            stiffness=blank.stiffness, edge_length=length / (nodes - 1), load=blank.nodal_load,
            natural_curvature=blank.natural_curvature, supports=self.supports, start=position[0], end=position[-1],
            end_angles=mapped.all_angles[[0, -1]], force=np.zeros(2), moments=np.zeros(2),
        )  # fmt: skip
        force = mapped.force / (least * size**2)
        reactions = (force - system.given_force)[:, list(system.held)].mean(axis=0)
        return system.state(mapped.angles, reactions).rod(blank)

    @property
    def basis(self) -> StiffnessBasis:
        """What K is a sum of."""
        return StiffnessBasis(self.coefficients, mirrored=bool(self.keep.symmetry))

    @property
    def moment_scale(self) -> float:
        """Typical moment."""
        bend = float(np.sqrt(np.mean(self.target.curvature**2)))
        return float(max(1.0, bend * min(2.0, np.sqrt(self.limits.largest_ratio))))

    def _scale(self, grid: StripGrid) -> FloatArray:
        u = grid.unknowns
        scale = np.ones(u.count)
        scale[u.moment] = self.moment_scale
        scale[u.force] = 5 * self.moment_scale
        return scale

    def _box(self, grid: StripGrid) -> tuple[FloatArray, FloatArray]:
        u, target = grid.unknowns, self.target
        lower, upper = np.full(u.count, -np.inf), np.full(u.count, np.inf)
        lower[u.stiffness], upper[u.stiffness] = self._stiffness_box(u.coefficients)
        start = self.supports.ends[0]
        if self.keep.both_ends[0]:
            lower[u.position] = upper[u.position] = target.position[0]
        if self.keep.both_tangents[0]:
            lower[u.angle] = upper[u.angle] = target.angle[0]
        if not start.angle:
            lower[u.moment] = upper[u.moment] = 0.0
        for axis, held in enumerate((start.x, start.y)):
            if not held:
                lower[u.force.start + axis] = upper[u.force.start + axis] = 0.0
        lower[u.length], upper[u.length] = self._lengths()
        return lower, upper

    def _lengths(self) -> tuple[float, float]:
        target, limits = self.target, self.limits
        low, high = _LENGTHS if limits.length is None else np.asarray(limits.length) / target.size
        blank = self.natural_curvature.length if isinstance(self.natural_curvature, RestCurvature) else None
        if blank is not None:
            asked = "keep length asks" if self.keep.length else "the limit length asks"
            least, most = (1.0, 1.0) if self.keep.length else (low, high)
            room = LENGTHS_APART * (1 - _SAME_LENGTH)
            low, high = (
                max(low, (1 - room) * blank / target.size),
                min(high, (1 + room) * blank / target.size),
            )
            if least > high or most < low:
                raise InputError(
                    f"{asked} for {least * target.size:.6g} to {most * target.size:.6g} mm, but the blank is "
                    f"{blank:.6g} mm long before it is bent: give its curvature along the length that is asked for"
                )
        if self.keep.length:
            if not low * (1 - 1e-12) <= 1 <= high * (1 + 1e-12):
                raise InputError(
                    f"keep length asks for {target.size:.6g} mm, outside the limit length of "
                    f"{low * target.size:.6g} to {high * target.size:.6g} mm: drop one of them"
                )
            low = high = 1.0
        if all(self.keep.both_ends):
            chord = float(np.hypot(*(target.position[-1] - target.position[0])))
            if high < chord * (1 - 1e-12):
                raise InputError(
                    f"the rod may be at most {high * target.size:.6g} mm long, but its kept ends are "
                    f"{chord * target.size:.6g} mm apart: allow more length or free an end"
                )
        return float(low), float(high)

    def distance(self, measure: Measure) -> Distance:
        """The measure of the distance from the target."""
        if measure == "mean":
            targets, _ = self.target.at(np.linspace(0, 1, self.nodes))
            return MeanDistance(targets, self._shares)
        if measure == "closest":
            return ClosestDistance(self.target, self._shares)
        if measure == "max":
            return LargestDistance(self.target, self.weights / self.weights.max())
        raise InputError(f"unknown measure {measure!r}: use 'mean', 'closest' or 'max'")

    @property
    def _shares(self) -> FloatArray:
        shares = self.weights.copy()
        shares[[0, -1]] /= 2
        return np.asarray(shares / shares.sum())

    def _constraints(self, with_margin: bool) -> list[Constraint]:
        target, limits, keep = self.target, self.limits, self.keep
        end = self.supports.ends[1]
        found: list[Constraint] = []
        if keep.symmetry:
            found.append(self._symmetry(keep.symmetry))
        else:
            if keep.both_ends[1]:
                found.append(EndPosition(target=_pair(target.position[-1])))
            if keep.both_tangents[1]:
                found.append(EndAngle(target=float(target.angle[-1])))
            if not end.angle:
                found.append(EndMoment(scale=self.moment_scale))
            found += [
                EndForce(axis=axis, scale=5 * self.moment_scale)
                for axis, held in enumerate((end.x, end.y))
                if not held
            ]
        for s in keep.points:
            if not 0 <= s <= target.size * (1 + 1e-9):
                raise InputError(f"keep point at {s:.6g} mm lies off the drawn curve of {target.size:.6g} mm")
            place = min(s / target.size, 1.0)
            point, _ = target.at(np.array([place]))
            found.append(Through(target=_pair(point[0]), place=place))
        if self.line is not None:
            a, b = ((np.asarray(p) - target.origin) / target.size for p in self.line)
            direction = (b - a) / np.hypot(*(b - a))
            found.append(InflectionLine(point=_pair(a), direction=_pair(direction), scale=self.moment_scale))
        curvature = limits.largest_curvature if self.section is None else limits.curvature
        if self.section is not None and limits.sheet is not None:
            found.append(StrainLimit(section=self.section, strain=limits.strain, size=target.size))
        if curvature is not None:
            found.append(CurvatureLimit(limit=curvature * target.size))
        found += [
            KeepOut(region=region, size=target.size, origin=_pair(target.origin), kept=keep.both_ends)
            for region in limits.keep_out
        ]
        if limits.stiffness_bounds is not None and limits.stiffness_bounds[0] is not None:
            found.append(LeastStiffness())
        if with_margin and limits.margin is not None:
            found.append(MarginLimit(limit=limits.margin))
        return found

    def _symmetry(self, kind: Symmetry) -> Constraint:
        target = self.target
        centre, axis = symmetry_frame(target, kind)
        rest = np.broadcast_to(self.rest, (self.nodes,))
        if (
            np.abs(rest - (1 if kind == "mirror" else -1) * rest[::-1]).max()
            > _SAME_CURVATURE * self.moment_scale
        ):
            image = "mirror image" if kind == "mirror" else "half turn"
            raise InputError(
                f"the blank is not its own {image} before it is bent: give one that is, or leave out keep symmetry"
            )
        if kind == "turn":
            if self.gravity is not None:
                raise InputError("a half turn turns gravity over: keep symmetry='turn' only without weight")
            return MiddleOfTurn(centre=_pair(centre), scale=self.moment_scale)
        if self.gravity is not None and abs(np.dot(self.gravity.direction, axis)) < 1 - 1e-9:
            raise InputError(
                "gravity pulls across the mirror axis: a strip with weight cannot stay symmetric"
            )
        across = np.array([-axis[1], axis[0]])
        middle = float(target.angles(np.array([0.5]))[0])
        angle = float(np.arctan2(across[1], across[0]))
        angle += np.pi * np.round((middle - angle) / np.pi)
        return MiddleOfMirror(
            centre=_pair(centre), axis=_pair(axis), angle=angle, scale=5 * self.moment_scale
        )

    def _stiffness_box(self, count: int) -> tuple[FloatArray, FloatArray]:
        """Least and largest coefficients: of the bounds along the strip the strictest over each one's support."""
        ratio = self.limits.largest_ratio
        low, high = np.ones(count), np.full(count, ratio)
        if self.limits.stiffness_bounds is None:
            return low, high
        s = np.linspace(0, 1, 20 * self.coefficients + 1)
        support = self.basis.at(s) > 0
        below, above = self.limits.stiffness_bounds
        if below is not None:
            values = _along(below, s, self.target.size, "stiffness bounds")
            low = np.maximum(low, np.where(support, values[:, None], -np.inf).max(axis=0))
        if above is not None:
            values = _along(above, s, self.target.size, "stiffness bounds")
            high = np.minimum(high, np.where(support, values[:, None], np.inf).min(axis=0))
        if low.min() > 1:
            raise InputError(
                f"stiffness_bounds ask for at least {low.min():.4g} everywhere, but K / min K is 1 somewhere: "
                "let the lower bound come down to 1"
            )
        if np.any(low > high):
            at = float(s[int(np.argmax(support[:, int(np.argmax(low - high))]))]) * self.target.size
            raise InputError(
                f"no stiffness is both above the lower and below the upper bound (or the ratio limit {ratio:.4g}) "
                f"near {at:.4g} mm: widen the bounds"
            )
        return low, high


def _nodal_rest(rest: NaturalCurvature, nodes: int, size: float) -> float | FloatArray:
    """kappa_0 times `size`, or that of a blank at so many nodes (nodes,)."""
    if isinstance(rest, RestCurvature):
        return size * rest.at(np.linspace(0.0, rest.length, nodes))
    return size * rest


def _inflection_line(
    curve: PlaneCurve, keep: Keep, gravity: Gravity | None, rest: NaturalCurvature
) -> tuple[FloatArray, FloatArray] | None:
    """Two points of the inflection line that is kept."""
    if not keep.line:
        return None
    if gravity is not None:
        raise InputError("a rod with weight has no inflection line: do without keep line, or without gravity")
    if not isinstance(keep.line, bool):
        return np.asarray(keep.line[0]), np.asarray(keep.line[1])
    line = check_equilibrium(curve, natural_curvature=rest).line
    if line is None:
        raise InputError(
            "the drawn curve has no inflection line to keep: give two points, keep line=((x, y), (x, y))"
        )
    point, direction = np.asarray(line.point), np.asarray(line.direction)
    return point, point + direction * curve.length


def _node_weights(weights: Weights, nodes: int, size: float) -> FloatArray:
    """Weights along the curve at the nodes, mean 1."""
    values = _along(1.0 if weights is None else weights, np.linspace(0, 1, nodes), size, "weights")
    if np.any(values < 0) or not values.any():
        raise InputError("weights along the curve must be 0 or more, and not all 0")
    return np.asarray(values / values.mean())


def _along(given: object, x: FloatArray, size: float, what: str) -> FloatArray:
    """Values at x (0..1) of a number, of values at equal distances, or of a function of arc length in mm."""
    values = given(x * size) if callable(given) else given
    array = np.asarray(values, dtype=float)
    if array.ndim == 0:
        array = np.full(2, float(array))
    if array.ndim != 1 or array.size < 2 or not np.all(np.isfinite(array)):
        raise InputError(
            f"{what} must be a finite number, values at equal distances, or a function of arc length"
        )
    return np.asarray(np.interp(x, np.linspace(0, 1, array.size), array))


def _pair(point: FloatArray) -> tuple[float, float]:
    return float(point[0]), float(point[1])
