"""What a new machine needs is installed first, or named in one sentence; then come environments and tests."""

import os
import shutil
import subprocess

import pytest


def test_a_user_without_rights_gets_one_sentence_with_all_packages(project_root, tmp_path):
    """On a path that has neither programs nor apt and sudo."""
    for name in ("bash", "env", "id", "grep"):
        (tmp_path / name).symlink_to(shutil.which(name))
    done = subprocess.run(
        [project_root / "tests" / "setup.sh"], env={"PATH": str(tmp_path)}, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert done.stderr == ""
    (sentence,) = done.stdout.splitlines()
    start, packages = sentence.split("--no-install-recommends ")
    assert start == "First install what the tests need, as root: apt-get install "
    assert set(packages.split()) >= {
        "gcc",
        "libc6-dev",
        "python3-dev",
        "python3-venv",
        "freecad",
        "librecad",
        "chromium",
    }


@pytest.fixture
def asked(project_root, tmp_path):
    """Function that returns what make would do in a folder whose environments were made before."""
    shutil.copy(project_root / "Makefile", tmp_path)
    shutil.copy(project_root / "pyproject.toml", tmp_path)
    (tmp_path / "elastica_cad" / "_native").mkdir(parents=True)
    for name in (
        ".venv/created",
        ".venv/test-installed",
        ".venv-oldest/installed",
        "tests/oldest/requirements.txt",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()

    def stub(*words):
        done = subprocess.run(
            ["make", "--dry-run", *words], cwd=tmp_path, env={"PATH": os.environ["PATH"]}, capture_output=True,
            text=True, check=True,
        )  # fmt: skip
        return done.stdout

    return stub


def test_an_environment_without_compiled_loops_is_installed_again(asked, tmp_path):
    assert "-m pip install" in asked(".venv/test-installed")
    (tmp_path / "elastica_cad" / "_native" / "loops.abi3.so").touch()
    assert "-m pip install" not in asked(".venv/test-installed")


def test_programs_are_installed_before_environments(asked):
    steps = asked("test")
    assert -1 < steps.find("tests/setup.sh") < steps.find("-m pip install") < steps.find("-m pytest")
