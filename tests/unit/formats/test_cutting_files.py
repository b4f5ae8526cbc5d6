import re
import subprocess
import sys
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest
import svgelements
from ezdxf.math import ConstructionPolyline
from ezdxf.path import make_path
from scipy.interpolate import BSpline

from elastica_cad import Drawing, InputError, MissingDependencyError, Path, PlaneCurve
from elastica_cad.formats import CURVES, DXF_VERSIONS, encode_dxf, encode_svg, style_layers, write_drawing
from elastica_cad.geometry import Arc, Line, Spline
from elastica_cad.geometry.approximations import as_beziers
from elastica_cad.strip import CUT_INNER, CUT_OUTER, ENGRAVE, MARK, LayeredPath, Text
from elastica_cad.strip.drawing import SHEET, separate_parts


def waved(degree=3):
    """An outline with two splines, lines and a rounded end."""
    low = PlaneCurve.spline([(0, -6), (30, -14), (60, -3), (90, -12), (110, -5), (120, -5)], degree)
    high = PlaneCurve(low.knots, low.control_points * (1, -1), degree).reversed()
    end = Arc((120, 0), 5, -np.pi / 2, np.pi / 2)
    return Path([Spline(low), end, Spline(high), Line((0, 6), (0, -6))], closed=True)


def drawing(degree=3):
    return Drawing(
        "waved <strip> & co",
        [
            LayeredPath(CUT_OUTER, waved(degree)),
            LayeredPath(CUT_INNER, Path.circle((110, 0), 2)),
            LayeredPath(MARK, Path([Line((10, -2), (10, 2))])),
            LayeredPath(
                CUT_INNER, Path.polyline([(60, -1), (70, -1), (70, 1), (60, 1)], [0, 1, 0, 1], closed=True)
            ),
            LayeredPath(CUT_INNER, Path([Spline(PlaneCurve.ellipse((30, 0), (6, 2)))], closed=True)),
            LayeredPath(ENGRAVE, Path([Spline(PlaneCurve.spline([(80, 0), (84, 3), (88, -3), (92, 0)], 3))])),
        ],
        [Text((40, -2), "A1: 0.8 mm", 4.0)],
    )


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("version", "curves"),
    [
        *((version, "spline") for version in DXF_VERSIONS),
        *((v, c) for v in ("R12", "R2010") for c in CURVES[1:]),
    ],
)
def test_every_version_and_curve_mode_is_sound(check_drawing, version, curves):
    check_drawing(drawing(), version=version, curves=curves, tolerance=0.005)


@pytest.mark.parametrize("degree", [3, 5])
def test_default_files_are_exact(check_drawing_file, tmp_path, degree):
    drawn = {item.layer: item.path for item in drawing(degree).strokes}
    for suffix in ("dxf", "svg"):
        curves = check_drawing_file(write_drawing(drawing(degree), tmp_path / f"strip.{suffix}"))
        loop = next(curve for curve in curves if curve.layer == CUT_OUTER)
        slack = 5e-6 if degree == 3 else 1e-3
        assert loop.area == pytest.approx(drawn[CUT_OUTER].area, rel=slack)
        assert loop.length == pytest.approx(drawn[CUT_OUTER].length, rel=slack)


def spline_points(spline, t):
    """Points of a SPLINE entity at its parameters, by scipy."""
    points = np.array(spline.control_points)[:, :2]
    weights = np.array(spline.weights)[:, None] if spline.weights else np.ones((len(points), 1))
    rows = BSpline(np.array(spline.knots), np.hstack([points * weights, weights]), spline.dxf.degree)(t)
    return rows[:, :2] / rows[:, 2:]


def test_bezier_splines_have_each_inner_knot_three_times_and_are_the_same_curves(tmp_path):
    kinds = {curves: tmp_path / f"{curves}.dxf" for curves in ("spline", "bezier")}
    for curves, path in kinds.items():
        write_drawing(drawing(), path, curves=curves)
    plain, joined = (
        [one for one in ezdxf.readfile(path).modelspace() if one.dxftype() == "SPLINE"]
        for path in kinds.values()
    )
    assert len(plain) == len(joined) > 2
    for one, other in zip(plain, joined, strict=True):
        knots, counts = np.unique(other.knots, return_counts=True)
        assert other.dxf.degree == 3
        assert counts.tolist() == [4, *[3] * (len(knots) - 2), 4]
        t = np.linspace(knots[0], knots[-1], 301)[:-1]
        ours, theirs = spline_points(one, t), spline_points(other, t)
        np.testing.assert_allclose(theirs, ours, rtol=0, atol=1e-9)


