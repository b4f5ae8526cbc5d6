"""`elastica coupon` as a user meets it: a strip to measure, a sheet from what was measured."""

import shlex

import pytest

import elastica_cad as ec
from tests.command_line import run


def test_a_coupon_is_written(tmp_path, check_drawing_file):
    run("coupon", "--sheet", "card-200gsm", "--overhang", 120, "-o", tmp_path)
    curves = check_drawing_file(tmp_path / "coupon-card-200gsm.dxf")
    (outline,) = [curve for curve in curves if curve.layer == "CUT_OUTER"]
    assert outline.area == pytest.approx(160 * 20)
    assert "exists already" in run("coupon", "--sheet", "card-200gsm", "-o", tmp_path, code=2).stderr


def test_the_sheet_of_a_coupon_is_named_as_for_elastica_sheets(tmp_path):
    named, bare = (run("coupon", *words, "-o", tmp_path, "--force").output for words in (
        ("--sheet", "card-200gsm"), ("card-200gsm",),
    ))  # fmt: skip
    assert bare == named
    assert "coupon --sheet card-200gsm --measured" in bare


def test_a_measured_coupon_becomes_a_sheet(tmp_path):
    droop = float(ec.mechanics.cantilever_droop(150.0, 96.05))
    result = run(
        "coupon --sheet card-200gsm --measured 150",
        droop,
        "--measured",
        120,
        ec.mechanics.cantilever_droop(120.0, 96.05),
        "--thickness",
        0.22,
        "--density",
        900,
        "--least-radius",
        22,
        "--name",
        "mine",
        "-o",
        tmp_path,
    )
    sheet = ec.load_sheets(tmp_path / "mine.toml")["mine"]
    assert sheet.elasto_gravity_length == pytest.approx(96.05, abs=1e-4)
    assert sheet.least_radius == pytest.approx(22)
    assert (sheet.thickness, sheet.density, sheet.grain) == (0.22, 900, "along")
    assert "elasto-gravity length 96.1 +- 0.475 mm" in result.output
    assert "Listed      elasto-gravity length " in result.output
    assert "a guess" not in result.output


@pytest.mark.parametrize(
    ("thickness", "density", "overhang", "droop", "modulus"),
    [
        (1.1, 120, 60, 30, "0.498 +- 0.0229 MPa"),
        (5, 30, 20, 10, "0.000223 +- 0.0000308 MPa"),
        (3, 7850, 900, 30, "280000 +- 4720 MPa"),
    ],
)
def test_soft_and_stiff_sheets_are_printed_with_three_digits(
    tmp_path, thickness, density, overhang, droop, modulus
):
    sizes = ("--thickness", thickness, "--density", density, "--measured", overhang, droop)
    assert f"Young's modulus {modulus}\n" in run("coupon", *sizes, "-o", tmp_path).output


def test_what_nobody_measured_is_reported(tmp_path):
    words = ("coupon", "--thickness", 1.1, "--density", 720, "--name", "felt", "--measured", 150, 41)
    guessed = run(*words, "-o", tmp_path / "guessed").output
    assert "The largest strain, 0.4 %, is a guess" in guessed
    assert "Listed" not in guessed
    bent = run(*words, "--least-radius", 60, "--kind", "wood", "--measured", 60, 2, "-o", tmp_path / "bent")
    assert "a guess" not in bent.output
    assert "A droop of 2 mm is too small for an accurate stiffness" in bent.stderr
    assert ec.Sheet.named(str(tmp_path / "bent" / "felt.toml")).kind == "wood"
    (written,) = ec.load_sheets(tmp_path / "guessed" / "felt.toml").values()
    assert len(f"{written.youngs_modulus!r}") <= 7  # as many digits as readings can tell


