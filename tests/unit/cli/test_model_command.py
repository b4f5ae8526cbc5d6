"""`elastica model` as a user meets it: one folder of files, messages, exit codes."""

import csv
import json
import re
import sys
from urllib.parse import unquote

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.cli import model_command
from elastica_cad.design import read_design
from elastica_cad.formats import curves_json
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.model.assembly import list_assembly_steps
from elastica_cad.plot import save_assembly_sheet
from elastica_cad.plot.drawing_process import drawing_process
from elastica_cad.strip import CUT_OUTER
from tests.command_line import run

BASE = """
[base]
sheet = "mdf-3"
height = 10
"""
DESIGN = """
schema = 1
name = "kit"
sheet = "birch-plywood-0.8"
max_width = 24

[[strips]]
count = 2
label = "K{i}"
origin = [0, "100 * i", 0]
curve.ellipse = { semi_axes = [150, 100], start = "0.1", end = "pi - 0.1" }

[base]
sheet = "mdf-3"
height = 10

[fixtures]
wall = 3

[cut]
kerf = "sheet"
version = "R12"
"""

TRIANGLE = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")]


@pytest.fixture
def design(tmp_path):
    path = tmp_path / "kit.toml"
    path.write_text(DESIGN)
    return path


@pytest.mark.campaign
def test_a_model_becomes_one_folder(design, tmp_path):
    out = tmp_path / "out"
    with drawing_process(["model"]) as process:  # as `main` starts it
        result = run("model", design, "-o", out, obj=process)
    assert result.exit_code == 0, result.output
    assert "kit: 2 strips (all the same); 3 pieces of 2 shapes" in result.output
    names = {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()}
    assert {
        "index.html",
        "kit-assembly.pdf",
        "kit.json",
        "kit-cut-list.csv",
        "kit-cut-list.txt",
        "model/kit.png",
        "parts/K1_birch-plywood-0.8_0.8mm_x1.svg",
        "parts/K1_birch-plywood-0.8_0.8mm_x1-mm.dxf",
        "sheets/kit-nest-1-birch-plywood-0.8-mm.dxf",
    } <= names
    report = json.loads((out / "kit.json").read_text())
    assert set(report["files"]) == names
    assert "parts/kit-base_mdf-3_3mm_x1-mm.dxf" in (out / "kit-cut-list.txt").read_text()
    if "model/kit.step" in names:
        text = (out / "model" / "kit.step").read_text()
        assert all(f"'{name}'" in text for name in ("K1", "K2", "base", "fixture K1:1", "fixture K2:2"))
    blocks = (
        [f"parts/fixture-K{i}-{k}.stl" for i in (1, 2) for k in (1, 2)] if "model/kit.step" in names else []
    )
    assert sorted(name for name in names if name.endswith(".stl")) == blocks
    message = f"{blocks[0]} to {blocks[-1]}, foot down" if blocks else "without STEP files they are left out"
    assert f"4 blocks to print: {message}" in (out / "index.html").read_text()


@pytest.mark.parametrize(("options", "cure"), [((), "build123d"), (("--no-step",), "leave out --no-step")])
def test_blocks_that_are_not_written_are_named(tmp_path, monkeypatch, options, cure):
    monkeypatch.setitem(sys.modules, "OCP", None)
    path, out = tmp_path / "kit.toml", tmp_path / "out"
    path.write_text(DESIGN.replace("K{i}", "K").replace(BASE, ""))
    result = run("model", path, "-o", out, "--no-pictures", "--no-effects", "--no-parts", *options)
    assert re.search(f"not written: .*STL of fixture K:1 and fixture K:2; .*{cure}", result.output)
    with (out / "kit-cut-list.csv").open() as file:
        assert {row["file"] for row in csv.DictReader(file) if row["sheet"] == "printed"} == {"not written"}


