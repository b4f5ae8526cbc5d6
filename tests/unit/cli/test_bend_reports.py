"""`elastica bend` of the report of a strip: the same strip, with what the options replace."""

import json
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Hole,
    InputError,
    Laminated,
    Limits,
    PlaneCurve,
    PointMass,
    Sheet,
    StripSpec,
    Supports,
    Tab,
    Weight,
    bend,
    bend_strip,
    make_strip,
    read_curves,
)
from elastica_cad.design.strip_request import FinishedStrip, request_record
from elastica_cad.files import read_drawing
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.mechanics import LeavesLaw, RestCurvature, ThicknessLaw
from elastica_cad.strip import TSlot
from tests.command_line import run

ARCH = "0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n"
SINE = PlaneCurve.fit(
    np.column_stack([100 * (t := np.linspace(0, np.pi, 60)), 60 * np.sin(t)]), tolerance=1e-4
)


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """As without matplotlib, for speed."""
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)


def bent(line, cwd):
    made = run(f"{line} --json --force", cwd=cwd)
    return json.loads(made.stdout)


@pytest.mark.parametrize(
    "made",
    [
        "--sheet pom-1 --max-width 12",
        "--sheet pom-1 --min-width 9 --gravity",
        "--sheet pom-1 --max-width 20 --ratio 1.05",
        "--sheet pom-1 --max-width 20 --natural-curvature 0.002",
        "--sheet pom-1 --set style.kind=perforated --set style.width=40",
        "--sheet ash-3 --set section.kind=thickness --set section.limits=[0.5,2] --set section.width=20",
        "--sheet birch-plywood-3 --max-width 30 --set ignore_limits=true",
    ],
)
def test_a_report_holds_all_of_its_strip(tmp_path, made):
    (tmp_path / "arch.csv").write_text(ARCH)
    run(f"strip arch.csv {made} --no-step --no-pictures -o out", cwd=tmp_path)
    report = json.loads((tmp_path / "out" / "arch.json").read_text())
    answer = bent("bend out/arch.json -o bent", tmp_path)
    (rest,), (again,) = (read_curves(tmp_path / name) for name in ("out/arch.json", "bent/arch-bent.json"))
    off = np.abs(rest.sample(101).position - again.sample(101).position).max()
    assert off < 1e-6 * rest.length
    assert answer["ratio"] == pytest.approx(report["ratio"], rel=1e-6)
    assert answer["travel"]["end_moment_Nmm"] == pytest.approx([report["reactions"]["end_moment"]], rel=0.01)


def test_supports_are_those_of_the_report_unless_an_option_says_others(tmp_path):
    spec = StripSpec(SINE, "pom-0.5", max_width=30, supports=Supports("pinned", "pinned"))
    report(spec, tmp_path / "sine.json")
    answer = bent("bend sine.json -o bent", tmp_path)
    assert not any("designed" in one for one in answer["notes"])
    assert answer["travel"]["end_moment_Nmm"] == pytest.approx([0.0], abs=1e-9)
    turned = bent("bend sine.json --hold-end clamped --end-angle -70 -o bent", tmp_path)
    assert turned["shapes"][0]["angles"][1] == pytest.approx(np.radians(-70))
    text = run("bend sine.json --hold-end clamped -o bent --force", cwd=tmp_path).stdout
    assert "with its ends held otherwise, and here bent with its end clamped" in text


def test_an_option_replaces_what_the_report_says(tmp_path):
    spec = StripSpec(SINE, "pom-0.5", max_width=30)
    report(spec, tmp_path / "sine.json")
    own, wide, steel, thick = (
        bent(f"bend sine.json --to 250 0 -o bent {more}", tmp_path)["travel"]["end_moment_Nmm"][0]
        for more in ("", "--max-width 15", "--sheet spring-steel-0.2", "--thickness 1")
    )
    assert wide == pytest.approx(own / 2, rel=0.08)
    assert thick == pytest.approx(8 * own, rel=0.08)
    strip = make_strip(SINE, "spring-steel-0.2", max_width=30)
    assert steel == pytest.approx(bend_strip(strip, [(250.0, 0.0)]).end_moment[0], rel=0.01)


