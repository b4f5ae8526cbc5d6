"""The curve of a strip between two clamps, or from one to its free end; strips of a body's sections."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Unpack

import cadquery as cq

from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel.strip_on_path import StripOptions, section_requests
from elastica_cad.kernel.strip_warnings import end_angles
from elastica_cad.mechanics.bending.between_clamps import elastica_between
from elastica_cad.mechanics.loads.arguments import whole_number
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.material.sheet import Sheet

if TYPE_CHECKING:
    from elastica_cad.forming.plane_sections.section_spec import SectionSpec

from elastica_cad.cadquery.strip_shapes import StripCompound, StripSolid, bent_strip


def elastica(
    start: cq.Vector | tuple[float, float],
    end: cq.Vector | tuple[float, float] | None,
    length: float,
    *,
    angles: tuple[float | None, float | None] = (None, None),
    stiffness: "float | Sequence[float] | Profile" = 1.0,
    gravity: Gravity | None = None,
    force: tuple[float, float] | None = None,
    side: int = 1,
    buckling: int = 1,
) -> cq.Edge:
    """The curve of a strip of given length between two clamps, or of one with a free end, as an edge in xy.

    Parameters
    ----------
    start, end : (x, y) or Vector
        mm; `end=None` leaves the end free, with the start clamped.
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

    Raises
    ------
    InputError
        A length that does not reach, a force at an end that is held.

    Examples
    --------
    >>> round(elastica((0, 0), (70, 0), 100, angles=(0, 0)).Length(), 3)
    100.0
    """
    found = elastica_between(
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
    return cq.Wire(occt.make_wire(Path([Spline(found.curve)]))).Edges()[0]


def section_strips(
    body: "cq.Shape | cq.Workplane",
    planes: "cq.Plane | Frame | Iterable[cq.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "list[StripSolid | StripCompound]":
    """The strips that follow the lines in which planes cut a face or a body.

    Parameters
    ----------
    body : Face, Shell, Solid, or Workplane with one
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, keeps the longest and smooths.
    sheet, max_width, **options
        As in `strip_outline`; most sections bend within `limits` only.
    half : bool
        Only what lies on the side to which a plane's x axis points.

    Returns
    -------
    list of StripSolid
        Standing in the section's plane; called by `label` and a number.

    Raises
    ------
    InputError
        No section that a strip could follow, and as `strip_outline`.

    Warns
    -----
    StripWarning
        Of lines that are left out.

    Examples
    --------
    >>> dome = cq.Workplane().sphere(60, angle1=20).faces(">Z")
    >>> len(section_strips(dome, cq.Plane.XZ(), "card-200gsm", max_width=8))
    1
    """
    shape = body.val() if isinstance(body, cq.Workplane) else body
    return [
        bent_strip(curve, sheet, max_width=max_width, **placed)
        for curve, placed in section_requests(shape, planes, options, half=half)
    ]
