"""Strips bent by finite elements, as tables.

python -m tests.campaign.finite_elements --out out/campaign

Needs ccx (Debian: calculix-ccx) and gmsh.
"""

import argparse
from pathlib import Path

from tests.campaign.finite_elements.closed_forms import known_answers


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    folder = parser.parse_args().out / "finite_elements"
    folder.mkdir(parents=True, exist_ok=True)
    for known in known_answers(folder / "known"):
        print(known, flush=True)


main()
