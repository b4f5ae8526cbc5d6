"""Drawings at the command line: which curve, through a pipe, made fair, and refused with the place as drawn."""

import json
import re
import tomllib
from pathlib import Path

import ezdxf
import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import write_curves
from tests.command_line import run

pytest.importorskip("cssselect2")

BODY = """
<g inkscape:groupmode="layer" inkscape:label="Cut">
<path id="arch" d="M 20.00,150.00 C 20.00,100.00 60.32,50.11 120.00,50.00
 C 170.00,49.93 220.00,80.00 220.00,150.00"/>
<path id="corner" d="M 0,0 C 10,10 20,20 30,20 C 30,30 40,40 50,40"/></g>
<g inkscape:groupmode="layer" inkscape:label="Notes"><path id="bow" d="M 0,250 C 20,290 80,290 100,250"/>
<text>hello</text></g>"""


@pytest.fixture
def drawing(tmp_path):
    names = 'xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    path = tmp_path / "drawn.svg"
    path.write_text(f'<svg {names} width="300mm" height="300mm" viewBox="0 0 300 300">{BODY}</svg>')
    return path


@pytest.mark.campaign
def test_every_curve_is_judged_for_itself(drawing):
    done = run("check", drawing, code=2)
    text, message = done.stdout, done.stderr
    assert done.exit_code == 2
    assert "curve 1 (arch, layer Cut) of 3:\nVerdict     A flat strip can take this curve" in text
    assert "curve 3 (bow, layer Notes) of 3:\nVerdict     A flat strip can take this curve" in text
    assert "curve 2 (corner, layer Cut) of 3: the curve has a corner" in message
    assert "(30, 20) mm" in message  # y down, as in the drawing
    assert "left out because they are not curves: 1 text" in message


def test_a_verdict_that_many_curves_have_is_said_once(tmp_path):
    path = '<path id="a{0}" d="M 0,{0} C 20,{1} 80,{1} 100,{0}"/>'
    paths = "".join(path.format(60 * i, 60 * i + 40) for i in range(5))
    (tmp_path / "five.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="300mm" viewBox="0 0 300 300">{paths}</svg>'
    )
    text = run("check", tmp_path / "five.svg").stdout
    assert "curve 1 (a0) to curve 5 (a240) of 5:" in text
    assert text.count("A flat strip can take this curve") == 1


@pytest.mark.parametrize("choice", [("--curve", "bow"), ("--curve", "3"), ("--layer", "Notes")])
def test_a_curve_is_chosen_by_number_id_or_layer(drawing, choice):
    answers = json.loads(run("check", drawing, *choice, "--json").stdout)
    assert [one["realizable"] for one in answers] == [True]


@pytest.mark.parametrize("choice", [("--curve", "bow"), ("--layer", "Notes")])
def test_one_curve_of_several_gets_the_whole_verdict(drawing, tmp_path, choice):
    alone = tmp_path / "alone.svg"
    alone.write_text(
        drawing.read_text().replace("<path", "<desc").replace('<desc id="bow"', '<path id="bow"')
    )
    text, expected = (run("check", *words).stdout for words in ((drawing, *choice), (alone,)))
    assert "Widths      the strip varies in width" in expected
    read, verdict = expected.split("\n", maxsplit=1)
    assert read == "Read        100.0 x 30.0 mm (unit from the file), 1 spline, read without approximation"
    assert text == f"{read}\ndrawn.svg, curve 3 (bow, layer Notes) of 3:\n{verdict}"
    result = run("check", drawing, "--curve", "corner", code=2)
    assert "curve 2 (corner, layer Cut) of 3: the curve has a corner" in result.stderr


def test_a_choice_that_is_not_there_is_listed_with_those_that_are(drawing):
    done = run("check", drawing, "--curve", "nix", code=2)
    assert "but not nix" in done.stderr
    assert "1 (arch, layer Cut), 2 (corner, layer Cut), 3 (bow, layer Notes)" in done.stderr


