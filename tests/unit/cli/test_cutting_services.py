"""Files for cutting services, which cut every line: from the commands and Python, read again with ezdxf."""

import json
import zipfile

import ezdxf
import pytest

from elastica_cad import InputError, read_curves, save_model
from elastica_cad.design import Cutting, read_design
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit
from elastica_cad.model.assembly import engraved_marks
from elastica_cad.strip.holding_template import holding_template
from tests.command_line import run

KIT = """schema = 1
name = "kit"
sheet = "birch-plywood-0.8"
max_width = 20
[[strips]]
label = "K"
curve.ellipse = { semi_axes = [150, 100], start = "0.1", end = "pi - 0.1" }
[base]
sheet = "mdf-3"
height = 10
[extras]
reference_bar = 100
[cut]
for = "service"
"""


def entities(path):
    return list(ezdxf.readfile(path).modelspace())


@pytest.fixture
def arch(tmp_path):
    path = tmp_path / "arch.txt"
    path.write_text("2 4\n0 0\n40 60\n90 60\n130 0\n")
    return path


def test_a_strip_for_a_service_is_one_closed_polyline_of_lines_and_arcs(arch, tmp_path):
    words = ("strip", arch, "--sheet", "birch-plywood-0.8", "--max-width", 20, "--no-step", "--no-pictures")
    run(*words, "--set", "cut.for=service", "-o", tmp_path / "out")
    drawn = {path.name for path in (tmp_path / "out").iterdir() if path.suffix in (".dxf", ".svg")}
    assert drawn == {"arch-mm.dxf", "arch-mm.svg"}
    (outline,) = entities(tmp_path / "out/arch-mm.dxf")
    assert (outline.dxftype(), outline.dxf.layer, outline.closed) == ("LWPOLYLINE", "CUT_OUTER", True)
    assert any(bulge for *_, bulge in outline.get_points("xyb"))


def test_a_service_needs_closed_outlines(arch, tmp_path):
    bridges = ("--set", "cut.for=service", "--set", "cut.holding.width=0.4")
    result = run("strip", arch, "--sheet", "card-200gsm", *bridges, "-o", tmp_path / "out", code=2)
    assert "cut.holding interrupts the outlines" in result.output


def test_a_kit_for_a_service_holds_parts_alone_and_packs_what_is_cut(tmp_path):
    (tmp_path / "kit.toml").write_text(KIT)
    out = tmp_path / "out"
    words = ("model", tmp_path / "kit.toml", "--no-step", "--no-pictures", "--no-effects", "--zip")
    result = run(*words, "-o", out)
    assert "have no bar of known length" in result.output
    parts = ["parts/K_birch-plywood-0.8_0.8mm_x1-mm.dxf", "parts/kit-base_mdf-3_3mm_x1-mm.dxf"]
    assert sorted(path.relative_to(out).as_posix() for path in out.rglob("*.dxf")) == parts
    for part in parts:
        kinds = {(one.dxftype(), one.dxf.layer[:4]) for one in entities(out / part)}
        assert kinds <= {("LWPOLYLINE", "CUT_"), ("CIRCLE", "CUT_")}
        assert parts[0] in (out / "kit-cut-list.txt").read_text()
    with zipfile.ZipFile(out / "kit-cut.zip") as cut, zipfile.ZipFile(out / "kit-look.zip") as seen:
        assert sorted(cut.namelist()) == ["kit-cut-list.csv", "kit-cut-list.txt", *parts]
        assert cut.read(parts[0]) == (out / parts[0]).read_bytes()
        assert {"index.html", "kit-cut-list.txt"} <= set(seen.namelist())
        assert not {*seen.namelist()} & {*parts}
    first = (out / "kit-cut.zip").read_bytes()
    run(*words, "-o", out, "--force")
    assert (out / "kit-cut.zip").read_bytes() == first
    assert "--no-parts leaves them out" in run(*words, "--no-parts", "-o", out, "--force", code=2).output


