"""Asks the rows of tables about commands: options are typed, files looked for, messages provoked."""

import json
import re
from functools import cache
from pathlib import Path

import ezdxf

from elastica_cad.cli.commands import elastica
from elastica_cad.declared import declared
from elastica_cad.design.revolution_table import RevolutionTable
from tests.manual.found_in_pages import ROOT, blocks_of, quoted
from tests.manual.proofs import ARCH, PLY, QUICK, asks, proved_by, typed

HOW_TO = "docs/how_to"
DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
 width="300mm" height="100mm" viewBox="0 0 300 100">
<g inkscape:groupmode="layer" inkscape:label="Cut"><path id="path10" d="M 0 90 C 20 0 60 0 80 90"/></g>
<g inkscape:groupmode="layer" inkscape:label="Notes">
<path id="path11" d="M 100 90 C 120 10 160 10 180 90"/>
<path id="path12" d="M 200 90 C 220 20 260 20 280 90"/></g></svg>
"""
CORNER = """<svg xmlns="http://www.w3.org/2000/svg" width="240mm" height="180mm" viewBox="0 0 240 180">
<path d="M 20 160 C 20 80 60 60 120 60 C 160 100 220 120 220 160" fill="none" stroke="black"/></svg>
"""
S = """<svg xmlns="http://www.w3.org/2000/svg" width="240mm" height="180mm" viewBox="0 0 240 180">
<path id="s" d="M 20 90 C 60 -20 100 20 120 90 C 140 160 200 200 220 60" fill="none" stroke="black"/></svg>
"""
WAVE = """<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="120mm" viewBox="0 0 200 120">
<path id="wave" d="M 10 70 C 40 -20 60 -20 80 60 C 100 140 120 140 140 60 C 150 20 170 20 185 80"/></svg>
"""
BUMPS = """<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">
<path d="M 0 100 C 20 180 40 180 60 100 C 80 20 100 80 120 140
C 140 200 160 120 180 130 C 200 140 220 40 260 120"/></svg>
"""
ARC = "\n".join(f"{x},{y}" for x, y in ((0, 0), (40, 30), (90, 45), (140, 32), (180, 0)))


def drawn(folder: Path) -> Path:
    """The manual's arch and other drawings, in the folder."""
    for name, text in (
        ("arch", ARCH),
        ("three", DRAWING),
        ("corner", CORNER),
        ("s", S),
        ("wave", WAVE),
        ("bumps", BUMPS),
    ):
        (folder / f"{name}.svg").write_text(text, encoding="utf-8")
    (folder / "points.csv").write_text(ARC, encoding="utf-8")
    return folder


def layers(path: Path) -> dict[str, list[str]]:
    """Kinds of entities by layer, in the order of the file."""
    found: dict[str, list[str]] = {}
    for entity in ezdxf.readfile(path).modelspace():
        found.setdefault(entity.dxf.layer, []).append(entity.dxftype())
    return found


def height(path: Path) -> float:
    """Of everything drawn on the outline's layer, mm."""
    from ezdxf import bbox

    space = ezdxf.readfile(path).modelspace()
    return float(bbox.extents(space.query('*[layer=="CUT_OUTER"]')).size.y)


def unknown_options(text: str) -> set[str]:
    """Options between backticks that no command of ours, or of those that pages speak of, has."""
    commands = [elastica, *(elastica.get_command(None, name) for name in elastica.commands)]
    known = {
        name
        for one in commands
        for request in one.params
        for name in (*request.opts, *request.secondary_opts)
    }
    result = " ".join(re.findall(r"`([^`]+)`", text))
    others = {"--help", "--minutes", "--styles", "--seed", "--only", "--patience", "--pictures", "--out"}
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", result)) - known - others


