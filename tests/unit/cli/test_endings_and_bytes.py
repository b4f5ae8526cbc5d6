"""How a command ends, and that it writes the same bytes whenever and however it runs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("click")

BOW = "2 4\n0 0\n40 60\n90 60\n130 0\n"
STRIP = ("--sheet", "birch-plywood-0.8", "--max-width", "20", "-o", "out")


def typed(*words, cwd, seed="0"):
    command = [sys.executable, "-m", "elastica_cad", *words]
    env = {**os.environ, "PYTHONHASHSEED": seed}
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False, env=env)


def typed_to(stream, *words, cwd):
    command = [sys.executable, "-m", "elastica_cad", *words]
    return subprocess.Popen(command, cwd=cwd, stdout=stream, stderr=subprocess.PIPE, text=True)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is always full")
def test_a_full_disk_at_standard_output_is_a_sentence(tmp_path):
    """It had ended in a traceback."""
    with open("/dev/full", "w") as full, typed_to(full, "sheets", cwd=tmp_path) as process:
        text = process.communicate()[1]
    assert text == "Error: the answer can't be written: No space left on device\n"
    assert process.returncode == 2


@pytest.mark.skipif(sys.platform == "win32", reason="pipes")
def test_a_reader_that_goes_away_ends_a_command_quietly(tmp_path):
    reads, writes = os.pipe()
    os.close(reads)
    with open(writes, "w") as broken, typed_to(broken, "sheets", cwd=tmp_path) as process:
        assert process.communicate()[1] == ""


def test_ctrl_c_ends_with_130(monkeypatch):
    """It had ended with 1, which says that a curve cannot be bent."""
    from elastica_cad.cli import main

    def stop(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("elastica_cad.cli.commands.elastica.invoke", stop)
    with pytest.raises(SystemExit) as ended:
        main(["sheets"])
    assert ended.value.code == 130


@pytest.mark.campaign
def test_the_same_bytes_in_every_run(tmp_path):
    """Handles, dates, ids, pictures, bodies, page: nothing tells when or with which seed they were written.

    STEP files alone hold what OpenCASCADE counts and sorts as it likes.
    """
    (tmp_path / "bow.txt").write_text(BOW)
    assert typed("new", "arch", "-q", cwd=tmp_path).returncode == 0
    found = []
    for seed in ("1", "2"):
        strip = typed(
            "strip", "bow.txt", *STRIP, "--set", "files.paper=A4", "--force", "-q", cwd=tmp_path, seed=seed
        )
        kit = typed("model", "arch.toml", "-o", "out/kit", "--force", "-q", cwd=tmp_path, seed=seed)
        assert (strip.returncode, kit.returncode) == (0, 0), strip.stderr + kit.stderr
        files = (path for path in (tmp_path / "out").rglob("*") if path.is_file())
        found.append({path.relative_to(tmp_path).as_posix(): path.read_bytes() for path in files})
    kinds = {name.rpartition(".")[2] for name in found[0]}
    assert {"dxf", "svg", "json", "pdf", "csv", "html"} <= kinds
    changed = [name for name, data in found[0].items() if found[1][name] != data]
    assert [name for name in changed if not name.endswith(".step")] == []
