"""Advice to the designer: its numbers are multipliers of the search, its words those of the drawing."""

import pickle
import re
from dataclasses import dataclass, replace

import numpy as np
import pytest

from elastica_cad import (
    Box,
    Keep,
    Limits,
    NearestRod,
    NotConvergedError,
    PlaneCurve,
    Sheet,
    Status,
    StripSpec,
    nearest_rod,
    stability,
)
from elastica_cad.errors import rounded_up
from elastica_cad.form_finding import ActiveLimit
from elastica_cad.form_finding.limits import PlaceLimit
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.formats import curves_json
from elastica_cad.mechanics import LeavesLaw
from tests.command_line import run

ARCH = PlaneCurve.spline([(0, 0), (20, 70), (60, 90), (110, 60), (120, 0)], degree=4)
WAVE = PlaneCurve.spline([(0, 0), (40, 60), (70, -60), (110, 70), (150, -40), (190, 10)], degree=4)
X = (0, 15, 60, 75, 75, 110, 150, 150, 170, 215, 230)
PLY = Sheet.named("birch-plywood-0.8")
LONGER = 1.15 * WAVE.length
Y = (0, 45, 50, 10, -40, -60, -40, 10, 50, 45, 0)
SNAKE = PlaneCurve.spline(np.column_stack([X, Y]))


def saving(near, start):
    """Saved distance in mm, from the sentence that starts so."""
    text = next(text for text in near.advice if text.startswith(start))
    return float(re.search(r"distance by about (\S+) mm", text).group(1))


@pytest.mark.parametrize(
    ("drawn", "name", "limits", "keep", "looser"),
    [
        (ARCH, "ratio limit: a change of 10 %", Limits(ratio=1.2), Keep(), Limits(ratio=1.212)),
        (
            SNAKE, "stability margin: a change of 10 %", Limits(ratio=3.0, margin=30.0), Keep(tangents=True),
            Limits(ratio=3.0, margin=29.7),
        ),
        (ARCH, "curvature limit: a change of 10 %", Limits(4, curvature=0.02), Keep(), Limits(4, curvature=0.0202)),
        (
            ARCH, "strain limit of the sheet (use a thinner sheet): a change of 10 %",
            Limits(4, sheet=PLY, strain=PLY.thickness / 100), Keep(),
            Limits(4, sheet=PLY, strain=PLY.thickness / 99),
        ),
        (
            ARCH, "keep-out regions: a change of 1 mm",
            Limits(ratio=4.0, keep_out=Box((40, 60), (80, 200))), Keep(),
            Limits(ratio=4.0, keep_out=Box((40, 60.1), (80, 200))),
        ),
        (
            WAVE, "range of lengths: a change of 1 mm", Limits(ratio=3.0, length=(LONGER, 1.1 * LONGER)), Keep(),
            Limits(ratio=3.0, length=(LONGER - 0.1, 1.1 * LONGER)),
        ),
    ],
    ids=["ratio", "margin", "curvature", "strain", "keep-out", "length"],
)  # fmt: skip
def test_savings_are_those_of_rods_within_slightly_looser_limits(drawn, name, limits, keep, looser):
    """A tenth of the step that the sentence names."""
    near, other = (nearest_rod(drawn, given, keep) for given in (limits, looser))
    assert saving(near, f"To come nearer to the drawn curve, relax the {name}") == pytest.approx(
        10 * (near.distance - other.distance), rel=0.15
    )


def test_savings_follow_the_measure_and_the_weights():
    request = {"measure": "max", "weights": lambda s: 1 + (s > 100)}
    near, other = (nearest_rod(ARCH, Limits(ratio=ratio), **request) for ratio in (1.2, 1.212))
    assert "reduces the largest distance by about" in near.advice[0]
    assert saving(near, "To come nearer to the drawn curve, relax the ratio limit") == pytest.approx(
        10 * (near.distance - other.distance), rel=0.1
    )


def test_the_ratio_that_the_widths_of_a_strip_limit_is_named_by_its_options():
    curve = PlaneCurve.spline([(0, 0), (20, 70), (60, 90), (110, 60), (120, 0)], degree=4)
    spec = StripSpec(curve, "birch-plywood-0.8", max_width=12, min_width=10, limits=Limits())
    texts = solve_rod(spec.rod_spec).advice
    assert any(
        "relax the ratio of largest to least width, now 1.2 (max_width; min_width or shop.least_width)"
        in text
        for text in texts
    )


