"""Strips bent by finite elements; docs/finite_elements.md is written anew after each.

python -m tests.campaign.finite_elements --out out/campaign --only slotted sideways

Needs ccx (Debian: calculix-ccx) and gmsh.
"""

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from tests.campaign.finite_elements.between import between_ends
from tests.campaign.finite_elements.cases import CASES
from tests.campaign.finite_elements.closed_forms import known_answers
from tests.campaign.finite_elements.drawn_by_seed import strips_drawn, tabs_drawn
from tests.campaign.finite_elements.flexures import flexed_parts
from tests.campaign.finite_elements.joined import joined_strips
from tests.campaign.finite_elements.sideways import swings
from tests.campaign.finite_elements.strips_in_pockets import strips_in_pockets, strips_of_the_pavilion
from tests.campaign.finite_elements.table import keep, measured
from tests.campaign.finite_elements.tapered import tapered_strips

WIDTHS = {"plain widths": False, "by default": None, "compensated": True}


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, default=Path("out/campaign"), help="for decks and answers of ccx")
    parser.add_argument(
        "--only",
        nargs="+",
        default=[""],
        help="parts of names of strips, or: known, sideways, pockets, tapered, joined, drawn, tabs, flexures, "
        "between",
    )
    parser.add_argument("--widths", nargs="+", choices=list(WIDTHS), default=list(WIDTHS))
    arguments = parser.parse_args()
    folder = arguments.out / "finite_elements"
    folder.mkdir(parents=True, exist_ok=True)

    def wanted(name: str) -> bool:
        return any(part in name for part in arguments.only)

    missed: list[str] = []

    def report(part: str, record: Any) -> None:
        print(record, flush=True)
        keep(part, record)
        if not getattr(record, "good", True):
            missed.append(record.name)

    parts = {
        "known": known_answers,
        "sideways": swings,
        "pockets": lambda place: (*strips_in_pockets(place), *strips_of_the_pavilion(place)),
        "tapered": tapered_strips,
        "joined": joined_strips,
        "flexures": flexed_parts,
        "drawn": strips_drawn,
        "tabs": tabs_drawn,
        "between": between_ends,
    }
    for part, found in parts.items():
        for record in found(folder) if wanted(part) else ():
            report(part, record)
    deviations: dict[str, list[float]] = {widths: [] for widths in arguments.widths}
    for case in CASES:
        if wanted(f"{case.group}, {case.name}"):
            for widths in arguments.widths:
                if WIDTHS[widths] is not None or case.has_default_widths:
                    row = measured(case, folder, compensated=WIDTHS[widths])
                    report(widths, row)
                    deviations[widths].append(row.strayed)
    print(json.dumps({
        f"deviation of strips, {widths}": {
            "strips": len(numbers), "median": f"{np.median(numbers):.1e}", "worst": f"{max(numbers):.1e}"
        }
        for widths, numbers in deviations.items() if numbers
    } | {"missed": missed}))  # fmt: skip
    return 1 if missed else 0


sys.exit(main())
