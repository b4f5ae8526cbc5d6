"""Rod with the least stiffness ratio whose rest shape is a drawn curve, and its stiffness as a spline."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, require_number, require_record, several
from elastica_cad.errors import (
    ElasticaError,
    FieldName,
    InputError,
    Length,
    Listed,
    NotConvergedError,
    note,
    rounded_up,
)
from elastica_cad.geometry.path import point
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, norm
from elastica_cad.geometry.polynomials import NODES, SLOPES, PanelFunction, legendre_basis, locate_in_panels
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bracing import SLACK_SHARE, slack_elements
from elastica_cad.mechanics.cross_sections import LeavesLaw, Section, require_section
from elastica_cad.mechanics.discrete_rod import edge_forces, nodal_forces
from elastica_cad.mechanics.elements import (
    Element,
    ElementForce,
    PointForce,
    forces_of,
    noun_of,
    require_elements,
    weight_with_loads,
)
from elastica_cad.mechanics.laminated_section import LaminatedSection
from elastica_cad.mechanics.loads import (
    EndName,
    ExcessCurvature,
    Gravity,
    NaturalCurvature,
    PointMass,
    Supports,
    Weight,
    nodal_curvature,
    require_curve,
    require_gravity,
    require_natural_curvature,
    require_supports,
    require_tolerance,
    whole_number,
)
from elastica_cad.mechanics.moment_conditions import BalancedStiffness, RodRequest
from elastica_cad.mechanics.moment_curvature import MaterialLaw
from elastica_cad.mechanics.optimal_balance import balance_of, carried_weight, extrapolated
from elastica_cad.mechanics.quadrature_panels import NARROWEST_SHARE, ROUGH_AT_ZERO, STEP_LENGTH
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import ScaleRange
from elastica_cad.mechanics.theorem1 import (
    AT_END_SHARE,
    EquilibriumCheck,
    InflectionLine,
    NotRealizable,
    is_about_kinks,
    refused,
)

TOLERANCE = 1e-6
"""Largest error of the stiffness profile, relative to its largest value. The extremes of the profile are exact."""

WORST_TOLERANCE = 0.01
"""Largest accepted error of the stiffness profile if the stiffness itself has large rounding errors.

Rounding errors are large under much weight, or with an inflection near an end.
"""

SAME_PLACE_SHARE = 1e-9
"""A knot closer than this fraction of the length to a zero of the curvature is moved to the zero."""

CELLS = 8
"""Number of equal parts of a panel; in each part, the density of knots is constant."""

_CELL_ENDS = legendre_basis(np.linspace(-1, 1, CELLS + 1))

_FOURTH_IN_CELLS = legendre_basis((2 * np.arange(CELLS) + 1) / CELLS - 1) @ np.linalg.matrix_power(SLOPES, 4)
"""Matrix from Legendre coefficients on a panel to fourth derivatives at the midpoints of its cells."""

BEST_CUBIC = 1 / 720
"""Error of the best cubic spline, divided by h^4 times the fourth derivative, for knot spacing h.