@asks(f"{HOW_TO}/curves.md", "you have", "do")
def _curves(row, folder):
    drawn(folder)
    if row[0] == "several curves in one file":
        made = ("strip", "three.svg", *PLY, *QUICK, "--ignore-limits", "--force", "-o", "out")
        for option, wanted in zip(quoted(row[1]), ("path12", "path12", "path10"), strict=True):
            chosen, named = (typed(folder, *made, *more) for more in (option.split(), ("--curve", wanted)))
            assert chosen.split(": ")[1].split("mm")[0] == named.split(": ")[1].split("mm")[0], option
    elif row[0].startswith("a file in cm"):
        option = quoted(row[1])[0].split()
        inch, mm = (typed(folder, "check", "points.csv", *more) for more in (option, ()))
        inch, mm = (float(re.search(r"curve of ([\d.]+) mm", result)[1]) for result in (inch, mm))
        assert abs(inch / mm - 25.4) < 0.1  # three or four digits are printed
    elif row[0] == "points you measured":
        assert "can take this curve" in typed(folder, "check", "points.csv")
    elif row[0].startswith("a curve that needs"):
        for option in quoted(row[1]):
            made = ("strip", "s.svg", "--sheet", "pom-0.5", "--max-width", "30", *QUICK)
            assert " the curve into " in typed(
                folder, *made, *option.split(), "-o", f"out{option[7:].strip()}"
            )
    elif row[0].startswith("several curves, and"):
        typed(folder, "strip", "three.svg", *PLY, "--ignore-limits", *quoted(row[1]), "-o", "out")
        assert len(list((folder / "out").glob("*.json"))) == 3
    elif row[0].startswith("a corner"):
        typed(folder, "strip", "corner.svg", *PLY, "--nearest", *quoted(row[1])[0].split(), "-o", "out")
        reports = [json.loads(path.read_text()) for path in (folder / "out").glob("*.json")]
        assert len(reports) == 2
        assert all(quoted(row[1])[1] in json.dumps(report) for report in reports)
    else:
        assert row[0] == "a drawing on standard input"
        command = quoted(row[1])[0].removeprefix("elastica ").split(" < ")
        assert "can take" in typed(folder, *command[0].split(), stdin=(folder / command[1]).read_text())


@asks(f"{HOW_TO}/models.md", "key", "effect")
def _keys_of_a_surface(row, _):
    """The keys are declared, and act."""
    keys = {name.partition(" ")[0] for name in quoted(row[0])}
    assert keys <= {field.name for field in declared(RevolutionTable)}
    tests = "tests/unit/design/test_revolution_in_design_files.py"
    proved_by(
        f"{tests}::test_a_drawn_profile_is_smoothed"
        if keys == {"smooth"}
        else f"{tests}::test_keys_of_a_strip_act_at_the_top_and_below_the_heading"
    )


@asks(f"{HOW_TO}/cutting.md", "layer", "line", "do")
def _layers(row, folder):
    drawn(folder)
    typed(folder, "strip", "arch.svg", "--sheet", "card-200gsm", "--style", "laminated", "--outer-width", "28",
          "--set", "style.backing=card-200gsm", "--label", "A", "-o", "out")  # fmt: skip
    typed(folder, "strip", "arch.svg", "--sheet", "card-200gsm", "--style", "perforated", "--outer-width", "28",
          "--label", "B", "-o", "out2")  # fmt: skip
    found = [layers(path) for path in (*folder.glob("out/*.dxf"), *folder.glob("out2/*.dxf"))]
    (name,) = quoted(row[0])
    assert any(name in one for one in found), name
    for one in found:
        order = [layer for layer in one if layer.startswith("CUT_")]
        assert order in (["CUT_INNER", "CUT_OUTER"], ["CUT_OUTER"], [])  # none on a template to clamp by


@asks(f"{HOW_TO}/cutting.md", "option", "writes")
def _cutting_options(row, folder):
    drawn(folder)
    for option in quoted(row[0]):
        out = re.sub(r"\W", "", option)
        typed(folder, "strip", "arch.svg", *PLY, *option.split(), "-o", out)
        typed(folder, "strip", "arch.svg", *PLY, "-o", out + "0")
        plain, request = folder / f"{out}0" / "arch.dxf", folder / out / "arch.dxf"
        if option == "--set cut.for=service":
            assert (folder / out / "arch-mm.dxf").is_file()
        elif option == "--set cut.marks=false":
            assert "MARK" in layers(plain)
            assert "MARK" not in layers(request)
        elif option.endswith("curves=bezier"):
            assert {"SPLINE"} <= set(layers(request)["CUT_OUTER"]) <= {"SPLINE", "LINE"}
        elif "cut.curves=" in option:
            space = ezdxf.readfile(request).modelspace()
            (line,) = space.query('*[layer=="CUT_OUTER"]')
            assert line.dxftype() == "LWPOLYLINE"
            assert line.closed
            assert line.has_arc == option.endswith("arc")
        elif option == "--set cut.version=R12":
            assert ezdxf.readfile(folder / out / quoted(row[1])[0]).dxfversion == "AC1009"
        elif option.startswith("--kerf"):
            kerf = 0.15
            assert abs(height(request) - height(plain) - kerf) < 0.02
        elif "cut.holding" in option:
            assert len(layers(request)["CUT_OUTER"]) > len(layers(plain)["CUT_OUTER"])
        elif option in ("--no-step", "--no-pictures"):
            left = {path.suffix for path in plain.parent.iterdir()} - {
                path.suffix for path in request.parent.iterdir()
            }
            assert left == {".step" if option == "--no-step" else ".png"}
        else:
            assert option == "--set files.paper=A4"
            assert (folder / out / "arch.pdf").read_bytes().startswith(b"%PDF")


