"""A strip whose end slides: a joint for what rides on it, the strip on the way, and an animation of both."""

import json
import pickle
import struct
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import Frame, InputError, Laminated, Strip, bend, stability
from elastica_cad.kernel import occt
from elastica_cad.kernel.end_travel import Travel, skin_meshes
from elastica_cad.strip import BentSolid
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

END = (118.0, 9.0)


def frames_of(path):
    """Of every mesh of an animated GLB its times, points (frames, n, 3) and triangles, as viewers show them."""
    data = path.read_bytes()
    assert data[:4] == b"glTF"
    assert struct.unpack("<I", data[8:12])[0] == len(data)
    size = struct.unpack("<I", data[12:16])[0]
    text, binary = json.loads(data[20 : 20 + size]), data[28 + size :]

    def values(number):
        accessor = text["accessors"][number]
        view = text["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        rows = np.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"])
        return rows.reshape(-1, width).squeeze()

    (animation,) = text["animations"]
    found = {}
    for node, sampler in zip(text["nodes"], animation["samplers"], strict=True):
        skin = text["meshes"][node["mesh"]]["primitives"][0]
        base = values(skin["attributes"]["POSITION"])
        targets = np.array([values(target["POSITION"]) for target in skin["targets"]])
        times = values(sampler["input"])
        weights = values(sampler["output"]).reshape(len(times), -1)
        local = 1000 * (base + np.einsum("ft,tnk->fnk", weights, targets)) * node["scale"][0]
        found[node["name"]] = times, local, values(skin["indices"]).reshape(-1, 3)
    return found


def enclosed(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return (a * np.cross(b, c)).sum() / 6


@pytest.mark.campaign
def test_an_animation_shows_the_strip_on_its_way(arch_strip, measure, tilted, tmp_path):
    travel = Travel(arch_strip, tilted, END)
    travel.write_glb(tmp_path / "arch.glb", frames=7, seconds=3.0)
    with pytest.raises(InputError, match="exists already"):
        travel.write_glb(tmp_path / "arch.glb")
    ((name, (times, points, triangles)),) = frames_of(tmp_path / "arch.glb").items()
    assert (name, len(times), times[-1]) == ("arch", 13, 3.0)
    assert points[0] == pytest.approx(points[-1])
    volume = arch_strip.area * arch_strip.sheet.thickness
    for frame, rod in ((0, arch_strip.rod), (3, travel.rods(7)[3]), (6, bend(arch_strip.rod, end=END))):
        shown = points[frame]
        assert enclosed(shown, triangles) == pytest.approx(volume, rel=1e-3)
        body = occt.make_solid(BentSolid.of(replace(arch_strip, rod=rod), tilted))
        assert measure.distance(body, shown[::40]) < 0.02


def test_the_sheets_of_a_laminate_move_together(plain, tmp_path):
    strip = Strip(
        plain.rod, plain.sheet, style=Laminated(width=24.0, backing=plain.sheet, least_backing=0.2), label="L"
    )
    Travel(strip, Frame(), END).write_glb(tmp_path / "laminate.glb", frames=3)
    assert list(frames_of(tmp_path / "laminate.glb")) == ["L", "L backing"]


def test_normals_point_outward(arch_strip):
    (skin,) = skin_meshes(arch_strip)
    points, normals = skin.bent(arch_strip.rod, Frame())
    inside = enclosed(points - 0.01 * normals, skin.triangles)
    assert inside < enclosed(points, skin.triangles) < enclosed(points + 0.01 * normals, skin.triangles)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1)


def test_shapes_on_the_way(arch_strip):
    travel = Travel(arch_strip, Frame(), END)
    for position in (0.0, 7.3, travel.length):
        rod = travel.rod(position)
        share = position / travel.length
        wanted = (1 - share) * arch_strip.rod.position[-1] + share * np.array(END)
        assert rod.position[-1] == pytest.approx(wanted, abs=1e-6)
        assert rod.angle[-1] == pytest.approx(arch_strip.rod.angle[-1])
        assert stability(rod).stable


