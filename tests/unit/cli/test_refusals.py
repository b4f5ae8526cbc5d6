"""A refusal ends with a suggestion where one was made, and the suggestion is run as it is printed."""

import json
import re
import shlex
import shutil
import signal
import subprocess
import sys

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import write_curves
from elastica_cad.cli.options import option_name
from elastica_cad.cli.settings import CommandKeys, parsed_settings
from elastica_cad.cli.strip_options import OPTIONS
from elastica_cad.cli.suggestions import cures_of
from elastica_cad.mechanics import trials
from elastica_cad.strip import suggestions
from tests.command_line import run, suggested_commands

CURVES = {
    "wave": [(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)],  # no strip takes it
    "tall": [(0, 0), (30, 120), (70, 130), (120, 60), (150, 0)],  # one does, with a neck of 2.3 mm
}


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
    made = run(*words, cwd=tmp_path)
    assert "Made anyway: tall: only 2.3 mm wide" in made.stderr
    assert "Made anyway" in (tmp_path / "out" / "tall.json").read_text()


@pytest.mark.campaign
def test_stability_is_a_word_and_its_margin_a_detail(tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["tall"], degree=4)], tmp_path / "tall.dxf")
    words = ("strip", "tall.dxf", "--sheet", "pom-0.5", "--max-width", "30", "-o", "out", "-v")
    made = run(*words, cwd=tmp_path)
    assert re.search(
        r"^Stability   stable: the strip neither snaps into another shape nor tips over sideways$",
        made.stdout,
        re.MULTILINE,
    )
    assert re.search(
        r"^ +The stability margin is [0-9.]+; below 5, a push can move .* shape\.$", made.stdout, re.MULTILINE
    )


@pytest.mark.campaign
def test_a_long_thin_arch_is_refused(tmp_path):
    arch = [(0, 0), (1500, 1900), (3500, 2000), (6000, 0)]
    write_curves([ec.PlaneCurve.spline(arch, degree=3)], tmp_path / "long.dxf")
    refused = run("strip long.dxf --sheet birch-plywood-0.8 --max-width 3.6 -o out", cwd=tmp_path, code=1)
    assert "larger than the stock" in refused.stderr
    assert not (tmp_path / "out").exists()


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
    write_curves([drawn["tall"].transformed([[2, 0, 0], [0, 2, 0], [0, 0, 1]])], folder / "wide.dxf")
    (folder / "arch.dxf").write_bytes((folder / "tall.dxf").read_bytes())
    (folder / "design.toml").write_text(f'{DESIGN}curve = "wave.dxf"\n')
    (folder / "thin.toml").write_text(f'{DESIGN}curve = "tall.dxf"\n')
    run("new", "sections", cwd=folder)
    return folder


SUGGESTED = [
    ("strip wide.dxf --sheet birch-plywood-0.8 --max-width 12 -o out", 1, "--max-width 15."),
    ("strip wide.dxf --sheet birch-plywood-0.8 --max-width 4000 -o out", 1, "--max-width"),
    ("strip wide.dxf --sheet birch-plywood-2 --max-width 30 -o out", 1, "--sheet birch-plywood-0.8"),
    ("strip slight.svg --sheet birch-plywood-0.8 --max-width 30 -o out", 2, "--smooth 0.2"),
    ("strip corner.svg --sheet card-200gsm --max-width 12 -o out", 2, "--set curve.split_corners=true"),
    ("check slight.svg", 2, "-o out --smooth 0.2"),
    ("strip slight.svg --sheet birch-plywood-0.8 --max-width 1.2 -o out --units inch", 2, "--smooth 0.2"),
]


def test_a_suggested_command_writes_to_a_new_folder(desk, tmp_path):
    shutil.copy(desk / "slight.svg", tmp_path)
    for name in ("out", "out-2"):
        (tmp_path / name).mkdir()
    (cure,) = json.loads(run("check slight.svg --json", cwd=tmp_path, code=2).stdout)["cures"][:1]
    assert "-o out-3 " in cure["text"]


