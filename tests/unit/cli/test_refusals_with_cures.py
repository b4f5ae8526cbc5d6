"""A refusal ends with a command that works, and the command is run as it is printed."""

import json
import re
import shlex
import signal
import subprocess
import sys

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.formats import write_curves

CURVES = {
    "wave": [(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)],  # no strip takes it
    "tall": [(0, 0), (30, 120), (70, 130), (120, 60), (150, 0)],  # one does, with a neck of 2.3 mm
}


def typed(words, cwd):
    return subprocess.run(
        [sys.executable, "-m", "elastica_cad", *words], cwd=cwd, capture_output=True, text=True, check=False
    )


def ended_by_ctrl_c(words, cwd, first="pass"):
    """What a command says before Ctrl-C and after it, and its exit code; `first` is run before it."""
    heard = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"  # also behind a shell's &
    )
    run = [sys.executable, "-c", f"{heard}; {first}; from elastica_cad.cli import main; main()", *words]
    with subprocess.Popen(run, cwd=cwd, stderr=subprocess.PIPE, bufsize=0) as running:
        before = running.stderr.read(4096).decode()
        running.send_signal(signal.SIGINT)
        after = running.stderr.read().decode()
    return before, after, running.returncode


@pytest.fixture
def zigzag(tmp_path):
    """A drawing of which no strip comes near soon: the search for one takes seconds."""
    (tmp_path / "zigzag.csv").write_text("".join(f"{10 * i},{20 * (i % 2)}\n" for i in range(40)))
    return tmp_path


def test_the_verdict_is_told_before_the_search_for_a_cure_which_ctrl_c_ends(zigzag):
    verdict, rest, code = ended_by_ctrl_c(["check", "zigzag.csv"], zigzag)
    assert verdict.startswith("Error: zigzag.csv: the curve has a corner at")
    assert "This works" not in verdict
    assert rest == "\n"
    assert code == 2


@pytest.mark.campaign
def test_a_search_that_takes_longer_than_it_may_leaves_the_verdict(zigzag):
    words = "strip zigzag.csv --sheet pom-0.5 --max-width 20 --seconds 3 --json"
    refused = typed(words.split(), zigzag)
    assert refused.returncode == 2
    assert refused.stderr.startswith("Error: zigzag.csv: the curve has a corner at")
    assert "takes longer" not in refused.stderr
    assert json.loads(refused.stdout)["error"] == refused.stderr.rstrip("\n")


@pytest.mark.campaign
@pytest.mark.parametrize("name", CURVES)
def test_the_command_that_is_told_works(name, tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES[name], degree=4)], tmp_path / f"{name}.dxf")
    words = f"strip {name}.dxf --sheet birch-plywood-0.8 --max-width 12 -o out".split()
    refused = typed(words, tmp_path)
    assert refused.returncode in (1, 2)
    assert not (tmp_path / "out").exists()
    (command, said) = re.search(r"This works: `.*? -m elastica_cad ([^`]*)` (.*)", refused.stderr).groups()
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr
    far = float(re.search(r"to within ([0-9.]+) mm", said)[1])
    assert far == pytest.approx(float(re.search(r"drawn curve ([0-9.]+) mm", made.stdout)[1]), rel=0.05)
    report = (tmp_path / "out" / f"{name}.json").read_text()
    assert "max_strain" in report


@pytest.mark.campaign
def test_a_wider_strip_is_told_where_the_sheet_asks_for_one(tmp_path):
    """No nearer curve helps 2 mm of a sheet that needs 3: the width typed is outweighed by the one that is told."""
    write_curves([ec.PlaneCurve.spline(CURVES["tall"], degree=4)], tmp_path / "tall.dxf")
    refused = typed(
        ["strip", "tall.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "2", "-o", "out"], tmp_path
    )
    assert refused.returncode == 2
    assert "mm wide at" in refused.stderr
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    assert "--max-width 4" in command
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr


@pytest.mark.campaign
def test_a_neck_is_written_anyway_and_said(tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["tall"], degree=4)], tmp_path / "tall.dxf")
    words = [
        "strip",
        "tall.dxf",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        "12",
        "--ignore-limits",
        "-o",
        "out",
    ]
    made = typed(words, tmp_path)
    assert made.returncode == 0, made.stderr
    assert "made anyway: tall: only 2.3 mm wide" in made.stderr
    assert "made anyway" in (tmp_path / "out" / "tall.json").read_text()


