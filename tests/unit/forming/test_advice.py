"""Advice to the designer: its numbers are those of rods solved for anew, its words those of the drawing."""

import pickle
import re
from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from click.testing import CliRunner

from elastica_cad.cli.commands import elastica
from elastica_cad.errors import NotConvergedError, NotMetError
from elastica_cad.formats.json_curves import curves_json
from elastica_cad.forming.limits import Box, Keep, Limits
from elastica_cad.forming.nearest_record import NearestRod, Status, advise
from elastica_cad.forming.nearest_search import nearest_rod
from elastica_cad.forming.splitting import split
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.equilibrium_check import check_equilibrium
from elastica_cad.mechanics.loads import Gravity
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.stability import stability
from elastica_cad.refusals import Length

ARCH = PlaneCurve.spline([(0, 0), (20, 70), (60, 90), (110, 60), (120, 0)], degree=4)
WAVE = PlaneCurve.spline([(0, 0), (40, 60), (70, -60), (110, 70), (150, -40), (190, 10)], degree=4)
X = (0, 15, 60, 75, 75, 110, 150, 150, 170, 215, 230)
Y = (0, 45, 50, 10, -40, -60, -40, 10, 50, 45, 0)
SNAKE = PlaneCurve.spline(np.column_stack([X, Y]))


def sentence(near, start):
    return next(text for text in advise(near) if text.startswith(start))


@pytest.mark.parametrize("gravity", [None, Gravity(110.0)], ids=["light", "heavy"])
def test_the_cost_of_the_ratio_is_the_difference_to_other_rods(gravity):
    near = nearest_rod(ARCH, Limits(ratio=1.2), gravity=gravity)
    free, more = (
        nearest_rod(ARCH, limits, gravity=gravity).mean_deviation for limits in (None, Limits(ratio=1.44))
    )
    expected = (
        f"The ratio limit costs {near.mean_deviation - free:.3g} mm of mean distance; "
        f"1.44 instead of 1.2 would cost {more - free:.3g} mm."
    )
    assert sentence(near, "The ratio limit") == expected


def test_multipliers_speak_where_the_looser_search_ends_in_a_worse_valley():
    near = nearest_rod(ARCH, Limits(ratio=1.2))
    lost = replace(near, again=lambda limits, keep: replace(near, distance=2 * near.distance))
    (ratio,) = (one.cost for one in near.binding if one.name == "ratio")
    assert lost.advice[0] == (
        f"The ratio limit of 1.2 costs {ratio:.3g} mm of mean distance per unit "
        "(its multiplier: true of small changes)."
    )
    a, b = (nearest_rod(ARCH, Limits(ratio=r)).mean_deviation for r in (1.19, 1.21))
    assert ratio == pytest.approx((a - b) / 0.02, rel=0.1)


def test_costs_follow_the_measure_and_the_weights():
    asked = {"measure": "max", "weights": lambda s: 1 + (s > 100)}
    near, free = (nearest_rod(ARCH, limits, **asked) for limits in (Limits(ratio=1.2), None))
    cost = float(re.search(r"costs (\S+) mm of largest distance", sentence(near, "The ratio")).group(1))
    at = np.array([n.distance for n in (near, free)])
    assert cost == pytest.approx(at[0] - at[1], rel=5e-3)


def test_the_cost_of_the_margin():
    keep = Keep(tangents=True)
    near = nearest_rod(SNAKE, Limits(ratio=3.0, margin=30.0), keep)
    free, less = (nearest_rod(SNAKE, Limits(ratio=3.0, margin=m), keep).mean_deviation for m in (None, 24.0))
    assert sentence(near, "The stability margin") == (
        f"The stability margin costs {near.mean_deviation - free:.3g} mm of mean distance; "
        f"24 instead of 30 would cost {less - free:.3g} mm."
    )


def test_ends_are_called_by_their_side():
    keep = Keep(tangents=True)
    for wish, freed in ((WAVE, (False, True)), (WAVE.reversed(), (True, False))):
        near = nearest_rod(wish, Limits(ratio=2.0, margin=5.0), keep)
        other = nearest_rod(wish, Limits(ratio=2.0, margin=5.0), Keep(tangents=freed))
        text = sentence(near, "Free the left end's angle")
        saved = float(re.search(r"saves (\S+) mm", text).group(1))
        assert saved == pytest.approx(near.mean_deviation - other.mean_deviation, rel=0.02)


def test_curvature_and_sheets_are_told_as_radii():
    near = nearest_rod(ARCH, Limits(ratio=4.0, curvature=1 / 50))
    free, more = (nearest_rod(ARCH, Limits(ratio=4.0, curvature=c)).mean_deviation for c in (None, 1 / 40))
    text = sentence(near, "The curvature limit")
    assert f"costs {near.mean_deviation - free:.3g} mm" in text
    assert f"a least radius of 40 mm instead of 50 mm would cost {Length(max(more - free, 0)):.3g}" in text
    sheet = Sheet.named("birch-plywood-0.8")
    near = nearest_rod(ARCH, Limits(sheet=sheet, strain=sheet.thickness / 2 / 50))
    assert sentence(near, "The sheet's strain limit costs")


