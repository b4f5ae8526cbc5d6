"""What the tests of the house share: docs/plan.py, which reads every import statement."""

import importlib.util
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def plan():
    file = Path(__file__).resolve().parents[2] / "docs" / "plan.py"
    spec = importlib.util.spec_from_file_location("plan", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def modules(plan):
    return plan.modules()


@pytest.fixture(scope="session")
def imports(plan):
    return plan.imports()
