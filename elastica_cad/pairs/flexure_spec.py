"""Request for a part with two rest shapes: two curves, a sheet, and limits."""

from dataclasses import dataclass, field
from typing import Annotated, Literal

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._values import EqualByValue
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import FieldName, InputError
from elastica_cad.form_finding.fairing_request import smooth_curve
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.sheets import Sheet, require_flat, require_name
from elastica_cad.pairs.flexure import Flexure, Pad
from elastica_cad.pairs.matching import MatchedPair, matched_pair, same_way
from elastica_cad.pairs.two_state_rods import Objective, PairLimits, State, TwoStateRod, two_state_rod

Match = Literal["ends", "shape", "none"]


@dataclass(frozen=True, eq=False)
class FlexureSpec(EqualByValue):
    """Request for a flexure: a part with two rest shapes (states).

    Attributes
    ----------
    first, second : PlaneCurve
        Drawn curves of both states, mm.
    sheet : Sheet or str
        Sheet from which the part is cut.
    scale : float
        Factor by which both curves are enlarged first.
    match : "ends", "shape" or "none"
        Method by which the lengths of both curves are made equal: see `matched_pair`.
    smooth : float, optional
        Largest distance, mm, by which smoothing may move the curves, as in `StripSpec`.
    limits : PairLimits
        Upper limits of stiffness ratio, natural curvature, and change of curvature.
    free : "first", "second" or None
        State in which no external forces act, or None.
    objective : "thickness" or "ratio"
        "thickness" maximises the least thickness at the strain limit of the sheet. "ratio" minimises the stiffness
        ratio.
    least_thickness, pad, fillet, push_at, printed, label, ignore_limits
        See `Flexure`.
    first_state, second_state : str
        Names of the states.

    Examples
    --------
    >>> import numpy as np
    >>> arch = PlaneCurve.spline([(0, 0), (30, 8), (90, 8), (120, 0)], degree=3)
    >>> spec = FlexureSpec(arch, arch.transformed(np.diag([1.0, -1.0, 1.0])), "pom-2")
    >>> spec.make().pair.bistable
    False
    """

    first: Annotated[PlaneCurve, Option("Curve of the first state.")]
    second: Annotated[PlaneCurve, Option("Curve of the second state.")]
    sheet: Annotated[
        Sheet | str, Option("Material, whose thickness is the depth of the part.", common=True, written=Sheet)
    ]
    scale: Annotated[float, Option("Factor by which both curves are enlarged.", above=0, common=True)] = 1.0
    match: Annotated[
        Match,
        Option(
            "Method to make both curves equally long: move them with fixed ends, scale them, or neither.",
            common=True,
        ),
    ] = "ends"
    smooth: Annotated[
        float | None,
        Option(
            "Largest distance to move the curves to make their curvature smooth.", "mm", least=0, common=True
        ),
    ] = None
    limits: Annotated[PairLimits, Option("Upper limits of the strip.")] = field(default_factory=PairLimits)
    free: Annotated[
        State | None,
        Option(
            "State in which the part rests without any support; by default both states need one.",
            common=True,
            replaces=("objective",),
        ),
    ] = None
    objective: Annotated[
        Objective,
        Option("Aim: the thickest part that the strain allows, or the most even thickness.", common=True),
    ] = "thickness"
    least_thickness: Annotated[
        float | None,
        Option(
            (
                "Thickness of the thinnest place, in the plane; by default the largest that the sheet's strain "
                "allows."
            ),
            "mm",
            above=0,
            common=True,
        ),
    ] = None
    pad: Annotated[Pad, Option("Pads that hold both ends.")] = field(default_factory=Pad)
    fillet: Annotated[float, Option("Radius at the roots of the pads.", "mm", least=0, common=True)] = 1.0
    push_at: Annotated[
        float | None,
        Option(
            "Place where a bistable part is pushed over; by default its middle.", "mm", least=0, common=True
        ),
    ] = None
    printed: Annotated[
        bool,
        Option(
            "Make the part for a printer: at least 0.9 mm thick, instead of 0.8 mm for a laser.", common=True
        ),
    ] = False
    label: Annotated[str, Option("Name of the part, engraved on its first pad.", common=True)] = ""
    ignore_limits: Annotated[
        bool, Option("Make the part even if it is too thin or touches itself.", common=True)
    ] = False
    first_state: Annotated[str, Option("Name of the first state; by default the id of its curve.")] = ""
    second_state: Annotated[str, Option("Name of the second state; by default the id of its curve.")] = ""

    def __post_init__(self) -> None:
        require_declared(FlexureSpec, vars(self))
        require_flat(Sheet.of(self.sheet))
        for name in ("label", "first_state", "second_state"):
            object.__setattr__(self, name, require_name(getattr(self, name), name))
        if self.first_state and self.first_state == self.second_state:
            raise InputError(
                "Both states have the name {name}. Use two names ({fields}).",
                name=self.first_state, fields=FieldName("second_state"),
            )  # fmt: skip

    @cached_property
    def matched(self) -> MatchedPair | None:
        """Both curves with equal lengths, or None if their lengths are not changed."""
        return None if self.match == "none" else matched_pair(*self.faired, self.match)

    @cached_property
    def faired(self) -> tuple[PlaneCurve, PlaneCurve]:
        """Both curves, smoothed, starting at the same end."""
        matrix = np.diag([self.scale, self.scale, 1.0])
        first, second = (
            smooth_curve(curve.transformed(matrix) if self.scale != 1 else curve, self.smooth).curve
            for curve in (self.first, self.second)
        )
        return same_way(first, second)

    @cached_property
    def pair(self) -> TwoStateRod:
        """Rod whose rest shapes are both curves."""
        first, second = self.matched or self.faired
        return two_state_rod(first, second, limits=self.limits, free=self.free, objective=self.objective)

    def make(self) -> Flexure:
        """Return the part.

        Raises
        ------
        NotRealizable
            No strip within the limits has both curves as rest shapes.
        """
        return Flexure(
            self.pair, Sheet.of(self.sheet), least_thickness=self.least_thickness, pad=self.pad, fillet=self.fillet,
            push_at=self.push_at, printed=self.printed, label=self.label, ignore_limits=self.ignore_limits,
            state_names=(self.first_state, self.second_state),
        )  # fmt: skip
