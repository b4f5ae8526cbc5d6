"""The rule of strain: allowed, warned with what happens to the material, refused where it breaks."""

from dataclasses import replace

import pytest

from elastica_cad import PlaneCurve, Sheet, make_strip, sheet_names
from elastica_cad.errors import Change, StrainError
from elastica_cad.mechanics.section_limits import StrainState, breaking_strain, judge_strain

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])


@pytest.mark.parametrize(
    ("sheet", "used", "state", "outcome"),
    [
        ("birch-plywood-0.8", 1.0, "ALLOWED", ""),
        ("birch-plywood-0.8", 1.4, "WARNED", "crack"),
        ("birch-plywood-0.8", 1.6, "REFUSED", "crack"),
        ("mdf-3", 1.9, "WARNED", "crack"),
        ("mdf-3", 2.1, "REFUSED", "crack"),
        ("card-200gsm", 5.0, "WARNED", "stays bent"),
        ("spring-steel-0.2", 5.0, "WARNED", "stays bent"),
        ("pom-0.5", 5.0, "WARNED", "creeps"),
    ],
)
def test_what_happens_to_a_sheet(sheet, used, state, outcome):
    known = Sheet.named(sheet)
    judged = judge_strain(known, used * known.max_strain, at=12.0)
    assert judged.state is StrainState[state]
    assert outcome in judged.outcome
    assert bool(judged.outcome) == (used > 1)
    assert judged.at == 12.0
    assert judged.percent == round(100 * used)


def test_a_thousandth_beyond_the_limit_is_no_hundred_percent():
    card = Sheet.named("card-200gsm")
    assert judge_strain(card, 1.001 * card.max_strain).percent == 101
    assert judge_strain(card, (1 + 1e-7) * card.max_strain).percent == 100


def test_every_sheet_breaks_beyond_its_limit_or_not_at_all():
    for name in sheet_names():
        sheet = Sheet.named(name)
        breaks = breaking_strain(sheet)
        assert breaks is None or breaks > sheet.max_strain
        assert (breaks is None) == (sheet.kind in ("card", "metal") or name.startswith("polypropylene"))
    own = replace(Sheet.named("card-200gsm"), break_strain=0.02)
    assert judge_strain(own, 0.021).refused
    assert Sheet.named("pom-0.5").break_strain == 0.5


def test_a_strip_that_would_break_is_refused_unless_limits_are_ignored():
    with pytest.raises(StrainError, match=r"strain is 2.7 % at .* the material may crack there") as refused:
        make_strip(ARCH, "birch-plywood-3", max_width=30)
    assert refused.value.refusal.values["percent"] > 300
    assert refused.value.refusal.changes[-1] == Change("nearest", True)
    made = make_strip(ARCH, "birch-plywood-3", max_width=30, ignore_limits=True)
    assert made.strain_verdict.refused
    assert made.strain_warnings[0] in made.warnings
    warned = make_strip(ARCH, "pom-1", max_width=60)
    assert warned.strain_verdict.allowed == (not warned.strain_warnings)
