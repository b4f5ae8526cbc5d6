"""Which tests run which lines, and how long each takes, so that a mutant meets only tests that can see it.

As a plugin of pytest it gathers them; `Covering` reads what was gathered.
"""

import json
import os
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import coverage
import pytest

from tests.campaign.trust.changed_lines import Lines

ROOMS = ("tests/unit", "tests/properties", "tests/validation", "--ignore=tests/unit/cli")
"""Where to look; tests of commands are left out, as what they start is a process of its own."""

FOLDER = "ELASTICA_COVERING"
"""Environment variable: where the plugin leaves its record."""


class _Gatherer:
    def __init__(self, folder: Path) -> None:
        self.folder, self.seconds = folder, dict[str, float]()
        self.seen = coverage.Coverage(data_file=str(folder / "lines"), source_pkgs=["elastica_cad"])
        self.seen.start()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[Any]:
        self.seen.switch_context(item.nodeid)
        since = time.process_time()
        done = yield
        self.seconds[item.nodeid] = time.process_time() - since
        self.seen.switch_context("")
        return done

    def pytest_sessionfinish(self) -> None:
        self.seen.stop()
        self.seen.save()
        (self.folder / "seconds.json").write_text(json.dumps(self.seconds))


def pytest_configure(config: pytest.Config) -> None:
    """Start before anything of the program is imported."""
    config.pluginmanager.register(_Gatherer(Path(os.environ[FOLDER])))


def gather(root: Path, folder: Path, floors: tuple[str, ...]) -> None:
    """Run all tests of the core once, and the examples of the floors' modules."""
    folder.mkdir(parents=True, exist_ok=True)
    words = ["-m", "pytest", "-n", "0", "-p", "tests.campaign.trust.covering_tests"]
    subprocess.run(
        [sys.executable, *words, *ROOMS, *(f"elastica_cad/{floor}" for floor in floors)], cwd=root, check=False,
        env={**os.environ, "PYTHONPATH": str(root), FOLDER: str(folder)}, stdout=subprocess.DEVNULL,
    )  # fmt: skip


class Covering:
    """The tests that run a line, the quickest first."""

    def __init__(self, folder: Path) -> None:
        self.seconds: dict[str, float] = json.loads((folder / "seconds.json").read_text())
        self.lines = coverage.CoverageData(str(folder / "lines"))
        self.lines.read()
        self.contexts: dict[str, dict[int, list[str]]] = {}
        self.names = {name[name.rindex("elastica_cad/") :]: name for name in self.lines.measured_files()}

    def of(self, file: Path, lines: Lines) -> list[str]:
        """Tests that run any of the lines; where none does, tests of anything in the file."""
        tests = {test for name, *some in lines for test in self._running(name, range(some[0], some[1] + 1))}
        tests = tests or self._running(str(file), None)
        return sorted((test for test in tests if test in self.seconds), key=self.seconds.__getitem__)

    def _running(self, file: str, some: range | None) -> set[str]:
        """Tests that run some lines of a file, or any."""
        if file not in self.contexts:
            self.contexts[file] = self.lines.contexts_by_lineno(self.names.get(file, ""))
        found = self.contexts[file]
        return {test for line in (found if some is None else some) for test in found.get(line, ()) if test}

    def within(self, tests: list[str], seconds: float) -> list[str]:
        """The quickest of them that take so long together; of each file one before the second of any."""
        turns: dict[str, int] = defaultdict(int)
        order = []
        for test in tests:
            name = test.partition("::")[0]
            order.append((turns[name], self.seconds[test], test))
            turns[name] += 1
        chosen, spent = [], 0.0
        for _, took, test in sorted(order):
            spent += took
            if spent > seconds and chosen:
                break
            chosen.append(test)
        return chosen