@pytest.mark.campaign
def test_the_margin_comes_with_a_word(tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["tall"], degree=4)], tmp_path / "tall.dxf")
    made = typed(
        ["strip", "tall.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "30", "-o", "out"], tmp_path
    )
    assert re.search(r"stable, margin [0-9.]+ \((low|ample)\): it stays", made.stdout)


@pytest.mark.campaign
def test_a_long_thin_arch_is_refused(tmp_path):
    arch = [(0, 0), (1500, 1900), (3500, 2000), (6000, 0)]
    write_curves([ec.PlaneCurve.spline(arch, degree=3)], tmp_path / "long.dxf")
    refused = typed(
        ["strip", "long.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "3.6", "-o", "out"], tmp_path
    )
    assert refused.returncode == 2
    assert "larger than the stock" in refused.stderr
    assert not (tmp_path / "out").exists()


REFUSED = [
    ("check wave.dxf", "--sheet card-200gsm --max-width 14 --nearest"),
    ("check arch.dfx", "check arch.dxf"),
    ("--units inch check arch.dxf", "check arch.dxf --units inch"),
    ("please check arch.dxf", "check arch.dxf"),
    ("check tall.dxf --start clampd", "--start clamped"),
    ("strip tall.dxf --sheet pom-1 --max-width 30 --curve 3 -o out", "--max-width 30 -o out --curve 1"),
    ("strip corner.svg --sheet birch-plywood-0.8 --max-width 20", "--nearest"),
    ("strip ring.svg --sheet birch-plywood-0.8 --max-width 20", "-o out"),
    ("check corner.svg", "strip corner.svg --sheet"),
    ("check both.svg --curve 2", "strip both.svg --curve 2 --sheet"),
    ("bend corner.svg --to 100 0", "--nearest"),
    ("bend wave.dxf --to 130 0", "--nearest"),
    ("bend two.dxf --to 130 0", "--curve 2"),
    ("reshape tall.dxf", "--top-right 165"),
    ("reshape tall.dxf --handle 0 0 0 0", "--top-right 165"),
    ("reshape tall.dxf --handle 0 0 0 0 --top-right 200 200", "--top-right 200 200"),
    ("reshape tall.dxf --top-right 0 0", "--top-right 120"),
    ("reshape tall.dxf --top-right 150 -200", "--top-right 150 36"),
    (
        "reshape tall.dxf --handle 0 0 0 0 --handle 150 0 150 0 --handle 150 90 0 0 --handle 0 90 0 90",
        "--handle 150 90 120 72",
    ),
    ("bend --straight 100 --to 200 0", "--to 90 0"),
    ("bend tall.dxf --from 10 0 --to 1000 0", "--to 240"),
    ("strip corner.svg --sheet birch-plywood-0.8 --max-width 20 -o out", "--split-corners"),
    ("check corner.svg", "--split-corners"),
    ("strip slight.svg --sheet birch-plywood-0.8 --max-width 30 -o out", "--smooth 0.2"),
    ("check slight.svg", "--smooth 0.2"),
    ("bend --straight 100 --gravity --to 90 0", "--sheet birch-plywood-0.8"),
    ("bend --straight 300 --to 200 0 --sheet card-200gsm --down 1 0", "--gravity"),
    ("strip tall.dxf --sheet birch-plywood-0.8 --max-width 40 --down 1 0", "--down 1 0 --gravity"),
    ("strip tall.dxf --sheet birch-plywood-0.8 --max-width 40 --gravity-length 400", "--gravity"),
    ("bend", "--straight 300 --to 200 0"),
    ("sheets birch-ply", "sheets birch-plywood-"),
    ("coupon", "--sheet birch-plywood-0.8"),
    ("coupon --sheet card-200gsm --width 2", "--width 8"),
    ("coupon --sheet crad-200gsm", "--sheet card-200gsm"),
    ("strip tall.dxf --max-width 30", "--sheet birch-plywood-0.8"),
    ("sections bowl.obj --unit mm", "--radial 8"),
    ("sections bowl.obj --unit mm --radial 4 --count 3", "--radial 4"),
    ("model design.toml --no-step --no-pictures", "--nearest"),
    ("model thin.toml --no-step --no-pictures", "--nearest"),
]
CORNER, RING, SLIGHT = (
    '<path d="M 10 100 C 40 60 70 60 100 100 C 130 60 160 60 190 100"/>',
    '<circle cx="100" cy="100" r="50"/>',
    '<path d="M 20 150 C 50 90 90 60 140 60.00000 C 190 60.10000 240 100 270 150"/>',  # 0.115 degrees
)
DESIGN = """
schema = 1
name = "kit"
sheet = "birch-plywood-0.8"
max_width = 12
[[strips]]
label = "K1"
"""


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """A folder with drawings and designs, a slip of a letter in some names."""
    folder = tmp_path_factory.mktemp("desk")
    drawn = {name: ec.PlaneCurve.spline(points, degree=4) for name, points in CURVES.items()}
    for name, curve in drawn.items():
        write_curves([curve], folder / f"{name}.dxf")
    write_curves(
        [drawn["wave"], drawn["tall"].transformed([[1, 0, 300], [0, 1, 0], [0, 0, 1]])], folder / "two.dxf"
    )
    for name, paths in (("corner", CORNER), ("ring", RING), ("both", RING + CORNER), ("slight", SLIGHT)):
        (folder / f"{name}.svg").write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">'
            f"{paths}</svg>"
        )
    (folder / "arch.dxf").write_bytes((folder / "tall.dxf").read_bytes())
    (folder / "design.toml").write_text(f'{DESIGN}curve = "wave.dxf"\n')
    (folder / "thin.toml").write_text(f'{DESIGN}curve = "tall.dxf"\n')
    made = typed(["new", "sections"], folder)
    assert made.returncode == 0, made.stderr
    return folder


@pytest.mark.campaign
@pytest.mark.parametrize(("words", "told"), REFUSED)
def test_every_command_ends_a_refusal_with_one_that_works(words, told, desk, tmp_path):
    before = sorted(desk.iterdir())
    refused = typed(words.split(), desk)
    assert refused.returncode in (1, 2)
    assert sorted(desk.iterdir()) == before  # trials leave nothing
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr + refused.stdout)
    assert told in command
    aside = [] if command.startswith(("check", "sheets")) else ["-o", str(tmp_path)]
    made = typed([*shlex.split(command), *aside], desk)
    assert made.returncode == 0, made.stderr