@pytest.mark.campaign
@pytest.mark.parametrize(("words", "code", "told"), SUGGESTED)
def test_a_suggestion_is_made_as_it_is_printed(words, code, told, desk, monkeypatch):
    monkeypatch.chdir(desk)
    refused = run(words, code=code)
    (command,) = (words for words in suggested_commands(refused.output) if told in words)
    made = run(*shlex.split(command))
    shutil.rmtree(desk / "out", ignore_errors=True)
    assert made.exit_code == 0, made.output
    assert "Warning: strain" not in made.output
    assert "unstable" not in made.output


@pytest.mark.campaign
@pytest.mark.parametrize(("seed", "kind"), [(3, "rail"), (40, "pin"), (42, "tie")])
def test_a_suggested_support_is_made_as_it_is_printed(seed, kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    heights = np.random.default_rng(seed).uniform(-60, 60, 7)
    curve = ec.PlaneCurve.spline(np.column_stack([np.linspace(0, 300, 7), heights]), degree=5)
    write_curves([curve], tmp_path / "wave.json")
    for words in ("strip wave.json --sheet pom-0.5 --max-width 30 -o out", "check wave.json"):
        commands = suggested_commands(run(words, code=1).output)
        (command,) = (command for command in commands if f"--{kind} " in command)
        made = run(*shlex.split(command), "--no-step", "--no-pictures")
        assert re.search(rf"^Between +{kind}", made.output, re.MULTILINE)
        assert "unstable" not in made.output
        shutil.rmtree("out")


def test_what_is_nearest_to_working_is_reported_where_no_change_of_the_request_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_curves([ec.PlaneCurve.arc((0, 0), 60, 0, 3)], tmp_path / "arc.json")
    refused = run("strip", "arc.json", "--sheet", "oak-3", "--max-width", "12", "-o", "out", code=1)
    sheet, scaled, nearest = suggested_commands(refused.output)
    assert shlex.split(sheet).count("--sheet") == 1
    ((scale, length),) = re.findall(
        r"^Change +Draw the curve ([0-9.]+) times as large \(a strip ([0-9]+) mm long",
        refused.output,
        re.MULTILINE,
    )
    run(*shlex.split(sheet), "--no-step", "--no-pictures")
    shutil.rmtree("out")
    made = run(*shlex.split(scaled), "--no-step", "--no-pictures").output
    assert float(re.search(r"^Size +([\d.]+) mm long", made, re.M)[1]) == pytest.approx(
        float(length), rel=0.005
    )
    options = ("--sheet", "oak-3", "--max-width", 12, "--set", "length=150", "-o", "again")
    again = run("strip", "arc.json", *options, code=1)
    assert suggested_commands(again.output)[1].count("length=") == 1
    assert nearest.endswith("--nearest --stable")
    assert "(another shape, up to " in refused.output.splitlines()[-1]
    larger = ec.PlaneCurve.arc((0, 0), 60 * float(scale), 0, 3)
    assert ec.make_strip(larger, "oak-3", max_width=12).strain_verdict.allowed
    assert float(length) == pytest.approx(larger.length, rel=0.005)


@pytest.mark.parametrize(
    "words",
    [
        "strip wide.dxf --sheet birch-plywod-0.8 --max-width 12",
        "strip wide.dxf --sheet birch-plywood-0.8 --max-width 12",  # writes over its own drawing
        "bend corner.svg --to 100 0",
    ],
)
def test_nothing_is_suggested_that_does_not_hold(words, desk, monkeypatch):
    monkeypatch.chdir(desk)
    refused = run(words, code=None)
    assert refused.exit_code in (1, 2)
    assert "\nChange " not in refused.output


def test_ctrl_c_ends_the_search_and_keeps_what_was_found(monkeypatch):
    tried = []

    def held_once(spec, change, *_):
        tried.append(change)
        if len(tried) == 2:
            raise KeyboardInterrupt
        return suggestions.Suggestion(change, (spec,), 1.0, 50, ())

    monkeypatch.setattr(suggestions, "try_change", held_once)
    spec = ec.StripSpec(ec.PlaneCurve.spline(CURVES["wave"], degree=4), "pom-0.5", max_width=20)
    with pytest.raises(ec.NotRealizable) as refused:
        spec.make()
    (cure,) = cures_of(spec, refused.value, lambda suggestion: "`it`")
    assert cure["text"].endswith(" (within 1 mm of the drawn curve, 50 % of the strain limit): `it`.")


def test_a_mistyped_command_is_reported_the_near_one():
    refused = run("chekc", "arch.dxf", code=2)
    assert "Did you mean 'check'?" in refused.output


@pytest.mark.campaign
def test_pieces_between_corners_carry_the_number_of_the_joint(desk, tmp_path):
    words = "strip corner.svg --set curve.split_corners=true --sheet card-200gsm --max-width 12 --json"
    made = run(*words.split(), "-o", tmp_path, cwd=desk)
    first, last = json.loads(made.stdout)["strips"]
    assert (first["joints"], last["joints"]) == (["", "J1"], ["J1", ""])
    assert first["length"] == pytest.approx(last["length"], rel=1e-6)
    run(*words.split(), "--label", "", "--set", "cut.curves=polyline", "-o", tmp_path / "bare", cwd=desk)
    engraved = [(tmp_path / "bare" / f"corner-{k}.dxf").read_text().count("ENGRAVE") for k in (1, 2)]
    assert engraved[0] == engraved[1] > 2  # strokes of J and 1, at the end of one, at the start of the other


@pytest.mark.campaign
def test_all_strips_of_a_design_that_cannot_be_made_are_named(desk, tmp_path):
    design = desk / "several.toml"
    strip = '[[strips]]\nlabel = "K{}"\ncurve = "{}"\n'
    named = [strip.format(2, "wide.dxf"), strip.format(3, "wide.dxf").replace("K3", "good")]
    design.write_text(f'{DESIGN}curve = "wave.dxf"\n' + named[0] + named[1] + "max_width = 40\n")
    refused = run("model", "several.toml", "--no-step", "--no-pictures", "-o", tmp_path, cwd=desk, code=1)
    design.unlink()
    assert refused.exit_code == 1
    assert "K1: " in refused.stderr
    assert "Also: K2: only 2.3" in refused.stderr
    assert "good: " not in refused.stderr
    assert "\nChange " not in refused.stderr  # one change mends not all


def test_stability_of_a_bent_strip_is_a_word(tmp_path):
    made = run("bend", "--straight", "200", "--to", "150", "0", "-o", "out", cwd=tmp_path)
    assert "Stability   stable in its plane" in made.stdout


@pytest.mark.campaign
@pytest.mark.parametrize("out", ["taken", "taken/below"])
def test_a_file_where_files_should_go_is_reported_and_no_command_that_fails_as_well(out, desk, tmp_path):
    """Trials write elsewhere: `--nearest` was told to work, into the same file."""
    taken = tmp_path / "taken"
    taken.write_text("mine")
    words = [
        "strip",
        "wide.dxf",
        "--sheet",
        "birch-plywood-0.8",
        "--max-width",
        "40",
        "-o",
        str(tmp_path / out),
    ]
    refused = run(*words, cwd=desk, code=2)
    assert "choose another folder" in refused.stderr
    assert "\nChange " not in refused.stderr
    assert taken.read_text() == "mine"


def test_an_option_is_no_folder(tmp_path):
    result = run("new", "lamp", "-o", "--json", cwd=tmp_path, code=2)
    assert "'--json' looks like an option: name a folder before it" in result.stderr
    assert not (tmp_path / "--json").exists()


@pytest.mark.parametrize(
    ("width", "told", "code"),
    [
        ("2e7", "is 20000000 mm, above the limit. Use a length of at most 1000000 mm", 2),
        ("9e5", "is larger than the stock of", 1),
    ],
)
def test_an_absurd_width_is_reported_at_once(width, told, code, desk):
    options = ["strip", "wide.dxf", "--sheet", "birch-plywood-0.8", "--max-width", width]
    refused = run(*options, cwd=desk, code=code)
    assert told in refused.stderr


@pytest.mark.parametrize("words", ["", "--smooth 0", "--natural-curvature 0.002"])
def test_a_refused_curve_always_has_a_list_of_cures(words, tmp_path):
    write_curves([ec.PlaneCurve.spline(CURVES["wave"], degree=4)], tmp_path / "wave.dxf")
    (report,) = json.loads(run("check wave.dxf --json", *words.split(), cwd=tmp_path, code=1).stdout)
    assert isinstance(report["cures"], list)
    error = json.loads(
        run("strip wave.dxf --sheet no-such --max-width 9 --json", cwd=tmp_path, code=2).stdout
    )
    assert error["cures"] == []


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ("bow ends.json --max-width 7", "set ignore_limits of `elastica strip`"),  # bow has no such option
        ("bend arc.json --max-width 7 --shorten 1", "set --set ignore_limits"),
        ("strip arc.json --max-width 7", "set --ignore-limits."),
    ],
)
def test_a_message_names_an_option_that_the_command_has(words, named, tmp_path):
    (tmp_path / "arc.json").write_text(ec.formats.curves_json([ec.PlaneCurve.arc((0, 0), 22, 0.0, 2.0)]))
    points = [(0, 0), (4, 8), (8, 16), (20, 24), (32, 16), (36, 8), (40, 0)]  # straight at both ends
    (tmp_path / "ends.json").write_text(ec.formats.curves_json([ec.PlaneCurve.spline(points, degree=4)]))
    refused = run(*words.split(), "--sheet", "birch-plywood-0.8", "-o", "out", cwd=tmp_path, code=1)
    assert named in refused.stderr


