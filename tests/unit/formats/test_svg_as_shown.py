"""SVG as browsers show it: style sheets, what is hidden or clipped, where transforms turn."""

import numpy as np
import pytest

from elastica_cad import InputError, read_curves
from elastica_cad.form_finding import smooth_curve

ARCH = "M20 90C45 30 120 30 150 90"
WAVE = "M20 20C60 60 110 -20 150 20"


@pytest.fixture
def svg(tmp_path):
    """A function that writes a drawing of 170 x 110 mm and reads its curves back."""

    def read(body, head='width="170mm" height="110mm" viewBox="0 0 170 110"', before="", **options):
        path = tmp_path / "shown.svg"
        path.write_text(
            f'{before}<svg xmlns="http://www.w3.org/2000/svg" {head}>{body}</svg>', encoding="utf-8"
        )
        return read_curves(path, **options)

    return read


def line(d, more=""):
    return f'<path fill="none" stroke="#000" d="{d}" {more}/>'


@pytest.mark.parametrize(
    ("rules", "is_hidden"),
    [
        ("@media print {path {stroke: red}} .away {display: none}", True),
        ("@media print {.away {display: none}}", False),
        ("@media screen {.away {display: none}}", True),
        ("@media print, screen {.away {display: none}}", True),
        ("@import url('a;b.css'); @font-face {font-family: x} .away {visibility: hidden}", True),
        ("/* .arch {} */ g.box > path.away {display: none}", True),
        ("#sheet .away {display: none}", True),
        ("#other .away {display: none}", False),
        ("rect + path {display: none}", True),
        ("rect ~ .away {display: none}", True),
        (".away[id^='wa'] {display: none}", True),
        (".box .away:last-child {opacity: 0}", True),
        ("path.away {display: none} .away {display: inline}", True),
        (".away {display: none} .away {display: inline}", False),
        ("#wave {display: inline} .away {display: none !important}", True),
        ("svg .away {stroke: none}", True),
        (".away {stroke: rgba(10, 20, 30, 0)}", True),
        (".away {stroke: rgb(0, 0, 0)}", False),
        (".away {stroke-width: 0px}", True),
        (".away {content: '} .away {display: none'}", False),
        ("g path:nth-child(2) {display: none}", True),
        ("path:nth-child(odd), .away:not(.odd) {display: none}", False),
        ("@media screen {@media print {.away {display: none}}}", False),
        ("path::before {display: none}", False),
    ],
)
def test_rules_of_style_sheets_hide_what_browsers_hide(svg, rules, is_hidden):
    wave = line(WAVE, 'id="wave" class="away odd"')
    shapes = f'<g id="sheet" class="box"><rect width="0" height="0"/>{wave}</g>'
    found = svg(f"<style>{rules}</style>" + line(ARCH, 'id="arch"') + shapes)
    assert [curve.provenance.name for curve in found] == (["arch"] if is_hidden else ["arch", "wave"])
    assert ("left out" in " ".join(found.notes)) == is_hidden or "1 hidden" in found.notes[0]


def test_rules_that_are_not_evaluated_are_named(svg):
    rules = "path:nth-col(2) {display: none} .a:hover {x: 1} @media (min-width: 9px) {#b {display: none}}"
    found = svg(f"<style>{rules} .c {{color: red}}</style>{line(ARCH)}")
    assert [note.partition(":")[2] for note in found.notes] == [
        " path:nth-col(2) and #b. Compare the curves with the drawing"
    ]


