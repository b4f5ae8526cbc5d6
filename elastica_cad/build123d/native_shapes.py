"""Records of bodies as solids and joints of build123d, and its places as frames."""

from collections.abc import Sequence
from typing import Any

import build123d as bd

from elastica_cad.fabrication.solids.strip_solids import BodyRecord, PrismSolid
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel import occt


def make_solids(records: Sequence[BodyRecord | PrismSolid]) -> list[bd.Solid]:
    """The bodies of records, one by one."""
    return [bd.Solid(occt.make_solid(record)) for record in records]


def add_joints(shape: Any, record: BodyRecord | PrismSolid) -> None:
    """Give a shape the rigid joints of a record, by their names."""
    for name, frame in record.joints.items():
        bd.RigidJoint(name, shape, bd.Location(occt.make_location(frame)))


def read_frame(location: bd.Location) -> Frame:
    """A place of build123d as a frame."""
    plane = bd.Plane(location)
    return Frame(tuple(plane.origin), tuple(plane.x_dir), tuple(plane.y_dir))
