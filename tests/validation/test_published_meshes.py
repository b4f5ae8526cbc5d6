"""Sections of the published meshes: the Flower Pot's 16 polylines, the Shell's ten strips."""

import json

import numpy as np
import pytest

from elastica_cad import Frame
from elastica_cad.form_finding import mesh_sections, radial_planes, section_curves
from elastica_cad.formats import read_mesh

UNIT = 60.0  # mm per mesh unit


@pytest.fixture(scope="module")
def pot(reference_data):
    file = reference_data / "hafner" / "flower-pot" / "flower-pot.obj"
    return read_mesh(file, unit="m").scaled(1e-3)


@pytest.fixture(scope="module")
def published(reference_data):
    return json.loads((reference_data / "reference" / "flower_pot.json").read_text())["curves"]


def test_the_flower_pot_meets_the_published_polylines(pot, published):
    """They cut the mesh moved by 0.001 in all directions: the same mesh here, every point of theirs is found."""
    for record in published:
        frame = Frame(record["frame_origin_3d"], *record["frame_axes_3d"])
        (section,) = mesh_sections(pot.vertices + 0.001, pot.faces, [frame])
        theirs = np.array(record["mesh_polyline"])
        gaps = [np.linalg.norm(line.points[:, None] - theirs[None], axis=2) for line in section.lines]
        ours = min(gaps, key=lambda gap: gap.min(axis=0).max())
        assert ours.min(axis=0).max() < 2e-8  # of the mesh unit: theirs are written with 9 digits


def test_the_flower_pot_as_it_is(pot, published):
    """Not moved, planes through its vertices: one line a half plane, no false inflection left."""
    planes = radial_planes((0, 0, 0), (0, 0, 1), 2 * np.pi * np.arange(16) / 16)
    scaled = pot.scaled(UNIT)
    sections = mesh_sections(scaled.vertices, scaled.faces, planes, half=True)
    assert all(len(section.lines) == 1 for section in sections)
    angles = [np.arctan2(*np.array(r["frame_axes_3d"])[0, 1::-1]) % (2 * np.pi) for r in published]
    assert np.sort(angles) == pytest.approx(2 * np.pi * np.arange(16) / 16, abs=2e-3)
    curves, reports = section_curves(sections, tolerance=0.5)
    assert len(curves) == 16
    (message,) = reports
    assert "is open along" in message
    for found in curves:
        assert found.deviation < 0.2
        assert found.curve.inflections.size <= 2
        assert found.curve.degree == 4
        assert found.frame.point(found.curve.evaluate(found.curve.domain)[0])[2] == pytest.approx(0, abs=1e-9)


def test_the_shell_runs_to_its_ends(reference_data):
    """Ten upright planes of the published angles across a sixth of it, one open line each."""
    mesh = read_mesh(reference_data / "hafner" / "teaser" / "teaser_sixth.obj", unit="mm").scaled(30)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    t = (np.arange(10) + 0.5) / 10
    angles = (1 - t) * np.pi / 2 + t * np.pi / 6 - t * (1 - t) / 2
    middle = (low + high) / 2
    planes = [Frame(middle, (np.cos(a), np.sin(a), 0), (0, 0, 1)) for a in angles]
    for section in mesh_sections(mesh.vertices, mesh.faces, planes):
        places = section.line.places
        assert not section.line.is_closed
        assert np.all((places >= low - 1e-9) & (places <= high + 1e-9))
        assert np.abs((places - middle) @ section.frame.z_axis).max() < 1e-12 * mesh.size