@pytest.mark.campaign
def test_a_drawing_is_kept_and_another_folder_told(desk, tmp_path):
    drawing = tmp_path / "tall.dxf"
    drawing.write_bytes((desk / "tall.dxf").read_bytes())
    words = "strip tall.dxf --sheet birch-plywood-0.8 --max-width 30"
    refused = typed(words.split(), tmp_path)
    assert f"-m elastica_cad {words} -o out`" in refused.stderr
    assert typed([*words.split(), "-o", "out"], tmp_path).returncode == 0
    assert drawing.read_bytes() == (desk / "tall.dxf").read_bytes()
    assert (tmp_path / "out" / "tall.dxf").exists()


@pytest.mark.campaign
def test_every_bad_curve_of_a_file_ends_with_its_own_command_and_the_good_one_is_made(desk, tmp_path):
    many = desk / "many.svg"
    good = '<path d="M 10 150 C 40 120 70 120 100 150"/>'
    many.write_text((desk / "both.svg").read_text().replace("</svg>", f"{good}</svg>"))
    words = f"strip many.svg --all --sheet card-200gsm --max-width 12 -o {tmp_path / 'out'}"
    made = typed(words.split(), desk)
    assert made.returncode == 1
    assert (tmp_path / "out" / "many-3.dxf").exists()
    told = {
        number: line for line in made.stderr.splitlines() for number in "12" if f"curve {number} of" in line
    }
    for number, line in told.items():
        command = shlex.split(re.search(r"This works: `.*? -m elastica_cad ([^`]*)`", line)[1])
        assert command[-2:] == ["--curve", number]
        assert typed(command, desk).returncode == 0
    names = {one.stem[: len("many-1")] for one in (tmp_path / "out").iterdir()}
    assert names == {"many-1", "many-2", "many-3"}  # the strips of the commands beside the first
    many.unlink()


