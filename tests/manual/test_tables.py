"""No table and no block of the manual is merely told: rows are asked, blocks run, the rest written by scripts."""

import json
import re
import tomllib

import pytest

from tests.manual import proofs, rows_of_code, rows_of_commands, rows_of_explanations
from tests.manual.found_in_pages import PAGES, ROOT, blocks, tables

ASKERS = (rows_of_code, rows_of_commands, rows_of_explanations)
TABLES = tables()
ROWS = [
    pytest.param(table, row, id=f"{table.page}: {row[0]}")
    for table in TABLES
    for row in table.rows
    if table.page not in proofs.WRITTEN
]
RUN_WHOLE = ("docs/tutorials/", "docs/how_to/", "docs/explanation/")
"""Pages that test_manual.py runs as their readers do."""
RUN_ELSEWHERE = {
    ("README.md", "python"): "tests/contract/test_snippets.py::test_python_of_readme",
    ("docs/code_cad.md", "python"): "tests/contract/test_snippets.py::test_page_for_scripts",
    ("docs/freecad.md", "python"): "tests/freecad/test_contract.py::test_page_of_the_workbench",
    ("README.md", "sh"): "tests/contract/test_snippets.py::test_commands_of_readme",
    (
        "docs/architecture.md",
        "text",
    ): "tests/house/test_documentation.py::test_calls_of_the_three_ways_exist",
    (
        "docs/how_to/models.md",
        "toml",
    ): "tests/unit/model/test_plate_holes.py::test_a_design_file_declares_the_holes",
    ("docs/publishing.md", "rst"): "tests/manual/test_tables.py::test_entries_for_lists_lead_here",
    ("docs/publishing.md", "text"): "tests/manual/test_tables.py::test_entries_for_lists_lead_here",
}
pytestmark = pytest.mark.campaign
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_every_table_is_requested_or_written():
    assert ASKERS
    of_pages = {(table.page, table.head) for table in TABLES if table.page not in proofs.WRITTEN}
    assert of_pages - set(proofs.ASKED) == set()
    assert set(proofs.ASKED) - of_pages == set(), "asked, but on no page"
    assert {page for page in proofs.WRITTEN if page in {table.page for table in TABLES}} == set(
        proofs.WRITTEN
    )
    for test in proofs.WRITTEN.values():
        proofs.proved_by(test)


@pytest.mark.parametrize(("table", "row"), ROWS)
def test_a_row_is_true(table, row, tmp_path):
    assert len(row) == len(table.head)
    proofs.ASKED[table.page, table.head](row, tmp_path)


def test_pages_of_campaigns_are_what_was_measured():
    from tests.campaign import record, solid_table
    from tests.campaign.finite_elements import table

    assert table.PAGE.read_text(encoding="utf-8") == table.written(table.kept())
    assert solid_table.PAGE.read_text(encoding="utf-8") == solid_table.written(solid_table.kept())
    assert record.PAGE.read_text(encoding="utf-8") == record.page(json.loads(record.KEPT.read_text()))


def test_measured_parts_and_forces_are_within_their_limits():
    from tests.campaign.finite_elements import table
    from tests.campaign.finite_elements.between import BetweenEnds
    from tests.campaign.finite_elements.flexures import FlexedPart

    rows = table.kept()
    records = [
        *(FlexedPart(**row) for row in rows["flexures"]),
        *(BetweenEnds(**row) for row in rows["between"]),
    ]
    assert [record.name for record in records if not record.good] == []


def test_answers_of_kernels_take_the_place_of_older_ones(tmp_path, monkeypatch):
    from tests.campaign import solid_table

    monkeypatch.setattr(solid_table, "KEPT", tmp_path / "solids.json")
    monkeypatch.setattr(solid_table, "PAGE", tmp_path / "kernels.md")
    request = {"program": "P 1", "style": "held", "curve": "S", "day": "2026-11-20"}
    rows = [
        request | {"operation": "fillet", "answer": "invalid", "plain": "ok"},
        request | {"operation": "boolean", "answer": "Error: no, with advice", "plain": "crashes"},
        request | {"operation": "mirror", "answer": "ok"},
    ]
    solid_table.keep(rows)
    page = (tmp_path / "kernels.md").read_text()
    assert "| fillet 0.2 mm, long edges, bent | held | S | P 1 | invalid |" in page
    assert "| boolean: a box cut out, bent |  | 0/1 |  |  |  | 1 | 0 |" in page
    solid_table.keep([rows[0] | {"answer": "ok", "day": "2026-11-21"}])
    (body,) = solid_table.kept()
    assert sorted(body["ok"]) == ["fillet", "mirror"]
    assert body["failed"] == {"boolean": ["Error: no", "crashes"]}
    assert "3 operations on 1 of 150 bodies, 2026-11-21." in (tmp_path / "kernels.md").read_text()


def test_every_block_is_run():
    left = []
    for page, block in blocks():
        if not block.kind and not block.file:
            installs(block.body)
        elif (page, block.kind) in RUN_ELSEWHERE:
            proofs.proved_by(RUN_ELSEWHERE[page, block.kind])
        elif not (page.startswith(RUN_WHOLE) and (block.kind in ("sh", "python", "text") or block.file)):
            left.append(f"{page}:{block.line} {block.kind}")
    assert left == []


def test_every_option_that_a_page_names_is_one():
    wrong = [
        page.name for page in PAGES if rows_of_commands.unknown_options(page.read_text(encoding="utf-8"))
    ]
    assert wrong == []


def installs(commands):
    """Lines that install name extras that the project has; make's demo does what they do."""
    for line in commands.strip().split("\n"):
        wanted = re.fullmatch(r"(?:\.venv/bin/)?pip install \"\.\[([\w,]+)\]\".*", line)
        if wanted is None:
            assert line in ("python3 -m venv .venv", "source .venv/bin/activate")
            continue
        assert set(wanted[1].split(",")) <= set(PROJECT["optional-dependencies"])


def test_entries_for_lists_lead_here():
    entries = [block.body for page, block in blocks() if page == "docs/publishing.md"]
    named = re.findall(r"ADDRESS/([\w/.]+)", "".join(entries))
    assert len(named) == 2
    assert all((ROOT / target).is_file() for target in named)
