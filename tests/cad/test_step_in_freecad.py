"""STEP files seen by FreeCAD: names, volumes and boxes by another program."""

import json
import shutil
import subprocess

import pytest

from elastica_cad import Frame
from elastica_cad.kernel import occt
from elastica_cad.kernel import step_files as step
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.model import EndFixture
from elastica_cad.strip import BentSolid, FlatSolid

FREECAD = shutil.which("freecadcmd")

READER = """
import json, sys, traceback
try:
    import FreeCAD, Import, Part
    seen = {}
    for path in PATHS:
        shape = Part.Shape()
        shape.read(path)
        box = shape.BoundBox
        names = None
        if shape.ShapeType == "Solid":  # 0.20 without its window dies of any assembly, whoever wrote it
            document = FreeCAD.newDocument()
            Import.insert(path, document.Name)
            names = [o.Label for o in document.Objects if hasattr(o, "Shape")]
        seen[path] = {
            "valid": shape.isValid(), "kind": shape.ShapeType, "volume": shape.Volume, "names": names,
            "box": [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax],
            "solids": len(shape.Solids),
        }
    open(OUT, "w").write(json.dumps(seen))
except BaseException:
    traceback.print_exc()
    sys.exit(1)
"""


def test_freecad_sees_the_same(arch_strip, plain, tmp_path, measure):
    """Names, volumes and boxes by another program (with an OpenCASCADE of its own, three years older)."""
    bodies = {
        "arch flat": FlatSolid.of(arch_strip),
        "arch bent": BentSolid.of(arch_strip, Frame((0, 0, 0), (1, 0, 0), (0, 0, 1))),
        "plain bent": BentSolid.of(plain),
        "fixture": EndFixture.of(arch_strip, engrave="ARCH:1").solid,
    }
    paths = {}
    for name, record in bodies.items():
        shape = occt.make_solid(record)
        paths[str(tmp_path / f"{name}.step")] = name, shape
        step.write_step([step.NamedShape(name, shape, sheet_color(plain.sheet))], tmp_path / f"{name}.step")
    whole = tmp_path / "whole.step"
    step.write_strip_step(arch_strip, whole)
    script, out = tmp_path / "reader.py", tmp_path / "seen.json"
    script.write_text(READER.replace("PATHS", repr([*paths, str(whole)])).replace("OUT", repr(str(out))))
    subprocess.run(
        [FREECAD, str(script)], stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=True
    )
    seen = json.loads(out.read_text())
    volumes = {name: measure.volume(shape, bent=False) for name, shape in paths.values()}
    assert seen[str(whole)]["solids"] == 2
    assert seen[str(whole)]["volume"] == pytest.approx(volumes["arch flat"] + volumes["arch bent"], rel=1e-4)
    for path, (name, shape) in paths.items():
        found = seen[path]
        assert found["valid"]
        assert found["kind"] == "Solid"
        assert found["names"] == [name]
        assert found["volume"] == pytest.approx(volumes[name], rel=1e-7)
        assert found["box"] == pytest.approx(box_of(shape), abs=0.02)


def box_of(shape):
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.Add_s(shape, box)
    return [
        *(getattr(box.CornerMin(), axis)() for axis in "XYZ"),
        *(getattr(box.CornerMax(), axis)() for axis in "XYZ"),
    ]