EVEN = {
    "rod": "--sheet glass-rod-2 --set section.kind=rod --set section.limits=[2,2]",
    "heavy rod": "--sheet glass-rod-2 --set section.kind=rod --set section.limits=[2,2] --gravity",
    "bar": "--sheet pom-2 --set section.kind=thickness --set section.limits=[2,2] --set section.width=8",
}


@pytest.mark.parametrize("kind", EVEN)
def test_an_even_rod_is_bent_by_its_own_report(tmp_path, kind):
    """The curve of the nearest even rod, taken exactly, would need a rod that is not quite even."""
    (tmp_path / "arch.csv").write_text("x mm,y mm\n0,0\n100,84\n200,118\n300,84\n400,0\n")
    line = f"strip arch.csv {EVEN[kind]} --ratio 1 --start pinned --end pinned --no-step --no-pictures -o out"
    run(line, cwd=tmp_path)
    force = json.loads((tmp_path / "out" / "arch.json").read_text())["reactions"]["end_force"]
    travel = bent("bend out/arch.json -o bent", tmp_path)["travel"]
    assert travel["end_force_x_N"] == pytest.approx(force[:1], rel=1e-3)
    law = "--set section.kind=rod --set section.limits"
    if kind == "rod":
        thick = bent(f"bend out/arch.json {law}=[3,3] -o bent", tmp_path)["travel"]
        assert thick["end_force_x_N"] == pytest.approx([1.5**4 * force[0]], rel=1e-3)


def test_a_report_of_the_time_when_the_section_was_called_law_is_read(loaded):
    data = json.loads((loaded / "thick.json").read_text())
    data["request"]["law"] = data["request"].pop("section")
    (loaded / "former.json").write_text(json.dumps(data))
    assert travel("former.json", loaded) == travel("thick.json", loaded)


def test_limits_of_a_new_law_are_those_of_the_finished_stiffness(loaded):
    law = "--set section.kind=thickness --set section.width=20 --set section.limits"
    refused = run(f"bend thick.json {law}=[1.19,1.2] -o bent --force", cwd=loaded, code=2).stderr
    assert "but the limits allow no less than 1.19 mm" in " ".join(refused.split())


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """Folder with reports of an arch under a mass, without a mass, and of a law."""
    folder = tmp_path_factory.mktemp("loaded")
    load = {"gravity": True, "loads": [PointMass(90, 60)], "compensate": False}
    for name, options in {
        "heavy": {"max_width": 30, **load},
        "light": {"max_width": 30, "compensate": False},
        "thick": {"section": ThicknessLaw(Sheet.named("birch-plywood-0.8"), 0.3, 1.2, width=20)},
    }.items():
        report(StripSpec(SINE, "birch-plywood-0.8", samples=201, **options), folder / f"{name}.json")
    return folder


def travel(line, folder):
    found = bent(f"bend {line} -o bent", folder)
    return {**found["travel"], "size": found["shapes"][0]["size"], "ratio": found["ratio"]}


@pytest.mark.parametrize(
    ("first", "second", "factor"),
    [  # half the mass on half the width is the same shape; so are other words for one change
        ("heavy.json --max-width 15", "heavy.json --set loads=[{at=90,mass=120}]", 0.5),
        ("heavy.json --set min_width=5 --set loads=[{at=90,mass=1e-6}]", "heavy.json --set loads=[]", None),
        ("heavy.json --sheet birch-plywood-3 --thickness 1", "heavy.json --thickness 1", 1.0),
        ("heavy.json --set gravity=false", "heavy.json --set gravity=false --max-width 60", 0.5),
        ("heavy.json --down 1 0", "heavy.json --gravity --down 1 0", 1.0),
        ("light.json --max-width 15", "light.json --set max_width=15", 1.0),
        ("light.json --gravity", "light.json --set gravity=true", 1.0),
        ("thick.json --max-width 20", "light.json --max-width 20", 1.0),
    ],
)
def test_options_on_a_report_agree_with_each_other(loaded, first, second, factor):
    one, other = travel(first, loaded), travel(second, loaded)
    assert one["size"] == pytest.approx(other["size"], rel=2e-4)
    if factor is not None:
        assert one["energy_Nmm"] == pytest.approx(factor * np.array(other["energy_Nmm"]), rel=2e-3)


