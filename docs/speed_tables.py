"""Writes explanation/speed.md: python docs/speed_tables.py [FILE] [--busy].

FILE is what `make benchmark` writes (pytest-benchmark's JSON); what the page tells of it is kept in
tests/benchmarks/measured.json. Without it the page is written from what was kept. --busy tells that the machine had
other work.
"""

import argparse
import json
import re
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "explanation" / "speed.md"
KEPT = ROOT / "tests" / "benchmarks" / "measured.json"

HEAD = """# Speed

This page compares the speed of this program with other solvers, and shows how long its commands take.
`make benchmark` writes the page (`docs/speed_tables.py`, from `tests/benchmarks`).

The times are medians, and depend on the machine. A ratio divides our time by the time of the other task in
the same run. It depends little on the machine, and a ratio below 1 means that our task is faster. Both tasks
are ours unless another solver or scipy is named. Equations are those of [the paper](reproduce_the_paper.md).

A *rod* is a strip as it is computed, at points along it (*nodes*, *samples*). The *nearest rod* is the strip that
is nearest to a curve that no strip can take within the limits.
"""

PEERS = {
    "test_nearest_against_ipopt.py::test_sixteen_light_curves_against_ipopt": (
        "`nearest_rod`: all sixteen curves of the Flower Pot without weight (ratio: their median)",
        "IPOPT through casadi: the same rod (201 nodes, 20 coefficients), exact derivatives",
    ),
    "test_lp_cost.py::test_row_generation_against_all_rows[200]": (
        "least stiffness ratio of a half ellipse, 200 samples",
        "HiGHS: the linear program of Eq. 4, for all samples at once",
    ),
    "test_lp_cost.py::test_row_generation_against_all_rows[2000]": (
        "the same, 2000 samples",
        "HiGHS: the linear program of Eq. 4, for all samples at once",
    ),
    "test_lp_cost.py::test_gravity_against_the_full_program": (
        "least stiffness ratio under weight, 500 samples",
        "HiGHS: the linear program of Eq. 6, for all samples at once",
    ),
    "test_lp_cost.py::test_all_strips_of_the_gallery": (
        "least stiffness ratios of all strips of nine models",
        "HiGHS: the linear programs of Eqs. 4 and 6, for all samples at once",
    ),
    "test_rod_speed.py::test_bend_against_solve_bvp": (
        "`bend`: a rod of 201 nodes between two clamps",
        "`scipy.integrate.solve_bvp`, tolerance 1e-6",
    ),
    "test_rod_speed.py::test_stability_against_the_dense_constrained_eigenproblem": (
        "`stability` of a rod of 1001 nodes",
        "numpy: eigenvalues of the dense projected Hessian",
    ),
}  # fmt: skip
"""What is measured beside a solver of others, and which one."""

BESIDE_SCIPY = "scipy: a cubic spline evaluated 500 times at 601 points"

