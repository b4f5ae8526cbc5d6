"""`elastica batten` as a sailmaker meets it: what is asked, what is told, and the files."""

import csv
import json
import re
import sys

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from elastica_cad import NotConvergedError, PlaneCurve, Sheet, StripSpec
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.kit.strip_kit import StripFiles, StripResult
from elastica_cad.mechanics import RoundLaw, ThicknessLaw
from elastica_cad.model.batten import BattenSpec, bench_drawing
from tests.command_line import run

ASKED = ("--sheet", "pom-1", "--length", "2400", "--camber", "10", "--at", "40")


def test_the_files_say_what_is_reported(tmp_path, check_drawing_file):
    result = run("batten", *ASKED, "--stock", 25, 8, "--least", 3, "--every", 300, "--weight", "-o", tmp_path)
    assert "Camber      233.9 mm (10 % of the chord) at 935.5 mm (40 %) along the chord" in result.output
    assert "Weight      with its ends level and its bulge down, the batten has a camber of" in result.output
    rows = list(csv.DictReader((tmp_path / "batten.csv").read_text().splitlines()))
    assert [float(row["s_mm"]) for row in rows] == list(np.arange(0.0, 2401.0, 300.0))
    sizes = np.array([float(row["thickness_mm"]) for row in rows])
    assert np.abs(np.diff(sizes, 2)).max() < 0.021  # an even taper, in hundredths
    assert sizes[-1] == pytest.approx(8.0, rel=1e-4)
    assert [float(row["thickness_inch"]) for row in rows] == pytest.approx(sizes / 25.4, abs=8e-4)
    report = json.loads((tmp_path / "batten.json").read_text())
    assert report["camber_place"] == pytest.approx(0.4, abs=1e-5)
    (outline,) = [one for one in check_drawing_file(tmp_path / "batten.dxf") if one.layer == "CUT_OUTER"]
    assert outline.area == pytest.approx(2400 * sizes.mean(), rel=1e-3)
    for kind in ("svg", "pdf", "step"):
        assert (tmp_path / f"batten.{kind}").stat().st_size > 1000


def test_what_cannot_be_written_is_reported(tmp_path, monkeypatch):
    """No CAD kernel and no matplotlib: the other files, and how to get these."""
    for module in ("OCP", "matplotlib"):
        monkeypatch.setitem(sys.modules, module, None)
    result = run("batten", *ASKED, "--stock", 25, 8, "--least", 3, "-o", tmp_path)
    assert re.search("not written: STEP; .*build123d", result.output)
    assert re.search("not written: PDF; .*matplotlib", result.output)
    assert sorted(one.suffix for one in tmp_path.iterdir()) == [".csv", ".dxf", ".json", ".svg"]


@pytest.mark.parametrize("law", ["strip", "rod", "tube"])
@pytest.mark.parametrize(("camber", "place"), [(0.08, 0.45), (0.12, 0.38), (0.1, 0.6)])
def test_an_independent_solver_finds_the_camber_where_it_is_requested(law, camber, place):
    """Hinged ends at the chord's distance, E I of the sizes by the book."""
    glass = Sheet("glass", 8.0, 38000.0, density=1900.0, max_strain=0.012)
    stock = ThicknessLaw(glass, 1.5, 8.0, width=25.0)
    if law != "strip":
        stock = RoundLaw(glass, 1.5, 8.0, bore=0.6 if law == "tube" else 0.0)
    made = BattenSpec(2400.0, camber, place, stock).make()
    s = np.linspace(0.0, 2400.0, 801)
    size = made.table(s)[f"{stock.quantity}_mm"]
    EI = 38000.0 * (25.0 * size**3 / 12 if law == "strip" else np.pi / 64 * size**4 * (1 - stock.bore**4))
    unit = EI.max()

    def slopes(u, y, force):
        x, _, angle, moment = y
        bend = moment / (np.interp(u * 2400.0, s, EI) / unit)
        return np.array([np.cos(angle), np.sin(angle), bend, -force[0] * np.sin(angle) + 0 * x])

    def held(a, b, _):
        return np.array([a[0], a[1], a[3], b[3], b[0] - made.chord / 2400.0])

    u = s / 2400.0
    rod = made.strip.rod
    x, y = (np.interp(s, rod.s, column) / 2400.0 for column in rod.position.T)
    guess = np.array([x, y, np.interp(s, rod.s, rod.angle), -10.0 * y])
    found = solve_bvp(slopes, held, u, guess * 1.01, p=[10.0], tol=1e-7, max_nodes=40000)
    assert found.success
    deep = np.abs(found.sol(u)[1])
    k = int(deep.argmax())
    assert deep[k] * 2400.0 / made.chord == pytest.approx(camber, rel=1e-3)
    assert found.sol(u)[0][k] * 2400.0 / made.chord == pytest.approx(place, abs=5e-3)
    assert abs(found.p[0]) * unit / 2400.0**2 == pytest.approx(made.end_force, rel=1e-2)
    assert np.hypot(*(found.sol(u)[:2] - (x, y))).max() < 1e-4