@pytest.mark.parametrize("words", ["sheets --units", "strip arch.csv --max-width", "batten --stock 20"])
def test_an_option_without_its_value_is_one_sentence(words, tmp_path):
    refused = run(words, cwd=tmp_path, code=2)
    assert words.split()[-1 if "20" not in words else 1] in refused.stderr


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
    refused = run(*words, "point = [0, 0], normal = [0, 1]", "-o", "out", cwd=tmp_path, code=2)
    assert refused.stderr.startswith(("! Error ", "Usage: "))


def test_no_command_is_reported_where_the_folder_reads_as_an_option(tmp_path):
    """Trials write elsewhere, so one had been told that is refused as well."""
    write_curves([ec.PlaneCurve.spline([(0, 0), (40, 60), (100, 0)], degree=2)], tmp_path / "a.dxf")
    words = ["strip", "a.dxf", "--sheet", "birch-plywood-0.8", "--max-width", "12", "-o", "-o"]
    refused = run(*words, cwd=tmp_path, code=2)
    assert refused.stderr.endswith("name a folder before it, or write ./-o.\n")


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
def test_limits_that_two_strips_miss_are_named_with_those_to_relax(tmp_path):
    (tmp_path / "pair.toml").write_text(FLATTER_THAN_THEY_CAN_BE)
    refused = run("model", "pair.toml", "-o", "out", cwd=tmp_path, code=1)
    assert refused.stderr.startswith("! Error     Not within these limits: A: ")
    assert re.search(r"by \d+(\.\d+)? mm: end position\. .*Relax .*the curvature limit", refused.stderr)
    assert "Also: B: " in refused.stderr


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("check", "Missing argument 'CURVE': name a file with the curve, such as arch.dxf, or"),
        ("model", "Missing argument 'DESIGN': name a design file; `elastica new pavilion` writes an example"),
        ("sections", "Missing argument 'MESH': name the file of a mesh (OBJ, STL, PLY) or of a STEP body."),
        ("strip arch.dxf", "Missing option '--sheet': give --sheet NAME. Material: the name of a sheet"),
        ("batten --sheet pom-1", "Missing option '--length': give --length MM. Length of the batten."),
    ],
)  # fmt: skip
def test_what_is_missing_is_listed_with_what_to_give(tmp_path, words, told):
    refused = run(words, cwd=tmp_path, code=2)
    assert f"! Error     {told}" in refused.stderr


