"""What a curve tells about itself: samples, curvature zeros, knots, corners."""

from dataclasses import dataclass

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.curvature_zeros import ZeroKind


@dataclass(frozen=True, eq=False)
class CurveSamples:
    """Points of a curve, all arrays over the same n places.

    Attributes
    ----------
    s : (n,) array
        Arc length from the start, mm.
    position : (n, 2) array
        Points, mm.
    angle : (n,) array
        Turning angle, rad, continuous along the curve.
    curvature : (n,) array
        Signed curvature, 1/mm, positive to the left.
    t : (n,) array
        Parameter of the curve.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    t: FloatArray


@dataclass(frozen=True)
class CurvatureZero:
    """A place (or, if flat, a stretch) where the curvature vanishes or jumps to the other sign.

    Attributes
    ----------
    s, s_end : float
        Arc length, mm; s_end differs from s for a straight piece only.
    t, t_end : float
        The same places in the curve's parameter.
    kind : str
        "crossing" (sign change), "touch" (none), "end" (at an end of the curve), "jump" (the sign changes by
        a jump at a knot), "flat" (a straight piece s..s_end).
    before, after : int
        Sign of the curvature on either side; 0 beyond the ends of the curve.
    """

    s: float
    t: float
    kind: ZeroKind
    s_end: float
    t_end: float
    before: int
    after: int

    @property
    def changes_sign(self) -> bool:
        """Does the curve bend one way before and the other way after?"""
        return self.before * self.after < 0


@dataclass(frozen=True)
class LineCrossing:
    """A common point of curve and line; fields as in `CurvatureZero` ("flat": the curve runs along it)."""

    s: float
    t: float
    kind: ZeroKind
    s_end: float
    t_end: float
    before: int
    after: int


@dataclass(frozen=True)
class Break:
    """An interior knot.

    Attributes
    ----------
    s, t : float
        Arc length (mm) and parameter.
    continuity : int
        How many derivatives with respect to arc length are continuous there: 0 tangent break, 1 curvature
        jump, 2 kink of the curvature, ... (at least; orders above 3 are taken from the knot's multiplicity).
    """

    s: float
    t: float
    continuity: int


@dataclass(frozen=True)
class TangentBreak:
    """A corner: arc length (mm), parameter, and the exterior angle (rad)."""

    s: float
    t: float
    angle: float