@pytest.mark.parametrize("full", [0.0, 0.3, 0.6])
def test_part_of_the_length_keeps_its_size(full):
    """Another family of tapers: the same camber at the same place."""
    stock = ThicknessLaw(Sheet("glass", 8.0, 38000.0, density=1900.0, max_strain=0.012), 2.0, 8.0, width=25.0)
    made = BattenSpec(2400.0, 0.1, 0.4, stock, full=full).make()
    assert made.camber == pytest.approx((0.1, 0.4), abs=1e-5)
    s = np.linspace(0.0, 2400.0, 49)
    size = made.table(s)["thickness_mm"]
    inside = s < 2400.0 * (1 - full) - 60
    assert size[s > 2400.0 * (1 - full) + 60] == pytest.approx(8.0, abs=0.02)
    assert np.abs(np.diff(size[inside], 2)).max() < 0.02
    assert size[0] < 4.1


RUBBER = Sheet("rubbery", 2.0, 900.0, density=1150.0, max_strain=0.05)


def lying_level(made, bulging):
    """Camber, place, end force in N and the shape in lengths, by an independent solver from the sizes alone."""
    rod, L, law = made.strip.rod, made.spec.length, made.spec.stock
    side = np.sign(rod.position[rod.s.size // 2, 1])
    size, bore, E = made.strip.layout.size, getattr(law, "bore", None), law.sheet.youngs_modulus
    inertia = 25.0 / 12 if bore is None else np.pi / 64 * (1 - bore**4)
    area = 25.0 if bore is None else np.pi / 4 * (1 - bore**2)
    power = 3 if bore is None else 4
    unit = E * inertia * law.largest**power
    pull = {"up": -side, "down": side, None: 0.0}[bulging]
    pull *= law.sheet.density * 9.80665e-9 * area * L**3 / unit

    def slopes(u, y):
        t = size(u * L)
        c, sn = np.cos(y[2]), np.sin(y[2])
        bend = y[3] / (t / law.largest) ** power
        return np.array([c, sn, bend, y[4] * sn - y[5] * c, 0 * c, -pull * t ** (power - 2)])

    def held(a, b):
        return np.array([a[0], a[1], a[3], b[3], b[0] - made.chord / L, b[1]])

    begin = np.vstack(
        [rod.position.T / L, 1.02 * rod.angle, -10.0 * rod.position[:, 1] / L, -10.0 + 0 * rod.s, 0 * rod.s]
    )
    found = solve_bvp(slopes, held, rod.s / L, begin, tol=1e-7, max_nodes=40000)
    assert found.success
    u = np.linspace(0, 1, 20001)
    x, y = found.sol(u)[:2] / (made.chord / L)
    k = int(np.abs(y).argmax())
    force = float(np.hypot(*found.sol(0.0)[4:6])) * unit / L**2
    return abs(y[k]), x[k], force, found.sol(rod.s / L)[:2].T


@pytest.mark.parametrize("bulging", ["up", "down"])
def test_weight_moves_the_camber_as_an_independent_solver_has_it(bulging):
    made = BattenSpec(900.0, 0.12, 0.44, ThicknessLaw(RUBBER, 2.0, 8.0, width=25.0)).make()
    depth, at, *_ = lying_level(made, bulging)
    camber, place = made.camber_with_weight(bulging=bulging)
    assert (camber, place) == (pytest.approx(depth, abs=1e-5), pytest.approx(at, abs=5e-4))
    assert abs(place - 0.44) > 0.005


@pytest.mark.parametrize("bore", [None, 0.0, 0.6], ids=["strip", "rod", "tube"])
def test_battens_light_and_heavy(bore):
    """Standing, lying and bulging up, lying and bulging down in turn: the camber is where it is asked for."""
    rng = np.random.default_rng(7)
    found = []
    for i in range(6):
        stock = ThicknessLaw(RUBBER, 1.0, 8.0, width=25.0)
        if bore is not None:
            stock = RoundLaw(RUBBER, 1.0, 8.0, bore=bore)
        camber, place, bulging = rng.uniform(0.1, 0.2), rng.uniform(0.44, 0.56), (None, "up", "down")[i % 3]
        made = BattenSpec(900.0, camber, place, stock, lying=bulging).make()
        depth, at, force, shape = lying_level(made, bulging)
        strayed = np.hypot(*(shape - made.strip.rod.position / 900.0).T).max()
        found.append((abs(depth / camber - 1), abs(at - place), abs(force / made.end_force - 1), strayed))
        assert made.table(np.linspace(0.0, 900.0, 31))[f"{stock.quantity}_mm"].max() == pytest.approx(
            8.0, rel=1e-3
        )
    depth, place, force, strayed = np.array(found).max(axis=0)
    assert depth < 1e-4
    assert place < 1e-3  # of the chord; asked is 5e-3
    assert force < 1e-4  # asked is 1e-2
    assert strayed < 1e-6  # of the length; asked is 1e-4


@pytest.mark.parametrize("bulging", ["up", "down"])
def test_a_batten_that_lies_is_planed_otherwise(bulging):
    stock = ThicknessLaw(RUBBER, 1.0, 8.0, width=25.0)
    light, heavy = (
        BattenSpec(900.0, 0.12, 0.44, stock, lying=way).make().table([0.0])["thickness_mm"].item()
        for way in (None, bulging)
    )
    assert abs(light - heavy) > 0.2


def test_what_is_too_heavy_to_bulge_is_reported():
    soft = Sheet("soft", 2.0, 60.0, density=1300.0, max_strain=0.2)
    with pytest.raises(
        NotConvergedError, match=r"snaps over under its own weight|no taper was found|no equilibrium"
    ):
        BattenSpec(2400.0, 0.05, 0.5, ThicknessLaw(soft, 1.0, 4.0, width=25.0), lying="up").make()


def test_leaves_instead_of_a_plane(tmp_path, check_drawing_file):
    result = run("batten", *ASKED, "--stock", 25, 8, "--least", 3, "--leaves", 4, "-o", tmp_path)
    assert "4 plies of 2 mm" in result.output
    report = json.loads((tmp_path / "batten.json").read_text())
    assert report["camber"] == pytest.approx(0.1, abs=2e-3)
    assert report["camber_place"] == pytest.approx(0.4, abs=1e-2)
    rows = list(csv.DictReader((tmp_path / "batten.csv").read_text().splitlines()))
    lengths = [float(row["length_mm"]) for row in rows]
    assert lengths == pytest.approx([one["length_mm"] for one in report["leaves"]], abs=0.01)
    assert (lengths[0], len(lengths), {row["thickness_mm"] for row in rows}) == (2400.0, 4, {"2"})
    outlines = [one for one in check_drawing_file(tmp_path / "batten.dxf") if one.layer == "CUT_OUTER"]
    assert sorted(one.area for one in outlines) == pytest.approx(sorted(25.0 * np.array(lengths)), rel=1e-4)
    assert sum(lengths) * 25 * 2 * 1.41e-3 == pytest.approx(report["mass_g"], rel=0.01)
    bodies = (tmp_path / "batten.step").read_text().count("MANIFOLD_SOLID_BREP")
    assert bodies == 2 * len(lengths)  # flat and bent


@pytest.mark.parametrize(("place", "towards"), [(25, "at least"), (80, "at most")])
def test_the_place_that_is_reported_instead_can_be_made(place, towards, tmp_path):
    options = ("--sheet", "pom-1", "--length", 2400, "--camber", 10, "--stock", 25, 8, "-o", tmp_path)
    refused = run("batten", *options, "--at", place, code=1)
    result = re.search(rf"Move the largest camber to {towards} (\d\d\.\d) %", refused.output)[1]
    made = run("batten", *options, "--at", result)
    assert re.search(
        rf"Camber      [\d.]+ mm \(10 % of the chord\) at [\d.]+ mm \({float(result):g} %\)", made.output
    )


def test_stock_as_it_is_sold_in_inches(tmp_path):
    run("batten", *ASKED, "--stock", "1in", "5/16in", "-o", tmp_path)
    *_, thick = csv.DictReader((tmp_path / "batten.csv").read_text().splitlines())
    assert float(thick["thickness_inch"]) == pytest.approx(0.3125, abs=5.1e-4)


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--stock", 25, 8, "--rod", 6), "--stock WIDTH THICKNESS for a strip, or --rod"),
        ((), "The material of the batten is missing"),
        (
            ("--stock", 25, 8, "--at", 95),
            r"the thin end would be thinner than the limit of 2 mm. Move the largest camber to at most \d\d\.\d %",
        ),
        (("--stock", 25, 8, "--least", 6), r"would be thinner than the limit of 6 mm \(it needs 3.3\d mm\)"),
        (
            ("--stock", 25, 8, "--least", 6, "--at", 30),
            r"Move the largest camber to at least \d\d\.\d % of the chord",
        ),
        (
            ("--stock", 25, 8, "--least", 6, "--at", 70),
            r"Move the largest camber to at most \d\d\.\d % of the chord",
        ),
        (("--stock", 25, 8, "--bore", 0.5), "--bore has no effect without --rod"),
        (("--stock", 25, 8, "--every", 0.1), r"--every is 0.1 mm\. Choose [\d.]+ mm to [\d.]+ mm,"),
        (("--rod", 8, "--leaves", 4), "--leaves has no effect without --stock"),
        (("--stock", 25, 8, "--leaves", 4, "--stations", 5), "--stations has no effect beside --leaves"),
        (("--stock", 25, 8, "--full", 95), "full size over 95 % of its length. Set --full to 0 to 80 %"),
        (("--rod", 8, "--full", 95), "full size over 95 % of its length. Set --full to 0 to 80 %"),
        (("--stock", 25, 8, "--leaves", 1), "2<=x<=50"),
    ],
)
def test_a_slip_is_one_sentence(arguments, said, tmp_path):
    result = run(
        "batten", *ASKED, *arguments, "-o", tmp_path, code=1 if "thinner" in said or "Move" in said else 2
    )
    assert re.search(said, result.output), result.output
    assert not list(tmp_path.iterdir())


