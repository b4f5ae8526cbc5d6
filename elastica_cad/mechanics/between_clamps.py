"""Shape of a bent strip (elastica) between two clamps, or with one clamp and a loaded free end."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import radians
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad._values import is_number, is_one_of, is_series, pair, require_positive
from elastica_cad.errors import InputError, Length, note
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import angle_of, left_of, norm, unit, unit_vectors
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bending import bend
from elastica_cad.mechanics.loads import End, Gravity, Supports
from elastica_cad.mechanics.rod import Rod

SAMPLES = 901  # number of nodes; the error of their positions is 1e-6 of the length of the strip


@dataclass(frozen=True, eq=False)
class ElasticaBetween:
    """Bent strip between two clamps or with a free end, and its side and buckling mode.

    Attributes
    ----------
    rod : Rod
        Bent rod; its `force` and `moment` at the ends act on the clamps.
    side : int
        +1 if the first bulge is left of the line from start to end, -1 if right, 0 for a straight strip. If the
        end is free, `side` is the side of the free end, seen along the clamp.
    mode : int
        Buckling mode; mode 1 is stable.
    """

    rod: Rod
    side: int
    mode: int

    @property
    def curve(self) -> PlaneCurve:
        """Shape as a smooth spline of degree 5 whose curvature agrees with the bending moment."""
        return self.rod.curve

    @property
    def inflections(self) -> int:
        """Number of sign changes of the curvature."""
        kappa = self.rod.curvature
        signs = np.sign(kappa[np.abs(kappa) > 1e-6 * np.abs(kappa).max(initial=0.0)])
        return int(np.count_nonzero(np.diff(signs)))

    def __str__(self) -> str:
        if self.side == 0:
            return note("the strip is straight")
        if _is_free(self.rod):
            template = (
                "the strip's free end goes to the left, with {count} inflections (mode {mode})"
                if self.side > 0
                else "the strip's free end goes to the right, with {count} inflections (mode {mode})"
            )
        else:
            template = (
                (
                    "the strip bulges to the left of the line between its ends, with {count} inflections (mode "
                    "{mode})"
                )
                if self.side > 0
                else (
                    "the strip bulges to the right of the line between its ends, with {count} inflections "
                    "(mode {mode})"
                )
            )
        return note(template, count=self.inflections, mode=self.mode)


def elastica_between(
    start: ArrayLike,
    end: ArrayLike | None,
    length: float,
    *,
    angles: tuple[float | None, float | None] = (None, None),
    stiffness: "ArrayLike | Profile" = 1.0,
    gravity: Gravity | None = None,
    force: ArrayLike | None = None,
    side: int = 1,
    mode: int = 1,
    samples: int = SAMPLES,
) -> ElasticaBetween:
    """Return the shape of a strip of given length between two points, or with a free end.

    The computation starts from a straight strip, moves the end to `end` and turns both ends to `angles`. A
    strip with a free end starts straight in the direction of its clamp and is loaded in steps.

    Parameters
    ----------
    start, end : (2,) array_like
        Positions of the ends, mm. If `end` is None, the end is free and the start is clamped.
    length : float
        Length of the strip, mm; more than the distance between its ends.
    angles : pair of float or None
        Angles of the tangent at both ends, rad, modulo 2 pi; None lets this end turn freely.
    stiffness : float, (n,) array_like or Profile
        Relative stiffness of a tapered strip, at uniform stations or as a profile over [0, length].
    gravity : Gravity, optional
        Weight of the strip.
    force : (2,) array_like, optional
        Force F (N) at a free end, divided by the least bending stiffness B (N mm2): F / B, 1/mm2.
    side : {+1, -1}
        Side of the first bulge, left (+1) or right (-1) of the line from start to end. If a force pushes a free
        end straight towards its clamp, `side` is the side to which the end moves.
    mode : int
        Buckling mode; shapes above mode 1 are usually unstable.
    samples : int
        Number of nodes.

    Raises
    ------
    NotConvergedError
        As `bend`.

    Examples
    --------
    >>> found = elastica_between((0, 0), (70, 0), 100.0, angles=(0.0, 0.0))
    >>> round(float(found.rod.position[:, 1].max()), 1), found.side, found.inflections
    (31.4, 1, 2)
    >>> drooping = elastica_between((0, 0), None, 100.0, angles=(0.0, None), force=(0, -1 / 100.0**2))
    >>> drooping.rod.position[-1].round(2).tolist()
    [94.36, -30.17]
    """
    first, (near, far) = pair(start, "start"), _pair_of_angles(angles)
    require_positive(length, "length")
    if not is_one_of(side, (1, -1)):
        raise InputError(
            f"side is {side!r}: give 1 for a bulge left of the line from start to end, -1 for right"
        )
    if end is None:
        if near is None:
            raise InputError(
                "with a free end, the strip turns about its start unless its start is clamped: give the angle "
                "at the start"
            )
        rod = Rod.straight(
            length, stiffness, samples=samples, start=first, angle=near, gravity=None,
            supports=Supports("clamped", End(x=False, y=False, angle=far is not None)),
        )  # fmt: skip
        load: Any = {
            "angles": (None, None if far is None else _nearest_turn(far, float(rod.angle[0]))),
            "gravity": gravity,
            "force": np.zeros(2) if force is None else pair(force, "force"),
        }
        with suppress(InputError):  # `bend` refuses a force below the buckling load of a straight rod
            bent = bend(rod, **load, side=side)
            return ElasticaBetween(bent, _side(bent), mode)
        bent = bend(rod, **load)
        return ElasticaBetween(bent, _side(bent), mode)
    if force is not None:
        raise InputError("a force needs a free end, but the end is held: give None for the end, or no force")
    last = pair(end, "end")
    chord = last - first
    distance = float(norm(chord))
    if not length > distance > 0:
        raise InputError(
            "a strip {length:.6g} long does not bend between ends that are {distance:.6g} apart: make the "
            "strip longer than the distance of its ends, and this distance larger than 0",
            length=Length(length),
            distance=Length(distance),
        )
    along = float(angle_of(chord))
    supports = Supports(*("pinned" if angle is None else "clamped" for angle in (near, far)))
    rod = Rod.straight(
        length, stiffness, samples=samples, start=first, angle=along, gravity=None, supports=supports
    )
    bent = bend(rod, end=last, side=side, mode=mode)
    near, far = (None if angle is None else _nearest_turn(angle, along) for angle in (near, far))
    if near is not None or far is not None or gravity is not None:
        bent = bend(bent, end=last, angles=(near, far), gravity=gravity, settle=mode == 1)
    return ElasticaBetween(bent, _side(bent), mode)


def angles_in_rad(angles: object) -> tuple[float | None, float | None]:
    """Convert two angles from degrees to radians. None means that the end turns freely."""
    near, far = _pair_of_angles(angles)
    if any(angle is not None and abs(angle) > 360 for angle in (near, far)):
        raise InputError(f"angles are {angles!r}: give degrees from -360 to 360")
    return None if near is None else radians(near), None if far is None else radians(far)


def _pair_of_angles(angles: object) -> tuple[float | None, float | None]:
    both = tuple(angles) if isinstance(angles, Sequence | np.ndarray) and is_series(angles) else ()
    if len(both) != 2 or not all(angle is None or is_number(angle) for angle in both):
        raise InputError(
            f"angles are {angles!r}: give two numbers, for start and end, or None for an end that turns "
            "freely"
        )
    near, far = both
    return near, far


def _nearest_turn(angle: float, near: float) -> float:
    """Return the angle nearest to `near`, rad, that differs from `angle` by whole turns."""
    return near + float(np.remainder(angle - near + np.pi, 2 * np.pi) - np.pi)


def _is_free(rod: Rod) -> bool:
    return not (rod.supports.ends[1].x or rod.supports.ends[1].y)


def _side(rod: Rod) -> int:
    """Return 1 if the first bulge, or the free end, is on the left, -1 on the right, and 0 for a straight rod."""
    off = rod.position - rod.position[0]
    if _is_free(rod):
        along, off = unit_vectors(rod.angle[0]), off[-1:]
    else:
        along = unit(off[-1])
    heights = off @ left_of(along)
    bulging = np.flatnonzero(np.abs(heights) > 1e-6 * rod.length)
    return int(np.sign(heights[bulging[0]])) if bulging.size else 0
