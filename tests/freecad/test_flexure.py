"""Parts with two states: properties, shapes, results, cutting files, and the command by mouse."""

import numpy as np
import Part
import pytest
from freecad.elastica_wb.cutting_files import write_cutting_files
from freecad.elastica_wb.features import flexure

from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.pairs import FlexureSpec

from . import launching
from .features import change, new

UP = [(15, 75), (57, 75), (87, 102), (126, 102), (162, 102), (201, 75), (240, 75)]
DOWN = [(15, 51), (51, 51), (81, 27), (120, 27), (162, 27), (204, 51), (240, 51)]


@pytest.fixture
def part(document, drawn):
    return new(flexure.create, document, drawn(UP, 3), (), drawn(DOWN, 3), ())


def test_a_part_of_two_sketches_is_that_of_the_core(part):
    assert (part.State, part.Sheet, part.Bistable) == (["Up-to-date"], "pom-2", True)
    first, second = (PlaneCurve.spline(points, degree=3) for points in (UP, DOWN))
    made = FlexureSpec(first, second, "pom-2").make()
    assert part.LargestForce == pytest.approx(made.travel.largest_force, rel=1e-3)
    assert part.ThinnestPlace.Value == pytest.approx(made.thickness_range[0], rel=1e-4)
    assert len(part.Shape.Solids) == 4
    volumes = {}
    for form in flexure.FORMS[1:]:
        change(part, Form=form)
        (solid,) = part.Shape.Solids
        assert solid.isValid()
        volumes[form] = solid.Volume
    assert volumes["As cut"] == pytest.approx(made.solid.volume, rel=1e-4)
    for state in ("First state", "Second state"):  # sharp roots in place of fillets
        assert volumes[state] == pytest.approx(volumes["As cut"], rel=0.01)
    assert volumes["Holder"] > 5 * volumes["As cut"]


def test_both_states_have_their_ends_in_the_holder(part):
    change(part, Form="Holder")
    holder = part.Shape.copy()
    places = [edge.Curve.Center for edge in holder.Edges if isinstance(edge.Curve, Part.Circle)]
    radius = part.PadHole.Value / 2
    holes = {(round(p.x, 1), round(p.y, 1)) for p in places if p.z > -1e-6}
    for state in ("First state", "Second state"):
        change(part, Form=state)
        centres = [
            edge.Curve.Center for edge in part.Shape.Edges
            if isinstance(edge.Curve, Part.Circle) and abs(edge.Curve.Radius - radius) < 1e-6
        ]  # fmt: skip
        for centre in centres:
            assert min(abs(centre.x - x) + abs(centre.y - y) for x, y in holes) < 0.15


def test_options_of_the_core_are_properties(part):
    part.PadWidth, part.EngravedText, part.RatioLimit = 14, "CLIP", 40
    spec = flexure.spec_of(part)
    assert (spec.pad.width, spec.label, spec.free, spec.limits.ratio) == (14, "CLIP", None, 40)
    change(part, PadLength=5)
    assert "two holes" in part.Reasons[0]
    assert part.Verdict == "There is no part."


def is_grey(part, name):
    return "ReadOnly" in part.getEditorMode(name)


def test_the_aim_is_grey_and_without_effect_beside_a_free_state(part):
    change(part, LeastThickness=0.6, Anyway=True)
    assert not is_grey(part, "Objective")
    change(part, Free="first", Objective="thickness")
    shape = part.Shape.Volume
    change(part, Objective="ratio")
    assert (part.State, is_grey(part, "Objective")) == (["Up-to-date"], True)
    assert part.Shape.Volume == pytest.approx(shape)
    change(part, Free="none")
    assert not is_grey(part, "Objective")


def test_the_place_of_the_push_is_grey_where_nothing_is_pushed(part, document, drawn):
    assert not is_grey(part, "PushAt")
    steep, low = (
        [(0, 0), (40, 0), (62, 22), (72, 52), (89, 99)],
        [(0, 0), (40, 0), (66, 15), (90, 40), (122, 72)],
    )
    stand = new(flexure.create, document, drawn(steep, 4), (), drawn(low, 4), ())
    change(stand, LeastThickness=2, Anyway=True, PushAt=50, PadLength=22)
    assert stand.State == ["Up-to-date"], list(stand.Reasons)
    assert is_grey(stand, "PushAt")
    assert any("moved between two positions" in reason for reason in stand.Reasons)


@pytest.mark.campaign
def test_a_part_is_cut_with_its_holder(part, tmp_path):
    change(part, EngravedText="CLIP")
    files = {path.name for path in write_cutting_files([part], tmp_path, kinds=("svg", "step", "csv"))}
    assert "cut-list.csv" in files
    assert any(name.startswith("CLIP-holder") for name in files)
    assert len([name for name in files if name.endswith(".svg")]) == 2
    (step,) = (name for name in files if name.endswith(".step"))
    assert len(Part.read(str(tmp_path / step)).Solids) == 4
    (curve,) = (name for name in files if name.endswith("-travel.csv"))
    table = np.genfromtxt(tmp_path / curve, delimiter=",", names=True)
    assert table.dtype.names == ("travel_mm", "force_N", "energy_Nmm", "largest_strain")
    until = table["travel_mm"] <= part.SnapTravel.Value
    assert table["force_N"][until].max() == pytest.approx(part.LargestForce, rel=1e-6)
    force, energy = table["force_N"], table["energy_Nmm"]
    work = np.sum((force[1:] + force[:-1]) / 2 * np.diff(table["travel_mm"]))
    assert work == pytest.approx(energy[-1] - energy[0], abs=0.02 * energy.max())


@pytest.mark.campaign
def test_a_clip_by_mouse(tmp_path):
    found = launching.run_window("flexure.py", tmp_path)
    assert "two curves" in found["one curve"]
    state, verdict, reasons, bistable, sheet = found["made"]
    assert (state, reasons, bistable, sheet) == (["Up-to-date"], [], True, "pom-2")
    assert "snaps between them" in verdict
    assert "snaps over at about" in found["rows"]
    assert found["chart"][0]
    assert found["chart"][1] > 100
    assert all(value > 0 for value in found["force"])
    assert found["solids"] == 4
    assert found["wider pads"] == [["Up-to-date"], 14]
    assert found["as cut"] == [1, True]
    assert found["closed"] == ["Up-to-date"]
    state, before, after = found["moved"]
    assert (state, after) == (["Up-to-date"], pytest.approx(before))
    assert len(found["pieces"]) == 2
    assert len(found["files"]) == 7
    assert found["refused"][1] == "There is no part."
    assert "mm long" in found["refused"][2]
    assert found["cancelled"] == ["Flexure"]
    assert found["saved"]
