"""Fixtures shared by all tests."""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Published reference data beside the checkout; absent on users' machines."""
    folder = ROOT.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("reference data not present beside the checkout")
    return folder


@pytest.fixture(scope="session")
def project_root() -> Path:
    return ROOT
