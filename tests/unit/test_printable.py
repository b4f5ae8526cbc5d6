"""Whatever strangers call their layers, ids and files: no sign of it steers a terminal or turns a line around."""

import json

import pytest

import elastica_cad as ec
from elastica_cad._notebook import html_table
from elastica_cad._text import printable
from elastica_cad.design.model_report import compose_start_page
from tests.command_line import run

CLIPBOARD, RED, BACKWARDS = "\x1b]52;c;eA==\x07", "\x9b31m", "\u202e\u2066"
NAME = f"L{CLIPBOARD}{RED}{BACKWARDS}"
SEEN = r"L\u001b]52;c;eA==\u0007\u009b31m\u202e\u2066"
STEERING = set("\x1b\x07\x9b\r\u202e\u2066")


def uncoloured(text):
    """Text without the red of the program's own labels."""
    return text.replace("\x1b[31m", "").replace("\x1b[0m", "")


DXF_HEADER = (
    "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1021\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES"
)


def dxf(names):
    arcs = [
        f"0\nARC\n8\n{name}\n10\n0\n20\n{y}\n40\n50\n50\n20\n51\n160"
        for name, y in zip(names, (0, 100), strict=True)
    ]
    return "\n".join([DXF_HEADER, *arcs, "0\nENDSEC\n0\nEOF\n"])


def svg(names):
    paths = "".join(
        f'<path id="{name}" d="M0 {y} C30 {y + 40} 60 {y + 40} 90 {y}"/>'
        for name, y in zip(names, (0, 100), strict=True)
    )
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="300mm" viewBox="0 0 100 300">'
    return f"{head}{paths}</svg>"


XML_NAME = f"L{RED}{BACKWARDS}"  # XML knows no escape codes below a space
FILES = {
    "two.dxf": dxf(["A" + NAME, "B" + NAME]),
    "two.svg": svg(["A" + XML_NAME, "B" + XML_NAME]),
    "curves.json": json.dumps({"schema": NAME}),
    "design.toml": f"schema = 1\n[[strips]]\n'{BACKWARDS}{RED}' = 1\n",
    "head.csv": f"x,y\n0,{BACKWARDS}\n",
    f"{NAME.replace('/', '')}.svg": svg(["A", "B"]),
}


@pytest.mark.parametrize("file", FILES, ids=["dxf", "svg", "json", "toml", "csv", "name"])
def test_terminals(tmp_path, file):
    (tmp_path / file).write_text(FILES[file], encoding="utf-8")
    command = "model" if file.endswith("toml") else "check"
    done = run(command, tmp_path / file, color=True, code=None)
    assert not STEERING & set(uncoloured(done.output))
    if file != "curves.json":
        assert r"\u202e" in done.output or r"\x1b" in done.output, done.output
    result = run(command, tmp_path / file, "--json", color=True, code=None)
    assert not STEERING & set(result.stdout)
    json.loads(result.stdout)


def test_programs_get_the_names_as_they_are():
    assert json.loads(printable(json.dumps(NAME, ensure_ascii=False))) == NAME


@pytest.mark.parametrize("words", [[NAME], ["check", NAME], ["check", "a.svg", f"--{NAME}"]])
def test_what_was_typed(words):
    assert not STEERING & set(uncoloured(run("", *words, color=True, code=2).output))


def test_html():
    page = compose_start_page(NAME, [NAME], [NAME], {f"{NAME}.png": NAME, f"{NAME}.dxf": NAME})
    assert not STEERING & set(page + html_table(NAME, [{NAME: NAME}]))
    assert SEEN in page


def test_tracebacks():
    error = ec.InputError(NAME)
    assert str(error) == SEEN
    assert str(error.at(strip="A\x1b")) == rf"A\u001b: {SEEN}"
    assert str(ec.NotConvergedError(NAME)) == SEEN


def test_a_line_end_and_other_languages_stay():
    result = "弧\u3000é\xa0\n\N{GRINNING FACE}"
    assert printable(result) == result
    assert json.loads(f'"{printable(chr(0xE0001))}"') == chr(0xE0001)
    assert printable("\udcff\x7f") == r"\udcff\u007f"
