import json

import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve, read_curves, write_curves
from elastica_cad.formats import curve_record, curves_json

pytestmark = pytest.mark.core

CURVES = [
    PlaneCurve.ellipse((1 / 3, 0.1), (70, 40), 0.3, 0.2, 2.0),
    PlaneCurve(np.arange(9.0) / 7, [(0, 0), (30, 40), (60, -40), (90, 10), (120, 0)], 3),
]


@pytest.fixture
def read(tmp_path):
    def written(content, **options):
        path = tmp_path / "curves.json"
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return read_curves(path, **options)

    return written


def test_round_trip_is_bit_by_bit_and_reproducible(read):
    text = curves_json(CURVES)
    assert text == curves_json(CURVES)
    for curve, back in zip(CURVES, read(text), strict=True):
        assert np.array_equal(back.knots, curve.knots)
        assert np.array_equal(back.control_points, curve.control_points)
        assert back.degree == curve.degree
        assert (back.weights is None) == (curve.weights is None)
        assert curve.weights is None or np.array_equal(back.weights, curve.weights)


def test_written_file_is_whole_and_not_overwritten(tmp_path):
    path = write_curves(CURVES, tmp_path / "a.json")
    assert [c.length for c in read_curves(path)] == [c.length for c in CURVES]
    with pytest.raises(InputError, match="exists already"):
        write_curves(CURVES[:1], path)
    write_curves(CURVES[:1], path, force=True)
    assert len(read_curves(path)) == 1
    assert [p.name for p in tmp_path.iterdir()] == ["a.json"]


def test_one_curve_is_written_as_a_row_of_one(tmp_path):
    arch = PlaneCurve.arc((0, 0), 80, 0.3, 2.8)
    (read,) = read_curves(write_curves(arch, tmp_path / "arch.json"))
    assert read.length == arch.length
    with pytest.raises(InputError, match=r"curves contain 3\. Pass only PlaneCurve records"):
        write_curves(3, tmp_path / "three.json")


def test_report_of_a_strip_holds_its_curve(read):
    report = {"schema": "elastica-report/1", "units": {"length": "mm"}, "curve": curve_record(CURVES[0])}
    (back,) = read(report)
    assert np.array_equal(back.control_points, CURVES[0].control_points)


def test_units(read):
    record = {"schema": "elastica-curves/1", "units": "cm", "curves": [curve_record(CURVES[1])]}
    assert read(record)[0].length == pytest.approx(10 * CURVES[1].length)
    assert read(record, unit="in")[0].length == pytest.approx(25.4 * CURVES[1].length)


def broken(**changes):
    record = curve_record(CURVES[1]) | changes
    return {"schema": "elastica-curves/1", "curves": [{k: v for k, v in record.items() if v != "gone"}]}


@pytest.mark.parametrize(("content", "words"), [
    ("{", "is not JSON"),
    ("[" * 100000, "too deep"),
    ("[1, 2]", "has no record"),
    ({"curves": []}, "has the schema None"),
    ({"schema": "elastica-curves/2"}, "newer than this program"),
    ({"schema": "elastica-curves/1", "curves": []}, "has no list of curves"),
    ({"schema": "elastica-curves/1", "units": "parsec", "curves": [1]}, "unknown unit 'parsec'"),
    ({"schema": "elastica-curves/1", "curves": [1]}, "curve 1 is not a curve"),
    (broken(knots="gone"), "curve 1 has no 'knots'"),
    (broken(degree=3.5), "degree is 3.5"),
    (broken(knots=["a"]), "not a number"),
    (broken(control_points=[1, 2]), "rows of x and y"),
    (broken(control_points=[[1, 2], [3]]), "not a number"),
    (broken(control_points=[[0, 0]] * 5), "curve 1: .*coincide"),
    (broken(knots=[0, 1]), "curve 1: .*give 9 knots"),
    (broken(weights=[1, 1, 1, 1, float("nan")]), "curve 1: .*NaN"),
])  # fmt: skip
def test_bad_files_get_one_sentence(read, content, words):
    with pytest.raises(InputError, match=rf"curves\.json: .*{words}") as caught:
        read(content)
    assert "\n" not in str(caught.value)
