"""The JSON of `elastica bend` has all forces on the strip: their sum and their moments are zero."""

import json

import numpy as np
import pytest

from tests.command_line import run

ARCH = "0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n"
ALL = "--rail 180 --pin 250 --tie 60 320 --point-mass 180 40 --point-force 100 0.1 -0.2 --gravity"


@pytest.mark.parametrize(
    "line",
    [
        f"arch.csv --sheet pom-1 --max-width 12 --set samples=201 {ALL} --to 365 2 --steps 2",
        f"arch.csv --rod 4 --sheet gfrp-1 {ALL}",
        "--straight 400 --sheet pom-1 --max-width 12 --gravity --hold-end free",
        "arch.csv --to 340 0 --rail 180",
    ],
)
def test_forces_and_moments_of_every_shape_are_balanced(tmp_path, monkeypatch, line):
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)
    (tmp_path / "arch.csv").write_text(ARCH)
    answer = json.loads(run(f"bend {line} --json", cwd=tmp_path).stdout)
    for shape in answer["shapes"]:
        held, weight = shape["reactions"], shape["weight"]
        forces = [
            (force, point)
            for element in (*shape["between"], *shape["masses"])
            for force, point in zip(element["force"], element["points"], strict=True)
        ]
        forces += [(held["start_force"], shape["start"]), (held["end_force"], shape["end"])]
        forces += [] if weight is None else [(weight["force"], weight["center"])]
        f, p = np.array(forces).transpose(1, 0, 2)
        moments = np.append(p[:, 0] * f[:, 1] - p[:, 1] * f[:, 0], [held["start_moment"], held["end_moment"]])
        assert np.abs(f.sum(axis=0)).max() < 1e-6 * np.abs(f).sum()
        assert abs(moments.sum()) < 1e-6 * np.abs(moments).sum()
    kinds = {element["kind"] for element in (*shape["between"], *shape["masses"])}
    assert "--pin" not in line or kinds == {"rail", "pin", "tie", "point force", "point mass"}