@pytest.mark.parametrize(
    ("clip", "is_cut"),
    [
        ('<rect x="0" y="0" width="80" height="110"/>', True),
        ('<rect width="170" height="110"/>', False),
        ('<path d="M0 0H170V110H0Z"/>', False),
        ('<path d="M0 0H70V110H0Z"/>', True),
        ('<circle cx="85" cy="55" r="300"/>', True),
    ],
)
@pytest.mark.parametrize(
    "where", ['<g clip-path="url(#c)">{}</g>', "<g style=\"clip-path: url('#c')\">{}</g>"]
)
def test_a_clip_that_cuts_a_curve_is_reported(svg, clip, is_cut, where):
    arch = line("M10 85C35 25 110 25 140 85", 'id="arch"')
    moved = f'<g transform="translate(10 5)">{arch}</g>'
    found = svg(f'<clipPath id="c">{clip}</clipPath>' + where.format(moved))
    assert found[0].length == pytest.approx(svg(line(ARCH))[0].length)
    assert ["clipped or masked" in note and "arch" in note for note in found.notes] == [True] * is_cut


@pytest.mark.parametrize(
    ("view", "is_cut"),
    [
        ('<svg width="80" height="110">{}</svg>', True),
        ('<svg width="80" height="110" overflow="hidden">{}</svg>', True),
        ('<svg width="80" height="110" style="overflow: visible">{}</svg>', False),
        ('<svg width="80" height="110" overflow="auto">{}</svg>', False),
        ("<svg>{}</svg>", False),
        ('<svg x="-10" width="140" height="100%">{}</svg>', True),
        ('<svg x="5" y="4" width="85" height="55" viewBox="0 0 170 110">{}</svg>', False),
        ('<svg width="85" height="55" viewBox="60 0 85 55">{}</svg>', True),
        ('<g transform="scale(.5)"><svg width="170" height="110"><svg height="80">{}</svg></svg></g>', True),
        ('<symbol id="s" viewBox="0 0 100 50">{}</symbol><use href="#s" width="50" height="25"/>', True),
        ('<symbol id="s" overflow="visible">{}</symbol><use href="#s" width="50" height="25"/>', False),
        ('<symbol id="s">{}</symbol><use href="#s" width="150" height="90"/>', False),
    ],
)
def test_a_nested_svg_that_cuts_a_curve_is_reported(svg, view, is_cut):
    """By default, the content of a nested <svg> or of a <symbol> ends at its viewport."""
    found = svg(view.format(line(ARCH, 'id="arch"')))
    assert len(found) == 1
    assert ["clipped or masked" in note and "arch" in note for note in found.notes] == [True] * is_cut


def test_a_clip_is_compared_with_each_clone_where_it_is(svg):
    clip = '<clipPath id="c"><rect width="170" height="100"/></clipPath>'
    clones = '<use id="u" href="#a" y="-9"/><use id="v" href="#a" transform="translate(0 30)"/>'
    arch = line(ARCH, 'id="a"')
    (message,) = svg(f'{clip}<defs>{arch}</defs><g clip-path="url(#c)">{clones}</g>').notes
    assert "v/a" in message
    assert "u/a" not in message


def test_a_clone_is_on_the_layer_where_it_is(svg):
    names = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    layers = [f'<g {names} inkscape:groupmode="layer" inkscape:label="L{k}">{{}}</g>' for k in (1, 2)]
    found = svg(layers[0].format(line(ARCH, 'id="a"')) + layers[1].format('<use id="u" href="#a" y="9"/>'))
    assert [(curve.name, curve.layer) for curve in found.file] == [("a", "L1"), ("u/a", "L2")]


@pytest.mark.parametrize(
    ("transform", "end"),
    [
        ("translate(10mm,5%)", (20 + 10 * 96 / 25.4, 90 + 5.5)),
        ("rotate (0.25turn)", (-90, 20)),
        ("rotate(100grad 20 90)", (20, 90)),
        ("skewX(45)scale(2-1)", (40 - 90, -90)),
        ("matrix(1 2 3 4 5 6)", (20 + 270 + 5, 40 + 360 + 6)),
        ("none", (20, 90)),
    ],
)
def test_transforms_are_read_as_in_css(svg, transform, end):
    (curve,) = svg(line(ARCH, f'transform="{transform}"'))
    assert curve.evaluate(curve.domain[0]) * (1, -1) == pytest.approx(np.array(end))