@pytest.mark.parametrize(
    "more", ["", " --set natural_curvature=0.002", " --set gravity=false", " --set loads=[]"]
)
def test_a_report_under_another_load_comes_to_rest(loaded, more):
    """Against the rod of the strip, bent in Python."""
    spec = StripSpec(
        SINE, "birch-plywood-0.8", max_width=30, samples=201, gravity=True, loads=[PointMass(90, 60)]
    )
    rod = spec.make().rod
    rest = {
        "": rod,
        " --set natural_curvature=0.002": replace(rod, natural_curvature=0.002),
        " --set gravity=false": replace(rod, gravity=None, weight=None),
        " --set loads=[]": replace(rod, weight=replace(rod.weight, masses=())),
    }[more]
    expected = np.ptp(bend(rest).position, axis=0)
    assert travel(f"heavy.json{more}", loaded)["size"] == pytest.approx(expected, rel=1e-4)
    moved = np.abs(expected - np.ptp(rod.position, axis=0)).max()
    assert (moved > 0.1) == bool(more)


def test_a_mass_that_no_width_carries_bends_the_strip_of_a_report(loaded):
    result = run("bend light.json --gravity --set loads=[{at=90,mass=9e4}] -o bent --force", cwd=loaded)
    assert "the strip snaps" in result.output


def test_a_law_replaces_the_widths_of_a_report(loaded):
    law = "--set section.kind=thickness --set section.limits=[0.3,1.2] --set section.width=20"
    assert travel(f"light.json {law}", loaded)["energy_Nmm"] == pytest.approx(
        travel("thick.json", loaded)["energy_Nmm"], rel=1e-4
    )


def test_the_unit_of_a_report_is_that_of_its_lengths(loaded):
    assert read_drawing(loaded / "heavy.json").unit.name == "mm"


def test_what_a_finished_strip_has_no_use_for_is_refused(tmp_path):
    report(StripSpec(SINE, "pom-0.5", max_width=30), tmp_path / "sine.json")
    for idle in ("nearest", "smooth 0.1", "set limits.margin=5", "set keep.length=true"):
        made = run(f"bend sine.json --{idle}", cwd=tmp_path, code=2)
        assert "the finished strip of a report" in made.stderr
    data = json.loads((tmp_path / "sine.json").read_text())
    data["request"]["sheet"] = {"record": "os"}
    (tmp_path / "bad.json").write_text(json.dumps(data))
    assert "Make the report again" in run("bend bad.json", cwd=tmp_path, code=2).stderr
    del data["request"]
    (tmp_path / "old.json").write_text(json.dumps(data))
    assert bent("bend old.json --to 250 0 -o bent", tmp_path)["travel"] is None


