import copy
import os
import pickle
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve, Sheet, load_sheets, sheet_names
from elastica_cad.mechanics.sheets import (
    NominalRatio,
    least_plywood_radius,
    library_files,
    library_folders,
    library_sheets,
    sheet_keys,
    sheets_for_curve,
)
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

PLY = {"thickness": 0.8, "youngs_modulus": 9250.0, "density": 680.0, "max_strain": 0.008}
ENTRY = "thickness_mm = 0.8\nyoungs_modulus_MPa = 9250\ndensity_kg_m3 = 680\nmax_strain = 0.008\n"


def written(tmp_path, text):
    path = tmp_path / "sheets.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_card_has_the_length_that_the_authors_measured():
    card = Sheet.named("card-200gsm")
    assert card.elasto_gravity_length == pytest.approx(1000 * 8.86e-4 ** (1 / 3), rel=1e-12)
    assert round(card.elasto_gravity_length, 1) == 96.0
    assert card.density * card.thickness == pytest.approx(200.0)  # g/m2
    assert card.least_radius == pytest.approx(20.0)


def test_gravity_carries_length_and_direction():
    gravity = Sheet("ply", **PLY).gravity(direction=(3, -4))
    h, rho, g, modulus = 0.8e-3, 680.0, 9.80665, 9250e6
    assert gravity.length == pytest.approx(1e3 * (modulus * h**2 / (12 * rho * g)) ** (1 / 3))
    assert gravity.direction == pytest.approx((0.6, -0.8))
    assert Sheet("ply", **PLY).gravity().direction == (0.0, -1.0)


def test_stiffness_and_radius():
    sheet = Sheet("ply", **PLY)
    assert sheet.bending_stiffness(30.0) == pytest.approx(9250 * 0.8**3 * 30 / 12)
    assert sheet.least_radius == pytest.approx(50.0)


@pytest.mark.parametrize(("thickness", "radius"), [(0.89, 51.0), (1.78, 132.0), (2.54, 218.0), (3.18, 305.0)])
def test_plywood_follows_the_published_bend_radii(thickness, radius):
    strains = {
        Sheet.named(n).thickness: Sheet.named(n).max_strain for n in sheet_names() if n.startswith("birch")
    }
    thick = {h: strains.pop(h) for h in (4.0, 6.0)}
    for h, strain in thick.items():
        assert h / (2 * strain) == pytest.approx(least_plywood_radius(h, "along"), rel=1e-3)
    h = np.array(sorted(strains))
    expected = np.interp(h, [0.89, 1.78, 2.54, 3.18], [0.89 / 102, 1.78 / 264, 2.54 / 436, 3.18 / 610])
    assert [strains[t] for t in h] == pytest.approx(expected)
    assert min(strains.values()) < thickness / (2 * radius) + 3e-4 < max(strains.values()) + 6e-4


@pytest.mark.parametrize("name", [
    "birch-plywood-0.8", "card-200gsm", "pom-0.5", "polypropylene-0.8", "petg-0.5", "acrylic-2", "mdf-3",
    "hdf-1.5", "aluminium-6061-0.5", "spring-steel-0.2", "gfrp-1",
])  # fmt: skip
def test_library_holds(name):
    assert name in sheet_names()
    assert Sheet.named(name).name == name


def test_every_built_in_sheet_states_source_and_ranges():
    for name in sheet_names():
        sheet = Sheet.named(name)
        assert len(sheet.source) > 40
        assert sheet.kind
        low, high = sheet.range_of("youngs_modulus")
        assert low <= sheet.youngs_modulus <= high
        assert 0.002 < sheet.max_strain < 0.02
        assert sheet.range_of("max_strain")[0] < sheet.range_of("max_strain")[1]
        assert sheet.kerf > 0 or "kerf not published" in sheet.source
        assert (sheet.grain != "none") == (sheet.kind in ("plywood", "card", "composite", "rod", "wood"))
        assert ("-across-" in name) == (sheet.grain == "across")