@pytest.mark.campaign
def test_printed_blocks_are_listed_with_the_sizes_of_their_meshes(tmp_path):
    """Three equal arches: one row for each end, with the extents of the triangles in its file."""
    path, out = tmp_path / "kit.toml", tmp_path / "out"
    path.write_text(DESIGN.replace("K{i}", "K").replace("count = 2", "count = 3").replace(BASE, ""))
    assert run("model", path, "-o", out, "--no-pictures").exit_code == 0
    with (out / "kit-cut-list.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["sheet"] == "printed"]
    assert [(row["part"], row["count"], row["mass_g"]) for row in rows] == [
        ("fixture K:1", "3", ""),
        ("fixture K:2", "3", ""),
    ]
    report = json.loads((out / "kit.json").read_text())
    assert report["pieces"] == 3
    for row, block in zip(rows, report["blocks"], strict=True):
        data = np.frombuffer((out / row["file"]).read_bytes()[84:], TRIANGLE)
        extents = sorted(np.ptp(data["corners"].reshape(-1, 3), axis=0))
        listed = [float(row[name]) for name in ("length_mm", "width_mm", "height_mm")]
        assert sorted(listed) == pytest.approx(extents, abs=0.006)
        assert (block["size"], block["color"]) == (pytest.approx(listed, abs=0.006), row["color"])
    table = (out / "kit-cut-list.txt").read_text().splitlines()
    assert [line.split()[:2] for line in table[-2:]] == [["fixture", f"K:{k}"] for k in (1, 2)]
    assert "height over the base mm" in table[-4]
    assert rows[0]["thickness_mm"] == ""


def test_the_same_design_gives_the_same_files(design, tmp_path):
    for folder in ("one", "two"):
        run("model", design, "-o", tmp_path / folder, "--no-step", "--no-pictures")
    written = [path for path in (tmp_path / "one").rglob("*") if path.is_file()]
    assert len(written) > 10
    for path in written:
        assert path.read_bytes() == (tmp_path / "two" / path.relative_to(tmp_path / "one")).read_bytes()


def test_parts_of_an_earlier_run_are_reported(design, tmp_path):
    """A folder goes to the workshop as it is: what the design no longer has must not be cut."""
    quick, out = ("--no-step", "--no-pictures", "--no-effects"), tmp_path / "out"
    assert "earlier run" not in run("model", design, "-o", out, *quick).output
    assert "earlier run" not in run("model", design, "-o", out, *quick, "--force").output
    design.write_text(DESIGN.replace("count = 2", "count = 1"))
    fewer = run("model", design, "-o", out, *quick, "--force")
    left = sorted(path.name for path in (out / "parts").iterdir() if path.name.startswith("K2_"))
    assert len(left) == 2
    assert (
        f"files of an earlier run that do not belong to this model (parts/{left[0]} and others)"
        in fewer.stderr
    )
    for name in left:
        (out / "parts" / name).unlink()
    assert "earlier run" not in run("model", design, "-o", out, *quick, "--force").output


def test_nothing_is_left_of_a_model_that_fails(design, tmp_path):
    out = tmp_path / "out"
    design.write_text(DESIGN.replace("max_width = 24", "max_width = 24\nnest.sheet_size = [300, 200]"))
    result = run("model", design, "-o", out, code=2)
    assert "K1: " in result.stderr
    assert "does not fit on a sheet of 300 by 200 mm" in result.stderr
    assert not out.exists()
    out.mkdir()
    taken = out / "kit.json"
    taken.write_text("mine")
    design.write_text(DESIGN)
    assert "exists already" in run("model", design, "-o", out, "--no-step", code=2).stderr
    assert [path.name for path in out.iterdir()] == ["kit.json"]
    assert taken.read_text() == "mine"


@pytest.mark.parametrize(
    ("out", "sentence"),
    [
        ("kit", "exists already: choose another name, or allow it to be overwritten"),
        ("file", "file is a file, not a folder: choose another folder for the files"),
        ("file/kit", "file is a file, but a folder is needed there: choose another folder"),
        (f"{'long' * 80}", "File name too long; choose another folder"),
    ],
)
def test_where_nothing_can_be_written_is_reported_before_the_model_is_made(
    design, tmp_path, monkeypatch, out, sentence
):
    made = []
    monkeypatch.setattr(model_command, "kit_contents", lambda *_, **__: made.append("model"))
    (tmp_path / "file").write_text("mine")
    (tmp_path / "kit").mkdir()
    (tmp_path / "kit" / "index.html").write_text("mine")
    result = run("model", design, "-o", tmp_path / out, code=2)
    assert sentence in result.stderr
    assert "\nChange " not in result.stderr
    assert not made
    assert not list(tmp_path.glob("**/.elastica-*"))


def test_bad_designs_are_one_sentence(design):
    design.write_text(DESIGN.replace("150, 100", '"os.system(1)", 100'))
    result = run("model", design, code=2)
    assert result.stderr.count("\n") == 1
    assert "strips[1], i = 1 (K1): curve: ellipse: semi_axes[1]" in result.stderr


def test_a_design_that_cannot_be_bent_exits_with_1(design):
    wave = '{ x = "50 * t", y = "40 * sin(t) + 6 * t ** 1.6", t = [0.1, 7.8] }'
    ellipse = next(line for line in DESIGN.splitlines() if line.startswith("curve.ellipse"))
    design.write_text(DESIGN.replace(ellipse, f"curve = {wave}"))
    result = run("model", design, code=1)
    assert result.stderr.startswith("! Error     Not realizable: K1: ")


@pytest.mark.campaign
def test_file_names_suit_every_system(design, tmp_path):
    own = '[sheets."felt 1/2"]\nthickness_mm = 1\nyoungs_modulus_MPa = 20\ndensity_kg_m3 = 300\nmax_strain = 0.1\n'
    text = (
        DESIGN.replace('"kit"', '"my kit/2"')
        .replace('"birch-plywood-0.8"', '"felt 1/2"')
        .replace('"sheet"', "0")
    )
    design.write_text(text.replace('"K{i}"', '"K/{i}"') + own)
    run("model", design, "-o", tmp_path / "out", "--no-step", "--no-pictures")
    names = {path.name for path in (tmp_path / "out").rglob("*")}
    assert {"my-kit-2.json", "my-kit-2-nest-1-felt-1-2.svg", "K-1_felt-1-2_1mm_x1.svg"} <= names
    second = "\n[[strips]]\nlabel = 'k1'\ncurve.ellipse = { semi_axes = [150, 100], start = 0.1, end = 2 }\n"
    design.write_text(DESIGN + second)
    run("model", design, "-o", tmp_path / "two", "--no-step", "--no-pictures")
    rows = csv.DictReader((tmp_path / "two/kit-cut-list.csv").read_text(encoding="utf-8").splitlines())
    files = {row["part"]: row["file"] for row in rows}
    assert files["k1"].endswith("k1_birch-plywood-0.8_0.8mm_x1-2-mm.dxf")
    printed = {part for part, file in files.items() if file == "not written"}  # blocks, which need STEP
    assert all(part.startswith("fixture ") for part in printed)
    assert all((tmp_path / "two" / file).is_file() for part, file in files.items() if part not in printed)


@pytest.fixture
def drawn(tmp_path):
    path = tmp_path / "bow.json"
    path.write_text(curves_json([ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.2, 2.9)]))
    return path


