"""Versions in reports."""

import sys
from importlib.metadata import PackageNotFoundError, version

import pytest

from elastica_cad.formats.reports.strip_report import list_versions

pytestmark = pytest.mark.core


def test_versions_are_those_that_python_tells():
    known = {}
    for package in ("elastica-cad", "numpy", "scipy", "highspy", "ezdxf"):
        try:
            known[package] = version(package)
        except PackageNotFoundError:
            continue
    assert list_versions() == known
    assert {"numpy", "scipy"} <= set(known)


def test_versions_of_wheels_and_of_debian_s_packages_come_first_on_the_path(monkeypatch, tmp_path):
    (tmp_path / "first" / "numpy-1.24.2.egg-info").mkdir(parents=True)
    (tmp_path / "first" / "Elastica_CAD-0.1.0.dev3+g1a2b.dist-info").mkdir()
    (tmp_path / "second" / "numpy-9.9.dist-info").mkdir(parents=True)
    (tmp_path / "second" / "ezdxf-1.1-py3.11.egg-info").mkdir()
    (tmp_path / "second" / "ezdxf_more-7.dist-info").mkdir()
    monkeypatch.setattr(sys, "path", [str(tmp_path / name) for name in ("first", "nowhere", "second")])
    assert list_versions() == {"elastica-cad": "0.1.0.dev3+g1a2b", "numpy": "1.24.2", "ezdxf": "1.1"}
