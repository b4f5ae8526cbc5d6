"""`elastica sections`: from a mesh file to strips, by the command line alone; broken meshes in words."""

import json

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.formats.point_files import read_path_points
from tests.command_line import run


def written(path, points, faces, factor=1.0):
    """An OBJ file of quads or triangles."""
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in (points * factor).tolist()]
    rows += ["f " + " ".join(str(i + 1) for i in face) for face in np.asarray(faces).tolist()]
    path.write_text("\n".join(rows))
    return path


def sheet_of(x, y, z):
    """Corners and quads of a grid (n, m) of places."""
    n, m = x.shape
    corner = (np.arange(n - 1)[:, None] * m + np.arange(m - 1)).ravel()
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    return points, np.column_stack([corner, corner + m, corner + m + 1, corner + 1])


@pytest.fixture
def dome():
    up, around = np.meshgrid(np.linspace(0, 1.4, 41), np.linspace(0, 2 * np.pi, 81), indexing="ij")
    return sheet_of(100 * np.cos(up) * np.cos(around), 100 * np.cos(up) * np.sin(around), 80 * np.sin(up))


@pytest.fixture
def torus():
    u, v = np.meshgrid(*[np.linspace(0, 2 * np.pi, n) for n in (61, 41)], indexing="ij")
    r = 80 + 20 * np.cos(v)
    return sheet_of(r * np.cos(u), r * np.sin(u), 20 * np.sin(v))


def test_metres_are_requested_and_strips_come_of_them(dome, tmp_path):
    mesh = written(tmp_path / "dome.obj", *dome, 0.001)
    result = run("sections", mesh, "--radial", 5, code=2)
    assert "is 0.294 from corner to corner" in result.stderr
    assert "--unit m" in result.stderr
    assert result.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == [mesh]
    out = tmp_path / "out"
    made = run(
        "sections",
        mesh,
        "--unit",
        "m",
        "--radial",
        5,
        "--point",
        0,
        0,
        0,
        "--sheet",
        "card-200gsm",
        "-o",
        out,
    )
    assert "Section     5: " in made.output
    assert "a strip can take it" in made.output
    assert "the mesh is open along" in made.stderr
    exact, drawn = (ec.read_curves(out / f"dome-sections.{kind}") for kind in ("json", "dxf"))
    assert [c.length for c in drawn] == pytest.approx([c.length for c in exact], rel=1e-9)
    x, y = exact[0].sample(50).position.T
    assert (x / 100) ** 2 + (y / 80) ** 2 == pytest.approx(np.ones(50), abs=0.02)
    kit = run(
        "model",
        out / "dome-sections.toml",
        "--below",
        tmp_path,
        "-o",
        tmp_path / "kit",
        "--no-step",
        "--no-pictures",
        "--no-effects",
    )
    assert "dome-sections: 5 strips" in kit.output
    report = json.loads((tmp_path / "kit" / "dome-sections.json").read_text())
    assert any("is open along" in text for text in report["reports"])
    assert all(part["ratio"] <= 3.5 * (1 + 1e-6) for part in report["parts"])
    for part, curve in zip(report["parts"], exact, strict=True):
        assert part["section"].startswith("section ")
        assert 0 <= part["deviation"] < 0.01 * curve.length
        assert 0 <= part["curve_off_section"] <= 0.3


def test_parallel_planes_stand_in_equal_slices(dome, tmp_path):
    mesh = written(tmp_path / "dome.obj", *dome)
    made = run("sections", mesh, "--parallel", 4, "--axis", 0, 1, 0, "--sheet", "card-200gsm", "-o", tmp_path)
    design = ec.design.read_design(tmp_path / "dome-sections.toml", ec.read_curves)
    assert [wish.frame.origin[1] for wish in design.entries] == pytest.approx([-75, -25, 25, 75], abs=0.2)
    offsets = [word for y in (-30, 30) for word in ("--offset", y)]
    made = run("sections", mesh, *offsets, "--axis", 0, 1, 0, "--point", 0, 0, 0, "-o", tmp_path / "two")
    assert made.output.count("mm long") == 2