def test_beziers_of_degree_two_are_raised_without_moving():
    arch = PlaneCurve.spline([(0, 0), (40, 60), (90, 60), (130, 0), (150, 40)], degree=2)
    raised = as_beziers(Path([Spline(arch)])).segments[0].curve
    t = np.linspace(*arch.domain, 99)
    np.testing.assert_allclose(raised.evaluate(t), arch.evaluate(t), rtol=0, atol=1e-12)


def test_without_marks_the_rest_stays(tmp_path):
    path = write_drawing(drawing(), tmp_path / "bare.dxf", marks=False)
    layers = {one.dxf.layer for one in ezdxf.readfile(path).modelspace()}
    assert layers == {CUT_OUTER, CUT_INNER, ENGRAVE}


def test_a_part_for_a_service_is_its_closed_cuts_alone():
    several = Drawing.merged("two", [drawing(), drawing().transformed([[1, 0, 0], [0, 1, 40], [0, 0, 1]])])
    parts = separate_parts(several)
    assert [[item.layer for item in part.paths] for part in parts] == [[CUT_INNER] * 3 + [CUT_OUTER]] * 2
    assert not any(part.texts for part in parts)
    slit = LayeredPath(CUT_INNER, Path([Line((0, 0), (5, 0))]))
    with pytest.raises(InputError, match=r"slit: the cut from .* is open"):
        separate_parts(Drawing("slit", [LayeredPath(CUT_OUTER, waved()), slit]))


def test_one_entity_a_loop_where_there_is_one(tmp_path):
    path = write_drawing(drawing(), tmp_path / "strip.dxf")
    kinds = [e.dxftype() for e in ezdxf.readfile(path).modelspace() if e.dxf.layer.startswith("CUT")]
    assert kinds == ["CIRCLE", "LWPOLYLINE", "SPLINE", "SPLINE", "ARC", "SPLINE", "LINE"]
    path = write_drawing(drawing(), tmp_path / "arcs.dxf", curves="arc")
    space = ezdxf.readfile(path).modelspace()
    assert [e.dxftype() for e in space.query("*[layer=='CUT_OUTER']")] == ["LWPOLYLINE"]
    path = write_drawing(drawing(), tmp_path / "old.dxf", version="R12")
    space = ezdxf.readfile(path).modelspace()
    (outline,) = space.query("*[layer=='CUT_OUTER']")
    assert (outline.dxftype(), outline.is_closed, outline.has_arc) == ("POLYLINE", True, True)
    assert {e.dxftype() for e in space} == {"CIRCLE", "POLYLINE"}


@pytest.mark.parametrize("layer", [CUT_OUTER, CUT_INNER, MARK])
def test_lines_of_r12_are_as_long_as_their_paths(tmp_path, layer):
    """Splines are arcs there, whose length differs by less than 1e-3."""
    space = ezdxf.readfile(write_drawing(drawing(), tmp_path / "old.dxf", version="R12")).modelspace()
    lines = [make_path(one).flattening(1e-3) for one in space.query(f"*[layer=='{layer}']")]
    read = sum(ConstructionPolyline(line).length for line in lines)
    assert read == pytest.approx(sum(path.length for path in drawing().on(layer)), rel=2e-3)


def test_loop_of_several_entities_is_a_group(tmp_path):
    document = ezdxf.readfile(write_drawing(drawing(), tmp_path / "strip.dxf"))
    ((name, group),) = document.groups
    assert name == "LOOP_1"
    assert sorted(e.dxftype() for e in group) == ["ARC", "LINE", "SPLINE", "SPLINE"]


def test_splines_keep_their_knots(tmp_path):
    document = ezdxf.readfile(write_drawing(drawing(), tmp_path / "strip.dxf"))
    spline = document.modelspace().query("SPLINE[layer=='CUT_OUTER']").first
    curve = waved().segments[0].curve
    assert np.array(spline.knots) == pytest.approx(curve.knots, abs=1e-15)
    assert np.array(list(spline.control_points))[:, :2] == pytest.approx(curve.control_points, abs=1e-13)


def test_only_the_border_of_a_sheet_is_seen_without_being_worked(tmp_path):
    nested = Drawing("nest", (*drawing().strokes, LayeredPath(SHEET, Path.rectangle(200, 80))), ())
    layers = ezdxf.readfile(write_drawing(nested, tmp_path / "nest.dxf")).layers
    assert layers.get("SHEET").dxf.plot == 0
    assert all(layers.get(name).dxf.plot == 1 for name in ("CUT_OUTER", "CUT_INNER", "MARK", "ENGRAVE"))


def test_lines_of_an_svg_are_as_wide_as_requested(tmp_path):
    for stroke in (0.1, 0.01):
        text = write_drawing(drawing(), tmp_path / f"{stroke}.svg", stroke=stroke).read_text()
        assert set(re.findall(r'stroke-width="([^"]*)"', text)) == {f"{stroke:g}"}
    with pytest.raises(InputError, match="stroke"):
        write_drawing(drawing(), tmp_path / "none.svg", stroke=0)


