"""The engraved text as edges on the flat part, and the message about a pocket that leans."""

import copy
import re
from itertools import product

import build123d as bd
import cadquery as cq
import numpy as np
import pytest

import elastica_cad as ec

ARCH = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
OPTIONS = {"max_width": 30, "label": "A1"}


def test_engraved_edges_are_the_strokes_of_the_drawing():
    from elastica_cad.build123d import BentStrip
    from elastica_cad.cadquery import bent_strip

    rib = BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, mode=bd.Mode.PRIVATE)
    strokes = [item.path for item in rib.strip.drawing().strokes if item.layer == "ENGRAVE"]
    length = sum(segment.length for path in strokes for segment in path.segments)
    edges = rib.engraving
    assert len(edges) == sum(len(path.segments) for path in strokes) > 4
    assert sum(edge.length for edge in edges) == pytest.approx(length)
    top = rib.flat.bounding_box().max.Z
    assert {round(edge.bounding_box().min.Z, 5) for edge in edges} == {round(top, 5)}
    others = bent_strip(ARCH, "birch-plywood-0.8", **OPTIONS).engraving
    assert sum(edge.Length() for edge in others) == pytest.approx(length)
    assert BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, engrave="", mode=bd.Mode.PRIVATE).engraving == []


@pytest.mark.parametrize("end", ["start", "end"])
def test_overlap_of_a_leaning_pocket_is_reported(end):
    from elastica_cad.build123d import BentStrip

    rib = BentStrip(ARCH, "birch-plywood-0.8", **OPTIONS, mode=bd.Mode.PRIVATE)
    block = rib.fixture(end)
    (text,) = set(block.warnings) - set(rib.warnings)
    angle, _, depth = map(float, re.search(r"by (\S+) degrees .* by (\S+) mm, .* to (\S+) mm", text).groups())
    place = block.joints["tab"].location.inverse()
    overlaps = [place * solid for solid in (block & rib).solids()]
    # the plane of the curve is xz of the joint; the overlaps are wedges beside both faces of the tab
    deepest = max(solid.bounding_box().size.Z for solid in overlaps)
    assert deepest == pytest.approx(depth, rel=0.05)
    assert angle == pytest.approx(abs(np.degrees(block._made.block.lean[1])), rel=0.05)


def test_pocket_of_an_unloaded_strip_does_not_lean():
    from elastica_cad.cadquery import bent_strip

    straight = bent_strip(cq.Edge.makeLine(cq.Vector(0, 0), cq.Vector(100, 0)), "mdf-3", max_width=20)
    assert straight.fixture("start").warnings == straight.warnings


ONTO = bd.Plane((5, -40, 12), x_dir=(0, 1, 1), z_dir=(1, 0, 0))


def _in_rows(shape):
    work = bd.BuildPart() if isinstance(shape, bd.Part) else bd.BuildSketch()
    with work, bd.Locations((0, 0), bd.Location((20, 60), 40), (0, 120)):
        made = type(shape)(shape.strip)
    assert len(made.copies) == 3
    return made


BUILD123D_MOTIONS = {
    "as made": lambda shape: shape,
    "moved": lambda shape: bd.Pos(3, 70, 8) * shape,
    "in place": lambda shape: shape.move(bd.Pos(3, 70, 8)),
    "on a plane": lambda shape: ONTO * shape,
    "turned": lambda shape: shape.rotate(bd.Axis.X, 35).rotate(bd.Axis.Z, 110, transform=True),
    "aligned": lambda shape: type(shape)(shape.strip, align=bd.Align.MIN),
    "rotation": lambda shape: type(shape)(shape.strip, rotation=40),
    "mirrored": lambda shape: (bd.Pos(3, 70, 8) * shape).mirror(bd.Plane.YZ).moved(bd.Rot(Y=30)),
    "turned over": lambda shape: shape.mirror(bd.Plane.XY),
    "mirrored twice": lambda shape: shape.mirror(bd.Plane.XZ.offset(9)).mirror(ONTO),
    "copied": lambda shape: bd.Pos(0, 50) * copy.copy(bd.Pos(9, 0) * shape),
    "copied deeply": lambda shape: bd.Pos(0, 50) * copy.deepcopy(bd.Pos(9, 0) * shape),
    "in rows": _in_rows,
    "rows moved": lambda shape: ONTO * _in_rows(shape),
    "rows mirrored": lambda shape: _in_rows(shape).mirror(bd.Plane.YZ),
}


