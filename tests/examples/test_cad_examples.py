"""The CAD examples: each runs as a user would run it."""

import itertools
import runpy

import pytest

from elastica_cad.strip.flat_pattern import in_smooth_pieces

SCRIPTS = [f"{name}_{kernel}" for name in ("lamp", "arch", "slotted") for kernel in ("build123d", "cadquery")]
FILES = {
    "lamp": ("lamp.step", "lamp-strip.dxf"),
    "arch": ("arch.step", "arch-strip.dxf"),
    "slotted": ("slotted.step", "slotted.dxf"),
}


@pytest.fixture(scope="module")
def run(project_root, tmp_path_factory):
    """Run a script once, as __main__, in an empty folder; its names and what it wrote."""
    seen = {}

    def once(script):
        if script not in seen:
            folder = tmp_path_factory.mktemp(script)
            with pytest.MonkeyPatch.context() as patch:
                patch.chdir(folder)
                names = runpy.run_path(
                    str(project_root / "examples" / "cad" / f"{script}.py"), run_name="__main__"
                )
            seen[script] = names, folder
        return seen[script]

    return once


def strip_of(names):
    return (names.get("rib") or names.get("arch") or names.get("strip")).strip


@pytest.mark.parametrize("script", SCRIPTS)
def test_runs_and_writes_its_files(script, run, check_drawing_file):
    names, folder = run(script)
    step, dxf = FILES[script.split("_")[0]]
    assert (folder / step).stat().st_size > 10_000
    check_drawing_file(folder / dxf)
    strip = strip_of(names)
    assert strip.rod.check.realizable
    assert strip.max_strain < strip.sheet.max_strain


@pytest.mark.campaign
def test_lamp_fits_together(run):
    """Ten strips and two rings that do not touch, tabs in the rings' slots."""
    lamp = run("lamp_build123d")[0]["lamp"]
    assert [child.label for child in lamp.children] == [
        *(f"strip {n}" for n in range(1, 11)),
        "lower ring",
        "upper ring",
    ]
    strip, *rings = lamp.children[0], *lamp.children[-2:]
    for ring in rings:
        assert strip.distance_to(ring) == pytest.approx(0.1, abs=1e-3)
    box = lamp.bounding_box()
    assert pytest.approx((-10, 270), abs=1e-4) == (box.min.Z, box.max.Z)


@pytest.mark.campaign
def test_arch_is_bolted_down(run):
    """No part enters another; bolts stand in the holes and are drilled out of the feet."""
    parts = run("arch_build123d")[0]["assembly"].children
    assert len(parts) == 7
    for one, other in itertools.combinations(parts, 2):
        shared = one & other
        assert not shared or shared.volume < 1e-6, f"{one.label} enters {other.label}"
    arch, bolts = parts[0], parts[1:5]
    for bolt in bolts:
        assert bolt.distance_to(arch) == pytest.approx(0.15, abs=1e-3)


def test_cadquery_assemblies_have_all_parts(run):
    lamp, arch = run("lamp_cadquery")[0]["lamp"], run("arch_cadquery")[0]["assembly"]
    assert len(lamp.children) == 12
    assert [child.name for child in arch.children] == [
        "strip", "at_start", "at_end", "at_hole1", "at_hole2", "at_hole3", "at_hole4",
    ]  # fmt: skip
    assert all(
        child.obj.val().isValid() if hasattr(child.obj, "val") else child.obj.isValid()
        for child in arch.children
    )


def test_slots_are_cut_into_flat_and_bent(run):
    names, _ = run("slotted_build123d")
    bent, flat = names["both"].children
    strip = names["rib"].strip
    assert bent.is_valid
    assert flat.is_valid
    plain_area = (strip.outline.bounds[1] - strip.outline.bounds[0]).prod()
    assert strip.area < plain_area
    assert flat.volume == pytest.approx(strip.area * strip.sheet.thickness, rel=2e-4)  # plain integration
    assert len(flat.solid().faces()) == len(in_smooth_pieces(strip.outline).segments) + 2


def test_pictures_can_be_drawn(project_root, run):
    run("slotted_build123d")
    pictures = runpy.run_path(str(project_root / "examples" / "cad" / "pictures.py"))
    figure = pictures["draw"]("slotted")
    assert "276 x 100 x 74 mm" in figure.get_suptitle()
    for name in pictures["PICTURES"]:
        png = project_root / "examples" / "cad" / f"{name}.png"
        assert 1000 < png.stat().st_size < 200_000
