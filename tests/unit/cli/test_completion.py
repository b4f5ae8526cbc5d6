"""The Tab key in a real bash: commands, options, and the keys of `--set`."""

import os
import pty
import subprocess
import sys

import pytest

SETUP = """\
PS1=
bind 'set enable-bracketed-paste off'
bind 'set bell-style none'
eval "$(_ELASTICA_COMPLETE=bash_source elastica)"
elastica() { printf '<%s>' "$@"; printf '\\n'; exit; }
echo ready
"""


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("be\t --hold-s\tpin\t", "<bend><--hold-start><pinned>"),
        ("strip --set limits.ra\t", "<strip><--set><limits.ratio=>"),
        ("help limits.cur\t", "<help><limits.curvature>"),
    ],
)
def test_tab_in_bash(typed, words, tmp_path):
    program = tmp_path / "elastica"
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m elastica_cad "$@"\n')
    program.chmod(0o755)
    keys, terminal = pty.openpty()
    surroundings = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", "TERM": "dumb"}
    with subprocess.Popen(
        ["bash", "--norc", "--noprofile", "-i"], stdin=terminal, stdout=terminal, stderr=terminal, env=surroundings,
        start_new_session=True,
    ):  # fmt: skip
        os.close(terminal)
        os.write(keys, SETUP.encode())
        read_until(keys, "\nready")
        os.write(keys, f"elastica {typed}\n".encode())
        shown = read_until(keys, "<", ">\r\n")
    os.close(keys)
    assert words in shown


def read_until(keys, *marks):
    """What the terminal shows until it has shown the marks one after the other."""
    shown, at = "", 0
    for mark in marks:
        while (found := shown.find(mark, at)) < 0:
            shown += os.read(keys, 4096).decode()
        at = found + len(mark)
    return shown