def _bodies(plain, motions, usual):
    """Each motion of plain parts, and of both bodies of a laminate, which is slow."""
    laminates = (
        pytest.param("laminate", motion, marks=() if motion == usual else pytest.mark.campaign)
        for motion in motions
    )
    return [*product(plain, motions), *laminates]


@pytest.mark.parametrize(
    ("kind", "motion"), _bodies(("FlatStrip", "StripOutline"), BUILD123D_MOTIONS, "rows moved")
)
def test_engraving_is_on_the_moved_part_of_build123d(kind, motion):
    from elastica_cad.build123d import FlatStrip, StripOutline

    make = StripOutline if kind == "StripOutline" else FlatStrip
    if motion == "rotation" and make is FlatStrip:
        shape = FlatStrip(_slotted(kind), rotation=(20, 30, 40))
    else:
        shape = BUILD123D_MOTIONS[motion](make(_slotted(kind)))
    assert len(shape.engraving) == sum(len(body.engraving) for body in shape.copies)
    for body in shape.copies:
        _require_engraved(body.faces(), body.engraving, body.strip)


CADQUERY_MOTIONS = {
    "as made": lambda shape: shape,
    "moved": lambda shape: shape.moved(cq.Location((3, 70, 8), (1, 2, 3), 50)),
    "located": lambda shape: shape.moved(cq.Location((1, 1, 1))).located(cq.Location((3, 70, 8))),
    "in place": lambda shape: shape.move(cq.Location((3, 70, 8))),
    "translated": lambda shape: shape.translate(cq.Vector(3, 70, 8)),
    "turned": lambda shape: shape.rotate((0, 0, 5), (1, 2, 5), 75),
    "mirrored": lambda shape: shape.moved(cq.Location((3, 70, 8))).mirror("YZ", (4, 0, 0)),
    "turned over": lambda shape: shape.mirror("XY"),
    "mirrored twice": lambda shape: shape.mirror("XZ", (0, 9, 0)).mirror((1, 2, 3)),
    "copied": lambda shape: shape.translate(cq.Vector(3, 70, 8)).copy().moved(cq.Location((0, 5, 0))),
    "cleaned": lambda shape: shape.translate(cq.Vector(3, 70, 8)).clean(),
    "on a workplane": lambda shape: (
        cq.Workplane("XZ", (9, 9, 9)).add(shape).rotate((0, 0, 0), (1, 0, 0), 9).val()
    ),
}


@pytest.mark.parametrize(("kind", "motion"), _bodies(("flat", "outline"), CADQUERY_MOTIONS, "moved"))
def test_engraving_is_on_the_moved_part_of_cadquery(kind, motion):
    from elastica_cad.cadquery import flat_strip, strip_outline

    make = strip_outline if kind == "outline" else flat_strip
    body = CADQUERY_MOTIONS[motion](make(_slotted(kind)))
    _require_engraved(body.Faces(), body.engraving, body.strip)


@pytest.mark.parametrize("form", ["flat", "outline"])
def test_engraving_is_on_every_strip_of_a_workplane(form):
    from elastica_cad.cadquery import Workplane

    work = Workplane("XZ").spline([(0, 0), (60, 50), (120, 0)]).pushPoints([(0, 0), (9, 40), (0, 80)])
    bodies = work.elasticStrip("polypropylene-0.5", max_width=20, form=form, label="A1", color="red").vals()
    assert len(bodies) == 3
    for body in bodies:
        _require_engraved(body.Faces(), body.engraving, body.strip)
        assert body.color.toTuple()[:3] == pytest.approx((1, 0, 0))


def _slotted(kind):
    """Return a strip that is not symmetric, because its mirrored body has another outline."""
    if kind == "laminate":
        return ec.StripSpec(
            ARCH, "pom-0.5", label="A1", style=ec.Laminated(width=24, backing="card-200gsm")
        ).make()
    slots = (ec.Slot(40, 1, side="upper"), ec.Slot(90, 1, side="lower"))
    return ec.StripSpec(ARCH, "birch-plywood-0.8", label="A1", max_width=24, slots=slots).make()


def _require_engraved(faces, edges, strip):
    """Require that all strokes of a text are inside one face."""
    strokes = [item.path for item in strip.drawing().strokes if item.layer == "ENGRAVE"]
    assert len(edges) == sum(len(path.segments) for path in strokes) > 4
    edges = [bd.Edge(edge.wrapped) for edge in edges]
    dots = [bd.Vertex(edge @ place) for edge in edges for place in (0, 0.5, 1)]
    on_face = [
        face for face in (bd.Face(face.wrapped) for face in faces) if max(map(face.distance_to, dots)) < 1e-6
    ]
    assert len(on_face) == 1