@asks(f"{HOW_TO}/cutting.md", "program", "files")
def _programs(row, _):
    tests = "tests/smoke/test_files_in_other_programs.py"
    proved_by(
        {
            "Inkscape": f"{tests}::test_inkscape_draws_closed_loops_on_the_layers",
            "LibreCAD": f"{tests}::test_librecad_prints_each_layer_at_full_size_in_closed_loops",
            "OpenSCAD": f"{tests}::test_openscad_extrudes_the_dxf",
            "FreeCAD": f"{tests}::test_freecad_reads_drawings_and_solids",
            "PDF viewers": f"{tests}::test_poppler_measures_the_paper_template",
            "Chromium": "tests/smoke/test_manual_in_a_browser.py::test_the_page_of_a_kit_shows_its_files",
        }[row[0]]
    )


@asks(f"{HOW_TO}/cutting.md", "program", "choose")
def _choices(row, _):
    assert quoted(row[1])
    assert not unknown_options(row[1])


@asks(f"{HOW_TO}/batten.md", "file", "for")
def _batten(row, folder):
    out = _batten_files(folder.parent)
    result = json.loads((out / "batten.json").read_text())
    for name in quoted(row[0]):
        assert (out / name).stat().st_size > 200
    head = (out / "batten.csv").read_text().lower().split("\n")[0]
    assert all(word in head for word in ("thickness", "mm", "inch", "strain", "safety"))
    assert "end_force_N" in json.dumps(result)
    assert (out / "batten.pdf").read_bytes().startswith(b"%PDF")


@asks("docs/tutorials/bow.md", "file", "for")
def _bow(row, folder):
    (folder.parent / "kite.csv").write_bytes((ROOT / "examples" / "bow" / "kite.csv").read_bytes())
    typed(folder.parent, "bow", "kite.csv", "--rod", "4", "--sheet", "glass-rod-4", "--force", "-o", "of-bow")
    (name,) = quoted(row[0])
    assert (folder.parent / "of-bow" / name).stat().st_size > 200
    if name.endswith(".csv"):
        head = (folder.parent / "of-bow" / name).read_text().split("\n")[0]
        assert all(word in head for word in ("cord", "pull", "rise", "strain", "safety", "margin"))


@cache
def _batten_files(folder):
    typed(folder, "batten", "--sheet", "pom-1", "--length", "2400", "--camber", "10", "--at", "40",
          "--stock", "25", "8", "--least", "3", "-o", "of-batten")  # fmt: skip
    return folder / "of-batten"


@asks("docs/tutorials/clip.md", "file", "for")
def _clip(row, folder):
    out = _clip_files(folder.parent)
    for name in quoted(row[0]):
        assert (out / name).stat().st_size > 200
    if "clip.json" in row[0]:
        message = (out / "clip.json").read_text()
        assert all(word in message for word in re.findall(r"strain|margin|force|travel", row[1]))


@cache
def _clip_files(folder):
    (folder / "of-clip").mkdir()
    page = (ROOT / "docs" / "tutorials" / "clip.md").read_text(encoding="utf-8")
    drawing, command, *_ = blocks_of(page)
    (folder / "of-clip" / drawing.file).write_text(drawing.body, encoding="utf-8")
    typed(folder / "of-clip", *command.body.split()[1:])
    return folder / "of-clip" / "out"


@asks("docs/tutorials/first_strip.md", "file", "for")
def _first_strip(row, folder):
    out = _strip_files(folder.parent)
    for name in quoted(row[0]):
        assert (out / name).stat().st_size > 200
    if "arch.dxf" in row[0]:
        known = {layer.dxf.name for layer in ezdxf.readfile(out / "arch.dxf").layers}
        assert set(quoted(row[1])) <= known
    if "arch.json" in row[0]:
        assert {"units", "versions"} <= set(json.loads((out / "arch.json").read_text()))