@pytest.mark.parametrize("grain", ["along", "across"])
def test_a_strain_of_the_other_grain_is_reported(tmp_path, grain):
    """Plywood across its face grain bears two thirds more: a strip along it would break at that."""
    words = ("coupon", "--sheet", "finnish-birch-plywood-across-3.6", "--measured", 300, 20, "--grain", grain)
    result = run(*words, "-o", tmp_path / "own")
    other = "The largest strain, 0.82 %, is from finnish-birch-plywood-across-3.6, which is bent across"
    assert (other in result.stderr) == (grain == "along")
    assert not run(*words, "--least-radius", 300, "-o", tmp_path / "bent").stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--sheet", "paper"), "unknown sheet 'paper'"),
        (("paper",), "unknown sheet 'paper'"),
        (("--sheet", "card-200gsm", "--name", "my", "card"), "'card' is an extra argument. Leave it out"),
        (("--sheet", "card-200gsm", "--kerf", 0.1), "--kerf has no effect without --measured"),
        (("--sheet", "card-200gsm", "--grain", "none"), "--grain has no effect without --measured"),
        (
            ("--sheet", "card-200gsm", "--measured", 160, 74, "--width", 30),
            "--width has no effect beside",
        ),
        ((), "set --thickness MM and --density KG/M3"),
        (("--sheet", "card-200gsm", "--measured", 100, 120), "cannot droop by 120 mm"),
        (("--sheet", "card-200gsm", "--measured", 160, 74, "--density", 0), "density is 0"),
        (("--sheet", "card-200gsm", "--measured", 160, 74, "--thickness", 0), "thickness is 0"),
        (("--sheet", "card-200gsm", "--width", 2), "too narrow"),
    ],
)
def test_coupons_refuse_in_words(arguments, message):
    result = run("coupon", *arguments, code=2)
    assert message in result.stderr


def test_what_is_typed_next_keeps_what_was_measured(tmp_path, monkeypatch):
    """E goes with the square of the thickness: a caliper's 0.95 mm that was left out made it 41 % too large."""
    monkeypatch.chdir(tmp_path)
    begun = run("coupon", "--sheet", "birch-plywood-0.8", "--thickness", 0.95, "--density", 610)
    (typed,) = (line for line in begun.output.splitlines() if "--measured" in line)
    droop = float(ec.mechanics.cantilever_droop(400.0, 420.0))
    run(*typed.replace("DROOP", f"{droop:.4f}").removeprefix("Then run").split()[1:])
    sheet = ec.Sheet.named("my-birch-plywood-0.8.toml")
    assert (sheet.thickness, sheet.density) == (0.95, 610)
    assert sheet.youngs_modulus == pytest.approx(12 * 610e-9 * 9.80665 * 420.0**3 / 0.95**2, rel=1e-3)
    listed = ec.Sheet.named("birch-plywood-0.8").with_thickness(0.95)  # thicker plywood bears less strain
    assert sheet.max_strain == listed.max_strain < ec.Sheet.named("birch-plywood-0.8").max_strain


def test_a_name_with_spaces_is_reported_as_it_is_typed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made = run("coupon --sheet birch-plywood-0.8 --measured 300 38 --name", "my/ply", "-o", "o m")
    (result,) = (
        line
        for line in made.output.splitlines()
        if line.startswith("Next        use the sheet in any command: ")
    )
    words = shlex.split(result.removeprefix("Next        use the sheet in any command: "))
    assert words == ["--sheet", "o m/my-ply.toml"]
    run("sheets", words[1])


