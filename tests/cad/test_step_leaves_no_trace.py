"""Writing and reading STEP changes nothing for whoever uses OpenCASCADE after us, and says who wrote the file."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from OCP.Bnd import Bnd_Box
from OCP.BRepBndLib import BRepBndLib
from OCP.Interface import Interface_Static
from OCP.Message import Message, Message_Gravity
from OCP.STEPControl import STEPControl_Writer
from OCP.TopoDS import TopoDS_Iterator

from elastica_cad import Frame, InputError, save
from elastica_cad.kernel.step_files import read_step_shape, try_in_a_copy, write_strip_step

ROOT = str(Path(__file__).resolve().parents[2])
DAMAGED = Path(__file__).resolve().parents[1] / "data" / "damaged"
NAMES = (
    "write.step.schema",
    "write.step.unit",
    "write.step.product.name",
    "xstep.cascade.unit",
    "write.surfacecurve.mode",
)


def state():
    get = getattr(Interface_Static, "CVal_s", None) or Interface_Static.CVal
    messenger = getattr(Message, "DefaultMessenger_s", None) or Message.DefaultMessenger
    return [get(name) for name in NAMES], [p.GetTraceLevel() for p in messenger().Printers()]


def test_settings_and_messages_stay(arch_strip, tmp_path):
    STEPControl_Writer()
    messenger = getattr(Message, "DefaultMessenger_s", None) or Message.DefaultMessenger
    for printer in messenger().Printers():
        printer.SetTraceLevel(Message_Gravity.Message_Warning)
    put = getattr(Interface_Static, "SetCVal_s", None) or Interface_Static.SetCVal
    put("write.step.unit", "INCH")
    before = state()
    assert before[0][1] == "INCH"
    try:
        write_strip_step(arch_strip, tmp_path / "a.step")
        read_step_shape(tmp_path / "a.step")
        assert state() == before
        assert "SI_UNIT(.MILLI.,.METRE.)" in (tmp_path / "a.step").read_text()
    finally:
        put("write.step.unit", "MM")


@pytest.mark.parametrize("suffix", ["step", "brep"])
def test_a_broken_file_is_one_sentence_and_nothing_else(tmp_path, capfd, suffix):
    """OpenCASCADE would write its own complaints to standard output, where programs look for JSON."""
    (tmp_path / f"a.{suffix}").write_text("ISO-10303-21;\nHEADER;\nENDSEC;\n")
    with pytest.raises(InputError, match="OpenCASCADE cannot read this file as"):
        read_step_shape(tmp_path / f"a.{suffix}")
    assert capfd.readouterr() == ("", "")


def test_a_file_on_which_opencascade_breaks_down():
    """OCCT 7.9 ends this process on it: entities of another kind where units are expected."""
    with pytest.raises(InputError, match="OpenCASCADE"):
        read_step_shape(DAMAGED / "breaks_opencascade.step")


def test_a_copy_that_breaks_down_is_reported():
    with pytest.raises(InputError, match="The file is damaged"):
        try_in_a_copy(lambda: os.kill(os.getpid(), signal.SIGSEGV))
    try_in_a_copy(lambda: 1 / 0)  # the real run raises it


@pytest.mark.parametrize("what", ["spins", "hangs"])
def test_a_copy_that_takes_too_long_is_ended(monkeypatch, what):
    monkeypatch.setattr("elastica_cad.kernel.step_files.LEAST_S", 1)
    monkeypatch.setattr("elastica_cad.kernel.step_files.BUSY", 5 if what == "spins" else 1)
    with pytest.raises(InputError, match=r"needs more than 1 s for this file"):
        try_in_a_copy((lambda: 10**9**9) if what == "spins" else (lambda: time.sleep(600)))


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere it ends by its limit of the processor")
def test_a_copy_ends_with_its_parent(tmp_path):
    """It spun for ever once its parent was killed: the power below is compiled, and hears no exception."""
    code = (
        "import os, pathlib\nfrom elastica_cad.kernel.step_files import try_in_a_copy\n"
        "def spin():\n    pathlib.Path('pid').write_text(str(os.getpid()))\n    os.rename('pid', 'spins')\n"
        "    10**9**9\n"
        "try_in_a_copy(spin)"
    )
    parent = subprocess.Popen(
        [sys.executable, "-c", code], cwd=tmp_path, env={**os.environ, "PYTHONPATH": ROOT}
    )
    while not (tmp_path / "spins").exists():
        assert parent.poll() is None
        time.sleep(0.01)
    parent.kill()
    parent.wait()
    proc = Path("/proc", (tmp_path / "spins").read_text(), "stat")
    for _ in range(3000):  # half a minute, where ten others want the processor
        if not proc.exists() or proc.read_text().rpartition(")")[2].split()[0] == "Z":
            return
        time.sleep(0.01)
    pytest.fail("the copy is still there")


def test_names(arch_strip, tmp_path):
    assert save(arch_strip, tmp_path / "a.step") == tmp_path / "a.step"
    text = (tmp_path / "a.step").read_text()
    assert "Author" not in text
    assert "Open CASCADE" not in text
    assert "'elastica_cad'" in text[:600]
    products = set(re.findall(r"PRODUCT\('([^']*)'", text))
    assert products == {"arch", "arch flat", "arch bent"}


@pytest.mark.parametrize("frame", [Frame(), Frame((5, 5, 5), (0, 1, 0), (0, 0, 1))])
def test_flat_lies_beside_bent(arch_strip, tmp_path, frame):
    write_strip_step(arch_strip, tmp_path / "a.step", frame=frame)
    read = read_step_shape(tmp_path / "a.step")
    walk, boxes = TopoDS_Iterator(read), []
    while walk.More():
        box = Bnd_Box()
        (getattr(BRepBndLib, "Add_s", None) or BRepBndLib.Add)(walk.Value(), box)
        boxes.append([[c.X(), c.Y(), c.Z()] for c in (box.CornerMin(), box.CornerMax())])
        walk.Next()
    (a_low, a_high), (b_low, b_high) = np.array(boxes)
    assert np.any(a_high < b_low - 5) or np.any(b_high < a_low - 5)