def test_ends_are_called_by_their_side():
    for wish in (WAVE, WAVE.reversed()):
        near = nearest_rod(wish, Limits(ratio=2.0, margin=5.0), Keep(tangents=True), measure="mean")
        assert (
            saving(
                near,
                "To come nearer to the drawn curve, relax the angle at the left end: a change of 1 degree ",
            )
            > 0
        )


def test_advice_solves_for_no_further_rod(monkeypatch):
    near = nearest_rod(ARCH, Limits(width=(10, 12)))
    monkeypatch.setattr("elastica_cad.form_finding.nearest_search.minimize", None)
    assert near.advice[0].startswith(
        "To come nearer to the drawn curve, relax the ratio of largest to least width, now 1.2 "
        "(max_width; min_width or shop.least_width): a change of 10 % reduces the "
    )


@pytest.mark.campaign
def test_limits_that_exclude_each_other_are_named():
    keep = Keep(tangents=True, length=True)
    near = nearest_rod(WAVE, Limits(ratio=1.05, margin=30.0), keep)
    assert near.status is Status.NOT_MET
    found = stability(near.rod)
    *missed, last = near.advice
    assert missed[0] == f"The stability margin is {found.margin:.3g} ({found.rating}), below the limit of 30."
    assert last.startswith("Relax the stability margin, ")
    assert "the length" in last
    assert near.relaxed(keep=Keep(tangents=True)).met


def test_nothing_is_advised_where_nothing_binds():
    near = nearest_rod(PlaneCurve.line((0, 0), (100, 20)), Limits(ratio=2.0, margin=5.0))
    assert near.advice == ()
    assert (
        str(near)
        == f"{Status.MET.value} The strip follows the nearest possible curve, at most 0 mm from the drawn curve."
    )


@dataclass(frozen=True, eq=False)
class MoreLimits(Limits):
    """Limits with one that no list knows: a least radius between two places."""

    least_radius: tuple[float, float, float] | None = None

    def at_places(self, *, strain):
        yield from super().at_places(strain=strain)
        if self.least_radius is not None:
            active = ActiveLimit(
                "radius of a part", self.least_radius[0], title="the least radius", unit="number"
            )
            yield PlaceLimit("least_radius", active, self._room, MoreLimits.stricter)

    def _room(self, places):
        radius, start, end = self.least_radius
        radii = np.where((places.s >= start) & (places.s <= end), radius, 0.0)
        return (
            1 - radii * abs(places.curvature),
            np.zeros((radii.size, 2)),
            -radii * np.sign(places.curvature),
        )

    def stricter(self, by):
        radius, start, end = self.least_radius
        return replace(self, least_radius=(radius * (1 + by), start, end))


def test_a_new_limit_binds_and_names_itself_in_advice():
    middle = (0.4 * ARCH.length, 0.6 * ARCH.length)
    near = nearest_rod(ARCH, MoreLimits(4, least_radius=(150.0, *middle)))
    share = near.rod.s / near.rod.length
    bent = np.abs(near.rod.curvature[(share > 0.401) & (share < 0.599)])
    assert near.met
    assert 1 / bent.max() == pytest.approx(150, rel=1e-5)
    (advice, *_) = near.advice
    assert advice.startswith("To come nearer to the drawn curve, relax the least radius: a change of 10 %")
    (binding,) = (binding for binding in near.binding if binding.name == "radius of a part")
    unmet = replace(near, binding=(replace(binding, broken=0.01),), status=Status.NOT_MET)
    assert unmet.advice == ("The strip violates a limit: radius of a part.", "Relax the least radius.")


def test_glued_plies_meet_a_new_limit():
    plies = LeavesLaw(Sheet.named("birch-plywood-0.8"), 6, 20)
    free = nearest_rod(ARCH, Limits(), section=plies)
    least = 1.1 / np.abs(free.rod.curvature).max()
    near = nearest_rod(ARCH, MoreLimits(least_radius=(least, 0.0, ARCH.length)), section=plies)
    names = [binding.name for binding in near.binding]
    assert near.met or names == ["radius of a part"]
    assert near.deviation > free.deviation
    assert np.abs(near.rod.curvature).max() < 0.99 * np.abs(free.rod.curvature).max()