def assert_two_along(mesh, path, folder):
    made = run("sections", mesh, "--along", path, "--count", 2, "-o", folder)
    assert made.output.count("mm long") == 2


def test_planes_along_a_path(dome, tmp_path):
    mesh, path = written(tmp_path / "dome.obj", *dome), tmp_path / "path.csv"
    path.write_text("# x, y, z\n-60, 0, 0\n60, 0, 0\n")
    assert_two_along(mesh, path, tmp_path)
    path.write_bytes(b"\xef\xbb\xbf-60, 0, 0\r\n60, 0, 0\r\n")  # as Windows saves it
    assert_two_along(mesh, path, tmp_path / "windows")
    path.write_text("1, 2\n")
    assert (
        "path.csv: row 1 has 2 columns instead of x, y and z"
        in run("sections", mesh, "--along", path, code=2).stderr
    )


def test_closed_sections_are_split(torus, tmp_path):
    """A ring: two closed loops across it, one a half plane."""
    mesh = written(tmp_path / "ring.obj", *torus)
    whole = run("sections", mesh, "--radial", 3, code=2)
    assert "no plane gives a strip: section 1: the section is a closed line (through (" in whole.stderr
    halves = run("sections", mesh, "--radial", 3, "--split", 0, 0, 1, 0, 0, 1, "-o", tmp_path)
    assert halves.output.count("mm long") == 6
    cuts = [word for y in (-70, 70) for word in ("--split-at", 0, y, 0)]
    level = run("sections", mesh, "--parallel", 1, "--axis", 0, 0, 1, *cuts, "-o", tmp_path, "--force")
    assert level.output.count("mm long") == 4
    assert "consists of 2 separate lines" in level.stderr
    longest = run(
        "sections", mesh, "--parallel", 1, "--axis", 0, 0, 1, *cuts, "--longest", "-o", tmp_path, "--force"
    )
    assert longest.output.count("mm long") == 2
    assert "only the longest line is used" in longest.stderr


def test_corners_are_reported_and_split(tmp_path):
    """A trough of two flat sides and a round bottom: 90 degrees at both edges."""
    t = np.linspace(0, np.pi, 61)
    x = np.concatenate([[-100, -75], -50 * np.cos(t), [75, 100]])
    z = np.concatenate([[0, 0], -50 * np.sin(t), [0, 0]])
    grid = np.meshgrid(x, [0.0, 50.0, 100.0], indexing="ij")
    mesh = written(tmp_path / "trough.obj", *sheet_of(*grid, np.broadcast_to(z[:, None], grid[0].shape)))
    whole = run("sections", mesh, "--parallel", 1, "--axis", 0, 1, 0, "-o", tmp_path, code=2)
    assert "Split the section at its corners" in whole.stderr
    run(
        "sections", mesh, "--parallel", 1, "--axis", 0, 1, 0, "--split-corners", 45, "-o", tmp_path, "--force"
    )
    lengths = [curve.length for curve in ec.read_curves(tmp_path / "trough-sections.json")]
    assert lengths == pytest.approx([50, 50 * np.pi, 50], rel=1e-3)


