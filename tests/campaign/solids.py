"""Thirty curves x five styles x three kernels: what users do to bodies of strips, as a table.

    python tests/campaign/solids.py --kernels build123d cadquery --out out/campaign

Every body is asked in a process of its own, so that a kernel that crashes or hangs costs one answer. Needs gmsh.
"""

import argparse
import json
import multiprocessing
import os
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
HERE = str(Path(__file__).resolve().parent)
FREECAD = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/share/freecad/Ext")
PATIENCE = 120.0  # s, for one operation


def asked(kernel: str, curve: str, style: str, plain: bool, names: list[str], pipe: Any) -> None:
    """Answers of one body, one message an operation."""
    from bank import made
    from operations import Bodies, kernel_named

    bodies = Bodies(made(curve, style), plain=plain)
    runner = kernel_named(kernel)(bodies)
    for name in names:
        start = time.perf_counter()
        try:
            valid, size = runner.run(name)
            answer = "ok" if valid else "invalid"
            if name in ("volume", "mirror", "split", "STEP"):
                error = abs(size / bodies.volume - 1)
                answer = answer if error < 0.02 else f"volume off by {error:.1e}"
        except Exception as error:
            answer, size = f"{type(error).__name__}: {str(error)[:70]}", 0.0
        pipe.send((name, answer, size, bodies.volume, time.perf_counter() - start))
    pipe.close()


def answers(kernel: str, curve: str, style: str, plain: bool, operations: list[str]) -> list[dict[str, Any]]:
    """All answers of one body, started anew after a crash or a hang."""
    rows: list[dict[str, Any]] = []
    left = list(operations)
    context = multiprocessing.get_context("fork")
    while left:
        here, there = context.Pipe(False)
        process = context.Process(target=asked, args=(kernel, curve, style, plain, left, there))
        process.start()
        there.close()
        try:
            while left and here.poll(PATIENCE):
                name, answer, size, whole, seconds = here.recv()
                left.remove(name)
                rows.append({"kernel": kernel, "curve": curve, "style": style, "operation": name, "answer": answer,
                             "size": size, "volume": whole, "seconds": round(seconds, 3)})  # fmt: skip
        except EOFError:
            pass
        if left:
            ended = "hangs" if process.is_alive() else "crashes"
            process.kill()
            rows.append(
                {"kernel": kernel, "curve": curve, "style": style, "operation": left.pop(0), "answer": ended}
            )
        process.join()
    return rows


def table(rows: list[dict[str, Any]]) -> str:
    """Markdown: a line an operation and kernel with the number that succeed, then every failure."""
    lines = ["| operation | kernel | asked | succeed | answers else |", "| --- | --- | ---: | ---: | --- |"]
    keys = sorted({(r["operation"], r["kernel"]) for r in rows})
    for operation, kernel in keys:
        mine = [r for r in rows if (r["operation"], r["kernel"]) == (operation, kernel)]
        bad = Counter(str(r["answer"])[:60] for r in mine if r["answer"] != "ok")
        told = "; ".join(f"{count} x {text}" for text, count in bad.most_common(3)).replace("|", "/")
        good = sum(r["answer"] == "ok" for r in mine)
        lines.append(f"| {operation} | {kernel} | {len(mine)} | {good} | {told} |")
    lines += ["", "| curve | style | kernel | operation | answer |", "| --- | --- | --- | --- | --- |"]
    lines += [
        f"| {r['curve']} | {r['style']} | {r['kernel']} | {r['operation']} | {str(r['answer']).replace('|', '/')} |"
        for r in rows
        if r["answer"] != "ok"
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    from bank import CURVES, STYLES
    from operations import KERNELS, OPERATIONS

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kernels", nargs="+", choices=list(KERNELS), default=list(KERNELS))
    parser.add_argument("--curves", nargs="+", choices=list(CURVES), default=list(CURVES))
    parser.add_argument("--styles", nargs="+", choices=list(STYLES), default=list(STYLES))
    parser.add_argument("--operations", nargs="+", choices=list(OPERATIONS), default=list(OPERATIONS))
    parser.add_argument(
        "--control",
        action="store_true",
        help="plain bodies with the same faces: what fails there is the kernel's",
    )
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    wanted = parser.parse_args()
    wanted.out.mkdir(parents=True, exist_ok=True)
    rows = []
    with (wanted.out / "solids.jsonl").open("w") as log:
        for kernel in wanted.kernels:
            for style in wanted.styles:
                for curve in wanted.curves:
                    found = answers(kernel, curve, style, wanted.control, wanted.operations)
                    rows += found
                    log.writelines(json.dumps(row) + "\n" for row in found)
                    log.flush()
                    good = sum(row["answer"] == "ok" for row in found)
                    print(f"{kernel}, {style}, {curve}: {good} of {len(found)}", flush=True)
                    (wanted.out / "solids.md").write_text(table(rows))


if __name__ == "__main__":
    sys.path[:0] = [HERE, str(ROOT)]
    sys.path += [place for place in FREECAD if os.path.isdir(place)]
    if os.path.isdir(FREECAD[0]):
        import freecad

        freecad.__path__.append(str(ROOT / "freecad_workbench" / "freecad"))
    main()