@pytest.mark.parametrize(("plies", "name"), [(3, "3.6"), (5, "6.4")])
def test_finnish_plywood_is_its_veneers_laid_crosswise(plies, name):
    """Veneers of 17.5 GPa and 70 MPa; of 13 plies, sold as 18 mm, the handbook has 10048 and 7452 MPa."""
    veneer, layers = 17500.0, np.array([1.1, *[1.4] * (plies - 2), 1.1])
    edges = np.concatenate([[0.0], np.cumsum(layers)]) - layers.sum() / 2
    h, second = layers.sum(), np.diff(edges**3) / 3
    shares = [float(second[way::2].sum() / (h**3 / 12)) for way in (0, 1)]
    strength = [70.0 * shares[0], 70.0 * shares[1] * (h / 2) / (h / 2 - 1.1)]
    for grain, share, strong in zip(("", "across-"), shares, strength, strict=True):
        sheet = Sheet.named(f"finnish-birch-plywood-{grain}{name}")
        assert sheet.thickness == pytest.approx(h)
        assert sheet.youngs_modulus == pytest.approx(veneer * share, abs=0.5)
        assert sheet.max_strain == pytest.approx(h / (2 * sheet.published_radius), rel=1e-6)
        assert sheet.range_of("max_strain")[0] == pytest.approx(strong / sheet.youngs_modulus / 2, rel=2e-3)


def test_grain_in_degrees_is_along_or_across_or_refused():
    assert [Sheet("ply", **PLY, grain=degrees).grain for degrees in (0, 90, 180)] == [
        "along",
        "across",
        "along",
    ]
    with pytest.raises(
        InputError, match=r"grain is 30 degrees, .* twists .*\. Lay the strip along \(0\) or across \(90\)"
    ):
        Sheet("ply", **PLY, grain=30)


def test_range_of_a_certain_number_is_the_number_twice():
    assert Sheet("ply", **PLY).range_of("density") == (680.0, 680.0)
    with pytest.raises(InputError, match="no range of 'colour'"):
        Sheet("ply", **PLY).range_of("colour")


test_unknown_name_offers_near_ones = refusal_test(
    [
        (
            lambda: Sheet.named("birch-ply-0.8"),
            r"unknown sheet 'birch-ply-0.8': did you mean birch-plywood-0\.8",
        ),
        (lambda: Sheet.named("birch-plywood-8"), "-8': use birch-plywood-6 and set thickness to 8 mm$"),
        (lambda: Sheet.named("Birch-plywood-0.5mm"), "use birch-plywood-0.6 and set thickness to 0.5 mm$"),
        (lambda: Sheet.named("birch-plywood-0"), "use one of birch-plywood-0.6, birch-plywood-0.8$"),
        (lambda: Sheet.named("zzzz"), "known sheets: card-200gsm"),
    ]
)


@pytest.mark.parametrize(("change", "words"), [
    ({"thickness": 0.0}, "thickness is 0.0: give a number above 0, in mm"),
    ({"thickness": "0.8"}, "give a number"),
    ({"youngs_modulus": float("nan")}, "youngs_modulus is nan: give a number"),
    ({"density": -1.0}, "density is -1.0: give a number above 0, in kg/m3"),
    ({"max_strain": None}, "max_strain is None"),
    ({"kerf": -0.1}, "kerf is -0.1: give a number from 0"),
    ({"poisson_ratio": 1.0}, "poisson_ratio is 1"),
    ({"grain": "sideways"}, "use one of along, across, none"),
    ({"density_range": (700.0, 800.0)}, "write a range that contains density = 680"),
    ({"density_range": (700.0,)}, "give 2 numbers from 0"),
    ({"name": " "}, "the name of a sheet is"),
    ({"name": "\u200b"}, "the name of a sheet is ''"),
])  # fmt: skip
def test_impossible_sheets_are_refused(change, words):
    with pytest.raises(InputError, match=words):
        Sheet(**({"name": "ply"} | PLY | change))


def test_every_field_has_a_key_in_the_file():
    assert {one.name for one in sheet_keys().values()} == set(Sheet.__dataclass_fields__) - {
        "name",
        "poisson_known",
    }


