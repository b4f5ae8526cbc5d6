"""Small errors of the clamps' angles that let a strip snap into another shape."""

from functools import lru_cache

from elastica_cad.errors import Angle, InputError, NotConvergedError, Refusal, note
from elastica_cad.mechanics.bending import bend, snap_percent
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import stability
from elastica_cad.strip.held_shape import closes
from elastica_cad.strip.strip import Strip


def can_snap(strip: Strip) -> bool:
    """Return True if a strip is unstable, or if a usual error of a clamp lets it snap."""
    return not stability(strip.rod).stable or clamp_warning(strip) is not None


def clamp_warning(strip: Strip) -> Refusal | None:
    """Return the warning that a usual error of a clamp lets a stable strip snap, or None."""
    error = strip.tolerance.clamps
    snap = _least_turn(strip.rod, error)
    if snap is None:
        return None
    turn, end = snap
    return note(
        "close to snapping: the strip snaps into another shape if the clamp at its {end} is turned by "
        "{turn:.2g}; usual errors are up to {error:.2g}. Support the strip between its ends, or "
        "draw another curve",
        end=note(end), turn=Angle(turn), error=Angle(error), severity="warning",
    )  # fmt: skip


@lru_cache(maxsize=64)
def _least_turn(rod: Rod, error: float) -> tuple[float, str] | None:
    """Return the least turn of a clamp, rad, at which the rod snaps, and the end of this clamp, or None.

    The rod is bent with one clamp turned by `error` to either side. Rods with rails, pins or ties are left out.
    """
    # above this margin no clamp is turned; the arches of the examples have margins of 80 to 110
    if rod.between or rod.supports.is_free or closes(rod) or not 0 < stability(rod).margin <= 60.0:
        return None
    snaps: list[tuple[float, str]] = []
    for k, (end, name) in enumerate(zip(rod.supports.ends, ("start", "end"), strict=True)):
        for turn in (error, -error) if end.angle else ():
            angle = float(rod.angle[-k]) + turn
            try:
                bent = bend(rod, angles=(None, angle) if k else (angle, None))
            except (InputError, NotConvergedError):  # `bend` refuses taut strips
                continue
            if (percent := snap_percent(bent)) is not None:
                snaps.append((error * percent / 100, name))
    return min(snaps, default=None)