def test_leaves_and_a_blank_come_back_as_they_were_made():
    sheet = Sheet.named("birch-plywood-0.8")
    curve = PlaneCurve.spline([(0, 0), (100, 20), (200, 120), (300, 160), (420, 0)], degree=4)
    leaves = StripSpec(curve, sheet, section=LeavesLaw(sheet, 6, 20.0), limits=Limits(), ignore_limits=True)
    blank = RestCurvature.linear([0, SINE.length], [0, 1e-3])
    for spec in (leaves, StripSpec(SINE, sheet, min_width=6.0, natural_curvature=blank)):
        made = spec.make()
        record = json.loads(json.dumps(request_record(spec, made)))
        again = FinishedStrip.read(record, made.rod.curve).make()
        end = tuple(made.rod.position[-1] - (20.0, 0.0))
        first, second = (bend_strip(strip, [end]) for strip in (made, again))
        assert second.end_force == pytest.approx(first.end_force, rel=2e-3, abs=1e-3)
        assert second.rods[0].position == pytest.approx(first.rods[0].position, abs=0.02)
        assert second.safety == pytest.approx(first.safety, rel=2e-3)


def finished(spec, strip):
    """Return the finished strip that is read from the report of a strip."""
    return FinishedStrip.read(json.loads(json.dumps(request_record(spec, strip))), strip.rod.curve)


def test_a_report_of_a_strip_under_a_weight_makes_the_same_strip_again():
    load = Weight(masses=(PointMass(90.0, 5.0),))
    spec = StripSpec(SINE, "birch-plywood-0.8", max_width=30, gravity=True, loads=load, compensate=False)
    strip = spec.make()
    again = finished(spec, strip)
    assert again.spec.loads.masses == load.masses
    assert again.make().width.extremes == pytest.approx(strip.width.extremes, rel=1e-6)


def test_limits_of_the_thickness_that_a_finished_strip_does_not_meet_are_refused():
    sheet = Sheet.named("birch-plywood-0.8")
    spec = StripSpec(SINE, sheet, section=ThicknessLaw(sheet, 0.3, 1.2, width=20))
    strip = spec.make()
    least, most = strip.layout.size.extremes
    same = finished(spec, strip).changed(section=ThicknessLaw(sheet, 0.2, most, width=20)).make()
    assert same.layout.size.extremes == pytest.approx((least, most), rel=1e-3)
    narrow = ThicknessLaw(sheet, (least + most) / 2, most, width=20)
    with pytest.raises(InputError, match=f"a thickness of {least:.4g} mm at .* but the limits allow no less"):
        finished(spec, strip).changed(section=narrow).make()


def test_a_laminate_with_a_weight_is_made_again_of_a_thicker_sheet():
    sheet = Sheet.named("birch-plywood-0.8")
    spec = StripSpec(SINE, sheet, style=Laminated(width=30, backing=sheet), gravity=True)
    strip = spec.make()
    thicker = finished(spec, strip).changed(sheet=sheet.with_thickness(0.9)).make()
    assert thicker.width.extremes == strip.width.extremes
    assert thicker.sheet.thickness == 0.9


def test_records_inside_the_tabs_of_a_report_come_back():
    sheet = Sheet.named("birch-plywood-0.8")
    spec = StripSpec(
        SINE, sheet, max_width=30, ends=(Tab(30, t_slot=TSlot(12.0)), Tab(10, holes=(Hole(5, 3),)))
    )
    again = FinishedStrip.read(json.loads(json.dumps(request_record(spec, spec.make()))), SINE).spec
    assert (again.ends, again.sheet, again.sheet.poisson_known) == (spec.ends, sheet, False)


def report(spec, path):
    """Write the report of a strip as `elastica strip` does, without its drawings."""
    from elastica_cad.kit.strip_kit import StripFiles, StripResult

    found = solve_rod(spec.rod_spec)
    result = StripResult(spec, found, spec.make(found), path.stem)
    kit = result.kit(StripFiles(step=False, pictures=False))
    path.write_text(json.dumps(kit.report, default=lambda value: np.asarray(value).tolist()))


@pytest.mark.parametrize("option", ["--set loads=[]", "--gravity", "--max-width 9", ""])
def test_a_missing_file_is_named_before_the_options_that_need_its_strip(tmp_path, option):
    refused = run(f"bend none/seat.json {option} -o out", cwd=tmp_path, code=2)
    assert "seat.json cannot be read: No such file or directory" in refused.stderr
