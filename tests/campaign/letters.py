"""Every English template as random letters: a test that fails then, and is not of wording, found a reader of words.

A plugin of pytest: `make campaign-letters`. A test asserts wording where the statement that fails holds a text, a
variable with words as its value, or one whose value a regular expression read.
"""

import ast
import inspect
import random
import re
import textwrap
from pathlib import Path

import pytest

from elastica_cad.errors import Wording

TESTS = Path(__file__).resolve().parents[1]
PACKAGE = TESTS.parent / "elastica_cad"
GAP = re.compile(r"(\{[a-z_0-9]+(?:![rs])?(?::[^{}]*)?\})")
TEXT = re.compile(
    r"""["'].*[a-z].*["']|\bmatch=|\bre\.|\b[A-Z_]{4,}\b|\bwords?\b|\bsaid\b|\btold\b|\bsentences?\b|\btexts?\b|\bmessage\b|\bstderr\b"""
)


def letters(text: str) -> str:
    """Other letters, always the same for a text; its gaps stay."""
    drawn = random.Random(text)
    parts = GAP.split(text)
    parts[::2] = [
        re.sub("[A-Za-z]", lambda _: drawn.choice("bdfghjklmnpqrstvwxz"), part) for part in parts[::2]
    ]
    return "".join(parts)


def pytest_configure() -> None:
    Wording.template = lambda _self, text: letters(text)  # type: ignore[method-assign]


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(call):
    report = yield
    if report.failed and report.when == "call" and _asserts_wording(call.excinfo):
        report.outcome, report.wasxfail = "skipped", "asserts wording"
    return report


def _asserts_wording(found) -> bool:
    own = [entry for entry in found.traceback if TESTS in Path(entry.path).parents]
    raised = Path(found.traceback[-1].path)
    return PACKAGE not in raised.parents and any(
        TEXT.search(str(entry.statement)) or _uses_text(entry) for entry in own[-1:]
    )


def _uses_text(entry) -> bool:
    """Return True if the statement uses a variable that holds words, or a value that a regular expression read."""
    used = set(re.findall(r"\w+", str(entry.statement)))
    values = (value for name, value in entry.frame.f_locals.items() if name in used)
    if any(isinstance(value, str) and re.search("[a-z].* .*[a-z]", value) for value in values):
        return True
    function = ast.parse(textwrap.dedent(inspect.getsource(entry.frame.code.raw)))
    settings = [node for node in ast.walk(function) if isinstance(node, ast.Assign | ast.AugAssign | ast.For)]
    matched: set[str] = set()
    for node in sorted(settings, key=lambda node: node.lineno):
        value = ast.unparse(node.iter if isinstance(node, ast.For) else node.value)
        if re.search(r"\bre\.", value) or matched & set(re.findall(r"\w+", value)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = (name for target in targets for name in ast.walk(target))
            matched |= {name.id for name in names if isinstance(name, ast.Name)}
    return bool(matched & used)