def test_a_section_that_no_rod_can_follow_is_named_and_the_others_go_on(tmp_path):
    """A sheet that is an arch at one end and a wave with inflections off any line at the other."""
    u, y = np.meshgrid(np.linspace(0.1, 7.8, 120), np.linspace(0, 100, 3), indexing="ij")
    arch = 60 - 2 * (u - 3.95) ** 2 * 2
    wave = 40 * np.sin(u) + 12 * (u - 4) ** 2
    written(tmp_path / "sheet.obj", *sheet_of(50 * u, y, np.where(y > 60, wave, arch)))
    design = tmp_path / "sheet.toml"
    design.write_text(
        'schema = 1\nsheet = "card-200gsm"\nmax_width = 20\n[[strips]]\n'
        'sections = { mesh = "sheet.obj", parallel = { normal = [0, 1, 0], offsets = [10, 99.9, 300] } }\n'
    )
    made = run("model", design, "-o", tmp_path / "kit", "--no-step", "--no-pictures", "--no-effects")
    assert "Model       sheet: 1 strip; " in made.output
    (message,) = [line for line in made.stderr.splitlines() if "S2" in line]
    assert "S2 (section 2, from (" in message
    assert "This section is left out." in message
    assert "section 3 at (0, 300, 0) mm: the plane misses the mesh by 200 mm" in made.stderr
    design.write_text(design.read_text().replace("10, ", ""))
    none = run("model", design, "-o", tmp_path / "none", code=1)
    assert "Not realizable: S1 (section 1, from (" in none.stderr


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ((), "Use one of --radial"),
        (("--radial", 3, "--parallel", 3), "not --radial and --parallel"),
        (("--parallel", 3, "--axis", 0, 0, 0), "normal is zero: give a direction"),
        (("--radial", 3, "--axis", 0, 0, 1, "--zero", 0, 0, 1), "zero"),
        (("--radial", 3, "--sheet", "paper-9000"), "paper-9000"),
        (("--offset", 900), "no plane gives a strip: section 1"),
        (("--radial", 3, "--scale", 1e-9), "too small or too large for strips"),
        (("--along", "none.csv"), "none.csv cannot be read"),
        (("--radial", 3, "--point", "nan", 0, 0), "--point is not finite"),
        (("--angle", "inf"), "--angle is not finite"),
        (("--offset", 1e300), "offsets contains 1e+300: give numbers up to 1e+09"),
        (("--parallel", 3, "--axis", 0, 1e300, 0), "normal contains 1e+300"),
    ],
)
def test_sentences(dome, tmp_path, options, sentence):
    mesh = written(tmp_path / "dome.obj", *dome)
    result = run("sections", mesh, *options, "-o", tmp_path, code=2)
    assert sentence in result.stderr


@pytest.mark.parametrize(
    ("spoilt", "sentence"),
    [
        (lambda v: v * 1e200, "is 1e+202 mm from the origin: correct the unit"),
        (lambda v: v * 1e-200, "have zero area: export"),
        (lambda v: np.where(v == v[0], np.nan, v), "vertex 0 of the mesh is"),
        (lambda v: v * 1e3, '--unit um or unit = "um" (um: '),
        (lambda v: v * [1, 1, 0] + [0, 0, 7], "the plane touches the mesh near ("),
    ],
)
def test_spoilt_meshes(dome, tmp_path, spoilt, sentence):
    mesh = written(tmp_path / "dome.obj", spoilt(dome[0]), dome[1])
    result = run("sections", mesh, "--parallel", 3, "--axis", 0, 0, 1, "-o", tmp_path, code=2)
    assert sentence in result.stderr


def test_a_mesh_in_pieces_is_read_as_one(tmp_path):
    """Quads that do not share corners, a tenth of a micrometre apart, some turned over."""
    u, v = np.meshgrid(np.linspace(0, np.pi, 40), np.linspace(0, 200, 10), indexing="ij")
    points, quads = sheet_of(100 * np.cos(u), v, 80 * np.sin(u))
    torn = points[quads].reshape(-1, 3) + 1e-4 * np.random.default_rng(0).normal(size=(quads.size, 3))
    faces = np.arange(quads.size).reshape(-1, 4)
    faces[::2] = faces[::2, ::-1]
    mesh = written(tmp_path / "vault.obj", torn, faces)
    made = run("sections", mesh, "--parallel", 3, "--axis", 0, 1, 0, "-o", tmp_path)
    assert made.output.count("mm long") == 3
    assert [c.length for c in ec.read_curves(tmp_path / "vault-sections.json")] == pytest.approx(
        [283.4] * 3, abs=0.2
    )
    for words in ("the mesh is open along 96 edges", "opposite orientations"):
        assert words in made.stderr


def test_a_split_at_an_end_is_none(dome, tmp_path):
    """The spine twice gives the same pieces as once."""
    mesh = written(tmp_path / "dome.obj", *dome)
    spine = ("--split", 0, 0, 0, 1, 0, 0)
    for count, folder in ((1, "once"), (2, "twice")):
        run("sections", mesh, "--offset", 0, "--axis", 0, 1, 0, *count * spine, "-o", tmp_path / folder)
    once, twice = (ec.read_curves(tmp_path / folder / "dome-sections.json") for folder in ("once", "twice"))
    assert [c.length for c in once] == [c.length for c in twice]


