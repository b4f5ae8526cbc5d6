"""Mesh files: units, wrong files, what is missing."""

import sys

import numpy as np
import pytest

from elastica_cad import InputError, MissingDependencyError
from elastica_cad.formats import read_mesh

TENT = "v 0 0 0\nv 90 0 0\nv 90 90 50\nv 0 90 50\nf 1 2 3 4\n"
STL = (
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 40 0 0\nvertex 0 40 0\nendloop\nendfacet\n"
    "endsolid s\n"
)
PLY = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n40 0 0\n0 40 0\n3 0 1 2\n"
)


def written(folder, name, text):
    file = folder / name
    file.write_text(text)
    return file


@pytest.mark.parametrize(
    ("name", "text", "faces"), [("a.obj", TENT, 2), ("a.stl", STL, 1), ("a.PLY", PLY, 1)]
)
def test_three_formats(tmp_path, name, text, faces):
    mesh = read_mesh(written(tmp_path, name, text))
    assert len(mesh.faces) == faces
    assert np.ptp(mesh.vertices[:, 0]) in (90, 40)


def test_negative_indices_count_back_from_their_line(tmp_path):
    walls = [
        "v 0 0 0\nv 30 0 0\nvt 0 0\nv 30 0 9\nv 0 0 9\nf -4/-1 -3/-1 -2/-1 -1/-1",
        "v 0 50 0\nv 0 80 0\nv 0 80 9\nf -3 -2 -1",
    ]
    mesh = read_mesh(written(tmp_path, "walls.obj", "\n".join([*walls, "f 1 2 5"])), unit="mm")
    triangles = np.sort(mesh.vertices[mesh.faces].mean(axis=1), axis=0)
    assert len(mesh.faces) == 4
    assert triangles[:, 1].tolist() == pytest.approx([0, 0, 50 / 3, 70])


def test_a_broken_mesh_is_one_sentence_and_nothing_else(tmp_path, capfd):
    for size in (90, 130, 200):
        file = tmp_path / "a.stl"
        file.write_bytes((bytes(80) + b"\xff\xff\x00\x00" + bytes(300))[:size])
        with pytest.raises(InputError) as refused:
            read_mesh(file)
        assert "\n" not in str(refused.value)
    assert capfd.readouterr() == ("", "")


def test_metres_are_requested(tmp_path):
    small = TENT.replace("90", "0.9").replace("50", "0.5")
    file = written(tmp_path, "tent.obj", small)
    with pytest.raises(InputError, match=r"tent\.obj: is 1\.37 .* --unit m .*\(m: 1367 mm\)"):
        read_mesh(file)
    with pytest.raises(InputError, match=r"is 13\.7 .*\(cm: 136\.7 mm, in: 347\.3 mm, m: 1\.367e\+04 mm\)"):
        read_mesh(file, scale=10)
    with pytest.raises(InputError, match=r"scale of .* set a number above 0"):
        read_mesh(file, scale=0)
    assert np.ptp(read_mesh(file, unit="m").vertices[:, 0]) == pytest.approx(900)
    with pytest.raises(InputError, match="unknown unit"):
        read_mesh(file, unit="furlong")


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.off", TENT, "but mesh files end in"),
        ("a.obj", "v 0 0 0\nv 1 0 0\n", "a.obj"),
        ("a.stl", "nonsense", "a.stl"),
        ("a.ply", "ply\nnonsense", "a.ply"),
        ("a.obj", "", "empty"),
    ],
)
def test_wrong_files(tmp_path, name, text, words):
    with pytest.raises(InputError, match=words):
        read_mesh(written(tmp_path, name, text))


def test_without_trimesh(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(MissingDependencyError, match="pip install trimesh"):
        read_mesh(written(tmp_path, "a.obj", TENT))


def test_a_damaged_mesh_is_refused_without_words_of_python(tmp_path):
    file = written(tmp_path, "a.obj", "v 0 0 0\nv 9 0 0\nv 9 9 5\nf 1 2 ..\n")
    with pytest.raises(InputError, match=r"a\.obj: is not a readable OBJ mesh: export the mesh again$"):
        read_mesh(file, unit="mm")