def test_save_model_writes_cutting_files_as_the_record_says(tmp_path):
    (tmp_path / "kit.toml").write_text(KIT.partition("[base]")[0])
    model = read_design(tmp_path / "kit.toml", read_curves).model()

    def layers(cutting, folder, suffix=""):
        save_model(model, tmp_path / folder, cutting=cutting, step=False, pictures=False)
        (part,) = (tmp_path / folder / "parts").glob(f"K_*_x1{suffix}.dxf")
        return {one.dxf.layer for one in entities(part)}

    assert "MARK" in layers(Cutting(), "marked")
    assert layers(Cutting(marks=False, version="R12"), "bare", "-mm") == {"CUT_OUTER", "ENGRAVE"}
    assert layers(Cutting("service"), "ordered", "-mm") == {"CUT_OUTER"}


@pytest.mark.parametrize("values", [{"recipient": "shop"}, {"marks": 1}, {"tolerance": 0}])
def test_a_record_of_wrong_values_is_refused(values):
    with pytest.raises(InputError, match=f"cutting {next(iter(values))} is"):
        Cutting(**values)


def test_papers_of_a_service_state_what_is_in_its_files(tmp_path):
    """A kit for one's own machine has engravings, and a service only cuts."""
    design = tmp_path / "kit.toml"
    for recipient, engraved in (("service", False), ("workshop", True)):
        design.write_text(KIT.replace('for = "service"', f'for = "{recipient}"').replace('"K"', '"左"'))
        read = read_design(design, read_curves)
        model = read.model()
        contents = kit_contents(model, read.kit, entries=read.entries)
        kit = model_kit(contents, step=False, pictures=False)
        marks = [*engraved_marks(contents.model, contents.holders)]
        assert bool(marks) == engraved
        assert any("1 = 左" in text for text in contents.notes) == engraved
        kit.write(tmp_path / recipient)
        page = (tmp_path / recipient / "index.html").read_text(encoding="utf-8")
        assert ("Nothing is written on the parts" in page) != engraved
        assert ("where its label starts" in page) == engraved
        assert (
            "1 = 左" in (tmp_path / recipient / "kit-cut-list.txt").read_text(encoding="utf-8")
        ) == engraved
        (strip,) = contents.model.strips
        lines = [text.text for text in holding_template(strip).texts]
        assert any("its first letter" in line for line in lines) == engraved


@pytest.mark.parametrize("service", [False, True])
def test_a_laminate_for_a_service_has_no_word_on_it(arch, tmp_path, service):
    style = 'style={kind="laminated", width=30, backing="card-200gsm"}'
    options = ("--set", "cut.for=service") if service else ()
    words = ("strip", arch, "--sheet", "card-200gsm", "--set", style, *options, "--no-step", "--no-pictures")
    run(*words, "-o", tmp_path / "out")
    side = json.loads((tmp_path / "out/arch.json").read_text())["backing_side"]
    assert "side" in side
    assert ("engraving" in side) != service


def test_a_kit_for_a_service_has_plan_pages(tmp_path):
    """On them are the texts that the files for the service do not have."""
    design = tmp_path / "kit.toml"
    for recipient in ("service", "workshop"):
        design.write_text(KIT.replace('for = "service"', f'for = "{recipient}"'))
        read = read_design(design, read_curves)
        kit = model_kit(kit_contents(read.model(), read.kit, entries=read.entries), step=False)
        plans = [file for file in kit.files if "-plan-" in file.name]
        assert bool(plans) == (recipient == "service")
        for plan in plans:
            plan.write(tmp_path / plan.name)
            assert (tmp_path / plan.name).read_bytes().startswith(b"%PDF")


def test_a_kit_of_rods_has_no_plan_page(tmp_path):
    design = tmp_path / "rods.toml"
    design.write_text(
        'schema = 1\nsheet = "glass-rod-8"\nsection = { kind = "rod", limits = [8, 8] }\nlimits = { ratio = 1 }\n'
        'cut = { for = "service" }\n[[strips]]\nlabel = "hoop"\n'
        "curve = { ellipse = { semi_axes = [800, 800], start = 0, end = 3.14159265358979 } }\n"
    )
    read = read_design(design, read_curves)
    kit = model_kit(kit_contents(read.model(), read.kit, entries=read.entries), step=False)
    assert [file.name for file in kit.files if file.name.endswith(".pdf")] == ["rods-assembly.pdf"]
