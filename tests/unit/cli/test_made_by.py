"""The command in the files it makes, and commands as the shells of two systems take them."""

import subprocess

import ezdxf
import pytest

from elastica_cad import PlaneCurve, write_curves
from elastica_cad._text import MADE_BY, command_of_drawings, quote_words
from tests.command_line import run

ARCH = PlaneCurve.spline([(0, 0), (60, 150), (150, 190), (240, 150), (300, 0)])


def test_drawings_carry_the_command_that_made_them(tmp_path):
    """The same command gives the same bytes wherever it writes; where the curve lies is not told."""
    write_curves([ARCH], tmp_path / "my arch.json")
    words = ["strip", str(tmp_path / "my arch.json"), "--sheet", "pom-1", "--max-width", "30", "--no-step"]
    for folder in ("first", "second"):
        run(*words, "--no-pictures", "-o", tmp_path / folder)
    command = "elastica strip 'my arch.json' --sheet pom-1 --max-width 30 --no-step --no-pictures"
    for name in ("my-arch.dxf", "my-arch.svg", "my-arch-holding.dxf"):
        content = (tmp_path / "first" / name).read_bytes()
        assert content == (tmp_path / "second" / name).read_bytes()
        assert command.replace("'", "&#x27;" if name.endswith("svg") else "'") in content.decode()
        assert str(tmp_path) not in content.decode()
    assert ezdxf.readfile(tmp_path / "first/my-arch.dxf").units == 4
    assert not MADE_BY.get()


def test_old_drawings_and_prints_carry_it_too(tmp_path):
    write_curves([ARCH], tmp_path / "arch.json")
    words = ["strip", str(tmp_path / "arch.json"), "--sheet", "pom-1", "--max-width", "30", "--no-step"]
    more = [
        "--set",
        "cut.version=R12",
        "--set",
        "files.paper=A4",
        "--no-pictures",
        "-o",
        str(tmp_path / "out"),
    ]
    run(*words, *more)
    command = "elastica strip arch.json --sheet pom-1"
    assert command in (tmp_path / "out/arch-mm.dxf").read_text(encoding="ascii")
    assert command in (tmp_path / "out/arch.pdf").read_bytes().decode("latin-1")


@pytest.mark.parametrize(
    ("words", "command"),
    [
        (["model", r"C:\Users\jo\lamp.toml", "-oout"], "elastica model lamp.toml"),
        (["strip", "a&b.dxf", "--output=x", "--force"], 'elastica strip "a&b.dxf"'),
        (["strip", r"..\my arch.dxf", "--unit", "in"], r'elastica strip "..\my arch.dxf" --unit in'),
        (["strip", "--set", 'section={ kind = "rod" }'], r'elastica strip --set "section={ kind = \"rod\" }"'),
        (["strip", "a.dxf", r"--sheets=D:\own\sheets.toml"], "elastica strip a.dxf --sheets=sheets.toml"),
    ],
)  # fmt: skip
def test_paths_and_quotes_of_windows(words, command):
    assert command_of_drawings(words, windows=True) == command


@pytest.mark.parametrize("words", [["a b", "c"], ['section={ kind = "rod" }'], ["it's", "$HOME", "a*b", ""]])
def test_a_shell_hands_on_what_was_quoted(words):
    printed = subprocess.run(
        ["sh", "-c", f"printf '%s\\n' {quote_words(words, windows=False)}"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert printed.stdout == "".join(f"{word}\n" for word in words)