@pytest.mark.parametrize(
    ("words", "advice"),
    [
        (
            "check arch.csv --kerf 0.2",
            "no option --kerf; `elastica strip` has --kerf. `elastica check --help` lists all options.\n",
        ),
        ("strip arch.csv --max-widht 1", "Did you mean --max-width?"),
        (
            "strip arch.csv --scale 2",
            "use --set length=VALUE instead of --scale: `elastica help length` explains it.\n",
        ),
        ("check arch.csv --scale 2", "no option --scale; `elastica strip` has --set length."),
        ("strip arch.csv --width 40", "use --max-width instead of --width:"),
        ("bend arch.csv --kerf 0.2", "no option --kerf; `elastica strip` has --kerf."),
        ("bend arch.csv --to 380", "--to needs 2 values, X Y. New position of the end, in mm of the drawing"),
        ("pair arch.csv arch.csv birch-plywood-0.8", "Write --sheet birch-plywood-0.8.\n"),
        ("pair arch.csv arch.csv pom-1 --sheet pom-2", "'pom-1' is an extra argument. Leave it out"),
        ("coupon oak-3 --sheet oak-2", "'oak-3' is an extra argument. Leave it out"),
        ("check my arch.csv", "Leave it out, or put quotes around a name with spaces.\n"),
        ("help rails", "did you mean rail?"),
        ("help screws", "did you mean revolution.holes.screws, base.holes.screws, or rings.holes.screws?"),
        (
            "pair arch.csv --sheet pom-1 --max-width 20",
            "no option --max-width; `elastica strip` has --max-width. `elastica pair --help` lists all options.\n",
        ),
        (
            "strip arch.csv --clearance 1",
            "key of design files: interlock.clearance, base.clearance, rings.clearance, frame.clearance, or "
            "fixtures.clearance. `elastica help interlock.clearance` explains it.\n",
        ),
        (
            "bend arch.csv --creep 1",
            "no option --creep, which is a key of design files: creep, strips.creep, or",
        ),
        (
            "bend --straight 9 --to 8 0 --sheet pom-1 --set creep=1",
            "--set has no effect beside --straight. Leave out one of these options.\n",
        ),
        *(
            (f"model design.toml --{option} 1", f"use --set {key}=VALUE instead of --{option}: ")
            for option, key in {
                **{
                    option_name(name)[2:]: path
                    for path, name in OPTIONS.items()
                    if path not in ("label", "ignore_limits")
                },
                "start": "supports",
                "end": "supports",
                "keep-strain": "limits.strain",
                "stable": "limits.margin",
                "rail": "between",
                "pin": "between",
                "tie": "between",
                "point-mass": "loads",
                "scale": "length",
            }.items()
        ),
        ("model design.toml --label A", "use strips.label in the design file instead of --label: "),
        ("model design.toml --curve 2", "use strips.curve in the design file instead of --curve: "),
        (
            "model design.toml --gap 2",
            "--set base.gap=VALUE, --set rings.gap=VALUE, or --set frame.gap=VALUE ",
        ),
        ("sheets birch", "use one of birch-plywood-0.6, birch-plywood-0.8, "),
    ],
)
def test_a_wrong_word_is_a_row_with_one_instruction(tmp_path, words, advice):
    refused = run(words, cwd=tmp_path, code=2)
    assert refused.stderr.startswith("! Error ")
    assert advice in refused.stderr
    assert refused.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("setting", "hint"),
    [
        ("kerf=2", "did you mean cut.kerf?"),
        ("start=pinned", "did you mean supports?"),
        ("gap=2", "`elastica help` lists them"),
        ("ends.lenght=2", "did you mean ends.length?"),
    ],
)
def test_an_unknown_key_is_not_replaced_by_likeness_alone(setting, hint):
    with pytest.raises(ec.InputError, match=re.escape(hint)):
        parsed_settings([setting], CommandKeys)