def test_every_section_without_a_strip_is_named(tmp_path):
    u, v = np.meshgrid(np.linspace(0, np.pi, 31), np.linspace(0, 2 * np.pi, 61), indexing="ij")
    ball = sheet_of(100 * np.sin(u) * np.cos(v), 100 * np.sin(u) * np.sin(v), 100 * np.cos(u))
    mesh = written(tmp_path / "ball.obj", *ball)
    heights = [word for z in (0, 150, 50) for word in ("--offset", z)]
    result = run("sections", mesh, *heights, "--axis", 0, 0, 1, "--point", 0, 0, 0, code=2)
    assert "section 1: the section is a closed line" in result.stderr
    assert "; section 2 at (0, 0, 150) mm: the plane misses the mesh by 50 mm" in result.stderr
    assert "; section 3: the section is a closed line" in result.stderr
    assert "(--split X Y Z NX NY NZ, a point and a normal)" in result.stderr
    many = [word for z in range(-90, 90, 9) for word in ("--offset", z)]
    assert "; and 14 more like these" in run("sections", mesh, *many, "--axis", 0, 0, 1, code=2).stderr


def test_options_without_effect_are_reported(dome, tmp_path):
    mesh = written(tmp_path / "dome.obj", *dome)
    counted = run("sections", mesh, "--radial", 3, "--count", 5, code=2)
    assert "--count has no effect without --along" in counted.stderr
    for options, message in (
        (("--radial", 3, "--up", 0, 1, 0), "--up has no effect beside --radial"),
        (
            ("--offset", 3, "--zero", 0, 1, 0),
            "--zero has no effect beside --offset",
        ),
        (
            ("--radial", 3, "--gravity"),
            "--gravity has no effect without --sheet",
        ),
    ):
        idle = run("sections", mesh, *options, code=2)
        assert message in idle.stderr
    for options in (("--angle", 0, "--angle", 90, "--angle", 360), ("--offset", 5, "--offset", 5)):
        twice = run("sections", mesh, *options, code=2)
        assert "contains the same plane twice, as numbers 1 and" in twice.stderr
    split = run("sections", mesh, "--radial", 3, "--split", 0, 0, 900, 0, 0, 1, "-o", tmp_path)
    assert (
        "Note      the plane through (0, 0, 900) mm across (0, 0, 1) does not split any section"
        in split.stderr
    )


def test_a_path_under_a_row_of_names(dome, tmp_path):
    mesh, path = written(tmp_path / "dome.obj", *dome), tmp_path / "path.csv"
    path.write_text("x,y,z\n-60,0,0\n60,0,0\n")
    assert_two_along(mesh, path, tmp_path)
    path.write_text("x,y\n-60,0\n60,0\n")
    assert (
        "row 2 has 2 columns instead of x, y and z" in run("sections", mesh, "--along", path, code=2).stderr
    )


@pytest.mark.parametrize("rows", [
    "\ufeffx;y;z\n-60,5;0;10,25\n60,5;0;10,25\n".encode(),
    "Pfad für die Spanten\nX [cm];Y [cm];Z [cm]\n-6,05;0;1,025\n6,05;0;1,025\n".encode("cp1252"),
    b"sep=;\nPoint;x (inches);y (inches);z (inches)\nA;-2.3819;0;0.40354\nB;2.3819;0;0.40354\n",
])  # fmt: skip
def test_a_path_is_read_as_other_tables_are(tmp_path, rows):
    (tmp_path / "path.csv").write_bytes(rows)
    expected = [(-60.5, 0, 10.25), (60.5, 0, 10.25)]
    assert read_path_points(tmp_path / "path.csv") == pytest.approx(np.array(expected), abs=1e-3)


def test_a_drawing_in_place_of_a_body_is_reported_all_that_can_be_cut(tmp_path):
    drawing = tmp_path / "plan.dxf"
    drawing.write_text("0\nEOF\n")
    result = run("sections", drawing, "--radial", 8, code=2)
    assert "plan.dxf ends in '.dxf', but files of meshes and CAD bodies end in .obj" in result.output
    assert ".step" in result.output
