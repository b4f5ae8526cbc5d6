"""Strips bent by finite elements; docs/finite_elements.md is written anew after each.

python -m tests.campaign.finite_elements --out out/campaign --only slotted sideways

Needs ccx (Debian: calculix-ccx) and gmsh.
"""

import argparse
from pathlib import Path

from tests.campaign.finite_elements.cases import CASES
from tests.campaign.finite_elements.closed_forms import known_answers
from tests.campaign.finite_elements.drawn_by_seed import strips_drawn
from tests.campaign.finite_elements.flexures import flexed_parts
from tests.campaign.finite_elements.joined import joined_strips
from tests.campaign.finite_elements.sideways import swings
from tests.campaign.finite_elements.strips_in_pockets import strips_in_pockets, strips_of_the_pavilion
from tests.campaign.finite_elements.table import keep, measured
from tests.campaign.finite_elements.tapered import tapered_strips

WIDTHS = {"plain widths": False, "by default": None, "compensated": True}


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, default=Path("out/campaign"), help="for decks and answers of ccx")
    parser.add_argument(
        "--only",
        nargs="+",
        default=[""],
        help="parts of names of strips, or: known, sideways, pockets, tapered, joined, drawn, flexures",
    )
    parser.add_argument("--widths", nargs="+", choices=list(WIDTHS), default=list(WIDTHS))
    asked = parser.parse_args()
    folder = asked.out / "finite_elements"
    folder.mkdir(parents=True, exist_ok=True)

    def wanted(name: str) -> bool:
        return any(part in name for part in asked.only)

    def told(part: str, record: object) -> None:
        print(record, flush=True)
        keep(part, record)

    if wanted("known"):
        for known in known_answers(folder):
            told("known", known)
    if wanted("sideways"):
        for swung in swings(folder):
            told("sideways", swung)
    if wanted("pockets"):
        for held in (*strips_in_pockets(folder), *strips_of_the_pavilion(folder)):
            told("pockets", held)
    if wanted("tapered"):
        for bent in tapered_strips(folder):
            told("tapered", bent)
    if wanted("joined"):
        for joined in joined_strips(folder):
            told("joined", joined)
    if wanted("flexures"):
        for flexed in flexed_parts(folder):
            told("flexures", flexed)
    if wanted("drawn"):
        for drawn in strips_drawn(folder):
            told("drawn", drawn)
    for case in CASES:
        if wanted(f"{case.group}, {case.name}"):
            for widths in asked.widths:
                if WIDTHS[widths] is not None or case.has_default_widths:
                    told(widths, measured(case, folder, compensated=WIDTHS[widths]))


main()