@pytest.mark.parametrize(
    ("ask", "says"),
    [
        (lambda strip: Travel(strip, Frame(), (1e4, 0)), "Choose a nearer point"),
        (lambda strip: Travel(strip, Frame(), strip.rod.position[-1]), "already in this position"),
        (lambda strip: Travel(strip, Frame(), 3.0), "two numbers"),
        (lambda strip: Travel(strip, Frame(), "60"), "two numbers"),
        (lambda strip: Travel(strip, Frame()), "but not both"),
        (lambda strip: Travel(strip, Frame(), angle=strip.rod.angle[-1]), "already in this position"),
        (
            lambda strip: Travel(strip, Frame(), angle=strip.rod.angle[-1] + 0.2).rod(20.0),
            "20 degrees, outside the travel",
        ),
        (lambda strip: Travel(strip, Frame(), END).rod(99.0), "outside the travel"),
        (lambda strip: Travel(strip, Frame(), END).rods(1), "2 or more"),
    ],
)
def test_one_sentence(arch_strip, ask, says):
    with pytest.raises(InputError, match=says):
        ask(arch_strip)


TILTED = ((5, -7, 11), (20, 30, 40))


@pytest.mark.build123d
@pytest.mark.parametrize("turn", [-25.0, 30.0])
def test_a_hub_turns_with_the_end_in_build123d(arch_strip, turn):
    rib = bd.Location(*TILTED) * bd_strips.BentStrip(arch_strip, plane=bd.Plane.XZ)
    slider = rib.slider(angle=np.degrees(arch_strip.rod.angle[-1]) + turn)
    assert slider.angular_range == pytest.approx((0, abs(turn)))
    hub = bd.Box(8, 30, 8)
    bd.RigidJoint("axle", hub)
    for angle in (0.0, 12.5, abs(turn)):
        slider.connect_to(hub.joints["axle"], angle=angle)
        end = slider.bent(angle).joints["end"].location
        sits = hub.joints["axle"].location
        assert (end.position - sits.position).length < 1e-6
        assert bd.Plane(sits).x_dir.dot(bd.Plane(end).x_dir) == pytest.approx(1, abs=1e-9)
        start = slider.bent(angle).joints["start"].location
        assert (start.position - rib.joints["start"].location.position).length < 1e-6


@pytest.mark.cadquery
@pytest.mark.parametrize("turn", [-25.0, 30.0])
def test_a_hub_turns_with_the_end_in_cadquery(arch_strip, turn):
    rib = cq_strips.bent_strip(arch_strip, plane=cq.Plane.XZ()).rotate((0, 0, 0), (1, 1, 0), 50)
    slider = rib.slider(angle=np.degrees(arch_strip.rod.angle[-1]) + turn)
    for angle in (0.0, abs(turn)):
        end, place = slider.bent(angle).joints["end"], slider.place(angle)
        assert (cq.Vector(*place.toTuple()[0]) - cq.Vector(*end.toTuple()[0])).Length < 1e-6
        assert cq.Plane(place).xDir.dot(cq.Plane(end).xDir) == pytest.approx(1, abs=1e-9)


@pytest.mark.build123d
def test_a_carriage_rides_in_build123d(arch_strip, tmp_path):
    rib = bd.Location((5, -7, 11), (20, 30, 40)) * bd_strips.BentStrip(arch_strip, plane=bd.Plane.XZ)
    slider = rib.slider(END)
    carriage = bd.Box(8, 30, 8)
    bd.RigidJoint("foot", carriage, bd.Location((0, 0, 4)))
    assert rib.joints["slider"] is slider
    hinge = rib.slider(angle=float(np.degrees(rib.rod.angle[-1])) + 5)
    assert (rib.joints["slider"], rib.joints["slider2"]) == (slider, hinge)
    for position in (0.0, 12.5, slider.linear_range[1]):
        slider.connect_to(carriage.joints["foot"], position=position)
        rides = carriage.joints["foot"].location.position
        body = slider.bent(position)
        assert (body.joints["end"].location.position - rides).length < 1e-6
        assert (body.joints["start"].location.position - rib.joints["start"].location.position).length < 1e-6
        assert body.volume == pytest.approx(rib.volume, rel=1e-4)
    bd.RigidJoint("wall", (wall := bd.Pos(90, 0, 0) * bd.Box(5, 5, 5))).connect_to(rib.joints["start"])
    joined = slider.bent(12.5).joints["start"].location.position
    assert (joined - wall.joints["wall"].location.position).length < 1e-6
    assert (joined - rib.joints["start"].location.position).length < 1e-6
    slider.write_glb(tmp_path / "rib.glb", frames=3)
    assert "arch" in frames_of(tmp_path / "rib.glb")
    with pytest.raises(InputError, match=r"\.bent\(\) first"):
        rib.flat.slider(END)


