"""The rod: a bent strip as nodal arrays, in the paper's normalisation (least stiffness 1)."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from elastica_cad._notebook import BLUE, GREY, svg_of_lines
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers, require_number, require_positive
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.arguments import require_gravity, require_supports, whole_number
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature, nodal_curvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw, scale_within
from elastica_cad.mechanics.rod.csv_text import csv_text
from elastica_cad.mechanics.rod.curling_law import CurlingLaw
from elastica_cad.mechanics.rod.discrete_rod import DiscreteRod, edge_forces
from elastica_cad.mechanics.rod.nodal_stiffness import scaled_to_least, stiffness_profile_of
from elastica_cad.mechanics.rod.rest_shape import edge_angles, has_even_edges, integrate_edges

if TYPE_CHECKING:
    from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

BAND_SHARE = 0.02  # of the length: half the band that shows the stiffness in a notebook


@dataclass(frozen=True, eq=False)
class Rod:
    """A rod in the plane; all arrays are nodal, with the same n.

    Attributes
    ----------
    s : (n,) array
        Arc length, mm, uniform, from 0 to the length.
    position : (n, 2) array
        mm.
    angle : (n,) array
        Turning angle, rad, continuous. Where a rod was computed on edges (paper, section 7.1), the end values
        are the angles that the supports hold, the others the mean of the two edges that meet at the node.
    curvature : (n,) array
        Signed, 1/mm; a discrete rod has moment / stiffness + kappa_0 here.
    stiffness : (n,) array
        K, dimensionless, least value 1.
    moment : (n,) array
        M = K (kappa - kappa_0), 1/mm; times the least bending stiffness (N mm2) it is N mm.
    force : (n, 2) array
        lambda = R b, 1/mm2; times the least bending stiffness newtons, minus the usual internal force. Edge
        values of a discrete rod are averaged to the nodes in between; the end nodes take half a cell of weight
        off the end edge.
    profile : Profile
        K as a spline of arc length, from which strips take their width.
    natural_curvature : float or (n,) array
        kappa_0, 1/mm: one for the whole rod, or one a node (a strip that was bent beyond its limit).
    gravity, weight, bending_stiffness
        What the rod carries: see `Gravity` and `Weight`; `bending_stiffness` is B, the least E I in N mm2, or
        None.
    law : MaterialLaw or None
        Where the material does not follow Hooke's law: M = K m(kappa - kappa_0) (paper, Appendix D). `bend` adds
        how a section follows the bend, and K stays what it is in the design: see `bending_law`.
    section : BoundedLaw or None
        What its stiffness is made of, where that is not the width of a strip that bends with E.
    residual : float
        Largest relative moment imbalance.
    shape : PlaneCurve or None
        The curve that the rod was made for; None where `curve` is drawn through the nodes.
    check : EquilibriumCheck or None
        What Theorem 1 said about that curve.
    moved : float
        How far the drawn curve was moved to bring its inflections onto one line, mm.
    warnings : tuple of str
        What a user should know about the answer.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    stiffness: FloatArray
    moment: FloatArray
    force: FloatArray
    profile: Profile
    gravity: Gravity | None = None
    supports: Supports = field(default_factory=Supports)
    natural_curvature: float | FloatArray = 0.0
    residual: float = 0.0
    weight: Weight | None = None
    bending_stiffness: float | None = None
    law: MaterialLaw | None = None
    section: BoundedLaw | None = None
    shape: PlaneCurve | None = None
    check: "EquilibriumCheck | None" = None
    warnings: tuple[str, ...] = ()
    moved: float = 0.0

    def __post_init__(self) -> None:
        n = numbers(self.s, "rod s").size
        for name, shape in {
            "s": (n,), "position": (n, 2), "angle": (n,), "curvature": (n,), "stiffness": (n,),
            "moment": (n,), "force": (n, 2),
        }.items():  # fmt: skip
            array = numbers(getattr(self, name), f"rod {name}").copy()
            if array.shape != shape or np.count_nonzero(np.isfinite(array)) < array.size:
                raise InputError(f"rod {name} must be finite with shape {shape}, got {array.shape}")
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        rest = numbers(self.natural_curvature, "natural curvature")
        if rest.size not in (1, n) or not np.isfinite(rest).all():
            raise InputError(
                f"natural curvature must be one finite number, or one for each of the {n} nodes, 1/mm"
            )
        if (self.stiffness <= 0).any():
            at = float(self.s[int(np.argmin(self.stiffness))])
            raise InputError(
                f"rod stiffness is not positive at {at:.6g} mm: every cross-section needs some width"
            )

    @classmethod
    def straight(
        cls,
        length: float,
        stiffness: "ArrayLike | Profile" = 1.0,
        *,
        samples: int | None = None,
        start: ArrayLike = (0.0, 0.0),
        angle: float = 0.0,
        gravity: Gravity | None = None,
        supports: Supports | None = None,
        natural_curvature: NaturalCurvature = 0.0,
        weight: Weight | None = None,
        bending_stiffness: float | None = None,
        law: MaterialLaw | None = None,
        section: BoundedLaw | None = None,
    ) -> "Rod":
        """A straight rod without a curve, to be bent by `bend`.

        Parameters
        ----------
        length : float
            mm.
        stiffness : float, (n,) array_like or Profile
            One value, nodal values at n uniform stations, or a profile over [0, length]; scaled to a least
            value 1.
        samples : int, optional
            Number of nodes (601 unless nodal values say otherwise).
        start, angle
            Position of the first end, mm, and direction, rad.
        gravity, supports, natural_curvature, weight, bending_stiffness, law, section
            As in `optimal_rod`; the stiffness is that of the rod while it is straight.

        Returns
        -------
        Rod
            Unloaded: moment and force are zero; with gravity `residual` tells how far from balance it is.

        Raises
        ------
        InputError
            Length or stiffness not positive.

        Examples
        --------
        >>> Rod.straight(100.0, [1, 2, 3]).ratio
        3.0
        """
        require_gravity(gravity)
        supports = require_supports(supports)
        if samples is not None:
            whole_number(samples, "samples", 3)
        if bending_stiffness is not None:
            require_positive(bending_stiffness, "bending stiffness", "N mm2")
        place = numbers(start, "start")
        if place.shape != (2,):
            raise InputError(f"start must be two numbers, mm, got {start!r}")
        require_positive(length, "rod length")
        require_number(angle, "the angle of a rod", "rad")
        profile, n = stiffness_profile_of(stiffness, length, samples)
        s = np.linspace(0.0, length, n)
        profile, K = scaled_to_least(profile, s)
        tangent = np.array([np.cos(angle), np.sin(angle)])
        rest = nodal_curvature(natural_curvature, s)
        bent = bool(np.any(numbers(rest, "natural curvature")))
        loaded = gravity is not None or weight is not None or bent
        return cls(
            s=s, position=place + s[:, None] * tangent,
            angle=np.full(n, float(angle)), curvature=np.zeros(n), stiffness=K,
            moment=np.zeros(n), force=np.zeros((n, 2)), profile=profile, gravity=gravity,
            supports=supports, natural_curvature=rest, residual=float(loaded), weight=weight,
            bending_stiffness=bending_stiffness, law=law, section=section,
        )  # fmt: skip

    @property
    def length(self) -> float:
        """Arc length, mm."""
        return float(self.s[-1])

    def __repr__(self) -> str:
        carries = "" if self.gravity is None else ", with weight"
        return f"<Rod of {self.length:.4g} mm, ratio {self.ratio:.4g}, {self.s.size} nodes{carries}>"

    def _repr_svg_(self) -> str:
        """The shape between two lines as far apart as it is stiff."""
        across = np.column_stack([-np.sin(self.angle), np.cos(self.angle)])
        half = BAND_SHARE * self.length * (self.stiffness / self.stiffness.max())[:, None] * across
        band = np.concatenate([self.position + half, (self.position - half)[::-1]])
        return svg_of_lines([(band, GREY, True), (self.position, BLUE, False)], repr(self))

    def table(self) -> dict[str, FloatArray]:
        """Columns (n,) by name with their unit, for a data frame or a file; force is lambda, moment M.

        Times the bending stiffness of a strip (N mm2) they are newtons and N mm: `Strip.table` has those.
        """
        return {
            "s_mm": self.s, "x_mm": self.position[:, 0], "y_mm": self.position[:, 1], "angle_rad": self.angle,
            "curvature_1_per_mm": self.curvature, "stiffness": self.stiffness, "moment_1_per_mm": self.moment,
            "force_x_1_per_mm2": self.force[:, 0], "force_y_1_per_mm2": self.force[:, 1],
        }  # fmt: skip

    def csv(self) -> str:
        """The table as comma-separated text with a header."""
        return csv_text(self.table())

    @property
    def ratio(self) -> float:
        """R = sup K / inf K, over the nodes and the profile between them."""
        low, high = self.profile.extremes
        return float(max(high, self.stiffness.max()) / min(low, self.stiffness.min()))

    @property
    def effective_curvature(self) -> FloatArray:
        """What K multiplies to give the moment (n,), 1/mm: kappa - kappa_0, or the law's m of it."""
        change = self.curvature - self.natural_curvature
        return np.asarray(change if self.law is None else self.law.effective_curvature(change))

    @property
    def follows_bend(self) -> bool:
        """Is it of a section whose stiffness hangs on how sharply it is bent?"""
        return self.section is not None and self.section.follows_bend

    @cached_property
    def bending_law(self) -> MaterialLaw | None:
        """The law of M = K m(kappa - kappa_0) however the rod is bent: what every solver asks.

        Where the section follows the bend, it is that of its sizes, which are as stiff as K in the rod's own shape.
        """
        law, section, rest = self.law, self.section, self.natural_curvature
        if section is None or not section.follows_bend or isinstance(law, CurlingLaw):
            return law
        here = section.bent(self.curvature - rest, rest)
        heavy = self.gravity is not None
        B = scale_within(here, self.stiffness, solved=self.bending_stiffness, heavy=heavy)
        factor = here.curl(here.parameter(B * self.stiffness))
        return law if factor is None else CurlingLaw(factor, factor(self.curvature), rest, law)

    def following(self) -> "Rod":
        """The same rod, which keeps the law that its section follows when its shape is another one."""
        law = self.bending_law
        return self if law is self.law else replace(self, law=law)

    @property
    def tangent_stiffness(self) -> FloatArray:
        """dM/dkappa (n,): what small disturbances feel; K unless `bending_law` says otherwise."""
        law = self.bending_law
        if law is None:
            return self.stiffness
        return self.stiffness * law.slope(self.curvature - self.natural_curvature)

    @property
    def flat_stiffness(self) -> FloatArray:
        """K (n,) that the sections would have if bending did not stiffen them: E I of their widths."""
        law = self.bending_law
        return self.stiffness / law.designed if isinstance(law, CurlingLaw) else self.stiffness

    @property
    def bending_energy(self) -> float:
        """Integral of M over kappa from rest and along the rod, 1/mm; times the least bending stiffness N mm."""
        change, law = self.curvature - self.natural_curvature, self.bending_law
        density = self.stiffness * (change**2 / 2 if law is None else law.energy(change))
        return float(np.sum((density[1:] + density[:-1]) * np.diff(self.s)) / 2)

    def bend_at(self, s: FloatArray) -> FloatArray:
        """kappa - kappa_0 (n,), 1/mm, at arc lengths (n,), mm; of a drawn curve its own."""
        s = numbers(s, "arc lengths")
        if self.shape is None:
            return Profile.interpolate(self.s, self.curvature - self.natural_curvature)(s)
        curvature = self.shape.curvature_at(self.shape.parameter(np.minimum(s, self.shape.length)))
        return np.asarray(curvature - self.rest_at(s))

    def rest_at(self, s: FloatArray) -> FloatArray:
        """kappa_0 (n,), 1/mm, at arc lengths (n,), mm."""
        rest = np.broadcast_to(np.asarray(self.natural_curvature, dtype=float), self.s.shape)
        return np.asarray(np.interp(numbers(s, "arc lengths"), self.s, rest))

    @property
    def node_lengths(self) -> FloatArray:
        """Voronoi lengths w (n,) of the nodes, mm (paper, section 7.1)."""
        h = self.length / (self.s.size - 1)
        w = np.full(self.s.size, h)
        w[[0, -1]] = h / 2
        return w

    @property
    def nodal_load(self) -> FloatArray:
        """Weight lumped at the nodes (n, 2) over the least bending stiffness, 1/mm2; zero without gravity."""
        if self.gravity is None:
            return np.zeros_like(self.position)
        down = np.asarray(self.gravity.direction)
        if self.weight is None:
            amount = self.node_lengths * self.flat_stiffness / self.gravity.length**3
        else:
            if self.bending_stiffness is None:
                raise InputError("a rod with weights in newtons needs its least bending stiffness (N mm2)")
            amount = self.weight.lumped(self.s, self.stiffness, self.node_lengths) / self.bending_stiffness
        return np.asarray(amount[:, None] * down)

    @cached_property
    def discrete(self) -> DiscreteRod:
        """Angles and forces on the edges, the tangent stiffness at the nodes: what stability depends on.

        Raises
        ------
        InputError
            When two neighbouring nodes coincide.
        """
        steps = np.diff(self.position, axis=0)
        apart = (steps[:, 0] != 0) | (steps[:, 1] != 0)
        if not apart.all():
            at = float(self.s[int(np.argmin(apart))])
            raise InputError(f"two neighbouring nodes of the rod coincide at {at:.6g} mm")
        angles = edge_angles(self.position, self.angle)
        force = np.zeros((angles.size, 2))
        nodal = np.zeros_like(self.force)
        if self.gravity is not None:
            load = self.nodal_load
            force = edge_forces(np.zeros(2), load)
            nodal[1:-1] = (force[:-1] + force[1:]) / 2
            nodal[0], nodal[-1] = force[0] - load[0], force[-1] + load[-1]
        force += (self.force - nodal).mean(axis=0)
        return DiscreteRod(
            self.tangent_stiffness, angles, force, self.length / angles.size, self.supports, self.position[0]
        )

    @cached_property
    def curve(self) -> PlaneCurve:
        """The shape as a spline: the drawn curve where there is one, else of degree 5.

        Of a discrete rod it has the rod's length, end positions and end angles, and passes the nodes at about
        h^2 kappa / 24, the edge length being h (see `integrate_edges`); through nodes that are samples of a curve
        it is a fit.
        """
        if self.shape is not None:
            return self.shape
        if has_even_edges(self.s, self.position):
            return integrate_edges(self.s, self.position, self.angle)
        return PlaneCurve.fit(self.position, degree=5, tolerance=1e-6 * self.length)

    def with_stiffness(self, stiffness: "ArrayLike | Profile") -> "Rod":
        """The same ends, shape and gravity with another stiffness profile: no longer in balance until bent.

        `stiffness` is (n,) nodal values or a `Profile`; it is scaled to a least value of 1. A wide strip that
        `bend` answered keeps the curl of the widths that it had: change the stiffness before it is bent.
        """
        if not isinstance(stiffness, Profile) and numbers(stiffness, "stiffness").size not in (
            1,
            self.s.size,
        ):
            raise InputError(
                f"stiffness has {np.size(stiffness)} values, the rod {self.s.size} nodes: give one a node, "
                "or a Profile"
            )
        profile, _ = stiffness_profile_of(stiffness, self.length, self.s.size)
        K = profile(self.s)
        if np.any(K <= 0):
            raise InputError(f"stiffness is not positive at {self.s[int(np.argmin(K))]:.6g} mm")
        K, profile = K / K.min(), profile.scaled(1 / K.min())
        size = np.abs(self.moment).max()
        imbalance = np.abs(K * self.effective_curvature - self.moment).max()
        residual = float(imbalance / size) if size > 0 else float(imbalance > 0)
        return replace(self, stiffness=K, profile=profile, residual=residual)