CROSSED = """
schema = 1
name = "crossed"
sheet = "birch-plywood-0.8"
max_width = 24
interlock = { clearance = 0.1 }
cut.holding = { width = 0.4, spacing = 200 }
nest = { sheet_size = [600, 300], margin = 1 }

[[strips]]
label = "A"
curve.ellipse = { semi_axes = [150, 100], start = "0.1", end = "pi - 0.1" }

[[strips]]
label = "B"
origin = [100, 0, 0]
curve.ellipse = { semi_axes = [140, 99], start = "0.1", end = "pi - 0.1" }
"""


@pytest.fixture
def crossed(tmp_path):
    path = tmp_path / "crossed.toml"
    path.write_text(CROSSED)
    return path


def test_what_slots_do_is_reported(crossed, tmp_path):
    out = tmp_path / "out"
    result = run("model", crossed, "-o", out, "--no-step", "--no-pictures")
    assert "deviates most: about" in result.output
    held = json.loads((out / "crossed.json").read_text())["held"]
    for name in ("A", "B"):
        assert 0 < held[name]["parts"]["slots"] < 5
    model = read_design(crossed, ec.read_curves).model()
    assert held["A"]["deviation"] == pytest.approx(model.held()[0].deviation, abs=1e-3)
    (note,) = (line for line in result.stderr.splitlines() if "deviate from their design" in line)
    least, most = sorted(held[name]["deviation"] for name in ("A", "B"))
    assert f"by {least:.2g} mm to {most:.2g} mm" in note


