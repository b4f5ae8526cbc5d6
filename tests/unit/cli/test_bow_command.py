"""`elastica bow` as a kite maker meets it: its rows, table and files, and what it refuses."""

import csv
import json
import re

import ezdxf
import numpy as np
import pytest
from scipy.special import ellipk

from elastica_cad import PlaneCurve, Sheet, read_curves, write_curves
from tests.command_line import run

ARCH = [(0, 0), (60, 300), (400, 420), (740, 300), (800, 0)]
STRIP = ("--sheet", "pom-2", "--max-width", "30")


@pytest.fixture
def arch(tmp_path):
    write_curves(PlaneCurve.spline(ARCH, degree=3), tmp_path / "arch.json")
    return tmp_path


def record(folder, *words):
    done = run("bow", "arch.json", *words, "-o", "out", "--force", "--json", cwd=folder)
    return json.loads(done.stdout)["bow"]


def test_an_even_rod_prints_what_a_shorter_cord_does(arch):
    done = run("bow", "arch.json", "--rod", 8, "--sheet", "pom-2", "-o", "out", cwd=arch)
    report = json.loads((arch / "out" / "arch-bow.json").read_text())
    assert f"{report['length_mm']:.1f} mm long, 8 mm in diameter" in done.output
    assert (
        f"at most {report['deviation_mm']:.3g} mm from the drawn curve; a rod of constant section cannot"
        in done.output
    )
    assert f"Cord        800.0 mm long, pulls with {report['pull_N']:.3g} N; rise" in done.output
    rows = list(csv.DictReader((arch / "out" / "arch-bow.csv").read_text().splitlines()))
    assert [float(row["shorter_percent"]) for row in rows] == [0, 2, 5, 10, 20]
    assert [float(row["cord_mm"]) for row in rows] == pytest.approx([800, 784, 760, 720, 640])
    for name, rises in (("pull_N", True), ("rise_mm", True), ("strain_percent", True), ("safety", False)):
        steps = np.diff([float(row[name]) for row in rows])
        assert (steps > 0).all() if rises else (steps < 0).all()
    assert sorted(path.suffix for path in (arch / "out").iterdir()) == [".csv", ".json", ".png"]


def test_pull_is_known_for_each_gpa_without_a_sheet(arch):
    bare, pom = record(arch, "--rod", 8), record(arch, "--rod", 8, "--sheet", "pom-2")
    assert bare["pull_N"] is None
    assert pom["pull_N"] == pytest.approx(2.75 * bare["pull_N_per_GPa"], rel=1e-6)
    m = np.sin(bare["end_angles"][0] / 2) ** 2
    stiffness = 1000 * np.pi * 8**4 / 64
    assert bare["pull_N_per_GPa"] == pytest.approx(
        stiffness * (2 * ellipk(m) / bare["length_mm"]) ** 2, rel=2e-6
    )
    done = run("bow", "arch.json", "--rod", "5/16in", "-o", "o", cwd=arch)
    assert "N per GPa of Young's modulus" in done.output
    assert "N as a pultruded glass rod, " in done.output
    assert "; a pultruded carbon rod allows 0.51 %" in done.output


def test_a_cord_is_shortened_by_a_percentage_or_a_length(arch):
    shorter = ("--shorter", 7.5, "--shorter", "50mm", "--shorter", "5cm", "--shorter", "5%")
    table = record(arch, "--rod", 8, *shorter)["shorter"]
    assert table["cord_mm"] == pytest.approx([800, 760, 750, 740])
    assert table["shorter_percent"] == pytest.approx([0, 5, 6.25, 7.5])


@pytest.mark.parametrize("load", [("--point-mass", 400, "50g"), ("--point-force", "400,420", 0.1, -0.4)])
def test_a_loaded_bow_is_the_even_rod_between_hinges_at_the_distance_of_its_cord(arch, load):
    """Its cord pulls with the force along it at the end; the weight acts too."""
    words = ("--rod", 8, "--sheet", "pom-2", *load)
    loaded = record(arch, *words)["loaded"]
    done = run("bend", "arch.json", *words, "-o", "out", "--force", "--json", cwd=arch)
    bent = json.loads(done.stdout)
    travel = bent["travel"]
    assert loaded["pull_N"] == pytest.approx(-travel["end_force_x_N"][0], rel=1e-6)
    assert loaded["moved_mm"] == pytest.approx(travel["displacement_mm"][0], rel=1e-6)
    assert loaded["safety"] == pytest.approx(travel["safety"][0], rel=1e-6)
    weight = Sheet.named("pom-2").specific_weight * np.pi * 4**2 * bent["length"]
    load_y = 0.4 if "--point-force" in load else 0.05 * 9.80665
    assert travel["start_force_y_N"][0] + travel["end_force_y_N"][0] == pytest.approx(load_y + weight)


