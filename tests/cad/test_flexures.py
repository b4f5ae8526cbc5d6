"""Parts with two states as native bodies, unloaded and in each state, and as STEP files."""

import copy
import pickle

import build123d as bd
import cadquery as cq
import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.errors import InputError


@pytest.fixture(scope="module")
def part():
    arch = ec.PlaneCurve.spline([(0, 0), (40, 14), (100, 14), (140, 0)], degree=3)
    pair = ec.two_state_rod(arch, arch.transformed(np.diag([1.0, -1.0, 1.0])))
    return ec.Flexure(pair, "pom-2", label="clip")


@pytest.mark.parametrize("state", [None, "first", "second"])
def test_both_libraries_make_the_part_in_its_states(part, state):
    from elastica_cad.build123d import FlexurePart
    from elastica_cad.cadquery import flexure_solid

    ours, theirs = FlexurePart(part, state, mode=bd.Mode.PRIVATE), flexure_solid(part, state)
    # area of a strip of varying thickness along its centre line, which no bend changes, by sums; pads and holes
    s = np.linspace(-part.overhang(0.0), part.pair.length + part.overhang(part.pair.length), 20001)
    h = part.thickness_at(s)
    strip = float(((h[1:] + h[:-1]) / 2 * np.diff(s)).sum())
    pads = 2 * (part.pad.length * part.pad_width - 2 * np.pi * part.pad.hole**2 / 4)
    assert ours.volume == pytest.approx((strip + pads) * 2, rel=2e-3)  # fillets fill as much as corners lose
    assert theirs.Volume() == pytest.approx(ours.volume, rel=1e-6)
    assert ours.is_valid
    assert theirs.isValid()
    assert (ours.state, theirs.state, ours.label, theirs.label) == (state, state, "clip", "clip")
    assert ours.flexure is theirs.flexure is part
    for name in ("start", "end", "hole1", "hole2", "hole3", "hole4"):
        here, there = tuple(ours.joints[name].location.position), theirs.joints[name].toTuple()[0]
        assert here == pytest.approx(there, abs=1e-9)
    places = [theirs.joints[f"hole{k}"].toTuple()[0][:2] for k in (1, 2, 3, 4)]
    first, _, last = np.hypot(*np.diff(np.array(places), axis=0).T)
    assert (first, last) == pytest.approx((part.pad.length - 2 * part.pad.inset,) * 2)


def test_another_state_keeps_the_place_of_the_first_pad(part):
    from elastica_cad.build123d import FlexurePart
    from elastica_cad.cadquery import flexure_solid

    ours = FlexurePart(part, "first", color="red", mode=bd.Mode.PRIVATE).moved(
        bd.Pos(5, 6, 7) * bd.Rot(20, 30, 40)
    )
    theirs = flexure_solid(part, "first", color=cq.Color("red")).moved(cq.Location((5, 6, 7), (1, 2, 3), 40))
    ours, theirs = copy.copy(ours), pickle.loads(pickle.dumps(theirs))
    for name, moved in (("start", False), ("end", True)):
        places = [tuple(body.joints[name].location.position) for body in (ours, ours.in_state("second"))]
        others = [body.joints[name].toTuple()[0] for body in (theirs, theirs.in_state("second"))]
        for before, after in (places, others):
            assert (np.abs(np.subtract(before, after)).max() > 1.0) == moved
            assert moved or before == pytest.approx(after, abs=1e-9)
    assert tuple(ours.in_state(None).color)[:3] == pytest.approx((1, 0, 0))
    mirrored = flexure_solid(part, "first").mirror("YZ")
    assert mirrored.joints["end"].toTuple()[0][0] == pytest.approx(-part.rods[0].position[-1, 0], abs=2.0)


def test_state_is_requested_by_name(part):
    from elastica_cad.cadquery import flexure_solid

    with pytest.raises(InputError, match='Use "first", "second", or None'):
        flexure_solid(part, "up")
    with pytest.raises(InputError, match="a Flexure"):
        flexure_solid(part.pair)


def test_saved_as_step_and_dxf(part, tmp_path):
    assert ec.save(part, tmp_path / "clip.dxf").stat().st_size > 1000
    for state in (None, "second"):
        file = ec.save(part, tmp_path / f"clip-{state}.step", state=state)
        (solid,) = cq.importers.importStep(str(file)).solids().vals()
        assert solid.Volume() == pytest.approx(part.solid_in(state).volume, rel=1e-4)


def test_in_each_state_the_ends_are_on_the_drawn_curve():
    """The part in its second state began along the first one, so its end was elsewhere."""
    from elastica_cad.build123d import FlexurePart
    from elastica_cad.cadquery import flexure_solid

    arch = ec.PlaneCurve.spline([(0, 0), (39, 13), (117, 13), (156, 0)], degree=3)
    down = arch.transformed([[1, 0, 4], [0, -1, 7], [0, 0, 1]])
    flexure = ec.Flexure(ec.two_state_rod(arch, down), "pom-2")
    for state, drawn in (("first", arch), ("second", down)):
        ours, theirs = FlexurePart(flexure, state, mode=bd.Mode.PRIVATE), flexure_solid(flexure, state)
        for name, end in zip(("start", "end"), drawn.evaluate(np.array(drawn.domain)), strict=True):
            for place in (tuple(ours.joints[name].location.position), theirs.joints[name].toTuple()[0]):
                # the inner edge of the pad is just beyond the end of the curve
                assert np.hypot(*(end - place[:2])) == pytest.approx(flexure.overhang(0.0), rel=1e-3)
