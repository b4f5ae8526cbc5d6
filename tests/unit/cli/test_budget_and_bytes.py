"""What a command may take, and that it writes the same bytes whenever and however it runs."""

import json
import os
import subprocess
import sys
import threading
import time

import pytest

pytest.importorskip("click")

BOW = "2 4\n0 0\n40 60\n90 60\n130 0\n"
STRIP = ("--sheet", "birch-plywood-0.8", "--max-width", "20", "-o", "out")


def typed(*words, cwd, seed="0"):
    command = [sys.executable, "-m", "elastica_cad", *words]
    env = {**os.environ, "PYTHONHASHSEED": seed}
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False, env=env)


@pytest.mark.parametrize("seconds", ["0.001", "0.4"])
def test_what_takes_longer_than_it_may_ends_with_a_sentence(tmp_path, seconds):
    (tmp_path / "bow.txt").write_text(BOW)
    done = typed("strip", "bow.txt", *STRIP, "--stable", "--seconds", seconds, "--json", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr.startswith(f"Error: this takes longer than {seconds} s: ask for less at a time")
    assert done.stderr.count("\n") == 1
    assert json.loads(done.stdout)["schema"] == "elastica-error/1"
    assert [path.name for path in tmp_path.rglob("*")] == ["bow.txt"]


def test_ctrl_c_as_the_budget_begins_is_ctrl_c(monkeypatch):
    """Before its watcher runs there is none to wait for."""
    from elastica_cad.cli.running.budget import spend

    def stop(thread):
        raise KeyboardInterrupt

    monkeypatch.setattr(threading.Thread, "start", stop)
    with pytest.raises(KeyboardInterrupt), spend(1.0, 8192.0):
        pass


def test_what_takes_more_memory_than_it_may(tmp_path):
    (tmp_path / "bow.txt").write_text(BOW)
    done = typed("strip", "bow.txt", *STRIP, "--memory", "20", cwd=tmp_path)
    assert done.returncode == 2
    assert "this takes more than 20 MB of memory" in done.stderr


@pytest.mark.campaign
def test_what_is_done_is_kept(tmp_path):
    """Many strips of one drawing: those that were written before the end stay, whole."""
    waves = "\n".join(f"2 4\n{x} 0\n{x + 40} 60\n{x + 90} 60\n{x + 130} 0" for x in range(0, 200 * 400, 200))
    curves = [[float(v) for v in row.split()] for row in waves.split("\n") if not row.startswith("2 4")]
    paths = [
        "M{} {}C{} {} {} {} {} {}".format(*(v for point in curves[i : i + 4] for v in point))
        for i in range(0, len(curves), 4)
    ]
    body = "".join(f'<path d="{path}"/>' for path in paths)
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" width="9mm" viewBox="0 0 9 9">{body}</svg>'
    (tmp_path / "many.svg").write_text(svg)
    begun = time.monotonic()
    one = typed("strip", "many.svg", *STRIP, "--curve", "1", "--force", cwd=tmp_path)
    took = time.monotonic() - begun
    assert one.returncode == 0, one.stderr
    done = typed("strip", "many.svg", *STRIP, "--all", "--force", "--seconds", str(3 * took), cwd=tmp_path)
    assert done.returncode == 2
    kept = sorted((tmp_path / "out").glob("*.json"))
    assert kept
    assert all(json.loads(file.read_text())["length"] > 0 for file in kept)
    assert "files that were done are kept" in done.stderr
    assert not list(tmp_path.rglob(".*"))


@pytest.mark.campaign
def test_the_same_bytes_in_every_run(tmp_path):
    """Handles, dates, ids, pictures, bodies, page: nothing tells when or with which seed they were written."""
    (tmp_path / "bow.txt").write_text(BOW)
    assert typed("new", "arch", "-q", cwd=tmp_path).returncode == 0
    found = []
    for seed in ("1", "2"):
        strip = typed("strip", "bow.txt", *STRIP, "--paper", "A4", "--force", "-q", cwd=tmp_path, seed=seed)
        kit = typed("model", "arch.toml", "-o", "out/kit", "--force", "-q", cwd=tmp_path, seed=seed)
        assert (strip.returncode, kit.returncode) == (0, 0), strip.stderr + kit.stderr
        files = (path for path in (tmp_path / "out").rglob("*") if path.is_file())
        found.append({path.relative_to(tmp_path).as_posix(): path.read_bytes() for path in files})
    kinds = {name.rpartition(".")[2] for name in found[0]}
    assert {"dxf", "svg", "json", "pdf", "csv", "html"} <= kinds
    assert [name for name, data in found[0].items() if found[1][name] != data] == []
