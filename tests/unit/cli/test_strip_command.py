"""The command line as a user meets it: files, messages, exit codes."""

import json
import re

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.formats import curves_json
from elastica_cad.mechanics import trials
from tests.command_line import run


@pytest.fixture
def drawn(tmp_path):
    path = tmp_path / "bow.json"
    path.write_text(curves_json([ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.2, 2.9)]))
    return path


@pytest.fixture
def impossible(tmp_path):
    """A wave whose outer inflections leave the line of the inner one."""
    x = np.linspace(0, 2.5 * np.pi, 200)
    path = tmp_path / "wave.csv"
    np.savetxt(path, np.column_stack([50 * x, 40 * np.sin(x) + 6 * x**1.6]), delimiter=",")
    return path


def test_strip_writes_every_file_and_a_report(drawn, tmp_path):
    out = tmp_path / "out"
    result = run("strip", drawn, "--sheet", "birch-plywood-0.8", "--max-width", 40, "-o", out)
    report = json.loads((out / "bow.json").read_text())
    assert report["schema"] == "elastica-report/1"
    assert report["width"]["largest"] == pytest.approx(40.0)
    assert report["ratio"] == pytest.approx(report["width"]["largest"] / report["width"]["least"])
    for suffix in ("dxf", "svg", "json", "png", "step"):
        assert (out / f"bow.{suffix}").stat().st_size > 1000
        assert f"bow.{suffix}" in result.stdout


def test_no_strip_is_cut_from_a_rod(drawn, tmp_path):
    done = run("strip", drawn, "--sheet", "glass-rod-3", "--max-width", 20, "-o", tmp_path / "out", code=2)
    assert (
        "glass-rod-3 is a rod, so no strip can be cut from it. Choose another --sheet, or set" in done.stderr
    )
    assert "`elastica bow --rod`" in done.stderr


def test_step_and_picture_may_be_left_out(drawn, tmp_path):
    """Without a word of what they would need."""
    out = tmp_path / "out"
    options = ("strip", drawn, "--sheet", "birch-plywood-0.8", "--max-width", 40, "--output", out)
    result = run(*options, "--no-step", "--no-pictures")
    assert "needs" not in result.stdout
    assert {path.suffix for path in out.iterdir()} == {".dxf", ".svg", ".json"}


@pytest.mark.campaign
def test_the_bent_strip_is_written_for_screens(drawn, tmp_path):
    pytest.importorskip("OCP")
    import trimesh

    options = ("strip", drawn, "--sheet", "birch-plywood-0.8", "--max-width", 40)
    result = run(*options, "--set", "files.glb=true", "-o", tmp_path / "up")
    assert "bow.glb" in result.stdout
    assert json.loads((tmp_path / "up" / "bow.json").read_text())["files"]["glb"] == "bow.glb"
    lying = ("--set", "x_axis=[0,1,0]", "--set", "y_axis=[1,0,0]", "--set", "origin=[0,0,500]")
    run(*options, *lying, "--set", "files.glb=true", "-o", tmp_path / "lying")
    (curve,) = ec.read_curves(drawn)
    x, y = np.subtract(*curve.bounds[::-1])
    up, flat = (trimesh.load(tmp_path / folder / "bow.glb") for folder in ("up", "lying"))
    assert "bow" in {str(name).lower() for name in up.graph.nodes}
    around = 10.5  # the tabs, and half the thickness
    for scene, (along, high, across) in ((up, (x, y, 40)), (flat, (y, 40, x))):  # glTF: m, y up
        size = scene.extents * 1000
        assert np.all(size > np.array([along, high, across]) - 0.2)
        assert np.all(size < np.array([along, high, across]) + 2 * around)
    assert flat.bounds.mean(axis=0)[1] * 1000 == pytest.approx(500, abs=0.1)
    run(*options, "-o", tmp_path / "plain")
    assert not (tmp_path / "plain" / "bow.glb").exists()


def test_nothing_is_overwritten_without_force(drawn, tmp_path):
    arguments = ("strip", drawn, "--sheet", "card-200gsm", "--max-width", 40, "-o", tmp_path / "out")
    run(*arguments)
    before = {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()}
    again = run(*arguments, code=2)
    assert "overwritten (--force" in again.stderr
    assert {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()} == before
    run(*arguments, "--force")
    after = {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()}
    assert after["bow.dxf"] == before["bow.dxf"]
    assert after["bow.svg"] == before["bow.svg"]
    assert after["bow.json"] == before["bow.json"]


