"""Drawings that would fill memory, run for ever or hold no numbers: one sentence each, and soon."""

import json
import random
import warnings
from pathlib import Path

import numpy as np
import pytest

from elastica_cad import ElasticaError, InputError, PlaneCurve, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.formats import curves_json
from elastica_cad.formats.source_file import require_file

pytest.importorskip("cssselect2")
ezdxf = pytest.importorskip("ezdxf")


PUBLIC = Path(__file__).resolve().parents[2] / "data" / "public"


def svg(folder, body, head=""):
    path = Path(folder, "a.svg")
    links = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    path.write_text(f"<svg {links} {head}>{body}</svg>", encoding="utf-8")
    return path


def refused(path, words, **options):
    with pytest.raises(InputError, match=words) as caught:
        read_curves(path, **options)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 600


def test_clones_are_counted_before_they_are_made(tmp_path):
    levels = ['<g id="g0"><path d="M0 0C1 2 3 2 4 0"/></g>']
    for k in range(1, 6):
        levels.append(f'<g id="g{k}">' + f'<use xlink:href="#g{k - 1}"/>' * 10 + "</g>")
    refused(
        svg(tmp_path, f"<defs>{''.join(levels)}</defs><use href='#g5'/>"),
        "20001 shapes or more, its clones counted",
    )
    thirty = [levels[0]] + [f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 9 + "</g>" for k in range(1, 30)]
    refused(svg(tmp_path, f"<defs>{''.join(thirty)}</defs><use href='#g29'/>"), "20001 shapes or more")


@pytest.mark.parametrize("body", ["", "<g/>", "<text>A</text>"])
def test_clones_of_nothing_are_not_put_in_place(tmp_path, body):
    levels = [f'<g id="g0">{body}</g>']
    levels += [f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 9 + "</g>" for k in range(1, 30)]
    arch = '<path d="M0 0C10 20 30 20 40 0"/>'
    assert len(read_drawing(svg(tmp_path, f"<defs>{''.join(levels)}</defs>{arch}<use href='#g29'/>"))) == 1


def test_of_two_groups_of_one_name_clones_show_the_first_and_count_it(tmp_path):
    """Another reader of the same file may take the last: then what was counted is not what is put in place."""
    bomb = '<g id="g0"><path d="M0 0C1 2 3 2 4 0"/></g>'
    bomb += "".join(f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 10 + "</g>" for k in range(1, 7))
    plain = "".join(f'<g id="g{k}"><path d="M0 0C10 20 30 20 40 {k}"/></g>' for k in range(7))
    file = read_drawing(svg(tmp_path, f"<defs>{plain}</defs><defs>{bomb}</defs><use href='#g6'/>"))
    assert [one.curve.at(one.curve.length).position[0, 0] for one in file] == pytest.approx([40 * 25.4 / 96])
    refused(svg(tmp_path, f"<defs>{bomb}</defs><defs>{plain}</defs><use href='#g6'/>"), "its clones counted")


def test_what_stands_beside_a_shape_in_clones_is_counted_too(tmp_path):
    group = '<g id="a"><path d="M0 0C1 2 3 2 4 0"/>' + "<g/>" * 200 + "</g>"
    refused(svg(tmp_path, group + "<use href='#a'/>" * 1000), "elements or more, its clones counted")


def test_a_clone_of_itself_is_left_out_and_the_rest_is_read(tmp_path):
    body = '<g id="a"><use href="#a"/><path d="M0 0C10 20 30 20 40 0"/></g>'
    file = read_drawing(svg(tmp_path, body))
    assert len(file) == 1
    assert file.skipped["clone of itself"] == 1


def test_a_style_sheet_without_end_is_refused(tmp_path):
    arch = '<path class="a" d="M0 0C10 20 30 20 40 0"/>'
    font = f"@font-face {{src: url(data:font/woff;base64,{'A' * 2 * 10**6})}}"
    assert len(read_drawing(svg(tmp_path, f"<style>{font}</style>{arch}"))) == 1
    refused(svg(tmp_path, f"<style>{'.b{}' * 300000}</style>{arch}"), "1200000 characters in a style sheet")
    for style in (f"fill:{'(' * 9999}", f"stroke-width:{'9' * 9999}"):
        refused(
            svg(tmp_path, f'<path style="{style}" d="M0 0C10 20 30 20 40 0"/>'), "has a style with unusable"
        )


@pytest.mark.parametrize(
    "selector", [f"{'*>' * 999}.a", f"{':not(' * 400}.b{')' * 400}", ":a(b)", "[*|b]", "."]
)
def test_selectors_without_end_or_sense_are_named(tmp_path, selector):
    arch = '<path class="a" d="M0 0C10 20 30 20 40 0"/>'
    file = read_drawing(
        svg(tmp_path, f"<style>{selector.replace('>', '&gt;')} {{display: none}}</style>{arch}")
    )
    assert "styles that are not supported" in file.remarks[-1]


