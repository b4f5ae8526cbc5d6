"""The page of benchmarks is what was kept of a run, and tells all of them."""

import ast
import importlib.util
import json
from pathlib import Path

import pytest

pytestmark = pytest.mark.campaign

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("speed_tables", ROOT / "docs" / "speed_tables.py")
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@pytest.fixture(scope="module")
def kept(script):
    return json.loads(script.KEPT.read_text(encoding="utf-8"))


def test_the_page_is_what_was_kept(script, kept):
    result = script.PAGE.read_text(encoding="utf-8")
    assert result == script.page(kept), "write it again: python docs/speed_tables.py"


def test_every_benchmark_has_a_row(script, kept):
    benchmarks = {
        f"{file.name}::{node.name}"
        for file in (ROOT / "tests" / "benchmarks").glob("test_*.py")
        for node in ast.parse(file.read_text(encoding="utf-8")).body
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    }
    assert {name.split("[")[0] for name in script.rows()} == benchmarks
    assert set(kept["rows"]) == script.rows()


def a_run(kept, shift=1.0):
    """What pytest-benchmark writes."""
    return {
        "datetime": "2026-11-21T10:00:00+00:00",
        "machine_info": {
            "cpu": {"brand_raw": "a processor"},
            "machine": "x86_64",
            "python_version": "3.11.2",
        },
        "benchmarks": [
            {
                "fullname": f"tests/benchmarks/{name[:-1]}-0.25]"
                if name.endswith("]")
                else f"tests/benchmarks/{name}",
                "stats": {"median": shift * one["median_s"]},
                "extra_info": {key: value for key, value in one.items() if key != "median_s"},
            }
            for name, one in kept["rows"].items()
        ],
    }


def test_a_run_is_reported(script, kept):
    again = script.condensed(a_run(kept), busy=False)
    assert again["rows"] == kept["rows"]
    assert "2026-11-21: a processor, Python 3.11.2.\n" in script.page(again)
    slower = script.page(script.condensed(a_run(kept, 1000.0), busy=True))
    assert "Other programs ran at the same time" in slower
    assert slower.split("## ")[1:] != script.page(again).split("## ")[1:]


def test_half_a_run_is_refused(script, kept):
    run = a_run(kept)
    del run["benchmarks"][3:]
    with pytest.raises(SystemExit, match="run `make benchmark` whole"):
        script.condensed(run, busy=False)
