"""Checks the release workflow and runs its steps for Linux here: python -m tests.campaign.workflow [PYTHON ...]

Each job gets a copy of the committed files and an empty environment; what a job uploads goes through one folder.
The tests run on each Python given, or on the one that runs this.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = ROOT / ".github" / "workflows"


def lint() -> None:
    """Refuse a workflow that its schema or the linter of workflows refuses."""
    files = sorted(map(str, WORKFLOWS.glob("*.yml")))
    for words in (
        ["check-jsonschema", "--builtin-schema", "vendor.github-workflows"],
        ["zizmor", "--offline"],
    ):
        program = Path(sys.executable).with_name(words[0])
        subprocess.run([program, *words[1:], *files], check=True, cwd=ROOT)


def wanted(step: dict[str, Any], matrix: dict[str, str]) -> bool:
    """Return True if a step runs on Linux with the values of a matrix."""
    condition = step.get("if", "True").replace("runner.os", "'Linux'")
    for name, value in matrix.items():
        condition = condition.replace(f"matrix.{name}", repr(value))
    return bool(eval(condition))  # "'Linux' == 'Linux'": our own file


def run_job(steps: list[dict[str, Any]], python: str, dist: Path, matrix: dict[str, str]) -> None:
    """Run the commands of a job in a copy of the committed files; keep what they leave in dist/."""
    with tempfile.TemporaryDirectory() as folder:
        source, environment = Path(folder, "source"), Path(folder, "environment")
        archive = Path(folder, "source.tar")
        subprocess.run(["git", "archive", "--output", archive, "HEAD"], check=True, cwd=ROOT)
        source.mkdir()
        shutil.unpack_archive(archive, source, filter="data")
        subprocess.run([python, "-m", "venv", environment], check=True)
        if any("download-artifact" in step.get("uses", "") for step in steps):
            (source / "dist").mkdir()
            shutil.copy(next(dist.glob(matrix["wheel"])), source / "dist")
        path = {"PATH": f"{environment / 'bin'}:{os.environ['PATH']}", "PYTHONPATH": ""}
        for step in steps:
            if "run" in step and wanted(step, matrix):
                print(f"-- {step.get('name', step['run'])}", flush=True)
                subprocess.run(
                    ["bash", "-e", "-c", step["run"]], check=True, cwd=source,
                    env=dict(os.environ) | path | step.get("env", {}),
                )  # fmt: skip
        if any("upload-artifact" in step.get("uses", "") for step in steps):
            for made in (source / "dist").iterdir():
                shutil.copy(made, dist)


def main(*pythons: str) -> None:
    """Lint, build and test."""
    from ruamel.yaml import YAML  # comes with check-jsonschema in the environment of this campaign

    lint()
    jobs = YAML(typ="safe").load(WORKFLOWS / "release.yml")["jobs"]
    with tempfile.TemporaryDirectory() as folder:
        dist = Path(folder)
        for job in ("source", "wheels"):
            run_job(jobs[job]["steps"], sys.executable, dist, {})
        tested = [
            (python, wheel)
            for python in pythons or (sys.executable,)
            for wheel in ("*abi3*.whl", "*none-any.whl")
        ]
        for python, wheel in tested:
            version = subprocess.check_output(
                [python, "-c", "import sys; print('%d.%d' % sys.version_info[:2])"], text=True
            ).strip()
            print(f"== {wheel} on Python {version}", flush=True)
            run_job(jobs["test"]["steps"], python, dist, {"python": version, "wheel": wheel})
        files = len(list(dist.iterdir()))
        print(f"{files} files built, installed {len(tested)} times; tests of core and contract passed")


if __name__ == "__main__":
    main(*sys.argv[1:])