def test_a_batten_for_a_curve_of_ones_own_has_the_same_papers(tmp_path, check_drawing_file):
    glass = Sheet.named("gfrp-2")
    sheer = PlaneCurve.spline([(0, 0), (600, 1500), (1500, 1900), (2400, 1500), (3000, 0)])
    spec = StripSpec(sheer, glass, section=ThicknessLaw(glass, 1.0, 4.0, width=20.0), label="sheer")
    found = solve_rod(spec.rod_spec)
    result = StripResult(spec, found, spec.make(found), "own")
    files = {file.name: file for file in result.kit(StripFiles(step=False)).files}
    assert {"own-bench.csv", "own-side.dxf", "own-side.svg", "own-side.pdf"} <= {*files}
    for name in ("own-bench.csv", "own-side.dxf"):
        files[name].write(tmp_path / name)
    rows = list(csv.DictReader((tmp_path / "own-bench.csv").read_text().splitlines()))
    sizes = np.array([float(row["thickness_mm"]) for row in rows])
    assert sizes.max() == pytest.approx(4.0, rel=1e-2)
    assert [float(row["thickness_inch"]) for row in rows] == pytest.approx(sizes / 25.4, abs=8e-4)
    assert max(len(row["thickness_inch"]) for row in rows) == len("0.157")
    assert max(float(row["strain_percent"]) for row in rows) == pytest.approx(
        100 * result.strip.max_strain, abs=6e-4
    )
    ticks = [text.text for text in bench_drawing(result.strip).texts]
    assert ticks[1] == f"{float(rows[1]['from_tip_mm']):.1f}: {sizes[1]:.2f}"
    message = " ".join(ticks[len(rows) :])
    assert message.startswith("sheer Glass fibre (GFRP), 20 mm wide: plane both faces alike hold the ends 30")
    along = np.array([[float(row[key]) for key in ("s_mm", "from_tip_mm", "from_tip_inch")] for row in rows])
    (first, *_), (last, *_) = along[[0, -1]]
    assert (first, last - result.strip.rod.length) == pytest.approx((-10.0, 10.0), abs=0.005)
    assert along[:, 1] == pytest.approx(along[:, 0] + 10)
    assert along[:, 2] == pytest.approx(along[:, 1] / 25.4, abs=6e-4)
    assert [rows[k]["strain_percent"] for k in (0, -1)] == ["0", "0"]
    (side,) = [one for one in check_drawing_file(tmp_path / "own-side.dxf") if one.layer == "CUT_OUTER"]
    assert side.area == pytest.approx(np.trapezoid(sizes, [float(row["s_mm"]) for row in rows]), rel=1e-2)


@pytest.mark.parametrize("camber", [9, 33])
def test_a_batten_of_constant_size_needs_no_wider_limits(camber, tmp_path):
    """The sizes of the fitted shape differ from the limit by 1e-5."""
    result = run(
        "batten", "--sheet", "glass-rod-4", "--length", 900, "--camber", camber, "--rod", 4, "--least", 4,
        "--every", 300, "-o", tmp_path,
    )  # fmt: skip
    assert f"({camber} % of the chord)" in result.stdout