def test_the_drawing_itself_is_never_overwritten(drawn):
    before = drawn.read_bytes()
    arguments = ("strip", drawn, "--sheet", "card-200gsm", "--max-width", 40, "-o", drawn.parent)
    for force in ((), ("--force",)):
        result = run(*arguments, *force, code=2)
        assert "bow.json contains the drawn curve" in result.stderr
    assert [p.name for p in drawn.parent.iterdir()] == ["bow.json"]
    assert drawn.read_bytes() == before


@pytest.mark.campaign
def test_not_realizable_is_exit_code_1_with_advice_and_no_files(impossible, tmp_path):
    result = run(
        "strip", impossible, "--sheet", "card-200gsm", "--max-width", 40, "-o", tmp_path / "out", code=1
    )
    assert "mm" in result.stderr
    assert not (tmp_path / "out").exists() or not list((tmp_path / "out").iterdir())
    run("check", impossible, code=1)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--max-width 4", "only"),  # a neck below the least width of the workshop
        ("--max-width 30 --min-width 29", "less than --min-width"),
        ("--max-width 30 --set shop.stock=[60,40]", "larger than the stock"),
        ("--max-width 3 --style perforated --outer-width 12", "ligaments"),
    ],
)
def test_a_limit_of_widths_or_of_the_workshop_is_exit_code_1(words, message, drawn, tmp_path):
    """The input is valid, but no strip can be made of it. Wrong input has the exit code 2."""
    line = ("strip", drawn, *words.split(), "--sheet", "birch-plywood-0.8", "-o", tmp_path / "out", "--json")
    done = run(*line, code=1)
    assert json.loads(done.stdout)["exit_code"] == 1
    assert message in done.stderr


def test_the_largest_exit_code_of_several_curves_counts(drawn, tmp_path):
    corner, both = [[0, 0], [90, 0], [90, 70]], tmp_path / "both.svg"
    both.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="300mm" viewBox="0 0 300 300">'
        '<path d="M 0 0 C 60 90 140 90 200 0" fill="none"/>'
        f'<polyline points="{" ".join(f"{x},{y}" for x, y in corner)}" fill="none"/></svg>'
    )
    line = ("strip", both, "--all", "--sheet", "birch-plywood-0.8", "-o", tmp_path / "out", "--no-pictures")
    run(*line, "--max-width", 30, code=2)
    run("check", both, code=2)


def test_a_warning_of_cracks_in_corners_does_not_deny_them(tmp_path):
    """The corners beside a narrow tab may crack; only a strip that breaks as a whole is refused."""
    (tmp_path / "arc.json").write_text(curves_json([ec.PlaneCurve.arc((0, 0), 66.0, 0.0, 2.0)]))
    ends = "ends=[{length=10,width=14},{length=10,width=14}]"
    line = ("strip", tmp_path / "arc.json", "--sheet", "birch-plywood-0.8", "--max-width", 20, "--set", ends)
    lines = run(*line, "-o", tmp_path / "out", "--no-pictures", "--no-step").stderr.splitlines()
    texts = [text for text in lines if "in the corners beside the tab" in text]
    assert len(texts) == 2
    for text in texts:
        assert "the material may crack there" in text
        assert text.endswith("The files are written anyway, because the whole strip is not likely to break.")


@pytest.mark.campaign
def test_strain_warns_and_strict_makes_it_an_exit_code(tmp_path):
    path = tmp_path / "tight.json"
    path.write_text(curves_json([ec.PlaneCurve.arc((0, 0), 20.0, 0.0, 2.0)]))
    arguments = (
        "strip",
        path,
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        20,
        "-o",
        tmp_path / "out",
        "--label",
        "T",
    )
    broken = run(*arguments, code=1)
    assert broken.stderr.startswith("! Error     The strain is 2 % at")
    loose = run(*arguments, "--ignore-limits")
    assert "! Strain    The strain is 2 % at" in loose.stderr
    run(*arguments, "--ignore-limits", "--force", "--set", "files.strict=true", code=1)


@pytest.mark.campaign
def test_the_layer_that_is_strained_most_is_reported_and_is_strict(tmp_path):
    """Of two sheets the thicker one bears less: 0.8 % is within the base's 0.87 %, beyond the backing's 0.74 %."""
    arch = np.array([(0, 0), (30, 120), (150, 190), (270, 120), (300, 0)]) * 1.36
    path = tmp_path / "arch.json"
    path.write_text(curves_json([ec.PlaneCurve.spline(arch, degree=3)]))
    style = ("--style", "laminated", "--outer-width", 28, "--set", "style.backing=birch-plywood-1.5")
    made = run(
        "strip",
        path,
        "--sheet",
        "birch-plywood-0.8",
        *style,
        "--set",
        "files.strict=true",
        "-o",
        tmp_path / "out",
        code=1,
    )
    result = re.search(
        r"^! Strain +The strain is (\S+) % .*birch-plywood-1\.5 allows (\S+) %", made.stderr, re.MULTILINE
    )
    assert float(result[2]) < float(result[1]) < 100 * ec.Sheet.named("birch-plywood-0.8").max_strain