@pytest.mark.cadquery
def test_a_carriage_rides_in_cadquery(arch_strip, tmp_path):
    rib = cq_strips.bent_strip(arch_strip, plane=cq.Plane.XZ()).rotate((0, 0, 0), (1, 1, 0), 50)
    slider = rib.slider(END)
    carriage = cq.Workplane().box(8, 30, 8)
    carriage.faces(">Z").tag("top")
    for position in (0.0, 12.5):
        body = slider.bent(position)
        end = cq.Vector(*body.joints["end"].toTuple()[0])
        assert (cq.Vector(*slider.place(position).toTuple()[0]) - end).Length < 1e-6
        made = cq.Assembly(body, name="rib").add(carriage, name="carriage", loc=cq.Location((5, 5, 5)))
        made.constrain("rib", "Fixed")
        slider.constrain(made, "carriage?top", position).solve()
        rides = made.objects["carriage"].loc
        assert (cq.Vector(*(rides * cq.Location((0, 0, 4))).toTuple()[0]) - end).Length < 1e-3
        across = cq.Plane(rides).zDir
        assert abs(across.dot(cq.Plane(slider.place(0)).zDir)) == pytest.approx(1, abs=1e-4)
    slider.write_glb(tmp_path / "rib.glb", frames=3)
    assert "arch" in frames_of(tmp_path / "rib.glb")
    with pytest.raises(InputError, match=r"\.bent\(\) first"):
        rib.flat.slider(END)


@pytest.mark.cadquery
def test_a_carriage_stays_on_its_path_in_cadquery(arch_strip):
    slider = cq_strips.bent_strip(arch_strip).slider(end=END)
    for position in (-1.0, 1.01 * slider.travel.length, 1000.0):
        with pytest.raises(InputError, match="outside the travel"):
            slider.place(position)
        with pytest.raises(InputError, match="outside the travel"):
            slider.constrain(cq.Assembly(), "carriage", position)


def shown_color(path):
    """The linear colour of the first material of a file."""
    content = path.read_bytes()
    header = json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")])
    return header["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"]


@pytest.mark.build123d
def test_a_rib_with_a_joint_is_pickled_and_its_animation_has_its_color(arch_strip, tmp_path):
    rib = bd_strips.BentStrip(arch_strip, mode=bd.Mode.PRIVATE)
    rib.slider(END)
    other = pickle.loads(pickle.dumps(rib))
    slider = other.joints["slider"]
    assert slider.parent is other
    assert slider.travel.length == rib.joints["slider"].travel.length
    assert slider.bent(5).volume == pytest.approx(rib.volume, rel=1e-4)
    other.color = bd.Color(1, 0, 0)
    slider.write_glb(tmp_path / "rib.glb", frames=2)
    assert shown_color(tmp_path / "rib.glb") == pytest.approx([1, 0, 0, 1], abs=1e-6)
    turned = pickle.loads(
        pickle.dumps(bd_strips.BentStrip(arch_strip, mode=bd.Mode.PRIVATE).slider(angle=-70))
    )
    assert turned.travel.angle == pytest.approx(np.radians(-70))


@pytest.mark.cadquery
def test_an_animation_in_cadquery_has_the_color_of_the_rib(arch_strip, tmp_path):
    rib = cq_strips.bent_strip(arch_strip, color=cq.Color(1, 0, 0))
    rib.slider(END).write_glb(tmp_path / "rib.glb", frames=2)
    assert shown_color(tmp_path / "rib.glb") == pytest.approx([1, 0, 0, 1], abs=1e-6)
