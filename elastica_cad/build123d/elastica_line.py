"""The curve of a strip between two clamps, or from one to its free end, as a line object."""

from collections.abc import Sequence

import build123d as bd

from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_warnings import end_angles
from elastica_cad.mechanics.bending.between_clamps import elastica_between
from elastica_cad.mechanics.loads.arguments import whole_number
from elastica_cad.mechanics.loads.gravity import Gravity


class Elastica(bd.BaseLineObject):
    """Line object: the curve that a strip of given length takes between two clamps, or from one to its free end.

    Which of its many shapes is stated by `branch`, and chosen by `side` and `buckling`.

    Parameters
    ----------
    start, end : point
        In the plane of the workplane; `end=None` leaves the end free, with the start clamped.
    length : float
        Of the strip, mm: more than the distance of its ends.
    angles : pair of float or None
        Of the tangents at start and end, degrees, whole turns not counted; None leaves the strip free to turn
        there.
    stiffness : float, sequence or Profile
        Of a tapered strip: its widths at even stations, in any unit.
    gravity : Gravity, optional
        The strip's own weight, as `Sheet.gravity` gives it.
    force : pair of float, optional
        At a free end, newtons over the strip's least bending stiffness in N mm2 (`Sheet.bending_stiffness`).
    side : {+1, -1}
        Bulge to the left or the right of the way from start to end.
    buckling : int
        Buckling mode; above 1 the shape is unstable as a rule.
    mode : Mode
        How it joins the builder's line.

    Raises
    ------
    InputError
        A length that does not reach, points off the plane, a force at an end that is held.

    Examples
    --------
    >>> line = Elastica((0, 0), (70, 0), 100, angles=(0, 0))
    >>> round(line.length, 3), str(line.branch)
    (100.0, 'the strip bulges to the left of its chord, with 2 inflections (mode 1)')
    """

    def __init__(
        self,
        start: bd.VectorLike,
        end: bd.VectorLike | None,
        length: float,
        *,
        angles: tuple[float | None, float | None] = (None, None),
        stiffness: "float | Sequence[float] | Profile" = 1.0,
        gravity: Gravity | None = None,
        force: tuple[float, float] | None = None,
        side: int = 1,
        buckling: int = 1,
        mode: bd.Mode = bd.Mode.ADD,
    ) -> None:
        self.branch = elastica_between(
            start,
            end,
            length,
            angles=end_angles(angles),
            stiffness=stiffness,
            gravity=gravity,
            force=force,
            side=side,
            mode=whole_number(buckling, "buckling", 1),
        )
        wire = occt.make_wire(Path([Spline(self.branch.curve)]))
        super().__init__(bd.Wire(wire), mode)
