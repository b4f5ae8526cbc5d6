"""Frames as places of CadQuery, places as frames, and names that its queries can hold."""

import re

import cadquery as cq

from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel import occt


def read_frame(location: cq.Location) -> Frame:
    """A place of CadQuery as a frame."""
    plane = cq.Plane(location)
    return Frame(plane.origin.toTuple(), plane.xDir.toTuple(), plane.yDir.toTuple())


def make_location(frame: Frame) -> cq.Location:
    """A frame as a place of CadQuery."""
    return cq.Location(occt.make_location(frame))


def plain_name(name: str) -> str:
    """A name that CadQuery's queries can hold."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)
    return plain if plain[:1].isalpha() else f"strip_{plain}"


def free_name(name: str, assembly: cq.Assembly) -> str:
    """A name that CadQuery's queries can hold, unlike those in the assembly."""
    plain = plain_name(name)
    tries = (plain, *(f"{plain}_{number}" for number in range(2, len(assembly.children) + 3)))
    return next(text for text in tries if text not in assembly.objects)