def test_a_drawing_comes_through_a_pipe(drawing):
    done = run("check", "-", "--curve", "bow", input=drawing.read_text())
    assert "can take this curve" in done.stdout
    assert "Standard input is empty" in run("check", "-", input="", code=2).stderr
    points = "0, 0\n10, 8\n20, 12\n30, 13\n40, 12\n50, 8\n60, 0\n"
    run("check", "-", input=points)


@pytest.mark.campaign
def test_a_strip_for_every_curve_and_none_spoils_the_others(drawing, tmp_path):
    out = tmp_path / "out"
    options = ("--sheet", "birch-plywood-0.8", "--max-width", 30, "-o", out)
    done = run("strip", drawing, "--all", *options, code=2)
    assert {"drawn-arch.dxf", "drawn-bow.dxf"} <= {path.name for path in out.iterdir()}
    assert not (out / "drawn-corner.dxf").exists()
    assert "curve 2 (corner, layer Cut) of 3: the curve has a corner" in done.stderr
    assert "1 of 3 curves" in done.stderr
    assert f"in {out} (cut: drawn-arch.dxf and drawn-bow.dxf)" in done.stdout


def test_no_file_of_one_curve_replaces_a_file_of_another(drawing, tmp_path):
    drawing.write_text(drawing.read_text().replace('id="bow"', 'id="arch-holding"'))
    options = ("--sheet", "birch-plywood-0.8", "--max-width", 30, "--no-pictures", "--no-step", "--force")
    done = run("strip", drawing, "--all", *options, "-o", tmp_path, code=2)
    template = tmp_path / "drawn-arch-holding.dxf"
    assert f"{template} is already a file of another curve" in done.stderr
    alone = tmp_path / "alone"
    run("strip", drawing, "--curve", "arch", *options, "-o", alone)
    drawn = [path.read_text().splitlines()[2:] for path in (template, alone / template.name)]
    assert drawn[0] == drawn[1], "apart from the comment with the command"


def test_a_saved_design_knows_curves_by_name_and_leaves_out_what_was_refused(drawing, tmp_path):
    """When a pupil draws her curve anew it is the last of the file; the numbers of all others change."""
    drawing.write_text(drawing.read_text().replace('id="bow"', 'id="path9" inkscape:label="Böw"'))
    design = tmp_path / "class.toml"
    options = ("--sheet", "birch-plywood-0.8", "--max-width", 30, "--no-pictures", "--no-step")
    done = run("strip", drawing, "--all", *options, "--save-design", design, "-o", tmp_path / "out", code=2)
    assert f"1 of 3 curves cannot be made with these options; {design} leaves them out" in done.stderr
    assert "has all strips in one plane, as drawn. Set `origin`" in done.stdout
    saved = tomllib.loads(design.read_text())["strips"]
    assert [(one["label"], one["curve"]["id"]) for one in saved] == [("arch", "arch"), ("Böw", "Böw")]
    before = lengths_of(design, tmp_path / "before")
    _, moved, *_ = drawing.read_text().split("<path")
    moved = f"<path{moved}"
    drawing.write_text(drawing.read_text().replace(moved, "").replace("</svg>", f"{moved}</svg>"))
    assert lengths_of(design, tmp_path / "after") == before
    run("strip", drawing, "--all", *options, "--save-design", design, "-o", tmp_path / "again", code=2)
    assert not (tmp_path / "again").exists(), "refused before anything is made"


