import numpy as np
import pytest

from elastica_cad import InputError, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.mechanics.theorem1 import require_bendable

pytestmark = pytest.mark.core

V = np.linspace(0, 1.5, 40)
ARC = np.column_stack([100 * np.cos(V), 100 * np.sin(V)])


@pytest.fixture
def csv(tmp_path):
    def read(text, **options):
        path = tmp_path / "points.csv"
        path.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
        return read_curves(path, **options)

    return read


def rows(points=ARC, separator=",", end="\n"):
    return end.join(separator.join(f"{v:.9g}" for v in row) for row in points) + end


@pytest.mark.parametrize("text", [
    rows(), rows(separator=", "), rows(separator=";"), rows(separator="\t"), rows(separator="   "),
    "x,y\n" + rows(), rows(end="\r\n"),
    "# measured\nx (mm); y (mm)\n" + rows(separator=" ; ").replace(".", ","),
    "\ufeff" + rows(), rows().encode("utf-16"), rows().replace("\n", ",\n"),
    "\n\n" + rows() + "\n\n# end\n",
    rows(np.column_stack([ARC, np.full(40, 7.0)])), "\n".join(f"{x:e} {y:E}" for x, y in ARC),
])  # fmt: skip
def test_points_are_read_in_any_common_dress(csv, text):
    (curve,) = csv(text, fit_tolerance=1e-3)
    assert curve.degree == 4
    assert curve.length == pytest.approx(150.0, abs=1e-2)
    ends = curve.evaluate(np.array(curve.domain))
    assert ends == pytest.approx(ARC[[0, -1]], abs=1e-5)
    dense = curve.sample(4001).position
    assert max(np.hypot(*(dense - p).T).min() for p in ARC) < 0.03


def test_the_minus_of_spreadsheets_in_nordic_languages(csv):
    (curve,) = csv("0;0\n50;\u221220,5\n100;0\n150;30\n200;0\n")
    assert np.hypot(*(curve.sample(4001).position - (50, -20.5)).T).min() < 0.05


def test_blank_rows_part_curves_and_points_in_line_are_straight(csv):
    fitted, straight = csv(rows() + "\n\n0,0\n10,10\n30,30\n30,30\n")
    assert fitted.length == pytest.approx(150.0, abs=0.05)
    assert straight.is_straight
    assert straight.length == pytest.approx(30 * np.sqrt(2))


def test_unit_scales_points(csv):
    (curve,) = csv("0,0\n3,4\n", unit="in")
    assert curve.length == pytest.approx(127.0)
    with pytest.raises(InputError, match=r"points\.csv: unknown unit 'parsec'"):
        csv("0,0\n3,4\n", unit="parsec")


def test_corners_are_kept(csv):
    (curve,) = csv("0,0\n50,0\n100,0\n100,40\n100,80\n")
    assert curve.length == pytest.approx(180.0)
    assert [c.s for c in curve.tangent_breaks] == pytest.approx([100.0])


@pytest.mark.parametrize(("text", "words"), [
    ("1,2\n3,nan\n5,6\n", r"row 2 is not finite \(3, nan\)"),
    ("1,2\ninf,4\n", "row 2 is not finite"),
    ("x,y\n1,2\n3,four\n", "row 3 has 'four' instead of a number: write a number"),
    ("1,2\n\n# note\n3\n", "row 4 has 1 columns"),
    ("1,2,3,4\n", "row 1 has 4 columns"),
    ("1,2,0\n3,4,1\n", "the third column varies by 1"),
    ("x,y\n", "the file has no points"),
    ("x,y\na,b\n1,2\n", "row 2 has 'a'"),
    ("  \n\n", "the file has no points"),
    ("5,5\n", "two different points"),
    ("5,5\n5,5\n5,5\n", "two different points"),
    (b"\xff\xff\x00\xd8", "not a text file"),
    (b"\xff\xfe\x00", "not a text file"),
])  # fmt: skip
def test_bad_points_get_one_sentence_with_file_and_row(csv, text, words):
    with pytest.raises(InputError, match=rf"points\.csv: .*{words}") as caught:
        csv(text)
    assert "\n" not in str(caught.value)