@pytest.mark.campaign
def test_kerf_widens_the_part_by_the_kerf_in_all(drawn, tmp_path):
    import ezdxf
    from ezdxf import bbox

    sizes = []
    for kerf in ("0", "0.2"):
        out = tmp_path / f"kerf{kerf}"
        run("strip", drawn, "--sheet", "card-200gsm", "--max-width", 40, "--kerf", kerf, "-o", out)
        cut = ezdxf.readfile(out / "bow.dxf").modelspace().query('*[layer=="CUT_OUTER"]')
        box = bbox.extents(cut)
        sizes.append([box.size.x, box.size.y])
    assert np.subtract(*reversed(sizes)) == pytest.approx([0.2, 0.2], abs=2e-3)


def test_sheets_lists_names_and_sources():
    assert "birch-plywood-0.8" in run("sheets").stdout
    assert "AC 43.13" in run("sheets", "birch-plywood-0.8").stdout


@pytest.mark.parametrize("command", [(), ("check",), ("strip",), ("sheets",)])
def test_help_teaches(command):
    result = run(*command, "--help")
    assert "Usage:" in result.stdout


BAD = {
    "missing.dxf": None,
    "empty.dxf": b"",
    "empty.csv": b"",
    "nan.csv": b"0,0\n1,nan\n2,1\n3,0\n4,1\n",
    "few.csv": b"0,0\n",
    "same.csv": b"1,1\n1,1\n1,1\n1,1\n1,1\n",
    "words.txt": b"hello world\n",
    "bad.json": b"{",
    "other.json": b'{"schema": "something"}',
    "unknown.xyz": b"1 2 3",
    "plain.svg": b"<svg xmlns='http://www.w3.org/2000/svg' width='10mm' height='10mm'/>",
    "broken.svg": b"<svg",
    "corner.csv": b"0,0\n50,30\n100,0\n",
    "drop.svg": b"<svg xmlns='http://www.w3.org/2000/svg' width='99mm' height='99mm'>"
    b"<path d='M10 10 C90 90 -70 90 10 10'/></svg>",
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_get_one_sentence_that_names_them(name, tmp_path):
    path = tmp_path / name
    if BAD[name] is not None:
        path.write_bytes(BAD[name])
    result = run("strip", path, "--sheet", "card-200gsm", "--max-width", 20, "-o", tmp_path / "out", code=2)
    assert name in result.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.campaign
def test_the_curve_at_fault_is_named_by_its_number(tmp_path):
    path = tmp_path / "several.json"
    arc = ec.PlaneCurve.arc((0, 0), 100.0, 0.0, 2.0)
    drop = ec.PlaneCurve.spline([(0, 0), (90, 90), (-90, 90), (0, 0)], degree=3)
    path.write_text(curves_json([arc, drop]))
    options = ("--sheet", "card-200gsm", "--max-width", 20, "-o", tmp_path)
    result = run("check", path, code=2)
    assert "several.json, curve 2 of 2: the closed curve has a corner" in result.stderr
    run("strip", path, "--curve", 1, *options)
    assert "curve 2 of 2" in run("strip", path, "--curve", 2, *options, code=2).stderr


@pytest.mark.campaign
def test_names_of_any_language(tmp_path):
    folder = tmp_path / "Träger und Bögen"
    folder.mkdir()
    path = folder / "Öse 字.json"
    path.write_text(curves_json([ec.PlaneCurve.arc((0, 0), 100.0, 0.0, 2.0)]))
    out = folder / "für Säge"
    run("strip", path, "--sheet", "card-200gsm", "--max-width", 20, "-o", out)
    assert json.loads((out / "Öse-字.json").read_text(encoding="utf-8"))["request"]["label"] == "Öse 字"
    assert (out / "Öse-字.dxf").stat().st_size > 1000


@pytest.mark.campaign
def test_folder_unknown_sheet_and_bad_numbers(drawn, tmp_path):
    good = ("--sheet", "card-200gsm", "--max-width", "20", "-o", tmp_path / "out")
    cases = [
        (("strip", tmp_path, *good), tmp_path.name),
        (("strip", drawn, "--sheet", "card-200gms", "--max-width", 20), "card-200gsm"),
        (("strip", drawn, "--sheet", "card-200gsm"), "--max-width"),
        (("strip", drawn, *good, "--kerf", "wide"), "kerf"),
        (("strip", drawn, *good, "--max-width", "-3"), "a number above 0"),
        (("strip", drawn, *good, "--tab", "-3"), "--tab: length is -3"),
        (("strip", drawn, *good, "--kerf", "50"), "wider than the cut of any tool"),
        (("strip", drawn, *good, "--curve", "7"), "7"),
        (("strip", drawn, *good, "--set", "cut.version=R99"), "R99"),
        (("strip", drawn, *good, "--set", "cut.tolerance=0"), "tolerance"),
        (
            ("strip", drawn, *good, "--set", "cut.tolerance=1e-12", "--set", "cut.curves=polyline"),
            "give a number from 0.0001 up to 10",
        ),
        (("strip", drawn, *good, "--keep-length"), "Add --nearest"),
        (("strip", drawn, *good, "--nearest", "--set", "samples=99"), "samples can only be set"),
    ]
    for arguments, words in cases:
        result = run(*arguments, code=2)
        assert words in result.stderr, result.stderr
        assert not (tmp_path / "out").exists(), arguments


@pytest.mark.campaign
def test_folder_that_nobody_may_write(drawn):
    """Not even root may make files in /proc."""
    result = run("strip", drawn, "--sheet", "card-200gsm", "--max-width", 20, "-o", "/proc/strips", code=2)
    assert "/proc/strips" in result.stderr


@pytest.mark.campaign
def test_output_folder_that_is_a_file(drawn, tmp_path):
    (tmp_path / "file").write_text("x")
    result = run("strip", drawn, "--sheet", "card-200gsm", "--max-width", 20, "-o", tmp_path / "file", code=2)
    assert "file" in result.stderr


@pytest.mark.campaign
def test_a_strip_that_strays_is_reported_what_compensates(tmp_path, monkeypatch):
    path = tmp_path / "arch.json"
    path.write_text(curves_json([ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])]))
    options = (
        "strip",
        path,
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        20,
        "--set",
        "slots = [{ at = 70, width = 1 }]",
    )
    result = run(*options, "-o", tmp_path / "plain").stdout
    left = float(
        re.search(r"^Change +use --compensate .* accurate to about ([\d.]+) mm$", result, re.MULTILINE)[1]
    )
    monkeypatch.setattr(trials, "MOST_PIECES", 0)
    untried = run(*options, "-o", tmp_path / "untried").stdout
    assert re.search(r"^Change +Not tried, because the curve has \d pieces", untried, re.MULTILINE)
    made_up = run(*options, "--compensate", "-o", tmp_path / "made up").stdout
    assert float(re.search(r"^Accuracy +about ([\d.]+) mm", made_up, re.MULTILINE)[1]) == left
    assert "--compensate" not in made_up