@cache
def _strip_files(folder):
    (folder / "of-strip").mkdir()
    drawn(folder / "of-strip")
    typed(folder / "of-strip", "strip", "arch.svg", *PLY, "--set", "files.paper=A4", "-o", "out")
    return folder / "of-strip" / "out"


@cache
def kit(folder):
    """A whole kit, with all that it can hold."""
    typed(folder, "new", "arch", "-o", "of-kit")
    typed(folder / "of-kit", "model", "arch.toml", "-o", "kit")
    return folder / "of-kit" / "kit"


@asks("docs/tutorials/lamp.md", "folder", "contents")
def _lamp(row, folder):
    out = kit(folder.parent)
    (name,) = quoted(row[0])
    if name.endswith("/"):
        assert {path.suffix for path in (out / name).iterdir()} >= {".dxf", ".svg"}
    else:
        assert "birch" in (out / name.replace("lamp", "arch")).read_text()


@asks(f"{HOW_TO}/models.md", "in the folder", "contents")
def _kit(row, folder):
    out = kit(folder.parent)
    for name in quoted(row[0]):
        path = out / name.replace("NAME", "arch")
        assert path.exists(), name
        if path.is_dir():
            wanted = {"STEP": ".step", "GLB": ".glb", "DXF": ".dxf", "SVG": ".svg"}
            request = {ending for word, ending in wanted.items() if word in row[1]}
            assert {file.suffix for file in path.iterdir()} >= request


@asks(f"{HOW_TO}/models.md", "option", "does")
def _kit_options(row, folder):
    option = quoted(row[0])[0]
    if option.startswith("--no-parts"):
        typed(folder, "new", "arch")
        typed(folder, "model", "arch.toml", *option.split(), "-o", "kit")
        names = {path.name for path in (folder / "kit").rglob("*")}
        assert not {"parts", "arch.step", "arch.png"} & names
        assert json.loads((folder / "kit" / "arch.json").read_text())["held"] in (None, [], {})
    elif "cut.holding" in option:
        typed(folder, "new", "arch")
        typed(folder, "model", "arch.toml", *option.split(), *QUICK, "--no-effects", "-o", "kit")
        (sheet,) = (folder / "kit" / "sheets").glob("*.dxf")
        assert not all(
            getattr(one, "closed", True) for one in ezdxf.readfile(sheet).modelspace().query("SPLINE")
        )
    elif "language" in option:
        proved_by("tests/unit/plot/test_assembly_sheet.py::test_the_sheet_is_in_another_language")
    else:
        proved_by(
            "tests/unit/cli/test_every_command.py::test_watching_remakes_what_changes_and_survives_mistakes"
        )


@asks(f"{HOW_TO}/tabs.md", "key", "meaning")
def _tabs(row, folder):
    drawn(folder)
    tried = {
        "length": "length = 18", "width": "length = 18, width = 9",
        "corner_radius": "length = 18, corner_radius = 2", "chamfer": "length = 18, chamfer = 2",
        "taper": "length = 18, taper = 3",
        "holes": "length = 18, holes = [{at = 9, diameter = 3.2, across = 2}]",
        "t_slot": "length = 22, t_slot = {depth = 14, screw = 4, nut = [7, 3.2]}",
    }  # fmt: skip
    (plain := folder / "plain").mkdir()
    typed(folder, "strip", "arch.svg", *PLY, "--set", "ends = [{ length = 18 }, {}]", "-o", str(plain))
    for key in quoted(row[0]):
        typed(folder, "strip", "arch.svg", *PLY, "--set", f"ends = [{{ {tried[key]} }}, {{}}]", "-o", key)
        changed = (folder / key / "arch.svg").read_text() != (plain / "arch.svg").read_text()
        assert changed == (key != "length")


@asks(f"{HOW_TO}/too_much.md", "option", "limit")
def _limits(row, folder):
    drawn(folder)
    (option,) = quoted(row[0])
    typed(folder, "strip", "s.svg", *PLY, *option.split(), "-o", "out")
    answer = json.loads((folder / "out" / "s.json").read_text())
    if option.startswith("--ratio"):
        assert answer["ratio"] <= 6.0 + 1e-6
    elif option == "--stable":
        assert answer["stability"]["margin"] >= 5.0 - 1e-6
    else:
        assert answer["strain"]["largest"] <= answer["strain"]["limit"] * (1 + 1e-6)


