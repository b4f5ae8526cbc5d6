"""Whether a change of the program changes any answer: the bank of requests asked with it and without.

A mutant whose line the bank runs, and that gives every answer again to 1e-6, is called equivalent.
"""

import json
import math
import os
import re
import sys
import time
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from tempfile import TemporaryDirectory
from typing import Any

from tests.campaign.trust.changed_copy import in_copy
from tests.campaign.trust.changed_lines import Lines
from tests.campaign.trust.request_bank import Request

SAME = 1e-6
"""Of a figure, or mm: answers that agree so well are the same to everybody who cuts."""

BANK_S = 6.0
"""Processor seconds, without the change, of the requests that one mutant is asked."""

VARYING = re.compile(
    r"[\w/]*/tmp\w{8}\b|\d{4}-\d\d-\d\dT[\d:]+|\d+\.\d+[.\d]* @ [\d-]*T?[\d:.+]+"
    r"|\{[0-9A-F]{8}(?:-[0-9A-F]{4}){3}-[0-9A-F]{12}\}|\b\d+\.\d\d s(?=  )"
    r"|#\d+(?=[ =,)])|OCCURRENCE\('\d+'"
)
"""What differs between two runs of the same program: folders, dates and ids in files, the seconds a step took.

OpenCASCADE numbers what it writes into a STEP file in an order of its own."""

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
EPOCH = "1700000000"
"""Files carry this date, and so are the same in every run."""

WHOLE_S = 300.0
"""Processor seconds of the whole bank, about twice."""

IMPORTED = (
    "geometry", "mechanics", "form_finding", "strip", "formats", "model", "pairs", "design",
    "cli", "kit", "files", "plot",
)  # fmt: skip
"""What is imported before lines are counted."""

FEWEST = 5
"""So many answers at least that run a line say that a change of it is seen by nobody."""

EQUAL, DIFFERENT, BROKEN = 0, 1, 2
"""Exit codes of a process that asks."""


def difference(one: object, other: object, place: str = "") -> str:
    """Where two answers differ by more than SAME; empty where they agree."""
    if isinstance(one, dict) and isinstance(other, dict):
        if one.keys() != other.keys():
            return f"{place}: {sorted(one.keys() ^ other.keys())}"
        return next(
            (result for key in one if (result := difference(one[key], other[key], f"{place}/{key}"))), ""
        )
    if isinstance(one, list) and isinstance(other, list):
        if len(one) != len(other):
            return f"{place}: {len(one)} and {len(other)}"
        pairs = enumerate(zip(one, other, strict=True))
        return next((result for n, pair in pairs if (result := difference(*pair, f"{place}/{n}"))), "")
    if isinstance(one, str) and isinstance(other, str):
        if one == other:
            return ""
        one, other = VARYING.sub("", one), VARYING.sub("", other)
        return "" if _same_text(one, other) else f"{place}: {_first(one, other)}"
    if isinstance(one, int | float) and isinstance(other, int | float):
        return "" if _same_number(one, other) else f"{place}: {one} and {other}"
    return "" if one == other else f"{place}: {one!r:.80} and {other!r:.80}"


def _same_number(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=SAME, abs_tol=SAME) or (math.isnan(one) and math.isnan(other))


def _same_text(one: str, other: str) -> bool:
    """The same words, and numbers that agree."""
    if NUMBER.split(one) != NUMBER.split(other):
        return False
    pairs = zip(NUMBER.findall(one), NUMBER.findall(other), strict=True)
    return all(a == b or _same_number(float(a), float(b)) for a, b in pairs)


def _first(one: str, other: str) -> str:
    """The first lines of two texts that differ."""
    for a, b in zip(one.splitlines(), other.splitlines(), strict=False):
        if a != b and not _same_text(a, b):
            return f"{a:.80} and {b:.80}"
    return f"{len(one)} and {len(other)} letters"