def test_units_and_view(tmp_path):
    document = ezdxf.readfile(write_drawing(drawing(), tmp_path / "strip.dxf"))
    assert document.dxfversion == "AC1024"
    assert document.header["$INSUNITS"] == 4
    assert np.array(document.header["$EXTMAX"])[:2] == pytest.approx(drawing().bounds[1])
    old = encode_dxf(drawing(), version="R12")
    assert old.startswith(b"999\nall lengths in mm\n")
    assert b"INSUNITS" not in old


@pytest.mark.parametrize("version", ["R12", "R2000", "R2010"])
def test_layers_can_be_renamed_and_coloured(tmp_path, version):
    layers = {"CUT_OUTER": "Cut", "ENGRAVE": ("Raster", "#ff8000")}
    path = write_drawing(drawing(), tmp_path / "strip.dxf", layers=layers, version=version)
    document = ezdxf.readfile(path)
    assert {e.dxf.layer for e in document.modelspace()} == {"Cut", "CUT_INNER", "Raster", "MARK"}
    assert document.layers.get("Cut").color == 1
    assert document.layers.get("CUT_INNER").color == 5
    assert document.layers.get("Raster").color == 30
    if version == "R2010":
        assert document.layers.get("Raster").rgb == (255, 128, 0)
    root = ElementTree.parse(write_drawing(drawing(), tmp_path / "strip.svg", layers=layers)).getroot()
    groups = root.findall("{http://www.w3.org/2000/svg}g")
    assert [g.get("id") for g in groups] == ["Raster", "MARK", "CUT_INNER", "Cut"]
    assert groups[0].get("stroke") == "#ff8000"


def test_svg_is_in_mm_and_upright(tmp_path):
    part = Path.polygon([(100, 50), (140, 50), (100, 70)])
    path = write_drawing(Drawing("wedge", [LayeredPath(CUT_OUTER, part)]), tmp_path / "wedge.svg")
    root = ElementTree.parse(path).getroot()
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("42mm", "22mm", "0 0 42 22")
    image = svgelements.SVG.parse(path, ppi=25.4)
    assert (image.width, image.height) == pytest.approx((42, 22))
    (shape,) = [e for e in image.elements() if isinstance(e, svgelements.Path)]
    assert shape.bbox() == pytest.approx((1, 1, 41, 21))
    # y grows downward on the screen: the right angle stays at the lower left
    assert tuple(shape.first_point) == pytest.approx((1, 21), rel=1e-5)


def test_svg_arcs_and_beziers_are_exact(tmp_path):
    text = encode_svg(drawing()).decode()
    assert "A5 5 0 0 0 " in text
    assert text.count("C") > 3
    assert "<title>waved &lt;strip&gt; &amp; co</title>" in text
    turned = encode_svg(Drawing("r", [LayeredPath(CUT_OUTER, Path.circle((0, 0), 5).reversed())])).decode()
    assert turned.count("A5 5 0 0 1 ") == 2


@pytest.mark.campaign
def test_same_drawing_same_bytes_in_another_process(tmp_path):
    code = (
        "import sys, hashlib, numpy as np\n"
        "from elastica_cad.geometry import *\n"
        "from elastica_cad.strip import *\n"
        "from elastica_cad.formats import *\n"
        "curve = PlaneCurve.spline([(0, 0), (9, 5), (20, -3), (30, 0)], 3)\n"
        "loop = Path([Spline(curve), Line((30, 0), (0, 0))], closed=True)\n"
        "d = Drawing('x', [LayeredPath('CUT_OUTER', loop)], [Text((0, 0), 'B2', 3.0)])\n"
        "print([hashlib.sha256(f(d)).hexdigest() for f in (encode_dxf, encode_svg)])\n"
    )
    runs = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": ":".join(filter(None, sys.path))},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3", "4")
    }
    assert len(runs) == 1


def test_ezdxf_is_left_as_it_was():
    before = ezdxf.options.write_fixed_meta_data_for_testing
    encode_dxf(drawing())
    assert ezdxf.options.write_fixed_meta_data_for_testing == before
    assert not before