def test_points_that_no_smooth_curve_follows(csv):
    noise = np.random.default_rng(7).normal(scale=0.1, size=300)
    points = np.column_stack([np.linspace(0, 200, 300), noise])
    (curve,) = csv(rows(points))
    assert curve.provenance.measured.noise == pytest.approx(0.1, rel=0.2)
    with pytest.raises(InputError) as caught:
        require_bendable(curve)
    assert {one.field for one in caught.value.refusal.changes} == {"smooth", "nearest"}
    (curve,) = csv(rows(points), fit_tolerance=0.5)
    assert curve.length == pytest.approx(200, rel=0.02)


@pytest.fixture
def text(tmp_path):
    def read(content, **options):
        path = tmp_path / "spline.txt"
        path.write_text(content, encoding="utf-8")
        return read_curves(path, **options)

    return read


def test_control_points_make_the_uniform_unclamped_spline(text):
    from scipy.interpolate import BSpline

    points = np.array([(0, 0), (1, 2), (3, 1), (4, 4), (6, 0), (7, 7)], dtype=float)
    (curve,) = text("4 6\n" + rows(points, " "))
    assert np.array_equal(curve.knots, np.arange(-4.0, 7.0))
    assert curve.domain == (0.0, 2.0)
    t = np.linspace(0, 2, 21)
    assert curve.evaluate(t) == pytest.approx(BSpline(np.arange(-4.0, 7.0), points, 4)(t))
    (inches,) = text("4 6\n" + rows(points, " "), unit="in")
    assert inches.length == pytest.approx(25.4 * curve.length)


def test_published_spline(reference_data):
    (curve,) = read_curves(reference_data / "hafner" / "spline_infl_simple.txt")
    assert curve.degree == 4
    assert len(curve.control_points) == 22
    assert len(curve.inflections) == 3


@pytest.mark.parametrize("heading", ["", "x y\n", "# of the left side\n"])
@pytest.mark.parametrize("first", [(0, 0), (0.5, 1), (-3, 2), (40, 7)])
def test_points_in_a_text_file_are_read_like_csv(text, first, heading):
    """They were refused: "a spline has degree 0"."""
    points = [first, (10, 15), (20, 27), (30, 27), (40, 25), (50, 20)]
    (curve,) = text(heading + rows(points, " "))
    assert curve.provenance.measured.points == pytest.approx(np.array(points, dtype=float))


@pytest.mark.parametrize(("content", "words"), [
    ("x y\n3 4\n1 a\n", "row 3 has 'a' instead of a number"),
    ("4 3\n0 0\n1 1\n", r"line 1 announces 3 control points, but 2 lines follow: .* into a \.csv file"),
    ("4 3\n0 0\n1 1\n2 0\n", "too few for degree 4"),
    ("1 2\n0 0\n1 1\n", "use a whole number, 2 or more"),
    ("2 3\n0 0\n1 x\n2 0\n", "row 3 has 'x'"),
    ("2 3\n0 0\n1 nan\n2 0\n", "row 3 is not finite"),
    ("2 3\n1 1\n1 1\n1 1\n", "coincide"),
    ("\n\n", "the file has no numbers"),
])  # fmt: skip
def test_bad_control_point_files(text, content, words):
    with pytest.raises(InputError, match=rf"spline\.txt: .*{words}") as caught:
        text(content)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "heading",
    [
        "x (in),y (in)",
        "X [in], Y [in]",
        "x_in,y_in",
        "y in,x in",
        "Point,x (in),y (in),Remark",
        "n,X_in,Y_in,Z_in",
    ],
)
def test_a_heading_says_columns_and_unit(tmp_path, heading):
    """As spreadsheets and measuring machines write them: inches were read as mm, a column of names refused."""
    parted = "," if "," in heading else " "
    names = [cell.strip().lower()[0] for cell in heading.replace(" (", "(").split(parted)]
    rows = [
        {"x": x, "y": y, "z": 0, "p": "P1", "n": 7, "r": "edge"} for x, y in [(0, 0), (2, 1), (4, 1), (6, 0)]
    ]
    lines = [heading, *(parted.join(str(row[name]) for name in names) for row in rows)]
    (tmp_path / "points.csv").write_text("\n".join(lines))
    (tmp_path / "plain.csv").write_text("0,0\n2,1\n4,1\n6,0\n")
    (named,) = read_curves(tmp_path / "points.csv")
    (plain,) = read_curves(tmp_path / "plain.csv", unit="in")
    assert named.length == pytest.approx(plain.length, rel=1e-12)
    assert named.length > 150
    (request,) = read_curves(tmp_path / "points.csv", unit="cm")  # what is asked for goes first
    assert request.length == pytest.approx(plain.length / 2.54, rel=1e-12)