OURS = {
    "test_lp_cost.py::test_cost_hardly_grows_with_the_samples": (
        "least stiffness ratio, 20,000 samples",
        "the same with 200 samples",
    ),
    "test_rod_speed.py::test_cost_is_linear_up_to_20000[bend]": (
        "`bend` of a rod of 20,001 nodes",
        "the same with 5001 nodes",
    ),
    "test_rod_speed.py::test_cost_is_linear_up_to_20000[stability]": (
        "`stability` of a rod of 20,001 nodes",
        "the same with 5001 nodes",
    ),
    "test_drawn_curve_speed.py::test_drawn_curve_against_its_evaluations[check_equilibrium-arch]": (
        "`check_equilibrium` (can a strip take the curve?) of a drawn arch",
        BESIDE_SCIPY,
    ),
    "test_drawn_curve_speed.py::test_drawn_curve_against_its_evaluations[check_equilibrium-wave]": (
        "the same of a wave",
        BESIDE_SCIPY,
    ),
    "test_drawn_curve_speed.py::test_drawn_curve_against_its_evaluations[optimal_rod-arch]": (
        "`optimal_rod` of a drawn arch",
        BESIDE_SCIPY,
    ),
    "test_drawn_curve_speed.py::test_drawn_curve_against_its_evaluations[optimal_rod-wave]": (
        "the same of a wave",
        BESIDE_SCIPY,
    ),
    "test_nearest_speed.py::test_second_solves_after_a_small_move": (
        "nearest rods of sixteen slightly moved curves, from the previous result (`start=`)",
        "the same without `start=`",
    ),
    "test_nearest_speed.py::test_compiled_beside_python": (
        "sixteen stable nearest rods under weight, inner loops compiled",
        "the same without compiled code (`ELASTICA_PURE`)",
    ),
    "test_batch_speed.py::test_two_processes": (
        "200 nearest rods in two processes",
        "the same in one process",
    ),
    "test_batch_speed.py::test_time_is_linear": (
        "600 nearest rods in two processes",
        "200 nearest rods in two processes",
    ),
    "test_batch_speed.py::test_ten_thousand": (
        "10,000 nearest rods in two processes",
        "half the time of the same in one process",
    ),
    "test_batch_speed.py::test_memory_is_constant": (
        "memory that the main process adds for 600 nearest rods in two processes, at its peak",
        "the same for 200 nearest rods",
    ),
    "test_slot_speed.py::test_slots_cost_a_few_times_the_strips": (
        "interlocking the Pavilion: 102 slots in 31 strips",
        "computing its 31 rods under their weight",
    ),
}
"""What is measured beside another task of ours."""

ALONE = {
    "test_nearest_speed.py::test_sixteen_light_curves": (
        "nearest rods of sixteen curves without weight, stiffness ratio at most 2.5"
    ),
    "test_nearest_speed.py::test_sixteen_heavy_stable_curves": (
        "the same under weight, ratio at most 3.3, [stability margin](stability.md) at least 5"
    ),
    "test_nearest_speed.py::test_wishes_that_no_rod_meets": (
        "sixteen searches that find no rod: ratio at most 1.3, stability margin at least 500"
    ),
    "test_nearest_speed.py::test_unstable_s": (
        "the nearest stable curve of an unstable S, with the same end tangents"
    ),
    "test_nearest_speed.py::test_march_with_sensitivities": "integration of one rod of 201 nodes, with derivatives",
}
"""What has no peer."""

PROCESSES = {
    "test_command_speed.py::test_whole_process[import]": "`import elastica_cad`",
    "test_command_speed.py::test_whole_process[check]": "`elastica check arch.dxf`",
    "test_command_speed.py::test_whole_process[strip without STEP]": (
        "`elastica strip arch.dxf`, without STEP files"
    ),
    "test_command_speed.py::test_whole_process[pavilion]": "`elastica model pavilion.toml`: 31 strips, 102 slots",
    "test_command_speed.py::test_whole_process[perforated]": (
        "`elastica strip` of a strip with 1220 holes: with a picture, without STEP files"
    ),
    "test_command_speed.py::test_whole_process[lamp]": (
        "`examples/lamp/lamp.py`: with its pictures, without STEP files"
    ),
}
"""Whole processes, from the command to its end."""

BODIES = {
    "test_cad_speed.py::test_one_strip[FlatSolid]": "flat strip",
    "test_cad_speed.py::test_one_strip[BentSolid]": "bent strip",
    "test_cad_speed.py::test_assembly_of_31_slotted_strips": "31 bent strips with six slots each",
    "test_cad_speed.py::test_a_strip_bent_forward": "strip bent by `bend`: its surfaces, without OpenCASCADE",
}
"""Bodies of OpenCASCADE."""


FREECAD = ("test_freecad_speed.py::test_recomputes", "test_freecad_speed.py::test_a_hundred_strips")
"""What a hand feels there: figures by what they are of, each with its unit."""