def test_an_option_is_explained_like_a_key(tmp_path):
    assert "elastica strip: --rail AT" in run("help rail").output


@pytest.mark.parametrize(
    ("words", "options"),
    [
        ("--set smooth=-1", "--smooth is -1.0: give"),
        ("--nearest --set samples=99", "Leave out --nearest, or --set samples"),
        (
            "--set loads=[{at=20,mass=5}]",
            "A point mass needs gravity in the plane of the curve. Set --gravity.\n",
        ),
        (
            "--nearest --set limits.width=[10,15] --max-width 20",
            "outside the limits of the width, 10 to 15 mm: change this width or the limits, or leave out "
            "the limits (--set limits.width)",
        ),
    ],
)
def test_the_options_that_set_a_refused_field_are_named(words, options, tmp_path):
    (tmp_path / "arch.csv").write_text("0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n")
    arguments = [
        "strip",
        str(tmp_path / "arch.csv"),
        "--sheet",
        "pom-0.5",
        "--max-width",
        "20",
        *words.split(),
    ]
    refused = run(*arguments, "-o", tmp_path / "out", code=2)
    assert options in refused.output


@pytest.mark.parametrize(
    ("count", "words"),
    [(200, "check points.csv"), (40, "strip points.csv --sheet pom-1 --max-width 30 -o out")],
)
def test_points_that_waver_are_smoothed_first(count, words, tmp_path, monkeypatch):
    """So few that a curve goes through all of them, and so many that none does."""
    monkeypatch.chdir(tmp_path)
    x = np.linspace(0.0, 400.0, count)
    points = np.column_stack([x, 0.001 * x * (400 - x)])
    points += 0.5 * np.random.default_rng(1).normal(size=points.shape)
    np.savetxt("points.csv", points, delimiter=",", fmt="%.2f")
    refused = run(words, code=None)
    assert refused.exit_code in (1, 2)
    command, *_ = suggested_commands(refused.output)
    assert "smooth" in command
    made = run(*shlex.split(command), "--no-step", "--no-pictures", "--json")
    assert json.loads(made.stdout)["strips"][0]["ratio"] < 2