The error is the largest value of B_4 / 4!, where B_4 is a Bernoulli polynomial.
"""

SPARE = 0.07
"""Fraction of the tolerance for which the first knots are chosen, so that a second fit is rarely necessary."""


def stiffness_profile(check: EquilibriumCheck, balance: BalancedStiffness, scale: float) -> Profile:
    """Return the stiffness K times `scale` as a cubic spline of arc length.

    K has two continuous derivatives fewer than the curve, or three fewer if an inflection is at a knot. The spline
    has the same kinks as K, and replaces the jumps of K by ramps.
    """
    curve = check.curve
    length = curve.length
    zeros = np.array([z.s for z in check.zeros])
    breaks: list[tuple[float, int]] = []
    steps: list[float] = []
    for s, order in (*balance.kinks, *((knot.s, knot.continuity - 2) for knot in curve.breaks)):
        # a knot ends a panel beyond this distance from a zero, as in `cut_into_panels`
        near = NARROWEST_SHARE if order > ROUGH_AT_ZERO - 2 else SAME_PLACE_SHARE
        at_zero = zeros.size > 0 and np.abs(zeros - s).min() < near * length
        if order - int(at_zero) >= 0:
            breaks.append((s, order - int(at_zero)))
        elif not steps or np.abs(np.array(steps) - s).min() > STEP_LENGTH * length:
            steps.append(s)
    K = _AlongArc.of(curve, balance, scale)
    half = STEP_LENGTH * length / 2
    # a ramp begins and ends at its feet
    feet = [s + side * half for s in steps for side in (-1, 1)]
    # fit the ramps of jumps separately, because they would spoil the fit beside them
    breaks += [(s, -1) for s in feet]

    def stiffness(s: FloatArray) -> FloatArray:
        """Return K at arc lengths, with a ramp instead of each step."""
        values = K(s)
        for step in steps:
            inside = np.abs(s - step) < half
            if inside.any():
                foot = np.array([step - half, step + half])
                values[inside] = np.interp(s[inside], foot, K(foot))
        return values

    # the tolerance is a multiple of the rounding errors of the stiffness
    noise = 4 * K.noise([*steps, *(s for s, _ in balance.kinks)])
    tolerance = min(max(TOLERANCE * K.largest, noise), WORST_TOLERANCE * K.largest)
    knots = K.knots([s for s, _ in breaks], SPARE * tolerance)
    fitted = Profile.fit(stiffness, length, breaks=breaks, knots=knots, tolerance=tolerance)
    for i, foot in enumerate(feet):
        # at a foot, the spline has two values: keep the value beside the ramp
        first = int(fitted.knots.searchsorted(foot - 1e-9 * fitted.length))
        coefficients = np.delete(fitted.coefficients, first - i % 2)
        fitted = Profile(np.delete(fitted.knots, first), coefficients, fitted.degree)
    low, high = fitted.extremes
    if high - low <= tolerance:
        return fitted
    return fitted.stretched(*stiffness(np.array(fitted.extreme_places)).tolist())


@dataclass(frozen=True, eq=False)
class _AlongArc:
    """Stiffness K as Legendre series on panels, which end at the arc lengths `edges` (N + 1,), mm."""

    edges: FloatArray
    series: PanelFunction

    @classmethod
    def of(cls, curve: PlaneCurve, balance: BalancedStiffness, scale: float) -> "_AlongArc":
        panels = balance.panels
        t = curve.parameter(panels.edge_s[:-1, None] + np.diff(panels.edge_s)[:, None] * (1 + NODES) / 2)
        values = balance.stiffness.at(*panels.locate(t.ravel())) * scale
        return cls(panels.edge_s, PanelFunction.through(values.reshape(t.shape)))

    def __call__(self, s: FloatArray) -> FloatArray:
        return self.series.at(*locate_in_panels(self.edges, s))

    @property
    def largest(self) -> float:
        return float(self.series.in_every_panel(_CELL_ENDS).max())

    def noise(self, steps: Sequence[float]) -> float:
        """Return the rounding error of the stiffness: its largest jump between panels.

        Jumps at the arc lengths `steps`, mm, are ignored, because the stiffness itself may jump there.
        """
        before, after = self.series.where_panels_meet
        jumps = np.abs(after - before)
        if len(steps):
            apart = np.abs(self.edges[1:-1, None] - np.array(steps)) > STEP_LENGTH * self.edges[-1]
            jumps = jumps[apart.all(axis=1)]
        return float(jumps.max(initial=0.0))

    def knots(self, breaks: Sequence[float], tolerance: float) -> FloatArray:
        """Return the inner knots of a cubic spline through the stiffness with an error of about `tolerance`.

        Between two `breaks`, the number of knots up to a place is the integral of the density that the fourth
        derivative requires.
        """
        fourth = self.series.in_every_panel(_FOURTH_IN_CELLS)
        count = (np.abs(fourth) * BEST_CUBIC / tolerance) ** 0.25 * 2 / CELLS
        reached, s = np.zeros(count.size + 1), np.empty(count.size + 1)
        count.cumsum(out=reached[1:])
        s[:-1] = (self.edges[:-1, None] + np.diff(self.edges)[:, None] * np.arange(CELLS) / CELLS).ravel()
        s[-1] = self.edges[-1]
        stops = sorted({float(self.edges[0]), *breaks, float(self.edges[-1])})
        at = np.interp(stops, s, reached).tolist()
        parts = [max(1, ceil(b - a)) for a, b in pairwise(at)]
        inner_knots = [
            a + (b - a) / n * np.arange(1, n) for (a, b), n in zip(pairwise(at), parts, strict=True)
        ]
        return np.interp(np.concatenate(inner_knots), reached, s)


def optimal_rod(
    curve: PlaneCurve,
    gravity: Gravity | None = None,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
    samples: int | None = None,
    *,
    weight: Weight | None = None,
    bending_stiffness: float | None = None,
    largest_stiffness: float | None = None,
    least_stiffness: float | None = None,
    law: MaterialLaw | None = None,
    section: Section | None = None,
    tolerance: float = 1e-4,
    check: EquilibriumCheck | None = None,
    between: "Element | Sequence[Element]" = (),
    loads: "PointMass | PointForce | Sequence[PointMass | PointForce]" = (),
) -> Rod:
    """Return the rod with the curve as rest shape and the least ratio of largest to least stiffness.

    Parameters
    ----------
    curve : PlaneCurve
        Drawn curve, mm.
    gravity : Gravity, optional
        Weight proportional to the stiffness, as for a strip of one sheet. The direction of `gravity` also
        applies to `weight`.
    supports : Supports
        By default both ends are clamped.
    natural_curvature : float or RestCurvature
        Natural curvature kappa_0, 1/mm, or its variation along a pre-bent strip; the rod then has kappa_0 at its
        nodes.
    samples : int, optional
        Number of nodes of the rod. By default the rod has 601 nodes, and the ratio is evaluated on the
        continuous curve. With `samples` but without `largest_stiffness`, the ratio is evaluated at the nodes.
    weight : Weight, optional
        Weight in newtons instead of a proportional weight. `own=True` adds the weight of the strip:
        K B / gravity.length^3 per length, with relative stiffness K.
    bending_stiffness : float, optional
        Lower bound B of the bending stiffness E I, N mm2, under a weight in newtons. By default, B is the value
        with the least ratio. If the ratio always decreases with B, the default is the least B whose ratio is
        within 1 % of the ratio without weight.
    largest_stiffness : float, optional
        Largest E I of the rod, N mm2, under a weight in newtons, for example that of the widest strip that
        fits. The result has the least ratio of all rods with this largest E I. If the curve is not the rest
        shape of such a rod under this weight, the largest E I of the result is smaller.
    least_stiffness : float, optional
        Lower bound of E I, N mm2, in addition to `largest_stiffness`.
    law : MaterialLaw, optional
        Nonlinear material law. Moment / initial stiffness replaces kappa - kappa_0 (paper, Appendix D).
    section : Section, optional
        Section of the strip: a thickness, a diameter, or a width that bends as a plate. The dimensions of the
        section are as large as their limits allow, and determine the bending stiffness. With `gravity`,
        of which only the direction is used, the rod carries the weight of the section and the masses of
        `weight`. The optimisation is then nonlinear, and the ratio is a local optimum; see `balance_of`.
    tolerance : float
        Largest distance of inflections from a common line, relative to the length; nearer inflections are moved
        onto the line. Almost unbent ends that are free to turn are made straight within the same tolerance.
        `Rod.moved` is the displacement of the curve, and `Rod.shape` is the moved curve.
    check : EquilibriumCheck, optional
        Result of an earlier check of the same curve with the same options.
    between : sequence of Rail, Pin and Tie
        Rails, pins and ties that hold the strip between its ends. Their forces are unknowns of the
        linear program. At an inflection, their force normal to the strip is zero, because the width
        would jump there. `Rod.between_forces` contains the forces.
    loads : sequence of PointMass and PointForce
        Masses (g) that hang on the strip in the direction of `gravity`, and forces (N). The weight of the strip is
        added. Like a `weight` in newtons, they determine the bending stiffness.

    Returns
    -------
    Rod
        Rod with least nodal stiffness 1. If weight, rails, pins or ties allow several stiffnesses, the result is
        the smoothest stiffness within 1 % of the least ratio (section 5.3).

    Raises
    ------
    NotRealizable
        No admissible stiffness exists; `check` of the error states why and where.

    References
    ----------
    Paper, Eqs. 4 to 6 and section 5.3.

    Examples
    --------
    >>> import math
    >>> arch = PlaneCurve.ellipse((0, 0), (200, 100), start=0, end=math.pi)
    >>> round(optimal_rod(arch).ratio, 4)
    1.5699

    A curve that no strip takes without a rail under its middle:

    >>> from elastica_cad.mechanics.elements import Rail
    >>> points = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
    >>> rod = optimal_rod(PlaneCurve.spline(points, degree=5), between=Rail((180, -5)))
    >>> round(rod.ratio, 1), rod.between_forces.shape
    (1.9, (1, 2))
    """
    require_curve(curve)
    require_gravity(gravity)
    between = require_elements(between)
    supports = require_supports(supports, between=bool(between))
    require_natural_curvature(natural_curvature)
    weight, forces = weight_with_loads(weight, gravity, loads)
    _check_options(gravity, samples, weight)
    in_newtons = weight is not None or bool(forces)
    for name, value in (
        ("bending_stiffness", bending_stiffness),
        ("largest_stiffness", largest_stiffness),
        ("least_stiffness", least_stiffness),
    ):
        if value is not None and not in_newtons:
            raise InputError(
                f"{name} applies only to rods with a weight in newtons: pass weight=Weight(...) too"
            )
        if value is not None and not (is_number(value) and value > 0):
            raise InputError(f"{name} is {value!r}: give a number above 0, in N mm2")
    if section is None and bending_stiffness is not None and largest_stiffness is not None:
        raise InputError(
            "`bending_stiffness` already sets the stiffness, so `largest_stiffness` has no effect: give "
            "only one of them"
        )
    if section is None and least_stiffness is not None and largest_stiffness is None:
        raise InputError(
            "`least_stiffness` applies only together with `largest_stiffness`. Pass `largest_stiffness` "
            "too, or pass `bending_stiffness` instead."
        )
    require_tolerance(tolerance)
    require_record(law, MaterialLaw | None, "law", "a MaterialLaw record, or None")
    request = RodRequest(
        curve, gravity, supports, natural_curvature, samples, weight, bending_stiffness, largest_stiffness,
        least_stiffness, law, section, check, between, forces,
    )  # fmt: skip
    if check is None:
        check = request.examined(tolerance)
    require_record(check, EquilibriumCheck, "check", "what check_equilibrium answers")
    return rod_of_request(replace(request, known_check=check))


def rod_of_request(request: RodRequest) -> Rod:
    """Return the rod of a checked request; see `optimal_rod`."""
    check, law = request.check, request.law
    if request.section is not None:
        _check_section(request, request.section)
    if request.gravity is not None and not check.any_stiffness:
        _require_load_at_free_end(request)
    if not check.realizable:
        raise NotRealizable(check)
    if law is not None:
        t = check.curve.parameter(np.linspace(0.0, check.length, 2001))
        law.require_design(float(np.abs(ExcessCurvature(check.curve, request.natural_curvature).at(t)).max()))
    return _unbent_rod(request) if check.any_stiffness else _bent_rod(request, balance_of(request))


def _check_section(request: RodRequest, section: Section) -> None:
    weight = request.weight
    if request.between or request.point_forces:
        raise InputError(
            "A varying thickness or diameter (section) cannot be combined with rails, pins, ties or "
            "point forces yet. Leave out the section, or these elements."
        )
    if isinstance(section, LeavesLaw):
        raise InputError(
            "glued plies change the stiffness in steps, so no stack follows a drawn curve exactly: use the "
            "nearest curve ({field})",
            field=FieldName("limits"),
        )
    require_section(section)
    alone = weight is None or (weight.own and not isinstance(weight.alpha, Profile) and weight.alpha == 0)
    settled = any(
        value is not None for value in (request.bending_stiffness, request.largest_stiffness, request.law)
    )
    if settled or not alone:
        raise InputError(
            "`section` already sets stiffness and weight: leave out `bending_stiffness`, "
            "`largest_stiffness` and `law`, and give `weight` only masses, such as Weight(masses=..., "
            "own=True)"
        )


def _check_options(gravity: Gravity | None, samples: int | None, weight: Weight | None) -> None:
    if samples is not None:
        whole_number(samples, "samples", 3)
    require_record(weight, Weight | None, "weight", "a Weight record, or None")
    if weight is not None and gravity is None:
        raise InputError("a weight in newtons needs a direction: set {field} too", field=FieldName("gravity"))


def _require_load_at_free_end(request: RodRequest) -> None:
    """Refuse a free end of a strip with weight, unless a mass, an element or a force acts on this end."""
    check = request.check
    acting = [mass.s for mass in request.masses if mass.mass > 0]
    acting += [s for element in (*request.elements, *request.forces) for s in element.s.tolist()]
    for name, support, s in zip(("start", "end"), request.supports.ends, (0.0, check.length), strict=True):
        hung = any(abs(at - s) <= AT_END_SHARE * check.length for at in acting)
        if not support.is_free or hung:
            continue
        reason = note(
            "The {end} (at {s}) is free, and near a free end a drawn curve never has exactly the curvature "
            "of a hanging strip. Use nearest_rod for the nearest curve of a hanging strip, "
            "bend(Rod.straight(...)) for a given strip, or hang a mass on this end. (The exact curvature at "
            "a distance u from the end is cos(angle) u^2 / (2 l^3), with the elasto-gravity length l.)",
            end=note(name), s=Length(s),
        )  # fmt: skip
        raise NotRealizable(refused(check, reason))


def _rod_of(
    request: RodRequest, check: EquilibriumCheck, moment: FloatArray, force: FloatArray, **fields: Any
) -> Rod:
    nodes, B = request.nodes, fields.get("bending_stiffness")
    loads = tuple(
        ElementForce(placed_force.element, placed_force.s, placed_force.units[0] / (B or 1.0))
        for placed_force in request.forces
    )
    return Rod(
        s=nodes.s, position=nodes.position, angle=nodes.angle, curvature=nodes.curvature, moment=moment,
        force=force, gravity=request.gravity, supports=request.supports,
        natural_curvature=nodal_curvature(request.natural_curvature, nodes.s), law=request.law,
        section=request.section, shape=check.curve, check=check, point_forces=loads, **fields,
    )  # fmt: skip


def _unbent_rod(request: RodRequest) -> Rod:
    """Return the uniform rod of a curve that any stiffness fits, or refuse a load that would bend it."""
    check, nodes = request.check, request.nodes
    n = nodes.s.size
    B, weight = request.bending_stiffness or request.largest_stiffness, request.weight
    if B is not None and weight is not None and request.gravity is not None:
        weight = carried_weight(weight, request.gravity, B)
    rod = _rod_of(
        request, check, np.zeros(n), np.zeros((n, 2)), stiffness=np.ones(n), weight=weight,
        profile=Profile.interpolate(nodes.s[[0, -1]], np.ones(2)),
        bending_stiffness=B, warnings=check.cautions,
        between=forces_of(request.elements, np.zeros(sum(element.unknowns for element in request.elements))),
    )  # fmt: skip
    if request.forces:
        reason = "Under a point force a straight strip bends. Draw the shape into which it bends."
        raise NotRealizable(refused(check, reason))
    if request.section is not None:
        bent = request.section.bent(0.0)
        size = bent.deciding_limit
        scale, newtons = float(bent.bending_stiffness(size)), float(bent.weight_per_length(size))
        masses = () if rod.weight is None else rod.weight.masses
        own = None if rod.gravity is None else Weight(alpha=newtons, masses=masses)
        rod = replace(rod, bending_stiffness=scale, weight=own)
    if request.gravity is None:
        return rod
    chord = nodes.position[-1] - nodes.position[0]
    sideways = abs(chord @ left_of(request.gravity.direction)) / norm(chord)
    if request.natural_curvature or sideways > 1e-9:
        reason = "Under its weight a straight strip sags, unless it is vertical. Draw its sagging shape."
        raise NotRealizable(refused(check, reason))
    if rod.weight is not None and rod.bending_stiffness is None:
        raise InputError(
            "a straight vertical strip hangs straight with any stiffness: set its `bending_stiffness`"
        )
    load = rod.nodal_load
    # the end carries the whole weight if it is held, or else the start
    force = nodal_forces(edge_forces(load[0], load), load)
    lower = request.supports.ends[1]
    return replace(rod, force=force if lower.x and lower.y else force - load.sum(axis=0))


def _bent_rod(request: RodRequest, balance: BalancedStiffness) -> Rod:
    """Return the rod with a balanced stiffness, divided by its least value, and with warnings."""
    check, nodes = request.check, request.nodes
    panel, x = balance.panels.locate(nodes.t)
    functions = (balance.stiffness, balance.moment, balance.force)
    values = PanelFunction(np.dstack([function.coefficients for function in functions])).at(panel, x)
    least = float(values[:, 0].min())
    if least <= 0:
        raise NotRealizable(check)
    K, moment, b = np.split(values / least, [1, 2], axis=1)
    K, moment = K[:, 0], moment[:, 0]
    size = np.abs(moment).max()
    change = nodes.curvature - nodal_curvature(request.natural_curvature, nodes.s)
    effective = change if request.law is None else request.law.effective_curvature(change)
    residual = float(np.abs(K * effective - moment).max() / size)
    # drop the cautions about kinks that rails, pins and ties cause
    near = KINK_SHARE * check.curve.length
    stations = [s for action in balance.between for s in action.s]
    jumps = [knot.s for knot in check.curve.breaks if knot.continuity < 2]

    def is_expected(s: float) -> bool:
        at_station, at_jump = (any(abs(s - at) <= near for at in places) for places in (stations, jumps))
        return at_station and not at_jump

    warnings = tuple(
        warning
        for warning in check.cautions
        if not (is_about_kinks(warning) and all(map(is_expected, warning.values["places"])))
    )
    if check.moved > 1e-3:
        warning = note(
            "The curve was moved by at most {moved} to bring its inflections onto one line."
            if request.gravity is None
            else "The curve was moved by at most {moved} to remove the remaining curvature at its ends.",
            moved=Length(check.moved),
            severity="warning",
        )
        warnings = (*warnings, warning)
    warnings = (*warnings, *_slack_warnings(request, balance))
    if request.needs_line and check.zeros and norm(b[0]) > 0:
        check = replace(check, line=InflectionLine.of_moment(float(moment[0]), b[0], nodes.position[0]))
    weight = balance.weight
    if weight is not None:  # K is divided by its least value, so multiply beta, which keeps the weight beta K
        weight = weight.scaled(beta=least)
    return _rod_of(
        request, check, moment, left_of(b), stiffness=K,
        profile=stiffness_profile(check, balance, 1 / least), residual=residual, weight=weight,
        bending_stiffness=None if balance.bending_stiffness is None else balance.bending_stiffness * least,
        warnings=warnings, moved=check.moved,
        between=tuple(replace(action, force=action.force / least) for action in balance.between),
    )  # fmt: skip


KINK_SHARE = 0.005
"""Largest distance of a rail, pin or tie from a kink that its force causes, as a fraction of the length."""


def _slack_in(balance: BalancedStiffness) -> tuple[ElementForce, ...]:
    return slack_elements(balance.between, left_of(balance.force.nodal.reshape(-1, 2)))


def _slack_warnings(request: RodRequest, balance: BalancedStiffness) -> Iterator[str]:
    """Yield warnings about elements with so little force that they may become slack, with a remedy."""
    slack = _slack_in(balance)
    width, height = np.abs(np.diff(request.nodes.position[[0, -1]], axis=0)[0])
    support: EndName = "slide-x" if width >= height else "slide-y"
    cured = _elements_loaded_by(request, support) if slack else ()
    for action in slack:
        yield note(
            "The {element} {places} from the start carries less than {share:g} % of the largest force, so it may "
            "become slack or come off the strip. Let the end slide (set {field} to {support}), so that the "
            "{element} carries more."
            if action.element in cured else
            "The {element} {places} from the start carries less than {share:g} % of the largest force, so it may "
            "become slack or come off the strip. Move or remove the {element}.",
            element=noun_of(action.element), places=Listed(map(Length, action.s.tolist())),
            share=100 * SLACK_SHARE, field=FieldName("supports.end"), support=support, severity="warning",
        )  # fmt: skip


def _elements_loaded_by(request: RodRequest, support: EndName) -> tuple[Element | PointForce, ...]:
    """Return the rails, pins and ties that are not slack if `support` replaces the clamp at the end."""
    if not request.supports.clamped:
        return ()
    try:
        balance = balance_of(replace(request, supports=Supports(end=support), known_check=None))
    except ElasticaError:
        return ()
    slack = [action.element for action in _slack_in(balance)]
    return tuple(action.element for action in balance.between if action.element not in slack)


_SETTLED_SHARE = 1e-5
"""The search for a laminate has converged when the stiffness changes by less than this fraction."""

_MOST_ROUNDS = 30
"""Largest number of optimal rods that are computed in the search for a laminate."""

_DENSE = 2001  # number of points at which the width of the backing is checked


@dataclass(frozen=True, eq=False)
class LaminateLayers:
    """Base of known width with a glued backing; the weight of this laminate is not proportional to its stiffness.

    Attributes
    ----------
    section : LaminatedSection
    base_width : float or Profile
        Width of the base, mm.
    least_backing : float
        Least width of backing that can be cut and glued, mm.
    """

    section: LaminatedSection
    base_width: float | Profile
    least_backing: float


@dataclass(frozen=True, eq=False)
class Laminate:
    """Laminated rod and the widths of its layers.

    Attributes
    ----------
    rod : Rod
        Rod with relative stiffness K; its `bending_stiffness` is the scale c, N mm2, of E I = c K.
    section : LaminatedSection
    base_width, backing_width : (n,) array
        Widths of base and backing at the nodes of the rod, mm.
    range : ScaleRange
        Range of scales for which a laminate with this K can be built; c is the upper limit.
    rounds : int
        Number of optimal rods that were computed; 1 without weight.
    """

    rod: Rod
    section: LaminatedSection
    base_width: FloatArray
    backing_width: FloatArray
    range: ScaleRange
    rounds: int


def optimal_laminate(
    curve: PlaneCurve,
    section: LaminatedSection,
    base_width: "float | Profile",
    *,
    direction: ArrayLike | None = None,
    supports: Supports | None = None,
    samples: int | None = None,
    least_backing: float = 0.0,
    masses: tuple[PointMass, ...] = (),
) -> Laminate:
    """Return the laminated rod of least stiffness ratio on a curve, with a base of given width.

    The weight of both layers is linear in the width of the backing but not in the stiffness K (paper, section 8.1,
    footnote 4). In each iteration, the weight per length is linearised at the present K and scale. If K and
    scale do not converge and the base has a uniform width, a nonlinear search in short steps follows.

    Parameters
    ----------
    curve : PlaneCurve
    section : LaminatedSection
    base_width : float or Profile
        Width of the base along the curve, mm.
    direction : (2,) array_like, optional
        Direction of gravity in the plane of the curve; by default the strip is weightless.
    supports, samples
        As in `optimal_rod`.
    least_backing : float
        Least width of backing that can be cut and glued, mm.
    masses : tuple of PointMass
        Masses that hang on the strip.

    Raises
    ------
    NotRealizable
        No admissible stiffness exists.
    NotConvergedError
        The iteration for weight and stiffness does not converge.

    Examples
    --------
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> card = Sheet.named("card-200gsm")
    >>> arch = PlaneCurve.ellipse((0, 0), (75, 60), start=0, end=3.1416)
    >>> laminate = optimal_laminate(arch, LaminatedSection(card, card), 20.0, direction=(0, -1))
    >>> round(float(laminate.backing_width.max()), 6)
    20.0
    """
    require_curve(curve)
    require_record(section, LaminatedSection, "the section", "a LaminatedSection(base, backing)")
    masses = several("masses", masses, PointMass, "PointMass")
    supports = require_supports(supports)
    gravity = None if direction is None else filled_gravity(section, direction)
    _check_options(gravity, samples, None)
    request = RodRequest(curve, gravity, supports, samples=samples, weight=Weight(masses=masses))
    return laminate_of_request(request, LaminateLayers(section, base_width, least_backing))


def laminate_of_request(request: RodRequest, layers: LaminateLayers) -> Laminate:
    """Return the laminate of a checked request, with the weight of its layers; see `optimal_laminate`."""
    base_width, s_end = layers.base_width, request.curve.length
    if isinstance(base_width, Profile) and not np.isclose(base_width.length, s_end, rtol=1e-6):
        raise InputError(
            (
                "the base width is given over {length:.6g}, but the curve is {s_end:.6g} long: give the width "
                "along the whole curve"
            ),
            length=Length(base_width.length),
            s_end=Length(s_end),
        )
    request = replace(request, known_check=request.check)
    rod = rod_of_request(replace(request, weight=None))
    base = _Base.under(rod, layers)
    if request.gravity is None:
        return base.laminate(rod, base.scale(rod), 1)
    laminate, change = _by_tangent_laws(request, base, rod)
    if laminate is not None:
        return laminate
    if isinstance(base_width, Profile):
        raise NotConvergedError(
            "weight and stiffness of the laminate did not converge (the stiffness still changes by "
            f"{change:.2g}): give the base a constant width, for which the search is more exact, "
            "or use stiffer or lighter sheets"
        )
    rod = _by_short_steps(request, layers.section, float(base_width))
    return base.laminate(rod, base.scale(rod), _MOST_ROUNDS)


@dataclass(frozen=True, eq=False)
class _Base:
    """Base of a laminate, and arc lengths at which the backing must fit on the base.

    Attributes
    ----------
    layers : LaminateLayers
    at_nodes : (n,) array
        Width of the base at the nodes of the rod, mm.
    places, at_places : (m,) arrays
        The arc lengths, mm, and the widths of the base there, mm.
    """

    layers: LaminateLayers
    at_nodes: FloatArray
    places: FloatArray
    at_places: FloatArray

    @classmethod
    def under(cls, rod: Rod, layers: LaminateLayers) -> "_Base":
        """Return the base under the backing of a rod."""
        width = layers.base_width
        at_nodes = _along(width, rod.s)
        places = np.union1d(np.linspace(0.0, rod.length, _DENSE), rod.s)
        if isinstance(width, Profile):
            places = np.union1d(places, width.knots.clip(0.0, rod.length))
        return cls(layers, at_nodes, places, _along(width, places))

    def scale(self, rod: Rod) -> float:
        """Return the largest c, N mm2, such that the base can carry a laminate c times as stiff as the rod."""
        section, least = self.layers.section.on(self.at_places), self.layers.least_backing
        stiffness = _stiffness(rod, self.places)
        scales = section.scale_range(stiffness, least_backing=least)
        if not scales.feasible:
            ratio = section.thickness_ratio(stiffness, least_backing=least)
            raise InputError(
                "the stiffness of the laminate cannot vary as much as the curve requires: make the backing "
                f"{rounded_up(1 / ratio, 3):g} times as thick as the base, or thicker (now "
                f"{section.backing.thickness / section.base.thickness:.3g} times)"
            )
        return scales.scale

    def laminate(self, rod: Rod, scale: float, rounds: int) -> Laminate:
        K, section = rod.stiffness, self.layers.section.on(self.at_nodes)
        return Laminate(
            rod=replace(rod, bending_stiffness=scale),
            section=section,
            base_width=self.at_nodes,
            backing_width=section.parameter(scale * K),
            range=section.scale_range(K, least_backing=self.layers.least_backing),
            rounds=rounds,
        )


def _by_tangent_laws(request: RodRequest, base: _Base, rod: Rod) -> tuple[Laminate | None, float]:
    """Return the laminate, or None without convergence, and the last relative change of its stiffness."""
    # knots of the cubic spline for the weight per length
    stations = np.linspace(0.0, rod.length, 81)
    w1 = _along(base.layers.base_width, stations)
    section = base.layers.section.on(w1)
    bounds = section.bending_stiffness(0.0 * w1), section.bending_stiffness(w1)
    scale = base.scale(rod)
    history: list[float] = []
    change, least = np.inf, 1.0  # `least` is the least relative stiffness, which smoothing may raise above 1
    for rounds in range(2, _MOST_ROUNDS):
        target = scale / least
        # an extrapolated E I may be less than that of the base alone, or more than that of two full layers
        EI = (scale * _stiffness(rod, stations)).clip(*bounds)
        weight = section.weight(stations, EI / target, target)
        weight = replace(weight, masses=request.masses)
        next_rod = rod_of_request(replace(request, weight=weight, bending_stiffness=target))
        change = float(np.abs(next_rod.stiffness / rod.stiffness - 1).max())
        rod, stiffness = next_rod, next_rod.bending_stiffness or target
        least = stiffness / target
        scale = base.scale(rod)
        if change < _SETTLED_SHARE and abs(scale / stiffness - 1) < _SETTLED_SHARE:
            return base.laminate(rod, scale, rounds), change
        history.append(np.log(scale))
        if len(history) == 3:
            scale = float(np.exp(extrapolated(*history)))
            history.clear()
    return None, change


def _by_short_steps(request: RodRequest, section: LaminatedSection, base_width: float) -> Rod:
    section = replace(section, base_width=base_width, limits=(0.0, base_width))
    try:
        rod = rod_of_request(
            replace(request, section=section, weight=Weight(masses=request.masses, own=True))
        )
    except InputError as error:
        raise InputError(
            "the stiffness of the laminate cannot vary as much as the curve requires under this weight: use "
            "a thicker backing, or lighter sheets"
        ) from error
    return replace(rod, section=None)  # the laminate itself describes the layers


def _along(width: float | Profile, s: FloatArray) -> FloatArray:
    return (
        width(s)
        if isinstance(width, Profile)
        else np.full(s.shape, require_number(width, "base width", "mm"))
    )


def _stiffness(rod: Rod, s: FloatArray) -> FloatArray:
    """Return the relative stiffness at arc lengths `s`. Values of its spline below 1 are raised to 1."""
    return np.maximum(rod.profile(s), 1.0)


def filled_gravity(section: LaminatedSection, direction: ArrayLike) -> Gravity:
    """Return the gravity of a laminate with layers of equal width, as a first approximation."""
    square = section.on(1.0)
    length = square.bending_stiffness(1.0) / square.weight_per_length(1.0)
    x, y = point(direction, "direction")
    return Gravity(float(length ** (1 / 3)), (float(x), float(y)))
