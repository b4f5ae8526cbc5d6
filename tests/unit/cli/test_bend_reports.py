"""`elastica bend` of the report of a strip: the same strip, with what the options replace."""

import json
from contextlib import chdir
from dataclasses import fields, is_dataclass
from typing import get_args, get_type_hints

import numpy as np
import pytest
from click.testing import CliRunner

from elastica_cad.cli.commands import elastica
from elastica_cad.fabrication.strip.outline import Hole, Tab, TSlot
from elastica_cad.fabrication.strip_spec import StripSpec, make_strip
from elastica_cad.fabrication.travel import bend_strip
from elastica_cad.files import read_curves
from elastica_cad.formats.reports.strip_request import RECORDS, SOLVED, FinishedStrip, request_record
from elastica_cad.forming.limits import Limits
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import RestCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import LeavesLaw

ARCH = "0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n"
SINE = PlaneCurve.fit(
    np.column_stack([100 * (t := np.linspace(0, np.pi, 60)), 60 * np.sin(t)]), tolerance=1e-4
)


def typed(line, cwd):
    with chdir(cwd):
        return CliRunner().invoke(elastica, line.split(), catch_exceptions=False)


def bent(line, cwd):
    made = typed(f"{line} --json --force", cwd)
    assert made.exit_code == 0, made.output
    return json.loads(made.stdout)


@pytest.mark.parametrize(
    "made",
    [
        "--sheet pom-1 --max-width 12",
        "--sheet pom-1 --min-width 9 --gravity",
        "--sheet pom-1 --max-width 20 --ratio 1.05",
        "--sheet pom-1 --max-width 20 --natural-curvature 0.002",
        "--sheet pom-1 --set style.kind=perforated --set style.width=40",
        "--sheet ash-3 --set law.kind=thickness --set law.limits=[0.5,2] --set law.width=20",
        "--sheet birch-plywood-3 --max-width 30 --set ignore_limits=true",
    ],
)
def test_a_report_holds_all_of_its_strip(tmp_path, made):
    (tmp_path / "arch.csv").write_text(ARCH)
    written = typed(f"strip arch.csv {made} --no-step --no-pictures -o out", tmp_path)
    assert written.exit_code == 0, written.output
    report = json.loads((tmp_path / "out" / "arch.json").read_text())
    told = bent("bend out/arch.json -o bent", tmp_path)
    (rest,), (again,) = (read_curves(tmp_path / name) for name in ("out/arch.json", "bent/arch-bent.json"))
    off = np.abs(rest.sample(101).position - again.sample(101).position).max()
    assert off < 1e-6 * rest.length
    assert told["ratio"] == pytest.approx(report["ratio"], rel=1e-6)
    assert told["travel"]["end_moment_Nmm"] == pytest.approx([report["reactions"]["end_moment"]], rel=0.01)


def test_supports_are_those_of_the_report_unless_an_option_says_others(tmp_path):
    spec = StripSpec(SINE, "pom-0.5", max_width=30, supports=Supports("pinned", "pinned"))
    report(spec, tmp_path / "sine.json")
    told = bent("bend sine.json -o bent", tmp_path)
    assert not any("designed" in one for one in told["notes"])
    assert told["travel"]["end_moment_Nmm"] == pytest.approx([0.0], abs=1e-9)
    turned = bent("bend sine.json --hold-end clamped --end-angle -70 -o bent", tmp_path)
    assert turned["shapes"][0]["angles"][1] == pytest.approx(np.radians(-70))
    said = typed("bend sine.json --hold-end clamped -o bent --force", tmp_path).stdout
    assert "with its ends held otherwise; here its end clamped" in said


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


def test_what_a_finished_strip_has_no_use_for_is_refused(tmp_path):
    report(StripSpec(SINE, "pom-0.5", max_width=30), tmp_path / "sine.json")
    for idle in ("nearest", "smooth 0.1"):
        made = typed(f"bend sine.json --{idle}", tmp_path)
        assert made.exit_code == 2
        assert "the strip of a report is finished" in made.stderr
    data = json.loads((tmp_path / "sine.json").read_text())
    data["request"]["sheet"] = {"record": "os"}
    (tmp_path / "bad.json").write_text(json.dumps(data))
    assert "make the report again" in typed("bend bad.json", tmp_path).stderr
    del data["request"]
    (tmp_path / "old.json").write_text(json.dumps(data))
    assert bent("bend old.json --to 250 0 -o bent", tmp_path)["travel"] is None


def test_leaves_and_a_blank_come_back_as_they_were_made():
    sheet = Sheet.named("birch-plywood-0.8")
    curve = PlaneCurve.spline([(0, 0), (100, 20), (200, 120), (300, 160), (420, 0)], degree=4)
    leaves = StripSpec(curve, sheet, law=LeavesLaw(sheet, 6, 20.0), limits=Limits(), ignore_limits=True)
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


def missing(kind, seen):
    """Records among the fields of a record that no report has a name for."""
    for one in get_args(kind):
        yield from missing(one, seen)
    if isinstance(kind, type) and is_dataclass(kind) and kind not in seen:
        seen.add(kind)
        if kind is not StripSpec and kind.__name__ not in RECORDS:
            yield kind
        hints = get_type_hints(kind)
        for one in fields(kind):
            if kind is not StripSpec or one.name not in SOLVED:
                yield from missing(hints[one.name], seen)


def test_every_record_of_a_request_has_a_name_in_reports():
    assert list(missing(StripSpec, set())) == []
    sheet = Sheet.named("birch-plywood-0.8")
    spec = StripSpec(
        SINE, sheet, max_width=30, ends=(Tab(30, t_slot=TSlot(12.0)), Tab(10, holes=(Hole(5, 3),)))
    )
    again = FinishedStrip.read(json.loads(json.dumps(request_record(spec, spec.make()))), SINE).spec
    assert (again.ends, again.sheet, again.sheet.poisson_known) == (spec.ends, sheet, False)


def report(spec, path):
    """Write the report of a strip as `elastica strip` does, without its drawings."""
    from elastica_cad.kit.strip_kit import StripFiles, StripKit

    found = spec.rod_spec.solve()
    kit = StripKit(spec, found, spec.make(found), path.stem, asked=StripFiles(step=False, pictures=False))
    path.write_text(json.dumps(kit.report, default=lambda value: np.asarray(value).tolist()))