@pytest.mark.parametrize(("smooth", "code", "length"), [(0, 1, 3346), (4, 1, 3344), (12, 0, 3343)])
def test_a_mistyped_offset_is_named_once(smooth, code, length, tmp_path, monkeypatch):
    """2-0-1 for 1-11-1 at 7-0-0, first of all; smoothed or not, the curve is no longer for it."""
    inches = "0-1-0,0-7-5,1-1-1,1-5-4,1-8-5,1-10-5,1-11-3+,2-0-1,1-9-5,1-7-2,1-3-6,1-1-5"
    stations = [*(f"{foot}-0-0" for foot in range(11)), "10-6-0"]
    rows = [f"{x},{y}" for x, y in zip(stations, inches.split(","), strict=True)]
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.csv").write_text("\n".join(["Station,Half-breadth", *rows]))
    result = run("check", "bad.csv", "--smooth", smooth, code=None)
    assert (result.exit_code, result.output.count("(2134, 612.8) mm, number 8 of 12, is 27 mm from")) == (
        code,
        1,
    )
    assert f"this curve of {length} mm" in result.output
    words = f"strip bad.csv --sheet pom-1 --max-width 60 --smooth {smooth} --ignore-limits --no-step --no-pictures"
    made = run(*words.split(), "-o", "out", code=code)
    for one in (result, made):
        text = one.stderr if one is made else one.stdout
        assert re.match(
            r"(Read  .*\n|bad\.csv: the .*\n)?(! )?(Error +Not realizable:|Verdict|Warning) +The point at \(2134",
            text,
        ), text
        assert "\nChange " not in one.output
    assert made.output.count("number 8 of 12") == 1


