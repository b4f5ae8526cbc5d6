"""A minute of the campaign of broken files: mutated files of every format, and a few hostile commands."""

import ast
from pathlib import Path

import pytest

from tests.campaign.trust import (
    changed_lines,
    commands,
    designs,
    equivalent,
    files,
    kernels,
    ledger,
    met_checks,
    request_bank,
    written,
)

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


def test_compiled_kernels_touch_nothing_but_their_arrays():
    ended = kernels.ask_apart(120, 2026)
    assert (ended.returncode, ended.stderr) == (0, "")
    cases, refused, wrong = map(int, ended.stdout.split())
    assert (cases, refused) == (120, wrong)


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


@pytest.mark.parametrize("number", range(3))
def test_designs_changed_at_random_are_made_or_refused_in_a_sentence(number, tmp_path):
    ended, wrong = designs.made(2026, number, tmp_path)
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


def test_an_answer_that_changed_would_be_noticed():
    """The bank of requests can tell: another place, word or count, and no figure behind the sixth."""
    strip = {"files": {"a.dxf": "SPLINE\n10\n12.5000001\n"}, "given": ["met", 3.0, [1.0, float("nan")]]}
    same = {"files": {"a.dxf": "SPLINE\n10\n12.5\n"}, "given": ["met", 3.0000001, [1.0, float("nan")]]}
    assert equivalent.difference(strip, same) == ""
    for place, other in (("/given/0", ["far", 3.0, [1.0]]), ("/given/1", ["met", 3.0001, [1.0]])):
        assert equivalent.difference(strip, {**strip, "given": other}).startswith(place)
    assert "a.dxf: 12.5000001 and 12.51" in equivalent.difference(
        strip, {**strip, "files": {"a.dxf": "SPLINE\n10\n12.51\n"}}
    )
    assert "b.dxf" in equivalent.difference(strip, {**strip, "files": {**strip["files"], "b.dxf": ""}})


def test_a_changed_place_runs_where_its_statement_or_its_constant_does():
    text = "STEP_MM = 2.0\n\n\ndef f(x):\n    if x > 1:\n        return (x\n            + STEP_MM)\n    return 0\n"
    tree, file = ast.parse(text), Path("elastica_cad/f.py")
    found = [
        changed_lines.lines_of(Path("nowhere"), file, tree, node)
        for node in ast.walk(tree)
        if isinstance(node, ast.Compare | ast.BinOp)
    ]
    assert found == [[(str(file), 5, 5)], [(str(file), 6, 7)]]


def test_requests_of_the_bank_give_the_same_again(tmp_path):
    requests = request_bank.bank()
    for name in (
        "command 0",
        "command 49",
        "page curves",
        "rod 2",
        "strip 11",
        "file dxf 0",
        "keys 7",
        "design arch",
    ):
        answers = []
        for turn in ("first", "second"):
            folder = tmp_path / name / turn
            folder.mkdir(parents=True)
            with pytest.MonkeyPatch.context() as patch:
                patch.chdir(folder)
                patch.setenv("SOURCE_DATE_EPOCH", equivalent.EPOCH)
                answers.append(request_bank.answer(requests[name], folder))
        assert equivalent.difference(*answers) == "", name
        assert "Traceback" not in str(answers)


def test_the_ledger_names_what_pages_say():
    for (page, _, words), tests in ledger.CLAIMS.items():
        assert words in " ".join((ROOT / page).read_text(encoding="utf-8").split()), page
        assert (ROOT / tests).is_file()