@pytest.mark.parametrize("curve", ["wave.dxf", "two.json"])
def test_a_curve_is_split_into_strips_that_say_where_they_meet(curve, tmp_path):
    """The cut pattern and the template have the names of the joints, and the saved design gives the same strips."""
    # the first three points are on a line, so the curvature is 0 at the start
    wave = [(0, 0), (10, 30), (20, 60), (50, -60), (80, 60), (100, 80), (160, -90), (190, 20)]
    path = tmp_path / curve
    write_curves([ec.PlaneCurve.spline(3 * np.array(wave), degree=4)], path)
    stem = path.stem
    options = ("--sheet", "pom-0.5", "--max-width", 40, "--start", "pinned", "--no-pictures", "--no-step")
    design = tmp_path / "split.toml"
    done = run("strip", path, "--split", 4, *options, "--json", "-o", tmp_path, "--save-design", design)
    record = json.loads(done.stdout)
    assert [one["name"] for one in record["strips"]] == [f"{stem}-{k}" for k in (1, 2, 3, 4)]
    assert [one.get("joints") for one in record["strips"]] == [
        ["", "J1"], ["J1", "J2"], ["J2", "J3"], ["J3", ""]
    ]  # fmt: skip
    lengths = [one["length"] for one in record["strips"]]
    assert np.cumsum(lengths)[:-1] == pytest.approx(record["splits"][0]["supports"], abs=0.2)
    supports = [one["request"]["supports"] for one in record["strips"]]
    assert [[end["angle"] for end in (pair["start"], pair["end"])] for pair in supports] == [
        [False, True], [True, True], [True, True], [True, True]
    ]  # fmt: skip
    assert engraved(tmp_path / f"{stem}-2.dxf") > engraved(tmp_path / f"{stem}-1.dxf")
    assert lengths_of(design, tmp_path / "model") == {
        f"{stem}-{k}": pytest.approx(length) for k, length in enumerate(lengths, start=1)
    }
    text = run("strip", path, "--split", *options, "--label", "Rib", "-o", tmp_path / "fewest").stdout
    fewest = int(re.search(r"split the curve into (\d) strips", text)[1])
    rows = re.findall(r"^(Rib-\d) .*; joined at (J1|J\d and J\d|J\d)$", text, re.M)
    assert [name for name, _ in rows] == [f"Rib-{k}" for k in range(1, fewest + 1)]
    assert (
        "--rail has no effect beside split"
        in run("strip", path, "--split", *options, "--pin", 40, code=2).stderr
    )
    assert f"{fewest} to 1000" in run("strip", path, "--split", 1, *options, code=2).stderr


def engraved(path):
    """Number of strokes that are engraved in a drawing."""
    return sum(one.dxf.layer == "ENGRAVE" for one in ezdxf.readfile(path).modelspace())


def test_a_curve_without_a_name_has_that_of_its_layer(tmp_path):
    """Inkscape names a drawn path path900; its layer, which a person named, is where it is looked for."""
    names = 'xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    layer = '<g inkscape:groupmode="layer" inkscape:label="{}">{}</g>'
    arc = '<path id="{}" transform="translate(0,{})" d="M 0,40 C 20,0 80,0 100,40"/>'
    body = layer.format("Rib A", arc.format("path900", 0)) + layer.format(
        "Keel", arc.format("path7", 60) + arc.format("path8", 120)
    ) + layer.format("Deck", arc.format("stern", 180))  # fmt: skip
    path = tmp_path / "boat.svg"
    path.write_text(f'<svg {names} width="300mm" height="300mm" viewBox="0 0 300 300">{body}</svg>')
    options = ("--sheet", "card-200gsm", "--max-width", 12, "--no-pictures", "--no-step", "-o", tmp_path)
    design = tmp_path / "boat.toml"
    done = run("strip", path, "--all", *options, "--json", "--save-design", design)
    labels = [one["request"]["label"] for one in json.loads(done.stdout)["strips"]]
    assert labels == ["Rib A", "path7", "path8", "stern"]
    assert [strip["curve"].get("id") for strip in tomllib.loads(design.read_text())["strips"]] == labels
    assert set(lengths_of(design, tmp_path / "model")) == set(labels)
    for which in ("Rib A", "path900"):
        chosen = json.loads(run("strip", path, "--curve", which, *options, "--force", "--json").stdout)
        assert chosen["strips"][0]["request"]["label"] == "Rib A"


def lengths_of(design, folder):
    """How long the parts of a design are cut, by their names."""
    quick = ("--no-effects", "--no-pictures", "--no-step", "--no-parts")
    done = run("model", design, *quick, "--json", "-o", folder)
    return {one["name"]: one["length"] for one in json.loads(done.stdout)["parts"]}