@pytest.mark.parametrize(("noise", "first", "smoothed"), [
    (0.4, "The points are too few", "No strip can take this curve as drawn, but a strip can"),
    (0.0, "A flat strip can take this curve", ""),
    (8.0, "No strip can take this curve, even if", "No strip can take this curve, even if it is smoothed within"),
])  # fmt: skip
def test_a_check_says_first_whether_points_are_fair_but_for_their_noise(noise, first, smoothed, tmp_path):
    x = np.linspace(0.0, 400.0, 30)
    y = (0.001 if noise < 5 else 0.0) * x * (400 - x) + noise * np.random.default_rng(3).normal(size=30)
    np.savetxt(
        tmp_path / "sheer.csv", np.column_stack([x, y, y]), delimiter=",", header="Station,A,B", comments=""
    )
    result = run("check", tmp_path / "sheer.csv", "--json", code=None)
    answers = json.loads(result.stdout)
    assert all(one["advice"].startswith(first) for one in answers), result.stdout
    assert all(not noise or any(text.startswith(smoothed) for text in one["notes"]) for one in answers)


def test_a_check_of_points_of_very_many_pieces_smooths_nothing(tmp_path, monkeypatch):
    x = np.linspace(0.0, 400.0, 30)
    y = 8 * np.random.default_rng(3).normal(size=30)
    np.savetxt(tmp_path / "rough.csv", np.column_stack([x, y]), delimiter=",")
    assert "even if it is smoothed within" in run("check rough.csv", cwd=tmp_path, code=1).output
    monkeypatch.setattr(trials, "MOST_PIECES", 2)
    checked = run("check rough.csv", cwd=tmp_path, code=1).output
    assert "even if it is smoothed" not in checked
    assert re.search(r"^Change +Not tried, because the curve has", checked, re.M)