def test_a_heading_with_two_units_is_refused(tmp_path):
    (tmp_path / "points.csv").write_text("x (in),y (mm)\n0,0\n2,1\n4,1\n6,0\n")
    with pytest.raises(InputError, match="has the units in and mm: give x and y in one unit"):
        read_curves(tmp_path / "points.csv")


@pytest.mark.parametrize(
    "text",
    [
        '"Point";"X [mm]";"Y [mm]"\r\n1;0;0\r\n2;40,5;30\r\n3;90;45\r\n4;140;32\r\n5;180;0\r\n',
        '"Point","X (mm)","Y (mm)"\n"1","0","0"\n"2","40,5","30"\n"3","90","45"\n"4","140","32"\n"5","180","0"\n',
        '"x" "y"\n0 0\n40.5 30\n90 45\n140 32\n180 0\n',
    ],
)
def test_cells_in_quotes_are_read_as_a_spreadsheet_saves_them(tmp_path, text):
    """The quotes hid the heading: the number of the point was x, and y a third column that ran over 45 mm."""
    file = tmp_path / "points.csv"
    file.write_text(text)
    (curve,) = read_curves(file)
    assert curve.sample(2).position == pytest.approx(np.array([(0, 0), (180, 0)]), abs=0.1)
    dense = curve.sample(4001).position
    assert np.min(np.linalg.norm(dense - (40.5, 30), axis=1)) < 0.1


OFFSETS = """Station,Distance (ft),Sheer,Half-breadth,Remark
0,0,3-4-5,0-0-4,stem
1,2,3-1-0+,1-2-1 ,
2,4,2-11-2,1-11-0,
3,6,2-10-4,2-2-3,
4,8,2-10-6,-,
"""


def test_a_table_of_offsets_has_a_curve_for_every_column(tmp_path):
    file = tmp_path / "hull.csv"
    file.write_text(OFFSETS)
    drawing = read_drawing(file)
    assert [one.name for one in drawing] == ["Sheer", "Half-breadth"]
    sheer, breadth = drawing.read()
    assert sheer.sample(2).position == pytest.approx(25.4 * np.array([(0, 40.625), (96, 34.75)]), abs=1e-6)
    assert breadth.sample(2).position[1] == pytest.approx((72 * 25.4, 26.375 * 25.4), abs=1e-6)
    assert np.hypot(*(sheer.sample(4001).position - 25.4 * np.array((24, 37.0625))).T).min() < 0.3
    assert not drawing.unit.note  # its heading says feet


def test_fractions_are_inches(tmp_path):
    file = tmp_path / "rule.csv"
    file.write_text("x,y\n0,0\n3 1/2,1/2\n7-1/4,3/4\n11,0\n")
    drawing = read_drawing(file)
    (curve,) = drawing.read()
    assert curve.sample(2).position[1] == pytest.approx((11 * 25.4, 0), abs=1e-6)
    assert drawing.unit.note
    (cm,) = read_drawing(file, unit="cm").read()
    assert cm.length == pytest.approx(curve.length / 2.54)


@pytest.mark.parametrize(("heading", "unit", "digits", "least"), [
    ("Station,Height", "mm", 0, 0.5),
    ("Station,Height (in)", "in", 1, 0.05 * 25.4),
    ("x (in),y (in)", "in", 1, 0.05 * 25.4),
    ("x,y", "mm", 0, 0.5),
    ("x,y", "mm", 1, 0.0),
])  # fmt: skip
def test_what_was_read_off_is_never_more_exact_than_its_digits(csv, heading, unit, digits, least):
    """A parabola's fourth differences are 0, so the rounded points of this one seem to have next to no noise."""
    x = np.arange(12) * 10.0
    table = "\n".join(f"{a:.{digits}f},{b:.{digits}f}" for a, b in zip(x, x**2 / 100, strict=True))
    (curve,) = csv(f"{heading}\n{table}\n")
    measured = curve.provenance.measured
    assert (0.0 if measured is None else measured.noise * np.sqrt(3)) == pytest.approx(least)
    assert measured is None or measured.reach >= least


@pytest.mark.parametrize(("cells", "parts"), [("1 1/2,2 3/32", 32), ("1 1/2,2", 2), ("0-1-4,0-2-0", 8)])
def test_a_rule_is_as_fine_as_its_finest_mark(csv, cells, parts):
    (curve,) = csv(f"0,0\n{cells}\n")
    assert curve.provenance.rounding == pytest.approx(25.4 / parts / 2)