def test_pieces_between_corners_carry_the_number_of_the_joint(desk, tmp_path):
    words = "strip corner.svg --split-corners --sheet card-200gsm --max-width 12 --json"
    made = typed([*words.split(), "-o", str(tmp_path)], desk)
    assert made.returncode == 0, made.stderr
    first, last = json.loads(made.stdout)["strips"]
    assert (first["joints"], last["joints"]) == (["", "J1"], ["J1", ""])
    assert first["length"] == pytest.approx(last["length"], rel=1e-6)
    plain = typed([*words.split(), "--label", "", "--curves", "polyline", "-o", str(tmp_path / "bare")], desk)
    assert plain.returncode == 0
    engraved = [(tmp_path / "bare" / f"corner-{k}.dxf").read_text().count("ENGRAVE") for k in (1, 2)]
    assert engraved[0] == engraved[1] > 2  # strokes of J and 1, at the end of one, at the start of the other


SLIPS = {
    "sheet": ("birch-plywood-0.8", "birch-plywod-0.8", "write `birch-plywood-0.8`"),
    "key": ("max_width", "max_widht", "write `max_width`"),
    "key of a strip": ("curve =", "curv =", "write `curve`"),
    "file": ("wide.dxf", "wdie.dxf", "write `wide.dxf`"),
    "schema": ("schema = 1", "", "write `schema = 1`"),
    "quotes": ('"wide.dxf"', "wide.dxf", 'write `curve = "wide.dxf"`'),
}


@pytest.mark.campaign
@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_in_a_design_ends_with_what_to_write_and_the_command_to_run_again(slip, tmp_path):
    right, wrong, told = SLIPS[slip]
    write_curves([ec.PlaneCurve.spline([(0, 0), (50, 50), (100, 0)], degree=2)], tmp_path / "wide.dxf")
    design = tmp_path / "kit.toml"
    design.write_text(f'{DESIGN}curve = "wide.dxf"\n'.replace(right, wrong))
    refused = typed(["model", "kit.toml", "--no-step", "--no-pictures", "-o", "out"], tmp_path)
    assert refused.returncode == 2
    assert told in refused.stderr
    assert sorted(one.name for one in tmp_path.iterdir()) == ["kit.toml", "wide.dxf"]
    write, old, line = re.search(
        r"This works: write `(.*?)`(?: for `(.*?)`)? in (?:a first line|line (\d+)) of kit.toml, then",
        refused.stderr,
    ).groups()
    lines = design.read_text().splitlines()
    if line is None:
        lines.insert(0, write)
    else:
        at = int(line) - 1
        lines[at] = write if old is None else lines[at].replace(old, write)
    design.write_text("\n".join(lines))
    (command,) = re.findall(r"then `.* -m elastica_cad ([^`]*)`", refused.stderr)
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("asked", "write"),
    [("", "nest.sheet_size = [1250, 1250]"), ("nest = { sheet_size = [900, 600] }\n", "shop.lap = 80")],
)
def test_a_strip_longer_than_its_sheet_ends_with_a_line_that_makes_room(asked, write, tmp_path):
    """A sheet that holds it, or where the file names its sheet, pieces that are joined."""
    design = tmp_path / "kit.toml"
    arch = "curve = { spline = [[0, 0], [500, 500], [1000, 0]], degree = 2 }"
    design.write_text(f"{asked}{DESIGN}{arch}\n")
    words = ["model", "kit.toml", "--no-step", "--no-pictures", "--no-effects", "-o", "out"]
    refused = typed(words, tmp_path)
    assert refused.returncode == 2
    assert "mm is larger than a sheet of" in refused.stderr
    assert f"This works: write `{write}` in a first line of kit.toml" in refused.stderr
    design.write_text(f"{write}\n{design.read_text()}")
    made = typed(words, tmp_path)
    assert made.returncode == 0, made.stderr