def test_widths_made_of_noise_are_warned_of(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    x = np.linspace(0.0, 400.0, 40)
    result = []
    for name, noise in (("even", 0.0), ("wavy", 0.02)):
        y = 0.001 * x * (400 - x) + noise * np.random.default_rng(3).normal(size=40)
        np.savetxt(f"{name}.csv", np.column_stack([x, y]), delimiter=",", fmt="%.3f")
        made = run(
            "strip",
            f"{name}.csv",
            "--sheet",
            "pom-1",
            "--max-width",
            "30",
            "--no-step",
            "--no-pictures",
            "--json",
            "-o",
            "out",
        )
        result.append(len(json.loads(made.stdout)["strips"][0]["warnings"]))
    assert result == [0, 2]


def test_the_command_that_enlarges_a_curve_keeps_the_strain_within_the_limit(tmp_path, monkeypatch):
    """The key `length` counts the straight ends, which become tabs."""
    (tmp_path / "u.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">'
        '<path id="u" d="M 100,20 L 100,150 C 100,175 112,180 118,180 C 124,180 136,175 136,150 L 136,20"/></svg>'
    )
    checked = run("check u.svg", cwd=tmp_path).stdout
    command = re.search(r"Change +Enlarge the curve for petg-0.5: `\S*elastica (strip .*?)`", checked)[1]
    assert " --set length=420.3" in command
    made = run(f"{command} --no-pictures", cwd=tmp_path)
    assert "Strain      1.54 %" in made.stdout
    assert "! Strain" not in made.output
    monkeypatch.setattr(trials, "MOST_PIECES", 0)
    assert re.search(r"^Change +Not tried, because", run("check u.svg", cwd=tmp_path).stdout, re.M)


@pytest.mark.parametrize(
    "words",
    [
        "check wave.dxf",
        pytest.param("strip wave.dxf --sheet card-200gsm --max-width 20 -o out", marks=pytest.mark.campaign),
    ],
)
@pytest.mark.parametrize("found", [False, True])
def test_a_search_without_a_result_says_so(words, found, tmp_path, monkeypatch):
    write_curves([ec.PlaneCurve.spline(CURVES["wave"], degree=4)], tmp_path / "wave.dxf")
    first = suggestions.suggest

    def found_changes(*options):
        yield from (change for change in list(first(*options))[:1] if found)

    monkeypatch.setattr(suggestions, "suggest", found_changes)
    result = run(words, cwd=tmp_path, code=1)
    assert ("No change that was tried makes the strip possible" in result.stderr) != found
    assert ("Change" in result.output) == found


def test_a_search_without_a_result_names_the_sheet_and_width_that_it_assumed(tmp_path, monkeypatch):
    """The search uses the sheet and the width that are typed, as `elastica strip` does."""
    write_curves([ec.PlaneCurve.spline(CURVES["wave"], degree=4)], tmp_path / "wave.dxf")
    tried = []

    def no_change(spec, *_):
        tried.append((spec.material.name, spec.max_width))
        return ()

    monkeypatch.setattr(suggestions, "suggest", no_change)
    text = run("check wave.dxf", cwd=tmp_path, code=1).stderr
    sheet, width = re.search(r"possible, with --sheet (\S+) --max-width (\S+) assumed\.", text).groups()
    text = run("check wave.dxf --max-width 17", cwd=tmp_path, code=1).stderr
    assert f"possible, with --sheet {sheet} assumed." in text
    text = run("check wave.dxf --sheet pom-1 --max-width 17", cwd=tmp_path, code=1).stderr
    assert "makes the strip possible.\n" in text
    run("strip wave.dxf --sheet pom-1 --max-width 17 -o out", cwd=tmp_path, code=1)
    assert tried == [(sheet, float(width)), (sheet, 17), ("pom-1", 17), ("pom-1", 17)]


def test_a_check_with_a_sheet_answers_for_this_sheet(tmp_path):
    (tmp_path / "arc.csv").write_text("0,0\n60,45\n130,60\n200,45\n260,0\n")
    (own,) = json.loads(run("check arc.csv --sheet pom-2 --json", cwd=tmp_path).stdout)
    assert [sheet["name"] for sheet in own["sheets"]] == ["pom-2"]
    assert "Add --sheet" in run("check arc.csv --thickness 2", cwd=tmp_path, code=2).stderr


def test_sizes_files_and_kerf_are_checked_before_the_strip_is_made(tmp_path, monkeypatch):
    """No rod is computed for a strip that is larger than its stock or would not be written."""
    monkeypatch.setattr("elastica_cad.cli.strip_command.solve_rod", None)
    (tmp_path / "arc.csv").write_text("0,0\n900,500\n2000,700\n3100,500\n4000,0\n")
    words = "strip arc.csv --sheet pom-1 --max-width 200 --nearest"
    text = run(f"{words} -o out", cwd=tmp_path, code=1).stderr
    assert re.search(r"arc: 4\d{3} x 200 mm is larger than the stock of 3050 x 1525 mm", text)
    wide = run(f"{words} --set length=900 --set shop.stock=[1000,150] -o out", cwd=tmp_path, code=1).stderr
    assert re.search(r"\d x 200 mm is larger than the stock of 1000 x 150 mm", wide)
    (tmp_path / "arc.json").write_text("{}")
    assert "arc.json exists" in run(f"{words} --set length=900", cwd=tmp_path, code=2).stderr
    text = run(
        "strip arc.csv --sheet oak-2 --max-width 20 --set length=900 --kerf sheet -o out",
        cwd=tmp_path,
        code=2,
    ).stderr
    assert "The width of the cut is not known for oak-2" in text