def main() -> None:
    """Keep what a run told, if one is given; write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path, nargs="?")
    parser.add_argument("--busy", action="store_true")
    asked = parser.parse_args()
    if asked.file is not None:
        run = json.loads(asked.file.read_text(encoding="utf-8"))
        KEPT.write_text(json.dumps(condensed(run, asked.busy), indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(page(json.loads(KEPT.read_text(encoding="utf-8"))), encoding="utf-8")
    print(PAGE)


def condensed(run: dict[str, Any], busy: bool) -> dict[str, Any]:
    """Of a run of pytest-benchmark what the page tells."""
    found = {named(one["fullname"]): one for one in run["benchmarks"]}
    lost = rows() - set(found)
    if lost:
        raise SystemExit(f"the run has no {', '.join(sorted(lost))}: run `make benchmark` whole")
    machine = run["machine_info"]
    return {
        "date": datetime.fromisoformat(run["datetime"]).date().isoformat(),
        "machine": f"{machine['cpu'].get('brand_raw', machine['machine'])}, Python {machine['python_version']}",
        "busy": busy,
        "rows": {
            name: {"median_s": one["stats"]["median"], **one["extra_info"]}
            for name, one in sorted(found.items())
        },
    }


def named(test: str) -> str:
    """A test by its file, its function and what it is asked with, without limits."""
    return re.sub(r"-[\d.]+\]$", "]", test.removeprefix("tests/benchmarks/"))


def rows() -> set[str]:
    """All that the page tells."""
    return {*PEERS, *OURS, *ALONE, *PROCESSES, *BODIES, *FREECAD}


def page(kept: dict[str, Any]) -> str:
    """The whole page."""
    found = kept["rows"]
    busy = (
        " Other programs ran at the same time: the times are too large, the ratios are roughly right."
        if kept["busy"]
        else ""
    )
    parts = [HEAD, f"All rows are of {kept['date']}: {kept['machine']}.{busy}\n"]
    parts += table(
        "Compared with other solvers",
        ["task", "other solver", "our time", "ratio"],
        [[*words, seconds(found[name]), ratio(found[name])] for name, words in PEERS.items()],
    )
    models = {
        name: share
        for name, share in found["test_lp_cost.py::test_all_strips_of_the_gallery"].items()
        if name not in ("ratio", "median_s")
    }
    parts += table(
        "The strips of each model, compared with HiGHS",
        ["model", "ratio"],
        [[name, told(share)] for name, share in models.items()],
    )
    parts += table(
        "Compared with other tasks",
        ["task", "other task", "our time or memory", "ratio"],
        [[*words, seconds(found[name]), ratio(found[name])] for name, words in OURS.items()],
    )
    parts += table(
        "Whole commands",
        ["command", "time", "divided by the time of a process that only imports numpy"],
        [[words, seconds(found[name]), ratio(found[name])] for name, words in PROCESSES.items()],
    )
    parts += table(
        "In FreeCAD",
        ["work", "time"],
        [
            [work.rpartition(", ")[0], f"{number:g} {work.rpartition(', ')[2]}"]
            for name in FREECAD
            for work, number in found[name].items()
            if work != "median_s"
        ],
    )
    parts += table(
        "Bodies",
        ["body", "time", "fraction spent in OpenCASCADE", "divided by the time to compute the strip"],
        [
            [
                words,
                seconds(found[name]),
                *(
                    f"{found[name][key]:g}" if key in found[name] else ""
                    for key in ("OpenCASCADE's share", "times the core")
                ),
            ]
            for name, words in BODIES.items()
        ],
    )
    parts += table(
        "Other times", ["task", "time"], [[words, seconds(found[name])] for name, words in ALONE.items()]
    )
    return "\n".join(parts)


def table(title: str, head: list[str], body: list[list[str]]) -> Iterator[str]:
    """A heading and its table."""
    yield f"## {title}\n"
    yield f"| {' | '.join(head)} |\n|{' --- |' * len(head)}"
    yield from (f"| {' | '.join(row)} |" for row in body)
    yield ""


def seconds(one: dict[str, Any]) -> str:
    """The median in a unit that is read at once; the memory where that is measured."""
    if "megabytes" in one:
        return f"{told(one['megabytes'])} MB"
    median = one["median_s"]
    size, unit = next(unit for unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")) if median >= unit[0])
    return f"{told(median / size)} {unit}"


def ratio(one: dict[str, Any]) -> str:
    """Ours over the peer's."""
    return told(one["ratio"])


def told(number: float) -> str:
    """Two digits, without powers of ten."""
    return f"{float(f'{number:.2g}'):g}"


if __name__ == "__main__":
    main()
