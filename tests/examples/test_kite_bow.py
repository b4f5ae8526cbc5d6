"""The example of a bow: a rod under a cord, even and tapered."""

import runpy

import pytest


def test_a_tapered_spar_follows_the_drawn_curve_and_pulls_less(project_root, tmp_path, capsys):
    main = runpy.run_path(str(project_root / "examples" / "bow" / "kite.py"))["main"]
    even, taper = main(tmp_path / "bow")
    assert (tmp_path / "bow" / "bow.png").stat().st_size > 10_000
    assert even.cord == pytest.approx(800)
    assert taper.deviation < 0.5 < even.deviation
    assert taper.pull < even.pull
    assert f"pull {taper.pull:.1f} N" in capsys.readouterr().out