def test_siblings_of_many_shapes_are_compared_without_recursion(tmp_path):
    shapes = (
        '<path d="M0 0C10 20 30 20 40 0"/>' + "<g/>" * 3000 + '<path class="b" d="M0 9C10 20 30 20 40 9"/>'
    )
    file = read_drawing(svg(tmp_path, f"<style>path ~ .b {{display: none}}</style>{shapes}"))
    assert len(file) == 1


def test_groups_nested_without_end_are_refused(tmp_path):
    deep = "<g>" * 5000 + '<path d="M0 0C10 20 30 20 40 0"/>' + "</g>" * 5000
    refused(svg(tmp_path, deep), "has groups nested more than")


@pytest.mark.parametrize("rows", [30000, 10**9])
def test_a_huge_array_of_inserts_is_counted_before_it_is_expanded(tmp_path, rows):
    document = ezdxf.new()
    block = document.blocks.new("B")
    block.add_line((0, 0), (1, 0))
    insert = document.modelspace().add_blockref("B", (0, 0))
    insert.dxf.row_count, insert.dxf.column_count = rows, 1000
    document.saveas(tmp_path / "a.dxf")
    refused(tmp_path / "a.dxf", "entities, including those of its blocks, more than the limit of 20000")


def test_a_bomb_of_blocks_is_counted_before_it_is_expanded(tmp_path):
    document = ezdxf.new()
    document.blocks.new("B0").add_line((0, 0), (1, 0))
    for k in range(1, 12):
        block = document.blocks.new(f"B{k}")
        for _ in range(10):
            block.add_blockref(f"B{k - 1}", (0, 0))
    document.modelspace().add_blockref("B11", (0, 0))
    document.saveas(tmp_path / "a.dxf")
    refused(tmp_path / "a.dxf", "entities, including those of its blocks")


@pytest.mark.parametrize("number", ["1e200", "1e308", "-1e308", "1e999", "9" * 400])
@pytest.mark.parametrize("place", ["path", "circle", "transform", "viewBox", "line"])
def test_numbers_at_the_edge_of_floats_in_svg(tmp_path, number, place):
    body = {
        "path": f'<path d="M 0 0 C 10 20 30 20 {number} 0"/>',
        "circle": f'<circle cx="0" cy="0" r="{number}"/>',
        "transform": f'<path transform="scale({number})" d="M0 0C10 20 30 20 40 0"/>',
        "viewBox": '<path d="M0 0C10 20 30 20 40 0"/>',
        "line": f'<line x1="0" y1="0" x2="{number}" y2="5"/>',
    }[place]
    head = f'width="100mm" height="100mm" viewBox="0 0 {number} {number}"' if place == "viewBox" else ""
    path = svg(tmp_path, body, head)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        if place == "viewBox" and not 0 < float(number) < np.inf:
            assert read_curves(path)  # a box that makes no sense counts as none
        else:
            refused(path, r"mm|number|finite|no sense|user units")


@pytest.mark.parametrize(("text", "words"), [
    ("3 99999999999999999999\n0 0\n", r"not between -1e\+10 and 1e\+10 mm"), ("30 1\n0 0\n", "degree 30"),
    ("2 3\n0 0\n1e200 5\n9 9\n", r"not between -1e\+10 and 1e\+10 mm"), ("2 100000000\n0 0\n", "limit of 12000"),
    ("2 3\n0 0\n1e-9 0\n0 1e-9\n", "size of 0.000000001 mm"),
])  # fmt: skip
def test_counts_and_sizes_in_text_files(tmp_path, text, words):
    (tmp_path / "a.txt").write_text(text)
    refused(tmp_path / "a.txt", words)


@pytest.mark.campaign
def test_counts_and_sizes_in_json_and_csv(tmp_path):
    good = curves_json([PlaneCurve.arc((0, 0), 50, 0, 2)])
    for bad in (
        good.replace("50.0", "1e200"),
        good.replace("50.0", "9" * 5000),
        good.replace('"degree": 2', '"degree": 60'),
    ):
        (tmp_path / "a.json").write_text(bad)
        refused(tmp_path / "a.json", "curve 1|JSON")
    (tmp_path / "a.csv").write_text("0, 0\n1e200, 5\n1e201, 9\n")
    refused(tmp_path / "a.csv", r"not between -1e\+10 and 1e\+10 mm")
    around = [f"{40 * np.cos(t)}, {40 * np.sin(t)}" for t in np.arange(0, 6.2, 0.3)]
    (tmp_path / "a.csv").write_text("\n".join((*around[:9], "1e200, -1e308", *around[10:])))
    refused(tmp_path / "a.csv", r"not between -1e\+10 and 1e\+10 mm")
    (tmp_path / "a.csv").write_text("\n".join(f"{x}, 0.{x}" for x in range(13000)))
    refused(tmp_path / "a.csv", "has 13000 points in one curve")