ARCH = [(0, 40), (450, 812.5), (980, 1204.25), (1620, 1310), (2200, 955.75)]


def table(head="x,y\n", separator=",", style="{:g}".format, points=ARCH):
    """Rows of points below a heading, each number in a style."""
    return head + "".join(separator.join(map(style, row)) + "\n" for row in points)


def inches(value):
    return f"{value / 25.4:.5f}"


def feet(value):
    return f"{value / 304.8:.6f}"


def cm(value):
    return f"{value / 10:g}"


def german(value):
    return f"{value:,.2f}".translate(str.maketrans(",.", ".,"))


@pytest.mark.parametrize("text", [
    table("x (inches),y (inches)\n", style=inches),
    table("X in Zoll;Y in Zoll\n", ";", lambda v: inches(v).replace(".", ",")),
    table('x ("),y (")\n', style=inches), table("x [″]\ty [″]\n", "\t", inches),
    table("x'\ty'\n", "\t", feet), table("Länge (Fuß),Höhe (Fuß)\n", style=feet),
    table("x / cm;y / cm\n", ";", cm), table("X-Koordinate (millimetres),Y-Koordinate (mm)\n"),
    table("# measured, all in inches\nx,y\n", style=inches), table("Arch\nUnits: cm\n\nx,y\n", style=cm),
    table("x,y\nin,in\n", style=inches), table("The arch of May 3\nx;y\n[cm];[cm]\n", ";", cm),
    table("mm;mm\n", ";"), table(style=lambda v: f"{cm(v)} cm"), table(style=lambda v: f'{inches(v)}"'),
    table("sep=;\nx;y\n", ";"), table('"SEP=|"\nx|y\n', "|"), table("sep=,\nx,y\n"),
    table("Bemerkung über alles\nx;y\n", ";").encode("cp1252"), table("x,y,备注\n").encode("gbk"),
    table(style=lambda v: f'"{v:,g}"'), table("x;y\n", ";", lambda v: f"{v:,.2f}"), table("x;y\n", ";", german),
    table("x;y\n", ";", lambda v: f"{v:,.2f}".replace(",", "\u202f").replace(".", ",")),
    table("x;y\n", ";", lambda v: f"{v:,g}".replace(",", "’")),
    table("Northing;Easting\n", ";", points=[p[::-1] for p in ARCH]),
    table("Point,E,N,Elevation\n", style="P,{0[0]},{0[1]},7".format, points=[[p] for p in ARCH]),
])  # fmt: skip
def test_tables_as_other_programs_write_them(csv, text):
    """Each was refused, or read in mm, mirrored or a thousand times too small."""
    (curve,) = csv(text)
    assert curve.sample(2).position == pytest.approx(np.array([ARCH[0], ARCH[-1]]), abs=0.1)
    dense = curve.sample(4001).position
    assert max(np.hypot(*(dense - p).T).min() for p in ARCH) < 0.4


@pytest.mark.parametrize("heading", [
    "x (furlong),y (furlong)", "x [yd],y [yd]", "x chain,y chain", "breadth [km],height [km]",
    "Northing (rods),Easting (rods)", "Station,Sheer (league)", "# unit: cubits\nx,y",
    "x (rods),y (rods),y (rods)",
])  # fmt: skip
def test_no_unknown_unit_is_read_as_mm(csv, heading):
    with pytest.raises(InputError, match="not a known unit: set the unit \\(unit\\)"):
        csv(table(f"{heading}\n"))
    assert csv(table(f"{heading}\n"), unit="cm")[0].length > 20_000


@pytest.mark.parametrize("text", [
    table("x;y\n", ";", "{:,}".format, [(1000, 2050), (1250, 2260), (1500, 2310), (1750, 2055)]),
    table("x\ty\n", "\t", "{:,}".format, [(0, 50), (500, 860), (1000, 910), (1500, 55)]),
    table("x;y\n", ";", lambda v: f"{v:,}".replace(",", "."), [(0, 50), (500, 860), (1000, 910), (1500, 55)]),
    'x,y\n"1,250.5","12,5"\n"2,000.5","13,5"\n',
])  # fmt: skip
def test_signs_that_may_part_thousands_or_decimals_are_refused(csv, text):
    with pytest.raises(
        InputError, match=r"row \d has '1.\d+(\.5)?', whose separator can mean thousands or decimals"
    ):
        csv(text)