def test_a_poisson_ratio_is_known_where_somebody_vouches_for_it(tmp_path):
    """However the sheet is passed on: changed, copied, pickled, written and read."""
    given, none = Sheet("ply", **PLY, poisson_ratio=0.3), Sheet("ply", **PLY)
    nominal = Sheet("ply", **PLY, poisson_ratio=NominalRatio(0.1))
    assert [sheet.poisson_known for sheet in (given, none, nominal)] == [True, False, False]
    assert given.poisson_ratio == none.poisson_ratio == 0.3
    assert given != none
    assert len({given, none, replace(none), replace(given)}) == 2
    for sheet in (given, none, nominal):
        path = written(tmp_path, sheet.toml())
        assert sheet == load_sheets(path)["ply"] == pickle.loads(pickle.dumps(sheet)) == copy.deepcopy(sheet)
        assert replace(sheet, density=700.0).poisson_known == sheet.poisson_known
        assert sheet.with_thickness(1.0).poisson_known == sheet.poisson_known
        assert replace(sheet, poisson_ratio=0.35).poisson_known
    assert load_sheets(written(tmp_path, f"[sheets.mine]\n{ENTRY}poisson_ratio = 0.3\n"))[
        "mine"
    ].poisson_known
    twice = f"[sheets.mine]\n{ENTRY}poisson_ratio = 0.3\nnominal_poisson_ratio = 0.3\n"
    with pytest.raises(InputError, match="poisson_ratio is given twice; remove nominal_poisson_ratio"):
        load_sheets(written(tmp_path, twice))


def test_a_shear_modulus_goes_through_a_file_and_is_nobodys_guess(tmp_path):
    given, none = Sheet("ply", **PLY, shear_modulus=620.0), Sheet("ply", **PLY)
    assert given.shear_ratio == 620 / given.youngs_modulus
    assert none.shear_ratio == pytest.approx(1 / 2.6)
    file = written(tmp_path, given.toml())
    assert load_sheets(file)["ply"] == given
    assert "shear_modulus" not in none.toml()
    with pytest.raises(InputError, match="shear_modulus is -1: give a number above 0, in MPa"):
        Sheet("ply", **PLY, shear_modulus=-1)
    with pytest.raises(
        InputError, match=r"shear_modulus_MPa = 0.00000062 looks like the wrong unit; N/mm2: 620"
    ):
        load_sheets(written(tmp_path, f"[sheets.mine]\n{ENTRY}shear_modulus_MPa = 6.2e-7\n"))


def test_the_library_knows_a_poisson_ratio_that_has_a_source():
    sheets = list(map(Sheet.named, sheet_names()))
    assert all(sheet.poisson_known == ("nu: " in sheet.source) for sheet in sheets)
    known = {sheet.name for sheet in sheets if sheet.poisson_known}
    assert {"aluminium-6061-0.5", "spring-steel-0.2", "pom-1", "acrylic-3"} <= known
    assert not known & {"card-200gsm", "birch-plywood-0.8", "mdf-3"}


def test_sheets_file_round_trip(tmp_path):
    sheets = [replace(Sheet.named(n), name=f'my "{n}"') for n in sheet_names()]
    path = written(tmp_path, "schema = 1\n" + "\n".join(s.toml() for s in sheets))
    assert load_sheets(path) == {s.name: s for s in sheets}


def test_least_sheets_file(tmp_path):
    sheet = load_sheets(written(tmp_path, f"[sheets.mine]\n{ENTRY}"))["mine"]
    assert sheet == Sheet("mine", **PLY)


