"""Bodies that move, in GLB files, read by the letter of glTF 2.0."""

import json
import struct

import numpy as np
import pytest

from elastica_cad.formats.animated_glb import MovingMesh, encode_animation

pytestmark = pytest.mark.core

COLUMNS = {"SCALAR": 1, "VEC3": 3}
KINDS = {5126: "<f4", 5125: "<u4"}
"""Component types of glTF: float and unsigned int."""


@pytest.fixture(scope="module")
def meshes():
    """A flap that folds up in three frames, and a plate that stays."""
    flap = np.zeros((3, 4, 3))
    flap[:, :, :2] = [(0, 0), (40, 0), (40, 30), (0, 30)]
    flap[1, 2:, 2], flap[2, 2:, 2] = 10, 25
    normals = np.tile([0.0, 0.0, 1.0], (3, 4, 1))
    normals[2, 2:] = (0, -0.6, 0.8)
    corners = np.array([[0, 1, 2], [0, 2, 3]])
    return (
        MovingMesh("flap", (1.0, 0.5, 0.0), flap, normals, corners),
        MovingMesh("plate", (0.0, 0.02, 1.0), flap[[0, 0, 0]] - 5, normals[[0, 0, 0]], corners),
    )


@pytest.fixture(scope="module")
def read(meshes):
    """The table of contents of the file, and a function that gives the numbers of one of its accessors."""
    data = encode_animation(meshes, 2.0)
    magic, version, whole = struct.unpack("<4sII", data[:12])
    assert (magic, version, whole) == (b"glTF", 2, len(data))
    size, kind = struct.unpack("<I4s", data[12:20])
    assert kind == b"JSON"
    content = json.loads(data[20 : 20 + size])
    rest = data[20 + size :]
    length, kind = struct.unpack("<I4s", rest[:8])
    assert kind == b"BIN\0"
    assert size % 4 == length % 4 == 0
    assert len(rest) == 8 + length

    def numbers(place):
        about = content["accessors"][place]
        view = content["bufferViews"][about["bufferView"]]
        first = 8 + view["byteOffset"]
        found = np.frombuffer(rest[first : first + view["byteLength"]], dtype=KINDS[about["componentType"]])
        found = found.reshape(about["count"], COLUMNS[about["type"]])
        if "min" in about:
            assert found.min(axis=0).tolist() == about["min"]
            assert found.max(axis=0).tolist() == about["max"]
        return found.squeeze()

    return content, numbers


def test_every_frame_is_where_it_was_drawn(meshes, read):
    content, numbers = read
    for mesh, shape in zip(meshes, content["meshes"], strict=True):
        (skin,) = shape["primitives"]
        assert shape["name"] == mesh.name
        assert numbers(skin["indices"]).tolist() == mesh.triangles.ravel().tolist()
        for name, wanted in (("POSITION", mesh.points), ("NORMAL", mesh.normals)):
            first = numbers(skin["attributes"][name])
            shapes = [first, *(first + numbers(target[name]) for target in skin["targets"])]
            assert np.array(shapes) == pytest.approx(wanted, abs=1e-5)
        assert shape["weights"] == [0.0] * (len(mesh.points) - 1)


def test_viewers_are_reported_what_is_corners_and_what_is_triangles(read):
    content, _ = read
    (skin,) = content["meshes"][0]["primitives"]
    views = [
        content["accessors"][place]["bufferView"]
        for place in (skin["attributes"]["POSITION"], skin["indices"])
    ]
    assert [content["bufferViews"][view]["target"] for view in views] == [34962, 34963]


def test_frames_come_one_after_the_other_and_go_back(read):
    content, numbers = read
    (film,) = content["animations"]
    for node, channel in enumerate(film["channels"]):
        sampler = film["samplers"][channel["sampler"]]
        assert channel["target"] == {"node": node, "path": "weights"}
        assert numbers(sampler["input"]) == pytest.approx([0, 0.5, 1.0, 1.5, 2.0])
        keys = numbers(sampler["output"]).reshape(5, 2)
        assert keys.tolist() == [[0, 0], [1, 0], [0, 1], [1, 0], [0, 0]]


def test_what_is_up_in_the_drawing_is_up_in_the_viewer_and_in_metres(read):
    content, _ = read
    for node in content["nodes"]:
        x, y, z, w = node["rotation"]
        turn = np.array([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x**2 + y**2)])  # of (0, 0, 1)
        assert turn == pytest.approx([0, 1, 0], abs=1e-12)
        assert node["scale"] == [0.001] * 3
    assert content["scenes"][content["scene"]]["nodes"] == [0, 1]


def test_colours_are_those_of_the_screen(read):
    """sRGB to linear by IEC 61966-2-1: half grey is 0.214, the darkest tones are divided by 12.92."""
    content, _ = read
    paint = [one["pbrMetallicRoughness"]["baseColorFactor"] for one in content["materials"]]
    assert paint[0] == pytest.approx([1.0, 0.214041, 0.0, 1.0], abs=1e-5)
    assert paint[1] == pytest.approx([0.0, 0.02 / 12.92, 1.0, 1.0], abs=1e-9)