def test_three_decimals_are_no_thousands(csv):
    for sign in ".,":
        (curve,) = csv(table("x;y\n", ";", lambda v, s=sign: f"{v / 10:.3f}".replace(".", s), ARCH[1:]))
        assert curve.bounds[1][0] == pytest.approx(220)


def test_thousands_in_quotes_are_reported(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text(table(style='"{:,}"'.format, points=[(1000, 2050), (1250, 2260), (1500, 2310)]))
    drawing = read_drawing(path)
    assert (
        drawing.unit.note
        == "the numbers have thousands separators: 1,000 was read as 1000. If that is wrong, remove the separators"
    )
    assert drawing.read()[0].bounds[1] == pytest.approx((1500, 2310), abs=1)


@pytest.mark.parametrize(("heading", "names"), [
    ("x,y,x,y", ["", ""]), ("Outer,,Inner,\nx,y,x,y", ["Outer", "Inner"]),
    ("x (left),y (left),x (right),y (right)", ["left", "right"]), ("X1 (cm),Y1 (cm),X2 (cm),Y2 (cm)", ["1", "2"]),
])  # fmt: skip
def test_curves_beside_each_other(tmp_path, heading, names):
    """The second may be shorter."""
    rows = [f"{a},{b},{a},{b + 700}\n" for a, b in ARCH[:-1]] + ["{},{},,\n".format(*ARCH[-1])]
    path = tmp_path / "points.csv"
    path.write_text(f"{heading}\n{''.join(rows)}")
    drawing = read_drawing(path)
    assert [one.name for one in drawing] == names
    scale = 10 if "cm" in heading else 1
    ends = [one.curve.sample(2).position[1] / scale for one in drawing]
    assert np.array(ends) == pytest.approx(np.array([ARCH[-1], (1620, 2010)]))
    path.write_text(f"x,y,x,y,x\n{''.join(rows)}")
    with pytest.raises(InputError, match="heading has x 3 times, y 2 times"):
        read_drawing(path)


def test_one_x_serves_several_y(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y,y\n0,1,5\n10,3,9\n20,2,7\n")
    assert [one.curve.sample(2).position[1, 1] for one in read_drawing(path)] == pytest.approx([2, 7])


@pytest.mark.parametrize(("cells", "height"), [
    (["3-1-0-", "2-11-2", "2-10-4"], 36.9375), (["3-1-0 +", "2-11-2", "2-10-4-"], 37.0625),
    (['"2\' 7 3/8"""', '"2\' 6"""', '"2\' 5 1/2"""'], 31.375), (["2'-7 3/8\"", "2'", "1'-11 1/4\""], 31.375),
    (["2′ 7⅜″", "2′ 6½″", "2′"], 31.375), (["2ft 7.5in", "2 ft", "1 ft 10 in"], 31.5),
    (["31 5/8\"", "30\"", "29''"], 31.625),
])  # fmt: skip
def test_feet_and_inches_in_a_table_of_offsets(tmp_path, cells, height):
    path = tmp_path / "hull.csv"
    path.write_text("Distance (ft),Sheer\n" + "".join(f"{2 * k},{cell}\n" for k, cell in enumerate(cells)))
    drawing = read_drawing(path)
    (curve,) = drawing.read()
    assert curve.sample(2).position[0] == pytest.approx((0, 25.4 * height))
    assert curve.sample(2).position[1, 0] == pytest.approx(4 * 304.8)


def test_a_table_without_a_readable_cell_names_its_first(tmp_path):
    path = tmp_path / "hull.csv"
    for cell in ("2 cubits", "high"):
        path.write_text(f"Station,Sheer\n0,{cell}\n2,{cell}\n")
        with pytest.raises(InputError, match=f"row 2 has '{cell}' instead of a number"):
            read_drawing(path)
    path.write_text("Station,Sheer,Rabbet\n0,2 cubits,1\n2,3 cubits,2\n4,3,1\n")
    drawing = read_drawing(path)
    assert [bool(one.problem) for one in drawing] == [True, False]
    assert "row 2 has '2 cubits'" in drawing.read().notes[0]


@pytest.mark.parametrize(("style", "digits"), [("{:.2f}", 2), ("{:.1f}", 1)])
def test_decimal_commas_count_as_digits(csv, style, digits):
    (curve,) = csv(table("x;y\n", ";", lambda v: style.format(v).replace(".", ",")))
    assert curve.provenance.rounding == pytest.approx(0.5 * 10.0**-digits)
