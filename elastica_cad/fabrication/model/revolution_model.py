"""Models of surfaces of revolution: equal strips that touch along all their edges."""

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad.errors import InputError
from elastica_cad.fabrication.holders.base_plate import BRIDGE_MM
from elastica_cad.fabrication.holders.placed_tab import End, place_tabs
from elastica_cad.fabrication.holders.ring_plate import PLAY_MM, Ring, ring_plate, slot_reach
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.tabs import Tab
from elastica_cad.forming.revolution.meridian import Meridian, meridian
from elastica_cad.mechanics.material.sheet import Sheet

MOST_STRIPS = 1000
"""More is a typing error: the strips of a sphere of 1 m would be 3 mm wide."""

TAB_MM = 8.0
"""Length of a tab that is not given: through a 3 mm ring with room for glue."""

TAB_GAP_MM = 0.5
"""Between the tabs of neighbours where they are nearest."""

TRIED_RINGS = 60
"""Sizes of rings that are tried where the one asked for cannot be made."""

NARROWEST_TAB_MM = 1.0
"""A narrower tab holds nothing: at a pole strips end as they are."""

BRIDGE_FACTOR = 1.02
"""On the least material between slots, so that rounding does not refuse them."""


def revolution(
    a: float,
    b: ArrayLike,
    start: ArrayLike,
    angle: float,
    strips: int,
    *,
    length: float,
    sheet: Sheet | str,
    ring: float | None = None,
    ends: tuple[Tab, Tab] | None = None,
    rings: Sheet | str | None = None,
    name: str = "revolution",
) -> Model:
    """The surface of revolution about z whose meridian has x kappa = a + <b, gamma>, tiled by plain strips.

    Parameters
    ----------
    a, b, start, angle, length, ring
        As in `meridian`.
    strips : int
        How many make the surface.
    sheet : Sheet or str
        Or its name.
    ends : pair of Tab, optional
        Of each strip; 8 mm long and so wide that neighbours' tabs keep apart, unless given.
    rings : Sheet or str, optional
        Of a ring at each end, or a cap near the pole, which join the model as its `plates`; see `ring_plate`.
    name : str

    Raises
    ------
    InputError, NotConvergedError
        As `meridian`, and fewer than three strips.

    Examples
    --------
    >>> card = Sheet.named("card-200gsm")
    >>> vase = revolution(-1.5, (0, 0.03), (150, -11.5), 2.2, 15, length=300, sheet=card)
    >>> len(vase.placed), len(vase.parts)
    (15, 1)
    """
    return revolve(
        meridian(a, b, start, angle, length, ring=ring),
        strips,
        sheet=sheet,
        ends=ends,
        rings=rings,
        name=name,
    )


def revolve(
    meridian: Meridian,
    strips: int,
    *,
    sheet: Sheet | str,
    ends: tuple[Tab, Tab] | None = None,
    rings: Sheet | str | None = None,
    name: str = "revolution",
) -> Model:
    """A meridian's surface about z, tiled by so many equal plain strips; see `revolution`.

    Raises
    ------
    InputError
        Fewer than three strips, an unknown sheet, or a ring that cannot be made; at a pole the smallest that can
        be is told.

    Examples
    --------
    >>> from elastica_cad.forming.revolution.meridian import meridian_through
    >>> profile = meridian_through([(70, 0), (125, 55), (90, 115), (75, 140)])
    >>> len(revolve(profile, 20, sheet="card-200gsm", rings="mdf-3").plates)
    2
    """
    if not 3 <= strips <= MOST_STRIPS:
        raise InputError(
            f"strips={strips}: a surface of revolution is tiled by 3 strips or more, {MOST_STRIPS} at most"
        )
    sheet = Sheet.named(sheet) if isinstance(sheet, str) else sheet
    rings = Sheet.named(rings) if isinstance(rings, str) else rings
    placed = _placed(meridian, strips, sheet, ends, rings)
    if rings is None:
        return Model(placed, name=name)
    first = _ring(placed, rings, "start")
    try:
        last = _ring(placed, rings, "end")
    except InputError as problem:
        works = _smallest_ring(meridian, strips, sheet, ends, rings) if meridian.at_pole else None
        if works is None:
            raise
        raise InputError(
            f"{problem}; ring={works} is the smallest, in whole mm, that works here"
        ) from problem
    return Model(placed, name=name, plates=(first, last))


def _placed(
    meridian: Meridian, strips: int, sheet: Sheet, ends: tuple[Tab, Tab] | None, rings: Sheet | None
) -> tuple[Placed, ...]:
    """All strips about the axis."""
    width = 2 * float(np.tan(np.pi / strips)) * float(meridian.distance.extremes[1])
    strip = Strip(meridian.rod, sheet, max_width=width, ends=ends or _tabs(meridian, strips, sheet, rings))
    turn = 2 * np.pi * np.arange(strips) / strips
    return tuple(Placed(strip, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn)


def _ring(placed: tuple[Placed, ...], sheet: Sheet, end: End) -> Ring:
    """At the start or at the end of all strips."""
    heights = placed[0].strip.rod.position[:, 1]
    return ring_plate(
        place_tabs(placed, [end]), sheet, middle=float(heights.min() + heights.max()) / 2, name=f"ring-{end}"
    )


def _smallest_ring(
    meridian: Meridian, strips: int, sheet: Sheet, ends: tuple[Tab, Tab] | None, rings: Sheet
) -> int | None:
    """The smallest distance from the axis, in whole millimetres, at which a ring can end the strips, if any."""

    def works(ring: int) -> bool:
        try:
            _ring(_placed(meridian.to_ring(ring), strips, sheet, ends, rings), rings, "end")
        except InputError:
            return False
        return True

    start, end = meridian.ring
    tried = np.unique(np.ceil(np.geomspace(end, start, TRIED_RINGS)[1:-1]).astype(int))
    tried = tried[(tried > end) & (tried < start)]
    first = next((i for i, ring in enumerate(tried.tolist()) if works(ring)), None)
    if first is None:
        return None
    before = int(tried[first - 1]) if first else int(end)
    return next(ring for ring in range(before + 1, int(tried[first]) + 1) if ring > end and works(ring))


def _tabs(meridian: Meridian, strips: int, sheet: Sheet, rings: Sheet | None) -> tuple[Tab, Tab]:
    """Tabs that go straight on, narrower than the room between the planes to both neighbours."""
    ends = meridian.curve.sample(2)
    outward = ends.angle + np.array([np.pi, 0.0])
    near = np.minimum(ends.position[:, 0], ends.position[:, 0] + TAB_MM * np.cos(outward))
    gap = TAB_GAP_MM
    if rings is not None:
        # what separates two slots is seen along the sides of either, turned by half the angle between them
        gap = 2 * PLAY_MM + BRIDGE_FACTOR * BRIDGE_MM / float(np.cos(np.pi / strips)) ** 2
        inner = [
            slot_reach(float(r), float(angle), rings.thickness, sheet.thickness)
            for r, angle in zip(ends.position[:, 0], outward, strict=True)
        ]
        near = np.minimum(near, inner)
    room = 2 * np.tan(np.pi / strips) * near - gap
    first, last = (
        Tab(TAB_MM, width=float(wide)) if wide > NARROWEST_TAB_MM else Tab(TAB_MM) for wide in room
    )
    return first, last