def test_loads_of_a_bow_are_printed_and_a_slack_cord_is_a_warning(arch):
    words = ("bow", "arch.json", "--rod", 8, "--sheet", "pom-2", "-o", "out", "--force")
    done = run(*words, "--point-mass", 400, 50, cwd=arch)
    assert "50 g at 400 mm (0.49 N); the weight of the strip" in done.stdout
    assert "Cord        under the loads, pulls with" in done.stdout
    done = run(*words, "--point-force", 600, 0, 40, cwd=arch)
    assert "slack under the loads" in done.stderr
    done = run("bow", "arch.json", "--rod", 8, "--point-mass", 400, 50, cwd=arch, code=2)
    assert "--point-mass has no effect without --sheet" in done.stderr


@pytest.mark.parametrize("stock", [("--rod", "5:9", "--sheet", "pom-2"), STRIP])
def test_a_taper_is_refused_with_the_command_that_works(arch, stock, check_drawing_file):
    done = run("bow", "arch.json", *stock, "-o", "out", cwd=arch, code=1)
    assert "free to turn, so the curvature there must be 0" in done.stderr
    assert "--nearest`." in done.stderr
    near = record(arch, *stock, "--nearest")
    assert near["ratio"] > 1.5
    assert 0 < near["deviation_mm"] < 15
    assert near["margin"] > 5
    (outline,) = [
        item for item in check_drawing_file(arch / "out" / "arch-bow.dxf") if item.layer == "CUT_OUTER"
    ]
    assert outline.area > near["length_mm"] * 4


def test_a_bow_with_bent_ends_is_not_advised_to_be_smoothed(tmp_path):
    """Smoothing the points leaves the ends bent, so only the nearest curve is proposed."""
    points = [(0, 0), (80, 95), (200, 180), (360, 225), (520, 222), (680, 170), (790, 90), (860, 0)]
    (tmp_path / "bow.csv").write_text("\n".join(f"{x},{y}" for x, y in points))
    words = ("bow", "bow.csv", "--sheet", "birch-plywood-1.5", "--max-width", "40")
    for more in ((), ("--smooth", "0.53")):
        done = run(*words, *more, "-o", "out", cwd=tmp_path, code=1)
        assert "is free to turn, so the curvature there must be 0" in done.stderr
        assert "set --smooth" not in done.stderr
        assert "--nearest`." in done.stderr
        assert ("noise of about 0.3 mm. The start" in done.stderr) == (not more)


@pytest.mark.parametrize("more", [("--nearest",), ("--min-width", "30")])
def test_the_holes_for_the_cord_are_at_the_ends_of_the_computed_cord(arch, more):
    """The pattern has two holes, with the material that the sheet needs beside them."""
    done = run("bow", "arch.json", *STRIP, "--hole", 4, *more, "-o", "out", cwd=arch)
    length = json.loads((arch / "out" / "arch-bow.json").read_text())["length_mm"]
    drawn = ezdxf.readfile(arch / "out" / "arch-bow.dxf").modelspace()
    first, last = sorted((e.dxf for e in drawn.query("CIRCLE")), key=lambda circle: circle.center.x)
    assert [first.layer, last.layer] == ["CUT_INNER"] * 2
    assert [first.radius, last.radius] == pytest.approx([2, 2])
    assert [*first.center, *last.center] == pytest.approx([0, 0, 0, length, 0, 0], abs=1e-6)
    assert f"holes of 4 mm at 10 and {length + 10:.4g} mm; measured along the flat strip" in done.output
    least = re.search(r"([\d.]+) (?:to [\d.]+ )?mm wide", done.output)
    assert float(least[1]) >= 8


def test_a_large_hole_for_the_cord_gets_tabs_long_enough_for_it(arch):
    done = run("bow", "arch.json", *STRIP, "--hole", 22, "--min-width", 30, "-o", "out", cwd=arch)
    tab = re.search(r"holes of 22 mm at (\S+) and", done.output)
    assert float(tab[1]) - 11 >= 2