@pytest.mark.parametrize(
    "transform", ["scale()", "matrix(1 0 0)", "translate(--1 5)", "rotate(5x)", "turn(3)"]
)
def test_a_transform_that_makes_no_sense_is_named(svg, transform):
    (message,) = svg(line(ARCH) + line(WAVE, f'id="wave" transform="{transform}"')).notes
    assert "path wave that has a transform with numbers that are not finite or too large" in message


def test_what_a_transform_flattens_is_not_shown(svg):
    (message,) = svg(line(ARCH) + line(WAVE, 'transform="rotate(30) scale(1 0)"')).notes
    assert message.endswith("1 hidden or empty shape")


def test_a_mask_is_reported_and_a_reference_to_nothing_is_not(svg):
    mask = '<mask id="m"><rect width="30" height="110" fill="#fff"/></mask>'
    arch = line(ARCH, 'id="a"')
    found = svg(f'{mask}<defs>{arch}</defs><use id="u" href="#a" mask="url(#m)"/>')
    assert [curve.provenance.name for curve in found] == ["u/a"]
    assert ["u/a" in note for note in found.notes] == [True]
    assert not svg(line(ARCH, 'clip-path="url(#nothing)" mask="none"')).notes


@pytest.mark.parametrize(
    ("style", "start"),
    [
        ('transform="rotate(90)" transform-origin="60 40"', (10, 0)),
        ('transform="rotate(90)" style="transform-origin: 60px 40px"', (10, 0)),
        ('style="transform: rotate(90deg); transform-origin: center"', (50, -10)),
        ('transform="rotate(90)" transform-origin="top 10%"', (-90, 20)),
        ('transform="rotate(90)" transform-origin="top right"', (80, -150)),
        ('transform="rotate(90)" transform-origin="bottom"', (105, 45)),
        ('transform="scale(2)" transform-origin="right bottom"', (-130, 70)),
        ('transform-origin="60 40"', (20, 90)),
    ],
)
def test_transforms_turn_about_their_origin(svg, style, start):
    (curve,) = svg(line(ARCH, style))
    assert curve.evaluate(curve.domain[0]) * (1, -1) == pytest.approx(np.array(start))


def test_boxes_without_stroke_and_fill_are_no_curves(svg):
    box = '<rect class="BoundingBox" stroke="none" fill="none" x="12" y="33" width="141" height="70"/>'
    found = svg(f"<g>{box}{line(ARCH)}</g>")
    assert len(found) == 1
    assert found.notes == ("left out because they are not curves: 1 shape without stroke and fill",)
    assert svg(line(ARCH) + line(WAVE, 'transform="scale(0)"')).notes[0].endswith("1 hidden or empty shape")
    assert len(svg(box)) == 1, "a drawing without any paint is read"


@pytest.mark.parametrize(
    ("head", "body", "mm"),
    [
        ('id="Layer_1" data-name="Layer 1" viewBox="0 0 400 300"', "", 25.4 / 72),
        ('id="Calque_1" data-name="Calque 1" width="400" height="300" viewBox="0 0 400 300"', "", 25.4 / 72),
        ('viewBox="0 0 400 300"', '<g id="Layer_2" data-name="Layer 2"/>', 25.4 / 72),
        ('id="arch" viewBox="0 0 400 300"', '<g class="cls-2"/>', 25.4 / 72),
        ('width="400" height="300" viewBox="0 0 400 300"', '<g data-name="of XD"/>', 25.4 / 96),
        ('data-name="Layer 1" width="400mm" viewBox="0 0 400 300"', "", 1.0),
    ],
)
def test_what_illustrator_exports_as_svg_is_in_points(svg, head, body, mm):
    found = svg(body + line(ARCH), head)
    assert np.ptp(found[0].control_points[:, 0]) == pytest.approx(130 * mm)
    assert any("Illustrator" in note for note in found.notes) == (mm == 25.4 / 72)


