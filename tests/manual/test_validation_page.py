"""The page of validation is what a run of its script gives."""

import importlib.util
from pathlib import Path

import pytest

pytestmark = pytest.mark.campaign

DOCS = Path(__file__).resolve().parents[2] / "docs"


def test_the_tables_are_what_a_run_gives():
    spec = importlib.util.spec_from_file_location("validation_tables", DOCS / "validation_tables.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    result = (DOCS / "explanation" / "validation.md").read_text(encoding="utf-8")
    assert result == script.page(), "write it again: python docs/validation_tables.py"