@pytest.mark.campaign
@pytest.mark.parametrize("weight", [(), ("--gravity",)], ids=["light", "heavy"])
def test_compensation_is_not_suggested_if_it_hardly_improves_the_accuracy(tmp_path, weight):
    path = tmp_path / "hoop.json"
    path.write_text(curves_json([ec.PlaneCurve.ellipse((0, 0), (50, 120), 0, -0.4, np.pi + 0.4)]))
    options = ("strip", path, "--sheet", "card-200gsm", "--max-width", 30, *weight)
    message = run(*options, "-o", tmp_path / "plain").stdout
    assert "--compensate" not in message  # the sheet causes most of the deviation


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("law", "quantity", "words"),
    [
        (
            'kind = "thickness", width = 20',
            "thickness",
            r"20 mm wide, 2\.\d\d to 3 mm thick",
        ),
        ('kind = "rod"', "diameter", r"2\.\d\d to 3 mm in diameter"),
    ],
)
def test_what_tapers_is_reported_in_words_numbers_and_picture(law, quantity, words, tmp_path):
    pytest.importorskip("matplotlib")
    from elastica_cad.plot import strip_sheet

    points = [(0, 0), (60, 150), (140, 200), (260, 150), (300, 0)]
    curve = ec.PlaneCurve.spline(points, degree=4)
    path = tmp_path / "arch.json"
    path.write_text(curves_json([curve]))
    law = f"{law}, limits = [1, 3]"
    done = run("strip", path, "--sheet", "pom-1", "--set", f"section = {{ {law} }}", "-o", tmp_path / "out")
    assert re.search(words, done.stdout), done.stdout
    sizes = json.loads((tmp_path / "out/arch.json").read_text())["stations"][quantity]
    assert max(sizes) == pytest.approx(3.0, rel=1e-4)
    assert min(sizes) < 2.99

    pom = ec.Sheet.named("pom-1")
    of = (
        ec.mechanics.ThicknessLaw(pom, 1, 3, width=20)
        if quantity == "thickness"
        else ec.mechanics.RoundLaw(pom, 1, 3)
    )
    picture = strip_sheet(ec.make_strip(curve, pom, section=of))
    assert "3.00" in [text.get_text() for text in picture.axes[2].texts]
    assert re.search(words, picture.get_suptitle())


