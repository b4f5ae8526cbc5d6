"""Thirty curves x five styles x three kernels: what users do to bodies of strips, as a table.

    python tests/campaign/solids.py --kernels build123d cadquery --minutes 60 --out out/campaign

Bodies come in an order shuffled by `--seed`, so that a run that ends in time has asked every kernel and style
alike; the next run leaves out what is kept already, or with `--again` what is in the log of `--out` only. What
fails is asked again of plain bodies with the same faces, whose long sides are splines through nine points, and
while that succeeds through 25, 17, 40 and 90: where one of them fails too, the kernel does. Every body has a
process of its own, so that a kernel that crashes or hangs costs one answer. Answers are put into `solids.json`, of
which `solid_table.py` writes docs/kernels.md; with `--minutes 0` those of a log alone. Needs gmsh for meshes.
"""

import argparse
import json
import multiprocessing
import os
import random
import resource
import signal
import sys
import time
from datetime import date
from importlib import import_module
from importlib.metadata import version
from itertools import product
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
HERE = str(Path(__file__).resolve().parent)
FREECAD = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/share/freecad/Ext")


DRAWN_THROUGH = (9, 25, 17, 40, 90)
"""Points of long sides of plain bodies: from few, as one draws them, to as many as ours have."""

Body = tuple[str, str, str]
"""Kernel, style and curve."""


def program(kernel: str) -> str:
    """The program as it is installed, with its OpenCASCADE; it is imported, as every body's process is a copy."""
    if kernel == "freecad":
        if os.path.isdir(FREECAD[0]):
            import freecad

            freecad.__path__.append(str(ROOT / "freecad_workbench" / "freecad"))
        import FreeCAD as App
        import Part

        return f"FreeCAD {App.Version()[0]}.{App.Version()[1]} (OpenCASCADE {Part.OCC_VERSION})"
    import_module(kernel)
    from OCP import __version__

    occt = ".".join(__version__.split(".")[:3])
    name = {"build123d": "build123d", "cadquery": "CadQuery"}[kernel]
    return f"{name} {version(kernel)} (OpenCASCADE {occt})"


def answered(body: Body, points: int, names: list[str], pipe: Any) -> None:
    """Answers of one body, one message an operation; one that takes longer than `PATIENCE` ends the process."""
    from bank import made
    from operations import PATIENCE, Bodies, kernel_named

    kernel, style, curve = body
    bodies = Bodies(made(curve, style), points=points)
    runner = kernel_named(kernel)(bodies)
    for name in names:
        start = time.process_time()
        resource.setrlimit(resource.RLIMIT_CPU, (int(start) + PATIENCE[name], resource.RLIM_INFINITY))
        try:
            valid, size = runner.run(name)
            answer = "ok" if valid else "invalid"
            if name in ("volume", "mirror", "split", "STEP"):
                error = abs(size / bodies.volume - 1)
                answer = answer if error < 0.02 else f"volume off by {error:.1e}"
        except Exception as error:
            answer, size = f"{type(error).__name__}: {str(error)[:70]}", 0.0
        pipe.send((name, answer, size, bodies.volume, time.process_time() - start))
    pipe.close()


def answers(body: Body, points: int, operations: list[str]) -> list[dict[str, Any]]:
    """All answers of one body, started anew after a crash or a hang."""
    from operations import PATIENCE

    rows: list[dict[str, Any]] = []
    left = list(operations)
    context = multiprocessing.get_context("fork")
    who = dict(zip(("kernel", "style", "curve"), body, strict=True)) | {"day": date.today().isoformat()}
    while left:
        here, there = context.Pipe(False)
        process = context.Process(target=answered, args=(body, points, left, there))
        process.start()
        there.close()
        try:
            while left:
                name, answer, size, whole, seconds = here.recv()
                left.remove(name)
                result = {"operation": name, "answer": answer, "size": size, "volume": whole}
                rows.append(who | result | {"seconds": round(seconds, 3)})
        except EOFError:
            process.join()
            long = process.exitcode == -signal.SIGXCPU
            answer = f"longer than {PATIENCE[left[0]]} s" if long else "crashes"
            rows.append(who | {"operation": left.pop(0), "answer": answer})
        process.join()
    return rows


def with_control(body: Body, operations: list[str]) -> list[dict[str, Any]]:
    """The answers of one body, those that failed with what plain bodies with the same faces answer."""
    rows = answers(body, 0, operations)
    for points in DRAWN_THROUGH:
        failed = [row for row in rows if row["answer"] != "ok" and row.get("plain", "ok") == "ok"]
        result = answers(body, points, [row["operation"] for row in failed])
        for row, plain in zip(failed, result, strict=True):
            row["plain"] = plain["answer"]
    return rows


def main() -> None:
    from bank import CURVES, STYLES
    from operations import KERNELS, OPERATIONS, SHARED

    from tests.campaign.solid_table import keep, kept

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kernels", nargs="+", choices=list(KERNELS), default=list(KERNELS))
    parser.add_argument("--curves", nargs="+", choices=list(CURVES), default=list(CURVES))
    parser.add_argument("--styles", nargs="+", choices=list(STYLES), default=list(STYLES))
    parser.add_argument("--operations", nargs="+", choices=list(OPERATIONS), default=list(OPERATIONS))
    parser.add_argument("--seed", type=int, default=1, help="of the order of the curves")
    parser.add_argument("--minutes", type=float, default=180.0, help="after which no other body is begun")
    parser.add_argument("--again", action="store_true", help="ask also what is kept, but for the log's")
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    wanted = parser.parse_args()
    wanted.out.mkdir(parents=True, exist_ok=True)
    log = wanted.out / "solids.jsonl"
    rows = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
    keep(rows)
    done = {(row["program"], row["style"], row["curve"], row["operation"]) for row in rows}
    if not wanted.again:
        done |= {
            (body["program"], body["style"], body["curve"], operation)
            for body in kept()
            for operation in (*body["ok"], *body["failed"])
        }
    curves = list(wanted.curves)
    random.Random(wanted.seed).shuffle(curves)
    programs = {kernel: program(kernel) for kernel in wanted.kernels}
    end = time.monotonic() + 60 * wanted.minutes
    for curve, style, kernel in product(curves, wanted.styles, wanted.kernels):
        body = kernel, style, curve
        apart = SHARED if kernel == "cadquery" and "build123d" in wanted.kernels else ()
        asked_of = programs[kernel], style, curve
        left = [name for name in wanted.operations if (*asked_of, name) not in done and name not in apart]
        if not left:
            continue
        if time.monotonic() > end:
            print("time is up: the next run goes on", flush=True)
            break
        found = [row | {"program": programs[kernel]} for row in with_control(body, left)]
        with log.open("a") as file:
            file.writelines(json.dumps(row) + "\n" for row in found)
        keep(found)
        rows += found
        good = sum(row["answer"] == "ok" for row in found)
        print(f"{kernel}, {style}, {curve}: {good} of {len(found)}", flush=True)
    succeeded = sum(row["answer"] == "ok" for row in rows)
    print(json.dumps({"operations": len(rows), "succeeded": succeeded}))


if __name__ == "__main__":
    sys.path[:0] = [HERE, str(ROOT)]
    sys.path += [place for place in FREECAD if os.path.isdir(place)]
    main()