@pytest.mark.parametrize("tolerance", [0.0, -1.0, 1e-12, 1e9, float("nan"), float("inf")])
def test_tolerances_that_make_no_sense(tmp_path, tolerance):
    refused(svg(tmp_path, '<path d="M0 0C10 20 30 20 40 0"/>'), "tolerance", tolerance=tolerance)


def test_a_binary_drawing_that_breaks_off(tmp_path):
    whole = (PUBLIC / "ezdxf" / "bin_dxf_r2000.dxf").read_bytes()
    for part in (0.01, 0.1, 0.5, 0.9):
        for beyond in range(4):
            (tmp_path / "a.dxf").write_bytes(whole[: int(part * len(whole)) + beyond])
            assert "\n" not in problem_of(tmp_path / "a.dxf")


def test_an_entity_that_no_version_knows_is_left_out_and_named(tmp_path):
    document = ezdxf.new("R2000", units=4)
    document.modelspace().add_line((0, 0), (30, 5))
    document.modelspace().add_circle((0, 50), 5)
    document.saveas(tmp_path / "a.dxf")
    text = (tmp_path / "a.dxf").read_text()
    (tmp_path / "a.dxf").write_text(text.replace("\nCIRCLE\n", "\n30\n"))
    file = read_drawing(tmp_path / "a.dxf")
    assert len(file) == 1
    assert sum(file.skipped.values()) == 1


def originals():
    document = ezdxf.new("R2000", units=4)
    space = document.modelspace()
    space.add_lwpolyline([(0, 0, 0.3), (40, 10, 0), (60, 30, -0.5)], format="xyb")
    space.add_open_spline([(0, 0), (40, 80), (90, 90), (130, 20), (190, 0)], degree=3)
    space.add_arc((0, 0), 50, 10, 170)
    space.add_ellipse((5, 5), (30, 0), 0.5, 0, 2)
    document.blocks.new("B").add_circle((0, 0), 5)
    space.add_blockref("B", (10, 10), dxfattribs={"xscale": 2.0, "row_count": 2, "row_spacing": 20})
    from io import StringIO

    stream = StringIO()
    document.write(stream)
    text = stream.getvalue()
    start = text.index("BLOCKS")
    drawing = (
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">'
        '<g transform="translate(10,5) rotate(20)"><path id="a" d="M 10 20 C 30 80 60 -10 90 40 s 20 30 40 -5"/>'
        '<circle cx="50" cy="50" r="20"/></g><use href="#a" x="5"/><polyline points="0,0 10,30 50,40"/></svg>'
    )
    curves = curves_json([PlaneCurve.arc((0, 0), 50, 0, 2), PlaneCurve.line((0, 0), (30, 5))])
    return {
        "dxf": (text[:start], text[start:]),
        "svg": ("", drawing),
        "json": ("", curves),
        "csv": ("", "x,y\n" + "\n".join(f"{x},{0.02 * x * (90 - x):.3f}" for x in range(0, 91, 5))),
        "txt": ("", "3 5\n0 0\n10.5 20.5\n30 40\n60.5 30\n90 0\n"),
    }


ODD = [
    "1e200",
    "-1e308",
    "1e999",
    "nan",
    "inf",
    "0",
    "-1",
    "99999999999999999999",
    "",
    "x",
    "1e-320",
    "0x1F",
    "١",
]


@pytest.mark.campaign
@pytest.mark.parametrize("kind", ["dxf", "svg", "json", "csv", "txt"])
def test_mutated_files_give_curves_or_one_sentence(tmp_path, kind):
    """Numbers swapped for odd ones, lines dropped or doubled, bytes overwritten: seeded, the same every time."""
    head, body = originals()[kind]
    rng = random.Random(f"{kind} 1")
    words = 30 if kind == "dxf" else 60
    for case in range(words):
        lines = body.split("\n") if kind not in ("svg",) else body.replace(" ", "\n").split("\n")
        for _ in range(rng.randint(1, 3)):
            at = rng.randrange(len(lines))
            action = rng.randrange(4)
            if action == 0:
                lines[at] = rng.choice(ODD)
            elif action == 1:
                digits = [i for i, sign in enumerate(lines[at]) if sign.isdigit()]
                if digits:
                    i = rng.choice(digits)
                    lines[at] = lines[at][:i] + rng.choice(ODD) + lines[at][i + 1 :]
            elif action == 2:
                del lines[at : at + rng.randint(1, 2)]
            else:
                lines.insert(at, lines[rng.randrange(len(lines))])
            lines = lines or [""]
        path = tmp_path / f"{case}.{kind}"
        path.write_text(head + (" " if kind == "svg" else "\n").join(lines), encoding="utf-8")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            text = problem_of(path)
        assert "\n" not in text
        assert len(text) < 1500