@pytest.mark.parametrize(("text", "words"), [
    ("[sheets.mine]\n" + ENTRY + "grain = 45\n", "grain is 45 degrees"),
    ("", "contains no sheet"),
    ("[sheets.mine", "is not a (valid )?TOML file"),
    ("[sheet.mine]\n", "unknown entry 'sheet'"),
    ("schema = 9\n[sheets.mine]\n" + ENTRY, "schema 9 is not known"),
    ("[sheets]\nmine = 3\n", "sheet 'mine' is 3; write a table"),
    ("[sheets.mine]\n" + ENTRY + "colour = 3\n", "unknown key 'colour'"),
    ("[sheets.mine]\n" + ENTRY + "thickness_cm = 0.08\n", r"write thickness_mm \(millimetres"),
    ("[sheets.mine]\n" + ENTRY + "youngs_modulus_GPa = 9\n", r"_MPa \(N/mm2: 9000 for 9 GPa\)"),
    ("[sheets.mine]\n" + ENTRY + "poison_ratio = 0.1\n", "did you mean poisson_ratio"),
    ("[sheets.mine]\n" + ENTRY.replace("9250", "9.25e9"), r"9\.25e\+09 looks like the wrong unit"),
    ("[sheets.mine]\n" + ENTRY.replace("680", "0.68"), "680 for 0.68 g/cm3"),
    ("[sheets.mine]\n" + ENTRY.replace("0.008", "0.8"), "a fraction: 0.008 for 0.8 %"),
    ("[sheets.mine]\n" + ENTRY.replace("0.8", "'0.8'"), "thickness_mm is '0.8'; write a number"),
    ("[sheets.mine]\n" + ENTRY.replace("0.8", "-0.8"), "thickness is -0.8: give a number above 0"),
    ("[sheets.mine]\n" + ENTRY.replace("density_kg_m3 = 680\n", ""), "density_kg_m3 is missing"),
    ("[sheets.mine]\n" + ENTRY + "source = 3\n", "write text in quotes"),
    ("[sheets.mine]\n" + ENTRY + "density_range_kg_m3 = 3\n", "write two numbers"),
])  # fmt: skip
def test_bad_sheets_files_get_one_sentence_that_names_the_file(tmp_path, text, words):
    with pytest.raises(InputError, match=words) as caught:
        load_sheets(written(tmp_path, text))
    assert "sheets.toml" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_sheets_file_that_cannot_be_read(tmp_path):
    with pytest.raises(InputError, match="is a folder"):
        load_sheets(tmp_path)
    with pytest.raises(InputError, match=r"none\.toml cannot be read: No such file"):
        load_sheets(tmp_path / "none.toml")
    (tmp_path / "b.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="cannot be read as TOML"):
        load_sheets(tmp_path / "b.toml")


@pytest.mark.parametrize(
    ("inches", "along", "across"),
    [(0.035, 2.0, 1.1), (0.125, 12.0, 7.1), (0.225, 27.0, 17.0), (0.250, 31.0, 20.0), (0.375, 54.0, 36.0)],
)
def test_the_published_radii_of_aircraft_plywood(inches, along, across):
    """Rows of FAA AC 43.13-1B, table 1-2."""
    assert least_plywood_radius(25.4 * inches, "along") == pytest.approx(25.4 * along)
    assert least_plywood_radius(25.4 * inches, "across") == pytest.approx(25.4 * across)


def test_radii_grow_with_thickness_and_end_with_the_table():
    found = [least_plywood_radius(h, "along") for h in np.linspace(0.8, 9.5, 60)]
    assert np.all(np.diff(found) > 0)
    assert least_plywood_radius(0.4, "along") is least_plywood_radius(12.0, "across") is None
    assert Sheet.named("pom-0.5").published_radius is None
    assert Sheet.named("birch-plywood-6").published_radius == pytest.approx(730.6, abs=0.1)


def test_another_thickness_of_the_same_material():
    thin, thick = (
        Sheet.named("pom-0.5").with_thickness(0.75),
        Sheet.named("birch-plywood-3").with_thickness(6),
    )
    assert (thin.name, thin.thickness, thin.max_strain) == (
        "pom-0.75",
        0.75,
        Sheet.named("pom-0.5").max_strain,
    )
    assert "figures of pom-0.5 at another thickness" in thin.source
    assert thick.max_strain == pytest.approx(Sheet.named("birch-plywood-6").max_strain, rel=0.01)
    assert Sheet.named("pom-1").with_thickness(1.0) is not None
    with pytest.raises(InputError, match="thickness is -1"):
        Sheet.named("pom-1").with_thickness(-1)


def test_the_library_of_a_user(tmp_path, monkeypatch):
    """Folders and files that the variable names; bad ones are told and do not hide the others."""
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "a.toml").write_text(f"[sheets.oak]\n{ENTRY}[sheets.pom-1]\n{ENTRY}")
    (folder / "b.toml").write_text("[sheets.ash]\nthickness = 3\n")
    monkeypatch.setenv("ELASTICA_SHEETS", f"{folder}{os.pathsep}{tmp_path / 'nowhere'}")
    assert sheet_names()[0] == "oak"
    assert "ash" not in sheet_names()
    assert Sheet.named("oak") == Sheet("oak", **PLY)
    assert Sheet.named("pom-1").youngs_modulus > 1000
    problems = library_sheets()[1]
    assert any("another sheet already has the name 'pom-1'" in text for text in problems)
    assert any("b.toml: sheet 'ash': unknown key 'thickness'" in text for text in problems)
    with pytest.raises(InputError, match=r"unknown sheet 'ash'.*b.toml"):
        Sheet.named("ash")
    (folder / "a.toml").write_text(f"[sheets.elm]\n{ENTRY}")
    assert sheet_names()[0] == "elm"
    monkeypatch.setenv("ELASTICA_SHEETS", str(folder / "a.toml"))
    assert sheet_names()[0] == "elm"