def test_a_column_that_makes_no_curve_spoils_no_other(tmp_path):
    """Nor is a straight one said to change with noise by nan %."""
    rows = "\n".join(f"0,1,{5 + k}" for k in range(5))
    (tmp_path / "lines.csv").write_text(f"Station,A,B\n{rows}\n")
    options = ("--sheet", "card-200gsm", "--max-width", 2, "--no-pictures", "--no-step")
    done = run("strip", tmp_path / "lines.csv", "--all", *options, "-o", tmp_path / "out", code=2)
    assert "curve 1 (A) of 2: a curve has fewer than two different points" in done.stderr
    assert "1 of 2 curves cannot be made with these options" in done.stderr
    assert "nan" not in done.stderr
    assert (tmp_path / "out" / "lines-B.dxf").exists()


def test_a_model_warns_of_a_strip_that_will_not_stay(tmp_path):
    x = np.linspace(0, 2 * np.pi, 60)
    np.savetxt(tmp_path / "wave.csv", np.column_stack([40 * x, 10 * np.sin(x)]), delimiter=",")
    design = tmp_path / "wave.toml"
    design.write_text(
        'schema = 1\nsheet = "card-200gsm"\nmax_width = 10\n[[strips]]\nlabel = "W"\ncurve = "wave.csv"\n'
    )
    quick = ("--no-effects", "--no-pictures", "--no-step", "--no-parts")
    done = run("model", design, *quick, "-o", tmp_path / "kit")
    assert "! Note      W: unstable: the strip snaps into another shape" in done.stderr
    assert "snaps into another shape" in (tmp_path / "kit" / "index.html").read_text()
    assert "Change      set limits.margin = 5 in the table of W for the nearest stable curve" in done.stdout
    design.write_text(design.read_text() + "limits.margin = 5\n")
    again = run("model", design, *quick, "-o", tmp_path / "again")
    assert "unstable" not in again.output
    assert "limits.margin" not in again.output


def test_one_of_several_curves_is_made_stable(tmp_path):
    x = np.linspace(0, 2 * np.pi, 60)
    wave, arch = np.column_stack([45 * x, 11 * np.sin(x)]), np.column_stack([45 * x, 60 * np.sin(x / 2)])
    rows = [f"{u:.3f},{v:.3f}" for u, v in wave], [f"{u:.3f},{v:.3f}" for u, v in arch]
    (tmp_path / "two.csv").write_text("\n\n".join("\n".join(lines) for lines in rows) + "\n")
    options = ("--sheet", "card-200gsm", "--max-width", 11, "--no-pictures", "--no-step")
    done = run("strip", tmp_path / "two.csv", "--all", *options, "-o", tmp_path / "out")
    (change,) = re.findall(r"^Change +use (.*) for the nearest stable curve$", done.stdout, re.M)
    again = run("strip", tmp_path / "two.csv", *change.split(), *options, "-o", tmp_path / "again")
    assert "unstable" not in again.output


def test_the_nearest_curve_is_supported_in_two_steps(tmp_path, monkeypatch):
    """Both printed commands make the strip, and so does a design with the written curve."""
    monkeypatch.chdir(tmp_path)
    x = np.linspace(0, 2 * np.pi, 60)
    np.savetxt("wave.csv", np.column_stack([40 * x, 10 * np.sin(x)]), delimiter=",")
    options = ("--sheet", "card-200gsm", "--max-width", 10, "--no-pictures", "--no-step", "-o", "out")
    refused = run("strip", "wave.csv", *options, "--stable", "--rail", 120, code=2).output
    assert "cannot be combined with a nearest curve" in refused
    first, second = (words.partition(" strip ")[2] for words in re.findall("`(.*? strip .*?)`", refused)[-2:])
    assert "stable: " in run("strip", *first.split()).stdout
    assert "the rail 120 mm from the start" in run("strip", *second.split()).stdout
    design, limits = Path("wave.toml"), "limits.margin = 5\n"
    text = f'schema = 1\nsheet = "card-200gsm"\nmax_width = 10\n{limits}[[strips]]\ncurve = "wave.csv"\n'
    design.write_text(f'{text}between = [{{ kind = "rail", at = 120 }}]\n')
    quick = ("--no-effects", "--no-pictures", "--no-step", "--no-parts")
    assert "its curve (the file NAME.json of `elastica strip`)" in run("model", design, code=2).output
    design.write_text(design.read_text().replace("wave.csv", "out/wave.json").replace(limits, ""))
    assert "1 strip" in run("model", design, *quick, "-o", "kit").stdout


