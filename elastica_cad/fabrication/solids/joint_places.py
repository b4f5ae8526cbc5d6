"""Where other parts join a strip, and how its sheets lie on each other."""

from collections.abc import Mapping

from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame


def centred_thickness(strip: Strip) -> float:
    """Thickness, mm, of the layers that are centred on the curve: all, but of glued leaves the through one."""
    return strip.layers[-1 if strip.layout.stack is None else 0].high


def joint_places(strip: Strip) -> dict[str, tuple[float, float, int]]:
    """Flat place (x, y) of every joint, and +1 where its x axis runs along the strip, -1 against it."""
    places = {"start": (0.0, 0.0, -1), "end": (strip.rod.length, 0.0, 1)}
    for number, hole in enumerate(strip.holes, start=1):
        x, y = map(float, hole.bounds.mean(axis=0))
        places[f"hole{number}"] = (x, y, 1)
    return places


def with_faces(joints: Mapping[str, Frame], thickness: float) -> dict[str, Frame]:
    """The joints, and of every hole one on each face of the strip: "hole1:top", "hole1:bottom", z outward."""
    found = dict(joints)
    for name, frame in joints.items():
        if name.startswith("hole"):
            found[f"{name}:top"] = frame.shifted(z=thickness / 2)
            below = frame.shifted(z=-thickness / 2)
            found[f"{name}:bottom"] = Frame(below.origin, below.x_axis, -below.y_axis)
    return found


def turned(frame: Frame, way: int) -> Frame:
    """The frame, half a turn about its z axis where `way` is -1."""
    return frame if way == 1 else Frame(frame.origin, -frame.x_axis, -frame.y_axis)
