"""Bodies of laminates in scripts: cut, cut again, in common with a box, and unchanged by all that."""

import random

import build123d as bd
import cadquery as cq
import pytest

from elastica_cad import (
    Frame,
    Hole,
    InputError,
    Laminated,
    Path,
    Sheet,
    Strip,
    Tab,
    build123d,
    cadquery,
    optimal_rod,
)
from elastica_cad.kernel import occt
from elastica_cad.strip import BentSolid, FlatSolid
from tests.campaign.bank import CURVES

BASES = ("card-200gsm", "pom-0.5", "birch-plywood-0.8")
BACKINGS = ("card-200gsm", "birch-plywood-0.8")
EVERYDAY = "short arc", "birch-plywood-0.8"
FORTY = [
    pytest.param(curve, backing, form, marks=() if (curve, backing) == EVERYDAY else pytest.mark.campaign)
    for curve in (EVERYDAY[0], *sorted(set(CURVES) - {EVERYDAY[0]})[:19])
    for backing in BACKINGS
    for form in (FlatSolid, BentSolid)
]
LARGEST_TOLERANCE = 1e-5  # mm
RELATIVE = 1e-5  # of the volume: a sheet on the outside of a bend is longer by the glue


def laminate(curve, backing):
    """A laminate of random sizes; some curves ask for more than a thin backing on a thick base can give."""
    chance = random.Random(f"{curve} {backing}")
    ends = chance.choice(
        [(Tab(0), Tab(0)), (Tab(10), Tab(14)), (Tab(12, holes=(Hole(6, 3.2),)), Tab(14, corner_radius=3))]
    )
    style = Laminated(width=chance.uniform(10, 40), backing=Sheet.named(backing), least_backing=0.2)
    for base in chance.sample(BASES, 3):
        try:
            return Strip(optimal_rod(CURVES[curve]), Sheet.named(base), style=style, ends=ends)
        except InputError:
            continue
    raise AssertionError(f"no base for {backing} on {curve}")


def box_through(record, strip, shift):
    """Corner and sizes of a box that reaches through both sheets, well off the middle."""
    chance = random.Random(f"{strip.rod.length} {shift}")
    at = strip.rod.length * chance.uniform(0.2, 0.8)
    size = (strip.rod.length / 5, 0.37 * float(strip.width.extremes[1]), 6.0)
    if isinstance(record, FlatSolid):
        return (at, shift, -3.0), size
    point = strip.rod.curve.at([at]).position[0]
    return (point[0] - size[0] / 2, point[1] - size[0] / 2, shift), (size[0], size[0], size[1])


def vertex_tolerances(shape):
    from OCP.BRep import BRep_Tool

    kernel = occt.kernel()
    vertices = occt.sub_shapes(shape, "vertex")
    return [BRep_Tool.Tolerance_s(kernel.as_vertex(vertex)) for vertex in vertices]


def in_build123d(records, strip, boxes):
    made = build123d.BentStrip if isinstance(records[0], BentSolid) else build123d.FlatStrip
    body = made(strip, mode=bd.Mode.PRIVATE)
    first, second = (
        bd.Pos(*at) * bd.Box(*size, align=bd.Align.MIN, mode=bd.Mode.PRIVATE) for at, size in boxes
    )
    yield body.wrapped
    cut = body - first
    yield from (cut.wrapped, (cut - second).wrapped, (body & first).wrapped, (first - body).wrapped)


def in_cadquery(records, strip, boxes):
    made = cadquery.bent_strip if isinstance(records[0], BentSolid) else cadquery.flat_strip
    body = made(strip)
    first, second = (cq.Solid.makeBox(*size, pnt=cq.Vector(*at)) for at, size in boxes)
    yield body.wrapped
    cut = body.cut(first)
    yield from (cut.wrapped, cut.cut(second).wrapped, body.intersect(first).wrapped, first.cut(body).wrapped)


def sums_of_parts(records, boxes, measured):
    """Volumes of the sheets one by one: whole, cut, cut again, in common; and of the first box less the sheets."""
    kernel = occt.kernel()
    operations = kernel.BOPAlgo_Operation
    first, second = (
        occt.make_solid(FlatSolid(Path.rectangle(*size[:2]), (), size[2], Frame(at))) for at, size in boxes
    )
    sheets = list(map(occt.make_solid, records))
    cut = [occt._combined(sheet, [first], operations.BOPAlgo_CUT) for sheet in sheets]
    again = [occt._combined(sheet, [second], operations.BOPAlgo_CUT) for sheet in cut]
    common = [occt._combined(sheet, [first], operations.BOPAlgo_COMMON) for sheet in sheets]
    sums = [sum(map(measured, shapes)) for shapes in (sheets, cut, again, common)]
    return [*sums, measured(first) - sums[-1]]


@pytest.mark.parametrize("library", [in_build123d, in_cadquery])
@pytest.mark.parametrize(("curve", "backing", "form"), FORTY)
def test_booleans_of_laminates(curve, backing, form, library, measure):
    strip = laminate(curve, backing)
    records = form.layers(strip)
    boxes = [box_through(records[0], strip, shift) for shift in (-1.3, 0.9)]

    def measured(shape):
        solids = occt.sub_shapes(shape, "solid")
        return sum(measure.volume(solid, bent=form is BentSolid) for solid in solids)

    bodies = library(records, strip, boxes)
    body = next(bodies)
    tolerances = vertex_tolerances(body)
    results = list(bodies)
    assert max(tolerances) <= LARGEST_TOLERANCE
    assert vertex_tolerances(body) == tolerances
    assert all(measure.is_valid(shape) for shape in (body, *results))
    whole, *parts = sums_of_parts(records, boxes, measured)
    assert measured(body) == pytest.approx(whole, rel=RELATIVE)
    assert list(map(measured, results)) == pytest.approx(parts, abs=RELATIVE * whole)