def problem_of(path):
    """What is said about a file, empty where all its curves are good."""
    try:
        file = read_drawing(path)
        for one in file:
            assert one.problem or np.isfinite(one.curve.length)
    except ElasticaError as error:
        return str(error)
    return " ".join(one.problem for one in file.bad[:1])


def test_a_circle_of_infinite_radius_is_refused_without_a_warning(tmp_path):
    path = tmp_path / "endless.dxf"
    rows = ("0", "SECTION", "2", "ENTITIES", "0", "CIRCLE", "8", "0", "10", "0.0", "20", "0.0", "40", "-inf")
    path.write_text("\n".join((*rows, "0", "ENDSEC", "0", "EOF", "")))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        refused(path, "not a finite number")


def test_attributes_named_beyond_ascii_do_no_harm(tmp_path):
    path = tmp_path / "named.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="90mm" viewBox="0 0 90 90" dépôt="1">'
        '<path d="M 0 0 C 20 40 60 40 80 0"/></svg>',
        encoding="utf-8",
    )
    assert len(read_drawing(path).curves) == 1


@pytest.mark.parametrize("name", ["words.txt", "words.json"])
def test_a_long_text_is_quoted_in_part(tmp_path, name):
    words = "elastica " * 300
    path = tmp_path / name
    text = f"0 {words.replace(' ', '-')}\n" * 2
    path.write_text(text if name.endswith("txt") else f'{{"schema": "{words}", "curves": [1]}}')
    message = problem_of(path)
    assert "elastica" in message
    assert len(message) < 400


def test_knots_nearer_than_the_smallest_number_are_refused_without_a_warning(tmp_path):
    path = tmp_path / "near.json"
    points = [[50.0, 0.0], [50.0, 27.0], [27.0, 42.0], [4.0, 56.0], [-20.0, 45.0]]
    curve = {
        "degree": 2,
        "knots": [0, 0, 0, 1e-320, 1, 2, 2, 2],
        "control_points": points,
        "weights": [1, 0.9, 1, 0.9, 1],
    }
    path.write_text(json.dumps({"schema": "elastica-curves/1", "units": "mm", "curves": [curve]}))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "no tangent" in problem_of(path)


def test_a_number_that_holds_half_the_file_is_reported_in_part(tmp_path):
    path = tmp_path / "torn.dxf"
    rows = ("0", "SECTION", "2", "ENTITIES", "0", "LINE", "8", "0", "10", "1.5" + "\0uous" * 400, "20", "0.0")
    path.write_text("\n".join((*rows, "11", "9.0", "21", "4.0", "0", "ENDSEC", "0", "EOF", "")))
    refused(path, r"is damaged \(.*'1\.5.*\.\.\.")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_entities_are_refused_before_they_are_expanded(tmp_path, encoding):
    """Entities of entities, below the parser's own limit."""
    head = '<!DOCTYPE svg [<!ENTITY b " 40 0"><!ENTITY a "M0 0C10 20 30 20&b;">]>'
    path = tmp_path / "a.svg"
    path.write_text(f'{head}<svg xmlns="http://www.w3.org/2000/svg"><path d="&a;"/></svg>', encoding=encoding)
    refused(path, "declares the XML entity a, which is not plain text")


@pytest.mark.parametrize(("suffix", "most"), [(".svg", 64), (".toml", 2), (".stl", 256)])
def test_a_file_that_is_too_large_is_refused_by_its_size(tmp_path, suffix, most):
    path = tmp_path / f"a{suffix}"
    with path.open("wb") as file:
        file.write(b"<")
        file.truncate((most + 1) * 10**6)
    with pytest.raises(InputError, match=f"has {most + 1} MB, more than the limit of {most} MB"):
        require_file(path)


def test_of_many_kinds_that_are_left_out_the_first_are_named(tmp_path):
    document = ezdxf.new("R2010", units=4)
    space = document.modelspace()
    space.add_arc((0, 0), 50, 10, 170)
    for number in range(500):
        document.layers.add(f"L{number}").off()
        space.add_line((0, 0), (9, 9), dxfattribs={"layer": f"L{number}"})
    document.saveas(tmp_path / "a.dxf")
    (message,) = read_drawing(tmp_path / "a.dxf").notes
    assert message.endswith("and 494 of other kinds")
    assert len(message) < 300
