import os
import signal
import subprocess
import sys

import pytest

from elastica_cad import cli
from elastica_cad._process import interrupts_held
from elastica_cad.cli.commands import elastica
from elastica_cad.cli.voice import Voice, progress_shown


def test_ctrl_c_in_an_import_that_catches_all_exceptions_ends_the_command_behind_it():
    passed = []

    @interrupts_held()
    def careless_import():
        try:
            signal.raise_signal(signal.SIGINT)
        except BaseException:
            pytest.fail("Ctrl-C was not held back")
        passed.append(True)

    with pytest.raises(KeyboardInterrupt):
        careless_import()
    assert passed
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)


def test_a_closed_pipe_ends_a_command_quietly():
    read, write = os.pipe()
    os.close(read)
    run = subprocess.run(
        [sys.executable, "-m", "elastica_cad", "sheets"], check=False, stdout=write, stderr=subprocess.PIPE
    )
    os.close(write)
    assert (run.returncode, run.stderr) == (141, b"")


def test_a_command_that_takes_long_shows_its_step(monkeypatch, tmp_path):
    speaker = Voice("model", step="made strip A (3 of 9)")
    monkeypatch.setattr("elastica_cad.cli.voice.voice", lambda: speaker)
    monkeypatch.setattr("elastica_cad.cli.voice.PATIENCE_S", 0.01)
    with (tmp_path / "err").open("w+") as screen:
        monkeypatch.setattr(sys, "__stderr__", screen)
        with progress_shown():
            while not screen.tell():
                pass
        screen.seek(0)
        assert screen.read().startswith("made strip A (3 of 9) ... 0 s")


PRESSED = """
import sys


class Pressed:
    def find_spec(self, name, *_):
        if name == "elastica_cad.errors":
            raise KeyboardInterrupt


sys.meta_path.insert(0, Pressed())
from elastica_cad.cli import main

main(["sheets"])
"""


def test_ctrl_c_in_the_first_imports_ends_a_command_quietly():
    run = subprocess.run([sys.executable, "-c", PRESSED], check=False, capture_output=True)
    assert (run.returncode, run.stdout, run.stderr) == (130, b"", b"")


def test_ctrl_c_while_a_class_is_made_ends_the_command_without_a_traceback(monkeypatch):
    class Pressed:
        def __set_name__(self, owner, name):
            raise KeyboardInterrupt

    def interrupted(**_):
        type("Imported", (), {"place": Pressed()})

    monkeypatch.setattr(elastica, "main", interrupted)
    with pytest.raises(SystemExit) as ended:
        cli.main(["--version"])
    assert ended.value.code == 130