@pytest.mark.campaign
def test_all_slips_of_a_design_are_told_and_mended_in_one_go(tmp_path):
    arch = "curve = { spline = [[0, 0], [50, 50], [100, 0]], degree = 2 }"
    lines = [
        "schema = 1", 'sheet = "birch-plywod-0.8"', "max_widht = 12",
        "[[strips]]", 'labl = "A"', arch, "[[strips]]", 'style = { kind = "plian" }', arch, "[nset]", "margin = 4",
    ]  # fmt: skip
    design = tmp_path / "sub" / "kit.toml"
    design.parent.mkdir()
    design.write_text("\n".join(lines))
    refused = typed(["model", "sub/kit.toml", "--no-step", "--no-pictures", "-o", "out"], tmp_path)
    assert refused.returncode == 2
    said, mends = refused.stderr.split("This works: ")
    for slip in ("'max_widht'", "'nset'", "'birch-plywod-0.8'", "'labl'"):
        assert said.count(slip) == 1
    told = re.findall(r"write `([^`]+)` for `([^`]+)` in line (\d+) of kit.toml", mends)
    assert {wrong for _, wrong, _ in told} == {"birch-plywod-0.8", "max_widht", "nset", "labl", "plian"}
    for right, wrong, line in told:
        lines[int(line) - 1] = lines[int(line) - 1].replace(wrong, right)
    design.write_text("\n".join(lines))
    (command,) = re.findall(r"then `.* -m elastica_cad ([^`]*)`", mends)
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr


@pytest.mark.campaign
def test_all_strips_of_a_design_that_cannot_be_made_are_named(desk, tmp_path):
    design = desk / "several.toml"
    strip = '[[strips]]\nlabel = "K{}"\ncurve = "{}"\n'
    named = [strip.format(2, "tall.dxf"), strip.format(3, "arch.dxf").replace("K3", "good")]
    design.write_text(f'{DESIGN}curve = "wave.dxf"\n' + named[0] + named[1] + "max_width = 40\n")
    refused = typed(["model", "several.toml", "--no-step", "--no-pictures", "-o", str(tmp_path)], desk)
    design.unlink()
    assert refused.returncode == 1
    assert "K1: " in refused.stderr
    assert "Also: K2: only 2.3" in refused.stderr
    assert "good: " not in refused.stderr
    assert "--nearest" in refused.stderr


def test_a_reshaped_curve_that_cannot_be_bent_ends_with_a_strip_near_it(tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["wave"], degree=4)], tmp_path / "wave.dxf")
    refused = typed(["reshape", "wave.dxf", "--top-right", "265", "190"], tmp_path)
    assert refused.returncode == 1
    (command,) = re.findall(
        r"This works: `.*? -m elastica_cad (strip wave-reshaped.dxf [^`]*)`", refused.stderr
    )
    made = typed([*shlex.split(command), "-o", "out"], tmp_path)
    assert made.returncode == 0, made.stderr


