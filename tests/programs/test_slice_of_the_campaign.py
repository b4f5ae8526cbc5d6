"""A minute of the campaign of broken files: mutated files of every format, and a few hostile commands."""

from pathlib import Path

import pytest

from tests.campaign.trust import commands, files, ledger, met_checks, written

ROOT = Path(__file__).resolve().parents[2]


def test_mutated_files_give_curves_or_one_sentence(tmp_path):
    faults, sums = files.watched(20_26, 400, tmp_path, minutes=10)
    assert faults == []
    assert sums["cases"] == 400
    assert sums["ends"]["curves"] > 10
    assert sums["most_mib"] < 1024


def test_hostile_commands_give_answers_or_one_sentence(tmp_path):
    import random

    from elastica_cad.cli.commands import elastica

    for number in range(12):
        rng, folder = random.Random(f"slice {number}"), tmp_path / str(number)
        folder.mkdir()
        commands.prepared(folder, rng)
        said = commands.words(rng, elastica.commands)
        ended = commands.run(said, folder, typed=True)
        assert commands.judged(said, folder, ended) == [], said


@pytest.mark.parametrize("number", range(4))
def test_rods_that_meet_their_limits_do(number):
    ended, wrong = met_checks.solved(2026, number)
    assert wrong == [], ended


def test_a_wrong_verdict_would_be_noticed():
    """The checks can fail: each of them does on a rod that misses what is asked."""
    import elastica_cad as ec

    points = [(0, 0), (40, 60), (90, 60), (130, 0)]
    near = ec.nearest_rod(ec.PlaneCurve.spline(points, degree=3), ec.Limits(ratio=2.0))
    assert met_checks.faults(near, points, {"ratio": 2.0}, {}) == []
    asked = {"ratio": 1.1, "curvature": 1e-3, "margin": 1e4}
    found = met_checks.faults(near, [(5, 0), *points[1:]], asked, {"length": True})
    assert [text.split()[0] for text in found] == ["ratio", "curvature", "margin", "ends", "length"]


@pytest.mark.parametrize("number", range(6))
def test_strips_at_random_can_be_cut(number, tmp_path):
    ended, wrong = written.drawn(2026, number, tmp_path)
    assert wrong == [], ended


def test_a_drawing_that_cannot_be_cut_would_be_noticed(tmp_path):
    import elastica_cad as ec
    from elastica_cad.fabrication.drawings.drawing import LayeredPath

    def told(*paths, size=None):
        ec.save(ec.Drawing("bad", paths), tmp_path / "bad.dxf", force=True)
        return " ".join(written.faults(tmp_path / "bad.dxf", size))

    plate = LayeredPath("CUT_OUTER", ec.Path.rectangle(80, 40))
    hole, other = (LayeredPath("CUT_INNER", ec.Path.circle((x, 20), 6)) for x in (30, 39))
    assert told(plate, hole) == ""
    assert "holes touch or cross" in told(plate, hole, other)
    assert "crosses its edge" in told(plate, LayeredPath("CUT_INNER", ec.Path.circle((80, 20), 6)))
    assert "parts touch or cross" in told(plate, LayeredPath("CUT_OUTER", ec.Path.circle((80, 20), 6)))
    assert "leaves the sheet" in told(plate, size=(60, 60))
    bow = ec.Path.polyline([(0, 0), (40, 30), (40, 0), (0, 30)], closed=True)
    assert "through itself" in told(LayeredPath("CUT_OUTER", bow))
    assert "stay open" in told(plate, LayeredPath("CUT_OUTER", ec.Path.polyline([(0, 60), (40, 60)])))


def test_the_ledger_names_what_pages_say():
    for (page, _, words), tests in ledger.CLAIMS.items():
        assert words in " ".join((ROOT / page).read_text(encoding="utf-8").split()), page
        assert (ROOT / tests).is_file()
