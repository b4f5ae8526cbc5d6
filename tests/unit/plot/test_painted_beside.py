"""Pictures of a kit that a copy of the process paints: the same bytes, and nobody notices where it fails."""

import gc
import os
import signal
import sys
import time
import warnings

import pytest

import elastica_cad as ec
from elastica_cad.kit import painted_beside as beside

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="copies are made on Linux alone")


@pytest.fixture(autouse=True)
def two_processors(monkeypatch):
    monkeypatch.setattr(beside, "usable_processors", lambda: 2)
    monkeypatch.setattr("threading.active_count", lambda: 1)


@pytest.fixture
def model():
    arch = ec.PlaneCurve.arc((0, 0), 60, 0.3, 3.1)
    strip = ec.Strip(ec.optimal_rod(arch), "card-200gsm", max_width=20, label="A")
    return ec.Model([ec.Placed(strip)], name="arch")


@pytest.fixture
def copies(monkeypatch):
    """Numbers of the copies that are begun; other tests of the same process may have children of their own."""
    begun, begin = [], beside.begin_copy

    def begin_copy(task):
        begun.append(begin(task))
        return begun[-1]

    monkeypatch.setattr(beside, "begin_copy", begin_copy)
    return begun


def is_gone(number):
    try:
        os.waitpid(number, os.WNOHANG)
    except ChildProcessError:
        return True
    return False


def contents(folder):
    return {file.relative_to(folder): file.read_bytes() for file in folder.rglob("*.*")}


@pytest.mark.campaign
def test_a_kit_is_the_same_with_pictures_painted_beside_and_here(model, tmp_path, monkeypatch):
    told, threshold = {}, gc.get_threshold()
    for place, processors in (("beside", 2), ("here", 1)):
        monkeypatch.setattr(beside, "usable_processors", lambda count=processors: count)
        told[place] = []
        ec.save_model(
            model, tmp_path / place, step=False, done=lambda name, _, place=place: told[place].append(name)
        )
    assert contents(tmp_path / "beside") == contents(tmp_path / "here")
    assert len(told["here"]) == len(contents(tmp_path / "here"))
    assert told["beside"] == told["here"]
    assert gc.get_threshold() == threshold


def test_what_is_painted_beside_is_not_painted_here(tmp_path):
    painted = tmp_path / "painted"
    with beside.painted_beside([lambda: painted.write_text(str(os.getpid()))]) as are_painted:
        assert are_painted()
        assert are_painted()
    assert int(painted.read_text()) != os.getpid()


def broken():
    raise RuntimeError("torn")


def warned():
    warnings.warn("a glyph is missing", stacklevel=1)


def killed():
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.mark.parametrize("paint", [broken, warned, killed])
def test_what_fails_beside_is_left_to_be_painted_here(paint):
    with beside.painted_beside([paint]) as are_painted:
        assert not are_painted()


def test_a_copy_that_hangs_is_ended(monkeypatch, copies):
    monkeypatch.setattr(beside, "LONGEST_S", 0.1)
    with beside.painted_beside([lambda: time.sleep(60)]) as are_painted:
        assert not are_painted()
    (copy,) = copies
    assert is_gone(copy)


def test_a_copy_ends_with_the_block(copies):
    with pytest.raises(RuntimeError), beside.painted_beside([lambda: time.sleep(60)]):
        raise RuntimeError
    (copy,) = copies
    assert is_gone(copy)


@pytest.mark.parametrize("reason", ["one processor", "other threads", "nothing to paint"])
def test_there_is_no_copy_where_it_would_spare_nothing_or_is_not_safe(monkeypatch, copies, reason):
    if reason == "one processor":
        monkeypatch.setattr(beside, "usable_processors", lambda: 1)
    if reason == "other threads":
        monkeypatch.setattr("threading.active_count", lambda: 2)
    with beside.painted_beside([] if reason == "nothing to paint" else [lambda: None]) as are_painted:
        assert copies == []
        assert not are_painted()