def test_margins_of_bent_strips_come_with_a_word(tmp_path):
    made = typed(["bend", "--straight", "200", "--to", "150", "0", "-o", "out"], tmp_path)
    assert re.search(r"stable, margin [0-9.]+ \((low|ample)\)", made.stdout)


@pytest.mark.campaign
@pytest.mark.parametrize("out", ["taken", "taken/below"])
def test_a_file_where_files_should_go_is_told_and_no_command_that_fails_as_well(out, desk, tmp_path):
    """Trials write elsewhere: `--nearest` was told to work, into the same file."""
    taken = tmp_path / "taken"
    taken.write_text("mine")
    words = [
        "strip",
        "tall.dxf",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        "40",
        "-o",
        str(tmp_path / out),
    ]
    refused = typed(words, desk)
    assert refused.returncode == 2
    assert "choose another folder" in refused.stderr
    assert "This works" not in refused.stderr
    assert taken.read_text() == "mine"


def test_an_option_is_no_folder(tmp_path):
    asked = typed(["new", "lamp", "-o", "--json"], tmp_path)
    assert asked.returncode == 2
    assert "'--json' reads as an option: name a folder before it" in asked.stderr
    assert not (tmp_path / "--json").exists()


@pytest.mark.parametrize(
    ("width", "told"),
    [("2e7", "is 2e+07 mm: give a length of at most 1e+06 mm"), ("9e5", "is larger than the stock of")],
)
def test_an_absurd_width_is_told_at_once(width, told, desk):
    asked = ["strip", "arch.dxf", "--sheet", "birch-plywood-0.8", "--max-width", width]
    refused = typed(asked, desk)
    assert refused.returncode == 2
    assert told in refused.stderr