@pytest.mark.parametrize(
    ("platform", "variable", "place"),
    [("linux", "XDG_CONFIG_HOME", "elastica/sheets"), ("win32", "APPDATA", "elastica/sheets")],
)
def test_where_the_library_is(platform, variable, place, tmp_path, monkeypatch):
    monkeypatch.delenv("ELASTICA_SHEETS", raising=False)
    monkeypatch.setattr("sys.platform", platform)
    monkeypatch.setenv(variable, str(tmp_path))
    assert library_folders() == (tmp_path / place,)
    assert library_files() == ()


def test_a_sheet_of_a_file(tmp_path):
    path = written(tmp_path, f"[sheets.mine]\n{ENTRY}")
    assert Sheet.named(str(path)) == Sheet.named("sheets.toml", folder=tmp_path) == Sheet("mine", **PLY)
    written(tmp_path, f"[sheets.mine]\n{ENTRY}[sheets.other]\n{ENTRY}")
    assert Sheet.named(f"{path}:other").name == "other"
    with pytest.raises(
        InputError, match=r"there are 2 sheets; use the name sheets.toml:mine or sheets.toml:other"
    ):
        Sheet.named(str(path))
    with pytest.raises(InputError, match="there is no sheet 'third'"):
        Sheet.named(f"{path}:third")


@pytest.mark.parametrize("typed", ["Tr\u00e4ger 1", "Tra\u0308ger\u00a01", "Tr\u00e4\u00adger 1"])
def test_a_sheet_is_found_by_its_name_however_it_is_written(typed, tmp_path, monkeypatch):
    path = written(tmp_path, f'[sheets."Tra\u0308ger\u00a01"]\n{ENTRY}')
    monkeypatch.setenv("ELASTICA_SHEETS", str(path))
    assert [*load_sheets(path)] == [Sheet.named(typed).name] == ["Tr\u00e4ger 1"]
    assert Sheet.named(f"{path}:{typed}") == Sheet.named(typed)


def test_a_sheets_file_of_a_windows_editor_is_read(tmp_path):
    path, text = tmp_path / "mine.toml", f"[sheets.mine]\n{ENTRY}"
    path.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert load_sheets(path)["mine"].thickness == 0.8
    path.write_bytes(text.encode("utf-16"))
    with pytest.raises(InputError, match="save the file as UTF-8"):
        load_sheets(path)


def test_rods_are_materials_of_bows_but_no_sheet_to_cut_from():
    assert Sheet.named("carbon-rod-4").youngs_modulus == 127_000
    gentle = PlaneCurve.arc((0, 0), 900, 0, 0.3)
    assert all("rod" not in known.sheet.name for known in sheets_for_curve(gentle))


@pytest.mark.parametrize(
    ("figures", "words"),
    [
        ({"youngs_modulus": 9.2e9}, r"youngs_modulus = 9\.2e\+09 looks like the wrong unit; N/mm2"),
        ({"max_strain": 2}, "max_strain = 2 looks like the wrong unit; a fraction"),
        ({"density": 0.68}, "density = 0.68 looks like the wrong unit; kg/m3"),
        ({"thickness": 0.0008}, "thickness = 0.0008 looks like the wrong unit; millimetres"),
    ],
)
def test_figures_in_a_wrong_unit_are_refused_in_python_as_in_files(figures, words):
    with pytest.raises(InputError, match=words):
        Sheet("mine", **PLY | figures)
    with pytest.raises(InputError, match=words):
        replace(Sheet("mine", **PLY), **figures)


def test_a_share_of_the_weight_may_be_as_small_as_it_is():
    ply = Sheet("mine", **PLY)
    assert ply.with_weight_share(1e-6).density == pytest.approx(1e-6 * ply.density)