def test_strips_that_run_through_each_other_unslotted_are_reported(crossed, tmp_path):
    """Kits of such strips were written without a word."""
    crossed.write_text(crossed.read_text().replace("interlock = { clearance = 0.1 }", ""))
    quick = ("--no-step", "--no-pictures", "--no-parts", "--no-effects")
    result = run("model", crossed, "-o", tmp_path / "out", *quick)
    (note,) = (line for line in result.stderr.splitlines() if "passes through" in line)
    assert re.fullmatch(
        r"(! )?Note +A \([0-9.]+ mm from its start\) passes through B \(.*\): cut slots \(interlock\), .*",
        note,
    )
    report = json.loads((tmp_path / "out" / "crossed.json").read_text())
    assert note.removeprefix("! ").removeprefix("Note").strip() in report["reports"]


@pytest.mark.campaign
def test_widths_make_up_for_slots_when_requested(crossed, tmp_path):
    found = {}
    for request in ("false", "true"):
        path = tmp_path / f"{request}.toml"
        path.write_text(
            crossed.read_text().replace("max_width = 24", f"max_width = 24\ncompensate = {request}")
        )
        run("model", path, "-o", tmp_path / request, "--no-step", "--no-pictures")
        (report,) = (tmp_path / request).glob("**/crossed.json")
        found[request] = {
            name: held["deviation"] for name, held in json.loads(report.read_text())["held"].items()
        }
    for name in ("A", "B"):
        assert found["true"][name] < 0.2 * found["false"][name]


def test_the_sheets_alone(crossed, tmp_path):
    out = tmp_path / "out"
    quick = ("--no-step", "--no-pictures", "--no-parts", "--no-effects")
    result = run("model", crossed, "-o", out, *quick)
    assert "deviates" not in result.output
    sheet = "crossed-nest-1-birch-plywood-0.8"
    ends = ("-cut-list.csv", "-cut-list.txt", ".json")
    assert {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()} == {
        "index.html", f"sheets/{sheet}.dxf", f"sheets/{sheet}.svg", *(f"crossed{end}" for end in ends)
    }  # fmt: skip
    assert (out / "crossed-cut-list.csv").read_text().count(f"sheets/{sheet}.dxf") == 2
    report = json.loads((out / "crossed.json").read_text())
    assert not report["held"]


@pytest.mark.campaign
def test_bridges_hold_the_parts(crossed, drawn, tmp_path):
    """Open cuts on the outer layer."""
    import ezdxf

    for given, width in (((), 0.4), (("--set", "cut.holding.width=1.5"), 1.5)):
        out = tmp_path / f"out{width}"
        run("model", crossed, "-o", out, "--no-step", "--no-pictures", "--no-effects", *given)
        (part,) = out.glob("parts/A_*.dxf")
        cuts = [e for e in ezdxf.readfile(part).modelspace() if e.dxf.layer == "CUT_OUTER"]
        assert cuts
        assert not any(cut.dxftype() == "LWPOLYLINE" and cut.closed for cut in cuts)
    sizes = ("--sheet", "birch-plywood-0.8", "--max-width", 24)
    whole = run("strip", drawn, *sizes, "-o", tmp_path / "whole")
    held = run("strip", drawn, *sizes, "--set", "cut.holding.width=0.5", "-o", tmp_path / "held")
    assert (whole.exit_code, held.exit_code) == (0, 0), held.output
    first, second = ((tmp_path / name / f"{drawn.stem}.svg").read_text() for name in ("whole", "held"))
    assert first.count("Z") > second.count("Z") == 0
    run("strip", drawn, *sizes, "--set", "cut.holding.width=-1", "-o", tmp_path, code=2)


@pytest.mark.campaign
def test_what_cannot_be_cut_is_made_anyway_only(design, tmp_path):
    """A base slot as wide as a finger; and a slot of a neighbour that leaves a strip a neck."""
    design.write_text(DESIGN.replace("height = 10", "height = 10\nslot_width = 9"))
    refused = run("model", design, "-o", tmp_path / "out", code=1)
    assert (
        "the slot for K1:1 (and 3 more) is 9 mm wide, but a tab 0.8 mm thick is held only" in refused.output
    )
    assert not (tmp_path / "out").exists()
    design.write_text(
        DESIGN.replace('label = "K{i}"', 'label = "K{i}"\nslots = [{ at = 30, width = 1, depth = 20 }]')
    )
    refused = run("model", design, "-o", tmp_path / "out", code=1)
    assert "K1: only" in refused.output
    written = run(
        "model",
        design,
        "-o",
        tmp_path / "out",
        "--ignore-limits",
        "--no-effects",
        "--no-pictures",
        "--no-step",
    )
    assert "! Note      Made anyway: K1: only" in written.stderr
    reports = json.loads((tmp_path / "out" / "kit.json").read_text())["reports"]
    assert sum(text.startswith("Made anyway: K1: only") for text in reports) == 1