@pytest.mark.campaign
def test_from_an_unknown_board_to_a_sheet_that_every_command_takes(tmp_path, monkeypatch):
    """No list has it: a coupon, a reading, a file; then all commands take it, and by name from the library."""
    library = tmp_path / "library"
    monkeypatch.setenv("ELASTICA_SHEETS", str(library))
    monkeypatch.chdir(tmp_path)
    begun = run("coupon", "--thickness", 1.1, "--density", 720, "--name", "felt", "--overhang", 200)
    assert (tmp_path / "coupon-felt.dxf").exists()
    next_words = "elastica coupon --thickness 1.1 --density 720 --name felt --measured 200 DROOP"
    assert next_words in begun.output
    droop = float(ec.mechanics.cantilever_droop(200.0, 210.0))
    words = [*next_words.split()[1:-1], droop, "--grain", "across", "--kerf", 0.2, "--least-radius", 60]
    library.mkdir()
    for kept, name in ((), "felt.toml"), (("--keep",), "felt"):
        made = run(*words, *kept)
        assert f"Next        use the sheet in any command: --sheet {name}\n" in made.output
        message = run("sheets", name).output
        assert "0.2 mm" in message
        assert "across" in message
    sheet = ec.Sheet.named("felt.toml")
    assert sheet == ec.Sheet.named("felt")
    assert (sheet.grain, sheet.kerf) == ("across", 0.2)
    assert "felt " in run("sheets").output
    ec.write_curves([ec.PlaneCurve.spline([(0, 0), (60, 120), (200, 150), (300, 0)], degree=3)], "arch.dxf")
    run("new", "sections")
    design = (tmp_path / "sections.toml").read_text().replace("card-200gsm", "felt.toml")
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "felt.toml").write_text((tmp_path / "felt.toml").read_text())
    (tmp_path / "deep" / "bowl.obj").write_bytes((tmp_path / "bowl.obj").read_bytes())
    (tmp_path / "deep" / "sections.toml").write_text(
        design.replace("max_width", "thickness = 0.9\nmax_width")
    )
    for command in (
        "strip arch.dxf --max-width 30 --sheet felt.toml -o a",
        "strip arch.dxf --max-width 30 --sheet felt --thickness 0.9 --kerf sheet -o b",
        "bend arch.dxf --max-width 30 --sheet felt --thickness 0.9 --to 280 0 -o c",
        "sections bowl.obj --unit mm --radial 3 --sheet felt.toml --thickness 0.9 -o d",
        "model deep/sections.toml --no-step --no-pictures --no-parts -o e",
        "coupon --sheet felt -o f",
    ):
        run(*command.split())
    assert 'sheet = "../felt.toml"' in (tmp_path / "d" / "bowl-sections.toml").read_text()
    run("model", "d/bowl-sections.toml", "--no-step", "--no-pictures", "-o", "g")
    cut = (tmp_path / "e" / "sections-cut-list.csv").read_text()
    assert ",felt-0.9,0.9," in cut


def test_a_density_in_g_per_cm3_is_refused_before_a_sheet_is_written(tmp_path):
    result = run("coupon --thickness 1.1 --density 0.7 --measured 150 40 -o", tmp_path, code=2)
    assert result.exit_code
    assert "--density: density_kg_m3 = 0.7 looks like the wrong unit" in result.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("droops", "contradict"), [((11.6, 25), True), ((24, 25), False)])
def test_readings_that_contradict_each_other_are_reported(tmp_path, droops, contradict):
    readings = [word for droop in droops for word in ("--measured", 150, droop)]
    result = run("coupon", "--sheet", "card-200gsm", *readings, "-o", tmp_path)
    assert ("contradict each other: a droop of 25 mm over 150 mm" in result.stderr) == contradict


def test_a_sheet_is_not_kept_where_there_is_no_place_for_settings(monkeypatch, tmp_path):
    monkeypatch.setattr("elastica_cad.cli.coupon_command.library_folders", tuple)
    words = ("coupon", "--thickness", 1, "--density", 700, "--measured", 160, 74, "--keep")
    assert "--keep needs a folder for settings, but there is no home folder" in run(*words, code=2).stderr
    (tmp_path / "file").write_text("")  # a folder that cannot be made
    monkeypatch.setattr(
        "elastica_cad.cli.coupon_command.library_folders", lambda: (tmp_path / "file" / "sheets",)
    )
    assert "a folder is needed there: choose another folder" in run(*words, code=2).stderr