def test_a_hole_too_large_for_the_strip_is_refused(arch):
    narrow = ("--sheet", "pom-2", "--max-width", 7, "--min-width", 7, "--hole", 4)
    done = run("bow", "arch.json", *narrow, "-o", "out", cwd=arch, code=1)
    assert "The hole for the cord is too large: only 1." in done.stderr
    assert "pom-2 needs at least 2 mm. Make the hole smaller, or the strip wider." in done.stderr
    assert not (arch / "out").exists()


def test_a_strip_of_constant_width_is_an_even_bow(arch):
    even = record(arch, *STRIP, "--min-width", 30)
    assert even["ratio"] < 1.01
    assert even["shorter"]["pull_N"][0] == pytest.approx(even["pull_N"], rel=1e-6)


def test_a_bow_far_from_the_drawn_curve_is_a_warning(tmp_path):
    wave = PlaneCurve.spline([(0, 0), (50, 80), (100, 0), (150, -80), (200, 0)], degree=3)
    write_curves(wave, tmp_path / "wave.json")
    done = run("bow", "wave.json", "--rod", "1/4in", "-o", "out", cwd=tmp_path)
    assert (
        "! Curve     the bent rod is at most 87.6 mm from the drawn curve; a rod of constant section cannot "
        "follow it exactly. "
        "Draw a curve that is more like an arch." in done.stderr
    )
    assert "6.35 mm in diameter" in done.output


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((), "The section of the bow is missing. Add --rod DIAMETER, or --max-width MM for a strip."),
        (("--rod", 8, *STRIP), "The section of the bow is missing."),
        (
            ("--max-width", 30),
            "--max-width has no effect without --sheet. Add --sheet, or leave out --max-width.",
        ),
        (
            ("--rod", 8, "--min-width", 3),
            "--min-width has no effect without --max-width.",
        ),
        (("--rod", 8, "--hole", 3), "--hole has no effect without --max-width."),
        (("--rod", 8, "--thickness", 2), "--thickness has no effect without --sheet."),
        (
            ("--sheet", "glass-rod-3", "--max-width", 9),
            "glass-rod-3 is a rod, so no strip can be cut from it. Use --rod",
        ),
        (
            ("--sheet", "glass-rod-3", "--max-width", 3, "--min-width", 3),
            "glass-rod-3 is a rod, so no strip can be cut from it. Use --rod",
        ),
        (("--rod", 8, "--nearest"), "--nearest and --smooth apply to a varying section only."),
        (("--rod", "8:6", "--sheet", "pom-2"), "diameter limits are 8 and 6"),
        (("--rod", "8:x"), "'x' is not a length"),
        (("--rod", 8, "--shorter", 100), "The cord cannot be shortened by 100 %."),
        (("--rod", 8, "--shorter", "900mm"), "The cord cannot be shortened by 112.5 %."),
        (("--rod", 8, "--shorter", "x"), "'x' is neither a percentage nor a length. Write 5 or 50mm."),
    ],
)
def test_refusals_name_the_option(arch, words, message):
    assert message in run("bow", "arch.json", *words, cwd=arch, code=2).stderr


def test_the_report_of_a_bow_is_read_as_its_curve(arch):
    run("bow", "arch.json", *STRIP, "--min-width", "30", "-o", "out", cwd=arch)
    (curve,) = read_curves(arch / "out" / "arch-bow.json")
    assert curve.length == pytest.approx(
        json.loads((arch / "out" / "arch-bow.json").read_text())["length_mm"]
    )
    done = run("bend", "out/arch-bow.json", *STRIP, "--to", 700, 0, "-o", "bent", cwd=arch)
    assert "1 spline" in done.output


def test_a_cord_that_is_too_short_for_the_sheet_is_marked(arch):
    printed = run("bow", "arch.json", "--rod", 6, "--sheet", "carbon-rod-6", "-o", "out", cwd=arch).stdout
    head, *rows = printed[printed.index("If you shorten the cord") :].splitlines()
    safeties = [float(row.split()[-1]) for row in rows[1:6]]
    assert min(safeties) < 1
    assert [row.split()[-2] == "!" for row in rows[1:6]] == [safety < 1 for safety in safeties]
    assert head.endswith("(!: above the strain limit):")
