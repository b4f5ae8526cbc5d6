"""Whatever a label, a model or a sheet is called: every file holds it as a text, and lies where it should."""

import csv
import json
import math
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path, PureWindowsPath
from tempfile import TemporaryDirectory
from unicodedata import category
from xml.etree import ElementTree

import ezdxf
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import elastica_cad as ec
from elastica_cad import InputError, save_model
from elastica_cad._text import distinct, file_word, plain_name
from elastica_cad.design.kit_spec import HolderSpec, KitSpec
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.model.assembly import list_assembly_steps
from elastica_cad.model.plate_pairs import end_plates

SHEET = ec.Sheet.named("birch-plywood-0.8")
ARCH = ec.make_strip(ec.PlaneCurve.arc((0, 0), 60, 0.3, 3.1), SHEET, max_width=30, label="A")
NASTY = (
    "<script>alert(1)</script>", '"><img src=x onerror=1>', "]]>", "&amp;", "=1+1", "@SUM(A1)", "-2+3", "+1",
    "x');#1=",
    "..", "../../x", "a/b\\c", "CON", "nul.txt", "com1", "%%c", "\\X2\\0041", "a,b;c", '"', "'", " ",
    "javascript:1",
    "left\u00a01", "👨‍👩‍👧", "שָׁלוֹם\u200f", "soft\u00adhyphen", "की", "Łukasz", "Анна", "左" * 90,
    "$\\frac$", "%s", "{0}",
    "a\n0\nSECTION\n", "a\r\nb", "\x00", "\ud800", "\u202etxt.exe", "\u2028", "日本", "A" * 400,
)  # fmt: skip
texts = st.one_of(st.sampled_from(NASTY), st.text(max_size=30), st.lists(st.sampled_from(NASTY)).map("".join))