@pytest.mark.campaign
@pytest.mark.parametrize("suffix", ["dxf", "svg"])
def test_kerf_is_taken_on_writing(check_drawing_file, tmp_path, suffix):
    plain = check_drawing_file(write_drawing(drawing(), tmp_path / f"a.{suffix}"))
    cut = check_drawing_file(write_drawing(drawing(), tmp_path / f"b.{suffix}", kerf=0.2))
    loops = [(a, b) for a, b in zip(plain, cut, strict=True) if a.layer in (CUT_OUTER, CUT_INNER)]
    assert len(loops) == 4
    for before, after in loops:
        side = 0.1 if before.layer == CUT_OUTER else -0.1
        assert after.area - before.area == pytest.approx(side * before.length, abs=0.05)
    engraved = [(a, b) for a, b in zip(plain, cut, strict=True) if a.layer == ENGRAVE]
    assert all(a.length == pytest.approx(b.length, abs=1e-5) for a, b in engraved)


@pytest.mark.campaign
@pytest.mark.parametrize("curves", ["arc", "polyline"])
@pytest.mark.parametrize("tolerance", [0.2, 0.01])
def test_tolerance_is_kept_in_the_file(check_drawing_file, tmp_path, curves, tolerance):
    path = write_drawing(drawing(), tmp_path / "strip.dxf", curves=curves, tolerance=tolerance)
    loop = next(c for c in check_drawing_file(path) if c.layer == CUT_OUTER)
    fine = np.concatenate([s.at(np.linspace(0, 1, 201)) for s in waved().segments])
    a, d = loop.points[:-1], np.diff(loop.points, axis=0)
    worst = 0.0
    for p in np.array_split(fine, 10):
        u = np.clip(((p[:, None] - a) * d).sum(axis=2) / np.maximum((d**2).sum(axis=1), 1e-300), 0, 1)
        off = a + u[..., None] * d - p[:, None]
        worst = max(worst, np.hypot(off[..., 0], off[..., 1]).min(axis=1).max())
    assert worst <= tolerance


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"curves": "nurbs"}, "curves is 'nurbs': use one of spline, bezier, arc, polyline"),
        ({"version": "R14"}, "'R14' is not a supported DXF version"),
        ({"tolerance": 0.0, "curves": "arc"}, "tolerance is 0"),
        ({"layers": {"CUT": "x"}}, "no layer 'CUT' to rename"),
        ({"layers": {"MARK": "a/b"}}, "'a/b' is not a layer name"),
        ({"layers": {"MARK": "a\u202eb"}}, r"contains '\\u202e' between 'a' and 'b'"),
        ({"layers": {"MARK": "\x85"}}, r"contains '\\x85'"),
        ({"layers": {"MARK": "\ud800"}}, r"contains '\\ud800'"),
        ({"layers": {"MARK": "e\u0301", "ENGRAVE": "\u00e9"}}, "two layers have the same name"),
        ({"layers": {"MARK": ("a", "red")}}, "'red' is not a colour"),
        ({"layers": {"MARK": "engrave"}}, "two layers have the same name"),
        ({"layers": {"MARK": "my marks"}, "version": "R12"}, "R12 does not allow the layer name 'my marks'"),
        ({"kerf": 20.0}, "kerf is 20 mm, wider than the cut of any tool"),
        ({"kerf": 10.0}, "of 10 mm is too wide"),
        ({"kerf": np.nan}, "kerf is nan"),
    ],
)
def test_bad_options_are_refused_and_leave_no_file(tmp_path, options, message):
    with pytest.raises(InputError, match=message):
        write_drawing(drawing(), tmp_path / "strip.dxf", **options)
    assert not list(tmp_path.iterdir())


def test_names_of_layers_are_cleaned_as_labels_are():
    assert style_layers({"MARK": "my\u00a0ma\u00adrks"})["MARK"].name == "my marks"


def test_empty_drawings_and_unknown_suffixes_are_refused(tmp_path):
    with pytest.raises(InputError, match="'void' has neither"):
        write_drawing(Drawing("void"), tmp_path / "void.svg")
    with pytest.raises(InputError, match=r"\.dxf or \.svg"):
        write_drawing(drawing(), tmp_path / "strip.pdf")
    assert not list(tmp_path.iterdir())


def test_a_curve_or_a_strip_is_no_drawing(tmp_path):
    with pytest.raises(InputError, match=r"the drawing is a PlaneCurve\. Pass a strip"):
        write_drawing(PlaneCurve.arc((0, 0), 80, 0.3, 2.8), tmp_path / "arc.dxf")


def test_without_ezdxf_one_sentence_says_so(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(MissingDependencyError, match=r"writing DXF needs ezdxf: .*pip install ezdxf"):
        write_drawing(drawing(), tmp_path / "strip.dxf")
    assert not list(tmp_path.iterdir())
    assert write_drawing(drawing(), tmp_path / "strip.svg").exists()
    assert write_drawing(drawing(), tmp_path / "old.dxf", version="R12").exists()


def test_standard_styles():
    assert style_layers()["CUT_OUTER"].rgb == (255, 0, 0)