@pytest.mark.campaign
def test_the_row_on_support_of_a_nearest_curve_is_a_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    heights = [11, -29, 41, 1, 1, 30, -42]
    curve = ec.PlaneCurve.spline(np.column_stack([np.linspace(0, 300, 7), heights]), degree=5)
    write_curves([curve], Path("wave.json"))
    options = ("--sheet", "card-200gsm", "--max-width", 30, "--no-pictures", "--no-step", "-o", "out")
    made = run("strip", "wave.json", *options, "--stable").output
    assert "Support the strip between its ends" in made
    (command,) = re.findall("to support this strip between its ends .*`.*? strip (.*?)`", made)
    assert "Between     pin" in run("strip", *command.split()).stdout


@pytest.mark.campaign
def test_pen_curves_are_faired_reported_and_left_alone_when_requested(drawing, tmp_path):
    ratios = {}
    for smooth in (None, 0, 1.5):
        out = tmp_path / f"out{smooth}"
        words = (
            "strip",
            drawing,
            "--curve",
            "arch",
            "--sheet",
            "birch-plywood-0.8",
            "--max-width",
            30,
            "-o",
            out,
        )
        done = run(*words, *(() if smooth is None else ("--set", f"smooth={smooth}")))
        report = json.loads((out / "drawn-arch.json").read_text())
        ratios[smooth] = report["ratio"]
        moved = report["smoothing"]["moved"]
        if smooth == 0:
            assert moved == 0
            assert "The width of the strip jumps" in done.stderr
            assert "Set --smooth to about 0.1 mm" in done.stderr
        else:
            assert 0 < moved <= (smooth or 0.1)
            assert report["smoothing"]["ratio_as_drawn"] == pytest.approx(ratios.get(0, 1.557), rel=1e-3)
            # a movement of at most 0.1 mm is a note in the report
            noted = done.stderr if smooth else done.stdout
            assert f"moved the curve by at most {moved:.2g} mm" in noted
            assert "The width of the strip jumps" not in done.stderr
    assert ratios[1.5] < ratios[None] < ratios[0]


@pytest.mark.parametrize(("words", "sentence"), [
    (("--max-width", "1e200"), "--max-width is 1e+200"),
    (("--max-width", "30", "--set", "smooth=-1"), "smooth is -1"),
    (("--max-width", "30", "--set", "smooth=nan"), "smooth is nan. Use a finite number"),
    (("--max-width", "inf"), "not finite"),
    (("--max-width", "30", "--set", "samples=" + "9" * 20), "at most 1e+09"),
])  # fmt: skip
def test_numbers_at_the_edge_are_refused_in_a_sentence(drawing, words, sentence):
    done = run("strip", drawing, "--curve", "arch", "--sheet", "birch-plywood-0.8", *words, code=2)
    assert sentence in done.stderr
    assert done.stderr.strip().count("\n") <= 1


def test_a_design_file_chooses_by_id_and_layer_and_smooths(drawing, tmp_path):
    design = tmp_path / "design.toml"
    design.write_text(
        'schema = 1\nsheet = "birch-plywood-0.8"\nmax_width = 30\nsmooth = 0.3\n'
        '[[strips]]\nlabel = "A"\ncurve = { file = "drawn.svg", id = "arch" }\n'
        '[[strips]]\nlabel = "B"\ncurve = { file = "drawn.svg", layer = "Notes" }\nsmooth = 0\n'
        "origin = [0, 90, 0]\n"
    )
    run("model", design, "-o", tmp_path / "out", "--no-step", "--no-pictures")