def test_the_stock_of_a_design_holds_for_its_plates_too(design, tmp_path):
    design.write_text(DESIGN.replace("max_width = 24", "max_width = 24\nshop = { stock = [600, 120] }"))
    refused = run("model", design, "-o", tmp_path / "out", code=1)
    assert "base: 324.3 x 147.5 mm is larger than the stock of 600 x 120 mm in mdf-3" in refused.output


def test_plates_keep_their_own_distance(design):
    """A piece of the base lies as far from the sheet's edge as its own margin says, those of strips as theirs."""
    design.write_text(DESIGN.replace("height = 10", "height = 10\nmargin = 17"))
    read = read_design(design, ec.read_curves)
    corners = [
        np.concatenate([path.points(0.01) for path in nest.on(CUT_OUTER)]).min(axis=0)
        for nest in kit_contents(read.model(), read.kit).nests
    ]
    assert corners[0] == pytest.approx([2, 2], abs=0.5)
    assert corners[1] == pytest.approx([17, 17], abs=0.5)


def test_feet_of_copies_are_one_part_of_the_cut_list(design, tmp_path):
    """Copies of a strip have one label: their feet were refused as two parts of one file."""
    design.write_text(
        DESIGN.replace("[fixtures]\nwall = 3", "feet = 8")
        + "[[patterns]]\nrepeat = { count = 2, step = [0, 300, 0] }\n"
    )
    quick = ("--no-step", "--no-pictures", "--no-effects")
    run("model", design, "-o", tmp_path / "out", *quick)
    rows = csv.DictReader((tmp_path / "out" / "kit-cut-list.csv").read_text().splitlines())
    feet = {row["part"]: int(row["count"]) for row in rows if "foot" in row["part"]}
    assert len(feet) == 8
    assert set(feet.values()) == {2}


@pytest.mark.campaign
def test_the_start_page_shows_and_links_every_file(design, tmp_path):
    out = tmp_path / "out"
    run("model", design, "-o", out, "--no-step")
    page = (out / "index.html").read_text(encoding="utf-8")
    linked = {unquote(one) for one in re.findall(r'(?:href|src)="([^"]+)"', page)}
    written = {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()}
    assert linked == written - {"index.html"}
    assert "2 strips (all the same); 3 pieces, " in page
    assert "kit-nest-1-birch-plywood-0.8: 2 pieces take 8 % of a sheet of 600 by 400 mm." in page


def test_the_start_page_of_a_single_strip_counts_one(tmp_path):
    alone = tmp_path / "alone.toml"
    alone.write_text(DESIGN.replace("count = 2", "count = 1").split("[base]")[0])
    run("model", alone, "-o", tmp_path / "out", "--no-step", "--no-pictures")
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    assert "1 strip; 1 piece, " in page
    assert ": 1 piece takes " in page
    assert "<p>A strip starts (1) where its label starts.</p>" in page


def test_an_error_comes_with_the_assumed_axis(tmp_path):
    profile = ec.PlaneCurve.fit([(50, 0), (62, 20), (65, 35), (60, 60)])
    ec.write_curves([profile], tmp_path / "profile.json")
    vase = tmp_path / "vase.toml"
    vase.write_text(
        "[revolution]\nsheet = 'card-200gsm'\ncurve = { file = 'profile.json' }\n[nest]\nsheet_size = [50, 50]\n"
    )
    result = run("model", vase, "-o", tmp_path / "out", "--no-effects", code=2)
    assert re.search(
        r"The axis is x = 0 .*\n.*does not fit on a sheet of 50 by 50 mm", result.output, re.DOTALL
    )


def test_base_and_strips_carry_matching_numbers(design):
    read = read_design(design, ec.read_curves)
    kit = kit_contents(read.model(), read.kit)
    engraved = {piece.name: [text.text for text in piece.drawing.texts] for piece in kit.pieces}
    assert engraved["K1"] == ["K1", "1", "2"]
    assert engraved["kit-base"] == ["K1:1", "K1:2", "K2:1", "K2:2", "base"]
    assert any(text.startswith("base: the tips of the tabs are up to ") for text in kit.notes)
    (piece,) = (piece for piece in kit.pieces if piece.name == "K1")
    first, second = (text.position[0] for text in piece.drawing.texts[1:])
    assert 0 < first < 15
    assert second > piece.bounds[1, 0] - 30
    steps = list_assembly_steps(kit.model, kit.holders)
    assert steps[1].ends == ("slot K2:1 of base and block K2:1", "slot K2:2 of base and block K2:2")