def test_a_limit_of_a_blank_is_one_of_the_change_of_curvature():
    arch = PlaneCurve.arc((0, 0), 100, np.pi, 1.0)
    near = nearest_rod(arch, Limits(curvature=0.01), natural_curvature=0.02)
    (binding,) = (binding for binding in near.binding if binding.name == "curvature")
    unmet = replace(near, binding=(replace(binding, limit=0.005, broken=0.1),), status=Status.NOT_MET)
    assert unmet.advice[0] == "Bending changes the curvature by 0.01 1/mm, above the limit of 0.005 1/mm."


def test_records_travel_with_what_was_requested():
    near = pickle.loads(pickle.dumps(nearest_rod(ARCH, Limits(ratio=1.2), weights=lambda s: 1 + s)))
    again = near.relaxed()
    np.testing.assert_allclose(again.rod.position, near.rod.position, atol=1e-9)
    assert near.relaxed(Limits(ratio=1.3)).rod.ratio == pytest.approx(1.3)


def test_failures_speak_for_themselves():
    failed = NearestRod.failure(ARCH, "it rained")
    assert failed.advice == ()
    assert str(failed).endswith("it rained")
    with pytest.raises(NotConvergedError, match="it rained"):
        failed.relaxed()


def test_the_command_line_passes_advice_on(tmp_path):
    drawn = tmp_path / "arch.json"
    drawn.write_text(curves_json([ARCH]), encoding="utf-8")
    options = [
        "strip",
        str(drawn),
        "--sheet",
        "card-200gsm",
        "--max-width",
        "20",
        "-o",
        str(tmp_path / "out"),
    ]
    done = run(*options, "--ratio", "1.2", "--no-step", "--no-pictures")
    assert nearest_rod(ARCH, Limits(ratio=1.2)).advice[0] in done.stdout


@pytest.mark.campaign
def test_refused_limits_are_listed_with_advice(tmp_path):
    drawn = tmp_path / "arch.json"
    drawn.write_text(curves_json([ARCH]), encoding="utf-8")
    options = ["strip", str(drawn), "--sheet", "mdf-3", "--max-width", "20", "-o", str(tmp_path / "out")]
    options += ["--nearest", "--ratio", "1.2", "--keep-strain", "--keep-tangents", "--keep-length"]
    sheet = Sheet.named("mdf-3")
    radius = f"low the limit of {rounded_up(sheet.least_radius, 3):g} mm"
    done = run(*options, code=1)
    assert radius in done.stderr
    assert "Relax the strain limit of the sheet (use a thinner sheet), " in done.stderr


@pytest.mark.campaign
def test_what_is_missed_is_reported_in_millimetres_and_degrees():
    """An arch of 120 mm that may hardly bend, with its ends, tangents and length kept."""
    arch = PlaneCurve.spline([(0, 0), (30, 60), (90, 60), (120, 0)], degree=3)
    near = nearest_rod(arch, Limits(curvature=1e-3), Keep(tangents=True, length=True))
    assert near.status is Status.NOT_MET
    broken = {binding.name: binding.broken for binding in near.binding}
    message = list(near.advice)
    assert (
        f"The strip violates a limit by {broken['end position'] * arch.length:.3g} mm: end position."
        in message
    )
    assert (
        f"The strip violates a limit by {np.degrees(broken['end tangent']):.3g} degrees: end tangent."
        in message
    )


def test_the_widths_that_limit_the_ratio_of_a_strip_are_named():
    widths = "relax the ratio of largest to least width, now 1.17 (max_width; min_width or shop.least_width):"
    near = solve_rod(StripSpec(ARCH, PLY, max_width=3.5, limits=Limits()).rod_spec)
    assert widths in " ".join(near.advice)
    near = solve_rod(StripSpec(ARCH, PLY, max_width=5, limits=Limits(ratio=1.1)).rod_spec)
    assert "relax the ratio limit:" in " ".join(near.advice)