@pytest.mark.campaign
def test_a_pen_curve_between_pins(tmp_path):
    """A half wave as a drawing program saves it, with three decimals, between ends that are free to turn."""
    length, height, pieces = 300.0, 80.0, 8
    t = np.linspace(0, 1, pieces + 1)
    place = np.column_stack([length * t, height * (1 - np.sin(np.pi * t))])
    handle = np.column_stack([np.full(t.size, length), -height * np.pi * np.cos(np.pi * t)]) / pieces / 3
    cubics = np.stack([place[:-1] + handle[:-1], place[1:] - handle[1:], place[1:]], axis=1)
    path = f"M{place[0, 0]:.3f},{place[0, 1]:.3f} C " + " ".join(
        f"{x:.3f},{y:.3f}" for x, y in cubics.reshape(-1, 2)
    )
    (tmp_path / "wave.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="80mm" viewBox="0 0 300 80">'
        f'<path d="{path}"/></svg>'
    )
    options = ("--start", "pinned", "--end", "pinned", "--sheet", "birch-plywood-0.8", "--max-width", "40")
    for more in ((), ("--gravity",)):
        run("strip", "wave.svg", *options, *more, "--force", "-o", "out", cwd=tmp_path)
        report = json.loads((tmp_path / "out" / "wave.json").read_text())
        # (1 + (pi h / L)^2)^(3/2) of the half wave
        assert report["ratio"] == pytest.approx((1 + (np.pi * height / length) ** 2) ** 1.5, rel=0.1)


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            ("--keep-strain", "--set", "limits.strain=0.05"),
            "--keep-strain and --set limits.strain set the same value. Leave out one of them",
        ),
        (
            ("--keep-tangents", "--set", "keep.tangents=[false,true]"),
            "--keep-tangents and --set keep.tangents set the same value",
        ),
        (
            ("--set", "limits.width=[10,15]"),
            "outside the limits of the width, 10 to 15 mm: .* limits \\(--set limits.width\\)",
        ),
    ],
)
def test_of_two_options_none_is_ignored(drawn, tmp_path, options, message):
    """The larger strain had been kept within, the tangent of the other end too, without a word."""
    result = run(
        "strip",
        drawn,
        "--sheet",
        "card-200gsm",
        "--max-width",
        20,
        "--nearest",
        *options,
        "-o",
        tmp_path,
        code=2,
    )
    assert re.search(message, result.stderr)


@pytest.mark.parametrize("changes", [(), ("--nearest",), ("--ratio", "2.5"), ("--nearest", "--stable")])
def test_a_loop_warns_once_that_the_strip_crosses_itself(tmp_path, changes):
    loop = ec.PlaneCurve.spline([(0, 0), (200, 100), (-100, 100), (100, 0)], degree=3)
    path = tmp_path / "loop.json"
    path.write_text(curves_json([loop]))
    width = ("--sheet", "pom-0.5", "--max-width", 60)
    printed = run("strip", path, *width, *changes, "--ignore-limits", "-o", tmp_path / "out").output
    assert printed.count("crosses itself") == 1


@pytest.mark.parametrize(
    ("design", "message"),
    [
        ("out", "is a folder"),
        ("out/arch.svg", "Choose another name for the design"),
        ("arch.csv", "Choose another name for the design"),
    ],
)
def test_a_design_is_not_saved_over_the_folder_the_files_or_the_drawn_curve(tmp_path, design, message):
    drawn = tmp_path / "arch.csv"
    drawn.write_text("0,0\n40,30\n110,55\n190,40\n240,0\n")
    before = drawn.read_bytes()
    options = "--sheet birch-plywood-0.8 --max-width 20 --no-step --no-pictures --force -o out"
    done = run(f"strip arch.csv {options} --save-design {design}", cwd=tmp_path, code=2)
    assert message in " ".join(done.stderr.split())
    assert [path.name for path in tmp_path.iterdir()] == ["arch.csv"]
    assert drawn.read_bytes() == before
