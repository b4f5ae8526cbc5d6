"""Displacement of a strip by errors in mounting its rails, pins and ties, beside strips that are bent so."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.errors import InputError
from elastica_cad.mechanics.mounting_errors import displacements_per_mm, spare_pieces

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)


def moved(rod, between):
    changes = [ec.bend(rod, between=elements).position for elements in between]
    return np.hypot(*(changes[0] - changes[1]).T).max()


def place(rod, i):
    return rod.curve.at(rod.between[i].s).position[0], rod.curve.at(rod.between[i].s).angle[0]


@pytest.mark.parametrize("end", [ec.End(), ec.End(x=False)])
def test_a_rail_that_is_moved_along_its_normal(end):
    slots = ec.Rail(120, one_sided=False), ec.Rail(200, one_sided=False)
    rod = ec.optimal_rod(WAVE, between=slots, supports=ec.Supports(end=end), samples=201)
    point, angle = place(rod, 1)
    normal = np.array([-np.sin(angle), np.cos(angle)])
    rails = [(slots[0], ec.Rail(tuple(point + off * normal), one_sided=False)) for off in (0.01, -0.01)]
    assert displacements_per_mm(rod)[1] == pytest.approx(moved(rod, rails) / 0.02, rel=1e-3)


def test_a_pin_in_its_worst_direction_and_a_shorter_cord():
    rod = ec.optimal_rod(WAVE, between=(ec.Pin(200), ec.Tie(40, 310)), samples=201)
    point, _ = place(rod, 0)
    length = np.hypot(*np.diff(rod.curve.at(rod.between[1].s).position, axis=0)[0])
    pin, tie = displacements_per_mm(rod)
    ties = [(ec.Pin(200), ec.Tie(40, 310, length=length + off)) for off in (0, -0.02)]
    assert tie == pytest.approx(moved(rod, ties) / 0.02, rel=2e-3)
    turns = np.radians(np.arange(0, 180, 15))
    worst = max(
        moved(rod, [(ec.Pin(tuple(point + off * d)), ec.Tie(40, 310)) for off in (0.01, -0.01)]) / 0.02
        for d in np.column_stack([np.cos(turns), np.sin(turns)])
    )
    assert worst <= pin * (1 + 2e-3)
    assert worst == pytest.approx(pin, rel=0.02)  # directions in steps of 15 degrees


def test_an_even_bow_with_a_shorter_cord():
    flat = ec.Rod.straight(500.0, samples=201)
    bent = ec.bend(flat, end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned"))
    bow = ec.optimal_rod(bent.curve, supports=ec.Supports("free", "free"), between=ec.Tie(0, bent.length))
    first, second = (
        ec.bend(flat, end=(chord, 0.0), supports=ec.Supports("pinned", "pinned")) for chord in (400.5, 399.5)
    )
    rise = second.position[:, 1].max() - first.position[:, 1].max()
    (per_mm,) = displacements_per_mm(bow)
    assert rise <= per_mm <= 2 * rise


def test_a_rail_without_force_moves_nothing():
    rod = ec.optimal_rod(WAVE, between=(ec.Rail(200), ec.Tie(40, 310)), samples=201)
    length = np.hypot(*np.diff(rod.curve.at(rod.between[1].s).position, axis=0)[0])
    slack = ec.bend(rod, between=(ec.Rail(200), ec.Tie(40, 310, length=length + 60)))
    moves = displacements_per_mm(slack)
    assert [bool(move) for move in moves] == [bool(np.any(action.force)) for action in slack.between]
    assert 0.0 in moves


def test_a_slack_cord_does_not_move_the_strip():
    """The program leaves this cord a force of the size of rounding errors."""
    assert (
        displacements_per_mm(ec.optimal_rod(WAVE, between=(ec.Pin(200), ec.Tie(180, 220)), samples=201))[1]
        == 0
    )


@pytest.mark.parametrize("at", [345, 350])
def test_a_pin_beside_an_almost_straight_piece_reaches_as_far_as_its_spare_length(at):
    rod = ec.optimal_rod(WAVE, between=(ec.Rail(200), ec.Pin(at)), samples=201)
    rail, pin = spare_pieces(rod)
    assert rail is None
    assert (pin.start, pin.end) == (at, rod.length)
    assert 0.1 < pin.spare < 0.5
    point, end = (rod.curve.at(np.array([s])).position[0] for s in (pin.start, pin.end))
    outward = (point - end) / np.hypot(*(point - end))

    def with_error(error):
        return ec.bend(rod, between=(ec.Rail(200), ec.Pin(tuple(point + error * outward))))

    with_error(0.9 * pin.spare)
    with pytest.raises(InputError, match="apart, but"):
        with_error(1.1 * pin.spare)