def test_illustrator_is_found_by_its_remark_in_utf_16_too(tmp_path):
    path = tmp_path / "wide.svg"
    remark = "<!-- Generator: Adobe Illustrator 29.1.0, SVG Export Plug-In -->"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{remark}{line(ARCH)}</svg>', encoding="utf-16")
    assert np.ptp(read_curves(path)[0].control_points[:, 0]) == pytest.approx(130 * 25.4 / 72)


def test_entities_of_plain_text_are_expanded(svg):
    names = '<!ENTITY ns_x "http://ns.adobe.com/x/"> <!ENTITY st0 "fill:none;stroke:#123456;">'
    (curve,) = svg(f'<path xmlns:x="&ns_x;" style="&st0;" d="{ARCH}"/>', before=f"<!DOCTYPE svg [{names}]>")
    assert curve.control_points[-1] == pytest.approx((150, -90))


@pytest.mark.parametrize("entity", [
    '<!ENTITY big "&st;&st;">', '<!ENTITY tag "&#60;path/>">', '<!ENTITY far SYSTEM "a.txt">', '<!ENTITY % p "x">',
    f'<!ENTITY long "{"x" * 1001}">',
])  # fmt: skip
def test_other_entities_are_refused(svg, entity):
    with pytest.raises(InputError, match=r"declares the XML entity \w+, which is not plain text"):
        svg(line(ARCH), before=f"<!DOCTYPE svg [{entity}]>")


def test_entities_cannot_blow_up_a_file(svg):
    with pytest.raises(InputError, match="is not an SVG file"):
        svg("&a;" * 60000 + line(ARCH), before=f'<!DOCTYPE svg [<!ENTITY a "{"x" * 999}">]>')


@pytest.mark.parametrize(
    "d",
    [
        "M12.5,80s60.25-70.5,140,0.5",
        "M12 80s60-70 140 0",
        "M10 80C30 20 150 80 150 80",
        "M10 80C10 80 40 20 80 20S150 80 150 80",
    ],
)
def test_a_node_without_a_handle_is_smoothed(svg, d):
    """The browser's curve is drawn by the Bezier formula here."""
    (curve,) = svg(line(d))
    smoothed = smooth_curve(curve)
    assert smoothed.curve is not curve
    drawn = np.array([(x, -y) for x, y in drawn_points(d)])
    for one, most in ((curve, 0.007), (smoothed.curve, 0.1)):
        dense = one.sample(20001).position
        off = max(np.hypot(*(dense - point).T).min() for point in drawn)
        assert off < most
    assert np.abs(smoothed.curve.sample(999).curvature).max() < 0.2


def drawn_points(d):
    from svgelements import Path

    return [(p.x, p.y) for p in (Path(d).point(t, error=1e-9) for t in np.linspace(0, 1, 200))]


@pytest.mark.parametrize(
    ("d", "width"),
    [
        ("M10 20H130V27H10Z", 7),
        ("M10 90A70 70 0 0 1 150 90H142A62 62 0 0 0 18 90Z", 8),
        ("M10 50A3 3 0 0 1 10 44L110 44A3 3 0 0 1 110 50Z", 6),
        ("M10 90A70 70 0 0 1 150 90H110A30 30 0 0 0 50 90Z", None),
        ("M80 10A40 40 0 1 1 79.9 10Z", None),
        ("M10 50Q80 10 150 50Q80 60 10 50Z", None),
        ("M10 90A70 70 0 0 1 150 90", None),
    ],
)
def test_the_outline_of_a_stroke_is_named(svg, d, width):
    result = [note for note in svg(line(d)).notes if "outline of a stroke" in note]
    assert len(result) == (width is not None)
    assert all(f"about {width} mm wide" in note for note in result)