class Page(HTMLParser):
    """Elements with their attributes, and all text."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.text = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))

    def handle_data(self, data):
        self.text.append(data)


def kit_of_one(label, name, sheet, folder):
    """The kit of one strip with these names, or None where they are refused by one sentence."""
    try:
        strip = replace(ARCH, label=label, sheet=replace(SHEET, name=sheet))
        model = ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))], name=name)
        return save_model(model, folder, pictures=False, step=False)
    except InputError as refusal:
        return None if "\n" not in str(refusal) else str(refusal)


@pytest.mark.campaign
@settings(max_examples=60, deadline=None)
@given(texts, texts, texts)
@example("=1+1", "<script>alert(1)</script>", "=cmd")
@example("../../x", "..", "a\\b")
@example("<b>", '"><img src=x onerror=1>', "x');#1=")
@example("A" * 400, "A" * 400, "A" * 400)
def test_names_are_texts_in_every_file(label, name, sheet):
    with TemporaryDirectory() as base:
        folder = Path(base, "deep", "kit")
        saved = kit_of_one(label, name, sheet, folder)
        found = [path for path in Path(base).rglob("*") if path.is_file()]
        if saved is None:
            assert not found
            return
        assert {path.relative_to(folder).as_posix() for path in found} == set(saved.files)
        for path in found:
            assert not any(PureWindowsPath(part).is_reserved() for part in path.parts)
            assert not re.search(r'[<>:"|?*\\\x00-\x1f]', path.name)
            read(path, plain_name(name), plain_name(label))


def read(path, name, label):
    """The file through a reader of others."""
    if path.suffix == ".dxf":
        document = ezdxf.readfile(path)
        assert not document.audit().errors
        assert {entity.dxftype() for entity in document.modelspace()} <= {
            "LWPOLYLINE", "SPLINE", "LINE", "ARC", "CIRCLE",
        }  # fmt: skip
    elif path.suffix == ".svg":
        root = ElementTree.parse(path).getroot()
        assert {str(one.tag).rpartition("}")[2] for one in root.iter()} <= {"svg", "title", "g", "path"}
    elif path.suffix == ".csv":
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        assert {len(row) for row in rows} == {len(rows[0])}
        assert not any(cell[:1] in tuple("=+-@\t\r") for row in rows for cell in row if cell)
        assert not label or rows[1][0] in (label, f"'{label}")
    elif path.suffix == ".html":
        page = Page(path.read_text(encoding="utf-8"))
        assert {tag for tag, _ in page.tags} <= {
            "html", "head", "meta", "title", "style", "body", "h1", "h2", "p", "ul", "li", "table", "tr", "td",
            "th", "a",
        }  # fmt: skip
        for tag, attributes in page.tags:
            assert not any(key.startswith("on") for key in attributes)
            if tag == "a":
                assert re.fullmatch(r"[\w%.-]+(/[\w%.-]+)*", attributes["href"])
        assert name in "".join(page.text)
    elif path.suffix == ".json":
        assert json.loads(path.read_text(encoding="utf-8"))["name"] == name


@settings(max_examples=100, deadline=None)
@given(texts)
def test_words_of_file_names(text):
    word = file_word(text)
    assert all(category(sign)[0] in "LMN" or sign in "_.-" for sign in word)
    assert word[0] not in "-."
    assert len(word) <= 61
    assert len(word.encode()) <= 97
    assert word == plain_name(word)
    for kind in ("", ".dxf", ".tar.gz"):
        assert not PureWindowsPath(word + kind).is_reserved()
        assert not (word + kind).endswith(".")


@pytest.mark.parametrize("text", ["a\nb", "\x00", "\u202e", "\ud800"])
def test_signs_without_a_place_in_files_are_refused(text):
    model = ec.Model([ec.Placed(ARCH, (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    for make in (
        lambda: replace(ARCH, label=text),
        lambda: replace(model, name=text),
        lambda: replace(SHEET, name=text),
        lambda: ec.Drawing(text),
    ):
        with pytest.raises(InputError, match="use printable characters in one line"):
            make()


def test_a_refused_sign_is_found_by_its_neighbours():
    with pytest.raises(InputError) as refusal:
        replace(ARCH, label="ab\u202ecd")
    assert "contains '\\u202e' between 'b' and 'c'" in str(refusal.value)
    with pytest.raises(InputError, match="between its start and 'b'"):
        replace(ARCH, label="\nb")


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("left\u00a01\u202f2", "left 1 2"),
        ("👨\u200d👩\u200d👧\ufe0f", "👨👩👧"),
        ("שלום\u200f", "שלום"),
        ("soft\u00adhyphen", "softhyphen"),
        ("Tra\u0308ger", "Träger"),
    ],
)
def test_spaces_are_plain_and_signs_without_width_are_dropped(typed, name, tmp_path):
    strip = replace(ARCH, label=typed, sheet=replace(SHEET, name=typed))
    model = ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))], name=typed)
    assert (strip.label, strip.sheet.name, model.name) == (name, name, name)
    assert strip.drawing().name == name
    saved = save_model(model, tmp_path / "kit", pictures=False, step=False)
    assert f"{file_word(name)}.json" in saved.files


def test_labels_that_clean_to_the_same_file_have_two_files(tmp_path):
    labels = ["a/b", "a:b", "A b", "左" * 80 + "1", "左" * 80 + "2"]
    placed = [ec.Placed(replace(ARCH, label=label), (0, 0, 100 * k)) for k, label in enumerate(labels)]
    saved = save_model(ec.Model(placed), tmp_path / "kit", pictures=False, step=False)
    with (tmp_path / "kit" / "model-cut-list.csv").open(newline="", encoding="utf-8") as file:
        files = {row["part"]: row["file"] for row in csv.DictReader(file)}
    assert [*files] == labels
    assert len({file.casefold() for file in files.values()}) == len(labels)
    assert set(files.values()) <= set(saved.files)
    assert distinct(map(file_word, labels[:3])) == ["a-b", "a-b-2", "A-b-3"]


def arch(label, **options):
    curve = ec.PlaneCurve.arc((0, 0), 100, math.pi, 0)
    return ec.make_strip(curve, "birch-plywood-0.8", max_width=20, label=label, **options)


def upright(strip, y=0.0):
    return ec.Placed(strip, (0, y, 0), (1, 0, 0), (0, 0, 1))


@pytest.mark.parametrize(
    "labels", [("左", "右"), ("Л", "П"), ("α", "β"), ("ø", "ł"), ("é", "e"), ("左", "1")]
)
def test_labels_that_differ_are_engraved_differently_everywhere(labels, tmp_path):
    model = ec.Model([upright(arch(label), 40.0 * k) for k, label in enumerate(labels)], name="模型")
    assert [strip.label for strip in model.strips] == [*labels]
    first, second = ([text.text for text in strip.drawing().texts] for strip in model.strips)
    assert first != second
    base = model.base_plate("mdf-3", name="底板")
    slots = {slot.name.rpartition(":")[0] for slot in base.slots}
    texts = {text.text for text in base.drawing.texts}
    assert len(slots) == 2
    assert not any("_" in text for text in (*first, *second, *texts))
    assert len(texts) == 5
    (nest,) = model.nest()
    assert {*first, *second} <= {text.text for text in nest.texts}
    steps = list_assembly_steps(model, [base])
    assert all(end.startswith("slot ") for step in steps for end in step.ends)
    saved = ec.save_model(model, tmp_path, step=False, pictures=False)
    numbered = [strip for strip in model.strips if strip.number]
    listed, page = (
        (tmp_path / name).read_text(encoding="utf-8") for name in ("模型-cut-list.txt", "index.html")
    )
    for strip in numbered:
        assert f"{strip.number} = {strip.label}" in listed
        assert f"{strip.number} = {strip.label}" in page
    report = json.loads((tmp_path / "模型.json").read_text(encoding="utf-8"))
    assert [part["engraved"] for part in report["parts"]] == [strip.engraved for strip in model.strips]
    assert "模型.json" in saved.files


@pytest.mark.parametrize(
    ("rings", "base", "texts"),
    [("环", "底板", ["1", "2", "3", "4", "5"]), ("Ring", "1", ["1", "2", "Ring-end", "Ring-start", "3"])],
)
def test_plates_of_a_model_have_different_numbers(rings, base, texts):
    """The model has plates of its own, and its kit adds a plate. A coupon has no number of a strip."""
    sheet = replace(SHEET, name="桦木")
    placed = [upright(replace(arch(label), sheet=sheet), 40.0 * k) for k, label in enumerate("左右")]
    model = ec.Model(placed, plates=end_plates(placed, "mdf-3", name=rings))
    request = HolderSpec("base", ec.Sheet.named("mdf-3"), {"name": base})
    contents = kit_contents(model, KitSpec(holders=(request,), coupon=True))
    plates = [*contents.model.plates, *contents.holders]
    assert [part.engraved for part in (*contents.model.strips, *plates)] == texts
    for plate, text in zip(plates, texts[2:], strict=True):
        assert text in {drawn.text for drawn in plate.drawing.texts}
    names = ["左", "右", *(plate.name for plate in model.plates), f"model-{base}"]
    pairs = [f"{text} = {name}" for text, name in zip(texts, names, strict=True) if text.isdecimal()]
    assert any(message.endswith(f": {', '.join(pairs)}") for message in contents.notes)
    (coupon,) = (piece for piece in contents.pieces if piece.name == "coupon")
    assert "coupon" in {text.text for text in coupon.drawing.texts}


def test_mates_and_equal_labels_have_the_same_numbers():
    across = ec.Placed(arch("右"), (60, 0, -20), (0, 1, 0), (0, 0, 1))
    model = ec.Model([upright(arch("左")), across]).interlock()
    assert [strip.engraved for strip in model.strips] == ["1", "2"]
    assert [slot.mate for strip in model.strips for slot in strip.slots] == ["2", "1"]
    longer = ec.make_strip(
        ec.PlaneCurve.arc((0, 0), 120, 3.0, 0.1), "birch-plywood-0.8", max_width=20, label="左"
    )
    pieces = ec.Model([upright(arch("左")), upright(longer, 50)]).pieces
    assert [piece.called for piece in pieces] == ["1 = 左", "1-2 = 左-2"]


def test_a_single_strip_names_its_number():
    strip = arch("左边")
    assert (strip.label, strip.engraved) == ("左边", "1")
    assert any("1 = 左边" in text for text in strip.warnings)
    for label in ("Träger", "Łukasz", "Анна", "Νίκη"):
        assert arch(label).engraved == label
    assert not arch("左边", engrave="L").number