def test_a_nested_sheet_has_a_border_and_reports_its_share(design, tmp_path):
    import ezdxf

    out = tmp_path / "out"
    design.write_text(DESIGN.replace('version = "R12"', ""))
    text = run("model", design, "-o", out, "--no-step", "--no-pictures", "-v").output
    assert "kit-nest-1-birch-plywood-0.8: 2 pieces, 8 % of the sheet" in text
    document = ezdxf.readfile(out / "sheets" / "kit-nest-1-birch-plywood-0.8.dxf")
    (border,) = (one for one in document.modelspace() if one.dxf.layer == "SHEET")
    assert border.closed
    corners = np.array(border.get_points("xy"))
    assert (corners.min(axis=0).tolist(), corners.max(axis=0).tolist()) == ([0, 0], [600, 400])
    assert document.layers.get("SHEET").dxf.plot == 0
    part = ezdxf.readfile(next((out / "parts").glob("K1_*.dxf")))
    assert "SHEET" not in part.layers


def test_the_assembly_sheet_names_every_end(design, tmp_path):
    steps = save_assembly_sheet(read_design(design, ec.read_curves).model(), tmp_path / "alone.pdf")
    assert len(steps) == 2
    assert all(end.startswith("hold at (") for step in steps for end in step.ends), "nothing else holds them"
    content = (tmp_path / "alone.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert content.count(b"/Type /Page ") == 1


@pytest.mark.campaign
@pytest.mark.parametrize("option", ["--parts", "--no-parts"])
def test_the_assembly_sheet_names_files_that_are_there(option, design, tmp_path, monkeypatch):
    """Without single parts it named files of these."""
    shown = []

    def write(model, path, *, holders, cut_list, language):
        shown.extend(row.file for row in cut_list.rows)
        path.write_bytes(b"%PDF")

    monkeypatch.setattr("elastica_cad.plot.assembly_sheet.save_assembly_sheet", write)
    out = tmp_path / "out"
    run("model", design, "-o", out, "--no-step", option)
    assert shown
    assert [file for file in shown if not (out / file).is_file()] == []


@pytest.mark.campaign
def test_the_model_is_written_for_screens(design, tmp_path):
    pytest.importorskip("OCP")
    import trimesh

    out = tmp_path / "out"
    run("model", design, "-o", out, "--no-pictures")
    scene = trimesh.load(out / "model" / "kit.glb")
    names = {str(name) for name in scene.graph.nodes}
    assert {"K1", "K2", "base", "fixture K1:1"} <= names
    low, high = scene.bounds * 1000  # y is up, in m
    assert high[1] == pytest.approx(100.4, abs=0.2)
    assert low[1] < 0


def test_a_slip_beside_braces_is_mended_too(tmp_path):
    """What stands in the file may hold braces, which are no gaps of a sentence."""
    (tmp_path / "a.toml").write_text('schema = 1\nsheet = birch{plywood\n[[strips]]\nlabel = "A{i"\n')
    done = run("model", tmp_path / "a.toml", "-o", tmp_path / "out", code=2)
    assert "is not a valid TOML file" in done.output


def test_what_twelve_ribs_share_is_reported_once(tmp_path):
    """Of a lamp the same warning filled the screen, rib by rib, and hid the others."""
    (tmp_path / "rib.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200">'
        '<path d="M 60 190 C 95 150 120 110 95 70 C 85 54 60 40 45 12"/></svg>'
    )
    design = tmp_path / "lamp.toml"
    design.write_text(
        'schema = 1\nname = "lamp"\nsheet = "birch-plywood-0.8"\nmax_width = 22\n[[strips]]\ncount = 12\n'
        'label = "R{i}"\ncurve = "rib.svg"\nsmooth = 0.5\norigin = ["100 * i", 0, 0]\n'
        "[nest]\nsheet_size = [600, 300]\n"
    )
    result = run(
        "model", design, "-o", tmp_path / "kit", "--no-effects", "--no-pictures", "--no-step", "--no-parts"
    )
    (note,) = (line for line in result.stderr.splitlines() if "curvature jumped" in line)
    assert note.startswith(
        "! Note      R1: The curvature jumped or had a kink where pieces of the curve meet."
    )
    assert note.endswith("(and 11 more like this)")


def test_equal_strips_have_one_row_with_their_number(design, tmp_path):
    design.write_text(DESIGN.replace('label = "K{i}"', 'label = "K"'))
    made = run("model", design, "-o", tmp_path / "kit", "--no-pictures", "--no-step", "--no-parts")
    (row,) = (line for line in made.stdout.splitlines() if line.startswith("K "))
    assert row.startswith("K x 2       376.6 mm long")
    (part,) = json.loads((tmp_path / "kit" / "kit.json").read_text())["parts"]
    used = 100 * part["largest_strain"] / ec.Sheet.named(part["sheet"]).max_strain
    assert f"; strain {used:.0f} % of the limit, stable; " in row
    assert "accurate to about" in row


def test_pieces_of_a_long_strip_leave_the_margin_of_the_sheet(tmp_path):
    """The stock is the sheet that parts are laid on, as one would write it; pieces of 600 mm were refused there."""
    path = tmp_path / "long.toml"
    path.write_text(
        'schema = 1\nname = "long"\nsheet = "birch-plywood-0.8"\nmax_width = 24\n'
        "shop = { stock = [600, 400], lap = 40 }\nnest = { sheet_size = [600, 400], margin = 3 }\n"
        '[[strips]]\nlabel = "A"\n'
        'curve.ellipse = { semi_axes = [399.4, 399.4], start = "0.1", end = "pi - 0.1" }\n'
    )
    out = tmp_path / "out"
    run("model", path, "-o", out, "--no-step", "--no-pictures", "--no-effects")
    with (out / "long-cut-list.csv").open() as file:
        lengths = [float(row["length_mm"]) for row in csv.DictReader(file)]
    assert 1194 < sum(length for length in lengths if length > 100) < 1196
    assert max(lengths) <= 594


LEAVES = """
schema = 1
name = "mast"
sheet = "gfrp-1"

[[strips]]
label = "BAT"
section = { kind = "thickness", limits = [1, 4], width = 20 }
curve = { spline = [[0, 0], [60, 50], [150, 70], [240, 50], [300, 0]] }

[[strips]]
label = "LEAF"
section = { kind = "leaves", leaves = 4, width = 20 }
origin = [0, 60, 0]
curve = { spline = [[0, 0], [60, 50], [150, 70], [240, 50], [300, 0]] }
limits = { ratio = 10 }
"""


@pytest.mark.campaign
def test_glued_leaves_beside_strips_that_are_held(tmp_path):
    path = tmp_path / "mast.toml"
    path.write_text(LEAVES + '[fixtures]\nstrips = ["BAT"]\n')
    done = run("model", path, "-o", tmp_path / "kit")
    parts = {file.name for file in (tmp_path / "kit" / "parts").iterdir()}
    assert {"fixture-BAT-1.stl", "fixture-BAT-2.stl", "LEAF_gfrp-1_1mm_x1.dxf"} <= parts
    assert "LEAF" in (tmp_path / "kit" / "mast-cut-list.txt").read_text()
    path.write_text(LEAVES + "[fixtures]\n")
    done = run("model", path, "-o", tmp_path / "all", code=2)
    assert "LEAF: " in done.output
    assert not (tmp_path / "all").exists()


POLES = """
name = "tent"
sheet = "glass-rod-4"
[[strips]]
label = "P"
count = 5
curve = "pole.csv"
section = { kind = "rod", limits = [4, 4] }
limits = {}
origin = [0, "300 * i", 0]
"""


def cut_only(design, out, *settings):
    options = [word for setting in settings for word in ("--set", setting)]
    result = run("model", design, "-o", out, "--no-step", "--no-pictures", "--no-effects", *options)
    assert result.exit_code == 0, result.output
    return result.output


def test_a_kit_of_rods_lists_the_lengths_to_saw(tmp_path):
    """Of five poles of 726 mm, three fit a rod of 2.25 m, and two a rod of 1.5 m. No sheet is nested."""
    (tmp_path / "pole.csv").write_text("x mm,y mm\n0,0\n150,110\n310,150\n470,110\n620,0\n")
    design = tmp_path / "tent.toml"
    design.write_text(POLES)
    for length, rods in (("2250", 2), ("1500", 3)):
        out = tmp_path / length
        bought = f"{rods} rods of Pultruded glass rod 4 mm, {length} mm long"
        assert bought in cut_only(design, out, f"shop.stock=[{length}, 100]")
        assert bought in (out / "index.html").read_text()
        (stock,) = json.loads((out / "tent.json").read_text())["stock"]
        assert (stock["size"], stock["count"]) == ([float(length)], rods)
        sawn = [[float(part) for part in re.findall(r"[\d.]+(?= \(P\))", line)] for line in stock["sawn"]]
        assert sum(map(len, sawn)) == 5
        assert all(sum(parts) < float(length) for parts in sawn)
        assert not (out / "sheets").exists()
        with (out / "tent-cut-list.csv").open() as file:
            assert {row["grain"] for row in csv.DictReader(file)} == {""}
        heads, _, pole, *_ = (out / "tent-cut-list.txt").read_text().splitlines()
        assert pole[heads.index("cut mm") :][: len("cut mm")].strip() == ""
    cut_only(design, tmp_path / "service", "cut.for=service")
    assert not [*(tmp_path / "service").rglob("*.dxf")]
    short = cut_only(design, tmp_path / "short", "shop.stock=[500, 100]")
    assert "P: longer than the rods that you buy (500 mm)" in short
    assert "10 rods" not in short  # the rests of two poles share a rod
    assert "8 rods of Pultruded glass rod 4 mm, 500 mm long" in short


def test_the_cut_list_says_how_many_sheets_to_buy(tmp_path):
    (tmp_path / "kit.toml").write_text(DESIGN.replace("count = 2", "count = 3"))
    message = cut_only(
        tmp_path / "kit.toml", tmp_path / "out", "nest.sheet_size=[450, 60]", "base.sheet_size=[500, 500]",
        "nest.price=[12.5, 0.8]",
    )  # fmt: skip
    listed = (tmp_path / "out" / "kit-cut-list.txt").read_text()
    for line in ("2 sheets of Birch plywood 0.8 mm, 450 x 60 mm", "1 sheet of MDF 3 mm, 500 x 500 mm"):
        assert line in listed
        assert line in message
    assert len([*(tmp_path / "out" / "sheets").glob("kit-nest*.dxf")]) == 2
    with (tmp_path / "out" / "kit-cut-list.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["sheet"] != "printed"]
    millimetres = sum(int(row["count"]) * float(row["cut_length_mm"]) for row in rows)
    cost = float(re.search(r"price ([0-9.]+): 3 sheets at 12.5", listed)[1])
    assert cost == pytest.approx(3 * 12.5 + 0.8 * millimetres / 1000, abs=0.01)
    strip = next(row for row in rows if row["sheet"] == "birch-plywood-0.8")
    assert (strip["pierces"], float(strip["area_cm2"])) == (
        "1",
        pytest.approx(float(strip["mass_g"]) / 0.8 / 0.68 * 10, rel=2e-3),
    )


@pytest.mark.parametrize(
    ("more", "sizes", "fault"),
    [
        ("nest.sheet_size=[600,400]", ("991.9", "929.2"), "does not fit on a sheet of 600 by 400 mm"),
        ("shop.stock=[700,25]", ("991.9", "231.2", "929.2"), "is larger than the stock of 700 x 25 mm"),
    ],
)
def test_all_strips_that_are_too_large_are_refused_before_one_is_made(
    more, sizes, fault, tmp_path, monkeypatch
):
    monkeypatch.setattr("elastica_cad.design.design_file.Design.model", None)
    arcs = {"A": "[400, 300], start = 0.2, end = 2.9", "B": "[90, 60], start = 0.2, end = 2.9",
            "C": "[400, 300], start = 0.2, end = 2.7"}  # fmt: skip
    strips = [
        f'[[strips]]\nlabel = "{label}"\nlimits = {{}}\ncurve.ellipse = {{ semi_axes = {arc} }}\n'
        for label, arc in arcs.items()
    ]
    design = tmp_path / "ribs.toml"
    design.write_text("schema = 1\nsheet = 'birch-plywood-0.8'\nmax_width = 30\n" + "".join(strips))
    refused = run("model", design, "--set", more, "-q", "-o", tmp_path / "out", code=None).stderr
    assert re.findall(r"([\d.]+) (?:x|by) 30", refused) == [*sizes]
    assert refused.count(fault) == len(sizes)