MAKE = ("strip", "arch.svg", *PLY, "-o", "o")
NEAR = ("strip", "s.svg", *PLY, "--nearest", "-o", "o")
PROVOKED = {
    "can take this curve": (r"can take this curve", "check", "arch.svg"),
    "the inflections are not on one line": (
        r"The inflections are not on one line",
        "check",
        "bumps.svg",
    ),
    "the line ... crosses the curve at ... mm": (
        r"The line .* crosses the curve at .* mm",
        "check",
        "wave.svg",
    ),
    "a corner ... mm from its start": (r"a corner [\d.]+ mm from its start", "check", "corner.svg"),
    "The strain is ... %; ... allows ... %": (
        r"The strain is .*; .* allows .* %",
        "strip",
        "three.svg",
        *PLY,
        "--curve",
        "1",
        "-o",
        "o",
    ),
    "No strip between ... and ... carries this load": (
        r"No strip between .* and .* carries this load",
        *MAKE,
        "--gravity",
        "--set",
        "loads = [{ at = 150, mass = 4000 }]",
    ),
    "only ... mm wide ..., but ... needs at least ... mm": (
        r"only [\d.]+ mm wide .* but .* needs at least [\d.]+ mm",
        *MAKE,
        "--max-width",
        "2",
    ),
    "larger than the stock": (r"larger than the stock", *MAKE, "--set", "shop.stock=[100,80]"),
}
"""The words of each message, and what makes a command say them."""

ROWS_OF = {
    ("check", "arch.svg"): ("Read", "Verdict", "Widths", "Sheets"),
    MAKE: ("Size", "Strain", "Stability", "Hold", "Accuracy", "Files"),
    NEAR: ("Curve", "Change"),
    (*MAKE, "--max-width", "2", "--ignore-limits"): ("Warning",),
    ("strip", "arch.svg", *PLY, "--tie", "60", "240", "-o", "o"): ("Between",),
    ("sections", "bowl.obj", "--unit", "mm", "--radial", "2", "-o", "o"): ("Section",),
    ("bend", "--straight", "120", *PLY, "--to", "97", "0", "--steps", "4", "-o", "o"): ("Shape", "Force"),
    (
        "batten",
        "--sheet",
        "pom-1",
        "--length",
        "900",
        "--camber",
        "9",
        "--at",
        "45",
        "--rod",
        "8",
        "-o",
        "o",
    ): ("Camber",),
    ("bow", "arch.svg", "--rod", "8", "-o", "o"): ("Cord",),
    ("model", "pavilion.toml", *QUICK, "--no-effects", "-o", "o"): ("Model", "Note"),
}
"""Commands, and the labels of rows that they print."""


@asks(f"{HOW_TO}/messages.md", "row", "it means", "do")
def _labels(row, folder):
    label = row[0].strip("*")
    (command,) = (words for words, labels in ROWS_OF.items() if label in labels)
    assert not unknown_options(row[-1])
    drawn(folder)
    for example in ("pavilion", "sections"):
        typed(folder, "new", example)
    assert re.search(rf"^(! )?{label} ", typed(folder, *command, code=None), re.MULTILINE)


ELSEWHERE = {
    "The points are too few or too inexact ...": "tests/unit/mechanics/test_points_of_curves.py::"
    "test_a_rod_of_undecided_points_is_warned_of",
    "... because of a corner or a rounding error": "tests/validation/test_every_number_of_decimals.py::"
    "test_a_handle_that_is_lost_by_rounding_is_undecided_at_the_door",
    "too slender to handle": "tests/unit/strip/test_makeability.py::"
    "test_longer_than_the_stock_and_too_slender",
    "the tab at the start of the strip can tip ...": "tests/unit/model/test_holding.py::"
    "test_an_inclined_tab_rocks_in_one_plate_and_not_in_two",
}


@asks(f"{HOW_TO}/messages.md", "it says", "it means", "do")
@asks(f"{HOW_TO}/messages.md", "it says", "do")
def _messages(row, folder):
    message = row[0].split("*")[1]
    assert not unknown_options(row[-1])
    if message in ELSEWHERE:
        proved_by(ELSEWHERE[message])
        return
    drawn(folder)
    words, *command = PROVOKED[message]
    text = typed(folder, *command, code=None)
    assert re.search(words, text), text
