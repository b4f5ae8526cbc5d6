"""A strip that is designed with loads is judged without them, too."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root

import elastica_cad as ec
from elastica_cad.design.reports import report_strip
from elastica_cad.errors import NotConvergedError, StrainError
from elastica_cad.mechanics.bending import bend
from elastica_cad.strip import strip as strip_module
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.suggestions import suggest
from elastica_cad.strip.summary import strip_rows

SHEET = ec.Sheet("test-ply", 1.2, 9000.0, density=700.0, max_strain=0.008, kind="plywood")
CURVE = ec.PlaneCurve.spline(
    np.array([(0, 0), (10, 110), (120, 190), (270, 140), (320, 0)], dtype=float), degree=3
)
MASS = ec.PointMass(190.0, 500.0)
G = 9.80665
EXACT = {"dense_output": True, "rtol": 1e-9, "atol": 1e-9}


def arch(width, mass=MASS, **fields):
    loads = () if mass is None else (mass,)
    return ec.make_strip(CURVE, SHEET, max_width=width, gravity=True, loads=loads, **fields)


def row(strip, label):
    (text,) = (row.text for row in strip_rows(strip) if row.label == label)
    return str(text)


def shot(strip):
    """Return stations, heights and curvatures with and without the mass, from shooting along the beam.

    The ends are clamped. The moment and the force at the start are unknown. The mass is removed in steps.
    """
    rod, rigidity = strip.rod, SHEET.youngs_modulus * SHEET.thickness**3 / 12
    ends = np.column_stack([rod.position[[0, -1]], rod.angle[[0, -1]]])
    units = np.array([1e3, 1.0, 1.0])

    def slope(s, state):
        _, _, angle, moment, right, up = state
        width = float(strip.width(s))
        turn = up * np.cos(angle) - right * np.sin(angle)
        weight = SHEET.density * 1e-9 * width * SHEET.thickness * G
        return [np.cos(angle), np.sin(angle), moment / (rigidity * width), turn, 0.0, -weight]

    def pieces(unknown, share):
        first = solve_ivp(slope, (0, MASS.at), [*ends[0], *(unknown * units)], **EXACT)
        state = first.y[:, -1] - [0, 0, 0, 0, 0, share * MASS.mass * 1e-3 * G]
        return first, solve_ivp(slope, (MASS.at, rod.length), state, **EXACT)

    def misses(unknown, share):
        return (pieces(unknown, share)[1].y[:3, -1] - ends[1]) * [1, 1, 100]

    unknown = np.array([rod.moment[0] * strip.bending_stiffness, *strip.reactions().start_force]) / units
    results = []
    for share in (1.0, 0.75, 0.5, 0.25, 0.0):
        solution = root(misses, unknown, args=(share,))
        assert solution.success, solution.message
        unknown, beam = solution.x, pieces(solution.x, share)
        s = np.concatenate([np.linspace(*piece.t[[0, -1]], 400) for piece in beam])
        states = np.concatenate([piece.sol(np.linspace(*piece.t[[0, -1]], 400)) for piece in beam], axis=1)
        results.append((states[:2].T, states[3] / (rigidity * strip.width(s))))
    return s, results[0], results[-1]


def test_the_empty_strip_is_the_beam_without_its_mass():
    strip = arch(28, ignore_limits=True)
    s, (drawn, loaded), (empty, bent) = shot(strip)
    half = SHEET.thickness / 2
    assert np.abs(drawn - strip.rod.curve.at(s).position).max() < 0.02
    assert strip.strains[0].largest == pytest.approx(half * np.abs(loaded).max(), rel=2e-3)
    strain = half * np.abs(bent).max()
    assert strain > 2 * strip.strains[0].largest
    assert strip.unloaded_strains[0].largest == pytest.approx(strain, rel=5e-3)
    assert strip.max_strain == strip.unloaded_strains[0].largest
    assert strip.max_strain_at == pytest.approx(s[np.abs(bent).argmax()], abs=3)
    moved = np.hypot(*(strip.unloaded.position - strip.rod.position).T).max()
    assert moved == pytest.approx(np.hypot(*(empty - drawn).T).max(), rel=0.01)
    report = report_strip(strip, name="arch", files={})["without_loads"]
    assert report["strain"] == pytest.approx(strain, rel=5e-3)
    assert report["strain_with_loads"] == pytest.approx(strip.strains[0].largest)
    assert report["moved"] == pytest.approx(moved)


def test_the_empty_strip_is_judged():
    strip = arch(28)
    assert strip.strain_verdict.unloaded
    assert not strip.strain_verdict.allowed
    assert strip.strain_verdict.percent == 139
    text = row(strip, "Strain")
    assert text == (
        "Without its loads, the strip is strained by 1.1 % at 190 mm from the start; test-ply allows 0.8 %: the "
        "material may crack there. Make the strip wider (max_width), or reduce its loads."
    )
    assert text in strip.warnings
    assert arch(28, replace(MASS, mass=200.0)).strain_verdict.allowed  # less load, as the message advises


def test_the_row_states_both_strains_of_a_strip_within_the_limit():
    strip = arch(45)
    assert strip.strain_verdict.allowed
    loaded, empty = (100 * layers[0].largest for layers in (strip.strains, strip.unloaded_strains))
    assert row(strip, "Strain") == (
        f"{empty:.2f} % at 190 mm from the start without the loads, {loaded:.2f} % with them; test-ply allows "
        "0.80 %"
    )
    assert row(strip, "Movement").startswith("without the loads, the strip moves by at most ")
    assert row(strip, "Movement").endswith(" from the start, to the left")


def test_an_empty_strip_that_would_break_is_refused_and_a_wider_one_suggested():
    with pytest.raises(StrainError, match="Without its loads, the strip is strained by") as refused:
        arch(26)
    spec = StripSpec(CURVE, SHEET, max_width=26, gravity=True, loads=(MASS,))
    widths = [item for item in suggest(spec, refused.value) if item.change.field == "max_width"]
    (suggestion,) = widths
    wider = arch(suggestion.change.value)
    rest = bend(wider.rod_to_bend, loads=())
    assert np.abs(rest.curvature).max() * SHEET.thickness / 2 <= SHEET.max_strain
    assert suggestion.used == wider.strain_verdict.percent <= 100


def test_a_width_suggested_for_a_load_also_suits_the_empty_strip():
    """The least width that carries the mass breaks without it."""
    spec = StripSpec(CURVE, SHEET, max_width=20, gravity=True, loads=(MASS,))
    with pytest.raises(ec.InputError, match="carries this load") as refused:
        spec.make()
    least = next(change for change in refused.value.refusal.changes if change.field == "max_width").value
    with pytest.raises(StrainError):
        arch(least)
    suggestion = next(item for item in suggest(spec, refused.value) if item.change.field == "max_width")
    assert suggestion.change.value > least
    assert arch(suggestion.change.value).strain_verdict.allowed


def snapped_arch():
    """Return a strip that a force holds in a shape that it leaves without the force."""
    curve = ec.PlaneCurve.arc((0, 0), 100, 0.9 * np.pi, 0.1 * np.pi)
    flat = ec.make_strip(curve, SHEET, max_width=20)
    rod = replace(flat.rod, bending_stiffness=flat.bending_stiffness)
    pushed = bend(rod, loads=[ec.PointForce(rod.length / 2, (0, -60))], settle=True)
    assert pushed.position[:, 1].min() < -10
    return ec.Strip(replace(pushed, warnings=()), SHEET, max_width=30)


def test_a_strip_that_snaps_without_its_loads_is_warned_of():
    strip = snapped_arch()
    warning = (
        "Without its loads, the strip snaps into another shape. Support the strip between its ends, or draw "
    )
    assert any(text.startswith(warning) for text in strip.warnings)


def test_a_strip_whose_empty_shape_is_not_found_is_warned_of(monkeypatch):
    def fail(*_args, **_fields):
        raise NotConvergedError("no equilibrium was found")

    monkeypatch.setattr(strip_module, "bend", fail)
    strip = arch(45)
    assert strip.unloaded is None
    assert (
        "The shape of the strip without its loads was not found. no equilibrium was found" in strip.warnings
    )


def test_only_strips_with_loads_are_bent_and_only_once(monkeypatch):
    calls = []

    def counted(*args, **fields):
        calls.append(fields)
        return bend(*args, **fields)

    monkeypatch.setattr(strip_module, "bend", counted)
    free = arch(45, None)
    assert (free.unloaded, free.unloaded_strains) == (None, ())
    strip_rows(free)
    assert not calls
    strip_rows(arch(45))
    assert len(calls) == 1