ARCH = [(0, 0), (60, 150), (150, 190), (240, 150), (300, 0)]


def test_a_gap_between_two_curves_is_reported(tmp_path):
    drawing = tmp_path / "gap.svg"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="100mm" viewBox="0 0 300 100">'
        '<path d="M10 80 C 40 20 60 20 100 40"/><path d="M100.2 40 C 140 60 160 60 200 20"/></svg>'
    )
    message = run("check", drawing).stderr
    assert "curve 1 and curve 2 end 0.2 mm apart near (100, -40) mm, so they become two strips" in message


def test_all_refused_curves_are_reported(tmp_path):
    corners = "".join(f'<path d="M0 {9 * k}h10v10"/>' for k in range(30))
    path = tmp_path / "a.svg"
    path.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="300mm" viewBox="0 0 300 300">{corners}</svg>'
    )
    result = run("check", path, code=2).stderr.splitlines()
    assert sum("a corner" in line for line in result) == 30


def test_strips_of_a_dxf_are_named_by_its_order_and_say_their_distances(tmp_path):
    """CAD programs name shapes by their handles. A warning that holds for all strips is printed once."""
    document = ezdxf.new(units=4)
    for k in range(3):
        fillet = [(0, 300 * k, 0), (150, 300 * k, np.tan((0.8 + 0.1 * k) / 4)), (260, 300 * k + 60, 0)]
        document.modelspace().add_lwpolyline(fillet[1:], format="xyb")
        document.modelspace().add_line(fillet[0][:2], fillet[1][:2])
    points = [(0, 1000), (70, 1090), (150, 1100), (230, 1010), (320, 1000)]
    for k in range(3):
        document.modelspace().add_spline([(x, y + 300 * k, 0) for x, y in points])
    document.saveas(tmp_path / "wall.dxf")
    options = (
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        30,
        "--nearest",
        "--ratio",
        2,
        "--no-pictures",
        "--no-step",
    )
    design = tmp_path / "wall.toml"
    done = run(
        "strip", tmp_path / "wall.dxf", "--all", *options, "--save-design", design, "-o", tmp_path / "out"
    )
    saved = tomllib.loads(design.read_text())["strips"]
    print(done.stdout, done.stderr)
    assert [(one["label"], one["curve"]["number"]) for one in saved] == [
        (f"wall-{k}", k) for k in range(1, 7)
    ]
    sizes = [line for line in done.stdout.splitlines() if line.startswith("wall-")]
    assert len(sizes) == 6
    assert all(re.search(r"; at most [\d.]+ mm from the drawn curve$", line) for line in sizes)
    assert done.stderr.count("The curvature jumped") <= 1
    lengths_of(design, tmp_path / "made")


def test_rounded_corners_are_named_by_their_angle_and_moved_as_far_as_the_file_was_read(tmp_path):
    """A corner of 19 degrees stays, and a corner of 0.8 degrees, at (200, 160), is rounded."""
    path = '<path d="M 20 150 C 40 60, 120 20, 150 100 L 200 160 C 230 195, 270 160, 280 60"/>'
    size = 'width="300mm" height="200mm" viewBox="0 0 300 200"'
    (tmp_path / "drawn.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{path}</svg>')
    options = "--sheet pom-0.5 --max-width 37 --no-step --no-pictures --set curve.split_corners=true"
    text = " ".join(run(f"strip drawn.svg {options} -v -o out", cwd=tmp_path).stdout.split())
    read = re.search(r"small corners at joints rounded, within (\S+) mm of the drawing", text)[1]
    result = r"Corners of at most (\d+) degrees, at which .* moved the curve by at most (\S+) mm\. Ends"
    assert re.search(result, text).groups() == ("5", read)