@pytest.mark.campaign
def test_a_strip_wider_than_the_stock_is_told_a_smaller_width(tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["tall"], degree=4)], tmp_path / "tall.dxf")
    refused = typed(
        ["strip", "tall.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "4000", "-o", "out"], tmp_path
    )
    assert refused.returncode == 2
    assert (
        "larger than the stock of 3050 x 1525 mm in birch-plywood-0.8; give a smaller max_width"
        in refused.stderr
    )
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    assert "--nearest" not in command
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr


@pytest.mark.parametrize("words", ["sheets --units", "strip arch.csv --max-width", "batten --stock 20"])
def test_an_option_without_its_value_is_one_sentence(words, tmp_path):
    refused = typed(words.split(), tmp_path)
    assert refused.returncode == 2
    assert "Traceback" not in refused.stderr
    assert words.split()[-1 if "20" not in words else 1] in refused.stderr


@pytest.mark.campaign
def test_a_misspelt_key_of_a_tab_keeps_its_tab(tmp_path):
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    write_curves([arch], tmp_path / "arch.dxf")
    words = ["strip", "arch.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "30"]
    refused = typed([*words, "--end-tab", "lenght = 25", "-o", "out"], tmp_path)
    assert refused.returncode == 2
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    assert "length = 25" in command
    made = typed(shlex.split(command), tmp_path)
    assert made.returncode == 0, made.stderr


def test_handles_of_a_curve_that_is_not_there_are_refused(tmp_path):
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    write_curves([arch], tmp_path / "arch.dxf")
    words = [
        "reshape",
        "arch.dxf",
        "--top-right",
        "120",
        "80",
        "--handle",
        "200",
        "-1e308",
        "40",
        "0.5",
        "--curve",
    ]
    refused = typed([*words, "point = [0, 0], normal = [0, 1]", "-o", "out"], tmp_path)
    assert refused.returncode == 2
    assert "Traceback" not in refused.stderr
    assert refused.stderr.startswith(("Error: ", "Usage: "))


def test_no_command_is_told_where_parts_would_share_a_file(tmp_path):
    """Trials left the parts out, so a command was told that was refused as the one before."""
    (tmp_path / "arch.csv").write_text("0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n")
    strips = "".join(f'[[strips]]\ncurve = "arch.csv"\nlabel = "{label}"\n' for label in "Aa")
    (tmp_path / "two.toml").write_text(f'schema = 1\nsheet = "birch-plywood-0.8"\nmax_width = 25\n{strips}')
    refused = typed(["model", "two.toml", "-o", "kit", "--no-step", "--no-pictures"], tmp_path)
    assert refused.returncode == 2
    assert "choose labels that differ in more than capitals" in refused.stderr
    for command in re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr):
        made = typed(shlex.split(command), tmp_path)
        assert made.returncode == 0, made.stderr


@pytest.mark.campaign
@pytest.mark.parametrize("command", ["check", "strip"])
def test_of_several_files_the_first_is_named(command, tmp_path):
    """A pattern such as *.dxf comes as several words."""
    for name in "ab":
        write_curves([ec.PlaneCurve.spline([(0, 0), (40, 60), (100, 0)], degree=2)], tmp_path / f"{name}.dxf")
    made_of = ["--sheet", "birch-plywood-0.8", "--max-width", "12", "-o", "out"]
    rest = made_of if command == "strip" else []
    refused = typed([command, "a.dxf", "b.dxf", *rest], tmp_path)
    assert refused.returncode == 2
    assert "unexpected extra argument (b.dxf)" in refused.stderr
    told = re.search(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    assert shlex.split(told[1]) == [command, "a.dxf", *rest]
    assert typed(shlex.split(told[1]), tmp_path).returncode == 0


def test_no_command_is_told_where_the_folder_reads_as_an_option(tmp_path):
    """Trials write elsewhere, so one had been told that is refused as well."""
    write_curves([ec.PlaneCurve.spline([(0, 0), (40, 60), (100, 0)], degree=2)], tmp_path / "a.dxf")
    words = ["strip", "a.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "12", "-o", "-o"]
    refused = typed(words, tmp_path)
    assert refused.returncode == 2
    assert refused.stderr.endswith("name a folder before it, or write ./-o\n")


FLATTER_THAN_THEY_CAN_BE = """schema = 1
sheet = "card-200gsm"
max_width = 20
limits = { curvature = 0.001 }
keep = { tangents = true, length = true }
[[strips]]
curve = { x = "t", y = "t * (120 - t) / 60", t = [0, 120] }
label = "A"
[[strips]]
curve = { x = "t", y = "t * (120 - t) / 50", t = [0, 120] }
label = "B"
"""


@pytest.mark.campaign
def test_limits_that_two_strips_miss_are_told_before_what_would_help_the_first(tmp_path):
    (tmp_path / "pair.toml").write_text(FLATTER_THAN_THEY_CAN_BE)
    slow = (
        "import elastica_cad.forming.nearest.advice as a, time; a._ways_out = lambda _: time.sleep(60) or ()"
    )
    verdict, rest, code = ended_by_ctrl_c(["model", "pair.toml", "-o", "out"], tmp_path, first=slow)
    assert verdict.startswith("Not within these limits: A: The limits cannot be met")
    assert "Also: B: The limits cannot be met" in verdict
    assert rest == "\n"
    assert code == 1


@pytest.mark.campaign
def test_what_would_help_is_sought_once_and_for_the_first_alone(tmp_path):
    (tmp_path / "pair.toml").write_text(FLATTER_THAN_THEY_CAN_BE)
    counted = (
        "import elastica_cad.forming.nearest.advice as a, sys; said = a._ways_out;"
        "a._ways_out = lambda near: (print('sought'), said(near))[1]"
    )
    run = f"{counted}; from elastica_cad.cli import main; main()"
    words = [sys.executable, "-c", run, "model", "pair.toml", "-o", "out"]
    told = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert told.stdout == "sought\n"
    verdict, advice = told.stderr.split("What would help the first: ")
    assert "is missed" not in verdict
    assert re.search(
        r"Missed: the end position, by \d+(\.\d+)? mm\. Without the curvature limit all limits are met",
        advice,
    )
    assert "Without the curvature limit all limits are met" in advice


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("words", "ending", "widest"),
    [
        ("strip ring.csv --sheet pom-0.5 --max-width 0.5", "--smooth 0.1mm", 12.7),
        ("strip arch.csv --sheet birch-plywood-0.8 --max-width 0.1", "--max-width 5.08mm --nearest", 5.08),
        ("strip arch.csv --sheet birch-plywood-0.8", "--max-width 20mm", 20.0),
        ("check ring.csv", "--max-width 53mm --smooth 0.1mm", 53.0),
    ],
)
def test_a_command_in_inches_is_told_lengths_that_are_read_as_they_are_meant(words, ending, widest, tmp_path):
    (tmp_path / "arch.csv").write_text("0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n")
    turns = np.linspace(0, 2 * np.pi, 49)
    ring = np.round(np.column_stack([120 * np.cos(turns), 80 * np.sin(turns)]), 6)
    (tmp_path / "ring.csv").write_text("".join(f"{x},{y}\n" for x, y in ring))
    refused = typed([*words.split(), "--units", "inch"], tmp_path)
    assert refused.returncode == 2
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    assert command.endswith(ending)
    made = typed([*shlex.split(command), "-o", "out", "--json"], tmp_path)
    assert made.returncode == 0, made.stderr
    (strip,) = json.loads(made.stdout)["strips"]
    assert strip["width"]["largest"] == pytest.approx(widest, rel=1e-4)
    assert strip["smoothing"] is None or strip["smoothing"]["moved"] < 0.1


@pytest.mark.campaign
def test_ends_in_inches_are_told_where_the_strip_reaches(tmp_path):
    refused = typed(["bend", "--straight", "10", "--to", "12", "0", "--units", "inch"], tmp_path)
    (command,) = re.findall(r"This works: `.*? -m elastica_cad ([^`]*)`", refused.stderr)
    made = typed([*shlex.split(command), "-o", "out", "--json"], tmp_path)
    assert made.returncode == 0, made.stderr
    assert json.loads(made.stdout)["shapes"][-1]["end"] == pytest.approx([228.6, 0.0])


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("check", "Missing argument 'CURVE': give the file that it is drawn in (DXF, SVG, CSV, JSON, STEP), or"),
        ("model", "Missing argument 'DESIGN': give a design file; `elastica new pavilion` writes one"),
        ("sections", "Missing argument 'MESH': give the file of a mesh (OBJ, STL, PLY) or of a STEP body."),
        ("strip arch.dxf", "Missing option '--sheet': give --sheet NAME|FILE. Material: a name of"),
        ("batten --sheet pom-1", "Missing option '--length': give --length MM. Of the batten."),
    ],
)  # fmt: skip
def test_what_is_missing_is_told_with_what_to_give(tmp_path, words, told):
    refused = typed(words.split(), tmp_path)
    assert refused.returncode == 2
    assert f"Error: {told}" in refused.stderr


@pytest.mark.campaign
def test_a_file_of_quite_another_name_is_not_offered_for_a_lost_one(tmp_path):
    """Another curve would be cut; a slip of the finger and another ending are mended."""
    ec.write_curves([ec.PlaneCurve.spline(CURVES["tall"])], tmp_path / "arch.svg")
    for lost, is_offered in (("pot.svg", False), ("acrh.svg", True), ("arch.dxf", True), ("ARCH.dxf", True)):
        refused = typed(["check", lost], tmp_path)
        assert refused.returncode == 2
        assert ("check arch.svg" in refused.stderr) == is_offered, refused.stderr
