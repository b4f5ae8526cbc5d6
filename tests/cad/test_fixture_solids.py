"""Fixtures and base plates in OpenCASCADE: whole bodies that hold the bent strip without touching it."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from elastica_cad import Frame, Hole, Model, Path, Placed, PlaneCurve, Sheet, Strip, Tab, optimal_rod
from elastica_cad.kernel import occt
from elastica_cad.kernel.mesh_files import write_stl
from elastica_cad.kernel.step_files import NamedShape, read_step_shape, step_bytes
from elastica_cad.model import EndFixture
from elastica_cad.model.fixtures import engraved
from elastica_cad.strip import BentSolid, FlatSolid, PrismSolid, Text, text_strokes
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

UPRIGHT = Frame((0, 0, 0), (1, 0, 0), (0, 0, 1))


@pytest.fixture(scope="module")
def strip():
    rod = optimal_rod(PlaneCurve.ellipse((0, 0), (100.0, 60.0), 0.0, 0.3, np.pi - 0.5))
    ends = (Tab(14), Tab(12, width=16, holes=(Hole(6, 3.0, 2.0),)))
    return Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=24.0, ends=ends, label="A")


def common(a, b):
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

    return BRepAlgoAPI_Common(a, b).Shape()


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("floor", [None, Frame((0, 0, -30.0))])
def test_a_block_is_one_body_that_clears_the_strip(strip, measure, end, floor):
    fixture = EndFixture.of(strip, end, UPRIGHT, floor=floor, engrave="")
    body = occt.make_solid(fixture.solid)
    assert measure.is_valid(body)
    bent = occt.make_solid(BentSolid.of(strip, UPRIGHT))
    unleaned = occt.make_solid(replace(fixture, lean=(0.0, 0.0)).solid)
    assert abs(measure.volume(common(unleaned, bent), bent=False)) < 1e-6
    tight = EndFixture.of(strip, end, UPRIGHT, floor=floor, engrave="", clearance=0.0)
    held = FlatSolid(
        Path.rectangle(fixture.tab.length, fixture.tab.width, corner=(0, -fixture.tab.width / 2)),
        thickness=1.0,
        frame=fixture.tab.frame.shifted(z=0.4),
    )
    grip = measure.volume(common(occt.make_solid(tight.solid), occt.make_solid(held)), bent=False)
    holes = sum(np.pi * hole.diameter**2 / 4 for hole in fixture.tab.shape.holes)
    assert grip == pytest.approx(fixture.tab.length * fixture.tab.width - holes, rel=1e-6)


def test_letters_take_a_little_away(strip, measure):
    plain, marked = (occt.make_solid(EndFixture.of(strip, engrave=number).solid) for number in ("", "A:1"))
    assert measure.is_valid(marked)
    gone = measure.volume(plain, bent=False) - measure.volume(marked, bent=False)
    assert 0.5 < gone < 12


@pytest.mark.build123d
def test_stl_of_build123d_is_closed(strip, tmp_path):
    block = bd_strips.BentStrip(strip).fixture("end")
    bd.export_stl(block, tmp_path / "block.stl")
    printed = trimesh.load(tmp_path / "block.stl")
    assert printed.is_watertight
    assert printed.volume == pytest.approx(block.volume, rel=1e-3)


@pytest.mark.cadquery
def test_stl_of_cadquery_is_closed(strip, tmp_path):
    block = cq_strips.bent_strip(strip).fixture("end")
    cq.exporters.export(cq.Workplane(obj=block), str(tmp_path / "block.stl"))
    printed = trimesh.load(tmp_path / "block.stl")
    assert printed.is_watertight
    assert printed.volume == pytest.approx(block.Volume(), rel=1e-3)


def test_letters_stay_small_in_a_file(strip):
    sizes = {}
    for number in ("", "A:1", "PAVILION"):
        body = occt.make_solid(EndFixture.of(strip, engrave=number).solid)
        sizes[number] = len(step_bytes([NamedShape("block", body)], name="block"))
    assert sizes["A:1"] < 3 * sizes[""]
    assert sizes["PAVILION"] < 7 * sizes[""]


def test_a_file_of_plain_faces_has_each_edge_once(strip, tmp_path, measure):
    """Planes and cylinders need no second drawing of their edges; the sides of a bent strip keep theirs."""
    block = occt.make_solid(EndFixture.of(strip, engrave="ARCH:1").solid)
    bent = occt.make_solid(BentSolid.of(strip, UPRIGHT))
    written = {"block": [NamedShape("block", block)]}
    written["both"] = [*written["block"], NamedShape("strip", bent)]
    for name, parts in written.items():
        path = tmp_path / f"{name}.step"
        path.write_bytes(step_bytes(parts, name=name))
        content = path.read_bytes()
        assert (b"PCURVE(" in content) == (name == "both")
        back = read_step_shape(path)
        assert measure.is_valid(back)
        whole = sum(measure.volume(part.shape, bent=False) for part in parts)
        assert measure.volume(back, bent=False) == pytest.approx(whole, rel=1e-6)


@pytest.mark.parametrize("number", ["", "A:1", "K2:2", "80O&g"])
@pytest.mark.parametrize("floor", [None, Frame((0, 0, -30.0))])
def test_a_slicer_finds_a_closed_body_that_stands_on_its_bed(strip, measure, tmp_path, number, floor):
    fixture = EndFixture.of(strip, "end", UPRIGHT, floor=floor, engrave=number)
    body = occt.make_solid(fixture.solid)
    file = tmp_path / "block.stl"
    write_stl(body, file, bed=fixture.ground)
    content = file.read_bytes()
    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    triangles = np.frombuffer(content, row, offset=84)
    assert int.from_bytes(content[80:84], "little") == len(triangles)
    a, b, c = np.moveaxis(triangles["corners"].astype(float), 1, 0)
    volume = np.sum(a * np.cross(b, c)) / 6
    assert volume == pytest.approx(measure.volume(body, bent=False), rel=1e-3)
    assert np.sum(triangles["normal"] * np.cross(b - a, c - a), axis=1).min() > 0
    assert min(one[:, 2].min() for one in (a, b, c)) == pytest.approx(0.0, abs=1e-4)
    # every edge is run once each way
    number_of = np.unique(np.concatenate([a, b, c]), axis=0, return_inverse=True)[1]
    ring = number_of.reshape(3, -1)
    ways = {(i, j) for k in range(3) for i, j in zip(ring[k], ring[(k + 1) % 3], strict=True)}
    assert len(ways) == 3 * len(triangles)
    assert all((j, i) in ways for i, j in ways)


@pytest.mark.campaign
def test_a_long_number_is_engraved_whole(strip, measure):
    number = "STRIP 17 OF THE PAVILION, BENT BY HAND: " * 2
    body = occt.make_solid(EndFixture.of(strip, engrave=number.strip()).solid)
    assert measure.is_valid(body)
    assert len(occt.sub_shapes(body, "face")) > 350


@pytest.mark.parametrize("number", ["80O", "B&g", "abc*#", "pqGd%"])
@pytest.mark.parametrize("height", [1.2, 4.0])
def test_letters_that_close_cross_and_turn_tightly(measure, number, height):
    strokes = text_strokes(Text((0, 0), number, height))
    letters = tuple(engraved(strokes, height, Frame()))
    block = FlatSolid(Path.rectangle(20, 12, corner=(-2, -4)), (), 4.0, Frame().shifted(z=-4))
    marked = occt.make_solid(PrismSolid((block,), letters))
    assert measure.is_valid(marked)
    gone = block.volume - measure.volume(marked, bent=False)
    apart = sum(abs(groove.outline.area) for groove in letters) * letters[0].thickness / 2
    assert 0.6 * apart < gone < apart


def test_a_tab_goes_through_the_base_plate(strip, measure):
    lowest = strip.rod.position[[0, -1], 1]
    assert abs(np.ptp(lowest)) < 40
    placed = Placed(strip, (0, 0, -min(lowest)), (1, 0, 0), (0, 0, 1))
    base = Model([placed]).base_plate(Sheet.named("mdf-3"))
    assert [slot.name for slot in base.slots] == ["A:2"] if lowest[0] > lowest[1] else ["A:1"]
    plate = occt.make_solid(base.solid)
    bent = occt.make_solid(BentSolid.of(strip, placed.frame))
    assert abs(measure.volume(common(plate, bent), bent=False)) < 1e-6


def test_a_leaning_strip_wider_than_its_tab_is_kept_out_of_the_base_plate(measure):
    """Its plane leans by 20 degrees: the lower corner of its end, 15 mm from the middle, would be 5.13 mm below."""
    rod = optimal_rod(PlaneCurve.arc((0, 0), 80.0, 0.0, np.pi))
    strip = Strip(
        rod, Sheet.named("birch-plywood-0.8"), max_width=30, ends=(Tab(30, width=8),) * 2, label="A"
    )
    lean = np.radians(20.0)
    placed = Placed(strip, (0, 0, 0), (1, 0, 0), (0, np.sin(lean), np.cos(lean)))
    bent = occt.make_solid(BentSolid.of(strip, placed.frame))

    def shared(plate):
        return abs(measure.volume(common(occt.make_solid(plate.solid), bent), bent=False))

    with pytest.raises(
        ValueError, match=r"beside the tab of A:1, the strip would enter the plate by 5\.13 mm"
    ):
        Model([placed]).base_plate("mdf-3")
    forced = Model([placed]).base_plate("mdf-3", ignore_limits=True)
    assert len(forced.warnings) == 2
    assert shared(forced) > 10
    lower = Model([placed]).base_plate("mdf-3", frame=Frame((0, 0, -5.4)))
    assert not lower.warnings
    assert shared(lower) < 1e-6
    upright = Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))
    assert not Model([upright]).base_plate("mdf-3").warnings


def test_prisms_must_make_one_body():
    plate = FlatSolid(Path.rectangle(10, 10), thickness=2.0)
    apart = FlatSolid(Path.rectangle(10, 10, corner=(20, 0)), thickness=2.0)
    with pytest.raises(ValueError, match="form 2 separate pieces"):
        occt.make_solid(PrismSolid((plate, apart)))
    with pytest.raises(ValueError, match="of prisms is empty"):
        PrismSolid(())
