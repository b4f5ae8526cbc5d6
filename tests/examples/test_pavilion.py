"""The Pavilion: from formulae to nested files, every file sound, nothing closer than the margin."""

import csv
import io
import json

import numpy as np
import pytest
import shapely

from elastica_cad import read_curves
from elastica_cad.design import read_design
from elastica_cad.model import rocking_tabs
from elastica_cad.strip import CUT_OUTER
from tests.command_line import run

MARGIN = 2.0


@pytest.fixture(scope="module")
def design(project_root):
    return read_design(project_root / "examples" / "pavilion" / "pavilion.toml", read_curves)


@pytest.fixture(scope="module")
def model(design):
    return design.model()


@pytest.fixture(scope="module")
def folder(project_root, tmp_path_factory):
    """Everything that the command writes, but for the assembly."""
    out = tmp_path_factory.mktemp("pavilion")
    file = project_root / "examples" / "pavilion" / "pavilion.toml"
    result = run("model", file, "-o", out, "--no-step")
    assert "31 strips" in result.output
    return out


def test_it_is_the_published_one(design, model):
    assert len(model.placed) == 31
    assert sum(len(strip.slots) for strip in model.strips) == 102
    ratios = [model.strips[i].rod.ratio for i in (0, 15)]
    assert ratios == pytest.approx([2.11702, 1.20212], abs=2e-5)
    for wish in design.entries:
        ends = wish.frame.point(wish.curve.evaluate(np.array(wish.curve.domain)))
        assert ends[:, 2] == pytest.approx([0, 0], abs=1e-9)
        assert np.hypot(*wish.frame.origin[:2]) == pytest.approx(800)


def test_no_loops_come_closer_than_the_margin(model, design):
    nests = model.nest(sheet_size=design.kit.nesting.sheet_size, margin=MARGIN)
    for nest in nests:
        shapes = [shapely.Polygon(path.points(1e-3)) for path in nest.on(CUT_OUTER)]
        assert all(shape.is_valid for shape in shapes)
        first, second = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=MARGIN - 5e-3)
        assert np.all(first == second)
        everything = shapely.union_all(shapes).bounds
        assert min(everything[:2]) >= MARGIN - 1e-6
        assert everything[2] <= 600 - MARGIN + 1e-6
        assert everything[3] <= 400 - MARGIN + 1e-6


def test_rows_are_filled_to_80_percent(model, design):
    """Of the rows' area, and no more sheets than rows of whole strips need."""
    nests = model.nest(sheet_size=design.kit.nesting.sheet_size, margin=MARGIN)
    assert sum(n.filled for n in nests) / sum(n.used for n in nests) > 0.8
    assert len(nests) == -(-31 // int((400 - MARGIN) // (45 + MARGIN)))


@pytest.mark.campaign
def test_every_file_is_sound(folder, check_drawing_file):
    drawings = [path for path in folder.rglob("*") if path.suffix in (".dxf", ".svg")]
    assert len(drawings) == 2 * (31 + 2 + 2 + 4 + 2)  # two plates, nested on a sheet each
    for path in drawings:
        if path.suffix == ".dxf" or path.name.startswith("P1_"):
            check_drawing_file(path)


@pytest.mark.campaign
def test_the_cut_list_names_every_file(folder):
    rows = list(csv.DictReader(io.StringIO((folder / "pavilion-cut-list.csv").read_text())))
    assert len(rows) == 35
    assert all((folder / row["file"]).is_file() for row in rows)
    report = json.loads((folder / "pavilion.json").read_text())
    assert report["schema"] == "elastica-model/1"
    assert set(report["files"]) == {
        path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()
    }
    assert sum(len(sheet["pieces"]) for sheet in report["sheets"]) == 35


@pytest.mark.campaign
def test_both_plates_of_the_base_have_a_slot_for_every_tab_and_let_none_rock(model, design):
    plates, _ = design.kit.holders[0].made(model)
    assert [plate.name for plate in plates] == ["base", "base-lower"]
    for plate in plates:
        assert len(plate.slots) == 62
        assert [slot.size[0] for slot in plate.slots] == pytest.approx([19.0] * 62)
    assert not rocking_tabs(model.placed, plates)