def test_other_limits_and_what_is_kept():
    longer = (WAVE.length * 1.06, WAVE.length * 1.1)
    near = nearest_rod(WAVE, Limits(ratio=3.0, length=longer))
    assert f"instead of {longer[0]:.4g} mm would cost" in sentence(near, "The range of lengths costs")
    near = nearest_rod(ARCH, Limits(ratio=4.0, keep_out=Box((40, 60), (80, 200))))
    free = nearest_rod(ARCH, Limits(ratio=4.0))
    assert f"costs {near.distance - free.distance:.3g} mm" in sentence(near, "The keep-out regions")


@pytest.mark.campaign
def test_supports_are_told_where_the_wish_has_no_strip():
    near = nearest_rod(WAVE, Limits(width=(10, 20)))
    assert near.advice[0].startswith("The ratio of the widths costs")
    assert not check_equilibrium(WAVE).realizable
    found = split(WAVE, ratio=2.0)
    assert near.advice[-1] == str(found)
    assert max(found.ratios) <= 2.0
    assert all(check_equilibrium(piece).realizable for piece in found.pieces)


@pytest.mark.campaign
def test_ways_out_of_limits_that_exclude_each_other():
    keep = Keep(tangents=True, length=True)
    near = nearest_rod(WAVE, Limits(ratio=1.05, margin=30.0), keep)
    assert near.status is Status.NOT_MET
    advice = list(islice(advise(near), 3))
    found = stability(near.rod)
    assert (
        advice[0] == f"The stability margin of 30 is missed: this rod has {found.margin:.3g} ({found.word})."
    )
    other = nearest_rod(WAVE, Limits(ratio=1.05, margin=30.0), Keep(tangents=True))
    assert other.met
    far = f"all limits are met, {other.deviation:.3g} mm from the drawn curve at most."
    assert f"Free the length: {far}" in advice
    lower = float(re.search(r"margin at (\S+) instead of 30: all limits are met", " ".join(advice)).group(1))
    assert nearest_rod(WAVE, Limits(ratio=1.05, margin=lower), keep).met


def test_nothing_is_advised_where_nothing_binds():
    near = nearest_rod(PlaneCurve.line((0, 0), (100, 20)), Limits(ratio=2.0, margin=5.0))
    assert near.advice == ()
    assert str(near) == f"{Status.MET.value} The rod leaves the drawn curve by 0 mm at most."


def test_records_travel_with_what_was_asked():
    near = pickle.loads(pickle.dumps(nearest_rod(ARCH, Limits(ratio=1.2), weights=lambda s: 1 + s)))
    again = near.relaxed()
    np.testing.assert_allclose(again.rod.position, near.rod.position, atol=1e-9)
    assert near.relaxed(Limits(ratio=1.3)).rod.ratio == pytest.approx(1.3)


def test_failures_speak_for_themselves():
    failed = NearestRod.failed(ARCH, "it rained")
    assert failed.advice == ()
    assert str(failed).endswith("it rained")
    with pytest.raises(NotConvergedError, match="it rained"):
        failed.relaxed()


def test_the_command_line_passes_advice_on(tmp_path):
    drawn = tmp_path / "arch.json"
    drawn.write_text(curves_json([ARCH]), encoding="utf-8")
    asked = ["strip", str(drawn), "--sheet", "card-200gsm", "--max-width", "20", "-o", str(tmp_path / "out")]
    done = CliRunner().invoke(elastica, [*asked, "--ratio", "1.2", "--no-step", "--no-pictures"])
    assert done.exit_code == 0
    assert next(advise(nearest_rod(ARCH, Limits(ratio=1.2)))) in done.stdout


@pytest.mark.campaign
def test_refused_limits_are_told_with_advice(tmp_path):
    drawn = tmp_path / "arch.json"
    drawn.write_text(curves_json([ARCH]), encoding="utf-8")
    asked = ["strip", str(drawn), "--sheet", "mdf-3", "--max-width", "20", "-o", str(tmp_path / "out")]
    asked += ["--nearest", "--ratio", "1.2", "--keep-strain", "--keep-tangents", "--keep-length"]
    sheet = Sheet.named("mdf-3")
    radius = f"least radius of {sheet.least_radius:.3g} mm is missed"
    done = CliRunner().invoke(elastica, asked)
    assert done.exit_code == 1
    assert radius in done.stderr
    assert "Without the sheet's strain limit all limits are met" in done.stderr
    assert " support" not in done.stderr  # pieces of the arch would be bent too much as well


def test_a_refusal_looks_for_advice_when_it_is_read_and_keeps_it_between_processes():
    sought = []
    told = NotMetError("missed.", lambda: sought.append(1) or ("Without it, met.",)).at(strip="rib 3")
    assert (told.verdict, sought) == ("rib 3: missed.", [])
    assert str(told) == "rib 3: missed. Without it, met."
    assert str(pickle.loads(pickle.dumps(told))) == str(told)


@pytest.mark.campaign
def test_what_is_missed_is_told_in_millimetres_and_degrees():
    """An arch of 120 mm that may hardly bend, with its ends, tangents and length kept."""
    arch = PlaneCurve.spline([(0, 0), (30, 60), (90, 60), (120, 0)], degree=3)
    near = nearest_rod(arch, Limits(curvature=1e-3), Keep(tangents=True, length=True))
    assert near.status is Status.NOT_MET
    broken = {binding.name: binding.broken for binding in near.binding}
    told = list(near.advice)
    assert f"Missed: the end position, by {broken['end position'] * arch.length:.3g} mm." in told
    assert f"Missed: the end tangent, by {np.degrees(broken['end tangent']):.3g} degrees." in told
