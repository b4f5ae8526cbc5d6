from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from elastica_cad import Drawing, InputError, MissingDependencyError, PlaneCurve, read_curves, save
from elastica_cad import Path as GeometryPath
from elastica_cad.cli.commands import elastica
from elastica_cad.files import CURVE_FORMATS
from elastica_cad.formats import curves_json
from elastica_cad.geometry import Spline
from elastica_cad.strip import LayeredPath
from elastica_cad.web.vocabulary import page_words


def test_the_suffix_chooses_the_reader(tmp_path):
    arch = PlaneCurve.arc((0, 0), 50, 0.3, 2.0)
    (tmp_path / "a.JSON").write_text(curves_json([arch]))
    (tmp_path / "a.csv").write_text("\n".join(f"{x},{y}" for x, y in arch.sample(60).position))
    (tmp_path / "a.txt").write_text("2 3\n0 0\n50 80\n100 0\n")
    assert read_curves(tmp_path / "a.JSON")[0].length == arch.length
    assert read_curves(str(tmp_path / "a.csv"))[0].length == pytest.approx(arch.length, abs=0.05)
    assert read_curves(tmp_path / "a.txt", unit="cm")[0].degree == 2


def test_svg_and_dxf(tmp_path):
    import ezdxf

    (tmp_path / "a.svg").write_text("<svg><path d='M 0 0 Q 10 20 30 0'/></svg>")
    document = ezdxf.new()
    document.modelspace().add_arc((0, 0), 5, 0, 90)
    document.saveas(tmp_path / "a.dxf")
    assert read_curves(tmp_path / "a.svg", unit="mm")[0].control_points[1] == pytest.approx((10, -20))
    assert read_curves(tmp_path / "a.dxf", unit="mm")[0].length == pytest.approx(2.5 * np.pi)


SUFFIXES = [suffix for kind in CURVE_FORMATS for suffix in kind.suffixes]


@pytest.mark.parametrize("kind", CURVE_FORMATS, ids=lambda kind: kind.name)
def test_every_format_is_offered_everywhere(kind):
    text = " ".join(CliRunner().invoke(elastica, ["--help"]).output.split())
    assert kind.name in text
    assert kind.remark in text
    assert all(suffix in read_curves.__doc__ for suffix in kind.suffixes)
    assert set(kind.suffixes) & set(page_words()["dropped"]) == set(kind.suffixes if kind.is_text else ())


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_no_file_of_that_kind_gets_one_sentence(tmp_path, suffix):
    missing, folder, empty, junk = (tmp_path / f"{n}{suffix}" for n in ("missing", "folder", "empty", "junk"))
    folder.mkdir()
    empty.touch()
    for path, words in (
        (missing, "cannot be read: No such file"),
        (folder, "is a folder: name one file in it"),
        (empty, "is empty"),
    ):
        with pytest.raises(InputError, match=words) as caught:
            read_curves(path)
        assert str(path) in str(caught.value)
        assert "\n" not in str(caught.value)
    junk.write_bytes(b"\x89PNG\r\n\x1a\n\x00\x00 junk")
    with pytest.raises((InputError, MissingDependencyError)) as caught:
        read_curves(junk)
    assert "junk" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_unknown_suffix(tmp_path):
    (tmp_path / "a.dwg").write_text("x")
    with pytest.raises(
        InputError, match=r"a\.dwg ends in '\.dwg', but files of curves end in \.dxf, \.svg, \.svgz, \.csv"
    ):
        read_curves(tmp_path / "a.dwg")
    (tmp_path / "plain").write_text("x")
    with pytest.raises(InputError, match="ends in ''"):
        read_curves(tmp_path / "plain")


def test_file_without_permission(tmp_path, monkeypatch):
    def refuse(self, *args, **kwargs):
        raise PermissionError(13, "Permission denied", str(self))

    (tmp_path / "a.csv").write_text("0,0\n1,1\n")
    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(InputError, match=r"a\.csv cannot be read: Permission denied"):
        read_curves(tmp_path / "a.csv")


@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
def test_what_is_saved_is_read_back(tmp_path, suffix):
    curve = PlaneCurve.spline([(20, 30), (50, 90), (80, -10), (110, 40), (150, 35)], degree=3)
    mark = LayeredPath("MARK", GeometryPath((Spline(curve),), closed=False))
    written = save(Drawing("part", (mark,), ()), tmp_path / f"part{suffix}")
    (back,) = read_curves(written)
    assert back.length == pytest.approx(curve.length, rel=1e-5)
    gap = back.sample(40).position - curve.sample(40).position
    if suffix == ".svg":  # a page has its own origin, in its upper left corner
        gap = gap - gap[0]
    assert np.abs(gap).max() < 1e-3
    with pytest.raises(InputError, match="exists already"):
        save(Drawing("part", (mark,), ()), written)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("one.csv", "3,4\n", "has fewer than two different points: draw the curve again, or leave it out"),
        ("null.json", "null", "has no record.*: give a file that elastica wrote"),
        ("other.json", "{}", "reports of strips: give a file of one of these kinds"),
        (
            "far.svg",
            '<svg><path d="M 0 0 L 1e40 2"/></svg>',
            "has the unusable number 1e40 in a path: export the file again",
        ),
    ],
)
def test_what_cannot_be_read_says_what_to_do(tmp_path, name, text, told):
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=f"{told}$"):
        read_curves(tmp_path / name)
