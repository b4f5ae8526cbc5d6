"""Request for a nearest rod, with the length of the drawn curve as the unit of length."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError
from elastica_cad.errors import Length as Mm
from elastica_cad.form_finding.curve_distance import (
    Distance,
    LargestDistance,
    MeanDistance,
    TargetCurve,
    even_steps,
)
from elastica_cad.form_finding.limits import Keep, Limits
from elastica_cad.form_finding.rod_map import MappedRod, SectionScale, StiffnessBasis, Unknowns
from elastica_cad.form_finding.rod_spec import RodSpec, Weights
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import (
    NaturalCurvature,
    RestCurvature,
    Supports,
)
from elastica_cad.mechanics.rod import SEARCH_SAMPLES, Rod
from elastica_cad.mechanics.rod_system import RodSystem

_FEWEST_COEFFICIENTS, _MOST_COEFFICIENTS = 20, 60
_COEFFICIENTS_PER_HALF_TURN = 4.2


@dataclass(frozen=True, eq=False)
class NearestTask:
    """Request for a nearest rod, with the length of the drawn curve as the unit of length.

    `pose_problem` converts the task to a nonlinear program.

    Attributes
    ----------
    limits : Limits
        Limits of the request, with the stiffness ratio that its section allows.
    weights : (nodes,) array
        Weights of the nodes in the distance; their mean is 1.
    coefficients : int
        Number of coefficients of the stiffness K.
    line : pair of points or None
        Two points on the inflection line to keep, mm.
    section : SectionScale or None
        Relation between section and stiffness K; None without a section.
    grows : bool
        True to make the sections of a rod without weight as large as the limits allow, after the search.
    keeps_scale : bool
        True to fix the scale and limit the width at each node, for a stiffness that depends on the curvature.
    """

    request: RodSpec
    target: TargetCurve
    limits: Limits
    keep: Keep
    weights: FloatArray
    coefficients: int
    line: tuple[FloatArray, FloatArray] | None
    section: SectionScale | None
    grows: bool = True
    keeps_scale: bool = False

    @classmethod
    def of(cls, request: RodSpec) -> "NearestTask":
        """Return the task for a request."""
        target, samples = TargetCurve.of(request.curve), request.samples or SEARCH_SAMPLES
        limits, keep = request.limits or Limits(), request.keep or Keep()
        coefficients = request.coefficients
        if coefficients is None:
            half_turns = float(np.abs(np.diff(target.angle)).sum()) / np.pi
            needed = _FEWEST_COEFFICIENTS + round(_COEFFICIENTS_PER_HALF_TURN * half_turns)
            coefficients = min(_MOST_COEFFICIENTS, needed, (samples - 1) // 2)
        scale = None
        if request.section is not None:
            bent = _nodal_bend(target, request.natural_curvature, samples)
            section = request.section.bent(bent, _nodal_rest(request.natural_curvature, samples, 1.0))
            scale = SectionScale.of(section, limits, heavy=request.gravity is not None)
            limits = replace(limits, ratio=scale.ratio)
        for region in limits.keep_out:
            ends = zip(("start", "end"), keep.both_ends, target.position[[0, -1]], strict=True)
            for side, is_kept, point in ends:
                inside = -float(region.clearance((point * target.size + target.origin)[None])[0][0])
                if is_kept and inside > 1e-9 * target.size:
                    raise InputError(
                        "the fixed {side} of the curve is {inside} inside a keep-out region: move the curve "
                        "or the region, or free this end",
                        side=side,
                        inside=Mm(inside),
                    )
        return cls(
            request, target, limits, keep, _node_weights(request.weights, samples, target.size), int(coefficients),
            _inflection_line(request, keep), scale,
        )  # fmt: skip

    @property
    def nodes(self) -> int:
        """Number of nodes of the rod."""
        return int(self.weights.size)

    @property
    def is_scaled_freely(self) -> bool:
        """True if the search determines the stiffness only up to a factor.

        This holds without a section, and if the limits of the section depend on the curvature of the rod.
        """
        return self.section is None or self.section.family.follows_bend

    @property
    def is_light(self) -> bool:
        """True for a rod without weight whose section determines the scale after the search."""
        return self.grows and self.request.gravity is None and not self.is_scaled_freely

    def within_ratio(self, ratio: float) -> "NearestTask":
        """Return the task with another largest stiffness ratio.

        Without weight, the sections are those that withstand the largest curvature.
        """
        limits = replace(self.limits, ratio=ratio)
        section = self.section
        if section is not None and self.is_light:
            section = SectionScale.of(section.family, limits, heavy=False)
        return replace(self, limits=limits, section=section)

    def settled(self, mapped: MappedRod) -> "NearestTask":
        """Return the task with the largest allowed widths for a rod, or this task if the widths do not change."""
        if self.section is None or not self.is_scaled_freely:
            return self
        bend = mapped.moments / mapped.stiffness / self.target.size
        section = self.section.settled(bend, mapped.stiffness, self.rest / self.target.size)
        return self if section is self.section else replace(self, section=section)

    @property
    def without_followed_margin(self) -> "NearestTask":
        """This task, without a limit of the margin that depends on a still unknown scale."""
        if self.section is None or not self.is_scaled_freely or self.limits.margin is None:
            return self
        return self.with_margin(None)

    def with_margin(self, margin: float | None) -> "NearestTask":
        """Return the task with another limit of the margin, or without a limit if `margin` is None."""
        return replace(self, limits=replace(self.limits, margin=margin))

    @property
    def even_stiffness(self) -> float:
        """Constant stiffness K of an initial guess: the geometric mean of 1 and the largest K, at most 4."""
        return float(np.sqrt(min(self.limits.largest_ratio, 16.0)))

    def off(self, mapped: MappedRod) -> float:
        """Return the root mean square distance of a rod from the target, divided by the length of the target."""
        return float(np.sqrt(2 * self.mean_distance.value(mapped)))

    @property
    def scale(self) -> float:
        """Bending stiffness, N mm2, where the relative stiffness K is 1; 1 without a section."""
        return 1.0 if self.section is None else self.section.scale

    @property
    def least_stiffness(self) -> float:
        """Least stiffness K: 1, or the K of the least width if the scale is fixed.

        The K of the least width can be below 1 only if the widths alone limit the stiffness ratio.
        """
        section, width, ratio = self.section, self.limits.width, self.limits.largest_ratio
        if not self.keeps_scale or section is None:
            return 1.0
        # limits of a strip include its stiffening in their least width, the width of a section does not
        family, least = (
            (section.family, section.family.limits[0])
            if width is None
            else (section.family.bent(0.0), width[0])
        )
        narrowest = float(family.bending_stiffness(least).max()) / section.scale if least > 0 else 1.0
        by_widths = width is not None and ratio >= width[1] / width[0]
        return min(narrowest if by_widths else max(1.0, narrowest), ratio)

    def scaled_by(self, share: float) -> "NearestTask":
        """Return the task with the stiffness of its sections multiplied by `share`."""
        if self.section is None:
            return self
        return replace(self, section=replace(self.section, scale=share * self.section.scale))

    @property
    def in_smaller_sections(self) -> "NearestTask | None":
        """Task with smaller sections, which withstand the curvature of the target; None if no change is needed."""
        # without weight, or with a scale that is determined later, the scale has no effect on the search
        if self.section is None or self.is_scaled_freely or self.request.gravity is None:
            return None
        bent = _nodal_bend(self.target, self.request.natural_curvature, self.nodes)
        section = self.section.bearing(bent, self.limits)
        return None if section is None else replace(self, section=section)

    @property
    def rest(self) -> float | FloatArray:
        """Natural curvature times the length of the target: a number, or an array (nodes,) for a pre-bent strip."""
        return _nodal_rest(self.request.natural_curvature, self.nodes, self.target.size)

    def rod_of(self, mapped: MappedRod) -> Rod:
        """Return the rod in mm, with a least stiffness of 1. Without weight, sections are as large as allowed.

        The state of the rod is computed again in mm from the angles and the forces of `mapped`.
        """
        size, section = self.target.size, self.section
        if section is not None and self.is_light:
            section = section.grown(mapped.stiffness, mapped.moments / mapped.stiffness / size, self.limits)
        least = float(mapped.stiffness.min())
        length = mapped.length * size
        profile = Profile(self.basis.knots * length, self.basis.coefficients(mapped.z) / least)
        blank = Rod.straight(
            length, profile, samples=self.nodes, gravity=self.request.gravity, supports=self.request.supports,
            natural_curvature=self.request.natural_curvature,
        )  # fmt: skip
        if section is not None:
            blank = section.carried_by(blank, mapped.stiffness)
        position = mapped.position * size + self.target.origin
        system = RodSystem(
            stiffness=blank.stiffness, edge_length=length / (self.nodes - 1), load=blank.nodal_load,
            natural_curvature=blank.natural_curvature, supports=blank.supports, start=position[0],
            end=position[-1], end_angles=mapped.all_angles[[0, -1]], force=np.zeros(2), moments=np.zeros(2),
        )  # fmt: skip
        force = mapped.force / (least * size**2)
        # reactions along the axes that both supports hold: the part of the forces that the loads do not cause
        reactions = (force - system.given_force)[:, list(system.held)].mean(axis=0)
        return system.state(mapped.angles, reactions).rod(blank)

    @property
    def basis(self) -> StiffnessBasis:
        """Basis functions of the stiffness K."""
        return StiffnessBasis(self.coefficients, mirrored=bool(self.keep.symmetry))

    @property
    def distance(self) -> Distance:
        """Requested measure of the distance from the target."""
        if self.request.measure == "max":
            return LargestDistance(self.target, self.weights / self.weights.max())
        return self.mean_distance

    @cached_property
    def mean_distance(self) -> MeanDistance:
        """Measure of the distance between points of rod and target at the same fraction of the length."""
        shares = self.weights.copy()
        shares[[0, -1]] /= 2  # the end nodes belong to half an edge only
        return MeanDistance(self.target.at(even_steps(self.nodes)), shares / shares.sum())


def _nodal_bend(target: TargetCurve, rest: NaturalCurvature, nodes: int) -> FloatArray:
    # change of curvature (nodes,), 1/mm, of a rod that follows the target
    kappa = np.interp(even_steps(nodes), even_steps(target.curvature.size), target.curvature)
    return (kappa - _nodal_rest(rest, nodes, target.size)) / target.size


def _nodal_rest(rest: NaturalCurvature, nodes: int, size: float) -> float | FloatArray:
    # natural curvature times `size`, at the nodes if it varies
    if isinstance(rest, RestCurvature):
        return size * rest.at(np.linspace(0.0, rest.length, nodes))
    return size * rest


@dataclass(frozen=True, eq=False)
class SearchPoint:
    """End of a search: the unknowns of a rod, with their unit of length and origin.

    Attributes
    ----------
    z : (p,) array
        Values of the unknowns.
    unknowns : Unknowns
        Meaning of each unknown.
    size : float
        Length of the target, which is the unit of length, mm.
    origin : (2,) array
        Origin of the coordinates, mm.
    off : float
        Mean distance from the target, divided by the diagonal of the target, after the last search from all initial
        guesses.
    """

    z: FloatArray
    unknowns: Unknowns
    size: float
    origin: FloatArray
    off: float

    def seen_from(self, target: TargetCurve, unknowns: Unknowns) -> FloatArray | None:
        """Convert the unknowns of this rod to the units of another target. Return None if `unknowns` differ."""
        u = self.unknowns
        if unknowns != u:
            return None
        z, larger = self.z.copy(), target.size / self.size
        z[u.moment] *= larger
        z[u.force] *= larger**2
        z[u.length] /= larger
        z[u.position] = (self.z[u.position] * self.size + self.origin - target.origin) / target.size
        return np.asarray(z)


def _inflection_line(request: RodSpec, keep: Keep) -> tuple[FloatArray, FloatArray] | None:
    """Return two points, mm, of the line on which the inflections must be, or None if there is no such request."""
    line, curve = keep.line, request.curve
    if not line:
        return None
    if request.gravity is not None:
        raise InputError(
            "with gravity, the inflections of a strip are not on one line: leave out `keep.line` or gravity"
        )
    if not isinstance(line, bool):
        return np.asarray(line[0]), np.asarray(line[1])
    crossing = examine(curve, Supports(), request.natural_curvature).line
    if crossing is None:
        raise InputError(
            "the inflections of the drawn curve do not determine one line: set `keep.line` to two points "
            "((x, y), (x, y)) of the line"
        )
    point, direction = np.asarray(crossing.point), np.asarray(crossing.direction)
    return point, point + direction * curve.length


def _node_weights(weights: Weights, nodes: int, size: float) -> FloatArray:
    """Return the weights of the distance at the nodes, with mean 1. `size` is the length of the curve, mm."""
    if weights is None:
        return np.ones(nodes)
    values = values_along(weights, even_steps(nodes), size, "weights")
    if (values < 0).any() or not values.any():
        raise InputError(
            "the weights along the curve are negative or all 0: give numbers of 0 or more, some above 0"
        )
    return np.asarray(values / values.mean())


def values_along(given: object, x: FloatArray, size: float, what: str) -> FloatArray:
    """Return the values of `given` at x (n,) in 0..1.

    `given` is a number, evenly spaced values, or a function of the arc length x * `size`, mm.
    """
    array = numbers(given(x * size) if callable(given) else given, what)
    if array.ndim == 0:
        array = np.full(2, float(array))
    if array.ndim != 1 or array.size < 2 or not np.isfinite(array).all():
        raise InputError(
            f"{what} cannot be read: give a finite number, values at equal distances, or a function of arc "
            "length"
        )
    return np.interp(x, np.linspace(0, 1, array.size), array)
