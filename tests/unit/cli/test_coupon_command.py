"""`elastica coupon` as a user meets it: a strip to measure, a sheet from what was measured."""

import pytest
from click.testing import CliRunner

import elastica_cad as ec
from elastica_cad.cli.commands import elastica


def run(*arguments):
    return CliRunner().invoke(elastica, [str(argument) for argument in arguments])


def test_a_coupon_is_written(tmp_path, check_drawing_file):
    result = run("coupon", "--sheet", "card-200gsm", "--overhang", 120, "-o", tmp_path)
    assert result.exit_code == 0, result.output
    curves = check_drawing_file(tmp_path / "coupon-card-200gsm.dxf")
    (outline,) = [curve for curve in curves if curve.layer == "CUT_OUTER"]
    assert outline.area == pytest.approx(160 * 20)
    assert "exists already" in run("coupon", "--sheet", "card-200gsm", "-o", tmp_path).stderr


def test_a_measured_coupon_becomes_a_sheet(tmp_path):
    droop = float(ec.mechanics.cantilever_droop(150.0, 96.05))
    result = run("coupon", "--sheet", "card-200gsm", "--measured", 150, droop, "--measured", 120,
                 ec.mechanics.cantilever_droop(120.0, 96.05), "--thickness", 0.22, "--density", 900,
                 "--least-radius", 22, "--name", "mine", "-o", tmp_path)  # fmt: skip
    assert result.exit_code == 0, result.output
    sheet = ec.load_sheets(tmp_path / "mine.toml")["mine"]
    assert sheet.elasto_gravity_length == pytest.approx(96.05, abs=1e-4)
    assert sheet.least_radius == pytest.approx(22)
    assert (sheet.thickness, sheet.density, sheet.grain) == (0.22, 900, "along")
    assert "elasto-gravity length 96.05 +-" in result.output


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--sheet", "paper"), "unknown sheet 'paper'"),
        (("--sheet", "card-200gsm", "--density", 900), "--density belongs to a measurement"),
        (("--sheet", "card-200gsm", "--measured", 100, 120), "a droop of 120 mm is more than"),
        (("--sheet", "card-200gsm", "--measured", 160, 74, "--density", 0), "density is 0"),
        (("--sheet", "card-200gsm", "--measured", 160, 74, "--thickness", 0), "thickness is 0"),
        (("--sheet", "card-200gsm", "--measured", 160, 74, "--name", "a/b"), "leave out /"),
        (("--sheet", "card-200gsm", "--width", 2), "too narrow"),
    ],
)
def test_coupons_refuse_in_words(arguments, message):
    result = run("coupon", *arguments)
    assert result.exit_code == 2
    assert message in result.stderr