@dataclass(frozen=True)
class Bank:
    """What the bank gave without a change: a file an answer, and lines and seconds of each request."""

    folder: Path

    @cached_property
    def known(self) -> dict[str, dict[str, Any]]:
        return dict(json.loads((self.folder / "requests.json").read_text()))

    def answer(self, name: str) -> object:
        return json.loads((self.folder / f"{name}.json").read_text())

    def of(self, lines: Lines) -> list[str]:
        """Requests that run any of the lines, those that take BANK_S together, of each kind in turn."""
        found, turns = [], dict[str, int]()
        for name, known in sorted(self.known.items(), key=lambda item: item[1]["seconds"]):
            if any(
                first <= line <= last for file, first, last in lines for line in known["lines"].get(file, ())
            ):
                kind = name.partition(" ")[0]
                found.append((turns.setdefault(kind, 0), known["seconds"], name))
                turns[kind] += 1
        chosen, spent = [], 0.0
        for _, seconds, name in sorted(found):
            if not chosen or spent + seconds < BANK_S:
                spent += seconds
                chosen.append(name)
        return chosen


def asked_bank(copy: Path, bank: Bank, lines: Lines) -> tuple[bool, str]:
    """Whether all answers of requests that run the lines are as before, and that in words."""
    names = bank.of(lines)
    if not names:
        return False, "no request of the bank runs it"
    with TemporaryDirectory() as folder:
        record = Path(folder, "found")
        code = in_copy(
            copy, lambda: _asked(bank, names, record), sum(bank.known[one]["seconds"] for one in names)
        )
        found = record.read_text() if record.exists() else "no answer"
    if code != EQUAL:
        return False, found
    return len(names) >= FEWEST, f"{len(names)} answers of the bank are as before"


def _asked(bank: Bank, names: list[str], record: Path) -> int:
    """Ask requests in this process, until an answer differs."""
    from tests.campaign.trust.request_bank import answer
    from tests.campaign.trust.request_bank import bank as requests

    os.environ["SOURCE_DATE_EPOCH"] = EPOCH
    for name in names:
        record.write_text(f"{name}: no answer")
        with TemporaryDirectory() as folder:
            given = json.loads(json.dumps(answer(requests()[name], Path(folder))))
            os.chdir("/")
        result = difference(bank.answer(name), given)
        if result:
            record.write_text(f"{name}: {result}")
            return DIFFERENT
    return EQUAL


def gather_bank(copy: Path, bank: Bank) -> None:
    """Ask every request, each in a process of its own, and keep answers, lines and seconds."""
    bank.folder.mkdir(parents=True, exist_ok=True)
    if in_copy(copy, lambda: _gathered_all(copy, bank), WHOLE_S, compiled=True) != EQUAL:
        sys.exit("a request of the bank does not end without any change")


def _gathered_all(copy: Path, bank: Bank) -> int:
    from tests.campaign.trust.request_bank import bank as requests

    for module in walk_packages([str(copy / "elastica_cad")], "elastica_cad."):
        if module.name.split(".")[1] in IMPORTED:
            import_module(module.name)
    kept, record = bank.folder / "requests.json", bank.folder / "one"
    known = json.loads(kept.read_text()) if kept.exists() else {}
    for name, request in requests().items():
        if name in known:
            continue
        child = os.fork()
        if not child:
            code = BROKEN
            try:
                record.write_text(json.dumps(_gathered(copy, bank, name, request)))
                code = EQUAL
            finally:
                os._exit(code)
        if os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) != EQUAL:
            return BROKEN
        known[name] = json.loads(record.read_text())
    kept.write_text(json.dumps(known))
    return EQUAL


def _gathered(copy: Path, bank: Bank, name: str, request: Request) -> dict[str, Any]:
    """One request in this process: which lines it ran, and how long it took; its answer is kept."""
    import coverage

    from tests.campaign.trust.request_bank import answer

    os.environ["SOURCE_DATE_EPOCH"] = EPOCH
    seen = coverage.Coverage(data_file=None, source=[str(copy / "elastica_cad")])
    seen.start()
    since = time.process_time()
    with TemporaryDirectory() as folder:
        given = answer(request, Path(folder))
        os.chdir("/")
    seconds = time.process_time() - since
    seen.stop()
    data = seen.get_data()
    (bank.folder / f"{name}.json").write_text(json.dumps(given))
    lines = {str(Path(path).relative_to(copy)): data.lines(path) for path in data.measured_files()}
    return {"seconds": seconds, "lines": {file: sorted(some) for file, some in lines.items() if some}}
